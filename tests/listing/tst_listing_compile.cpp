#include "app/listing/limits.h"
#include "app/listing/program.h"
#include "tests/listing/listing_support.h"
#include "tests/suite.h"

#include <QTest>

using namespace listing_support;

class ListingCompile : public QObject
{
    Q_OBJECT

private slots:
    void everyNameOfTheVocabularyCompiles();
    void mistakeIsSaidInOneSentence_data();
    void mistakeIsSaidInOneSentence();
    void slipOfABeginnerIsFoundWhereItIs_data();
    void slipOfABeginnerIsFoundWhereItIs();
    void codeStandsInFunctions_data();
    void codeStandsInFunctions();
    void severalMistakesComeInTheOrderOfTheText();
    void aMissingBraceIsSaidWhereItOpens_data();
    void aMissingBraceIsSaidWhereItOpens();
    void frameFunctionIsRequired();
    void boundsAreErrors_data();
    void boundsAreErrors();
    void vocabularyFollowsTheNamesOfTheScene();
    void reservedNamesAreLeftOutOfTheVocabulary();
    void creaturesAreInTheVocabulary();
    void mistakeWithCreaturesIsSaidInOneSentence_data();
    void mistakeWithCreaturesIsSaidInOneSentence();
    void branchesAndSticksAreInTheVocabulary();
    void mistakeWithBranchesOrSticksIsSaidInOneSentence_data();
    void mistakeWithBranchesOrSticksIsSaidInOneSentence();
    void theLongestListingCompiles();
};

void ListingCompile::everyNameOfTheVocabularyCompiles()
{
    QCOMPARE(errorsOf(frameOf(R"(
        Vec2 v = body.position + feet[0].velocity - Vec2(1, 2);
        v = -v;
        v *= 2; v /= 2; v += v; v -= v;
        v = 2 * v; v = v * 2; v = v / 2;
        bool same = v == Vec2() && v != Vec2(1, 1);
        double all = length(v) + dot(v, v) + v.x + v.y + sin(1) + cos(1) + atan2(1, 2) + sqrt(2) + pow(2, 3) +
                     hypot(3, 4) + remainder(5, 3) + random(1, 2) + abs(-1) + min(1, 2) + max(1, 2) + clamp(3, 1, 2) + floor(1.5) + random(0) + pi;
        all += k + damp + radius + frame_number + body.mass + body.radius + feet.count;
        v = direction(body, feet[0]) + direction(body, v) + direction(v, pointer, body) + body.before;
        all += new_targets.count > 0 ? new_targets[0].x : 0;
        all += hand.x + pointer.x + target.y;
        if (keys.left || keys.right || keys.up || keys.down || pointer_down || pointer_known || body.held || same)
            all += 1;
        auto whole = 3 % 2;
        for (int i = 0; i < feet.count; ++i) { if (i == 1) continue; if (i == 2) break; }
        while (all > 1e9) all /= 2;
        do { all -= 1; } while (all > 1e9);
        if (whole == 1) all = 1;
        body.velocity.x = all > 0 ? 1 : 2;)")),
             std::string());
}

void ListingCompile::mistakeIsSaidInOneSentence_data()
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
    row("vector as a number", "double a = body.position;", "3:12+4 A Vec2 cannot be used as a double.");
    row("vector plus number", "Vec2 a = body.position + 1;",
        "3:24+1 This sign does not work between a Vec2 and the other value. A Vec2 can be added to a Vec2, "
        "and multiplied or divided by a number.");
    row("number as a condition", "if (k) body.velocity *= k;",
        "3:5+1 A condition is true or false. Compare this with something, for example with == or >.");
    row("parameter is set", "k = 2;",
        "3:1+1 This cannot be changed. A listing changes positions, velocities and its own variables.");
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
    row("letter outside ASCII", "double größe = 1;", "3:10+2 'ö' is not part of this language.");
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
        "3:7+1 '=' sets a value, and stands once in a statement. To compare, write '=='.");
    row("value of a choice is set", "k > 1 ? body.position.x : body.position.y = 1;",
        "3:43+1 Only a variable can be set: a name, with members or an index behind it.");
    row("choice between a whole number and another one", "double a = damp < 1 ? 1 / damp : 1;",
        "3:12+4 Both values of a choice with ? need the same type. Write '1.0' for '1' beside a double.");
    row("chain of comparisons", "if (0 < k < 1) body.velocity.x = 1;",
        "3:11+1 Compare two values at a time, for example 'a < b && b < c'.");
    row("comparisons apart", "bool a = 0 < k && k <= 1 || (k == 2) != (k > 3 ? k < 9 : k > 1);", "");
    row("two assignments", "double a = 1; double b = 2; a = b = 3;",
        "3:35+1 '=' sets a value, and stands once in a statement. To compare, write '=='.");
    row("assignments in the head of a loop", "for (int i = 0, j = 1; i <= j; i += 2) j -= 1;", "");
    row("switch", "switch (1) {}", "3:1+6 'switch' is reserved and not part of this language. Use 'if'.");
    row("power sign", "body.velocity.x = 2 ^ 3;",
        "3:21+1 '^' is not part of this language. A power is 'pow(a, b)'.");
    row("function without a value", "body.velocity.x = frame();",
        "3:19+5 'frame' has no value, so it stands alone: 'frame(...);'.");
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
    row("unknown function", "print(k);",
        "3:1+5 There is no function 'print'. The functions are sin, cos, atan2, sqrt, pow, hypot, abs, min, "
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
    row("value of a function without one", "return 5;",
        "3:1+6 A 'void' function returns no value. Write 'return;'.");
}

void ListingCompile::slipOfABeginnerIsFoundWhereItIs_data()
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
        "3:17+1 A place or a velocity is written 'Vec2(x, y)'.");
    row("condition without brackets", "if k > 1 { }", "3:1+2 A condition stands in brackets: 'if (...)'.");
    row("colon", "if (k > 1):\nbody.position = hand;",
        "3:11+1 No ':' stands here. The lines that belong to a condition stand between '{' and '}'.");
    row("then", "if (k > 1) then body.position = hand;", "3:12+4 No 'then' stands here.");
    row("semicolon behind a condition", "if (k > 1);\nbody.position = hand;",
        "3:11+1 This ';' ends the 'if', so that nothing belongs to it. Delete the ';'.");
    row("semicolon behind do and while", "double a = 1; do a += 1; while (a < 3);", "");
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
        "3:26+6 A function stands alone here: 'length(...)'.");
    row("other languages' number", "float a = 1;",
        "3:1+5 'float' is reserved and not part of this language. Use 'double'.");
    row("other languages' comment", "# move",
        "3:1+1 '#' is not part of this language. A comment begins with '//'.");
}

void ListingCompile::slipOfABeginnerIsFoundWhereItIs()
{
    mistakeIsSaidInOneSentence();
}

void ListingCompile::codeStandsInFunctions_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("error");
    QTest::newRow("no function") << "body.velocity *= damp;"
                                 << "1:1+4 This stands outside of a function. Put it between the braces of "
                                    "a function.";
    QTest::newRow("array") << "array<double> a(9);\nvoid frame() {}"
                           << "1:1+5 A listing cannot make arrays. Write a variable for each value.";
    QTest::newRow("a brace too many")
        << "void frame()\n{\nif (k > 1)\nbody.position = hand;\n}\nelse\n{\n}\n}"
        << "6:1+4 This stands outside of a function. Look for a '}' too many above.";
    QTest::newRow("no type")
        << "frame()\n{\n}"
        << "1:1+5 A function begins with the type of its result, for example 'void' or 'Vec2'.";
    QTest::newRow("another language")
        << "def frame():\n    body.position = hand"
        << "1:1+3 A function begins with the type of its result, for example 'void' or 'Vec2'.";
    QTest::newRow("no brace") << "void frame()\n    body.position = hand;"
                              << "1:12+1 '{' is missing at the end of this line.";
    QTest::newRow("no brackets") << "void frame\n{\n}"
                                 << "1:1+4 'void' stands only before a function, for example 'void frame()'.";
    QTest::newRow("all kinds") << "double a = 1;\nconst Vec2 b(1, 2);\nVec2 twice(Vec2 v) { return 2 * v; }\n"
                                  "void frame() { }"
                               << QString();
}

void ListingCompile::codeStandsInFunctions()
{
    QFETCH(QString, text);
    QFETCH(QString, error);
    QCOMPARE(QString::fromStdString(errorsOf(text.toStdString())), error);
}

void ListingCompile::mistakeIsSaidInOneSentence()
{
    QFETCH(QString, line);
    QFETCH(QString, error);
    QCOMPARE(QString::fromStdString(errorsOf(frameOf(line.toStdString()))), error);
}

void ListingCompile::severalMistakesComeInTheOrderOfTheText()
{
    QCOMPARE(errorsOf(frameOf("body.velocty *= damp;\nbody.velocity *= dmap;")),
             std::string("3:6+7 'velocty' is not a member of Body. Did you mean 'velocity'?\n"
                         "4:18+4 There is no 'dmap'. Did you mean 'damp'?"));
}

void ListingCompile::aMissingBraceIsSaidWhereItOpens_data()
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

void ListingCompile::aMissingBraceIsSaidWhereItOpens()
{
    codeStandsInFunctions();
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
        << repeat("double a%1 = 0;\n", 1).arg(0) +
               [] {
                   QString all;
                   for (int i = 1; i < 1100; ++i)
                       all += QStringLiteral("double a%1=0;\n").arg(i);
                   return all;
               }() +
               "void frame() {}"
        << "1:1+6 The variables outside of functions take 8800 bytes. The most is 8192.";
    QTest::newRow("body as a global variable")
        << "Body b = body;\nvoid frame() {}"
        << "1:6+1 'b' cannot be remembered from frame to frame. Only numbers, bool and Vec2 can.";
    QTest::newRow("class") << "class A { A @next; }\nvoid frame() {}"
                           << "1:1+5 'class' is reserved and not part of this language. Use another name.";
}

void ListingCompile::boundsAreErrors()
{
    QFETCH(QString, text);
    QFETCH(QString, error);
    QCOMPARE(QString::fromStdString(errorsOf(text.toStdString())), error);
}

void ListingCompile::vocabularyFollowsTheNamesOfTheScene()
{
    const listing::Vocabulary found = listing::vocabularyOf(threeFeet());
    QVERIFY(found.bodies == std::vector<std::string>{"body"});
    QVERIFY((found.arrays == std::vector<listing::Vocabulary::Array>{{"feet", "foot"}}));
    QVERIFY((found.parameters == std::vector<std::string>{"damp", "k", "radius"}));
    QVERIFY(!found.bodiesTurn && !found.hasGait);
    const listing::Binding binding = listing::bind(found, threeFeet());
    QVERIFY(binding.bodies == std::vector<int>{3});
    QVERIFY((binding.arrays == std::vector<std::vector<int>>{{0, 1, 2}}));
    QVERIFY((binding.parameters == std::vector<double>{0.5, 0.25, 50}));
    QCOMPARE(binding.seed, std::uint64_t{7});
    QCOMPARE(listing::pluralOf("branch"), std::string("branches"));
    QCOMPARE(listing::pluralOf("p"), std::string("points"));
    QCOMPARE(listing::pluralOf("arm"), std::string("arms"));
}

void ListingCompile::reservedNamesAreLeftOutOfTheVocabulary()
{
    sim::Scene scene = threeFeet();
    scene.names = {"creature0.foot0", "out", "pointer", "body"};
    const listing::Vocabulary found = listing::vocabularyOf(scene);
    QVERIFY(found.bodies == std::vector<std::string>{"body"});
    QVERIFY(found.arrays.empty());
}

void ListingCompile::creaturesAreInTheVocabulary()
{
    const listing::Vocabulary found = listing::vocabularyOf(threeCreatures());
    QVERIFY(found.hasCreatures && found.hasGait);
    QVERIFY(found.bodies.empty() && found.arrays.empty());
    QVERIFY((found.parameters == std::vector<std::string>{"floor", "k"}));
    const listing::Binding binding = listing::bind(found, threeCreatures());
    QCOMPARE(binding.creatures.size(), std::size_t{3});
    QCOMPARE(binding.creatures[1].body, 5);
    QVERIFY((binding.creatures[1].feet == std::vector<int>{3, 4}));
}

void ListingCompile::mistakeWithCreaturesIsSaidInOneSentence_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("error");
    const auto row = [](const char *name, const char *line, const char *error) {
        QTest::newRow(name) << QString::fromUtf8(line) << QString::fromUtf8(error);
    };
    row("none", "Creature one = creatures[0]; one.gait += one.gait_speed; one.feet[0].position.x = floor;",
        "");
    row("member of a creature", "creatures[0].velocity *= k;",
        "3:14+8 'velocity' is not a member of Creature. It has body, feet, gait and gait_speed.");
    row("array instead of a creature", "creatures.gait = 0;",
        "3:11+4 'gait' is not a member of the array of creatures. Choose one of them first, for example with "
        "[0].");
    row("clock of the scene", "gait = 0;",
        "3:1+4 There is no 'gait'. A new variable needs a type: 'double gait', 'int gait' or 'Vec2 gait'.");
    row("misspelt type", "Creatre one = creatures[0];",
        "3:1+7 There is no type 'Creatre'. Did you mean 'Creature'?");
    row("unknown type", "Animal one = creatures[0];",
        "3:1+6 There is no type 'Animal'. The types are double, int, bool, Vec2, Body and Creature.");
    row("function that a number replaces", "double a = floor(1.5);",
        "3:12+5 'floor' is a double here, not a function. To multiply, write '*'.");
}

void ListingCompile::mistakeWithCreaturesIsSaidInOneSentence()
{
    QFETCH(QString, line);
    QFETCH(QString, error);
    QCOMPARE(QString::fromStdString(errorsOf(frameOf(line.toStdString()), threeCreatures())), error);
}

void ListingCompile::branchesAndSticksAreInTheVocabulary()
{
    const listing::Vocabulary ofTree = listing::vocabularyOf(swingingBush());
    QVERIFY(ofTree.hasTree && ofTree.hasGust && ofTree.bodiesTurn && !ofTree.hasSticks);
    QVERIFY((ofTree.arrays == std::vector<listing::Vocabulary::Array>{{"branches", "branch"}}));
    const listing::Vocabulary ofSticks = listing::vocabularyOf(twoSticks());
    QVERIFY(ofSticks.hasSticks && !ofSticks.hasTree && !ofSticks.hasGust);
    QVERIFY((ofSticks.arrays == std::vector<listing::Vocabulary::Array>{{"points", "p"}}));
    const listing::Binding binding = listing::bind(ofSticks, twoSticks());
    QVERIFY((binding.sticks == std::vector<sim::Stick>{{0, 1, 10, 0.25}, {1, 2, 7, 0.5}}));
    QVERIFY(binding.otherBodies == std::vector<int>{2}); // reached by a stick only
    const listing::Vocabulary ofFeet = listing::vocabularyOf(threeFeet());
    QVERIFY(!ofFeet.hasTree && !ofFeet.hasGust && !ofFeet.hasSticks);
}

void ListingCompile::mistakeWithBranchesOrSticksIsSaidInOneSentence_data()
{
    QTest::addColumn<bool>("hasTree");
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("error");
    const auto row = [](const char *name, bool hasTree, const char *line, const char *error) {
        QTest::newRow(name) << hasTree << QString::fromUtf8(line) << QString::fromUtf8(error);
    };
    row("names of a tree", true,
        "Body trunk = branches[0]; trunk.angle = trunk.rest + trunk.scale * trunk.length / trunk.inertia;\n"
        "if (gust_known && trunk.number < trunk.children.count) gust_front = gust_tail + gust;",
        "");
    row("names of sticks", false,
        "Stick one = sticks[0]; one.a.position.x = one.length * one.share + one.b.position.x;", "");
    row("member of a branch", true, "branches[0].kids[0].spin = 1;",
        "3:13+4 'kids' is not a member of Body. It has position, velocity, before, held, mass, radius, "
        "angle, spin, "
        "number, rest, scale, length, inertia and children.");
    row("number of a branch is set", true, "branches[0].scale = 1;",
        "3:13+5 This cannot be changed. A listing changes positions, velocities and its own variables.");
    row("children instead of a child", true, "branches[0].children.spin = 1;",
        "3:22+4 'spin' is not a member of an array of bodies. Choose one of them first, for example with "
        "[0].");
    row("member of a stick", false, "sticks[0].lenght *= k;",
        "3:11+6 'lenght' is not a member of Stick. Did you mean 'length'?");
    row("sticks instead of a stick", false, "double a = sticks.length;",
        "3:19+6 'length' is not a member of the array of sticks. Choose one of them first, for example with "
        "[0].");
    row("length of a stick is set", false, "sticks[0].length = 2;",
        "3:11+6 This cannot be changed. A listing changes positions, velocities and its own variables.");
    row("unknown name", false, "points[0].position.x = wobble;",
        "3:24+6 There is no 'wobble'. This scene has points and sticks, and the number k.");
    row("unknown type", false, "Rope one = sticks[0];",
        "3:1+4 There is no type 'Rope'. The types are double, int, bool, Vec2, Body and Stick.");
    row("gust of a scene without one", false, "gust_front += 1;",
        "3:1+10 There is no 'gust_front'. This scene has points and sticks, and the number k.");
}

void ListingCompile::mistakeWithBranchesOrSticksIsSaidInOneSentence()
{
    QFETCH(bool, hasTree);
    QFETCH(QString, line);
    QFETCH(QString, error);
    const sim::Scene scene = hasTree ? swingingBush() : twoSticks();
    QCOMPARE(QString::fromStdString(errorsOf(frameOf(line.toStdString()), scene)), error);
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
