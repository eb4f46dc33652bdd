<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>GravityWalls</name>
    <message>
        <source>Walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>Two walls and a floor. After each move they ask: **is an edge past me?** A place is the middle of a disc, so half its width counts: 15&#x202f;px for the body, 5&#x202f;px for a foot.

What went too far is put back until its edge touches the wall. Then its velocity across the wall is turned round: times −1, and times **bounce**, the share that it keeps. At 0 it stays at the wall.

A body in your hand meets no wall, and there is no ceiling.

(The tutorial behind this lesson calls the wall at 20&#x202f;px “right” and the one at 520&#x202f;px “left”. Here left is left.)</source>
        <translation>Zwei Wände und ein Boden. Nach jeder Bewegung fragen sie: **Ist ein Rand an mir vorbei?** Ein Ort ist die Mitte einer Scheibe, also zählt ihre halbe Breite: 15&#x202f;px beim Körper, 5&#x202f;px bei einem Fuß.

Was zu weit ging, wird zurückgesetzt, bis sein Rand die Wand berührt. Dann wird seine Geschwindigkeit quer zur Wand umgekehrt: mal −1, und mal **Abprall**, der Anteil, den es behält. Bei 0 bleibt es an der Wand.

Ein Körper in deiner Hand trifft auf keine Wand, und eine Decke gibt es nicht.

(Das Tutorial, auf dem diese Lektion beruht, nennt die Wand bei 20&#x202f;px „rechts“ und die bei 520&#x202f;px „links“. Hier ist links links.)</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>**Gravity** is one more pull that adds up: straight down, and the same for everything. y points down, so it adds to the y of the velocity.

It comes **before damping**, beside the springs. So what hangs still has pulls that cancel: a foot hangs where its spring pulls up as much as gravity pulls down, **whatever the damping**. Were gravity added after damping, more damping would mean hanging lower.

On the floor nothing holds the feet: they slide apart, and the body comes down between them. Its velocity there is not 0: in each frame gravity pulls it into the floor and the floor turns it round.</source>
        <translation>**Schwerkraft** ist noch ein Zug, der sich addiert: gerade nach unten, und für alles gleich. y zeigt nach unten, also kommt sie zum y der Geschwindigkeit hinzu.

Sie kommt **vor der Dämpfung**, neben den Federn. So hat auch Hängendes Züge, die sich aufheben: Ein Fuß hängt dort, wo seine Feder so stark nach oben zieht wie die Schwerkraft nach unten, **wie groß die Dämpfung auch ist**. Käme die Schwerkraft nach der Dämpfung, hieße mehr Dämpfung, tiefer zu hängen.

Am Boden hält nichts die Füße: Sie gleiten auseinander, und der Körper sinkt zwischen sie. Seine Geschwindigkeit dort ist nicht 0: In jedem Bild zieht die Schwerkraft ihn in den Boden, und der Boden kehrt ihn um.</translation>
    </message>
    <message>
        <source>Throw the creature so that some part of it hits the left wall.</source>
        <translation>Wirf die Figur so, dass ein Teil von ihr die linke Wand trifft.</translation>
    </message>
    <message>
        <source>Stop inside a frame (**Shift+→**) when something has moved into a wall, before it is put back.</source>
        <translation>Halte innerhalb eines Bildes an (**Umschalt+→**), wenn sich etwas in eine Wand bewegt hat und noch nicht zurückgesetzt ist.</translation>
    </message>
    <message>
        <source>Set **bounce** to 0 and throw it at a side wall. What hits it loses its speed.</source>
        <translation>Setze **Abprall** auf 0 und wirf sie gegen eine Seitenwand. Was auftrifft, verliert sein Tempo.</translation>
    </message>
    <message>
        <source>There is no ceiling. Throw the body out over the top.</source>
        <translation>Es gibt keine Decke. Wirf den Körper oben hinaus.</translation>
    </message>
    <message>
        <source>Hold the body high up until the feet hang still. They hang radius + g / k below it: 52.5&#x202f;px.</source>
        <translation>Halte den Körper hoch oben, bis die Füße still hängen. Sie hängen Radius + g / k unter ihm: 52,5&#x202f;px.</translation>
    </message>
    <message>
        <source>Do the same with **damping** at 0.6. Do the feet hang any lower?</source>
        <translation>Tu dasselbe mit **Dämpfung** auf 0,6. Hängen die Füße tiefer?</translation>
    </message>
    <message>
        <source>Stop inside a frame right after gravity has pulled.</source>
        <translation>Halte innerhalb eines Bildes gleich nach dem Zug der Schwerkraft an.</translation>
    </message>
    <message>
        <source>Put the walls 60&#x202f;px apart (**left** 240, **right** 300), lift the body, and let it down on its feet.</source>
        <translation>Stelle die Wände 60&#x202f;px auseinander (**linke Wand** 240, **rechte Wand** 300), heb den Körper an und lass ihn auf seine Füße herunter.</translation>
    </message>
</context>
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
