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
        <source>Share</source>
        <translation>Anteil</translation>
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
        <source>free</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>limited</source>
        <translation>begrenzt</translation>
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
<context>
    <name>listing</name>
    <message>
        <source>Gives a stick its length back: each end takes its share of the error.</source>
        <translation>Gibt einem Stab seine Länge zurück: Jedes Ende übernimmt seinen Anteil am Fehler.</translation>
    </message>
    <message>
        <source>your hand does not give way</source>
        <translation>deine Hand gibt nicht nach</translation>
    </message>
    <message>
        <source>from the y axis</source>
        <translation>von der y-Achse aus</translation>
    </message>
    <message>
        <source>The pointer carries the first point.</source>
        <translation>Der Zeiger trägt den ersten Punkt.</translation>
    </message>
    <message>
        <source>One stick after the other: each sees what the one before it moved.</source>
        <translation>Ein Stab nach dem anderen: Jeder sieht, was der Stab vor ihm bewegt hat.</translation>
    </message>
    <message>
        <source>A point keeps going as it came, and falls. In your hand it comes along.</source>
        <translation>Ein Punkt bewegt sich weiter wie bisher und fällt. In deiner Hand geht er mit.</translation>
    </message>
    <message>
        <source>Is the angle from `a` to `b`, clockwise, past a limit? Then each turns back by half of it.</source>
        <translation>Verlässt der Winkel von `a` nach `b`, im Uhrzeigersinn, seine Grenzen? Beide drehen halb zurück.</translation>
    </message>
    <message>
        <source>the middle stays</source>
        <translation>die Mitte bleibt</translation>
    </message>
    <message>
        <source>Gives a stick its length back. An end in your hand does not give way.</source>
        <translation>Gibt einem Stab seine Länge zurück. Ein Ende in deiner Hand gibt nicht nach.</translation>
    </message>
    <message>
        <source>Friction holds back what slides along a wall: the deeper in the wall, the more.</source>
        <translation>Reibung bremst, was an einer Wand entlangrutscht: je tiefer in der Wand, desto mehr.</translation>
    </message>
    <message>
        <source>the torso, not inside out</source>
        <translation>der Rumpf, nicht umgestülpt</translation>
    </message>
    <message>
        <source>shoulders</source>
        <translation>Schultern</translation>
    </message>
    <message>
        <source>elbows</source>
        <translation>Ellbogen</translation>
    </message>
    <message>
        <source>hips</source>
        <translation>Hüften</translation>
    </message>
    <message>
        <source>knees</source>
        <translation>Knie</translation>
    </message>
    <message>
        <source>Verlet: the velocity is how far it came, whatever moved it.</source>
        <translation>Verlet: Die Geschwindigkeit ist, wie weit er kam, egal was ihn bewegt hat.</translation>
    </message>
    <message>
        <source>Gives a stick its length back: `a` takes its share of the error, `b` takes the rest.</source>
        <translation>Gibt einem Stab seine Länge zurück: `a` übernimmt seinen Anteil am Fehler, `b` den Rest.</translation>
    </message>
    <message>
        <source>Each stick makes the ones before it a little wrong again.</source>
        <translation>Jeder Stab macht die vor ihm wieder ein wenig falsch.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>head</source>
        <translation>Kopf</translation>
    </message>
</context>
</TS>
