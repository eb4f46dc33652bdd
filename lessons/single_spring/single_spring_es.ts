<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>SingleSpring</name>
    <message>
        <source>pull, not acting yet</source>
        <translation>tirón, aún no actúa</translation>
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
        <translation>Un solo muelle</translation>
    </message>
    <message>
        <source>One foot on one spring: pull, let go, and see why it swings and settles.</source>
        <translation>Un pie en un muelle: tira, suelta y mira por qué oscila y se estabiliza.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>It moves with your hand. Let go, and it keeps this velocity: a throw.</source>
        <translation>Se mueve con tu mano. Si lo sueltas, conserva esta velocidad: un lanzamiento.</translation>
    </message>
    <message>
        <source>The body is a handle: it stays where you leave it.</source>
        <translation>El cuerpo es un asa: se queda donde lo dejas.</translation>
    </message>
    <message>
        <source>the nearest place on the ring</source>
        <translation>el lugar más cercano del anillo</translation>
    </message>
</context>
</TS>
