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

Am Boden hält nichts die Füße: Sie gleiten auseinander, und der Körper sinkt zwischen sie. Seine Geschwindigkeit dort ist nicht 0: In jedem Bild zieht die Schwerkraft ihn in den Boden, und der Boden kehrt seine Geschwindigkeit um.</translation>
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
    <message>
        <source>A wall puts back what went too far, and turns its velocity round.</source>
        <translation>Eine Wand setzt zurück, was zu weit ging, und kehrt seine Geschwindigkeit um.</translation>
    </message>
    <message>
        <source>Press **Space**, take the large disc, swing it quickly to the left, and let go on the way.</source>
        <translation>Drück die **Leertaste**, nimm die große Scheibe, schwing sie schnell nach links und lass unterwegs los.</translation>
    </message>
    <message>
        <source>Throw the creature at a wall and stop just before it is there. Then press **Shift+→** again and again: after a move, look whether an edge is past the wall.</source>
        <translation>Wirf die Figur gegen eine Wand und halte an, kurz bevor sie dort ist. Drück dann immer wieder **Umschalt+→**: Sieh nach jeder Bewegung, ob ein Rand an der Wand vorbei ist.</translation>
    </message>
    <message>
        <source>Type 0 into the field beside **Bounce**, press **Space**, and throw the creature at the left or the right wall.</source>
        <translation>Gib im Feld neben **Abprall** 0 ein, drück die **Leertaste** und wirf die Figur gegen die linke oder die rechte Wand.</translation>
    </message>
    <message>
        <source>Press **Space**, take the large disc, swing it quickly up past the upper edge, and let go on the way.</source>
        <translation>Drück die **Leertaste**, nimm die große Scheibe, schwing sie schnell nach oben über den oberen Rand und lass unterwegs los.</translation>
    </message>
    <message>
        <source>Bounce</source>
        <translation>Abprall</translation>
    </message>
    <message>
        <source>bounce</source>
        <translation>Abprall</translation>
    </message>
    <message>
        <source>The share of its velocity that a thing keeps when a wall turns it round. At 1 it comes back as fast as it came, at 0 it stays at the wall.</source>
        <translation>Der Anteil seiner Geschwindigkeit, den etwas behält, wenn eine Wand es umkehrt. Bei 1 kommt es so schnell zurück, wie es kam, bei 0 bleibt es an der Wand.</translation>
    </message>
    <message>
        <source>Gravity is one more pull, the same for everything, and it comes before damping.</source>
        <translation>Schwerkraft ist noch ein Zug, für alles gleich, und sie kommt vor der Dämpfung.</translation>
    </message>
    <message>
        <source>Press **Space**, take the large disc, lift it to the upper edge, and hold it there until the feet have stopped swinging.</source>
        <translation>Drück die **Leertaste**, nimm die große Scheibe, heb sie an den oberen Rand und halte sie dort, bis die Füße nicht mehr schwingen.</translation>
    </message>
    <message>
        <source>Type 0.6 into the field beside **Damping**. Then lift the large disc and hold it, as before.</source>
        <translation>Gib im Feld neben **Dämpfung** 0,6 ein. Heb dann die große Scheibe und halte sie, wie zuvor.</translation>
    </message>
    <message>
        <source>Type 240 beside **Left wall** and 300 beside **Right wall**. Press **Space**, lift the large disc until its feet hang under it, let it down slowly until they stand, and let go.</source>
        <translation>Gib neben **Linke Wand** 240 und neben **Rechte Wand** 300 ein. Drück die **Leertaste**, heb die große Scheibe, bis ihre Füße unter ihr hängen, lass sie langsam herunter, bis sie stehen, und lass los.</translation>
    </message>
    <message>
        <source>gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>A pull straight down that is the same for everything: each frame it adds as much to the velocity, however far down a thing is.</source>
        <translation>Ein Zug gerade nach unten, der für alles gleich ist: In jedem Bild gibt er gleich viel zur Geschwindigkeit hinzu, wie weit unten etwas auch ist.</translation>
    </message>
    <message>
        <source>Why is a fall a parabola?</source>
        <translation>Warum ist ein Fall eine Parabel?</translation>
    </message>
    <message>
        <source>Gravity adds the same to the velocity in each frame, so after t frames it is

`v = g × t`

The ways add up. The first is short and the last is the longest; the middle one, half of g × t, stands for all:

`way = g × t² / 2`

Twice as long, four times as deep. Sideways nothing pulls, so a thrown thing goes equally far each frame. Evenly to the side and ever faster down: that curve is a parabola.

(In steps of a frame, without damping, the sum is g × t × (t + 1) / 2: a little more. The lesson Accuracy is about that.)</source>
        <translation>Die Schwerkraft gibt in jedem Bild gleich viel zur Geschwindigkeit hinzu, nach t Bildern ist sie also

`v = g × t`

Die Wege (way) addieren sich. Der erste ist kurz und der letzte der längste; der mittlere, die Hälfte von g × t, steht für alle:

`way = g × t² / 2`

Doppelt so lang, viermal so tief. Zur Seite zieht nichts, darum kommt etwas Geworfenes in jedem Bild gleich weit. Gleichmäßig zur Seite und immer schneller nach unten: Diese Kurve ist eine Parabel.

(In Zeitschritten von einem Bild, ohne Dämpfung, ist die Summe g × t × (t + 1) / 2: ein wenig mehr. Davon handelt die Lektion Genauigkeit.)</translation>
    </message>
    <message>
        <source>hold it still, high over the floor, until the feet hang still.</source>
        <translation>halte ihn still, hoch über dem Boden, bis die Füße still hängen.</translation>
    </message>
    <message>
        <source>Throw the creature, at 5&#x202f;px per frame or more, so that some part of it hits the left wall.</source>
        <translation>Wirf die Figur, mit 5&#x202f;px pro Bild oder mehr, so, dass ein Teil von ihr die linke Wand trifft.</translation>
    </message>
    <message>
        <source>throw it so that it hits the left wall.</source>
        <translation>wirf sie so, dass sie die linke Wand trifft.</translation>
    </message>
    <message>
        <source>press **Shift+→** until something has moved into a wall: throw it at one first.</source>
        <translation>drück **Umschalt+→**, bis sich etwas in eine Wand bewegt hat: Wirf sie zuerst gegen eine.</translation>
    </message>
    <message>
        <source>throw it so that it hits a side wall.</source>
        <translation>wirf sie so, dass sie eine Seitenwand trifft.</translation>
    </message>
    <message>
        <source>throw it upwards, and harder: the body has to get above y = 0.</source>
        <translation>wirf sie nach oben, und kräftiger: Der Körper muss über y = 0 kommen.</translation>
    </message>
    <message>
        <source>No, 52.5&#x202f;px again: there the spring pulls up as much as gravity pulls down, and damping has nothing to take.</source>
        <translation>Nein, wieder 52,5&#x202f;px: Dort zieht die Feder so stark nach oben wie die Schwerkraft nach unten, und die Dämpfung hat nichts zu nehmen.</translation>
    </message>
    <message>
        <source>press **Shift+→** until gravity is the last phase that was done.</source>
        <translation>drück **Umschalt+→**, bis die Schwerkraft die letzte erledigte Phase ist.</translation>
    </message>
    <message>
        <source>lift it again, and let it down with all feet under it. It stands %1&#x202f;px over the floor.</source>
        <translation>heb ihn noch einmal und lass ihn mit allen Füßen unter sich herunter. Er steht %1&#x202f;px über dem Boden.</translation>
    </message>
    <message>
        <source>Stop, and press **Shift+→** until the strip under the timeline marks gravity.</source>
        <translation>Halte an und drück **Umschalt+→**, bis der Streifen unter der Zeitleiste die Schwerkraft markiert.</translation>
    </message>
    <message>
        <source>the bounce at a wall</source>
        <translation>der Abprall an einer Wand</translation>
    </message>
    <message>
        <source>Write the **bounce at the right wall**: if the edge of the disc is past the wall, put the disc back, and turn its velocity round.</source>
        <translation>Schreibe den **Abprall an der rechten Wand**: Ist der Rand der Scheibe an der Wand vorbei, setze die Scheibe zurück und kehre ihre Geschwindigkeit um.</translation>
    </message>
    <message>
        <source>If the disc is past the right wall: put it back, and let it bounce.</source>
        <translation>Ist die Scheibe an der rechten Wand vorbei: zurücksetzen und abprallen lassen.</translation>
    </message>
    <message>
        <source>The disc touches the wall when its middle is `me.radius` away from `right`.</source>
        <translation>Die Scheibe berührt die Wand, wenn ihre Mitte `me.radius` von `right` entfernt ist.</translation>
    </message>
    <message>
        <source>In the `if` are two lines: one sets `me.position.x`, the other turns `me.velocity.x` round and keeps the share `bounce` of it.</source>
        <translation>Im `if` stehen zwei Zeilen: Die eine setzt `me.position.x`, die andere kehrt `me.velocity.x` um und behält davon den Anteil `bounce`.</translation>
    </message>
    <message>
        <source>`if (me.position.x &gt; right - …)`, and in it `me.position.x = …;` and `me.velocity.x *= -…;`</source>
        <translation>`if (me.position.x &gt; right - …)`, und darin `me.position.x = …;` und `me.velocity.x *= -…;`</translation>
    </message>
    <message>
        <source>Half of the disc is inside the wall: the middle of the disc bounces, not its edge. Use `me.radius`.</source>
        <translation>Die halbe Scheibe steckt in der Wand: Die Mitte der Scheibe prallt ab, nicht ihr Rand. Nimm `me.radius`.</translation>
    </message>
    <message>
        <source>The velocity still points into the wall. A minus turns it round.</source>
        <translation>Die Geschwindigkeit zeigt noch in die Wand hinein. Ein Minus kehrt sie um.</translation>
    </message>
    <message>
        <source>The velocity turns round, but the disc is still past the wall. Put it back, too.</source>
        <translation>Die Geschwindigkeit kehrt sich um, aber die Scheibe ist noch an der Wand vorbei. Setze sie auch zurück.</translation>
    </message>
    <message>
        <source>The disc is put back, but its velocity still points into the wall.</source>
        <translation>Die Scheibe wird zurückgesetzt, aber ihre Geschwindigkeit zeigt noch in die Wand hinein.</translation>
    </message>
    <message>
        <source>The whole velocity turns round. Only the part across the wall does, which is x.</source>
        <translation>Die ganze Geschwindigkeit kehrt sich um. Das tut nur der Teil quer zur Wand, also x.</translation>
    </message>
    <message>
        <source>the bounce on the floor</source>
        <translation>der Abprall am Boden</translation>
    </message>
    <message>
        <source>Write the **bounce on the floor**, for a disc whose edge is below `floor`.</source>
        <translation>Schreibe den **Abprall am Boden**, für eine Scheibe, deren Rand unter `floor` ist.</translation>
    </message>
    <message>
        <source>If the disc is below the floor: put it back, and let it bounce.</source>
        <translation>Ist die Scheibe unter dem Boden: zurücksetzen und abprallen lassen.</translation>
    </message>
    <message>
        <source>It is the bounce at the wall, with y in place of x. y points down.</source>
        <translation>Es ist der Abprall an der Wand, mit y anstelle von x. y zeigt nach unten.</translation>
    </message>
    <message>
        <source>The disc touches the floor when its middle is `me.radius` above `floor`: at `floor - me.radius`.</source>
        <translation>Die Scheibe berührt den Boden, wenn ihre Mitte `me.radius` über `floor` ist: bei `floor - me.radius`.</translation>
    </message>
    <message>
        <source>`if (me.position.y &gt; …)`, and in it `me.position.y = …;` and `me.velocity.y *= -…;`</source>
        <translation>`if (me.position.y &gt; …)`, und darin `me.position.y = …;` und `me.velocity.y *= -…;`</translation>
    </message>
    <message>
        <source>Half of the disc is below the floor. Use `me.radius`.</source>
        <translation>Die halbe Scheibe ist unter dem Boden. Nimm `me.radius`.</translation>
    </message>
    <message>
        <source>The velocity turns round, but the disc is still below the floor. Put it back, too.</source>
        <translation>Die Geschwindigkeit kehrt sich um, aber die Scheibe ist noch unter dem Boden. Setze sie auch zurück.</translation>
    </message>
    <message>
        <source>The disc is put back, but its velocity still points down.</source>
        <translation>Die Scheibe wird zurückgesetzt, aber ihre Geschwindigkeit zeigt noch nach unten.</translation>
    </message>
    <message>
        <source>This happens above the floor. y points down, so what is below the floor has the larger y.</source>
        <translation>Das geschieht über dem Boden. y zeigt nach unten, also hat das größere y, was unter dem Boden ist.</translation>
    </message>
    <message>
        <source>Write the line for **gravity**: in each frame it adds the same velocity to every body, downwards.</source>
        <translation>Schreibe die Zeile für die **Schwerkraft**: In jedem Bild gibt sie jedem Körper dieselbe Geschwindigkeit dazu, nach unten.</translation>
    </message>
    <message>
        <source>Gravity pulls me down.</source>
        <translation>Die Schwerkraft zieht mich nach unten.</translation>
    </message>
    <message>
        <source>Gravity is one more pull, so it changes the velocity.</source>
        <translation>Die Schwerkraft ist noch ein Zug, also ändert sie die Geschwindigkeit.</translation>
    </message>
    <message>
        <source>It pulls down only, and y points down.</source>
        <translation>Sie zieht nur nach unten, und y zeigt nach unten.</translation>
    </message>
    <message>
        <source>`me.velocity.y += …;`</source>
        <translation>`me.velocity.y += …;`</translation>
    </message>
    <message>
        <source>The bodies fall upwards. y points down, so a pull down is added to y.</source>
        <translation>Die Körper fallen nach oben. y zeigt nach unten, also wird ein Zug nach unten zu y addiert.</translation>
    </message>
    <message>
        <source>The bodies sink at the same speed for ever. Gravity changes the velocity, and what falls gets faster.</source>
        <translation>Die Körper sinken ewig gleich schnell. Die Schwerkraft ändert die Geschwindigkeit, und was fällt, wird schneller.</translation>
    </message>
    <message>
        <source>This gravity pulls to the right. Down is y.</source>
        <translation>Diese Schwerkraft zieht nach rechts. Nach unten ist y.</translation>
    </message>
    <message>
        <source>With `=` the body forgets how fast it fell already.</source>
        <translation>Mit `=` vergisst der Körper, wie schnell er schon fiel.</translation>
    </message>
    <message>
        <source>the whole frame</source>
        <translation>das ganze Bild</translation>
    </message>
    <message>
        <source>**From the empty page:** write the whole frame of a body with feet in a room, with springs, gravity, damping and three walls.</source>
        <translation>**Von der leeren Seite:** Schreibe das ganze Bild eines Körpers mit Füßen in einem Raum, mit Federn, Schwerkraft, Dämpfung und drei Wänden.</translation>
    </message>
    <message>
        <source>The frame is that of lesson 3: the body follows if it is held, then each foot, then the body. New is only how a body moves.</source>
        <translation>Das Bild ist das von Lektion 3: Der Körper folgt, wenn er gehalten wird, dann jeder Fuß, dann der Körper. Neu ist nur, wie sich ein Körper bewegt.</translation>
    </message>
    <message>
        <source>To move: add gravity, damp, move. Then three walls: the right one, the left one and the floor. There is no ceiling.</source>
        <translation>Zum Bewegen: Schwerkraft addieren, dämpfen, bewegen. Dann drei Wände: die rechte, die linke und der Boden. Eine Decke gibt es nicht.</translation>
    </message>
    <message>
        <source>A wall: `if (me.position.x &gt; right - me.radius)`, then `me.position.x = right - me.radius;` and `me.velocity.x *= -bounce;`</source>
        <translation>Eine Wand: `if (me.position.x &gt; right - me.radius)`, dann `me.position.x = right - me.radius;` und `me.velocity.x *= -bounce;`</translation>
    </message>
    <message>
        <source>The rest is right, but gravity is missing.</source>
        <translation>Der Rest stimmt, aber die Schwerkraft fehlt.</translation>
    </message>
    <message>
        <source>The rest is right, but the bodies fall upwards.</source>
        <translation>Der Rest stimmt, aber die Körper fallen nach oben.</translation>
    </message>
    <message>
        <source>The rest is right, but every pull points away from its target.</source>
        <translation>Der Rest stimmt, aber jeder Zug zeigt von seinem Ziel weg.</translation>
    </message>
    <message>
        <source>Write the whole frame. The names: body, feet[i] (each with position, velocity, radius, held), feet.count, hand, k, damp, radius, gravity, bounce, left, right, floor.</source>
        <translation>Schreibe das ganze Bild. Die Namen: body, feet[i] (jeweils mit position, velocity, radius, held), feet.count, hand, k, damp, radius, gravity, bounce, left, right, floor.</translation>
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
