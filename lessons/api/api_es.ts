<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>Conditions</name>
    <message>
        <source>take it with the mouse, and let go of it.</source>
        <translation>tómalo con el ratón y suéltalo.</translation>
    </message>
    <message>
        <source>let go while the mouse moves, at %2&#x202f;px per frame or more. You let go at %1.</source>
        <translation>suelta mientras el ratón se mueve, a %2&#x202f;px por fotograma o más. El tuyo salió a %1.</translation>
    </message>
    <message>
        <source>take it with the mouse.</source>
        <translation>tómalo con el ratón.</translation>
    </message>
    <message>
        <source>take it with the mouse, and hold it.</source>
        <translation>tómalo con el ratón y sujétalo.</translation>
    </message>
    <message>
        <source>carry it %2&#x202f;px or more. It came %1&#x202f;px.</source>
        <translation>llévalo %2&#x202f;px o más. Ha avanzado %1&#x202f;px.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until nothing moves.</source>
        <translation>deja correr el tiempo (**Espacio**) hasta que nada se mueva.</translation>
    </message>
    <message>
        <source>hands off, and let time run for %2&#x202f;frames. So far: %1.</source>
        <translation>sin tocar nada, deja correr el tiempo %2&#x202f;fotogramas. Hasta ahora: %1.</translation>
    </message>
    <message>
        <source>let time run for %2&#x202f;frames with this value. So far: %1.</source>
        <translation>deja correr el tiempo %2&#x202f;fotogramas con este valor. Hasta ahora: %1.</translation>
    </message>
    <message>
        <source>go on to frame %2. This is frame %1.</source>
        <translation>sigue hasta el fotograma %2. Este es el fotograma %1.</translation>
    </message>
    <message>
        <source>stop, show the page **Engine** of the code, and go into a frame: **Shift+→**.</source>
        <translation>para, muestra la página **Motor de cálculo** del código y entra en un fotograma: **Mayús+→**.</translation>
    </message>
    <message>
        <source>press **Shift+→** or **Shift+←** until a spring has pulled and nothing has moved.</source>
        <translation>pulsa **Mayús+→** o **Mayús+←** hasta que un muelle haya tirado y nada se haya movido.</translation>
    </message>
    <message>
        <source>play on for 10&#x202f;frames from where the two part. So far: %1.</source>
        <translation>reproduce 10&#x202f;fotogramas más desde donde se separan los dos. Hasta ahora: %1.</translation>
    </message>
</context>
<context>
    <name>Document</name>
    <message>
        <source>the story is missing. Write it below the title.</source>
        <translation>falta la historia. Escríbela debajo del título.</translation>
    </message>
    <message>
        <source>there is no text below %1. Write it there, or remove the heading.</source>
        <translation>no hay texto debajo de %1. Escríbelo allí o quita el encabezado.</translation>
    </message>
    <message>
        <source>%1 has no id. End the heading with “{#id}”, where id is made of a to z, 0 to 9 and _.</source>
        <translation>%1 no tiene identificador. Termina el encabezado con «{#id}», donde id se compone de a a z, 0 a 9 y _.</translation>
    </message>
    <message>
        <source>the id “%1” was used above. Choose another one.</source>
        <translation>el identificador «%1» ya se ha usado más arriba. Elige otro.</translation>
    </message>
    <message>
        <source>%1 is incomplete. Write “## %2: ” and a text after it.</source>
        <translation>%1 está incompleto. Escribe «## %2: » y un texto detrás.</translation>
    </message>
    <message>
        <source>%1 does not belong here. Here you can write %2.</source>
        <translation>%1 no va aquí. Aquí puedes escribir %2.</translation>
    </message>
    <message>
        <source>%1 does not belong here. Remove it, or write it below a “## Try”.</source>
        <translation>%1 no va aquí. Quítalo o escríbelo debajo de un «## Try».</translation>
    </message>
    <message>
        <source>%1 is there twice. Remove one of them.</source>
        <translation>%1 está dos veces. Quita uno de los dos.</translation>
    </message>
    <message>
        <source>the thing to try “%1” has no hint. Write it below a “### Hint”.</source>
        <translation>la prueba «%1» no tiene pista. Escríbela debajo de un «### Hint».</translation>
    </message>
    <message>
        <source>“%1” has no name. Write “- name: sentence”, where the name is made of a to z, 0 to 9 and _.</source>
        <translation>«%1» no tiene nombre. Escribe «- nombre: frase», donde el nombre se compone de a a z, 0 a 9 y _.</translation>
    </message>
    <message>
        <source>the name “%1” is there twice. Remove one of the sentences.</source>
        <translation>el nombre «%1» está dos veces. Quita una de las frases.</translation>
    </message>
    <message>
        <source>the task “%1” has no title. Write “## Task: title {#%1}”.</source>
        <translation>la tarea «%1» no tiene título. Escribe «## Task: título {#%1}».</translation>
    </message>
    <message>
        <source>the task “%1” has no comment for the empty place. Write it below a “### Comment”.</source>
        <translation>la tarea «%1» no tiene comentario para el hueco. Escríbelo debajo de un «### Comment».</translation>
    </message>
    <message>
        <source>the number of hints of the task “%1” is %2, not 3. Write each below a “### Hint”.</source>
        <translation>el número de pistas de la tarea «%1» es %2, no 3. Escribe cada una debajo de un «### Hint».</translation>
    </message>
    <message>
        <source>this near miss is incomplete. Write its code between two lines ```, and below it a sentence about what the code does.</source>
        <translation>este casi acierto está incompleto. Escribe su código entre dos líneas ``` y, debajo, una frase sobre lo que hace el código.</translation>
    </message>
    <message>
        <source>the word “%1” is there twice. Remove one of them.</source>
        <translation>la palabra «%1» está dos veces. Quita una de las dos.</translation>
    </message>
    <message>
        <source>the word “%1” is not explained. Write one to three sentences, after a blank line.</source>
        <translation>la palabra «%1» no está explicada. Escribe de una a tres frases, después de una línea en blanco.</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, línea %2: %3</translation>
    </message>
    <message>
        <source>en</source>
        <extracomment>The code of the language of this file, for the lessons&apos; documents: de, fr</extracomment>
        <translation>es</translation>
    </message>
    <message>
        <source>the file is missing. Write it, and configure the build again.</source>
        <translation>falta el archivo. Escríbelo y vuelve a configurar la compilación.</translation>
    </message>
    <message>
        <source>the thing to try “%1” has choices, but no answer. Write it below an “### Answer”.</source>
        <translation>la prueba «%1» tiene opciones, pero no respuesta. Escríbela debajo de un «### Answer».</translation>
    </message>
    <message>
        <source>the title of the concept “%1” has %2 characters. Write 1 to %3, as in “## Concept: title {#%1}”.</source>
        <translation>el título del concepto «%1» tiene %2 caracteres. Escribe de 1 a %3, como en «## Concept: título {#%1}».</translation>
    </message>
    <message>
        <source>the concept “%1” needs one paragraph besides “Rests on: …”. Write one sentence there.</source>
        <translation>el concepto «%1» necesita un párrafo además de «Rests on: …». Escribe allí una frase.</translation>
    </message>
    <message>
        <source>a condition cannot be called “%1”. Give it a name of its own, made of a to z, 0 to 9 and _.</source>
        <translation>una condición no se puede llamar «%1». Dale un nombre propio, compuesto de a a z, 0 a 9 y _.</translation>
    </message>
    <message>
        <source>this run needs “- frames: ” and the number of frames in which the thing is done, and has no “until” and no “step”.</source>
        <translation>esta ejecución necesita «- frames: » y el número de fotogramas en los que se consigue, y no lleva «until» ni «step».</translation>
    </message>
    <message>
        <source>%1 is not a heading of a lesson. Write “## Try {#id}”, “## Predict {#id}”, “## Task: title {#id}”, “## Parameter: name {#id}”, “## Word: name”, “## Concept: title {#id}”, “## Why: question” or “## Learnt”.</source>
        <translation>%1 no es un título de una lección. Escribe «## Try {#id}», «## Predict {#id}», «## Task: título {#id}», «## Parameter: nombre {#id}», «## Word: nombre», «## Concept: título {#id}», «## Why: pregunta» o «## Learnt».</translation>
    </message>
    <message>
        <source>the parameter “%1” has no name. Write “## Parameter: name {#%1}”.</source>
        <translation>el parámetro «%1» no tiene nombre. Escribe «## Parameter: nombre {#%1}».</translation>
    </message>
</context>
<context>
    <name>DocumentScan</name>
    <message>
        <source>this is not UTF-8. Save the file with the encoding UTF-8.</source>
        <translation>esto no es UTF-8. Guarda el archivo con la codificación UTF-8.</translation>
    </message>
    <message>
        <source>the title is missing. Begin the file with “# ” and the title of the step.</source>
        <translation>falta el título. Empieza el archivo con «# » y el título del paso.</translation>
    </message>
    <message>
        <source>this is a second title. Write “## ” instead.</source>
        <translation>este es un segundo título. Escribe «## » en su lugar.</translation>
    </message>
    <message>
        <source>the code has no end. Write ``` on a line of its own after it.</source>
        <translation>el código no tiene final. Escribe detrás ``` en una línea aparte.</translation>
    </message>
    <message>
        <source>a space is missing after “#”. Write the heading as in “## Learnt”.</source>
        <translation>falta un espacio después de «#». Escribe el título como en «## Learnt».</translation>
    </message>
</context>
<context>
    <name>Formula</name>
    <message>
        <source>braces belong behind a formula, which is a paragraph of its own in backticks. Write them there, or remove them.</source>
        <translation>las llaves van detrás de una fórmula, que es un párrafo aparte entre comillas invertidas. Escríbelas allí o quítalas.</translation>
    </message>
    <message>
        <source>“%1” is nothing that a formula can highlight. Write the name of a body or a parameter, “a -&gt; b”, “a -&gt; b x”, “a -&gt; b y”, “a.velocity”, or “circle a parameter”, with commas between them.</source>
        <translation>«%1» no es nada que una fórmula pueda resaltar. Escribe el nombre de un cuerpo o de un parámetro, «a -&gt; b», «a -&gt; b x», «a -&gt; b y», «a.velocity» o «circle a parameter», separados por comas.</translation>
    </message>
    <message>
        <source>“%1” in the braces is not there in this step. It has the bodies %2, and the parameters %3.</source>
        <translation>«%1», entre llaves, no existe en este paso. Tiene los cuerpos %2 y los parámetros %3.</translation>
    </message>
</context>
<context>
    <name>Join</name>
    <message>
        <source>none</source>
        <translation>ninguno</translation>
    </message>
    <message>
        <source>the thing to try “%1” says nothing about what is missing for “%2”. Write “- %2: sentence” below its “### Missing”.</source>
        <translation>la prueba «%1» no dice nada sobre lo que falta para «%2». Escribe «- %2: frase» debajo de su «### Missing».</translation>
    </message>
    <message>
        <source>the thing to try “%1” has no condition “%2”. Remove the sentence, or give it one of the names: %3.</source>
        <translation>la prueba «%1» no tiene ninguna condición «%2». Quita la frase o ponle uno de estos nombres: %3.</translation>
    </message>
    <message>
        <source>the thing to try “%1” is unknown. Use one of the ids of this step: %2.</source>
        <translation>la prueba «%1» es desconocida. Usa uno de los identificadores de este paso: %2.</translation>
    </message>
    <message>
        <source>the thing to try “%1” is missing. Write “## Try {#%1}” and its text.</source>
        <translation>falta la prueba «%1». Escribe «## Try {#%1}» y su texto.</translation>
    </message>
    <message>
        <source>the listing has no gap “%1”. In %2, put the lines that learners write between “//&gt; %1” and “//&lt;”.</source>
        <translation>el listado no tiene ningún hueco «%1». En %2, pon entre «//&gt; %1» y «//&lt;» las líneas que se escriben.</translation>
    </message>
    <message>
        <source>the listing has no gap “%1”. Use one of: %2.</source>
        <translation>el listado no tiene ningún hueco «%1». Usa uno de estos: %2.</translation>
    </message>
    <message>
        <source>the step has no parameter “%1”. Remove the heading: only lessons without C++ declare parameters in a document.</source>
        <translation>el paso no tiene ningún parámetro «%1». Quita el título: solo las lecciones sin C++ declaran parámetros en un documento.</translation>
    </message>
</context>
<context>
    <name>ListingText</name>
    <message>
        <source>line %1: %2</source>
        <translation>línea %1: %2</translation>
    </message>
    <message>
        <source>this gap begins inside another one. Write “//&lt;” where that one ends.</source>
        <translation>este hueco empieza dentro de otro. Escribe «//&lt;» donde termina el otro.</translation>
    </message>
    <message>
        <source>a gap needs an id that no other gap has. Write it after “//&gt;”.</source>
        <translation>un hueco necesita un identificador que ningún otro tenga. Escríbelo después de «//&gt;».</translation>
    </message>
    <message>
        <source>no gap begins before this “//&lt;”. Write “//&gt; id” there, or remove it.</source>
        <translation>ningún hueco empieza antes de este «//&lt;». Escribe allí «//&gt; id» o quítalo.</translation>
    </message>
    <message>
        <source>the gap has no code. Write it above this line, or remove the gap.</source>
        <translation>el hueco no tiene código. Escríbelo encima de esta línea o quita el hueco.</translation>
    </message>
    <message>
        <source>the last gap has no end. Write “//&lt;” after its code.</source>
        <translation>el último hueco no tiene final. Escribe «//&lt;» después de su código.</translation>
    </message>
</context>
<context>
    <name>ParameterText</name>
    <message>
        <source>a parameter has no “%1”. It has “value”, “minimum”, “maximum”, “step”, “unit” and “sets”.</source>
        <translation>un parámetro no tiene «%1». Tiene «value», «minimum», «maximum», «step», «unit» y «sets».</translation>
    </message>
    <message>
        <source>“%1” is there twice. Remove one of them.</source>
        <translation>«%1» está dos veces. Quita uno de los dos.</translation>
    </message>
    <message>
        <source>“%1” is not a number between -1000000000 and 1000000000. Write it as in “- %2: 2”.</source>
        <translation>«%1» no es un número entre -1000000000 y 1000000000. Escríbelo como en «- %2: 2».</translation>
    </message>
    <message>
        <source>the step cannot be %1. Write one of these: %2.</source>
        <translation>el paso no puede ser %1. Escribe uno de estos: %2.</translation>
    </message>
    <message>
        <source>this unit has %1 characters. Write at most %2.</source>
        <translation>esta unidad tiene %1 caracteres. Escribe %2 como máximo.</translation>
    </message>
    <message>
        <source>the name of the parameter “%1” has %2 characters. Write at most %3.</source>
        <translation>el nombre del parámetro «%1» tiene %2 caracteres. Escribe %3 como máximo.</translation>
    </message>
    <message>
        <source>nothing says what the parameter “%1” does. Write one sentence below its heading.</source>
        <translation>nada dice qué hace el parámetro «%1». Escribe una frase debajo de su título.</translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>px</source>
        <translation>px</translation>
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
        <source>How hard a spring pulls: this share of the missing distance, each frame.</source>
        <translation>Con qué fuerza tira un muelle: esta fracción de la distancia que falta, en cada fotograma.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radio</translation>
    </message>
    <message>
        <source>The distance that the spring keeps.</source>
        <translation>La distancia que mantiene el muelle.</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Desvío</translation>
    </message>
    <message>
        <source>How far to the right of the body the spring ends. Below 0: to the left.</source>
        <translation>Cuánto a la derecha del cuerpo acaba el muelle. Bajo 0: a la izquierda.</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pies</translation>
    </message>
    <message>
        <source>How many feet the body has.</source>
        <translation>Cuántos pies tiene el cuerpo.</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>Centro x</translation>
    </message>
    <message>
        <source>How far to the right the cross is.</source>
        <translation>Cuánto a la derecha está la cruz.</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>Centro y</translation>
    </message>
    <message>
        <source>How far down the cross is.</source>
        <translation>Cuánto más abajo está la cruz.</translation>
    </message>
</context>
<context>
    <name>Predict</name>
    <message>
        <source>the question of the prediction “%1” is missing. Write it below the heading.</source>
        <translation>falta la pregunta de la predicción «%1». Escríbela debajo del encabezado.</translation>
    </message>
    <message>
        <source>“### %1” does not belong here. Here you can write “### Run”, “### Ask”, “### Other curve”, “### Answer”.</source>
        <translation>«### %1» no va aquí. Aquí puedes escribir «### Run», «### Ask», «### Other curve», «### Answer».</translation>
    </message>
    <message>
        <source>“### %1” is there twice. Remove one of them.</source>
        <translation>«### %1» está dos veces. Quita uno de los dos.</translation>
    </message>
    <message>
        <source>“%1” does not belong here. A prediction asks one question, and can have a “- unit: px” after it.</source>
        <translation>«%1» no va aquí. Una predicción hace una sola pregunta y puede llevar detrás «- unit: px».</translation>
    </message>
    <message>
        <source>“%1” cannot be asked. Write “- place: body”, “- number: frames”, “- number: foot.x” or “- curve: foot.x”.</source>
        <translation>no se puede preguntar por «%1». Escribe «- place: body», «- number: frames», «- number: foot.x» o «- curve: foot.x».</translation>
    </message>
    <message>
        <source>the prediction “%1” is incomplete. Write “### %2” and what belongs below it.</source>
        <translation>la predicción «%1» está incompleta. Escribe «### %2» y lo que va debajo.</translation>
    </message>
    <message>
        <source>this run has no end. Write “- frames: ” and the frame at which it ends at the latest.</source>
        <translation>esta ejecución no tiene final. Escribe «- frames: » y el fotograma en el que termina a más tardar.</translation>
    </message>
    <message>
        <source>the number of frames is given away by the run. Write “- until: ” and the condition at which it ends.</source>
        <translation>la ejecución delata el número de fotogramas. Escribe «- until: » y la condición con la que termina.</translation>
    </message>
    <message>
        <source>the number of other curves of the prediction “%1” is %2, not 2. Write each below an “### Other curve”.</source>
        <translation>el número de otras curvas de la predicción «%1» es %2, no 2. Escribe cada una debajo de un «### Other curve».</translation>
    </message>
    <message>
        <source>“### Other curve” does not belong here. Remove it, or ask for a “- curve: ”.</source>
        <translation>«### Other curve» no va aquí. Quítalo o pregunta por una «- curve: ».</translation>
    </message>
    <message>
        <source>“%1” is not a choice. Write “- [ ] text”, or “- [x] text” if it is right.</source>
        <translation>«%1» no es una opción. Escribe «- [ ] texto», o «- [x] texto» si es la correcta.</translation>
    </message>
    <message>
        <source>the number of choices is %1. Write two to four.</source>
        <translation>el número de opciones es %1. Escribe de dos a cuatro.</translation>
    </message>
    <message>
        <source>the number of right choices is %1, not 1. Write “- [x] ” before the right one.</source>
        <translation>el número de opciones correctas es %1, no 1. Escribe «- [x] » delante de la correcta.</translation>
    </message>
</context>
<context>
    <name>Project</name>
    <message>
        <source>the brief is missing. Write it below the title.</source>
        <translation>falta el enunciado. Escríbelo debajo del título.</translation>
    </message>
    <message>
        <source>the number of levels is %1, not 3. Write each below a “## Level: title {#id}”.</source>
        <translation>el número de niveles es %1, no 3. Escribe cada uno debajo de un «## Level: título {#id}».</translation>
    </message>
    <message>
        <source>“## %1” is not a heading of a project. Write “## Level: title {#id}”.</source>
        <translation>«## %1» no es un encabezado de un proyecto. Escribe «## Level: título {#id}».</translation>
    </message>
    <message>
        <source>the id “%1” was used above. Choose another one.</source>
        <translation>el identificador «%1» ya se ha usado más arriba. Elige otro.</translation>
    </message>
    <message>
        <source>“### %1” is there twice. Remove one of them.</source>
        <translation>«### %1» está dos veces. Quita uno de los dos.</translation>
    </message>
    <message>
        <source>“### %1” does not belong here. Here you can write “### Run”, “### Holds”, “### Show”, “### Hint”.</source>
        <translation>«### %1» no va aquí. Aquí puedes escribir «### Run», «### Holds», «### Show», «### Hint».</translation>
    </message>
    <message>
        <source>“%1: %2” is not a ring. Write its place and radius in px: “- ring: 300, 220, 12”.</source>
        <translation>«%1: %2» no es un aro. Escribe su lugar y su radio en px: «- ring: 300, 220, 12».</translation>
    </message>
    <message>
        <source>“%1” is not a list of names. Write “- %2: one, other”.</source>
        <translation>«%1» no es una lista de nombres. Escribe «- %2: uno, otro».</translation>
    </message>
    <message>
        <source>“%1” is not a condition. Write “- always `condition`: sentence”, or “once”, “at the start” or “at the end” in place of “always”.</source>
        <translation>«%1» no es una condición. Escribe «- always `condition`: frase», o bien «once», «at the start» o «at the end» en lugar de «always».</translation>
    </message>
    <message>
        <source>the level “%1” does not say what it asks. Write it below the heading.</source>
        <translation>el nivel «%1» no dice lo que pide. Escríbelo debajo del encabezado.</translation>
    </message>
    <message>
        <source>the level “%1” is incomplete. Write “### %2” and what belongs below it.</source>
        <translation>el nivel «%1» está incompleto. Escribe «### %2» y lo que va debajo.</translation>
    </message>
    <message>
        <source>this run has no end. Write “- frames: ” and the number of frames to judge.</source>
        <translation>esta ejecución no tiene final. Escribe «- frames: » y el número de fotogramas que se juzgan.</translation>
    </message>
    <message>
        <source>the run of a level has no “until” and no “step”. Remove them.</source>
        <translation>la ejecución de un nivel no lleva «until» ni «step». Quítalos.</translation>
    </message>
</context>
<context>
    <name>Recall</name>
    <message>
        <source>there is no text below the title. Write one sentence there.</source>
        <translation>no hay texto debajo del título. Escribe allí una frase.</translation>
    </message>
    <message>
        <source>there is no question. Write “## Question {#id}” and its text.</source>
        <translation>no hay ninguna pregunta. Escribe «## Question {#id}» y su texto.</translation>
    </message>
    <message>
        <source>“## %1” is not a heading of a recall question. Write “## Question {#id}”, where id is made of a to z, 0 to 9 and _.</source>
        <translation>«## %1» no es un encabezado de una pregunta de repaso. Escribe «## Question {#id}», donde id se compone de a a z, 0 a 9 y _.</translation>
    </message>
    <message>
        <source>the id “%1” was used above. Choose another one.</source>
        <translation>el identificador «%1» ya se ha usado más arriba. Elige otro.</translation>
    </message>
    <message>
        <source>there is no text below “%1 %2”. Write it there, or remove the heading.</source>
        <translation>no hay texto debajo de «%1 %2». Escríbelo allí o quita el encabezado.</translation>
    </message>
    <message>
        <source>“### %1” does not belong here. Here you can write “### Right” and “### Wrong”, or “### Do” and “### Answer”.</source>
        <translation>«### %1» no va aquí. Aquí puedes escribir «### Right» y «### Wrong», o «### Do» y «### Answer».</translation>
    </message>
    <message>
        <source>“### %1” is there twice. Remove one of them.</source>
        <translation>«### %1» está dos veces. Quita uno de los dos.</translation>
    </message>
    <message>
        <source>the question “%1” is incomplete. Write one “### Right” and one to three “### Wrong”, or “### Do” and “### Answer”.</source>
        <translation>la pregunta «%1» está incompleta. Escribe un «### Right» y de uno a tres «### Wrong», o «### Do» y «### Answer».</translation>
    </message>
    <message>
        <source>the question “%1” has %2 choices. Keep four at most.</source>
        <translation>la pregunta «%1» tiene %2 opciones. Deja cuatro como mucho.</translation>
    </message>
    <message>
        <source>the choice begins with ```. Write its code in backticks.</source>
        <translation>la opción empieza con ```. Escribe su código entre comillas invertidas.</translation>
    </message>
    <message>
        <source>the choice has %1 characters. Make its first paragraph %2 or shorter, and explain it in the next one.</source>
        <translation>la opción tiene %1 caracteres. Acorta su primer párrafo a %2 o menos y explícala en el siguiente.</translation>
    </message>
    <message>
        <source>this choice is not explained. Write why it is wrong below it, after a blank line.</source>
        <translation>esta opción no está explicada. Escribe debajo, después de una línea en blanco, por qué es incorrecta.</translation>
    </message>
    <message>
        <source>the scene is missing. Write “- step: lesson/step” in the list.</source>
        <translation>falta la escena. Escribe «- step: lesson/step» en la lista.</translation>
    </message>
    <message>
        <source>nothing says when this is done. Write “- until: condition” in the list.</source>
        <translation>nada dice cuándo está hecho. Escribe «- until: condition» en la lista.</translation>
    </message>
    <message>
        <source>this run needs “- frames: ” and the number of frames in which it is done, and has no “until” and no “step”.</source>
        <translation>esta ejecución necesita «- frames: » y el número de fotogramas en los que se consigue, y no lleva «until» ni «step».</translation>
    </message>
</context>
<context>
    <name>RunSetupReaderText</name>
    <message>
        <source>“%1” is there twice. Remove one of them.</source>
        <translation>«%1» está dos veces. Quita uno de los dos.</translation>
    </message>
    <message>
        <source>“%1” is not a number of frames. Write a whole number from 1 to %2.</source>
        <translation>«%1» no es un número de fotogramas. Escribe un número entero de 1 a %2.</translation>
    </message>
    <message>
        <source>“%1” is not a place. Write x and y in px, as in “- %2: 300, 220”.</source>
        <translation>«%1» no es un lugar. Escribe x e y en px, como en «- %2: 300, 220».</translation>
    </message>
    <message>
        <source>“%1” is incomplete. Write x and y in px and the number of frames, as in “- %2: 300, 220, 10”.</source>
        <translation>«%1» está incompleto. Escribe x e y en px y el número de fotogramas, como en «- %2: 300, 220, 10».</translation>
    </message>
    <message>
        <source>“%1” does not belong in this list. Write “- name: value”, on one line.</source>
        <translation>«%1» no va en esta lista. Escribe «- nombre: valor», en una línea.</translation>
    </message>
    <message>
        <source>there is no list below “### %1”. Write “- name: value” there, or remove the heading.</source>
        <translation>no hay ninguna lista debajo de «### %1». Escribe allí «- nombre: valor» o quita el encabezado.</translation>
    </message>
    <message>
        <source>nothing says which body to drag. Write its name, as in “- drag foot: %1”.</source>
        <translation>falta el cuerpo que se arrastra. Escribe su nombre, como en «- drag foot: %1».</translation>
    </message>
</context>
</TS>
