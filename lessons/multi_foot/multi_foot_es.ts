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
</TS>
