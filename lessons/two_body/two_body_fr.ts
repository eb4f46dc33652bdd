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
</TS>
