<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>StabilityText</name>
    <message numerus="yes">
        <source>Use %n &amp;passes</source>
        <translation>
            <numerusform>Use %n &amp;pass</numerusform>
            <numerusform>Use %n &amp;passes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::ExperimentFiles</name>
    <message numerus="yes">
        <source>Copied: %n character(s), in one line.</source>
        <translation>
            <numerusform>Copied: %n character, in one line.</numerusform>
            <numerusform>Copied: %n characters, in one line.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::RemedySearch</name>
    <message numerus="yes">
        <source>Tested: it is stable for %n frames.</source>
        <translation>
            <numerusform>Tested: it is stable for %n frame.</numerusform>
            <numerusform>Tested: it is stable for %n frames.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::RulePanel</name>
    <message numerus="yes">
        <source>pull acts along %n rule links.</source>
        <translation>
            <numerusform>pull acts along %n rule link.</numerusform>
            <numerusform>pull acts along %n rule links.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>app::SettlingPlot</name>
    <message numerus="yes">
        <source>at rest after %n frames</source>
        <translation>
            <numerusform>at rest after %n frame</numerusform>
            <numerusform>at rest after %n frames</numerusform>
        </translation>
    </message>
</context>
</TS>
