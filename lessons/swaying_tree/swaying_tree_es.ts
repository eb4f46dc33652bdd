<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>SwayingTree</name>
    <message>
        <source>corrected</source>
        <translation>corregido</translation>
    </message>
    <message>
        <source>published</source>
        <translation>publicado</translation>
    </message>
    <message>
        <source>%1 px off</source>
        <translation>%1 px de diferencia</translation>
    </message>
    <message>
        <source>front</source>
        <translation>parte delantera</translation>
    </message>
    <message>
        <source>end</source>
        <translation>extremo</translation>
    </message>
    <message>
        <source>Part of the tree is below the ground: the rule turns angles, and knows no ground.</source>
        <translation>Una parte del árbol está bajo el suelo: la regla gira ángulos y no conoce ningún suelo.</translation>
    </message>
    <message>
        <source>Branches</source>
        <translation>Ramas</translation>
    </message>
    <message>
        <source>How many branches the tree has.</source>
        <translation>Cuántas ramas tiene el árbol.</translation>
    </message>
    <message>
        <source>Largest bend</source>
        <translation>Flexión máxima</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>How far the most bent branch is turned from where it grew.</source>
        <translation>Cuánto se ha girado la rama más doblada respecto a como creció.</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energía</translation>
    </message>
    <message>
        <source>Of motion and springs together. Without wind and damping it stays.</source>
        <translation>La del movimiento y la de los muelles juntas. Sin viento ni amortiguación no cambia.</translation>
    </message>
    <message>
        <source>In motion</source>
        <translation>En movimiento</translation>
    </message>
    <message>
        <source>The part that is in the turning branches.</source>
        <translation>La parte que está en las ramas que giran.</translation>
    </message>
    <message>
        <source>In springs</source>
        <translation>En los muelles</translation>
    </message>
    <message>
        <source>The part that the bent joints hold.</source>
        <translation>La parte que guardan las articulaciones dobladas.</translation>
    </message>
    <message>
        <source>Formula</source>
        <translation>Fórmula</translation>
    </message>
    <message>
        <source>What the tutorial’s text means, or what its code prints.</source>
        <translation>Lo que quiere decir el texto del tutorial, o lo que hace su código impreso.</translation>
    </message>
    <message>
        <source>Trunk length</source>
        <translation>Largo del tronco</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>How long the trunk is. All branches grow and shrink with it.</source>
        <translation>Cuánto mide el tronco. Todas las ramas crecen y encogen con él.</translation>
    </message>
    <message>
        <source>Spread</source>
        <translation>Apertura</translation>
    </message>
    <message>
        <source>How far a branch leans away from its parent.</source>
        <translation>Cuánto se inclina una rama respecto a su rama madre.</translation>
    </message>
    <message>
        <source>Slope</source>
        <translation>Reducción</translation>
    </message>
    <message>
        <source>How large a branch is, as a share of its parent.</source>
        <translation>El tamaño de una rama, como fracción de aquella de la que nace.</translation>
    </message>
    <message>
        <source>Smallest branch</source>
        <translation>Rama mínima</translation>
    </message>
    <message>
        <source>Branches must be larger than this share of the trunk.</source>
        <translation>Las ramas tienen que ser mayores que esta fracción del tronco.</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Dispersión</translation>
    </message>
    <message>
        <source>How much chance may turn a new branch, to either side.</source>
        <translation>Cuánto puede girar el azar una rama nueva, a cada lado.</translation>
    </message>
    <message>
        <source>Ease</source>
        <translation>Suavizado</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>fotogramas</translation>
    </message>
    <message>
        <source>How slowly a branch turns: each frame by the missing angle divided by this.</source>
        <translation>Con qué lentitud gira una rama: en cada fotograma, el ángulo que falta dividido entre esto.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Viento</translation>
    </message>
    <message>
        <source>How hard the wind blows. 0 is a calm.</source>
        <translation>Con qué fuerza sopla el viento. 0 es calma.</translation>
    </message>
    <message>
        <source>Turbulence</source>
        <translation>Turbulencia</translation>
    </message>
    <message>
        <source>How much chance may turn the wind in each frame, to either side.</source>
        <translation>Cuánto puede girar el azar el viento en cada fotograma, a cada lado.</translation>
    </message>
    <message>
        <source>Gust speed</source>
        <translation>Avance de ráfaga</translation>
    </message>
    <message>
        <source>px/frame</source>
        <translation>px/fotograma</translation>
    </message>
    <message>
        <source>How fast a gust runs outwards from the pointer.</source>
        <translation>Con qué rapidez corre una ráfaga desde el puntero hacia fuera.</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Ráfagas</translation>
    </message>
    <message>
        <source>The share by which the wind swells and ebbs as it runs. 0 is a steady wind.</source>
        <translation>La fracción en que el viento sube y baja mientras corre. 0 es un viento constante.</translation>
    </message>
    <message>
        <source>Poplar</source>
        <translation>Álamo</translation>
    </message>
    <message>
        <source>A small spread makes a narrow crown that reaches up.</source>
        <translation>Una apertura pequeña da una copa estrecha que va hacia arriba.</translation>
    </message>
    <message>
        <source>Honeycomb</source>
        <translation>Panal</translation>
    </message>
    <message>
        <source>At 60 degrees without jitter, branches meet and draw a net of hexagons.</source>
        <translation>A 60 grados y sin dispersión, las ramas se encuentran y dibujan una red de hexágonos.</translation>
    </message>
    <message>
        <source>City plan</source>
        <translation>Plano de ciudad</translation>
    </message>
    <message>
        <source>Right angles, each branch 0.71 of its parent: streets that fill a rectangle.</source>
        <translation>Ángulos rectos, cada rama 0,71 de la anterior: calles que llenan un rectángulo.</translation>
    </message>
    <message>
        <source>Lace</source>
        <translation>Encaje</translation>
    </message>
    <message>
        <source>Turned by 130 degrees, branches fold back on themselves and fill a triangle.</source>
        <translation>Giradas 130 grados, las ramas se pliegan sobre sí mismas y llenan un triángulo.</translation>
    </message>
    <message>
        <source>Cauliflower</source>
        <translation>Coliflor</translation>
    </message>
    <message>
        <source>Short steps and a slow slope: many branches of nearly one size.</source>
        <translation>Tramos cortos y una reducción lenta: muchas ramas casi del mismo tamaño.</translation>
    </message>
    <message>
        <source>Thicket</source>
        <translation>Matorral</translation>
    </message>
    <message>
        <source>With a jitter of 90 degrees chance has the last word.</source>
        <translation>Con una dispersión de 90 grados, el azar tiene la última palabra.</translation>
    </message>
    <message>
        <source>How hard a joint turns its branch back: for a lone trunk, this share of its bend each frame.</source>
        <translation>Con qué fuerza devuelve una articulación su rama: para un tronco solo, esta fracción de su flexión en cada fotograma.</translation>
    </message>
    <message>
        <source>The share of its spin that every branch keeps each frame. 1 keeps it all.</source>
        <translation>La fracción de su velocidad angular que cada rama conserva en cada fotograma. 1 la conserva toda.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Swaying tree</source>
        <translation>Árbol que se mece</translation>
    </message>
    <message>
        <source>A tree that grows by one rule, bends in your wind, and at last swings by itself.</source>
        <translation>Un árbol que crece con una sola regla, se dobla con tu viento y al final oscila solo.</translation>
    </message>
</context>
<context>
    <name>listing</name>
    <message>
        <source>Two smaller branches grow at the end of this one, and each of them does the same.</source>
        <translation>Al final de esta rama crecen dos más pequeñas, y cada una hace lo mismo.</translation>
    </message>
    <message>
        <source>a rule that uses itself needs an end</source>
        <translation>una regla que se usa a sí misma necesita un final</translation>
    </message>
    <message>
        <source>to a radian; the tutorial rounds</source>
        <translation>por radián; el tutorial redondea</translation>
    </message>
    <message>
        <source>from where a branch begins to where it ends, if it is as large as the trunk</source>
        <translation>de donde empieza una rama a donde acaba, si es tan grande como el tronco</translation>
    </message>
    <message>
        <source>Where a branch ends, its children begin, and so do theirs: a function that calls itself.</source>
        <translation>Donde acaba una rama empiezan sus hijos, y los de ellos: una función que se llama a sí misma.</translation>
    </message>
    <message>
        <source>The wind turns a branch away from the pointer, by a part of the missing angle. The tutorial</source>
        <translation>El viento aparta una rama del puntero, una parte del ángulo que falta. El tutorial escribe</translation>
    </message>
    <message>
        <source>prints a plus for the minus and 360 for 180, and its branches can turn past the wind.</source>
        <translation>un más en vez del menos y 360 en vez de 180, y sus ramas pueden girar más allá del viento.</translation>
    </message>
    <message>
        <source>far branches resist</source>
        <translation>las ramas lejanas resisten</translation>
    </message>
    <message>
        <source>the pointer is on its end</source>
        <translation>el puntero está en su extremo</translation>
    </message>
    <message>
        <source>the short way</source>
        <translation>el camino corto</translation>
    </message>
    <message>
        <source>never past the wind</source>
        <translation>nunca más allá del viento</translation>
    </message>
    <message>
        <source>Back to rest by a part of the missing angle, then away from the wind.</source>
        <translation>Hacia el reposo, una parte del ángulo que falta; luego, lejos del viento.</translation>
    </message>
    <message>
        <source>by chance, up to jitter to either side; the seed and the branch&apos;s number decide</source>
        <translation>al azar, hasta jitter a cada lado; deciden la semilla y el número de la rama</translation>
    </message>
    <message>
        <source>The wind pushes hardest across a branch.</source>
        <translation>El viento empuja con más fuerza de través a una rama.</translation>
    </message>
    <message>
        <source>the gust is not here</source>
        <translation>la ráfaga no está aquí</translation>
    </message>
    <message>
        <source>the sine between them</source>
        <translation>el seno del ángulo entre ellas</translation>
    </message>
    <message>
        <source>Each joint is a spring that turns. Returns its torque: the parent feels the opposite one.</source>
        <translation>Cada articulación es un muelle que gira. Devuelve su torque: la rama madre siente el opuesto.</translation>
    </message>
    <message>
        <source>a new gust</source>
        <translation>una ráfaga nueva</translation>
    </message>
    <message>
        <source>thick ones resist</source>
        <translation>las gruesas resisten</translation>
    </message>
    <message>
        <source>Turns a branch to the pointer.</source>
        <translation>Gira una rama hacia el puntero.</translation>
    </message>
    <message>
        <source>printed with a plus, in the branch&apos;s own measure</source>
        <translation>impreso con un más, en la medida propia de la rama</translation>
    </message>
    <message>
        <source>A branch is three things: where it begins, its angle, and its length. Where it ends follows.</source>
        <translation>Una rama son tres cosas: dónde empieza, su ángulo y su longitud. De ahí sale dónde acaba.</translation>
    </message>
    <message>
        <source>cos and sin take radians: there are 180 / pi degrees in one. The tutorial has 57.3.</source>
        <translation>cos y sin toman radianes: en un radián hay 180 / pi grados. El tutorial pone 57,3.</translation>
    </message>
    <message>
        <source>the same for all</source>
        <translation>igual para todas</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>root</source>
        <translation>raíz</translation>
    </message>
</context>
</TS>
