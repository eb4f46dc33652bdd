<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>lesson.json</name>
    <message>
        <source>Multi-foot</source>
        <translation>Muchos pies</translation>
    </message>
    <message>
        <source>One body on many feet: pulls add up, and so does stiffness.</source>
        <translation>Un cuerpo sobre muchos pies: los tirones se suman, y la rigidez también.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>the pull on `me`, towards the nearest place at the distance `radius` from `anchor`</source>
        <translation>el tirón sobre `me`, hacia el lugar más cercano a la distancia `radius` de `anchor`</translation>
    </message>
    <message>
        <source>The body feels every foot.</source>
        <translation>El cuerpo siente cada pie.</translation>
    </message>
    <message>
        <source>The feet grow at random places before the first frame. From then on nothing is different.</source>
        <translation>Los pies crecen en lugares al azar antes del primer fotograma. Después, nada es distinto.</translation>
    </message>
    <message>
        <source>Two pulls on one body add up.</source>
        <translation>Dos tirones sobre un mismo cuerpo se suman.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>left</source>
        <translation>izquierda</translation>
    </message>
    <message>
        <source>top</source>
        <translation>arriba</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecha</translation>
    </message>
    <message>
        <source>stone</source>
        <translation>piedra</translation>
    </message>
</context>
</TS>
