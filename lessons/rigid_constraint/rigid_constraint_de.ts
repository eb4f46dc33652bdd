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
</TS>
