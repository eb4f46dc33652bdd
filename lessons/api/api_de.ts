<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Conditions</name>
    <message>
        <source>take it with the mouse, and let go of it.</source>
        <translation>greif mit der Maus zu und lass wieder los.</translation>
    </message>
    <message>
        <source>let go while the mouse moves, at %2&#x202f;px per frame or more. You let go at %1.</source>
        <translation>lass los, während sich die Maus bewegt, mit %2&#x202f;px pro Bild oder mehr. Du hast bei %1 losgelassen.</translation>
    </message>
    <message>
        <source>take it with the mouse.</source>
        <translation>greif mit der Maus zu.</translation>
    </message>
    <message>
        <source>take it with the mouse, and hold it.</source>
        <translation>greif mit der Maus zu und halte fest.</translation>
    </message>
    <message>
        <source>carry it %2&#x202f;px or more. It came %1&#x202f;px.</source>
        <translation>trag weiter: %2&#x202f;px oder mehr. Es waren %1&#x202f;px.</translation>
    </message>
    <message>
        <source>let time run (**Space**) until nothing moves.</source>
        <translation>lass die Zeit laufen (**Leertaste**), bis sich nichts mehr bewegt.</translation>
    </message>
    <message>
        <source>hands off, and let time run for %2&#x202f;frames. So far: %1.</source>
        <translation>Hände weg, und lass die Zeit %2&#x202f;Bilder lang laufen. Bisher: %1.</translation>
    </message>
    <message>
        <source>let time run for %2&#x202f;frames with this value. So far: %1.</source>
        <translation>lass die Zeit mit diesem Wert %2&#x202f;Bilder lang laufen. Bisher: %1.</translation>
    </message>
    <message>
        <source>go on to frame %2. This is frame %1.</source>
        <translation>geh weiter bis Bild %2. Das hier ist Bild %1.</translation>
    </message>
    <message>
        <source>stop, show the page **Engine** of the code, and go into a frame: **Shift+→**.</source>
        <translation>halte an, zeig beim Code die Seite **Engine** und geh in ein Bild hinein: **Umschalt+→**.</translation>
    </message>
    <message>
        <source>press **Shift+→** or **Shift+←** until a spring has pulled and nothing has moved.</source>
        <translation>drück **Umschalt+→** oder **Umschalt+←**, bis eine Feder gezogen hat und sich nichts bewegt hat.</translation>
    </message>
    <message>
        <source>play on for 10&#x202f;frames from where the two part. So far: %1.</source>
        <translation>spiele von dort, wo sich die beiden trennen, 10&#x202f;Bilder weiter. Bisher: %1.</translation>
    </message>
</context>
<context>
    <name>Document</name>
    <message>
        <source>the story is missing. Write it below the title.</source>
        <translation>Die Erzählung fehlt. Schreib sie unter den Titel.</translation>
    </message>
    <message>
        <source>there is no text below %1. Write it there, or remove the heading.</source>
        <translation>Unter %1 steht kein Text. Schreib ihn dorthin oder entferne die Überschrift.</translation>
    </message>
    <message>
        <source>%1 has no id. End the heading with “{#id}”, where id is made of a to z, 0 to 9 and _.</source>
        <translation>%1 hat keine Kennung. Beende die Überschrift mit „{#id}“; eine Kennung besteht aus a bis z, 0 bis 9 und _.</translation>
    </message>
    <message>
        <source>the id “%1” was used above. Choose another one.</source>
        <translation>Die Kennung „%1“ steht weiter oben schon. Wähle eine andere.</translation>
    </message>
    <message>
        <source>%1 is incomplete. Write “## %2: ” and a text after it.</source>
        <translation>%1 ist unvollständig. Schreib „## %2: “ und einen Text dahinter.</translation>
    </message>
    <message>
        <source>%1 does not belong here. Here you can write %2.</source>
        <translation>%1 gehört nicht hierher. Hier kannst du %2 schreiben.</translation>
    </message>
    <message>
        <source>%1 does not belong here. Remove it, or write it below a “## Try”.</source>
        <translation>%1 gehört nicht hierher. Entferne die Überschrift oder schreib sie unter ein „## Try“.</translation>
    </message>
    <message>
        <source>%1 is there twice. Remove one of them.</source>
        <translation>%1 steht zweimal da. Entferne eins davon.</translation>
    </message>
    <message>
        <source>the thing to try “%1” has no hint. Write it below a “### Hint”.</source>
        <translation>Der Versuch „%1“ hat keinen Tipp. Schreib ihn unter ein „### Hint“.</translation>
    </message>
    <message>
        <source>“%1” has no name. Write “- name: sentence”, where the name is made of a to z, 0 to 9 and _.</source>
        <translation>„%1“ hat keinen Namen. Schreib „- name: Satz“; ein Name besteht aus a bis z, 0 bis 9 und _.</translation>
    </message>
    <message>
        <source>the name “%1” is there twice. Remove one of the sentences.</source>
        <translation>Der Name „%1“ steht zweimal da. Entferne einen der Sätze.</translation>
    </message>
    <message>
        <source>the task “%1” has no title. Write “## Task: title {#%1}”.</source>
        <translation>Die Aufgabe „%1“ hat keinen Titel. Schreib „## Task: Titel {#%1}“.</translation>
    </message>
    <message>
        <source>the task “%1” has no comment for the empty place. Write it below a “### Comment”.</source>
        <translation>Die Aufgabe „%1“ hat keinen Kommentar für die leere Stelle. Schreib ihn unter ein „### Comment“.</translation>
    </message>
    <message>
        <source>the number of hints of the task “%1” is %2, not 3. Write each below a “### Hint”.</source>
        <translation>Die Aufgabe „%1“ hat nicht 3 Tipps, sondern %2. Schreib jeden unter ein eigenes „### Hint“.</translation>
    </message>
    <message>
        <source>this near miss is incomplete. Write its code between two lines ```, and below it a sentence about what the code does.</source>
        <translation>Dieser Beinahe-Treffer ist unvollständig. Schreib seinen Code zwischen zwei Zeilen ``` und darunter einen Satz darüber, was der Code tut.</translation>
    </message>
    <message>
        <source>the word “%1” is there twice. Remove one of them.</source>
        <translation>Das Wort „%1“ steht zweimal da. Entferne eins davon.</translation>
    </message>
    <message>
        <source>the word “%1” is not explained. Write one to three sentences, after a blank line.</source>
        <translation>Das Wort „%1“ ist nicht erklärt. Schreib nach einer Leerzeile einen bis drei Sätze.</translation>
    </message>
    <message>
        <source>%1, line %2: %3</source>
        <translation>%1, Zeile %2: %3</translation>
    </message>
    <message>
        <source>en</source>
        <extracomment>The code of the language of this file, for the lessons&apos; documents: de, fr</extracomment>
        <translation>de</translation>
    </message>
    <message>
        <source>the file is missing. Write it, and configure the build again.</source>
        <translation>Die Datei fehlt. Schreib sie und konfiguriere den Build neu.</translation>
    </message>
    <message>
        <source>the thing to try “%1” has choices, but no answer. Write it below an “### Answer”.</source>
        <translation>die Aufgabe „%1“ hat Antworten zur Wahl, aber keine Auflösung. Schreib sie unter ein „### Answer“.</translation>
    </message>
    <message>
        <source>the title of the concept “%1” has %2 characters. Write 1 to %3, as in “## Concept: title {#%1}”.</source>
        <translation>Der Titel des Begriffs „%1“ hat %2 Zeichen. Schreib 1 bis %3, wie in „## Concept: title {#%1}“.</translation>
    </message>
    <message>
        <source>the concept “%1” needs one paragraph besides “Rests on: …”. Write one sentence there.</source>
        <translation>Der Begriff „%1“ braucht einen Absatz neben „Rests on: …“. Schreib dort einen Satz.</translation>
    </message>
    <message>
        <source>a condition cannot be called “%1”. Give it a name of its own, made of a to z, 0 to 9 and _.</source>
        <translation>Eine Bedingung kann nicht „%1“ heißen. Gib ihr einen eigenen Namen aus a bis z, 0 bis 9 und _.</translation>
    </message>
    <message>
        <source>this run needs “- frames: ” and the number of frames in which the thing is done, and has no “until” and no “step”.</source>
        <translation>Dieser Lauf braucht „- frames: “ und die Zahl der Bilder, in denen es getan ist, und hat kein „until“ und kein „step“.</translation>
    </message>
    <message>
        <source>%1 is not a heading of a lesson. Write “## Try {#id}”, “## Predict {#id}”, “## Task: title {#id}”, “## Parameter: name {#id}”, “## Word: name”, “## Concept: title {#id}”, “## Why: question” or “## Learnt”.</source>
        <translation>%1 ist keine Überschrift einer Lektion. Schreib „## Try {#id}“, „## Predict {#id}“, „## Task: Titel {#id}“, „## Parameter: Name {#id}“, „## Word: Name“, „## Concept: Titel {#id}“, „## Why: Frage“ oder „## Learnt“.</translation>
    </message>
    <message>
        <source>the parameter “%1” has no name. Write “## Parameter: name {#%1}”.</source>
        <translation>Der Parameter „%1“ hat keinen Namen. Schreib „## Parameter: Name {#%1}“.</translation>
    </message>
</context>
<context>
    <name>DocumentScan</name>
    <message>
        <source>this is not UTF-8. Save the file with the encoding UTF-8.</source>
        <translation>Das ist kein UTF-8. Speichere die Datei mit der Kodierung UTF-8.</translation>
    </message>
    <message>
        <source>the title is missing. Begin the file with “# ” and the title of the step.</source>
        <translation>Der Titel fehlt. Beginne die Datei mit „# “ und dem Titel des Schritts.</translation>
    </message>
    <message>
        <source>this is a second title. Write “## ” instead.</source>
        <translation>Das ist ein zweiter Titel. Schreib stattdessen „## “.</translation>
    </message>
    <message>
        <source>the code has no end. Write ``` on a line of its own after it.</source>
        <translation>Der Code hat kein Ende. Schreib dahinter ``` auf eine eigene Zeile.</translation>
    </message>
    <message>
        <source>a space is missing after “#”. Write the heading as in “## Learnt”.</source>
        <translation>Nach „#“ fehlt ein Leerzeichen. Schreib die Überschrift wie in „## Learnt“.</translation>
    </message>
</context>
<context>
    <name>Formula</name>
    <message>
        <source>braces belong behind a formula, which is a paragraph of its own in backticks. Write them there, or remove them.</source>
        <translation>geschweifte Klammern gehören hinter eine Formel, also einen eigenen Absatz in Backticks. Schreib sie dorthin oder lösch sie.</translation>
    </message>
    <message>
        <source>“%1” is nothing that a formula can highlight. Write the name of a body or a parameter, “a -&gt; b”, “a -&gt; b x”, “a -&gt; b y”, “a.velocity”, or “circle a parameter”, with commas between them.</source>
        <translation>„%1“ kann eine Formel nicht markieren. Schreib den Namen eines Körpers oder eines Parameters, „a -&gt; b“, „a -&gt; b x“, „a -&gt; b y“, „a.velocity“ oder „circle a parameter“, mit Kommas dazwischen.</translation>
    </message>
    <message>
        <source>“%1” in the braces is not there in this step. It has the bodies %2, and the parameters %3.</source>
        <translation>„%1“ in den geschweiften Klammern gibt es in diesem Schritt nicht. Er hat die Körper %2 und die Parameter %3.</translation>
    </message>
</context>
<context>
    <name>Join</name>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>the thing to try “%1” says nothing about what is missing for “%2”. Write “- %2: sentence” below its “### Missing”.</source>
        <translation>Der Versuch „%1“ sagt nicht, was für „%2“ noch fehlt. Schreib „- %2: Satz“ unter sein „### Missing“.</translation>
    </message>
    <message>
        <source>the thing to try “%1” has no condition “%2”. Remove the sentence, or give it one of the names: %3.</source>
        <translation>Der Versuch „%1“ hat keine Bedingung „%2“. Entferne den Satz oder gib ihm einen dieser Namen: %3.</translation>
    </message>
    <message>
        <source>the thing to try “%1” is unknown. Use one of the ids of this step: %2.</source>
        <translation>Den Versuch „%1“ gibt es nicht. Verwende eine der Kennungen dieses Schritts: %2.</translation>
    </message>
    <message>
        <source>the thing to try “%1” is missing. Write “## Try {#%1}” and its text.</source>
        <translation>Der Versuch „%1“ fehlt. Schreib „## Try {#%1}“ und seinen Text.</translation>
    </message>
    <message>
        <source>the listing has no gap “%1”. In %2, put the lines that learners write between “//&gt; %1” and “//&lt;”.</source>
        <translation>Das Listing hat keine Lücke „%1“. Setz in %2 die Zeilen, die Lernende schreiben, zwischen „//&gt; %1“ und „//&lt;“.</translation>
    </message>
    <message>
        <source>the listing has no gap “%1”. Use one of: %2.</source>
        <translation>Das Listing hat keine Lücke „%1“. Verwende eine von: %2.</translation>
    </message>
    <message>
        <source>the step has no parameter “%1”. Remove the heading: only lessons without C++ declare parameters in a document.</source>
        <translation>Der Schritt hat keinen Parameter „%1“. Entferne die Überschrift: Nur Lektionen ohne C++ legen Parameter in einem Text an.</translation>
    </message>
</context>
<context>
    <name>ListingText</name>
    <message>
        <source>line %1: %2</source>
        <translation>Zeile %1: %2</translation>
    </message>
    <message>
        <source>this gap begins inside another one. Write “//&lt;” where that one ends.</source>
        <translation>Diese Lücke beginnt in einer anderen. Schreib „//&lt;“ dorthin, wo die andere endet.</translation>
    </message>
    <message>
        <source>a gap needs an id that no other gap has. Write it after “//&gt;”.</source>
        <translation>Eine Lücke braucht eine Kennung, die keine andere hat. Schreib sie hinter „//&gt;“.</translation>
    </message>
    <message>
        <source>no gap begins before this “//&lt;”. Write “//&gt; id” there, or remove it.</source>
        <translation>Vor diesem „//&lt;“ beginnt keine Lücke. Schreib dort „//&gt; id“ oder nimm es heraus.</translation>
    </message>
    <message>
        <source>the gap has no code. Write it above this line, or remove the gap.</source>
        <translation>Die Lücke hat keinen Code. Schreib ihn über diese Zeile oder nimm die Lücke heraus.</translation>
    </message>
    <message>
        <source>the last gap has no end. Write “//&lt;” after its code.</source>
        <translation>Die letzte Lücke hat kein Ende. Schreib „//&lt;“ hinter ihren Code.</translation>
    </message>
</context>
<context>
    <name>ParameterText</name>
    <message>
        <source>a parameter has no “%1”. It has “value”, “minimum”, “maximum”, “step”, “unit” and “sets”.</source>
        <translation>Ein Parameter hat kein „%1“. Er hat „value“, „minimum“, „maximum“, „step“, „unit“ und „sets“.</translation>
    </message>
    <message>
        <source>“%1” is there twice. Remove one of them.</source>
        <translation>„%1“ steht zweimal da. Nimm eins davon heraus.</translation>
    </message>
    <message>
        <source>“%1” is not a number between -1000000000 and 1000000000. Write it as in “- %2: 2”.</source>
        <translation>„%1“ ist keine Zahl zwischen -1000000000 und 1000000000. Schreib sie wie in „- %2: 2“.</translation>
    </message>
    <message>
        <source>the step cannot be %1. Write one of these: %2.</source>
        <translation>Der Schritt kann nicht %1 sein. Schreib eins davon: %2.</translation>
    </message>
    <message>
        <source>this unit has %1 characters. Write at most %2.</source>
        <translation>Diese Einheit hat %1 Zeichen. Schreib höchstens %2.</translation>
    </message>
    <message>
        <source>the name of the parameter “%1” has %2 characters. Write at most %3.</source>
        <translation>Der Name des Parameters „%1“ hat %2 Zeichen. Schreib höchstens %3.</translation>
    </message>
    <message>
        <source>nothing says what the parameter “%1” does. Write one sentence below its heading.</source>
        <translation>Nirgends steht, was der Parameter „%1“ bewirkt. Schreib einen Satz unter seine Überschrift.</translation>
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
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>1/frame²</source>
        <translation>1/Bild²</translation>
    </message>
    <message>
        <source>How hard a spring pulls: this share of the missing distance, each frame.</source>
        <translation>Wie stark eine Feder zieht: dieser Anteil des fehlenden Abstands, in jedem Bild.</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Radius</translation>
    </message>
    <message>
        <source>The distance that the spring keeps.</source>
        <translation>Der Abstand, den die Feder hält.</translation>
    </message>
    <message>
        <source>Offset</source>
        <translation>Versatz</translation>
    </message>
    <message>
        <source>How far to the right of the body the spring ends. Below 0: to the left.</source>
        <translation>Wie weit rechts vom Körper die Feder endet. Unter 0: links davon.</translation>
    </message>
    <message>
        <source>Feet</source>
        <translation>Füße</translation>
    </message>
    <message>
        <source>How many feet the body has.</source>
        <translation>Wie viele Füße der Körper hat.</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>Mitte x</translation>
    </message>
    <message>
        <source>How far to the right the cross is.</source>
        <translation>Wie weit rechts das Kreuz ist.</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>Mitte y</translation>
    </message>
    <message>
        <source>How far down the cross is.</source>
        <translation>Wie weit unten das Kreuz ist.</translation>
    </message>
</context>
<context>
    <name>Predict</name>
    <message>
        <source>the question of the prediction “%1” is missing. Write it below the heading.</source>
        <translation>die Frage der Vorhersage „%1“ fehlt. Schreib sie unter die Überschrift.</translation>
    </message>
    <message>
        <source>“### %1” does not belong here. Here you can write “### Run”, “### Ask”, “### Other curve”, “### Answer”.</source>
        <translation>„### %1“ gehört nicht hierher. Hier kannst du „### Run“, „### Ask“, „### Other curve“ und „### Answer“ schreiben.</translation>
    </message>
    <message>
        <source>“### %1” is there twice. Remove one of them.</source>
        <translation>„### %1“ steht zweimal da. Nimm eins davon heraus.</translation>
    </message>
    <message>
        <source>“%1” does not belong here. A prediction asks one question, and can have a “- unit: px” after it.</source>
        <translation>„%1“ gehört nicht hierher. Eine Vorhersage stellt eine Frage, und danach kann „- unit: px“ stehen.</translation>
    </message>
    <message>
        <source>“%1” cannot be asked. Write “- place: body”, “- number: frames”, “- number: foot.x” or “- curve: foot.x”.</source>
        <translation>Nach „%1“ kann man nicht fragen. Schreib „- place: body“, „- number: frames“, „- number: foot.x“ oder „- curve: foot.x“.</translation>
    </message>
    <message>
        <source>the prediction “%1” is incomplete. Write “### %2” and what belongs below it.</source>
        <translation>die Vorhersage „%1“ ist unvollständig. Schreib „### %2“ und darunter, was dazugehört.</translation>
    </message>
    <message>
        <source>this run has no end. Write “- frames: ” and the frame at which it ends at the latest.</source>
        <translation>dieser Lauf hat kein Ende. Schreib „- frames: “ und das Bild, bei dem er spätestens endet.</translation>
    </message>
    <message>
        <source>the number of frames is given away by the run. Write “- until: ” and the condition at which it ends.</source>
        <translation>der Lauf verrät die Anzahl der Bilder. Schreib „- until: “ und die Bedingung, bei der er endet.</translation>
    </message>
    <message>
        <source>the number of other curves of the prediction “%1” is %2, not 2. Write each below an “### Other curve”.</source>
        <translation>die Vorhersage „%1“ hat %2 andere Kurven statt 2. Schreib jede unter ein „### Other curve“.</translation>
    </message>
    <message>
        <source>“### Other curve” does not belong here. Remove it, or ask for a “- curve: ”.</source>
        <translation>„### Other curve“ gehört nicht hierher. Nimm es heraus oder frag nach einer „- curve: “.</translation>
    </message>
    <message>
        <source>“%1” is not a choice. Write “- [ ] text”, or “- [x] text” if it is right.</source>
        <translation>„%1“ ist keine Antwort zur Wahl. Schreib „- [ ] Text“ oder „- [x] Text“, wenn sie stimmt.</translation>
    </message>
    <message>
        <source>the number of choices is %1. Write two to four.</source>
        <translation>es gibt %1 Antworten zur Wahl. Schreib zwei bis vier.</translation>
    </message>
    <message>
        <source>the number of right choices is %1, not 1. Write “- [x] ” before the right one.</source>
        <translation>%1 Antworten sind als richtig markiert statt 1. Schreib „- [x] “ vor die richtige.</translation>
    </message>
</context>
<context>
    <name>Project</name>
    <message>
        <source>the brief is missing. Write it below the title.</source>
        <translation>die Aufgabe fehlt. Schreib sie unter den Titel.</translation>
    </message>
    <message>
        <source>the number of levels is %1, not 3. Write each below a “## Level: title {#id}”.</source>
        <translation>die Zahl der Stufen ist %1, nicht 3. Schreib jede unter ein „## Level: Titel {#id}“.</translation>
    </message>
    <message>
        <source>“## %1” is not a heading of a project. Write “## Level: title {#id}”.</source>
        <translation>„## %1“ ist keine Überschrift eines Projekts. Schreib „## Level: Titel {#id}“.</translation>
    </message>
    <message>
        <source>the id “%1” was used above. Choose another one.</source>
        <translation>die Kennung „%1“ kommt oben schon vor. Nimm eine andere.</translation>
    </message>
    <message>
        <source>“### %1” is there twice. Remove one of them.</source>
        <translation>„### %1“ steht zweimal da. Entferne eines davon.</translation>
    </message>
    <message>
        <source>“### %1” does not belong here. Here you can write “### Run”, “### Holds”, “### Show”, “### Hint”.</source>
        <translation>„### %1“ gehört nicht hierher. Hier kannst du „### Run“, „### Holds“, „### Show“, „### Hint“ schreiben.</translation>
    </message>
    <message>
        <source>“%1: %2” is not a ring. Write its place and radius in px: “- ring: 300, 220, 12”.</source>
        <translation>„%1: %2“ ist kein Ring. Schreib seinen Ort und Radius in px: „- ring: 300, 220, 12“.</translation>
    </message>
    <message>
        <source>“%1” is not a list of names. Write “- %2: one, other”.</source>
        <translation>„%1“ ist keine Liste von Namen. Schreib „- %2: eins, anderes“.</translation>
    </message>
    <message>
        <source>“%1” is not a condition. Write “- always `condition`: sentence”, or “once”, “at the start” or “at the end” in place of “always”.</source>
        <translation>„%1“ ist keine Bedingung. Schreib „- always `condition`: Satz“, oder „once“, „at the start“ oder „at the end“ statt „always“.</translation>
    </message>
    <message>
        <source>the level “%1” does not say what it asks. Write it below the heading.</source>
        <translation>die Stufe „%1“ sagt nicht, was sie verlangt. Schreib es unter die Überschrift.</translation>
    </message>
    <message>
        <source>the level “%1” is incomplete. Write “### %2” and what belongs below it.</source>
        <translation>die Stufe „%1“ ist unvollständig. Schreib „### %2“ und was darunter gehört.</translation>
    </message>
    <message>
        <source>this run has no end. Write “- frames: ” and the number of frames to judge.</source>
        <translation>dieser Lauf hat kein Ende. Schreib „- frames: “ und die Zahl der Bilder, die beurteilt werden.</translation>
    </message>
    <message>
        <source>the run of a level has no “until” and no “step”. Remove them.</source>
        <translation>der Lauf einer Stufe hat kein „until“ und kein „step“. Entferne sie.</translation>
    </message>
</context>
<context>
    <name>Recall</name>
    <message>
        <source>there is no text below the title. Write one sentence there.</source>
        <translation>Unter dem Titel steht kein Text. Schreib dort einen Satz.</translation>
    </message>
    <message>
        <source>there is no question. Write “## Question {#id}” and its text.</source>
        <translation>Es gibt keine Frage. Schreib „## Question {#id}“ und ihren Text.</translation>
    </message>
    <message>
        <source>“## %1” is not a heading of a recall question. Write “## Question {#id}”, where id is made of a to z, 0 to 9 and _.</source>
        <translation>„## %1“ ist keine Überschrift einer Frage. Schreib „## Question {#id}“. Die id besteht aus a bis z, 0 bis 9 und _.</translation>
    </message>
    <message>
        <source>the id “%1” was used above. Choose another one.</source>
        <translation>Die id „%1“ kam oben schon vor. Nimm eine andere.</translation>
    </message>
    <message>
        <source>there is no text below “%1 %2”. Write it there, or remove the heading.</source>
        <translation>Unter „%1 %2“ steht kein Text. Schreib ihn dorthin oder entferne die Überschrift.</translation>
    </message>
    <message>
        <source>“### %1” does not belong here. Here you can write “### Right” and “### Wrong”, or “### Do” and “### Answer”.</source>
        <translation>„### %1“ gehört nicht hierher. Hier kannst du „### Right“ und „### Wrong“ schreiben oder „### Do“ und „### Answer“.</translation>
    </message>
    <message>
        <source>“### %1” is there twice. Remove one of them.</source>
        <translation>„### %1“ steht zweimal da. Entferne eins davon.</translation>
    </message>
    <message>
        <source>the question “%1” is incomplete. Write one “### Right” and one to three “### Wrong”, or “### Do” and “### Answer”.</source>
        <translation>Die Frage „%1“ ist unvollständig. Schreib ein „### Right“ und ein bis drei „### Wrong“ oder „### Do“ und „### Answer“.</translation>
    </message>
    <message>
        <source>the question “%1” has %2 choices. Keep four at most.</source>
        <translation>Die Frage „%1“ hat %2 Antworten zur Wahl. Behalte höchstens vier.</translation>
    </message>
    <message>
        <source>the choice begins with ```. Write its code in backticks.</source>
        <translation>Die Antwort beginnt mit ```. Schreib ihren Code zwischen einfache Gravis-Zeichen.</translation>
    </message>
    <message>
        <source>the choice has %1 characters. Make its first paragraph %2 or shorter, and explain it in the next one.</source>
        <translation>Die Antwort hat %1 Zeichen. Kürze ihren ersten Absatz auf %2 oder weniger und erkläre sie im nächsten.</translation>
    </message>
    <message>
        <source>this choice is not explained. Write why it is wrong below it, after a blank line.</source>
        <translation>Diese Antwort ist nicht erklärt. Schreib darunter, nach einer Leerzeile, warum sie falsch ist.</translation>
    </message>
    <message>
        <source>the scene is missing. Write “- step: lesson/step” in the list.</source>
        <translation>Die Szene fehlt. Schreib „- step: lesson/step“ in die Liste.</translation>
    </message>
    <message>
        <source>nothing says when this is done. Write “- until: condition” in the list.</source>
        <translation>Nichts sagt, wann es getan ist. Schreib „- until: condition“ in die Liste.</translation>
    </message>
    <message>
        <source>this run needs “- frames: ” and the number of frames in which it is done, and has no “until” and no “step”.</source>
        <translation>Dieser Lauf braucht „- frames: “ und die Zahl der Bilder, in denen es getan ist, und hat kein „until“ und kein „step“.</translation>
    </message>
</context>
<context>
    <name>RunSetupReaderText</name>
    <message>
        <source>“%1” is there twice. Remove one of them.</source>
        <translation>„%1“ steht zweimal da. Nimm eins davon heraus.</translation>
    </message>
    <message>
        <source>“%1” is not a number of frames. Write a whole number from 1 to %2.</source>
        <translation>„%1“ ist keine Anzahl von Bildern. Schreib eine ganze Zahl von 1 bis %2.</translation>
    </message>
    <message>
        <source>“%1” is not a place. Write x and y in px, as in “- %2: 300, 220”.</source>
        <translation>„%1“ ist kein Ort. Schreib x und y in px wie in „- %2: 300, 220“.</translation>
    </message>
    <message>
        <source>“%1” is incomplete. Write x and y in px and the number of frames, as in “- %2: 300, 220, 10”.</source>
        <translation>„%1“ ist unvollständig. Schreib x und y in px und die Anzahl der Bilder wie in „- %2: 300, 220, 10“.</translation>
    </message>
    <message>
        <source>“%1” does not belong in this list. Write “- name: value”, on one line.</source>
        <translation>„%1“ gehört nicht in diese Liste. Schreib „- Name: Wert“ in eine Zeile.</translation>
    </message>
    <message>
        <source>there is no list below “### %1”. Write “- name: value” there, or remove the heading.</source>
        <translation>unter „### %1“ steht keine Liste. Schreib dort „- Name: Wert“ oder nimm die Überschrift heraus.</translation>
    </message>
    <message>
        <source>nothing says which body to drag. Write its name, as in “- drag foot: %1”.</source>
        <translation>hier fehlt, welcher Körper gezogen wird. Schreib seinen Namen wie in „- drag foot: %1“.</translation>
    </message>
</context>
</TS>
