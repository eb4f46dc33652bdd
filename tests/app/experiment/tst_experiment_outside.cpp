// Events that only some steps accept, and files that replace a step's points and sticks.

#include "sim/run/timeline.h"
#include "tests/app/experiment/user_errors.h"
#include "tests/suite.h"

#include <QTest>

using namespace app;

namespace {

QByteArray file(const char *lesson, const char *step, const QByteArray &fields)
{
    return "{\n\"format\": \"springstep-experiment/1\",\n\"lesson\": \"" + QByteArray(lesson) +
           "\",\n\"step\": \"" + step + "\",\n" + fields + "\n}\n";
}

QByteArray sticks(const QByteArray &fields)
{
    return file("rigid_constraint", "list", fields);
}

QByteArray points(int count, const char *first = "p")
{
    QByteArray text;
    for (int i = 0; i < count; ++i)
        text += (i ? ", \"" : "\"") + QByteArray(first) + QByteArray::number(i) +
                "\": {\"x\": " + QByteArray::number(100 + 30 * i) + ", \"y\": 100}";
    return "\"bodies\": {" + text + "}";
}

Experiment read(const QByteArray &text)
{
    static const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
    return parseExperiment(text, "x.json", library);
}

}

class TestExperimentOutside : public QObject
{
    Q_OBJECT

private slots:
    void errorsNameTheirLine_data()
    {
        user_errors::addColumns();
        const auto row = [](const char *name, const QByteArray &text, const QString &sentence) {
            QTest::newRow(name) << text << sentence;
        };
        row("an unknown key",
            file("walking_gait", "steering",
                 "\"input\": [{\"frame\": 1, \"event\": \"key\", \"key\": \"shift\", \"down\": true}]"),
            "line 5: there is no key \"shift\"; there is \"left\", \"right\", \"up\", \"down\".");
        row("a key neither down nor up",
            file("walking_gait", "steering",
                 "\"input\": [{\"frame\": 1, \"event\": \"key\", \"key\": \"left\"}]"),
            "line 5: an event has no \"down\"; add it. It must be true or false.");
        row("a pointer that is down by 1",
            file("swaying_tree", "wind",
                 "\"input\": [{\"frame\": 1, \"event\": \"pointer\", \"x\": 1, \"y\": 2, \"down\": 1}]"),
            "line 5: \"down\" is 1; it must be true or false.");
        row("a pointer without y",
            file("swaying_tree", "wind", "\"input\": [{\"frame\": 1, \"event\": \"pointer\", \"x\": 1}]"),
            "line 5: an event has no \"y\"; add it. It must be a number.");
        row("a target without a place",
            file("codeling", "motor", "\"input\": [{\"frame\": 1, \"event\": \"target\"}]"),
            "line 5: an event has no \"x\"; add it. It must be a number.");
        row("a gust without degrees",
            file("swaying_tree", "turbulence", "\"input\": [{\"frame\": 1, \"event\": \"gust\"}]"),
            "line 5: an event has no \"degrees\"; add it. It must be a number.");
        row("a gust where there is no turbulence",
            file("swaying_tree", "wind", "\"input\": [{\"frame\": 1, \"event\": \"gust\", \"degrees\": 3}]"),
            "line 5: the step \"wind\" has no event \"gust\"; it has \"grab\", \"move\", \"release\", "
            "\"pointer\", \"set\".");
        row("a point of another name", sticks(points(2, "q")),
            "line 5: there is no body \"q0\" here; the points are called \"p0\", \"p1\" and so on.");
        row("a leading zero", sticks("\"bodies\": {\"p00\": {\"x\": 1, \"y\": 1}}"),
            "line 5: there is no body \"p00\" here; the points are called \"p0\", \"p1\" and so on.");
        row("a gap", sticks("\"bodies\": {\"p0\": {\"x\": 1, \"y\": 1},\n\"p2\": {\"x\": 1, \"y\": 1}}"),
            "line 6: the points have a gap: 2 of them are \"p0\" to \"p1\", without \"p2\".");
        row("too many points", sticks(points(1001)), "line 5: \"bodies\" has 1001 points; the most is 1000.");
        row("an end that is not there",
            sticks(points(2) +
                   ",\n\"links\": [{\"a\": \"p0\", \"b\": \"p2\", \"length\": 9, \"share\": 0.5}]"),
            "line 6: there is no point \"p2\" here; there is \"p0\" to \"p1\".");
        row("one point at both ends",
            sticks(points(2) + ",\n\"links\": [{\"a\": \"p1\", \"b\": \"p1\", \"length\": 9}]"),
            "line 6: a link has \"p1\" at both ends; give it two points.");
        row("a share beyond 1",
            sticks(points(2) +
                   ",\n\"links\": [{\"a\": \"p0\", \"b\": \"p1\", \"length\": 9, \"share\": 1.5}]"),
            "line 6: \"share\" is 1.5; it can be 0 to 1.");
        row("a length below 0",
            sticks(points(2) + ",\n\"links\": [{\"a\": \"p0\", \"b\": \"p1\", \"length\": -9}]"),
            "line 6: \"length\" is -9; it can be 0 to 1000000.");
        row("a link without a length", sticks(points(2) + ",\n\"links\": [{\"a\": \"p0\", \"b\": \"p1\"}]"),
            "line 6: a link has no \"length\"; add it. It must be a number.");
        row("links that are no list", sticks(points(2) + ",\n\"links\": 3"),
            "line 6: \"links\" is 3; it must be a list in [ ].");
    }
    void errorsNameTheirLine() { user_errors::checkRow(); }

    void bodiesOfTheFileBecomeThePoints_data()
    {
        QTest::addColumn<int>("count");
        for (const int count : {2, 3, 40, 1000})
            QTest::addRow("%d points", count) << count;
    }
    void bodiesOfTheFileBecomeThePoints()
    {
        QFETCH(int, count);
        QByteArray links;
        for (int i = 0; i + 1 < count; ++i)
            links += (i ? ",{" : "{") + QByteArray("\"a\": \"p") + QByteArray::number(i) + "\", \"b\": \"p" +
                     QByteArray::number(i + 1) + "\", \"length\": 25}";
        const Experiment experiment = read(sticks(points(count) + ",\n\"links\": [" + links + "]"));
        const sim::Timeline run(experiment.script);
        QCOMPARE(run.state().pointCount(), count);
        for (int i = 0; i < count; ++i)
            QCOMPARE(run.state().positionOf(i).x, 100.0 + 30.0 * i);
        QCOMPARE(int(experiment.script.values.sticks->size()), count - 1);
        QCOMPARE(experiment.script.values.sticks->front().share, 0.5);
    }

    void filesSurviveARoundTrip_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("keys and a pointer")
            << file("walking_gait", "steering",
                    "\"input\": [{\"frame\": 1, \"event\": \"key\", \"key\": \"left\", \"down\": true}, "
                    "{\"frame\": 5, \"event\": \"key\", \"key\": \"left\", \"down\": false}, "
                    "{\"frame\": 7, \"event\": \"pointer\", \"x\": 10.5, \"y\": -3}]");
        QTest::newRow("wind and gusts")
            << file("swaying_tree", "turbulence",
                    "\"seed\": 7, \"input\": [{\"frame\": 1, \"event\": \"pointer\", \"x\": 81, \"y\": 260, "
                    "\"down\": true}, {\"frame\": 1, \"event\": \"gust\", \"degrees\": -2.25}]");
        QTest::newRow("targets in one frame")
            << file("codeling", "anticipation",
                    "\"input\": [{\"frame\": 3, \"event\": \"target\", \"x\": 1, \"y\": 2}, "
                    "{\"frame\": 3, \"event\": \"target\", \"x\": 3, \"y\": 4}]");
        QTest::newRow("points and sticks")
            << sticks(points(3) + ", \"links\": [{\"a\": \"p2\", \"b\": \"p0\", \"length\": 12.5, "
                                  "\"share\": 0.125}]");
        QTest::newRow("points without sticks") << sticks(points(3) + ", \"links\": []");
    }
    void filesSurviveARoundTrip()
    {
        QFETCH(QByteArray, text);
        static const LessonLibrary library = LessonLibrary::load({LESSON_DIR});
        const Experiment first = read(text);
        const Experiment second = read(experimentText(first, library));
        QVERIFY(first.script.input == second.script.input);
        QVERIFY(first.script.values == second.script.values);
        QVERIFY(first.script.bodies == second.script.bodies);
    }
};

SUITE(tst_experiment_outside, TestExperimentOutside)
#include "tst_experiment_outside.moc"
