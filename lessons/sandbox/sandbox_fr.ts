<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>Sandbox</name>
    <message>
        <source>Chain</source>
        <translation>Chaîne</translation>
    </message>
    <message>
        <source>Seven sticks on a nail. Pull the end aside and let go.</source>
        <translation>Sept tiges à un clou. Tire le bout sur le côté et lâche.</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>Pont</translation>
    </message>
    <message>
        <source>A truss between two nails, with a load on a spring. Make the load heavier.</source>
        <translation>Un treillis entre deux clous, avec une charge à un ressort. Alourdis la charge.</translation>
    </message>
    <message>
        <source>Jelly</source>
        <translation>Gelée</translation>
    </message>
    <message>
        <source>A grid of springs. Throw it into a corner.</source>
        <translation>Une grille de ressorts. Lance-la dans un coin.</translation>
    </message>
    <message>
        <source>Walker</source>
        <translation>Marcheur</translation>
    </message>
    <message>
        <source>Four feet in two gait groups, which turns round at the walls.</source>
        <translation>Quatre pieds en deux groupes d’allure, qui fait demi-tour face aux murs.</translation>
    </message>
    <message>
        <source>Cradle</source>
        <translation>Pendule de Newton</translation>
    </message>
    <message>
        <source>Five balls side by side: what comes in on the left goes out on the right.</source>
        <translation>Cinq boules côte à côte&#xa0;: ce qui arrive à gauche repart à droite.</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Roue</translation>
    </message>
    <message>
        <source>A rim of sticks with springs for spokes, on a floor that holds.</source>
        <translation>Une jante de tiges avec des ressorts pour rayons, sur un sol qui accroche.</translation>
    </message>
    <message>
        <source>Cloth</source>
        <translation>Tissu</translation>
    </message>
    <message>
        <source>A net of springs on three nails, in a little wind.</source>
        <translation>Un filet de ressorts à trois clous, dans un peu de vent.</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Arbre</translation>
    </message>
    <message>
        <source>A trunk of braced springs whose leaves catch the wind.</source>
        <translation>Un tronc de ressorts à renforts, dont les feuilles prennent le vent.</translation>
    </message>
    <message>
        <source>Ragdoll</source>
        <translation>Pantin</translation>
    </message>
    <message>
        <source>Fourteen sticks that fall. Lift it by a hand.</source>
        <translation>Quatorze tiges qui tombent. Soulève-le par une main.</translation>
    </message>
    <message>
        <source>Trampoline</source>
        <translation>Trampoline</translation>
    </message>
    <message>
        <source>A heavy ball on a net of springs, and bodies that push each other away.</source>
        <translation>Une balle lourde sur un filet de ressorts, et des corps qui se repoussent.</translation>
    </message>
    <message>
        <source>Crystal</source>
        <translation>Cristal</translation>
    </message>
    <message>
        <source>Positive and negative charges find each other and form a crystal. Give one the other sign.</source>
        <translation>Des charges positives et négatives se trouvent et forment un cristal. Donne à l’une l’autre signe.</translation>
    </message>
    <message>
        <source>Magnets</source>
        <translation>Aimants</translation>
    </message>
    <message>
        <source>Seven magnets find each other. Pull one away and let go.</source>
        <translation>Sept aimants se trouvent. Éloignes-en un et lâche.</translation>
    </message>
    <message>
        <source>Wind profile</source>
        <translation>Vent près du sol</translation>
    </message>
    <message>
        <source>The wind is slow near the ground and fast high up. Change how fast it grows with the height.</source>
        <translation>Le vent est lent près du sol et rapide en hauteur. Change la façon dont il croît avec la hauteur.</translation>
    </message>
    <message>
        <source>Hardening spring</source>
        <translation>Ressort durcissant</translation>
    </message>
    <message>
        <source>The right spring hardens when it stretches, so it swings faster. Pull both down equally far.</source>
        <translation>Le ressort de droite durcit en s’étirant, donc il oscille plus vite. Tire les deux aussi bas.</translation>
    </message>
    <message>
        <source>Planet</source>
        <translation>Planète</translation>
    </message>
    <message>
        <source>A planet on a circle and a comet on an ellipse. Write another power of the distance than 3.</source>
        <translation>Une planète sur un cercle et une comète sur une ellipse. Écris une autre puissance de la distance que 3.</translation>
    </message>
    <message>
        <source>Pumped swing</source>
        <translation>Balançoire poussée</translation>
    </message>
    <message>
        <source>A motor pushes a swing in its own rhythm. Change the rhythm a little: the swing stays low.</source>
        <translation>Un moteur pousse une balançoire à son propre rythme. Change un peu le rythme&#xa0;: elle reste basse.</translation>
    </message>
    <message>
        <source>Drag of the air</source>
        <translation>Résistance de l’air</translation>
    </message>
    <message>
        <source>The drag grows with the square of the speed: fast swings end soon, slow ones go on.</source>
        <translation>La résistance grandit avec le carré de la rapidité&#xa0;: les oscillations rapides finissent vite, les lentes durent.</translation>
    </message>
    <message>
        <source>Flock</source>
        <translation>Nuée</translation>
    </message>
    <message>
        <source>Twenty dots that watch their neighbours. Remove one of the three habits.</source>
        <translation>Vingt points qui surveillent leurs voisins. Enlève l’une des trois habitudes.</translation>
    </message>
    <message>
        <source>Whirlpool</source>
        <translation>Tourbillon</translation>
    </message>
    <message>
        <source>Water carries bodies round its middle. Let the water turn the other way.</source>
        <translation>L’eau porte des corps autour de son milieu. Fais tourner l’eau dans l’autre sens.</translation>
    </message>
    <message>
        <source>Leash</source>
        <translation>Laisse</translation>
    </message>
    <message>
        <source>A leash pulls only when it is tight. Make it longer, or tie a third dog to it.</source>
        <translation>Une laisse ne tire que si elle est tendue. Allonge-la, ou attaches-y un troisième chien.</translation>
    </message>
    <message>
        <source>Hovering platform</source>
        <translation>Plateforme flottante</translation>
    </message>
    <message>
        <source>A platform compares its place with its goal, and follows your pointer. Change how hard it corrects.</source>
        <translation>Une plateforme compare sa place à son but, et suit ton pointeur. Change la force de sa correction.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Build your own</source>
        <translation>Construis la tienne</translation>
    </message>
    <message>
        <source>Points, springs, sticks, feet and walls: a scene that you build yourself.</source>
        <translation>Points, ressorts, tiges, pieds et murs&#xa0;: une scène que tu construis toi-même.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>points</source>
        <translation>points</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>balle</translation>
    </message>
    <message>
        <source>left</source>
        <translation>gauche</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>milieu</translation>
    </message>
    <message>
        <source>right</source>
        <translation>droite</translation>
    </message>
    <message>
        <source>load</source>
        <translation>charge</translation>
    </message>
    <message>
        <source>post</source>
        <translation>poteau</translation>
    </message>
    <message>
        <source>dog</source>
        <translation>chien</translation>
    </message>
    <message>
        <source>puppy</source>
        <translation>chiot</translation>
    </message>
    <message>
        <source>sun</source>
        <translation>soleil</translation>
    </message>
    <message>
        <source>planet</source>
        <translation>planète</translation>
    </message>
    <message>
        <source>comet</source>
        <translation>comète</translation>
    </message>
    <message>
        <source>nail</source>
        <translation>clou</translation>
    </message>
    <message>
        <source>seat</source>
        <translation>siège</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>pied</translation>
    </message>
    <message>
        <source>body</source>
        <translation>corps</translation>
    </message>
</context>
</TS>
