<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>Accuracy</name>
    <message>
        <source>Off by</source>
        <translation>Écart</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>How far the point that is worst off is from its exact place.</source>
        <translation>Distance entre le point le moins précis et sa place exacte.</translation>
    </message>
    <message>
        <source>Energy drift</source>
        <translation>Dérive de l’énergie</translation>
    </message>
    <message>
        <source>%</source>
        <translation>%</translation>
    </message>
    <message>
        <source>How much more energy there is than in the exact motion at this moment.</source>
        <translation>Énergie en plus à cet instant, par rapport au mouvement exact.</translation>
    </message>
    <message>
        <source>Its step</source>
        <translation>Son pas de temps</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>images</translation>
    </message>
    <message>
        <source>How much time the method took at once, the last time.</source>
        <translation>Temps que la méthode a parcouru d’un coup, la dernière fois.</translation>
    </message>
    <message>
        <source>Computations</source>
        <translation>Calculs</translation>
    </message>
    <message>
        <source>a frame</source>
        <translation>par image</translation>
    </message>
    <message>
        <source>How often all forces were computed for this frame: that is the work.</source>
        <translation>Combien de fois toutes les forces ont été calculées pour cette image&#xa0;: c’est le travail.</translation>
    </message>
    <message>
        <source>%1&#x2009;px off</source>
        <translation>à %1&#x202f;px</translation>
    </message>
    <message>
        <source>Creatures</source>
        <translation>Créatures</translation>
    </message>
    <message>
        <source>How many creatures there are.</source>
        <translation>Nombre de créatures.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Accuracy</source>
        <translation>Précision</translation>
    </message>
    <message>
        <source>How far off a computed motion is, and what it costs to be nearer.</source>
        <translation>L’écart d’un mouvement calculé, et ce qu’il en coûte de s’approcher.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>ball</source>
        <translation>balle</translation>
    </message>
</context>
</TS>
