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
        <source>Share of p0</source>
        <translation>Part de p0</translation>
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
</TS>
