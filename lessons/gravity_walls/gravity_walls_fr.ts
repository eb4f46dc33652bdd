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
</TS>
