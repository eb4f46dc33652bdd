<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>AccuracyPlotText</name>
    <message>
        <source>%1: %2 frames; reference %3, accurate to %4 px</source>
        <translation>%1: %2 Bilder; Referenz %3, auf %4 px genau</translation>
    </message>
</context>
<context>
    <name>AccuracyReportText</name>
    <message>
        <source>step</source>
        <translation>Zeitschritt</translation>
    </message>
    <message>
        <source>error, px</source>
        <translation>Fehler, px</translation>
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
        <source>in use</source>
        <translation>verwendet</translation>
    </message>
    <message>
        <source>This scene has no exact motion to compare with, because %1 acts once per step. Each method is therefore compared with itself at a finer step (%2), which differs by up to %3 px from the next coarser one.</source>
        <translation>Diese Szene hat keine exakte Bewegung zum Vergleich, denn %1 wirkt einmal pro Zeitschritt. Darum wird jedes Verfahren mit sich selbst bei feinerem Zeitschritt verglichen (%2); der weicht bis zu %3 px vom nächstgröberen ab.</translation>
    </message>
    <message>
        <source>Errors are distances from %1 (%2). Its check, %3 (%4), differs from it by up to %5 px.</source>
        <translation>Fehler sind Abstände von %1 (%2). Die Gegenprobe %3 (%4) weicht davon bis zu %5 px ab.</translation>
    </message>
    <message>
        <source>Errors are given up to frame %1 of %2</source>
        <translation>Fehler gibt es bis Bild %1 von %2</translation>
    </message>
    <message>
        <source>: after that, the reference and its check disagree.</source>
        <translation>: Danach stimmen Referenz und Gegenprobe nicht mehr überein.</translation>
    </message>
    <message>
        <source>: after that, the reference is no longer finite.</source>
        <translation>: Danach ist die Referenz nicht mehr endlich.</translation>
    </message>
    <message>
        <source>: computing the reference beyond that would take too long.</source>
        <translation>: Die Referenz noch weiter zu berechnen, würde zu lange dauern.</translation>
    </message>
    <message>
        <source>No method stays within an error of %1 px.</source>
        <translation>Kein Verfahren bleibt unter einem Fehler von %1 px.</translation>
    </message>
    <message>
        <source>The cheapest way to stay within an error of %1 px costs %2 µs a frame: %3, with an error of %4 px.</source>
        <translation>Am billigsten bleibt man für %2 µs pro Bild unter einem Fehler von %1 px: %3, mit einem Fehler von %4 px.</translation>
    </message>
    <message>
        <source>No error was measured for the method in use, %1: see the table.</source>
        <translation>Für das verwendete Verfahren %1 wurde kein Fehler gemessen: siehe Tabelle.</translation>
    </message>
    <message>
        <source>The method in use, %1, costs %2 µs a frame, with an error of %3 px.</source>
        <translation>Das verwendete Verfahren %1 kostet %2 µs pro Bild, mit einem Fehler von %3 px.</translation>
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
        <source>* on the front: nothing cheaper is as accurate.</source>
        <translation>* auf der Bestlinie: Nichts Billigeres ist so genau.</translation>
    </message>
    <message>
        <source>This machine is busy with other things: times vary by %1 %.</source>
        <translation>Dieser Rechner hat anderes zu tun: Die Zeiten schwanken um %1 %.</translation>
    </message>
    <message>
        <source>Nothing moves here unless you do something, so there is no error to measure. Save a run in which you do something, and measure that file.</source>
        <translation>Hier bewegt sich nichts, solange du nichts tust, also gibt es keinen Fehler zu messen. Speichere einen Lauf, in dem du etwas tust, und miss diese Datei.</translation>
    </message>
</context>
<context>
    <name>AccuracyText</name>
    <message>
        <source>Measured %1 %</source>
        <translation>%1 % gemessen</translation>
    </message>
    <message>
        <source>%1: the picture could not be written: %2. Choose another folder or name.</source>
        <translation>%1: Die Bilddatei ließ sich nicht schreiben: %2. Wähle einen anderen Ordner oder Namen.</translation>
    </message>
    <message>
        <source>Your setup costs %1 and has an error of %2.</source>
        <translation>Deine Einstellung kostet %1 und hat einen Fehler von %2.</translation>
    </message>
    <message>
        <source>Your setup has an error of %1.</source>
        <translation>Deine Einstellung hat einen Fehler von %1.</translation>
    </message>
    <message>
        <source>Your setup is unstable here: its numbers grow without bound.</source>
        <translation>Deine Einstellung ist hier instabil: Die Zahlen wachsen ohne Grenze.</translation>
    </message>
    <message>
        <source>Your method cannot compute this scene.</source>
        <translation>Dein Verfahren kann diese Szene nicht berechnen.</translation>
    </message>
    <message>
        <source>Your setup would take too long to measure.</source>
        <translation>Deine Einstellung zu messen, würde zu lange dauern.</translation>
    </message>
    <message>
        <source>Errors are measured first, then times. The cost of staying within an error of %1 will appear here.</source>
        <translation>Erst werden Fehler gemessen, dann Zeiten. Hier erscheint dann, was ein Fehler von höchstens %1 kostet.</translation>
    </message>
    <message>
        <source>No method stays within an error of %1.</source>
        <translation>Kein Verfahren bleibt unter einem Fehler von %1.</translation>
    </message>
    <message>
        <source>No method stays within an error of %1. The closest is %2, with an error of %3.</source>
        <translation>Kein Verfahren bleibt unter einem Fehler von %1. Am nächsten kommt %2 mit einem Fehler von %3.</translation>
    </message>
    <message>
        <source>Errors are measured up to frame %1 of %2.</source>
        <translation>Fehler werden bis Bild %1 von %2 gemessen.</translation>
    </message>
    <message>
        <source>After that, even the two finest steps disagree, because the smallest difference grows here.</source>
        <translation>Danach stimmen nicht einmal die zwei feinsten Zeitschritte überein, denn hier wächst der kleinste Unterschied.</translation>
    </message>
    <message>
        <source>After that, even two very accurate solutions disagree. The smallest difference grows here until the true positions cannot be known.</source>
        <translation>Danach stimmen nicht einmal zwei sehr genaue Lösungen überein. Hier wächst der kleinste Unterschied, bis niemand mehr weiß, wo die Körper wirklich sind.</translation>
    </message>
    <message>
        <source>After that, the exact motion itself grows without bound.</source>
        <translation>Danach wächst die exakte Bewegung selbst ohne Grenze.</translation>
    </message>
    <message>
        <source>Computing the exact motion beyond that would take too long.</source>
        <translation>Die exakte Bewegung noch weiter zu berechnen, würde zu lange dauern.</translation>
    </message>
    <message>
        <source>one of its effects</source>
        <translation>einer ihrer Effekte</translation>
    </message>
    <message>
        <source>This scene has no exact motion to compare with, because %1 acts once per step, however short the step is. Each method is therefore compared with its own finest steps.</source>
        <translation>Diese Szene hat keine exakte Bewegung zum Vergleich, denn „%1“ wirkt einmal pro Zeitschritt, wie kurz er auch ist. Darum wird jedes Verfahren mit seinen eigenen feinsten Zeitschritten verglichen.</translation>
    </message>
    <message>
        <source>Cannot compute this scene: %1.</source>
        <translation>Kann diese Szene nicht berechnen: %1.</translation>
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
        <source>No error, to the last digit</source>
        <translation>Kein Fehler, bis zur letzten Stelle</translation>
    </message>
    <message>
        <source>Error at most %1</source>
        <translation>Fehler höchstens %1</translation>
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
        <source>Skipped: it would take too long</source>
        <translation>Ausgelassen: Es würde zu lange dauern</translation>
    </message>
    <message>
        <source>Not measured yet</source>
        <translation>Noch nicht gemessen</translation>
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
        <source>On the front: nothing cheaper is as accurate</source>
        <translation>Auf der Bestlinie: Nichts Billigeres ist so genau</translation>
    </message>
    <message>
        <source>Nothing moves here unless you do something, so there is no error to measure. Drag a body or change a number, then measure again.</source>
        <translation>Hier bewegt sich nichts, solange du nichts tust, also gibt es keinen Fehler zu messen. Zieh an einem Körper oder ändere eine Zahl und miss dann noch einmal.</translation>
    </message>
    <message>
        <source>First results, for frames 0 to %1. The exact motion after that is still being computed.</source>
        <translation>Erste Ergebnisse für die Bilder 0 bis %1. Die exakte Bewegung danach wird noch berechnet.</translation>
    </message>
    <message>
        <source>Nothing cheaper than your setup stays within an error of %1: %2 costs %3 a frame, with an error of %4.</source>
        <translation>Nichts Billigeres als deine Einstellung bleibt unter einem Fehler von %1: %2 kostet %3 pro Bild, mit einem Fehler von %4.</translation>
    </message>
    <message>
        <source>The cheapest way to stay within an error of %1 costs %2 a frame: %3.</source>
        <translation>Am billigsten bleibt man für %2 pro Bild unter einem Fehler von %1: %3.</translation>
    </message>
    <message>
        <source>The machine is busy with other things: the times differ by %1&#x2009;% from run to run. The errors are not affected.</source>
        <translation>Der Rechner hat anderes zu tun: Die Zeiten unterscheiden sich von Lauf zu Lauf um %1&#x2009;%. Die Fehler sind davon nicht betroffen.</translation>
    </message>
    <message>
        <source>Unstable: %1</source>
        <translation>Instabil: %1</translation>
    </message>
    <message>
        <source>unstable at large steps: %1</source>
        <translation>instabil bei großen Zeitschritten: %1</translation>
    </message>
    <message>
        <source>%1: the run is computed by code, which has no shorter steps to compare with. Remove &quot;method&quot; and &quot;code&quot; to measure the methods.</source>
        <translation>%1: Den Lauf berechnet Code, und der hat keine kürzeren Zeitschritte zum Vergleich. Entferne &quot;method&quot; und &quot;code&quot;, um die Verfahren zu messen.</translation>
    </message>
    <message>
        <source>%1 is not the name of a plot; it ends in .svg.</source>
        <translation>%1 ist kein Name für ein Diagramm; er endet auf .svg.</translation>
    </message>
</context>
<context>
    <name>Attempt</name>
    <message>
        <source>There is not enough memory.</source>
        <translation>Der Speicher reicht nicht.</translation>
    </message>
</context>
<context>
    <name>BlueprintReader</name>
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
        <source>there is no body %1 in this scene; %2 must be the name of one of its &quot;bodies&quot;.</source>
        <translation>in dieser Szene gibt es keinen Körper %1; %2 muss der Name von einem aus &quot;bodies&quot; sein.</translation>
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
        <source>%1 is a foot twice; it can be the foot of only one body.</source>
        <translation>%1 ist zweimal ein Fuß; ein Punkt kann nur der Fuß eines einzigen Körpers sein.</translation>
    </message>
    <message>
        <source>a scene cannot have the effect %1; it can have %2. Its springs, sticks and feet need no effect.</source>
        <translation>eine Szene kann den Effekt %1 nicht haben; möglich ist %2. Ihre Federn, Stäbe und Füße brauchen keinen Effekt.</translation>
    </message>
    <message>
        <source>the effect %1 is given twice; keep one.</source>
        <translation>der Effekt %1 ist zweimal angegeben; behalte einen.</translation>
    </message>
    <message>
        <source>&quot;rule&quot; does not compile. Line %1: %2</source>
        <translation>&quot;rule&quot; lässt sich nicht übersetzen. Zeile %1: %2</translation>
    </message>
    <message>
        <source>a rule link</source>
        <translation>eine Verbindung der Regel</translation>
    </message>
</context>
<context>
    <name>BodyNamesText</name>
    <message>
        <source>A name is a letter from a to z, then up to %1 letters, digits or _. Write it without spaces and accents.</source>
        <translation>Ein Name ist ein Buchstabe von a bis z, dann bis zu %1 Buchstaben, Ziffern oder _. Schreib ihn ohne Leerzeichen und Umlaute.</translation>
    </message>
    <message>
        <source>“%1” is a word of the code. Choose another name, such as “%1_1”.</source>
        <translation>„%1“ ist ein Wort des Codes. Wähle einen anderen Namen, zum Beispiel „%1_1“.</translation>
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
        <source>%1 at frame %2</source>
        <translation>%1 bei Bild %2</translation>
    </message>
</context>
<context>
    <name>BreakpointMonitorText</name>
    <message>
        <source>%1, line %2</source>
        <translation>%1, Zeile %2</translation>
    </message>
    <message>
        <source>Stopped at frame %1 before %2: %3.</source>
        <translation>Angehalten bei Bild %1 vor „%2“: %3.</translation>
    </message>
    <message>
        <source>Stopped at frame %1 before line %2: %3.</source>
        <translation>Angehalten bei Bild %1 vor Zeile %2: %3.</translation>
    </message>
    <message>
        <source>Stopped at frame %1 before line %2 of the listing.</source>
        <translation>Angehalten bei Bild %1 vor Zeile %2 des Listings.</translation>
    </message>
</context>
<context>
    <name>CaptionText</name>
    <message>
        <source>pulls change the velocities directly, %1.</source>
        <translation>Züge ändern die Geschwindigkeiten direkt, %1.</translation>
    </message>
    <message>
        <source>accelerations are being added up, %1.</source>
        <translation>Beschleunigungen werden addiert, %1.</translation>
    </message>
    <message>
        <source>velocities have changed, %1.</source>
        <translation>Geschwindigkeiten haben sich geändert, %1.</translation>
    </message>
    <message>
        <source>already moved: %1; not yet moved: %2.</source>
        <translation>schon bewegt: %1; noch nicht bewegt: %2.</translation>
    </message>
    <message>
        <source>everything has moved; next: %1.</source>
        <translation>alles hat sich bewegt; als Nächstes: „%1“.</translation>
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
        <source>after %1, points have moved directly, without a velocity.</source>
        <translation>nach „%1“ haben sich Punkte direkt bewegt, nicht über eine Geschwindigkeit.</translation>
    </message>
    <message>
        <source>after %1, points have moved directly, and velocities have changed.</source>
        <translation>nach „%1“ sind Punkte direkt bewegt und Geschwindigkeiten geändert.</translation>
    </message>
    <message>
        <source>Inside frame %1, step %2 of %3: %4</source>
        <translation>Innerhalb von Bild %1, Zeitschritt %2 von %3: %4</translation>
    </message>
    <message>
        <source>Inside frame %1: %2</source>
        <translation>Innerhalb von Bild %1: %2</translation>
    </message>
</context>
<context>
    <name>CheckText</name>
    <message>
        <source>%1: %2 (steps: %3; languages besides the first: %4)
</source>
        <translation>%1: %2 (Schritte: %3; Sprachen außer der ersten: %4)
</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
</context>
<context>
    <name>CodeJudge</name>
    <message>
        <source>%1° away from its angle</source>
        <translation>%1° von seinem Winkel entfernt</translation>
    </message>
    <message>
        <source>%1&#x202f;px away from its place</source>
        <translation>%1&#x202f;px von seinem Ort entfernt</translation>
    </message>
    <message>
        <source>Not yet: in frame %1 of a trial run with other parameters, %2 is %3.</source>
        <translation>Noch nicht: In Bild %1 eines Probelaufs mit anderen Parametern ist %2 %3.</translation>
    </message>
    <message>
        <source>Not yet: in frame %1 of a trial run, %2 is %3.</source>
        <translation>Noch nicht: In Bild %1 eines Probelaufs ist %2 %3.</translation>
    </message>
    <message>
        <source>Not yet: while your hand holds %1 in a trial run with other parameters, %2 is %3.</source>
        <translation>Noch nicht: Während deine Hand in einem Probelauf mit anderen Parametern %1 hält, ist %2 %3.</translation>
    </message>
    <message>
        <source>Not yet: while your hand holds %1 in a trial run, %2 is %3.</source>
        <translation>Noch nicht: Während deine Hand in einem Probelauf %1 hält, ist %2 %3.</translation>
    </message>
    <message>
        <source>Right: your code does the same as the listing in three trial runs.</source>
        <translation>Richtig: In drei Probeläufen tut dein Code dasselbe wie das Listing.</translation>
    </message>
    <message>
        <source>Not yet: a trial run stops in frame %1. %2</source>
        <translation>Noch nicht: Ein Probelauf hält in Bild %1 an. %2</translation>
    </message>
    <message>
        <source>Not yet: in frame %1 of a trial run, a number became infinite.</source>
        <translation>Noch nicht: In Bild %1 eines Probelaufs wurde eine Zahl unendlich.</translation>
    </message>
    <message>
        <source>Line %1 is not correct yet, so the code cannot run.</source>
        <translation>Zeile %1 ist noch nicht richtig, darum kann der Code nicht laufen.</translation>
    </message>
</context>
<context>
    <name>CodeListingText</name>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>%1: order of the phases</source>
        <translation>%1: Reihenfolge der Phasen</translation>
    </message>
</context>
<context>
    <name>CodeMarksText</name>
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
</context>
<context>
    <name>CodeRowsText</name>
    <message>
        <source>%1: added up by the method</source>
        <translation>%1: vom Verfahren addiert</translation>
    </message>
</context>
<context>
    <name>CodeSymbols</name>
    <message>
        <source>Where the body is, as seen from the other end of its spring.</source>
        <translation>Wo der Körper ist, vom anderen Ende seiner Feder aus gesehen.</translation>
    </message>
    <message>
        <source>The direction away from the other end of the spring, as an arrow of length 1.</source>
        <translation>Die Richtung weg vom anderen Ende der Feder, als Pfeil der Länge 1.</translation>
    </message>
    <message>
        <source>The same direction, as an angle.</source>
        <translation>Dieselbe Richtung, als Winkel.</translation>
    </message>
    <message>
        <source>How far the body is from the other end of its spring.</source>
        <translation>Wie weit der Körper vom anderen Ende seiner Feder entfernt ist.</translation>
    </message>
    <message>
        <source>How much farther away the spring pulls the body, as a share of its distance.</source>
        <translation>Um wie viel weiter weg die Feder den Körper zieht, als Anteil seiner Entfernung.</translation>
    </message>
    <message>
        <source>Where the spring pulls the body to.</source>
        <translation>Wohin die Feder den Körper zieht.</translation>
    </message>
    <message>
        <source>The arrow from the body to where the spring pulls it.</source>
        <translation>Der Pfeil vom Körper dorthin, wohin die Feder ihn zieht.</translation>
    </message>
    <message>
        <source>How much all springs together add to the velocity in each frame.</source>
        <translation>Wie viel alle Federn zusammen in jedem Bild zur Geschwindigkeit addieren.</translation>
    </message>
    <message>
        <source>How much gravity adds to the velocity in each frame.</source>
        <translation>Wie viel die Schwerkraft in jedem Bild zur Geschwindigkeit addiert.</translation>
    </message>
    <message>
        <source>The arrow from the body to its target.</source>
        <translation>Der Pfeil vom Körper zu seinem Ziel.</translation>
    </message>
    <message>
        <source>The share of the velocity that is left after this step.</source>
        <translation>Der Anteil der Geschwindigkeit, der nach diesem Zeitschritt übrig ist.</translation>
    </message>
    <message>
        <source>How much is added to the velocity in each frame.</source>
        <translation>Wie viel in jedem Bild zur Geschwindigkeit addiert wird.</translation>
    </message>
    <message>
        <source>Where the body is: x to the right, y down.</source>
        <translation>Wo der Körper ist: x nach rechts, y nach unten.</translation>
    </message>
    <message>
        <source>The velocity: how far the body moves in a frame.</source>
        <translation>Die Geschwindigkeit: wie weit sich der Körper in einem Bild bewegt.</translation>
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
    <name>CodeTargetsText</name>
    <message>
        <source>%1 can be %2, but not %3.</source>
        <translation>%1 kann %2 sein, aber nicht %3.</translation>
    </message>
    <message>
        <source>%1 can be a whole number from %2 to %3, but not %4.</source>
        <translation>%1 kann eine ganze Zahl von %2 bis %3 sein, aber nicht %4.</translation>
    </message>
    <message>
        <source>%1 can be a number from %2 to %3, but not %4.</source>
        <translation>%1 kann eine Zahl von %2 bis %3 sein, aber nicht %4.</translation>
    </message>
</context>
<context>
    <name>CodeTextWords</name>
    <message>
        <source>other code</source>
        <translation>anderer Code</translation>
    </message>
</context>
<context>
    <name>CodeValuesText</name>
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
        <source>there is no display for the window; set DISPLAY, or use a verb that needs none: %1.</source>
        <translation>es gibt keinen Bildschirm für das Fenster; setze DISPLAY oder verwende ein Verb, das keinen braucht: %1.</translation>
    </message>
</context>
<context>
    <name>CommandLineText</name>
    <message>
        <source>An experiment or a lesson to open.</source>
        <translation>Ein Experiment oder eine Lektion, die geöffnet werden.</translation>
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
        <source>%1; see %2 --help.</source>
        <translation>%1; siehe %2 --help.</translation>
    </message>
    <message>
        <source>no arguments</source>
        <translation>keine Argumente</translation>
    </message>
    <message>
        <source>%1 takes %2; see %3 --help.</source>
        <translation>%1 braucht %2; siehe %3 --help.</translation>
    </message>
    <message>
        <source>Physically based animation, step by step.

Without a verb, the window opens and shows FILE, an experiment or a lesson.

Verbs (each has its own --help, and none needs a display):</source>
        <translation>Physikalisch basierte Animation, Schritt für Schritt.

Ohne Verb öffnet sich das Fenster und zeigt FILE, ein Experiment oder eine Lektion.

Verben (jedes hat sein eigenes --help, und keines braucht einen Bildschirm):</translation>
    </message>
    <message>
        <source>%1 (default %2).</source>
        <translation>%1 (Vorgabe %2).</translation>
    </message>
    <message>
        <source>the window opens one file; leave out %1.</source>
        <translation>das Fenster öffnet eine Datei; lass %1 weg.</translation>
    </message>
</context>
<context>
    <name>CommandList</name>
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
</context>
<context>
    <name>ConceptMapText</name>
    <message>
        <source>the id “%1” is that of a concept in %2, too. Choose another one.</source>
        <translation>Die id „%1“ hat auch ein Begriff in %2. Nimm eine andere.</translation>
    </message>
    <message>
        <source>the concept “%1” rests on “%2”, which no step explains. Use the id of a concept, or remove it.</source>
        <translation>Der Begriff „%1“ beruht auf „%2“, den kein Schritt erklärt. Nimm die id eines Begriffs oder entferne sie.</translation>
    </message>
    <message>
        <source>the concept “%1” rests on “%2”, which comes later, in %3. Move one of them, or remove the id.</source>
        <translation>Der Begriff „%1“ beruht auf „%2“, der erst später kommt, in %3. Verschieb einen der beiden oder entferne die id.</translation>
    </message>
    <message>
        <source>the concept “%1” rests on itself. Remove its id from “Rests on”.</source>
        <translation>Der Begriff „%1“ beruht auf sich selbst. Entferne seine id aus „Rests on“.</translation>
    </message>
    <message>
        <source>the concept “%1” rests on one that rests on it. Remove one of the two ids.</source>
        <translation>Der Begriff „%1“ beruht auf einem, der auf ihm beruht. Entferne eine der beiden ids.</translation>
    </message>
</context>
<context>
    <name>ConditionNamesText</name>
    <message>
        <source>Character %1: %2</source>
        <translation>Zeichen %1: %2</translation>
    </message>
</context>
<context>
    <name>ConditionParserText</name>
    <message>
        <source>this is too long; use at most %1 characters.</source>
        <translation>das ist zu lang; nimm höchstens %1 Zeichen.</translation>
    </message>
    <message>
        <source>a number is neither true nor false; compare it, as in %1.</source>
        <translation>eine Zahl ist weder wahr noch falsch; vergleiche sie, wie in %1.</translation>
    </message>
    <message>
        <source>this is true or false, not a number; join conditions with and, or.</source>
        <translation>das ist wahr oder falsch, keine Zahl; verbinde Bedingungen mit and, or.</translation>
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
        <source>%1 is a text; only phase and choices can be compared with a text.</source>
        <translation>%1 ist ein Text; nur phase und Auswahlen lassen sich mit einem Text vergleichen.</translation>
    </message>
    <message>
        <source>a number cannot be used here; write a condition such as x &gt; 0.</source>
        <translation>hier passt keine Zahl; schreibe eine Bedingung wie x &gt; 0.</translation>
    </message>
    <message>
        <source>the condition is empty; write a comparison, as in %1.y &gt; 380.</source>
        <translation>die Bedingung ist leer; schreibe einen Vergleich, wie in %1.y &gt; 380.</translation>
    </message>
    <message>
        <source>this parenthesis closes nothing; remove it.</source>
        <translation>diese Klammer schließt nichts; entferne sie.</translation>
    </message>
    <message>
        <source>%1 cannot directly follow the text before it; put and, or, or a sign such as + or &lt; between them.</source>
        <translation>%1 kann nicht direkt auf den Text davor folgen; setze and, or oder ein Zeichen wie + oder &lt; dazwischen.</translation>
    </message>
    <message>
        <source>a comparison has only two sides; join two comparisons with and.</source>
        <translation>ein Vergleich hat nur zwei Seiten; verbinde zwei Vergleiche mit and.</translation>
    </message>
    <message>
        <source>names can only be equal or different; write == or !=.</source>
        <translation>Namen können nur gleich oder verschieden sein; schreibe == oder !=.</translation>
    </message>
    <message>
        <source>this parenthesis is not closed; close it with ).</source>
        <translation>diese Klammer ist nicht geschlossen; schließe sie mit ).</translation>
    </message>
    <message>
        <source>%1 cannot be here; a sign or ) is missing before it.</source>
        <translation>%1 kann hier nicht stehen; davor fehlt ein Zeichen oder ).</translation>
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
        <source>%1 needs parentheses around its number, as in %1(%2.vy).</source>
        <translation>%1 braucht Klammern um seine Zahl, wie in %1(%2.vy).</translation>
    </message>
    <message>
        <source>a comma can only be between two bodies, as in distance(%1, %2); write numbers with a point.</source>
        <translation>ein Komma kann nur zwischen zwei Körpern stehen wie in distance(%1, %2); schreib Zahlen mit Punkt.</translation>
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
        <source>%1 is a Vec2; ask for one of its numbers, %1.x or %1.y.</source>
        <translation>%1 ist ein Vec2; frag nach einer seiner Zahlen, %1.x oder %1.y.</translation>
    </message>
    <message>
        <source>%1 is a number, without members.</source>
        <translation>%1 ist eine Zahl und hat keine Teile.</translation>
    </message>
    <message>
        <source>distance needs two bodies with a comma between them, as in %1.</source>
        <translation>distance braucht zwei Körper mit einem Komma dazwischen wie in %1.</translation>
    </message>
    <message>
        <source>the name of a body is missing here, as in %1.</source>
        <translation>hier fehlt der Name eines Körpers wie in %1.</translation>
    </message>
</context>
<context>
    <name>ConditionTokensText</name>
    <message>
        <source>%1 is not a number; write one like 380, 0.5 or 1e-3.</source>
        <translation>%1 ist keine Zahl; schreibe eine wie 380, 0.5 oder 1e-3.</translation>
    </message>
    <message>
        <source>This text has no closing quotation mark; close it with %1.</source>
        <translation>Diesem Text fehlt das schließende Anführungszeichen; schließe ihn mit %1.</translation>
    </message>
    <message>
        <source>A single “=” would set a value; write == to compare two values.</source>
        <translation>Ein einzelnes „=“ würde einen Wert setzen; schreibe ==, um zwei Werte zu vergleichen.</translation>
    </message>
    <message>
        <source>A comma has no meaning here; write 0.5 with a point, and join conditions with “and”.</source>
        <translation>Ein Komma hat hier keine Bedeutung; schreibe 0.5 mit Punkt, und verbinde Bedingungen mit „and“.</translation>
    </message>
    <message>
        <source>%1 has no meaning here; there are numbers, names, + - * / ( ), comparisons, and, or, not.</source>
        <translation>%1 hat hier keine Bedeutung; es gibt Zahlen, Namen, + - * / ( ), Vergleiche, and, or, not.</translation>
    </message>
</context>
<context>
    <name>CostReportText</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
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
        <source>Each line is measured separately. Effects and method together take %1 of the time of the whole frame.</source>
        <translation>Jede Zeile wird für sich gemessen. Effekte und Verfahren brauchen zusammen %1 der Zeit des ganzen Bildes.</translation>
    </message>
</context>
<context>
    <name>CostText</name>
    <message>
        <source>The run does not reach frame %1. %2 Give an earlier frame.</source>
        <translation>Der Lauf kommt nicht bis Bild %1. %2 Gib ein früheres Bild an.</translation>
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
        <source>Measured %1 times</source>
        <translation>%1-mal gemessen</translation>
    </message>
</context>
<context>
    <name>DifferenceTableText</name>
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
    <name>DifferenceText</name>
    <message>
        <source>The other run is being computed again…</source>
        <translation>Der andere Lauf wird neu berechnet …</translation>
    </message>
    <message>
        <source>There is no other run to compare with.</source>
        <translation>Es gibt keinen anderen Lauf zum Vergleichen.</translation>
    </message>
    <message>
        <source>More than %1 points: too many to compare at every frame.</source>
        <translation>Mehr als %1 Punkte: zu viele, um sie bei jedem Bild zu vergleichen.</translation>
    </message>
    <message>
        <source>The other run does not have the selected body.</source>
        <translation>Den ausgewählten Körper gibt es im anderen Lauf nicht.</translation>
    </message>
    <message>
        <source>The two runs have no body in common.</source>
        <translation>Die zwei Läufe haben keinen Körper gemeinsam.</translation>
    </message>
    <message>
        <source>No difference up to frame %1. Play on to see whether one appears.</source>
        <translation>Kein Unterschied bis Bild %1. Spiele weiter, um zu sehen, ob einer entsteht.</translation>
    </message>
    <message>
        <source>Largest: %1&#x2009;px apart, %2, at frame %3.</source>
        <translation>Am größten: %1&#x2009;px auseinander, %2, bei Bild %3.</translation>
    </message>
    <message>
        <source>Compared every %1 frames.</source>
        <translation>Verglichen alle %1 Bilder.</translation>
    </message>
    <message>
        <source>branches off at frame %1</source>
        <translation>zweigt bei Bild %1 ab</translation>
    </message>
    <message>
        <source>branches off at the start</source>
        <translation>zweigt am Anfang ab</translation>
    </message>
    <message>
        <source>%1, %2, kept</source>
        <translation>%1, %2, behalten</translation>
    </message>
</context>
<context>
    <name>EdgeMarkersText</name>
    <message>
        <source>%1 bodies</source>
        <translation>%1 Körper</translation>
    </message>
</context>
<context>
    <name>EditHistory</name>
    <message>
        <source>undone: %1</source>
        <translation>rückgängig: %1</translation>
    </message>
</context>
<context>
    <name>EffectLinesText</name>
    <message>
        <source>Nearly all of a frame’s %2&#x2009;µs are spent in “%1”.</source>
        <translation>Fast alle %2&#x2009;µs eines Bildes entfallen auf „%1“.</translation>
    </message>
    <message>
        <source>Without “%1” a frame would cost %2&#x2009;µs instead of %3.</source>
        <translation>Ohne „%1“ würde ein Bild %2&#x2009;µs statt %3 kosten.</translation>
    </message>
    <message>
        <source>%1&#x2009;µs a frame; about half of the measurements are within %2.</source>
        <translation>%1&#x2009;µs pro Bild; etwa die Hälfte der Messungen liegt innerhalb von %2.</translation>
    </message>
    <message>
        <source>Points that it acts on: %1.</source>
        <translation>Punkte, auf die er wirkt: %1.</translation>
    </message>
    <message>
        <source>The method computes it together with the move.</source>
        <translation>Das Verfahren berechnet ihn zusammen mit der Bewegung.</translation>
    </message>
    <message>
        <source>Each frame computes it %1.</source>
        <translation>Jedes Bild berechnet ihn %1.</translation>
    </message>
    <message>
        <source>With these settings it changes nothing, so it is not computed: 0&#x2009;µs.</source>
        <translation>Mit diesen Einstellungen ändert er nichts, also wird er nicht berechnet: 0&#x2009;µs.</translation>
    </message>
    <message>
        <source>Switched off: it costs nothing.</source>
        <translation>Ausgeschaltet: Er kostet nichts.</translation>
    </message>
    <message>
        <source>Not in this scene, so it costs nothing.</source>
        <translation>Nicht in dieser Szene, also kostet es nichts.</translation>
    </message>
    <message>
        <source>Press Space or click the switch to turn it off.</source>
        <translation>Drück die Leertaste oder klicke auf den Schalter, um ihn auszuschalten.</translation>
    </message>
    <message>
        <source>Press Space or click the switch to turn it on again.</source>
        <translation>Drück die Leertaste oder klicke auf den Schalter, um ihn wieder einzuschalten.</translation>
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
        <source>not in this scene</source>
        <translation>nicht in dieser Szene</translation>
    </message>
    <message>
        <source>Rest of the frame</source>
        <translation>Rest des Bildes</translation>
    </message>
    <message>
        <source>Time outside the effects: moving the points, and the method&apos;s own sums. It cannot be switched off.</source>
        <translation>Zeit außerhalb der Effekte: das Bewegen der Punkte und die eigenen Rechnungen des Verfahrens. Sie lässt sich nicht ausschalten.</translation>
    </message>
    <message>
        <source>%1 (%2). %3</source>
        <translation>%1 (%2). %3</translation>
    </message>
    <message>
        <source>Not in this scene, so it costs nothing and has no switch. Other lessons have:</source>
        <translation>Nicht in dieser Szene, also kostet es nichts und hat keinen Schalter. In anderen Lektionen gibt es:</translation>
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
        <source>%1%2µs a frame, ±%3</source>
        <translation>%1%2µs pro Bild, ±%3</translation>
    </message>
</context>
<context>
    <name>EnergyLinesText</name>
    <message>
        <source>Energy that you add by dragging</source>
        <translation>Energie, die du durch Ziehen hineinsteckst</translation>
    </message>
    <message>
        <source>If a stiffness or a length changes, the energy stored in springs changes, too</source>
        <translation>Ändert sich eine Steifigkeit oder eine Länge, ändert sich auch die Energie in den Federn</translation>
    </message>
    <message>
        <source>Energy that gait clocks and steering add</source>
        <translation>Energie, die Ganguhren und Steuerung hineinstecken</translation>
    </message>
    <message>
        <source>Energy that the wind adds or takes away</source>
        <translation>Energie, die der Wind hineinsteckt oder wegnimmt</translation>
    </message>
    <message>
        <source>Energy that the force of your rule adds or takes away</source>
        <translation>Energie, die die Kraft deiner Regel zuführt oder entzieht</translation>
    </message>
    <message>
        <source>A pull without an opposite pull stores no energy. It adds energy or takes it away</source>
        <translation>Ein Zug ohne Gegenzug speichert keine Energie. Er bringt Energie hinein oder nimmt sie weg</translation>
    </message>
    <message>
        <source>It pulls everything down, and nothing pulls back</source>
        <translation>Sie zieht alles nach unten, und nichts zieht zurück</translation>
    </message>
    <message>
        <source>Springs pull on fixed places, and those pull back</source>
        <translation>Federn ziehen an festen Orten, und die ziehen zurück</translation>
    </message>
    <message>
        <source>Energy that damping takes from everything that moves</source>
        <translation>Energie, die die Dämpfung allem nimmt, das sich bewegt</translation>
    </message>
    <message>
        <source>Energy that walls and ground take, or add when they push bodies out</source>
        <translation>Energie, die Wände und Boden nehmen oder hineinstecken, wenn sie Körper herausschieben</translation>
    </message>
    <message>
        <source>Energy that sticks and joints change when they correct lengths and angles</source>
        <translation>Energie, die Stäbe und Gelenke ändern, wenn sie Längen und Winkel korrigieren</translation>
    </message>
    <message>
        <source>Gained or lost through the method&apos;s error, not through anything in the scene. A smaller step or another method makes it smaller.</source>
        <translation>Durch den Fehler des Verfahrens gewonnen oder verloren, nicht durch etwas in der Szene. Ein kleinerer Zeitschritt oder ein anderes Verfahren macht die Drift kleiner.</translation>
    </message>
    <message>
        <source>In motion</source>
        <translation>In der Bewegung</translation>
    </message>
    <message>
        <source>Half of mass × speed², added up over all points</source>
        <translation>Die Hälfte von Masse × Tempo², über alle Punkte addiert</translation>
    </message>
    <message>
        <source>In height</source>
        <translation>In der Höhe</translation>
    </message>
    <message>
        <source>Mass × gravity × height, measured from the lowest point of this run</source>
        <translation>Masse × Schwerkraft × Höhe, gemessen vom tiefsten Punkt dieses Laufs</translation>
    </message>
    <message>
        <source>In springs</source>
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
        <source>A rule sets the position of at least one body in each frame, so this body has no velocity and the energy cannot be counted. Choose a scene in which every body has inertia.</source>
        <translation>Eine Regel setzt in jedem Bild den Ort von mindestens einem Körper. Dieser Körper hat keine Geschwindigkeit, also lässt sich die Energie nicht zählen. Wähle eine Szene, in der jeder Körper Trägheit hat.</translation>
    </message>
    <message>
        <source>Nothing moves in this scene unless you drag it, so there is no energy to count. Choose a scene with a body on a spring.</source>
        <translation>In dieser Szene bewegt sich nichts, wenn du es nicht ziehst. Also gibt es keine Energie zu zählen. Wähle eine Szene mit einem Körper an einer Feder.</translation>
    </message>
    <message>
        <source>There are more than %1 points here. Counting the energy of all of them, phase by phase, would take longer than the run itself.</source>
        <translation>Hier gibt es mehr als %1 Punkte. Die Energie von allen Phase für Phase zu zählen, würde länger dauern als der Lauf selbst.</translation>
    </message>
    <message>
        <source>Something here turns, but its inertia is unknown. So there is no energy to count.</source>
        <translation>Etwas dreht sich hier, aber seine Trägheit ist nicht bekannt. Darum gibt es keine Energie zu zählen.</translation>
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
</context>
<context>
    <name>Experiment</name>
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
        <source>frame %1 is before the start of the branch, whose &quot;fork&quot; is %2; use frame %2 or a later one.</source>
        <translation>Bild %1 liegt vor dem Anfang des Zweigs, dessen &quot;fork&quot; %2 ist; nimm Bild %2 oder ein späteres.</translation>
    </message>
    <message>
        <source>this is a notebook, not an experiment; &quot;springstep notebook check&quot; replays it.</source>
        <translation>das ist ein Heft, kein Experiment; „springstep notebook check“ spielt es nach.</translation>
    </message>
    <message>
        <source>If it is a lesson without C++, open it in the window, or name its folder in SPRINGSTEP_LESSONS.</source>
        <translation>Wenn es eine Lektion ohne C++ ist, öffne sie im Fenster, oder nenne ihren Ordner in SPRINGSTEP_LESSONS.</translation>
    </message>
</context>
<context>
    <name>ExperimentArgumentText</name>
    <message>
        <source>Reading %1</source>
        <translation>Liest %1</translation>
    </message>
    <message>
        <source>%1 is neither a file nor a step; name a step as LESSON/STEP, as &quot;springstep lessons&quot; lists them.</source>
        <translation>%1 ist weder eine Datei noch ein Schritt; nenne einen Schritt als LESSON/STEP, wie &quot;springstep lessons&quot; sie auflistet.</translation>
    </message>
</context>
<context>
    <name>ExperimentInput</name>
    <message>
        <source>the step %1 has no event %2; it has %3.</source>
        <translation>der Schritt %1 hat kein Ereignis %2; er hat %3.</translation>
    </message>
    <message>
        <source>a body&apos;s name</source>
        <translation>der Name eines Körpers</translation>
    </message>
</context>
<context>
    <name>ExperimentLineText</name>
    <message>
        <source>The text begins like an experiment, but it is incomplete. Copy all of it, from “springstep:” to its end.</source>
        <translation>Der Text beginnt wie ein Experiment, ist aber nicht vollständig. Kopiere ihn ganz, von „springstep:“ bis zum Ende.</translation>
    </message>
    <message>
        <source>The text is larger than %1 MiB, the maximum for an experiment.</source>
        <translation>Der Text ist größer als %1 MiB, und mehr darf ein Experiment nicht haben.</translation>
    </message>
    <message>
        <source>This run has too much input for a message. Save it as a file, and send that.</source>
        <translation>Dieser Lauf hat zu viele Eingaben für eine Nachricht. Speichere ihn als Datei und verschicke diese.</translation>
    </message>
    <message>
        <source>There is no text to paste. Copy an experiment first: it begins with “springstep:” or {.</source>
        <translation>Es gibt keinen Text zum Einfügen. Kopiere zuerst ein Experiment: Es beginnt mit „springstep:“ oder {.</translation>
    </message>
    <message>
        <source>The copied text is not an experiment. An experiment begins with “springstep:” or {.</source>
        <translation>Der kopierte Text ist kein Experiment. Ein Experiment beginnt mit „springstep:“ oder {.</translation>
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
    <name>ExperimentMethodText</name>
    <message>
        <source>there is no method %1; there is %2.</source>
        <translation>es gibt kein Verfahren %1; es gibt %2.</translation>
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
        <source>the method %1 chooses its own steps; give &quot;tolerance&quot; instead of &quot;h&quot;.</source>
        <translation>das Verfahren %1 wählt seine Zeitschritte selbst; gib &quot;tolerance&quot; statt &quot;h&quot; an.</translation>
    </message>
    <message>
        <source>the method %1 has fixed steps; give &quot;h&quot; instead of &quot;tolerance&quot;.</source>
        <translation>das Verfahren %1 hat feste Zeitschritte; gib &quot;h&quot; statt &quot;tolerance&quot; an.</translation>
    </message>
    <message>
        <source>&quot;code&quot; needs the method %1; set &quot;method&quot; to it, or remove &quot;code&quot;.</source>
        <translation>&quot;code&quot; braucht das Verfahren %1; setze &quot;method&quot; darauf, oder entferne &quot;code&quot;.</translation>
    </message>
    <message>
        <source>the method %1 needs &quot;code&quot;, the text of a listing.</source>
        <translation>das Verfahren %1 braucht &quot;code&quot;, den Text eines Listings.</translation>
    </message>
    <message>
        <source>%1 has %2 bytes; it can have up to %3.</source>
        <translation>%1 hat %2 Bytes; höchstens %3 sind möglich.</translation>
    </message>
    <message>
        <source>&quot;code&quot; does not compile. Line %1: %2</source>
        <translation>&quot;code&quot; lässt sich nicht übersetzen. Zeile %1: %2</translation>
    </message>
</context>
<context>
    <name>ExperimentPointsText</name>
    <message>
        <source>a point&apos;s name</source>
        <translation>der Name eines Punktes</translation>
    </message>
    <message>
        <source>there is no point %1 here; there is &quot;p0&quot; to %2.</source>
        <translation>hier gibt es keinen Punkt %1; es gibt &quot;p0&quot; bis %2.</translation>
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
    <name>ExperimentText</name>
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
</context>
<context>
    <name>ExperimentWriterText</name>
    <message>
        <source>a number of this experiment is not finite, and a file cannot store such a number. Go back to an earlier frame.</source>
        <translation>eine Zahl dieses Experiments ist nicht endlich, und eine Datei kann so eine Zahl nicht speichern. Geh zurück zu einem früheren Bild.</translation>
    </message>
    <message>
        <source>the file would have too many other runs: it can have %1, with %2 events together. Delete some in “Runs”.</source>
        <translation>die Datei hätte zu viele andere Läufe: Erlaubt sind %1 mit zusammen %2 Ereignissen. Lösche einige in „Läufe“.</translation>
    </message>
    <message>
        <source>the step %1 is no longer installed. Install its lesson again.</source>
        <translation>der Schritt %1 ist nicht mehr installiert. Installiere seine Lektion neu.</translation>
    </message>
    <message>
        <source>the run has more input than a file can store. Restart it, or go back and continue from an earlier frame.</source>
        <translation>der Lauf hat mehr Eingaben, als in eine Datei passen. Starte ihn neu, oder geh zurück und mach bei einem früheren Bild weiter.</translation>
    </message>
    <message>
        <source>your code is longer than %1 bytes, the most that a file can store. Shorten it.</source>
        <translation>dein Code ist länger als %1 Bytes; mehr kann eine Datei nicht speichern. Kürze ihn.</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>&amp;New: the step as published</source>
        <translation>&amp;Neu: der Schritt wie veröffentlicht</translation>
    </message>
    <message>
        <source>&amp;Open an experiment or a lesson…</source>
        <translation>Experiment oder Lektion ö&amp;ffnen …</translation>
    </message>
    <message>
        <source>An experiment, or a lesson: its lesson.json or its .springstep-lesson file</source>
        <translation>Ein Experiment oder eine Lektion: ihre lesson.json oder ihre Datei .springstep-lesson</translation>
    </message>
    <message>
        <source>Reco&amp;ver scenes…</source>
        <translation>Szenen &amp;wiederherstellen…</translation>
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
        <source>&amp;Picture of the scene…</source>
        <translation>&amp;Bild der Szene …</translation>
    </message>
    <message>
        <source>&amp;Film of the run…</source>
        <translation>&amp;Film des Laufs …</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>The scene as it is shown, as PNG or SVG</source>
        <translation>Die Szene, wie sie zu sehen ist, als PNG oder SVG</translation>
    </message>
    <message>
        <source>The run as a video, an animated GIF or a PNG for each frame</source>
        <translation>Der Lauf als Video, als animiertes GIF oder als ein PNG für jedes Bild</translation>
    </message>
    <message>
        <source>&amp;Keep in gallery</source>
        <translation>In der Ga&amp;lerie behalten</translation>
    </message>
    <message>
        <source>&amp;Gallery…</source>
        <translation>&amp;Galerie …</translation>
    </message>
    <message>
        <source>Keep the experiment with a picture, without choosing a file</source>
        <translation>Das Experiment mit einem Bild behalten, ohne eine Datei zu wählen</translation>
    </message>
    <message>
        <source>What you keep: open, rename or remove it</source>
        <translation>Was du behältst: öffnen, umbenennen oder entfernen</translation>
    </message>
    <message>
        <source>&amp;Hand in a notebook…</source>
        <translation>&amp;Heft abgeben …</translation>
    </message>
    <message>
        <source>Write what you did into a file for your teacher, or onto a page</source>
        <translation>Schreib, was du gemacht hast, in eine Datei für deine Lehrkraft oder auf eine Seite</translation>
    </message>
    <message>
        <source>&amp;Web page of the run…</source>
        <translation>&amp;Webseite des Laufs …</translation>
    </message>
    <message>
        <source>One file that plays the run in any browser, with the listing and the plots</source>
        <translation>Eine Datei, die den Lauf in jedem Browser abspielt, mit Listing und Diagrammen</translation>
    </message>
    <message>
        <source>&amp;Handout of the lesson…</source>
        <translation>A&amp;rbeitsblatt der Lektion …</translation>
    </message>
    <message>
        <source>The lesson on paper, as a PDF: with lines to write on, and the answers at the end</source>
        <translation>Die Lektion auf Papier, als PDF: mit Zeilen zum Schreiben und den Antworten am Ende</translation>
    </message>
</context>
<context>
    <name>FileRowText</name>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Auswählen …</translation>
    </message>
    <message>
        <source>Choose a folder and a name</source>
        <translation>Wähle einen Ordner und einen Namen</translation>
    </message>
</context>
<context>
    <name>FilmFileText</name>
    <message>
        <source>Could not write %1: %2. Free some disk space, or choose another folder.</source>
        <translation>%1 ließ sich nicht schreiben: %2. Schaffe Platz oder wähle einen anderen Ordner.</translation>
    </message>
    <message>
        <source>%1 is not a film&apos;s name: choose one that ends in .webm or .gif. For a picture of each frame, choose one that ends in .png and has %04d for the frame&apos;s number, such as walk_%04d.png.</source>
        <translation>%1 ist kein Name für einen Film: Wähle einen, der auf .webm oder .gif endet. Für eine Datei pro Bild wähle einen, der auf .png endet und %04d für die Nummer des Bildes enthält, zum Beispiel walk_%04d.png.</translation>
    </message>
</context>
<context>
    <name>FilmText</name>
    <message>
        <source>Frame %1 of %2, %3 %</source>
        <translation>Bild %1 von %2, %3 %</translation>
    </message>
    <message>
        <source>Setting up the run</source>
        <translation>Bereitet den Lauf vor</translation>
    </message>
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
    <message>
        <source>--fps is for a film in one file; PNG files have no time in them. Leave it out.</source>
        <translation>--fps ist für einen Film in einer Datei; PNG-Dateien enthalten keine Zeit. Lass es weg.</translation>
    </message>
    <message>
        <source>%1 For a web page, choose one that ends in .html.</source>
        <translation>%1 Für eine Webseite wähle einen, der auf .html endet.</translation>
    </message>
    <message>
        <source>--%1 is for web pages, which end in .html. Leave it out.</source>
        <translation>--%1 ist für Webseiten, die auf .html enden. Lass es weg.</translation>
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
        <source>go to the body that it points to</source>
        <translation>zu dem Körper gehen, auf den er zeigt</translation>
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
        <source>select the previous or the next body</source>
        <translation>den vorigen oder den nächsten Körper auswählen</translation>
    </message>
    <message>
        <source>Alt and an arrow key</source>
        <translation>Alt und eine Pfeiltaste</translation>
    </message>
    <message>
        <source>move the selected body 10 px</source>
        <translation>den ausgewählten Körper 10 px bewegen</translation>
    </message>
    <message>
        <source>Press the background</source>
        <translation>Auf den Hintergrund drücken</translation>
    </message>
    <message>
        <source>blow, steer or aim, in steps that have this</source>
        <translation>blasen, lenken oder zielen, in Schritten, die das haben</translation>
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
        <source>steer, in steps that have this</source>
        <translation>lenken, in Schritten, die das haben</translation>
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
        <source>press or release the pointer&apos;s button</source>
        <translation>die Taste des Zeigers drücken oder loslassen</translation>
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
        <source>compare with the run that branches off there; right-click: more</source>
        <translation>mit dem Lauf vergleichen, der dort abzweigt; Rechtsklick: mehr</translation>
    </message>
    <message>
        <source>Shift and a click</source>
        <translation>Umschalt und ein Klick</translation>
    </message>
    <message>
        <source>add a part to the selection, or remove it</source>
        <translation>ein Teil zur Auswahl hinzunehmen oder daraus entfernen</translation>
    </message>
    <message>
        <source>select all parts in the box</source>
        <translation>alle Teile im Rahmen auswählen</translation>
    </message>
    <message>
        <source>Drag from point to point</source>
        <translation>Von Punkt zu Punkt ziehen</translation>
    </message>
    <message>
        <source>connect them, with the Spring or the Stick tool</source>
        <translation>sie verbinden, mit dem Werkzeug Feder oder Stab</translation>
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
        <source>move the selected parts 10 px, with Shift 1 px</source>
        <translation>die ausgewählten Teile um 10 px bewegen, mit Umschalt um 1 px</translation>
    </message>
    <message>
        <source>{ and }</source>
        <translation>{ und }</translation>
    </message>
    <message>
        <source>select the previous or the next spring or stick</source>
        <translation>die vorige oder nächste Verbindung auswählen</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>end a row of links, put the tool away, clear the selection</source>
        <translation>eine Reihe von Verbindungen beenden, das Werkzeug weglegen, die Auswahl aufheben</translation>
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
        <source>preview that moment; the run stays at its frame</source>
        <translation>eine Vorschau dieses Moments zeigen; der Lauf bleibt bei seinem Bild</translation>
    </message>
    <message>
        <source>Alt and the underlined letter</source>
        <translation>Alt und der unterstrichene Buchstabe</translation>
    </message>
    <message>
        <source>use a remedy, when a run has failed</source>
        <translation>ein Gegenmittel anwenden, wenn ein Lauf gescheitert ist</translation>
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
        <source>choose what it shows</source>
        <translation>wählen, was es zeigt</translation>
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
        <source>Click left of a line, or %1</source>
        <translation>Links neben eine Zeile klicken, oder %1</translation>
    </message>
    <message>
        <source>set or remove a breakpoint before its phase</source>
        <translation>einen Haltepunkt vor ihrer Phase setzen oder entfernen</translation>
    </message>
    <message>
        <source>Drag a dotted word</source>
        <translation>Ein gepunktetes Wort ziehen</translation>
    </message>
    <message>
        <source>change that parameter; with Shift in small steps</source>
        <translation>diesen Parameter ändern; mit Umschalt in kleinen Schritten</translation>
    </message>
    <message>
        <source>Double-click it, or %1</source>
        <translation>Doppelklick darauf, oder %1</translation>
    </message>
    <message>
        <source>type the parameter&apos;s value</source>
        <translation>den Wert des Parameters eintippen</translation>
    </message>
    <message>
        <source>Point at a word, or %1</source>
        <translation>Auf ein Wort zeigen, oder %1</translation>
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
        <source>show the lines that this step removed</source>
        <translation>die Zeilen zeigen, die dieser Schritt entfernt hat</translation>
    </message>
    <message>
        <source>copy the selection, or the whole region</source>
        <translation>die Auswahl kopieren, oder den ganzen Bereich</translation>
    </message>
    <message>
        <source>Stop when…</source>
        <translation>Anhalten, wenn …</translation>
    </message>
    <message>
        <source>the field below the code: stop when a condition becomes true</source>
        <translation>das Feld unter dem Code: anhalten, wenn eine Bedingung wahr wird</translation>
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
        <source>set the largest error that you accept</source>
        <translation>den größten Fehler einstellen, den du hinnimmst</translation>
    </message>
    <message>
        <source>Click left of a line, in the listing</source>
        <translation>Links neben eine Zeile klicken, im Listing</translation>
    </message>
    <message>
        <source>Point at a place or a velocity, in the listing</source>
        <translation>Auf einen Ort oder eine Geschwindigkeit zeigen, im Listing</translation>
    </message>
    <message>
        <source>see it in the picture</source>
        <translation>im Bild ansehen</translation>
    </message>
    <message>
        <source>Drag a number, in the listing</source>
        <translation>Eine Zahl ziehen, im Listing</translation>
    </message>
    <message>
        <source>change it; with Shift in small steps</source>
        <translation>sie ändern; mit Umschalt in kleinen Schritten</translation>
    </message>
    <message>
        <source>%1, in the listing</source>
        <translation>%1, im Listing</translation>
    </message>
    <message>
        <source>complete a name</source>
        <translation>einen Namen vervollständigen</translation>
    </message>
    <message>
        <source>Esc, in the listing</source>
        <translation>Esc, im Listing</translation>
    </message>
    <message>
        <source>leave it, so that keys move the run again</source>
        <translation>es verlassen, damit die Tasten wieder den Lauf bewegen</translation>
    </message>
    <message>
        <source>Ctrl and a click left of a line, or %1, in the listing</source>
        <translation>Strg und links neben eine Zeile klicken, oder %1, im Listing</translation>
    </message>
    <message>
        <source>set or remove a breakpoint before it</source>
        <translation>einen Haltepunkt vor ihr setzen oder entfernen</translation>
    </message>
</context>
<context>
    <name>GroundLayersText</name>
    <message>
        <source>%1&#x202f;px</source>
        <translation>%1&#x202f;px</translation>
    </message>
</context>
<context>
    <name>Gui</name>
    <message>
        <source>No lesson was found in %1. Build the lessons, or name their folder in SPRINGSTEP_LESSONS.</source>
        <translation>In %1 wurde keine Lektion gefunden. Baue die Lektionen oder nenne ihren Ordner in SPRINGSTEP_LESSONS.</translation>
    </message>
    <message>
        <source>%1 could not be written: give a folder that you may write to, and a name that ends in .png or .jpg.</source>
        <translation>%1 ließ sich nicht schreiben: Nenne einen Ordner, in den du schreiben darfst, und einen Namen, der auf .png oder .jpg endet.</translation>
    </message>
</context>
<context>
    <name>Handout</name>
    <message>
        <source>Name:</source>
        <translation>Name:</translation>
    </message>
    <message>
        <source>Date:</source>
        <translation>Datum:</translation>
    </message>
    <message>
        <source>Answers: %1</source>
        <translation>Antworten: %1</translation>
    </message>
    <message>
        <source>Predict</source>
        <translation>Sag voraus</translation>
    </message>
    <message>
        <source>Mark the place in the picture.</source>
        <translation>Kreuze die Stelle im Bild an.</translation>
    </message>
    <message>
        <source>Try this</source>
        <translation>Probier das</translation>
    </message>
    <message>
        <source>Write it yourself: %1</source>
        <translation>Schreib es selbst: %1</translation>
    </message>
    <message>
        <source>Build: %1</source>
        <translation>Bau: %1</translation>
    </message>
</context>
<context>
    <name>HandoutCliText</name>
    <message>
        <source>handout: %1</source>
        <translation>handout: %1</translation>
    </message>
    <message>
        <source>%1 is not the name of a handout; it ends in .pdf.</source>
        <translation>%1 ist kein Name für ein Arbeitsblatt; er endet auf .pdf.</translation>
    </message>
    <message>
        <source>%1 of %2 pictures</source>
        <translation>%1 von %2 Bildern</translation>
    </message>
    <message>
        <source>Stopped before the handout was written.</source>
        <translation>Abgebrochen, bevor das Arbeitsblatt geschrieben war.</translation>
    </message>
</context>
<context>
    <name>HandoutExportText</name>
    <message>
        <source>Handout of the lesson</source>
        <translation>Arbeitsblatt der Lektion</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>The pictures of “%1” are drawn…</source>
        <translation>Die Bilder von „%1“ werden gezeichnet …</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>HardCasesText</name>
    <message>
        <source>There is no case %1; there is %2.</source>
        <translation>Es gibt keinen Fall %1; es gibt %2.</translation>
    </message>
    <message>
        <source>%1, %2: %3 %</source>
        <translation>%1, %2: %3 %</translation>
    </message>
</context>
<context>
    <name>HardReportText</name>
    <message>
        <source>method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>claims</source>
        <translation>Zusage</translation>
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
        <source>holds</source>
        <translation>hält</translation>
    </message>
</context>
<context>
    <name>HelpCommands</name>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Tasten und Maus</translation>
    </message>
    <message>
        <source>Show a &amp;hint</source>
        <translation>T&amp;ipp zeigen</translation>
    </message>
    <message>
        <source>&amp;Glossary</source>
        <translation>&amp;Glossar</translation>
    </message>
    <message>
        <source>Take the &amp;tour</source>
        <translation>&amp;Rundgang machen</translation>
    </message>
    <message>
        <source>&amp;About Springstep</source>
        <translation>Ü&amp;ber Springstep</translation>
    </message>
    <message>
        <source>A hint for the next thing to try</source>
        <translation>Ein Tipp, was als Nächstes auszuprobieren ist</translation>
    </message>
    <message>
        <source>The words that the lessons teach</source>
        <translation>Die Begriffe, die die Lektionen lehren</translation>
    </message>
    <message>
        <source>A one-minute tour of this window</source>
        <translation>Ein Rundgang durch dieses Fenster in einer Minute</translation>
    </message>
    <message>
        <source>Version, licence and libraries</source>
        <translation>Version, Lizenz und Bibliotheken</translation>
    </message>
    <message>
        <source>&amp;Map of concepts</source>
        <translation>&amp;Karte der Begriffe</translation>
    </message>
    <message>
        <source>The concepts of all lessons: what rests on what, and what you know</source>
        <translation>Die Begriffe aller Lektionen: was worauf beruht und was du schon weißt</translation>
    </message>
</context>
<context>
    <name>Highlights</name>
    <message>
        <source>%1&#x2009;px/frame</source>
        <translation>%1&#x2009;px/Bild</translation>
    </message>
    <message>
        <source>the arrow from %1 to %2</source>
        <translation>der Pfeil von %1 zu %2</translation>
    </message>
    <message>
        <source>x from %1 to %2</source>
        <translation>x von %1 bis %2</translation>
    </message>
    <message>
        <source>y from %1 to %2</source>
        <translation>y von %1 bis %2</translation>
    </message>
    <message>
        <source>the velocity of %1</source>
        <translation>die Geschwindigkeit von %1</translation>
    </message>
    <message>
        <source>the circle around %1</source>
        <translation>der Kreis um %1</translation>
    </message>
</context>
<context>
    <name>HudText</name>
    <message>
        <source>%1 (before: %2)</source>
        <translation>%1 (vorher: %2)</translation>
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
        <source>rest length</source>
        <translation>Ruhelänge</translation>
    </message>
    <message>
        <source>velocity of %1&#x2009;px/frame</source>
        <translation>Geschwindigkeit von %1&#x2009;px/Bild</translation>
    </message>
    <message>
        <source>pull of %1&#x2009;px/frame²</source>
        <translation>Zug von %1&#x2009;px/Bild²</translation>
    </message>
</context>
<context>
    <name>JsonDocumentText</name>
    <message>
        <source>%1 is too large for a number; the largest is %2.</source>
        <translation>%1 ist zu groß für eine Zahl; die größte ist %2.</translation>
    </message>
    <message>
        <source>%1 is given twice; keep one of them.</source>
        <translation>%1 ist zweimal angegeben; behalte eines davon.</translation>
    </message>
    <message>
        <source>lists and objects are nested more than %1 deep here; an experiment needs only 3 levels.</source>
        <translation>Listen und Objekte sind hier mehr als %1-fach verschachtelt; ein Experiment braucht nur 3 Ebenen.</translation>
    </message>
    <message>
        <source>here begins one value too many; an experiment has at most %1 values.</source>
        <translation>hier beginnt ein Wert zu viel; ein Experiment hat höchstens %1 Werte.</translation>
    </message>
    <message>
        <source>there is text after the end; remove everything after the closing bracket.</source>
        <translation>nach dem Ende steht noch Text; entferne alles nach der schließenden Klammer.</translation>
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
        <source>a text in double quotes is not valid; it must end on its own line, and only &quot; \ / b f n r t u may follow a \.</source>
        <translation>ein Text in doppelten Anführungszeichen ist nicht gültig; er muss in seiner eigenen Zeile enden, und nach einem \ darf nur &quot; \ / b f n r t u stehen.</translation>
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
        <source>%1: line 1: the file is empty; it must begin with {.</source>
        <translation>%1: Zeile 1: Die Datei ist leer; sie muss mit { beginnen.</translation>
    </message>
    <message>
        <source>the file ends here too early; the rest of it is missing.</source>
        <translation>die Datei endet hier zu früh; ihr Rest fehlt.</translation>
    </message>
    <message>
        <source>%1: line %2: %3</source>
        <translation>%1: Zeile %2: %3</translation>
    </message>
    <message>
        <source>%1: this is a zip. The window opens a zipped lesson if its name ends in .springstep-lesson.</source>
        <translation>%1: Das ist ein Zip. Das Fenster öffnet eine gezippte Lektion, wenn ihr Name auf .springstep-lesson endet.</translation>
    </message>
    <message>
        <source>nothing follows the last comma before this %1; remove the comma.</source>
        <translation>nach dem letzten Komma vor diesem %1 folgt nichts; entferne das Komma.</translation>
    </message>
</context>
<context>
    <name>JsonFieldsText</name>
    <message>
        <source>%1 is %2; it must be %3.</source>
        <translation>%1 ist %2; es muss %3 sein.</translation>
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
        <source>%1 is %2; it can be a whole number from %3 to %4.</source>
        <translation>%1 ist %2; möglich ist eine ganze Zahl von %3 bis %4.</translation>
    </message>
    <message>
        <source>beyond 2^53</source>
        <translation>mehr als 2^53</translation>
    </message>
    <message>
        <source>%1 is %2; it must be an object in { }.</source>
        <translation>%1 ist %2; es muss ein Objekt in { } sein.</translation>
    </message>
    <message>
        <source>%1 has no %2; add it. It must be %3.</source>
        <translation>%1 hat kein %2; füge es hinzu. Es muss %3 sein.</translation>
    </message>
    <message>
        <source>%1 has no field %2; there is %3.</source>
        <translation>%1 hat kein Feld %2; es gibt %3.</translation>
    </message>
    <message>
        <source>%1 is %2; it can be %3 to %4.</source>
        <translation>%1 ist %2; möglich ist %3 bis %4.</translation>
    </message>
</context>
<context>
    <name>KeyNames</name>
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
</context>
<context>
    <name>LessonCheckText</name>
    <message>
        <source>the listing does not compile</source>
        <translation>das Listing lässt sich nicht übersetzen</translation>
    </message>
    <message>
        <source>one of them stops in frame %1</source>
        <translation>eins von beiden endet in Bild %1</translation>
    </message>
    <message>
        <source>the listing moves %1 otherwise than the method %2: %3 px apart in frame %4 of a trial run</source>
        <translation>das Listing bewegt %1 anders als die Methode %2: %3 px Abstand in Bild %4 eines Probelaufs</translation>
    </message>
    <message>
        <source>same motion as %1</source>
        <translation>dieselbe Bewegung wie %1</translation>
    </message>
    <message>
        <source>it is done in frame %1 without the learner; add a condition such as “- begun: released()”</source>
        <translation>in Bild %1 ist es ohne dein Zutun getan; füge eine Bedingung wie „- begun: released()“ hinzu</translation>
    </message>
    <message>
        <source>it states no solution; write a “### Solution”</source>
        <translation>es nennt keine Lösung; schreib ein „### Solution“</translation>
    </message>
    <message>
        <source>done in frame %1</source>
        <translation>getan in Bild %1</translation>
    </message>
    <message>
        <source>its solution does not do it in %1 frames</source>
        <translation>seine Lösung schafft es in %1 Bildern nicht</translation>
    </message>
    <message>
        <source>its solution does not do it in %1 frames: %2</source>
        <translation>seine Lösung schafft es in %1 Bildern nicht: %2</translation>
    </message>
    <message>
        <source>its solution does not do it in %1 frames: each condition holds in some frame, but they never all hold in the same one</source>
        <translation>seine Lösung schafft es in %1 Bildern nicht: Jede Bedingung gilt in irgendeinem Bild, aber nie gelten alle im selben</translation>
    </message>
    <message>
        <source>its condition does not hold up to frame %1</source>
        <translation>seine Bedingung trifft bis Bild %1 nicht zu</translation>
    </message>
    <message>
        <source>ends in frame %1</source>
        <translation>endet in Bild %1</translation>
    </message>
    <message>
        <source>%1, at (%2, %3)</source>
        <translation>%1, bei (%2, %3)</translation>
    </message>
    <message>
        <source>%1, with %2</source>
        <translation>%1, mit %2</translation>
    </message>
    <message>
        <source>two of its curves look the same</source>
        <translation>zwei seiner Kurven sehen gleich aus</translation>
    </message>
    <message>
        <source>the listing itself does not pass</source>
        <translation>das Listing selbst besteht nicht</translation>
    </message>
    <message>
        <source>the empty place passes</source>
        <translation>die leere Stelle besteht</translation>
    </message>
    <message>
        <source>near miss %1 is not told from the others or from the solution</source>
        <translation>der beinahe richtige Versuch %1 wird nicht von den anderen oder von der Lösung unterschieden</translation>
    </message>
    <message>
        <source>passes, with %1 near misses</source>
        <translation>besteht, mit %1 beinahe richtigen Versuchen</translation>
    </message>
    <message>
        <source>there is no step %1</source>
        <translation>es gibt keinen Schritt %1</translation>
    </message>
    <message>
        <source>the start scene passes</source>
        <translation>die Anfangsszene besteht</translation>
    </message>
    <message>
        <source>it states no solution; save one as %1</source>
        <translation>es nennt keine Lösung; sichere eine als %1</translation>
    </message>
    <message>
        <source>%1 passes</source>
        <translation>%1 besteht</translation>
    </message>
    <message>
        <source>has %1 choices</source>
        <translation>hat %1 Antworten zur Wahl</translation>
    </message>
    <message>
        <source>%1, in which the hand holds it. Every body can be held: write “if (%2.held) %2.position = hand;”, and leave the forces out then</source>
        <translation>%1, in dem die Hand ihn hält. Jeder Körper kann gehalten werden: Schreib „if (%2.held) %2.position = hand;“ und lass die Kräfte dann weg</translation>
    </message>
</context>
<context>
    <name>LessonFolderText</name>
    <message>
        <source>%1: this is not UTF-8. Save the file with the encoding UTF-8.</source>
        <translation>%1: Das ist kein UTF-8. Sichere die Datei mit der Kodierung UTF-8.</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>die Datei</translation>
    </message>
    <message>
        <source>&quot;format&quot; is %1; this program reads %2.</source>
        <translation>„format“ ist %1; dieses Programm liest %2.</translation>
    </message>
    <message>
        <source>a name of your own</source>
        <translation>ein eigener Name</translation>
    </message>
    <message>
        <source>a lesson cannot have the id %1; an id has up to 40 characters, a to z, 0 to 9 and _, and begins with a letter.</source>
        <translation>eine Lektion kann nicht die Kennung %1 haben; eine Kennung hat bis zu 40 Zeichen, a bis z, 0 bis 9 und _, und beginnt mit einem Buchstaben.</translation>
    </message>
    <message>
        <source>there is another lesson with the id %1, “%2”. Choose another id.</source>
        <translation>es gibt eine andere Lektion mit der Kennung %1, „%2“. Wähle eine andere.</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>%1 has %2 characters; it can have 1 to %3.</source>
        <translation>%1 hat %2 Zeichen; es kann 1 bis %3 haben.</translation>
    </message>
    <message>
        <source>a list of ids</source>
        <translation>eine Liste von Kennungen</translation>
    </message>
    <message>
        <source>a step cannot have the id %1; each has one of its own, made of a to z, 0 to 9 and _, and not lesson, recall or project.</source>
        <translation>ein Schritt kann nicht die Kennung %1 haben; jeder hat eine eigene aus a bis z, 0 bis 9 und _, und nicht lesson, recall oder project.</translation>
    </message>
    <message>
        <source>a lesson has 1 to %1 steps, and &quot;steps&quot; lists %2.</source>
        <translation>eine Lektion hat 1 bis %1 Schritte, und „steps“ nennt %2.</translation>
    </message>
    <message>
        <source>%1: the file is missing. It has %2.</source>
        <translation>%1: Die Datei fehlt. Darin steht %2.</translation>
    </message>
    <message>
        <source>%1: the listing has more than %2 bytes.</source>
        <translation>%1: Das Listing hat mehr als %2 Bytes.</translation>
    </message>
    <message>
        <source>%1: a listing computes whole frames, and the scene has steps of another length. Set &quot;h&quot; to 1 in %2.json.</source>
        <translation>%1: Ein Listing berechnet ganze Bilder, und die Szene hat Schritte von anderer Länge. Setz „h“ in %2.json auf 1.</translation>
    </message>
    <message>
        <source>%1: a near miss of the task %2 does not compile: %3</source>
        <translation>%1: Ein beinahe richtiger Versuch der Aufgabe %2 lässt sich nicht übersetzen: %3</translation>
    </message>
    <message>
        <source>%1: a lesson has files .md, .json and .code. Remove it.</source>
        <translation>%1: Eine Lektion hat Dateien .md, .json und .code. Entferne sie.</translation>
    </message>
    <message>
        <source>%1: there is no step %2 in &quot;steps&quot; of lesson.json; there is %3. Add it there, or rename the file.</source>
        <translation>%1: In „steps“ von lesson.json gibt es keinen Schritt %2; es gibt %3. Trag ihn dort ein, oder benenne die Datei um.</translation>
    </message>
    <message>
        <source>the scene that the project starts with</source>
        <translation>die Szene, mit der das Projekt beginnt</translation>
    </message>
    <message>
        <source>a text cannot show pictures. The scene is the picture; remove “![”.</source>
        <translation>Ein Text kann keine Bilder zeigen. Die Szene ist das Bild; entferne „![“.</translation>
    </message>
    <message>
        <source>the scene of the step: save it in the window under this name, with the ending .json</source>
        <translation>die Szene des Schritts: Sichere sie im Fenster unter diesem Namen, mit der Endung .json</translation>
    </message>
    <message>
        <source>the texts of the step. Write the file, or remove the step from lesson.json</source>
        <translation>der Text des Schritts. Schreib die Datei, oder nimm den Schritt aus lesson.json</translation>
    </message>
    <message>
        <source>%1: a listing computes this scene. Choose a method in the window, and write the listing into %2.code.</source>
        <translation>%1: Ein Listing berechnet diese Szene. Wähle im Fenster eine Methode, und schreib das Listing in %2.code.</translation>
    </message>
    <message>
        <source>%1: a step has at most %2 things to try, predictions and tasks, and a thing to try as many conditions and drags.</source>
        <translation>%1: Ein Schritt hat höchstens %2 Versuche, Vorhersagen und Aufgaben, und ein Versuch ebenso viele Bedingungen und Züge mit der Maus.</translation>
    </message>
    <message>
        <source>%1 says where the parameter %2 begins. Remove it here.</source>
        <translation>%1 sagt, wo der Parameter %2 beginnt. Entferne ihn hier.</translation>
    </message>
    <message>
        <source>%1: the scene is one of the lesson %2, which is not built in. Open that lesson, choose File &gt; New lesson from this scene, and take the scene that this writes.</source>
        <translation>%1: Die Szene gehört zur Lektion %2, die nicht eingebaut ist. Öffne diese Lektion, wähle Datei &gt; Neue Lektion aus dieser Szene, und nimm die Szene, die dabei entsteht.</translation>
    </message>
</context>
<context>
    <name>LessonLanguagesText</name>
    <message>
        <source>%1, step %2: the languages differ in %3. Make them the same.</source>
        <translation>%1, Schritt %2: Die Sprachen unterscheiden sich in %3. Gleiche sie an.</translation>
    </message>
    <message>
        <source>their predictions</source>
        <translation>ihren Vorhersagen</translation>
    </message>
    <message>
        <source>their tasks</source>
        <translation>ihren Aufgaben</translation>
    </message>
    <message>
        <source>their questions</source>
        <translation>ihren Fragen</translation>
    </message>
</context>
<context>
    <name>LessonPackageText</name>
    <message>
        <source>%1 is a link or a device. Put the file itself there.</source>
        <translation>%1 ist eine Verknüpfung oder ein Gerät. Leg die Datei selbst dorthin.</translation>
    </message>
    <message>
        <source>%1: a lesson has at most %2 files, with %3 MiB in all of them.</source>
        <translation>%1: Eine Lektion hat höchstens %2 Dateien mit zusammen %3 MiB.</translation>
    </message>
    <message>
        <source>%1: there is no such folder or file; check its name.</source>
        <translation>%1: Diesen Ordner oder diese Datei gibt es nicht; prüf den Namen.</translation>
    </message>
    <message>
        <source>%1: there is no lesson.json, which describes the lesson. Choose the folder that has it, or write it.</source>
        <translation>%1: Es gibt keine lesson.json, die die Lektion beschreibt. Wähle den Ordner, der sie hat, oder schreib sie.</translation>
    </message>
</context>
<context>
    <name>LessonParametersText</name>
    <message>
        <source>a parameter cannot be called “%1”: the word has another meaning in code, in conditions or in runs. Choose another id.</source>
        <translation>ein Parameter kann nicht „%1“ heißen: Das Wort bedeutet im Code, in Bedingungen oder in Läufen etwas anderes. Wähle eine andere Kennung.</translation>
    </message>
    <message>
        <source>the parameter “%1” has no range. Write “- minimum: 0” and “- maximum: 1” below its text, with your numbers.</source>
        <translation>der Parameter „%1“ hat keinen Bereich. Schreib „- minimum: 0“ und „- maximum: 1“ unter seinen Text, mit deinen Zahlen.</translation>
    </message>
    <message>
        <source>the minimum of “%1” is not below its maximum. Change one of them.</source>
        <translation>das Minimum von „%1“ liegt nicht unter dem Maximum. Ändere eins davon.</translation>
    </message>
    <message>
        <source>“%1” begins with the value that the scene has there. Remove “- value”.</source>
        <translation>„%1“ beginnt mit dem Wert, den die Szene dort hat. Entferne „- value“.</translation>
    </message>
    <message>
        <source>the parameter “%1” has no value at the start. Write “- value: %2”, or “- sets: k of a-b” with the names of two bodies that a spring joins.</source>
        <translation>der Parameter „%1“ hat am Anfang keinen Wert. Schreib „- value: %2“, oder „- sets: k of a-b“ mit den Namen zweier Körper, die eine Feder verbindet.</translation>
    </message>
    <message>
        <source>the step of “%1” is 1, so its numbers are whole. Choose a smaller step, such as 0.1.</source>
        <translation>der Schritt von „%1“ ist 1, also sind seine Zahlen ganz. Wähle einen kleineren Schritt, etwa 0.1.</translation>
    </message>
    <message>
        <source>the value of “%1” is %2, outside its range from %3 to %4. Change one of them.</source>
        <translation>der Wert von „%1“ ist %2 und liegt außerhalb des Bereichs von %3 bis %4. Ändere eins davon.</translation>
    </message>
    <message>
        <source>the %1 of “%2” differs between the languages. Remove it here: the numbers are in the first language.</source>
        <translation>„%1“ von „%2“ ist in den Sprachen verschieden. Entferne es hier: Die Zahlen stehen in der ersten Sprache.</translation>
    </message>
    <message>
        <source>the parameter “%1” is missing. Write “## Parameter: name {#%1}”, and a sentence below it.</source>
        <translation>der Parameter „%1“ fehlt. Schreib „## Parameter: Name {#%1}“ und einen Satz darunter.</translation>
    </message>
    <message>
        <source>%1 declares no parameter “%2”. Remove it here, or add it there.</source>
        <translation>%1 legt keinen Parameter „%2“ an. Entferne ihn hier oder füge ihn dort hinzu.</translation>
    </message>
    <message>
        <source>“sets” differs between the languages. Remove it here.</source>
        <translation>„sets“ ist in den Sprachen verschieden. Entferne es hier.</translation>
    </message>
    <message>
        <source>“%1” is not something that a parameter can set. Write “k of a-b” or “length of a-b” with the names of two bodies, and commas between several.</source>
        <translation>„%1“ kann ein Parameter nicht setzen. Schreib „k of a-b“ oder „length of a-b“ mit den Namen zweier Körper, und Kommas zwischen mehreren.</translation>
    </message>
    <message>
        <source>no spring of the scene joins “%1” and “%2”. Springs join %3.</source>
        <translation>keine Feder der Szene verbindet „%1“ und „%2“. Federn verbinden: %3.</translation>
    </message>
    <message>
        <source>no spring or stick of the scene joins “%1” and “%2”. They join %3.</source>
        <translation>keine Feder und kein Stab der Szene verbindet „%1“ und „%2“. Sie verbinden: %3.</translation>
    </message>
    <message>
        <source>“%1” can be %2 to %3 in a scene, and the parameter goes from %4 to %5. Change its minimum or maximum.</source>
        <translation>„%1“ kann in einer Szene %2 bis %3 sein, und der Parameter geht von %4 bis %5. Ändere sein Minimum oder Maximum.</translation>
    </message>
    <message>
        <source>a parameter of your own needs a scene of the sandbox. Remove “%1”, or take the scene to the sandbox (Ctrl+B) and save it there.</source>
        <translation>ein eigener Parameter braucht eine Szene des Sandkastens. Entferne „%1“, oder nimm die Szene in den Sandkasten mit (Strg+B) und speichere sie dort.</translation>
    </message>
    <message>
        <source>“%1” sets several numbers, of which one is %2 and another is %3 in the scene. Make them the same there, or use two parameters.</source>
        <translation>„%1“ setzt mehrere Zahlen, von denen eine in der Szene %2 ist und eine andere %3. Mach sie dort gleich, oder nimm zwei Parameter.</translation>
    </message>
    <message>
        <source>the scene has %1 there, which does not fit the parameter “%2” from %3 to %4. Change its minimum, maximum or step, or the scene.</source>
        <translation>die Szene hat dort %1, und das passt nicht zum Parameter „%2“ von %3 bis %4. Ändere sein Minimum, sein Maximum, seinen Schritt oder die Szene.</translation>
    </message>
    <message>
        <source>the scene has a parameter “%1” already. Choose another id.</source>
        <translation>die Szene hat schon einen Parameter „%1“. Wähle eine andere Kennung.</translation>
    </message>
    <message>
        <source>bodies of the scene are called “%1”. Choose another id.</source>
        <translation>Körper der Szene heißen „%1“. Wähle eine andere Kennung.</translation>
    </message>
    <message>
        <source>nothing reads the parameter “%1”. Write %1 into the rule of the scene in place of a number, or let it set one: “- sets: k of a-b”.</source>
        <translation>nichts liest den Parameter „%1“. Schreib %1 statt einer Zahl in die Regel der Szene, oder lass ihn eine setzen: „- sets: k of a-b“.</translation>
    </message>
    <message>
        <source>the scene has no springs. Build one, or write “- value: ” in place of “- sets: ”.</source>
        <translation>die Szene hat keine Federn. Bau eine, oder schreib „- value: “ statt „- sets: “.</translation>
    </message>
    <message>
        <source>the scene has no springs or sticks. Build one, or write “- value: ” in place of “- sets: ”.</source>
        <translation>die Szene hat keine Federn und keine Stäbe. Bau etwas davon, oder schreib „- value: “ statt „- sets: “.</translation>
    </message>
</context>
<context>
    <name>LessonPluginText</name>
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
        <source>the step %1 has no scene or no view</source>
        <translation>der Schritt %1 hat keine Szene oder keine Ansicht</translation>
    </message>
    <message>
        <source>the step %1 needs the method %2, which does not exist</source>
        <translation>der Schritt %1 braucht das Verfahren %2, das es nicht gibt</translation>
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
        <source>its steps could not be created (%1)</source>
        <translation>ihre Schritte ließen sich nicht erstellen (%1)</translation>
    </message>
    <message>
        <source>its description has no whole number &quot;order&quot;</source>
        <translation>ihre Beschreibung hat keine ganze Zahl &quot;order&quot;</translation>
    </message>
    <message>
        <source>It could not be loaded: %1. Build or install it again.</source>
        <translation>Sie ließ sich nicht laden: %1. Baue oder installiere sie neu.</translation>
    </message>
    <message>
        <source>its description lists the steps %1, its code has %2</source>
        <translation>ihre Beschreibung zählt die Schritte %1 auf, ihr Code hat %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>its project could not be read (%1)</source>
        <translation>ihr Projekt konnte nicht gelesen werden (%1)</translation>
    </message>
    <message>
        <source>its questions could not be read (%1)</source>
        <translation>ihre Fragen konnten nicht gelesen werden (%1)</translation>
    </message>
</context>
<context>
    <name>LessonStepText</name>
    <message>
        <source>%1 stands for a number, and this condition does not compare one. Write a comparison with the number on its left, or a sentence without %1.</source>
        <translation>%1 steht für eine Zahl, und diese Bedingung vergleicht keine. Schreib einen Vergleich mit der Zahl auf der linken Seite, oder einen Satz ohne %1.</translation>
    </message>
    <message>
        <source>nothing says when the thing to try “%1” is done. Write a “### Done when” with a list, as in “- pulled: released(%2)”.</source>
        <translation>Nichts sagt, wann der Versuch „%1“ getan ist. Schreib ein „### Done when“ mit einer Liste, etwa „- pulled: released(%2)“.</translation>
    </message>
</context>
<context>
    <name>LessonWriterText</name>
    <message>
        <source>## Try {#pull}

Pull **%1** aside, and let go of it. What does it do?

### Hint

Press **Space**. Hold the mouse button on %1, move the mouse, and let go.

### Answer

Write here what one can see then.

### Done when

- begun: held(%1) or released(%1)
- let_go: released(%1)

### Missing

- let_go: let go of it.

### Solution

- drag %1: %2, %3, 10
- frames: 30

</source>
        <translation>## Try {#pull}

Zieh **%1** zur Seite und lass los. Was tut es?

### Hint

Drück die **Leertaste**. Halte die Maustaste auf %1, beweg die Maus und lass los.

### Answer

Schreib hier, was man dann sieht.

### Done when

- begun: held(%1) or released(%1)
- let_go: released(%1)

### Missing

- let_go: lass es los.

### Solution

- drag %1: %2, %3, 10
- frames: 30

</translation>
    </message>
    <message>
        <source>## Predict {#where}

Nobody touches anything. Where is %1 after 60 frames? Click the place.

### Run

- frames: 60

### Ask

- place: %1

### Answer

Write here why it is there.

</source>
        <translation>## Predict {#where}

Niemand berührt etwas. Wo ist %1 nach 60 Bildern? Klick auf die Stelle.

### Run

- frames: 60

### Ask

- place: %1

### Answer

Schreib hier, warum es dort ist.

</translation>
    </message>
    <message>
        <source># The title of the step

Write here what a learner should look at, why it is so, and the rule to keep. Save this file, and the window shows what you wrote.

Below are parts that a step can have. Change them, copy them, or remove them.

</source>
        <translation># Der Titel des Schritts

Schreib hier, worauf man achten soll, warum es so ist, und welche Regel man sich merkt. Sichere diese Datei, und das Fenster zeigt, was du geschrieben hast.

Darunter stehen Teile, die ein Schritt haben kann. Ändere sie, kopier sie oder entferne sie.

</translation>
    </message>
    <message>
        <source>## Word: Step

Forms: none

A word that the text uses, in one sentence.

## Why: Why is it so?

Write here a question that learners ask, and the answer.

## Learnt

Write here in one sentence what a learner knows now.
</source>
        <translation>## Word: Schritt

Forms: none

Ein Wort, das der Text verwendet, in einem Satz.

## Why: Warum ist das so?

Schreib hier eine Frage, die sich stellt, und die Antwort.

## Learnt

Schreib hier in einem Satz, was man jetzt weiß.
</translation>
    </message>
    <message>
        <source>My lesson</source>
        <translation>Meine Lektion</translation>
    </message>
    <message>
        <source>What it is about, in one sentence.</source>
        <translation>Worum es geht, in einem Satz.</translation>
    </message>
    <message>
        <source>%1 is not empty. Choose a new folder for the lesson.</source>
        <translation>%1 ist nicht leer. Wähle einen neuen Ordner für die Lektion.</translation>
    </message>
    <message>
        <source>%1: the folder could not be made. Choose another place.</source>
        <translation>%1: Der Ordner ließ sich nicht anlegen. Wähle einen anderen Ort.</translation>
    </message>
    <message>
        <source>There is no step %1 any more. Open another one, and begin the lesson with its scene.</source>
        <translation>Den Schritt %1 gibt es nicht mehr. Öffne einen anderen und beginne die Lektion mit dessen Szene.</translation>
    </message>
</context>
<context>
    <name>LessonsText</name>
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
    <name>LinePositionText</name>
    <message>
        <source>before line %1, %2 of %3 lines run</source>
        <translation>vor Zeile %1, %2 von %3 Zeilen gelaufen</translation>
    </message>
    <message>
        <source>before line %1, %2 lines run</source>
        <translation>vor Zeile %1, %2 Zeilen gelaufen</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Bild %1</translation>
    </message>
</context>
<context>
    <name>LineValuesText</name>
    <message>
        <source>%1: from %2 to %3</source>
        <translation>%1: von %2 auf %3</translation>
    </message>
    <message>
        <source>%1 = %2 of %3</source>
        <translation>%1 = %2 von %3</translation>
    </message>
    <message>
        <source>no body</source>
        <translation>kein Körper</translation>
    </message>
    <message>
        <source>This frame runs more than %1 lines. The others are not shown.</source>
        <translation>In diesem Bild laufen mehr als %1 Zeilen. Die übrigen werden nicht gezeigt.</translation>
    </message>
</context>
<context>
    <name>ListingText</name>
    <message>
        <source>Did you mean %1?</source>
        <translation>Meintest du %1?</translation>
    </message>
    <message>
        <source>%1 is not a member of an array of bodies.</source>
        <translation>%1 ist kein Teil einer Liste von Körpern.</translation>
    </message>
    <message>
        <source>%1 is not a member of the array of creatures.</source>
        <translation>%1 ist kein Teil der Liste der Wesen.</translation>
    </message>
    <message>
        <source>%1 is not a member of the array of sticks.</source>
        <translation>%1 ist kein Teil der Liste der Stäbe.</translation>
    </message>
    <message>
        <source>%1 is not a member of the new targets.</source>
        <translation>%1 ist kein Teil der neuen Ziele.</translation>
    </message>
    <message>
        <source>%1 is not a member of the keys.</source>
        <translation>%1 ist keine der Tasten.</translation>
    </message>
    <message>
        <source>%1 is not a member of %2.</source>
        <translation>%1 ist kein Teil von %2.</translation>
    </message>
    <message>
        <source>It has %1.</source>
        <translation>Es hat %1.</translation>
    </message>
    <message>
        <source>Choose one of them first, for example with [0].</source>
        <translation>Wähle zuerst einen davon, zum Beispiel mit [0].</translation>
    </message>
    <message>
        <source>There is no function %1.</source>
        <translation>Es gibt keine Funktion %1.</translation>
    </message>
    <message>
        <source>There is no type %1.</source>
        <translation>Es gibt keinen Typ %1.</translation>
    </message>
    <message>
        <source>The types are %1.</source>
        <translation>Die Typen sind %1.</translation>
    </message>
    <message>
        <source>The functions are %1.</source>
        <translation>Die Funktionen sind %1.</translation>
    </message>
    <message>
        <source>There is no %1: %2 is empty.</source>
        <translation>Es gibt kein %1: %2 ist leer.</translation>
    </message>
    <message>
        <source>There is no %1: the only one is %2.</source>
        <translation>Es gibt kein %1: Das einzige ist %2.</translation>
    </message>
    <message>
        <source>There is no %1: %2 goes from %3 to %4.</source>
        <translation>Es gibt kein %1: %2 reicht von %3 bis %4.</translation>
    </message>
    <message>
        <source>There is no %1.</source>
        <translation>Es gibt kein %1.</translation>
    </message>
    <message>
        <source>This scene has %1, and the numbers %2.</source>
        <translation>Diese Szene hat %1 und die Zahlen %2.</translation>
    </message>
    <message>
        <source>This scene has %1, and the number %2.</source>
        <translation>Diese Szene hat %1 und die Zahl %2.</translation>
    </message>
    <message>
        <source>This scene has the numbers %1.</source>
        <translation>Diese Szene hat die Zahlen %1.</translation>
    </message>
    <message>
        <source>This scene has the number %1.</source>
        <translation>Diese Szene hat die Zahl %1.</translation>
    </message>
    <message>
        <source>This scene has %1.</source>
        <translation>Diese Szene hat %1.</translation>
    </message>
    <message>
        <source>There already is %1 here.</source>
        <translation>%1 gibt es hier schon.</translation>
    </message>
    <message>
        <source>There already is %1 in this scene.</source>
        <translation>%1 gibt es in dieser Szene schon.</translation>
    </message>
    <message>
        <source>Use another name.</source>
        <translation>Nimm einen anderen Namen.</translation>
    </message>
    <message>
        <source>A new variable needs a type: %1, %2 or %3.</source>
        <translation>Eine neue Variable braucht einen Typ: %1, %2 oder %3.</translation>
    </message>
    <message>
        <source>This is an array of bodies.</source>
        <translation>Das ist eine Liste von Körpern.</translation>
    </message>
    <message>
        <source>%1 does not take these values: %2.</source>
        <translation>%1 nimmt diese Werte nicht: %2.</translation>
    </message>
    <message>
        <source>A %1 cannot be used as a %2.</source>
        <translation>Ein %1 lässt sich nicht als %2 verwenden.</translation>
    </message>
    <message>
        <source>This sign does not work between a %1 and the other value.</source>
        <translation>Dieses Zeichen geht nicht zwischen einem %1 und dem anderen Wert.</translation>
    </message>
    <message>
        <source>This sign does not work between a %1 and a %2.</source>
        <translation>Dieses Zeichen geht nicht zwischen einem %1 und einem %2.</translation>
    </message>
    <message>
        <source>A Vec2 can be added to a Vec2, and multiplied or divided by a number.</source>
        <translation>Ein Vec2 lässt sich zu einem Vec2 addieren, und mit einer Zahl malnehmen oder durch sie teilen.</translation>
    </message>
    <message>
        <source>Use the position or the velocity of the body.</source>
        <translation>Nimm den Ort oder die Geschwindigkeit des Körpers.</translation>
    </message>
    <message>
        <source>%1 is a %2 here, not a function.</source>
        <translation>%1 ist hier ein %2 und keine Funktion.</translation>
    </message>
    <message>
        <source>This is not a function.</source>
        <translation>Das ist keine Funktion.</translation>
    </message>
    <message>
        <source>%1 is not a function.</source>
        <translation>%1 ist keine Funktion.</translation>
    </message>
    <message>
        <source>Write it without &apos;()&apos;.</source>
        <translation>Schreibe es ohne &apos;()&apos;.</translation>
    </message>
    <message>
        <source>To multiply, write &apos;*&apos;.</source>
        <translation>Zum Malnehmen schreibe &apos;*&apos;.</translation>
    </message>
    <message>
        <source>Both values of a choice with ? need the same type.</source>
        <translation>Beide Werte einer Auswahl mit ? brauchen denselben Typ.</translation>
    </message>
    <message>
        <source>Write %1 for %2 beside a double.</source>
        <translation>Schreibe neben einem double %1 statt %2.</translation>
    </message>
    <message>
        <source>Between whole numbers, &apos;/&apos; drops the fraction: this is %1.</source>
        <translation>Zwischen ganzen Zahlen lässt &apos;/&apos; den Rest weg: Das ist %1.</translation>
    </message>
    <message>
        <source>Between whole numbers, &apos;/&apos; drops the fraction.</source>
        <translation>Zwischen ganzen Zahlen lässt &apos;/&apos; den Rest weg.</translation>
    </message>
    <message>
        <source>An &apos;int&apos; keeps no fraction, and this value may have one.</source>
        <translation>Ein &apos;int&apos; behält keine Nachkommastellen, und dieser Wert kann welche haben.</translation>
    </message>
    <message>
        <source>Write %1, or round down with %2.</source>
        <translation>Schreibe %1, oder runde mit %2 ab.</translation>
    </message>
    <message>
        <source>A value is missing at the end of this line.</source>
        <translation>Am Ende dieser Zeile fehlt ein Wert.</translation>
    </message>
    <message>
        <source>A name is missing at the end of this line.</source>
        <translation>Am Ende dieser Zeile fehlt ein Name.</translation>
    </message>
    <message>
        <source>%1 is missing at the end of this line.</source>
        <translation>Am Ende dieser Zeile fehlt %1.</translation>
    </message>
    <message>
        <source>%1 is missing before %2.</source>
        <translation>Vor %2 fehlt %1.</translation>
    </message>
    <message>
        <source>This %1 has no %2.</source>
        <translation>Zu diesem %1 fehlt das %2.</translation>
    </message>
    <message>
        <source>A value is missing here.</source>
        <translation>Hier fehlt ein Wert.</translation>
    </message>
    <message>
        <source>The name of a type is missing here: %1.</source>
        <translation>Hier fehlt der Name eines Typs: %1.</translation>
    </message>
    <message>
        <source>A name is missing here.</source>
        <translation>Hier fehlt ein Name.</translation>
    </message>
    <message>
        <source>The name of a member is missing behind the dot.</source>
        <translation>Hinter dem Punkt fehlt der Name eines Teils.</translation>
    </message>
    <message>
        <source>%1 is missing here.</source>
        <translation>Hier fehlt %1.</translation>
    </message>
    <message>
        <source>A Body cannot be replaced by another one.</source>
        <translation>Ein Body lässt sich nicht durch einen anderen ersetzen.</translation>
    </message>
    <message>
        <source>Set its position or its velocity.</source>
        <translation>Setze seinen Ort oder seine Geschwindigkeit.</translation>
    </message>
    <message>
        <source>This cannot be changed.</source>
        <translation>Das lässt sich nicht ändern.</translation>
    </message>
    <message>
        <source>This is a parameter.</source>
        <translation>Das ist ein Parameter.</translation>
    </message>
    <message>
        <source>Set it with its slider.</source>
        <translation>Stelle ihn mit seinem Schieberegler ein.</translation>
    </message>
    <message>
        <source>A listing changes positions, velocities and its own variables.</source>
        <translation>Ein Listing ändert Orte, Geschwindigkeiten und seine eigenen Variablen.</translation>
    </message>
    <message>
        <source>A %1 cannot be set as a whole.</source>
        <translation>Ein %1 lässt sich nicht als Ganzes setzen.</translation>
    </message>
    <message>
        <source>%1 has no value yet.</source>
        <translation>%1 hat noch keinen Wert.</translation>
    </message>
    <message>
        <source>Give it one: %1.</source>
        <translation>Gib ihm einen: %1.</translation>
    </message>
    <message>
        <source>A condition is true or false.</source>
        <translation>Eine Bedingung ist wahr oder falsch.</translation>
    </message>
    <message>
        <source>%1 is a type and has no value.</source>
        <translation>%1 ist ein Typ und hat keinen Wert.</translation>
    </message>
    <message>
        <source>Use its x, its y or its length.</source>
        <translation>Nimm sein x, sein y oder seine Länge.</translation>
    </message>
    <message>
        <source>This sign does not work with this value.</source>
        <translation>Dieses Zeichen passt nicht zu diesem Wert.</translation>
    </message>
    <message>
        <source>Only an array has an index in &apos;[...]&apos;.</source>
        <translation>Nur eine Liste hat einen Index in &apos;[...]&apos;.</translation>
    </message>
    <message>
        <source>This computes a value, and nothing keeps it.</source>
        <translation>Das berechnet einen Wert, und nichts behält ihn.</translation>
    </message>
    <message>
        <source>Compare this with something, for example with == or &gt;.</source>
        <translation>Vergleiche das mit etwas, zum Beispiel mit == oder &gt;.</translation>
    </message>
    <message>
        <source>This function can end without &apos;return&apos;.</source>
        <translation>Diese Funktion kann ohne &apos;return&apos; enden.</translation>
    </message>
    <message>
        <source>It has to return a value in every case.</source>
        <translation>Sie muss in jedem Fall einen Wert zurückgeben.</translation>
    </message>
    <message>
        <source>This function has to return a value.</source>
        <translation>Diese Funktion muss einen Wert zurückgeben.</translation>
    </message>
    <message>
        <source>A &apos;void&apos; function returns no value.</source>
        <translation>Eine Funktion mit &apos;void&apos; gibt keinen Wert zurück.</translation>
    </message>
    <message>
        <source>The text ends too early: a &apos;}&apos; or a &apos;)&apos; is missing.</source>
        <translation>Der Text endet zu früh: Es fehlt eine &apos;}&apos; oder eine &apos;)&apos;.</translation>
    </message>
    <message>
        <source>A Body variable needs a body, for example %1.</source>
        <translation>Eine Variable vom Typ Body braucht einen Körper, zum Beispiel %1.</translation>
    </message>
    <message>
        <source>%1 cannot be remembered from frame to frame.</source>
        <translation>%1 lässt sich nicht von Bild zu Bild merken.</translation>
    </message>
    <message>
        <source>Only numbers, bool and Vec2 can.</source>
        <translation>Das geht nur mit Zahlen, bool und Vec2.</translation>
    </message>
    <message>
        <source>The first value of %1 cannot be computed.</source>
        <translation>Der erste Wert von %1 lässt sich nicht berechnen.</translation>
    </message>
    <message>
        <source>Write the number itself, without %1.</source>
        <translation>Schreibe die Zahl selbst, ohne %1.</translation>
    </message>
    <message>
        <source>The function &apos;void frame()&apos; is missing.</source>
        <translation>Die Funktion &apos;void frame()&apos; fehlt.</translation>
    </message>
    <message>
        <source>It runs once in every frame.</source>
        <translation>Sie läuft einmal in jedem Bild.</translation>
    </message>
    <message>
        <source>A listing cannot make arrays.</source>
        <translation>Ein Listing kann keine eigenen Listen anlegen.</translation>
    </message>
    <message>
        <source>Write a variable for each value.</source>
        <translation>Schreib für jeden Wert eine Variable.</translation>
    </message>
    <message>
        <source>This is outside of any function.</source>
        <translation>Das steht außerhalb einer Funktion.</translation>
    </message>
    <message>
        <source>A function cannot be inside another function.</source>
        <translation>Eine Funktion kann nicht in einer anderen stehen.</translation>
    </message>
    <message>
        <source>Move it out.</source>
        <translation>Verschiebe sie nach außen.</translation>
    </message>
    <message>
        <source>%1 works only in a loop.</source>
        <translation>%1 geht nur in einer Schleife.</translation>
    </message>
    <message>
        <source>%1 does not belong here.</source>
        <translation>%1 gehört nicht hierher.</translation>
    </message>
    <message>
        <source>Put it between the braces of a function.</source>
        <translation>Schreibe es zwischen die geschweiften Klammern einer Funktion.</translation>
    </message>
    <message>
        <source>Look for a &apos;}&apos; too many above.</source>
        <translation>Suche weiter oben nach einer überzähligen &apos;}&apos;.</translation>
    </message>
    <message>
        <source>A function begins with the type of its result, for example %1 or %2.</source>
        <translation>Eine Funktion beginnt mit dem Typ ihres Ergebnisses, zum Beispiel %1 oder %2.</translation>
    </message>
    <message>
        <source>A function is called without an object here: %1.</source>
        <translation>Eine Funktion wird hier ohne Objekt aufgerufen: %1.</translation>
    </message>
    <message>
        <source>This text cannot be compiled.</source>
        <translation>Dieses Listing lässt sich nicht übersetzen.</translation>
    </message>
    <message>
        <source>Texts in quotes are not part of this language.</source>
        <translation>Texte in Anführungszeichen gehören nicht zu dieser Sprache.</translation>
    </message>
    <message>
        <source>It has numbers, bool and Vec2.</source>
        <translation>Sie hat Zahlen, bool und Vec2.</translation>
    </message>
    <message>
        <source>This character is not part of this language.</source>
        <translation>Dieses Zeichen gehört nicht zu dieser Sprache.</translation>
    </message>
    <message>
        <source>%1 is reserved and not part of this language.</source>
        <translation>%1 ist reserviert und gehört nicht zu dieser Sprache.</translation>
    </message>
    <message>
        <source>%1 is not part of this language.</source>
        <translation>%1 gehört nicht zu dieser Sprache.</translation>
    </message>
    <message>
        <source>A Body variable already stands for the body itself.</source>
        <translation>Eine Variable vom Typ Body steht schon für den Körper selbst.</translation>
    </message>
    <message>
        <source>A loop is written %1.</source>
        <translation>Eine Schleife schreibst du so: %1.</translation>
    </message>
    <message>
        <source>A comment begins with %1.</source>
        <translation>Ein Kommentar beginnt mit %1.</translation>
    </message>
    <message>
        <source>A name begins with a letter.</source>
        <translation>Ein Name beginnt mit einem Buchstaben.</translation>
    </message>
    <message>
        <source>A name has only the letters a to z, digits and &apos;_&apos;.</source>
        <translation>Ein Name hat nur die Buchstaben a bis z, Ziffern und &apos;_&apos;.</translation>
    </message>
    <message>
        <source>A listing cannot print: its values are shown beside its lines.</source>
        <translation>Ein Listing gibt nichts aus: Seine Werte stehen neben seinen Zeilen.</translation>
    </message>
    <message>
        <source>A power is %1.</source>
        <translation>Eine Potenz ist %1.</translation>
    </message>
    <message>
        <source>Write a position or a velocity as %1.</source>
        <translation>Einen Ort oder eine Geschwindigkeit schreibst du so: %1.</translation>
    </message>
    <message>
        <source>A condition needs brackets: %1.</source>
        <translation>Eine Bedingung steht in Klammern: %1.</translation>
    </message>
    <message>
        <source>Leave out the &apos;:&apos;.</source>
        <translation>Lass das &apos;:&apos; weg.</translation>
    </message>
    <message>
        <source>The lines that belong to a condition go between &apos;{&apos; and &apos;}&apos;.</source>
        <translation>Die Zeilen, die zu einer Bedingung gehören, stehen zwischen &apos;{&apos; und &apos;}&apos;.</translation>
    </message>
    <message>
        <source>This &apos;;&apos; ends %1, so that nothing belongs to it.</source>
        <translation>Dieses &apos;;&apos; beendet %1, sodass nichts dazu gehört.</translation>
    </message>
    <message>
        <source>Delete the &apos;;&apos;.</source>
        <translation>Lösche das &apos;;&apos;.</translation>
    </message>
    <message>
        <source>Leave it out.</source>
        <translation>Lass es weg.</translation>
    </message>
    <message>
        <source>Use %1.</source>
        <translation>Nimm %1.</translation>
    </message>
    <message>
        <source>A number ends without &apos;f&apos; here.</source>
        <translation>Eine Zahl endet hier ohne &apos;f&apos;.</translation>
    </message>
    <message>
        <source>A number has a point, not a comma: %1.</source>
        <translation>Eine Zahl hat hier einen Punkt und kein Komma: %1.</translation>
    </message>
    <message>
        <source>&apos;void&apos; is only for functions, for example %1.</source>
        <translation>&apos;void&apos; steht nur vor einer Funktion, zum Beispiel %1.</translation>
    </message>
    <message>
        <source>%1 returns no value, so call it on its own: %2.</source>
        <translation>%1 gibt keinen Wert zurück. Rufe es für sich auf: %2.</translation>
    </message>
    <message>
        <source>&apos;=&apos; sets a value, and can be used once in a statement.</source>
        <translation>&apos;=&apos; setzt einen Wert und steht nur einmal in einer Anweisung.</translation>
    </message>
    <message>
        <source>To compare, write &apos;==&apos;.</source>
        <translation>Zum Vergleichen schreibe &apos;==&apos;.</translation>
    </message>
    <message>
        <source>&apos;==&apos; compares and changes nothing.</source>
        <translation>&apos;==&apos; vergleicht nur und ändert nichts.</translation>
    </message>
    <message>
        <source>To set a value, write &apos;=&apos;.</source>
        <translation>Um einen Wert zu setzen, schreibe &apos;=&apos;.</translation>
    </message>
    <message>
        <source>Only a variable can be set: a name, with members or an index behind it.</source>
        <translation>Nur eine Variable lässt sich setzen: ein Name, mit Teilen oder einem Index dahinter.</translation>
    </message>
    <message>
        <source>Compare two values at a time, for example %1.</source>
        <translation>Vergleiche immer zwei Werte, zum Beispiel %1.</translation>
    </message>
    <message>
        <source>Write &apos;*&apos; between a number and a name: %1.</source>
        <translation>Schreibe &apos;*&apos; zwischen eine Zahl und einen Namen: %1.</translation>
    </message>
    <message>
        <source>Write &apos;+=&apos; to add to a value.</source>
        <translation>Schreibe &apos;+=&apos;, um zu einem Wert etwas zu addieren.</translation>
    </message>
    <message>
        <source>Write &apos;-=&apos; to subtract from a value.</source>
        <translation>Schreibe &apos;-=&apos;, um von einem Wert abzuziehen.</translation>
    </message>
    <message>
        <source>Write &apos;.&apos; between a body and its member, for example %1.</source>
        <translation>Schreibe &apos;.&apos; zwischen einen Körper und seinen Teil, zum Beispiel %1.</translation>
    </message>
    <message>
        <source>Write %1 to compare.</source>
        <translation>Schreibe %1, um zu vergleichen.</translation>
    </message>
    <message>
        <source>Write %1 without a space in between.</source>
        <translation>Schreibe %1 ohne Leerzeichen dazwischen.</translation>
    </message>
    <message>
        <source>Write %1 with small letters.</source>
        <translation>Schreibe %1 mit kleinen Buchstaben.</translation>
    </message>
    <message>
        <source>Write it as %1.</source>
        <translation>Schreibe es so: %1.</translation>
    </message>
    <message>
        <source>Write %1.</source>
        <translation>Schreibe %1.</translation>
    </message>
    <message>
        <source>There are more than %1 &apos;else&apos; in this listing.</source>
        <translation>In diesem Listing stehen mehr als %1 &apos;else&apos;.</translation>
    </message>
    <message>
        <source>There are more than %1 brackets inside one another.</source>
        <translation>Mehr als %1 Klammern stehen ineinander.</translation>
    </message>
    <message>
        <source>This statement is too long.</source>
        <translation>Diese Anweisung ist zu lang.</translation>
    </message>
    <message>
        <source>Split it in two.</source>
        <translation>Teile sie in zwei.</translation>
    </message>
    <message>
        <source>The variables outside of functions take %1 bytes.</source>
        <translation>Die Variablen außerhalb von Funktionen brauchen %1 Bytes.</translation>
    </message>
    <message>
        <source>This listing has %1 bytes.</source>
        <translation>Dieses Listing hat %1 Bytes.</translation>
    </message>
    <message>
        <source>The most is %1.</source>
        <translation>Erlaubt sind höchstens %1.</translation>
    </message>
    <message>
        <source>This variable stands for no body.</source>
        <translation>Diese Variable steht für keinen Körper.</translation>
    </message>
    <message>
        <source>This divides by 0.</source>
        <translation>Hier wird durch 0 geteilt.</translation>
    </message>
    <message>
        <source>The result is too large for a number.</source>
        <translation>Das Ergebnis ist zu groß für eine Zahl.</translation>
    </message>
    <message>
        <source>This loop still runs after %1 lines.</source>
        <translation>Diese Schleife läuft nach %1 Zeilen immer noch.</translation>
    </message>
    <message>
        <source>It ends only when its condition becomes false.</source>
        <translation>Sie endet erst, wenn ihre Bedingung nicht mehr gilt.</translation>
    </message>
    <message>
        <source>This still runs after %1 lines.</source>
        <translation>Das läuft nach %1 Zeilen immer noch.</translation>
    </message>
    <message>
        <source>A function calls itself too often.</source>
        <translation>Eine Funktion ruft sich selbst zu oft auf.</translation>
    </message>
    <message>
        <source>Functions call functions %1 times inside one another.</source>
        <translation>Funktionen rufen %1-mal ineinander Funktionen auf.</translation>
    </message>
    <message>
        <source>Functions call functions too many times inside one another.</source>
        <translation>Funktionen rufen zu oft ineinander Funktionen auf.</translation>
    </message>
    <message>
        <source>A function that calls itself needs a case in which it does not.</source>
        <translation>Eine Funktion, die sich selbst aufruft, braucht einen Fall, in dem sie es nicht tut.</translation>
    </message>
    <message>
        <source>The position of %1 is not a finite number.</source>
        <translation>Der Ort von %1 ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>The velocity of %1 is not a finite number.</source>
        <translation>Die Geschwindigkeit von %1 ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>The angle or the spin of %1 is not a finite number.</source>
        <translation>Der Winkel oder die Drehung von %1 ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>Look for the root of a negative number, or for a number that grows in each frame.</source>
        <translation>Suche nach der Wurzel einer negativen Zahl oder nach einer Zahl, die in jedem Bild wächst.</translation>
    </message>
    <message>
        <source>The gait of %1 is not a finite number.</source>
        <translation>Der Gang von %1 ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>%1 is not a finite number.</source>
        <translation>%1 ist keine endliche Zahl.</translation>
    </message>
    <message>
        <source>The interpreter stopped.</source>
        <translation>Der Interpreter hat angehalten.</translation>
    </message>
    <message>
        <source> and </source>
        <comment>in a list</comment>
        <translation> und </translation>
    </message>
    <message>
        <source> or </source>
        <comment>in a list</comment>
        <translation> oder </translation>
    </message>
    <message>
        <source>A rule needs the function %1 or %2.</source>
        <translation>Eine Regel braucht die Funktion %1 oder %2.</translation>
    </message>
    <message>
        <source>The function %1 of a rule has the form %2.</source>
        <translation>Die Funktion %1 einer Regel hat die Form %2.</translation>
    </message>
    <message>
        <source>A rule remembers nothing, so %1 cannot be outside of a function.</source>
        <translation>Eine Regel merkt sich nichts, darum kann %1 nicht außerhalb einer Funktion stehen.</translation>
    </message>
    <message>
        <source>Move it into one.</source>
        <translation>Verschiebe es in eine.</translation>
    </message>
    <message>
        <source>The force is not a finite number.</source>
        <translation>Die Kraft ist keine endliche Zahl.</translation>
    </message>
</context>
<context>
    <name>MapTableText</name>
    <message>
        <source>step [frames]</source>
        <translation>Zeitschritt [Bilder]</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>in Ruhe</translation>
    </message>
    <message>
        <source>still moving</source>
        <translation>bewegt sich noch</translation>
    </message>
    <message>
        <source>grows</source>
        <translation>wächst</translation>
    </message>
    <message>
        <source>cannot be computed</source>
        <translation>nicht zu berechnen</translation>
    </message>
    <message>
        <source>growth [a frame]</source>
        <translation>Wachstum [pro Bild]</translation>
    </message>
    <message>
        <source>time to rest [frames]</source>
        <translation>Zeit bis zur Ruhe [Bilder]</translation>
    </message>
    <message>
        <source>outcome</source>
        <translation>Ergebnis</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>E&amp;xportieren</translation>
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
</context>
<context>
    <name>NotebookCheckText</name>
    <message>
        <source>Its run takes more than %1 s to replay.</source>
        <translation>Sein Lauf braucht zum Nachspielen mehr als %1 s.</translation>
    </message>
    <message>
        <source>It was ticked by a version that kept no runs.</source>
        <translation>Es wurde in einer Version abgehakt, die keine Läufe aufhob.</translation>
    </message>
    <message>
        <source>Its run is of another step.</source>
        <translation>Sein Lauf gehört zu einem anderen Schritt.</translation>
    </message>
    <message>
        <source>At frame %1 its run does not do it.</source>
        <translation>Bei Bild %1 leistet sein Lauf das nicht.</translation>
    </message>
    <message>
        <source>Still to do: %1</source>
        <translation>Noch zu tun: %1</translation>
    </message>
    <message>
        <source>Its answer cannot be read.</source>
        <translation>Seine Antwort ist nicht lesbar.</translation>
    </message>
    <message>
        <source>The notebook counts “%1” as %2, but the run gives “%3”.</source>
        <translation>Das Heft zählt „%1“ als %2, aber der Lauf ergibt „%3“.</translation>
    </message>
    <message>
        <source>The notebook counts “%1” as %2, but the answer of the lesson is “%3”.</source>
        <translation>Das Heft zählt „%1“ als %2, aber die Antwort der Lektion ist „%3“.</translation>
    </message>
    <message>
        <source>right</source>
        <translation>richtig</translation>
    </message>
    <message>
        <source>not right</source>
        <translation>nicht richtig</translation>
    </message>
    <message>
        <source>The notebook says that the run gives “%1”, but it gives “%2”.</source>
        <translation>Laut Heft ergibt der Lauf „%1“, er ergibt aber „%2“.</translation>
    </message>
    <message>
        <source>“%1” was said; it is “%2”.</source>
        <translation>Gesagt wurde „%1“; es ist „%2“.</translation>
    </message>
</context>
<context>
    <name>NotebookFileText</name>
    <message>
        <source>the file</source>
        <translation>die Datei</translation>
    </message>
    <message>
        <source>this is not a notebook: its &quot;format&quot; is %1, and this program reads %2.</source>
        <translation>das ist kein Heft: sein &quot;format&quot; ist %1, und dieses Programm liest %2.</translation>
    </message>
    <message>
        <source>the seal of the file</source>
        <translation>das Siegel der Datei</translation>
    </message>
    <message>
        <source>&quot;name&quot; has %1 letters; it can have up to %2.</source>
        <translation>&quot;name&quot; hat %1 Buchstaben; möglich sind bis zu %2.</translation>
    </message>
    <message>
        <source>a list of what was done</source>
        <translation>eine Liste dessen, was gemacht wurde</translation>
    </message>
    <message>
        <source>&quot;entries&quot; has %1 entries; it can have up to %2.</source>
        <translation>&quot;entries&quot; hat %1 Einträge; möglich sind bis zu %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time; write it as 2026-01-31T12:00:00Z.</source>
        <translation>&quot;%1&quot; ist keine Zeit; schreib sie wie 2026-01-31T12:00:00Z.</translation>
    </message>
    <message>
        <source>an entry</source>
        <translation>ein Eintrag</translation>
    </message>
    <message>
        <source>the id of what was done</source>
        <translation>die Kennung dessen, was gemacht wurde</translation>
    </message>
    <message>
        <source>the id of a step</source>
        <translation>die Kennung eines Schritts</translation>
    </message>
    <message>
        <source>the answer</source>
        <translation>die Antwort</translation>
    </message>
    <message>
        <source>what the run showed</source>
        <translation>was der Lauf zeigte</translation>
    </message>
    <message>
        <source>&quot;kind&quot; is %1; it can be %2.</source>
        <translation>&quot;kind&quot; ist %1; möglich ist %2.</translation>
    </message>
    <message>
        <source>the runs are larger than %1 MiB together, the maximum for a notebook.</source>
        <translation>die Läufe sind zusammen größer als %1 MiB, das Höchstmaß für ein Heft.</translation>
    </message>
    <message>
        <source>the run of %1 is damaged, or larger than %2 MiB; ask for the notebook again.</source>
        <translation>der Lauf von %1 ist beschädigt oder größer als %2 MiB; bitte noch einmal um das Heft.</translation>
    </message>
    <message>
        <source>there is no %1 called %2 in %3; the notebook may be from another version of the lesson.</source>
        <translation>in %3 gibt es kein „%1“ namens %2; das Heft stammt vielleicht aus einer anderen Version der Lektion.</translation>
    </message>
    <message>
        <source>%1 is there twice; ask for the notebook again.</source>
        <translation>%1 steht zweimal da; bitte noch einmal um das Heft.</translation>
    </message>
    <message>
        <source>%1: this is not a notebook; a notebook is text in UTF-8.</source>
        <translation>%1: Das ist kein Heft; ein Heft ist Text in UTF-8.</translation>
    </message>
    <message>
        <source>The notebook would be too large. Choose fewer lessons, or leave out the gallery.</source>
        <translation>Das Heft würde zu groß. Wähle weniger Lektionen oder lass die Galerie weg.</translation>
    </message>
    <message>
        <source>If it is a lesson without C++, name its folder or its zip beside the notebook.</source>
        <translation>Ist es eine Lektion ohne C++, dann nenne ihren Ordner oder ihr Zip neben dem Heft.</translation>
    </message>
</context>
<context>
    <name>NotebookPageText</name>
    <message>
        <source>Notebook</source>
        <translation>Heft</translation>
    </message>
    <message>
        <source>Notebook of %1</source>
        <translation>Heft von %1</translation>
    </message>
    <message>
        <source>Springstep, %1</source>
        <translation>Springstep, %1</translation>
    </message>
    <message>
        <source>Nothing is done yet.</source>
        <translation>Noch ist nichts gemacht.</translation>
    </message>
    <message>
        <source>Project: %1</source>
        <translation>Projekt: %1</translation>
    </message>
    <message>
        <source>Built and kept</source>
        <translation>Gebaut und behalten</translation>
    </message>
    <message>
        <source>The scene at that moment</source>
        <translation>Die Szene in diesem Augenblick</translation>
    </message>
</context>
<context>
    <name>NotebookReportText</name>
    <message>
        <source>%1 of %2 are shown by their runs.</source>
        <translation>%1 von %2 sind durch ihre Läufe belegt.</translation>
    </message>
    <message>
        <source>The file was changed after it was written.</source>
        <translation>Die Datei wurde nach dem Schreiben verändert.</translation>
    </message>
    <message>
        <source>Nothing is in it.</source>
        <translation>Es enthält nichts.</translation>
    </message>
</context>
<context>
    <name>NotebookText</name>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1: %2 von %3</translation>
    </message>
    <message>
        <source>%1 of %2 notebooks could not be read.</source>
        <translation>%1 von %2 Heften ließen sich nicht lesen.</translation>
    </message>
    <message>
        <source>notebook page takes FILE OUT; see springstep notebook --help.</source>
        <translation>notebook page nimmt FILE OUT; siehe springstep notebook --help.</translation>
    </message>
    <message>
        <source>%1 is not the name of a page; it can end in .html or .pdf.</source>
        <translation>%1 ist kein Name einer Seite; er kann auf .html oder .pdf enden.</translation>
    </message>
    <message>
        <source>--lessons: %1</source>
        <translation>--lessons: %1</translation>
    </message>
    <message>
        <source>notebook write takes OUT; see springstep notebook --help.</source>
        <translation>notebook write nimmt OUT; siehe springstep notebook --help.</translation>
    </message>
    <message>
        <source>%1 is not the name of a notebook; it ends in %2.</source>
        <translation>%1 ist kein Name eines Hefts; er endet auf %2.</translation>
    </message>
    <message>
        <source>notebook cannot %1; it can &quot;check&quot;, &quot;page&quot; or &quot;write&quot;.</source>
        <translation>notebook kann nicht %1; es kann &quot;check&quot;, &quot;page&quot; oder &quot;write&quot;.</translation>
    </message>
    <message>
        <source>notebook check takes FILE...; see springstep notebook --help.</source>
        <translation>notebook check nimmt FILE...; siehe springstep notebook --help.</translation>
    </message>
    <message>
        <source>--%1 is for notebook check. Leave it out.</source>
        <translation>--%1 ist für notebook check. Lass es weg.</translation>
    </message>
    <message>
        <source>--%1 is for notebook write. Leave it out.</source>
        <translation>--%1 ist für notebook write. Lass es weg.</translation>
    </message>
    <message>
        <source>--json and --csv are two forms of the result. Leave one out.</source>
        <translation>--json und --csv sind zwei Formen des Ergebnisses. Lass eines weg.</translation>
    </message>
</context>
<context>
    <name>OptionValuesText</name>
    <message>
        <source>--%1 is %2; it can be %3 to %4.</source>
        <translation>--%1 ist %2; möglich ist %3 bis %4.</translation>
    </message>
    <message>
        <source>--%1 is %2; it can be a whole number from 0 to %3.</source>
        <translation>--%1 ist %2; möglich ist eine ganze Zahl von 0 bis %3.</translation>
    </message>
    <message>
        <source>--size is %1; it can be WIDTHxHEIGHT in pixels, each from 100 to 9999, such as 1280x800.</source>
        <translation>--size ist %1; möglich ist BREITExHÖHE in Pixeln, beides von 100 bis 9999, zum Beispiel 1280x800.</translation>
    </message>
    <message>
        <source>--theme is %1; it can be &quot;light&quot;, &quot;dark&quot; or &quot;contrast&quot;.</source>
        <translation>--theme ist %1; möglich ist &quot;light&quot;, &quot;dark&quot; oder &quot;contrast&quot;.</translation>
    </message>
    <message>
        <source>--language is %1; it can be %2.</source>
        <translation>--language ist %1; möglich ist %2.</translation>
    </message>
</context>
<context>
    <name>ParameterValueText</name>
    <message>
        <source>%1 is %2; it can be one of %3.</source>
        <translation>%1 ist %2; möglich ist eines von %3.</translation>
    </message>
    <message>
        <source>the step %1 has no parameter %2; it has %3.</source>
        <translation>der Schritt %1 hat keinen Parameter %2; er hat %3.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
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
    <name>PhrasesText</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1&#x2009;px</source>
        <translation>%1&#x2009;px</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>Bild %1</translation>
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
    <name>PictureFileText</name>
    <message>
        <source>%1 could not be written: %2. Choose another folder or name.</source>
        <translation>%1 ließ sich nicht schreiben: %2. Wähle einen anderen Ordner oder Namen.</translation>
    </message>
    <message>
        <source>%1 is not the name of a picture; it ends in .png or .svg.</source>
        <translation>%1 ist kein Name für ein Bild; er endet auf .png oder .svg.</translation>
    </message>
</context>
<context>
    <name>PlacePicker</name>
    <message>
        <source>your place, %1 away</source>
        <translation>dein Ort, %1 daneben</translation>
    </message>
    <message>
        <source>Your cross is at %1, %2</source>
        <translation>Dein Kreuz ist bei %1; %2</translation>
    </message>
    <message>
        <source>%1, %2 away from the true place %3, %4</source>
        <translation>%1, %2 entfernt vom wahren Ort %3; %4</translation>
    </message>
</context>
<context>
    <name>PredictionText</name>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>exactly as you said</source>
        <translation>genau so, wie du es gesagt hast</translation>
    </message>
    <message>
        <source>your number is %1 too high</source>
        <translation>deine Zahl ist um %1 zu hoch</translation>
    </message>
    <message>
        <source>your number is %1 too low</source>
        <translation>deine Zahl ist um %1 zu niedrig</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>curve %1</source>
        <translation>Kurve %1</translation>
    </message>
    <message>
        <source>You said **%1**. It is **%2**: %3&#x202f;px away.</source>
        <translation>Du hast gesagt: **%1**. Es ist **%2**, das ist %3&#x202f;px daneben.</translation>
    </message>
    <message>
        <source>You said **%1**. It is **%2**: %3.</source>
        <translation>Du hast gesagt: **%1**. Es sind **%2**: %3.</translation>
    </message>
    <message>
        <source>You said **%1**, and so it is.</source>
        <translation>Du hast gesagt: **%1**. So ist es.</translation>
    </message>
    <message>
        <source>You said **%1**. It is **%2**.</source>
        <translation>Du hast gesagt: **%1**. Es ist **%2**.</translation>
    </message>
    <message>
        <source>from %1 to %2, at most %3, at least %4</source>
        <translation>von %1 bis %2, höchstens %3, mindestens %4</translation>
    </message>
</context>
<context>
    <name>ProjectJudge</name>
    <message>
        <source>Not yet: the run does not use what you have written. Mend its mistakes first.</source>
        <translation>Noch nicht: Der Lauf benutzt nicht, was du geschrieben hast. Behebe zuerst die Fehler darin.</translation>
    </message>
    <message>
        <source>Not yet: this level needs %1. Switch it on.</source>
        <translation>Noch nicht: Diese Stufe braucht %1. Schalte es ein.</translation>
    </message>
    <message>
        <source>Not yet: your scene has no body %1, which this level is about. Undo, or start again.</source>
        <translation>Noch nicht: In deiner Szene fehlt der Körper %1, um den es in dieser Stufe geht. Mach es rückgängig, oder beginne neu.</translation>
    </message>
    <message>
        <source>Not yet: this level asks you to leave %1 at %2.</source>
        <translation>Noch nicht: In dieser Stufe bleibt %1 auf %2.</translation>
    </message>
    <message>
        <source>Not yet: this level asks you to leave %1 as it was: place, speed, mass and size. Undo, or start again.</source>
        <translation>Noch nicht: In dieser Stufe bleibt %1, wie es war: Ort, Tempo, Masse und Größe. Mach es rückgängig, oder beginne neu.</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 ist %2</translation>
    </message>
    <message>
        <source>Not yet: the run stops in frame %1. %2</source>
        <translation>Noch nicht: Der Lauf endet in Bild %1. %2</translation>
    </message>
    <message>
        <source>Not yet: at the start, this does not hold: %1.</source>
        <translation>Noch nicht: Am Anfang gilt dies nicht: %1.</translation>
    </message>
    <message>
        <source>Not yet: in frame %1, this does not hold: %2.</source>
        <translation>Noch nicht: In Bild %1 gilt dies nicht: %2.</translation>
    </message>
    <message>
        <source>Not yet: up to frame %1, this never happens: %2.</source>
        <translation>Noch nicht: Bis Bild %1 geschieht dies nie: %2.</translation>
    </message>
    <message>
        <source>Not yet: at the end, in frame %1, this does not hold: %2.</source>
        <translation>Noch nicht: Am Ende, in Bild %1, gilt dies nicht: %2.</translation>
    </message>
    <message>
        <source>Not yet: %1</source>
        <translation>Noch nicht: %1</translation>
    </message>
</context>
<context>
    <name>PropertyRangesText</name>
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
        <source>How hard it is to move. Most bodies have 1.</source>
        <translation>Wie schwer er sich bewegen lässt. Die meisten Körper haben 1.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Its width: walls stop its edge, and the wind pushes against it.</source>
        <translation>Seine Breite: Wände halten seinen Rand auf, und der Wind drückt dagegen.</translation>
    </message>
    <message>
        <source>Nailed</source>
        <translation>Genagelt</translation>
    </message>
    <message>
        <source>Whether it is fixed in place.</source>
        <translation>Ob er an seinem Ort befestigt ist.</translation>
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
        <source>How hard it pulls a body of mass 1: this share of the missing distance in each frame.</source>
        <translation>Wie stark sie an einem Körper der Masse 1 zieht: um diesen Anteil des fehlenden Abstands in jedem Bild.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>How far apart its two ends should be.</source>
        <translation>Wie weit auseinander die zwei Enden sein sollen.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>The share of a length error that its first end corrects; the other end corrects the rest.</source>
        <translation>Der Anteil eines Längenfehlers, den das erste Ende korrigiert; das andere Ende korrigiert den Rest.</translation>
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
        <source>The angle of the foot, seen from its body: 0 is left of the body, 90 above it.</source>
        <translation>Der Winkel des Fußes, vom Körper aus gesehen: 0 ist links vom Körper, 90 darüber.</translation>
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
        <source>How fast the clock of this gait group turns its legs. 0: they stand still. To walk, feet need ground.</source>
        <translation>Wie schnell die Uhr dieser Ganggruppe ihre Beine dreht. 0: Sie stehen still. Zum Gehen brauchen Füße Boden.</translation>
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
        <source>The angle at which that clock starts. Groups with different angles step in turn.</source>
        <translation>Der Winkel, bei dem diese Uhr beginnt. Gruppen mit verschiedenen Winkeln treten im Wechsel.</translation>
    </message>
    <message>
        <source>Carries</source>
        <translation>Trägt</translation>
    </message>
    <message>
        <source>Whether the feet push the body back. If they do not, they cannot carry it.</source>
        <translation>Ob die Füße den Körper zurückschieben. Sonst können sie ihn nicht tragen.</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Gruppe</translation>
    </message>
    <message>
        <source>The gait group: its feet share one clock.</source>
        <translation>Die Ganggruppe: Ihre Füße teilen sich eine Uhr.</translation>
    </message>
</context>
<context>
    <name>PullCardText</name>
    <message>
        <source>px/frame²</source>
        <translation>px/Bild²</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Return</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Rücktaste</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Einfg</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
</context>
<context>
    <name>QuantityText</name>
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
        <source>total kinetic energy</source>
        <translation>gesamte kinetische Energie</translation>
    </message>
    <message>
        <source>total potential energy</source>
        <translation>gesamte potenzielle Energie</translation>
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
        <source>How far it moves to the right in a frame</source>
        <translation>Wie weit er sich in einem Bild nach rechts bewegt</translation>
    </message>
    <message>
        <source>How far it moves down in a frame</source>
        <translation>Wie weit er sich in einem Bild nach unten bewegt</translation>
    </message>
    <message>
        <source>How far it moves in a frame, in any direction</source>
        <translation>Wie weit er sich in einem Bild bewegt, egal in welche Richtung</translation>
    </message>
    <message>
        <source>How much its velocity to the right changed in the last frame</source>
        <translation>Um wie viel sich seine Geschwindigkeit nach rechts im letzten Bild änderte</translation>
    </message>
    <message>
        <source>How much its velocity downwards changed in the last frame</source>
        <translation>Um wie viel sich seine Geschwindigkeit nach unten im letzten Bild änderte</translation>
    </message>
    <message>
        <source>How much its velocity changed in the last frame, in any direction</source>
        <translation>Um wie viel sich seine Geschwindigkeit im letzten Bild änderte, egal in welche Richtung</translation>
    </message>
    <message>
        <source>Where it points: 0° is to the right, and 90° is down</source>
        <translation>Wohin er zeigt: 0° ist nach rechts, und 90° ist nach unten</translation>
    </message>
    <message>
        <source>How much its angle changes in a frame</source>
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
        <source>The energy stored in springs and in height</source>
        <translation>Die Energie, die in Federn und in der Höhe steckt</translation>
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
        <source>There is no %1 in this step. Choose another body above. The curve returns in the next step that has %1.</source>
        <translation>In diesem Schritt gibt es „%1“ nicht. Wähle oben einen anderen Körper. Im nächsten Schritt mit „%1“ kommt die Kurve zurück.</translation>
    </message>
    <message>
        <source>%1 is moved from outside, so it has no velocity of its own. Choose its position above instead.</source>
        <translation>%1 wird von außen bewegt und hat darum keine eigene Geschwindigkeit. Wähle oben stattdessen die Position.</translation>
    </message>
    <message>
        <source>This scene has only points, and points have no angle. Choose another quantity above.</source>
        <translation>Diese Szene hat nur Punkte, und Punkte haben keinen Winkel. Wähle oben eine andere Größe.</translation>
    </message>
</context>
<context>
    <name>QuotingText</name>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
</context>
<context>
    <name>ReferenceMarksText</name>
    <message>
        <source>%1 off the reference here</source>
        <translation>%1 neben der Referenz hier</translation>
    </message>
</context>
<context>
    <name>RestText</name>
    <message>
        <source>Everything is at rest: a frame costs nothing until you touch something.</source>
        <translation>Alles ruht: Ein Bild kostet nichts, bis du etwas anfasst.</translation>
    </message>
    <message>
        <source>Nothing can rest now, because “%1” changes over time.</source>
        <translation>Jetzt kann nichts ruhen, denn „%1“ ändert sich mit der Zeit.</translation>
    </message>
    <message>
        <source>With a method that chooses its own steps, bodies at rest cost as much as moving ones.</source>
        <translation>Bei einem Verfahren, das seine Zeitschritte selbst wählt, kosten ruhende Körper so viel wie bewegte.</translation>
    </message>
    <message>
        <source>Bodies at rest cost nothing until you touch them.</source>
        <translation>Ruhende Körper kosten nichts, bis du sie anfasst.</translation>
    </message>
</context>
<context>
    <name>RuleCode</name>
    <message>
        <source>The force on each body.</source>
        <translation>Die Kraft auf jeden Körper.</translation>
    </message>
    <message>
        <source>me.position is in px, y points down.</source>
        <translation>me.position ist in px, y zeigt nach unten.</translation>
    </message>
    <message>
        <source>me.velocity is in px per frame.</source>
        <translation>me.velocity ist in px pro Bild.</translation>
    </message>
    <message>
        <source>The force on me from other.</source>
        <translation>Die Kraft auf me, die von other kommt.</translation>
    </message>
    <message>
        <source>It acts on both ends of each rule link.</source>
        <translation>Sie wirkt auf beide Enden jeder Regelverbindung.</translation>
    </message>
    <message>
        <source>Change rule</source>
        <translation>Regel ändern</translation>
    </message>
    <message>
        <source>Delete rule</source>
        <translation>Regel löschen</translation>
    </message>
    <message>
        <source>your rule</source>
        <translation>deine Regel</translation>
    </message>
    <message>
        <source>no rule</source>
        <translation>keine Regel</translation>
    </message>
</context>
<context>
    <name>RuleErrorText</name>
    <message>
        <source>Line %1 of your rule, for %2: %3</source>
        <translation>Zeile %1 deiner Regel, für %2: %3</translation>
    </message>
    <message>
        <source>Line %1 of your rule, for %2 and %3: %4</source>
        <translation>Zeile %1 deiner Regel, für %2 und %3: %4</translation>
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
    <name>RunPositionText</name>
    <message>
        <source>step %1 of %2</source>
        <translation>Zeitschritt %1 von %2</translation>
    </message>
    <message>
        <source>%1 of %2 phases done</source>
        <translation>%1 von %2 Phasen getan</translation>
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
    <name>RunProgramText</name>
    <message>
        <source>Line %1 of your code: %2</source>
        <translation>Zeile %1 deines Codes: %2</translation>
    </message>
    <message>
        <source>Stopped at frame %1. %2</source>
        <translation>Angehalten bei Bild %1. %2</translation>
    </message>
</context>
<context>
    <name>RunSetupText</name>
    <message>
        <source>%1 cannot be %2. It can be: %3.</source>
        <translation>%1 kann nicht %2 sein. Möglich ist: %3.</translation>
    </message>
    <message>
        <source>%1 cannot be %2. It can be a number from %3 to %4.</source>
        <translation>%1 kann nicht %2 sein. Möglich ist eine Zahl von %3 bis %4.</translation>
    </message>
    <message>
        <source>There is no body %1 here; there are %2.</source>
        <translation>Hier gibt es keinen Körper %1; es gibt %2.</translation>
    </message>
    <message>
        <source>There is no parameter %1 here; there are %2.</source>
        <translation>Hier gibt es keinen Parameter %1; es gibt %2.</translation>
    </message>
    <message>
        <source>There is no method %1; the methods are %2.</source>
        <translation>Es gibt kein Verfahren %1; die Verfahren sind %2.</translation>
    </message>
</context>
<context>
    <name>SandboxPropertiesText</name>
    <message>
        <source>Point %1</source>
        <translation>Punkt %1</translation>
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
        <source>Gait group %1</source>
        <translation>Ganggruppe %1</translation>
    </message>
</context>
<context>
    <name>SandboxText</name>
    <message>
        <source>the order in which points move (%1), because here all move at once</source>
        <translation>die Reihenfolge, in der sich Punkte bewegen (%1), denn hier bewegen sich alle zugleich</translation>
    </message>
    <message>
        <source>This is your own copy of the scene: change what you like.</source>
        <translation>Das ist deine eigene Kopie der Szene: Ändere, was du magst.</translation>
    </message>
    <message>
        <source>This is your own copy of the scene. It could not be copied completely. Missing: %1.</source>
        <translation>Das ist deine eigene Kopie der Szene. Sie ließ sich nicht ganz kopieren. Es fehlt: %1.</translation>
    </message>
    <message>
        <source>This scene has %1 points, but the sandbox allows only %2. Choose a smaller scene.</source>
        <translation>Diese Szene hat %1 Punkte, aber der Sandkasten erlaubt nur %2. Wähle eine kleinere Szene.</translation>
    </message>
    <message>
        <source>The sandbox cannot open this scene, because it has no branches with joints. Take another scene, or look at the examples in the sandbox.</source>
        <translation>Der Sandkasten kann diese Szene nicht öffnen, denn er kennt keine Zweige mit Gelenken. Nimm eine andere Szene, oder sieh dir die Beispiele im Sandkasten an.</translation>
    </message>
    <message>
        <source>This scene has flown apart: a point is more than %1 px away, or moves that far in a frame. Go back in time, and take the scene from there.</source>
        <translation>Diese Szene ist auseinandergeflogen: Ein Punkt ist mehr als %1 px entfernt oder bewegt sich in einem Bild so weit. Geh in der Zeit zurück, und übernimm die Szene von dort.</translation>
    </message>
    <message>
        <source>Take scene to sandbox</source>
        <translation>Szene in den Sandkasten übernehmen</translation>
    </message>
    <message>
        <source>Open example %1</source>
        <translation>Beispiel %1 öffnen</translation>
    </message>
    <message>
        <source>You can only build at the start of the run. Press Home to go there.</source>
        <translation>Bauen kannst du nur am Anfang des Laufs. Drück Pos1, um dorthin zu gehen.</translation>
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
        <source>A new scene has one point, the fewest that a scene can have. Move it, or add parts to it.</source>
        <translation>Eine neue Szene hat einen Punkt, weniger geht nicht. Verschieb ihn oder füg Teile hinzu.</translation>
    </message>
</context>
<context>
    <name>SceneExport</name>
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
        <source>Could not save the picture: %1</source>
        <translation>Das Bild ließ sich nicht speichern: %1</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>Could not write the handout: %1</source>
        <translation>Das Arbeitsblatt konnte nicht geschrieben werden: %1</translation>
    </message>
</context>
<context>
    <name>SceneOverlay</name>
    <message>
        <source>sum so far</source>
        <translation>Summe bisher</translation>
    </message>
    <message>
        <source>sum of all pulls</source>
        <translation>Summe aller Züge</translation>
    </message>
</context>
<context>
    <name>ScreenshotText</name>
    <message>
        <source>--mode is %1; it can be &quot;learn&quot; or &quot;measure&quot;.</source>
        <translation>--mode ist %1; möglich ist &quot;learn&quot; oder &quot;measure&quot;.</translation>
    </message>
    <message>
        <source>--stability is %1; it can be &quot;gauge&quot;, &quot;reasons&quot;, or a map: &quot;step&quot;, &quot;damping&quot; or &quot;rest&quot;.</source>
        <translation>--stability ist %1; möglich ist &quot;gauge&quot;, &quot;reasons&quot; oder eine Karte: &quot;step&quot;, &quot;damping&quot; oder &quot;rest&quot;.</translation>
    </message>
    <message>
        <source>%1 is not a step; name it as LESSON/STEP, as &quot;springstep lessons&quot; lists them.</source>
        <translation>%1 ist kein Schritt; nenne ihn als LESSON/STEP, wie &quot;springstep lessons&quot; sie auflistet.</translation>
    </message>
</context>
<context>
    <name>SentencesText</name>
    <message>
        <source>The step %1 is not allowed. It can be a whole number of frames, or 1 divided by a whole number, from 0.000001 to 100 frames.</source>
        <translation>Der Zeitschritt %1 ist nicht erlaubt. Möglich ist eine ganze Zahl von Bildern oder 1 geteilt durch eine ganze Zahl, von 0.000001 bis 100 Bildern.</translation>
    </message>
    <message>
        <source>The tolerance %1 is not allowed. It can be from 1e-13 to 100 px.</source>
        <translation>Die Toleranz %1 ist nicht erlaubt. Möglich ist 1e-13 bis 100 px.</translation>
    </message>
    <message>
        <source>The method %1 chooses its own steps. Choose a tolerance in px instead of a step.</source>
        <translation>Das Verfahren „%1“ wählt seine Zeitschritte selbst. Wähle eine Toleranz in px statt eines Zeitschritts.</translation>
    </message>
    <message>
        <source>Stopped at frame %1: your code has a mistake that stops the next frame.</source>
        <translation>Bei Bild %1 angehalten: Dein Code hat einen Fehler, der das nächste Bild abbricht.</translation>
    </message>
    <message>
        <source>Your code computes whole frames, so its step cannot be %1. Choose a step of 1 frame.</source>
        <translation>Dein Code berechnet ganze Bilder, darum kann sein Zeitschritt nicht %1 sein. Wähle einen Zeitschritt von 1 Bild.</translation>
    </message>
    <message>
        <source>The method %1 has fixed steps. Choose a step in frames instead of a tolerance.</source>
        <translation>Das Verfahren „%1“ hat feste Zeitschritte. Wähle einen Zeitschritt in Bildern statt einer Toleranz.</translation>
    </message>
    <message>
        <source>%1 acts once per step, so smaller steps give a different motion from the first frame on.</source>
        <translation>„%1“ wirkt einmal pro Zeitschritt, darum ergeben kleinere Zeitschritte vom ersten Bild an eine andere Bewegung.</translation>
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
        <source>The method %1 cannot compute this scene, because parts of it have no velocity of their own. Choose another method.</source>
        <translation>Das Verfahren „%1“ kann diese Szene nicht berechnen, denn Teile von ihr haben keine eigene Geschwindigkeit. Wähle ein anderes Verfahren.</translation>
    </message>
    <message>
        <source>Nothing in this scene can move. Leave at least one body free.</source>
        <translation>In dieser Szene kann sich nichts bewegen. Lass mindestens einen Körper frei.</translation>
    </message>
    <message>
        <source>This scene has %1 points, and at most %2 can be measured with every method. Measure a smaller scene of the same kind: its results are valid for this one, too.</source>
        <translation>Diese Szene hat %1 Punkte, und höchstens %2 lassen sich mit jedem Verfahren messen. Miss eine kleinere Szene dieser Art: Ihre Ergebnisse gelten auch für diese.</translation>
    </message>
    <message>
        <source>This tree would have more than %1 branches: make its slope smaller than %2, or its smallest branch larger than %3.</source>
        <translation>Dieser Baum hätte mehr als %1 Zweige: Mach seine Verjüngung kleiner als %2 oder seinen kleinsten Zweig größer als %3.</translation>
    </message>
    <message>
        <source>Stick %1 ends at p%2, but there is no such point. There are %3 points, and the first is p0.</source>
        <translation>Stab %1 endet bei p%2, aber diesen Punkt gibt es nicht. Es gibt %3 Punkte, und der erste ist p0.</translation>
    </message>
    <message>
        <source>Spring %1 ends at p%2, but there is no such point. There are %3 points, and the first is p0.</source>
        <translation>Feder %1 endet bei p%2, aber diesen Punkt gibt es nicht. Es gibt %3 Punkte, und der erste ist p0.</translation>
    </message>
    <message>
        <source>The event %1 before frame %2 has a value that is infinite or not a number. Give it a finite number.</source>
        <translation>Das Ereignis %1 vor Bild %2 hat einen Wert, der unendlich oder keine Zahl ist. Gib ihm eine endliche Zahl.</translation>
    </message>
    <message>
        <source>The start of %1 has a value that is infinite or not a number. Give it a finite number.</source>
        <translation>Der Start von %1 hat einen Wert, der unendlich oder keine Zahl ist. Gib ihm eine endliche Zahl.</translation>
    </message>
    <message>
        <source>These settings do not fit together: %1.</source>
        <translation>Diese Einstellungen passen nicht zusammen: %1.</translation>
    </message>
    <message>
        <source>The spring of %1</source>
        <translation>Die Feder von %1</translation>
    </message>
    <message>
        <source>The force on %1 (%2)</source>
        <translation>Die Kraft auf %1 (%2)</translation>
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
        <source>Stopped at frame %1: the method needs too many steps for the next frame.</source>
        <translation>Angehalten bei Bild %1: Für das nächste Bild braucht das Verfahren zu viele Zeitschritte.</translation>
    </message>
    <message>
        <source>%1 is strongest.</source>
        <translation>%1 ist am stärksten.</translation>
    </message>
    <message>
        <source>The strongest force acts on %1.</source>
        <translation>Die stärkste Kraft wirkt auf %1.</translation>
    </message>
    <message>
        <source>Try a larger tolerance, or a method with fixed steps.</source>
        <translation>Versuch es mit einer größeren Toleranz oder mit einem Verfahren mit festen Zeitschritten.</translation>
    </message>
    <message>
        <source>Stopped at frame %1: in the next frame, a number is not finite.</source>
        <translation>Angehalten bei Bild %1: Im nächsten Bild ist eine Zahl nicht endlich.</translation>
    </message>
    <message>
        <source>Stopped at frame %1: in the next frame, “%2” is too far away or too fast for a number (not finite).</source>
        <translation>Angehalten bei Bild %1: Im nächsten Bild ist „%2“ zu weit weg oder zu schnell für eine Zahl (nicht endlich).</translation>
    </message>
    <message>
        <source>It began in “%1”.</source>
        <translation>Begonnen hat es in „%1“.</translation>
    </message>
    <message>
        <source>It moves one body after the other, so the pulls between them do not cancel.</source>
        <translation>Es bewegt einen Körper nach dem anderen, darum heben sich die Züge zwischen ihnen nicht auf.</translation>
    </message>
    <message>
        <source>It looks for the moment when a body leaves the walls, but here a body never leaves them.</source>
        <translation>Es sucht den Moment, in dem ein Körper die Wände verlässt, aber hier verlässt er sie nie.</translation>
    </message>
    <message>
        <source>It would need about %1 steps in a frame, but stops after %2.</source>
        <translation>Es bräuchte etwa %1 Zeitschritte in einem Bild, hört aber nach %2 auf.</translation>
    </message>
    <message>
        <source>Without damping, the errors of its steps add up: to %1 px in %2 frames at worst.</source>
        <translation>Ohne Dämpfung summieren sich die Fehler seiner Zeitschritte: schlimmstenfalls auf %1 px in %2 Bildern.</translation>
    </message>
    <message>
        <source>Because its steps may have errors of %1 px, it never comes fully to rest: it moves by up to %2 px a frame.</source>
        <translation>Weil seine Zeitschritte Fehler von %1 px haben dürfen, kommt es nie ganz zur Ruhe: Es bewegt sich um bis zu %2 px pro Bild.</translation>
    </message>
    <message>
        <source>With a step of %1, its stiffest spring (stiffness %2) would swing from %3 px to %4 px, and farther.</source>
        <translation>Mit einem Zeitschritt von %1 würde seine steifste Feder (Steifigkeit %2) von %3 px auf %4 px ausschlagen, und weiter.</translation>
    </message>
    <message>
        <source>Its sticks are only tested with steps up to %1. With a step of %2, their errors are larger.</source>
        <translation>Seine Stäbe werden nur mit Zeitschritten bis %1 geprüft. Mit einem Zeitschritt von %2 sind ihre Fehler größer.</translation>
    </message>
    <message>
        <source>With a step of %1, its stiffest spring (stiffness %2) would not stop swinging: of %3 px, %4 px would be left after %5 frames.</source>
        <translation>Mit einem Zeitschritt von %1 würde seine steifste Feder (Steifigkeit %2) nicht zur Ruhe kommen: Von %3 px wären nach %5 Bildern noch %4 px übrig.</translation>
    </message>
    <message>
        <source>After frame %1, the position of %2 is no longer a finite number: it overflowed in &quot;%3&quot;.</source>
        <translation>Nach Bild %1 ist die Position von %2 keine endliche Zahl mehr: Sie wurde in „%3“ zu groß.</translation>
    </message>
    <message>
        <source>After frame %1, the method needs more steps for one frame than allowed.</source>
        <translation>Nach Bild %1 braucht das Verfahren für ein Bild mehr Zeitschritte als erlaubt.</translation>
    </message>
    <message>
        <source>At frame %1, %2 is more than %3 px away.</source>
        <translation>Bei Bild %1 ist %2 mehr als %3 px entfernt.</translation>
    </message>
    <message>
        <source>At frame %1, the centre of mass has moved %2 px, although nothing pushed it.</source>
        <translation>Bei Bild %1 hat sich der Schwerpunkt um %2 px bewegt, obwohl ihn nichts geschoben hat.</translation>
    </message>
    <message>
        <source>At frame %1, the length of the stick between %2 and %3 is wrong by %4 px, more than the expected %5 px.</source>
        <translation>Bei Bild %1 ist die Länge des Stabs zwischen %2 und %3 um %4 px falsch, mehr als die erwarteten %5 px.</translation>
    </message>
    <message>
        <source>At the end, %1 still moves %2 px a frame.</source>
        <translation>Am Ende bewegt sich %1 immer noch um %2 px pro Bild.</translation>
    </message>
    <message>
        <source>At the end, %1 is %2 px from where it should rest.</source>
        <translation>Am Ende ist %1 um %2 px von dem Ort entfernt, an dem es ruhen sollte.</translation>
    </message>
    <message>
        <source>At the end, the distance between %1 and %2 is wrong by %3 px.</source>
        <translation>Am Ende ist der Abstand von %1 und %2 um %3 px falsch.</translation>
    </message>
    <message>
        <source>A second run differs from the first one at frame %1.</source>
        <translation>Ein zweiter Lauf unterscheidet sich bei Bild %1 vom ersten.</translation>
    </message>
    <message>
        <source>This input should be rejected, but it was accepted.</source>
        <translation>Diese Eingabe sollte abgelehnt werden, wurde aber angenommen.</translation>
    </message>
    <message>
        <source>The run should stop and name the number that is not finite, but it does not.</source>
        <translation>Der Lauf sollte anhalten und die Zahl nennen, die nicht endlich ist, tut es aber nicht.</translation>
    </message>
</context>
<context>
    <name>StabilityText</name>
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
        <source>%1 sets the limit.</source>
        <translation>%1 bestimmt die Grenze.</translation>
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
        <source>&lt;b&gt;Every step is stable, because of the damping.&lt;/b&gt; However long it is, no swing grows here.</source>
        <translation>&lt;b&gt;Durch die Dämpfung ist jeder Zeitschritt stabil.&lt;/b&gt; Wie lang er auch ist, hier schaukelt sich nichts auf.</translation>
    </message>
    <message>
        <source>&lt;b&gt;No step is stable.&lt;/b&gt; This one is so short that the growth is too slow to notice.</source>
        <translation>&lt;b&gt;Kein Zeitschritt ist stabil.&lt;/b&gt; Dieser ist so kurz, dass man das langsame Wachsen nicht bemerkt.</translation>
    </message>
    <message>
        <source>&lt;b&gt;No shorter step is stable.&lt;/b&gt; This one is, because of the damping.</source>
        <translation>&lt;b&gt;Kein kürzerer Zeitschritt ist stabil.&lt;/b&gt; Dieser ist es durch die Dämpfung.</translation>
    </message>
    <message>
        <source>&lt;b&gt;No step is stable.&lt;/b&gt; With this method and so little damping, small disturbances %1. They also grow with any shorter step.</source>
        <translation>&lt;b&gt;Kein Zeitschritt ist stabil.&lt;/b&gt; Kleine Störungen %1 mit diesem Verfahren und so wenig Dämpfung. Auch bei jedem kürzeren Zeitschritt wachsen sie.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1, but still stable.&lt;/b&gt; Steps longer than %2 are unstable, but this one is so long that the damping makes it stable again.</source>
        <translation>&lt;b&gt;%1, aber trotzdem stabil.&lt;/b&gt; Zeitschritte über %2 sind instabil, aber dieser ist so lang, dass ihn die Dämpfung wieder stabil macht.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1.&lt;/b&gt; Small disturbances %2. Steps up to %3 are stable.</source>
        <translation>&lt;b&gt;%1.&lt;/b&gt; Kleine Störungen %2. Zeitschritte bis %3 sind stabil.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1.&lt;/b&gt; Steps up to %2 are stable here.</source>
        <translation>&lt;b&gt;%1.&lt;/b&gt; Zeitschritte bis %2 sind hier stabil.</translation>
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
        <source>unknown here</source>
        <translation>hier unbekannt</translation>
    </message>
    <message>
        <source>too many points</source>
        <translation>zu viele Punkte</translation>
    </message>
    <message>
        <source>stable by damping</source>
        <translation>stabil durch Dämpfung</translation>
    </message>
    <message>
        <source>just stable</source>
        <translation>gerade noch stabil</translation>
    </message>
    <message>
        <source>no stable step</source>
        <translation>kein Zeitschritt stabil</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 has no such limit.&lt;/b&gt; Long steps are stable, however stiff the springs are; they are only less accurate. Choose the step for the accuracy that you want.</source>
        <translation>&lt;b&gt;„%1“ hat keine solche Grenze.&lt;/b&gt; Lange Zeitschritte sind stabil, wie steif die Federn auch sind; sie sind nur weniger genau. Wähle den Zeitschritt nach der Genauigkeit, die du brauchst.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 keeps its own steps short enough.&lt;/b&gt; Its tolerance, %2, limits them.</source>
        <translation>&lt;b&gt;„%1“ hält seine Zeitschritte selbst kurz genug.&lt;/b&gt; Seine Toleranz, %2, begrenzt sie.</translation>
    </message>
    <message>
        <source>&lt;b&gt;No springs act here.&lt;/b&gt; The other effects have no stiffness, so no step is too long for them.</source>
        <translation>&lt;b&gt;Hier wirkt keine Feder.&lt;/b&gt; Die anderen Effekte haben keine Steifigkeit, also ist kein Zeitschritt für sie zu lang.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Unknown here.&lt;/b&gt; The pulls in this state are not finite numbers.</source>
        <translation>&lt;b&gt;Hier unbekannt.&lt;/b&gt; Die Züge in diesem Zustand sind keine endlichen Zahlen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Too many points.&lt;/b&gt; With more than %1 of them, finding the limit would take too long. If the creatures do not touch each other, look at only a few of them: their limit is the same.</source>
        <translation>&lt;b&gt;Zu viele Punkte.&lt;/b&gt; Bei mehr als %1 würde es zu lange dauern, die Grenze zu finden. Wenn die Figuren einander nicht berühren, sieh dir nur wenige davon an: Ihre Grenze ist dieselbe.</translation>
    </message>
    <message>
        <source>Not included: %1. They act in jumps, once per step, and have no stiffness.</source>
        <translation>Nicht berücksichtigt: %1. Sie wirken in Sprüngen, einmal pro Zeitschritt, und haben keine Steifigkeit.</translation>
    </message>
    <message>
        <source>%1 For sticks that carry weight, smaller steps help more than more passes.</source>
        <translation>%1 Bei Stäben, die Gewicht tragen, helfen kleinere Zeitschritte mehr als mehr Durchgänge.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Sticks keep their lengths.&lt;/b&gt; None was wrong by more than %1&#x2009;px in the last %2 frames.</source>
        <translation>&lt;b&gt;Die Stäbe halten ihre Länge.&lt;/b&gt; In den letzten %2 Bildern war keiner um mehr als %1&#x2009;px falsch.</translation>
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
        <source>%1 Neither shorter steps nor more passes halve this error. Perhaps the lengths contradict each other.</source>
        <translation>%1 Weder kürzere Zeitschritte noch mehr Durchgänge halbieren diesen Fehler. Vielleicht widersprechen sich die Längen.</translation>
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
    <message numerus="yes">
        <source>Use %n &amp;passes</source>
        <translation>
            <numerusform>%n Du&amp;rchgang nehmen</numerusform>
            <numerusform>%n Du&amp;rchgänge nehmen</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Use %1</source>
        <translation>%1 &amp;nehmen</translation>
    </message>
    <message>
        <source>sticks are then wrong by up to %1&#x2009;px</source>
        <translation>dann sind Stäbe um bis zu %1&#x2009;px falsch</translation>
    </message>
    <message>
        <source>then at %1</source>
        <translation>dann bei %1</translation>
    </message>
    <message>
        <source>every step is then stable, because of the damping</source>
        <translation>dann ist durch die Dämpfung jeder Zeitschritt stabil</translation>
    </message>
    <message>
        <source>chooses its own steps</source>
        <translation>wählt seine Zeitschritte selbst</translation>
    </message>
    <message>
        <source>has no such limit</source>
        <translation>hat keine solche Grenze</translation>
    </message>
    <message>
        <source>&lt;b&gt;Unknown for your code.&lt;/b&gt; The limit follows from the springs of the scene, and your code may compute anything else.</source>
        <translation>&lt;b&gt;Für deinen Code unbekannt.&lt;/b&gt; Die Grenze folgt aus den Federn der Szene, und dein Code kann etwas ganz anderes berechnen.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Unknown for this rule.&lt;/b&gt; Its force depends on velocities, and the limit is computed from positions only. Try a shorter step: if the motion stays the same, the step is short enough.</source>
        <translation>&lt;b&gt;Für diese Regel unbekannt.&lt;/b&gt; Ihre Kraft hängt von Geschwindigkeiten ab, und die Grenze wird nur aus den Orten berechnet. Probier einen kürzeren Schritt: Bleibt die Bewegung gleich, dann ist der Schritt kurz genug.</translation>
    </message>
</context>
<context>
    <name>StepText</name>
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
</context>
<context>
    <name>TerminalText</name>
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
    <message>
        <source>Frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>Stopped at frame %1 of %2.</source>
        <translation>Angehalten bei Bild %1 von %2.</translation>
    </message>
    <message>
        <source>Stopped before the end.</source>
        <translation>Vor dem Ende angehalten.</translation>
    </message>
</context>
<context>
    <name>TraceText</name>
    <message>
        <source>Setting up the run</source>
        <translation>Bereitet den Lauf vor</translation>
    </message>
    <message>
        <source>The rows could not be written: %1. Free some disk space, or write to another folder.</source>
        <translation>Die Zeilen ließen sich nicht schreiben: %1. Schaffe Platz, oder schreibe in einen anderen Ordner.</translation>
    </message>
</context>
<context>
    <name>UnitCircle</name>
    <message>
        <source>The arrow has no length,</source>
        <translation>Der Pfeil hat keine Länge,</translation>
    </message>
    <message>
        <source>so it has no direction.</source>
        <translation>also hat er keine Richtung.</translation>
    </message>
    <message>
        <source>%1 = %2 / %3 = %4</source>
        <extracomment>cosine = 40 / 50 = 0.8</extracomment>
        <translation>%1 = %2 / %3 = %4</translation>
    </message>
    <message>
        <source>angle = %1° = %2&#x2009;rad</source>
        <translation>Winkel = %1° = %2&#x2009;rad</translation>
    </message>
    <message>
        <source>cosine</source>
        <translation>Kosinus</translation>
    </message>
    <message>
        <source>the side beside the angle</source>
        <translation>die Seite am Winkel</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>Sinus</translation>
    </message>
    <message>
        <source>the side opposite the angle</source>
        <translation>die Seite gegenüber vom Winkel</translation>
    </message>
    <message>
        <source>%1² + %2² = 1</source>
        <extracomment>Pythagoras: 0.8² + 0.6² = 1</extracomment>
        <translation>%1² + %2² = 1</translation>
    </message>
    <message>
        <source>y points down: a sine above 0 is down</source>
        <translation>y zeigt nach unten: Sinus über 0 ist unten</translation>
    </message>
    <message>
        <source>Unit circle</source>
        <translation>Einheitskreis</translation>
    </message>
</context>
<context>
    <name>VerbsText</name>
    <message>
        <source>Prints the result as JSON.</source>
        <translation>Gibt das Ergebnis als JSON aus.</translation>
    </message>
    <message>
        <source>Width and height in pixels, each from 100 to 9999.</source>
        <translation>Breite und Höhe in Pixeln, jeweils von 100 bis 9999.</translation>
    </message>
    <message>
        <source>light, dark or contrast.</source>
        <translation>light, dark oder contrast.</translation>
    </message>
    <message>
        <source>The experiment.</source>
        <translation>Das Experiment.</translation>
    </message>
    <message>
        <source>The experiment or the step of a lesson.</source>
        <translation>Das Experiment oder der Schritt einer Lektion.</translation>
    </message>
    <message>
        <source>Lists lessons, steps, parameters and methods.</source>
        <translation>Listet Lektionen, Schritte, Parameter und Verfahren auf.</translation>
    </message>
    <message>
        <source>Computes the run of an experiment and writes every frame as CSV.</source>
        <translation>Berechnet den Lauf eines Experiments und schreibt jedes Bild als CSV.</translation>
    </message>
    <message>
        <source>Measures the error of each method on a scene, and its cost.</source>
        <translation>Misst den Fehler jedes Verfahrens für eine Szene und seine Kosten.</translation>
    </message>
    <message>
        <source>Also draws error against time, as an SVG file.</source>
        <translation>Zeichnet außerdem den Fehler über der Zeit, als SVG-Datei.</translation>
    </message>
    <message>
        <source>Also names the cheapest method and step with an error of at most E px.</source>
        <translation>Nennt außerdem das billigste Verfahren mit seinem Schritt, dessen Fehler höchstens E px ist.</translation>
    </message>
    <message>
        <source>The number of frames to compute (default: the file&apos;s, at most 1000, or 200 for a step).</source>
        <translation>Die Zahl der Bilder, die berechnet werden (Vorgabe: die der Datei, höchstens 1000, oder 200 für einen Schritt).</translation>
    </message>
    <message>
        <source>Runs every hard case with every method. The exit code is 1 if a method fails a case that it claims.</source>
        <translation>Rechnet jeden schwierigen Fall mit jedem Verfahren. Der Exit-Code ist 1, wenn ein Verfahren an einem Fall scheitert, den es zusagt.</translation>
    </message>
    <message>
        <source>Runs this case only.</source>
        <translation>Rechnet nur diesen Fall.</translation>
    </message>
    <message>
        <source>Runs the cases at full size. Some take hours.</source>
        <translation>Rechnet die Fälle in voller Größe. Manche dauern Stunden.</translation>
    </message>
    <message>
        <source>Measures the time of a frame, and of each effect in it.</source>
        <translation>Misst die Zeit eines Bildes und die jedes Effekts darin.</translation>
    </message>
    <message>
        <source>Measures the frames after frame N.</source>
        <translation>Misst die Bilder nach Bild N.</translation>
    </message>
    <message>
        <source>Draws the window as a learner sees it.</source>
        <translation>Zeichnet das Fenster, wie Lernende es sehen.</translation>
    </message>
    <message>
        <source>The step to open.</source>
        <translation>Der Schritt, der geöffnet wird.</translation>
    </message>
    <message>
        <source>The picture to write.</source>
        <translation>Das Bild, das geschrieben wird.</translation>
    </message>
    <message>
        <source>Goes to frame N.</source>
        <translation>Geht zu Bild N.</translation>
    </message>
    <message>
        <source>Stops after P phases inside the next frame.</source>
        <translation>Hält nach P Phasen im nächsten Bild an.</translation>
    </message>
    <message>
        <source>learn or measure.</source>
        <translation>learn oder measure.</translation>
    </message>
    <message>
        <source>Shows where energy went.</source>
        <translation>Zeigt, wohin die Energie ging.</translation>
    </message>
    <message>
        <source>Shows the cost of each effect.</source>
        <translation>Zeigt die Kosten jedes Effekts.</translation>
    </message>
    <message>
        <source>Shows the plots.</source>
        <translation>Zeigt die Diagramme.</translation>
    </message>
    <message>
        <source>gauge, reasons, or a map: step, damping or rest.</source>
        <translation>gauge, reasons oder eine Karte: step, damping oder rest.</translation>
    </message>
    <message>
        <source>Makes a film of the run of an experiment: a WebM video, an animated GIF, a PNG for each frame, or a web page that plays it.</source>
        <translation>Macht aus dem Lauf eines Experiments einen Film: ein WebM-Video, ein animiertes GIF, ein PNG für jedes Bild oder eine Webseite, die ihn abspielt.</translation>
    </message>
    <message>
        <source>The film: OUT.webm, OUT.gif, OUT.html, or OUT_%04d.png, where %04d stands for the number of the frame with 4 digits, such as 0007. %d writes 7, and the files do not sort by name.</source>
        <translation>Der Film: OUT.webm, OUT.gif, OUT.html oder OUT_%04d.png, wobei %04d für die Nummer des Bildes mit 4 Ziffern steht, etwa 0007. %d schreibt 7; dann ordnet der Name die Dateien nicht.</translation>
    </message>
    <message>
        <source>The first frame.</source>
        <translation>Das erste Bild.</translation>
    </message>
    <message>
        <source>The last frame (default: the file&apos;s number of frames).</source>
        <translation>Das letzte Bild (Vorgabe: die Bilderzahl der Datei).</translation>
    </message>
    <message>
        <source>Frames per second, up to 50 in a GIF and 120 otherwise (default 30). Not for PNG files.</source>
        <translation>Bilder pro Sekunde, bis 50 in einem GIF und sonst bis 120 (Vorgabe 30). Nicht für PNG-Dateien.</translation>
    </message>
    <message>
        <source>Checks notebooks by replaying every run, makes a page of one, or writes your own. The exit code is 1 if a run does not show what its notebook says.</source>
        <translation>Prüft Hefte, indem es jeden Lauf nachspielt, macht aus einem eine Seite oder schreibt dein eigenes. Der Rückgabewert ist 1, wenn ein Lauf nicht zeigt, was sein Heft sagt.</translation>
    </message>
    <message>
        <source>check FILE..., page FILE OUT.html, page FILE OUT.pdf, or write OUT.springstep-notebook.</source>
        <translation>check FILE..., page FILE OUT.html, page FILE OUT.pdf oder write OUT.springstep-notebook.</translation>
    </message>
    <message>
        <source>Prints the result as CSV.</source>
        <translation>Gibt das Ergebnis als CSV aus.</translation>
    </message>
    <message>
        <source>The name to write into the notebook.</source>
        <translation>Der Name, der ins Heft kommt.</translation>
    </message>
    <message>
        <source>The lessons to write (default: all).</source>
        <translation>Die Lektionen, die hineinkommen (Vorgabe: alle).</translation>
    </message>
    <message>
        <source>Checks a lesson of your own, and plays the solution of each thing to try. The exit code is 1 if one fails.</source>
        <translation>Prüft eine eigene Lektion und spielt die Lösung jedes Versuchs. Der Rückgabewert ist 1, wenn eine nicht gelingt.</translation>
    </message>
    <message>
        <source>The folder of the lesson, or its zip.</source>
        <translation>Der Ordner der Lektion, oder ihr Zip.</translation>
    </message>
    <message>
        <source>Writes a lesson on paper: its texts, pictures and questions with lines to write on. The answers follow on separate pages.</source>
        <translation>Schreibt eine Lektion auf Papier: ihre Texte, Bilder und Fragen mit Zeilen zum Schreiben. Die Antworten folgen auf eigenen Seiten.</translation>
    </message>
    <message>
        <source>A lesson, or the folder or the zip of one.</source>
        <translation>Eine Lektion oder ihr Ordner oder ihr Zip.</translation>
    </message>
    <message>
        <source>The PDF to write.</source>
        <translation>Das PDF, das geschrieben wird.</translation>
    </message>
    <message>
        <source>en, de, es or fr (default: that of the system).</source>
        <translation>en, de, es oder fr (Vorgabe: die des Systems).</translation>
    </message>
    <message>
        <source>A plot on a web page, such as &quot;y(body)&quot;, &quot;energy&quot; or &quot;y(body):x(body)&quot;. Repeat it for more.</source>
        <translation>Ein Diagramm auf einer Webseite, wie &quot;y(body)&quot;, &quot;energy&quot; oder &quot;y(body):x(body)&quot;. Für mehr wiederholen.</translation>
    </message>
    <message>
        <source>The run in FILE that a web page shows as the ghost.</source>
        <translation>Der Lauf in FILE, den eine Webseite als Geist zeigt.</translation>
    </message>
    <message>
        <source>The notebooks, or the notebook and the page to write; and the lessons without C++ that they are about, as folders or zips.</source>
        <translation>Die Hefte, oder das Heft und die Seite, die geschrieben wird; und die Lektionen ohne C++, von denen sie handeln, als Ordner oder Zip.</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>L&amp;earn</source>
        <translation>Le&amp;rnen</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>&amp;Build</source>
        <translation>&amp;Bauen</translation>
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
        <source>Ne&amp;xt body outside</source>
        <translation>Nächster Körper a&amp;ußerhalb</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>&amp;Lektionen</translation>
    </message>
    <message>
        <source>Lessons &amp;as a narrow strip</source>
        <translation>Lektionen nur als &amp;Zeichen</translation>
    </message>
    <message>
        <source>&amp;Code and parameters</source>
        <translation>&amp;Code und Parameter</translation>
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
        <source>&amp;Plots</source>
        <translation>D&amp;iagramme</translation>
    </message>
    <message>
        <source>&amp;Stability of the step</source>
        <translation>&amp;Stabilität des Zeitschritts</translation>
    </message>
    <message>
        <source>Map of the time to rest</source>
        <translation>Karte der Zeit bis zur Ruhe</translation>
    </message>
    <message>
        <source>How many frames the run takes to come to rest, for each stiffness and damping</source>
        <translation>Nach wie vielen Bildern der Lauf in Ruhe ist, für jede Steifigkeit und jede Dämpfung</translation>
    </message>
    <message>
        <source>&amp;Unlock: panels can be moved</source>
        <translation>&amp;Entsperren: Leisten lassen sich verschieben</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>&amp;Hoher Kontrast</translation>
    </message>
    <message>
        <source>Less mo&amp;vement</source>
        <translation>&amp;Weniger Bewegung</translation>
    </message>
    <message>
        <source>Scene onl&amp;y</source>
        <translation>&amp;Nur die Szene</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>V&amp;ollbild</translation>
    </message>
    <message>
        <source>Lessons, scene and code</source>
        <translation>Lektionen, Szene und Code</translation>
    </message>
    <message>
        <source>The error and the cost of each method for this scene</source>
        <translation>Fehler und Kosten jedes Verfahrens für diese Szene</translation>
    </message>
    <message>
        <source>Build your own scene from points, springs, sticks and feet</source>
        <translation>Eine eigene Szene aus Punkten, Federn, Stäben und Füßen bauen</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Show the whole scene with all bodies, and keep them in view</source>
        <translation>Die ganze Szene mit allen Körpern zeigen und sie im Bild behalten</translation>
    </message>
    <message>
        <source>Bring a body that is outside the picture into view</source>
        <translation>Einen Körper, der außerhalb des Bildes ist, ins Bild holen</translation>
    </message>
    <message>
        <source>Show only the symbols of the lessons, to save space</source>
        <translation>Nur die Zeichen der Lektionen zeigen, um Platz zu sparen</translation>
    </message>
    <message>
        <source>Where energy and momentum went</source>
        <translation>Wohin Energie und Impuls gingen</translation>
    </message>
    <message>
        <source>The cost of each effect in the scene, with a switch for each</source>
        <translation>Die Kosten jedes Effekts in der Szene, mit einem Schalter für jeden</translation>
    </message>
    <message>
        <source>Curves of any quantity of any body</source>
        <translation>Kurven jeder Größe jedes Körpers</translation>
    </message>
    <message>
        <source>Drag a panel by its title to another place</source>
        <translation>Ein Bedienfeld an seinem Titel an einen anderen Platz ziehen</translation>
    </message>
    <message>
        <source>Moves the panels back to their original places, in this mode only</source>
        <translation>Stellt die Leisten an ihre ursprünglichen Plätze zurück, nur in dieser Anordnung</translation>
    </message>
    <message>
        <source>Panels and menus open without animation, and wind is drawn as a still picture. Only the simulation moves</source>
        <translation>Leisten und Menüs öffnen sich ohne Animation, und Wind wird als Standbild gezeichnet. Nur die Simulation bewegt sich</translation>
    </message>
    <message>
        <source>Show only the scene and its timeline. Press again to bring the panels back</source>
        <translation>Nur die Szene und ihre Zeitleiste zeigen. Noch einmal drücken holt die Leisten zurück</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Zurücksetzen</translation>
    </message>
    <message>
        <source>Unit circle</source>
        <translation>Einheitskreis</translation>
    </message>
    <message>
        <source>Show the angle of an arrow, its cosine and its sine on a circle</source>
        <translation>Zeigt den Winkel eines Pfeils, seinen Kosinus und seinen Sinus an einem Kreis</translation>
    </message>
</context>
<context>
    <name>WebPageCliText</name>
    <message>
        <source>--%1 is for films; a web page has the size and the colours of its reader&apos;s browser. Leave it out.</source>
        <translation>--%1 ist für Filme; eine Webseite hat die Größe und die Farben des Browsers, der sie zeigt. Lass es weg.</translation>
    </message>
    <message>
        <source>--plot is %1; it can be %2, with its bodies, as in %3 and %4.</source>
        <translation>--plot ist %1; möglich ist %2, mit den Körpern dazu, wie in %3 und %4.</translation>
    </message>
    <message>
        <source>--plot is %1, but there is no %2; there is %3.</source>
        <translation>--plot ist %1, aber es gibt kein %2; es gibt %3.</translation>
    </message>
    <message>
        <source>--plot is %1, which has no value in this scene. Choose another one.</source>
        <translation>--plot ist %1, was in dieser Szene keinen Wert hat. Wähle etwas anderes.</translation>
    </message>
    <message>
        <source>--plot is given %1 times; a web page has room for %2 plots.</source>
        <translation>--plot ist %1-mal angegeben; eine Webseite hat Platz für %2 Diagramme.</translation>
    </message>
    <message>
        <source>--ghost is %1, but FILE has no other run. Keep one in the window.</source>
        <translation>--ghost ist %1, aber FILE hat keinen anderen Lauf. Behalte einen im Fenster.</translation>
    </message>
    <message>
        <source>--ghost is %1; it can be %2.</source>
        <translation>--ghost ist %1; möglich ist %2.</translation>
    </message>
</context>
<context>
    <name>WebPageText</name>
    <message>
        <source>A web page has room for %1 frames of this scene, and this would be %2. Choose fewer frames.</source>
        <translation>Eine Webseite hat Platz für %1 Bilder dieser Szene, und das wären %2. Wähle weniger Bilder.</translation>
    </message>
    <message>
        <source>The last frame, %1, comes before the first, %2. Swap them.</source>
        <translation>Das letzte Bild, %1, kommt vor dem ersten, %2. Vertausche sie.</translation>
    </message>
    <message>
        <source>The bodies of %1 frames do not fit on a web page. Choose fewer frames.</source>
        <translation>Die Körper von %1 Bildern passen nicht auf eine Webseite. Wähle weniger Bilder.</translation>
    </message>
    <message>
        <source>The run does not reach frame %1: it stops at frame %2. Begin the page earlier.</source>
        <translation>Der Lauf kommt nicht bis Bild %1: Er endet bei Bild %2. Beginne die Seite früher.</translation>
    </message>
</context>
<context>
    <name>WebPageWords</name>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Ein Bild zurück</translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation>Ein Bild vor</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Vergrößern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>Fit the scene</source>
        <translation>Szene einpassen</translation>
    </message>
    <message>
        <source>Trails</source>
        <translation>Spuren</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>Helle Farben</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Dunkle Farben</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>%1 at (%2, %3)</source>
        <translation>%1 bei (%2, %3)</translation>
    </message>
    <message>
        <source>About this step</source>
        <translation>Über diesen Schritt</translation>
    </message>
    <message>
        <source>Listing</source>
        <translation>Listing</translation>
    </message>
    <message>
        <source>Beside each line: the values that this frame has set</source>
        <translation>Neben jeder Zeile: die Werte, die dieses Bild gesetzt hat</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>time, frames</source>
        <translation>Zeit, Bilder</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>kein Wert</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>Links, Rechts</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Pos1, Ende</translation>
    </message>
    <message>
        <source>Shift with arrows, or drag</source>
        <translation>Umschalt mit Pfeiltasten, oder ziehen</translation>
    </message>
    <message>
        <source>Mouse wheel</source>
        <translation>Mausrad</translation>
    </message>
    <message>
        <source>play or pause</source>
        <translation>abspielen oder anhalten</translation>
    </message>
    <message>
        <source>one frame back or forward; with Ctrl, ten</source>
        <translation>ein Bild zurück oder vor; mit Strg zehn</translation>
    </message>
    <message>
        <source>first or last frame</source>
        <translation>erstes oder letztes Bild</translation>
    </message>
    <message>
        <source>move the view</source>
        <translation>die Ansicht verschieben</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>vergrößern oder verkleinern</translation>
    </message>
    <message>
        <source>light or dark colours</source>
        <translation>helle oder dunkle Farben</translation>
    </message>
    <message>
        <source>Made with Springstep</source>
        <translation>Mit Springstep gemacht</translation>
    </message>
    <message>
        <source>The run needs JavaScript. Allow it in this browser, and load the page again.</source>
        <translation>Der Lauf braucht JavaScript. Erlaube es in diesem Browser, und lade die Seite neu.</translation>
    </message>
    <message>
        <source>This browser is too old to show the run. Use one from 2023 or later.</source>
        <translation>Dieser Browser ist zu alt für den Lauf. Nimm einen von 2023 oder später.</translation>
    </message>
    <message>
        <source>The run on this page cannot be read: the file is damaged. Ask for it again.</source>
        <translation>Der Lauf auf dieser Seite ist nicht lesbar: Die Datei ist beschädigt. Lass sie dir noch einmal geben.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Choose what the scene shows</source>
        <translation>Auswählen, was die Szene zeigt</translation>
    </message>
    <message>
        <source>Velocity arrows</source>
        <translation>Geschwindigkeitspfeile</translation>
    </message>
    <message>
        <source>Onion skins</source>
        <translation>Zwiebelschalen</translation>
    </message>
    <message>
        <source>Ghost</source>
        <translation>Geist</translation>
    </message>
    <message>
        <source>Guide lines</source>
        <translation>Hilfslinien</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Legende</translation>
    </message>
</context>
<context>
    <name>WholeFileText</name>
    <message>
        <source>%1: the file could not be written: %2. Choose another folder or name.</source>
        <translation>%1: Die Datei konnte nicht geschrieben werden: %2. Wähle einen anderen Ordner oder Namen.</translation>
    </message>
    <message>
        <source>%1: there is no such file; check its name and folder.</source>
        <translation>%1: Diese Datei gibt es nicht; prüfe Namen und Ordner.</translation>
    </message>
    <message>
        <source>%1: the file could not be read: %2.</source>
        <translation>%1: Die Datei ließ sich nicht lesen: %2.</translation>
    </message>
    <message>
        <source>%1: this is a folder; give a file.</source>
        <translation>%1: Das ist ein Ordner; gib eine Datei an.</translation>
    </message>
    <message>
        <source>%1: the file is larger than %2 MiB, the maximum.</source>
        <translation>%1: Die Datei ist größer als %2 MiB, das Höchstmaß.</translation>
    </message>
</context>
<context>
    <name>ZipText</name>
    <message>
        <source>the zip is damaged. Get it again, or make a new zip of the folder.</source>
        <translation>Das Zip ist beschädigt. Hol es noch einmal, oder mach ein neues Zip des Ordners.</translation>
    </message>
    <message>
        <source>this is not a zip, or its end is missing. Choose the lesson.json or the zip of a lesson, or get the zip again.</source>
        <translation>Das ist kein Zip, oder sein Ende fehlt. Wähle lesson.json oder das Zip einer Lektion, oder hol das Zip noch einmal.</translation>
    </message>
    <message>
        <source>%1 is in a folder. All files of a lesson are side by side.</source>
        <translation>%1 liegt in einem Ordner. Alle Dateien einer Lektion liegen nebeneinander.</translation>
    </message>
    <message>
        <source>%1 is there twice. Make a new zip of the folder.</source>
        <translation>%1 ist doppelt da. Mach ein neues Zip des Ordners.</translation>
    </message>
    <message>
        <source>the zip has several parts, or is too large for a lesson.</source>
        <translation>Das Zip hat mehrere Teile oder ist zu groß für eine Lektion.</translation>
    </message>
    <message>
        <source>the zip has more than %1 files.</source>
        <translation>Das Zip hat mehr als %1 Dateien.</translation>
    </message>
    <message>
        <source>the files are larger than %1 MiB together.</source>
        <translation>Die Dateien sind zusammen größer als %1 MiB.</translation>
    </message>
    <message>
        <source>the name of a file is not UTF-8. Give it a name without accents.</source>
        <translation>Der Name einer Datei ist kein UTF-8. Gib ihr einen Namen ohne Akzente und Umlaute.</translation>
    </message>
    <message>
        <source>%1 leads out of the lesson. This zip is not safe; nothing was read.</source>
        <translation>%1 führt aus der Lektion hinaus. Dieses Zip ist nicht sicher; nichts wurde gelesen.</translation>
    </message>
    <message>
        <source>%1 is a link. Put the file itself into the zip.</source>
        <translation>%1 ist eine Verknüpfung. Leg die Datei selbst in das Zip.</translation>
    </message>
    <message>
        <source>%1 has a password. Make a zip without one.</source>
        <translation>%1 hat ein Passwort. Mach ein Zip ohne Passwort.</translation>
    </message>
    <message>
        <source>%1 is compressed by a method that this program cannot read. Save it as an ordinary zip file.</source>
        <translation>%1 ist auf eine Art gepackt, die dieses Programm nicht lesen kann. Mach ein gewöhnliches Zip.</translation>
    </message>
    <message>
        <source>%1 is larger than %2 MiB.</source>
        <translation>%1 ist größer als %2 MiB.</translation>
    </message>
    <message>
        <source>the zip is empty.</source>
        <translation>Das Zip ist leer.</translation>
    </message>
    <message>
        <source>%1 is larger than the zip says. This zip is not safe; nothing was read.</source>
        <translation>%1 ist größer, als das Zip sagt. Dieses Zip ist nicht sicher; nichts wurde gelesen.</translation>
    </message>
    <message>
        <source>%1 is packed as ZIP64, which is for very large files. Save it as an ordinary zip file.</source>
        <translation>%1 ist als ZIP64 gepackt, das für sehr große Dateien ist. Mach ein gewöhnliches Zip.</translation>
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
        <source>running your code</source>
        <translation>Ausführen deines Codes</translation>
    </message>
    <message>
        <source>films as video</source>
        <translation>Filme als Video</translation>
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
        <source>The error of each method, and its cost</source>
        <translation>Der Fehler jedes Verfahrens und seine Kosten</translation>
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
        <source>Progress of the measurement</source>
        <translation>Fortschritt der Messung</translation>
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
        <source>Cancel; the results so far stay</source>
        <translation>Abbrechen; die Ergebnisse bis jetzt bleiben</translation>
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
        <source>Cancelled. The results so far are shown.</source>
        <translation>Abgebrochen. Die Ergebnisse bis dahin sind zu sehen.</translation>
    </message>
    <message>
        <source>The scene has changed. Measuring starts when you stop changing it.</source>
        <translation>Die Szene hat sich geändert. Gemessen wird, sobald du sie nicht mehr änderst.</translation>
    </message>
    <message>
        <source>Not measured yet.</source>
        <translation>Noch nicht gemessen.</translation>
    </message>
    <message>
        <source>How accurate is each method for this scene, and what does it cost? Every method computes it with many steps, and is compared with a far more accurate reference.</source>
        <translation>Wie genau ist jedes Verfahren für diese Szene, und was kostet es? Jedes Verfahren berechnet sie mit vielen Zeitschritten und wird mit einer weit genaueren Referenz verglichen.</translation>
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
        <source>Only the method of this step, and the two most useful to compare it with</source>
        <translation>Nur das Verfahren dieses Schritts und die zwei, mit denen sich der Vergleich am meisten lohnt</translation>
    </message>
    <message>
        <source>All measured methods, with two more plots and with remarks</source>
        <translation>Alle gemessenen Verfahren, mit zwei weiteren Diagrammen und Anmerkungen</translation>
    </message>
</context>
<context>
    <name>app::AccuracyStudy</name>
    <message>
        <source>Your code is left out: it computes whole frames, so it cannot be compared with shorter steps.</source>
        <translation>Dein Code fehlt hier: Er berechnet ganze Bilder, lässt sich also nicht mit kürzeren Zeitschritten vergleichen.</translation>
    </message>
</context>
<context>
    <name>app::Appearance</name>
    <message>
        <source>This step shows no angle.</source>
        <translation>Dieser Schritt zeigt keinen Winkel.</translation>
    </message>
</context>
<context>
    <name>app::ArrangeMenu</name>
    <message>
        <source>A&amp;rrange panels</source>
        <translation>Leisten &amp;verschieben</translation>
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
    <message>
        <source>Drag this panel to its new place</source>
        <translation>Zieh diese Leiste an ihren neuen Platz</translation>
    </message>
</context>
<context>
    <name>app::Attempts</name>
    <message>
        <source>stop here: press **Space**.</source>
        <translation>halte hier an: Drück die **Leertaste**.</translation>
    </message>
    <message>
        <source>the error is too large, or a frame takes too long. Try another method or step.</source>
        <translation>der Fehler ist zu groß, oder ein Bild dauert zu lang. Versuche ein anderes Verfahren oder einen anderen Zeitschritt.</translation>
    </message>
    <message>
        <source>this run was set up for you. Undo brings your own run back: do it there.</source>
        <translation>diesen Lauf hat Springstep eingestellt. Rückgängig bringt deinen eigenen zurück: Mach es dort.</translation>
    </message>
    <message>
        <source>your code computes this run, and it has no phases. Press **Reset listing** on the page **Listing**. Undo brings your code back.</source>
        <translation>diesen Lauf berechnet dein Code, und der hat keine Phasen. Drück auf der Seite **Listing** auf **Listing zurücksetzen**. Rückgängig bringt deinen Code zurück.</translation>
    </message>
    <message>
        <source>your code computes this run, in steps of 1 frame. Press **Reset listing** on the page **Listing**, then choose the step. Undo brings your code back.</source>
        <translation>diesen Lauf berechnet dein Code, mit Zeitschritten von 1 Bild. Drück auf der Seite **Listing** auf **Listing zurücksetzen** und wähle dann den Zeitschritt. Rückgängig bringt deinen Code zurück.</translation>
    </message>
</context>
<context>
    <name>app::Autosave</name>
    <message>
        <source>the folder %1 could not be created</source>
        <translation>der Ordner %1 ließ sich nicht anlegen</translation>
    </message>
    <message>
        <source>a file in %1 could not be locked</source>
        <translation>eine Datei in %1 ließ sich nicht sperren</translation>
    </message>
    <message>
        <source>Could not save a backup of your work: %1. Free some disk space, or save it as a file.</source>
        <translation>Deine Arbeit ließ sich nicht automatisch sichern: %1. Schaffe dort Platz, oder speichere sie als Datei.</translation>
    </message>
</context>
<context>
    <name>app::BranchesPanel</name>
    <message>
        <source>Two runs</source>
        <translation>Zwei Läufe</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Größter Abstand</translation>
    </message>
    <message>
        <source>In each frame, the body that is farthest from its place in the other run</source>
        <translation>In jedem Bild der Körper, der am weitesten von seinem Ort im anderen Lauf entfernt ist</translation>
    </message>
    <message>
        <source>Only the body that is selected in the picture</source>
        <translation>Nur der Körper, der in der Szene ausgewählt ist</translation>
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
    <name>app::BreakpointList</name>
    <message>
        <source>when</source>
        <translation>wenn</translation>
    </message>
    <message>
        <source>Stop when</source>
        <translation>Anhalten, wenn</translation>
    </message>
    <message>
        <source>Stops the run as soon as this is true, even inside a frame.
You can use x, y, vx, vy of bodies, frame, phase, and all parameters;
+ - * / ( ), &lt; &lt;= &gt; &gt;= == !=, and, or, not, abs(), sqrt(), distance(a, b), speed(a), still(a), held(a), released(a).
Press Enter to add it.</source>
        <translation>Hält den Lauf an, sobald das wahr ist, auch innerhalb eines Bildes.
Du kannst x, y, vx, vy von Körpern, frame, phase und alle Parameter verwenden;
+ - * / ( ), &lt; &lt;= &gt; &gt;= == !=, and, or, not, abs(), sqrt(), distance(a, b), speed(a), still(a), held(a), released(a).
Drück Eingabe, um es hinzuzufügen.</translation>
    </message>
    <message>
        <source>always, or when…</source>
        <translation>immer, oder wenn …</translation>
    </message>
    <message>
        <source>Condition of breakpoint %1</source>
        <translation>Bedingung des Haltepunkts %1</translation>
    </message>
    <message>
        <source>Stops before this line&apos;s phase if this is true. Press Enter to apply.</source>
        <translation>Hält vor der Phase dieser Zeile an, wenn das wahr ist. Drück Eingabe zum Übernehmen.</translation>
    </message>
    <message>
        <source>Stops when this becomes true. Press Enter to apply.</source>
        <translation>Hält an, wenn das wahr wird. Drück Eingabe zum Übernehmen.</translation>
    </message>
    <message>
        <source>Stop before this line (%1)</source>
        <translation>Vor dieser Zeile anhalten (%1)</translation>
    </message>
    <message>
        <source>Stop when this becomes true</source>
        <translation>Anhalten, wenn das wahr wird</translation>
    </message>
    <message>
        <source>Breakpoint %1 %2</source>
        <translation>Haltepunkt %1 %2</translation>
    </message>
    <message>
        <source>Remove this breakpoint</source>
        <translation>Diesen Haltepunkt entfernen</translation>
    </message>
    <message>
        <source>Remove the breakpoint %1 %2</source>
        <translation>Den Haltepunkt %1 %2 entfernen</translation>
    </message>
    <message>
        <source>Stop when… (%1.y &gt; 300)</source>
        <translation>Anhalten, wenn … (%1.y &gt; 300)</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>Stop before this line of the listing</source>
        <translation>Vor dieser Zeile des Listings anhalten</translation>
    </message>
    <message>
        <source>Stops before this line if this is true. Press Enter to apply.</source>
        <translation>Hält vor dieser Zeile an, wenn das wahr ist. Drück Eingabe zum Übernehmen.</translation>
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
        <source>Now set the numbers of the feet. Press Select (V).</source>
        <translation>Nun zu den Zahlen der Füße. Drück Auswahl (V).</translation>
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
        <source>Go to frame 0, where the scene can be changed</source>
        <translation>Zu Bild 0 gehen, wo sich die Szene ändern lässt</translation>
    </message>
    <message>
        <source>Effects on everything</source>
        <translation>Wirkt auf alles</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>Scenes to start from. Undo brings yours back</source>
        <translation>Szenen als Anfang. Rückgängig bringt deine zurück</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>A scene with one point. Undo brings yours back</source>
        <translation>Eine Szene mit einem Punkt. Rückgängig bringt deine zurück</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Back to the lessons; your scene stays here</source>
        <translation>Zurück zu den Lektionen; deine Szene bleibt hier</translation>
    </message>
    <message>
        <source>points %1, links %2</source>
        <translation>Punkte %1, Verbindungen %2</translation>
    </message>
    <message>
        <source>The scene is playing. You can only build at the start of the run.</source>
        <translation>Die Szene läuft. Bauen kannst du nur am Anfang des Laufs.</translation>
    </message>
    <message>
        <source>You are at frame %1. You can only build at the start of the run.</source>
        <translation>Du bist bei Bild %1. Bauen kannst du nur am Anfang des Laufs.</translation>
    </message>
    <message>
        <source>Click where you want a point.</source>
        <translation>Klicke dorthin, wo du einen Punkt haben willst.</translation>
    </message>
    <message>
        <source>Click a point to nail it down or to free it, or click where you want a nail.</source>
        <translation>Klicke auf einen Punkt, um ihn festzunageln oder zu lösen, oder dorthin, wo du einen Nagel haben willst.</translation>
    </message>
    <message>
        <source>Click a part to select it, drag it to move it, or draw a box around several.</source>
        <translation>Klicke auf ein Teil, um es auszuwählen, zieh es, um es zu verschieben, oder zieh einen Rahmen um mehrere.</translation>
    </message>
    <message>
        <source>New gait group</source>
        <translation>Neue Ganggruppe</translation>
    </message>
    <message>
        <source>Gives this foot its own gait group, with its own clock</source>
        <translation>Gibt diesem Fuß eine eigene Ganggruppe mit eigener Uhr</translation>
    </message>
    <message>
        <source>Click where it ends; the next one starts there. Esc: start somewhere else.</source>
        <translation>Klicke, wo das andere Ende hinkommt; von dort geht es weiter. Esc: woanders beginnen.</translation>
    </message>
    <message>
        <source>Click each of its feet, or where you want one. Esc: another body.</source>
        <translation>Klicke auf jeden seiner Füße oder dorthin, wo du einen haben willst. Esc: ein anderer Körper.</translation>
    </message>
    <message>
        <source>Click a body, then each of its feet, or where you want one.</source>
        <translation>Klicke auf einen Körper, dann auf jeden seiner Füße oder dorthin, wo du einen haben willst.</translation>
    </message>
    <message>
        <source>First build: a walker</source>
        <translation>Erstes Bauen: ein Läufer</translation>
    </message>
    <message>
        <source>Build a creature that walks, in ten clicks. It starts with a new scene. Undo brings yours back</source>
        <translation>Bau mit zehn Klicks ein Wesen, das geht. Es beginnt mit einer neuen Szene. Rückgängig bringt deine zurück</translation>
    </message>
    <message>
        <source>Drag from point to point to make one spring. With clicks, each spring starts where the last one ends.</source>
        <translation>Zieh von Punkt zu Punkt: Das macht eine Feder. Mit Klicks beginnt jede Feder dort, wo die letzte endet.</translation>
    </message>
    <message>
        <source>Drag from point to point to make one stick. With clicks, each stick starts where the last one ends.</source>
        <translation>Zieh von Punkt zu Punkt: Das macht einen Stab. Mit Klicks beginnt jeder Stab dort, wo der letzte endet.</translation>
    </message>
    <message>
        <source>On the ground, Swing makes it walk. Opposite feet need opposite angles: 0° and 180°.</source>
        <translation>Auf dem Boden bringt Schwung die Figur zum Gehen. Gegenüberliegende Füße brauchen gegenüberliegende Winkel: 0° und 180°.</translation>
    </message>
    <message>
        <source>Drag from point to point to make one rule link, along which pull of your rule acts. With clicks, each link starts where the last one ends.</source>
        <translation>Ziehe von Punkt zu Punkt für eine Regelverbindung, entlang der pull deiner Regel wirkt. Mit Klicks beginnt jede dort, wo die letzte endet.</translation>
    </message>
    <message>
        <source>A rule link has no settings: pull of your rule acts on both of its ends.</source>
        <translation>Eine Regelverbindung hat keine Einstellungen: pull deiner Regel wirkt auf ihre beiden Enden.</translation>
    </message>
</context>
<context>
    <name>app::ChoiceRow</name>
    <message>
        <source>Choose this answer (Space)</source>
        <translation>Diese Antwort wählen (Leertaste)</translation>
    </message>
    <message>
        <source>%1, right</source>
        <translation>%1, richtig</translation>
    </message>
    <message>
        <source>%1, wrong</source>
        <translation>%1, falsch</translation>
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
        <source>x solid, y dashed</source>
        <translation>x durchgezogen, y gestrichelt</translation>
    </message>
</context>
<context>
    <name>app::CodePages</name>
    <message>
        <source>Let the listing compute the run from here</source>
        <translation>Den Lauf ab hier vom Listing berechnen lassen</translation>
    </message>
    <message>
        <source>Listing</source>
        <translation>Listing</translation>
    </message>
    <message>
        <source>The program of a frame, to read, to step through and to change</source>
        <translation>Das Programm eines Bildes: zum Lesen, zum Durchgehen und zum Ändern</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Engine</translation>
    </message>
    <message>
        <source>The code of Springstep that computes the run</source>
        <translation>Der Code von Springstep, der den Lauf berechnet</translation>
    </message>
    <message>
        <source>%1 computes this run, not the listing.</source>
        <translation>Diesen Lauf berechnet %1, nicht das Listing.</translation>
    </message>
    <message>
        <source>Use your code</source>
        <translation>Deinen Code verwenden</translation>
    </message>
    <message>
        <source>Use the listing</source>
        <translation>Listing verwenden</translation>
    </message>
    <message>
        <source>My rule</source>
        <translation>Meine Regel</translation>
    </message>
    <message>
        <source>A force that you write, for this scene</source>
        <translation>Eine Kraft für diese Szene, die du selbst schreibst</translation>
    </message>
</context>
<context>
    <name>app::CodePanel</name>
    <message>
        <source>Lines that are new in this step. Click to go through them.</source>
        <translation>Zeilen, die in diesem Schritt neu sind. Klicke, um sie durchzugehen.</translation>
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
        <source>%1 Press Enter to apply, Esc to cancel.</source>
        <translation>%1 Eingabe übernimmt, Esc bricht ab.</translation>
    </message>
    <message>
        <source>“%1” has no known value.</source>
        <translation>„%1“ hat keinen bekannten Wert.</translation>
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
        <source>Remove breakpoint</source>
        <translation>Haltepunkt entfernen</translation>
    </message>
    <message>
        <source>Set breakpoint</source>
        <translation>Haltepunkt setzen</translation>
    </message>
    <message>
        <source>Set breakpoint when…</source>
        <translation>Haltepunkt mit Bedingung …</translation>
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
        <source>Copy all shown code</source>
        <translation>Allen gezeigten Code kopieren</translation>
    </message>
    <message>
        <source>Lines that this step removed. Click to show or hide them, struck through at their old places (%1 in the code).</source>
        <translation>Zeilen, die dieser Schritt entfernt hat. Ein Klick zeigt oder verbirgt sie, durchgestrichen an ihrem alten Platz (%1 im Code).</translation>
    </message>
    <message>
        <source>1 line removed</source>
        <translation>1 Zeile entfernt</translation>
    </message>
    <message>
        <source>%1 lines removed</source>
        <translation>%1 Zeilen entfernt</translation>
    </message>
    <message>
        <source>This step removed no lines.</source>
        <translation>Dieser Schritt hat keine Zeile entfernt.</translation>
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
        <source>Up and Down go from line to line. Enter runs to a line, or folds a section at its heading. %1 sets a breakpoint, %2 changes a parameter, %3 shows a value, %4 copies.</source>
        <translation>Pfeil hoch und Pfeil runter gehen von Zeile zu Zeile. Eingabe läuft bis zu einer Zeile oder klappt an einer Überschrift einen Abschnitt ein und aus. %1 setzt einen Haltepunkt, %2 ändert einen Parameter, %3 zeigt einen Wert, %4 kopiert.</translation>
    </message>
    <message>
        <source>The run stops before this line&apos;s phase. Click to remove the breakpoint</source>
        <translation>Der Lauf hält vor der Phase dieser Zeile an. Ein Klick entfernt den Haltepunkt</translation>
    </message>
    <message>
        <source>Click to set a breakpoint before this line&apos;s phase</source>
        <translation>Ein Klick setzt einen Haltepunkt vor der Phase dieser Zeile</translation>
    </message>
    <message>
        <source>New in this step. %1</source>
        <translation>Neu in diesem Schritt. %1</translation>
    </message>
    <message>
        <source>The previous step has this line; this step removed it.</source>
        <translation>Der vorige Schritt hat diese Zeile; dieser Schritt hat sie entfernt.</translation>
    </message>
    <message>
        <source>These lines add up the values computed above. They are the same for every force.
Click to fold or unfold (Enter)</source>
        <translation>Diese Zeilen addieren die Werte, die darüber berechnet wurden. Sie sind für jede Kraft dieselben.
Klick klappt ein oder aus (Eingabe)</translation>
    </message>
</context>
<context>
    <name>app::ComparisonRuns</name>
    <message>
        <source>before: %1</source>
        <translation>vorher: %1</translation>
    </message>
    <message>
        <source>after: %1</source>
        <translation>nachher: %1</translation>
    </message>
    <message>
        <source>Computing “%1” again: frame %2 of %3. Press Esc to stop.</source>
        <translation>„%1“ wird noch einmal berechnet: Bild %2 von %3. Drück Esc, um anzuhalten.</translation>
    </message>
    <message>
        <source>Stopped: “%1” is not shown. You can show it again in “Runs”.</source>
        <translation>Angehalten: „%1“ ist nicht zu sehen. In „Läufe“ kannst du ihn wieder zeigen.</translation>
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
</context>
<context>
    <name>app::ConceptButton</name>
    <message>
        <source>known</source>
        <translation>bekannt</translation>
    </message>
    <message>
        <source>can come next</source>
        <translation>kann als Nächstes kommen</translation>
    </message>
    <message>
        <source>for later</source>
        <translation>für später</translation>
    </message>
    <message>
        <source>Opens %1</source>
        <translation>Öffnet %1</translation>
    </message>
</context>
<context>
    <name>app::ConceptView</name>
    <message>
        <source>Map of concepts</source>
        <translation>Karte der Begriffe</translation>
    </message>
</context>
<context>
    <name>app::CursorPlot</name>
    <message>
        <source>%1. Under the mouse: %2</source>
        <translation>%1. Unter der Maus: %2</translation>
    </message>
</context>
<context>
    <name>app::CurveButton</name>
    <message>
        <source>Choose this curve (%1)</source>
        <translation>Diese Kurve wählen (%1)</translation>
    </message>
    <message>
        <source>Curve %1: %2</source>
        <translation>Kurve %1: %2</translation>
    </message>
    <message>
        <source>%1, right</source>
        <translation>%1, richtig</translation>
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
    <name>app::EditCommands</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
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
        <source>&amp;Undo: %1</source>
        <translation>&amp;Rückgängig: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Wiederholen: %1</translation>
    </message>
    <message>
        <source>There is nothing to undo in this step</source>
        <translation>In diesem Schritt gibt es nichts rückgängig zu machen</translation>
    </message>
    <message>
        <source>There is nothing to redo</source>
        <translation>Es gibt nichts zu wiederholen</translation>
    </message>
</context>
<context>
    <name>app::EffectHeads</name>
    <message>
        <source>Effect</source>
        <translation>Effekt</translation>
    </message>
    <message>
        <source>The effects of this scene, in the order in which they run.</source>
        <translation>Die Effekte dieser Szene, in der Reihenfolge, in der sie laufen.</translation>
    </message>
    <message>
        <source>µs a frame</source>
        <translation>µs/Bild</translation>
    </message>
    <message>
        <source>Microseconds (millionths of a second) that each frame of the run spends on it. About half of the measurements are within the ±.</source>
        <translation>Mikrosekunden (millionstel Sekunden), die jedes Bild des Laufs dafür braucht. Etwa die Hälfte der Messungen liegt innerhalb des ±.</translation>
    </message>
    <message>
        <source>µs a point</source>
        <translation>µs/Punkt</translation>
    </message>
    <message>
        <source>The same for each point that it acts on.</source>
        <translation>Dasselbe für jeden Punkt, auf den er wirkt.</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>Male</translation>
    </message>
    <message>
        <source>How often a frame computes it. Some methods compute it several times.</source>
        <translation>Wie oft ein Bild ihn berechnet. Manche Verfahren berechnen ihn mehrmals.</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>How many points it acts on.</source>
        <translation>Auf wie viele Punkte er wirkt.</translation>
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
        <source>The effects of the scene and their costs</source>
        <translation>Die Effekte der Szene und ihre Kosten</translation>
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
        <source>Measure again</source>
        <translation>Neu messen</translation>
    </message>
    <message>
        <source>Measure what a frame costs where the run is now</source>
        <translation>Messen, was ein Bild kostet, wo der Lauf gerade ist</translation>
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
    <name>app::EnergyListModel</name>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>%1: %2&#x2009;%3
%4</source>
        <translation>%1: %2&#x2009;%3
%4</translation>
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
        <source>Everything here turns in place, held by the ground. So there is no momentum to count: choose a scene with moving bodies.</source>
        <translation>Alles dreht sich hier am Ort, vom Boden gehalten. Darum gibt es keinen Impuls zu zählen: Wähle eine Szene mit bewegten Körpern.</translation>
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
        <source>energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>momentum</source>
        <translation>Impuls</translation>
    </message>
    <message>
        <source>Click or drag to go to a frame; the arrow keys move by one frame</source>
        <translation>Klicken oder Ziehen führt zu einem Bild; die Pfeiltasten gehen ein Bild weiter</translation>
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
        <source>Could not open the experiment: %1 Your scene is unchanged.</source>
        <translation>Das Experiment ließ sich nicht öffnen: %1 Deine Szene ist unverändert.</translation>
    </message>
    <message>
        <source>Could not save the experiment: %1</source>
        <translation>Das Experiment ließ sich nicht speichern: %1</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Gespeichert als %1.</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>%1 hat ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>Save the changes, then continue</source>
        <translation>Änderungen speichern, dann weiter</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Continue without saving: your changes are lost</source>
        <translation>Ohne Speichern weiter: Deine Änderungen gehen verloren</translation>
    </message>
    <message>
        <source>Open an experiment or a lesson</source>
        <translation>Experiment oder Lektion öffnen</translation>
    </message>
    <message>
        <source>Experiments and lessons (*.springstep *.json *%1)</source>
        <translation>Experimente und Lektionen (*.springstep *.json *%1)</translation>
    </message>
    <message>
        <source>Experiments (*.springstep *.json)</source>
        <translation>Experimente (*.springstep *.json)</translation>
    </message>
    <message>
        <source>Save the experiment</source>
        <translation>Experiment speichern</translation>
    </message>
    <message>
        <source>The step has its published state again.</source>
        <translation>Der Schritt ist wieder wie veröffentlicht.</translation>
    </message>
    <message>
        <source>&amp;%1  %2</source>
        <translation>&amp;%1  %2</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>Keine Dateien</translation>
    </message>
    <message>
        <source>Experiments that you open or save are listed here</source>
        <translation>Hier stehen Experimente, die du öffnest oder speicherst</translation>
    </message>
    <message>
        <source>Could not copy the experiment: %1</source>
        <translation>Das Experiment ließ sich nicht kopieren: %1</translation>
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
        <source>“%1” has unsaved changes.</source>
        <translation>„%1“ hat ungespeicherte Änderungen.</translation>
    </message>
    <message>
        <source>Could not find %1, so it was removed from the list. If you moved it, open it from its new place.</source>
        <translation>%1 wurde nicht gefunden und deshalb aus der Liste entfernt. Wenn du die Datei verschoben hast, öffne sie an ihrem neuen Ort.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Abbrechen</translation>
    </message>
    <message>
        <source>%1[*] – Springstep</source>
        <translation>%1[*] – Springstep</translation>
    </message>
</context>
<context>
    <name>app::ExportDialog</name>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Bild %1 von %2</translation>
    </message>
    <message>
        <source>%1 is saved, up to the frame where the run stops. %2</source>
        <translation>%1 ist gespeichert, bis zu dem Bild, bei dem der Lauf anhält. %2</translation>
    </message>
    <message>
        <source>%1 is saved.</source>
        <translation>%1 ist gespeichert.</translation>
    </message>
    <message>
        <source>Cancelled. No file was written.</source>
        <translation>Abgebrochen. Keine Datei wurde geschrieben.</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>Abbre&amp;chen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this dialog (Esc)</source>
        <translation>Diesen Dialog schließen (Esc)</translation>
    </message>
</context>
<context>
    <name>app::FailureNotice</name>
    <message>
        <source>Searching for a remedy…</source>
        <translation>Sucht nach Abhilfe …</translation>
    </message>
    <message>
        <source>Correct this line, and the run goes on.</source>
        <translation>Berichtige diese Zeile, dann geht der Lauf weiter.</translation>
    </message>
    <message>
        <source>Correct this line, and the run goes on. Undo reverts your last change.</source>
        <translation>Berichtige diese Zeile, dann geht der Lauf weiter. Rückgängig nimmt deine letzte Änderung zurück.</translation>
    </message>
    <message>
        <source>No smaller step and no other method was found to be stable. Go back, and undo the change that caused this.</source>
        <translation>Weder ein kleinerer Zeitschritt noch ein anderes Verfahren erwies sich als stabil. Geh zurück und nimm die Änderung zurück, die das verursacht hat.</translation>
    </message>
</context>
<context>
    <name>app::FilmDialog</name>
    <message>
        <source>Film of the run</source>
        <translation>Film vom Lauf</translation>
    </message>
    <message>
        <source>Progress of the film</source>
        <translation>Fortschritt des Films</translation>
    </message>
    <message>
        <source>The first frame of the film</source>
        <translation>Das erste Bild des Films</translation>
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
        <source>The speed of the film: 30 is as fast as in the window</source>
        <translation>Das Tempo des Films: 30 ist so schnell wie im Fenster</translation>
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
        <source>Make the film; you can use the window meanwhile</source>
        <translation>Den Film erstellen; das Fenster kannst du derweil benutzen</translation>
    </message>
    <message>
        <source>Choosing its colours…</source>
        <translation>Farben werden ausgewählt …</translation>
    </message>
    <message>
        <source>Cancelled. The pictures up to frame %1 are saved.</source>
        <translation>Abgebrochen. Die Bilder bis Bild %1 sind gespeichert.</translation>
    </message>
    <message>
        <source>Cancel the film (Esc)</source>
        <translation>Den Film abbrechen (Esc)</translation>
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
        <source>Make the film, and overwrite the existing file</source>
        <translation>Den Film erstellen und die vorhandene Datei überschreiben</translation>
    </message>
    <message>
        <source>A name that ends in .webm or .gif makes one file. A name such as walk_%04d.png makes a picture of each frame, with its number instead of %04d.</source>
        <translation>Ein Name, der auf .webm oder .gif endet, ergibt eine Datei. Ein Name wie walk_%04d.png ergibt für jedes Bild eine Datei, mit seiner Nummer anstelle von %04d.</translation>
    </message>
</context>
<context>
    <name>app::FilmName</name>
    <message>
        <source>Where to save the film</source>
        <translation>Wohin der Film gespeichert wird</translation>
    </message>
    <message>
        <source>%1 already exists. Replace it, or choose another name.</source>
        <translation>%1 gibt es schon. Ersetze die Datei oder wähle einen anderen Namen.</translation>
    </message>
    <message>
        <source>Such pictures already exist, for example %1. Replace them, or choose another name.</source>
        <translation>Solche Bilder gibt es schon, zum Beispiel %1. Ersetze sie oder wähle einen anderen Namen.</translation>
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
        <source>The width of the pictures compared with their height; the height follows the width</source>
        <translation>Die Breite der Bilder im Verhältnis zu ihrer Höhe; die Höhe folgt der Breite</translation>
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
        <source>The times when each foot is on the ground. Click to go to that frame</source>
        <translation>Die Zeiten, in denen jeder Fuß am Boden ist. Ein Klick führt zu diesem Bild</translation>
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
        <source>Press Enter to go there, Esc to cancel</source>
        <translation>Eingabe geht hin, Esc bricht ab</translation>
    </message>
    <message>
        <source>A frame is a whole number from 0 to %1.</source>
        <translation>Ein Bild ist eine ganze Zahl von 0 bis %1.</translation>
    </message>
</context>
<context>
    <name>app::FrameRange</name>
    <message>
        <source>First frame</source>
        <translation>Erstes Bild</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Letztes Bild</translation>
    </message>
    <message>
        <source>&amp;First frame</source>
        <translation>&amp;Erstes Bild</translation>
    </message>
    <message>
        <source>&amp;Last frame</source>
        <translation>&amp;Letztes Bild</translation>
    </message>
</context>
<context>
    <name>app::Gallery</name>
    <message>
        <source>the file</source>
        <translation>die Datei</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>this is not an experiment of the gallery.</source>
        <translation>das ist kein Experiment der Galerie.</translation>
    </message>
    <message>
        <source>%1 The file was left alone.</source>
        <translation>%1 Die Datei bleibt, wie sie ist.</translation>
    </message>
    <message>
        <source>%1: the file could not be written: %2. Check the folder %3.</source>
        <translation>%1: Die Datei ließ sich nicht schreiben: %2. Prüfe den Ordner %3.</translation>
    </message>
    <message>
        <source>keep %1</source>
        <translation>%1 behalten</translation>
    </message>
    <message>
        <source>rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>%1: the file could not be removed: %2. Check the folder %3.</source>
        <translation>%1: Die Datei ließ sich nicht entfernen: %2. Prüfe den Ordner %3.</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
</context>
<context>
    <name>app::GalleryDesk</name>
    <message>
        <source>Could not keep the experiment: %1</source>
        <translation>Das Experiment ließ sich nicht behalten: %1</translation>
    </message>
    <message>
        <source>Kept in the gallery as %1.</source>
        <translation>In der Galerie als %1 behalten.</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>%1 öffnen</translation>
    </message>
    <message>
        <source>%1 is open. Undo brings your scene back.</source>
        <translation>%1 ist offen. Rückgängig bringt deine Szene zurück.</translation>
    </message>
</context>
<context>
    <name>app::GalleryPage</name>
    <message>
        <source>Gallery</source>
        <translation>Galerie</translation>
    </message>
    <message>
        <source>Experiments that you keep</source>
        <translation>Experimente, die du behältst</translation>
    </message>
    <message>
        <source>Nothing is kept here yet. Build something, then press Keep this one: the gallery stores it with a picture.</source>
        <translation>Hier ist noch nichts. Bau etwas, und drück dann „Dieses behalten“: Die Galerie bewahrt es mit einem Bild auf.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Open the selected experiment (Return)</source>
        <translation>Das gewählte Experiment öffnen (Eingabe)</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Give the selected experiment another title (F2)</source>
        <translation>Dem gewählten Experiment einen anderen Titel geben (F2)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the selected experiment from the gallery (Del)</source>
        <translation>Das gewählte Experiment aus der Galerie entfernen (Entf)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Keep this one</source>
        <translation>Dieses behalten</translation>
    </message>
    <message>
        <source>Keep the experiment that is open in the window</source>
        <translation>Das Experiment behalten, das im Fenster offen ist</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close the gallery (Esc)</source>
        <translation>Die Galerie schließen (Esc)</translation>
    </message>
    <message>
        <source>%1, kept %2. Return opens it.</source>
        <translation>%1, behalten %2. Eingabe öffnet es.</translation>
    </message>
    <message>
        <source>There is nothing to undo</source>
        <translation>Es gibt nichts rückgängig zu machen</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Z)</source>
        <translation>%1 (Strg+Z)</translation>
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
        <source>Part of a word, or of its meaning</source>
        <translation>Teil eines Begriffs oder seiner Bedeutung</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Begriffe</translation>
    </message>
    <message>
        <source>No word found for “%1”. Try only a part of it.</source>
        <translation>Kein Begriff zu „%1“ gefunden. Versuch es nur mit einem Teil davon.</translation>
    </message>
</context>
<context>
    <name>app::GrowthPlot</name>
    <message>
        <source>Map of growth</source>
        <translation>Karte des Wachstums</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instabil</translation>
    </message>
    <message>
        <source>stable</source>
        <translation>stabil</translation>
    </message>
    <message>
        <source>disturbances %1</source>
        <translation>Störungen %1</translation>
    </message>
    <message>
        <source>a step of %1</source>
        <translation>ein Zeitschritt von %1</translation>
    </message>
    <message>
        <source>Click or press Enter to use k %1 and %2</source>
        <translation>Ein Klick oder Eingabe setzt k %1 und %2</translation>
    </message>
    <message>
        <source>stiffness k, 1/frame²</source>
        <translation>Steifigkeit k, 1/Bild²</translation>
    </message>
    <message>
        <source>step, frames</source>
        <translation>Zeitschritt, Bilder</translation>
    </message>
    <message>
        <source>damp, kept per frame</source>
        <translation>damp, pro Bild behalten</translation>
    </message>
    <message>
        <source>×10 a frame</source>
        <translation>×10 pro Bild</translation>
    </message>
</context>
<context>
    <name>app::GuessBox</name>
    <message>
        <source>What do you expect?</source>
        <translation>Was erwartest du?</translation>
    </message>
    <message>
        <source>You said: %1</source>
        <translation>Du hast gesagt: %1</translation>
    </message>
    <message>
        <source>Choose what you expect</source>
        <translation>Wähle, was du erwartest</translation>
    </message>
    <message>
        <source>Hide the choices</source>
        <translation>Antworten ausblenden</translation>
    </message>
    <message>
        <source>**You said:** %1</source>
        <translation>**Du hast gesagt:** %1</translation>
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
        <source>Restart the first build with a new scene. Undo brings this one back</source>
        <translation>Das erste Bauen mit einer neuen Szene noch einmal beginnen. Rückgängig bringt diese zurück</translation>
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
    <name>app::HandInDialog</name>
    <message>
        <source>Hand in a notebook</source>
        <translation>Heft abgeben</translation>
    </message>
    <message>
        <source>A notebook has what you did: what you tried, predicted, wrote and built, each with its run. Your teacher can replay it. Nothing is sent: the files stay on this computer until you pass them on.</source>
        <translation>Ein Heft enthält, was du gemacht hast: was du ausprobiert, vorhergesagt, geschrieben und gebaut hast, jeweils mit seinem Lauf. Deine Lehrkraft kann es nachspielen. Nichts wird verschickt: Die Dateien bleiben auf diesem Computer, bis du sie weitergibst.</translation>
    </message>
    <message>
        <source>may stay empty</source>
        <translation>darf leer bleiben</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Your name for the notebook. Without it, the notebook has no name</source>
        <translation>Dein Name für das Heft. Ohne ihn hat das Heft keinen Namen</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Name</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lektionen</translation>
    </message>
    <message>
        <source>Space chooses a lesson, or leaves it out</source>
        <translation>Die Leertaste wählt eine Lektion aus oder lässt sie weg</translation>
    </message>
    <message>
        <source>&amp;Lessons, and how much you did in them</source>
        <translation>&amp;Lektionen, und wie viel du darin gemacht hast</translation>
    </message>
    <message>
        <source>Also puts in the scenes that you keep in the gallery</source>
        <translation>Legt auch die Szenen hinein, die du in der Galerie behältst</translation>
    </message>
    <message>
        <source>Note&amp;book (.springstep-notebook)</source>
        <translation>&amp;Heft (.springstep-notebook)</translation>
    </message>
    <message>
        <source>A file whose runs your teacher can replay</source>
        <translation>Eine Datei, deren Läufe deine Lehrkraft nachspielen kann</translation>
    </message>
    <message>
        <source>&amp;Web page (.html)</source>
        <translation>&amp;Webseite (.html)</translation>
    </message>
    <message>
        <source>A page to read in any browser, with pictures</source>
        <translation>Eine Seite mit Bildern, die jeder Browser zeigt</translation>
    </message>
    <message>
        <source>&amp;PDF (.pdf)</source>
        <translation>&amp;PDF (.pdf)</translation>
    </message>
    <message>
        <source>The same on paper</source>
        <translation>Dasselbe auf Papier</translation>
    </message>
    <message>
        <source>Where to write, without an ending</source>
        <translation>Wohin geschrieben wird, ohne Endung</translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>Diese Seite schließen (Esc)</translation>
    </message>
    <message>
        <source>Scenes of the &amp;gallery (%1)</source>
        <translation>Szenen der &amp;Galerie (%1)</translation>
    </message>
    <message>
        <source>Notebooks (*.springstep-notebook)</source>
        <translation>Hefte (*.springstep-notebook)</translation>
    </message>
    <message>
        <source>Wri&amp;te</source>
        <translation>&amp;Schreiben</translation>
    </message>
    <message>
        <source>Write the files</source>
        <translation>Die Dateien schreiben</translation>
    </message>
    <message>
        <source>There is nothing to hand in yet. Do a thing to try, answer a prediction, or keep a scene first.</source>
        <translation>Es gibt noch nichts abzugeben. Probier erst etwas aus, sag etwas vorher oder behalte eine Szene.</translation>
    </message>
    <message>
        <source>Choose a lesson, or the scenes of the gallery.</source>
        <translation>Wähle eine Lektion oder die Szenen der Galerie.</translation>
    </message>
    <message>
        <source>Choose what to write: the notebook, the web page or the PDF.</source>
        <translation>Wähle, was geschrieben wird: das Heft, die Webseite oder das PDF.</translation>
    </message>
    <message>
        <source>Type the name of a file.</source>
        <translation>Gib den Namen einer Datei ein.</translation>
    </message>
    <message>
        <source>This writes %1.</source>
        <translation>Das schreibt %1.</translation>
    </message>
    <message>
        <source>%1 already exists. Replace it, or choose another name.</source>
        <translation>%1 gibt es schon. Ersetze die Datei oder wähle einen anderen Namen.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Ersetzen</translation>
    </message>
    <message>
        <source>Write the files, and overwrite those that exist</source>
        <translation>Die Dateien schreiben und vorhandene überschreiben</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Schreibt …</translation>
    </message>
    <message>
        <source>%1 written to %2.</source>
        <translation>%1 steht jetzt in %2.</translation>
    </message>
    <message>
        <source>Could not write: %1</source>
        <translation>Das Schreiben ist misslungen: %1</translation>
    </message>
    <message>
        <source>notebook</source>
        <comment>name of a file</comment>
        <translation>heft</translation>
    </message>
</context>
<context>
    <name>app::Header</name>
    <message>
        <source>More menus</source>
        <translation>Weitere Menüs</translation>
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
</context>
<context>
    <name>app::Introduction</name>
    <message>
        <source>These lessons have no concepts</source>
        <translation>Diese Lektionen haben keine Begriffe</translation>
    </message>
</context>
<context>
    <name>app::KeyCaps</name>
    <message>
        <source>or</source>
        <translation>oder</translation>
    </message>
</context>
<context>
    <name>app::LanguageMenu</name>
    <message>
        <source>Lan&amp;guage</source>
        <translation>Spr&amp;ache</translation>
    </message>
    <message>
        <source>&amp;System language</source>
        <translation>&amp;Systemsprache</translation>
    </message>
    <message>
        <source>Springstep will use %1 after a restart.</source>
        <translation>Nach einem Neustart verwendet Springstep %1.</translation>
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
        <source>Show all lessons instead of the text</source>
        <translation>Alle Lektionen statt des Textes zeigen</translation>
    </message>
</context>
<context>
    <name>app::LearnerCode</name>
    <message>
        <source>Change code</source>
        <translation>Code ändern</translation>
    </message>
    <message>
        <source>Reset listing</source>
        <translation>Listing zurücksetzen</translation>
    </message>
    <message>
        <source>your code</source>
        <translation>dein Code</translation>
    </message>
    <message>
        <source>the listing of the step</source>
        <translation>das Listing des Schritts</translation>
    </message>
    <message>
        <source>This step has no listing.</source>
        <translation>Dieser Schritt hat kein Listing.</translation>
    </message>
    <message>
        <source>Your code does not compile. Line %1: %2</source>
        <translation>Dein Code lässt sich nicht übersetzen. Zeile %1: %2</translation>
    </message>
    <message>
        <source>Change method</source>
        <translation>Verfahren ändern</translation>
    </message>
</context>
<context>
    <name>app::LessonDesk</name>
    <message>
        <source>New &amp;lesson from this scene…</source>
        <translation>Neue Lektion &amp;aus dieser Szene …</translation>
    </message>
    <message>
        <source>Write a small lesson with this scene into a folder, to go on with an editor</source>
        <translation>Eine kleine Lektion mit dieser Szene in einen Ordner schreiben, um in einem Editor weiterzumachen</translation>
    </message>
    <message>
        <source>There is no place for lessons of your own</source>
        <translation>Es gibt keinen Platz für eigene Lektionen</translation>
    </message>
    <message>
        <source>Could not open the lesson: %1</source>
        <translation>Die Lektion ließ sich nicht öffnen: %1</translation>
    </message>
    <message>
        <source>Choose a new folder for the lesson</source>
        <translation>Einen neuen Ordner für die Lektion wählen</translation>
    </message>
    <message>
        <source>Folder of a lesson (*)</source>
        <translation>Ordner einer Lektion (*)</translation>
    </message>
    <message>
        <source>Could not begin a lesson: %1</source>
        <translation>Die Lektion ließ sich nicht anlegen: %1</translation>
    </message>
    <message>
        <source>The lesson is in %1. Write its texts in first.md: each time you save, they change here.</source>
        <translation>Die Lektion ist in %1. Schreib ihre Texte in first.md: Mit jedem Speichern ändern sie sich hier.</translation>
    </message>
    <message>
        <source>The lesson is in %1. Open its first.md in an editor: each time you save, it changes here.</source>
        <translation>Die Lektion ist in %1. Öffne ihre first.md in einem Editor: Mit jedem Speichern ändert sie sich hier.</translation>
    </message>
    <message>
        <source>Could not show the lesson: %1</source>
        <translation>Die Lektion ließ sich nicht anzeigen: %1</translation>
    </message>
    <message>
        <source>Re&amp;move this lesson from the list</source>
        <translation>&amp;Diese Lektion aus der Liste nehmen</translation>
    </message>
    <message>
        <source>Take the open lesson out of your lessons; its files stay where they are</source>
        <translation>Die offene Lektion aus deinen Lektionen nehmen; ihre Dateien bleiben, wo sie sind</translation>
    </message>
    <message>
        <source>The open lesson is not one of yours</source>
        <translation>Die offene Lektion ist keine von deinen</translation>
    </message>
    <message>
        <source>%1 is no longer in the list. Its files are still there.</source>
        <translation>%1 steht nicht mehr in der Liste. Die Dateien sind noch da.</translation>
    </message>
    <message>
        <source>Put it back</source>
        <translation>Zurücklegen</translation>
    </message>
    <message>
        <source>Opens the lesson again</source>
        <translation>Öffnet die Lektion wieder</translation>
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
        <translation>gerade geöffnet</translation>
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
        <source>Yours</source>
        <translation>Deine</translation>
    </message>
    <message>
        <source>Lessons that you opened with File &gt; Open</source>
        <translation>Lektionen, die du mit Datei &gt; Öffnen geöffnet hast</translation>
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
        <source>A summary of this lesson, and the things that are still to try</source>
        <translation>Eine Zusammenfassung dieser Lektion und das, was noch auszuprobieren ist</translation>
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
        <source>Previous step</source>
        <translation>Vorheriger Schritt</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Nächster Schritt</translation>
    </message>
</context>
<context>
    <name>app::LevelBox</name>
    <message>
        <source>Judge it</source>
        <translation>Beurteilen</translation>
    </message>
    <message>
        <source>Runs your scene or your code, and says whether it passes</source>
        <translation>Lässt deine Szene oder deinen Code laufen und sagt, ob die Stufe geschafft ist</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Stops the judge</source>
        <translation>Bricht die Beurteilung ab</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Tipp</translation>
    </message>
    <message>
        <source>Shows or hides a hint</source>
        <translation>Zeigt oder verbirgt einen Tipp</translation>
    </message>
    <message>
        <source>%1, passed</source>
        <translation>%1, geschafft</translation>
    </message>
    <message>
        <source>Judging: %1 % of the frames.</source>
        <translation>Wird beurteilt: %1 % der Bilder.</translation>
    </message>
    <message>
        <source>Passed: everything holds.</source>
        <translation>Geschafft: Alles gilt.</translation>
    </message>
</context>
<context>
    <name>app::LineStepper</name>
    <message>
        <source>Line %1 does not run in this frame, nor in the next one.</source>
        <translation>Zeile %1 läuft weder in diesem Bild noch im nächsten.</translation>
    </message>
</context>
<context>
    <name>app::ListingEditor</name>
    <message>
        <source>Listing: the code that you can change</source>
        <translation>Listing: der Code, den du ändern kannst</translation>
    </message>
    <message>
        <source>Run to this line</source>
        <translation>Bis zu dieser Zeile laufen</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Ausschneiden</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Einfügen</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Alles auswählen</translation>
    </message>
    <message>
        <source>Reset listing</source>
        <translation>Listing zurücksetzen</translation>
    </message>
    <message>
        <source>The run stops before this line. Click the dot to remove the breakpoint</source>
        <translation>Der Lauf hält vor dieser Zeile an. Ein Klick auf den Punkt entfernt den Haltepunkt</translation>
    </message>
    <message>
        <source>Click to run to this line. Ctrl+click sets a breakpoint</source>
        <translation>Ein Klick läuft bis zu dieser Zeile. Strg+Klick setzt einen Haltepunkt</translation>
    </message>
    <message>
        <source>You changed this line. %1</source>
        <translation>Diese Zeile hast du geändert. %1</translation>
    </message>
    <message>
        <source>Set breakpoint</source>
        <translation>Haltepunkt setzen</translation>
    </message>
    <message>
        <source>Remove breakpoint</source>
        <translation>Haltepunkt entfernen</translation>
    </message>
    <message>
        <source>Type to change it; the run is computed again after a short pause. Tab indents, %1 completes a name, %2 sets a breakpoint, Esc leaves the editor.</source>
        <translation>Tippe, um es zu ändern; nach einer kurzen Pause wird der Lauf neu berechnet. Tab rückt ein, %1 vervollständigt einen Namen, %2 setzt einen Haltepunkt, Esc verlässt den Editor.</translation>
    </message>
    <message>
        <source>My rule: forces that you write</source>
        <translation>Meine Regel: Kräfte, die du schreibst</translation>
    </message>
    <message>
        <source>Type to change it; the run is computed again after a short pause. Tab indents, %1 completes a name, Esc leaves the editor.</source>
        <translation>Tippe, um sie zu ändern; nach einer kurzen Pause wird der Lauf neu berechnet. Tab rückt ein, %1 vervollständigt einen Namen, Esc verlässt den Editor.</translation>
    </message>
    <message>
        <source>Delete rule</source>
        <translation>Regel löschen</translation>
    </message>
</context>
<context>
    <name>app::ListingPanel</name>
    <message>
        <source>Reset listing</source>
        <translation>Listing zurücksetzen</translation>
    </message>
    <message>
        <source>Correct the mistake first. Until then, the last good code computes the run.</source>
        <translation>Berichtige zuerst den Fehler. Bis dahin berechnet der letzte gültige Code den Lauf.</translation>
    </message>
    <message>
        <source>This listing does not compute the run. Choose “Use your code” first.</source>
        <translation>Dieses Listing berechnet den Lauf nicht. Wähle zuerst „Deinen Code verwenden“.</translation>
    </message>
    <message>
        <source>Bring the step&apos;s own listing back (Undo brings yours back)</source>
        <translation>Das Listing des Schritts zurückholen (Rückgängig holt deines zurück)</translation>
    </message>
    <message>
        <source>This is the step&apos;s own listing.</source>
        <translation>Das ist das Listing des Schritts.</translation>
    </message>
    <message>
        <source>No line that runs comes after line %1. Choose a line inside a function.</source>
        <translation>Nach Zeile %1 läuft keine Zeile mehr. Wähl eine Zeile in einer Funktion.</translation>
    </message>
    <message>
        <source>No longer stops before line %1.</source>
        <translation>Hält nicht mehr vor Zeile %1 an.</translation>
    </message>
    <message>
        <source>Stops before line %1.</source>
        <translation>Hält vor Zeile %1 an.</translation>
    </message>
</context>
<context>
    <name>app::MainWindow</name>
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
        <source>Open &amp;recent</source>
        <translation>&amp;Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Diagramme</translation>
    </message>
    <message>
        <source>Two runs</source>
        <translation>Zwei Läufe</translation>
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
        <source>The panels are back in their original places.</source>
        <translation>Die Leisten stehen wieder an ihren ursprünglichen Plätzen.</translation>
    </message>
    <message>
        <source>There is no folder for the gallery</source>
        <translation>Es gibt keinen Ordner für die Galerie</translation>
    </message>
</context>
<context>
    <name>app::MapPage</name>
    <message>
        <source>Map of concepts</source>
        <translation>Karte der Begriffe</translation>
    </message>
    <message>
        <source>What rests on what</source>
        <translation>Was worauf beruht</translation>
    </message>
    <message>
        <source>You know it</source>
        <translation>Kennst du</translation>
    </message>
    <message>
        <source>Can come next</source>
        <translation>Kann als Nächstes kommen</translation>
    </message>
    <message>
        <source>For later</source>
        <translation>Für später</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Back to the open step (Esc)</source>
        <translation>Zurück zum offenen Schritt (Esc)</translation>
    </message>
    <message>
        <source>You know %1 of %2 concepts. Lines lead up from a concept to those that it rests on.</source>
        <translation>Du kennst %1 von %2 Begriffen. Linien führen von einem Begriff nach oben zu denen, auf denen er beruht.</translation>
    </message>
    <message>
        <source>Go on: %1</source>
        <translation>Weiter: %1</translation>
    </message>
    <message>
        <source>Begin: %1</source>
        <translation>Anfangen: %1</translation>
    </message>
    <message>
        <source>Opens %1</source>
        <translation>Öffnet %1</translation>
    </message>
    <message>
        <source>you know it</source>
        <translation>kennst du</translation>
    </message>
    <message>
        <source>it can come next</source>
        <translation>kann als Nächstes kommen</translation>
    </message>
    <message>
        <source>for later</source>
        <translation>für später</translation>
    </message>
    <message>
        <source>Point at a concept to see what it rests on. A click, or **Enter**, opens its step. The arrow keys go from one to the next.</source>
        <translation>Zeig auf einen Begriff, dann siehst du, worauf er beruht. Ein Klick oder die **Eingabetaste** öffnet seinen Schritt. Mit den Pfeiltasten kommst du vom einen zum nächsten.</translation>
    </message>
    <message>
        <source>Rests on: %1.</source>
        <translation>Beruht auf: %1.</translation>
    </message>
    <message>
        <source>Leads to: %1.</source>
        <translation>Führt zu: %1.</translation>
    </message>
</context>
<context>
    <name>app::MapPlot</name>
    <message>
        <source>a step of %1&#x2009;frames</source>
        <translation>ein Zeitschritt von %1&#x2009;Bildern</translation>
    </message>
    <message>
        <source>The map is being computed.</source>
        <translation>Die Karte wird berechnet.</translation>
    </message>
    <message>
        <source>You are at %1. The arrow keys move over the map, and Enter uses the values at a place.</source>
        <translation>Du bist bei %1. Die Pfeiltasten gehen über die Karte, Eingabe übernimmt die Werte eines Orts.</translation>
    </message>
    <message>
        <source>you are here</source>
        <translation>du bist hier</translation>
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
    <name>app::MistakeRow</name>
    <message>
        <source>Line %1: %2</source>
        <translation>Zeile %1: %2</translation>
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
        <source>Press Return to apply, Esc to cancel</source>
        <translation>Eingabe übernimmt, Esc bricht ab</translation>
    </message>
</context>
<context>
    <name>app::NameRow</name>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>The name of the point in files, in “Stop when…”, and in lessons and their listings. Press Enter to apply.</source>
        <translation>Der Name des Punkts in Dateien, in „Anhalten, wenn …“ und in Lektionen und ihren Listings. Drück Eingabe zum Übernehmen.</translation>
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
        <source>Back: %1</source>
        <translation>Zurück: %1</translation>
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
        <source>What you learnt</source>
        <translation>Was du gelernt hast</translation>
    </message>
    <message>
        <source>What you learnt in this lesson, and what comes next</source>
        <translation>Was du in dieser Lektion gelernt hast, und was danach kommt</translation>
    </message>
    <message>
        <source>Write it yourself</source>
        <translation>Schreib es selbst</translation>
    </message>
    <message>
        <source>Predict, then play</source>
        <translation>Erst vorhersagen, dann abspielen</translation>
    </message>
    <message>
        <source>Predict first</source>
        <translation>Erst vorhersagen</translation>
    </message>
    <message>
        <source>Goes to a question about a run, at the end of the text</source>
        <translation>Geht zu einer Frage über einen Lauf am Ende des Textes</translation>
    </message>
    <message>
        <source>Goes to a task in the listing, at the end of the text</source>
        <translation>Geht zu einer Aufgabe im Listing am Ende des Textes</translation>
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
        <source>Could not save the numbers as %1: %2. Choose another folder, or free some disk space.</source>
        <translation>Die Zahlen ließen sich nicht als %1 speichern: %2. Wähle einen anderen Ordner, oder schaffe Platz.</translation>
    </message>
</context>
<context>
    <name>app::OrderPlot</name>
    <message>
        <source>Error against step: the measured order</source>
        <translation>Fehler über dem Zeitschritt: die gemessene Ordnung</translation>
    </message>
    <message>
        <source>%1: %2, as expected</source>
        <translation>%1: %2, wie erwartet</translation>
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
        <source>A step %1 times as short makes the error %2 times as small: order %3 here, %4 expected</source>
        <translation>Ein %1-mal so kurzer Zeitschritt macht den Fehler %2-mal so klein: Ordnung %3 hier, %4 erwartet</translation>
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
        <source>Pictures of this step with other values</source>
        <translation>Bilder dieses Schritts mit anderen Werten</translation>
    </message>
    <message>
        <source>Reset every parameter to its start value in this step</source>
        <translation>Jeden Parameter auf seinen Anfangswert in diesem Schritt zurücksetzen</translation>
    </message>
    <message>
        <source>Nothing to reset: every parameter has its start value.</source>
        <translation>Nichts zurückzusetzen: Jeder Parameter hat seinen Anfangswert.</translation>
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
        <source>Reset to %1</source>
        <translation>Zurück auf %1</translation>
    </message>
    <message>
        <source>Reset %1 to %2</source>
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
    <name>app::Playback</name>
    <message>
        <source>The run plays while you drag. Press Space to stop it.</source>
        <translation>Der Lauf spielt, während du ziehst. Drück die Leertaste, um ihn anzuhalten.</translation>
    </message>
    <message>
        <source>The run is paused. Press Space to play from here.</source>
        <translation>Der Lauf ist angehalten. Drück die Leertaste, um von hier aus abzuspielen.</translation>
    </message>
    <message>
        <source>Too much to compute at 30 frames a second: the run plays more slowly. Its numbers stay the same.</source>
        <translation>Zu viel zu berechnen für 30 Bilder pro Sekunde: Der Lauf spielt langsamer. Seine Zahlen bleiben dieselben.</translation>
    </message>
</context>
<context>
    <name>app::PlotCard</name>
    <message>
        <source>Plotted quantity</source>
        <translation>Aufgetragene Größe</translation>
    </message>
    <message>
        <source>The other axis: time, or another quantity</source>
        <translation>Die andere Achse: Zeit oder eine andere Größe</translation>
    </message>
    <message>
        <source>Save, copy, keep or remove this plot</source>
        <translation>Dieses Diagramm speichern, kopieren, festhalten oder entfernen</translation>
    </message>
    <message>
        <source>Actions for this plot</source>
        <translation>Aktionen für dieses Diagramm</translation>
    </message>
    <message>
        <source>against</source>
        <translation>über</translation>
    </message>
    <message>
        <source>&amp;Pin to %1</source>
        <translation>An %1 an&amp;heften</translation>
    </message>
    <message>
        <source>If off, the plot follows the body that is selected in the picture</source>
        <translation>Wenn aus, folgt das Diagramm dem Körper, der in der Szene ausgewählt ist</translation>
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
        <source>Could not save the picture as %1: %2. Choose another folder, or free some disk space.</source>
        <translation>Das Bild ließ sich nicht als %1 speichern: %2. Wähle einen anderen Ordner, oder schaffe Platz.</translation>
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
        <source>There are no numbers to save, because this plot is empty. Play the run first.</source>
        <translation>Es gibt keine Zahlen zu speichern, denn dieses Diagramm ist leer. Spiel erst den Lauf ab.</translation>
    </message>
    <message>
        <source>Cancelled: nothing was saved.</source>
        <translation>Abgebrochen: Nichts wurde gespeichert.</translation>
    </message>
    <message>
        <source>All values that are counted or measured here, with all digits</source>
        <translation>Alle Werte, die hier gezählt oder gemessen sind, mit allen Stellen</translation>
    </message>
    <message>
        <source>Could not save the numbers as %1: %2. Choose another folder, or free some disk space.</source>
        <translation>Die Zahlen ließen sich nicht als %1 speichern: %2. Wähle einen anderen Ordner, oder schaffe Platz.</translation>
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
        <source>There is no plot yet. &lt;b&gt;Add&lt;/b&gt;, above, has curves to start with: the position of a body, its speed, or one quantity against another.</source>
        <translation>Es gibt noch kein Diagramm. &lt;b&gt;Neu&lt;/b&gt;, oben, hat Kurven für den Anfang: die Position eines Körpers, sein Tempo oder eine Größe über einer anderen.</translation>
    </message>
    <message>
        <source>Progress of saving</source>
        <translation>Fortschritt des Speicherns</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel; nothing is saved then</source>
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
        <source>For anything else, add a plot and choose what it shows</source>
        <translation>Für alles andere: ein Diagramm hinzufügen und wählen, was es zeigt</translation>
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
    <name>app::PredictionBox</name>
    <message>
        <source>Fold this prediction</source>
        <translation>Diese Vorhersage zuklappen</translation>
    </message>
    <message>
        <source>Predict what happens</source>
        <translation>Vorhersagen, was geschieht</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>Type your prediction. Enter plays the run.</source>
        <translation>Tipp deine Vorhersage ein. Enter spielt den Lauf ab.</translation>
    </message>
    <message>
        <source>Your prediction</source>
        <translation>Deine Vorhersage</translation>
    </message>
    <message>
        <source>Your prediction, %1</source>
        <translation>Deine Vorhersage, %1</translation>
    </message>
    <message>
        <source>Choose the place</source>
        <translation>Ort wählen</translation>
    </message>
    <message>
        <source>Shows how the run begins. Then click a place, or move the cross with the arrow keys.</source>
        <translation>Zeigt, wie der Lauf beginnt. Klick dann einen Ort an oder bewege das Kreuz mit den Pfeiltasten.</translation>
    </message>
    <message>
        <source>Play it</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Predict again</source>
        <translation>Neu vorhersagen</translation>
    </message>
    <message>
        <source>Forgets this answer, so that you can give another one</source>
        <translation>Vergisst diese Antwort, damit du eine andere geben kannst</translation>
    </message>
    <message>
        <source>Watch the run. It stops by itself.</source>
        <translation>Sieh dem Lauf zu. Er hält von selbst an.</translation>
    </message>
    <message>
        <source>One moment …</source>
        <translation>Einen Moment …</translation>
    </message>
    <message>
        <source>The run was changed on the way. Play it again to see how it ends.</source>
        <translation>Der Lauf wurde unterwegs geändert. Spiel ihn noch einmal ab, um zu sehen, wie er endet.</translation>
    </message>
    <message>
        <source>Your cross is at **%1**.</source>
        <translation>Dein Kreuz ist bei **%1**.</translation>
    </message>
    <message>
        <source>Click in the scene, or move the cross with the arrow keys.</source>
        <translation>Klick in die Szene oder bewege das Kreuz mit den Pfeiltasten.</translation>
    </message>
    <message>
        <source>Move the cross</source>
        <translation>Kreuz verschieben</translation>
    </message>
    <message>
        <source>Plays the run, and compares it with your prediction. Undo brings your own run back.</source>
        <translation>Spielt den Lauf ab und vergleicht ihn mit deiner Vorhersage. Rückgängig bringt deinen eigenen Lauf zurück.</translation>
    </message>
    <message>
        <source>Predict first.</source>
        <translation>Sag erst etwas vorher.</translation>
    </message>
    <message>
        <source>Answered. Fold this prediction</source>
        <translation>Beantwortet. Diese Vorhersage zuklappen</translation>
    </message>
    <message>
        <source>Answered. Show it again</source>
        <translation>Beantwortet. Wieder zeigen</translation>
    </message>
    <message>
        <source>%1, answered</source>
        <translation>%1, beantwortet</translation>
    </message>
</context>
<context>
    <name>app::PredictionDesk</name>
    <message>
        <source>Prediction</source>
        <translation>Vorhersage</translation>
    </message>
    <message>
        <source>the prediction</source>
        <translation>die Vorhersage</translation>
    </message>
    <message>
        <source>prediction</source>
        <translation>Vorhersage</translation>
    </message>
</context>
<context>
    <name>app::PresetGallery</name>
    <message>
        <source>Presets</source>
        <translation>Beispiele</translation>
    </message>
    <message>
        <source>%1 Restarts this step.</source>
        <translation>%1 Startet diesen Schritt neu.</translation>
    </message>
</context>
<context>
    <name>app::ProjectBox</name>
    <message>
        <source>Start</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Weiter</translation>
    </message>
    <message>
        <source>Opens what you have built so far</source>
        <translation>Öffnet, was du bisher gebaut hast</translation>
    </message>
    <message>
        <source>Put away</source>
        <translation>Weglegen</translation>
    </message>
    <message>
        <source>Removes this project from here. What you built stays.</source>
        <translation>Nimmt dieses Projekt von hier weg. Was du gebaut hast, bleibt.</translation>
    </message>
    <message>
        <source>Fold the project</source>
        <translation>Projekt einklappen</translation>
    </message>
    <message>
        <source>Show the brief and the levels of the project</source>
        <translation>Aufgabe und Stufen des Projekts zeigen</translation>
    </message>
    <message>
        <source>Project: %1</source>
        <translation>Projekt: %1</translation>
    </message>
    <message>
        <source>Levels that you have passed</source>
        <translation>Stufen, die du geschafft hast</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Opens the start scene of this project. Undo brings back what is there now.</source>
        <translation>Öffnet die Anfangsszene dieses Projekts. Rückgängig bringt zurück, was jetzt da ist.</translation>
    </message>
</context>
<context>
    <name>app::ProjectDesk</name>
    <message>
        <source>Start “%1”</source>
        <translation>„%1“ beginnen</translation>
    </message>
    <message>
        <source>The start scene is open. Undo brings your scene back.</source>
        <translation>Die Anfangsszene ist offen. Rückgängig bringt deine Szene zurück.</translation>
    </message>
</context>
<context>
    <name>app::PropertyRow</name>
    <message>
        <source>%1 From %2 to %3.</source>
        <translation>%1 Von %2 bis %3.</translation>
    </message>
    <message>
        <source>different</source>
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
        <source>Select one in the picture, then pin the plot to it</source>
        <translation>Wähle einen in der Szene aus, und hefte das Diagramm dann an ihn an</translation>
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
        <source>Play, or step one frame, to start a curve here.</source>
        <translation>Spiele ab, oder geh ein Bild weiter, damit hier eine Kurve beginnt.</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>%1: %2 inside frame %3</source>
        <translation>%1: %2 innerhalb von Bild %3</translation>
    </message>
</context>
<context>
    <name>app::RecallBox</name>
    <message>
        <source>The question before</source>
        <translation>Die Frage davor</translation>
    </message>
    <message>
        <source>The next question</source>
        <translation>Die nächste Frage</translation>
    </message>
    <message>
        <source>Do it in the scene</source>
        <translation>In der Szene machen</translation>
    </message>
    <message>
        <source>Opens the scene. Your run of that step stays under “Runs”.</source>
        <translation>Öffnet die Szene. Dein Lauf des Schritts bleibt unter „Läufe“.</translation>
    </message>
    <message>
        <source>**Right.** %1</source>
        <translation>**Richtig.** %1</translation>
    </message>
    <message>
        <source>**Not this one.** %1</source>
        <translation>**Diese nicht.** %1</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Noch einmal machen</translation>
    </message>
    <message>
        <source>Question %1 of %2</source>
        <translation>Frage %1 von %2</translation>
    </message>
</context>
<context>
    <name>app::RecallDesk</name>
    <message>
        <source>There is no step %1.</source>
        <translation>Es gibt keinen Schritt %1.</translation>
    </message>
    <message>
        <source>Set the scene up</source>
        <translation>Szene einrichten</translation>
    </message>
    <message>
        <source>your run</source>
        <translation>dein Lauf</translation>
    </message>
    <message>
        <source>there is no step %1. Write “- step: lesson/step”.</source>
        <translation>Es gibt keinen Schritt %1. Schreib „- step: lesson/step“.</translation>
    </message>
</context>
<context>
    <name>app::RecallPage</name>
    <message>
        <source>Do it in the scene</source>
        <translation>In der Szene machen</translation>
    </message>
    <message>
        <source>Set the scene up again</source>
        <translation>Szene neu einrichten</translation>
    </message>
    <message>
        <source>Begins the run again as it was when this question opened</source>
        <translation>Beginnt den Lauf noch einmal so, wie er war, als sich die Frage öffnete</translation>
    </message>
    <message>
        <source>Back to the questions</source>
        <translation>Zurück zu den Fragen</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Back to the questions of the lesson. You can answer this one later.</source>
        <translation>Zurück zu den Fragen der Lektion. Du kannst diese später beantworten.</translation>
    </message>
    <message>
        <source>**Done** ✓</source>
        <translation>**Geschafft** ✓</translation>
    </message>
    <message>
        <source>Not done yet. Springstep sees it when you have done it.</source>
        <translation>Noch nicht getan. Springstep merkt es, wenn du es gemacht hast.</translation>
    </message>
</context>
<context>
    <name>app::RecoveryList</name>
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
        <source>These scenes were not saved. Recover one to continue with it.</source>
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
        <source>Continue with the selected scene (Return)</source>
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
    <name>app::RecoveryPrompt</name>
    <message>
        <source>“%1: %2”</source>
        <translation>„%1: %2“</translation>
    </message>
    <message>
        <source>Springstep did not close normally. Your scene of %1 from %2 can be recovered.</source>
        <translation>Springstep wurde nicht normal beendet. Deine Szene zu %1 (%2) lässt sich wiederherstellen.</translation>
    </message>
    <message>
        <source>Your scene of %1 from %2 was not saved. It can be recovered.</source>
        <translation>Deine Szene zu %1 (%2) wurde nicht gespeichert. Sie lässt sich wiederherstellen.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Wiederherstellen</translation>
    </message>
    <message>
        <source>Continue with this scene</source>
        <translation>Mit dieser Szene weitermachen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete this scene for good</source>
        <translation>Diese Szene endgültig löschen</translation>
    </message>
    <message>
        <source>Springstep did not close normally. %1 unsaved scenes can be recovered.</source>
        <translation>Springstep wurde nicht normal beendet. %1 ungespeicherte Szenen lassen sich wiederherstellen.</translation>
    </message>
    <message>
        <source>%1 unsaved scenes can be recovered.</source>
        <translation>%1 ungespeicherte Szenen lassen sich wiederherstellen.</translation>
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
    <name>app::RemedySearch</name>
    <message>
        <source>Computes the run again with this change, up to this frame. Your input is kept, and the old run stays as a ghost.</source>
        <translation>Berechnet den Lauf mit dieser Änderung noch einmal, bis zu diesem Bild. Deine Eingaben bleiben, und der alte Lauf bleibt als Geist.</translation>
    </message>
    <message>
        <source>Not tested: that would take too long.</source>
        <translation>Nicht geprüft: Das würde zu lange dauern.</translation>
    </message>
    <message numerus="yes">
        <source>Tested: it is stable for %n frames.</source>
        <translation>
            <numerusform>Geprüft: %n Bild lang stabil.</numerusform>
            <numerusform>Geprüft: %n Bilder lang stabil.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::Restart</name>
    <message>
        <source>%1 A film is being made.</source>
        <translation>%1 Gerade entsteht ein Film.</translation>
    </message>
    <message>
        <source>%1 A web page is being made.</source>
        <translation>%1 Gerade entsteht eine Webseite.</translation>
    </message>
    <message>
        <source>Restart now</source>
        <translation>Jetzt neu starten</translation>
    </message>
    <message>
        <source>Cancels the film; everything else is kept</source>
        <translation>Bricht den Film ab; alles andere bleibt</translation>
    </message>
    <message>
        <source>Cancels the page; everything else is kept</source>
        <translation>Bricht die Webseite ab; alles andere bleibt</translation>
    </message>
</context>
<context>
    <name>app::RulePanel</name>
    <message>
        <source>Delete rule</source>
        <translation>Regel löschen</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Einschalten</translation>
    </message>
    <message>
        <source>Let your rule act again, from frame 0 on</source>
        <translation>Lass deine Regel wieder wirken, von Bild 0 an</translation>
    </message>
    <message>
        <source>Delete your rule and start over (Undo brings it back)</source>
        <translation>Deine Regel löschen und neu anfangen (Rückgängig bringt sie zurück)</translation>
    </message>
    <message>
        <source>There is no rule yet.</source>
        <translation>Es gibt noch keine Regel.</translation>
    </message>
    <message>
        <source>No rule acts yet. Your code acts as soon as you stop typing.</source>
        <translation>Noch wirkt keine Regel. Dein Code wirkt, sobald du aufhörst zu tippen.</translation>
    </message>
    <message>
        <source>Your rule is switched off.</source>
        <translation>Deine Regel ist ausgeschaltet.</translation>
    </message>
    <message>
        <source>Your last rule without a mistake still acts.</source>
        <translation>Deine letzte Regel ohne Fehler wirkt weiter.</translation>
    </message>
    <message>
        <source>force acts on every body.</source>
        <translation>force wirkt auf jeden Körper.</translation>
    </message>
    <message>
        <source>pull acts along rule links, and there are none yet.</source>
        <translation>pull wirkt entlang von Regelverbindungen, und es gibt noch keine.</translation>
    </message>
    <message numerus="yes">
        <source>pull acts along %n rule links.</source>
        <translation>
            <numerusform>pull wirkt entlang von %n Regelverbindung.</numerusform>
            <numerusform>pull wirkt entlang von %n Regelverbindungen.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::RunCommands</name>
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
        <source>Re&amp;start</source>
        <translation>Neu s&amp;tarten</translation>
    </message>
    <message>
        <source>Repea&amp;t the run with the same input</source>
        <translation>Den Lauf mit denselben Eingaben wieder&amp;holen</translation>
    </message>
    <message>
        <source>To th&amp;e last computed frame</source>
        <translation>Zum l&amp;etzten berechneten Bild</translation>
    </message>
    <message>
        <source>Go to frame…</source>
        <translation>Zu Bild gehen …</translation>
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
        <source>Reset run &amp;and parameters</source>
        <translation>La&amp;uf und Parameter zurücksetzen</translation>
    </message>
    <message>
        <source>Delete the &amp;old run</source>
        <translation>Alten Lauf lö&amp;schen</translation>
    </message>
    <message>
        <source>Choose another run…</source>
        <translation>Anderen Lauf wählen …</translation>
    </message>
    <message>
        <source>&amp;Compare two runs</source>
        <translation>Z&amp;wei Läufe vergleichen</translation>
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
        <source>One phase forward</source>
        <translation>Eine Phase weiter</translation>
    </message>
    <message>
        <source>One phase back</source>
        <translation>Eine Phase zurück</translation>
    </message>
    <message>
        <source>Go to a frame</source>
        <translation>Zu einem Bild gehen</translation>
    </message>
    <message>
        <source>The distance between the two runs, frame by frame</source>
        <translation>Der Abstand der zwei Läufe, Bild für Bild</translation>
    </message>
    <message>
        <source>This is frame 0, the first frame.</source>
        <translation>Das ist Bild 0, das erste Bild.</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Ein Bild zurück</translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation>Ein Bild weiter</translation>
    </message>
    <message>
        <source>Stop here</source>
        <translation>Hier anhalten</translation>
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
        <source>%1 repeats this run instead, with the same input.</source>
        <translation>%1 wiederholt stattdessen diesen Lauf, mit denselben Eingaben.</translation>
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
        <source>To the start of this frame</source>
        <translation>Zum Anfang dieses Bildes</translation>
    </message>
    <message>
        <source>To the end of this frame</source>
        <translation>Zum Ende dieses Bildes</translation>
    </message>
    <message>
        <source>Starts a new run from frame 0, with the current parameters.</source>
        <translation>Startet einen neuen Lauf ab Bild 0, mit den jetzigen Parametern.</translation>
    </message>
    <message>
        <source>Go back in time and change something: the old run then appears here.</source>
        <translation>Geh in der Zeit zurück und ändere etwas: Der alte Lauf erscheint dann hier.</translation>
    </message>
    <message>
        <source>Step over calls</source>
        <translation>Aufrufe überspringen</translation>
    </message>
    <message>
        <source>Step out of the call</source>
        <translation>Aus dem Aufruf heraus</translation>
    </message>
    <message>
        <source>Run the next line with all functions that it calls</source>
        <translation>Die nächste Zeile mit allen Funktionen ausführen, die sie aufruft</translation>
    </message>
    <message>
        <source>Run to the end of the function, or of the frame</source>
        <translation>Bis zum Ende der Funktion laufen, oder des Bildes</translation>
    </message>
    <message>
        <source>&amp;Next line</source>
        <translation>&amp;Nächste Zeile</translation>
    </message>
    <message>
        <source>One line forward</source>
        <translation>Eine Zeile weiter</translation>
    </message>
    <message>
        <source>Line bac&amp;k</source>
        <translation>Zeile zurüc&amp;k</translation>
    </message>
    <message>
        <source>One line back</source>
        <translation>Eine Zeile zurück</translation>
    </message>
    <message>
        <source>Open the Listing page of the code to go line by line.</source>
        <translation>Öffne die Seite „Listing“ des Codes, um Zeile für Zeile zu gehen.</translation>
    </message>
</context>
<context>
    <name>app::RunEditor</name>
    <message>
        <source>The old run stays beside this one as “%1”.</source>
        <translation>Der alte Lauf bleibt als „%1“ neben diesem.</translation>
    </message>
    <message>
        <source>Choose “%1”</source>
        <translation>„%1“ wählen</translation>
    </message>
    <message>
        <source>Reset run and parameters</source>
        <translation>Lauf und Parameter zurücksetzen</translation>
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
        <source>A new run. The old one is in “Runs”; Undo brings it back.</source>
        <translation>Ein neuer Lauf. Der alte steht in „Läufe“; Rückgängig bringt ihn zurück.</translation>
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
        <source>“%1” is the current run again. The run that you left is now in “Runs”.</source>
        <translation>„%1“ ist wieder der aktuelle Lauf. Der Lauf, den du verlassen hast, steht jetzt in „Läufe“.</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>Rückgängig: %1.</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>Wiederholt: %1.</translation>
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
        <source>%1 off</source>
        <translation>%1 aus</translation>
    </message>
    <message>
        <source>%1 on</source>
        <translation>%1 an</translation>
    </message>
</context>
<context>
    <name>app::RunPlot</name>
    <message>
        <source>Error over the run</source>
        <translation>Fehler über den Lauf</translation>
    </message>
    <message>
        <source>error, px</source>
        <translation>Fehler, px</translation>
    </message>
    <message>
        <source>Frame %1: error %2</source>
        <translation>Bild %1: Fehler %2</translation>
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
        <source>Go back in time and change something: the old run then stays as another run.</source>
        <translation>Geh in der Zeit zurück und ändere etwas: Der alte Lauf bleibt dann als anderer Lauf.</translation>
    </message>
    <message>
        <source>&amp;Hide the other run</source>
        <translation>Den anderen Lauf &amp;verbergen</translation>
    </message>
    <message>
        <source>Shows only this run; the others stay in this menu</source>
        <translation>Zeigt nur diesen Lauf; die anderen bleiben in diesem Menü</translation>
    </message>
    <message>
        <source>&amp;Compare in numbers</source>
        <translation>In &amp;Zahlen vergleichen</translation>
    </message>
    <message>
        <source>The distance between the two runs, frame by frame</source>
        <translation>Der Abstand der zwei Läufe, Bild für Bild</translation>
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
        <source>Makes it the current run again, exactly as it was; this run becomes another run</source>
        <translation>Macht ihn wieder zum aktuellen Lauf, genau wie er war; dieser wird ein anderer Lauf</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Behalten</translation>
    </message>
    <message>
        <source>Keeps this run until you delete it. Of the other runs, only the last %1 stay.</source>
        <translation>Behält diesen Lauf, bis du ihn löschst. Von den anderen bleiben nur die letzten %1.</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Umbenennen …</translation>
    </message>
    <message>
        <source>Give this run another name</source>
        <translation>Diesem Lauf einen anderen Namen geben</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>Deletes this run; Undo brings it back</source>
        <translation>Löscht diesen Lauf; Rückgängig bringt ihn zurück</translation>
    </message>
</context>
<context>
    <name>app::SandboxCommands</name>
    <message>
        <source>&amp;Take this scene to the sandbox</source>
        <translation>Diese Szene in den Sandkasten überneh&amp;men</translation>
    </message>
    <message>
        <source>&amp;Delete selection</source>
        <translation>Auswahl &amp;löschen</translation>
    </message>
    <message>
        <source>Dup&amp;licate selection</source>
        <translation>Auswahl &amp;verdoppeln</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>&amp;Alles auswählen</translation>
    </message>
    <message>
        <source>Continue building this scene in the sandbox</source>
        <translation>An dieser Szene im Sandkasten weiterbauen</translation>
    </message>
    <message>
        <source>Select and move parts</source>
        <translation>Teile auswählen und bewegen</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Auswahl</translation>
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
        <source>Fix a point in place, or free it</source>
        <translation>Einen Punkt an seinem Ort befestigen oder ihn lösen</translation>
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
        <source>Connect two points with a spring, which pulls and pushes them to its length</source>
        <translation>Zwei Punkte mit einer Feder verbinden, die sie auf ihre Länge zieht und schiebt</translation>
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
        <source>Connect two points with a stick, which keeps its length</source>
        <translation>Zwei Punkte mit einem Stab verbinden, der seine Länge behält</translation>
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
        <source>Give a body a foot, at an angle from the body</source>
        <translation>Einem Körper einen Fuß geben, in einem Winkel zum Körper</translation>
    </message>
    <message>
        <source>The sandbox is not installed</source>
        <translation>Der Sandkasten ist nicht installiert</translation>
    </message>
    <message>
        <source>This scene is already in the sandbox</source>
        <translation>Diese Szene ist schon im Sandkasten</translation>
    </message>
    <message>
        <source>Select parts, and drag them to another place</source>
        <translation>Teile auswählen und an einen anderen Ort ziehen</translation>
    </message>
    <message>
        <source>&amp;My rule</source>
        <translation>Meine Re&amp;gel</translation>
    </message>
    <message>
        <source>My rule</source>
        <translation>Meine Regel</translation>
    </message>
    <message>
        <source>Write a force of your own for this scene</source>
        <translation>Schreibe selbst eine Kraft für diese Szene</translation>
    </message>
    <message>
        <source>Lin&amp;k selection by my rule</source>
        <translation>Auswahl d&amp;urch meine Regel verbinden</translation>
    </message>
    <message>
        <source>Link all</source>
        <translation>Alle Paare</translation>
    </message>
    <message>
        <source>Add a rule link between each two of the selected points</source>
        <translation>Je zwei der ausgewählten Punkte durch eine Regelverbindung verbinden</translation>
    </message>
    <message>
        <source>Add rule links</source>
        <translation>Regelverbindungen hinzufügen</translation>
    </message>
    <message>
        <source>Rule link</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>Connect two points by the function pull of your rule</source>
        <translation>Zwei Punkte durch die Funktion pull deiner Regel verbinden</translation>
    </message>
</context>
<context>
    <name>app::SandboxEditor</name>
    <message>
        <source>The scene has too many of this kind. Delete some first.</source>
        <translation>Die Szene hat zu viele von dieser Art. Lösche erst welche.</translation>
    </message>
    <message>
        <source>This point is already a foot, and a point can be the foot of only one body. Choose another point.</source>
        <translation>Dieser Punkt ist schon ein Fuß, und ein Punkt kann nur der Fuß eines einzigen Körpers sein. Wähle einen anderen Punkt.</translation>
    </message>
    <message>
        <source>A scene needs at least one point that can move. Leave one free.</source>
        <translation>Eine Szene braucht mindestens einen Punkt, der sich bewegen kann. Lass einen übrig.</translation>
    </message>
    <message>
        <source>With this copy, the scene would have too many parts. Select fewer parts, or delete some first.</source>
        <translation>Mit dieser Kopie hätte die Szene zu viele Teile. Wähle weniger aus oder lösche erst welche.</translation>
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
    <message>
        <source>rule link</source>
        <translation>Regelverbindung</translation>
    </message>
    <message>
        <source>Add rule link</source>
        <translation>Regelverbindung hinzufügen</translation>
    </message>
    <message>
        <source>These two points have a rule link already, and the rule acts once along it.</source>
        <translation>Diese zwei Punkte haben schon eine Regelverbindung, und die Regel wirkt einmal entlang von ihr.</translation>
    </message>
    <message>
        <source>Select at least two points first: draw a box around them.</source>
        <translation>Wähle zuerst mindestens zwei Punkte aus: Ziehe einen Rahmen um sie.</translation>
    </message>
    <message>
        <source>Link %1 by the rule</source>
        <translation>%1 durch die Regel verbinden</translation>
    </message>
    <message>
        <source>All of these points have rule links already.</source>
        <translation>Alle diese Punkte haben schon Regelverbindungen.</translation>
    </message>
    <message>
        <source>“%1” is a parameter. Choose another name, such as “%1_1”.</source>
        <translation>„%1“ ist ein Parameter. Wähle einen anderen Namen, zum Beispiel „%1_1“.</translation>
    </message>
    <message>
        <source>Another point is called “%1”. Choose another name.</source>
        <translation>Ein anderer Punkt heißt schon „%1“. Wähle einen anderen Namen.</translation>
    </message>
    <message>
        <source>Your code computes this run, and it names the points. Choose another method first.</source>
        <translation>Diesen Lauf berechnet dein Code, und der nennt die Punkte beim Namen. Wähle zuerst ein anderes Verfahren.</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>%1 in %2 umbenennen</translation>
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
        <source>Choose what the picture shows besides the creature</source>
        <translation>Auswählen, was die Szene außer der Figur zeigt</translation>
    </message>
    <message>
        <source>Zoom to 100&#x2009;%</source>
        <translation>Auf 100&#x2009;% zoomen</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
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
        <source>Guide lines</source>
        <translation>Hilfslinien</translation>
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
        <source>All pulls</source>
        <translation>Alle Züge</translation>
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
    <message>
        <source>The largest error that the method allows in each of its steps</source>
        <translation>Der größte Fehler, den das Verfahren in jedem seiner Zeitschritte zulässt</translation>
    </message>
    <message>
        <source>Your code</source>
        <translation>Dein Code</translation>
    </message>
    <message>
        <source>The listing, as you changed it</source>
        <translation>Das Listing, wie du es geändert hast</translation>
    </message>
    <message>
        <source>This step has no listing.</source>
        <translation>Dieser Schritt hat kein Listing.</translation>
    </message>
    <message>
        <source>Unit circle</source>
        <translation>Einheitskreis</translation>
    </message>
</context>
<context>
    <name>app::SceneCard</name>
    <message>
        <source>Done! You have tried everything here. %1 opens the next step.</source>
        <translation>Fertig! Du hast hier alles ausprobiert. %1 öffnet den nächsten Schritt.</translation>
    </message>
    <message>
        <source>Done! You have tried everything here.</source>
        <translation>Fertig! Du hast hier alles ausprobiert.</translation>
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
        <source>The hand of the recorded run is at %1, %2</source>
        <translation>Die Hand des aufgezeichneten Laufs ist bei %1, %2</translation>
    </message>
    <message>
        <source>Preview. %1</source>
        <translation>Vorschau. %1</translation>
    </message>
    <message>
        <source>Preview of frame %1.</source>
        <translation>Vorschau von Bild %1.</translation>
    </message>
    <message>
        <source>The formula is about: %1</source>
        <translation>Die Formel handelt von: %1</translation>
    </message>
</context>
<context>
    <name>app::SettlingMonitor</name>
    <message>
        <source>Change %1 and %2</source>
        <translation>%1 und %2 ändern</translation>
    </message>
</context>
<context>
    <name>app::SettlingPlot</name>
    <message>
        <source>Map of the time to rest</source>
        <translation>Karte der Zeit bis zur Ruhe</translation>
    </message>
    <message numerus="yes">
        <source>at rest after %n frames</source>
        <translation>
            <numerusform>nach %n Bild in Ruhe</numerusform>
            <numerusform>nach %n Bildern in Ruhe</numerusform>
        </translation>
    </message>
    <message>
        <source>still moving after %1 frames</source>
        <translation>nach %1 Bildern noch in Bewegung</translation>
    </message>
    <message>
        <source>the motion grows without bound</source>
        <translation>die Bewegung wächst ohne Grenze</translation>
    </message>
    <message>
        <source>cannot be computed</source>
        <translation>nicht zu berechnen</translation>
    </message>
    <message>
        <source>Click or press Enter to begin the run again with %1 %2 and %3 %4</source>
        <translation>Ein Klick oder Eingabe beginnt den Lauf neu mit %1 %2 und %3 %4</translation>
    </message>
    <message>
        <source>Your run from its start, with all you did: how many frames after frame %1, your last input, it is at rest.</source>
        <translation>Dein Lauf von Anfang an, mit allem, was du getan hast: wie viele Bilder nach Bild %1, deiner letzten Eingabe, er in Ruhe ist.</translation>
    </message>
    <message>
        <source>Your run from its start: after how many frames it is at rest.</source>
        <translation>Dein Lauf von Anfang an: nach wie vielen Bildern er in Ruhe ist.</translation>
    </message>
    <message>
        <source>At rest, each body stays within 1&#x2009;px of its last place, and moves less than 0.05&#x2009;px in a frame.</source>
        <translation>In Ruhe heißt: Jeder Körper bleibt höchstens 1&#x2009;px von seinem letzten Ort entfernt und bewegt sich um weniger als 0,05&#x2009;px pro Bild.</translation>
    </message>
    <message>
        <source>Input after frame %1 is left out.</source>
        <translation>Eingaben nach Bild %1 fehlen dabei.</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 Bilder</translation>
    </message>
    <message>
        <source>still moving</source>
        <translation>bewegt sich</translation>
    </message>
    <message>
        <source>grows</source>
        <translation>wächst</translation>
    </message>
</context>
<context>
    <name>app::SizeMenu</name>
    <message>
        <source>Si&amp;ze of text and controls</source>
        <translation>Größe von &amp;Text und Bedienelementen</translation>
    </message>
    <message>
        <source>%1&#x2009;%</source>
        <translation>%1&#x2009;%</translation>
    </message>
    <message>
        <source>Changes text, buttons and the scene. The window opens again with all its contents</source>
        <translation>Ändert Text, Knöpfe und Szene. Das Fenster öffnet sich neu mit allem, was darin ist</translation>
    </message>
    <message>
        <source>At that size, this screen is too small for the scene and its timeline</source>
        <translation>Bei dieser Größe ist dieser Bildschirm für die Szene und ihre Zeitleiste zu klein</translation>
    </message>
    <message>
        <source>Springstep will be drawn at %1&#x2009;% after a restart.</source>
        <translation>Nach einem Neustart wird Springstep mit %1&#x2009;% gezeichnet.</translation>
    </message>
</context>
<context>
    <name>app::SpeedButton</name>
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
    <name>app::StabilityGauge</name>
    <message>
        <source>Stability</source>
        <translation>Stabilität</translation>
    </message>
    <message>
        <source>Click for the reasons and the remedies</source>
        <translation>Ein Klick zeigt die Gründe und Gegenmittel</translation>
    </message>
    <message>
        <source>%1&#x2009;% of the limit</source>
        <translation>%1&#x2009;% der Grenze</translation>
    </message>
    <message>
        <source>Preview of frame %1: %2</source>
        <translation>Vorschau von Bild %1: %2</translation>
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
        <source>Close, and show the previous panel</source>
        <translation>Schließen und die vorige Leiste zeigen</translation>
    </message>
    <message>
        <source>Remedies</source>
        <translation>Gegenmittel</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>k and step</source>
        <translation>k und Zeitschritt</translation>
    </message>
    <message>
        <source>Shows which stiffness and step are stable, with everything else unchanged. Click again to close</source>
        <translation>Zeigt, welche Steifigkeit und welcher Zeitschritt stabil sind; alles andere bleibt gleich. Noch ein Klick schließt die Karte</translation>
    </message>
    <message>
        <source>k and damping</source>
        <translation>k und Dämpfung</translation>
    </message>
    <message>
        <source>Shows which stiffness and damping are stable, with everything else unchanged. Click again to close</source>
        <translation>Zeigt, welche Steifigkeit und welche Dämpfung stabil sind; alles andere bleibt gleich. Noch ein Klick schließt die Karte</translation>
    </message>
    <message>
        <source>There is no map for this step: it has no stiffness k to change.</source>
        <translation>Für diesen Schritt gibt es keine Karte: Er hat keine Steifigkeit k, die man ändern könnte.</translation>
    </message>
    <message>
        <source>There is no map here: no springs act, so every stiffness and every step is stable.</source>
        <translation>Hier gibt es keine Karte: Es wirkt keine Feder, also ist jede Steifigkeit und jeder Zeitschritt stabil.</translation>
    </message>
    <message>
        <source>There is no map for this method: it is stable at every stiffness.</source>
        <translation>Für dieses Verfahren gibt es keine Karte: Es ist bei jeder Steifigkeit stabil.</translation>
    </message>
    <message>
        <source>There is no map for your code: it may compute anything, whatever the stiffness is.</source>
        <translation>Für deinen Code gibt es keine Karte: Er kann alles Mögliche berechnen, wie groß die Steifigkeit auch ist.</translation>
    </message>
    <message>
        <source>Time to rest</source>
        <translation>Zeit bis Ruhe</translation>
    </message>
    <message>
        <source>Shows how many frames the run takes to come to rest, for each stiffness and damping. Click again to close</source>
        <translation>Zeigt, nach wie vielen Bildern der Lauf in Ruhe ist, für jede Steifigkeit und jede Dämpfung. Noch ein Klick schließt die Karte</translation>
    </message>
    <message>
        <source>There is no map of the time to rest for this step: it needs the stiffness k, a damping, and at most %1 points.</source>
        <translation>Für diesen Schritt gibt es keine Karte der Zeit bis zur Ruhe: Dafür braucht er die Steifigkeit k, eine Dämpfung und höchstens %1 Punkte.</translation>
    </message>
</context>
<context>
    <name>app::StatusFigures</name>
    <message>
        <source>How many points the scene has: each body, foot or joint is one</source>
        <translation>Wie viele Punkte die Szene hat: Jeder Körper, jeder Fuß und jedes Gelenk ist einer</translation>
    </message>
    <message>
        <source>How often a frame computes all forces. The cost of a frame depends on this</source>
        <translation>Wie oft ein Bild alle Kräfte berechnet. Davon hängt ab, was ein Bild kostet</translation>
    </message>
    <message>
        <source>The time to compute a frame of this scene on this machine (the median of many runs)</source>
        <translation>Die Zeit, die dieser Rechner für ein Bild dieser Szene braucht (Median vieler Läufe)</translation>
    </message>
    <message>
        <source>The largest distance of any body from the exact motion, over these frames</source>
        <translation>Der größte Abstand eines Körpers von der exakten Bewegung, in diesen Bildern</translation>
    </message>
    <message>
        <source>%1 a frame</source>
        <translation>%1 pro Bild</translation>
    </message>
    <message>
        <source>error %1 over %2 frames</source>
        <translation>Fehler %1 in %2 Bildern</translation>
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
        <source>forces %1 times a frame so far</source>
        <translation>Kräfte bisher %1-mal/Bild</translation>
    </message>
</context>
<context>
    <name>app::StatusLine</name>
    <message>
        <source>Preview inside frame %1. The run does not move.</source>
        <translation>Vorschau in Bild %1 hinein. Der Lauf bleibt, wo er ist.</translation>
    </message>
    <message>
        <source>Preview of frame %1. The run stays at frame %2.</source>
        <translation>Vorschau von Bild %1. Der Lauf bleibt bei Bild %2.</translation>
    </message>
    <message>
        <source>Everything is at rest. Touch something, or press &lt;b&gt;%1&lt;/b&gt; to stop.</source>
        <translation>Alles ruht. Fass etwas an. &lt;b&gt;%1&lt;/b&gt; hält an.</translation>
    </message>
    <message>
        <source>Playing. Press &lt;b&gt;%1&lt;/b&gt; to stop anywhere.</source>
        <translation>Läuft. &lt;b&gt;%1&lt;/b&gt; hält an.</translation>
    </message>
    <message>
        <source>Inside frame %1, after %2. &lt;b&gt;%3&lt;/b&gt; next phase, &lt;b&gt;%4&lt;/b&gt; next frame.</source>
        <translation>Innerhalb von Bild %1, nach „%2“. &lt;b&gt;%3&lt;/b&gt; nächste Phase, &lt;b&gt;%4&lt;/b&gt; nächstes Bild.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; plays, &lt;b&gt;%2&lt;/b&gt; next frame, &lt;b&gt;%3&lt;/b&gt; into the frame. Drag anything.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt; spielt ab, &lt;b&gt;%2&lt;/b&gt; nächstes Bild, &lt;b&gt;%3&lt;/b&gt; ins Bild. Zieh an etwas.</translation>
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
        <source>From 1e-13 to 100 px; press Enter to apply</source>
        <translation>Von 1e-13 bis 100 px; Eingabe übernimmt</translation>
    </message>
    <message>
        <source>A whole number of frames, or 1 divided by a whole number; press Enter to apply</source>
        <translation>Eine ganze Zahl von Bildern oder 1 geteilt durch eine ganze Zahl; Eingabe übernimmt</translation>
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
    <name>app::StudyPlot</name>
    <message>
        <source>Points: %1. The arrow keys go through them, and Enter uses one.</source>
        <translation>Punkte: %1. Die Pfeiltasten gehen sie durch, Eingabe verwendet einen.</translation>
    </message>
    <message>
        <source>← more accurate</source>
        <translation>← genauer</translation>
    </message>
    <message>
        <source>largest error, px</source>
        <translation>größter Fehler, px</translation>
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
        <source>Restore the ticks</source>
        <translation>Häkchen zurückholen</translation>
    </message>
    <message>
        <source>Restart this lesson</source>
        <translation>Lektion neu beginnen</translation>
    </message>
    <message>
        <source>Ticks everything again that you had done before</source>
        <translation>Hakt alles wieder ab, was du schon geschafft hattest</translation>
    </message>
    <message>
        <source>Removes the ticks of this lesson. You can restore them.</source>
        <translation>Entfernt die Häkchen dieser Lektion. Du kannst sie wiederherstellen.</translation>
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
    <message>
        <source>%1 of %2 tasks written in the listing.</source>
        <translation>%1 von %2 Aufgaben im Listing geschrieben.</translation>
    </message>
    <message>
        <source>Still to write: %1</source>
        <translation>Noch zu schreiben: %1</translation>
    </message>
    <message>
        <source>Predicted: %1 %2</source>
        <translation>Vorhergesagt: %1 %2</translation>
    </message>
    <message>
        <source>%1 of %2 levels of the project passed.</source>
        <translation>%1 von %2 Stufen des Projekts geschafft.</translation>
    </message>
    <message>
        <source>**Project: %1**</source>
        <translation>**Projekt: %1**</translation>
    </message>
    <message>
        <source>Still to pass: %1</source>
        <translation>Noch zu schaffen: %1</translation>
    </message>
</context>
<context>
    <name>app::TaskBox</name>
    <message>
        <source>Write it yourself</source>
        <translation>Schreib es selbst</translation>
    </message>
    <message>
        <source>Empties the place in the listing, so that you can write it</source>
        <translation>Leert die Stelle im Listing, damit du sie schreiben kannst</translation>
    </message>
    <message>
        <source>Shows the next hint</source>
        <translation>Zeigt den nächsten Tipp</translation>
    </message>
    <message>
        <source>Solution</source>
        <translation>Lösung</translation>
    </message>
    <message>
        <source>Writes the solution into the listing</source>
        <translation>Schreibt die Lösung in das Listing</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Stops this task. Your code stays.</source>
        <translation>Beendet diese Aufgabe. Dein Code bleibt.</translation>
    </message>
    <message>
        <source>%1, done</source>
        <translation>%1, erledigt</translation>
    </message>
    <message>
        <source>Write it again</source>
        <translation>Schreib es noch einmal</translation>
    </message>
    <message>
        <source>Hint %1 of %2</source>
        <translation>Tipp %1 von %2</translation>
    </message>
</context>
<context>
    <name>app::TaskDesk</name>
    <message>
        <source>This is the solution. To get the tick, start again and write it yourself.</source>
        <translation>Das ist die Lösung. Für den Haken beginne noch einmal und schreib es selbst.</translation>
    </message>
    <message>
        <source>Trying your code …</source>
        <translation>Dein Code wird ausprobiert …</translation>
    </message>
</context>
<context>
    <name>app::TimelineStrip</name>
    <message>
        <source>%1: phase %2 of %3. Click to run to it.</source>
        <translation>%1: Phase %2 von %3. Ein Klick läuft bis dorthin.</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Zeitleiste</translation>
    </message>
    <message>
        <source>%1 other runs branch off from this one at frame %2. Click to choose one.</source>
        <translation>%1 andere Läufe zweigen bei Bild %2 von diesem ab. Ein Klick, um einen zu wählen.</translation>
    </message>
    <message>
        <source>Another run: %1. Click to show it beside this one, right-click for more.</source>
        <translation>Ein anderer Lauf: %1. Ein Klick zeigt ihn neben diesem, ein Rechtsklick mehr.</translation>
    </message>
    <message>
        <source>Beside this run: %1. Right-click for more.</source>
        <translation>Neben diesem Lauf: %1. Ein Rechtsklick zeigt mehr.</translation>
    </message>
    <message>
        <source>Left and Right: one frame. With Shift: one phase. Home: restart. With Shift: repeat the run. End: the last computed frame. Menu: the other runs.</source>
        <translation>Links und Rechts: ein Bild. Mit Umschalt: eine Phase. Pos1: neu starten. Mit Umschalt: den Lauf wiederholen. Ende: das letzte berechnete Bild. Menü: die anderen Läufe.</translation>
    </message>
    <message>
        <source>%1. Preview: %2</source>
        <translation>%1. Vorschau: %2</translation>
    </message>
    <message>
        <source>Line %1, %2 of %3: %4
Click to run to it.</source>
        <translation>Zeile %1, %2 von %3: %4
Klicken, um bis dorthin zu laufen.</translation>
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
        <source>The previous card</source>
        <translation>Die vorige Karte</translation>
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
    <message>
        <source>The picture</source>
        <translation>Die Szene</translation>
    </message>
    <message>
        <source>This is the scene of the lesson. Drag anything in it. Let go while moving to throw it.</source>
        <translation>Das ist die Szene der Lektion. Zieh an etwas darin. Lass in Bewegung los, um es zu werfen.</translation>
    </message>
    <message>
        <source>Play and stop</source>
        <translation>Abspielen und anhalten</translation>
    </message>
    <message>
        <source>**%1** plays and stops the run. **%2** goes one frame forward, **%3** one frame back.</source>
        <translation>**%1** spielt den Lauf ab und hält ihn an. **%2** geht ein Bild weiter, **%3** ein Bild zurück.</translation>
    </message>
    <message>
        <source>The whole run is kept</source>
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
        <source>**%1** runs one line of the code, and **%2** takes it back. On the code&apos;s page **Engine** they go from phase to phase: springs pull, damping slows things down, things move.</source>
        <translation>**%1** führt eine Zeile des Codes aus, und **%2** nimmt sie zurück. Auf der Seite **Engine** des Codes gehen sie von Phase zu Phase: Federn ziehen, die Dämpfung bremst, alles bewegt sich.</translation>
    </message>
    <message>
        <source>The code that runs</source>
        <translation>Der Code, der läuft</translation>
    </message>
    <message>
        <source>Numbers to change</source>
        <translation>Zahlen zum Ändern</translation>
    </message>
    <message>
        <source>Move a slider, or type any number. The arrow beside it resets the number.</source>
        <translation>Bewege einen Schieber, oder tippe irgendeine Zahl. Der Pfeil daneben setzt sie zurück.</translation>
    </message>
    <message>
        <source>Try this</source>
        <translation>Probier es aus</translation>
    </message>
    <message>
        <source>Springstep ticks each task when it sees you do it. Click a lamp for a hint, or a dotted word for its meaning.</source>
        <translation>Springstep hakt jede Aufgabe ab, wenn es sieht, dass du sie erledigst. Klick auf eine Lampe für einen Tipp oder auf ein gepunktetes Wort für seine Bedeutung.</translation>
    </message>
    <message>
        <source>These lines compute the scene. Beside them are the current values. Change a line, and the picture follows.</source>
        <translation>Diese Zeilen berechnen die Szene. Daneben stehen die aktuellen Werte. Ändere eine Zeile, und das Bild folgt.</translation>
    </message>
</context>
<context>
    <name>app::TransportBar</name>
    <message>
        <source>going to %1… %2 stops</source>
        <translation>geht zu %1 … %2 hält an</translation>
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
        <source>· at %1</source>
        <translation>· bei %1</translation>
    </message>
    <message>
        <source>Playing speed (%1 and %2). It never changes the step</source>
        <translation>Abspieltempo (%1 und %2). Den Zeitschritt ändert es nie</translation>
    </message>
    <message>
        <source>· preview: %1</source>
        <translation>· Vorschau: %1</translation>
    </message>
    <message>
        <source>· preview of frame %1</source>
        <translation>· Vorschau auf Bild %1</translation>
    </message>
</context>
<context>
    <name>app::TryBox</name>
    <message>
        <source>Hint: %1</source>
        <translation>Tipp: %1</translation>
    </message>
    <message>
        <source>Hide the hint</source>
        <translation>Den Tipp verbergen</translation>
    </message>
    <message>
        <source>Show a hint (H)</source>
        <translation>Einen Tipp zeigen (H)</translation>
    </message>
    <message>
        <source>Hide the answer</source>
        <translation>Antwort verbergen</translation>
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
    <name>app::UserInput</name>
    <message>
        <source>your hand</source>
        <translation>deine Hand</translation>
    </message>
    <message>
        <source>Drag %1</source>
        <translation>%1 ziehen</translation>
    </message>
    <message>
        <source>Move pointer</source>
        <translation>Zeiger bewegen</translation>
    </message>
    <message>
        <source>the pointer</source>
        <translation>der Zeiger</translation>
    </message>
    <message>
        <source>Set target</source>
        <translation>Ziel setzen</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>das Ziel</translation>
    </message>
    <message>
        <source>Press arrow keys</source>
        <translation>Pfeiltasten drücken</translation>
    </message>
    <message>
        <source>the keys</source>
        <translation>die Tasten</translation>
    </message>
</context>
<context>
    <name>app::WebPageDialog</name>
    <message>
        <source>Web page of the run</source>
        <translation>Webseite des Laufs</translation>
    </message>
    <message>
        <source>Progress of the web page</source>
        <translation>Fortschritt der Webseite</translation>
    </message>
    <message>
        <source>One file that plays the run in any browser, also without a network: the scene, the listing with its values, the plots that are open, and the text of the step.</source>
        <translation>Eine Datei, die den Lauf in jedem Browser abspielt, auch ohne Netz: die Szene, das Listing mit seinen Werten, die offenen Diagramme und den Text des Schritts.</translation>
    </message>
    <message>
        <source>The first frame of the page</source>
        <translation>Das erste Bild der Seite</translation>
    </message>
    <message>
        <source>The last frame of the page; the run is computed up to there</source>
        <translation>Das letzte Bild der Seite; der Lauf wird bis dahin berechnet</translation>
    </message>
    <message>
        <source>&amp;Save as…</source>
        <translation>&amp;Speichern unter …</translation>
    </message>
    <message>
        <source>Choose a file, and make the page; you can use the window meanwhile</source>
        <translation>Wähle eine Datei, und die Seite entsteht; das Fenster kannst du derweil benutzen</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Webseiten (*.html)</translation>
    </message>
    <message>
        <source>Cancel the page (Esc)</source>
        <translation>Die Seite abbrechen (Esc)</translation>
    </message>
</context>
<context>
    <name>app::WhyButton</name>
    <message>
        <source>Hide the answer</source>
        <translation>Antwort verbergen</translation>
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
    <name>app::WhyText</name>
    <message>
        <source>Click the line to keep the marks.</source>
        <translation>Klick die Zeile an, damit die Marken bleiben.</translation>
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
        <source>The front: nothing cheaper
is as accurate.</source>
        <translation>Die Bestlinie: Nichts
Billigeres ist so genau.</translation>
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
        <source>forces computed per frame (times follow)</source>
        <translation>berechnete Kräfte pro Bild (Zeiten folgen)</translation>
    </message>
    <message>
        <source>← faster</source>
        <translation>← schneller</translation>
    </message>
    <message>
        <source>A frame is on the screen
for %1&#x2009;µs (30 a second)</source>
        <translation>Ein Bild steht %1&#x2009;µs
auf dem Schirm (30 pro Sekunde)</translation>
    </message>
</context>
<context>
    <name>app::YourLessons</name>
    <message>
        <source>Could not find %1, so it is no longer among your lessons. If you moved it, open it from its new place.</source>
        <translation>%1 war nicht zu finden und steht nicht mehr unter deinen Lektionen. Wenn du sie verschoben hast, öffne sie von dort.</translation>
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
        <source>Done by dragging</source>
        <translation>Durch Ziehen geleistet</translation>
    </message>
    <message>
        <source>Changed with a parameter</source>
        <translation>Durch einen Parameter geändert</translation>
    </message>
    <message>
        <source>Done by clocks and steering</source>
        <translation>Durch Uhr und Steuerung</translation>
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
        <source>Given by fixed places</source>
        <translation>Von festen Orten gegeben</translation>
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
        <source>squeezed into one pixel</source>
        <translation>in einen Pixel gepresst</translation>
    </message>
    <message>
        <source>Twelve feet stand within 1 px of their body, on springs of stiffness one million that are 50 px long. Squeezed like this, they flip over at the slightest touch.</source>
        <translation>Zwölf Füße stehen höchstens 1 px von ihrem Körper entfernt, an Federn der Steifigkeit eine Million, die 50 px lang sind. So zusammengepresst, schlagen sie bei der kleinsten Berührung um.</translation>
    </message>
    <message>
        <source>the pair that runs away</source>
        <translation>das Paar, das davonläuft</translation>
    </message>
    <message>
        <source>A foot and a body pull each other, but one after the other. So the pair drives itself forward, although nothing pushes it.</source>
        <translation>Ein Fuß und ein Körper ziehen einander, aber nacheinander: So treibt sich das Paar selbst an, obwohl nichts es schiebt.</translation>
    </message>
    <message>
        <source>sixty feet</source>
        <translation>sechzig Füße</translation>
    </message>
    <message>
        <source>Each foot has a soft spring, but sixty together pull the body too hard for one step.</source>
        <translation>Jeder Fuß hat eine weiche Feder, aber sechzig zusammen ziehen zu stark am Körper für einen Zeitschritt.</translation>
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
        <source>Body and feet start in the same place, where no spring has a direction.</source>
        <translation>Körper und Füße beginnen am selben Ort, wo keine Feder eine Richtung hat.</translation>
    </message>
    <message>
        <source>all on one line</source>
        <translation>alles auf einer Linie</translation>
    </message>
    <message>
        <source>Body and feet stand on one line, so nothing pulls them off it.</source>
        <translation>Körper und Füße stehen auf einer Linie, also zieht nichts sie davon weg.</translation>
    </message>
    <message>
        <source>springs without a length</source>
        <translation>Federn ohne Länge</translation>
    </message>
    <message>
        <source>Springs of length 0 pull all points to one place, where the springs have no direction.</source>
        <translation>Federn der Länge 0 ziehen alle Punkte an einen Ort, wo die Federn keine Richtung haben.</translation>
    </message>
    <message>
        <source>thrown into a corner</source>
        <translation>in eine Ecke geworfen</translation>
    </message>
    <message>
        <source>A body flies into a corner at a million px a frame. In one step, it would fly through two thousand rooms.</source>
        <translation>Ein Körper fliegt mit einer Million px pro Bild in eine Ecke. In einem Zeitschritt würde er durch zweitausend Räume fliegen.</translation>
    </message>
    <message>
        <source>walls closer than the body</source>
        <translation>Wände enger als der Körper</translation>
    </message>
    <message>
        <source>The body is 30 px wide but the room only 15 px. Wherever the body is, it is inside a wall.</source>
        <translation>Der Körper ist 30 px breit, der Raum aber nur 15 px. Wo der Körper auch ist, er steckt in einer Wand.</translation>
    </message>
    <message>
        <source>a million times the gravity</source>
        <translation>das Millionenfache der Schwerkraft</translation>
    </message>
    <message>
        <source>In each frame, gravity makes everything a million px a frame faster, above a floor without bounce.</source>
        <translation>Die Schwerkraft macht alles in jedem Bild um eine Million px pro Bild schneller, über einem Boden ohne Abprall.</translation>
    </message>
    <message>
        <source>grabbed and let go</source>
        <translation>gegriffen und losgelassen</translation>
    </message>
    <message>
        <source>The body is grabbed for one frame and let go.</source>
        <translation>Der Körper wird für ein Bild gegriffen und losgelassen.</translation>
    </message>
    <message>
        <source>torn away</source>
        <translation>weggerissen</translation>
    </message>
    <message>
        <source>The body is dragged a billion px away in one frame and let go.</source>
        <translation>Der Körper wird in einem Bild eine Milliarde px weit weggezogen und losgelassen.</translation>
    </message>
    <message>
        <source>torn away on stiff springs</source>
        <translation>an steifen Federn weggerissen</translation>
    </message>
    <message>
        <source>The same, with springs of stiffness one million.</source>
        <translation>Dasselbe, mit Federn der Steifigkeit eine Million.</translation>
    </message>
    <message>
        <source>legs that flip</source>
        <translation>Beine, die umschlagen</translation>
    </message>
    <message>
        <source>The gait turns by half a circle in each frame, so the steps see only two of its positions.</source>
        <translation>Der Gang dreht sich in jedem Bild um einen halben Kreis, darum sehen die Zeitschritte nur zwei seiner Stellungen.</translation>
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
        <source>a drag to nowhere</source>
        <translation>ein Ziehen ins Nirgendwo</translation>
    </message>
    <message>
        <source>The body is dragged to a position that is not a number.</source>
        <translation>Der Körper wird an einen Ort gezogen, der keine Zahl ist.</translation>
    </message>
    <message>
        <source>a pointer infinitely far away</source>
        <translation>ein unendlich ferner Zeiger</translation>
    </message>
    <message>
        <source>The pointer moves to a position that is infinitely far away.</source>
        <translation>Der Zeiger geht an einen Ort, der unendlich weit weg ist.</translation>
    </message>
    <message>
        <source>an infinite stiffness</source>
        <translation>eine unendliche Steifigkeit</translation>
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
        <source>In the middle of the run, the stiffness jumps from 0.2 to one million.</source>
        <translation>Mitten im Lauf springt die Steifigkeit von 0,2 auf eine Million.</translation>
    </message>
    <message>
        <source>just below the limit</source>
        <translation>knapp unter der Grenze</translation>
    </message>
    <message>
        <source>With one step a frame, the limit is a stiffness of 4. This spring has 3.99.</source>
        <translation>Bei einem Zeitschritt pro Bild ist die Grenze die Steifigkeit 4. Diese Feder hat 3,99.</translation>
    </message>
    <message>
        <source>at the limit</source>
        <translation>an der Grenze</translation>
    </message>
    <message>
        <source>At stiffness 4, each step takes the foot to the other side at full speed, so it swings farther each time.</source>
        <translation>Bei Steifigkeit 4 bringt jeder Zeitschritt den Fuß mit vollem Tempo auf die andere Seite, darum schwingt er jedes Mal weiter.</translation>
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
        <source>A spring of stiffness one billion behaves almost like a stick.</source>
        <translation>Eine Feder der Steifigkeit eine Milliarde verhält sich fast wie ein Stab.</translation>
    </message>
    <message>
        <source>nearly rigid, without damping</source>
        <translation>fast starr, ohne Dämpfung</translation>
    </message>
    <message>
        <source>The same without damping: it may swing for ever, but no farther than at the start.</source>
        <translation>Dasselbe ohne Dämpfung: Sie darf ewig schwingen, aber nicht weiter als am Anfang.</translation>
    </message>
    <message>
        <source>damping that stops everything</source>
        <translation>Dämpfung, die alles anhält</translation>
    </message>
    <message>
        <source>With damping 0, no velocity is left, so nothing may move.</source>
        <translation>Mit Dämpfung 0 bleibt keine Geschwindigkeit übrig, also darf sich nichts bewegen.</translation>
    </message>
    <message>
        <source>no damping</source>
        <translation>keine Dämpfung</translation>
    </message>
    <message>
        <source>With damping 1, nothing is lost: the foot swings for ever, but never farther.</source>
        <translation>Mit Dämpfung 1 geht nichts verloren: Der Fuß schwingt ewig, aber nie weiter.</translation>
    </message>
    <message>
        <source>almost no velocity left</source>
        <translation>fast keine Geschwindigkeit übrig</translation>
    </message>
    <message>
        <source>A damping of 1e-300 leaves velocities that are almost too small to be stored.</source>
        <translation>Eine Dämpfung von 1e-300 lässt Geschwindigkeiten übrig, die fast zu klein zum Speichern sind.</translation>
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
        <source>The spring is stiff enough to move the heavy body, and therefore a hundred million times too stiff for the light one.</source>
        <translation>Die Feder ist steif genug, den schweren Körper zu bewegen, und darum für den leichten hundert Millionen Mal zu steif.</translation>
    </message>
    <message>
        <source>sticks that contradict each other</source>
        <translation>Stäbe, die sich widersprechen</translation>
    </message>
    <message>
        <source>Three sticks of lengths 1, 1 and 10 cannot form a triangle. Wherever the points move, at least one length is wrong.</source>
        <translation>Drei Stäbe der Längen 1, 1 und 10 können kein Dreieck bilden. Wohin sich die Punkte auch bewegen, mindestens eine Länge ist falsch.</translation>
    </message>
    <message>
        <source>a chain that is too short</source>
        <translation>eine zu kurze Kette</translation>
    </message>
    <message>
        <source>A chain of a thousand links between two nails is a tenth too short, so its links cannot keep their lengths.</source>
        <translation>Eine Kette aus tausend Gliedern zwischen zwei Nägeln ist um ein Zehntel zu kurz, darum können ihre Glieder ihre Länge nicht halten.</translation>
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
        <source>The same chain and the same work, but with 20 steps of one pass each instead of 20 passes a frame. The errors of its links are a ninth as large.</source>
        <translation>Dieselbe Kette und dieselbe Arbeit, aber mit 20 Zeitschritten zu je einem Durchgang statt 20 Durchgängen pro Bild. Die Fehler ihrer Glieder sind ein Neuntel so groß.</translation>
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
        <source>A stick between two fixed points is too short, and neither point can move.</source>
        <translation>Ein Stab zwischen zwei festen Punkten ist zu kurz, und keiner der Punkte kann sich bewegen.</translation>
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
        <source>Lead and tail start in the same place, on a soft stick that has no direction there.</source>
        <translation>Spitze und Schwanz beginnen am selben Ort, an einem weichen Stab, der dort keine Richtung hat.</translation>
    </message>
    <message>
        <source>a target beyond the horizon</source>
        <translation>ein Ziel hinter dem Horizont</translation>
    </message>
    <message>
        <source>The target is a billion px away, and the motor pulls harder the farther away it is.</source>
        <translation>Das Ziel ist eine Milliarde px weit weg, und der Motor zieht umso stärker, je weiter es weg ist.</translation>
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
        <source>A foot swings without damping for ten million frames, almost four days of playing. Its errors must not add up.</source>
        <translation>Ein Fuß schwingt ohne Dämpfung zehn Millionen Bilder lang, fast vier Tage Spielzeit. Seine Fehler dürfen sich nicht summieren.</translation>
    </message>
    <message>
        <source>a million frames at rest</source>
        <translation>eine Million Bilder in Ruhe</translation>
    </message>
    <message>
        <source>At rest, bodies still have velocities that are almost too small to be stored, but they must not move.</source>
        <translation>In Ruhe haben Körper noch Geschwindigkeiten, die fast zu klein zum Speichern sind, aber sie dürfen sich nicht bewegen.</translation>
    </message>
    <message>
        <source>a million steps a frame</source>
        <translation>eine Million Zeitschritte pro Bild</translation>
    </message>
    <message>
        <source>Each step is a millionth of a frame, so its small change is almost lost in rounding.</source>
        <translation>Jeder Zeitschritt ist ein millionstel Bild, darum geht seine kleine Änderung fast im Runden verloren.</translation>
    </message>
    <message>
        <source>a third of a frame</source>
        <translation>ein Drittel Bild</translation>
    </message>
    <message>
        <source>Three steps a frame: no binary number is exactly a third.</source>
        <translation>Drei Zeitschritte pro Bild: Keine Binärzahl ist genau ein Drittel.</translation>
    </message>
    <message>
        <source>a hundred frames in a step</source>
        <translation>hundert Bilder in einem Zeitschritt</translation>
    </message>
    <message>
        <source>One step skips seven swings of the spring.</source>
        <translation>Ein Zeitschritt überspringt sieben Schwingungen der Feder.</translation>
    </message>
    <message>
        <source>no distance to divide by</source>
        <translation>kein Abstand, durch den man teilen könnte</translation>
    </message>
    <message>
        <source>The printed formula divides by the distance of the pointer, which can be 0. Then the run must stop with a message.</source>
        <translation>Die gedruckte Formel teilt durch den Abstand des Zeigers, der 0 sein kann. Dann muss der Lauf mit einer Meldung anhalten.</translation>
    </message>
    <message>
        <source>the pointer on the root</source>
        <translation>der Zeiger auf der Wurzel</translation>
    </message>
    <message>
        <source>The trunk turns towards a pointer that is exactly at its root.</source>
        <translation>Der Stamm dreht sich zu einem Zeiger, der genau an seiner Wurzel ist.</translation>
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
        <source>a tree that never ends</source>
        <translation>ein Baum, der nie endet</translation>
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
        <source>The distance to the pointer resists the wind, and here it is 0.</source>
        <translation>Der Abstand zum Zeiger widersteht dem Wind, und hier ist er 0.</translation>
    </message>
    <message>
        <source>branches</source>
        <translation>Zweige</translation>
    </message>
    <message>
        <source>adaptive steps</source>
        <translation>adaptive Zeitschritte</translation>
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
        <source>solve for new positions</source>
        <translation>nach neuen Positionen auflösen</translation>
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
        <source>trial step</source>
        <translation>Probeschritt</translation>
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
        <source>Moves the swimmer back a little before it starts towards a new target, like a cat before it jumps.</source>
        <translation>Schiebt den Schwimmer ein wenig zurück, bevor er zu einem neuen Ziel startet, wie eine Katze vor dem Sprung.</translation>
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
        <source>Advances the angle of the legs a little in each frame: the rhythm of the walk.</source>
        <translation>Dreht den Winkel der Beine in jedem Bild ein wenig weiter: der Takt des Gehens.</translation>
    </message>
    <message>
        <source>Pulls everything down equally.</source>
        <translation>Zieht alles gleich stark nach unten.</translation>
    </message>
    <message>
        <source>Keeps feet from sinking into the ground, and from slipping unless it is icy.</source>
        <translation>Hält Füße davon ab, in den Boden einzusinken und zu rutschen, außer auf Eis.</translation>
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
        <source>Pulls the swimmer to its target, like a spring.</source>
        <translation>Zieht den Schwimmer zu seinem Ziel, wie eine Feder.</translation>
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
        <source>Moves a point to the pointer.</source>
        <translation>Bewegt einen Punkt zum Zeiger.</translation>
    </message>
    <message>
        <source>Pushes bodies apart that come too close, so that creatures do not walk through each other.</source>
        <translation>Schiebt Körper auseinander, die sich zu nahe kommen, damit Figuren nicht durcheinander hindurchgehen.</translation>
    </message>
    <message>
        <source>Keep two points a length apart: they pull when the distance is longer, and push when it is shorter.</source>
        <translation>Hält zwei Punkte eine Länge auseinander: Zieht, wenn der Abstand größer ist, und schiebt, wenn er kleiner ist.</translation>
    </message>
    <message>
        <source>Turns each branch part of the way back to its direction at rest.</source>
        <translation>Dreht jeden Zweig ein Stück zurück zu seiner Richtung in Ruhe.</translation>
    </message>
    <message>
        <source>Keep a point near its distance, but let it lag behind for a while.</source>
        <translation>Hält einen Punkt nahe an seinem Abstand, lässt ihn aber eine Weile nachhängen.</translation>
    </message>
    <message>
        <source>Slows the tail as water does: more across the body than along it.</source>
        <translation>Bremst den Schwanz, wie Wasser es tut: quer zum Körper mehr als längs.</translation>
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
        <source>Bend each joint back: the farther a branch has turned from its direction at rest, the harder.</source>
        <translation>Biegt jedes Gelenk zurück: je weiter sich ein Zweig aus seiner Richtung in Ruhe gedreht hat, desto stärker.</translation>
    </message>
    <message>
        <source>Makes a creature turn round when it meets a wall.</source>
        <translation>Lässt eine Figur umkehren, wenn sie auf eine Wand trifft.</translation>
    </message>
    <message>
        <source>Turns every branch to the pointer while its button is down.</source>
        <translation>Dreht jeden Zweig zum Zeiger, solange dessen Taste gedrückt ist.</translation>
    </message>
    <message>
        <source>Put back points that have gone past a wall or the floor, and reverse their velocity.</source>
        <translation>Setzt Punkte zurück, die über eine Wand oder den Boden hinaus sind, und kehrt ihre Geschwindigkeit um.</translation>
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
        <source>Blows everything sideways, wide bodies more strongly, and can come in gusts.</source>
        <translation>Bläst alles zur Seite, breite Körper stärker, und kann in Böen kommen.</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Keeps everything on one side of a straight line at any angle.</source>
        <translation>Hält alles auf einer Seite einer Geraden in beliebigem Winkel.</translation>
    </message>
    <message>
        <source>Keeps everything between two walls and above a floor, with friction and without bounce.</source>
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
        <source>Grabbed and dragged</source>
        <translation>Gegriffen und gezogen</translation>
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
        <source>Invalid input</source>
        <translation>Ungültige Eingaben</translation>
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
        <source>How much a wall slows things that slide along it. 0: like ice.</source>
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
        <source>The share by which the strength of the wind changes.</source>
        <translation>Der Anteil, um den sich die Stärke des Windes ändert.</translation>
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
        <source>Push points with like charges apart, and pull unlike ones together: the closer they are, the harder.</source>
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
    <message>
        <source>your code</source>
        <translation>dein Code</translation>
    </message>
    <message>
        <source>Your code</source>
        <translation>Dein Code</translation>
    </message>
    <message>
        <source>Done by my rule</source>
        <translation>Von meiner Regel geleistet</translation>
    </message>
    <message>
        <source>my rule</source>
        <translation>meine Regel</translation>
    </message>
    <message>
        <source>Acts on bodies by the rule that you wrote.</source>
        <translation>Wirkt auf Körper nach der Regel, die du geschrieben hast.</translation>
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
