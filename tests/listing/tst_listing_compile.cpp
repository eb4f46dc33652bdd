#include "app/listing/program.h"
#include "tests/listing/listing_support.h"
#include "tests/suite.h"

#include <QTest>

using namespace listing_support;

class ListingCompile : public QObject
{
    Q_OBJECT

private slots:
    void mistakeIsReportedInOneSentence_data();
    void mistakeIsReportedInOneSentence();
    void beginnersMistakeIsReportedAtItsPosition_data();
    void beginnersMistakeIsReportedAtItsPosition();
    void mistakeOutsideAFunctionBodyIsReported_data();
    void mistakeOutsideAFunctionBodyIsReported();
    void mistakesAreReportedInTheOrderOfTheText();
    void missingBraceIsReportedWhereItsBlockOpens_data();
    void missingBraceIsReportedWhereItsBlockOpens();
    void frameFunctionIsRequired();
    void boundsAreErrors_data();
    void boundsAreErrors();
    void theLongestListingCompiles();
};

void ListingCompile::mistakeIsReportedInOneSentence_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("error");
    // The line is line 3 of the listing.
    const auto row = [](const char *name, const char *line, const char *error) {
        QTest::newRow(name) << QString::fromUtf8(line) << QString::fromUtf8(error);
    };
    row("misspelt member", "body.velocty *= damp;",
        "3:6+7 'velocty' is not a member of Body. Did you mean 'velocity'?");
    row("unknown member", "body.colour = 1;",
        "3:6+6 'colour' is not a member of Body. It has position, velocity, before, held, mass and radius.");
    row("unknown member of a vector", "body.position.z = 1;",
        "3:15+1 'z' is not a member of Vec2. It has x and y.");
    row("array instead of a body", "feet.velocity *= damp;",
        "3:6+8 'velocity' is not a member of an array of bodies. Choose one of them first, for example with "
        "[0].");
    row("misspelt name", "body.velocity *= dmap;", "3:18+4 There is no 'dmap'. Did you mean 'damp'?");
    row("unknown name", "body.velocity *= wobble;",
        "3:18+6 There is no 'wobble'. This scene has body and feet, and the numbers damp, k and radius.");
    row("misspelt function", "double a = sine(1);", "3:12+4 There is no 'sine'. Did you mean 'sin'?");
    row("wrong values", "double a = sin(body.position);",
        "3:12+3 'sin' does not take these values: 'sin(Vec2)'. Write it as 'sin(angle)'.");
    row("unknown type", "Vector from = body.position;",
        "3:1+6 There is no type 'Vector'. The types are double, int, bool, Vec2 and Body.");
    row("misspelt type", "Vec from = body.position;", "3:1+3 There is no type 'Vec'. Did you mean 'Vec2'?");
    row("vector as a number", "double a = body.position;",
        "3:12+4 A Vec2 cannot be used as a double. Use its x, its y or its length.");
    row("vector plus number", "Vec2 a = body.position + 1;",
        "3:24+1 This sign does not work between a Vec2 and the other value. A Vec2 can be added to a Vec2, "
        "and multiplied or divided by a number.");
    row("number as a condition", "if (k) body.velocity *= k;",
        "3:5+1 A condition is true or false. Compare this with something, for example with == or >.");
    row("parameter is set", "k = 2;", "3:1+1 This is a parameter. Set it with its slider.");
    row("radius of a body is set", "body.radius = 2;",
        "3:6+6 This cannot be changed. A listing changes positions, velocities and its own variables.");
    row("body is replaced", "body = feet[0];",
        "3:1+4 A Body cannot be replaced by another one. Set its position or its velocity.");
    row("text in quotes", "body.velocity *= \"x\";",
        "3:18+1 Texts in quotes are not part of this language. It has numbers, bool and Vec2.");
    row("reserved word", "Vec2 out = body.position;",
        "3:6+3 'out' is reserved and not part of this language. Use another name.");
    row("handle", "Body @b = body;",
        "3:6+1 '@' is not part of this language. A Body variable already stands for the body itself.");
    row("number without a value", "double a; body.velocity *= a;",
        "3:8+1 'a' has no value yet. Give it one: 'double a = 0;'.");
    row("second number without a value", "int a = 1, b; body.velocity *= b;",
        "3:12+1 'b' has no value yet. Give it one: 'int b = 0;'.");
    row("letter outside ASCII", "double größe = 1;",
        "3:10+2 'ö' is not part of this language. A name has only the letters a to z, digits and '_'.");
    row("fraction for a whole number", "int a = atan2(1, 2);",
        "3:9+5 An 'int' keeps no fraction, and this value may have one. Write 'double', or round down with "
        "'floor(...)'.");
    row("fraction added to a whole number", "int a = 1; a += 0.5;",
        "3:17+3 An 'int' keeps no fraction, and this value may have one. Write 'double', or round down with "
        "'floor(...)'.");
    row("number with a fraction for a whole number", "int a = 2.5;",
        "3:9+3 An 'int' keeps no fraction, and this value may have one. Write 'double', or round down with "
        "'floor(...)'.");
    row("least of a whole number and another one", "int n = 3; int a = min(n, k);",
        "3:20+3 An 'int' keeps no fraction, and this value may have one. Write 'double', or round down with "
        "'floor(...)'.");
    row("whole numbers",
        "int n = 2.0; int a = min(n + 1, feet.count - 1) % 2; a = frame_number; a += 2 * floor(k);", "");
    row("large whole number", "double a = 9007199254740993;", "");
    row("name twice", "int a = 1; int a = 2;", "3:16+1 There already is 'a' here. Use another name.");
    row("single ampersand", "if (k > 1 & damp > 0) body.velocity.x = 1;",
        "3:11+1 '&' is not part of this language. Did you mean '&&'?");
    row("assignment as a condition", "if (k = 1) body.velocity.x = 1;",
        "3:7+1 '=' sets a value, and can be used once in a statement. To compare, write '=='.");
    row("value of a choice is set", "k > 1 ? body.position.x : body.position.y = 1;",
        "3:43+1 Only a variable can be set: a name, with members or an index behind it.");
    row("choice between a whole number and another one", "double a = damp < 1 ? 1 / damp : 1;",
        "3:12+4 Both values of a choice with ? need the same type. Write '1.0' for '1' beside a double.");
    row("chain of comparisons", "if (0 < k < 1) body.velocity.x = 1;",
        "3:11+1 Compare two values at a time, for example 'a < b && b < c'.");
    row("comparisons apart", "bool a = 0 < k && k <= 1 || (k == 2) != (k > 3 ? k < 9 : k > 1);", "");
    row("two assignments", "double a = 1; double b = 2; a = b = 3;",
        "3:35+1 '=' sets a value, and can be used once in a statement. To compare, write '=='.");
    row("assignments in the head of a loop", "for (int i = 0, j = 1; i <= j; i += 2) j -= 1;", "");
    row("switch", "switch (1) {}", "3:1+6 'switch' is reserved and not part of this language. Use 'if'.");
    row("power sign", "body.velocity.x = 2 ^ 3;",
        "3:21+1 '^' is not part of this language. A power is 'pow(a, b)'.");
    row("function without a value", "body.velocity.x = frame();",
        "3:19+5 'frame' returns no value, so call it on its own: 'frame(...);'.");
    row("number with a suffix", "double a = 1.5f;", "3:12+4 A number ends without 'f' here.");
    row("type around a number", "int a = int(2.7);", "3:9+3 Write the number itself, without 'int(...)'.");
    row("number as a constant vector", "const Vec2 z = true;", "3:16+4 A bool cannot be used as a Vec2.");
    row("missing value", "double a = ;", "3:12+1 A value is missing here.");
    row("missing semicolon", "body.velocity *= damp", "3:18+4 ';' is missing at the end of this line.");
    row("missing semicolon in a line", "if (k > 1) { body.velocity *= damp }", "3:36+1 ';' is missing here.");
    row("member without its body", "position += damp * hand;",
        "3:1+8 There is no 'position'. Write 'body.position'.");
    row("coordinate of a body", "body.x = 1;",
        "3:6+1 'x' is not a member of Body. Did you mean 'position.x'?");
    row("beginning of a member", "body.pos = hand;",
        "3:6+3 'pos' is not a member of Body. Did you mean 'position'?");
    row("longer name", "body.velocity *= damping;", "3:18+7 There is no 'damping'. Did you mean 'damp'?");
    row("other case", "bool a = True;", "3:10+4 There is no 'True'. Did you mean 'true'?");
    row("variable without a type", "x = 3;",
        "3:1+1 There is no 'x'. A new variable needs a type: 'double x', 'int x' or 'Vec2 x'.");
    row("printing", "print(k);",
        "3:1+5 There is no 'print'. A listing cannot print: its values are shown beside its lines.");
    row("unknown function", "jump(k);",
        "3:1+4 There is no function 'jump'. The functions are sin, cos, atan2, sqrt, pow, hypot, abs, min, "
        "max, "
        "clamp, floor, remainder, random, length, dot and direction.");
    row("factor without a sign", "body.velocity += k (hand - body.position);",
        "3:18+1 'k' is a double here, not a function. To multiply, write '*'.");
    row("difference of bodies", "Vec2 a = body - feet[0];",
        "3:15+1 This sign does not work between a Body and a Body. Use the position or the velocity of the "
        "body.");
    row("product of vectors", "Vec2 a = hand * hand;",
        "3:15+1 This sign does not work between a Vec2 and a Vec2. A Vec2 can be added to a Vec2, and "
        "multiplied "
        "or divided by a number.");
    row("array as a body", "Body a = feet;",
        "3:10+4 This is an array of bodies. Choose one of them first, for example with [0].");
    row("type in place of a body", "Body.velocity *= damp;",
        "3:1+4 'Body' is a type and has no value. Write 'body'.");
    row("number as a vector", "body.velocity = 0;",
        "3:17+1 An int cannot be used as a Vec2. Write a position or a velocity as 'Vec2(x, y)'.");
    row("body as a vector", "body.position = feet[0];",
        "3:17+4 A Body cannot be used as a Vec2. Use the position or the velocity of the body.");
    row("number as a truth value", "bool a = 1;",
        "3:10+1 An int cannot be used as a bool. Write 'true' or 'false'.");
    row("number added to a vector", "body.position += 1;",
        "3:1+4 This sign does not work between a Vec2 and the other value. A Vec2 can be added to a Vec2, "
        "and "
        "multiplied or divided by a number.");
    row("opposite of a number", "if (!k) body.velocity *= k;",
        "3:5+1 A condition is true or false. Compare this with something, for example with == or >.");
    row("vector that is counted", "body.position++;", "3:14+1 This sign does not work with this value.");
    row("foot is replaced", "if (k > 1) feet[0] = body;",
        "3:12+4 A Body cannot be replaced by another one. Set its position or its velocity.");
    row("array as a function", "feet(0).velocity *= damp;",
        "3:1+4 This is an array of bodies. Choose one of them first, for example with [0].");
    row("array without a number", "feet[].velocity *= damp;",
        "3:5+1 This is an array of bodies. Choose one of them first, for example with [0].");
    row("body as an array", "feet[0][1].velocity *= damp;", "3:8+1 Only an array has an index in '[...]'.");
    row("constant divided by 0", "double a = k / 0.0;", "3:14+1 This divides by 0.");
    row("number as a function", "body.velocity.x += 2(k);",
        "3:21+1 This is not a function. To multiply, write '*'.");
    row("function without brackets", "double a = abs -3;", "3:16+1 Write it as 'abs(x)'.");
    row("break without a loop", "break;", "3:1+5 'break' works only in a loop.");
    row("continue without a loop", "continue;", "3:1+8 'continue' works only in a loop.");
    row("unused sum", "body.position.x + 3;",
        "3:1+4 This computes a value, and nothing keeps it. To set a value, write '='.");
    row("unused call", "length(hand);",
        "3:1+6 This computes a value, and nothing keeps it. To set a value, write '='.");
    row("statements with an effect", "Vec2 v; ; int i = 0; i++; --i; do i += 1; while (i < 3); v.x = 1;", "");
    row("value of a function without one", "return 5;",
        "3:1+6 A 'void' function returns no value. Write 'return;'.");
}

void ListingCompile::mistakeIsReportedInOneSentence()
{
    QFETCH(QString, line);
    QFETCH(QString, error);
    QCOMPARE(QString::fromStdString(errorsOf(frameOf(line.toStdString()))), error);
}

void ListingCompile::beginnersMistakeIsReportedAtItsPosition_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("error");
    const auto row = [](const char *name, const char *line, const char *error) {
        QTest::newRow(name) << QString::fromUtf8(line) << QString::fromUtf8(error);
    };
    row("no semicolon between lines", "body.velocity *= damp\nbody.position += body.velocity;",
        "3:18+4 ';' is missing at the end of this line.");
    row("no semicolon behind a bracket", "body.velocity = Vec2(1, 2)\nbody.position = hand;",
        "3:26+1 ';' is missing at the end of this line.");
    row("a statement over lines", "double a = k\n+ damp;\nif (k > 1\nand a > 1)\na = 1;\nelse\na = 2;", "");
    row("no semicolon before else", "if (k > 1) body.position = hand else body.velocity *= k;",
        "3:33+4 ';' is missing before 'else'.");
    row("open bracket", "body.velocity *= (damp;\nbody.position = hand;", "3:18+1 This '(' has no ')'.");
    row("open bracket of a loop", "for (int i = 0; i < 2; i++ { }", "3:5+1 This '(' has no ')'.");
    row("closing bracket", "body.velocity *= damp);", "3:22+1 This ')' has no '('.");
    row("closing brace", "if (k > 1)\nbody.velocity *= damp;\n}", "6:1+1 This '}' has no '{'.");
    row("array", "array<double> a;", "3:1+5 A listing cannot make arrays. Write a variable for each value.");
    row("array with a length", "double a[9];",
        "3:1+6 A listing cannot make arrays. Write a variable for each value.");
    row("array type", "Vec2[] a;", "3:1+4 A listing cannot make arrays. Write a variable for each value.");
    row("decimal comma", "body.velocity *= 0,9;", "3:18+3 A number has a point, not a comma: '0.9'.");
    row("arguments are no decimals", "body.velocity = Vec2(1,2) + pow(1,2) * hand;", "");
    row("number before a name", "body.velocity *= 2k;",
        "3:18+2 Write '*' between a number and a name: '2 * k'.");
    row("numbers with an exponent or another base", "double a = 1e3 + 1e-3 + 0x1F + 1. + .5;", "");
    row("half of a whole number", "double a = 1 / 2;",
        "3:14+1 Between whole numbers, '/' drops the fraction: this is 0. Write '1.0 / 2'.");
    row("half of an even number", "double a = 4 / 2 + 1.0 / 2 + feet.count / 2;", "");
    row("place in brackets", "body.position = (1, 2);",
        "3:17+1 Write a position or a velocity as 'Vec2(x, y)'.");
    row("condition without brackets", "if k > 1 { }", "3:1+2 A condition needs brackets: 'if (...)'.");
    row("colon", "if (k > 1):\nbody.position = hand;",
        "3:11+1 Leave out the ':'. The lines that belong to a condition go between '{' and '}'.");
    row("then", "if (k > 1) then body.position = hand;",
        "3:12+4 'then' is not part of this language. Leave it out.");
    row("semicolon behind a condition", "if (k > 1);\nbody.position = hand;",
        "3:11+1 This ';' ends 'if', so that nothing belongs to it. Delete the ';'.");
    row("semicolon behind do and while", "double a = 1; do a += 1; while (a < 3);", "");
    row("semicolon behind the head of a loop", "for (int i = 0; i < 3; i++);\n    feet[i].velocity *= damp;",
        "3:28+1 This ';' ends 'for', so that nothing belongs to it. Delete the ';'.");
    row("else without if",
        "if (k > 1)\nbody.velocity *= k;\nbody.position = hand;\nelse\nbody.position = hand;",
        "6:1+4 This 'else' has no 'if'. The lines that belong to a condition go between '{' and '}'.");
    row("no dot behind an index", "feet[0]velocity *= damp;", "3:8+8 '.' is missing before 'velocity'.");
    row("comma in place of a dot", "body.position,x = 3;",
        "3:14+1 Write '.' between a body and its member, for example 'body.position'.");
    row("name that begins with a digit", "double 2nd = 3;", "3:8+3 A name begins with a letter.");
    row("number before a name with a space", "body.velocity *= 2 k;",
        "3:18+1 Write '*' between a number and a name: '2 * k'.");
    row("share of a count", "double a = 1 / feet.count;",
        "3:14+1 Between whole numbers, '/' drops the fraction. Write '1.0 / feet.count'.");
    row("minus and equals swapped", "body.position.x =- 3;", "3:17+1 Write '-=' to subtract from a value.");
    row("negative value", "body.position.x = -3; body.position.x =-k;", "");
    row("unequal in another language", "if (k <> 1) body.position = hand;", "3:7+1 Write '!=' to compare.");
    row("place in braces", "Vec2 a = {1, 2};", "3:10+1 Write a position or a velocity as 'Vec2(x, y)'.");
    row("place in square brackets", "Vec2 a = [1, 2];",
        "3:10+1 Write a position or a velocity as 'Vec2(x, y)'.");
    row("member as a function", "if (body.held()) body.position = hand;",
        "3:10+4 'held' is not a function. Write it without '()'.");
    row("comment without an end", "/* hand\nbody.position = hand;", "3:1+2 This '/*' has no '*/'.");
    row("sign of a printed product", "body.velocity.x = 3 × k;",
        "3:21+2 '×' is not part of this language. To multiply, write '*'.");
    row("printed minus", "body.velocity.x = k − 2;", "3:21+3 '−' is not part of this language. Write '-'.");
    row("printed pi", "body.velocity.x = π;", "3:19+2 'π' is not part of this language. Write 'pi'.");
    row("printed root", "body.velocity.x = √k;", "3:19+3 '√' is not part of this language. Write 'sqrt(x)'.");
    row("printed square", "body.velocity.x = k²;",
        "3:20+2 '²' is not part of this language. A power is 'pow(a, b)'.");
    row("output", "cout << k;",
        "3:6+1 '<<' is not part of this language. A listing cannot print: its values are shown beside its "
        "lines.");
    row("capital letter", "If (k > 1) body.position = hand;", "3:1+2 Write 'if' with small letters.");
    row("elif", "if (k > 1) { } elif (k > 2) { }",
        "3:16+4 'elif' is not part of this language. Use 'else if'.");
    row("loop over values", "for (Body foot : feet) foot.velocity *= damp;",
        "3:1+3 A loop is written 'for (int i = 0; i < 5; i++)'.");
    row("loop with commas", "for (int i = 0, i < 3, i++) feet[i].velocity *= damp;",
        "3:1+3 A loop is written 'for (int i = 0; i < 5; i++)'.");
    row("loop with a choice", "for (int i = 0; k > 1 ? i < 2 : i < 3; i++) { }", "");
    row("new", "body.position = new Vec2(1, 2);", "3:17+3 'new' is not part of this language. Leave it out.");
    row("comparison in place of a value", "body.position == hand;",
        "3:15+1 '==' compares and changes nothing. To set a value, write '='.");
    row("comparison behind a condition", "if (k == 1) body.position == hand;",
        "3:27+1 '==' compares and changes nothing. To set a value, write '='.");
    row("comparisons with a use", "bool a = k == 1; a = k == 2 || a == (k != 1);", "");
    row("sign and equals swapped", "body.velocity =+ hand;", "3:15+1 Write '+=' to add to a value.");
    row("greater or equal swapped", "if (k => 1) body.position = hand;", "3:7+1 Write '>=' to compare.");
    row("space in a sign", "body.velocity * = damp;", "3:15+1 Write '*=' without a space in between.");
    row("arrow", "body->velocity *= damp;",
        "3:5+1 Write '.' between a body and its member, for example 'body.position'.");
    row("method", "double a = body.velocity.length();",
        "3:26+6 A function is called without an object here: 'length(...)'.");
    row("other languages' number", "float a = 1;",
        "3:1+5 'float' is reserved and not part of this language. Use 'double'.");
    row("other languages' comment", "# move",
        "3:1+1 '#' is not part of this language. A comment begins with '//'.");
}

void ListingCompile::beginnersMistakeIsReportedAtItsPosition()
{
    mistakeIsReportedInOneSentence();
}

void ListingCompile::mistakeOutsideAFunctionBodyIsReported_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("error");
    QTest::newRow("no function") << "body.velocity *= damp;"
                                 << "1:1+4 This is outside of any function. Put it between the braces of "
                                    "a function.";
    QTest::newRow("array") << "array<double> a(9);\nvoid frame() {}"
                           << "1:1+5 A listing cannot make arrays. Write a variable for each value.";
    QTest::newRow("a brace too many")
        << "void frame()\n{\nif (k > 1)\nbody.position = hand;\n}\nelse\n{\n}\n}"
        << "6:1+4 This is outside of any function. Look for a '}' too many above.";
    QTest::newRow("no type")
        << "frame()\n{\n}"
        << "1:1+5 A function begins with the type of its result, for example 'void' or 'Vec2'.";
    QTest::newRow("another language")
        << "def frame():\n    body.position = hand"
        << "1:1+3 A function begins with the type of its result, for example 'void' or 'Vec2'.";
    QTest::newRow("no brace") << "void frame()\n    body.position = hand;"
                              << "1:12+1 '{' is missing at the end of this line.";
    QTest::newRow("no brackets") << "void frame\n{\n}"
                                 << "1:1+4 'void' is only for functions, for example 'void frame()'.";
    QTest::newRow("semicolon behind the head")
        << "void frame();\n{\n    body.position = hand;\n}"
        << "1:13+1 This ';' ends 'frame', so that nothing belongs to it. Delete the ';'.";
    QTest::newRow("function in a function")
        << "void frame()\n{\n    void stop()\n    {\n    }\n    stop();\n}"
        << "3:5+4 A function cannot be inside another function. Move it out.";
    QTest::newRow("function twice") << "void frame() {}\nvoid frame() {}"
                                    << "2:1+4 There already is 'frame' here. Use another name.";
    QTest::newRow("function of the listing with other values")
        << "void stop(Body me) { me.velocity = Vec2(0, 0); }\nvoid frame() { stop(); }"
        << "2:16+4 'stop' does not take these values: 'stop()'. Write it as 'stop(Body me)'.";
    QTest::newRow("all kinds") << "double a = 1;\nconst Vec2 b(1, 2);\nVec2 twice(Vec2 v) { return 2 * v; }\n"
                                  "void frame() { }"
                               << QString();
}

void ListingCompile::mistakeOutsideAFunctionBodyIsReported()
{
    QFETCH(QString, text);
    QFETCH(QString, error);
    QCOMPARE(QString::fromStdString(errorsOf(text.toStdString())), error);
}

void ListingCompile::mistakesAreReportedInTheOrderOfTheText()
{
    QCOMPARE(errorsOf(frameOf("body.velocty *= damp;\nbody.velocity *= dmap;")),
             std::string("3:6+7 'velocty' is not a member of Body. Did you mean 'velocity'?\n"
                         "4:18+4 There is no 'dmap'. Did you mean 'damp'?"));
}

void ListingCompile::missingBraceIsReportedWhereItsBlockOpens_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("error");
    QTest::newRow("at the end") << "void frame()\n{\n    body.position = hand;\n"
                                << "2:1+1 This '{' has no '}'.";
    QTest::newRow("in a function above")
        << "Vec2 pull(Body me)\n{\n    Vec2 from = hand;\n\nvoid frame()\n{\n}\n"
        << "2:1+1 This '{' has no '}'.";
    QTest::newRow("inside, told by the indents")
        << "void frame()\n{\n    if (k > 1)\n    {\n        body.position = hand;\n}\n"
        << "4:5+1 This '{' has no '}'.";
    QTest::newRow("bracket at the end") << "void frame()\n{\n    body.position = Vec2(1, 2\n"
                                        << "3:25+1 This '(' has no ')'.";
    QTest::newRow("a mistake before the end is said first")
        << "Vec2 pull(Body me)\n{\n    Vec2 from = me.positon;\n    double a = dmap;\nvoid frame()\n{\n}\n"
        << "3:20+7 'positon' is not a member of Body. Did you mean 'position'?\n"
           "4:16+4 There is no 'dmap'. Did you mean 'damp'?\n2:1+1 This '{' has no '}'.";
    QTest::newRow("no semicolon before the end") << "void frame()\n{\n    body.velocity *= damp\n"
                                                 << "3:22+4 ';' is missing at the end of this line.\n"
                                                    "2:1+1 This '{' has no '}'.";
    QTest::newRow("a brace too many elsewhere")
        << "Vec2 pull(Body me)\n{\n    return hand;\nvoid frame()\n{\n}\n}\n"
        << "2:1+1 This '{' has no '}'.";
}

void ListingCompile::missingBraceIsReportedWhereItsBlockOpens()
{
    mistakeOutsideAFunctionBodyIsReported();
}

void ListingCompile::frameFunctionIsRequired()
{
    QCOMPARE(errorsOf("void fram() {}"),
             std::string("1:1+4 The function 'void frame()' is missing. It runs once in every frame."));
    QCOMPARE(errorsOf(""),
             std::string("1:1+1 The function 'void frame()' is missing. It runs once in every frame."));
}

void ListingCompile::boundsAreErrors_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("error");
    const auto repeat = [](const char *text, int count) { return QString::fromUtf8(text).repeated(count); };
    const QString frame = QStringLiteral("void frame() { ");
    QString globals;
    for (int i = 0; i < 1100; ++i)
        globals += QStringLiteral("double a%1 = 0;\n").arg(i);
    QTest::newRow("text") << repeat("// 8901\n", 2501)
                          << "1:1+1 This listing has 20008 bytes. The most is 20000.";
    QTest::newRow("brackets") << frame + "double a = " + repeat("(", 39) + "1" + repeat(")", 39) + "; }"
                              << QString();
    QTest::newRow("too many brackets")
        << frame + "double a = " + repeat("(", 60) + "1" + repeat(")", 60) + "; }"
        << "1:66+1 There are more than 40 brackets inside one another.";
    QTest::newRow("statement") << frame + "double a = 1" + repeat(" + 1", 240) + "; }" << QString();
    QTest::newRow("long statement") << frame + "double a = 1" + repeat(" + 1", 300) + "; }"
                                    << "1:1021+1 This statement is too long. Split it in two.";
    QTest::newRow("else") << frame + repeat("if (k > 1) {} else ", 201) + "{} }"
                          << "1:3830+4 There are more than 200 'else' in this listing.";
    QTest::newRow("global variables")
        << globals + "void frame() {}"
        << "1:1+6 The variables outside of functions take 8800 bytes. The most is 8192.";
    QTest::newRow("body as a global variable")
        << "Body b = body;\nvoid frame() {}"
        << "1:6+1 'b' cannot be remembered from frame to frame. Only numbers, bool and Vec2 can.";
    QTest::newRow("class") << "class A { A @next; }\nvoid frame() {}"
                           << "1:1+5 'class' is reserved and not part of this language. Use another name.";
}

void ListingCompile::boundsAreErrors()
{
    mistakeOutsideAFunctionBodyIsReported();
}

void ListingCompile::theLongestListingCompiles()
{
    QString longest = QStringLiteral("void frame()\n{\n");
    while (longest.size() < 19'900)
        longest += QStringLiteral("    body.velocity += k * (feet[0].position - body.position);\n");
    QVERIFY(listing::Program::compile((longest + "}\n").toStdString(), listing::vocabularyOf(threeFeet()))
                .program);
}

SUITE(tst_listing_compile, ListingCompile)
#include "tst_listing_compile.moc"
