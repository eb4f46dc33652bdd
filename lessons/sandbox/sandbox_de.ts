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
    <message>
        <source>Magnets</source>
        <translation>Magnete</translation>
    </message>
    <message>
        <source>Seven magnets find each other. Pull one away and let go.</source>
        <translation>Sieben Magnete finden zueinander. Zieh einen weg und lass los.</translation>
    </message>
    <message>
        <source>Wind profile</source>
        <translation>Wind am Boden</translation>
    </message>
    <message>
        <source>The wind is slow near the ground and fast high up. Change how fast it grows with the height.</source>
        <translation>Am Boden weht der Wind schwach, oben stark. Ändere, wie schnell er mit der Höhe zunimmt.</translation>
    </message>
    <message>
        <source>Hardening spring</source>
        <translation>Harte Feder</translation>
    </message>
    <message>
        <source>The right spring hardens when it stretches, so it swings faster. Pull both down equally far.</source>
        <translation>Die rechte Feder wird beim Dehnen härter, darum schwingt sie schneller. Zieh beide gleich weit nach unten.</translation>
    </message>
    <message>
        <source>Planet</source>
        <translation>Planet</translation>
    </message>
    <message>
        <source>A planet on a circle and a comet on an ellipse. Write another power of the distance than 3.</source>
        <translation>Ein Planet auf einem Kreis und ein Komet auf einer Ellipse. Schreib eine andere Potenz des Abstands als 3.</translation>
    </message>
    <message>
        <source>Pumped swing</source>
        <translation>Angestoßene Schaukel</translation>
    </message>
    <message>
        <source>A motor pushes a swing in its own rhythm. Change the rhythm a little: the swing stays low.</source>
        <translation>Ein Motor stößt eine Schaukel in ihrem eigenen Takt an. Ändere den Takt ein wenig: Sie bleibt niedrig.</translation>
    </message>
    <message>
        <source>Drag of the air</source>
        <translation>Luftwiderstand</translation>
    </message>
    <message>
        <source>The drag grows with the square of the speed: fast swings end soon, slow ones go on.</source>
        <translation>Der Widerstand wächst mit dem Quadrat der Geschwindigkeit: Schnelles Schwingen endet bald, langsames dauert an.</translation>
    </message>
    <message>
        <source>Flock</source>
        <translation>Schwarm</translation>
    </message>
    <message>
        <source>Twenty dots that watch their neighbours. Remove one of the three habits.</source>
        <translation>Zwanzig Punkte, die auf ihre Nachbarn achten. Nimm eine der drei Gewohnheiten weg.</translation>
    </message>
    <message>
        <source>Whirlpool</source>
        <translation>Strudel</translation>
    </message>
    <message>
        <source>Water carries bodies round its middle. Let the water turn the other way.</source>
        <translation>Wasser trägt Körper um seine Mitte. Lass das Wasser andersherum kreisen.</translation>
    </message>
    <message>
        <source>Leash</source>
        <translation>Leine</translation>
    </message>
    <message>
        <source>A leash pulls only when it is tight. Make it longer, or tie a third dog to it.</source>
        <translation>Eine Leine zieht nur, wenn sie gespannt ist. Mach sie länger oder binde einen dritten Hund an.</translation>
    </message>
    <message>
        <source>Hovering platform</source>
        <translation>Schwebende Plattform</translation>
    </message>
    <message>
        <source>A platform compares its place with its goal, and follows your pointer. Change how hard it corrects.</source>
        <translation>Eine Plattform vergleicht ihren Ort mit ihrem Ziel und folgt deinem Zeiger. Ändere, wie stark sie korrigiert.</translation>
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
    <message>
        <source>ball</source>
        <translation>Ball</translation>
    </message>
    <message>
        <source>left</source>
        <translation>links</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>right</source>
        <translation>rechts</translation>
    </message>
    <message>
        <source>load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>post</source>
        <translation>Pfosten</translation>
    </message>
    <message>
        <source>dog</source>
        <translation>Hund</translation>
    </message>
    <message>
        <source>puppy</source>
        <translation>Welpe</translation>
    </message>
    <message>
        <source>sun</source>
        <translation>Sonne</translation>
    </message>
    <message>
        <source>planet</source>
        <translation>Planet</translation>
    </message>
    <message>
        <source>comet</source>
        <translation>Komet</translation>
    </message>
    <message>
        <source>nail</source>
        <translation>Nagel</translation>
    </message>
    <message>
        <source>seat</source>
        <translation>Sitz</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>Fuß</translation>
    </message>
    <message>
        <source>body</source>
        <translation>Körper</translation>
    </message>
</context>
</TS>
