<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>SwayingTree</name>
    <message>
        <source>corrected</source>
        <translation>korrigiert</translation>
    </message>
    <message>
        <source>published</source>
        <translation>veröffentlicht</translation>
    </message>
    <message>
        <source>%1 px off</source>
        <translation>%1 px daneben</translation>
    </message>
    <message>
        <source>front</source>
        <translation>Vorderseite</translation>
    </message>
    <message>
        <source>end</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Part of the tree is below the ground: the rule turns angles, and knows no ground.</source>
        <translation>Ein Teil des Baums liegt unter dem Boden: Die Regel dreht Winkel und kennt keinen Boden.</translation>
    </message>
    <message>
        <source>Branches</source>
        <translation>Zweige</translation>
    </message>
    <message>
        <source>How many branches the tree has.</source>
        <translation>Wie viele Zweige der Baum hat.</translation>
    </message>
    <message>
        <source>Largest bend</source>
        <translation>Größte Biegung</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>How far the most bent branch is turned from where it grew.</source>
        <translation>Wie weit der am meisten gebogene Zweig von dort gedreht ist, wo er wuchs.</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Of motion and springs together. Without wind and damping it stays.</source>
        <translation>Von Bewegung und Federn zusammen. Ohne Wind und Dämpfung bleibt sie.</translation>
    </message>
    <message>
        <source>In motion</source>
        <translation>In Bewegung</translation>
    </message>
    <message>
        <source>The part that is in the turning branches.</source>
        <translation>Der Teil, der in den sich drehenden Zweigen steckt.</translation>
    </message>
    <message>
        <source>In springs</source>
        <translation>In Federn</translation>
    </message>
    <message>
        <source>The part that the bent joints hold.</source>
        <translation>Der Teil, den die gebogenen Gelenke halten.</translation>
    </message>
    <message>
        <source>The trunk</source>
        <translation>Der Stamm</translation>
    </message>
    <message>
        <source>Where a branch ends, two smaller ones begin. One leans 30° to the left of it, one to the right: that is the **spread**. Each is 0.8 times as large: the **slope**. And each of them does the same.

Such a rule that uses itself needs an end. A branch grows only while it is **larger than 0.2** of the trunk. That makes 8 levels: 1 + 2 + 4 + … + 128 = **255 branches** from one rule.

With a slope of 1 nothing would get smaller and the tree would never end. So the levels are counted before it grows, and a tree of more than 131071 branches is refused.

Branches are numbered level by level, from left to right: 0 is the trunk.</source>
        <translation>Wo ein Zweig endet, beginnen zwei kleinere. Einer neigt sich um 30° nach links von ihm, einer nach rechts: Das ist die **Spreizung**. Jeder ist 0,8-mal so groß: die **Verjüngung**. Und jeder von ihnen tut dasselbe.

Eine solche Regel, die sich selbst verwendet, braucht ein Ende. Ein Zweig wächst nur, solange er **größer als 0,2** vom Stamm ist. Das ergibt 8 Ebenen: 1 + 2 + 4 + … + 128 = **255 Zweige** aus einer Regel.

Mit einer Verjüngung von 1 würde nichts kleiner, und der Baum hätte kein Ende. Darum werden die Ebenen gezählt, bevor er wächst, und ein Baum mit mehr als 131071 Zweigen wird abgelehnt.

Zweige sind Ebene für Ebene nummeriert, von links nach rechts: 0 ist der Stamm.</translation>
    </message>
    <message>
        <source>A little chance</source>
        <translation>Ein wenig Zufall</translation>
    </message>
    <message>
        <source>Real trees are not so neat. So each new branch is turned by a little more: by chance, up to 10° to either side. That is the **jitter**.

A branch leans from where its parent points. So what chance did to the parent, its children carry on, and one change near the trunk turns a whole bough.

Each number of chance is worked out from the branch’s own number and the **seed**, a whole number that belongs to the experiment. So the same seed grows the same tree, each time that you go back to the start.

A variable or two are enough for quite other patterns. The **gallery** has some; from one of them, go on by yourself.</source>
        <translation>Echte Bäume sind nicht so ordentlich. Darum wird jeder neue Zweig noch ein wenig mehr gedreht: zufällig, bis zu 10° nach jeder Seite. Das ist die **Streuung**.

Ein Zweig neigt sich von der Richtung seines Elternzweigs weg. Was der Zufall mit den Eltern tat, tragen die Kinder also weiter, und eine Änderung nahe am Stamm dreht einen ganzen Ast.

Jede Zufallszahl wird aus der Nummer des Zweigs und dem **Startwert** (seed) berechnet, einer ganzen Zahl, die zum Experiment gehört. Derselbe Startwert lässt also denselben Baum wachsen, jedes Mal, wenn du zum Anfang zurückgehst.

Ein, zwei Variablen genügen für ganz andere Muster. Die **Beispiele** zeigen einige; von dort aus mach selbst weiter.</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Formel</translation>
    </message>
    <message>
        <source>What the tutorial’s text means, or what its code prints.</source>
        <translation>Was der Text des Tutorials meint oder was sein Code tut, so wie er gedruckt ist.</translation>
    </message>
    <message>
        <source>Trunk length</source>
        <translation>Stammlänge</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>How long the trunk is. All branches grow and shrink with it.</source>
        <translation>Wie lang der Stamm ist. Alle Zweige wachsen und schrumpfen mit ihm.</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Spreizung</translation>
    </message>
    <message>
        <source>How far a branch leans away from its parent.</source>
        <translation>Wie weit sich ein Zweig von seinem Elternzweig wegneigt.</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Verjüngung</translation>
    </message>
    <message>
        <source>How large a branch is, as a share of its parent.</source>
        <translation>Wie groß ein Zweig ist, als Anteil seines Elternzweigs.</translation>
    </message>
    <message>
        <source>Smallest branch</source>
        <translation>Kleinster Zweig</translation>
    </message>
    <message>
        <source>Branches must be larger than this share of the trunk.</source>
        <translation>Zweige müssen größer sein als dieser Anteil des Stamms.</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>How much chance may turn a new branch, to either side.</source>
        <translation>Wie weit der Zufall einen neuen Zweig drehen darf, nach jeder Seite.</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Langsamkeit</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>How slowly a branch turns: each frame by the missing angle divided by this.</source>
        <translation>Wie langsam ein Zweig sich dreht: in jedem Bild um den fehlenden Winkel, geteilt durch diese Zahl.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>How hard the wind blows. 0 is a calm.</source>
        <translation>Wie stark der Wind weht. 0 ist Windstille.</translation>
    </message>
    <message>
        <source>Turbulence</source>
        <translation>Turbulenz</translation>
    </message>
    <message>
        <source>How much chance may turn the wind in each frame, to either side.</source>
        <translation>Wie weit der Zufall den Wind in jedem Bild drehen darf, nach jeder Seite.</translation>
    </message>
    <message>
        <source>Gust speed</source>
        <translation>Böentempo</translation>
    </message>
    <message>
        <source>px/frame</source>
        <translation>px/Bild</translation>
    </message>
    <message>
        <source>How fast a gust runs outwards from the pointer.</source>
        <translation>Wie schnell eine Bö vom Zeiger nach außen läuft.</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Böen</translation>
    </message>
    <message>
        <source>The share by which the wind swells and ebbs as it runs. 0 is a steady wind.</source>
        <translation>Der Anteil, um den der Wind beim Laufen an- und abschwillt. 0 ist ein steter Wind.</translation>
    </message>
    <message>
        <source>Poplar</source>
        <translation>Pappel</translation>
    </message>
    <message>
        <source>A small spread makes a narrow crown that reaches up.</source>
        <translation>Eine kleine Spreizung ergibt eine schmale Krone, die nach oben strebt.</translation>
    </message>
    <message>
        <source>Honeycomb</source>
        <translation>Bienenwabe</translation>
    </message>
    <message>
        <source>At 60 degrees without jitter, branches meet and draw a net of hexagons.</source>
        <translation>Bei 60 Grad ohne Streuung treffen sich Zweige und zeichnen ein Netz aus Sechsecken.</translation>
    </message>
    <message>
        <source>City plan</source>
        <translation>Stadtplan</translation>
    </message>
    <message>
        <source>Right angles, each branch 0.71 of its parent: streets that fill a rectangle.</source>
        <translation>Rechte Winkel, jeder Zweig 0,71 seines Elternzweigs: Straßen, die ein Rechteck füllen.</translation>
    </message>
    <message>
        <source>Lace</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>Turned by 130 degrees, branches fold back on themselves and fill a triangle.</source>
        <translation>Um 130 Grad gedreht, falten sich Zweige auf sich selbst zurück und füllen ein Dreieck.</translation>
    </message>
    <message>
        <source>Cauliflower</source>
        <translation>Blumenkohl</translation>
    </message>
    <message>
        <source>Short steps and a slow slope: many branches of nearly one size.</source>
        <translation>Kurze Glieder und eine langsame Verjüngung: viele Zweige von fast einer Größe.</translation>
    </message>
    <message>
        <source>Thicket</source>
        <translation>Dickicht</translation>
    </message>
    <message>
        <source>With a jitter of 90 degrees chance has the last word.</source>
        <translation>Mit einer Streuung von 90 Grad hat der Zufall das letzte Wort.</translation>
    </message>
    <message>
        <source>Make the trunk half as high as the stage: set **trunk length** to 200.</source>
        <translation>Mach den Stamm halb so hoch wie die Szene: Setze **Stammlänge** auf 200.</translation>
    </message>
    <message>
        <source>Switch **Formula** to published. Find its 0.0116&#x202f;px in the code: the x of `end` is no longer 275.</source>
        <translation>Stelle **Formel** auf veröffentlicht. Such seine 0,0116&#x202f;px im Code: Das x von `end` ist nicht mehr 275.</translation>
    </message>
    <message>
        <source>Make a tree with just three branches: raise **smallest branch**.</source>
        <translation>Mach einen Baum mit nur drei Zweigen: Erhöhe **Kleinster Zweig**.</translation>
    </message>
    <message>
        <source>Set **spread** to 90°. Which way do the branches of every second level point?</source>
        <translation>Setze **Spreizung** auf 90°. In welche Richtung zeigen die Zweige jeder zweiten Ebene?</translation>
    </message>
    <message>
        <source>Set **slope** to 0.7. How many levels are left, and how many branches?</source>
        <translation>Setze **Verjüngung** auf 0,7. Wie viele Ebenen bleiben, und wie viele Zweige?</translation>
    </message>
    <message>
        <source>Set **jitter** to 0, and the tree of the step before is back.</source>
        <translation>Setze **Streuung** auf 0, und der Baum des vorigen Schritts ist wieder da.</translation>
    </message>
    <message>
        <source>Set **jitter** to 60°. Is it still a tree?</source>
        <translation>Setze **Streuung** auf 60°. Ist das noch ein Baum?</translation>
    </message>
    <message>
        <source>Choose a tree from the gallery, or make one of your own with another **spread**.</source>
        <translation>Wähle einen Baum aus den Beispielen oder mach einen eigenen mit anderer **Spreizung**.</translation>
    </message>
    <message>
        <source>Hold the button down beside the tree. Every branch points at you.</source>
        <translation>Halte neben dem Baum die Taste gedrückt. Jeder Zweig zeigt auf dich.</translation>
    </message>
    <message>
        <source>Do the same with **Formula** set to published, and hold still. Count the frames until the whole tree points at you.</source>
        <translation>Tu dasselbe mit **Formel** auf veröffentlicht und halte still. Zähl die Bilder, bis der ganze Baum auf dich zeigt.</translation>
    </message>
    <message>
        <source>Hold the button down low beside the trunk, then let go. Does the tree get up again?</source>
        <translation>Halte die Taste tief neben dem Stamm gedrückt, dann lass los. Steht der Baum wieder auf?</translation>
    </message>
    <message>
        <source>Blow until the trunk leans by more than 60°.</source>
        <translation>Blase, bis der Stamm sich um mehr als 60° neigt.</translation>
    </message>
    <message>
        <source>Blow from close by. Go back a few frames, set **Formula** to published, and play on: the ghost is the wind as meant.</source>
        <translation>Blase aus der Nähe. Geh ein paar Bilder zurück, stelle **Formel** auf veröffentlicht und spiele weiter: Der Geist ist der Wind, wie er gemeint war.</translation>
    </message>
    <message>
        <source>Bend a branch by more than 60°, let go, and count the frames until all are back within 1°.</source>
        <translation>Bieg einen Zweig um mehr als 60°, lass los und zähl die Bilder, bis alle innerhalb von 1° zurück sind.</translation>
    </message>
    <message>
        <source>Do the same with **ease** at 30. How much longer does it take?</source>
        <translation>Tu dasselbe mit **Langsamkeit** auf 30. Wie viel länger dauert es?</translation>
    </message>
    <message>
        <source>Stop inside a frame (**Shift+→**) when the tree has returned and the wind has not bent it yet.</source>
        <translation>Halte innerhalb eines Bildes an (**Umschalt+→**), wenn der Baum zurückgekehrt ist und der Wind ihn noch nicht gebogen hat.</translation>
    </message>
    <message>
        <source>Blow at a twig from less than 20&#x202f;px until it is bent by more than 30°.</source>
        <translation>Blase aus weniger als 20&#x202f;px auf einen Zweig, bis er um mehr als 30° gebogen ist.</translation>
    </message>
    <message>
        <source>While you blow, go back a few frames, set **Formula** to published, and play on. Which tree bends more?</source>
        <translation>Geh beim Blasen ein paar Bilder zurück, stelle **Formel** auf veröffentlicht und spiele weiter. Welcher Baum biegt sich mehr?</translation>
    </message>
    <message>
        <source>Set **wind** to 20 and lean the trunk by 10°.</source>
        <translation>Setze **Wind** auf 20 und neige den Stamm um 10°.</translation>
    </message>
    <message>
        <source>While you blow from close by, go back a few frames, set **Formula** to published, and play on. Which twigs quiver?</source>
        <translation>Geh beim Blasen aus der Nähe ein paar Bilder zurück, stelle **Formel** auf veröffentlicht und spiele weiter. Welche Zweige zittern?</translation>
    </message>
    <message>
        <source>Hold the button for 60&#x202f;frames and watch the twigs, then the trunk.</source>
        <translation>Halte die Taste 60&#x202f;Bilder lang und beobachte die feinen Zweige, dann den Stamm.</translation>
    </message>
    <message>
        <source>Go back to where your wind began, set **turbulence** to 0, and play on. The ghost trembles, the tree does not.</source>
        <translation>Geh zum Beginn deines Windes zurück, setze **Turbulenz** auf 0 und spiele weiter. Der Geist zittert, der Baum nicht.</translation>
    </message>
    <message>
        <source>Blow, let go, and watch: the trunk swings past its rest, towards where the wind came from.</source>
        <translation>Blase, lass los und sieh zu: Der Stamm schwingt über seine Ruhelage hinaus, dorthin, woher der Wind kam.</translation>
    </message>
    <message>
        <source>Hold the button at the left edge and stop (**Space**) when the gust has reached some branches, but not all.</source>
        <translation>Halte die Taste am linken Rand und halte an (**Leertaste**), wenn die Bö einige Zweige erreicht hat, aber nicht alle.</translation>
    </message>
    <message>
        <source>Set **damping** to 1, blow, and let go. After 300&#x202f;frames it still sways: look at the energy.</source>
        <translation>Setze **Dämpfung** auf 1, blase und lass los. Nach 300&#x202f;Bildern schwankt er noch immer: Sieh dir die Energie an.</translation>
    </message>
    <message>
        <source>To the pointer</source>
        <translation>Zum Zeiger</translation>
    </message>
    <message>
        <source>Hold the button down: every branch turns to the pointer. The trunk turns first. Then its children move to where it ends now, turn in their turn, and move theirs: from the trunk to the twigs.

The tutorial takes the line from the branch’s end to the pointer, and its code **adds** the end where the text means the distance between the two. That slip makes it work: the branch comes round in a few frames. With a minus it would flip to and fro as soon as the pointer is nearer than two lengths.

**Corrected** takes the line from the branch’s origin, so one frame will do. The two dashed lines show what each formula wants of the branch next to the pointer.</source>
        <translation>Halte die Taste gedrückt: Jeder Zweig dreht sich zum Zeiger. Zuerst dreht sich der Stamm. Dann gehen seine Kinder dorthin, wo er jetzt endet, drehen sich ihrerseits und bewegen ihre: vom Stamm bis zu den feinsten Zweigen.

Das Tutorial nimmt die Linie vom Ende des Zweigs zum Zeiger, und sein Code **addiert** das Ende, wo der Text den Abstand der beiden meint. Durch diesen Ausrutscher funktioniert es: Der Zweig kommt in wenigen Bildern herum. Mit einem Minus würde er hin und her klappen, sobald der Zeiger näher als zwei Längen ist.

**Korrigiert** nimmt die Linie vom Anfang des Zweigs, darum genügt ein Bild. Die zwei gestrichelten Linien zeigen, was jede Formel von dem Zweig neben dem Zeiger will.</translation>
    </message>
    <message>
        <source>Wind blows **away** from you, and nothing bends at once. Each frame a branch turns by the missing angle divided by **ease**, 8: fast at first, then slower. Within 1° it stays.

From an angle of −170° to one of 170° it is 20° the short way round, not 340°. So a way past **180°, to either side**, is taken the other way round.

The published code differs in two places. It adds the end point to the pointer where the way between the two is meant, so it blows to a wrong side when the pointer is near. And its second test has 360 for 180, so some branches take the long way. The dashed lines show both winds at the branch next to the pointer. Nothing brings the tree back yet.</source>
        <translation>Wind weht **von dir weg**, und nichts biegt sich auf einmal. In jedem Bild dreht sich ein Zweig um den fehlenden Winkel, geteilt durch **Langsamkeit**, 8: erst schnell, dann langsamer. Innerhalb von 1° bleibt er.

Von einem Winkel von −170° zu einem von 170° sind es auf dem kurzen Weg 20°, nicht 340°. Darum wird ein Weg über **180°, nach jeder Seite**, andersherum genommen.

Der veröffentlichte Code unterscheidet sich an zwei Stellen. Er addiert den Endpunkt zum Zeiger, wo der Weg zwischen den beiden gemeint ist, darum bläst er zu einer falschen Seite, wenn der Zeiger nahe ist. Und sein zweiter Test hat 360 statt 180, darum nehmen manche Zweige den langen Weg. Die gestrichelten Linien zeigen beide Winde an dem Zweig neben dem Zeiger. Noch bringt nichts den Baum zurück.</translation>
    </message>
    <message>
        <source>Back to rest</source>
        <translation>Zurück zur Ruhe</translation>
    </message>
    <message>
        <source>Each branch keeps a second angle: the one at which it grew, **rest**. In every frame, wind or not, it turns back by the missing angle divided by **ease**. It is the formula of the wind with another target.

While you hold the button both act, one after the other: first the whole tree returns, then the wind bends it. Both take an eighth of what they miss, so a branch stays about half-way between the two.

Let go, and an eighth of the way is left out each frame: after 5&#x202f;frames half of the bend is left. Within 1° a branch stays where it is. Nothing swings past its rest, as nothing here has a velocity.</source>
        <translation>Jeder Zweig behält einen zweiten Winkel: den, mit dem er wuchs, **Ruhe** (rest). In jedem Bild, ob Wind oder nicht, dreht er sich um den fehlenden Winkel, geteilt durch **Langsamkeit**, zurück. Es ist die Formel des Windes mit einem anderen Ziel.

Solange du die Taste hältst, wirken beide, eins nach dem anderen: Erst kehrt der ganze Baum zurück, dann biegt ihn der Wind. Beide nehmen ein Achtel von dem, was ihnen fehlt, darum bleibt ein Zweig etwa auf halbem Weg zwischen beiden.

Lass los, und in jedem Bild fällt ein Achtel des Wegs weg: Nach 5&#x202f;Bildern ist die Hälfte der Biegung übrig. Innerhalb von 1° bleibt ein Zweig, wo er ist. Nichts schwingt über seine Ruhelage hinaus, denn nichts hat hier eine Geschwindigkeit.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Close to you the wind should be strong, and far away weak. So the 8 in the wind’s formula gives way to the **distance** between the pointer and the branch’s end: at 100&#x202f;px a branch turns by a hundredth of the missing angle each frame. Its way back is still an eighth, so far branches hardly bend.

Nearer than 1&#x202f;px that would be more than all of it. **Corrected** stops at the wind’s angle, and with the pointer on the very end it takes a direction that belongs to the branch. The published code shoots past, and divides by 0 there.

Its distance is in the branch’s own measure, too: for a branch half as large it counts twice.</source>
        <translation>Nahe bei dir soll der Wind stark sein, und weit weg schwach. Darum weicht die 8 in der Formel des Windes dem **Abstand** zwischen dem Zeiger und dem Ende des Zweigs: Bei 100&#x202f;px dreht sich ein Zweig in jedem Bild um ein Hundertstel des fehlenden Winkels. Sein Rückweg ist noch immer ein Achtel, darum biegen sich ferne Zweige kaum.

Näher als 1&#x202f;px wäre das mehr als der ganze fehlende Winkel. **Korrigiert** hält beim Winkel des Windes an, und mit dem Zeiger genau auf dem Ende nimmt es eine Richtung, die zum Zweig gehört. Der veröffentlichte Code schießt darüber hinaus und teilt dort durch 0.

Auch ist sein Abstand im eigenen Maß des Zweigs: Bei einem halb so großen Zweig zählt er doppelt.</translation>
    </message>
    <message>
        <source>Thickness</source>
        <translation>Dicke</translation>
    </message>
    <message>
        <source>Thick branches resist. The distance is multiplied by the branch’s **scale twice**: a twig of 0.2 has 0.04 of the trunk’s resistance, so it turns 25 times as fast. Then all of it is divided by **wind**, 5.

The tutorial says that dividing by 5 decreases the strength of the wind. But its variable `strength` divides the bend, so a smaller one bends more: 5 makes the wind **five times stronger**.

Where distance × scale² / 5 is less than 1, the published code turns a twig by more than the missing angle, past the wind and back. That is much of the quiver near the pointer. **Corrected** stops at the wind’s angle.</source>
        <translation>Dicke Zweige widerstehen. Der Abstand wird **zweimal mit der Größe** (scale) des Zweigs multipliziert: Ein Zweig von 0,2 hat 0,04 vom Widerstand des Stamms, also dreht er sich 25-mal so schnell. Dann wird alles durch **Wind**, 5, geteilt.

Das Tutorial sagt, durch 5 zu teilen, mache den Wind schwächer. Aber seine Variable `strength` teilt die Biegung, darum biegt eine kleinere mehr: 5 macht den Wind **fünfmal stärker**.

Wo Abstand × Größe² / 5 kleiner als 1 ist, dreht der veröffentlichte Code einen Zweig um mehr als den fehlenden Winkel, über den Wind hinaus und zurück. Daher kommt viel von dem Zittern nahe am Zeiger. **Korrigiert** hält beim Winkel des Windes an.</translation>
    </message>
    <message>
        <source>Real wind is never steady. Once a frame, chance turns the wind’s angle by up to 20° to either side, **the same for all branches**. Twigs follow at once, so they tremble. The trunk is slow: for it, the changes of many frames cancel.

Chance is worked out from the seed and the frame’s number. So when you go back in time, the same gusts come again. An experiment file can give a frame’s turbulence itself, as a `gust` in degrees.

This is where the tutorial ends. It moves **angles**: they have no velocity, so this tree never swings past its rest. The last step is ours. Try the **gallery** in this wind first.</source>
        <translation>Echter Wind ist nie stet. Einmal pro Bild dreht der Zufall den Winkel des Windes um bis zu 20° nach jeder Seite, **gleich für alle Zweige**. Feine Zweige folgen sofort, darum zittern sie. Der Stamm ist langsam: Für ihn heben sich die Änderungen vieler Bilder auf.

Der Zufall wird aus dem Startwert und der Nummer des Bildes berechnet. Gehst du also in der Zeit zurück, kommen dieselben Böen wieder. Eine Experimentdatei kann die Turbulenz eines Bildes selbst angeben, als `gust` in Grad.

Hier endet das Tutorial. Es bewegt **Winkel**: Sie haben keine Geschwindigkeit, darum schwingt dieser Baum nie über seine Ruhelage hinaus. Der letzte Schritt ist unserer. Probier zuerst die **Beispiele** in diesem Wind aus.</translation>
    </message>
    <message>
        <source>How hard a joint turns its branch back: for a lone trunk, this share of its bend each frame.</source>
        <translation>Wie stark ein Gelenk seinen Zweig zurückdreht: für einen Stamm allein dieser Anteil seiner Biegung, in jedem Bild.</translation>
    </message>
    <message>
        <source>The share of its spin that every branch keeps each frame. 1 keeps it all.</source>
        <translation>Der Anteil seiner Drehung, den jeder Zweig in jedem Bild behält. 1 behält alles.</translation>
    </message>
    <message>
        <source>A real sway</source>
        <translation>Echtes Schwanken</translation>
    </message>
    <message>
        <source>Now every joint is a **spring that turns**: its torque is its stiffness times its twist. The branch feels it one way, its parent **the opposite way**. That is how a gust in the twigs moves the trunk.

A branch has a **spin**, in degrees per frame. Its inertia is its own, plus what it carries at its end; its stiffness is k × inertia / scale. So a lone trunk is the spring of lesson 1, and thin branches swing faster.

Wind pushes by the sine of the angle between branch and wind. A gust runs outwards at **gust speed**: far branches feel it later. Let go, and the tree swings past its rest.

With these values a step can be up to 3.1&#x202f;frames long. Without damping and wind the energy stays.</source>
        <translation>Jetzt ist jedes Gelenk eine **Feder, die dreht**: Ihr Drehmoment ist ihre Steifigkeit mal ihre Verdrehung. Der Zweig spürt es in die eine Richtung, sein Elternzweig **in die andere**. So bewegt eine Bö in den feinen Zweigen den Stamm.

Ein Zweig hat eine **Drehgeschwindigkeit**, in Grad pro Bild. Seine Trägheit ist seine eigene, plus was er an seinem Ende trägt; seine Steifigkeit ist k × Trägheit / Größe. Ein Stamm allein ist also die Feder aus Lektion 1, und dünne Zweige schwingen schneller.

Wind schiebt mit dem Sinus des Winkels zwischen Zweig und Wind. Eine Bö läuft mit dem **Böentempo** nach außen: Ferne Zweige spüren sie später. Lass los, und der Baum schwingt über seine Ruhelage hinaus.

Mit diesen Werten kann ein Zeitschritt bis zu 3,1&#x202f;Bilder lang sein. Ohne Dämpfung und Wind bleibt die Energie.</translation>
    </message>
    <message>
        <source>A branch is an origin, an angle and a length; cos and sin tell where it ends.</source>
        <translation>Ein Zweig ist ein Anfang, ein Winkel und eine Länge; cos und sin sagen, wo er endet.</translation>
    </message>
    <message>
        <source>Type 200 into the field beside **Trunk length**.</source>
        <translation>Gib 200 in das Feld neben **Stammlänge** ein.</translation>
    </message>
    <message>
        <source>Sine and cosine</source>
        <translation>Sinus und Kosinus</translation>
    </message>
    <message>
        <source>cos and sin|sine</source>
        <translation>cos und sin|Sinus|Kosinus</translation>
    </message>
    <message>
        <source>The two numbers of a way of 1&#x2009;px at an angle: cos is how far to the right, sin how far down.</source>
        <translation>Die zwei Zahlen eines Wegs von 1&#x2009;px in einem Winkel: cos ist, wie weit nach rechts, sin, wie weit nach unten.</translation>
    </message>
    <message>
        <source>Why divide by 57.2958?</source>
        <translation>Warum durch 57,2958 teilen?</translation>
    </message>
    <message>
        <source>A full turn is 360°. Counted by the arc of a circle of radius 1 it is 2π:

`360° = 2π rad = 6.2832&#x2009;rad`

So one radian is

`360° / 6.2832 = 57.2958°`

cos and sin count in radians. An angle in degrees is divided by that number first:

`−90° / 57.2958 = −1.5708&#x2009;rad`</source>
        <translation>Eine volle Drehung ist 360°. Gezählt am Bogen eines Kreises mit Radius 1 ist sie 2π:

`360° = 2π rad = 6,2832&#x2009;rad`

Ein Radiant ist also

`360° / 6,2832 = 57,2958°`

cos und sin zählen in Radiant. Ein Winkel in Grad wird erst durch diese Zahl geteilt:

`−90° / 57,2958 = −1,5708&#x2009;rad`</translation>
    </message>
    <message>
        <source>A rule that uses itself grows a whole tree, and a smallest size ends it.</source>
        <translation>Eine Regel, die sich selbst verwendet, lässt einen ganzen Baum wachsen, und eine kleinste Größe beendet sie.</translation>
    </message>
    <message>
        <source>Type 90 into the field beside **Spread**.</source>
        <translation>Gib 90 in das Feld neben **Spreizung** ein.</translation>
    </message>
    <message>
        <source>Type 0.7 into the field beside **Slope**. The number of branches stands above the parameters.</source>
        <translation>Gib 0,7 in das Feld neben **Verjüngung** ein. Die Zahl der Zweige steht über den Parametern.</translation>
    </message>
    <message>
        <source>Rule that uses itself</source>
        <translation>Regel, die sich selbst verwendet</translation>
    </message>
    <message>
        <source>rule that uses itself</source>
        <translation>Regel, die sich selbst verwendet</translation>
    </message>
    <message>
        <source>A rule whose last part is: and now do the same again, with something smaller. Its name is recursion. It needs an end.</source>
        <translation>Eine Regel, deren letzter Teil lautet: Und jetzt dasselbe noch einmal, mit etwas Kleinerem. Man nennt das Rekursion. Sie braucht ein Ende.</translation>
    </message>
    <message>
        <source>Chance that is worked out from a seed makes a tree look real and grow the same each time.</source>
        <translation>Zufall, der aus einem Startwert berechnet wird, lässt einen Baum echt aussehen und jedes Mal gleich wachsen.</translation>
    </message>
    <message>
        <source>Type 0 into the field beside **Jitter**.</source>
        <translation>Gib 0 in das Feld neben **Streuung** ein.</translation>
    </message>
    <message>
        <source>Type 60 into the field beside **Jitter**.</source>
        <translation>Gib 60 in das Feld neben **Streuung** ein.</translation>
    </message>
    <message>
        <source>Above the parameters, press **Presets** and choose a picture. Or type another number beside **Spread**.</source>
        <translation>Drück über den Parametern **Beispiele** und wähle ein Bild. Oder gib neben **Spreizung** eine andere Zahl ein.</translation>
    </message>
    <message>
        <source>jitter</source>
        <translation>Streuung</translation>
    </message>
    <message>
        <source>How far chance may turn a thing from where it should point.</source>
        <translation>Wie weit der Zufall etwas von der Richtung wegdrehen darf, in die es zeigen soll.</translation>
    </message>
    <message>
        <source>Every branch turns from the trunk outwards, as a child begins where its parent ends.</source>
        <translation>Jeder Zweig dreht sich, vom Stamm nach außen, denn ein Kind beginnt, wo sein Elternzweig endet.</translation>
    </message>
    <message>
        <source>Press **Space**. Put the pointer into the picture beside the tree, hold the mouse button down, and keep still.</source>
        <translation>Drück die **Leertaste**. Setze den Zeiger neben den Baum, halte die Maustaste gedrückt und halte still.</translation>
    </message>
    <message>
        <source>Choose **published** beside **Formula**. Then hold the mouse button down beside the tree and count.</source>
        <translation>Wähle **veröffentlicht** neben **Formel**. Dann halte neben dem Baum die Maustaste gedrückt und zähl mit.</translation>
    </message>
    <message>
        <source>Press **Space**. Hold the mouse button down near the ground, right of the trunk, for a moment, and let go.</source>
        <translation>Drück die **Leertaste**. Halte nahe am Boden, rechts vom Stamm, kurz die Maustaste gedrückt und lass los.</translation>
    </message>
    <message>
        <source>To turn by a part of what is missing is fast at first and then slower, and it has to go the short way round.</source>
        <translation>Sich um einen Teil des Fehlenden zu drehen, ist erst schnell und dann langsamer, und es muss auf dem kurzen Weg geschehen.</translation>
    </message>
    <message>
        <source>Press **Space**. Hold the mouse button down low in the left or right corner for two seconds.</source>
        <translation>Drück die **Leertaste**. Halte tief in der linken oder rechten Ecke zwei Sekunden lang die Maustaste gedrückt.</translation>
    </message>
    <message>
        <source>ease</source>
        <translation>Langsamkeit</translation>
    </message>
    <message>
        <source>Each frame a branch turns by the missing angle divided by this number. So it starts fast and arrives gently.</source>
        <translation>In jedem Bild dreht sich ein Zweig um den fehlenden Winkel, geteilt durch diese Zahl. Darum beginnt er schnell und kommt sanft an.</translation>
    </message>
    <message>
        <source>Why 180° and not 360°?</source>
        <translation>Warum 180° und nicht 360°?</translation>
    </message>
    <message>
        <source>Two angles a turn apart are the same direction. From −170° to 170° one can go

`170 − (−170) = 340°`

or the other way round:

`340 − 360 = −20°`

The short way is never more than half a turn. So if what is missing is more than 180°, take a whole turn off it; if it is less than −180°, add one. Were the test at 360°, every way between 180° and 360° would be taken the long way.</source>
        <translation>Zwei Winkel, die eine Drehung auseinanderliegen, sind dieselbe Richtung. Von −170° nach 170° kann man

`170 − (−170) = 340°`

gehen, oder andersherum:

`340 − 360 = −20°`

Der kurze Weg ist nie mehr als eine halbe Drehung. Fehlen also mehr als 180°, zieh eine ganze Drehung ab; sind es weniger als −180°, zähl eine dazu. Läge der Test bei 360°, würde jeder Weg zwischen 180° und 360° auf dem langen Weg genommen.</translation>
    </message>
    <message>
        <source>A branch that remembers the angle at which it grew comes back to it, and without a velocity it never swings past.</source>
        <translation>Ein Zweig, der sich den Winkel merkt, mit dem er wuchs, kehrt zu ihm zurück, und ohne Geschwindigkeit schwingt er nie darüber hinaus.</translation>
    </message>
    <message>
        <source>Press **Space**. Hold the mouse button down at the foot of the trunk for two seconds, let go, and wait.</source>
        <translation>Drück die **Leertaste**. Halte am Fuß des Stamms zwei Sekunden lang die Maustaste gedrückt, lass los und warte.</translation>
    </message>
    <message>
        <source>Type 30 into the field beside **Ease**. Hold the mouse button down at the foot of the trunk for seven seconds, let go, and wait.</source>
        <translation>Gib 30 in das Feld neben **Langsamkeit** ein. Halte am Fuß des Stamms sieben Sekunden lang die Maustaste gedrückt, lass los und warte.</translation>
    </message>
    <message>
        <source>Press **Space** and hold the mouse button down beside the tree. With the button down, press **Space** to stop, and then **Shift+→** until the tree has returned.</source>
        <translation>Drück die **Leertaste** und halte neben dem Baum die Maustaste gedrückt. Drück bei gehaltener Maustaste die **Leertaste**, um anzuhalten, und dann **Umschalt+→**, bis der Baum zurückgekehrt ist.</translation>
    </message>
    <message>
        <source>Divided by the distance, the wind is strong near by and weak far away.</source>
        <translation>Durch den Abstand geteilt, ist der Wind in der Nähe stark und in der Ferne schwach.</translation>
    </message>
    <message>
        <source>Press **Space**. Hold the mouse button down right at the end of a twig, and follow the twig.</source>
        <translation>Drück die **Leertaste**. Halte genau am Ende eines feinen Zweigs die Maustaste gedrückt und folge dem Zweig.</translation>
    </message>
    <message>
        <source>Thick branches resist by their scale twice, so twigs turn first.</source>
        <translation>Dicke Zweige widerstehen mit ihrer Größe gleich zweimal, darum drehen sich die feinen zuerst.</translation>
    </message>
    <message>
        <source>Press **Space**, and hold the mouse button down left of the crown for a second.</source>
        <translation>Drück die **Leertaste** und halte links von der Krone eine Sekunde lang die Maustaste gedrückt.</translation>
    </message>
    <message>
        <source>Type 20 into the field beside **Wind**. Press **Space**, and hold the mouse button down close beside the trunk for two seconds.</source>
        <translation>Gib 20 in das Feld neben **Wind** ein. Drück die **Leertaste** und halte dicht neben dem Stamm zwei Sekunden lang die Maustaste gedrückt.</translation>
    </message>
    <message>
        <source>The same chance for all branches makes twigs tremble, while the trunk hardly feels it.</source>
        <translation>Derselbe Zufall für alle Zweige lässt die feinen zittern, während der Stamm ihn kaum spürt.</translation>
    </message>
    <message>
        <source>Press **Space**, and hold the mouse button down left of the crown for three seconds.</source>
        <translation>Drück die **Leertaste** und halte links von der Krone drei Sekunden lang die Maustaste gedrückt.</translation>
    </message>
    <message>
        <source>Hold the mouse button down for two seconds while it plays, and stop. Drag the timeline back to soon after the wind began, type 0 beside **Turbulence**, and play on.</source>
        <translation>Halte beim Abspielen zwei Sekunden lang die Maustaste gedrückt und halte dann an. Zieh die Zeitleiste bis kurz nach dem Beginn des Windes zurück, gib 0 neben **Turbulenz** ein und spiele weiter.</translation>
    </message>
    <message>
        <source>Above the parameters, press **Presets** and choose a picture. Press **Space** and hold the mouse button down close to the tree.</source>
        <translation>Drück über den Parametern **Beispiele** und wähle ein Bild. Drück die **Leertaste** und halte dicht am Baum die Maustaste gedrückt.</translation>
    </message>
    <message>
        <source>turbulence</source>
        <translation>Turbulenz</translation>
    </message>
    <message>
        <source>How far chance turns the wind in each frame, the same for all.</source>
        <translation>Wie weit der Zufall den Wind in jedem Bild dreht, für alle gleich.</translation>
    </message>
    <message>
        <source>With a spin and a spring in each joint, a gust in the twigs moves the trunk, and the tree swings past its rest.</source>
        <translation>Mit einer Drehgeschwindigkeit und einer Feder in jedem Gelenk bewegt eine Bö in den feinen Zweigen den Stamm, und der Baum schwingt über seine Ruhelage hinaus.</translation>
    </message>
    <message>
        <source>Press **Space**. Hold the mouse button down left of the tree for two seconds, let go, and wait.</source>
        <translation>Drück die **Leertaste**. Halte links vom Baum zwei Sekunden lang die Maustaste gedrückt, lass los und warte.</translation>
    </message>
    <message>
        <source>Press **Space**, and press the mouse button at the left edge. Half a second later, with the button down, press **Space** again.</source>
        <translation>Drück die **Leertaste** und am linken Rand die Maustaste. Halte sie gedrückt, und drück eine halbe Sekunde später noch einmal die **Leertaste**.</translation>
    </message>
    <message>
        <source>Type 1 into the field beside **Damping**. Press **Space**, hold the mouse button down for a second, let go, and wait ten seconds.</source>
        <translation>Gib 1 in das Feld neben **Dämpfung** ein. Drück die **Leertaste**, halte eine Sekunde lang die Maustaste gedrückt, lass los und warte zehn Sekunden.</translation>
    </message>
    <message>
        <source>Above the parameters, press **Presets** and choose a picture. Press **Space** and hold the mouse button down left of the tree for two seconds.</source>
        <translation>Drück über den Parametern **Beispiele** und wähle ein Bild. Drück die **Leertaste** und halte links vom Baum zwei Sekunden lang die Maustaste gedrückt.</translation>
    </message>
    <message>
        <source>Torque</source>
        <translation>Drehmoment</translation>
    </message>
    <message>
        <source>torque</source>
        <translation>Drehmoment|Drehmoments</translation>
    </message>
    <message>
        <source>What turns a thing, as a pull moves it. A joint that is twisted twice as far turns back twice as hard.</source>
        <translation>Was etwas dreht, so wie ein Zug es bewegt. Ein Gelenk, das doppelt so weit verdreht ist, dreht doppelt so stark zurück.</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>Drehgeschwindigkeit</translation>
    </message>
    <message>
        <source>spin</source>
        <translation>Drehgeschwindigkeit</translation>
    </message>
    <message>
        <source>How far a thing turns in a frame, in degrees. What velocity is to a place, spin is to an angle.</source>
        <translation>Wie weit sich etwas in einem Bild dreht, in Grad. Was die Geschwindigkeit für einen Ort ist, ist sie für einen Winkel.</translation>
    </message>
    <message>
        <source>Inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>inertia</source>
        <translation>Trägheit</translation>
    </message>
    <message>
        <source>How hard it is to set a thing turning, or to stop it. More mass farther out means more of it.</source>
        <translation>Wie schwer es ist, etwas in Drehung zu versetzen oder anzuhalten. Mehr Masse weiter außen bedeutet mehr davon. (In der Physik heißt sie Trägheitsmoment.)</translation>
    </message>
    <message>
        <source>hold the mouse button down in the picture.</source>
        <translation>halte in der Szene die Maustaste gedrückt.</translation>
    </message>
    <message>
        <source>hold the mouse button down beside the tree, and let go.</source>
        <translation>halte neben dem Baum die Maustaste gedrückt und lass los.</translation>
    </message>
    <message>
        <source>go on blowing while time runs. So far: %1&#x202f;frames of %2.</source>
        <translation>blase weiter, während die Zeit läuft. Bisher: %1&#x202f;Bilder von %2.</translation>
    </message>
    <message>
        <source>hold still while time runs (**Space**). Some branch is off by %1°.</source>
        <translation>halte still, während die Zeit läuft (**Leertaste**). Ein Zweig weicht um %1° ab.</translation>
    </message>
    <message>
        <source>go on until the trunk leans by more than %2°. Now: %1°.</source>
        <translation>mach weiter, bis sich der Stamm um mehr als %2° neigt. Jetzt: %1°.</translation>
    </message>
    <message>
        <source>bend a branch by more than 60° before you let go. It was %1°.</source>
        <translation>biege einen Zweig um mehr als 60°, bevor du loslässt. Es waren %1°.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until all are back within 1°. Some branch is off by %1°.</source>
        <translation>lass die Zeit laufen (**Leertaste**), bis alle bis auf 1° zurück sind. Ein Zweig weicht um %1° ab.</translation>
    </message>
    <message>
        <source>set **ease** to 30.</source>
        <translation>setze **Langsamkeit** auf 30.</translation>
    </message>
    <message>
        <source>Choose another tree from the gallery and blow at it, until a branch is bent by more than 10°.</source>
        <translation>Wähle einen anderen Baum aus den Beispielen und blase auf ihn, bis ein Zweig um mehr als 10° gebogen ist.</translation>
    </message>
    <message>
        <source>blow on while time runs. The most that a branch is bent: %1°.</source>
        <translation>blase weiter, während die Zeit läuft. Am meisten gebogen ist ein Zweig um %1°.</translation>
    </message>
    <message>
        <source>make it three branches. This tree has %1.</source>
        <translation>mach drei Zweige daraus. Dieser Baum hat %1.</translation>
    </message>
    <message>
        <source>Straight up and down. Those of the levels between point left and right.</source>
        <translation>Gerade nach oben und unten. Die der Ebenen dazwischen zeigen nach links und rechts.</translation>
    </message>
    <message>
        <source>5 levels with 1 + 2 + 4 + 8 + 16 = 31 branches: at the next level they would be 0.17 of the trunk, less than 0.2.</source>
        <translation>5 Ebenen mit 1 + 2 + 4 + 8 + 16 = 31 Zweigen: In der nächsten wären sie 0,17 des Stamms, weniger als 0,2.</translation>
    </message>
    <message>
        <source>Hardly: chance turns branches farther than they spread, so some grow back towards the ground.</source>
        <translation>Kaum: Der Zufall dreht Zweige weiter, als sie sich spreizen, also wachsen manche zurück zum Boden.</translation>
    </message>
    <message>
        <source>set **Formula** to corrected.</source>
        <translation>setze **Formel** auf korrigiert.</translation>
    </message>
    <message>
        <source>hold the button lower, so that the trunk leans by more than 45°. Yours leans by %1°.</source>
        <translation>halte die Taste tiefer, sodass sich der Stamm um mehr als 45° neigt. Er neigt sich um %1°.</translation>
    </message>
    <message>
        <source>No. Nothing turns a branch back: it stays as it was turned last.</source>
        <translation>Nein. Nichts dreht einen Zweig zurück: Er bleibt so, wie er zuletzt gedreht wurde.</translation>
    </message>
    <message>
        <source>Set **ease** to 30 and blow for ten frames. With 2 the tree turns much faster.</source>
        <translation>Setze **Langsamkeit** auf 30 und blase zehn Bilder lang. Mit 2 dreht sich der Baum viel schneller.</translation>
    </message>
    <message>
        <source>About four times as long: each frame takes a thirtieth of the way that is left, not an eighth.</source>
        <translation>Etwa viermal so lang: Jedes Bild nimmt ein Dreißigstel des Wegs, der noch fehlt, und kein Achtel.</translation>
    </message>
    <message>
        <source>press **Shift+→** until the return is the last phase that was done.</source>
        <translation>drück **Umschalt+→**, bis die Rückkehr die letzte erledigte Phase ist.</translation>
    </message>
    <message>
        <source>blow for a while first: nothing is bent by more than 1°.</source>
        <translation>blase zuerst eine Weile: Nichts ist um mehr als 1° gebogen.</translation>
    </message>
    <message>
        <source>blow from less than 20&#x202f;px from the end of a twig. It is %1&#x202f;px.</source>
        <translation>blase aus weniger als 20&#x202f;px vom Ende eines feinen Zweigs. Es sind %1&#x202f;px.</translation>
    </message>
    <message>
        <source>follow the twig. It is bent by %1°.</source>
        <translation>folge dem feinen Zweig. Er ist um %1° gebogen.</translation>
    </message>
    <message>
        <source>Now from far away, for example from a corner, for 60&#x202f;frames: nothing bends by more than 15°.</source>
        <translation>Jetzt von weit weg, zum Beispiel aus einer Ecke, 60&#x202f;Bilder lang: Nichts biegt sich um mehr als 15°.</translation>
    </message>
    <message>
        <source>blow from farther away. Some branch is bent by %1°.</source>
        <translation>blase von weiter weg. Ein Zweig ist um %1° gebogen.</translation>
    </message>
    <message>
        <source>The corrected one. In the published formula the same distance counts twice for a branch half as large.</source>
        <translation>Der korrigierte. In der veröffentlichten Formel zählt derselbe Abstand für einen halb so großen Zweig doppelt.</translation>
    </message>
    <message>
        <source>Blow until some twig is bent by more than 20°, and twenty times as far as the trunk.</source>
        <translation>Blase, bis ein feiner Zweig um mehr als 20° gebogen ist, und zwanzigmal so weit wie der Stamm.</translation>
    </message>
    <message>
        <source>blow from closer. The most that a twig is bent: %1°.</source>
        <translation>blase aus größerer Nähe. Am meisten gebogen ist ein Zweig um %1°.</translation>
    </message>
    <message>
        <source>blow at a twig far from the trunk. It is bent %1 times as far as the trunk.</source>
        <translation>blase auf einen feinen Zweig weit weg vom Stamm. Er ist %1-mal so weit gebogen wie der Stamm.</translation>
    </message>
    <message>
        <source>The twigs of the published formula that are close to you: a frame turns them past the wind, the next one back.</source>
        <translation>Die feinen Zweige der veröffentlichten Formel in deiner Nähe: Ein Bild dreht sie am Wind vorbei, das nächste zurück.</translation>
    </message>
    <message>
        <source>set **turbulence** to 0 there.</source>
        <translation>setze dort **Turbulenz** auf 0.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until the trunk swings past its rest, by 0.5° or more. If it does not, blow harder.</source>
        <translation>lass die Zeit laufen (**Leertaste**), bis der Stamm um 0,5° oder mehr über seine Ruhelage hinausschwingt. Tut er es nicht, blase stärker.</translation>
    </message>
    <message>
        <source>stop when the gust has reached some branches, but not all. Hold the button at the left edge, and press **Space** earlier or later.</source>
        <translation>halte an, wenn die Bö einige Zweige erreicht hat, aber nicht alle. Halte die Taste am linken Rand und drück die **Leertaste** früher oder später.</translation>
    </message>
    <message>
        <source>hands off, and let time run for 300&#x202f;frames. So far: %1.</source>
        <translation>Hände weg, und lass die Zeit 300&#x202f;Bilder lang laufen. Bisher: %1.</translation>
    </message>
    <message>
        <source>blow harder: nothing is bent by more than 1°.</source>
        <translation>blase stärker: Nichts ist um mehr als 1° gebogen.</translation>
    </message>
    <message>
        <source>A branch is three things: where it begins, its **angle**, and its length. Where it ends follows: `cos` and `sin` of the angle, times the length, lead from its origin to its end.

The trunk begins in the middle of the ground, 275&#x202f;px to the right and 400&#x202f;px down. Its angle is −90°: y points down, so angles grow clockwise, and minus a quarter turn is straight up. It is 100&#x202f;px long.

`cos` and `sin` take radians, so the angle is divided by the degrees to a radian: 57.2958. The tutorial behind this lesson divides by 57.3. That leans the trunk by 0.0066° to the right, and its end is 0.0116&#x202f;px off. The list **Formula** offers both.</source>
        <translation>Ein Zweig ist dreierlei: wo er beginnt, sein **Winkel** und seine Länge. Wo er endet, folgt daraus: `cos` und `sin` des Winkels, mal die Länge, führen von seinem Anfang zu seinem Ende.

Der Stamm beginnt in der Mitte des Bodens, 275&#x202f;px nach rechts und 400&#x202f;px nach unten. Sein Winkel ist −90°: y zeigt nach unten, darum wachsen Winkel im Uhrzeigersinn, und minus eine Vierteldrehung ist gerade nach oben. Er ist 100&#x202f;px lang.

`cos` und `sin` nehmen Radiant, darum wird der Winkel durch die Grad pro Radiant geteilt: 57,2958. Das Tutorial, auf dem diese Lektion beruht, teilt durch 57,3. Das neigt den Stamm um 0,0066° nach rechts, und sein Ende ist 0,0116&#x202f;px daneben. Die Liste **Formel** bietet beide an.</translation>
    </message>
    <message>
        <source>Choose **published** beside **Formula**, and press **→**. Then rest the pointer on `end` in the code.</source>
        <translation>Wähle **veröffentlicht** neben **Formel** und drück **→**. Halte dann den Zeiger im Code über `end`.</translation>
    </message>
    <message>
        <source>The children of the trunk are 0.8 (or 0.7) as large, and their children 0.64 (or 0.49). Type 0.65 beside **Smallest branch**.</source>
        <translation>Die Kinder des Stamms sind 0,8-mal (oder 0,7-mal) so groß, deren Kinder 0,64-mal (oder 0,49-mal). Gib 0,65 neben **Kleinster Zweig** ein.</translation>
    </message>
    <message>
        <source>Press **Home**. Type 2 beside **Ease**, press **Space**, and hold the mouse button down for a second. Then type 30 beside **Ease**, and hold it again.</source>
        <translation>Drück **Pos1**. Gib 2 neben **Langsamkeit** ein, drück die **Leertaste** und halte eine Sekunde lang die Maustaste gedrückt. Dann gib 30 neben **Langsamkeit** ein und halte sie noch einmal.</translation>
    </message>
    <message>
        <source>Press **Home**, then **Space**, and hold the mouse button down close to the tree for two seconds. Stop, drag the timeline back by twenty frames, choose **published** beside **Formula**, and play on.</source>
        <translation>Drück **Pos1**, dann die **Leertaste**, und halte dicht am Baum zwei Sekunden lang die Maustaste gedrückt. Halte an, zieh die Zeitleiste um zwanzig Bilder zurück, wähle **veröffentlicht** neben **Formel** und spiele weiter.</translation>
    </message>
    <message>
        <source>Press **Space**, and hold the mouse button down in an upper corner of the picture for three seconds.</source>
        <translation>Drück die **Leertaste** und halte in einer oberen Ecke der Szene drei Sekunden lang die Maustaste gedrückt.</translation>
    </message>
    <message>
        <source>Press **Space** and hold the mouse button down for two seconds. Stop, drag the timeline back by twenty frames, choose **published** beside **Formula**, and play on.</source>
        <translation>Drück die **Leertaste** und halte zwei Sekunden lang die Maustaste gedrückt. Halte an, zieh die Zeitleiste um zwanzig Bilder zurück, wähle **veröffentlicht** neben **Formel** und spiele weiter.</translation>
    </message>
    <message>
        <source>Press **Home**, then **Space**, and hold the mouse button down on a twig in the crown for two seconds. Stop, drag the timeline back by twenty frames, choose **published** beside **Formula**, and play on.</source>
        <translation>Drück **Pos1**, dann die **Leertaste**, und halte auf einem Zweig in der Krone zwei Sekunden lang die Maustaste gedrückt. Halte an, zieh die Zeitleiste um zwanzig Bilder zurück, wähle **veröffentlicht** neben **Formel** und spiele weiter.</translation>
    </message>
    <message>
        <source>go back farther, to where you were still blowing, and choose it there.</source>
        <translation>geh weiter zurück, dorthin, wo du noch geblasen hast, und wähle sie dort.</translation>
    </message>
    <message>
        <source>a function that calls itself</source>
        <translation>eine Funktion, die sich selbst aufruft</translation>
    </message>
    <message>
        <source>Write where the **children begin**: where the branch ends. Each child then places its own children in the same way.</source>
        <translation>Schreibe, wo die **Kinder beginnen**: wo der Zweig endet. Jedes Kind setzt dann auf dieselbe Weise seine eigenen Kinder.</translation>
    </message>
    <message>
        <source>Find the end of the branch, and place each child there.</source>
        <translation>Finde das Ende des Zweigs und setze jedes Kind dorthin.</translation>
    </message>
    <message>
        <source>The end is `reach(branch)` away from the beginning, if the branch is as large as the trunk. A smaller one reaches `branch.scale` times as far.</source>
        <translation>Das Ende ist `reach(branch)` vom Anfang entfernt, wenn der Zweig so groß wie der Stamm ist. Ein kleinerer reicht `branch.scale` mal so weit.</translation>
    </message>
    <message>
        <source>A loop over `branch.children.count` calls the function itself for each child.</source>
        <translation>Eine Schleife über `branch.children.count` ruft die Funktion selbst für jedes Kind auf.</translation>
    </message>
    <message>
        <source>`Vec2 end = branch.position + branch.scale * …;` and in the loop `place(branch.children[i], …);`</source>
        <translation>`Vec2 end = branch.position + branch.scale * …;` und in der Schleife `place(branch.children[i], …);`</translation>
    </message>
    <message>
        <source>All branches begin in one place: the children begin where the branch begins. They belong at its end.</source>
        <translation>Alle Zweige beginnen an einem Ort: Die Kinder beginnen, wo der Zweig beginnt. Sie gehören an sein Ende.</translation>
    </message>
    <message>
        <source>Each branch is as long as the trunk. Multiply by `branch.scale`.</source>
        <translation>Jeder Zweig ist so lang wie der Stamm. Multipliziere mit `branch.scale`.</translation>
    </message>
    <message>
        <source>Only the first child follows. And a branch without children has no number 0.</source>
        <translation>Nur das erste Kind folgt. Und ein Zweig ohne Kinder hat keine Nummer 0.</translation>
    </message>
    <message>
        <source>The tree grows from the wrong end: the branch leads from its beginning to its end with a plus.</source>
        <translation>Der Baum wächst vom falschen Ende aus: Der Zweig führt mit einem Plus von seinem Anfang zu seinem Ende.</translation>
    </message>
    <message>
        <source>turn towards the pointer</source>
        <translation>zum Zeiger drehen</translation>
    </message>
    <message>
        <source>Write the **angle** with which the branch points along `way`. An angle of a branch is in degrees.</source>
        <translation>Schreibe den **Winkel**, mit dem der Zweig entlang `way` zeigt. Ein Zweig hat seinen Winkel in Grad.</translation>
    </message>
    <message>
        <source>Set the angle of the branch.</source>
        <translation>Setze den Winkel des Zweigs.</translation>
    </message>
    <message>
        <source>`atan2` makes an angle of a y and an x. It is in radians.</source>
        <translation>`atan2` macht aus einem y und einem x einen Winkel. Er ist in Radiant.</translation>
    </message>
    <message>
        <source>The function `degrees()` returns how many degrees are in one radian.</source>
        <translation>Die Funktion `degrees()` gibt zurück, wie viele Grad ein Radiant hat.</translation>
    </message>
    <message>
        <source>`branch.angle = atan2(…, …) * …;`</source>
        <translation>`branch.angle = atan2(…, …) * …;`</translation>
    </message>
    <message>
        <source>This angle is in radians. Multiply by `degrees()`.</source>
        <translation>Dieser Winkel ist in Radiant. Multipliziere mit `degrees()`.</translation>
    </message>
    <message>
        <source>x and y are swapped in `atan2`: y comes first.</source>
        <translation>x und y sind in `atan2` vertauscht: y kommt zuerst.</translation>
    </message>
    <message>
        <source>With `+=` the branch turns on in each frame. Set the angle with `=`.</source>
        <translation>Mit `+=` dreht sich der Zweig in jedem Bild weiter. Setze den Winkel mit `=`.</translation>
    </message>
    <message>
        <source>The branch turns to the wrong side: y points down, and so does the angle.</source>
        <translation>Der Zweig dreht sich zur falschen Seite: y zeigt nach unten, und der Winkel auch.</translation>
    </message>
    <message>
        <source>the whole frame</source>
        <translation>das ganze Bild</translation>
    </message>
    <message>
        <source>**From the empty page:** write the whole frame of a tree that turns to the pointer while its button is down. All its branches follow one function that calls itself.</source>
        <translation>**Von der leeren Seite:** Schreibe das ganze Bild eines Baums, der sich zum Zeiger dreht, solange dessen Taste gedrückt ist. Alle Zweige folgen einer Funktion, die sich selbst aufruft.</translation>
    </message>
    <message>
        <source>`void move(Body branch, Vec2 origin)` places a branch and then calls itself for its children. `frame` calls it for the trunk, which begins where it is.</source>
        <translation>`void move(Body branch, Vec2 origin)` setzt einen Zweig und ruft sich dann selbst für dessen Kinder auf. `frame` ruft sie für den Stamm auf, der beginnt, wo er ist.</translation>
    </message>
    <message>
        <source>In `move`: the branch begins at `origin`, or at `hand` if it is held. If `pointer_down`, and it is not held, it turns to the pointer. Its end is the origin of its children.</source>
        <translation>In `move`: Der Zweig beginnt bei `origin`, oder bei `hand`, wenn er gehalten wird. Bei `pointer_down`, und wenn er nicht gehalten wird, dreht er sich zum Zeiger. Sein Ende ist der Ursprung seiner Kinder.</translation>
    </message>
    <message>
        <source>The angle is `atan2(way.y, way.x) * 180 / pi` with `Vec2 way = pointer - branch.position`. The end is `branch.scale * base_length` away, in the direction `Vec2(cos(rad), sin(rad))`.</source>
        <translation>Der Winkel ist `atan2(way.y, way.x) * 180 / pi` mit `Vec2 way = pointer - branch.position`. Das Ende ist `branch.scale * base_length` entfernt, in der Richtung `Vec2(cos(rad), sin(rad))`.</translation>
    </message>
    <message>
        <source>The rest is right, but x and y are swapped in `atan2`: y comes first.</source>
        <translation>Der Rest stimmt, aber x und y sind in `atan2` vertauscht: y kommt zuerst.</translation>
    </message>
    <message>
        <source>The rest is right, but each branch is as long as the trunk. Multiply by its `scale`.</source>
        <translation>Der Rest stimmt, aber jeder Zweig ist so lang wie der Stamm. Multipliziere mit seinem `scale`.</translation>
    </message>
    <message>
        <source>back to rest</source>
        <translation>zurück zur Ruhe</translation>
    </message>
    <message>
        <source>Write how a branch goes **back to rest**: each frame by the missing angle, divided by **ease**. If less than 1° is missing, it stays.</source>
        <translation>Schreibe, wie ein Zweig **zur Ruhe zurückkehrt**: in jedem Bild um den fehlenden Winkel, geteilt durch **Langsamkeit**. Fehlt weniger als 1°, bleibt er stehen.</translation>
    </message>
    <message>
        <source>Go a part of the way back to the angle at rest.</source>
        <translation>Geh einen Teil des Wegs zum Winkel der Ruhe zurück.</translation>
    </message>
    <message>
        <source>The missing angle leads from `branch.angle` to `branch.rest`.</source>
        <translation>Der fehlende Winkel führt von `branch.angle` zu `branch.rest`.</translation>
    </message>
    <message>
        <source>`abs` makes a number positive, so that both sides count.</source>
        <translation>`abs` macht eine Zahl positiv, sodass beide Seiten zählen.</translation>
    </message>
    <message>
        <source>`double way = branch.rest - …;` and `if (abs(way) &gt; 1) branch.angle += way / …;`</source>
        <translation>`double way = branch.rest - …;` und `if (abs(way) &gt; 1) branch.angle += way / …;`</translation>
    </message>
    <message>
        <source>The branch jumps back at once. Divide by `ease`.</source>
        <translation>Der Zweig springt sofort zurück. Teile durch `ease`.</translation>
    </message>
    <message>
        <source>The branch turns away from rest. Swap the two angles.</source>
        <translation>Der Zweig dreht sich von der Ruhe weg. Vertausche die zwei Winkel.</translation>
    </message>
    <message>
        <source>The branch only goes back from one side. `abs(way)` counts both.</source>
        <translation>Der Zweig kehrt nur von einer Seite zurück. `abs(way)` zählt beide.</translation>
    </message>
    <message>
        <source>It also moves when less than 1° is missing, so it never stops. An `if` ends this.</source>
        <translation>Er bewegt sich auch, wenn weniger als 1° fehlt, und hält darum nie an. Ein `if` beendet das.</translation>
    </message>
    <message>
        <source>Write the whole frame. The names: branches[0], the trunk (each branch has position, angle, scale, held, children[i], children.count), base_length, hand, pointer, pointer_down.</source>
        <translation>Schreibe das ganze Bild. Die Namen: branches[0], der Stamm (jeder Zweig hat position, angle, scale, held, children[i], children.count), base_length, hand, pointer, pointer_down.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Swaying tree</source>
        <translation>Schwankender Baum</translation>
    </message>
    <message>
        <source>A tree that grows by one rule, bends in your wind, and at last swings by itself.</source>
        <translation>Ein Baum, der nach einer Regel wächst, sich in deinem Wind biegt und zuletzt von selbst schwingt.</translation>
    </message>
</context>
</TS>
