<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>Conditions</name>
    <message>
        <source>take it with the mouse, and let go of it.</source>
        <translation>prends-le avec la souris, et lâche-le.</translation>
    </message>
    <message>
        <source>let go while the mouse moves, at %2&#x202f;px per frame or more. You let go at %1.</source>
        <translation>lâche pendant que la souris bouge, à %2&#x202f;px par image ou plus. Là, c’était %1.</translation>
    </message>
    <message>
        <source>take it with the mouse.</source>
        <translation>prends-le avec la souris.</translation>
    </message>
    <message>
        <source>take it with the mouse, and hold it.</source>
        <translation>prends-le avec la souris, et tiens-le.</translation>
    </message>
    <message>
        <source>carry it %2&#x202f;px or more. It came %1&#x202f;px.</source>
        <translation>porte-le sur %2&#x202f;px ou plus. Il a parcouru %1&#x202f;px.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until nothing moves.</source>
        <translation>laisse passer le temps (**Espace**) jusqu’à ce que plus rien ne bouge.</translation>
    </message>
    <message>
        <source>hands off, and let time run for %2&#x202f;frames. So far: %1.</source>
        <translation>ne touche à rien, et laisse passer %2&#x202f;images. Jusqu’ici&#xa0;: %1.</translation>
    </message>
    <message>
        <source>let time run for %2&#x202f;frames with this value. So far: %1.</source>
        <translation>laisse passer %2&#x202f;images avec cette valeur. Jusqu’ici&#xa0;: %1.</translation>
    </message>
    <message>
        <source>go on to frame %2. This is frame %1.</source>
        <translation>continue jusqu’à l’image %2. Tu es à l’image %1.</translation>
    </message>
    <message>
        <source>stop, show the page **Engine** of the code, and go into a frame: **Shift+→**.</source>
        <translation>arrête, affiche la page **Moteur physique** du code, et entre dans une image&#xa0;: **Maj+→**.</translation>
    </message>
    <message>
        <source>press **Shift+→** or **Shift+←** until a spring has pulled and nothing has moved.</source>
        <translation>appuie sur **Maj+→** ou **Maj+←** jusqu’à ce qu’un ressort ait tiré et que rien n’ait bougé.</translation>
    </message>
    <message>
        <source>play on for 10&#x202f;frames from where the two part. So far: %1.</source>
        <translation>continue pendant 10&#x202f;images après l’endroit où les deux se séparent. Jusqu’ici&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>Document</name>
    <message>
        <source>the story is missing. Write it below the title.</source>
        <translation>le récit manque. Écris-le sous le titre.</translation>
    </message>
    <message>
        <source>there is no text below %1. Write it there, or remove the heading.</source>
        <translation>il n’y a pas de texte sous %1. Écris-le là, ou enlève le titre.</translation>
    </message>
    <message>
        <source>%1 has no id. End the heading with “{#id}”, where id is made of a to z, 0 to 9 and _.</source>
        <translation>%1 n’a pas d’identifiant. Termine le titre par «&#x202f;{#id}&#x202f;», où id se compose de a à z, de 0 à 9 et de _.</translation>
    </message>
    <message>
        <source>the id “%1” was used above. Choose another one.</source>
        <translation>l’identifiant «&#x202f;%1&#x202f;» est déjà utilisé plus haut. Choisis-en un autre.</translation>
    </message>
    <message>
        <source>%1 is incomplete. Write “## %2: ” and a text after it.</source>
        <translation>%1 est incomplet. Écris «&#x202f;## %2:&#x202f;» suivi d’un texte.</translation>
    </message>
    <message>
        <source>%1 does not belong here. Here you can write %2.</source>
        <translation>%1 n’a pas sa place ici. Tu peux écrire ici %2.</translation>
    </message>
    <message>
        <source>%1 does not belong here. Remove it, or write it below a “## Try”.</source>
        <translation>%1 n’a pas sa place ici. Enlève-le, ou écris-le sous un «&#x202f;## Try&#x202f;».</translation>
    </message>
    <message>
        <source>%1 is there twice. Remove one of them.</source>
        <translation>%1 s’y trouve deux fois. Enlève l’un des deux.</translation>
    </message>
    <message>
        <source>the thing to try “%1” has no hint. Write it below a “### Hint”.</source>
        <translation>l’essai «&#x202f;%1&#x202f;» n’a pas d’indice. Écris-le sous un «&#x202f;### Hint&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” has no name. Write “- name: sentence”, where the name is made of a to z, 0 to 9 and _.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas de nom. Écris «&#x202f;- nom: phrase&#x202f;», où le nom se compose de a à z, de 0 à 9 et de _.</translation>
    </message>
    <message>
        <source>the name “%1” is there twice. Remove one of the sentences.</source>
        <translation>le nom «&#x202f;%1&#x202f;» s’y trouve deux fois. Enlève l’une des phrases.</translation>
    </message>
    <message>
        <source>the task “%1” has no title. Write “## Task: title {#%1}”.</source>
        <translation>l’exercice «&#x202f;%1&#x202f;» n’a pas de titre. Écris «&#x202f;## Task: titre {#%1}&#x202f;».</translation>
    </message>
    <message>
        <source>the task “%1” has no comment for the empty place. Write it below a “### Comment”.</source>
        <translation>l’exercice «&#x202f;%1&#x202f;» n’a pas de commentaire pour l’endroit vide. Écris-le sous un «&#x202f;### Comment&#x202f;».</translation>
    </message>
    <message>
        <source>the number of hints of the task “%1” is %2, not 3. Write each below a “### Hint”.</source>
        <translation>l’exercice «&#x202f;%1&#x202f;» a %2 indices, et non 3. Écris chacun sous un «&#x202f;### Hint&#x202f;».</translation>
    </message>
    <message>
        <source>this near miss is incomplete. Write its code between two lines ```, and below it a sentence about what the code does.</source>
        <translation>cet essai presque juste est incomplet. Écris son code entre deux lignes ```, et dessous une phrase sur ce que fait le code.</translation>
    </message>
    <message>
        <source>the word “%1” is there twice. Remove one of them.</source>
        <translation>le mot «&#x202f;%1&#x202f;» s’y trouve deux fois. Enlève l’un des deux.</translation>
    </message>
    <message>
        <source>the word “%1” is not explained. Write one to three sentences, after a blank line.</source>
        <translation>le mot «&#x202f;%1&#x202f;» n’est pas expliqué. Écris une à trois phrases, après une ligne vide.</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, ligne %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>en</source>
        <extracomment>The code of the language of this file, for the lessons&apos; documents: de, fr</extracomment>
        <translation>fr</translation>
    </message>
    <message>
        <source>the file is missing. Write it, and configure the build again.</source>
        <translation>le fichier manque. Écris-le, et configure à nouveau la compilation.</translation>
    </message>
    <message>
        <source>the thing to try “%1” has choices, but no answer. Write it below an “### Answer”.</source>
        <translation>l’essai «&#x202f;%1&#x202f;» a des choix, mais pas de réponse. Écris-la sous un «&#x202f;### Answer&#x202f;».</translation>
    </message>
    <message>
        <source>the title of the concept “%1” has %2 characters. Write 1 to %3, as in “## Concept: title {#%1}”.</source>
        <translation>le titre de la notion «&#x202f;%1&#x202f;» a %2 caractères. Écris-en de 1 à %3, comme dans «&#x202f;## Concept: titre {#%1}&#x202f;».</translation>
    </message>
    <message>
        <source>the concept “%1” needs one paragraph besides “Rests on: …”. Write one sentence there.</source>
        <translation>la notion «&#x202f;%1&#x202f;» a besoin d’un seul paragraphe en plus de «&#x202f;Rests on: …&#x202f;». Écris-y une phrase.</translation>
    </message>
    <message>
        <source>a condition cannot be called “%1”. Give it a name of its own, made of a to z, 0 to 9 and _.</source>
        <translation>une condition ne peut pas s’appeler «&#x202f;%1&#x202f;». Donne-lui un nom à elle, composé de a à z, de 0 à 9 et de _.</translation>
    </message>
    <message>
        <source>this run needs “- frames: ” and the number of frames in which the thing is done, and has no “until” and no “step”.</source>
        <translation>cette simulation a besoin de «&#x202f;- frames:&#x202f;» et du nombre d’images dans lequel la chose est faite, et n’a ni «&#x202f;until&#x202f;» ni «&#x202f;step&#x202f;».</translation>
    </message>
    <message>
        <source>%1 is not a heading of a lesson. Write “## Try {#id}”, “## Predict {#id}”, “## Task: title {#id}”, “## Parameter: name {#id}”, “## Word: name”, “## Concept: title {#id}”, “## Why: question” or “## Learnt”.</source>
        <translation>%1 n’est pas un titre de leçon. Écris «&#x202f;## Try {#id}&#x202f;», «&#x202f;## Predict {#id}&#x202f;», «&#x202f;## Task: titre {#id}&#x202f;», «&#x202f;## Parameter: nom {#id}&#x202f;», «&#x202f;## Word: nom&#x202f;», «&#x202f;## Concept: titre {#id}&#x202f;», «&#x202f;## Why: question&#x202f;» ou «&#x202f;## Learnt&#x202f;».</translation>
    </message>
    <message>
        <source>the parameter “%1” has no name. Write “## Parameter: name {#%1}”.</source>
        <translation>le paramètre «&#x202f;%1&#x202f;» n’a pas de nom. Écris «&#x202f;## Parameter: nom {#%1}&#x202f;».</translation>
    </message>
</context>
<context>
    <name>DocumentScan</name>
    <message>
        <source>this is not UTF-8. Save the file with the encoding UTF-8.</source>
        <translation>ce n’est pas de l’UTF-8. Enregistre le fichier avec l’encodage UTF-8.</translation>
    </message>
    <message>
        <source>the title is missing. Begin the file with “# ” and the title of the step.</source>
        <translation>le titre manque. Commence le fichier par «&#x202f;#&#x202f;» et le titre de l’étape.</translation>
    </message>
    <message>
        <source>this is a second title. Write “## ” instead.</source>
        <translation>c’est un deuxième titre. Écris plutôt «&#x202f;##&#x202f;».</translation>
    </message>
    <message>
        <source>the code has no end. Write ``` on a line of its own after it.</source>
        <translation>le code n’a pas de fin. Écris ``` après lui, seul sur une ligne.</translation>
    </message>
    <message>
        <source>a space is missing after “#”. Write the heading as in “## Learnt”.</source>
        <translation>il manque une espace après «&#x202f;#&#x202f;». Écris le titre comme dans «&#x202f;## Learnt&#x202f;».</translation>
    </message>
</context>
<context>
    <name>Formula</name>
    <message>
        <source>braces belong behind a formula, which is a paragraph of its own in backticks. Write them there, or remove them.</source>
        <translation>des accolades se placent derrière une formule, qui est un paragraphe à elle seule entre accents graves. Écris-les là, ou enlève-les.</translation>
    </message>
    <message>
        <source>“%1” is nothing that a formula can highlight. Write the name of a body or a parameter, “a -&gt; b”, “a -&gt; b x”, “a -&gt; b y”, “a.velocity”, or “circle a parameter”, with commas between them.</source>
        <translation>«&#x202f;%1&#x202f;» n’est rien qu’une formule puisse mettre en évidence. Écris le nom d’un corps ou d’un paramètre, «&#x202f;a -&gt; b&#x202f;», «&#x202f;a -&gt; b x&#x202f;», «&#x202f;a -&gt; b y&#x202f;», «&#x202f;a.velocity&#x202f;» ou «&#x202f;circle a parameter&#x202f;», séparés par des virgules.</translation>
    </message>
    <message>
        <source>“%1” in the braces is not there in this step. It has the bodies %2, and the parameters %3.</source>
        <translation>«&#x202f;%1&#x202f;», entre accolades, n’existe pas dans cette étape. Elle a les corps %2, et les paramètres %3.</translation>
    </message>
</context>
<context>
    <name>Join</name>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>the thing to try “%1” says nothing about what is missing for “%2”. Write “- %2: sentence” below its “### Missing”.</source>
        <translation>l’essai «&#x202f;%1&#x202f;» ne dit pas ce qui manque pour «&#x202f;%2&#x202f;». Écris «&#x202f;- %2: phrase&#x202f;» sous son «&#x202f;### Missing&#x202f;».</translation>
    </message>
    <message>
        <source>the thing to try “%1” has no condition “%2”. Remove the sentence, or give it one of the names: %3.</source>
        <translation>l’essai «&#x202f;%1&#x202f;» n’a pas de condition «&#x202f;%2&#x202f;». Enlève la phrase, ou donne-lui l’un de ces noms&#xa0;: %3.</translation>
    </message>
    <message>
        <source>the thing to try “%1” is unknown. Use one of the ids of this step: %2.</source>
        <translation>l’essai «&#x202f;%1&#x202f;» est inconnu. Utilise l’un des identifiants de cette étape&#xa0;: %2.</translation>
    </message>
    <message>
        <source>the thing to try “%1” is missing. Write “## Try {#%1}” and its text.</source>
        <translation>l’essai «&#x202f;%1&#x202f;» manque. Écris «&#x202f;## Try {#%1}&#x202f;» et son texte.</translation>
    </message>
    <message>
        <source>the listing has no gap “%1”. In %2, put the lines that learners write between “//&gt; %1” and “//&lt;”.</source>
        <translation>le listing n’a pas de lacune «&#x202f;%1&#x202f;». Dans %2, mets entre «&#x202f;//&gt; %1&#x202f;» et «&#x202f;//&lt;&#x202f;» les lignes à écrire.</translation>
    </message>
    <message>
        <source>the listing has no gap “%1”. Use one of: %2.</source>
        <translation>le listing n’a pas de lacune «&#x202f;%1&#x202f;». Utilise l’une de celles-ci&#xa0;: %2.</translation>
    </message>
    <message>
        <source>the step has no parameter “%1”. Remove the heading: only lessons without C++ declare parameters in a document.</source>
        <translation>l’étape n’a pas de paramètre «&#x202f;%1&#x202f;». Supprime le titre&#xa0;: seules les leçons sans C++ déclarent des paramètres dans un document.</translation>
    </message>
</context>
<context>
    <name>ListingText</name>
    <message>
        <source>line %1: %2</source>
        <translation>ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>this gap begins inside another one. Write “//&lt;” where that one ends.</source>
        <translation>cette lacune commence dans une autre. Écris «&#x202f;//&lt;&#x202f;» là où l’autre finit.</translation>
    </message>
    <message>
        <source>a gap needs an id that no other gap has. Write it after “//&gt;”.</source>
        <translation>une lacune a besoin d’un identifiant qu’aucune autre n’a. Écris-le après «&#x202f;//&gt;&#x202f;».</translation>
    </message>
    <message>
        <source>no gap begins before this “//&lt;”. Write “//&gt; id” there, or remove it.</source>
        <translation>aucune lacune ne commence avant ce «&#x202f;//&lt;&#x202f;». Écris-y «&#x202f;//&gt; id&#x202f;», ou enlève-le.</translation>
    </message>
    <message>
        <source>the gap has no code. Write it above this line, or remove the gap.</source>
        <translation>la lacune n’a pas de code. Écris-le au-dessus de cette ligne, ou enlève la lacune.</translation>
    </message>
    <message>
        <source>the last gap has no end. Write “//&lt;” after its code.</source>
        <translation>la dernière lacune n’a pas de fin. Écris «&#x202f;//&lt;&#x202f;» après son code.</translation>
    </message>
</context>
<context>
    <name>ParameterText</name>
    <message>
        <source>a parameter has no “%1”. It has “value”, “minimum”, “maximum”, “step”, “unit” and “sets”.</source>
        <translation>un paramètre n’a pas de «&#x202f;%1&#x202f;». Il a «&#x202f;value&#x202f;», «&#x202f;minimum&#x202f;», «&#x202f;maximum&#x202f;», «&#x202f;step&#x202f;», «&#x202f;unit&#x202f;» et «&#x202f;sets&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” is there twice. Remove one of them.</source>
        <translation>«&#x202f;%1&#x202f;» s’y trouve deux fois. Enlève l’un des deux.</translation>
    </message>
    <message>
        <source>“%1” is not a number between -1000000000 and 1000000000. Write it as in “- %2: 2”.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un nombre entre -1000000000 et 1000000000. Écris-le comme dans «&#x202f;- %2: 2&#x202f;».</translation>
    </message>
    <message>
        <source>the step cannot be %1. Write one of these: %2.</source>
        <translation>le pas ne peut pas être %1. Écris l’un de ceux-ci&#xa0;: %2.</translation>
    </message>
    <message>
        <source>this unit has %1 characters. Write at most %2.</source>
        <translation>cette unité a %1 caractères. Écris-en %2 au plus.</translation>
    </message>
    <message>
        <source>the name of the parameter “%1” has %2 characters. Write at most %3.</source>
        <translation>le nom du paramètre «&#x202f;%1&#x202f;» a %2 caractères. Écris-en %3 au plus.</translation>
    </message>
    <message>
        <source>nothing says what the parameter “%1” does. Write one sentence below its heading.</source>
        <translation>rien ne dit ce que fait le paramètre «&#x202f;%1&#x202f;». Écris une phrase sous son titre.</translation>
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
        <translation>Raideur</translation>
    </message>
    <message>
        <source>1/frame²</source>
        <translation>1/image²</translation>
    </message>
    <message>
        <source>How hard a spring pulls: this share of the missing distance, each frame.</source>
        <translation>Force d’un ressort&#xa0;: cette part de la distance qui manque, à chaque image.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Rayon</translation>
    </message>
    <message>
        <source>The distance that the spring keeps.</source>
        <translation>Distance que garde le ressort.</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Décalage</translation>
    </message>
    <message>
        <source>How far to the right of the body the spring ends. Below 0: to the left.</source>
        <translation>À quelle distance à droite du corps finit le ressort. Sous 0&#xa0;: à gauche.</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Pieds</translation>
    </message>
    <message>
        <source>How many feet the body has.</source>
        <translation>Nombre de pieds du corps.</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>Centre x</translation>
    </message>
    <message>
        <source>How far to the right the cross is.</source>
        <translation>À quelle distance vers la droite se trouve la croix.</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>Centre y</translation>
    </message>
    <message>
        <source>How far down the cross is.</source>
        <translation>À quelle distance vers le bas se trouve la croix.</translation>
    </message>
</context>
<context>
    <name>Predict</name>
    <message>
        <source>the question of the prediction “%1” is missing. Write it below the heading.</source>
        <translation>la question de la prédiction «&#x202f;%1&#x202f;» manque. Écris-la sous le titre.</translation>
    </message>
    <message>
        <source>“### %1” does not belong here. Here you can write “### Run”, “### Ask”, “### Other curve”, “### Answer”.</source>
        <translation>«&#x202f;### %1&#x202f;» n’a pas sa place ici. Tu peux écrire ici «&#x202f;### Run&#x202f;», «&#x202f;### Ask&#x202f;», «&#x202f;### Other curve&#x202f;», «&#x202f;### Answer&#x202f;».</translation>
    </message>
    <message>
        <source>“### %1” is there twice. Remove one of them.</source>
        <translation>«&#x202f;### %1&#x202f;» s’y trouve deux fois. Enlève l’un des deux.</translation>
    </message>
    <message>
        <source>“%1” does not belong here. A prediction asks one question, and can have a “- unit: px” after it.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas sa place ici. Une prédiction pose une seule question, qui peut être suivie de «&#x202f;- unit: px&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” cannot be asked. Write “- place: body”, “- number: frames”, “- number: foot.x” or “- curve: foot.x”.</source>
        <translation>on ne peut pas demander «&#x202f;%1&#x202f;». Écris «&#x202f;- place: body&#x202f;», «&#x202f;- number: frames&#x202f;», «&#x202f;- number: foot.x&#x202f;» ou «&#x202f;- curve: foot.x&#x202f;».</translation>
    </message>
    <message>
        <source>the prediction “%1” is incomplete. Write “### %2” and what belongs below it.</source>
        <translation>la prédiction «&#x202f;%1&#x202f;» est incomplète. Écris «&#x202f;### %2&#x202f;» et ce qui va dessous.</translation>
    </message>
    <message>
        <source>this run has no end. Write “- frames: ” and the frame at which it ends at the latest.</source>
        <translation>cette simulation n’a pas de fin. Écris «&#x202f;- frames:&#x202f;» et l’image à laquelle elle finit au plus tard.</translation>
    </message>
    <message>
        <source>the number of frames is given away by the run. Write “- until: ” and the condition at which it ends.</source>
        <translation>la simulation trahit le nombre d’images. Écris «&#x202f;- until:&#x202f;» et la condition à laquelle elle finit.</translation>
    </message>
    <message>
        <source>the number of other curves of the prediction “%1” is %2, not 2. Write each below an “### Other curve”.</source>
        <translation>la prédiction «&#x202f;%1&#x202f;» a %2 autres courbes, et non 2. Écris chacune sous un «&#x202f;### Other curve&#x202f;».</translation>
    </message>
    <message>
        <source>“### Other curve” does not belong here. Remove it, or ask for a “- curve: ”.</source>
        <translation>«&#x202f;### Other curve&#x202f;» n’a pas sa place ici. Enlève-le, ou demande une «&#x202f;- curve:&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” is not a choice. Write “- [ ] text”, or “- [x] text” if it is right.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un choix. Écris «&#x202f;- [ ] texte&#x202f;», ou «&#x202f;- [x] texte&#x202f;» s’il est juste.</translation>
    </message>
    <message>
        <source>the number of choices is %1. Write two to four.</source>
        <translation>le nombre de choix est %1. Écris-en de deux à quatre.</translation>
    </message>
    <message>
        <source>the number of right choices is %1, not 1. Write “- [x] ” before the right one.</source>
        <translation>le nombre de choix justes est %1, et non 1. Écris «&#x202f;- [x]&#x202f;» devant le bon.</translation>
    </message>
</context>
<context>
    <name>Project</name>
    <message>
        <source>the brief is missing. Write it below the title.</source>
        <translation>l’énoncé manque. Écris-le sous le titre.</translation>
    </message>
    <message>
        <source>the number of levels is %1, not 3. Write each below a “## Level: title {#id}”.</source>
        <translation>le nombre de paliers est %1, et non 3. Écris chacun sous un «&#x202f;## Level: titre {#id}&#x202f;».</translation>
    </message>
    <message>
        <source>“## %1” is not a heading of a project. Write “## Level: title {#id}”.</source>
        <translation>«&#x202f;## %1&#x202f;» n’est pas un titre de projet. Écris «&#x202f;## Level: titre {#id}&#x202f;».</translation>
    </message>
    <message>
        <source>the id “%1” was used above. Choose another one.</source>
        <translation>l’identifiant «&#x202f;%1&#x202f;» est déjà utilisé plus haut. Choisis-en un autre.</translation>
    </message>
    <message>
        <source>“### %1” is there twice. Remove one of them.</source>
        <translation>«&#x202f;### %1&#x202f;» s’y trouve deux fois. Enlève l’un des deux.</translation>
    </message>
    <message>
        <source>“### %1” does not belong here. Here you can write “### Run”, “### Holds”, “### Show”, “### Hint”.</source>
        <translation>«&#x202f;### %1&#x202f;» n’a pas sa place ici. Tu peux écrire ici «&#x202f;### Run&#x202f;», «&#x202f;### Holds&#x202f;», «&#x202f;### Show&#x202f;», «&#x202f;### Hint&#x202f;».</translation>
    </message>
    <message>
        <source>“%1: %2” is not a ring. Write its place and radius in px: “- ring: 300, 220, 12”.</source>
        <translation>«&#x202f;%1: %2&#x202f;» n’est pas un anneau. Écris sa place et son rayon en px&#xa0;: «&#x202f;- ring: 300, 220, 12&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” is not a list of names. Write “- %2: one, other”.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas une liste de noms. Écris «&#x202f;- %2: un, autre&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” is not a condition. Write “- always `condition`: sentence”, or “once”, “at the start” or “at the end” in place of “always”.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas une condition. Écris «&#x202f;- always `condition`: phrase&#x202f;», ou «&#x202f;once&#x202f;», «&#x202f;at the start&#x202f;» ou «&#x202f;at the end&#x202f;» à la place de «&#x202f;always&#x202f;».</translation>
    </message>
    <message>
        <source>the level “%1” does not say what it asks. Write it below the heading.</source>
        <translation>le palier «&#x202f;%1&#x202f;» ne dit pas ce qu’il demande. Écris-le sous le titre.</translation>
    </message>
    <message>
        <source>the level “%1” is incomplete. Write “### %2” and what belongs below it.</source>
        <translation>le palier «&#x202f;%1&#x202f;» est incomplet. Écris «&#x202f;### %2&#x202f;» et ce qui va dessous.</translation>
    </message>
    <message>
        <source>this run has no end. Write “- frames: ” and the number of frames to judge.</source>
        <translation>cette simulation n’a pas de fin. Écris «&#x202f;- frames:&#x202f;» et le nombre d’images à vérifier.</translation>
    </message>
    <message>
        <source>the run of a level has no “until” and no “step”. Remove them.</source>
        <translation>la simulation d’un palier n’a ni «&#x202f;until&#x202f;» ni «&#x202f;step&#x202f;». Enlève-les.</translation>
    </message>
</context>
<context>
    <name>Recall</name>
    <message>
        <source>there is no text below the title. Write one sentence there.</source>
        <translation>il n’y a pas de texte sous le titre. Écris-y une phrase.</translation>
    </message>
    <message>
        <source>there is no question. Write “## Question {#id}” and its text.</source>
        <translation>il n’y a pas de question. Écris «&#x202f;## Question {#id}&#x202f;» et son texte.</translation>
    </message>
    <message>
        <source>“## %1” is not a heading of a recall question. Write “## Question {#id}”, where id is made of a to z, 0 to 9 and _.</source>
        <translation>«&#x202f;## %1&#x202f;» n’est pas un titre de question. Écris «&#x202f;## Question {#id}&#x202f;», où id se compose de a à z, de 0 à 9 et de _.</translation>
    </message>
    <message>
        <source>the id “%1” was used above. Choose another one.</source>
        <translation>l’identifiant «&#x202f;%1&#x202f;» est déjà utilisé plus haut. Choisis-en un autre.</translation>
    </message>
    <message>
        <source>there is no text below “%1 %2”. Write it there, or remove the heading.</source>
        <translation>il n’y a pas de texte sous «&#x202f;%1 %2&#x202f;». Écris-le là, ou enlève le titre.</translation>
    </message>
    <message>
        <source>“### %1” does not belong here. Here you can write “### Right” and “### Wrong”, or “### Do” and “### Answer”.</source>
        <translation>«&#x202f;### %1&#x202f;» n’a pas sa place ici. Tu peux écrire ici «&#x202f;### Right&#x202f;» et «&#x202f;### Wrong&#x202f;», ou «&#x202f;### Do&#x202f;» et «&#x202f;### Answer&#x202f;».</translation>
    </message>
    <message>
        <source>“### %1” is there twice. Remove one of them.</source>
        <translation>«&#x202f;### %1&#x202f;» s’y trouve deux fois. Enlève l’un des deux.</translation>
    </message>
    <message>
        <source>the question “%1” is incomplete. Write one “### Right” and one to three “### Wrong”, or “### Do” and “### Answer”.</source>
        <translation>la question «&#x202f;%1&#x202f;» est incomplète. Écris un «&#x202f;### Right&#x202f;» et un à trois «&#x202f;### Wrong&#x202f;», ou «&#x202f;### Do&#x202f;» et «&#x202f;### Answer&#x202f;».</translation>
    </message>
    <message>
        <source>the question “%1” has %2 choices. Keep four at most.</source>
        <translation>la question «&#x202f;%1&#x202f;» a %2 choix. Gardes-en quatre au plus.</translation>
    </message>
    <message>
        <source>the choice begins with ```. Write its code in backticks.</source>
        <translation>le choix commence par ```. Écris son code entre accents graves simples.</translation>
    </message>
    <message>
        <source>the choice has %1 characters. Make its first paragraph %2 or shorter, and explain it in the next one.</source>
        <translation>le choix a %1 caractères. Raccourcis son premier paragraphe à %2 au plus, et explique-le dans le suivant.</translation>
    </message>
    <message>
        <source>this choice is not explained. Write why it is wrong below it, after a blank line.</source>
        <translation>ce choix n’est pas expliqué. Écris dessous pourquoi il est faux, après une ligne vide.</translation>
    </message>
    <message>
        <source>the scene is missing. Write “- step: lesson/step” in the list.</source>
        <translation>la scène manque. Écris «&#x202f;- step: lesson/step&#x202f;» dans la liste.</translation>
    </message>
    <message>
        <source>nothing says when this is done. Write “- until: condition” in the list.</source>
        <translation>rien ne dit quand c’est fait. Écris «&#x202f;- until: condition&#x202f;» dans la liste.</translation>
    </message>
    <message>
        <source>this run needs “- frames: ” and the number of frames in which it is done, and has no “until” and no “step”.</source>
        <translation>cette simulation a besoin de «&#x202f;- frames:&#x202f;» et du nombre d’images dans lequel c’est fait, et n’a ni «&#x202f;until&#x202f;» ni «&#x202f;step&#x202f;».</translation>
    </message>
</context>
<context>
    <name>RunSetupReaderText</name>
    <message>
        <source>“%1” is there twice. Remove one of them.</source>
        <translation>«&#x202f;%1&#x202f;» s’y trouve deux fois. Enlève l’un des deux.</translation>
    </message>
    <message>
        <source>“%1” is not a number of frames. Write a whole number from 1 to %2.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un nombre d’images. Écris un nombre entier de 1 à %2.</translation>
    </message>
    <message>
        <source>“%1” is not a place. Write x and y in px, as in “- %2: 300, 220”.</source>
        <translation>«&#x202f;%1&#x202f;» n’est pas un endroit. Écris x et y en px, comme dans «&#x202f;- %2: 300, 220&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” is incomplete. Write x and y in px and the number of frames, as in “- %2: 300, 220, 10”.</source>
        <translation>«&#x202f;%1&#x202f;» est incomplet. Écris x et y en px et le nombre d’images, comme dans «&#x202f;- %2: 300, 220, 10&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” does not belong in this list. Write “- name: value”, on one line.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas sa place dans cette liste. Écris «&#x202f;- nom: valeur&#x202f;», sur une ligne.</translation>
    </message>
    <message>
        <source>there is no list below “### %1”. Write “- name: value” there, or remove the heading.</source>
        <translation>il n’y a pas de liste sous «&#x202f;### %1&#x202f;». Écris-y «&#x202f;- nom: valeur&#x202f;», ou enlève le titre.</translation>
    </message>
    <message>
        <source>nothing says which body to drag. Write its name, as in “- drag foot: %1”.</source>
        <translation>il manque le corps à tirer. Écris son nom, comme dans «&#x202f;- drag foot: %1&#x202f;».</translation>
    </message>
</context>
</TS>
