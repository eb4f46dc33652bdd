<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>lesson.json</name>
    <message>
        <source>Multi-foot</source>
        <translation>Viele Füße</translation>
    </message>
    <message>
        <source>One body on many feet: pulls add up, and so does stiffness.</source>
        <translation>Ein Körper auf vielen Füßen: Züge addieren sich, und Steifigkeit auch.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>the pull on `me`, towards the nearest place at the distance `radius` from `anchor`</source>
        <translation>der Zug an `me`, zum nächsten Ort im Abstand `radius` von `anchor`</translation>
    </message>
    <message>
        <source>The body feels every foot.</source>
        <translation>Der Körper spürt jeden Fuß.</translation>
    </message>
    <message>
        <source>The feet grow at random places before the first frame. From then on nothing is different.</source>
        <translation>Die Füße wachsen vor dem ersten Bild an zufälligen Orten. Danach ist alles wie zuvor.</translation>
    </message>
    <message>
        <source>Two pulls on one body add up.</source>
        <translation>Zwei Züge an einem Körper addieren sich.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>top</source>
        <translation>oben</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>stone</source>
        <translation>Stein</translation>
    </message>
</context>
</TS>
