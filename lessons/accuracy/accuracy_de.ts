<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Accuracy</name>
    <message>
        <source>Off by</source>
        <translation>Abweichung</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>How far the point that is worst off is from its exact place.</source>
        <translation>Wie weit der ungenaueste Punkt von seinem exakten Ort entfernt ist.</translation>
    </message>
    <message>
        <source>Energy drift</source>
        <translation>Energiedrift</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>How much more energy there is than in the exact motion at this moment.</source>
        <translation>Wie viel mehr Energie es in diesem Moment gibt als in der exakten Bewegung.</translation>
    </message>
    <message>
        <source>Its step</source>
        <translation>Sein Zeitschritt</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>How much time the method took at once, the last time.</source>
        <translation>Wie viel Zeit das Verfahren beim letzten Mal auf einmal genommen hat.</translation>
    </message>
    <message>
        <source>Computations</source>
        <translation>Berechnungen</translation>
    </message>
    <message>
        <source>a frame</source>
        <translation>pro Bild</translation>
    </message>
    <message>
        <source>How often all forces were computed for this frame: that is the work.</source>
        <translation>Wie oft für dieses Bild alle Kräfte berechnet wurden: Das ist die Arbeit.</translation>
    </message>
    <message>
        <source>%1&#x2009;px off</source>
        <translation>%1&#x2009;px daneben</translation>
    </message>
    <message>
        <source>Creatures</source>
        <translation>Figuren</translation>
    </message>
    <message>
        <source>How many creatures there are.</source>
        <translation>Wie viele Figuren es gibt.</translation>
    </message>
    <message>
        <source>Big step, small step</source>
        <translation>Große, kleine Schritte</translation>
    </message>
    <message>
        <source>A real spring pulls **all the time**. A computed one asks for its pull once a **step**, and goes straight on until the next. Here a step is one frame.

Without damping the exact motion is known: a cosine that swings once in 14.05&#x2009;frames. The dashed ring is there. The foot is not: each step turns a bend into a straight line, so it swings a little too fast, and after 100&#x2009;frames it is 66&#x2009;px off.

More, smaller steps follow the bend more closely, and each one is **work**: the pull has to be computed anew. You choose the step above the scene.</source>
        <translation>Eine echte Feder zieht **die ganze Zeit**. Eine berechnete fragt einmal pro **Zeitschritt** nach ihrem Zug und geht bis zum nächsten geradeaus. Hier ist ein Zeitschritt ein Bild.

Ohne Dämpfung ist die exakte Bewegung bekannt: ein Kosinus, der in 14,05&#x2009;Bildern einmal schwingt. Dort ist der gestrichelte Ring. Der Fuß ist es nicht: Jeder Zeitschritt macht aus einer Biegung eine Gerade, darum schwingt er ein wenig zu schnell und ist nach 100&#x2009;Bildern 66&#x2009;px daneben.

Mehr und kleinere Zeitschritte folgen der Biegung genauer, und jeder ist **Arbeit**: Der Zug muss neu berechnet werden. Den Zeitschritt wählst du über der Szene.</translation>
    </message>
    <message>
        <source>Energy that grows</source>
        <translation>Wachsende Energie</translation>
    </message>
    <message>
        <source>Motion has energy, and so has a stretched spring. Without damping **their sum never changes**. **Drift** is what the method adds to it.

**Explicit Euler** moves by the old velocity, and pulls by the old place. Each step multiplies the energy by exactly 1 + k h², whatever the motion: at k = 0.02 and h = 1 by 1.02. That doubles it every 35&#x2009;frames. A smaller step only takes longer.

**Semi-implicit Euler** moves by the new velocity. One line in another place, the same work: now the energy swings 7&#x2009;% round the true one, for ever, and never runs away. **Verlet** methods swing only half a percent.</source>
        <translation>Bewegung hat Energie, und eine gespannte Feder auch. Ohne Dämpfung **ändert sich ihre Summe nie**. **Drift** ist, was das Verfahren hinzufügt.

Das **explizite Euler-Verfahren** bewegt mit der alten Geschwindigkeit und zieht vom alten Ort aus. Jeder Zeitschritt vervielfacht die Energie um genau 1 + k h², wie die Bewegung auch aussieht: bei k = 0,02 und h = 1 um 1,02. Das verdoppelt sie alle 35&#x2009;Bilder. Ein kleinerer Zeitschritt braucht dafür nur länger.

Das **semi-implizite Euler-Verfahren** bewegt mit der neuen Geschwindigkeit. Eine Zeile an anderer Stelle, dieselbe Arbeit: Jetzt schwankt die Energie um 7&#x2009;% um die wahre, für immer, und läuft nie davon. **Verlet**-Verfahren schwanken nur um ein halbes Prozent.</translation>
    </message>
    <message>
        <source>Halve the step</source>
        <translation>Halber Zeitschritt</translation>
    </message>
    <message>
        <source>Half the step is twice the work. What do you get for it?

A method of **order 1** gets half the error. **Order 2**: a quarter. **Order 4**: a sixteenth. The order says nothing about one step alone; it says what halving is worth.

Runge–Kutta 4 asks for the forces four times a step, Semi-implicit Euler once. Yet with 8 computations a frame the one is 0.13&#x2009;px off at frame 60, and the other 0.44&#x2009;px. With 64, it is 0.00003&#x2009;px against 0.05.

Steps must be small enough first: at 2&#x2009;frames both are far off.

The **Accuracy** plot (Measure, at the top) shows a method as a ladder: three of them, or all by **Show all methods**. Steeper is a higher order.</source>
        <translation>Der halbe Zeitschritt ist die doppelte Arbeit. Was bekommst du dafür?

Ein Verfahren der **Ordnung 1** bekommt den halben Fehler. **Ordnung 2**: ein Viertel. **Ordnung 4**: ein Sechzehntel. Die Ordnung sagt nichts über einen einzelnen Zeitschritt; sie sagt, was das Halbieren wert ist.

Runge–Kutta 4 fragt viermal pro Zeitschritt nach den Kräften, das semi-implizite Euler-Verfahren einmal. Trotzdem ist bei 8 Berechnungen pro Bild das eine bei Bild 60 um 0,13&#x2009;px daneben und das andere um 0,44&#x2009;px. Bei 64 sind es 0,00003&#x2009;px gegen 0,05.

Dafür müssen die Zeitschritte erst einmal klein genug sein: Bei 2&#x2009;Bildern sind beide weit daneben.

Das Diagramm **Genauigkeit** (Messen, ganz oben) zeigt ein Verfahren als Leiter: drei davon, oder mit **Alle Verfahren zeigen** jedes. Steiler heißt höhere Ordnung.</translation>
    </message>
    <message>
        <source>Steps that adapt</source>
        <translation>Zeitschritte nach Maß</translation>
    </message>
    <message>
        <source>This foot falls past the middle, closely. Far out little happens, and a step could be long. At the middle its spring turns round in less than a frame: only there are small steps needed.

**Dormand–Prince** chooses. It computes each step twice at once, with order 5 and order 4. If the two differ by more than the **tolerance**, the step was too long, and it tries a shorter one.

Watch **its step**: almost 4&#x2009;frames far out, less than half a frame in the middle. The tolerance is for one step; errors add up on the way, so after 150&#x2009;frames more than 0.001&#x2009;px is missing.</source>
        <translation>Dieser Fuß fällt an der Mitte vorbei, und zwar knapp. Weit draußen geschieht wenig, und ein Zeitschritt könnte lang sein. In der Mitte kehrt sich seine Feder in weniger als einem Bild um: Nur dort braucht es kleine Zeitschritte.

**Dormand–Prince** wählt selbst. Es berechnet jeden Zeitschritt zweimal zugleich, mit Ordnung 5 und Ordnung 4. Unterscheiden sich die zwei um mehr als die **Toleranz**, war der Zeitschritt zu lang, und es versucht einen kürzeren.

Sieh dir **seinen Zeitschritt** an: fast 4&#x2009;Bilder weit draußen, weniger als ein halbes Bild in der Mitte. Die Toleranz gilt für einen Zeitschritt; unterwegs summieren sich die Fehler, darum fehlt nach 150&#x2009;Bildern mehr als 0,001&#x2009;px.</translation>
    </message>
    <message>
        <source>A bounce</source>
        <translation>Ein Aufprall</translation>
    </message>
    <message>
        <source>Between two bounces a ball flies a parabola, and Runge–Kutta 4 computes that **without any error**. But it is first at the floor after 30.66&#x2009;frames, in the middle of a step. The step ends in the floor, and only then the ball is put back. That mistake is as big as a step is long: **at a bounce every order is 1**.

Dormand–Prince looks back along its step, finds the moment of the touch, ends the step there, turns the velocity round, and goes on. This is called **event finding**.

With a bounce of 0.5 each flight takes half as long as the one before. Infinitely many fit into 92&#x2009;frames. So a ball that hardly leaves the floor is put to rest.</source>
        <translation>Zwischen zwei Aufprallen fliegt ein Ball eine Parabel, und Runge–Kutta 4 berechnet sie **ganz ohne Fehler**. Aber den Boden erreicht er zuerst nach 30,66&#x2009;Bildern, mitten in einem Zeitschritt. Der endet im Boden, und erst dann wird der Ball zurückgesetzt. Dieser Fehler ist so groß, wie ein Zeitschritt lang ist: **Bei einem Aufprall ist jede Ordnung 1**.

Dormand–Prince schaut seinen Zeitschritt entlang zurück, findet den Moment der Berührung, beendet den Zeitschritt dort, kehrt die Geschwindigkeit um und macht weiter. Das heißt **Ereignissuche**.

Bei einem Abprall von 0,5 dauert jeder Flug halb so lang wie der vorige. Unendlich viele passen in 92&#x2009;Bilder. Darum wird ein Ball, der sich kaum noch vom Boden löst, zur Ruhe gelegt.</translation>
    </message>
    <message>
        <source>The budget</source>
        <translation>Das Budget</translation>
    </message>
    <message>
        <source>No method is best. The question is: **how far off may it be, and what may it cost?** A game that moves 10&#x202f;000 creatures 60 times a second has 1.7&#x2009;µs for each, and more to do.

Here you may be 1&#x2009;px off, and spend **half a microsecond** a frame. The way you start with is cheap, and 15&#x2009;px off. Small steps of it are exact, and dear. Which method, with which step?

When you come to frame 200 the program compares your run with the exact one, and times it on this machine, several times over. Nothing else may be changed. On a busy machine it may need another try, so let it play on.

**Measure** (at the top), then **Show all methods**: click a mark to use it.</source>
        <translation>Kein Verfahren ist das beste. Die Frage ist: **Wie weit darf es daneben sein, und was darf es kosten?** Ein Spiel, das 10 000 Figuren 60-mal pro Sekunde bewegt, hat 1,7&#x202f;µs für jede, und noch mehr zu tun.

Hier darfst du 1&#x202f;px daneben sein und **eine halbe Mikrosekunde** pro Bild ausgeben. Der Anfang ist billig und 15&#x202f;px daneben. Kleine Zeitschritte davon sind genau, und teuer. Welches Verfahren, mit welchem Zeitschritt?

Bei Bild 200 vergleicht das Programm deinen Lauf mit dem exakten und misst mehrmals seine Zeit auf diesem Rechner. Sonst darf nichts geändert sein. Auf einem beschäftigten Rechner braucht es vielleicht noch einen Versuch, also lass es weiterlaufen.

**Messen** (ganz oben), dann **Alle Verfahren zeigen**: Klicke auf eine Marke, um sie zu verwenden.</translation>
    </message>
    <message>
        <source>A crowd</source>
        <translation>Eine Menge</translation>
    </message>
    <message>
        <source>**Twice as many creatures are twice the work.** They do not feel each other, so each is the same again: 6&#x2009;points, and 10&#x2009;pulls in every step. Such a cost is called **linear**. It is the best that one can hope for: were everybody to feel everybody, twice as many would be four times the work.

At 30&#x2009;frames a second there are 33&#x2009;ms for each frame. Where that is not enough, the run plays slower, and stays the same run.

Each **effect** in the list has its price, and one that is not in it costs nothing. Neither does one that can change nothing, as a gravity of 0: it is left out.

**Equal things lie side by side** in memory: all bodies, all first feet, all second feet. So the processor works on several creatures at once.</source>
        <translation>**Doppelt so viele Figuren sind doppelt so viel Arbeit.** Sie spüren einander nicht, also ist jede noch einmal dasselbe: 6 Punkte und 10 Züge in jedem Zeitschritt. Solche Kosten heißen **linear**. Besser kann man es nicht erhoffen: Würde jede jede spüren, wären doppelt so viele die vierfache Arbeit.

Bei 30&#x2009;Bildern pro Sekunde gibt es 33&#x2009;ms für jedes Bild. Wo das nicht reicht, läuft es langsamer ab und bleibt derselbe Lauf.

Jeder **Effekt** in der Liste hat seinen Preis, und einer, der nicht darin steht, kostet nichts. Ebenso einer, der nichts ändern kann, wie eine Schwerkraft von 0: Er wird weggelassen.

**Gleiches liegt nebeneinander** im Speicher: alle Körper, alle ersten Füße, alle zweiten Füße. So arbeitet der Prozessor an mehreren Figuren zugleich.</translation>
    </message>
    <message>
        <source>Choose **1/8&#x2009;frame** as step, and play to frame 100. How far is it off now?</source>
        <translation>Wähle **1/8 Bild** als Zeitschritt und spiele bis Bild 100. Wie weit ist er jetzt daneben?</translation>
    </message>
    <message>
        <source>Choose **2&#x2009;frames**. Wait until the foot is more than 100&#x2009;px off.</source>
        <translation>Wähle **2&#x2009;Bilder**. Warte, bis der Fuß mehr als 100&#x2009;px daneben ist.</translation>
    </message>
    <message>
        <source>With steps of 1&#x2009;frame, go to frame 0, set **k** to 0.02 and play to frame 100. A slow swing forgives a big step.</source>
        <translation>Geh mit Zeitschritten von 1 Bild zu Bild 0, setze **k** auf 0,02 und spiele bis Bild 100. Eine langsame Schwingung verzeiht einen großen Zeitschritt.</translation>
    </message>
    <message>
        <source>Choose **Explicit Euler** as method, and play until there is twice the energy: a drift of 100&#x2009;%.</source>
        <translation>Wähle **Explizites Euler** und spiele, bis es doppelt so viel Energie gibt: eine Drift von 100&#x2009;%.</translation>
    </message>
    <message>
        <source>Give it steps of **1/8&#x2009;frame**. Does a small step save it? Wait for a drift of 10&#x2009;%.</source>
        <translation>Gib ihm Zeitschritte von **1/8 Bild**. Rettet es ein kleiner Zeitschritt? Warte auf eine Drift von 10&#x2009;%.</translation>
    </message>
    <message>
        <source>Choose **Velocity Verlet** with steps of 1&#x2009;frame. Play 200&#x2009;frames: the drift stays within half a percent.</source>
        <translation>Wähle **Velocity-Verlet** mit Zeitschritten von 1 Bild. Spiele 200&#x2009;Bilder: Die Drift bleibt innerhalb eines halben Prozents.</translation>
    </message>
    <message>
        <source>**Midpoint**, the same two steps: a quarter?</source>
        <translation>**Mittelpunktsregel**, dieselben zwei Zeitschritte: ein Viertel?</translation>
    </message>
    <message>
        <source>**Runge–Kutta 4**, the same two steps: a sixteenth?</source>
        <translation>**Runge–Kutta 4**, dieselben zwei Zeitschritte: ein Sechzehntel?</translation>
    </message>
    <message>
        <source>Be less than 0.01&#x2009;px off at frame 60, with at most 16 computations a frame. (Any method; change nothing else.)</source>
        <translation>Sei bei Bild 60 weniger als 0,01&#x2009;px daneben, mit höchstens 16 Berechnungen pro Bild. (Jedes Verfahren; ändere sonst nichts.)</translation>
    </message>
    <message>
        <source>Choose a **tolerance** of 0.1&#x2009;px or more, and play to frame 150. Less work; how far off?</source>
        <translation>Wähle eine **Toleranz** von 0,1&#x2009;px oder mehr und spiele bis Bild 150. Weniger Arbeit; wie weit daneben?</translation>
    </message>
    <message>
        <source>**Runge–Kutta 4**: find a step with which it is less than 0.2&#x2009;px off at frame 150. What does it pay for a frame?</source>
        <translation>**Runge–Kutta 4**: Finde einen Zeitschritt, mit dem es bei Bild 150 weniger als 0,2&#x2009;px daneben ist. Was zahlt es pro Bild?</translation>
    </message>
    <message>
        <source>Halve the step of **Runge–Kutta 4** until it is 1/8&#x2009;frame, and play to frame 200. Order 4, or 1?</source>
        <translation>Halbiere den Zeitschritt von **Runge–Kutta 4** bis auf 1/8 Bild und spiele bis Bild 200. Ordnung 4 oder 1?</translation>
    </message>
    <message>
        <source>Choose **Dormand–Prince 5(4)**, and play to frame 200. How far off now?</source>
        <translation>Wähle **Dormand–Prince 5(4)** und spiele bis Bild 200. Wie weit jetzt daneben?</translation>
    </message>
    <message>
        <source>Keep it, go to frame 0 and set **bounce** to 0.5. Wait until the ball has stopped bouncing.</source>
        <translation>Behalte es, geh zu Bild 0 und setze **Abprall** auf 0,5. Warte, bis der Ball nicht mehr springt.</translation>
    </message>
    <message>
        <source>Be less than 1&#x2009;px off all the way to frame 200, at any price.</source>
        <translation>Sei den ganzen Weg bis Bild 200 weniger als 1&#x2009;px daneben, um jeden Preis.</translation>
    </message>
    <message>
        <source>Less than **1&#x2009;px** off, within **0.5&#x2009;µs** a frame. The machine checks both at frame 200.</source>
        <translation>Weniger als **1&#x2009;px** daneben, innerhalb von **0,5&#x2009;µs** pro Bild. Das Programm prüft beides bei Bild 200.</translation>
    </message>
    <message>
        <source>Less than **0.1&#x2009;px** off, within **1&#x2009;µs** a frame.</source>
        <translation>Weniger als **0,1&#x2009;px** daneben, innerhalb von **1&#x2009;µs** pro Bild.</translation>
    </message>
    <message>
        <source>Set **Bounce** to 0 and wait until all lie still.</source>
        <translation>Setze **Abprall** auf 0 und warte, bis alle still liegen.</translation>
    </message>
    <message>
        <source>A computed motion goes straight on within a step, so small steps follow a bend more closely, and cost more.</source>
        <translation>Eine berechnete Bewegung geht innerhalb eines Zeitschritts geradeaus, darum folgen kleine Zeitschritte einer Biegung genauer, und kosten mehr.</translation>
    </message>
    <message>
        <source>Choose **2&#x2009;frames** as step above the picture, press **Space**, and wait.</source>
        <translation>Wähle über der Szene **2&#x2009;Bilder** als Zeitschritt, drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Choose **1&#x2009;frame** as step. Press **Home**, type 0.02 beside **k**, press **Space**, and wait four seconds.</source>
        <translation>Wähle **1&#x2009;Bild** als Zeitschritt. Drück **Pos1**, gib neben **k** 0,02 ein, drück die **Leertaste** und warte vier Sekunden.</translation>
    </message>
    <message>
        <source>Above the picture, press **Step**, type 5 into the field **Other**, and press **Enter**. Then press **Space**.</source>
        <translation>Drück über der Szene **Zeitschritt**, gib im Feld **Andere** 5 ein und drück **Eingabe**. Drück dann die **Leertaste**.</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>small steps|smaller steps|once a step|each step|steps of</source>
        <translation>Zeitschritt|Zeitschritte|Zeitschritten|Zeitschritts</translation>
    </message>
    <message>
        <source>How far in time a method goes at once, in frames. A step of half a frame means two of them in each frame.</source>
        <translation>Wie viel Zeit ein Verfahren auf einmal geht, in Bildern. Ein Zeitschritt von einem halben Bild heißt: zwei davon in jedem Bild.</translation>
    </message>
    <message>
        <source>Exact motion</source>
        <translation>Exakte Bewegung</translation>
    </message>
    <message>
        <source>exact motion</source>
        <translation>exakte Bewegung|exakten Bewegung</translation>
    </message>
    <message>
        <source>What really would happen, without any steps: the dashed ring shows it.</source>
        <translation>Was wirklich geschehen würde, ganz ohne Zeitschritte: Der gestrichelte Ring zeigt es.</translation>
    </message>
    <message>
        <source>A method can make energy from nothing; one that moves by the new velocity does not, in the long run.</source>
        <translation>Ein Verfahren kann Energie aus dem Nichts machen; eines, das mit der neuen Geschwindigkeit bewegt, tut das auf Dauer nicht.</translation>
    </message>
    <message>
        <source>Above the picture, press **Method** and choose **Explicit Euler**. Press **Space** and watch the drift above the parameters.</source>
        <translation>Drück über der Szene **Verfahren** und wähle **Explizites Euler**. Drück die **Leertaste** und sieh dir die Drift über den Parametern an.</translation>
    </message>
    <message>
        <source>Choose **Explicit Euler** as method and **1/8&#x2009;frame** as step. Press **Space** and wait.</source>
        <translation>Wähle **Explizites Euler** als Verfahren und **1/8&#x2009;Bild** als Zeitschritt. Drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Choose **Velocity Verlet** as method and **1&#x2009;frame** as step. Press **Space**, and stop after frame 200.</source>
        <translation>Wähle **Velocity-Verlet** als Verfahren und **1&#x2009;Bild** als Zeitschritt. Drück die **Leertaste** und halte nach Bild 200 an.</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>What a stretched spring holds, and what moves holds: half of the square of its velocity. One turns into the other. Without damping the sum stays.</source>
        <translation>Was eine gespannte Feder enthält, und was Bewegtes enthält: die Hälfte vom Quadrat seiner Geschwindigkeit. Das eine wird zum anderen. Ohne Dämpfung bleibt die Summe.</translation>
    </message>
    <message>
        <source>drift</source>
        <translation>Drift</translation>
    </message>
    <message>
        <source>Energy that a method adds or loses by itself. The real motion has none.</source>
        <translation>Energie, die ein Verfahren von sich aus hinzufügt oder verliert. Die wirkliche Bewegung hat keine Drift.</translation>
    </message>
    <message>
        <source>Explicit Euler</source>
        <translation>Explizites Euler</translation>
    </message>
    <message>
        <source>The simplest method: everything moves by its old velocity, and is pulled from its old place. It gains energy in every swing.</source>
        <translation>Das einfachste Verfahren: Alles bewegt sich mit seiner alten Geschwindigkeit und wird von seinem alten Ort aus gezogen. Es gewinnt mit jeder Schwingung Energie.</translation>
    </message>
    <message>
        <source>Velocity Verlet</source>
        <translation>Velocity-Verlet</translation>
    </message>
    <message>
        <source>A method of order 2: half of the pull, then the move, then half of the new pull. Its steps can be taken back exactly.</source>
        <translation>Ein Verfahren der Ordnung 2: der halbe Zug, dann die Bewegung, dann die Hälfte des neuen Zugs. Seine Zeitschritte lassen sich genau zurücknehmen.</translation>
    </message>
    <message>
        <source>Why does Explicit Euler gain k h² in each step?</source>
        <translation>Warum gewinnt das explizite Euler-Verfahren in jedem Zeitschritt k h²?</translation>
    </message>
    <message>
        <source>The energy of one spring is half of

`E = v² + k x²`

Explicit Euler makes, with a step h,

`x → x + h v`

`v → v − h k x`

Put that into E. The parts with x × v cancel, and what is left is

`v² + k x² + h² k (v² + k x²)`

So E becomes E × (1 + k h²), wherever the foot is. At k = 0.02 and h = 1: 2&#x2009;% more in each step.</source>
        <translation>Die Energie einer Feder ist die Hälfte von

`E = v² + k x²`

Das explizite Euler-Verfahren macht mit einem Zeitschritt h

`x → x + h v`

`v → v − h k x`

Setze das in E ein. Die Teile mit x × v heben sich auf, und übrig bleibt

`v² + k x² + h² k (v² + k x²)`

Aus E wird also E × (1 + k h²), wo der Fuß auch ist. Bei k = 0,02 und h = 1: 2&#x2009;% mehr in jedem Zeitschritt.</translation>
    </message>
    <message>
        <source>The order of a method says what halving the step is worth.</source>
        <translation>Die Ordnung eines Verfahrens sagt, was das Halbieren des Zeitschritts wert ist.</translation>
    </message>
    <message>
        <source>Choose **1/8&#x2009;frame** as step, type 60 into the frame counter, and read how far off it is. Do the same with **1/16&#x2009;frame**.</source>
        <translation>Wähle **1/8&#x2009;Bild** als Zeitschritt, gib im Bildzähler 60 ein und lies ab, wie weit er daneben ist. Tu dasselbe mit **1/16&#x2009;Bild**.</translation>
    </message>
    <message>
        <source>Choose **Midpoint** as method, then **1/8** and **1/16&#x2009;frame** as step, and go to frame 60 each time.</source>
        <translation>Wähle **Mittelpunktsregel** als Verfahren, dann **1/8** und **1/16&#x2009;Bild** als Zeitschritt, und geh jedes Mal zu Bild 60.</translation>
    </message>
    <message>
        <source>Choose **Runge–Kutta 4** as method, then **1/8** and **1/16&#x2009;frame** as step, and go to frame 60 each time.</source>
        <translation>Wähle **Runge–Kutta 4** als Verfahren, dann **1/8** und **1/16&#x2009;Bild** als Zeitschritt, und geh jedes Mal zu Bild 60.</translation>
    </message>
    <message>
        <source>Runge–Kutta 4 computes four times in a step. In steps of 1/4&#x2009;frame that is 16 in a frame. Go to frame 60.</source>
        <translation>Runge–Kutta 4 rechnet in einem Zeitschritt viermal. Mit Zeitschritten von 1/4&#x2009;Bild sind das 16 Berechnungen pro Bild. Geh zu Bild 60.</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>order 1|order 2|order 4|a higher order|every order</source>
        <translation>Ordnung 1|Ordnung 2|Ordnung 4|Ordnung 5|höhere Ordnung|jede Ordnung|die Ordnung</translation>
    </message>
    <message>
        <source>What halving the step is worth: half of the error for order 1, a quarter for order 2, a sixteenth for order 4.</source>
        <translation>Was das Halbieren des Zeitschritts wert ist: der halbe Fehler bei Ordnung 1, ein Viertel bei Ordnung 2, ein Sechzehntel bei Ordnung 4.</translation>
    </message>
    <message>
        <source>Runge–Kutta 4</source>
        <translation>Runge–Kutta 4</translation>
    </message>
    <message>
        <source>A method of order 4. It asks for the forces four times in each step, and takes a mean of what it hears.</source>
        <translation>Ein Verfahren der Ordnung 4. Es fragt in jedem Zeitschritt viermal nach den Kräften und nimmt ein Mittel aus dem, was es hört.</translation>
    </message>
    <message>
        <source>Why a half, a quarter, a sixteenth?</source>
        <translation>Warum die Hälfte, ein Viertel, ein Sechzehntel?</translation>
    </message>
    <message>
        <source>Within a step the real motion bends, and a method bends only a little with it. What it misses in one step of length h grows like

`h × h` for order 1,

`h × h × h` for order 2,

and so on: one more h than its order. But a stretch of time needs 1/h steps, and their errors add up:

`h² × (1/h) = h`

One h is used up. So with order p the error over the whole stretch goes like

`h^p`

and half of h leaves 1/2, 1/4, 1/16 of it for p = 1, 2, 4.</source>
        <translation>Innerhalb eines Zeitschritts biegt sich die wirkliche Bewegung, und ein Verfahren biegt sich nur ein wenig mit. Was ihm in einem Zeitschritt der Länge h entgeht, wächst wie

`h × h` bei Ordnung 1,

`h × h × h` bei Ordnung 2,

und so weiter: ein h mehr als seine Ordnung. Aber eine Zeitspanne braucht 1/h Zeitschritte, und deren Fehler summieren sich:

`h² × (1/h) = h`

Ein h ist damit verbraucht. Bei Ordnung p geht der Fehler über die ganze Zeitspanne also wie

`h^p`

und das halbe h lässt davon 1/2, 1/4, 1/16 übrig, für p = 1, 2, 4.</translation>
    </message>
    <message>
        <source>A method that compares two answers can choose its own steps: long where little happens, short where much does.</source>
        <translation>Ein Verfahren, das zwei Antworten vergleicht, kann seine Zeitschritte selbst wählen: lang, wo wenig geschieht, kurz, wo viel geschieht.</translation>
    </message>
    <message>
        <source>Choose **Runge–Kutta 4** as method and **1/4&#x2009;frame** as step, type 150 into the frame counter, and read how far off it is.</source>
        <translation>Wähle **Runge–Kutta 4** als Verfahren und **1/4&#x2009;Bild** als Zeitschritt, gib im Bildzähler 150 ein und lies ab, wie weit er daneben ist.</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>The error that a method may make in one of its own steps, in pixels.</source>
        <translation>Der Fehler, den ein Verfahren in einem seiner eigenen Zeitschritte machen darf, in Pixeln.</translation>
    </message>
    <message>
        <source>Dormand–Prince</source>
        <translation>Dormand–Prince</translation>
    </message>
    <message>
        <source>A method that computes each step twice, with order 5 and order 4, and takes shorter steps where the two differ too much.</source>
        <translation>Ein Verfahren, das jeden Zeitschritt zweimal berechnet, mit Ordnung 5 und Ordnung 4, und kürzere Zeitschritte nimmt, wo sich die zwei zu sehr unterscheiden.</translation>
    </message>
    <message>
        <source>A bounce in the middle of a step spoils every order, unless the method looks for the very moment.</source>
        <translation>Ein Aufprall mitten in einem Zeitschritt verdirbt jede Ordnung, es sei denn, das Verfahren sucht genau diesen Moment.</translation>
    </message>
    <message>
        <source>Choose **1/8&#x2009;frame** as step, type 200 into the frame counter, and read how far off it is.</source>
        <translation>Wähle **1/8&#x2009;Bild** als Zeitschritt, gib im Bildzähler 200 ein und lies ab, wie weit er daneben ist.</translation>
    </message>
    <message>
        <source>Choose **Dormand–Prince 5(4)** as method, and type 200 into the frame counter.</source>
        <translation>Wähle **Dormand–Prince 5(4)** als Verfahren und gib im Bildzähler 200 ein.</translation>
    </message>
    <message>
        <source>Keep Dormand–Prince. Press **Home**, type 0.5 beside **Bounce**, press **Space**, and wait.</source>
        <translation>Behalte Dormand–Prince. Drück **Pos1**, gib neben **Abprall** 0,5 ein, drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>Event finding</source>
        <translation>Ereignissuche</translation>
    </message>
    <message>
        <source>event finding</source>
        <translation>Ereignissuche</translation>
    </message>
    <message>
        <source>To look back along a step for the moment at which something touched, and to end the step there.</source>
        <translation>Einen Zeitschritt entlang zurückschauen nach dem Moment, in dem etwas berührt wurde, und den Zeitschritt dort beenden.</translation>
    </message>
    <message>
        <source>No method is best: it depends on how far off it may be, and on what it may cost.</source>
        <translation>Kein Verfahren ist das beste: Es kommt darauf an, wie weit es daneben sein darf und was es kosten darf.</translation>
    </message>
    <message>
        <source>Choose **1/16&#x2009;frame** as step, and play to frame 200.</source>
        <translation>Wähle **1/16&#x2009;Bild** als Zeitschritt und spiele bis Bild 200.</translation>
    </message>
    <message>
        <source>Try **Velocity Verlet** with steps of 1/2&#x2009;frame, or **Runge–Kutta 4** with steps of 1&#x2009;frame. Play past frame 200 and let it play on for a moment.</source>
        <translation>Versuch **Velocity-Verlet** mit Zeitschritten von 1/2&#x2009;Bild, oder **Runge–Kutta 4** mit Zeitschritten von 1&#x2009;Bild. Spiele über Bild 200 hinaus und lass es einen Moment weiterlaufen.</translation>
    </message>
    <message>
        <source>Try **Runge–Kutta 4** with steps of 1/2&#x2009;frame. Play past frame 200 and let it play on for a moment.</source>
        <translation>Versuch **Runge–Kutta 4** mit Zeitschritten von 1/2&#x2009;Bild. Spiele über Bild 200 hinaus und lass es einen Moment weiterlaufen.</translation>
    </message>
    <message>
        <source>Twice as many are twice the work, and an effect that is not there costs nothing.</source>
        <translation>Doppelt so viele sind doppelt so viel Arbeit, und ein Effekt, der nicht da ist, kostet nichts.</translation>
    </message>
    <message>
        <source>Type 0 into the field beside **Gravity**, press **Space**, and wait two seconds.</source>
        <translation>Gib im Feld neben **Schwerkraft** 0 ein, drück die **Leertaste** und warte zwei Sekunden.</translation>
    </message>
    <message>
        <source>Type 0 into the field beside **Bounce**, press **Space**, and wait. Fewer creatures are sooner done.</source>
        <translation>Gib im Feld neben **Abprall** 0 ein, drück die **Leertaste** und warte. Mit weniger Figuren geht es schneller.</translation>
    </message>
    <message>
        <source>Effect</source>
        <translation>Effekt</translation>
    </message>
    <message>
        <source>effect|effects</source>
        <translation>Effekt|Effekte|Effekten</translation>
    </message>
    <message>
        <source>One thing that acts in a scene: springs, gravity, damping, walls. Only those that a scene lists cost time.</source>
        <translation>Etwas, das in einer Szene wirkt: Federn, Schwerkraft, Dämpfung, Wände. Nur was in der Liste einer Szene steht, kostet Zeit.</translation>
    </message>
    <message>
        <source>choose **1&#x2009;frame** as step.</source>
        <translation>wähle **1&#x2009;Bild** als Zeitschritt.</translation>
    </message>
    <message>
        <source>go to frame %2. This is frame %1.</source>
        <translation>geh zu Bild %2. Das hier ist Bild %1.</translation>
    </message>
    <message>
        <source>start the step afresh (**Ctrl+R**), and choose nothing but method and step.</source>
        <translation>beginne den Schritt neu (**Strg+R**) und wähle nichts als Verfahren und Zeitschritt.</translation>
    </message>
    <message>
        <source>try another method or step. This one is %1&#x2009;px off.</source>
        <translation>versuche ein anderes Verfahren oder einen anderen Zeitschritt. Es ist %1&#x2009;px daneben.</translation>
    </message>
    <message>
        <source>play on. The drift is %1&#x2009;%.</source>
        <translation>spiele weiter. Die Drift ist %1&#x2009;%.</translation>
    </message>
    <message>
        <source>3&#x2009;px, instead of 66&#x2009;px.</source>
        <translation>3&#x2009;px statt 66&#x2009;px.</translation>
    </message>
    <message>
        <source>play on. The foot is %1&#x2009;px off.</source>
        <translation>spiele weiter. Der Fuß ist %1&#x2009;px daneben.</translation>
    </message>
    <message>
        <source>set **k** at frame 0: press **Home**.</source>
        <translation>setze **k** bei Bild 0: Drück **Pos1**.</translation>
    </message>
    <message>
        <source>Type **5&#x2009;frames** as step. Now k h² is 5, more than 4: each swing throws it farther out. Wait until it is 1000&#x2009;px away.</source>
        <translation>Gib **5&#x2009;Bilder** als Zeitschritt ein. Jetzt ist k h² gleich 5, mehr als 4: Jede Schwingung wirft ihn weiter hinaus. Warte, bis er 1000&#x2009;px weit weg ist.</translation>
    </message>
    <message>
        <source>play on. The foot is %1&#x2009;px away.</source>
        <translation>spiele weiter. Der Fuß ist %1&#x2009;px weit weg.</translation>
    </message>
    <message>
        <source>choose **Explicit Euler** as method.</source>
        <translation>wähle **Explizites Euler** als Verfahren.</translation>
    </message>
    <message>
        <source>No. The energy grows more slowly, but it still grows, and never stops growing.</source>
        <translation>Nein. Die Energie wächst langsamer, aber sie wächst, und sie hört nie auf zu wachsen.</translation>
    </message>
    <message>
        <source>**Semi-implicit Euler**: go to frame 60 with steps of 1/16&#x2009;frame. Is it half as far off as with 1/8?</source>
        <translation>**Semi-implizites Euler**: Geh mit Zeitschritten von 1/16&#x2009;Bild zu Bild 60. Ist es halb so weit daneben wie mit 1/8?</translation>
    </message>
    <message>
        <source>choose **Semi-implicit Euler** as method.</source>
        <translation>wähle **Semi-implizites Euler** als Verfahren.</translation>
    </message>
    <message>
        <source>Nearly: 0.21&#x2009;px instead of 0.44&#x2009;px. Its order is 1.</source>
        <translation>Fast: 0,21&#x2009;px statt 0,44&#x2009;px. Seine Ordnung ist 1.</translation>
    </message>
    <message>
        <source>choose **Midpoint** as method.</source>
        <translation>wähle **Mittelpunktsregel** als Verfahren.</translation>
    </message>
    <message>
        <source>Yes: 0.21&#x2009;px instead of 0.84&#x2009;px. Its order is 2.</source>
        <translation>Ja: 0,21&#x2009;px statt 0,84&#x2009;px. Ihre Ordnung ist 2.</translation>
    </message>
    <message>
        <source>choose **Runge–Kutta 4** as method.</source>
        <translation>wähle **Runge–Kutta 4** als Verfahren.</translation>
    </message>
    <message>
        <source>Yes: 0.00003&#x2009;px instead of 0.0005&#x2009;px. Its order is 4.</source>
        <translation>Ja: 0,00003&#x2009;px statt 0,0005&#x2009;px. Seine Ordnung ist 4.</translation>
    </message>
    <message>
        <source>choose something cheaper. This needs %1 computations a frame.</source>
        <translation>wähle etwas Billigeres. Das braucht %1 Berechnungen pro Bild.</translation>
    </message>
    <message>
        <source>About 23&#x2009;px. The tolerance is for one step, and the errors of all steps add up.</source>
        <translation>Etwa 23&#x2009;px. Die Toleranz gilt für einen Zeitschritt, und die Fehler aller Zeitschritte summieren sich.</translation>
    </message>
    <message>
        <source>Throw the foot, at 5&#x2009;px per frame or more, past the middle, within 10&#x2009;px of it. Watch its steps get shorter than 1&#x2009;frame.</source>
        <translation>Wirf den Fuß, mit 5&#x2009;px pro Bild oder mehr, an der Mitte vorbei, innerhalb von 10&#x2009;px. Sieh zu, wie seine Zeitschritte kürzer als 1&#x2009;Bild werden.</translation>
    </message>
    <message>
        <source>choose **Dormand–Prince 5(4)** as method.</source>
        <translation>wähle **Dormand–Prince 5(4)** als Verfahren.</translation>
    </message>
    <message>
        <source>it has to pass the middle within 10&#x2009;px. Throw it closer by.</source>
        <translation>er muss innerhalb von 10&#x2009;px an der Mitte vorbei. Wirf ihn näher daran vorbei.</translation>
    </message>
    <message>
        <source>16 computations of all forces: four for each step of 1/4&#x2009;frame. Far out it would not need them.</source>
        <translation>16 Berechnungen aller Kräfte: vier für jeden Zeitschritt von 1/4&#x2009;Bild. Weit draußen bräuchte es sie nicht.</translation>
    </message>
    <message>
        <source>By less than a millionth of a pixel: it ends a step at the very moment of each touch.</source>
        <translation>Weniger als ein Millionstel Pixel: Es beendet einen Zeitschritt genau im Moment jeder Berührung.</translation>
    </message>
    <message>
        <source>play on until the ball lies on the floor.</source>
        <translation>spiele weiter, bis der Ball am Boden liegt.</translation>
    </message>
    <message>
        <source>Set **Creatures** to 20&#x2009;000 and play on for 60&#x2009;frames. Does a frame take twice as long as with 10&#x2009;000?</source>
        <translation>Setze **Figuren** auf 20&#x2009;000 und spiele 60&#x2009;Bilder weiter. Dauert ein Bild doppelt so lang wie mit 10&#x2009;000?</translation>
    </message>
    <message>
        <source>About twice: each creature costs the same. It is more where the machine’s cache no longer holds all of them.</source>
        <translation>Etwa doppelt: Jede Figur kostet dasselbe. Mehr ist es, wo der Cache des Rechners nicht mehr alle fasst.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until nothing moves.</source>
        <translation>lass die Zeit laufen (**Leertaste**), bis sich nichts mehr bewegt.</translation>
    </message>
    <message>
        <source>set **k** back to 0.2.</source>
        <translation>setze **k** zurück auf 0,2.</translation>
    </message>
    <message>
        <source>Above the picture, press **Step** and choose **1/8&#x2009;frame**. Click the number beside **Frame**, type 100, and press **Enter**. How far off it is stands above the parameters.</source>
        <translation>Drück über der Szene **Zeitschritt** und wähle **1/8&#x2009;Bild**. Klicke die Zahl neben **Bild** an, gib 100 ein und drück **Eingabe**. Wie weit es daneben liegt, steht über den Parametern.</translation>
    </message>
    <message>
        <source>Above the picture, press **Tolerance** and choose **0.1&#x2009;px**. Then type 150 into the frame counter.</source>
        <translation>Drück über der Szene **Toleranz** und wähle **0,1&#x2009;px**. Gib dann im Bildzähler 150 ein.</translation>
    </message>
    <message>
        <source>Press **Tolerance** and choose **0.001&#x2009;px**, then press **Home**. Take the foot and throw it so that it just passes the dot in the middle.</source>
        <translation>Drück **Toleranz** und wähle **0,001&#x2009;px**, dann drück **Pos1**. Nimm den Fuß und wirf ihn so, dass er knapp am Punkt in der Mitte vorbeifliegt.</translation>
    </message>
    <message>
        <source>its step there is %1 frames long: choose a **tolerance** of 0.001&#x2009;px.</source>
        <translation>sein Zeitschritt ist dort %1 Bilder lang: Wähle eine **Toleranz** von 0,001&#x2009;px.</translation>
    </message>
    <message>
        <source>Order 1: from 1/4&#x2009;frame to 1/8&#x2009;frame, the error falls from 24 to 15&#x2009;px, not to a sixteenth.</source>
        <translation>Ordnung 1: Von 1/4&#x2009;Bild zu 1/8&#x2009;Bild fällt der Fehler von 24 auf 15&#x2009;px, nicht auf ein Sechzehntel.</translation>
    </message>
    <message>
        <source>Type 10000 into the field beside **Creatures**, press **Space**, and wait a moment. Then type 20000, and wait again. The panel Effects (**Ctrl+4**) tells how long a frame takes.</source>
        <translation>Gib im Feld neben **Figuren** 10000 ein, drück die **Leertaste** und warte einen Moment. Gib dann 20000 ein und warte noch einmal. Das Feld Effekte (**Strg+4**) sagt, wie lange ein Bild dauert.</translation>
    </message>
    <message>
        <source>Set **Gravity** to 0 and play on for 60&#x2009;frames. It is left out now: its phase is gone from the strip below.</source>
        <translation>Setze **Schwerkraft** auf 0 und spiele 60&#x2009;Bilder weiter. Jetzt ist sie weggelassen: Ihre Phase fehlt im Streifen darunter.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>How far off a computed motion is, and what it costs to be nearer.</source>
        <translation>Wie weit eine berechnete Bewegung daneben ist und was es kostet, näher heranzukommen.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>ball</source>
        <translation>Ball</translation>
    </message>
</context>
</TS>
