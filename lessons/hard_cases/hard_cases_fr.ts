<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>HardCases</name>
    <message>
        <source>its steps are too long for what is so stiff</source>
        <translation>ses pas de temps sont trop longs pour une telle raideur</translation>
    </message>
    <message>
        <source>its steps are longer than those that the case’s sticks are measured by</source>
        <translation>ses pas de temps sont plus longs que ceux auxquels on mesure les tiges du cas</translation>
    </message>
    <message>
        <source>it swings on for longer than the run</source>
        <translation>il oscille encore après la fin de la simulation</translation>
    </message>
    <message>
        <source>it moves one body after the other</source>
        <translation>elle déplace les corps l’un après l’autre</translation>
    </message>
    <message>
        <source>it would need too many steps</source>
        <translation>il lui faudrait trop de pas de temps</translation>
    </message>
    <message>
        <source>its errors add up</source>
        <translation>ses erreurs s’accumulent</translation>
    </message>
    <message>
        <source>its errors keep it stirring</source>
        <translation>ses erreurs l’empêchent de se calmer</translation>
    </message>
    <message>
        <source>no place there is free</source>
        <translation>aucun endroit n’y est libre</translation>
    </message>
    <message>
        <source>it cannot compute all of it</source>
        <translation>elle ne peut pas tout calculer</translation>
    </message>
    <message>
        <source>You have changed it: nobody claims this.</source>
        <translation>Tu l’as modifié&#xa0;: personne ne promet cela.</translation>
    </message>
    <message>
        <source>%1 claims this case.</source>
        <translation>«&#x202f;%1&#x202f;» promet de tenir ce cas.</translation>
    </message>
    <message>
        <source>%1 does not claim it: %2.</source>
        <translation>«&#x202f;%1&#x202f;» ne le promet pas&#xa0;: %2.</translation>
    </message>
    <message>
        <source>out of its bounds since frame %1</source>
        <translation>hors de ses limites depuis l’image %1</translation>
    </message>
    <message>
        <source>within its bounds up to frame %1, the rest is not looked at yet</source>
        <translation>dans ses limites jusqu’à l’image %1, le reste n’est pas encore examiné</translation>
    </message>
    <message>
        <source>within its bounds so far</source>
        <translation>dans ses limites jusqu’ici</translation>
    </message>
    <message>
        <source>within its bounds so far, not at rest yet</source>
        <translation>dans ses limites jusqu’ici, pas encore au repos</translation>
    </message>
    <message>
        <source>within its bounds so far, and at rest, as it should be</source>
        <translation>dans ses limites jusqu’ici, et au repos, comme il se doit</translation>
    </message>
    <message>
        <source>%1
%2 Frame %3 of %4: %5.</source>
        <translation>%1
%2 Image %3 sur %4&#xa0;: %5.</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Cas</translation>
    </message>
    <message>
        <source>The experiment that runs. Another one begins at frame 0.</source>
        <translation>L’expérience en cours. Une autre commence à l’image 0.</translation>
    </message>
    <message>
        <source>How hard the springs of the case pull. 0: as hard as the case has it.</source>
        <translation>Force des ressorts du cas. 0&#xa0;: celle que le cas prévoit.</translation>
    </message>
    <message>
        <source>the middle moved %1&#x2009;px</source>
        <translation>le milieu s’est déplacé de %1&#x202f;px</translation>
    </message>
    <message>
        <source>Longest</source>
        <translation>Longueur max.</translation>
    </message>
    <message>
        <source>The length of the third stick. The other two are 20&#x2009;px long.</source>
        <translation>Longueur de la troisième tige. Les deux autres ont 20&#x202f;px de long.</translation>
    </message>
    <message>
        <source>Implicit midpoint</source>
        <translation>Point milieu implicite</translation>
    </message>
    <message>
        <source>Semi-implicit Euler</source>
        <translation>Euler semi-implicite</translation>
    </message>
    <message>
        <source>Backward Euler</source>
        <translation>Euler implicite</translation>
    </message>
    <message>
        <source>The same, as sticks</source>
        <translation>Le même, avec des tiges</translation>
    </message>
    <message>
        <source>Made of</source>
        <translation>Matériau</translation>
    </message>
    <message>
        <source>Whether springs hold the three points, or rigid sticks.</source>
        <translation>Les trois points sont tenus par des ressorts, ou par des tiges rigides.</translation>
    </message>
    <message>
        <source>Velocity Verlet</source>
        <translation>Verlet vitesse</translation>
    </message>
    <message>
        <source>springs</source>
        <translation>ressorts</translation>
    </message>
    <message>
        <source>sticks</source>
        <translation>tiges</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Hard cases</source>
        <translation>Cas difficiles</translation>
    </message>
    <message>
        <source>What breaks a simulation, why, and what holds.</source>
        <translation>Ce qui casse une simulation, pourquoi, et ce qui tient.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>bank</source>
        <translation>rive</translation>
    </message>
    <message>
        <source>stone</source>
        <translation>pierre</translation>
    </message>
</context>
</TS>
