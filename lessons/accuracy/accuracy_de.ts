<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Accuracy</name>
    <message>
        <source>Off by</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>How far the point that is worst off is from its exact place.</source>
        <translation>Wie weit der ungenaueste Punkt von seinem exakten Ort entfernt ist.</translation>
    </message>
    <message>
        <source>Energy drift</source>
        <translation>Energiedrift</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>How much more energy there is than in the exact motion at this moment.</source>
        <translation>Wie viel mehr Energie es in diesem Moment gibt als in der exakten Bewegung.</translation>
    </message>
    <message>
        <source>Its step</source>
        <translation>Sein Zeitschritt</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>How much time the method took at once, the last time.</source>
        <translation>Wie viel Zeit das Verfahren beim letzten Mal auf einmal genommen hat.</translation>
    </message>
    <message>
        <source>Computations</source>
        <translation>Berechnungen</translation>
    </message>
    <message>
        <source>a frame</source>
        <translation>pro Bild</translation>
    </message>
    <message>
        <source>How often all forces were computed for this frame: that is the work.</source>
        <translation>Wie oft für dieses Bild alle Kräfte berechnet wurden: Das ist die Arbeit.</translation>
    </message>
    <message>
        <source>%1&#x2009;px off</source>
        <translation>%1&#x2009;px daneben</translation>
    </message>
    <message>
        <source>Creatures</source>
        <translation>Figuren</translation>
    </message>
    <message>
        <source>How many creatures there are.</source>
        <translation>Wie viele Figuren es gibt.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>How far off a computed motion is, and what it costs to be nearer.</source>
        <translation>Wie weit eine berechnete Bewegung daneben ist und was es kostet, näher heranzukommen.</translation>
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
