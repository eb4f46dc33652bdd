<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>lesson.json</name>
    <message>
        <source>Two bodies</source>
        <translation>Deux corps</translation>
    </message>
    <message>
        <source>A foot and a body pull each other: whose turn it is makes a difference.</source>
        <translation>Un pied et un corps se tirent l’un l’autre&#xa0;: il importe de savoir à qui c’est le tour.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>The leg is drawn from body to foot after each frame. It needs no line here.</source>
        <translation>La patte est dessinée du corps au pied après chaque image. Pas besoin de ligne ici.</translation>
    </message>
    <message>
        <source>the place at the distance `radius` from `anchor` that is nearest to `me`</source>
        <translation>l’endroit à la distance `radius` de `anchor` qui est le plus proche de `me`</translation>
    </message>
    <message>
        <source>The body sees the foot where it already is.</source>
        <translation>Le corps voit le pied là où il est déjà.</translation>
    </message>
</context>
</TS>
