<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE" sourcelanguage="en">
<context>
    <name>Sandbox</name>
    <message>
        <source>Chain</source>
        <translation>Kette</translation>
    </message>
    <message>
        <source>Seven sticks on a nail. Pull the end aside and let go.</source>
        <translation>Sieben Stäbe an einem Nagel. Zieh das Ende zur Seite und lass los.</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>Brücke</translation>
    </message>
    <message>
        <source>A truss between two nails, with a load on a spring. Make the load heavier.</source>
        <translation>Ein Fachwerk zwischen zwei Nägeln, mit einer Last an einer Feder. Mach die Last schwerer.</translation>
    </message>
    <message>
        <source>Jelly</source>
        <translation>Götterspeise</translation>
    </message>
    <message>
        <source>A grid of springs. Throw it into a corner.</source>
        <translation>Ein Gitter aus Federn. Wirf es in eine Ecke.</translation>
    </message>
    <message>
        <source>Walker</source>
        <translation>Vierbeiner</translation>
    </message>
    <message>
        <source>Four feet in two gait groups, which turns round at the walls.</source>
        <translation>Vier Füße in zwei Ganggruppen; an den Wänden kehrt er um.</translation>
    </message>
    <message>
        <source>Cradle</source>
        <translation>Kugelpendel</translation>
    </message>
    <message>
        <source>Five balls side by side: what comes in on the left goes out on the right.</source>
        <translation>Fünf Kugeln nebeneinander: Was links ankommt, geht rechts hinaus.</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>A rim of sticks with springs for spokes, on a floor that holds.</source>
        <translation>Eine Felge aus Stäben mit Federn als Speichen, auf einem Boden, der hält.</translation>
    </message>
    <message>
        <source>Cloth</source>
        <translation>Tuch</translation>
    </message>
    <message>
        <source>A net of springs on three nails, in a little wind.</source>
        <translation>Ein Netz aus Federn an drei Nägeln, in leichtem Wind.</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Baum</translation>
    </message>
    <message>
        <source>A trunk of braced springs whose leaves catch the wind.</source>
        <translation>Ein Stamm aus verstrebten Federn, dessen Blätter den Wind fangen.</translation>
    </message>
    <message>
        <source>Ragdoll</source>
        <translation>Gliederpuppe</translation>
    </message>
    <message>
        <source>Fourteen sticks that fall. Lift it by a hand.</source>
        <translation>Vierzehn Stäbe, die fallen. Heb sie an einer Hand hoch.</translation>
    </message>
    <message>
        <source>Trampoline</source>
        <translation>Trampolin</translation>
    </message>
    <message>
        <source>A heavy ball on a net of springs, and bodies that push each other away.</source>
        <translation>Ein schwerer Ball auf einem Netz aus Federn, und Körper, die einander wegschieben.</translation>
    </message>
    <message>
        <source>Crystal</source>
        <translation>Kristall</translation>
    </message>
    <message>
        <source>Positive and negative charges find each other and form a crystal. Give one the other sign.</source>
        <translation>Positive und negative Ladungen finden sich und bilden einen Kristall. Gib einer das andere Vorzeichen.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Build your own</source>
        <translation>Selbst bauen</translation>
    </message>
    <message>
        <source>Points, springs, sticks, feet and walls: a scene that you build yourself.</source>
        <translation>Punkte, Federn, Stäbe, Füße und Wände: eine Szene, die du selbst baust.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
</context>
</TS>
