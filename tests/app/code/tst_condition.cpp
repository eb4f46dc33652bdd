#include "app/model/breakpoints/breakpoint_monitor.h"
#include "app/model/text/user_error.h"
#include "sim/run/script/composed_interval.h"
#include "tests/app/code/listing_support.h"
#include "tests/suite.h"

#include <QRegularExpression>

using namespace listing_support;

namespace {

/// A run inside frame 41, before gravity: five numbers of it are set so that a reader can compute with them.
struct ConditionFixture
{
    explicit ConditionFixture(const QString &lesson = "gravity_walls", const QString &name = "gravity")
        : step(stepOf(lesson, name)), run(runOf(step)), state(run.state())
    {
        state.place(0, {100.0, 381.5});
        state.setVelocity(0, {3.0, -4.0});
        state.place(1, {-7.25, 0.0});
    }
    bool ask(const QString &text)
    {
        const Condition condition = Condition::parse(text, conditionNames(step, run));
        return condition.holds({state, 41, &run.track().nextInterval()->pipeline.phaseAt(phase)});
    }
    QString error(const QString &text)
    {
        try {
            Condition::parse(text, conditionNames(step, run));
        } catch (const UserError &error) {
            return error.sentence();
        }
        return {};
    }

    const lessons::Step &step;
    sim::Timeline run;
    sim::State state;
    int phase = 1; ///< gravity
};

}

/// Conditions that learners write about a run: parsing, evaluation and errors.
class TestCondition : public QObject
{
    Q_OBJECT

private slots:
    void conditionIsEvaluated_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("answer");
        const auto row = [](const char *text, bool answer) {
            QTest::newRow(text) << QString(text) << answer;
        };
        row("foot0.y > 380", true);
        row("foot0.y>381.5", false);
        row("foot0.y >= 381.5", true);
        row("foot0.y <= 381.5", true);
        row("foot0.y < 381.5", false);
        row("frame == 41", true);
        row("frame != 41", false);
        row("41 == frame", true);
        row("foot0.vx == 3 and foot0.vy == -4", true);
        row("foot0.vx == 3 and foot0.vy == 4", false);
        row("foot0.vx == 0 or foot0.vy == -4", true);
        row("foot0.vx == 0 || foot0.vy == 0", false);
        row("foot0.vx == 3 && foot0.x == 100", true);
        row("foot0.vx * foot0.vx + foot0.vy * foot0.vy == 25", true);
        row("foot0.vx * foot0.vx + foot0.vy * foot0.vy > 25", false);
        row("sqrt(foot0.vx * foot0.vx + foot0.vy * foot0.vy) == 5", true);
        row("abs(foot0.vy) == 4", true);
        row("speed(foot0) == 5", true);
        row("speed(foot0) > 5", false);
        row("still(foot0) or still()", false);
        row("held() or held(foot0) or released() or released(foot1)", false);
        row("not held(foot0) and frame >= 0", true);
        row("distance(foot0, foot0) == 0", true);
        row("distance(foot0,foot1) == distance( foot1 , foot0 )", true);
        row("distance(foot0, foot1) == sqrt(107.25 * 107.25 + 381.5 * 381.5)", true);
        row("abs(foot0.vy - 6) / 2 == 5", true);
        row("k == 0.2", true);
        row("floor - foot0.y < 0", true);
        row("gravity > 0.4 and gravity < 0.6", true);
        row("phase == \"gravity\"", true);
        row("phase == 'springs'", false);
        row("phase != \"springs\"", true);
        row("\"gravity\" == phase", true);
        row("phase == “gravity”", true);
        row("phase == \"radial_spring\"", false);
        row("not frame == 41", false);
        row("not not frame == 41", true);
        row("!(frame == 40)", true);
        row("2 + 3 * 4 == 14", true);
        row("(2 + 3) * 4 == 20", true);
        row("10 - 4 - 3 == 3", true);
        row("24 / 4 / 2 == 3", true);
        row("24 / (4 / 2) == 12", true);
        row("-2 * -3 == 6", true);
        row("--2 == 2", true);
        row("+2 == 2", true);
        row("2 - -3 == 5", true);
        row("-foot1.x == 7.25", true);
        row("1e2 == 100", true);
        row("1.5E-1 == .15", true);
        row("5. == 5", true);
        row("1 == 0 and 1 == 0 or 1 == 1", true);
        row("1 == 1 or 1 == 0 and 1 == 0", true);
        row("(1 == 1 or 1 == 0) and 1 == 0", false);
        row("not 1 == 0 and 1 == 1", true);
        row("(((foot0.y)) > (380))", true);
        row("foot0.y ≥ 381.5 and foot0.y ≤ 381.5 and foot0.x ≠ 0", true);
        row("6 ÷ 2 × 2 − 1 == 5", true);
        row("  frame\t== 41  ", true);
        row("0 / 0 == 0 / 0", false);
        row("0 / 0 != 0", true);
        row("1 / 0 > 1e308", true);
        row("sqrt(-1) > 0 or sqrt(-1) <= 0", false);
    }
    void conditionIsEvaluated()
    {
        QFETCH(QString, text);
        QFETCH(bool, answer);
        ConditionFixture fixture;
        QCOMPARE(fixture.error(text), QString());
        QCOMPARE(fixture.ask(text), answer);
    }

    void invalidConditionsAreRefusedWithTheCharacterAndARemedy_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("place");
        QTest::addColumn<QString>("says");
        const auto row = [](const char *text, int place, const char *says) {
            QTest::newRow(text) << QString(text) << place << QString(says);
        };
        row("", 1, "foot0.y > 380");
        row("   ", 1, "the condition is empty");
        row("foot0.y", 1, "foot0.y > 0");
        row("foot0.y + 1", 1, "compare it");
        row("frame", 1, "frame > 0");
        row("41", 1, "compare it");
        row("foot0.y >", 10, "at the end");
        row("> 380", 1, "missing before \">\"");
        row("foot0.y > > 380", 11, "missing before");
        row("foot0.y = 380", 9, "==");
        row("foot0.y => 380", 9, "==");
        row("foot0.y == 380 foot0.x", 16, "and, or");
        row("foot0.y > 380 and", 18, "at the end");
        row("and foot0.y > 380", 1, "missing before \"and\"");
        row("foot0.y > 380 or or frame == 1", 18, "missing before");
        row("not", 4, "at the end");
        row("(foot0.y > 380", 1, "close it");
        row("foot0.y > 380)", 14, "remove it");
        row("()", 2, "missing before \")\"");
        row("(frame == 1 2)", 13, "cannot be here");
        row("1 < frame < 9", 11, "and");
        row("fooot0.y > 1", 1, "there are foot0, foot1, foot2, foot3, body");
        row("frame == 1 and fooot0.y > 1", 16, "fooot0");
        row("foot0.z > 1", 7, "x, y, vx, vy");
        row("foot0 > 1", 1, "foot0.y");
        row("foot0. > 1", 6, "has no meaning");
        row("foot0.y.x > 1", 1, "no body");
        row("speed > 1", 1, "frame, phase");
        row("foot0.angle > 1", 7, "x, y, vx, vy");
        row("phase", 1, "phase == \"");
        row("phase == 1", 1, "phase == \"");
        row("phase + 1 == 2", 1, "phase == \"");
        row("phase < \"gravity\"", 7, "== or !=");
        row("phase == \"gravty\"", 10, "gravity");
        row("phase == gravity", 1, "phase == \"");
        row("\"gravity\" > 1", 1, "only phase and choices");
        row("\"gravity\"", 1, "only phase and choices");
        row("phase == \"gravity", 10, "close it");
        row("(frame == 1) + 2 == 3", 2, "true or false");
        row("abs(frame == 1) == 1", 5, "true or false");
        row("abs foot0.y > 1", 5, "parentheses");
        row("abs(foot0.y", 4, "close it");
        row("sqrt() > 1", 6, "missing before");
        row("speed(1) > 1", 7, "as in speed(foot0)");
        row("speed() > 1", 7, "name of a body");
        row("speed(foot0.x) > 1", 7, "no body");
        row("speed(foot0, foot1) > 1", 12, "two bodies");
        row("speed(foot0", 6, "close it");
        row("still(1)", 7, "as in still(foot0)");
        row("held(fooot)", 6, "there are foot0");
        row("released(foot0", 9, "close it");
        row("still(foot0) > 1", 1, "true or false");
        row("still", 1, "there is no");
        row("distance(foot0) > 1", 15, "as in distance(foot0, foot1)");
        row("distance(foot0, fooot) > 1", 17, "there are foot0");
        row("distance foot0 > 1", 1, "frame, phase");
        row("(0,5 == k)", 3, "with a point");
        row("frame == 1 and 2", 16, "compare it");
        row("1 or frame == 1", 1, "compare it");
        row("not frame", 5, "compare it");
        row("3foot == 1", 1, "not a number");
        row("1.2.3 == 1", 1, "not a number");
        row("1e == 1", 1, "not a number");
        row("1e999 == 1", 1, "not a number");
        row("0,5 == k", 2, "point");
        row("k == 0.2; frame == 1", 9, "has no meaning");
        row("k == 0.2 ? 1 : 0", 10, "has no meaning");
        row("frame % 2 == 0", 7, "has no meaning");
        row("k ^ 2 == 0", 3, "has no meaning");
        row("foot0.y > 380 😀", 15, "has no meaning");
        row("größe > 1", 3, "has no meaning");
        row("frame == 1 & frame == 2", 12, "has no meaning");
        row("foot0.y > 1 AND k > 1", 13, "cannot directly follow");
    }
    void invalidConditionsAreRefusedWithTheCharacterAndARemedy()
    {
        QFETCH(QString, text);
        QFETCH(int, place);
        QFETCH(QString, says);
        ConditionFixture fixture;
        const QString sentence = fixture.error(text);
        QVERIFY2(sentence.startsWith(QString("Character %1: ").arg(place)), qPrintable(sentence));
        QVERIFY2(sentence.contains(says), qPrintable(sentence));
        QVERIFY2(sentence.endsWith('.') && !sentence.contains('\n'), qPrintable(sentence));
        QCOMPARE(sentence.count(QRegularExpression("[.!?] [A-Z]")), 0); // one sentence
    }

    void tooLongConditionIsRefused()
    {
        ConditionFixture fixture;
        for (const QString &part : {QString("("), QString("not "), QString("-"), QString("1+"), QString("a")})
            QVERIFY(!fixture.error(part.repeated(100000)).isEmpty());
        // As deep as the length allows.
        const int depth = (Condition::longest - 6) / 2;
        QVERIFY(fixture.ask(QString("(").repeated(depth) + "1 == 1" + QString(")").repeated(depth)));
        QVERIFY(fixture.ask("1 == " + QString("-").repeated(200) + "1"));
    }

    void conditionWithAnyPartCutOutIsReadOrRefused()
    {
        ConditionFixture fixture;
        const QString whole = "not (foot0.y*-2.5e1 >= abs(k) and phase == \"gravity\" or frame != 12)";
        QVERIFY(fixture.error(whole).isEmpty());
        for (int from = 0; from < whole.size(); ++from) {
            for (int count = 0; count + from <= whole.size(); ++count) {
                const QString sentence = fixture.error(whole.left(from) + whole.mid(from + count));
                QVERIFY2(sentence.isEmpty() || sentence.startsWith("Character "), qPrintable(sentence));
            }
        }
    }

    void conditionsReadTheAnglesOfBodiesThatTurn()
    {
        ConditionFixture fixture("swaying_tree", "branches");
        QVERIFY(fixture.state.angle.size() > 0);
        const QString body = QString::fromStdString(fixture.run.track().interval().scene.names[1]);
        fixture.phase = 0;
        fixture.state.angle[1] = 12.5;
        QVERIFY(fixture.ask(body + ".angle == 12.5"));
    }

    void aChoiceIsComparedWithTheIdsOfItsValues()
    {
        ConditionFixture fixture("swaying_tree", "branches");
        fixture.phase = 0;
        const lessons::Parameter *formula = fixture.step.parameter("formula");
        QVERIFY(formula && formula->choices.size() > 1);
        const QString is = formula->choices[int(formula->defaultValue)];
        const QString other = formula->choices[formula->defaultValue == 0.0 ? 1 : 0];
        QVERIFY(fixture.ask(QString("formula == \"%1\"").arg(is)));
        QVERIFY(!fixture.ask(QString("\"%1\" == formula").arg(other)));
        QVERIFY(fixture.ask(QString("formula != \"%1\"").arg(other)));
        QVERIFY(fixture.error("formula == \"wrong\"").contains(other));
        QVERIFY(fixture.error("formula > 1").contains("choice"));
        QVERIFY(fixture.error("formula < \"" + is + '"').contains("=="));
    }

    void conditionKnowsWhetherItReadsTheFrameNumber()
    {
        ConditionFixture fixture;
        const ConditionNames names = conditionNames(fixture.step, fixture.run);
        QVERIFY(Condition::parse("k > 1 or frame > 2", names).readsFrame());
        QVERIFY(!Condition::parse("k > 1", names).readsFrame());
    }
};

SUITE(tst_condition, TestCondition)
#include "tst_condition.moc"
