<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>WalkingGait</name>
    <message>
        <source>Centipede</source>
        <translation>Ciempiés</translation>
    </message>
    <message>
        <source>Twelve feet, one after the other: the body glides.</source>
        <translation>Doce pies, uno tras otro: el cuerpo se desliza.</translation>
    </message>
    <message>
        <source>Trot</source>
        <translation>Trote</translation>
    </message>
    <message>
        <source>Four feet in two pairs: it bobs like one with two feet.</source>
        <translation>Cuatro pies en dos pares: sube y baja como con dos pies.</translation>
    </message>
    <message>
        <source>Limp</source>
        <translation>Cojera</translation>
    </message>
    <message>
        <source>Three feet close behind each other, then a pause.</source>
        <translation>Tres pies muy seguidos y luego una pausa.</translation>
    </message>
    <message>
        <source>Runner</source>
        <translation>Corredor</translation>
    </message>
    <message>
        <source>A fast clock: no foot touches the ground for long.</source>
        <translation>Un reloj rápido: ningún pie toca el suelo mucho tiempo.</translation>
    </message>
    <message>
        <source>Swing</source>
        <translation>Balanceo</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>How far foot 0 is from the middle of its places. The leg is what it would be if it followed exactly.</source>
        <translation>A qué distancia está el pie 0 del centro de sus posiciones. La pierna es lo que sería si lo siguiera exactamente.</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Momento lineal</translation>
    </message>
    <message>
        <source>px/frame</source>
        <translation>px/fotograma</translation>
    </message>
    <message>
        <source>All velocities added up; how long that arrow is. Every mass is 1.</source>
        <translation>Todas las velocidades sumadas; cuánto mide esa flecha. Cada masa es 1.</translation>
    </message>
    <message>
        <source>Walks</source>
        <translation>Camina</translation>
    </message>
    <message>
        <source>How far the body came to the right in the last frame.</source>
        <translation>Cuánto avanzó el cuerpo hacia la derecha en el último fotograma.</translation>
    </message>
    <message>
        <source>Slip</source>
        <translation>Resbalamiento</translation>
    </message>
    <message>
        <source>How far the standing feet slid in the last frame, on the average.</source>
        <translation>Cuánto resbalaron de media los pies apoyados en el último fotograma.</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Reloj</translation>
    </message>
    <message>
        <source>rad/frame</source>
        <translation>rad/fotograma</translation>
    </message>
    <message>
        <source>How fast the gait clock turns.</source>
        <translation>Con qué rapidez gira el reloj de marcha.</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Empuje</translation>
    </message>
    <message>
        <source>px/frame²</source>
        <translation>px/fotograma²</translation>
    </message>
    <message>
        <source>All pushes between bodies added up; how long that arrow is.</source>
        <translation>Todos los empujes entre cuerpos sumados; cuánto mide esa flecha.</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Pierna</translation>
    </message>
    <message>
        <source>How far a foot belongs from the middle of its places.</source>
        <translation>A qué distancia del centro de sus posiciones va un pie.</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Descenso</translation>
    </message>
    <message>
        <source>How far below the body the feet belong.</source>
        <translation>A qué distancia por debajo del cuerpo van los pies.</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Curva</translation>
    </message>
    <message>
        <source>How high above its foot the point lies that bends a leg. Only drawn.</source>
        <translation>A qué altura sobre su pie está el punto que dobla una pierna. Solo se dibuja.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Rapidez</translation>
    </message>
    <message>
        <source>How far the gait clock turns each frame. Below 0 it turns the other way.</source>
        <translation>Cuánto gira el reloj de marcha en cada fotograma. Por debajo de 0 gira en el otro sentido.</translation>
    </message>
    <message>
        <source>The share of its speed that a foot keeps, turned round, on the ground.</source>
        <translation>La fracción de su rapidez que un pie conserva, invertida, en el suelo.</translation>
    </message>
    <message>
        <source>Traction</source>
        <translation>Agarre</translation>
    </message>
    <message>
        <source>Whether the ground stops a foot sideways, too. Without it is ice.</source>
        <translation>Si el suelo también detiene un pie hacia los lados. Sin él es hielo.</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pies</translation>
    </message>
    <message>
        <source>How many feet the body has.</source>
        <translation>Cuántos pies tiene el cuerpo.</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Apertura</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Over how much of a turn the feet are spread. At 0 all step together.</source>
        <translation>En qué parte de una vuelta se reparten los pies. Con 0 pisan todos a la vez.</translation>
    </message>
    <message>
        <source>Top speed</source>
        <translation>Rapidez máxima</translation>
    </message>
    <message>
        <source>The fastest that keys and pointer make the gait clock.</source>
        <translation>La mayor rapidez que las teclas y el puntero dan al reloj de marcha.</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Cambio</translation>
    </message>
    <message>
        <source>rad/frame²</source>
        <translation>rad/fotograma²</translation>
    </message>
    <message>
        <source>How much speed an arrow key adds or takes away, each frame that it is down.</source>
        <translation>Cuánta rapidez añade o quita una tecla de flecha, en cada fotograma que está pulsada.</translation>
    </message>
    <message>
        <source>At a wall</source>
        <translation>En una pared</translation>
    </message>
    <message>
        <source>Whether it turns round where it bumps into a wall, or walks on.</source>
        <translation>Si da la vuelta donde choca con una pared o sigue caminando.</translation>
    </message>
    <message>
        <source>Creatures</source>
        <translation>Criaturas</translation>
    </message>
    <message>
        <source>How many creatures there are.</source>
        <translation>Cuántas criaturas hay.</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Repulsión</translation>
    </message>
    <message>
        <source>1/frame²</source>
        <translation>1/fotograma²</translation>
    </message>
    <message>
        <source>How hard two bodies push: this share of the missing distance, each frame.</source>
        <translation>Con qué fuerza empujan dos cuerpos: esta fracción de la distancia que falta, en cada fotograma.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Two bodies closer than this push each other.</source>
        <translation>Dos cuerpos más cercanos que esto se empujan.</translation>
    </message>
    <message>
        <source>Felt by</source>
        <translation>Sentida por</translation>
    </message>
    <message>
        <source>Whether both bodies feel a push, or only the one that comes first.</source>
        <translation>Si sienten un empuje los dos cuerpos o solo el que va primero.</translation>
    </message>
    <message>
        <source>foot %1</source>
        <translation>pie %1</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>centro</translation>
    </message>
    <message>
        <source>full</source>
        <translation>completo</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>dar la vuelta</translation>
    </message>
    <message>
        <source>walk on</source>
        <translation>seguir caminando</translation>
    </message>
    <message>
        <source>both</source>
        <translation>ambas</translation>
    </message>
    <message>
        <source>one</source>
        <translation>una</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Walking</source>
        <translation>Caminar</translation>
    </message>
    <message>
        <source>Bones, a clock that turns them, and ground: a creature that walks.</source>
        <translation>Huesos, un reloj que los gira y suelo: una criatura que camina.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>The foot feels the force, and the body feels the opposite.</source>
        <translation>El pie siente la fuerza, y el cuerpo siente la opuesta.</translation>
    </message>
    <message>
        <source>where the foot belongs</source>
        <translation>donde debe estar el pie</translation>
    </message>
    <message>
        <source>The body is a handle: it stays where you leave it.</source>
        <translation>El cuerpo es un asa: se queda donde lo dejas.</translation>
    </message>
    <message>
        <source>Each foot has a bone: an angle of its own, in radians.</source>
        <translation>Cada pie tiene un hueso: un ángulo propio, en radianes.</translation>
    </message>
    <message>
        <source>to the left of the body</source>
        <translation>a la izquierda del cuerpo</translation>
    </message>
    <message>
        <source>half a turn on</source>
        <translation>media vuelta más allá</translation>
    </message>
    <message>
        <source>these walls take all speed</source>
        <translation>estas paredes quitan toda la velocidad</translation>
    </message>
    <message>
        <source>a spring that never pulls</source>
        <translation>un muelle que nunca tira</translation>
    </message>
    <message>
        <source>0: both, 1: one</source>
        <translation>0: ambas, 1: una</translation>
    </message>
    <message>
        <source>A leg bends towards a point above its foot. That point is only drawn: no spring knows of it.</source>
        <translation>Una pierna se dobla hacia un punto sobre su pie. Solo se dibuja: ningún muelle lo conoce.</translation>
    </message>
    <message>
        <source>where the foot belongs: below the body, by `drop`</source>
        <translation>donde debe estar el pie: `drop` por debajo del cuerpo</translation>
    </message>
    <message>
        <source>The ground holds the feet, and only the feet.</source>
        <translation>El suelo sujeta los pies, y solo los pies.</translation>
    </message>
    <message>
        <source>without bounce it is 0</source>
        <translation>sin rebote es 0</translation>
    </message>
    <message>
        <source>0: full, 1: none</source>
        <translation>0: completo, 1: ninguno</translation>
    </message>
    <message>
        <source>The legs are drawn after the frame, from the body to each foot. They need no line here.</source>
        <translation>Las piernas se dibujan tras el fotograma, del cuerpo a cada pie. Aquí no necesitan ninguna línea.</translation>
    </message>
    <message>
        <source>The feet share the clock, and each has an angle of its own.</source>
        <translation>Los pies comparten el reloj, y cada uno tiene un ángulo propio.</translation>
    </message>
    <message>
        <source>in radians</source>
        <translation>en radianes</translation>
    </message>
    <message>
        <source>by the pointer, or by the arrow keys</source>
        <translation>con el puntero o con las flechas del teclado</translation>
    </message>
    <message>
        <source>The place goes round: one clock turns all bones.</source>
        <translation>El lugar da vueltas: un solo reloj gira todos los huesos.</translation>
    </message>
    <message>
        <source>the clock, in radians</source>
        <translation>el reloj, en radianes</translation>
    </message>
    <message>
        <source>A part that touches a wall turns the clock&apos;s speed, so that it leads away.</source>
        <translation>Una parte que toca una pared cambia el sentido del reloj, para que se aleje de ella.</translation>
    </message>
    <message>
        <source>0: turn, 1: walk on</source>
        <translation>0: dar la vuelta, 1: seguir caminando</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>left</source>
        <translation>izquierda</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>pie</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecha</translation>
    </message>
    <message>
        <source>load</source>
        <translation>carga</translation>
    </message>
</context>
</TS>
