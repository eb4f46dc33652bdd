<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>AccuracyPlotText</name>
    <message>
        <source>%1: %2 frames; reference %3, accurate to %4 px</source>
        <translation>%1&#xa0;: %2 images&#x202f;; référence %3, exacte à %4 px près</translation>
    </message>
</context>
<context>
    <name>AccuracyReportText</name>
    <message>
        <source>step</source>
        <translation>pas de temps</translation>
    </message>
    <message>
        <source>error, px</source>
        <translation>erreur, px</translation>
    </message>
    <message>
        <source>forces/frame</source>
        <translation>forces/image</translation>
    </message>
    <message>
        <source>ns/frame</source>
        <translation>ns/image</translation>
    </message>
    <message>
        <source>+-</source>
        <translation>+-</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instable</translation>
    </message>
    <message>
        <source>takes too long</source>
        <translation>trop long</translation>
    </message>
    <message>
        <source>in use</source>
        <translation>utilisée</translation>
    </message>
    <message>
        <source>This scene has no exact motion to compare with, because %1 acts once per step. Each method is therefore compared with itself at a finer step (%2), which differs by up to %3 px from the next coarser one.</source>
        <translation>Cette scène n’a pas de mouvement exact auquel se comparer, car %1 agit une fois par pas de temps. Chaque méthode est donc comparée à elle-même avec un pas de temps plus fin (%2), qui s’écarte d’au plus %3 px du pas de temps immédiatement plus grossier.</translation>
    </message>
    <message>
        <source>Errors are distances from %1 (%2). Its check, %3 (%4), differs from it by up to %5 px.</source>
        <translation>Les erreurs sont des distances à %1 (%2). Sa vérification, %3 (%4), s’en écarte d’au plus %5 px.</translation>
    </message>
    <message>
        <source>Errors are given up to frame %1 of %2</source>
        <translation>Les erreurs sont données jusqu’à l’image %1 sur %2</translation>
    </message>
    <message>
        <source>: after that, the reference and its check disagree.</source>
        <translation>&#xa0;: ensuite, la référence et sa vérification ne concordent plus.</translation>
    </message>
    <message>
        <source>: after that, the reference is no longer finite.</source>
        <translation>&#xa0;: ensuite, la référence n’est plus finie.</translation>
    </message>
    <message>
        <source>: computing the reference beyond that would take too long.</source>
        <translation>&#xa0;: calculer la référence au-delà prendrait trop de temps.</translation>
    </message>
    <message>
        <source>No method stays within an error of %1 px.</source>
        <translation>Aucune méthode ne reste sous une erreur de %1 px.</translation>
    </message>
    <message>
        <source>The cheapest way to stay within an error of %1 px costs %2 µs a frame: %3, with an error of %4 px.</source>
        <translation>Le moyen le moins coûteux de rester sous une erreur de %1 px prend %2 µs par image&#xa0;: %3, avec une erreur de %4 px.</translation>
    </message>
    <message>
        <source>No error was measured for the method in use, %1: see the table.</source>
        <translation>Aucune erreur n’a été mesurée pour la méthode utilisée, %1&#xa0;: voir le tableau.</translation>
    </message>
    <message>
        <source>The method in use, %1, costs %2 µs a frame, with an error of %3 px.</source>
        <translation>La méthode utilisée, %1, coûte %2 µs par image, avec une erreur de %3 px.</translation>
    </message>
    <message>
        <source>tolerance %1</source>
        <translation>tolérance %1</translation>
    </message>
    <message>
        <source>h %1</source>
        <translation>h %1</translation>
    </message>
    <message>
        <source>method</source>
        <translation>méthode</translation>
    </message>
    <message>
        <source>* on the front: nothing cheaper is as accurate.</source>
        <translation>* sur le front&#xa0;: rien de moins coûteux n’est aussi précis.</translation>
    </message>
    <message>
        <source>This machine is busy with other things: times vary by %1 %.</source>
        <translation>Cette machine est occupée à autre chose&#xa0;: les temps varient de %1 %.</translation>
    </message>
    <message>
        <source>Nothing moves here unless you do something, so there is no error to measure. Save a run in which you do something, and measure that file.</source>
        <translation>Rien ne bouge ici si tu ne fais rien, donc il n’y a pas d’erreur à mesurer. Enregistre une simulation où tu fais quelque chose, et mesure ce fichier.</translation>
    </message>
</context>
<context>
    <name>AccuracyText</name>
    <message>
        <source>Measured %1 %</source>
        <translation>%1 % mesurés</translation>
    </message>
    <message>
        <source>%1: the picture could not be written: %2. Choose another folder or name.</source>
        <translation>%1&#xa0;: la capture n’a pas pu être écrite&#xa0;: %2. Choisis un autre dossier ou un autre nom.</translation>
    </message>
    <message>
        <source>Your setup costs %1 and has an error of %2.</source>
        <translation>Ton réglage coûte %1 et a une erreur de %2.</translation>
    </message>
    <message>
        <source>Your setup has an error of %1.</source>
        <translation>Ton réglage a une erreur de %1.</translation>
    </message>
    <message>
        <source>Your setup is unstable here: its numbers grow without bound.</source>
        <translation>Ton réglage est instable ici&#xa0;: ses nombres grandissent sans limite.</translation>
    </message>
    <message>
        <source>Your method cannot compute this scene.</source>
        <translation>Ta méthode ne peut pas calculer cette scène.</translation>
    </message>
    <message>
        <source>Your setup would take too long to measure.</source>
        <translation>Mesurer ton réglage prendrait trop de temps.</translation>
    </message>
    <message>
        <source>Errors are measured first, then times. The cost of staying within an error of %1 will appear here.</source>
        <translation>On mesure d’abord les erreurs, puis les temps. Ici apparaîtra ce que coûte une erreur d’au plus %1.</translation>
    </message>
    <message>
        <source>No method stays within an error of %1.</source>
        <translation>Aucune méthode ne reste sous une erreur de %1.</translation>
    </message>
    <message>
        <source>No method stays within an error of %1. The closest is %2, with an error of %3.</source>
        <translation>Aucune méthode ne reste sous une erreur de %1. La plus proche est %2, avec une erreur de %3.</translation>
    </message>
    <message>
        <source>Errors are measured up to frame %1 of %2.</source>
        <translation>Les erreurs sont mesurées jusqu’à l’image %1 sur %2.</translation>
    </message>
    <message>
        <source>After that, even the two finest steps disagree, because the smallest difference grows here.</source>
        <translation>Ensuite, même les deux pas de temps les plus fins ne concordent plus, car la moindre différence grandit ici.</translation>
    </message>
    <message>
        <source>After that, even two very accurate solutions disagree. The smallest difference grows here until the true positions cannot be known.</source>
        <translation>Ensuite, même deux solutions très précises ne concordent plus. La moindre différence grandit ici, jusqu’à ce qu’on ne puisse plus connaître les vraies positions.</translation>
    </message>
    <message>
        <source>After that, the exact motion itself grows without bound.</source>
        <translation>Ensuite, le mouvement exact lui-même grandit sans limite.</translation>
    </message>
    <message>
        <source>Computing the exact motion beyond that would take too long.</source>
        <translation>Calculer le mouvement exact au-delà prendrait trop de temps.</translation>
    </message>
    <message>
        <source>one of its effects</source>
        <translation>un de ses effets</translation>
    </message>
    <message>
        <source>This scene has no exact motion to compare with, because %1 acts once per step, however short the step is. Each method is therefore compared with its own finest steps.</source>
        <translation>Cette scène n’a pas de mouvement exact auquel se comparer, car «&#x202f;%1&#x202f;» agit une fois par pas de temps, aussi court soit-il. Chaque méthode est donc comparée à ses propres pas de temps les plus fins.</translation>
    </message>
    <message>
        <source>Cannot compute this scene: %1.</source>
        <translation>Ne peut pas calculer cette scène&#xa0;: %1.</translation>
    </message>
    <message>
        <source>%1&#x2009;µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>%1, tolerance %2</source>
        <translation>%1, tolérance %2</translation>
    </message>
    <message>
        <source>%1, step %2</source>
        <translation>%1, pas de temps %2</translation>
    </message>
    <message>
        <source>No error, to the last digit</source>
        <translation>Aucune erreur, jusqu’au dernier chiffre</translation>
    </message>
    <message>
        <source>Error at most %1</source>
        <translation>Erreur d’au plus %1</translation>
    </message>
    <message>
        <source>Unstable: its numbers grow without bound</source>
        <translation>Instable&#xa0;: ses nombres grandissent sans limite</translation>
    </message>
    <message>
        <source>Cannot compute this scene</source>
        <translation>Ne peut pas calculer cette scène</translation>
    </message>
    <message>
        <source>Skipped: it would take too long</source>
        <translation>Omise&#xa0;: cela prendrait trop de temps</translation>
    </message>
    <message>
        <source>Not measured yet</source>
        <translation>Pas encore mesurée</translation>
    </message>
    <message>
        <source>%1 ± %2 a frame</source>
        <translation>%1 ± %2 par image</translation>
    </message>
    <message>
        <source>Computes all forces %1 times a frame</source>
        <translation>Calcule toutes les forces %1 fois par image</translation>
    </message>
    <message>
        <source>On the front: nothing cheaper is as accurate</source>
        <translation>Sur le front&#xa0;: rien de moins coûteux n’est aussi précis</translation>
    </message>
    <message>
        <source>Nothing moves here unless you do something, so there is no error to measure. Drag a body or change a number, then measure again.</source>
        <translation>Rien ne bouge ici si tu ne fais rien, donc il n’y a pas d’erreur à mesurer. Fais glisser un corps ou change un nombre, puis mesure à nouveau.</translation>
    </message>
    <message>
        <source>First results, for frames 0 to %1. The exact motion after that is still being computed.</source>
        <translation>Premiers résultats, pour les images 0 à %1. Le mouvement exact au-delà est encore en cours de calcul.</translation>
    </message>
    <message>
        <source>Nothing cheaper than your setup stays within an error of %1: %2 costs %3 a frame, with an error of %4.</source>
        <translation>Rien de moins coûteux que ton réglage ne reste sous une erreur de %1&#xa0;: %2 coûte %3 par image, avec une erreur de %4.</translation>
    </message>
    <message>
        <source>The cheapest way to stay within an error of %1 costs %2 a frame: %3.</source>
        <translation>Le moyen le moins coûteux de rester sous une erreur de %1 prend %2 par image&#xa0;: %3.</translation>
    </message>
    <message>
        <source>The machine is busy with other things: the times differ by %1&#x2009;% from run to run. The errors are not affected.</source>
        <translation>La machine est occupée à autre chose&#xa0;: les temps varient de %1 % d’une simulation à l’autre. Les erreurs n’en souffrent pas.</translation>
    </message>
    <message>
        <source>Unstable: %1</source>
        <translation>Instable&#xa0;: %1</translation>
    </message>
    <message>
        <source>unstable at large steps: %1</source>
        <translation>instable avec de grands pas de temps&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1: the run is computed by code, which has no shorter steps to compare with. Remove &quot;method&quot; and &quot;code&quot; to measure the methods.</source>
        <translation>%1&#xa0;: la simulation est calculée par du code, qui n’a pas de pas de temps plus courts auxquels se comparer. Retire &quot;method&quot; et &quot;code&quot; pour mesurer les méthodes.</translation>
    </message>
    <message>
        <source>%1 is not the name of a plot; it ends in .svg.</source>
        <translation>%1 n’est pas un nom de graphique&#x202f;; il doit finir par .svg.</translation>
    </message>
</context>
<context>
    <name>Attempt</name>
    <message>
        <source>There is not enough memory.</source>
        <translation>Il n’y a pas assez de mémoire.</translation>
    </message>
</context>
<context>
    <name>BlueprintReader</name>
    <message>
        <source>%1 has %2 entries; the most is %3.</source>
        <translation>%1 a %2 entrées&#x202f;; le maximum est %3.</translation>
    </message>
    <message>
        <source>an object in { }</source>
        <translation>un objet entre { }</translation>
    </message>
    <message>
        <source>&quot;bodies&quot; is empty; a scene needs at least one body.</source>
        <translation>&quot;bodies&quot; est vide&#x202f;; une scène a besoin d’au moins un corps.</translation>
    </message>
    <message>
        <source>a body cannot be called %1; a name is a letter, then up to %2 letters, digits, dots and _.</source>
        <translation>un corps ne peut pas s’appeler %1&#x202f;; un nom est une lettre, puis jusqu’à %2 lettres, chiffres, points et _.</translation>
    </message>
    <message>
        <source>a body&apos;s name</source>
        <translation>le nom d’un corps</translation>
    </message>
    <message>
        <source>there is no body %1 in this scene; %2 must be the name of one of its &quot;bodies&quot;.</source>
        <translation>il n’y a pas de corps %1 dans cette scène&#x202f;; %2 doit être le nom d’un de ses &quot;bodies&quot;.</translation>
    </message>
    <message>
        <source>%1 has %2 at both ends; give it two bodies.</source>
        <translation>%1 a %2 à ses deux extrémités&#x202f;; donne-lui deux corps.</translation>
    </message>
    <message>
        <source>a spring</source>
        <translation>un ressort</translation>
    </message>
    <message>
        <source>a stick</source>
        <translation>une tige</translation>
    </message>
    <message>
        <source>a gait group</source>
        <translation>un groupe d’allure</translation>
    </message>
    <message>
        <source>a foot</source>
        <translation>un pied</translation>
    </message>
    <message>
        <source>a foot belongs to a gait group, and there is none; add &quot;gaits&quot;: [{}].</source>
        <translation>un pied appartient à un groupe d’allure, et il n’y en a pas&#x202f;; ajoute &quot;gaits&quot;: [{}].</translation>
    </message>
    <message>
        <source>%1 is a foot twice; it can be the foot of only one body.</source>
        <translation>%1 est deux fois un pied&#x202f;; il ne peut être le pied que d’un seul corps.</translation>
    </message>
    <message>
        <source>a scene cannot have the effect %1; it can have %2. Its springs, sticks and feet need no effect.</source>
        <translation>une scène ne peut pas avoir l’effet %1&#x202f;; elle peut avoir %2. Ses ressorts, ses tiges et ses pieds n’ont besoin d’aucun effet.</translation>
    </message>
    <message>
        <source>the effect %1 is given twice; keep one.</source>
        <translation>l’effet %1 est donné deux fois&#x202f;; garde-en un.</translation>
    </message>
    <message>
        <source>&quot;rule&quot; does not compile. Line %1: %2</source>
        <translation>&quot;rule&quot; ne se compile pas. Ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>a rule link</source>
        <translation>une liaison de la règle</translation>
    </message>
</context>
<context>
    <name>BodyNamesText</name>
    <message>
        <source>A name is a letter from a to z, then up to %1 letters, digits or _. Write it without spaces and accents.</source>
        <translation>Un nom est une lettre de a à z, puis jusqu’à %1 lettres, chiffres ou _. Écris-le sans espaces ni accents.</translation>
    </message>
    <message>
        <source>“%1” is a word of the code. Choose another name, such as “%1_1”.</source>
        <translation>«&#x202f;%1&#x202f;» est un mot du code. Choisis un autre nom, par exemple «&#x202f;%1_1&#x202f;».</translation>
    </message>
</context>
<context>
    <name>BodyText</name>
    <message>
        <source>%1 at (%2, %3)</source>
        <translation>%1 en (%2, %3)</translation>
    </message>
    <message>
        <source>%1, at rest</source>
        <translation>%1, au repos</translation>
    </message>
    <message>
        <source>%1, moving %2 px a frame</source>
        <translation>%1, bouge de %2 px par image</translation>
    </message>
</context>
<context>
    <name>Branches</name>
    <message>
        <source>%1 at frame %2</source>
        <translation>%1 à l’image %2</translation>
    </message>
</context>
<context>
    <name>BreakpointMonitorText</name>
    <message>
        <source>%1, line %2</source>
        <translation>%1, ligne %2</translation>
    </message>
    <message>
        <source>Stopped at frame %1 before %2: %3.</source>
        <translation>Arrêt à l’image %1 avant «&#x202f;%2&#x202f;»&#xa0;: %3.</translation>
    </message>
    <message>
        <source>Stopped at frame %1 before line %2: %3.</source>
        <translation>Arrêt à l’image %1 avant la ligne %2&#xa0;: %3.</translation>
    </message>
    <message>
        <source>Stopped at frame %1 before line %2 of the listing.</source>
        <translation>Arrêt à l’image %1 avant la ligne %2 du listing.</translation>
    </message>
</context>
<context>
    <name>CaptionText</name>
    <message>
        <source>pulls change the velocities directly, %1.</source>
        <translation>les tractions changent directement les vitesses, %1.</translation>
    </message>
    <message>
        <source>accelerations are being added up, %1.</source>
        <translation>les accélérations s’additionnent, %1.</translation>
    </message>
    <message>
        <source>velocities have changed, %1.</source>
        <translation>des vitesses ont changé, %1.</translation>
    </message>
    <message>
        <source>already moved: %1; not yet moved: %2.</source>
        <translation>déjà déplacés&#xa0;: %1&#x202f;; pas encore déplacés&#xa0;: %2.</translation>
    </message>
    <message>
        <source>everything has moved; next: %1.</source>
        <translation>tout a bougé&#x202f;; ensuite&#xa0;: «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>everything has moved.</source>
        <translation>tout a bougé.</translation>
    </message>
    <message>
        <source>Inside frame %1: %2 of %3 steps are done.</source>
        <translation>Dans l’image %1&#xa0;: %2 pas de temps faits sur %3.</translation>
    </message>
    <message>
        <source>nothing has moved in it yet</source>
        <translation>rien n’y a encore bougé</translation>
    </message>
    <message>
        <source>nothing has moved yet</source>
        <translation>rien n’a encore bougé</translation>
    </message>
    <message>
        <source>after %1, points have moved directly, without a velocity.</source>
        <translation>après «&#x202f;%1&#x202f;», des points ont été déplacés directement, sans vitesse.</translation>
    </message>
    <message>
        <source>after %1, points have moved directly, and velocities have changed.</source>
        <translation>après «&#x202f;%1&#x202f;», des points ont été déplacés directement et des vitesses ont changé.</translation>
    </message>
    <message>
        <source>Inside frame %1, step %2 of %3: %4</source>
        <translation>Dans l’image %1, pas de temps %2 sur %3&#xa0;: %4</translation>
    </message>
    <message>
        <source>Inside frame %1: %2</source>
        <translation>Dans l’image %1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>CheckText</name>
    <message>
        <source>%1: %2 (steps: %3; languages besides the first: %4)
</source>
        <translation>%1&#xa0;: %2 (étapes&#xa0;: %3&#x202f;; langues en plus de la première&#xa0;: %4)
</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
</context>
<context>
    <name>CodeJudge</name>
    <message>
        <source>%1° away from its angle</source>
        <translation>à %1° de son angle</translation>
    </message>
    <message>
        <source>%1&#x202f;px away from its place</source>
        <translation>à %1&#x202f;px de sa place</translation>
    </message>
    <message>
        <source>Not yet: in frame %1 of a trial run with other parameters, %2 is %3.</source>
        <translation>Pas encore&#xa0;: à l’image %1 d’une simulation d’essai avec d’autres paramètres, «&#x202f;%2&#x202f;» est %3.</translation>
    </message>
    <message>
        <source>Not yet: in frame %1 of a trial run, %2 is %3.</source>
        <translation>Pas encore&#xa0;: à l’image %1 d’une simulation d’essai, «&#x202f;%2&#x202f;» est %3.</translation>
    </message>
    <message>
        <source>Not yet: while your hand holds %1 in a trial run with other parameters, %2 is %3.</source>
        <translation>Pas encore&#xa0;: dans une simulation d’essai avec d’autres paramètres, ta main tient «&#x202f;%1&#x202f;», et «&#x202f;%2&#x202f;» est %3.</translation>
    </message>
    <message>
        <source>Not yet: while your hand holds %1 in a trial run, %2 is %3.</source>
        <translation>Pas encore&#xa0;: dans une simulation d’essai, ta main tient «&#x202f;%1&#x202f;», et «&#x202f;%2&#x202f;» est %3.</translation>
    </message>
    <message>
        <source>Right: your code does the same as the listing in three trial runs.</source>
        <translation>Juste&#xa0;: ton code fait la même chose que le listing dans trois simulations d’essai.</translation>
    </message>
    <message>
        <source>Not yet: a trial run stops in frame %1. %2</source>
        <translation>Pas encore&#xa0;: une simulation d’essai s’arrête à l’image %1. %2</translation>
    </message>
    <message>
        <source>Not yet: in frame %1 of a trial run, a number became infinite.</source>
        <translation>Pas encore&#xa0;: à l’image %1 d’une simulation d’essai, un nombre est devenu infini.</translation>
    </message>
    <message>
        <source>Line %1 is not correct yet, so the code cannot run.</source>
        <translation>La ligne %1 n’est pas encore correcte, donc le code ne peut pas s’exécuter.</translation>
    </message>
</context>
<context>
    <name>CodeListingText</name>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>%1: order of the phases</source>
        <translation>%1&#xa0;: ordre des phases</translation>
    </message>
</context>
<context>
    <name>CodeMarksText</name>
    <message>
        <source>done</source>
        <translation>fait</translation>
    </message>
    <message>
        <source>now</source>
        <translation>maintenant</translation>
    </message>
    <message>
        <source>next</source>
        <translation>ensuite</translation>
    </message>
    <message>
        <source>1 pull</source>
        <translation>1 traction</translation>
    </message>
    <message>
        <source>%1 pulls</source>
        <translation>%1 tractions</translation>
    </message>
</context>
<context>
    <name>CodeRowsText</name>
    <message>
        <source>%1: added up by the method</source>
        <translation>%1&#xa0;: additionnées par la méthode</translation>
    </message>
</context>
<context>
    <name>CodeSymbols</name>
    <message>
        <source>Where the body is, as seen from the other end of its spring.</source>
        <translation>Où est le corps, vu de l’autre bout de son ressort.</translation>
    </message>
    <message>
        <source>The direction away from the other end of the spring, as an arrow of length 1.</source>
        <translation>La direction qui s’éloigne de l’autre bout du ressort, comme une flèche de longueur 1.</translation>
    </message>
    <message>
        <source>The same direction, as an angle.</source>
        <translation>La même direction, sous forme d’angle.</translation>
    </message>
    <message>
        <source>How far the body is from the other end of its spring.</source>
        <translation>À quelle distance le corps est de l’autre bout de son ressort.</translation>
    </message>
    <message>
        <source>How much farther away the spring pulls the body, as a share of its distance.</source>
        <translation>De combien le ressort tire le corps plus loin, en part de sa distance.</translation>
    </message>
    <message>
        <source>Where the spring pulls the body to.</source>
        <translation>Vers quel endroit le ressort tire le corps.</translation>
    </message>
    <message>
        <source>The arrow from the body to where the spring pulls it.</source>
        <translation>La flèche du corps vers l’endroit où le ressort le tire.</translation>
    </message>
    <message>
        <source>How much all springs together add to the velocity in each frame.</source>
        <translation>Ce que tous les ressorts ensemble ajoutent à la vitesse à chaque image.</translation>
    </message>
    <message>
        <source>How much gravity adds to the velocity in each frame.</source>
        <translation>Ce que la gravité ajoute à la vitesse à chaque image.</translation>
    </message>
    <message>
        <source>The arrow from the body to its target.</source>
        <translation>La flèche du corps vers sa cible.</translation>
    </message>
    <message>
        <source>The share of the velocity that is left after this step.</source>
        <translation>La part de la vitesse qui reste après ce pas de temps.</translation>
    </message>
    <message>
        <source>How much is added to the velocity in each frame.</source>
        <translation>Ce qui est ajouté à la vitesse à chaque image.</translation>
    </message>
    <message>
        <source>Where the body is: x to the right, y down.</source>
        <translation>Où est le corps&#xa0;: x vers la droite, y vers le bas.</translation>
    </message>
    <message>
        <source>The velocity: how far the body moves in a frame.</source>
        <translation>La vitesse&#xa0;: de combien le corps se déplace en une image.</translation>
    </message>
    <message>
        <source>How far the two are from each other.</source>
        <translation>À quelle distance les deux sont l’un de l’autre.</translation>
    </message>
    <message>
        <source>How fast it turns.</source>
        <translation>À quelle vitesse il tourne.</translation>
    </message>
    <message>
        <source>The direction in which it points.</source>
        <translation>La direction vers laquelle il pointe.</translation>
    </message>
</context>
<context>
    <name>CodeTargetsText</name>
    <message>
        <source>%1 can be %2, but not %3.</source>
        <translation>%1 peut être %2, mais pas %3.</translation>
    </message>
    <message>
        <source>%1 can be a whole number from %2 to %3, but not %4.</source>
        <translation>%1 peut être un nombre entier de %2 à %3, mais pas %4.</translation>
    </message>
    <message>
        <source>%1 can be a number from %2 to %3, but not %4.</source>
        <translation>%1 peut être un nombre de %2 à %3, mais pas %4.</translation>
    </message>
</context>
<context>
    <name>CodeTextWords</name>
    <message>
        <source>other code</source>
        <translation>autre code</translation>
    </message>
</context>
<context>
    <name>CodeValuesText</name>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>too large</source>
        <translation>trop grand</translation>
    </message>
    <message>
        <source>%1: from %2 to %3%4</source>
        <translation>%1&#xa0;: de %2 à %3%4</translation>
    </message>
    <message>
        <source>%1: %2%3, unchanged</source>
        <translation>%1&#xa0;: %2%3, inchangé</translation>
    </message>
    <message>
        <source>%1: %2%3</source>
        <translation>%1&#xa0;: %2%3</translation>
    </message>
    <message>
        <source>The sum of %1 pulls</source>
        <translation>La somme de %1 tractions</translation>
    </message>
</context>
<context>
    <name>CommandLine</name>
    <message>
        <source>there is no display for the window; set DISPLAY, or use a verb that needs none: %1.</source>
        <translation>il n’y a pas d’écran pour la fenêtre&#x202f;; définis DISPLAY, ou utilise une commande qui n’en a pas besoin&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>CommandLineText</name>
    <message>
        <source>An experiment or a lesson to open.</source>
        <translation>Une expérience ou une leçon à ouvrir.</translation>
    </message>
    <message>
        <source>Prints the version.</source>
        <translation>Affiche la version.</translation>
    </message>
    <message>
        <source>there is no verb and no file %1; the verbs are %2.</source>
        <translation>il n’y a ni commande ni fichier %1&#x202f;; les commandes sont %2.</translation>
    </message>
    <message>
        <source>there is no verb %1; the verbs are %2.</source>
        <translation>il n’y a pas de commande %1&#x202f;; les commandes sont %2.</translation>
    </message>
    <message>
        <source>Prints this help.</source>
        <translation>Affiche cette aide.</translation>
    </message>
    <message>
        <source>%1; see %2 --help.</source>
        <translation>%1&#x202f;; voir %2 --help.</translation>
    </message>
    <message>
        <source>no arguments</source>
        <translation>aucun argument</translation>
    </message>
    <message>
        <source>%1 takes %2; see %3 --help.</source>
        <translation>%1 attend %2&#x202f;; voir %3 --help.</translation>
    </message>
    <message>
        <source>Physically based animation, step by step.

Without a verb, the window opens and shows FILE, an experiment or a lesson.

Verbs (each has its own --help, and none needs a display):</source>
        <translation>Animation fondée sur la physique, étape par étape.

Sans commande, la fenêtre s’ouvre et montre FILE, une expérience ou une leçon.

Commandes (chacune a son propre --help, et aucune n’a besoin d’un écran)&#xa0;:</translation>
    </message>
    <message>
        <source>%1 (default %2).</source>
        <translation>%1 (par défaut %2).</translation>
    </message>
    <message>
        <source>the window opens one file; leave out %1.</source>
        <translation>la fenêtre ouvre un seul fichier&#x202f;; enlève %1.</translation>
    </message>
</context>
<context>
    <name>CommandList</name>
    <message>
        <source>Experiments</source>
        <translation>Expériences</translation>
    </message>
    <message>
        <source>Pictures and films</source>
        <translation>Captures et films</translation>
    </message>
    <message>
        <source>Changes</source>
        <translation>Modifications</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Temps</translation>
    </message>
    <message>
        <source>Other runs</source>
        <translation>Autres simulations</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>Étapes</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Vue</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenêtre</translation>
    </message>
    <message>
        <source>Build</source>
        <translation>Construire</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Accuracy</source>
        <translation>Précision</translation>
    </message>
</context>
<context>
    <name>ConceptMapText</name>
    <message>
        <source>the id “%1” is that of a concept in %2, too. Choose another one.</source>
        <translation>l’identifiant «&#x202f;%1&#x202f;» est aussi celui d’une notion de %2. Choisis-en un autre.</translation>
    </message>
    <message>
        <source>the concept “%1” rests on “%2”, which no step explains. Use the id of a concept, or remove it.</source>
        <translation>la notion «&#x202f;%1&#x202f;» repose sur «&#x202f;%2&#x202f;», qu’aucune étape n’explique. Utilise l’identifiant d’une notion, ou retire-le.</translation>
    </message>
    <message>
        <source>the concept “%1” rests on “%2”, which comes later, in %3. Move one of them, or remove the id.</source>
        <translation>la notion «&#x202f;%1&#x202f;» repose sur «&#x202f;%2&#x202f;», qui vient plus tard, dans %3. Déplace l’une des deux, ou retire l’identifiant.</translation>
    </message>
    <message>
        <source>the concept “%1” rests on itself. Remove its id from “Rests on”.</source>
        <translation>la notion «&#x202f;%1&#x202f;» repose sur elle-même. Retire son identifiant de «&#x202f;Rests on&#x202f;».</translation>
    </message>
    <message>
        <source>the concept “%1” rests on one that rests on it. Remove one of the two ids.</source>
        <translation>la notion «&#x202f;%1&#x202f;» repose sur une notion qui repose sur elle. Retire l’un des deux identifiants.</translation>
    </message>
</context>
<context>
    <name>ConditionNamesText</name>
    <message>
        <source>Character %1: %2</source>
        <translation>Caractère %1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>ConditionParserText</name>
    <message>
        <source>this is too long; use at most %1 characters.</source>
        <translation>c’est trop long&#x202f;; utilise au plus %1 caractères.</translation>
    </message>
    <message>
        <source>a number is neither true nor false; compare it, as in %1.</source>
        <translation>un nombre n’est ni vrai ni faux&#x202f;; compare-le, comme dans %1.</translation>
    </message>
    <message>
        <source>this is true or false, not a number; join conditions with and, or.</source>
        <translation>c’est vrai ou faux, pas un nombre&#x202f;; relie les conditions avec and, or.</translation>
    </message>
    <message>
        <source>a phase can only be compared with its name, as in phase == &quot;%1&quot;.</source>
        <translation>une phase ne se compare qu’à son nom, comme dans phase == &quot;%1&quot;.</translation>
    </message>
    <message>
        <source>%1 is a choice; compare it with one of its values, as in %1 == &quot;%2&quot;.</source>
        <translation>%1 est un choix&#x202f;; compare-le à l’une de ses valeurs, comme dans %1 == &quot;%2&quot;.</translation>
    </message>
    <message>
        <source>%1 is a text; only phase and choices can be compared with a text.</source>
        <translation>%1 est un texte&#x202f;; seuls phase et les choix se comparent à un texte.</translation>
    </message>
    <message>
        <source>a number cannot be used here; write a condition such as x &gt; 0.</source>
        <translation>un nombre ne va pas ici&#x202f;; écris une condition comme x &gt; 0.</translation>
    </message>
    <message>
        <source>the condition is empty; write a comparison, as in %1.y &gt; 380.</source>
        <translation>la condition est vide&#x202f;; écris une comparaison, comme dans %1.y &gt; 380.</translation>
    </message>
    <message>
        <source>this parenthesis closes nothing; remove it.</source>
        <translation>cette parenthèse ne ferme rien&#x202f;; retire-la.</translation>
    </message>
    <message>
        <source>%1 cannot directly follow the text before it; put and, or, or a sign such as + or &lt; between them.</source>
        <translation>%1 ne peut pas suivre directement le texte qui précède&#x202f;; mets entre les deux and, or ou un signe comme + ou &lt;.</translation>
    </message>
    <message>
        <source>a comparison has only two sides; join two comparisons with and.</source>
        <translation>une comparaison n’a que deux côtés&#x202f;; relie deux comparaisons avec and.</translation>
    </message>
    <message>
        <source>names can only be equal or different; write == or !=.</source>
        <translation>des noms ne peuvent être qu’égaux ou différents&#x202f;; écris == ou !=.</translation>
    </message>
    <message>
        <source>this parenthesis is not closed; close it with ).</source>
        <translation>cette parenthèse n’est pas fermée&#x202f;; ferme-la avec ).</translation>
    </message>
    <message>
        <source>%1 cannot be here; a sign or ) is missing before it.</source>
        <translation>%1 ne peut pas être ici&#x202f;; il manque un signe ou ) devant.</translation>
    </message>
    <message>
        <source>something is missing at the end; add a number or a name.</source>
        <translation>il manque quelque chose à la fin&#x202f;; ajoute un nombre ou un nom.</translation>
    </message>
    <message>
        <source>a number or a name is missing before %1; add it.</source>
        <translation>il manque un nombre ou un nom devant %1&#x202f;; ajoute-le.</translation>
    </message>
    <message>
        <source>%1 needs parentheses around its number, as in %1(%2.vy).</source>
        <translation>%1 a besoin de parenthèses autour de son nombre, comme dans %1(%2.vy).</translation>
    </message>
    <message>
        <source>a comma can only be between two bodies, as in distance(%1, %2); write numbers with a point.</source>
        <translation>une virgule ne va qu’entre deux corps, comme dans distance(%1, %2)&#x202f;; écris les nombres avec un point.</translation>
    </message>
    <message>
        <source>there is no phase %1; there are %2.</source>
        <translation>il n’y a pas de phase %1&#x202f;; il y a %2.</translation>
    </message>
    <message>
        <source>%1 is never %2; it can be %3.</source>
        <translation>%1 n’est jamais %2&#x202f;; possible&#xa0;: %3.</translation>
    </message>
    <message>
        <source>there is no body %1 here; there are %2.</source>
        <translation>il n’y a pas de corps %1 ici&#x202f;; il y a %2.</translation>
    </message>
    <message>
        <source>%1 has no %2; it has %3.</source>
        <translation>%1 n’a pas de %2&#x202f;; il y a %3.</translation>
    </message>
    <message>
        <source>%1 is a body; ask for one of its numbers, as in %1.y (%2).</source>
        <translation>%1 est un corps&#x202f;; demande l’un de ses nombres, comme dans %1.y (%2).</translation>
    </message>
    <message>
        <source>there is no %1 here; there are %2, and numbers of bodies, as in %3.y.</source>
        <translation>il n’y a pas de %1 ici&#x202f;; il y a %2, et des nombres de corps, comme dans %3.y.</translation>
    </message>
    <message>
        <source>%1 is a Vec2; ask for one of its numbers, %1.x or %1.y.</source>
        <translation>%1 est un Vec2&#x202f;; demande l’un de ses nombres, %1.x ou %1.y.</translation>
    </message>
    <message>
        <source>%1 is a number, without members.</source>
        <translation>%1 est un nombre, sans membres.</translation>
    </message>
    <message>
        <source>distance needs two bodies with a comma between them, as in %1.</source>
        <translation>distance a besoin de deux corps séparés par une virgule, comme dans %1.</translation>
    </message>
    <message>
        <source>the name of a body is missing here, as in %1.</source>
        <translation>il manque ici le nom d’un corps, comme dans %1.</translation>
    </message>
</context>
<context>
    <name>ConditionTokensText</name>
    <message>
        <source>%1 is not a number; write one like 380, 0.5 or 1e-3.</source>
        <translation>%1 n’est pas un nombre&#x202f;; écris-en un comme 380, 0.5 ou 1e-3.</translation>
    </message>
    <message>
        <source>This text has no closing quotation mark; close it with %1.</source>
        <translation>Il manque le guillemet fermant de ce texte&#x202f;; ferme-le avec %1.</translation>
    </message>
    <message>
        <source>A single “=” would set a value; write == to compare two values.</source>
        <translation>Un seul «&#x202f;=&#x202f;» donnerait une valeur&#x202f;; écris == pour comparer deux valeurs.</translation>
    </message>
    <message>
        <source>A comma has no meaning here; write 0.5 with a point, and join conditions with “and”.</source>
        <translation>Une virgule n’a pas de sens ici&#x202f;; écris 0.5 avec un point, et relie les conditions avec «&#x202f;and&#x202f;».</translation>
    </message>
    <message>
        <source>%1 has no meaning here; there are numbers, names, + - * / ( ), comparisons, and, or, not.</source>
        <translation>%1 n’a pas de sens ici&#x202f;; il y a des nombres, des noms, + - * / ( ), des comparaisons, and, or, not.</translation>
    </message>
</context>
<context>
    <name>CostReportText</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>effect</source>
        <translation>effet</translation>
    </message>
    <message>
        <source>points</source>
        <translation>points</translation>
    </message>
    <message>
        <source>times/frame</source>
        <translation>fois/image</translation>
    </message>
    <message>
        <source>ns/frame</source>
        <translation>ns/image</translation>
    </message>
    <message>
        <source>+-</source>
        <translation>+-</translation>
    </message>
    <message>
        <source>ns/point</source>
        <translation>ns/point</translation>
    </message>
    <message>
        <source>share</source>
        <translation>part</translation>
    </message>
    <message>
        <source>the method itself</source>
        <translation>la méthode elle-même</translation>
    </message>
    <message>
        <source>whole frame</source>
        <translation>image entière</translation>
    </message>
    <message>
        <source>Each line is measured separately. Effects and method together take %1 of the time of the whole frame.</source>
        <translation>Chaque ligne est mesurée séparément. Les effets et la méthode prennent ensemble %1 du temps de l’image entière.</translation>
    </message>
</context>
<context>
    <name>CostText</name>
    <message>
        <source>The run does not reach frame %1. %2 Give an earlier frame.</source>
        <translation>La simulation n’atteint pas l’image %1. %2 Donne une image antérieure.</translation>
    </message>
    <message>
        <source>changes nothing</source>
        <translation>ne change rien</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>Measured %1 times</source>
        <translation>Mesuré %1 fois</translation>
    </message>
</context>
<context>
    <name>DifferenceTableText</name>
    <message>
        <source>distance [px]</source>
        <translation>distance [px]</translation>
    </message>
    <message>
        <source>body</source>
        <translation>corps</translation>
    </message>
</context>
<context>
    <name>DifferenceText</name>
    <message>
        <source>The other run is being computed again…</source>
        <translation>L’autre simulation est recalculée…</translation>
    </message>
    <message>
        <source>There is no other run to compare with.</source>
        <translation>Il n’y a pas d’autre simulation à comparer.</translation>
    </message>
    <message>
        <source>More than %1 points: too many to compare at every frame.</source>
        <translation>Plus de %1 points&#xa0;: trop pour les comparer à chaque image.</translation>
    </message>
    <message>
        <source>The other run does not have the selected body.</source>
        <translation>L’autre simulation n’a pas le corps sélectionné.</translation>
    </message>
    <message>
        <source>The two runs have no body in common.</source>
        <translation>Les deux simulations n’ont aucun corps en commun.</translation>
    </message>
    <message>
        <source>No difference up to frame %1. Play on to see whether one appears.</source>
        <translation>Aucune différence jusqu’à l’image %1. Continue la lecture pour voir s’il en apparaît une.</translation>
    </message>
    <message>
        <source>Largest: %1&#x2009;px apart, %2, at frame %3.</source>
        <translation>La plus grande&#xa0;: %1 px d’écart, %2, à l’image %3.</translation>
    </message>
    <message>
        <source>Compared every %1 frames.</source>
        <translation>Comparées toutes les %1 images.</translation>
    </message>
    <message>
        <source>branches off at frame %1</source>
        <translation>s’écarte à l’image %1</translation>
    </message>
    <message>
        <source>branches off at the start</source>
        <translation>s’écarte dès le début</translation>
    </message>
    <message>
        <source>%1, %2, kept</source>
        <translation>%1, %2, gardée</translation>
    </message>
</context>
<context>
    <name>EdgeMarkersText</name>
    <message>
        <source>%1 bodies</source>
        <translation>%1 corps</translation>
    </message>
</context>
<context>
    <name>EditHistory</name>
    <message>
        <source>undone: %1</source>
        <translation>annulé&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>EffectLinesText</name>
    <message>
        <source>Nearly all of a frame’s %2&#x2009;µs are spent in “%1”.</source>
        <translation>Presque toutes les %2&#x2009;µs d’une image reviennent à «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>Without “%1” a frame would cost %2&#x2009;µs instead of %3.</source>
        <translation>Sans «&#x202f;%1&#x202f;», une image coûterait %2 µs au lieu de %3.</translation>
    </message>
    <message>
        <source>%1&#x2009;µs a frame; about half of the measurements are within %2.</source>
        <translation>%1 µs par image&#x202f;; environ la moitié des mesures sont à moins de %2.</translation>
    </message>
    <message>
        <source>Points that it acts on: %1.</source>
        <translation>Points sur lesquels il agit&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The method computes it together with the move.</source>
        <translation>La méthode le calcule en même temps que le déplacement.</translation>
    </message>
    <message>
        <source>Each frame computes it %1.</source>
        <translation>Chaque image le calcule %1.</translation>
    </message>
    <message>
        <source>With these settings it changes nothing, so it is not computed: 0&#x2009;µs.</source>
        <translation>Avec ces réglages, il ne change rien, donc il n’est pas calculé&#xa0;: 0 µs.</translation>
    </message>
    <message>
        <source>Switched off: it costs nothing.</source>
        <translation>Désactivé&#xa0;: il ne coûte rien.</translation>
    </message>
    <message>
        <source>Not in this scene, so it costs nothing.</source>
        <translation>Pas dans cette scène, donc il ne coûte rien.</translation>
    </message>
    <message>
        <source>Press Space or click the switch to turn it off.</source>
        <translation>Appuie sur Espace ou clique sur l’interrupteur pour le désactiver.</translation>
    </message>
    <message>
        <source>Press Space or click the switch to turn it on again.</source>
        <translation>Appuie sur Espace ou clique sur l’interrupteur pour le réactiver.</translation>
    </message>
    <message>
        <source>switched off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>changes nothing here</source>
        <translation>ne change rien ici</translation>
    </message>
    <message>
        <source>not in this scene</source>
        <translation>pas dans cette scène</translation>
    </message>
    <message>
        <source>Rest of the frame</source>
        <translation>Reste de l’image</translation>
    </message>
    <message>
        <source>Time outside the effects: moving the points, and the method&apos;s own sums. It cannot be switched off.</source>
        <translation>Temps hors des effets&#xa0;: le déplacement des points et les calculs propres à la méthode. On ne peut pas le désactiver.</translation>
    </message>
    <message>
        <source>%1 (%2). %3</source>
        <translation>%1 (%2). %3</translation>
    </message>
    <message>
        <source>Not in this scene, so it costs nothing and has no switch. Other lessons have:</source>
        <translation>Pas dans cette scène, donc il ne coûte rien et n’a pas d’interrupteur. Dans d’autres leçons, il y a&#xa0;:</translation>
    </message>
    <message>
        <source>%1, %2&#x2009;µs, %3</source>
        <translation>%1, %2 µs, %3</translation>
    </message>
    <message>
        <source>%1, not measured yet</source>
        <translation>%1, pas encore mesuré</translation>
    </message>
    <message>
        <source>%1, %2&#x2009;µs a frame</source>
        <translation>%1, %2 µs par image</translation>
    </message>
    <message>
        <source>on</source>
        <translation>activé</translation>
    </message>
    <message>
        <source>off</source>
        <translation>désactivé</translation>
    </message>
    <message>
        <source>%1%2µs a frame, ±%3</source>
        <translation>%1%2µs par image, ±%3</translation>
    </message>
</context>
<context>
    <name>EnergyLinesText</name>
    <message>
        <source>Energy that you add by dragging</source>
        <translation>Énergie que tu ajoutes en faisant glisser</translation>
    </message>
    <message>
        <source>If a stiffness or a length changes, the energy stored in springs changes, too</source>
        <translation>Si une raideur ou une longueur change, l’énergie des ressorts change aussi</translation>
    </message>
    <message>
        <source>Energy that gait clocks and steering add</source>
        <translation>Énergie qu’ajoutent les horloges d’allure et le pilotage</translation>
    </message>
    <message>
        <source>Energy that the wind adds or takes away</source>
        <translation>Énergie que le vent ajoute ou enlève</translation>
    </message>
    <message>
        <source>Energy that the force of your rule adds or takes away</source>
        <translation>Énergie que la force de ta règle ajoute ou enlève</translation>
    </message>
    <message>
        <source>A pull without an opposite pull stores no energy. It adds energy or takes it away</source>
        <translation>Une traction sans traction opposée ne stocke pas d’énergie. Elle en ajoute ou en enlève</translation>
    </message>
    <message>
        <source>It pulls everything down, and nothing pulls back</source>
        <translation>Elle tire tout vers le bas, et rien ne tire en retour</translation>
    </message>
    <message>
        <source>Springs pull on fixed places, and those pull back</source>
        <translation>Les ressorts tirent sur des points fixes, qui tirent en retour</translation>
    </message>
    <message>
        <source>Energy that damping takes from everything that moves</source>
        <translation>Énergie que l’amortissement prend à tout ce qui bouge</translation>
    </message>
    <message>
        <source>Energy that walls and ground take, or add when they push bodies out</source>
        <translation>Énergie que les murs et le sol prennent, ou ajoutent quand ils repoussent des corps</translation>
    </message>
    <message>
        <source>Energy that sticks and joints change when they correct lengths and angles</source>
        <translation>Énergie que changent les tiges et les articulations en corrigeant longueurs et angles</translation>
    </message>
    <message>
        <source>Gained or lost through the method&apos;s error, not through anything in the scene. A smaller step or another method makes it smaller.</source>
        <translation>Gagnée ou perdue par l’erreur de la méthode, non par quelque chose dans la scène. Un pas de temps plus petit ou une autre méthode la réduit.</translation>
    </message>
    <message>
        <source>In motion</source>
        <translation>En mouvement</translation>
    </message>
    <message>
        <source>Half of mass × speed², added up over all points</source>
        <translation>La moitié de masse × vitesse², additionnée sur tous les points</translation>
    </message>
    <message>
        <source>In height</source>
        <translation>En hauteur</translation>
    </message>
    <message>
        <source>Mass × gravity × height, measured from the lowest point of this run</source>
        <translation>Masse × gravité × hauteur, mesurée depuis le point le plus bas de cette simulation</translation>
    </message>
    <message>
        <source>In springs</source>
        <translation>Dans les ressorts</translation>
    </message>
    <message>
        <source>Half of stiffness × stretch², added up over all springs</source>
        <translation>La moitié de raideur × étirement², additionnée sur tous les ressorts</translation>
    </message>
    <message>
        <source>Mass × velocity, added up over all points: to the right, and down</source>
        <translation>Masse × vitesse, additionnée sur tous les points&#xa0;: vers la droite et vers le bas</translation>
    </message>
    <message>
        <source>A rule sets the position of at least one body in each frame, so this body has no velocity and the energy cannot be counted. Choose a scene in which every body has inertia.</source>
        <translation>Une règle fixe à chaque image la position d’au moins un corps&#x202f;; ce corps n’a donc pas de vitesse, et on ne peut pas compter l’énergie. Choisis une scène où chaque corps a de l’inertie.</translation>
    </message>
    <message>
        <source>Nothing moves in this scene unless you drag it, so there is no energy to count. Choose a scene with a body on a spring.</source>
        <translation>Rien ne bouge dans cette scène si tu ne le fais pas glisser, donc il n’y a pas d’énergie à compter. Choisis une scène avec un corps sur un ressort.</translation>
    </message>
    <message>
        <source>There are more than %1 points here. Counting the energy of all of them, phase by phase, would take longer than the run itself.</source>
        <translation>Il y a plus de %1 points ici. Compter l’énergie de tous, phase par phase, prendrait plus de temps que la simulation elle-même.</translation>
    </message>
    <message>
        <source>Something here turns, but its inertia is unknown. So there is no energy to count.</source>
        <translation>Quelque chose tourne ici, mais son inertie est inconnue. Il n’y a donc pas d’énergie à compter.</translation>
    </message>
    <message>
        <source>inertia × degrees²/frame²</source>
        <translation>inertie × degrés²/image²</translation>
    </message>
    <message>
        <source>mass × px²/frame²</source>
        <translation>masse × px²/image²</translation>
    </message>
    <message>
        <source>mass × px/frame</source>
        <translation>masse × px/image</translation>
    </message>
</context>
<context>
    <name>Experiment</name>
    <message>
        <source>the file</source>
        <translation>le fichier</translation>
    </message>
    <message>
        <source>&quot;format&quot; is %1; this program reads %2.</source>
        <translation>&quot;format&quot; vaut %1&#x202f;; ce programme lit %2.</translation>
    </message>
    <message>
        <source>&quot;scene&quot; does not go with a lesson&apos;s step, which has its own; remove it, and change that one by &quot;parameters&quot;, &quot;bodies&quot; and &quot;effects&quot;.</source>
        <translation>&quot;scene&quot; ne va pas avec l’étape d’une leçon, qui a la sienne&#x202f;; retire-le, et modifie celle-là avec &quot;parameters&quot;, &quot;bodies&quot; et &quot;effects&quot;.</translation>
    </message>
    <message>
        <source>the step %1 has no sticks; remove &quot;links&quot;.</source>
        <translation>l’étape %1 n’a pas de tiges&#x202f;; retire &quot;links&quot;.</translation>
    </message>
    <message>
        <source>nothing is held at frame %1; a %2 comes after a &quot;grab&quot;.</source>
        <translation>rien n’est tenu à l’image %1&#x202f;; un %2 vient après un &quot;grab&quot;.</translation>
    </message>
    <message>
        <source>the step %1 has no effect %2; it has %3.</source>
        <translation>l’étape %1 n’a pas d’effet %2&#x202f;; elle a %3.</translation>
    </message>
    <message>
        <source>the body %1</source>
        <translation>le corps %1</translation>
    </message>
    <message>
        <source>there is no body %1 here; there is %2.</source>
        <translation>il n’y a pas de corps %1 ici&#x202f;; il y a %2.</translation>
    </message>
    <message>
        <source>the step %1 has its sticks in &quot;scene&quot;; move &quot;links&quot; there and call it &quot;sticks&quot;.</source>
        <translation>l’étape %1 a ses tiges dans &quot;scene&quot;&#x202f;; déplace &quot;links&quot; là-bas et appelle-le &quot;sticks&quot;.</translation>
    </message>
    <message>
        <source>&quot;name&quot; has %1 letters; it can have 1 to %2.</source>
        <translation>&quot;name&quot; a %1 lettres&#x202f;; possible&#xa0;: de 1 à %2.</translation>
    </message>
    <message>
        <source>&quot;branches&quot; has %1 runs; it can have up to %2.</source>
        <translation>&quot;branches&quot; a %1 simulations&#x202f;; possible&#xa0;: jusqu’à %2.</translation>
    </message>
    <message>
        <source>the runs in &quot;branches&quot; have more than %1 events together; remove some.</source>
        <translation>les simulations de &quot;branches&quot; ont ensemble plus de %1 événements&#x202f;; retires-en.</translation>
    </message>
    <message>
        <source>a branch</source>
        <translation>une variante</translation>
    </message>
    <message>
        <source>a text that tells it from others</source>
        <translation>un texte qui la distingue des autres</translation>
    </message>
    <message>
        <source>frame %1 is before the start of the branch, whose &quot;fork&quot; is %2; use frame %2 or a later one.</source>
        <translation>l’image %1 est avant le début de la variante, dont &quot;fork&quot; vaut %2&#x202f;; utilise l’image %2 ou une image ultérieure.</translation>
    </message>
    <message>
        <source>this is a notebook, not an experiment; &quot;springstep notebook check&quot; replays it.</source>
        <translation>c’est un cahier, pas une expérience&#x202f;; «&#x202f;springstep notebook check&#x202f;» le rejoue.</translation>
    </message>
    <message>
        <source>If it is a lesson without C++, open it in the window, or name its folder in SPRINGSTEP_LESSONS.</source>
        <translation>Si c’est une leçon sans C++, ouvre-la dans la fenêtre, ou indique son dossier dans SPRINGSTEP_LESSONS.</translation>
    </message>
</context>
<context>
    <name>ExperimentArgumentText</name>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>%1 is neither a file nor a step; name a step as LESSON/STEP, as &quot;springstep lessons&quot; lists them.</source>
        <translation>%1 n’est ni un fichier ni une étape&#x202f;; nomme une étape par LESSON/STEP, comme les donne «&#x202f;springstep lessons&#x202f;».</translation>
    </message>
</context>
<context>
    <name>ExperimentInput</name>
    <message>
        <source>the step %1 has no event %2; it has %3.</source>
        <translation>l’étape %1 n’a pas d’événement %2&#x202f;; elle a %3.</translation>
    </message>
    <message>
        <source>a body&apos;s name</source>
        <translation>le nom d’un corps</translation>
    </message>
</context>
<context>
    <name>ExperimentLineText</name>
    <message>
        <source>The text begins like an experiment, but it is incomplete. Copy all of it, from “springstep:” to its end.</source>
        <translation>Le texte commence comme une expérience, mais il est incomplet. Copie-le en entier, de «&#x202f;springstep:&#x202f;» jusqu’à la fin.</translation>
    </message>
    <message>
        <source>The text is larger than %1 MiB, the maximum for an experiment.</source>
        <translation>Le texte dépasse %1 Mio, le maximum pour une expérience.</translation>
    </message>
    <message>
        <source>This run has too much input for a message. Save it as a file, and send that.</source>
        <translation>Cette simulation a trop d’entrées pour un message. Enregistre-la dans un fichier et envoie-le.</translation>
    </message>
    <message>
        <source>There is no text to paste. Copy an experiment first: it begins with “springstep:” or {.</source>
        <translation>Il n’y a pas de texte à coller. Copie d’abord une expérience&#xa0;: elle commence par «&#x202f;springstep:&#x202f;» ou {.</translation>
    </message>
    <message>
        <source>The copied text is not an experiment. An experiment begins with “springstep:” or {.</source>
        <translation>Le texte copié n’est pas une expérience. Une expérience commence par «&#x202f;springstep:&#x202f;» ou {.</translation>
    </message>
    <message>
        <source>The text is too long for an experiment in one line. Open it as a file.</source>
        <translation>Le texte est trop long pour une expérience sur une ligne. Ouvre-le comme fichier.</translation>
    </message>
    <message>
        <source>Pasted text</source>
        <translation>Texte collé</translation>
    </message>
</context>
<context>
    <name>ExperimentMethodText</name>
    <message>
        <source>there is no method %1; there is %2.</source>
        <translation>il n’y a pas de méthode %1&#x202f;; il y a %2.</translation>
    </message>
    <message>
        <source>&quot;h&quot; is %1; it can be 0.000001 to 100 frames, a whole number or 1 divided by one: 2, 1, 0.5, 0.25...</source>
        <translation>&quot;h&quot; vaut %1&#x202f;; possible&#xa0;: de 0.000001 à 100 images, un nombre entier ou 1 divisé par un entier&#xa0;: 2, 1, 0.5, 0.25...</translation>
    </message>
    <message>
        <source>&quot;tolerance&quot; is %1; it can be 1e-13 to 100 px.</source>
        <translation>&quot;tolerance&quot; vaut %1&#x202f;; possible&#xa0;: de 1e-13 à 100 px.</translation>
    </message>
    <message>
        <source>the method %1 chooses its own steps; give &quot;tolerance&quot; instead of &quot;h&quot;.</source>
        <translation>la méthode %1 choisit elle-même ses pas de temps&#x202f;; donne &quot;tolerance&quot; au lieu de &quot;h&quot;.</translation>
    </message>
    <message>
        <source>the method %1 has fixed steps; give &quot;h&quot; instead of &quot;tolerance&quot;.</source>
        <translation>la méthode %1 a des pas de temps fixes&#x202f;; donne &quot;h&quot; au lieu de &quot;tolerance&quot;.</translation>
    </message>
    <message>
        <source>&quot;code&quot; needs the method %1; set &quot;method&quot; to it, or remove &quot;code&quot;.</source>
        <translation>&quot;code&quot; exige la méthode %1&#x202f;; mets-la dans &quot;method&quot;, ou retire &quot;code&quot;.</translation>
    </message>
    <message>
        <source>the method %1 needs &quot;code&quot;, the text of a listing.</source>
        <translation>la méthode %1 exige &quot;code&quot;, le texte d’un listing.</translation>
    </message>
    <message>
        <source>%1 has %2 bytes; it can have up to %3.</source>
        <translation>%1 a %2 octets&#x202f;; le maximum est %3.</translation>
    </message>
    <message>
        <source>&quot;code&quot; does not compile. Line %1: %2</source>
        <translation>&quot;code&quot; ne se compile pas. Ligne %1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>ExperimentPointsText</name>
    <message>
        <source>a point&apos;s name</source>
        <translation>le nom d’un point</translation>
    </message>
    <message>
        <source>there is no point %1 here; there is &quot;p0&quot; to %2.</source>
        <translation>il n’y a pas de point %1 ici&#x202f;; il y a de &quot;p0&quot; à %2.</translation>
    </message>
    <message>
        <source>&quot;bodies&quot; has %1 points; the most is %2.</source>
        <translation>&quot;bodies&quot; a %1 points&#x202f;; le maximum est %2.</translation>
    </message>
    <message>
        <source>there is no body %1 here; the points are called &quot;p0&quot;, &quot;p1&quot; and so on.</source>
        <translation>il n’y a pas de corps %1 ici&#x202f;; les points s’appellent &quot;p0&quot;, &quot;p1&quot; et ainsi de suite.</translation>
    </message>
    <message>
        <source>the points have a gap: %1 of them are &quot;p0&quot; to %2, without %3.</source>
        <translation>il y a un trou dans les points&#xa0;: %1 d’entre eux vont de &quot;p0&quot; à %2, sans %3.</translation>
    </message>
    <message>
        <source>&quot;links&quot; has %1 sticks; the most is %2.</source>
        <translation>&quot;links&quot; a %1 tiges&#x202f;; le maximum est %2.</translation>
    </message>
    <message>
        <source>a link</source>
        <translation>une tige</translation>
    </message>
    <message>
        <source>a link has %1 at both ends; give it two points.</source>
        <translation>une tige a %1 à ses deux extrémités&#x202f;; donne-lui deux points.</translation>
    </message>
</context>
<context>
    <name>ExperimentText</name>
    <message>
        <source>there is no lesson %1, as no lesson is installed; SPRINGSTEP_LESSONS can name the folder that has them.</source>
        <translation>il n’y a pas de leçon %1, car aucune leçon n’est installée&#x202f;; SPRINGSTEP_LESSONS peut nommer le dossier où elles sont.</translation>
    </message>
    <message>
        <source>there is no lesson %1; there is %2.</source>
        <translation>il n’y a pas de leçon %1&#x202f;; il y a %2.</translation>
    </message>
    <message>
        <source>the lesson %1 has no step %2; it has %3.</source>
        <translation>la leçon %1 n’a pas d’étape %2&#x202f;; elle a %3.</translation>
    </message>
</context>
<context>
    <name>ExperimentWriterText</name>
    <message>
        <source>a number of this experiment is not finite, and a file cannot store such a number. Go back to an earlier frame.</source>
        <translation>un nombre de cette expérience n’est pas fini, et un fichier ne peut pas stocker un tel nombre. Reviens à une image antérieure.</translation>
    </message>
    <message>
        <source>the file would have too many other runs: it can have %1, with %2 events together. Delete some in “Runs”.</source>
        <translation>le fichier aurait trop d’autres simulations&#xa0;: il peut en avoir %1, avec %2 événements en tout. Supprimes-en dans «&#x202f;Simulations&#x202f;».</translation>
    </message>
    <message>
        <source>the step %1 is no longer installed. Install its lesson again.</source>
        <translation>l’étape %1 n’est plus installée. Réinstalle sa leçon.</translation>
    </message>
    <message>
        <source>the run has more input than a file can store. Restart it, or go back and continue from an earlier frame.</source>
        <translation>la simulation a plus d’entrées qu’un fichier ne peut en stocker. Relance-la, ou reviens en arrière et continue depuis une image antérieure.</translation>
    </message>
    <message>
        <source>your code is longer than %1 bytes, the most that a file can store. Shorten it.</source>
        <translation>ton code dépasse %1 octets, le maximum qu’un fichier peut stocker. Raccourcis-le.</translation>
    </message>
</context>
<context>
    <name>FileCommands</name>
    <message>
        <source>&amp;New: the step as published</source>
        <translation>&amp;Nouveau&#xa0;: l’étape telle que publiée</translation>
    </message>
    <message>
        <source>&amp;Open an experiment or a lesson…</source>
        <translation>&amp;Ouvrir une expérience ou une leçon…</translation>
    </message>
    <message>
        <source>An experiment, or a lesson: its lesson.json or its .springstep-lesson file</source>
        <translation>Une expérience, ou une leçon&#xa0;: son lesson.json ou son fichier .springstep-lesson</translation>
    </message>
    <message>
        <source>Reco&amp;ver scenes…</source>
        <translation>&amp;Récupérer des scènes…</translation>
    </message>
    <message>
        <source>&amp;Save the experiment</source>
        <translation>&amp;Enregistrer l’expérience</translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation>Enregistrer &amp;sous…</translation>
    </message>
    <message>
        <source>&amp;Picture of the scene…</source>
        <translation>&amp;Capture de la scène…</translation>
    </message>
    <message>
        <source>&amp;Film of the run…</source>
        <translation>&amp;Film de la simulation…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Quitter</translation>
    </message>
    <message>
        <source>The scene as it is shown, as PNG or SVG</source>
        <translation>La scène telle qu’on la voit, en PNG ou SVG</translation>
    </message>
    <message>
        <source>The run as a video, an animated GIF or a PNG for each frame</source>
        <translation>La simulation en vidéo, en GIF animé ou en un PNG par image</translation>
    </message>
    <message>
        <source>&amp;Keep in gallery</source>
        <translation>&amp;Garder dans la galerie</translation>
    </message>
    <message>
        <source>&amp;Gallery…</source>
        <translation>Ga&amp;lerie…</translation>
    </message>
    <message>
        <source>Keep the experiment with a picture, without choosing a file</source>
        <translation>Garder l’expérience avec une capture, sans choisir de fichier</translation>
    </message>
    <message>
        <source>What you keep: open, rename or remove it</source>
        <translation>Ce que tu gardes&#xa0;: l’ouvrir, le renommer ou le retirer</translation>
    </message>
    <message>
        <source>&amp;Hand in a notebook…</source>
        <translation>Ren&amp;dre un cahier…</translation>
    </message>
    <message>
        <source>Write what you did into a file for your teacher, or onto a page</source>
        <translation>Écrire ce que tu as fait dans un fichier pour ton enseignant, ou sur une page</translation>
    </message>
    <message>
        <source>&amp;Web page of the run…</source>
        <translation>Page &amp;web de la simulation…</translation>
    </message>
    <message>
        <source>One file that plays the run in any browser, with the listing and the plots</source>
        <translation>Un seul fichier qui joue la simulation dans tout navigateur, avec listing et graphiques</translation>
    </message>
    <message>
        <source>&amp;Handout of the lesson…</source>
        <translation>Fic&amp;he de la leçon…</translation>
    </message>
    <message>
        <source>The lesson on paper, as a PDF: with lines to write on, and the answers at the end</source>
        <translation>La leçon sur papier, en PDF&#xa0;: avec des lignes pour écrire, et les réponses à la fin</translation>
    </message>
</context>
<context>
    <name>FileRowText</name>
    <message>
        <source>File</source>
        <translation>Fichier</translation>
    </message>
    <message>
        <source>&amp;Choose…</source>
        <translation>C&amp;hoisir…</translation>
    </message>
    <message>
        <source>Choose a folder and a name</source>
        <translation>Choisir un dossier et un nom</translation>
    </message>
</context>
<context>
    <name>FilmFileText</name>
    <message>
        <source>Could not write %1: %2. Free some disk space, or choose another folder.</source>
        <translation>Impossible d’écrire %1&#xa0;: %2. Libère de l’espace disque, ou choisis un autre dossier.</translation>
    </message>
    <message>
        <source>%1 is not a film&apos;s name: choose one that ends in .webm or .gif. For a picture of each frame, choose one that ends in .png and has %04d for the frame&apos;s number, such as walk_%04d.png.</source>
        <translation>%1 n’est pas un nom de film&#xa0;: choisis-en un qui finit par .webm ou .gif. Pour une capture par image, choisis un nom qui finit par .png et contient %04d pour le numéro de l’image, comme walk_%04d.png.</translation>
    </message>
</context>
<context>
    <name>FilmText</name>
    <message>
        <source>Frame %1 of %2, %3 %</source>
        <translation>Image %1 sur %2, %3 %</translation>
    </message>
    <message>
        <source>Setting up the run</source>
        <translation>Préparation de la simulation</translation>
    </message>
    <message>
        <source>The last frame, %1, comes before the first, %2. Swap them.</source>
        <translation>La dernière image, %1, vient avant la première, %2. Échange-les.</translation>
    </message>
    <message>
        <source>A GIF shows at most %1 pictures a second, and this would be %2. Choose fewer, or PNG files.</source>
        <translation>Un GIF montre au plus %1 images par seconde, et il y en aurait %2. Choisis-en moins, ou des fichiers PNG.</translation>
    </message>
    <message>
        <source>The run does not reach frame %1: it stops at frame %2. Begin the film earlier.</source>
        <translation>La simulation n’atteint pas l’image %1&#xa0;: elle s’arrête à l’image %2. Commence le film plus tôt.</translation>
    </message>
    <message>
        <source>--fps is for a film in one file; PNG files have no time in them. Leave it out.</source>
        <translation>--fps est pour un film en un seul fichier&#x202f;; les fichiers PNG ne contiennent pas de temps. Omets-le.</translation>
    </message>
    <message>
        <source>%1 For a web page, choose one that ends in .html.</source>
        <translation>%1 Pour une page web, choisis un nom qui finit par .html.</translation>
    </message>
    <message>
        <source>--%1 is for web pages, which end in .html. Leave it out.</source>
        <translation>--%1 est pour les pages web, qui finissent par .html. Enlève cette option.</translation>
    </message>
</context>
<context>
    <name>Gestures</name>
    <message>
        <source>Drag a body</source>
        <translation>Faire glisser un corps</translation>
    </message>
    <message>
        <source>grab it; let go while moving to throw it</source>
        <translation>l’attraper&#x202f;; le lâcher en mouvement pour le lancer</translation>
    </message>
    <message>
        <source>Drag the background</source>
        <translation>Faire glisser l’arrière-plan</translation>
    </message>
    <message>
        <source>move the picture</source>
        <translation>déplacer la vue</translation>
    </message>
    <message>
        <source>Click an arrow at the edge</source>
        <translation>Cliquer sur une flèche au bord</translation>
    </message>
    <message>
        <source>go to the body that it points to</source>
        <translation>aller au corps qu’elle indique</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Molette</translation>
    </message>
    <message>
        <source>zoom where the pointer is</source>
        <translation>zoomer là où est le pointeur</translation>
    </message>
    <message>
        <source>[ and ]</source>
        <translation>[ et ]</translation>
    </message>
    <message>
        <source>select the previous or the next body</source>
        <translation>sélectionner le corps précédent ou suivant</translation>
    </message>
    <message>
        <source>Alt and an arrow key</source>
        <translation>Alt et une flèche du clavier</translation>
    </message>
    <message>
        <source>move the selected body 10 px</source>
        <translation>déplacer le corps sélectionné de 10 px</translation>
    </message>
    <message>
        <source>Press the background</source>
        <translation>Appuyer sur l’arrière-plan</translation>
    </message>
    <message>
        <source>blow, steer or aim, in steps that have this</source>
        <translation>souffler, diriger ou viser, dans les étapes qui le permettent</translation>
    </message>
    <message>
        <source>Drag with the middle button</source>
        <translation>Faire glisser avec le bouton du milieu</translation>
    </message>
    <message>
        <source>Arrow keys</source>
        <translation>Flèches du clavier</translation>
    </message>
    <message>
        <source>steer, in steps that have this</source>
        <translation>diriger, dans les étapes qui le permettent</translation>
    </message>
    <message>
        <source>Alt, Shift and an arrow key</source>
        <translation>Alt, Maj et une flèche du clavier</translation>
    </message>
    <message>
        <source>move the pointer or the target 20 px</source>
        <translation>déplacer le pointeur ou la cible de 20 px</translation>
    </message>
    <message>
        <source>Alt and Enter</source>
        <translation>Alt et Entrée</translation>
    </message>
    <message>
        <source>press or release the pointer&apos;s button</source>
        <translation>enfoncer ou relâcher le bouton du pointeur</translation>
    </message>
    <message>
        <source>Drag an end of the ruler</source>
        <translation>Faire glisser un bout de la règle graduée</translation>
    </message>
    <message>
        <source>measure a length and an angle (switch it on under Show)</source>
        <translation>mesurer une longueur et un angle (à activer dans «&#x202f;Affichage&#x202f;»)</translation>
    </message>
    <message>
        <source>Ctrl, Alt and an arrow key</source>
        <translation>Ctrl, Alt et une flèche du clavier</translation>
    </message>
    <message>
        <source>move the ruler&apos;s far end 5 px; with Shift the near one</source>
        <translation>déplacer de 5 px le bout éloigné de la règle graduée&#x202f;; avec Maj, le bout proche</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>let go</source>
        <translation>lâcher</translation>
    </message>
    <message>
        <source>Click the dots below a ring</source>
        <translation>Cliquer sur les points sous un anneau</translation>
    </message>
    <message>
        <source>compare with the run that branches off there; right-click: more</source>
        <translation>comparer à la simulation qui s’en écarte là&#x202f;; clic droit&#xa0;: plus</translation>
    </message>
    <message>
        <source>Shift and a click</source>
        <translation>Maj et un clic</translation>
    </message>
    <message>
        <source>add a part to the selection, or remove it</source>
        <translation>ajouter un élément à la sélection, ou l’en retirer</translation>
    </message>
    <message>
        <source>select all parts in the box</source>
        <translation>sélectionner tous les éléments du cadre</translation>
    </message>
    <message>
        <source>Drag from point to point</source>
        <translation>Faire glisser d’un point à l’autre</translation>
    </message>
    <message>
        <source>connect them, with the Spring or the Stick tool</source>
        <translation>les relier, avec l’outil Ressort ou Tige</translation>
    </message>
    <message>
        <source>Arrow keys and Enter</source>
        <translation>Flèches du clavier et Entrée</translation>
    </message>
    <message>
        <source>move the tool 10 px, with Shift 1 px; use it</source>
        <translation>déplacer l’outil de 10 px, avec Maj de 1 px&#x202f;; l’utiliser</translation>
    </message>
    <message>
        <source>move the selected parts 10 px, with Shift 1 px</source>
        <translation>déplacer les éléments sélectionnés de 10 px, avec Maj de 1 px</translation>
    </message>
    <message>
        <source>{ and }</source>
        <translation>{ et }</translation>
    </message>
    <message>
        <source>select the previous or the next spring or stick</source>
        <translation>sélectionner le ressort ou la tige précédents ou suivants</translation>
    </message>
    <message>
        <source>Escape</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>end a row of links, put the tool away, clear the selection</source>
        <translation>finir une suite de liens, ranger l’outil, vider la sélection</translation>
    </message>
    <message>
        <source>Drag the timeline</source>
        <translation>Faire glisser la ligne de temps</translation>
    </message>
    <message>
        <source>go anywhere in time</source>
        <translation>aller n’importe où dans le temps</translation>
    </message>
    <message>
        <source>Click a phase</source>
        <translation>Cliquer sur une phase</translation>
    </message>
    <message>
        <source>run to it</source>
        <translation>avancer jusqu’à elle</translation>
    </message>
    <message>
        <source>Point at timeline, phase, plot or trail</source>
        <translation>Pointer temps, phase, graphique ou trace</translation>
    </message>
    <message>
        <source>preview that moment; the run stays at its frame</source>
        <translation>avoir un aperçu de ce moment&#x202f;; la simulation reste à son image</translation>
    </message>
    <message>
        <source>Alt and the underlined letter</source>
        <translation>Alt et la lettre soulignée</translation>
    </message>
    <message>
        <source>use a remedy, when a run has failed</source>
        <translation>utiliser un remède, quand une simulation a échoué</translation>
    </message>
    <message>
        <source>Drop a file on the window</source>
        <translation>Déposer un fichier sur la fenêtre</translation>
    </message>
    <message>
        <source>open it</source>
        <translation>l’ouvrir</translation>
    </message>
    <message>
        <source>Press or drag</source>
        <translation>Appuyer ou faire glisser</translation>
    </message>
    <message>
        <source>go to a frame</source>
        <translation>aller à une image</translation>
    </message>
    <message>
        <source>+ and −, or Ctrl and the wheel</source>
        <translation>+ et −, ou Ctrl et la molette</translation>
    </message>
    <message>
        <source>fewer or more frames</source>
        <translation>moins ou plus d’images</translation>
    </message>
    <message>
        <source>The names above a plot</source>
        <translation>Les noms au-dessus d’un graphique</translation>
    </message>
    <message>
        <source>choose what it shows</source>
        <translation>choisir ce qu’il montre</translation>
    </message>
    <message>
        <source>Menu key, or right-click</source>
        <translation>Touche Menu, ou clic droit</translation>
    </message>
    <message>
        <source>save, copy, keep or remove it</source>
        <translation>l’enregistrer, le copier, le garder ou le retirer</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Suppr</translation>
    </message>
    <message>
        <source>remove it</source>
        <translation>le retirer</translation>
    </message>
    <message>
        <source>Click a line, or Enter</source>
        <translation>Cliquer sur une ligne, ou Entrée</translation>
    </message>
    <message>
        <source>run to its phase</source>
        <translation>avancer jusqu’à sa phase</translation>
    </message>
    <message>
        <source>Click left of a line, or %1</source>
        <translation>Cliquer à gauche d’une ligne, ou %1</translation>
    </message>
    <message>
        <source>set or remove a breakpoint before its phase</source>
        <translation>poser ou retirer un point d’arrêt avant sa phase</translation>
    </message>
    <message>
        <source>Drag a dotted word</source>
        <translation>Faire glisser un mot pointillé</translation>
    </message>
    <message>
        <source>change that parameter; with Shift in small steps</source>
        <translation>changer ce paramètre&#x202f;; avec Maj, peu à peu</translation>
    </message>
    <message>
        <source>Double-click it, or %1</source>
        <translation>Double-cliquer dessus, ou %1</translation>
    </message>
    <message>
        <source>type the parameter&apos;s value</source>
        <translation>saisir la valeur du paramètre</translation>
    </message>
    <message>
        <source>Point at a word, or %1</source>
        <translation>Pointer un mot, ou %1</translation>
    </message>
    <message>
        <source>its value, and its last 120 frames</source>
        <translation>sa valeur, et ses 120 dernières images</translation>
    </message>
    <message>
        <source>Up and Down</source>
        <translation>Haut et Bas</translation>
    </message>
    <message>
        <source>from line to line; with Ctrl from heading to heading</source>
        <translation>de ligne en ligne&#x202f;; avec Ctrl, de titre en titre</translation>
    </message>
    <message>
        <source>Ctrl and Left or Right</source>
        <translation>Ctrl et Gauche ou Droite</translation>
    </message>
    <message>
        <source>from word to word</source>
        <translation>de mot en mot</translation>
    </message>
    <message>
        <source>Enter, on a heading</source>
        <translation>Entrée, sur un titre</translation>
    </message>
    <message>
        <source>fold or unfold</source>
        <translation>replier ou déplier</translation>
    </message>
    <message>
        <source>show the lines that this step removed</source>
        <translation>montrer les lignes que cette étape a retirées</translation>
    </message>
    <message>
        <source>copy the selection, or the whole region</source>
        <translation>copier la sélection, ou toute la zone</translation>
    </message>
    <message>
        <source>Stop when…</source>
        <translation>Arrêter quand…</translation>
    </message>
    <message>
        <source>the field below the code: stop when a condition becomes true</source>
        <translation>le champ sous le code&#xa0;: arrêter quand une condition devient vraie</translation>
    </message>
    <message>
        <source>walk through the points of a plot</source>
        <translation>parcourir les points d’un graphique</translation>
    </message>
    <message>
        <source>Enter or a click</source>
        <translation>Entrée ou un clic</translation>
    </message>
    <message>
        <source>use the method and step of a point</source>
        <translation>utiliser la méthode et le pas de temps d’un point</translation>
    </message>
    <message>
        <source>+ and −, or drag the line</source>
        <translation>+ et −, ou faire glisser la ligne</translation>
    </message>
    <message>
        <source>set the largest error that you accept</source>
        <translation>fixer la plus grande erreur que tu acceptes</translation>
    </message>
    <message>
        <source>Click left of a line, in the listing</source>
        <translation>Cliquer à gauche d’une ligne, dans le listing</translation>
    </message>
    <message>
        <source>Point at a place or a velocity, in the listing</source>
        <translation>Pointer position ou vitesse, dans le listing</translation>
    </message>
    <message>
        <source>see it in the picture</source>
        <translation>la voir dans la vue</translation>
    </message>
    <message>
        <source>Drag a number, in the listing</source>
        <translation>Faire glisser un nombre, dans le listing</translation>
    </message>
    <message>
        <source>change it; with Shift in small steps</source>
        <translation>le changer&#x202f;; avec Maj, peu à peu</translation>
    </message>
    <message>
        <source>%1, in the listing</source>
        <translation>%1, dans le listing</translation>
    </message>
    <message>
        <source>complete a name</source>
        <translation>compléter un nom</translation>
    </message>
    <message>
        <source>Esc, in the listing</source>
        <translation>Échap, dans le listing</translation>
    </message>
    <message>
        <source>leave it, so that keys move the run again</source>
        <translation>le quitter, pour que les touches commandent à nouveau la simulation</translation>
    </message>
    <message>
        <source>Ctrl and a click left of a line, or %1, in the listing</source>
        <translation>Ctrl et clic à gauche, ou %1, dans le listing</translation>
    </message>
    <message>
        <source>set or remove a breakpoint before it</source>
        <translation>poser ou retirer un point d’arrêt avant elle</translation>
    </message>
</context>
<context>
    <name>GroundLayersText</name>
    <message>
        <source>%1&#x202f;px</source>
        <translation>%1&#x202f;px</translation>
    </message>
</context>
<context>
    <name>Gui</name>
    <message>
        <source>No lesson was found in %1. Build the lessons, or name their folder in SPRINGSTEP_LESSONS.</source>
        <translation>Aucune leçon trouvée dans %1. Compile les leçons, ou nomme leur dossier dans SPRINGSTEP_LESSONS.</translation>
    </message>
    <message>
        <source>%1 could not be written: give a folder that you may write to, and a name that ends in .png or .jpg.</source>
        <translation>%1 n’a pas pu être écrit&#xa0;: donne un dossier où tu as le droit d’écrire, et un nom qui finit par .png ou .jpg.</translation>
    </message>
</context>
<context>
    <name>Handout</name>
    <message>
        <source>Name:</source>
        <translation>Nom&#xa0;:</translation>
    </message>
    <message>
        <source>Date:</source>
        <translation>Date&#xa0;:</translation>
    </message>
    <message>
        <source>Answers: %1</source>
        <translation>Réponses&#xa0;: %1</translation>
    </message>
    <message>
        <source>Predict</source>
        <translation>Prédis</translation>
    </message>
    <message>
        <source>Mark the place in the picture.</source>
        <translation>Marque l’endroit sur le dessin.</translation>
    </message>
    <message>
        <source>Try this</source>
        <translation>À toi d’essayer</translation>
    </message>
    <message>
        <source>Write it yourself: %1</source>
        <translation>Écris-le toi-même&#xa0;: %1</translation>
    </message>
    <message>
        <source>Build: %1</source>
        <translation>Construis&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>HandoutCliText</name>
    <message>
        <source>handout: %1</source>
        <translation>handout: %1</translation>
    </message>
    <message>
        <source>%1 is not the name of a handout; it ends in .pdf.</source>
        <translation>%1 n’est pas un nom de fiche&#x202f;; il doit finir par .pdf.</translation>
    </message>
    <message>
        <source>%1 of %2 pictures</source>
        <translation>%1 vues sur %2</translation>
    </message>
    <message>
        <source>Stopped before the handout was written.</source>
        <translation>Arrêt avant que la fiche soit écrite.</translation>
    </message>
</context>
<context>
    <name>HandoutExportText</name>
    <message>
        <source>Handout of the lesson</source>
        <translation>Fiche de la leçon</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>The pictures of “%1” are drawn…</source>
        <translation>Les vues de «&#x202f;%1&#x202f;» sont dessinées…</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
</context>
<context>
    <name>HardCasesText</name>
    <message>
        <source>There is no case %1; there is %2.</source>
        <translation>Il n’y a pas de cas %1&#x202f;; il y a %2.</translation>
    </message>
    <message>
        <source>%1, %2: %3 %</source>
        <translation>%1, %2&#xa0;: %3 %</translation>
    </message>
</context>
<context>
    <name>HardReportText</name>
    <message>
        <source>method</source>
        <translation>méthode</translation>
    </message>
    <message>
        <source>claims</source>
        <translation>promet</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>images</translation>
    </message>
    <message>
        <source>ns/frame</source>
        <translation>ns/image</translation>
    </message>
    <message>
        <source>BROKEN</source>
        <translation>ROMPU</translation>
    </message>
    <message>
        <source>fails</source>
        <translation>échoue</translation>
    </message>
    <message>
        <source>%1 of %2 runs are claimed</source>
        <translation>%1 simulations sur %2 sont promises</translation>
    </message>
    <message>
        <source>, and all of those hold.</source>
        <translation>, et toutes celles-là tiennent.</translation>
    </message>
    <message>
        <source>, and %1 of those fail: %2.</source>
        <translation>, et %1 d’entre elles échouent&#xa0;: %2.</translation>
    </message>
    <message>
        <source>holds</source>
        <translation>tient</translation>
    </message>
</context>
<context>
    <name>HelpCommands</name>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>&amp;Touches et souris</translation>
    </message>
    <message>
        <source>Show a &amp;hint</source>
        <translation>Afficher un &amp;indice</translation>
    </message>
    <message>
        <source>&amp;Glossary</source>
        <translation>&amp;Glossaire</translation>
    </message>
    <message>
        <source>Take the &amp;tour</source>
        <translation>Faire la &amp;visite</translation>
    </message>
    <message>
        <source>&amp;About Springstep</source>
        <translation>À &amp;propos de Springstep</translation>
    </message>
    <message>
        <source>A hint for the next thing to try</source>
        <translation>Un indice pour le prochain essai</translation>
    </message>
    <message>
        <source>The words that the lessons teach</source>
        <translation>Les mots qu’enseignent les leçons</translation>
    </message>
    <message>
        <source>A one-minute tour of this window</source>
        <translation>Une visite de cette fenêtre en une minute</translation>
    </message>
    <message>
        <source>Version, licence and libraries</source>
        <translation>Version, licence et bibliothèques</translation>
    </message>
    <message>
        <source>&amp;Map of concepts</source>
        <translation>&amp;Carte des notions</translation>
    </message>
    <message>
        <source>The concepts of all lessons: what rests on what, and what you know</source>
        <translation>Les notions de toutes les leçons&#xa0;: ce qui repose sur quoi, et ce que tu sais</translation>
    </message>
</context>
<context>
    <name>Highlights</name>
    <message>
        <source>%1&#x2009;px/frame</source>
        <translation>%1 px/image</translation>
    </message>
    <message>
        <source>the arrow from %1 to %2</source>
        <translation>la flèche de %1 à %2</translation>
    </message>
    <message>
        <source>x from %1 to %2</source>
        <translation>x de %1 à %2</translation>
    </message>
    <message>
        <source>y from %1 to %2</source>
        <translation>y de %1 à %2</translation>
    </message>
    <message>
        <source>the velocity of %1</source>
        <translation>la vitesse de %1</translation>
    </message>
    <message>
        <source>the circle around %1</source>
        <translation>le cercle autour de %1</translation>
    </message>
</context>
<context>
    <name>HudText</name>
    <message>
        <source>%1 (before: %2)</source>
        <translation>%1 (avant&#xa0;: %2)</translation>
    </message>
    <message>
        <source>your method</source>
        <translation>ta méthode</translation>
    </message>
    <message>
        <source>reference, ±%1</source>
        <translation>référence, ±%1</translation>
    </message>
    <message>
        <source>every %1 frames</source>
        <translation>toutes les %1 images</translation>
    </message>
    <message>
        <source>rest length</source>
        <translation>longueur à vide</translation>
    </message>
    <message>
        <source>velocity of %1&#x2009;px/frame</source>
        <translation>vitesse de %1 px/image</translation>
    </message>
    <message>
        <source>pull of %1&#x2009;px/frame²</source>
        <translation>traction de %1 px/image²</translation>
    </message>
</context>
<context>
    <name>JsonDocumentText</name>
    <message>
        <source>%1 is too large for a number; the largest is %2.</source>
        <translation>%1 est trop grand pour un nombre&#x202f;; le plus grand est %2.</translation>
    </message>
    <message>
        <source>%1 is given twice; keep one of them.</source>
        <translation>%1 est donné deux fois&#x202f;; n’en garde qu’un.</translation>
    </message>
    <message>
        <source>lists and objects are nested more than %1 deep here; an experiment needs only 3 levels.</source>
        <translation>des listes et des objets sont imbriqués ici plus de %1 fois&#x202f;; une expérience n’a besoin que de 3 niveaux.</translation>
    </message>
    <message>
        <source>here begins one value too many; an experiment has at most %1 values.</source>
        <translation>ici commence une valeur de trop&#x202f;; une expérience a au plus %1 valeurs.</translation>
    </message>
    <message>
        <source>there is text after the end; remove everything after the closing bracket.</source>
        <translation>il y a du texte après la fin&#x202f;; enlève tout ce qui suit le crochet ou l’accolade de fermeture.</translation>
    </message>
    <message>
        <source>a name in double quotes is expected here.</source>
        <translation>un nom entre guillemets doubles est attendu ici.</translation>
    </message>
    <message>
        <source>a colon is expected here, between a name and its value.</source>
        <translation>un deux-points est attendu ici, entre un nom et sa valeur.</translation>
    </message>
    <message>
        <source>a comma or a closing } is expected here.</source>
        <translation>une virgule ou une } fermante est attendue ici.</translation>
    </message>
    <message>
        <source>a comma or a closing ] is expected here.</source>
        <translation>une virgule ou un ] fermant est attendu ici.</translation>
    </message>
    <message>
        <source>a text in double quotes is not valid; it must end on its own line, and only &quot; \ / b f n r t u may follow a \.</source>
        <translation>un texte entre guillemets doubles n’est pas valable&#x202f;; il doit finir sur sa ligne, et seuls &quot; \ / b f n r t u peuvent suivre un \.</translation>
    </message>
    <message>
        <source>a text has bytes that are not UTF-8; save the file as UTF-8.</source>
        <translation>un texte a des octets qui ne sont pas de l’UTF-8&#x202f;; enregistre le fichier en UTF-8.</translation>
    </message>
    <message>
        <source>a number is too large; the largest is %1.</source>
        <translation>un nombre est trop grand&#x202f;; le plus grand est %1.</translation>
    </message>
    <message>
        <source>a number is not complete; write it as 0.5 or 5e-1.</source>
        <translation>un nombre n’est pas complet&#x202f;; écris-le comme 0.5 ou 5e-1.</translation>
    </message>
    <message>
        <source>this is not JSON; a value is a number, a &quot;text&quot;, true, false, null, a [list] or an {object}.</source>
        <translation>ce n’est pas du JSON&#x202f;; une valeur est un nombre, un &quot;texte&quot;, true, false, null, une [liste] ou un {objet}.</translation>
    </message>
    <message>
        <source>%1: line %2: there is a zero byte; an experiment is JSON text in UTF-8.</source>
        <translation>%1&#xa0;: ligne %2&#xa0;: il y a un octet nul&#x202f;; une expérience est du texte JSON en UTF-8.</translation>
    </message>
    <message>
        <source>%1: line 1: the file is empty; it must begin with {.</source>
        <translation>%1&#xa0;: ligne 1&#xa0;: le fichier est vide&#x202f;; il doit commencer par {.</translation>
    </message>
    <message>
        <source>the file ends here too early; the rest of it is missing.</source>
        <translation>le fichier se termine ici trop tôt&#x202f;; le reste manque.</translation>
    </message>
    <message>
        <source>%1: line %2: %3</source>
        <translation>%1&#xa0;: ligne %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1: this is a zip. The window opens a zipped lesson if its name ends in .springstep-lesson.</source>
        <translation>%1&#xa0;: c’est un zip. La fenêtre ouvre une leçon en zip si son nom finit par .springstep-lesson.</translation>
    </message>
    <message>
        <source>nothing follows the last comma before this %1; remove the comma.</source>
        <translation>rien ne suit la dernière virgule avant ce %1&#x202f;; enlève la virgule.</translation>
    </message>
</context>
<context>
    <name>JsonFieldsText</name>
    <message>
        <source>%1 is %2; it must be %3.</source>
        <translation>%1 est %2&#x202f;; il faut %3.</translation>
    </message>
    <message>
        <source>%1: line %2: %3</source>
        <translation>%1&#xa0;: ligne %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>the text %1</source>
        <translation>le texte %1</translation>
    </message>
    <message>
        <source>a list</source>
        <translation>une liste</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objet</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true ou false</translation>
    </message>
    <message>
        <source>a text in double quotes</source>
        <translation>un texte entre guillemets doubles</translation>
    </message>
    <message>
        <source>a list in [ ]</source>
        <translation>une liste entre [ ]</translation>
    </message>
    <message>
        <source>%1 is %2; it can be a whole number from %3 to %4.</source>
        <translation>%1 vaut %2&#x202f;; possible&#xa0;: un nombre entier de %3 à %4.</translation>
    </message>
    <message>
        <source>beyond 2^53</source>
        <translation>au-delà de 2^53</translation>
    </message>
    <message>
        <source>%1 is %2; it must be an object in { }.</source>
        <translation>%1 est %2&#x202f;; il faut un objet entre { }.</translation>
    </message>
    <message>
        <source>%1 has no %2; add it. It must be %3.</source>
        <translation>%1 n’a pas de %2&#x202f;; ajoute-le. Il faut %3.</translation>
    </message>
    <message>
        <source>%1 has no field %2; there is %3.</source>
        <translation>%1 n’a pas de champ %2&#x202f;; il y a %3.</translation>
    </message>
    <message>
        <source>%1 is %2; it can be %3 to %4.</source>
        <translation>%1 vaut %2&#x202f;; possible&#xa0;: de %3 à %4.</translation>
    </message>
</context>
<context>
    <name>KeyNames</name>
    <message>
        <source>Page Up</source>
        <translation>Page haut</translation>
    </message>
    <message>
        <source>Page Down</source>
        <translation>Page bas</translation>
    </message>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Maj</translation>
    </message>
</context>
<context>
    <name>LessonCheckText</name>
    <message>
        <source>the listing does not compile</source>
        <translation>le listing ne se compile pas</translation>
    </message>
    <message>
        <source>one of them stops in frame %1</source>
        <translation>l’un des deux s’arrête à l’image %1</translation>
    </message>
    <message>
        <source>the listing moves %1 otherwise than the method %2: %3 px apart in frame %4 of a trial run</source>
        <translation>le listing déplace %1 autrement que la méthode %2&#xa0;: %3 px d’écart à l’image %4 d’une simulation d’essai</translation>
    </message>
    <message>
        <source>same motion as %1</source>
        <translation>même mouvement que %1</translation>
    </message>
    <message>
        <source>it is done in frame %1 without the learner; add a condition such as “- begun: released()”</source>
        <translation>il est fait à l’image %1 sans l’élève&#x202f;; ajoute une condition comme «&#x202f;- begun: released()&#x202f;»</translation>
    </message>
    <message>
        <source>it states no solution; write a “### Solution”</source>
        <translation>il n’indique pas de solution&#x202f;; écris un «&#x202f;### Solution&#x202f;»</translation>
    </message>
    <message>
        <source>done in frame %1</source>
        <translation>fait à l’image %1</translation>
    </message>
    <message>
        <source>its solution does not do it in %1 frames</source>
        <translation>sa solution n’y parvient pas en %1 images</translation>
    </message>
    <message>
        <source>its solution does not do it in %1 frames: %2</source>
        <translation>sa solution n’y parvient pas en %1 images&#xa0;: %2</translation>
    </message>
    <message>
        <source>its solution does not do it in %1 frames: each condition holds in some frame, but they never all hold in the same one</source>
        <translation>sa solution n’y parvient pas en %1 images&#xa0;: chaque condition est vraie dans une image, mais elles ne le sont jamais toutes dans la même</translation>
    </message>
    <message>
        <source>its condition does not hold up to frame %1</source>
        <translation>sa condition n’est pas remplie jusqu’à l’image %1</translation>
    </message>
    <message>
        <source>ends in frame %1</source>
        <translation>finit à l’image %1</translation>
    </message>
    <message>
        <source>%1, at (%2, %3)</source>
        <translation>%1, en (%2, %3)</translation>
    </message>
    <message>
        <source>%1, with %2</source>
        <translation>%1, avec %2</translation>
    </message>
    <message>
        <source>two of its curves look the same</source>
        <translation>deux de ses courbes se ressemblent</translation>
    </message>
    <message>
        <source>the listing itself does not pass</source>
        <translation>le listing lui-même ne réussit pas</translation>
    </message>
    <message>
        <source>the empty place passes</source>
        <translation>l’emplacement vide réussit</translation>
    </message>
    <message>
        <source>near miss %1 is not told from the others or from the solution</source>
        <translation>l’essai presque juste %1 ne se distingue pas des autres ou de la solution</translation>
    </message>
    <message>
        <source>passes, with %1 near misses</source>
        <translation>réussit, avec %1 essais presque justes</translation>
    </message>
    <message>
        <source>there is no step %1</source>
        <translation>il n’y a pas d’étape %1</translation>
    </message>
    <message>
        <source>the start scene passes</source>
        <translation>la scène de départ réussit</translation>
    </message>
    <message>
        <source>it states no solution; save one as %1</source>
        <translation>il n’indique pas de solution&#x202f;; enregistres-en une sous %1</translation>
    </message>
    <message>
        <source>%1 passes</source>
        <translation>%1 réussit</translation>
    </message>
    <message>
        <source>has %1 choices</source>
        <translation>a %1 réponses au choix</translation>
    </message>
    <message>
        <source>%1, in which the hand holds it. Every body can be held: write “if (%2.held) %2.position = hand;”, and leave the forces out then</source>
        <translation>%1, pendant que la main le tient. Tout corps peut être tenu&#xa0;: écris «&#x202f;if (%2.held) %2.position = hand;&#x202f;», et laisse alors les forces de côté</translation>
    </message>
</context>
<context>
    <name>LessonFolderText</name>
    <message>
        <source>%1: this is not UTF-8. Save the file with the encoding UTF-8.</source>
        <translation>%1&#xa0;: ce n’est pas de l’UTF-8. Enregistre le fichier avec l’encodage UTF-8.</translation>
    </message>
    <message>
        <source>the file</source>
        <translation>le fichier</translation>
    </message>
    <message>
        <source>&quot;format&quot; is %1; this program reads %2.</source>
        <translation>&quot;format&quot; vaut %1&#x202f;; ce programme lit %2.</translation>
    </message>
    <message>
        <source>a name of your own</source>
        <translation>un nom à toi</translation>
    </message>
    <message>
        <source>a lesson cannot have the id %1; an id has up to 40 characters, a to z, 0 to 9 and _, and begins with a letter.</source>
        <translation>une leçon ne peut pas avoir l’identifiant %1&#x202f;; un identifiant a au plus 40 caractères, a à z, 0 à 9 et _, et commence par une lettre.</translation>
    </message>
    <message>
        <source>there is another lesson with the id %1, “%2”. Choose another id.</source>
        <translation>il y a une autre leçon avec l’identifiant %1, «&#x202f;%2&#x202f;». Choisis un autre identifiant.</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>%1 has %2 characters; it can have 1 to %3.</source>
        <translation>%1 a %2 caractères&#x202f;; possible&#xa0;: de 1 à %3.</translation>
    </message>
    <message>
        <source>a list of ids</source>
        <translation>une liste d’identifiants</translation>
    </message>
    <message>
        <source>a step cannot have the id %1; each has one of its own, made of a to z, 0 to 9 and _, and not lesson, recall or project.</source>
        <translation>une étape ne peut pas avoir l’identifiant %1&#x202f;; chacune a le sien, fait de a à z, 0 à 9 et _, et qui n’est pas lesson, recall ou project.</translation>
    </message>
    <message>
        <source>a lesson has 1 to %1 steps, and &quot;steps&quot; lists %2.</source>
        <translation>une leçon a de 1 à %1 étapes, et &quot;steps&quot; en cite %2.</translation>
    </message>
    <message>
        <source>%1: the file is missing. It has %2.</source>
        <translation>%1&#xa0;: le fichier manque. Il contient %2.</translation>
    </message>
    <message>
        <source>%1: the listing has more than %2 bytes.</source>
        <translation>%1&#xa0;: le listing a plus de %2 octets.</translation>
    </message>
    <message>
        <source>%1: a listing computes whole frames, and the scene has steps of another length. Set &quot;h&quot; to 1 in %2.json.</source>
        <translation>%1&#xa0;: un listing calcule des images entières, et la scène a des pas de temps d’une autre longueur. Mets &quot;h&quot; à 1 dans %2.json.</translation>
    </message>
    <message>
        <source>%1: a near miss of the task %2 does not compile: %3</source>
        <translation>%1&#xa0;: un essai presque juste de l’exercice %2 ne se compile pas&#xa0;: %3</translation>
    </message>
    <message>
        <source>%1: a lesson has files .md, .json and .code. Remove it.</source>
        <translation>%1&#xa0;: une leçon a des fichiers .md, .json et .code. Retire-le.</translation>
    </message>
    <message>
        <source>%1: there is no step %2 in &quot;steps&quot; of lesson.json; there is %3. Add it there, or rename the file.</source>
        <translation>%1&#xa0;: il n’y a pas d’étape %2 dans &quot;steps&quot; de lesson.json&#x202f;; il y a %3. Ajoute-la là, ou renomme le fichier.</translation>
    </message>
    <message>
        <source>the scene that the project starts with</source>
        <translation>la scène par laquelle le projet commence</translation>
    </message>
    <message>
        <source>a text cannot show pictures. The scene is the picture; remove “![”.</source>
        <translation>un texte ne peut pas montrer d’images. La scène est l’image&#x202f;; retire «&#x202f;![&#x202f;».</translation>
    </message>
    <message>
        <source>the scene of the step: save it in the window under this name, with the ending .json</source>
        <translation>la scène de l’étape&#xa0;: enregistre-la dans la fenêtre sous ce nom, terminé par .json</translation>
    </message>
    <message>
        <source>the texts of the step. Write the file, or remove the step from lesson.json</source>
        <translation>les textes de l’étape. Écris le fichier, ou enlève l’étape de lesson.json</translation>
    </message>
    <message>
        <source>%1: a listing computes this scene. Choose a method in the window, and write the listing into %2.code.</source>
        <translation>%1&#xa0;: un listing calcule cette scène. Choisis une méthode dans la fenêtre, et écris le listing dans %2.code.</translation>
    </message>
    <message>
        <source>%1: a step has at most %2 things to try, predictions and tasks, and a thing to try as many conditions and drags.</source>
        <translation>%1&#xa0;: une étape a au plus %2 essais, prédictions et exercices, et un essai autant de conditions et de gestes de souris.</translation>
    </message>
    <message>
        <source>%1 says where the parameter %2 begins. Remove it here.</source>
        <translation>%1 dit où commence le paramètre %2. Supprime-le ici.</translation>
    </message>
    <message>
        <source>%1: the scene is one of the lesson %2, which is not built in. Open that lesson, choose File &gt; New lesson from this scene, and take the scene that this writes.</source>
        <translation>%1&#xa0;: la scène est de la leçon %2, qui n’est pas intégrée. Ouvre cette leçon, choisis Fichier &gt; Nouvelle leçon à partir de cette scène, et prends la scène ainsi écrite.</translation>
    </message>
</context>
<context>
    <name>LessonLanguagesText</name>
    <message>
        <source>%1, step %2: the languages differ in %3. Make them the same.</source>
        <translation>%1, étape %2&#xa0;: les langues diffèrent par %3. Rends-les identiques.</translation>
    </message>
    <message>
        <source>their predictions</source>
        <translation>leurs prédictions</translation>
    </message>
    <message>
        <source>their tasks</source>
        <translation>leurs exercices</translation>
    </message>
    <message>
        <source>their questions</source>
        <translation>leurs questions</translation>
    </message>
</context>
<context>
    <name>LessonPackageText</name>
    <message>
        <source>%1 is a link or a device. Put the file itself there.</source>
        <translation>%1 est un lien ou un périphérique. Mets le fichier lui-même à cet endroit.</translation>
    </message>
    <message>
        <source>%1: a lesson has at most %2 files, with %3 MiB in all of them.</source>
        <translation>%1&#xa0;: une leçon a au plus %2 fichiers, avec %3 Mio en tout.</translation>
    </message>
    <message>
        <source>%1: there is no such folder or file; check its name.</source>
        <translation>%1&#xa0;: ce dossier ou fichier n’existe pas&#x202f;; vérifie son nom.</translation>
    </message>
    <message>
        <source>%1: there is no lesson.json, which describes the lesson. Choose the folder that has it, or write it.</source>
        <translation>%1&#xa0;: il n’y a pas de lesson.json, qui décrit la leçon. Choisis le dossier qui le contient, ou écris-le.</translation>
    </message>
</context>
<context>
    <name>LessonParametersText</name>
    <message>
        <source>a parameter cannot be called “%1”: the word has another meaning in code, in conditions or in runs. Choose another id.</source>
        <translation>un paramètre ne peut pas s’appeler «&#x202f;%1&#x202f;»&#xa0;: ce mot a un autre sens dans le code, les conditions ou les simulations. Choisis un autre identifiant.</translation>
    </message>
    <message>
        <source>the parameter “%1” has no range. Write “- minimum: 0” and “- maximum: 1” below its text, with your numbers.</source>
        <translation>le paramètre «&#x202f;%1&#x202f;» n’a pas d’intervalle. Écris «&#x202f;- minimum: 0&#x202f;» et «&#x202f;- maximum: 1&#x202f;» sous son texte, avec tes nombres.</translation>
    </message>
    <message>
        <source>the minimum of “%1” is not below its maximum. Change one of them.</source>
        <translation>le minimum de «&#x202f;%1&#x202f;» n’est pas inférieur à son maximum. Change l’un des deux.</translation>
    </message>
    <message>
        <source>“%1” begins with the value that the scene has there. Remove “- value”.</source>
        <translation>«&#x202f;%1&#x202f;» commence par la valeur que la scène a à cet endroit. Supprime «&#x202f;- value&#x202f;».</translation>
    </message>
    <message>
        <source>the parameter “%1” has no value at the start. Write “- value: %2”, or “- sets: k of a-b” with the names of two bodies that a spring joins.</source>
        <translation>le paramètre «&#x202f;%1&#x202f;» n’a pas de valeur au début. Écris «&#x202f;- value: %2&#x202f;», ou «&#x202f;- sets: k of a-b&#x202f;» avec les noms de deux corps qu’un ressort relie.</translation>
    </message>
    <message>
        <source>the step of “%1” is 1, so its numbers are whole. Choose a smaller step, such as 0.1.</source>
        <translation>le pas de «&#x202f;%1&#x202f;» est 1, ses nombres sont donc entiers. Choisis un pas plus petit, par exemple 0.1.</translation>
    </message>
    <message>
        <source>the value of “%1” is %2, outside its range from %3 to %4. Change one of them.</source>
        <translation>la valeur de «&#x202f;%1&#x202f;» est %2, en dehors de son intervalle de %3 à %4. Change l’un des deux.</translation>
    </message>
    <message>
        <source>the %1 of “%2” differs between the languages. Remove it here: the numbers are in the first language.</source>
        <translation>«&#x202f;%1&#x202f;» de «&#x202f;%2&#x202f;» diffère selon la langue. Supprime-le ici&#xa0;: les nombres sont dans la première langue.</translation>
    </message>
    <message>
        <source>the parameter “%1” is missing. Write “## Parameter: name {#%1}”, and a sentence below it.</source>
        <translation>le paramètre «&#x202f;%1&#x202f;» manque. Écris «&#x202f;## Parameter: nom {#%1}&#x202f;», et une phrase en dessous.</translation>
    </message>
    <message>
        <source>%1 declares no parameter “%2”. Remove it here, or add it there.</source>
        <translation>%1 ne déclare pas de paramètre «&#x202f;%2&#x202f;». Supprime-le ici ou ajoute-le là-bas.</translation>
    </message>
    <message>
        <source>“sets” differs between the languages. Remove it here.</source>
        <translation>«&#x202f;sets&#x202f;» diffère selon la langue. Supprime-le ici.</translation>
    </message>
    <message>
        <source>“%1” is not something that a parameter can set. Write “k of a-b” or “length of a-b” with the names of two bodies, and commas between several.</source>
        <translation>Un paramètre ne peut pas régler «&#x202f;%1&#x202f;». Écris «&#x202f;k of a-b&#x202f;» ou «&#x202f;length of a-b&#x202f;» avec les noms de deux corps, et des virgules entre plusieurs.</translation>
    </message>
    <message>
        <source>no spring of the scene joins “%1” and “%2”. Springs join %3.</source>
        <translation>aucun ressort de la scène ne relie «&#x202f;%1&#x202f;» et «&#x202f;%2&#x202f;». Les ressorts relient&#xa0;: %3.</translation>
    </message>
    <message>
        <source>no spring or stick of the scene joins “%1” and “%2”. They join %3.</source>
        <translation>aucun ressort et aucune tige de la scène ne relie «&#x202f;%1&#x202f;» et «&#x202f;%2&#x202f;». Ils relient&#xa0;: %3.</translation>
    </message>
    <message>
        <source>“%1” can be %2 to %3 in a scene, and the parameter goes from %4 to %5. Change its minimum or maximum.</source>
        <translation>«&#x202f;%1&#x202f;» peut aller de %2 à %3 dans une scène, et le paramètre va de %4 à %5. Change son minimum ou son maximum.</translation>
    </message>
    <message>
        <source>a parameter of your own needs a scene of the sandbox. Remove “%1”, or take the scene to the sandbox (Ctrl+B) and save it there.</source>
        <translation>un paramètre à toi a besoin d’une scène du bac à sable. Supprime «&#x202f;%1&#x202f;», ou emmène la scène dans le bac à sable (Ctrl+B) et enregistre-la là-bas.</translation>
    </message>
    <message>
        <source>“%1” sets several numbers, of which one is %2 and another is %3 in the scene. Make them the same there, or use two parameters.</source>
        <translation>«&#x202f;%1&#x202f;» règle plusieurs nombres, dont l’un est %2 et un autre %3 dans la scène. Rends-les égaux là-bas, ou prends deux paramètres.</translation>
    </message>
    <message>
        <source>the scene has %1 there, which does not fit the parameter “%2” from %3 to %4. Change its minimum, maximum or step, or the scene.</source>
        <translation>la scène a %1 à cet endroit, ce qui ne convient pas au paramètre «&#x202f;%2&#x202f;» de %3 à %4. Change son minimum, son maximum ou son pas, ou la scène.</translation>
    </message>
    <message>
        <source>the scene has a parameter “%1” already. Choose another id.</source>
        <translation>la scène a déjà un paramètre «&#x202f;%1&#x202f;». Choisis un autre identifiant.</translation>
    </message>
    <message>
        <source>bodies of the scene are called “%1”. Choose another id.</source>
        <translation>des corps de la scène s’appellent «&#x202f;%1&#x202f;». Choisis un autre identifiant.</translation>
    </message>
    <message>
        <source>nothing reads the parameter “%1”. Write %1 into the rule of the scene in place of a number, or let it set one: “- sets: k of a-b”.</source>
        <translation>rien ne lit le paramètre «&#x202f;%1&#x202f;». Écris %1 dans la règle de la scène à la place d’un nombre, ou fais-lui en régler un&#xa0;: «&#x202f;- sets: k of a-b&#x202f;».</translation>
    </message>
    <message>
        <source>the scene has no springs. Build one, or write “- value: ” in place of “- sets: ”.</source>
        <translation>la scène n’a pas de ressorts. Construis-en un, ou écris «&#x202f;- value:&#x202f;» à la place de «&#x202f;- sets:&#x202f;».</translation>
    </message>
    <message>
        <source>the scene has no springs or sticks. Build one, or write “- value: ” in place of “- sets: ”.</source>
        <translation>la scène n’a ni ressorts ni tiges. Construis-en, ou écris «&#x202f;- value:&#x202f;» à la place de «&#x202f;- sets:&#x202f;».</translation>
    </message>
</context>
<context>
    <name>LessonPluginText</name>
    <message>
        <source>It is not a lesson that can be used: %1.</source>
        <translation>Ce n’est pas une leçon utilisable&#xa0;: %1.</translation>
    </message>
    <message>
        <source>It is not a plugin, or it is damaged; install it again, or move it to another folder.</source>
        <translation>Ce n’est pas un greffon, ou il est abîmé&#x202f;; réinstalle-le, ou déplace-le dans un autre dossier.</translation>
    </message>
    <message>
        <source>It is a lesson for another version of the program (%1, not %2); build it again for this one.</source>
        <translation>C’est une leçon pour une autre version du programme (%1, pas %2)&#x202f;; recompile-la pour celle-ci.</translation>
    </message>
    <message>
        <source>It is a plugin of another program (%1); move it to another folder.</source>
        <translation>C’est un greffon d’un autre programme (%1)&#x202f;; déplace-le dans un autre dossier.</translation>
    </message>
    <message>
        <source>its description has no text %1</source>
        <translation>sa description n’a pas de texte %1</translation>
    </message>
    <message>
        <source>the id %1 is not made of a to z, 0 to 9 and _</source>
        <translation>l’identifiant %1 n’est pas fait de a à z, 0 à 9 et _</translation>
    </message>
    <message>
        <source>its description lists no &quot;steps&quot;</source>
        <translation>sa description ne cite pas de &quot;steps&quot;</translation>
    </message>
    <message>
        <source>its description lists a step twice</source>
        <translation>sa description cite une étape deux fois</translation>
    </message>
    <message>
        <source>the step %1 has no scene or no view</source>
        <translation>l’étape %1 n’a pas de scène ou pas de vue</translation>
    </message>
    <message>
        <source>the step %1 needs the method %2, which does not exist</source>
        <translation>l’étape %1 exige la méthode %2, qui n’existe pas</translation>
    </message>
    <message>
        <source>the step %1 cannot start (%2)</source>
        <translation>l’étape %1 ne peut pas commencer (%2)</translation>
    </message>
    <message>
        <source>its code has no lesson</source>
        <translation>son code ne contient pas de leçon</translation>
    </message>
    <message>
        <source>its steps could not be created (%1)</source>
        <translation>ses étapes n’ont pas pu être créées (%1)</translation>
    </message>
    <message>
        <source>its description has no whole number &quot;order&quot;</source>
        <translation>sa description n’a pas de nombre entier &quot;order&quot;</translation>
    </message>
    <message>
        <source>It could not be loaded: %1. Build or install it again.</source>
        <translation>Elle n’a pas pu être chargée&#xa0;: %1. Recompile-la ou réinstalle-la.</translation>
    </message>
    <message>
        <source>its description lists the steps %1, its code has %2</source>
        <translation>sa description cite les étapes %1, son code a %2</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucune</translation>
    </message>
    <message>
        <source>its project could not be read (%1)</source>
        <translation>son projet n’a pas pu être lu (%1)</translation>
    </message>
    <message>
        <source>its questions could not be read (%1)</source>
        <translation>ses questions n’ont pas pu être lues (%1)</translation>
    </message>
</context>
<context>
    <name>LessonStepText</name>
    <message>
        <source>%1 stands for a number, and this condition does not compare one. Write a comparison with the number on its left, or a sentence without %1.</source>
        <translation>%1 représente un nombre, et cette condition n’en compare aucun. Écris une comparaison avec le nombre à gauche, ou une phrase sans %1.</translation>
    </message>
    <message>
        <source>nothing says when the thing to try “%1” is done. Write a “### Done when” with a list, as in “- pulled: released(%2)”.</source>
        <translation>rien ne dit quand l’essai «&#x202f;%1&#x202f;» est fait. Écris un «&#x202f;### Done when&#x202f;» avec une liste, comme dans «&#x202f;- pulled: released(%2)&#x202f;».</translation>
    </message>
</context>
<context>
    <name>LessonWriterText</name>
    <message>
        <source>## Try {#pull}

Pull **%1** aside, and let go of it. What does it do?

### Hint

Press **Space**. Hold the mouse button on %1, move the mouse, and let go.

### Answer

Write here what one can see then.

### Done when

- begun: held(%1) or released(%1)
- let_go: released(%1)

### Missing

- let_go: let go of it.

### Solution

- drag %1: %2, %3, 10
- frames: 30

</source>
        <translation>## Try {#pull}

Tire **%1** sur le côté, puis lâche. Que se passe-t-il&#x202f;?

### Hint

Appuie sur **Espace**. Tiens le bouton de la souris enfoncé sur %1, déplace la souris, puis lâche.

### Answer

Écris ici ce qu’on voit alors.

### Done when

- begun: held(%1) or released(%1)
- let_go: released(%1)

### Missing

- let_go: lâche-le.

### Solution

- drag %1: %2, %3, 10
- frames: 30

</translation>
    </message>
    <message>
        <source>## Predict {#where}

Nobody touches anything. Where is %1 after 60 frames? Click the place.

### Run

- frames: 60

### Ask

- place: %1

### Answer

Write here why it is there.

</source>
        <translation>## Predict {#where}

Personne ne touche à rien. Où est %1 après 60 images&#x202f;? Clique sur l’endroit.

### Run

- frames: 60

### Ask

- place: %1

### Answer

Écris ici pourquoi il est là.

</translation>
    </message>
    <message>
        <source># The title of the step

Write here what a learner should look at, why it is so, and the rule to keep. Save this file, and the window shows what you wrote.

Below are parts that a step can have. Change them, copy them, or remove them.

</source>
        <translation># Le titre de l’étape

Écris ici ce que l’élève doit regarder, pourquoi il en est ainsi, et la règle à retenir. Enregistre ce fichier, et la fenêtre montre ce que tu as écrit.

Voici ensuite des parties qu’une étape peut avoir. Change-les, copie-les ou retire-les.

</translation>
    </message>
    <message>
        <source>## Word: Step

Forms: none

A word that the text uses, in one sentence.

## Why: Why is it so?

Write here a question that learners ask, and the answer.

## Learnt

Write here in one sentence what a learner knows now.
</source>
        <translation>## Word: Étape

Forms: none

Un mot que le texte utilise, en une phrase.

## Why: Pourquoi en est-il ainsi&#x202f;?

Écris ici une question que se posent les élèves, et la réponse.

## Learnt

Écris ici en une phrase ce que l’élève sait maintenant.
</translation>
    </message>
    <message>
        <source>My lesson</source>
        <translation>Ma leçon</translation>
    </message>
    <message>
        <source>What it is about, in one sentence.</source>
        <translation>De quoi elle parle, en une phrase.</translation>
    </message>
    <message>
        <source>%1 is not empty. Choose a new folder for the lesson.</source>
        <translation>%1 n’est pas vide. Choisis un nouveau dossier pour la leçon.</translation>
    </message>
    <message>
        <source>%1: the folder could not be made. Choose another place.</source>
        <translation>%1&#xa0;: le dossier n’a pas pu être créé. Choisis un autre endroit.</translation>
    </message>
    <message>
        <source>There is no step %1 any more. Open another one, and begin the lesson with its scene.</source>
        <translation>L’étape %1 n’existe plus. Ouvres-en une autre, et commence la leçon avec sa scène.</translation>
    </message>
</context>
<context>
    <name>LessonsText</name>
    <message>
        <source>%1; one of %2</source>
        <translation>%1&#x202f;; l’un de %2</translation>
    </message>
    <message>
        <source>%1; %2 to %3</source>
        <translation>%1&#x202f;; de %2 à %3</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>Méthodes</translation>
    </message>
    <message>
        <source>order %1</source>
        <translation>ordre %1</translation>
    </message>
    <message>
        <source>; needs %1</source>
        <translation>&#x202f;; exige %1</translation>
    </message>
    <message>
        <source>No lesson was found in %1; SPRINGSTEP_LESSONS can name a folder that has them.</source>
        <translation>Aucune leçon trouvée dans %1&#x202f;; SPRINGSTEP_LESSONS peut nommer un dossier qui en contient.</translation>
    </message>
</context>
<context>
    <name>LinePositionText</name>
    <message>
        <source>before line %1, %2 of %3 lines run</source>
        <translation>avant la ligne %1, %2 lignes exécutées sur %3</translation>
    </message>
    <message>
        <source>before line %1, %2 lines run</source>
        <translation>avant la ligne %1, %2 lignes exécutées</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Image %1</translation>
    </message>
</context>
<context>
    <name>LineValuesText</name>
    <message>
        <source>%1: from %2 to %3</source>
        <translation>%1&#xa0;: de %2 à %3</translation>
    </message>
    <message>
        <source>%1 = %2 of %3</source>
        <translation>%1 = %2 sur %3</translation>
    </message>
    <message>
        <source>no body</source>
        <translation>aucun corps</translation>
    </message>
    <message>
        <source>This frame runs more than %1 lines. The others are not shown.</source>
        <translation>Cette image exécute plus de %1 lignes. Les autres ne sont pas montrées.</translation>
    </message>
</context>
<context>
    <name>ListingText</name>
    <message>
        <source>Did you mean %1?</source>
        <translation>Voulais-tu dire %1&#x202f;?</translation>
    </message>
    <message>
        <source>%1 is not a member of an array of bodies.</source>
        <translation>%1 n’est pas un membre d’une liste de corps.</translation>
    </message>
    <message>
        <source>%1 is not a member of the array of creatures.</source>
        <translation>%1 n’est pas un membre de la liste des créatures.</translation>
    </message>
    <message>
        <source>%1 is not a member of the array of sticks.</source>
        <translation>%1 n’est pas un membre de la liste des tiges.</translation>
    </message>
    <message>
        <source>%1 is not a member of the new targets.</source>
        <translation>%1 n’est pas un membre des nouvelles cibles.</translation>
    </message>
    <message>
        <source>%1 is not a member of the keys.</source>
        <translation>%1 n’est pas une des touches.</translation>
    </message>
    <message>
        <source>%1 is not a member of %2.</source>
        <translation>%1 n’est pas un membre de %2.</translation>
    </message>
    <message>
        <source>It has %1.</source>
        <translation>Il y a %1.</translation>
    </message>
    <message>
        <source>Choose one of them first, for example with [0].</source>
        <translation>Choisis-en d’abord un, par exemple avec [0].</translation>
    </message>
    <message>
        <source>There is no function %1.</source>
        <translation>Il n’y a pas de fonction %1.</translation>
    </message>
    <message>
        <source>There is no type %1.</source>
        <translation>Il n’y a pas de type %1.</translation>
    </message>
    <message>
        <source>The types are %1.</source>
        <translation>Les types sont %1.</translation>
    </message>
    <message>
        <source>The functions are %1.</source>
        <translation>Les fonctions sont %1.</translation>
    </message>
    <message>
        <source>There is no %1: %2 is empty.</source>
        <translation>Il n’y a pas de %1&#xa0;: %2 est vide.</translation>
    </message>
    <message>
        <source>There is no %1: the only one is %2.</source>
        <translation>Il n’y a pas de %1&#xa0;: le seul est %2.</translation>
    </message>
    <message>
        <source>There is no %1: %2 goes from %3 to %4.</source>
        <translation>Il n’y a pas de %1&#xa0;: %2 va de %3 à %4.</translation>
    </message>
    <message>
        <source>There is no %1.</source>
        <translation>Il n’y a pas de %1.</translation>
    </message>
    <message>
        <source>This scene has %1, and the numbers %2.</source>
        <translation>Cette scène a %1, et les nombres %2.</translation>
    </message>
    <message>
        <source>This scene has %1, and the number %2.</source>
        <translation>Cette scène a %1, et le nombre %2.</translation>
    </message>
    <message>
        <source>This scene has the numbers %1.</source>
        <translation>Cette scène a les nombres %1.</translation>
    </message>
    <message>
        <source>This scene has the number %1.</source>
        <translation>Cette scène a le nombre %1.</translation>
    </message>
    <message>
        <source>This scene has %1.</source>
        <translation>Cette scène a %1.</translation>
    </message>
    <message>
        <source>There already is %1 here.</source>
        <translation>Il y a déjà %1 ici.</translation>
    </message>
    <message>
        <source>There already is %1 in this scene.</source>
        <translation>Il y a déjà %1 dans cette scène.</translation>
    </message>
    <message>
        <source>Use another name.</source>
        <translation>Utilise un autre nom.</translation>
    </message>
    <message>
        <source>A new variable needs a type: %1, %2 or %3.</source>
        <translation>Une nouvelle variable a besoin d’un type&#xa0;: %1, %2 ou %3.</translation>
    </message>
    <message>
        <source>This is an array of bodies.</source>
        <translation>C’est une liste de corps.</translation>
    </message>
    <message>
        <source>%1 does not take these values: %2.</source>
        <translation>%1 n’accepte pas ces valeurs&#xa0;: %2.</translation>
    </message>
    <message>
        <source>A %1 cannot be used as a %2.</source>
        <translation>Un %1 ne peut pas servir de %2.</translation>
    </message>
    <message>
        <source>This sign does not work between a %1 and the other value.</source>
        <translation>Ce signe ne marche pas entre un %1 et l’autre valeur.</translation>
    </message>
    <message>
        <source>This sign does not work between a %1 and a %2.</source>
        <translation>Ce signe ne marche pas entre un %1 et un %2.</translation>
    </message>
    <message>
        <source>A Vec2 can be added to a Vec2, and multiplied or divided by a number.</source>
        <translation>Un Vec2 peut être ajouté à un Vec2, et multiplié ou divisé par un nombre.</translation>
    </message>
    <message>
        <source>Use the position or the velocity of the body.</source>
        <translation>Utilise la position ou la vitesse du corps.</translation>
    </message>
    <message>
        <source>%1 is a %2 here, not a function.</source>
        <translation>%1 est ici un %2, pas une fonction.</translation>
    </message>
    <message>
        <source>This is not a function.</source>
        <translation>Ce n’est pas une fonction.</translation>
    </message>
    <message>
        <source>%1 is not a function.</source>
        <translation>%1 n’est pas une fonction.</translation>
    </message>
    <message>
        <source>Write it without &apos;()&apos;.</source>
        <translation>Écris-le sans &apos;()&apos;.</translation>
    </message>
    <message>
        <source>To multiply, write &apos;*&apos;.</source>
        <translation>Pour multiplier, écris &apos;*&apos;.</translation>
    </message>
    <message>
        <source>Both values of a choice with ? need the same type.</source>
        <translation>Les deux valeurs d’un choix avec&#x202f;? doivent être du même type.</translation>
    </message>
    <message>
        <source>Write %1 for %2 beside a double.</source>
        <translation>Écris %1 au lieu de %2 à côté d’un double.</translation>
    </message>
    <message>
        <source>Between whole numbers, &apos;/&apos; drops the fraction: this is %1.</source>
        <translation>Entre nombres entiers, &apos;/&apos; supprime les décimales&#xa0;: cela fait %1.</translation>
    </message>
    <message>
        <source>Between whole numbers, &apos;/&apos; drops the fraction.</source>
        <translation>Entre nombres entiers, &apos;/&apos; supprime les décimales.</translation>
    </message>
    <message>
        <source>An &apos;int&apos; keeps no fraction, and this value may have one.</source>
        <translation>Un &apos;int&apos; n’a pas de décimales, et cette valeur peut en avoir.</translation>
    </message>
    <message>
        <source>Write %1, or round down with %2.</source>
        <translation>Écris %1, ou arrondis vers le bas avec %2.</translation>
    </message>
    <message>
        <source>A value is missing at the end of this line.</source>
        <translation>Il manque une valeur à la fin de cette ligne.</translation>
    </message>
    <message>
        <source>A name is missing at the end of this line.</source>
        <translation>Il manque un nom à la fin de cette ligne.</translation>
    </message>
    <message>
        <source>%1 is missing at the end of this line.</source>
        <translation>Il manque %1 à la fin de cette ligne.</translation>
    </message>
    <message>
        <source>%1 is missing before %2.</source>
        <translation>Il manque %1 avant %2.</translation>
    </message>
    <message>
        <source>This %1 has no %2.</source>
        <translation>À ce %1, il manque le %2.</translation>
    </message>
    <message>
        <source>A value is missing here.</source>
        <translation>Il manque une valeur ici.</translation>
    </message>
    <message>
        <source>The name of a type is missing here: %1.</source>
        <translation>Il manque ici le nom d’un type&#xa0;: %1.</translation>
    </message>
    <message>
        <source>A name is missing here.</source>
        <translation>Il manque un nom ici.</translation>
    </message>
    <message>
        <source>The name of a member is missing behind the dot.</source>
        <translation>Il manque le nom d’un membre après le point.</translation>
    </message>
    <message>
        <source>%1 is missing here.</source>
        <translation>Il manque %1 ici.</translation>
    </message>
    <message>
        <source>A Body cannot be replaced by another one.</source>
        <translation>Un Body ne peut pas être remplacé par un autre.</translation>
    </message>
    <message>
        <source>Set its position or its velocity.</source>
        <translation>Change sa position ou sa vitesse.</translation>
    </message>
    <message>
        <source>This cannot be changed.</source>
        <translation>Cela ne peut pas être changé.</translation>
    </message>
    <message>
        <source>This is a parameter.</source>
        <translation>C’est un paramètre.</translation>
    </message>
    <message>
        <source>Set it with its slider.</source>
        <translation>Règle-le avec son curseur.</translation>
    </message>
    <message>
        <source>A listing changes positions, velocities and its own variables.</source>
        <translation>Un listing change des positions, des vitesses et ses propres variables.</translation>
    </message>
    <message>
        <source>A %1 cannot be set as a whole.</source>
        <translation>Un %1 ne peut pas être changé d’un bloc.</translation>
    </message>
    <message>
        <source>%1 has no value yet.</source>
        <translation>%1 n’a pas encore de valeur.</translation>
    </message>
    <message>
        <source>Give it one: %1.</source>
        <translation>Donne-lui-en une&#xa0;: %1.</translation>
    </message>
    <message>
        <source>A condition is true or false.</source>
        <translation>Une condition est vraie ou fausse.</translation>
    </message>
    <message>
        <source>%1 is a type and has no value.</source>
        <translation>%1 est un type et n’a pas de valeur.</translation>
    </message>
    <message>
        <source>Use its x, its y or its length.</source>
        <translation>Utilise son x, son y ou sa longueur.</translation>
    </message>
    <message>
        <source>This sign does not work with this value.</source>
        <translation>Ce signe ne marche pas avec cette valeur.</translation>
    </message>
    <message>
        <source>Only an array has an index in &apos;[...]&apos;.</source>
        <translation>Seule une liste a un indice entre &apos;[...]&apos;.</translation>
    </message>
    <message>
        <source>This computes a value, and nothing keeps it.</source>
        <translation>Ceci calcule une valeur que rien ne garde.</translation>
    </message>
    <message>
        <source>Compare this with something, for example with == or &gt;.</source>
        <translation>Compare ceci à quelque chose, par exemple avec == ou &gt;.</translation>
    </message>
    <message>
        <source>This function can end without &apos;return&apos;.</source>
        <translation>Cette fonction peut finir sans &apos;return&apos;.</translation>
    </message>
    <message>
        <source>It has to return a value in every case.</source>
        <translation>Elle doit renvoyer une valeur dans tous les cas.</translation>
    </message>
    <message>
        <source>This function has to return a value.</source>
        <translation>Cette fonction doit renvoyer une valeur.</translation>
    </message>
    <message>
        <source>A &apos;void&apos; function returns no value.</source>
        <translation>Une fonction &apos;void&apos; ne renvoie aucune valeur.</translation>
    </message>
    <message>
        <source>The text ends too early: a &apos;}&apos; or a &apos;)&apos; is missing.</source>
        <translation>Le texte finit trop tôt&#xa0;: il manque une &apos;}&apos; ou une &apos;)&apos;.</translation>
    </message>
    <message>
        <source>A Body variable needs a body, for example %1.</source>
        <translation>Une variable Body a besoin d’un corps, par exemple %1.</translation>
    </message>
    <message>
        <source>%1 cannot be remembered from frame to frame.</source>
        <translation>%1 ne peut pas être mémorisé d’image en image.</translation>
    </message>
    <message>
        <source>Only numbers, bool and Vec2 can.</source>
        <translation>C’est possible seulement avec les nombres, bool et Vec2.</translation>
    </message>
    <message>
        <source>The first value of %1 cannot be computed.</source>
        <translation>La première valeur de %1 ne peut pas être calculée.</translation>
    </message>
    <message>
        <source>Write the number itself, without %1.</source>
        <translation>Écris le nombre lui-même, sans %1.</translation>
    </message>
    <message>
        <source>The function &apos;void frame()&apos; is missing.</source>
        <translation>Il manque la fonction &apos;void frame()&apos;.</translation>
    </message>
    <message>
        <source>It runs once in every frame.</source>
        <translation>Elle s’exécute une fois à chaque image.</translation>
    </message>
    <message>
        <source>A listing cannot make arrays.</source>
        <translation>Un listing ne peut pas créer ses propres listes.</translation>
    </message>
    <message>
        <source>Write a variable for each value.</source>
        <translation>Écris une variable pour chaque valeur.</translation>
    </message>
    <message>
        <source>This is outside of any function.</source>
        <translation>Ceci est hors d’une fonction.</translation>
    </message>
    <message>
        <source>A function cannot be inside another function.</source>
        <translation>Une fonction ne peut pas être dans une autre.</translation>
    </message>
    <message>
        <source>Move it out.</source>
        <translation>Place-la à l’extérieur.</translation>
    </message>
    <message>
        <source>%1 works only in a loop.</source>
        <translation>%1 ne se trouve que dans une boucle.</translation>
    </message>
    <message>
        <source>%1 does not belong here.</source>
        <translation>%1 n’a pas sa place ici.</translation>
    </message>
    <message>
        <source>Put it between the braces of a function.</source>
        <translation>Mets-le entre les accolades d’une fonction.</translation>
    </message>
    <message>
        <source>Look for a &apos;}&apos; too many above.</source>
        <translation>Cherche une &apos;}&apos; de trop plus haut.</translation>
    </message>
    <message>
        <source>A function begins with the type of its result, for example %1 or %2.</source>
        <translation>Une fonction commence par le type de son résultat, par exemple %1 ou %2.</translation>
    </message>
    <message>
        <source>A function is called without an object here: %1.</source>
        <translation>Ici, une fonction s’appelle sans objet&#xa0;: %1.</translation>
    </message>
    <message>
        <source>This text cannot be compiled.</source>
        <translation>Ce texte ne peut pas être compilé.</translation>
    </message>
    <message>
        <source>Texts in quotes are not part of this language.</source>
        <translation>Les textes entre guillemets ne font pas partie de ce langage.</translation>
    </message>
    <message>
        <source>It has numbers, bool and Vec2.</source>
        <translation>Il a des nombres, bool et Vec2.</translation>
    </message>
    <message>
        <source>This character is not part of this language.</source>
        <translation>Ce caractère ne fait pas partie de ce langage.</translation>
    </message>
    <message>
        <source>%1 is reserved and not part of this language.</source>
        <translation>%1 est réservé et ne fait pas partie de ce langage.</translation>
    </message>
    <message>
        <source>%1 is not part of this language.</source>
        <translation>%1 ne fait pas partie de ce langage.</translation>
    </message>
    <message>
        <source>A Body variable already stands for the body itself.</source>
        <translation>Une variable Body représente déjà le corps lui-même.</translation>
    </message>
    <message>
        <source>A loop is written %1.</source>
        <translation>Une boucle s’écrit %1.</translation>
    </message>
    <message>
        <source>A comment begins with %1.</source>
        <translation>Un commentaire commence par %1.</translation>
    </message>
    <message>
        <source>A name begins with a letter.</source>
        <translation>Un nom commence par une lettre.</translation>
    </message>
    <message>
        <source>A name has only the letters a to z, digits and &apos;_&apos;.</source>
        <translation>Un nom n’a que les lettres de a à z, des chiffres et &apos;_&apos;.</translation>
    </message>
    <message>
        <source>A listing cannot print: its values are shown beside its lines.</source>
        <translation>Un listing n’affiche rien&#xa0;: ses valeurs sont à côté de ses lignes.</translation>
    </message>
    <message>
        <source>A power is %1.</source>
        <translation>Une puissance est %1.</translation>
    </message>
    <message>
        <source>Write a position or a velocity as %1.</source>
        <translation>Une position ou une vitesse s’écrit %1.</translation>
    </message>
    <message>
        <source>A condition needs brackets: %1.</source>
        <translation>Une condition est entre parenthèses&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Leave out the &apos;:&apos;.</source>
        <translation>Enlève le &apos;:&apos;.</translation>
    </message>
    <message>
        <source>The lines that belong to a condition go between &apos;{&apos; and &apos;}&apos;.</source>
        <translation>Les lignes qui dépendent d’une condition sont entre &apos;{&apos; et &apos;}&apos;.</translation>
    </message>
    <message>
        <source>This &apos;;&apos; ends %1, so that nothing belongs to it.</source>
        <translation>Ce &apos;;&apos; termine %1, donc rien n’en dépend.</translation>
    </message>
    <message>
        <source>Delete the &apos;;&apos;.</source>
        <translation>Supprime le &apos;;&apos;.</translation>
    </message>
    <message>
        <source>Leave it out.</source>
        <translation>Enlève-le.</translation>
    </message>
    <message>
        <source>Use %1.</source>
        <translation>Utilise %1.</translation>
    </message>
    <message>
        <source>A number ends without &apos;f&apos; here.</source>
        <translation>Ici, un nombre finit sans &apos;f&apos;.</translation>
    </message>
    <message>
        <source>A number has a point, not a comma: %1.</source>
        <translation>Un nombre a un point, pas une virgule&#xa0;: %1.</translation>
    </message>
    <message>
        <source>&apos;void&apos; is only for functions, for example %1.</source>
        <translation>&apos;void&apos; ne va que devant une fonction, par exemple %1.</translation>
    </message>
    <message>
        <source>%1 returns no value, so call it on its own: %2.</source>
        <translation>%1 ne renvoie pas de valeur, donc appelle-le à part&#xa0;: %2.</translation>
    </message>
    <message>
        <source>&apos;=&apos; sets a value, and can be used once in a statement.</source>
        <translation>&apos;=&apos; donne une valeur, et n’apparaît qu’une fois dans une instruction.</translation>
    </message>
    <message>
        <source>To compare, write &apos;==&apos;.</source>
        <translation>Pour comparer, écris &apos;==&apos;.</translation>
    </message>
    <message>
        <source>&apos;==&apos; compares and changes nothing.</source>
        <translation>&apos;==&apos; compare et ne change rien.</translation>
    </message>
    <message>
        <source>To set a value, write &apos;=&apos;.</source>
        <translation>Pour donner une valeur, écris &apos;=&apos;.</translation>
    </message>
    <message>
        <source>Only a variable can be set: a name, with members or an index behind it.</source>
        <translation>On ne peut donner une valeur qu’à une variable&#xa0;: un nom, suivi de membres ou d’un indice.</translation>
    </message>
    <message>
        <source>Compare two values at a time, for example %1.</source>
        <translation>Compare deux valeurs à la fois, par exemple %1.</translation>
    </message>
    <message>
        <source>Write &apos;*&apos; between a number and a name: %1.</source>
        <translation>Écris &apos;*&apos; entre un nombre et un nom&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Write &apos;+=&apos; to add to a value.</source>
        <translation>Écris &apos;+=&apos; pour ajouter à une valeur.</translation>
    </message>
    <message>
        <source>Write &apos;-=&apos; to subtract from a value.</source>
        <translation>Écris &apos;-=&apos; pour soustraire d’une valeur.</translation>
    </message>
    <message>
        <source>Write &apos;.&apos; between a body and its member, for example %1.</source>
        <translation>Écris &apos;.&apos; entre un corps et son membre, par exemple %1.</translation>
    </message>
    <message>
        <source>Write %1 to compare.</source>
        <translation>Écris %1 pour comparer.</translation>
    </message>
    <message>
        <source>Write %1 without a space in between.</source>
        <translation>Écris %1 sans espace au milieu.</translation>
    </message>
    <message>
        <source>Write %1 with small letters.</source>
        <translation>Écris %1 en minuscules.</translation>
    </message>
    <message>
        <source>Write it as %1.</source>
        <translation>Écris-le ainsi&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Write %1.</source>
        <translation>Écris %1.</translation>
    </message>
    <message>
        <source>There are more than %1 &apos;else&apos; in this listing.</source>
        <translation>Il y a plus de %1 &apos;else&apos; dans ce listing.</translation>
    </message>
    <message>
        <source>There are more than %1 brackets inside one another.</source>
        <translation>Il y a plus de %1 parenthèses les unes dans les autres.</translation>
    </message>
    <message>
        <source>This statement is too long.</source>
        <translation>Cette instruction est trop longue.</translation>
    </message>
    <message>
        <source>Split it in two.</source>
        <translation>Coupe-la en deux.</translation>
    </message>
    <message>
        <source>The variables outside of functions take %1 bytes.</source>
        <translation>Les variables hors des fonctions prennent %1 octets.</translation>
    </message>
    <message>
        <source>This listing has %1 bytes.</source>
        <translation>Ce listing compte %1 octets.</translation>
    </message>
    <message>
        <source>The most is %1.</source>
        <translation>Le maximum est %1.</translation>
    </message>
    <message>
        <source>This variable stands for no body.</source>
        <translation>Cette variable ne représente aucun corps.</translation>
    </message>
    <message>
        <source>This divides by 0.</source>
        <translation>Ceci divise par 0.</translation>
    </message>
    <message>
        <source>The result is too large for a number.</source>
        <translation>Le résultat est trop grand pour un nombre.</translation>
    </message>
    <message>
        <source>This loop still runs after %1 lines.</source>
        <translation>Cette boucle tourne encore après %1 lignes.</translation>
    </message>
    <message>
        <source>It ends only when its condition becomes false.</source>
        <translation>Elle ne s’arrête que lorsque sa condition devient fausse.</translation>
    </message>
    <message>
        <source>This still runs after %1 lines.</source>
        <translation>Ceci tourne encore après %1 lignes.</translation>
    </message>
    <message>
        <source>A function calls itself too often.</source>
        <translation>Une fonction s’appelle elle-même trop souvent.</translation>
    </message>
    <message>
        <source>Functions call functions %1 times inside one another.</source>
        <translation>Des fonctions appellent des fonctions %1 fois les unes dans les autres.</translation>
    </message>
    <message>
        <source>Functions call functions too many times inside one another.</source>
        <translation>Des fonctions appellent des fonctions trop de fois les unes dans les autres.</translation>
    </message>
    <message>
        <source>A function that calls itself needs a case in which it does not.</source>
        <translation>Une fonction qui s’appelle elle-même a besoin d’un cas où elle ne le fait pas.</translation>
    </message>
    <message>
        <source>The position of %1 is not a finite number.</source>
        <translation>La position de «&#x202f;%1&#x202f;» n’est pas un nombre fini.</translation>
    </message>
    <message>
        <source>The velocity of %1 is not a finite number.</source>
        <translation>La vitesse de «&#x202f;%1&#x202f;» n’est pas un nombre fini.</translation>
    </message>
    <message>
        <source>The angle or the spin of %1 is not a finite number.</source>
        <translation>L’angle ou la vitesse angulaire de «&#x202f;%1&#x202f;» n’est pas un nombre fini.</translation>
    </message>
    <message>
        <source>Look for the root of a negative number, or for a number that grows in each frame.</source>
        <translation>Cherche la racine d’un nombre négatif ou un nombre qui grandit à chaque image.</translation>
    </message>
    <message>
        <source>The gait of %1 is not a finite number.</source>
        <translation>L’allure de %1 n’est pas un nombre fini.</translation>
    </message>
    <message>
        <source>%1 is not a finite number.</source>
        <translation>%1 n’est pas un nombre fini.</translation>
    </message>
    <message>
        <source>The interpreter stopped.</source>
        <translation>L’interpréteur s’est arrêté.</translation>
    </message>
    <message>
        <source> and </source>
        <comment>in a list</comment>
        <translation> et </translation>
    </message>
    <message>
        <source> or </source>
        <comment>in a list</comment>
        <translation> ou </translation>
    </message>
    <message>
        <source>A rule needs the function %1 or %2.</source>
        <translation>Une règle a besoin de la fonction %1 ou %2.</translation>
    </message>
    <message>
        <source>The function %1 of a rule has the form %2.</source>
        <translation>La fonction %1 d’une règle a la forme %2.</translation>
    </message>
    <message>
        <source>A rule remembers nothing, so %1 cannot be outside of a function.</source>
        <translation>Une règle ne mémorise rien, donc %1 ne peut pas être hors d’une fonction.</translation>
    </message>
    <message>
        <source>Move it into one.</source>
        <translation>Mets-le dans une fonction.</translation>
    </message>
    <message>
        <source>The force is not a finite number.</source>
        <translation>La force n’est pas un nombre fini.</translation>
    </message>
</context>
<context>
    <name>MapTableText</name>
    <message>
        <source>step [frames]</source>
        <translation>pas de temps [images]</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>au repos</translation>
    </message>
    <message>
        <source>still moving</source>
        <translation>bouge encore</translation>
    </message>
    <message>
        <source>grows</source>
        <translation>grandit</translation>
    </message>
    <message>
        <source>cannot be computed</source>
        <translation>pas calculable</translation>
    </message>
    <message>
        <source>growth [a frame]</source>
        <translation>croissance [par image]</translation>
    </message>
    <message>
        <source>time to rest [frames]</source>
        <translation>temps de stabilisation [images]</translation>
    </message>
    <message>
        <source>outcome</source>
        <translation>résultat</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation>E&amp;xporter</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;Run</source>
        <translation>&amp;Simulation</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Vue</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Aide</translation>
    </message>
</context>
<context>
    <name>NotebookCheckText</name>
    <message>
        <source>Its run takes more than %1 s to replay.</source>
        <translation>Il faut plus de %1 s pour rejouer sa simulation.</translation>
    </message>
    <message>
        <source>It was ticked by a version that kept no runs.</source>
        <translation>Il a été coché par une version qui ne gardait pas les simulations.</translation>
    </message>
    <message>
        <source>Its run is of another step.</source>
        <translation>Sa simulation est d’une autre étape.</translation>
    </message>
    <message>
        <source>At frame %1 its run does not do it.</source>
        <translation>À l’image %1, sa simulation ne le fait pas.</translation>
    </message>
    <message>
        <source>Still to do: %1</source>
        <translation>Encore à faire&#xa0;: %1</translation>
    </message>
    <message>
        <source>Its answer cannot be read.</source>
        <translation>Sa réponse est illisible.</translation>
    </message>
    <message>
        <source>The notebook counts “%1” as %2, but the run gives “%3”.</source>
        <translation>Le cahier compte «&#x202f;%1&#x202f;» comme %2, mais la simulation donne «&#x202f;%3&#x202f;».</translation>
    </message>
    <message>
        <source>right</source>
        <translation>juste</translation>
    </message>
    <message>
        <source>not right</source>
        <translation>pas juste</translation>
    </message>
    <message>
        <source>The notebook says that the run gives “%1”, but it gives “%2”.</source>
        <translation>D’après le cahier, la simulation donne «&#x202f;%1&#x202f;», mais elle donne «&#x202f;%2&#x202f;».</translation>
    </message>
    <message>
        <source>“%1” was said; it is “%2”.</source>
        <translation>La réponse était «&#x202f;%1&#x202f;»&#x202f;; c’est «&#x202f;%2&#x202f;».</translation>
    </message>
    <message>
        <source>The notebook counts “%1” as %2, but the answer of the lesson is “%3”.</source>
        <translation>Le cahier compte «&#x202f;%1&#x202f;» comme %2, mais la réponse de la leçon est «&#x202f;%3&#x202f;».</translation>
    </message>
</context>
<context>
    <name>NotebookFileText</name>
    <message>
        <source>the file</source>
        <translation>le fichier</translation>
    </message>
    <message>
        <source>this is not a notebook: its &quot;format&quot; is %1, and this program reads %2.</source>
        <translation>ce n’est pas un cahier&#xa0;: son &quot;format&quot; vaut %1, et ce programme lit %2.</translation>
    </message>
    <message>
        <source>the seal of the file</source>
        <translation>le sceau du fichier</translation>
    </message>
    <message>
        <source>&quot;name&quot; has %1 letters; it can have up to %2.</source>
        <translation>&quot;name&quot; a %1 lettres&#x202f;; possible&#xa0;: jusqu’à %2.</translation>
    </message>
    <message>
        <source>a list of what was done</source>
        <translation>une liste de ce qui a été fait</translation>
    </message>
    <message>
        <source>&quot;entries&quot; has %1 entries; it can have up to %2.</source>
        <translation>&quot;entries&quot; a %1 entrées&#x202f;; possible&#xa0;: jusqu’à %2.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a time; write it as 2026-01-31T12:00:00Z.</source>
        <translation>&quot;%1&quot; n’est pas une heure&#x202f;; écris-la comme 2026-01-31T12:00:00Z.</translation>
    </message>
    <message>
        <source>an entry</source>
        <translation>une entrée</translation>
    </message>
    <message>
        <source>the id of what was done</source>
        <translation>l’identifiant de ce qui a été fait</translation>
    </message>
    <message>
        <source>the id of a step</source>
        <translation>l’identifiant d’une étape</translation>
    </message>
    <message>
        <source>the answer</source>
        <translation>la réponse</translation>
    </message>
    <message>
        <source>what the run showed</source>
        <translation>ce que la simulation a montré</translation>
    </message>
    <message>
        <source>&quot;kind&quot; is %1; it can be %2.</source>
        <translation>&quot;kind&quot; vaut %1&#x202f;; possible&#xa0;: %2.</translation>
    </message>
    <message>
        <source>the runs are larger than %1 MiB together, the maximum for a notebook.</source>
        <translation>les simulations dépassent ensemble %1 Mio, le maximum pour un cahier.</translation>
    </message>
    <message>
        <source>the run of %1 is damaged, or larger than %2 MiB; ask for the notebook again.</source>
        <translation>la simulation de %1 est abîmée, ou dépasse %2 Mio&#x202f;; redemande le cahier.</translation>
    </message>
    <message>
        <source>there is no %1 called %2 in %3; the notebook may be from another version of the lesson.</source>
        <translation>il n’y a pas de %1 appelé %2 dans %3&#x202f;; le cahier vient peut-être d’une autre version de la leçon.</translation>
    </message>
    <message>
        <source>%1 is there twice; ask for the notebook again.</source>
        <translation>%1 y est deux fois&#x202f;; redemande le cahier.</translation>
    </message>
    <message>
        <source>%1: this is not a notebook; a notebook is text in UTF-8.</source>
        <translation>%1&#xa0;: ce n’est pas un cahier&#x202f;; un cahier est du texte en UTF-8.</translation>
    </message>
    <message>
        <source>The notebook would be too large. Choose fewer lessons, or leave out the gallery.</source>
        <translation>Le cahier serait trop grand. Choisis moins de leçons, ou laisse de côté la galerie.</translation>
    </message>
    <message>
        <source>If it is a lesson without C++, name its folder or its zip beside the notebook.</source>
        <translation>Si c’est une leçon sans C++, nomme son dossier ou son zip à côté du cahier.</translation>
    </message>
</context>
<context>
    <name>NotebookPageText</name>
    <message>
        <source>Notebook</source>
        <translation>Cahier</translation>
    </message>
    <message>
        <source>Notebook of %1</source>
        <translation>Cahier de %1</translation>
    </message>
    <message>
        <source>Springstep, %1</source>
        <translation>Springstep, %1</translation>
    </message>
    <message>
        <source>Nothing is done yet.</source>
        <translation>Rien n’est encore fait.</translation>
    </message>
    <message>
        <source>Project: %1</source>
        <translation>Projet&#xa0;: %1</translation>
    </message>
    <message>
        <source>Built and kept</source>
        <translation>Construit et gardé</translation>
    </message>
    <message>
        <source>The scene at that moment</source>
        <translation>La scène à ce moment</translation>
    </message>
</context>
<context>
    <name>NotebookReportText</name>
    <message>
        <source>%1 of %2 are shown by their runs.</source>
        <translation>%1 sur %2 sont démontrés par leurs simulations.</translation>
    </message>
    <message>
        <source>The file was changed after it was written.</source>
        <translation>Le fichier a été modifié après avoir été écrit.</translation>
    </message>
    <message>
        <source>Nothing is in it.</source>
        <translation>Il ne contient rien.</translation>
    </message>
</context>
<context>
    <name>NotebookText</name>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1&#xa0;: %2 sur %3</translation>
    </message>
    <message>
        <source>%1 of %2 notebooks could not be read.</source>
        <translation>%1 cahiers sur %2 n’ont pas pu être lus.</translation>
    </message>
    <message>
        <source>notebook page takes FILE OUT; see springstep notebook --help.</source>
        <translation>notebook page attend FILE OUT&#x202f;; voir springstep notebook --help.</translation>
    </message>
    <message>
        <source>%1 is not the name of a page; it can end in .html or .pdf.</source>
        <translation>%1 n’est pas un nom de page&#x202f;; il peut finir par .html ou .pdf.</translation>
    </message>
    <message>
        <source>--lessons: %1</source>
        <translation>--lessons&#xa0;: %1</translation>
    </message>
    <message>
        <source>notebook write takes OUT; see springstep notebook --help.</source>
        <translation>notebook write attend OUT&#x202f;; voir springstep notebook --help.</translation>
    </message>
    <message>
        <source>%1 is not the name of a notebook; it ends in %2.</source>
        <translation>%1 n’est pas un nom de cahier&#x202f;; il finit par %2.</translation>
    </message>
    <message>
        <source>notebook cannot %1; it can &quot;check&quot;, &quot;page&quot; or &quot;write&quot;.</source>
        <translation>notebook ne connaît pas %1&#x202f;; il connaît &quot;check&quot;, &quot;page&quot; ou &quot;write&quot;.</translation>
    </message>
    <message>
        <source>notebook check takes FILE...; see springstep notebook --help.</source>
        <translation>notebook check attend FILE...&#x202f;; voir springstep notebook --help.</translation>
    </message>
    <message>
        <source>--%1 is for notebook check. Leave it out.</source>
        <translation>--%1 est pour notebook check. Enlève cette option.</translation>
    </message>
    <message>
        <source>--%1 is for notebook write. Leave it out.</source>
        <translation>--%1 est pour notebook write. Enlève cette option.</translation>
    </message>
    <message>
        <source>--json and --csv are two forms of the result. Leave one out.</source>
        <translation>--json et --csv sont deux formes du résultat. Enlève l’une des deux.</translation>
    </message>
</context>
<context>
    <name>OptionValuesText</name>
    <message>
        <source>--%1 is %2; it can be %3 to %4.</source>
        <translation>--%1 vaut %2&#x202f;; possible&#xa0;: de %3 à %4.</translation>
    </message>
    <message>
        <source>--%1 is %2; it can be a whole number from 0 to %3.</source>
        <translation>--%1 vaut %2&#x202f;; possible&#xa0;: un nombre entier de 0 à %3.</translation>
    </message>
    <message>
        <source>--size is %1; it can be WIDTHxHEIGHT in pixels, each from 100 to 9999, such as 1280x800.</source>
        <translation>--size vaut %1&#x202f;; possible&#xa0;: LARGEURxHAUTEUR en pixels, chacune de 100 à 9999, comme 1280x800.</translation>
    </message>
    <message>
        <source>--theme is %1; it can be &quot;light&quot;, &quot;dark&quot; or &quot;contrast&quot;.</source>
        <translation>--theme vaut %1&#x202f;; possible&#xa0;: &quot;light&quot;, &quot;dark&quot; ou &quot;contrast&quot;.</translation>
    </message>
    <message>
        <source>--language is %1; it can be %2.</source>
        <translation>--language est %1&#x202f;; valeurs possibles&#xa0;: %2.</translation>
    </message>
</context>
<context>
    <name>ParameterValueText</name>
    <message>
        <source>%1 is %2; it can be one of %3.</source>
        <translation>%1 vaut %2&#x202f;; possible&#xa0;: l’un de %3.</translation>
    </message>
    <message>
        <source>the step %1 has no parameter %2; it has %3.</source>
        <translation>l’étape %1 n’a pas de paramètre %2&#x202f;; elle a %3.</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>%1 is %2; it can be a whole number from %3 to %4.</source>
        <translation>%1 vaut %2&#x202f;; possible&#xa0;: un nombre entier de %3 à %4.</translation>
    </message>
    <message>
        <source>%1 is %2; it can be %3 to %4.</source>
        <translation>%1 vaut %2&#x202f;; possible&#xa0;: de %3 à %4.</translation>
    </message>
</context>
<context>
    <name>PhrasesText</name>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1&#x2009;px</source>
        <translation>%1 px</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>image</translation>
    </message>
    <message>
        <source>frame %1</source>
        <translation>image %1</translation>
    </message>
    <message>
        <source>1 point</source>
        <translation>1 point</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 points</translation>
    </message>
</context>
<context>
    <name>PictureFileText</name>
    <message>
        <source>%1 could not be written: %2. Choose another folder or name.</source>
        <translation>%1 n’a pas pu être écrit&#xa0;: %2. Choisis un autre dossier ou un autre nom.</translation>
    </message>
    <message>
        <source>%1 is not the name of a picture; it ends in .png or .svg.</source>
        <translation>%1 n’est pas un nom d’image&#x202f;; il doit finir par .png ou .svg.</translation>
    </message>
</context>
<context>
    <name>PlacePicker</name>
    <message>
        <source>your place, %1 away</source>
        <translation>ton endroit, à %1</translation>
    </message>
    <message>
        <source>Your cross is at %1, %2</source>
        <translation>Ta croix est en %1&#x202f;;&#xa0;%2</translation>
    </message>
    <message>
        <source>%1, %2 away from the true place %3, %4</source>
        <translation>%1, à %2 du vrai endroit %3&#x202f;; %4</translation>
    </message>
</context>
<context>
    <name>PredictionText</name>
    <message>
        <source>frame</source>
        <translation>image</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>images</translation>
    </message>
    <message>
        <source>exactly as you said</source>
        <translation>exactement ce que tu as dit</translation>
    </message>
    <message>
        <source>your number is %1 too high</source>
        <translation>ton nombre est trop grand de %1</translation>
    </message>
    <message>
        <source>your number is %1 too low</source>
        <translation>ton nombre est trop petit de %1</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1&#x202f;;&#xa0;%2</translation>
    </message>
    <message>
        <source>curve %1</source>
        <translation>courbe %1</translation>
    </message>
    <message>
        <source>You said **%1**. It is **%2**: %3&#x202f;px away.</source>
        <translation>Tu as dit **%1**. C’est **%2**&#xa0;: %3&#x202f;px d’écart.</translation>
    </message>
    <message>
        <source>You said **%1**. It is **%2**: %3.</source>
        <translation>Tu as dit **%1**. C’est **%2**&#xa0;: %3.</translation>
    </message>
    <message>
        <source>You said **%1**, and so it is.</source>
        <translation>Tu as dit **%1**, et c’est bien ça.</translation>
    </message>
    <message>
        <source>You said **%1**. It is **%2**.</source>
        <translation>Tu as dit **%1**. C’est **%2**.</translation>
    </message>
    <message>
        <source>from %1 to %2, at most %3, at least %4</source>
        <translation>de %1 à %2, au plus %3, au moins %4</translation>
    </message>
</context>
<context>
    <name>ProjectJudge</name>
    <message>
        <source>Not yet: the run does not use what you have written. Mend its mistakes first.</source>
        <translation>Pas encore&#xa0;: la simulation n’utilise pas ce que tu as écrit. Corrige d’abord ses fautes.</translation>
    </message>
    <message>
        <source>Not yet: this level needs %1. Switch it on.</source>
        <translation>Pas encore&#xa0;: ce palier exige %1. Active-le.</translation>
    </message>
    <message>
        <source>Not yet: your scene has no body %1, which this level is about. Undo, or start again.</source>
        <translation>Pas encore&#xa0;: ta scène n’a pas le corps %1, dont parle ce palier. Annule, ou recommence.</translation>
    </message>
    <message>
        <source>Not yet: this level asks you to leave %1 at %2.</source>
        <translation>Pas encore&#xa0;: ce palier te demande de laisser %1 à %2.</translation>
    </message>
    <message>
        <source>Not yet: this level asks you to leave %1 as it was: place, speed, mass and size. Undo, or start again.</source>
        <translation>Pas encore&#xa0;: ce palier te demande de laisser %1 tel quel&#xa0;: place, vitesse, masse et taille. Annule, ou recommence.</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 vaut %2</translation>
    </message>
    <message>
        <source>Not yet: the run stops in frame %1. %2</source>
        <translation>Pas encore&#xa0;: la simulation s’arrête à l’image %1. %2</translation>
    </message>
    <message>
        <source>Not yet: at the start, this does not hold: %1.</source>
        <translation>Pas encore&#xa0;: au début, ceci n’est pas vrai&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Not yet: in frame %1, this does not hold: %2.</source>
        <translation>Pas encore&#xa0;: à l’image %1, ceci n’est pas vrai&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Not yet: up to frame %1, this never happens: %2.</source>
        <translation>Pas encore&#xa0;: jusqu’à l’image %1, ceci n’arrive jamais&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Not yet: at the end, in frame %1, this does not hold: %2.</source>
        <translation>Pas encore&#xa0;: à la fin, à l’image %1, ceci n’est pas vrai&#xa0;: %2.</translation>
    </message>
    <message>
        <source>Not yet: %1</source>
        <translation>Pas encore&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>PropertyRangesText</name>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>How far to the right it starts.</source>
        <translation>À quelle distance vers la droite il commence.</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>How far down it starts.</source>
        <translation>À quelle distance vers le bas il commence.</translation>
    </message>
    <message>
        <source>Speed x</source>
        <translation>Vitesse x</translation>
    </message>
    <message>
        <source>px/frame</source>
        <translation>px/image</translation>
    </message>
    <message>
        <source>How fast it starts to the right.</source>
        <translation>Vitesse de départ vers la droite.</translation>
    </message>
    <message>
        <source>Speed y</source>
        <translation>Vitesse y</translation>
    </message>
    <message>
        <source>How fast it starts downwards.</source>
        <translation>Vitesse de départ vers le bas.</translation>
    </message>
    <message>
        <source>Mass</source>
        <translation>Masse</translation>
    </message>
    <message>
        <source>How hard it is to move. Most bodies have 1.</source>
        <translation>Difficulté à le mettre en mouvement. La plupart des corps ont 1.</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
    </message>
    <message>
        <source>Its width: walls stop its edge, and the wind pushes against it.</source>
        <translation>Sa largeur&#xa0;: les murs arrêtent son bord, et le vent pousse contre lui.</translation>
    </message>
    <message>
        <source>Nailed</source>
        <translation>Cloué</translation>
    </message>
    <message>
        <source>Whether it is fixed in place.</source>
        <translation>S’il est fixé sur place.</translation>
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
        <source>How hard it pulls a body of mass 1: this share of the missing distance in each frame.</source>
        <translation>Force de sa traction sur un corps de masse 1&#xa0;: cette part de la distance manquante à chaque image.</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Longueur</translation>
    </message>
    <message>
        <source>How far apart its two ends should be.</source>
        <translation>Distance voulue entre ses deux extrémités.</translation>
    </message>
    <message>
        <source>Share</source>
        <translation>Part</translation>
    </message>
    <message>
        <source>The share of a length error that its first end corrects; the other end corrects the rest.</source>
        <translation>La part d’une erreur de longueur que corrige sa première extrémité&#x202f;; l’autre corrige le reste.</translation>
    </message>
    <message>
        <source>Angle</source>
        <translation>Angle</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>The angle of the foot, seen from its body: 0 is left of the body, 90 above it.</source>
        <translation>L’angle du pied, vu de son corps&#xa0;: 0 est à gauche du corps, 90 au-dessus.</translation>
    </message>
    <message>
        <source>Leg</source>
        <translation>Patte</translation>
    </message>
    <message>
        <source>How long the legs of this gait group are.</source>
        <translation>Longueur des pattes de ce groupe d’allure.</translation>
    </message>
    <message>
        <source>Drop</source>
        <translation>Abaissement</translation>
    </message>
    <message>
        <source>How far below the body the legs of this gait group end.</source>
        <translation>À quelle distance sous le corps finissent les pattes de ce groupe d’allure.</translation>
    </message>
    <message>
        <source>Swing</source>
        <translation>Élan</translation>
    </message>
    <message>
        <source>rad/frame</source>
        <translation>rad/image</translation>
    </message>
    <message>
        <source>How fast the clock of this gait group turns its legs. 0: they stand still. To walk, feet need ground.</source>
        <translation>Vitesse à laquelle l’horloge de ce groupe d’allure fait tourner ses pattes. 0&#xa0;: elles restent immobiles. Pour marcher, il faut un sol aux pieds.</translation>
    </message>
    <message>
        <source>Begin</source>
        <translation>Début</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>rad</translation>
    </message>
    <message>
        <source>The angle at which that clock starts. Groups with different angles step in turn.</source>
        <translation>L’angle auquel cette horloge commence. Des groupes d’angles différents posent leurs pieds tour à tour.</translation>
    </message>
    <message>
        <source>Carries</source>
        <translation>Porte</translation>
    </message>
    <message>
        <source>Whether the feet push the body back. If they do not, they cannot carry it.</source>
        <translation>Si les pieds repoussent le corps. Sinon, ils ne peuvent pas le porter.</translation>
    </message>
    <message>
        <source>Group</source>
        <translation>Groupe</translation>
    </message>
    <message>
        <source>The gait group: its feet share one clock.</source>
        <translation>Le groupe d’allure&#xa0;: ses pieds partagent une horloge.</translation>
    </message>
</context>
<context>
    <name>PullCardText</name>
    <message>
        <source>px/frame²</source>
        <translation>px/image²</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Ctrl</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Maj</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Échap</translation>
    </message>
    <message>
        <source>Tab</source>
        <translation>Tab</translation>
    </message>
    <message>
        <source>Return</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>Backspace</source>
        <translation>Retour arrière</translation>
    </message>
    <message>
        <source>Ins</source>
        <translation>Inser</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Suppr</translation>
    </message>
</context>
<context>
    <name>QuantityText</name>
    <message>
        <source>time</source>
        <translation>temps</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>velocity x</source>
        <translation>vitesse x</translation>
    </message>
    <message>
        <source>velocity y</source>
        <translation>vitesse y</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>rapidité</translation>
    </message>
    <message>
        <source>acceleration x</source>
        <translation>accélération x</translation>
    </message>
    <message>
        <source>acceleration y</source>
        <translation>accélération y</translation>
    </message>
    <message>
        <source>size of acceleration</source>
        <translation>norme de l’accélération</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>angle</translation>
    </message>
    <message>
        <source>turning speed</source>
        <translation>vitesse angulaire</translation>
    </message>
    <message>
        <source>kinetic energy</source>
        <translation>énergie cinétique</translation>
    </message>
    <message>
        <source>distance</source>
        <translation>distance</translation>
    </message>
    <message>
        <source>total kinetic energy</source>
        <translation>énergie cinétique totale</translation>
    </message>
    <message>
        <source>total potential energy</source>
        <translation>énergie potentielle totale</translation>
    </message>
    <message>
        <source>total energy</source>
        <translation>énergie totale</translation>
    </message>
    <message>
        <source>Frames since the start of the run</source>
        <translation>Images depuis le début de la simulation</translation>
    </message>
    <message>
        <source>How far to the right it is</source>
        <translation>À quelle distance vers la droite il est</translation>
    </message>
    <message>
        <source>How far down it is: y grows downwards, in the picture and in plots</source>
        <translation>À quelle distance vers le bas il est&#xa0;: y augmente vers le bas, dans la vue et dans les graphiques</translation>
    </message>
    <message>
        <source>How far it moves to the right in a frame</source>
        <translation>De combien il se déplace vers la droite en une image</translation>
    </message>
    <message>
        <source>How far it moves down in a frame</source>
        <translation>De combien il se déplace vers le bas en une image</translation>
    </message>
    <message>
        <source>How far it moves in a frame, in any direction</source>
        <translation>De combien il se déplace en une image, dans n’importe quelle direction</translation>
    </message>
    <message>
        <source>How much its velocity to the right changed in the last frame</source>
        <translation>De combien sa vitesse vers la droite a changé à la dernière image</translation>
    </message>
    <message>
        <source>How much its velocity downwards changed in the last frame</source>
        <translation>De combien sa vitesse vers le bas a changé à la dernière image</translation>
    </message>
    <message>
        <source>How much its velocity changed in the last frame, in any direction</source>
        <translation>De combien sa vitesse a changé à la dernière image, dans n’importe quelle direction</translation>
    </message>
    <message>
        <source>Where it points: 0° is to the right, and 90° is down</source>
        <translation>Où il pointe&#xa0;: 0° est vers la droite, et 90° vers le bas</translation>
    </message>
    <message>
        <source>How much its angle changes in a frame</source>
        <translation>De combien son angle change en une image</translation>
    </message>
    <message>
        <source>Half its mass times the square of its speed</source>
        <translation>La moitié de sa masse multipliée par le carré de sa rapidité</translation>
    </message>
    <message>
        <source>How far two bodies are from each other, centre to centre</source>
        <translation>À quelle distance deux corps sont l’un de l’autre, de centre à centre</translation>
    </message>
    <message>
        <source>The energy of motion of everything together</source>
        <translation>L’énergie de mouvement de tout l’ensemble</translation>
    </message>
    <message>
        <source>The energy stored in springs and in height</source>
        <translation>L’énergie stockée dans les ressorts et dans la hauteur</translation>
    </message>
    <message>
        <source>Kinetic and potential energy of everything together</source>
        <translation>L’énergie cinétique et potentielle de tout l’ensemble</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>images</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>px/frame</source>
        <translation>px/image</translation>
    </message>
    <message>
        <source>px/frame²</source>
        <translation>px/image²</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>degrés</translation>
    </message>
    <message>
        <source>degrees/frame</source>
        <translation>degrés/image</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>%1 %2 – %3</source>
        <translation>%1 %2 – %3</translation>
    </message>
    <message>
        <source>There is no %1 in this step. Choose another body above. The curve returns in the next step that has %1.</source>
        <translation>Il n’y a pas de «&#x202f;%1&#x202f;» dans cette étape. Choisis un autre corps ci-dessus. La courbe reviendra à la prochaine étape qui a «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>%1 is moved from outside, so it has no velocity of its own. Choose its position above instead.</source>
        <translation>«&#x202f;%1&#x202f;» est déplacé de l’extérieur, donc il n’a pas de vitesse propre. Choisis plutôt sa position ci-dessus.</translation>
    </message>
    <message>
        <source>This scene has only points, and points have no angle. Choose another quantity above.</source>
        <translation>Cette scène n’a que des points, et les points n’ont pas d’angle. Choisis une autre grandeur ci-dessus.</translation>
    </message>
</context>
<context>
    <name>QuotingText</name>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 de plus</translation>
    </message>
</context>
<context>
    <name>ReferenceMarksText</name>
    <message>
        <source>%1 off the reference here</source>
        <translation>ici à %1 de la référence</translation>
    </message>
</context>
<context>
    <name>RestText</name>
    <message>
        <source>Everything is at rest: a frame costs nothing until you touch something.</source>
        <translation>Tout est au repos&#xa0;: une image ne coûte rien tant que tu ne touches à rien.</translation>
    </message>
    <message>
        <source>Nothing can rest now, because “%1” changes over time.</source>
        <translation>Rien ne peut être au repos maintenant, car «&#x202f;%1&#x202f;» change au cours du temps.</translation>
    </message>
    <message>
        <source>With a method that chooses its own steps, bodies at rest cost as much as moving ones.</source>
        <translation>Avec une méthode qui choisit ses pas de temps, les corps au repos coûtent autant que ceux qui bougent.</translation>
    </message>
    <message>
        <source>Bodies at rest cost nothing until you touch them.</source>
        <translation>Les corps au repos ne coûtent rien tant que tu ne les touches pas.</translation>
    </message>
</context>
<context>
    <name>RuleCode</name>
    <message>
        <source>The force on each body.</source>
        <translation>La force sur chaque corps.</translation>
    </message>
    <message>
        <source>me.position is in px, y points down.</source>
        <translation>me.position est en px, y pointe vers le bas.</translation>
    </message>
    <message>
        <source>me.velocity is in px per frame.</source>
        <translation>me.velocity est en px par image.</translation>
    </message>
    <message>
        <source>The force on me from other.</source>
        <translation>La force sur me venant de other.</translation>
    </message>
    <message>
        <source>It acts on both ends of each rule link.</source>
        <translation>Elle agit sur les deux extrémités de chaque liaison de la règle.</translation>
    </message>
    <message>
        <source>Change rule</source>
        <translation>Modifier la règle</translation>
    </message>
    <message>
        <source>Delete rule</source>
        <translation>Supprimer la règle</translation>
    </message>
    <message>
        <source>your rule</source>
        <translation>ta règle</translation>
    </message>
    <message>
        <source>no rule</source>
        <translation>aucune règle</translation>
    </message>
</context>
<context>
    <name>RuleErrorText</name>
    <message>
        <source>Line %1 of your rule, for %2: %3</source>
        <translation>Ligne %1 de ta règle, pour %2&#xa0;: %3</translation>
    </message>
    <message>
        <source>Line %1 of your rule, for %2 and %3: %4</source>
        <translation>Ligne %1 de ta règle, pour %2 et %3&#xa0;: %4</translation>
    </message>
</context>
<context>
    <name>Ruler</name>
    <message>
        <source>%1&#x2009;px, %2°</source>
        <translation>%1 px, %2°</translation>
    </message>
</context>
<context>
    <name>RunPositionText</name>
    <message>
        <source>step %1 of %2</source>
        <translation>pas de temps %1 sur %2</translation>
    </message>
    <message>
        <source>%1 of %2 phases done</source>
        <translation>phases faites&#xa0;: %1 sur %2</translation>
    </message>
    <message>
        <source>Frame %1</source>
        <translation>Image %1</translation>
    </message>
    <message>
        <source>Frame %1, after %2, %3</source>
        <translation>Image %1, après «&#x202f;%2&#x202f;», %3</translation>
    </message>
</context>
<context>
    <name>RunProgramText</name>
    <message>
        <source>Line %1 of your code: %2</source>
        <translation>Ligne %1 de ton code&#xa0;: %2</translation>
    </message>
    <message>
        <source>Stopped at frame %1. %2</source>
        <translation>Arrêt à l’image %1. %2</translation>
    </message>
</context>
<context>
    <name>RunSetupText</name>
    <message>
        <source>%1 cannot be %2. It can be: %3.</source>
        <translation>%1 ne peut pas être %2. Possible&#xa0;: %3.</translation>
    </message>
    <message>
        <source>%1 cannot be %2. It can be a number from %3 to %4.</source>
        <translation>%1 ne peut pas être %2. Possible&#xa0;: un nombre de %3 à %4.</translation>
    </message>
    <message>
        <source>There is no body %1 here; there are %2.</source>
        <translation>Il n’y a pas de corps %1 ici&#x202f;; il y a %2.</translation>
    </message>
    <message>
        <source>There is no parameter %1 here; there are %2.</source>
        <translation>Il n’y a pas de paramètre %1 ici&#x202f;; il y a %2.</translation>
    </message>
    <message>
        <source>There is no method %1; the methods are %2.</source>
        <translation>Il n’y a pas de méthode %1&#x202f;; les méthodes sont %2.</translation>
    </message>
</context>
<context>
    <name>SandboxPropertiesText</name>
    <message>
        <source>Point %1</source>
        <translation>Point %1</translation>
    </message>
    <message>
        <source>Spring</source>
        <translation>Ressort</translation>
    </message>
    <message>
        <source>%1 springs</source>
        <translation>%1 ressorts</translation>
    </message>
    <message>
        <source>Stick</source>
        <translation>Tige</translation>
    </message>
    <message>
        <source>%1 sticks</source>
        <translation>%1 tiges</translation>
    </message>
    <message>
        <source>Foot of %1</source>
        <translation>Pied de %1</translation>
    </message>
    <message>
        <source>Gait group %1</source>
        <translation>Groupe d’allure %1</translation>
    </message>
</context>
<context>
    <name>SandboxText</name>
    <message>
        <source>the order in which points move (%1), because here all move at once</source>
        <translation>l’ordre dans lequel les points bougent (%1), car ici tous bougent à la fois</translation>
    </message>
    <message>
        <source>This is your own copy of the scene: change what you like.</source>
        <translation>C’est ta propre copie de la scène&#xa0;: change ce que tu veux.</translation>
    </message>
    <message>
        <source>This is your own copy of the scene. It could not be copied completely. Missing: %1.</source>
        <translation>C’est ta propre copie de la scène. Elle n’a pas pu être copiée en entier. Il manque&#xa0;: %1.</translation>
    </message>
    <message>
        <source>This scene has %1 points, but the sandbox allows only %2. Choose a smaller scene.</source>
        <translation>Cette scène a %1 points, mais le bac à sable n’en permet que %2. Choisis une scène plus petite.</translation>
    </message>
    <message>
        <source>The sandbox cannot open this scene, because it has no branches with joints. Take another scene, or look at the examples in the sandbox.</source>
        <translation>Le bac à sable ne peut pas ouvrir cette scène, car il n’a pas de branches avec articulations. Prends une autre scène, ou regarde les exemples du bac à sable.</translation>
    </message>
    <message>
        <source>This scene has flown apart: a point is more than %1 px away, or moves that far in a frame. Go back in time, and take the scene from there.</source>
        <translation>Cette scène a volé en éclats&#xa0;: un point est à plus de %1 px, ou bouge d’autant en une image. Reviens en arrière dans le temps, et reprends la scène à partir de là.</translation>
    </message>
    <message>
        <source>Take scene to sandbox</source>
        <translation>Emporter la scène au bac à sable</translation>
    </message>
    <message>
        <source>Open example %1</source>
        <translation>Ouvrir l’exemple %1</translation>
    </message>
    <message>
        <source>You can only build at the start of the run. Press Home to go there.</source>
        <translation>Tu ne peux construire qu’au début de la simulation. Appuie sur Début pour y aller.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Ajouter %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Retirer %1</translation>
    </message>
    <message>
        <source>Start new scene</source>
        <translation>Nouvelle scène</translation>
    </message>
    <message>
        <source>A new scene has one point, the fewest that a scene can have. Move it, or add parts to it.</source>
        <translation>Une nouvelle scène a un point, le minimum possible. Déplace-le, ou ajoute des éléments.</translation>
    </message>
</context>
<context>
    <name>SceneExport</name>
    <message>
        <source>The picture of the scene is copied.</source>
        <translation>La capture de la scène est copiée.</translation>
    </message>
    <message>
        <source>Picture of the scene</source>
        <translation>Capture de la scène</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg)</source>
        <translation>Captures (*.png *.svg)</translation>
    </message>
    <message>
        <source>Could not save the picture: %1</source>
        <translation>Impossible d’enregistrer la capture&#xa0;: %1</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Enregistré sous %1.</translation>
    </message>
    <message>
        <source>Could not write the handout: %1</source>
        <translation>Impossible d’écrire la fiche&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>SceneOverlay</name>
    <message>
        <source>sum so far</source>
        <translation>somme jusqu’ici</translation>
    </message>
    <message>
        <source>sum of all pulls</source>
        <translation>somme des tractions</translation>
    </message>
</context>
<context>
    <name>ScreenshotText</name>
    <message>
        <source>--mode is %1; it can be &quot;learn&quot; or &quot;measure&quot;.</source>
        <translation>--mode vaut %1&#x202f;; possible&#xa0;: &quot;learn&quot; ou &quot;measure&quot;.</translation>
    </message>
    <message>
        <source>--stability is %1; it can be &quot;gauge&quot;, &quot;reasons&quot;, or a map: &quot;step&quot;, &quot;damping&quot; or &quot;rest&quot;.</source>
        <translation>--stability vaut %1&#x202f;; possible&#xa0;: &quot;gauge&quot;, &quot;reasons&quot;, ou une carte&#xa0;: &quot;step&quot;, &quot;damping&quot; ou &quot;rest&quot;.</translation>
    </message>
    <message>
        <source>%1 is not a step; name it as LESSON/STEP, as &quot;springstep lessons&quot; lists them.</source>
        <translation>%1 n’est pas une étape&#x202f;; nomme-la par LESSON/STEP, comme les donne «&#x202f;springstep lessons&#x202f;».</translation>
    </message>
</context>
<context>
    <name>SentencesText</name>
    <message>
        <source>The step %1 is not allowed. It can be a whole number of frames, or 1 divided by a whole number, from 0.000001 to 100 frames.</source>
        <translation>Le pas de temps %1 n’est pas permis. Possible&#xa0;: un nombre entier d’images, ou 1 divisé par un nombre entier, de 0.000001 à 100 images.</translation>
    </message>
    <message>
        <source>The tolerance %1 is not allowed. It can be from 1e-13 to 100 px.</source>
        <translation>La tolérance %1 n’est pas permise. Possible&#xa0;: de 1e-13 à 100 px.</translation>
    </message>
    <message>
        <source>The method %1 chooses its own steps. Choose a tolerance in px instead of a step.</source>
        <translation>La méthode «&#x202f;%1&#x202f;» choisit elle-même ses pas de temps. Choisis une tolérance en px au lieu d’un pas de temps.</translation>
    </message>
    <message>
        <source>Stopped at frame %1: your code has a mistake that stops the next frame.</source>
        <translation>Arrêt à l’image %1&#xa0;: ton code a une faute qui arrête l’image suivante.</translation>
    </message>
    <message>
        <source>Your code computes whole frames, so its step cannot be %1. Choose a step of 1 frame.</source>
        <translation>Ton code calcule des images entières, donc son pas de temps ne peut pas être %1. Choisis un pas de temps de 1 image.</translation>
    </message>
    <message>
        <source>The method %1 has fixed steps. Choose a step in frames instead of a tolerance.</source>
        <translation>La méthode «&#x202f;%1&#x202f;» a des pas de temps fixes. Choisis un pas de temps en images au lieu d’une tolérance.</translation>
    </message>
    <message>
        <source>%1 acts once per step, so smaller steps give a different motion from the first frame on.</source>
        <translation>«&#x202f;%1&#x202f;» agit une fois par pas de temps, donc des pas de temps plus petits donnent un autre mouvement dès la première image.</translation>
    </message>
    <message>
        <source>There is nothing to compare with after frame %1.</source>
        <translation>Il n’y a rien à quoi comparer après l’image %1.</translation>
    </message>
    <message>
        <source>The method %1 cannot compute %2: choose another method, or switch that effect off.</source>
        <translation>La méthode «&#x202f;%1&#x202f;» ne peut pas calculer «&#x202f;%2&#x202f;»&#xa0;: choisis une autre méthode, ou désactive cet effet.</translation>
    </message>
    <message>
        <source>The method %1 cannot compute this scene, because parts of it have no velocity of their own. Choose another method.</source>
        <translation>La méthode «&#x202f;%1&#x202f;» ne peut pas calculer cette scène, car certaines de ses parties n’ont pas de vitesse propre. Choisis une autre méthode.</translation>
    </message>
    <message>
        <source>Nothing in this scene can move. Leave at least one body free.</source>
        <translation>Rien ne peut bouger dans cette scène. Laisse au moins un corps libre.</translation>
    </message>
    <message>
        <source>This scene has %1 points, and at most %2 can be measured with every method. Measure a smaller scene of the same kind: its results are valid for this one, too.</source>
        <translation>Cette scène a %1 points, et on peut en mesurer au plus %2 avec chaque méthode. Mesure une scène plus petite du même genre&#xa0;: ses résultats valent aussi pour celle-ci.</translation>
    </message>
    <message>
        <source>This tree would have more than %1 branches: make its slope smaller than %2, or its smallest branch larger than %3.</source>
        <translation>Cet arbre aurait plus de %1 branches&#xa0;: rends sa réduction plus petite que %2, ou sa plus petite branche plus grande que %3.</translation>
    </message>
    <message>
        <source>Stick %1 ends at p%2, but there is no such point. There are %3 points, and the first is p0.</source>
        <translation>La tige %1 finit en p%2, mais ce point n’existe pas. Il y a %3 points, et le premier est p0.</translation>
    </message>
    <message>
        <source>Spring %1 ends at p%2, but there is no such point. There are %3 points, and the first is p0.</source>
        <translation>Le ressort %1 finit en p%2, mais ce point n’existe pas. Il y a %3 points, et le premier est p0.</translation>
    </message>
    <message>
        <source>The event %1 before frame %2 has a value that is infinite or not a number. Give it a finite number.</source>
        <translation>L’événement %1 avant l’image %2 a une valeur infinie ou qui n’est pas un nombre. Donne-lui un nombre fini.</translation>
    </message>
    <message>
        <source>The start of %1 has a value that is infinite or not a number. Give it a finite number.</source>
        <translation>Le départ de %1 a une valeur infinie ou qui n’est pas un nombre. Donne-lui un nombre fini.</translation>
    </message>
    <message>
        <source>These settings do not fit together: %1.</source>
        <translation>Ces réglages ne vont pas ensemble&#xa0;: %1.</translation>
    </message>
    <message>
        <source>The spring of %1</source>
        <translation>Le ressort de %1</translation>
    </message>
    <message>
        <source>The force on %1 (%2)</source>
        <translation>La force sur %1 (%2)</translation>
    </message>
    <message>
        <source>%1 – %2</source>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>The spring %1</source>
        <translation>Le ressort %1</translation>
    </message>
    <message>
        <source>Stopped at frame %1: the method needs too many steps for the next frame.</source>
        <translation>Arrêt à l’image %1&#xa0;: la méthode a besoin de trop de pas de temps pour l’image suivante.</translation>
    </message>
    <message>
        <source>%1 is strongest.</source>
        <translation>%1 agit le plus fort.</translation>
    </message>
    <message>
        <source>The strongest force acts on %1.</source>
        <translation>La force la plus grande agit sur %1.</translation>
    </message>
    <message>
        <source>Try a larger tolerance, or a method with fixed steps.</source>
        <translation>Essaie une tolérance plus grande, ou une méthode à pas de temps fixes.</translation>
    </message>
    <message>
        <source>Stopped at frame %1: in the next frame, a number is not finite.</source>
        <translation>Arrêt à l’image %1&#xa0;: à l’image suivante, un nombre n’est pas fini.</translation>
    </message>
    <message>
        <source>Stopped at frame %1: in the next frame, “%2” is too far away or too fast for a number (not finite).</source>
        <translation>Arrêt à l’image %1&#xa0;: à l’image suivante, «&#x202f;%2&#x202f;» est trop loin ou trop rapide pour un nombre (pas fini).</translation>
    </message>
    <message>
        <source>It began in “%1”.</source>
        <translation>Cela a commencé dans «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>It moves one body after the other, so the pulls between them do not cancel.</source>
        <translation>Elle déplace les corps l’un après l’autre, donc les tractions entre eux ne se compensent pas.</translation>
    </message>
    <message>
        <source>It looks for the moment when a body leaves the walls, but here a body never leaves them.</source>
        <translation>Elle cherche le moment où un corps quitte les murs, mais ici un corps ne les quitte jamais.</translation>
    </message>
    <message>
        <source>It would need about %1 steps in a frame, but stops after %2.</source>
        <translation>Il lui faudrait environ %1 pas de temps par image, mais elle s’arrête après %2.</translation>
    </message>
    <message>
        <source>Without damping, the errors of its steps add up: to %1 px in %2 frames at worst.</source>
        <translation>Sans amortissement, les erreurs de ses pas de temps s’accumulent&#xa0;: au pire, jusqu’à %1 px en %2 images.</translation>
    </message>
    <message>
        <source>Because its steps may have errors of %1 px, it never comes fully to rest: it moves by up to %2 px a frame.</source>
        <translation>Comme ses pas de temps peuvent avoir des erreurs de %1 px, elle ne s’immobilise jamais tout à fait&#xa0;: elle bouge d’au plus %2 px par image.</translation>
    </message>
    <message>
        <source>With a step of %1, its stiffest spring (stiffness %2) would swing from %3 px to %4 px, and farther.</source>
        <translation>Avec un pas de temps de %1, son ressort le plus raide (raideur %2) oscillerait de %3 px jusqu’à %4 px, et plus loin.</translation>
    </message>
    <message>
        <source>Its sticks are only tested with steps up to %1. With a step of %2, their errors are larger.</source>
        <translation>Ses tiges ne sont testées qu’avec des pas de temps jusqu’à %1. Avec un pas de temps de %2, leurs erreurs sont plus grandes.</translation>
    </message>
    <message>
        <source>With a step of %1, its stiffest spring (stiffness %2) would not stop swinging: of %3 px, %4 px would be left after %5 frames.</source>
        <translation>Avec un pas de temps de %1, son ressort le plus raide (raideur %2) ne cesserait pas d’osciller&#xa0;: sur %3 px, il resterait %4 px après %5 images.</translation>
    </message>
    <message>
        <source>After frame %1, the position of %2 is no longer a finite number: it overflowed in &quot;%3&quot;.</source>
        <translation>Après l’image %1, la position de %2 n’est plus un nombre fini&#xa0;: elle est devenue trop grande dans «&#x202f;%3&#x202f;».</translation>
    </message>
    <message>
        <source>After frame %1, the method needs more steps for one frame than allowed.</source>
        <translation>Après l’image %1, il faut à la méthode plus de pas de temps pour une image que ce qui est permis.</translation>
    </message>
    <message>
        <source>At frame %1, %2 is more than %3 px away.</source>
        <translation>À l’image %1, «&#x202f;%2&#x202f;» est à plus de %3 px.</translation>
    </message>
    <message>
        <source>At frame %1, the centre of mass has moved %2 px, although nothing pushed it.</source>
        <translation>À l’image %1, le centre de masse s’est déplacé de %2 px, alors que rien ne l’a poussé.</translation>
    </message>
    <message>
        <source>At frame %1, the length of the stick between %2 and %3 is wrong by %4 px, more than the expected %5 px.</source>
        <translation>À l’image %1, la longueur de la tige entre %2 et %3 est fausse de %4 px, plus que les %5 px attendus.</translation>
    </message>
    <message>
        <source>At the end, %1 still moves %2 px a frame.</source>
        <translation>À la fin, %1 bouge encore de %2 px par image.</translation>
    </message>
    <message>
        <source>At the end, %1 is %2 px from where it should rest.</source>
        <translation>À la fin, «&#x202f;%1&#x202f;» est à %2 px de l’endroit où il devrait reposer.</translation>
    </message>
    <message>
        <source>At the end, the distance between %1 and %2 is wrong by %3 px.</source>
        <translation>À la fin, la distance entre %1 et %2 est fausse de %3 px.</translation>
    </message>
    <message>
        <source>A second run differs from the first one at frame %1.</source>
        <translation>Une deuxième simulation diffère de la première à l’image %1.</translation>
    </message>
    <message>
        <source>This input should be rejected, but it was accepted.</source>
        <translation>Cette entrée devrait être refusée, mais elle a été acceptée.</translation>
    </message>
    <message>
        <source>The run should stop and name the number that is not finite, but it does not.</source>
        <translation>La simulation devrait s’arrêter et nommer le nombre qui n’est pas fini, mais elle ne le fait pas.</translation>
    </message>
</context>
<context>
    <name>StabilityText</name>
    <message>
        <source>%1 × the limit</source>
        <translation>%1 × la limite</translation>
    </message>
    <message>
        <source>%1&#x2009;% of the limit</source>
        <translation>%1 % de la limite</translation>
    </message>
    <message>
        <source>%1&#x2009;frames</source>
        <translation>%1 images</translation>
    </message>
    <message>
        <source>%1 sets the limit.</source>
        <translation>%1 fixe la limite.</translation>
    </message>
    <message>
        <source>Past the limit it swings to the other side at each step, farther each time.</source>
        <translation>Au-delà de la limite, il passe de l’autre côté à chaque pas de temps, chaque fois plus loin.</translation>
    </message>
    <message>
        <source>Past the limit it swings wider and wider.</source>
        <translation>Au-delà de la limite, il oscille de plus en plus fort.</translation>
    </message>
    <message>
        <source>Past the limit all of it drifts off, faster and faster: one end moves before the other does, so their pulls do not cancel.</source>
        <translation>Au-delà de la limite, tout part à la dérive, de plus en plus vite&#xa0;: une extrémité bouge avant l’autre, donc leurs tractions ne se compensent pas.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Every step is stable, because of the damping.&lt;/b&gt; However long it is, no swing grows here.</source>
        <translation>&lt;b&gt;Tout pas de temps est stable, grâce à l’amortissement.&lt;/b&gt; Aussi long soit-il, aucune oscillation ne grandit ici.</translation>
    </message>
    <message>
        <source>&lt;b&gt;No step is stable.&lt;/b&gt; This one is so short that the growth is too slow to notice.</source>
        <translation>&lt;b&gt;Aucun pas de temps n’est stable.&lt;/b&gt; Celui-ci est si court que la croissance est trop lente pour se remarquer.</translation>
    </message>
    <message>
        <source>&lt;b&gt;No shorter step is stable.&lt;/b&gt; This one is, because of the damping.</source>
        <translation>&lt;b&gt;Aucun pas de temps plus court n’est stable.&lt;/b&gt; Celui-ci l’est, grâce à l’amortissement.</translation>
    </message>
    <message>
        <source>&lt;b&gt;No step is stable.&lt;/b&gt; With this method and so little damping, small disturbances %1. They also grow with any shorter step.</source>
        <translation>&lt;b&gt;Aucun pas de temps n’est stable.&lt;/b&gt; Avec cette méthode et si peu d’amortissement, les petites perturbations %1. Elles grandissent aussi avec tout pas de temps plus court.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1, but still stable.&lt;/b&gt; Steps longer than %2 are unstable, but this one is so long that the damping makes it stable again.</source>
        <translation>&lt;b&gt;%1, mais stable quand même.&lt;/b&gt; Les pas de temps au-delà de %2 sont instables, mais celui-ci est si long que l’amortissement le rend de nouveau stable.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1.&lt;/b&gt; Small disturbances %2. Steps up to %3 are stable.</source>
        <translation>&lt;b&gt;%1.&lt;/b&gt; Les petites perturbations %2. Les pas de temps jusqu’à %3 sont stables.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1.&lt;/b&gt; Steps up to %2 are stable here.</source>
        <translation>&lt;b&gt;%1.&lt;/b&gt; Les pas de temps jusqu’à %2 sont stables ici.</translation>
    </message>
    <message>
        <source>grow more than a million times a frame</source>
        <translation>sont multipliées par plus d’un million à chaque image</translation>
    </message>
    <message>
        <source>grow by %1&#x2009;% a frame</source>
        <translation>grandissent de %1 % par image</translation>
    </message>
    <message>
        <source>grow %1 times a frame</source>
        <translation>sont multipliées par %1 à chaque image</translation>
    </message>
    <message>
        <source>no limit</source>
        <translation>aucune limite</translation>
    </message>
    <message>
        <source>by its tolerance</source>
        <translation>par sa tolérance</translation>
    </message>
    <message>
        <source>no springs act</source>
        <translation>aucun ressort</translation>
    </message>
    <message>
        <source>unknown here</source>
        <translation>inconnue ici</translation>
    </message>
    <message>
        <source>too many points</source>
        <translation>trop de points</translation>
    </message>
    <message>
        <source>stable by damping</source>
        <translation>stable par amortissement</translation>
    </message>
    <message>
        <source>just stable</source>
        <translation>tout juste stable</translation>
    </message>
    <message>
        <source>no stable step</source>
        <translation>aucun pas de temps stable</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 has no such limit.&lt;/b&gt; Long steps are stable, however stiff the springs are; they are only less accurate. Choose the step for the accuracy that you want.</source>
        <translation>&lt;b&gt;«&#x202f;%1&#x202f;» n’a pas de telle limite.&lt;/b&gt; Les longs pas de temps sont stables, aussi raides que soient les ressorts&#x202f;; ils sont seulement moins précis. Choisis le pas de temps selon la précision voulue.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1 keeps its own steps short enough.&lt;/b&gt; Its tolerance, %2, limits them.</source>
        <translation>&lt;b&gt;«&#x202f;%1&#x202f;» garde elle-même ses pas de temps assez courts.&lt;/b&gt; Sa tolérance, %2, les limite.</translation>
    </message>
    <message>
        <source>&lt;b&gt;No springs act here.&lt;/b&gt; The other effects have no stiffness, so no step is too long for them.</source>
        <translation>&lt;b&gt;Aucun ressort n’agit ici.&lt;/b&gt; Les autres effets n’ont pas de raideur, donc aucun pas de temps n’est trop long pour eux.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Unknown here.&lt;/b&gt; The pulls in this state are not finite numbers.</source>
        <translation>&lt;b&gt;Inconnue ici.&lt;/b&gt; Les tractions dans cet état ne sont pas des nombres finis.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Too many points.&lt;/b&gt; With more than %1 of them, finding the limit would take too long. If the creatures do not touch each other, look at only a few of them: their limit is the same.</source>
        <translation>&lt;b&gt;Trop de points.&lt;/b&gt; Avec plus de %1, trouver la limite prendrait trop de temps. Si les créatures ne se touchent pas, n’en regarde que quelques-unes&#xa0;: leur limite est la même.</translation>
    </message>
    <message>
        <source>Not included: %1. They act in jumps, once per step, and have no stiffness.</source>
        <translation>Non compris&#xa0;: %1. Ils agissent par sauts, une fois par pas de temps, et n’ont pas de raideur.</translation>
    </message>
    <message>
        <source>%1 For sticks that carry weight, smaller steps help more than more passes.</source>
        <translation>%1 Pour des tiges qui portent du poids, des pas de temps plus petits aident mieux que plus de passes.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Sticks keep their lengths.&lt;/b&gt; None was wrong by more than %1&#x2009;px in the last %2 frames.</source>
        <translation>&lt;b&gt;Les tiges gardent leur longueur.&lt;/b&gt; Aucune n’a été fausse de plus de %1 px dans les %2 dernières images.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Sticks are up to %1&#x2009;px too long:&lt;/b&gt; %2 – %3 in the last %4 frames.</source>
        <translation>&lt;b&gt;Des tiges ont jusqu’à %1 px de trop&#xa0;:&lt;/b&gt; %2 – %3 dans les %4 dernières images.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Sticks are up to %1&#x2009;px too short:&lt;/b&gt; %2 – %3 in the last %4 frames.</source>
        <translation>&lt;b&gt;À des tiges, il manque jusqu’à %1 px&#xa0;:&lt;/b&gt; %2 – %3 dans les %4 dernières images.</translation>
    </message>
    <message>
        <source>%1 Neither shorter steps nor more passes halve this error. Perhaps the lengths contradict each other.</source>
        <translation>%1 Ni des pas de temps plus courts ni plus de passes ne réduisent cette erreur de moitié. Les longueurs se contredisent peut-être.</translation>
    </message>
    <message>
        <source>Use a &amp;step of %1</source>
        <translation>&amp;Pas de temps de %1</translation>
    </message>
    <message>
        <source>Use a &amp;tolerance of %1</source>
        <translation>&amp;Tolérance de %1</translation>
    </message>
    <message>
        <source>&amp;Damp more: %1 %2</source>
        <translation>A&amp;mortir plus&#xa0;: %1 %2</translation>
    </message>
    <message numerus="yes">
        <source>Use %n &amp;passes</source>
        <translation>
            <numerusform>Faire %n pa&amp;sse</numerusform>
            <numerusform>Faire %n pa&amp;sses</numerusform>
        </translation>
    </message>
    <message>
        <source>&amp;Use %1</source>
        <translation>&amp;Utiliser %1</translation>
    </message>
    <message>
        <source>sticks are then wrong by up to %1&#x2009;px</source>
        <translation>les tiges sont alors fausses d’au plus %1 px</translation>
    </message>
    <message>
        <source>then at %1</source>
        <translation>alors à %1</translation>
    </message>
    <message>
        <source>every step is then stable, because of the damping</source>
        <translation>tout pas de temps est alors stable, grâce à l’amortissement</translation>
    </message>
    <message>
        <source>chooses its own steps</source>
        <translation>choisit elle-même ses pas de temps</translation>
    </message>
    <message>
        <source>has no such limit</source>
        <translation>n’a pas de telle limite</translation>
    </message>
    <message>
        <source>&lt;b&gt;Unknown for your code.&lt;/b&gt; The limit follows from the springs of the scene, and your code may compute anything else.</source>
        <translation>&lt;b&gt;Inconnue pour ton code.&lt;/b&gt; La limite découle des ressorts de la scène, et ton code peut calculer tout autre chose.</translation>
    </message>
    <message>
        <source>&lt;b&gt;Unknown for this rule.&lt;/b&gt; Its force depends on velocities, and the limit is computed from positions only. Try a shorter step: if the motion stays the same, the step is short enough.</source>
        <translation>&lt;b&gt;Inconnue pour cette règle.&lt;/b&gt; Sa force dépend de vitesses, et la limite est calculée à partir des positions seules. Essaie un pas plus court : si le mouvement reste le même, le pas est assez court.</translation>
    </message>
</context>
<context>
    <name>StepText</name>
    <message>
        <source>1/%1 frame</source>
        <translation>1/%1 image</translation>
    </message>
    <message>
        <source>1 frame</source>
        <translation>1 image</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 images</translation>
    </message>
</context>
<context>
    <name>TerminalText</name>
    <message>
        <source>springstep: there is not enough memory for this; close other programs, or give it a smaller experiment.</source>
        <translation>springstep&#xa0;: il n’y a pas assez de mémoire pour cela&#x202f;; ferme d’autres programmes, ou donne une expérience plus petite.</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Interrompu&#xa0;: %1</translation>
    </message>
    <message>
        <source>%1… %2 s</source>
        <translation>%1… %2 s</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Image %1 sur %2</translation>
    </message>
    <message>
        <source>Stopped at frame %1 of %2.</source>
        <translation>Arrêt à l’image %1 sur %2.</translation>
    </message>
    <message>
        <source>Stopped before the end.</source>
        <translation>Arrêt avant la fin.</translation>
    </message>
</context>
<context>
    <name>TraceText</name>
    <message>
        <source>Setting up the run</source>
        <translation>Préparation de la simulation</translation>
    </message>
    <message>
        <source>The rows could not be written: %1. Free some disk space, or write to another folder.</source>
        <translation>Les lignes n’ont pas pu être écrites&#xa0;: %1. Libère de l’espace disque, ou écris dans un autre dossier.</translation>
    </message>
</context>
<context>
    <name>UnitCircle</name>
    <message>
        <source>The arrow has no length,</source>
        <translation>La flèche n’a pas de longueur,</translation>
    </message>
    <message>
        <source>so it has no direction.</source>
        <translation>donc pas de direction.</translation>
    </message>
    <message>
        <source>%1 = %2 / %3 = %4</source>
        <extracomment>cosine = 40 / 50 = 0.8</extracomment>
        <translation>%1 = %2 / %3 = %4</translation>
    </message>
    <message>
        <source>angle = %1° = %2&#x2009;rad</source>
        <translation>angle = %1° = %2 rad</translation>
    </message>
    <message>
        <source>cosine</source>
        <translation>cosinus</translation>
    </message>
    <message>
        <source>the side beside the angle</source>
        <translation>le côté adjacent à l’angle</translation>
    </message>
    <message>
        <source>sine</source>
        <translation>sinus</translation>
    </message>
    <message>
        <source>the side opposite the angle</source>
        <translation>le côté opposé à l’angle</translation>
    </message>
    <message>
        <source>%1² + %2² = 1</source>
        <extracomment>Pythagoras: 0.8² + 0.6² = 1</extracomment>
        <translation>%1² + %2² = 1</translation>
    </message>
    <message>
        <source>y points down: a sine above 0 is down</source>
        <translation>y pointe en bas&#xa0;: un sinus positif, en bas</translation>
    </message>
    <message>
        <source>Unit circle</source>
        <translation>Cercle trigonométrique</translation>
    </message>
</context>
<context>
    <name>VerbsText</name>
    <message>
        <source>Prints the result as JSON.</source>
        <translation>Affiche le résultat en JSON.</translation>
    </message>
    <message>
        <source>Width and height in pixels, each from 100 to 9999.</source>
        <translation>Largeur et hauteur en pixels, chacune de 100 à 9999.</translation>
    </message>
    <message>
        <source>light, dark or contrast.</source>
        <translation>light, dark ou contrast.</translation>
    </message>
    <message>
        <source>The experiment.</source>
        <translation>L’expérience.</translation>
    </message>
    <message>
        <source>The experiment or the step of a lesson.</source>
        <translation>L’expérience ou l’étape d’une leçon.</translation>
    </message>
    <message>
        <source>Lists lessons, steps, parameters and methods.</source>
        <translation>Liste les leçons, les étapes, les paramètres et les méthodes.</translation>
    </message>
    <message>
        <source>Computes the run of an experiment and writes every frame as CSV.</source>
        <translation>Calcule la simulation d’une expérience et écrit chaque image en CSV.</translation>
    </message>
    <message>
        <source>Measures the error of each method on a scene, and its cost.</source>
        <translation>Mesure l’erreur de chaque méthode sur une scène, et son coût.</translation>
    </message>
    <message>
        <source>Also draws error against time, as an SVG file.</source>
        <translation>Trace aussi l’erreur en fonction du temps, dans un fichier SVG.</translation>
    </message>
    <message>
        <source>Also names the cheapest method and step with an error of at most E px.</source>
        <translation>Nomme aussi la méthode et le pas de temps les moins coûteux avec une erreur d’au plus E px.</translation>
    </message>
    <message>
        <source>The number of frames to compute (default: the file&apos;s, at most 1000, or 200 for a step).</source>
        <translation>Le nombre d’images à calculer (par défaut&#xa0;: celui du fichier, au plus 1000, ou 200 pour une étape).</translation>
    </message>
    <message>
        <source>Runs every hard case with every method. The exit code is 1 if a method fails a case that it claims.</source>
        <translation>Exécute chaque cas difficile avec chaque méthode. Le code de sortie est 1 si une méthode échoue à un cas qu’elle promet.</translation>
    </message>
    <message>
        <source>Runs this case only.</source>
        <translation>N’exécute que ce cas.</translation>
    </message>
    <message>
        <source>Runs the cases at full size. Some take hours.</source>
        <translation>Exécute les cas en taille réelle. Certains prennent des heures.</translation>
    </message>
    <message>
        <source>Measures the time of a frame, and of each effect in it.</source>
        <translation>Mesure le temps d’une image, et de chaque effet qu’elle contient.</translation>
    </message>
    <message>
        <source>Measures the frames after frame N.</source>
        <translation>Mesure les images après l’image N.</translation>
    </message>
    <message>
        <source>Draws the window as a learner sees it.</source>
        <translation>Dessine la fenêtre comme l’élève la voit.</translation>
    </message>
    <message>
        <source>The step to open.</source>
        <translation>L’étape à ouvrir.</translation>
    </message>
    <message>
        <source>The picture to write.</source>
        <translation>La capture à écrire.</translation>
    </message>
    <message>
        <source>Goes to frame N.</source>
        <translation>Va à l’image N.</translation>
    </message>
    <message>
        <source>Stops after P phases inside the next frame.</source>
        <translation>S’arrête après P phases dans l’image suivante.</translation>
    </message>
    <message>
        <source>learn or measure.</source>
        <translation>learn ou measure.</translation>
    </message>
    <message>
        <source>Shows where energy went.</source>
        <translation>Montre où est passée l’énergie.</translation>
    </message>
    <message>
        <source>Shows the cost of each effect.</source>
        <translation>Montre le coût de chaque effet.</translation>
    </message>
    <message>
        <source>Shows the plots.</source>
        <translation>Montre les graphiques.</translation>
    </message>
    <message>
        <source>gauge, reasons, or a map: step, damping or rest.</source>
        <translation>gauge, reasons, ou une carte&#xa0;: step, damping ou rest.</translation>
    </message>
    <message>
        <source>Makes a film of the run of an experiment: a WebM video, an animated GIF, a PNG for each frame, or a web page that plays it.</source>
        <translation>Fait un film de la simulation d’une expérience&#xa0;: une vidéo WebM, un GIF animé, un PNG par image, ou une page web qui la joue.</translation>
    </message>
    <message>
        <source>The film: OUT.webm, OUT.gif, OUT.html, or OUT_%04d.png, where %04d stands for the number of the frame with 4 digits, such as 0007. %d writes 7, and the files do not sort by name.</source>
        <translation>Le film&#xa0;: OUT.webm, OUT.gif, OUT.html ou OUT_%04d.png, où %04d représente le numéro de l’image en 4 chiffres, comme 0007. %d écrit 7&#x202f;; le nom ne trie alors pas les fichiers.</translation>
    </message>
    <message>
        <source>The first frame.</source>
        <translation>La première image.</translation>
    </message>
    <message>
        <source>The last frame (default: the file&apos;s number of frames).</source>
        <translation>La dernière image (par défaut&#xa0;: le nombre d’images du fichier).</translation>
    </message>
    <message>
        <source>Frames per second, up to 50 in a GIF and 120 otherwise (default 30). Not for PNG files.</source>
        <translation>Images par seconde, jusqu’à 50 dans un GIF et 120 sinon (par défaut 30). Pas pour les fichiers PNG.</translation>
    </message>
    <message>
        <source>Checks notebooks by replaying every run, makes a page of one, or writes your own. The exit code is 1 if a run does not show what its notebook says.</source>
        <translation>Vérifie des cahiers en rejouant chaque simulation, fait une page de l’un d’eux, ou écrit le tien. Le code de sortie est 1 si une simulation ne montre pas ce que dit son cahier.</translation>
    </message>
    <message>
        <source>check FILE..., page FILE OUT.html, page FILE OUT.pdf, or write OUT.springstep-notebook.</source>
        <translation>check FILE..., page FILE OUT.html, page FILE OUT.pdf ou write OUT.springstep-notebook.</translation>
    </message>
    <message>
        <source>Prints the result as CSV.</source>
        <translation>Affiche le résultat en CSV.</translation>
    </message>
    <message>
        <source>The name to write into the notebook.</source>
        <translation>Le nom à écrire dans le cahier.</translation>
    </message>
    <message>
        <source>The lessons to write (default: all).</source>
        <translation>Les leçons à écrire (par défaut&#xa0;: toutes).</translation>
    </message>
    <message>
        <source>Checks a lesson of your own, and plays the solution of each thing to try. The exit code is 1 if one fails.</source>
        <translation>Vérifie une leçon à toi, et joue la solution de chaque essai. Le code de sortie est 1 si l’une d’elles échoue.</translation>
    </message>
    <message>
        <source>The folder of the lesson, or its zip.</source>
        <translation>Le dossier de la leçon, ou son zip.</translation>
    </message>
    <message>
        <source>Writes a lesson on paper: its texts, pictures and questions with lines to write on. The answers follow on separate pages.</source>
        <translation>Écrit une leçon sur papier&#xa0;: ses textes, ses images et ses questions avec des lignes pour écrire. Les réponses suivent sur des pages à part.</translation>
    </message>
    <message>
        <source>A lesson, or the folder or the zip of one.</source>
        <translation>Une leçon, ou son dossier ou son zip.</translation>
    </message>
    <message>
        <source>The PDF to write.</source>
        <translation>Le PDF à écrire.</translation>
    </message>
    <message>
        <source>en, de, es or fr (default: that of the system).</source>
        <translation>en, de, es ou fr (par défaut&#xa0;: celle du système).</translation>
    </message>
    <message>
        <source>A plot on a web page, such as &quot;y(body)&quot;, &quot;energy&quot; or &quot;y(body):x(body)&quot;. Repeat it for more.</source>
        <translation>Un graphique sur une page web, comme &quot;y(body)&quot;, &quot;energy&quot; ou &quot;y(body):x(body)&quot;. À répéter pour en avoir plus.</translation>
    </message>
    <message>
        <source>The run in FILE that a web page shows as the ghost.</source>
        <translation>La simulation de FILE qu’une page web montre comme fantôme.</translation>
    </message>
    <message>
        <source>The notebooks, or the notebook and the page to write; and the lessons without C++ that they are about, as folders or zips.</source>
        <translation>Les cahiers, ou le cahier et la page à écrire&#x202f;; et les leçons sans C++ dont ils parlent, comme dossiers ou zips.</translation>
    </message>
</context>
<context>
    <name>ViewCommands</name>
    <message>
        <source>L&amp;earn</source>
        <translation>&amp;Apprendre</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Mesurer</translation>
    </message>
    <message>
        <source>&amp;Build</source>
        <translation>&amp;Construire</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>&amp;Zoom avant</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Zoom a&amp;rrière</translation>
    </message>
    <message>
        <source>&amp;Fit the scene</source>
        <translation>A&amp;juster la scène</translation>
    </message>
    <message>
        <source>Ne&amp;xt body outside</source>
        <translation>Corps suivant &amp;hors de vue</translation>
    </message>
    <message>
        <source>&amp;Lessons</source>
        <translation>&amp;Leçons</translation>
    </message>
    <message>
        <source>Lessons &amp;as a narrow strip</source>
        <translation>Leçons en &amp;bande étroite</translation>
    </message>
    <message>
        <source>&amp;Code and parameters</source>
        <translation>Code et &amp;paramètres</translation>
    </message>
    <message>
        <source>E&amp;nergy</source>
        <translation>É&amp;nergie</translation>
    </message>
    <message>
        <source>Effec&amp;ts</source>
        <translation>&amp;Effets</translation>
    </message>
    <message>
        <source>&amp;Plots</source>
        <translation>&amp;Graphiques</translation>
    </message>
    <message>
        <source>&amp;Stability of the step</source>
        <translation>&amp;Stabilité du pas de temps</translation>
    </message>
    <message>
        <source>Map of the time to rest</source>
        <translation>Carte du temps de stabilisation</translation>
    </message>
    <message>
        <source>How many frames the run takes to come to rest, for each stiffness and damping</source>
        <translation>Nombre d’images avant que la simulation s’immobilise, pour chaque raideur et chaque amortissement</translation>
    </message>
    <message>
        <source>&amp;Unlock: panels can be moved</source>
        <translation>&amp;Déverrouiller&#xa0;: panneaux déplaçables</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>S&amp;ombre</translation>
    </message>
    <message>
        <source>&amp;High contrast</source>
        <translation>Contraste éle&amp;vé</translation>
    </message>
    <message>
        <source>Less mo&amp;vement</source>
        <translation>Moins de mouvemen&amp;t</translation>
    </message>
    <message>
        <source>Scene onl&amp;y</source>
        <translation>Uni&amp;quement la scène</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>Ple&amp;in écran</translation>
    </message>
    <message>
        <source>Lessons, scene and code</source>
        <translation>Leçons, scène et code</translation>
    </message>
    <message>
        <source>The error and the cost of each method for this scene</source>
        <translation>L’erreur et le coût de chaque méthode pour cette scène</translation>
    </message>
    <message>
        <source>Build your own scene from points, springs, sticks and feet</source>
        <translation>Construire ta propre scène avec des points, des ressorts, des tiges et des pieds</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Ajuster</translation>
    </message>
    <message>
        <source>Show the whole scene with all bodies, and keep them in view</source>
        <translation>Afficher toute la scène avec tous les corps, et les garder dans la vue</translation>
    </message>
    <message>
        <source>Bring a body that is outside the picture into view</source>
        <translation>Ramener dans la vue un corps qui en est sorti</translation>
    </message>
    <message>
        <source>Show only the symbols of the lessons, to save space</source>
        <translation>N’afficher que les symboles des leçons, pour gagner de la place</translation>
    </message>
    <message>
        <source>Where energy and momentum went</source>
        <translation>Où sont passées l’énergie et la quantité de mouvement</translation>
    </message>
    <message>
        <source>The cost of each effect in the scene, with a switch for each</source>
        <translation>Le coût de chaque effet de la scène, avec un interrupteur pour chacun</translation>
    </message>
    <message>
        <source>Curves of any quantity of any body</source>
        <translation>Courbes de toute grandeur de tout corps</translation>
    </message>
    <message>
        <source>Drag a panel by its title to another place</source>
        <translation>Faire glisser un panneau par son titre vers un autre endroit</translation>
    </message>
    <message>
        <source>Moves the panels back to their original places, in this mode only</source>
        <translation>Remet les panneaux à leur place d’origine, dans ce mode seulement</translation>
    </message>
    <message>
        <source>Panels and menus open without animation, and wind is drawn as a still picture. Only the simulation moves</source>
        <translation>Les panneaux et les menus s’ouvrent sans animation, et le vent est dessiné fixe. Seule la simulation bouge</translation>
    </message>
    <message>
        <source>Show only the scene and its timeline. Press again to bring the panels back</source>
        <translation>N’afficher que la scène et sa ligne de temps. Un nouvel appui ramène les panneaux</translation>
    </message>
    <message>
        <source>&amp;Reset</source>
        <translation>&amp;Réinitialiser</translation>
    </message>
    <message>
        <source>Unit circle</source>
        <translation>Cercle trigonométrique</translation>
    </message>
    <message>
        <source>Show the angle of an arrow, its cosine and its sine on a circle</source>
        <translation>Montre l’angle d’une flèche, son cosinus et son sinus sur un cercle</translation>
    </message>
</context>
<context>
    <name>WebPageCliText</name>
    <message>
        <source>--%1 is for films; a web page has the size and the colours of its reader&apos;s browser. Leave it out.</source>
        <translation>--%1 est pour les films&#x202f;; une page web a la taille et les couleurs du navigateur qui l’affiche. Enlève cette option.</translation>
    </message>
    <message>
        <source>--plot is %1; it can be %2, with its bodies, as in %3 and %4.</source>
        <translation>--plot est %1&#x202f;; valeurs possibles&#xa0;: %2, avec leurs corps, comme dans %3 et %4.</translation>
    </message>
    <message>
        <source>--plot is %1, but there is no %2; there is %3.</source>
        <translation>--plot est %1, mais il n’y a pas %2&#x202f;; il y a %3.</translation>
    </message>
    <message>
        <source>--plot is %1, which has no value in this scene. Choose another one.</source>
        <translation>--plot est %1, qui n’a pas de valeur dans cette scène. Choisis autre chose.</translation>
    </message>
    <message>
        <source>--plot is given %1 times; a web page has room for %2 plots.</source>
        <translation>--plot est donné %1 fois&#x202f;; une page web a de la place pour %2 graphiques.</translation>
    </message>
    <message>
        <source>--ghost is %1, but FILE has no other run. Keep one in the window.</source>
        <translation>--ghost est %1, mais FILE n’a pas d’autre simulation. Gardes-en une dans la fenêtre.</translation>
    </message>
    <message>
        <source>--ghost is %1; it can be %2.</source>
        <translation>--ghost est %1&#x202f;; valeurs possibles&#xa0;: %2.</translation>
    </message>
</context>
<context>
    <name>WebPageText</name>
    <message>
        <source>A web page has room for %1 frames of this scene, and this would be %2. Choose fewer frames.</source>
        <translation>Une page web peut contenir %1 images de cette scène, et il y en aurait %2. Choisis moins d’images.</translation>
    </message>
    <message>
        <source>The last frame, %1, comes before the first, %2. Swap them.</source>
        <translation>La dernière image, %1, vient avant la première, %2. Échange-les.</translation>
    </message>
    <message>
        <source>The bodies of %1 frames do not fit on a web page. Choose fewer frames.</source>
        <translation>Les corps de %1 images ne tiennent pas dans une page web. Choisis moins d’images.</translation>
    </message>
    <message>
        <source>The run does not reach frame %1: it stops at frame %2. Begin the page earlier.</source>
        <translation>La simulation n’atteint pas l’image %1&#xa0;: elle s’arrête à l’image %2. Fais commencer la page plus tôt.</translation>
    </message>
</context>
<context>
    <name>WebPageWords</name>
    <message>
        <source>Play</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Une image en arrière</translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation>Une image en avant</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Au début</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Image %1 sur %2</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>Zoom in</source>
        <translation>Zoom avant</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Zoom arrière</translation>
    </message>
    <message>
        <source>Fit the scene</source>
        <translation>Ajuster la scène</translation>
    </message>
    <message>
        <source>Trails</source>
        <translation>Traces</translation>
    </message>
    <message>
        <source>Light colours</source>
        <translation>Couleurs claires</translation>
    </message>
    <message>
        <source>Dark colours</source>
        <translation>Couleurs sombres</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>%1 at (%2, %3)</source>
        <translation>%1 en (%2, %3)</translation>
    </message>
    <message>
        <source>About this step</source>
        <translation>À propos de cette étape</translation>
    </message>
    <message>
        <source>Listing</source>
        <translation>Listing</translation>
    </message>
    <message>
        <source>Beside each line: the values that this frame has set</source>
        <translation>À côté de chaque ligne&#xa0;: les valeurs que cette image a fixées</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>time, frames</source>
        <translation>temps, images</translation>
    </message>
    <message>
        <source>no value</source>
        <translation>pas de valeur</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Touches et souris</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Espace</translation>
    </message>
    <message>
        <source>Left, Right</source>
        <translation>Gauche, Droite</translation>
    </message>
    <message>
        <source>Home, End</source>
        <translation>Début, Fin</translation>
    </message>
    <message>
        <source>Shift with arrows, or drag</source>
        <translation>Maj avec les flèches, ou glisser</translation>
    </message>
    <message>
        <source>Mouse wheel</source>
        <translation>Molette</translation>
    </message>
    <message>
        <source>play or pause</source>
        <translation>lecture ou pause</translation>
    </message>
    <message>
        <source>one frame back or forward; with Ctrl, ten</source>
        <translation>une image en arrière ou en avant&#x202f;; avec Ctrl, dix</translation>
    </message>
    <message>
        <source>first or last frame</source>
        <translation>première ou dernière image</translation>
    </message>
    <message>
        <source>move the view</source>
        <translation>déplacer la vue</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>zoom</translation>
    </message>
    <message>
        <source>light or dark colours</source>
        <translation>couleurs claires ou sombres</translation>
    </message>
    <message>
        <source>Made with Springstep</source>
        <translation>Créé avec Springstep</translation>
    </message>
    <message>
        <source>The run needs JavaScript. Allow it in this browser, and load the page again.</source>
        <translation>La simulation a besoin de JavaScript. Autorise-le dans ce navigateur, et recharge la page.</translation>
    </message>
    <message>
        <source>This browser is too old to show the run. Use one from 2023 or later.</source>
        <translation>Ce navigateur est trop ancien pour montrer la simulation. Prends-en un de 2023 ou plus récent.</translation>
    </message>
    <message>
        <source>The run on this page cannot be read: the file is damaged. Ask for it again.</source>
        <translation>La simulation de cette page est illisible&#xa0;: le fichier est endommagé. Redemande-le.</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>Choose what the scene shows</source>
        <translation>Choisir ce que la scène montre</translation>
    </message>
    <message>
        <source>Velocity arrows</source>
        <translation>Flèches de vitesse</translation>
    </message>
    <message>
        <source>Onion skins</source>
        <translation>Pelures d’oignon</translation>
    </message>
    <message>
        <source>Ghost</source>
        <translation>Fantôme</translation>
    </message>
    <message>
        <source>Guide lines</source>
        <translation>Lignes de repère</translation>
    </message>
    <message>
        <source>Legend</source>
        <translation>Légende</translation>
    </message>
</context>
<context>
    <name>WholeFileText</name>
    <message>
        <source>%1: the file could not be written: %2. Choose another folder or name.</source>
        <translation>%1&#xa0;: impossible d’écrire le fichier&#xa0;: %2. Choisis un autre dossier ou un autre nom.</translation>
    </message>
    <message>
        <source>%1: there is no such file; check its name and folder.</source>
        <translation>%1&#xa0;: ce fichier n’existe pas&#x202f;; vérifie son nom et son dossier.</translation>
    </message>
    <message>
        <source>%1: the file could not be read: %2.</source>
        <translation>%1&#xa0;: le fichier n’a pas pu être lu&#xa0;: %2.</translation>
    </message>
    <message>
        <source>%1: this is a folder; give a file.</source>
        <translation>%1&#xa0;: c’est un dossier&#x202f;; donne un fichier.</translation>
    </message>
    <message>
        <source>%1: the file is larger than %2 MiB, the maximum.</source>
        <translation>%1&#xa0;: le fichier dépasse %2 Mio, le maximum.</translation>
    </message>
</context>
<context>
    <name>ZipText</name>
    <message>
        <source>the zip is damaged. Get it again, or make a new zip of the folder.</source>
        <translation>le zip est endommagé. Récupère-le à nouveau, ou refais un zip du dossier.</translation>
    </message>
    <message>
        <source>this is not a zip, or its end is missing. Choose the lesson.json or the zip of a lesson, or get the zip again.</source>
        <translation>ce n’est pas un zip, ou il manque sa fin. Choisis le lesson.json ou le zip d’une leçon, ou récupère à nouveau le zip.</translation>
    </message>
    <message>
        <source>%1 is in a folder. All files of a lesson are side by side.</source>
        <translation>%1 est dans un dossier. Tous les fichiers d’une leçon sont côte à côte.</translation>
    </message>
    <message>
        <source>%1 is there twice. Make a new zip of the folder.</source>
        <translation>%1 y est deux fois. Refais un zip du dossier.</translation>
    </message>
    <message>
        <source>the zip has several parts, or is too large for a lesson.</source>
        <translation>le zip est en plusieurs parties, ou trop gros pour une leçon.</translation>
    </message>
    <message>
        <source>the zip has more than %1 files.</source>
        <translation>le zip a plus de %1 fichiers.</translation>
    </message>
    <message>
        <source>the files are larger than %1 MiB together.</source>
        <translation>ensemble, les fichiers dépassent %1 Mio.</translation>
    </message>
    <message>
        <source>the name of a file is not UTF-8. Give it a name without accents.</source>
        <translation>le nom d’un fichier n’est pas en UTF-8. Donne-lui un nom sans accents.</translation>
    </message>
    <message>
        <source>%1 leads out of the lesson. This zip is not safe; nothing was read.</source>
        <translation>%1 mène hors de la leçon. Ce zip n’est pas sûr&#x202f;; rien n’a été lu.</translation>
    </message>
    <message>
        <source>%1 is a link. Put the file itself into the zip.</source>
        <translation>%1 est un lien. Mets le fichier lui-même dans le zip.</translation>
    </message>
    <message>
        <source>%1 has a password. Make a zip without one.</source>
        <translation>%1 a un mot de passe. Fais un zip sans mot de passe.</translation>
    </message>
    <message>
        <source>%1 is compressed by a method that this program cannot read. Save it as an ordinary zip file.</source>
        <translation>%1 est compressé d’une façon que ce programme ne sait pas lire. Fais un zip ordinaire.</translation>
    </message>
    <message>
        <source>%1 is larger than %2 MiB.</source>
        <translation>%1 dépasse %2 Mio.</translation>
    </message>
    <message>
        <source>the zip is empty.</source>
        <translation>le zip est vide.</translation>
    </message>
    <message>
        <source>%1 is larger than the zip says. This zip is not safe; nothing was read.</source>
        <translation>%1 est plus gros que ce que dit le zip. Ce zip n’est pas sûr&#x202f;; rien n’a été lu.</translation>
    </message>
    <message>
        <source>%1 is packed as ZIP64, which is for very large files. Save it as an ordinary zip file.</source>
        <translation>%1 est compressé en ZIP64, un format pour de très gros fichiers. Fais un zip ordinaire.</translation>
    </message>
</context>
<context>
    <name>app::AboutPage</name>
    <message>
        <source>windows and files</source>
        <translation>fenêtres et fichiers</translation>
    </message>
    <message>
        <source>plots</source>
        <translation>graphiques</translation>
    </message>
    <message>
        <source>the code panel</source>
        <translation>panneau du code</translation>
    </message>
    <message>
        <source>arrays of numbers</source>
        <translation>tableaux de nombres</translation>
    </message>
    <message>
        <source>reading experiments</source>
        <translation>lecture des expériences</translation>
    </message>
    <message>
        <source>films as GIF</source>
        <translation>films en GIF</translation>
    </message>
    <message>
        <source>running your code</source>
        <translation>exécution de ton code</translation>
    </message>
    <message>
        <source>films as video</source>
        <translation>films en vidéo</translation>
    </message>
    <message>
        <source>experiments as short text</source>
        <translation>expériences en texte court</translation>
    </message>
    <message>
        <source>typeface of the window</source>
        <translation>police de la fenêtre</translation>
    </message>
    <message>
        <source>typeface of code and numbers</source>
        <translation>police du code et des nombres</translation>
    </message>
    <message>
        <source>About Springstep</source>
        <translation>À propos de Springstep</translation>
    </message>
    <message>
        <source>Version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>Teaches physically based animation step by step, from one spring to creatures that walk.</source>
        <translation>Enseigne l’animation physique étape par étape, d’un seul ressort à des créatures qui marchent.</translation>
    </message>
    <message>
        <source>You may use, change and share it under the &lt;a href=&quot;%1&quot;&gt;GNU General Public License, version 3&lt;/a&gt;. It comes without any warranty.</source>
        <translation>Tu peux l’utiliser, le modifier et le partager selon la &lt;a href=&quot;%1&quot;&gt;licence publique générale GNU, version 3&lt;/a&gt;. Il est fourni sans aucune garantie.</translation>
    </message>
    <message>
        <source>Built with</source>
        <translation>Réalisé avec</translation>
    </message>
    <message>
        <source>%1: %2. Licence: %3</source>
        <translation>%1&#xa0;: %2. Licence&#xa0;: %3</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>Fermer cette page (Échap)</translation>
    </message>
</context>
<context>
    <name>app::AccuracyPanel</name>
    <message>
        <source>Accuracy</source>
        <translation>Précision</translation>
    </message>
    <message>
        <source>Error against time</source>
        <translation>Erreur et durée</translation>
    </message>
    <message>
        <source>The error of each method, and its cost</source>
        <translation>L’erreur de chaque méthode, et son coût</translation>
    </message>
    <message>
        <source>Over the run</source>
        <translation>Évolution</translation>
    </message>
    <message>
        <source>How the error grows, at about the cost of your method</source>
        <translation>Comment l’erreur grandit, à peu près au coût de ta méthode</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>How fast the error shrinks when the step does</source>
        <translation>À quelle vitesse l’erreur diminue avec le pas de temps</translation>
    </message>
    <message>
        <source>Progress of the measurement</source>
        <translation>Progression de la mesure</translation>
    </message>
    <message>
        <source>Use it</source>
        <translation>Utiliser</translation>
    </message>
    <message>
        <source>first %1 frames of %2</source>
        <translation>les %1 premières images sur %2</translation>
    </message>
    <message>
        <source>%1 frames, %2 methods</source>
        <translation>%1 images, %2 méthodes</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Remesurer</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Mesurer</translation>
    </message>
    <message>
        <source>Cancel; the results so far stay</source>
        <translation>Annuler&#x202f;; les résultats obtenus restent</translation>
    </message>
    <message>
        <source>Compute the scene with every method, and time it</source>
        <translation>Calculer la scène avec chaque méthode, et la chronométrer</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Mesure en cours…</translation>
    </message>
    <message>
        <source>Times are medians of repeated, interleaved runs; whiskers show their spread.</source>
        <translation>Les durées sont les médianes de simulations répétées et alternées&#x202f;; les traits montrent leur dispersion.</translation>
    </message>
    <message>
        <source>Cancelled. The results so far are shown.</source>
        <translation>Annulé. Les résultats obtenus jusque-là sont affichés.</translation>
    </message>
    <message>
        <source>The scene has changed. Measuring starts when you stop changing it.</source>
        <translation>La scène a changé. La mesure commencera quand tu cesseras de la modifier.</translation>
    </message>
    <message>
        <source>Not measured yet.</source>
        <translation>Pas encore mesuré.</translation>
    </message>
    <message>
        <source>How accurate is each method for this scene, and what does it cost? Every method computes it with many steps, and is compared with a far more accurate reference.</source>
        <translation>Quelle est la précision de chaque méthode pour cette scène, et combien coûte-t-elle&#x202f;? Chaque méthode la calcule avec beaucoup de pas de temps, puis est comparée à une référence bien plus précise.</translation>
    </message>
    <message>
        <source>Use %1</source>
        <translation>Utiliser %1</translation>
    </message>
    <message>
        <source>%1 frames, %2 of %3 methods</source>
        <translation>%1 images, méthodes&#xa0;: %2 sur %3</translation>
    </message>
    <message>
        <source>Show fewer methods</source>
        <translation>Afficher moins de méthodes</translation>
    </message>
    <message>
        <source>Show all methods</source>
        <translation>Afficher toutes les méthodes</translation>
    </message>
    <message>
        <source>Only the method of this step, and the two most useful to compare it with</source>
        <translation>Seulement la méthode de cette étape, et les deux plus utiles à lui comparer</translation>
    </message>
    <message>
        <source>All measured methods, with two more plots and with remarks</source>
        <translation>Toutes les méthodes mesurées, avec deux autres graphiques et des remarques</translation>
    </message>
</context>
<context>
    <name>app::AccuracyStudy</name>
    <message>
        <source>Your code is left out: it computes whole frames, so it cannot be compared with shorter steps.</source>
        <translation>Ton code n’y est pas&#xa0;: il calcule des images entières, et ne peut donc pas être comparé à des pas de temps plus courts.</translation>
    </message>
</context>
<context>
    <name>app::Appearance</name>
    <message>
        <source>This step shows no angle.</source>
        <translation>Cette étape ne montre pas d’angle.</translation>
    </message>
</context>
<context>
    <name>app::ArrangeMenu</name>
    <message>
        <source>A&amp;rrange panels</source>
        <translation>&amp;Déplacer les panneaux</translation>
    </message>
    <message>
        <source>to the &amp;left</source>
        <translation>à &amp;gauche</translation>
    </message>
    <message>
        <source>to the &amp;right</source>
        <translation>à &amp;droite</translation>
    </message>
    <message>
        <source>&amp;below the picture</source>
        <translation>&amp;sous la vue</translation>
    </message>
    <message>
        <source>Drag this panel to its new place</source>
        <translation>Fais glisser ce panneau vers sa nouvelle place</translation>
    </message>
</context>
<context>
    <name>app::Attempts</name>
    <message>
        <source>stop here: press **Space**.</source>
        <translation>arrête ici&#xa0;: appuie sur **Espace**.</translation>
    </message>
    <message>
        <source>the error is too large, or a frame takes too long. Try another method or step.</source>
        <translation>l’erreur est trop grande, ou une image prend trop de temps. Essaie une autre méthode ou un autre pas de temps.</translation>
    </message>
    <message>
        <source>this run was set up for you. Undo brings your own run back: do it there.</source>
        <translation>cette simulation a été préparée par Springstep. Annuler ramène ta propre simulation&#xa0;: fais-le là.</translation>
    </message>
    <message>
        <source>your code computes this run, and it has no phases. Press **Reset listing** on the page **Listing**. Undo brings your code back.</source>
        <translation>ton code calcule cette simulation, et il n’a pas de phases. Sur la page **Listing**, appuie sur **Rétablir le listing**. Annuler ramène ton code.</translation>
    </message>
    <message>
        <source>your code computes this run, in steps of 1 frame. Press **Reset listing** on the page **Listing**, then choose the step. Undo brings your code back.</source>
        <translation>ton code calcule cette simulation, avec des pas de 1 image. Sur la page **Listing**, appuie sur **Rétablir le listing**, puis choisis le pas. Annuler ramène ton code.</translation>
    </message>
</context>
<context>
    <name>app::Autosave</name>
    <message>
        <source>the folder %1 could not be created</source>
        <translation>le dossier %1 n’a pas pu être créé</translation>
    </message>
    <message>
        <source>a file in %1 could not be locked</source>
        <translation>un fichier de %1 n’a pas pu être verrouillé</translation>
    </message>
    <message>
        <source>Could not save a backup of your work: %1. Free some disk space, or save it as a file.</source>
        <translation>Impossible de sauvegarder ton travail&#xa0;: %1. Libère de l’espace disque, ou enregistre-le dans un fichier.</translation>
    </message>
</context>
<context>
    <name>app::BranchesPanel</name>
    <message>
        <source>Two runs</source>
        <translation>Deux simulations</translation>
    </message>
    <message>
        <source>Largest distance</source>
        <translation>Plus grand écart</translation>
    </message>
    <message>
        <source>In each frame, the body that is farthest from its place in the other run</source>
        <translation>Dans chaque image, le corps le plus éloigné de sa place dans l’autre simulation</translation>
    </message>
    <message>
        <source>Only the body that is selected in the picture</source>
        <translation>Seulement le corps sélectionné dans la vue</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>Simulations</translation>
    </message>
    <message>
        <source>Choose the run to compare with, keep, name and delete runs</source>
        <translation>Choisir la simulation à comparer&#x202f;; garder, nommer et supprimer des simulations</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Y aller</translation>
    </message>
    <message>
        <source>Go to the frame with the largest difference</source>
        <translation>Aller à l’image où la différence est la plus grande</translation>
    </message>
    <message>
        <source>this one and “%1”</source>
        <translation>celle-ci et «&#x202f;%1&#x202f;»</translation>
    </message>
</context>
<context>
    <name>app::BreakpointList</name>
    <message>
        <source>when</source>
        <translation>quand</translation>
    </message>
    <message>
        <source>Stop when</source>
        <translation>Arrêter quand</translation>
    </message>
    <message>
        <source>Stops the run as soon as this is true, even inside a frame.
You can use x, y, vx, vy of bodies, frame, phase, and all parameters;
+ - * / ( ), &lt; &lt;= &gt; &gt;= == !=, and, or, not, abs(), sqrt(), distance(a, b), speed(a), still(a), held(a), released(a).
Press Enter to add it.</source>
        <translation>Arrête la simulation dès que c’est vrai, même au milieu d’une image.
Tu peux utiliser x, y, vx, vy des corps, frame, phase et tous les paramètres&#x202f;;
+ - * / ( ), &lt; &lt;= &gt; &gt;= == !=, and, or, not, abs(), sqrt(), distance(a, b), speed(a), still(a), held(a), released(a).
Appuie sur Entrée pour l’ajouter.</translation>
    </message>
    <message>
        <source>always, or when…</source>
        <translation>toujours, ou quand…</translation>
    </message>
    <message>
        <source>Condition of breakpoint %1</source>
        <translation>Condition du point d’arrêt %1</translation>
    </message>
    <message>
        <source>Stops before this line&apos;s phase if this is true. Press Enter to apply.</source>
        <translation>Arrête avant la phase de cette ligne si c’est vrai. Appuie sur Entrée pour appliquer.</translation>
    </message>
    <message>
        <source>Stops when this becomes true. Press Enter to apply.</source>
        <translation>Arrête quand cela devient vrai. Appuie sur Entrée pour appliquer.</translation>
    </message>
    <message>
        <source>Stop before this line (%1)</source>
        <translation>Arrêter avant cette ligne (%1)</translation>
    </message>
    <message>
        <source>Stop when this becomes true</source>
        <translation>Arrêter quand cela devient vrai</translation>
    </message>
    <message>
        <source>Breakpoint %1 %2</source>
        <translation>Point d’arrêt %1 %2</translation>
    </message>
    <message>
        <source>Remove this breakpoint</source>
        <translation>Supprimer ce point d’arrêt</translation>
    </message>
    <message>
        <source>Remove the breakpoint %1 %2</source>
        <translation>Supprimer le point d’arrêt %1 %2</translation>
    </message>
    <message>
        <source>Stop when… (%1.y &gt; 300)</source>
        <translation>Arrêter quand… (%1.y &gt; 300)</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>Stop before this line of the listing</source>
        <translation>Arrêter avant cette ligne du listing</translation>
    </message>
    <message>
        <source>Stops before this line if this is true. Press Enter to apply.</source>
        <translation>Arrête avant cette ligne si c’est vrai. Appuie sur Entrée pour appliquer.</translation>
    </message>
</context>
<context>
    <name>app::BuildGuide</name>
    <message>
        <source>The point in the picture is the body of your creature. Press Foot (F) to give it feet.</source>
        <translation>Le point dans la vue est le corps de ta créature. Appuie sur Pied (F) pour lui donner des pieds.</translation>
    </message>
    <message>
        <source>Click the body.</source>
        <translation>Clique sur le corps.</translation>
    </message>
    <message>
        <source>Click the cross on the left: the first foot.</source>
        <translation>Clique sur la croix de gauche&#xa0;: le premier pied.</translation>
    </message>
    <message>
        <source>Click the cross on the right. Opposite feet need opposite angles: one 0°, the other 180°.</source>
        <translation>Clique sur la croix de droite. Des pieds opposés ont besoin d’angles opposés&#xa0;: l’un 0°, l’autre 180°.</translation>
    </message>
    <message>
        <source>Two feet must be opposite each other. Click the cross on the right.</source>
        <translation>Deux pieds doivent être l’un en face de l’autre. Clique sur la croix de droite.</translation>
    </message>
    <message>
        <source>Now set the numbers of the feet. Press Select (V).</source>
        <translation>Passe aux nombres des pieds. Appuie sur Sélection (V).</translation>
    </message>
    <message>
        <source>Click one of the feet.</source>
        <translation>Clique sur l’un des pieds.</translation>
    </message>
    <message>
        <source>Swing makes it walk: it turns the legs. Type 0.05 into the field Swing, and press Return.</source>
        <translation>Élan la fait marcher&#xa0;: il fait tourner les pattes. Tape 0,05 dans le champ Élan, et appuie sur Entrée.</translation>
    </message>
    <message>
        <source>Feet need something to push against. Switch Ground on.</source>
        <translation>Les pieds ont besoin d’un appui pour pousser. Active Sol.</translation>
    </message>
    <message>
        <source>Switch Walls off, so that nothing is in the way.</source>
        <translation>Désactive Murs, pour que rien ne gêne.</translation>
    </message>
    <message>
        <source>Press Play (Space).</source>
        <translation>Appuie sur Lecture (Espace).</translation>
    </message>
    <message>
        <source>Watch it: it lands, and then its feet push it along.</source>
        <translation>Regarde-la&#xa0;: elle atterrit, puis ses pieds la poussent en avant.</translation>
    </message>
    <message>
        <source>It does not walk yet. Press Home, and make Swing 0.05.</source>
        <translation>Elle ne marche pas encore. Appuie sur Début, et mets Élan à 0,05.</translation>
    </message>
    <message>
        <source>It walks! Press Home to change it: another Swing, a third foot, or a heavier body.</source>
        <translation>Elle marche&#x202f;! Appuie sur Début pour la modifier&#xa0;: un autre Élan, un troisième pied ou un corps plus lourd.</translation>
    </message>
</context>
<context>
    <name>app::BuildPanel</name>
    <message>
        <source>Build</source>
        <translation>Construire</translation>
    </message>
    <message>
        <source>Go to the start</source>
        <translation>Aller au début</translation>
    </message>
    <message>
        <source>Go to frame 0, where the scene can be changed</source>
        <translation>Aller à l’image 0, où la scène peut être modifiée</translation>
    </message>
    <message>
        <source>Effects on everything</source>
        <translation>Effets sur tout</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>Exemples</translation>
    </message>
    <message>
        <source>Scenes to start from. Undo brings yours back</source>
        <translation>Des scènes pour commencer. Annuler ramène la tienne</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Nouvelle</translation>
    </message>
    <message>
        <source>A scene with one point. Undo brings yours back</source>
        <translation>Une scène avec un point. Annuler ramène la tienne</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Leçons</translation>
    </message>
    <message>
        <source>Back to the lessons; your scene stays here</source>
        <translation>Retour aux leçons&#x202f;; ta scène reste ici</translation>
    </message>
    <message>
        <source>points %1, links %2</source>
        <translation>points %1, liens %2</translation>
    </message>
    <message>
        <source>The scene is playing. You can only build at the start of the run.</source>
        <translation>La scène est en lecture. Tu ne peux construire qu’au début de la simulation.</translation>
    </message>
    <message>
        <source>You are at frame %1. You can only build at the start of the run.</source>
        <translation>Tu es à l’image %1. Tu ne peux construire qu’au début de la simulation.</translation>
    </message>
    <message>
        <source>Click where you want a point.</source>
        <translation>Clique où tu veux un point.</translation>
    </message>
    <message>
        <source>Click a point to nail it down or to free it, or click where you want a nail.</source>
        <translation>Clique sur un point pour le clouer ou le libérer, ou clique où tu veux un clou.</translation>
    </message>
    <message>
        <source>Click a part to select it, drag it to move it, or draw a box around several.</source>
        <translation>Clique sur un élément pour le sélectionner, fais-le glisser pour le déplacer, ou trace un cadre autour de plusieurs.</translation>
    </message>
    <message>
        <source>New gait group</source>
        <translation>Nouveau groupe d’allure</translation>
    </message>
    <message>
        <source>Gives this foot its own gait group, with its own clock</source>
        <translation>Donne à ce pied son propre groupe d’allure, avec sa propre horloge</translation>
    </message>
    <message>
        <source>Click where it ends; the next one starts there. Esc: start somewhere else.</source>
        <translation>Clique où elle finit&#x202f;; la suivante part de là. Échap&#xa0;: commencer ailleurs.</translation>
    </message>
    <message>
        <source>Click each of its feet, or where you want one. Esc: another body.</source>
        <translation>Clique sur chacun de ses pieds, ou là où tu en veux un. Échap&#xa0;: un autre corps.</translation>
    </message>
    <message>
        <source>Click a body, then each of its feet, or where you want one.</source>
        <translation>Clique sur un corps, puis sur chacun de ses pieds, ou là où tu en veux un.</translation>
    </message>
    <message>
        <source>First build: a walker</source>
        <translation>Guide&#xa0;: un marcheur</translation>
    </message>
    <message>
        <source>Build a creature that walks, in ten clicks. It starts with a new scene. Undo brings yours back</source>
        <translation>Construis une créature qui marche, en dix clics. Cela commence par une nouvelle scène. Annuler ramène la tienne</translation>
    </message>
    <message>
        <source>Drag from point to point to make one spring. With clicks, each spring starts where the last one ends.</source>
        <translation>Fais glisser d’un point à l’autre pour faire un ressort. Avec des clics, chaque ressort part de la fin du précédent.</translation>
    </message>
    <message>
        <source>Drag from point to point to make one stick. With clicks, each stick starts where the last one ends.</source>
        <translation>Fais glisser d’un point à l’autre pour faire une tige. Avec des clics, chaque tige part de la fin de la précédente.</translation>
    </message>
    <message>
        <source>On the ground, Swing makes it walk. Opposite feet need opposite angles: 0° and 180°.</source>
        <translation>Sur le sol, Élan la fait marcher. Des pieds opposés ont besoin d’angles opposés&#xa0;: 0° et 180°.</translation>
    </message>
    <message>
        <source>Drag from point to point to make one rule link, along which pull of your rule acts. With clicks, each link starts where the last one ends.</source>
        <translation>Fais glisser d’un point à l’autre pour faire une liaison de règle, le long de laquelle agit la fonction pull de ta règle. Avec des clics, chaque liaison part de la fin de la précédente.</translation>
    </message>
    <message>
        <source>A rule link has no settings: pull of your rule acts on both of its ends.</source>
        <translation>Une liaison de règle n’a pas de réglages&#xa0;: la fonction pull de ta règle agit sur ses deux bouts.</translation>
    </message>
</context>
<context>
    <name>app::ChoiceRow</name>
    <message>
        <source>Choose this answer (Space)</source>
        <translation>Choisir cette réponse (Espace)</translation>
    </message>
    <message>
        <source>%1, right</source>
        <translation>%1, juste</translation>
    </message>
    <message>
        <source>%1, wrong</source>
        <translation>%1, faux</translation>
    </message>
</context>
<context>
    <name>app::CodeCard</name>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1&#xa0;: %2. %3</translation>
    </message>
    <message>
        <source>Drag it sideways, or double-click it to type.</source>
        <translation>Fais-le glisser de côté, ou double-clique dessus pour taper.</translation>
    </message>
    <message>
        <source>x solid, y dashed</source>
        <translation>x continu, y en tirets</translation>
    </message>
</context>
<context>
    <name>app::CodePages</name>
    <message>
        <source>Let the listing compute the run from here</source>
        <translation>Faire calculer la simulation par le listing à partir d’ici</translation>
    </message>
    <message>
        <source>Listing</source>
        <translation>Listing</translation>
    </message>
    <message>
        <source>The program of a frame, to read, to step through and to change</source>
        <translation>Le programme d’une image&#xa0;: à lire, à parcourir et à modifier</translation>
    </message>
    <message>
        <source>Engine</source>
        <translation>Moteur physique</translation>
    </message>
    <message>
        <source>The code of Springstep that computes the run</source>
        <translation>Le code de Springstep qui calcule la simulation</translation>
    </message>
    <message>
        <source>%1 computes this run, not the listing.</source>
        <translation>%1 calcule cette simulation, pas le listing.</translation>
    </message>
    <message>
        <source>Use your code</source>
        <translation>Utiliser ton code</translation>
    </message>
    <message>
        <source>Use the listing</source>
        <translation>Utiliser le listing</translation>
    </message>
    <message>
        <source>My rule</source>
        <translation>Ma règle</translation>
    </message>
    <message>
        <source>A force that you write, for this scene</source>
        <translation>Une force que tu écris, pour cette scène</translation>
    </message>
</context>
<context>
    <name>app::CodePanel</name>
    <message>
        <source>Lines that are new in this step. Click to go through them.</source>
        <translation>Les lignes nouvelles de cette étape. Clique pour les parcourir.</translation>
    </message>
    <message>
        <source>Copy the shown code, with its files&apos; names</source>
        <translation>Copier le code affiché, avec les noms de ses fichiers</translation>
    </message>
    <message>
        <source>Copy the code</source>
        <translation>Copier le code</translation>
    </message>
    <message>
        <source>Copied the code.</source>
        <translation>Code copié.</translation>
    </message>
    <message>
        <source>values of %1</source>
        <translation>valeurs&#xa0;: %1</translation>
    </message>
    <message>
        <source>values of the %1</source>
        <translation>valeurs&#xa0;: %1</translation>
    </message>
    <message>
        <source>1 line new</source>
        <translation>1 nouvelle</translation>
    </message>
    <message>
        <source>%1 lines new</source>
        <translation>%1 nouvelles</translation>
    </message>
    <message>
        <source>%1 Press Enter to apply, Esc to cancel.</source>
        <translation>%1 Entrée applique, Échap annule.</translation>
    </message>
    <message>
        <source>“%1” has no known value.</source>
        <translation>«&#x202f;%1&#x202f;» n’a pas de valeur connue.</translation>
    </message>
    <message>
        <source>Of %1, in “%2”.</source>
        <translation>De %1, dans «&#x202f;%2&#x202f;».</translation>
    </message>
    <message>
        <source>none yet</source>
        <translation>pas encore</translation>
    </message>
    <message>
        <source>This line sets the scene up, before the first frame. Choose a line of a phase to stop at.</source>
        <translation>Cette ligne met la scène en place, avant la première image. Choisis une ligne d’une phase pour t’y arrêter.</translation>
    </message>
    <message>
        <source>This line says in which order phases run. Choose a line of a phase to stop at.</source>
        <translation>Cette ligne dit dans quel ordre les phases s’exécutent. Choisis une ligne d’une phase pour t’y arrêter.</translation>
    </message>
    <message>
        <source>%1, line %2</source>
        <translation>%1, ligne %2</translation>
    </message>
    <message>
        <source>Stops before %1.</source>
        <translation>Arrête avant %1.</translation>
    </message>
    <message>
        <source>No longer stops before %1.</source>
        <translation>N’arrête plus avant %1.</translation>
    </message>
    <message>
        <source>This line sets the scene up, before the first frame. Click a line of a phase to run to it.</source>
        <translation>Cette ligne met la scène en place, avant la première image. Clique sur une ligne d’une phase pour aller jusqu’à elle.</translation>
    </message>
    <message>
        <source>This line says in which order phases run. Click a line of a phase to run to it.</source>
        <translation>Cette ligne dit dans quel ordre les phases s’exécutent. Clique sur une ligne d’une phase pour aller jusqu’à elle.</translation>
    </message>
    <message>
        <source>Run to here</source>
        <translation>Aller jusqu’ici</translation>
    </message>
    <message>
        <source>Remove breakpoint</source>
        <translation>Supprimer le point d’arrêt</translation>
    </message>
    <message>
        <source>Set breakpoint</source>
        <translation>Placer un point d’arrêt</translation>
    </message>
    <message>
        <source>Set breakpoint when…</source>
        <translation>Point d’arrêt quand…</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy “%1”</source>
        <translation>Copier «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Copy all shown code</source>
        <translation>Copier tout le code affiché</translation>
    </message>
    <message>
        <source>Lines that this step removed. Click to show or hide them, struck through at their old places (%1 in the code).</source>
        <translation>Lignes que cette étape a supprimées. Un clic les affiche ou les masque, barrées à leur ancienne place (%1 dans le code).</translation>
    </message>
    <message>
        <source>1 line removed</source>
        <translation>1 ligne supprimée</translation>
    </message>
    <message>
        <source>%1 lines removed</source>
        <translation>%1 lignes supprimées</translation>
    </message>
    <message>
        <source>This step removed no lines.</source>
        <translation>Cette étape n’a supprimé aucune ligne.</translation>
    </message>
</context>
<context>
    <name>app::CodeView</name>
    <message>
        <source>Code that runs</source>
        <translation>Code qui s’exécute</translation>
    </message>
    <message>
        <source>%1
Click to fold or unfold (Enter)</source>
        <translation>%1
Clique pour replier ou déplier (Entrée)</translation>
    </message>
    <message>
        <source>Up and Down go from line to line. Enter runs to a line, or folds a section at its heading. %1 sets a breakpoint, %2 changes a parameter, %3 shows a value, %4 copies.</source>
        <translation>Haut et Bas vont de ligne en ligne. Entrée va jusqu’à une ligne, ou replie une section à son titre. %1 place un point d’arrêt, %2 change un paramètre, %3 montre une valeur, %4 copie.</translation>
    </message>
    <message>
        <source>The run stops before this line&apos;s phase. Click to remove the breakpoint</source>
        <translation>La simulation s’arrête avant la phase de cette ligne. Un clic supprime le point d’arrêt</translation>
    </message>
    <message>
        <source>Click to set a breakpoint before this line&apos;s phase</source>
        <translation>Un clic place un point d’arrêt avant la phase de cette ligne</translation>
    </message>
    <message>
        <source>New in this step. %1</source>
        <translation>Nouveau dans cette étape. %1</translation>
    </message>
    <message>
        <source>The previous step has this line; this step removed it.</source>
        <translation>L’étape précédente a cette ligne&#x202f;; cette étape l’a supprimée.</translation>
    </message>
    <message>
        <source>These lines add up the values computed above. They are the same for every force.
Click to fold or unfold (Enter)</source>
        <translation>Ces lignes additionnent les valeurs calculées plus haut. Elles sont les mêmes pour chaque force.
Clique pour replier ou déplier (Entrée)</translation>
    </message>
</context>
<context>
    <name>app::ComparisonRuns</name>
    <message>
        <source>before: %1</source>
        <translation>avant&#xa0;: %1</translation>
    </message>
    <message>
        <source>after: %1</source>
        <translation>après&#xa0;: %1</translation>
    </message>
    <message>
        <source>Computing “%1” again: frame %2 of %3. Press Esc to stop.</source>
        <translation>«&#x202f;%1&#x202f;» est recalculée&#xa0;: image %2 sur %3. Appuie sur Échap pour arrêter.</translation>
    </message>
    <message>
        <source>Stopped: “%1” is not shown. You can show it again in “Runs”.</source>
        <translation>Arrêté&#xa0;: «&#x202f;%1&#x202f;» n’est pas affichée. Tu peux l’afficher à nouveau dans «&#x202f;Simulations&#x202f;».</translation>
    </message>
    <message>
        <source>Keep run</source>
        <translation>Garder la simulation</translation>
    </message>
    <message>
        <source>Stop keeping run</source>
        <translation>Ne plus garder la simulation</translation>
    </message>
    <message>
        <source>Rename run</source>
        <translation>Renommer la simulation</translation>
    </message>
    <message>
        <source>Delete run</source>
        <translation>Supprimer la simulation</translation>
    </message>
</context>
<context>
    <name>app::ConceptButton</name>
    <message>
        <source>known</source>
        <translation>connue</translation>
    </message>
    <message>
        <source>can come next</source>
        <translation>peut venir ensuite</translation>
    </message>
    <message>
        <source>for later</source>
        <translation>pour plus tard</translation>
    </message>
    <message>
        <source>Opens %1</source>
        <translation>Ouvre %1</translation>
    </message>
</context>
<context>
    <name>app::ConceptView</name>
    <message>
        <source>Map of concepts</source>
        <translation>Carte des notions</translation>
    </message>
</context>
<context>
    <name>app::CursorPlot</name>
    <message>
        <source>%1. Under the mouse: %2</source>
        <translation>%1. Sous la souris&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>app::CurveButton</name>
    <message>
        <source>Choose this curve (%1)</source>
        <translation>Choisir cette courbe (%1)</translation>
    </message>
    <message>
        <source>Curve %1: %2</source>
        <translation>Courbe %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>%1, right</source>
        <translation>%1, juste</translation>
    </message>
</context>
<context>
    <name>app::DifferencePlot</name>
    <message>
        <source>Distance between the two runs over time</source>
        <translation>Écart entre les deux simulations en fonction du temps</translation>
    </message>
    <message>
        <source>px apart</source>
        <translation>écart en px</translation>
    </message>
    <message>
        <source>frame %1: %2&#x2009;px apart</source>
        <translation>image %1&#xa0;: %2&#x2009;px d’écart</translation>
    </message>
    <message>
        <source>%1: %2&#x2009;px at frame %3</source>
        <translation>%1&#xa0;: %2&#x2009;px à l’image %3</translation>
    </message>
    <message>
        <source>%1, px</source>
        <translation>%1, px</translation>
    </message>
</context>
<context>
    <name>app::EditCommands</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Rétablir</translation>
    </message>
    <message>
        <source>&amp;Copy the experiment as text</source>
        <translation>&amp;Copier l’expérience en texte</translation>
    </message>
    <message>
        <source>&amp;Paste an experiment</source>
        <translation>C&amp;oller une expérience</translation>
    </message>
    <message>
        <source>Copy the p&amp;icture of the scene</source>
        <translation>Copier la &amp;vue de la scène</translation>
    </message>
    <message>
        <source>&amp;Undo: %1</source>
        <translation>&amp;Annuler&#xa0;: %1</translation>
    </message>
    <message>
        <source>&amp;Redo: %1</source>
        <translation>&amp;Rétablir&#xa0;: %1</translation>
    </message>
    <message>
        <source>There is nothing to undo in this step</source>
        <translation>Il n’y a rien à annuler dans cette étape</translation>
    </message>
    <message>
        <source>There is nothing to redo</source>
        <translation>Il n’y a rien à rétablir</translation>
    </message>
</context>
<context>
    <name>app::EffectHeads</name>
    <message>
        <source>Effect</source>
        <translation>Effet</translation>
    </message>
    <message>
        <source>The effects of this scene, in the order in which they run.</source>
        <translation>Les effets de cette scène, dans l’ordre où ils s’exécutent.</translation>
    </message>
    <message>
        <source>µs a frame</source>
        <translation>µs/image</translation>
    </message>
    <message>
        <source>Microseconds (millionths of a second) that each frame of the run spends on it. About half of the measurements are within the ±.</source>
        <translation>Microsecondes (millionièmes de seconde) que chaque image de la simulation y consacre. À peu près la moitié des mesures sont dans les limites du ±.</translation>
    </message>
    <message>
        <source>µs a point</source>
        <translation>µs/point</translation>
    </message>
    <message>
        <source>The same for each point that it acts on.</source>
        <translation>La même chose pour chaque point sur lequel il agit.</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>fois</translation>
    </message>
    <message>
        <source>How often a frame computes it. Some methods compute it several times.</source>
        <translation>Combien de fois une image le calcule. Certaines méthodes le calculent plusieurs fois.</translation>
    </message>
    <message>
        <source>points</source>
        <translation>points</translation>
    </message>
    <message>
        <source>How many points it acts on.</source>
        <translation>Sur combien de points il agit.</translation>
    </message>
</context>
<context>
    <name>app::EffectLedger</name>
    <message>
        <source>measuring…</source>
        <translation>mesure en cours…</translation>
    </message>
    <message>
        <source>%1, measuring…</source>
        <translation>%1, mesure en cours…</translation>
    </message>
    <message>
        <source>%1, measured now</source>
        <translation>%1, mesuré maintenant</translation>
    </message>
    <message>
        <source>%1, measured at frame %2</source>
        <translation>%1, mesuré à l’image %2</translation>
    </message>
</context>
<context>
    <name>app::EffectList</name>
    <message>
        <source>The effects of the scene and their costs</source>
        <translation>Les effets de la scène et leurs coûts</translation>
    </message>
</context>
<context>
    <name>app::EffectsPanel</name>
    <message>
        <source>Effects</source>
        <translation>Effets</translation>
    </message>
    <message>
        <source>&amp;Measure the effects again</source>
        <translation>Re&amp;mesurer les effets</translation>
    </message>
    <message>
        <source>Measure again</source>
        <translation>Remesurer</translation>
    </message>
    <message>
        <source>Measure what a frame costs where the run is now</source>
        <translation>Mesurer ce que coûte une image là où en est la simulation</translation>
    </message>
</context>
<context>
    <name>app::EnergyList</name>
    <message>
        <source>Where energy and momentum went</source>
        <translation>Où sont passées l’énergie et la quantité de mouvement</translation>
    </message>
</context>
<context>
    <name>app::EnergyListModel</name>
    <message>
        <source>%1: %2 %3</source>
        <translation>%1&#xa0;: %2 %3</translation>
    </message>
    <message>
        <source>%1: %2&#x2009;%3
%4</source>
        <translation>%1&#xa0;: %2&#x2009;%3
%4</translation>
    </message>
</context>
<context>
    <name>app::EnergyPanel</name>
    <message>
        <source>Where it went</source>
        <translation>Où elle est passée</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Énergie</translation>
    </message>
    <message>
        <source>Where energy is, and where it went</source>
        <translation>Où est l’énergie, et où elle est passée</translation>
    </message>
    <message>
        <source>Momentum</source>
        <translation>Quantité de mouvement</translation>
    </message>
    <message>
        <source>Mass × velocity of everything together, and what changed it</source>
        <translation>Masse × vitesse de tout ensemble, et ce qui l’a changée</translation>
    </message>
    <message>
        <source>Everything here turns in place, held by the ground. So there is no momentum to count: choose a scene with moving bodies.</source>
        <translation>Ici, tout tourne sur place, retenu par le sol. Il n’y a donc pas de quantité de mouvement à compter&#xa0;: choisis une scène avec des corps en mouvement.</translation>
    </message>
    <message>
        <source>frame %1 to %2</source>
        <translation>image %1 à %2</translation>
    </message>
    <message>
        <source>counting…</source>
        <translation>comptage…</translation>
    </message>
</context>
<context>
    <name>app::EnergyPlot</name>
    <message>
        <source>Energy over the last frames</source>
        <translation>Énergie sur les dernières images</translation>
    </message>
    <message>
        <source>Momentum over the last frames</source>
        <translation>Quantité de mouvement sur les dernières images</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>vers la droite</translation>
    </message>
    <message>
        <source>down</source>
        <translation>vers le bas</translation>
    </message>
    <message>
        <source>energy</source>
        <translation>énergie</translation>
    </message>
    <message>
        <source>momentum</source>
        <translation>quantité de mouvement</translation>
    </message>
    <message>
        <source>Click or drag to go to a frame; the arrow keys move by one frame</source>
        <translation>Clique ou fais glisser pour aller à une image&#x202f;; les flèches avancent d’une image</translation>
    </message>
    <message>
        <source>%1 to the right, %2 down</source>
        <translation>%1 vers la droite, %2 vers le bas</translation>
    </message>
    <message>
        <source>%1 there, drift %2</source>
        <translation>%1 présente, dérive %2</translation>
    </message>
    <message>
        <source>%1: frame %2 is not counted</source>
        <translation>%1&#xa0;: l’image %2 n’est pas comptée</translation>
    </message>
    <message>
        <source>%1: %2 (%3) at frame %4</source>
        <translation>%1&#xa0;: %2 (%3) à l’image %4</translation>
    </message>
</context>
<context>
    <name>app::ExampleGallery</name>
    <message>
        <source>Examples</source>
        <translation>Exemples</translation>
    </message>
    <message>
        <source>%1 Undo brings your scene back.</source>
        <translation>%1 Annuler ramène ta scène.</translation>
    </message>
</context>
<context>
    <name>app::ExperimentFiles</name>
    <message>
        <source>Could not open the experiment: %1 Your scene is unchanged.</source>
        <translation>Impossible d’ouvrir l’expérience&#xa0;: %1 Ta scène n’a pas changé.</translation>
    </message>
    <message>
        <source>Could not save the experiment: %1</source>
        <translation>Impossible d’enregistrer l’expérience&#xa0;: %1</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Enregistré&#xa0;: %1.</translation>
    </message>
    <message>
        <source>%1 has unsaved changes.</source>
        <translation>%1 a des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Save the changes, then continue</source>
        <translation>Enregistrer les modifications, puis continuer</translation>
    </message>
    <message>
        <source>Discard changes</source>
        <translation>Abandonner les modifications</translation>
    </message>
    <message>
        <source>Continue without saving: your changes are lost</source>
        <translation>Continuer sans enregistrer&#xa0;: tes modifications sont perdues</translation>
    </message>
    <message>
        <source>Open an experiment or a lesson</source>
        <translation>Ouvrir une expérience ou une leçon</translation>
    </message>
    <message>
        <source>Experiments and lessons (*.springstep *.json *%1)</source>
        <translation>Expériences et leçons (*.springstep *.json *%1)</translation>
    </message>
    <message>
        <source>Experiments (*.springstep *.json)</source>
        <translation>Expériences (*.springstep *.json)</translation>
    </message>
    <message>
        <source>Save the experiment</source>
        <translation>Enregistrer l’expérience</translation>
    </message>
    <message>
        <source>The step has its published state again.</source>
        <translation>L’étape est de nouveau telle que publiée.</translation>
    </message>
    <message>
        <source>&amp;%1  %2</source>
        <translation>&amp;%1  %2</translation>
    </message>
    <message>
        <source>No recent files</source>
        <translation>Aucun fichier récent</translation>
    </message>
    <message>
        <source>Experiments that you open or save are listed here</source>
        <translation>Les expériences que tu ouvres ou enregistres apparaissent ici</translation>
    </message>
    <message>
        <source>Could not copy the experiment: %1</source>
        <translation>Impossible de copier l’expérience&#xa0;: %1</translation>
    </message>
    <message numerus="yes">
        <source>Copied: %n character(s), in one line.</source>
        <translation>
            <numerusform>Copié&#xa0;: %n caractère, en une ligne.</numerusform>
            <numerusform>Copié&#xa0;: %n caractères, en une ligne.</numerusform>
        </translation>
    </message>
    <message>
        <source>Springstep</source>
        <translation>Springstep</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Enregistrer</translation>
    </message>
    <message>
        <source>Close &amp;without saving</source>
        <translation>Fermer &amp;sans enregistrer</translation>
    </message>
    <message>
        <source>“%1” has unsaved changes.</source>
        <translation>«&#x202f;%1&#x202f;» a des modifications non enregistrées.</translation>
    </message>
    <message>
        <source>Could not find %1, so it was removed from the list. If you moved it, open it from its new place.</source>
        <translation>%1 est introuvable, et a donc été retiré de la liste. Si tu l’as déplacé, ouvre-le depuis son nouvel emplacement.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>&amp;Annuler</translation>
    </message>
    <message>
        <source>%1[*] – Springstep</source>
        <translation>%1[*] – Springstep</translation>
    </message>
</context>
<context>
    <name>app::ExportDialog</name>
    <message>
        <source>Frame %1 of %2</source>
        <translation>Image %1 sur %2</translation>
    </message>
    <message>
        <source>%1 is saved, up to the frame where the run stops. %2</source>
        <translation>%1 est enregistré, jusqu’à l’image où la simulation s’arrête. %2</translation>
    </message>
    <message>
        <source>%1 is saved.</source>
        <translation>%1 est enregistré.</translation>
    </message>
    <message>
        <source>Cancelled. No file was written.</source>
        <translation>Annulé. Aucun fichier n’a été écrit.</translation>
    </message>
    <message>
        <source>Ca&amp;ncel</source>
        <translation>A&amp;nnuler</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Close this dialog (Esc)</source>
        <translation>Fermer cette boîte de dialogue (Échap)</translation>
    </message>
</context>
<context>
    <name>app::FailureNotice</name>
    <message>
        <source>Searching for a remedy…</source>
        <translation>Recherche d’un remède…</translation>
    </message>
    <message>
        <source>Correct this line, and the run goes on.</source>
        <translation>Corrige cette ligne, et la simulation continue.</translation>
    </message>
    <message>
        <source>Correct this line, and the run goes on. Undo reverts your last change.</source>
        <translation>Corrige cette ligne, et la simulation continue. Annuler retire ton dernier changement.</translation>
    </message>
    <message>
        <source>No smaller step and no other method was found to be stable. Go back, and undo the change that caused this.</source>
        <translation>Aucun pas de temps plus court et aucune autre méthode ne se sont montrés stables. Reviens en arrière, et annule le changement qui a causé cela.</translation>
    </message>
</context>
<context>
    <name>app::FilmDialog</name>
    <message>
        <source>Film of the run</source>
        <translation>Film de la simulation</translation>
    </message>
    <message>
        <source>Progress of the film</source>
        <translation>Progression du film</translation>
    </message>
    <message>
        <source>The first frame of the film</source>
        <translation>La première image du film</translation>
    </message>
    <message>
        <source>The last frame of the film; the run is computed up to there</source>
        <translation>La dernière image du film&#x202f;; la simulation est calculée jusque-là</translation>
    </message>
    <message>
        <source>Frames a second</source>
        <translation>Images par seconde</translation>
    </message>
    <message>
        <source>The speed of the film: 30 is as fast as in the window</source>
        <translation>La vitesse du film&#xa0;: 30 va aussi vite que dans la fenêtre</translation>
    </message>
    <message>
        <source>Frames a &amp;second</source>
        <translation>Images par &amp;seconde</translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>&amp;Make the film</source>
        <translation>&amp;Créer le film</translation>
    </message>
    <message>
        <source>Make the film; you can use the window meanwhile</source>
        <translation>Créer le film&#x202f;; pendant ce temps, tu peux utiliser la fenêtre</translation>
    </message>
    <message>
        <source>Choosing its colours…</source>
        <translation>Choix des couleurs…</translation>
    </message>
    <message>
        <source>Cancelled. The pictures up to frame %1 are saved.</source>
        <translation>Annulé. Les captures jusqu’à l’image %1 sont enregistrées.</translation>
    </message>
    <message>
        <source>Cancel the film (Esc)</source>
        <translation>Annuler le film (Échap)</translation>
    </message>
    <message>
        <source>&amp;Width</source>
        <translation>&amp;Largeur</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Remplacer</translation>
    </message>
    <message>
        <source>Make the film, and overwrite the existing file</source>
        <translation>Créer le film, et écraser le fichier existant</translation>
    </message>
    <message>
        <source>A name that ends in .webm or .gif makes one file. A name such as walk_%04d.png makes a picture of each frame, with its number instead of %04d.</source>
        <translation>Un nom en .webm ou .gif donne un seul fichier. Un nom comme walk_%04d.png donne une capture par image, avec son numéro pour %04d.</translation>
    </message>
</context>
<context>
    <name>app::FilmName</name>
    <message>
        <source>Where to save the film</source>
        <translation>Où enregistrer le film</translation>
    </message>
    <message>
        <source>%1 already exists. Replace it, or choose another name.</source>
        <translation>%1 existe déjà. Remplace-le, ou choisis un autre nom.</translation>
    </message>
    <message>
        <source>Such pictures already exist, for example %1. Replace them, or choose another name.</source>
        <translation>De telles captures existent déjà, par exemple %1. Remplace-les, ou choisis un autre nom.</translation>
    </message>
    <message>
        <source>Film of the run</source>
        <translation>Film de la simulation</translation>
    </message>
    <message>
        <source>Films (*.gif *.webm);;Pictures of each frame (*.png)</source>
        <translation>Films (*.gif *.webm);;Captures de chaque image (*.png)</translation>
    </message>
</context>
<context>
    <name>app::FilmSize</name>
    <message>
        <source>Width in pixels</source>
        <translation>Largeur en pixels</translation>
    </message>
    <message>
        <source>How wide the pictures are, %1 to %2 pixels</source>
        <translation>La largeur du film, de %1 à %2 pixels</translation>
    </message>
    <message>
        <source>4 : 3</source>
        <translation>4&#xa0;: 3</translation>
    </message>
    <message>
        <source>16 : 9</source>
        <translation>16&#xa0;: 9</translation>
    </message>
    <message>
        <source>square</source>
        <translation>carré</translation>
    </message>
    <message>
        <source>as the scene is</source>
        <translation>comme la scène</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Forme</translation>
    </message>
    <message>
        <source>The width of the pictures compared with their height; the height follows the width</source>
        <translation>La largeur du film par rapport à sa hauteur&#x202f;; la hauteur suit la largeur</translation>
    </message>
    <message>
        <source>Height: %1 pixels</source>
        <translation>Hauteur&#xa0;: %1 pixels</translation>
    </message>
</context>
<context>
    <name>app::FootfallStrip</name>
    <message>
        <source>Feet on the ground</source>
        <translation>Pieds au sol</translation>
    </message>
    <message>
        <source>%1 stands, slipped %2&#x202f;px.</source>
        <translation>%1 est au sol, a glissé de %2&#x202f;px.</translation>
    </message>
    <message>
        <source>%1 is in the air.</source>
        <translation>%1 est en l’air.</translation>
    </message>
    <message>
        <source>Feet on the ground, and how many px each slips</source>
        <translation>Pieds au sol, et de combien de px chacun glisse</translation>
    </message>
    <message>
        <source>The times when each foot is on the ground. Click to go to that frame</source>
        <translation>Les moments où chaque pied est au sol. Un clic mène à cette image</translation>
    </message>
    <message>
        <source>%1 is in the air at frame %2</source>
        <translation>%1 est en l’air à l’image %2</translation>
    </message>
    <message>
        <source>%1 stands from frame %2 to %3 and slips %4&#x202f;px</source>
        <translation>%1 est au sol de l’image %2 à %3 et glisse de %4&#x202f;px</translation>
    </message>
</context>
<context>
    <name>app::FrameCounter</name>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>Image</translation>
    </message>
    <message>
        <source>Go to frame</source>
        <translation>Aller à l’image</translation>
    </message>
    <message>
        <source>Press Enter to go there, Esc to cancel</source>
        <translation>Entrée y va, Échap annule</translation>
    </message>
    <message>
        <source>A frame is a whole number from 0 to %1.</source>
        <translation>Une image est un nombre entier de 0 à %1.</translation>
    </message>
</context>
<context>
    <name>app::FrameRange</name>
    <message>
        <source>First frame</source>
        <translation>Première image</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>Dernière image</translation>
    </message>
    <message>
        <source>&amp;First frame</source>
        <translation>&amp;Première image</translation>
    </message>
    <message>
        <source>&amp;Last frame</source>
        <translation>&amp;Dernière image</translation>
    </message>
</context>
<context>
    <name>app::Gallery</name>
    <message>
        <source>the file</source>
        <translation>le fichier</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>this is not an experiment of the gallery.</source>
        <translation>ce n’est pas une expérience de la galerie.</translation>
    </message>
    <message>
        <source>%1 The file was left alone.</source>
        <translation>%1 Le fichier est resté tel quel.</translation>
    </message>
    <message>
        <source>%1: the file could not be written: %2. Check the folder %3.</source>
        <translation>%1&#xa0;: impossible d’écrire le fichier&#xa0;: %2. Vérifie le dossier %3.</translation>
    </message>
    <message>
        <source>keep %1</source>
        <translation>garder %1</translation>
    </message>
    <message>
        <source>rename %1</source>
        <translation>renommer %1</translation>
    </message>
    <message>
        <source>remove %1</source>
        <translation>supprimer %1</translation>
    </message>
    <message>
        <source>%1: the file could not be removed: %2. Check the folder %3.</source>
        <translation>%1&#xa0;: impossible de supprimer le fichier&#xa0;: %2. Vérifie le dossier %3.</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Annuler&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>app::GalleryDesk</name>
    <message>
        <source>Could not keep the experiment: %1</source>
        <translation>Impossible de garder l’expérience&#xa0;: %1</translation>
    </message>
    <message>
        <source>Kept in the gallery as %1.</source>
        <translation>Gardé dans la galerie&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Open %1</source>
        <translation>Ouvrir %1</translation>
    </message>
    <message>
        <source>%1 is open. Undo brings your scene back.</source>
        <translation>%1 est ouvert. Annuler ramène ta scène.</translation>
    </message>
</context>
<context>
    <name>app::GalleryPage</name>
    <message>
        <source>Gallery</source>
        <translation>Galerie</translation>
    </message>
    <message>
        <source>Experiments that you keep</source>
        <translation>Les expériences que tu gardes</translation>
    </message>
    <message>
        <source>Nothing is kept here yet. Build something, then press Keep this one: the gallery stores it with a picture.</source>
        <translation>Rien n’est encore gardé ici. Construis quelque chose, puis appuie sur «&#x202f;Garder celle-ci&#x202f;»&#xa0;: la galerie la conserve avec une capture.</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Ouvrir</translation>
    </message>
    <message>
        <source>Open the selected experiment (Return)</source>
        <translation>Ouvrir l’expérience sélectionnée (Entrée)</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Renommer</translation>
    </message>
    <message>
        <source>Give the selected experiment another title (F2)</source>
        <translation>Donner un autre titre à l’expérience sélectionnée (F2)</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Remove the selected experiment from the gallery (Del)</source>
        <translation>Supprimer de la galerie l’expérience sélectionnée (Suppr)</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Keep this one</source>
        <translation>Garder celle-ci</translation>
    </message>
    <message>
        <source>Keep the experiment that is open in the window</source>
        <translation>Garder l’expérience ouverte dans la fenêtre</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Close the gallery (Esc)</source>
        <translation>Fermer la galerie (Échap)</translation>
    </message>
    <message>
        <source>%1, kept %2. Return opens it.</source>
        <translation>%1, gardée %2. Entrée l’ouvre.</translation>
    </message>
    <message>
        <source>There is nothing to undo</source>
        <translation>Il n’y a rien à annuler</translation>
    </message>
    <message>
        <source>%1 (Ctrl+Z)</source>
        <translation>%1 (Ctrl+Z)</translation>
    </message>
</context>
<context>
    <name>app::GlossaryPage</name>
    <message>
        <source>Glossary</source>
        <translation>Glossaire</translation>
    </message>
    <message>
        <source>The words that the lessons teach. Esc closes this page.</source>
        <translation>Les mots que les leçons enseignent. Échap ferme cette page.</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Rechercher</translation>
    </message>
    <message>
        <source>Search the glossary</source>
        <translation>Rechercher dans le glossaire</translation>
    </message>
    <message>
        <source>Part of a word, or of its meaning</source>
        <translation>Une partie d’un mot, ou de son sens</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>Mots</translation>
    </message>
    <message>
        <source>No word found for “%1”. Try only a part of it.</source>
        <translation>Aucun mot trouvé pour «&#x202f;%1&#x202f;». Essaie avec une partie seulement.</translation>
    </message>
</context>
<context>
    <name>app::GrowthPlot</name>
    <message>
        <source>Map of growth</source>
        <translation>Carte de croissance</translation>
    </message>
    <message>
        <source>unstable</source>
        <translation>instable</translation>
    </message>
    <message>
        <source>stable</source>
        <translation>stable</translation>
    </message>
    <message>
        <source>disturbances %1</source>
        <translation>perturbations %1</translation>
    </message>
    <message>
        <source>a step of %1</source>
        <translation>un pas de temps de %1</translation>
    </message>
    <message>
        <source>Click or press Enter to use k %1 and %2</source>
        <translation>Un clic ou Entrée utilise k %1 et %2</translation>
    </message>
    <message>
        <source>stiffness k, 1/frame²</source>
        <translation>raideur k, 1/image²</translation>
    </message>
    <message>
        <source>step, frames</source>
        <translation>pas de temps, images</translation>
    </message>
    <message>
        <source>damp, kept per frame</source>
        <translation>damp, conservé par image</translation>
    </message>
    <message>
        <source>×10 a frame</source>
        <translation>×10 par image</translation>
    </message>
</context>
<context>
    <name>app::GuessBox</name>
    <message>
        <source>What do you expect?</source>
        <translation>À quoi t’attends-tu&#x202f;?</translation>
    </message>
    <message>
        <source>You said: %1</source>
        <translation>Tu as dit&#xa0;: %1</translation>
    </message>
    <message>
        <source>Choose what you expect</source>
        <translation>Choisis ce à quoi tu t’attends</translation>
    </message>
    <message>
        <source>Hide the choices</source>
        <translation>Masquer les choix</translation>
    </message>
    <message>
        <source>**You said:** %1</source>
        <translation>**Tu as dit&#xa0;:** %1</translation>
    </message>
</context>
<context>
    <name>app::GuideBox</name>
    <message>
        <source>First build</source>
        <translation>Guide</translation>
    </message>
    <message>
        <source>With keys: arrow keys move the cross in the picture, Return clicks there, Tab goes to fields and switches.</source>
        <translation>Au clavier&#xa0;: les flèches déplacent la croix dans la vue, Entrée clique à cet endroit, Tab va aux champs et aux interrupteurs.</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Recommencer</translation>
    </message>
    <message>
        <source>Restart the first build with a new scene. Undo brings this one back</source>
        <translation>Recommencer la première construction avec une nouvelle scène. Annuler ramène celle-ci</translation>
    </message>
    <message>
        <source>Leave</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>Leave the first build; the scene stays as it is</source>
        <translation>Quitter la première construction&#x202f;; la scène reste telle quelle</translation>
    </message>
    <message>
        <source>First build: %1 of %2</source>
        <translation>Guide&#xa0;: %1 sur %2</translation>
    </message>
</context>
<context>
    <name>app::HandInDialog</name>
    <message>
        <source>Hand in a notebook</source>
        <translation>Rendre un cahier</translation>
    </message>
    <message>
        <source>A notebook has what you did: what you tried, predicted, wrote and built, each with its run. Your teacher can replay it. Nothing is sent: the files stay on this computer until you pass them on.</source>
        <translation>Un cahier contient ce que tu as fait&#xa0;: ce que tu as essayé, prédit, écrit et construit, chaque fois avec sa simulation. Ton enseignant peut la rejouer. Rien n’est envoyé&#xa0;: les fichiers restent sur cet ordinateur jusqu’à ce que tu les transmettes.</translation>
    </message>
    <message>
        <source>may stay empty</source>
        <translation>peut rester vide</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Your name for the notebook. Without it, the notebook has no name</source>
        <translation>Ton nom pour le cahier. Sans lui, le cahier n’a pas de nom</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>&amp;Nom</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Leçons</translation>
    </message>
    <message>
        <source>Space chooses a lesson, or leaves it out</source>
        <translation>Espace choisit une leçon, ou la laisse de côté</translation>
    </message>
    <message>
        <source>&amp;Lessons, and how much you did in them</source>
        <translation>&amp;Leçons, et combien tu y as fait</translation>
    </message>
    <message>
        <source>Also puts in the scenes that you keep in the gallery</source>
        <translation>Y met aussi les scènes que tu gardes dans la galerie</translation>
    </message>
    <message>
        <source>Note&amp;book (.springstep-notebook)</source>
        <translation>&amp;Cahier (.springstep-notebook)</translation>
    </message>
    <message>
        <source>A file whose runs your teacher can replay</source>
        <translation>Un fichier dont ton enseignant peut rejouer les simulations</translation>
    </message>
    <message>
        <source>&amp;Web page (.html)</source>
        <translation>Page &amp;web (.html)</translation>
    </message>
    <message>
        <source>A page to read in any browser, with pictures</source>
        <translation>Une page illustrée, lisible dans tout navigateur</translation>
    </message>
    <message>
        <source>&amp;PDF (.pdf)</source>
        <translation>&amp;PDF (.pdf)</translation>
    </message>
    <message>
        <source>The same on paper</source>
        <translation>La même chose sur papier</translation>
    </message>
    <message>
        <source>Where to write, without an ending</source>
        <translation>Où écrire, sans extension</translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Close this page (Esc)</source>
        <translation>Fermer cette page (Échap)</translation>
    </message>
    <message>
        <source>Scenes of the &amp;gallery (%1)</source>
        <translation>Scènes de la &amp;galerie (%1)</translation>
    </message>
    <message>
        <source>Notebooks (*.springstep-notebook)</source>
        <translation>Cahiers (*.springstep-notebook)</translation>
    </message>
    <message>
        <source>Wri&amp;te</source>
        <translation>Éc&amp;rire</translation>
    </message>
    <message>
        <source>Write the files</source>
        <translation>Écrire les fichiers</translation>
    </message>
    <message>
        <source>There is nothing to hand in yet. Do a thing to try, answer a prediction, or keep a scene first.</source>
        <translation>Il n’y a encore rien à rendre. Fais d’abord un essai, réponds à une prédiction, ou garde une scène.</translation>
    </message>
    <message>
        <source>Choose a lesson, or the scenes of the gallery.</source>
        <translation>Choisis une leçon, ou les scènes de la galerie.</translation>
    </message>
    <message>
        <source>Choose what to write: the notebook, the web page or the PDF.</source>
        <translation>Choisis ce qu’il faut écrire&#xa0;: le cahier, la page web ou le PDF.</translation>
    </message>
    <message>
        <source>Type the name of a file.</source>
        <translation>Tape le nom d’un fichier.</translation>
    </message>
    <message>
        <source>This writes %1.</source>
        <translation>Cela écrit %1.</translation>
    </message>
    <message>
        <source>%1 already exists. Replace it, or choose another name.</source>
        <translation>%1 existe déjà. Remplace-le, ou choisis un autre nom.</translation>
    </message>
    <message>
        <source>&amp;Replace</source>
        <translation>&amp;Remplacer</translation>
    </message>
    <message>
        <source>Write the files, and overwrite those that exist</source>
        <translation>Écrire les fichiers, et écraser ceux qui existent</translation>
    </message>
    <message>
        <source>Writing…</source>
        <translation>Écriture…</translation>
    </message>
    <message>
        <source>%1 written to %2.</source>
        <translation>%1&#xa0;: écrit dans %2.</translation>
    </message>
    <message>
        <source>Could not write: %1</source>
        <translation>Impossible d’écrire&#xa0;: %1</translation>
    </message>
    <message>
        <source>notebook</source>
        <comment>name of a file</comment>
        <translation>cahier</translation>
    </message>
</context>
<context>
    <name>app::Header</name>
    <message>
        <source>More menus</source>
        <translation>Autres menus</translation>
    </message>
</context>
<context>
    <name>app::HelpPage</name>
    <message>
        <source>Keys and mouse</source>
        <translation>Touches et souris</translation>
    </message>
    <message>
        <source>Everything works without the mouse, too. Esc closes this page.</source>
        <translation>Tout marche aussi sans la souris. Échap ferme cette page.</translation>
    </message>
</context>
<context>
    <name>app::Introduction</name>
    <message>
        <source>These lessons have no concepts</source>
        <translation>Ces leçons n’ont pas de notions</translation>
    </message>
</context>
<context>
    <name>app::KeyCaps</name>
    <message>
        <source>or</source>
        <translation>ou</translation>
    </message>
</context>
<context>
    <name>app::LanguageMenu</name>
    <message>
        <source>Lan&amp;guage</source>
        <translation>Lang&amp;ue</translation>
    </message>
    <message>
        <source>&amp;System language</source>
        <translation>Langue du &amp;système</translation>
    </message>
    <message>
        <source>Springstep will use %1 after a restart.</source>
        <translation>Springstep utilisera %1 après un redémarrage.</translation>
    </message>
</context>
<context>
    <name>app::LearnPanel</name>
    <message>
        <source>Lessons</source>
        <translation>Leçons</translation>
    </message>
    <message>
        <source>%1 of %2 steps</source>
        <translation>%1/%2 étapes</translation>
    </message>
    <message>
        <source>Fold the lessons to a narrow strip</source>
        <translation>Replier les leçons en une bande étroite</translation>
    </message>
    <message>
        <source>All lessons</source>
        <translation>Toutes les leçons</translation>
    </message>
    <message>
        <source>Back to the text (Esc)</source>
        <translation>Retour au texte (Échap)</translation>
    </message>
    <message>
        <source>Show all lessons instead of the text</source>
        <translation>Afficher toutes les leçons à la place du texte</translation>
    </message>
</context>
<context>
    <name>app::LearnerCode</name>
    <message>
        <source>Change code</source>
        <translation>Modifier le code</translation>
    </message>
    <message>
        <source>Reset listing</source>
        <translation>Rétablir le listing</translation>
    </message>
    <message>
        <source>your code</source>
        <translation>ton code</translation>
    </message>
    <message>
        <source>the listing of the step</source>
        <translation>le listing de l’étape</translation>
    </message>
    <message>
        <source>This step has no listing.</source>
        <translation>Cette étape n’a pas de listing.</translation>
    </message>
    <message>
        <source>Your code does not compile. Line %1: %2</source>
        <translation>Ton code ne se compile pas. Ligne %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Change method</source>
        <translation>Changer la méthode</translation>
    </message>
</context>
<context>
    <name>app::LessonDesk</name>
    <message>
        <source>New &amp;lesson from this scene…</source>
        <translation>Nouvelle leçon à partir de cette s&amp;cène…</translation>
    </message>
    <message>
        <source>Write a small lesson with this scene into a folder, to go on with an editor</source>
        <translation>Écrire une petite leçon avec cette scène dans un dossier, pour continuer avec un éditeur</translation>
    </message>
    <message>
        <source>There is no place for lessons of your own</source>
        <translation>Il n’y a pas d’endroit pour tes propres leçons</translation>
    </message>
    <message>
        <source>Could not open the lesson: %1</source>
        <translation>Impossible d’ouvrir la leçon&#xa0;: %1</translation>
    </message>
    <message>
        <source>Choose a new folder for the lesson</source>
        <translation>Choisir un nouveau dossier pour la leçon</translation>
    </message>
    <message>
        <source>Folder of a lesson (*)</source>
        <translation>Dossier d’une leçon (*)</translation>
    </message>
    <message>
        <source>Could not begin a lesson: %1</source>
        <translation>Impossible de commencer une leçon&#xa0;: %1</translation>
    </message>
    <message>
        <source>The lesson is in %1. Write its texts in first.md: each time you save, they change here.</source>
        <translation>La leçon est dans %1. Écris ses textes dans first.md&#xa0;: à chaque enregistrement, ils changent ici.</translation>
    </message>
    <message>
        <source>The lesson is in %1. Open its first.md in an editor: each time you save, it changes here.</source>
        <translation>La leçon est dans %1. Ouvre son fichier first.md dans un éditeur&#xa0;: à chaque enregistrement, elle change ici.</translation>
    </message>
    <message>
        <source>Could not show the lesson: %1</source>
        <translation>Impossible d’afficher la leçon&#xa0;: %1</translation>
    </message>
    <message>
        <source>Re&amp;move this lesson from the list</source>
        <translation>Re&amp;tirer cette leçon de la liste</translation>
    </message>
    <message>
        <source>Take the open lesson out of your lessons; its files stay where they are</source>
        <translation>Retirer la leçon ouverte de tes leçons&#x202f;; ses fichiers restent où ils sont</translation>
    </message>
    <message>
        <source>The open lesson is not one of yours</source>
        <translation>La leçon ouverte n’est pas une des tiennes</translation>
    </message>
    <message>
        <source>%1 is no longer in the list. Its files are still there.</source>
        <translation>%1 n’est plus dans la liste. Ses fichiers sont toujours là.</translation>
    </message>
    <message>
        <source>Put it back</source>
        <translation>La remettre</translation>
    </message>
    <message>
        <source>Opens the lesson again</source>
        <translation>Ouvre de nouveau la leçon</translation>
    </message>
</context>
<context>
    <name>app::LessonList</name>
    <message>
        <source>Lessons</source>
        <translation>Leçons</translation>
    </message>
</context>
<context>
    <name>app::LessonModel</name>
    <message>
        <source>open</source>
        <translation>ouverte</translation>
    </message>
    <message>
        <source>%1, %2 of %3 steps done</source>
        <translation>%1, %2 étapes faites sur %3</translation>
    </message>
    <message>
        <source>%1, done</source>
        <translation>%1, fait</translation>
    </message>
    <message>
        <source>%1, not yet done</source>
        <translation>%1, pas encore fait</translation>
    </message>
    <message>
        <source>Yours</source>
        <translation>Les tiennes</translation>
    </message>
    <message>
        <source>Lessons that you opened with File &gt; Open</source>
        <translation>Les leçons que tu as ouvertes avec Fichier &gt; Ouvrir</translation>
    </message>
    <message>
        <source>1 file is not a lesson</source>
        <translation>1 fichier n’est pas une leçon</translation>
    </message>
    <message>
        <source>%1 files are not lessons</source>
        <translation>%1 fichiers ne sont pas des leçons</translation>
    </message>
    <message>
        <source>What you learnt</source>
        <translation>Ce que tu as appris</translation>
    </message>
    <message>
        <source>A summary of this lesson, and the things that are still to try</source>
        <translation>Un résumé de cette leçon, et les essais qu’il reste à faire</translation>
    </message>
    <message>
        <source>%1: what you learnt</source>
        <translation>%1&#xa0;: ce que tu as appris</translation>
    </message>
</context>
<context>
    <name>app::LessonRail</name>
    <message>
        <source>Show the lessons with their texts</source>
        <translation>Afficher les leçons avec leurs textes</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Étape précédente</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Étape suivante</translation>
    </message>
</context>
<context>
    <name>app::LevelBox</name>
    <message>
        <source>Judge it</source>
        <translation>Vérifier</translation>
    </message>
    <message>
        <source>Runs your scene or your code, and says whether it passes</source>
        <translation>Exécute ta scène ou ton code, et dit si le palier est réussi</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Stops the judge</source>
        <translation>Arrête la vérification</translation>
    </message>
    <message>
        <source>Hint</source>
        <translation>Indice</translation>
    </message>
    <message>
        <source>Shows or hides a hint</source>
        <translation>Affiche ou masque un indice</translation>
    </message>
    <message>
        <source>%1, passed</source>
        <translation>%1, réussi</translation>
    </message>
    <message>
        <source>Judging: %1 % of the frames.</source>
        <translation>Vérification&#xa0;: %1&#x202f;% des images.</translation>
    </message>
    <message>
        <source>Passed: everything holds.</source>
        <translation>Réussi&#xa0;: tout est respecté.</translation>
    </message>
</context>
<context>
    <name>app::LineStepper</name>
    <message>
        <source>Line %1 does not run in this frame, nor in the next one.</source>
        <translation>La ligne %1 ne s’exécute ni dans cette image, ni dans la suivante.</translation>
    </message>
</context>
<context>
    <name>app::ListingEditor</name>
    <message>
        <source>Listing: the code that you can change</source>
        <translation>Listing&#xa0;: le code que tu peux modifier</translation>
    </message>
    <message>
        <source>Run to this line</source>
        <translation>Aller jusqu’à cette ligne</translation>
    </message>
    <message>
        <source>Cut</source>
        <translation>Couper</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Paste</source>
        <translation>Coller</translation>
    </message>
    <message>
        <source>Select all</source>
        <translation>Tout sélectionner</translation>
    </message>
    <message>
        <source>Reset listing</source>
        <translation>Rétablir le listing</translation>
    </message>
    <message>
        <source>The run stops before this line. Click the dot to remove the breakpoint</source>
        <translation>La simulation s’arrête avant cette ligne. Un clic sur le point supprime le point d’arrêt</translation>
    </message>
    <message>
        <source>Click to run to this line. Ctrl+click sets a breakpoint</source>
        <translation>Un clic va jusqu’à cette ligne. Ctrl+clic place un point d’arrêt</translation>
    </message>
    <message>
        <source>You changed this line. %1</source>
        <translation>Tu as modifié cette ligne. %1</translation>
    </message>
    <message>
        <source>Set breakpoint</source>
        <translation>Placer un point d’arrêt</translation>
    </message>
    <message>
        <source>Remove breakpoint</source>
        <translation>Supprimer le point d’arrêt</translation>
    </message>
    <message>
        <source>Type to change it; the run is computed again after a short pause. Tab indents, %1 completes a name, %2 sets a breakpoint, Esc leaves the editor.</source>
        <translation>Tape pour le modifier&#x202f;; la simulation est recalculée après une courte pause. Tab indente, %1 complète un nom, %2 place un point d’arrêt, Échap quitte l’éditeur.</translation>
    </message>
    <message>
        <source>My rule: forces that you write</source>
        <translation>Ma règle&#xa0;: des forces que tu écris</translation>
    </message>
    <message>
        <source>Type to change it; the run is computed again after a short pause. Tab indents, %1 completes a name, Esc leaves the editor.</source>
        <translation>Tape pour la modifier&#x202f;; la simulation est recalculée après une courte pause. Tab indente, %1 complète un nom, Échap quitte l’éditeur.</translation>
    </message>
    <message>
        <source>Delete rule</source>
        <translation>Supprimer la règle</translation>
    </message>
</context>
<context>
    <name>app::ListingPanel</name>
    <message>
        <source>Reset listing</source>
        <translation>Rétablir le listing</translation>
    </message>
    <message>
        <source>Correct the mistake first. Until then, the last good code computes the run.</source>
        <translation>Corrige d’abord l’erreur. D’ici là, le dernier code correct calcule la simulation.</translation>
    </message>
    <message>
        <source>This listing does not compute the run. Choose “Use your code” first.</source>
        <translation>Ce listing ne calcule pas la simulation. Choisis d’abord «&#x202f;Utiliser ton code&#x202f;».</translation>
    </message>
    <message>
        <source>Bring the step&apos;s own listing back (Undo brings yours back)</source>
        <translation>Ramener le listing de l’étape (Annuler ramène le tien)</translation>
    </message>
    <message>
        <source>This is the step&apos;s own listing.</source>
        <translation>C’est le listing de l’étape.</translation>
    </message>
    <message>
        <source>No line that runs comes after line %1. Choose a line inside a function.</source>
        <translation>Aucune ligne ne s’exécute après la ligne %1. Choisis une ligne à l’intérieur d’une fonction.</translation>
    </message>
    <message>
        <source>No longer stops before line %1.</source>
        <translation>N’arrête plus avant la ligne %1.</translation>
    </message>
    <message>
        <source>Stops before line %1.</source>
        <translation>Arrête avant la ligne %1.</translation>
    </message>
</context>
<context>
    <name>app::MainWindow</name>
    <message>
        <source>Accuracy</source>
        <translation>Précision</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Énergie</translation>
    </message>
    <message>
        <source>Effects</source>
        <translation>Effets</translation>
    </message>
    <message>
        <source>Code</source>
        <translation>Code</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>&amp;Fichiers récents</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>Two runs</source>
        <translation>Deux simulations</translation>
    </message>
    <message>
        <source>Stability</source>
        <translation>Stabilité</translation>
    </message>
    <message>
        <source>Lessons</source>
        <translation>Leçons</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>The panels are back in their original places.</source>
        <translation>Les panneaux sont revenus à leur place d’origine.</translation>
    </message>
    <message>
        <source>There is no folder for the gallery</source>
        <translation>Il n’y a pas de dossier pour la galerie</translation>
    </message>
</context>
<context>
    <name>app::MapPage</name>
    <message>
        <source>Map of concepts</source>
        <translation>Carte des notions</translation>
    </message>
    <message>
        <source>What rests on what</source>
        <translation>Ce qui repose sur quoi</translation>
    </message>
    <message>
        <source>You know it</source>
        <translation>Connue</translation>
    </message>
    <message>
        <source>Can come next</source>
        <translation>Peut venir ensuite</translation>
    </message>
    <message>
        <source>For later</source>
        <translation>Pour plus tard</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Back to the open step (Esc)</source>
        <translation>Retour à l’étape ouverte (Échap)</translation>
    </message>
    <message>
        <source>You know %1 of %2 concepts. Lines lead up from a concept to those that it rests on.</source>
        <translation>Notions connues&#xa0;: %1 sur %2. Les lignes montent d’une notion vers celles sur lesquelles elle repose.</translation>
    </message>
    <message>
        <source>Go on: %1</source>
        <translation>Continuer&#xa0;: %1</translation>
    </message>
    <message>
        <source>Begin: %1</source>
        <translation>Commencer&#xa0;: %1</translation>
    </message>
    <message>
        <source>Opens %1</source>
        <translation>Ouvre %1</translation>
    </message>
    <message>
        <source>you know it</source>
        <translation>tu la connais</translation>
    </message>
    <message>
        <source>it can come next</source>
        <translation>elle peut venir ensuite</translation>
    </message>
    <message>
        <source>for later</source>
        <translation>pour plus tard</translation>
    </message>
    <message>
        <source>Point at a concept to see what it rests on. A click, or **Enter**, opens its step. The arrow keys go from one to the next.</source>
        <translation>Pointe une notion pour voir sur quoi elle repose. Un clic, ou **Entrée**, ouvre son étape. Les flèches vont de l’une à l’autre.</translation>
    </message>
    <message>
        <source>Rests on: %1.</source>
        <translation>Repose sur&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Leads to: %1.</source>
        <translation>Mène à&#xa0;: %1.</translation>
    </message>
</context>
<context>
    <name>app::MapPlot</name>
    <message>
        <source>a step of %1&#x2009;frames</source>
        <translation>un pas de temps de %1&#x2009;images</translation>
    </message>
    <message>
        <source>The map is being computed.</source>
        <translation>La carte est en cours de calcul.</translation>
    </message>
    <message>
        <source>You are at %1. The arrow keys move over the map, and Enter uses the values at a place.</source>
        <translation>Tu es à %1. Les flèches se déplacent sur la carte, et Entrée utilise les valeurs d’un endroit.</translation>
    </message>
    <message>
        <source>you are here</source>
        <translation>tu es ici</translation>
    </message>
</context>
<context>
    <name>app::MeasurePanel</name>
    <message>
        <source>Measured</source>
        <translation>Mesuré</translation>
    </message>
    <message>
        <source>at the cursor</source>
        <translation>au curseur</translation>
    </message>
</context>
<context>
    <name>app::MistakeRow</name>
    <message>
        <source>Line %1: %2</source>
        <translation>Ligne %1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>app::NameField</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Name of the run</source>
        <translation>Nom de la simulation</translation>
    </message>
    <message>
        <source>Press Return to apply, Esc to cancel</source>
        <translation>Entrée applique, Échap annule</translation>
    </message>
</context>
<context>
    <name>app::NameRow</name>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>The name of the point in files, in “Stop when…”, and in lessons and their listings. Press Enter to apply.</source>
        <translation>Le nom du point dans les fichiers, dans «&#x202f;Arrêter quand…&#x202f;», et dans les leçons et leurs listings. Appuie sur Entrée pour appliquer.</translation>
    </message>
</context>
<context>
    <name>app::Narration</name>
    <message>
        <source>Try this</source>
        <translation>À toi d’essayer</translation>
    </message>
    <message>
        <source>Previous step</source>
        <translation>Étape précédente</translation>
    </message>
    <message>
        <source>Back: %1</source>
        <translation>Retour&#xa0;: %1</translation>
    </message>
    <message>
        <source>This is the first step.</source>
        <translation>C’est la première étape.</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Suite&#xa0;: %1</translation>
    </message>
    <message>
        <source>What you learnt</source>
        <translation>Ce que tu as appris</translation>
    </message>
    <message>
        <source>What you learnt in this lesson, and what comes next</source>
        <translation>Ce que tu as appris dans cette leçon, et ce qui vient ensuite</translation>
    </message>
    <message>
        <source>Write it yourself</source>
        <translation>Écris-le toi-même</translation>
    </message>
    <message>
        <source>Predict, then play</source>
        <translation>Prédis, puis lance</translation>
    </message>
    <message>
        <source>Predict first</source>
        <translation>Prédis d’abord</translation>
    </message>
    <message>
        <source>Goes to a question about a run, at the end of the text</source>
        <translation>Va à une question sur une simulation, à la fin du texte</translation>
    </message>
    <message>
        <source>Goes to a task in the listing, at the end of the text</source>
        <translation>Va à une tâche dans le listing, à la fin du texte</translation>
    </message>
</context>
<context>
    <name>app::Notice</name>
    <message>
        <source>Notice</source>
        <translation>Avis</translation>
    </message>
    <message>
        <source>Close this notice (Esc)</source>
        <translation>Fermer cet avis (Échap)</translation>
    </message>
    <message>
        <source>Close this notice</source>
        <translation>Fermer cet avis</translation>
    </message>
</context>
<context>
    <name>app::NumberTable</name>
    <message>
        <source>Could not save the numbers as %1: %2. Choose another folder, or free some disk space.</source>
        <translation>Impossible d’enregistrer les nombres dans %1&#xa0;: %2. Choisis un autre dossier, ou libère de l’espace disque.</translation>
    </message>
</context>
<context>
    <name>app::OrderPlot</name>
    <message>
        <source>Error against step: the measured order</source>
        <translation>Erreur en fonction du pas de temps&#xa0;: l’ordre mesuré</translation>
    </message>
    <message>
        <source>%1: %2, as expected</source>
        <translation>%1&#xa0;: %2, comme attendu</translation>
    </message>
    <message>
        <source>%1: %2 of %3</source>
        <translation>%1&#xa0;: %2 au lieu de %3</translation>
    </message>
    <message>
        <source>step, frames (finer →)</source>
        <translation>pas de temps, images (plus fin →)</translation>
    </message>
    <message>
        <source>A step %1 times as short makes the error %2 times as small: order %3 here, %4 expected</source>
        <translation>Un pas de temps %1 fois plus court rend l’erreur %2 fois plus petite&#xa0;: ordre %3 ici, %4 attendu</translation>
    </message>
</context>
<context>
    <name>app::ParameterPanel</name>
    <message>
        <source>Parameters</source>
        <translation>Paramètres</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Tout réinitialiser</translation>
    </message>
    <message>
        <source>Presets</source>
        <translation>Préréglages</translation>
    </message>
    <message>
        <source>Pictures of this step with other values</source>
        <translation>Des vues de cette étape avec d’autres valeurs</translation>
    </message>
    <message>
        <source>Reset every parameter to its start value in this step</source>
        <translation>Remettre chaque paramètre à sa valeur de départ dans cette étape</translation>
    </message>
    <message>
        <source>Nothing to reset: every parameter has its start value.</source>
        <translation>Rien à réinitialiser&#xa0;: chaque paramètre a sa valeur de départ.</translation>
    </message>
    <message>
        <source>Show fewer parameters</source>
        <translation>Afficher moins de paramètres</translation>
    </message>
    <message>
        <source>Show all parameters</source>
        <translation>Afficher tous les paramètres</translation>
    </message>
    <message>
        <source>%1, shown</source>
        <translation>%1, déplié</translation>
    </message>
    <message>
        <source>%1, folded</source>
        <translation>%1, replié</translation>
    </message>
</context>
<context>
    <name>app::ParameterRow</name>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1, slider</source>
        <translation>%1, curseur</translation>
    </message>
    <message>
        <source>Reset to %1</source>
        <translation>Remettre à %1</translation>
    </message>
    <message>
        <source>Reset %1 to %2</source>
        <translation>Remettre %1 à %2</translation>
    </message>
    <message>
        <source>It can be %1 to %2%3.</source>
        <translation>Valeurs possibles&#xa0;: %1 à %2%3.</translation>
    </message>
    <message>
        <source>%1 can be %2 to %3.</source>
        <translation>%1 peut aller de %2 à %3.</translation>
    </message>
</context>
<context>
    <name>app::Playback</name>
    <message>
        <source>The run plays while you drag. Press Space to stop it.</source>
        <translation>La simulation continue pendant que tu fais glisser. Appuie sur Espace pour l’arrêter.</translation>
    </message>
    <message>
        <source>The run is paused. Press Space to play from here.</source>
        <translation>La simulation est en pause. Appuie sur Espace pour la lancer à partir d’ici.</translation>
    </message>
    <message>
        <source>Too much to compute at 30 frames a second: the run plays more slowly. Its numbers stay the same.</source>
        <translation>Trop à calculer pour 30 images par seconde&#xa0;: la simulation va plus lentement. Ses nombres restent les mêmes.</translation>
    </message>
</context>
<context>
    <name>app::PlotCard</name>
    <message>
        <source>Plotted quantity</source>
        <translation>Grandeur tracée</translation>
    </message>
    <message>
        <source>The other axis: time, or another quantity</source>
        <translation>L’autre axe&#xa0;: le temps, ou une autre grandeur</translation>
    </message>
    <message>
        <source>Save, copy, keep or remove this plot</source>
        <translation>Enregistrer, copier, épingler ou supprimer ce graphique</translation>
    </message>
    <message>
        <source>Actions for this plot</source>
        <translation>Actions pour ce graphique</translation>
    </message>
    <message>
        <source>against</source>
        <translation>en fonction de</translation>
    </message>
    <message>
        <source>&amp;Pin to %1</source>
        <translation>É&amp;pingler à %1</translation>
    </message>
    <message>
        <source>If off, the plot follows the body that is selected in the picture</source>
        <translation>Sinon, le graphique suit le corps sélectionné dans la vue</translation>
    </message>
    <message>
        <source>&amp;Fewer frames	+</source>
        <translation>&amp;Moins d’images	+</translation>
    </message>
    <message>
        <source>&amp;More frames	−</source>
        <translation>P&amp;lus d’images	−</translation>
    </message>
    <message>
        <source>&amp;Remove this plot	Del</source>
        <translation>&amp;Supprimer le graphique	Suppr</translation>
    </message>
</context>
<context>
    <name>app::PlotExport</name>
    <message>
        <source>Save the &amp;picture…</source>
        <translation>Enregistrer la &amp;capture…</translation>
    </message>
    <message>
        <source>&amp;Copy the picture</source>
        <translation>C&amp;opier la capture</translation>
    </message>
    <message>
        <source>As PNG, SVG or PDF</source>
        <translation>En PNG, SVG ou PDF</translation>
    </message>
    <message>
        <source>Save the &amp;numbers as CSV…</source>
        <translation>Enregistrer les &amp;nombres en CSV…</translation>
    </message>
    <message>
        <source>Every frame of the run, with all digits</source>
        <translation>Chaque image de la simulation, avec tous les chiffres</translation>
    </message>
    <message>
        <source>Save or copy this plot</source>
        <translation>Enregistrer ou copier ce graphique</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>Enregistré&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Could not save the picture as %1: %2. Choose another folder, or free some disk space.</source>
        <translation>Impossible d’enregistrer la capture dans %1&#xa0;: %2. Choisis un autre dossier, ou libère de l’espace disque.</translation>
    </message>
    <message>
        <source>The picture is copied: paste it anywhere.</source>
        <translation>La capture est copiée&#xa0;: colle-la où tu veux.</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Enregistrer la capture</translation>
    </message>
    <message>
        <source>Pictures (*.png *.svg *.pdf)</source>
        <translation>Captures (*.png *.svg *.pdf)</translation>
    </message>
    <message>
        <source>Save the numbers</source>
        <translation>Enregistrer les nombres</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>Tableaux (*.csv)</translation>
    </message>
    <message>
        <source>There are no numbers to save, because this plot is empty. Play the run first.</source>
        <translation>Il n’y a pas de nombres à enregistrer, car ce graphique est vide. Lance d’abord la simulation.</translation>
    </message>
    <message>
        <source>Cancelled: nothing was saved.</source>
        <translation>Annulé&#xa0;: rien n’a été enregistré.</translation>
    </message>
    <message>
        <source>All values that are counted or measured here, with all digits</source>
        <translation>Toutes les valeurs comptées ou mesurées ici, avec tous les chiffres</translation>
    </message>
    <message>
        <source>Could not save the numbers as %1: %2. Choose another folder, or free some disk space.</source>
        <translation>Impossible d’enregistrer les nombres dans %1&#xa0;: %2. Choisis un autre dossier, ou libère de l’espace disque.</translation>
    </message>
</context>
<context>
    <name>app::PlotValue</name>
    <message>
        <source>The number at the cursor</source>
        <translation>Le nombre au curseur</translation>
    </message>
</context>
<context>
    <name>app::PlotsPanel</name>
    <message>
        <source>Plots</source>
        <translation>Graphiques</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Another plot</source>
        <translation>Un autre graphique</translation>
    </message>
    <message>
        <source>Add a plot</source>
        <translation>Ajouter un graphique</translation>
    </message>
    <message>
        <source>There is no plot yet. &lt;b&gt;Add&lt;/b&gt;, above, has curves to start with: the position of a body, its speed, or one quantity against another.</source>
        <translation>Il n’y a pas encore de graphique. &lt;b&gt;Ajouter&lt;/b&gt;, en haut, propose des courbes pour commencer&#xa0;: la position d’un corps, sa vitesse, ou une grandeur en fonction d’une autre.</translation>
    </message>
    <message>
        <source>Progress of saving</source>
        <translation>Progression de l’enregistrement</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Cancel; nothing is saved then</source>
        <translation>Annuler&#x202f;; rien n’est alors enregistré</translation>
    </message>
    <message>
        <source>Saving numbers…</source>
        <translation>Enregistrement des nombres…</translation>
    </message>
    <message>
        <source>There are %1 plots: more would be too small to read. Remove one first.</source>
        <translation>Il y a %1 graphiques&#xa0;: davantage seraient trop petits à lire. Supprimes-en un d’abord.</translation>
    </message>
    <message>
        <source>%1 against time</source>
        <translation>%1 en fonction du temps</translation>
    </message>
    <message>
        <source>the path: y against x</source>
        <translation>la trajectoire&#xa0;: y en fonction de x</translation>
    </message>
    <message>
        <source>velocity y against y</source>
        <translation>vitesse y en fonction de y</translation>
    </message>
    <message>
        <source>turning speed against angle</source>
        <translation>vitesse angulaire en fonction de l’angle</translation>
    </message>
    <message>
        <source>For anything else, add a plot and choose what it shows</source>
        <translation>Pour tout le reste, ajoute un graphique et choisis ce qu’il montre</translation>
    </message>
    <message>
        <source>The names above a plot are menus</source>
        <translation>Les noms au-dessus d’un graphique sont des menus</translation>
    </message>
    <message>
        <source>the whole run</source>
        <translation>toute la simulation</translation>
    </message>
    <message>
        <source>frame %1 to %2</source>
        <translation>image %1 à %2</translation>
    </message>
</context>
<context>
    <name>app::PredictionBox</name>
    <message>
        <source>Fold this prediction</source>
        <translation>Replier cette prédiction</translation>
    </message>
    <message>
        <source>Predict what happens</source>
        <translation>Prédire ce qui se passe</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>images</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>Type your prediction. Enter plays the run.</source>
        <translation>Tape ta prédiction. Entrée lance la simulation.</translation>
    </message>
    <message>
        <source>Your prediction</source>
        <translation>Ta prédiction</translation>
    </message>
    <message>
        <source>Your prediction, %1</source>
        <translation>Ta prédiction, %1</translation>
    </message>
    <message>
        <source>Choose the place</source>
        <translation>Choisir l’endroit</translation>
    </message>
    <message>
        <source>Shows how the run begins. Then click a place, or move the cross with the arrow keys.</source>
        <translation>Montre comment la simulation commence. Clique ensuite à un endroit, ou déplace la croix avec les flèches.</translation>
    </message>
    <message>
        <source>Play it</source>
        <translation>Lancer</translation>
    </message>
    <message>
        <source>Predict again</source>
        <translation>Prédire à nouveau</translation>
    </message>
    <message>
        <source>Forgets this answer, so that you can give another one</source>
        <translation>Oublie cette réponse, pour que tu puisses en donner une autre</translation>
    </message>
    <message>
        <source>Watch the run. It stops by itself.</source>
        <translation>Regarde la simulation. Elle s’arrête d’elle-même.</translation>
    </message>
    <message>
        <source>One moment …</source>
        <translation>Un instant…</translation>
    </message>
    <message>
        <source>The run was changed on the way. Play it again to see how it ends.</source>
        <translation>La simulation a été modifiée en cours de route. Relance-la pour voir comment elle finit.</translation>
    </message>
    <message>
        <source>Your cross is at **%1**.</source>
        <translation>Ta croix est en **%1**.</translation>
    </message>
    <message>
        <source>Click in the scene, or move the cross with the arrow keys.</source>
        <translation>Clique dans la scène, ou déplace la croix avec les flèches.</translation>
    </message>
    <message>
        <source>Move the cross</source>
        <translation>Déplacer la croix</translation>
    </message>
    <message>
        <source>Plays the run, and compares it with your prediction. Undo brings your own run back.</source>
        <translation>Lance la simulation, et la compare à ta prédiction. Annuler ramène ta propre simulation.</translation>
    </message>
    <message>
        <source>Predict first.</source>
        <translation>Prédis d’abord.</translation>
    </message>
    <message>
        <source>Answered. Fold this prediction</source>
        <translation>Répondu. Replier cette prédiction</translation>
    </message>
    <message>
        <source>Answered. Show it again</source>
        <translation>Répondu. La montrer à nouveau</translation>
    </message>
    <message>
        <source>%1, answered</source>
        <translation>%1, répondu</translation>
    </message>
</context>
<context>
    <name>app::PredictionDesk</name>
    <message>
        <source>Prediction</source>
        <translation>Prédiction</translation>
    </message>
    <message>
        <source>the prediction</source>
        <translation>la prédiction</translation>
    </message>
    <message>
        <source>prediction</source>
        <translation>prédiction</translation>
    </message>
</context>
<context>
    <name>app::PresetGallery</name>
    <message>
        <source>Presets</source>
        <translation>Préréglages</translation>
    </message>
    <message>
        <source>%1 Restarts this step.</source>
        <translation>%1 Recommence cette étape.</translation>
    </message>
</context>
<context>
    <name>app::ProjectBox</name>
    <message>
        <source>Start</source>
        <translation>Commencer</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>Opens what you have built so far</source>
        <translation>Ouvre ce que tu as construit jusqu’ici</translation>
    </message>
    <message>
        <source>Put away</source>
        <translation>Ranger</translation>
    </message>
    <message>
        <source>Removes this project from here. What you built stays.</source>
        <translation>Retire ce projet d’ici. Ce que tu as construit reste.</translation>
    </message>
    <message>
        <source>Fold the project</source>
        <translation>Replier le projet</translation>
    </message>
    <message>
        <source>Show the brief and the levels of the project</source>
        <translation>Afficher l’énoncé et les paliers du projet</translation>
    </message>
    <message>
        <source>Project: %1</source>
        <translation>Projet&#xa0;: %1</translation>
    </message>
    <message>
        <source>Levels that you have passed</source>
        <translation>Paliers que tu as réussis</translation>
    </message>
    <message>
        <source>Start again</source>
        <translation>Recommencer</translation>
    </message>
    <message>
        <source>Opens the start scene of this project. Undo brings back what is there now.</source>
        <translation>Ouvre la scène de départ de ce projet. Annuler ramène ce qui est là maintenant.</translation>
    </message>
</context>
<context>
    <name>app::ProjectDesk</name>
    <message>
        <source>Start “%1”</source>
        <translation>Commencer «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>The start scene is open. Undo brings your scene back.</source>
        <translation>La scène de départ est ouverte. Annuler ramène ta scène.</translation>
    </message>
</context>
<context>
    <name>app::PropertyRow</name>
    <message>
        <source>%1 From %2 to %3.</source>
        <translation>%1 De %2 à %3.</translation>
    </message>
    <message>
        <source>different</source>
        <translation>différent</translation>
    </message>
    <message>
        <source>Change %1 of %2</source>
        <translation>Changer %1&#xa0;: %2</translation>
    </message>
    <message>
        <source>Switch “%1” on</source>
        <translation>Activer «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Switch “%1” off</source>
        <translation>Désactiver «&#x202f;%1&#x202f;»</translation>
    </message>
</context>
<context>
    <name>app::QuantityMenu</name>
    <message>
        <source>… and %1 more</source>
        <translation>… et %1 de plus</translation>
    </message>
    <message>
        <source>Select one in the picture, then pin the plot to it</source>
        <translation>Sélectionnes-en un dans la vue, puis épingle le graphique dessus</translation>
    </message>
    <message>
        <source>distance to</source>
        <translation>distance à</translation>
    </message>
    <message>
        <source>of which body</source>
        <translation>de quel corps</translation>
    </message>
    <message>
        <source>the selected one: %1</source>
        <translation>du corps sélectionné&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>app::QuantityPlot</name>
    <message>
        <source>%1 against %2</source>
        <translation>%1 en fonction de %2</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>%1: %2 at frame %3</source>
        <translation>%1&#xa0;: %2 à l’image %3</translation>
    </message>
    <message>
        <source>Play, or step one frame, to start a curve here.</source>
        <translation>Lance la lecture, ou avance d’une image, pour commencer une courbe ici.</translation>
    </message>
    <message>
        <source>frame</source>
        <translation>image</translation>
    </message>
    <message>
        <source>%1: %2 inside frame %3</source>
        <translation>%1&#xa0;: %2 à l’intérieur de l’image %3</translation>
    </message>
</context>
<context>
    <name>app::RecallBox</name>
    <message>
        <source>The question before</source>
        <translation>La question précédente</translation>
    </message>
    <message>
        <source>The next question</source>
        <translation>La question suivante</translation>
    </message>
    <message>
        <source>Do it in the scene</source>
        <translation>Le faire dans la scène</translation>
    </message>
    <message>
        <source>Opens the scene. Your run of that step stays under “Runs”.</source>
        <translation>Ouvre la scène. Ta simulation de cette étape reste dans «&#x202f;Simulations&#x202f;».</translation>
    </message>
    <message>
        <source>**Right.** %1</source>
        <translation>**Juste.** %1</translation>
    </message>
    <message>
        <source>**Not this one.** %1</source>
        <translation>**Pas celle-ci.** %1</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Le refaire</translation>
    </message>
    <message>
        <source>Question %1 of %2</source>
        <translation>Question %1 sur %2</translation>
    </message>
</context>
<context>
    <name>app::RecallDesk</name>
    <message>
        <source>There is no step %1.</source>
        <translation>Il n’y a pas d’étape %1.</translation>
    </message>
    <message>
        <source>Set the scene up</source>
        <translation>Préparer la scène</translation>
    </message>
    <message>
        <source>your run</source>
        <translation>ta simulation</translation>
    </message>
    <message>
        <source>there is no step %1. Write “- step: lesson/step”.</source>
        <translation>il n’y a pas d’étape %1. Écris «&#x202f;- step: lesson/step&#x202f;».</translation>
    </message>
</context>
<context>
    <name>app::RecallPage</name>
    <message>
        <source>Do it in the scene</source>
        <translation>Le faire dans la scène</translation>
    </message>
    <message>
        <source>Set the scene up again</source>
        <translation>Repréparer la scène</translation>
    </message>
    <message>
        <source>Begins the run again as it was when this question opened</source>
        <translation>Recommence la simulation telle qu’elle était à l’ouverture de cette question</translation>
    </message>
    <message>
        <source>Back to the questions</source>
        <translation>Retour aux questions</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Back to the questions of the lesson. You can answer this one later.</source>
        <translation>Retour aux questions de la leçon. Tu pourras répondre à celle-ci plus tard.</translation>
    </message>
    <message>
        <source>**Done** ✓</source>
        <translation>**Fait** ✓</translation>
    </message>
    <message>
        <source>Not done yet. Springstep sees it when you have done it.</source>
        <translation>Pas encore fait. Springstep le voit quand tu l’as fait.</translation>
    </message>
</context>
<context>
    <name>app::RecoveryList</name>
    <message>
        <source>%1: %2 (not installed)</source>
        <translation>%1&#xa0;: %2 (non installé)</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Recover scenes</source>
        <translation>Récupérer des scènes</translation>
    </message>
    <message>
        <source>These scenes were not saved. Recover one to continue with it.</source>
        <translation>Ces scènes n’ont pas été enregistrées. Récupères-en une pour la continuer.</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>Images</translation>
    </message>
    <message>
        <source>Last changed</source>
        <translation>Modifiée</translation>
    </message>
    <message>
        <source>Scenes that were not saved</source>
        <translation>Scènes qui n’ont pas été enregistrées</translation>
    </message>
    <message>
        <source>Continue with the selected scene (Return)</source>
        <translation>Continuer avec la scène sélectionnée (Entrée)</translation>
    </message>
    <message>
        <source>Delete the selected scene for good (Del)</source>
        <translation>Supprimer définitivement la scène sélectionnée (Suppr)</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Keep them all for later (Esc)</source>
        <translation>Les garder toutes pour plus tard (Échap)</translation>
    </message>
    <message>
        <source>damaged</source>
        <translation>endommagée</translation>
    </message>
</context>
<context>
    <name>app::RecoveryPrompt</name>
    <message>
        <source>“%1: %2”</source>
        <translation>«&#x202f;%1&#xa0;: %2&#x202f;»</translation>
    </message>
    <message>
        <source>Springstep did not close normally. Your scene of %1 from %2 can be recovered.</source>
        <translation>Springstep ne s’est pas fermé normalement. Ta scène de %1 (%2) peut être récupérée.</translation>
    </message>
    <message>
        <source>Your scene of %1 from %2 was not saved. It can be recovered.</source>
        <translation>Ta scène de %1 (%2) n’a pas été enregistrée. Elle peut être récupérée.</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>Continue with this scene</source>
        <translation>Continuer avec cette scène</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Supprimer</translation>
    </message>
    <message>
        <source>Delete this scene for good</source>
        <translation>Supprimer définitivement cette scène</translation>
    </message>
    <message>
        <source>Springstep did not close normally. %1 unsaved scenes can be recovered.</source>
        <translation>Springstep ne s’est pas fermé normalement. %1 scènes non enregistrées peuvent être récupérées.</translation>
    </message>
    <message>
        <source>%1 unsaved scenes can be recovered.</source>
        <translation>%1 scènes non enregistrées peuvent être récupérées.</translation>
    </message>
    <message>
        <source>Show them</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>Shows a list, from which each can be recovered or deleted</source>
        <translation>Affiche une liste où chacune peut être récupérée ou supprimée</translation>
    </message>
    <message>
        <source>There is no scene to recover.</source>
        <translation>Il n’y a pas de scène à récupérer.</translation>
    </message>
</context>
<context>
    <name>app::RemedySearch</name>
    <message>
        <source>Computes the run again with this change, up to this frame. Your input is kept, and the old run stays as a ghost.</source>
        <translation>Recalcule la simulation avec ce changement, jusqu’à cette image. Tes actions sont conservées, et l’ancienne simulation reste comme fantôme.</translation>
    </message>
    <message>
        <source>Not tested: that would take too long.</source>
        <translation>Pas testé&#xa0;: cela prendrait trop de temps.</translation>
    </message>
    <message numerus="yes">
        <source>Tested: it is stable for %n frames.</source>
        <translation>
            <numerusform>Testé&#xa0;: stable pendant %n image.</numerusform>
            <numerusform>Testé&#xa0;: stable pendant %n images.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::Restart</name>
    <message>
        <source>%1 A film is being made.</source>
        <translation>%1 Un film est en cours de création.</translation>
    </message>
    <message>
        <source>%1 A web page is being made.</source>
        <translation>%1 Une page web est en cours de création.</translation>
    </message>
    <message>
        <source>Restart now</source>
        <translation>Redémarrer</translation>
    </message>
    <message>
        <source>Cancels the film; everything else is kept</source>
        <translation>Annule le film&#x202f;; tout le reste est conservé</translation>
    </message>
    <message>
        <source>Cancels the page; everything else is kept</source>
        <translation>Annule la page&#x202f;; tout le reste est conservé</translation>
    </message>
</context>
<context>
    <name>app::RulePanel</name>
    <message>
        <source>Delete rule</source>
        <translation>Supprimer la règle</translation>
    </message>
    <message>
        <source>Switch on</source>
        <translation>Activer</translation>
    </message>
    <message>
        <source>Let your rule act again, from frame 0 on</source>
        <translation>Laisser ta règle agir à nouveau, à partir de l’image 0</translation>
    </message>
    <message>
        <source>Delete your rule and start over (Undo brings it back)</source>
        <translation>Supprimer ta règle et recommencer (Annuler la ramène)</translation>
    </message>
    <message>
        <source>There is no rule yet.</source>
        <translation>Il n’y a pas encore de règle.</translation>
    </message>
    <message>
        <source>No rule acts yet. Your code acts as soon as you stop typing.</source>
        <translation>Aucune règle n’agit encore. Ton code agit dès que tu arrêtes d’écrire.</translation>
    </message>
    <message>
        <source>Your rule is switched off.</source>
        <translation>Ta règle est désactivée.</translation>
    </message>
    <message>
        <source>Your last rule without a mistake still acts.</source>
        <translation>Ta dernière règle sans erreur agit toujours.</translation>
    </message>
    <message>
        <source>force acts on every body.</source>
        <translation>force agit sur chaque corps.</translation>
    </message>
    <message>
        <source>pull acts along rule links, and there are none yet.</source>
        <translation>pull agit le long des liaisons de règle, et il n’y en a pas encore.</translation>
    </message>
    <message numerus="yes">
        <source>pull acts along %n rule links.</source>
        <translation>
            <numerusform>pull agit le long de %n liaison de règle.</numerusform>
            <numerusform>pull agit le long de %n liaisons de règle.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::RunCommands</name>
    <message>
        <source>&amp;Play or pause</source>
        <translation>&amp;Lecture ou pause</translation>
    </message>
    <message>
        <source>Next &amp;frame</source>
        <translation>&amp;Image suivante</translation>
    </message>
    <message>
        <source>Frame &amp;back</source>
        <translation>I&amp;mage précédente</translation>
    </message>
    <message>
        <source>&amp;Next phase</source>
        <translation>&amp;Phase suivante</translation>
    </message>
    <message>
        <source>P&amp;hase back</source>
        <translation>P&amp;hase précédente</translation>
    </message>
    <message>
        <source>Re&amp;start</source>
        <translation>&amp;Recommencer</translation>
    </message>
    <message>
        <source>Repea&amp;t the run with the same input</source>
        <translation>Répé&amp;ter la simulation avec les mêmes actions</translation>
    </message>
    <message>
        <source>To th&amp;e last computed frame</source>
        <translation>À la d&amp;ernière image calculée</translation>
    </message>
    <message>
        <source>Go to frame…</source>
        <translation>Aller à l’image…</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>R&amp;alentir</translation>
    </message>
    <message>
        <source>Faste&amp;r</source>
        <translation>A&amp;ccélérer</translation>
    </message>
    <message>
        <source>Reset run &amp;and parameters</source>
        <translation>Réinitialiser &amp;simulation et paramètres</translation>
    </message>
    <message>
        <source>Delete the &amp;old run</source>
        <translation>S&amp;upprimer l’ancienne simulation</translation>
    </message>
    <message>
        <source>Choose another run…</source>
        <translation>Choisir une autre simulation…</translation>
    </message>
    <message>
        <source>&amp;Compare two runs</source>
        <translation>Comparer &amp;deux simulations</translation>
    </message>
    <message>
        <source>Ne&amp;xt step</source>
        <translation>Étape sui&amp;vante</translation>
    </message>
    <message>
        <source>Pre&amp;vious step</source>
        <translation>Étape précéde&amp;nte</translation>
    </message>
    <message>
        <source>One phase forward</source>
        <translation>Une phase en avant</translation>
    </message>
    <message>
        <source>One phase back</source>
        <translation>Une phase en arrière</translation>
    </message>
    <message>
        <source>Go to a frame</source>
        <translation>Aller à une image</translation>
    </message>
    <message>
        <source>The distance between the two runs, frame by frame</source>
        <translation>L’écart entre les deux simulations, image par image</translation>
    </message>
    <message>
        <source>This is frame 0, the first frame.</source>
        <translation>C’est l’image 0, la première image.</translation>
    </message>
    <message>
        <source>One frame back</source>
        <translation>Une image en arrière</translation>
    </message>
    <message>
        <source>One frame forward</source>
        <translation>Une image en avant</translation>
    </message>
    <message>
        <source>Stop here</source>
        <translation>Arrêter ici</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lecture</translation>
    </message>
    <message>
        <source>%1 repeats this run instead, with the same input.</source>
        <translation>%1 répète plutôt cette simulation, avec les mêmes actions.</translation>
    </message>
    <message>
        <source>Other runs: none yet</source>
        <translation>Autres simulations&#xa0;: aucune</translation>
    </message>
    <message>
        <source>Other runs: one</source>
        <translation>Autres simulations&#xa0;: une</translation>
    </message>
    <message>
        <source>Other runs: %1</source>
        <translation>Autres simulations&#xa0;: %1</translation>
    </message>
    <message>
        <source>To the start of this frame</source>
        <translation>Au début de cette image</translation>
    </message>
    <message>
        <source>To the end of this frame</source>
        <translation>À la fin de cette image</translation>
    </message>
    <message>
        <source>Starts a new run from frame 0, with the current parameters.</source>
        <translation>Démarre une nouvelle simulation à partir de l’image 0, avec les paramètres actuels.</translation>
    </message>
    <message>
        <source>Go back in time and change something: the old run then appears here.</source>
        <translation>Remonte le temps et change quelque chose&#xa0;: l’ancienne simulation apparaît alors ici.</translation>
    </message>
    <message>
        <source>Step over calls</source>
        <translation>Sauter les appels</translation>
    </message>
    <message>
        <source>Step out of the call</source>
        <translation>Sortir de l’appel</translation>
    </message>
    <message>
        <source>Run the next line with all functions that it calls</source>
        <translation>Exécuter la ligne suivante avec toutes les fonctions qu’elle appelle</translation>
    </message>
    <message>
        <source>Run to the end of the function, or of the frame</source>
        <translation>Exécuter jusqu’à la fin de la fonction, ou de l’image</translation>
    </message>
    <message>
        <source>&amp;Next line</source>
        <translation>Li&amp;gne suivante</translation>
    </message>
    <message>
        <source>One line forward</source>
        <translation>Une ligne en avant</translation>
    </message>
    <message>
        <source>Line bac&amp;k</source>
        <translation>Ligne &amp;précédente</translation>
    </message>
    <message>
        <source>One line back</source>
        <translation>Une ligne en arrière</translation>
    </message>
    <message>
        <source>Open the Listing page of the code to go line by line.</source>
        <translation>Ouvre la page «&#x202f;Listing&#x202f;» du code pour avancer ligne par ligne.</translation>
    </message>
</context>
<context>
    <name>app::RunEditor</name>
    <message>
        <source>The old run stays beside this one as “%1”.</source>
        <translation>L’ancienne simulation reste à côté de celle-ci&#xa0;: «&#x202f;%1&#x202f;».</translation>
    </message>
    <message>
        <source>Choose “%1”</source>
        <translation>Choisir «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>Reset run and parameters</source>
        <translation>Réinitialiser simulation et paramètres</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Recommencer</translation>
    </message>
    <message>
        <source>the restart</source>
        <translation>le redémarrage</translation>
    </message>
    <message>
        <source>A new run. The old one is in “Runs”; Undo brings it back.</source>
        <translation>Une nouvelle simulation. L’ancienne est dans «&#x202f;Simulations&#x202f;»&#x202f;; Annuler la ramène.</translation>
    </message>
    <message>
        <source>the first run</source>
        <translation>la première simulation</translation>
    </message>
    <message>
        <source>Go back to “%1”</source>
        <translation>Revenir à «&#x202f;%1&#x202f;»</translation>
    </message>
    <message>
        <source>“%1” is the current run again. The run that you left is now in “Runs”.</source>
        <translation>«&#x202f;%1&#x202f;» est de nouveau la simulation actuelle. Celle que tu as quittée est maintenant dans «&#x202f;Simulations&#x202f;».</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>Annulé&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>Rétabli&#xa0;: %1.</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Changer %1</translation>
    </message>
    <message>
        <source>Reset all parameters</source>
        <translation>Réinitialiser tous les paramètres</translation>
    </message>
    <message>
        <source>Change step</source>
        <translation>Changer le pas de temps</translation>
    </message>
    <message>
        <source>Change method</source>
        <translation>Changer la méthode</translation>
    </message>
    <message>
        <source>Apply remedy</source>
        <translation>Appliquer le remède</translation>
    </message>
    <message>
        <source>a remedy</source>
        <translation>un remède</translation>
    </message>
    <message>
        <source>%1 off</source>
        <translation>%1 désactivé</translation>
    </message>
    <message>
        <source>%1 on</source>
        <translation>%1 activé</translation>
    </message>
</context>
<context>
    <name>app::RunPlot</name>
    <message>
        <source>Error over the run</source>
        <translation>Erreur au fil de la simulation</translation>
    </message>
    <message>
        <source>error, px</source>
        <translation>erreur, px</translation>
    </message>
    <message>
        <source>Frame %1: error %2</source>
        <translation>Image %1&#xa0;: erreur %2</translation>
    </message>
</context>
<context>
    <name>app::RunsMenu</name>
    <message>
        <source>Other r&amp;uns</source>
        <translation>Autres simulati&amp;ons</translation>
    </message>
    <message>
        <source>No other run yet</source>
        <translation>Pas encore d’autre simulation</translation>
    </message>
    <message>
        <source>Go back in time and change something: the old run then stays as another run.</source>
        <translation>Remonte le temps et change quelque chose&#xa0;: l’ancienne simulation reste alors à côté.</translation>
    </message>
    <message>
        <source>&amp;Hide the other run</source>
        <translation>&amp;Masquer l’autre simulation</translation>
    </message>
    <message>
        <source>Shows only this run; the others stay in this menu</source>
        <translation>N’affiche que cette simulation&#x202f;; les autres restent dans ce menu</translation>
    </message>
    <message>
        <source>&amp;Compare in numbers</source>
        <translation>&amp;Comparer en chiffres</translation>
    </message>
    <message>
        <source>The distance between the two runs, frame by frame</source>
        <translation>L’écart entre les deux simulations, image par image</translation>
    </message>
    <message>
        <source>&amp;Show beside</source>
        <translation>&amp;Afficher à côté</translation>
    </message>
    <message>
        <source>As a ghost in the picture, and as dots in the timeline</source>
        <translation>Comme fantôme dans la vue, et en points dans la ligne de temps</translation>
    </message>
    <message>
        <source>&amp;Go back to it</source>
        <translation>&amp;Y revenir</translation>
    </message>
    <message>
        <source>Makes it the current run again, exactly as it was; this run becomes another run</source>
        <translation>En refait la simulation actuelle, exactement telle qu’elle était&#x202f;; celle-ci devient une autre simulation</translation>
    </message>
    <message>
        <source>&amp;Keep</source>
        <translation>&amp;Garder</translation>
    </message>
    <message>
        <source>Keeps this run until you delete it. Of the other runs, only the last %1 stay.</source>
        <translation>Garde cette simulation jusqu’à ce que tu la supprimes. Des autres, seules les %1 dernières restent.</translation>
    </message>
    <message>
        <source>&amp;Rename…</source>
        <translation>&amp;Renommer…</translation>
    </message>
    <message>
        <source>Give this run another name</source>
        <translation>Donner un autre nom à cette simulation</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Supprimer</translation>
    </message>
    <message>
        <source>Deletes this run; Undo brings it back</source>
        <translation>Supprime cette simulation&#x202f;; Annuler la ramène</translation>
    </message>
</context>
<context>
    <name>app::SandboxCommands</name>
    <message>
        <source>&amp;Take this scene to the sandbox</source>
        <translation>R&amp;eprendre cette scène dans le bac à sable</translation>
    </message>
    <message>
        <source>&amp;Delete selection</source>
        <translation>&amp;Supprimer la sélection</translation>
    </message>
    <message>
        <source>Dup&amp;licate selection</source>
        <translation>&amp;Dupliquer la sélection</translation>
    </message>
    <message>
        <source>Select &amp;all</source>
        <translation>&amp;Tout sélectionner</translation>
    </message>
    <message>
        <source>Continue building this scene in the sandbox</source>
        <translation>Continuer à construire cette scène dans le bac à sable</translation>
    </message>
    <message>
        <source>Select and move parts</source>
        <translation>Sélectionner et déplacer des éléments</translation>
    </message>
    <message>
        <source>Select</source>
        <translation>Sélection</translation>
    </message>
    <message>
        <source>Add points</source>
        <translation>Ajouter des points</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Add a body with a mass and a size</source>
        <translation>Ajouter un corps avec une masse et une taille</translation>
    </message>
    <message>
        <source>Nail points down</source>
        <translation>Clouer des points</translation>
    </message>
    <message>
        <source>Nail</source>
        <translation>Clou</translation>
    </message>
    <message>
        <source>Fix a point in place, or free it</source>
        <translation>Fixer un point sur place, ou le libérer</translation>
    </message>
    <message>
        <source>Add springs</source>
        <translation>Ajouter des ressorts</translation>
    </message>
    <message>
        <source>Spring</source>
        <translation>Ressort</translation>
    </message>
    <message>
        <source>Connect two points with a spring, which pulls and pushes them to its length</source>
        <translation>Relier deux points par un ressort, qui les tire et les pousse vers sa longueur</translation>
    </message>
    <message>
        <source>Add sticks</source>
        <translation>Ajouter des tiges</translation>
    </message>
    <message>
        <source>Stick</source>
        <translation>Tige</translation>
    </message>
    <message>
        <source>Connect two points with a stick, which keeps its length</source>
        <translation>Relier deux points par une tige, qui garde sa longueur</translation>
    </message>
    <message>
        <source>Add feet</source>
        <translation>Ajouter des pieds</translation>
    </message>
    <message>
        <source>Foot</source>
        <translation>Pied</translation>
    </message>
    <message>
        <source>Give a body a foot, at an angle from the body</source>
        <translation>Donner un pied à un corps, à un certain angle du corps</translation>
    </message>
    <message>
        <source>The sandbox is not installed</source>
        <translation>Le bac à sable n’est pas installé</translation>
    </message>
    <message>
        <source>This scene is already in the sandbox</source>
        <translation>Cette scène est déjà dans le bac à sable</translation>
    </message>
    <message>
        <source>Select parts, and drag them to another place</source>
        <translation>Sélectionner des éléments et les faire glisser ailleurs</translation>
    </message>
    <message>
        <source>&amp;My rule</source>
        <translation>&amp;Ma règle</translation>
    </message>
    <message>
        <source>My rule</source>
        <translation>Ma règle</translation>
    </message>
    <message>
        <source>Write a force of your own for this scene</source>
        <translation>Écrire ta propre force pour cette scène</translation>
    </message>
    <message>
        <source>Lin&amp;k selection by my rule</source>
        <translation>&amp;Lier la sélection par ma règle</translation>
    </message>
    <message>
        <source>Link all</source>
        <translation>Tout lier</translation>
    </message>
    <message>
        <source>Add a rule link between each two of the selected points</source>
        <translation>Ajouter une liaison de règle entre chaque paire de points sélectionnés</translation>
    </message>
    <message>
        <source>Add rule links</source>
        <translation>Ajouter des liaisons de règle</translation>
    </message>
    <message>
        <source>Rule link</source>
        <translation>Liaison</translation>
    </message>
    <message>
        <source>Connect two points by the function pull of your rule</source>
        <translation>Relier deux points par la fonction pull de ta règle</translation>
    </message>
</context>
<context>
    <name>app::SandboxEditor</name>
    <message>
        <source>The scene has too many of this kind. Delete some first.</source>
        <translation>La scène en a trop de cette sorte. Supprimes-en d’abord.</translation>
    </message>
    <message>
        <source>This point is already a foot, and a point can be the foot of only one body. Choose another point.</source>
        <translation>Ce point est déjà un pied, et un point ne peut être le pied que d’un seul corps. Choisis un autre point.</translation>
    </message>
    <message>
        <source>A scene needs at least one point that can move. Leave one free.</source>
        <translation>Une scène a besoin d’au moins un point qui peut bouger. Laisses-en un libre.</translation>
    </message>
    <message>
        <source>With this copy, the scene would have too many parts. Select fewer parts, or delete some first.</source>
        <translation>Avec cette copie, la scène aurait trop d’éléments. Sélectionnes-en moins, ou supprimes-en d’abord.</translation>
    </message>
    <message>
        <source>%1 parts</source>
        <translation>%1 éléments</translation>
    </message>
    <message>
        <source>stick</source>
        <translation>tige</translation>
    </message>
    <message>
        <source>spring</source>
        <translation>ressort</translation>
    </message>
    <message>
        <source>Add point</source>
        <translation>Ajouter un point</translation>
    </message>
    <message>
        <source>Add nail</source>
        <translation>Ajouter un clou</translation>
    </message>
    <message>
        <source>Free %1</source>
        <translation>Libérer %1</translation>
    </message>
    <message>
        <source>Nail %1 down</source>
        <translation>Clouer %1</translation>
    </message>
    <message>
        <source>Add spring</source>
        <translation>Ajouter un ressort</translation>
    </message>
    <message>
        <source>Add stick</source>
        <translation>Ajouter une tige</translation>
    </message>
    <message>
        <source>Add foot</source>
        <translation>Ajouter un pied</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>Déplacer %1</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Supprimer %1</translation>
    </message>
    <message>
        <source>Duplicate %1</source>
        <translation>Dupliquer %1</translation>
    </message>
    <message>
        <source>Add gait group</source>
        <translation>Ajouter un groupe d’allure</translation>
    </message>
    <message>
        <source>rule link</source>
        <translation>liaison de règle</translation>
    </message>
    <message>
        <source>Add rule link</source>
        <translation>Ajouter une liaison de règle</translation>
    </message>
    <message>
        <source>These two points have a rule link already, and the rule acts once along it.</source>
        <translation>Ces deux points ont déjà une liaison de règle, et la règle n’agit qu’une fois le long d’elle.</translation>
    </message>
    <message>
        <source>Select at least two points first: draw a box around them.</source>
        <translation>Sélectionne d’abord au moins deux points&#xa0;: trace un cadre autour d’eux.</translation>
    </message>
    <message>
        <source>Link %1 by the rule</source>
        <translation>Lier %1 par la règle</translation>
    </message>
    <message>
        <source>All of these points have rule links already.</source>
        <translation>Tous ces points ont déjà des liaisons de règle.</translation>
    </message>
    <message>
        <source>“%1” is a parameter. Choose another name, such as “%1_1”.</source>
        <translation>«&#x202f;%1&#x202f;» est un paramètre. Choisis un autre nom, par exemple «&#x202f;%1_1&#x202f;».</translation>
    </message>
    <message>
        <source>Another point is called “%1”. Choose another name.</source>
        <translation>Un autre point s’appelle déjà «&#x202f;%1&#x202f;». Choisis un autre nom.</translation>
    </message>
    <message>
        <source>Your code computes this run, and it names the points. Choose another method first.</source>
        <translation>Ton code calcule cette simulation, et il nomme les points. Choisis d’abord une autre méthode.</translation>
    </message>
    <message>
        <source>Rename %1 to %2</source>
        <translation>Renommer %1 en %2</translation>
    </message>
</context>
<context>
    <name>app::SceneBar</name>
    <message>
        <source>How the run is computed from one step to the next</source>
        <translation>Comment la simulation est calculée d’un pas de temps au suivant</translation>
    </message>
    <message>
        <source>How much time one step of the method covers</source>
        <translation>Combien de temps couvre un pas de temps de la méthode</translation>
    </message>
    <message>
        <source>Choose what the picture shows besides the creature</source>
        <translation>Choisir ce que la vue montre en plus de la créature</translation>
    </message>
    <message>
        <source>Zoom to 100&#x2009;%</source>
        <translation>Zoom à 100&#x2009;%</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Affichage</translation>
    </message>
    <message>
        <source>Trails</source>
        <translation>Traces</translation>
    </message>
    <message>
        <source>Velocity arrows</source>
        <translation>Flèches de vitesse</translation>
    </message>
    <message>
        <source>Grid</source>
        <translation>Grille</translation>
    </message>
    <message>
        <source>Guide lines</source>
        <translation>Lignes de repère</translation>
    </message>
    <message>
        <source>Eyes</source>
        <translation>Yeux</translation>
    </message>
    <message>
        <source>Ghost</source>
        <translation>Fantôme</translation>
    </message>
    <message>
        <source>Onion skins</source>
        <translation>Pelures d’oignon</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>Référence</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Méthode</translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation>Tolérance</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>Pas de temps</translation>
    </message>
    <message>
        <source>%1&#x2009;%</source>
        <translation>%1&#x2009;%</translation>
    </message>
    <message>
        <source>Zoom %1</source>
        <translation>Zoom %1</translation>
    </message>
    <message>
        <source>All pulls</source>
        <translation>Toutes les tractions</translation>
    </message>
    <message>
        <source>Ruler</source>
        <translation>Règle graduée</translation>
    </message>
    <message>
        <source>Clock</source>
        <translation>Horloge</translation>
    </message>
    <message>
        <source>Rest lengths</source>
        <translation>Longueurs à vide</translation>
    </message>
    <message>
        <source>The largest error that the method allows in each of its steps</source>
        <translation>La plus grande erreur que la méthode admet dans chacun de ses pas de temps</translation>
    </message>
    <message>
        <source>Your code</source>
        <translation>Ton code</translation>
    </message>
    <message>
        <source>The listing, as you changed it</source>
        <translation>Le listing, tel que tu l’as modifié</translation>
    </message>
    <message>
        <source>This step has no listing.</source>
        <translation>Cette étape n’a pas de listing.</translation>
    </message>
    <message>
        <source>Unit circle</source>
        <translation>Cercle trigonométrique</translation>
    </message>
</context>
<context>
    <name>app::SceneCard</name>
    <message>
        <source>Done! You have tried everything here. %1 opens the next step.</source>
        <translation>Terminé&#x202f;! Tu as tout essayé ici. %1 ouvre l’étape suivante.</translation>
    </message>
    <message>
        <source>Done! You have tried everything here.</source>
        <translation>Terminé&#x202f;! Tu as tout essayé ici.</translation>
    </message>
</context>
<context>
    <name>app::SceneView</name>
    <message>
        <source>%1: outside of the picture. Click, or press O, to bring it into view.</source>
        <translation>%1&#xa0;: hors de la vue. Un clic, ou la touche O, le ramène dans la vue.</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Scène</translation>
    </message>
    <message>
        <source>Beside it: %1</source>
        <translation>À côté&#xa0;: %1</translation>
    </message>
    <message>
        <source>frame %1 = %2&#x2009;s</source>
        <translation>image %1 = %2&#x2009;s</translation>
    </message>
    <message>
        <source>The hand of the recorded run is at %1, %2</source>
        <translation>La main de la simulation enregistrée est en %1, %2</translation>
    </message>
    <message>
        <source>Preview. %1</source>
        <translation>Aperçu. %1</translation>
    </message>
    <message>
        <source>Preview of frame %1.</source>
        <translation>Aperçu de l’image %1.</translation>
    </message>
    <message>
        <source>The formula is about: %1</source>
        <translation>La formule porte sur&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>app::SettlingMonitor</name>
    <message>
        <source>Change %1 and %2</source>
        <translation>Changer %1 et %2</translation>
    </message>
</context>
<context>
    <name>app::SettlingPlot</name>
    <message>
        <source>Map of the time to rest</source>
        <translation>Carte du temps de stabilisation</translation>
    </message>
    <message numerus="yes">
        <source>at rest after %n frames</source>
        <translation>
            <numerusform>au repos après %n image</numerusform>
            <numerusform>au repos après %n images</numerusform>
        </translation>
    </message>
    <message>
        <source>still moving after %1 frames</source>
        <translation>encore en mouvement après %1 images</translation>
    </message>
    <message>
        <source>the motion grows without bound</source>
        <translation>le mouvement grandit sans limite</translation>
    </message>
    <message>
        <source>cannot be computed</source>
        <translation>ne peut pas être calculé</translation>
    </message>
    <message>
        <source>Click or press Enter to begin the run again with %1 %2 and %3 %4</source>
        <translation>Un clic ou Entrée recommence la simulation avec %1 %2 et %3 %4</translation>
    </message>
    <message>
        <source>Your run from its start, with all you did: how many frames after frame %1, your last input, it is at rest.</source>
        <translation>Ta simulation depuis son début, avec tout ce que tu as fait&#xa0;: combien d’images après l’image %1, ta dernière action, elle est au repos.</translation>
    </message>
    <message>
        <source>Your run from its start: after how many frames it is at rest.</source>
        <translation>Ta simulation depuis son début&#xa0;: après combien d’images elle est au repos.</translation>
    </message>
    <message>
        <source>At rest, each body stays within 1&#x2009;px of its last place, and moves less than 0.05&#x2009;px in a frame.</source>
        <translation>Au repos, chaque corps reste à moins de 1&#x2009;px de sa dernière place, et bouge de moins de 0,05&#x2009;px par image.</translation>
    </message>
    <message>
        <source>Input after frame %1 is left out.</source>
        <translation>Les actions après l’image %1 ne comptent pas.</translation>
    </message>
    <message>
        <source>%1 frames</source>
        <translation>%1 images</translation>
    </message>
    <message>
        <source>still moving</source>
        <translation>bouge encore</translation>
    </message>
    <message>
        <source>grows</source>
        <translation>grandit</translation>
    </message>
</context>
<context>
    <name>app::SizeMenu</name>
    <message>
        <source>Si&amp;ze of text and controls</source>
        <translation>Taille du te&amp;xte et des commandes</translation>
    </message>
    <message>
        <source>%1&#x2009;%</source>
        <translation>%1&#x2009;%</translation>
    </message>
    <message>
        <source>Changes text, buttons and the scene. The window opens again with all its contents</source>
        <translation>Change le texte, les boutons et la scène. La fenêtre se rouvre avec tout son contenu</translation>
    </message>
    <message>
        <source>At that size, this screen is too small for the scene and its timeline</source>
        <translation>À cette taille, cet écran est trop petit pour la scène et sa ligne de temps</translation>
    </message>
    <message>
        <source>Springstep will be drawn at %1&#x2009;% after a restart.</source>
        <translation>Springstep sera dessiné à %1&#x2009;% après un redémarrage.</translation>
    </message>
</context>
<context>
    <name>app::SpeedButton</name>
    <message>
        <source>%1×</source>
        <translation>%1×</translation>
    </message>
    <message>
        <source>Playing speed %1, %2</source>
        <translation>Vitesse de lecture %1, %2</translation>
    </message>
    <message>
        <source>%1 frames/s</source>
        <translation>%1 images/s</translation>
    </message>
</context>
<context>
    <name>app::StabilityGauge</name>
    <message>
        <source>Stability</source>
        <translation>Stabilité</translation>
    </message>
    <message>
        <source>Click for the reasons and the remedies</source>
        <translation>Un clic montre les raisons et les remèdes</translation>
    </message>
    <message>
        <source>%1&#x2009;% of the limit</source>
        <translation>%1&#x2009;% de la limite</translation>
    </message>
    <message>
        <source>Preview of frame %1: %2</source>
        <translation>Aperçu de l’image %1&#xa0;: %2</translation>
    </message>
</context>
<context>
    <name>app::StabilityPanel</name>
    <message>
        <source>Stability</source>
        <translation>Stabilité</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Fermer</translation>
    </message>
    <message>
        <source>Close, and show the previous panel</source>
        <translation>Fermer, et afficher le panneau précédent</translation>
    </message>
    <message>
        <source>Remedies</source>
        <translation>Remèdes</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
    <message>
        <source>k and step</source>
        <translation>k et pas de temps</translation>
    </message>
    <message>
        <source>Shows which stiffness and step are stable, with everything else unchanged. Click again to close</source>
        <translation>Montre quelle raideur et quel pas de temps sont stables, tout le reste étant inchangé. Un nouveau clic la ferme</translation>
    </message>
    <message>
        <source>k and damping</source>
        <translation>k et amortissement</translation>
    </message>
    <message>
        <source>Shows which stiffness and damping are stable, with everything else unchanged. Click again to close</source>
        <translation>Montre quelle raideur et quel amortissement sont stables, tout le reste étant inchangé. Un nouveau clic la ferme</translation>
    </message>
    <message>
        <source>There is no map for this step: it has no stiffness k to change.</source>
        <translation>Il n’y a pas de carte pour cette étape&#xa0;: elle n’a pas de raideur k à changer.</translation>
    </message>
    <message>
        <source>There is no map here: no springs act, so every stiffness and every step is stable.</source>
        <translation>Il n’y a pas de carte ici&#xa0;: aucun ressort n’agit, donc toute raideur et tout pas de temps sont stables.</translation>
    </message>
    <message>
        <source>There is no map for this method: it is stable at every stiffness.</source>
        <translation>Il n’y a pas de carte pour cette méthode&#xa0;: elle est stable à toute raideur.</translation>
    </message>
    <message>
        <source>There is no map for your code: it may compute anything, whatever the stiffness is.</source>
        <translation>Il n’y a pas de carte pour ton code&#xa0;: il peut calculer n’importe quoi, quelle que soit la raideur.</translation>
    </message>
    <message>
        <source>Time to rest</source>
        <translation>Repos</translation>
    </message>
    <message>
        <source>Shows how many frames the run takes to come to rest, for each stiffness and damping. Click again to close</source>
        <translation>Montre après combien d’images la simulation s’immobilise, pour chaque raideur et chaque amortissement. Un nouveau clic la ferme</translation>
    </message>
    <message>
        <source>There is no map of the time to rest for this step: it needs the stiffness k, a damping, and at most %1 points.</source>
        <translation>Il n’y a pas de carte du temps de stabilisation pour cette étape&#xa0;: il lui faut la raideur k, un amortissement et au plus %1 points.</translation>
    </message>
</context>
<context>
    <name>app::StatusFigures</name>
    <message>
        <source>How many points the scene has: each body, foot or joint is one</source>
        <translation>Nombre de points de la scène&#xa0;: chaque corps, pied ou articulation en est un</translation>
    </message>
    <message>
        <source>How often a frame computes all forces. The cost of a frame depends on this</source>
        <translation>Combien de fois une image calcule toutes les forces. Le coût d’une image en dépend</translation>
    </message>
    <message>
        <source>The time to compute a frame of this scene on this machine (the median of many runs)</source>
        <translation>La durée de calcul d’une image de cette scène sur cette machine (médiane de nombreuses exécutions)</translation>
    </message>
    <message>
        <source>The largest distance of any body from the exact motion, over these frames</source>
        <translation>Le plus grand écart d’un corps au mouvement exact, sur ces images</translation>
    </message>
    <message>
        <source>%1 a frame</source>
        <translation>%1 par image</translation>
    </message>
    <message>
        <source>error %1 over %2 frames</source>
        <translation>erreur %1 sur %2 images</translation>
    </message>
    <message>
        <source>forces once a frame</source>
        <translation>forces 1 fois/image</translation>
    </message>
    <message>
        <source>forces %1 times a frame</source>
        <translation>forces %1 fois/image</translation>
    </message>
    <message>
        <source>forces %1 times a frame so far</source>
        <translation>forces %1 fois/image jusqu’ici</translation>
    </message>
</context>
<context>
    <name>app::StatusLine</name>
    <message>
        <source>Preview inside frame %1. The run does not move.</source>
        <translation>Aperçu à l’intérieur de l’image %1. La simulation ne bouge pas.</translation>
    </message>
    <message>
        <source>Preview of frame %1. The run stays at frame %2.</source>
        <translation>Aperçu de l’image %1. La simulation reste à l’image %2.</translation>
    </message>
    <message>
        <source>Everything is at rest. Touch something, or press &lt;b&gt;%1&lt;/b&gt; to stop.</source>
        <translation>Tout est au repos. Touche quelque chose, ou appuie sur &lt;b&gt;%1&lt;/b&gt; pour arrêter.</translation>
    </message>
    <message>
        <source>Playing. Press &lt;b&gt;%1&lt;/b&gt; to stop anywhere.</source>
        <translation>En lecture. Appuie sur &lt;b&gt;%1&lt;/b&gt; pour arrêter n’importe où.</translation>
    </message>
    <message>
        <source>Inside frame %1, after %2. &lt;b&gt;%3&lt;/b&gt; next phase, &lt;b&gt;%4&lt;/b&gt; next frame.</source>
        <translation>Dans l’image %1, après «&#x202f;%2&#x202f;». &lt;b&gt;%3&lt;/b&gt; phase suivante, &lt;b&gt;%4&lt;/b&gt; image suivante.</translation>
    </message>
    <message>
        <source>&lt;b&gt;%1&lt;/b&gt; plays, &lt;b&gt;%2&lt;/b&gt; next frame, &lt;b&gt;%3&lt;/b&gt; into the frame. Drag anything.</source>
        <translation>&lt;b&gt;%1&lt;/b&gt; lecture, &lt;b&gt;%2&lt;/b&gt; image suivante, &lt;b&gt;%3&lt;/b&gt; dans l’image. Fais glisser ce que tu veux.</translation>
    </message>
</context>
<context>
    <name>app::StepMenu</name>
    <message>
        <source>Other:</source>
        <translation>Autre&#xa0;:</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>images</translation>
    </message>
    <message>
        <source>From 1e-13 to 100 px; press Enter to apply</source>
        <translation>De 1e-13 à 100 px&#x202f;; Entrée applique</translation>
    </message>
    <message>
        <source>A whole number of frames, or 1 divided by a whole number; press Enter to apply</source>
        <translation>Un nombre entier d’images, ou 1 divisé par un nombre entier&#x202f;; Entrée applique</translation>
    </message>
    <message>
        <source>Other tolerance, in px</source>
        <translation>Autre tolérance, en px</translation>
    </message>
    <message>
        <source>Other step, in frames</source>
        <translation>Autre pas de temps, en images</translation>
    </message>
</context>
<context>
    <name>app::StudyPlot</name>
    <message>
        <source>Points: %1. The arrow keys go through them, and Enter uses one.</source>
        <translation>Points&#xa0;: %1. Les flèches les parcourent, et Entrée en utilise un.</translation>
    </message>
    <message>
        <source>← more accurate</source>
        <translation>← plus précis</translation>
    </message>
    <message>
        <source>largest error, px</source>
        <translation>plus grande erreur, px</translation>
    </message>
</context>
<context>
    <name>app::SummaryPage</name>
    <message>
        <source>Back to the step</source>
        <translation>Retour à l’étape</translation>
    </message>
    <message>
        <source>%1: what you learnt</source>
        <translation>%1&#xa0;: ce que tu as appris</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Suite&#xa0;: %1</translation>
    </message>
    <message>
        <source>The last lesson</source>
        <translation>La dernière leçon</translation>
    </message>
    <message>
        <source>No lesson comes after this one.</source>
        <translation>Aucune leçon ne vient après celle-ci.</translation>
    </message>
    <message>
        <source>Restore the ticks</source>
        <translation>Rétablir les coches</translation>
    </message>
    <message>
        <source>Restart this lesson</source>
        <translation>Recommencer la leçon</translation>
    </message>
    <message>
        <source>Ticks everything again that you had done before</source>
        <translation>Coche à nouveau tout ce que tu avais déjà fait</translation>
    </message>
    <message>
        <source>Removes the ticks of this lesson. You can restore them.</source>
        <translation>Enlève les coches de cette leçon. Tu pourras les rétablir.</translation>
    </message>
    <message>
        <source>Nothing is ticked in this lesson yet.</source>
        <translation>Rien n’est encore coché dans cette leçon.</translation>
    </message>
    <message>
        <source>%1 of %2 things tried.</source>
        <translation>Essais faits&#xa0;: %1 sur %2.</translation>
    </message>
    <message>
        <source>Still to try: %1</source>
        <translation>Encore à essayer&#xa0;: %1</translation>
    </message>
    <message>
        <source>**Next: %1.** %2</source>
        <translation>**Suite&#xa0;: %1.** %2</translation>
    </message>
    <message>
        <source>%1 of %2 tasks written in the listing.</source>
        <translation>Exercices écrits dans le listing&#xa0;: %1 sur %2.</translation>
    </message>
    <message>
        <source>Still to write: %1</source>
        <translation>Encore à écrire&#xa0;: %1</translation>
    </message>
    <message>
        <source>Predicted: %1 %2</source>
        <translation>Prédit&#xa0;: %1 %2</translation>
    </message>
    <message>
        <source>%1 of %2 levels of the project passed.</source>
        <translation>Paliers du projet réussis&#xa0;: %1 sur %2.</translation>
    </message>
    <message>
        <source>**Project: %1**</source>
        <translation>**Projet&#xa0;: %1**</translation>
    </message>
    <message>
        <source>Still to pass: %1</source>
        <translation>Encore à réussir&#xa0;: %1</translation>
    </message>
</context>
<context>
    <name>app::TaskBox</name>
    <message>
        <source>Write it yourself</source>
        <translation>Écris-le toi-même</translation>
    </message>
    <message>
        <source>Empties the place in the listing, so that you can write it</source>
        <translation>Vide l’endroit dans le listing, pour que tu puisses l’écrire</translation>
    </message>
    <message>
        <source>Shows the next hint</source>
        <translation>Affiche l’indice suivant</translation>
    </message>
    <message>
        <source>Solution</source>
        <translation>Solution</translation>
    </message>
    <message>
        <source>Writes the solution into the listing</source>
        <translation>Écrit la solution dans le listing</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>Stops this task. Your code stays.</source>
        <translation>Arrête cet exercice. Ton code reste.</translation>
    </message>
    <message>
        <source>%1, done</source>
        <translation>%1, fait</translation>
    </message>
    <message>
        <source>Write it again</source>
        <translation>Écris-le à nouveau</translation>
    </message>
    <message>
        <source>Hint %1 of %2</source>
        <translation>Indice %1 sur %2</translation>
    </message>
</context>
<context>
    <name>app::TaskDesk</name>
    <message>
        <source>This is the solution. To get the tick, start again and write it yourself.</source>
        <translation>C’est la solution. Pour avoir la coche, recommence et écris-le toi-même.</translation>
    </message>
    <message>
        <source>Trying your code …</source>
        <translation>Essai de ton code…</translation>
    </message>
</context>
<context>
    <name>app::TimelineStrip</name>
    <message>
        <source>%1: phase %2 of %3. Click to run to it.</source>
        <translation>%1&#xa0;: phase %2 sur %3. Un clic va jusque-là.</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>Ligne de temps</translation>
    </message>
    <message>
        <source>%1 other runs branch off from this one at frame %2. Click to choose one.</source>
        <translation>%1 autres simulations s’écartent de celle-ci à l’image %2. Clique pour en choisir une.</translation>
    </message>
    <message>
        <source>Another run: %1. Click to show it beside this one, right-click for more.</source>
        <translation>Une autre simulation&#xa0;: %1. Un clic l’affiche à côté de celle-ci, un clic droit en propose plus.</translation>
    </message>
    <message>
        <source>Beside this run: %1. Right-click for more.</source>
        <translation>À côté de cette simulation&#xa0;: %1. Un clic droit en propose plus.</translation>
    </message>
    <message>
        <source>Left and Right: one frame. With Shift: one phase. Home: restart. With Shift: repeat the run. End: the last computed frame. Menu: the other runs.</source>
        <translation>Gauche et Droite&#xa0;: une image. Avec Maj&#xa0;: une phase. Début&#xa0;: recommencer. Avec Maj&#xa0;: répéter la simulation. Fin&#xa0;: la dernière image calculée. Menu&#xa0;: les autres simulations.</translation>
    </message>
    <message>
        <source>%1. Preview: %2</source>
        <translation>%1. Aperçu&#xa0;: %2</translation>
    </message>
    <message>
        <source>Line %1, %2 of %3: %4
Click to run to it.</source>
        <translation>Ligne %1, %2 sur %3&#xa0;: %4
Clique pour aller jusque-là.</translation>
    </message>
</context>
<context>
    <name>app::Tour</name>
    <message>
        <source>Skip</source>
        <translation>Passer</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>Ends the tour (Esc). It is in the Help menu.</source>
        <translation>Termine la visite (Échap). Elle est dans le menu «&#x202f;Aide&#x202f;».</translation>
    </message>
    <message>
        <source>The previous card</source>
        <translation>La carte précédente</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminer</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
    </message>
    <message>
        <source>Ends the tour (Enter)</source>
        <translation>Termine la visite (Entrée)</translation>
    </message>
    <message>
        <source>The next card (Enter)</source>
        <translation>La carte suivante (Entrée)</translation>
    </message>
    <message>
        <source>The picture</source>
        <translation>La vue</translation>
    </message>
    <message>
        <source>This is the scene of the lesson. Drag anything in it. Let go while moving to throw it.</source>
        <translation>C’est la scène de la leçon. Fais-y glisser ce que tu veux. Lâche en plein mouvement pour le lancer.</translation>
    </message>
    <message>
        <source>Play and stop</source>
        <translation>Lecture et arrêt</translation>
    </message>
    <message>
        <source>**%1** plays and stops the run. **%2** goes one frame forward, **%3** one frame back.</source>
        <translation>**%1** lance et arrête la simulation. **%2** avance d’une image, **%3** recule d’une image.</translation>
    </message>
    <message>
        <source>The whole run is kept</source>
        <translation>Toute la simulation reste</translation>
    </message>
    <message>
        <source>Drag here to go back in time. Change something there, and the old run stays as a ghost.</source>
        <translation>Fais glisser ici pour remonter le temps. Change quelque chose, et l’ancienne simulation reste comme fantôme.</translation>
    </message>
    <message>
        <source>Inside a frame</source>
        <translation>Dans une image</translation>
    </message>
    <message>
        <source>**%1** runs one line of the code, and **%2** takes it back. On the code&apos;s page **Engine** they go from phase to phase: springs pull, damping slows things down, things move.</source>
        <translation>**%1** exécute une ligne du code, et **%2** l’annule. Sur la page **Moteur physique** du code, ces touches vont de phase en phase&#xa0;: les ressorts tirent, l’amortissement freine, tout bouge.</translation>
    </message>
    <message>
        <source>The code that runs</source>
        <translation>Le code qui s’exécute</translation>
    </message>
    <message>
        <source>Numbers to change</source>
        <translation>Des nombres à changer</translation>
    </message>
    <message>
        <source>Move a slider, or type any number. The arrow beside it resets the number.</source>
        <translation>Bouge un curseur, ou tape n’importe quel nombre. La flèche à côté le réinitialise.</translation>
    </message>
    <message>
        <source>Try this</source>
        <translation>À toi d’essayer</translation>
    </message>
    <message>
        <source>Springstep ticks each task when it sees you do it. Click a lamp for a hint, or a dotted word for its meaning.</source>
        <translation>Springstep coche chaque essai quand il te voit le faire. Clique sur une lampe pour un indice, ou sur un mot pointillé pour son sens.</translation>
    </message>
    <message>
        <source>These lines compute the scene. Beside them are the current values. Change a line, and the picture follows.</source>
        <translation>Ces lignes calculent la scène. À côté se trouvent les valeurs actuelles. Change une ligne, et la vue suit.</translation>
    </message>
</context>
<context>
    <name>app::TransportBar</name>
    <message>
        <source>going to %1… %2 stops</source>
        <translation>va à %1… %2 arrête</translation>
    </message>
    <message>
        <source>going to %1…</source>
        <translation>va à %1…</translation>
    </message>
    <message>
        <source>· %1</source>
        <translation>· %1</translation>
    </message>
    <message>
        <source>· at %1</source>
        <translation>· à %1</translation>
    </message>
    <message>
        <source>Playing speed (%1 and %2). It never changes the step</source>
        <translation>Vitesse de lecture (%1 et %2). Elle ne change jamais le pas de temps</translation>
    </message>
    <message>
        <source>· preview: %1</source>
        <translation>· aperçu&#xa0;: %1</translation>
    </message>
    <message>
        <source>· preview of frame %1</source>
        <translation>· aperçu de l’image %1</translation>
    </message>
</context>
<context>
    <name>app::TryBox</name>
    <message>
        <source>Hint: %1</source>
        <translation>Indice&#xa0;: %1</translation>
    </message>
    <message>
        <source>Hide the hint</source>
        <translation>Masquer l’indice</translation>
    </message>
    <message>
        <source>Show a hint (H)</source>
        <translation>Afficher un indice (H)</translation>
    </message>
    <message>
        <source>Hide the answer</source>
        <translation>Masquer la réponse</translation>
    </message>
    <message>
        <source>Show the answer</source>
        <translation>Afficher la réponse</translation>
    </message>
    <message>
        <source>Answer: %1</source>
        <translation>Réponse&#xa0;: %1</translation>
    </message>
    <message>
        <source>**Still to do:** %1</source>
        <translation>**Encore à faire&#xa0;:** %1</translation>
    </message>
</context>
<context>
    <name>app::TryRow</name>
    <message>
        <source>Springstep ticks this when it sees you do it.</source>
        <translation>Springstep coche cela quand il te voit le faire.</translation>
    </message>
    <message>
        <source>%1 done</source>
        <translation>%1&#xa0;: fait</translation>
    </message>
    <message>
        <source>%1 not yet</source>
        <translation>%1&#xa0;: pas encore</translation>
    </message>
</context>
<context>
    <name>app::UserInput</name>
    <message>
        <source>your hand</source>
        <translation>ta main</translation>
    </message>
    <message>
        <source>Drag %1</source>
        <translation>Faire glisser %1</translation>
    </message>
    <message>
        <source>Move pointer</source>
        <translation>Déplacer le pointeur</translation>
    </message>
    <message>
        <source>the pointer</source>
        <translation>le pointeur</translation>
    </message>
    <message>
        <source>Set target</source>
        <translation>Placer la cible</translation>
    </message>
    <message>
        <source>the target</source>
        <translation>la cible</translation>
    </message>
    <message>
        <source>Press arrow keys</source>
        <translation>Appuyer sur les flèches</translation>
    </message>
    <message>
        <source>the keys</source>
        <translation>les touches</translation>
    </message>
</context>
<context>
    <name>app::WebPageDialog</name>
    <message>
        <source>Web page of the run</source>
        <translation>Page web de la simulation</translation>
    </message>
    <message>
        <source>Progress of the web page</source>
        <translation>Progression de la page web</translation>
    </message>
    <message>
        <source>One file that plays the run in any browser, also without a network: the scene, the listing with its values, the plots that are open, and the text of the step.</source>
        <translation>Un seul fichier qui montre la simulation dans n’importe quel navigateur, même sans réseau&#xa0;: la scène, le listing avec ses valeurs, les graphiques ouverts, et le texte de l’étape.</translation>
    </message>
    <message>
        <source>The first frame of the page</source>
        <translation>La première image de la page</translation>
    </message>
    <message>
        <source>The last frame of the page; the run is computed up to there</source>
        <translation>La dernière image de la page&#x202f;; la simulation est calculée jusque-là</translation>
    </message>
    <message>
        <source>&amp;Save as…</source>
        <translation>&amp;Enregistrer sous…</translation>
    </message>
    <message>
        <source>Choose a file, and make the page; you can use the window meanwhile</source>
        <translation>Choisis un fichier, et la page est créée&#x202f;; pendant ce temps, tu peux utiliser la fenêtre</translation>
    </message>
    <message>
        <source>Web pages (*.html)</source>
        <translation>Pages web (*.html)</translation>
    </message>
    <message>
        <source>Cancel the page (Esc)</source>
        <translation>Annuler la page (Échap)</translation>
    </message>
</context>
<context>
    <name>app::WhyButton</name>
    <message>
        <source>Hide the answer</source>
        <translation>Masquer la réponse</translation>
    </message>
    <message>
        <source>Show the answer</source>
        <translation>Afficher la réponse</translation>
    </message>
    <message>
        <source>open</source>
        <translation>dépliée</translation>
    </message>
    <message>
        <source>folded</source>
        <translation>repliée</translation>
    </message>
</context>
<context>
    <name>app::WhyText</name>
    <message>
        <source>Click the line to keep the marks.</source>
        <translation>Clique sur la ligne pour garder les repères.</translation>
    </message>
</context>
<context>
    <name>app::WordCard</name>
    <message>
        <source>Taught in</source>
        <translation>Enseigné dans</translation>
    </message>
    <message>
        <source>All words</source>
        <translation>Tous les mots</translation>
    </message>
</context>
<context>
    <name>app::WorkPrecisionPlot</name>
    <message>
        <source>you are here</source>
        <translation>tu es ici</translation>
    </message>
    <message>
        <source>The front: nothing cheaper
is as accurate.</source>
        <translation>Le front&#xa0;: rien de moins cher
n’est aussi précis.</translation>
    </message>
    <message>
        <source>Error against time</source>
        <translation>Erreur et durée</translation>
    </message>
    <message>
        <source>time to compute a frame, µs</source>
        <translation>durée de calcul d’une image, µs</translation>
    </message>
    <message>
        <source>forces computed per frame (times follow)</source>
        <translation>forces calculées par image (durées à suivre)</translation>
    </message>
    <message>
        <source>← faster</source>
        <translation>← plus rapide</translation>
    </message>
    <message>
        <source>A frame is on the screen
for %1&#x2009;µs (30 a second)</source>
        <translation>Une image reste à l’écran
%1 µs (30 par seconde)</translation>
    </message>
</context>
<context>
    <name>app::YourLessons</name>
    <message>
        <source>Could not find %1, so it is no longer among your lessons. If you moved it, open it from its new place.</source>
        <translation>%1 est introuvable, et n’est donc plus parmi tes leçons. Si tu l’as déplacé, ouvre-le depuis son nouvel emplacement.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>an event</source>
        <translation>un événement</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un nombre entier</translation>
    </message>
    <message>
        <source>a parameter&apos;s id</source>
        <translation>l’identifiant d’un paramètre</translation>
    </message>
    <message>
        <source>a value of that parameter</source>
        <translation>une valeur de ce paramètre</translation>
    </message>
    <message>
        <source>joint limits</source>
        <translation>butées d’articulation</translation>
    </message>
    <message>
        <source>area</source>
        <translation>aire</translation>
    </message>
    <message>
        <source>spring</source>
        <translation>ressort</translation>
    </message>
    <message>
        <source>damping</source>
        <translation>amortissement</translation>
    </message>
    <message>
        <source>gait clock</source>
        <translation>horloge d’allure</translation>
    </message>
    <message>
        <source>gravity</source>
        <translation>gravité</translation>
    </message>
    <message>
        <source>ground</source>
        <translation>sol</translation>
    </message>
    <message>
        <source>gust runs on</source>
        <translation>rafale qui avance</translation>
    </message>
    <message>
        <source>joints</source>
        <translation>articulations</translation>
    </message>
    <message>
        <source>legs</source>
        <translation>pattes</translation>
    </message>
    <message>
        <source>motor</source>
        <translation>moteur</translation>
    </message>
    <message>
        <source>anticipation</source>
        <translation>anticipation</translation>
    </message>
    <message>
        <source>pointer</source>
        <translation>pointeur</translation>
    </message>
    <message>
        <source>push</source>
        <translation>poussée</translation>
    </message>
    <message>
        <source>springs</source>
        <translation>ressorts</translation>
    </message>
    <message>
        <source>return to rest</source>
        <translation>retour au repos</translation>
    </message>
    <message>
        <source>room</source>
        <translation>pièce</translation>
    </message>
    <message>
        <source>soft sticks</source>
        <translation>tiges souples</translation>
    </message>
    <message>
        <source>drag along, across</source>
        <translation>frein en long, en travers</translation>
    </message>
    <message>
        <source>steering</source>
        <translation>pilotage</translation>
    </message>
    <message>
        <source>sticks</source>
        <translation>tiges</translation>
    </message>
    <message>
        <source>wind</source>
        <translation>vent</translation>
    </message>
    <message>
        <source>turn round</source>
        <translation>demi-tour</translation>
    </message>
    <message>
        <source>turn to the pointer</source>
        <translation>rotation vers le pointeur</translation>
    </message>
    <message>
        <source>walls</source>
        <translation>murs</translation>
    </message>
    <message>
        <source>Done by dragging</source>
        <translation>Fournie à la souris</translation>
    </message>
    <message>
        <source>Changed with a parameter</source>
        <translation>Changée par un paramètre</translation>
    </message>
    <message>
        <source>Done by clocks and steering</source>
        <translation>Fournie par horloge et pilotage</translation>
    </message>
    <message>
        <source>Done by wind</source>
        <translation>Fournie par le vent</translation>
    </message>
    <message>
        <source>Done by one-way pulls</source>
        <translation>Fournie par tractions unilatérales</translation>
    </message>
    <message>
        <source>Given by gravity</source>
        <translation>Donnée par la gravité</translation>
    </message>
    <message>
        <source>Given by fixed places</source>
        <translation>Donnée par les points fixes</translation>
    </message>
    <message>
        <source>Lost by damping</source>
        <translation>Perdue par amortissement</translation>
    </message>
    <message>
        <source>At impacts</source>
        <translation>Lors des chocs</translation>
    </message>
    <message>
        <source>Changed by sticks</source>
        <translation>Changée par les tiges</translation>
    </message>
    <message>
        <source>Drift of the method</source>
        <translation>Dérive de la méthode</translation>
    </message>
    <message>
        <source>squeezed into one pixel</source>
        <translation>écrasés dans un pixel</translation>
    </message>
    <message>
        <source>Twelve feet stand within 1 px of their body, on springs of stiffness one million that are 50 px long. Squeezed like this, they flip over at the slightest touch.</source>
        <translation>Douze pieds sont à moins de 1 px de leur corps, sur des ressorts de raideur un million et longs de 50 px. Écrasés ainsi, ils se retournent au moindre contact.</translation>
    </message>
    <message>
        <source>the pair that runs away</source>
        <translation>la paire qui s’enfuit</translation>
    </message>
    <message>
        <source>A foot and a body pull each other, but one after the other. So the pair drives itself forward, although nothing pushes it.</source>
        <translation>Un pied et un corps se tirent l’un l’autre, mais l’un après l’autre. La paire se propulse donc elle-même, bien que rien ne la pousse.</translation>
    </message>
    <message>
        <source>sixty feet</source>
        <translation>soixante pieds</translation>
    </message>
    <message>
        <source>Each foot has a soft spring, but sixty together pull the body too hard for one step.</source>
        <translation>Chaque pied a un ressort souple, mais à soixante, ils tirent trop fort sur le corps pour un pas de temps.</translation>
    </message>
    <message>
        <source>a hundred feet</source>
        <translation>cent pieds</translation>
    </message>
    <message>
        <source>A hundred soft springs on one body make a stiff one.</source>
        <translation>Cent ressorts souples sur un corps en font un raide.</translation>
    </message>
    <message>
        <source>a thousand feet</source>
        <translation>mille pieds</translation>
    </message>
    <message>
        <source>A thousand feet pull one body as hard as a spring of stiffness 200.</source>
        <translation>Mille pieds tirent un corps aussi fort qu’un ressort de raideur 200.</translation>
    </message>
    <message>
        <source>ten thousand feet</source>
        <translation>dix mille pieds</translation>
    </message>
    <message>
        <source>Ten thousand feet pull one body as hard as a spring of stiffness 2000.</source>
        <translation>Dix mille pieds tirent un corps aussi fort qu’un ressort de raideur 2000.</translation>
    </message>
    <message>
        <source>all in one place</source>
        <translation>tous au même endroit</translation>
    </message>
    <message>
        <source>Body and feet start in the same place, where no spring has a direction.</source>
        <translation>Le corps et les pieds commencent au même endroit, où aucun ressort n’a de direction.</translation>
    </message>
    <message>
        <source>all on one line</source>
        <translation>tous sur une ligne</translation>
    </message>
    <message>
        <source>Body and feet stand on one line, so nothing pulls them off it.</source>
        <translation>Le corps et les pieds sont sur une ligne, donc rien ne les en écarte.</translation>
    </message>
    <message>
        <source>springs without a length</source>
        <translation>ressorts sans longueur</translation>
    </message>
    <message>
        <source>Springs of length 0 pull all points to one place, where the springs have no direction.</source>
        <translation>Des ressorts de longueur 0 tirent tous les points vers un seul endroit, où ils n’ont pas de direction.</translation>
    </message>
    <message>
        <source>thrown into a corner</source>
        <translation>lancé dans un coin</translation>
    </message>
    <message>
        <source>A body flies into a corner at a million px a frame. In one step, it would fly through two thousand rooms.</source>
        <translation>Un corps vole dans un coin à un million de px par image. En un pas de temps, il traverserait deux mille pièces.</translation>
    </message>
    <message>
        <source>walls closer than the body</source>
        <translation>murs plus proches que le corps</translation>
    </message>
    <message>
        <source>The body is 30 px wide but the room only 15 px. Wherever the body is, it is inside a wall.</source>
        <translation>Le corps fait 30 px de large, mais la pièce seulement 15 px. Où qu’il soit, le corps est dans un mur.</translation>
    </message>
    <message>
        <source>a million times the gravity</source>
        <translation>un million de fois la gravité</translation>
    </message>
    <message>
        <source>In each frame, gravity makes everything a million px a frame faster, above a floor without bounce.</source>
        <translation>À chaque image, la gravité accélère tout d’un million de px par image, au-dessus d’un sol sans rebond.</translation>
    </message>
    <message>
        <source>grabbed and let go</source>
        <translation>attrapé et lâché</translation>
    </message>
    <message>
        <source>The body is grabbed for one frame and let go.</source>
        <translation>Le corps est attrapé pendant une image, puis lâché.</translation>
    </message>
    <message>
        <source>torn away</source>
        <translation>arraché</translation>
    </message>
    <message>
        <source>The body is dragged a billion px away in one frame and let go.</source>
        <translation>Le corps est traîné à un milliard de px en une image, puis lâché.</translation>
    </message>
    <message>
        <source>torn away on stiff springs</source>
        <translation>arraché sur des ressorts raides</translation>
    </message>
    <message>
        <source>The same, with springs of stiffness one million.</source>
        <translation>La même chose, avec des ressorts de raideur un million.</translation>
    </message>
    <message>
        <source>legs that flip</source>
        <translation>pattes qui se retournent</translation>
    </message>
    <message>
        <source>The gait turns by half a circle in each frame, so the steps see only two of its positions.</source>
        <translation>L’allure tourne d’un demi-cercle à chaque image, donc les pas de temps ne voient que deux de ses positions.</translation>
    </message>
    <message>
        <source>legs that whirl</source>
        <translation>pattes qui tourbillonnent</translation>
    </message>
    <message>
        <source>The gait turns 159,155 times in a frame.</source>
        <translation>L’allure tourne 159&#x202f;155 fois en une image.</translation>
    </message>
    <message>
        <source>a drag to nowhere</source>
        <translation>traîné vers nulle part</translation>
    </message>
    <message>
        <source>The body is dragged to a position that is not a number.</source>
        <translation>Le corps est traîné vers une position qui n’est pas un nombre.</translation>
    </message>
    <message>
        <source>a pointer infinitely far away</source>
        <translation>un pointeur infiniment loin</translation>
    </message>
    <message>
        <source>The pointer moves to a position that is infinitely far away.</source>
        <translation>Le pointeur va à une position infiniment éloignée.</translation>
    </message>
    <message>
        <source>an infinite stiffness</source>
        <translation>une raideur infinie</translation>
    </message>
    <message>
        <source>The stiffness is set to infinity.</source>
        <translation>La raideur est mise à l’infini.</translation>
    </message>
    <message>
        <source>feet</source>
        <translation>pieds</translation>
    </message>
    <message>
        <source>body</source>
        <translation>corps</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>pied</translation>
    </message>
    <message>
        <source>light</source>
        <translation>léger</translation>
    </message>
    <message>
        <source>heavy</source>
        <translation>lourd</translation>
    </message>
    <message>
        <source>lead</source>
        <translation>meneur</translation>
    </message>
    <message>
        <source>tail</source>
        <translation>queue</translation>
    </message>
    <message>
        <source>suddenly stiff</source>
        <translation>soudain raide</translation>
    </message>
    <message>
        <source>In the middle of the run, the stiffness jumps from 0.2 to one million.</source>
        <translation>Au milieu de la simulation, la raideur saute de 0,2 à un million.</translation>
    </message>
    <message>
        <source>just below the limit</source>
        <translation>juste sous la limite</translation>
    </message>
    <message>
        <source>With one step a frame, the limit is a stiffness of 4. This spring has 3.99.</source>
        <translation>Avec un pas de temps par image, la limite est une raideur de 4. Ce ressort a 3,99.</translation>
    </message>
    <message>
        <source>at the limit</source>
        <translation>à la limite</translation>
    </message>
    <message>
        <source>At stiffness 4, each step takes the foot to the other side at full speed, so it swings farther each time.</source>
        <translation>À la raideur 4, chaque pas de temps amène le pied de l’autre côté à pleine vitesse&#x202f;; il oscille donc plus loin chaque fois.</translation>
    </message>
    <message>
        <source>just above the limit</source>
        <translation>juste au-dessus de la limite</translation>
    </message>
    <message>
        <source>At stiffness 4.01 each swing is a tenth larger than the one before.</source>
        <translation>À la raideur 4,01, chaque oscillation dépasse la précédente d’un dixième.</translation>
    </message>
    <message>
        <source>a thousand times as stiff</source>
        <translation>mille fois plus raide</translation>
    </message>
    <message>
        <source>A spring of stiffness 1000 swings five times in a frame.</source>
        <translation>Un ressort de raideur 1000 oscille cinq fois en une image.</translation>
    </message>
    <message>
        <source>a million times as stiff</source>
        <translation>un million de fois plus raide</translation>
    </message>
    <message>
        <source>A spring of stiffness a million swings 159 times in a frame.</source>
        <translation>Un ressort de raideur un million oscille 159 fois en une image.</translation>
    </message>
    <message>
        <source>nearly rigid</source>
        <translation>presque rigide</translation>
    </message>
    <message>
        <source>A spring of stiffness one billion behaves almost like a stick.</source>
        <translation>Un ressort de raideur un milliard se comporte presque comme une tige.</translation>
    </message>
    <message>
        <source>nearly rigid, without damping</source>
        <translation>presque rigide, sans amortissement</translation>
    </message>
    <message>
        <source>The same without damping: it may swing for ever, but no farther than at the start.</source>
        <translation>La même chose sans amortissement&#xa0;: il peut osciller toujours, mais pas plus loin qu’au début.</translation>
    </message>
    <message>
        <source>damping that stops everything</source>
        <translation>un amortissement qui arrête tout</translation>
    </message>
    <message>
        <source>With damping 0, no velocity is left, so nothing may move.</source>
        <translation>Avec l’amortissement 0, il ne reste aucune vitesse, donc rien ne doit bouger.</translation>
    </message>
    <message>
        <source>no damping</source>
        <translation>pas d’amortissement</translation>
    </message>
    <message>
        <source>With damping 1, nothing is lost: the foot swings for ever, but never farther.</source>
        <translation>Avec l’amortissement 1, rien n’est perdu&#xa0;: le pied oscille toujours, mais jamais plus loin.</translation>
    </message>
    <message>
        <source>almost no velocity left</source>
        <translation>presque plus de vitesse</translation>
    </message>
    <message>
        <source>A damping of 1e-300 leaves velocities that are almost too small to be stored.</source>
        <translation>Un amortissement de 1e-300 laisse des vitesses presque trop petites pour être mémorisées.</translation>
    </message>
    <message>
        <source>a fly and a mountain</source>
        <translation>une mouche et une montagne</translation>
    </message>
    <message>
        <source>One body is a billion times as heavy as the one on its spring.</source>
        <translation>Un corps est un milliard de fois plus lourd que celui de son ressort.</translation>
    </message>
    <message>
        <source>the mountain swings, too</source>
        <translation>la montagne oscille aussi</translation>
    </message>
    <message>
        <source>The spring is stiff enough to move the heavy body, and therefore a hundred million times too stiff for the light one.</source>
        <translation>Le ressort est assez raide pour bouger le corps lourd, et donc cent millions de fois trop raide pour le léger.</translation>
    </message>
    <message>
        <source>sticks that contradict each other</source>
        <translation>tiges qui se contredisent</translation>
    </message>
    <message>
        <source>Three sticks of lengths 1, 1 and 10 cannot form a triangle. Wherever the points move, at least one length is wrong.</source>
        <translation>Trois tiges de longueurs 1, 1 et 10 ne peuvent pas former un triangle. Où qu’aillent les points, au moins une longueur est fausse.</translation>
    </message>
    <message>
        <source>a chain that is too short</source>
        <translation>une chaîne trop courte</translation>
    </message>
    <message>
        <source>A chain of a thousand links between two nails is a tenth too short, so its links cannot keep their lengths.</source>
        <translation>Une chaîne de mille maillons entre deux clous est trop courte d’un dixième&#x202f;; ses maillons ne peuvent donc pas garder leur longueur.</translation>
    </message>
    <message>
        <source>a chain too heavy for its sticks</source>
        <translation>une chaîne trop lourde pour ses tiges</translation>
    </message>
    <message>
        <source>A chain of a thousand links hangs between two nails: 20 passes a frame leave its links much too long.</source>
        <translation>Une chaîne de mille maillons pend entre deux clous&#xa0;: 20 passes par image laissent ses maillons beaucoup trop longs.</translation>
    </message>
    <message>
        <source>a heavy chain in small steps</source>
        <translation>une chaîne lourde à petits pas de temps</translation>
    </message>
    <message>
        <source>The same chain and the same work, but with 20 steps of one pass each instead of 20 passes a frame. The errors of its links are a ninth as large.</source>
        <translation>La même chaîne et le même travail, mais avec 20 pas de temps d’une passe chacun au lieu de 20 passes par image. Les erreurs de ses maillons sont neuf fois plus petites.</translation>
    </message>
    <message>
        <source>a stick without a length</source>
        <translation>une tige sans longueur</translation>
    </message>
    <message>
        <source>Two points on a stick of length 0 have no direction between them, and a body hangs on them.</source>
        <translation>Entre deux points sur une tige de longueur 0, il n’y a pas de direction, et un corps y est suspendu.</translation>
    </message>
    <message>
        <source>a stick between two nails</source>
        <translation>une tige entre deux clous</translation>
    </message>
    <message>
        <source>A stick between two fixed points is too short, and neither point can move.</source>
        <translation>Une tige entre deux points fixes est trop courte, et aucun des points ne peut bouger.</translation>
    </message>
    <message>
        <source>the tail goes through the lead</source>
        <translation>la queue traverse le meneur</translation>
    </message>
    <message>
        <source>The lead turns round and swims straight through its own tail.</source>
        <translation>Le meneur fait demi-tour et nage tout droit à travers sa propre queue.</translation>
    </message>
    <message>
        <source>the tail is in the lead</source>
        <translation>la queue est dans le meneur</translation>
    </message>
    <message>
        <source>Lead and tail start in the same place, on a soft stick that has no direction there.</source>
        <translation>Le meneur et la queue commencent au même endroit, sur une tige souple qui n’y a pas de direction.</translation>
    </message>
    <message>
        <source>a target beyond the horizon</source>
        <translation>une cible au-delà de l’horizon</translation>
    </message>
    <message>
        <source>The target is a billion px away, and the motor pulls harder the farther away it is.</source>
        <translation>La cible est à un milliard de px, et plus elle est loin, plus le moteur tire fort.</translation>
    </message>
    <message>
        <source>points</source>
        <translation>points</translation>
    </message>
    <message>
        <source>ten million frames</source>
        <translation>dix millions d’images</translation>
    </message>
    <message>
        <source>A foot swings without damping for ten million frames, almost four days of playing. Its errors must not add up.</source>
        <translation>Un pied oscille sans amortissement pendant dix millions d’images, presque quatre jours de lecture. Ses erreurs ne doivent pas s’accumuler.</translation>
    </message>
    <message>
        <source>a million frames at rest</source>
        <translation>un million d’images au repos</translation>
    </message>
    <message>
        <source>At rest, bodies still have velocities that are almost too small to be stored, but they must not move.</source>
        <translation>Au repos, les corps ont encore des vitesses presque trop petites pour être mémorisées, mais ils ne doivent pas bouger.</translation>
    </message>
    <message>
        <source>a million steps a frame</source>
        <translation>un million de pas de temps par image</translation>
    </message>
    <message>
        <source>Each step is a millionth of a frame, so its small change is almost lost in rounding.</source>
        <translation>Chaque pas de temps est un millionième d’image&#x202f;; son petit changement se perd donc presque dans les arrondis.</translation>
    </message>
    <message>
        <source>a third of a frame</source>
        <translation>un tiers d’image</translation>
    </message>
    <message>
        <source>Three steps a frame: no binary number is exactly a third.</source>
        <translation>Trois pas de temps par image&#xa0;: aucun nombre binaire n’est exactement un tiers.</translation>
    </message>
    <message>
        <source>a hundred frames in a step</source>
        <translation>cent images en un pas de temps</translation>
    </message>
    <message>
        <source>One step skips seven swings of the spring.</source>
        <translation>Un pas de temps saute sept oscillations du ressort.</translation>
    </message>
    <message>
        <source>no distance to divide by</source>
        <translation>pas de distance par quoi diviser</translation>
    </message>
    <message>
        <source>The printed formula divides by the distance of the pointer, which can be 0. Then the run must stop with a message.</source>
        <translation>La formule imprimée divise par la distance du pointeur, qui peut être 0. La simulation doit alors s’arrêter avec un message.</translation>
    </message>
    <message>
        <source>the pointer on the root</source>
        <translation>le pointeur sur la racine</translation>
    </message>
    <message>
        <source>The trunk turns towards a pointer that is exactly at its root.</source>
        <translation>Le tronc se tourne vers un pointeur qui est exactement à sa racine.</translation>
    </message>
    <message>
        <source>sixteen forks</source>
        <translation>seize fourches</translation>
    </message>
    <message>
        <source>Each branch forks into two as large as itself, sixteen times: 131,071 branches in the wind.</source>
        <translation>Chaque branche se divise en deux aussi grandes qu’elle, seize fois&#xa0;: 131&#x202f;071 branches dans le vent.</translation>
    </message>
    <message>
        <source>a tree that never ends</source>
        <translation>un arbre qui ne finit jamais</translation>
    </message>
    <message>
        <source>Branches that are as large as their parents never get small enough to stop forking.</source>
        <translation>Des branches aussi grandes que leurs parentes ne deviennent jamais assez petites pour cesser de se diviser.</translation>
    </message>
    <message>
        <source>a tree of glass</source>
        <translation>un arbre de verre</translation>
    </message>
    <message>
        <source>Joints a million times as stiff as wood, bent by ten degrees and let go.</source>
        <translation>Des articulations un million de fois plus raides que le bois, fléchies de dix degrés puis lâchées.</translation>
    </message>
    <message>
        <source>wind from the branch itself</source>
        <translation>un vent venu de la branche même</translation>
    </message>
    <message>
        <source>The pointer is exactly where the trunk ends: the wind has no direction there.</source>
        <translation>Le pointeur est exactement au bout du tronc&#xa0;: le vent n’y a pas de direction.</translation>
    </message>
    <message>
        <source>wind without a distance</source>
        <translation>un vent sans distance</translation>
    </message>
    <message>
        <source>The distance to the pointer resists the wind, and here it is 0.</source>
        <translation>La distance au pointeur résiste au vent, et ici elle est 0.</translation>
    </message>
    <message>
        <source>branches</source>
        <translation>branches</translation>
    </message>
    <message>
        <source>adaptive steps</source>
        <translation>pas de temps adaptatifs</translation>
    </message>
    <message>
        <source>Backward Euler</source>
        <translation>Euler implicite</translation>
    </message>
    <message>
        <source>Dormand–Prince 8(5,3)</source>
        <translation>Dormand–Prince 8(5,3)</translation>
    </message>
    <message>
        <source>Dormand–Prince 5(4)</source>
        <translation>Dormand–Prince 5(4)</translation>
    </message>
    <message>
        <source>Explicit Euler</source>
        <translation>Euler explicite</translation>
    </message>
    <message>
        <source>solve for new positions</source>
        <translation>calcul des nouvelles positions</translation>
    </message>
    <message>
        <source>Implicit midpoint</source>
        <translation>Point milieu implicite</translation>
    </message>
    <message>
        <source>Runge–Kutta–Nyström 8(6)</source>
        <translation>Runge–Kutta–Nyström 8(6)</translation>
    </message>
    <message>
        <source>kick</source>
        <translation>impulsion</translation>
    </message>
    <message>
        <source>half kick</source>
        <translation>demi-impulsion</translation>
    </message>
    <message>
        <source>move</source>
        <translation>mouvement</translation>
    </message>
    <message>
        <source>half move</source>
        <translation>demi-mouvement</translation>
    </message>
    <message>
        <source>turn</source>
        <translation>rotation</translation>
    </message>
    <message>
        <source>half turn</source>
        <translation>demi-rotation</translation>
    </message>
    <message>
        <source>new velocity</source>
        <translation>nouvelle vitesse</translation>
    </message>
    <message>
        <source>Position Verlet</source>
        <translation>Verlet position</translation>
    </message>
    <message>
        <source>Published</source>
        <translation>Publiée</translation>
    </message>
    <message>
        <source>trial step</source>
        <translation>pas d’essai</translation>
    </message>
    <message>
        <source>Midpoint</source>
        <translation>Point milieu</translation>
    </message>
    <message>
        <source>Runge–Kutta 4</source>
        <translation>Runge–Kutta 4</translation>
    </message>
    <message>
        <source>Semi-implicit Euler</source>
        <translation>Euler semi-implicite</translation>
    </message>
    <message>
        <source>TR-BDF2</source>
        <translation>TR-BDF2</translation>
    </message>
    <message>
        <source>Velocity Verlet</source>
        <translation>Verlet vitesse</translation>
    </message>
    <message>
        <source>Keep joints from bending too far: a knee does not bend forwards.</source>
        <translation>Empêche les articulations de trop fléchir&#xa0;: un genou ne se plie pas vers l’avant.</translation>
    </message>
    <message>
        <source>Moves the swimmer back a little before it starts towards a new target, like a cat before it jumps.</source>
        <translation>Fait un peu reculer le nageur avant qu’il parte vers une nouvelle cible, comme un chat avant de sauter.</translation>
    </message>
    <message>
        <source>Keeps the area of the body: what gets longer gets thinner.</source>
        <translation>Conserve l’aire du corps&#xa0;: ce qui s’allonge s’amincit.</translation>
    </message>
    <message>
        <source>Pulls a foot to the body, wherever that is.</source>
        <translation>Tire un pied vers le corps, où qu’il soit.</translation>
    </message>
    <message>
        <source>Takes a share of every velocity each frame, so that things come to rest.</source>
        <translation>Enlève à chaque image une part de toute vitesse, pour que les choses s’immobilisent.</translation>
    </message>
    <message>
        <source>Advances the angle of the legs a little in each frame: the rhythm of the walk.</source>
        <translation>Avance un peu l’angle des pattes à chaque image&#xa0;: le rythme de la marche.</translation>
    </message>
    <message>
        <source>Pulls everything down equally.</source>
        <translation>Tire tout également vers le bas.</translation>
    </message>
    <message>
        <source>Keeps feet from sinking into the ground, and from slipping unless it is icy.</source>
        <translation>Empêche les pieds de s’enfoncer dans le sol, et de glisser sauf sur la glace.</translation>
    </message>
    <message>
        <source>Lets a gust run outwards from the pointer, so that near branches feel it first.</source>
        <translation>Fait partir une rafale du pointeur vers l’extérieur, pour que les branches proches la ressentent d’abord.</translation>
    </message>
    <message>
        <source>Set each branch on the end of the branch that carries it.</source>
        <translation>Pose chaque branche au bout de la branche qui la porte.</translation>
    </message>
    <message>
        <source>Pull each foot to its own place, as seen from the body.</source>
        <translation>Tire chaque pied vers sa propre place, vue depuis le corps.</translation>
    </message>
    <message>
        <source>Pulls the swimmer to its target, like a spring.</source>
        <translation>Tire le nageur vers sa cible, comme un ressort.</translation>
    </message>
    <message>
        <source>Pulls a foot to a place beside the body.</source>
        <translation>Tire un pied vers un endroit à côté du corps.</translation>
    </message>
    <message>
        <source>Pulls a foot to a fixed place.</source>
        <translation>Tire un pied vers un endroit fixe.</translation>
    </message>
    <message>
        <source>Moves a point to the pointer.</source>
        <translation>Amène un point au pointeur.</translation>
    </message>
    <message>
        <source>Pushes bodies apart that come too close, so that creatures do not walk through each other.</source>
        <translation>Écarte les corps qui s’approchent trop, pour que les créatures ne se traversent pas.</translation>
    </message>
    <message>
        <source>Keep two points a length apart: they pull when the distance is longer, and push when it is shorter.</source>
        <translation>Garde deux points à une longueur l’un de l’autre&#xa0;: tire quand la distance est plus longue, pousse quand elle est plus courte.</translation>
    </message>
    <message>
        <source>Turns each branch part of the way back to its direction at rest.</source>
        <translation>Fait tourner chaque branche d’une partie du chemin vers sa direction de repos.</translation>
    </message>
    <message>
        <source>Keep a point near its distance, but let it lag behind for a while.</source>
        <translation>Garde un point près de sa distance, mais le laisse traîner un moment.</translation>
    </message>
    <message>
        <source>Slows the tail as water does: more across the body than along it.</source>
        <translation>Freine la queue comme le fait l’eau&#xa0;: plus en travers du corps qu’en long.</translation>
    </message>
    <message>
        <source>Lets the arrow keys and the pointer set how fast the legs swing.</source>
        <translation>Laisse les flèches et le pointeur régler la vitesse à laquelle les pattes se balancent.</translation>
    </message>
    <message>
        <source>Give each pair of points its length back, by moving them: a stick does not stretch.</source>
        <translation>Rend sa longueur à chaque paire de points, en les déplaçant&#xa0;: une tige ne s’étire pas.</translation>
    </message>
    <message>
        <source>Bend each joint back: the farther a branch has turned from its direction at rest, the harder.</source>
        <translation>Ramène chaque articulation&#xa0;: plus une branche s’est écartée de sa direction de repos, plus fort.</translation>
    </message>
    <message>
        <source>Makes a creature turn round when it meets a wall.</source>
        <translation>Fait faire demi-tour à une créature qui rencontre un mur.</translation>
    </message>
    <message>
        <source>Turns every branch to the pointer while its button is down.</source>
        <translation>Tourne chaque branche vers le pointeur tant que son bouton est enfoncé.</translation>
    </message>
    <message>
        <source>Put back points that have gone past a wall or the floor, and reverse their velocity.</source>
        <translation>Remet en place les points qui ont dépassé un mur ou le sol, et inverse leur vitesse.</translation>
    </message>
    <message>
        <source>Turns the branches away from the pointer while its button is down.</source>
        <translation>Détourne les branches du pointeur tant que son bouton est enfoncé.</translation>
    </message>
    <message>
        <source>the body %1</source>
        <translation>le corps %1</translation>
    </message>
    <message>
        <source>Blows everything sideways, wide bodies more strongly, and can come in gusts.</source>
        <translation>Souffle tout de côté, les corps larges plus fort, et peut venir par rafales.</translation>
    </message>
    <message>
        <source>ramp</source>
        <translation>rampe</translation>
    </message>
    <message>
        <source>Keeps everything on one side of a straight line at any angle.</source>
        <translation>Garde tout d’un côté d’une ligne droite, à n’importe quel angle.</translation>
    </message>
    <message>
        <source>Keeps everything between two walls and above a floor, with friction and without bounce.</source>
        <translation>Garde tout entre deux murs et au-dessus d’un sol, avec du frottement et sans rebond.</translation>
    </message>
    <message>
        <source>Stiff springs</source>
        <translation>Ressorts raides</translation>
    </message>
    <message>
        <source>Many feet on one body</source>
        <translation>Beaucoup de pieds sur un corps</translation>
    </message>
    <message>
        <source>All in one place</source>
        <translation>Tous au même endroit</translation>
    </message>
    <message>
        <source>Grabbed and dragged</source>
        <translation>Attrapé et traîné</translation>
    </message>
    <message>
        <source>Walls and walking</source>
        <translation>Murs et marche</translation>
    </message>
    <message>
        <source>Sticks that contradict</source>
        <translation>Tiges qui se contredisent</translation>
    </message>
    <message>
        <source>Swimmers</source>
        <translation>Nageurs</translation>
    </message>
    <message>
        <source>Trees in wind</source>
        <translation>Arbres dans le vent</translation>
    </message>
    <message>
        <source>Unusual steps</source>
        <translation>Pas de temps inhabituels</translation>
    </message>
    <message>
        <source>Long runs</source>
        <translation>Longues simulations</translation>
    </message>
    <message>
        <source>Invalid input</source>
        <translation>Entrées invalides</translation>
    </message>
    <message>
        <source>1/frame²</source>
        <translation>1/image²</translation>
    </message>
    <message>
        <source>Bounce</source>
        <translation>Rebond</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Amortissement</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Distance</translation>
    </message>
    <message>
        <source>Floor</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <source>Gravity</source>
        <translation>Gravité</translation>
    </message>
    <message>
        <source>Ground</source>
        <translation>Sol</translation>
    </message>
    <message>
        <source>Gusts</source>
        <translation>Rafales</translation>
    </message>
    <message>
        <source>How far down that place is.</source>
        <translation>À quelle distance vers le bas se trouve cet endroit.</translation>
    </message>
    <message>
        <source>How far down the floor lies.</source>
        <translation>À quelle distance vers le bas se trouve le sol.</translation>
    </message>
    <message>
        <source>How far down the ground lies.</source>
        <translation>À quelle distance vers le bas se trouve le sol.</translation>
    </message>
    <message>
        <source>How far to the right a place of the ramp is.</source>
        <translation>Position vers la droite d’un endroit de la rampe.</translation>
    </message>
    <message>
        <source>How hard it blows to the right on a body 10 px wide. Below 0: to the left.</source>
        <translation>Force du vent vers la droite sur un corps large de 10 px. Au-dessous de 0&#xa0;: vers la gauche.</translation>
    </message>
    <message>
        <source>How hard two bodies push: this share of the missing distance, each frame.</source>
        <translation>Force avec laquelle deux corps se poussent&#xa0;: cette part de la distance manquante, à chaque image.</translation>
    </message>
    <message>
        <source>How much a wall slows things that slide along it. 0: like ice.</source>
        <translation>À quel point un mur freine ce qui glisse le long de lui. 0&#xa0;: comme de la glace.</translation>
    </message>
    <message>
        <source>How much speed everything gains downwards each frame.</source>
        <translation>Combien de vitesse tout gagne vers le bas à chaque image.</translation>
    </message>
    <message>
        <source>How often each frame goes through the list of sticks.</source>
        <translation>Combien de fois chaque image parcourt la liste des tiges.</translation>
    </message>
    <message>
        <source>How steeply it rises to the right. 0: level. 90: a wall on the right. 180: a ceiling.</source>
        <translation>Pente de la rampe vers la droite. 0&#xa0;: horizontale. 90&#xa0;: un mur à droite. 180&#xa0;: un plafond.</translation>
    </message>
    <message>
        <source>Iterations</source>
        <translation>Itérations</translation>
    </message>
    <message>
        <source>Left wall</source>
        <translation>Mur gauche</translation>
    </message>
    <message>
        <source>Push</source>
        <translation>Poussée</translation>
    </message>
    <message>
        <source>Ramp</source>
        <translation>Rampe</translation>
    </message>
    <message>
        <source>Ramp x</source>
        <translation>Rampe x</translation>
    </message>
    <message>
        <source>Ramp y</source>
        <translation>Rampe y</translation>
    </message>
    <message>
        <source>Right wall</source>
        <translation>Mur droit</translation>
    </message>
    <message>
        <source>The share by which the strength of the wind changes.</source>
        <translation>La part dont la force du vent varie.</translation>
    </message>
    <message>
        <source>The share of its speed that a body keeps at a wall.</source>
        <translation>La part de sa vitesse qu’un corps garde contre un mur.</translation>
    </message>
    <message>
        <source>The share of its speed that everything keeps each frame. 1 keeps it all.</source>
        <translation>La part de sa vitesse que tout garde à chaque image. 1 garde tout.</translation>
    </message>
    <message>
        <source>Two bodies closer than this push each other.</source>
        <translation>Deux corps plus proches que cela se poussent.</translation>
    </message>
    <message>
        <source>Where the left wall stands.</source>
        <translation>Où se trouve le mur gauche.</translation>
    </message>
    <message>
        <source>Where the right wall stands.</source>
        <translation>Où se trouve le mur droit.</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Vent</translation>
    </message>
    <message>
        <source>ice on the ground</source>
        <translation>de la glace sur le sol</translation>
    </message>
    <message>
        <source>kept</source>
        <translation>conservé</translation>
    </message>
    <message>
        <source>passes</source>
        <translation>passes</translation>
    </message>
    <message>
        <source>per frame</source>
        <translation>par image</translation>
    </message>
    <message>
        <source>px</source>
        <translation>px</translation>
    </message>
    <message>
        <source>px/frame²</source>
        <translation>px/image²</translation>
    </message>
    <message>
        <source>springs that pull one end only</source>
        <translation>des ressorts qui ne tirent qu’un bout</translation>
    </message>
    <message>
        <source>feet with more than one leg</source>
        <translation>des pieds avec plus d’une patte</translation>
    </message>
    <message>
        <source>the bounce of the ground</source>
        <translation>le rebond du sol</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
    <message>
        <source>Charge strength</source>
        <translation>Force des charges</translation>
    </message>
    <message>
        <source>px³/frame²</source>
        <translation>px³/image²</translation>
    </message>
    <message>
        <source>How hard charges push and pull each other.</source>
        <translation>Avec quelle force les charges se repoussent et s’attirent.</translation>
    </message>
    <message>
        <source>Softening</source>
        <translation>Adoucissement</translation>
    </message>
    <message>
        <source>Weakens the force where charges come closer than about this, so that it stays finite.</source>
        <translation>Affaiblit la force là où les charges s’approchent à moins d’environ cette distance, pour qu’elle reste finie.</translation>
    </message>
    <message>
        <source>Charge</source>
        <translation>Charge</translation>
    </message>
    <message>
        <source>Charges of the same sign repel each other, and others attract. 0: it carries none.</source>
        <translation>Les charges de même signe se repoussent, les autres s’attirent. 0&#xa0;: il n’en porte aucune.</translation>
    </message>
    <message>
        <source>Where this charge is, seen from the other one.</source>
        <translation>Où est cette charge, vue depuis l’autre.</translation>
    </message>
    <message>
        <source>How far apart the two charges are.</source>
        <translation>La distance entre les deux charges.</translation>
    </message>
    <message>
        <source>How hard they push each other apart, for a mass of 1. Below 0: they attract each other.</source>
        <translation>Avec quelle force elles se repoussent, pour une masse de 1. Au-dessous de 0&#xa0;: elles s’attirent.</translation>
    </message>
    <message>
        <source>What all charges together add to the velocity each frame.</source>
        <translation>Ce que toutes les charges ensemble ajoutent à la vitesse à chaque image.</translation>
    </message>
    <message>
        <source>charges</source>
        <translation>charges</translation>
    </message>
    <message>
        <source>Push points with like charges apart, and pull unlike ones together: the closer they are, the harder.</source>
        <translation>Repousse les points de charges semblables, et attire ceux de charges contraires&#xa0;: plus ils sont proches, plus fort.</translation>
    </message>
    <message>
        <source>two charges in one place</source>
        <translation>deux charges au même endroit</translation>
    </message>
    <message>
        <source>Two like charges begin in one place, where the force between them is greatest and has no direction.</source>
        <translation>Deux charges semblables commencent au même endroit, où la force entre elles est la plus grande et n’a pas de direction.</translation>
    </message>
    <message>
        <source>creature</source>
        <translation>créature</translation>
    </message>
    <message>
        <source>bodies</source>
        <translation>corps</translation>
    </message>
    <message>
        <source>branch</source>
        <translation>branche</translation>
    </message>
    <message>
        <source>your code</source>
        <translation>ton code</translation>
    </message>
    <message>
        <source>Your code</source>
        <translation>Ton code</translation>
    </message>
    <message>
        <source>Done by my rule</source>
        <translation>Fournie par ma règle</translation>
    </message>
    <message>
        <source>my rule</source>
        <translation>ma règle</translation>
    </message>
    <message>
        <source>Acts on bodies by the rule that you wrote.</source>
        <translation>Agit sur les corps selon la règle que tu as écrite.</translation>
    </message>
</context>
<context>
    <name>sim::Keys</name>
    <message>
        <source>there is no key %1; there is %2.</source>
        <translation>il n’y a pas de touche %1&#x202f;; il y a %2.</translation>
    </message>
</context>
</TS>
