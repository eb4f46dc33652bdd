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
</TS>
