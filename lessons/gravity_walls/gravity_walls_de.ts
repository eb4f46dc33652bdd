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
<context>
    <name>listing</name>
    <message>
        <source>the pull on `me`, towards the nearest place at the distance `radius` from `anchor`</source>
        <translation>der Zug an `me`, zum nächsten Ort im Abstand `radius` von `anchor`</translation>
    </message>
    <message>
        <source>one more pull, the same for all, and before damping</source>
        <translation>noch ein Zug, für alle gleich und vor der Dämpfung</translation>
    </message>
    <message>
        <source>Is an edge past a wall? Put the disc back, and turn its velocity away from the wall.</source>
        <translation>Ist ein Rand hinter einer Wand? Zurücksetzen, und die Geschwindigkeit von ihr weg richten.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>ball</source>
        <translation>Ball</translation>
    </message>
</context>
</TS>
