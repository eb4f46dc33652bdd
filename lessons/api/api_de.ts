<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Parameters</name>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>1/frame²</source>
        <translation>1/Bild²</translation>
    </message>
    <message>
        <source>How hard a spring pulls: this share of the missing distance, each frame.</source>
        <translation>Wie stark eine Feder zieht: dieser Anteil des fehlenden Abstands, in jedem Bild.</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>per frame</source>
        <translation>pro Bild</translation>
    </message>
    <message>
        <source>The share of its speed that everything keeps each frame. 1 keeps it all.</source>
        <translation>Der Anteil seines Tempos, den alles in jedem Bild behält. 1 behält alles.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>The distance that the spring keeps.</source>
        <translation>Der Abstand, den die Feder hält.</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>How far to the right of the body the spring ends. Below 0: to the left.</source>
        <translation>Wie weit rechts vom Körper die Feder endet. Unter 0: links davon.</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Füße</translation>
    </message>
    <message>
        <source>How many feet the body has.</source>
        <translation>Wie viele Füße der Körper hat.</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>px/frame²</source>
        <translation>px/Bild²</translation>
    </message>
    <message>
        <source>How much speed everything gains downwards each frame.</source>
        <translation>Wie viel Tempo alles in jedem Bild nach unten gewinnt.</translation>
    </message>
    <message>
        <source>Bounce</source>
        <translation>Abprall</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>behalten</translation>
    </message>
    <message>
        <source>The share of its speed that a body keeps at a wall.</source>
        <translation>Der Anteil seines Tempos, den ein Körper an einer Wand behält.</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>How far down the ground lies.</source>
        <translation>Wie weit unten der Boden liegt.</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>Mitte x</translation>
    </message>
    <message>
        <source>How far to the right the cross is.</source>
        <translation>Wie weit rechts das Kreuz ist.</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>Mitte y</translation>
    </message>
    <message>
        <source>How far down the cross is.</source>
        <translation>Wie weit unten das Kreuz ist.</translation>
    </message>
    <message>
        <source>Left wall</source>
        <translation>Linke Wand</translation>
    </message>
    <message>
        <source>Where the left wall stands.</source>
        <translation>Wo die linke Wand steht.</translation>
    </message>
    <message>
        <source>Right wall</source>
        <translation>Rechte Wand</translation>
    </message>
    <message>
        <source>Where the right wall stands.</source>
        <translation>Wo die rechte Wand steht.</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>How far down the floor lies.</source>
        <translation>Wie weit unten der Boden liegt.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>Füße</translation>
    </message>
    <message>
        <source>body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>bodies</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>creature</source>
        <translation>Figur</translation>
    </message>
    <message>
        <source>springs that pull one end only</source>
        <translation>Federn, die nur an einem Ende ziehen</translation>
    </message>
    <message>
        <source>feet with more than one leg</source>
        <translation>Füße mit mehr als einem Bein</translation>
    </message>
    <message>
        <source>the bounce of the ground</source>
        <translation>Abprall am Boden</translation>
    </message>
    <message>
        <source>ice on the ground</source>
        <translation>Eis auf dem Boden</translation>
    </message>
</context>
</TS>
