<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>Conditions</name>
    <message>
        <source>take it with the mouse, and let go of it.</source>
        <translation>nimm es mit der Maus und lass es los.</translation>
    </message>
    <message>
        <source>let go while the mouse moves, at %2&#x202f;px per frame or more. Yours left at %1.</source>
        <translation>lass los, während sich die Maus bewegt, mit %2&#x202f;px pro Bild oder mehr. Losgelassen wurde bei %1.</translation>
    </message>
    <message>
        <source>take it with the mouse.</source>
        <translation>nimm es mit der Maus.</translation>
    </message>
    <message>
        <source>take it with the mouse, and hold it.</source>
        <translation>nimm es mit der Maus und halte es.</translation>
    </message>
    <message>
        <source>carry it %2&#x202f;px or more. It came %1&#x202f;px.</source>
        <translation>trag es %2&#x202f;px weit oder mehr. Es kam %1&#x202f;px weit.</translation>
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
        <source>%1 is not a heading of a lesson. Write “## Try {#id}”, “## Task: title {#id}”, “## Word: name”, “## Why: question” or “## Learnt”.</source>
        <translation>%1 ist keine Überschrift einer Lektion. Schreib „## Try {#id}“, „## Task: Titel {#id}“, „## Word: Name“, „## Why: Frage“ oder „## Learnt“.</translation>
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
        <source>the listing has no gap “%1”. Use one of: %2.</source>
        <translation>Das Listing hat keine Lücke „%1“. Verwende eine von: %2.</translation>
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
</TS>
