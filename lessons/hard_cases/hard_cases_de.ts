<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>HardCases</name>
    <message>
        <source>its steps are too long for what is so stiff</source>
        <translation>Seine Zeitschritte sind zu lang für etwas so Steifes</translation>
    </message>
    <message>
        <source>its steps are longer than those that the case’s sticks are measured by</source>
        <translation>Seine Zeitschritte sind länger als die, an denen die Stäbe des Falls gemessen werden</translation>
    </message>
    <message>
        <source>it swings on for longer than the run</source>
        <translation>Es schwingt länger weiter, als der Lauf dauert</translation>
    </message>
    <message>
        <source>it moves one body after the other</source>
        <translation>Es bewegt einen Körper nach dem anderen</translation>
    </message>
    <message>
        <source>it would need too many steps</source>
        <translation>Es würde zu viele Zeitschritte brauchen</translation>
    </message>
    <message>
        <source>its errors add up</source>
        <translation>Seine Fehler summieren sich</translation>
    </message>
    <message>
        <source>its errors keep it stirring</source>
        <translation>Seine Fehler halten es in Unruhe</translation>
    </message>
    <message>
        <source>no place there is free</source>
        <translation>Kein Ort dort ist frei</translation>
    </message>
    <message>
        <source>it cannot compute all of it</source>
        <translation>Es kann nicht alles davon berechnen</translation>
    </message>
    <message>
        <source>You have changed it: nobody claims this.</source>
        <translation>Du hast ihn geändert: Niemand sagt das zu.</translation>
    </message>
    <message>
        <source>%1 claims this case.</source>
        <translation>„%1“ sagt diesen Fall zu.</translation>
    </message>
    <message>
        <source>%1 does not claim it: %2.</source>
        <translation>„%1“ sagt ihn nicht zu: %2.</translation>
    </message>
    <message>
        <source>out of its bounds since frame %1</source>
        <translation>außerhalb seiner Grenzen seit Bild %1</translation>
    </message>
    <message>
        <source>within its bounds up to frame %1, the rest is not looked at yet</source>
        <translation>innerhalb seiner Grenzen bis Bild %1, der Rest ist noch nicht angesehen</translation>
    </message>
    <message>
        <source>within its bounds so far</source>
        <translation>bisher innerhalb seiner Grenzen</translation>
    </message>
    <message>
        <source>within its bounds so far, not at rest yet</source>
        <translation>bisher innerhalb seiner Grenzen, noch nicht in Ruhe</translation>
    </message>
    <message>
        <source>within its bounds so far, and at rest, as it should be</source>
        <translation>bisher innerhalb seiner Grenzen und in Ruhe, so wie es sein soll</translation>
    </message>
    <message>
        <source>%1
%2 Frame %3 of %4: %5.</source>
        <translation>%1
%2 Bild %3 von %4: %5.</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>The experiment that runs. Another one begins at frame 0.</source>
        <translation>Das Experiment, das läuft. Ein anderes beginnt bei Bild 0.</translation>
    </message>
    <message>
        <source>How hard the springs of the case pull. 0: as hard as the case has it.</source>
        <translation>Wie stark die Federn des Falls ziehen. 0: so stark, wie der Fall es vorsieht.</translation>
    </message>
    <message>
        <source>the middle moved %1&#x2009;px</source>
        <translation>die Mitte hat sich um %1&#x2009;px bewegt</translation>
    </message>
    <message>
        <source>Longest</source>
        <translation>Längster</translation>
    </message>
    <message>
        <source>The length of the third stick. The other two are 20&#x2009;px long.</source>
        <translation>Die Länge des dritten Stabs. Die anderen zwei sind 20&#x2009;px lang.</translation>
    </message>
    <message>
        <source>Implicit midpoint</source>
        <translation>Implizite Mittelpunktsregel</translation>
    </message>
    <message>
        <source>Semi-implicit Euler</source>
        <translation>Semi-implizites Euler</translation>
    </message>
    <message>
        <source>Backward Euler</source>
        <translation>Implizites Euler</translation>
    </message>
    <message>
        <source>The same, as sticks</source>
        <translation>Dasselbe, als Stäbe</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Whether springs hold the three points, or rigid sticks.</source>
        <translation>Ob Federn die drei Punkte halten oder starre Stäbe.</translation>
    </message>
    <message>
        <source>Velocity Verlet</source>
        <translation>Velocity-Verlet</translation>
    </message>
    <message>
        <source>springs</source>
        <translation>Federn</translation>
    </message>
    <message>
        <source>sticks</source>
        <translation>Stäbe</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Hard cases</source>
        <translation>Schwierige Fälle</translation>
    </message>
    <message>
        <source>What breaks a simulation, why, and what holds.</source>
        <translation>Was eine Simulation zerbricht, warum, und was hält.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>bank</source>
        <translation>Ufer</translation>
    </message>
    <message>
        <source>stone</source>
        <translation>Stein</translation>
    </message>
</context>
</TS>
