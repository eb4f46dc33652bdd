<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>lesson.json</name>
    <message>
        <source>Two bodies</source>
        <translation>Dos cuerpos</translation>
    </message>
    <message>
        <source>A foot and a body pull each other: whose turn it is makes a difference.</source>
        <translation>Un pie y un cuerpo tiran uno del otro: no da igual a quién le toca.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>The leg is drawn from body to foot after each frame. It needs no line here.</source>
        <translation>La pierna se dibuja del cuerpo al pie tras cada fotograma. Aquí no necesita ninguna línea.</translation>
    </message>
    <message>
        <source>the place at the distance `radius` from `anchor` that is nearest to `me`</source>
        <translation>el lugar a la distancia `radius` de `anchor` que está más cerca de `me`</translation>
    </message>
    <message>
        <source>The body sees the foot where it already is.</source>
        <translation>El cuerpo ve el pie donde ya está.</translation>
    </message>
</context>
</TS>
