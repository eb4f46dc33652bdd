<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>SingleSpring</name>
    <message>
        <source>pull, not acting yet</source>
        <translation>traction, pas encore appliquée</translation>
    </message>
    <message>
        <source>%1° = %2&#x202f;rad</source>
        <translation>%1° = %2&#x202f;rad</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Single spring</source>
        <translation>Un seul ressort</translation>
    </message>
    <message>
        <source>One foot on one spring: pull, let go, and see why it swings and settles.</source>
        <translation>Un pied sur un ressort&#xa0;: tire, lâche, et vois pourquoi il oscille et se stabilise.</translation>
    </message>
</context>
</TS>
