<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>lesson.json</name>
    <message>
        <source>Gravity and walls</source>
        <translation>Gravité et murs</translation>
    </message>
    <message>
        <source>A room to bounce in, and a pull that goes straight down.</source>
        <translation>Une pièce où rebondir, et une traction qui va tout droit vers le bas.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>the pull on `me`, towards the nearest place at the distance `radius` from `anchor`</source>
        <translation>la traction sur `me`, vers l’endroit le plus proche à la distance `radius` de `anchor`</translation>
    </message>
    <message>
        <source>one more pull, the same for all, and before damping</source>
        <translation>encore une traction, la même pour tous, avant l’amortissement</translation>
    </message>
    <message>
        <source>Is an edge past a wall? Put the disc back, and turn its velocity away from the wall.</source>
        <translation>Un bord a dépassé un mur&#x202f;? Remets le disque, et dirige sa vitesse loin du mur.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>ball</source>
        <translation>balle</translation>
    </message>
</context>
</TS>
