<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>AccuracyPlotText</name>
    <message>
        <source>%1: %2 frames; reference %3, accurate to %4 px</source>
        <translation>%1: %2 fotogramas; referencia %3, con una precisión de %4 px</translation>
    </message>
</context>
<context>
    <name>AccuracyReportText</name>
    <message>
        <source>step</source>
        <translation>paso de tiempo</translation>
    </message>
    <message>
        <source>error, px</source>
        <translation>error, px</translation>
    </message>
    <message>
        <source>forces/frame</source>
        <translation>fuerzas/fot.</translation>
    </message>
    <message>
        <source>ns/frame</source>
        <translation>ns/fot.</translation>
    </message>
    <message>
        <source>+-</source>
        <translation>+-</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>inestable</translation>
    </message>
    <message>
        <source>takes too long</source>
        <translation>tarda demasiado</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>en uso</translation>
    </message>
    <message>
        <source>This scene has no exact motion to compare with, because %1 acts once per step. Each method is therefore compared with itself at a finer step (%2), which differs by up to %3 px from the next coarser one.</source>
        <translation>Esta escena no tiene movimiento exacto con el que comparar, porque %1 actúa una vez por paso de tiempo. Por eso cada método se compara consigo mismo con un paso más fino (%2), que se aparta hasta %3 px del siguiente más grueso.</translation>
    </message>
    <message>
        <source>Errors are distances from %1 (%2). Its check, %3 (%4), differs from it by up to %5 px.</source>
        <translation>Los errores son distancias a %1 (%2). Su comprobación, %3 (%4), se aparta de él hasta %5 px.</translation>
    </message>
    <message>
        <source>Errors are given up to frame %1 of %2</source>
        <translation>Hay errores hasta el fotograma %1 de %2</translation>
    </message>
    <message>
        <source>: after that, the reference and its check disagree.</source>
        <translation>: después, la referencia y su comprobación ya no coinciden.</translation>
    </message>
    <message>
        <source>: after that, the reference is no longer finite.</source>
        <translation>: después, la referencia ya no es finita.</translation>
    </message>
    <message>
        <source>: computing the reference beyond that would take too long.</source>
        <translation>: calcular la referencia más allá llevaría demasiado tiempo.</translation>
    </message>
    <message>
        <source>No method stays within an error of %1 px.</source>
        <translation>Ningún método baja de un error de %1 px.</translation>
    </message>
    <message>
        <source>The cheapest way to stay within an error of %1 px costs %2 µs a frame: %3, with an error of %4 px.</source>
        <translation>Lo más barato para no pasar de un error de %1 px cuesta %2 µs por fotograma: %3, con un error de %4 px.</translation>
    </message>
    <message>
        <source>No error was measured for the method in use, %1: see the table.</source>
        <translation>No se midió ningún error para el método en uso, %1: mira la tabla.</translation>
    </message>
    <message>
        <source>The method in use, %1, costs %2 µs a frame, with an error of %3 px.</source>
        <translation>El método en uso, %1, cuesta %2 µs por fotograma, con un error de %3 px.</translation>
    </message>
    <message>
        <source>tolerance %1</source>
        <translation>tolerancia %1</translation>
    </message>
    <message>
        <source>h %1</source>
        <translation>h %1</translation>
    </message>
    <message>
        <source>method</source>
        <translation>método</translation>
    </message>
    <message>
        <source>* on the front: nothing cheaper is as accurate.</source>
        <translation>* en la línea óptima: nada más barato es tan preciso.</translation>
    </message>
    <message>
        <source>This machine is busy with other things: times vary by %1 %.</source>
        <translation>Este equipo está ocupado con otras cosas: los tiempos varían un %1 %.</translation>
    </message>
    <message>
        <source>Nothing moves here unless you do something, so there is no error to measure. Save a run in which you do something, and measure that file.</source>
        <translation>Aquí no se mueve nada si tú no haces algo, así que no hay error que medir. Guarda una ejecución en la que hagas algo y mide ese archivo.</translation>
    </message>
</context>
<context>
    <name>AccuracyText</name>
    <message>
        <source>Measured %1 %</source>
        <translation>Medido: %1 %</translation>
    </message>
    <message>
        <source>%1: the picture could not be written: %2. Choose another folder or name.</source>
        <translation>%1: no se pudo escribir la imagen: %2. Elige otra carpeta u otro nombre.</translation>
    </message>
    <message>
        <source>Your setup costs %1 and has an error of %2.</source>
        <translation>Tu configuración cuesta %1 y tiene un error de %2.</translation>
    </message>
    <message>
        <source>Your setup has an error of %1.</source>
        <translation>Tu configuración tiene un error de %1.</translation>
    </message>
    <message>
        <source>Your setup is unstable here: its numbers grow without bound.</source>
        <translation>Tu configuración es inestable aquí: los números crecen sin límite.</translation>
    </message>
    <message>
        <source>Your method cannot compute this scene.</source>
        <translation>Tu método no puede calcular esta escena.</translation>
    </message>
    <message>
        <source>Your setup would take too long to measure.</source>
        <translation>Medir tu configuración llevaría demasiado tiempo.</translation>
    </message>
    <message>
        <source>Errors are measured first, then times. The cost of staying within an error of %1 will appear here.</source>
        <translation>Primero se miden los errores y luego los tiempos. Aquí aparecerá lo que cuesta no pasar de un error de %1.</translation>
    </message>
    <message>
        <source>No method stays within an error of %1.</source>
        <translation>Ningún método baja de un error de %1.</translation>
    </message>
    <message>
        <source>No method stays within an error of %1. The closest is %2, with an error of %3.</source>
        <translation>Ningún método baja de un error de %1. El que más se acerca es %2, con un error de %3.</translation>
    </message>
    <message>
        <source>Errors are measured up to frame %1 of %2.</source>
        <translation>Los errores se miden hasta el fotograma %1 de %2.</translation>
    </message>
    <message>
        <source>After that, even the two finest steps disagree, because the smallest difference grows here.</source>
        <translation>Después, ni siquiera los dos pasos de tiempo más finos coinciden, porque aquí crece la menor diferencia.</translation>
    </message>
    <message>
        <source>After that, even two very accurate solutions disagree. The smallest difference grows here until the true positions cannot be known.</source>
        <translation>Después, ni siquiera dos soluciones muy precisas coinciden. Aquí la menor diferencia crece hasta que ya no se pueden saber las posiciones verdaderas.</translation>
    </message>
    <message>
        <source>After that, the exact motion itself grows without bound.</source>
        <translation>Después, el propio movimiento exacto crece sin límite.</translation>
    </message>
    <message>
        <source>Computing the exact motion beyond that would take too long.</source>
        <translation>Calcular el movimiento exacto más allá llevaría demasiado tiempo.</translation>
    </message>
    <message>
        <source>one of its effects</source>
        <translation>uno de sus efectos</translation>
    </message>
    <message>
        <source>This scene has no exact motion to compare with, because %1 acts once per step, however short the step is. Each method is therefore compared with its own finest steps.</source>
        <translation>Esta escena no tiene movimiento exacto con el que comparar, porque «%1» actúa una vez por paso de tiempo, por corto que sea. Por eso cada método se compara con sus propios pasos más finos.</translation>
    </message>
    <message>
        <source>Cannot compute this scene: %1.</source>
        <translation>No puede calcular esta escena: %1.</translation>
    </message>
    <message>
        <source>%1&#x2009;µs</source>
        <translation>%1&#x2009;µs</translation>
    </message>
    <message>
        <source>%1, tolerance %2</source>
        <translation>%1, tolerancia %2</translation>
    </message>
    <message>
        <source>%1, step %2</source>
        <translation>%1, paso de tiempo %2</translation>
    </message>
    <message>
        <source>No error, to the last digit</source>
        <translation>Sin error, hasta la última cifra</translation>
    </message>
    <message>
        <source>Error at most %1</source>
        <translation>Error máximo: %1</translation>
    </message>
    <message>
        <source>Unstable: its numbers grow without bound</source>
        <translation>Inestable: sus números crecen sin límite</translation>
    </message>
    <message>
        <source>Cannot compute this scene</source>
        <translation>No puede calcular esta escena</translation>
    </message>
    <message>
        <source>Skipped: it would take too long</source>
        <translation>Omitido: llevaría demasiado tiempo</translation>
    </message>
    <message>
        <source>Not measured yet</source>
        <translation>Aún sin medir</translation>
    </message>
    <message>
        <source>%1 ± %2 a frame</source>
        <translation>%1 ± %2 por fotograma</translation>
    </message>
    <message>
        <source>Computes all forces %1 times a frame</source>
        <translation>Calcula todas las fuerzas %1 veces por fotograma</translation>
    </message>
    <message>
        <source>On the front: nothing cheaper is as accurate</source>
        <translation>En la línea óptima: nada más barato es tan preciso</translation>
    </message>
    <message>
        <source>Nothing moves here unless you do something, so there is no error to measure. Drag a body or change a number, then measure again.</source>
        <translation>Aquí no se mueve nada si tú no haces algo, así que no hay error que medir. Arrastra un cuerpo o cambia un número y mide de nuevo.</translation>
    </message>
    <message>
        <source>First results, for frames 0 to %1. The exact motion after that is still being computed.</source>
        <translation>Primeros resultados, para los fotogramas 0 a %1. El movimiento exacto posterior aún se está calculando.</translation>
    </message>
    <message>
        <source>Nothing cheaper than your setup stays within an error of %1: %2 costs %3 a frame, with an error of %4.</source>
        <translation>Nada más barato que tu configuración baja de un error de %1: %2 cuesta %3 por fotograma, con un error de %4.</translation>
    </message>
    <message>
        <source>The cheapest way to stay within an error of %1 costs %2 a frame: %3.</source>
        <translation>Lo más barato para no pasar de un error de %1 cuesta %2 por fotograma: %3.</translation>
    </message>
    <message>
        <source>The machine is busy with other things: the times differ by %1&#x2009;% from run to run. The errors are not affected.</source>
        <translation>El equipo está ocupado con otras cosas: los tiempos varían un %1&#x2009;% de una ejecución a otra. A los errores no les afecta.</translation>
    </message>
    <message>
        <source>Unstable: %1</source>
        <translation>Inestable: %1</translation>
    </message>
    <message>
        <source>unstable at large steps: %1</source>
        <translation>inestable con pasos de tiempo grandes: %1</translation>
    </message>
    <message>
        <source>%1: the run is computed by code, which has no shorter steps to compare with. Remove &quot;method&quot; and &quot;code&quot; to measure the methods.</source>
        <translation>%1: la ejecución la calcula código, que no tiene pasos de tiempo más cortos con los que comparar. Quita &quot;method&quot; y &quot;code&quot; para medir los métodos.</translation>
    </message>
    <message>
        <source>%1 is not the name of a plot; it ends in .svg.</source>
        <translation>%1 no es el nombre de un gráfico; termina en .svg.</translation>
    </message>
</context>
<context>
    <name>Attempt</name>
    <message>
        <source>There is not enough memory.</source>
        <translation>No hay memoria suficiente.</translation>
    </message>
</context>
<context>
    <name>BlueprintReader</name>
    <message>
        <source>%1 has %2 entries; the most is %3.</source>
        <translation>%1 tiene %2 entradas; el máximo es %3.</translation>
    </message>
    <message>
        <source>an object in { }</source>
        <translation>un objeto en { }</translation>
    </message>
    <message>
        <source>&quot;bodies&quot; is empty; a scene needs at least one body.</source>
        <translation>&quot;bodies&quot; está vacío; una escena necesita al menos un cuerpo.</translation>
    </message>
    <message>
        <source>a body cannot be called %1; a name is a letter, then up to %2 letters, digits, dots and _.</source>
        <translation>un cuerpo no puede llamarse %1; un nombre es una letra y luego hasta %2 letras, cifras, puntos y _.</translation>
    </message>
    <message>
        <source>a body&apos;s name</source>
        <translation>el nombre de un cuerpo</translation>
    </message>
    <message>
        <source>there is no body %1 in this scene; %2 must be the name of one of its &quot;bodies&quot;.</source>
        <translation>en esta escena no hay ningún cuerpo %1; %2 debe ser el nombre de uno de sus &quot;bodies&quot;.</translation>
    </message>
    <message>
        <source>%1 has %2 at both ends; give it two bodies.</source>
        <translation>%1 tiene %2 en los dos extremos; dale dos cuerpos.</translation>
    </message>
    <message>
        <source>a spring</source>
        <translation>un muelle</translation>
    </message>
    <message>
        <source>a stick</source>
        <translation>una barra</translation>
    </message>
    <message>
        <source>a gait group</source>
        <translation>un grupo de marcha</translation>
    </message>
    <message>
        <source>a foot</source>
        <translation>un pie</translation>
    </message>
    <message>
        <source>a foot belongs to a gait group, and there is none; add &quot;gaits&quot;: [{}].</source>
        <translation>un pie pertenece a un grupo de marcha, y no hay ninguno; añade &quot;gaits&quot;: [{}].</translation>
    </message>
    <message>
        <source>%1 is a foot twice; it can be the foot of only one body.</source>
        <translation>%1 es un pie dos veces; solo puede ser el pie de un cuerpo.</translation>
    </message>
    <message>
        <source>a scene cannot have the effect %1; it can have %2. Its springs, sticks and feet need no effect.</source>
        <translation>una escena no puede tener el efecto %1; puede tener %2. Sus muelles, barras y pies no necesitan ningún efecto.</translation>
    </message>
    <message>
        <source>the effect %1 is given twice; keep one.</source>
        <translation>el efecto %1 aparece dos veces; deja uno.</translation>
    </message>
    <message>
        <source>&quot;rule&quot; does not compile. Line %1: %2</source>
        <translation>&quot;rule&quot; no se puede compilar. Línea %1: %2</translation>
    </message>
    <message>
        <source>a rule link</source>
        <translation>una unión de la regla</translation>
    </message>
</context>
<context>
    <name>BodyNamesText</name>
    <message>
        <source>A name is a letter from a to z, then up to %1 letters, digits or _. Write it without spaces and accents.</source>
        <translation>Un nombre es una letra de la a a la z, seguida de hasta %1 letras, cifras o _. Escríbelo sin espacios ni tildes.</translation>
    </message>
    <message>
        <source>“%1” is a word of the code. Choose another name, such as “%1_1”.</source>
        <translation>«%1» es una palabra del código. Elige otro nombre, por ejemplo «%1_1».</translation>
    </message>
</context>
<context>
    <name>BodyText</name>
    <message>
        <source>%1 at (%2, %3)</source>
        <translation>%1 en (%2, %3)</translation>
    </message>
    <message>
        <source>%1, at rest</source>
        <translation>%1, en reposo</translation>
    </message>
    <message>
        <source>%1, moving %2 px a frame</source>
        <translation>%1, se mueve %2 px por fotograma</translation>
    </message>
</context>
<context>
    <name>Branches</name>
    <message>
        <source>%1 at frame %2</source>
        <translation>%1 en el fotograma %2</translation>
    </message>
</context>
<context>
    <name>BreakpointMonitorText</name>
    <message>
        <source>%1, line %2</source>
        <translation>%1, línea %2</translation>
    </message>
    <message>
        <source>Stopped at frame %1 before %2: %3.</source>
        <translation>Parado en el fotograma %1 antes de «%2»: %3.</translation>
    </message>
    <message>
        <source>Stopped at frame %1 before line %2: %3.</source>
        <translation>Parado en el fotograma %1 antes de la línea %2: %3.</translation>
    </message>
    <message>
        <source>Stopped at frame %1 before line %2 of the listing.</source>
        <translation>Parado en el fotograma %1 antes de la línea %2 del listado.</translation>
    </message>
</context>
<context>
    <name>CaptionText</name>
    <message>
        <source>pulls change the velocities directly, %1.</source>
        <translation>los tirones cambian las velocidades directamente, %1.</translation>
    </message>
    <message>
        <source>accelerations are being added up, %1.</source>
        <translation>se están sumando aceleraciones, %1.</translation>
    </message>
    <message>
        <source>velocities have changed, %1.</source>
        <translation>las velocidades han cambiado, %1.</translation>
    </message>
    <message>
        <source>already moved: %1; not yet moved: %2.</source>
        <translation>ya movido: %1; aún sin mover: %2.</translation>
    </message>
    <message>
        <source>everything has moved; next: %1.</source>
        <translation>todo se ha movido; ahora viene «%1».</translation>
    </message>
    <message>
        <source>everything has moved.</source>
        <translation>todo se ha movido.</translation>
    </message>
    <message>
        <source>Inside frame %1: %2 of %3 steps are done.</source>
        <translation>Dentro del fotograma %1: hechos %2 de %3 pasos de tiempo.</translation>
    </message>
    <message>
        <source>nothing has moved in it yet</source>
        <translation>en él aún no se ha movido nada</translation>
    </message>
    <message>
        <source>nothing has moved yet</source>
        <translation>aún no se ha movido nada</translation>
    </message>
    <message>
        <source>after %1, points have moved directly, without a velocity.</source>
        <translation>tras «%1», hay puntos movidos directamente, sin velocidad.</translation>
    </message>
    <message>
        <source>after %1, points have moved directly, and velocities have changed.</source>
        <translation>tras «%1», hay puntos movidos directamente y velocidades cambiadas.</translation>
    </message>
    <message>
        <source>Inside frame %1, step %2 of %3: %4</source>
        <translation>Dentro del fotograma %1, paso de tiempo %2 de %3: %4</translation>
    </message>
    <message>
        <source>Inside frame %1: %2</source>
        <translation>Dentro del fotograma %1: %2</translation>
    </message>
</context>
<context>
    <name>CheckText</name>
    <message>
        <source>%1: %2 (steps: %3; languages besides the first: %4)
</source>
        <translation>%1: %2 (pasos: %3; idiomas además del primero: %4)
</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
</context>
<context>
    <name>CodeJudge</name>
    <message>
        <source>%1° away from its angle</source>
        <translation>a %1° de su ángulo</translation>
    </message>
    <message>
        <source>%1&#x202f;px away from its place</source>
        <translation>a %1&#x202f;px de su lugar</translation>
    </message>
    <message>
        <source>Not yet: in frame %1 of a trial run with other parameters, %2 is %3.</source>
        <translation>Todavía no: en el fotograma %1 de una ejecución de prueba con otros parámetros, %2 está %3.</translation>
    </message>
    <message>
        <source>Not yet: in frame %1 of a trial run, %2 is %3.</source>
        <translation>Todavía no: en el fotograma %1 de una ejecución de prueba, %2 está %3.</translation>
    </message>
    <message>
        <source>Not yet: while your hand holds %1 in a trial run with other parameters, %2 is %3.</source>
        <translation>Todavía no: mientras tu mano sujeta %1 en una ejecución de prueba con otros parámetros, %2 está %3.</translation>
    </message>
    <message>
        <source>Not yet: while your hand holds %1 in a trial run, %2 is %3.</source>
        <translation>Todavía no: mientras tu mano sujeta %1 en una ejecución de prueba, %2 está %3.</translation>
    </message>
    <message>
        <source>Right: your code does the same as the listing in three trial runs.</source>
        <translation>Correcto: tu código hace lo mismo que el listado en tres ejecuciones de prueba.</translation>
    </message>
    <message>
        <source>Not yet: a trial run stops in frame %1. %2</source>
        <translation>Todavía no: una ejecución de prueba se para en el fotograma %1. %2</translation>
    </message>
    <message>
        <source>Not yet: in frame %1 of a trial run, a number became infinite.</source>
        <translation>Todavía no: en el fotograma %1 de una ejecución de prueba, un número se hizo infinito.</translation>
    </message>
    <message>
        <source>Line %1 is not correct yet, so the code cannot run.</source>
        <translation>La línea %1 aún no es correcta, así que el código no puede ejecutarse.</translation>
    </message>
</context>
<context>
    <name>CodeListingText</name>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>%1: order of the phases</source>
        <translation>%1: orden de las fases</translation>
    </message>
</context>
<context>
    <name>CodeMarksText</name>
    <message>
        <source>done</source>
        <translation>hecho</translation>
    </message>
    <message>
        <source>now</source>
        <translation>ahora</translation>
    </message>
    <message>
        <source>next</source>
        <translation>siguiente</translation>
    </message>
    <message>
        <source>1 pull</source>
        <translation>1 tirón</translation>
    </message>
    <message>
        <source>%1 pulls</source>
        <translation>%1 tirones</translation>
    </message>
</context>
<context>
    <name>CodeRowsText</name>
    <message>
        <source>%1: added up by the method</source>
        <translation>%1: sumados por el método</translation>
    </message>
</context>
<context>
    <name>CodeSymbols</name>
    <message>
        <source>Where the body is, as seen from the other end of its spring.</source>
        <translation>Dónde está el cuerpo, visto desde el otro extremo de su muelle.</translation>
    </message>
    <message>
        <source>The direction away from the other end of the spring, as an arrow of length 1.</source>
        <translation>La dirección que se aleja del otro extremo del muelle, como una flecha de longitud 1.</translation>
    </message>
    <message>
        <source>The same direction, as an angle.</source>
        <translation>La misma dirección, como ángulo.</translation>
    </message>
    <message>
        <source>How far the body is from the other end of its spring.</source>
        <translation>A qué distancia está el cuerpo del otro extremo de su muelle.</translation>
    </message>
    <message>
        <source>How much farther away the spring pulls the body, as a share of its distance.</source>
        <translation>Cuánto más lejos lleva el muelle al cuerpo, como fracción de su distancia.</translation>
    </message>
    <message>
        <source>Where the spring pulls the body to.</source>
        <translation>Hacia dónde tira el muelle del cuerpo.</translation>
    </message>
    <message>
        <source>The arrow from the body to where the spring pulls it.</source>
        <translation>La flecha del cuerpo al lugar hacia el que tira el muelle.</translation>
    </message>
    <message>
        <source>How much all springs together add to the velocity in each frame.</source>
        <translation>Cuánto suman todos los muelles juntos a la velocidad en cada fotograma.</translation>
    </message>
    <message>
        <source>How much gravity adds to the velocity in each frame.</source>
        <translation>Cuánto suma la gravedad a la velocidad en cada fotograma.</translation>
    </message>
    <message>
        <source>The arrow from the body to its target.</source>
        <translation>La flecha del cuerpo a su objetivo.</translation>
    </message>
    <message>
        <source>The share of the velocity that is left after this step.</source>
        <translation>La fracción de la velocidad que queda tras este paso de tiempo.</translation>
    </message>
    <message>
        <source>How much is added to the velocity in each frame.</source>
        <translation>Cuánto se suma a la velocidad en cada fotograma.</translation>
    </message>
    <message>
        <source>Where the body is: x to the right, y down.</source>
        <translation>Dónde está el cuerpo; x: hacia la derecha, y: hacia abajo.</translation>
    </message>
    <message>
        <source>The velocity: how far the body moves in a frame.</source>
        <translation>La velocidad: cuánto se mueve el cuerpo en un fotograma.</translation>
    </message>
    <message>
        <source>How far the two are from each other.</source>
        <translation>A qué distancia están los dos entre sí.</translation>
    </message>
    <message>
        <source>How fast it turns.</source>
        <translation>Con qué rapidez gira.</translation>
    </message>
    <message>
        <source>The direction in which it points.</source>
        <translation>La dirección en la que apunta.</translation>
    </message>
</context>
<context>
    <name>CodeTargetsText</name>
    <message>
        <source>%1 can be %2, but not %3.</source>
        <translation>%1 puede ser %2, pero no %3.</translation>
    </message>
    <message>
        <source>%1 can be a whole number from %2 to %3, but not %4.</source>
        <translation>%1 puede ser un número entero de %2 a %3, pero no %4.</translation>
    </message>
    <message>
        <source>%1 can be a number from %2 to %3, but not %4.</source>
        <translation>%1 puede ser un número de %2 a %3, pero no %4.</translation>
    </message>
</context>
<context>
    <name>CodeTextWords</name>
    <message>
        <source>other code</source>
        <translation>otro código</translation>
    </message>
</context>
<context>
    <name>CodeValuesText</name>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>too large</source>
        <translation>excesivo</translation>
    </message>
    <message>
        <source>%1: from %2 to %3%4</source>
        <translation>%1: de %2 a %3%4</translation>
    </message>
    <message>
        <source>%1: %2%3, unchanged</source>
        <translation>%1: %2%3, sin cambios</translation>
    </message>
    <message>
        <source>%1: %2%3</source>
        <translation>%1: %2%3</translation>
    </message>
    <message>
        <source>The sum of %1 pulls</source>
        <translation>La suma de %1 tirones</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>there is no display for the window; set DISPLAY, or use a verb that needs none: %1.</source>
        <translation>no hay pantalla para la ventana; define DISPLAY, o usa un verbo que no la necesite: %1.</translation>
    </message>
</context>
<context>
    <name>CommandLineText</name>
    <message>
        <source>An experiment or a lesson to open.</source>
        <translation>Un experimento o una lección que abrir.</translation>
    </message>
    <message>
        <source>Prints the version.</source>
        <translation>Muestra la versión.</translation>
    </message>
    <message>
        <source>there is no verb and no file %1; the verbs are %2.</source>
        <translation>no hay ningún verbo ni archivo %1; los verbos son %2.</translation>
    </message>
    <message>
        <source>there is no verb %1; the verbs are %2.</source>
        <translation>no hay ningún verbo %1; los verbos son %2.</translation>
    </message>
    <message>
        <source>Prints this help.</source>
        <translation>Muestra esta ayuda.</translation>
    </message>
    <message>
        <source>%1; see %2 --help.</source>
        <translation>%1; consulta %2 --help.</translation>
    </message>
    <message>
        <source>no arguments</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>%1 takes %2; see %3 --help.</source>
        <translation>argumentos de %1: %2; consulta %3 --help.</translation>
    </message>
    <message>
        <source>Physically based animation, step by step.

Without a verb, the window opens and shows FILE, an experiment or a lesson.

Verbs (each has its own --help, and none needs a display):</source>
        <translation>Animación basada en la física, paso a paso.

Sin verbo, se abre la ventana y muestra FILE, un experimento o una lección.

Verbos (cada uno tiene su propio --help, y ninguno necesita pantalla):</translation>
    </message>
    <message>
        <source>%1 (default %2).</source>
        <translation>%1 (por defecto %2).</translation>
    </message>
    <message>
        <source>the window opens one file; leave out %1.</source>
        <translation>la ventana abre un archivo; omite %1.</translation>
    </message>
</context>
<context>
    <name>CommandList</name>
    <message>
        <source>Experiments</source>
        <translation>Experimentos</translation>
    </message>
    <message>
        <source>Pictures and films</source>
        <translation>Imágenes y vídeos</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Cambios</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Tiempo</translation>
    </message>
    <message>
        <source>Other runs</source>
        <translation>Otras ejecuciones</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Pasos</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Imagen</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Ventana</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Construir</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Gráficas</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Código</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Precisión</translation>
    </message>
</context>
<context>
    <name>ConceptMapText</name>
    <message>
        <source>the id “%1” is that of a concept in %2, too. Choose another one.</source>
        <translation>el id «%1» también es el de un concepto de %2. Elige otro.</translation>
    </message>
    <message>
        <source>the concept “%1” rests on “%2”, which no step explains. Use the id of a concept, or remove it.</source>
        <translation>el concepto «%1» se apoya en «%2», que ningún paso explica. Usa el id de un concepto, o quítalo.</translation>
    </message>
    <message>
        <source>the concept “%1” rests on “%2”, which comes later, in %3. Move one of them, or remove the id.</source>
        <translation>el concepto «%1» se apoya en «%2», que viene después, en %3. Mueve uno de los dos, o quita el id.</translation>
    </message>
    <message>
        <source>the concept “%1” rests on itself. Remove its id from “Rests on”.</source>
        <translation>el concepto «%1» se apoya en sí mismo. Quita su id de «Rests on».</translation>
    </message>
    <message>
        <source>the concept “%1” rests on one that rests on it. Remove one of the two ids.</source>
        <translation>el concepto «%1» se apoya en uno que se apoya en él. Quita uno de los dos ids.</translation>
    </message>
</context>
<context>
    <name>ConditionNamesText</name>
    <message>
        <source>Character %1: %2</source>
        <translation>Carácter %1: %2</translation>
    </message>
</context>
<context>
    <name>ConditionParserText</name>
    <message>
        <source>this is too long; use at most %1 characters.</source>
        <translation>esto es demasiado largo; usa como máximo %1 caracteres.</translation>
    </message>
    <message>
        <source>a number is neither true nor false; compare it, as in %1.</source>
        <translation>un número no es verdadero ni falso; compáralo, como en %1.</translation>
    </message>
    <message>
        <source>this is true or false, not a number; join conditions with and, or.</source>
        <translation>esto es verdadero o falso, no un número; une condiciones con and, or.</translation>
    </message>
    <message>
        <source>a phase can only be compared with its name, as in phase == &quot;%1&quot;.</source>
        <translation>una fase solo se puede comparar con su nombre, como en phase == &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>%1 is a choice; compare it with one of its values, as in %1 == &quot;%2&quot;.</source>
        <translation>%1 es una opción; compárala con uno de sus valores, como en %1 == &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>%1 is a text; only phase and choices can be compared with a text.</source>
        <translation>%1 es un texto; solo phase y las opciones se pueden comparar con un texto.</translation>
    </message>
    <message>
        <source>a number cannot be used here; write a condition such as x &gt; 0.</source>
        <translation>aquí no sirve un número; escribe una condición como x &gt; 0.</translation>
    </message>
    <message>
        <source>the condition is empty; write a comparison, as in %1.y &gt; 380.</source>
        <translation>la condición está vacía; escribe una comparación, como en %1.y &gt; 380.</translation>
    </message>
    <message>
        <source>this parenthesis closes nothing; remove it.</source>
        <translation>este paréntesis no cierra nada; quítalo.</translation>
    </message>
    <message>
        <source>%1 cannot directly follow the text before it; put and, or, or a sign such as + or &lt; between them.</source>
        <translation>%1 no puede ir justo después del texto anterior; pon entre ellos and, or, o un signo como + o &lt;.</translation>
    </message>
    <message>
        <source>a comparison has only two sides; join two comparisons with and.</source>
        <translation>una comparación solo tiene dos lados; une dos comparaciones con and.</translation>
    </message>
    <message>
        <source>names can only be equal or different; write == or !=.</source>
        <translation>los nombres solo pueden ser iguales o distintos; escribe == o !=.</translation>
    </message>
    <message>
        <source>this parenthesis is not closed; close it with ).</source>
        <translation>este paréntesis no está cerrado; ciérralo con ).</translation>
    </message>
    <message>
        <source>%1 cannot be here; a sign or ) is missing before it.</source>
        <translation>%1 no puede estar aquí; falta antes un signo o ).</translation>
    </message>
    <message>
        <source>something is missing at the end; add a number or a name.</source>
        <translation>falta algo al final; añade un número o un nombre.</translation>
    </message>
    <message>
        <source>a number or a name is missing before %1; add it.</source>
        <translation>falta un número o un nombre antes de %1; añádelo.</translation>
    </message>
    <message>
        <source>%1 needs parentheses around its number, as in %1(%2.vy).</source>
        <translation>%1 necesita paréntesis alrededor de su número, como en %1(%2.vy).</translation>
    </message>
    <message>
        <source>a comma can only be between two bodies, as in distance(%1, %2); write numbers with a point.</source>
        <translation>una coma solo puede estar entre dos cuerpos, como en distance(%1, %2); escribe los números con punto.</translation>
    </message>
    <message>
        <source>there is no phase %1; there are %2.</source>
        <translation>no hay ninguna fase %1; hay %2.</translation>
    </message>
    <message>
        <source>%1 is never %2; it can be %3.</source>
        <translation>%1 nunca es %2; puede ser %3.</translation>
    </message>
    <message>
        <source>there is no body %1 here; there are %2.</source>
        <translation>aquí no hay ningún cuerpo %1; hay %2.</translation>
    </message>
    <message>
        <source>%1 has no %2; it has %3.</source>
        <translation>%1 no tiene %2; tiene %3.</translation>
    </message>
    <message>
        <source>%1 is a body; ask for one of its numbers, as in %1.y (%2).</source>
        <translation>%1 es un cuerpo; pregunta por uno de sus números, como en %1.y (%2).</translation>
    </message>
    <message>
        <source>there is no %1 here; there are %2, and numbers of bodies, as in %3.y.</source>
        <translation>aquí no existe %1; hay %2, y números de cuerpos, como en %3.y.</translation>
    </message>
    <message>
        <source>%1 is a Vec2; ask for one of its numbers, %1.x or %1.y.</source>
        <translation>%1 es un Vec2; pregunta por uno de sus números, %1.x o %1.y.</translation>
    </message>
    <message>
        <source>%1 is a number, without members.</source>
        <translation>%1 es un número, sin miembros.</translation>
    </message>
    <message>
        <source>distance needs two bodies with a comma between them, as in %1.</source>
        <translation>distance necesita dos cuerpos con una coma entre ellos, como en %1.</translation>
    </message>
    <message>
        <source>the name of a body is missing here, as in %1.</source>
        <translation>aquí falta el nombre de un cuerpo, como en %1.</translation>
    </message>
</context>
<context>
    <name>ConditionTokensText</name>
    <message>
        <source>%1 is not a number; write one like 380, 0.5 or 1e-3.</source>
        <translation>%1 no es un número; escribe uno como 380, 0.5 o 1e-3.</translation>
    </message>
    <message>
        <source>This text has no closing quotation mark; close it with %1.</source>
        <translation>A este texto le faltan las comillas de cierre; ciérralo con %1.</translation>
    </message>
    <message>
        <source>A single “=” would set a value; write == to compare two values.</source>
        <translation>Un solo «=» asignaría un valor; escribe == para comparar dos valores.</translation>
    </message>
    <message>
        <source>A comma has no meaning here; write 0.5 with a point, and join conditions with “and”.</source>
        <translation>Una coma no significa nada aquí; escribe 0.5 con punto, y une condiciones con «and».</translation>
    </message>
    <message>
        <source>%1 has no meaning here; there are numbers, names, + - * / ( ), comparisons, and, or, not.</source>
        <translation>%1 no significa nada aquí; hay números, nombres, + - * / ( ), comparaciones, and, or, not.</translation>
    </message>
</context>
<context>
    <name>CostReportText</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>effect</source>
        <translation>efecto</translation>
    </message>
    <message>
        <source>points</source>
        <translation>puntos</translation>
    </message>
    <message>
        <source>times/frame</source>
        <translation>veces/fot.</translation>
    </message>
    <message>
        <source>ns/frame</source>
        <translation>ns/fot.</translation>
    </message>
    <message>
        <source>+-</source>
        <translation>+-</translation>
    </message>
    <message>
        <source>ns/point</source>
        <translation>ns/punto</translation>
    </message>
    <message>
        <source>share</source>
        <translation>fracc.</translation>
    </message>
    <message>
        <source>the method itself</source>
        <translation>el propio método</translation>
    </message>
    <message>
        <source>whole frame</source>
        <translation>fotograma entero</translation>
    </message>
    <message>
        <source>Each line is measured separately. Effects and method together take %1 of the time of the whole frame.</source>
        <translation>Cada línea se mide por separado. Los efectos y el método suman %1 del tiempo del fotograma entero.</translation>
    </message>
</context>
<context>
    <name>CostText</name>
    <message>
        <source>The run does not reach frame %1. %2 Give an earlier frame.</source>
        <translation>La ejecución no llega al fotograma %1. %2 Indica un fotograma anterior.</translation>
    </message>
    <message>
        <source>changes nothing</source>
        <translation>no cambia nada</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>desactivado</translation>
    </message>
    <message>
        <source>Measured %1 times</source>
        <translation>Medido %1 veces</translation>
    </message>
</context>
<context>
    <name>DifferenceTableText</name>
    <message>
        <source>distance [px]</source>
        <translation>distancia [px]</translation>
    </message>
    <message>
        <source>body</source>
        <translation>cuerpo</translation>
    </message>
</context>
<context>
    <name>DifferenceText</name>
    <message>
        <source>The other run is being computed again…</source>
        <translation>La otra ejecución se está calculando de nuevo…</translation>
    </message>
    <message>
        <source>There is no other run to compare with.</source>
        <translation>No hay otra ejecución con la que comparar.</translation>
    </message>
    <message>
        <source>More than %1 points: too many to compare at every frame.</source>
        <translation>Más de %1 puntos: demasiados para compararlos en cada fotograma.</translation>
    </message>
    <message>
        <source>The other run does not have the selected body.</source>
        <translation>La otra ejecución no tiene el cuerpo seleccionado.</translation>
    </message>
    <message>
        <source>The two runs have no body in common.</source>
        <translation>Las dos ejecuciones no tienen ningún cuerpo en común.</translation>
    </message>
    <message>
        <source>No difference up to frame %1. Play on to see whether one appears.</source>
        <translation>Sin diferencia hasta el fotograma %1. Sigue reproduciendo para ver si aparece alguna.</translation>
    </message>
    <message>
        <source>Largest: %1&#x2009;px apart, %2, at frame %3.</source>
        <translation>La mayor: %1&#x2009;px de separación, %2, en el fotograma %3.</translation>
    </message>
    <message>
        <source>Compared every %1 frames.</source>
        <translation>Comparado cada %1 fotogramas.</translation>
    </message>
    <message>
        <source>branches off at frame %1</source>
        <translation>se separa en el fotograma %1</translation>
    </message>
    <message>
        <source>branches off at the start</source>
        <translation>se separa al principio</translation>
    </message>
    <message>
        <source>%1, %2, kept</source>
        <translation>%1, %2, conservada</translation>
    </message>
</context>
<context>
    <name>EdgeMarkersText</name>
    <message>
        <source>%1 bodies</source>
        <translation>%1 cuerpos</translation>
    </message>
</context>
<context>
    <name>EditHistory</name>
    <message>
        <source>undone: %1</source>
        <translation>deshecho: %1</translation>
    </message>
</context>
<context>
    <name>EffectLinesText</name>
    <message>
        <source>Nearly all of a frame’s %2&#x2009;µs are spent in “%1”.</source>
        <translation>Casi todos los %2&#x2009;µs de un fotograma se gastan en «%1».</translation>
    </message>
    <message>
        <source>Without “%1” a frame would cost %2&#x2009;µs instead of %3.</source>
        <translation>Sin «%1», un fotograma costaría %2&#x2009;µs en vez de %3.</translation>
    </message>
    <message>
        <source>%1&#x2009;µs a frame; about half of the measurements are within %2.</source>
        <translation>%1&#x2009;µs por fotograma; cerca de la mitad de las mediciones están dentro de %2.</translation>
    </message>
    <message>
        <source>Points that it acts on: %1.</source>
        <translation>Puntos sobre los que actúa: %1.</translation>
    </message>
    <message>
        <source>The method computes it together with the move.</source>
        <translation>El método lo calcula junto con el movimiento.</translation>
    </message>
    <message>
        <source>Each frame computes it %1.</source>
        <translation>Cada fotograma lo calcula %1.</translation>
    </message>
    <message>
        <source>With these settings it changes nothing, so it is not computed: 0&#x2009;µs.</source>
        <translation>Con estos ajustes no cambia nada, así que no se calcula: 0&#x2009;µs.</translation>
    </message>
    <message>
        <source>Switched off: it costs nothing.</source>
        <translation>Desactivado: no cuesta nada.</translation>
    </message>
    <message>
        <source>Not in this scene, so it costs nothing.</source>
        <translation>No está en esta escena, así que no cuesta nada.</translation>
    </message>
    <message>
        <source>Press Space or click the switch to turn it off.</source>
        <translation>Pulsa Espacio o haz clic en el interruptor para desactivarlo.</translation>
    </message>
    <message>
        <source>Press Space or click the switch to turn it on again.</source>
        <translation>Pulsa Espacio o haz clic en el interruptor para volver a activarlo.</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>desactivado</translation>
    </message>
    <message>
        <source>changes nothing here</source>
        <translation>aquí no cambia nada</translation>
    </message>
    <message>
        <source>not in this scene</source>
        <translation>no está en esta escena</translation>
    </message>
    <message>
        <source>Rest of the frame</source>
        <translation>El resto</translation>
    </message>
    <message>
        <source>Time outside the effects: moving the points, and the method&apos;s own sums. It cannot be switched off.</source>
        <translation>Tiempo fuera de los efectos: mover los puntos y los cálculos propios del método. No se puede desactivar.</translation>
    </message>
    <message>
        <source>%1 (%2). %3</source>
        <translation>%1 (%2). %3</translation>
    </message>
    <message>
        <source>Not in this scene, so it costs nothing and has no switch. Other lessons have:</source>
        <translation>No está en esta escena, así que no cuesta nada ni tiene interruptor. Otras lecciones tienen:</translation>
    </message>
    <message>
        <source>%1, %2&#x2009;µs, %3</source>
        <translation>%1, %2&#x2009;µs, %3</translation>
    </message>
    <message>
        <source>%1, not measured yet</source>
        <translation>%1, aún sin medir</translation>
    </message>
    <message>
        <source>%1, %2&#x2009;µs a frame</source>
        <translation>%1, %2&#x2009;µs por fotograma</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activado</translation>
    </message>
    <message>
        <source>off</source>
        <translation>desactivado</translation>
    </message>
    <message>
        <source>%1%2µs a frame, ±%3</source>
        <translation>%1%2µs por fotograma, ±%3</translation>
    </message>
</context>
<context>
    <name>EnergyLinesText</name>
    <message>
        <source>Energy that you add by dragging</source>
        <translation>Energía que añades al arrastrar</translation>
    </message>
    <message>
        <source>If a stiffness or a length changes, the energy stored in springs changes, too</source>
        <translation>Si cambia una rigidez o una longitud, cambia también la energía almacenada en los muelles</translation>
    </message>
    <message>
        <source>Energy that gait clocks and steering add</source>
        <translation>Energía que añaden los relojes de marcha y el control</translation>
    </message>
    <message>
        <source>Energy that the wind adds or takes away</source>
        <translation>Energía que el viento añade o quita</translation>
    </message>
    <message>
        <source>Energy that the force of your rule adds or takes away</source>
        <translation>Energía que la fuerza de tu regla añade o quita</translation>
    </message>
    <message>
        <source>A pull without an opposite pull stores no energy. It adds energy or takes it away</source>
        <translation>Un tirón sin tirón opuesto no almacena energía. La añade o la quita</translation>
    </message>
    <message>
        <source>It pulls everything down, and nothing pulls back</source>
        <translation>Tira de todo hacia abajo, y nada tira de vuelta</translation>
    </message>
    <message>
        <source>Springs pull on fixed places, and those pull back</source>
        <translation>Los muelles tiran de lugares fijos, y estos tiran de vuelta</translation>
    </message>
    <message>
        <source>Energy that damping takes from everything that moves</source>
        <translation>Energía que la amortiguación quita a todo lo que se mueve</translation>
    </message>
    <message>
        <source>Energy that walls and ground take, or add when they push bodies out</source>
        <translation>Energía que las paredes y el suelo quitan, o añaden al empujar los cuerpos hacia fuera</translation>
    </message>
    <message>
        <source>Energy that sticks and joints change when they correct lengths and angles</source>
        <translation>Energía que las barras y articulaciones cambian al corregir longitudes y ángulos</translation>
    </message>
    <message>
        <source>Gained or lost through the method&apos;s error, not through anything in the scene. A smaller step or another method makes it smaller.</source>
        <translation>Ganada o perdida por el error del método, no por algo de la escena. Con un paso de tiempo menor o con otro método es más pequeña.</translation>
    </message>
    <message>
        <source>In motion</source>
        <translation>En movimiento</translation>
    </message>
    <message>
        <source>Half of mass × speed², added up over all points</source>
        <translation>La mitad de masa × rapidez², sumada para todos los puntos</translation>
    </message>
    <message>
        <source>In height</source>
        <translation>En altura</translation>
    </message>
    <message>
        <source>Mass × gravity × height, measured from the lowest point of this run</source>
        <translation>Masa × gravedad × altura, medida desde el punto más bajo de esta ejecución</translation>
    </message>
    <message>
        <source>In springs</source>
        <translation>En los muelles</translation>
    </message>
    <message>
        <source>Half of stiffness × stretch², added up over all springs</source>
        <translation>La mitad de rigidez × estiramiento², sumada para todos los muelles</translation>
    </message>
    <message>
        <source>Mass × velocity, added up over all points: to the right, and down</source>
        <translation>Masa × velocidad, sumada para todos los puntos: hacia la derecha y hacia abajo</translation>
    </message>
    <message>
        <source>A rule sets the position of at least one body in each frame, so this body has no velocity and the energy cannot be counted. Choose a scene in which every body has inertia.</source>
        <translation>Una regla fija la posición de al menos un cuerpo en cada fotograma; ese cuerpo no tiene velocidad, así que no se puede contar la energía. Elige una escena en la que todos los cuerpos tengan inercia.</translation>
    </message>
    <message>
        <source>Nothing moves in this scene unless you drag it, so there is no energy to count. Choose a scene with a body on a spring.</source>
        <translation>En esta escena no se mueve nada si no lo arrastras, así que no hay energía que contar. Elige una escena con un cuerpo en un muelle.</translation>
    </message>
    <message>
        <source>There are more than %1 points here. Counting the energy of all of them, phase by phase, would take longer than the run itself.</source>
        <translation>Aquí hay más de %1 puntos. Contar la energía de todos, fase a fase, llevaría más tiempo que la propia ejecución.</translation>
    </message>
    <message>
        <source>Something here turns, but its inertia is unknown. So there is no energy to count.</source>
        <translation>Aquí algo gira, pero su inercia es desconocida. Por eso no hay energía que contar.</translation>
    </message>
    <message>
        <source>inertia × degrees²/frame²</source>
        <translation>inercia × grados²/fotograma²</translation>
    </message>
    <message>
        <source>mass × px²/frame²</source>
        <translation>masa × px²/fotograma²</translation>
    </message>
    <message>
        <source>mass × px/frame</source>
        <translation>masa × px/fotograma</translation>
    </message>
</context>
<context>
    <name>Experiment</name>
    <message>
        <source>the file</source>
        <translation>el archivo</translation>
    </message>
    <message>
        <source>&quot;format&quot; is %1; this program reads %2.</source>
        <translation>&quot;format&quot; es %1; este programa lee %2.</translation>
    </message>
    <message>
        <source>&quot;scene&quot; does not go with a lesson&apos;s step, which has its own; remove it, and change that one by &quot;parameters&quot;, &quot;bodies&quot; and &quot;effects&quot;.</source>
        <translation>&quot;scene&quot; no va con el paso de una lección, que tiene la suya; quítalo, y cambia esa con &quot;parameters&quot;, &quot;bodies&quot; y &quot;effects&quot;.</translation>
    </message>
    <message>
        <source>the step %1 has no sticks; remove &quot;links&quot;.</source>
        <translation>el paso %1 no tiene barras; quita &quot;links&quot;.</translation>
    </message>
    <message>
        <source>nothing is held at frame %1; a %2 comes after a &quot;grab&quot;.</source>
        <translation>no se sujeta nada en el fotograma %1; un %2 va después de un &quot;grab&quot;.</translation>
    </message>
    <message>
        <source>the step %1 has no effect %2; it has %3.</source>
        <translation>el paso %1 no tiene el efecto %2; tiene %3.</translation>
    </message>
    <message>
        <source>the body %1</source>
        <translation>el cuerpo %1</translation>
    </message>
    <message>
        <source>there is no body %1 here; there is %2.</source>
        <translation>aquí no hay ningún cuerpo %1; hay %2.</translation>
    </message>
    <message>
        <source>the step %1 has its sticks in &quot;scene&quot;; move &quot;links&quot; there and call it &quot;sticks&quot;.</source>
        <translation>el paso %1 tiene sus barras en &quot;scene&quot;; mueve &quot;links&quot; allí y llámalo &quot;sticks&quot;.</translation>
    </message>
    <message>
        <source>&quot;name&quot; has %1 letters; it can have 1 to %2.</source>
        <translation>&quot;name&quot; tiene %1 letras; puede tener de 1 a %2.</translation>
    </message>
    <message>
        <source>&quot;branches&quot; has %1 runs; it can have up to %2.</source>
        <translation>&quot;branches&quot; tiene %1 ejecuciones; puede tener hasta %2.</translation>
    </message>
    <message>
        <source>the runs in &quot;branches&quot; have more than %1 events together; remove some.</source>
        <translation>las ejecuciones de &quot;branches&quot; tienen más de %1 eventos en total; quita algunos.</translation>
    </message>
    <message>
        <source>a branch</source>
        <translation>una variante</translation>
    </message>
    <message>
        <source>a text that tells it from others</source>
        <translation>un texto que la distinga de otras</translation>
    </message>
    <message>
        <source>frame %1 is before the start of the branch, whose &quot;fork&quot; is %2; use frame %2 or a later one.</source>
        <translation>el fotograma %1 es anterior al inicio de la variante, cuyo &quot;fork&quot; es %2; usa el fotograma %2 o uno posterior.</translation>
    </message>
    <message>
        <source>this is a notebook, not an experiment; &quot;springstep notebook check&quot; replays it.</source>
        <translation>esto es un cuaderno, no un experimento; «springstep notebook check» lo vuelve a reproducir.</translation>
    </message>
    <message>
        <source>If it is a lesson without C++, open it in the window, or name its folder in SPRINGSTEP_LESSONS.</source>
        <translation>Si es una lección sin C++, ábrela en la ventana, o indica su carpeta en SPRINGSTEP_LESSONS.</translation>
    </message>
</context>
<context>
    <name>ExperimentArgumentText</name>
    <message>
        <source>Reading %1</source>
        <translation>Leyendo %1</translation>
    </message>
    <message>
        <source>%1 is neither a file nor a step; name a step as LESSON/STEP, as &quot;springstep lessons&quot; lists them.</source>
        <translation>%1 no es ni un archivo ni un paso; nombra un paso como LESSON/STEP, tal como los lista &quot;springstep lessons&quot;.</translation>
    </message>
</context>
<context>
    <name>ExperimentInput</name>
    <message>
        <source>the step %1 has no event %2; it has %3.</source>
        <translation>el paso %1 no tiene el evento %2; tiene %3.</translation>
    </message>
    <message>
        <source>a body&apos;s name</source>
        <translation>el nombre de un cuerpo</translation>
    </message>
</context>
<context>
    <name>ExperimentLineText</name>
    <message>
        <source>The text begins like an experiment, but it is incomplete. Copy all of it, from “springstep:” to its end.</source>
        <translation>El texto empieza como un experimento, pero está incompleto. Cópialo entero, desde «springstep:» hasta el final.</translation>
    </message>
    <message>
        <source>The text is larger than %1 MiB, the maximum for an experiment.</source>
        <translation>El texto ocupa más de %1 MiB, el máximo para un experimento.</translation>
    </message>
    <message>
        <source>This run has too much input for a message. Save it as a file, and send that.</source>
        <translation>Esta ejecución tiene demasiadas entradas para un mensaje. Guárdala como archivo y envía el archivo.</translation>
    </message>
    <message>
        <source>There is no text to paste. Copy an experiment first: it begins with “springstep:” or {.</source>
        <translation>No hay texto que pegar. Copia antes un experimento: empieza por «springstep:» o {.</translation>
    </message>
    <message>
        <source>The copied text is not an experiment. An experiment begins with “springstep:” or {.</source>
        <translation>El texto copiado no es un experimento. Un experimento empieza por «springstep:» o {.</translation>
    </message>
    <message>
        <source>The text is too long for an experiment in one line. Open it as a file.</source>
        <translation>El texto es demasiado largo para un experimento en una línea. Ábrelo como archivo.</translation>
    </message>
    <message>
        <source>Pasted text</source>
        <translation>Texto pegado</translation>
    </message>
</context>
<context>
    <name>ExperimentMethodText</name>
    <message>
        <source>there is no method %1; there is %2.</source>
        <translation>no hay ningún método %1; hay %2.</translation>
    </message>
    <message>
        <source>&quot;h&quot; is %1; it can be 0.000001 to 100 frames, a whole number or 1 divided by one: 2, 1, 0.5, 0.25...</source>
        <translation>&quot;h&quot; es %1; puede ir de 0.000001 a 100 fotogramas, un número entero o 1 dividido por uno: 2, 1, 0.5, 0.25...</translation>
    </message>
    <message>
        <source>&quot;tolerance&quot; is %1; it can be 1e-13 to 100 px.</source>
        <translation>&quot;tolerance&quot; es %1; puede ir de 1e-13 a 100 px.</translation>
    </message>
    <message>
        <source>the method %1 chooses its own steps; give &quot;tolerance&quot; instead of &quot;h&quot;.</source>
        <translation>el método %1 elige sus propios pasos de tiempo; indica &quot;tolerance&quot; en vez de &quot;h&quot;.</translation>
    </message>
    <message>
        <source>the method %1 has fixed steps; give &quot;h&quot; instead of &quot;tolerance&quot;.</source>
        <translation>el método %1 tiene pasos de tiempo fijos; indica &quot;h&quot; en vez de &quot;tolerance&quot;.</translation>
    </message>
    <message>
        <source>&quot;code&quot; needs the method %1; set &quot;method&quot; to it, or remove &quot;code&quot;.</source>
        <translation>&quot;code&quot; necesita el método %1; ponlo en &quot;method&quot;, o quita &quot;code&quot;.</translation>
    </message>
    <message>
        <source>the method %1 needs &quot;code&quot;, the text of a listing.</source>
        <translation>el método %1 necesita &quot;code&quot;, el texto de un listado.</translation>
    </message>
    <message>
        <source>%1 has %2 bytes; it can have up to %3.</source>
        <translation>%1 tiene %2 bytes; puede tener hasta %3.</translation>
    </message>
    <message>
        <source>&quot;code&quot; does not compile. Line %1: %2</source>
        <translation>&quot;code&quot; no se puede compilar. Línea %1: %2</translation>
    </message>
</context>
<context>
    <name>ExperimentPointsText</name>
    <message>
        <source>a point&apos;s name</source>
        <translation>el nombre de un punto</translation>
    </message>
    <message>
        <source>there is no point %1 here; there is &quot;p0&quot; to %2.</source>
        <translation>aquí no hay ningún punto %1; hay de &quot;p0&quot; a %2.</translation>
    </message>
    <message>
        <source>&quot;bodies&quot; has %1 points; the most is %2.</source>
        <translation>&quot;bodies&quot; tiene %1 puntos; el máximo es %2.</translation>
    </message>
    <message>
        <source>there is no body %1 here; the points are called &quot;p0&quot;, &quot;p1&quot; and so on.</source>
        <translation>aquí no hay ningún cuerpo %1; los puntos se llaman &quot;p0&quot;, &quot;p1&quot;, etc.</translation>
    </message>
    <message>
        <source>the points have a gap: %1 of them are &quot;p0&quot; to %2, without %3.</source>
        <translation>falta un punto: %1 de ellos van de &quot;p0&quot; a %2, sin %3.</translation>
    </message>
    <message>
        <source>&quot;links&quot; has %1 sticks; the most is %2.</source>
        <translation>&quot;links&quot; tiene %1 barras; el máximo es %2.</translation>
    </message>
    <message>
        <source>a link</source>
        <translation>una barra</translation>
    </message>
    <message>
        <source>a link has %1 at both ends; give it two points.</source>
        <translation>una barra tiene %1 en los dos extremos; dale dos puntos.</translation>
    </message>
</context>
<context>
    <name>ExperimentText</name>
    <message>
        <source>there is no lesson %1, as no lesson is installed; SPRINGSTEP_LESSONS can name the folder that has them.</source>
        <translation>no hay ninguna lección %1, porque no hay lecciones instaladas; SPRINGSTEP_LESSONS puede indicar la carpeta que las tiene.</translation>
    </message>
    <message>
        <source>there is no lesson %1; there is %2.</source>
        <translation>no hay ninguna lección %1; hay %2.</translation>
    </message>
    <message>
        <source>the lesson %1 has no step %2; it has %3.</source>
        <translation>la lección %1 no tiene el paso %2; tiene %3.</translation>
    </message>
</context>
<context>
    <name>ExperimentWriterText</name>
    <message>
        <source>a number of this experiment is not finite, and a file cannot store such a number. Go back to an earlier frame.</source>
        <translation>un número de este experimento no es finito, y un archivo no puede guardar un número así. Vuelve a un fotograma anterior.</translation>
    </message>
    <message>
        <source>the file would have too many other runs: it can have %1, with %2 events together. Delete some in “Runs”.</source>
        <translation>el archivo tendría demasiadas ejecuciones: puede tener %1, con %2 eventos en total. Elimina algunas en «Ejecuciones».</translation>
    </message>
    <message>
        <source>the step %1 is no longer installed. Install its lesson again.</source>
        <translation>el paso %1 ya no está instalado. Vuelve a instalar su lección.</translation>
    </message>
    <message>
        <source>the run has more input than a file can store. Restart it, or go back and continue from an earlier frame.</source>
        <translation>la ejecución tiene más entradas de las que caben en un archivo. Reiníciala, o vuelve a un fotograma anterior y sigue desde allí.</translation>
    </message>
    <message>
        <source>your code is longer than %1 bytes, the most that a file can store. Shorten it.</source>
        <translation>tu código tiene más de %1 bytes, el máximo que cabe en un archivo. Acórtalo.</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>&amp;New: the step as published</source>
        <translation>&amp;Nuevo: el paso como se publicó</translation>
    </message>
    <message>
        <source>&amp;Open an experiment or a lesson…</source>
        <translation>&amp;Abrir un experimento o una lección…</translation>
    </message>
    <message>
        <source>An experiment, or a lesson: its lesson.json or its .springstep-lesson file</source>
        <translation>Un experimento, o una lección: su lesson.json o su archivo .springstep-lesson</translation>
    </message>
    <message>
        <source>Reco&amp;ver scenes…</source>
        <translation>Rec&amp;uperar escenas…</translation>
    </message>
    <message>
        <source>&amp;Save the experiment</source>
        <translation>&amp;Guardar el experimento</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Guardar &amp;como…</translation>
    </message>
    <message>
        <source>&amp;Picture of the scene…</source>
        <translation>&amp;Imagen de la escena…</translation>
    </message>
    <message>
        <source>&amp;Film of the run…</source>
        <translation>&amp;Vídeo de la ejecución…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Salir</translation>
    </message>
    <message>
        <source>The scene as it is shown, as PNG or SVG</source>
        <translation>La escena tal como se ve, en PNG o SVG</translation>
    </message>
    <message>
        <source>The run as a video, an animated GIF or a PNG for each frame</source>
        <translation>La ejecución como vídeo, como GIF animado o como un PNG por fotograma</translation>
    </message>
    <message>
        <source>&amp;Keep in gallery</source>
        <translation>Guardar en la gal&amp;ería</translation>
    </message>
    <message>
        <source>&amp;Gallery…</source>
        <translation>Ga&amp;lería…</translation>
    </message>
    <message>
        <source>Keep the experiment with a picture, without choosing a file</source>
        <translation>Guardar el experimento con una imagen, sin elegir un archivo</translation>
    </message>
    <message>
        <source>What you keep: open, rename or remove it</source>
        <translation>Lo que guardas: abrirlo, renombrarlo o quitarlo</translation>
    </message>
    <message>
        <source>&amp;Hand in a notebook…</source>
        <translation>En&amp;tregar un cuaderno…</translation>
    </message>
    <message>
        <source>Write what you did into a file for your teacher, or onto a page</source>
        <translation>Escribir lo que has hecho en un archivo para tu docente, o en una página</translation>
    </message>
    <message>
        <source>&amp;Web page of the run…</source>
        <translation>Página &amp;web de la ejecución…</translation>
    </message>
    <message>
        <source>One file that plays the run in any browser, with the listing and the plots</source>
        <translation>Un archivo que reproduce la ejecución en cualquier navegador, con el listado y las gráficas</translation>
    </message>
    <message>
        <source>&amp;Handout of the lesson…</source>
        <translation>&amp;Hoja de trabajo de la lección…</translation>
    </message>
    <message>
        <source>The lesson on paper, as a PDF: with lines to write on, and the answers at the end</source>
        <translation>La lección en papel, como PDF: con líneas para escribir y las respuestas al final</translation>
    </message>
</context>
<context>
    <name>FileRowText</name>
    <message>
        <source>File</source>
        <translation>Archivo</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>&amp;Elegir…</translation>
    </message>
    <message>
        <source>Choose a folder and a name</source>
        <translation>Elegir una carpeta y un nombre</translation>
    </message>
</context>
<context>
    <name>FilmFileText</name>
    <message>
        <source>Could not write %1: %2. Free some disk space, or choose another folder.</source>
        <translation>No se pudo escribir %1: %2. Libera espacio en el disco o elige otra carpeta.</translation>
    </message>
    <message>
        <source>%1 is not a film&apos;s name: choose one that ends in .webm or .gif. For a picture of each frame, choose one that ends in .png and has %04d for the frame&apos;s number, such as walk_%04d.png.</source>
        <translation>%1 no es un nombre de vídeo: elige uno que termine en .webm o .gif. Para tener una imagen de cada fotograma, elige uno que termine en .png y contenga %04d para el número del fotograma, como walk_%04d.png.</translation>
    </message>
</context>
<context>
    <name>FilmText</name>
    <message>
        <source>Frame %1 of %2, %3 %</source>
        <translation>Fotograma %1 de %2, %3 %</translation>
    </message>
    <message>
        <source>Setting up the run</source>
        <translation>Preparando la ejecución</translation>
    </message>
    <message>
        <source>The last frame, %1, comes before the first, %2. Swap them.</source>
        <translation>El último fotograma, %1, va antes que el primero, %2. Intercámbialos.</translation>
    </message>
    <message>
        <source>A GIF shows at most %1 pictures a second, and this would be %2. Choose fewer, or PNG files.</source>
        <translation>Un GIF muestra como máximo %1 imágenes por segundo, y serían %2. Elige menos, o archivos PNG.</translation>
    </message>
    <message>
        <source>The run does not reach frame %1: it stops at frame %2. Begin the film earlier.</source>
        <translation>La ejecución no llega al fotograma %1: se para en el %2. Empieza el vídeo antes.</translation>
    </message>
    <message>
        <source>--fps is for a film in one file; PNG files have no time in them. Leave it out.</source>
        <translation>--fps es para un vídeo en un solo archivo; los archivos PNG no contienen tiempo. Omítelo.</translation>
    </message>
    <message>
        <source>%1 For a web page, choose one that ends in .html.</source>
        <translation>%1 Para una página web, elige uno que termine en .html.</translation>
    </message>
    <message>
        <source>--%1 is for web pages, which end in .html. Leave it out.</source>
        <translation>--%1 es para páginas web, que terminan en .html. Omítelo.</translation>
    </message>
</context>
<context>
    <name>Gestures</name>
    <message>
        <source>Drag a body</source>
        <translation>Arrastrar un cuerpo</translation>
    </message>
    <message>
        <source>grab it; let go while moving to throw it</source>
        <translation>sujetarlo; soltarlo en movimiento para lanzarlo</translation>
    </message>
    <message>
        <source>Drag the background</source>
        <translation>Arrastrar el fondo</translation>
    </message>
    <message>
        <source>move the picture</source>
        <translation>mover la imagen</translation>
    </message>
    <message>
        <source>Click an arrow at the edge</source>
        <translation>Clic en una flecha del borde</translation>
    </message>
    <message>
        <source>go to the body that it points to</source>
        <translation>ir al cuerpo al que apunta</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rueda</translation>
    </message>
    <message>
        <source>zoom where the pointer is</source>
        <translation>ampliar donde está el puntero</translation>
    </message>
    <message>
        <source>[ and ]</source>
        <translation>[ y ]</translation>
    </message>
    <message>
        <source>select the previous or the next body</source>
        <translation>seleccionar el cuerpo anterior o el siguiente</translation>
    </message>
    <message>
        <source>Alt and an arrow key</source>
        <translation>Alt y una flecha</translation>
    </message>
    <message>
        <source>move the selected body 10 px</source>
        <translation>mover 10 px el cuerpo seleccionado</translation>
    </message>
    <message>
        <source>Press the background</source>
        <translation>Pulsar el fondo</translation>
    </message>
    <message>
        <source>blow, steer or aim, in steps that have this</source>
        <translation>soplar, dirigir o apuntar, en los pasos que lo tienen</translation>
    </message>
    <message>
        <source>Drag with the middle button</source>
        <translation>Arrastrar con el botón central</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Flechas</translation>
    </message>
    <message>
        <source>steer, in steps that have this</source>
        <translation>dirigir, en los pasos que lo tienen</translation>
    </message>
    <message>
        <source>Alt, Shift and an arrow key</source>
        <translation>Alt, Mayús y una flecha</translation>
    </message>
    <message>
        <source>move the pointer or the target 20 px</source>
        <translation>mover 20 px el puntero o el objetivo</translation>
    </message>
    <message>
        <source>Alt and Enter</source>
        <translation>Alt e Intro</translation>
    </message>
    <message>
        <source>press or release the pointer&apos;s button</source>
        <translation>pulsar o soltar el botón del puntero</translation>
    </message>
    <message>
        <source>Drag an end of the ruler</source>
        <translation>Arrastrar un extremo de la regla graduada</translation>
    </message>
    <message>
        <source>measure a length and an angle (switch it on under Show)</source>
        <translation>medir una longitud y un ángulo (se activa en «Mostrar»)</translation>
    </message>
    <message>
        <source>Ctrl, Alt and an arrow key</source>
        <translation>Ctrl, Alt y una flecha</translation>
    </message>
    <message>
        <source>move the ruler&apos;s far end 5 px; with Shift the near one</source>
        <translation>mover 5 px el extremo lejano de la regla graduada; con Mayús, el cercano</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>let go</source>
        <translation>soltar</translation>
    </message>
    <message>
        <source>Click the dots below a ring</source>
        <translation>Clic en los puntos bajo un anillo</translation>
    </message>
    <message>
        <source>compare with the run that branches off there; right-click: more</source>
        <translation>comparar con la ejecución que se separa ahí; clic derecho: más</translation>
    </message>
    <message>
        <source>Shift and a click</source>
        <translation>Mayús y un clic</translation>
    </message>
    <message>
        <source>add a part to the selection, or remove it</source>
        <translation>añadir una pieza a la selección, o quitarla</translation>
    </message>
    <message>
        <source>select all parts in the box</source>
        <translation>seleccionar todas las piezas del recuadro</translation>
    </message>
    <message>
        <source>Drag from point to point</source>
        <translation>Arrastrar de punto a punto</translation>
    </message>
    <message>
        <source>connect them, with the Spring or the Stick tool</source>
        <translation>unirlos, con la herramienta Muelle o Barra</translation>
    </message>
    <message>
        <source>Arrow keys and Enter</source>
        <translation>Flechas e Intro</translation>
    </message>
    <message>
        <source>move the tool 10 px, with Shift 1 px; use it</source>
        <translation>mover la herramienta 10 px, con Mayús 1 px; usarla</translation>
    </message>
    <message>
        <source>move the selected parts 10 px, with Shift 1 px</source>
        <translation>mover las piezas seleccionadas 10 px, con Mayús 1 px</translation>
    </message>
    <message>
        <source>{ and }</source>
        <translation>{ y }</translation>
    </message>
    <message>
        <source>select the previous or the next spring or stick</source>
        <translation>seleccionar el muelle o la barra anterior o siguiente</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>end a row of links, put the tool away, clear the selection</source>
        <translation>terminar una fila de uniones, dejar la herramienta, anular la selección</translation>
    </message>
    <message>
        <source>Drag the timeline</source>
        <translation>Arrastrar la línea de tiempo</translation>
    </message>
    <message>
        <source>go anywhere in time</source>
        <translation>ir a cualquier instante</translation>
    </message>
    <message>
        <source>Click a phase</source>
        <translation>Clic en una fase</translation>
    </message>
    <message>
        <source>run to it</source>
        <translation>ejecutar hasta ella</translation>
    </message>
    <message>
        <source>Point at timeline, phase, plot or trail</source>
        <translation>Señalar línea de tiempo, fase, gráfica o estela</translation>
    </message>
    <message>
        <source>preview that moment; the run stays at its frame</source>
        <translation>vista previa de ese instante; la ejecución sigue en su fotograma</translation>
    </message>
    <message>
        <source>Alt and the underlined letter</source>
        <translation>Alt y la letra subrayada</translation>
    </message>
    <message>
        <source>use a remedy, when a run has failed</source>
        <translation>usar un remedio, cuando una ejecución ha fallado</translation>
    </message>
    <message>
        <source>Drop a file on the window</source>
        <translation>Soltar un archivo en la ventana</translation>
    </message>
    <message>
        <source>open it</source>
        <translation>abrirlo</translation>
    </message>
    <message>
        <source>Press or drag</source>
        <translation>Pulsar o arrastrar</translation>
    </message>
    <message>
        <source>go to a frame</source>
        <translation>ir a un fotograma</translation>
    </message>
    <message>
        <source>+ and −, or Ctrl and the wheel</source>
        <translation>+ y −, o Ctrl y la rueda</translation>
    </message>
    <message>
        <source>fewer or more frames</source>
        <translation>menos o más fotogramas</translation>
    </message>
    <message>
        <source>The names above a plot</source>
        <translation>Los nombres sobre una gráfica</translation>
    </message>
    <message>
        <source>choose what it shows</source>
        <translation>elegir lo que muestra</translation>
    </message>
    <message>
        <source>Menu key, or right-click</source>
        <translation>Tecla Menú, o clic derecho</translation>
    </message>
    <message>
        <source>save, copy, keep or remove it</source>
        <translation>guardarla, copiarla, fijarla o quitarla</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supr</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>quitarla</translation>
    </message>
    <message>
        <source>Click a line, or Enter</source>
        <translation>Clic en una línea, o Intro</translation>
    </message>
    <message>
        <source>run to its phase</source>
        <translation>ejecutar hasta su fase</translation>
    </message>
    <message>
        <source>Click left of a line, or %1</source>
        <translation>Clic a la izquierda de una línea, o %1</translation>
    </message>
    <message>
        <source>set or remove a breakpoint before its phase</source>
        <translation>poner o quitar un punto de interrupción antes de su fase</translation>
    </message>
    <message>
        <source>Drag a dotted word</source>
        <translation>Arrastrar una palabra punteada</translation>
    </message>
    <message>
        <source>change that parameter; with Shift in small steps</source>
        <translation>cambiar ese parámetro; con Mayús, en pasos pequeños</translation>
    </message>
    <message>
        <source>Double-click it, or %1</source>
        <translation>Doble clic en ella, o %1</translation>
    </message>
    <message>
        <source>type the parameter&apos;s value</source>
        <translation>escribir el valor del parámetro</translation>
    </message>
    <message>
        <source>Point at a word, or %1</source>
        <translation>Señalar una palabra, o %1</translation>
    </message>
    <message>
        <source>its value, and its last 120 frames</source>
        <translation>su valor y sus últimos 120 fotogramas</translation>
    </message>
    <message>
        <source>Up and Down</source>
        <translation>Arriba y Abajo</translation>
    </message>
    <message>
        <source>from line to line; with Ctrl from heading to heading</source>
        <translation>de línea en línea; con Ctrl, de título en título</translation>
    </message>
    <message>
        <source>Ctrl and Left or Right</source>
        <translation>Ctrl e Izquierda o Derecha</translation>
    </message>
    <message>
        <source>from word to word</source>
        <translation>de palabra en palabra</translation>
    </message>
    <message>
        <source>Enter, on a heading</source>
        <translation>Intro, en un título</translation>
    </message>
    <message>
        <source>fold or unfold</source>
        <translation>plegar o desplegar</translation>
    </message>
    <message>
        <source>show the lines that this step removed</source>
        <translation>mostrar las líneas que este paso quitó</translation>
    </message>
    <message>
        <source>copy the selection, or the whole region</source>
        <translation>copiar la selección, o la región entera</translation>
    </message>
    <message>
        <source>Stop when…</source>
        <translation>Parar cuando…</translation>
    </message>
    <message>
        <source>the field below the code: stop when a condition becomes true</source>
        <translation>el campo bajo el código: parar cuando se cumple una condición</translation>
    </message>
    <message>
        <source>walk through the points of a plot</source>
        <translation>recorrer los puntos de una gráfica</translation>
    </message>
    <message>
        <source>Enter or a click</source>
        <translation>Intro o un clic</translation>
    </message>
    <message>
        <source>use the method and step of a point</source>
        <translation>usar el método y el paso de tiempo de un punto</translation>
    </message>
    <message>
        <source>+ and −, or drag the line</source>
        <translation>+ y −, o arrastrar la línea</translation>
    </message>
    <message>
        <source>set the largest error that you accept</source>
        <translation>fijar el mayor error que aceptas</translation>
    </message>
    <message>
        <source>Click left of a line, in the listing</source>
        <translation>Clic a la izquierda de una línea, en el listado</translation>
    </message>
    <message>
        <source>Point at a place or a velocity, in the listing</source>
        <translation>Señalar un lugar o una velocidad, en el listado</translation>
    </message>
    <message>
        <source>see it in the picture</source>
        <translation>verlo en la imagen</translation>
    </message>
    <message>
        <source>Drag a number, in the listing</source>
        <translation>Arrastrar un número, en el listado</translation>
    </message>
    <message>
        <source>change it; with Shift in small steps</source>
        <translation>cambiarlo; con Mayús, en pasos pequeños</translation>
    </message>
    <message>
        <source>%1, in the listing</source>
        <translation>%1, en el listado</translation>
    </message>
    <message>
        <source>complete a name</source>
        <translation>completar un nombre</translation>
    </message>
    <message>
        <source>Esc, in the listing</source>
        <translation>Esc, en el listado</translation>
    </message>
    <message>
        <source>leave it, so that keys move the run again</source>
        <translation>salir de él, para que las teclas vuelvan a mover la ejecución</translation>
    </message>
    <message>
        <source>Ctrl and a click left of a line, or %1, in the listing</source>
        <translation>Ctrl y clic en el margen, o %1, en el listado</translation>
    </message>
    <message>
        <source>set or remove a breakpoint before it</source>
        <translation>poner o quitar un punto de interrupción antes de la línea</translation>
    </message>
</context>
<context>
    <name>GroundLayersText</name>
    <message>
        <source>%1&#x202f;px</source>
        <translation>%1&#x202f;px</translation>
    </message>
</context>
<context>
    <name>Gui</name>
    <message>
        <source>No lesson was found in %1. Build the lessons, or name their folder in SPRINGSTEP_LESSONS.</source>
        <translation>No se encontró ninguna lección en %1. Compila las lecciones, o indica su carpeta en SPRINGSTEP_LESSONS.</translation>
    </message>
    <message>
        <source>%1 could not be written: give a folder that you may write to, and a name that ends in .png or .jpg.</source>
        <translation>No se pudo escribir %1: indica una carpeta en la que puedas escribir, y un nombre que termine en .png o .jpg.</translation>
    </message>
</context>
<context>
    <name>Handout</name>
    <message>
        <source>Name:</source>
        <translation>Nombre:</translation>
    </message>
    <message>
        <source>Date:</source>
        <translation>Fecha:</translation>
    </message>
    <message>
        <source>Answers: %1</source>
        <translation>Respuestas: %1</translation>
    </message>
    <message>
        <source>Predict</source>
        <translation>Predice</translation>
    </message>
    <message>
        <source>Mark the place in the picture.</source>
        <translation>Marca el lugar en la imagen.</translation>
    </message>
    <message>
        <source>Try this</source>
        <translation>Prueba esto</translation>
    </message>
    <message>
        <source>Write it yourself: %1</source>
        <translation>Escríbelo tú: %1</translation>
    </message>
    <message>
        <source>Build: %1</source>
        <translation>Construye: %1</translation>
    </message>
</context>
<context>
    <name>HandoutCliText</name>
    <message>
        <source>handout: %1</source>
        <translation>handout: %1</translation>
    </message>
    <message>
        <source>%1 is not the name of a handout; it ends in .pdf.</source>
        <translation>%1 no es el nombre de una hoja de trabajo; termina en .pdf.</translation>
    </message>
    <message>
        <source>%1 of %2 pictures</source>
        <translation>%1 de %2 imágenes</translation>
    </message>
    <message>
        <source>Stopped before the handout was written.</source>
        <translation>Parado antes de escribir la hoja de trabajo.</translation>
    </message>
</context>
<context>
    <name>HandoutExportText</name>
    <message>
        <source>Handout of the lesson</source>
        <translation>Hoja de trabajo de la lección</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>The pictures of “%1” are drawn…</source>
        <translation>Dibujando las imágenes de «%1»…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
</context>
<context>
    <name>HardCasesText</name>
    <message>
        <source>There is no case %1; there is %2.</source>
        <translation>No hay ningún caso %1; hay %2.</translation>
    </message>
    <message>
        <source>%1, %2: %3 %</source>
        <translation>%1, %2: %3 %</translation>
    </message>
</context>
<context>
    <name>HardReportText</name>
    <message>
        <source>method</source>
        <translation>método</translation>
    </message>
    <message>
        <source>claims</source>
        <translation>garant.</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>fotogr.</translation>
    </message>
    <message>
        <source>ns/frame</source>
        <translation>ns/fot.</translation>
    </message>
    <message>
        <source>BROKEN</source>
        <translation>ROTA</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>falla</translation>
    </message>
    <message>
        <source>%1 of %2 runs are claimed</source>
        <translation>%1 de %2 ejecuciones están garantizadas</translation>
    </message>
    <message>
        <source>, and all of those hold.</source>
        <translation>, y todas ellas aguantan.</translation>
    </message>
    <message>
        <source>, and %1 of those fail: %2.</source>
        <translation>, y %1 de ellas fallan: %2.</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>aguanta</translation>
    </message>
</context>
<context>
    <name>HelpCommands</name>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Teclas y ratón</translation>
    </message>
    <message>
        <source>Show a &amp;hint</source>
        <translation>Mostrar &amp;pista</translation>
    </message>
    <message>
        <source>&amp;Glossary</source>
        <translation>&amp;Glosario</translation>
    </message>
    <message>
        <source>Take the &amp;tour</source>
        <translation>&amp;Visita guiada</translation>
    </message>
    <message>
        <source>&amp;About Springstep</source>
        <translation>&amp;Acerca de Springstep</translation>
    </message>
    <message>
        <source>A hint for the next thing to try</source>
        <translation>Una pista para lo siguiente que probar</translation>
    </message>
    <message>
        <source>The words that the lessons teach</source>
        <translation>Las palabras que enseñan las lecciones</translation>
    </message>
    <message>
        <source>A one-minute tour of this window</source>
        <translation>Una visita guiada de un minuto por esta ventana</translation>
    </message>
    <message>
        <source>Version, licence and libraries</source>
        <translation>Versión, licencia y bibliotecas</translation>
    </message>
    <message>
        <source>&amp;Map of concepts</source>
        <translation>&amp;Mapa de conceptos</translation>
    </message>
    <message>
        <source>The concepts of all lessons: what rests on what, and what you know</source>
        <translation>Los conceptos de todas las lecciones: qué se apoya en qué y qué sabes ya</translation>
    </message>
</context>
<context>
    <name>Highlights</name>
    <message>
        <source>%1&#x2009;px/frame</source>
        <translation>%1&#x2009;px/fotograma</translation>
    </message>
    <message>
        <source>the arrow from %1 to %2</source>
        <translation>la flecha de %1 a %2</translation>
    </message>
    <message>
        <source>x from %1 to %2</source>
        <translation>x: de %1 a %2</translation>
    </message>
    <message>
        <source>y from %1 to %2</source>
        <translation>y: de %1 a %2</translation>
    </message>
    <message>
        <source>the velocity of %1</source>
        <translation>la velocidad de %1</translation>
    </message>
    <message>
        <source>the circle around %1</source>
        <translation>el círculo alrededor de %1</translation>
    </message>
</context>
<context>
    <name>HudText</name>
    <message>
        <source>%1 (before: %2)</source>
        <translation>%1 (antes: %2)</translation>
    </message>
    <message>
        <source>your method</source>
        <translation>tu método</translation>
    </message>
    <message>
        <source>reference, ±%1</source>
        <translation>referencia, ±%1</translation>
    </message>
    <message>
        <source>every %1 frames</source>
        <translation>cada %1 fotogramas</translation>
    </message>
    <message>
        <source>rest length</source>
        <translation>longitud natural</translation>
    </message>
    <message>
        <source>velocity of %1&#x2009;px/frame</source>
        <translation>velocidad de %1&#x2009;px/fotograma</translation>
    </message>
    <message>
        <source>pull of %1&#x2009;px/frame²</source>
        <translation>tirón de %1&#x2009;px/fotograma²</translation>
    </message>
</context>
<context>
    <name>JsonDocumentText</name>
    <message>
        <source>%1 is too large for a number; the largest is %2.</source>
        <translation>%1 es demasiado grande para un número; el mayor es %2.</translation>
    </message>
    <message>
        <source>%1 is given twice; keep one of them.</source>
        <translation>%1 aparece dos veces; deja uno de ellos.</translation>
    </message>
    <message>
        <source>lists and objects are nested more than %1 deep here; an experiment needs only 3 levels.</source>
        <translation>aquí hay listas y objetos anidados a más de %1 niveles; un experimento solo necesita 3.</translation>
    </message>
    <message>
        <source>here begins one value too many; an experiment has at most %1 values.</source>
        <translation>aquí empieza un valor de más; un experimento tiene como máximo %1 valores.</translation>
    </message>
    <message>
        <source>there is text after the end; remove everything after the closing bracket.</source>
        <translation>hay texto después del final; quita todo lo que sigue al corchete o a la llave de cierre.</translation>
    </message>
    <message>
        <source>a name in double quotes is expected here.</source>
        <translation>aquí se espera un nombre entre comillas dobles.</translation>
    </message>
    <message>
        <source>a colon is expected here, between a name and its value.</source>
        <translation>aquí se esperan dos puntos, entre un nombre y su valor.</translation>
    </message>
    <message>
        <source>a comma or a closing } is expected here.</source>
        <translation>aquí se espera una coma o una } de cierre.</translation>
    </message>
    <message>
        <source>a comma or a closing ] is expected here.</source>
        <translation>aquí se espera una coma o un ] de cierre.</translation>
    </message>
    <message>
        <source>a text in double quotes is not valid; it must end on its own line, and only &quot; \ / b f n r t u may follow a \.</source>
        <translation>un texto entre comillas dobles no es válido; debe terminar en su propia línea, y a una \ solo le puede seguir &quot; \ / b f n r t u.</translation>
    </message>
    <message>
        <source>a text has bytes that are not UTF-8; save the file as UTF-8.</source>
        <translation>un texto tiene bytes que no son UTF-8; guarda el archivo como UTF-8.</translation>
    </message>
    <message>
        <source>a number is too large; the largest is %1.</source>
        <translation>un número es demasiado grande; el mayor es %1.</translation>
    </message>
    <message>
        <source>a number is not complete; write it as 0.5 or 5e-1.</source>
        <translation>un número no está completo; escríbelo como 0.5 o 5e-1.</translation>
    </message>
    <message>
        <source>this is not JSON; a value is a number, a &quot;text&quot;, true, false, null, a [list] or an {object}.</source>
        <translation>esto no es JSON; un valor es un número, un &quot;text&quot;, true, false, null, una [lista] o un {objeto}.</translation>
    </message>
    <message>
        <source>%1: line %2: there is a zero byte; an experiment is JSON text in UTF-8.</source>
        <translation>%1: línea %2: hay un byte cero; un experimento es texto JSON en UTF-8.</translation>
    </message>
    <message>
        <source>%1: line 1: the file is empty; it must begin with {.</source>
        <translation>%1: línea 1: el archivo está vacío; tiene que empezar con {.</translation>
    </message>
    <message>
        <source>the file ends here too early; the rest of it is missing.</source>
        <translation>el archivo termina aquí demasiado pronto; falta el resto.</translation>
    </message>
    <message>
        <source>%1: line %2: %3</source>
        <translation>%1: línea %2: %3</translation>
    </message>
    <message>
        <source>%1: this is a zip. The window opens a zipped lesson if its name ends in .springstep-lesson.</source>
        <translation>%1: esto es un zip. La ventana abre una lección en zip si su nombre termina en .springstep-lesson.</translation>
    </message>
    <message>
        <source>nothing follows the last comma before this %1; remove the comma.</source>
        <translation>no sigue nada a la última coma antes de este %1; quita la coma.</translation>
    </message>
</context>
<context>
    <name>JsonFieldsText</name>
    <message>
        <source>%1 is %2; it must be %3.</source>
        <translation>%1 es %2; debe ser %3.</translation>
    </message>
    <message>
        <source>%1: line %2: %3</source>
        <translation>%1: línea %2: %3</translation>
    </message>
    <message>
        <source>the text %1</source>
        <translation>el texto %1</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>una lista</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objeto</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un número</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true o false</translation>
    </message>
    <message>
        <source>a text in double quotes</source>
        <translation>un texto entre comillas dobles</translation>
    </message>
    <message>
        <source>a list in [ ]</source>
        <translation>una lista en [ ]</translation>
    </message>
    <message>
        <source>%1 is %2; it can be a whole number from %3 to %4.</source>
        <translation>%1 es %2; puede ser un número entero de %3 a %4.</translation>
    </message>
    <message>
        <source>beyond 2^53</source>
        <translation>más de 2^53</translation>
    </message>
    <message>
        <source>%1 is %2; it must be an object in { }.</source>
        <translation>%1 es %2; debe ser un objeto en { }.</translation>
    </message>
    <message>
        <source>%1 has no %2; add it. It must be %3.</source>
        <translation>%1 no tiene %2; añádelo. Debe ser %3.</translation>
    </message>
    <message>
        <source>%1 has no field %2; there is %3.</source>
        <translation>%1 no tiene el campo %2; hay %3.</translation>
    </message>
    <message>
        <source>%1 is %2; it can be %3 to %4.</source>
        <translation>%1 es %2; puede ir de %3 a %4.</translation>
    </message>
</context>
<context>
    <name>KeyNames</name>
    <message>
        <source>Page Up</source>
        <translation>Re Pág</translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation>Av Pág</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Mayús</translation>
    </message>
</context>
<context>
    <name>LessonCheckText</name>
    <message>
        <source>the listing does not compile</source>
        <translation>el listado no se puede compilar</translation>
    </message>
    <message>
        <source>one of them stops in frame %1</source>
        <translation>uno de los dos se para en el fotograma %1</translation>
    </message>
    <message>
        <source>the listing moves %1 otherwise than the method %2: %3 px apart in frame %4 of a trial run</source>
        <translation>el listado mueve %1 de otra forma que el método %2: %3 px de separación en el fotograma %4 de una ejecución de prueba</translation>
    </message>
    <message>
        <source>same motion as %1</source>
        <translation>mismo movimiento que %1</translation>
    </message>
    <message>
        <source>it is done in frame %1 without the learner; add a condition such as “- begun: released()”</source>
        <translation>se cumple en el fotograma %1 sin que nadie haga nada; añade una condición como «- begun: released()»</translation>
    </message>
    <message>
        <source>it states no solution; write a “### Solution”</source>
        <translation>no indica ninguna solución; escribe un «### Solution»</translation>
    </message>
    <message>
        <source>done in frame %1</source>
        <translation>hecho en el fotograma %1</translation>
    </message>
    <message>
        <source>its solution does not do it in %1 frames</source>
        <translation>su solución no lo consigue en %1 fotogramas</translation>
    </message>
    <message>
        <source>its solution does not do it in %1 frames: %2</source>
        <translation>su solución no lo consigue en %1 fotogramas: %2</translation>
    </message>
    <message>
        <source>its solution does not do it in %1 frames: each condition holds in some frame, but they never all hold in the same one</source>
        <translation>su solución no lo consigue en %1 fotogramas: cada condición se cumple en algún fotograma, pero nunca se cumplen todas en el mismo</translation>
    </message>
    <message>
        <source>its condition does not hold up to frame %1</source>
        <translation>su condición sigue sin cumplirse en el fotograma %1</translation>
    </message>
    <message>
        <source>ends in frame %1</source>
        <translation>termina en el fotograma %1</translation>
    </message>
    <message>
        <source>%1, at (%2, %3)</source>
        <translation>%1, en (%2, %3)</translation>
    </message>
    <message>
        <source>%1, with %2</source>
        <translation>%1, con %2</translation>
    </message>
    <message>
        <source>two of its curves look the same</source>
        <translation>dos de sus gráficas parecen iguales</translation>
    </message>
    <message>
        <source>the listing itself does not pass</source>
        <translation>el propio listado no pasa</translation>
    </message>
    <message>
        <source>the empty place passes</source>
        <translation>el lugar vacío pasa</translation>
    </message>
    <message>
        <source>near miss %1 is not told from the others or from the solution</source>
        <translation>el casi acierto %1 no se distingue de los otros o de la solución</translation>
    </message>
    <message>
        <source>passes, with %1 near misses</source>
        <translation>pasa, con %1 casi aciertos</translation>
    </message>
    <message>
        <source>there is no step %1</source>
        <translation>no hay ningún paso %1</translation>
    </message>
    <message>
        <source>the start scene passes</source>
        <translation>la escena inicial pasa</translation>
    </message>
    <message>
        <source>it states no solution; save one as %1</source>
        <translation>no indica ninguna solución; guarda una como %1</translation>
    </message>
    <message>
        <source>%1 passes</source>
        <translation>%1 pasa</translation>
    </message>
    <message>
        <source>has %1 choices</source>
        <translation>tiene %1 respuestas para elegir</translation>
    </message>
    <message>
        <source>%1, in which the hand holds it. Every body can be held: write “if (%2.held) %2.position = hand;”, and leave the forces out then</source>
        <translation>%1, mientras lo sujeta la mano. Se puede sujetar cualquier cuerpo: escribe «if (%2.held) %2.position = hand;», y deja entonces fuera las fuerzas</translation>
    </message>
</context>
<context>
    <name>LessonFolderText</name>
    <message>
        <source>%1: this is not UTF-8. Save the file with the encoding UTF-8.</source>
        <translation>%1: esto no es UTF-8. Guarda el archivo con la codificación UTF-8.</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>el archivo</translation>
    </message>
    <message>
        <source>&quot;format&quot; is %1; this program reads %2.</source>
        <translation>&quot;format&quot; es %1; este programa lee %2.</translation>
    </message>
    <message>
        <source>a name of your own</source>
        <translation>un nombre propio</translation>
    </message>
    <message>
        <source>a lesson cannot have the id %1; an id has up to 40 characters, a to z, 0 to 9 and _, and begins with a letter.</source>
        <translation>una lección no puede tener el id %1; un id tiene hasta 40 caracteres, de la a a la z, de 0 a 9 y _, y empieza por una letra.</translation>
    </message>
    <message>
        <source>there is another lesson with the id %1, “%2”. Choose another id.</source>
        <translation>hay otra lección con el id %1, «%2». Elige otro id.</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texto</translation>
    </message>
    <message>
        <source>%1 has %2 characters; it can have 1 to %3.</source>
        <translation>%1 tiene %2 caracteres; puede tener de 1 a %3.</translation>
    </message>
    <message>
        <source>a list of ids</source>
        <translation>una lista de ids</translation>
    </message>
    <message>
        <source>a step cannot have the id %1; each has one of its own, made of a to z, 0 to 9 and _, and not lesson, recall or project.</source>
        <translation>un paso no puede tener el id %1; cada uno tiene el suyo, hecho de la a a la z, de 0 a 9 y _, y no lesson, recall ni project.</translation>
    </message>
    <message>
        <source>a lesson has 1 to %1 steps, and &quot;steps&quot; lists %2.</source>
        <translation>una lección tiene de 1 a %1 pasos, y &quot;steps&quot; nombra %2.</translation>
    </message>
    <message>
        <source>%1: the file is missing. It has %2.</source>
        <translation>%1: falta el archivo. Contiene %2.</translation>
    </message>
    <message>
        <source>%1: the listing has more than %2 bytes.</source>
        <translation>%1: el listado tiene más de %2 bytes.</translation>
    </message>
    <message>
        <source>%1: a listing computes whole frames, and the scene has steps of another length. Set &quot;h&quot; to 1 in %2.json.</source>
        <translation>%1: un listado calcula fotogramas enteros, y la escena tiene pasos de tiempo de otra longitud. Pon &quot;h&quot; a 1 en %2.json.</translation>
    </message>
    <message>
        <source>%1: a near miss of the task %2 does not compile: %3</source>
        <translation>%1: un casi acierto de la tarea %2 no se puede compilar: %3</translation>
    </message>
    <message>
        <source>%1: a lesson has files .md, .json and .code. Remove it.</source>
        <translation>%1: una lección tiene archivos .md, .json y .code. Quítalo.</translation>
    </message>
    <message>
        <source>%1: there is no step %2 in &quot;steps&quot; of lesson.json; there is %3. Add it there, or rename the file.</source>
        <translation>%1: no hay ningún paso %2 en &quot;steps&quot; de lesson.json; hay %3. Añádelo allí, o renombra el archivo.</translation>
    </message>
    <message>
        <source>the scene that the project starts with</source>
        <translation>la escena con la que empieza el proyecto</translation>
    </message>
    <message>
        <source>a text cannot show pictures. The scene is the picture; remove “![”.</source>
        <translation>un texto no puede mostrar imágenes. La escena es la imagen; quita «![».</translation>
    </message>
    <message>
        <source>the scene of the step: save it in the window under this name, with the ending .json</source>
        <translation>la escena del paso: guárdala en la ventana con este nombre, terminado en .json</translation>
    </message>
    <message>
        <source>the texts of the step. Write the file, or remove the step from lesson.json</source>
        <translation>los textos del paso. Escribe el archivo, o quita el paso de lesson.json</translation>
    </message>
    <message>
        <source>%1: a listing computes this scene. Choose a method in the window, and write the listing into %2.code.</source>
        <translation>%1: un listado calcula esta escena. Elige un método en la ventana y escribe el listado en %2.code.</translation>
    </message>
    <message>
        <source>%1: a step has at most %2 things to try, predictions and tasks, and a thing to try as many conditions and drags.</source>
        <translation>%1: un paso tiene como máximo %2 pruebas, predicciones y tareas, y una prueba, otras tantas condiciones y arrastres.</translation>
    </message>
    <message>
        <source>%1 says where the parameter %2 begins. Remove it here.</source>
        <translation>%1 dice dónde empieza el parámetro %2. Quítalo aquí.</translation>
    </message>
    <message>
        <source>%1: the scene is one of the lesson %2, which is not built in. Open that lesson, choose File &gt; New lesson from this scene, and take the scene that this writes.</source>
        <translation>%1: la escena es de la lección %2, que no viene incluida. Abre esa lección, elige Archivo &gt; Nueva lección de esta escena, y usa la escena que se escribe así.</translation>
    </message>
</context>
<context>
    <name>LessonLanguagesText</name>
    <message>
        <source>%1, step %2: the languages differ in %3. Make them the same.</source>
        <translation>%1, paso %2: los idiomas difieren en %3. Haz que coincidan.</translation>
    </message>
    <message>
        <source>their predictions</source>
        <translation>sus predicciones</translation>
    </message>
    <message>
        <source>their tasks</source>
        <translation>sus tareas</translation>
    </message>
    <message>
        <source>their questions</source>
        <translation>sus preguntas</translation>
    </message>
</context>
<context>
    <name>LessonPackageText</name>
    <message>
        <source>%1 is a link or a device. Put the file itself there.</source>
        <translation>%1 es un enlace o un dispositivo. Pon allí el archivo mismo.</translation>
    </message>
    <message>
        <source>%1: a lesson has at most %2 files, with %3 MiB in all of them.</source>
        <translation>%1: una lección tiene como máximo %2 archivos, con %3 MiB en total.</translation>
    </message>
    <message>
        <source>%1: there is no such folder or file; check its name.</source>
        <translation>%1: no existe esa carpeta o ese archivo; comprueba el nombre.</translation>
    </message>
    <message>
        <source>%1: there is no lesson.json, which describes the lesson. Choose the folder that has it, or write it.</source>
        <translation>%1: no hay ningún lesson.json, que describe la lección. Elige la carpeta que lo tiene, o escríbelo.</translation>
    </message>
</context>
<context>
    <name>LessonParametersText</name>
    <message>
        <source>a parameter cannot be called “%1”: the word has another meaning in code, in conditions or in runs. Choose another id.</source>
        <translation>un parámetro no se puede llamar «%1»: la palabra significa otra cosa en el código, en las condiciones o en las ejecuciones. Elige otro id.</translation>
    </message>
    <message>
        <source>the parameter “%1” has no range. Write “- minimum: 0” and “- maximum: 1” below its text, with your numbers.</source>
        <translation>el parámetro «%1» no tiene rango. Escribe «- minimum: 0» y «- maximum: 1» debajo de su texto, con tus números.</translation>
    </message>
    <message>
        <source>the minimum of “%1” is not below its maximum. Change one of them.</source>
        <translation>el mínimo de «%1» no está por debajo del máximo. Cambia uno de los dos.</translation>
    </message>
    <message>
        <source>“%1” begins with the value that the scene has there. Remove “- value”.</source>
        <translation>«%1» empieza con el valor que la escena tiene ahí. Quita «- value».</translation>
    </message>
    <message>
        <source>the parameter “%1” has no value at the start. Write “- value: %2”, or “- sets: k of a-b” with the names of two bodies that a spring joins.</source>
        <translation>el parámetro «%1» no tiene valor al principio. Escribe «- value: %2», o «- sets: k of a-b» con los nombres de dos cuerpos unidos por un muelle.</translation>
    </message>
    <message>
        <source>the step of “%1” is 1, so its numbers are whole. Choose a smaller step, such as 0.1.</source>
        <translation>el paso de «%1» es 1, así que sus números son enteros. Elige un paso más pequeño, por ejemplo 0.1.</translation>
    </message>
    <message>
        <source>the value of “%1” is %2, outside its range from %3 to %4. Change one of them.</source>
        <translation>el valor de «%1» es %2 y está fuera de su rango, de %3 a %4. Cambia uno de los dos.</translation>
    </message>
    <message>
        <source>the %1 of “%2” differs between the languages. Remove it here: the numbers are in the first language.</source>
        <translation>«%1» de «%2» es distinto según el idioma. Quítalo aquí: los números están en el primer idioma.</translation>
    </message>
    <message>
        <source>the parameter “%1” is missing. Write “## Parameter: name {#%1}”, and a sentence below it.</source>
        <translation>falta el parámetro «%1». Escribe «## Parameter: nombre {#%1}» y una frase debajo.</translation>
    </message>
    <message>
        <source>%1 declares no parameter “%2”. Remove it here, or add it there.</source>
        <translation>%1 no declara ningún parámetro «%2». Quítalo aquí o añádelo allí.</translation>
    </message>
    <message>
        <source>“sets” differs between the languages. Remove it here.</source>
        <translation>«sets» es distinto según el idioma. Quítalo aquí.</translation>
    </message>
    <message>
        <source>“%1” is not something that a parameter can set. Write “k of a-b” or “length of a-b” with the names of two bodies, and commas between several.</source>
        <translation>«%1» no es algo que un parámetro pueda fijar. Escribe «k of a-b» o «length of a-b» con los nombres de dos cuerpos, y comas entre varios.</translation>
    </message>
    <message>
        <source>no spring of the scene joins “%1” and “%2”. Springs join %3.</source>
        <translation>ningún muelle de la escena une «%1» y «%2». Los muelles unen: %3.</translation>
    </message>
    <message>
        <source>no spring or stick of the scene joins “%1” and “%2”. They join %3.</source>
        <translation>ningún muelle ni barra de la escena une «%1» y «%2». Unen: %3.</translation>
    </message>
    <message>
        <source>“%1” can be %2 to %3 in a scene, and the parameter goes from %4 to %5. Change its minimum or maximum.</source>
        <translation>«%1» puede ser de %2 a %3 en una escena, y el parámetro va de %4 a %5. Cambia su mínimo o su máximo.</translation>
    </message>
    <message>
        <source>a parameter of your own needs a scene of the sandbox. Remove “%1”, or take the scene to the sandbox (Ctrl+B) and save it there.</source>
        <translation>un parámetro propio necesita una escena del taller. Quita «%1», o lleva la escena al taller (Ctrl+B) y guárdala allí.</translation>
    </message>
    <message>
        <source>“%1” sets several numbers, of which one is %2 and another is %3 in the scene. Make them the same there, or use two parameters.</source>
        <translation>«%1» fija varios números, de los que uno es %2 y otro %3 en la escena. Haz que sean iguales allí, o usa dos parámetros.</translation>
    </message>
    <message>
        <source>the scene has %1 there, which does not fit the parameter “%2” from %3 to %4. Change its minimum, maximum or step, or the scene.</source>
        <translation>la escena tiene ahí %1, que no cabe en el parámetro «%2», de %3 a %4. Cambia su mínimo, su máximo o su paso, o la escena.</translation>
    </message>
    <message>
        <source>the scene has a parameter “%1” already. Choose another id.</source>
        <translation>la escena ya tiene un parámetro «%1». Elige otro id.</translation>
    </message>
    <message>
        <source>bodies of the scene are called “%1”. Choose another id.</source>
        <translation>hay cuerpos de la escena que se llaman «%1». Elige otro id.</translation>
    </message>
    <message>
        <source>nothing reads the parameter “%1”. Write %1 into the rule of the scene in place of a number, or let it set one: “- sets: k of a-b”.</source>
        <translation>nada lee el parámetro «%1». Escribe %1 en la regla de la escena en lugar de un número, o haz que fije uno: «- sets: k of a-b».</translation>
    </message>
    <message>
        <source>the scene has no springs. Build one, or write “- value: ” in place of “- sets: ”.</source>
        <translation>la escena no tiene muelles. Construye uno, o escribe «- value: » en lugar de «- sets: ».</translation>
    </message>
    <message>
        <source>the scene has no springs or sticks. Build one, or write “- value: ” in place of “- sets: ”.</source>
        <translation>la escena no tiene muelles ni barras. Construye uno de los dos, o escribe «- value: » en lugar de «- sets: ».</translation>
    </message>
</context>
<context>
    <name>LessonPluginText</name>
    <message>
        <source>It is not a lesson that can be used: %1.</source>
        <translation>No es una lección que se pueda usar: %1.</translation>
    </message>
    <message>
        <source>It is not a plugin, or it is damaged; install it again, or move it to another folder.</source>
        <translation>No es un complemento, o está dañado; instálalo de nuevo, o muévelo a otra carpeta.</translation>
    </message>
    <message>
        <source>It is a lesson for another version of the program (%1, not %2); build it again for this one.</source>
        <translation>Es una lección para otra versión del programa (%1, no %2); compílala de nuevo para esta.</translation>
    </message>
    <message>
        <source>It is a plugin of another program (%1); move it to another folder.</source>
        <translation>Es un complemento de otro programa (%1); muévelo a otra carpeta.</translation>
    </message>
    <message>
        <source>its description has no text %1</source>
        <translation>su descripción no tiene ningún texto %1</translation>
    </message>
    <message>
        <source>the id %1 is not made of a to z, 0 to 9 and _</source>
        <translation>el id %1 no está hecho de la a a la z, de 0 a 9 y _</translation>
    </message>
    <message>
        <source>its description lists no &quot;steps&quot;</source>
        <translation>su descripción no enumera ningún &quot;steps&quot;</translation>
    </message>
    <message>
        <source>its description lists a step twice</source>
        <translation>su descripción enumera un paso dos veces</translation>
    </message>
    <message>
        <source>the step %1 has no scene or no view</source>
        <translation>el paso %1 no tiene escena o no tiene vista</translation>
    </message>
    <message>
        <source>the step %1 needs the method %2, which does not exist</source>
        <translation>el paso %1 necesita el método %2, que no existe</translation>
    </message>
    <message>
        <source>the step %1 cannot start (%2)</source>
        <translation>el paso %1 no puede empezar (%2)</translation>
    </message>
    <message>
        <source>its code has no lesson</source>
        <translation>su código no contiene ninguna lección</translation>
    </message>
    <message>
        <source>its steps could not be created (%1)</source>
        <translation>no se pudieron crear sus pasos (%1)</translation>
    </message>
    <message>
        <source>its description has no whole number &quot;order&quot;</source>
        <translation>su descripción no tiene ningún número entero &quot;order&quot;</translation>
    </message>
    <message>
        <source>It could not be loaded: %1. Build or install it again.</source>
        <translation>No se pudo cargar: %1. Compílala o instálala de nuevo.</translation>
    </message>
    <message>
        <source>its description lists the steps %1, its code has %2</source>
        <translation>su descripción enumera los pasos %1, su código tiene %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>its project could not be read (%1)</source>
        <translation>no se pudo leer su proyecto (%1)</translation>
    </message>
    <message>
        <source>its questions could not be read (%1)</source>
        <translation>no se pudieron leer sus preguntas (%1)</translation>
    </message>
</context>
<context>
    <name>LessonStepText</name>
    <message>
        <source>%1 stands for a number, and this condition does not compare one. Write a comparison with the number on its left, or a sentence without %1.</source>
        <translation>%1 representa un número, y esta condición no compara ninguno. Escribe una comparación con el número a su izquierda, o una frase sin %1.</translation>
    </message>
    <message>
        <source>nothing says when the thing to try “%1” is done. Write a “### Done when” with a list, as in “- pulled: released(%2)”.</source>
        <translation>nada dice cuándo está hecha la prueba «%1». Escribe un «### Done when» con una lista, como en «- pulled: released(%2)».</translation>
    </message>
</context>
<context>
    <name>LessonWriterText</name>
    <message>
        <source>## Try {#pull}

Pull **%1** aside, and let go of it. What does it do?

### Hint

Press **Space**. Hold the mouse button on %1, move the mouse, and let go.

### Answer

Write here what one can see then.

### Done when

- begun: held(%1) or released(%1)
- let_go: released(%1)

### Missing

- let_go: let go of it.

### Solution

- drag %1: %2, %3, 10
- frames: 30

</source>
        <translation>## Try {#pull}

Tira de **%1** hacia un lado y suéltalo. ¿Qué hace?

### Hint

Pulsa **Espacio**. Mantén el botón del ratón sobre %1, mueve el ratón y suelta.

### Answer

Escribe aquí lo que se ve entonces.

### Done when

- begun: held(%1) or released(%1)
- let_go: released(%1)

### Missing

- let_go: suéltalo.

### Solution

- drag %1: %2, %3, 10
- frames: 30

</translation>
    </message>
    <message>
        <source>## Predict {#where}

Nobody touches anything. Where is %1 after 60 frames? Click the place.

### Run

- frames: 60

### Ask

- place: %1

### Answer

Write here why it is there.

</source>
        <translation>## Predict {#where}

Nadie toca nada. ¿Dónde está %1 tras 60 fotogramas? Haz clic en el lugar.

### Run

- frames: 60

### Ask

- place: %1

### Answer

Escribe aquí por qué está allí.

</translation>
    </message>
    <message>
        <source># The title of the step

Write here what a learner should look at, why it is so, and the rule to keep. Save this file, and the window shows what you wrote.

Below are parts that a step can have. Change them, copy them, or remove them.

</source>
        <translation># El título del paso

Escribe aquí en qué hay que fijarse, por qué es así y qué regla hay que recordar. Guarda este archivo, y la ventana muestra lo que has escrito.

Debajo hay partes que un paso puede tener. Cámbialas, cópialas o quítalas.

</translation>
    </message>
    <message>
        <source>## Word: Step

Forms: none

A word that the text uses, in one sentence.

## Why: Why is it so?

Write here a question that learners ask, and the answer.

## Learnt

Write here in one sentence what a learner knows now.
</source>
        <translation>## Word: Paso

Forms: none

Una palabra que usa el texto, en una frase.

## Why: ¿Por qué es así?

Escribe aquí una pregunta que surge al aprender, y la respuesta.

## Learnt

Escribe aquí en una frase lo que ahora se sabe.
</translation>
    </message>
    <message>
        <source>My lesson</source>
        <translation>Mi lección</translation>
    </message>
    <message>
        <source>What it is about, in one sentence.</source>
        <translation>De qué trata, en una frase.</translation>
    </message>
    <message>
        <source>%1 is not empty. Choose a new folder for the lesson.</source>
        <translation>%1 no está vacía. Elige una carpeta nueva para la lección.</translation>
    </message>
    <message>
        <source>%1: the folder could not be made. Choose another place.</source>
        <translation>%1: no se pudo crear la carpeta. Elige otro lugar.</translation>
    </message>
    <message>
        <source>There is no step %1 any more. Open another one, and begin the lesson with its scene.</source>
        <translation>El paso %1 ya no existe. Abre otro y empieza la lección con su escena.</translation>
    </message>
</context>
<context>
    <name>LessonsText</name>
    <message>
        <source>%1; one of %2</source>
        <translation>%1; uno de %2</translation>
    </message>
    <message>
        <source>%1; %2 to %3</source>
        <translation>%1; de %2 a %3</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Métodos</translation>
    </message>
    <message>
        <source>order %1</source>
        <translation>orden %1</translation>
    </message>
    <message>
        <source>; needs %1</source>
        <translation>; necesita %1</translation>
    </message>
    <message>
        <source>No lesson was found in %1; SPRINGSTEP_LESSONS can name a folder that has them.</source>
        <translation>No se encontró ninguna lección en %1; SPRINGSTEP_LESSONS puede indicar una carpeta que las tenga.</translation>
    </message>
</context>
<context>
    <name>LinePositionText</name>
    <message>
        <source>before line %1, %2 of %3 lines run</source>
        <translation>antes de la línea %1, ejecutadas %2 de %3 líneas</translation>
    </message>
    <message>
        <source>before line %1, %2 lines run</source>
        <translation>antes de la línea %1, ejecutadas %2 líneas</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>línea %1</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Fotograma %1</translation>
    </message>
</context>
<context>
    <name>LineValuesText</name>
    <message>
        <source>%1: from %2 to %3</source>
        <translation>%1: de %2 a %3</translation>
    </message>
    <message>
        <source>%1 = %2 of %3</source>
        <translation>%1 = %2 de %3</translation>
    </message>
    <message>
        <source>no body</source>
        <translation>ningún cuerpo</translation>
    </message>
    <message>
        <source>This frame runs more than %1 lines. The others are not shown.</source>
        <translation>Este fotograma ejecuta más de %1 líneas. Las demás no se muestran.</translation>
    </message>
</context>
<context>
    <name>ListingText</name>
    <message>
        <source>Did you mean %1?</source>
        <translation>¿Querías decir %1?</translation>
    </message>
    <message>
        <source>%1 is not a member of an array of bodies.</source>
        <translation>%1 no es un miembro de una lista de cuerpos.</translation>
    </message>
    <message>
        <source>%1 is not a member of the array of creatures.</source>
        <translation>%1 no es un miembro de la lista de criaturas.</translation>
    </message>
    <message>
        <source>%1 is not a member of the array of sticks.</source>
        <translation>%1 no es un miembro de la lista de barras.</translation>
    </message>
    <message>
        <source>%1 is not a member of the new targets.</source>
        <translation>%1 no es un miembro de los nuevos objetivos.</translation>
    </message>
    <message>
        <source>%1 is not a member of the keys.</source>
        <translation>%1 no es ninguna de las teclas.</translation>
    </message>
    <message>
        <source>%1 is not a member of %2.</source>
        <translation>%1 no es un miembro de %2.</translation>
    </message>
    <message>
        <source>It has %1.</source>
        <translation>Tiene %1.</translation>
    </message>
    <message>
        <source>Choose one of them first, for example with [0].</source>
        <translation>Elige antes uno de ellos, por ejemplo con [0].</translation>
    </message>
    <message>
        <source>There is no function %1.</source>
        <translation>No existe la función %1.</translation>
    </message>
    <message>
        <source>There is no type %1.</source>
        <translation>No existe el tipo %1.</translation>
    </message>
    <message>
        <source>The types are %1.</source>
        <translation>Los tipos son %1.</translation>
    </message>
    <message>
        <source>The functions are %1.</source>
        <translation>Las funciones son %1.</translation>
    </message>
    <message>
        <source>There is no %1: %2 is empty.</source>
        <translation>No existe %1: %2 está vacío.</translation>
    </message>
    <message>
        <source>There is no %1: the only one is %2.</source>
        <translation>No existe %1: solo hay %2.</translation>
    </message>
    <message>
        <source>There is no %1: %2 goes from %3 to %4.</source>
        <translation>No existe %1: %2 va de %3 a %4.</translation>
    </message>
    <message>
        <source>There is no %1.</source>
        <translation>No existe %1.</translation>
    </message>
    <message>
        <source>This scene has %1, and the numbers %2.</source>
        <translation>Esta escena tiene %1, y los números %2.</translation>
    </message>
    <message>
        <source>This scene has %1, and the number %2.</source>
        <translation>Esta escena tiene %1, y el número %2.</translation>
    </message>
    <message>
        <source>This scene has the numbers %1.</source>
        <translation>Esta escena tiene los números %1.</translation>
    </message>
    <message>
        <source>This scene has the number %1.</source>
        <translation>Esta escena tiene el número %1.</translation>
    </message>
    <message>
        <source>This scene has %1.</source>
        <translation>Esta escena tiene %1.</translation>
    </message>
    <message>
        <source>There already is %1 here.</source>
        <translation>Aquí ya existe %1.</translation>
    </message>
    <message>
        <source>There already is %1 in this scene.</source>
        <translation>En esta escena ya existe %1.</translation>
    </message>
    <message>
        <source>Use another name.</source>
        <translation>Usa otro nombre.</translation>
    </message>
    <message>
        <source>A new variable needs a type: %1, %2 or %3.</source>
        <translation>Una variable nueva necesita un tipo: %1, %2 o %3.</translation>
    </message>
    <message>
        <source>This is an array of bodies.</source>
        <translation>Esto es una lista de cuerpos.</translation>
    </message>
    <message>
        <source>%1 does not take these values: %2.</source>
        <translation>%1 no acepta estos valores: %2.</translation>
    </message>
    <message>
        <source>A %1 cannot be used as a %2.</source>
        <translation>Un %1 no puede usarse como %2.</translation>
    </message>
    <message>
        <source>This sign does not work between a %1 and the other value.</source>
        <translation>Este signo no sirve entre un %1 y el otro valor.</translation>
    </message>
    <message>
        <source>This sign does not work between a %1 and a %2.</source>
        <translation>Este signo no sirve entre un %1 y un %2.</translation>
    </message>
    <message>
        <source>A Vec2 can be added to a Vec2, and multiplied or divided by a number.</source>
        <translation>Un Vec2 se puede sumar a un Vec2, y multiplicar o dividir por un número.</translation>
    </message>
    <message>
        <source>Use the position or the velocity of the body.</source>
        <translation>Usa la posición o la velocidad del cuerpo.</translation>
    </message>
    <message>
        <source>%1 is a %2 here, not a function.</source>
        <translation>Aquí %1 es un %2, no una función.</translation>
    </message>
    <message>
        <source>This is not a function.</source>
        <translation>Esto no es una función.</translation>
    </message>
    <message>
        <source>%1 is not a function.</source>
        <translation>%1 no es una función.</translation>
    </message>
    <message>
        <source>Write it without &apos;()&apos;.</source>
        <translation>Escríbelo sin &apos;()&apos;.</translation>
    </message>
    <message>
        <source>To multiply, write &apos;*&apos;.</source>
        <translation>Para multiplicar, escribe &apos;*&apos;.</translation>
    </message>
    <message>
        <source>Both values of a choice with ? need the same type.</source>
        <translation>Los dos valores de una elección con ? necesitan el mismo tipo.</translation>
    </message>
    <message>
        <source>Write %1 for %2 beside a double.</source>
        <translation>Junto a un double, escribe %1 en vez de %2.</translation>
    </message>
    <message>
        <source>Between whole numbers, &apos;/&apos; drops the fraction: this is %1.</source>
        <translation>Entre números enteros, &apos;/&apos; descarta la parte decimal: esto es %1.</translation>
    </message>
    <message>
        <source>Between whole numbers, &apos;/&apos; drops the fraction.</source>
        <translation>Entre números enteros, &apos;/&apos; descarta la parte decimal.</translation>
    </message>
    <message>
        <source>An &apos;int&apos; keeps no fraction, and this value may have one.</source>
        <translation>Un &apos;int&apos; no guarda decimales, y este valor puede tenerlos.</translation>
    </message>
    <message>
        <source>Write %1, or round down with %2.</source>
        <translation>Escribe %1, o redondea hacia abajo con %2.</translation>
    </message>
    <message>
        <source>A value is missing at the end of this line.</source>
        <translation>Falta un valor al final de esta línea.</translation>
    </message>
    <message>
        <source>A name is missing at the end of this line.</source>
        <translation>Falta un nombre al final de esta línea.</translation>
    </message>
    <message>
        <source>%1 is missing at the end of this line.</source>
        <translation>Falta %1 al final de esta línea.</translation>
    </message>
    <message>
        <source>%1 is missing before %2.</source>
        <translation>Falta %1 antes de %2.</translation>
    </message>
    <message>
        <source>This %1 has no %2.</source>
        <translation>A este %1 le falta su %2.</translation>
    </message>
    <message>
        <source>A value is missing here.</source>
        <translation>Aquí falta un valor.</translation>
    </message>
    <message>
        <source>The name of a type is missing here: %1.</source>
        <translation>Aquí falta el nombre de un tipo: %1.</translation>
    </message>
    <message>
        <source>A name is missing here.</source>
        <translation>Aquí falta un nombre.</translation>
    </message>
    <message>
        <source>The name of a member is missing behind the dot.</source>
        <translation>Falta el nombre de un miembro después del punto.</translation>
    </message>
    <message>
        <source>%1 is missing here.</source>
        <translation>Aquí falta %1.</translation>
    </message>
    <message>
        <source>A Body cannot be replaced by another one.</source>
        <translation>Un Body no se puede sustituir por otro.</translation>
    </message>
    <message>
        <source>Set its position or its velocity.</source>
        <translation>Asigna su posición o su velocidad.</translation>
    </message>
    <message>
        <source>This cannot be changed.</source>
        <translation>Esto no se puede cambiar.</translation>
    </message>
    <message>
        <source>This is a parameter.</source>
        <translation>Esto es un parámetro.</translation>
    </message>
    <message>
        <source>Set it with its slider.</source>
        <translation>Ajústalo con su control deslizante.</translation>
    </message>
    <message>
        <source>A listing changes positions, velocities and its own variables.</source>
        <translation>Un listado cambia posiciones, velocidades y sus propias variables.</translation>
    </message>
    <message>
        <source>A %1 cannot be set as a whole.</source>
        <translation>Un %1 no se puede asignar entero.</translation>
    </message>
    <message>
        <source>%1 has no value yet.</source>
        <translation>%1 aún no tiene ningún valor.</translation>
    </message>
    <message>
        <source>Give it one: %1.</source>
        <translation>Dale uno: %1.</translation>
    </message>
    <message>
        <source>A condition is true or false.</source>
        <translation>Una condición es verdadera o falsa.</translation>
    </message>
    <message>
        <source>%1 is a type and has no value.</source>
        <translation>%1 es un tipo y no tiene valor.</translation>
    </message>
    <message>
        <source>Use its x, its y or its length.</source>
        <translation>Usa su x, su y o su longitud.</translation>
    </message>
    <message>
        <source>This sign does not work with this value.</source>
        <translation>Este signo no funciona con este valor.</translation>
    </message>
    <message>
        <source>Only an array has an index in &apos;[...]&apos;.</source>
        <translation>Solo una lista tiene un índice entre &apos;[...]&apos;.</translation>
    </message>
    <message>
        <source>This computes a value, and nothing keeps it.</source>
        <translation>Esto calcula un valor y nada lo guarda.</translation>
    </message>
    <message>
        <source>Compare this with something, for example with == or &gt;.</source>
        <translation>Compara esto con algo, por ejemplo con == o &gt;.</translation>
    </message>
    <message>
        <source>This function can end without &apos;return&apos;.</source>
        <translation>Esta función puede terminar sin &apos;return&apos;.</translation>
    </message>
    <message>
        <source>It has to return a value in every case.</source>
        <translation>Tiene que devolver un valor en todos los casos.</translation>
    </message>
    <message>
        <source>This function has to return a value.</source>
        <translation>Esta función tiene que devolver un valor.</translation>
    </message>
    <message>
        <source>A &apos;void&apos; function returns no value.</source>
        <translation>Una función &apos;void&apos; no devuelve ningún valor.</translation>
    </message>
    <message>
        <source>The text ends too early: a &apos;}&apos; or a &apos;)&apos; is missing.</source>
        <translation>El texto termina demasiado pronto: falta una &apos;}&apos; o un &apos;)&apos;.</translation>
    </message>
    <message>
        <source>A Body variable needs a body, for example %1.</source>
        <translation>Una variable Body necesita un cuerpo, por ejemplo %1.</translation>
    </message>
    <message>
        <source>%1 cannot be remembered from frame to frame.</source>
        <translation>%1 no se puede recordar de un fotograma a otro.</translation>
    </message>
    <message>
        <source>Only numbers, bool and Vec2 can.</source>
        <translation>Solo se puede con números, bool y Vec2.</translation>
    </message>
    <message>
        <source>The first value of %1 cannot be computed.</source>
        <translation>El primer valor de %1 no se puede calcular.</translation>
    </message>
    <message>
        <source>Write the number itself, without %1.</source>
        <translation>Escribe el propio número, sin %1.</translation>
    </message>
    <message>
        <source>The function &apos;void frame()&apos; is missing.</source>
        <translation>Falta la función &apos;void frame()&apos;.</translation>
    </message>
    <message>
        <source>It runs once in every frame.</source>
        <translation>Se ejecuta una vez en cada fotograma.</translation>
    </message>
    <message>
        <source>A listing cannot make arrays.</source>
        <translation>Un listado no puede crear listas propias.</translation>
    </message>
    <message>
        <source>Write a variable for each value.</source>
        <translation>Escribe una variable para cada valor.</translation>
    </message>
    <message>
        <source>This is outside of any function.</source>
        <translation>Esto está fuera de una función.</translation>
    </message>
    <message>
        <source>A function cannot be inside another function.</source>
        <translation>Una función no puede estar dentro de otra.</translation>
    </message>
    <message>
        <source>Move it out.</source>
        <translation>Sácala fuera.</translation>
    </message>
    <message>
        <source>%1 works only in a loop.</source>
        <translation>%1 solo va dentro de un bucle.</translation>
    </message>
    <message>
        <source>%1 does not belong here.</source>
        <translation>%1 no va aquí.</translation>
    </message>
    <message>
        <source>Put it between the braces of a function.</source>
        <translation>Ponlo entre las llaves de una función.</translation>
    </message>
    <message>
        <source>Look for a &apos;}&apos; too many above.</source>
        <translation>Busca más arriba una &apos;}&apos; de más.</translation>
    </message>
    <message>
        <source>A function begins with the type of its result, for example %1 or %2.</source>
        <translation>Una función empieza con el tipo de su resultado, por ejemplo %1 o %2.</translation>
    </message>
    <message>
        <source>A function is called without an object here: %1.</source>
        <translation>Aquí una función se llama sin objeto: %1.</translation>
    </message>
    <message>
        <source>This text cannot be compiled.</source>
        <translation>Este texto no se puede compilar.</translation>
    </message>
    <message>
        <source>Texts in quotes are not part of this language.</source>
        <translation>Los textos entre comillas no forman parte de este lenguaje.</translation>
    </message>
    <message>
        <source>It has numbers, bool and Vec2.</source>
        <translation>Tiene números, bool y Vec2.</translation>
    </message>
    <message>
        <source>This character is not part of this language.</source>
        <translation>Este carácter no forma parte de este lenguaje.</translation>
    </message>
    <message>
        <source>%1 is reserved and not part of this language.</source>
        <translation>%1 está reservado y no forma parte de este lenguaje.</translation>
    </message>
    <message>
        <source>%1 is not part of this language.</source>
        <translation>%1 no forma parte de este lenguaje.</translation>
    </message>
    <message>
        <source>A Body variable already stands for the body itself.</source>
        <translation>Una variable Body ya representa el cuerpo mismo.</translation>
    </message>
    <message>
        <source>A loop is written %1.</source>
        <translation>Un bucle se escribe así: %1.</translation>
    </message>
    <message>
        <source>A comment begins with %1.</source>
        <translation>Un comentario empieza por %1.</translation>
    </message>
    <message>
        <source>A name begins with a letter.</source>
        <translation>Un nombre empieza por una letra.</translation>
    </message>
    <message>
        <source>A name has only the letters a to z, digits and &apos;_&apos;.</source>
        <translation>Un nombre solo tiene las letras de la a a la z, cifras y &apos;_&apos;.</translation>
    </message>
    <message>
        <source>A listing cannot print: its values are shown beside its lines.</source>
        <translation>Un listado no imprime nada: sus valores están junto a sus líneas.</translation>
    </message>
    <message>
        <source>A power is %1.</source>
        <translation>Una potencia es %1.</translation>
    </message>
    <message>
        <source>Write a position or a velocity as %1.</source>
        <translation>Un lugar o una velocidad se escriben así: %1.</translation>
    </message>
    <message>
        <source>A condition needs brackets: %1.</source>
        <translation>Una condición va entre paréntesis: %1.</translation>
    </message>
    <message>
        <source>Leave out the &apos;:&apos;.</source>
        <translation>Quita el &apos;:&apos;.</translation>
    </message>
    <message>
        <source>The lines that belong to a condition go between &apos;{&apos; and &apos;}&apos;.</source>
        <translation>Las líneas que pertenecen a una condición van entre &apos;{&apos; y &apos;}&apos;.</translation>
    </message>
    <message>
        <source>This &apos;;&apos; ends %1, so that nothing belongs to it.</source>
        <translation>Este &apos;;&apos; termina %1, así que no le pertenece nada.</translation>
    </message>
    <message>
        <source>Delete the &apos;;&apos;.</source>
        <translation>Elimina el &apos;;&apos;.</translation>
    </message>
    <message>
        <source>Leave it out.</source>
        <translation>Omítelo.</translation>
    </message>
    <message>
        <source>Use %1.</source>
        <translation>Usa %1.</translation>
    </message>
    <message>
        <source>A number ends without &apos;f&apos; here.</source>
        <translation>Aquí un número termina sin &apos;f&apos;.</translation>
    </message>
    <message>
        <source>A number has a point, not a comma: %1.</source>
        <translation>Un número lleva punto, no coma: %1.</translation>
    </message>
    <message>
        <source>&apos;void&apos; is only for functions, for example %1.</source>
        <translation>&apos;void&apos; solo va antes de una función, por ejemplo %1.</translation>
    </message>
    <message>
        <source>%1 returns no value, so call it on its own: %2.</source>
        <translation>%1 no devuelve ningún valor, así que llámalo por separado: %2.</translation>
    </message>
    <message>
        <source>&apos;=&apos; sets a value, and can be used once in a statement.</source>
        <translation>&apos;=&apos; asigna un valor, y va una sola vez en una instrucción.</translation>
    </message>
    <message>
        <source>To compare, write &apos;==&apos;.</source>
        <translation>Para comparar, escribe &apos;==&apos;.</translation>
    </message>
    <message>
        <source>&apos;==&apos; compares and changes nothing.</source>
        <translation>&apos;==&apos; compara y no cambia nada.</translation>
    </message>
    <message>
        <source>To set a value, write &apos;=&apos;.</source>
        <translation>Para asignar un valor, escribe &apos;=&apos;.</translation>
    </message>
    <message>
        <source>Only a variable can be set: a name, with members or an index behind it.</source>
        <translation>Solo se puede asignar una variable: un nombre, seguido de miembros o de un índice.</translation>
    </message>
    <message>
        <source>Compare two values at a time, for example %1.</source>
        <translation>Compara los valores de dos en dos, por ejemplo %1.</translation>
    </message>
    <message>
        <source>Write &apos;*&apos; between a number and a name: %1.</source>
        <translation>Escribe &apos;*&apos; entre un número y un nombre: %1.</translation>
    </message>
    <message>
        <source>Write &apos;+=&apos; to add to a value.</source>
        <translation>Escribe &apos;+=&apos; para sumar algo a un valor.</translation>
    </message>
    <message>
        <source>Write &apos;-=&apos; to subtract from a value.</source>
        <translation>Escribe &apos;-=&apos; para restar de un valor.</translation>
    </message>
    <message>
        <source>Write &apos;.&apos; between a body and its member, for example %1.</source>
        <translation>Escribe &apos;.&apos; entre un cuerpo y su miembro, por ejemplo %1.</translation>
    </message>
    <message>
        <source>Write %1 to compare.</source>
        <translation>Escribe %1 para comparar.</translation>
    </message>
    <message>
        <source>Write %1 without a space in between.</source>
        <translation>Escribe %1 sin espacio en medio.</translation>
    </message>
    <message>
        <source>Write %1 with small letters.</source>
        <translation>Escribe %1 con minúsculas.</translation>
    </message>
    <message>
        <source>Write it as %1.</source>
        <translation>Escríbelo así: %1.</translation>
    </message>
    <message>
        <source>Write %1.</source>
        <translation>Escribe %1.</translation>
    </message>
    <message>
        <source>There are more than %1 &apos;else&apos; in this listing.</source>
        <translation>Hay más de %1 &apos;else&apos; en este listado.</translation>
    </message>
    <message>
        <source>There are more than %1 brackets inside one another.</source>
        <translation>Hay más de %1 paréntesis unos dentro de otros.</translation>
    </message>
    <message>
        <source>This statement is too long.</source>
        <translation>Esta instrucción es demasiado larga.</translation>
    </message>
    <message>
        <source>Split it in two.</source>
        <translation>Divídela en dos.</translation>
    </message>
    <message>
        <source>The variables outside of functions take %1 bytes.</source>
        <translation>Las variables fuera de funciones ocupan %1 bytes.</translation>
    </message>
    <message>
        <source>This listing has %1 bytes.</source>
        <translation>Este listado tiene %1 bytes.</translation>
    </message>
    <message>
        <source>The most is %1.</source>
        <translation>El máximo es %1.</translation>
    </message>
    <message>
        <source>This variable stands for no body.</source>
        <translation>Esta variable no representa ningún cuerpo.</translation>
    </message>
    <message>
        <source>This divides by 0.</source>
        <translation>Esto divide entre 0.</translation>
    </message>
    <message>
        <source>The result is too large for a number.</source>
        <translation>El resultado es demasiado grande para un número.</translation>
    </message>
    <message>
        <source>This loop still runs after %1 lines.</source>
        <translation>Este bucle sigue en marcha tras %1 líneas.</translation>
    </message>
    <message>
        <source>It ends only when its condition becomes false.</source>
        <translation>Solo termina cuando su condición deja de cumplirse.</translation>
    </message>
    <message>
        <source>This still runs after %1 lines.</source>
        <translation>Esto sigue en marcha tras %1 líneas.</translation>
    </message>
    <message>
        <source>A function calls itself too often.</source>
        <translation>Una función se llama a sí misma demasiadas veces.</translation>
    </message>
    <message>
        <source>Functions call functions %1 times inside one another.</source>
        <translation>Unas funciones llaman a otras %1 veces, unas dentro de otras.</translation>
    </message>
    <message>
        <source>Functions call functions too many times inside one another.</source>
        <translation>Unas funciones llaman a otras demasiadas veces, unas dentro de otras.</translation>
    </message>
    <message>
        <source>A function that calls itself needs a case in which it does not.</source>
        <translation>Una función que se llama a sí misma necesita un caso en el que no lo haga.</translation>
    </message>
    <message>
        <source>The position of %1 is not a finite number.</source>
        <translation>La posición de %1 no es un número finito.</translation>
    </message>
    <message>
        <source>The velocity of %1 is not a finite number.</source>
        <translation>La velocidad de %1 no es un número finito.</translation>
    </message>
    <message>
        <source>The angle or the spin of %1 is not a finite number.</source>
        <translation>El ángulo o la velocidad angular de %1 no es un número finito.</translation>
    </message>
    <message>
        <source>Look for the root of a negative number, or for a number that grows in each frame.</source>
        <translation>Busca la raíz de un número negativo o un número que crezca en cada fotograma.</translation>
    </message>
    <message>
        <source>The gait of %1 is not a finite number.</source>
        <translation>La marcha de %1 no es un número finito.</translation>
    </message>
    <message>
        <source>%1 is not a finite number.</source>
        <translation>%1 no es un número finito.</translation>
    </message>
    <message>
        <source>The interpreter stopped.</source>
        <translation>El intérprete se ha parado.</translation>
    </message>
    <message>
        <source> and </source>
        <comment>in a list</comment>
        <translation> y </translation>
    </message>
    <message>
        <source> or </source>
        <comment>in a list</comment>
        <translation> o </translation>
    </message>
    <message>
        <source>A rule needs the function %1 or %2.</source>
        <translation>Una regla necesita la función %1 o %2.</translation>
    </message>
    <message>
        <source>The function %1 of a rule has the form %2.</source>
        <translation>La función %1 de una regla tiene la forma %2.</translation>
    </message>
    <message>
        <source>A rule remembers nothing, so %1 cannot be outside of a function.</source>
        <translation>Una regla no recuerda nada, así que %1 no puede estar fuera de una función.</translation>
    </message>
    <message>
        <source>Move it into one.</source>
        <translation>Muévelo dentro de una.</translation>
    </message>
    <message>
        <source>The force is not a finite number.</source>
        <translation>La fuerza no es un número finito.</translation>
    </message>
</context>
<context>
    <name>MapTableText</name>
    <message>
        <source>step [frames]</source>
        <translation>paso de tiempo [fotogramas]</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>en reposo</translation>
    </message>
    <message>
        <source>still moving</source>
        <translation>aún se mueve</translation>
    </message>
    <message>
        <source>grows</source>
        <translation>crece</translation>
    </message>
    <message>
        <source>cannot be computed</source>
        <translation>no se puede calcular</translation>
    </message>
    <message>
        <source>growth [a frame]</source>
        <translation>crecimiento [por fotograma]</translation>
    </message>
    <message>
        <source>time to rest [frames]</source>
        <translation>tiempo hasta el reposo [fotogramas]</translation>
    </message>
    <message>
        <source>outcome</source>
        <translation>resultado</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>E&amp;xportar</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Editar</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>E&amp;jecución</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ver</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>A&amp;yuda</translation>
    </message>
</context>
<context>
    <name>NotebookCheckText</name>
    <message>
        <source>Its run takes more than %1 s to replay.</source>
        <translation>Volver a reproducir su ejecución lleva más de %1 s.</translation>
    </message>
    <message>
        <source>It was ticked by a version that kept no runs.</source>
        <translation>Se marcó con una versión que no guardaba ejecuciones.</translation>
    </message>
    <message>
        <source>Its run is of another step.</source>
        <translation>Su ejecución es de otro paso.</translation>
    </message>
    <message>
        <source>At frame %1 its run does not do it.</source>
        <translation>En el fotograma %1 su ejecución no lo consigue.</translation>
    </message>
    <message>
        <source>Still to do: %1</source>
        <translation>Queda por hacer: %1</translation>
    </message>
    <message>
        <source>Its answer cannot be read.</source>
        <translation>No se puede leer su respuesta.</translation>
    </message>
    <message>
        <source>The notebook counts “%1” as %2, but the run gives “%3”.</source>
        <translation>El cuaderno cuenta «%1» como %2, pero la ejecución da «%3».</translation>
    </message>
    <message>
        <source>right</source>
        <translation>correcto</translation>
    </message>
    <message>
        <source>not right</source>
        <translation>no correcto</translation>
    </message>
    <message>
        <source>The notebook says that the run gives “%1”, but it gives “%2”.</source>
        <translation>El cuaderno dice que la ejecución da «%1», pero da «%2».</translation>
    </message>
    <message>
        <source>“%1” was said; it is “%2”.</source>
        <translation>Se dijo «%1»; es «%2».</translation>
    </message>
    <message>
        <source>The notebook counts “%1” as %2, but the answer of the lesson is “%3”.</source>
        <translation>El cuaderno cuenta «%1» como %2, pero la respuesta de la lección es «%3».</translation>
    </message>
</context>
<context>
    <name>NotebookFileText</name>
    <message>
        <source>the file</source>
        <translation>el archivo</translation>
    </message>
    <message>
        <source>this is not a notebook: its &quot;format&quot; is %1, and this program reads %2.</source>
        <translation>esto no es un cuaderno: su &quot;format&quot; es %1, y este programa lee %2.</translation>
    </message>
    <message>
        <source>the seal of the file</source>
        <translation>el sello del archivo</translation>
    </message>
    <message>
        <source>&quot;name&quot; has %1 letters; it can have up to %2.</source>
        <translation>&quot;name&quot; tiene %1 letras; puede tener hasta %2.</translation>
    </message>
    <message>
        <source>a list of what was done</source>
        <translation>una lista de lo que se hizo</translation>
    </message>
    <message>
        <source>&quot;entries&quot; has %1 entries; it can have up to %2.</source>
        <translation>&quot;entries&quot; tiene %1 entradas; puede tener hasta %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time; write it as 2026-01-31T12:00:00Z.</source>
        <translation>&quot;%1&quot; no es una hora; escríbela como 2026-01-31T12:00:00Z.</translation>
    </message>
    <message>
        <source>an entry</source>
        <translation>una entrada</translation>
    </message>
    <message>
        <source>the id of what was done</source>
        <translation>el id de lo que se hizo</translation>
    </message>
    <message>
        <source>the id of a step</source>
        <translation>el id de un paso</translation>
    </message>
    <message>
        <source>the answer</source>
        <translation>la respuesta</translation>
    </message>
    <message>
        <source>what the run showed</source>
        <translation>lo que mostró la ejecución</translation>
    </message>
    <message>
        <source>&quot;kind&quot; is %1; it can be %2.</source>
        <translation>&quot;kind&quot; es %1; puede ser %2.</translation>
    </message>
    <message>
        <source>the runs are larger than %1 MiB together, the maximum for a notebook.</source>
        <translation>las ejecuciones ocupan juntas más de %1 MiB, el máximo para un cuaderno.</translation>
    </message>
    <message>
        <source>the run of %1 is damaged, or larger than %2 MiB; ask for the notebook again.</source>
        <translation>la ejecución de %1 está dañada, u ocupa más de %2 MiB; pide el cuaderno otra vez.</translation>
    </message>
    <message>
        <source>there is no %1 called %2 in %3; the notebook may be from another version of the lesson.</source>
        <translation>en %3 no hay ningún «%1» llamado %2; quizá el cuaderno sea de otra versión de la lección.</translation>
    </message>
    <message>
        <source>%1 is there twice; ask for the notebook again.</source>
        <translation>%1 aparece dos veces; pide el cuaderno otra vez.</translation>
    </message>
    <message>
        <source>%1: this is not a notebook; a notebook is text in UTF-8.</source>
        <translation>%1: esto no es un cuaderno; un cuaderno es texto en UTF-8.</translation>
    </message>
    <message>
        <source>The notebook would be too large. Choose fewer lessons, or leave out the gallery.</source>
        <translation>El cuaderno sería demasiado grande. Elige menos lecciones u omite la galería.</translation>
    </message>
    <message>
        <source>If it is a lesson without C++, name its folder or its zip beside the notebook.</source>
        <translation>Si es una lección sin C++, nombra su carpeta o su zip junto al cuaderno.</translation>
    </message>
</context>
<context>
    <name>NotebookPageText</name>
    <message>
        <source>Notebook</source>
        <translation>Cuaderno</translation>
    </message>
    <message>
        <source>Notebook of %1</source>
        <translation>Cuaderno de %1</translation>
    </message>
    <message>
        <source>Springstep, %1</source>
        <translation>Springstep, %1</translation>
    </message>
    <message>
        <source>Nothing is done yet.</source>
        <translation>Aún no hay nada hecho.</translation>
    </message>
    <message>
        <source>Project: %1</source>
        <translation>Proyecto: %1</translation>
    </message>
    <message>
        <source>Built and kept</source>
        <translation>Construido y guardado</translation>
    </message>
    <message>
        <source>The scene at that moment</source>
        <translation>La escena en ese instante</translation>
    </message>
</context>
<context>
    <name>NotebookReportText</name>
    <message>
        <source>%1 of %2 are shown by their runs.</source>
        <translation>%1 de %2 quedan demostrados por sus ejecuciones.</translation>
    </message>
    <message>
        <source>The file was changed after it was written.</source>
        <translation>El archivo se cambió después de escribirse.</translation>
    </message>
    <message>
        <source>Nothing is in it.</source>
        <translation>No contiene nada.</translation>
    </message>
</context>
<context>
    <name>NotebookText</name>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1: %2 de %3</translation>
    </message>
    <message>
        <source>%1 of %2 notebooks could not be read.</source>
        <translation>No se pudieron leer %1 de %2 cuadernos.</translation>
    </message>
    <message>
        <source>notebook page takes FILE OUT; see springstep notebook --help.</source>
        <translation>notebook page acepta FILE OUT; consulta springstep notebook --help.</translation>
    </message>
    <message>
        <source>%1 is not the name of a page; it can end in .html or .pdf.</source>
        <translation>%1 no es el nombre de una página; puede terminar en .html o .pdf.</translation>
    </message>
    <message>
        <source>--lessons: %1</source>
        <translation>--lessons: %1</translation>
    </message>
    <message>
        <source>notebook write takes OUT; see springstep notebook --help.</source>
        <translation>notebook write acepta OUT; consulta springstep notebook --help.</translation>
    </message>
    <message>
        <source>%1 is not the name of a notebook; it ends in %2.</source>
        <translation>%1 no es el nombre de un cuaderno; termina en %2.</translation>
    </message>
    <message>
        <source>notebook cannot %1; it can &quot;check&quot;, &quot;page&quot; or &quot;write&quot;.</source>
        <translation>notebook no puede hacer %1; puede hacer &quot;check&quot;, &quot;page&quot; o &quot;write&quot;.</translation>
    </message>
    <message>
        <source>notebook check takes FILE...; see springstep notebook --help.</source>
        <translation>notebook check acepta FILE...; consulta springstep notebook --help.</translation>
    </message>
    <message>
        <source>--%1 is for notebook check. Leave it out.</source>
        <translation>--%1 es para notebook check. Omítelo.</translation>
    </message>
    <message>
        <source>--%1 is for notebook write. Leave it out.</source>
        <translation>--%1 es para notebook write. Omítelo.</translation>
    </message>
    <message>
        <source>--json and --csv are two forms of the result. Leave one out.</source>
        <translation>--json y --csv son dos formas del resultado. Omite una de ellas.</translation>
    </message>
</context>
<context>
    <name>OptionValuesText</name>
    <message>
        <source>--%1 is %2; it can be %3 to %4.</source>
        <translation>--%1 es %2; puede ir de %3 a %4.</translation>
    </message>
    <message>
        <source>--%1 is %2; it can be a whole number from 0 to %3.</source>
        <translation>--%1 es %2; puede ser un número entero de 0 a %3.</translation>
    </message>
    <message>
        <source>--size is %1; it can be WIDTHxHEIGHT in pixels, each from 100 to 9999, such as 1280x800.</source>
        <translation>--size es %1; puede ser ANCHOxALTO en píxeles, cada uno de 100 a 9999, como 1280x800.</translation>
    </message>
    <message>
        <source>--theme is %1; it can be &quot;light&quot;, &quot;dark&quot; or &quot;contrast&quot;.</source>
        <translation>--theme es %1; puede ser &quot;light&quot;, &quot;dark&quot; o &quot;contrast&quot;.</translation>
    </message>
    <message>
        <source>--language is %1; it can be %2.</source>
        <translation>--language es %1; puede ser %2.</translation>
    </message>
</context>
<context>
    <name>ParameterValueText</name>
    <message>
        <source>%1 is %2; it can be one of %3.</source>
        <translation>%1 es %2; puede ser uno de %3.</translation>
    </message>
    <message>
        <source>the step %1 has no parameter %2; it has %3.</source>
        <translation>el paso %1 no tiene el parámetro %2; tiene %3.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>%1 is %2; it can be a whole number from %3 to %4.</source>
        <translation>%1 es %2; puede ser un número entero de %3 a %4.</translation>
    </message>
    <message>
        <source>%1 is %2; it can be %3 to %4.</source>
        <translation>%1 es %2; puede ir de %3 a %4.</translation>
    </message>
</context>
<context>
    <name>PhrasesText</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1&#x2009;px</source>
        <translation>%1&#x2009;px</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>fotograma</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>fotograma %1</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 punto</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 puntos</translation>
    </message>
</context>
<context>
    <name>PictureFileText</name>
    <message>
        <source>%1 could not be written: %2. Choose another folder or name.</source>
        <translation>No se pudo escribir %1: %2. Elige otra carpeta u otro nombre.</translation>
    </message>
    <message>
        <source>%1 is not the name of a picture; it ends in .png or .svg.</source>
        <translation>%1 no es el nombre de una imagen; termina en .png o .svg.</translation>
    </message>
</context>
<context>
    <name>PlacePicker</name>
    <message>
        <source>your place, %1 away</source>
        <translation>tu lugar, %1 de diferencia</translation>
    </message>
    <message>
        <source>Your cross is at %1, %2</source>
        <translation>Tu cruz está en %1; %2</translation>
    </message>
    <message>
        <source>%1, %2 away from the true place %3, %4</source>
        <translation>%1, a %2 del lugar verdadero, %3; %4</translation>
    </message>
</context>
<context>
    <name>PredictionText</name>
    <message>
        <source>frame</source>
        <translation>fotograma</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>fotogramas</translation>
    </message>
    <message>
        <source>exactly as you said</source>
        <translation>justo lo que dijiste</translation>
    </message>
    <message>
        <source>your number is %1 too high</source>
        <translation>tu número se pasa en %1</translation>
    </message>
    <message>
        <source>your number is %1 too low</source>
        <translation>tu número se queda corto en %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>curve %1</source>
        <translation>gráfica %1</translation>
    </message>
    <message>
        <source>You said **%1**. It is **%2**: %3&#x202f;px away.</source>
        <translation>Dijiste **%1**. La respuesta es **%2**: %3&#x202f;px de diferencia.</translation>
    </message>
    <message>
        <source>You said **%1**. It is **%2**: %3.</source>
        <translation>Dijiste **%1**. La respuesta es **%2**: %3.</translation>
    </message>
    <message>
        <source>You said **%1**, and so it is.</source>
        <translation>Dijiste **%1**, y así es.</translation>
    </message>
    <message>
        <source>You said **%1**. It is **%2**.</source>
        <translation>Dijiste **%1**. La respuesta es **%2**.</translation>
    </message>
    <message>
        <source>from %1 to %2, at most %3, at least %4</source>
        <translation>de %1 a %2, como máximo %3, como mínimo %4</translation>
    </message>
</context>
<context>
    <name>ProjectJudge</name>
    <message>
        <source>Not yet: the run does not use what you have written. Mend its mistakes first.</source>
        <translation>Todavía no: la ejecución no usa lo que has escrito. Corrige antes sus errores.</translation>
    </message>
    <message>
        <source>Not yet: this level needs %1. Switch it on.</source>
        <translation>Todavía no: este nivel necesita %1. Actívalo.</translation>
    </message>
    <message>
        <source>Not yet: your scene has no body %1, which this level is about. Undo, or start again.</source>
        <translation>Todavía no: en tu escena falta el cuerpo %1, del que trata este nivel. Deshaz, o empieza de nuevo.</translation>
    </message>
    <message>
        <source>Not yet: this level asks you to leave %1 at %2.</source>
        <translation>Todavía no: este nivel pide dejar %1 en %2.</translation>
    </message>
    <message>
        <source>Not yet: this level asks you to leave %1 as it was: place, speed, mass and size. Undo, or start again.</source>
        <translation>Todavía no: este nivel pide dejar %1 como estaba: lugar, rapidez, masa y tamaño. Deshaz, o empieza de nuevo.</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 es %2</translation>
    </message>
    <message>
        <source>Not yet: the run stops in frame %1. %2</source>
        <translation>Todavía no: la ejecución se para en el fotograma %1. %2</translation>
    </message>
    <message>
        <source>Not yet: at the start, this does not hold: %1.</source>
        <translation>Todavía no: al principio no se cumple esto: %1.</translation>
    </message>
    <message>
        <source>Not yet: in frame %1, this does not hold: %2.</source>
        <translation>Todavía no: en el fotograma %1 no se cumple esto: %2.</translation>
    </message>
    <message>
        <source>Not yet: up to frame %1, this never happens: %2.</source>
        <translation>Todavía no: hasta el fotograma %1 nunca ocurre esto: %2.</translation>
    </message>
    <message>
        <source>Not yet: at the end, in frame %1, this does not hold: %2.</source>
        <translation>Todavía no: al final, en el fotograma %1, no se cumple esto: %2.</translation>
    </message>
    <message>
        <source>Not yet: %1</source>
        <translation>Todavía no: %1</translation>
    </message>
</context>
<context>
    <name>PropertyRangesText</name>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>How far to the right it starts.</source>
        <translation>A qué distancia hacia la derecha empieza.</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>How far down it starts.</source>
        <translation>A qué distancia hacia abajo empieza.</translation>
    </message>
    <message>
        <source>Speed x</source>
        <translation>Velocidad x</translation>
    </message>
    <message>
        <source>px/frame</source>
        <translation>px/fotograma</translation>
    </message>
    <message>
        <source>How fast it starts to the right.</source>
        <translation>Con qué rapidez empieza hacia la derecha.</translation>
    </message>
    <message>
        <source>Speed y</source>
        <translation>Velocidad y</translation>
    </message>
    <message>
        <source>How fast it starts downwards.</source>
        <translation>Con qué rapidez empieza hacia abajo.</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masa</translation>
    </message>
    <message>
        <source>How hard it is to move. Most bodies have 1.</source>
        <translation>Cuánto cuesta moverlo. La mayoría de los cuerpos tienen 1.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Tamaño</translation>
    </message>
    <message>
        <source>Its width: walls stop its edge, and the wind pushes against it.</source>
        <translation>Su anchura: las paredes detienen su borde, y el viento lo empuja.</translation>
    </message>
    <message>
        <source>Nailed</source>
        <translation>Clavado</translation>
    </message>
    <message>
        <source>Whether it is fixed in place.</source>
        <translation>Si está fijo en su lugar.</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Rigidez</translation>
    </message>
    <message>
        <source>1/frame²</source>
        <translation>1/fotograma²</translation>
    </message>
    <message>
        <source>How hard it pulls a body of mass 1: this share of the missing distance in each frame.</source>
        <translation>Con qué fuerza tira de un cuerpo de masa 1: esta fracción de la distancia que falta, en cada fotograma.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longitud</translation>
    </message>
    <message>
        <source>How far apart its two ends should be.</source>
        <translation>A qué distancia deben estar sus dos extremos.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Fracción</translation>
    </message>
    <message>
        <source>The share of a length error that its first end corrects; the other end corrects the rest.</source>
        <translation>La fracción de un error de longitud que corrige su primer extremo; el otro extremo corrige el resto.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Ángulo</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>The angle of the foot, seen from its body: 0 is left of the body, 90 above it.</source>
        <translation>El ángulo del pie, visto desde su cuerpo: 0 es a la izquierda del cuerpo, 90 encima de él.</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Pierna</translation>
    </message>
    <message>
        <source>How long the legs of this gait group are.</source>
        <translation>Cuánto miden las piernas de este grupo de marcha.</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Descenso</translation>
    </message>
    <message>
        <source>How far below the body the legs of this gait group end.</source>
        <translation>Cuánto por debajo del cuerpo terminan las piernas de este grupo de marcha.</translation>
    </message>
    <message>
        <source>Swing</source>
        <translation>Balanceo</translation>
    </message>
    <message>
        <source>rad/frame</source>
        <translation>rad/fotograma</translation>
    </message>
    <message>
        <source>How fast the clock of this gait group turns its legs. 0: they stand still. To walk, feet need ground.</source>
        <translation>Con qué rapidez gira las piernas el reloj de este grupo de marcha. 0: están quietas. Para caminar, los pies necesitan suelo.</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Inicio</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>rad</translation>
    </message>
    <message>
        <source>The angle at which that clock starts. Groups with different angles step in turn.</source>
        <translation>El ángulo en el que empieza ese reloj. Los grupos con ángulos distintos pisan por turnos.</translation>
    </message>
    <message>
        <source>Carries</source>
        <translation>Lleva</translation>
    </message>
    <message>
        <source>Whether the feet push the body back. If they do not, they cannot carry it.</source>
        <translation>Si los pies empujan el cuerpo de vuelta. Si no, no pueden llevarlo.</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Grupo</translation>
    </message>
    <message>
        <source>The gait group: its feet share one clock.</source>
        <translation>El grupo de marcha: sus pies comparten un reloj.</translation>
    </message>
</context>
<context>
    <name>PullCardText</name>
    <message>
        <source>px/frame²</source>
        <translation>px/fotograma²</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Mayús</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retroceso</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Intro</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Insert</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Supr</translation>
    </message>
</context>
<context>
    <name>QuantityText</name>
    <message>
        <source>time</source>
        <translation>tiempo</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>velocity x</source>
        <translation>velocidad x</translation>
    </message>
    <message>
        <source>velocity y</source>
        <translation>velocidad y</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>rapidez</translation>
    </message>
    <message>
        <source>acceleration x</source>
        <translation>aceleración x</translation>
    </message>
    <message>
        <source>acceleration y</source>
        <translation>aceleración y</translation>
    </message>
    <message>
        <source>size of acceleration</source>
        <translation>módulo de la aceleración</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>ángulo</translation>
    </message>
    <message>
        <source>turning speed</source>
        <translation>rapidez de giro</translation>
    </message>
    <message>
        <source>kinetic energy</source>
        <translation>energía cinética</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distancia</translation>
    </message>
    <message>
        <source>total kinetic energy</source>
        <translation>energía cinética total</translation>
    </message>
    <message>
        <source>total potential energy</source>
        <translation>energía potencial total</translation>
    </message>
    <message>
        <source>total energy</source>
        <translation>energía total</translation>
    </message>
    <message>
        <source>Frames since the start of the run</source>
        <translation>Fotogramas desde el inicio de la ejecución</translation>
    </message>
    <message>
        <source>How far to the right it is</source>
        <translation>A qué distancia hacia la derecha está</translation>
    </message>
    <message>
        <source>How far down it is: y grows downwards, in the picture and in plots</source>
        <translation>A qué distancia hacia abajo está: el eje y crece hacia abajo, en la imagen y en las gráficas</translation>
    </message>
    <message>
        <source>How far it moves to the right in a frame</source>
        <translation>Cuánto se mueve hacia la derecha en un fotograma</translation>
    </message>
    <message>
        <source>How far it moves down in a frame</source>
        <translation>Cuánto se mueve hacia abajo en un fotograma</translation>
    </message>
    <message>
        <source>How far it moves in a frame, in any direction</source>
        <translation>Cuánto se mueve en un fotograma, en cualquier dirección</translation>
    </message>
    <message>
        <source>How much its velocity to the right changed in the last frame</source>
        <translation>Cuánto cambió su velocidad hacia la derecha en el último fotograma</translation>
    </message>
    <message>
        <source>How much its velocity downwards changed in the last frame</source>
        <translation>Cuánto cambió su velocidad hacia abajo en el último fotograma</translation>
    </message>
    <message>
        <source>How much its velocity changed in the last frame, in any direction</source>
        <translation>Cuánto cambió su velocidad en el último fotograma, en cualquier dirección</translation>
    </message>
    <message>
        <source>Where it points: 0° is to the right, and 90° is down</source>
        <translation>Hacia dónde apunta: 0° es hacia la derecha, y 90° es hacia abajo</translation>
    </message>
    <message>
        <source>How much its angle changes in a frame</source>
        <translation>Cuánto cambia su ángulo en un fotograma</translation>
    </message>
    <message>
        <source>Half its mass times the square of its speed</source>
        <translation>La mitad de su masa por el cuadrado de su rapidez</translation>
    </message>
    <message>
        <source>How far two bodies are from each other, centre to centre</source>
        <translation>A qué distancia están dos cuerpos, de centro a centro</translation>
    </message>
    <message>
        <source>The energy of motion of everything together</source>
        <translation>La energía de movimiento de todo el conjunto</translation>
    </message>
    <message>
        <source>The energy stored in springs and in height</source>
        <translation>La energía almacenada en los muelles y en la altura</translation>
    </message>
    <message>
        <source>Kinetic and potential energy of everything together</source>
        <translation>La energía cinética y potencial de todo el conjunto</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>fotogramas</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>px/frame</source>
        <translation>px/fotograma</translation>
    </message>
    <message>
        <source>px/frame²</source>
        <translation>px/fotograma²</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>grados</translation>
    </message>
    <message>
        <source>degrees/frame</source>
        <translation>grados/fotograma</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 de %2</translation>
    </message>
    <message>
        <source>%1 %2 – %3</source>
        <translation>%1 %2 – %3</translation>
    </message>
    <message>
        <source>There is no %1 in this step. Choose another body above. The curve returns in the next step that has %1.</source>
        <translation>En este paso no hay «%1». Elige arriba otro cuerpo. La curva vuelve en el próximo paso que tenga «%1».</translation>
    </message>
    <message>
        <source>%1 is moved from outside, so it has no velocity of its own. Choose its position above instead.</source>
        <translation>%1 se mueve desde fuera, así que no tiene velocidad propia. Elige arriba su posición en su lugar.</translation>
    </message>
    <message>
        <source>This scene has only points, and points have no angle. Choose another quantity above.</source>
        <translation>Esta escena solo tiene puntos, y los puntos no tienen ángulo. Elige arriba otra magnitud.</translation>
    </message>
</context>
<context>
    <name>QuotingText</name>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 y %2 más</translation>
    </message>
</context>
<context>
    <name>ReferenceMarksText</name>
    <message>
        <source>%1 off the reference here</source>
        <translation>aquí, a %1 de la referencia</translation>
    </message>
</context>
<context>
    <name>RestText</name>
    <message>
        <source>Everything is at rest: a frame costs nothing until you touch something.</source>
        <translation>Todo está en reposo: un fotograma no cuesta nada hasta que toques algo.</translation>
    </message>
    <message>
        <source>Nothing can rest now, because “%1” changes over time.</source>
        <translation>Ahora nada puede quedar en reposo, porque «%1» cambia con el tiempo.</translation>
    </message>
    <message>
        <source>With a method that chooses its own steps, bodies at rest cost as much as moving ones.</source>
        <translation>Con un método que elige sus propios pasos de tiempo, los cuerpos en reposo cuestan tanto como los que se mueven.</translation>
    </message>
    <message>
        <source>Bodies at rest cost nothing until you touch them.</source>
        <translation>Los cuerpos en reposo no cuestan nada hasta que los toques.</translation>
    </message>
</context>
<context>
    <name>RuleCode</name>
    <message>
        <source>The force on each body.</source>
        <translation>La fuerza sobre cada cuerpo.</translation>
    </message>
    <message>
        <source>me.position is in px, y points down.</source>
        <translation>me.position está en px; el eje y apunta hacia abajo.</translation>
    </message>
    <message>
        <source>me.velocity is in px per frame.</source>
        <translation>me.velocity está en px por fotograma.</translation>
    </message>
    <message>
        <source>The force on me from other.</source>
        <translation>La fuerza sobre me que viene de other.</translation>
    </message>
    <message>
        <source>It acts on both ends of each rule link.</source>
        <translation>Actúa en los dos extremos de cada unión de la regla.</translation>
    </message>
    <message>
        <source>Change rule</source>
        <translation>Cambiar regla</translation>
    </message>
    <message>
        <source>Delete rule</source>
        <translation>Eliminar regla</translation>
    </message>
    <message>
        <source>your rule</source>
        <translation>tu regla</translation>
    </message>
    <message>
        <source>no rule</source>
        <translation>ninguna regla</translation>
    </message>
</context>
<context>
    <name>RuleErrorText</name>
    <message>
        <source>Line %1 of your rule, for %2: %3</source>
        <translation>Línea %1 de tu regla, para %2: %3</translation>
    </message>
    <message>
        <source>Line %1 of your rule, for %2 and %3: %4</source>
        <translation>Línea %1 de tu regla, para %2 y %3: %4</translation>
    </message>
</context>
<context>
    <name>Ruler</name>
    <message>
        <source>%1&#x2009;px, %2°</source>
        <translation>%1&#x2009;px, %2°</translation>
    </message>
</context>
<context>
    <name>RunPositionText</name>
    <message>
        <source>step %1 of %2</source>
        <translation>paso de tiempo %1 de %2</translation>
    </message>
    <message>
        <source>%1 of %2 phases done</source>
        <translation>hechas %1 de %2 fases</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Fotograma %1</translation>
    </message>
    <message>
        <source>Frame %1, after %2, %3</source>
        <translation>Fotograma %1, tras «%2», %3</translation>
    </message>
</context>
<context>
    <name>RunProgramText</name>
    <message>
        <source>Line %1 of your code: %2</source>
        <translation>Línea %1 de tu código: %2</translation>
    </message>
    <message>
        <source>Stopped at frame %1. %2</source>
        <translation>Parado en el fotograma %1. %2</translation>
    </message>
</context>
<context>
    <name>RunSetupText</name>
    <message>
        <source>%1 cannot be %2. It can be: %3.</source>
        <translation>%1 no puede ser %2. Puede ser: %3.</translation>
    </message>
    <message>
        <source>%1 cannot be %2. It can be a number from %3 to %4.</source>
        <translation>%1 no puede ser %2. Puede ser un número de %3 a %4.</translation>
    </message>
    <message>
        <source>There is no body %1 here; there are %2.</source>
        <translation>Aquí no hay ningún cuerpo %1; hay %2.</translation>
    </message>
    <message>
        <source>There is no parameter %1 here; there are %2.</source>
        <translation>Aquí no hay ningún parámetro %1; hay %2.</translation>
    </message>
    <message>
        <source>There is no method %1; the methods are %2.</source>
        <translation>No hay ningún método %1; los métodos son %2.</translation>
    </message>
</context>
<context>
    <name>SandboxPropertiesText</name>
    <message>
        <source>Point %1</source>
        <translation>Punto %1</translation>
    </message>
    <message>
        <source>Spring</source>
        <translation>Muelle</translation>
    </message>
    <message>
        <source>%1 springs</source>
        <translation>%1 muelles</translation>
    </message>
    <message>
        <source>Stick</source>
        <translation>Barra</translation>
    </message>
    <message>
        <source>%1 sticks</source>
        <translation>%1 barras</translation>
    </message>
    <message>
        <source>Foot of %1</source>
        <translation>Pie de %1</translation>
    </message>
    <message>
        <source>Gait group %1</source>
        <translation>Grupo de marcha %1</translation>
    </message>
</context>
<context>
    <name>SandboxText</name>
    <message>
        <source>the order in which points move (%1), because here all move at once</source>
        <translation>el orden en que se mueven los puntos (%1), porque aquí se mueven todos a la vez</translation>
    </message>
    <message>
        <source>This is your own copy of the scene: change what you like.</source>
        <translation>Esta es tu propia copia de la escena: cambia lo que quieras.</translation>
    </message>
    <message>
        <source>This is your own copy of the scene. It could not be copied completely. Missing: %1.</source>
        <translation>Esta es tu propia copia de la escena. No se pudo copiar por completo. Falta: %1.</translation>
    </message>
    <message>
        <source>This scene has %1 points, but the sandbox allows only %2. Choose a smaller scene.</source>
        <translation>Esta escena tiene %1 puntos, pero el taller solo admite %2. Elige una escena más pequeña.</translation>
    </message>
    <message>
        <source>The sandbox cannot open this scene, because it has no branches with joints. Take another scene, or look at the examples in the sandbox.</source>
        <translation>El taller no puede abrir esta escena, porque no tiene ramas con articulaciones. Toma otra escena, o mira los ejemplos del taller.</translation>
    </message>
    <message>
        <source>This scene has flown apart: a point is more than %1 px away, or moves that far in a frame. Go back in time, and take the scene from there.</source>
        <translation>Esta escena ha salido volando en pedazos: un punto está a más de %1 px, o se mueve tanto en un fotograma. Retrocede en el tiempo y toma la escena de allí.</translation>
    </message>
    <message>
        <source>Take scene to sandbox</source>
        <translation>Llevar la escena al taller</translation>
    </message>
    <message>
        <source>Open example %1</source>
        <translation>Abrir el ejemplo %1</translation>
    </message>
    <message>
        <source>You can only build at the start of the run. Press Home to go there.</source>
        <translation>Solo puedes construir al inicio de la ejecución. Pulsa Inicio para ir allí.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Añadir %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Quitar %1</translation>
    </message>
    <message>
        <source>Start new scene</source>
        <translation>Empezar escena nueva</translation>
    </message>
    <message>
        <source>A new scene has one point, the fewest that a scene can have. Move it, or add parts to it.</source>
        <translation>Una escena nueva tiene un punto, lo mínimo que puede tener una escena. Muévelo, o añádele piezas.</translation>
    </message>
</context>
<context>
    <name>SceneExport</name>
    <message>
        <source>The picture of the scene is copied.</source>
        <translation>La imagen de la escena se ha copiado.</translation>
    </message>
    <message>
        <source>Picture of the scene</source>
        <translation>Imagen de la escena</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg)</source>
        <translation>Imágenes (*.png *.svg)</translation>
    </message>
    <message>
        <source>Could not save the picture: %1</source>
        <translation>No se pudo guardar la imagen: %1</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Guardado como %1.</translation>
    </message>
    <message>
        <source>Could not write the handout: %1</source>
        <translation>No se pudo escribir la hoja de trabajo: %1</translation>
    </message>
</context>
<context>
    <name>SceneOverlay</name>
    <message>
        <source>sum so far</source>
        <translation>suma parcial</translation>
    </message>
    <message>
        <source>sum of all pulls</source>
        <translation>suma de los tirones</translation>
    </message>
</context>
<context>
    <name>ScreenshotText</name>
    <message>
        <source>--mode is %1; it can be &quot;learn&quot; or &quot;measure&quot;.</source>
        <translation>--mode es %1; puede ser &quot;learn&quot; o &quot;measure&quot;.</translation>
    </message>
    <message>
        <source>--stability is %1; it can be &quot;gauge&quot;, &quot;reasons&quot;, or a map: &quot;step&quot;, &quot;damping&quot; or &quot;rest&quot;.</source>
        <translation>--stability es %1; puede ser &quot;gauge&quot;, &quot;reasons&quot; o un mapa: &quot;step&quot;, &quot;damping&quot; o &quot;rest&quot;.</translation>
    </message>
    <message>
        <source>%1 is not a step; name it as LESSON/STEP, as &quot;springstep lessons&quot; lists them.</source>
        <translation>%1 no es un paso; nómbralo como LESSON/STEP, tal como los lista &quot;springstep lessons&quot;.</translation>
    </message>
</context>
<context>
    <name>SentencesText</name>
    <message>
        <source>The step %1 is not allowed. It can be a whole number of frames, or 1 divided by a whole number, from 0.000001 to 100 frames.</source>
        <translation>El paso de tiempo %1 no está permitido. Puede ser un número entero de fotogramas, o 1 dividido por un número entero, de 0.000001 a 100 fotogramas.</translation>
    </message>
    <message>
        <source>The tolerance %1 is not allowed. It can be from 1e-13 to 100 px.</source>
        <translation>La tolerancia %1 no está permitida. Puede ir de 1e-13 a 100 px.</translation>
    </message>
    <message>
        <source>The method %1 chooses its own steps. Choose a tolerance in px instead of a step.</source>
        <translation>El método «%1» elige sus propios pasos de tiempo. Elige una tolerancia en px en vez de un paso de tiempo.</translation>
    </message>
    <message>
        <source>Stopped at frame %1: your code has a mistake that stops the next frame.</source>
        <translation>Parado en el fotograma %1: tu código tiene un error que detiene el siguiente fotograma.</translation>
    </message>
    <message>
        <source>Your code computes whole frames, so its step cannot be %1. Choose a step of 1 frame.</source>
        <translation>Tu código calcula fotogramas enteros, así que su paso de tiempo no puede ser %1. Elige un paso de 1 fotograma.</translation>
    </message>
    <message>
        <source>The method %1 has fixed steps. Choose a step in frames instead of a tolerance.</source>
        <translation>El método «%1» tiene pasos de tiempo fijos. Elige un paso de tiempo en fotogramas en vez de una tolerancia.</translation>
    </message>
    <message>
        <source>%1 acts once per step, so smaller steps give a different motion from the first frame on.</source>
        <translation>«%1» actúa una vez por paso de tiempo, así que con pasos más pequeños el movimiento es otro desde el primer fotograma.</translation>
    </message>
    <message>
        <source>There is nothing to compare with after frame %1.</source>
        <translation>Después del fotograma %1 no hay nada con lo que comparar.</translation>
    </message>
    <message>
        <source>The method %1 cannot compute %2: choose another method, or switch that effect off.</source>
        <translation>El método «%1» no puede calcular «%2»: elige otro método, o desactiva ese efecto.</translation>
    </message>
    <message>
        <source>The method %1 cannot compute this scene, because parts of it have no velocity of their own. Choose another method.</source>
        <translation>El método «%1» no puede calcular esta escena, porque partes de ella no tienen velocidad propia. Elige otro método.</translation>
    </message>
    <message>
        <source>Nothing in this scene can move. Leave at least one body free.</source>
        <translation>En esta escena no se puede mover nada. Deja libre al menos un cuerpo.</translation>
    </message>
    <message>
        <source>This scene has %1 points, and at most %2 can be measured with every method. Measure a smaller scene of the same kind: its results are valid for this one, too.</source>
        <translation>Esta escena tiene %1 puntos, y como máximo se pueden medir %2 con todos los métodos. Mide una escena más pequeña del mismo tipo: sus resultados valen también para esta.</translation>
    </message>
    <message>
        <source>This tree would have more than %1 branches: make its slope smaller than %2, or its smallest branch larger than %3.</source>
        <translation>Este árbol tendría más de %1 ramas: haz su reducción menor que %2, o su rama más pequeña mayor que %3.</translation>
    </message>
    <message>
        <source>Stick %1 ends at p%2, but there is no such point. There are %3 points, and the first is p0.</source>
        <translation>La barra %1 termina en p%2, pero no existe ese punto. Hay %3 puntos, y el primero es p0.</translation>
    </message>
    <message>
        <source>Spring %1 ends at p%2, but there is no such point. There are %3 points, and the first is p0.</source>
        <translation>El muelle %1 termina en p%2, pero no existe ese punto. Hay %3 puntos, y el primero es p0.</translation>
    </message>
    <message>
        <source>The event %1 before frame %2 has a value that is infinite or not a number. Give it a finite number.</source>
        <translation>El evento %1 antes del fotograma %2 tiene un valor que es infinito o no es un número. Dale un número finito.</translation>
    </message>
    <message>
        <source>The start of %1 has a value that is infinite or not a number. Give it a finite number.</source>
        <translation>El inicio de %1 tiene un valor que es infinito o no es un número. Dale un número finito.</translation>
    </message>
    <message>
        <source>These settings do not fit together: %1.</source>
        <translation>Estos ajustes no encajan entre sí: %1.</translation>
    </message>
    <message>
        <source>The spring of %1</source>
        <translation>El muelle de %1</translation>
    </message>
    <message>
        <source>The force on %1 (%2)</source>
        <translation>La fuerza sobre %1 (%2)</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>The spring %1</source>
        <translation>El muelle %1</translation>
    </message>
    <message>
        <source>Stopped at frame %1: the method needs too many steps for the next frame.</source>
        <translation>Parado en el fotograma %1: el método necesita demasiados pasos de tiempo para el siguiente fotograma.</translation>
    </message>
    <message>
        <source>%1 is strongest.</source>
        <translation>%1 es lo más fuerte.</translation>
    </message>
    <message>
        <source>The strongest force acts on %1.</source>
        <translation>La fuerza mayor actúa sobre %1.</translation>
    </message>
    <message>
        <source>Try a larger tolerance, or a method with fixed steps.</source>
        <translation>Prueba con una tolerancia mayor, o con un método de pasos de tiempo fijos.</translation>
    </message>
    <message>
        <source>Stopped at frame %1: in the next frame, a number is not finite.</source>
        <translation>Parado en el fotograma %1: en el siguiente fotograma, un número no es finito.</translation>
    </message>
    <message>
        <source>Stopped at frame %1: in the next frame, “%2” is too far away or too fast for a number (not finite).</source>
        <translation>Parado en el fotograma %1: en el siguiente fotograma, «%2» está demasiado lejos o va demasiado rápido para un número (no finito).</translation>
    </message>
    <message>
        <source>It began in “%1”.</source>
        <translation>Empezó en «%1».</translation>
    </message>
    <message>
        <source>It moves one body after the other, so the pulls between them do not cancel.</source>
        <translation>Mueve los cuerpos uno tras otro, así que los tirones entre ellos no se anulan.</translation>
    </message>
    <message>
        <source>It looks for the moment when a body leaves the walls, but here a body never leaves them.</source>
        <translation>Busca el instante en que un cuerpo sale de las paredes, pero aquí ningún cuerpo sale de ellas.</translation>
    </message>
    <message>
        <source>It would need about %1 steps in a frame, but stops after %2.</source>
        <translation>Necesitaría unos %1 pasos de tiempo en un fotograma, pero se para tras %2.</translation>
    </message>
    <message>
        <source>Without damping, the errors of its steps add up: to %1 px in %2 frames at worst.</source>
        <translation>Sin amortiguación, los errores de sus pasos de tiempo se acumulan: en el peor caso, %1 px en %2 fotogramas.</translation>
    </message>
    <message>
        <source>Because its steps may have errors of %1 px, it never comes fully to rest: it moves by up to %2 px a frame.</source>
        <translation>Como sus pasos de tiempo pueden tener errores de %1 px, nunca queda del todo en reposo: se mueve hasta %2 px por fotograma.</translation>
    </message>
    <message>
        <source>With a step of %1, its stiffest spring (stiffness %2) would swing from %3 px to %4 px, and farther.</source>
        <translation>Con un paso de tiempo de %1, su muelle más rígido (rigidez %2) oscilaría de %3 px a %4 px, y más lejos.</translation>
    </message>
    <message>
        <source>Its sticks are only tested with steps up to %1. With a step of %2, their errors are larger.</source>
        <translation>Sus barras solo se prueban con pasos de tiempo hasta %1. Con un paso de %2, sus errores son mayores.</translation>
    </message>
    <message>
        <source>With a step of %1, its stiffest spring (stiffness %2) would not stop swinging: of %3 px, %4 px would be left after %5 frames.</source>
        <translation>Con un paso de tiempo de %1, su muelle más rígido (rigidez %2) no dejaría de oscilar: de %3 px, quedarían %4 px tras %5 fotogramas.</translation>
    </message>
    <message>
        <source>After frame %1, the position of %2 is no longer a finite number: it overflowed in &quot;%3&quot;.</source>
        <translation>Tras el fotograma %1, la posición de %2 ya no es un número finito: se hizo demasiado grande en «%3».</translation>
    </message>
    <message>
        <source>After frame %1, the method needs more steps for one frame than allowed.</source>
        <translation>Tras el fotograma %1, el método necesita para un fotograma más pasos de tiempo de los permitidos.</translation>
    </message>
    <message>
        <source>At frame %1, %2 is more than %3 px away.</source>
        <translation>En el fotograma %1, %2 está a más de %3 px.</translation>
    </message>
    <message>
        <source>At frame %1, the centre of mass has moved %2 px, although nothing pushed it.</source>
        <translation>En el fotograma %1, el centro de masas se ha movido %2 px, aunque nada lo empujó.</translation>
    </message>
    <message>
        <source>At frame %1, the length of the stick between %2 and %3 is wrong by %4 px, more than the expected %5 px.</source>
        <translation>En el fotograma %1, la longitud de la barra entre %2 y %3 tiene un error de %4 px, más de los %5 px esperados.</translation>
    </message>
    <message>
        <source>At the end, %1 still moves %2 px a frame.</source>
        <translation>Al final, %1 aún se mueve %2 px por fotograma.</translation>
    </message>
    <message>
        <source>At the end, %1 is %2 px from where it should rest.</source>
        <translation>Al final, %1 está a %2 px de donde debería reposar.</translation>
    </message>
    <message>
        <source>At the end, the distance between %1 and %2 is wrong by %3 px.</source>
        <translation>Al final, la distancia entre %1 y %2 tiene un error de %3 px.</translation>
    </message>
    <message>
        <source>A second run differs from the first one at frame %1.</source>
        <translation>Una segunda ejecución difiere de la primera en el fotograma %1.</translation>
    </message>
    <message>
        <source>This input should be rejected, but it was accepted.</source>
        <translation>Esta entrada debería rechazarse, pero se aceptó.</translation>
    </message>
    <message>
        <source>The run should stop and name the number that is not finite, but it does not.</source>
        <translation>La ejecución debería parar y nombrar el número que no es finito, pero no lo hace.</translation>
    </message>
</context>
<context>
    <name>StabilityText</name>
    <message>
        <source>%1 × the limit</source>
        <translation>%1 × el límite</translation>
    </message>
    <message>
        <source>%1&#x2009;% of the limit</source>
        <translation>%1&#x2009;% del límite</translation>
    </message>
    <message>
        <source>%1&#x2009;frames</source>
        <translation>%1&#x2009;fotogramas</translation>
    </message>
    <message>
        <source>%1 sets the limit.</source>
        <translation>%1 fija el límite.</translation>
    </message>
    <message>
        <source>Past the limit it swings to the other side at each step, farther each time.</source>
        <translation>Pasado el límite, oscila al otro lado en cada paso de tiempo, cada vez más lejos.</translation>
    </message>
    <message>
        <source>Past the limit it swings wider and wider.</source>
        <translation>Pasado el límite, oscila cada vez más.</translation>
    </message>
    <message>
        <source>Past the limit all of it drifts off, faster and faster: one end moves before the other does, so their pulls do not cancel.</source>
        <translation>Pasado el límite, todo se aleja cada vez más rápido: un extremo se mueve antes que el otro, así que sus tirones no se anulan.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Every step is stable, because of the damping.&lt;/b&gt; However long it is, no swing grows here.</source>
        <translation>&lt;b&gt;Todo paso de tiempo es estable gracias a la amortiguación.&lt;/b&gt; Por largo que sea, aquí no crece ninguna oscilación.</translation>
    </message>
    <message>
        <source>&lt;b&gt;No step is stable.&lt;/b&gt; This one is so short that the growth is too slow to notice.</source>
        <translation>&lt;b&gt;Ningún paso de tiempo es estable.&lt;/b&gt; Este es tan corto que el crecimiento es demasiado lento para notarse.</translation>
    </message>
    <message>
        <source>&lt;b&gt;No shorter step is stable.&lt;/b&gt; This one is, because of the damping.</source>
        <translation>&lt;b&gt;Ningún paso de tiempo más corto es estable.&lt;/b&gt; Este sí, gracias a la amortiguación.</translation>
    </message>
    <message>
        <source>&lt;b&gt;No step is stable.&lt;/b&gt; With this method and so little damping, small disturbances %1. They also grow with any shorter step.</source>
        <translation>&lt;b&gt;Ningún paso de tiempo es estable.&lt;/b&gt; Con este método y tan poca amortiguación, las pequeñas perturbaciones %1. También crecen con cualquier paso más corto.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1, but still stable.&lt;/b&gt; Steps longer than %2 are unstable, but this one is so long that the damping makes it stable again.</source>
        <translation>&lt;b&gt;%1, pero aún estable.&lt;/b&gt; Los pasos de tiempo de más de %2 son inestables, pero este es tan largo que la amortiguación lo vuelve a hacer estable.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1.&lt;/b&gt; Small disturbances %2. Steps up to %3 are stable.</source>
        <translation>&lt;b&gt;%1.&lt;/b&gt; Las pequeñas perturbaciones %2. Los pasos de tiempo hasta %3 son estables.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1.&lt;/b&gt; Steps up to %2 are stable here.</source>
        <translation>&lt;b&gt;%1.&lt;/b&gt; Aquí los pasos de tiempo hasta %2 son estables.</translation>
    </message>
    <message>
        <source>grow more than a million times a frame</source>
        <translation>se multiplican por más de un millón en cada fotograma</translation>
    </message>
    <message>
        <source>grow by %1&#x2009;% a frame</source>
        <translation>crecen un %1&#x2009;% por fotograma</translation>
    </message>
    <message>
        <source>grow %1 times a frame</source>
        <translation>se multiplican por %1 en cada fotograma</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>sin límite</translation>
    </message>
    <message>
        <source>by its tolerance</source>
        <translation>por su tolerancia</translation>
    </message>
    <message>
        <source>no springs act</source>
        <translation>sin muelles activos</translation>
    </message>
    <message>
        <source>unknown here</source>
        <translation>desconocido aquí</translation>
    </message>
    <message>
        <source>too many points</source>
        <translation>demasiados puntos</translation>
    </message>
    <message>
        <source>stable by damping</source>
        <translation>estable por amortiguación</translation>
    </message>
    <message>
        <source>just stable</source>
        <translation>apenas estable</translation>
    </message>
    <message>
        <source>no stable step</source>
        <translation>ningún paso estable</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 has no such limit.&lt;/b&gt; Long steps are stable, however stiff the springs are; they are only less accurate. Choose the step for the accuracy that you want.</source>
        <translation>&lt;b&gt;«%1» no tiene ese límite.&lt;/b&gt; Los pasos de tiempo largos son estables, por rígidos que sean los muelles; solo son menos precisos. Elige el paso según la precisión que quieras.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 keeps its own steps short enough.&lt;/b&gt; Its tolerance, %2, limits them.</source>
        <translation>&lt;b&gt;«%1» mantiene sus pasos de tiempo lo bastante cortos.&lt;/b&gt; Su tolerancia, %2, los limita.</translation>
    </message>
    <message>
        <source>&lt;b&gt;No springs act here.&lt;/b&gt; The other effects have no stiffness, so no step is too long for them.</source>
        <translation>&lt;b&gt;Aquí no actúa ningún muelle.&lt;/b&gt; Los demás efectos no tienen rigidez, así que ningún paso de tiempo es demasiado largo para ellos.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Unknown here.&lt;/b&gt; The pulls in this state are not finite numbers.</source>
        <translation>&lt;b&gt;Desconocido aquí.&lt;/b&gt; Los tirones en este estado no son números finitos.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Too many points.&lt;/b&gt; With more than %1 of them, finding the limit would take too long. If the creatures do not touch each other, look at only a few of them: their limit is the same.</source>
        <translation>&lt;b&gt;Demasiados puntos.&lt;/b&gt; Con más de %1, hallar el límite llevaría demasiado tiempo. Si las criaturas no se tocan entre sí, mira solo unas pocas: su límite es el mismo.</translation>
    </message>
    <message>
        <source>Not included: %1. They act in jumps, once per step, and have no stiffness.</source>
        <translation>Sin incluir: %1. Actúan a saltos, una vez por paso de tiempo, y no tienen rigidez.</translation>
    </message>
    <message>
        <source>%1 For sticks that carry weight, smaller steps help more than more passes.</source>
        <translation>%1 Con barras que sostienen peso, ayudan más los pasos de tiempo menores que más pasadas.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Sticks keep their lengths.&lt;/b&gt; None was wrong by more than %1&#x2009;px in the last %2 frames.</source>
        <translation>&lt;b&gt;Las barras conservan su longitud.&lt;/b&gt; Ninguna falló por más de %1&#x2009;px en los últimos %2 fotogramas.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Sticks are up to %1&#x2009;px too long:&lt;/b&gt; %2 – %3 in the last %4 frames.</source>
        <translation>&lt;b&gt;Hay barras hasta %1&#x2009;px demasiado largas:&lt;/b&gt; %2 – %3 en los últimos %4 fotogramas.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Sticks are up to %1&#x2009;px too short:&lt;/b&gt; %2 – %3 in the last %4 frames.</source>
        <translation>&lt;b&gt;Hay barras hasta %1&#x2009;px demasiado cortas:&lt;/b&gt; %2 – %3 en los últimos %4 fotogramas.</translation>
    </message>
    <message>
        <source>%1 Neither shorter steps nor more passes halve this error. Perhaps the lengths contradict each other.</source>
        <translation>%1 Ni pasos de tiempo más cortos ni más pasadas reducen este error a la mitad. Quizá las longitudes se contradigan.</translation>
    </message>
    <message>
        <source>Use a &amp;step of %1</source>
        <translation>&amp;Paso de %1</translation>
    </message>
    <message>
        <source>Use a &amp;tolerance of %1</source>
        <translation>&amp;Tolerancia %1</translation>
    </message>
    <message>
        <source>&amp;Damp more: %1 %2</source>
        <translation>P&amp;oner %1 %2</translation>
    </message>
    <message numerus="yes">
        <source>Use %n &amp;passes</source>
        <translation>
            <numerusform>Usar %n pasa&amp;da</numerusform>
            <numerusform>Usar %n pasa&amp;das</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Use %1</source>
        <translation>&amp;Usar %1</translation>
    </message>
    <message>
        <source>sticks are then wrong by up to %1&#x2009;px</source>
        <translation>entonces las barras fallan hasta %1&#x2009;px</translation>
    </message>
    <message>
        <source>then at %1</source>
        <translation>entonces, %1</translation>
    </message>
    <message>
        <source>every step is then stable, because of the damping</source>
        <translation>entonces todo paso de tiempo es estable gracias a la amortiguación</translation>
    </message>
    <message>
        <source>chooses its own steps</source>
        <translation>elige sus propios pasos de tiempo</translation>
    </message>
    <message>
        <source>has no such limit</source>
        <translation>no tiene ese límite</translation>
    </message>
    <message>
        <source>&lt;b&gt;Unknown for your code.&lt;/b&gt; The limit follows from the springs of the scene, and your code may compute anything else.</source>
        <translation>&lt;b&gt;Desconocido para tu código.&lt;/b&gt; El límite se deduce de los muelles de la escena, y tu código puede calcular cualquier otra cosa.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Unknown for this rule.&lt;/b&gt; Its force depends on velocities, and the limit is computed from positions only. Try a shorter step: if the motion stays the same, the step is short enough.</source>
        <translation>&lt;b&gt;Desconocido para esta regla.&lt;/b&gt; Su fuerza depende de velocidades, y el límite se calcula solo a partir de las posiciones. Prueba un paso más corto: si el movimiento no cambia, el paso es lo bastante corto.</translation>
    </message>
</context>
<context>
    <name>StepText</name>
    <message>
        <source>1/%1 frame</source>
        <translation>1/%1 fotograma</translation>
    </message>
    <message>
        <source>1 frame</source>
        <translation>1 fotograma</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 fotogramas</translation>
    </message>
</context>
<context>
    <name>TerminalText</name>
    <message>
        <source>springstep: there is not enough memory for this; close other programs, or give it a smaller experiment.</source>
        <translation>springstep: no hay memoria suficiente para esto; cierra otros programas, o usa un experimento más pequeño.</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Parado: %1</translation>
    </message>
    <message>
        <source>%1… %2 s</source>
        <translation>%1… %2 s</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Fotograma %1 de %2</translation>
    </message>
    <message>
        <source>Stopped at frame %1 of %2.</source>
        <translation>Parado en el fotograma %1 de %2.</translation>
    </message>
    <message>
        <source>Stopped before the end.</source>
        <translation>Parado antes del final.</translation>
    </message>
</context>
<context>
    <name>TraceText</name>
    <message>
        <source>Setting up the run</source>
        <translation>Preparando la ejecución</translation>
    </message>
    <message>
        <source>The rows could not be written: %1. Free some disk space, or write to another folder.</source>
        <translation>No se pudieron escribir las filas: %1. Libera espacio en el disco, o escribe en otra carpeta.</translation>
    </message>
</context>
<context>
    <name>UnitCircle</name>
    <message>
        <source>The arrow has no length,</source>
        <translation>La flecha no tiene longitud,</translation>
    </message>
    <message>
        <source>so it has no direction.</source>
        <translation>así que no tiene dirección.</translation>
    </message>
    <message>
        <source>%1 = %2 / %3 = %4</source>
        <extracomment>cosine = 40 / 50 = 0.8</extracomment>
        <translation>%1 = %2 / %3 = %4</translation>
    </message>
    <message>
        <source>angle = %1° = %2&#x2009;rad</source>
        <translation>ángulo = %1° = %2&#x2009;rad</translation>
    </message>
    <message>
        <source>cosine</source>
        <translation>coseno</translation>
    </message>
    <message>
        <source>the side beside the angle</source>
        <translation>el lado contiguo</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>seno</translation>
    </message>
    <message>
        <source>the side opposite the angle</source>
        <translation>el lado opuesto</translation>
    </message>
    <message>
        <source>%1² + %2² = 1</source>
        <extracomment>Pythagoras: 0.8² + 0.6² = 1</extracomment>
        <translation>%1² + %2² = 1</translation>
    </message>
    <message>
        <source>y points down: a sine above 0 is down</source>
        <translation>eje y hacia abajo: seno mayor que 0 es abajo</translation>
    </message>
    <message>
        <source>Unit circle</source>
        <translation>Circunferencia unidad</translation>
    </message>
</context>
<context>
    <name>VerbsText</name>
    <message>
        <source>Prints the result as JSON.</source>
        <translation>Muestra el resultado como JSON.</translation>
    </message>
    <message>
        <source>Width and height in pixels, each from 100 to 9999.</source>
        <translation>Anchura y altura en píxeles, cada una de 100 a 9999.</translation>
    </message>
    <message>
        <source>light, dark or contrast.</source>
        <translation>light, dark o contrast.</translation>
    </message>
    <message>
        <source>The experiment.</source>
        <translation>El experimento.</translation>
    </message>
    <message>
        <source>The experiment or the step of a lesson.</source>
        <translation>El experimento o el paso de una lección.</translation>
    </message>
    <message>
        <source>Lists lessons, steps, parameters and methods.</source>
        <translation>Lista las lecciones, los pasos, los parámetros y los métodos.</translation>
    </message>
    <message>
        <source>Computes the run of an experiment and writes every frame as CSV.</source>
        <translation>Calcula la ejecución de un experimento y escribe cada fotograma como CSV.</translation>
    </message>
    <message>
        <source>Measures the error of each method on a scene, and its cost.</source>
        <translation>Mide el error de cada método en una escena, y su coste.</translation>
    </message>
    <message>
        <source>Also draws error against time, as an SVG file.</source>
        <translation>Además dibuja el error frente al tiempo, como archivo SVG.</translation>
    </message>
    <message>
        <source>Also names the cheapest method and step with an error of at most E px.</source>
        <translation>Además indica el método y el paso de tiempo más baratos con un error de E px como máximo.</translation>
    </message>
    <message>
        <source>The number of frames to compute (default: the file&apos;s, at most 1000, or 200 for a step).</source>
        <translation>El número de fotogramas que se calculan (por defecto: el del archivo, como máximo 1000, o 200 para un paso).</translation>
    </message>
    <message>
        <source>Runs every hard case with every method. The exit code is 1 if a method fails a case that it claims.</source>
        <translation>Ejecuta cada caso difícil con cada método. El código de salida es 1 si un método falla en un caso que garantiza.</translation>
    </message>
    <message>
        <source>Runs this case only.</source>
        <translation>Ejecuta solo este caso.</translation>
    </message>
    <message>
        <source>Runs the cases at full size. Some take hours.</source>
        <translation>Ejecuta los casos a tamaño completo. Algunos tardan horas.</translation>
    </message>
    <message>
        <source>Measures the time of a frame, and of each effect in it.</source>
        <translation>Mide el tiempo de un fotograma y de cada efecto en él.</translation>
    </message>
    <message>
        <source>Measures the frames after frame N.</source>
        <translation>Mide los fotogramas tras el fotograma N.</translation>
    </message>
    <message>
        <source>Draws the window as a learner sees it.</source>
        <translation>Dibuja la ventana tal como la ve quien aprende.</translation>
    </message>
    <message>
        <source>The step to open.</source>
        <translation>El paso que se abre.</translation>
    </message>
    <message>
        <source>The picture to write.</source>
        <translation>La imagen que se escribe.</translation>
    </message>
    <message>
        <source>Goes to frame N.</source>
        <translation>Va al fotograma N.</translation>
    </message>
    <message>
        <source>Stops after P phases inside the next frame.</source>
        <translation>Se para tras P fases dentro del siguiente fotograma.</translation>
    </message>
    <message>
        <source>learn or measure.</source>
        <translation>learn o measure.</translation>
    </message>
    <message>
        <source>Shows where energy went.</source>
        <translation>Muestra adónde ha ido la energía.</translation>
    </message>
    <message>
        <source>Shows the cost of each effect.</source>
        <translation>Muestra el coste de cada efecto.</translation>
    </message>
    <message>
        <source>Shows the plots.</source>
        <translation>Muestra las gráficas.</translation>
    </message>
    <message>
        <source>gauge, reasons, or a map: step, damping or rest.</source>
        <translation>gauge, reasons o un mapa: step, damping o rest.</translation>
    </message>
    <message>
        <source>Makes a film of the run of an experiment: a WebM video, an animated GIF, a PNG for each frame, or a web page that plays it.</source>
        <translation>Hace un vídeo de la ejecución de un experimento: un vídeo WebM, un GIF animado, un PNG por fotograma o una página web que la reproduce.</translation>
    </message>
    <message>
        <source>The film: OUT.webm, OUT.gif, OUT.html, or OUT_%04d.png, where %04d stands for the number of the frame with 4 digits, such as 0007. %d writes 7, and the files do not sort by name.</source>
        <translation>El vídeo: OUT.webm, OUT.gif, OUT.html o OUT_%04d.png, donde %04d es el número del fotograma con 4 cifras, como 0007. %d escribe 7; así el nombre no ordena los archivos.</translation>
    </message>
    <message>
        <source>The first frame.</source>
        <translation>El primer fotograma.</translation>
    </message>
    <message>
        <source>The last frame (default: the file&apos;s number of frames).</source>
        <translation>El último fotograma (por defecto: el número de fotogramas del archivo).</translation>
    </message>
    <message>
        <source>Frames per second, up to 50 in a GIF and 120 otherwise (default 30). Not for PNG files.</source>
        <translation>Fotogramas por segundo, hasta 50 en un GIF y 120 en los demás casos (por defecto 30). No para archivos PNG.</translation>
    </message>
    <message>
        <source>Checks notebooks by replaying every run, makes a page of one, or writes your own. The exit code is 1 if a run does not show what its notebook says.</source>
        <translation>Comprueba cuadernos volviendo a reproducir cada ejecución, hace una página de uno o escribe el tuyo. El código de salida es 1 si una ejecución no muestra lo que dice su cuaderno.</translation>
    </message>
    <message>
        <source>check FILE..., page FILE OUT.html, page FILE OUT.pdf, or write OUT.springstep-notebook.</source>
        <translation>check FILE..., page FILE OUT.html, page FILE OUT.pdf o write OUT.springstep-notebook.</translation>
    </message>
    <message>
        <source>Prints the result as CSV.</source>
        <translation>Muestra el resultado como CSV.</translation>
    </message>
    <message>
        <source>The name to write into the notebook.</source>
        <translation>El nombre que se escribe en el cuaderno.</translation>
    </message>
    <message>
        <source>The lessons to write (default: all).</source>
        <translation>Las lecciones que se incluyen (por defecto: todas).</translation>
    </message>
    <message>
        <source>Checks a lesson of your own, and plays the solution of each thing to try. The exit code is 1 if one fails.</source>
        <translation>Comprueba una lección tuya y reproduce la solución de cada prueba. El código de salida es 1 si una falla.</translation>
    </message>
    <message>
        <source>The folder of the lesson, or its zip.</source>
        <translation>La carpeta de la lección, o su zip.</translation>
    </message>
    <message>
        <source>Writes a lesson on paper: its texts, pictures and questions with lines to write on. The answers follow on separate pages.</source>
        <translation>Escribe una lección en papel: sus textos, imágenes y preguntas, con líneas para escribir. Las respuestas van en páginas aparte.</translation>
    </message>
    <message>
        <source>A lesson, or the folder or the zip of one.</source>
        <translation>Una lección, o la carpeta o el zip de una.</translation>
    </message>
    <message>
        <source>The PDF to write.</source>
        <translation>El PDF que se escribe.</translation>
    </message>
    <message>
        <source>en, de, es or fr (default: that of the system).</source>
        <translation>en, de, es o fr (por defecto: el del sistema).</translation>
    </message>
    <message>
        <source>A plot on a web page, such as &quot;y(body)&quot;, &quot;energy&quot; or &quot;y(body):x(body)&quot;. Repeat it for more.</source>
        <translation>Una gráfica en una página web, como &quot;y(body)&quot;, &quot;energy&quot; o &quot;y(body):x(body)&quot;. Se puede repetir.</translation>
    </message>
    <message>
        <source>The run in FILE that a web page shows as the ghost.</source>
        <translation>La ejecución de FILE que una página web muestra como fantasma.</translation>
    </message>
    <message>
        <source>The notebooks, or the notebook and the page to write; and the lessons without C++ that they are about, as folders or zips.</source>
        <translation>Los cuadernos, o el cuaderno y la página que se escribe; y las lecciones sin C++ de las que tratan, como carpetas o zips.</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>L&amp;earn</source>
        <translation>Apr&amp;ender</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Medir</translation>
    </message>
    <message>
        <source>&amp;Build</source>
        <translation>&amp;Construir</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Acercar</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ale&amp;jar</translation>
    </message>
    <message>
        <source>&amp;Fit the scene</source>
        <translation>Ajus&amp;tar la escena</translation>
    </message>
    <message>
        <source>Ne&amp;xt body outside</source>
        <translation>Siguiente cuer&amp;po fuera</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>&amp;Lecciones</translation>
    </message>
    <message>
        <source>Lessons &amp;as a narrow strip</source>
        <translation>Lecciones en franja estrec&amp;ha</translation>
    </message>
    <message>
        <source>&amp;Code and parameters</source>
        <translation>Có&amp;digo y parámetros</translation>
    </message>
    <message>
        <source>E&amp;nergy</source>
        <translation>Ener&amp;gía</translation>
    </message>
    <message>
        <source>Effec&amp;ts</source>
        <translation>E&amp;fectos</translation>
    </message>
    <message>
        <source>&amp;Plots</source>
        <translation>G&amp;ráficas</translation>
    </message>
    <message>
        <source>&amp;Stability of the step</source>
        <translation>Esta&amp;bilidad del paso de tiempo</translation>
    </message>
    <message>
        <source>Map of the time to rest</source>
        <translation>Mapa del tiempo hasta el reposo</translation>
    </message>
    <message>
        <source>How many frames the run takes to come to rest, for each stiffness and damping</source>
        <translation>Cuántos fotogramas tarda la ejecución en quedar en reposo, para cada rigidez y amortiguación</translation>
    </message>
    <message>
        <source>&amp;Unlock: panels can be moved</source>
        <translation>&amp;Desbloquear: los paneles se pueden mover</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>Osc&amp;uro</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>Alto co&amp;ntraste</translation>
    </message>
    <message>
        <source>Less mo&amp;vement</source>
        <translation>Menos mo&amp;vimiento</translation>
    </message>
    <message>
        <source>Scene onl&amp;y</source>
        <translation>&amp;Solo la escena</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Pantalla c&amp;ompleta</translation>
    </message>
    <message>
        <source>Lessons, scene and code</source>
        <translation>Lecciones, escena y código</translation>
    </message>
    <message>
        <source>The error and the cost of each method for this scene</source>
        <translation>El error y el coste de cada método en esta escena</translation>
    </message>
    <message>
        <source>Build your own scene from points, springs, sticks and feet</source>
        <translation>Construye tu propia escena con puntos, muelles, barras y pies</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajustar</translation>
    </message>
    <message>
        <source>Show the whole scene with all bodies, and keep them in view</source>
        <translation>Mostrar toda la escena con todos los cuerpos, y mantenerlos a la vista</translation>
    </message>
    <message>
        <source>Bring a body that is outside the picture into view</source>
        <translation>Traer a la vista un cuerpo que está fuera de la imagen</translation>
    </message>
    <message>
        <source>Show only the symbols of the lessons, to save space</source>
        <translation>Mostrar solo los símbolos de las lecciones, para ahorrar espacio</translation>
    </message>
    <message>
        <source>Where energy and momentum went</source>
        <translation>Adónde fueron la energía y el momento lineal</translation>
    </message>
    <message>
        <source>The cost of each effect in the scene, with a switch for each</source>
        <translation>El coste de cada efecto de la escena, con un interruptor para cada uno</translation>
    </message>
    <message>
        <source>Curves of any quantity of any body</source>
        <translation>Curvas de cualquier magnitud de cualquier cuerpo</translation>
    </message>
    <message>
        <source>Drag a panel by its title to another place</source>
        <translation>Arrastra un panel por su título a otro lugar</translation>
    </message>
    <message>
        <source>Moves the panels back to their original places, in this mode only</source>
        <translation>Devuelve los paneles a sus lugares originales, solo en este modo</translation>
    </message>
    <message>
        <source>Panels and menus open without animation, and wind is drawn as a still picture. Only the simulation moves</source>
        <translation>Los paneles y menús se abren sin animación, y el viento se dibuja como imagen fija. Solo se mueve la simulación</translation>
    </message>
    <message>
        <source>Show only the scene and its timeline. Press again to bring the panels back</source>
        <translation>Mostrar solo la escena y su línea de tiempo. Pulsa otra vez para recuperar los paneles</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Restablecer</translation>
    </message>
    <message>
        <source>Unit circle</source>
        <translation>Circunferencia unidad</translation>
    </message>
    <message>
        <source>Show the angle of an arrow, its cosine and its sine on a circle</source>
        <translation>Mostrar el ángulo de una flecha, su coseno y su seno en una circunferencia</translation>
    </message>
</context>
<context>
    <name>WebPageCliText</name>
    <message>
        <source>--%1 is for films; a web page has the size and the colours of its reader&apos;s browser. Leave it out.</source>
        <translation>--%1 es para vídeos; una página web tiene el tamaño y los colores del navegador de quien la lee. Omítelo.</translation>
    </message>
    <message>
        <source>--plot is %1; it can be %2, with its bodies, as in %3 and %4.</source>
        <translation>--plot es %1; puede ser %2, con sus cuerpos, como en %3 y %4.</translation>
    </message>
    <message>
        <source>--plot is %1, but there is no %2; there is %3.</source>
        <translation>--plot es %1, pero no hay %2; hay %3.</translation>
    </message>
    <message>
        <source>--plot is %1, which has no value in this scene. Choose another one.</source>
        <translation>--plot es %1, que no tiene valor en esta escena. Elige otra cosa.</translation>
    </message>
    <message>
        <source>--plot is given %1 times; a web page has room for %2 plots.</source>
        <translation>--plot aparece %1 veces; en una página web caben %2 gráficas.</translation>
    </message>
    <message>
        <source>--ghost is %1, but FILE has no other run. Keep one in the window.</source>
        <translation>--ghost es %1, pero FILE no tiene otra ejecución. Conserva una en la ventana.</translation>
    </message>
    <message>
        <source>--ghost is %1; it can be %2.</source>
        <translation>--ghost es %1; puede ser %2.</translation>
    </message>
</context>
<context>
    <name>WebPageText</name>
    <message>
        <source>A web page has room for %1 frames of this scene, and this would be %2. Choose fewer frames.</source>
        <translation>En una página web caben %1 fotogramas de esta escena, y serían %2. Elige menos fotogramas.</translation>
    </message>
    <message>
        <source>The last frame, %1, comes before the first, %2. Swap them.</source>
        <translation>El último fotograma, %1, va antes que el primero, %2. Intercámbialos.</translation>
    </message>
    <message>
        <source>The bodies of %1 frames do not fit on a web page. Choose fewer frames.</source>
        <translation>Los cuerpos de %1 fotogramas no caben en una página web. Elige menos fotogramas.</translation>
    </message>
    <message>
        <source>The run does not reach frame %1: it stops at frame %2. Begin the page earlier.</source>
        <translation>La ejecución no llega al fotograma %1: se para en el %2. Empieza la página antes.</translation>
    </message>
</context>
<context>
    <name>WebPageWords</name>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Un fotograma atrás</translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation>Un fotograma adelante</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Ir al inicio</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Fotograma</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Fotograma %1 de %2</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Velocidad</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Acercar</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Alejar</translation>
    </message>
    <message>
        <source>Fit the scene</source>
        <translation>Ajustar la escena</translation>
    </message>
    <message>
        <source>Trails</source>
        <translation>Estelas</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>Colores claros</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Colores oscuros</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>%1 at (%2, %3)</source>
        <translation>%1 en (%2, %3)</translation>
    </message>
    <message>
        <source>About this step</source>
        <translation>Sobre este paso</translation>
    </message>
    <message>
        <source>Listing</source>
        <translation>Listado</translation>
    </message>
    <message>
        <source>Beside each line: the values that this frame has set</source>
        <translation>Junto a cada línea: los valores que ha asignado este fotograma</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Gráficas</translation>
    </message>
    <message>
        <source>time, frames</source>
        <translation>tiempo, fotogramas</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>sin valor</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Teclas y ratón</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espacio</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>Izquierda, Derecha</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Inicio, Fin</translation>
    </message>
    <message>
        <source>Shift with arrows, or drag</source>
        <translation>Mayús con flechas, o arrastrar</translation>
    </message>
    <message>
        <source>Mouse wheel</source>
        <translation>Rueda del ratón</translation>
    </message>
    <message>
        <source>play or pause</source>
        <translation>reproducir o parar</translation>
    </message>
    <message>
        <source>one frame back or forward; with Ctrl, ten</source>
        <translation>un fotograma atrás o adelante; con Ctrl, diez</translation>
    </message>
    <message>
        <source>first or last frame</source>
        <translation>primer o último fotograma</translation>
    </message>
    <message>
        <source>move the view</source>
        <translation>mover la vista</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>acercar o alejar</translation>
    </message>
    <message>
        <source>light or dark colours</source>
        <translation>colores claros u oscuros</translation>
    </message>
    <message>
        <source>Made with Springstep</source>
        <translation>Hecho con Springstep</translation>
    </message>
    <message>
        <source>The run needs JavaScript. Allow it in this browser, and load the page again.</source>
        <translation>La ejecución necesita JavaScript. Permítelo en este navegador y vuelve a cargar la página.</translation>
    </message>
    <message>
        <source>This browser is too old to show the run. Use one from 2023 or later.</source>
        <translation>Este navegador es demasiado antiguo para mostrar la ejecución. Usa uno de 2023 o posterior.</translation>
    </message>
    <message>
        <source>The run on this page cannot be read: the file is damaged. Ask for it again.</source>
        <translation>No se puede leer la ejecución de esta página: el archivo está dañado. Pídelo otra vez.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Choose what the scene shows</source>
        <translation>Elegir qué muestra la escena</translation>
    </message>
    <message>
        <source>Velocity arrows</source>
        <translation>Flechas de velocidad</translation>
    </message>
    <message>
        <source>Onion skins</source>
        <translation>Papel cebolla</translation>
    </message>
    <message>
        <source>Ghost</source>
        <translation>Fantasma</translation>
    </message>
    <message>
        <source>Guide lines</source>
        <translation>Líneas guía</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Leyenda</translation>
    </message>
</context>
<context>
    <name>WholeFileText</name>
    <message>
        <source>%1: the file could not be written: %2. Choose another folder or name.</source>
        <translation>%1: no se pudo escribir el archivo: %2. Elige otra carpeta u otro nombre.</translation>
    </message>
    <message>
        <source>%1: there is no such file; check its name and folder.</source>
        <translation>%1: no existe ese archivo; comprueba su nombre y su carpeta.</translation>
    </message>
    <message>
        <source>%1: the file could not be read: %2.</source>
        <translation>%1: no se pudo leer el archivo: %2.</translation>
    </message>
    <message>
        <source>%1: this is a folder; give a file.</source>
        <translation>%1: es una carpeta; indica un archivo.</translation>
    </message>
    <message>
        <source>%1: the file is larger than %2 MiB, the maximum.</source>
        <translation>%1: el archivo ocupa más de %2 MiB, el máximo.</translation>
    </message>
</context>
<context>
    <name>ZipText</name>
    <message>
        <source>the zip is damaged. Get it again, or make a new zip of the folder.</source>
        <translation>el zip está dañado. Consíguelo otra vez, o haz un zip nuevo de la carpeta.</translation>
    </message>
    <message>
        <source>this is not a zip, or its end is missing. Choose the lesson.json or the zip of a lesson, or get the zip again.</source>
        <translation>esto no es un zip, o le falta el final. Elige el lesson.json o el zip de una lección, o consigue el zip otra vez.</translation>
    </message>
    <message>
        <source>%1 is in a folder. All files of a lesson are side by side.</source>
        <translation>%1 está en una carpeta. Todos los archivos de una lección van juntos, uno al lado de otro.</translation>
    </message>
    <message>
        <source>%1 is there twice. Make a new zip of the folder.</source>
        <translation>%1 aparece dos veces. Haz un zip nuevo de la carpeta.</translation>
    </message>
    <message>
        <source>the zip has several parts, or is too large for a lesson.</source>
        <translation>el zip tiene varias partes, o es demasiado grande para una lección.</translation>
    </message>
    <message>
        <source>the zip has more than %1 files.</source>
        <translation>el zip tiene más de %1 archivos.</translation>
    </message>
    <message>
        <source>the files are larger than %1 MiB together.</source>
        <translation>los archivos ocupan juntos más de %1 MiB.</translation>
    </message>
    <message>
        <source>the name of a file is not UTF-8. Give it a name without accents.</source>
        <translation>el nombre de un archivo no está en UTF-8. Dale un nombre sin tildes.</translation>
    </message>
    <message>
        <source>%1 leads out of the lesson. This zip is not safe; nothing was read.</source>
        <translation>%1 lleva fuera de la lección. Este zip no es seguro; no se ha leído nada.</translation>
    </message>
    <message>
        <source>%1 is a link. Put the file itself into the zip.</source>
        <translation>%1 es un enlace. Pon en el zip el propio archivo.</translation>
    </message>
    <message>
        <source>%1 has a password. Make a zip without one.</source>
        <translation>%1 tiene contraseña. Haz un zip sin ella.</translation>
    </message>
    <message>
        <source>%1 is compressed by a method that this program cannot read. Save it as an ordinary zip file.</source>
        <translation>%1 está comprimido de una forma que este programa no puede leer. Haz un zip normal.</translation>
    </message>
    <message>
        <source>%1 is larger than %2 MiB.</source>
        <translation>%1 ocupa más de %2 MiB.</translation>
    </message>
    <message>
        <source>the zip is empty.</source>
        <translation>el zip está vacío.</translation>
    </message>
    <message>
        <source>%1 is larger than the zip says. This zip is not safe; nothing was read.</source>
        <translation>%1 es más grande de lo que dice el zip. Este zip no es seguro; no se ha leído nada.</translation>
    </message>
    <message>
        <source>%1 is packed as ZIP64, which is for very large files. Save it as an ordinary zip file.</source>
        <translation>%1 está comprimido como ZIP64, que es para archivos muy grandes. Haz un zip normal.</translation>
    </message>
</context>
<context>
    <name>app::AboutPage</name>
    <message>
        <source>windows and files</source>
        <translation>ventanas y archivos</translation>
    </message>
    <message>
        <source>plots</source>
        <translation>gráficas</translation>
    </message>
    <message>
        <source>the code panel</source>
        <translation>el panel de código</translation>
    </message>
    <message>
        <source>arrays of numbers</source>
        <translation>matrices de números</translation>
    </message>
    <message>
        <source>reading experiments</source>
        <translation>lectura de experimentos</translation>
    </message>
    <message>
        <source>films as GIF</source>
        <translation>vídeos en GIF</translation>
    </message>
    <message>
        <source>running your code</source>
        <translation>ejecución de tu código</translation>
    </message>
    <message>
        <source>films as video</source>
        <translation>vídeos</translation>
    </message>
    <message>
        <source>experiments as short text</source>
        <translation>experimentos como texto corto</translation>
    </message>
    <message>
        <source>typeface of the window</source>
        <translation>letra de la ventana</translation>
    </message>
    <message>
        <source>typeface of code and numbers</source>
        <translation>letra del código y los números</translation>
    </message>
    <message>
        <source>About Springstep</source>
        <translation>Acerca de Springstep</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>Versión %1</translation>
    </message>
    <message>
        <source>Teaches physically based animation step by step, from one spring to creatures that walk.</source>
        <translation>Enseña animación basada en la física paso a paso, desde un solo muelle hasta criaturas que caminan.</translation>
    </message>
    <message>
        <source>You may use, change and share it under the &lt;a href=&quot;%1&quot;&gt;GNU General Public License, version 3&lt;/a&gt;. It comes without any warranty.</source>
        <translation>Puedes usarlo, cambiarlo y compartirlo según la &lt;a href=&quot;%1&quot;&gt;Licencia Pública General de GNU, versión 3&lt;/a&gt;. Se ofrece sin ninguna garantía.</translation>
    </message>
    <message>
        <source>Built with</source>
        <translation>Hecho con</translation>
    </message>
    <message>
        <source>%1: %2. Licence: %3</source>
        <translation>%1: %2. Licencia: %3</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>Cerrar esta página (Esc)</translation>
    </message>
</context>
<context>
    <name>app::AccuracyPanel</name>
    <message>
        <source>Accuracy</source>
        <translation>Precisión</translation>
    </message>
    <message>
        <source>Error against time</source>
        <translation>Error y tiempo</translation>
    </message>
    <message>
        <source>The error of each method, and its cost</source>
        <translation>El error de cada método y su coste</translation>
    </message>
    <message>
        <source>Over the run</source>
        <translation>Evolución</translation>
    </message>
    <message>
        <source>How the error grows, at about the cost of your method</source>
        <translation>Cómo crece el error, con un coste parecido al de tu método</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Orden</translation>
    </message>
    <message>
        <source>How fast the error shrinks when the step does</source>
        <translation>Con qué rapidez disminuye el error al acortar el paso de tiempo</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Progreso de la medición</translation>
    </message>
    <message>
        <source>Use it</source>
        <translation>Usar</translation>
    </message>
    <message>
        <source>first %1 frames of %2</source>
        <translation>primeros %1 fotogramas de %2</translation>
    </message>
    <message>
        <source>%1 frames, %2 methods</source>
        <translation>%1 fotogramas, %2 métodos</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Repetir</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Medir</translation>
    </message>
    <message>
        <source>Cancel; the results so far stay</source>
        <translation>Cancelar; los resultados hasta ahora se quedan</translation>
    </message>
    <message>
        <source>Compute the scene with every method, and time it</source>
        <translation>Calcular la escena con cada método y medir el tiempo</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Midiendo…</translation>
    </message>
    <message>
        <source>Times are medians of repeated, interleaved runs; whiskers show their spread.</source>
        <translation>Los tiempos son medianas de ejecuciones repetidas y entrelazadas; los bigotes muestran su dispersión.</translation>
    </message>
    <message>
        <source>Cancelled. The results so far are shown.</source>
        <translation>Cancelado. Se muestran los resultados obtenidos.</translation>
    </message>
    <message>
        <source>The scene has changed. Measuring starts when you stop changing it.</source>
        <translation>La escena ha cambiado. La medición empieza cuando dejes de cambiarla.</translation>
    </message>
    <message>
        <source>Not measured yet.</source>
        <translation>Aún sin medir.</translation>
    </message>
    <message>
        <source>How accurate is each method for this scene, and what does it cost? Every method computes it with many steps, and is compared with a far more accurate reference.</source>
        <translation>¿Qué precisión tiene cada método en esta escena, y cuánto cuesta? Cada método la calcula con muchos pasos de tiempo y se compara con una referencia mucho más precisa.</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Usar %1</translation>
    </message>
    <message>
        <source>%1 frames, %2 of %3 methods</source>
        <translation>%1 fotogramas, %2 de %3 métodos</translation>
    </message>
    <message>
        <source>Show fewer methods</source>
        <translation>Menos métodos</translation>
    </message>
    <message>
        <source>Show all methods</source>
        <translation>Todos los métodos</translation>
    </message>
    <message>
        <source>Only the method of this step, and the two most useful to compare it with</source>
        <translation>Solo el método de este paso y los dos con los que más vale la pena compararlo</translation>
    </message>
    <message>
        <source>All measured methods, with two more plots and with remarks</source>
        <translation>Todos los métodos medidos, con dos gráficas más y observaciones</translation>
    </message>
</context>
<context>
    <name>app::AccuracyStudy</name>
    <message>
        <source>Your code is left out: it computes whole frames, so it cannot be compared with shorter steps.</source>
        <translation>Tu código no aparece: calcula fotogramas enteros, así que no se puede comparar con pasos de tiempo más cortos.</translation>
    </message>
</context>
<context>
    <name>app::Appearance</name>
    <message>
        <source>This step shows no angle.</source>
        <translation>Este paso no muestra ningún ángulo.</translation>
    </message>
</context>
<context>
    <name>app::ArrangeMenu</name>
    <message>
        <source>A&amp;rrange panels</source>
        <translation>Organi&amp;zar paneles</translation>
    </message>
    <message>
        <source>to the &amp;left</source>
        <translation>a la &amp;izquierda</translation>
    </message>
    <message>
        <source>to the &amp;right</source>
        <translation>a la &amp;derecha</translation>
    </message>
    <message>
        <source>&amp;below the picture</source>
        <translation>de&amp;bajo de la imagen</translation>
    </message>
    <message>
        <source>Drag this panel to its new place</source>
        <translation>Arrastra este panel a su nuevo lugar</translation>
    </message>
</context>
<context>
    <name>app::Attempts</name>
    <message>
        <source>stop here: press **Space**.</source>
        <translation>párate aquí: pulsa **Espacio**.</translation>
    </message>
    <message>
        <source>the error is too large, or a frame takes too long. Try another method or step.</source>
        <translation>el error es demasiado grande, o un fotograma tarda demasiado. Prueba otro método u otro paso de tiempo.</translation>
    </message>
    <message>
        <source>this run was set up for you. Undo brings your own run back: do it there.</source>
        <translation>esta ejecución la ha preparado Springstep. Deshacer recupera tu propia ejecución: hazlo en ella.</translation>
    </message>
    <message>
        <source>your code computes this run, and it has no phases. Press **Reset listing** on the page **Listing**. Undo brings your code back.</source>
        <translation>esta ejecución la calcula tu código, y no tiene fases. En la página **Listado**, pulsa **Restablecer el listado**. Deshacer recupera tu código.</translation>
    </message>
    <message>
        <source>your code computes this run, in steps of 1 frame. Press **Reset listing** on the page **Listing**, then choose the step. Undo brings your code back.</source>
        <translation>esta ejecución la calcula tu código, con pasos de 1 fotograma. En la página **Listado**, pulsa **Restablecer el listado** y elige después el paso. Deshacer recupera tu código.</translation>
    </message>
</context>
<context>
    <name>app::Autosave</name>
    <message>
        <source>the folder %1 could not be created</source>
        <translation>no se pudo crear la carpeta %1</translation>
    </message>
    <message>
        <source>a file in %1 could not be locked</source>
        <translation>no se pudo bloquear un archivo de %1</translation>
    </message>
    <message>
        <source>Could not save a backup of your work: %1. Free some disk space, or save it as a file.</source>
        <translation>No se pudo guardar una copia de tu trabajo: %1. Libera espacio en el disco, o guárdalo como archivo.</translation>
    </message>
</context>
<context>
    <name>app::BranchesPanel</name>
    <message>
        <source>Two runs</source>
        <translation>Dos ejecuciones</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Distancia máxima</translation>
    </message>
    <message>
        <source>In each frame, the body that is farthest from its place in the other run</source>
        <translation>En cada fotograma, el cuerpo más alejado de su lugar en la otra ejecución</translation>
    </message>
    <message>
        <source>Only the body that is selected in the picture</source>
        <translation>Solo el cuerpo seleccionado en la imagen</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Ejecuciones</translation>
    </message>
    <message>
        <source>Choose the run to compare with, keep, name and delete runs</source>
        <translation>Elegir la ejecución con la que comparar; conservar, renombrar y eliminar ejecuciones</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Ir allí</translation>
    </message>
    <message>
        <source>Go to the frame with the largest difference</source>
        <translation>Ir al fotograma con la mayor diferencia</translation>
    </message>
    <message>
        <source>this one and “%1”</source>
        <translation>esta y «%1»</translation>
    </message>
</context>
<context>
    <name>app::BreakpointList</name>
    <message>
        <source>when</source>
        <translation>cuando</translation>
    </message>
    <message>
        <source>Stop when</source>
        <translation>Parar cuando</translation>
    </message>
    <message>
        <source>Stops the run as soon as this is true, even inside a frame.
You can use x, y, vx, vy of bodies, frame, phase, and all parameters;
+ - * / ( ), &lt; &lt;= &gt; &gt;= == !=, and, or, not, abs(), sqrt(), distance(a, b), speed(a), still(a), held(a), released(a).
Press Enter to add it.</source>
        <translation>Detiene la ejecución en cuanto esto se cumple, incluso dentro de un fotograma.
Puedes usar x, y, vx, vy de los cuerpos, frame, phase y todos los parámetros;
+ - * / ( ), &lt; &lt;= &gt; &gt;= == !=, and, or, not, abs(), sqrt(), distance(a, b), speed(a), still(a), held(a), released(a).
Pulsa Intro para añadirlo.</translation>
    </message>
    <message>
        <source>always, or when…</source>
        <translation>siempre, o cuando…</translation>
    </message>
    <message>
        <source>Condition of breakpoint %1</source>
        <translation>Condición del punto de interrupción %1</translation>
    </message>
    <message>
        <source>Stops before this line&apos;s phase if this is true. Press Enter to apply.</source>
        <translation>Se para antes de la fase de esta línea si esto se cumple. Pulsa Intro para aplicar.</translation>
    </message>
    <message>
        <source>Stops when this becomes true. Press Enter to apply.</source>
        <translation>Se para cuando esto se cumple. Pulsa Intro para aplicar.</translation>
    </message>
    <message>
        <source>Stop before this line (%1)</source>
        <translation>Parar antes de esta línea (%1)</translation>
    </message>
    <message>
        <source>Stop when this becomes true</source>
        <translation>Parar cuando esto se cumpla</translation>
    </message>
    <message>
        <source>Breakpoint %1 %2</source>
        <translation>Punto de interrupción %1 %2</translation>
    </message>
    <message>
        <source>Remove this breakpoint</source>
        <translation>Quitar este punto de interrupción</translation>
    </message>
    <message>
        <source>Remove the breakpoint %1 %2</source>
        <translation>Quitar el punto de interrupción %1 %2</translation>
    </message>
    <message>
        <source>Stop when… (%1.y &gt; 300)</source>
        <translation>Parar cuando… (%1.y &gt; 300)</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>línea %1</translation>
    </message>
    <message>
        <source>Stop before this line of the listing</source>
        <translation>Parar antes de esta línea del listado</translation>
    </message>
    <message>
        <source>Stops before this line if this is true. Press Enter to apply.</source>
        <translation>Se para antes de esta línea si esto se cumple. Pulsa Intro para aplicar.</translation>
    </message>
</context>
<context>
    <name>app::BuildGuide</name>
    <message>
        <source>The point in the picture is the body of your creature. Press Foot (F) to give it feet.</source>
        <translation>El punto de la imagen es el cuerpo de tu criatura. Pulsa Pie (F) para darle pies.</translation>
    </message>
    <message>
        <source>Click the body.</source>
        <translation>Haz clic en el cuerpo.</translation>
    </message>
    <message>
        <source>Click the cross on the left: the first foot.</source>
        <translation>Haz clic en la cruz de la izquierda: el primer pie.</translation>
    </message>
    <message>
        <source>Click the cross on the right. Opposite feet need opposite angles: one 0°, the other 180°.</source>
        <translation>Haz clic en la cruz de la derecha. Los pies opuestos necesitan ángulos opuestos: uno 0°, el otro 180°.</translation>
    </message>
    <message>
        <source>Two feet must be opposite each other. Click the cross on the right.</source>
        <translation>Los dos pies deben estar uno frente al otro. Haz clic en la cruz de la derecha.</translation>
    </message>
    <message>
        <source>Now set the numbers of the feet. Press Select (V).</source>
        <translation>Ahora, los números de los pies. Pulsa Selección (V).</translation>
    </message>
    <message>
        <source>Click one of the feet.</source>
        <translation>Haz clic en uno de los pies.</translation>
    </message>
    <message>
        <source>Swing makes it walk: it turns the legs. Type 0.05 into the field Swing, and press Return.</source>
        <translation>El balanceo hace que camine: gira las piernas. Escribe 0,05 en el campo Balanceo y pulsa Intro.</translation>
    </message>
    <message>
        <source>Feet need something to push against. Switch Ground on.</source>
        <translation>Los pies necesitan algo contra lo que empujar. Activa Suelo.</translation>
    </message>
    <message>
        <source>Switch Walls off, so that nothing is in the way.</source>
        <translation>Desactiva Paredes, para que nada estorbe.</translation>
    </message>
    <message>
        <source>Press Play (Space).</source>
        <translation>Pulsa Reproducir (Espacio).</translation>
    </message>
    <message>
        <source>Watch it: it lands, and then its feet push it along.</source>
        <translation>Obsérvala: cae al suelo, y luego sus pies la empujan hacia delante.</translation>
    </message>
    <message>
        <source>It does not walk yet. Press Home, and make Swing 0.05.</source>
        <translation>Aún no camina. Pulsa Inicio y pon Balanceo en 0,05.</translation>
    </message>
    <message>
        <source>It walks! Press Home to change it: another Swing, a third foot, or a heavier body.</source>
        <translation>¡Camina! Pulsa Inicio para cambiarla: otro balanceo, un tercer pie o un cuerpo más pesado.</translation>
    </message>
</context>
<context>
    <name>app::BuildPanel</name>
    <message>
        <source>Build</source>
        <translation>Construir</translation>
    </message>
    <message>
        <source>Go to the start</source>
        <translation>Ir al inicio</translation>
    </message>
    <message>
        <source>Go to frame 0, where the scene can be changed</source>
        <translation>Ir al fotograma 0, donde se puede cambiar la escena</translation>
    </message>
    <message>
        <source>Effects on everything</source>
        <translation>Efectos sobre todo</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Ejemplos</translation>
    </message>
    <message>
        <source>Scenes to start from. Undo brings yours back</source>
        <translation>Escenas para empezar. Deshacer recupera la tuya</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nuevo</translation>
    </message>
    <message>
        <source>A scene with one point. Undo brings yours back</source>
        <translation>Una escena con un punto. Deshacer recupera la tuya</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lecciones</translation>
    </message>
    <message>
        <source>Back to the lessons; your scene stays here</source>
        <translation>Volver a las lecciones; tu escena se queda aquí</translation>
    </message>
    <message>
        <source>points %1, links %2</source>
        <translation>puntos %1, uniones %2</translation>
    </message>
    <message>
        <source>The scene is playing. You can only build at the start of the run.</source>
        <translation>La escena se está reproduciendo. Solo puedes construir al inicio de la ejecución.</translation>
    </message>
    <message>
        <source>You are at frame %1. You can only build at the start of the run.</source>
        <translation>Estás en el fotograma %1. Solo puedes construir al inicio de la ejecución.</translation>
    </message>
    <message>
        <source>Click where you want a point.</source>
        <translation>Haz clic donde quieras un punto.</translation>
    </message>
    <message>
        <source>Click a point to nail it down or to free it, or click where you want a nail.</source>
        <translation>Haz clic en un punto para clavarlo o soltarlo, o donde quieras un clavo.</translation>
    </message>
    <message>
        <source>Click a part to select it, drag it to move it, or draw a box around several.</source>
        <translation>Haz clic en una pieza para seleccionarla, arrástrala para moverla, o dibuja un recuadro alrededor de varias.</translation>
    </message>
    <message>
        <source>New gait group</source>
        <translation>Nuevo grupo de marcha</translation>
    </message>
    <message>
        <source>Gives this foot its own gait group, with its own clock</source>
        <translation>Da a este pie su propio grupo de marcha, con su propio reloj</translation>
    </message>
    <message>
        <source>Click where it ends; the next one starts there. Esc: start somewhere else.</source>
        <translation>Haz clic donde termina; el siguiente empieza allí. Esc: empezar en otro lugar.</translation>
    </message>
    <message>
        <source>Click each of its feet, or where you want one. Esc: another body.</source>
        <translation>Haz clic en cada uno de sus pies, o donde quieras uno. Esc: otro cuerpo.</translation>
    </message>
    <message>
        <source>Click a body, then each of its feet, or where you want one.</source>
        <translation>Haz clic en un cuerpo y luego en cada uno de sus pies, o donde quieras uno.</translation>
    </message>
    <message>
        <source>First build: a walker</source>
        <translation>Guía: un caminante</translation>
    </message>
    <message>
        <source>Build a creature that walks, in ten clicks. It starts with a new scene. Undo brings yours back</source>
        <translation>Construye con diez clics una criatura que camina. Empieza con una escena nueva. Deshacer recupera la tuya</translation>
    </message>
    <message>
        <source>Drag from point to point to make one spring. With clicks, each spring starts where the last one ends.</source>
        <translation>Arrastra de punto a punto para hacer un muelle. Con clics, cada muelle empieza donde termina el anterior.</translation>
    </message>
    <message>
        <source>Drag from point to point to make one stick. With clicks, each stick starts where the last one ends.</source>
        <translation>Arrastra de punto a punto para hacer una barra. Con clics, cada barra empieza donde termina la anterior.</translation>
    </message>
    <message>
        <source>On the ground, Swing makes it walk. Opposite feet need opposite angles: 0° and 180°.</source>
        <translation>Sobre el suelo, el balanceo hace que camine. Los pies opuestos necesitan ángulos opuestos: 0° y 180°.</translation>
    </message>
    <message>
        <source>Drag from point to point to make one rule link, along which pull of your rule acts. With clicks, each link starts where the last one ends.</source>
        <translation>Arrastra de punto a punto para hacer una unión de la regla, a lo largo de la cual actúa pull de tu regla. Con clics, cada una empieza donde termina la anterior.</translation>
    </message>
    <message>
        <source>A rule link has no settings: pull of your rule acts on both of its ends.</source>
        <translation>Una unión de la regla no tiene ajustes: pull de tu regla actúa en sus dos extremos.</translation>
    </message>
</context>
<context>
    <name>app::ChoiceRow</name>
    <message>
        <source>Choose this answer (Space)</source>
        <translation>Elegir esta respuesta (Espacio)</translation>
    </message>
    <message>
        <source>%1, right</source>
        <translation>%1, correcta</translation>
    </message>
    <message>
        <source>%1, wrong</source>
        <translation>%1, incorrecta</translation>
    </message>
</context>
<context>
    <name>app::CodeCard</name>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1: %2. %3</translation>
    </message>
    <message>
        <source>Drag it sideways, or double-click it to type.</source>
        <translation>Arrástralo hacia un lado, o haz doble clic en él para escribir.</translation>
    </message>
    <message>
        <source>x solid, y dashed</source>
        <translation>x continua, y discontinua</translation>
    </message>
</context>
<context>
    <name>app::CodePages</name>
    <message>
        <source>Let the listing compute the run from here</source>
        <translation>Dejar que el listado calcule la ejecución desde aquí</translation>
    </message>
    <message>
        <source>Listing</source>
        <translation>Listado</translation>
    </message>
    <message>
        <source>The program of a frame, to read, to step through and to change</source>
        <translation>El programa de un fotograma: para leerlo, recorrerlo y cambiarlo</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Motor de cálculo</translation>
    </message>
    <message>
        <source>The code of Springstep that computes the run</source>
        <translation>El código de Springstep que calcula la ejecución</translation>
    </message>
    <message>
        <source>%1 computes this run, not the listing.</source>
        <translation>Esta ejecución la calcula %1, no el listado.</translation>
    </message>
    <message>
        <source>Use your code</source>
        <translation>Usar tu código</translation>
    </message>
    <message>
        <source>Use the listing</source>
        <translation>Usar el listado</translation>
    </message>
    <message>
        <source>My rule</source>
        <translation>Mi regla</translation>
    </message>
    <message>
        <source>A force that you write, for this scene</source>
        <translation>Una fuerza para esta escena que escribes tú</translation>
    </message>
</context>
<context>
    <name>app::CodePanel</name>
    <message>
        <source>Lines that are new in this step. Click to go through them.</source>
        <translation>Líneas nuevas en este paso. Haz clic para recorrerlas.</translation>
    </message>
    <message>
        <source>Copy the shown code, with its files&apos; names</source>
        <translation>Copiar el código mostrado, con los nombres de sus archivos</translation>
    </message>
    <message>
        <source>Copy the code</source>
        <translation>Copiar el código</translation>
    </message>
    <message>
        <source>Copied the code.</source>
        <translation>Código copiado.</translation>
    </message>
    <message>
        <source>values of %1</source>
        <translation>valores: %1</translation>
    </message>
    <message>
        <source>values of the %1</source>
        <translation>valores: %1</translation>
    </message>
    <message>
        <source>1 line new</source>
        <translation>1 nueva</translation>
    </message>
    <message>
        <source>%1 lines new</source>
        <translation>%1 nuevas</translation>
    </message>
    <message>
        <source>%1 Press Enter to apply, Esc to cancel.</source>
        <translation>%1 Intro aplica, Esc cancela.</translation>
    </message>
    <message>
        <source>“%1” has no known value.</source>
        <translation>«%1» no tiene ningún valor conocido.</translation>
    </message>
    <message>
        <source>Of %1, in “%2”.</source>
        <translation>De %1, en «%2».</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>aún ninguno</translation>
    </message>
    <message>
        <source>This line sets the scene up, before the first frame. Choose a line of a phase to stop at.</source>
        <translation>Esta línea prepara la escena, antes del primer fotograma. Elige una línea de una fase para parar en ella.</translation>
    </message>
    <message>
        <source>This line says in which order phases run. Choose a line of a phase to stop at.</source>
        <translation>Esta línea dice en qué orden se ejecutan las fases. Elige una línea de una fase para parar en ella.</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, línea %2</translation>
    </message>
    <message>
        <source>Stops before %1.</source>
        <translation>Se para antes de %1.</translation>
    </message>
    <message>
        <source>No longer stops before %1.</source>
        <translation>Ya no se para antes de %1.</translation>
    </message>
    <message>
        <source>This line sets the scene up, before the first frame. Click a line of a phase to run to it.</source>
        <translation>Esta línea prepara la escena, antes del primer fotograma. Haz clic en una línea de una fase para ejecutar hasta ella.</translation>
    </message>
    <message>
        <source>This line says in which order phases run. Click a line of a phase to run to it.</source>
        <translation>Esta línea dice en qué orden se ejecutan las fases. Haz clic en una línea de una fase para ejecutar hasta ella.</translation>
    </message>
    <message>
        <source>Run to here</source>
        <translation>Ejecutar hasta aquí</translation>
    </message>
    <message>
        <source>Remove breakpoint</source>
        <translation>Quitar punto de interrupción</translation>
    </message>
    <message>
        <source>Set breakpoint</source>
        <translation>Poner punto de interrupción</translation>
    </message>
    <message>
        <source>Set breakpoint when…</source>
        <translation>Punto de interrupción cuando…</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Copy “%1”</source>
        <translation>Copiar «%1»</translation>
    </message>
    <message>
        <source>Copy all shown code</source>
        <translation>Copiar todo el código mostrado</translation>
    </message>
    <message>
        <source>Lines that this step removed. Click to show or hide them, struck through at their old places (%1 in the code).</source>
        <translation>Líneas que este paso ha quitado. Haz clic para mostrarlas u ocultarlas, tachadas en sus lugares de antes (%1 en el código).</translation>
    </message>
    <message>
        <source>1 line removed</source>
        <translation>1 línea quitada</translation>
    </message>
    <message>
        <source>%1 lines removed</source>
        <translation>%1 líneas quitadas</translation>
    </message>
    <message>
        <source>This step removed no lines.</source>
        <translation>Este paso no ha quitado ninguna línea.</translation>
    </message>
</context>
<context>
    <name>app::CodeView</name>
    <message>
        <source>Code that runs</source>
        <translation>Código que se ejecuta</translation>
    </message>
    <message>
        <source>%1
Click to fold or unfold (Enter)</source>
        <translation>%1
Haz clic para plegar o desplegar (Intro)</translation>
    </message>
    <message>
        <source>Up and Down go from line to line. Enter runs to a line, or folds a section at its heading. %1 sets a breakpoint, %2 changes a parameter, %3 shows a value, %4 copies.</source>
        <translation>Flecha arriba y Flecha abajo van de línea en línea. Intro ejecuta hasta una línea, o pliega una sección en su título. %1 pone un punto de interrupción, %2 cambia un parámetro, %3 muestra un valor, %4 copia.</translation>
    </message>
    <message>
        <source>The run stops before this line&apos;s phase. Click to remove the breakpoint</source>
        <translation>La ejecución se para antes de la fase de esta línea. Haz clic para quitar el punto de interrupción</translation>
    </message>
    <message>
        <source>Click to set a breakpoint before this line&apos;s phase</source>
        <translation>Haz clic para poner un punto de interrupción antes de la fase de esta línea</translation>
    </message>
    <message>
        <source>New in this step. %1</source>
        <translation>Nueva en este paso. %1</translation>
    </message>
    <message>
        <source>The previous step has this line; this step removed it.</source>
        <translation>El paso anterior tiene esta línea; este paso la ha quitado.</translation>
    </message>
    <message>
        <source>These lines add up the values computed above. They are the same for every force.
Click to fold or unfold (Enter)</source>
        <translation>Estas líneas suman los valores calculados arriba. Son las mismas para todas las fuerzas.
Haz clic para plegar o desplegar (Intro)</translation>
    </message>
</context>
<context>
    <name>app::ComparisonRuns</name>
    <message>
        <source>before: %1</source>
        <translation>antes: %1</translation>
    </message>
    <message>
        <source>after: %1</source>
        <translation>después: %1</translation>
    </message>
    <message>
        <source>Computing “%1” again: frame %2 of %3. Press Esc to stop.</source>
        <translation>Calculando de nuevo «%1»: fotograma %2 de %3. Pulsa Esc para parar.</translation>
    </message>
    <message>
        <source>Stopped: “%1” is not shown. You can show it again in “Runs”.</source>
        <translation>Parado: «%1» no se muestra. Puedes volver a mostrarla en «Ejecuciones».</translation>
    </message>
    <message>
        <source>Keep run</source>
        <translation>Conservar ejecución</translation>
    </message>
    <message>
        <source>Stop keeping run</source>
        <translation>Dejar de conservar ejecución</translation>
    </message>
    <message>
        <source>Rename run</source>
        <translation>Renombrar ejecución</translation>
    </message>
    <message>
        <source>Delete run</source>
        <translation>Eliminar ejecución</translation>
    </message>
</context>
<context>
    <name>app::ConceptButton</name>
    <message>
        <source>known</source>
        <translation>conocido</translation>
    </message>
    <message>
        <source>can come next</source>
        <translation>puede venir ahora</translation>
    </message>
    <message>
        <source>for later</source>
        <translation>para más adelante</translation>
    </message>
    <message>
        <source>Opens %1</source>
        <translation>Abre %1</translation>
    </message>
</context>
<context>
    <name>app::ConceptView</name>
    <message>
        <source>Map of concepts</source>
        <translation>Mapa de conceptos</translation>
    </message>
</context>
<context>
    <name>app::CursorPlot</name>
    <message>
        <source>%1. Under the mouse: %2</source>
        <translation>%1. Bajo el ratón: %2</translation>
    </message>
</context>
<context>
    <name>app::CurveButton</name>
    <message>
        <source>Choose this curve (%1)</source>
        <translation>Elegir esta gráfica (%1)</translation>
    </message>
    <message>
        <source>Curve %1: %2</source>
        <translation>Gráfica %1: %2</translation>
    </message>
    <message>
        <source>%1, right</source>
        <translation>%1, correcta</translation>
    </message>
</context>
<context>
    <name>app::DifferencePlot</name>
    <message>
        <source>Distance between the two runs over time</source>
        <translation>Distancia entre las dos ejecuciones frente al tiempo</translation>
    </message>
    <message>
        <source>px apart</source>
        <translation>px de distancia</translation>
    </message>
    <message>
        <source>frame %1: %2&#x2009;px apart</source>
        <translation>fotograma %1: a %2 px</translation>
    </message>
    <message>
        <source>%1: %2&#x2009;px at frame %3</source>
        <translation>%1: %2 px en el fotograma %3</translation>
    </message>
    <message>
        <source>%1, px</source>
        <translation>%1, px</translation>
    </message>
</context>
<context>
    <name>app::EditCommands</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Deshacer</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rehacer</translation>
    </message>
    <message>
        <source>&amp;Copy the experiment as text</source>
        <translation>&amp;Copiar el experimento como texto</translation>
    </message>
    <message>
        <source>&amp;Paste an experiment</source>
        <translation>&amp;Pegar un experimento</translation>
    </message>
    <message>
        <source>Copy the p&amp;icture of the scene</source>
        <translation>Copiar la &amp;imagen de la escena</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Deshacer: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rehacer: %1</translation>
    </message>
    <message>
        <source>There is nothing to undo in this step</source>
        <translation>No hay nada que deshacer en este paso</translation>
    </message>
    <message>
        <source>There is nothing to redo</source>
        <translation>No hay nada que rehacer</translation>
    </message>
</context>
<context>
    <name>app::EffectHeads</name>
    <message>
        <source>Effect</source>
        <translation>Efecto</translation>
    </message>
    <message>
        <source>The effects of this scene, in the order in which they run.</source>
        <translation>Los efectos de esta escena, en el orden en que se ejecutan.</translation>
    </message>
    <message>
        <source>µs a frame</source>
        <translation>µs/fot.</translation>
    </message>
    <message>
        <source>Microseconds (millionths of a second) that each frame of the run spends on it. About half of the measurements are within the ±.</source>
        <translation>Microsegundos (millonésimas de segundo) que cada fotograma de la ejecución dedica a esto. Cerca de la mitad de las mediciones están dentro del ±.</translation>
    </message>
    <message>
        <source>µs a point</source>
        <translation>µs/punto</translation>
    </message>
    <message>
        <source>The same for each point that it acts on.</source>
        <translation>Lo mismo por cada punto en el que actúa.</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>veces</translation>
    </message>
    <message>
        <source>How often a frame computes it. Some methods compute it several times.</source>
        <translation>Cuántas veces lo calcula un fotograma. Algunos métodos lo calculan varias veces.</translation>
    </message>
    <message>
        <source>points</source>
        <translation>puntos</translation>
    </message>
    <message>
        <source>How many points it acts on.</source>
        <translation>En cuántos puntos actúa.</translation>
    </message>
</context>
<context>
    <name>app::EffectLedger</name>
    <message>
        <source>measuring…</source>
        <translation>midiendo…</translation>
    </message>
    <message>
        <source>%1, measuring…</source>
        <translation>%1, midiendo…</translation>
    </message>
    <message>
        <source>%1, measured now</source>
        <translation>%1, medido ahora</translation>
    </message>
    <message>
        <source>%1, measured at frame %2</source>
        <translation>%1, medido en el fotograma %2</translation>
    </message>
</context>
<context>
    <name>app::EffectList</name>
    <message>
        <source>The effects of the scene and their costs</source>
        <translation>Los efectos de la escena y sus costes</translation>
    </message>
</context>
<context>
    <name>app::EffectsPanel</name>
    <message>
        <source>Effects</source>
        <translation>Efectos</translation>
    </message>
    <message>
        <source>&amp;Measure the effects again</source>
        <translation>&amp;Medir de nuevo los efectos</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Repetir</translation>
    </message>
    <message>
        <source>Measure what a frame costs where the run is now</source>
        <translation>Medir lo que cuesta un fotograma en el punto actual de la ejecución</translation>
    </message>
</context>
<context>
    <name>app::EnergyList</name>
    <message>
        <source>Where energy and momentum went</source>
        <translation>Adónde fueron la energía y el momento lineal</translation>
    </message>
</context>
<context>
    <name>app::EnergyListModel</name>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1: %2 %3</translation>
    </message>
    <message>
        <source>%1: %2&#x2009;%3
%4</source>
        <translation>%1: %2&#x2009;%3
%4</translation>
    </message>
</context>
<context>
    <name>app::EnergyPanel</name>
    <message>
        <source>Where it went</source>
        <translation>Adónde fue</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energía</translation>
    </message>
    <message>
        <source>Where energy is, and where it went</source>
        <translation>Dónde está la energía y adónde fue</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Momento lineal</translation>
    </message>
    <message>
        <source>Mass × velocity of everything together, and what changed it</source>
        <translation>Masa × velocidad de todo junto, y qué lo ha cambiado</translation>
    </message>
    <message>
        <source>Everything here turns in place, held by the ground. So there is no momentum to count: choose a scene with moving bodies.</source>
        <translation>Aquí todo gira sin moverse del sitio, sujeto por el suelo. Por eso no hay momento lineal que contar: elige una escena con cuerpos que se mueven.</translation>
    </message>
    <message>
        <source>frame %1 to %2</source>
        <translation>fotograma %1 a %2</translation>
    </message>
    <message>
        <source>counting…</source>
        <translation>contando…</translation>
    </message>
</context>
<context>
    <name>app::EnergyPlot</name>
    <message>
        <source>Energy over the last frames</source>
        <translation>Energía en los últimos fotogramas</translation>
    </message>
    <message>
        <source>Momentum over the last frames</source>
        <translation>Momento lineal en los últimos fotogramas</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>a la derecha</translation>
    </message>
    <message>
        <source>down</source>
        <translation>hacia abajo</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>energía</translation>
    </message>
    <message>
        <source>momentum</source>
        <translation>momento lineal</translation>
    </message>
    <message>
        <source>Click or drag to go to a frame; the arrow keys move by one frame</source>
        <translation>Haz clic o arrastra para ir a un fotograma; las flechas avanzan de uno en uno</translation>
    </message>
    <message>
        <source>%1 to the right, %2 down</source>
        <translation>%1 a la derecha, %2 hacia abajo</translation>
    </message>
    <message>
        <source>%1 there, drift %2</source>
        <translation>%1 allí, deriva %2</translation>
    </message>
    <message>
        <source>%1: frame %2 is not counted</source>
        <translation>%1: el fotograma %2 no está contado</translation>
    </message>
    <message>
        <source>%1: %2 (%3) at frame %4</source>
        <translation>%1: %2 (%3) en el fotograma %4</translation>
    </message>
</context>
<context>
    <name>app::ExampleGallery</name>
    <message>
        <source>Examples</source>
        <translation>Ejemplos</translation>
    </message>
    <message>
        <source>%1 Undo brings your scene back.</source>
        <translation>%1 Deshacer recupera tu escena.</translation>
    </message>
</context>
<context>
    <name>app::ExperimentFiles</name>
    <message>
        <source>Could not open the experiment: %1 Your scene is unchanged.</source>
        <translation>No se pudo abrir el experimento: %1 Tu escena no ha cambiado.</translation>
    </message>
    <message>
        <source>Could not save the experiment: %1</source>
        <translation>No se pudo guardar el experimento: %1</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Guardado como %1.</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>%1 tiene cambios sin guardar.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Guardar</translation>
    </message>
    <message>
        <source>Save the changes, then continue</source>
        <translation>Guardar los cambios y continuar</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Descartar los cambios</translation>
    </message>
    <message>
        <source>Continue without saving: your changes are lost</source>
        <translation>Continuar sin guardar: tus cambios se pierden</translation>
    </message>
    <message>
        <source>Open an experiment or a lesson</source>
        <translation>Abrir un experimento o una lección</translation>
    </message>
    <message>
        <source>Experiments and lessons (*.springstep *.json *%1)</source>
        <translation>Experimentos y lecciones (*.springstep *.json *%1)</translation>
    </message>
    <message>
        <source>Experiments (*.springstep *.json)</source>
        <translation>Experimentos (*.springstep *.json)</translation>
    </message>
    <message>
        <source>Save the experiment</source>
        <translation>Guardar el experimento</translation>
    </message>
    <message>
        <source>The step has its published state again.</source>
        <translation>El paso vuelve a estar como se publicó.</translation>
    </message>
    <message>
        <source>&amp;%1  %2</source>
        <translation>&amp;%1  %2</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>Sin archivos</translation>
    </message>
    <message>
        <source>Experiments that you open or save are listed here</source>
        <translation>Aquí aparecen los experimentos que abres o guardas</translation>
    </message>
    <message>
        <source>Could not copy the experiment: %1</source>
        <translation>No se pudo copiar el experimento: %1</translation>
    </message>
    <message numerus="yes">
        <source>Copied: %n character(s), in one line.</source>
        <translation>
            <numerusform>Copiado: %n carácter, en una línea.</numerusform>
            <numerusform>Copiado: %n caracteres, en una línea.</numerusform>
        </translation>
    </message>
    <message>
        <source>Springstep</source>
        <translation>Springstep</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Guardar</translation>
    </message>
    <message>
        <source>Close &amp;without saving</source>
        <translation>Cerrar &amp;sin guardar</translation>
    </message>
    <message>
        <source>“%1” has unsaved changes.</source>
        <translation>«%1» tiene cambios sin guardar.</translation>
    </message>
    <message>
        <source>Could not find %1, so it was removed from the list. If you moved it, open it from its new place.</source>
        <translation>No se encontró %1, así que se ha quitado de la lista. Si lo moviste, ábrelo desde su nuevo lugar.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>%1[*] – Springstep</source>
        <translation>%1[*] – Springstep</translation>
    </message>
</context>
<context>
    <name>app::ExportDialog</name>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Fotograma %1 de %2</translation>
    </message>
    <message>
        <source>%1 is saved, up to the frame where the run stops. %2</source>
        <translation>%1 se ha guardado, hasta el fotograma en que se para la ejecución. %2</translation>
    </message>
    <message>
        <source>%1 is saved.</source>
        <translation>%1 se ha guardado.</translation>
    </message>
    <message>
        <source>Cancelled. No file was written.</source>
        <translation>Cancelado. No se ha escrito ningún archivo.</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>&amp;Cancelar</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close this dialog (Esc)</source>
        <translation>Cerrar este diálogo (Esc)</translation>
    </message>
</context>
<context>
    <name>app::FailureNotice</name>
    <message>
        <source>Searching for a remedy…</source>
        <translation>Buscando un remedio…</translation>
    </message>
    <message>
        <source>Correct this line, and the run goes on.</source>
        <translation>Corrige esta línea y la ejecución sigue.</translation>
    </message>
    <message>
        <source>Correct this line, and the run goes on. Undo reverts your last change.</source>
        <translation>Corrige esta línea y la ejecución sigue. Deshacer retira tu último cambio.</translation>
    </message>
    <message>
        <source>No smaller step and no other method was found to be stable. Go back, and undo the change that caused this.</source>
        <translation>Ningún paso de tiempo más corto ni ningún otro método ha resultado estable. Retrocede y deshaz el cambio que causó esto.</translation>
    </message>
</context>
<context>
    <name>app::FilmDialog</name>
    <message>
        <source>Film of the run</source>
        <translation>Vídeo de la ejecución</translation>
    </message>
    <message>
        <source>Progress of the film</source>
        <translation>Progreso del vídeo</translation>
    </message>
    <message>
        <source>The first frame of the film</source>
        <translation>El primer fotograma del vídeo</translation>
    </message>
    <message>
        <source>The last frame of the film; the run is computed up to there</source>
        <translation>El último fotograma del vídeo; la ejecución se calcula hasta ahí</translation>
    </message>
    <message>
        <source>Frames a second</source>
        <translation>Fotogramas por segundo</translation>
    </message>
    <message>
        <source>The speed of the film: 30 is as fast as in the window</source>
        <translation>La velocidad del vídeo: 30 es tan rápido como en la ventana</translation>
    </message>
    <message>
        <source>Frames a &amp;second</source>
        <translation>Fotogramas por &amp;segundo</translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>&amp;Make the film</source>
        <translation>Crear el &amp;vídeo</translation>
    </message>
    <message>
        <source>Make the film; you can use the window meanwhile</source>
        <translation>Crear el vídeo; mientras tanto puedes usar la ventana</translation>
    </message>
    <message>
        <source>Choosing its colours…</source>
        <translation>Eligiendo sus colores…</translation>
    </message>
    <message>
        <source>Cancelled. The pictures up to frame %1 are saved.</source>
        <translation>Cancelado. Se han guardado las imágenes hasta el fotograma %1.</translation>
    </message>
    <message>
        <source>Cancel the film (Esc)</source>
        <translation>Cancelar el vídeo (Esc)</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>A&amp;nchura</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Reemplazar</translation>
    </message>
    <message>
        <source>Make the film, and overwrite the existing file</source>
        <translation>Crear el vídeo y sobrescribir el archivo existente</translation>
    </message>
    <message>
        <source>A name that ends in .webm or .gif makes one file. A name such as walk_%04d.png makes a picture of each frame, with its number instead of %04d.</source>
        <translation>Un nombre que termina en .webm o .gif hace un solo archivo. Un nombre como walk_%04d.png hace una imagen de cada fotograma, con su número en vez de %04d.</translation>
    </message>
</context>
<context>
    <name>app::FilmName</name>
    <message>
        <source>Where to save the film</source>
        <translation>Dónde guardar el vídeo</translation>
    </message>
    <message>
        <source>%1 already exists. Replace it, or choose another name.</source>
        <translation>%1 ya existe. Reemplázalo o elige otro nombre.</translation>
    </message>
    <message>
        <source>Such pictures already exist, for example %1. Replace them, or choose another name.</source>
        <translation>Ya existen imágenes así, por ejemplo %1. Reemplázalas o elige otro nombre.</translation>
    </message>
    <message>
        <source>Film of the run</source>
        <translation>Vídeo de la ejecución</translation>
    </message>
    <message>
        <source>Films (*.gif *.webm);;Pictures of each frame (*.png)</source>
        <translation>Vídeos (*.gif *.webm);;Imágenes de cada fotograma (*.png)</translation>
    </message>
</context>
<context>
    <name>app::FilmSize</name>
    <message>
        <source>Width in pixels</source>
        <translation>Anchura en píxeles</translation>
    </message>
    <message>
        <source>How wide the pictures are, %1 to %2 pixels</source>
        <translation>La anchura de las imágenes, de %1 a %2 píxeles</translation>
    </message>
    <message>
        <source>4 : 3</source>
        <translation>4 : 3</translation>
    </message>
    <message>
        <source>16 : 9</source>
        <translation>16 : 9</translation>
    </message>
    <message>
        <source>square</source>
        <translation>cuadrada</translation>
    </message>
    <message>
        <source>as the scene is</source>
        <translation>como la escena</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forma</translation>
    </message>
    <message>
        <source>The width of the pictures compared with their height; the height follows the width</source>
        <translation>La anchura de las imágenes en relación con su altura; la altura sigue a la anchura</translation>
    </message>
    <message>
        <source>Height: %1 pixels</source>
        <translation>Altura: %1 píxeles</translation>
    </message>
</context>
<context>
    <name>app::FootfallStrip</name>
    <message>
        <source>Feet on the ground</source>
        <translation>Pies en el suelo</translation>
    </message>
    <message>
        <source>%1 stands, slipped %2&#x202f;px.</source>
        <translation>%1 está apoyado, ha resbalado %2&#x202f;px.</translation>
    </message>
    <message>
        <source>%1 is in the air.</source>
        <translation>%1 está en el aire.</translation>
    </message>
    <message>
        <source>Feet on the ground, and how many px each slips</source>
        <translation>Pies en el suelo, y cuántos px resbala cada uno</translation>
    </message>
    <message>
        <source>The times when each foot is on the ground. Click to go to that frame</source>
        <translation>Los momentos en que cada pie está en el suelo. Haz clic para ir a ese fotograma</translation>
    </message>
    <message>
        <source>%1 is in the air at frame %2</source>
        <translation>%1 está en el aire en el fotograma %2</translation>
    </message>
    <message>
        <source>%1 stands from frame %2 to %3 and slips %4&#x202f;px</source>
        <translation>%1 se apoya del fotograma %2 al %3 y resbala %4&#x202f;px</translation>
    </message>
</context>
<context>
    <name>app::FrameCounter</name>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Fotograma</translation>
    </message>
    <message>
        <source>Go to frame</source>
        <translation>Ir al fotograma</translation>
    </message>
    <message>
        <source>Press Enter to go there, Esc to cancel</source>
        <translation>Pulsa Intro para ir allí, Esc para cancelar</translation>
    </message>
    <message>
        <source>A frame is a whole number from 0 to %1.</source>
        <translation>Un fotograma es un número entero de 0 a %1.</translation>
    </message>
</context>
<context>
    <name>app::FrameRange</name>
    <message>
        <source>First frame</source>
        <translation>Primer fotograma</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Último fotograma</translation>
    </message>
    <message>
        <source>&amp;First frame</source>
        <translation>&amp;Primer fotograma</translation>
    </message>
    <message>
        <source>&amp;Last frame</source>
        <translation>Ú&amp;ltimo fotograma</translation>
    </message>
</context>
<context>
    <name>app::Gallery</name>
    <message>
        <source>the file</source>
        <translation>el archivo</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texto</translation>
    </message>
    <message>
        <source>this is not an experiment of the gallery.</source>
        <translation>esto no es un experimento de la galería.</translation>
    </message>
    <message>
        <source>%1 The file was left alone.</source>
        <translation>%1 El archivo se ha dejado como estaba.</translation>
    </message>
    <message>
        <source>%1: the file could not be written: %2. Check the folder %3.</source>
        <translation>%1: no se pudo escribir el archivo: %2. Comprueba la carpeta %3.</translation>
    </message>
    <message>
        <source>keep %1</source>
        <translation>guardar %1</translation>
    </message>
    <message>
        <source>rename %1</source>
        <translation>renombrar %1</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>quitar %1</translation>
    </message>
    <message>
        <source>%1: the file could not be removed: %2. Check the folder %3.</source>
        <translation>%1: no se pudo quitar el archivo: %2. Comprueba la carpeta %3.</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Deshacer: %1</translation>
    </message>
</context>
<context>
    <name>app::GalleryDesk</name>
    <message>
        <source>Could not keep the experiment: %1</source>
        <translation>No se pudo guardar el experimento: %1</translation>
    </message>
    <message>
        <source>Kept in the gallery as %1.</source>
        <translation>Guardado en la galería como %1.</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Abrir %1</translation>
    </message>
    <message>
        <source>%1 is open. Undo brings your scene back.</source>
        <translation>%1 está abierto. Deshacer recupera tu escena.</translation>
    </message>
</context>
<context>
    <name>app::GalleryPage</name>
    <message>
        <source>Gallery</source>
        <translation>Galería</translation>
    </message>
    <message>
        <source>Experiments that you keep</source>
        <translation>Experimentos que guardas</translation>
    </message>
    <message>
        <source>Nothing is kept here yet. Build something, then press Keep this one: the gallery stores it with a picture.</source>
        <translation>Aquí aún no hay nada guardado. Construye algo y pulsa Guardar este: la galería lo guarda con una imagen.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Abrir</translation>
    </message>
    <message>
        <source>Open the selected experiment (Return)</source>
        <translation>Abrir el experimento seleccionado (Intro)</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renombrar</translation>
    </message>
    <message>
        <source>Give the selected experiment another title (F2)</source>
        <translation>Dar otro título al experimento seleccionado (F2)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Quitar</translation>
    </message>
    <message>
        <source>Remove the selected experiment from the gallery (Del)</source>
        <translation>Quitar de la galería el experimento seleccionado (Supr)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Deshacer</translation>
    </message>
    <message>
        <source>Keep this one</source>
        <translation>Guardar este</translation>
    </message>
    <message>
        <source>Keep the experiment that is open in the window</source>
        <translation>Guardar el experimento que está abierto en la ventana</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close the gallery (Esc)</source>
        <translation>Cerrar la galería (Esc)</translation>
    </message>
    <message>
        <source>%1, kept %2. Return opens it.</source>
        <translation>%1, guardado %2. Intro lo abre.</translation>
    </message>
    <message>
        <source>There is nothing to undo</source>
        <translation>No hay nada que deshacer</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Z)</source>
        <translation>%1 (Ctrl+Z)</translation>
    </message>
</context>
<context>
    <name>app::GlossaryPage</name>
    <message>
        <source>Glossary</source>
        <translation>Glosario</translation>
    </message>
    <message>
        <source>The words that the lessons teach. Esc closes this page.</source>
        <translation>Las palabras que enseñan las lecciones. Esc cierra esta página.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Buscar</translation>
    </message>
    <message>
        <source>Search the glossary</source>
        <translation>Buscar en el glosario</translation>
    </message>
    <message>
        <source>Part of a word, or of its meaning</source>
        <translation>Parte de una palabra o de su significado</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Palabras</translation>
    </message>
    <message>
        <source>No word found for “%1”. Try only a part of it.</source>
        <translation>No hay ninguna palabra para «%1». Prueba con solo una parte.</translation>
    </message>
</context>
<context>
    <name>app::GrowthPlot</name>
    <message>
        <source>Map of growth</source>
        <translation>Mapa del crecimiento</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>inestable</translation>
    </message>
    <message>
        <source>stable</source>
        <translation>estable</translation>
    </message>
    <message>
        <source>disturbances %1</source>
        <translation>perturbaciones %1</translation>
    </message>
    <message>
        <source>a step of %1</source>
        <translation>un paso de tiempo de %1</translation>
    </message>
    <message>
        <source>Click or press Enter to use k %1 and %2</source>
        <translation>Haz clic o pulsa Intro para usar k %1 y %2</translation>
    </message>
    <message>
        <source>stiffness k, 1/frame²</source>
        <translation>rigidez k, 1/fotograma²</translation>
    </message>
    <message>
        <source>step, frames</source>
        <translation>paso de tiempo, fotogramas</translation>
    </message>
    <message>
        <source>damp, kept per frame</source>
        <translation>damp, por fotograma</translation>
    </message>
    <message>
        <source>×10 a frame</source>
        <translation>×10/fotograma</translation>
    </message>
</context>
<context>
    <name>app::GuessBox</name>
    <message>
        <source>What do you expect?</source>
        <translation>¿Qué esperas?</translation>
    </message>
    <message>
        <source>You said: %1</source>
        <translation>Dijiste: %1</translation>
    </message>
    <message>
        <source>Choose what you expect</source>
        <translation>Elige lo que esperas</translation>
    </message>
    <message>
        <source>Hide the choices</source>
        <translation>Ocultar las opciones</translation>
    </message>
    <message>
        <source>**You said:** %1</source>
        <translation>**Dijiste:** %1</translation>
    </message>
</context>
<context>
    <name>app::GuideBox</name>
    <message>
        <source>First build</source>
        <translation>Guía</translation>
    </message>
    <message>
        <source>With keys: arrow keys move the cross in the picture, Return clicks there, Tab goes to fields and switches.</source>
        <translation>Con el teclado: las flechas mueven la cruz en la imagen, Intro hace clic allí, Tab va a los campos e interruptores.</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Reiniciar</translation>
    </message>
    <message>
        <source>Restart the first build with a new scene. Undo brings this one back</source>
        <translation>Reiniciar la primera construcción con una escena nueva. Deshacer recupera esta</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Dejarlo</translation>
    </message>
    <message>
        <source>Leave the first build; the scene stays as it is</source>
        <translation>Dejar la primera construcción; la escena se queda como está</translation>
    </message>
    <message>
        <source>First build: %1 of %2</source>
        <translation>Guía: %1 de %2</translation>
    </message>
</context>
<context>
    <name>app::HandInDialog</name>
    <message>
        <source>Hand in a notebook</source>
        <translation>Entregar un cuaderno</translation>
    </message>
    <message>
        <source>A notebook has what you did: what you tried, predicted, wrote and built, each with its run. Your teacher can replay it. Nothing is sent: the files stay on this computer until you pass them on.</source>
        <translation>Un cuaderno contiene lo que has hecho: lo que has probado, predicho, escrito y construido, cada cosa con su ejecución. Tu profesor o profesora puede volver a reproducirlo. No se envía nada: los archivos se quedan en este equipo hasta que tú los pases.</translation>
    </message>
    <message>
        <source>may stay empty</source>
        <translation>puede quedar vacío</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Your name for the notebook. Without it, the notebook has no name</source>
        <translation>Tu nombre para el cuaderno. Sin él, el cuaderno no tiene nombre</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nombre</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lecciones</translation>
    </message>
    <message>
        <source>Space chooses a lesson, or leaves it out</source>
        <translation>Espacio elige una lección, o la omite</translation>
    </message>
    <message>
        <source>&amp;Lessons, and how much you did in them</source>
        <translation>&amp;Lecciones, y cuánto has hecho en ellas</translation>
    </message>
    <message>
        <source>Also puts in the scenes that you keep in the gallery</source>
        <translation>Incluye también las escenas que guardas en la galería</translation>
    </message>
    <message>
        <source>Note&amp;book (.springstep-notebook)</source>
        <translation>C&amp;uaderno (.springstep-notebook)</translation>
    </message>
    <message>
        <source>A file whose runs your teacher can replay</source>
        <translation>Un archivo cuyas ejecuciones puede reproducir tu profesor o profesora</translation>
    </message>
    <message>
        <source>&amp;Web page (.html)</source>
        <translation>Página &amp;web (.html)</translation>
    </message>
    <message>
        <source>A page to read in any browser, with pictures</source>
        <translation>Una página con imágenes, para leer en cualquier navegador</translation>
    </message>
    <message>
        <source>&amp;PDF (.pdf)</source>
        <translation>&amp;PDF (.pdf)</translation>
    </message>
    <message>
        <source>The same on paper</source>
        <translation>Lo mismo en papel</translation>
    </message>
    <message>
        <source>Where to write, without an ending</source>
        <translation>Dónde guardarlo, sin extensión</translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation>&amp;Archivo</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>Cerrar esta página (Esc)</translation>
    </message>
    <message>
        <source>Scenes of the &amp;gallery (%1)</source>
        <translation>Escenas de la &amp;galería (%1)</translation>
    </message>
    <message>
        <source>Notebooks (*.springstep-notebook)</source>
        <translation>Cuadernos (*.springstep-notebook)</translation>
    </message>
    <message>
        <source>Wri&amp;te</source>
        <translation>Guar&amp;dar</translation>
    </message>
    <message>
        <source>Write the files</source>
        <translation>Guardar los archivos</translation>
    </message>
    <message>
        <source>There is nothing to hand in yet. Do a thing to try, answer a prediction, or keep a scene first.</source>
        <translation>Aún no hay nada que entregar. Antes haz una prueba, responde a una predicción o guarda una escena.</translation>
    </message>
    <message>
        <source>Choose a lesson, or the scenes of the gallery.</source>
        <translation>Elige una lección, o las escenas de la galería.</translation>
    </message>
    <message>
        <source>Choose what to write: the notebook, the web page or the PDF.</source>
        <translation>Elige qué guardar: el cuaderno, la página web o el PDF.</translation>
    </message>
    <message>
        <source>Type the name of a file.</source>
        <translation>Escribe el nombre de un archivo.</translation>
    </message>
    <message>
        <source>This writes %1.</source>
        <translation>Se guarda como %1.</translation>
    </message>
    <message>
        <source>%1 already exists. Replace it, or choose another name.</source>
        <translation>%1 ya existe. Reemplázalo o elige otro nombre.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Reemplazar</translation>
    </message>
    <message>
        <source>Write the files, and overwrite those that exist</source>
        <translation>Guardar los archivos y sobrescribir los que ya existen</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Guardando…</translation>
    </message>
    <message>
        <source>%1 written to %2.</source>
        <translation>%1: guardado en %2.</translation>
    </message>
    <message>
        <source>Could not write: %1</source>
        <translation>No se pudo guardar: %1</translation>
    </message>
    <message>
        <source>notebook</source>
        <comment>name of a file</comment>
        <translation>cuaderno</translation>
    </message>
</context>
<context>
    <name>app::Header</name>
    <message>
        <source>More menus</source>
        <translation>Más menús</translation>
    </message>
</context>
<context>
    <name>app::HelpPage</name>
    <message>
        <source>Keys and mouse</source>
        <translation>Teclas y ratón</translation>
    </message>
    <message>
        <source>Everything works without the mouse, too. Esc closes this page.</source>
        <translation>Todo funciona también sin ratón. Esc cierra esta página.</translation>
    </message>
</context>
<context>
    <name>app::Introduction</name>
    <message>
        <source>These lessons have no concepts</source>
        <translation>Estas lecciones no tienen conceptos</translation>
    </message>
</context>
<context>
    <name>app::KeyCaps</name>
    <message>
        <source>or</source>
        <translation>o</translation>
    </message>
</context>
<context>
    <name>app::LanguageMenu</name>
    <message>
        <source>Lan&amp;guage</source>
        <translation>&amp;Idioma</translation>
    </message>
    <message>
        <source>&amp;System language</source>
        <translation>Idioma del &amp;sistema</translation>
    </message>
    <message>
        <source>Springstep will use %1 after a restart.</source>
        <translation>Springstep usará %1 al reiniciarse.</translation>
    </message>
</context>
<context>
    <name>app::LearnPanel</name>
    <message>
        <source>Lessons</source>
        <translation>Lecciones</translation>
    </message>
    <message>
        <source>%1 of %2 steps</source>
        <translation>%1/%2 pasos</translation>
    </message>
    <message>
        <source>Fold the lessons to a narrow strip</source>
        <translation>Plegar las lecciones en una franja estrecha</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Todas las lecciones</translation>
    </message>
    <message>
        <source>Back to the text (Esc)</source>
        <translation>Volver al texto (Esc)</translation>
    </message>
    <message>
        <source>Show all lessons instead of the text</source>
        <translation>Mostrar todas las lecciones en vez del texto</translation>
    </message>
</context>
<context>
    <name>app::LearnerCode</name>
    <message>
        <source>Change code</source>
        <translation>Cambiar el código</translation>
    </message>
    <message>
        <source>Reset listing</source>
        <translation>Restablecer el listado</translation>
    </message>
    <message>
        <source>your code</source>
        <translation>tu código</translation>
    </message>
    <message>
        <source>the listing of the step</source>
        <translation>el listado del paso</translation>
    </message>
    <message>
        <source>This step has no listing.</source>
        <translation>Este paso no tiene listado.</translation>
    </message>
    <message>
        <source>Your code does not compile. Line %1: %2</source>
        <translation>Tu código no se puede compilar. Línea %1: %2</translation>
    </message>
    <message>
        <source>Change method</source>
        <translation>Cambiar el método</translation>
    </message>
</context>
<context>
    <name>app::LessonDesk</name>
    <message>
        <source>New &amp;lesson from this scene…</source>
        <translation>Nueva lección &amp;de esta escena…</translation>
    </message>
    <message>
        <source>Write a small lesson with this scene into a folder, to go on with an editor</source>
        <translation>Escribir en una carpeta una pequeña lección con esta escena, para continuarla en un editor</translation>
    </message>
    <message>
        <source>There is no place for lessons of your own</source>
        <translation>No hay lugar para tus propias lecciones</translation>
    </message>
    <message>
        <source>Could not open the lesson: %1</source>
        <translation>No se pudo abrir la lección: %1</translation>
    </message>
    <message>
        <source>Choose a new folder for the lesson</source>
        <translation>Elegir una carpeta nueva para la lección</translation>
    </message>
    <message>
        <source>Folder of a lesson (*)</source>
        <translation>Carpeta de una lección (*)</translation>
    </message>
    <message>
        <source>Could not begin a lesson: %1</source>
        <translation>No se pudo empezar una lección: %1</translation>
    </message>
    <message>
        <source>The lesson is in %1. Write its texts in first.md: each time you save, they change here.</source>
        <translation>La lección está en %1. Escribe sus textos en first.md: cada vez que guardas, cambian aquí.</translation>
    </message>
    <message>
        <source>The lesson is in %1. Open its first.md in an editor: each time you save, it changes here.</source>
        <translation>La lección está en %1. Abre su first.md en un editor: cada vez que guardas, cambia aquí.</translation>
    </message>
    <message>
        <source>Could not show the lesson: %1</source>
        <translation>No se pudo mostrar la lección: %1</translation>
    </message>
    <message>
        <source>Re&amp;move this lesson from the list</source>
        <translation>&amp;Quitar esta lección de la lista</translation>
    </message>
    <message>
        <source>Take the open lesson out of your lessons; its files stay where they are</source>
        <translation>Quitar la lección abierta de tus lecciones; sus archivos se quedan donde están</translation>
    </message>
    <message>
        <source>The open lesson is not one of yours</source>
        <translation>La lección abierta no es una de las tuyas</translation>
    </message>
    <message>
        <source>%1 is no longer in the list. Its files are still there.</source>
        <translation>%1 ya no está en la lista. Sus archivos siguen ahí.</translation>
    </message>
    <message>
        <source>Put it back</source>
        <translation>Volver a ponerla</translation>
    </message>
    <message>
        <source>Opens the lesson again</source>
        <translation>Abre la lección de nuevo</translation>
    </message>
</context>
<context>
    <name>app::LessonList</name>
    <message>
        <source>Lessons</source>
        <translation>Lecciones</translation>
    </message>
</context>
<context>
    <name>app::LessonModel</name>
    <message>
        <source>open</source>
        <translation>abierta</translation>
    </message>
    <message>
        <source>%1, %2 of %3 steps done</source>
        <translation>%1, %2 de %3 pasos hechos</translation>
    </message>
    <message>
        <source>%1, done</source>
        <translation>%1, hecho</translation>
    </message>
    <message>
        <source>%1, not yet done</source>
        <translation>%1, aún sin hacer</translation>
    </message>
    <message>
        <source>Yours</source>
        <translation>Tuyas</translation>
    </message>
    <message>
        <source>Lessons that you opened with File &gt; Open</source>
        <translation>Lecciones que has abierto con Archivo &gt; Abrir</translation>
    </message>
    <message>
        <source>1 file is not a lesson</source>
        <translation>1 archivo no es una lección</translation>
    </message>
    <message>
        <source>%1 files are not lessons</source>
        <translation>%1 archivos no son lecciones</translation>
    </message>
    <message>
        <source>What you learnt</source>
        <translation>Lo que has aprendido</translation>
    </message>
    <message>
        <source>A summary of this lesson, and the things that are still to try</source>
        <translation>Un resumen de esta lección y lo que aún queda por probar</translation>
    </message>
    <message>
        <source>%1: what you learnt</source>
        <translation>%1: lo que has aprendido</translation>
    </message>
</context>
<context>
    <name>app::LessonRail</name>
    <message>
        <source>Show the lessons with their texts</source>
        <translation>Mostrar las lecciones con sus textos</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Paso anterior</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Paso siguiente</translation>
    </message>
</context>
<context>
    <name>app::LevelBox</name>
    <message>
        <source>Judge it</source>
        <translation>Evaluar</translation>
    </message>
    <message>
        <source>Runs your scene or your code, and says whether it passes</source>
        <translation>Ejecuta tu escena o tu código y dice si supera el nivel</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Stops the judge</source>
        <translation>Detiene la evaluación</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Pista</translation>
    </message>
    <message>
        <source>Shows or hides a hint</source>
        <translation>Muestra u oculta una pista</translation>
    </message>
    <message>
        <source>%1, passed</source>
        <translation>%1, superado</translation>
    </message>
    <message>
        <source>Judging: %1 % of the frames.</source>
        <translation>Evaluando: %1 % de los fotogramas.</translation>
    </message>
    <message>
        <source>Passed: everything holds.</source>
        <translation>Superado: todo se cumple.</translation>
    </message>
</context>
<context>
    <name>app::LineStepper</name>
    <message>
        <source>Line %1 does not run in this frame, nor in the next one.</source>
        <translation>La línea %1 no se ejecuta en este fotograma ni en el siguiente.</translation>
    </message>
</context>
<context>
    <name>app::ListingEditor</name>
    <message>
        <source>Listing: the code that you can change</source>
        <translation>Listado: el código que puedes cambiar</translation>
    </message>
    <message>
        <source>Run to this line</source>
        <translation>Ejecutar hasta esta línea</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Cortar</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copiar</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Pegar</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Seleccionar todo</translation>
    </message>
    <message>
        <source>Reset listing</source>
        <translation>Restablecer el listado</translation>
    </message>
    <message>
        <source>The run stops before this line. Click the dot to remove the breakpoint</source>
        <translation>La ejecución se para antes de esta línea. Haz clic en el círculo para quitar el punto de interrupción</translation>
    </message>
    <message>
        <source>Click to run to this line. Ctrl+click sets a breakpoint</source>
        <translation>Haz clic para ejecutar hasta esta línea. Ctrl+clic pone un punto de interrupción</translation>
    </message>
    <message>
        <source>You changed this line. %1</source>
        <translation>Has cambiado esta línea. %1</translation>
    </message>
    <message>
        <source>Set breakpoint</source>
        <translation>Poner punto de interrupción</translation>
    </message>
    <message>
        <source>Remove breakpoint</source>
        <translation>Quitar punto de interrupción</translation>
    </message>
    <message>
        <source>Type to change it; the run is computed again after a short pause. Tab indents, %1 completes a name, %2 sets a breakpoint, Esc leaves the editor.</source>
        <translation>Escribe para cambiarlo; la ejecución se calcula de nuevo tras una breve pausa. Tab sangra, %1 completa un nombre, %2 pone un punto de interrupción, Esc sale del editor.</translation>
    </message>
    <message>
        <source>My rule: forces that you write</source>
        <translation>Mi regla: fuerzas que escribes tú</translation>
    </message>
    <message>
        <source>Type to change it; the run is computed again after a short pause. Tab indents, %1 completes a name, Esc leaves the editor.</source>
        <translation>Escribe para cambiarla; la ejecución se calcula de nuevo tras una breve pausa. Tab sangra, %1 completa un nombre, Esc sale del editor.</translation>
    </message>
    <message>
        <source>Delete rule</source>
        <translation>Eliminar la regla</translation>
    </message>
</context>
<context>
    <name>app::ListingPanel</name>
    <message>
        <source>Reset listing</source>
        <translation>Restablecer el listado</translation>
    </message>
    <message>
        <source>Correct the mistake first. Until then, the last good code computes the run.</source>
        <translation>Corrige antes el error. Hasta entonces, el último código válido calcula la ejecución.</translation>
    </message>
    <message>
        <source>This listing does not compute the run. Choose “Use your code” first.</source>
        <translation>Este listado no calcula la ejecución. Elige antes «Usar tu código».</translation>
    </message>
    <message>
        <source>Bring the step&apos;s own listing back (Undo brings yours back)</source>
        <translation>Recuperar el listado del propio paso (Deshacer recupera el tuyo)</translation>
    </message>
    <message>
        <source>This is the step&apos;s own listing.</source>
        <translation>Este es el listado del propio paso.</translation>
    </message>
    <message>
        <source>No line that runs comes after line %1. Choose a line inside a function.</source>
        <translation>Después de la línea %1 no hay ninguna que se ejecute. Elige una línea dentro de una función.</translation>
    </message>
    <message>
        <source>No longer stops before line %1.</source>
        <translation>Ya no se para antes de la línea %1.</translation>
    </message>
    <message>
        <source>Stops before line %1.</source>
        <translation>Se para antes de la línea %1.</translation>
    </message>
</context>
<context>
    <name>app::MainWindow</name>
    <message>
        <source>Accuracy</source>
        <translation>Precisión</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energía</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Efectos</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Código</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>Abrir &amp;recientes</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Gráficas</translation>
    </message>
    <message>
        <source>Two runs</source>
        <translation>Dos ejecuciones</translation>
    </message>
    <message>
        <source>Stability</source>
        <translation>Estabilidad</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Lecciones</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>The panels are back in their original places.</source>
        <translation>Los paneles están otra vez en sus lugares originales.</translation>
    </message>
    <message>
        <source>There is no folder for the gallery</source>
        <translation>No hay carpeta para la galería</translation>
    </message>
</context>
<context>
    <name>app::MapPage</name>
    <message>
        <source>Map of concepts</source>
        <translation>Mapa de conceptos</translation>
    </message>
    <message>
        <source>What rests on what</source>
        <translation>Qué se apoya en qué</translation>
    </message>
    <message>
        <source>You know it</source>
        <translation>Ya lo sabes</translation>
    </message>
    <message>
        <source>Can come next</source>
        <translation>Puede venir ahora</translation>
    </message>
    <message>
        <source>For later</source>
        <translation>Para después</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Back to the open step (Esc)</source>
        <translation>Volver al paso abierto (Esc)</translation>
    </message>
    <message>
        <source>You know %1 of %2 concepts. Lines lead up from a concept to those that it rests on.</source>
        <translation>Sabes %1 de %2 conceptos. Las líneas suben de un concepto a aquellos en los que se apoya.</translation>
    </message>
    <message>
        <source>Go on: %1</source>
        <translation>Seguir: %1</translation>
    </message>
    <message>
        <source>Begin: %1</source>
        <translation>Empezar: %1</translation>
    </message>
    <message>
        <source>Opens %1</source>
        <translation>Abre %1</translation>
    </message>
    <message>
        <source>you know it</source>
        <translation>ya lo sabes</translation>
    </message>
    <message>
        <source>it can come next</source>
        <translation>puede venir ahora</translation>
    </message>
    <message>
        <source>for later</source>
        <translation>para más adelante</translation>
    </message>
    <message>
        <source>Point at a concept to see what it rests on. A click, or **Enter**, opens its step. The arrow keys go from one to the next.</source>
        <translation>Señala un concepto para ver en qué se apoya. Un clic, o **Intro**, abre su paso. Las flechas van de uno a otro.</translation>
    </message>
    <message>
        <source>Rests on: %1.</source>
        <translation>Se apoya en: %1.</translation>
    </message>
    <message>
        <source>Leads to: %1.</source>
        <translation>Lleva a: %1.</translation>
    </message>
</context>
<context>
    <name>app::MapPlot</name>
    <message>
        <source>a step of %1&#x2009;frames</source>
        <translation>un paso de tiempo de %1 fotogramas</translation>
    </message>
    <message>
        <source>The map is being computed.</source>
        <translation>Se está calculando el mapa.</translation>
    </message>
    <message>
        <source>You are at %1. The arrow keys move over the map, and Enter uses the values at a place.</source>
        <translation>Estás en %1. Las flechas recorren el mapa, e Intro usa los valores de un lugar.</translation>
    </message>
    <message>
        <source>you are here</source>
        <translation>estás aquí</translation>
    </message>
</context>
<context>
    <name>app::MeasurePanel</name>
    <message>
        <source>Measured</source>
        <translation>Medido</translation>
    </message>
    <message>
        <source>at the cursor</source>
        <translation>en el cursor</translation>
    </message>
</context>
<context>
    <name>app::MistakeRow</name>
    <message>
        <source>Line %1: %2</source>
        <translation>Línea %1: %2</translation>
    </message>
</context>
<context>
    <name>app::NameField</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>Name of the run</source>
        <translation>Nombre de la ejecución</translation>
    </message>
    <message>
        <source>Press Return to apply, Esc to cancel</source>
        <translation>Pulsa Intro para aplicar, Esc para cancelar</translation>
    </message>
</context>
<context>
    <name>app::NameRow</name>
    <message>
        <source>Name</source>
        <translation>Nombre</translation>
    </message>
    <message>
        <source>The name of the point in files, in “Stop when…”, and in lessons and their listings. Press Enter to apply.</source>
        <translation>El nombre del punto en los archivos, en «Parar cuando…» y en las lecciones y sus listados. Pulsa Intro para aplicar.</translation>
    </message>
</context>
<context>
    <name>app::Narration</name>
    <message>
        <source>Try this</source>
        <translation>Prueba esto</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Paso anterior</translation>
    </message>
    <message>
        <source>Back: %1</source>
        <translation>Atrás: %1</translation>
    </message>
    <message>
        <source>This is the first step.</source>
        <translation>Este es el primer paso.</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Siguiente: %1</translation>
    </message>
    <message>
        <source>What you learnt</source>
        <translation>Lo que has aprendido</translation>
    </message>
    <message>
        <source>What you learnt in this lesson, and what comes next</source>
        <translation>Lo que has aprendido en esta lección y lo que viene después</translation>
    </message>
    <message>
        <source>Write it yourself</source>
        <translation>Escríbelo tú</translation>
    </message>
    <message>
        <source>Predict, then play</source>
        <translation>Predice y luego reproduce</translation>
    </message>
    <message>
        <source>Predict first</source>
        <translation>Predice antes</translation>
    </message>
    <message>
        <source>Goes to a question about a run, at the end of the text</source>
        <translation>Va a una pregunta sobre una ejecución, al final del texto</translation>
    </message>
    <message>
        <source>Goes to a task in the listing, at the end of the text</source>
        <translation>Va a una tarea en el listado, al final del texto</translation>
    </message>
</context>
<context>
    <name>app::Notice</name>
    <message>
        <source>Notice</source>
        <translation>Aviso</translation>
    </message>
    <message>
        <source>Close this notice (Esc)</source>
        <translation>Cerrar este aviso (Esc)</translation>
    </message>
    <message>
        <source>Close this notice</source>
        <translation>Cerrar este aviso</translation>
    </message>
</context>
<context>
    <name>app::NumberTable</name>
    <message>
        <source>Could not save the numbers as %1: %2. Choose another folder, or free some disk space.</source>
        <translation>No se pudieron guardar los números como %1: %2. Elige otra carpeta o libera espacio en el disco.</translation>
    </message>
</context>
<context>
    <name>app::OrderPlot</name>
    <message>
        <source>Error against step: the measured order</source>
        <translation>Error frente al paso de tiempo: el orden medido</translation>
    </message>
    <message>
        <source>%1: %2, as expected</source>
        <translation>%1: %2, como se esperaba</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1: %2 de %3</translation>
    </message>
    <message>
        <source>step, frames (finer →)</source>
        <translation>paso de tiempo, fotogramas (más fino →)</translation>
    </message>
    <message>
        <source>A step %1 times as short makes the error %2 times as small: order %3 here, %4 expected</source>
        <translation>Un paso de tiempo %1 veces más corto hace el error %2 veces más pequeño: orden %3 aquí, se esperaba %4</translation>
    </message>
</context>
<context>
    <name>app::ParameterPanel</name>
    <message>
        <source>Parameters</source>
        <translation>Parámetros</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Restablecer todo</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Preajustes</translation>
    </message>
    <message>
        <source>Pictures of this step with other values</source>
        <translation>Imágenes de este paso con otros valores</translation>
    </message>
    <message>
        <source>Reset every parameter to its start value in this step</source>
        <translation>Devolver cada parámetro a su valor inicial en este paso</translation>
    </message>
    <message>
        <source>Nothing to reset: every parameter has its start value.</source>
        <translation>Nada que restablecer: todos los parámetros tienen su valor inicial.</translation>
    </message>
    <message>
        <source>Show fewer parameters</source>
        <translation>Mostrar menos parámetros</translation>
    </message>
    <message>
        <source>Show all parameters</source>
        <translation>Mostrar todos los parámetros</translation>
    </message>
    <message>
        <source>%1, shown</source>
        <translation>%1, desplegado</translation>
    </message>
    <message>
        <source>%1, folded</source>
        <translation>%1, plegado</translation>
    </message>
</context>
<context>
    <name>app::ParameterRow</name>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1, deslizador</translation>
    </message>
    <message>
        <source>Reset to %1</source>
        <translation>Restablecer a %1</translation>
    </message>
    <message>
        <source>Reset %1 to %2</source>
        <translation>Restablecer %1 a %2</translation>
    </message>
    <message>
        <source>It can be %1 to %2%3.</source>
        <translation>Puede ir de %1 a %2%3.</translation>
    </message>
    <message>
        <source>%1 can be %2 to %3.</source>
        <translation>%1 puede ir de %2 a %3.</translation>
    </message>
</context>
<context>
    <name>app::Playback</name>
    <message>
        <source>The run plays while you drag. Press Space to stop it.</source>
        <translation>La ejecución se reproduce mientras arrastras. Pulsa Espacio para pararla.</translation>
    </message>
    <message>
        <source>The run is paused. Press Space to play from here.</source>
        <translation>La ejecución está parada. Pulsa Espacio para reproducirla desde aquí.</translation>
    </message>
    <message>
        <source>Too much to compute at 30 frames a second: the run plays more slowly. Its numbers stay the same.</source>
        <translation>Demasiado que calcular a 30 fotogramas por segundo: la ejecución se reproduce más despacio. Sus números no cambian.</translation>
    </message>
</context>
<context>
    <name>app::PlotCard</name>
    <message>
        <source>Plotted quantity</source>
        <translation>Magnitud representada</translation>
    </message>
    <message>
        <source>The other axis: time, or another quantity</source>
        <translation>El otro eje: el tiempo u otra magnitud</translation>
    </message>
    <message>
        <source>Save, copy, keep or remove this plot</source>
        <translation>Guardar, copiar, fijar o quitar esta gráfica</translation>
    </message>
    <message>
        <source>Actions for this plot</source>
        <translation>Acciones para esta gráfica</translation>
    </message>
    <message>
        <source>against</source>
        <translation>frente a</translation>
    </message>
    <message>
        <source>&amp;Pin to %1</source>
        <translation>&amp;Fijar a «%1»</translation>
    </message>
    <message>
        <source>If off, the plot follows the body that is selected in the picture</source>
        <translation>Si está desactivado, la gráfica sigue al cuerpo seleccionado en la imagen</translation>
    </message>
    <message>
        <source>&amp;Fewer frames	+</source>
        <translation>&amp;Menos fotogramas	+</translation>
    </message>
    <message>
        <source>&amp;More frames	−</source>
        <translation>Más fo&amp;togramas	−</translation>
    </message>
    <message>
        <source>&amp;Remove this plot	Del</source>
        <translation>&amp;Quitar esta gráfica	Supr</translation>
    </message>
</context>
<context>
    <name>app::PlotExport</name>
    <message>
        <source>Save the &amp;picture…</source>
        <translation>Guardar la &amp;imagen…</translation>
    </message>
    <message>
        <source>&amp;Copy the picture</source>
        <translation>&amp;Copiar la imagen</translation>
    </message>
    <message>
        <source>As PNG, SVG or PDF</source>
        <translation>Como PNG, SVG o PDF</translation>
    </message>
    <message>
        <source>Save the &amp;numbers as CSV…</source>
        <translation>Guardar los &amp;números como CSV…</translation>
    </message>
    <message>
        <source>Every frame of the run, with all digits</source>
        <translation>Todos los fotogramas de la ejecución, con todas las cifras</translation>
    </message>
    <message>
        <source>Save or copy this plot</source>
        <translation>Guardar o copiar esta gráfica</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Guardado como %1.</translation>
    </message>
    <message>
        <source>Could not save the picture as %1: %2. Choose another folder, or free some disk space.</source>
        <translation>No se pudo guardar la imagen como %1: %2. Elige otra carpeta o libera espacio en el disco.</translation>
    </message>
    <message>
        <source>The picture is copied: paste it anywhere.</source>
        <translation>La imagen está copiada: pégala donde quieras.</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Guardar la imagen</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg *.pdf)</source>
        <translation>Imágenes (*.png *.svg *.pdf)</translation>
    </message>
    <message>
        <source>Save the numbers</source>
        <translation>Guardar los números</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tablas (*.csv)</translation>
    </message>
    <message>
        <source>There are no numbers to save, because this plot is empty. Play the run first.</source>
        <translation>No hay números que guardar, porque esta gráfica está vacía. Reproduce antes la ejecución.</translation>
    </message>
    <message>
        <source>Cancelled: nothing was saved.</source>
        <translation>Cancelado: no se ha guardado nada.</translation>
    </message>
    <message>
        <source>All values that are counted or measured here, with all digits</source>
        <translation>Todos los valores que se cuentan o se miden aquí, con todas las cifras</translation>
    </message>
    <message>
        <source>Could not save the numbers as %1: %2. Choose another folder, or free some disk space.</source>
        <translation>No se pudieron guardar los números como %1: %2. Elige otra carpeta o libera espacio en el disco.</translation>
    </message>
</context>
<context>
    <name>app::PlotValue</name>
    <message>
        <source>The number at the cursor</source>
        <translation>El número en el cursor</translation>
    </message>
</context>
<context>
    <name>app::PlotsPanel</name>
    <message>
        <source>Plots</source>
        <translation>Gráficas</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Añadir</translation>
    </message>
    <message>
        <source>Another plot</source>
        <translation>Otra gráfica</translation>
    </message>
    <message>
        <source>Add a plot</source>
        <translation>Añadir una gráfica</translation>
    </message>
    <message>
        <source>There is no plot yet. &lt;b&gt;Add&lt;/b&gt;, above, has curves to start with: the position of a body, its speed, or one quantity against another.</source>
        <translation>Aún no hay ninguna gráfica. &lt;b&gt;Añadir&lt;/b&gt;, arriba, tiene curvas para empezar: la posición de un cuerpo, su rapidez o una magnitud frente a otra.</translation>
    </message>
    <message>
        <source>Progress of saving</source>
        <translation>Progreso del guardado</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Cancelar</translation>
    </message>
    <message>
        <source>Cancel; nothing is saved then</source>
        <translation>Cancelar; entonces no se guarda nada</translation>
    </message>
    <message>
        <source>Saving numbers…</source>
        <translation>Guardando los números…</translation>
    </message>
    <message>
        <source>There are %1 plots: more would be too small to read. Remove one first.</source>
        <translation>Hay %1 gráficas: más serían demasiado pequeñas para leerlas. Quita antes una.</translation>
    </message>
    <message>
        <source>%1 against time</source>
        <translation>%1 frente al tiempo</translation>
    </message>
    <message>
        <source>the path: y against x</source>
        <translation>la trayectoria: y frente a x</translation>
    </message>
    <message>
        <source>velocity y against y</source>
        <translation>velocidad y frente a y</translation>
    </message>
    <message>
        <source>turning speed against angle</source>
        <translation>rapidez de giro frente al ángulo</translation>
    </message>
    <message>
        <source>For anything else, add a plot and choose what it shows</source>
        <translation>Para cualquier otra cosa, añade una gráfica y elige qué muestra</translation>
    </message>
    <message>
        <source>The names above a plot are menus</source>
        <translation>Los nombres encima de una gráfica son menús</translation>
    </message>
    <message>
        <source>the whole run</source>
        <translation>toda la ejecución</translation>
    </message>
    <message>
        <source>frame %1 to %2</source>
        <translation>fotograma %1 a %2</translation>
    </message>
</context>
<context>
    <name>app::PredictionBox</name>
    <message>
        <source>Fold this prediction</source>
        <translation>Plegar esta predicción</translation>
    </message>
    <message>
        <source>Predict what happens</source>
        <translation>Predecir qué ocurre</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>fotogramas</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un número</translation>
    </message>
    <message>
        <source>Type your prediction. Enter plays the run.</source>
        <translation>Escribe tu predicción. Intro reproduce la ejecución.</translation>
    </message>
    <message>
        <source>Your prediction</source>
        <translation>Tu predicción</translation>
    </message>
    <message>
        <source>Your prediction, %1</source>
        <translation>Tu predicción, %1</translation>
    </message>
    <message>
        <source>Choose the place</source>
        <translation>Elegir lugar</translation>
    </message>
    <message>
        <source>Shows how the run begins. Then click a place, or move the cross with the arrow keys.</source>
        <translation>Muestra cómo empieza la ejecución. Luego haz clic en un lugar, o mueve la cruz con las flechas.</translation>
    </message>
    <message>
        <source>Play it</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>Predict again</source>
        <translation>Predecir otra vez</translation>
    </message>
    <message>
        <source>Forgets this answer, so that you can give another one</source>
        <translation>Olvida esta respuesta, para que puedas dar otra</translation>
    </message>
    <message>
        <source>Watch the run. It stops by itself.</source>
        <translation>Observa la ejecución. Se para sola.</translation>
    </message>
    <message>
        <source>One moment …</source>
        <translation>Un momento…</translation>
    </message>
    <message>
        <source>The run was changed on the way. Play it again to see how it ends.</source>
        <translation>La ejecución se ha cambiado a mitad de camino. Reprodúcela otra vez para ver cómo termina.</translation>
    </message>
    <message>
        <source>Your cross is at **%1**.</source>
        <translation>Tu cruz está en **%1**.</translation>
    </message>
    <message>
        <source>Click in the scene, or move the cross with the arrow keys.</source>
        <translation>Haz clic en la escena, o mueve la cruz con las flechas.</translation>
    </message>
    <message>
        <source>Move the cross</source>
        <translation>Mover la cruz</translation>
    </message>
    <message>
        <source>Plays the run, and compares it with your prediction. Undo brings your own run back.</source>
        <translation>Reproduce la ejecución y la compara con tu predicción. Deshacer recupera tu propia ejecución.</translation>
    </message>
    <message>
        <source>Predict first.</source>
        <translation>Antes, predice algo.</translation>
    </message>
    <message>
        <source>Answered. Fold this prediction</source>
        <translation>Respondida. Plegar esta predicción</translation>
    </message>
    <message>
        <source>Answered. Show it again</source>
        <translation>Respondida. Mostrarla de nuevo</translation>
    </message>
    <message>
        <source>%1, answered</source>
        <translation>%1, respondida</translation>
    </message>
</context>
<context>
    <name>app::PredictionDesk</name>
    <message>
        <source>Prediction</source>
        <translation>Predicción</translation>
    </message>
    <message>
        <source>the prediction</source>
        <translation>la predicción</translation>
    </message>
    <message>
        <source>prediction</source>
        <translation>predicción</translation>
    </message>
</context>
<context>
    <name>app::PresetGallery</name>
    <message>
        <source>Presets</source>
        <translation>Preajustes</translation>
    </message>
    <message>
        <source>%1 Restarts this step.</source>
        <translation>%1 Reinicia este paso.</translation>
    </message>
</context>
<context>
    <name>app::ProjectBox</name>
    <message>
        <source>Start</source>
        <translation>Empezar</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Seguir</translation>
    </message>
    <message>
        <source>Opens what you have built so far</source>
        <translation>Abre lo que has construido hasta ahora</translation>
    </message>
    <message>
        <source>Put away</source>
        <translation>Apartar</translation>
    </message>
    <message>
        <source>Removes this project from here. What you built stays.</source>
        <translation>Quita este proyecto de aquí. Lo que has construido se queda.</translation>
    </message>
    <message>
        <source>Fold the project</source>
        <translation>Plegar el proyecto</translation>
    </message>
    <message>
        <source>Show the brief and the levels of the project</source>
        <translation>Mostrar el encargo y los niveles del proyecto</translation>
    </message>
    <message>
        <source>Project: %1</source>
        <translation>Proyecto: %1</translation>
    </message>
    <message>
        <source>Levels that you have passed</source>
        <translation>Niveles que has superado</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Empezar de nuevo</translation>
    </message>
    <message>
        <source>Opens the start scene of this project. Undo brings back what is there now.</source>
        <translation>Abre la escena inicial de este proyecto. Deshacer recupera lo que hay ahora.</translation>
    </message>
</context>
<context>
    <name>app::ProjectDesk</name>
    <message>
        <source>Start “%1”</source>
        <translation>Empezar «%1»</translation>
    </message>
    <message>
        <source>The start scene is open. Undo brings your scene back.</source>
        <translation>La escena inicial está abierta. Deshacer recupera tu escena.</translation>
    </message>
</context>
<context>
    <name>app::PropertyRow</name>
    <message>
        <source>%1 From %2 to %3.</source>
        <translation>%1 De %2 a %3.</translation>
    </message>
    <message>
        <source>different</source>
        <translation>distinto</translation>
    </message>
    <message>
        <source>Change %1 of %2</source>
        <translation>Cambiar %1: %2</translation>
    </message>
    <message>
        <source>Switch “%1” on</source>
        <translation>Activar «%1»</translation>
    </message>
    <message>
        <source>Switch “%1” off</source>
        <translation>Desactivar «%1»</translation>
    </message>
</context>
<context>
    <name>app::QuantityMenu</name>
    <message>
        <source>… and %1 more</source>
        <translation>… y %1 más</translation>
    </message>
    <message>
        <source>Select one in the picture, then pin the plot to it</source>
        <translation>Selecciona uno en la imagen y luego fija la gráfica a él</translation>
    </message>
    <message>
        <source>distance to</source>
        <translation>distancia a</translation>
    </message>
    <message>
        <source>of which body</source>
        <translation>de qué cuerpo</translation>
    </message>
    <message>
        <source>the selected one: %1</source>
        <translation>el seleccionado: %1</translation>
    </message>
</context>
<context>
    <name>app::QuantityPlot</name>
    <message>
        <source>%1 against %2</source>
        <translation>%1 frente a %2</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1: %2 at frame %3</source>
        <translation>%1: %2 en el fotograma %3</translation>
    </message>
    <message>
        <source>Play, or step one frame, to start a curve here.</source>
        <translation>Reproduce, o avanza un fotograma, para empezar aquí una curva.</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>fot.</translation>
    </message>
    <message>
        <source>%1: %2 inside frame %3</source>
        <translation>%1: %2 dentro del fotograma %3</translation>
    </message>
</context>
<context>
    <name>app::RecallBox</name>
    <message>
        <source>The question before</source>
        <translation>La pregunta anterior</translation>
    </message>
    <message>
        <source>The next question</source>
        <translation>La pregunta siguiente</translation>
    </message>
    <message>
        <source>Do it in the scene</source>
        <translation>Hazlo en la escena</translation>
    </message>
    <message>
        <source>Opens the scene. Your run of that step stays under “Runs”.</source>
        <translation>Abre la escena. Tu ejecución de ese paso se queda en «Ejecuciones».</translation>
    </message>
    <message>
        <source>**Right.** %1</source>
        <translation>**Correcto.** %1</translation>
    </message>
    <message>
        <source>**Not this one.** %1</source>
        <translation>**Esa no es.** %1</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Hacerlo otra vez</translation>
    </message>
    <message>
        <source>Question %1 of %2</source>
        <translation>Pregunta %1 de %2</translation>
    </message>
</context>
<context>
    <name>app::RecallDesk</name>
    <message>
        <source>There is no step %1.</source>
        <translation>No existe el paso %1.</translation>
    </message>
    <message>
        <source>Set the scene up</source>
        <translation>Preparar la escena</translation>
    </message>
    <message>
        <source>your run</source>
        <translation>tu ejecución</translation>
    </message>
    <message>
        <source>there is no step %1. Write “- step: lesson/step”.</source>
        <translation>no existe el paso %1. Escribe «- step: lesson/step».</translation>
    </message>
</context>
<context>
    <name>app::RecallPage</name>
    <message>
        <source>Do it in the scene</source>
        <translation>Hazlo en la escena</translation>
    </message>
    <message>
        <source>Set the scene up again</source>
        <translation>Preparar de nuevo la escena</translation>
    </message>
    <message>
        <source>Begins the run again as it was when this question opened</source>
        <translation>Empieza otra vez la ejecución, tal como estaba cuando se abrió esta pregunta</translation>
    </message>
    <message>
        <source>Back to the questions</source>
        <translation>Volver a las preguntas</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Volver</translation>
    </message>
    <message>
        <source>Back to the questions of the lesson. You can answer this one later.</source>
        <translation>Vuelve a las preguntas de la lección. Puedes responder a esta más tarde.</translation>
    </message>
    <message>
        <source>**Done** ✓</source>
        <translation>**Hecho** ✓</translation>
    </message>
    <message>
        <source>Not done yet. Springstep sees it when you have done it.</source>
        <translation>Aún no está hecho. Springstep lo ve cuando lo has hecho.</translation>
    </message>
</context>
<context>
    <name>app::RecoveryList</name>
    <message>
        <source>%1: %2 (not installed)</source>
        <translation>%1: %2 (no instalada)</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recuperar</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Recover scenes</source>
        <translation>Recuperar escenas</translation>
    </message>
    <message>
        <source>These scenes were not saved. Recover one to continue with it.</source>
        <translation>Estas escenas no se guardaron. Recupera una para continuar con ella.</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Fotogramas</translation>
    </message>
    <message>
        <source>Last changed</source>
        <translation>Último cambio</translation>
    </message>
    <message>
        <source>Scenes that were not saved</source>
        <translation>Escenas que no se guardaron</translation>
    </message>
    <message>
        <source>Continue with the selected scene (Return)</source>
        <translation>Continuar con la escena seleccionada (Intro)</translation>
    </message>
    <message>
        <source>Delete the selected scene for good (Del)</source>
        <translation>Eliminar para siempre la escena seleccionada (Supr)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Keep them all for later (Esc)</source>
        <translation>Conservarlas todas para más tarde (Esc)</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>dañada</translation>
    </message>
</context>
<context>
    <name>app::RecoveryPrompt</name>
    <message>
        <source>“%1: %2”</source>
        <translation>«%1: %2»</translation>
    </message>
    <message>
        <source>Springstep did not close normally. Your scene of %1 from %2 can be recovered.</source>
        <translation>Springstep no se cerró con normalidad. Se puede recuperar tu escena de %1 (%2).</translation>
    </message>
    <message>
        <source>Your scene of %1 from %2 was not saved. It can be recovered.</source>
        <translation>Tu escena de %1 (%2) no se guardó. Se puede recuperar.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Recuperar</translation>
    </message>
    <message>
        <source>Continue with this scene</source>
        <translation>Continuar con esta escena</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Eliminar</translation>
    </message>
    <message>
        <source>Delete this scene for good</source>
        <translation>Eliminar esta escena para siempre</translation>
    </message>
    <message>
        <source>Springstep did not close normally. %1 unsaved scenes can be recovered.</source>
        <translation>Springstep no se cerró con normalidad. Se pueden recuperar %1 escenas sin guardar.</translation>
    </message>
    <message>
        <source>%1 unsaved scenes can be recovered.</source>
        <translation>Se pueden recuperar %1 escenas sin guardar.</translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Mostrarlas</translation>
    </message>
    <message>
        <source>Shows a list, from which each can be recovered or deleted</source>
        <translation>Muestra una lista desde la que cada una se puede recuperar o eliminar</translation>
    </message>
    <message>
        <source>There is no scene to recover.</source>
        <translation>No hay ninguna escena que recuperar.</translation>
    </message>
</context>
<context>
    <name>app::RemedySearch</name>
    <message>
        <source>Computes the run again with this change, up to this frame. Your input is kept, and the old run stays as a ghost.</source>
        <translation>Calcula de nuevo la ejecución con este cambio, hasta este fotograma. Tus entradas se conservan, y la ejecución antigua queda como fantasma.</translation>
    </message>
    <message>
        <source>Not tested: that would take too long.</source>
        <translation>Sin probar: llevaría demasiado tiempo.</translation>
    </message>
    <message numerus="yes">
        <source>Tested: it is stable for %n frames.</source>
        <translation>
            <numerusform>Probado: es estable durante %n fotograma.</numerusform>
            <numerusform>Probado: es estable durante %n fotogramas.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::Restart</name>
    <message>
        <source>%1 A film is being made.</source>
        <translation>%1 Se está creando un vídeo.</translation>
    </message>
    <message>
        <source>%1 A web page is being made.</source>
        <translation>%1 Se está creando una página web.</translation>
    </message>
    <message>
        <source>Restart now</source>
        <translation>Reiniciar ahora</translation>
    </message>
    <message>
        <source>Cancels the film; everything else is kept</source>
        <translation>Cancela el vídeo; todo lo demás se conserva</translation>
    </message>
    <message>
        <source>Cancels the page; everything else is kept</source>
        <translation>Cancela la página; todo lo demás se conserva</translation>
    </message>
</context>
<context>
    <name>app::RulePanel</name>
    <message>
        <source>Delete rule</source>
        <translation>Eliminar la regla</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Activar</translation>
    </message>
    <message>
        <source>Let your rule act again, from frame 0 on</source>
        <translation>Haz que tu regla actúe de nuevo, desde el fotograma 0</translation>
    </message>
    <message>
        <source>Delete your rule and start over (Undo brings it back)</source>
        <translation>Eliminar tu regla y empezar de nuevo (Deshacer la recupera)</translation>
    </message>
    <message>
        <source>There is no rule yet.</source>
        <translation>Aún no hay ninguna regla.</translation>
    </message>
    <message>
        <source>No rule acts yet. Your code acts as soon as you stop typing.</source>
        <translation>Aún no actúa ninguna regla. Tu código actúa en cuanto dejas de escribir.</translation>
    </message>
    <message>
        <source>Your rule is switched off.</source>
        <translation>Tu regla está desactivada.</translation>
    </message>
    <message>
        <source>Your last rule without a mistake still acts.</source>
        <translation>Tu última regla sin errores sigue actuando.</translation>
    </message>
    <message>
        <source>force acts on every body.</source>
        <translation>force actúa sobre cada cuerpo.</translation>
    </message>
    <message>
        <source>pull acts along rule links, and there are none yet.</source>
        <translation>pull actúa a lo largo de las uniones de la regla, y aún no hay ninguna.</translation>
    </message>
    <message numerus="yes">
        <source>pull acts along %n rule links.</source>
        <translation>
            <numerusform>pull actúa a lo largo de %n unión de la regla.</numerusform>
            <numerusform>pull actúa a lo largo de %n uniones de la regla.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::RunCommands</name>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Reproducir o parar</translation>
    </message>
    <message>
        <source>Next &amp;frame</source>
        <translation>Fotograma &amp;siguiente</translation>
    </message>
    <message>
        <source>Frame &amp;back</source>
        <translation>Fotograma &amp;anterior</translation>
    </message>
    <message>
        <source>&amp;Next phase</source>
        <translation>&amp;Fase siguiente</translation>
    </message>
    <message>
        <source>P&amp;hase back</source>
        <translation>Fase an&amp;terior</translation>
    </message>
    <message>
        <source>Re&amp;start</source>
        <translation>R&amp;einiciar</translation>
    </message>
    <message>
        <source>Repea&amp;t the run with the same input</source>
        <translation>Re&amp;petir la ejecución con las mismas entradas</translation>
    </message>
    <message>
        <source>To th&amp;e last computed frame</source>
        <translation>Al ú&amp;ltimo fotograma calculado</translation>
    </message>
    <message>
        <source>Go to frame…</source>
        <translation>Ir al fotograma…</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>Más le&amp;nto</translation>
    </message>
    <message>
        <source>Faste&amp;r</source>
        <translation>Más rápi&amp;do</translation>
    </message>
    <message>
        <source>Reset run &amp;and parameters</source>
        <translation>Restablecer ejecución &amp;y parámetros</translation>
    </message>
    <message>
        <source>Delete the &amp;old run</source>
        <translation>Eliminar la ejecución anti&amp;gua</translation>
    </message>
    <message>
        <source>Choose another run…</source>
        <translation>Elegir otra ejecución…</translation>
    </message>
    <message>
        <source>&amp;Compare two runs</source>
        <translation>&amp;Comparar dos ejecuciones</translation>
    </message>
    <message>
        <source>Ne&amp;xt step</source>
        <translation>Paso s&amp;iguiente</translation>
    </message>
    <message>
        <source>Pre&amp;vious step</source>
        <translation>Paso anteri&amp;or</translation>
    </message>
    <message>
        <source>One phase forward</source>
        <translation>Una fase adelante</translation>
    </message>
    <message>
        <source>One phase back</source>
        <translation>Una fase atrás</translation>
    </message>
    <message>
        <source>Go to a frame</source>
        <translation>Ir a un fotograma</translation>
    </message>
    <message>
        <source>The distance between the two runs, frame by frame</source>
        <translation>La distancia entre las dos ejecuciones, fotograma a fotograma</translation>
    </message>
    <message>
        <source>This is frame 0, the first frame.</source>
        <translation>Este es el fotograma 0, el primero.</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Un fotograma atrás</translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation>Un fotograma adelante</translation>
    </message>
    <message>
        <source>Stop here</source>
        <translation>Parar aquí</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Reproducir</translation>
    </message>
    <message>
        <source>%1 repeats this run instead, with the same input.</source>
        <translation>%1, en cambio, repite esta ejecución con las mismas entradas.</translation>
    </message>
    <message>
        <source>Other runs: none yet</source>
        <translation>Otras ejecuciones: aún ninguna</translation>
    </message>
    <message>
        <source>Other runs: one</source>
        <translation>Otras ejecuciones: una</translation>
    </message>
    <message>
        <source>Other runs: %1</source>
        <translation>Otras ejecuciones: %1</translation>
    </message>
    <message>
        <source>To the start of this frame</source>
        <translation>Al inicio de este fotograma</translation>
    </message>
    <message>
        <source>To the end of this frame</source>
        <translation>Al final de este fotograma</translation>
    </message>
    <message>
        <source>Starts a new run from frame 0, with the current parameters.</source>
        <translation>Empieza una ejecución nueva desde el fotograma 0, con los parámetros actuales.</translation>
    </message>
    <message>
        <source>Go back in time and change something: the old run then appears here.</source>
        <translation>Retrocede en el tiempo y cambia algo: entonces la ejecución antigua aparece aquí.</translation>
    </message>
    <message>
        <source>Step over calls</source>
        <translation>Saltar las llamadas</translation>
    </message>
    <message>
        <source>Step out of the call</source>
        <translation>Salir de la llamada</translation>
    </message>
    <message>
        <source>Run the next line with all functions that it calls</source>
        <translation>Ejecutar la línea siguiente con todas las funciones a las que llama</translation>
    </message>
    <message>
        <source>Run to the end of the function, or of the frame</source>
        <translation>Ejecutar hasta el final de la función, o del fotograma</translation>
    </message>
    <message>
        <source>&amp;Next line</source>
        <translation>Línea sig&amp;uiente</translation>
    </message>
    <message>
        <source>One line forward</source>
        <translation>Una línea adelante</translation>
    </message>
    <message>
        <source>Line bac&amp;k</source>
        <translation>Línea an&amp;terior</translation>
    </message>
    <message>
        <source>One line back</source>
        <translation>Una línea atrás</translation>
    </message>
    <message>
        <source>Open the Listing page of the code to go line by line.</source>
        <translation>Abre la página Listado del código para ir línea a línea.</translation>
    </message>
</context>
<context>
    <name>app::RunEditor</name>
    <message>
        <source>The old run stays beside this one as “%1”.</source>
        <translation>La ejecución antigua se queda junto a esta como «%1».</translation>
    </message>
    <message>
        <source>Choose “%1”</source>
        <translation>Elegir «%1»</translation>
    </message>
    <message>
        <source>Reset run and parameters</source>
        <translation>Restablecer ejecución y parámetros</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Reiniciar</translation>
    </message>
    <message>
        <source>the restart</source>
        <translation>el reinicio</translation>
    </message>
    <message>
        <source>A new run. The old one is in “Runs”; Undo brings it back.</source>
        <translation>Una ejecución nueva. La antigua está en «Ejecuciones»; Deshacer la recupera.</translation>
    </message>
    <message>
        <source>the first run</source>
        <translation>la primera ejecución</translation>
    </message>
    <message>
        <source>Go back to “%1”</source>
        <translation>Volver a «%1»</translation>
    </message>
    <message>
        <source>“%1” is the current run again. The run that you left is now in “Runs”.</source>
        <translation>«%1» vuelve a ser la ejecución actual. La que has dejado está ahora en «Ejecuciones».</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>Deshecho: %1.</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>Rehecho: %1.</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Cambiar %1</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>Restablecer todos los parámetros</translation>
    </message>
    <message>
        <source>Change step</source>
        <translation>Cambiar el paso de tiempo</translation>
    </message>
    <message>
        <source>Change method</source>
        <translation>Cambiar el método</translation>
    </message>
    <message>
        <source>Apply remedy</source>
        <translation>Aplicar un remedio</translation>
    </message>
    <message>
        <source>a remedy</source>
        <translation>un remedio</translation>
    </message>
    <message>
        <source>%1 off</source>
        <translation>%1: desactivado</translation>
    </message>
    <message>
        <source>%1 on</source>
        <translation>%1: activado</translation>
    </message>
</context>
<context>
    <name>app::RunPlot</name>
    <message>
        <source>Error over the run</source>
        <translation>Error en la ejecución</translation>
    </message>
    <message>
        <source>error, px</source>
        <translation>error, px</translation>
    </message>
    <message>
        <source>Frame %1: error %2</source>
        <translation>Fotograma %1: error %2</translation>
    </message>
</context>
<context>
    <name>app::RunsMenu</name>
    <message>
        <source>Other r&amp;uns</source>
        <translation>Otras e&amp;jecuciones</translation>
    </message>
    <message>
        <source>No other run yet</source>
        <translation>Aún no hay otra ejecución</translation>
    </message>
    <message>
        <source>Go back in time and change something: the old run then stays as another run.</source>
        <translation>Retrocede en el tiempo y cambia algo: entonces la ejecución antigua queda como otra ejecución.</translation>
    </message>
    <message>
        <source>&amp;Hide the other run</source>
        <translation>&amp;Ocultar la otra ejecución</translation>
    </message>
    <message>
        <source>Shows only this run; the others stay in this menu</source>
        <translation>Muestra solo esta ejecución; las demás se quedan en este menú</translation>
    </message>
    <message>
        <source>&amp;Compare in numbers</source>
        <translation>&amp;Comparar en números</translation>
    </message>
    <message>
        <source>The distance between the two runs, frame by frame</source>
        <translation>La distancia entre las dos ejecuciones, fotograma a fotograma</translation>
    </message>
    <message>
        <source>&amp;Show beside</source>
        <translation>&amp;Mostrar al lado</translation>
    </message>
    <message>
        <source>As a ghost in the picture, and as dots in the timeline</source>
        <translation>Como fantasma en la imagen y como puntos en la línea de tiempo</translation>
    </message>
    <message>
        <source>&amp;Go back to it</source>
        <translation>&amp;Volver a ella</translation>
    </message>
    <message>
        <source>Makes it the current run again, exactly as it was; this run becomes another run</source>
        <translation>La convierte otra vez en la ejecución actual, tal como era; esta pasa a ser otra ejecución</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>Co&amp;nservar</translation>
    </message>
    <message>
        <source>Keeps this run until you delete it. Of the other runs, only the last %1 stay.</source>
        <translation>Conserva esta ejecución hasta que la elimines. De las demás solo quedan las últimas %1.</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Renombrar…</translation>
    </message>
    <message>
        <source>Give this run another name</source>
        <translation>Dar otro nombre a esta ejecución</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Eliminar</translation>
    </message>
    <message>
        <source>Deletes this run; Undo brings it back</source>
        <translation>Elimina esta ejecución; Deshacer la recupera</translation>
    </message>
</context>
<context>
    <name>app::SandboxCommands</name>
    <message>
        <source>&amp;Take this scene to the sandbox</source>
        <translation>&amp;Llevar esta escena al taller</translation>
    </message>
    <message>
        <source>&amp;Delete selection</source>
        <translation>&amp;Eliminar la selección</translation>
    </message>
    <message>
        <source>Dup&amp;licate selection</source>
        <translation>D&amp;uplicar la selección</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>Seleccionar &amp;todo</translation>
    </message>
    <message>
        <source>Continue building this scene in the sandbox</source>
        <translation>Seguir construyendo esta escena en el taller</translation>
    </message>
    <message>
        <source>Select and move parts</source>
        <translation>Seleccionar y mover piezas</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Selección</translation>
    </message>
    <message>
        <source>Add points</source>
        <translation>Añadir puntos</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punto</translation>
    </message>
    <message>
        <source>Add a body with a mass and a size</source>
        <translation>Añadir un cuerpo con masa y tamaño</translation>
    </message>
    <message>
        <source>Nail points down</source>
        <translation>Clavar puntos</translation>
    </message>
    <message>
        <source>Nail</source>
        <translation>Clavo</translation>
    </message>
    <message>
        <source>Fix a point in place, or free it</source>
        <translation>Fijar un punto en su lugar, o soltarlo</translation>
    </message>
    <message>
        <source>Add springs</source>
        <translation>Añadir muelles</translation>
    </message>
    <message>
        <source>Spring</source>
        <translation>Muelle</translation>
    </message>
    <message>
        <source>Connect two points with a spring, which pulls and pushes them to its length</source>
        <translation>Unir dos puntos con un muelle, que tira de ellos y los empuja hasta su longitud</translation>
    </message>
    <message>
        <source>Add sticks</source>
        <translation>Añadir barras</translation>
    </message>
    <message>
        <source>Stick</source>
        <translation>Barra</translation>
    </message>
    <message>
        <source>Connect two points with a stick, which keeps its length</source>
        <translation>Unir dos puntos con una barra, que mantiene su longitud</translation>
    </message>
    <message>
        <source>Add feet</source>
        <translation>Añadir pies</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Pie</translation>
    </message>
    <message>
        <source>Give a body a foot, at an angle from the body</source>
        <translation>Dar un pie a un cuerpo, en un ángulo visto desde el cuerpo</translation>
    </message>
    <message>
        <source>The sandbox is not installed</source>
        <translation>El taller no está instalado</translation>
    </message>
    <message>
        <source>This scene is already in the sandbox</source>
        <translation>Esta escena ya está en el taller</translation>
    </message>
    <message>
        <source>Select parts, and drag them to another place</source>
        <translation>Seleccionar piezas y arrastrarlas a otro lugar</translation>
    </message>
    <message>
        <source>&amp;My rule</source>
        <translation>Mi re&amp;gla</translation>
    </message>
    <message>
        <source>My rule</source>
        <translation>Mi regla</translation>
    </message>
    <message>
        <source>Write a force of your own for this scene</source>
        <translation>Escribe una fuerza propia para esta escena</translation>
    </message>
    <message>
        <source>Lin&amp;k selection by my rule</source>
        <translation>Unir la &amp;selección con mi regla</translation>
    </message>
    <message>
        <source>Link all</source>
        <translation>Unir todos</translation>
    </message>
    <message>
        <source>Add a rule link between each two of the selected points</source>
        <translation>Añadir una unión de la regla entre cada dos de los puntos seleccionados</translation>
    </message>
    <message>
        <source>Add rule links</source>
        <translation>Añadir uniones de la regla</translation>
    </message>
    <message>
        <source>Rule link</source>
        <translation>Unión</translation>
    </message>
    <message>
        <source>Connect two points by the function pull of your rule</source>
        <translation>Unir dos puntos mediante la función pull de tu regla</translation>
    </message>
</context>
<context>
    <name>app::SandboxEditor</name>
    <message>
        <source>The scene has too many of this kind. Delete some first.</source>
        <translation>La escena tiene demasiadas piezas de este tipo. Elimina antes algunas.</translation>
    </message>
    <message>
        <source>This point is already a foot, and a point can be the foot of only one body. Choose another point.</source>
        <translation>Este punto ya es un pie, y un punto solo puede ser el pie de un cuerpo. Elige otro punto.</translation>
    </message>
    <message>
        <source>A scene needs at least one point that can move. Leave one free.</source>
        <translation>Una escena necesita al menos un punto que se pueda mover. Deja uno libre.</translation>
    </message>
    <message>
        <source>With this copy, the scene would have too many parts. Select fewer parts, or delete some first.</source>
        <translation>Con esta copia, la escena tendría demasiadas piezas. Selecciona menos piezas, o elimina antes algunas.</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 piezas</translation>
    </message>
    <message>
        <source>stick</source>
        <translation>barra</translation>
    </message>
    <message>
        <source>spring</source>
        <translation>muelle</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Añadir un punto</translation>
    </message>
    <message>
        <source>Add nail</source>
        <translation>Añadir un clavo</translation>
    </message>
    <message>
        <source>Free %1</source>
        <translation>Soltar %1</translation>
    </message>
    <message>
        <source>Nail %1 down</source>
        <translation>Clavar %1</translation>
    </message>
    <message>
        <source>Add spring</source>
        <translation>Añadir un muelle</translation>
    </message>
    <message>
        <source>Add stick</source>
        <translation>Añadir una barra</translation>
    </message>
    <message>
        <source>Add foot</source>
        <translation>Añadir un pie</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Mover %1</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Eliminar %1</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Duplicar %1</translation>
    </message>
    <message>
        <source>Add gait group</source>
        <translation>Añadir un grupo de marcha</translation>
    </message>
    <message>
        <source>rule link</source>
        <translation>unión de la regla</translation>
    </message>
    <message>
        <source>Add rule link</source>
        <translation>Añadir una unión de la regla</translation>
    </message>
    <message>
        <source>These two points have a rule link already, and the rule acts once along it.</source>
        <translation>Estos dos puntos ya tienen una unión de la regla, y la regla actúa una vez a lo largo de ella.</translation>
    </message>
    <message>
        <source>Select at least two points first: draw a box around them.</source>
        <translation>Selecciona antes al menos dos puntos: dibuja un recuadro alrededor de ellos.</translation>
    </message>
    <message>
        <source>Link %1 by the rule</source>
        <translation>Unir %1 con la regla</translation>
    </message>
    <message>
        <source>All of these points have rule links already.</source>
        <translation>Todos estos puntos ya tienen uniones de la regla.</translation>
    </message>
    <message>
        <source>“%1” is a parameter. Choose another name, such as “%1_1”.</source>
        <translation>«%1» es un parámetro. Elige otro nombre, por ejemplo «%1_1».</translation>
    </message>
    <message>
        <source>Another point is called “%1”. Choose another name.</source>
        <translation>Otro punto ya se llama «%1». Elige otro nombre.</translation>
    </message>
    <message>
        <source>Your code computes this run, and it names the points. Choose another method first.</source>
        <translation>Esta ejecución la calcula tu código, y nombra los puntos. Elige antes otro método.</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>Cambiar el nombre de %1 a %2</translation>
    </message>
</context>
<context>
    <name>app::SceneBar</name>
    <message>
        <source>How the run is computed from one step to the next</source>
        <translation>Cómo se calcula la ejecución de un paso de tiempo al siguiente</translation>
    </message>
    <message>
        <source>How much time one step of the method covers</source>
        <translation>Cuánto tiempo abarca un paso de tiempo del método</translation>
    </message>
    <message>
        <source>Choose what the picture shows besides the creature</source>
        <translation>Elegir qué muestra la imagen además de la criatura</translation>
    </message>
    <message>
        <source>Zoom to 100&#x2009;%</source>
        <translation>Zoom al 100 %</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Mostrar</translation>
    </message>
    <message>
        <source>Trails</source>
        <translation>Estelas</translation>
    </message>
    <message>
        <source>Velocity arrows</source>
        <translation>Flechas de velocidad</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Rejilla</translation>
    </message>
    <message>
        <source>Guide lines</source>
        <translation>Líneas guía</translation>
    </message>
    <message>
        <source>Eyes</source>
        <translation>Ojos</translation>
    </message>
    <message>
        <source>Ghost</source>
        <translation>Fantasma</translation>
    </message>
    <message>
        <source>Onion skins</source>
        <translation>Papel cebolla</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Referencia</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Método</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolerancia</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Paso de tiempo</translation>
    </message>
    <message>
        <source>%1&#x2009;%</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Zoom %1</source>
        <translation>Zoom %1</translation>
    </message>
    <message>
        <source>All pulls</source>
        <translation>Todos los tirones</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>Regla graduada</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Reloj</translation>
    </message>
    <message>
        <source>Rest lengths</source>
        <translation>Longitudes naturales</translation>
    </message>
    <message>
        <source>The largest error that the method allows in each of its steps</source>
        <translation>El error máximo que el método permite en cada uno de sus pasos de tiempo</translation>
    </message>
    <message>
        <source>Your code</source>
        <translation>Tu código</translation>
    </message>
    <message>
        <source>The listing, as you changed it</source>
        <translation>El listado, tal como lo has cambiado</translation>
    </message>
    <message>
        <source>This step has no listing.</source>
        <translation>Este paso no tiene listado.</translation>
    </message>
    <message>
        <source>Unit circle</source>
        <translation>Circunferencia unidad</translation>
    </message>
</context>
<context>
    <name>app::SceneCard</name>
    <message>
        <source>Done! You have tried everything here. %1 opens the next step.</source>
        <translation>¡Hecho! Has probado todo lo de aquí. %1 abre el paso siguiente.</translation>
    </message>
    <message>
        <source>Done! You have tried everything here.</source>
        <translation>¡Hecho! Has probado todo lo de aquí.</translation>
    </message>
</context>
<context>
    <name>app::SceneView</name>
    <message>
        <source>%1: outside of the picture. Click, or press O, to bring it into view.</source>
        <translation>%1: fuera de la imagen. Haz clic, o pulsa O, para traerlo a la vista.</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Escena</translation>
    </message>
    <message>
        <source>Beside it: %1</source>
        <translation>Al lado: %1</translation>
    </message>
    <message>
        <source>frame %1 = %2&#x2009;s</source>
        <translation>fotograma %1 = %2 s</translation>
    </message>
    <message>
        <source>The hand of the recorded run is at %1, %2</source>
        <translation>La mano de la ejecución grabada está en %1, %2</translation>
    </message>
    <message>
        <source>Preview. %1</source>
        <translation>Vista previa. %1</translation>
    </message>
    <message>
        <source>Preview of frame %1.</source>
        <translation>Vista previa del fotograma %1.</translation>
    </message>
    <message>
        <source>The formula is about: %1</source>
        <translation>La fórmula trata de: %1</translation>
    </message>
</context>
<context>
    <name>app::SettlingMonitor</name>
    <message>
        <source>Change %1 and %2</source>
        <translation>Cambiar %1 y %2</translation>
    </message>
</context>
<context>
    <name>app::SettlingPlot</name>
    <message>
        <source>Map of the time to rest</source>
        <translation>Mapa del tiempo hasta el reposo</translation>
    </message>
    <message numerus="yes">
        <source>at rest after %n frames</source>
        <translation>
            <numerusform>en reposo tras %n fotograma</numerusform>
            <numerusform>en reposo tras %n fotogramas</numerusform>
        </translation>
    </message>
    <message>
        <source>still moving after %1 frames</source>
        <translation>aún se mueve tras %1 fotogramas</translation>
    </message>
    <message>
        <source>the motion grows without bound</source>
        <translation>el movimiento crece sin límite</translation>
    </message>
    <message>
        <source>cannot be computed</source>
        <translation>no se puede calcular</translation>
    </message>
    <message>
        <source>Click or press Enter to begin the run again with %1 %2 and %3 %4</source>
        <translation>Haz clic o pulsa Intro para empezar de nuevo la ejecución con %1 %2 y %3 %4</translation>
    </message>
    <message>
        <source>Your run from its start, with all you did: how many frames after frame %1, your last input, it is at rest.</source>
        <translation>Tu ejecución desde el inicio, con todo lo que hiciste: cuántos fotogramas después del fotograma %1, tu última entrada, queda en reposo.</translation>
    </message>
    <message>
        <source>Your run from its start: after how many frames it is at rest.</source>
        <translation>Tu ejecución desde el inicio: tras cuántos fotogramas queda en reposo.</translation>
    </message>
    <message>
        <source>At rest, each body stays within 1&#x2009;px of its last place, and moves less than 0.05&#x2009;px in a frame.</source>
        <translation>En reposo, cada cuerpo se queda a menos de 1 px de su último lugar y se mueve menos de 0,05 px por fotograma.</translation>
    </message>
    <message>
        <source>Input after frame %1 is left out.</source>
        <translation>No se incluyen las entradas posteriores al fotograma %1.</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 fotogramas</translation>
    </message>
    <message>
        <source>still moving</source>
        <translation>aún se mueve</translation>
    </message>
    <message>
        <source>grows</source>
        <translation>crece</translation>
    </message>
</context>
<context>
    <name>app::SizeMenu</name>
    <message>
        <source>Si&amp;ze of text and controls</source>
        <translation>Tamaño del texto &amp;y los controles</translation>
    </message>
    <message>
        <source>%1&#x2009;%</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Changes text, buttons and the scene. The window opens again with all its contents</source>
        <translation>Cambia el texto, los botones y la escena. La ventana se abre de nuevo con todo su contenido</translation>
    </message>
    <message>
        <source>At that size, this screen is too small for the scene and its timeline</source>
        <translation>Con ese tamaño, esta pantalla es demasiado pequeña para la escena y su línea de tiempo</translation>
    </message>
    <message>
        <source>Springstep will be drawn at %1&#x2009;% after a restart.</source>
        <translation>Springstep se dibujará al %1 % al reiniciarse.</translation>
    </message>
</context>
<context>
    <name>app::SpeedButton</name>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Playing speed %1, %2</source>
        <translation>Velocidad de reproducción %1, %2</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 fot./s</translation>
    </message>
</context>
<context>
    <name>app::StabilityGauge</name>
    <message>
        <source>Stability</source>
        <translation>Estabilidad</translation>
    </message>
    <message>
        <source>Click for the reasons and the remedies</source>
        <translation>Haz clic para ver las razones y los remedios</translation>
    </message>
    <message>
        <source>%1&#x2009;% of the limit</source>
        <translation>%1 % del límite</translation>
    </message>
    <message>
        <source>Preview of frame %1: %2</source>
        <translation>Vista previa del fotograma %1: %2</translation>
    </message>
</context>
<context>
    <name>app::StabilityPanel</name>
    <message>
        <source>Stability</source>
        <translation>Estabilidad</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Cerrar</translation>
    </message>
    <message>
        <source>Close, and show the previous panel</source>
        <translation>Cerrar y mostrar el panel anterior</translation>
    </message>
    <message>
        <source>Remedies</source>
        <translation>Remedios</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Mapa</translation>
    </message>
    <message>
        <source>k and step</source>
        <translation>k y paso de tiempo</translation>
    </message>
    <message>
        <source>Shows which stiffness and step are stable, with everything else unchanged. Click again to close</source>
        <translation>Muestra qué rigidez y qué paso de tiempo son estables, sin cambiar nada más. Haz clic otra vez para cerrar</translation>
    </message>
    <message>
        <source>k and damping</source>
        <translation>k y amortiguación</translation>
    </message>
    <message>
        <source>Shows which stiffness and damping are stable, with everything else unchanged. Click again to close</source>
        <translation>Muestra qué rigidez y qué amortiguación son estables, sin cambiar nada más. Haz clic otra vez para cerrar</translation>
    </message>
    <message>
        <source>There is no map for this step: it has no stiffness k to change.</source>
        <translation>No hay mapa para este paso: no tiene ninguna rigidez k que cambiar.</translation>
    </message>
    <message>
        <source>There is no map here: no springs act, so every stiffness and every step is stable.</source>
        <translation>Aquí no hay mapa: no actúa ningún muelle, así que toda rigidez y todo paso de tiempo son estables.</translation>
    </message>
    <message>
        <source>There is no map for this method: it is stable at every stiffness.</source>
        <translation>No hay mapa para este método: es estable con cualquier rigidez.</translation>
    </message>
    <message>
        <source>There is no map for your code: it may compute anything, whatever the stiffness is.</source>
        <translation>No hay mapa para tu código: puede calcular cualquier cosa, sea cual sea la rigidez.</translation>
    </message>
    <message>
        <source>Time to rest</source>
        <translation>Reposo</translation>
    </message>
    <message>
        <source>Shows how many frames the run takes to come to rest, for each stiffness and damping. Click again to close</source>
        <translation>Muestra cuántos fotogramas tarda la ejecución en quedar en reposo, para cada rigidez y amortiguación. Haz clic otra vez para cerrar</translation>
    </message>
    <message>
        <source>There is no map of the time to rest for this step: it needs the stiffness k, a damping, and at most %1 points.</source>
        <translation>No hay mapa del tiempo hasta el reposo para este paso: necesita la rigidez k, una amortiguación y %1 puntos como máximo.</translation>
    </message>
</context>
<context>
    <name>app::StatusFigures</name>
    <message>
        <source>How many points the scene has: each body, foot or joint is one</source>
        <translation>Cuántos puntos tiene la escena: cada cuerpo, pie o articulación es uno</translation>
    </message>
    <message>
        <source>How often a frame computes all forces. The cost of a frame depends on this</source>
        <translation>Cuántas veces calcula un fotograma todas las fuerzas. El coste de un fotograma depende de esto</translation>
    </message>
    <message>
        <source>The time to compute a frame of this scene on this machine (the median of many runs)</source>
        <translation>El tiempo para calcular un fotograma de esta escena en este equipo (mediana de muchas ejecuciones)</translation>
    </message>
    <message>
        <source>The largest distance of any body from the exact motion, over these frames</source>
        <translation>La mayor distancia de un cuerpo al movimiento exacto, en estos fotogramas</translation>
    </message>
    <message>
        <source>%1 a frame</source>
        <translation>%1/fotograma</translation>
    </message>
    <message>
        <source>error %1 over %2 frames</source>
        <translation>error %1 en %2 fotogramas</translation>
    </message>
    <message>
        <source>forces once a frame</source>
        <translation>fuerzas 1 vez/fot.</translation>
    </message>
    <message>
        <source>forces %1 times a frame</source>
        <translation>fuerzas %1 veces/fot.</translation>
    </message>
    <message>
        <source>forces %1 times a frame so far</source>
        <translation>fuerzas %1 veces/fot. por ahora</translation>
    </message>
</context>
<context>
    <name>app::StatusLine</name>
    <message>
        <source>Preview inside frame %1. The run does not move.</source>
        <translation>Vista previa dentro del fotograma %1. La ejecución no se mueve.</translation>
    </message>
    <message>
        <source>Preview of frame %1. The run stays at frame %2.</source>
        <translation>Vista previa del fotograma %1. La ejecución sigue en el fotograma %2.</translation>
    </message>
    <message>
        <source>Everything is at rest. Touch something, or press &lt;b&gt;%1&lt;/b&gt; to stop.</source>
        <translation>Todo está en reposo. Toca algo, o pulsa &lt;b&gt;%1&lt;/b&gt; para parar.</translation>
    </message>
    <message>
        <source>Playing. Press &lt;b&gt;%1&lt;/b&gt; to stop anywhere.</source>
        <translation>Reproduciendo. Pulsa &lt;b&gt;%1&lt;/b&gt; para parar donde sea.</translation>
    </message>
    <message>
        <source>Inside frame %1, after %2. &lt;b&gt;%3&lt;/b&gt; next phase, &lt;b&gt;%4&lt;/b&gt; next frame.</source>
        <translation>Dentro del fotograma %1, tras «%2». &lt;b&gt;%3&lt;/b&gt; fase siguiente, &lt;b&gt;%4&lt;/b&gt; fotograma siguiente.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; plays, &lt;b&gt;%2&lt;/b&gt; next frame, &lt;b&gt;%3&lt;/b&gt; into the frame. Drag anything.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt; reproduce, &lt;b&gt;%2&lt;/b&gt; fotograma siguiente, &lt;b&gt;%3&lt;/b&gt; entra en el fotograma. Arrastra lo que quieras.</translation>
    </message>
</context>
<context>
    <name>app::StepMenu</name>
    <message>
        <source>Other:</source>
        <translation>Otro:</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>fotogramas</translation>
    </message>
    <message>
        <source>From 1e-13 to 100 px; press Enter to apply</source>
        <translation>De 1e-13 a 100 px; pulsa Intro para aplicar</translation>
    </message>
    <message>
        <source>A whole number of frames, or 1 divided by a whole number; press Enter to apply</source>
        <translation>Un número entero de fotogramas, o 1 dividido entre un número entero; pulsa Intro para aplicar</translation>
    </message>
    <message>
        <source>Other tolerance, in px</source>
        <translation>Otra tolerancia, en px</translation>
    </message>
    <message>
        <source>Other step, in frames</source>
        <translation>Otro paso de tiempo, en fotogramas</translation>
    </message>
</context>
<context>
    <name>app::StudyPlot</name>
    <message>
        <source>Points: %1. The arrow keys go through them, and Enter uses one.</source>
        <translation>Puntos: %1. Las flechas los recorren, e Intro usa uno.</translation>
    </message>
    <message>
        <source>← more accurate</source>
        <translation>← más preciso</translation>
    </message>
    <message>
        <source>largest error, px</source>
        <translation>error máximo, px</translation>
    </message>
</context>
<context>
    <name>app::SummaryPage</name>
    <message>
        <source>Back to the step</source>
        <translation>Volver al paso</translation>
    </message>
    <message>
        <source>%1: what you learnt</source>
        <translation>%1: lo que has aprendido</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Siguiente: %1</translation>
    </message>
    <message>
        <source>The last lesson</source>
        <translation>La última lección</translation>
    </message>
    <message>
        <source>No lesson comes after this one.</source>
        <translation>No hay ninguna lección después de esta.</translation>
    </message>
    <message>
        <source>Restore the ticks</source>
        <translation>Recuperar las marcas</translation>
    </message>
    <message>
        <source>Restart this lesson</source>
        <translation>Reiniciar la lección</translation>
    </message>
    <message>
        <source>Ticks everything again that you had done before</source>
        <translation>Vuelve a marcar todo lo que ya habías hecho</translation>
    </message>
    <message>
        <source>Removes the ticks of this lesson. You can restore them.</source>
        <translation>Quita las marcas de esta lección. Puedes recuperarlas.</translation>
    </message>
    <message>
        <source>Nothing is ticked in this lesson yet.</source>
        <translation>Aún no hay nada marcado en esta lección.</translation>
    </message>
    <message>
        <source>%1 of %2 things tried.</source>
        <translation>%1 de %2 pruebas hechas.</translation>
    </message>
    <message>
        <source>Still to try: %1</source>
        <translation>Queda por probar: %1</translation>
    </message>
    <message>
        <source>**Next: %1.** %2</source>
        <translation>**Siguiente: %1.** %2</translation>
    </message>
    <message>
        <source>%1 of %2 tasks written in the listing.</source>
        <translation>%1 de %2 tareas escritas en el listado.</translation>
    </message>
    <message>
        <source>Still to write: %1</source>
        <translation>Queda por escribir: %1</translation>
    </message>
    <message>
        <source>Predicted: %1 %2</source>
        <translation>Predicho: %1 %2</translation>
    </message>
    <message>
        <source>%1 of %2 levels of the project passed.</source>
        <translation>%1 de %2 niveles del proyecto superados.</translation>
    </message>
    <message>
        <source>**Project: %1**</source>
        <translation>**Proyecto: %1**</translation>
    </message>
    <message>
        <source>Still to pass: %1</source>
        <translation>Queda por superar: %1</translation>
    </message>
</context>
<context>
    <name>app::TaskBox</name>
    <message>
        <source>Write it yourself</source>
        <translation>Escríbelo tú</translation>
    </message>
    <message>
        <source>Empties the place in the listing, so that you can write it</source>
        <translation>Vacía el lugar en el listado, para que lo escribas tú</translation>
    </message>
    <message>
        <source>Shows the next hint</source>
        <translation>Muestra la pista siguiente</translation>
    </message>
    <message>
        <source>Solution</source>
        <translation>Solución</translation>
    </message>
    <message>
        <source>Writes the solution into the listing</source>
        <translation>Escribe la solución en el listado</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Parar</translation>
    </message>
    <message>
        <source>Stops this task. Your code stays.</source>
        <translation>Detiene esta tarea. Tu código se queda.</translation>
    </message>
    <message>
        <source>%1, done</source>
        <translation>%1, hecha</translation>
    </message>
    <message>
        <source>Write it again</source>
        <translation>Escribirlo otra vez</translation>
    </message>
    <message>
        <source>Hint %1 of %2</source>
        <translation>Pista %1 de %2</translation>
    </message>
</context>
<context>
    <name>app::TaskDesk</name>
    <message>
        <source>This is the solution. To get the tick, start again and write it yourself.</source>
        <translation>Esta es la solución. Para conseguir la marca, empieza de nuevo y escríbela tú.</translation>
    </message>
    <message>
        <source>Trying your code …</source>
        <translation>Probando tu código…</translation>
    </message>
</context>
<context>
    <name>app::TimelineStrip</name>
    <message>
        <source>%1: phase %2 of %3. Click to run to it.</source>
        <translation>%1: fase %2 de %3. Haz clic para ejecutar hasta ella.</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Línea de tiempo</translation>
    </message>
    <message>
        <source>%1 other runs branch off from this one at frame %2. Click to choose one.</source>
        <translation>%1 ejecuciones más se separan de esta en el fotograma %2. Haz clic para elegir una.</translation>
    </message>
    <message>
        <source>Another run: %1. Click to show it beside this one, right-click for more.</source>
        <translation>Otra ejecución: %1. Haz clic para mostrarla junto a esta, clic derecho para más.</translation>
    </message>
    <message>
        <source>Beside this run: %1. Right-click for more.</source>
        <translation>Junto a esta ejecución: %1. Clic derecho para más.</translation>
    </message>
    <message>
        <source>Left and Right: one frame. With Shift: one phase. Home: restart. With Shift: repeat the run. End: the last computed frame. Menu: the other runs.</source>
        <translation>Izquierda y Derecha: un fotograma. Con Mayús: una fase. Inicio: reiniciar. Con Mayús: repetir la ejecución. Fin: el último fotograma calculado. Menú: las otras ejecuciones.</translation>
    </message>
    <message>
        <source>%1. Preview: %2</source>
        <translation>%1. Vista previa: %2</translation>
    </message>
    <message>
        <source>Line %1, %2 of %3: %4
Click to run to it.</source>
        <translation>Línea %1, %2 de %3: %4
Haz clic para ejecutar hasta ella.</translation>
    </message>
</context>
<context>
    <name>app::Tour</name>
    <message>
        <source>Skip</source>
        <translation>Omitir</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Atrás</translation>
    </message>
    <message>
        <source>Ends the tour (Esc). It is in the Help menu.</source>
        <translation>Termina la visita guiada (Esc). Está en el menú Ayuda.</translation>
    </message>
    <message>
        <source>The previous card</source>
        <translation>La tarjeta anterior</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Listo</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Siguiente</translation>
    </message>
    <message>
        <source>Ends the tour (Enter)</source>
        <translation>Termina la visita guiada (Intro)</translation>
    </message>
    <message>
        <source>The next card (Enter)</source>
        <translation>La tarjeta siguiente (Intro)</translation>
    </message>
    <message>
        <source>The picture</source>
        <translation>La imagen</translation>
    </message>
    <message>
        <source>This is the scene of the lesson. Drag anything in it. Let go while moving to throw it.</source>
        <translation>Esta es la escena de la lección. Arrastra lo que quieras. Suéltalo en movimiento para lanzarlo.</translation>
    </message>
    <message>
        <source>Play and stop</source>
        <translation>Reproducir y parar</translation>
    </message>
    <message>
        <source>**%1** plays and stops the run. **%2** goes one frame forward, **%3** one frame back.</source>
        <translation>**%1** reproduce y para la ejecución. **%2** avanza un fotograma, **%3** retrocede uno.</translation>
    </message>
    <message>
        <source>The whole run is kept</source>
        <translation>Se conserva toda la ejecución</translation>
    </message>
    <message>
        <source>Drag here to go back in time. Change something there, and the old run stays as a ghost.</source>
        <translation>Arrastra aquí para retroceder en el tiempo. Cambia algo allí, y la ejecución antigua queda como fantasma.</translation>
    </message>
    <message>
        <source>Inside a frame</source>
        <translation>Dentro de un fotograma</translation>
    </message>
    <message>
        <source>**%1** runs one line of the code, and **%2** takes it back. On the code&apos;s page **Engine** they go from phase to phase: springs pull, damping slows things down, things move.</source>
        <translation>**%1** ejecuta una línea del código, y **%2** la deshace. En la página **Motor de cálculo** del código van de fase en fase: los muelles tiran, la amortiguación frena las cosas, las cosas se mueven.</translation>
    </message>
    <message>
        <source>The code that runs</source>
        <translation>El código que se ejecuta</translation>
    </message>
    <message>
        <source>Numbers to change</source>
        <translation>Números que cambiar</translation>
    </message>
    <message>
        <source>Move a slider, or type any number. The arrow beside it resets the number.</source>
        <translation>Mueve un deslizador, o escribe cualquier número. La flecha de al lado lo restablece.</translation>
    </message>
    <message>
        <source>Try this</source>
        <translation>Prueba esto</translation>
    </message>
    <message>
        <source>Springstep ticks each task when it sees you do it. Click a lamp for a hint, or a dotted word for its meaning.</source>
        <translation>Springstep marca cada prueba cuando ve que la haces. Haz clic en una bombilla para ver una pista, o en una palabra punteada para ver su significado.</translation>
    </message>
    <message>
        <source>These lines compute the scene. Beside them are the current values. Change a line, and the picture follows.</source>
        <translation>Estas líneas calculan la escena. Al lado están los valores actuales. Cambia una línea, y la imagen la sigue.</translation>
    </message>
</context>
<context>
    <name>app::TransportBar</name>
    <message>
        <source>going to %1… %2 stops</source>
        <translation>yendo a %1… %2: parar</translation>
    </message>
    <message>
        <source>going to %1…</source>
        <translation>yendo a %1…</translation>
    </message>
    <message>
        <source>· %1</source>
        <translation>· %1</translation>
    </message>
    <message>
        <source>· at %1</source>
        <translation>· en %1</translation>
    </message>
    <message>
        <source>Playing speed (%1 and %2). It never changes the step</source>
        <translation>Velocidad de reproducción (%1 y %2). Nunca cambia el paso de tiempo</translation>
    </message>
    <message>
        <source>· preview: %1</source>
        <translation>· vista previa: %1</translation>
    </message>
    <message>
        <source>· preview of frame %1</source>
        <translation>· vista previa del fotograma %1</translation>
    </message>
</context>
<context>
    <name>app::TryBox</name>
    <message>
        <source>Hint: %1</source>
        <translation>Pista: %1</translation>
    </message>
    <message>
        <source>Hide the hint</source>
        <translation>Ocultar la pista</translation>
    </message>
    <message>
        <source>Show a hint (H)</source>
        <translation>Mostrar una pista (H)</translation>
    </message>
    <message>
        <source>Hide the answer</source>
        <translation>Ocultar la respuesta</translation>
    </message>
    <message>
        <source>Show the answer</source>
        <translation>Mostrar la respuesta</translation>
    </message>
    <message>
        <source>Answer: %1</source>
        <translation>Respuesta: %1</translation>
    </message>
    <message>
        <source>**Still to do:** %1</source>
        <translation>**Queda por hacer:** %1</translation>
    </message>
</context>
<context>
    <name>app::TryRow</name>
    <message>
        <source>Springstep ticks this when it sees you do it.</source>
        <translation>Springstep marca esto cuando ve que lo haces.</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1 hecho</translation>
    </message>
    <message>
        <source>%1 not yet</source>
        <translation>%1 aún no</translation>
    </message>
</context>
<context>
    <name>app::UserInput</name>
    <message>
        <source>your hand</source>
        <translation>tu mano</translation>
    </message>
    <message>
        <source>Drag %1</source>
        <translation>Arrastrar %1</translation>
    </message>
    <message>
        <source>Move pointer</source>
        <translation>Mover el puntero</translation>
    </message>
    <message>
        <source>the pointer</source>
        <translation>el puntero</translation>
    </message>
    <message>
        <source>Set target</source>
        <translation>Fijar el objetivo</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>el objetivo</translation>
    </message>
    <message>
        <source>Press arrow keys</source>
        <translation>Pulsar flechas</translation>
    </message>
    <message>
        <source>the keys</source>
        <translation>las teclas</translation>
    </message>
</context>
<context>
    <name>app::WebPageDialog</name>
    <message>
        <source>Web page of the run</source>
        <translation>Página web de la ejecución</translation>
    </message>
    <message>
        <source>Progress of the web page</source>
        <translation>Progreso de la página web</translation>
    </message>
    <message>
        <source>One file that plays the run in any browser, also without a network: the scene, the listing with its values, the plots that are open, and the text of the step.</source>
        <translation>Un archivo que reproduce la ejecución en cualquier navegador, también sin red: la escena, el listado con sus valores, las gráficas abiertas y el texto del paso.</translation>
    </message>
    <message>
        <source>The first frame of the page</source>
        <translation>El primer fotograma de la página</translation>
    </message>
    <message>
        <source>The last frame of the page; the run is computed up to there</source>
        <translation>El último fotograma de la página; la ejecución se calcula hasta ahí</translation>
    </message>
    <message>
        <source>&amp;Save as…</source>
        <translation>&amp;Guardar como…</translation>
    </message>
    <message>
        <source>Choose a file, and make the page; you can use the window meanwhile</source>
        <translation>Elegir un archivo y crear la página; mientras tanto puedes usar la ventana</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Páginas web (*.html)</translation>
    </message>
    <message>
        <source>Cancel the page (Esc)</source>
        <translation>Cancelar la página (Esc)</translation>
    </message>
</context>
<context>
    <name>app::WhyButton</name>
    <message>
        <source>Hide the answer</source>
        <translation>Ocultar la respuesta</translation>
    </message>
    <message>
        <source>Show the answer</source>
        <translation>Mostrar la respuesta</translation>
    </message>
    <message>
        <source>open</source>
        <translation>desplegada</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>plegada</translation>
    </message>
</context>
<context>
    <name>app::WhyText</name>
    <message>
        <source>Click the line to keep the marks.</source>
        <translation>Haz clic en la línea para mantener las marcas.</translation>
    </message>
</context>
<context>
    <name>app::WordCard</name>
    <message>
        <source>Taught in</source>
        <translation>Se enseña en</translation>
    </message>
    <message>
        <source>All words</source>
        <translation>Todas las palabras</translation>
    </message>
</context>
<context>
    <name>app::WorkPrecisionPlot</name>
    <message>
        <source>you are here</source>
        <translation>estás aquí</translation>
    </message>
    <message>
        <source>The front: nothing cheaper
is as accurate.</source>
        <translation>La línea óptima: nada más
barato es tan preciso.</translation>
    </message>
    <message>
        <source>Error against time</source>
        <translation>Error y tiempo</translation>
    </message>
    <message>
        <source>time to compute a frame, µs</source>
        <translation>tiempo para calcular un fotograma, µs</translation>
    </message>
    <message>
        <source>forces computed per frame (times follow)</source>
        <translation>fuerzas calculadas por fotograma (después, los tiempos)</translation>
    </message>
    <message>
        <source>← faster</source>
        <translation>← más rápido</translation>
    </message>
    <message>
        <source>A frame is on the screen
for %1&#x2009;µs (30 a second)</source>
        <translation>Un fotograma está en pantalla
%1 µs (30 por segundo)</translation>
    </message>
</context>
<context>
    <name>app::YourLessons</name>
    <message>
        <source>Could not find %1, so it is no longer among your lessons. If you moved it, open it from its new place.</source>
        <translation>No se encontró %1, así que ya no está entre tus lecciones. Si la moviste, ábrela desde su nuevo lugar.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>an event</source>
        <translation>un evento</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un número entero</translation>
    </message>
    <message>
        <source>a parameter&apos;s id</source>
        <translation>el id de un parámetro</translation>
    </message>
    <message>
        <source>a value of that parameter</source>
        <translation>un valor de ese parámetro</translation>
    </message>
    <message>
        <source>joint limits</source>
        <translation>límites articulares</translation>
    </message>
    <message>
        <source>area</source>
        <translation>área</translation>
    </message>
    <message>
        <source>spring</source>
        <translation>muelle</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>amortiguación</translation>
    </message>
    <message>
        <source>gait clock</source>
        <translation>reloj de marcha</translation>
    </message>
    <message>
        <source>gravity</source>
        <translation>gravedad</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>suelo</translation>
    </message>
    <message>
        <source>gust runs on</source>
        <translation>avance de la ráfaga</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>articulaciones</translation>
    </message>
    <message>
        <source>legs</source>
        <translation>piernas</translation>
    </message>
    <message>
        <source>motor</source>
        <translation>motor</translation>
    </message>
    <message>
        <source>anticipation</source>
        <translation>anticipación</translation>
    </message>
    <message>
        <source>pointer</source>
        <translation>puntero</translation>
    </message>
    <message>
        <source>push</source>
        <translation>repulsión</translation>
    </message>
    <message>
        <source>springs</source>
        <translation>muelles</translation>
    </message>
    <message>
        <source>return to rest</source>
        <translation>vuelta al reposo</translation>
    </message>
    <message>
        <source>room</source>
        <translation>habitación</translation>
    </message>
    <message>
        <source>soft sticks</source>
        <translation>barras blandas</translation>
    </message>
    <message>
        <source>drag along, across</source>
        <translation>freno a lo largo, de través</translation>
    </message>
    <message>
        <source>steering</source>
        <translation>control</translation>
    </message>
    <message>
        <source>sticks</source>
        <translation>barras</translation>
    </message>
    <message>
        <source>wind</source>
        <translation>viento</translation>
    </message>
    <message>
        <source>turn round</source>
        <translation>dar la vuelta</translation>
    </message>
    <message>
        <source>turn to the pointer</source>
        <translation>giro hacia el puntero</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>paredes</translation>
    </message>
    <message>
        <source>Done by dragging</source>
        <translation>Aportada al arrastrar</translation>
    </message>
    <message>
        <source>Changed with a parameter</source>
        <translation>Cambiada por un parámetro</translation>
    </message>
    <message>
        <source>Done by clocks and steering</source>
        <translation>Aportada por reloj y control</translation>
    </message>
    <message>
        <source>Done by wind</source>
        <translation>Aportada por el viento</translation>
    </message>
    <message>
        <source>Done by one-way pulls</source>
        <translation>Aportada por tirones unilaterales</translation>
    </message>
    <message>
        <source>Given by gravity</source>
        <translation>Dada por la gravedad</translation>
    </message>
    <message>
        <source>Given by fixed places</source>
        <translation>Dada por lugares fijos</translation>
    </message>
    <message>
        <source>Lost by damping</source>
        <translation>Perdida por amortiguación</translation>
    </message>
    <message>
        <source>At impacts</source>
        <translation>En choques</translation>
    </message>
    <message>
        <source>Changed by sticks</source>
        <translation>Cambiada por barras</translation>
    </message>
    <message>
        <source>Drift of the method</source>
        <translation>Deriva del método</translation>
    </message>
    <message>
        <source>squeezed into one pixel</source>
        <translation>apretado en un píxel</translation>
    </message>
    <message>
        <source>Twelve feet stand within 1 px of their body, on springs of stiffness one million that are 50 px long. Squeezed like this, they flip over at the slightest touch.</source>
        <translation>Doce pies están a menos de 1 px de su cuerpo, con muelles de rigidez un millón que miden 50 px. Apretados así, se dan la vuelta al menor roce.</translation>
    </message>
    <message>
        <source>the pair that runs away</source>
        <translation>la pareja que se escapa</translation>
    </message>
    <message>
        <source>A foot and a body pull each other, but one after the other. So the pair drives itself forward, although nothing pushes it.</source>
        <translation>Un pie y un cuerpo tiran el uno del otro, pero por turnos. Así la pareja se impulsa sola hacia delante, aunque nada la empuja.</translation>
    </message>
    <message>
        <source>sixty feet</source>
        <translation>sesenta pies</translation>
    </message>
    <message>
        <source>Each foot has a soft spring, but sixty together pull the body too hard for one step.</source>
        <translation>Cada pie tiene un muelle blando, pero sesenta juntos tiran del cuerpo con demasiada fuerza para un paso de tiempo.</translation>
    </message>
    <message>
        <source>a hundred feet</source>
        <translation>cien pies</translation>
    </message>
    <message>
        <source>A hundred soft springs on one body make a stiff one.</source>
        <translation>Cien muelles blandos en un cuerpo hacen uno rígido.</translation>
    </message>
    <message>
        <source>a thousand feet</source>
        <translation>mil pies</translation>
    </message>
    <message>
        <source>A thousand feet pull one body as hard as a spring of stiffness 200.</source>
        <translation>Mil pies tiran de un cuerpo con tanta fuerza como un muelle de rigidez 200.</translation>
    </message>
    <message>
        <source>ten thousand feet</source>
        <translation>diez mil pies</translation>
    </message>
    <message>
        <source>Ten thousand feet pull one body as hard as a spring of stiffness 2000.</source>
        <translation>Diez mil pies tiran de un cuerpo con tanta fuerza como un muelle de rigidez 2000.</translation>
    </message>
    <message>
        <source>all in one place</source>
        <translation>todo en un mismo lugar</translation>
    </message>
    <message>
        <source>Body and feet start in the same place, where no spring has a direction.</source>
        <translation>El cuerpo y los pies empiezan en el mismo lugar, donde ningún muelle tiene dirección.</translation>
    </message>
    <message>
        <source>all on one line</source>
        <translation>todo en una línea</translation>
    </message>
    <message>
        <source>Body and feet stand on one line, so nothing pulls them off it.</source>
        <translation>El cuerpo y los pies están en una misma línea, así que nada los saca de ella.</translation>
    </message>
    <message>
        <source>springs without a length</source>
        <translation>muelles sin longitud</translation>
    </message>
    <message>
        <source>Springs of length 0 pull all points to one place, where the springs have no direction.</source>
        <translation>Los muelles de longitud 0 tiran de todos los puntos hacia un mismo lugar, donde los muelles no tienen dirección.</translation>
    </message>
    <message>
        <source>thrown into a corner</source>
        <translation>lanzado a un rincón</translation>
    </message>
    <message>
        <source>A body flies into a corner at a million px a frame. In one step, it would fly through two thousand rooms.</source>
        <translation>Un cuerpo vuela hacia un rincón a un millón de px por fotograma. En un paso de tiempo atravesaría dos mil habitaciones.</translation>
    </message>
    <message>
        <source>walls closer than the body</source>
        <translation>paredes más juntas que el cuerpo</translation>
    </message>
    <message>
        <source>The body is 30 px wide but the room only 15 px. Wherever the body is, it is inside a wall.</source>
        <translation>El cuerpo mide 30 px de ancho, pero la habitación solo 15 px. Esté donde esté, el cuerpo está dentro de una pared.</translation>
    </message>
    <message>
        <source>a million times the gravity</source>
        <translation>un millón de veces la gravedad</translation>
    </message>
    <message>
        <source>In each frame, gravity makes everything a million px a frame faster, above a floor without bounce.</source>
        <translation>En cada fotograma, la gravedad hace que todo vaya un millón de px por fotograma más rápido, sobre un suelo sin rebote.</translation>
    </message>
    <message>
        <source>grabbed and let go</source>
        <translation>sujetado y soltado</translation>
    </message>
    <message>
        <source>The body is grabbed for one frame and let go.</source>
        <translation>El cuerpo se sujeta durante un fotograma y se suelta.</translation>
    </message>
    <message>
        <source>torn away</source>
        <translation>arrancado</translation>
    </message>
    <message>
        <source>The body is dragged a billion px away in one frame and let go.</source>
        <translation>El cuerpo se arrastra a mil millones de px en un fotograma y se suelta.</translation>
    </message>
    <message>
        <source>torn away on stiff springs</source>
        <translation>arrancado con muelles rígidos</translation>
    </message>
    <message>
        <source>The same, with springs of stiffness one million.</source>
        <translation>Lo mismo, con muelles de rigidez un millón.</translation>
    </message>
    <message>
        <source>legs that flip</source>
        <translation>piernas que se invierten</translation>
    </message>
    <message>
        <source>The gait turns by half a circle in each frame, so the steps see only two of its positions.</source>
        <translation>La marcha gira media vuelta en cada fotograma, así que los pasos de tiempo solo ven dos de sus posiciones.</translation>
    </message>
    <message>
        <source>legs that whirl</source>
        <translation>piernas como aspas</translation>
    </message>
    <message>
        <source>The gait turns 159,155 times in a frame.</source>
        <translation>La marcha da 159&#x202f;155 vueltas en un fotograma.</translation>
    </message>
    <message>
        <source>a drag to nowhere</source>
        <translation>un arrastre a ninguna parte</translation>
    </message>
    <message>
        <source>The body is dragged to a position that is not a number.</source>
        <translation>El cuerpo se arrastra a una posición que no es un número.</translation>
    </message>
    <message>
        <source>a pointer infinitely far away</source>
        <translation>un puntero infinitamente lejos</translation>
    </message>
    <message>
        <source>The pointer moves to a position that is infinitely far away.</source>
        <translation>El puntero se mueve a una posición que está infinitamente lejos.</translation>
    </message>
    <message>
        <source>an infinite stiffness</source>
        <translation>una rigidez infinita</translation>
    </message>
    <message>
        <source>The stiffness is set to infinity.</source>
        <translation>La rigidez se pone en infinito.</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>pies</translation>
    </message>
    <message>
        <source>body</source>
        <translation>cuerpo</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>pie</translation>
    </message>
    <message>
        <source>light</source>
        <translation>ligero</translation>
    </message>
    <message>
        <source>heavy</source>
        <translation>pesado</translation>
    </message>
    <message>
        <source>lead</source>
        <translation>guía</translation>
    </message>
    <message>
        <source>tail</source>
        <translation>cola</translation>
    </message>
    <message>
        <source>suddenly stiff</source>
        <translation>rígido de repente</translation>
    </message>
    <message>
        <source>In the middle of the run, the stiffness jumps from 0.2 to one million.</source>
        <translation>A mitad de la ejecución, la rigidez salta de 0,2 a un millón.</translation>
    </message>
    <message>
        <source>just below the limit</source>
        <translation>justo por debajo del límite</translation>
    </message>
    <message>
        <source>With one step a frame, the limit is a stiffness of 4. This spring has 3.99.</source>
        <translation>Con un paso de tiempo por fotograma, el límite es una rigidez de 4. Este muelle tiene 3,99.</translation>
    </message>
    <message>
        <source>at the limit</source>
        <translation>en el límite</translation>
    </message>
    <message>
        <source>At stiffness 4, each step takes the foot to the other side at full speed, so it swings farther each time.</source>
        <translation>Con rigidez 4, cada paso de tiempo lleva el pie al otro lado a toda velocidad, así que oscila cada vez más lejos.</translation>
    </message>
    <message>
        <source>just above the limit</source>
        <translation>justo por encima del límite</translation>
    </message>
    <message>
        <source>At stiffness 4.01 each swing is a tenth larger than the one before.</source>
        <translation>Con rigidez 4,01, cada oscilación es una décima parte mayor que la anterior.</translation>
    </message>
    <message>
        <source>a thousand times as stiff</source>
        <translation>mil veces más rígido</translation>
    </message>
    <message>
        <source>A spring of stiffness 1000 swings five times in a frame.</source>
        <translation>Un muelle de rigidez 1000 oscila cinco veces en un fotograma.</translation>
    </message>
    <message>
        <source>a million times as stiff</source>
        <translation>un millón de veces más rígido</translation>
    </message>
    <message>
        <source>A spring of stiffness a million swings 159 times in a frame.</source>
        <translation>Un muelle de rigidez un millón oscila 159 veces en un fotograma.</translation>
    </message>
    <message>
        <source>nearly rigid</source>
        <translation>casi indeformable</translation>
    </message>
    <message>
        <source>A spring of stiffness one billion behaves almost like a stick.</source>
        <translation>Un muelle de rigidez mil millones se comporta casi como una barra.</translation>
    </message>
    <message>
        <source>nearly rigid, without damping</source>
        <translation>casi indeformable, sin amortiguación</translation>
    </message>
    <message>
        <source>The same without damping: it may swing for ever, but no farther than at the start.</source>
        <translation>Lo mismo sin amortiguación: puede oscilar para siempre, pero no más lejos que al principio.</translation>
    </message>
    <message>
        <source>damping that stops everything</source>
        <translation>amortiguación que lo para todo</translation>
    </message>
    <message>
        <source>With damping 0, no velocity is left, so nothing may move.</source>
        <translation>Con amortiguación 0 no queda velocidad, así que nada debe moverse.</translation>
    </message>
    <message>
        <source>no damping</source>
        <translation>sin amortiguación</translation>
    </message>
    <message>
        <source>With damping 1, nothing is lost: the foot swings for ever, but never farther.</source>
        <translation>Con amortiguación 1 no se pierde nada: el pie oscila para siempre, pero nunca más lejos.</translation>
    </message>
    <message>
        <source>almost no velocity left</source>
        <translation>casi sin velocidad</translation>
    </message>
    <message>
        <source>A damping of 1e-300 leaves velocities that are almost too small to be stored.</source>
        <translation>Una amortiguación de 1e-300 deja velocidades casi demasiado pequeñas para almacenarlas.</translation>
    </message>
    <message>
        <source>a fly and a mountain</source>
        <translation>una mosca y una montaña</translation>
    </message>
    <message>
        <source>One body is a billion times as heavy as the one on its spring.</source>
        <translation>Un cuerpo pesa mil millones de veces más que el que está en su muelle.</translation>
    </message>
    <message>
        <source>the mountain swings, too</source>
        <translation>la montaña también oscila</translation>
    </message>
    <message>
        <source>The spring is stiff enough to move the heavy body, and therefore a hundred million times too stiff for the light one.</source>
        <translation>El muelle es lo bastante rígido para mover el cuerpo pesado, y por eso cien millones de veces demasiado rígido para el ligero.</translation>
    </message>
    <message>
        <source>sticks that contradict each other</source>
        <translation>barras que se contradicen</translation>
    </message>
    <message>
        <source>Three sticks of lengths 1, 1 and 10 cannot form a triangle. Wherever the points move, at least one length is wrong.</source>
        <translation>Tres barras de longitudes 1, 1 y 10 no pueden formar un triángulo. Vayan donde vayan los puntos, al menos una longitud es incorrecta.</translation>
    </message>
    <message>
        <source>a chain that is too short</source>
        <translation>una cadena demasiado corta</translation>
    </message>
    <message>
        <source>A chain of a thousand links between two nails is a tenth too short, so its links cannot keep their lengths.</source>
        <translation>Una cadena de mil eslabones entre dos clavos es una décima parte demasiado corta, así que sus eslabones no pueden mantener su longitud.</translation>
    </message>
    <message>
        <source>a chain too heavy for its sticks</source>
        <translation>una cadena demasiado pesada para sus barras</translation>
    </message>
    <message>
        <source>A chain of a thousand links hangs between two nails: 20 passes a frame leave its links much too long.</source>
        <translation>Una cadena de mil eslabones cuelga entre dos clavos: 20 pasadas por fotograma dejan sus eslabones demasiado largos.</translation>
    </message>
    <message>
        <source>a heavy chain in small steps</source>
        <translation>una cadena pesada en pasos de tiempo pequeños</translation>
    </message>
    <message>
        <source>The same chain and the same work, but with 20 steps of one pass each instead of 20 passes a frame. The errors of its links are a ninth as large.</source>
        <translation>La misma cadena y el mismo trabajo, pero con 20 pasos de tiempo de una pasada cada uno en vez de 20 pasadas por fotograma. Los errores de sus eslabones son nueve veces menores.</translation>
    </message>
    <message>
        <source>a stick without a length</source>
        <translation>una barra sin longitud</translation>
    </message>
    <message>
        <source>Two points on a stick of length 0 have no direction between them, and a body hangs on them.</source>
        <translation>Dos puntos en una barra de longitud 0 no tienen dirección entre ellos, y de ellos cuelga un cuerpo.</translation>
    </message>
    <message>
        <source>a stick between two nails</source>
        <translation>una barra entre dos clavos</translation>
    </message>
    <message>
        <source>A stick between two fixed points is too short, and neither point can move.</source>
        <translation>Una barra entre dos puntos fijos es demasiado corta, y ninguno de los puntos se puede mover.</translation>
    </message>
    <message>
        <source>the tail goes through the lead</source>
        <translation>la cola atraviesa la guía</translation>
    </message>
    <message>
        <source>The lead turns round and swims straight through its own tail.</source>
        <translation>La guía da la vuelta y nada directamente a través de su propia cola.</translation>
    </message>
    <message>
        <source>the tail is in the lead</source>
        <translation>la cola está en la guía</translation>
    </message>
    <message>
        <source>Lead and tail start in the same place, on a soft stick that has no direction there.</source>
        <translation>La guía y la cola empiezan en el mismo lugar, en una barra blanda que allí no tiene dirección.</translation>
    </message>
    <message>
        <source>a target beyond the horizon</source>
        <translation>un objetivo más allá del horizonte</translation>
    </message>
    <message>
        <source>The target is a billion px away, and the motor pulls harder the farther away it is.</source>
        <translation>El objetivo está a mil millones de px, y el motor tira más fuerte cuanto más lejos está.</translation>
    </message>
    <message>
        <source>points</source>
        <translation>puntos</translation>
    </message>
    <message>
        <source>ten million frames</source>
        <translation>diez millones de fotogramas</translation>
    </message>
    <message>
        <source>A foot swings without damping for ten million frames, almost four days of playing. Its errors must not add up.</source>
        <translation>Un pie oscila sin amortiguación durante diez millones de fotogramas, casi cuatro días de reproducción. Sus errores no deben acumularse.</translation>
    </message>
    <message>
        <source>a million frames at rest</source>
        <translation>un millón de fotogramas en reposo</translation>
    </message>
    <message>
        <source>At rest, bodies still have velocities that are almost too small to be stored, but they must not move.</source>
        <translation>En reposo, los cuerpos aún tienen velocidades casi demasiado pequeñas para almacenarlas, pero no deben moverse.</translation>
    </message>
    <message>
        <source>a million steps a frame</source>
        <translation>un millón de pasos de tiempo por fotograma</translation>
    </message>
    <message>
        <source>Each step is a millionth of a frame, so its small change is almost lost in rounding.</source>
        <translation>Cada paso de tiempo es una millonésima de fotograma, así que su pequeño cambio casi se pierde al redondear.</translation>
    </message>
    <message>
        <source>a third of a frame</source>
        <translation>un tercio de fotograma</translation>
    </message>
    <message>
        <source>Three steps a frame: no binary number is exactly a third.</source>
        <translation>Tres pasos de tiempo por fotograma: ningún número binario es exactamente un tercio.</translation>
    </message>
    <message>
        <source>a hundred frames in a step</source>
        <translation>cien fotogramas en un paso de tiempo</translation>
    </message>
    <message>
        <source>One step skips seven swings of the spring.</source>
        <translation>Un paso de tiempo se salta siete oscilaciones del muelle.</translation>
    </message>
    <message>
        <source>no distance to divide by</source>
        <translation>ninguna distancia entre la que dividir</translation>
    </message>
    <message>
        <source>The printed formula divides by the distance of the pointer, which can be 0. Then the run must stop with a message.</source>
        <translation>La fórmula impresa divide entre la distancia del puntero, que puede ser 0. Entonces la ejecución debe pararse con un mensaje.</translation>
    </message>
    <message>
        <source>the pointer on the root</source>
        <translation>el puntero en la raíz</translation>
    </message>
    <message>
        <source>The trunk turns towards a pointer that is exactly at its root.</source>
        <translation>El tronco gira hacia un puntero que está justo en su raíz.</translation>
    </message>
    <message>
        <source>sixteen forks</source>
        <translation>dieciséis bifurcaciones</translation>
    </message>
    <message>
        <source>Each branch forks into two as large as itself, sixteen times: 131,071 branches in the wind.</source>
        <translation>Cada rama se bifurca en dos tan grandes como ella, dieciséis veces: 131&#x202f;071 ramas al viento.</translation>
    </message>
    <message>
        <source>a tree that never ends</source>
        <translation>un árbol que nunca termina</translation>
    </message>
    <message>
        <source>Branches that are as large as their parents never get small enough to stop forking.</source>
        <translation>Las ramas tan grandes como sus madres nunca llegan a ser lo bastante pequeñas para dejar de bifurcarse.</translation>
    </message>
    <message>
        <source>a tree of glass</source>
        <translation>un árbol de cristal</translation>
    </message>
    <message>
        <source>Joints a million times as stiff as wood, bent by ten degrees and let go.</source>
        <translation>Articulaciones un millón de veces más rígidas que la madera, dobladas diez grados y soltadas.</translation>
    </message>
    <message>
        <source>wind from the branch itself</source>
        <translation>viento desde la propia rama</translation>
    </message>
    <message>
        <source>The pointer is exactly where the trunk ends: the wind has no direction there.</source>
        <translation>El puntero está justo donde termina el tronco: allí el viento no tiene dirección.</translation>
    </message>
    <message>
        <source>wind without a distance</source>
        <translation>viento sin distancia</translation>
    </message>
    <message>
        <source>The distance to the pointer resists the wind, and here it is 0.</source>
        <translation>La distancia al puntero se opone al viento, y aquí es 0.</translation>
    </message>
    <message>
        <source>branches</source>
        <translation>ramas</translation>
    </message>
    <message>
        <source>adaptive steps</source>
        <translation>pasos de tiempo adaptativos</translation>
    </message>
    <message>
        <source>Backward Euler</source>
        <translation>Euler implícito</translation>
    </message>
    <message>
        <source>Dormand–Prince 8(5,3)</source>
        <translation>Dormand–Prince 8(5,3)</translation>
    </message>
    <message>
        <source>Dormand–Prince 5(4)</source>
        <translation>Dormand–Prince 5(4)</translation>
    </message>
    <message>
        <source>Explicit Euler</source>
        <translation>Euler explícito</translation>
    </message>
    <message>
        <source>solve for new positions</source>
        <translation>despejar las nuevas posiciones</translation>
    </message>
    <message>
        <source>Implicit midpoint</source>
        <translation>Punto medio implícito</translation>
    </message>
    <message>
        <source>Runge–Kutta–Nyström 8(6)</source>
        <translation>Runge–Kutta–Nyström 8(6)</translation>
    </message>
    <message>
        <source>kick</source>
        <translation>empujón</translation>
    </message>
    <message>
        <source>half kick</source>
        <translation>medio empujón</translation>
    </message>
    <message>
        <source>move</source>
        <translation>movimiento</translation>
    </message>
    <message>
        <source>half move</source>
        <translation>medio movimiento</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>giro</translation>
    </message>
    <message>
        <source>half turn</source>
        <translation>medio giro</translation>
    </message>
    <message>
        <source>new velocity</source>
        <translation>nueva velocidad</translation>
    </message>
    <message>
        <source>Position Verlet</source>
        <translation>Verlet de posición</translation>
    </message>
    <message>
        <source>Published</source>
        <translation>Publicado</translation>
    </message>
    <message>
        <source>trial step</source>
        <translation>paso de prueba</translation>
    </message>
    <message>
        <source>Midpoint</source>
        <translation>Punto medio</translation>
    </message>
    <message>
        <source>Runge–Kutta 4</source>
        <translation>Runge–Kutta 4</translation>
    </message>
    <message>
        <source>Semi-implicit Euler</source>
        <translation>Euler semiimplícito</translation>
    </message>
    <message>
        <source>TR-BDF2</source>
        <translation>TR-BDF2</translation>
    </message>
    <message>
        <source>Velocity Verlet</source>
        <translation>Verlet de velocidad</translation>
    </message>
    <message>
        <source>Keep joints from bending too far: a knee does not bend forwards.</source>
        <translation>Impide que las articulaciones se doblen demasiado: una rodilla no se dobla hacia delante.</translation>
    </message>
    <message>
        <source>Moves the swimmer back a little before it starts towards a new target, like a cat before it jumps.</source>
        <translation>Mueve al nadador un poco hacia atrás antes de que salga hacia un nuevo objetivo, como un gato antes de saltar.</translation>
    </message>
    <message>
        <source>Keeps the area of the body: what gets longer gets thinner.</source>
        <translation>Mantiene el área del cuerpo: lo que se alarga se estrecha.</translation>
    </message>
    <message>
        <source>Pulls a foot to the body, wherever that is.</source>
        <translation>Tira de un pie hacia el cuerpo, esté donde esté.</translation>
    </message>
    <message>
        <source>Takes a share of every velocity each frame, so that things come to rest.</source>
        <translation>Quita una fracción de cada velocidad en cada fotograma, para que las cosas queden en reposo.</translation>
    </message>
    <message>
        <source>Advances the angle of the legs a little in each frame: the rhythm of the walk.</source>
        <translation>Avanza un poco el ángulo de las piernas en cada fotograma: el ritmo de la marcha.</translation>
    </message>
    <message>
        <source>Pulls everything down equally.</source>
        <translation>Tira de todo hacia abajo por igual.</translation>
    </message>
    <message>
        <source>Keeps feet from sinking into the ground, and from slipping unless it is icy.</source>
        <translation>Impide que los pies se hundan en el suelo, y que resbalen salvo si hay hielo.</translation>
    </message>
    <message>
        <source>Lets a gust run outwards from the pointer, so that near branches feel it first.</source>
        <translation>Deja que una ráfaga avance hacia fuera desde el puntero, de modo que las ramas cercanas la sientan primero.</translation>
    </message>
    <message>
        <source>Set each branch on the end of the branch that carries it.</source>
        <translation>Pone cada rama en el extremo de la rama que la lleva.</translation>
    </message>
    <message>
        <source>Pull each foot to its own place, as seen from the body.</source>
        <translation>Tira de cada pie hacia su propio lugar, visto desde el cuerpo.</translation>
    </message>
    <message>
        <source>Pulls the swimmer to its target, like a spring.</source>
        <translation>Tira del nadador hacia su objetivo, como un muelle.</translation>
    </message>
    <message>
        <source>Pulls a foot to a place beside the body.</source>
        <translation>Tira de un pie hacia un lugar junto al cuerpo.</translation>
    </message>
    <message>
        <source>Pulls a foot to a fixed place.</source>
        <translation>Tira de un pie hacia un lugar fijo.</translation>
    </message>
    <message>
        <source>Moves a point to the pointer.</source>
        <translation>Mueve un punto al puntero.</translation>
    </message>
    <message>
        <source>Pushes bodies apart that come too close, so that creatures do not walk through each other.</source>
        <translation>Separa los cuerpos que se acercan demasiado, para que las criaturas no se atraviesen al caminar.</translation>
    </message>
    <message>
        <source>Keep two points a length apart: they pull when the distance is longer, and push when it is shorter.</source>
        <translation>Mantiene dos puntos a una longitud: tira si la distancia es mayor y empuja si es menor.</translation>
    </message>
    <message>
        <source>Turns each branch part of the way back to its direction at rest.</source>
        <translation>Gira cada rama una parte del camino de vuelta a su dirección en reposo.</translation>
    </message>
    <message>
        <source>Keep a point near its distance, but let it lag behind for a while.</source>
        <translation>Mantiene un punto cerca de su distancia, pero deja que se retrase un rato.</translation>
    </message>
    <message>
        <source>Slows the tail as water does: more across the body than along it.</source>
        <translation>Frena la cola como lo hace el agua: más de través que a lo largo.</translation>
    </message>
    <message>
        <source>Lets the arrow keys and the pointer set how fast the legs swing.</source>
        <translation>Deja que las flechas y el puntero decidan con qué rapidez se balancean las piernas.</translation>
    </message>
    <message>
        <source>Give each pair of points its length back, by moving them: a stick does not stretch.</source>
        <translation>Devuelve su longitud a cada par de puntos, moviéndolos: una barra no se estira.</translation>
    </message>
    <message>
        <source>Bend each joint back: the farther a branch has turned from its direction at rest, the harder.</source>
        <translation>Dobla de vuelta cada articulación: cuanto más se ha girado una rama desde su dirección en reposo, con más fuerza.</translation>
    </message>
    <message>
        <source>Makes a creature turn round when it meets a wall.</source>
        <translation>Hace que una criatura dé la vuelta al llegar a una pared.</translation>
    </message>
    <message>
        <source>Turns every branch to the pointer while its button is down.</source>
        <translation>Gira cada rama hacia el puntero mientras su botón está pulsado.</translation>
    </message>
    <message>
        <source>Put back points that have gone past a wall or the floor, and reverse their velocity.</source>
        <translation>Devuelve los puntos que han pasado una pared o el suelo, e invierte su velocidad.</translation>
    </message>
    <message>
        <source>Turns the branches away from the pointer while its button is down.</source>
        <translation>Aparta las ramas del puntero mientras su botón está pulsado.</translation>
    </message>
    <message>
        <source>the body %1</source>
        <translation>el cuerpo %1</translation>
    </message>
    <message>
        <source>Blows everything sideways, wide bodies more strongly, and can come in gusts.</source>
        <translation>Sopla todo hacia un lado, con más fuerza los cuerpos anchos, y puede llegar en ráfagas.</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>rampa</translation>
    </message>
    <message>
        <source>Keeps everything on one side of a straight line at any angle.</source>
        <translation>Mantiene todo a un lado de una recta con cualquier ángulo.</translation>
    </message>
    <message>
        <source>Keeps everything between two walls and above a floor, with friction and without bounce.</source>
        <translation>Mantiene todo entre dos paredes y sobre un suelo, con rozamiento y sin rebote.</translation>
    </message>
    <message>
        <source>Stiff springs</source>
        <translation>Muelles rígidos</translation>
    </message>
    <message>
        <source>Many feet on one body</source>
        <translation>Muchos pies en un cuerpo</translation>
    </message>
    <message>
        <source>All in one place</source>
        <translation>Todo en un mismo lugar</translation>
    </message>
    <message>
        <source>Grabbed and dragged</source>
        <translation>Sujetado y arrastrado</translation>
    </message>
    <message>
        <source>Walls and walking</source>
        <translation>Paredes y caminar</translation>
    </message>
    <message>
        <source>Sticks that contradict</source>
        <translation>Barras que se contradicen</translation>
    </message>
    <message>
        <source>Swimmers</source>
        <translation>Nadadores</translation>
    </message>
    <message>
        <source>Trees in wind</source>
        <translation>Árboles al viento</translation>
    </message>
    <message>
        <source>Unusual steps</source>
        <translation>Pasos de tiempo insólitos</translation>
    </message>
    <message>
        <source>Long runs</source>
        <translation>Ejecuciones largas</translation>
    </message>
    <message>
        <source>Invalid input</source>
        <translation>Entrada no válida</translation>
    </message>
    <message>
        <source>1/frame²</source>
        <translation>1/fotograma²</translation>
    </message>
    <message>
        <source>Bounce</source>
        <translation>Rebote</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortiguación</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distancia</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Suelo</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Rozamiento</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Gravedad</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Suelo</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Ráfagas</translation>
    </message>
    <message>
        <source>How far down that place is.</source>
        <translation>Cuánto más abajo está ese lugar.</translation>
    </message>
    <message>
        <source>How far down the floor lies.</source>
        <translation>Cuánto más abajo está el suelo.</translation>
    </message>
    <message>
        <source>How far down the ground lies.</source>
        <translation>Cuánto más abajo está el suelo.</translation>
    </message>
    <message>
        <source>How far to the right a place of the ramp is.</source>
        <translation>Cuánto a la derecha está un lugar de la rampa.</translation>
    </message>
    <message>
        <source>How hard it blows to the right on a body 10 px wide. Below 0: to the left.</source>
        <translation>Con qué fuerza sopla hacia la derecha sobre un cuerpo de 10 px de ancho. Por debajo de 0: hacia la izquierda.</translation>
    </message>
    <message>
        <source>How hard two bodies push: this share of the missing distance, each frame.</source>
        <translation>Con qué fuerza se empujan dos cuerpos: esta fracción de la distancia que falta, en cada fotograma.</translation>
    </message>
    <message>
        <source>How much a wall slows things that slide along it. 0: like ice.</source>
        <translation>Cuánto frena una pared lo que se desliza por ella. 0: como hielo.</translation>
    </message>
    <message>
        <source>How much speed everything gains downwards each frame.</source>
        <translation>Cuánta rapidez gana todo hacia abajo en cada fotograma.</translation>
    </message>
    <message>
        <source>How often each frame goes through the list of sticks.</source>
        <translation>Cuántas veces recorre cada fotograma la lista de barras.</translation>
    </message>
    <message>
        <source>How steeply it rises to the right. 0: level. 90: a wall on the right. 180: a ceiling.</source>
        <translation>Cuánto sube hacia la derecha. 0: horizontal. 90: una pared a la derecha. 180: un techo.</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Iteraciones</translation>
    </message>
    <message>
        <source>Left wall</source>
        <translation>Pared izquierda</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Repulsión</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampa</translation>
    </message>
    <message>
        <source>Ramp x</source>
        <translation>Rampa x</translation>
    </message>
    <message>
        <source>Ramp y</source>
        <translation>Rampa y</translation>
    </message>
    <message>
        <source>Right wall</source>
        <translation>Pared derecha</translation>
    </message>
    <message>
        <source>The share by which the strength of the wind changes.</source>
        <translation>La fracción en que cambia la fuerza del viento.</translation>
    </message>
    <message>
        <source>The share of its speed that a body keeps at a wall.</source>
        <translation>La fracción de su rapidez que un cuerpo conserva en una pared.</translation>
    </message>
    <message>
        <source>The share of its speed that everything keeps each frame. 1 keeps it all.</source>
        <translation>La fracción de su rapidez que todo conserva en cada fotograma. 1 la conserva toda.</translation>
    </message>
    <message>
        <source>Two bodies closer than this push each other.</source>
        <translation>Dos cuerpos más cercanos que esto se empujan.</translation>
    </message>
    <message>
        <source>Where the left wall stands.</source>
        <translation>Dónde está la pared izquierda.</translation>
    </message>
    <message>
        <source>Where the right wall stands.</source>
        <translation>Dónde está la pared derecha.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Viento</translation>
    </message>
    <message>
        <source>ice on the ground</source>
        <translation>hielo en el suelo</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>se conserva</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>pasadas</translation>
    </message>
    <message>
        <source>per frame</source>
        <translation>por fotograma</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>px/frame²</source>
        <translation>px/fotograma²</translation>
    </message>
    <message>
        <source>springs that pull one end only</source>
        <translation>muelles que solo tiran de un extremo</translation>
    </message>
    <message>
        <source>feet with more than one leg</source>
        <translation>pies con más de una pierna</translation>
    </message>
    <message>
        <source>the bounce of the ground</source>
        <translation>el rebote del suelo</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Charge strength</source>
        <translation>Fuerza de las cargas</translation>
    </message>
    <message>
        <source>px³/frame²</source>
        <translation>px³/fotograma²</translation>
    </message>
    <message>
        <source>How hard charges push and pull each other.</source>
        <translation>Con qué fuerza se repelen y se atraen las cargas.</translation>
    </message>
    <message>
        <source>Softening</source>
        <translation>Suavidad</translation>
    </message>
    <message>
        <source>Weakens the force where charges come closer than about this, so that it stays finite.</source>
        <translation>Debilita la fuerza donde las cargas se acercan más que esto, aproximadamente, para que siga siendo finita.</translation>
    </message>
    <message>
        <source>Charge</source>
        <translation>Carga</translation>
    </message>
    <message>
        <source>Charges of the same sign repel each other, and others attract. 0: it carries none.</source>
        <translation>Las cargas del mismo signo se repelen, y las demás se atraen. 0: no lleva ninguna.</translation>
    </message>
    <message>
        <source>Where this charge is, seen from the other one.</source>
        <translation>Dónde está esta carga, vista desde la otra.</translation>
    </message>
    <message>
        <source>How far apart the two charges are.</source>
        <translation>A qué distancia están las dos cargas.</translation>
    </message>
    <message>
        <source>How hard they push each other apart, for a mass of 1. Below 0: they attract each other.</source>
        <translation>Con qué fuerza se repelen, para una masa de 1. Por debajo de 0: se atraen.</translation>
    </message>
    <message>
        <source>What all charges together add to the velocity each frame.</source>
        <translation>Lo que todas las cargas juntas añaden a la velocidad en cada fotograma.</translation>
    </message>
    <message>
        <source>charges</source>
        <translation>cargas</translation>
    </message>
    <message>
        <source>Push points with like charges apart, and pull unlike ones together: the closer they are, the harder.</source>
        <translation>Aparta los puntos con cargas iguales y junta los de cargas distintas: cuanto más cerca, más fuerte.</translation>
    </message>
    <message>
        <source>two charges in one place</source>
        <translation>dos cargas en un mismo lugar</translation>
    </message>
    <message>
        <source>Two like charges begin in one place, where the force between them is greatest and has no direction.</source>
        <translation>Dos cargas iguales empiezan en un mismo lugar, donde la fuerza entre ellas es máxima y no tiene dirección.</translation>
    </message>
    <message>
        <source>creature</source>
        <translation>criatura</translation>
    </message>
    <message>
        <source>bodies</source>
        <translation>cuerpos</translation>
    </message>
    <message>
        <source>branch</source>
        <translation>rama</translation>
    </message>
    <message>
        <source>your code</source>
        <translation>tu código</translation>
    </message>
    <message>
        <source>Your code</source>
        <translation>Tu código</translation>
    </message>
    <message>
        <source>Done by my rule</source>
        <translation>Aportada por mi regla</translation>
    </message>
    <message>
        <source>my rule</source>
        <translation>mi regla</translation>
    </message>
    <message>
        <source>Acts on bodies by the rule that you wrote.</source>
        <translation>Actúa sobre los cuerpos según la regla que has escrito.</translation>
    </message>
</context>
<context>
    <name>sim::Keys</name>
    <message>
        <source>there is no key %1; there is %2.</source>
        <translation>no existe la tecla %1; existe %2.</translation>
    </message>
</context>
</TS>
