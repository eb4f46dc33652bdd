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
        <source>Share of p0</source>
        <translation>Fracción de p0</translation>
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
</TS>
