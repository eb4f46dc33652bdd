#include "sim/base/error.h"
#include "sim/effects/tree/joints.h"
#include "sim/run/finite.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"
#include "tests/lessons/support/support.h"
#include "tests/suite.h"

#include <QTest>

using namespace support;

/// The growth of the tree in the lesson `swaying_tree`, and the state that a run keeps when the tree changes.
class TreeGrowth : public QObject
{
    Q_OBJECT

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("swaying_tree"));

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }

    sim::Script pressed(const char *id, sim::Vec2 at, const Changes &changes = {}) const
    {
        sim::Script script = scriptOf(step(id), "published", 1.0, changes);
        script.input = {{1, sim::Pointer{at, true}}};
        return script;
    }

private slots:
    void numberOfBranches_data();
    void numberOfBranches();
    void unboundedTreesAreRejected_data();
    void unboundedTreesAreRejected();
    void changedTreeKeepsItsBends();
    void changedTreeStaysTogether_data();
    void changedTreeStaysTogether();
    void seedDeterminesTreeAndGusts();
    void presetsGrowDifferentTrees();
};

void TreeGrowth::numberOfBranches_data()
{
    QTest::addColumn<double>("slope");
    QTest::addColumn<double>("minScale");
    QTest::addColumn<int>("branches");
    QTest::newRow("as published") << 0.8 << 0.2 << 255;
    QTest::newRow("only a trunk") << 0.8 << 0.9 << 1;
    QTest::newRow("a scale equal to the limit does not grow") << 0.5 << 0.25 << 3;
    QTest::newRow("17 levels") << 0.9 << 0.18 << 131'071;
}

void TreeGrowth::numberOfBranches()
{
    QFETCH(double, slope);
    QFETCH(double, minScale);
    QFETCH(int, branches);
    for (const char *id : {"branches", "turbulence", "real_sway"}) {
        sim::Script script = step(id).script();
        script.values.set("slope", slope);
        script.values.set("min_scale", minScale);
        const sim::State after = stateAfter(script, 2);
        QCOMPARE(after.pointCount(), branches);
        QCOMPARE(sim::firstNonFinitePoint(after), -1);
    }
}

void TreeGrowth::unboundedTreesAreRejected_data()
{
    QTest::addColumn<double>("slope");
    QTest::addColumn<double>("minScale");
    QTest::newRow("18 levels") << 0.9 << 0.16;
    QTest::newRow("all branches equal") << 1.0 << 0.2;
    QTest::newRow("growing branches") << 2.0 << 0.2;
    QTest::newRow("no smallest branch") << 0.8 << 0.0;
    QTest::newRow("a tiny smallest branch") << 0.8 << 1e-300;
}

void TreeGrowth::unboundedTreesAreRejected()
{
    QFETCH(double, slope);
    QFETCH(double, minScale);
    int tried = 0;
    for (const lessons::Step &each : m_lesson.steps) {
        if (!each.parameter(QStringLiteral("slope")))
            continue;
        ++tried;
        sim::Timeline run(each.script());
        run.seek({3, 0});
        try {
            run.setParameter("min_scale", minScale);
            run.setParameter("slope", slope);
            QFAIL("no error was thrown");
        } catch (const sim::Error &error) {
            QCOMPARE(error.id(), std::string("tree-too-big"));
            QCOMPARE(error.values().at("most"), std::string("131071"));
        }
        run.seek({5, 0}); // the run continues
        QCOMPARE(run.cursor().frame, 5);
    }
    QVERIFY(tried >= 5);
}

void TreeGrowth::changedTreeKeepsItsBends()
{
    sim::Timeline run(pressed("wind", {60, 200}));
    run.seek({30, 0});
    run.applyInput(sim::Pointer{{60, 200}, false});
    run.seek({31, 0});
    const sim::State before = run.state();
    const Eigen::ArrayXd bends = before.angle - run.track().interval().scene.start.angle;
    run.setParameter("spread", 50.0);
    run.seek({40, 0});
    const Eigen::ArrayXd after = run.state().angle - run.track().interval().scene.start.angle;
    QVERIFY(((bends - after).abs() < 1e-9).all());
    QVERIFY(largestDistance(before, run.state()) > 20.0);
}

void TreeGrowth::changedTreeStaysTogether_data()
{
    QTest::addColumn<QString>("id");
    QTest::addColumn<QString>("parameter");
    QTest::addColumn<double>("value");
    for (const char *id : {"branches", "towards_pointer", "rest", "turbulence", "real_sway"}) {
        QTest::addRow("%s, another spread", id) << id << "spread" << 50.0;
        QTest::addRow("%s, another trunk", id) << id << "base_length" << 60.0;
        QTest::addRow("%s, other sizes", id) << id << "slope" << 0.7;
        QTest::addRow("%s, more branches", id) << id << "min_scale" << 0.15;
    }
}

void TreeGrowth::changedTreeStaysTogether()
{
    QFETCH(QString, id);
    QFETCH(QString, parameter);
    QFETCH(double, value);
    sim::Timeline run(pressed(qPrintable(id), {60, 200}));
    run.seek({30, 0});
    run.setParameter(parameter.toStdString(), value);
    std::shared_ptr<const sim::ComposedInterval> interval;
    const sim::State state = run.track().preview(interval); // as the window draws it until the next frame
    const sim::Joints *joints = nullptr;
    for (const sim::EffectPtr &effect : interval->scene.effects) {
        if (const auto *found = dynamic_cast<const sim::Joints *>(effect.get()))
            joints = found;
    }
    QVERIFY(joints);
    QVERIFY(state.pointCount() > 3);
    const sim::Tree &tree = joints->tree();
    for (int i = 1; i < state.pointCount(); ++i) {
        const int parent = tree.parent[static_cast<std::size_t>(i)];
        const sim::Vec2 gap = state.positionOf(i) - sim::endOf(tree, state, parent, joints->degrees());
        QVERIFY2(sim::length(gap) < 1e-9,
                 qPrintable(QStringLiteral("branch %1: %2 px").arg(i).arg(sim::length(gap))));
    }
}

void TreeGrowth::seedDeterminesTreeAndGusts()
{
    const auto runWith = [&](std::uint64_t seed, double jitter) {
        sim::Script script = pressed("turbulence", {60, 200}, {{"jitter", jitter}});
        script.values.seed = seed;
        return stateAfter(script, 50);
    };
    QVERIFY(sim::sameBits(runWith(3, 10.0), runWith(3, 10.0)));
    QVERIFY(largestDistance(runWith(3, 10.0), runWith(4, 10.0)) > 1.0);
    QVERIFY(largestDistance(runWith(3, 0.0), runWith(4, 0.0)) > 0.01); // the same tree, other gusts
}

void TreeGrowth::presetsGrowDifferentTrees()
{
    for (const char *id : {"randomness", "turbulence", "real_sway"}) {
        const lessons::Step &lessonStep = step(id);
        QVERIFY(lessonStep.presets.size() >= 5);
        QStringList titles;
        std::vector<sim::State> trees = {lessonStep.scene(lessonStep.defaultValues()).start};
        for (const lessons::Preset &preset : lessonStep.presets) {
            QVERIFY(!preset.title.isEmpty() && preset.help.endsWith(u'.'));
            titles << preset.title;
            sim::Values values = lessonStep.defaultValues();
            for (const auto &[name, value] : preset.values) {
                const lessons::Parameter *parameter = lessonStep.parameter(name);
                QVERIFY(parameter && value >= parameter->min && value <= parameter->max);
                values.set(name.toStdString(), value);
            }
            trees.push_back(lessonStep.scene(values).start);
            for (std::size_t i = 0; i + 1 < trees.size(); ++i)
                QVERIFY(trees[i].pointCount() != trees.back().pointCount() ||
                        largestDistance(trees[i], trees.back()) > 20.0);
        }
        titles.removeDuplicates();
        QCOMPARE(titles.size(), static_cast<qsizetype>(lessonStep.presets.size()));
    }
}

SUITE(tst_tree_growth, TreeGrowth)
#include "tst_tree_growth.moc"
