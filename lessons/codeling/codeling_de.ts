<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Codeling</name>
    <message>
        <source>motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Way to the target</source>
        <translation>Weg zum Ziel</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>It grows before a move: that is the anticipation.</source>
        <translation>Vor einer Bewegung wächst er: Das ist das Ausholen.</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Streckung</translation>
    </message>
    <message>
        <source>How long the spine is, as a part of its length at rest.</source>
        <translation>Wie lang das Rückgrat ist, als Anteil seiner Länge in Ruhe.</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>The area of the body, as a part of its area at rest.</source>
        <translation>Die Fläche des Körpers, als Anteil seiner Fläche in Ruhe.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Erhalt</translation>
    </message>
    <message>
        <source>per frame</source>
        <translation>pro Bild</translation>
    </message>
    <message>
        <source>The share of its speed that the lead keeps each frame.</source>
        <translation>Der Anteil ihres Tempos, den die Spitze in jedem Bild behält.</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>How hard the motor pulls: this times the way to the target.</source>
        <translation>Wie stark der Motor zieht: so viel mal der Weg zum Ziel.</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitmaß</translation>
    </message>
    <message>
        <source>How much of its own time passes in a frame: the pull counts dt × dt.</source>
        <translation>Wie viel seiner eigenen Zeit in einem Bild vergeht: Der Zug zählt dt × dt.</translation>
    </message>
    <message>
        <source>Target x</source>
        <translation>Ziel x</translation>
    </message>
    <message>
        <source>How far to the right the first target is.</source>
        <translation>Wie weit rechts das erste Ziel ist.</translation>
    </message>
    <message>
        <source>Target y</source>
        <translation>Ziel y</translation>
    </message>
    <message>
        <source>How far down the first target is.</source>
        <translation>Wie weit unten das erste Ziel ist.</translation>
    </message>
    <message>
        <source>Rest length</source>
        <translation>Ruhelänge</translation>
    </message>
    <message>
        <source>How far the tail is from the lead at rest.</source>
        <translation>Wie weit der Schwanz in Ruhe von der Spitze entfernt ist.</translation>
    </message>
    <message>
        <source>Anticipation</source>
        <translation>Ausholen</translation>
    </message>
    <message>
        <source>How far it backs up before a move, as a part of the way to the target.</source>
        <translation>Wie weit es vor einer Bewegung zurückweicht, als Anteil des Wegs zum Ziel.</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>The part of the spine’s error that goes each frame.</source>
        <translation>Der Teil des Fehlers des Rückgrats, der in jedem Bild verschwindet.</translation>
    </message>
    <message>
        <source>Hard</source>
        <translation>Hart</translation>
    </message>
    <message>
        <source>The same, when the spine is shorter than least or longer than most.</source>
        <translation>Dasselbe, wenn das Rückgrat kürzer als die kleinste oder länger als die größte Länge ist.</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Längs</translation>
    </message>
    <message>
        <source>The share of the tail’s speed along the spine that it keeps.</source>
        <translation>Der Anteil des Schwanztempos längs zum Rückgrat, den er behält.</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Quer</translation>
    </message>
    <message>
        <source>The share of the tail’s speed across the spine that it keeps.</source>
        <translation>Der Anteil des Schwanztempos quer zum Rückgrat, den er behält.</translation>
    </message>
    <message>
        <source>Least length</source>
        <translation>Kleinste Länge</translation>
    </message>
    <message>
        <source>Shorter than this, the spine pushes hard.</source>
        <translation>Ist es kürzer, schiebt das Rückgrat hart.</translation>
    </message>
    <message>
        <source>Most length</source>
        <translation>Größte Länge</translation>
    </message>
    <message>
        <source>Longer than this, the spine pulls hard.</source>
        <translation>Ist es länger, zieht das Rückgrat hart.</translation>
    </message>
    <message>
        <source>Tentacles</source>
        <translation>Tentakel</translation>
    </message>
    <message>
        <source>How many tentacles it has.</source>
        <translation>Wie viele Tentakel es hat.</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Glieder</translation>
    </message>
    <message>
        <source>How many links each tentacle has.</source>
        <translation>Wie viele Glieder jeder Tentakel hat.</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>The share of its speed that a tentacle keeps each frame. Less: thicker water.</source>
        <translation>Der Anteil seines Tempos, den ein Tentakel in jedem Bild behält. Weniger: zäheres Wasser.</translation>
    </message>
    <message>
        <source>A motor</source>
        <translation>Ein Motor</translation>
    </message>
    <message>
        <source>Click anywhere: this little creature swims there. Its motor is a **spring** from its head, the **lead**, to the target. The pull is k times the way to go, so it starts fast, slows down by itself, and swims a little too far before it turns back.

**keep** is the share of its velocity that it keeps each frame. With 1 it would swing about the target for ever. With 0.7 it is there after a dozen frames.

A frame is a quarter of this creature’s own unit of time: **dt** is 0.25. A pull changes a place by dt × dt, so k = 0.9 does as much as k = 0.056 in the first lessons.</source>
        <translation>Klicke irgendwohin: Dieses kleine Wesen schwimmt dorthin. Sein Motor ist eine **Feder** von seinem Kopf, der **Spitze**, zum Ziel. Der Zug ist k mal der Weg, der noch fehlt; darum startet es schnell, wird von selbst langsamer und schwimmt ein wenig zu weit, bevor es umkehrt.

**Erhalt** ist der Anteil seiner Geschwindigkeit, den es in jedem Bild behält. Mit 1 würde es ewig um das Ziel schwingen. Mit 0,7 ist es nach einem Dutzend Bildern da.

Ein Bild ist ein Viertel der eigenen Zeiteinheit dieses Wesens: **dt** ist 0,25. Ein Zug ändert einen Ort um dt × dt, darum bewirkt k = 0,9 so viel wie k = 0,056 in den ersten Lektionen.</translation>
    </message>
    <message>
        <source>Which way it looks</source>
        <translation>Wohin es schaut</translation>
    </message>
    <message>
        <source>A dot has no front. So give it a second point, the **tail**, tied to the lead by a rigid stick of 40&#x202f;px.

This stick is **one-sided**: the lead takes nothing of the error, the tail takes it all. The motor does not even know that there is a tail. And the tail has no velocity of its own: it is pulled along behind, wherever the lead goes.

That is enough for a direction: from tail to lead is the way that it looks. When it is sent to the side, it turns there in a smooth curve. When it is sent straight back, it pushes its tail ahead of it for a while: the stick knows a length, not a front.

In each frame the lead moves first. The tail follows in the same frame.</source>
        <translation>Ein Punkt hat kein Vorn. Gib ihm also einen zweiten Punkt, den **Schwanz**, mit einem starren Stab von 40&#x202f;px an die Spitze gebunden.

Dieser Stab ist **einseitig**: Die Spitze übernimmt nichts vom Fehler, der Schwanz alles. Der Motor weiß nicht einmal, dass es einen Schwanz gibt. Und der Schwanz hat keine eigene Geschwindigkeit: Er wird hinterhergezogen, wohin die Spitze auch geht.

Das genügt für eine Richtung: Vom Schwanz zur Spitze, dorthin schaut es. Wird es zur Seite geschickt, dreht es sich in einer sanften Kurve. Wird es geradewegs zurückgeschickt, schiebt es seinen Schwanz eine Weile vor sich her: Der Stab kennt eine Länge, kein Vorn.

In jedem Bild bewegt sich zuerst die Spitze. Der Schwanz folgt im selben Bild.</translation>
    </message>
    <message>
        <source>Squash and stretch</source>
        <translation>Stauchen, Strecken</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Set **keep** to 1 and click somewhere else. After 100&#x202f;frames it still swings.</source>
        <translation>Setze **Erhalt** auf 1 und klicke woandershin. Nach 100&#x202f;Bildern schwingt es immer noch.</translation>
    </message>
    <message>
        <source>Send it to places so that it turns round: the tail at least 30&#x202f;px to the right of the lead.</source>
        <translation>Schicke es so umher, dass es sich umdreht: den Schwanz mindestens 30&#x202f;px rechts von der Spitze.</translation>
    </message>
    <message>
        <source>Stop inside a frame when the lead has moved, and the tail is 5&#x202f;px too far away.</source>
        <translation>Halte innerhalb eines Bildes an, wenn die Spitze sich bewegt hat und der Schwanz 5&#x202f;px zu weit weg ist.</translation>
    </message>
    <message>
        <source>Set **anticipation** to 0.6 and click far away. It winds up like a spring.</source>
        <translation>Setze **Ausholen** auf 0,6 und klicke weit weg. Es spannt sich wie eine Feder.</translation>
    </message>
    <message>
        <source>Go back in time to before a click, change **anticipation**, and compare with the ghost.</source>
        <translation>Geh in der Zeit vor einen Klick zurück, ändere **Ausholen** und vergleiche mit dem Geist.</translation>
    </message>
    <message>
        <source>Send it so far that its spine gets 55&#x202f;px long.</source>
        <translation>Schicke es so weit, dass sein Rückgrat 55&#x202f;px lang wird.</translation>
    </message>
    <message>
        <source>Send it where it looks, so that it is squashed to 32&#x202f;px before it starts.</source>
        <translation>Schicke es dorthin, wohin es schaut, sodass es vor dem Start auf 32&#x202f;px gestaucht wird.</translation>
    </message>
    <message>
        <source>Go back in time, set **soft** to 1, and compare with the ghost.</source>
        <translation>Geh in der Zeit zurück, setze **Weich** auf 1 und vergleiche mit dem Geist.</translation>
    </message>
    <message>
        <source>Squash it until it is 40&#x202f;px wide.</source>
        <translation>Stauche es, bis es 40&#x202f;px breit ist.</translation>
    </message>
    <message>
        <source>Stretch it until it is only 22&#x202f;px wide.</source>
        <translation>Strecke es, bis es nur noch 22&#x202f;px breit ist.</translation>
    </message>
    <message>
        <source>Pull one side at least 40&#x202f;px out. The other side makes up for it: the area stays.</source>
        <translation>Zieh eine Seite mindestens 40&#x202f;px hinaus. Die andere gleicht es aus: Die Fläche bleibt.</translation>
    </message>
    <message>
        <source>Set **tentacles** to 8, send it somewhere, and wait until it has arrived.</source>
        <translation>Setze **Tentakel** auf 8, schicke es irgendwohin und warte, bis es angekommen ist.</translation>
    </message>
    <message>
        <source>Set **water** to 0.98 and send it to and fro until a tentacle whips at 40&#x202f;px per frame.</source>
        <translation>Setze **Wasser** auf 0,98 und schicke es hin und her, bis ein Tentakel mit 40&#x202f;px pro Bild peitscht.</translation>
    </message>
    <message>
        <source>Go back in time, change **water**, and compare with the ghost.</source>
        <translation>Geh in der Zeit zurück, ändere **Wasser** und vergleiche mit dem Geist.</translation>
    </message>
    <message>
        <source>A spring from the head to a target is a motor: fast at first, slower by itself.</source>
        <translation>Eine Feder vom Kopf zu einem Ziel ist ein Motor: am Anfang schnell, von selbst langsamer.</translation>
    </message>
    <message>
        <source>Press **Space**, and click the background near the edge of the picture. Then wait.</source>
        <translation>Drück die **Leertaste** und klicke nahe am Rand auf den Hintergrund. Warte dann.</translation>
    </message>
    <message>
        <source>Type 1 into the field beside **Keep**. Press **Space**, click the background, and wait four seconds.</source>
        <translation>Gib im Feld neben **Erhalt** 1 ein. Drück die **Leertaste**, klicke auf den Hintergrund und warte vier Sekunden.</translation>
    </message>
    <message>
        <source>Lead</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>the lead</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>The head of the creature. The motor pulls it, and all else follows.</source>
        <translation>Der Kopf des Wesens. Der Motor zieht ihn, und alles andere folgt.</translation>
    </message>
    <message>
        <source>dt</source>
        <translation>dt</translation>
    </message>
    <message>
        <source>How much of its own time passes for a creature in a frame. The smaller it is, the slower everything goes.</source>
        <translation>Wie viel seiner eigenen Zeit für ein Wesen in einem Bild vergeht. Je kleiner es ist, desto langsamer geht alles.</translation>
    </message>
    <message>
        <source>Why dt × dt?</source>
        <translation>Warum dt × dt?</translation>
    </message>
    <message>
        <source>A pull changes the velocity, and the velocity changes the place. In a quarter of the time a pull adds a quarter as much to the velocity:

`v = v + dt × pull`

And that velocity carries the point for a quarter of the time:

`x = x + dt × v`

Both together:

`0.25 × 0.25 = 0.0625`

So the place changes by a sixteenth, and 0.9 does as much as 0.9 / 16, which is 0.056.</source>
        <translation>Ein Zug ändert die Geschwindigkeit, und die Geschwindigkeit ändert den Ort. In einem Viertel der Zeit gibt ein Zug (pull) ein Viertel so viel zur Geschwindigkeit hinzu:

`v = v + dt × pull`

Und diese Geschwindigkeit trägt den Punkt ein Viertel der Zeit lang:

`x = x + dt × v`

Beides zusammen:

`0,25 × 0,25 = 0,0625`

Der Ort ändert sich also um ein Sechzehntel, und 0,9 bewirkt so viel wie 0,9 / 16, das ist 0,056.</translation>
    </message>
    <message>
        <source>A tail on a one-sided stick gives a direction: from tail to lead.</source>
        <translation>Ein Schwanz an einem einseitigen Stab gibt eine Richtung: vom Schwanz zur Spitze.</translation>
    </message>
    <message>
        <source>Press **Space**. Click far up in the picture, and when it is under way, click far to the left.</source>
        <translation>Drück die **Leertaste**. Klicke weit oben in die Szene, und wenn es unterwegs ist, klicke weit links.</translation>
    </message>
    <message>
        <source>Press **Space**. Take the tail, carry it across the picture, let go, and wait.</source>
        <translation>Drück die **Leertaste**. Nimm den Schwanz, trag ihn quer durch die Szene, lass los und warte.</translation>
    </message>
    <message>
        <source>One-sided</source>
        <translation>Einseitig</translation>
    </message>
    <message>
        <source>one-sided</source>
        <translation>einseitig|einseitige|einseitigen|einseitiger</translation>
    </message>
    <message>
        <source>A stick of which one end takes the whole error. The other end feels nothing of it, so it leads.</source>
        <translation>Ein Stab, bei dem ein Ende den ganzen Fehler übernimmt. Das andere Ende spürt nichts davon, also führt es.</translation>
    </message>
    <message>
        <source>A shift away from the target, in the frame of the click, looks like winding up.</source>
        <translation>Eine Verschiebung weg vom Ziel, im Bild des Klicks, sieht aus wie Schwungholen.</translation>
    </message>
    <message>
        <source>Type 0.6 into the field beside **Anticipation**. Press **Space** and click far away.</source>
        <translation>Gib im Feld neben **Ausholen** 0,6 ein. Drück die **Leertaste** und klicke weit weg.</translation>
    </message>
    <message>
        <source>anticipation</source>
        <translation>Ausholen</translation>
    </message>
    <message>
        <source>A small move the other way before a big one. It tells the eye what comes.</source>
        <translation>Eine kleine Bewegung in die Gegenrichtung vor einer großen. Sie sagt dem Auge, was kommt.</translation>
    </message>
    <message>
        <source>A soft stick takes a part of its error each frame, so the body gives way.</source>
        <translation>Ein weicher Stab nimmt in jedem Bild nur einen Teil seines Fehlers, darum gibt der Körper nach.</translation>
    </message>
    <message>
        <source>Press **Space**, and click the background in the corner that is farthest away.</source>
        <translation>Drück die **Leertaste** und klicke in der Ecke, die am weitesten entfernt ist, auf den Hintergrund.</translation>
    </message>
    <message>
        <source>Press **Space**. It looks to the right at the start: click the background far to the right, at the same height.</source>
        <translation>Drück die **Leertaste**. Am Anfang schaut es nach rechts: Klicke weit rechts, auf gleicher Höhe, auf den Hintergrund.</translation>
    </message>
    <message>
        <source>Play, click the background, and stop. Drag the timeline back to the left, type 1 beside **Soft**, and play on for a second.</source>
        <translation>Spiele ab, klicke auf den Hintergrund und halte an. Zieh die Zeitleiste nach links zurück, gib neben **Weich** 1 ein und spiele eine Sekunde weiter.</translation>
    </message>
    <message>
        <source>Soft constraint</source>
        <translation>Weiche Zwangsbedingung</translation>
    </message>
    <message>
        <source>is soft|soft stick|soft and one-sided</source>
        <translation>er ist weich|weicher Stab|weich und einseitig</translation>
    </message>
    <message>
        <source>A constraint that takes only a part of its error each frame. It gives way, and comes back little by little.</source>
        <translation>Eine Zwangsbedingung, die in jedem Bild nur einen Teil ihres Fehlers nimmt. Sie gibt nach und kommt nach und nach zurück.</translation>
    </message>
    <message>
        <source>Animators’ words for a body that gets shorter and wider, or longer and thinner, as it moves. It makes a body look soft and alive.</source>
        <translation>So nennen Trickfilmer es, wenn ein Körper im Bewegen kürzer und breiter wird, oder länger und dünner. Das lässt ihn weich und lebendig aussehen.</translation>
    </message>
    <message>
        <source>If the area must stay, the width follows from the length.</source>
        <translation>Wenn die Fläche bleiben muss, folgt die Breite aus der Länge.</translation>
    </message>
    <message>
        <source>Press **Space**. Take one of the two points at its sides, pull it away from the body, and do not let go.</source>
        <translation>Drück die **Leertaste**. Nimm einen der zwei Punkte an seinen Seiten, zieh ihn vom Körper weg und lass nicht los.</translation>
    </message>
    <message>
        <source>Why 2 × area / spine?</source>
        <translation>Warum 2 × Fläche / Rückgrat?</translation>
    </message>
    <message>
        <source>The spine cuts the shape into two triangles. Each has the spine as its base and half of the width as its height, and the area of a triangle is base × height / 2:

`2 × spine × (width / 2) / 2`

That is

`area = spine × width / 2`

Now ask the other way round. Which width keeps the area?

`width = 2 × area / spine`</source>
        <translation>Das Rückgrat (spine) zerlegt die Form in zwei Dreiecke. Jedes hat das Rückgrat als Grundseite und die halbe Breite (width) als Höhe, und die Fläche (area) eines Dreiecks ist Grundseite × Höhe / 2:

`2 × spine × (width / 2) / 2`

Das heißt

`area = spine × width / 2`

Frag jetzt andersherum. Welche Breite erhält die Fläche?

`width = 2 × area / spine`</translation>
    </message>
    <message>
        <source>A chain of one-sided sticks is right after one pass, because no link disturbs an earlier one.</source>
        <translation>Eine Kette einseitiger Stäbe stimmt nach einem Durchgang, weil kein Glied ein früheres stört.</translation>
    </message>
    <message>
        <source>Type 8 into the field beside **Tentacles**. Press **Space**, click the background, and wait.</source>
        <translation>Gib im Feld neben **Tentakel** 8 ein. Drück die **Leertaste**, klicke auf den Hintergrund und warte.</translation>
    </message>
    <message>
        <source>Type 0.98 into the field beside **Water**. Press **Space**, and click one corner and the opposite one in turn, twice a second.</source>
        <translation>Gib im Feld neben **Wasser** 0,98 ein. Drück die **Leertaste** und klicke abwechselnd in eine Ecke und in die gegenüber, zweimal pro Sekunde.</translation>
    </message>
    <message>
        <source>Play, click the background, and stop. Drag the timeline back to the left, type another **Water**, and play on for a second.</source>
        <translation>Spiele ab, klicke auf den Hintergrund und halte an. Zieh die Zeitleiste nach links zurück, gib ein anderes **Wasser** ein und spiele eine Sekunde weiter.</translation>
    </message>
    <message>
        <source>click the background.</source>
        <translation>klicke auf den Hintergrund.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until it lies still at its target.</source>
        <translation>lass die Zeit laufen (**Leertaste**), bis es still an seinem Ziel liegt.</translation>
    </message>
    <message>
        <source>click farther away: it has to back up at 3&#x202f;px per frame or more. Now: %1.</source>
        <translation>klicke weiter weg: Es muss mit 3&#x202f;px pro Bild oder mehr zurückweichen. Jetzt: %1.</translation>
    </message>
    <message>
        <source>click somewhere else: it stands still.</source>
        <translation>klicke woandershin: Es steht still.</translation>
    </message>
    <message>
        <source>Take the lead in your hand and throw it, at 5&#x202f;px per frame or more. It comes back.</source>
        <translation>Nimm die Spitze in die Hand und wirf sie, mit 5&#x202f;px pro Bild oder mehr. Sie kommt zurück.</translation>
    </message>
    <message>
        <source>send it to the left. The tail is %1&#x202f;px to the right of the lead.</source>
        <translation>schicke es nach links. Der Schwanz ist %1&#x202f;px rechts von der Spitze.</translation>
    </message>
    <message>
        <source>press **Shift+→** until the lead has moved.</source>
        <translation>drück **Umschalt+→**, bis die Spitze sich bewegt hat.</translation>
    </message>
    <message>
        <source>stop while it is fast: click far away first. The tail is %1&#x202f;px too far away.</source>
        <translation>halte an, solange es schnell ist: Klicke zuerst weit weg. Der Schwanz ist %1&#x202f;px zu weit weg.</translation>
    </message>
    <message>
        <source>go back to before a click, and change **anticipation** there.</source>
        <translation>geh vor einen Klick zurück und ändere dort **Ausholen**.</translation>
    </message>
    <message>
        <source>send it farther. Its spine is %1&#x202f;px long.</source>
        <translation>schicke es weiter. Sein Rückgrat ist %1&#x202f;px lang.</translation>
    </message>
    <message>
        <source>send it far away, to where it looks. Its spine is %1&#x202f;px long.</source>
        <translation>schicke es weit weg, dorthin, wohin es schaut. Sein Rückgrat ist %1&#x202f;px lang.</translation>
    </message>
    <message>
        <source>set **soft** to 1 there.</source>
        <translation>setze dort **Weich** auf 1.</translation>
    </message>
    <message>
        <source>send it far away, to where it looks. It is %1&#x202f;px wide.</source>
        <translation>schicke es weit weg, dorthin, wohin es schaut. Es ist %1&#x202f;px breit.</translation>
    </message>
    <message>
        <source>send it farther. It is %1&#x202f;px wide.</source>
        <translation>schicke es weiter. Es ist %1&#x202f;px breit.</translation>
    </message>
    <message>
        <source>hold it still until the area is right again.</source>
        <translation>halte sie still, bis die Fläche wieder stimmt.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until it has arrived.</source>
        <translation>lass die Zeit laufen (**Leertaste**), bis es angekommen ist.</translation>
    </message>
    <message>
        <source>send it to and fro, farther and faster. The fastest tip moves at %1&#x202f;px per frame.</source>
        <translation>schicke es weiter und schneller hin und her. Die schnellste Spitze bewegt sich mit %1&#x202f;px pro Bild.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>How far apart the two sides are.</source>
        <translation>Wie weit die beiden Seiten auseinander sind.</translation>
    </message>
    <message>
        <source>Before you jump, you crouch. Animators call that **anticipation**: a small move the other way tells the eye that a big one is coming.

When you click, the lead is shifted **away from the target** by a part of the way, 0.2 of it.

Its place before that frame stays what it was. The velocity is the way that it came, so the shift is also a push: it goes on backing up, slower and slower, until the motor has turned it round. A longer way gives a bigger shift, with no number to be set for it.

Two clicks in one frame shift it twice.</source>
        <translation>Bevor du springst, gehst du in die Hocke. Trickfilmer nennen das **Ausholen**: Eine kleine Bewegung in die Gegenrichtung sagt dem Auge, dass eine große kommt.

Wenn du klickst, wird die Spitze **vom Ziel weg** verschoben, um einen Teil des Wegs, 0,2 davon.

Ihr Ort vor diesem Bild bleibt, was er war. Die Geschwindigkeit ist der Weg, den sie kam, darum ist die Verschiebung auch ein Schubs: Sie weicht weiter zurück, langsamer und langsamer, bis der Motor sie umgekehrt hat. Ein längerer Weg gibt eine größere Verschiebung, ohne eine Zahl, die man dafür setzen müsste.

Zwei Klicks in einem Bild verschieben sie zweimal.</translation>
    </message>
    <message>
        <source>Now the tail gets a velocity of its own, and the stick gives way: it is **soft**. The tail drags behind and swings past, and the body is squashed and stretched along its **spine**, the line from tail to lead.

Each frame takes only 0.1 of the error. But a soft stick alone would let the tail pass through the lead. So there are **three cases**: shorter than 20&#x202f;px or longer than 60&#x202f;px, it takes 0.8 of what is past that limit; in between, 0.1 of the way to 40&#x202f;px.

The tail’s velocity is split in two, **along** the spine and **across** it. Along, it keeps 0.7 each frame, across only 0.5: it bobs more than it swings round.</source>
        <translation>Jetzt bekommt der Schwanz eine eigene Geschwindigkeit, und der Stab gibt nach: Er ist **weich**. Der Schwanz hinkt hinterher und schwingt vorbei, und der Körper wird längs seines **Rückgrats** gestaucht und gestreckt, der Linie vom Schwanz zur Spitze.

Jedes Bild nimmt nur 0,1 des Fehlers. Aber ein weicher Stab allein würde den Schwanz durch die Spitze hindurchlassen. Darum gibt es **drei Fälle**: Kürzer als 20&#x202f;px oder länger als 60&#x202f;px nimmt er 0,8 von dem, was jenseits der Grenze ist; dazwischen 0,1 des Wegs zu 40&#x202f;px.

Die Geschwindigkeit des Schwanzes wird zerlegt, **längs** zum Rückgrat und **quer** dazu. Längs behält er in jedem Bild 0,7, quer nur 0,5: Er federt mehr, als er herumschwingt.</translation>
    </message>
    <message>
        <source>A body that gets shorter must get wider, or it seems to lose weight. Two more points make the **sides**, with five more constraints.

Four are soft and one-sided: from lead and tail to each side. They keep the sides in the middle.

The fifth is rigid and goes across, from side to side. **Its length follows from the area**: half of spine times width is the area of this shape, so the width that it needs is 2 × area / spine. Half as long makes twice as wide.

In a sharp turn the sides come late and the shape buckles; calmer moves look better.</source>
        <translation>Ein Körper, der kürzer wird, muss breiter werden, sonst scheint er Gewicht zu verlieren. Zwei weitere Punkte bilden die **Seiten**, mit fünf weiteren Zwangsbedingungen.

Vier sind weich und einseitig: von Spitze und Schwanz zu jeder Seite. Sie halten die Seiten in der Mitte.

Die fünfte ist starr und geht quer, von Seite zu Seite. **Ihre Länge folgt aus der Fläche**: Die Hälfte von Rückgrat mal Breite ist die Fläche dieser Form, also ist die Breite, die sie braucht, 2 × Fläche / Rückgrat. Halb so lang macht doppelt so breit.

In einer scharfen Kurve kommen die Seiten zu spät, und die Form knickt ein; ruhigere Bewegungen sehen besser aus.</translation>
    </message>
    <message>
        <source>The sides carry **tentacles**: chains of points with sticks between them. Each point goes on as it came (Verlet), and **water** leaves it a share of its speed. Then the sticks pull it in.

These sticks are one-sided, too. From the side outwards, each link puts its outer end right and leaves the inner one alone. So **one pass is enough**: no later link disturbs an earlier one, and every link has exactly its 7&#x202f;px.

The price: a tentacle feels the body, but the body does not feel the tentacle. For something so light that is a fair lie.

Nothing here was drawn frame by frame: springs and constraints do all of it.</source>
        <translation>Die Seiten tragen **Tentakel**: Ketten von Punkten mit Stäben dazwischen. Jeder Punkt geht weiter, wie er kam (Verlet), und **Wasser** lässt ihm einen Anteil seines Tempos. Dann ziehen die Stäbe ihn heran.

Auch diese Stäbe sind einseitig. Von der Seite nach außen stellt jedes Glied sein äußeres Ende richtig und lässt das innere in Ruhe. Darum **genügt ein Durchgang**: Kein späteres Glied stört ein früheres, und jedes Glied hat genau seine 7&#x202f;px.

Der Preis: Ein Tentakel spürt den Körper, aber der Körper spürt den Tentakel nicht. Für etwas so Leichtes ist das ein erlaubter Schwindel.

Nichts hier wurde Bild für Bild gezeichnet: Federn und Zwangsbedingungen tun das alles.</translation>
    </message>
    <message>
        <source>Press **Space**. Take the head (the lead), swing it quickly, let go on the way, and wait.</source>
        <translation>Drück die **Leertaste**. Nimm den Kopf (die Spitze), schwing ihn schnell, lass unterwegs los und warte.</translation>
    </message>
    <message>
        <source>Stop. Click the background far off, on the side away from its tail, and go on with **→** until it is fast. Then press **Shift+→** until the strip under the timeline marks the move.</source>
        <translation>Halte an. Klicke weit entfernt auf den Hintergrund, auf der Seite, auf der der Schwanz nicht ist, und geh mit **→** weiter, bis es schnell ist. Drück dann **Umschalt+→**, bis der Streifen unter der Zeitleiste die Bewegung markiert.</translation>
    </message>
    <message>
        <source>Stop. Click the background far from the creature, and press **Shift+→** until the strip under the timeline marks the anticipation.</source>
        <translation>Halte an. Klicke weit vom Wesen entfernt auf den Hintergrund und drück **Umschalt+→**, bis der Streifen unter der Zeitleiste das Ausholen markiert.</translation>
    </message>
    <message>
        <source>Play, click the background, and stop. Drag the timeline back to before the click, type another **Anticipation**, and play on for half a second.</source>
        <translation>Spiele ab, klicke auf den Hintergrund und halte an. Zieh die Zeitleiste vor den Klick zurück, gib ein anderes **Ausholen** ein und spiele eine halbe Sekunde weiter.</translation>
    </message>
    <message>
        <source>Click at least 100&#x202f;px away, and wait until it has arrived.</source>
        <translation>Klicke mindestens 100&#x202f;px entfernt und warte, bis es angekommen ist.</translation>
    </message>
    <message>
        <source>click 100&#x202f;px away or more. That was %1&#x202f;px.</source>
        <translation>klicke 100&#x202f;px entfernt oder mehr. Das waren %1&#x202f;px.</translation>
    </message>
    <message>
        <source>Pull it at least 75&#x202f;px away by its tail, let go, and wait until it is back.</source>
        <translation>Zieh es am Schwanz mindestens 75&#x202f;px weg, lass los und warte, bis es zurück ist.</translation>
    </message>
    <message>
        <source>Click far away, and stop inside a frame right after the anticipation, when it backs up at 3&#x202f;px per frame or more.</source>
        <translation>Klicke weit weg und halte innerhalb eines Bildes gleich nach dem Ausholen an, wenn es mit 3&#x202f;px pro Bild oder mehr zurückweicht.</translation>
    </message>
    <message>
        <source>press **Shift+→** until the anticipation is the last phase that was done.</source>
        <translation>drück **Umschalt+→**, bis das Ausholen die letzte erledigte Phase ist.</translation>
    </message>
    <message>
        <source>let time run for 100&#x202f;frames after the click. So far: %1.</source>
        <translation>lass die Zeit nach dem Klick 100&#x202f;Bilder lang laufen. Bisher: %1.</translation>
    </message>
    <message>
        <source>the pull to the target</source>
        <translation>der Zug zum Ziel</translation>
    </message>
    <message>
        <source>Write the **pull of the motor**: a spring to the target. Times **dt** twice, the tutorial’s time of a frame, it becomes a velocity per frame.</source>
        <translation>Schreibe den **Zug des Motors**: eine Feder zum Ziel. Zweimal mal **dt**, die Zeit eines Bildes im Tutorial, wird daraus eine Geschwindigkeit pro Bild.</translation>
    </message>
    <message>
        <source>Vec2 pull: the spring to the target.</source>
        <translation>Vec2 pull: die Feder zum Ziel.</translation>
    </message>
    <message>
        <source>The missing distance leads from `lead.position` to `target`.</source>
        <translation>Der fehlende Abstand führt von `lead.position` zu `target`.</translation>
    </message>
    <message>
        <source>A spring pulls `k` times the missing distance. Multiply by `dt` twice.</source>
        <translation>Eine Feder zieht `k` mal den fehlenden Abstand. Multipliziere zweimal mit `dt`.</translation>
    </message>
    <message>
        <source>`Vec2 pull = k * dt * dt * (… - …);`</source>
        <translation>`Vec2 pull = k * dt * dt * (… - …);`</translation>
    </message>
    <message>
        <source>The pull points away from the target. Swap the two places of the difference.</source>
        <translation>Der Zug zeigt vom Ziel weg. Vertausche die zwei Orte der Differenz.</translation>
    </message>
    <message>
        <source>The pull is too strong by far: `dt` belongs there twice.</source>
        <translation>Der Zug ist viel zu stark: `dt` gehört zweimal dorthin.</translation>
    </message>
    <message>
        <source>The pull is too strong by far: `dt` is missing, twice.</source>
        <translation>Der Zug ist viel zu stark: `dt` fehlt, zweimal.</translation>
    </message>
    <message>
        <source>a tail that follows</source>
        <translation>ein Schwanz, der folgt</translation>
    </message>
    <message>
        <source>Write **which end gives way**: the tail takes the whole `correction`. But if your hand holds the tail, the lead takes it.</source>
        <translation>Schreibe, **welches Ende nachgibt**: Der Schwanz nimmt die ganze `correction`. Aber wenn deine Hand den Schwanz hält, nimmt sie die Spitze.</translation>
    </message>
    <message>
        <source>Move the tail, or the lead if the tail is held.</source>
        <translation>Bewege den Schwanz, oder die Spitze, wenn der Schwanz gehalten wird.</translation>
    </message>
    <message>
        <source>The tail comes closer with a minus. The lead would come closer with a plus.</source>
        <translation>Der Schwanz kommt mit einem Minus näher. Die Spitze käme mit einem Plus näher.</translation>
    </message>
    <message>
        <source>`if (tail.held) lead.position += …; else tail.position -= …;`</source>
        <translation>`if (tail.held) lead.position += …; else tail.position -= …;`</translation>
    </message>
    <message>
        <source>While you hold the tail it slips out of your hand. Then the lead has to give way.</source>
        <translation>Während du den Schwanz hältst, rutscht er dir aus der Hand. Dann muss die Spitze nachgeben.</translation>
    </message>
    <message>
        <source>The correction points the wrong way: the two get apart. The tail needs a minus, and the lead a plus.</source>
        <translation>Die Korrektur zeigt in die falsche Richtung: Die beiden kommen auseinander. Der Schwanz braucht ein Minus und die Spitze ein Plus.</translation>
    </message>
    <message>
        <source>The lead gives way, so it drags on the tail. It should be the tail that follows.</source>
        <translation>Die Spitze gibt nach, darum bremst sie der Schwanz. Folgen soll der Schwanz.</translation>
    </message>
    <message>
        <source>While you hold the tail, nothing gives way, and the stick stretches.</source>
        <translation>Während du den Schwanz hältst, gibt nichts nach, und der Stab dehnt sich.</translation>
    </message>
    <message>
        <source>Write the **anticipation**: before it goes to a new target, the lead backs up by the part **anticipation** of the distance. The shift is a push, too.</source>
        <translation>Schreibe das **Ausholen**: Bevor die Spitze zu einem neuen Ziel geht, weicht sie zurück, um den Teil **Ausholen** des Abstands. Die Verschiebung ist auch ein Schubs.</translation>
    </message>
    <message>
        <source>The lead backs up: shift its position, and add the shift to its velocity.</source>
        <translation>Die Spitze weicht zurück: Verschiebe ihren Ort und addiere die Verschiebung zu ihrer Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Away from the target: from the target to where the lead is.</source>
        <translation>Vom Ziel weg: vom Ziel dorthin, wo die Spitze ist.</translation>
    </message>
    <message>
        <source>The shift is `anticipation` times that vector. It is added twice: to the position and to the velocity.</source>
        <translation>Die Verschiebung ist `anticipation` mal dieser Vektor. Sie wird zweimal addiert: zum Ort und zur Geschwindigkeit.</translation>
    </message>
    <message>
        <source>`Vec2 shift = anticipation * (lead.position - …);`, and two lines with `+= shift`.</source>
        <translation>`Vec2 shift = anticipation * (lead.position - …);`, und zwei Zeilen mit `+= shift`.</translation>
    </message>
    <message>
        <source>The lead jumps towards the target. To back up, it has to go the other way.</source>
        <translation>Die Spitze springt zum Ziel hin. Um auszuholen, muss sie in die andere Richtung.</translation>
    </message>
    <message>
        <source>The lead backs up, but the shift gives it no velocity. Add the shift to the velocity, too.</source>
        <translation>Die Spitze weicht zurück, aber die Verschiebung gibt ihr keine Geschwindigkeit. Addiere sie auch zur Geschwindigkeit.</translation>
    </message>
    <message>
        <source>The lead gets a push, but does not jump back. Add the shift to the position, too.</source>
        <translation>Die Spitze bekommt einen Schubs, springt aber nicht zurück. Addiere die Verschiebung auch zum Ort.</translation>
    </message>
    <message>
        <source>The lead backs up by the whole distance. Multiply by `anticipation`.</source>
        <translation>Die Spitze weicht um den ganzen Abstand zurück. Multipliziere mit `anticipation`.</translation>
    </message>
    <message>
        <source>the whole frame</source>
        <translation>das ganze Bild</translation>
    </message>
    <message>
        <source>**From the empty page:** write the whole frame of a swimmer: it backs up before a new target, a spring pulls the lead, and the tail follows on a stick.</source>
        <translation>**Von der leeren Seite:** Schreibe das ganze Bild eines Schwimmers: Er holt vor einem neuen Ziel aus, eine Feder zieht die Spitze, und der Schwanz folgt an einem Stab.</translation>
    </message>
    <message>
        <source>First the anticipation, for each new target, if the lead is not held. Then the lead: in your hand, or damped (`keep`), pulled and moved. Then the tail.</source>
        <translation>Zuerst das Ausholen, für jedes neue Ziel, wenn die Spitze nicht gehalten wird. Dann die Spitze: in deiner Hand, oder gedämpft (`keep`), gezogen und bewegt. Dann der Schwanz.</translation>
    </message>
    <message>
        <source>The lead: `lead.velocity *= keep;`, then the pull `k * dt * dt * (target - lead.position)`, then the move.</source>
        <translation>Die Spitze: `lead.velocity *= keep;`, dann der Zug `k * dt * dt * (target - lead.position)`, dann die Bewegung.</translation>
    </message>
    <message>
        <source>The tail: in your hand it goes to `hand`. The error of the stick is the distance minus `rest_length`. Move the tail by it towards the lead. If the tail is held, move the lead instead.</source>
        <translation>Der Schwanz: In deiner Hand geht er zu `hand`. Der Fehler des Stabs ist der Abstand minus `rest_length`. Bewege den Schwanz um ihn zur Spitze hin. Wird der Schwanz gehalten, bewege stattdessen die Spitze.</translation>
    </message>
    <message>
        <source>The rest is right, but the lead jumps towards a new target. It should back up.</source>
        <translation>Der Rest stimmt, aber die Spitze springt zu einem neuen Ziel hin. Sie soll ausholen.</translation>
    </message>
    <message>
        <source>The rest is right, but backing up gives the lead no velocity. The shift is a push, too.</source>
        <translation>Der Rest stimmt, aber das Ausholen gibt der Spitze keine Geschwindigkeit. Die Verschiebung ist auch ein Schubs.</translation>
    </message>
    <message>
        <source>The rest is right, but while you hold the tail, the lead has to give way.</source>
        <translation>Der Rest stimmt, aber während du den Schwanz hältst, muss die Spitze nachgeben.</translation>
    </message>
    <message>
        <source>the width that keeps the area</source>
        <translation>die Breite, die die Fläche erhält</translation>
    </message>
    <message>
        <source>Write the **width** that keeps the area: **rest_length** times 30 at rest. Count a spine of less than 10&#x202f;px as 10&#x202f;px long.</source>
        <translation>Schreibe die **Breite**, die die Fläche erhält: In Ruhe ist diese **Ruhelänge** mal 30. Ein Rückgrat von weniger als 10&#x202f;px zählt wie eines von 10&#x202f;px.</translation>
    </message>
    <message>
        <source>double wanted: the width that keeps the area.</source>
        <translation>double wanted: die Breite, die die Fläche erhält.</translation>
    </message>
    <message>
        <source>The area is the length times the width, so the width is the area divided by the length.</source>
        <translation>Die Fläche ist Länge mal Breite, also ist die Breite die Fläche geteilt durch die Länge.</translation>
    </message>
    <message>
        <source>The length is the distance of `lead` and `tail`. `max(…, 10)` is never less than 10.</source>
        <translation>Die Länge ist der Abstand von `lead` und `tail`. `max(…, 10)` ist nie kleiner als 10.</translation>
    </message>
    <message>
        <source>`double wanted = rest_length * 30 / max(length(… - …), 10);`</source>
        <translation>`double wanted = rest_length * 30 / max(length(… - …), 10);`</translation>
    </message>
    <message>
        <source>The width stays 30&#x202f;px, so a short swimmer has a smaller area. Half as long has to be twice as wide.</source>
        <translation>Die Breite bleibt 30&#x202f;px, darum hat ein kurzer Schwimmer eine kleinere Fläche. Halb so lang muss doppelt so breit sein.</translation>
    </message>
    <message>
        <source>It gets wider as it gets longer. Divide by the length.</source>
        <translation>Er wird breiter, wenn er länger wird. Teile durch die Länge.</translation>
    </message>
    <message>
        <source>This is far too narrow: the area is `rest_length` times 30.</source>
        <translation>Das ist viel zu schmal: Die Fläche ist `rest_length` mal 30.</translation>
    </message>
    <message>
        <source>`correction` points from the lead to the tail, and is as long as the error.</source>
        <translation>`correction` zeigt von der Spitze zum Schwanz und ist so lang wie der Fehler.</translation>
    </message>
    <message>
        <source>Write the whole frame. The names: lead, tail (each with position, velocity, held), target, new_targets[i], new_targets.count, anticipation, k, keep, dt, rest_length, hand.</source>
        <translation>Schreibe das ganze Bild. Die Namen: lead, tail (jeweils mit position, velocity, held), target, new_targets[i], new_targets.count, anticipation, k, keep, dt, rest_length, hand.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Codeling</source>
        <translation>Codeling</translation>
    </message>
    <message>
        <source>A little swimmer whose whole character comes from springs and constraints.</source>
        <translation>Ein kleiner Schwimmer, dessen ganzer Charakter aus Federn und Zwangsbedingungen kommt.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>lead</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>tail</source>
        <translation>Schwanz</translation>
    </message>
    <message>
        <source>sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>tentacles</source>
        <translation>Tentakel</translation>
    </message>
    <message>
        <source>side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>tentacle</source>
        <translation>Tentakel</translation>
    </message>
</context>
</TS>
