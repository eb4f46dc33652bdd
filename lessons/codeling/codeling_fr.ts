<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>Codeling</name>
    <message>
        <source>motor</source>
        <translation>moteur</translation>
    </message>
    <message>
        <source>Way to the target</source>
        <translation>Distance à la cible</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>It grows before a move: that is the anticipation.</source>
        <translation>Il grandit avant un déplacement&#xa0;: c’est l’anticipation.</translation>
    </message>
    <message>
        <source>Stretch</source>
        <translation>Étirement</translation>
    </message>
    <message>
        <source>How long the spine is, as a part of its length at rest.</source>
        <translation>Longueur de la colonne vertébrale, en part de sa longueur au repos.</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Aire</translation>
    </message>
    <message>
        <source>The area of the body, as a part of its area at rest.</source>
        <translation>Aire du corps, en part de son aire au repos.</translation>
    </message>
    <message>
        <source>Keep</source>
        <translation>Conservation</translation>
    </message>
    <message>
        <source>per frame</source>
        <translation>par image</translation>
    </message>
    <message>
        <source>The share of its speed that the lead keeps each frame.</source>
        <translation>Part de sa vitesse que le meneur garde à chaque image.</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>How hard the motor pulls: this times the way to the target.</source>
        <translation>Force du moteur&#xa0;: ce nombre fois le chemin jusqu’à la cible.</translation>
    </message>
    <message>
        <source>Time step</source>
        <translation>Échelle de temps</translation>
    </message>
    <message>
        <source>How much of its own time passes in a frame: the pull counts dt × dt.</source>
        <translation>Durée d’une image dans son propre temps&#xa0;: la traction compte dt × dt.</translation>
    </message>
    <message>
        <source>Target x</source>
        <translation>Cible x</translation>
    </message>
    <message>
        <source>How far to the right the first target is.</source>
        <translation>À quelle distance vers la droite se trouve la première cible.</translation>
    </message>
    <message>
        <source>Target y</source>
        <translation>Cible y</translation>
    </message>
    <message>
        <source>How far down the first target is.</source>
        <translation>À quelle distance vers le bas se trouve la première cible.</translation>
    </message>
    <message>
        <source>Rest length</source>
        <translation>Longueur à vide</translation>
    </message>
    <message>
        <source>How far the tail is from the lead at rest.</source>
        <translation>Distance entre la queue et le meneur au repos.</translation>
    </message>
    <message>
        <source>Anticipation</source>
        <translation>Anticipation</translation>
    </message>
    <message>
        <source>How far it backs up before a move, as a part of the way to the target.</source>
        <translation>Recul avant un déplacement, en part du chemin jusqu’à la cible.</translation>
    </message>
    <message>
        <source>Soft</source>
        <translation>Souple</translation>
    </message>
    <message>
        <source>The part of the spine’s error that goes each frame.</source>
        <translation>Part de l’erreur de la colonne vertébrale qui disparaît à chaque image.</translation>
    </message>
    <message>
        <source>Hard</source>
        <translation>Dur</translation>
    </message>
    <message>
        <source>The same, when the spine is too short or too long.</source>
        <translation>La même, quand la colonne vertébrale est trop courte ou trop longue.</translation>
    </message>
    <message>
        <source>Along</source>
        <translation>En long</translation>
    </message>
    <message>
        <source>The share of the tail’s speed along the spine that it keeps.</source>
        <translation>Part que la queue garde de sa vitesse dans la longueur de la colonne vertébrale.</translation>
    </message>
    <message>
        <source>Across</source>
        <translation>En travers</translation>
    </message>
    <message>
        <source>The share of the tail’s speed across the spine that it keeps.</source>
        <translation>Part que la queue garde de sa vitesse en travers de la colonne vertébrale.</translation>
    </message>
    <message>
        <source>Shortest length</source>
        <translation>Longueur min.</translation>
    </message>
    <message>
        <source>Shorter than this, the spine pushes hard.</source>
        <translation>En deçà de cette longueur, la colonne vertébrale pousse fort.</translation>
    </message>
    <message>
        <source>Longest length</source>
        <translation>Longueur max.</translation>
    </message>
    <message>
        <source>Longer than this, the spine pulls hard.</source>
        <translation>Au-delà de cette longueur, la colonne vertébrale tire fort.</translation>
    </message>
    <message>
        <source>Tentacles</source>
        <translation>Tentacules</translation>
    </message>
    <message>
        <source>How many tentacles it has.</source>
        <translation>Nombre de ses tentacules.</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Maillons</translation>
    </message>
    <message>
        <source>How many links each tentacle has.</source>
        <translation>Nombre de maillons de chaque tentacule.</translation>
    </message>
    <message>
        <source>Water</source>
        <translation>Eau</translation>
    </message>
    <message>
        <source>The share of its speed that a tentacle keeps each frame. Less: thicker water.</source>
        <translation>Part de sa vitesse qu’un tentacule garde à chaque image. Moins&#xa0;: une eau plus épaisse.</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>Largeur</translation>
    </message>
    <message>
        <source>How far apart the two sides are.</source>
        <translation>Distance entre les deux côtés.</translation>
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
        <translation>Un petit nageur dont tout le caractère vient de ressorts et de contraintes.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>Before it goes, the lead backs up. The shift is a push, too.</source>
        <translation>Avant de partir, le meneur recule. Ce recul est aussi une poussée.</translation>
    </message>
    <message>
        <source>A stick with one side: the tail takes all of the error.</source>
        <translation>Une tige unilatérale&#xa0;: la queue prend toute l’erreur.</translation>
    </message>
    <message>
        <source>from the y axis</source>
        <translation>depuis l’axe des y</translation>
    </message>
    <message>
        <source>but your hand does not give way</source>
        <translation>mais ta main ne cède pas</translation>
    </message>
    <message>
        <source>a spring to the target; dt is the tutorial&apos;s time of a frame</source>
        <translation>un ressort vers la cible&#x202f;; dt est la durée d’une image dans le tutoriel</translation>
    </message>
    <message>
        <source>A soft stick takes a part of its error each frame. Past its limits, it takes a larger part.</source>
        <translation>Une tige souple corrige une part de son erreur à chaque image, et davantage hors de ses limites.</translation>
    </message>
    <message>
        <source>The tail keeps more of its speed along the spine than across it.</source>
        <translation>La queue garde plus de vitesse le long de la colonne vertébrale qu’en travers.</translation>
    </message>
    <message>
        <source>how far it came, also in your hand</source>
        <translation>le chemin parcouru, aussi dans ta main</translation>
    </message>
    <message>
        <source>Gives a stick its length back: the outer end takes all of the error, unless you hold it.</source>
        <translation>Rend sa longueur à une tige&#xa0;: le bout extérieur prend toute l’erreur, sauf si tu le tiens.</translation>
    </message>
    <message>
        <source>The sides stay in the middle...</source>
        <translation>Les côtés restent au milieu…</translation>
    </message>
    <message>
        <source>...and as far apart as the area needs: half as long, twice as wide.</source>
        <translation>… et aussi écartés que l’aire le demande&#xa0;: deux fois plus court, deux fois plus large.</translation>
    </message>
    <message>
        <source>The tentacles go on as they came. Then each link pulls the next one in, outwards.</source>
        <translation>Les tentacules continuent comme avant. Puis chaque maillon attire le suivant, vers le bout.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>lead</source>
        <translation>meneur</translation>
    </message>
    <message>
        <source>tail</source>
        <translation>queue</translation>
    </message>
    <message>
        <source>sides</source>
        <translation>côtés</translation>
    </message>
    <message>
        <source>tentacles</source>
        <translation>tentacules</translation>
    </message>
    <message>
        <source>side</source>
        <translation>côté</translation>
    </message>
    <message>
        <source>tentacle</source>
        <translation>tentacule</translation>
    </message>
</context>
</TS>
