#include "app/listing/limits.h"
#include "app/listing/program.h"
#include "tests/listing/listing_support.h"
#include "tests/suite.h"

#include <QElapsedTimer>
#include <QTest>

using namespace listing_support;
using listing::Moment;
using listing::RunErrorKind;
using listing::Trace;
using listing::TracedLine;
using sim::Vec2;

namespace {

/// Returns the lines of a trace: "4 5 5.6 5" for lines 4, 5, 6 (one call deeper than frame), 5.
QString linesOf(const Trace &trace)
{
    QStringList lines;
    for (const TracedLine &line : trace.lines)
        lines << QString::number(line.line) + QString(line.depth, QLatin1Char('\''));
    return lines.join(' ');
}

QString loopsOf(const TracedLine &line)
{
    QStringList loops;
    for (const listing::LoopTurn &loop : line.loops)
        loops << QStringLiteral("%1: %2 of %3").arg(loop.line).arg(loop.turn).arg(loop.turns);
    return loops.join(QStringLiteral(", "));
}

}

class ListingTrace : public QObject
{
    Q_OBJECT

private slots:
    void linesRunInTheOrderOfTheProgram_data();
    void linesRunInTheOrderOfTheProgram();
    void variablesAreThoseInScope();
    void valuesAreThoseBeforeTheLine();
    void lastBraceSeesTheVariablesOfItsFunction();
    void innerVariableHidesNothingOutsideItsBlock();
    void loopsCountTheirTurns();
    void secondRunOfALoopCountsFromOne();
    void recursionHasItsDepth();
    void traceEndsWithTheError();
    void traceKeepsABoundedNumberOfLines();
    void traceDoesNotChangeTheRun();
    void stateInsideTheFrameIsThatAfterTheLines();
    void everyPrefixOfAFrameMatchesItsTrace();
    void globalsAreShownWithTheirValues();
};

void ListingTrace::linesRunInTheOrderOfTheProgram_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("lines");
    const auto row = [](const char *name, const std::string &text, const char *lines) {
        QTest::newRow(name) << QString::fromStdString(text) << QString::fromLatin1(lines);
    };
    row("statements", frameOf("double a = 1;\na += 1;\n\na += 2;"), "3 4 6 7");
    row("several on a line", frameOf("double a = 1; a += 1; a += 2;"), "3 4");
    row("if", frameOf("if (k > 1)\n    body.velocity.x = 1;\nelse\n    body.velocity.x = 2;"), "3 6 7");
    row("for", frameOf("for (int i = 0; i < 2; i++)\n{\n    body.velocity.x += 1;\n}"), "3 5 3 5 3 7");
    row("for without braces", frameOf("for (int i = 0; i < 2; i++)\n    body.velocity.x += 1;"),
        "3 4 3 4 3 5");
    row("while", frameOf("int n = 0;\nwhile (n < 2)\n    n++;"), "3 4 5 4 5 6");
    row("call", "void f()\n{\n    body.velocity.x += 1;\n}\n" + frameOf("f();\nf();"), "7 3' 4' 8 3' 4' 9");
}

void ListingTrace::linesRunInTheOrderOfTheProgram()
{
    QFETCH(QString, text);
    QFETCH(QString, lines);
    Bench bench(text.toStdString());
    const Trace trace = bench.program->trace(bench.state, bench.binding);
    QCOMPARE(linesOf(trace), lines);
    QVERIFY(trace.isComplete);
    QVERIFY(!trace.error);
}

void ListingTrace::variablesAreThoseInScope()
{
    Bench bench = Bench::ofFrame("for (int i = 0; i < 1; i++)\n"
                                 "{\n"
                                 "    Body foot = feet[i];\n"
                                 "    Vec2 d = body.position;\n"
                                 "    foot.velocity = d;\n"
                                 "}\n"
                                 "bool big = k > 1;\n"
                                 "body.velocity.x = 1;");
    const Trace trace = bench.program->trace(bench.state, bench.binding);
    const auto namesAt = [&](int line) {
        QStringList names;
        for (const TracedLine &traced : trace.lines) {
            if (traced.line == line && names.isEmpty()) {
                for (const listing::Variable &variable : traced.variables)
                    names << QString::fromStdString(variable.name + ":" + listing::typeName(variable.value));
            }
        }
        return names.join(' ');
    };
    QCOMPARE(namesAt(5), QStringLiteral("i:int"));
    QCOMPARE(namesAt(6), QStringLiteral("i:int foot:Body"));
    QCOMPARE(namesAt(7), QStringLiteral("i:int foot:Body d:Vec2"));
    QCOMPARE(namesAt(9), QString());
    QCOMPARE(namesAt(10), QStringLiteral("big:bool"));
}

void ListingTrace::valuesAreThoseBeforeTheLine()
{
    Bench bench =
        Bench::ofFrame("double a = 1;\na = 5;\nVec2 v(a, 2);\nBody b = feet[2];\nbody.velocity = v;");
    const Trace trace = bench.program->trace(bench.state, bench.binding);
    QCOMPARE(trace.lines.size(), std::size_t{6});
    QCOMPARE(shown(trace.lines[1].variables, "a"), std::string("a = 1"));
    QCOMPARE(shown(trace.lines[2].variables, "a"), std::string("a = 5"));
    QCOMPARE(shown(trace.lines[4].variables, "v"), std::string("v = (5, 2)"));
    QCOMPARE(shown(trace.lines[4].variables, "b"), std::string("b = feet[2]"));
}

void ListingTrace::lastBraceSeesTheVariablesOfItsFunction()
{
    // The second function begins right behind the first one, and the text ends with a brace.
    Bench bench("void f(double x)\n{\n    { Vec2 inner(1, 1); }\n    Vec2 end(x, 2);\n}void frame()\n"
                "{\n    double a = 3;\n    f(a);\n    Body foot = feet[2];\n    Vec2 last(a, 4);\n}");
    const Trace trace = bench.program->trace(bench.state, bench.binding);
    QCOMPARE(linesOf(trace), QStringLiteral("7 8 3' 4' 5' 9 10 11"));
    const std::vector<listing::Variable> &inner = trace.lines[4].variables, &outer = trace.lines[7].variables;
    QCOMPARE(shown(inner, "x"), std::string("x = 3"));
    QCOMPARE(shown(inner, "end"), std::string("end = (3, 2)"));
    QCOMPARE(inner.size(), std::size_t{2});
    QCOMPARE(shown(outer, "a"), std::string("a = 3"));
    QCOMPARE(shown(outer, "foot"), std::string("foot = feet[2]"));
    QCOMPARE(shown(outer, "last"), std::string("last = (3, 4)"));
    QCOMPARE(outer.size(), std::size_t{3});
}

void ListingTrace::innerVariableHidesNothingOutsideItsBlock()
{
    Bench bench = Bench::ofFrame("for (int i = 0; i < 1; i++)\n"
                                 "    body.velocity.x = i;\n"
                                 "for (int i = 7; i < 8; i++)\n"
                                 "    body.velocity.x = i;\n"
                                 "body.velocity.y = 1;");
    const Trace trace = bench.program->trace(bench.state, bench.binding);
    const auto variablesOf = [&](int number) {
        for (const TracedLine &line : trace.lines) {
            if (line.line == number)
                return line.variables;
        }
        qFatal("line %d is not traced", number);
    };
    QCOMPARE(shown(variablesOf(4), "i"), std::string("i = 0"));
    QCOMPARE(shown(variablesOf(6), "i"), std::string("i = 7"));
    QCOMPARE(variablesOf(6).size(), std::size_t{1});
    QVERIFY(variablesOf(7).empty());
}

void ListingTrace::loopsCountTheirTurns()
{
    Bench bench = Bench::ofFrame("for (int i = 0; i < 3; i++)\n"
                                 "{\n"
                                 "    int n = i;\n"
                                 "    while (n > 0)\n"
                                 "        n--;\n"
                                 "}\n");
    const Trace trace = bench.program->trace(bench.state, bench.binding);
    QStringList at5, at7;
    for (const TracedLine &line : trace.lines) {
        if (line.line == 5)
            at5 << loopsOf(line);
        if (line.line == 7)
            at7 << loopsOf(line);
    }
    QCOMPARE(at5, (QStringList{"3: 1 of 3", "3: 2 of 3", "3: 3 of 3"}));
    QCOMPARE(at7, (QStringList{"3: 2 of 3, 6: 1 of 1", "3: 3 of 3, 6: 1 of 2", "3: 3 of 3, 6: 2 of 2"}));
}

void ListingTrace::secondRunOfALoopCountsFromOne()
{
    Bench bench("void f(int n)\n{\n    do\n    {\n        n--;\n    } while (n > 0);\n}\n" +
                frameOf("f(2);\nf(3);"));
    const Trace trace = bench.program->trace(bench.state, bench.binding);
    QStringList at5;
    for (const TracedLine &line : trace.lines) {
        if (line.line == 5)
            at5 << loopsOf(line);
    }
    QCOMPARE(at5, (QStringList{"3: 1 of 2", "3: 2 of 2", "3: 1 of 3", "3: 2 of 3", "3: 3 of 3"}));
}

void ListingTrace::recursionHasItsDepth()
{
    Bench bench("int f(int n)\n{\n    if (n == 0)\n        return 0;\n    return 1 + f(n - 1);\n}\n" +
                frameOf("f(2);"));
    const Trace trace = bench.program->trace(bench.state, bench.binding);
    QCOMPARE(linesOf(trace), QStringLiteral("9 3' 5' 3'' 5'' 3''' 4''' 10"));
    QCOMPARE(shown(trace.lines[3].variables, "n"), std::string("n = 1"));
    QCOMPARE(shown(trace.lines[5].variables, "n"), std::string("n = 0"));
    QCOMPARE(trace.lines[5].function, std::string("f"));
    QCOMPARE(trace.lines[0].function, std::string("frame"));
}

void ListingTrace::traceEndsWithTheError()
{
    Bench bench = Bench::ofFrame("double a = 1;\nfeet[8].velocity.x = a;\na = 2;");
    const Trace trace = bench.program->trace(bench.state, bench.binding);
    QCOMPARE(linesOf(trace), QStringLiteral("3 4"));
    QVERIFY(trace.error && trace.error->kind == RunErrorKind::noSuchBody && trace.error->line == 4);
}

void ListingTrace::traceKeepsABoundedNumberOfLines()
{
    Bench bench = Bench::ofFrame("for (int i = 0; i < 9000; i++)\n    body.position.x += 1;");
    const Trace trace = bench.program->trace(bench.state, bench.binding);
    QVERIFY(!trace.isComplete && !trace.error);
    QCOMPARE(trace.lines.size(), std::size_t{listing::maxTracedLines});
    QVERIFY(!bench.run());
    QCOMPARE(bench.body().x, 9100.0);
}

void ListingTrace::traceDoesNotChangeTheRun()
{
    Bench bench("double clock = 0;\n" + frameOf("clock += 1;\nbody.position.x += clock;"));
    Bench other("double clock = 0;\n" + frameOf("clock += 1;\nbody.position.x += clock;"));
    for (int i = 0; i < 5; ++i) {
        const Trace first = bench.program->trace(bench.state, bench.binding);
        const Trace second = bench.program->trace(bench.state, bench.binding);
        QCOMPARE(linesOf(first), linesOf(second));
        QVERIFY(first.lines[1].variables == second.lines[1].variables);
        QVERIFY(!bench.run());
        QVERIFY(!other.run());
        QVERIFY(sim::sameBits(bench.state, other.state));
    }
}

void ListingTrace::stateInsideTheFrameIsThatAfterTheLines()
{
    Bench bench("int steps = 0;\n" +
                frameOf("body.position.x = 1;\nbody.position.x = 2;\nsteps++;\nbody.position.y = 3;"));
    const Moment start = bench.program->runLines(bench.state, bench.binding, 0);
    QVERIFY(start.next && start.next->line == 4);
    QVERIFY(start.state.positionOf(3) == (Vec2{100, 50}));
    const Moment second = bench.program->runLines(bench.state, bench.binding, 2);
    QVERIFY(second.next && second.next->line == 6);
    QVERIFY(second.state.positionOf(3) == (Vec2{2, 50}));
    QCOMPARE(shown(second.next->variables, "steps"), std::string("steps = 0"));
    const Moment third = bench.program->runLines(bench.state, bench.binding, 3);
    QCOMPARE(shown(third.next->variables, "steps"), std::string("steps = 1"));
    const Moment end = bench.program->runLines(bench.state, bench.binding, 99);
    QVERIFY(!end.next && !end.error);
    QVERIFY(end.state.positionOf(3) == (Vec2{2, 3}));
}

void ListingTrace::everyPrefixOfAFrameMatchesItsTrace()
{
    Bench bench(fileText("lessons/multi_foot/any_number.code"));
    const Trace trace = bench.program->trace(bench.state, bench.binding);
    QVERIFY(trace.lines.size() > 30);
    for (std::size_t i = 0; i < trace.lines.size(); ++i) {
        const Moment moment = bench.program->runLines(bench.state, bench.binding, static_cast<int>(i));
        QVERIFY(moment.next.has_value());
        QCOMPARE(moment.next->line, trace.lines[i].line);
        QCOMPARE(moment.next->depth, trace.lines[i].depth);
        QVERIFY(moment.next->variables == trace.lines[i].variables);
    }
    const Moment end =
        bench.program->runLines(bench.state, bench.binding, static_cast<int>(trace.lines.size()));
    QVERIFY(!end.next);
    sim::State after = bench.state;
    QVERIFY(!bench.program->run(after, bench.binding));
    QVERIFY(sim::sameBits(after, end.state));
}

void ListingTrace::globalsAreShownWithTheirValues()
{
    Bench bench("double clock = 2.5;\n" + frameOf("clock += 1;\nbody.position.x = clock;"));
    const Trace trace = bench.program->trace(bench.state, bench.binding);
    QCOMPARE(shown(trace.lines[0].variables, "clock"), std::string("clock = 2.5"));
    QCOMPARE(shown(trace.lines[1].variables, "clock"), std::string("clock = 3.5"));
    QVERIFY(trace.lines[1].variables.back().isGlobal);
}

SUITE(tst_listing_trace, ListingTrace)
#include "tst_listing_trace.moc"
