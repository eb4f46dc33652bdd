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
<context>
    <name>listing</name>
    <message>
        <source>It moves with your hand. Let go, and it keeps this velocity: a throw.</source>
        <translation>Il suit ta main. Lâche-le, et il garde cette vitesse&#xa0;: un lancer.</translation>
    </message>
    <message>
        <source>The body is a handle: it stays where you leave it.</source>
        <translation>Le corps est une poignée&#xa0;: il reste là où tu le laisses.</translation>
    </message>
    <message>
        <source>the nearest place on the ring</source>
        <translation>l’endroit le plus proche sur l’anneau</translation>
    </message>
</context>
</TS>
