<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>SingleSpring</name>
    <message>
        <source>pull to come</source>
        <translation>künftiger Zug</translation>
    </message>
    <message>
        <source>%1° = %2&#x202f;rad</source>
        <translation>%1° = %2 rad</translation>
    </message>
    <message>
        <source>Drag and throw</source>
        <translation>Ziehen und werfen</translation>
    </message>
    <message>
        <source>This dot is a **foot**. Its place is two numbers: **x** pixels (px) to the right, **y** pixels down. Its **velocity** is two numbers as well: how far it goes in x and in y from one picture, a **frame**, to the next.

While you hold the foot, its velocity is the distance that your hand came in the last frame. When you let go it keeps that. So **a moving hand throws it**.

**Damping** is the share of its velocity that it keeps each frame. At 0.9 a throw of 10&#x202f;px per frame glides 90&#x202f;px and stops.

The arrow is the pull that a spring to the cross would have. It does not act yet: that is the next step.</source>
        <translation>Dieser Punkt ist ein **Fuß**. Sein Ort sind zwei Zahlen: **x** Pixel (px) nach rechts, **y** Pixel nach unten. Auch seine **Geschwindigkeit** sind zwei Zahlen: wie weit er in x und in y von einem Bild (**Frame**) zum nächsten geht.

Solange du den Fuß hältst, ist seine Geschwindigkeit der Weg, den deine Hand im letzten Bild kam. Wenn du loslässt, behält er sie. Also **wirft ihn eine Hand, die sich bewegt**.

**Dämpfung** ist der Anteil seiner Geschwindigkeit, den er in jedem Bild behält. Bei 0,9 gleitet ein Wurf von 10&#x202f;px pro Bild 90&#x202f;px weit und bleibt stehen.

Der Pfeil ist der Zug, den eine Feder zum Kreuz hätte. Er wirkt noch nicht: Das ist der nächste Schritt.</translation>
    </message>
    <message>
        <source>A fixed centre</source>
        <translation>Eine feste Mitte</translation>
    </message>
    <message>
        <source>A **spring** pulls the foot to the cross. The pull is the distance times the stiffness **k**: twice as far, **twice the pull**. That is Hooke’s law.

x and y are worked out apart. The distance in x changes the velocity in x, the distance in y the velocity in y. Together they point at the cross.

Each frame has three phases: the spring adds its pull to the velocity, damping takes its share, and the foot moves.

The foot is fastest near the cross, where the pull is weakest, so it **overshoots** and swings back. Damping makes each swing smaller, until the foot stands on the cross, where the pull is 0.</source>
        <translation>Eine **Feder** zieht den Fuß zum Kreuz. Der Zug ist der Abstand mal die Steifigkeit **k**: doppelt so weit, **doppelter Zug**. Das ist das Hookesche Gesetz.

x und y werden getrennt ausgerechnet. Der Abstand in x ändert die Geschwindigkeit in x, der Abstand in y die Geschwindigkeit in y. Zusammen zeigen sie auf das Kreuz.

Jedes Bild hat drei Phasen: Die Feder gibt ihren Zug zur Geschwindigkeit hinzu, die Dämpfung nimmt ihren Anteil, und der Fuß bewegt sich.

Am schnellsten ist der Fuß nahe am Kreuz, wo der Zug am schwächsten ist, darum **schießt er darüber hinaus** und schwingt zurück. Die Dämpfung macht jede Schwingung kleiner, bis der Fuß auf dem Kreuz steht, wo der Zug 0 ist.</translation>
    </message>
    <message>
        <source>A moving body</source>
        <translation>Ein bewegter Körper</translation>
    </message>
    <message>
        <source>Now the spring ends at the **body**, and you can carry the body about. The spring reads the body’s place anew in each frame, so **the foot follows wherever you go**. Its formula is the same as before: only the centre is now a place that moves.

The foot comes late. The pull changes its velocity, and only the velocity changes its place.

This body is a handle: it feels no pull and keeps no velocity, and stays where you leave it.</source>
        <translation>Jetzt endet die Feder am **Körper**, und den Körper kannst du umhertragen. Die Feder liest den Ort des Körpers in jedem Bild neu, darum **folgt dir der Fuß überallhin**. Ihre Formel ist dieselbe wie zuvor: Nur die Mitte ist jetzt ein Ort, der sich bewegt.

Der Fuß kommt verspätet. Der Zug ändert seine Geschwindigkeit, und erst die Geschwindigkeit ändert seinen Ort.

Dieser Körper ist ein Griff: Er spürt keinen Zug und behält keine Geschwindigkeit, und bleibt, wo du ihn lässt.</translation>
    </message>
    <message>
        <source>An offset</source>
        <translation>Ein Versatz</translation>
    </message>
    <message>
        <source>The foot came to rest on top of the body, and one hid the other. So give the spring another **target**: the cross, 50&#x202f;px to the right of the body. The **offset** is added to the body’s x; its y stays.

Nothing else changes: the pull is still k times the distance, now to the target.

But **an offset chooses the side for the foot**. From wherever you let it go, it ends on the right. To keep the distance and leave the side free you need more than an offset: a direction.</source>
        <translation>Der Fuß kam auf dem Körper zur Ruhe, und der eine verdeckte den anderen. Gib der Feder also ein anderes **Ziel**: das Kreuz, 50&#x202f;px rechts vom Körper. Der **Versatz** wird zum x des Körpers addiert; sein y bleibt.

Sonst ändert sich nichts: Der Zug ist noch immer k mal der Abstand, jetzt zum Ziel.

Aber **ein Versatz wählt die Seite für den Fuß**. Wo du ihn auch loslässt, er endet rechts. Um den Abstand zu halten und die Seite freizulassen, brauchst du mehr als einen Versatz: eine Richtung.</translation>
    </message>
    <message>
        <source>Any direction</source>
        <translation>Jede Richtung</translation>
    </message>
    <message>
        <source>The target is now 50&#x202f;px from the body **in the direction in which the foot is**: any place on the ring will do.

dx and dy, the x and y of `from` in the code, lead from the body to the foot. `atan2(dy, dx)` makes them one **angle**, counted from the x axis. y points down, so it grows clockwise.

The angle is in **radians**: 1&#x202f;rad = 57.2958°, and half a turn is 3.1416&#x202f;rad. (The tutorial behind this lesson says about 59°; its code is right all the same, as it never needs degrees.)

`cos` and `sin` lead back: the x and y of a way of 1&#x202f;px at that angle. Times **radius**, plus the body’s place: that is the target.</source>
        <translation>Das Ziel ist jetzt 50&#x202f;px vom Körper entfernt, **in der Richtung, in der der Fuß ist**: Jeder Ort auf dem Ring ist recht.

dx und dy, das x und y von `from` im Code, führen vom Körper zum Fuß. `atan2(dy, dx)` macht aus ihnen einen **Winkel**, von der x-Achse aus gezählt. y zeigt nach unten, darum wächst er im Uhrzeigersinn.

Der Winkel ist in **Radiant**: 1 rad = 57,2958°, und eine halbe Drehung ist 3,1416 rad. (Das Tutorial, auf dem diese Lektion beruht, sagt etwa 59°; sein Code stimmt trotzdem, denn Grad braucht er nie.)

`cos` und `sin` führen zurück: das x und y eines Wegs von 1&#x202f;px in diesem Winkel. Mal **Radius**, plus der Ort des Körpers: Das ist das Ziel.</translation>
    </message>
    <message>
        <source>Drag the foot to the cross, to 15&#x202f;px, hold it still, and let go. Nothing pulls it: it stays.</source>
        <translation>Zieh den Fuß bis auf 15&#x202f;px zum Kreuz, halte ihn still und lass los. Nichts zieht an ihm: Er bleibt.</translation>
    </message>
    <message>
        <source>Throw it: let go while the mouse is moving. It glides and stops.</source>
        <translation>Wirf ihn: Lass los, während die Maus sich bewegt. Er gleitet und bleibt stehen.</translation>
    </message>
    <message>
        <source>Set **damping** to 1 and throw it again. Does it ever stop? Give it 60&#x202f;frames.</source>
        <translation>Setze **Dämpfung** auf 1 und wirf ihn noch einmal. Bleibt er je stehen? Gib ihm 60&#x202f;Bilder.</translation>
    </message>
    <message>
        <source>Pull the foot at least 100&#x202f;px away from the cross, let go, and wait until it is still.</source>
        <translation>Zieh den Fuß mindestens 100&#x202f;px vom Kreuz weg, lass los und warte, bis er still ist.</translation>
    </message>
    <message>
        <source>Stop inside a frame (**Shift+→**) when the spring has pulled and nothing has moved yet.</source>
        <translation>Halte innerhalb eines Bildes an (**Umschalt+→**), wenn die Feder gezogen hat und sich noch nichts bewegt hat.</translation>
    </message>
    <message>
        <source>Set **damping** to 1, pull the foot out and let go. Does it ever stop? Give it 100&#x202f;frames.</source>
        <translation>Setze **Dämpfung** auf 1, zieh den Fuß hinaus und lass los. Bleibt er je stehen? Gib ihm 100&#x202f;Bilder.</translation>
    </message>
    <message>
        <source>Go back in time, change **damping**, and compare with the ghost.</source>
        <translation>Geh in der Zeit zurück, ändere **Dämpfung** und vergleiche mit dem Geist.</translation>
    </message>
    <message>
        <source>Carry the body at least 200&#x202f;px away, and wait until the foot lies on it.</source>
        <translation>Trag den Körper mindestens 200&#x202f;px weg und warte, bis der Fuß auf ihm liegt.</translation>
    </message>
    <message>
        <source>Set the stiffness **k** to 0.02 and carry the body until the foot is 150&#x202f;px behind.</source>
        <translation>Setze die Steifigkeit **k** auf 0,02 und trag den Körper, bis der Fuß 150&#x202f;px zurückliegt.</translation>
    </message>
    <message>
        <source>Throw the foot, and stop inside a frame when the spring has pulled it and it has not moved.</source>
        <translation>Wirf den Fuß und halte innerhalb eines Bildes an, wenn die Feder an ihm gezogen hat und er sich noch nicht bewegt hat.</translation>
    </message>
    <message>
        <source>Let the foot go on the left of the body. Where does it come to rest?</source>
        <translation>Lass den Fuß links vom Körper los. Wo kommt er zur Ruhe?</translation>
    </message>
    <message>
        <source>Give **offset** a minus, at least −10, and wait until the foot is still.</source>
        <translation>Gib **Versatz** ein Minus, mindestens −10, und warte, bis der Fuß still ist.</translation>
    </message>
    <message>
        <source>Carry the body at least 100&#x202f;px. The target goes with it.</source>
        <translation>Trag den Körper mindestens 100&#x202f;px. Das Ziel geht mit.</translation>
    </message>
    <message>
        <source>Let the foot go close by on the left of the body, so that it comes to rest there.</source>
        <translation>Lass den Fuß dicht links vom Körper los, sodass er dort zur Ruhe kommt.</translation>
    </message>
    <message>
        <source>Hold the foot straight below the body, to 5°. What is the angle in radians?</source>
        <translation>Halte den Fuß gerade unter den Körper, bis auf 5°. Wie groß ist der Winkel in Radiant?</translation>
    </message>
    <message>
        <source>Set **radius** to 120 and wait until the foot is still.</source>
        <translation>Setze **Radius** auf 120 und warte, bis der Fuß still ist.</translation>
    </message>
    <message>
        <source>Stop inside a frame when the spring has pulled. Find `angle` and `target` in the code.</source>
        <translation>Halte innerhalb eines Bildes an, wenn die Feder gezogen hat. Such `angle` und `target` im Code.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Single spring</source>
        <translation>Eine Feder</translation>
    </message>
    <message>
        <source>One foot on one spring: pull, let go, and see why it swings and settles.</source>
        <translation>Ein Fuß an einer Feder: Zieh, lass los und sieh, warum er schwingt und zur Ruhe kommt.</translation>
    </message>
</context>
</TS>
