<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>RigidConstraint</name>
    <message>
        <source>Largest error</source>
        <translation>Error máximo</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>How far the length of the worst stick is from what it should be.</source>
        <translation>Cuánto se aparta la longitud de la peor barra de la que debería tener.</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Estiramiento máximo</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>How far the worst stick is from its length, as a part of that length.</source>
        <translation>Cuánto se aparta la peor barra de su longitud, como parte de esa longitud.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>How far apart a stick keeps its two ends.</source>
        <translation>A qué distancia mantiene una barra sus dos extremos.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Fracción</translation>
    </message>
    <message>
        <source>The part of the error that p0 takes; p1 takes the rest.</source>
        <translation>La parte del error que corrige p0; p1 corrige el resto.</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triángulos</translation>
    </message>
    <message>
        <source>How many triangles the figure has.</source>
        <translation>Cuántos triángulos tiene la figura.</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iteraciones</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>pasadas</translation>
    </message>
    <message>
        <source>How often each frame goes through the list of sticks.</source>
        <translation>Cuántas veces recorre cada fotograma la lista de barras.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Rozamiento</translation>
    </message>
    <message>
        <source>How much a wall’s push holds back what slides along it. 0: like ice.</source>
        <translation>Cuánto frena una pared lo que se desliza por ella. 0: como hielo.</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Articulaciones</translation>
    </message>
    <message>
        <source>Whether arms and legs bend only as far as joints do, or all the way round.</source>
        <translation>Si brazos y piernas se doblan solo hasta donde llegan las articulaciones, o en redondo.</translation>
    </message>
    <message>
        <source>free</source>
        <translation>libres</translation>
    </message>
    <message>
        <source>limited</source>
        <translation>limitadas</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Rigid constraints</source>
        <translation>Restricciones rígidas</translation>
    </message>
    <message>
        <source>Sticks that keep their length, from one pair to a ragdoll to throw about.</source>
        <translation>Barras que conservan su longitud, desde una pareja hasta un muñeco de trapo que se puede lanzar.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>Gives a stick its length back: each end takes its share of the error.</source>
        <translation>Devuelve su longitud a una barra: cada extremo se encarga de su fracción del error.</translation>
    </message>
    <message>
        <source>your hand does not give way</source>
        <translation>tu mano no cede</translation>
    </message>
    <message>
        <source>from the y axis</source>
        <translation>desde el eje y</translation>
    </message>
    <message>
        <source>The pointer carries the first point.</source>
        <translation>El puntero lleva el primer punto.</translation>
    </message>
    <message>
        <source>One stick after the other: each sees what the one before it moved.</source>
        <translation>Una barra tras otra: cada una ve lo que ha movido la anterior.</translation>
    </message>
    <message>
        <source>A point keeps going as it came, and falls. In your hand it comes along.</source>
        <translation>Un punto sigue como venía, y cae. En tu mano, va con ella.</translation>
    </message>
    <message>
        <source>Is the angle from `a` to `b`, clockwise, past a limit? Then each turns back by half of it.</source>
        <translation>¿Pasa un límite el ángulo de `a` a `b`, en sentido horario? Cada uno gira atrás la mitad.</translation>
    </message>
    <message>
        <source>the middle stays</source>
        <translation>el centro se queda</translation>
    </message>
    <message>
        <source>Gives a stick its length back. An end in your hand does not give way.</source>
        <translation>Devuelve su longitud a una barra. Un extremo en tu mano no cede.</translation>
    </message>
    <message>
        <source>Friction holds back what slides along a wall: the deeper in the wall, the more.</source>
        <translation>El rozamiento frena lo que se desliza por una pared: cuanto más dentro de ella, más.</translation>
    </message>
    <message>
        <source>the torso, not inside out</source>
        <translation>el torso, sin volverse del revés</translation>
    </message>
    <message>
        <source>shoulders</source>
        <translation>hombros</translation>
    </message>
    <message>
        <source>elbows</source>
        <translation>codos</translation>
    </message>
    <message>
        <source>hips</source>
        <translation>caderas</translation>
    </message>
    <message>
        <source>knees</source>
        <translation>rodillas</translation>
    </message>
    <message>
        <source>Verlet: the velocity is how far it came, whatever moved it.</source>
        <translation>Verlet: la velocidad es cuánto ha avanzado, sea lo que sea lo que lo ha movido.</translation>
    </message>
    <message>
        <source>Gives a stick its length back: `a` takes its share of the error, `b` takes the rest.</source>
        <translation>Devuelve su longitud a una barra: `a` se encarga de su fracción del error, y `b`, del resto.</translation>
    </message>
    <message>
        <source>Each stick makes the ones before it a little wrong again.</source>
        <translation>Cada barra vuelve a estropear un poco las anteriores.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>head</source>
        <translation>cabeza</translation>
    </message>
</context>
</TS>
