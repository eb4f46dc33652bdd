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
</TS>
