<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>RigidConstraint</name>
    <message>
        <source>Largest error</source>
        <translation>Größter Fehler</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>How far the length of the worst stick is from what it should be.</source>
        <translation>Wie weit die Länge des schlechtesten Stabs von ihrem Sollwert entfernt ist.</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Größte Dehnung</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>How far the worst stick is from its length, as a part of that length.</source>
        <translation>Wie weit der schlechteste Stab von seiner Länge entfernt ist, als Anteil dieser Länge.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>How far apart a stick keeps its two ends.</source>
        <translation>Wie weit ein Stab seine zwei Enden auseinanderhält.</translation>
    </message>
    <message>
        <source>Share of p0</source>
        <translation>Anteil von p0</translation>
    </message>
    <message>
        <source>The part of the error that p0 takes; p1 takes the rest.</source>
        <translation>Der Teil des Fehlers, den p0 übernimmt; p1 übernimmt den Rest.</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Dreiecke</translation>
    </message>
    <message>
        <source>How many triangles the figure has.</source>
        <translation>Wie viele Dreiecke die Figur hat.</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterationen</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>How often each frame goes through the list of sticks.</source>
        <translation>Wie oft jedes Bild die Liste der Stäbe durchgeht.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>How much a wall’s push holds back what slides along it. 0: like ice.</source>
        <translation>Wie stark eine Wand bremst, was an ihr entlanggleitet. 0: wie Eis.</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>Whether arms and legs bend only as far as joints do, or all the way round.</source>
        <translation>Ob Arme und Beine sich nur so weit beugen wie Gelenke oder ganz herum.</translation>
    </message>
    <message>
        <source>A pair</source>
        <translation>Ein Paar</translation>
    </message>
    <message>
        <source>A **stick** is a rule: these two points are 100&#x202f;px apart, whatever happens. Such a rule is called a **constraint**. The pointer carries p0, and the rule does the rest.

Each frame the code measures the distance. What it has too much is the **error**; below 0 it has too little. Both points go along the stick, and each takes **half of the error**. Then the distance is right, in one go: there is no spring here, and no velocity.

Both points start in one place, where a stick has no direction. `atan2(0, 0)` is 0, so they part straight up and down.

This angle is counted from the y axis: that is why dx comes first in `atan2`.</source>
        <translation>Ein **Stab** ist eine Regel: Diese zwei Punkte sind 100&#x202f;px auseinander, was auch geschieht. Eine solche Regel heißt **Zwangsbedingung**. Der Zeiger trägt p0, und die Regel tut den Rest.

In jedem Bild misst der Code den Abstand. Um wie viel er zu groß ist, das ist der **Fehler**; unter 0 ist er zu klein. Beide Punkte gehen am Stab entlang, und jeder übernimmt **die Hälfte des Fehlers**. Dann stimmt der Abstand, auf einen Schlag: Es gibt hier keine Feder und keine Geschwindigkeit.

Beide Punkte beginnen an einem Ort, wo ein Stab keine Richtung hat. `atan2(0, 0)` ist 0, also trennen sie sich gerade nach oben und unten.

Dieser Winkel zählt von der y-Achse aus: Darum steht dx in `atan2` an erster Stelle.</translation>
    </message>
    <message>
        <source>Who takes the error</source>
        <translation>Wer den Fehler trägt</translation>
    </message>
    <message>
        <source>Half each is not always what you want. **share** is the part of the error that p0 takes, from 0 to 1. p1 takes the rest.

At 1, p1 is a nail. The pointer takes p0 away, and the stick brings it back to 100&#x202f;px from the nail, on the side where the pointer is.

At 0, p0 stays at the pointer and p1 is pulled along.

In between, both move. The pointer puts p0 back each frame, so the stick is wrong again. While the pointer stands still, **each frame leaves share of the error**: at 0.5 half of it, then a quarter, and p0 comes to the pointer after all.</source>
        <translation>Jeder die Hälfte ist nicht immer, was du willst. **Anteil** (share) ist der Teil des Fehlers, den p0 übernimmt, von 0 bis 1. p1 übernimmt den Rest.

Bei 1 ist p1 ein Nagel. Der Zeiger trägt p0 davon, und der Stab bringt ihn auf 100&#x202f;px an den Nagel zurück, auf der Seite, auf der der Zeiger ist.

Bei 0 bleibt p0 am Zeiger, und p1 wird hinterhergezogen.

Dazwischen bewegen sich beide. Der Zeiger setzt p0 in jedem Bild zurück, darum ist der Stab wieder falsch. Solange der Zeiger stillsteht, **lässt jedes Bild den Anteil vom Fehler übrig**: bei 0,5 die Hälfte, dann ein Viertel, und p0 kommt doch noch zum Zeiger.</translation>
    </message>
    <message>
        <source>A triangle</source>
        <translation>Ein Dreieck</translation>
    </message>
    <message>
        <source>Three points, three sticks: the same function three times, one after the other. Each stick makes its own distance right, and **the ones before it a little wrong again**.

Move the pointer slowly, and you hardly see it. Move it fast, and the triangle is out of shape: one round of corrections is not enough. The next frame corrects what is left, so it comes back to its shape in a few frames.

The three start in one place and part on one line. They stay on that line until the pointer leaves it: on a line no stick knows a way to the side.

Three sticks of 100&#x202f;px can all be right at once. Sticks of 100, 100 and 300&#x202f;px never can: some error would stay for ever.</source>
        <translation>Drei Punkte, drei Stäbe: dieselbe Funktion dreimal, eine nach der anderen. Jeder Stab stellt seinen eigenen Abstand richtig, und **die vor ihm wieder ein wenig falsch**.

Beweg den Zeiger langsam, und du siehst es kaum. Beweg ihn schnell, und das Dreieck ist verzogen: Eine Runde von Korrekturen genügt nicht. Das nächste Bild korrigiert, was übrig ist, darum kommt es in wenigen Bildern in seine Form zurück.

Die drei beginnen an einem Ort und trennen sich auf einer Linie. Auf ihr bleiben sie, bis der Zeiger sie verlässt: Auf einer Linie kennt kein Stab einen Weg zur Seite.

Drei Stäbe von 100&#x202f;px können alle zugleich stimmen. Stäbe von 100, 100 und 300&#x202f;px können das nie: Ein Fehler bliebe für immer.</translation>
    </message>
    <message>
        <source>A list of sticks</source>
        <translation>Eine Liste von Stäben</translation>
    </message>
    <message>
        <source>Copied lines will not do for a big figure. Here **a loop** fills a list of sticks: each point is tied to the one before it and to the one before that, which gives a row of triangles. A second loop goes through the list each frame and enforces one stick after the other.

**The order matters.** A pull at p0 runs down the list in one frame, as each stick sees what the one before it moved. A correction that has to go the other way gets one stick further each frame.

A stick’s colour shows its error. After a fast move you can watch the error spread, and shrink frame by frame.</source>
        <translation>Kopierte Zeilen genügen nicht für eine große Figur. Hier füllt **eine Schleife** eine Liste von Stäben: Jeder Punkt ist an den vor ihm gebunden und an den davor, das gibt eine Reihe von Dreiecken. Eine zweite Schleife geht in jedem Bild die Liste durch und setzt einen Stab nach dem anderen durch.

**Die Reihenfolge zählt.** Ein Zug an p0 läuft in einem Bild die Liste hinunter, denn jeder Stab sieht, was der vor ihm bewegt hat. Eine Korrektur, die in die andere Richtung muss, kommt in jedem Bild einen Stab weiter.

Die Farbe eines Stabs zeigt seinen Fehler. Nach einer schnellen Bewegung kannst du zusehen, wie der Fehler sich ausbreitet und Bild für Bild schrumpft.</translation>
    </message>
    <message>
        <source>Points that move</source>
        <translation>Bewegte Punkte</translation>
    </message>
    <message>
        <source>Now the points move by themselves, and fall. But a stick puts a point elsewhere without asking its velocity. The remedy: **do not keep a velocity. It is the way that the point came**, its place now minus its place one frame before:

`x + (x − before) + g`

is the next place. This is **Verlet integration**. Watch the phases: move, sticks, room, and then the new velocity is read off. Whatever moved the point is in it.

Walls are constraints, too: no point may be past one. **Friction** holds back what slides along them.

**iterations** says how often a frame goes through the list of sticks. At 1 this box gives way like rubber; more make it stiff.</source>
        <translation>Jetzt bewegen sich die Punkte von selbst und fallen. Aber ein Stab setzt einen Punkt woandershin, ohne nach seiner Geschwindigkeit zu fragen. Die Abhilfe: **Speichere keine Geschwindigkeit. Sie ist der Weg, den der Punkt kam**, sein Ort jetzt minus sein Ort ein Bild zuvor:

`x + (x − before) + g`

ist der nächste Ort. Das ist **Verlet-Integration**. Sieh dir die Phasen an: Bewegung, Stäbe, Raum, und dann wird die neue Geschwindigkeit abgelesen. Was den Punkt auch bewegt hat, steckt darin.

Auch Wände sind Zwangsbedingungen: Kein Punkt darf hinter einer sein. **Reibung** bremst, was an ihnen entlanggleitet.

**Iterationen** sagt, wie oft ein Bild die Liste der Stäbe durchgeht. Bei 1 gibt diese Kiste nach wie Gummi; mehr machen sie steif.</translation>
    </message>
    <message>
        <source>A ragdoll</source>
        <translation>Eine Gliederpuppe</translation>
    </message>
    <message>
        <source>A whole figure: 12 points and 14 sticks. Three sticks make the torso a triangle, which cannot be bent. Three more hold the head on it: two from the shoulders, and one from the hip as a **brace**. Arms and legs are two sticks each.

Sticks alone let a knee turn all the way round. **Joint limits** are constraints that act only when they are broken: when the angle at a joint is past its limit, both limbs are turned back, half of it each.

Drag it, throw it, drop it. A stick’s colour shows what error is left after all iterations, and the figure beside the scene shows the worst one. Each pass takes a part of the error, so **twice the passes leave less**, and cost twice as much.</source>
        <translation>Eine ganze Figur: 12 Punkte und 14 Stäbe. Drei Stäbe machen den Rumpf zu einem Dreieck, das sich nicht biegen lässt. Drei weitere halten den Kopf darauf: zwei von den Schultern und einer von der Hüfte als **Strebe**. Arme und Beine sind je zwei Stäbe.

Stäbe allein lassen ein Knie ganz herumdrehen. **Gelenkgrenzen** sind Zwangsbedingungen, die nur wirken, wenn sie verletzt sind: Ist der Winkel an einem Gelenk über seiner Grenze, werden beide Glieder zurückgedreht, jedes um die Hälfte.

Zieh sie, wirf sie, lass sie fallen. Die Farbe eines Stabs zeigt, welcher Fehler nach allen Iterationen übrig ist, und die Zahl neben der Szene zeigt den schlimmsten. Jeder Durchgang nimmt einen Teil des Fehlers, darum **lassen doppelt so viele weniger übrig** und kosten doppelt so viel.</translation>
    </message>
    <message>
        <source>Lead p0 at least 150&#x202f;px away. p1 is pulled after it.</source>
        <translation>Führe p0 mindestens 150&#x202f;px weg. p1 wird hinterhergezogen.</translation>
    </message>
    <message>
        <source>Stop inside a frame (**Shift+→**) when the pointer has moved p0 by 20&#x202f;px or more, and the stick has not acted.</source>
        <translation>Halte innerhalb eines Bildes an (**Umschalt+→**), wenn der Zeiger p0 um 20&#x202f;px oder mehr bewegt hat und der Stab noch nicht gewirkt hat.</translation>
    </message>
    <message>
        <source>With **share** at 1, lead the pointer around p1. p1 does not move at all.</source>
        <translation>Führe bei **Anteil** 1 den Zeiger um p1 herum. p1 bewegt sich gar nicht.</translation>
    </message>
    <message>
        <source>Set **share** to 0 and lead p0 at least 150&#x202f;px away. It stays at the pointer.</source>
        <translation>Setze **Anteil** auf 0 und führe p0 mindestens 150&#x202f;px weg. Er bleibt am Zeiger.</translation>
    </message>
    <message>
        <source>Then hold it still until all three sticks are right to 0.01&#x202f;px.</source>
        <translation>Halte ihn dann still, bis alle drei Stäbe bis auf 0,01&#x202f;px stimmen.</translation>
    </message>
    <message>
        <source>Set **length** to 150 and lead p0 off the line, until all three sticks are right to 0.01&#x202f;px.</source>
        <translation>Setze **Länge** auf 150 und führe p0 von der Linie weg, bis alle drei Stäbe bis auf 0,01&#x202f;px stimmen.</translation>
    </message>
    <message>
        <source>Lead p0 at least 150&#x202f;px away, and wait until every stick is right to 0.1&#x202f;px.</source>
        <translation>Führe p0 mindestens 150&#x202f;px weg und warte, bis jeder Stab bis auf 0,1&#x202f;px stimmt.</translation>
    </message>
    <message>
        <source>Set **triangles** to 15 and shake p0, until a stick is wrong by 20&#x202f;px.</source>
        <translation>Setze **Dreiecke** auf 15 und schüttle p0, bis ein Stab um 20&#x202f;px falsch ist.</translation>
    </message>
    <message>
        <source>Go back in time, change **length**, and compare with the ghost.</source>
        <translation>Geh in der Zeit zurück, ändere **Länge** und vergleiche mit dem Geist.</translation>
    </message>
    <message>
        <source>Set **iterations** to 20, carry the box 50&#x202f;px or more, drop it, and wait until it lies still.</source>
        <translation>Setze **Iterationen** auf 20, trag die Kiste 50&#x202f;px oder mehr, lass sie fallen und warte, bis sie still liegt.</translation>
    </message>
    <message>
        <source>Set **gravity** to 0 and throw it. A second later it still glides.</source>
        <translation>Setze **Schwerkraft** auf 0 und wirf sie. Eine Sekunde später gleitet sie immer noch.</translation>
    </message>
    <message>
        <source>Stop inside a frame when the sticks have moved points, and the velocity is still the old one.</source>
        <translation>Halte innerhalb eines Bildes an, wenn die Stäbe Punkte bewegt haben und die Geschwindigkeit noch die alte ist.</translation>
    </message>
    <message>
        <source>Set **iterations** to 1 and shake it, until a stick is wrong by 25&#x202f;%.</source>
        <translation>Setze **Iterationen** auf 1 und schüttle sie, bis ein Stab um 25&#x202f;% falsch ist.</translation>
    </message>
    <message>
        <source>Go back in time to before you threw it, change **iterations**, and compare with the ghost.</source>
        <translation>Geh in der Zeit zurück, bevor du sie geworfen hast, ändere **Iterationen** und vergleiche mit dem Geist.</translation>
    </message>
    <message>
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>limited</source>
        <translation>begrenzt</translation>
    </message>
    <message>
        <source>A stick measures its error and moves both ends by half of it: no spring, no velocity.</source>
        <translation>Ein Stab misst seinen Fehler und schiebt beide Enden um die Hälfte davon: keine Feder, keine Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Stop. Press the mouse button 50&#x2009;px or more beside p0 and keep it down. Then press **Shift+→** once.</source>
        <translation>Halte an. Drück die Maustaste 50&#x2009;px oder mehr neben p0 und halte sie gedrückt. Dann drück einmal **Umschalt+→**.</translation>
    </message>
    <message>
        <source>Type 0 into the field beside **Length**. Press **Space**, hold the mouse button down and lead p0 away.</source>
        <translation>Gib 0 in das Feld neben **Länge** ein. Drück die **Leertaste**, halte die Maustaste gedrückt und führe p0 weg.</translation>
    </message>
    <message>
        <source>Stick</source>
        <translation>Stab</translation>
    </message>
    <message>
        <source>stick|sticks</source>
        <translation>Stab|Stäbe|Stäben|Stabs</translation>
    </message>
    <message>
        <source>A rule that keeps two points at a fixed distance. It does not pull: it puts its ends where they belong.</source>
        <translation>Eine Regel, die zwei Punkte in einem festen Abstand hält. Sie zieht nicht: Sie setzt ihre Enden dorthin, wo sie hingehören.</translation>
    </message>
    <message>
        <source>Constraint</source>
        <translation>Zwangsbedingung</translation>
    </message>
    <message>
        <source>constraint|constraints</source>
        <translation>Zwangsbedingung|Zwangsbedingungen</translation>
    </message>
    <message>
        <source>A rule that must hold after each frame, whatever moved before: a distance, a wall, a joint that bends only so far.</source>
        <translation>Eine Regel, die nach jedem Bild gelten muss, was sich zuvor auch bewegt hat: ein Abstand, eine Wand, ein Gelenk, das sich nur so weit beugt.</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>the error|error</source>
        <translation>Fehler|Fehlers|Fehlern</translation>
    </message>
    <message>
        <source>Of a stick: how much too long it is, or too short (then it is below 0). Of a run: how far it is from the exact motion.</source>
        <translation>Bei einem Stab: um wie viel er zu lang ist oder zu kurz (dann unter 0). Bei einem Lauf: wie weit er von der exakten Bewegung entfernt ist.</translation>
    </message>
    <message>
        <source>Why half of the error each?</source>
        <translation>Warum jeder den halben Fehler?</translation>
    </message>
    <message>
        <source>A stick of 100&#x2009;px is 130&#x2009;px long. The error is

`130 − 100 = 30&#x2009;px`

Both ends move along the stick, towards each other. Together they have to come 30&#x2009;px, so each comes 15:

`share of a = w_a / (w_a + w_b)`

where w is how easily an end moves: 1 for both here, and 0 for a nail. Two ends that are as heavy share alike, and their middle stays where it is.</source>
        <translation>Ein Stab von 100&#x2009;px ist 130&#x2009;px lang. Der Fehler ist

`130 − 100 = 30&#x2009;px`

Beide Enden gehen am Stab entlang, aufeinander zu. Zusammen müssen sie 30&#x2009;px weit gehen, also jedes 15. Der Anteil (share) von a ist

`share of a = w_a / (w_a + w_b)`

Dabei ist w, wie leicht sich ein Ende bewegt: 1 für beide hier, und 0 für einen Nagel. Zwei gleich schwere Enden teilen gleich, und ihre Mitte bleibt, wo sie ist.</translation>
    </message>
    <message>
        <source>Who takes which share of the error decides who leads and who follows.</source>
        <translation>Wer welchen Anteil des Fehlers übernimmt, entscheidet, wer führt und wer folgt.</translation>
    </message>
    <message>
        <source>Leave **Share** at 1. Press **Space**, hold the mouse button down, and lead the pointer round p1 in a wide circle.</source>
        <translation>Lass **Anteil** auf 1. Drück die **Leertaste**, halte die Maustaste gedrückt und führe den Zeiger in weitem Kreis um p1.</translation>
    </message>
    <message>
        <source>Type 0 into the field beside **Share**. Press **Space**, hold the mouse button down and lead p0 to the other side of the picture.</source>
        <translation>Gib 0 in das Feld neben **Anteil** ein. Drück die **Leertaste**, halte die Maustaste gedrückt und führe p0 auf die andere Seite der Szene.</translation>
    </message>
    <message>
        <source>Type 0.5 into the field beside **Share**. Press **Space**, hold the mouse button down, move the pointer far away, and keep still.</source>
        <translation>Gib 0,5 in das Feld neben **Anteil** ein. Drück die **Leertaste**, halte die Maustaste gedrückt, bewege den Zeiger weit weg und halte still.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>The part of a stick’s error that one of its ends takes, from 0 to 1. The other end takes the rest.</source>
        <translation>Der Teil vom Fehler eines Stabs, den eines seiner Enden übernimmt, von 0 bis 1. Das andere Ende übernimmt den Rest.</translation>
    </message>
    <message>
        <source>Why does each frame leave share of the error?</source>
        <translation>Warum lässt jedes Bild den Anteil vom Fehler übrig?</translation>
    </message>
    <message>
        <source>The pointer puts p0 back each frame. The stick is then wrong by some error e. p0 takes share × e, p1 takes the rest:

`p1 comes (1 − share) × e nearer`

The pointer puts p0 back again. What p0 gave is undone, what p1 came stays. So what is left is

`e − (1 − share) × e = share × e`

At 0.5: a half, a quarter, an eighth. At 1 nothing ever gets better, at 0 one frame is enough.</source>
        <translation>Der Zeiger setzt p0 in jedem Bild zurück. Dann ist der Stab um einen Fehler e falsch. p0 übernimmt Anteil × e, p1 den Rest. So viel kommt p1 näher (share ist der Anteil):

`p1 comes (1 − share) × e nearer`

Der Zeiger setzt p0 wieder zurück. Was p0 gab, ist aufgehoben, was p1 kam, bleibt. Übrig ist also

`e − (1 − share) × e = share × e`

Bei 0,5: die Hälfte, ein Viertel, ein Achtel. Bei 1 wird nie etwas besser, bei 0 genügt ein Bild.</translation>
    </message>
    <message>
        <source>Each stick makes itself right and its neighbours a little wrong; frame by frame the error shrinks.</source>
        <translation>Jeder Stab stellt sich selbst richtig und seine Nachbarn ein wenig falsch; Bild für Bild schrumpft der Fehler.</translation>
    </message>
    <message>
        <source>Press **Space**, hold the mouse button down, and move the pointer quickly across the picture.</source>
        <translation>Drück die **Leertaste**, halte die Maustaste gedrückt und bewege den Zeiger schnell quer durch die Szene.</translation>
    </message>
    <message>
        <source>Keep the mouse button down and the pointer still for some seconds. The largest error stands above the parameters.</source>
        <translation>Halte die Maustaste gedrückt und den Zeiger einige Sekunden still. Der größte Fehler steht über den Parametern.</translation>
    </message>
    <message>
        <source>Type 150 into the field beside **Length**. Press **Space**, hold the mouse button down, lead p0 to the side, and keep still.</source>
        <translation>Gib 150 in das Feld neben **Länge** ein. Drück die **Leertaste**, halte die Maustaste gedrückt, führe p0 zur Seite und halte still.</translation>
    </message>
    <message>
        <source>A loop goes through a list of sticks, and the order of the list decides how fast a pull arrives.</source>
        <translation>Eine Schleife geht eine Liste von Stäben durch, und die Reihenfolge der Liste entscheidet, wie schnell ein Zug ankommt.</translation>
    </message>
    <message>
        <source>Press **Space**, hold the mouse button down, lead p0 across the picture, and keep still.</source>
        <translation>Drück die **Leertaste**, halte die Maustaste gedrückt, führe p0 quer durch die Szene und halte still.</translation>
    </message>
    <message>
        <source>Type 15 into the field beside **Triangles**. Press **Space**, hold the mouse button down, and shake p0 to and fro.</source>
        <translation>Gib 15 in das Feld neben **Dreiecke** ein. Drück die **Leertaste**, halte die Maustaste gedrückt und schüttle p0 hin und her.</translation>
    </message>
    <message>
        <source>Play and lead p0 for some seconds. Stop, drag the timeline back to the left, type another **Length**, and play on for a second.</source>
        <translation>Spiele ab und führe p0 einige Sekunden lang. Halte an, zieh die Zeitleiste nach links zurück, gib eine andere **Länge** ein und spiele eine Sekunde weiter.</translation>
    </message>
    <message>
        <source>A velocity that is the way a point came holds whatever moved the point, sticks and walls, too.</source>
        <translation>In einer Geschwindigkeit, die der Weg eines Punktes ist, steckt alles, was ihn bewegt hat, auch Stäbe und Wände.</translation>
    </message>
    <message>
        <source>Press **Space**. Take a corner of the box, swing it quickly to one side, and let go on the way.</source>
        <translation>Drück die **Leertaste**. Nimm eine Ecke der Kiste, schwing sie schnell zur Seite und lass unterwegs los.</translation>
    </message>
    <message>
        <source>Type 20 into the field beside **Iterations**. Press **Space**, lift the box by a corner, let go, and wait.</source>
        <translation>Gib 20 in das Feld neben **Iterationen** ein. Drück die **Leertaste**, heb die Kiste an einer Ecke hoch, lass los und warte.</translation>
    </message>
    <message>
        <source>Type 0 into the field beside **Gravity**. Press **Space**, throw the box, and watch it for a second.</source>
        <translation>Gib 0 in das Feld neben **Schwerkraft** ein. Drück die **Leertaste**, wirf die Kiste und sieh ihr eine Sekunde zu.</translation>
    </message>
    <message>
        <source>Verlet integration</source>
        <translation>Verlet-Integration</translation>
    </message>
    <message>
        <source>Verlet integration|Verlet</source>
        <translation>Verlet-Integration|Verlet</translation>
    </message>
    <message>
        <source>A method that keeps the last two places of a point in place of its velocity. The way from one to the other is the velocity.</source>
        <translation>Ein Verfahren, das statt der Geschwindigkeit eines Punktes seine letzten zwei Orte behält. Der Weg vom einen zum anderen ist die Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Iteration</source>
        <translation>Iteration</translation>
    </message>
    <message>
        <source>iterations|iteration</source>
        <translation>Iterationen|Iteration</translation>
    </message>
    <message>
        <source>One pass through the list of sticks. More of them in a frame make what the sticks hold stiffer.</source>
        <translation>Ein Durchgang durch die Liste der Stäbe. Mehr davon in einem Bild machen steifer, was die Stäbe halten.</translation>
    </message>
    <message>
        <source>friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>What holds back a thing that slides along a wall. The harder it is pressed against the wall, the more.</source>
        <translation>Was bremst, was an einer Wand entlanggleitet. Je fester es an die Wand gedrückt wird, desto mehr.</translation>
    </message>
    <message>
        <source>Why is a place minus a place a velocity?</source>
        <translation>Warum ist Ort minus Ort eine Geschwindigkeit?</translation>
    </message>
    <message>
        <source>A velocity is how far a thing comes in a frame. So it is already there, in the last two places:

`v = x − before`

The next place is this one, plus the velocity, plus what gravity adds:

`next = x + (x − before) + g`

And if a stick has moved x meanwhile, x − before is another number: the velocity knows of it without being told.</source>
        <translation>Eine Geschwindigkeit ist, wie weit etwas in einem Bild kommt. In den letzten zwei Orten (before: davor) steckt sie also schon:

`v = x − before`

Der nächste Ort ist dieser, plus die Geschwindigkeit, plus was die Schwerkraft hinzufügt:

`next = x + (x − before) + g`

Und hat ein Stab x inzwischen bewegt, ist x − before eine andere Zahl: Die Geschwindigkeit weiß davon, ohne dass es ihr jemand sagt.</translation>
    </message>
    <message>
        <source>Points, sticks and joint limits are enough for a whole figure; more passes leave less error.</source>
        <translation>Punkte, Stäbe und Gelenkgrenzen genügen für eine ganze Figur; mehr Durchgänge lassen weniger Fehler übrig.</translation>
    </message>
    <message>
        <source>Press **Space**. Take any joint, lift the figure, let go, and wait until it lies still.</source>
        <translation>Drück die **Leertaste**. Nimm irgendein Gelenk, heb die Figur hoch, lass los und warte, bis sie still liegt.</translation>
    </message>
    <message>
        <source>Press **Space**, take a joint, swing it quickly to one side, and let go on the way.</source>
        <translation>Drück die **Leertaste**, nimm ein Gelenk, schwing es schnell zur Seite und lass unterwegs los.</translation>
    </message>
    <message>
        <source>Type 1 into the field beside **Iterations**. Press **Space**, take a joint, and shake it to and fro.</source>
        <translation>Gib 1 in das Feld neben **Iterationen** ein. Drück die **Leertaste**, nimm ein Gelenk und schüttle es hin und her.</translation>
    </message>
    <message>
        <source>Throw the figure and stop. Drag the timeline back to before the throw, type another number of **Iterations**, and play on for a second.</source>
        <translation>Wirf die Figur und halte an. Zieh die Zeitleiste vor den Wurf zurück, gib eine andere Zahl bei **Iterationen** ein und spiele eine Sekunde weiter.</translation>
    </message>
    <message>
        <source>Joint limit</source>
        <translation>Gelenkgrenze</translation>
    </message>
    <message>
        <source>joint limits|joint limit</source>
        <translation>Gelenkgrenzen|Gelenkgrenze</translation>
    </message>
    <message>
        <source>A constraint on an angle: it acts only when a joint is bent farther than it may be.</source>
        <translation>Eine Zwangsbedingung für einen Winkel: Sie wirkt nur, wenn ein Gelenk weiter gebeugt ist, als es darf.</translation>
    </message>
    <message>
        <source>hold the mouse button down in the picture, and lead p0.</source>
        <translation>halte in der Szene die Maustaste gedrückt und führe p0.</translation>
    </message>
    <message>
        <source>lead p0 %2&#x202f;px away or more, with the mouse button down. So far: %1&#x202f;px.</source>
        <translation>führe p0 %2&#x202f;px weit weg oder mehr, mit gedrückter Maustaste. Bisher: %1&#x202f;px.</translation>
    </message>
    <message>
        <source>keep the pointer still. The largest error is %1&#x202f;px.</source>
        <translation>halte den Zeiger still. Der größte Fehler ist %1&#x202f;px.</translation>
    </message>
    <message>
        <source>move the pointer faster. The largest error is %1&#x202f;px.</source>
        <translation>bewege den Zeiger schneller. Der größte Fehler ist %1&#x202f;px.</translation>
    </message>
    <message>
        <source>throw it so that it hits a side wall.</source>
        <translation>wirf sie so, dass sie eine Seitenwand trifft.</translation>
    </message>
    <message>
        <source>let time run (**Space**): p1 has come %1&#x202f;px of 60&#x202f;px.</source>
        <translation>lass die Zeit laufen (**Leertaste**): p1 ist %1&#x202f;px von 60&#x202f;px weit gekommen.</translation>
    </message>
    <message>
        <source>press **Shift+→** until the pointer has moved p0, and the stick has not acted.</source>
        <translation>drück **Umschalt+→**, bis der Zeiger p0 bewegt hat und der Stab noch nicht gewirkt hat.</translation>
    </message>
    <message>
        <source>put the pointer farther from p0 before that frame. It was %1&#x202f;px.</source>
        <translation>setze den Zeiger vor diesem Bild weiter weg von p0. Es waren %1&#x202f;px.</translation>
    </message>
    <message>
        <source>Set **length** to 0 and lead p0 away, 50&#x202f;px or more. Where is p1?</source>
        <translation>Setze **Länge** auf 0 und führe p0 weg, 50&#x202f;px oder mehr. Wo ist p1?</translation>
    </message>
    <message>
        <source>let time run (**Space**) until the stick is right.</source>
        <translation>lass die Zeit laufen (**Leertaste**), bis der Stab stimmt.</translation>
    </message>
    <message>
        <source>In the same place as p0: a stick of 0&#x202f;px holds two points together.</source>
        <translation>Am selben Ort wie p0: Ein Stab von 0&#x202f;px hält zwei Punkte zusammen.</translation>
    </message>
    <message>
        <source>set **share** to 1.</source>
        <translation>setze **Anteil** auf 1.</translation>
    </message>
    <message>
        <source>lead the pointer on, so that p0 comes 20&#x202f;px or more in ten frames while p1 stands.</source>
        <translation>führe den Zeiger weiter, sodass p0 in zehn Bildern 20&#x202f;px oder mehr vorankommt, während p1 steht.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until p0 is at the pointer.</source>
        <translation>lass die Zeit laufen (**Leertaste**), bis p0 am Zeiger ist.</translation>
    </message>
    <message>
        <source>Set **share** to 0.5, lead p0 100&#x202f;px away or more, and hold the pointer still until p0 has come to it.</source>
        <translation>Setze **Anteil** auf 0,5, führe p0 100&#x202f;px weit weg oder mehr und halte den Zeiger still, bis p0 bei ihm ist.</translation>
    </message>
    <message>
        <source>hold the pointer still while time runs. p0 is %1&#x202f;px from it.</source>
        <translation>halte den Zeiger still, während die Zeit läuft. p0 ist %1&#x202f;px von ihm entfernt.</translation>
    </message>
    <message>
        <source>Lead p0 away so fast that a stick is wrong by 10&#x202f;px.</source>
        <translation>Führe p0 so schnell weg, dass ein Stab um 10&#x202f;px falsch ist.</translation>
    </message>
    <message>
        <source>Throw the box against a wall, at 5&#x202f;px per frame or more.</source>
        <translation>Wirf die Kiste gegen eine Wand, mit 5&#x202f;px pro Bild oder mehr.</translation>
    </message>
    <message>
        <source>press **Shift+→** until the sticks are the last phase that was done.</source>
        <translation>drück **Umschalt+→**, bis die Stäbe die letzte erledigte Phase sind.</translation>
    </message>
    <message>
        <source>Lift it by any point, 50&#x202f;px or more, drop it, and wait until it lies still.</source>
        <translation>Heb sie an irgendeinem Punkt 50&#x202f;px oder mehr an, lass sie fallen und warte, bis sie still liegt.</translation>
    </message>
    <message>
        <source>Throw it at a wall, at 5&#x202f;px per frame or more.</source>
        <translation>Wirf sie gegen eine Wand, mit 5&#x202f;px pro Bild oder mehr.</translation>
    </message>
    <message>
        <source>take it with the mouse, and shake it.</source>
        <translation>nimm sie mit der Maus und schüttle sie.</translation>
    </message>
    <message>
        <source>shake it harder. The worst stick is wrong by %1&#x202f;%.</source>
        <translation>schüttle sie kräftiger. Der schlimmste Stab ist um %1&#x202f;% falsch.</translation>
    </message>
    <message>
        <source>go back to before you threw it, and change **iterations** there.</source>
        <translation>geh vor den Wurf zurück und ändere dort **Iterationen**.</translation>
    </message>
    <message>
        <source>Stop, and press **Shift+→** until the strip under the timeline marks the sticks.</source>
        <translation>Halte an und drück **Umschalt+→**, bis der Streifen unter der Zeitleiste die Stäbe markiert.</translation>
    </message>
    <message>
        <source>Press **Space**. Hold the mouse button down in the picture and lead p0 into an upper corner.</source>
        <translation>Drück die **Leertaste**. Halte in der Szene die Maustaste gedrückt und führe p0 in eine obere Ecke.</translation>
    </message>
    <message>
        <source>the error of a stick</source>
        <translation>der Fehler eines Stabs</translation>
    </message>
    <message>
        <source>Write the **error** of the stick: by how much it is longer than it should be.</source>
        <translation>Schreibe den **Fehler** des Stabs: um wie viel er länger ist, als er sein soll.</translation>
    </message>
    <message>
        <source>double error: how much too long the stick is.</source>
        <translation>double error: um wie viel der Stab zu lang ist.</translation>
    </message>
    <message>
        <source>`d` leads from one end to the other, so its length is that of the stick now.</source>
        <translation>`d` führt von einem Ende zum anderen. Seine Länge ist also die des Stabs jetzt.</translation>
    </message>
    <message>
        <source>`length(d)` returns the length of a vector, and `stick.length` is the right one.</source>
        <translation>`length(d)` gibt die Länge eines Vektors zurück, und `stick.length` ist die richtige.</translation>
    </message>
    <message>
        <source>`double error = length(d) - …;`</source>
        <translation>`double error = length(d) - …;`</translation>
    </message>
    <message>
        <source>The sign is wrong: a stick that is too long gets longer still. The error is what there is, minus what there should be.</source>
        <translation>Das Vorzeichen ist falsch: Ein zu langer Stab wird noch länger. Der Fehler ist das, was ist, minus das, was sein soll.</translation>
    </message>
    <message>
        <source>This is the whole length, so the two ends meet. Subtract the right length.</source>
        <translation>Das ist die ganze Länge, darum treffen sich die zwei Enden. Subtrahiere die richtige Länge.</translation>
    </message>
    <message>
        <source>a shared error</source>
        <translation>ein geteilter Fehler</translation>
    </message>
    <message>
        <source>Share the **error** between the two ends: `a` takes the part `share_of_a` of it, and `b` the rest. At 0.5 each takes half.</source>
        <translation>Teile den **Fehler** zwischen den zwei Enden: `a` nimmt davon den Anteil `share_of_a` und `b` den Rest. Bei 0,5 nimmt jedes die Hälfte.</translation>
    </message>
    <message>
        <source>double part_of_a and part_of_b: the error, shared.</source>
        <translation>double part_of_a und part_of_b: der Fehler, geteilt.</translation>
    </message>
    <message>
        <source>Together the two parts have to be the whole error.</source>
        <translation>Zusammen müssen die zwei Teile der ganze Fehler sein.</translation>
    </message>
    <message>
        <source>If `a` takes a share of 0.3, what is left for `b` is 1 - 0.3.</source>
        <translation>Nimmt `a` einen Anteil von 0,3, bleibt für `b` noch 1 - 0,3.</translation>
    </message>
    <message>
        <source>`double part_of_a = error * …;` and `double part_of_b = error * (1 - …);`</source>
        <translation>`double part_of_a = error * …;` und `double part_of_b = error * (1 - …);`</translation>
    </message>
    <message>
        <source>Both ends take the whole error, so the stick is as much too short as it was too long.</source>
        <translation>Beide Enden nehmen den ganzen Fehler. Darum ist der Stab nun so viel zu kurz, wie er zu lang war.</translation>
    </message>
    <message>
        <source>Both take half, whatever the shares are. Use `share_of_a`.</source>
        <translation>Beide nehmen die Hälfte, was die Anteile auch sind. Nimm `share_of_a`.</translation>
    </message>
    <message>
        <source>The two parts are equal. They add up to the whole error only at a share of 0.5.</source>
        <translation>Die zwei Teile sind gleich. Nur bei einem Anteil von 0,5 ergeben sie zusammen den ganzen Fehler.</translation>
    </message>
    <message>
        <source>The two shares are swapped.</source>
        <translation>Die zwei Anteile sind vertauscht.</translation>
    </message>
    <message>
        <source>one stick after the other</source>
        <translation>ein Stab nach dem anderen</translation>
    </message>
    <message>
        <source>Write the **loop** that gives every stick its length back, in the order of the list.</source>
        <translation>Schreibe die **Schleife**, die jedem Stab seine Länge zurückgibt, in der Reihenfolge der Liste.</translation>
    </message>
    <message>
        <source>Enforce every stick.</source>
        <translation>Stelle jeden Stab richtig.</translation>
    </message>
    <message>
        <source>There are `sticks.count` sticks, from the number 0 on.</source>
        <translation>Es gibt `sticks.count` Stäbe, von der Nummer 0 an.</translation>
    </message>
    <message>
        <source>`enforce(stick)` gives one stick its length back.</source>
        <translation>`enforce(stick)` gibt einem Stab seine Länge zurück.</translation>
    </message>
    <message>
        <source>`for (int i = 0; i &lt; …; i++)`, and in it `enforce(sticks[…]);`</source>
        <translation>`for (int i = 0; i &lt; …; i++)`, und darin `enforce(sticks[…]);`</translation>
    </message>
    <message>
        <source>The loop leaves out the first stick. It has the number 0.</source>
        <translation>Die Schleife lässt den ersten Stab aus. Er hat die Nummer 0.</translation>
    </message>
    <message>
        <source>The loop leaves out the last stick.</source>
        <translation>Die Schleife lässt den letzten Stab aus.</translation>
    </message>
    <message>
        <source>The loop begins with the last stick. Each stick changes the ones before it, so the order matters.</source>
        <translation>Die Schleife beginnt mit dem letzten Stab. Jeder Stab verändert die davor, darum kommt es auf die Reihenfolge an.</translation>
    </message>
    <message>
        <source>the whole frame</source>
        <translation>das ganze Bild</translation>
    </message>
    <message>
        <source>**From the empty page:** write the whole frame of the figure of sticks. The pointer carries the first point, your hand can hold any point, and each stick gets its length back.</source>
        <translation>**Von der leeren Seite:** Schreibe das ganze Bild der Figur aus Stäben. Der Zeiger trägt den ersten Punkt, deine Hand kann jeden Punkt halten, und jeder Stab bekommt seine Länge zurück.</translation>
    </message>
    <message>
        <source>First the points: one that is held goes to `hand`. The first point goes to `pointer` if `pointer_known` and it is not held. Then each stick, in order.</source>
        <translation>Zuerst die Punkte: Ein gehaltener geht zu `hand`. Der erste Punkt geht zu `pointer`, wenn `pointer_known` gilt und er nicht gehalten wird. Dann jeder Stab, der Reihe nach.</translation>
    </message>
    <message>
        <source>A stick: its error is its length now minus `stick.length`. `stick.a` takes the part `stick.share`, and `stick.b` the rest. If one end is held, the other takes all.</source>
        <translation>Ein Stab: Sein Fehler ist seine Länge jetzt minus `stick.length`. `stick.a` nimmt den Anteil `stick.share` und `stick.b` den Rest. Wird ein Ende gehalten, nimmt das andere alles.</translation>
    </message>
    <message>
        <source>With `Vec2 out = direction(stick.b, stick.a);`: `stick.a.position -= error * share * out;` and `stick.b.position += error * (1 - share) * out;`</source>
        <translation>Mit `Vec2 out = direction(stick.b, stick.a);`: `stick.a.position -= error * share * out;` und `stick.b.position += error * (1 - share) * out;`</translation>
    </message>
    <message>
        <source>The rest is right, but both ends take the whole error.</source>
        <translation>Der Rest stimmt, aber beide Enden nehmen den ganzen Fehler.</translation>
    </message>
    <message>
        <source>The rest is right, but the first stick is left out. It has the number 0.</source>
        <translation>Der Rest stimmt, aber der erste Stab ist ausgelassen. Er hat die Nummer 0.</translation>
    </message>
    <message>
        <source>The rest is right, but the sticks come in the wrong order.</source>
        <translation>Der Rest stimmt, aber die Stäbe kommen in der falschen Reihenfolge.</translation>
    </message>
    <message>
        <source>Verlet’s new place</source>
        <translation>Verlets neuer Ort</translation>
    </message>
    <message>
        <source>Write the **new place** of a point that falls: gravity adds to its velocity, damping takes its share of both, and then it moves.</source>
        <translation>Schreibe den **neuen Ort** eines Punktes, der fällt: Die Schwerkraft kommt zu seiner Geschwindigkeit hinzu, die Dämpfung nimmt ihren Anteil von beidem, und dann bewegt er sich.</translation>
    </message>
    <message>
        <source>The point falls, is damped, and moves.</source>
        <translation>Der Punkt fällt, wird gedämpft und bewegt sich.</translation>
    </message>
    <message>
        <source>Gravity adds `gravity` to the velocity in y.</source>
        <translation>Die Schwerkraft addiert `gravity` zur Geschwindigkeit in y.</translation>
    </message>
    <message>
        <source>Damping comes after gravity, so it takes its share of the sum.</source>
        <translation>Die Dämpfung kommt nach der Schwerkraft und nimmt ihren Anteil von der Summe.</translation>
    </message>
    <message>
        <source>`point.velocity = damp * (point.velocity + Vec2(0, …));` and then the move.</source>
        <translation>`point.velocity = damp * (point.velocity + Vec2(0, …));` und dann die Bewegung.</translation>
    </message>
    <message>
        <source>Damping takes its share before gravity. It should take its share of the sum.</source>
        <translation>Die Dämpfung nimmt ihren Anteil vor der Schwerkraft. Sie soll ihn von der Summe nehmen.</translation>
    </message>
    <message>
        <source>Nothing falls: gravity is missing.</source>
        <translation>Nichts fällt: Die Schwerkraft fehlt.</translation>
    </message>
    <message>
        <source>This gravity pulls to the right. Down is y, the second number.</source>
        <translation>Diese Schwerkraft zieht nach rechts. Nach unten ist y, die zweite Zahl.</translation>
    </message>
    <message>
        <source>The point moves by the velocity of the last frame. Move it last.</source>
        <translation>Der Punkt bewegt sich mit der Geschwindigkeit des letzten Bildes. Bewege ihn zuletzt.</translation>
    </message>
    <message>
        <source>the velocity after the sticks</source>
        <translation>die Geschwindigkeit nach den Stäben</translation>
    </message>
    <message>
        <source>Sticks and walls have moved the points. Write the **velocity** of each: how far it came in this frame.</source>
        <translation>Stäbe und Wände haben die Punkte bewegt. Schreibe von jedem die **Geschwindigkeit**: wie weit er in diesem Bild kam.</translation>
    </message>
    <message>
        <source>The velocity of each point: how far it came.</source>
        <translation>Die Geschwindigkeit jedes Punktes: wie weit er kam.</translation>
    </message>
    <message>
        <source>`before` is where a point was when the frame began.</source>
        <translation>`before` ist, wo ein Punkt war, als das Bild begann.</translation>
    </message>
    <message>
        <source>How far a point came is its position now minus the one before.</source>
        <translation>Wie weit ein Punkt kam, ist sein Ort jetzt minus der Ort davor.</translation>
    </message>
    <message>
        <source>In a loop: `points[i].velocity = points[i].position - …;`</source>
        <translation>In einer Schleife: `points[i].velocity = points[i].position - …;`</translation>
    </message>
    <message>
        <source>The velocity points backwards: it leads from now to before.</source>
        <translation>Die Geschwindigkeit zeigt rückwärts: Sie führt von jetzt nach vorher.</translation>
    </message>
    <message>
        <source>With `+=` each velocity counts twice. Set it with `=`.</source>
        <translation>Mit `+=` zählt jede Geschwindigkeit doppelt. Setze sie mit `=`.</translation>
    </message>
    <message>
        <source>Write the whole frame. The names: points[i] (with position, held), points.count, sticks[i] (with a, b, length, share), sticks.count, hand, pointer, pointer_known.</source>
        <translation>Schreibe das ganze Bild. Die Namen: points[i] (mit position, held), points.count, sticks[i] (mit a, b, length, share), sticks.count, hand, pointer, pointer_known.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Rigid constraints</source>
        <translation>Starre Stäbe</translation>
    </message>
    <message>
        <source>Sticks that keep their length, from one pair to a ragdoll to throw about.</source>
        <translation>Stäbe, die ihre Länge behalten, von einem Paar bis zu einer Gliederpuppe zum Herumwerfen.</translation>
    </message>
</context>
</TS>
