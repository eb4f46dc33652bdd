<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="es" sourcelanguage="en">
<context>
    <name>Sandbox</name>
    <message>
        <source>Chain</source>
        <translation>Cadena</translation>
    </message>
    <message>
        <source>Seven sticks on a nail. Pull the end aside and let go.</source>
        <translation>Siete barras en un clavo. Tira del extremo hacia un lado y suelta.</translation>
    </message>
    <message>
        <source>Bridge</source>
        <translation>Puente</translation>
    </message>
    <message>
        <source>A truss between two nails, with a load on a spring. Make the load heavier.</source>
        <translation>Una celosía entre dos clavos, con una carga en un muelle. Haz más pesada la carga.</translation>
    </message>
    <message>
        <source>Jelly</source>
        <translation>Gelatina</translation>
    </message>
    <message>
        <source>A grid of springs. Throw it into a corner.</source>
        <translation>Una cuadrícula de muelles. Lánzala a un rincón.</translation>
    </message>
    <message>
        <source>Walker</source>
        <translation>Cuadrúpedo</translation>
    </message>
    <message>
        <source>Four feet in two gait groups, which turns round at the walls.</source>
        <translation>Cuatro pies en dos grupos de marcha, que da la vuelta en las paredes.</translation>
    </message>
    <message>
        <source>Cradle</source>
        <translation>Péndulo de Newton</translation>
    </message>
    <message>
        <source>Five balls side by side: what comes in on the left goes out on the right.</source>
        <translation>Cinco bolas en fila: lo que llega por la izquierda sale por la derecha.</translation>
    </message>
    <message>
        <source>Wheel</source>
        <translation>Rueda</translation>
    </message>
    <message>
        <source>A rim of sticks with springs for spokes, on a floor that holds.</source>
        <translation>Una llanta de barras con muelles por radios, sobre un suelo que sujeta.</translation>
    </message>
    <message>
        <source>Cloth</source>
        <translation>Tela</translation>
    </message>
    <message>
        <source>A net of springs on three nails, in a little wind.</source>
        <translation>Una red de muelles en tres clavos, con un poco de viento.</translation>
    </message>
    <message>
        <source>Tree</source>
        <translation>Árbol</translation>
    </message>
    <message>
        <source>A trunk of braced springs whose leaves catch the wind.</source>
        <translation>Un tronco de muelles apuntalados cuyas hojas atrapan el viento.</translation>
    </message>
    <message>
        <source>Ragdoll</source>
        <translation>Muñeco de trapo</translation>
    </message>
    <message>
        <source>Fourteen sticks that fall. Lift it by a hand.</source>
        <translation>Catorce barras que caen. Levántalo por una mano.</translation>
    </message>
    <message>
        <source>Trampoline</source>
        <translation>Cama elástica</translation>
    </message>
    <message>
        <source>A heavy ball on a net of springs, and bodies that push each other away.</source>
        <translation>Una bola pesada sobre una red de muelles, y cuerpos que se empujan unos a otros.</translation>
    </message>
    <message>
        <source>Crystal</source>
        <translation>Cristal</translation>
    </message>
    <message>
        <source>Positive and negative charges find each other and form a crystal. Give one the other sign.</source>
        <translation>Cargas positivas y negativas se encuentran y forman un cristal. Dale a una el otro signo.</translation>
    </message>
    <message>
        <source>Magnets</source>
        <translation>Imanes</translation>
    </message>
    <message>
        <source>Seven magnets find each other. Pull one away and let go.</source>
        <translation>Siete imanes se encuentran. Aparta uno y suéltalo.</translation>
    </message>
    <message>
        <source>Wind profile</source>
        <translation>Perfil del viento</translation>
    </message>
    <message>
        <source>The wind is slow near the ground and fast high up. Change how fast it grows with the height.</source>
        <translation>El viento es lento cerca del suelo y rápido en lo alto. Cambia lo deprisa que crece con la altura.</translation>
    </message>
    <message>
        <source>Hardening spring</source>
        <translation>Muelle progresivo</translation>
    </message>
    <message>
        <source>The right spring hardens when it stretches, so it swings faster. Pull both down equally far.</source>
        <translation>El muelle derecho se endurece al estirarse, así que oscila más rápido. Baja los dos lo mismo.</translation>
    </message>
    <message>
        <source>Planet</source>
        <translation>Planeta</translation>
    </message>
    <message>
        <source>A planet on a circle and a comet on an ellipse. Write another power of the distance than 3.</source>
        <translation>Un planeta en un círculo y un cometa en una elipse. Escribe otra potencia de la distancia que 3.</translation>
    </message>
    <message>
        <source>Pumped swing</source>
        <translation>Columpio impulsado</translation>
    </message>
    <message>
        <source>A motor pushes a swing in its own rhythm. Change the rhythm a little: the swing stays low.</source>
        <translation>Un motor empuja un columpio a su propio ritmo. Cambia un poco el ritmo: el columpio se queda bajo.</translation>
    </message>
    <message>
        <source>Drag of the air</source>
        <translation>Resistencia del aire</translation>
    </message>
    <message>
        <source>The drag grows with the square of the speed: fast swings end soon, slow ones go on.</source>
        <translation>La resistencia crece con el cuadrado de la rapidez: las oscilaciones rápidas acaban pronto, las lentas siguen.</translation>
    </message>
    <message>
        <source>Flock</source>
        <translation>Bandada</translation>
    </message>
    <message>
        <source>Twenty dots that watch their neighbours. Remove one of the three habits.</source>
        <translation>Veinte puntos que miran a sus vecinos. Quita una de las tres costumbres.</translation>
    </message>
    <message>
        <source>Whirlpool</source>
        <translation>Remolino</translation>
    </message>
    <message>
        <source>Water carries bodies round its middle. Let the water turn the other way.</source>
        <translation>El agua lleva los cuerpos alrededor de su centro. Haz que gire en el otro sentido.</translation>
    </message>
    <message>
        <source>Leash</source>
        <translation>Correa</translation>
    </message>
    <message>
        <source>A leash pulls only when it is tight. Make it longer, or tie a third dog to it.</source>
        <translation>Una correa solo tira cuando está tensa. Hazla más larga o ata a ella un tercer perro.</translation>
    </message>
    <message>
        <source>Hovering platform</source>
        <translation>Plataforma flotante</translation>
    </message>
    <message>
        <source>A platform compares its place with its goal, and follows your pointer. Change how hard it corrects.</source>
        <translation>Una plataforma compara su posición con su meta y sigue tu puntero. Cambia con qué fuerza corrige.</translation>
    </message>
</context>
<context>
    <name>lesson.json</name>
    <message>
        <source>Build your own</source>
        <translation>Construye tu escena</translation>
    </message>
    <message>
        <source>Points, springs, sticks, feet and walls: a scene that you build yourself.</source>
        <translation>Puntos, muelles, barras, pies y paredes: una escena que construyes tú.</translation>
    </message>
</context>
<context>
    <name>sim</name>
    <message>
        <source>points</source>
        <translation>puntos</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>bola</translation>
    </message>
    <message>
        <source>left</source>
        <translation>izquierda</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>centro</translation>
    </message>
    <message>
        <source>right</source>
        <translation>derecha</translation>
    </message>
    <message>
        <source>load</source>
        <translation>carga</translation>
    </message>
    <message>
        <source>post</source>
        <translation>poste</translation>
    </message>
    <message>
        <source>dog</source>
        <translation>perro</translation>
    </message>
    <message>
        <source>puppy</source>
        <translation>cachorro</translation>
    </message>
    <message>
        <source>sun</source>
        <translation>sol</translation>
    </message>
    <message>
        <source>planet</source>
        <translation>planeta</translation>
    </message>
    <message>
        <source>comet</source>
        <translation>cometa</translation>
    </message>
    <message>
        <source>nail</source>
        <translation>clavo</translation>
    </message>
    <message>
        <source>seat</source>
        <translation>asiento</translation>
    </message>
    <message>
        <source>foot</source>
        <translation>pie</translation>
    </message>
    <message>
        <source>body</source>
        <translation>cuerpo</translation>
    </message>
</context>
</TS>
