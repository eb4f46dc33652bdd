<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>Accuracy</name>
    <message>
        <source>Off by</source>
        <translation>Diferencia</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>How far the point that is worst off is from its exact place.</source>
        <translation>A qué distancia de su posición exacta está el punto más desviado.</translation>
    </message>
    <message>
        <source>Energy drift</source>
        <translation>Deriva de energía</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>How much more energy there is than in the exact motion at this moment.</source>
        <translation>Cuánta más energía hay que en el movimiento exacto en este instante.</translation>
    </message>
    <message>
        <source>Its step</source>
        <translation>Su paso de tiempo</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>fotogramas</translation>
    </message>
    <message>
        <source>How much time the method took at once, the last time.</source>
        <translation>Cuánto tiempo avanzó el método de una vez, la última vez.</translation>
    </message>
    <message>
        <source>Computations</source>
        <translation>Cálculos</translation>
    </message>
    <message>
        <source>a frame</source>
        <translation>por fotograma</translation>
    </message>
    <message>
        <source>How often all forces were computed for this frame: that is the work.</source>
        <translation>Cuántas veces se calcularon todas las fuerzas para este fotograma: ese es el trabajo.</translation>
    </message>
    <message>
        <source>%1&#x2009;px off</source>
        <translation>%1&#x2009;px de diferencia</translation>
    </message>
    <message>
        <source>Creatures</source>
        <translation>Criaturas</translation>
    </message>
    <message>
        <source>How many creatures there are.</source>
        <translation>Cuántas criaturas hay.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Accuracy</source>
        <translation>Precisión</translation>
    </message>
    <message>
        <source>How far off a computed motion is, and what it costs to be nearer.</source>
        <translation>Cuánto se desvía un movimiento calculado y lo que cuesta acercarse más.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>ball</source>
        <translation>bola</translation>
    </message>
</context>
</TS>
