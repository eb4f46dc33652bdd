<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>SingleSpring</name>
    <message>
        <source>pull, not acting yet</source>
        <translation>Zug, wirkt noch nicht</translation>
    </message>
    <message>
        <source>%1° = %2&#x202f;rad</source>
        <translation>%1° = %2 rad</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Single spring</source>
        <translation>Eine Feder</translation>
    </message>
    <message>
        <source>One foot on one spring: pull, let go, and see why it swings and settles.</source>
        <translation>Ein Fuß an einer Feder: Zieh, lass los und sieh, warum er schwingt und zur Ruhe kommt.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>It moves with your hand. Let go, and it keeps this velocity: a throw.</source>
        <translation>Er geht mit deiner Hand mit. Lass los, und er behält diese Geschwindigkeit: ein Wurf.</translation>
    </message>
    <message>
        <source>The body is a handle: it stays where you leave it.</source>
        <translation>Der Körper ist ein Griff: Er bleibt, wo du ihn lässt.</translation>
    </message>
    <message>
        <source>the nearest place on the ring</source>
        <translation>der nächste Ort auf dem Ring</translation>
    </message>
</context>
</TS>
