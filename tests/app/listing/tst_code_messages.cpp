// Messages about mistakes in a learner's code, in German.

#include "app/model/text/language.h"
#include "app/model/text/listing_text.h"
#include "tests/app/listing/code_session.h"
#include "tests/suite.h"

#include <QRegularExpression>

using namespace app;
using code_session::Opened;

class CodeMessagesTest : public QObject
{
    Q_OBJECT

private slots:
    void compileErrorsAreTranslatedToGerman_data()
    {
        QTest::addColumn<QString>("code"); // in the function frame
        for (const char *code : {"feet[0].velocty *= 2;",
                                 "feet[0].nonsense *= 2;",
                                 "feet.position = hand;",
                                 "feets[0].velocity *= 2;",
                                 "nonsense = 3;",
                                 "double x = sin(1, 2);",
                                 "double x = sinn(1);",
                                 "doble x = 1;",
                                 "float x = 1;",
                                 "int i = feet[0].position;",
                                 "feet[0].velocity = 3;",
                                 "Vec2 v = hand * hand;",
                                 "Vec2 v = hand + 3;",
                                 "k = 3;",
                                 "body = feet[0];",
                                 "double x;",
                                 "if (k) k;",
                                 "if (k = 3) return;",

                                 "double x = \"text\";",
                                 "switch (1) {}",
                                 "double x = 1.0f;",
                                 "bool b = 1 < k < 3;",
                                 "int x = 1 | 2;",
                                 "int x = 1 ^ 2;",
                                 "Body @b = body;",
                                 "double x = ;",
                                 "double = 3;",
                                 "hand.;",
                                 "double x = 3",
                                 "}",

                                 "double x = 1; double x = 2;",
                                 "double x = double(3);",
                                 "frame() + 1;",
                                 "3 = k;",
                                 "void x = 3;",
                                 "else else;",

                                 "position += hand;",
                                 "x = 3;",
                                 "print(3);",
                                 "k (hand);",
                                 "Vec2 v = body - body;",
                                 "Body b = feet;",
                                 "return 5;",
                                 "double x = k > 1 ? 1 / k : 1;",
                                 "hand *= k\nhand *= k;",
                                 "body.held",
                                 "if (k > 1) k = 2 else k = 3;",
                                 "k *= (2;",
                                 "k *= 2);",
                                 "k *= 0,9;",
                                 "k *= 2k;",
                                 "k *= 1 / 2;",
                                 "hand = (1, 2);",
                                 "if k > 1 {}",
                                 "if (k > 1): k = 2;",
                                 "if (k > 1) then k = 2;",
                                 "if (k > 1); k = 2;",
                                 "If (k > 1) k = 2;",
                                 "if (k > 1) {} elif (k > 2) {}",
                                 "for (i : feet) {}",
                                 "for (i in feet) {}",
                                 "hand = new Vec2(1, 2);",
                                 "k == 2;",
                                 "int whole = atan2(1, 2);",
                                 "k =+ 2;",
                                 "if (k => 2) return;",
                                 "k * = 2;",
                                 "body->held;",
                                 "hand.length();",
                                 "# k",
                                 "if (k > 1) {",
                                 "double a[9];",
                                 "} k = 2; {",
                                 "} frame() {",

                                 "Body.velocity = hand;",
                                 "hand += 1;",
                                 "hand++;",
                                 "feet[0][1].velocity = hand;",
                                 "bool b = 1;",
                                 "double a = 2(k);",
                                 "break;",
                                 "body.velocity;",
                                 "for (int i = 0; i < 2; i++);",
                                 "double 2nd = 2;",
                                 "double ä = 2;",
                                 "double a = 1 / feet.count;",
                                 "k =- 2;",
                                 "body.held();",
                                 "void stop() { }",
                                 "/* k",
                                 "k = 2; else k = 3;"})
            QTest::newRow(code) << QString(code);
    }
    void compileErrorsAreTranslatedToGerman()
    {
        QFETCH(QString, code);
        Opened opened("multi_foot", "any_number");
        const QString text = QStringLiteral("void frame()\n{\n    %1\n}\n").arg(code);
        const std::vector<listing::CompileError> errors = opened.session.code().compiled(text).errors;
        QVERIFY(!errors.empty());
        const Language german("de");
        for (const listing::CompileError &error : errors) {
            QString told = listingSentence(error.sentence);
            told.remove(QRegularExpression("'[^']*'"));
            static const QRegularExpression english(
                "\\b(the|is|not|this|There|This|cannot|here|has|It|Write|Use|To|missing|stands|written)\\b");
            QVERIFY2(!english.match(told).hasMatch(), qPrintable(listingSentence(error.sentence)));
        }
    }

    void runtimeErrorsAreTranslatedToGerman_data()
    {
        QTest::addColumn<QString>("code");
        QTest::addColumn<QString>("sentence");
        QTest::newRow("no such body") << "feet[7].velocity *= 2;"
                                      << "Es gibt kein feet[7]: feet reicht von feet[0] bis feet[3].";
        QTest::newRow("division") << "int zero = 0; int one = 1 / zero;"
                                  << "Hier wird durch 0 geteilt.";
        QTest::newRow("endless")
            << "while (true) { body.velocity *= 1; }"
            << "Diese Schleife läuft nach 100000 Zeilen immer noch. Sie endet erst, wenn ihre "
               "Bedingung nicht mehr gilt.";
        QTest::newRow("not finite")
            << "body.velocity *= 1e308; body.velocity += Vec2(1e308, 0); body.velocity *= 9;"
            << "Die Geschwindigkeit von body ist keine endliche Zahl. Suche nach der Wurzel einer negativen "
               "Zahl oder "
               "nach einer Zahl, die in jedem Bild wächst.";
    }
    void runtimeErrorsAreTranslatedToGerman()
    {
        QFETCH(QString, code);
        QFETCH(QString, sentence);
        Opened opened("multi_foot", "any_number");
        opened.session.editor().setParameter("feet", 4);
        opened.session.code().write(QStringLiteral("void frame()\n{\n    %1\n}\n").arg(code));
        opened.goTo(3);
        const std::optional<listing::RunError> error = opened.session.code().runError();
        QVERIFY(error);
        const Language german("de");
        QCOMPARE(listingSentence(error->sentence), sentence);
    }
};

SUITE(tst_code_messages, CodeMessagesTest)
#include "tst_code_messages.moc"
