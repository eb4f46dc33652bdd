<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>lesson.json</name>
    <message>
        <source>Multi-foot</source>
        <translation>Viele Füße</translation>
    </message>
    <message>
        <source>One body on many feet: pulls add up, and so does stiffness.</source>
        <translation>Ein Körper auf vielen Füßen: Züge addieren sich, und Steifigkeit auch.</translation>
    </message>
</context>
</TS>
