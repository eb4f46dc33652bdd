<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>TwoBody</name>
    <message>
        <source>Stop inside a frame when the foot has moved and the body has not. What does the body see?</source>
        <translation>Halte innerhalb eines Bildes an, wenn der Fuß sich bewegt hat und der Körper noch nicht. Was sieht der Körper?</translation>
    </message>
    <message>
        <source>Set **k** to 0.3 and hands off: the pair flies out of the picture by itself.</source>
        <translation>Setze **k** auf 0,3, und Hände weg: Das Paar fliegt von selbst aus dem Bild.</translation>
    </message>
    <message>
        <source>Keep k at 0.3, set **damping** to 0.85, and wait until the pair is still.</source>
        <translation>Lass k bei 0,3, setze **Dämpfung** auf 0,85 und warte, bis das Paar still ist.</translation>
    </message>
    <message>
        <source>With k at 0.3 and damping at 0.9, choose the method **Semi-implicit Euler** and watch 100&#x202f;frames, hands off.</source>
        <translation>Wähle bei k 0,3 und Dämpfung 0,9 **Semi-implizites Euler** und sieh 100&#x202f;Bilder zu, Hände weg.</translation>
    </message>
    <message>
        <source>Hold one end and pull so fast that the leg stretches to 100&#x202f;px or more.</source>
        <translation>Halte ein Ende und zieh so schnell, dass sich das Bein auf 100&#x202f;px oder mehr dehnt.</translation>
    </message>
    <message>
        <source>Hold one end and press the leg to under 20&#x202f;px. Then let go.</source>
        <translation>Halte ein Ende und drück das Bein auf unter 20&#x202f;px zusammen. Dann lass los.</translation>
    </message>
    <message>
        <source>Set **radius** to 100 and wait until the leg is still, 100&#x202f;px long.</source>
        <translation>Setze **Radius** auf 100 und warte, bis das Bein still ist, 100&#x202f;px lang.</translation>
    </message>
    <message>
        <source>Go back in time, change **k**, and compare with the ghost.</source>
        <translation>Geh in der Zeit zurück, ändere **k** und vergleiche mit dem Geist.</translation>
    </message>
    <message>
        <source>Each pulls the other</source>
        <translation>Beide ziehen</translation>
    </message>
    <message>
        <source>Now **both are pulled**: the foot to a place 50&#x202f;px from the body, and the body to a place 50&#x202f;px from the foot. It is one rule, used twice.

The foot moves first, and the body sees it **where it already is**. So the two pulls are not quite opposite, and the velocities add up to more than nothing. That sum is the **momentum**, and here it comes from nowhere: the pair drifts.

With k = 0.3 it flies for ever. Set damping to 0.85 as well, and it calms down: damping then takes more than the order of moves gives.

The method Semi-implicit Euler moves both **at once**. Their pulls are opposite, and the momentum stays 0.</source>
        <translation>Jetzt werden **beide gezogen**: der Fuß an einen Ort 50&#x202f;px vom Körper, und der Körper an einen Ort 50&#x202f;px vom Fuß. Es ist eine Regel, zweimal verwendet.

Der Fuß bewegt sich zuerst, und der Körper sieht ihn dort, **wo er schon ist**. Darum sind die zwei Züge nicht ganz entgegengesetzt, und die Geschwindigkeiten ergeben zusammen mehr als nichts. Diese Summe ist der **Impuls**, und hier kommt er aus dem Nichts: Das Paar treibt davon.

Mit k = 0,3 fliegt es ewig. Setze auch die Dämpfung auf 0,85, und es beruhigt sich: Dann nimmt die Dämpfung mehr, als die Reihenfolge der Bewegungen gibt.

Das semi-implizite Euler-Verfahren bewegt beide **zugleich**. Ihre Züge sind entgegengesetzt, und der Impuls bleibt 0.</translation>
    </message>
    <message>
        <source>A leg</source>
        <translation>Ein Bein</translation>
    </message>
    <message>
        <source>A body, a foot, and now a **leg**: a line from one to the other. In the code it is one line, too.

It is drawn after each frame, from the two places as they are then, so it always fits. It adds no pull and costs no phase: **what is drawn cannot change what is computed**.

But it shows the spring that was there before. A leg longer than **radius** pulls its two ends together, a shorter one pushes them apart, and at 50&#x202f;px it does nothing.</source>
        <translation>Ein Körper, ein Fuß, und jetzt ein **Bein**: eine Linie vom einen zum anderen. Auch im Code ist es eine Zeile.

Es wird nach jedem Bild gezeichnet, aus den zwei Orten, wie sie dann sind, darum passt es immer. Es fügt keinen Zug hinzu und kostet keine Phase: **Was gezeichnet wird, kann nicht ändern, was berechnet wird**.

Aber es zeigt die Feder, die schon vorher da war. Ein Bein, das länger als **Radius** ist, zieht seine zwei Enden zusammen, ein kürzeres drückt sie auseinander, und bei 50&#x202f;px tut es nichts.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Two bodies</source>
        <translation>Zwei Körper</translation>
    </message>
    <message>
        <source>A foot and a body pull each other: whose turn it is makes a difference.</source>
        <translation>Ein Fuß und ein Körper ziehen einander: Wer gerade dran ist, macht einen Unterschied.</translation>
    </message>
</context>
</TS>
