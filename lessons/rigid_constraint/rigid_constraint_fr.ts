<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>RigidConstraint</name>
    <message>
        <source>Largest error</source>
        <translation>Plus grande erreur</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>How far the length of the worst stick is from what it should be.</source>
        <translation>Écart entre la longueur de la pire tige et celle qu’elle devrait avoir.</translation>
    </message>
    <message>
        <source>Largest stretch</source>
        <translation>Plus grand étirement</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>How far the worst stick is from its length, as a part of that length.</source>
        <translation>Écart de la pire tige à sa longueur, en part de cette longueur.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>How far apart a stick keeps its two ends.</source>
        <translation>Distance qu’une tige garde entre ses deux extrémités.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Part</translation>
    </message>
    <message>
        <source>The part of the error that p0 takes; p1 takes the rest.</source>
        <translation>Part de l’erreur que prend p0&#x202f;; p1 prend le reste.</translation>
    </message>
    <message>
        <source>Triangles</source>
        <translation>Triangles</translation>
    </message>
    <message>
        <source>How many triangles the figure has.</source>
        <translation>Nombre de triangles de la figure.</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Itérations</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>passes</translation>
    </message>
    <message>
        <source>How often each frame goes through the list of sticks.</source>
        <translation>Combien de fois chaque image parcourt la liste des tiges.</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <source>How much a wall’s push holds back what slides along it. 0: like ice.</source>
        <translation>À quel point un mur retient ce qui glisse le long de lui. 0&#xa0;: comme de la glace.</translation>
    </message>
    <message>
        <source>Joints</source>
        <translation>Articulations</translation>
    </message>
    <message>
        <source>Whether arms and legs bend only as far as joints do, or all the way round.</source>
        <translation>Bras et jambes plient seulement autant que des articulations, ou font le tour complet.</translation>
    </message>
    <message>
        <source>free</source>
        <translation>libres</translation>
    </message>
    <message>
        <source>limited</source>
        <translation>limitées</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Rigid constraints</source>
        <translation>Contraintes rigides</translation>
    </message>
    <message>
        <source>Sticks that keep their length, from one pair to a ragdoll to throw about.</source>
        <translation>Des tiges qui gardent leur longueur, d’une simple paire jusqu’à un pantin à lancer partout.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>Gives a stick its length back: each end takes its share of the error.</source>
        <translation>Rend sa longueur à une tige&#xa0;: chaque bout prend sa part de l’erreur.</translation>
    </message>
    <message>
        <source>your hand does not give way</source>
        <translation>ta main ne cède pas</translation>
    </message>
    <message>
        <source>from the y axis</source>
        <translation>depuis l’axe des y</translation>
    </message>
    <message>
        <source>The pointer carries the first point.</source>
        <translation>Le pointeur porte le premier point.</translation>
    </message>
    <message>
        <source>One stick after the other: each sees what the one before it moved.</source>
        <translation>Une tige après l’autre&#xa0;: chacune voit ce que la précédente a déplacé.</translation>
    </message>
    <message>
        <source>A point keeps going as it came, and falls. In your hand it comes along.</source>
        <translation>Un point continue comme avant, et tombe. Dans ta main, il la suit.</translation>
    </message>
    <message>
        <source>Is the angle from `a` to `b`, clockwise, past a limit? Then each turns back by half of it.</source>
        <translation>L’angle de `a` à `b`, dans le sens horaire, passe une limite&#x202f;? Chacun recule de la moitié.</translation>
    </message>
    <message>
        <source>the middle stays</source>
        <translation>le milieu reste</translation>
    </message>
    <message>
        <source>Gives a stick its length back. An end in your hand does not give way.</source>
        <translation>Rend sa longueur à une tige. Un bout que tu tiens ne cède pas.</translation>
    </message>
    <message>
        <source>Friction holds back what slides along a wall: the deeper in the wall, the more.</source>
        <translation>Le frottement retient ce qui glisse le long d’un mur&#xa0;: plus c’est enfoncé, plus il retient.</translation>
    </message>
    <message>
        <source>the torso, not inside out</source>
        <translation>le torse, sans se retourner</translation>
    </message>
    <message>
        <source>shoulders</source>
        <translation>épaules</translation>
    </message>
    <message>
        <source>elbows</source>
        <translation>coudes</translation>
    </message>
    <message>
        <source>hips</source>
        <translation>hanches</translation>
    </message>
    <message>
        <source>knees</source>
        <translation>genoux</translation>
    </message>
    <message>
        <source>Verlet: the velocity is how far it came, whatever moved it.</source>
        <translation>Verlet&#xa0;: la vitesse est le chemin parcouru, quelle qu’en soit la cause.</translation>
    </message>
    <message>
        <source>Gives a stick its length back: `a` takes its share of the error, `b` takes the rest.</source>
        <translation>Rend sa longueur à une tige&#xa0;: `a` prend sa part de l’erreur, `b` prend le reste.</translation>
    </message>
    <message>
        <source>Each stick makes the ones before it a little wrong again.</source>
        <translation>Chaque tige rend les précédentes de nouveau un peu fausses.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>head</source>
        <translation>tête</translation>
    </message>
</context>
</TS>
