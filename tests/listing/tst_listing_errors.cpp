#include "app/listing/limits.h"
#include "app/listing/program.h"
#include "tests/listing/listing_support.h"
#include "tests/suite.h"

#include <QTest>

using namespace listing_support;
using listing::RunError;
using listing::RunErrorKind;
using sim::Vec2;

namespace {

QString notFinite(const char *name)
{
    return QString("%1 is not a finite number. "
                   "Look for the root of a negative number, or for a number that grows in each frame.")
        .arg(name);
}

}

/// The errors of a program that runs.
class ListingErrors : public QObject
{
    Q_OBJECT

private slots:
    void errorWithACreatureIsReported_data();
    void errorWithACreatureIsReported();
    void errorWithATreeOrAStickIsReported_data();
    void errorWithATreeOrAStickIsReported();
    void errorStopsTheFrameOnItsLine_data();
    void errorStopsTheFrameOnItsLine();
    void errorLeavesTheStateUnchanged();
    void errorHasTheValuesOfItsVariables();
    void programRunsAfterAnError();
    void deepestAllowedCallRuns();
};

void ListingErrors::errorWithACreatureIsReported_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("creature")
        << "creatures[3].gait = 0;"
        << "There is no creatures[3]: creatures goes from creatures[0] to creatures[2].";
    QTest::newRow("foot") << "creatures[1].feet[2].position.x = 0;"
                          << "There is no creatures[1].feet[2]: creatures[1].feet goes from "
                             "creatures[1].feet[0] to creatures[1].feet[1].";
    QTest::newRow("none") << "Creature one;\none.body.position.x = 1;"
                          << "This variable stands for no body.";
    QTest::newRow("infinite position")
        << "creatures[1].body.position.x = sqrt(-1);" << notFinite("The position of creatures[1].body");
    QTest::newRow("infinite clock") << "creatures[2].gait = sqrt(-1);"
                                    << notFinite("The gait of creatures[2]");
}

void ListingErrors::errorWithACreatureIsReported()
{
    QFETCH(QString, line);
    QFETCH(QString, sentence);
    Bench bench(frameOf(line.toStdString()), threeCreatures());
    const std::optional<RunError> error = bench.run();
    QVERIFY(error.has_value());
    QCOMPARE(QString::fromStdString(error->sentence), sentence);
}

void ListingErrors::errorWithATreeOrAStickIsReported_data()
{
    QTest::addColumn<bool>("hasTree");
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("child") << true << "branches[0].children[2].spin = 1;"
                           << "There is no children[2]: children goes from children[0] to children[1].";
    QTest::newRow("child of a twig") << true << "branches[1].children[0].spin = 1;"
                                     << "There is no children[0]: children is empty.";
    QTest::newRow("infinite gust") << true << "gust_front = sqrt(-1);"
                                   << notFinite("'gust_front' or 'gust_tail'");
    QTest::newRow("stick") << false << "sticks[2].a.position.x = 1;"
                           << "There is no sticks[2]: sticks goes from sticks[0] to sticks[1].";
    QTest::newRow("no stick") << false << "Stick none;\nnone.a.position.x = 1;"
                              << "This variable stands for no body.";
    QTest::newRow("direction to no body") << false << "Body none;\nVec2 out_ = direction(points[0], none);"
                                          << "This variable stands for no body.";
    QTest::newRow("target") << false << "Vec2 first = new_targets[0];"
                            << "There is no new_targets[0]: new_targets is empty.";
    QTest::newRow("infinite position")
        << false << "sticks[1].b.position.x = sqrt(-1);" << notFinite("The position of sticks[1].b");
}

void ListingErrors::errorWithATreeOrAStickIsReported()
{
    QFETCH(bool, hasTree);
    QFETCH(QString, line);
    QFETCH(QString, sentence);
    Bench bench(frameOf(line.toStdString()), hasTree ? swingingBush() : twoSticks());
    const std::optional<RunError> error = bench.run();
    QVERIFY(error.has_value());
    QCOMPARE(QString::fromStdString(error->sentence), sentence);
}

void ListingErrors::errorStopsTheFrameOnItsLine_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("sentence");
    const auto row = [](const char *name, const std::string &text, RunErrorKind kind, int line,
                        const QString &sentence) {
        QTest::newRow(name) << QString::fromStdString(text) << int(kind) << line << sentence;
    };
    row("index too large", frameOf("int i = 7;\nfeet[i].velocity *= damp;"), RunErrorKind::noSuchBody, 4,
        "There is no feet[7]: feet goes from feet[0] to feet[2].");
    row("index below zero", frameOf("feet[-1].velocity *= damp;"), RunErrorKind::noSuchBody, 3,
        "There is no feet[-1]: feet goes from feet[0] to feet[2].");
    row("variable without a body", frameOf("Body b;\nb.velocity *= damp;"), RunErrorKind::noSuchBody, 4,
        "This variable stands for no body.");
    row("division of whole numbers", frameOf("int n = 0;\n\nint a = 3 / n;"), RunErrorKind::divisionByZero, 5,
        "This divides by 0.");
    row("remainder of whole numbers", frameOf("int n = 0;\nint a = 3 % n;"), RunErrorKind::divisionByZero, 4,
        "This divides by 0.");
    row("division of numbers", frameOf("double n = 0;\ndouble a = 3 / n;"), RunErrorKind::divisionByZero, 4,
        "This divides by 0.");
    row("endless loop", frameOf("int n = 0;\nwhile (true)\n{\n    n += 1;\n}"), RunErrorKind::endlessLoop, 4,
        "This loop still runs after 100000 lines. It ends only when its condition becomes false.");
    row("endless loop in a loop", frameOf("for (int i = 0; i < 2; i++)\n    for (;;) {}"),
        RunErrorKind::endlessLoop, 4,
        "This loop still runs after 100000 lines. It ends only when its condition becomes false.");
    row("function in an endless loop",
        "void f() { body.position.x += 1; }\n" + frameOf("int n = 0;\nwhile (n < 2)\n    f();"),
        RunErrorKind::endlessLoop, 5,
        "This loop still runs after 100000 lines. It ends only when its condition becomes false.");
    row("function that calls itself too often",
        "int f(int n) { return n == 0 ? 0 : f(n - 1) + f(n - 1); }\n" + frameOf("f(50);"),
        RunErrorKind::endlessLoop, 1,
        "This still runs after 100000 lines. A function calls itself too often.");
    row("endless recursion", "int f(int n) { return f(n + 1); }\n" + frameOf("f(0);"), RunErrorKind::tooDeep,
        1,
        "Functions call functions 100 times inside one another. A function that calls itself needs a case in "
        "which "
        "it does not.");
    row("infinite velocity", frameOf("double a = 1e200;\nbody.velocity.x = a * a;\nbody.position.x = 3;"),
        RunErrorKind::notFinite, 4, notFinite("The velocity of body"));
    row("root of a negative number",
        frameOf("feet[0].position.x = 1;\nfeet[1].position = Vec2(sqrt(-1), 0);"), RunErrorKind::notFinite, 4,
        notFinite("The position of feet[1]"));
    row("division of a vector", frameOf("double n = 0;\nVec2 a = hand / n;"), RunErrorKind::divisionByZero, 4,
        "This divides by 0.");
    row("vector that is divided", frameOf("body.velocity /= length(body.velocity);"),
        RunErrorKind::divisionByZero, 3, "This divides by 0.");
    row("infinite global", "double g = 1e300;\n" + frameOf("g *= g;"), RunErrorKind::notFinite, 4,
        notFinite("'g'"));
    row("error in an initial value", "double g = feet[9].mass;\n" + frameOf(""), RunErrorKind::noSuchBody, 1,
        "There is no feet[9]: feet goes from feet[0] to feet[2].");
    row("endless initial value", "int f() { while (true) {} return 1; }\nint g = f();\n" + frameOf(""),
        RunErrorKind::endlessLoop, 1,
        "This loop still runs after 100000 lines. It ends only when its condition becomes false.");
    row("smallest whole number by -1", frameOf("int n = -2147483647 - 1;\nint m = -1;\nn = n / m;"),
        RunErrorKind::notFinite, 5, "The result is too large for a number.");
}

void ListingErrors::errorStopsTheFrameOnItsLine()
{
    QFETCH(QString, text);
    QFETCH(int, kind);
    QFETCH(int, line);
    QFETCH(QString, sentence);
    Bench bench(text.toStdString());
    const std::optional<RunError> error = bench.run();
    QVERIFY(error.has_value());
    QCOMPARE(QString::fromStdString(error->sentence), sentence);
    QCOMPARE(error->line, line);
    QCOMPARE(int(error->kind), kind);
}

void ListingErrors::errorLeavesTheStateUnchanged()
{
    Bench bench("double g = 1;\n" + frameOf("g = 2; body.position.x = 3; feet[3].velocity *= 2;"));
    const sim::State before = bench.state;
    QVERIFY(bench.run());
    bench.state.frame = before.frame;
    QVERIFY(sim::sameBits(bench.state, before));
}

void ListingErrors::errorHasTheValuesOfItsVariables()
{
    Bench bench("double g = 1.5;\n"
                "void step(Body me, int n)\n{\n    Vec2 d(n, 2 * n);\n    feet[n].velocity += d;\n}\n" +
                frameOf("for (int i = 0; i < 9; i++)\n    step(body, i);"));
    const std::optional<RunError> error = bench.run();
    QVERIFY(error.has_value());
    QCOMPARE(error->line, 5);
    QCOMPARE(shown(error->variables, "n"), std::string("n = 3"));
    QCOMPARE(shown(error->variables, "d"), std::string("d = (3, 6)"));
    QCOMPARE(shown(error->variables, "me"), std::string("me = body"));
    QCOMPARE(shown(error->variables, "g"), std::string("g = 1.5"));
    QCOMPARE(error->variables.size(), std::size_t{4});
}

void ListingErrors::programRunsAfterAnError()
{
    Bench bench = Bench::ofFrame("feet[frame_number == 2 ? 9 : 0].position.x += 1;");
    QVERIFY(!bench.run());
    QVERIFY(bench.run());
    QVERIFY(!bench.run());
    QCOMPARE(bench.state.positionOf(0).x, 2.0);
}

void ListingErrors::deepestAllowedCallRuns()
{
    const std::string sum = "int f(int n) { if (n == 0) return 0; return 1 + f(n - 1); }\n";
    Bench deepest(sum + frameOf("body.position.x = f(" + std::to_string(listing::maxCallDepth - 1) + ");"));
    QVERIFY(!deepest.run());
    QCOMPARE(deepest.body().x, double(listing::maxCallDepth - 1));
    Bench deeper(sum + frameOf("body.position.x = f(" + std::to_string(listing::maxCallDepth) + ");"));
    QVERIFY(deeper.run());
}

SUITE(tst_listing_errors, ListingErrors)
#include "tst_listing_errors.moc"
