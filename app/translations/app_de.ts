<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Accuracy</name>
    <message>
        <source>%1: the picture cannot be written: %2. Choose another folder or name.</source>
        <translation>%1: Die Bilddatei lässt sich nicht schreiben: %2. Wähle einen anderen Ordner oder Namen.</translation>
    </message>
    <message>
        <source>Stopped before everything was measured.</source>
        <translation>Angehalten, bevor alles gemessen war.</translation>
    </message>
    <message>
        <source>%1 frames; reference %2, known to %3 px</source>
        <translation>%1 Bilder; Referenz %2, bekannt auf %3 px</translation>
    </message>
    <message>
        <source>time, ns a frame</source>
        <translation>Zeit, ns pro Bild</translation>
    </message>
    <message>
        <source>error, px</source>
        <translation>Fehler, px</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>verwendet</translation>
    </message>
    <message>
        <source>step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>forces/frame</source>
        <translation>Kräfte/Bild</translation>
    </message>
    <message>
        <source>ns/frame</source>
        <translation>ns/Bild</translation>
    </message>
    <message>
        <source>+-</source>
        <translation>+-</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instabil</translation>
    </message>
    <message>
        <source>takes too long</source>
        <translation>dauert zu lange</translation>
    </message>
    <message>
        <source>There is no continuous motion behind this scene: what %1 does depends on the step. So each method is compared with itself at a finer step (%2), which is up to %3 px from the next coarser one.</source>
        <translation>Hinter dieser Szene steht keine stetige Bewegung: Was %1 bewirkt, hängt vom Zeitschritt ab. Darum wird jedes Verfahren mit sich selbst bei feinerem Zeitschritt verglichen (%2); der liegt bis zu %3 px neben dem nächstgröberen.</translation>
    </message>
    <message>
        <source>Errors are distances from %1 (%2). Its check, %3 (%4), is up to %5 px from it.</source>
        <translation>Fehler sind Abstände von %1 (%2). Die Gegenprobe %3 (%4) weicht davon bis zu %5 px ab.</translation>
    </message>
    <message>
        <source>Errors are given up to frame %1 of %2</source>
        <translation>Fehler gibt es bis Bild %1 von %2</translation>
    </message>
    <message>
        <source>: after it they are too far apart to be believed.</source>
        <translation>: Danach liegen sie zu weit auseinander, um glaubhaft zu sein.</translation>
    </message>
    <message>
        <source>: after it the reference stops being finite.</source>
        <translation>: Danach bleibt die Referenz nicht mehr endlich.</translation>
    </message>
    <message>
        <source>: computing a reference further takes too long.</source>
        <translation>: Eine Referenz darüber hinaus zu berechnen, dauert zu lange.</translation>
    </message>
    <message>
        <source>Nothing that was measured is within %1 px.</source>
        <translation>Nichts Gemessenes bleibt innerhalb von %1 px.</translation>
    </message>
    <message>
        <source>To be within %1 px this scene costs %2 µs a frame: %3, which is %4 px off.</source>
        <translation>Innerhalb von %1 px zu bleiben, kostet in dieser Szene %2 µs pro Bild: %3 mit einer Abweichung von %4 px.</translation>
    </message>
    <message>
        <source>The method in use, %1, has no error to show: see the table.</source>
        <translation>Das verwendete Verfahren %1 hat keinen Fehler vorzuweisen: siehe Tabelle.</translation>
    </message>
    <message>
        <source>The method in use, %1, costs %2 µs a frame and is %3 px off.</source>
        <translation>Das verwendete Verfahren %1 kostet %2 µs pro Bild und weicht um %3 px ab.</translation>
    </message>
    <message>
        <source>tolerance %1</source>
        <translation>Toleranz %1</translation>
    </message>
    <message>
        <source>h %1</source>
        <translation>h %1</translation>
    </message>
    <message>
        <source>method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>* on the front: nothing measured is at least as exact and cheaper.</source>
        <translation>* auf der Bestlinie: Nichts Gemessenes ist mindestens so genau und billiger.</translation>
    </message>
    <message>
        <source>This machine is busy with other things: times vary by %1 %.</source>
        <translation>Dieser Rechner hat anderes zu tun: Die Zeiten schwanken um %1 %.</translation>
    </message>
    <message>
        <source>Nothing moves here unless you do something: save a run in which you do, and measure that file.</source>
        <translation>Hier bewegt sich nichts, solange du nichts tust: Speichere einen Lauf, in dem du etwas tust, und miss diese Datei.</translation>
    </message>
</context>
<context>
    <name>AccuracyWords</name>
    <message>
        <source>Yours costs %1 and is %2 off.</source>
        <translation>Deines kostet %1 und weicht um %2 ab.</translation>
    </message>
    <message>
        <source>Yours is %1 off.</source>
        <translation>Deines weicht um %1 ab.</translation>
    </message>
    <message>
        <source>Yours is unstable here: its numbers grow without bound.</source>
        <translation>Deines ist hier instabil: Seine Zahlen wachsen ohne Grenze.</translation>
    </message>
    <message>
        <source>Yours cannot compute this scene.</source>
        <translation>Deines kann diese Szene nicht berechnen.</translation>
    </message>
    <message>
        <source>Yours would take too long to measure.</source>
        <translation>Deines zu messen, würde zu lange dauern.</translation>
    </message>
    <message>
        <source>Errors first, then times: what it costs to be within %1 will stand here.</source>
        <translation>Erst die Fehler, dann die Zeiten: Was es kostet, innerhalb von %1 zu bleiben, wird hier stehen.</translation>
    </message>
    <message>
        <source>Nothing here comes within %1.</source>
        <translation>Nichts kommt hier auf %1 heran.</translation>
    </message>
    <message>
        <source>Nothing here comes within %1. The closest is %2: %3 off.</source>
        <translation>Nichts kommt hier auf %1 heran. Am nächsten kommt %2: %3 Abweichung.</translation>
    </message>
    <message>
        <source>Errors count up to frame %1 of %2.</source>
        <translation>Fehler zählen bis Bild %1 von %2.</translation>
    </message>
    <message>
        <source>After it, even the two finest steps part: here the smallest difference grows.</source>
        <translation>Danach trennen sich sogar die zwei feinsten Zeitschritte: Hier wächst der kleinste Unterschied.</translation>
    </message>
    <message>
        <source>After it, two very exact solutions part: here the smallest difference grows until nobody can say where the bodies really are.</source>
        <translation>Danach trennen sich zwei sehr genaue Lösungen: Hier wächst der kleinste Unterschied, bis niemand mehr sagen kann, wo die Körper wirklich sind.</translation>
    </message>
    <message>
        <source>After it, the exact motion itself grows without bound.</source>
        <translation>Danach wächst die exakte Bewegung selbst ohne Grenze.</translation>
    </message>
    <message>
        <source>To know the exact motion any longer would take too long.</source>
        <translation>Die exakte Bewegung noch länger zu kennen, würde zu lange dauern.</translation>
    </message>
    <message>
        <source>one of its effects</source>
        <translation>einer ihrer Effekte</translation>
    </message>
    <message>
        <source>This scene has no exact motion to compare with: %1 acts once a step, however short the step is. So each method is compared with its own finest steps.</source>
        <translation>Diese Szene hat keine exakte Bewegung zum Vergleich: „%1“ wirkt einmal pro Zeitschritt, wie kurz er auch ist. Darum wird jedes Verfahren mit seinen eigenen feinsten Zeitschritten verglichen.</translation>
    </message>
    <message>
        <source>Not able to compute this scene: %1.</source>
        <translation>Kann diese Szene nicht berechnen: %1.</translation>
    </message>
    <message>
        <source>%1&#x2009;px</source>
        <translation>%1&#x2009;px</translation>
    </message>
    <message>
        <source>%1&#x2009;µs</source>
        <translation>%1&#x2009;µs</translation>
    </message>
    <message>
        <source>%1, tolerance %2</source>
        <translation>%1, Toleranz %2</translation>
    </message>
    <message>
        <source>%1, step %2</source>
        <translation>%1, Zeitschritt %2</translation>
    </message>
    <message>
        <source>Not off at all, to the last digit</source>
        <translation>Bis zur letzten Stelle ohne Abweichung</translation>
    </message>
    <message>
        <source>At most %1 off</source>
        <translation>Weicht höchstens um %1 ab</translation>
    </message>
    <message>
        <source>Unstable: its numbers grow without bound</source>
        <translation>Instabil: Seine Zahlen wachsen ohne Grenze</translation>
    </message>
    <message>
        <source>Cannot compute this scene</source>
        <translation>Kann diese Szene nicht berechnen</translation>
    </message>
    <message>
        <source>Left out: it would take too long</source>
        <translation>Ausgelassen: Es würde zu lange dauern</translation>
    </message>
    <message>
        <source>Not tried yet</source>
        <translation>Noch nicht versucht</translation>
    </message>
    <message>
        <source>%1 ± %2 a frame</source>
        <translation>%1 ± %2 pro Bild</translation>
    </message>
    <message>
        <source>Computes all forces %1 times a frame</source>
        <translation>Berechnet alle Kräfte %1-mal pro Bild</translation>
    </message>
    <message>
        <source>On the front: nothing is as exact for less</source>
        <translation>Auf der Bestlinie: Nichts ist für weniger so genau</translation>
    </message>
    <message>
        <source>Nothing moves here unless you do something, so nothing can be off: drag a body or change a number, then measure again.</source>
        <translation>Hier bewegt sich nichts, solange du nichts tust, also kann auch nichts abweichen: Zieh an einem Körper oder ändere eine Zahl und miss dann noch einmal.</translation>
    </message>
    <message>
        <source>A first look, at frames 0 to %1: further, the exact motion is still being computed.</source>
        <translation>Ein erster Blick auf die Bilder 0 bis %1: Weiter hinten wird die exakte Bewegung noch berechnet.</translation>
    </message>
    <message>
        <source>To be within %1, nothing is cheaper than what you use: %2, at %3 a frame and %4 off.</source>
        <translation>Innerhalb von %1 ist nichts billiger als das, was du verwendest: %2 für %3 pro Bild bei %4 Abweichung.</translation>
    </message>
    <message>
        <source>To be within %1, this scene costs %2 a frame: %3.</source>
        <translation>Innerhalb von %1 zu bleiben, kostet in dieser Szene %2 pro Bild: %3.</translation>
    </message>
    <message>
        <source>The machine is busy with other things: the times differ by %1&#x2009;% from run to run. Errors are not touched by that.</source>
        <translation>Der Rechner hat anderes zu tun: Die Zeiten unterscheiden sich von Lauf zu Lauf um %1&#x2009;%. Die Fehler berührt das nicht.</translation>
    </message>
    <message>
        <source>Unstable: %1</source>
        <translation>Instabil: %1</translation>
    </message>
    <message>
        <source>unstable at big steps: %1</source>
        <translation>instabil bei großen Zeitschritten: %1</translation>
    </message>
</context>
<context>
    <name>Attempt</name>
    <message>
        <source>There is not enough memory for it.</source>
        <translation>Dafür reicht der Speicher nicht.</translation>
    </message>
</context>
<context>
    <name>BlueprintReader</name>
    <message>
        <source>%1 is %2; it can be %3 to %4.</source>
        <translation>%1 ist %2; möglich ist %3 bis %4.</translation>
    </message>
    <message>
        <source>%1 has %2 entries; the most is %3.</source>
        <translation>%1 hat %2 Einträge; höchstens sind es %3.</translation>
    </message>
    <message>
        <source>an object in { }</source>
        <translation>ein Objekt in { }</translation>
    </message>
    <message>
        <source>&quot;bodies&quot; is empty; a scene needs at least one body.</source>
        <translation>&quot;bodies&quot; ist leer; eine Szene braucht mindestens einen Körper.</translation>
    </message>
    <message>
        <source>a body cannot be called %1; a name is a letter, then up to %2 letters, digits, dots and _.</source>
        <translation>ein Körper kann nicht %1 heißen; ein Name ist ein Buchstabe, dann bis zu %2 Buchstaben, Ziffern, Punkte und _.</translation>
    </message>
    <message>
        <source>a body&apos;s name</source>
        <translation>der Name eines Körpers</translation>
    </message>
    <message>
        <source>there is no body %1 in this scene; %2 takes the name of one of its &quot;bodies&quot;.</source>
        <translation>in dieser Szene gibt es keinen Körper %1; %2 verlangt den Namen von einem aus &quot;bodies&quot;.</translation>
    </message>
    <message>
        <source>%1 has %2 at both ends; give it two bodies.</source>
        <translation>%1 hat %2 an beiden Enden; nenne zwei Körper.</translation>
    </message>
    <message>
        <source>a spring</source>
        <translation>eine Feder</translation>
    </message>
    <message>
        <source>a stick</source>
        <translation>ein Stab</translation>
    </message>
    <message>
        <source>a gait group</source>
        <translation>eine Ganggruppe</translation>
    </message>
    <message>
        <source>a foot</source>
        <translation>ein Fuß</translation>
    </message>
    <message>
        <source>a foot belongs to a gait group, and there is none; add &quot;gaits&quot;: [{}].</source>
        <translation>ein Fuß gehört zu einer Ganggruppe, und es gibt keine; füge &quot;gaits&quot;: [{}] hinzu.</translation>
    </message>
    <message>
        <source>%1 is a foot twice; it can be the foot of one body.</source>
        <translation>%1 ist zweimal ein Fuß; möglich ist nur der Fuß eines einzigen Körpers.</translation>
    </message>
    <message>
        <source>a scene cannot have the effect %1; it can have %2, and its springs, sticks and feet act of themselves.</source>
        <translation>eine Szene kann den Effekt %1 nicht haben; möglich ist %2, und ihre Federn, Stäbe und Füße wirken von selbst.</translation>
    </message>
    <message>
        <source>the effect %1 is given twice; keep one.</source>
        <translation>der Effekt %1 ist zweimal angegeben; behalte einen.</translation>
    </message>
</context>
<context>
    <name>BodyText</name>
    <message>
        <source>%1 at (%2, %3)</source>
        <translation>%1 bei (%2, %3)</translation>
    </message>
    <message>
        <source>%1, at rest</source>
        <translation>%1, in Ruhe</translation>
    </message>
    <message>
        <source>%1, moving %2 px a frame</source>
        <translation>%1, bewegt sich um %2 px pro Bild</translation>
    </message>
</context>
<context>
    <name>Branches</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 at frame %2</source>
        <translation>%1 bei Bild %2</translation>
    </message>
</context>
<context>
    <name>BreakWatch</name>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>Stopped at frame %1 before %2: %3.</source>
        <translation>Angehalten bei Bild %1 vor „%2“: %3.</translation>
    </message>
</context>
<context>
    <name>BuiltProperties</name>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>How far to the right it starts.</source>
        <translation>Wie weit rechts er beginnt.</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>How far down it starts.</source>
        <translation>Wie weit unten er beginnt.</translation>
    </message>
    <message>
        <source>Speed x</source>
        <translation>Tempo x</translation>
    </message>
    <message>
        <source>px/frame</source>
        <translation>px/Bild</translation>
    </message>
    <message>
        <source>How fast it starts to the right.</source>
        <translation>Wie schnell er nach rechts startet.</translation>
    </message>
    <message>
        <source>Speed y</source>
        <translation>Tempo y</translation>
    </message>
    <message>
        <source>How fast it starts downwards.</source>
        <translation>Wie schnell er nach unten startet.</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>How much it takes to move it; a usual body has 1.</source>
        <translation>Wie viel es braucht, ihn zu bewegen; ein üblicher Körper hat 1.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Its width: walls stop its edge, and wind takes hold of it.</source>
        <translation>Seine Breite: Wände halten seinen Rand auf, und der Wind greift an ihr an.</translation>
    </message>
    <message>
        <source>Nailed</source>
        <translation>Genagelt</translation>
    </message>
    <message>
        <source>Whether it stays where it is.</source>
        <translation>Ob er bleibt, wo er ist.</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>1/frame²</source>
        <translation>1/Bild²</translation>
    </message>
    <message>
        <source>How hard it pulls a usual body: this share of the missing distance, each frame.</source>
        <translation>Wie stark an einem üblichen Körper gezogen wird: um diesen Anteil des fehlenden Abstands, in jedem Bild.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>How far apart it wants its two ends.</source>
        <translation>Wie weit auseinander die zwei Enden sein sollen.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>The part of a wrong length that its first end makes good; the other end does the rest.</source>
        <translation>Der Teil einer falschen Länge, den das erste Ende ausgleicht; das andere Ende macht den Rest.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Where the foot belongs, seen from its body: 0 is left of it, 90 above it.</source>
        <translation>Wohin der Fuß gehört, von seinem Körper aus gesehen: 0 ist links davon, 90 darüber.</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Bein</translation>
    </message>
    <message>
        <source>How long the legs of this gait group are.</source>
        <translation>Wie lang die Beine dieser Ganggruppe sind.</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Absenkung</translation>
    </message>
    <message>
        <source>How far below the body the legs of this gait group end.</source>
        <translation>Wie weit unter dem Körper die Beine dieser Ganggruppe enden.</translation>
    </message>
    <message>
        <source>Swing</source>
        <translation>Schwung</translation>
    </message>
    <message>
        <source>rad/frame</source>
        <translation>rad/Bild</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Beginn</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>rad</translation>
    </message>
    <message>
        <source>Where that clock begins: groups that begin apart step in turn.</source>
        <translation>Wo diese Uhr beginnt: Gruppen, die versetzt beginnen, treten im Wechsel.</translation>
    </message>
    <message>
        <source>Carries</source>
        <translation>Trägt</translation>
    </message>
    <message>
        <source>Whether the body feels its feet: without that they do not carry it.</source>
        <translation>Ob der Körper seine Füße spürt: Sonst tragen sie ihn nicht.</translation>
    </message>
    <message>
        <source>Point %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>Spring</source>
        <translation>Feder</translation>
    </message>
    <message>
        <source>%1 springs</source>
        <translation>%1 Federn</translation>
    </message>
    <message>
        <source>Stick</source>
        <translation>Stab</translation>
    </message>
    <message>
        <source>%1 sticks</source>
        <translation>%1 Stäbe</translation>
    </message>
    <message>
        <source>Foot of %1</source>
        <translation>Fuß von %1</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>The gait group: its feet swing to one clock.</source>
        <translation>Die Ganggruppe: Ihre Füße schwingen nach einer Uhr.</translation>
    </message>
    <message>
        <source>Gait group %1</source>
        <translation>Ganggruppe %1</translation>
    </message>
    <message>
        <source>How fast the clock of this gait group turns its legs. 0: they stand still. To walk, feet need ground.</source>
        <translation>Wie schnell die Uhr dieser Ganggruppe ihre Beine dreht. 0: Sie stehen still. Zum Gehen brauchen Füße Boden.</translation>
    </message>
</context>
<context>
    <name>CodeListing</name>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>%1: the order</source>
        <translation>%1: die Reihenfolge</translation>
    </message>
</context>
<context>
    <name>CodeMarks</name>
    <message>
        <source>done</source>
        <translation>erledigt</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>next</source>
        <translation>als Nächstes</translation>
    </message>
    <message>
        <source>1 pull</source>
        <translation>1 Zug</translation>
    </message>
    <message>
        <source>%1 pulls</source>
        <translation>%1 Züge</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 Punkt</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
</context>
<context>
    <name>CodeRows</name>
    <message>
        <source>%1: how the method adds it</source>
        <translation>%1: wie das Verfahren es addiert</translation>
    </message>
</context>
<context>
    <name>CodeSteering</name>
    <message>
        <source>%1 can be %2, and not %3.</source>
        <translation>%1 kann %2 sein, aber nicht %3.</translation>
    </message>
    <message>
        <source>%1 can be a whole number from %2 to %3, and not %4.</source>
        <translation>%1 kann eine ganze Zahl von %2 bis %3 sein, aber nicht %4.</translation>
    </message>
    <message>
        <source>%1 can be a number from %2 to %3, and not %4.</source>
        <translation>%1 kann eine Zahl von %2 bis %3 sein, aber nicht %4.</translation>
    </message>
</context>
<context>
    <name>CodeSymbols</name>
    <message>
        <source>Where the body is, seen from the place it hangs on.</source>
        <translation>Wo der Körper ist, gesehen vom Ort, an dem er hängt.</translation>
    </message>
    <message>
        <source>The direction away from the place it hangs on, 1 long.</source>
        <translation>Die Richtung weg vom Ort, an dem er hängt, mit Länge 1.</translation>
    </message>
    <message>
        <source>The same direction, as an angle.</source>
        <translation>Dieselbe Richtung, als Winkel.</translation>
    </message>
    <message>
        <source>How far the body is from the place it hangs on.</source>
        <translation>Wie weit der Körper von dem Ort entfernt ist, an dem er hängt.</translation>
    </message>
    <message>
        <source>How much farther out the spring wants the body, as a share of its distance.</source>
        <translation>Wie viel weiter außen die Feder den Körper haben will, als Anteil seiner Entfernung.</translation>
    </message>
    <message>
        <source>Where the spring pulls the body to.</source>
        <translation>Wohin die Feder den Körper zieht.</translation>
    </message>
    <message>
        <source>The way from the body to where the spring pulls it.</source>
        <translation>Der Weg vom Körper dorthin, wohin die Feder ihn zieht.</translation>
    </message>
    <message>
        <source>What all springs together add to the velocity each frame.</source>
        <translation>Was alle Federn zusammen in jedem Bild zur Geschwindigkeit addieren.</translation>
    </message>
    <message>
        <source>What gravity adds to the velocity each frame.</source>
        <translation>Was die Schwerkraft in jedem Bild zur Geschwindigkeit addiert.</translation>
    </message>
    <message>
        <source>The way from the body to its target.</source>
        <translation>Der Weg vom Körper zu seinem Ziel.</translation>
    </message>
    <message>
        <source>The share of the velocity that is left after this step.</source>
        <translation>Der Anteil der Geschwindigkeit, der nach diesem Zeitschritt übrig ist.</translation>
    </message>
    <message>
        <source>What is added to the velocity each frame.</source>
        <translation>Was in jedem Bild zur Geschwindigkeit addiert wird.</translation>
    </message>
    <message>
        <source>Where the body is: x to the right, y down.</source>
        <translation>Wo der Körper ist: x nach rechts, y nach unten.</translation>
    </message>
    <message>
        <source>The velocity: how far the body goes in a frame.</source>
        <translation>Die Geschwindigkeit: wie weit der Körper in einem Bild kommt.</translation>
    </message>
    <message>
        <source>How far the two are from each other.</source>
        <translation>Wie weit die beiden voneinander entfernt sind.</translation>
    </message>
    <message>
        <source>How fast it turns.</source>
        <translation>Wie schnell er sich dreht.</translation>
    </message>
    <message>
        <source>The direction in which it points.</source>
        <translation>Die Richtung, in die er zeigt.</translation>
    </message>
</context>
<context>
    <name>CodeValues</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>too large</source>
        <translation>zu groß</translation>
    </message>
    <message>
        <source>%1: from %2 to %3%4</source>
        <translation>%1: von %2 auf %3%4</translation>
    </message>
    <message>
        <source>%1: %2%3, unchanged</source>
        <translation>%1: %2%3, unverändert</translation>
    </message>
    <message>
        <source>%1: %2%3</source>
        <translation>%1: %2%3</translation>
    </message>
    <message>
        <source>The sum of %1 pulls</source>
        <translation>Die Summe von %1 Zügen</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>The same as JSON.</source>
        <translation>Dasselbe als JSON.</translation>
    </message>
    <message>
        <source>Lists lessons, steps, parameters and methods.</source>
        <translation>Listet Lektionen, Schritte, Parameter und Verfahren auf.</translation>
    </message>
    <message>
        <source>Computes an experiment and writes every frame as CSV: frame,body,x,y,vx,vy.</source>
        <translation>Berechnet ein Experiment und schreibt jedes Bild als CSV: frame,body,x,y,vx,vy.</translation>
    </message>
    <message>
        <source>The experiment.</source>
        <translation>Das Experiment.</translation>
    </message>
    <message>
        <source>--%1 is %2; it can be %3 to %4.</source>
        <translation>--%1 ist %2; möglich ist %3 bis %4.</translation>
    </message>
    <message>
        <source>Measures what error each method makes on a scene, and what it costs.</source>
        <translation>Misst, welchen Fehler jedes Verfahren in einer Szene macht und was es kostet.</translation>
    </message>
    <message>
        <source>The experiment, or the step.</source>
        <translation>Das Experiment oder der Schritt.</translation>
    </message>
    <message>
        <source>Draws error against time.</source>
        <translation>Zeichnet den Fehler über der Zeit.</translation>
    </message>
    <message>
        <source>Names the cheapest way within E px.</source>
        <translation>Nennt den billigsten Weg innerhalb von E px.</translation>
    </message>
    <message>
        <source>Frames to compute (default 200, or the file&apos;s).</source>
        <translation>Zu berechnende Bilder (Vorgabe 200 oder die der Datei).</translation>
    </message>
    <message>
        <source>Runs every hard case under every method, and tells what holds; exit code 1 if a method fails a case that it claims.</source>
        <translation>Rechnet jeden schwierigen Fall mit jedem Verfahren und meldet, was hält; Exit-Code 1, wenn ein Verfahren an einem Fall scheitert, den es zusagt.</translation>
    </message>
    <message>
        <source>Runs this case only.</source>
        <translation>Rechnet nur diesen Fall.</translation>
    </message>
    <message>
        <source>Runs of full size: some take hours.</source>
        <translation>Läufe in voller Größe: Manche dauern Stunden.</translation>
    </message>
    <message>
        <source>Measures what each effect of a scene costs in a frame, and what else the frame takes.</source>
        <translation>Misst, was jeder Effekt einer Szene pro Bild kostet und was das Bild sonst noch braucht.</translation>
    </message>
    <message>
        <source>Measures the frames after frame N (default 0).</source>
        <translation>Misst die Bilder nach Bild N (Vorgabe 0).</translation>
    </message>
    <message>
        <source>An experiment to open.</source>
        <translation>Ein Experiment, das geöffnet wird.</translation>
    </message>
    <message>
        <source>Prints the version.</source>
        <translation>Gibt die Version aus.</translation>
    </message>
    <message>
        <source>there is no verb and no file %1; the verbs are %2.</source>
        <translation>es gibt kein Verb und keine Datei %1; die Verben sind %2.</translation>
    </message>
    <message>
        <source>there is no verb %1; the verbs are %2.</source>
        <translation>es gibt kein Verb %1; die Verben sind %2.</translation>
    </message>
    <message>
        <source>Prints this help.</source>
        <translation>Gibt diese Hilfe aus.</translation>
    </message>
    <message>
        <source>%1; %2 --help tells what there is.</source>
        <translation>%1; %2 --help sagt, was es gibt.</translation>
    </message>
    <message>
        <source>no name</source>
        <translation>kein Name</translation>
    </message>
    <message>
        <source>%1 takes %2; %3 --help tells more.</source>
        <translation>%1 braucht %2; %3 --help sagt mehr.</translation>
    </message>
    <message>
        <source>%1 is neither a file nor a step; name a step as LESSON/STEP, as &quot;springstep lessons&quot; lists them.</source>
        <translation>%1 ist weder eine Datei noch ein Schritt; nenne einen Schritt als LESSON/STEP, wie &quot;springstep lessons&quot; sie auflistet.</translation>
    </message>
    <message>
        <source>there is no display for the window; set DISPLAY, or use a verb that needs none: %1.</source>
        <translation>es gibt keinen Bildschirm für das Fenster; setze DISPLAY oder verwende ein Verb, das keinen braucht: %1.</translation>
    </message>
    <message>
        <source>--size is %1; it can be WIDTHxHEIGHT in pixels, each from 100 to 9999, such as 1280x800.</source>
        <translation>--size ist %1; möglich ist BREITExHÖHE in Pixeln, beides von 100 bis 9999, zum Beispiel 1280x800.</translation>
    </message>
    <message>
        <source>--mode is %1; it can be &quot;learn&quot; or &quot;measure&quot;.</source>
        <translation>--mode ist %1; möglich ist &quot;learn&quot; oder &quot;measure&quot;.</translation>
    </message>
    <message>
        <source>--stability is %1; it can be &quot;gauge&quot;, &quot;reasons&quot;, or a map: &quot;step&quot; or &quot;damping&quot;.</source>
        <translation>--stability ist %1; möglich ist &quot;gauge&quot;, &quot;reasons&quot; oder eine Karte: &quot;step&quot; oder &quot;damping&quot;.</translation>
    </message>
    <message>
        <source>%1 is not a step; name it as LESSON/STEP, as &quot;springstep lessons&quot; lists them.</source>
        <translation>%1 ist kein Schritt; nenne ihn als LESSON/STEP, wie &quot;springstep lessons&quot; sie auflistet.</translation>
    </message>
    <message>
        <source>Draws the window as a learner sees it.</source>
        <translation>Zeichnet das Fenster so, wie Lernende es sehen.</translation>
    </message>
    <message>
        <source>The step to open.</source>
        <translation>Der Schritt, der geöffnet wird.</translation>
    </message>
    <message>
        <source>The picture to write.</source>
        <translation>Die Bilddatei, die geschrieben wird.</translation>
    </message>
    <message>
        <source>Go to frame N (default 0).</source>
        <translation>Geht zu Bild N (Vorgabe 0).</translation>
    </message>
    <message>
        <source>Stop after P phases inside the next frame (default 0).</source>
        <translation>Hält nach P Phasen im nächsten Bild an (Vorgabe 0).</translation>
    </message>
    <message>
        <source>Width and height in pixels (default 1280x800).</source>
        <translation>Breite und Höhe in Pixeln (Vorgabe 1280x800).</translation>
    </message>
    <message>
        <source>learn or measure (default learn).</source>
        <translation>learn oder measure (Vorgabe learn).</translation>
    </message>
    <message>
        <source>Show where energy went, below the picture.</source>
        <translation>Zeigt unter der Szene, wohin die Energie ging.</translation>
    </message>
    <message>
        <source>Show what each effect costs.</source>
        <translation>Zeigt, was jeder Effekt kostet.</translation>
    </message>
    <message>
        <source>gauge, reasons, or a map: step or damping (default gauge).</source>
        <translation>gauge, reasons oder eine Karte: step oder damping (Vorgabe gauge).</translation>
    </message>
    <message>
        <source>--fps is %1; it can be %2 to %3.</source>
        <translation>--fps ist %1; möglich ist %2 bis %3.</translation>
    </message>
    <message>
        <source>Width and height in pixels (default 640x480).</source>
        <translation>Breite und Höhe in Pixeln (Vorgabe 640x480).</translation>
    </message>
    <message>
        <source>light, dark or contrast (default light).</source>
        <translation>light, dark oder contrast (Vorgabe light).</translation>
    </message>
    <message>
        <source>The first frame (default 0).</source>
        <translation>Das erste Bild (Vorgabe 0).</translation>
    </message>
    <message>
        <source>The last frame (default: the file&apos;s frames).</source>
        <translation>Das letzte Bild (Vorgabe: die Bilder der Datei).</translation>
    </message>
    <message>
        <source>--theme is %1; it can be &quot;light&quot;, &quot;dark&quot; or &quot;contrast&quot;.</source>
        <translation>--theme ist %1; möglich ist &quot;light&quot;, &quot;dark&quot; oder &quot;contrast&quot;.</translation>
    </message>
    <message>
        <source>Show the plots.</source>
        <translation>Zeigt die Diagramme.</translation>
    </message>
    <message>
        <source>Physically based animation, step by step.

Without a verb the window opens, with an experiment if FILE names one.

Verbs; each has its own --help, and none needs a display:
  lessons [--json]                            lists lessons, steps, parameters, methods
  trace FILE                                  writes the run of an experiment as CSV
  accuracy FILE|LESSON/STEP [--json] [--svg OUT] [--tolerance E]
                                              measures errors and costs of the methods
  hardcases [--case ID] [--json]              tells which methods hold where runs break
  cost FILE|LESSON/STEP [--json] [--frame N]  measures what each effect costs in a frame
  screenshot LESSON/STEP --frame N OUT.png    draws the window
  film FILE OUT.webm|OUT.gif|OUT_%04d.png     makes a film of an experiment&apos;s run</source>
        <translation>Physikalisch basierte Animation, Schritt für Schritt.

Ohne Verb öffnet sich das Fenster, mit einem Experiment, wenn FILE eines nennt.

Verben; jedes hat sein eigenes --help, und keines braucht einen Bildschirm:
  lessons [--json]                            listet Lektionen, Schritte, Parameter und Verfahren auf
  trace FILE                                  schreibt den Lauf eines Experiments als CSV
  accuracy FILE|LESSON/STEP [--json] [--svg OUT] [--tolerance E]
                                              misst Fehler und Kosten der Verfahren
  hardcases [--case ID] [--json]              sagt, welche Verfahren halten, wo Läufe brechen
  cost FILE|LESSON/STEP [--json] [--frame N]  misst, was jeder Effekt pro Bild kostet
  screenshot LESSON/STEP --frame N OUT.png    zeichnet das Fenster
  film FILE OUT.webm|OUT.gif|OUT_%04d.png     macht einen Film vom Lauf eines Experiments</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Liest %1</translation>
    </message>
    <message>
        <source>--fps is for a film in one file; PNG files have no time in them. Leave it out.</source>
        <translation>--fps ist für einen Film in einer Datei; PNG-Dateien enthalten keine Zeit. Lass es weg.</translation>
    </message>
    <message>
        <source>Makes a film of an experiment&apos;s run: a video (WebM), an animated GIF, or a PNG for each frame.</source>
        <translation>Macht einen Film vom Lauf eines Experiments: ein Video (WebM), ein animiertes GIF oder ein PNG für jedes Bild.</translation>
    </message>
    <message>
        <source>The film: OUT.webm, OUT.gif, or OUT_%04d.png with the frame&apos;s number for %04d.</source>
        <translation>Der Film: OUT.webm, OUT.gif oder OUT_%04d.png mit der Nummer des Bildes für %04d.</translation>
    </message>
    <message>
        <source>Frames a second, up to 50 in a GIF and 120 in a video (default 30).</source>
        <translation>Bilder pro Sekunde, bis 50 in einem GIF und 120 in einem Video (Vorgabe 30).</translation>
    </message>
</context>
<context>
    <name>Condition</name>
    <message>
        <source>Character %1: %2</source>
        <translation>Zeichen %1: %2</translation>
    </message>
    <message>
        <source>this is too long; leave it at %1 characters.</source>
        <translation>das ist zu lang; belass es bei %1 Zeichen.</translation>
    </message>
    <message>
        <source>a number says neither yes nor no; compare it, as in %1.</source>
        <translation>eine Zahl sagt weder ja noch nein; vergleiche sie, wie in %1.</translation>
    </message>
    <message>
        <source>this is true or false, and no number; join questions with and, or.</source>
        <translation>das ist wahr oder falsch und keine Zahl; verbinde Fragen mit and, or.</translation>
    </message>
    <message>
        <source>a phase can only be compared with its name, as in phase == &quot;%1&quot;.</source>
        <translation>eine Phase lässt sich nur mit ihrem Namen vergleichen, wie in phase == &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>%1 is a choice; compare it with one of its values, as in %1 == &quot;%2&quot;.</source>
        <translation>%1 ist eine Auswahl; vergleiche sie mit einem ihrer Werte, wie in %1 == &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>%1 is a text; only phase and choices are compared with one.</source>
        <translation>%1 ist ein Text; mit einem Text vergleicht man nur phase und Auswahlen.</translation>
    </message>
    <message>
        <source>a number does not fit here.</source>
        <translation>eine Zahl passt hier nicht.</translation>
    </message>
    <message>
        <source>nothing is asked yet; write a comparison, as in %1.y &gt; 380.</source>
        <translation>noch ist nichts gefragt; schreibe einen Vergleich, wie in %1.y &gt; 380.</translation>
    </message>
    <message>
        <source>no parenthesis is open here; take this one away.</source>
        <translation>hier ist keine Klammer offen; nimm diese weg.</translation>
    </message>
    <message>
        <source>%1 does not follow from what is before it; put and, or, or a sign such as + or &lt; between.</source>
        <translation>%1 schließt nicht an das an, was davor steht; setze and, or oder ein Zeichen wie + oder &lt; dazwischen.</translation>
    </message>
    <message>
        <source>one question compares two things; join two of them with and.</source>
        <translation>eine Frage vergleicht zwei Dinge; verbinde zwei Fragen mit and.</translation>
    </message>
    <message>
        <source>names are equal or not; write == or !=.</source>
        <translation>Namen sind gleich oder nicht; schreibe == oder !=.</translation>
    </message>
    <message>
        <source>this parenthesis does not end; close it with ).</source>
        <translation>diese Klammer endet nicht; schließe sie mit ).</translation>
    </message>
    <message>
        <source>%1 does not fit here; a sign or ) is missing before it.</source>
        <translation>%1 passt hier nicht; davor fehlt ein Zeichen oder ).</translation>
    </message>
    <message>
        <source>something is missing at the end; add a number or a name.</source>
        <translation>am Ende fehlt etwas; füge eine Zahl oder einen Namen hinzu.</translation>
    </message>
    <message>
        <source>a number or a name is missing before %1; add it.</source>
        <translation>vor %1 fehlt eine Zahl oder ein Name; füge das hinzu.</translation>
    </message>
    <message>
        <source>what %1 is taken of goes into parentheses, as in %1(%2.vy).</source>
        <translation>wovon %1 genommen wird, steht in Klammern, wie in %1(%2.vy).</translation>
    </message>
    <message>
        <source>there is no phase %1; there are %2.</source>
        <translation>es gibt keine Phase %1; es gibt %2.</translation>
    </message>
    <message>
        <source>%1 is never %2; it can be %3.</source>
        <translation>%1 ist nie %2; möglich ist %3.</translation>
    </message>
    <message>
        <source>there is no body %1 here; there are %2.</source>
        <translation>hier gibt es keinen Körper %1; es gibt %2.</translation>
    </message>
    <message>
        <source>%1 has no %2; it has %3.</source>
        <translation>%1 hat kein %2; es gibt %3.</translation>
    </message>
    <message>
        <source>%1 is a body; ask for one of its numbers, as in %1.y (%2).</source>
        <translation>%1 ist ein Körper; frag nach einer seiner Zahlen, wie in %1.y (%2).</translation>
    </message>
    <message>
        <source>there is no %1 here; there are %2, and numbers of bodies, as in %3.y.</source>
        <translation>hier gibt es kein %1; es gibt %2 und Zahlen von Körpern, wie in %3.y.</translation>
    </message>
    <message>
        <source>%1 is no number; write one like 380, 0.5 or 1e-3.</source>
        <translation>%1 ist keine Zahl; schreibe eine wie 380, 0.5 oder 1e-3.</translation>
    </message>
    <message>
        <source>This text does not end; close it with %1.</source>
        <translation>Dieser Text endet nicht; schließe ihn mit %1.</translation>
    </message>
    <message>
        <source>One “=” sets a value; write == to ask whether two are equal.</source>
        <translation>Ein „=“ setzt einen Wert; schreibe ==, um zu fragen, ob zwei gleich sind.</translation>
    </message>
    <message>
        <source>A comma has no meaning here; write 0.5 with a point, and join questions with “and”.</source>
        <translation>Ein Komma hat hier keine Bedeutung; schreibe 0.5 mit Punkt, und verbinde Fragen mit „and“.</translation>
    </message>
    <message>
        <source>%1 has no meaning here; there are numbers, names, + - * / ( ), comparisons, and, or, not.</source>
        <translation>%1 hat hier keine Bedeutung; es gibt Zahlen, Namen, + - * / ( ), Vergleiche, and, or, not.</translation>
    </message>
</context>
<context>
    <name>Cost</name>
    <message>
        <source>The run does not reach frame %1. %2 Ask for the frames after an earlier one.</source>
        <translation>Der Lauf kommt nicht bis Bild %1. %2 Frag nach den Bildern ab einem früheren.</translation>
    </message>
    <message>
        <source>changes nothing</source>
        <translation>ändert nichts</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>ausgeschaltet</translation>
    </message>
    <message>
        <source>Stopped before everything was measured.</source>
        <translation>Angehalten, bevor alles gemessen war.</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>effect</source>
        <translation>Effekt</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>times/frame</source>
        <translation>mal/Bild</translation>
    </message>
    <message>
        <source>ns/frame</source>
        <translation>ns/Bild</translation>
    </message>
    <message>
        <source>+-</source>
        <translation>+-</translation>
    </message>
    <message>
        <source>ns/point</source>
        <translation>ns/Punkt</translation>
    </message>
    <message>
        <source>share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>the method itself</source>
        <translation>das Verfahren selbst</translation>
    </message>
    <message>
        <source>whole frame</source>
        <translation>ganzes Bild</translation>
    </message>
    <message>
        <source>Each line is measured by itself; effects and method come to %1 of the whole frame.</source>
        <translation>Jede Zeile wird für sich gemessen; Effekte und Verfahren ergeben zusammen %1 des ganzen Bildes.</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
</context>
<context>
    <name>DifferenceTable</name>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>distance [px]</source>
        <translation>Abstand [px]</translation>
    </message>
    <message>
        <source>body</source>
        <translation>Körper</translation>
    </message>
</context>
<context>
    <name>DifferenceWords</name>
    <message>
        <source>The other run is being computed again…</source>
        <translation>Der andere Lauf wird neu berechnet …</translation>
    </message>
    <message>
        <source>There is no other run beside this one.</source>
        <translation>Neben diesem gibt es keinen anderen Lauf.</translation>
    </message>
    <message>
        <source>More than %1 points: too many to compare at every frame.</source>
        <translation>Mehr als %1 Punkte: zu viele, um sie bei jedem Bild zu vergleichen.</translation>
    </message>
    <message>
        <source>The other run does not have the body that is chosen.</source>
        <translation>Den gewählten Körper gibt es im anderen Lauf nicht.</translation>
    </message>
    <message>
        <source>The two runs have no body in common.</source>
        <translation>Die zwei Läufe haben keinen Körper gemeinsam.</translation>
    </message>
    <message>
        <source>No difference up to frame %1. Play on to see what comes of it.</source>
        <translation>Kein Unterschied bis Bild %1. Spiele weiter, um zu sehen, was daraus wird.</translation>
    </message>
    <message>
        <source>Largest: %1&#x2009;px apart, %2, at frame %3.</source>
        <translation>Am größten: %1&#x2009;px auseinander, %2, bei Bild %3.</translation>
    </message>
    <message>
        <source>Looked at every %1 frames.</source>
        <translation>Verglichen alle %1 Bilder.</translation>
    </message>
    <message>
        <source>parts at frame %1</source>
        <translation>trennt sich bei Bild %1</translation>
    </message>
    <message>
        <source>parts at the start</source>
        <translation>trennt sich am Anfang</translation>
    </message>
    <message>
        <source>%1, %2, kept</source>
        <translation>%1, %2, behalten</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>EdgeMarkers</name>
    <message>
        <source>%1&#x2009;px</source>
        <translation>%1&#x2009;px</translation>
    </message>
    <message>
        <source>%1 bodies</source>
        <translation>%1 Körper</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>EffectLines</name>
    <message>
        <source>Without “%1” a frame would cost %2&#x2009;µs in place of %3.</source>
        <translation>Ohne „%1“ würde ein Bild %2&#x2009;µs statt %3 kosten.</translation>
    </message>
    <message>
        <source>%1&#x2009;µs a frame, half of the rounds within %2.</source>
        <translation>%1&#x2009;µs pro Bild, die Hälfte der Durchgänge innerhalb von %2.</translation>
    </message>
    <message>
        <source>Points that it works on: %1.</source>
        <translation>Punkte, an denen er arbeitet: %1.</translation>
    </message>
    <message>
        <source>The method works it out together with the move.</source>
        <translation>Das Verfahren rechnet ihn zusammen mit der Bewegung aus.</translation>
    </message>
    <message>
        <source>A frame computes it %1.</source>
        <translation>Ein Bild berechnet ihn %1.</translation>
    </message>
    <message>
        <source>As it is set it can change nothing, so no frame computes it: 0&#x2009;µs.</source>
        <translation>So, wie er eingestellt ist, kann er nichts ändern, also berechnet ihn kein Bild: 0&#x2009;µs.</translation>
    </message>
    <message>
        <source>Switched off: it costs nothing.</source>
        <translation>Ausgeschaltet: Er kostet nichts.</translation>
    </message>
    <message>
        <source>Space or a click on the switch takes it out of the scene.</source>
        <translation>Leertaste oder ein Klick auf den Schalter nimmt ihn aus der Szene.</translation>
    </message>
    <message>
        <source>Space or a click on the switch puts it back.</source>
        <translation>Leertaste oder ein Klick auf den Schalter bringt ihn zurück.</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>ausgeschaltet</translation>
    </message>
    <message>
        <source>changes nothing here</source>
        <translation>ändert hier nichts</translation>
    </message>
    <message>
        <source>Rest of the frame</source>
        <translation>Rest des Bildes</translation>
    </message>
    <message>
        <source>What no effect takes: moving the points, and the method&apos;s own sums. It cannot be switched off.</source>
        <translation>Was kein Effekt braucht: die Punkte zu bewegen und die eigenen Rechnungen des Verfahrens. Das lässt sich nicht ausschalten.</translation>
    </message>
    <message>
        <source>%1 (%2). %3</source>
        <translation>%1 (%2). %3</translation>
    </message>
    <message>
        <source>not in this scene</source>
        <translation>nicht in dieser Szene</translation>
    </message>
    <message>
        <source>Not in this scene, so it costs nothing and there is nothing to switch. Other lessons have:</source>
        <translation>Nicht in dieser Szene, also kostet es nichts und es gibt nichts zu schalten. In anderen Lektionen gibt es:</translation>
    </message>
    <message>
        <source>%1, %2&#x2009;µs, %3</source>
        <translation>%1, %2&#x2009;µs, %3</translation>
    </message>
    <message>
        <source>%1, not measured yet</source>
        <translation>%1, noch nicht gemessen</translation>
    </message>
    <message>
        <source>%1, %2&#x2009;µs a frame</source>
        <translation>%1, %2&#x2009;µs pro Bild</translation>
    </message>
    <message>
        <source>on</source>
        <translation>an</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>%1, %2, %3</source>
        <translation>%1, %2, %3</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1%2µs a frame, ±%3</source>
        <translation>%1%2µs pro Bild, ±%3</translation>
    </message>
    <message>
        <source>Not in this scene, so it costs nothing.</source>
        <translation>Nicht in dieser Szene, also kostet es nichts.</translation>
    </message>
</context>
<context>
    <name>EnergyLines</name>
    <message>
        <source>Done by the hand</source>
        <translation>Von der Hand geleistet</translation>
    </message>
    <message>
        <source>What you put in by grabbing and dragging</source>
        <translation>Was du durch Greifen und Ziehen hineinsteckst</translation>
    </message>
    <message>
        <source>Changed with a number</source>
        <translation>Mit einer Zahl geändert</translation>
    </message>
    <message>
        <source>A stiffness or a length that changes also changes what springs hold</source>
        <translation>Eine Steifigkeit oder Länge, die sich ändert, ändert auch, was Federn halten</translation>
    </message>
    <message>
        <source>Done by what drives</source>
        <translation>Von Antrieben geleistet</translation>
    </message>
    <message>
        <source>What clocks and steering put in</source>
        <translation>Was Uhren und Steuerung hineinstecken</translation>
    </message>
    <message>
        <source>Done by wind</source>
        <translation>Vom Wind geleistet</translation>
    </message>
    <message>
        <source>What the wind puts in, or takes</source>
        <translation>Was der Wind hineinsteckt oder nimmt</translation>
    </message>
    <message>
        <source>Done by one-way pulls</source>
        <translation>Von einseitigen Zügen geleistet</translation>
    </message>
    <message>
        <source>A pull that pulls nothing back holds nothing: what it does, it makes or takes</source>
        <translation>Ein Zug, den nichts zurückzieht, hält nichts: Was er leistet, macht oder nimmt er</translation>
    </message>
    <message>
        <source>Given by gravity</source>
        <translation>Von der Schwerkraft gegeben</translation>
    </message>
    <message>
        <source>It pulls everything down, and nothing pulls back</source>
        <translation>Sie zieht alles nach unten, und nichts zieht zurück</translation>
    </message>
    <message>
        <source>Given by what stands fast</source>
        <translation>Von Feststehendem gegeben</translation>
    </message>
    <message>
        <source>Springs to a place that cannot move pull on it, and it pulls back</source>
        <translation>Federn an einem Ort, der sich nicht bewegen kann, ziehen an ihm, und er zieht zurück</translation>
    </message>
    <message>
        <source>Lost by damping</source>
        <translation>Durch Dämpfung verloren</translation>
    </message>
    <message>
        <source>What damping takes from everything that moves</source>
        <translation>Was die Dämpfung allem nimmt, das sich bewegt</translation>
    </message>
    <message>
        <source>At impacts</source>
        <translation>Bei Stößen</translation>
    </message>
    <message>
        <source>What walls and ground take, and what they lift bodies by</source>
        <translation>Was Wände und Boden nehmen und worum sie Körper anheben</translation>
    </message>
    <message>
        <source>Changed by sticks</source>
        <translation>Durch Stäbe geändert</translation>
    </message>
    <message>
        <source>What sticks and joints change when they put things right</source>
        <translation>Was Stäbe und Gelenke ändern, wenn sie etwas richtigstellen</translation>
    </message>
    <message>
        <source>Drift of the method</source>
        <translation>Drift des Verfahrens</translation>
    </message>
    <message>
        <source>Made or lost by the method&apos;s error: nothing in the scene explains it. A smaller step or another method makes it smaller.</source>
        <translation>Durch den Fehler des Verfahrens entstanden oder verloren: Nichts in der Szene erklärt es. Ein kleinerer Zeitschritt oder ein anderes Verfahren macht ihn kleiner.</translation>
    </message>
    <message>
        <source>In what moves</source>
        <translation>In der Bewegung</translation>
    </message>
    <message>
        <source>Half of mass × speed², added up over all points</source>
        <translation>Die Hälfte von Masse × Tempo², über alle Punkte addiert</translation>
    </message>
    <message>
        <source>Held by height</source>
        <translation>Durch Höhe gespeichert</translation>
    </message>
    <message>
        <source>Mass × gravity × height, counted from the lowest of this run</source>
        <translation>Masse × Schwerkraft × Höhe, gezählt vom tiefsten Punkt dieses Laufs</translation>
    </message>
    <message>
        <source>What springs hold</source>
        <translation>In den Federn</translation>
    </message>
    <message>
        <source>Half of stiffness × stretch², added up over all springs</source>
        <translation>Die Hälfte von Steifigkeit × Dehnung², über alle Federn addiert</translation>
    </message>
    <message>
        <source>Mass × velocity, added up over all points: to the right, and down</source>
        <translation>Masse × Geschwindigkeit, über alle Punkte addiert: nach rechts und nach unten</translation>
    </message>
    <message>
        <source>Something here has no velocity of its own: a rule puts it where it goes, and nothing keeps it moving. So there is no energy to count. Scenes in which everything has inertia have this ledger.</source>
        <translation>Etwas hat hier keine eigene Geschwindigkeit: Eine Regel setzt es dorthin, wo es hingehört, und nichts hält es in Bewegung. Also gibt es keine Energie zu zählen. Szenen, in denen alles träge ist, haben diese Bilanz.</translation>
    </message>
    <message>
        <source>Nothing here moves by itself: where it is, something else decides. So there is no energy to count. Scenes with a body that a spring pulls have this ledger.</source>
        <translation>Hier bewegt sich nichts von selbst: Wo es ist, entscheidet etwas anderes. Also gibt es keine Energie zu zählen. Szenen mit einem Körper, an dem eine Feder zieht, haben diese Bilanz.</translation>
    </message>
    <message>
        <source>There are more than %1 points here. To count the energy of all of them, phase by phase, would take longer than the run itself.</source>
        <translation>Hier gibt es mehr als %1 Punkte. Die Energie von allen Phase für Phase zu zählen, würde länger dauern als der Lauf selbst.</translation>
    </message>
    <message>
        <source>Nothing here tells how heavy what turns is. So there is no energy to count.</source>
        <translation>Nichts sagt hier, wie schwer das ist, was sich dreht. Also gibt es keine Energie zu zählen.</translation>
    </message>
    <message>
        <source>inertia × degrees²/frame²</source>
        <translation>Trägheit × Grad²/Bild²</translation>
    </message>
    <message>
        <source>mass × px²/frame²</source>
        <translation>Masse × px²/Bild²</translation>
    </message>
    <message>
        <source>mass × px/frame</source>
        <translation>Masse × px/Bild</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
</context>
<context>
    <name>Experiment</name>
    <message>
        <source>%1: the file is larger than %2 MiB, which is the most for an experiment.</source>
        <translation>%1: Die Datei ist größer als %2 MiB, und mehr darf ein Experiment nicht haben.</translation>
    </message>
    <message>
        <source>%1: this is a folder; give the file of an experiment.</source>
        <translation>%1: Das ist ein Ordner; gib die Datei eines Experiments an.</translation>
    </message>
    <message>
        <source>%1: there is no such file; check its name and folder.</source>
        <translation>%1: Diese Datei gibt es nicht; prüfe Namen und Ordner.</translation>
    </message>
    <message>
        <source>%1: the file cannot be read: %2.</source>
        <translation>%1: Die Datei lässt sich nicht lesen: %2.</translation>
    </message>
    <message>
        <source>there is no lesson %1, as no lesson is installed; SPRINGSTEP_LESSONS can name the folder that has them.</source>
        <translation>es gibt keine Lektion %1, denn es ist keine Lektion installiert; SPRINGSTEP_LESSONS kann den Ordner nennen, in dem sie sind.</translation>
    </message>
    <message>
        <source>there is no lesson %1; there is %2.</source>
        <translation>es gibt keine Lektion %1; es gibt %2.</translation>
    </message>
    <message>
        <source>the lesson %1 has no step %2; it has %3.</source>
        <translation>die Lektion %1 hat keinen Schritt %2; sie hat %3.</translation>
    </message>
    <message>
        <source>%1: the file cannot be written: %2. Choose another folder or name.</source>
        <translation>%1: Die Datei lässt sich nicht schreiben: %2. Wähle einen anderen Ordner oder Namen.</translation>
    </message>
    <message>
        <source>there is no method %1; there is %2.</source>
        <translation>es gibt kein Verfahren %1; es gibt %2.</translation>
    </message>
    <message>
        <source>the method %1 chooses its own steps; give &quot;tolerance&quot; in place of &quot;h&quot;.</source>
        <translation>das Verfahren %1 wählt seine Zeitschritte selbst; gib &quot;tolerance&quot; statt &quot;h&quot; an.</translation>
    </message>
    <message>
        <source>the method %1 takes steps of one length; give &quot;h&quot; in place of &quot;tolerance&quot;.</source>
        <translation>das Verfahren %1 macht Zeitschritte von einer Länge; gib &quot;h&quot; statt &quot;tolerance&quot; an.</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>die Datei</translation>
    </message>
    <message>
        <source>&quot;format&quot; is %1; this program reads %2.</source>
        <translation>&quot;format&quot; ist %1; dieses Programm liest %2.</translation>
    </message>
    <message>
        <source>&quot;scene&quot; does not go with a lesson&apos;s step, which has its own; remove it, and change that one by &quot;parameters&quot;, &quot;bodies&quot; and &quot;effects&quot;.</source>
        <translation>&quot;scene&quot; passt nicht zum Schritt einer Lektion, der seine eigene hat; entferne es und ändere jene mit &quot;parameters&quot;, &quot;bodies&quot; und &quot;effects&quot;.</translation>
    </message>
    <message>
        <source>the step %1 has no sticks; remove &quot;links&quot;.</source>
        <translation>der Schritt %1 hat keine Stäbe; entferne &quot;links&quot;.</translation>
    </message>
    <message>
        <source>nothing is held at frame %1; a %2 comes after a &quot;grab&quot;.</source>
        <translation>bei Bild %1 wird nichts gehalten; ein %2 kommt nach einem &quot;grab&quot;.</translation>
    </message>
    <message>
        <source>the step %1 has no effect %2; it has %3.</source>
        <translation>der Schritt %1 hat keinen Effekt %2; er hat %3.</translation>
    </message>
    <message>
        <source>the body %1</source>
        <translation>der Körper %1</translation>
    </message>
    <message>
        <source>there is no body %1 here; there is %2.</source>
        <translation>hier gibt es keinen Körper %1; es gibt %2.</translation>
    </message>
    <message>
        <source>Not saved: a number of this experiment is not finite, and files have no such number. Go back to a frame before that.</source>
        <translation>Nicht gespeichert: Eine Zahl dieses Experiments ist nicht endlich, und Dateien kennen keine solche Zahl. Geh zurück zu einem Bild davor.</translation>
    </message>
    <message>
        <source>Not saved: the step %1 is not installed any more.</source>
        <translation>Nicht gespeichert: Der Schritt %1 ist nicht mehr installiert.</translation>
    </message>
    <message>
        <source>the step %1 has its sticks in &quot;scene&quot;; move &quot;links&quot; there and call it &quot;sticks&quot;.</source>
        <translation>der Schritt %1 hat seine Stäbe in &quot;scene&quot;; verschiebe &quot;links&quot; dorthin und nenne es &quot;sticks&quot;.</translation>
    </message>
    <message>
        <source>&quot;name&quot; has %1 letters; it can have 1 to %2.</source>
        <translation>&quot;name&quot; hat %1 Zeichen; erlaubt sind 1 bis %2.</translation>
    </message>
    <message>
        <source>&quot;branches&quot; has %1 runs; it can have up to %2.</source>
        <translation>&quot;branches&quot; hat %1 Läufe; erlaubt sind bis zu %2.</translation>
    </message>
    <message>
        <source>the runs in &quot;branches&quot; have more than %1 events together; remove some.</source>
        <translation>die Läufe in &quot;branches&quot; haben zusammen mehr als %1 Ereignisse; nimm einige heraus.</translation>
    </message>
    <message>
        <source>a branch</source>
        <translation>ein Zweig</translation>
    </message>
    <message>
        <source>a text that tells it from others</source>
        <translation>ein Text, der ihn von anderen unterscheidet</translation>
    </message>
    <message>
        <source>frame %1 comes before the branch does, whose &quot;fork&quot; is %2; begin there or later.</source>
        <translation>Bild %1 liegt vor dem Zweig, dessen &quot;fork&quot; %2 ist; beginne dort oder später.</translation>
    </message>
    <message>
        <source>Not saved: there are more runs beside this one than a file can have: %1 with %2 events together. Delete some that you named or keep, in “Runs”.</source>
        <translation>Nicht gespeichert: Neben diesem Lauf gibt es mehr, als eine Datei haben kann: %1 mit zusammen %2 Ereignissen. Lösche in „Läufe“ einige, die du benannt hast oder behältst.</translation>
    </message>
    <message>
        <source>Not saved: the run has more input than a file can have. Start it again, or go back and change it earlier.</source>
        <translation>Nicht gespeichert: Der Lauf hat mehr Eingaben, als eine Datei haben kann. Beginne ihn neu, oder geh zurück und ändere ihn früher.</translation>
    </message>
</context>
<context>
    <name>ExperimentInput</name>
    <message>
        <source>the step %1 has no event %2; it knows %3.</source>
        <translation>der Schritt %1 hat kein Ereignis %2; er kennt %3.</translation>
    </message>
    <message>
        <source>a body&apos;s name</source>
        <translation>der Name eines Körpers</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
</context>
<context>
    <name>ExperimentLine</name>
    <message>
        <source>The text begins as an experiment does, but it is not whole. Copy all of it, from “springstep:” to its end.</source>
        <translation>Der Text beginnt wie ein Experiment, ist aber nicht vollständig. Kopiere ihn ganz, von „springstep:“ bis zum Ende.</translation>
    </message>
    <message>
        <source>The text holds more than %1 MiB, which is the most for an experiment.</source>
        <translation>Der Text enthält mehr als %1 MiB, und mehr darf ein Experiment nicht haben.</translation>
    </message>
    <message>
        <source>This run has so much input that it does not fit a message. Save it as a file (Ctrl+S), and send that.</source>
        <translation>Dieser Lauf hat so viele Eingaben, dass er nicht in eine Nachricht passt. Speichere ihn als Datei (Strg+S) und verschicke diese.</translation>
    </message>
    <message>
        <source>There is no text to paste. Copy an experiment first: it begins with “springstep:” or {.</source>
        <translation>Es gibt keinen Text zum Einfügen. Kopiere zuerst ein Experiment: Es beginnt mit „springstep:“ oder {.</translation>
    </message>
    <message>
        <source>The text that was copied is no experiment: one begins with “springstep:” or {.</source>
        <translation>Der kopierte Text ist kein Experiment: Eines beginnt mit „springstep:“ oder {.</translation>
    </message>
    <message>
        <source>The text is too long for an experiment in one line. Open it as a file.</source>
        <translation>Der Text ist zu lang für ein Experiment in einer Zeile. Öffne ihn als Datei.</translation>
    </message>
    <message>
        <source>Pasted text</source>
        <translation>Eingefügter Text</translation>
    </message>
</context>
<context>
    <name>ExperimentPoints</name>
    <message>
        <source>a point&apos;s name</source>
        <translation>der Name eines Punktes</translation>
    </message>
    <message>
        <source>there is no point %1 here; there is &quot;p0&quot; to %2.</source>
        <translation>hier gibt es keinen Punkt %1; es gibt &quot;p0&quot; bis %2.</translation>
    </message>
    <message>
        <source>&quot;share&quot; is %1; it can be 0 to 1.</source>
        <translation>&quot;share&quot; ist %1; möglich ist 0 bis 1.</translation>
    </message>
    <message>
        <source>&quot;length&quot; is %1; it can be 0 to 1000000 px.</source>
        <translation>&quot;length&quot; ist %1; möglich ist 0 bis 1000000 px.</translation>
    </message>
    <message>
        <source>&quot;bodies&quot; has %1 points; the most is %2.</source>
        <translation>&quot;bodies&quot; hat %1 Punkte; höchstens sind es %2.</translation>
    </message>
    <message>
        <source>there is no body %1 here; the points are called &quot;p0&quot;, &quot;p1&quot; and so on.</source>
        <translation>hier gibt es keinen Körper %1; die Punkte heißen &quot;p0&quot;, &quot;p1&quot; und so weiter.</translation>
    </message>
    <message>
        <source>the points have a gap: %1 of them are &quot;p0&quot; to %2, without %3.</source>
        <translation>die Punkte haben eine Lücke: %1 von ihnen sind &quot;p0&quot; bis %2, ohne %3.</translation>
    </message>
    <message>
        <source>&quot;links&quot; has %1 sticks; the most is %2.</source>
        <translation>&quot;links&quot; hat %1 Stäbe; höchstens sind es %2.</translation>
    </message>
    <message>
        <source>a link</source>
        <translation>ein Stab</translation>
    </message>
    <message>
        <source>a link has %1 at both ends; give it two points.</source>
        <translation>ein Stab hat %1 an beiden Enden; gib ihm zwei Punkte.</translation>
    </message>
</context>
<context>
    <name>Film</name>
    <message>
        <source>The last frame, %1, comes before the first, %2. Swap them.</source>
        <translation>Das letzte Bild, %1, kommt vor dem ersten, %2. Vertausche sie.</translation>
    </message>
    <message>
        <source>A GIF shows at most %1 pictures a second, and this would be %2. Choose fewer, or PNG files.</source>
        <translation>Ein GIF zeigt höchstens %1 Bilder pro Sekunde, und hier wären es %2. Wähle weniger oder PNG-Dateien.</translation>
    </message>
    <message>
        <source>The run does not reach frame %1: it stops at frame %2. Begin the film earlier.</source>
        <translation>Der Lauf kommt nicht bis Bild %1: Er hält bei Bild %2 an. Beginne den Film früher.</translation>
    </message>
</context>
<context>
    <name>FilmFile</name>
    <message>
        <source>%1 cannot be written: %2. Make room, or choose another folder.</source>
        <translation>%1 lässt sich nicht schreiben: %2. Schaffe Platz oder wähle einen anderen Ordner.</translation>
    </message>
    <message>
        <source>%1 is no film&apos;s name: it ends in .webm or .gif, or, for a picture of each frame, in .png with %04d where the frame&apos;s number goes, such as walk_%04d.png.</source>
        <translation>%1 ist kein Name für einen Film: Der endet auf .webm oder .gif oder, für eine Datei pro Bild, auf .png, mit %04d dort, wo die Nummer des Bildes hinkommt, zum Beispiel walk_%04d.png.</translation>
    </message>
</context>
<context>
    <name>FilmVerb</name>
    <message>
        <source>Frame %1 of %2, %3 %</source>
        <translation>Bild %1 von %2, %3 %</translation>
    </message>
    <message>
        <source>Stopped at frame %1 of %2.</source>
        <translation>Angehalten bei Bild %1 von %2.</translation>
    </message>
    <message>
        <source>Setting up the run</source>
        <translation>Bereitet den Lauf vor</translation>
    </message>
</context>
<context>
    <name>FrameCaption</name>
    <message>
        <source>pulls go straight onto the velocity, %1.</source>
        <translation>Züge gehen gleich in die Geschwindigkeit ein, %1.</translation>
    </message>
    <message>
        <source>accelerations are gathered, %1.</source>
        <translation>Beschleunigungen werden gesammelt, %1.</translation>
    </message>
    <message>
        <source>velocities have changed, %1.</source>
        <translation>Geschwindigkeiten haben sich geändert, %1.</translation>
    </message>
    <message>
        <source>%1 moved already, %2 not yet.</source>
        <translation>schon bewegt: %1, noch nicht: %2.</translation>
    </message>
    <message>
        <source>everything has moved, %1 to come.</source>
        <translation>alles hat sich bewegt, „%1“ kommt noch.</translation>
    </message>
    <message>
        <source>everything has moved.</source>
        <translation>alles hat sich bewegt.</translation>
    </message>
    <message>
        <source>Inside frame %1: %2 of %3 steps are done.</source>
        <translation>Innerhalb von Bild %1: %2 von %3 Zeitschritten sind getan.</translation>
    </message>
    <message>
        <source>nothing has moved in it yet</source>
        <translation>in ihm hat sich noch nichts bewegt</translation>
    </message>
    <message>
        <source>nothing has moved yet</source>
        <translation>noch hat sich nichts bewegt</translation>
    </message>
    <message>
        <source>Inside frame %1, step %2 of %3: %4</source>
        <translation>Innerhalb von Bild %1, Zeitschritt %2 von %3: %4</translation>
    </message>
    <message>
        <source>Inside frame %1: %2</source>
        <translation>Innerhalb von Bild %1: %2</translation>
    </message>
    <message>
        <source>%1 has moved things directly, not by a velocity.</source>
        <translation>%1 hat Dinge direkt bewegt, nicht über eine Geschwindigkeit.</translation>
    </message>
</context>
<context>
    <name>Gestures</name>
    <message>
        <source>Drag a body</source>
        <translation>Einen Körper ziehen</translation>
    </message>
    <message>
        <source>grab it; let go while moving to throw it</source>
        <translation>greifen; in Bewegung loslassen, um ihn zu werfen</translation>
    </message>
    <message>
        <source>Drag the background</source>
        <translation>Den Hintergrund ziehen</translation>
    </message>
    <message>
        <source>move the picture</source>
        <translation>die Szene verschieben</translation>
    </message>
    <message>
        <source>Click an arrow at the edge</source>
        <translation>Auf einen Pfeil am Rand klicken</translation>
    </message>
    <message>
        <source>go to the body outside that it points to</source>
        <translation>zu dem Körper außerhalb gehen, auf den er zeigt</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>zoom where the pointer is</source>
        <translation>vergrößern, wo der Zeiger ist</translation>
    </message>
    <message>
        <source>[ and ]</source>
        <translation>[ und ]</translation>
    </message>
    <message>
        <source>choose the body before or after</source>
        <translation>den Körper davor oder danach wählen</translation>
    </message>
    <message>
        <source>Alt and an arrow key</source>
        <translation>Alt und eine Pfeiltaste</translation>
    </message>
    <message>
        <source>carry the chosen body 10 px</source>
        <translation>den gewählten Körper 10 px tragen</translation>
    </message>
    <message>
        <source>Press the background</source>
        <translation>Auf den Hintergrund drücken</translation>
    </message>
    <message>
        <source>blow, steer or aim, where a step has that</source>
        <translation>blasen, lenken oder zielen, wo ein Schritt das hat</translation>
    </message>
    <message>
        <source>Drag with the middle button</source>
        <translation>Mit der mittleren Taste ziehen</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Pfeiltasten</translation>
    </message>
    <message>
        <source>steer, where a step has that</source>
        <translation>lenken, wo ein Schritt das hat</translation>
    </message>
    <message>
        <source>Alt, Shift and an arrow key</source>
        <translation>Alt, Umschalt und eine Pfeiltaste</translation>
    </message>
    <message>
        <source>move the pointer or the target 20 px</source>
        <translation>Zeiger oder Ziel um 20 px bewegen</translation>
    </message>
    <message>
        <source>Alt and Enter</source>
        <translation>Alt und Eingabe</translation>
    </message>
    <message>
        <source>pointer button down or up</source>
        <translation>Zeigertaste drücken oder loslassen</translation>
    </message>
    <message>
        <source>Drag an end of the ruler</source>
        <translation>Ein Ende des Lineals ziehen</translation>
    </message>
    <message>
        <source>measure a length and an angle (switch it on under Show)</source>
        <translation>eine Länge und einen Winkel messen (einzuschalten unter „Zeigen“)</translation>
    </message>
    <message>
        <source>Ctrl, Alt and an arrow key</source>
        <translation>Strg, Alt und eine Pfeiltaste</translation>
    </message>
    <message>
        <source>move the ruler&apos;s far end 5 px; with Shift the near one</source>
        <translation>das ferne Ende des Lineals um 5 px bewegen; mit Umschalt das nahe</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>let go</source>
        <translation>loslassen</translation>
    </message>
    <message>
        <source>Click the dots below a ring</source>
        <translation>Auf die Punkte unter einem Ring klicken</translation>
    </message>
    <message>
        <source>show the run that parts there beside this one; right-click: more</source>
        <translation>den Lauf, der dort abzweigt, neben diesem zeigen; Rechtsklick: mehr</translation>
    </message>
    <message>
        <source>Shift and a click</source>
        <translation>Umschalt und ein Klick</translation>
    </message>
    <message>
        <source>choose one part more, or one less</source>
        <translation>ein Teil mehr wählen, oder eines weniger</translation>
    </message>
    <message>
        <source>choose what is in the box</source>
        <translation>wählen, was im Rahmen ist</translation>
    </message>
    <message>
        <source>Drag from point to point</source>
        <translation>Von Punkt zu Punkt ziehen</translation>
    </message>
    <message>
        <source>tie them, with a spring or a stick in hand</source>
        <translation>sie verbinden, mit einer Feder oder einem Stab in der Hand</translation>
    </message>
    <message>
        <source>Arrow keys and Enter</source>
        <translation>Pfeiltasten und Eingabe</translation>
    </message>
    <message>
        <source>move the tool 10 px, with Shift 1 px; use it</source>
        <translation>das Werkzeug um 10 px bewegen, mit Umschalt um 1 px; es benutzen</translation>
    </message>
    <message>
        <source>move what is chosen 10 px, with Shift 1 px</source>
        <translation>das Gewählte um 10 px bewegen, mit Umschalt um 1 px</translation>
    </message>
    <message>
        <source>{ and }</source>
        <translation>{ und }</translation>
    </message>
    <message>
        <source>choose the spring or stick before or after</source>
        <translation>die Feder oder den Stab davor oder danach wählen</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>end a row of links, put the tool away, choose nothing</source>
        <translation>eine Reihe von Verbindungen beenden, das Werkzeug weglegen, nichts wählen</translation>
    </message>
    <message>
        <source>Drag the timeline</source>
        <translation>Die Zeitleiste ziehen</translation>
    </message>
    <message>
        <source>go anywhere in time</source>
        <translation>irgendwohin in der Zeit gehen</translation>
    </message>
    <message>
        <source>Click a phase</source>
        <translation>Auf eine Phase klicken</translation>
    </message>
    <message>
        <source>run to it</source>
        <translation>bis zu ihr laufen</translation>
    </message>
    <message>
        <source>Point at timeline, phase, plot or trail</source>
        <translation>Auf Zeitleiste, Phase, Diagramm oder Spur zeigen</translation>
    </message>
    <message>
        <source>look at that moment; the run stays where it stands</source>
        <translation>einen Blick auf diesen Moment werfen; der Lauf bleibt, wo er steht</translation>
    </message>
    <message>
        <source>Alt and the underlined letter</source>
        <translation>Alt und der unterstrichene Buchstabe</translation>
    </message>
    <message>
        <source>where a run has stopped by itself: use what mends it</source>
        <translation>wo ein Lauf von selbst angehalten hat: nehmen, was ihn heilt</translation>
    </message>
    <message>
        <source>Drop a file on the window</source>
        <translation>Eine Datei auf das Fenster ziehen</translation>
    </message>
    <message>
        <source>open it</source>
        <translation>sie öffnen</translation>
    </message>
    <message>
        <source>Press or drag</source>
        <translation>Drücken oder ziehen</translation>
    </message>
    <message>
        <source>go to a frame</source>
        <translation>zu einem Bild gehen</translation>
    </message>
    <message>
        <source>+ and −, or Ctrl and the wheel</source>
        <translation>+ und −, oder Strg und das Mausrad</translation>
    </message>
    <message>
        <source>fewer or more frames</source>
        <translation>weniger oder mehr Bilder</translation>
    </message>
    <message>
        <source>The names above a plot</source>
        <translation>Die Namen über einem Diagramm</translation>
    </message>
    <message>
        <source>menus of what it shows</source>
        <translation>Menüs dafür, was es zeigt</translation>
    </message>
    <message>
        <source>Menu key, or right-click</source>
        <translation>Menütaste oder Rechtsklick</translation>
    </message>
    <message>
        <source>save, copy, keep or remove it</source>
        <translation>es speichern, kopieren, festhalten oder entfernen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>es entfernen</translation>
    </message>
    <message>
        <source>Click a line, or Enter</source>
        <translation>Auf eine Zeile klicken, oder Eingabe</translation>
    </message>
    <message>
        <source>run to its phase</source>
        <translation>bis zu ihrer Phase laufen</translation>
    </message>
    <message>
        <source>Click left of a line, or F9</source>
        <translation>Links neben eine Zeile klicken, oder F9</translation>
    </message>
    <message>
        <source>stop before its phase, or no longer</source>
        <translation>vor ihrer Phase anhalten, oder nicht mehr</translation>
    </message>
    <message>
        <source>Drag a dotted word</source>
        <translation>Ein gepunktetes Wort ziehen</translation>
    </message>
    <message>
        <source>change that parameter; with Shift finely</source>
        <translation>diesen Parameter ändern; mit Umschalt fein</translation>
    </message>
    <message>
        <source>Double-click it, or F2</source>
        <translation>Doppelklick darauf, oder F2</translation>
    </message>
    <message>
        <source>type the parameter&apos;s value</source>
        <translation>den Wert des Parameters eintippen</translation>
    </message>
    <message>
        <source>Point at a word, or Ctrl+I</source>
        <translation>Auf ein Wort zeigen, oder Strg+I</translation>
    </message>
    <message>
        <source>its value, and its last 120 frames</source>
        <translation>sein Wert und seine letzten 120 Bilder</translation>
    </message>
    <message>
        <source>Up and Down</source>
        <translation>Auf und Ab</translation>
    </message>
    <message>
        <source>from line to line; with Ctrl from heading to heading</source>
        <translation>von Zeile zu Zeile; mit Strg von Überschrift zu Überschrift</translation>
    </message>
    <message>
        <source>Ctrl and Left or Right</source>
        <translation>Strg und Links oder Rechts</translation>
    </message>
    <message>
        <source>from word to word</source>
        <translation>von Wort zu Wort</translation>
    </message>
    <message>
        <source>Enter, on a heading</source>
        <translation>Eingabe auf einer Überschrift</translation>
    </message>
    <message>
        <source>fold or unfold</source>
        <translation>zuklappen oder aufklappen</translation>
    </message>
    <message>
        <source>F8</source>
        <translation>F8</translation>
    </message>
    <message>
        <source>show the lines of the step before that are gone</source>
        <translation>die Zeilen des Schritts davor zeigen, die weg sind</translation>
    </message>
    <message>
        <source>Ctrl+C</source>
        <translation>Strg+C</translation>
    </message>
    <message>
        <source>copy what is selected, or the whole region</source>
        <translation>das Ausgewählte kopieren, oder den ganzen Bereich</translation>
    </message>
    <message>
        <source>Stop when…</source>
        <translation>Anhalten, wenn …</translation>
    </message>
    <message>
        <source>the field below the code: stop when that comes true</source>
        <translation>das Feld unter dem Code: anhalten, wenn das wahr wird</translation>
    </message>
    <message>
        <source>walk through the points of a plot</source>
        <translation>durch die Punkte einer Kurve gehen</translation>
    </message>
    <message>
        <source>Enter or a click</source>
        <translation>Eingabe oder ein Klick</translation>
    </message>
    <message>
        <source>use the method and step of a point</source>
        <translation>Verfahren und Zeitschritt eines Punktes verwenden</translation>
    </message>
    <message>
        <source>+ and −, or drag the line</source>
        <translation>+ und −, oder die Linie ziehen</translation>
    </message>
    <message>
        <source>how far off is near enough</source>
        <translation>wie viel Abweichung nah genug ist</translation>
    </message>
</context>
<context>
    <name>GifFile</name>
    <message>
        <source>%1 cannot be written: %2. Make room, or choose another folder.</source>
        <translation>%1 lässt sich nicht schreiben: %2. Schaffe Platz oder wähle einen anderen Ordner.</translation>
    </message>
</context>
<context>
    <name>GroundLayer</name>
    <message>
        <source>%1&#x202f;px</source>
        <translation>%1&#x202f;px</translation>
    </message>
</context>
<context>
    <name>GrowthTable</name>
    <message>
        <source>step [frames]</source>
        <translation>Zeitschritt [Bilder]</translation>
    </message>
    <message>
        <source>growth [a frame]</source>
        <translation>Wachstum [pro Bild]</translation>
    </message>
</context>
<context>
    <name>Gui</name>
    <message>
        <source>No lesson was found in %1. Build the lessons, or name their folder in SPRINGSTEP_LESSONS.</source>
        <translation>In %1 wurde keine Lektion gefunden. Baue die Lektionen oder nenne ihren Ordner in SPRINGSTEP_LESSONS.</translation>
    </message>
    <message>
        <source>%1 cannot be written: name a folder that you may write to, and a file that ends in .png or .jpg.</source>
        <translation>%1 lässt sich nicht schreiben: Nenne einen Ordner, in den du schreiben darfst, und eine Datei, die auf .png oder .jpg endet.</translation>
    </message>
</context>
<context>
    <name>HardCases</name>
    <message>
        <source>There is no case %1; there is %2.</source>
        <translation>Es gibt keinen Fall %1; es gibt %2.</translation>
    </message>
    <message>
        <source>%1, %2: %3 %</source>
        <translation>%1, %2: %3 %</translation>
    </message>
    <message>
        <source>Stopped before every case was run.</source>
        <translation>Angehalten, bevor jeder Fall gelaufen war.</translation>
    </message>
    <message>
        <source>method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>claims</source>
        <translation>Zusage</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>hält</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>ns/frame</source>
        <translation>ns/Bild</translation>
    </message>
    <message>
        <source>BROKEN</source>
        <translation>GEBROCHEN</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>hält nicht</translation>
    </message>
    <message>
        <source>%1 of %2 runs are claimed</source>
        <translation>%1 von %2 Läufen sind zugesagt</translation>
    </message>
    <message>
        <source>, and all of those hold.</source>
        <translation>, und sie halten alle.</translation>
    </message>
    <message>
        <source>, and %1 of those fail: %2.</source>
        <translation>, und %1 davon halten nicht: %2.</translation>
    </message>
    <message>
        <source>It moves one thing after the other, so pulls between them do not cancel out.</source>
        <translation>Es bewegt eins nach dem anderen, darum heben sich die Züge dazwischen nicht auf.</translation>
    </message>
    <message>
        <source>It looks for the moment in which a body is free of all walls, and here there is none.</source>
        <translation>Es sucht den Moment, in dem ein Körper frei von allen Wänden ist, und den gibt es hier nicht.</translation>
    </message>
    <message>
        <source>Nothing damps, so what its steps are off adds up: to %1 px in %2 frames at worst.</source>
        <translation>Nichts dämpft, darum summiert sich die Abweichung seiner Zeitschritte: schlimmstenfalls auf %1 px in %2 Bildern.</translation>
    </message>
    <message>
        <source>Steps that may be %1 px off keep it stirring by up to %2 px a frame.</source>
        <translation>Zeitschritte, die um %1 px abweichen dürfen, halten es mit bis zu %2 px pro Bild in Unruhe.</translation>
    </message>
    <message>
        <source>At a step of h %1 its stiffest spring (%2) would go from %3 px to %4 px, and farther.</source>
        <translation>Bei einem Zeitschritt von h %1 ginge seine steifste Feder (%2) von %3 px auf %4 px und weiter.</translation>
    </message>
    <message>
        <source>Its sticks are measured by steps of h %1: at %2 they err more.</source>
        <translation>Seine Stäbe werden an Zeitschritten von h %1 gemessen: Bei %2 ist ihr Fehler größer.</translation>
    </message>
    <message>
        <source>At a step of h %1 its stiffest spring (%2) would swing on: of %3 px, %4 px would be left after %5 frames.</source>
        <translation>Bei einem Zeitschritt von h %1 würde seine steifste Feder (%2) weiterschwingen: Von %3 px wären nach %5 Bildern noch %4 px übrig.</translation>
    </message>
    <message>
        <source>After frame %1 %2 is nowhere any more: &quot;%3&quot; gave a number without an end.</source>
        <translation>Nach Bild %1 ist %2 nirgends mehr: „%3“ ergab eine Zahl ohne Ende.</translation>
    </message>
    <message>
        <source>At frame %1 %2 is more than %3 px away.</source>
        <translation>Bei Bild %1 ist %2 mehr als %3 px entfernt.</translation>
    </message>
    <message>
        <source>At frame %1 the middle of all has gone %2 px, and nothing pushed it.</source>
        <translation>Bei Bild %1 ist die Mitte von allem um %2 px gewandert, und nichts hat sie geschoben.</translation>
    </message>
    <message>
        <source>At frame %1 the stick between %2 and %3 is %4 px wrong, and %5 px are possible.</source>
        <translation>Bei Bild %1 ist der Stab zwischen %2 und %3 um %4 px falsch, und %5 px sind möglich.</translation>
    </message>
    <message>
        <source>In the end %1 still goes %2 px a frame.</source>
        <translation>Am Ende bewegt sich %1 immer noch um %2 px pro Bild.</translation>
    </message>
    <message>
        <source>In the end %1 is %2 px from where it should rest.</source>
        <translation>Am Ende ist %1 um %2 px von dem Ort entfernt, an dem es ruhen sollte.</translation>
    </message>
    <message>
        <source>In the end the distance of %1 and %2 is %3 px wrong.</source>
        <translation>Am Ende ist der Abstand von %1 und %2 um %3 px falsch.</translation>
    </message>
    <message>
        <source>A second run differs from the first at frame %1.</source>
        <translation>Ein zweiter Lauf unterscheidet sich vom ersten bei Bild %1.</translation>
    </message>
    <message>
        <source>It should be refused, and is not.</source>
        <translation>Es sollte abgelehnt werden und wird es nicht.</translation>
    </message>
    <message>
        <source>It should end with a word about what is not finite, and does not.</source>
        <translation>Es sollte mit einem Wort darüber enden, was nicht endlich ist, und tut es nicht.</translation>
    </message>
    <message>
        <source>It would need about %1 steps a frame, and gives up at %2.</source>
        <translation>Es bräuchte etwa %1 Zeitschritte pro Bild und gibt bei %2 auf.</translation>
    </message>
    <message>
        <source>After frame %1 it needs more steps for a frame than it may take.</source>
        <translation>Nach Bild %1 braucht es für ein Bild mehr Zeitschritte, als es darf.</translation>
    </message>
</context>
<context>
    <name>JsonDocument</name>
    <message>
        <source>%1 is too large for a number; the largest is %2.</source>
        <translation>%1 ist zu groß für eine Zahl; die größte ist %2.</translation>
    </message>
    <message>
        <source>%1 is given twice; keep one of them.</source>
        <translation>%1 ist zweimal angegeben; behalte eines davon.</translation>
    </message>
    <message>
        <source>lists and objects stand more than %1 deep in each other here; an experiment needs 3.</source>
        <translation>Listen und Objekte stehen hier mehr als %1-fach ineinander; ein Experiment braucht 3.</translation>
    </message>
    <message>
        <source>an experiment has at most %1 values; here begins one more.</source>
        <translation>ein Experiment hat höchstens %1 Werte; hier beginnt einer mehr.</translation>
    </message>
    <message>
        <source>the experiment ends before this; remove what follows its closing bracket.</source>
        <translation>das Experiment endet davor; entferne, was nach seiner schließenden Klammer kommt.</translation>
    </message>
    <message>
        <source>a name in double quotes is expected here.</source>
        <translation>hier wird ein Name in doppelten Anführungszeichen erwartet.</translation>
    </message>
    <message>
        <source>a colon is expected here, between a name and its value.</source>
        <translation>hier wird ein Doppelpunkt erwartet, zwischen einem Namen und seinem Wert.</translation>
    </message>
    <message>
        <source>a comma or a closing } is expected here.</source>
        <translation>hier wird ein Komma oder ein schließendes } erwartet.</translation>
    </message>
    <message>
        <source>a comma or a closing ] is expected here.</source>
        <translation>hier wird ein Komma oder ein schließendes ] erwartet.</translation>
    </message>
    <message>
        <source>a text in double quotes is not well formed; it ends on its own line, and after a \ comes one of &quot; \ / b f n r t u.</source>
        <translation>ein Text in doppelten Anführungszeichen ist nicht richtig gebildet; er endet in seiner eigenen Zeile, und nach einem \ kommt eines von &quot; \ / b f n r t u.</translation>
    </message>
    <message>
        <source>a text has bytes that are not UTF-8; save the file as UTF-8.</source>
        <translation>ein Text enthält Bytes, die nicht UTF-8 sind; speichere die Datei als UTF-8.</translation>
    </message>
    <message>
        <source>a number is too large; the largest is %1.</source>
        <translation>eine Zahl ist zu groß; die größte ist %1.</translation>
    </message>
    <message>
        <source>a number is not complete; write it as 0.5 or 5e-1.</source>
        <translation>eine Zahl ist nicht vollständig; schreibe sie als 0.5 oder 5e-1.</translation>
    </message>
    <message>
        <source>this is not JSON; a value is a number, a &quot;text&quot;, true, false, null, a [list] or an {object}.</source>
        <translation>das ist kein JSON; ein Wert ist eine Zahl, ein &quot;text&quot;, true, false, null, eine [Liste] oder ein {Objekt}.</translation>
    </message>
    <message>
        <source>%1: line %2: there is a zero byte; an experiment is JSON text in UTF-8.</source>
        <translation>%1: Zeile %2: Hier steht ein Null-Byte; ein Experiment ist JSON-Text in UTF-8.</translation>
    </message>
    <message>
        <source>%1: line 1: the file is empty; an experiment begins with {.</source>
        <translation>%1: Zeile 1: Die Datei ist leer; ein Experiment beginnt mit {.</translation>
    </message>
    <message>
        <source>the file ends here, in the middle; its end is missing.</source>
        <translation>die Datei endet hier mittendrin; ihr Ende fehlt.</translation>
    </message>
    <message>
        <source>%1: line %2: %3</source>
        <translation>%1: Zeile %2: %3</translation>
    </message>
</context>
<context>
    <name>JsonFields</name>
    <message>
        <source>%1 is %2; it takes %3.</source>
        <translation>%1 ist %2; verlangt ist %3.</translation>
    </message>
    <message>
        <source>%1: line %2: %3</source>
        <translation>%1: Zeile %2: %3</translation>
    </message>
    <message>
        <source>the text %1</source>
        <translation>der Text %1</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>a text in double quotes</source>
        <translation>ein Text in doppelten Anführungszeichen</translation>
    </message>
    <message>
        <source>a list in [ ]</source>
        <translation>eine Liste in [ ]</translation>
    </message>
    <message>
        <source>%1 is %2; it takes an object in { }.</source>
        <translation>%1 ist %2; verlangt ist ein Objekt in { }.</translation>
    </message>
    <message>
        <source>%1 has no %2; it takes %3.</source>
        <translation>%1 hat kein %2; verlangt ist %3.</translation>
    </message>
    <message>
        <source>%1 has no field %2; there is %3.</source>
        <translation>%1 hat kein Feld %2; es gibt %3.</translation>
    </message>
</context>
<context>
    <name>LessonPlugin</name>
    <message>
        <source>It is not a lesson that can be used: %1.</source>
        <translation>Das ist keine brauchbare Lektion: %1.</translation>
    </message>
    <message>
        <source>It is not a plugin, or it is damaged; install it again, or move it to another folder.</source>
        <translation>Das ist kein Plugin, oder es ist beschädigt; installiere es neu oder verschiebe es in einen anderen Ordner.</translation>
    </message>
    <message>
        <source>It is a lesson for another version of the program (%1, not %2); build it again for this one.</source>
        <translation>Das ist eine Lektion für eine andere Version des Programms (%1, nicht %2); baue sie für diese neu.</translation>
    </message>
    <message>
        <source>It is a plugin of another program (%1); move it to another folder.</source>
        <translation>Das ist ein Plugin eines anderen Programms (%1); verschiebe es in einen anderen Ordner.</translation>
    </message>
    <message>
        <source>its description has no text %1</source>
        <translation>ihre Beschreibung hat keinen Text %1</translation>
    </message>
    <message>
        <source>the id %1 is not made of a to z, 0 to 9 and _</source>
        <translation>die Kennung %1 besteht nicht aus a bis z, 0 bis 9 und _</translation>
    </message>
    <message>
        <source>its description lists no &quot;steps&quot;</source>
        <translation>ihre Beschreibung zählt keine &quot;steps&quot; auf</translation>
    </message>
    <message>
        <source>its description lists a step twice</source>
        <translation>ihre Beschreibung zählt einen Schritt doppelt auf</translation>
    </message>
    <message>
        <source>its description has no whole number &quot;order&quot;</source>
        <translation>ihre Beschreibung hat keine ganze Zahl &quot;order&quot;</translation>
    </message>
    <message>
        <source>the step %1 has no scene or no look</source>
        <translation>der Schritt %1 hat keine Szene oder kein Aussehen</translation>
    </message>
    <message>
        <source>the step %1 wants the method %2, which is not there</source>
        <translation>der Schritt %1 will das Verfahren %2, das es nicht gibt</translation>
    </message>
    <message>
        <source>the step %1 cannot start (%2)</source>
        <translation>der Schritt %1 kann nicht beginnen (%2)</translation>
    </message>
    <message>
        <source>its code has no lesson</source>
        <translation>ihr Code enthält keine Lektion</translation>
    </message>
    <message>
        <source>its steps cannot be made (%1)</source>
        <translation>ihre Schritte lassen sich nicht erstellen (%1)</translation>
    </message>
    <message>
        <source>It cannot be loaded; build or install it again. The system says: %1.</source>
        <translation>Sie lässt sich nicht laden; baue oder installiere sie neu. Das System sagt: %1.</translation>
    </message>
    <message>
        <source>its description lists the steps %1, its code has %2</source>
        <translation>ihre Beschreibung zählt die Schritte %1 auf, ihr Code hat %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>LessonsList</name>
    <message>
        <source>%1; one of %2</source>
        <translation>%1; eines von %2</translation>
    </message>
    <message>
        <source>%1; %2 to %3</source>
        <translation>%1; %2 bis %3</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>order %1</source>
        <translation>Ordnung %1</translation>
    </message>
    <message>
        <source>; needs %1</source>
        <translation>; braucht %1</translation>
    </message>
    <message>
        <source>No lesson was found in %1; SPRINGSTEP_LESSONS can name a folder that has them.</source>
        <translation>In %1 wurde keine Lektion gefunden; SPRINGSTEP_LESSONS kann einen Ordner nennen, in dem welche sind.</translation>
    </message>
</context>
<context>
    <name>ParameterValue</name>
    <message>
        <source>%1 is %2; it can be one of %3.</source>
        <translation>%1 ist %2; möglich ist eines von %3.</translation>
    </message>
    <message>
        <source>%1 is %2; it can be a whole number from %3 to %4.</source>
        <translation>%1 ist %2; möglich ist eine ganze Zahl von %3 bis %4.</translation>
    </message>
    <message>
        <source>%1 is %2; it can be %3 to %4.</source>
        <translation>%1 ist %2; möglich ist %3 bis %4.</translation>
    </message>
</context>
<context>
    <name>PictureFile</name>
    <message>
        <source>%1 cannot be written: %2. Choose another folder or name.</source>
        <translation>%1 lässt sich nicht schreiben: %2. Wähle einen anderen Ordner oder Namen.</translation>
    </message>
</context>
<context>
    <name>Position</name>
    <message>
        <source>step %1 of %2</source>
        <translation>Zeitschritt %1 von %2</translation>
    </message>
    <message>
        <source>%1 of %2 phases done</source>
        <translation>%1 von %2 Phasen getan</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>Frame %1, after %2, %3</source>
        <translation>Bild %1, nach „%2“, %3</translation>
    </message>
</context>
<context>
    <name>PullCard</name>
    <message>
        <source>px/frame²</source>
        <translation>px/Bild²</translation>
    </message>
</context>
<context>
    <name>Quantity</name>
    <message>
        <source>time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>velocity x</source>
        <translation>Geschwindigkeit x</translation>
    </message>
    <message>
        <source>velocity y</source>
        <translation>Geschwindigkeit y</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>acceleration x</source>
        <translation>Beschleunigung x</translation>
    </message>
    <message>
        <source>acceleration y</source>
        <translation>Beschleunigung y</translation>
    </message>
    <message>
        <source>size of acceleration</source>
        <translation>Betrag der Beschleunigung</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>Winkel</translation>
    </message>
    <message>
        <source>turning speed</source>
        <translation>Drehtempo</translation>
    </message>
    <message>
        <source>kinetic energy</source>
        <translation>kinetische Energie</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>kinetic energy of all</source>
        <translation>kinetische Energie von allem</translation>
    </message>
    <message>
        <source>potential energy of all</source>
        <translation>potenzielle Energie von allem</translation>
    </message>
    <message>
        <source>total energy</source>
        <translation>Gesamtenergie</translation>
    </message>
    <message>
        <source>Frames since the start of the run</source>
        <translation>Bilder seit dem Anfang des Laufs</translation>
    </message>
    <message>
        <source>How far to the right it is</source>
        <translation>Wie weit rechts er ist</translation>
    </message>
    <message>
        <source>How far down it is: y grows downwards, in the picture and in plots</source>
        <translation>Wie weit unten er ist: y wächst nach unten, in der Szene und in Kurven</translation>
    </message>
    <message>
        <source>How far it comes to the right in a frame</source>
        <translation>Wie weit er in einem Bild nach rechts kommt</translation>
    </message>
    <message>
        <source>How far it comes down in a frame</source>
        <translation>Wie weit er in einem Bild nach unten kommt</translation>
    </message>
    <message>
        <source>How far it comes in a frame, whichever way</source>
        <translation>Wie weit er in einem Bild kommt, egal wohin</translation>
    </message>
    <message>
        <source>By how much its velocity to the right changed in the last frame</source>
        <translation>Um wie viel sich seine Geschwindigkeit nach rechts im letzten Bild änderte</translation>
    </message>
    <message>
        <source>By how much its velocity downwards changed in the last frame</source>
        <translation>Um wie viel sich seine Geschwindigkeit nach unten im letzten Bild änderte</translation>
    </message>
    <message>
        <source>By how much its velocity changed in the last frame, whichever way</source>
        <translation>Um wie viel sich seine Geschwindigkeit im letzten Bild änderte, egal wohin</translation>
    </message>
    <message>
        <source>Where it points: 0° is to the right, and 90° is down</source>
        <translation>Wohin er zeigt: 0° ist nach rechts, und 90° ist nach unten</translation>
    </message>
    <message>
        <source>By how much its angle changes in a frame</source>
        <translation>Um wie viel sich sein Winkel in einem Bild ändert</translation>
    </message>
    <message>
        <source>Half its mass times the square of its speed</source>
        <translation>Seine halbe Masse mal das Quadrat seines Tempos</translation>
    </message>
    <message>
        <source>How far two bodies are from each other, centre to centre</source>
        <translation>Wie weit zwei Körper voneinander entfernt sind, von Mitte zu Mitte</translation>
    </message>
    <message>
        <source>The energy of motion of everything together</source>
        <translation>Die Bewegungsenergie von allem zusammen</translation>
    </message>
    <message>
        <source>What springs hold, and what lies high</source>
        <translation>Was Federn halten und was in der Höhe liegt</translation>
    </message>
    <message>
        <source>Kinetic and potential energy of everything together</source>
        <translation>Kinetische und potenzielle Energie von allem zusammen</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>px/frame</source>
        <translation>px/Bild</translation>
    </message>
    <message>
        <source>px/frame²</source>
        <translation>px/Bild²</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>degrees/frame</source>
        <translation>Grad/Bild</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 %2 – %3</source>
        <translation>%1 %2 – %3</translation>
    </message>
    <message>
        <source>Nothing here is called %1. The curve comes back with the next step that has one; or choose another body above.</source>
        <translation>Hier heißt nichts %1. Die Kurve kommt mit dem nächsten Schritt zurück, der so etwas hat; oder wähle oben einen anderen Körper.</translation>
    </message>
    <message>
        <source>Something else puts %1 where it goes, so it keeps no velocity. Its position can be plotted: choose that above.</source>
        <translation>Etwas anderes setzt %1 dorthin, wo es hingehört, darum gibt es keine eigene Geschwindigkeit. Die Position hat eine Kurve: Wähle sie oben.</translation>
    </message>
    <message>
        <source>What this scene moves are points: they have no angle. Branches of a tree have one.</source>
        <translation>Was diese Szene bewegt, sind Punkte: Sie haben keinen Winkel. Zweige eines Baums haben einen.</translation>
    </message>
</context>
<context>
    <name>ReferenceMarks</name>
    <message>
        <source>%1 off the reference here</source>
        <translation>%1 neben der Referenz hier</translation>
    </message>
</context>
<context>
    <name>RestWords</name>
    <message>
        <source>Everything rests: a frame costs nothing until something is touched.</source>
        <translation>Alles ruht: Ein Bild kostet nichts, bis etwas berührt wird.</translation>
    </message>
    <message>
        <source>Nothing rests now: “%1” changes with the time.</source>
        <translation>Jetzt ruht nichts: „%1“ ändert sich mit der Zeit.</translation>
    </message>
    <message>
        <source>With a method that chooses its own steps, what rests costs as much as what moves.</source>
        <translation>Bei einem Verfahren, das seine Zeitschritte selbst wählt, kostet das Ruhende so viel wie das Bewegte.</translation>
    </message>
    <message>
        <source>What comes to rest costs nothing until it is touched.</source>
        <translation>Was zur Ruhe kommt, kostet nichts, bis es berührt wird.</translation>
    </message>
</context>
<context>
    <name>Ruler</name>
    <message>
        <source>%1&#x2009;px, %2°</source>
        <translation>%1&#x2009;px, %2°</translation>
    </message>
</context>
<context>
    <name>SceneOverlay</name>
    <message>
        <source>%1&#x2009;px</source>
        <translation>%1&#x2009;px</translation>
    </message>
    <message>
        <source>your method</source>
        <translation>dein Verfahren</translation>
    </message>
    <message>
        <source>reference, ±%1</source>
        <translation>Referenz, ±%1</translation>
    </message>
    <message>
        <source>every %1 frames</source>
        <translation>alle %1 Bilder</translation>
    </message>
    <message>
        <source>velocity of %1&#x2009;px/frame</source>
        <translation>Geschwindigkeit von %1&#x2009;px/Bild</translation>
    </message>
    <message>
        <source>pull of %1&#x2009;px/frame²</source>
        <translation>Zug von %1&#x2009;px/Bild²</translation>
    </message>
    <message>
        <source>%1 (before: %2)</source>
        <translation>%1 (vorher: %2)</translation>
    </message>
    <message>
        <source>sum so far</source>
        <translation>Summe bisher</translation>
    </message>
    <message>
        <source>sum of all pulls</source>
        <translation>Summe aller Züge</translation>
    </message>
    <message>
        <source>length at rest</source>
        <translation>Länge in Ruhe</translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source>The step %1 does not fit: it can be 1 divided by a whole number, or a whole number, from 0.000001 to 100 frames.</source>
        <translation>Der Zeitschritt %1 passt nicht: Möglich ist 1 geteilt durch eine ganze Zahl oder eine ganze Zahl, von 0.000001 bis 100 Bildern.</translation>
    </message>
    <message>
        <source>The tolerance %1 does not fit: it can be from 1e-13 to 100 px.</source>
        <translation>Die Toleranz %1 passt nicht: Möglich ist 1e-13 bis 100 px.</translation>
    </message>
    <message>
        <source>The method %1 chooses its steps itself: give it a tolerance in px in place of a step.</source>
        <translation>Das Verfahren „%1“ wählt seine Zeitschritte selbst: Gib ihm eine Toleranz in px statt eines Zeitschritts.</translation>
    </message>
    <message>
        <source>The method %1 takes steps of one length: give it a step in frames in place of a tolerance.</source>
        <translation>Das Verfahren „%1“ macht Zeitschritte von einer Länge: Gib ihm einen Zeitschritt in Bildern statt einer Toleranz.</translation>
    </message>
    <message>
        <source>%1 acts once a step, so that smaller steps make another motion from the first frame on.</source>
        <translation>„%1“ wirkt einmal pro Zeitschritt, sodass kleinere Zeitschritte vom ersten Bild an eine andere Bewegung ergeben.</translation>
    </message>
    <message>
        <source>There is nothing to compare with after frame %1.</source>
        <translation>Nach Bild %1 gibt es nichts, womit man vergleichen könnte.</translation>
    </message>
    <message>
        <source>The method %1 cannot compute %2: choose another method, or switch that effect off.</source>
        <translation>Das Verfahren „%1“ kann „%2“ nicht berechnen: Wähle ein anderes Verfahren oder schalte diesen Effekt aus.</translation>
    </message>
    <message>
        <source>The method %1 cannot compute this scene: parts of it go only where they are put, and have no velocity. Choose another method.</source>
        <translation>Das Verfahren „%1“ kann diese Szene nicht berechnen: Teile von ihr gehen nur dorthin, wo man sie hinsetzt, und haben keine Geschwindigkeit. Wähle ein anderes Verfahren.</translation>
    </message>
    <message>
        <source>Nothing in this scene can move: leave at least one body free.</source>
        <translation>In dieser Szene kann sich nichts bewegen: Lass mindestens einen Körper frei.</translation>
    </message>
    <message>
        <source>This scene has %1 points. Up to %2 are computed with every method: what a few of them tell about methods holds for more of the same.</source>
        <translation>Diese Szene hat %1 Punkte. Bis zu %2 werden mit jedem Verfahren berechnet: Was wenige von ihnen über Verfahren sagen, gilt auch für mehr davon.</translation>
    </message>
    <message>
        <source>This tree would have more than %1 branches: make its slope smaller than %2, or its smallest branch larger than %3.</source>
        <translation>Dieser Baum hätte mehr als %1 Zweige: Mach seine Verjüngung kleiner als %2 oder seinen kleinsten Zweig größer als %3.</translation>
    </message>
    <message>
        <source>Stick %1 ends at p%2, and there is no such point: there are %3, and the first is p0.</source>
        <translation>Stab %1 endet bei p%2, und diesen Punkt gibt es nicht: Es sind %3, und der erste ist p0.</translation>
    </message>
    <message>
        <source>The event %1 before frame %2 has a number that is infinite or none at all: give it a finite one.</source>
        <translation>Das Ereignis %1 vor Bild %2 hat eine Zahl, die unendlich oder gar keine ist: Gib ihm eine endliche.</translation>
    </message>
    <message>
        <source>The start of %1 has a number that is infinite or none at all: give it a finite one.</source>
        <translation>Der Start von %1 hat eine Zahl, die unendlich oder gar keine ist: Gib ihm eine endliche.</translation>
    </message>
    <message>
        <source>This does not fit together: %1.</source>
        <translation>Das passt nicht zusammen: %1.</translation>
    </message>
    <message>
        <source>The spring of %1</source>
        <translation>Die Feder von %1</translation>
    </message>
    <message>
        <source>What pulls %1 (%2)</source>
        <translation>Was an %1 zieht (%2)</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>The spring %1</source>
        <translation>Die Feder %1</translation>
    </message>
    <message>
        <source>Stopped at frame %1: the method needs too many steps for the next one.</source>
        <translation>Angehalten bei Bild %1: Für das nächste braucht das Verfahren zu viele Zeitschritte.</translation>
    </message>
    <message>
        <source>%1 pulls hardest.</source>
        <translation>%1 zieht am stärksten.</translation>
    </message>
    <message>
        <source>What is pulled hardest is %1.</source>
        <translation>Am stärksten gezogen wird %1.</translation>
    </message>
    <message>
        <source>Try a larger tolerance, or a method whose steps all have one length.</source>
        <translation>Versuch es mit einer größeren Toleranz oder mit einem Verfahren, dessen Zeitschritte alle gleich lang sind.</translation>
    </message>
    <message>
        <source>Stopped at frame %1: in the next one a number is not finite.</source>
        <translation>Angehalten bei Bild %1: Im nächsten ist eine Zahl nicht endlich.</translation>
    </message>
    <message>
        <source>Stopped at frame %1: in the next one “%2” is too far or too fast for any number (not finite).</source>
        <translation>Angehalten bei Bild %1: Im nächsten ist „%2“ zu weit weg oder zu schnell für jede Zahl (nicht endlich).</translation>
    </message>
    <message>
        <source>It began in “%1”.</source>
        <translation>Begonnen hat es in „%1“.</translation>
    </message>
    <message>
        <source>Spring %1 ends at p%2, and there is no such point: there are %3, and the first is p0.</source>
        <translation>Feder %1 endet bei p%2, und diesen Punkt gibt es nicht: Es sind %3, und der erste ist p0.</translation>
    </message>
</context>
<context>
    <name>StabilityWords</name>
    <message>
        <source>%1 × the limit</source>
        <translation>%1 × die Grenze</translation>
    </message>
    <message>
        <source>%1&#x2009;% of the limit</source>
        <translation>%1&#x2009;% der Grenze</translation>
    </message>
    <message>
        <source>%1&#x2009;frames</source>
        <translation>%1&#x2009;Bilder</translation>
    </message>
    <message>
        <source>%1 decides it.</source>
        <translation>%1 entscheidet das.</translation>
    </message>
    <message>
        <source>Past the limit it swings to the other side at each step, farther each time.</source>
        <translation>Jenseits der Grenze schwingt es bei jedem Zeitschritt auf die andere Seite, jedes Mal weiter.</translation>
    </message>
    <message>
        <source>Past the limit it swings wider and wider.</source>
        <translation>Jenseits der Grenze schwingt es weiter und weiter.</translation>
    </message>
    <message>
        <source>Past the limit all of it drifts off, faster and faster: one end moves before the other does, so their pulls do not cancel.</source>
        <translation>Jenseits der Grenze treibt alles davon, schneller und schneller: Ein Ende bewegt sich vor dem anderen, darum heben sich ihre Züge nicht auf.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Damping holds every step.&lt;/b&gt; However long, nothing swings up here.</source>
        <translation>&lt;b&gt;Die Dämpfung hält jeden Zeitschritt.&lt;/b&gt; Wie lang er auch ist, hier schaukelt sich nichts auf.</translation>
    </message>
    <message>
        <source>&lt;b&gt;No step holds.&lt;/b&gt; This one is so short that growth is too slow to tell.</source>
        <translation>&lt;b&gt;Kein Zeitschritt hält.&lt;/b&gt; Dieser ist so kurz, dass das Wachsen zu langsam ist, um es zu sehen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;No shorter step holds.&lt;/b&gt; Damping holds one as long as this.</source>
        <translation>&lt;b&gt;Kein kürzerer Zeitschritt hält.&lt;/b&gt; Einen so langen wie diesen hält die Dämpfung.</translation>
    </message>
    <message>
        <source>&lt;b&gt;No step holds.&lt;/b&gt; With this method and so little damping, small disturbances %1, and at any shorter step they still grow.</source>
        <translation>&lt;b&gt;Kein Zeitschritt hält.&lt;/b&gt; Kleine Störungen %1 mit diesem Verfahren und so wenig Dämpfung, und auch bei jedem kürzeren Zeitschritt wachsen sie.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1, and held all the same.&lt;/b&gt; From %2 on steps are too long, but damping holds one as long as this.</source>
        <translation>&lt;b&gt;%1, und trotzdem gehalten.&lt;/b&gt; Ab %2 sind Zeitschritte zu lang, aber einen so langen wie diesen hält die Dämpfung.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1.&lt;/b&gt; Small disturbances %2. Steps up to %3 hold.</source>
        <translation>&lt;b&gt;%1.&lt;/b&gt; Kleine Störungen %2. Zeitschritte bis %3 halten.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1.&lt;/b&gt; Steps up to %2 hold here.</source>
        <translation>&lt;b&gt;%1.&lt;/b&gt; Zeitschritte bis %2 halten hier.</translation>
    </message>
    <message>
        <source>grow more than a million times a frame</source>
        <translation>wachsen auf mehr als das Millionenfache pro Bild</translation>
    </message>
    <message>
        <source>grow by %1&#x2009;% a frame</source>
        <translation>wachsen um %1&#x2009;% pro Bild</translation>
    </message>
    <message>
        <source>grow %1 times a frame</source>
        <translation>wachsen auf das %1-Fache pro Bild</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>keine Grenze</translation>
    </message>
    <message>
        <source>by its tolerance</source>
        <translation>durch seine Toleranz</translation>
    </message>
    <message>
        <source>no springs act</source>
        <translation>keine Feder wirkt</translation>
    </message>
    <message>
        <source>not known here</source>
        <translation>hier nicht bekannt</translation>
    </message>
    <message>
        <source>too many points</source>
        <translation>zu viele Punkte</translation>
    </message>
    <message>
        <source>held by damping</source>
        <translation>durch Dämpfung gehalten</translation>
    </message>
    <message>
        <source>just held</source>
        <translation>gerade noch gehalten</translation>
    </message>
    <message>
        <source>no step holds</source>
        <translation>kein Zeitschritt hält</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 has no such limit.&lt;/b&gt; A long step stays bounded however stiff the springs; it is only less exact. How exact it should be bounds the step.</source>
        <translation>&lt;b&gt;„%1“ hat keine solche Grenze.&lt;/b&gt; Ein langer Zeitschritt bleibt beschränkt, wie steif die Federn auch sind; er ist nur weniger genau. Wie genau es sein soll, begrenzt den Zeitschritt.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 keeps its own steps short enough.&lt;/b&gt; Its tolerance, %2, bounds them.</source>
        <translation>&lt;b&gt;„%1“ hält seine Zeitschritte selbst kurz genug.&lt;/b&gt; Seine Toleranz, %2, begrenzt sie.</translation>
    </message>
    <message>
        <source>&lt;b&gt;No springs act here.&lt;/b&gt; What acts has no stiffness, so no step is too long for it.</source>
        <translation>&lt;b&gt;Hier wirkt keine Feder.&lt;/b&gt; Was wirkt, hat keine Steifigkeit, also ist kein Zeitschritt dafür zu lang.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Not known here.&lt;/b&gt; The pulls in this state are no finite numbers.</source>
        <translation>&lt;b&gt;Hier nicht bekannt.&lt;/b&gt; Die Züge in diesem Zustand sind keine endlichen Zahlen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Too many points.&lt;/b&gt; With more than %1 of them it would take too long to find the stiffest swing. Where nobody feels anybody, a few of them tell it for all.</source>
        <translation>&lt;b&gt;Zu viele Punkte.&lt;/b&gt; Bei mehr als %1 davon würde es zu lange dauern, die steifste Schwingung zu finden. Wo niemand jemanden spürt, sagen wenige es für alle.</translation>
    </message>
    <message>
        <source>Not part of this: %1. They act by jumps, once a step, and have no stiffness.</source>
        <translation>Nicht Teil davon: %1. Sie wirken in Sprüngen, einmal pro Zeitschritt, und haben keine Steifigkeit.</translation>
    </message>
    <message>
        <source>%1 Sticks that bear weight err less by smaller steps than by more passes.</source>
        <translation>%1 Stäbe, die Gewicht tragen, werden durch kleinere Zeitschritte genauer als durch mehr Durchgänge.</translation>
    </message>
    <message>
        <source>Use a &amp;step of %1</source>
        <translation>Zeit&amp;schritt %1 nehmen</translation>
    </message>
    <message>
        <source>Use a &amp;tolerance of %1</source>
        <translation>&amp;Toleranz %1 nehmen</translation>
    </message>
    <message>
        <source>&amp;Damp more: %1 %2</source>
        <translation>Mehr &amp;dämpfen: %1 %2</translation>
    </message>
    <message>
        <source>&amp;Use %1</source>
        <translation>%1 &amp;nehmen</translation>
    </message>
    <message>
        <source>then at %1</source>
        <translation>dann bei %1</translation>
    </message>
    <message>
        <source>keeps its own steps</source>
        <translation>hält seine Zeitschritte selbst kurz</translation>
    </message>
    <message>
        <source>has no such limit</source>
        <translation>hat keine solche Grenze</translation>
    </message>
    <message>
        <source>&lt;b&gt;Sticks fit.&lt;/b&gt; None was more than %1&#x2009;px wrong in the last %2 frames.</source>
        <translation>&lt;b&gt;Die Stäbe passen.&lt;/b&gt; Keiner war in den letzten %2 Bildern mehr als %1&#x2009;px falsch.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Sticks are up to %1&#x2009;px too long:&lt;/b&gt; %2 – %3 in the last %4 frames.</source>
        <translation>&lt;b&gt;Stäbe sind bis zu %1&#x2009;px zu lang:&lt;/b&gt; %2 – %3 in den letzten %4 Bildern.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Sticks are up to %1&#x2009;px too short:&lt;/b&gt; %2 – %3 in the last %4 frames.</source>
        <translation>&lt;b&gt;Stäbe sind bis zu %1&#x2009;px zu kurz:&lt;/b&gt; %2 – %3 in den letzten %4 Bildern.</translation>
    </message>
    <message>
        <source>%1 Neither shorter steps nor more passes make that half as much: perhaps they cannot all have their lengths at once.</source>
        <translation>%1 Weder kürzere Zeitschritte noch mehr Durchgänge machen es halb so schlimm: Vielleicht können nicht alle zugleich ihre Länge haben.</translation>
    </message>
    <message numerus="yes">
        <source>Use %n &amp;passes</source>
        <translation>
            <numerusform>%n Du&amp;rchgang nehmen</numerusform>
            <numerusform>%n Du&amp;rchgänge nehmen</numerusform>
        </translation>
    </message>
    <message>
        <source>then sticks are up to %1&#x2009;px wrong</source>
        <translation>dann sind Stäbe bis zu %1&#x2009;px falsch</translation>
    </message>
    <message>
        <source>then damping holds every step</source>
        <translation>dann hält die Dämpfung jeden Zeitschritt</translation>
    </message>
</context>
<context>
    <name>StepWords</name>
    <message>
        <source>1/%1 frame</source>
        <translation>1/%1 Bild</translation>
    </message>
    <message>
        <source>1 frame</source>
        <translation>1 Bild</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 Bilder</translation>
    </message>
    <message>
        <source>%1&#x2009;px</source>
        <translation>%1&#x2009;px</translation>
    </message>
</context>
<context>
    <name>Terminal</name>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>springstep: there is not enough memory for this; close other programs, or give it a smaller experiment.</source>
        <translation>springstep: Der Speicher reicht nicht; schließe andere Programme, oder gib ein kleineres Experiment an.</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Abgebrochen: %1</translation>
    </message>
    <message>
        <source>%1… %2 s</source>
        <translation>%1 … %2 s</translation>
    </message>
</context>
<context>
    <name>Text</name>
    <message>
        <source>Measured %1 %</source>
        <translation>%1 % gemessen</translation>
    </message>
    <message>
        <source>Measured %1 times</source>
        <translation>%1-mal gemessen</translation>
    </message>
    <message>
        <source>--%1 is %2; it can be a whole number from 0 to %3.</source>
        <translation>--%1 ist %2; möglich ist eine ganze Zahl von 0 bis %3.</translation>
    </message>
    <message>
        <source>&quot;h&quot; is %1; it can be 0.000001 to 100 frames, a whole number or 1 divided by one: 2, 1, 0.5, 0.25...</source>
        <translation>&quot;h&quot; ist %1; möglich ist 0.000001 bis 100 Bilder, eine ganze Zahl oder 1 geteilt durch eine: 2, 1, 0.5, 0.25 ...</translation>
    </message>
    <message>
        <source>&quot;tolerance&quot; is %1; it can be 1e-13 to 100 px.</source>
        <translation>&quot;tolerance&quot; ist %1; möglich ist 1e-13 bis 100 px.</translation>
    </message>
    <message>
        <source>%1 is %2; it can be a whole number from %3 to %4.</source>
        <translation>%1 ist %2; möglich ist eine ganze Zahl von %3 bis %4.</translation>
    </message>
    <message>
        <source>beyond 2^53</source>
        <translation>mehr als 2^53</translation>
    </message>
    <message>
        <source>the step %1 has no parameter %2; it has %3.</source>
        <translation>der Schritt %1 hat keinen Parameter %2; er hat %3.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>Trace</name>
    <message>
        <source>The rows cannot be written: %1. Make room, or write to another place.</source>
        <translation>Die Zeilen lassen sich nicht schreiben: %1. Schaffe Platz oder schreibe an einen anderen Ort.</translation>
    </message>
    <message>
        <source>Stopped at frame %1 of %2.</source>
        <translation>Angehalten bei Bild %1 von %2.</translation>
    </message>
    <message>
        <source>Setting up the run</source>
        <translation>Bereitet den Lauf vor</translation>
    </message>
</context>
<context>
    <name>WebmFile</name>
    <message>
        <source>%1 cannot be written: %2. Make room, or choose another folder.</source>
        <translation>%1 lässt sich nicht schreiben: %2. Schaffe Platz oder wähle einen anderen Ordner.</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
</context>
<context>
    <name>Workshop</name>
    <message>
        <source>This is your own copy of the scene: change what you like.</source>
        <translation>Das ist deine eigene Kopie der Szene: Ändere, was du magst.</translation>
    </message>
    <message>
        <source>This is your own copy of the scene. What could not be taken along: %1.</source>
        <translation>Das ist deine eigene Kopie der Szene. Was nicht mitkommen konnte: %1.</translation>
    </message>
    <message>
        <source>This scene has %1 points; one that you build can have %2.</source>
        <translation>Diese Szene hat %1 Punkte; eine, die du baust, kann %2 haben.</translation>
    </message>
    <message>
        <source>This scene cannot be built from points: its branches turn in their joints. Take another one, or open the sandbox and look at its examples.</source>
        <translation>Diese Szene lässt sich nicht aus Punkten bauen: Ihre Zweige drehen sich in ihren Gelenken. Nimm eine andere, oder öffne den Sandkasten und sieh dir seine Beispiele an.</translation>
    </message>
    <message>
        <source>This scene has flown apart: a point is farther away than %1 px, or that fast. Go back in time, and take it from there.</source>
        <translation>Diese Szene ist auseinandergeflogen: Ein Punkt ist weiter weg als %1 px oder so schnell. Geh in der Zeit zurück und nimm sie von dort.</translation>
    </message>
    <message>
        <source>Building happens at the start of the run: press Home to go there.</source>
        <translation>Gebaut wird am Anfang des Laufs: Drück Pos1, um dorthin zu gehen.</translation>
    </message>
    <message>
        <source>the order in which points move (%1), as here all move at once</source>
        <translation>die Reihenfolge, in der sich Punkte bewegen (%1), denn hier bewegen sich alle zugleich</translation>
    </message>
    <message>
        <source>Take over scene</source>
        <translation>Szene übernehmen</translation>
    </message>
    <message>
        <source>Open example %1</source>
        <translation>Beispiel %1 öffnen</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Start new scene</source>
        <translation>Neue Szene beginnen</translation>
    </message>
    <message>
        <source>A new scene has one point: the least that a scene can have. Move it, or build on from it.</source>
        <translation>Eine neue Szene hat einen Punkt: Weniger geht nicht. Verschieb ihn oder bau von ihm aus weiter.</translation>
    </message>
</context>
<context>
    <name>app::AboutPage</name>
    <message>
        <source>windows and files</source>
        <translation>Fenster und Dateien</translation>
    </message>
    <message>
        <source>plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>the code panel</source>
        <translation>Codebereich</translation>
    </message>
    <message>
        <source>arrays of numbers</source>
        <translation>Zahlenfelder</translation>
    </message>
    <message>
        <source>reading experiments</source>
        <translation>Lesen von Experimenten</translation>
    </message>
    <message>
        <source>films as GIF</source>
        <translation>Filme als GIF</translation>
    </message>
    <message>
        <source>experiments as short text</source>
        <translation>Experimente als kurzer Text</translation>
    </message>
    <message>
        <source>typeface of the window</source>
        <translation>Schrift des Fensters</translation>
    </message>
    <message>
        <source>typeface of code and numbers</source>
        <translation>Schrift für Code und Zahlen</translation>
    </message>
    <message>
        <source>About Springstep</source>
        <translation>Über Springstep</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>Teaches physically based animation step by step, from one spring to creatures that walk.</source>
        <translation>Lehrt physikbasierte Animation Schritt für Schritt, von einer Feder bis zu Wesen, die laufen.</translation>
    </message>
    <message>
        <source>You may use, change and share it under the &lt;a href=&quot;%1&quot;&gt;GNU General Public License, version 3&lt;/a&gt;. It comes without any warranty.</source>
        <translation>Du darfst es nutzen, ändern und weitergeben, nach der &lt;a href=&quot;%1&quot;&gt;GNU General Public License, Version 3&lt;/a&gt;. Es kommt ohne jede Gewährleistung.</translation>
    </message>
    <message>
        <source>Built with</source>
        <translation>Gebaut mit</translation>
    </message>
    <message>
        <source>%1: %2. Licence: %3</source>
        <translation>%1: %2. Lizenz: %3</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>Diese Seite schließen (Esc)</translation>
    </message>
</context>
<context>
    <name>app::AccuracyPanel</name>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Error against time</source>
        <translation>Fehler und Zeit</translation>
    </message>
    <message>
        <source>How far off each method is, and what it costs</source>
        <translation>Wie weit jedes Verfahren abweicht und was es kostet</translation>
    </message>
    <message>
        <source>Over the run</source>
        <translation>Im Lauf</translation>
    </message>
    <message>
        <source>How the error grows, at about the cost of your method</source>
        <translation>Wie der Fehler wächst, zu etwa den Kosten deines Verfahrens</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordnung</translation>
    </message>
    <message>
        <source>How fast the error shrinks when the step does</source>
        <translation>Wie schnell der Fehler mit dem Zeitschritt schrumpft</translation>
    </message>
    <message>
        <source>How far the measurement is</source>
        <translation>Wie weit die Messung ist</translation>
    </message>
    <message>
        <source>Use it</source>
        <translation>Verwenden</translation>
    </message>
    <message>
        <source>first %1 frames of %2</source>
        <translation>die ersten %1 Bilder von %2</translation>
    </message>
    <message>
        <source>%1 frames, %2 methods</source>
        <translation>%1 Bilder, %2 Verfahren</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Neu messen</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messen</translation>
    </message>
    <message>
        <source>Stop; what was measured until now stays</source>
        <translation>Anhalten; was bis jetzt gemessen ist, bleibt</translation>
    </message>
    <message>
        <source>Compute the scene with every method, and time it</source>
        <translation>Die Szene mit jedem Verfahren berechnen und die Zeit messen</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Messung läuft …</translation>
    </message>
    <message>
        <source>Times are medians of repeated, interleaved runs; whiskers show their spread.</source>
        <translation>Zeiten sind Mediane wiederholter, verschränkter Läufe; die Striche zeigen ihre Streuung.</translation>
    </message>
    <message>
        <source>Cancelled. What was measured until then is shown.</source>
        <translation>Abgebrochen. Gezeigt wird, was bis dahin gemessen war.</translation>
    </message>
    <message>
        <source>The scene has changed. It is measured as soon as it stays the same.</source>
        <translation>Die Szene hat sich geändert. Gemessen wird, sobald sie gleich bleibt.</translation>
    </message>
    <message>
        <source>Not measured yet.</source>
        <translation>Noch nicht gemessen.</translation>
    </message>
    <message>
        <source>How far off is each way of computing this scene, and what does it cost? Every method runs it at many steps, against a reference that is far more exact.</source>
        <translation>Wie weit weicht jede Art, diese Szene zu berechnen, ab, und was kostet sie? Jedes Verfahren rechnet sie mit vielen Zeitschritten, gegen eine Referenz, die weit genauer ist.</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>%1 verwenden</translation>
    </message>
    <message>
        <source>%1 frames, %2 of %3 methods</source>
        <translation>%1 Bilder, %2 von %3 Verfahren</translation>
    </message>
    <message>
        <source>Show fewer methods</source>
        <translation>Weniger Verfahren zeigen</translation>
    </message>
    <message>
        <source>Show all methods</source>
        <translation>Alle Verfahren zeigen</translation>
    </message>
    <message>
        <source>Only the method of this step and the two that tell most beside it</source>
        <translation>Nur das Verfahren dieses Schritts und die zwei, die daneben am meisten sagen</translation>
    </message>
    <message>
        <source>Every method that was measured, two more plots of them, and remarks</source>
        <translation>Jedes gemessene Verfahren, zwei weitere Diagramme davon, und Anmerkungen</translation>
    </message>
</context>
<context>
    <name>app::ArrangeMenu</name>
    <message>
        <source>Drag this panel to where it is to stand</source>
        <translation>Zieh diese Leiste dorthin, wo sie stehen soll</translation>
    </message>
    <message>
        <source>A&amp;rrange panels</source>
        <translation>Leisten &amp;verschieben</translation>
    </message>
    <message>
        <source>&amp;Unlock: panels can be moved</source>
        <translation>&amp;Entsperren: Leisten lassen sich verschieben</translation>
    </message>
    <message>
        <source>Drag a panel by its title to where it is to stand</source>
        <translation>Zieh eine Leiste an ihrem Titel dorthin, wo sie stehen soll</translation>
    </message>
    <message>
        <source>As &amp;at first</source>
        <translation>Wie am &amp;Anfang</translation>
    </message>
    <message>
        <source>Puts the panels back to where they stood at first, in this preset alone</source>
        <translation>Stellt die Leisten zurück, wie sie am Anfang standen, nur in dieser Anordnung</translation>
    </message>
    <message>
        <source>to the &amp;left</source>
        <translation>nach &amp;links</translation>
    </message>
    <message>
        <source>to the &amp;right</source>
        <translation>nach &amp;rechts</translation>
    </message>
    <message>
        <source>&amp;below the picture</source>
        <translation>&amp;unter das Bild</translation>
    </message>
</context>
<context>
    <name>app::Attempts</name>
    <message>
        <source>stop here: press **Space**.</source>
        <translation>halte hier an: Drück die **Leertaste**.</translation>
    </message>
    <message>
        <source>it is too far off, or a frame takes too long. Try another method or step.</source>
        <translation>es ist zu weit daneben, oder ein Bild dauert zu lang. Versuche ein anderes Verfahren oder einen anderen Zeitschritt.</translation>
    </message>
</context>
<context>
    <name>app::BranchesPanel</name>
    <message>
        <source>Two runs</source>
        <translation>Zwei Läufe</translation>
    </message>
    <message>
        <source>Farthest off</source>
        <translation>Am weitesten weg</translation>
    </message>
    <message>
        <source>At each frame the body that is farthest from where it is in the other run</source>
        <translation>Bei jedem Bild der Körper, der am weitesten von seinem Ort im anderen Lauf entfernt ist</translation>
    </message>
    <message>
        <source>Only the body that is chosen in the picture</source>
        <translation>Nur der Körper, der in der Szene gewählt ist</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Läufe</translation>
    </message>
    <message>
        <source>Choose the run to compare with, keep, name and delete runs</source>
        <translation>Den Lauf zum Vergleichen wählen; Läufe behalten, benennen und löschen</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Hingehen</translation>
    </message>
    <message>
        <source>Go to the frame with the largest difference</source>
        <translation>Zum Bild mit dem größten Unterschied gehen</translation>
    </message>
    <message>
        <source>this one and “%1”</source>
        <translation>dieser und „%1“</translation>
    </message>
</context>
<context>
    <name>app::BuildGuide</name>
    <message>
        <source>The point in the picture is the body of your creature. Press Foot (F) to give it feet.</source>
        <translation>Der Punkt im Bild ist der Körper deines Wesens. Drück Fuß (F), um ihm Füße zu geben.</translation>
    </message>
    <message>
        <source>Click the body.</source>
        <translation>Klick auf den Körper.</translation>
    </message>
    <message>
        <source>Click the cross on the left: the first foot.</source>
        <translation>Klick auf das Kreuz links: Das wird der erste Fuß.</translation>
    </message>
    <message>
        <source>Click the cross on the right. Opposite feet need opposite angles: one 0°, the other 180°.</source>
        <translation>Klick auf das Kreuz rechts. Füße, die sich gegenüberstehen, brauchen gegenüberliegende Winkel: einer 0°, der andere 180°.</translation>
    </message>
    <message>
        <source>Two feet must be opposite each other. Click the cross on the right.</source>
        <translation>Zwei Füße müssen sich gegenüberstehen. Klick auf das Kreuz rechts.</translation>
    </message>
    <message>
        <source>Now the numbers of the feet. Press Choose (V).</source>
        <translation>Nun die Zahlen der Füße. Drück Wählen (V).</translation>
    </message>
    <message>
        <source>Click one of the feet.</source>
        <translation>Klick auf einen der Füße.</translation>
    </message>
    <message>
        <source>Swing makes it walk: it turns the legs. Type 0.05 into the field Swing, and press Return.</source>
        <translation>Schwung lässt es gehen: Er dreht die Beine. Gib 0,05 in das Feld Schwung ein und drück die Eingabetaste.</translation>
    </message>
    <message>
        <source>Feet need something to push against. Switch Ground on.</source>
        <translation>Füße müssen sich von etwas abstoßen. Schalte Boden ein.</translation>
    </message>
    <message>
        <source>Switch Walls off, so that nothing is in the way.</source>
        <translation>Schalte Wände aus, damit nichts im Weg ist.</translation>
    </message>
    <message>
        <source>Press Play (Space).</source>
        <translation>Drück Abspielen (Leertaste).</translation>
    </message>
    <message>
        <source>Watch it: it lands, and then its feet push it along.</source>
        <translation>Schau zu: Es landet, und dann schieben es seine Füße voran.</translation>
    </message>
    <message>
        <source>It does not walk yet. Press Home, and make Swing 0.05.</source>
        <translation>Es geht noch nicht. Drück Pos1 und stell Schwung auf 0,05.</translation>
    </message>
    <message>
        <source>It walks! Press Home to change it: another Swing, a third foot, or a heavier body.</source>
        <translation>Es geht! Drück Pos1, um es zu ändern: ein anderer Schwung, ein dritter Fuß oder ein schwererer Körper.</translation>
    </message>
</context>
<context>
    <name>app::BuildPanel</name>
    <message>
        <source>Build</source>
        <translation>Bauen</translation>
    </message>
    <message>
        <source>Go to the start</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>Go to frame 0, where the scene can be changed (Home)</source>
        <translation>Zu Bild 0 gehen, wo sich die Szene ändern lässt (Pos1)</translation>
    </message>
    <message>
        <source>Acts on everything</source>
        <translation>Wirkt auf alles</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Ten scenes to start from; undo brings yours back</source>
        <translation>Zehn Szenen als Anfang; Rückgängig bringt deine zurück</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>A scene with one point; undo brings yours back</source>
        <translation>Eine Szene mit einem Punkt; Rückgängig bringt deine zurück</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Back to the lessons; what you built stays here (F5)</source>
        <translation>Zurück zu den Lektionen; was du gebaut hast, bleibt hier (F5)</translation>
    </message>
    <message>
        <source>points %1, links %2</source>
        <translation>Punkte %1, Verbindungen %2</translation>
    </message>
    <message>
        <source>The scene plays. Building happens at the start of the run.</source>
        <translation>Die Szene läuft. Gebaut wird am Anfang des Laufs.</translation>
    </message>
    <message>
        <source>You are at frame %1. Building happens at the start of the run.</source>
        <translation>Du bist bei Bild %1. Gebaut wird am Anfang des Laufs.</translation>
    </message>
    <message>
        <source>Click where a point shall be.</source>
        <translation>Klicke dorthin, wo ein Punkt sein soll.</translation>
    </message>
    <message>
        <source>Click a point to nail it down or to free it, or where a nail shall be.</source>
        <translation>Klicke auf einen Punkt, um ihn festzunageln oder zu lösen, oder dorthin, wo ein Nagel sein soll.</translation>
    </message>
    <message>
        <source>Click a part to choose it, drag it to move it, or draw a box round several.</source>
        <translation>Klicke auf ein Teil, um es zu wählen, zieh es, um es zu verschieben, oder zieh einen Rahmen um mehrere.</translation>
    </message>
    <message>
        <source>New gait group</source>
        <translation>Neue Ganggruppe</translation>
    </message>
    <message>
        <source>Gives this foot a gait group of its own, with a clock of its own</source>
        <translation>Gibt diesem Fuß eine eigene Ganggruppe mit eigener Uhr</translation>
    </message>
    <message>
        <source>Click where it ends; the next goes on from there. Esc: begin elsewhere.</source>
        <translation>Klicke, wo das andere Ende hinkommt; von dort geht es weiter. Esc: woanders beginnen.</translation>
    </message>
    <message>
        <source>Click each of its feet, or where one shall be. Esc: another body.</source>
        <translation>Klicke auf jeden seiner Füße oder dorthin, wo einer sein soll. Esc: ein anderer Körper.</translation>
    </message>
    <message>
        <source>Click a body, then each of its feet, or where one shall be.</source>
        <translation>Klicke auf einen Körper, dann auf jeden seiner Füße oder dorthin, wo einer sein soll.</translation>
    </message>
    <message>
        <source>First build: a walker</source>
        <translation>Erstes Bauen: ein Läufer</translation>
    </message>
    <message>
        <source>Build a creature that walks, in ten clicks. It begins with a new scene; undo brings yours back</source>
        <translation>Bau mit zehn Klicks ein Wesen, das geht. Es beginnt mit einer neuen Szene; Rückgängig bringt deine zurück</translation>
    </message>
    <message>
        <source>Drag from one point to another: that makes one spring. With clicks, each spring goes on from the last.</source>
        <translation>Zieh von einem Punkt zum anderen: Das macht eine Feder. Mit Klicks geht jede Feder von der letzten aus weiter.</translation>
    </message>
    <message>
        <source>Drag from one point to another: that makes one stick. With clicks, each stick goes on from the last.</source>
        <translation>Zieh von einem Punkt zum anderen: Das macht einen Stab. Mit Klicks geht jeder Stab vom letzten aus weiter.</translation>
    </message>
    <message>
        <source>On ground, Swing makes it walk. Feet opposite each other need opposite angles: 0° and 180°.</source>
        <translation>Auf Boden lässt Schwung es gehen. Füße, die sich gegenüberstehen, brauchen gegenüberliegende Winkel: 0° und 180°.</translation>
    </message>
</context>
<context>
    <name>app::CodeCard</name>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1: %2. %3</translation>
    </message>
    <message>
        <source>Drag it sideways, or double-click it to type.</source>
        <translation>Zieh die Zahl seitwärts, oder doppelklicke darauf, um zu tippen.</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>x solid, y dashed</source>
        <translation>x durchgezogen, y gestrichelt</translation>
    </message>
</context>
<context>
    <name>app::CodePanel</name>
    <message>
        <source>Lines that the step before does not have. Click to go through them.</source>
        <translation>Zeilen, die der vorige Schritt nicht hat. Klicke, um sie durchzugehen.</translation>
    </message>
    <message>
        <source>Copy the shown code, with its files&apos; names</source>
        <translation>Den gezeigten Code mit den Namen seiner Dateien kopieren</translation>
    </message>
    <message>
        <source>Copy the code</source>
        <translation>Den Code kopieren</translation>
    </message>
    <message>
        <source>Copied the code.</source>
        <translation>Code kopiert.</translation>
    </message>
    <message>
        <source>values of %1</source>
        <translation>Werte: %1</translation>
    </message>
    <message>
        <source>values of the %1</source>
        <translation>Werte: %1</translation>
    </message>
    <message>
        <source>1 line new</source>
        <translation>1 neu</translation>
    </message>
    <message>
        <source>%1 lines new</source>
        <translation>%1 neu</translation>
    </message>
    <message>
        <source>%1 Enter takes it, Esc leaves it as it was.</source>
        <translation>%1 Eingabe übernimmt, Esc lässt es, wie es war.</translation>
    </message>
    <message>
        <source>No number is known of “%1”.</source>
        <translation>Von „%1“ ist keine Zahl bekannt.</translation>
    </message>
    <message>
        <source>Of %1, in “%2”.</source>
        <translation>Von %1, in „%2“.</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>noch keine</translation>
    </message>
    <message>
        <source>This line sets the scene up, before the first frame. Choose a line of a phase to stop at.</source>
        <translation>Diese Zeile baut die Szene auf, vor dem ersten Bild. Wähle zum Anhalten die Zeile einer Phase.</translation>
    </message>
    <message>
        <source>This line says in which order phases run. Choose a line of a phase to stop at.</source>
        <translation>Diese Zeile sagt, in welcher Reihenfolge Phasen laufen. Wähle zum Anhalten die Zeile einer Phase.</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>Stops before %1.</source>
        <translation>Hält vor %1 an.</translation>
    </message>
    <message>
        <source>No longer stops before %1.</source>
        <translation>Hält nicht mehr vor %1 an.</translation>
    </message>
    <message>
        <source>This line sets the scene up, before the first frame. Click a line of a phase to run to it.</source>
        <translation>Diese Zeile baut die Szene auf, vor dem ersten Bild. Klicke auf die Zeile einer Phase, um bis zu ihr zu laufen.</translation>
    </message>
    <message>
        <source>This line says in which order phases run. Click a line of a phase to run to it.</source>
        <translation>Diese Zeile sagt, in welcher Reihenfolge Phasen laufen. Klicke auf die Zeile einer Phase, um bis zu ihr zu laufen.</translation>
    </message>
    <message>
        <source>Run to here</source>
        <translation>Bis hierher laufen</translation>
    </message>
    <message>
        <source>Take the stop away</source>
        <translation>Haltepunkt entfernen</translation>
    </message>
    <message>
        <source>Stop here</source>
        <translation>Hier anhalten</translation>
    </message>
    <message>
        <source>Stop here when…</source>
        <translation>Hier anhalten, wenn …</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy “%1”</source>
        <translation>„%1“ kopieren</translation>
    </message>
    <message>
        <source>Copy all that is shown</source>
        <translation>Alles Gezeigte kopieren</translation>
    </message>
    <message>
        <source>Lines that only the step before has. Click to see them struck through where they were, or no longer (F8 in the code).</source>
        <translation>Zeilen, die nur der Schritt davor hat. Ein Klick zeigt sie durchgestrichen, wo sie standen, oder nicht mehr (F8 im Code).</translation>
    </message>
    <message>
        <source>1 line gone</source>
        <translation>1 Zeile weg</translation>
    </message>
    <message>
        <source>%1 lines gone</source>
        <translation>%1 Zeilen weg</translation>
    </message>
    <message>
        <source>Every line of the step before is still here.</source>
        <translation>Jede Zeile des Schritts davor ist noch da.</translation>
    </message>
</context>
<context>
    <name>app::CodeView</name>
    <message>
        <source>Code that runs</source>
        <translation>Code, der läuft</translation>
    </message>
    <message>
        <source>%1
Click to fold or unfold (Enter)</source>
        <translation>%1
Klick klappt ein oder aus (Eingabe)</translation>
    </message>
    <message>
        <source>Up and Down go from line to line. Enter runs to a line, or folds at a heading. F9 sets a stop, F2 changes a parameter, Ctrl+I tells a value, Ctrl+C copies.</source>
        <translation>Pfeil hoch und Pfeil runter gehen von Zeile zu Zeile. Eingabe läuft bis zu einer Zeile oder klappt bei einer Überschrift ein und aus. F9 setzt einen Haltepunkt, F2 ändert einen Parameter, Strg+I nennt einen Wert, Strg+C kopiert.</translation>
    </message>
    <message>
        <source>The run stops before this line&apos;s phase. Click to take the stop away (F9).</source>
        <translation>Der Lauf hält vor der Phase dieser Zeile an. Ein Klick entfernt den Haltepunkt (F9).</translation>
    </message>
    <message>
        <source>Click to stop before this line&apos;s phase (F9)</source>
        <translation>Ein Klick lässt den Lauf vor der Phase dieser Zeile anhalten (F9)</translation>
    </message>
    <message>
        <source>New in this step. %1</source>
        <translation>Neu in diesem Schritt. %1</translation>
    </message>
    <message>
        <source>The step before has this line; here it is gone.</source>
        <translation>Der Schritt davor hat diese Zeile; hier ist sie weg.</translation>
    </message>
    <message>
        <source>These lines add up what was computed above. They are the same for every force.
Click to fold or unfold (Enter)</source>
        <translation>Diese Zeilen addieren, was darüber berechnet wurde. Sie sind für jede Kraft dieselben.
Klick klappt ein oder aus (Eingabe)</translation>
    </message>
</context>
<context>
    <name>app::Commands</name>
    <message>
        <source>Experiments</source>
        <translation>Experimente</translation>
    </message>
    <message>
        <source>Pictures and films</source>
        <translation>Bilder und Filme</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Änderungen</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Other runs</source>
        <translation>Andere Läufe</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Schritte</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Bauen</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>app::CursorPlot</name>
    <message>
        <source>%1. Looking at %2</source>
        <translation>%1. Ein Blick auf %2</translation>
    </message>
</context>
<context>
    <name>app::DifferencePlot</name>
    <message>
        <source>Distance between the two runs over time</source>
        <translation>Abstand der zwei Läufe über der Zeit</translation>
    </message>
    <message>
        <source>px apart</source>
        <translation>px auseinander</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>%1&#x2009;px</source>
        <translation>%1&#x2009;px</translation>
    </message>
    <message>
        <source>frame %1: %2&#x2009;px apart</source>
        <translation>Bild %1: %2&#x2009;px auseinander</translation>
    </message>
    <message>
        <source>%1: %2&#x2009;px at frame %3</source>
        <translation>%1: %2&#x2009;px in Bild %3</translation>
    </message>
    <message>
        <source>%1, px</source>
        <translation>%1, px</translation>
    </message>
</context>
<context>
    <name>app::EffectHeads</name>
    <message>
        <source>Effect</source>
        <translation>Effekt</translation>
    </message>
    <message>
        <source>What acts in this scene, in the order in which it runs.</source>
        <translation>Was in dieser Szene wirkt, in der Reihenfolge, in der es läuft.</translation>
    </message>
    <message>
        <source>µs a frame</source>
        <translation>µs/Bild</translation>
    </message>
    <message>
        <source>Microseconds, millionths of a second, that each frame of the run spends on it. ± is how far half of the rounds are apart.</source>
        <translation>Mikrosekunden, millionstel Sekunden, die jedes Bild des Laufs dafür braucht. ± sagt, wie weit die Hälfte der Durchgänge auseinanderliegt.</translation>
    </message>
    <message>
        <source>µs a point</source>
        <translation>µs/Punkt</translation>
    </message>
    <message>
        <source>The same for each point that it works on.</source>
        <translation>Dasselbe für jeden Punkt, an dem er arbeitet.</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>Male</translation>
    </message>
    <message>
        <source>How often a frame computes it: some methods look several times.</source>
        <translation>Wie oft ein Bild ihn berechnet: Manche Verfahren schauen mehrmals hin.</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>How many points it works on.</source>
        <translation>An wie vielen Punkten er arbeitet.</translation>
    </message>
</context>
<context>
    <name>app::EffectLedger</name>
    <message>
        <source>measuring…</source>
        <translation>Messung läuft …</translation>
    </message>
    <message>
        <source>%1, measuring…</source>
        <translation>%1, Messung läuft …</translation>
    </message>
    <message>
        <source>%1, measured now</source>
        <translation>%1, jetzt gemessen</translation>
    </message>
    <message>
        <source>%1, measured at frame %2</source>
        <translation>%1, gemessen bei Bild %2</translation>
    </message>
</context>
<context>
    <name>app::EffectList</name>
    <message>
        <source>The effects of the scene, and what each costs</source>
        <translation>Die Effekte der Szene und was jeder kostet</translation>
    </message>
</context>
<context>
    <name>app::EffectsPanel</name>
    <message>
        <source>Effects</source>
        <translation>Effekte</translation>
    </message>
    <message>
        <source>&amp;Measure the effects again</source>
        <translation>Effekte neu &amp;messen</translation>
    </message>
    <message>
        <source>Measure what a frame costs where the run is now (%1)</source>
        <translation>Messen, was ein Bild kostet, wo der Lauf gerade ist (%1)</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Neu messen</translation>
    </message>
</context>
<context>
    <name>app::EnergyList</name>
    <message>
        <source>Where energy and momentum went</source>
        <translation>Wohin Energie und Impuls gingen</translation>
    </message>
</context>
<context>
    <name>app::EnergyPanel</name>
    <message>
        <source>Where it went</source>
        <translation>Wohin sie ging</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Where energy is, and where it went</source>
        <translation>Wo die Energie ist und wohin sie ging</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Impuls</translation>
    </message>
    <message>
        <source>Mass × velocity of everything together, and what changed it</source>
        <translation>Masse × Geschwindigkeit von allem zusammen, und was das geändert hat</translation>
    </message>
    <message>
        <source>Everything here turns in place, held by the ground: only what goes somewhere has momentum to count.</source>
        <translation>Alles dreht sich hier am Ort, vom Boden gehalten: Nur was irgendwohin geht, hat einen Impuls, den man zählen kann.</translation>
    </message>
    <message>
        <source>frame %1 to %2</source>
        <translation>Bild %1 bis %2</translation>
    </message>
    <message>
        <source>counting…</source>
        <translation>wird gezählt …</translation>
    </message>
</context>
<context>
    <name>app::EnergyPlot</name>
    <message>
        <source>Energy over the last frames</source>
        <translation>Energie über die letzten Bilder</translation>
    </message>
    <message>
        <source>Momentum over the last frames</source>
        <translation>Impuls über die letzten Bilder</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>down</source>
        <translation>nach unten</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>momentum</source>
        <translation>Impuls</translation>
    </message>
    <message>
        <source>A press or a drag goes to a frame, and the arrow keys go on by one</source>
        <translation>Drücken oder Ziehen führt zu einem Bild, die Pfeiltasten gehen um eines weiter</translation>
    </message>
    <message>
        <source>frame %1: %2</source>
        <translation>Bild %1: %2</translation>
    </message>
    <message>
        <source>%1 to the right, %2 down</source>
        <translation>%1 nach rechts, %2 nach unten</translation>
    </message>
    <message>
        <source>%1 there, drift %2</source>
        <translation>%1 da, Drift %2</translation>
    </message>
    <message>
        <source>%1: frame %2 is not counted</source>
        <translation>%1: Bild %2 ist nicht gezählt</translation>
    </message>
    <message>
        <source>%1: %2 (%3) at frame %4</source>
        <translation>%1: %2 (%3) in Bild %4</translation>
    </message>
</context>
<context>
    <name>app::ExampleGallery</name>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>%1 Undo brings your scene back.</source>
        <translation>%1 Rückgängig bringt deine Szene zurück.</translation>
    </message>
</context>
<context>
    <name>app::ExperimentFiles</name>
    <message>
        <source>Experiment not opened: %1 Your scene is unchanged.</source>
        <translation>Experiment nicht geöffnet: %1 Deine Szene ist unverändert.</translation>
    </message>
    <message>
        <source>Experiment not saved: %1</source>
        <translation>Experiment nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>What you did in “%1” is not saved.</source>
        <translation>Was du in „%1“ getan hast, ist nicht gespeichert.</translation>
    </message>
    <message>
        <source>%1 has changes that are not saved.</source>
        <translation>%1 hat Änderungen, die nicht gespeichert sind.</translation>
    </message>
    <message>
        <source>Save it first</source>
        <translation>Erst speichern</translation>
    </message>
    <message>
        <source>Save it, then go on</source>
        <translation>Speichern und dann weiter</translation>
    </message>
    <message>
        <source>Go on without</source>
        <translation>Ohne weiter</translation>
    </message>
    <message>
        <source>Go on; what was not saved is gone</source>
        <translation>Weiter; was nicht gespeichert war, ist weg</translation>
    </message>
    <message>
        <source>Open an experiment</source>
        <translation>Experiment öffnen</translation>
    </message>
    <message>
        <source>Experiments (*.json)</source>
        <translation>Experimente (*.json)</translation>
    </message>
    <message>
        <source>Save the experiment</source>
        <translation>Experiment speichern</translation>
    </message>
    <message>
        <source>The step as it is published.</source>
        <translation>Der Schritt, wie er veröffentlicht ist.</translation>
    </message>
    <message>
        <source>&amp;%1  %2</source>
        <translation>&amp;%1  %2</translation>
    </message>
    <message>
        <source>No file yet</source>
        <translation>Noch keine Datei</translation>
    </message>
    <message>
        <source>Experiments that you open or save will be listed here</source>
        <translation>Experimente, die du öffnest oder speicherst, stehen dann hier</translation>
    </message>
    <message>
        <source>%1 is not there any more, and was taken out of the list. If you moved it, open it from where it is now.</source>
        <translation>%1 ist nicht mehr da und wurde aus der Liste genommen. Wenn du die Datei verschoben hast, öffne sie dort, wo sie jetzt ist.</translation>
    </message>
    <message>
        <source>Experiment not copied: %1</source>
        <translation>Experiment nicht kopiert: %1</translation>
    </message>
    <message numerus="yes">
        <source>Copied: %n character(s), in one line.</source>
        <translation>
            <numerusform>Kopiert: %n Zeichen, in einer Zeile.</numerusform>
            <numerusform>Kopiert: %n Zeichen, in einer Zeile.</numerusform>
        </translation>
    </message>
    <message>
        <source>Springstep</source>
        <translation>Springstep</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>Close &amp;without saving</source>
        <translation>&amp;Ohne Speichern schließen</translation>
    </message>
    <message>
        <source>&amp;Stay</source>
        <translation>&amp;Bleiben</translation>
    </message>
</context>
<context>
    <name>app::FilmDialog</name>
    <message>
        <source>Film of the run</source>
        <translation>Film vom Lauf</translation>
    </message>
    <message>
        <source>How much of the film is made</source>
        <translation>Wie viel vom Film gemacht ist</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>Erstes Bild</translation>
    </message>
    <message>
        <source>The first frame of the film</source>
        <translation>Das erste Bild des Films</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Letztes Bild</translation>
    </message>
    <message>
        <source>The last frame of the film; the run is computed up to there</source>
        <translation>Das letzte Bild des Films; der Lauf wird bis dahin berechnet</translation>
    </message>
    <message>
        <source>Frames a second</source>
        <translation>Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>How fast the film plays: 30 is as fast as the window does</source>
        <translation>Wie schnell der Film läuft: 30 ist so schnell wie im Fenster</translation>
    </message>
    <message>
        <source>&amp;First frame</source>
        <translation>&amp;Erstes Bild</translation>
    </message>
    <message>
        <source>&amp;Last frame</source>
        <translation>&amp;Letztes Bild</translation>
    </message>
    <message>
        <source>Frames a &amp;second</source>
        <translation>Bilder pro &amp;Sekunde</translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Make the film</source>
        <translation>Film e&amp;rstellen</translation>
    </message>
    <message>
        <source>Make the film; the window can be used meanwhile</source>
        <translation>Den Film erstellen; das Fenster ist derweil benutzbar</translation>
    </message>
    <message>
        <source>Looking at its colours…</source>
        <translation>Sieht sich die Farben an …</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>%1 is made, up to where the run stops. %2</source>
        <translation>%1 ist fertig, bis dahin, wo der Lauf anhält. %2</translation>
    </message>
    <message>
        <source>%1 is made.</source>
        <translation>%1 ist fertig.</translation>
    </message>
    <message>
        <source>Stopped. No file was written.</source>
        <translation>Angehalten. Keine Datei wurde geschrieben.</translation>
    </message>
    <message>
        <source>Stopped. The pictures up to frame %1 are there.</source>
        <translation>Angehalten. Die Bilder bis Bild %1 sind da.</translation>
    </message>
    <message>
        <source>S&amp;top</source>
        <translation>An&amp;halten</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Give the film up (Esc)</source>
        <translation>Den Film aufgeben (Esc)</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>Diese Seite schließen (Esc)</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Breite</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>E&amp;rsetzen</translation>
    </message>
    <message>
        <source>Make the film, and write over what is there</source>
        <translation>Den Film erstellen und überschreiben, was schon da ist</translation>
    </message>
    <message>
        <source>A name that ends in .webm or .gif makes one file. A name such as walk_%04d.png makes a picture of each frame, with its number in place of %04d.</source>
        <translation>Ein Name, der auf .webm oder .gif endet, ergibt eine Datei. Ein Name wie walk_%04d.png ergibt für jedes Bild eine Datei, mit seiner Nummer anstelle von %04d.</translation>
    </message>
</context>
<context>
    <name>app::FilmName</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>Where the film goes</source>
        <translation>Wohin der Film kommt</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Wählen …</translation>
    </message>
    <message>
        <source>Choose a folder and a name</source>
        <translation>Einen Ordner und einen Namen wählen</translation>
    </message>
    <message>
        <source>%1 is there already. Replace it, or give another name.</source>
        <translation>%1 gibt es schon. Ersetze die Datei oder gib einen anderen Namen an.</translation>
    </message>
    <message>
        <source>Such pictures are there already, as %1. Replace them, or give another name.</source>
        <translation>Solche Bilder gibt es schon, etwa %1. Ersetze sie oder gib einen anderen Namen an.</translation>
    </message>
    <message>
        <source>Film of the run</source>
        <translation>Film vom Lauf</translation>
    </message>
    <message>
        <source>Films (*.gif *.webm);;Pictures of each frame (*.png)</source>
        <translation>Filme (*.gif *.webm);;Jedes Bild als Datei (*.png)</translation>
    </message>
</context>
<context>
    <name>app::FilmSize</name>
    <message>
        <source>Width in pixels</source>
        <translation>Breite in Pixeln</translation>
    </message>
    <message>
        <source>How wide the pictures are, %1 to %2 pixels</source>
        <translation>Wie breit die Bilder sind, %1 bis %2 Pixel</translation>
    </message>
    <message>
        <source>4 : 3</source>
        <translation>4 : 3</translation>
    </message>
    <message>
        <source>16 : 9</source>
        <translation>16 : 9</translation>
    </message>
    <message>
        <source>square</source>
        <translation>quadratisch</translation>
    </message>
    <message>
        <source>as the scene is</source>
        <translation>wie die Szene</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>How wide the pictures are beside their height; the height follows the width</source>
        <translation>Wie breit die Bilder im Verhältnis zu ihrer Höhe sind; die Höhe folgt der Breite</translation>
    </message>
    <message>
        <source>Height: %1 pixels</source>
        <translation>Höhe: %1 Pixel</translation>
    </message>
</context>
<context>
    <name>app::FootfallStrip</name>
    <message>
        <source>Feet on the ground</source>
        <translation>Füße am Boden</translation>
    </message>
    <message>
        <source>%1 stands, slipped %2&#x202f;px.</source>
        <translation>%1 steht, ist %2&#x202f;px gerutscht.</translation>
    </message>
    <message>
        <source>%1 is in the air.</source>
        <translation>%1 ist in der Luft.</translation>
    </message>
    <message>
        <source>Feet on the ground, and how many px each slips</source>
        <translation>Füße am Boden, und um wie viele px jeder rutscht</translation>
    </message>
    <message>
        <source>Which foot stands when. Click to go to that frame</source>
        <translation>Welcher Fuß wann steht. Ein Klick führt zu diesem Bild</translation>
    </message>
    <message>
        <source>%1 is in the air at frame %2</source>
        <translation>%1 ist bei Bild %2 in der Luft</translation>
    </message>
    <message>
        <source>%1 stands from frame %2 to %3 and slips %4&#x202f;px</source>
        <translation>%1 steht von Bild %2 bis %3 und rutscht %4&#x202f;px</translation>
    </message>
</context>
<context>
    <name>app::FrameCounter</name>
    <message>
        <source>Go to a frame (Ctrl+G)</source>
        <translation>Zu einem Bild gehen (Strg+G)</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Go to frame</source>
        <translation>Zu Bild gehen</translation>
    </message>
    <message>
        <source>Enter goes there, Escape leaves</source>
        <translation>Eingabe geht hin, Esc verlässt das Feld</translation>
    </message>
    <message>
        <source>A frame is a whole number from 0 to %1.</source>
        <translation>Ein Bild ist eine ganze Zahl von 0 bis %1.</translation>
    </message>
</context>
<context>
    <name>app::GlossaryPage</name>
    <message>
        <source>Glossary</source>
        <translation>Glossar</translation>
    </message>
    <message>
        <source>The words that the lessons teach. Esc closes this page.</source>
        <translation>Die Begriffe, die die Lektionen lehren. Esc schließt diese Seite.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search the glossary</source>
        <translation>Das Glossar durchsuchen</translation>
    </message>
    <message>
        <source>Part of a word, or of what it means</source>
        <translation>Teil eines Begriffs oder dessen, was er bedeutet</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Begriffe</translation>
    </message>
    <message>
        <source>No word is found for “%1”. Try a part of it.</source>
        <translation>Zu „%1“ ist kein Begriff zu finden. Versuch es mit einem Teil davon.</translation>
    </message>
</context>
<context>
    <name>app::GrowthPlot</name>
    <message>
        <source>Map of growth</source>
        <translation>Karte des Wachstums</translation>
    </message>
    <message>
        <source>a step of %1&#x2009;frames</source>
        <translation>ein Zeitschritt von %1&#x2009;Bildern</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: disturbances %2</source>
        <translation>%1: Störungen %2</translation>
    </message>
    <message>
        <source>%1: it holds</source>
        <translation>%1: Es hält</translation>
    </message>
    <message>
        <source>a step of %1</source>
        <translation>ein Zeitschritt von %1</translation>
    </message>
    <message>
        <source>%1
A click or Enter uses k %2 and %3</source>
        <translation>%1
Ein Klick oder Eingabe setzt k %2 und %3</translation>
    </message>
    <message>
        <source>The map is being computed.</source>
        <translation>Die Karte wird berechnet.</translation>
    </message>
    <message>
        <source>You are at %1. Arrow keys walk over the map, Enter uses a place.</source>
        <translation>Du bist bei %1. Pfeiltasten gehen über die Karte, Eingabe übernimmt einen Ort.</translation>
    </message>
    <message>
        <source>grows</source>
        <translation>wächst</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>hält</translation>
    </message>
    <message>
        <source>you are here</source>
        <translation>du bist hier</translation>
    </message>
    <message>
        <source>step, frames</source>
        <translation>Zeitschritt, Bilder</translation>
    </message>
    <message>
        <source>damp, kept a frame</source>
        <translation>damp, pro Bild behalten</translation>
    </message>
    <message>
        <source>stiffness k, 1/frame²</source>
        <translation>Steifigkeit k, 1/Bild²</translation>
    </message>
    <message>
        <source>×10 a frame</source>
        <translation>×10 pro Bild</translation>
    </message>
</context>
<context>
    <name>app::GuideBox</name>
    <message>
        <source>First build</source>
        <translation>Erstes Bauen</translation>
    </message>
    <message>
        <source>With keys: arrow keys move the cross in the picture, Return clicks there, Tab goes to fields and switches.</source>
        <translation>Mit Tasten: Pfeiltasten bewegen das Kreuz im Bild, die Eingabetaste klickt dort, Tab geht zu Feldern und Schaltern.</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Begin the first build again with a new scene; undo brings this one back</source>
        <translation>Das erste Bauen mit einer neuen Szene noch einmal beginnen; Rückgängig bringt diese zurück</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Verlassen</translation>
    </message>
    <message>
        <source>Leave the first build; the scene stays as it is</source>
        <translation>Das erste Bauen verlassen; die Szene bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>First build: %1 of %2</source>
        <translation>Erstes Bauen: %1 von %2</translation>
    </message>
</context>
<context>
    <name>app::HelpPage</name>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>Everything works without the mouse, too. Esc closes this page.</source>
        <translation>Alles geht auch ohne Maus. Esc schließt diese Seite.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>app::KeptList</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1: %2 (not installed)</source>
        <translation>%1: %2 (nicht installiert)</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Recover scenes</source>
        <translation>Szenen wiederherstellen</translation>
    </message>
    <message>
        <source>These scenes were not saved. Recover one to go on with it.</source>
        <translation>Diese Szenen wurden nicht gespeichert. Stell eine wieder her, um damit weiterzumachen.</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Last changed</source>
        <translation>Zuletzt geändert</translation>
    </message>
    <message>
        <source>Scenes that were not saved</source>
        <translation>Szenen, die nicht gespeichert wurden</translation>
    </message>
    <message>
        <source>Go on with the selected scene (Return)</source>
        <translation>Mit der ausgewählten Szene weitermachen (Eingabe)</translation>
    </message>
    <message>
        <source>Delete the selected scene for good (Del)</source>
        <translation>Die ausgewählte Szene endgültig löschen (Entf)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Keep them all for later (Esc)</source>
        <translation>Alle für später behalten (Esc)</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>beschädigt</translation>
    </message>
</context>
<context>
    <name>app::KeptOffer</name>
    <message>
        <source>“%1: %2”</source>
        <translation>„%1: %2“</translation>
    </message>
    <message>
        <source>Springstep was ended by something else. Your scene of %1 from %2 is here.</source>
        <translation>Springstep wurde von außen beendet. Deine Szene zu %1 (%2) ist noch da.</translation>
    </message>
    <message>
        <source>Your scene of %1 from %2 was not saved. It is here.</source>
        <translation>Deine Szene zu %1 (%2) war nicht gespeichert. Sie ist noch da.</translation>
    </message>
    <message>
        <source>Open it</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Go on with it</source>
        <translation>Damit weitermachen</translation>
    </message>
    <message>
        <source>Forget it</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>Delete it; it will not be offered again</source>
        <translation>Sie löschen; sie wird nicht noch einmal angeboten</translation>
    </message>
    <message>
        <source>Springstep was ended by something else. %1 scenes that were not saved are here.</source>
        <translation>Springstep wurde von etwas anderem beendet. Hier sind %1 Szenen, die nicht gespeichert wurden.</translation>
    </message>
    <message>
        <source>%1 scenes that were not saved are here.</source>
        <translation>Hier sind %1 Szenen, die nicht gespeichert wurden.</translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Anzeigen</translation>
    </message>
    <message>
        <source>Shows a list, from which each can be recovered or deleted</source>
        <translation>Zeigt eine Liste, aus der man jede wiederherstellen oder löschen kann</translation>
    </message>
    <message>
        <source>There is no scene to recover.</source>
        <translation>Es gibt keine Szene zum Wiederherstellen.</translation>
    </message>
</context>
<context>
    <name>app::KeyCaps</name>
    <message>
        <source>Page Up</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation>Bild ab</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>or</source>
        <translation>oder</translation>
    </message>
</context>
<context>
    <name>app::LearnPanel</name>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>%1 of %2 steps</source>
        <translation>%1/%2 Schritte</translation>
    </message>
    <message>
        <source>Fold the lessons to a narrow strip (Ctrl+Shift+1)</source>
        <translation>Die Lektionen zu einem schmalen Streifen falten (Strg+Umschalt+1)</translation>
    </message>
    <message>
        <source>Fold the lessons to a narrow strip</source>
        <translation>Die Lektionen zu einem schmalen Streifen falten</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Alle Lektionen</translation>
    </message>
    <message>
        <source>Back to the text (Esc)</source>
        <translation>Zurück zum Text (Esc)</translation>
    </message>
    <message>
        <source>Show all lessons in place of the text</source>
        <translation>Alle Lektionen statt des Textes zeigen</translation>
    </message>
</context>
<context>
    <name>app::LessonList</name>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
</context>
<context>
    <name>app::LessonModel</name>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>%1, %2 of %3 steps done</source>
        <translation>%1, %2 von %3 Schritten geschafft</translation>
    </message>
    <message>
        <source>%1, done</source>
        <translation>%1, geschafft</translation>
    </message>
    <message>
        <source>%1, not yet done</source>
        <translation>%1, noch nicht geschafft</translation>
    </message>
    <message>
        <source>1 file is not a lesson</source>
        <translation>1 Datei ist keine Lektion</translation>
    </message>
    <message>
        <source>%1 files are not lessons</source>
        <translation>%1 Dateien sind keine Lektionen</translation>
    </message>
    <message>
        <source>What you learnt</source>
        <translation>Was du gelernt hast</translation>
    </message>
    <message>
        <source>What the steps of this lesson taught, and what is still to try</source>
        <translation>Was die Schritte dieser Lektion gelehrt haben, und was noch auszuprobieren ist</translation>
    </message>
    <message>
        <source>%1: what you learnt</source>
        <translation>%1: was du gelernt hast</translation>
    </message>
</context>
<context>
    <name>app::LessonRail</name>
    <message>
        <source>Show the lessons with their texts</source>
        <translation>Die Lektionen mit ihren Texten zeigen</translation>
    </message>
    <message>
        <source>Show the lessons with their texts (Ctrl+Shift+1)</source>
        <translation>Die Lektionen mit ihren Texten zeigen (Strg+Umschalt+1)</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Vorheriger Schritt</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Nächster Schritt</translation>
    </message>
</context>
<context>
    <name>app::MainWindow</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Lauf</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>&amp;Open an experiment…</source>
        <translation>Experiment ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>&amp;Save the experiment</source>
        <translation>Experiment &amp;speichern</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Speichern &amp;unter …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Next &amp;frame</source>
        <translation>Nächstes &amp;Bild</translation>
    </message>
    <message>
        <source>Frame &amp;back</source>
        <translation>Bild &amp;zurück</translation>
    </message>
    <message>
        <source>&amp;Next phase</source>
        <translation>&amp;Nächste Phase</translation>
    </message>
    <message>
        <source>P&amp;hase back</source>
        <translation>&amp;Phase zurück</translation>
    </message>
    <message>
        <source>To the &amp;end of what was computed</source>
        <translation>Zum &amp;Ende des Berechneten</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>&amp;Langsamer</translation>
    </message>
    <message>
        <source>Faste&amp;r</source>
        <translation>S&amp;chneller</translation>
    </message>
    <message>
        <source>Start the step &amp;afresh</source>
        <translation>Schritt neu be&amp;ginnen</translation>
    </message>
    <message>
        <source>Forget the &amp;old run</source>
        <translation>Alten Lauf &amp;vergessen</translation>
    </message>
    <message>
        <source>Ne&amp;xt step</source>
        <translation>Nächster Sch&amp;ritt</translation>
    </message>
    <message>
        <source>Pre&amp;vious step</source>
        <translation>Vor&amp;iger Schritt</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>&amp;Fit the scene</source>
        <translation>Szene ein&amp;passen</translation>
    </message>
    <message>
        <source>Show the whole stage with all bodies, and stay with them (Ctrl+0)</source>
        <translation>Die ganze Bühne mit allen Körpern zeigen und bei ihnen bleiben (Strg+0)</translation>
    </message>
    <message>
        <source>Ne&amp;xt body outside</source>
        <translation>Nächster Körper a&amp;ußerhalb</translation>
    </message>
    <message>
        <source>Bring a body that is outside of the picture into view (O)</source>
        <translation>Einen Körper, der außerhalb des Bildes ist, ins Bild holen (O)</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>&amp;Lektionen</translation>
    </message>
    <message>
        <source>&amp;Code and parameters</source>
        <translation>&amp;Code und Parameter</translation>
    </message>
    <message>
        <source>What each effect of the scene costs, with a switch for each (Ctrl+4)</source>
        <translation>Was jeder Effekt der Szene kostet, mit einem Schalter für jeden (Strg+4)</translation>
    </message>
    <message>
        <source>&amp;Stability of the step</source>
        <translation>&amp;Stabilität des Zeitschritts</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>V&amp;ollbild</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Genauigkeit</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Effekte</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>Nothing was changed in this step that could be undone (Ctrl+Z)</source>
        <translation>In diesem Schritt wurde nichts geändert, was sich rückgängig machen ließe (Strg+Z)</translation>
    </message>
    <message>
        <source>Undo: %1 (Ctrl+Z)</source>
        <translation>Rückgängig: %1 (Strg+Z)</translation>
    </message>
    <message>
        <source>Nothing was undone (Ctrl+Shift+Z)</source>
        <translation>Nichts wurde rückgängig gemacht (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>Redo: %1 (Ctrl+Shift+Z)</source>
        <translation>Wiederholen: %1 (Strg+Umschalt+Z)</translation>
    </message>
    <message>
        <source>Lan&amp;guage</source>
        <translation>Spr&amp;ache</translation>
    </message>
    <message>
        <source>As the &amp;system has it</source>
        <translation>Wie das &amp;System</translation>
    </message>
    <message>
        <source>Springstep speaks %1 from its next start on.</source>
        <translation>Ab dem nächsten Start spricht Springstep %1.</translation>
    </message>
    <message>
        <source>L&amp;earn</source>
        <translation>Le&amp;rnen</translation>
    </message>
    <message>
        <source>Lessons, scene and code</source>
        <translation>Lektionen, Szene und Code</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>What accuracy costs in time, on this scene</source>
        <translation>Was Genauigkeit an Zeit kostet, in dieser Szene</translation>
    </message>
    <message>
        <source>E&amp;nergy</source>
        <translation>&amp;Energie</translation>
    </message>
    <message>
        <source>Effec&amp;ts</source>
        <translation>E&amp;ffekte</translation>
    </message>
    <message>
        <source>&amp;New: the step as published</source>
        <translation>&amp;Neu: der Schritt wie veröffentlicht</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Less mo&amp;vement</source>
        <translation>&amp;Weniger Bewegung</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>&amp;Hoher Kontrast</translation>
    </message>
    <message>
        <source>Si&amp;ze of text and controls</source>
        <translation>Größe von &amp;Text und Bedienelementen</translation>
    </message>
    <message>
        <source>%1&#x2009;%</source>
        <translation>%1&#x2009;%</translation>
    </message>
    <message>
        <source>This screen is too small for the scene with its time at that size</source>
        <translation>Für die Szene mit ihrer Zeit ist dieser Bildschirm bei dieser Größe zu klein</translation>
    </message>
    <message>
        <source>At its next start, Springstep is drawn at %1&#x2009;%.</source>
        <translation>Ab dem nächsten Start wird Springstep mit %1&#x2009;% gezeichnet.</translation>
    </message>
    <message>
        <source>Scene onl&amp;y</source>
        <translation>&amp;Nur die Szene</translation>
    </message>
    <message>
        <source>Nothing but the scene and its time; again brings the panels back (F11)</source>
        <translation>Nichts als die Szene und ihre Zeit; noch einmal holt die Leisten zurück (F11)</translation>
    </message>
    <message>
        <source>Two runs</source>
        <translation>Zwei Läufe</translation>
    </message>
    <message>
        <source>Choose among the other runs…</source>
        <translation>Unter den anderen Läufen wählen …</translation>
    </message>
    <message>
        <source>Show one beside, go back to it, keep, name or delete it</source>
        <translation>Einen daneben zeigen, zu ihm zurückgehen, ihn behalten, benennen oder löschen</translation>
    </message>
    <message>
        <source>&amp;Compare two runs</source>
        <translation>Z&amp;wei Läufe vergleichen</translation>
    </message>
    <message>
        <source>How far this run and the one beside it are apart, frame by frame</source>
        <translation>Wie weit dieser Lauf und der daneben auseinander sind, Bild für Bild</translation>
    </message>
    <message>
        <source>Choose and move parts</source>
        <translation>Teile wählen und bewegen</translation>
    </message>
    <message>
        <source>Choose</source>
        <translation>Wählen</translation>
    </message>
    <message>
        <source>Choose parts, and drag them to where they shall be</source>
        <translation>Teile wählen und dorthin ziehen, wo sie sein sollen</translation>
    </message>
    <message>
        <source>Add points</source>
        <translation>Punkte hinzufügen</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Add a body with a mass and a size</source>
        <translation>Einen Körper mit Masse und Größe hinzufügen</translation>
    </message>
    <message>
        <source>Nail points down</source>
        <translation>Punkte festnageln</translation>
    </message>
    <message>
        <source>Nail</source>
        <translation>Nagel</translation>
    </message>
    <message>
        <source>Fix a point where it is, or free it</source>
        <translation>Einen Punkt festmachen, wo er ist, oder ihn lösen</translation>
    </message>
    <message>
        <source>Add springs</source>
        <translation>Federn hinzufügen</translation>
    </message>
    <message>
        <source>Spring</source>
        <translation>Feder</translation>
    </message>
    <message>
        <source>Tie two points: a spring pulls and pushes them to its length</source>
        <translation>Zwei Punkte verbinden: Eine Feder zieht und schiebt sie auf ihre Länge</translation>
    </message>
    <message>
        <source>Add sticks</source>
        <translation>Stäbe hinzufügen</translation>
    </message>
    <message>
        <source>Stick</source>
        <translation>Stab</translation>
    </message>
    <message>
        <source>Tie two points: a stick keeps its length</source>
        <translation>Zwei Punkte verbinden: Ein Stab behält seine Länge</translation>
    </message>
    <message>
        <source>Add feet</source>
        <translation>Füße hinzufügen</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>Give a body a foot, which belongs at an angle from it</source>
        <translation>Einem Körper einen Fuß geben, der in einem Winkel zu ihm gehört</translation>
    </message>
    <message>
        <source>&amp;Take this scene to the sandbox</source>
        <translation>Diese Szene in den Sandkasten &amp;mitnehmen</translation>
    </message>
    <message>
        <source>&amp;Delete what is chosen</source>
        <translation>Auswahl &amp;löschen</translation>
    </message>
    <message>
        <source>Dup&amp;licate what is chosen</source>
        <translation>Auswahl &amp;verdoppeln</translation>
    </message>
    <message>
        <source>Choose &amp;all</source>
        <translation>&amp;Alles wählen</translation>
    </message>
    <message>
        <source>No sandbox is installed</source>
        <translation>Es ist kein Sandkasten installiert</translation>
    </message>
    <message>
        <source>This scene is in the sandbox</source>
        <translation>Diese Szene ist im Sandkasten</translation>
    </message>
    <message>
        <source>Take this scene to the sandbox, to build on (Ctrl+B)</source>
        <translation>Diese Szene in den Sandkasten mitnehmen, um daran weiterzubauen (Strg+B)</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>E&amp;xportieren</translation>
    </message>
    <message>
        <source>&amp;Picture of the scene…</source>
        <translation>&amp;Bild der Szene …</translation>
    </message>
    <message>
        <source>The scene as it is shown, as PNG or SVG</source>
        <translation>Die Szene, wie sie zu sehen ist, als PNG oder SVG</translation>
    </message>
    <message>
        <source>&amp;Film of the run…</source>
        <translation>&amp;Film des Laufs …</translation>
    </message>
    <message>
        <source>The run as an animated GIF or a PNG for each frame</source>
        <translation>Der Lauf als animiertes GIF oder ein PNG für jedes Bild</translation>
    </message>
    <message>
        <source>The picture of the scene is copied.</source>
        <translation>Das Bild der Szene ist kopiert.</translation>
    </message>
    <message>
        <source>Picture of the scene</source>
        <translation>Bild der Szene</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg)</source>
        <translation>Bilder (*.png *.svg)</translation>
    </message>
    <message>
        <source>Picture not saved: %1</source>
        <translation>Bild nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>%1[*] – Springstep</source>
        <translation>%1[*] – Springstep</translation>
    </message>
    <message>
        <source>&amp;Copy the experiment as text</source>
        <translation>Experiment als Text &amp;kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste an experiment</source>
        <translation>Experiment &amp;einfügen</translation>
    </message>
    <message>
        <source>Copy the p&amp;icture of the scene</source>
        <translation>&amp;Bild der Szene kopieren</translation>
    </message>
    <message>
        <source>Show a &amp;hint</source>
        <translation>T&amp;ipp zeigen</translation>
    </message>
    <message>
        <source>A hint for the next thing to try (H)</source>
        <translation>Ein Tipp, was als Nächstes auszuprobieren ist (H)</translation>
    </message>
    <message>
        <source>&amp;Glossary</source>
        <translation>&amp;Glossar</translation>
    </message>
    <message>
        <source>The words that the lessons teach (Shift+F1)</source>
        <translation>Die Begriffe, die die Lektionen lehren (Umschalt+F1)</translation>
    </message>
    <message>
        <source>Take the &amp;tour</source>
        <translation>&amp;Rundgang machen</translation>
    </message>
    <message>
        <source>A minute with what there is in this window</source>
        <translation>Eine Minute mit dem, was es in diesem Fenster gibt</translation>
    </message>
    <message>
        <source>The picture</source>
        <translation>Die Szene</translation>
    </message>
    <message>
        <source>This is what a lesson is about. Drag anything in it, and let go on the way to throw it.</source>
        <translation>Darum geht es in einer Lektion. Zieh an etwas darin, und lass unterwegs los, um es zu werfen.</translation>
    </message>
    <message>
        <source>Play and stop</source>
        <translation>Abspielen und anhalten</translation>
    </message>
    <message>
        <source>**Space** plays, and stops anywhere. **→** goes on by one frame, **←** goes back.</source>
        <translation>**Leertaste** spielt ab und hält überall an. **→** geht ein Bild weiter, **←** geht eines zurück.</translation>
    </message>
    <message>
        <source>All of the run is kept</source>
        <translation>Der ganze Lauf bleibt</translation>
    </message>
    <message>
        <source>Drag here to go back in time. Change something there, and the old run stays as a ghost.</source>
        <translation>Zieh hier, um in der Zeit zurückzugehen. Ändere dort etwas, und der alte Lauf bleibt als Geist.</translation>
    </message>
    <message>
        <source>Inside a frame</source>
        <translation>In einem Bild</translation>
    </message>
    <message>
        <source>A frame is made of phases: springs pull, damping takes its share, things move. **Shift+→** goes from one to the next.</source>
        <translation>Ein Bild besteht aus Phasen: Federn ziehen, die Dämpfung nimmt ihren Anteil, die Dinge bewegen sich. **Umschalt+→** geht von einer zur nächsten.</translation>
    </message>
    <message>
        <source>The code that runs</source>
        <translation>Der Code, der läuft</translation>
    </message>
    <message>
        <source>These very lines compute the picture. Beside them stand the values of this moment.</source>
        <translation>Genau diese Zeilen berechnen die Szene. Neben ihnen stehen die Werte dieses Augenblicks.</translation>
    </message>
    <message>
        <source>Numbers to change</source>
        <translation>Zahlen zum Ändern</translation>
    </message>
    <message>
        <source>Move a slider, or type any number. The arrow behind it brings it back.</source>
        <translation>Bewege einen Schieber, oder tippe irgendeine Zahl. Der Pfeil dahinter bringt sie zurück.</translation>
    </message>
    <message>
        <source>Try this</source>
        <translation>Probier es aus</translation>
    </message>
    <message>
        <source>Springstep ticks what it sees you do. A lamp has a hint, and words with dots under them are explained when you click them.</source>
        <translation>Springstep hakt ab, was es dich tun sieht. Eine Lampe hat einen Tipp, und Wörter mit Punkten darunter werden erklärt, wenn du sie anklickst.</translation>
    </message>
    <message>
        <source>&amp;Build</source>
        <translation>&amp;Bauen</translation>
    </message>
    <message>
        <source>A scene of your own: points, springs, sticks, feet</source>
        <translation>Eine eigene Szene: Punkte, Federn, Stäbe, Füße</translation>
    </message>
    <message>
        <source>&amp;Plots</source>
        <translation>D&amp;iagramme</translation>
    </message>
    <message>
        <source>Curves of any quantity of any body (Ctrl+5)</source>
        <translation>Kurven jeder Größe jedes Körpers (Strg+5)</translation>
    </message>
    <message>
        <source>Stability</source>
        <translation>Stabilität</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>The panels stand as they did at first.</source>
        <translation>Die Leisten stehen wieder wie am Anfang.</translation>
    </message>
    <message>
        <source>Where energy and momentum went (Ctrl+3)</source>
        <translation>Wohin Energie und Impuls gingen (Strg+3)</translation>
    </message>
    <message>
        <source>Panels and menus come and go at once, wind is drawn still; only what is computed moves</source>
        <translation>Leisten und Menüs kommen und gehen sofort, Wind wird als Standbild gezeichnet; nur was berechnet wird, bewegt sich</translation>
    </message>
    <message>
        <source>Lessons &amp;as a narrow strip</source>
        <translation>Lektionen nur als &amp;Zeichen</translation>
    </message>
    <message>
        <source>The marks of the lessons alone, and more room for the rest (Ctrl+Shift+1)</source>
        <translation>Nur die Zeichen der Lektionen, und mehr Platz für den Rest (Strg+Umschalt+1)</translation>
    </message>
    <message>
        <source>Start again now</source>
        <translation>Jetzt neu starten</translation>
    </message>
    <message>
        <source>Text, buttons and the picture; the window opens again with all that is in it</source>
        <translation>Text, Knöpfe und Szene; das Fenster öffnet sich neu mit allem, was darin ist</translation>
    </message>
    <message>
        <source>%1 A film is being made.</source>
        <translation>%1 Gerade entsteht ein Film.</translation>
    </message>
    <message>
        <source>Stops the film; everything else stays</source>
        <translation>Bricht den Film ab; alles andere bleibt</translation>
    </message>
    <message>
        <source>&amp;About Springstep</source>
        <translation>Ü&amp;ber Springstep</translation>
    </message>
    <message>
        <source>Version, licence, and what it is built with</source>
        <translation>Version, Lizenz und verwendete Bibliotheken</translation>
    </message>
    <message>
        <source>Reco&amp;ver scenes…</source>
        <translation>Szenen &amp;wiederherstellen…</translation>
    </message>
    <message>
        <source>Re&amp;start</source>
        <translation>Neu s&amp;tarten</translation>
    </message>
    <message>
        <source>Repea&amp;t the run, with all that was done in it</source>
        <translation>Den Lauf wieder&amp;holen, mit allem, was darin getan wurde</translation>
    </message>
</context>
<context>
    <name>app::MeasurePanel</name>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>at the cursor</source>
        <translation>am Zeitzeiger</translation>
    </message>
</context>
<context>
    <name>app::NameField</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Name of the run</source>
        <translation>Name des Laufs</translation>
    </message>
    <message>
        <source>Return takes this name, Escape leaves the one before</source>
        <translation>Eingabe übernimmt diesen Namen, Esc lässt den vorigen</translation>
    </message>
</context>
<context>
    <name>app::Narration</name>
    <message>
        <source>Try this</source>
        <translation>Probier es aus</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Voriger Schritt</translation>
    </message>
    <message>
        <source>Back: %1 (Page Up)</source>
        <translation>Zurück: %1 (Bild auf)</translation>
    </message>
    <message>
        <source>This is the first step.</source>
        <translation>Das ist der erste Schritt.</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Weiter: %1</translation>
    </message>
    <message>
        <source>Next: %1 (Page Down)</source>
        <translation>Weiter: %1 (Bild ab)</translation>
    </message>
    <message>
        <source>What you learnt</source>
        <translation>Was du gelernt hast</translation>
    </message>
    <message>
        <source>What you learnt in this lesson, and what comes next</source>
        <translation>Was du in dieser Lektion gelernt hast, und was danach kommt</translation>
    </message>
</context>
<context>
    <name>app::Notice</name>
    <message>
        <source>Notice</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Close this notice (Esc)</source>
        <translation>Diesen Hinweis schließen (Esc)</translation>
    </message>
    <message>
        <source>Close this notice</source>
        <translation>Diesen Hinweis schließen</translation>
    </message>
</context>
<context>
    <name>app::NumberTable</name>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>The numbers were not saved as %1: %2. Choose another folder, or make room.</source>
        <translation>Die Zahlen wurden nicht als %1 gespeichert: %2. Wähle einen anderen Ordner, oder schaffe Platz.</translation>
    </message>
</context>
<context>
    <name>app::OrderPlot</name>
    <message>
        <source>Error against step: the measured order</source>
        <translation>Fehler über dem Zeitschritt: die gemessene Ordnung</translation>
    </message>
    <message>
        <source>%1: %2, as stated</source>
        <translation>%1: %2, wie angegeben</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1: %2 von %3</translation>
    </message>
    <message>
        <source>step, frames (finer →)</source>
        <translation>Zeitschritt, Bilder (feiner →)</translation>
    </message>
    <message>
        <source>how far off at most, px</source>
        <translation>größte Abweichung, px</translation>
    </message>
    <message>
        <source>← more exact</source>
        <translation>← genauer</translation>
    </message>
    <message>
        <source>A step %1 times as short makes the error %2 times as small: order %3 here, %4 stated</source>
        <translation>Ein Zeitschritt, %1-mal so kurz, macht den Fehler %2-mal so klein: Ordnung %3 hier, %4 angegeben</translation>
    </message>
</context>
<context>
    <name>app::ParameterPanel</name>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurücksetzen</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Pictures of what other values make of this step</source>
        <translation>Bilder davon, was andere Werte aus diesem Schritt machen</translation>
    </message>
    <message>
        <source>Set every parameter back to what this step begins with</source>
        <translation>Jeden Parameter auf das setzen, womit dieser Schritt beginnt</translation>
    </message>
    <message>
        <source>Nothing to reset: every parameter is as this step begins with.</source>
        <translation>Nichts zurückzusetzen: Jeder Parameter ist so, wie dieser Schritt beginnt.</translation>
    </message>
    <message>
        <source>Show fewer parameters</source>
        <translation>Weniger Parameter zeigen</translation>
    </message>
    <message>
        <source>Show all parameters</source>
        <translation>Alle Parameter zeigen</translation>
    </message>
    <message>
        <source>%1, shown</source>
        <translation>%1, aufgeklappt</translation>
    </message>
    <message>
        <source>%1, folded</source>
        <translation>%1, zugeklappt</translation>
    </message>
</context>
<context>
    <name>app::ParameterRow</name>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1, Schieber</translation>
    </message>
    <message>
        <source>Back to %1</source>
        <translation>Zurück auf %1</translation>
    </message>
    <message>
        <source>%1 back to %2</source>
        <translation>%1 zurück auf %2</translation>
    </message>
    <message>
        <source>It can be %1 to %2%3.</source>
        <translation>Möglich ist %1 bis %2%3.</translation>
    </message>
    <message>
        <source>%1 can be %2 to %3.</source>
        <translation>%1 kann %2 bis %3 sein.</translation>
    </message>
</context>
<context>
    <name>app::PlotCard</name>
    <message>
        <source>What is plotted</source>
        <translation>Was aufgetragen wird</translation>
    </message>
    <message>
        <source>Against what: time, or another quantity</source>
        <translation>Worüber: über der Zeit oder einer anderen Größe</translation>
    </message>
    <message>
        <source>Save, copy, keep or remove this plot</source>
        <translation>Dieses Diagramm speichern, kopieren, festhalten oder entfernen</translation>
    </message>
    <message>
        <source>What can be done with this plot</source>
        <translation>Was sich mit diesem Diagramm tun lässt</translation>
    </message>
    <message>
        <source>against</source>
        <translation>über</translation>
    </message>
    <message>
        <source>&amp;Keep to %1</source>
        <translation>Bei %1 &amp;bleiben</translation>
    </message>
    <message>
        <source>Off: it follows the body that is selected in the picture</source>
        <translation>Aus: Es folgt dem Körper, der in der Szene gewählt ist</translation>
    </message>
    <message>
        <source>&amp;Fewer frames	+</source>
        <translation>&amp;Weniger Bilder	+</translation>
    </message>
    <message>
        <source>&amp;More frames	−</source>
        <translation>&amp;Mehr Bilder	−</translation>
    </message>
    <message>
        <source>&amp;Remove this plot	Del</source>
        <translation>Diagramm &amp;entfernen	Entf</translation>
    </message>
</context>
<context>
    <name>app::PlotExport</name>
    <message>
        <source>Save the &amp;picture…</source>
        <translation>Bil&amp;d speichern …</translation>
    </message>
    <message>
        <source>&amp;Copy the picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>As PNG, SVG or PDF</source>
        <translation>Als PNG, SVG oder PDF</translation>
    </message>
    <message>
        <source>Save the &amp;numbers as CSV…</source>
        <translation>&amp;Zahlen als CSV speichern …</translation>
    </message>
    <message>
        <source>Every frame of the run, with all digits</source>
        <translation>Jedes Bild des Laufs, mit allen Stellen</translation>
    </message>
    <message>
        <source>Save or copy this plot</source>
        <translation>Dieses Diagramm speichern oder kopieren</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>The picture was not saved as %1: %2. Choose another folder, or make room.</source>
        <translation>Das Bild wurde nicht als %1 gespeichert: %2. Wähle einen anderen Ordner, oder schaffe Platz.</translation>
    </message>
    <message>
        <source>The picture is copied: paste it anywhere.</source>
        <translation>Das Bild ist kopiert: Füge es ein, wo du willst.</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Das Bild speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg *.pdf)</source>
        <translation>Bilder (*.png *.svg *.pdf)</translation>
    </message>
    <message>
        <source>Save the numbers</source>
        <translation>Die Zahlen speichern</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tabellen (*.csv)</translation>
    </message>
    <message>
        <source>There are no numbers to save: this plot shows nothing here.</source>
        <translation>Es gibt keine Zahlen zu speichern: Dieses Diagramm zeigt hier nichts.</translation>
    </message>
    <message>
        <source>Left off: nothing was saved.</source>
        <translation>Abgebrochen: Nichts wurde gespeichert.</translation>
    </message>
    <message>
        <source>All that is counted or measured here, with all digits</source>
        <translation>Alles, was hier gezählt oder gemessen ist, mit allen Stellen</translation>
    </message>
    <message>
        <source>The numbers were not saved as %1: %2. Choose another folder, or make room.</source>
        <translation>Die Zahlen wurden nicht als %1 gespeichert: %2. Wähle einen anderen Ordner, oder schaffe Platz.</translation>
    </message>
</context>
<context>
    <name>app::PlotValue</name>
    <message>
        <source>The number at the cursor</source>
        <translation>Die Zahl am Zeiger</translation>
    </message>
</context>
<context>
    <name>app::PlotsPanel</name>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Another plot</source>
        <translation>Noch ein Diagramm</translation>
    </message>
    <message>
        <source>Add a plot</source>
        <translation>Ein Diagramm hinzufügen</translation>
    </message>
    <message>
        <source>Nothing is plotted. &lt;b&gt;Add&lt;/b&gt;, above, has curves to begin with: how far down a body is, how fast it goes, or one quantity against another.</source>
        <translation>Es gibt noch kein Diagramm. &lt;b&gt;Neu&lt;/b&gt;, oben, hat Kurven für den Anfang: wie tief ein Körper ist, wie schnell er geht, oder eine Größe über einer anderen.</translation>
    </message>
    <message>
        <source>How much of the numbers is written</source>
        <translation>Wie viel von den Zahlen geschrieben ist</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Leave off; nothing is saved then</source>
        <translation>Abbrechen; dann wird nichts gespeichert</translation>
    </message>
    <message>
        <source>Saving numbers…</source>
        <translation>Zahlen werden gespeichert …</translation>
    </message>
    <message>
        <source>There are %1 plots: more would be too small to read. Remove one first.</source>
        <translation>Es gibt %1 Diagramme: Mehr wären zu klein zum Lesen. Entferne erst eines.</translation>
    </message>
    <message>
        <source>%1 against time</source>
        <translation>%1 über der Zeit</translation>
    </message>
    <message>
        <source>the path: y against x</source>
        <translation>die Bahn: y über x</translation>
    </message>
    <message>
        <source>velocity y against y</source>
        <translation>Geschwindigkeit y über y</translation>
    </message>
    <message>
        <source>turning speed against angle</source>
        <translation>Drehtempo über Winkel</translation>
    </message>
    <message>
        <source>Anything else: add one, and choose what it shows</source>
        <translation>Alles andere: eines hinzufügen und wählen, was es zeigt</translation>
    </message>
    <message>
        <source>The names above a plot are menus</source>
        <translation>Die Namen über einem Diagramm sind Menüs</translation>
    </message>
    <message>
        <source>the whole run</source>
        <translation>der ganze Lauf</translation>
    </message>
    <message>
        <source>frame %1 to %2</source>
        <translation>Bild %1 bis %2</translation>
    </message>
</context>
<context>
    <name>app::PresetGallery</name>
    <message>
        <source>Presets</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>%1 Starts this step anew.</source>
        <translation>%1 Beginnt diesen Schritt neu.</translation>
    </message>
</context>
<context>
    <name>app::PropertyRow</name>
    <message>
        <source>%1 From %2 to %3.</source>
        <translation>%1 Von %2 bis %3.</translation>
    </message>
    <message>
        <source>differ</source>
        <translation>verschieden</translation>
    </message>
    <message>
        <source>Change %1 of %2</source>
        <translation>%1 ändern: %2</translation>
    </message>
    <message>
        <source>Switch “%1” on</source>
        <translation>„%1“ einschalten</translation>
    </message>
    <message>
        <source>Switch “%1” off</source>
        <translation>„%1“ ausschalten</translation>
    </message>
</context>
<context>
    <name>app::QuantityMenu</name>
    <message>
        <source>… and %1 more</source>
        <translation>… und %1 weitere</translation>
    </message>
    <message>
        <source>Select one in the picture, then keep the plot to it</source>
        <translation>Wähle einen in der Szene, und lass das Diagramm dann bei ihm bleiben</translation>
    </message>
    <message>
        <source>distance to</source>
        <translation>Abstand zu</translation>
    </message>
    <message>
        <source>of which body</source>
        <translation>von welchem Körper</translation>
    </message>
    <message>
        <source>the selected one: %1</source>
        <translation>vom gewählten: %1</translation>
    </message>
</context>
<context>
    <name>app::QuantityPlot</name>
    <message>
        <source>%1 against %2</source>
        <translation>%1 über %2</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1: %2 at frame %3</source>
        <translation>%1: %2 bei Bild %3</translation>
    </message>
    <message>
        <source>Play, or step a frame: then a curve begins here.</source>
        <translation>Spiele ab, oder geh ein Bild weiter: Dann beginnt hier eine Kurve.</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>frame %1: %2</source>
        <translation>Bild %1: %2</translation>
    </message>
    <message>
        <source>%1: %2 inside frame %3</source>
        <translation>%1: %2 innerhalb von Bild %3</translation>
    </message>
</context>
<context>
    <name>app::RemedySearch</name>
    <message>
        <source>Computes the run again with that, up to this frame. What you did is kept, and the old run stays as a ghost.</source>
        <translation>Berechnet den Lauf damit noch einmal, bis zu diesem Bild. Was du getan hast, bleibt, und der alte Lauf bleibt als Geist.</translation>
    </message>
    <message>
        <source>Not tried out: that would take long.</source>
        <translation>Nicht ausprobiert: Das würde lange dauern.</translation>
    </message>
    <message numerus="yes">
        <source>Tried out: it holds for %n frames.</source>
        <translation>
            <numerusform>Ausprobiert: Es hält %n Bild lang.</numerusform>
            <numerusform>Ausprobiert: Es hält %n Bilder lang.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::RunPlot</name>
    <message>
        <source>Error over the run</source>
        <translation>Fehler über den Lauf</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>how far off, px</source>
        <translation>Abweichung, px</translation>
    </message>
    <message>
        <source>← more exact</source>
        <translation>← genauer</translation>
    </message>
    <message>
        <source>Frame %1: %2 off</source>
        <translation>Bild %1: %2 Abweichung</translation>
    </message>
</context>
<context>
    <name>app::RunsMenu</name>
    <message>
        <source>Other r&amp;uns</source>
        <translation>An&amp;dere Läufe</translation>
    </message>
    <message>
        <source>No other run yet</source>
        <translation>Noch kein anderer Lauf</translation>
    </message>
    <message>
        <source>Go back in time and change something: the run as it was stays as another run.</source>
        <translation>Geh in der Zeit zurück und ändere etwas: Der Lauf, wie er war, bleibt als anderer Lauf.</translation>
    </message>
    <message>
        <source>Show none &amp;beside</source>
        <translation>&amp;Keinen daneben zeigen</translation>
    </message>
    <message>
        <source>Only this run is seen; the others stay in this menu</source>
        <translation>Nur dieser Lauf ist zu sehen; die anderen bleiben in diesem Menü</translation>
    </message>
    <message>
        <source>&amp;Compare in numbers</source>
        <translation>In &amp;Zahlen vergleichen</translation>
    </message>
    <message>
        <source>How far the two runs are apart, frame by frame</source>
        <translation>Wie weit die zwei Läufe auseinander sind, Bild für Bild</translation>
    </message>
    <message>
        <source>&amp;Show beside</source>
        <translation>&amp;Daneben zeigen</translation>
    </message>
    <message>
        <source>As a ghost in the picture, and as dots in the timeline</source>
        <translation>Als Geist in der Szene und als Punkte in der Zeitleiste</translation>
    </message>
    <message>
        <source>&amp;Go back to it</source>
        <translation>&amp;Zu ihm zurückgehen</translation>
    </message>
    <message>
        <source>It is the run again, exactly as it was; this run becomes another run</source>
        <translation>Er ist wieder der Lauf, genau wie er war; dieser wird ein anderer Lauf</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Behalten</translation>
    </message>
    <message>
        <source>It stays until you delete it. Of those that are not kept, the last %1 stay.</source>
        <translation>Er bleibt, bis du ihn löschst. Von denen, die du nicht behältst, bleiben die letzten %1.</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Umbenennen …</translation>
    </message>
    <message>
        <source>Give this run a name of your own</source>
        <translation>Diesem Lauf einen eigenen Namen geben</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>It is gone, unless you undo this</source>
        <translation>Er ist weg, es sei denn, du machst das rückgängig</translation>
    </message>
</context>
<context>
    <name>app::SceneBar</name>
    <message>
        <source>How the run is computed from one step to the next</source>
        <translation>Wie der Lauf von einem Zeitschritt zum nächsten berechnet wird</translation>
    </message>
    <message>
        <source>How much time one step of the method covers</source>
        <translation>Wie viel Zeit ein Zeitschritt des Verfahrens umfasst</translation>
    </message>
    <message>
        <source>What the picture shows besides the creature</source>
        <translation>Was die Szene außer der Figur zeigt</translation>
    </message>
    <message>
        <source>Zoom to 100&#x2009;%</source>
        <translation>Auf 100&#x2009;% zoomen</translation>
    </message>
    <message>
        <source>Show the whole stage with all bodies, and stay with them (Ctrl+0)</source>
        <translation>Die ganze Bühne mit allen Körpern zeigen und bei ihnen bleiben (Strg+0)</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>The error that each of the method&apos;s own steps may make</source>
        <translation>Der Fehler, den jeder eigene Zeitschritt des Verfahrens machen darf</translation>
    </message>
    <message>
        <source>Trails</source>
        <translation>Spuren</translation>
    </message>
    <message>
        <source>Velocity arrows</source>
        <translation>Geschwindigkeitspfeile</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Gitter</translation>
    </message>
    <message>
        <source>Explaining lines</source>
        <translation>Erklärende Linien</translation>
    </message>
    <message>
        <source>Eyes</source>
        <translation>Augen</translation>
    </message>
    <message>
        <source>Ghost</source>
        <translation>Geist</translation>
    </message>
    <message>
        <source>Onion skins</source>
        <translation>Zwiebelschalen</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referenz</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Toleranz</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>%1&#x2009;%</source>
        <translation>%1&#x2009;%</translation>
    </message>
    <message>
        <source>Zoom %1</source>
        <translation>Zoom %1</translation>
    </message>
    <message>
        <source>Pulls of all forces</source>
        <translation>Züge aller Kräfte</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>Lineal</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Uhr</translation>
    </message>
    <message>
        <source>Rest lengths</source>
        <translation>Ruhelängen</translation>
    </message>
</context>
<context>
    <name>app::SceneCard</name>
    <message>
        <source>Done: all there is to try here. Page Down opens the next step.</source>
        <translation>Fertig: alles, was es hier zu probieren gibt. Bild ab öffnet den nächsten Schritt.</translation>
    </message>
    <message>
        <source>Done: all there is to try here.</source>
        <translation>Fertig: alles, was es hier zu probieren gibt.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>app::SceneKeeper</name>
    <message>
        <source>the folder %1 cannot be made</source>
        <translation>der Ordner %1 lässt sich nicht anlegen</translation>
    </message>
    <message>
        <source>no file can be locked in %1</source>
        <translation>in %1 lässt sich keine Datei sperren</translation>
    </message>
    <message>
        <source>What you do is not kept against a crash: %1. Make room there, or save as a file.</source>
        <translation>Was du tust, ist nicht gegen einen Absturz gesichert: %1. Schaffe dort Platz, oder speichere in eine Datei.</translation>
    </message>
</context>
<context>
    <name>app::SceneView</name>
    <message>
        <source>%1: outside of the picture. Click, or press O, to bring it into view.</source>
        <translation>%1: außerhalb des Bildes. Ein Klick oder die Taste O holt es ins Bild.</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Beside it: %1</source>
        <translation>Daneben: %1</translation>
    </message>
    <message>
        <source>frame %1 = %2&#x2009;s</source>
        <translation>Bild %1 = %2&#x2009;s</translation>
    </message>
    <message>
        <source>Only a look: this is frame %1.</source>
        <translation>Nur ein Blick: Das ist Bild %1.</translation>
    </message>
    <message>
        <source>Only a look. %1</source>
        <translation>Nur ein Blick. %1</translation>
    </message>
    <message>
        <source>The hand of the recorded run is at %1, %2</source>
        <translation>Die Hand des aufgezeichneten Laufs ist bei %1, %2</translation>
    </message>
</context>
<context>
    <name>app::Session</name>
    <message>
        <source>your hand</source>
        <translation>deine Hand</translation>
    </message>
    <message>
        <source>before: %1</source>
        <translation>vorher: %1</translation>
    </message>
    <message>
        <source>the pointer</source>
        <translation>der Zeiger</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>das Ziel</translation>
    </message>
    <message>
        <source>the keys</source>
        <translation>die Tasten</translation>
    </message>
    <message>
        <source>%1 off</source>
        <translation>%1 aus</translation>
    </message>
    <message>
        <source>%1 on</source>
        <translation>%1 an</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Too much to compute for 30 frames a second: it plays slower than that. The run stays the same.</source>
        <translation>Zu viel zu berechnen für 30 Bilder pro Sekunde: Es läuft langsamer ab. Der Lauf bleibt derselbe.</translation>
    </message>
    <message>
        <source>Start afresh</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>undone: %1</source>
        <translation>rückgängig: %1</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>Rückgängig: %1.</translation>
    </message>
    <message>
        <source>The run as it was stays beside this one, as “%1”.</source>
        <translation>Der Lauf, wie er war, bleibt neben diesem, als „%1“.</translation>
    </message>
    <message>
        <source>after: %1</source>
        <translation>nachher: %1</translation>
    </message>
    <message>
        <source>Computing “%1” again: frame %2 of %3. Esc stops.</source>
        <translation>„%1“ wird noch einmal berechnet: Bild %2 von %3. Esc hält an.</translation>
    </message>
    <message>
        <source>Stopped: “%1” is not shown. It can be shown again from “Runs”.</source>
        <translation>Angehalten: „%1“ ist nicht zu sehen. Über „Läufe“ lässt er sich wieder zeigen.</translation>
    </message>
    <message>
        <source>the first run</source>
        <translation>der erste Lauf</translation>
    </message>
    <message>
        <source>Go back to “%1”</source>
        <translation>Zurück zu „%1“</translation>
    </message>
    <message>
        <source>This is “%1” again. The run that you left is a branch now.</source>
        <translation>Das ist wieder „%1“. Der Lauf, den du verlassen hast, ist jetzt einer der anderen Läufe.</translation>
    </message>
    <message>
        <source>Keep run</source>
        <translation>Lauf behalten</translation>
    </message>
    <message>
        <source>Stop keeping run</source>
        <translation>Lauf nicht mehr behalten</translation>
    </message>
    <message>
        <source>Rename run</source>
        <translation>Lauf umbenennen</translation>
    </message>
    <message>
        <source>Delete run</source>
        <translation>Lauf löschen</translation>
    </message>
    <message>
        <source>Drag %1</source>
        <translation>%1 ziehen</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>Alle Parameter zurücksetzen</translation>
    </message>
    <message>
        <source>Change step</source>
        <translation>Zeitschritt ändern</translation>
    </message>
    <message>
        <source>Change method</source>
        <translation>Verfahren ändern</translation>
    </message>
    <message>
        <source>Apply remedy</source>
        <translation>Abhilfe anwenden</translation>
    </message>
    <message>
        <source>a remedy</source>
        <translation>einer Abhilfe</translation>
    </message>
    <message>
        <source>Move pointer</source>
        <translation>Zeiger bewegen</translation>
    </message>
    <message>
        <source>Set target</source>
        <translation>Ziel setzen</translation>
    </message>
    <message>
        <source>Press arrow keys</source>
        <translation>Pfeiltasten drücken</translation>
    </message>
    <message>
        <source>Choose “%1”</source>
        <translation>„%1“ wählen</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>Wiederholt: %1.</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neu starten</translation>
    </message>
    <message>
        <source>the restart</source>
        <translation>Neustart</translation>
    </message>
    <message>
        <source>A fresh run. The run as it was is under “Runs”, and undo (Ctrl+Z) brings it back.</source>
        <translation>Ein frischer Lauf. Der Lauf von vorher steht unter „Läufe“, und Rückgängig (Strg+Z) bringt ihn zurück.</translation>
    </message>
    <message>
        <source>Time runs while your hand moves things. Space stops it.</source>
        <translation>Die Zeit läuft, während deine Hand etwas bewegt. Die Leertaste hält sie an.</translation>
    </message>
    <message>
        <source>Time stands still. Space lets it run from here.</source>
        <translation>Die Zeit steht still. Die Leertaste lässt sie von hier aus laufen.</translation>
    </message>
</context>
<context>
    <name>app::SpeedButton</name>
    <message>
        <source>Playing speed (− and +). It never changes the step</source>
        <translation>Abspieltempo (− und +). Den Zeitschritt ändert es nie</translation>
    </message>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Playing speed %1, %2</source>
        <translation>Abspieltempo %1, %2</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 Bilder/s</translation>
    </message>
</context>
<context>
    <name>app::SpotPlot</name>
    <message>
        <source>Points: %1. Arrow keys walk through them, Enter uses one.</source>
        <translation>Punkte: %1. Pfeiltasten gehen durch sie hindurch, Eingabe verwendet einen.</translation>
    </message>
</context>
<context>
    <name>app::StabilityGauge</name>
    <message>
        <source>Stability</source>
        <translation>Stabilität</translation>
    </message>
    <message>
        <source>Click for the reasons, and for what would mend it (Ctrl+L).</source>
        <translation>Ein Klick zeigt die Gründe und was helfen würde (Strg+L).</translation>
    </message>
    <message>
        <source>%1&#x2009;% of the limit</source>
        <translation>%1&#x2009;% der Grenze</translation>
    </message>
    <message>
        <source>Looking at frame %1: %2</source>
        <translation>Ein Blick auf Bild %1: %2</translation>
    </message>
</context>
<context>
    <name>app::StabilityPanel</name>
    <message>
        <source>Stability</source>
        <translation>Stabilität</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close, and show what was here before (Ctrl+L)</source>
        <translation>Schließen und zeigen, was vorher hier war (Strg+L)</translation>
    </message>
    <message>
        <source>What would help</source>
        <translation>Was helfen würde</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Stiffness and step</source>
        <translation>k und Zeitschritt</translation>
    </message>
    <message>
        <source>Which stiffness and which step hold, all else as it is; again to close</source>
        <translation>Welche Steifigkeit und welcher Zeitschritt halten, alles andere wie jetzt; noch einmal, um zu schließen</translation>
    </message>
    <message>
        <source>Stiffness and damping</source>
        <translation>k und Dämpfung</translation>
    </message>
    <message>
        <source>Which stiffness and which damping hold, all else as it is; again to close</source>
        <translation>Welche Steifigkeit und welche Dämpfung halten, alles andere wie jetzt; noch einmal, um zu schließen</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>There is no map for this step: it has no stiffness k to change.</source>
        <translation>Für diesen Schritt gibt es keine Karte: Er hat keine Steifigkeit k, die man ändern könnte.</translation>
    </message>
    <message>
        <source>There is no map here: no springs act, so any stiffness and any step hold.</source>
        <translation>Hier gibt es keine Karte: Es wirkt keine Feder, also hält jede Steifigkeit und jeder Zeitschritt.</translation>
    </message>
    <message>
        <source>There is no map for this method: no stiffness is too much for its step.</source>
        <translation>Für dieses Verfahren gibt es keine Karte: Keine Steifigkeit ist zu viel für seinen Zeitschritt.</translation>
    </message>
</context>
<context>
    <name>app::StatusFigures</name>
    <message>
        <source>How many points the scene has: each body, foot or joint is one</source>
        <translation>Wie viele Punkte die Szene hat: Jeder Körper, jeder Fuß und jedes Gelenk ist einer</translation>
    </message>
    <message>
        <source>How often a frame computes all forces: that is its work</source>
        <translation>Wie oft ein Bild alle Kräfte berechnet: Das ist seine Arbeit</translation>
    </message>
    <message>
        <source>What computing a frame of this scene takes on this machine, in the middle of many runs</source>
        <translation>Was es auf diesem Rechner kostet, ein Bild dieser Szene zu berechnen, im Mittel vieler Läufe</translation>
    </message>
    <message>
        <source>How far the body that is worst off ever is from the exact motion, over these frames</source>
        <translation>Wie weit der ungenaueste Körper in diesen Bildern höchstens von der exakten Bewegung abweicht</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 Punkt</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>%1 a frame</source>
        <translation>%1 pro Bild</translation>
    </message>
    <message>
        <source>%1 off over %2 frames</source>
        <translation>%1 daneben in %2 Bildern</translation>
    </message>
    <message>
        <source>forces once a frame</source>
        <translation>Kräfte einmal/Bild</translation>
    </message>
    <message>
        <source>forces %1 times a frame</source>
        <translation>Kräfte %1-mal/Bild</translation>
    </message>
    <message>
        <source>forces %1 times a frame until now</source>
        <translation>Kräfte bisher %1-mal/Bild</translation>
    </message>
</context>
<context>
    <name>app::StatusLine</name>
    <message>
        <source>A look inside frame %1. The run stays where it is.</source>
        <translation>Ein Blick in Bild %1 hinein. Der Lauf bleibt, wo er ist.</translation>
    </message>
    <message>
        <source>A look at frame %1. The run stays at frame %2.</source>
        <translation>Ein Blick auf Bild %1. Der Lauf bleibt bei Bild %2.</translation>
    </message>
    <message>
        <source>Everything rests. Touch something, or press &lt;b&gt;Space&lt;/b&gt; to stop.</source>
        <translation>Alles ruht. Fass etwas an, oder drück die &lt;b&gt;Leertaste&lt;/b&gt;, um anzuhalten.</translation>
    </message>
    <message>
        <source>Playing. Press &lt;b&gt;Space&lt;/b&gt; to stop anywhere.</source>
        <translation>Läuft. Drück die &lt;b&gt;Leertaste&lt;/b&gt;, um irgendwo anzuhalten.</translation>
    </message>
    <message>
        <source>Inside frame %1, after %2. &lt;b&gt;Shift+→&lt;/b&gt; next phase, &lt;b&gt;→&lt;/b&gt; next frame.</source>
        <translation>Innerhalb von Bild %1, nach „%2“. &lt;b&gt;Umschalt+→&lt;/b&gt; nächste Phase, &lt;b&gt;→&lt;/b&gt; nächstes Bild.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Space&lt;/b&gt; plays, &lt;b&gt;→&lt;/b&gt; next frame, &lt;b&gt;Shift+→&lt;/b&gt; into the frame. Drag anything.</source>
        <translation>&lt;b&gt;Leertaste&lt;/b&gt; spielt ab, &lt;b&gt;→&lt;/b&gt; nächstes Bild, &lt;b&gt;Umschalt+→&lt;/b&gt; ins Bild. Zieh an etwas.</translation>
    </message>
</context>
<context>
    <name>app::StepMenu</name>
    <message>
        <source>Other:</source>
        <translation>Andere:</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>From 1e-13 to 100 px; Enter takes it</source>
        <translation>Von 1e-13 bis 100 px; Eingabe übernimmt</translation>
    </message>
    <message>
        <source>1 divided by a whole number, or a whole number, in frames; Enter takes it</source>
        <translation>1 geteilt durch eine ganze Zahl oder eine ganze Zahl, in Bildern; Eingabe übernimmt</translation>
    </message>
    <message>
        <source>Other tolerance, in px</source>
        <translation>Andere Toleranz, in px</translation>
    </message>
    <message>
        <source>Other step, in frames</source>
        <translation>Anderer Zeitschritt, in Bildern</translation>
    </message>
</context>
<context>
    <name>app::StopList</name>
    <message>
        <source>when</source>
        <translation>wenn</translation>
    </message>
    <message>
        <source>Stop when</source>
        <translation>Anhalten, wenn</translation>
    </message>
    <message>
        <source>Stops the run as soon as this comes true, also inside a frame.
There are x, y, vx, vy of bodies, frame, phase, and all parameters;
+ - * / ( ), &lt; &lt;= &gt; &gt;= == !=, and, or, not, abs(), sqrt().
Enter adds it.</source>
        <translation>Hält den Lauf an, sobald das wahr wird, auch innerhalb eines Bildes.
Es gibt x, y, vx, vy von Körpern, frame, phase und alle Parameter;
+ - * / ( ), &lt; &lt;= &gt; &gt;= == !=, and, or, not, abs(), sqrt().
Eingabe fügt es hinzu.</translation>
    </message>
    <message>
        <source>always, or when…</source>
        <translation>immer, oder wenn …</translation>
    </message>
    <message>
        <source>Condition of the stop %1</source>
        <translation>Bedingung des Haltepunkts %1</translation>
    </message>
    <message>
        <source>Stops before this line&apos;s phase where this holds. Enter keeps what you typed.</source>
        <translation>Hält vor der Phase dieser Zeile an, wo das gilt. Eingabe behält, was du getippt hast.</translation>
    </message>
    <message>
        <source>Stops where this comes true. Enter keeps what you typed.</source>
        <translation>Hält an, wo das wahr wird. Eingabe behält, was du getippt hast.</translation>
    </message>
    <message>
        <source>Whether to stop before this line (%1)</source>
        <translation>Ob vor dieser Zeile angehalten wird (%1)</translation>
    </message>
    <message>
        <source>Whether to stop when this comes true</source>
        <translation>Ob angehalten wird, wenn das wahr wird</translation>
    </message>
    <message>
        <source>Stop %1 %2</source>
        <translation>Haltepunkt %1 %2</translation>
    </message>
    <message>
        <source>Take this stop away</source>
        <translation>Diesen Haltepunkt entfernen</translation>
    </message>
    <message>
        <source>Take the stop %1 %2 away</source>
        <translation>Den Haltepunkt %1 %2 entfernen</translation>
    </message>
    <message>
        <source>Stop when… (%1.y &gt; 300)</source>
        <translation>Anhalten, wenn … (%1.y &gt; 300)</translation>
    </message>
</context>
<context>
    <name>app::StopNotice</name>
    <message>
        <source>Trying out what would mend it…</source>
        <translation>Was würde es heilen? Wird ausprobiert …</translation>
    </message>
    <message>
        <source>No smaller step and no other method was found to hold. Go back, and change what made it so.</source>
        <translation>Kein kleinerer Zeitschritt und kein anderes Verfahren hielt stand. Geh zurück und ändere, was dazu geführt hat.</translation>
    </message>
</context>
<context>
    <name>app::SummaryPage</name>
    <message>
        <source>Back to the step</source>
        <translation>Zurück zum Schritt</translation>
    </message>
    <message>
        <source>%1: what you learnt</source>
        <translation>%1: was du gelernt hast</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Weiter: %1</translation>
    </message>
    <message>
        <source>The last lesson</source>
        <translation>Die letzte Lektion</translation>
    </message>
    <message>
        <source>No lesson comes after this one.</source>
        <translation>Danach kommt keine Lektion mehr.</translation>
    </message>
    <message>
        <source>Bring the ticks back</source>
        <translation>Häkchen zurückholen</translation>
    </message>
    <message>
        <source>Start this lesson over</source>
        <translation>Lektion neu beginnen</translation>
    </message>
    <message>
        <source>Ticks everything again that was ticked before</source>
        <translation>Hakt alles wieder ab, was vorher abgehakt war</translation>
    </message>
    <message>
        <source>Takes its ticks away. They can be brought back.</source>
        <translation>Nimmt ihre Häkchen weg. Sie lassen sich zurückholen.</translation>
    </message>
    <message>
        <source>Nothing is ticked in this lesson yet.</source>
        <translation>In dieser Lektion ist noch nichts abgehakt.</translation>
    </message>
    <message>
        <source>%1 of %2 things tried.</source>
        <translation>%1 von %2 Dingen ausprobiert.</translation>
    </message>
    <message>
        <source>Still to try: %1</source>
        <translation>Noch auszuprobieren: %1</translation>
    </message>
    <message>
        <source>**Next: %1.** %2</source>
        <translation>**Weiter: %1.** %2</translation>
    </message>
</context>
<context>
    <name>app::TimelineStrip</name>
    <message>
        <source>%1: phase %2 of %3. Click to run to it.</source>
        <translation>%1: Phase %2 von %3. Ein Klick läuft bis dorthin.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>%1 other runs part from this one at frame %2. Click to choose one.</source>
        <translation>%1 andere Läufe zweigen bei Bild %2 von diesem ab. Ein Klick, um einen zu wählen.</translation>
    </message>
    <message>
        <source>Another run: %1. Click to show it beside this one, right-click for more.</source>
        <translation>Ein anderer Lauf: %1. Ein Klick zeigt ihn neben diesem, ein Rechtsklick mehr.</translation>
    </message>
    <message>
        <source>Beside this run: %1. Right-click for what you can do with it.</source>
        <translation>Neben diesem Lauf: %1. Ein Rechtsklick zeigt, was sich damit tun lässt.</translation>
    </message>
    <message>
        <source>%1. Looking at: %2</source>
        <translation>%1. Ein Blick auf: %2</translation>
    </message>
    <message>
        <source>Left and Right: one frame. With Shift: one phase. Home: restart. With Shift: repeat the run. End: the last computed frame. Menu: the other runs.</source>
        <translation>Links und Rechts: ein Bild. Mit Umschalt: eine Phase. Pos1: neu starten. Mit Umschalt: den Lauf wiederholen. Ende: das letzte berechnete Bild. Menü: die anderen Läufe.</translation>
    </message>
</context>
<context>
    <name>app::Tour</name>
    <message>
        <source>Skip</source>
        <translation>Überspringen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Ends the tour (Esc). It is in the Help menu.</source>
        <translation>Beendet den Rundgang (Esc). Er steht im Menü „Hilfe“.</translation>
    </message>
    <message>
        <source>The card before</source>
        <translation>Die Karte davor</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Ends the tour (Enter)</source>
        <translation>Beendet den Rundgang (Eingabe)</translation>
    </message>
    <message>
        <source>The next card (Enter)</source>
        <translation>Die nächste Karte (Eingabe)</translation>
    </message>
</context>
<context>
    <name>app::TransportBar</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Go to frame…</source>
        <translation>Zu Bild gehen …</translation>
    </message>
    <message>
        <source>going to %1… Esc stops</source>
        <translation>geht zu %1 … Esc hält an</translation>
    </message>
    <message>
        <source>going to %1…</source>
        <translation>geht zu %1 …</translation>
    </message>
    <message>
        <source>· %1</source>
        <translation>· %1</translation>
    </message>
    <message>
        <source>This is frame 0: nothing comes before it.</source>
        <translation>Das ist Bild 0: Davor kommt nichts.</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>One phase back</source>
        <translation>Eine Phase zurück</translation>
    </message>
    <message>
        <source>Shift+←</source>
        <translation>Umschalt+←</translation>
    </message>
    <message>
        <source>Back to the start of this frame</source>
        <translation>Zurück zum Anfang dieses Bildes</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Ein Bild zurück</translation>
    </message>
    <message>
        <source>←</source>
        <translation>←</translation>
    </message>
    <message>
        <source>On to the end of this frame</source>
        <translation>Weiter zum Ende dieses Bildes</translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation>Ein Bild weiter</translation>
    </message>
    <message>
        <source>→</source>
        <translation>→</translation>
    </message>
    <message>
        <source>One phase forward</source>
        <translation>Eine Phase weiter</translation>
    </message>
    <message>
        <source>Shift+→</source>
        <translation>Umschalt+→</translation>
    </message>
    <message>
        <source>Stop here</source>
        <translation>Hier anhalten</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Other runs: none yet</source>
        <translation>Andere Läufe: noch keiner</translation>
    </message>
    <message>
        <source>Other runs: one</source>
        <translation>Andere Läufe: einer</translation>
    </message>
    <message>
        <source>Other runs: %1</source>
        <translation>Andere Läufe: %1</translation>
    </message>
    <message>
        <source>Ctrl+Shift+R</source>
        <translation>Strg+Umschalt+R</translation>
    </message>
    <message>
        <source>Go back in time and change something: the run as it was stays, and is found here.</source>
        <translation>Geh in der Zeit zurück und ändere etwas: Der Lauf, wie er war, bleibt und ist hier zu finden.</translation>
    </message>
    <message>
        <source>· looking: %1</source>
        <translation>· Blick: %1</translation>
    </message>
    <message>
        <source>· looking at frame %1</source>
        <translation>· Blick auf Bild %1</translation>
    </message>
    <message>
        <source>· at %1</source>
        <translation>· bei %1</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neu starten</translation>
    </message>
    <message>
        <source>A fresh run from frame 0, with the parameters as they are now.</source>
        <translation>Ein frischer Lauf ab Bild 0, mit den Parametern, wie sie jetzt sind.</translation>
    </message>
    <message>
        <source>Shift+Home repeats this run instead, with all that was done in it.</source>
        <translation>Umschalt+Pos1 wiederholt stattdessen diesen Lauf, mit allem, was darin getan wurde.</translation>
    </message>
</context>
<context>
    <name>app::TryBox</name>
    <message>
        <source>Hint: %1</source>
        <translation>Tipp: %1</translation>
    </message>
    <message>
        <source>Put the hint away</source>
        <translation>Den Tipp weglegen</translation>
    </message>
    <message>
        <source>Show a hint (H)</source>
        <translation>Einen Tipp zeigen (H)</translation>
    </message>
    <message>
        <source>Put the answer away</source>
        <translation>Antwort weglegen</translation>
    </message>
    <message>
        <source>Show the answer</source>
        <translation>Antwort zeigen</translation>
    </message>
    <message>
        <source>Answer: %1</source>
        <translation>Antwort: %1</translation>
    </message>
    <message>
        <source>**Still to do:** %1</source>
        <translation>**Noch zu tun:** %1</translation>
    </message>
</context>
<context>
    <name>app::TryRow</name>
    <message>
        <source>Springstep ticks this when it sees you do it.</source>
        <translation>Springstep hakt das ab, wenn es sieht, dass du es tust.</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 geschafft</translation>
    </message>
    <message>
        <source>%1 not yet</source>
        <translation>%1 noch nicht</translation>
    </message>
</context>
<context>
    <name>app::WhyButton</name>
    <message>
        <source>Fold the answer</source>
        <translation>Antwort zuklappen</translation>
    </message>
    <message>
        <source>Show the answer</source>
        <translation>Antwort zeigen</translation>
    </message>
    <message>
        <source>open</source>
        <translation>aufgeklappt</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>zugeklappt</translation>
    </message>
</context>
<context>
    <name>app::WordCard</name>
    <message>
        <source>Taught in</source>
        <translation>Gelehrt in</translation>
    </message>
    <message>
        <source>All words</source>
        <translation>Alle Begriffe</translation>
    </message>
</context>
<context>
    <name>app::WorkPrecisionPlot</name>
    <message>
        <source>you are here</source>
        <translation>du bist hier</translation>
    </message>
    <message>
        <source>The front: nothing is
as exact for less.</source>
        <translation>Die Bestlinie: Nichts ist
für weniger so genau.</translation>
    </message>
    <message>
        <source>Error against time</source>
        <translation>Fehler und Zeit</translation>
    </message>
    <message>
        <source>time to compute a frame, µs</source>
        <translation>Zeit zum Berechnen eines Bildes, µs</translation>
    </message>
    <message>
        <source>forces computed a frame (times come next)</source>
        <translation>berechnete Kräfte pro Bild (Zeiten folgen)</translation>
    </message>
    <message>
        <source>how far off at most, px</source>
        <translation>größte Abweichung, px</translation>
    </message>
    <message>
        <source>← faster</source>
        <translation>← schneller</translation>
    </message>
    <message>
        <source>← more exact</source>
        <translation>← genauer</translation>
    </message>
    <message>
        <source>A frame is on the screen
for %1&#x2009;µs (30 a second)</source>
        <translation>Ein Bild steht %1&#x2009;µs
auf dem Schirm (30 pro Sekunde)</translation>
    </message>
</context>
<context>
    <name>app::Workbench</name>
    <message>
        <source>Building happens at the start of the run: press Home to go there.</source>
        <translation>Gebaut wird am Anfang des Laufs: Drück Pos1, um dorthin zu gehen.</translation>
    </message>
    <message>
        <source>There is no room for more of this kind: delete something first.</source>
        <translation>Für mehr von dieser Art ist kein Platz: Lösche erst etwas.</translation>
    </message>
    <message>
        <source>This point is a foot already: it can be the foot of one body.</source>
        <translation>Dieser Punkt ist schon ein Fuß: Er kann der Fuß eines einzigen Körpers sein.</translation>
    </message>
    <message>
        <source>A scene needs at least one point that can move: leave one.</source>
        <translation>Eine Szene braucht mindestens einen Punkt, der sich bewegen kann: Lass einen übrig.</translation>
    </message>
    <message>
        <source>There is no room for a copy of all that: choose fewer parts, or delete some first.</source>
        <translation>Für eine Kopie von all dem ist kein Platz: Wähle weniger Teile oder lösche erst welche.</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 Teile</translation>
    </message>
    <message>
        <source>stick</source>
        <translation>Stab</translation>
    </message>
    <message>
        <source>spring</source>
        <translation>Feder</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Punkt hinzufügen</translation>
    </message>
    <message>
        <source>Add nail</source>
        <translation>Nagel hinzufügen</translation>
    </message>
    <message>
        <source>Free %1</source>
        <translation>%1 lösen</translation>
    </message>
    <message>
        <source>Nail %1 down</source>
        <translation>%1 festnageln</translation>
    </message>
    <message>
        <source>Add spring</source>
        <translation>Feder hinzufügen</translation>
    </message>
    <message>
        <source>Add stick</source>
        <translation>Stab hinzufügen</translation>
    </message>
    <message>
        <source>Add foot</source>
        <translation>Fuß hinzufügen</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 bewegen</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>%1 verdoppeln</translation>
    </message>
    <message>
        <source>Add gait group</source>
        <translation>Ganggruppe hinzufügen</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>an event</source>
        <translation>ein Ereignis</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a parameter&apos;s id</source>
        <translation>die Kennung eines Parameters</translation>
    </message>
    <message>
        <source>a value of that parameter</source>
        <translation>ein Wert dieses Parameters</translation>
    </message>
    <message>
        <source>joint limits</source>
        <translation>Gelenkgrenzen</translation>
    </message>
    <message>
        <source>area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>spring</source>
        <translation>Feder</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>gait clock</source>
        <translation>Ganguhr</translation>
    </message>
    <message>
        <source>gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>gust runs on</source>
        <translation>Bö läuft weiter</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>Gelenke</translation>
    </message>
    <message>
        <source>legs</source>
        <translation>Beine</translation>
    </message>
    <message>
        <source>motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>anticipation</source>
        <translation>Ausholen</translation>
    </message>
    <message>
        <source>pointer</source>
        <translation>Zeiger</translation>
    </message>
    <message>
        <source>push</source>
        <translation>Abstoßen</translation>
    </message>
    <message>
        <source>springs</source>
        <translation>Federn</translation>
    </message>
    <message>
        <source>return to rest</source>
        <translation>Rückkehr zur Ruhe</translation>
    </message>
    <message>
        <source>room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>soft sticks</source>
        <translation>weiche Stäbe</translation>
    </message>
    <message>
        <source>drag along, across</source>
        <translation>Bremsen längs, quer</translation>
    </message>
    <message>
        <source>steering</source>
        <translation>Lenkung</translation>
    </message>
    <message>
        <source>sticks</source>
        <translation>Stäbe</translation>
    </message>
    <message>
        <source>wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>turn round</source>
        <translation>Umkehren</translation>
    </message>
    <message>
        <source>turn to the pointer</source>
        <translation>Drehen zum Zeiger</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>Wände</translation>
    </message>
    <message>
        <source>Done by the hand</source>
        <translation>Von der Hand geleistet</translation>
    </message>
    <message>
        <source>Changed with a number</source>
        <translation>Mit einer Zahl geändert</translation>
    </message>
    <message>
        <source>Done by what drives</source>
        <translation>Von Antrieben geleistet</translation>
    </message>
    <message>
        <source>Done by wind</source>
        <translation>Vom Wind geleistet</translation>
    </message>
    <message>
        <source>Done by one-way pulls</source>
        <translation>Von einseitigen Zügen geleistet</translation>
    </message>
    <message>
        <source>Given by gravity</source>
        <translation>Von der Schwerkraft gegeben</translation>
    </message>
    <message>
        <source>Given by what stands fast</source>
        <translation>Von Feststehendem gegeben</translation>
    </message>
    <message>
        <source>Lost by damping</source>
        <translation>Durch Dämpfung verloren</translation>
    </message>
    <message>
        <source>At impacts</source>
        <translation>Bei Stößen</translation>
    </message>
    <message>
        <source>Changed by sticks</source>
        <translation>Durch Stäbe geändert</translation>
    </message>
    <message>
        <source>Drift of the method</source>
        <translation>Drift des Verfahrens</translation>
    </message>
    <message>
        <source>pressed into one px</source>
        <translation>in einen Pixel gepresst</translation>
    </message>
    <message>
        <source>Twelve feet stand within 1 px of their body, on springs of stiffness a million that are 50 px long: pressed together they turn over at a touch.</source>
        <translation>Zwölf Füße stehen innerhalb von 1 px um ihren Körper, an Federn der Steifigkeit eine Million, die 50 px lang sind: So zusammengepresst, überschlagen sie sich bei jeder Berührung.</translation>
    </message>
    <message>
        <source>the pair that runs away</source>
        <translation>das Paar, das davonläuft</translation>
    </message>
    <message>
        <source>A foot and a body pull each other, but one after the other: so the pair drives itself on, though nothing pushes it.</source>
        <translation>Ein Fuß und ein Körper ziehen einander, aber nacheinander: So treibt sich das Paar selbst an, obwohl nichts es schiebt.</translation>
    </message>
    <message>
        <source>sixty feet</source>
        <translation>sechzig Füße</translation>
    </message>
    <message>
        <source>Each foot alone is soft, but sixty together pull the body too hard for a step.</source>
        <translation>Jeder Fuß für sich ist weich, aber sechzig zusammen ziehen zu stark am Körper für einen Zeitschritt.</translation>
    </message>
    <message>
        <source>a hundred feet</source>
        <translation>hundert Füße</translation>
    </message>
    <message>
        <source>A hundred soft springs on one body make a stiff one.</source>
        <translation>Hundert weiche Federn an einem Körper ergeben eine steife.</translation>
    </message>
    <message>
        <source>a thousand feet</source>
        <translation>tausend Füße</translation>
    </message>
    <message>
        <source>A thousand feet pull one body as hard as a spring of stiffness 200.</source>
        <translation>Tausend Füße ziehen einen Körper so stark wie eine Feder der Steifigkeit 200.</translation>
    </message>
    <message>
        <source>ten thousand feet</source>
        <translation>zehntausend Füße</translation>
    </message>
    <message>
        <source>Ten thousand feet pull one body as hard as a spring of stiffness 2000.</source>
        <translation>Zehntausend Füße ziehen einen Körper so stark wie eine Feder der Steifigkeit 2000.</translation>
    </message>
    <message>
        <source>all in one place</source>
        <translation>alles an einem Ort</translation>
    </message>
    <message>
        <source>Body and feet begin in one place, where no spring has a direction.</source>
        <translation>Körper und Füße beginnen an einem Ort, wo keine Feder eine Richtung hat.</translation>
    </message>
    <message>
        <source>all on one line</source>
        <translation>alles auf einer Linie</translation>
    </message>
    <message>
        <source>Body and feet stand in line, so nothing pulls them off it.</source>
        <translation>Körper und Füße stehen in einer Linie, also zieht nichts sie davon weg.</translation>
    </message>
    <message>
        <source>springs without a length</source>
        <translation>Federn ohne Länge</translation>
    </message>
    <message>
        <source>Springs of length 0 pull all points into one place, where their directions are lost.</source>
        <translation>Federn der Länge 0 ziehen alle Punkte an einen Ort, wo ihre Richtungen verloren gehen.</translation>
    </message>
    <message>
        <source>thrown into a corner</source>
        <translation>in eine Ecke geworfen</translation>
    </message>
    <message>
        <source>A body comes into a corner at a million px a frame: in one step it would be two thousand rooms away.</source>
        <translation>Ein Körper kommt mit einer Million px pro Bild in eine Ecke: In einem Zeitschritt wäre er zweitausend Räume weit weg.</translation>
    </message>
    <message>
        <source>walls closer than the body</source>
        <translation>Wände enger als der Körper</translation>
    </message>
    <message>
        <source>The body is 30 px wide and the room 15: wherever it is, it is in a wall.</source>
        <translation>Der Körper ist 30 px breit und der Raum 15: Wo er auch ist, er steckt in einer Wand.</translation>
    </message>
    <message>
        <source>a million times the gravity</source>
        <translation>das Millionenfache der Schwerkraft</translation>
    </message>
    <message>
        <source>All falls at a million px a frame, each frame, onto a floor that gives nothing back.</source>
        <translation>Alles fällt mit einer Million px pro Bild, in jedem Bild, auf einen Boden, der nichts zurückgibt.</translation>
    </message>
    <message>
        <source>grabbed and let go</source>
        <translation>gegriffen und losgelassen</translation>
    </message>
    <message>
        <source>A hand takes the body for one frame and lets it go.</source>
        <translation>Eine Hand nimmt den Körper für ein Bild und lässt ihn los.</translation>
    </message>
    <message>
        <source>torn away</source>
        <translation>weggerissen</translation>
    </message>
    <message>
        <source>A hand takes the body a billion px away in one frame, and lets it go.</source>
        <translation>Eine Hand nimmt den Körper in einem Bild eine Milliarde px weit weg und lässt ihn los.</translation>
    </message>
    <message>
        <source>torn away on stiff springs</source>
        <translation>an steifen Federn weggerissen</translation>
    </message>
    <message>
        <source>The same on springs of stiffness a million.</source>
        <translation>Dasselbe an Federn der Steifigkeit eine Million.</translation>
    </message>
    <message>
        <source>legs that flip</source>
        <translation>Beine, die umschlagen</translation>
    </message>
    <message>
        <source>The gait turns by half a circle each frame: a step sees two places of it only.</source>
        <translation>Der Gang dreht sich in jedem Bild um einen halben Kreis: Ein Zeitschritt sieht nur zwei Orte davon.</translation>
    </message>
    <message>
        <source>legs that whirl</source>
        <translation>Beine, die wirbeln</translation>
    </message>
    <message>
        <source>The gait turns 159,155 times in a frame.</source>
        <translation>Der Gang dreht sich 159&#x2009;155-mal in einem Bild.</translation>
    </message>
    <message>
        <source>a hand that is nowhere</source>
        <translation>eine Hand, die nirgends ist</translation>
    </message>
    <message>
        <source>The hand moves to a place that is not a number.</source>
        <translation>Die Hand geht an einen Ort, der keine Zahl ist.</translation>
    </message>
    <message>
        <source>a pointer at the end of the world</source>
        <translation>ein Zeiger am Ende der Welt</translation>
    </message>
    <message>
        <source>The pointer goes to a place that is infinitely far away.</source>
        <translation>Der Zeiger geht an einen Ort, der unendlich weit weg ist.</translation>
    </message>
    <message>
        <source>an endless stiffness</source>
        <translation>eine endlose Steifigkeit</translation>
    </message>
    <message>
        <source>The stiffness is set to infinity.</source>
        <translation>Die Steifigkeit wird auf unendlich gesetzt.</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>Füße</translation>
    </message>
    <message>
        <source>body</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>light</source>
        <translation>leicht</translation>
    </message>
    <message>
        <source>heavy</source>
        <translation>schwer</translation>
    </message>
    <message>
        <source>lead</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>tail</source>
        <translation>Schwanz</translation>
    </message>
    <message>
        <source>suddenly stiff</source>
        <translation>plötzlich steif</translation>
    </message>
    <message>
        <source>In the middle of a run the stiffness goes from 0.2 to a million.</source>
        <translation>Mitten in einem Lauf geht die Steifigkeit von 0,2 auf eine Million.</translation>
    </message>
    <message>
        <source>just below the limit</source>
        <translation>knapp unter der Grenze</translation>
    </message>
    <message>
        <source>A spring that one step a frame can just follow: stiffness 3.99, where the limit is 4.</source>
        <translation>Eine Feder, der ein Zeitschritt pro Bild gerade noch folgen kann: Steifigkeit 3,99, wo die Grenze 4 ist.</translation>
    </message>
    <message>
        <source>at the limit</source>
        <translation>an der Grenze</translation>
    </message>
    <message>
        <source>At stiffness 4 the foot comes to the other side in one step, with all its speed: it goes farther each time.</source>
        <translation>Bei Steifigkeit 4 kommt der Fuß in einem Zeitschritt auf die andere Seite, mit all seinem Tempo: Jedes Mal geht er weiter.</translation>
    </message>
    <message>
        <source>just above the limit</source>
        <translation>knapp über der Grenze</translation>
    </message>
    <message>
        <source>At stiffness 4.01 each swing is a tenth larger than the one before.</source>
        <translation>Bei Steifigkeit 4,01 ist jede Schwingung ein Zehntel größer als die vorige.</translation>
    </message>
    <message>
        <source>a thousand times as stiff</source>
        <translation>tausendmal so steif</translation>
    </message>
    <message>
        <source>A spring of stiffness 1000 swings five times in a frame.</source>
        <translation>Eine Feder der Steifigkeit 1000 schwingt fünfmal in einem Bild.</translation>
    </message>
    <message>
        <source>a million times as stiff</source>
        <translation>eine Million Mal so steif</translation>
    </message>
    <message>
        <source>A spring of stiffness a million swings 159 times in a frame.</source>
        <translation>Eine Feder der Steifigkeit eine Million schwingt 159-mal in einem Bild.</translation>
    </message>
    <message>
        <source>nearly rigid</source>
        <translation>fast starr</translation>
    </message>
    <message>
        <source>A spring of stiffness 1e9 is as good as a stick.</source>
        <translation>Eine Feder der Steifigkeit 1e9 ist so gut wie ein Stab.</translation>
    </message>
    <message>
        <source>nearly rigid, and nothing slows it</source>
        <translation>fast starr, und nichts bremst sie</translation>
    </message>
    <message>
        <source>The same without damping: it may swing for ever, but no farther than it began.</source>
        <translation>Dasselbe ohne Dämpfung: Sie darf ewig schwingen, aber nicht weiter, als sie begann.</translation>
    </message>
    <message>
        <source>damping that stops all</source>
        <translation>Dämpfung, die alles anhält</translation>
    </message>
    <message>
        <source>With damping 0 no velocity is left: nothing may move.</source>
        <translation>Mit Dämpfung 0 bleibt keine Geschwindigkeit übrig: Nichts darf sich bewegen.</translation>
    </message>
    <message>
        <source>no damping</source>
        <translation>keine Dämpfung</translation>
    </message>
    <message>
        <source>With damping 1 nothing is lost: the foot swings for ever, and no farther.</source>
        <translation>Mit Dämpfung 1 geht nichts verloren: Der Fuß schwingt ewig, und nicht weiter.</translation>
    </message>
    <message>
        <source>next to nothing is left</source>
        <translation>fast nichts bleibt übrig</translation>
    </message>
    <message>
        <source>Damping of 1e-300 leaves numbers that are nearly too small to write.</source>
        <translation>Eine Dämpfung von 1e-300 lässt Zahlen übrig, die fast zu klein zum Schreiben sind.</translation>
    </message>
    <message>
        <source>a fly and a mountain</source>
        <translation>eine Fliege und ein Berg</translation>
    </message>
    <message>
        <source>One body is a billion times as heavy as the one on its spring.</source>
        <translation>Ein Körper ist eine Milliarde Mal so schwer wie der an seiner Feder.</translation>
    </message>
    <message>
        <source>the mountain swings, too</source>
        <translation>auch der Berg schwingt</translation>
    </message>
    <message>
        <source>The spring is stiff enough to move the heavy body, and so a hundred million times too stiff for the light one.</source>
        <translation>Die Feder ist steif genug, den schweren Körper zu bewegen, und darum für den leichten hundert Millionen Mal zu steif.</translation>
    </message>
    <message>
        <source>sticks that contradict each other</source>
        <translation>Stäbe, die sich widersprechen</translation>
    </message>
    <message>
        <source>Three sticks of lengths 1, 1 and 10 make no triangle: whatever moves, one is wrong.</source>
        <translation>Drei Stäbe der Längen 1, 1 und 10 ergeben kein Dreieck: Was sich auch bewegt, einer ist falsch.</translation>
    </message>
    <message>
        <source>a chain that is too short</source>
        <translation>eine zu kurze Kette</translation>
    </message>
    <message>
        <source>A chain of a thousand links between two nails is a tenth too short: no link can be right.</source>
        <translation>Eine Kette aus tausend Gliedern zwischen zwei Nägeln ist um ein Zehntel zu kurz: Kein Glied kann richtig sein.</translation>
    </message>
    <message>
        <source>a chain too heavy for its sticks</source>
        <translation>eine Kette, zu schwer für ihre Stäbe</translation>
    </message>
    <message>
        <source>A chain of a thousand links hangs between two nails: 20 passes a frame leave its links much too long.</source>
        <translation>Eine Kette aus tausend Gliedern hängt zwischen zwei Nägeln: 20 Durchgänge pro Bild lassen ihre Glieder viel zu lang.</translation>
    </message>
    <message>
        <source>a heavy chain in small steps</source>
        <translation>eine schwere Kette in kleinen Zeitschritten</translation>
    </message>
    <message>
        <source>The same chain and the same work: in place of 20 passes a frame 20 steps of one pass each. Its links err a ninth as much.</source>
        <translation>Dieselbe Kette und dieselbe Arbeit: statt 20 Durchgängen pro Bild 20 Zeitschritte mit je einem Durchgang. Der Fehler ihrer Glieder ist ein Neuntel so groß.</translation>
    </message>
    <message>
        <source>a stick without a length</source>
        <translation>ein Stab ohne Länge</translation>
    </message>
    <message>
        <source>Two points on a stick of length 0 have no direction between them, and a body hangs on them.</source>
        <translation>Zwei Punkte an einem Stab der Länge 0 haben keine Richtung zueinander, und an ihnen hängt ein Körper.</translation>
    </message>
    <message>
        <source>a stick between two nails</source>
        <translation>ein Stab zwischen zwei Nägeln</translation>
    </message>
    <message>
        <source>A stick that is too short between two points that stand fast: neither gives way.</source>
        <translation>Ein zu kurzer Stab zwischen zwei Punkten, die feststehen: Keiner gibt nach.</translation>
    </message>
    <message>
        <source>the tail goes through the lead</source>
        <translation>der Schwanz geht durch die Spitze</translation>
    </message>
    <message>
        <source>The lead turns round and swims straight through its own tail.</source>
        <translation>Die Spitze kehrt um und schwimmt mitten durch ihren eigenen Schwanz.</translation>
    </message>
    <message>
        <source>the tail is in the lead</source>
        <translation>der Schwanz ist in der Spitze</translation>
    </message>
    <message>
        <source>Lead and tail begin in one place, on a soft stick that has no direction there.</source>
        <translation>Spitze und Schwanz beginnen an einem Ort, an einem weichen Stab, der dort keine Richtung hat.</translation>
    </message>
    <message>
        <source>a target beyond the horizon</source>
        <translation>ein Ziel hinter dem Horizont</translation>
    </message>
    <message>
        <source>The target is a billion px away, and the motor pulls the harder the farther it is.</source>
        <translation>Das Ziel ist eine Milliarde px weit weg, und je weiter, desto stärker zieht der Motor.</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>ten million frames</source>
        <translation>zehn Millionen Bilder</translation>
    </message>
    <message>
        <source>A foot swings for nearly four days of playing, and nothing slows it: no error may add up.</source>
        <translation>Ein Fuß schwingt fast vier Tage Spielzeit lang, und nichts bremst ihn: Kein Fehler darf sich summieren.</translation>
    </message>
    <message>
        <source>a million frames at rest</source>
        <translation>eine Million Bilder in Ruhe</translation>
    </message>
    <message>
        <source>What has come to rest keeps velocities that are nearly too small to write, and must keep still.</source>
        <translation>Was zur Ruhe gekommen ist, behält Geschwindigkeiten, die fast zu klein zum Schreiben sind, und muss still bleiben.</translation>
    </message>
    <message>
        <source>a million steps a frame</source>
        <translation>eine Million Zeitschritte pro Bild</translation>
    </message>
    <message>
        <source>Steps of a millionth of a frame: what each adds is nearly lost in rounding.</source>
        <translation>Zeitschritte von einem millionstel Bild: Was jeder hinzufügt, geht fast im Runden verloren.</translation>
    </message>
    <message>
        <source>a third of a frame</source>
        <translation>ein Drittel Bild</translation>
    </message>
    <message>
        <source>Three steps a frame, of a length that no binary number is equal to.</source>
        <translation>Drei Zeitschritte pro Bild, von einer Länge, der keine Binärzahl gleich ist.</translation>
    </message>
    <message>
        <source>a hundred frames in a step</source>
        <translation>hundert Bilder in einem Zeitschritt</translation>
    </message>
    <message>
        <source>One step leaps over seven swings of the spring.</source>
        <translation>Ein Zeitschritt überspringt sieben Schwingungen der Feder.</translation>
    </message>
    <message>
        <source>no distance to divide by</source>
        <translation>kein Abstand, durch den man teilen könnte</translation>
    </message>
    <message>
        <source>In the printed formula the pointer can be at distance 0: it divides by that, and the run must end with a word about it.</source>
        <translation>In der gedruckten Formel kann der Zeiger den Abstand 0 haben: Sie teilt durch ihn, und der Lauf muss mit einem Wort darüber enden.</translation>
    </message>
    <message>
        <source>the pointer on the root</source>
        <translation>der Zeiger auf der Wurzel</translation>
    </message>
    <message>
        <source>The trunk turns to a pointer that is exactly where it begins.</source>
        <translation>Der Stamm dreht sich zu einem Zeiger, der genau dort ist, wo er beginnt.</translation>
    </message>
    <message>
        <source>sixteen forks</source>
        <translation>sechzehn Gabelungen</translation>
    </message>
    <message>
        <source>Each branch forks into two as large as itself, sixteen times: 131,071 branches in the wind.</source>
        <translation>Jeder Zweig gabelt sich in zwei so große wie er selbst, sechzehnmal: 131&#x2009;071 Zweige im Wind.</translation>
    </message>
    <message>
        <source>a tree without an end</source>
        <translation>ein Baum ohne Ende</translation>
    </message>
    <message>
        <source>Branches that are as large as their parents never get small enough to stop forking.</source>
        <translation>Zweige, die so groß sind wie ihre Eltern, werden nie klein genug, um sich nicht mehr zu gabeln.</translation>
    </message>
    <message>
        <source>a tree of glass</source>
        <translation>ein Baum aus Glas</translation>
    </message>
    <message>
        <source>Joints a million times as stiff as wood, bent by ten degrees and let go.</source>
        <translation>Gelenke, eine Million Mal so steif wie Holz, um zehn Grad gebogen und losgelassen.</translation>
    </message>
    <message>
        <source>wind from the branch itself</source>
        <translation>Wind aus dem Zweig selbst</translation>
    </message>
    <message>
        <source>The pointer is exactly where the trunk ends: the wind has no direction there.</source>
        <translation>Der Zeiger ist genau dort, wo der Stamm endet: Der Wind hat dort keine Richtung.</translation>
    </message>
    <message>
        <source>wind without a distance</source>
        <translation>Wind ohne Abstand</translation>
    </message>
    <message>
        <source>What resists the wind is the distance to the pointer, and it is 0.</source>
        <translation>Was dem Wind widersteht, ist der Abstand zum Zeiger, und der ist 0.</translation>
    </message>
    <message>
        <source>branches</source>
        <translation>Zweige</translation>
    </message>
    <message>
        <source>steps of its own</source>
        <translation>eigene Zeitschritte</translation>
    </message>
    <message>
        <source>Backward Euler</source>
        <translation>Implizites Euler</translation>
    </message>
    <message>
        <source>Dormand–Prince 8(5,3)</source>
        <translation>Dormand–Prince 8(5,3)</translation>
    </message>
    <message>
        <source>Dormand–Prince 5(4)</source>
        <translation>Dormand–Prince 5(4)</translation>
    </message>
    <message>
        <source>Explicit Euler</source>
        <translation>Explizites Euler</translation>
    </message>
    <message>
        <source>solve for the new place</source>
        <translation>nach dem neuen Ort auflösen</translation>
    </message>
    <message>
        <source>Implicit midpoint</source>
        <translation>Implizite Mittelpunktsregel</translation>
    </message>
    <message>
        <source>Runge–Kutta–Nyström 8(6)</source>
        <translation>Runge–Kutta–Nyström 8(6)</translation>
    </message>
    <message>
        <source>kick</source>
        <translation>Schub</translation>
    </message>
    <message>
        <source>half kick</source>
        <translation>halber Schub</translation>
    </message>
    <message>
        <source>move</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>half move</source>
        <translation>halbe Bewegung</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>half turn</source>
        <translation>halbe Drehung</translation>
    </message>
    <message>
        <source>new velocity</source>
        <translation>neue Geschwindigkeit</translation>
    </message>
    <message>
        <source>Position Verlet</source>
        <translation>Positions-Verlet</translation>
    </message>
    <message>
        <source>Published</source>
        <translation>Veröffentlicht</translation>
    </message>
    <message>
        <source>try a place</source>
        <translation>einen Ort probieren</translation>
    </message>
    <message>
        <source>Midpoint</source>
        <translation>Mittelpunktsregel</translation>
    </message>
    <message>
        <source>Runge–Kutta 4</source>
        <translation>Runge–Kutta 4</translation>
    </message>
    <message>
        <source>Semi-implicit Euler</source>
        <translation>Semi-implizites Euler</translation>
    </message>
    <message>
        <source>TR-BDF2</source>
        <translation>TR-BDF2</translation>
    </message>
    <message>
        <source>Velocity Verlet</source>
        <translation>Velocity-Verlet</translation>
    </message>
    <message>
        <source>Keep joints from bending too far: a knee does not bend forwards.</source>
        <translation>Hält Gelenke davon ab, sich zu weit zu beugen: Ein Knie beugt sich nicht nach vorn.</translation>
    </message>
    <message>
        <source>Shifts the swimmer back before it goes to a new target, as a cat draws back before it leaps.</source>
        <translation>Schiebt den Schwimmer zurück, bevor er zu einem neuen Ziel startet, so wie eine Katze vor dem Sprung zurückweicht.</translation>
    </message>
    <message>
        <source>Keeps the area of the body: what gets longer gets thinner.</source>
        <translation>Erhält die Fläche des Körpers: Was länger wird, wird schmaler.</translation>
    </message>
    <message>
        <source>Pulls a foot to the body, wherever that is.</source>
        <translation>Zieht einen Fuß zum Körper, wo der auch ist.</translation>
    </message>
    <message>
        <source>Takes a share of every velocity each frame, so that things come to rest.</source>
        <translation>Nimmt jeder Geschwindigkeit in jedem Bild einen Anteil, damit die Dinge zur Ruhe kommen.</translation>
    </message>
    <message>
        <source>Turns the angle that swings the legs on, a little each frame: the beat of the walk.</source>
        <translation>Dreht den Winkel, der die Beine schwingt, in jedem Bild ein wenig weiter: der Takt des Gehens.</translation>
    </message>
    <message>
        <source>Pulls everything down, and everything alike.</source>
        <translation>Zieht alles nach unten, und alles gleich.</translation>
    </message>
    <message>
        <source>Keeps the feet from sinking in, and from slipping where it holds them.</source>
        <translation>Hält die Füße davon ab, einzusinken und dort zu rutschen, wo er sie hält.</translation>
    </message>
    <message>
        <source>Lets a gust run outwards from the pointer, so that near branches feel it first.</source>
        <translation>Lässt eine Bö vom Zeiger nach außen laufen, sodass nahe Zweige sie zuerst spüren.</translation>
    </message>
    <message>
        <source>Set each branch on the end of the branch that carries it.</source>
        <translation>Setzt jeden Zweig auf das Ende des Zweigs, der ihn trägt.</translation>
    </message>
    <message>
        <source>Pull each foot to its own place, as seen from the body.</source>
        <translation>Zieht jeden Fuß an einen eigenen Ort, vom Körper aus gesehen.</translation>
    </message>
    <message>
        <source>Pulls the swimmer to its target, as a spring does.</source>
        <translation>Zieht den Schwimmer zu seinem Ziel, so wie eine Feder es tut.</translation>
    </message>
    <message>
        <source>Pulls a foot to a place beside the body.</source>
        <translation>Zieht einen Fuß an einen Ort neben dem Körper.</translation>
    </message>
    <message>
        <source>Pulls a foot to a fixed place.</source>
        <translation>Zieht einen Fuß an einen festen Ort.</translation>
    </message>
    <message>
        <source>Carries a point to where the pointer is.</source>
        <translation>Trägt einen Punkt dorthin, wo der Zeiger ist.</translation>
    </message>
    <message>
        <source>Pushes apart what comes too close, so that creatures do not walk through each other.</source>
        <translation>Schiebt auseinander, was sich zu nahe kommt, damit Figuren nicht durcheinander hindurchgehen.</translation>
    </message>
    <message>
        <source>Keep two points a length apart: they pull when it is more, and push when it is less.</source>
        <translation>Hält zwei Punkte eine Länge auseinander: Zieht, wenn es mehr ist, und schiebt, wenn es weniger ist.</translation>
    </message>
    <message>
        <source>Turns each branch a part of the way back to where it grew.</source>
        <translation>Dreht jeden Zweig ein Stück des Wegs dorthin zurück, wo er wuchs.</translation>
    </message>
    <message>
        <source>Keep a point near its distance, but let it lag behind for a while.</source>
        <translation>Hält einen Punkt nahe an seinem Abstand, lässt ihn aber eine Weile nachhängen.</translation>
    </message>
    <message>
        <source>Slows the tail, and more so across the body than along it, as water does.</source>
        <translation>Bremst den Schwanz, und zwar quer zum Körper mehr als längs, so wie Wasser es tut.</translation>
    </message>
    <message>
        <source>Lets the arrow keys and the pointer set how fast the legs swing.</source>
        <translation>Lässt Pfeiltasten und Zeiger bestimmen, wie schnell die Beine schwingen.</translation>
    </message>
    <message>
        <source>Give each pair of points its length back, by moving them: a stick does not stretch.</source>
        <translation>Gibt jedem Paar von Punkten seine Länge zurück, indem er sie bewegt: Ein Stab dehnt sich nicht.</translation>
    </message>
    <message>
        <source>Bend each joint back: the harder, the farther a branch has turned from where it grew.</source>
        <translation>Biegt jedes Gelenk zurück: je stärker, desto weiter sich ein Zweig von dort gedreht hat, wo er wuchs.</translation>
    </message>
    <message>
        <source>Makes a creature that meets a wall walk the other way.</source>
        <translation>Lässt eine Figur, die auf eine Wand trifft, in die andere Richtung gehen.</translation>
    </message>
    <message>
        <source>Turns every branch to the pointer while its button is down.</source>
        <translation>Dreht jeden Zweig zum Zeiger, solange dessen Taste gedrückt ist.</translation>
    </message>
    <message>
        <source>Put back what has gone past a wall or the floor, and turn its velocity round.</source>
        <translation>Setzt zurück, was über eine Wand oder den Boden hinaus ist, und kehrt seine Geschwindigkeit um.</translation>
    </message>
    <message>
        <source>Turns the branches away from the pointer while its button is down.</source>
        <translation>Dreht die Zweige vom Zeiger weg, solange dessen Taste gedrückt ist.</translation>
    </message>
    <message>
        <source>the body %1</source>
        <translation>der Körper %1</translation>
    </message>
    <message>
        <source>Blows everything sideways, wide bodies more, and swells and ebbs.</source>
        <translation>Bläst alles zur Seite, breite Körper mehr, und schwillt an und ab.</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Keeps everything on one side of a straight line, which leans as you like.</source>
        <translation>Hält alles auf einer Seite einer Geraden, die so schräg liegt, wie du willst.</translation>
    </message>
    <message>
        <source>Keeps everything between two walls and above a floor, with friction and without a bounce.</source>
        <translation>Hält alles zwischen zwei Wänden und über einem Boden, mit Reibung und ohne Abprall.</translation>
    </message>
    <message>
        <source>Stiff springs</source>
        <translation>Steife Federn</translation>
    </message>
    <message>
        <source>Many feet on one body</source>
        <translation>Viele Füße an einem Körper</translation>
    </message>
    <message>
        <source>All in one place</source>
        <translation>Alles an einem Ort</translation>
    </message>
    <message>
        <source>Torn by a hand</source>
        <translation>Von einer Hand gerissen</translation>
    </message>
    <message>
        <source>Walls and walking</source>
        <translation>Wände und Gehen</translation>
    </message>
    <message>
        <source>Sticks that contradict</source>
        <translation>Stäbe, die sich widersprechen</translation>
    </message>
    <message>
        <source>Swimmers</source>
        <translation>Schwimmer</translation>
    </message>
    <message>
        <source>Trees in wind</source>
        <translation>Bäume im Wind</translation>
    </message>
    <message>
        <source>Unusual steps</source>
        <translation>Ungewöhnliche Zeitschritte</translation>
    </message>
    <message>
        <source>Long runs</source>
        <translation>Lange Läufe</translation>
    </message>
    <message>
        <source>Input that is refused</source>
        <translation>Eingaben, die abgelehnt werden</translation>
    </message>
    <message>
        <source>1/frame²</source>
        <translation>1/Bild²</translation>
    </message>
    <message>
        <source>Bounce</source>
        <translation>Abprall</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Schwerkraft</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Boden</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Böen</translation>
    </message>
    <message>
        <source>How far down that place is.</source>
        <translation>Wie weit unten diese Stelle liegt.</translation>
    </message>
    <message>
        <source>How far down the floor lies.</source>
        <translation>Wie weit unten der Boden liegt.</translation>
    </message>
    <message>
        <source>How far down the ground lies.</source>
        <translation>Wie weit unten der Boden liegt.</translation>
    </message>
    <message>
        <source>How far to the right a place of the ramp is.</source>
        <translation>Wie weit rechts eine Stelle der Rampe liegt.</translation>
    </message>
    <message>
        <source>How hard it blows to the right on a body 10 px wide. Below 0: to the left.</source>
        <translation>Wie stark er auf einen 10 px breiten Körper nach rechts weht. Unter 0: nach links.</translation>
    </message>
    <message>
        <source>How hard two bodies push: this share of the missing distance, each frame.</source>
        <translation>Wie stark zwei Körper schieben: dieser Anteil des fehlenden Abstands, in jedem Bild.</translation>
    </message>
    <message>
        <source>How much a wall’s push holds back what slides along it. 0: like ice.</source>
        <translation>Wie stark eine Wand bremst, was an ihr entlanggleitet. 0: wie Eis.</translation>
    </message>
    <message>
        <source>How much speed everything gains downwards each frame.</source>
        <translation>Wie viel Tempo alles in jedem Bild nach unten gewinnt.</translation>
    </message>
    <message>
        <source>How often each frame goes through the list of sticks.</source>
        <translation>Wie oft jedes Bild die Liste der Stäbe durchgeht.</translation>
    </message>
    <message>
        <source>How steeply it rises to the right. 0: level. 90: a wall on the right. 180: a ceiling.</source>
        <translation>Wie steil sie nach rechts steigt. 0: waagrecht. 90: eine Wand rechts. 180: eine Decke.</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iterationen</translation>
    </message>
    <message>
        <source>Left wall</source>
        <translation>Linke Wand</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Abstoßung</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Ramp x</source>
        <translation>Rampe x</translation>
    </message>
    <message>
        <source>Ramp y</source>
        <translation>Rampe y</translation>
    </message>
    <message>
        <source>Right wall</source>
        <translation>Rechte Wand</translation>
    </message>
    <message>
        <source>The share by which the wind swells and ebbs.</source>
        <translation>Der Anteil, um den der Wind an- und abschwillt.</translation>
    </message>
    <message>
        <source>The share of its speed that a body keeps at a wall.</source>
        <translation>Der Anteil seines Tempos, den ein Körper an einer Wand behält.</translation>
    </message>
    <message>
        <source>The share of its speed that everything keeps each frame. 1 keeps it all.</source>
        <translation>Der Anteil seines Tempos, den alles in jedem Bild behält. 1 behält alles.</translation>
    </message>
    <message>
        <source>Two bodies closer than this push each other.</source>
        <translation>Zwei Körper, die sich näher sind, schieben einander weg.</translation>
    </message>
    <message>
        <source>Where the left wall stands.</source>
        <translation>Wo die linke Wand steht.</translation>
    </message>
    <message>
        <source>Where the right wall stands.</source>
        <translation>Wo die rechte Wand steht.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>ice on the ground</source>
        <translation>Eis auf dem Boden</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>behalten</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>per frame</source>
        <translation>pro Bild</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>px/frame²</source>
        <translation>px/Bild²</translation>
    </message>
    <message>
        <source>springs that pull one end only</source>
        <translation>Federn, die nur an einem Ende ziehen</translation>
    </message>
    <message>
        <source>feet with more than one leg</source>
        <translation>Füße mit mehr als einem Bein</translation>
    </message>
    <message>
        <source>the bounce of the ground</source>
        <translation>Abprall am Boden</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Charge strength</source>
        <translation>Stärke der Ladungen</translation>
    </message>
    <message>
        <source>px³/frame²</source>
        <translation>px³/Bild²</translation>
    </message>
    <message>
        <source>How hard charges push and pull each other.</source>
        <translation>Wie stark Ladungen einander abstoßen und anziehen.</translation>
    </message>
    <message>
        <source>Softening</source>
        <translation>Weichheit</translation>
    </message>
    <message>
        <source>Weakens the force where charges come closer than about this, so that it stays finite.</source>
        <translation>Schwächt die Kraft, wo Ladungen sich näher kommen als etwa so weit, damit sie endlich bleibt.</translation>
    </message>
    <message>
        <source>Charge</source>
        <translation>Ladung</translation>
    </message>
    <message>
        <source>Charges of the same sign repel each other, and others attract. 0: it carries none.</source>
        <translation>Ladungen mit gleichem Vorzeichen stoßen einander ab, andere ziehen sich an. 0: Er trägt keine.</translation>
    </message>
    <message>
        <source>Where this charge is, seen from the other one.</source>
        <translation>Wo diese Ladung ist, von der anderen aus gesehen.</translation>
    </message>
    <message>
        <source>How far apart the two charges are.</source>
        <translation>Wie weit die beiden Ladungen voneinander entfernt sind.</translation>
    </message>
    <message>
        <source>How hard they push each other apart, for a mass of 1. Below 0: they attract each other.</source>
        <translation>Wie stark sie einander abstoßen, bei Masse 1. Unter 0: Sie ziehen sich an.</translation>
    </message>
    <message>
        <source>What all charges together add to the velocity each frame.</source>
        <translation>Was alle Ladungen zusammen in jedem Bild zur Geschwindigkeit hinzufügen.</translation>
    </message>
    <message>
        <source>charges</source>
        <translation>Ladungen</translation>
    </message>
    <message>
        <source>Push points with like charges apart, and pull unlike ones together: the harder, the closer they are.</source>
        <translation>Stoßen Punkte mit gleicher Ladung voneinander ab und ziehen ungleiche zueinander: je näher, desto stärker.</translation>
    </message>
    <message>
        <source>two charges in one place</source>
        <translation>zwei Ladungen an einem Ort</translation>
    </message>
    <message>
        <source>Two like charges begin in one place, where the force between them is greatest and has no direction.</source>
        <translation>Zwei gleiche Ladungen beginnen an einem Ort, wo die Kraft zwischen ihnen am größten ist und keine Richtung hat.</translation>
    </message>
    <message>
        <source>creature</source>
        <translation>Figur</translation>
    </message>
    <message>
        <source>bodies</source>
        <translation>Körper</translation>
    </message>
    <message>
        <source>branch</source>
        <translation>Zweig</translation>
    </message>
</context>
<context>
    <name>sim::Keys</name>
    <message>
        <source>there is no key %1; there is %2.</source>
        <translation>es gibt keine Taste %1; es gibt %2.</translation>
    </message>
</context>
</TS>
