// Parameters that lessons without C++ declare: their rules and listings read them, and runs, files and new lessons keep them.

#include "app/listing/rule_program.h"
#include "app/model/lesson_folders/lesson_check.h"
#include "app/model/lesson_folders/lesson_writer.h"
#include "sim/run/timeline.h"
#include "tests/app/model/lesson_examples.h"
#include "tests/suite.h"

#include <QTemporaryDir>

#include <cmath>

using namespace app;
using namespace lesson_examples;

namespace {

const LessonLibrary &plainLibrary()
{
    return experiment_support::library();
}

/// Returns the sentence with which a lesson is refused; empty if it is read.
QString refusalOf(const LessonFiles &files, const QString &language = "en")
{
    return mistakeOf([&] { lessonOf(files, language, plainLibrary()); });
}

/// Returns how far the bob is from the middle at most in the last 200 of 2000 frames.
double widthOfSwing(sim::Script script)
{
    script.bodies["bob"] = {{330.0, 60.0 + std::sqrt(240.0 * 240.0 - 60.0 * 60.0)}, sim::Vec2{}};
    sim::Track track(script, 0);
    const int bob = track.interval().scene.find("bob");
    double widest = 0.0;
    for (int frame = 1; frame <= 2000; ++frame) {
        track.seek({frame, 0});
        if (frame > 1800)
            widest = std::max(widest, std::abs(track.state().positionOf(bob).x - 270.0));
    }
    return widest;
}

/// Returns a declaration of a parameter for the document of a step.
QByteArray declaration(const char *id, const char *items)
{
    return QByteArray("## Parameter: Thing {#") + id + "}\n\nIt does something.\n\n" + items +
           "\n\n## Try {#";
}

}

class TestLessonParameters : public QObject
{
    Q_OBJECT

private slots:
    void aRuleReadsAParameter();
    void aParameterSetsASpringOfTheScene();
    void aTranslationHasItsOwnTexts();
    void predictionsAndSolutionsSetTheParameter();
    void filesKeepTheParameter();
    void newLessonKeepsTheParameter();
    void parametersOfARuleCanBeReplacedByNumbers();
    void aMistakeIsNamedWithItsPlace_data();
    void aMistakeIsNamedWithItsPlace();
    void aTranslationThatDiffersIsRefused_data();
    void aTranslationThatDiffersIsRefused();
};

void TestLessonParameters::aRuleReadsAParameter()
{
    const LessonEntry lesson = lessonOf(filesOf(pendulum), "en", plainLibrary());
    const lessons::Step &step = *lesson.step("clock");
    const lessons::Parameter &push = step.parameters.front(); // before those of the program
    QCOMPARE(push.id, QString("wheel"));
    QCOMPARE(push.name, QString("Push"));
    QCOMPARE(push.unit, QString("px/frame²"));
    QCOMPARE(push.help, QString("How hard the wheel pushes the bob while it passes the middle."));
    QCOMPARE(push.decimals, 3);
    QVERIFY(!push.isInteger && push.defaultValue == 0.1 && push.min == 0.0 && push.max == 0.2);
    sim::Script script = step.script();
    const double full = widthOfSwing(script);
    script.values.set("wheel", 0.025);
    const double quarter = widthOfSwing(script);
    script.values.set("wheel", 0.0);
    QVERIFY(widthOfSwing(script) < 15.0); // the air takes it all: 60 px times exp(-2)
    QVERIFY2(std::abs(full - 121.0) < 2.0, qPrintable(QString::number(full)));
    // The energy of a swing grows with the square of its width.
    QVERIFY2(std::abs(quarter - full / 2.0) < 4.0, qPrintable(QString::number(quarter)));
}

void TestLessonParameters::aParameterSetsASpringOfTheScene()
{
    const LessonEntry lesson = lessonOf(filesOf(caterpillar), "en", plainLibrary());
    const lessons::Step &step = *lesson.step("pair");
    QCOMPARE(step.parameter("k")->defaultValue, 0.05); // that of the scene
    sim::Script script = step.script();
    script.bodies["head"] = {{390.0, 200.0}, {}};
    script.values.set("damp", 1.0);
    // The gap is 80 px too long, and both ends move.
    for (const double k : {0.02, 0.05, 0.2}) {
        script.values.set("k", k);
        sim::Track track(script, 0);
        track.seek({1, 0});
        const sim::Vec2 gap = track.state().positionOf(1) - track.state().positionOf(0);
        QVERIFY(std::abs(gap.x - (160.0 - 2.0 * k * 80.0)) < 1e-9);
    }
    // A change within a run acts from its frame on.
    script.values.set("damp", 0.97);
    script.values.set("k", 0.05);
    script.input = {{1, sim::Set{"k", 0.0}}};
    sim::Track track(script, 0);
    track.seek({1, 0});
    const sim::Vec2 moving = track.state().velocityOf(1);
    track.seek({2, 0});
    QVERIFY(std::abs(track.state().velocityOf(1).x - 0.97 * moving.x) < 1e-12);
}

void TestLessonParameters::aTranslationHasItsOwnTexts()
{
    const LessonEntry lesson = lessonOf(filesOf(pendulum), "de", plainLibrary());
    const lessons::Parameter &push = *lesson.step("clock")->parameter("wheel");
    QCOMPARE(push.name, QString("Stoß"));
    QCOMPARE(push.unit, QString("px/Bild²"));
    QCOMPARE(push.defaultValue, 0.1);
    LessonFiles files = filesOf(pendulum);
    files.all.erase("clock.de.md");
    QCOMPARE(lessonOf(files, "de", plainLibrary()).step("clock")->parameter("wheel")->name, QString("Push"));
    // It may repeat the numbers.
    files = pendulumWith("clock.de.md", "- unit: px/Bild²", "- value: 0.1\n- step: 0.001\n- unit: px/Bild²");
    QCOMPARE(refusalOf(files, "de"), QString());
}

void TestLessonParameters::predictionsAndSolutionsSetTheParameter()
{
    LessonFiles files =
        pendulumWith("clock.md", "- damp: 0.9\n\n### Other curve", "- wheel: 0\n\n### Other curve");
    LessonEntry lesson = lessonOf(files, "en", plainLibrary());
    std::erase_if(lesson.steps, [](const lessons::Step &step) { return step.id != u"clock"; });
    lesson.recall = {};
    int things = 0;
    for (const LessonFinding &one : checkLesson(files, lesson, plainLibrary())) {
        QVERIFY2(one.isGood, qPrintable(one.id + ": " + one.sentence));
        things += one.id == u"quarter" || one.id == u"wide" ? 1 : 0;
    }
    QCOMPARE(things, 2);
    files = pendulumWith("clock.md", "- wheel: 0.025", "- wheel: 0.3");
    QVERIFY2(refusalOf(files).contains("wheel cannot be \"0.3\". It can be a number from 0 to 0.2."),
             qPrintable(refusalOf(files)));
}

void TestLessonParameters::filesKeepTheParameter()
{
    LessonLibrary library = plainLibrary();
    library.yours.push_back(lessonOf(filesOf(pendulum), "en", library));
    Experiment experiment = newExperiment(pendulum, "clock", library);
    experiment.script.values.set("wheel", 0.15);
    experiment.script.input = {{10, sim::Set{"wheel", 0.05}}};
    const QByteArray text = experimentText(experiment, library);
    QVERIFY(text.contains("\"wheel\": 0.15"));
    const Experiment back = parseExperiment(text, "x.json", library);
    QVERIFY(back.script.values == experiment.script.values && back.script.input == experiment.script.input);
    QString refused;
    try {
        parseExperiment(QByteArray(text).replace("0.15", "0.25"), "x.json", library);
    } catch (const UserError &error) {
        refused = error.sentence();
    }
    QVERIFY2(refused.contains("\"wheel\" is 0.25; it can be 0 to 0.2."), qPrintable(refused));
}

void TestLessonParameters::newLessonKeepsTheParameter()
{
    LessonLibrary library = plainLibrary();
    library.yours.push_back(lessonOf(filesOf(pendulum), "en", library));
    library.yours.push_back(lessonOf(filesOf(caterpillar), "en", library));
    const QTemporaryDir dir;
    QString mistakes;
    const auto begun = [&](const QString &lesson, const QString &step, const std::string &id, double value) {
        Experiment scene = newExperiment(lesson, step, library);
        scene.script.values.set(id, value);
        scene.script.input = {{3, sim::Set{id, 0.0}}};
        const QString folder = dir.filePath(lesson + "_again");
        writeLesson(scene, folder, library);
        const LessonFiles files = readLessonFiles(folder);
        const LessonEntry written = lessonOf(files, "en", library);
        for (const LessonFinding &one : checkLesson(files, written, library))
            mistakes += one.isGood ? QString() : one.id + ": " + one.sentence;
        return written.steps.front();
    };
    const lessons::Step clock = begun(pendulum, "clock", "wheel", 0.15);
    QCOMPARE(clock.parameter("wheel")->defaultValue, 0.15);
    QCOMPARE(clock.parameter("wheel")->max, 0.2);
    const lessons::Step worm = begun(caterpillar, "pair", "k", 0.11);
    QCOMPARE(worm.parameter("k")->defaultValue, 0.11);
    QCOMPARE(worm.parameter("k")->name, QString("Stiffness"));
    QVERIFY(worm.script().input.empty());
    QCOMPARE(mistakes, QString());
}

void TestLessonParameters::parametersOfARuleCanBeReplacedByNumbers()
{
    const std::string rule = "// wheel\nVec2 force(Body me)\n{\n    double low = 5 / wheel;\n"
                             "    if (me.radius > 3) { double wheel = 2; low = wheel; }\n"
                             "    return Vec2(low, -kick * me.mass);\n}\n";
    QVERIFY(!listing::compileRule(rule).rule);
    QVERIFY(listing::compileRule(rule, {"wheel", "kick"}).rule);
    const std::string with = listing::withNumbers(rule, {{"wheel", 2.0}, {"kick", -0.00001}, {"mass", 7.0}});
    QCOMPARE(QString::fromStdString(with),
             QString("// wheel\nVec2 force(Body me)\n{\n    double low = 5 / 2.0;\n"
                     "    if (me.radius > 3) { double wheel = 2; low = wheel; }\n"
                     "    return Vec2(low, -(-0.00001) * me.mass);\n}\n"));
    QVERIFY(listing::compileRule(with).rule);
}

void TestLessonParameters::aMistakeIsNamedWithItsPlace_data()
{
    addMistakeColumns();
    const auto row = addMistake;
    const char *const text = "How hard the wheel pushes the bob while it passes the middle.\n";
    row("no sentence", "clock.md", text, "",
        "pendulum_clock/clock.md, line 14: nothing says what the parameter “wheel” does.");
    row("no name", "clock.md", "Parameter: Push {#wheel}", "Parameter {#wheel}",
        "the parameter “wheel” has no name.");
    row("no id", "clock.md", "Push {#wheel}", "Push", "has no id");
    row("an unknown item", "clock.md",
        "- unit:", "- units:", "clock.md, line 22: a parameter has no “units”.");
    row("a word for a number", "clock.md", "- value: 0.1", "- value: hard",
        "clock.md, line 18: “hard” is not a number");
    row("not finite", "clock.md", "- value: 0.1", "- value: nan", "“nan” is not a number");
    row("twice", "clock.md", "- value: 0.1", "- value: 0.1\n- value: 0.1",
        "clock.md, line 19: “value” is there twice.");
    row("a step of its own", "clock.md", "- step: 0.001", "- step: 0.05", "the step cannot be 0.05.");
    row("a long unit", "clock.md", "px/frame²", "pixels in a frame of a frame",
        "this unit has 28 characters.");
    row("no range", "clock.md", "- maximum: 0.2\n", "", "line 14: the parameter “wheel” has no range.");
    row("an empty range", "clock.md", "- minimum: 0\n", "- minimum: 0.2\n",
        "the minimum of “wheel” is not below its maximum.");
    row("no value", "clock.md", "- value: 0.1\n", "", "the parameter “wheel” has no value at the start.");
    row("a value outside", "clock.md", "- value: 0.1", "- value: 0.3",
        "the value of “wheel” is 0.3, outside its range from 0 to 0.2. Change one of them.");
    row("whole numbers", "clock.md", "- step: 0.001", "- step: 1", "the step of “wheel” is 1");
    row("a heading below", "clock.md", "- unit: px/frame²\n", "- unit: px\n\n### Hint\n\nPush.\n",
        "“### Hint” does not belong here.");
    row("in the scene, too", "clock.json", "\"damp\": 0.998", "\"damp\": 0.998, \"wheel\": 0.1",
        "clock.json: line 6: pendulum_clock/clock.md says where the parameter \"wheel\" begins.");
    row("not declared", "clock.md", "{#wheel}", "{#wheell}", "\"rule\" does not compile.");
    const QByteArray numbers = "- value: 1\n- minimum: 0\n- maximum: 2";
    row("a name that is taken", "swing.md", "## Try {#", declaration("gravity", numbers),
        "the scene has a parameter “gravity” already.");
    row("a word of the language", "swing.md", "## Try {#", declaration("frame", numbers),
        "a parameter cannot be called “frame”");
    row("a word of runs", "swing.md", "## Try {#", declaration("method", numbers),
        "a parameter cannot be called “method”");
    row("a body", "swing.md", "## Try {#", declaration("bob", numbers),
        "bodies of the scene are called “bob”.");
    row("nothing reads it", "swing.md", "## Try {#", declaration("sway", numbers),
        "nothing reads the parameter “sway”. Write sway into the rule");
    row("no spring there", "swing.md", "## Try {#",
        declaration("sway", "- sets: k of nail-bob\n- minimum: 0\n- maximum: 2"),
        "the scene has no springs. Build one, or write “- value: ” in place of “- sets: ”.");
    row("no stick there", "swing.md", "## Try {#",
        declaration("sway", "- sets: length of nail-bop\n- minimum: 0\n- maximum: 2"),
        "no spring or stick of the scene joins “nail” and “bop”. They join \"nail-bob\".");
    row("another number", "swing.md", "## Try {#",
        declaration("sway", "- sets: colour of bob\n- minimum: 0\n- maximum: 2"),
        "“colour of bob” is not something that a parameter can set.");
    row("a scene outside the range", "swing.md", "## Try {#",
        declaration("sway", "- sets: length of bob-nail\n- minimum: 0\n- maximum: 100"),
        "the scene has 240 there, which does not fit the parameter “sway” from 0 to 100.");
    row("a negative length", "swing.md", "## Try {#",
        declaration("sway", "- sets: length of bob-nail\n- minimum: -10\n- maximum: 300"),
        "“length” can be 0 to 1000000 in a scene");
    row("a value and a target", "swing.md", "## Try {#",
        declaration("sway", "- sets: length of bob-nail\n- value: 240\n- minimum: 0\n- maximum: 300"),
        "begins with the value that the scene has there. Remove “- value”.");
    row("two lengths", "two.md", "## Try {#",
        declaration("sway", "- sets: length of nail-long, length of pin-short\n- minimum: 0\n- maximum: 300"),
        "“sway” sets several numbers, of which one is 240 and another is 60 in the scene.");
}

void TestLessonParameters::aMistakeIsNamedWithItsPlace()
{
    checkMistake();
}

void TestLessonParameters::aTranslationThatDiffersIsRefused_data()
{
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::addColumn<QString>("said");
    QTest::newRow("missing") << QByteArray("{#wheel}") << QByteArray("{#stoss}")
                             << "clock.de.md, line 1: the parameter “wheel” is missing.";
    QTest::newRow("one more") << QByteArray("## Try {#") << declaration("stoss", "- unit: px")
                              << "declares no parameter “stoss”.";
    QTest::newRow("another number") << QByteArray("- unit: px/Bild²") << QByteArray("- maximum: 0.3")
                                    << "the maximum of “wheel” differs between the languages.";
    QTest::newRow("another target") << QByteArray("- unit: px/Bild²")
                                    << QByteArray("- sets: length of nail-bob")
                                    << "“sets” differs between the languages.";
}

void TestLessonParameters::aTranslationThatDiffersIsRefused()
{
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    QFETCH(QString, said);
    const LessonFiles files = pendulumWith("clock.de.md", from, to);
    QVERIFY(!files.all.empty());
    QVERIFY2(refusalOf(files, "de").contains(said), qPrintable(refusalOf(files, "de")));
    QCOMPARE(refusalOf(files), QString()); // English is shown without it
}

SUITE(tst_lesson_parameters, TestLessonParameters)
#include "tst_lesson_parameters.moc"
