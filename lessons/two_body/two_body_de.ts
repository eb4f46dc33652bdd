<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>lesson.json</name>
    <message>
        <source>Two bodies</source>
        <translation>Zwei Körper</translation>
    </message>
    <message>
        <source>A foot and a body pull each other: whose turn it is makes a difference.</source>
        <translation>Ein Fuß und ein Körper ziehen aneinander: Es macht einen Unterschied, wer gerade dran ist.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>The leg is drawn from body to foot after each frame. It needs no line here.</source>
        <translation>Das Bein wird nach jedem Bild vom Körper zum Fuß gezeichnet. Es braucht hier keine Zeile.</translation>
    </message>
    <message>
        <source>the place at the distance `radius` from `anchor` that is nearest to `me`</source>
        <translation>der Ort im Abstand `radius` von `anchor`, der am nächsten bei `me` ist</translation>
    </message>
    <message>
        <source>The body sees the foot where it already is.</source>
        <translation>Der Körper sieht den Fuß dort, wo er schon ist.</translation>
    </message>
</context>
</TS>
