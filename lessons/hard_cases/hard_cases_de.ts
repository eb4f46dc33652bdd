<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>HardCases</name>
    <message>
        <source>its steps are too long for what is so stiff</source>
        <translation>Seine Zeitschritte sind zu lang für etwas so Steifes</translation>
    </message>
    <message>
        <source>its steps are longer than those that the case’s sticks are measured by</source>
        <translation>Seine Zeitschritte sind länger als die, an denen die Stäbe des Falls gemessen werden</translation>
    </message>
    <message>
        <source>it swings on for longer than the run</source>
        <translation>Es schwingt länger weiter, als der Lauf dauert</translation>
    </message>
    <message>
        <source>it moves one body after the other</source>
        <translation>Es bewegt einen Körper nach dem anderen</translation>
    </message>
    <message>
        <source>it would need too many steps</source>
        <translation>Es würde zu viele Zeitschritte brauchen</translation>
    </message>
    <message>
        <source>its errors add up</source>
        <translation>Seine Fehler summieren sich</translation>
    </message>
    <message>
        <source>its errors keep it stirring</source>
        <translation>Seine Fehler halten es in Unruhe</translation>
    </message>
    <message>
        <source>no place there is free</source>
        <translation>Kein Ort dort ist frei</translation>
    </message>
    <message>
        <source>it cannot compute all of it</source>
        <translation>Es kann nicht alles davon berechnen</translation>
    </message>
    <message>
        <source>You have changed it: nobody claims this.</source>
        <translation>Du hast ihn geändert: Niemand sagt das zu.</translation>
    </message>
    <message>
        <source>%1 claims this case.</source>
        <translation>„%1“ sagt diesen Fall zu.</translation>
    </message>
    <message>
        <source>%1 does not claim it: %2.</source>
        <translation>„%1“ sagt ihn nicht zu: %2.</translation>
    </message>
    <message>
        <source>out of its bounds since frame %1</source>
        <translation>außerhalb seiner Grenzen seit Bild %1</translation>
    </message>
    <message>
        <source>within its bounds up to frame %1, the rest is not looked at yet</source>
        <translation>innerhalb seiner Grenzen bis Bild %1, der Rest ist noch nicht angesehen</translation>
    </message>
    <message>
        <source>within its bounds so far</source>
        <translation>bisher innerhalb seiner Grenzen</translation>
    </message>
    <message>
        <source>within its bounds so far, not at rest yet</source>
        <translation>bisher innerhalb seiner Grenzen, noch nicht in Ruhe</translation>
    </message>
    <message>
        <source>within its bounds so far, and at rest, as it should be</source>
        <translation>bisher innerhalb seiner Grenzen und in Ruhe, so wie es sein soll</translation>
    </message>
    <message>
        <source>%1
%2 Frame %3 of %4: %5.</source>
        <translation>%1
%2 Bild %3 von %4: %5.</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>The experiment that runs. Another one begins at frame 0.</source>
        <translation>Das Experiment, das läuft. Ein anderes beginnt bei Bild 0.</translation>
    </message>
    <message>
        <source>How hard the springs of the case pull. 0: as hard as the case has it.</source>
        <translation>Wie stark die Federn des Falls ziehen. 0: so stark, wie der Fall es vorsieht.</translation>
    </message>
    <message>
        <source>the middle moved %1&#x2009;px</source>
        <translation>die Mitte hat sich um %1&#x2009;px bewegt</translation>
    </message>
    <message>
        <source>Longest</source>
        <translation>Längster</translation>
    </message>
    <message>
        <source>The length of the third stick. The other two are 20&#x2009;px long.</source>
        <translation>Die Länge des dritten Stabs. Die anderen zwei sind 20&#x2009;px lang.</translation>
    </message>
    <message>
        <source>The limit of a step</source>
        <translation>Zeitschritt-Grenze</translation>
    </message>
    <message>
        <source>Implicit midpoint</source>
        <translation>Implizite Mittelpunktsregel</translation>
    </message>
    <message>
        <source>A step asks for the pull once, and then goes straight on. If the spring is too stiff, it goes past the middle, and farther out than it came from. The next pull is stronger still.

Without damping this begins at exactly **k h² = 4**: with steps of one frame, at a stiffness of 4. There the foot comes out on the other side with all its speed. Here k is 4.01.

A smaller step moves the limit: half of it bears **four times** the stiffness. Damping moves it, too: for steps of a frame to k = 2&#x2009;(1 + damp) / damp.

**Implicit midpoint**, below, asks for the pull half-way, where it does not know the place yet, and solves for it. It has no such limit.

The small **gauge** shows how near you are.</source>
        <translation>Ein Zeitschritt fragt einmal nach dem Zug und geht dann geradeaus. Ist die Feder zu steif, geht er über die Mitte hinaus, und weiter hinaus, als er herkam. Der nächste Zug ist noch stärker.

Ohne Dämpfung beginnt das bei genau **k h² = 4**: mit Zeitschritten von einem Bild bei einer Steifigkeit von 4. Dort kommt der Fuß mit all seinem Tempo auf der anderen Seite heraus. Hier ist k 4,01.

Ein kleinerer Zeitschritt verschiebt die Grenze: Der halbe verträgt die **vierfache** Steifigkeit. Auch Dämpfung verschiebt sie: bei Zeitschritten von einem Bild auf k = 2 (1 + damp) / damp.

Die **implizite Mittelpunktsregel**, unten, fragt auf halbem Weg nach dem Zug, wo sie den Ort noch nicht kennt, und löst danach auf. Sie hat keine solche Grenze.

Die kleine **Anzeige** zeigt, wie nahe du ihr bist.</translation>
    </message>
    <message>
        <source>The runaway pair</source>
        <translation>Das Paar läuft davon</translation>
    </message>
    <message>
        <source>Semi-implicit Euler</source>
        <translation>Semi-implizites Euler</translation>
    </message>
    <message>
        <source>A foot and a body pull each other. Nothing pushes from outside, so **the middle between them has to stay where it is**: at the cross.

The printed rule moves the foot first. Then the body looks where the foot is **now**, and feels another pull than the foot felt. What the two give each other is not equal any more: the pair makes itself a push out of nothing, each frame. With k = 0.3 and damping 0.9 that is more than damping takes, and the pair never comes to rest.

At k = 0.2 it does come to rest, but in a wrong place.

**Semi-implicit Euler**, on the right, is the same formula. It only takes all pulls first, and moves all bodies then.</source>
        <translation>Ein Fuß und ein Körper ziehen einander. Nichts schiebt von außen, also **muss die Mitte zwischen ihnen bleiben, wo sie ist**: am Kreuz.

Die gedruckte Regel bewegt zuerst den Fuß. Dann schaut der Körper, wo der Fuß **jetzt** ist, und spürt einen anderen Zug, als der Fuß spürte. Was die zwei einander geben, ist nicht mehr gleich: Das Paar macht sich in jedem Bild einen Schubs aus dem Nichts. Mit k = 0,3 und Dämpfung 0,9 ist das mehr, als die Dämpfung nimmt, und das Paar kommt nie zur Ruhe.

Bei k = 0,2 kommt es zur Ruhe, aber am falschen Ort.

Das **semi-implizite Euler-Verfahren**, rechts, ist dieselbe Formel. Es nimmt nur zuerst alle Züge und bewegt dann alle Körper.</translation>
    </message>
    <message>
        <source>Too many feet</source>
        <translation>Zu viele Füße</translation>
    </message>
    <message>
        <source>Backward Euler</source>
        <translation>Implizites Euler</translation>
    </message>
    <message>
        <source>A stiffness of 0.2 is soft. But the body feels **all its feet at once**: sixty soft springs make one that is stiff.

In any direction about half of the feet count, and the feet give way a little. So the pair of body and feet swings like a spring of stiffness k&#x2009;(1 + feet / 2). With damping 0.85 the limit is 4.35, which is about 41 feet. At rest, that is: legs that are out of their length make it worse, so 38 feet hold here, and 41 do not.

**Backward Euler**, on the right, looks for the place where the pulls *of the new place* lead to. No number of feet is too many for it.</source>
        <translation>Eine Steifigkeit von 0,2 ist weich. Aber der Körper spürt **alle seine Füße zugleich**: Sechzig weiche Federn ergeben eine, die steif ist.

In jeder Richtung zählt etwa die Hälfte der Füße, und die Füße geben ein wenig nach. Darum schwingt das Paar aus Körper und Füßen wie eine Feder der Steifigkeit k (1 + Füße / 2). Mit Dämpfung 0,85 ist die Grenze 4,35, das sind etwa 41 Füße. In Ruhe jedenfalls: Beine, die nicht ihre Länge haben, machen es schlimmer, darum halten hier 38 Füße, und 41 nicht.

Das **implizite Euler-Verfahren**, rechts, sucht den Ort, zu dem die Züge *des neuen Ortes* führen. Keine Zahl von Füßen ist ihm zu viel.</translation>
    </message>
    <message>
        <source>All in one place</source>
        <translation>Alles an einem Ort</translation>
    </message>
    <message>
        <source>Five feet and a body begin in **one place**. Each spring wants to be 50&#x2009;px long. In which direction?

The printed code asks `atan2(0, 0)`, which is 0: to the right, for every foot. So all five go together, the body goes to the left, and what was five feet is one for ever: nothing tells them apart any more.

The rule on the right gives **each pair a direction of its own**: it turns by the golden angle from one pair to the next, so many feet spread evenly. The two ends of a spring get opposite directions. It counts nothing but the numbers of the two points, so the same run comes out each time.

Every method but the printed one uses it, everywhere.</source>
        <translation>Fünf Füße und ein Körper beginnen an **einem Ort**. Jede Feder will 50&#x2009;px lang sein. In welche Richtung?

Der gedruckte Code fragt `atan2(0, 0)`, und das ist 0: nach rechts, für jeden Fuß. Also gehen alle fünf zusammen, der Körper geht nach links, und was fünf Füße waren, ist für immer einer: Nichts unterscheidet sie mehr.

Die Regel rechts gibt **jedem Paar seine eigene Richtung**: Von einem Paar zum nächsten dreht sie sich um den goldenen Winkel, darum verteilen sich viele Füße gleichmäßig. Die zwei Enden einer Feder bekommen entgegengesetzte Richtungen. Sie zählt nichts als die Nummern der zwei Punkte, darum kommt jedes Mal derselbe Lauf heraus.

Jedes Verfahren außer dem gedruckten verwendet sie, überall.</translation>
    </message>
    <message>
        <source>Stiff but calm</source>
        <translation>Steif, aber ruhig</translation>
    </message>
    <message>
        <source>Three legs, each 5000 times as stiff as before: nearly sticks. In one step Semi-implicit Euler sends the feet 20&#x2009;000&#x2009;px away. Some frames later the numbers are too large to write: the run **stops at the last good frame** and says who went first. Nothing is lost. Go back, and change something.

It can be saved by small steps: 1/32 of a frame is too long still, 1/64 holds. That is 64 times the work, for a motion that nobody sees.

**Backward Euler** needs one step a frame, at any stiffness. The price: it slows what swings, as if there were more damping. For what should be stiff and calm that is right; for what should swing, it is not.</source>
        <translation>Drei Beine, jedes 5000-mal so steif wie zuvor: fast Stäbe. In einem Zeitschritt schickt das semi-implizite Euler-Verfahren die Füße 20 000&#x2009;px weit weg. Einige Bilder später sind die Zahlen zu groß zum Schreiben: Der Lauf **hält beim letzten guten Bild an** und sagt, wer zuerst davonging. Nichts ist verloren. Geh zurück und ändere etwas.

Retten lässt er sich mit kleinen Zeitschritten: 1/32 Bild ist noch zu lang, 1/64 hält. Das ist die 64-fache Arbeit, für eine Bewegung, die niemand sieht.

Das **implizite Euler-Verfahren** braucht einen Zeitschritt pro Bild, bei jeder Steifigkeit. Der Preis: Es bremst, was schwingt, als gäbe es mehr Dämpfung. Für etwas, das steif und ruhig sein soll, ist das richtig; für etwas, das schwingen soll, nicht.</translation>
    </message>
    <message>
        <source>Sticks that contradict</source>
        <translation>Stäbe im Widerspruch</translation>
    </message>
    <message>
        <source>The same, as sticks</source>
        <translation>Dasselbe, als Stäbe</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Whether springs hold the three points, or rigid sticks.</source>
        <translation>Ob Federn die drei Punkte halten oder starre Stäbe.</translation>
    </message>
    <message>
        <source>Three lengths: 20, 20 and 200&#x2009;px. No triangle has them. Whatever moves, something is wrong.

On the left **springs** pull. What is wrong stays wrong, so they pull for ever, and three springs of 1.5 are too stiff for a step: in a line they swing like one of 3 k, and the limit is 4.22.

On the right **sticks** hold. They do not pull: each is made right by *moving* its ends, one after the other. The last in the list has its length, and the others bear the error. A place cannot be moved farther than an error is large, so sticks never run away. They come to rest, with a lie shared out among them. Its size is in their colour.</source>
        <translation>Drei Längen: 20, 20 und 200&#x2009;px. Kein Dreieck hat sie. Was sich auch bewegt, etwas ist falsch.

Links ziehen **Federn**. Was falsch ist, bleibt falsch, darum ziehen sie ewig, und drei Federn von 1,5 sind zu steif für einen Zeitschritt: In einer Linie schwingen sie wie eine von 3 k, und die Grenze ist 4,22.

Rechts halten **Stäbe**. Sie ziehen nicht: Jeder wird richtiggestellt, indem man seine Enden *bewegt*, einer nach dem anderen. Der letzte in der Liste hat seine Länge, und die anderen tragen den Fehler. Ein Ort lässt sich nicht weiter bewegen, als ein Fehler groß ist, darum laufen Stäbe nie davon. Sie kommen zur Ruhe, mit einer Lüge, die sie unter sich aufteilen. Ihre Farbe zeigt, wie groß sie ist.</translation>
    </message>
    <message>
        <source>The long run</source>
        <translation>Der lange Lauf</translation>
    </message>
    <message>
        <source>Velocity Verlet</source>
        <translation>Velocity-Verlet</translation>
    </message>
    <message>
        <source>Nothing slows this foot. It should swing for ever.

**Runge–Kutta 4** is the more exact of the two: in the first ten frames it is never more than 1.3&#x2009;px off, Velocity Verlet up to 14&#x2009;px. But its error always points the same way: with steps of a frame, each of them takes 0.08&#x2009;% of the swing. After **851&#x2009;frames** half is left, after 5000 next to nothing.

**Velocity Verlet**, below, swings a little too fast. But its steps can be taken back exactly, and so nothing is lost, not in ten million frames.

To go far, type a frame&apos;s number into the counter.

What an error *adds up to* counts for more than how small it is.</source>
        <translation>Nichts bremst diesen Fuß. Er sollte ewig schwingen.

**Runge–Kutta 4** ist das genauere der beiden: In den ersten zehn Bildern ist es nie mehr als 1,3&#x2009;px daneben, Velocity-Verlet bis zu 14&#x2009;px. Aber sein Fehler zeigt immer in dieselbe Richtung: Mit Zeitschritten von einem Bild nimmt jeder 0,08&#x2009;% der Schwingung. Nach **851&#x2009;Bildern** ist die Hälfte übrig, nach 5000 fast nichts.

**Velocity-Verlet**, unten, schwingt ein wenig zu schnell. Aber seine Zeitschritte lassen sich genau zurücknehmen, und so geht nichts verloren, nicht in zehn Millionen Bildern.

Um weit zu gehen, gib die Nummer eines Bildes in den Zähler ein.

Wozu sich ein Fehler *summiert*, zählt mehr, als wie klein er ist.</translation>
    </message>
    <message>
        <source>The torture panel</source>
        <translation>Die Zerreißprobe</translation>
    </message>
    <message>
        <source>Here are all the cases that this program is tested with. Choose one, and a **method** above the scene, and see what holds.

A method **claims** what it can hold: that follows from its rule, and is worked out before the run. The line over the scene says whether it claims this case, and how the run has been so far: within the bounds that the case sets, at rest where it should be, or out of bounds, and since when.

A claim that breaks would be a fault of the program. A case that nobody claims may hold all the same. What cannot be computed at all is refused, with a sentence.

Hands, walls and steps belong to a case. If you reach in, it is your own experiment.</source>
        <translation>Hier sind alle Fälle, mit denen dieses Programm geprüft wird. Wähle einen, und ein **Verfahren** über der Szene, und sieh, was hält.

Ein Verfahren **sagt zu**, was es halten kann: Das folgt aus seiner Regel und wird vor dem Lauf ausgerechnet. Die Zeile über der Szene sagt, ob es diesen Fall zusagt, und wie der Lauf bisher war: innerhalb der Grenzen, die der Fall setzt, in Ruhe, wo er es sein soll, oder außerhalb der Grenzen, und seit wann.

Eine Zusage, die bricht, wäre ein Fehler des Programms. Ein Fall, den niemand zusagt, kann trotzdem halten. Was sich gar nicht berechnen lässt, wird abgelehnt, mit einem Satz.

Hände, Wände und Zeitschritte gehören zu einem Fall. Greifst du ein, ist es dein eigenes Experiment.</translation>
    </message>
    <message>
        <source>Choose **1/2&#x2009;frame** as step, and play to frame 100. It swings, hardly farther than the crosses.</source>
        <translation>Wähle **1/2 Bild** als Zeitschritt und spiele bis Bild 100. Er schwingt, kaum weiter als die Kreuze.</translation>
    </message>
    <message>
        <source>With steps of 1&#x2009;frame, go to frame 0 and set **k** to 3.9. Play to frame 100: six times as far, and it always comes back.</source>
        <translation>Geh mit Zeitschritten von 1 Bild zu Bild 0 und setze **k** auf 3,9. Spiele bis Bild 100: sechsmal so weit, und er kommt immer zurück.</translation>
    </message>
    <message>
        <source>At k = 4.01, go to frame 0 and set **damp** to 0.9. The limit is 4.22 now: wait until it rests.</source>
        <translation>Geh bei k = 4,01 zu Bild 0 und setze **Dämpfung** auf 0,9. Jetzt ist die Grenze 4,22: Warte, bis er ruht.</translation>
    </message>
    <message>
        <source>Choose **Semi-implicit Euler** as method, and play to frame 200. Where is the middle?</source>
        <translation>Wähle **Semi-implizites Euler** und spiele bis Bild 200. Wo ist die Mitte?</translation>
    </message>
    <message>
        <source>With **Published** and steps of 1&#x2009;frame, go to frame 0 and set **k** to 0.2. Wait until it rests: 157&#x2009;px from where it belongs.</source>
        <translation>Geh mit **Veröffentlicht** und Zeitschritten von 1 Bild zu Bild 0 und setze **k** auf 0,2. Warte, bis es ruht: 157&#x2009;px von dort, wo es hingehört.</translation>
    </message>
    <message>
        <source>**Published** at k = 0.3, with steps of **1/4&#x2009;frame**: wait until it rests. Less wrong, and never right.</source>
        <translation>**Veröffentlicht** bei k = 0,3, mit Zeitschritten von **1/4 Bild**: Warte, bis es ruht. Weniger falsch, und nie richtig.</translation>
    </message>
    <message>
        <source>With steps of 1&#x2009;frame, go to frame 0 and set **feet** to 38. Wait until it rests.</source>
        <translation>Geh mit Zeitschritten von 1 Bild zu Bild 0 und setze **Füße** auf 38. Warte, bis alles ruht.</translation>
    </message>
    <message>
        <source>Sixty feet at rest with steps of **1/2&#x2009;frame**.</source>
        <translation>Sechzig Füße in Ruhe, mit Zeitschritten von **1/2 Bild**.</translation>
    </message>
    <message>
        <source>Sixty feet at rest with steps of 1&#x2009;frame: how soft must the springs be? (Go to frame 0 first.)</source>
        <translation>Sechzig Füße in Ruhe, mit Zeitschritten von 1 Bild: Wie weich müssen die Federn sein? (Geh zuerst zu Bild 0.)</translation>
    </message>
    <message>
        <source>Choose **Semi-implicit Euler**, and play from frame 0 to 60: five feet, all apart.</source>
        <translation>Wähle **Semi-implizites Euler** und spiele von Bild 0 bis 60: fünf Füße, alle getrennt.</translation>
    </message>
    <message>
        <source>With any other method and all feet apart, set **radius** to 0: all fall into one place. After 60&#x2009;frames set it to 50 again. Do they part?</source>
        <translation>Setze mit jedem anderen Verfahren, wenn alle Füße getrennt sind, **Radius** auf 0: Alle fallen an einen Ort. Setze ihn nach 60&#x2009;Bildern wieder auf 50. Trennen sie sich?</translation>
    </message>
    <message>
        <source>**Semi-implicit Euler**: find a step with which the stiff legs come to rest.</source>
        <translation>**Semi-implizites Euler**: Finde einen Zeitschritt, mit dem die steifen Beine zur Ruhe kommen.</translation>
    </message>
    <message>
        <source>**Backward Euler**, steps of 1&#x2009;frame: go to frame 0, type 1000000 as **k**, and play 30&#x2009;frames.</source>
        <translation>**Implizites Euler**, Zeitschritte von 1 Bild: Geh zu Bild 0, gib 1000000 als **k** ein und spiele 30&#x2009;Bilder.</translation>
    </message>
    <message>
        <source>The price: **Backward Euler** with **k** 0.2 and **damp** 1, from frame 0. Nothing slows the legs. Wait until they have stopped swinging.</source>
        <translation>Der Preis: **Implizites Euler** mit **k** 0,2 und **Dämpfung** 1, von Bild 0 an. Nichts bremst die Beine. Warte, bis sie nicht mehr schwingen.</translation>
    </message>
    <message>
        <source>Springs, steps of 1&#x2009;frame: go to frame 0 and set **k** to 1. They share the error: wait until they rest.</source>
        <translation>Federn, Zeitschritte von 1 Bild: Geh zu Bild 0 und setze **k** auf 1. Sie teilen sich den Fehler: Warte, bis sie ruhen.</translation>
    </message>
    <message>
        <source>Choose **sticks**, and wait until they rest. Which of them has its length?</source>
        <translation>Wähle **Stäbe** und warte, bis sie ruhen. Welcher von ihnen hat seine Länge?</translation>
    </message>
    <message>
        <source>Sticks: make **longest** so short that there is such a triangle, and all three are right to 0.1&#x2009;px.</source>
        <translation>Stäbe: Mach **Längster** so kurz, dass es so ein Dreieck gibt und alle drei bis auf 0,1&#x2009;px stimmen.</translation>
    </message>
    <message>
        <source>**Runge–Kutta 4**, steps of 1&#x2009;frame: go to frame 5000. What is left?</source>
        <translation>**Runge–Kutta 4**, Zeitschritte von 1 Bild: Geh zu Bild 5000. Was ist übrig?</translation>
    </message>
    <message>
        <source>The same with steps of **1/2&#x2009;frame**: a thirty-second of the loss a frame.</source>
        <translation>Dasselbe mit Zeitschritten von **1/2 Bild**: ein Zweiunddreißigstel des Verlusts pro Bild.</translation>
    </message>
    <message>
        <source>**Velocity Verlet**, steps of 1&#x2009;frame, to frame 20000: it swings as at first.</source>
        <translation>**Velocity-Verlet**, Zeitschritte von 1 Bild, bis Bild 20000: Es schwingt wie am Anfang.</translation>
    </message>
    <message>
        <source>Case **nearly rigid**: find a method that claims it, and play until it is at rest.</source>
        <translation>Fall **fast starr**: Finde ein Verfahren, das ihn zusagt, und spiele, bis er in Ruhe ist.</translation>
    </message>
    <message>
        <source>Case **torn away**: find a method with which the legs have their length again before frame 400. Which is the quickest?</source>
        <translation>Fall **weggerissen**: Finde ein Verfahren, mit dem die Beine vor Bild 400 wieder ihre Länge haben. Welches ist das schnellste?</translation>
    </message>
    <message>
        <source>Make any case **stop**: find one that a method does not claim, and see who went first.</source>
        <translation>Bring einen Fall zum **Anhalten**: Finde einen, den ein Verfahren nicht zusagt, und sieh, wer zuerst davonging.</translation>
    </message>
    <message>
        <source>springs</source>
        <translation>Federn</translation>
    </message>
    <message>
        <source>sticks</source>
        <translation>Stäbe</translation>
    </message>
    <message>
        <source>A step that is too long for a spring throws it out: without damping from k h² = 4 on.</source>
        <translation>Ein Zeitschritt, der für eine Feder zu lang ist, wirft sie hinaus: ohne Dämpfung ab k h² = 4.</translation>
    </message>
    <message>
        <source>Above the picture, press **Step** and choose **1/2&#x2009;frame**. Press **Space** and wait four seconds.</source>
        <translation>Drück über der Szene **Zeitschritt** und wähle **1/2&#x2009;Bild**. Drück die **Leertaste** und warte vier Sekunden.</translation>
    </message>
    <message>
        <source>Press **Home**, type 3.9 into the field beside **k**, press **Space**, and wait four seconds.</source>
        <translation>Drück **Pos1**, gib im Feld neben **k** 3,9 ein, drück die **Leertaste** und warte vier Sekunden.</translation>
    </message>
    <message>
        <source>Press **Home**, type 0.9 into the field beside **Damping**, press **Space**, and wait.</source>
        <translation>Drück **Pos1**, gib im Feld neben **Dämpfung** 0,9 ein, drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Stability limit</source>
        <translation>Stabilitätsgrenze</translation>
    </message>
    <message>
        <source>the limit</source>
        <translation>die Grenze</translation>
    </message>
    <message>
        <source>The longest step with which a method still holds a scene. Past it, each swing is wider than the one before.</source>
        <translation>Der längste Zeitschritt, mit dem ein Verfahren eine Szene noch hält. Darüber ist jede Schwingung weiter als die vorige.</translation>
    </message>
    <message>
        <source>Gauge</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>gauge</source>
        <translation>Anzeige</translation>
    </message>
    <message>
        <source>The small bar at the lower right: it shows how near the step is to its stability limit. A click shows the reasons.</source>
        <translation>Der kleine Balken rechts unten: Er zeigt, wie nahe der Zeitschritt seiner Stabilitätsgrenze ist. Ein Klick zeigt die Gründe.</translation>
    </message>
    <message>
        <source>Implicit method</source>
        <translation>Implizites Verfahren</translation>
    </message>
    <message>
        <source>implicit midpoint|solves for it</source>
        <translation>implizite Mittelpunktsregel|löst danach auf</translation>
    </message>
    <message>
        <source>A method that asks for the pull at a place that it does not know yet, and finds the place that fits. It costs more, and has no stability limit.</source>
        <translation>Ein Verfahren, das nach dem Zug an einem Ort fragt, den es noch nicht kennt, und den Ort findet, der passt. Es kostet mehr und hat keine Stabilitätsgrenze.</translation>
    </message>
    <message>
        <source>Why 4?</source>
        <translation>Warum 4?</translation>
    </message>
    <message>
        <source>Let the foot be at x with the velocity v. A step of h makes

`v → v − h k x`

`x → x + h v`

Now ask which swing comes back just as wide, on the other side: from x to −x, and v to −v. For v that needs

`h k x = 2 v`

and for x, with the new velocity −v,

`h v = 2 x`

Put one into the other:

`k h² = 4`

With less, a swing stays as wide as it is. With more, it grows.</source>
        <translation>Der Fuß sei bei x, mit der Geschwindigkeit v. Ein Zeitschritt von h macht

`v → v − h k x`

`x → x + h v`

Frag jetzt, welche Schwingung genau so weit zurückkommt, auf der anderen Seite: von x zu −x, und v zu −v. Für v braucht es dazu

`h k x = 2 v`

und für x, mit der neuen Geschwindigkeit −v,

`h v = 2 x`

Setze das eine ins andere ein:

`k h² = 4`

Mit weniger bleibt eine Schwingung so weit, wie sie ist. Mit mehr wächst sie.</translation>
    </message>
    <message>
        <source>Pulls that are taken at different moments do not cancel, so the pair pushes itself.</source>
        <translation>Züge, die zu verschiedenen Momenten genommen werden, heben sich nicht auf, darum schiebt das Paar sich selbst.</translation>
    </message>
    <message>
        <source>Above the picture, press **Method** and choose **Semi-implicit Euler**. Press **Space** and wait seven seconds.</source>
        <translation>Drück über der Szene **Verfahren** und wähle **Semi-implizites Euler**. Drück die **Leertaste** und warte sieben Sekunden.</translation>
    </message>
    <message>
        <source>Choose **Published** as method and **1&#x2009;frame** as step. Press **Home**, type 0.2 beside **k**, press **Space**, and wait.</source>
        <translation>Wähle **Veröffentlicht** als Verfahren und **1&#x2009;Bild** als Zeitschritt. Drück **Pos1**, gib neben **k** 0,2 ein, drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Choose **Published** as method and **1/4&#x2009;frame** as step. Press **Space** and wait.</source>
        <translation>Wähle **Veröffentlicht** als Verfahren und **1/4&#x2009;Bild** als Zeitschritt. Drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Sixty soft springs on one body make one that is stiff.</source>
        <translation>Sechzig weiche Federn an einem Körper ergeben eine, die steif ist.</translation>
    </message>
    <message>
        <source>Press **Home**, type 38 into the field beside **Feet**, press **Space**, and wait.</source>
        <translation>Drück **Pos1**, gib im Feld neben **Füße** 38 ein, drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Above the picture, press **Step** and choose **1/2&#x2009;frame**. Press **Space** and wait.</source>
        <translation>Drück über der Szene **Zeitschritt** und wähle **1/2&#x2009;Bild**. Drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Press **Home**, type 0.1 into the field beside **k**, press **Space**, and wait.</source>
        <translation>Drück **Pos1**, gib im Feld neben **k** 0,1 ein, drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>A method that looks for the place from which its own pulls lead back to where it came from. It holds at any stiffness, and slows what swings.</source>
        <translation>Ein Verfahren, das den Ort sucht, von dem aus seine eigenen Züge dorthin zurückführen, woher es kam. Es hält bei jeder Steifigkeit und bremst, was schwingt.</translation>
    </message>
    <message>
        <source>Two points in one place have no direction between them, so a rule has to give them one.</source>
        <translation>Zwei Punkte an einem Ort haben keine Richtung zueinander, darum muss eine Regel ihnen eine geben.</translation>
    </message>
    <message>
        <source>Above the picture, press **Method** and choose **Semi-implicit Euler**. Press **Space** and wait two seconds.</source>
        <translation>Drück über der Szene **Verfahren** und wähle **Semi-implizites Euler**. Drück die **Leertaste** und warte zwei Sekunden.</translation>
    </message>
    <message>
        <source>Choose **Published** as method, press **Space**, and wait two seconds. Take a foot, carry it up, let go, and wait.</source>
        <translation>Wähle **Veröffentlicht** als Verfahren, drück die **Leertaste** und warte zwei Sekunden. Nimm einen Fuß, trag ihn nach oben, lass los und warte.</translation>
    </message>
    <message>
        <source>Choose **Semi-implicit Euler** as method and play two seconds. Type 0 beside **Radius** and wait two seconds. Then type 50, and wait again.</source>
        <translation>Wähle **Semi-implizites Euler** als Verfahren und spiele zwei Sekunden. Gib neben **Radius** 0 ein und warte zwei Sekunden. Gib dann 50 ein und warte noch einmal.</translation>
    </message>
    <message>
        <source>Coincident points</source>
        <translation>Zusammenfallende Punkte</translation>
    </message>
    <message>
        <source>one place</source>
        <translation>an einem Ort|an einen Ort</translation>
    </message>
    <message>
        <source>Two points at exactly the same place. Nothing tells in which direction one lies from the other.</source>
        <translation>Zwei Punkte an genau demselben Ort. Nichts sagt, in welcher Richtung der eine vom anderen liegt.</translation>
    </message>
    <message>
        <source>Golden angle</source>
        <translation>Goldener Winkel</translation>
    </message>
    <message>
        <source>golden angle</source>
        <translation>goldenen Winkel|goldener Winkel|goldene Winkel</translation>
    </message>
    <message>
        <source>137.5°. Turned by it again and again, directions never fall on one another and spread evenly. Sunflowers set their seeds like that.</source>
        <translation>137,5°. Immer wieder um ihn gedreht, fallen Richtungen nie aufeinander und verteilen sich gleichmäßig. Sonnenblumen setzen so ihre Kerne.</translation>
    </message>
    <message>
        <source>Why has one place no direction?</source>
        <translation>Warum hat ein einziger Ort keine Richtung?</translation>
    </message>
    <message>
        <source>The direction from a to b is the way from one to the other, divided by its length:

`d / |d|`

In one place d is (0, 0) and its length is 0. Nothing can be divided by 0, and every direction would be as good.

So a rule has to choose, and three things matter: the **same** choice each time, **opposite** ones for the two ends, and **different** ones for different pairs, or all would go the same way and stay together.

`angle = number × 137.5°`

does that: the golden angle never fits into a turn.</source>
        <translation>Die Richtung von a nach b ist der Weg vom einen zum anderen, geteilt durch seine Länge:

`d / |d|`

An einem Ort ist d (0, 0) und seine Länge 0. Durch 0 lässt sich nichts teilen, und jede Richtung wäre gleich gut.

Also muss eine Regel wählen, und auf drei Dinge kommt es an: jedes Mal **dieselbe** Wahl, **entgegengesetzte** Richtungen für die zwei Enden und **verschiedene** für verschiedene Paare, sonst gingen alle denselben Weg und blieben beisammen.

`angle = number × 137.5°`

leistet das, der Winkel (angle) aus der Nummer (number): Der goldene Winkel geht in einer Drehung nie auf.</translation>
    </message>
    <message>
        <source>What is stiff and should be calm needs either tiny steps or an implicit method.</source>
        <translation>Was steif ist und ruhig sein soll, braucht winzige Zeitschritte oder ein implizites Verfahren.</translation>
    </message>
    <message>
        <source>Above the picture, press **Step** and choose **1/64&#x2009;frame**. Press **Space** and wait.</source>
        <translation>Drück über der Szene **Zeitschritt** und wähle **1/64&#x2009;Bild**. Drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Choose **Backward Euler** as method. Press **Home**, type 1000000 beside **k**, and press **Space**.</source>
        <translation>Wähle **Implizites Euler** als Verfahren. Drück **Pos1**, gib neben **k** 1000000 ein und drück die **Leertaste**.</translation>
    </message>
    <message>
        <source>Choose **Backward Euler** as method. Press **Home**, type 0.2 beside **k** and 1 beside **Damping**, press **Space**, and wait.</source>
        <translation>Wähle **Implizites Euler** als Verfahren. Drück **Pos1**, gib neben **k** 0,2 und neben **Dämpfung** 1 ein, drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Stiff</source>
        <translation>Steif</translation>
    </message>
    <message>
        <source>is stiff|too stiff|stiff legs|stiff and calm</source>
        <translation>steif ist|zu steif|steifen Beine|steif und ruhig</translation>
    </message>
    <message>
        <source>Held so hard that it swings many times in a frame. Nobody sees those swings, but a method has to cope with them.</source>
        <translation>So fest gehalten, dass es in einem Bild viele Male schwingt. Niemand sieht diese Schwingungen, aber ein Verfahren muss mit ihnen zurechtkommen.</translation>
    </message>
    <message>
        <source>Where rules contradict, springs pull for ever, and sticks come to rest with a lie shared among them.</source>
        <translation>Wo Regeln sich widersprechen, ziehen Federn ewig, und Stäbe kommen zur Ruhe, mit einer Lüge, die sie unter sich aufteilen.</translation>
    </message>
    <message>
        <source>Press **Home**, type 1 into the field beside **k**, press **Space**, and wait.</source>
        <translation>Drück **Pos1**, gib im Feld neben **k** 1 ein, drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Choose **sticks** beside **Made of**, press **Space**, and wait.</source>
        <translation>Wähle neben **Material** **Stäbe**, drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Two sticks of 20&#x2009;px reach 40&#x2009;px at most. Choose **sticks** beside **Made of**, type 30 beside **Longest**, press **Space**, and wait.</source>
        <translation>Zwei Stäbe von 20&#x2009;px reichen höchstens 40&#x2009;px weit. Wähle neben **Material** **Stäbe**, gib neben **Längster** 30 ein, drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>What an error adds up to over thousands of frames counts for more than how small it is.</source>
        <translation>Wozu sich ein Fehler über Tausende von Bildern summiert, zählt mehr, als wie klein er ist.</translation>
    </message>
    <message>
        <source>Press **Ctrl+G**, type 5000, and press **Enter**.</source>
        <translation>Drück **Strg+G**, gib 5000 ein und drück **Eingabe**.</translation>
    </message>
    <message>
        <source>Above the picture, press **Step** and choose **1/2&#x2009;frame**. Press **Ctrl+G**, type 5000, and press **Enter**.</source>
        <translation>Drück über der Szene **Zeitschritt** und wähle **1/2&#x2009;Bild**. Drück **Strg+G**, gib 5000 ein und drück **Eingabe**.</translation>
    </message>
    <message>
        <source>Choose **Velocity Verlet** as method and **1&#x2009;frame** as step. Press **Ctrl+G**, type 20000, and press **Enter**.</source>
        <translation>Wähle **Velocity-Verlet** als Verfahren und **1&#x2009;Bild** als Zeitschritt. Drück **Strg+G**, gib 20000 ein und drück **Eingabe**.</translation>
    </message>
    <message>
        <source>What a method can hold follows from its rule, and can be said before the run.</source>
        <translation>Was ein Verfahren halten kann, folgt aus seiner Regel und lässt sich vor dem Lauf sagen.</translation>
    </message>
    <message>
        <source>Choose **nearly rigid** beside **Case**, and **Backward Euler** as method above the picture. Press **Space** and wait.</source>
        <translation>Wähle neben **Fall** **fast starr** und über der Szene **Implizites Euler** als Verfahren. Drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Choose **torn away** beside **Case**, and **Semi-implicit Euler** or **Backward Euler** as method. Press **Space** and wait.</source>
        <translation>Wähle neben **Fall** **weggerissen** und **Semi-implizites Euler** oder **Implizites Euler** als Verfahren. Drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Choose **Semi-implicit Euler** as method, and a case with stiff springs. Press **Space** and wait until the run stops by itself.</source>
        <translation>Wähle **Semi-implizites Euler** als Verfahren und einen Fall mit steifen Federn. Drück die **Leertaste** und warte, bis der Lauf von selbst anhält.</translation>
    </message>
    <message>
        <source>Claim</source>
        <translation>Zusage</translation>
    </message>
    <message>
        <source>claims|claim</source>
        <translation>sagt zu|zusagt|Zusage|Zusagen</translation>
    </message>
    <message>
        <source>What a method says it can hold, worked out from its rule before the run.</source>
        <translation>Was ein Verfahren nach eigener Aussage halten kann, vor dem Lauf aus seiner Regel ausgerechnet.</translation>
    </message>
    <message>
        <source>play on to frame %2. This is frame %1.</source>
        <translation>spiele weiter bis Bild %2. Das hier ist Bild %1.</translation>
    </message>
    <message>
        <source>press **Home**, and set **%1** to %2 there.</source>
        <translation>drück **Pos1** und setze dort **%1** auf %2.</translation>
    </message>
    <message>
        <source>choose steps of **1&#x2009;frame**.</source>
        <translation>wähle Zeitschritte von **1&#x2009;Bild**.</translation>
    </message>
    <message>
        <source>choose steps of **1/2&#x2009;frame**.</source>
        <translation>wähle Zeitschritte von **1/2&#x2009;Bild**.</translation>
    </message>
    <message>
        <source>choose **Semi-implicit Euler** as method.</source>
        <translation>wähle **Semi-implizites Euler** als Verfahren.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until it rests.</source>
        <translation>lass die Zeit laufen (**Leertaste**), bis es ruht.</translation>
    </message>
    <message>
        <source>choose **Published** as method.</source>
        <translation>wähle **Veröffentlicht** als Verfahren.</translation>
    </message>
    <message>
        <source>press **Home**, change nothing on the way, and do not touch it.</source>
        <translation>drück **Pos1**, ändere unterwegs nichts und fass es nicht an.</translation>
    </message>
    <message>
        <source>try something else: the worst leg is %1&#x2009;px off.</source>
        <translation>versuche etwas anderes: Das schlimmste Bein ist %1&#x2009;px daneben.</translation>
    </message>
    <message>
        <source>play on until all feet are more than 10&#x2009;px apart. The nearest two: %1&#x2009;px.</source>
        <translation>spiele weiter, bis alle Füße mehr als 10&#x2009;px auseinander sind. Die nächsten beiden: %1&#x2009;px.</translation>
    </message>
    <message>
        <source>set **radius** to 0, play on for 60&#x2009;frames, and set it to 50 again.</source>
        <translation>setze **Radius** auf 0, spiele 60&#x2009;Bilder weiter und setze ihn wieder auf 50.</translation>
    </message>
    <message>
        <source>choose the case again, and change nothing but method and step.</source>
        <translation>wähle den Fall noch einmal und ändere nichts als Verfahren und Zeitschritt.</translation>
    </message>
    <message>
        <source>k</source>
        <translation>k</translation>
    </message>
    <message>
        <source>damp</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>press **Home** and choose the method there: the pair has moved before.</source>
        <translation>drück **Pos1** und wähle dort das Verfahren: Das Paar hat sich vorher bewegt.</translation>
    </message>
    <message>
        <source>Where it was at the start. Both pulls are taken at one moment, so they cancel.</source>
        <translation>Wo sie am Anfang war. Beide Züge werden im selben Moment genommen, also heben sie sich auf.</translation>
    </message>
    <message>
        <source>set **feet** to 60 at frame 0.</source>
        <translation>setze **Füße** bei Bild 0 auf 60.</translation>
    </message>
    <message>
        <source>not all legs have their length: the worst is %1&#x2009;px off.</source>
        <translation>nicht alle Beine haben ihre Länge: Das schlimmste ist %1&#x2009;px daneben.</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>Füße</translation>
    </message>
    <message>
        <source>press **Home**, and set **k** there.</source>
        <translation>drück **Pos1** und setze dort **k**.</translation>
    </message>
    <message>
        <source>set **damp** to 0.85.</source>
        <translation>setze **Dämpfung** auf 0,85.</translation>
    </message>
    <message>
        <source>k = 0.13 holds, 0.14 does not.</source>
        <translation>k = 0,13 hält, 0,14 nicht.</translation>
    </message>
    <message>
        <source>**Published**: drag one foot up, 20&#x2009;px or more out of the line, let go, and wait until it rests. Did the others follow one by one, or as one?</source>
        <translation>**Veröffentlicht**: Zieh einen Fuß nach oben, 20&#x2009;px oder mehr aus der Linie, lass los und warte, bis es ruht. Folgten die anderen einzeln oder wie einer?</translation>
    </message>
    <message>
        <source>As one. The other four lie in one place, and nothing tells them apart.</source>
        <translation>Wie einer. Die anderen vier liegen an einem Ort, und nichts unterscheidet sie.</translation>
    </message>
    <message>
        <source>set **radius** to 50 again.</source>
        <translation>setze **Radius** wieder auf 50.</translation>
    </message>
    <message>
        <source>Yes. Other methods give points in one place directions of their own, all different.</source>
        <translation>Ja. Andere Verfahren geben Punkten an einem Ort eigene Richtungen, alle verschieden.</translation>
    </message>
    <message>
        <source>press **Home**, and set **k** to 1000 there.</source>
        <translation>drück **Pos1** und setze dort **k** auf 1000.</translation>
    </message>
    <message>
        <source>press **Home**, and try a smaller step.</source>
        <translation>drück **Pos1** und versuche einen kleineren Zeitschritt.</translation>
    </message>
    <message>
        <source>choose **Backward Euler** as method.</source>
        <translation>wähle **Implizites Euler** als Verfahren.</translation>
    </message>
    <message>
        <source>choose **springs**.</source>
        <translation>wähle **Federn**.</translation>
    </message>
    <message>
        <source>longest</source>
        <translation>Längster</translation>
    </message>
    <message>
        <source>The long one: it comes last in the list. The two short ones bear the error.</source>
        <translation>Der lange: Er kommt als letzter in der Liste. Die beiden kurzen tragen den Fehler.</translation>
    </message>
    <message>
        <source>choose **sticks**.</source>
        <translation>wähle **Stäbe**.</translation>
    </message>
    <message>
        <source>make **longest** shorter, or play on. The worst stick is %1&#x2009;px off.</source>
        <translation>mach **Längster** kürzer oder spiele weiter. Der schlimmste Stab ist %1&#x2009;px daneben.</translation>
    </message>
    <message>
        <source>choose **Runge–Kutta 4** as method.</source>
        <translation>wähle **Runge–Kutta 4** als Verfahren.</translation>
    </message>
    <message>
        <source>2&#x2009;px of 120&#x2009;px.</source>
        <translation>2&#x2009;px von 120&#x2009;px.</translation>
    </message>
    <message>
        <source>this method cannot hold it. Try one that claims it, from frame 0.</source>
        <translation>dieses Verfahren kann es nicht halten. Versuche eines, das es zusagt, von Bild 0 an.</translation>
    </message>
    <message>
        <source>play on until it is at rest.</source>
        <translation>spiele weiter, bis es ruht.</translation>
    </message>
    <message>
        <source>frame 400 is past. Try another method, from frame 0.</source>
        <translation>Bild 400 ist vorbei. Versuche ein anderes Verfahren, von Bild 0 an.</translation>
    </message>
    <message>
        <source>Backward Euler: it has them right at frame 37. It slows what swings.</source>
        <translation>Implizites Euler: Bei Bild 37 stimmen sie wieder. Es bremst, was schwingt.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Hard cases</source>
        <translation>Schwierige Fälle</translation>
    </message>
    <message>
        <source>What breaks a simulation, why, and what holds.</source>
        <translation>Was eine Simulation zerbricht, warum, und was hält.</translation>
    </message>
</context>
</TS>
