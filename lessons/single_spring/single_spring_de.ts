<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>SingleSpring</name>
    <message>
        <source>pull, not acting yet</source>
        <translation>Zug, wirkt noch nicht</translation>
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
        <source>A fixed centre</source>
        <translation>Eine feste Mitte</translation>
    </message>
    <message>
        <source>A **spring**, the zigzag, pulls the foot to the cross. The pull is the distance times the stiffness **k**: twice as far, **twice the pull**. That is Hooke’s law.

x and y are worked out apart. The distance in x changes the velocity in x, the distance in y the velocity in y. Together they point at the cross.

Each frame has three phases: the spring adds its pull to the velocity, damping takes its share, and the foot moves.

The foot is fastest near the cross, where the pull is weakest, so it **overshoots** and swings back. Damping makes each swing smaller, until the foot stands on the cross, where the pull is 0.</source>
        <translation>Eine **Feder**, das Zickzack, zieht den Fuß zum Kreuz. Der Zug ist der Abstand mal die Steifigkeit **k**: doppelt so weit, **doppelter Zug**. Das ist das Hooke’sche Gesetz.

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

Der Fuß kommt zu spät. Der Zug ändert seine Geschwindigkeit, und erst die Geschwindigkeit ändert seinen Ort.

Dieser Körper ist ein Griff: Er spürt keinen Zug, behält keine Geschwindigkeit und bleibt, wo du ihn lässt.</translation>
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
        <source>Set **damping** to 1 and throw it again. Does it ever stop? Give it 60&#x202f;frames.</source>
        <translation>Setze **Dämpfung** auf 1 und wirf ihn noch einmal. Bleibt er je stehen? Gib ihm 60&#x202f;Bilder Zeit.</translation>
    </message>
    <message>
        <source>Pull the foot at least 100&#x202f;px away from the cross, let go, and wait until it is still.</source>
        <translation>Zieh den Fuß mindestens 100&#x202f;px vom Kreuz weg, lass los und warte, bis er still ist.</translation>
    </message>
    <message>
        <source>Show the page **Engine** of the code, and stop inside a frame (**Shift+→**) when the spring has pulled and nothing has moved yet.</source>
        <translation>Zeig beim Code die Seite **Engine** und halte innerhalb eines Bildes an (**Umschalt+→**), wenn die Feder gezogen hat und sich noch nichts bewegt hat.</translation>
    </message>
    <message>
        <source>Set **damping** to 1, pull the foot out and let go. Does it ever stop? Give it 100&#x202f;frames.</source>
        <translation>Setze **Dämpfung** auf 1, zieh den Fuß hinaus und lass los. Bleibt er je stehen? Gib ihm 100&#x202f;Bilder Zeit.</translation>
    </message>
    <message>
        <source>Go back in time, change **damping**, and compare with the ghost.</source>
        <translation>Geh in der Zeit zurück, ändere **Dämpfung** und vergleiche mit dem Geist.</translation>
    </message>
    <message>
        <source>Set the stiffness **k** to 0.02 and carry the body until the foot is 150&#x202f;px behind.</source>
        <translation>Setze die Steifigkeit **k** auf 0,02 und trag den Körper, bis der Fuß 150&#x202f;px zurückliegt.</translation>
    </message>
    <message>
        <source>Let the foot go on the left of the body. Where does it come to rest?</source>
        <translation>Lass den Fuß links vom Körper los. Wo kommt er zur Ruhe?</translation>
    </message>
    <message>
        <source>Carry the body at least 100&#x202f;px. The target goes with it.</source>
        <translation>Trag den Körper mindestens 100&#x202f;px. Das Ziel geht mit.</translation>
    </message>
    <message>
        <source>Set **radius** to 120 and wait until the foot is still.</source>
        <translation>Setze **Radius** auf 120 und warte, bis der Fuß still ist.</translation>
    </message>
    <message>
        <source>Stop inside a frame when the spring has pulled. Find `angle` and `target` in the code.</source>
        <translation>Halte innerhalb eines Bildes an, wenn die Feder gezogen hat. Such `angle` und `target` im Code.</translation>
    </message>
    <message>
        <source>Press **Space**, so that time runs. Take the foot with the mouse, carry it onto the cross, and wait a moment there before you let go.</source>
        <translation>Drück die **Leertaste**, damit die Zeit läuft. Nimm den Fuß mit der Maus, trag ihn auf das Kreuz und warte dort einen Moment, bevor du loslässt.</translation>
    </message>
    <message>
        <source>Press **Space**. Take the foot, move the mouse quickly, and let go on the way. Then hands off until it stands.</source>
        <translation>Drück die **Leertaste**. Nimm den Fuß, bewege die Maus schnell und lass unterwegs los. Dann Hände weg, bis er steht.</translation>
    </message>
    <message>
        <source>Type 1 into the field beside **Damping**. Press **Space**, throw the foot as before, and wait two seconds.</source>
        <translation>Gib 1 in das Feld neben **Dämpfung** ein. Drück die **Leertaste**, wirf den Fuß wie zuvor und warte zwei Sekunden.</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>frame|frames</source>
        <translation>Frame|Bilder|Bildern|jedes Bild|jedem Bild|letzten Bild|pro Bild|einem Bild|Bild für Bild</translation>
    </message>
    <message>
        <source>One picture of the run, and the time from it to the next. 30 of them are shown in a second, unless you choose another speed.</source>
        <translation>Ein Bild (Frame) des Laufs, und die Zeit von ihm bis zum nächsten. In einer Sekunde werden 30 gezeigt, es sei denn, du wählst ein anderes Tempo.</translation>
    </message>
    <message>
        <source>Velocity</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>velocity|velocities</source>
        <translation>Geschwindigkeit|Geschwindigkeiten</translation>
    </message>
    <message>
        <source>How far something goes in a frame, and which way: one number for x and one for y, in pixels per frame.</source>
        <translation>Wie weit etwas in einem Bild kommt, und in welche Richtung: eine Zahl für x und eine für y, in Pixel pro Bild.</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>The share of its velocity that a thing keeps each frame. At 0.9 a tenth of it is gone after one frame. At 1 nothing is.</source>
        <translation>Der Anteil seiner Geschwindigkeit, den etwas in jedem Bild behält. Bei 0,9 ist nach einem Bild ein Zehntel davon weg. Bei 1 nichts.</translation>
    </message>
    <message>
        <source>Why does a throw of 10&#x2009;px glide 90&#x2009;px?</source>
        <translation>Warum gleitet ein Wurf von 10&#x2009;px ganze 90&#x2009;px?</translation>
    </message>
    <message>
        <source>Each frame keeps 0.9 of the velocity, so the ways get shorter:

`9 + 8.1 + 7.29 + …`

Every number is 0.9 times the one before. Such a sum never ends, and yet it stays below a limit:

`10 × 0.9 / (1 − 0.9) = 90`

Damping is a share **per frame**. Where a frame is computed in two halves, each half keeps the root of it, so that both together keep 0.9:

`√0.9 × √0.9 = 0.9`

Seen the other way, damping is a **drag**: a push against the motion, and the faster a thing is, the stronger the push.</source>
        <translation>Jedes Bild behält 0,9 der Geschwindigkeit, darum werden die Wege kürzer:

`9 + 8,1 + 7,29 + …`

Jede Zahl ist 0,9-mal die davor. Eine solche Summe endet nie, und doch bleibt sie unter einer Grenze:

`10 × 0,9 / (1 − 0,9) = 90`

Dämpfung ist ein Anteil **pro Bild**. Wo ein Bild in zwei Hälften berechnet wird, behält jede Hälfte die Wurzel davon, sodass beide zusammen 0,9 behalten:

`√0,9 × √0,9 = 0,9`

Anders gesehen ist Dämpfung ein **Widerstand**: Er schiebt gegen die Bewegung, und je schneller etwas ist, desto stärker.</translation>
    </message>
    <message>
        <source>A spring pulls with k times the distance, and what it pulls swings past the middle.</source>
        <translation>Eine Feder zieht mit k mal dem Abstand, und was sie zieht, schwingt über die Mitte hinaus.</translation>
    </message>
    <message>
        <source>Press **Space**. Take the foot far out, let go, and wait until it stands on the cross.</source>
        <translation>Drück die **Leertaste**. Nimm den Fuß weit hinaus, lass los und warte, bis er auf dem Kreuz steht.</translation>
    </message>
    <message>
        <source>Click **Engine** above the code, and stop (**Space**). Then press **Shift+→** once: that is one phase. The spring is the first of them.</source>
        <translation>Klick über dem Code auf **Engine** und halte an (**Leertaste**). Dann drück einmal **Umschalt+→**: Das ist eine Phase. Die Feder ist die erste.</translation>
    </message>
    <message>
        <source>Type 1 into the field beside **Damping**, press **Space**, pull the foot out, let go, and wait some seconds.</source>
        <translation>Gib 1 in das Feld neben **Dämpfung** ein, drück die **Leertaste**, zieh den Fuß hinaus, lass los und warte einige Sekunden.</translation>
    </message>
    <message>
        <source>Play some seconds and stop. Drag the timeline back to the left, change **Damping**, and play on from there. The old run goes on as a dashed ghost.</source>
        <translation>Spiele einige Sekunden ab und halte an. Zieh die Zeitleiste nach links zurück, ändere **Dämpfung** und spiele von dort weiter. Der alte Lauf geht als gestrichelter Geist weiter.</translation>
    </message>
    <message>
        <source>Spring</source>
        <translation>Feder</translation>
    </message>
    <message>
        <source>spring|springs</source>
        <translation>Feder|Federn</translation>
    </message>
    <message>
        <source>Something that pulls together what is too far apart, and pushes apart what is too close. The more is missing, the stronger it pulls.</source>
        <translation>Etwas, das zusammenzieht, was zu weit auseinander ist, und auseinanderdrückt, was zu nah ist. Je mehr fehlt, desto stärker zieht die Feder.</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>stiffness|stiffer</source>
        <translation>Steifigkeit|steifer</translation>
    </message>
    <message>
        <source>How hard a spring pulls for each pixel: the number k. At 0.2 it adds a fifth of the missing distance to the velocity, each frame. Physics calls it the spring constant, too.</source>
        <translation>Wie stark eine Feder für jedes Pixel zieht: die Zahl k. Bei 0,2 fügt sie der Geschwindigkeit in jedem Bild ein Fünftel des fehlenden Abstands hinzu. In der Physik heißt sie auch Federkonstante.</translation>
    </message>
    <message>
        <source>Hooke’s law</source>
        <translation>Das Hooke’sche Gesetz</translation>
    </message>
    <message>
        <source>Twice as far, twice the pull: a spring pulls with k times the distance.</source>
        <translation>Doppelt so weit, doppelter Zug: Eine Feder zieht mit k mal dem Abstand.</translation>
    </message>
    <message>
        <source>Phase</source>
        <translation>Phase</translation>
    </message>
    <message>
        <source>phase|phases</source>
        <translation>Phase|Phasen</translation>
    </message>
    <message>
        <source>A part of a frame: first the springs pull, then damping takes its share, then everything moves. While the code shows its page **Engine**, **Shift+→** goes from one to the next.</source>
        <translation>Ein Teil eines Bildes: Erst ziehen die Federn, dann nimmt die Dämpfung ihren Anteil, dann bewegt sich alles. Solange der Code seine Seite **Engine** zeigt, geht **Umschalt+→** von einer zur nächsten.</translation>
    </message>
    <message>
        <source>Overshoot</source>
        <translation>Überschwingen</translation>
    </message>
    <message>
        <source>overshoots|overshoot</source>
        <translation>schießt er darüber hinaus|schießt darüber hinaus|überschwingen</translation>
    </message>
    <message>
        <source>To go past the place where one wants to be. A swinging foot does so at every swing.</source>
        <translation>Über den Ort hinausgehen, an dem man sein will. Ein schwingender Fuß tut das bei jeder Schwingung.</translation>
    </message>
    <message>
        <source>Ghost</source>
        <translation>Geist</translation>
    </message>
    <message>
        <source>ghost</source>
        <translation>Geist|Geists</translation>
    </message>
    <message>
        <source>The run as it was before you changed something in its past. It is drawn as a dashed outline, and goes along with the new run.</source>
        <translation>Der Lauf, wie er war, bevor du etwas in seiner Vergangenheit geändert hast. Er wird als gestrichelter Umriss gezeichnet und läuft mit dem neuen Lauf mit.</translation>
    </message>
    <message>
        <source>Why twice as far, twice the pull?</source>
        <translation>Warum doppelt so weit, doppelter Zug?</translation>
    </message>
    <message>
        <source>Two springs one after the other share a stretch, and each is stretched by half of it. So a stretch of one px in one spring pulls as much as two px in both. That is what Robert Hooke saw in 1678:

`pull = k × distance`

Here it is added to the velocity once a frame, in x and in y apart:

`vx = vx + k × (cx − x)`

Real springs keep to it as long as they are not bent out of shape.</source>
        <translation>Zwei Federn hintereinander teilen sich eine Dehnung, und jede wird um die Hälfte gedehnt. Eine Dehnung von einem px in einer Feder zieht also so stark wie zwei px in beiden. Das sah Robert Hooke 1678 (pull ist der Zug, distance der Abstand):

`pull = k × distance`

Hier wird er einmal pro Bild zur Geschwindigkeit addiert, in x und in y getrennt:

`vx = vx + k × (cx − x)`

Echte Federn halten sich daran, solange sie nicht überdehnt werden.</translation>
    </message>
    <message>
        <source>A spring reads the place of its other end anew in each frame, so what hangs on it follows.</source>
        <translation>Eine Feder liest den Ort ihres anderen Endes in jedem Bild neu, darum folgt ihm, was an ihr hängt.</translation>
    </message>
    <message>
        <source>Press **Space**. Take the large disc, carry it across the picture, and let go. Wait until the foot has come to rest on it.</source>
        <translation>Drück die **Leertaste**. Nimm die große Scheibe, trag sie quer durch die Szene und lass los. Warte, bis der Fuß auf ihr zur Ruhe gekommen ist.</translation>
    </message>
    <message>
        <source>Type 0.02 into the field beside **k**. Press **Space**, and swing the body quickly from one corner of the picture to the other.</source>
        <translation>Gib 0,02 in das Feld neben **k** ein. Drück die **Leertaste** und schwing den Körper schnell von einer Ecke der Szene zur anderen.</translation>
    </message>
    <message>
        <source>An offset moves the target of a spring to a side, whatever side the foot comes from.</source>
        <translation>Ein Versatz schiebt das Ziel einer Feder zu einer Seite, von welcher Seite der Fuß auch kommt.</translation>
    </message>
    <message>
        <source>Press **Space**. Drag the foot to the left of the body, let go, and wait until it stands.</source>
        <translation>Drück die **Leertaste**. Zieh den Fuß links neben den Körper, lass los und warte, bis er steht.</translation>
    </message>
    <message>
        <source>Type −60 into the field beside **Offset**, press **Space**, and wait.</source>
        <translation>Gib −60 in das Feld neben **Versatz** ein, drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Press **Space**, take the large disc, and carry it across the picture.</source>
        <translation>Drück die **Leertaste**, nimm die große Scheibe und trag sie quer durch die Szene.</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>target|targets</source>
        <translation>Ziel|Ziele|Zielen|Ziels</translation>
    </message>
    <message>
        <source>The place that a spring pulls to. It need not be the middle of something.</source>
        <translation>Der Ort, zu dem eine Feder zieht. Er muss nicht die Mitte von etwas sein.</translation>
    </message>
    <message>
        <source>With an angle the target can be 50&#x2009;px away in any direction: atan2 finds it, cos and sin lead back.</source>
        <translation>Mit einem Winkel kann das Ziel 50&#x2009;px weit in jeder Richtung liegen: atan2 findet ihn, cos und sin führen zurück.</translation>
    </message>
    <message>
        <source>Press **Space**. Put the foot just to the left of the body, hold it still for a moment, and let go.</source>
        <translation>Drück die **Leertaste**. Setze den Fuß knapp links neben den Körper, halte ihn einen Moment still und lass los.</translation>
    </message>
    <message>
        <source>Press **Space**. Hold the foot straight below the body, with the mouse button down. The angle is written beside the arc.</source>
        <translation>Drück die **Leertaste**. Halte den Fuß gerade unter den Körper, mit gedrückter Maustaste. Der Winkel steht neben dem Bogen.</translation>
    </message>
    <message>
        <source>Type 120 into the field beside **Radius**, press **Space**, and wait.</source>
        <translation>Gib 120 in das Feld neben **Radius** ein, drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Stop with **Space**, and press **Shift+→** once. The code shows what each line has found.</source>
        <translation>Halte mit der **Leertaste** an und drück einmal **Umschalt+→**. Der Code zeigt, was jede Zeile gefunden hat.</translation>
    </message>
    <message>
        <source>Rest length</source>
        <translation>Ruhelänge</translation>
    </message>
    <message>
        <source>rest length|radius</source>
        <translation>Ruhelänge|Radius</translation>
    </message>
    <message>
        <source>The length at which a spring does nothing. A longer one pulls its ends together, a shorter one pushes them apart. In these lessons it is called radius.</source>
        <translation>Die Länge, bei der eine Feder nichts tut. Eine längere zieht ihre Enden zusammen, eine kürzere drückt sie auseinander. In diesen Lektionen heißt sie Radius.</translation>
    </message>
    <message>
        <source>Radian</source>
        <translation>Radiant</translation>
    </message>
    <message>
        <source>radian|radians</source>
        <translation>Radiant</translation>
    </message>
    <message>
        <source>A way to count angles: the length of the arc, divided by its radius. A full turn is 2π, 6.2832&#x2009;rad; one rad is 57.2958°.</source>
        <translation>Eine Art, Winkel zu zählen: die Länge des Bogens, geteilt durch seinen Radius. Eine volle Drehung ist 2π, 6,2832&#x2009;rad; ein rad ist 57,2958°.</translation>
    </message>
    <message>
        <source>atan2</source>
        <translation>atan2</translation>
    </message>
    <message>
        <source>Makes an angle of the two numbers of a direction: `atan2(dy, dx)`. For (0, 0) it gives 0.</source>
        <translation>Macht aus den zwei Zahlen einer Richtung einen Winkel: `atan2(dy, dx)`. Für (0, 0) ergibt es 0.</translation>
    </message>
    <message>
        <source>Why atan2, and not a division?</source>
        <translation>Warum atan2 und nicht einfach teilen?</translation>
    </message>
    <message>
        <source>How steep a way is, is a division:

`steepness = dy / dx`

But it cannot tell a way from its opposite: −2 / −1 is the same as 2 / 1. And straight up, dx is 0, and nothing can be divided by that.

`atan2(dy, dx)`

gets both numbers, so it sees their signs. It knows all four quarters of a turn, from −π to π, and straight up and down as well.

`atan2(2, 1) = 1.107&#x2009;rad`

`atan2(−2, −1) = −2.034&#x2009;rad`</source>
        <translation>Wie steil ein Weg ist, ergibt sich durch Teilen (steepness ist die Steilheit):

`steepness = dy / dx`

Aber das kann einen Weg nicht von seinem Gegenteil unterscheiden: −2 / −1 ist dasselbe wie 2 / 1. Und gerade nach oben ist dx 0, und durch 0 lässt sich nichts teilen.

`atan2(dy, dx)`

bekommt beide Zahlen, sieht also ihre Vorzeichen. Es kennt alle vier Viertel einer Drehung, von −π bis π, und auch gerade nach oben und unten.

`atan2(2, 1) = 1.107&#x2009;rad`

`atan2(−2, −1) = −2.034&#x2009;rad`</translation>
    </message>
    <message>
        <source>let go so that it moves: it stands still.</source>
        <translation>lass so los, dass er sich bewegt: Er steht still.</translation>
    </message>
    <message>
        <source>hold it still for a moment before you let go. Yours left at %1&#x202f;px per frame.</source>
        <translation>halte ihn einen Moment still, bevor du loslässt. Losgelassen wurde bei %1&#x202f;px pro Bild.</translation>
    </message>
    <message>
        <source>let go within 15&#x202f;px of the cross. Yours lies %1&#x202f;px from it.</source>
        <translation>lass höchstens 15&#x202f;px vom Kreuz entfernt los. Er liegt %1&#x202f;px davon.</translation>
    </message>
    <message>
        <source>Throw it: let go while the mouse moves at 5&#x202f;px per frame or more. It glides and stops.</source>
        <translation>Wirf ihn: Lass los, während sich die Maus mit 5&#x202f;px pro Bild oder mehr bewegt. Er gleitet und bleibt stehen.</translation>
    </message>
    <message>
        <source>let it glide for 60&#x202f;frames with this damping. So far: %1.</source>
        <translation>lass ihn mit dieser Dämpfung 60&#x202f;Bilder lang gleiten. Bisher: %1.</translation>
    </message>
    <message>
        <source>No. Nothing takes a share of its velocity, so it keeps all of it and glides on for ever.</source>
        <translation>Nein. Nichts nimmt einen Teil seiner Geschwindigkeit, also behält er sie ganz und gleitet für immer weiter.</translation>
    </message>
    <message>
        <source>let go at least 100&#x202f;px from the cross. Yours left %1&#x202f;px from it.</source>
        <translation>lass mindestens 100&#x202f;px vom Kreuz entfernt los. Es waren %1&#x202f;px.</translation>
    </message>
    <message>
        <source>let it swing for 100&#x202f;frames with this damping. So far: %1.</source>
        <translation>lass ihn mit dieser Dämpfung 100&#x202f;Bilder lang schwingen. Bisher: %1.</translation>
    </message>
    <message>
        <source>No. Nothing takes a share of its velocity, so it swings as wide as at first, for ever.</source>
        <translation>Nein. Nichts nimmt einen Teil seiner Geschwindigkeit, also schwingt er für immer so weit wie am Anfang.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until the foot lies still on the body.</source>
        <translation>lass die Zeit laufen (**Leertaste**), bis der Fuß still auf dem Körper liegt.</translation>
    </message>
    <message>
        <source>carry it farther or faster. The foot is %1&#x202f;px behind.</source>
        <translation>trag ihn weiter oder schneller. Der Fuß ist %1&#x202f;px dahinter.</translation>
    </message>
    <message>
        <source>Throw the foot (at 5&#x202f;px per frame or more), and stop inside a frame when the spring has pulled it and it has not moved.</source>
        <translation>Wirf den Fuß (mit 5&#x202f;px pro Bild oder mehr) und halte innerhalb eines Bildes an, wenn die Feder ihn gezogen hat und er sich noch nicht bewegt hat.</translation>
    </message>
    <message>
        <source>let go on the left of the body.</source>
        <translation>lass links vom Körper los.</translation>
    </message>
    <message>
        <source>On the right, on the cross: the offset is added to the x of the body, wherever the foot comes from.</source>
        <translation>Rechts, auf dem Kreuz: Der Versatz wird zum x des Körpers addiert, woher der Fuß auch kommt.</translation>
    </message>
    <message>
        <source>Set **offset** to −10 or less, and wait until the foot is still.</source>
        <translation>Setze **Versatz** auf −10 oder weniger und warte, bis der Fuß still ist.</translation>
    </message>
    <message>
        <source>set **offset** to −10 or less. It is %1.</source>
        <translation>setze **Versatz** auf −10 oder weniger. Er ist %1.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until the foot lies still on the cross.</source>
        <translation>lass die Zeit laufen (**Leertaste**), bis der Fuß still auf dem Kreuz liegt.</translation>
    </message>
    <message>
        <source>Let the foot go close by on the left of the body, so that it comes to rest there, at least 20&#x202f;px to the left.</source>
        <translation>Lass den Fuß dicht links vom Körper los, sodass er dort zur Ruhe kommt, mindestens 20&#x202f;px links.</translation>
    </message>
    <message>
        <source>let go closer to the body, on its left: the foot came to rest elsewhere.</source>
        <translation>lass näher am Körper los, links von ihm: Der Fuß kam anderswo zur Ruhe.</translation>
    </message>
    <message>
        <source>hold it straight below the body. It is off by %1°.</source>
        <translation>halte ihn gerade unter den Körper. Es fehlen %1°.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until the foot is still on the ring.</source>
        <translation>lass die Zeit laufen (**Leertaste**), bis der Fuß still auf dem Ring ist.</translation>
    </message>
    <message>
        <source>This dot is a **foot**. Its place is two numbers: **x** pixels (px) to the right, **y** pixels down. Its **velocity** is two numbers as well: how far it goes in x and in y from one picture, a **frame**, to the next.

While you hold the foot, its velocity is how far your hand moved in the last frame. When you let go it keeps that. So **a moving hand throws it**.

**Damping** is the share of its velocity that it keeps each frame. At 0.9 a throw of 10&#x202f;px per frame glides 90&#x202f;px and stops.

The arrow is the pull that a spring to the cross would have. It does not act yet: that is the next step.</source>
        <translation>Dieser Punkt ist ein **Fuß**. Sein Ort sind zwei Zahlen: **x** Pixel (px) nach rechts, **y** Pixel nach unten. Auch seine **Geschwindigkeit** sind zwei Zahlen: wie weit er in x und in y von einem Bild (**Frame**) zum nächsten geht.

Solange du den Fuß hältst, ist seine Geschwindigkeit so groß wie der Weg deiner Hand im letzten Bild. Wenn du loslässt, behält er sie. Also **wirft ihn eine Hand, die sich bewegt**.

**Dämpfung** ist der Anteil seiner Geschwindigkeit, den er in jedem Bild behält. Bei 0,9 gleitet ein Wurf von 10&#x202f;px pro Bild 90&#x202f;px weit und bleibt stehen.

Der Pfeil ist der Zug, den eine Feder zum Kreuz hätte. Er wirkt noch nicht: Das ist der nächste Schritt.</translation>
    </message>
    <message>
        <source>A place and a velocity are two numbers each, and damping is the share of the velocity that is kept in every frame.</source>
        <translation>Ort und Geschwindigkeit sind je zwei Zahlen, und die Dämpfung ist der Anteil der Geschwindigkeit, der in jedem Bild bleibt.</translation>
    </message>
    <message>
        <source>Carry the body at least 100&#x202f;px away, and wait until the foot lies on it.</source>
        <translation>Trag den Körper mindestens 100&#x202f;px weg und warte, bis der Fuß auf ihm liegt.</translation>
    </message>
    <message>
        <source>Hold the foot straight below the body, to within 5°. What is the angle in radians?</source>
        <translation>Halte den Fuß gerade unter den Körper, bis auf 5°. Wie groß ist der Winkel in Radiant?</translation>
    </message>
    <message>
        <source>1.57&#x202f;rad: π / 2, a quarter of a turn. y points down, so the angle of what is below is positive.</source>
        <translation>1,57&#x202f;rad: π / 2, eine Vierteldrehung. y zeigt nach unten, also ist der Winkel für unten positiv.</translation>
    </message>
    <message>
        <source>Carry the foot to within 15&#x202f;px of the cross, hold it still, and let go. Nothing pulls it: it stays.</source>
        <translation>Trag den Fuß bis auf 15&#x202f;px an das Kreuz heran, halte ihn still und lass los. Nichts zieht an ihm: Er bleibt.</translation>
    </message>
    <message>
        <source>Press **Home**, then **Space**, throw the foot, and stop with **Space** while it flies. Then press **Shift+→** once.</source>
        <translation>Drück **Pos1**, dann die **Leertaste**, wirf den Fuß und halte mit der **Leertaste** an, während er fliegt. Dann drück einmal **Umschalt+→**.</translation>
    </message>
    <message>
        <source>hold it still there for a moment.</source>
        <translation>halte ihn dort einen Moment lang still.</translation>
    </message>
    <message>
        <source>the throw</source>
        <translation>der Wurf</translation>
    </message>
    <message>
        <source>Write what the foot does **while you hold it**: it goes where your hand is. Its velocity is how far the hand moved in this frame.</source>
        <translation>Schreibe, was der Fuß tut, **während du ihn hältst**: Er geht dorthin, wo deine Hand ist. Seine Geschwindigkeit ist, wie weit sich die Hand in diesem Bild bewegt hat.</translation>
    </message>
    <message>
        <source>The foot is held: set its velocity and its position.</source>
        <translation>Der Fuß ist in der Hand: Setze seine Geschwindigkeit und seinen Ort.</translation>
    </message>
    <message>
        <source>The foot is still where the hand was in the last frame. Now the hand is at `hand`. The velocity is the difference.</source>
        <translation>Der Fuß ist noch dort, wo die Hand im letzten Bild war. Jetzt ist die Hand bei `hand`. Die Geschwindigkeit ist der Unterschied.</translation>
    </message>
    <message>
        <source>Two lines: first the velocity, then the position. After the move the difference would be 0.</source>
        <translation>Zwei Zeilen: erst die Geschwindigkeit, dann der Ort. Nach der Bewegung wäre der Unterschied 0.</translation>
    </message>
    <message>
        <source>`foot.velocity = hand - …;` and then `foot.position = …;`</source>
        <translation>`foot.velocity = hand - …;` und dann `foot.position = …;`</translation>
    </message>
    <message>
        <source>The velocity points backwards: from the hand to where the foot was. It flies away from your throw.</source>
        <translation>Die Geschwindigkeit zeigt rückwärts: von der Hand dorthin, wo der Fuß war. Er fliegt gegen deinen Wurf davon.</translation>
    </message>
    <message>
        <source>With `+=` the velocity grows in each frame that you hold the foot. Set it with `=`.</source>
        <translation>Mit `+=` wächst die Geschwindigkeit in jedem Bild, in dem du den Fuß hältst. Setze sie mit `=`.</translation>
    </message>
    <message>
        <source>the pull of the spring</source>
        <translation>der Zug der Feder</translation>
    </message>
    <message>
        <source>Write the **pull of the spring**: add **k** times the missing distance to the foot’s velocity.</source>
        <translation>Schreibe den **Zug der Feder**: Addiere **k** mal den fehlenden Abstand zur Geschwindigkeit des Fußes.</translation>
    </message>
    <message>
        <source>The spring pulls the foot towards the centre.</source>
        <translation>Die Feder zieht den Fuß zur Mitte.</translation>
    </message>
    <message>
        <source>The missing distance is a vector that points from the foot to the centre.</source>
        <translation>Der fehlende Abstand ist ein Vektor, der vom Fuß zur Mitte zeigt.</translation>
    </message>
    <message>
        <source>A difference of two places points from the second to the first: `a - b` leads from b to a.</source>
        <translation>Die Differenz zweier Orte zeigt vom zweiten zum ersten: `a - b` führt von b nach a.</translation>
    </message>
    <message>
        <source>`foot.velocity += k * (… - …);` with `centre` and `foot.position`.</source>
        <translation>`foot.velocity += k * (… - …);` mit `centre` und `foot.position`.</translation>
    </message>
    <message>
        <source>The pull points away from the centre. Swap the two places of the difference.</source>
        <translation>Der Zug zeigt von der Mitte weg. Vertausche die zwei Orte der Differenz.</translation>
    </message>
    <message>
        <source>With `=` the foot forgets the velocity that it had, so it never swings. The pull is added with `+=`.</source>
        <translation>Mit `=` vergisst der Fuß die Geschwindigkeit, die er hatte, und schwingt nie. Der Zug wird mit `+=` addiert.</translation>
    </message>
    <message>
        <source>The direction is right, but the pull is the whole distance. Multiply it by `k`.</source>
        <translation>Die Richtung stimmt, aber der Zug ist der ganze Abstand. Multipliziere ihn mit `k`.</translation>
    </message>
    <message>
        <source>This moves the foot by the pull. A pull changes the velocity, and the velocity moves the foot.</source>
        <translation>Das bewegt den Fuß um den Zug. Ein Zug ändert die Geschwindigkeit, und die Geschwindigkeit bewegt den Fuß.</translation>
    </message>
    <message>
        <source>damping and the move</source>
        <translation>die Dämpfung und die Bewegung</translation>
    </message>
    <message>
        <source>The spring has pulled. Write the **end of the frame**: damping takes its share of the velocity, and then the foot moves.</source>
        <translation>Die Feder hat gezogen. Schreibe das **Ende des Bildes**: Die Dämpfung nimmt ihren Anteil der Geschwindigkeit, und dann bewegt sich der Fuß.</translation>
    </message>
    <message>
        <source>Damping, and then the move.</source>
        <translation>Die Dämpfung, und dann die Bewegung.</translation>
    </message>
    <message>
        <source>After damping, the velocity is `damp` times what it was.</source>
        <translation>Nach der Dämpfung ist die Geschwindigkeit `damp` mal so groß wie vorher.</translation>
    </message>
    <message>
        <source>A velocity is the distance for one frame, so the move adds the velocity to the position.</source>
        <translation>Die Geschwindigkeit ist der Weg in einem Bild. Die Bewegung addiert also die Geschwindigkeit zum Ort.</translation>
    </message>
    <message>
        <source>`foot.velocity *= …;` and then `foot.position += …;`</source>
        <translation>`foot.velocity *= …;` und dann `foot.position += …;`</translation>
    </message>
    <message>
        <source>The foot moves before damping takes its share. It should move by the damped velocity: swap the two lines.</source>
        <translation>Der Fuß bewegt sich, bevor die Dämpfung ihren Anteil nimmt. Er soll sich mit der gedämpften Geschwindigkeit bewegen: Vertausche die zwei Zeilen.</translation>
    </message>
    <message>
        <source>The foot moves, but nothing takes speed away. Damping is missing.</source>
        <translation>Der Fuß bewegt sich, aber nichts macht ihn langsamer. Die Dämpfung fehlt.</translation>
    </message>
    <message>
        <source>`damp` is the share that the foot keeps, not the share that it loses.</source>
        <translation>`damp` ist der Anteil, den der Fuß behält, nicht der Anteil, den er verliert.</translation>
    </message>
    <message>
        <source>The foot moves by the damped velocity, but keeps the undamped one for the next frame. Change `foot.velocity` itself.</source>
        <translation>Der Fuß bewegt sich mit der gedämpften Geschwindigkeit, behält aber die ungedämpfte für das nächste Bild. Ändere `foot.velocity` selbst.</translation>
    </message>
    <message>
        <source>the target with an offset</source>
        <translation>das Ziel mit einem Versatz</translation>
    </message>
    <message>
        <source>Write the **target** of the spring: the place **offset** px to the right of the body.</source>
        <translation>Schreibe das **Ziel** der Feder: den Ort, der **Versatz** px rechts vom Körper ist.</translation>
    </message>
    <message>
        <source>Vec2 target: the place where the spring ends.</source>
        <translation>Vec2 target: der Ort, an dem die Feder endet.</translation>
    </message>
    <message>
        <source>Begin with the position of the body. Right means a larger x. y stays.</source>
        <translation>Beginne mit dem Ort des Körpers. Rechts heißt: ein größeres x. y bleibt.</translation>
    </message>
    <message>
        <source>`Vec2 target = …;` makes a variable. You can change its `x` afterwards.</source>
        <translation>`Vec2 target = …;` macht eine Variable. Danach kannst du ihr `x` ändern.</translation>
    </message>
    <message>
        <source>`Vec2 target = body.position;` and then `target.x += …;`</source>
        <translation>`Vec2 target = body.position;` und dann `target.x += …;`</translation>
    </message>
    <message>
        <source>The target is on the left of the body. x grows to the right.</source>
        <translation>Das Ziel ist links vom Körper. x wächst nach rechts.</translation>
    </message>
    <message>
        <source>The target is below the body: y points down. Change its x.</source>
        <translation>Das Ziel ist unter dem Körper: y zeigt nach unten. Ändere sein x.</translation>
    </message>
    <message>
        <source>The target is on the body itself. Add the offset.</source>
        <translation>Das Ziel ist auf dem Körper selbst. Addiere den Versatz.</translation>
    </message>
    <message>
        <source>The target moves along with the foot, so the foot never gets there. Begin with the position of the body.</source>
        <translation>Das Ziel bewegt sich mit dem Fuß mit, darum kommt der Fuß nie an. Beginne mit dem Ort des Körpers.</translation>
    </message>
    <message>
        <source>the target in any direction</source>
        <translation>das Ziel in jeder Richtung</translation>
    </message>
    <message>
        <source>Write the **target in any direction**: the place at the distance **radius** from the body, in the direction in which the foot is.</source>
        <translation>Schreibe das **Ziel in jeder Richtung**: den Ort im Abstand **Radius** vom Körper, in der Richtung, in der der Fuß ist.</translation>
    </message>
    <message>
        <source>Vec2 target: the nearest place on the ring.</source>
        <translation>Vec2 target: der nächste Ort auf dem Ring.</translation>
    </message>
    <message>
        <source>First find the direction: the vector from the body to the foot. `atan2` makes an angle of its y and its x.</source>
        <translation>Finde zuerst die Richtung: den Vektor vom Körper zum Fuß. `atan2` macht aus seinem y und seinem x einen Winkel.</translation>
    </message>
    <message>
        <source>`Vec2(cos(angle), sin(angle))` is a step of 1&#x202f;px at that angle. Make it `radius` times as long, and start at the body.</source>
        <translation>`Vec2(cos(angle), sin(angle))` ist ein Schritt von 1 px in diesem Winkel. Mach ihn `radius` mal so lang und beginne beim Körper.</translation>
    </message>
    <message>
        <source>`Vec2 from = foot.position - body.position;`

`double angle = atan2(from.y, from.x);`

`Vec2 target = body.position + radius * …;`</source>
        <translation>`Vec2 from = foot.position - body.position;`

`double angle = atan2(from.y, from.x);`

`Vec2 target = body.position + radius * …;`</translation>
    </message>
    <message>
        <source>The target is on the other side of the body. The direction has to lead from the body to the foot.</source>
        <translation>Das Ziel ist auf der anderen Seite des Körpers. Die Richtung muss vom Körper zum Fuß führen.</translation>
    </message>
    <message>
        <source>The ring is around the top left corner of the picture. Add the position of the body.</source>
        <translation>Der Ring liegt um die linke obere Ecke des Bildes. Addiere den Ort des Körpers.</translation>
    </message>
    <message>
        <source>The target is on the body itself. It should be `radius` px away from it.</source>
        <translation>Das Ziel ist auf dem Körper selbst. Es soll `radius` px von ihm entfernt sein.</translation>
    </message>
    <message>
        <source>the whole frame</source>
        <translation>das ganze Bild</translation>
    </message>
    <message>
        <source>**From the empty page:** write the whole frame. You can carry the body. You can carry and throw the foot, and its spring ends on the ring around the body.</source>
        <translation>**Von der leeren Seite:** Schreibe das ganze Bild. Den Körper kannst du tragen. Den Fuß kannst du tragen und werfen, und seine Feder endet auf dem Ring um den Körper.</translation>
    </message>
    <message>
        <source>Write the whole frame. The names: body, foot (each with position, velocity and held), hand, k, damp, radius.</source>
        <translation>Schreibe das ganze Bild. Die Namen: body, foot (jeweils mit position, velocity und held), hand, k, damp, radius.</translation>
    </message>
    <message>
        <source>Begin with the hand: `if (body.held)` the body goes to the hand. `if (foot.held)` the foot does too, and its velocity is how far the hand moved. What comes then happens only if the foot is not held.</source>
        <translation>Beginne mit der Hand: `if (body.held)`, dann geht der Körper zur Hand. `if (foot.held)`, dann geht auch der Fuß dorthin, und seine Geschwindigkeit ist, wie weit sich die Hand bewegt hat. Was danach kommt, geschieht nur, wenn der Fuß nicht gehalten wird.</translation>
    </message>
    <message>
        <source>In `else`: find the target on the ring, add the pull to the velocity, damp the velocity, and move the foot.</source>
        <translation>In `else`: Finde das Ziel auf dem Ring, addiere den Zug zur Geschwindigkeit, dämpfe die Geschwindigkeit und bewege den Fuß.</translation>
    </message>
    <message>
        <source>The target: `body.position + radius * Vec2(cos(angle), sin(angle))`, with the angle of `foot.position - body.position`. The pull: `k * (target - foot.position)`.</source>
        <translation>Das Ziel: `body.position + radius * Vec2(cos(angle), sin(angle))`, mit dem Winkel von `foot.position - body.position`. Der Zug: `k * (target - foot.position)`.</translation>
    </message>
    <message>
        <source>The rest is right, but the foot cannot be thrown: while you hold it, its velocity has to be how far the hand moved.</source>
        <translation>Der Rest stimmt, aber der Fuß lässt sich nicht werfen: Während du ihn hältst, muss seine Geschwindigkeit sein, wie weit sich die Hand bewegt hat.</translation>
    </message>
    <message>
        <source>The rest is right, but the target is on the other side of the body.</source>
        <translation>Der Rest stimmt, aber das Ziel ist auf der anderen Seite des Körpers.</translation>
    </message>
    <message>
        <source>The rest is right, but the target is on the body itself. It should be `radius` px away from it.</source>
        <translation>Der Rest stimmt, aber das Ziel ist auf dem Körper selbst. Es soll `radius` px von ihm entfernt sein.</translation>
    </message>
    <message>
        <source>The foot has no velocity when you let go, so you cannot throw it. Take the difference before the foot moves.</source>
        <translation>Der Fuß hat keine Geschwindigkeit, wenn du loslässt, darum kannst du ihn nicht werfen. Nimm den Unterschied, bevor sich der Fuß bewegt.</translation>
    </message>
    <message>
        <source>x and y are swapped: `atan2` takes y first, and `cos` belongs to x.</source>
        <translation>x und y sind vertauscht: `atan2` nimmt zuerst y, und `cos` gehört zu x.</translation>
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
