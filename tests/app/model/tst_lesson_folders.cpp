// Lessons without C++: the installed examples, mistakes in folders, zips from strangers, new lessons.

#include "app/model/lesson_folders/lesson_check.h"
#include "app/model/lesson_folders/lesson_languages.h"
#include "app/model/lesson_folders/lesson_writer.h"
#include "app/model/lesson_folders/zip_reader.h"
#include "sim/run/timeline.h"
#include "tests/app/model/lesson_examples.h"
#include "tests/app/support/files.h"
#include "tests/app/support/zip_writer.h"
#include "tests/suite.h"

#include <QDir>
#include <QTemporaryDir>

#include <cmath>
#include <numbers>
#include <set>

using namespace app;
using namespace lesson_examples;

namespace {

const LessonLibrary &builtIn()
{
    return experiment_support::library();
}

/// Returns the positions of a body in frames 0 to `frames` of a run.
std::vector<sim::Vec2> pathOf(const sim::Script &script, const std::string &body, int frames)
{
    sim::Track track(script, 0);
    const int point = track.interval().scene.find(body);
    std::vector<sim::Vec2> path;
    for (int frame = 0; frame <= frames; ++frame) {
        track.seek({frame, 0});
        path.push_back(track.state().positionOf(point));
    }
    return path;
}

/// Returns the mean time between passes of `x` to the right, in frames.
double periodOf(const std::vector<sim::Vec2> &path, double x)
{
    std::vector<double> passes;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const double before = path[i - 1].x - x, after = path[i].x - x;
        if (before < 0.0 && after >= 0.0)
            passes.push_back(static_cast<double>(i) - after / (after - before));
    }
    return (passes.back() - passes.front()) / static_cast<double>(passes.size() - 1);
}

/// Returns the run of a step in which the body starts at rest on a circle around a nail, `aside` px from its lowest place.
sim::Script swungAside(const lessons::Step &step, const std::string &body, sim::Vec2 nail, double length,
                       double aside)
{
    sim::Script script = step.script();
    script.bodies[body] = {nail + sim::Vec2{aside, std::sqrt(length * length - aside * aside)}, sim::Vec2{}};
    return script;
}

QByteArray patched(QByteArray bytes, qsizetype at, const QByteArray &by)
{
    return bytes.replace(at, by.size(), by);
}

/// Returns the zip of a small lesson, of which each file is named by `name`.
QByteArray zipWith(const QString &name)
{
    return tests::zipOf({{name, "a"}, {"zz.md", "b"}});
}

}

class TestLessonFolders : public QObject
{
    Q_OBJECT

private slots:
    void examplesPassTheirCheck_data()
    {
        QTest::addColumn<QString>("example");
        QTest::newRow("pendulum clock") << pendulum;
        QTest::newRow("caterpillar") << caterpillar;
    }

    void examplesPassTheirCheck()
    {
        QFETCH(QString, example);
        const LessonEntry lesson = lessonOf(filesOf(example), "en", builtIn());
        QCOMPARE(lesson.steps.size(), std::size_t(3));
        const LessonEntry german = lessonOf(filesOf(example), "de", builtIn());
        QVERIFY(german.title != lesson.title);
        checkSameQuestions(lesson, german);
        std::set<LessonFinding::Kind> kinds;
        for (const LessonFinding &one : checkLesson(filesOf(example), lesson, builtIn())) {
            kinds.insert(one.kind);
            QVERIFY2(one.isGood,
                     qPrintable(one.step + ' ' + wordFor(one.kind) + ' ' + one.id + ": " + one.sentence));
        }
        QCOMPARE(kinds.size(), std::size_t(5)); // all but levels
    }

    void periodOfAPendulumMatchesTheFormula_data()
    {
        QTest::addColumn<QString>("step");
        QTest::addColumn<QString>("body");
        QTest::addColumn<double>("nail");
        QTest::addColumn<double>("length");
        QTest::newRow("one") << "swing"
                             << "bob" << 270.0 << 240.0;
        QTest::newRow("long") << "two"
                              << "long" << 230.0 << 240.0;
        QTest::newRow("short") << "two"
                               << "short" << 400.0 << 60.0;
    }

    void periodOfAPendulumMatchesTheFormula()
    {
        QFETCH(QString, step);
        QFETCH(QString, body);
        QFETCH(double, nail);
        QFETCH(double, length);
        const LessonEntry lesson = lessonOf(filesOf(pendulum), "en", builtIn());
        const sim::Script script = swungAside(*lesson.step(step), body.toStdString(), {nail, 60.0}, length,
                                              -0.08 * length); // less than 5°
        const double formula = 2.0 * std::numbers::pi * std::sqrt(length / 0.3);
        const double period = periodOf(pathOf(script, body.toStdString(), 800), nail);
        QVERIFY2(std::abs(period - formula) < 0.003 * formula, qPrintable(QString::number(period)));
    }

    void theClockFindsItsOwnSwing_data()
    {
        QTest::addColumn<double>("start");
        QTest::newRow("narrow") << 20.0;
        QTest::newRow("wide") << 170.0;
    }

    void theClockFindsItsOwnSwing()
    {
        QFETCH(double, start);
        const LessonEntry lesson = lessonOf(filesOf(pendulum), "en", builtIn());
        const auto path =
            pathOf(swungAside(*lesson.step("clock"), "bob", {270.0, 60.0}, 240.0, start), "bob", 2400);
        double widest = 0.0;
        for (std::size_t i = path.size() - 200; i < path.size(); ++i)
            widest = std::max(widest, path[i].x - 270.0);
        QVERIFY2(std::abs(widest - 121.0) < 2.0, qPrintable(QString::number(widest)));
    }

    void onlyClawsMoveTheMiddleOfTheCaterpillar()
    {
        const LessonEntry lesson = lessonOf(filesOf(caterpillar), "en", builtIn());
        const auto middleAfter = [](const sim::Script &script, int frames) {
            sim::Track track(script, 0);
            track.seek({frames, 0});
            return track.state().position.col(0).mean();
        };
        QVERIFY(std::abs(middleAfter(lesson.step("wave")->script(), 600) - 270.0) < 1e-9);
        sim::Script script = lesson.step("claws")->script();
        QVERIFY(std::abs(middleAfter(script, 200) - 271.7) < 0.1);
        script.values.set("friction", 0.0);
        QVERIFY(std::abs(middleAfter(script, 200) - 135.0) < 1e-9);
    }

    void aMistakeInADocumentIsNamedWithItsPlace_data()
    {
        addMistakeColumns();
        addMistake("not UTF-8", "swing.md", "bob",
                   "b\xf6"
                   "b",
                   "pendulum_clock/swing.md, line 3: this is not UTF-8.");
        addMistake("a picture", "swing.md", "Pull it far,", "![x](/etc/passwd)",
                   "swing.md, line 12: a text cannot show pictures.");
        addMistake("an unknown heading", "swing.md", "### Done when", "### Done if",
                   "swing.md, line 23: “### Done if”");
        addMistake("a body that is not there", "swing.md", "released(bob)", "released(bop)",
                   "swing.md, line 25: Character 23: there is no body \"bop\" here; there are bob, nail.");
        addMistake("a number alone", "swing.md", "speed(bob) > 2", "speed(bob)",
                   "swing.md, line 28: Character 1: a number is neither true nor false");
        addMistake("no condition", "swing.md",
                   "### Done when\n\n- begun: held(bob) or released(bob)\n- let_go: released(bob)\n"
                   "- middle: abs(bob.x - nail.x) < 15\n- fast: speed(bob) > 2\n",
                   "", "swing.md, line 15: nothing says when the thing to try “let_go” is done.");
        addMistake(
            "a sentence without a condition", "swing.md", "- middle: abs", "- centre: abs",
            "the thing to try “let_go” has no condition “middle”. Remove the sentence, or give it one of the "
            "names: begun, let_go, centre, fast.");
        addMistake("a number that nothing measures", "swing.md", "abs(bob.x - nail.x) < 15",
                   "bob.x > 255 and bob.x < 285", "swing.md, line 27: %1 stands for a number");
        addMistake("a solution with a wrong body", "swing.md", "- drag bob: 350", "- drag bop: 350",
                   "swing.md, line 36: There is no body \"bop\" here");
        addMistake("a solution without an end", "swing.md", "- frames: 120", "- k: 3",
                   "this run needs “- frames: ”");
        addMistake("a parameter that is not there", "swing.md", "- gravity: 1.2\n", "- gravitation: 1.2\n",
                   "There is no parameter \"gravitation\" here");
        addMistake("a task without a gap", "swing.md", "{#fall}", "{#falls}",
                   "the listing has no gap “falls”");
        addMistake("a near miss that does not compile", "swing.md", "bob.velocity.y -= gravity;",
                   "bob.velocity.y -= gravty;", "a near miss of the task \"fall\" does not compile");
    }

    void aMistakeInADocumentIsNamedWithItsPlace() { checkMistake(); }

    void aMistakeInAnotherFileIsNamed_data()
    {
        addMistakeColumns();
        addMistake("not JSON", "lesson.json", "\"id\":", "\"id\"",
                   "lesson.json: line 3: a colon is expected");
        addMistake("another format", "lesson.json", "springstep-lesson/1", "springstep-lesson/7",
                   "lesson.json: line 2: \"format\" is \"springstep-lesson/7\"; this program reads "
                   "\"springstep-lesson/1\".");
        addMistake("an id of a built-in lesson", "lesson.json", "\"pendulum_clock\"", "\"two_body\"",
                   "lesson.json: line 3: there is another lesson with the id \"two_body\"");
        addMistake("an id with a space", "lesson.json", "\"pendulum_clock\"", "\"my clock\"",
                   "cannot have the id \"my clock\"");
        addMistake("a step twice", "lesson.json", "\"two\"", "\"swing\"",
                   "a step cannot have the id \"swing\"");
        addMistake(
            "a step without files", "lesson.json", "\"two\"", "\"three\"",
            "pendulum_clock/three.json: the file is missing. It has the scene of the step: save it in the "
            "window under this name, with the ending .json.");
        addMistake("a step that is not listed", "lesson.json", ", \"clock\"", "",
                   "there is no step \"clock\" in \"steps\" of lesson.json");
        addMistake("an unknown field", "lesson.json", "\"summary\"", "\"sumary\"", "\"sumary\"");
        addMistake("a listing that does not compile", "swing.code", "length(from) - sticks",
                   "size(from) - sticks", "pendulum_clock/swing.code, line 25:");
        addMistake("a gap without an end", "swing.code", "        //<\n", "", "swing.code");
        addMistake("a listing with small steps", "swing.json", "\"step\": \"build\",",
                   "\"step\": \"build\", \"h\": 0.5,", "Set \"h\" to 1 in swing.json.");
        addMistake("a scene without a body", "swing.json", "\"b\": \"bob\"", "\"b\": \"pop\"",
                   "swing.json: line 11: there is no body \"pop\" in this scene");
        addMistake("a rule that does not compile", "clock.json", "velocity.x > 0", "velocity.x >> 0",
                   "\"rule\" does not compile. Line 8");
        addMistake("a question about no step", "recall.md", "pendulum_clock/swing", "pendulum_clock/swim",
                   "recall.md, line 63: there is no step \"pendulum_clock/swim\".");
    }

    void aMistakeInAnotherFileIsNamed() { checkMistake(); }

    void aLessonThatAsksTooMuchFailsItsCheck_data()
    {
        addMistakeColumns();
        addMistake("a solution that is too short", "swing.md", "- frames: 120", "- frames: 12",
                   "its solution does not do it in 12 frames");
        addMistake("conditions that exclude each other", "swing.md",
                   "- middle:", "- held: held(bob)\n- middle:",
                   "each condition holds in some frame, but they never all hold in the same one");
        addMistake("a try that does itself", "two.md",
                   "- begun: gravity != 0.3\n- moon: abs(gravity - 0.05) < 0.005\n",
                   "- begun: frame > 5\n- moon: frame > 7\n", "it is done in frame 100 without the learner");
        addMistake("a prediction without an end", "swing.md", "- until: bob.vx < 0",
                   "- until: bob.vx < -1000", "its condition does not hold up to frame 300");
        addMistake("curves that look the same", "two.md", "- gravity: 1.2\n", "- iterations: 9\n",
                   "two of its curves look the same");
        addMistake("a nail that cannot be held", "swing.code",
                   "    if (nail.held)\n        nail.position = hand;\n", "",
                   "in which the hand holds it. Every body can be held: write “if (nail.held) nail.position "
                   "= hand;”");
        addMistake("another motion", "swing.code", "bob.velocity *= damp;", "bob.velocity *= damp * damp;",
                   "the listing moves \"bob\" otherwise than the method semi_implicit_euler");
    }

    void aLessonThatAsksTooMuchFailsItsCheck()
    {
        QFETCH(QString, file);
        QFETCH(QString, said);
        const LessonFiles files = mistakenFiles();
        QVERIFY(!files.all.empty());
        LessonEntry lesson = lessonOf(files, "en", builtIn());
        std::erase_if(lesson.steps,
                      [&](const lessons::Step &step) { return !file.startsWith(step.id + '.'); });
        lesson.recall = {};
        QStringList failures;
        for (const LessonFinding &one : checkLesson(files, lesson, builtIn())) {
            if (!one.isGood)
                failures << one.sentence;
        }
        QVERIFY2(failures.join('\n').contains(said), qPrintable(failures.join('\n')));
    }

    void lessonCanBeReadFromItsZip()
    {
        const QTemporaryDir dir;
        const QString file = dir.filePath("clock" + lessonEnding);
        tests::writeFile(file, tests::zipOf(filesOf(pendulum).all));
        QVERIFY(isLessonPath(file) && isLessonPath(examplesFolder + pendulum) && !isLessonPath(dir.path()));
        QVERIFY(readLessonFiles(file).all == filesOf(pendulum).all);
        QCOMPARE(readLesson(file, builtIn()).steps.size(), std::size_t(3));
    }

    void aZipOfTheFolderItselfIsReadToo()
    {
        std::map<QString, QByteArray> files;
        for (const auto &[name, content] : filesOf(pendulum).all)
            files["clock/" + name] = content;
        QVERIFY(readZip(tests::zipOf(files), "x", {mostLessonFiles, largestLessonFile, largestLesson}) ==
                filesOf(pendulum).all);
    }

    void aZipFromAStrangerIsRefused_data()
    {
        QTest::addColumn<QByteArray>("zip");
        QTest::addColumn<QString>("said");
        const QByteArray good = zipWith("aa.md");
        const qsizetype table = good.indexOf("PK\x01\x02"), end = good.indexOf("PK\x05\x06");
        const QByteArray zeros(largestLessonFile + 1, '\0');
        QTest::newRow("a path upwards") << zipWith("../aa.md") << "leads out of the lesson";
        QTest::newRow("a path upwards inside") << zipWith("aa/../../aa.md") << "leads out of the lesson";
        QTest::newRow("an absolute path") << zipWith("/etc/passwd") << "leads out of the lesson";
        QTest::newRow("a path of Windows") << zipWith("..\\aa.md") << "leads out of the lesson";
        QTest::newRow("a drive") << zipWith("C:aa.md") << "leads out of the lesson";
        QTest::newRow("a folder") << zipWith("aa/bb.md") << "\"aa/bb.md\" is in a folder";
        QTest::newRow("a link") << patched(good, table + 38, QByteArray("\0\0\xff\xa1", 4)) << "is a link";
        QTest::newRow("a password") << patched(good, table + 8, QByteArray(1, '\1')) << "has a password";
        QTest::newRow("another packing")
            << patched(good, table + 10, QByteArray(1, '\14')) << "compressed by a method";
        QTest::newRow("a name twice") << QByteArray(good).replace("zz.md", "aa.md") << "is there twice";
        QTest::newRow("a name that is not UTF-8")
            << QByteArray(good).replace("zz.md", "z\xff.md") << "not UTF-8";
        QTest::newRow("a large file") << tests::zipOf({{"aa.md", zeros}}) << "is larger than 4 MiB";
        QTest::newRow("a bomb") << patched(tests::zipOf({{"aa.md", zeros}}),
                                           tests::zipOf({{"aa.md", zeros}}).indexOf("PK\x01\x02") + 24,
                                           QByteArray("\x10\0\0\0", 4))
                                << "is larger than the zip says";
        QTest::newRow("other content")
            << patched(good, table + 16, QByteArray(1, '\7')) << "the zip is damaged";
        QTest::newRow("cut") << good.left(end) << "its end is missing";
        QTest::newRow("a table beyond the end")
            << patched(good, end + 16, QByteArray("\xff\xff\xff\x7f", 4)) << "the zip is damaged";
        QTest::newRow("too many files")
            << patched(good, end + 8, QByteArray("\xff\xff\xff\xff", 4)) << "several parts";
        QTest::newRow("no zip") << QByteArray("hello") << "this is not a zip";
        QTest::newRow("nothing") << QByteArray() << "this is not a zip";
    }

    void aZipFromAStrangerIsRefused()
    {
        QFETCH(QByteArray, zip);
        QFETCH(QString, said);
        const QString mistake = mistakeOf([&] {
            readZip(zip, "stranger.springstep-lesson", {mostLessonFiles, largestLessonFile, largestLesson});
        });
        QVERIFY2(mistake.startsWith("stranger.springstep-lesson: ") && mistake.contains(said),
                 qPrintable(mistake));
    }

    void manyFilesAreRefused()
    {
        std::map<QString, QByteArray> files;
        for (std::size_t i = 0; i <= mostLessonFiles; ++i)
            files[QStringLiteral("a%1.md").arg(i)] = "a";
        const QString mistake = mistakeOf([&] {
            readZip(tests::zipOf(files), "x", {mostLessonFiles, largestLessonFile, largestLesson});
        });
        QVERIFY2(mistake.contains("more than 200 files"), qPrintable(mistake));
    }

    void aLinkInAFolderIsRefused()
    {
        const QTemporaryDir dir;
        QVERIFY(QFile::copy(examplesFolder + pendulum + "/lesson.json", dir.filePath("lesson.json")));
        QVERIFY(QFile::link("/etc/passwd", dir.filePath("swing.md")));
        const QString mistake = mistakeOf([&] { readLessonFiles(dir.path()); });
        QVERIFY2(mistake.contains("swing.md is a link"), qPrintable(mistake));
    }

    void aNewLessonPassesItsCheck_data()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("step");
        QTest::newRow("sandbox") << "sandbox"
                                 << "build";
        QTest::newRow("spring") << "single_spring"
                                << "radial";
        QTest::newRow("creature") << "multi_foot"
                                  << "any_number";
        QTest::newRow("sticks") << "rigid_constraint"
                                << "ragdoll";
        QTest::newRow("tree") << "swaying_tree"
                              << "trunk";
    }

    void aNewLessonPassesItsCheck()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, step);
        const QTemporaryDir dir;
        const QString folder = dir.filePath("My lesson!");
        writeLesson(newExperiment(lesson, step, builtIn()), folder, builtIn());
        const LessonEntry written = readLesson(folder, builtIn());
        QCOMPARE(written.id, "my_lesson");
        const std::vector<LessonFinding> findings = checkLesson(readLessonFiles(folder), written, builtIn());
        QVERIFY(!findings.empty());
        for (const LessonFinding &one : findings)
            QVERIFY2(one.isGood, qPrintable(wordFor(one.kind) + ' ' + one.id + ": " + one.sentence));
        const QString mistake =
            mistakeOf([&] { writeLesson(newExperiment(lesson, step, builtIn()), folder, builtIn()); });
        QVERIFY2(mistake.contains("is not empty"), qPrintable(mistake));
    }

    void yourLessonsComeAfterTheOthers()
    {
        const LessonLibrary with = LessonLibrary::load({LESSON_DIR, examplesFolder});
        QVERIFY(with.problems.empty());
        QCOMPARE(with.yours.size(), std::size_t(2));
        QCOMPARE(&with.entry(with.entries() - 1), &with.yours.back());
        QCOMPARE(with.lesson(pendulum)->source, QFileInfo(examplesFolder + pendulum).canonicalFilePath());
        QVERIFY(with.lesson(pendulum)->step("two")->points == lessons::PointSource::step);
        // An experiment of a lesson without C++ is saved and read like any other.
        Experiment experiment = newExperiment(pendulum, "two", with);
        experiment.script.values.set("gravity", 0.05);
        const QByteArray text = experimentText(experiment, with);
        QVERIFY(!text.contains("scene"));
        const Experiment back = parseExperiment(text, "x.json", with);
        QVERIFY(back.script.values == experiment.script.values);
        QCOMPARE(experimentText(back, with), text);
    }

    void conditionsKnowTheHandAndRest()
    {
        const LessonEntry lesson = lessonOf(filesOf(caterpillar), "en", builtIn());
        const lessons::Step &step = *lesson.step("pair");
        const lessons::Conditions &pull = step.tries.front().conditions; // begun, let_go, rest, gap
        sim::Timeline run(step.script());
        QVERIFY(!pull.all()[0].holds(run) && !pull.all()[1].holds(run) && pull.all()[2].holds(run));
        run.applyInput(sim::Grab{"head"});
        run.applyInput(sim::Move{{380.0, 200.0}});
        run.nextOutputStep();
        QVERIFY(pull.all()[0].holds(run) && !pull.all()[1].holds(run) && !pull.all()[2].holds(run));
        QCOMPARE(pull.todo(run), "let go of the head.");
        run.applyInput(sim::Release{});
        run.nextOutputStep();
        QVERIFY(pull.all()[0].holds(run) && pull.all()[1].holds(run) && !pull.hold(run));
        run.seek({600, 0});
        QVERIFY(pull.hold(run));
    }
};

SUITE(tst_lesson_folders, TestLessonFolders)
#include "tst_lesson_folders.moc"
