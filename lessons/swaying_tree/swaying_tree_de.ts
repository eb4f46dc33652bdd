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
        <source>How hard a joint turns its branch back: for a lone trunk, this share of its bend each frame.</source>
        <translation>Wie stark ein Gelenk seinen Zweig zurückdreht: für einen Stamm allein dieser Anteil seiner Biegung, in jedem Bild.</translation>
    </message>
    <message>
        <source>The share of its spin that every branch keeps each frame. 1 keeps it all.</source>
        <translation>Der Anteil seiner Drehung, den jeder Zweig in jedem Bild behält. 1 behält alles.</translation>
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
<context>
    <name>listing</name>
    <message>
        <source>Two smaller branches grow at the end of this one, and each of them does the same.</source>
        <translation>Am Ende dieses Zweigs wachsen zwei kleinere, und jeder von ihnen macht dasselbe.</translation>
    </message>
    <message>
        <source>a rule that uses itself needs an end</source>
        <translation>eine Regel, die sich selbst benutzt, braucht ein Ende</translation>
    </message>
    <message>
        <source>to a radian; the tutorial rounds</source>
        <translation>pro Radiant; das Tutorial rundet</translation>
    </message>
    <message>
        <source>from where a branch begins to where it ends, if it is as large as the trunk</source>
        <translation>vom Anfang eines Zweigs zu seinem Ende, wenn er so groß ist wie der Stamm</translation>
    </message>
    <message>
        <source>Where a branch ends, its children begin, and so do theirs: a function that calls itself.</source>
        <translation>Am Ende eines Zweigs beginnen seine Kinder, und so fort: eine Funktion, die sich selbst aufruft.</translation>
    </message>
    <message>
        <source>The wind turns a branch away from the pointer, by a part of the missing angle. The tutorial</source>
        <translation>Der Wind dreht einen Zweig vom Zeiger weg, um einen Teil des fehlenden Winkels. Das Tutorial</translation>
    </message>
    <message>
        <source>prints a plus for the minus and 360 for 180, and its branches can turn past the wind.</source>
        <translation>schreibt Plus statt Minus und 360 statt 180, und seine Zweige können zu weit drehen.</translation>
    </message>
    <message>
        <source>far branches resist</source>
        <translation>ferne Zweige widerstehen</translation>
    </message>
    <message>
        <source>the pointer is on its end</source>
        <translation>der Zeiger ist auf seinem Ende</translation>
    </message>
    <message>
        <source>the short way</source>
        <translation>der kurze Weg</translation>
    </message>
    <message>
        <source>never past the wind</source>
        <translation>nie über den Wind hinaus</translation>
    </message>
    <message>
        <source>Back to rest by a part of the missing angle, then away from the wind.</source>
        <translation>Um einen Teil des fehlenden Winkels zurück zur Ruhe, dann weg vom Wind.</translation>
    </message>
    <message>
        <source>by chance, up to jitter to either side; the seed and the branch&apos;s number decide</source>
        <translation>zufällig, bis zu jitter nach jeder Seite; Startwert und Nummer des Zweigs entscheiden</translation>
    </message>
    <message>
        <source>The wind pushes hardest across a branch.</source>
        <translation>Der Wind drückt am stärksten quer zu einem Zweig.</translation>
    </message>
    <message>
        <source>the gust is not here</source>
        <translation>hier ist die Bö nicht</translation>
    </message>
    <message>
        <source>the sine between them</source>
        <translation>der Sinus zwischen ihnen</translation>
    </message>
    <message>
        <source>Each joint is a spring that turns. Returns its torque: the parent feels the opposite one.</source>
        <translation>Jedes Gelenk ist eine Drehfeder. Gibt ihr Drehmoment zurück; der Elternzweig spürt es umgekehrt.</translation>
    </message>
    <message>
        <source>a new gust</source>
        <translation>eine neue Bö</translation>
    </message>
    <message>
        <source>thick ones resist</source>
        <translation>dicke widerstehen</translation>
    </message>
    <message>
        <source>Turns a branch to the pointer.</source>
        <translation>Dreht einen Zweig zum Zeiger.</translation>
    </message>
    <message>
        <source>printed with a plus, in the branch&apos;s own measure</source>
        <translation>gedruckt mit einem Plus, im eigenen Maß des Zweigs</translation>
    </message>
    <message>
        <source>A branch is three things: where it begins, its angle, and its length. Where it ends follows.</source>
        <translation>Ein Zweig ist drei Dinge: sein Anfang, sein Winkel und seine Länge. Daraus folgt sein Ende.</translation>
    </message>
    <message>
        <source>cos and sin take radians: there are 180 / pi degrees in one. The tutorial has 57.3.</source>
        <translation>cos und sin nehmen Radiant: Ein Radiant hat 180 / pi Grad. Das Tutorial nimmt 57,3.</translation>
    </message>
    <message>
        <source>the same for all</source>
        <translation>für alle gleich</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>root</source>
        <translation>Wurzel</translation>
    </message>
</context>
</TS>
