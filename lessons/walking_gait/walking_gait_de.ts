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
<context>
    <name>listing</name>
    <message>
        <source>The foot feels the force, and the body feels the opposite.</source>
        <translation>Der Fuß spürt die Kraft, und der Körper spürt die entgegengesetzte.</translation>
    </message>
    <message>
        <source>where the foot belongs</source>
        <translation>wo der Fuß hingehört</translation>
    </message>
    <message>
        <source>The body is a handle: it stays where you leave it.</source>
        <translation>Der Körper ist ein Griff: Er bleibt, wo du ihn lässt.</translation>
    </message>
    <message>
        <source>Each foot has a bone: an angle of its own, in radians.</source>
        <translation>Jeder Fuß hat einen Knochen: einen eigenen Winkel, in Radiant.</translation>
    </message>
    <message>
        <source>to the left of the body</source>
        <translation>links vom Körper</translation>
    </message>
    <message>
        <source>half a turn on</source>
        <translation>eine halbe Drehung weiter</translation>
    </message>
    <message>
        <source>these walls take all speed</source>
        <translation>diese Wände nehmen alle Geschwindigkeit</translation>
    </message>
    <message>
        <source>a spring that never pulls</source>
        <translation>eine Feder, die nie zieht</translation>
    </message>
    <message>
        <source>0: both, 1: one</source>
        <translation>0: von beiden, 1: von einem</translation>
    </message>
    <message>
        <source>A leg bends towards a point above its foot. That point is only drawn: no spring knows of it.</source>
        <translation>Ein Bein biegt sich zu einem Punkt über dem Fuß. Er ist nur gezeichnet: Keine Feder kennt ihn.</translation>
    </message>
    <message>
        <source>where the foot belongs: below the body, by `drop`</source>
        <translation>wo der Fuß hingehört: um `drop` unter dem Körper</translation>
    </message>
    <message>
        <source>The ground holds the feet, and only the feet.</source>
        <translation>Der Boden hält die Füße, und nur die Füße.</translation>
    </message>
    <message>
        <source>without bounce it is 0</source>
        <translation>ohne Abprall ist sie 0</translation>
    </message>
    <message>
        <source>0: full, 1: none</source>
        <translation>0: voll, 1: keine</translation>
    </message>
    <message>
        <source>The legs are drawn after the frame, from the body to each foot. They need no line here.</source>
        <translation>Die Beine werden nach dem Bild vom Körper zu den Füßen gezeichnet. Sie brauchen hier keine Zeile.</translation>
    </message>
    <message>
        <source>The feet share the clock, and each has an angle of its own.</source>
        <translation>Die Füße teilen sich die Uhr, und jeder hat einen eigenen Winkel.</translation>
    </message>
    <message>
        <source>in radians</source>
        <translation>in Radiant</translation>
    </message>
    <message>
        <source>by the pointer, or by the arrow keys</source>
        <translation>mit dem Zeiger oder mit den Pfeiltasten</translation>
    </message>
    <message>
        <source>The place goes round: one clock turns all bones.</source>
        <translation>Der Ort geht im Kreis: Eine Uhr dreht alle Knochen.</translation>
    </message>
    <message>
        <source>the clock, in radians</source>
        <translation>die Uhr, in Radiant</translation>
    </message>
    <message>
        <source>A part that touches a wall turns the clock&apos;s speed, so that it leads away.</source>
        <translation>Ein Teil, der eine Wand berührt, kehrt das Tempo der Uhr um, sodass es von ihr wegführt.</translation>
    </message>
    <message>
        <source>0: turn, 1: walk on</source>
        <translation>0: umkehren, 1: weitergehen</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>load</source>
        <translation>Last</translation>
    </message>
</context>
</TS>
