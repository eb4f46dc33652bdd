<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>HardCases</name>
    <message>
        <source>its steps are too long for what is so stiff</source>
        <translation>sus pasos de tiempo son demasiado largos para algo tan rígido</translation>
    </message>
    <message>
        <source>its steps are longer than those that the case’s sticks are measured by</source>
        <translation>sus pasos de tiempo son más largos que aquellos con los que se miden las barras del caso</translation>
    </message>
    <message>
        <source>it swings on for longer than the run</source>
        <translation>sigue oscilando más de lo que dura la ejecución</translation>
    </message>
    <message>
        <source>it moves one body after the other</source>
        <translation>mueve los cuerpos uno tras otro</translation>
    </message>
    <message>
        <source>it would need too many steps</source>
        <translation>necesitaría demasiados pasos de tiempo</translation>
    </message>
    <message>
        <source>its errors add up</source>
        <translation>sus errores se acumulan</translation>
    </message>
    <message>
        <source>its errors keep it stirring</source>
        <translation>sus errores no lo dejan en reposo</translation>
    </message>
    <message>
        <source>no place there is free</source>
        <translation>allí no hay ningún lugar libre</translation>
    </message>
    <message>
        <source>it cannot compute all of it</source>
        <translation>no puede calcularlo todo</translation>
    </message>
    <message>
        <source>You have changed it: nobody claims this.</source>
        <translation>Lo has cambiado: nadie garantiza esto.</translation>
    </message>
    <message>
        <source>%1 claims this case.</source>
        <translation>%1 garantiza este caso.</translation>
    </message>
    <message>
        <source>%1 does not claim it: %2.</source>
        <translation>%1 no lo garantiza: %2.</translation>
    </message>
    <message>
        <source>out of its bounds since frame %1</source>
        <translation>fuera de sus límites desde el fotograma %1</translation>
    </message>
    <message>
        <source>within its bounds up to frame %1, the rest is not looked at yet</source>
        <translation>dentro de sus límites hasta el fotograma %1; el resto aún no se ha mirado</translation>
    </message>
    <message>
        <source>within its bounds so far</source>
        <translation>dentro de sus límites hasta ahora</translation>
    </message>
    <message>
        <source>within its bounds so far, not at rest yet</source>
        <translation>dentro de sus límites hasta ahora, aún no en reposo</translation>
    </message>
    <message>
        <source>within its bounds so far, and at rest, as it should be</source>
        <translation>dentro de sus límites hasta ahora, y en reposo, como debe ser</translation>
    </message>
    <message>
        <source>%1
%2 Frame %3 of %4: %5.</source>
        <translation>%1
%2 Fotograma %3 de %4: %5.</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Caso</translation>
    </message>
    <message>
        <source>The experiment that runs. Another one begins at frame 0.</source>
        <translation>El experimento que se ejecuta. Otro empieza en el fotograma 0.</translation>
    </message>
    <message>
        <source>How hard the springs of the case pull. 0: as hard as the case has it.</source>
        <translation>Con qué fuerza tiran los muelles del caso. 0: la que el caso prevé.</translation>
    </message>
    <message>
        <source>the middle moved %1&#x2009;px</source>
        <translation>el centro se ha movido %1&#x2009;px</translation>
    </message>
    <message>
        <source>Longest</source>
        <translation>La más larga</translation>
    </message>
    <message>
        <source>The length of the third stick. The other two are 20&#x2009;px long.</source>
        <translation>La longitud de la tercera barra. Las otras dos miden 20&#x2009;px.</translation>
    </message>
    <message>
        <source>Implicit midpoint</source>
        <translation>Punto medio implícito</translation>
    </message>
    <message>
        <source>Semi-implicit Euler</source>
        <translation>Euler semiimplícito</translation>
    </message>
    <message>
        <source>Backward Euler</source>
        <translation>Euler implícito</translation>
    </message>
    <message>
        <source>The same, as sticks</source>
        <translation>Lo mismo, con barras</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Hecho de</translation>
    </message>
    <message>
        <source>Whether springs hold the three points, or rigid sticks.</source>
        <translation>Si los tres puntos los sujetan muelles o barras indeformables.</translation>
    </message>
    <message>
        <source>Velocity Verlet</source>
        <translation>Verlet de velocidad</translation>
    </message>
    <message>
        <source>springs</source>
        <translation>muelles</translation>
    </message>
    <message>
        <source>sticks</source>
        <translation>barras</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Hard cases</source>
        <translation>Casos difíciles</translation>
    </message>
    <message>
        <source>What breaks a simulation, why, and what holds.</source>
        <translation>Qué rompe una simulación, por qué, y qué aguanta.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>bank</source>
        <translation>orilla</translation>
    </message>
    <message>
        <source>stone</source>
        <translation>piedra</translation>
    </message>
</context>
</TS>
