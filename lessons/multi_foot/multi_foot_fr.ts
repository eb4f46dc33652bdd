<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>lesson.json</name>
    <message>
        <source>Multi-foot</source>
        <translation>Plusieurs pieds</translation>
    </message>
    <message>
        <source>One body on many feet: pulls add up, and so does stiffness.</source>
        <translation>Un corps sur beaucoup de pieds&#xa0;: les tractions s’additionnent, et la raideur aussi.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>the pull on `me`, towards the nearest place at the distance `radius` from `anchor`</source>
        <translation>la traction sur `me`, vers l’endroit le plus proche à la distance `radius` de `anchor`</translation>
    </message>
    <message>
        <source>The body feels every foot.</source>
        <translation>Le corps ressent chaque pied.</translation>
    </message>
    <message>
        <source>The feet grow at random places before the first frame. From then on nothing is different.</source>
        <translation>Les pieds poussent à des endroits au hasard avant la première image. Ensuite, rien ne change.</translation>
    </message>
    <message>
        <source>Two pulls on one body add up.</source>
        <translation>Deux tractions sur un même corps s’additionnent.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>top</source>
        <translation>haut</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>stone</source>
        <translation>pierre</translation>
    </message>
</context>
</TS>
