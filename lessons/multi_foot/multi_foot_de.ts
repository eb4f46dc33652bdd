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

Von hier an ist die Dämpfung 0,85. Die Füße bewegen sich noch immer vor dem Körper, und jede Feder macht ein wenig Impuls aus dem Nichts. Bei 0,9 ist das mehr, als die Dämpfung nimmt, und die Figur verlässt das Bild.</translation>
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
        <source>Pull a foot at least 100&#x202f;px out, let go, and wait until all is still.</source>
        <translation>Zieh einen Fuß mindestens 100&#x202f;px hinaus, lass los und warte, bis alles still ist.</translation>
    </message>
    <message>
        <source>Carry the body at least 200&#x202f;px. Both feet follow.</source>
        <translation>Trag den Körper mindestens 200&#x202f;px. Beide Füße folgen.</translation>
    </message>
    <message>
        <source>Set **damping** to 0.9 and hands off. How long does it stay in the picture?</source>
        <translation>Setze **Dämpfung** auf 0,9, und Hände weg. Wie lange bleibt sie im Bild?</translation>
    </message>
    <message>
        <source>Pull one foot at least 100&#x202f;px out, let go, and wait until all is still.</source>
        <translation>Zieh einen Fuß mindestens 100&#x202f;px hinaus, lass los und warte, bis alles still ist.</translation>
    </message>
    <message>
        <source>Set **feet** to 12 and give it 200&#x202f;frames. Does it calm down?</source>
        <translation>Setze **Füße** auf 12 und gib ihnen 200&#x202f;Bilder. Kommt alles zur Ruhe?</translation>
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
