<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>lesson.json</name>
    <message>
        <source>Gravity and walls</source>
        <translation>Schwerkraft und Wände</translation>
    </message>
    <message>
        <source>A room to bounce in, and a pull that goes straight down.</source>
        <translation>Ein Raum zum Abprallen und ein Zug, der gerade nach unten geht.</translation>
    </message>
</context>
</TS>
