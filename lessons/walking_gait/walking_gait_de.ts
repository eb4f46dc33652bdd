<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>WalkingGait</name>
    <message>
        <source>Centipede</source>
        <translation>Tausendfüßler</translation>
    </message>
    <message>
        <source>Twelve feet, one after the other: the body glides.</source>
        <translation>Zwölf Füße, einer nach dem anderen: Der Körper gleitet.</translation>
    </message>
    <message>
        <source>Trot</source>
        <translation>Trab</translation>
    </message>
    <message>
        <source>Four feet in two pairs: it bobs like one with two feet.</source>
        <translation>Vier Füße in zwei Paaren: Sie wippt wie eine Figur mit zwei Füßen.</translation>
    </message>
    <message>
        <source>Limp</source>
        <translation>Humpeln</translation>
    </message>
    <message>
        <source>Three feet close behind each other, then a pause.</source>
        <translation>Drei Füße dicht hintereinander, dann eine Pause.</translation>
    </message>
    <message>
        <source>Runner</source>
        <translation>Läufer</translation>
    </message>
    <message>
        <source>A fast clock: no foot touches the ground for long.</source>
        <translation>Eine schnelle Uhr: Kein Fuß berührt den Boden lang.</translation>
    </message>
    <message>
        <source>More feet</source>
        <translation>Mehr Füße</translation>
    </message>
    <message>
        <source>More feet need no new code: the loop gives each an angle, and they share the clock. Foot i of n belongs i/n of a full turn behind foot 0. **spread** makes that more or less than a full turn.

Two feet carry the body up and down by 55&#x202f;px. With five it is 4&#x202f;px, with twelve 1&#x202f;px: some foot is always on its way down. They walk faster, too, 1.4&#x202f;px a frame instead of 1.2.

At a spread of 0 all step together. The body falls and rises, and it gets nowhere.</source>
        <translation>Mehr Füße brauchen keinen neuen Code: Die Schleife gibt jedem einen Winkel, und sie teilen sich die Uhr. Fuß i von n gehört i/n einer ganzen Drehung hinter Fuß 0. **Verteilung** macht daraus mehr oder weniger als eine ganze Drehung.

Zwei Füße tragen den Körper um 55&#x202f;px auf und ab. Bei fünf sind es 4&#x202f;px, bei zwölf 1&#x202f;px: Irgendein Fuß ist immer auf dem Weg nach unten. Sie gehen auch schneller, 1,4&#x202f;px pro Bild statt 1,2.

Bei einer Verteilung von 0 treten alle zugleich auf. Der Körper fällt und steigt und kommt nicht vom Fleck.</translation>
    </message>
    <message>
        <source>Steering</source>
        <translation>Lenken</translation>
    </message>
    <message>
        <source>The clock&apos;s speed is a number like any other, so it can change while the creature walks. Above 0 it walks right, below 0 left, at 0 it stands.

**Arrow keys**, while it plays: each frame that → is down adds **change** to the speed, ← takes as much away.

**Pointer:** while its button is down it sets the speed: 200&#x202f;px to the right of the body ask for **top speed**, half as far for half of it, and to the left it is negative.

Neither gets past the top speed, 0.15 either way. Let go, and the creature keeps the speed that it has.</source>
        <translation>Das Tempo der Uhr ist eine Zahl wie jede andere, also kann es sich ändern, während die Figur geht. Über 0 geht sie nach rechts, unter 0 nach links, bei 0 steht sie.

**Pfeiltasten**, solange es läuft: In jedem Bild, in dem → gedrückt ist, kommt **Änderung** zum Tempo hinzu, ← nimmt ebenso viel weg.

**Zeiger:** Solange seine Taste gedrückt ist, bestimmt er das Tempo: 200&#x202f;px rechts vom Körper verlangen **Höchsttempo**, halb so weit die Hälfte davon, und links ist es negativ.

Keines von beiden kommt über das Höchsttempo hinaus, 0,15 in jeder Richtung. Lass los, und die Figur behält das Tempo, das sie hat.</translation>
    </message>
    <message>
        <source>Walls to bump into</source>
        <translation>Wände zum Anstoßen</translation>
    </message>
    <message>
        <source>Two walls, as in the lesson before, for feet and body. Where an edge is past a wall, it is put back, and the velocity across the wall becomes 0.

The creature **turns round** when any part of it touches a wall: the clock&apos;s speed gets the sign that leads away. It is a rule, not a force: the wall only stops what hits it. With **at wall** on *walk on* it walks against the wall for good. Its standing feet then slip 1.1&#x202f;px a frame, more than twice as much as on its way.

You can steer it, as before: with the arrow keys, or with the pointer while its button is down.</source>
        <translation>Zwei Wände, wie in der Lektion davor, für Füße und Körper. Wo ein Rand über eine Wand hinaus ist, wird er zurückgesetzt, und die Geschwindigkeit quer zur Wand wird 0.

Die Figur **kehrt um**, wenn irgendein Teil von ihr eine Wand berührt: Das Tempo der Uhr bekommt das Vorzeichen, das wegführt. Das ist eine Regel, keine Kraft: Die Wand hält nur an, was sie trifft. Steht **An einer Wand** auf *weitergehen*, geht sie endlos gegen die Wand. Ihre stehenden Füße rutschen dann 1,1&#x202f;px pro Bild, mehr als doppelt so viel wie unterwegs.

Lenken kannst du sie wie zuvor: mit den Pfeiltasten oder mit dem Zeiger, solange seine Taste gedrückt ist.</translation>
    </message>
    <message>
        <source>Company</source>
        <translation>Gesellschaft</translation>
    </message>
    <message>
        <source>Several creatures, each with its own clock. They start towards each other, out of step.

Two bodies closer than **distance** push each other apart, by **push** times the missing distance: a spring that never pulls. Legs meet nothing.

Each push is felt by **both**, the opposite way, in the same moment. So all pushes add up to 0, and two creatures that meet share their momentum out anew; the push makes none and loses none. (The ground does: it stops feet.) With **felt by** on one, the second feels nothing. Then each push makes momentum from nothing.</source>
        <translation>Mehrere Figuren, jede mit eigener Uhr. Sie starten aufeinander zu, nicht im Takt.

Zwei Körper, die sich näher als **Abstand** sind, schieben einander weg, um **Abstoßung** mal das, was fehlt: eine Feder, die nie zieht. Beine treffen auf nichts.

Jedes Abstoßen spüren **beide**, in entgegengesetzter Richtung, im selben Moment. Darum ergibt alles Abstoßen zusammen 0, und zwei Figuren, die sich treffen, teilen ihren Impuls neu auf; das Abstoßen macht keinen und verliert keinen. (Der Boden schon: Er hält Füße an.) Steht **Gespürt von** auf *einem*, spürt der zweite nichts. Dann macht jedes Abstoßen Impuls aus dem Nichts.</translation>
    </message>
    <message>
        <source>Set **traction** to none for 150&#x202f;frames: ice. It treads on the spot.</source>
        <translation>Setze **Haftung** 150&#x202f;Bilder lang auf keine: Eis. Sie tritt auf der Stelle.</translation>
    </message>
    <message>
        <source>Set **bounce** to 0.8 and stop just when a foot bounces.</source>
        <translation>Setze **Abprall** auf 0,8 und halte genau dann an, wenn ein Fuß abprallt.</translation>
    </message>
    <message>
        <source>Set **feet** to 12 and watch for 200&#x202f;frames. How much does the body go up and down?</source>
        <translation>Setze **Füße** auf 12 und sieh 200&#x202f;Bilder lang zu. Wie weit geht der Körper auf und ab?</translation>
    </message>
    <message>
        <source>Set **spread** to 0 for 200&#x202f;frames. All feet step together: does it get anywhere?</source>
        <translation>Setze **Verteilung** 200&#x202f;Bilder lang auf 0. Alle Füße treten zugleich auf: Kommt sie vom Fleck?</translation>
    </message>
    <message>
        <source>Make it as fast as it can with the pointer: hold the button at least 200&#x202f;px away from it.</source>
        <translation>Mach sie mit dem Zeiger so schnell wie möglich: Halte die Taste mindestens 200&#x202f;px von ihr entfernt.</translation>
    </message>
    <message>
        <source>Make it stand: bring the clock to within 0.005&#x202f;rad/frame of 0.</source>
        <translation>Bring sie zum Stehen: Die Uhr muss bis auf 0,005 rad/Bild an 0 heran.</translation>
    </message>
    <message>
        <source>Put the walls 150&#x202f;px apart or closer, and see it turn to the left.</source>
        <translation>Stelle die Wände 150&#x202f;px oder enger auseinander und sieh, wie sie nach links umkehrt.</translation>
    </message>
    <message>
        <source>Set **felt by** to one, and look at the sum of the pushes while two bodies touch.</source>
        <translation>Stelle **Gespürt von** auf *einem* und sieh dir die Summe allen Abstoßens an, während zwei Körper sich berühren.</translation>
    </message>
    <message>
        <source>Set **creatures** to 5 and watch the crowd for 300&#x202f;frames.</source>
        <translation>Setze **Figuren** auf 5 und sieh der Menge 300&#x202f;Bilder lang zu.</translation>
    </message>
    <message>
        <source>Swing</source>
        <translation>Schwung</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>How far foot 0 is from the middle of its places. The leg is what it would be if it followed exactly.</source>
        <translation>Wie weit Fuß 0 von der Mitte seiner Orte entfernt ist. Das Bein ist, was es wäre, wenn er genau folgte.</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Impuls</translation>
    </message>
    <message>
        <source>px/frame</source>
        <translation>px/Bild</translation>
    </message>
    <message>
        <source>All velocities added up; how long that arrow is. Every mass is 1.</source>
        <translation>Alle Geschwindigkeiten addiert; wie lang dieser Pfeil ist. Jede Masse ist 1.</translation>
    </message>
    <message>
        <source>Walks</source>
        <translation>Geht</translation>
    </message>
    <message>
        <source>How far the body came to the right in the last frame.</source>
        <translation>Wie weit der Körper im letzten Bild nach rechts kam.</translation>
    </message>
    <message>
        <source>Slip</source>
        <translation>Rutschen</translation>
    </message>
    <message>
        <source>How far the standing feet slid in the last frame, on the average.</source>
        <translation>Wie weit die stehenden Füße im letzten Bild im Mittel gerutscht sind.</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>rad/frame</source>
        <translation>rad/Bild</translation>
    </message>
    <message>
        <source>How fast the gait clock turns.</source>
        <translation>Wie schnell sich die Ganguhr dreht.</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Abstoßen</translation>
    </message>
    <message>
        <source>px/frame²</source>
        <translation>px/Bild²</translation>
    </message>
    <message>
        <source>All pushes between bodies added up; how long that arrow is.</source>
        <translation>Alles Abstoßen zwischen Körpern addiert; wie lang dieser Pfeil ist.</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Bein</translation>
    </message>
    <message>
        <source>How far a foot belongs from the middle of its places.</source>
        <translation>Wie weit ein Fuß von der Mitte seiner Orte entfernt hingehört.</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Absenkung</translation>
    </message>
    <message>
        <source>How far below the body the feet belong.</source>
        <translation>Wie weit unter den Körper die Füße gehören.</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Bogen</translation>
    </message>
    <message>
        <source>How high above its foot the point lies that bends a leg. Only drawn.</source>
        <translation>Wie hoch über seinem Fuß der Punkt liegt, der ein Bein biegt. Nur gezeichnet.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>How far the gait clock turns each frame. Below 0 it turns the other way.</source>
        <translation>Wie weit sich die Ganguhr in jedem Bild dreht. Unter 0 dreht sie sich andersherum.</translation>
    </message>
    <message>
        <source>The share of its speed that a foot keeps, turned round, on the ground.</source>
        <translation>Der Anteil seines Tempos, den ein Fuß, umgekehrt, am Boden behält.</translation>
    </message>
    <message>
        <source>Traction</source>
        <translation>Haftung</translation>
    </message>
    <message>
        <source>Whether the ground stops a foot sideways, too. Without it is ice.</source>
        <translation>Ob der Boden einen Fuß auch seitwärts anhält. Ohne sie ist er wie Eis.</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Füße</translation>
    </message>
    <message>
        <source>How many feet the body has.</source>
        <translation>Wie viele Füße der Körper hat.</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Over how much of a turn the feet are spread. At 0 all step together.</source>
        <translation>Über wie viel einer Drehung die Füße verteilt sind. Bei 0 treten alle zugleich auf.</translation>
    </message>
    <message>
        <source>Top speed</source>
        <translation>Höchsttempo</translation>
    </message>
    <message>
        <source>The fastest that keys and pointer make the gait clock.</source>
        <translation>Das schnellste Tempo, das Tasten und Zeiger der Ganguhr geben.</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Änderung</translation>
    </message>
    <message>
        <source>rad/frame²</source>
        <translation>rad/Bild²</translation>
    </message>
    <message>
        <source>How much speed an arrow key adds or takes away, each frame that it is down.</source>
        <translation>Wie viel Tempo eine Pfeiltaste hinzufügt oder wegnimmt, in jedem Bild, in dem sie gedrückt ist.</translation>
    </message>
    <message>
        <source>At a wall</source>
        <translation>An einer Wand</translation>
    </message>
    <message>
        <source>Whether it turns round where it bumps into a wall, or walks on.</source>
        <translation>Ob sie umkehrt, wo sie an eine Wand stößt, oder weitergeht.</translation>
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
        <source>Push</source>
        <translation>Abstoßung</translation>
    </message>
    <message>
        <source>1/frame²</source>
        <translation>1/Bild²</translation>
    </message>
    <message>
        <source>How hard two bodies push: this share of the missing distance, each frame.</source>
        <translation>Wie stark zwei Körper schieben: dieser Anteil des fehlenden Abstands, in jedem Bild.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Two bodies closer than this push each other.</source>
        <translation>Zwei Körper, die sich näher sind, schieben einander weg.</translation>
    </message>
    <message>
        <source>Felt by</source>
        <translation>Gespürt von</translation>
    </message>
    <message>
        <source>Whether both bodies feel a push, or only the one that comes first.</source>
        <translation>Ob beide Körper das Abstoßen spüren oder nur der, der zuerst kommt.</translation>
    </message>
    <message>
        <source>foot %1</source>
        <translation>Fuß %1</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Bones</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Until now a foot was content anywhere on a ring round the body: a rag doll. Now each foot has a **bone**: an angle of its own. It belongs **leg** pixels from the body at that angle, and a plain spring pulls it there. A cross shows the place.

Angles are in radians. Foot 0 has the angle 0; foot 1 has π, half a turn on. The code **subtracts** the bone from the body, so foot 0 belongs on the **left**.

(The tutorial behind this lesson says right, and in one passage that the leg is 75&#x202f;px. Its code has left and 50, and its code is what runs here.)

The body is a handle again: only your hand moves it.</source>
        <translation>Bisher war ein Fuß überall auf einem Ring um den Körper zufrieden: eine Stoffpuppe. Jetzt hat jeder Fuß einen **Knochen**: einen eigenen Winkel. Sein Platz ist **Bein** Pixel vom Körper entfernt, in diesem Winkel, und eine einfache Feder zieht ihn dorthin. Ein Kreuz zeigt den Ort.

Winkel sind in Radiant. Fuß 0 hat den Winkel 0; Fuß 1 hat π, eine halbe Drehung weiter. Der Code zieht den Knochen vom Körper **ab**, darum gehört Fuß 0 nach **links**.

(Das Tutorial, auf dem diese Lektion beruht, sagt rechts, und an einer Stelle, das Bein sei 75&#x202f;px lang. Sein Code hat links und 50, und sein Code ist, was hier läuft.)

Der Körper ist wieder ein Griff: Nur deine Hand bewegt ihn.</translation>
    </message>
    <message>
        <source>Legs</source>
        <translation>Beine</translation>
    </message>
    <message>
        <source>Feet below the body</source>
        <translation>Füße unten</translation>
    </message>
    <message>
        <source>Feet belong below a body. One number does it: **drop** moves the place of every foot straight down, by 50&#x202f;px. (y points down, so it is added.)

It comes after the bone: it does not turn with the leg&apos;s angle, and is the same for all feet.

Each place is now 50&#x202f;px to the side and 50&#x202f;px down: 70.7&#x202f;px from the body. The feet start in their places, so nothing moves until you move something.</source>
        <translation>Füße gehören unter einen Körper. Eine Zahl genügt: **Absenkung** schiebt den Ort jedes Fußes gerade nach unten, um 50&#x202f;px. (y zeigt nach unten, darum wird sie addiert.)

Sie kommt nach dem Knochen: Sie dreht sich nicht mit dem Winkel des Beins und ist für alle Füße gleich.

Jeder Ort ist jetzt 50&#x202f;px seitlich und 50&#x202f;px unten: 70,7&#x202f;px vom Körper. Die Füße beginnen an ihren Orten, darum bewegt sich nichts, bis du etwas bewegst.</translation>
    </message>
    <message>
        <source>Curved legs</source>
        <translation>Gebogene Beine</translation>
    </message>
    <message>
        <source>Two straight twigs are no legs. A **curve** needs one more point: the cross above each foot, **curve** pixels up. The leg leaves the foot towards that point and comes to the body from there. Halfway it is a quarter of the way to the foot, a quarter to the body, and half to the cross.

The point is only drawn. The springs do not know of it, so the run is the same for every curve: the ghost proves it.</source>
        <translation>Zwei gerade Stöcke sind keine Beine. Eine **Kurve** braucht noch einen Punkt: das Kreuz über jedem Fuß, **Bogen** Pixel darüber. Das Bein verlässt den Fuß auf diesen Punkt zu und kommt von dort zum Körper. Auf halbem Weg ist es ein Viertel des Wegs zum Fuß, ein Viertel zum Körper und die Hälfte zum Kreuz.

Der Punkt ist nur gezeichnet. Die Federn wissen nichts von ihm, darum ist der Lauf für jede Kurve derselbe: Der Geist beweist es.</translation>
    </message>
    <message>
        <source>Now the places move. The creature gets **one clock** that turns by **speed** each frame, last of all. Every foot adds it to its own angle. So the places go round, clockwise, half a turn apart, and each foot runs after its place.

At 0.05&#x202f;rad a frame a full turn (2π, 6.28&#x202f;rad) takes 126&#x202f;frames.

A foot is on a spring: it doesn&apos;t follow exactly. At this speed it goes round on 50.6&#x202f;px where its place is 50&#x202f;px out. Near the speed at which it would swing by itself, it goes much farther.</source>
        <translation>Jetzt bewegen sich die Orte. Die Figur bekommt **eine Uhr**, die sich in jedem Bild um **Tempo** dreht, als Letztes von allem. Jeder Fuß addiert sie zu seinem eigenen Winkel. So gehen die Orte im Kreis, im Uhrzeigersinn, eine halbe Drehung auseinander, und jeder Fuß läuft seinem Ort nach.

Bei 0,05 rad pro Bild dauert eine ganze Drehung (2π, 6,28 rad) 126&#x202f;Bilder.

Ein Fuß hängt an einer Feder: Er folgt nicht genau. Bei diesem Tempo kreist er auf 50,6&#x202f;px, wo sein Ort 50&#x202f;px draußen ist. Nahe dem Tempo, mit dem er von selbst schwingen würde, kommt er viel weiter hinaus.</translation>
    </message>
    <message>
        <source>The body is pulled, too</source>
        <translation>Zug auch am Körper</translation>
    </message>
    <message>
        <source>What pulls is pulled back, just as hard, the other way. That needs no new formula: each leg&apos;s pull goes onto its foot, and the **opposite** goes onto the body, in the same moment.

So what the feet gain, the body loses. All velocities added up are the **momentum**, and no leg can change it. Only damping takes from it, and your hand.

Let it run: the legs pull the body left and right just as hard at every moment. It stays where it is. Legs alone get nowhere: there must be something to stand on.</source>
        <translation>Was zieht, wird auch selbst gezogen, genauso stark, in die andere Richtung. Das braucht keine neue Formel: Der Zug jedes Beins geht auf seinen Fuß, und das **Entgegengesetzte** geht auf den Körper, im selben Moment.

Was die Füße gewinnen, verliert also der Körper. Alle Geschwindigkeiten addiert sind der **Impuls**, und kein Bein kann ihn ändern. Nur die Dämpfung nimmt davon, und deine Hand.

Lass es laufen: Die Beine ziehen den Körper in jedem Moment genauso stark nach links wie nach rechts. Er bleibt, wo er ist. Beine allein kommen nirgendwohin: Es muss etwas geben, worauf man steht.</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Gravity pulls everything down, and the **ground** holds the feet. Only the feet: they hold the body. A foot below the ground is put back onto it, and its velocity becomes 0, sideways, too. That is its **traction**.

Now the foot stands. Its leg still pulls, and only the body can give way: it walks, about 150&#x202f;px in each turn of the clock. A negative **speed** walks left. Without traction it treads on the spot.

A standing foot is stopped **after** it moved. So it slips a little in each frame, 0.4&#x202f;px on the average. In steps of half a frame it slips 0.25&#x202f;px, and walks 1.4&#x202f;px a frame instead of 1.2.

From here on k is 0.1.</source>
        <translation>Die Schwerkraft zieht alles nach unten, und der **Boden** hält die Füße. Nur die Füße: Sie halten den Körper. Ein Fuß unter dem Boden wird darauf zurückgesetzt, und seine Geschwindigkeit wird 0, auch seitwärts. Das ist seine **Haftung**.

Jetzt steht der Fuß. Sein Bein zieht weiter, und nur der Körper kann nachgeben: Er geht, etwa 150&#x202f;px in jeder Drehung der Uhr. Ein negatives **Tempo** geht nach links. Ohne Haftung tritt er auf der Stelle.

Ein stehender Fuß wird angehalten, **nachdem** er sich bewegt hat. Darum rutscht er in jedem Bild ein wenig, im Mittel 0,4&#x202f;px. Mit Zeitschritten von einem halben Bild rutscht er 0,25&#x202f;px, und geht 1,4&#x202f;px pro Bild statt 1,2.

Von hier an ist k 0,1.</translation>
    </message>
    <message>
        <source>Stop inside a frame (**Shift+→**) when the springs have pulled and nothing has moved.</source>
        <translation>Halte innerhalb eines Bildes an (**Umschalt+→**), wenn die Federn gezogen haben und sich nichts bewegt hat.</translation>
    </message>
    <message>
        <source>Set **leg** to 100 and wait until all is still. How long are the lines?</source>
        <translation>Setze **Bein** auf 100 und warte, bis alles still ist. Wie lang sind die Linien?</translation>
    </message>
    <message>
        <source>Set **drop** to 0, as it was before, and wait until all is still.</source>
        <translation>Setze **Absenkung** auf 0, wie es vorher war, und warte, bis alles still ist.</translation>
    </message>
    <message>
        <source>Set **drop** so that the feet belong above the body, and wait until all is still.</source>
        <translation>Setze **Absenkung** so, dass die Füße über den Körper gehören, und warte, bis alles still ist.</translation>
    </message>
    <message>
        <source>Set **curve** to 0. What do the legs look like?</source>
        <translation>Setze **Bogen** auf 0. Wie sehen die Beine aus?</translation>
    </message>
    <message>
        <source>Carry the body, go back in time, change **curve**, and compare with the ghost: the run is the same.</source>
        <translation>Trag den Körper, geh in der Zeit zurück, ändere **Bogen** und vergleiche mit dem Geist: Der Lauf ist derselbe.</translation>
    </message>
    <message>
        <source>Set **curve** below 0.</source>
        <translation>Setze **Bogen** unter 0.</translation>
    </message>
    <message>
        <source>Set **speed** to −0.05 for at least 60&#x202f;frames. Which way do the feet go round now?</source>
        <translation>Setze **Tempo** für mindestens 60&#x202f;Bilder auf −0,05. In welche Richtung kreisen die Füße jetzt?</translation>
    </message>
    <message>
        <source>Hold a foot for 60&#x202f;frames. It feels nothing, but the body still feels its leg.</source>
        <translation>Halte einen Fuß 60&#x202f;Bilder lang. Er spürt nichts, aber der Körper spürt noch immer sein Bein.</translation>
    </message>
    <message>
        <source>full</source>
        <translation>voll</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>umkehren</translation>
    </message>
    <message>
        <source>walk on</source>
        <translation>weitergehen</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beiden</translation>
    </message>
    <message>
        <source>one</source>
        <translation>einem</translation>
    </message>
    <message>
        <source>Press **Space**, take the large disc, and carry it slowly to one side of the picture.</source>
        <translation>Drück die **Leertaste**, nimm die große Scheibe und trag sie langsam zu einer Seite der Szene.</translation>
    </message>
    <message>
        <source>A bone gives each foot an angle of its own: one place, and not a ring of places.</source>
        <translation>Ein Knochen gibt jedem Fuß einen eigenen Winkel: einen Ort, und nicht einen Ring von Orten.</translation>
    </message>
    <message>
        <source>Press **Space**. Take the small disc on the left, carry it past the body to the right, let go, and wait.</source>
        <translation>Drück die **Leertaste**. Nimm die kleine Scheibe links, trag sie am Körper vorbei nach rechts, lass los und warte.</translation>
    </message>
    <message>
        <source>Stop, and press **Shift+→** once: the springs come first.</source>
        <translation>Halte an und drück einmal **Umschalt+→**: Die Federn kommen zuerst.</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>bone|bones</source>
        <translation>Knochen|Knochens</translation>
    </message>
    <message>
        <source>An angle that belongs to a foot: it says on which side of the body the foot has its place.</source>
        <translation>Ein Winkel, der zu einem Fuß gehört: Er sagt, auf welcher Seite des Körpers der Fuß seinen Ort hat.</translation>
    </message>
    <message>
        <source>A leg is a line that is drawn anew for each picture; nothing feels it.</source>
        <translation>Ein Bein ist eine Linie, die für jedes Bild neu gezeichnet wird; nichts spürt sie.</translation>
    </message>
    <message>
        <source>Type 100 into the field beside **Leg**, press **Space**, and wait.</source>
        <translation>Gib 100 in das Feld neben **Bein** ein, drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>One number that is added to y moves all places below the body.</source>
        <translation>Eine Zahl, die zu y addiert wird, schiebt alle Orte unter den Körper.</translation>
    </message>
    <message>
        <source>Type 0 into the field beside **Drop**, press **Space**, and wait.</source>
        <translation>Gib 0 in das Feld neben **Absenkung** ein, drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>y points down, so above the body is below 0: type −50 beside **Drop**, press **Space**, and wait.</source>
        <translation>y zeigt nach unten, über dem Körper ist also unter 0: Gib −50 neben **Absenkung** ein, drück die **Leertaste** und warte.</translation>
    </message>
    <message>
        <source>A third point bends a leg, and because it is only drawn, the run stays the same.</source>
        <translation>Ein dritter Punkt biegt ein Bein, und weil er nur gezeichnet ist, bleibt der Lauf derselbe.</translation>
    </message>
    <message>
        <source>Type 0 into the field beside **Curve**, and look at the legs.</source>
        <translation>Gib 0 in das Feld neben **Bogen** ein und sieh dir die Beine an.</translation>
    </message>
    <message>
        <source>Press **Space**, carry the body, and stop. Drag the timeline back to the left, type another **Curve**, and play on for a second.</source>
        <translation>Drück die **Leertaste**, trag den Körper und halte an. Zieh die Zeitleiste nach links zurück, gib einen anderen **Bogen** ein und spiele eine Sekunde weiter.</translation>
    </message>
    <message>
        <source>Type −30 into the field beside **Curve**.</source>
        <translation>Gib −30 in das Feld neben **Bogen** ein.</translation>
    </message>
    <message>
        <source>curve</source>
        <translation>Kurve|Kurven|Bogen</translation>
    </message>
    <message>
        <source>A line that is bent by a third point: it leaves one end towards that point, and comes to the other end from there. (Its name is Bézier curve.)</source>
        <translation>Eine Linie, die ein dritter Punkt biegt: Sie verlässt das eine Ende auf ihn zu und kommt von ihm her zum anderen. (Man nennt sie Bézierkurve.)</translation>
    </message>
    <message>
        <source>A clock turns the places of all feet, and each foot runs after its place.</source>
        <translation>Eine Uhr dreht die Orte aller Füße, und jeder Fuß läuft seinem Ort nach.</translation>
    </message>
    <message>
        <source>Type −0.05 into the field beside **Speed**, press **Space**, and wait three seconds.</source>
        <translation>Gib −0,05 in das Feld neben **Tempo** ein, drück die **Leertaste** und warte drei Sekunden.</translation>
    </message>
    <message>
        <source>A foot goes farthest when the clock turns about as fast as the foot swings by itself. Type 0.45 beside **Speed**, press **Space**, and touch nothing.</source>
        <translation>Am weitesten kommt ein Fuß, wenn sich die Uhr etwa so schnell dreht, wie er von selbst schwingt. Gib 0,45 neben **Tempo** ein, drück die **Leertaste** und fass nichts an.</translation>
    </message>
    <message>
        <source>Gait clock</source>
        <translation>Ganguhr</translation>
    </message>
    <message>
        <source>clock|one clock</source>
        <translation>Uhr|eine Uhr|Ganguhr</translation>
    </message>
    <message>
        <source>An angle that grows by the same amount each frame. Every foot adds it to the angle of its bone, so all of them go round in one rhythm.</source>
        <translation>Ein Winkel, der in jedem Bild um gleich viel wächst. Jeder Fuß addiert ihn zum Winkel seines Knochens, darum kreisen alle in einem Rhythmus.</translation>
    </message>
    <message>
        <source>Gait</source>
        <translation>Gang</translation>
    </message>
    <message>
        <source>gait|gaits</source>
        <translation>Gang|Gänge|Gangart</translation>
    </message>
    <message>
        <source>The order and the rhythm in which a creature moves its feet.</source>
        <translation>Die Reihenfolge und der Rhythmus, in denen eine Figur ihre Füße bewegt.</translation>
    </message>
    <message>
        <source>Why sine and cosine in a clock?</source>
        <translation>Warum Sinus und Kosinus in einer Uhr?</translation>
    </message>
    <message>
        <source>A point on a circle has two numbers. Walk round a circle of radius 1, and call the way along it the angle a. Then

`x = cos a,  y = sin a`

That is what cos and sin **are**. For a circle of 50&#x2009;px round a middle:

`x = mx + 50 × cos a`

`y = my + 50 × sin a`

The clock only makes a larger, frame by frame. x then swings to and fro, and y does so a quarter of a turn later. Half a turn more, π, puts the other foot on the far side: cos and sin change their sign.</source>
        <translation>Ein Punkt auf einem Kreis hat zwei Zahlen. Geh um einen Kreis mit Radius 1 und nenne den Weg auf ihm den Winkel a. Dann ist

`x = cos a,  y = sin a`

Das **sind** cos und sin. Für einen Kreis von 50&#x2009;px um eine Mitte:

`x = mx + 50 × cos a`

`y = my + 50 × sin a`

Die Uhr macht nur a größer, Bild für Bild. Dann schwingt x hin und her, und y tut es eine Vierteldrehung später. Eine halbe Drehung mehr, π, setzt den anderen Fuß auf die Gegenseite: cos und sin wechseln ihr Vorzeichen.</translation>
    </message>
    <message>
        <source>Each leg pulls foot and body just as hard, so legs alone get nowhere.</source>
        <translation>Jedes Bein zieht Fuß und Körper gleich stark, darum kommen Beine allein nirgendwohin.</translation>
    </message>
    <message>
        <source>Type 1 into the field beside **Damping**. Press **Space**, take the large disc, swing it, and let go on the way. Then wait four seconds.</source>
        <translation>Gib 1 in das Feld neben **Dämpfung** ein. Drück die **Leertaste**, nimm die große Scheibe, schwing sie und lass unterwegs los. Dann warte vier Sekunden.</translation>
    </message>
    <message>
        <source>Press **Space**, take a small disc, and hold it for two seconds.</source>
        <translation>Drück die **Leertaste**, nimm eine kleine Scheibe und halte sie zwei Sekunden lang.</translation>
    </message>
    <message>
        <source>A foot that stands cannot give way, so the body does: it walks.</source>
        <translation>Ein Fuß, der steht, kann nicht nachgeben, also tut es der Körper: Er geht.</translation>
    </message>
    <message>
        <source>Type −0.05 into the field beside **Speed**, press **Space**, and watch it go.</source>
        <translation>Gib −0,05 in das Feld neben **Tempo** ein, drück die **Leertaste** und sieh ihr nach.</translation>
    </message>
    <message>
        <source>Play some seconds. Choose **none** beside **Traction**, and wait five seconds.</source>
        <translation>Spiele einige Sekunden ab. Wähle **keine** neben **Haftung** und warte fünf Sekunden.</translation>
    </message>
    <message>
        <source>traction</source>
        <translation>Haftung</translation>
    </message>
    <message>
        <source>What keeps a foot from sliding on the ground. Without it the ground is like ice.</source>
        <translation>Was einen Fuß davon abhält, auf dem Boden zu rutschen. Ohne sie ist der Boden wie Eis.</translation>
    </message>
    <message>
        <source>slips a little</source>
        <translation>rutscht|rutschen|gerutscht</translation>
    </message>
    <message>
        <source>How far a foot slides along the ground while it should stand.</source>
        <translation>Wie weit ein Fuß auf dem Boden rutscht, während er stehen sollte.</translation>
    </message>
    <message>
        <source>More feet share the clock, and the body goes up and down less.</source>
        <translation>Mehr Füße teilen sich die Uhr, und der Körper geht weniger auf und ab.</translation>
    </message>
    <message>
        <source>Type 12 into the field beside **Feet**, press **Space**, and wait seven seconds.</source>
        <translation>Gib 12 in das Feld neben **Füße** ein, drück die **Leertaste** und warte sieben Sekunden.</translation>
    </message>
    <message>
        <source>Type 0 into the field beside **Spread**, press **Space**, and wait seven seconds.</source>
        <translation>Gib 0 in das Feld neben **Verteilung** ein, drück die **Leertaste** und warte sieben Sekunden.</translation>
    </message>
    <message>
        <source>The speed of the clock steers the creature: above 0 to the right, below 0 to the left.</source>
        <translation>Das Tempo der Uhr lenkt die Figur: über 0 nach rechts, unter 0 nach links.</translation>
    </message>
    <message>
        <source>Click the picture, press **Space**, and hold **←** for two seconds. Let go when it walks to the left, and watch.</source>
        <translation>Klick in die Szene, drück die **Leertaste** und halte zwei Sekunden lang **←**. Lass los, wenn sie nach links geht, und sieh zu.</translation>
    </message>
    <message>
        <source>Press **Space** and hold **←** until its legs hardly move. Or press the mouse button far off, and with the button down go straight above or below the body.</source>
        <translation>Drück die **Leertaste** und halte **←**, bis sich ihre Beine kaum noch bewegen. Oder drück die Maustaste weit weg und geh mit gedrückter Taste gerade über oder unter den Körper.</translation>
    </message>
    <message>
        <source>Turning round at a wall is a rule for the clock; the wall itself only stops what hits it.</source>
        <translation>An einer Wand umzukehren ist eine Regel für die Uhr; die Wand selbst hält nur an, was sie trifft.</translation>
    </message>
    <message>
        <source>Choose **walk on** beside **At a wall**, press **Space**, and wait until it has walked against a wall for a while.</source>
        <translation>Wähle **weitergehen** neben **An einer Wand**, drück die **Leertaste** und warte, bis sie eine Weile gegen eine Wand gegangen ist.</translation>
    </message>
    <message>
        <source>Press **Space**, take the large disc, swing it towards a wall, and let go on the way.</source>
        <translation>Drück die **Leertaste**, nimm die große Scheibe, schwing sie auf eine Wand zu und lass unterwegs los.</translation>
    </message>
    <message>
        <source>A push that both feel makes no momentum; a push that one feels makes it from nothing.</source>
        <translation>Ein Abstoßen, das beide spüren, macht keinen Impuls; eines, das nur einer spürt, macht ihn aus dem Nichts.</translation>
    </message>
    <message>
        <source>Press **Space**, take the large disc of one creature, and carry it onto the other one.</source>
        <translation>Drück die **Leertaste**, nimm die große Scheibe einer Figur und trag sie auf die andere.</translation>
    </message>
    <message>
        <source>Choose **one** beside **Felt by**, press **Space**, and wait until two bodies touch.</source>
        <translation>Wähle **einem** neben **Gespürt von**, drück die **Leertaste** und warte, bis zwei Körper sich berühren.</translation>
    </message>
    <message>
        <source>Type 5 into the field beside **Creatures**, press **Space**, and wait ten seconds.</source>
        <translation>Gib 5 in das Feld neben **Figuren** ein, drück die **Leertaste** und warte zehn Sekunden.</translation>
    </message>
    <message>
        <source>let it walk on to 100&#x202f;px left of where it began. So far: %1&#x202f;px.</source>
        <translation>lass sie weitergehen, bis 100&#x202f;px links von ihrem Anfang. Bisher: %1&#x202f;px.</translation>
    </message>
    <message>
        <source>stop at a frame in which no foot touches the ground: go there with **→**.</source>
        <translation>halte bei einem Bild an, in dem kein Fuß den Boden berührt: Geh mit **→** dorthin.</translation>
    </message>
    <message>
        <source>Set **speed** to −0.05 and let the creature walk to 100&#x202f;px left of where it began.</source>
        <translation>Setze **Tempo** auf −0,05 und lass die Figur bis 100&#x202f;px links von ihrem Anfang gehen.</translation>
    </message>
    <message>
        <source>stop at a frame in which a foot on the ground moves up, at 1&#x202f;px per frame or more: go there with **→**.</source>
        <translation>halte bei einem Bild an, in dem ein Fuß am Boden nach oben geht, mit 1&#x202f;px pro Bild oder mehr: Geh mit **→** dorthin.</translation>
    </message>
    <message>
        <source>let it walk on until a foot stands on the ground.</source>
        <translation>lass sie weitergehen, bis ein Fuß am Boden steht.</translation>
    </message>
    <message>
        <source>By less than 1&#x202f;px: some foot is always on its way down.</source>
        <translation>Um weniger als 1&#x202f;px: Irgendein Fuß ist immer auf dem Weg nach unten.</translation>
    </message>
    <message>
        <source>No. The body falls and rises and goes to and fro, but it gets nowhere.</source>
        <translation>Nein. Der Körper fällt und steigt und geht hin und her, aber er kommt nicht vom Fleck.</translation>
    </message>
    <message>
        <source>Set **speed** to 0.3, play 60&#x202f;frames, and stop when no foot touches the ground.</source>
        <translation>Setze **Tempo** auf 0,3, spiele 60&#x202f;Bilder und halte an, wenn kein Fuß den Boden berührt.</translation>
    </message>
    <message>
        <source>Hold the **←** key until the creature walks to the left, and let it walk to 100&#x202f;px left of where it began.</source>
        <translation>Halte die Taste **←**, bis die Figur nach links geht, und lass sie bis 100&#x202f;px links von ihrem Anfang gehen.</translation>
    </message>
    <message>
        <source>hold **←** longer, until the clock’s speed is below 0. It is %1&#x202f;rad per frame.</source>
        <translation>halte **←** länger, bis das Tempo der Uhr unter 0 ist. Es ist %1&#x202f;rad pro Bild.</translation>
    </message>
    <message>
        <source>hold the button 200&#x202f;px or more to the left or right of it, while time runs. The clock’s speed is %1&#x202f;rad per frame.</source>
        <translation>halte die Taste 200&#x202f;px oder mehr links oder rechts von ihr, während die Zeit läuft. Das Tempo der Uhr ist %1&#x202f;rad pro Bild.</translation>
    </message>
    <message>
        <source>bring the clock’s speed to 0. It is %1&#x202f;rad per frame.</source>
        <translation>bring das Tempo der Uhr auf 0. Es ist %1&#x202f;rad pro Bild.</translation>
    </message>
    <message>
        <source>Set **at wall** to *walk on* and let it walk against a wall, for 200&#x202f;frames in all.</source>
        <translation>Stelle **An einer Wand** auf *weitergehen* und lass sie gegen eine Wand gehen, 200&#x202f;Bilder insgesamt.</translation>
    </message>
    <message>
        <source>let it walk on until it touches a wall.</source>
        <translation>lass sie weitergehen, bis sie eine Wand berührt.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until it turns.</source>
        <translation>lass die Zeit laufen (**Leertaste**), bis sie umkehrt.</translation>
    </message>
    <message>
        <source>Throw the creature into a wall, so that it gets there within 40&#x202f;frames.</source>
        <translation>Wirf die Figur so gegen eine Wand, dass sie in höchstens 40&#x202f;Bildern dort ist.</translation>
    </message>
    <message>
        <source>throw it harder or closer to a wall: it has to get there within 40&#x202f;frames.</source>
        <translation>wirf sie kräftiger oder näher an einer Wand: Sie muss in höchstens 40&#x202f;Bildern dort sein.</translation>
    </message>
    <message>
        <source>Take one creature by its body and drag it at least 40&#x202f;px, into another. Both feel the push; the one in your hand cannot move.</source>
        <translation>Nimm eine Figur am Körper und zieh sie mindestens 40&#x202f;px weit, in eine andere hinein. Beide spüren das Abstoßen; die in deiner Hand kann sich nicht bewegen.</translation>
    </message>
    <message>
        <source>drag it into another. The nearest body is %1&#x202f;px away.</source>
        <translation>zieh sie in eine andere hinein. Der nächste Körper ist %1&#x202f;px entfernt.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until two bodies touch. They are %1&#x202f;px apart.</source>
        <translation>lass die Zeit laufen (**Leertaste**), bis zwei Körper sich berühren. Sie sind %1&#x202f;px auseinander.</translation>
    </message>
    <message>
        <source>Pull foot 0 to the right of the body, 20&#x202f;px or more past it, let go, and wait until all is still. Where does it end?</source>
        <translation>Zieh Fuß 0 auf die rechte Seite des Körpers, 20&#x202f;px oder mehr an ihm vorbei, lass los und warte, bis alles still ist. Wo endet er?</translation>
    </message>
    <message>
        <source>pull it 20&#x202f;px or more past the body, to the right. It came %1&#x202f;px past it.</source>
        <translation>zieh ihn 20&#x202f;px oder mehr am Körper vorbei, nach rechts. Er kam %1&#x202f;px vorbei.</translation>
    </message>
    <message>
        <source>On the left again: its bone has an angle of its own, and the spring pulls it to that place from anywhere.</source>
        <translation>Wieder links: Sein Knochen hat einen eigenen Winkel, und die Feder zieht ihn von überall dorthin.</translation>
    </message>
    <message>
        <source>100&#x202f;px: at rest a line is as long as **leg** says.</source>
        <translation>100&#x202f;px: In Ruhe ist eine Linie so lang, wie **Bein** sagt.</translation>
    </message>
    <message>
        <source>Straight: the point that bends a leg lies on its foot then.</source>
        <translation>Gerade: Der Punkt, der ein Bein biegt, liegt dann auf seinem Fuß.</translation>
    </message>
    <message>
        <source>carry the body first. Then go back in time, and change **curve** there.</source>
        <translation>trag zuerst den Körper. Geh dann in der Zeit zurück und ändere dort **Bogen**.</translation>
    </message>
    <message>
        <source>Anticlockwise: the angle of each foot gets smaller from frame to frame.</source>
        <translation>Gegen den Uhrzeigersinn: Der Winkel jedes Fußes wird von Bild zu Bild kleiner.</translation>
    </message>
    <message>
        <source>Find a speed at which a foot goes round more than 150&#x202f;px from the middle of its places. Hands off for 120&#x202f;frames while you measure.</source>
        <translation>Finde ein Tempo, bei dem ein Fuß mehr als 150&#x202f;px von der Mitte seiner Orte entfernt kreist. Hände weg, 120&#x202f;Bilder lang, während du misst.</translation>
    </message>
    <message>
        <source>try another speed. Foot 0 is %1&#x202f;px from the middle of its places.</source>
        <translation>versuche ein anderes Tempo. Fuß 0 ist %1&#x202f;px von der Mitte seiner Orte entfernt.</translation>
    </message>
    <message>
        <source>Set **damping** to 1 and throw the creature, at 5&#x202f;px per frame or more. After 100&#x202f;frames its momentum is what your hand gave it.</source>
        <translation>Setze **Dämpfung** auf 1 und wirf die Figur, mit 5&#x202f;px pro Bild oder mehr. Nach 100&#x202f;Bildern ist ihr Impuls, was deine Hand ihr gab.</translation>
    </message>
    <message>
        <source>hold it for 60&#x202f;frames while time runs. So far: %1.</source>
        <translation>halte ihn 60&#x202f;Bilder lang, während die Zeit läuft. Bisher: %1.</translation>
    </message>
    <message>
        <source>Type 0.8 into the field beside **Bounce**, and press **Enter**. Go on frame by frame with **→** until a foot that was on the ground goes up.</source>
        <translation>Gib 0,8 in das Feld neben **Abprall** ein und drück **Eingabe**. Geh mit **→** Bild für Bild weiter, bis ein Fuß, der am Boden war, nach oben geht.</translation>
    </message>
    <message>
        <source>Carry the body at least 100&#x202f;px. Both feet follow, each on its side.</source>
        <translation>Trag den Körper mindestens 100&#x202f;px. Beide Füße folgen, jeder auf seiner Seite.</translation>
    </message>
    <message>
        <source>Carry the body at least 100&#x202f;px to the side. If you do it slowly, it looks like walking.</source>
        <translation>Trag den Körper mindestens 100&#x202f;px zur Seite. Wenn du es langsam tust, sieht es aus wie Gehen.</translation>
    </message>
    <message>
        <source>carry it 100&#x202f;px to the side. It came %1&#x202f;px.</source>
        <translation>trag ihn 100&#x202f;px zur Seite. Er kam %1&#x202f;px weit.</translation>
    </message>
    <message>
        <source>Pull a foot at least 75&#x202f;px away and let go. Now the body comes along.</source>
        <translation>Zieh einen Fuß mindestens 75&#x202f;px weg und lass los. Jetzt kommt der Körper mit.</translation>
    </message>
    <message>
        <source>Lift the body at least 60&#x202f;px and let go. It lands on its feet and walks on, for 60&#x202f;frames.</source>
        <translation>Heb den Körper mindestens 60&#x202f;px an und lass los. Die Figur landet auf den Füßen und geht weiter, 60&#x202f;Bilder lang.</translation>
    </message>
    <message>
        <source>lift it 60&#x202f;px or more. It came %1&#x202f;px up.</source>
        <translation>heb ihn 60&#x202f;px oder mehr. Er kam %1&#x202f;px hoch.</translation>
    </message>
    <message>
        <source>set **spread** back to 360°.</source>
        <translation>setze **Verteilung** zurück auf 360°.</translation>
    </message>
    <message>
        <source>set **feet** back to 5.</source>
        <translation>setze **Füße** zurück auf 5.</translation>
    </message>
    <message>
        <source>Press **Space**, take the large disc, lift it near to the upper edge of the picture, let go, and wait two seconds.</source>
        <translation>Drück die **Leertaste**, nimm die große Scheibe, heb sie bis nahe an den oberen Rand der Szene, lass los und warte zwei Sekunden.</translation>
    </message>
    <message>
        <source>Press **Reset all**. Type 0.3 into the field beside **Speed**. Play three seconds and stop. Go on frame by frame with **→** until all feet are in the air.</source>
        <translation>Drück **Alle zurücksetzen**. Gib 0,3 in das Feld neben **Tempo** ein. Spiele drei Sekunden ab und halte an. Geh mit **→** Bild für Bild weiter, bis alle Füße in der Luft sind.</translation>
    </message>
    <message>
        <source>Press **Space**. Press the mouse button in the picture, and with the button down go far to the left or right, past the edge of the picture if need be.</source>
        <translation>Drück die **Leertaste**. Drück in der Szene die Maustaste und geh mit gedrückter Taste weit nach links oder rechts, wenn nötig über den Rand der Szene hinaus.</translation>
    </message>
    <message>
        <source>Choose **turn** beside **At a wall**. Type 200 beside **Left wall** and 340 beside **Right wall**, press **Space**, and wait until it turns.</source>
        <translation>Wähle **umkehren** neben **An einer Wand**. Gib 200 neben **Linke Wand** und 340 neben **Rechte Wand** ein, drück die **Leertaste** und warte, bis sie umkehrt.</translation>
    </message>
    <message>
        <source>let it stand for ten frames.</source>
        <translation>lass es zehn Bilder lang stehen.</translation>
    </message>
    <message>
        <source>choose **turn** beside **At a wall**.</source>
        <translation>wähle **umkehren** neben **An einer Wand**.</translation>
    </message>
    <message>
        <source>Press **Space**, take a small disc, pull it to the upper edge of the picture, and let go.</source>
        <translation>Drück die **Leertaste**, nimm eine kleine Scheibe, zieh sie an den oberen Rand der Szene und lass los.</translation>
    </message>
    <message>
        <source>A **leg** is a line from the body to a foot. It is made anew for each picture, from where body and foot are at that moment. Nothing feels it: the code that moves the feet is the same as before.

Still it tells you something: how far the foot is from the body. At rest each line is as long as **leg** says, 50&#x202f;px. While a foot swings, you see it stretch and shrink.</source>
        <translation>Ein **Bein** ist eine Linie vom Körper zu einem Fuß. Sie wird für jedes Bild neu gemacht, aus dem, wo Körper und Fuß in diesem Moment sind. Nichts spürt sie: Der Code, der die Füße bewegt, ist derselbe wie zuvor.

Trotzdem sagt sie dir etwas: wie weit der Fuß vom Körper weg ist. In Ruhe ist jede Linie so lang, wie **Bein** sagt, 50&#x202f;px. Während ein Fuß schwingt, siehst du sie sich dehnen und schrumpfen.</translation>
    </message>
    <message>
        <source>Pull a foot at least 75&#x202f;px away and let go. The line shows how far the foot swings.</source>
        <translation>Zieh einen Fuß mindestens 75&#x202f;px weg und lass los. Die Linie zeigt, wie weit der Fuß schwingt.</translation>
    </message>
    <message>
        <source>where a foot belongs</source>
        <translation>wohin ein Fuß gehört</translation>
    </message>
    <message>
        <source>Write where the foot belongs: **leg** px from the body, in the direction that `angle` tells. At the angle 0 it is on the left.</source>
        <translation>Schreibe, wohin der Fuß gehört: **Bein** px vom Körper, in der Richtung, die `angle` angibt. Beim Winkel 0 ist er links.</translation>
    </message>
    <message>
        <source>Vec2 target: where the foot belongs.</source>
        <translation>Vec2 target: wohin der Fuß gehört.</translation>
    </message>
    <message>
        <source>`Vec2(cos(angle), sin(angle))` is a step of 1&#x202f;px at that angle. At 0 it leads to the right.</source>
        <translation>`Vec2(cos(angle), sin(angle))` ist ein Schritt von 1&#x202f;px in diesem Winkel. Bei 0 führt er nach rechts.</translation>
    </message>
    <message>
        <source>A minus makes it lead the other way.</source>
        <translation>Ein Minus lässt ihn in die andere Richtung führen.</translation>
    </message>
    <message>
        <source>`Vec2 target = body.position - …;`</source>
        <translation>`Vec2 target = body.position - …;`</translation>
    </message>
    <message>
        <source>The feet are swapped: at the angle 0 the foot belongs on the left. Subtract.</source>
        <translation>Die Füße sind vertauscht: Beim Winkel 0 gehört der Fuß nach links. Subtrahiere.</translation>
    </message>
    <message>
        <source>The foot is only 1&#x202f;px away from the body. Multiply by `leg`.</source>
        <translation>Der Fuß ist nur 1&#x202f;px vom Körper entfernt. Multipliziere mit `leg`.</translation>
    </message>
    <message>
        <source>`cos` and `sin` are swapped: `cos` belongs to x.</source>
        <translation>`cos` und `sin` sind vertauscht: `cos` gehört zu x.</translation>
    </message>
    <message>
        <source>the target of a swinging foot</source>
        <translation>das Ziel eines schwingenden Fußes</translation>
    </message>
    <message>
        <source>Write the **target of a swinging foot**: as before, but the clock `gait` turns the angle, and the place is **drop** px lower.</source>
        <translation>Schreibe das **Ziel eines schwingenden Fußes**: wie zuvor, aber die Uhr `gait` dreht den Winkel, und der Ort ist **Absenkung** px tiefer.</translation>
    </message>
    <message>
        <source>Vec2 target: the place goes round the body, drop px below it.</source>
        <translation>Vec2 target: Der Ort läuft im Kreis, drop px unter dem Körper.</translation>
    </message>
    <message>
        <source>The clock is an angle, too. Add it to the angle of the bone.</source>
        <translation>Auch die Uhr ist ein Winkel. Addiere sie zum Winkel des Knochens.</translation>
    </message>
    <message>
        <source>Down is a larger y: change `target.y` in the end.</source>
        <translation>Nach unten ist ein größeres y: Ändere am Ende `target.y`.</translation>
    </message>
    <message>
        <source>`Vec2 target = body.position - leg * Vec2(cos(angle + …), sin(…));` and `target.y += …;`</source>
        <translation>`Vec2 target = body.position - leg * Vec2(cos(angle + …), sin(…));` und `target.y += …;`</translation>
    </message>
    <message>
        <source>The feet go round backwards. Add the clock to the angle.</source>
        <translation>Die Füße laufen rückwärts im Kreis. Addiere die Uhr zum Winkel.</translation>
    </message>
    <message>
        <source>The feet stand still: the clock `gait` is missing.</source>
        <translation>Die Füße stehen still: Die Uhr `gait` fehlt.</translation>
    </message>
    <message>
        <source>The feet go round the body itself. They belong `drop` px lower.</source>
        <translation>Die Füße laufen um den Körper selbst. Sie gehören `drop` px tiefer.</translation>
    </message>
    <message>
        <source>The feet go round above the body. y points down.</source>
        <translation>Die Füße laufen über dem Körper im Kreis. y zeigt nach unten.</translation>
    </message>
    <message>
        <source>force and opposite force</source>
        <translation>Kraft und Gegenkraft</translation>
    </message>
    <message>
        <source>Write the **two sides of a force**: the foot feels `force`, and the body feels the opposite. What your hand holds feels nothing.</source>
        <translation>Schreibe die **zwei Seiten einer Kraft**: Der Fuß spürt `force`, und der Körper spürt das Gegenteil. Was deine Hand hält, spürt nichts.</translation>
    </message>
    <message>
        <source>The foot feels the force, the body the opposite one.</source>
        <translation>Der Fuß spürt die Kraft, der Körper die Gegenkraft.</translation>
    </message>
    <message>
        <source>A force changes the velocity of what feels it.</source>
        <translation>Eine Kraft ändert die Geschwindigkeit dessen, was sie spürt.</translation>
    </message>
    <message>
        <source>The opposite of a vector has a minus. Each line needs an `if`: what is held keeps its velocity.</source>
        <translation>Das Gegenteil eines Vektors hat ein Minus. Jede Zeile braucht ein `if`: Was gehalten wird, behält seine Geschwindigkeit.</translation>
    </message>
    <message>
        <source>`if (!foot.held) foot.velocity += …;` and for the body `-=`.</source>
        <translation>`if (!foot.held) foot.velocity += …;` und für den Körper `-=`.</translation>
    </message>
    <message>
        <source>The body feels the same force as the foot, so both go the same way. It has to feel the opposite.</source>
        <translation>Der Körper spürt dieselbe Kraft wie der Fuß, darum bewegen sich beide in dieselbe Richtung. Er muss das Gegenteil spüren.</translation>
    </message>
    <message>
        <source>The body feels nothing, so it hangs in the air like a handle.</source>
        <translation>Der Körper spürt nichts und hängt in der Luft wie ein Griff.</translation>
    </message>
    <message>
        <source>The force also acts on what your hand holds. Its velocity has to stay that of your hand.</source>
        <translation>Die Kraft wirkt auch auf das, was deine Hand hält. Seine Geschwindigkeit muss die deiner Hand bleiben.</translation>
    </message>
    <message>
        <source>Both forces are turned round: the foot flees from its target.</source>
        <translation>Beide Kräfte sind umgekehrt: Der Fuß flieht vor seinem Ziel.</translation>
    </message>
    <message>
        <source>feet on the ground</source>
        <translation>Füße auf dem Boden</translation>
    </message>
    <message>
        <source>Write how the **ground holds a foot** (not the body): put it back, let it bounce, and with full traction (`traction == 0`) it does not slide.</source>
        <translation>Schreibe, wie der **Boden einen Fuß hält** (nicht den Körper): zurücksetzen, abprallen lassen, und bei voller Haftung (`traction == 0`) gleitet er nicht.</translation>
    </message>
    <message>
        <source>If a foot is below the ground: put it back, let it bounce, and hold it.</source>
        <translation>Ist ein Fuß unter dem Boden: zurücksetzen, abprallen lassen und festhalten.</translation>
    </message>
    <message>
        <source>A point is a foot if `me != body`. It is below the ground if its y is larger than `ground`.</source>
        <translation>Ein Punkt ist ein Fuß, wenn `me != body` gilt. Er ist unter dem Boden, wenn sein y größer als `ground` ist.</translation>
    </message>
    <message>
        <source>After the bounce, its velocity in y is `-bounce` times what it was.</source>
        <translation>Nach dem Abprall ist seine Geschwindigkeit in y `-bounce` mal die von vorher.</translation>
    </message>
    <message>
        <source>`if (me.position.y &gt; ground &amp;&amp; me != body)`, and in it: set `me.position.y`, then `me.velocity.y *= -bounce;`, then `if (traction == 0) me.velocity.x = 0;`</source>
        <translation>`if (me.position.y &gt; ground &amp;&amp; me != body)`, und darin: `me.position.y` setzen, dann `me.velocity.y *= -bounce;`, dann `if (traction == 0) me.velocity.x = 0;`</translation>
    </message>
    <message>
        <source>The feet slide on the ground as on ice, so the body does not get on. With full traction their velocity in x is 0.</source>
        <translation>Die Füße gleiten auf dem Boden wie auf Eis, darum kommt der Körper nicht voran. Bei voller Haftung ist ihre Geschwindigkeit in x 0.</translation>
    </message>
    <message>
        <source>The feet are put back, but they keep their velocity: they slide, and each pull starts from a fall.</source>
        <translation>Die Füße werden zurückgesetzt, behalten aber ihre Geschwindigkeit: Sie gleiten, und jeder Zug beginnt mit einem Fall.</translation>
    </message>
    <message>
        <source>The feet are held, but below the ground. Put them back.</source>
        <translation>Die Füße werden gehalten, aber unter dem Boden. Setze sie zurück.</translation>
    </message>
    <message>
        <source>The feet stick to the ground from the start: this holds what is above it. y points down.</source>
        <translation>Die Füße kleben von Anfang an am Boden: Das hält, was über ihm ist. y zeigt nach unten.</translation>
    </message>
    <message>
        <source>the whole frame</source>
        <translation>das ganze Bild</translation>
    </message>
    <message>
        <source>**From the empty page:** write the whole frame of a creature that walks: two feet, a clock, forces on both sides, gravity, and the ground.</source>
        <translation>**Von der leeren Seite:** Schreibe das ganze Bild eines Wesens, das geht: zwei Füße, eine Uhr, Kräfte auf beiden Seiten, Schwerkraft und der Boden.</translation>
    </message>
    <message>
        <source>The order of a frame: what is held follows the hand. Then both feet pull. Then all three move, the feet first. In the end the clock goes on by `speed`.</source>
        <translation>Die Reihenfolge eines Bildes: Was gehalten wird, folgt der Hand. Dann ziehen beide Füße. Dann bewegen sich alle drei, die Füße zuerst. Am Ende geht die Uhr um `speed` weiter.</translation>
    </message>
    <message>
        <source>The foot 0 has the angle 0, and the foot 1 the angle `pi`. The target is `body.position - leg * Vec2(cos(angle + gait), sin(angle + gait))`, `drop` px lower. The body feels the opposite force.</source>
        <translation>Der Fuß 0 hat den Winkel 0, der Fuß 1 den Winkel `pi`. Das Ziel ist `body.position - leg * Vec2(cos(angle + gait), sin(angle + gait))`, `drop` px tiefer. Der Körper spürt die Gegenkraft.</translation>
    </message>
    <message>
        <source>To move: gravity, damping, the move, and then the ground. The ground holds feet only: `me != body`.</source>
        <translation>Zum Bewegen: Schwerkraft, Dämpfung, die Bewegung und dann der Boden. Der Boden hält nur Füße: `me != body`.</translation>
    </message>
    <message>
        <source>The rest is right, but the clock stands still, so no foot ever moves on.</source>
        <translation>Der Rest stimmt, aber die Uhr steht still, darum geht kein Fuß je weiter.</translation>
    </message>
    <message>
        <source>The rest is right, but the clock runs backwards.</source>
        <translation>Der Rest stimmt, aber die Uhr läuft rückwärts.</translation>
    </message>
    <message>
        <source>The rest is right, but the feet slide on the ground as on ice.</source>
        <translation>Der Rest stimmt, aber die Füße gleiten auf dem Boden wie auf Eis.</translation>
    </message>
    <message>
        <source>Write the whole frame. The names: body, feet[0], feet[1] (each with position, velocity and held), hand, gait, speed, leg, drop, k, damp, gravity, ground, bounce, traction (0: full).</source>
        <translation>Schreibe das ganze Bild. Die Namen: body, feet[0], feet[1] (jeweils mit position, velocity und held), hand, gait, speed, leg, drop, k, damp, gravity, ground, bounce, traction (0: voll).</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Walking</source>
        <translation>Gehen</translation>
    </message>
    <message>
        <source>Bones, a clock that turns them, and ground: a creature that walks.</source>
        <translation>Knochen, eine Uhr, die sie dreht, und Boden: eine Figur, die geht.</translation>
    </message>
</context>
</TS>
