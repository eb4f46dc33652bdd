<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>lesson.json</name>
    <message>
        <source>Gravity and walls</source>
        <translation>Gravedad y paredes</translation>
    </message>
    <message>
        <source>A room to bounce in, and a pull that goes straight down.</source>
        <translation>Una habitación en la que rebotar, y un tirón que va recto hacia abajo.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>the pull on `me`, towards the nearest place at the distance `radius` from `anchor`</source>
        <translation>el tirón sobre `me`, hacia el lugar más cercano a la distancia `radius` de `anchor`</translation>
    </message>
    <message>
        <source>one more pull, the same for all, and before damping</source>
        <translation>un tirón más, igual para todos, y antes de la amortiguación</translation>
    </message>
    <message>
        <source>Is an edge past a wall? Put the disc back, and turn its velocity away from the wall.</source>
        <translation>¿Un borde ha pasado la pared? Devuelve el disco, y dirige su velocidad lejos de la pared.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>ball</source>
        <translation>bola</translation>
    </message>
</context>
</TS>
