<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>MultiFoot</name>
    <message>
        <source>Two feet</source>
        <translation>Zwei Füße</translation>
    </message>
    <message>
        <source>Each foot keeps its distance from the body, as before. The body keeps its distance from **both** feet.

Two pulls on one body need no new formula: **they add up**. The first pull goes onto the velocity, then the second. Damping comes once, after all pulls, and then the body moves.

Damping is 0.85 from here on. The feet still move before the body, and each spring makes a little momentum from nothing. At 0.9 that is more than damping takes, and the creature leaves the picture.</source>
        <translation>Jeder Fuß hält seinen Abstand vom Körper, wie zuvor. Der Körper hält seinen Abstand von **beiden** Füßen.

Zwei Züge an einem Körper brauchen keine neue Formel: **Sie addieren sich**. Der erste Zug geht in die Geschwindigkeit ein, dann der zweite. Die Dämpfung kommt einmal, nach allen Zügen, und dann bewegt sich der Körper.

Von hier an ist die Dämpfung 0,85. Die Füße bewegen sich noch immer vor dem Körper, und jede Feder macht ein wenig Impuls aus dem Nichts. Bei 0,9 ist das mehr, als die Dämpfung nimmt, und die Figur verlässt die Szene.</translation>
    </message>
    <message>
        <source>Any number of feet</source>
        <translation>Beliebig viele Füße</translation>
    </message>
    <message>
        <source>Two more springs for each new foot could be written out, one line each. Instead **one loop** adds them: the loop does not know how many feet there are.

The number is a parameter now. The first five feet have places of their own; more than five start on a circle round the body.

Feet do not feel each other. They feel the body, and **the body feels every foot**, so a tug at one foot reaches all the others through it.</source>
        <translation>Zwei weitere Federn für jeden neuen Fuß könnte man ausschreiben, je eine Zeile. Stattdessen addiert sie **eine Schleife**: Die Schleife weiß nicht, wie viele Füße es gibt.

Die Anzahl ist jetzt ein Parameter. Die ersten fünf Füße haben eigene Orte; mehr als fünf beginnen auf einem Kreis um den Körper.

Füße spüren einander nicht. Sie spüren den Körper, und **der Körper spürt jeden Fuß**, darum erreicht ein Ruck an einem Fuß durch ihn alle anderen.</translation>
    </message>
    <message>
        <source>Feet that grow</source>
        <translation>Füße, die wachsen</translation>
    </message>
    <message>
        <source>Now the code places the feet, too: each **at random**, up to 50&#x202f;px from the body in x and in y. One number, the **seed**, decides all of them, so a run can be repeated.

**Stay below a dozen feet.** Each foot adds work to each frame. And the body feels every foot: the more there are, the stiffer it is held. At some number a step of a whole frame carries the body past its place by more than it was away, and every swing is wider than the last. From about 10 on they tremble, 16 mostly fly off, 60 explode.

The springs are not to blame: with two steps of half a frame each, 60 feet hold.</source>
        <translation>Jetzt setzt der Code auch die Füße: jeden **zufällig**, bis zu 50&#x202f;px vom Körper in x und in y. Eine Zahl, der **Startwert** (seed), entscheidet über alle, darum lässt sich ein Lauf wiederholen.

**Bleib unter einem Dutzend Füßen.** Jeder Fuß macht in jedem Bild Arbeit. Und der Körper spürt jeden Fuß: Je mehr es sind, desto steifer wird er gehalten. Ab einer gewissen Zahl trägt ein Zeitschritt von einem ganzen Bild den Körper weiter über seinen Ort hinaus, als er davon entfernt war, und jede Schwingung ist weiter als die vorige. Ab etwa 10 zittern sie, 16 fliegen meist davon, 60 explodieren.

Die Federn sind nicht schuld: Mit zwei Zeitschritten von je einem halben Bild halten 60 Füße.</translation>
    </message>
    <message>
        <source>Set **feet** to 12 and give it 200&#x202f;frames. Does it calm down?</source>
        <translation>Setze **Füße** auf 12 und gib ihnen 200&#x202f;Bilder Zeit. Kommt alles zur Ruhe?</translation>
    </message>
    <message>
        <source>Go back in time, change **damping**, and compare with the ghost.</source>
        <translation>Geh in der Zeit zurück, ändere **Dämpfung** und vergleiche mit dem Geist.</translation>
    </message>
    <message>
        <source>Set **feet** to 16, choose the method **Semi-implicit Euler**, and wait until all is still.</source>
        <translation>Setze **Füße** auf 16, wähle **Semi-implizites Euler** und warte, bis alles still ist.</translation>
    </message>
    <message>
        <source>Set **feet** to 60 and play until it explodes.</source>
        <translation>Setze **Füße** auf 60 und spiele, bis alles explodiert.</translation>
    </message>
    <message>
        <source>Keep the 60 feet, choose a **step** of 1/2&#x202f;frame, and wait until all is still.</source>
        <translation>Behalte die 60 Füße, wähle einen **Zeitschritt** von 1/2 Bild und warte, bis alles still ist.</translation>
    </message>
    <message>
        <source>Several pulls on one body add up, one after the other.</source>
        <translation>Mehrere Züge an einem Körper addieren sich, einer nach dem anderen.</translation>
    </message>
    <message>
        <source>Press **Space**, take the large disc, and carry it from one side of the picture to the other.</source>
        <translation>Drück die **Leertaste**, nimm die große Scheibe und trag sie von einer Seite der Szene zur anderen.</translation>
    </message>
    <message>
        <source>A loop adds the springs, so the same code does for any number of feet.</source>
        <translation>Eine Schleife addiert die Federn, darum taugt derselbe Code für beliebig viele Füße.</translation>
    </message>
    <message>
        <source>Play some seconds, drag the timeline back to the left, change **Damping**, and play on for a second.</source>
        <translation>Spiele einige Sekunden, zieh die Zeitleiste nach links zurück, ändere **Dämpfung** und spiele eine Sekunde weiter.</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Schleife</translation>
    </message>
    <message>
        <source>loop|one loop</source>
        <translation>Schleife|eine Schleife</translation>
    </message>
    <message>
        <source>Lines of code that are done again and again, once for each thing in a list.</source>
        <translation>Zeilen im Code, die immer wieder ausgeführt werden, einmal für jedes Ding in einer Liste.</translation>
    </message>
    <message>
        <source>Parameter</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>parameter|parameters</source>
        <translation>Parameter|Parameters|Parametern</translation>
    </message>
    <message>
        <source>A number of the scene that you can change, at the lower right.</source>
        <translation>Eine Zahl der Szene, die du rechts unten ändern kannst.</translation>
    </message>
    <message>
        <source>Many soft springs on one body hold it like one stiff spring, and a whole frame can be too long a step for that.</source>
        <translation>Viele weiche Federn an einem Körper halten ihn wie eine steife Feder, und dafür kann ein ganzes Bild ein zu langer Zeitschritt sein.</translation>
    </message>
    <message>
        <source>Type 16 into the field beside **Feet**. Above the picture, choose **Semi-implicit Euler** as method. Press **Space** and wait.</source>
        <translation>Gib im Feld neben **Füße** 16 ein. Wähle über der Szene **Semi-implizites Euler** als Verfahren. Drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Type 60 into the field beside **Feet**, and press **Space**. It takes some seconds.</source>
        <translation>Gib im Feld neben **Füße** 60 ein und drück die **Leertaste**. Es dauert einige Sekunden.</translation>
    </message>
    <message>
        <source>Leave 60 in the field beside **Feet**, press **Home** to go to frame 0, choose **1/2 frame** as step above the picture, and press **Space**.</source>
        <translation>Lass im Feld neben **Füße** 60 stehen, drück **Pos1**, um zu Bild 0 zu gehen, wähle über der Szene **1/2&#x2009;Bild** als Zeitschritt und drück die **Leertaste**.</translation>
    </message>
    <message>
        <source>Seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>seed</source>
        <translation>Startwert</translation>
    </message>
    <message>
        <source>A whole number from which all chance of a run is worked out. The same seed gives the same run.</source>
        <translation>Eine ganze Zahl, aus der aller Zufall eines Laufs berechnet wird. Derselbe Startwert gibt denselben Lauf.</translation>
    </message>
    <message>
        <source>Why are many soft springs like a stiff one?</source>
        <translation>Warum sind viele weiche Federn wie eine steife?</translation>
    </message>
    <message>
        <source>Move the body by 1&#x2009;px. A spring that points that way pulls it back by k. With n springs like it, it is

`n × k`

at once. Springs that point to the side pull less, so on the average about half of them count.

If that is so much that the body comes back **past** its place, and by more than it was away, then the next pull is stronger still. From then on each swing is wider than the last.</source>
        <translation>Verschiebe den Körper um 1&#x2009;px. Eine Feder, die in diese Richtung zeigt, zieht ihn mit k zurück. Mit n solchen Federn sind es

`n × k`

auf einmal. Federn, die zur Seite zeigen, ziehen weniger, darum zählt im Mittel etwa die Hälfte von ihnen.

Ist das so viel, dass der Körper **über** seinen Ort hinaus zurückkommt, und zwar weiter, als er davon entfernt war, dann ist der nächste Zug noch stärker. Von da an ist jede Schwingung weiter als die vorige.</translation>
    </message>
    <message>
        <source>Yes. After 50&#x202f;frames nothing moves faster than a tenth of a pixel per frame.</source>
        <translation>Ja. Nach 50&#x202f;Bildern bewegt sich nichts schneller als ein Zehntel Pixel pro Bild.</translation>
    </message>
    <message>
        <source>choose the method **Semi-implicit Euler**.</source>
        <translation>wähle das Verfahren **Semi-implizites Euler**.</translation>
    </message>
    <message>
        <source>let time run (**Space**), with steps of 1&#x202f;frame.</source>
        <translation>lass die Zeit laufen (**Leertaste**), mit Zeitschritten von 1&#x202f;Bild.</translation>
    </message>
    <message>
        <source>set **feet** to 60.</source>
        <translation>setze **Füße** auf 60.</translation>
    </message>
    <message>
        <source>Pull a foot at least 75&#x202f;px out, let go, and wait until all is still.</source>
        <translation>Zieh einen Fuß mindestens 75&#x202f;px hinaus, lass los und warte, bis alles still ist.</translation>
    </message>
    <message>
        <source>Carry the body at least 100&#x202f;px. Both feet follow.</source>
        <translation>Trag den Körper mindestens 100&#x202f;px. Beide Füße folgen.</translation>
    </message>
    <message>
        <source>Set **damping** to 0.9 and hands off. How long does it take to fly away?</source>
        <translation>Setze **Dämpfung** auf 0,9, und Hände weg. Wie lange braucht sie, um davonzufliegen?</translation>
    </message>
    <message>
        <source>Pull one foot at least 75&#x202f;px out, let go, and wait until all is still.</source>
        <translation>Zieh einen Fuß mindestens 75&#x202f;px hinaus, lass los und warte, bis alles still ist.</translation>
    </message>
    <message>
        <source>It has left the stage of 540 × 400&#x202f;px after about 225&#x202f;frames, 7.5 seconds. Its springs make more momentum than damping takes.</source>
        <translation>Nach etwa 225&#x202f;Bildern, 7,5 Sekunden, hat sie die Bühne von 540 × 400&#x202f;px verlassen. Ihre Federn machen mehr Impuls, als die Dämpfung nimmt.</translation>
    </message>
    <message>
        <source>Press **Home**. Type 0.9 into the field beside **Damping**, press **Space**, and touch nothing.</source>
        <translation>Drück **Pos1**. Gib im Feld neben **Dämpfung** 0,9 ein, drück die **Leertaste** und fass nichts an.</translation>
    </message>
    <message>
        <source>Press **Home**. Type 12 into the field beside **Feet**, press **Space**, and wait seven seconds.</source>
        <translation>Drück **Pos1**. Gib 12 in das Feld neben **Füße** ein, drück die **Leertaste** und warte sieben Sekunden.</translation>
    </message>
    <message>
        <source>press **Home**, and set **feet** to 12 there: the creature was out of shape.</source>
        <translation>drück **Pos1** und setze **Füße** dort auf 12: Das Wesen war aus der Form.</translation>
    </message>
    <message>
        <source>Press **Space**. Take one of the small discs, pull it to the upper edge of the picture, let go, and wait.</source>
        <translation>Drück die **Leertaste**. Nimm eine der kleinen Scheiben, zieh sie an den oberen Rand der Szene, lass los und warte.</translation>
    </message>
    <message>
        <source>Press **Space**, pull one of the small discs to the upper edge of the picture, let go, and wait.</source>
        <translation>Drück die **Leertaste**, zieh eine der kleinen Scheiben an den oberen Rand der Szene, lass los und warte.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until it has left the stage.</source>
        <translation>lass die Zeit laufen (**Leertaste**), bis sie die Bühne verlassen hat.</translation>
    </message>
</context>
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
</TS>
