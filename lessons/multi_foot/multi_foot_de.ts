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
    <message>
        <source>two pulls</source>
        <translation>zwei Züge</translation>
    </message>
    <message>
        <source>Write the **two pulls on the body**, one from each foot. They add up.</source>
        <translation>Schreibe die **zwei Züge am Körper**, einen von jedem Fuß. Sie addieren sich.</translation>
    </message>
    <message>
        <source>Both feet pull the body.</source>
        <translation>Beide Füße ziehen den Körper.</translation>
    </message>
    <message>
        <source>`pull(me, anchor)` returns the pull on `me`. It is added to the velocity of `me`.</source>
        <translation>`pull(me, anchor)` gibt den Zug an `me` zurück. Er wird zur Geschwindigkeit von `me` addiert.</translation>
    </message>
    <message>
        <source>The feet are `feet[0]` and `feet[1]`. Here the body is the one that is pulled.</source>
        <translation>Die Füße sind `feet[0]` und `feet[1]`. Gezogen wird hier der Körper.</translation>
    </message>
    <message>
        <source>`body.velocity += pull(body, …);` twice.</source>
        <translation>`body.velocity += pull(body, …);`, zweimal.</translation>
    </message>
    <message>
        <source>Only one foot pulls the body. The other one, `feet[1]`, is missing.</source>
        <translation>Nur ein Fuß zieht den Körper. Der andere, `feet[1]`, fehlt.</translation>
    </message>
    <message>
        <source>Only one foot pulls the body. The other one, `feet[0]`, is missing.</source>
        <translation>Nur ein Fuß zieht den Körper. Der andere, `feet[0]`, fehlt.</translation>
    </message>
    <message>
        <source>The two pulls add up, but `=` forgets the velocity that the body had.</source>
        <translation>Die zwei Züge addieren sich, aber `=` vergisst die Geschwindigkeit, die der Körper hatte.</translation>
    </message>
    <message>
        <source>These are the pulls on the feet. The first name in the brackets is the one that is pulled.</source>
        <translation>Das sind die Züge an den Füßen. Der erste Name in der Klammer ist der, der gezogen wird.</translation>
    </message>
    <message>
        <source>a loop over the feet</source>
        <translation>eine Schleife über die Füße</translation>
    </message>
    <message>
        <source>Write the **loop** in which every foot pulls the body, however many there are.</source>
        <translation>Schreibe die **Schleife**, in der jeder Fuß den Körper zieht, wie viele es auch sind.</translation>
    </message>
    <message>
        <source>Every foot pulls the body.</source>
        <translation>Jeder Fuß zieht den Körper.</translation>
    </message>
    <message>
        <source>There are `feet.count` feet. Their numbers begin with 0.</source>
        <translation>Es gibt `feet.count` Füße. Ihre Nummern beginnen mit 0.</translation>
    </message>
    <message>
        <source>A loop that counts: `for (int i = 0; i &lt; …; i++)`. Inside it, `feet[i]` is one foot.</source>
        <translation>Eine Schleife, die zählt: `for (int i = 0; i &lt; …; i++)`. In ihr ist `feet[i]` ein Fuß.</translation>
    </message>
    <message>
        <source>In the loop: `body.velocity += pull(body, feet[i]);`</source>
        <translation>In der Schleife: `body.velocity += pull(body, feet[i]);`</translation>
    </message>
    <message>
        <source>The loop leaves out the first foot. It has the number 0.</source>
        <translation>Die Schleife lässt den ersten Fuß aus. Er hat die Nummer 0.</translation>
    </message>
    <message>
        <source>The loop leaves out the last foot.</source>
        <translation>Die Schleife lässt den letzten Fuß aus.</translation>
    </message>
    <message>
        <source>With `=` each pull replaces the one before. They should add up.</source>
        <translation>Mit `=` ersetzt jeder Zug den davor. Sie sollen sich addieren.</translation>
    </message>
    <message>
        <source>The same foot pulls each time. Use `feet[i]`.</source>
        <translation>Jedes Mal zieht derselbe Fuß. Nimm `feet[i]`.</translation>
    </message>
    <message>
        <source>a body in your hand</source>
        <translation>ein Körper in deiner Hand</translation>
    </message>
    <message>
        <source>Write the function **follow** for a body that is held: it goes where your hand is, and can be thrown.</source>
        <translation>Schreibe die Funktion **follow** für einen Körper, der gehalten wird: Er geht dorthin, wo deine Hand ist, und du kannst ihn werfen.</translation>
    </message>
    <message>
        <source>me is held by the hand.</source>
        <translation>me ist in der Hand.</translation>
    </message>
    <message>
        <source>The velocity is how far the hand moved in this frame: from where `me` still is to `hand`.</source>
        <translation>Die Geschwindigkeit ist, wie weit sich die Hand in diesem Bild bewegt hat: von dort, wo `me` noch ist, bis zu `hand`.</translation>
    </message>
    <message>
        <source>Set the velocity before the position changes.</source>
        <translation>Setze die Geschwindigkeit, bevor sich der Ort ändert.</translation>
    </message>
    <message>
        <source>`me.velocity = hand - …;` and then `me.position = …;`</source>
        <translation>`me.velocity = hand - …;` und dann `me.position = …;`</translation>
    </message>
    <message>
        <source>`me` has already moved when you take the difference, so its velocity is 0 and it cannot be thrown. Swap the two lines.</source>
        <translation>`me` hat sich schon bewegt, wenn du den Unterschied nimmst. Darum ist seine Geschwindigkeit 0, und du kannst es nicht werfen. Vertausche die zwei Zeilen.</translation>
    </message>
    <message>
        <source>`me` follows the hand, but keeps the velocity from before. Your throw has no effect.</source>
        <translation>`me` folgt der Hand, behält aber die Geschwindigkeit von vorher. Dein Wurf hat keine Wirkung.</translation>
    </message>
    <message>
        <source>`me` lags behind the hand. While it is held, nothing damps it.</source>
        <translation>`me` bleibt hinter der Hand zurück. Was gehalten wird, wird nicht gedämpft.</translation>
    </message>
    <message>
        <source>the whole frame</source>
        <translation>das ganze Bild</translation>
    </message>
    <message>
        <source>**From the empty page:** write the whole frame of a body with any number of feet. The hand comes first, then each foot, and the body last.</source>
        <translation>**Von der leeren Seite:** Schreibe das ganze Bild für einen Körper mit beliebig vielen Füßen. Erst kommt die Hand, dann jeder Fuß und zuletzt der Körper.</translation>
    </message>
    <message>
        <source>Write the whole frame. The names: body, feet[i] (each with position, velocity and held), feet.count, hand, k, damp, radius. Functions of your own stand above frame.</source>
        <translation>Schreibe das ganze Bild. Die Namen: body, feet[i] (jeweils mit position, velocity und held), feet.count, hand, k, damp, radius. Eigene Funktionen stehen über frame.</translation>
    </message>
    <message>
        <source>Three functions help: `pull(me, anchor)` returns the pull on `me`, `follow(me)` is for a body that is held, and `move(me)` damps and moves.</source>
        <translation>Drei Funktionen helfen: `pull(me, anchor)` gibt den Zug an `me` zurück, `follow(me)` ist für einen Körper, der gehalten wird, und `move(me)` dämpft und bewegt.</translation>
    </message>
    <message>
        <source>The order: if the body is held, it follows. Then a loop: each foot follows if it is held; if not, it is pulled by the body and moves. Then the body, if it is not held: all pulls, and one move.</source>
        <translation>Die Reihenfolge: Wird der Körper gehalten, folgt er. Dann eine Schleife: Jeder Fuß folgt, wenn er gehalten wird; wenn nicht, zieht ihn der Körper, und er bewegt sich. Dann der Körper, wenn er nicht gehalten wird: alle Züge und eine Bewegung.</translation>
    </message>
    <message>
        <source>`Vec2 pull(Body me, Body anchor)` returns `k * (target - me.position)`. Its target is `anchor.position + radius * Vec2(cos(angle), sin(angle))`, with the angle of `me.position - anchor.position`.</source>
        <translation>`Vec2 pull(Body me, Body anchor)` gibt `k * (target - me.position)` zurück. Sein Ziel ist `anchor.position + radius * Vec2(cos(angle), sin(angle))`, mit dem Winkel von `me.position - anchor.position`.</translation>
    </message>
    <message>
        <source>The rest is right, but each target is on the far side of the body that pulls.</source>
        <translation>Der Rest stimmt, aber jedes Ziel ist auf der anderen Seite des Körpers, der zieht.</translation>
    </message>
    <message>
        <source>The rest is right, but the springs pull the bodies onto each other. They should stay `radius` px apart.</source>
        <translation>Der Rest stimmt, aber die Federn ziehen die Körper aufeinander. Sie sollen `radius` px Abstand halten.</translation>
    </message>
    <message>
        <source>The rest is right, but every pull points away from its target.</source>
        <translation>Der Rest stimmt, aber jeder Zug zeigt von seinem Ziel weg.</translation>
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
