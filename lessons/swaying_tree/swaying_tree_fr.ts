<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>SwayingTree</name>
    <message>
        <source>corrected</source>
        <translation>corrigée</translation>
    </message>
    <message>
        <source>published</source>
        <translation>publiée</translation>
    </message>
    <message>
        <source>%1 px off</source>
        <translation>à %1&#x202f;px</translation>
    </message>
    <message>
        <source>front</source>
        <translation>avant</translation>
    </message>
    <message>
        <source>end</source>
        <translation>bout</translation>
    </message>
    <message>
        <source>Part of the tree is below the ground: the rule turns angles, and knows no ground.</source>
        <translation>Une partie de l’arbre est sous le sol&#xa0;: la règle tourne des angles, et ne connaît pas de sol.</translation>
    </message>
    <message>
        <source>Branches</source>
        <translation>Branches</translation>
    </message>
    <message>
        <source>How many branches the tree has.</source>
        <translation>Nombre de branches de l’arbre.</translation>
    </message>
    <message>
        <source>Largest bend</source>
        <translation>Plus grande flexion</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>How far the most bent branch is turned from where it grew.</source>
        <translation>Angle entre la branche la plus fléchie et la direction où elle a poussé.</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Énergie</translation>
    </message>
    <message>
        <source>Of motion and springs together. Without wind and damping it stays.</source>
        <translation>Du mouvement et des ressorts ensemble. Sans vent ni amortissement, elle reste.</translation>
    </message>
    <message>
        <source>In motion</source>
        <translation>En mouvement</translation>
    </message>
    <message>
        <source>The part that is in the turning branches.</source>
        <translation>La part qui est dans les branches qui tournent.</translation>
    </message>
    <message>
        <source>In springs</source>
        <translation>Dans les ressorts</translation>
    </message>
    <message>
        <source>The part that the bent joints hold.</source>
        <translation>La part que retiennent les articulations fléchies.</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Formule</translation>
    </message>
    <message>
        <source>What the tutorial’s text means, or what its code prints.</source>
        <translation>Ce que veut dire le texte du tutoriel, ou ce que fait son code tel qu’il est imprimé.</translation>
    </message>
    <message>
        <source>Trunk length</source>
        <translation>Longueur du tronc</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>How long the trunk is. All branches grow and shrink with it.</source>
        <translation>Longueur du tronc. Toutes les branches grandissent et rapetissent avec lui.</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Écartement</translation>
    </message>
    <message>
        <source>How far a branch leans away from its parent.</source>
        <translation>À quel point une branche s’écarte de sa branche parente.</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Réduction</translation>
    </message>
    <message>
        <source>How large a branch is, as a share of its parent.</source>
        <translation>Taille d’une branche, en part de sa branche parente.</translation>
    </message>
    <message>
        <source>Smallest branch</source>
        <translation>Plus petite branche</translation>
    </message>
    <message>
        <source>Branches must be larger than this share of the trunk.</source>
        <translation>Les branches doivent être plus grandes que cette part du tronc.</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Aléa</translation>
    </message>
    <message>
        <source>How much chance may turn a new branch, to either side.</source>
        <translation>De combien le hasard peut tourner une nouvelle branche, de chaque côté.</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Douceur</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>images</translation>
    </message>
    <message>
        <source>How slowly a branch turns: each frame by the missing angle divided by this.</source>
        <translation>Lenteur d’une branche&#xa0;: à chaque image, elle tourne de l’angle qui manque, divisé par ce nombre.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vent</translation>
    </message>
    <message>
        <source>How hard the wind blows. 0 is a calm.</source>
        <translation>Force du vent. 0&#xa0;: pas de vent.</translation>
    </message>
    <message>
        <source>Turbulence</source>
        <translation>Turbulence</translation>
    </message>
    <message>
        <source>How much chance may turn the wind in each frame, to either side.</source>
        <translation>De combien le hasard peut tourner le vent à chaque image, de chaque côté.</translation>
    </message>
    <message>
        <source>Gust speed</source>
        <translation>Vitesse des rafales</translation>
    </message>
    <message>
        <source>px/frame</source>
        <translation>px/image</translation>
    </message>
    <message>
        <source>How fast a gust runs outwards from the pointer.</source>
        <translation>Vitesse à laquelle une rafale s’éloigne du pointeur.</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Rafales</translation>
    </message>
    <message>
        <source>The share by which the wind swells and ebbs as it runs. 0 is a steady wind.</source>
        <translation>La part dont le vent forcit et faiblit en avançant. 0&#xa0;: un vent régulier.</translation>
    </message>
    <message>
        <source>Poplar</source>
        <translation>Peuplier</translation>
    </message>
    <message>
        <source>A small spread makes a narrow crown that reaches up.</source>
        <translation>Un petit écartement donne une cime étroite qui s’élance vers le haut.</translation>
    </message>
    <message>
        <source>Honeycomb</source>
        <translation>Nid d’abeille</translation>
    </message>
    <message>
        <source>At 60 degrees without jitter, branches meet and draw a net of hexagons.</source>
        <translation>À 60 degrés sans aléa, les branches se rejoignent et dessinent un filet d’hexagones.</translation>
    </message>
    <message>
        <source>City plan</source>
        <translation>Plan de ville</translation>
    </message>
    <message>
        <source>Right angles, each branch 0.71 of its parent: streets that fill a rectangle.</source>
        <translation>Angles droits, chaque branche 0,71 fois sa parente&#xa0;: des rues qui remplissent un rectangle.</translation>
    </message>
    <message>
        <source>Lace</source>
        <translation>Dentelle</translation>
    </message>
    <message>
        <source>Turned by 130 degrees, branches fold back on themselves and fill a triangle.</source>
        <translation>Tournées de 130 degrés, les branches se replient sur elles-mêmes et remplissent un triangle.</translation>
    </message>
    <message>
        <source>Cauliflower</source>
        <translation>Chou-fleur</translation>
    </message>
    <message>
        <source>Short steps and a slow slope: many branches of nearly one size.</source>
        <translation>Branches courtes et réduction lente&#xa0;: beaucoup de branches presque de même taille.</translation>
    </message>
    <message>
        <source>Thicket</source>
        <translation>Fourré</translation>
    </message>
    <message>
        <source>With a jitter of 90 degrees chance has the last word.</source>
        <translation>Avec un aléa de 90 degrés, le hasard a le dernier mot.</translation>
    </message>
    <message>
        <source>How hard a joint turns its branch back: for a lone trunk, this share of its bend each frame.</source>
        <translation>Force avec laquelle une articulation ramène sa branche&#xa0;: pour un tronc seul, cette part de sa flexion à chaque image.</translation>
    </message>
    <message>
        <source>The share of its spin that every branch keeps each frame. 1 keeps it all.</source>
        <translation>Part de sa vitesse angulaire que chaque branche garde à chaque image. 1 garde tout.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Swaying tree</source>
        <translation>Arbre qui se balance</translation>
    </message>
    <message>
        <source>A tree that grows by one rule, bends in your wind, and at last swings by itself.</source>
        <translation>Un arbre qui pousse selon une seule règle, plie dans ton vent, et finit par osciller de lui-même.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>Two smaller branches grow at the end of this one, and each of them does the same.</source>
        <translation>Deux branches plus petites poussent au bout de celle-ci, et chacune fait de même.</translation>
    </message>
    <message>
        <source>a rule that uses itself needs an end</source>
        <translation>une règle qui s’utilise elle-même a besoin d’une fin</translation>
    </message>
    <message>
        <source>to a radian; the tutorial rounds</source>
        <translation>par radian&#x202f;; le tutoriel arrondit</translation>
    </message>
    <message>
        <source>from where a branch begins to where it ends, if it is as large as the trunk</source>
        <translation>du début d’une branche à son bout, si elle est aussi grande que le tronc</translation>
    </message>
    <message>
        <source>Where a branch ends, its children begin, and so do theirs: a function that calls itself.</source>
        <translation>Au bout d’une branche naissent ses enfants, et ainsi de suite&#xa0;: la fonction s’appelle elle-même.</translation>
    </message>
    <message>
        <source>The wind turns a branch away from the pointer, by a part of the missing angle. The tutorial</source>
        <translation>Le vent écarte une branche du pointeur, d’une part de l’angle qui manque. Le tutoriel</translation>
    </message>
    <message>
        <source>prints a plus for the minus and 360 for 180, and its branches can turn past the wind.</source>
        <translation>écrit un plus au lieu du moins et 360 au lieu de 180, et ses branches peuvent dépasser le vent.</translation>
    </message>
    <message>
        <source>far branches resist</source>
        <translation>les branches lointaines résistent</translation>
    </message>
    <message>
        <source>the pointer is on its end</source>
        <translation>le pointeur est sur son bout</translation>
    </message>
    <message>
        <source>the short way</source>
        <translation>le chemin court</translation>
    </message>
    <message>
        <source>never past the wind</source>
        <translation>jamais au-delà du vent</translation>
    </message>
    <message>
        <source>Back to rest by a part of the missing angle, then away from the wind.</source>
        <translation>Retour au repos d’une part de l’angle qui manque, puis à l’écart du vent.</translation>
    </message>
    <message>
        <source>by chance, up to jitter to either side; the seed and the branch&apos;s number decide</source>
        <translation>au hasard, jusqu’à jitter de chaque côté&#x202f;; la graine et le numéro de la branche décident</translation>
    </message>
    <message>
        <source>The wind pushes hardest across a branch.</source>
        <translation>Le vent pousse le plus fort en travers d’une branche.</translation>
    </message>
    <message>
        <source>the gust is not here</source>
        <translation>la rafale n’est pas ici</translation>
    </message>
    <message>
        <source>the sine between them</source>
        <translation>le sinus de l’angle entre elles</translation>
    </message>
    <message>
        <source>Each joint is a spring that turns. Returns its torque: the parent feels the opposite one.</source>
        <translation>Chaque articulation est un ressort de rotation. Renvoie son couple&#xa0;: le parent ressent l’opposé.</translation>
    </message>
    <message>
        <source>a new gust</source>
        <translation>une nouvelle rafale</translation>
    </message>
    <message>
        <source>thick ones resist</source>
        <translation>les épaisses résistent</translation>
    </message>
    <message>
        <source>Turns a branch to the pointer.</source>
        <translation>Tourne une branche vers le pointeur.</translation>
    </message>
    <message>
        <source>printed with a plus, in the branch&apos;s own measure</source>
        <translation>imprimé avec un plus, dans la mesure propre à la branche</translation>
    </message>
    <message>
        <source>A branch is three things: where it begins, its angle, and its length. Where it ends follows.</source>
        <translation>Une branche, c’est trois choses&#xa0;: son début, son angle et sa longueur. Son bout en découle.</translation>
    </message>
    <message>
        <source>cos and sin take radians: there are 180 / pi degrees in one. The tutorial has 57.3.</source>
        <translation>cos et sin prennent des radians&#xa0;: un radian fait 180 / pi degrés. Le tutoriel met 57,3.</translation>
    </message>
    <message>
        <source>the same for all</source>
        <translation>le même pour toutes</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>root</source>
        <translation>racine</translation>
    </message>
</context>
</TS>
