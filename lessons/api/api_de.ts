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
