<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>Codeling</name>
    <message>
        <source>motor</source>
        <translation>motor</translation>
    </message>
    <message>
        <source>Way to the target</source>
        <translation>Camino al objetivo</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>It grows before a move: that is the anticipation.</source>
        <translation>Crece antes de un movimiento: esa es la anticipación.</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Estiramiento</translation>
    </message>
    <message>
        <source>How long the spine is, as a part of its length at rest.</source>
        <translation>Cuánto mide la espina, como parte de su longitud en reposo.</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Área</translation>
    </message>
    <message>
        <source>The area of the body, as a part of its area at rest.</source>
        <translation>El área del cuerpo, como parte de su área en reposo.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Retención</translation>
    </message>
    <message>
        <source>per frame</source>
        <translation>por fotograma</translation>
    </message>
    <message>
        <source>The share of its speed that the lead keeps each frame.</source>
        <translation>La fracción de su rapidez que la guía conserva en cada fotograma.</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidez</translation>
    </message>
    <message>
        <source>How hard the motor pulls: this times the way to the target.</source>
        <translation>Con qué fuerza tira el motor: esto por el camino al objetivo.</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Intervalo de tiempo</translation>
    </message>
    <message>
        <source>How much of its own time passes in a frame: the pull counts dt × dt.</source>
        <translation>Cuánto de su propio tiempo pasa en un fotograma: el tirón cuenta dt × dt.</translation>
    </message>
    <message>
        <source>Target x</source>
        <translation>Objetivo x</translation>
    </message>
    <message>
        <source>How far to the right the first target is.</source>
        <translation>Cuánto a la derecha está el primer objetivo.</translation>
    </message>
    <message>
        <source>Target y</source>
        <translation>Objetivo y</translation>
    </message>
    <message>
        <source>How far down the first target is.</source>
        <translation>Cuánto más abajo está el primer objetivo.</translation>
    </message>
    <message>
        <source>Rest length</source>
        <translation>Longitud natural</translation>
    </message>
    <message>
        <source>How far the tail is from the lead at rest.</source>
        <translation>A qué distancia de la guía está la cola en reposo.</translation>
    </message>
    <message>
        <source>Anticipation</source>
        <translation>Anticipación</translation>
    </message>
    <message>
        <source>How far it backs up before a move, as a part of the way to the target.</source>
        <translation>Cuánto retrocede antes de un movimiento, como parte del camino al objetivo.</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Blando</translation>
    </message>
    <message>
        <source>The part of the spine’s error that goes each frame.</source>
        <translation>La parte del error de la espina que desaparece en cada fotograma.</translation>
    </message>
    <message>
        <source>Hard</source>
        <translation>Duro</translation>
    </message>
    <message>
        <source>The same, when the spine is too short or too long.</source>
        <translation>Lo mismo, cuando la espina es demasiado corta o demasiado larga.</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>A lo largo</translation>
    </message>
    <message>
        <source>The share of the tail’s speed along the spine that it keeps.</source>
        <translation>La fracción de su rapidez a lo largo de la espina que conserva la cola.</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>De través</translation>
    </message>
    <message>
        <source>The share of the tail’s speed across the spine that it keeps.</source>
        <translation>La fracción de su rapidez de través a la espina que conserva la cola.</translation>
    </message>
    <message>
        <source>Shortest length</source>
        <translation>Longitud mínima</translation>
    </message>
    <message>
        <source>Shorter than this, the spine pushes hard.</source>
        <translation>Si es más corta, la espina empuja con fuerza.</translation>
    </message>
    <message>
        <source>Longest length</source>
        <translation>Longitud máxima</translation>
    </message>
    <message>
        <source>Longer than this, the spine pulls hard.</source>
        <translation>Si es más larga, la espina tira con fuerza.</translation>
    </message>
    <message>
        <source>Tentacles</source>
        <translation>Tentáculos</translation>
    </message>
    <message>
        <source>How many tentacles it has.</source>
        <translation>Cuántos tentáculos tiene.</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Eslabones</translation>
    </message>
    <message>
        <source>How many links each tentacle has.</source>
        <translation>Cuántos eslabones tiene cada tentáculo.</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Agua</translation>
    </message>
    <message>
        <source>The share of its speed that a tentacle keeps each frame. Less: thicker water.</source>
        <translation>La fracción de su rapidez que un tentáculo conserva en cada fotograma. Menos: agua más espesa.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Anchura</translation>
    </message>
    <message>
        <source>How far apart the two sides are.</source>
        <translation>A qué distancia están los dos lados.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Codeling</source>
        <translation>Codeling</translation>
    </message>
    <message>
        <source>A little swimmer whose whole character comes from springs and constraints.</source>
        <translation>Un pequeño nadador cuyo carácter sale todo de muelles y restricciones.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>Before it goes, the lead backs up. The shift is a push, too.</source>
        <translation>Antes de salir, la guía retrocede. Ese retroceso también es un empujón.</translation>
    </message>
    <message>
        <source>A stick with one side: the tail takes all of the error.</source>
        <translation>Una barra unilateral: la cola se encarga de todo el error.</translation>
    </message>
    <message>
        <source>from the y axis</source>
        <translation>desde el eje y</translation>
    </message>
    <message>
        <source>but your hand does not give way</source>
        <translation>pero tu mano no cede</translation>
    </message>
    <message>
        <source>a spring to the target; dt is the tutorial&apos;s time of a frame</source>
        <translation>un muelle hacia el objetivo; dt es la duración de un fotograma en el tutorial</translation>
    </message>
    <message>
        <source>A soft stick takes a part of its error each frame. Past its limits, it takes a larger part.</source>
        <translation>Una barra blanda corrige en cada fotograma una parte de su error; fuera de sus límites, más.</translation>
    </message>
    <message>
        <source>The tail keeps more of its speed along the spine than across it.</source>
        <translation>La cola conserva más rapidez a lo largo de la espina que de través.</translation>
    </message>
    <message>
        <source>how far it came, also in your hand</source>
        <translation>cuánto ha avanzado, también en tu mano</translation>
    </message>
    <message>
        <source>Gives a stick its length back: the outer end takes all of the error, unless you hold it.</source>
        <translation>Devuelve su longitud a una barra: el extremo de fuera se encarga del error, si no lo sujetas.</translation>
    </message>
    <message>
        <source>The sides stay in the middle...</source>
        <translation>Los lados se quedan en el centro...</translation>
    </message>
    <message>
        <source>...and as far apart as the area needs: half as long, twice as wide.</source>
        <translation>...y tan separados como pide el área: la mitad de largo, el doble de ancho.</translation>
    </message>
    <message>
        <source>The tentacles go on as they came. Then each link pulls the next one in, outwards.</source>
        <translation>Los tentáculos siguen como venían. Luego cada eslabón atrae al siguiente, hacia fuera.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>lead</source>
        <translation>guía</translation>
    </message>
    <message>
        <source>tail</source>
        <translation>cola</translation>
    </message>
    <message>
        <source>sides</source>
        <translation>lados</translation>
    </message>
    <message>
        <source>tentacles</source>
        <translation>tentáculos</translation>
    </message>
    <message>
        <source>side</source>
        <translation>lado</translation>
    </message>
    <message>
        <source>tentacle</source>
        <translation>tentáculo</translation>
    </message>
</context>
</TS>
