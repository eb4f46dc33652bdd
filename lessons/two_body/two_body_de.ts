<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>lesson.json</name>
    <message>
        <source>Two bodies</source>
        <translation>Zwei Körper</translation>
    </message>
    <message>
        <source>A foot and a body pull each other: whose turn it is makes a difference.</source>
        <translation>Ein Fuß und ein Körper ziehen aneinander: Es macht einen Unterschied, wer gerade dran ist.</translation>
    </message>
</context>
</TS>
