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
        <source>Who moves first matters: if one sees the other where it already is, momentum comes from nowhere.</source>
        <translation>Es ist nicht egal, wer sich zuerst bewegt: Sieht einer den anderen dort, wo er schon ist, kommt Impuls aus dem Nichts.</translation>
    </message>
    <message>
        <source>Type 0.3 into the field beside **k**, press **Space**, and touch nothing.</source>
        <translation>Gib 0,3 in das Feld neben **k** ein, drück die **Leertaste** und fass nichts an.</translation>
    </message>
    <message>
        <source>Type 0.3 beside **k** and 0.85 beside **Damping**. Then press **Space** and wait.</source>
        <translation>Gib 0,3 neben **k** und 0,85 neben **Dämpfung** ein. Dann drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Impuls</translation>
    </message>
    <message>
        <source>momentum</source>
        <translation>Impuls|Impulses</translation>
    </message>
    <message>
        <source>All velocities added up (times the mass, where masses differ). What only pulls each other cannot change it.</source>
        <translation>Alle Geschwindigkeiten addiert (mal die Masse, wo Massen verschieden sind). Was nur aneinander zieht, kann ihn nicht ändern.</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>method|methods</source>
        <translation>Verfahren|Verfahrens</translation>
    </message>
    <message>
        <source>The recipe that computes the next frame from this one: what is asked for when, and what moves when. You choose it above the picture.</source>
        <translation>Das Rezept, das aus diesem Bild das nächste berechnet: wonach wann gefragt wird und was sich wann bewegt. Du wählst es über der Szene.</translation>
    </message>
    <message>
        <source>Semi-implicit Euler</source>
        <translation>Semi-implizites Euler</translation>
    </message>
    <message>
        <source>A method: first all velocities get their pulls, and then everything moves by its new velocity.</source>
        <translation>Ein Verfahren: Erst bekommen alle Geschwindigkeiten ihre Züge, und dann bewegt sich alles mit seiner neuen Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Why does a spring pull both ends?</source>
        <translation>Warum zieht eine Feder an beiden Enden?</translation>
    </message>
    <message>
        <source>Hold a rubber band between two hands: each hand feels it, and just as hard. What pulls is pulled back:

`pull on body = − pull on foot`

So whatever the foot gains, the body loses, and the sum stays:

`v_foot + v_body = the same`

That holds only if both pulls are taken **at the same moment**. If the foot moves first, the body feels another distance than the foot felt. Then the two pulls do not cancel, and what is left over pushes the pair along.</source>
        <translation>Halte ein Gummiband zwischen zwei Händen: Jede Hand spürt es, und genauso stark. Was zieht, wird auch selbst gezogen. Der Zug am Körper (body) ist minus der Zug am Fuß (foot):

`pull on body = − pull on foot`

Was der Fuß gewinnt, verliert also der Körper, und die Summe bleibt gleich:

`v_foot + v_body = the same`

Das gilt nur, wenn beide Züge **im selben Moment** genommen werden. Bewegt sich der Fuß zuerst, spürt der Körper einen anderen Abstand, als der Fuß gespürt hat. Dann heben sich die zwei Züge nicht auf, und was übrig bleibt, schiebt das Paar davon.</translation>
    </message>
    <message>
        <source>A leg is only drawn: it shows how long the spring is, and changes nothing.</source>
        <translation>Ein Bein ist nur gezeichnet: Es zeigt, wie lang die Feder ist, und ändert nichts.</translation>
    </message>
    <message>
        <source>Press **Space**, take the foot, and pull it quickly into a corner. Do not let go yet.</source>
        <translation>Drück die **Leertaste**, nimm den Fuß und zieh ihn schnell in eine Ecke. Lass noch nicht los.</translation>
    </message>
    <message>
        <source>Type 100 into the field beside **Radius**, press **Space**, and wait.</source>
        <translation>Gib 100 in das Feld neben **Radius** ein, drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>set **damping** to 0.9.</source>
        <translation>setze **Dämpfung** auf 0,9.</translation>
    </message>
    <message>
        <source>set **damping** to 0.85.</source>
        <translation>setze **Dämpfung** auf 0,85.</translation>
    </message>
    <message>
        <source>set **k** to 0.3.</source>
        <translation>setze **k** auf 0,3.</translation>
    </message>
    <message>
        <source>press **Shift+→** until the foot has moved and the body has not.</source>
        <translation>drück **Umschalt+→**, bis der Fuß sich bewegt hat und der Körper noch nicht.</translation>
    </message>
    <message>
        <source>The foot where it is now. So the body is not pulled back as hard as the foot was pulled.</source>
        <translation>Den Fuß dort, wo er jetzt ist. Also wird der Körper nicht so stark gezogen, wie der Fuß gezogen wurde.</translation>
    </message>
    <message>
        <source>choose the method **Published**.</source>
        <translation>wähle das Verfahren **Veröffentlicht**.</translation>
    </message>
    <message>
        <source>press **Home** to begin again: your hand has left the pair a momentum.</source>
        <translation>drück **Pos1**, um neu zu beginnen: Deine Hand hat dem Paar einen Impuls gegeben.</translation>
    </message>
    <message>
        <source>pull faster. The leg is %1&#x202f;px long.</source>
        <translation>zieh schneller. Das Bein ist %1&#x202f;px lang.</translation>
    </message>
    <message>
        <source>let go now.</source>
        <translation>lass jetzt los.</translation>
    </message>
    <message>
        <source>pull the two apart, so that the leg becomes 100&#x202f;px long.</source>
        <translation>zieh die beiden auseinander, sodass das Bein 100&#x202f;px lang wird.</translation>
    </message>
    <message>
        <source>Set **k** to 0.3 and hands off: the pair flies away by itself.</source>
        <translation>Setze **k** auf 0,3, und Hände weg: Das Paar fliegt von selbst davon.</translation>
    </message>
    <message>
        <source>Stop, and press **Shift+→** until the strip under the timeline marks the move of the foot. The move of the body is still to come.</source>
        <translation>Halte an und drück **Umschalt+→**, bis der Streifen unter der Zeitleiste die Bewegung des Fußes markiert. Die des Körpers kommt erst noch.</translation>
    </message>
    <message>
        <source>Press **Home**. Type 0.3 beside **k** and 0.9 beside **Damping**. Above the picture, choose **Semi-implicit Euler** as method. Press **Space** and wait four seconds.</source>
        <translation>Drück **Pos1**. Gib 0,3 neben **k** und 0,9 neben **Dämpfung** ein. Wähle über der Szene **Semi-implizites Euler** als Verfahren. Drück die **Leertaste** und warte vier Sekunden.</translation>
    </message>
    <message>
        <source>Press **Space**, take the foot, and push it quickly onto the body. Let go at once.</source>
        <translation>Drück die **Leertaste**, nimm den Fuß und schieb ihn schnell auf den Körper. Lass sofort los.</translation>
    </message>
    <message>
        <source>Play some seconds, drag the timeline back to where both still move, type another **k**, and play on for a second.</source>
        <translation>Spiele ein paar Sekunden ab, zieh die Zeitleiste dorthin zurück, wo sich beide noch bewegen, gib ein anderes **k** ein und spiele eine Sekunde weiter.</translation>
    </message>
    <message>
        <source>A body, a foot, and now a **leg**: a line from one to the other. In the code it is one line, too.

It is drawn after each frame, from the two places as they are then, so it always fits. It adds no pull and costs no phase: **what is drawn cannot change what is computed**.

But it shows how long the spring is. Where it is longer than **radius**, the spring pulls its two ends together; where it is shorter, the spring pushes them apart; and at 50&#x202f;px it does nothing.</source>
        <translation>Ein Körper, ein Fuß, und jetzt ein **Bein**: eine Linie vom einen zum anderen. Auch im Code ist es eine Zeile.

Es wird nach jedem Bild gezeichnet, aus den zwei Orten, wie sie dann sind, darum passt es immer. Es fügt keinen Zug hinzu und kostet keine Phase: **Was gezeichnet wird, kann nicht ändern, was berechnet wird**.

Aber er zeigt, wie lang die Feder ist. Wo er länger ist als **Radius**, zieht die Feder ihre beiden Enden zusammen; wo er kürzer ist, drückt sie sie auseinander; und bei 50&#x202f;px tut sie nichts.</translation>
    </message>
    <message>
        <source>Hold one end and squeeze the leg to under 30&#x202f;px. Then let go.</source>
        <translation>Halte ein Ende und drück das Bein auf unter 30&#x202f;px zusammen. Dann lass los.</translation>
    </message>
    <message>
        <source>squeeze the leg to under 30&#x202f;px and let go there. It was %1&#x202f;px long.</source>
        <translation>drück das Bein auf unter 30&#x202f;px zusammen und lass dort los. Es war %1&#x202f;px lang.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until the pair has left the stage.</source>
        <translation>lass die Zeit laufen (**Leertaste**), bis das Paar die Bühne verlassen hat.</translation>
    </message>
    <message>
        <source>the opposite pull</source>
        <translation>der Gegenzug</translation>
    </message>
    <message>
        <source>Write the **opposite pull**: the spring also pulls the body, to its place at the distance **radius** from the foot.</source>
        <translation>Schreibe den **Gegenzug**: Die Feder zieht auch den Körper, an seinen Ort im Abstand **Radius** vom Fuß.</translation>
    </message>
    <message>
        <source>The spring pulls the body, too.</source>
        <translation>Die Feder zieht auch den Körper.</translation>
    </message>
    <message>
        <source>It is the line of the foot, with the two bodies swapped.</source>
        <translation>Es ist die Zeile des Fußes, mit vertauschten Körpern.</translation>
    </message>
    <message>
        <source>`nearest(body, foot)` is the place at the right distance from the foot that is nearest to the body.</source>
        <translation>`nearest(body, foot)` ist der Ort im richtigen Abstand vom Fuß, der dem Körper am nächsten ist.</translation>
    </message>
    <message>
        <source>`body.velocity += k * (nearest(…, …) - body.position);`</source>
        <translation>`body.velocity += k * (nearest(…, …) - body.position);`</translation>
    </message>
    <message>
        <source>The pull points away from the body’s place. A pull leads from where a body is to where it should be, and is added.</source>
        <translation>Der Zug zeigt vom Ort des Körpers weg. Ein Zug führt von dort, wo ein Körper ist, dorthin, wo er sein soll, und wird addiert.</translation>
    </message>
    <message>
        <source>This is the pull on the foot. The body would go the same way as the foot, and they would never meet.</source>
        <translation>Das ist der Zug am Fuß. Der Körper ginge denselben Weg wie der Fuß, und sie träfen sich nie.</translation>
    </message>
    <message>
        <source>`nearest(foot, body)` is the place of the foot. Swap the two bodies.</source>
        <translation>`nearest(foot, body)` ist der Ort des Fußes. Vertausche die zwei Körper.</translation>
    </message>
    <message>
        <source>This pulls the body onto the foot. It should stay `radius` px away.</source>
        <translation>Das zieht den Körper auf den Fuß. Er soll `radius` px entfernt bleiben.</translation>
    </message>
    <message>
        <source>the nearest place</source>
        <translation>der nächste Ort</translation>
    </message>
    <message>
        <source>Write the function **nearest**: it returns the place at the distance **radius** from `anchor` that is nearest to `me`.</source>
        <translation>Schreibe die Funktion **nearest**: Sie gibt den Ort im Abstand **Radius** von `anchor` zurück, der `me` am nächsten ist.</translation>
    </message>
    <message>
        <source>Return the place on the ring around anchor.</source>
        <translation>Gib den Ort auf dem Ring um anchor zurück.</translation>
    </message>
    <message>
        <source>The place is in the direction of `me`, seen from `anchor`.</source>
        <translation>Der Ort liegt in der Richtung von `me`, von `anchor` aus gesehen.</translation>
    </message>
    <message>
        <source>The angle of a vector is `atan2(y, x)`, and `Vec2(cos(angle), sin(angle))` is a step of 1&#x202f;px in its direction.</source>
        <translation>Der Winkel eines Vektors ist `atan2(y, x)`, und `Vec2(cos(angle), sin(angle))` ist ein Schritt von 1 px in seiner Richtung.</translation>
    </message>
    <message>
        <source>`Vec2 from = me.position - anchor.position;`

`double angle = …;`

`return anchor.position + …;`</source>
        <translation>`Vec2 from = me.position - anchor.position;`

`double angle = …;`

`return anchor.position + …;`</translation>
    </message>
    <message>
        <source>The place is on the far side of `anchor`. The direction has to lead from `anchor` to `me`.</source>
        <translation>Der Ort ist auf der anderen Seite von `anchor`. Die Richtung muss von `anchor` zu `me` führen.</translation>
    </message>
    <message>
        <source>The place is `radius` px from `me`. Start at `anchor`.</source>
        <translation>Der Ort ist `radius` px von `me` entfernt. Beginne bei `anchor`.</translation>
    </message>
    <message>
        <source>The place is on `anchor` itself. It should be `radius` px away.</source>
        <translation>Der Ort ist auf `anchor` selbst. Er soll `radius` px entfernt sein.</translation>
    </message>
    <message>
        <source>the whole frame</source>
        <translation>das ganze Bild</translation>
    </message>
    <message>
        <source>**From the empty page:** write the whole frame. Hold and throw both bodies. The foot is pulled and moves first, and then the body, which sees the foot where it already is.</source>
        <translation>**Von der leeren Seite:** Schreibe das ganze Bild. Beide Körper kannst du halten und werfen. Der Fuß wird gezogen und bewegt sich zuerst. Dann kommt der Körper, der den Fuß dort sieht, wo er schon ist.</translation>
    </message>
    <message>
        <source>Write the whole frame. The names: body, foot (each with position, velocity and held), hand, k, damp, radius. A function nearest(me, anchor) can find the place on a ring.</source>
        <translation>Schreibe das ganze Bild. Die Namen: body, foot (jeweils mit position, velocity und held), hand, k, damp, radius. Eine Funktion nearest(me, anchor) kann den Ort auf einem Ring finden.</translation>
    </message>
    <message>
        <source>Begin with the hand: a held body goes to the hand, and its velocity is how far the hand moved. Do this for both bodies first.</source>
        <translation>Beginne mit der Hand: Ein gehaltener Körper geht zur Hand, und seine Geschwindigkeit ist, wie weit sich die Hand bewegt hat. Tu das zuerst für beide Körper.</translation>
    </message>
    <message>
        <source>Then the foot, if it is not held: pull, damping, move. Then the same for the body, if it is not held.</source>
        <translation>Dann der Fuß, wenn er nicht gehalten wird: Zug, Dämpfung, Bewegung. Dann dasselbe für den Körper, wenn er nicht gehalten wird.</translation>
    </message>
    <message>
        <source>`Vec2 nearest(Body me, Body anchor)` above `frame` returns the target. The pull is `k * (nearest(foot, body) - foot.position)`, and for the body the other way round.</source>
        <translation>`Vec2 nearest(Body me, Body anchor)` über `frame` gibt das Ziel zurück. Der Zug ist `k * (nearest(foot, body) - foot.position)`, und für den Körper andersherum.</translation>
    </message>
    <message>
        <source>The rest is right, but the foot cannot be thrown: while you hold it, its velocity has to be how far the hand moved.</source>
        <translation>Der Rest stimmt, aber der Fuß lässt sich nicht werfen: Während du ihn hältst, muss seine Geschwindigkeit sein, wie weit sich die Hand bewegt hat.</translation>
    </message>
    <message>
        <source>The rest is right, but the foot moves before damping takes its share.</source>
        <translation>Der Rest stimmt, aber der Fuß bewegt sich, bevor die Dämpfung ihren Anteil nimmt.</translation>
    </message>
    <message>
        <source>The rest is right, but the pull on the body points away from its place.</source>
        <translation>Der Rest stimmt, aber der Zug am Körper zeigt von seinem Ort weg.</translation>
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
        <translation>Ein Fuß und ein Körper ziehen einander: Es macht einen Unterschied, wer gerade dran ist.</translation>
    </message>
</context>
</TS>
