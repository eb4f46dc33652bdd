<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Codeling</name>
    <message>
        <source>motor</source>
        <translation>Motor</translation>
    </message>
    <message>
        <source>Way to the target</source>
        <translation>Weg zum Ziel</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>It grows before a move: that is the anticipation.</source>
        <translation>Vor einer Bewegung wächst er: Das ist das Ausholen.</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Streckung</translation>
    </message>
    <message>
        <source>How long the spine is, as a part of its length at rest.</source>
        <translation>Wie lang das Rückgrat ist, als Anteil seiner Länge in Ruhe.</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>The area of the body, as a part of its area at rest.</source>
        <translation>Die Fläche des Körpers, als Anteil seiner Fläche in Ruhe.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Erhalt</translation>
    </message>
    <message>
        <source>per frame</source>
        <translation>pro Bild</translation>
    </message>
    <message>
        <source>The share of its speed that the lead keeps each frame.</source>
        <translation>Der Anteil ihres Tempos, den die Spitze in jedem Bild behält.</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>How hard the motor pulls: this times the way to the target.</source>
        <translation>Wie stark der Motor zieht: so viel mal der Weg zum Ziel.</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Zeitmaß</translation>
    </message>
    <message>
        <source>How much of its own time passes in a frame: the pull counts dt × dt.</source>
        <translation>Wie viel seiner eigenen Zeit in einem Bild vergeht: Der Zug zählt dt × dt.</translation>
    </message>
    <message>
        <source>Target x</source>
        <translation>Ziel x</translation>
    </message>
    <message>
        <source>How far to the right the first target is.</source>
        <translation>Wie weit rechts das erste Ziel ist.</translation>
    </message>
    <message>
        <source>Target y</source>
        <translation>Ziel y</translation>
    </message>
    <message>
        <source>How far down the first target is.</source>
        <translation>Wie weit unten das erste Ziel ist.</translation>
    </message>
    <message>
        <source>Rest length</source>
        <translation>Ruhelänge</translation>
    </message>
    <message>
        <source>How far the tail is from the lead at rest.</source>
        <translation>Wie weit der Schwanz in Ruhe von der Spitze entfernt ist.</translation>
    </message>
    <message>
        <source>Anticipation</source>
        <translation>Ausholen</translation>
    </message>
    <message>
        <source>How far it backs up before a move, as a part of the way to the target.</source>
        <translation>Wie weit es vor einer Bewegung zurückweicht, als Anteil des Wegs zum Ziel.</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Weich</translation>
    </message>
    <message>
        <source>The part of the spine’s error that goes each frame.</source>
        <translation>Der Teil des Fehlers des Rückgrats, der in jedem Bild verschwindet.</translation>
    </message>
    <message>
        <source>Hard</source>
        <translation>Hart</translation>
    </message>
    <message>
        <source>The same, when the spine is too short or too long.</source>
        <translation>Dasselbe, wenn das Rückgrat zu kurz oder zu lang ist.</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>Längs</translation>
    </message>
    <message>
        <source>The share of the tail’s speed along the spine that it keeps.</source>
        <translation>Der Anteil seines Tempos längs des Rückgrats, den der Schwanz behält.</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>Quer</translation>
    </message>
    <message>
        <source>The share of the tail’s speed across the spine that it keeps.</source>
        <translation>Der Anteil seines Tempos quer zum Rückgrat, den der Schwanz behält.</translation>
    </message>
    <message>
        <source>Shortest length</source>
        <translation>Kleinste Länge</translation>
    </message>
    <message>
        <source>Shorter than this, the spine pushes hard.</source>
        <translation>Ist es kürzer, schiebt das Rückgrat hart.</translation>
    </message>
    <message>
        <source>Longest length</source>
        <translation>Größte Länge</translation>
    </message>
    <message>
        <source>Longer than this, the spine pulls hard.</source>
        <translation>Ist es länger, zieht das Rückgrat hart.</translation>
    </message>
    <message>
        <source>Tentacles</source>
        <translation>Tentakel</translation>
    </message>
    <message>
        <source>How many tentacles it has.</source>
        <translation>Wie viele Tentakel es hat.</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Glieder</translation>
    </message>
    <message>
        <source>How many links each tentacle has.</source>
        <translation>Wie viele Glieder jeder Tentakel hat.</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Wasser</translation>
    </message>
    <message>
        <source>The share of its speed that a tentacle keeps each frame. Less: thicker water.</source>
        <translation>Der Anteil seines Tempos, den ein Tentakel in jedem Bild behält. Weniger: zäheres Wasser.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Breite</translation>
    </message>
    <message>
        <source>How far apart the two sides are.</source>
        <translation>Wie weit die beiden Seiten auseinander sind.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Codeling</source>
        <translation>Codeling</translation>
    </message>
    <message>
        <source>A little swimmer whose whole character comes from springs and constraints.</source>
        <translation>Ein kleiner Schwimmer, dessen ganzer Charakter aus Federn und Zwangsbedingungen kommt.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>Before it goes, the lead backs up. The shift is a push, too.</source>
        <translation>Bevor sie losschwimmt, weicht die Spitze zurück. Die Verschiebung ist auch ein Schubs.</translation>
    </message>
    <message>
        <source>A stick with one side: the tail takes all of the error.</source>
        <translation>Ein einseitiger Stab: Der Schwanz übernimmt den ganzen Fehler.</translation>
    </message>
    <message>
        <source>from the y axis</source>
        <translation>von der y-Achse aus</translation>
    </message>
    <message>
        <source>but your hand does not give way</source>
        <translation>aber deine Hand gibt nicht nach</translation>
    </message>
    <message>
        <source>a spring to the target; dt is the tutorial&apos;s time of a frame</source>
        <translation>eine Feder zum Ziel; dt ist die Dauer eines Bildes im Tutorial</translation>
    </message>
    <message>
        <source>A soft stick takes a part of its error each frame. Past its limits, it takes a larger part.</source>
        <translation>Ein weicher Stab behebt in jedem Bild einen Teil seines Fehlers, jenseits seiner Grenzen mehr.</translation>
    </message>
    <message>
        <source>The tail keeps more of its speed along the spine than across it.</source>
        <translation>Der Schwanz behält längs des Rückgrats mehr von seinem Tempo als quer dazu.</translation>
    </message>
    <message>
        <source>how far it came, also in your hand</source>
        <translation>wie weit er kam, auch in deiner Hand</translation>
    </message>
    <message>
        <source>Gives a stick its length back: the outer end takes all of the error, unless you hold it.</source>
        <translation>Gibt einem Stab seine Länge zurück: Das äußere Ende übernimmt den Fehler, außer du hältst es.</translation>
    </message>
    <message>
        <source>The sides stay in the middle...</source>
        <translation>Die Seiten bleiben in der Mitte …</translation>
    </message>
    <message>
        <source>...and as far apart as the area needs: half as long, twice as wide.</source>
        <translation>… und so weit auseinander, wie die Fläche es braucht: halb so lang, doppelt so breit.</translation>
    </message>
    <message>
        <source>The tentacles go on as they came. Then each link pulls the next one in, outwards.</source>
        <translation>Die Tentakel bewegen sich weiter wie bisher. Dann zieht jedes Glied das nächste heran.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>lead</source>
        <translation>Spitze</translation>
    </message>
    <message>
        <source>tail</source>
        <translation>Schwanz</translation>
    </message>
    <message>
        <source>sides</source>
        <translation>Seiten</translation>
    </message>
    <message>
        <source>tentacles</source>
        <translation>Tentakel</translation>
    </message>
    <message>
        <source>side</source>
        <translation>Seite</translation>
    </message>
    <message>
        <source>tentacle</source>
        <translation>Tentakel</translation>
    </message>
</context>
</TS>
