<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>WalkingGait</name>
    <message>
        <source>Centipede</source>
        <translation>Mille-pattes</translation>
    </message>
    <message>
        <source>Twelve feet, one after the other: the body glides.</source>
        <translation>Douze pieds, l’un après l’autre&#xa0;: le corps glisse.</translation>
    </message>
    <message>
        <source>Trot</source>
        <translation>Trot</translation>
    </message>
    <message>
        <source>Four feet in two pairs: it bobs like one with two feet.</source>
        <translation>Quatre pieds en deux paires&#xa0;: elle sautille comme avec deux pieds.</translation>
    </message>
    <message>
        <source>Limp</source>
        <translation>Boiterie</translation>
    </message>
    <message>
        <source>Three feet close behind each other, then a pause.</source>
        <translation>Trois pieds tout près l’un de l’autre, puis une pause.</translation>
    </message>
    <message>
        <source>Runner</source>
        <translation>Coureur</translation>
    </message>
    <message>
        <source>A fast clock: no foot touches the ground for long.</source>
        <translation>Une horloge rapide&#xa0;: aucun pied ne touche longtemps le sol.</translation>
    </message>
    <message>
        <source>Swing</source>
        <translation>Élan</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>How far foot 0 is from the middle of its places. The leg is what it would be if it followed exactly.</source>
        <translation>Distance du pied 0 au milieu de ses places. S’il suivait exactement, elle vaudrait la patte.</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Quantité de mouvement</translation>
    </message>
    <message>
        <source>px/frame</source>
        <translation>px/image</translation>
    </message>
    <message>
        <source>All velocities added up; how long that arrow is. Every mass is 1.</source>
        <translation>Toutes les vitesses additionnées&#x202f;; longueur de cette flèche. Chaque masse vaut 1.</translation>
    </message>
    <message>
        <source>Walks</source>
        <translation>Marche</translation>
    </message>
    <message>
        <source>How far the body came to the right in the last frame.</source>
        <translation>De combien le corps a avancé vers la droite à la dernière image.</translation>
    </message>
    <message>
        <source>Slip</source>
        <translation>Glissement</translation>
    </message>
    <message>
        <source>How far the standing feet slid in the last frame, on the average.</source>
        <translation>De combien les pieds en appui ont glissé à la dernière image, en moyenne.</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Horloge</translation>
    </message>
    <message>
        <source>rad/frame</source>
        <translation>rad/image</translation>
    </message>
    <message>
        <source>How fast the gait clock turns.</source>
        <translation>Vitesse à laquelle tourne l’horloge d’allure.</translation>
    </message>
    <message>
        <source>Pushes</source>
        <translation>Poussées</translation>
    </message>
    <message>
        <source>px/frame²</source>
        <translation>px/image²</translation>
    </message>
    <message>
        <source>All pushes between bodies added up; how long that arrow is.</source>
        <translation>Toutes les poussées entre corps additionnées&#x202f;; longueur de cette flèche.</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Patte</translation>
    </message>
    <message>
        <source>How far a foot belongs from the middle of its places.</source>
        <translation>À quelle distance du milieu de ses places un pied doit être.</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Abaissement</translation>
    </message>
    <message>
        <source>How far below the body the feet belong.</source>
        <translation>À quelle distance sous le corps les pieds doivent être.</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Courbe</translation>
    </message>
    <message>
        <source>How high above its foot the point lies that bends a leg. Only drawn.</source>
        <translation>Hauteur, au-dessus de son pied, du point qui plie une patte. Seulement dessiné.</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>How far the gait clock turns each frame. Below 0 it turns the other way.</source>
        <translation>De combien l’horloge d’allure tourne à chaque image. Sous 0, elle tourne dans l’autre sens.</translation>
    </message>
    <message>
        <source>The share of its speed that a foot keeps, turned round, on the ground.</source>
        <translation>Part de sa rapidité qu’un pied garde, retournée, au sol.</translation>
    </message>
    <message>
        <source>Traction</source>
        <translation>Adhérence</translation>
    </message>
    <message>
        <source>Whether the ground stops a foot sideways, too. Without it is ice.</source>
        <translation>Le sol arrête aussi un pied sur le côté. Sans elle, c’est de la glace.</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pieds</translation>
    </message>
    <message>
        <source>How many feet the body has.</source>
        <translation>Nombre de pieds du corps.</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Écartement</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Over how much of a turn the feet are spread. At 0 all step together.</source>
        <translation>Sur quelle part d’un tour les pieds sont répartis. À 0, tous se posent ensemble.</translation>
    </message>
    <message>
        <source>Top speed</source>
        <translation>Vitesse max.</translation>
    </message>
    <message>
        <source>The fastest that keys and pointer make the gait clock.</source>
        <translation>La plus grande vitesse que touches et pointeur donnent à l’horloge d’allure.</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>Variation</translation>
    </message>
    <message>
        <source>rad/frame²</source>
        <translation>rad/image²</translation>
    </message>
    <message>
        <source>How much speed an arrow key adds or takes away, each frame that it is down.</source>
        <translation>Vitesse qu’une touche fléchée ajoute ou retire, à chaque image où elle est enfoncée.</translation>
    </message>
    <message>
        <source>At a wall</source>
        <translation>Face à un mur</translation>
    </message>
    <message>
        <source>Whether it turns round where it bumps into a wall, or walks on.</source>
        <translation>Elle fait demi-tour là où elle heurte un mur, ou elle continue.</translation>
    </message>
    <message>
        <source>Creatures</source>
        <translation>Créatures</translation>
    </message>
    <message>
        <source>How many creatures there are.</source>
        <translation>Nombre de créatures.</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Poussée</translation>
    </message>
    <message>
        <source>1/frame²</source>
        <translation>1/image²</translation>
    </message>
    <message>
        <source>How hard two bodies push: this share of the missing distance, each frame.</source>
        <translation>Force de la poussée entre deux corps&#xa0;: cette part de la distance qui manque, à chaque image.</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Two bodies closer than this push each other.</source>
        <translation>Deux corps plus proches que cela se poussent.</translation>
    </message>
    <message>
        <source>Felt by</source>
        <translation>Ressentie par</translation>
    </message>
    <message>
        <source>Whether both bodies feel a push, or only the one that comes first.</source>
        <translation>Une poussée est ressentie par les deux corps, ou seulement par le premier.</translation>
    </message>
    <message>
        <source>foot %1</source>
        <translation>pied %1</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>milieu</translation>
    </message>
    <message>
        <source>full</source>
        <translation>totale</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>faire demi-tour</translation>
    </message>
    <message>
        <source>walk on</source>
        <translation>continuer</translation>
    </message>
    <message>
        <source>both</source>
        <translation>les deux</translation>
    </message>
    <message>
        <source>one</source>
        <translation>un seul</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Walking</source>
        <translation>La marche</translation>
    </message>
    <message>
        <source>Bones, a clock that turns them, and ground: a creature that walks.</source>
        <translation>Des os, une horloge qui les tourne, et un sol&#xa0;: une créature qui marche.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>The foot feels the force, and the body feels the opposite.</source>
        <translation>Le pied ressent la force, et le corps ressent la force opposée.</translation>
    </message>
    <message>
        <source>where the foot belongs</source>
        <translation>la place du pied</translation>
    </message>
    <message>
        <source>The body is a handle: it stays where you leave it.</source>
        <translation>Le corps est une poignée&#xa0;: il reste là où tu le laisses.</translation>
    </message>
    <message>
        <source>Each foot has a bone: an angle of its own, in radians.</source>
        <translation>Chaque pied a un os&#xa0;: un angle bien à lui, en radians.</translation>
    </message>
    <message>
        <source>to the left of the body</source>
        <translation>à gauche du corps</translation>
    </message>
    <message>
        <source>half a turn on</source>
        <translation>un demi-tour plus loin</translation>
    </message>
    <message>
        <source>these walls take all speed</source>
        <translation>ces murs prennent toute la vitesse</translation>
    </message>
    <message>
        <source>a spring that never pulls</source>
        <translation>un ressort qui ne tire jamais</translation>
    </message>
    <message>
        <source>0: both, 1: one</source>
        <translation>0&#xa0;: les deux, 1&#xa0;: un seul</translation>
    </message>
    <message>
        <source>A leg bends towards a point above its foot. That point is only drawn: no spring knows of it.</source>
        <translation>Une patte plie vers un point au-dessus du pied. Il est juste dessiné&#xa0;: aucun ressort ne le voit.</translation>
    </message>
    <message>
        <source>where the foot belongs: below the body, by `drop`</source>
        <translation>la place du pied&#xa0;: sous le corps, à `drop`</translation>
    </message>
    <message>
        <source>The ground holds the feet, and only the feet.</source>
        <translation>Le sol retient les pieds, et seulement les pieds.</translation>
    </message>
    <message>
        <source>without bounce it is 0</source>
        <translation>sans rebond, elle vaut 0</translation>
    </message>
    <message>
        <source>0: full, 1: none</source>
        <translation>0&#xa0;: totale, 1&#xa0;: aucune</translation>
    </message>
    <message>
        <source>The legs are drawn after the frame, from the body to each foot. They need no line here.</source>
        <translation>Les pattes sont dessinées après l’image, du corps à chaque pied. Pas besoin de ligne ici.</translation>
    </message>
    <message>
        <source>The feet share the clock, and each has an angle of its own.</source>
        <translation>Les pieds partagent l’horloge, et chacun a un angle bien à lui.</translation>
    </message>
    <message>
        <source>in radians</source>
        <translation>en radians</translation>
    </message>
    <message>
        <source>by the pointer, or by the arrow keys</source>
        <translation>avec le pointeur ou avec les touches fléchées</translation>
    </message>
    <message>
        <source>The place goes round: one clock turns all bones.</source>
        <translation>L’endroit fait le tour&#xa0;: une seule horloge tourne tous les os.</translation>
    </message>
    <message>
        <source>the clock, in radians</source>
        <translation>l’horloge, en radians</translation>
    </message>
    <message>
        <source>A part that touches a wall turns the clock&apos;s speed, so that it leads away.</source>
        <translation>Une partie qui touche un mur change le sens de l’horloge, pour qu’elle s’en éloigne.</translation>
    </message>
    <message>
        <source>0: turn, 1: walk on</source>
        <translation>0&#xa0;: faire demi-tour, 1&#xa0;: continuer</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>pied</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>load</source>
        <translation>charge</translation>
    </message>
</context>
</TS>
