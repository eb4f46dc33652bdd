// Reading, refusing and writing the field "scene" of an experiment.

#include "app/model/experiment/experiment.h"
#include "app/model/sandbox/blueprint_limits.h"
#include "sim/effects/all_effects.h"
#include "tests/app/experiment/experiment_support.h"
#include "tests/app/experiment/user_errors.h"
#include "tests/suite.h"

#include <QTest>

using namespace app;

namespace {

/// An experiment of the sandbox; `fields` begin on line 5.
QByteArray with(const QByteArray &fields)
{
    return "{\n\"format\": \"springstep-experiment/1\",\n\"lesson\": \"sandbox\",\n\"step\": \"build\",\n" +
           fields + "\n}\n";
}

/// A scene of two points; `more` begins on line 6.
QByteArray withPair(const QByteArray &more)
{
    return with("\"scene\": { \"bodies\": { \"a\": { \"x\": 1, \"y\": 2 }, \"b\": { \"x\": 3, \"y\": 4 } }" +
                (more.isEmpty() ? QByteArray() : ",\n" + more) + " }");
}

QByteArray manyPoints(std::size_t count)
{
    QByteArrayList points;
    for (std::size_t i = 0; i < count; ++i)
        points << "\"p" + QByteArray::number(qulonglong(i)) + "\": { \"x\": 0, \"y\": 0 }";
    return with("\"scene\": { \"bodies\": { " + points.join(", ") + " } }");
}

/// The effects that a scene can have, as error messages list them.
QByteArray offered()
{
    QByteArrayList ids;
    for (const sim::EffectDescription *one :
         experiment_support::library().sandboxes.front().steps.front().availableEffects)
        ids << '"' + QByteArray(one->id) + '"';
    return ids.join(", ");
}

sim::Blueprint readPlan(const QByteArray &text)
{
    return *parseExperiment(text, "x.json", experiment_support::library()).script.values.blueprint;
}

/// One of everything, with numbers that are hard to write.
sim::Blueprint everything()
{
    sim::Blueprint plan;
    plan.points = {{"p0", {0.1 + 0.2, -1e6}, {1.0 / 3.0, -2e-7}, 0.001, 1.0, false},
                   {"Head.of_9", {1e6, 2.5}, {}, 1e6, 1000.0, true},
                   {"foot", {7, 8}, {0, 1}, 2.5, 12.25, false}};
    plan.springs = {{0, 1, 0.7, 1.0 / 7.0}, {1, 0, 1e9, 0.0}};
    plan.sticks = {{2, 1, 33.3, 0.25}, {0, 2, 1e6, 0.5}};
    plan.gaits = {{0.3, 44, -3, 0.05, 1.5, false}, {}};
    plan.feet = {{2, 0, 359.5, 1}};
    plan.effects = {"breeze", "gravity"};
    return plan;
}

}

class BuiltScene : public QObject
{
    Q_OBJECT

private slots:
    void sceneSurvivesARoundTrip()
    {
        Experiment experiment = newExperiment("sandbox", "build", experiment_support::library());
        experiment.script.values.blueprint = std::make_shared<const sim::Blueprint>(everything());
        experiment.script.values.set("wind", -0.3);
        experiment.script.effectsOff = {"springs"};
        experiment.script.input = {{4, sim::Grab{"Head.of_9"}}, {9, sim::Release{}}};
        const QByteArray text = experimentText(experiment, experiment_support::library());
        const Experiment back = parseExperiment(text, "x.json", experiment_support::library());
        QVERIFY(*back.script.values.blueprint == everything());
        QVERIFY(back.script.values == experiment.script.values);
        QVERIFY(back.script.input == experiment.script.input);
        QVERIFY(back.script.effectsOff == experiment.script.effectsOff);
        QCOMPARE(experimentText(back, experiment_support::library()), text);
    }

    void missingFieldsHaveTheirDefaults()
    {
        const sim::Blueprint plan = readPlan(withPair(
            "\"springs\": [{ \"a\": \"b\", \"b\": \"a\", \"k\": 1, \"length\": 2 }], \"gaits\": [{}]"));
        QCOMPARE(plan.points[0].mass, 1.0);
        QCOMPARE(plan.points[0].size, 10.0);
        QVERIFY(!plan.points[0].fixed);
        QVERIFY(plan.springs == (std::vector<sim::BlueprintSpring>{{1, 0, 1.0, 2.0}}));
        QVERIFY(plan.gaits.front() == sim::BlueprintGait());
        QVERIFY(plan.effects.empty());
    }

    void aFileWithoutASceneHasTheFirstOne()
    {
        const sim::Blueprint plan = readPlan(with("\"frames\": 3"));
        QCOMPARE(plan.points.size(), std::size_t(2));
        QVERIFY(plan.points[0].fixed);
    }

    void startsOfBodiesAreBuiltIn()
    {
        const Experiment experiment = parseExperiment(
            withPair("\"effects\": [] }, \"bodies\": { \"b\": { \"x\": 9, \"y\": 8, \"vx\": 7 }"), "x.json",
            experiment_support::library());
        QVERIFY(experiment.script.bodies.empty());
        QVERIFY((experiment.script.values.blueprint->points[1].x == sim::Vec2{9, 8}));
        QVERIFY((experiment.script.values.blueprint->points[1].v == sim::Vec2{7, 0}));
    }

    void numberOfPointsIsLimited()
    {
        QCOMPARE(readPlan(manyPoints(built::mostPoints)).points.size(), built::mostPoints);
        QCOMPARE(user_errors::errorOf(manyPoints(built::mostPoints + 1)),
                 QString("x.json: line 5: \"bodies\" has 1001 entries; the most is 1000."));
    }

    void invalidScenesAreRefused_data()
    {
        user_errors::addColumns();
        const auto row = [](const char *name, const QByteArray &text, const char *sentence) {
            QTest::newRow(name) << text << QString::fromUtf8(sentence);
        };
        row("no object", with("\"scene\": 7"), "line 5: \"scene\" is 7; it must be an object in { }.");
        row("no bodies", with("\"scene\": { \"effects\": [] }"),
            "line 5: \"scene\" has no \"bodies\"; add it. It must be an object in { }.");
        row("empty", with("\"scene\": { \"bodies\": {} }"),
            "line 5: \"bodies\" is empty; a scene needs at least one body.");
        row("unknown field", withPair("\"ropes\": []"),
            "line 6: \"scene\" has no field \"ropes\"; there is \"bodies\", \"springs\", \"sticks\", "
            "\"feet\", "
            "\"gaits\", \"effects\", \"rule\", \"rule_links\".");
        row("bad name", with("\"scene\": { \"bodies\": { \"1 a\": { \"x\": 1, \"y\": 2 } } }"),
            "line 5: a body cannot be called \"1 a\"; a name is a letter, then up to 39 letters, digits, "
            "dots and _.");
        row("name twice", with("\"scene\": { \"bodies\": { \"a\": {}, \"a\": {} } }"),
            "line 5: \"a\" is given twice; keep one of them.");
        row("no place", with("\"scene\": { \"bodies\": { \"a\": { \"x\": 1 } } }"),
            "line 5: the body \"a\" has no \"y\"; add it. It must be a number.");
        row("no mass", with("\"scene\": { \"bodies\": { \"a\": { \"x\": 1, \"y\": 2, \"mass\": 0 } } }"),
            "line 5: \"mass\" is 0; it can be 0.001 to 1000000.");
        row("far", with("\"scene\": { \"bodies\": { \"a\": { \"x\": 1e7, \"y\": 2 } } }"),
            "line 5: \"x\" is 10000000; it can be -1000000 to 1000000.");
        row("not true", with("\"scene\": { \"bodies\": { \"a\": { \"x\": 1, \"y\": 2, \"fixed\": 1 } } }"),
            "line 5: \"fixed\" is 1; it must be true or false.");
        row("no such end", withPair("\"springs\": [{ \"a\": \"a\", \"b\": \"c\", \"k\": 1, \"length\": 2 }]"),
            "line 6: there is no body \"c\" in this scene; \"b\" must be the name of one of its \"bodies\".");
        row("one end", withPair("\"springs\": [{ \"a\": \"a\", \"b\": \"a\", \"k\": 1, \"length\": 2 }]"),
            "line 6: a spring has \"a\" at both ends; give it two bodies.");
        row("below 0", withPair("\"springs\": [{ \"a\": \"a\", \"b\": \"b\", \"k\": -1, \"length\": 2 }]"),
            "line 6: \"k\" is -1; it can be 0 to 1000000000.");
        row("no length", withPair("\"sticks\": [{ \"a\": \"a\", \"b\": \"b\" }]"),
            "line 6: a stick has no \"length\"; add it. It must be a number.");
        row("no list", withPair("\"sticks\": {}"),
            "line 6: \"sticks\" is an object; it must be a list in [ ].");
        row("no group", withPair("\"feet\": [{ \"foot\": \"a\", \"body\": \"b\" }]"),
            "line 6: a foot belongs to a gait group, and there is none; add \"gaits\": [{}].");
        row("no such group",
            withPair("\"gaits\": [{}], \"feet\": [{ \"foot\": \"a\", \"body\": \"b\", \"gait\": 1 }]"),
            "line 6: \"gait\" is 1; it can be a whole number from 0 to 0.");
        row("foot twice",
            withPair("\"gaits\": [{}], \"feet\": [{ \"foot\": \"a\", \"body\": \"b\" },\n{ \"foot\": \"a\", "
                     "\"body\": "
                     "\"b\" }]"),
            "line 7: \"a\" is a foot twice; it can be the foot of only one body.");
        row("fast clock", withPair("\"gaits\": [{ \"speed\": 11 }]"),
            "line 6: \"speed\" is 11; it can be -10 to 10.");
        row("unknown effect", withPair("\"effects\": [\"magic\"]"),
            "line 6: a scene cannot have the effect \"magic\"; it can have " + offered() +
                ". Its springs, sticks and feet need no effect.");
        row("effect twice", withPair("\"effects\": [\"gravity\", \"gravity\"]"),
            "line 6: the effect \"gravity\" is given twice; keep one.");
        row("nothing moves",
            with("\"scene\": { \"bodies\": { \"a\": { \"x\": 1, \"y\": 2, \"fixed\": true } } }"),
            "line 1: Nothing in this scene can move. Leave at least one body free.");
        row("links", withPair("\"effects\": []").replace("[] }", "[] }, \"links\": [{}]"),
            "line 6: the step \"build\" has its sticks in \"scene\"; move \"links\" there and call it "
            "\"sticks\".");
        row("a lesson's step",
            "{\n\"format\": \"springstep-experiment/1\",\n\"lesson\": \"multi_foot\",\n\"step\": "
            "\"any_number\",\n"
            "\"scene\": {} }",
            "line 5: \"scene\" does not go with a lesson's step, which has its own; remove it, and change "
            "that one "
            "by \"parameters\", \"bodies\" and \"effects\".");
    }
    void invalidScenesAreRefused() { user_errors::checkRow(); }
};

SUITE(tst_built_scene, BuiltScene)
#include "tst_built_scene.moc"
