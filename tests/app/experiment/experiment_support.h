#pragma once

#include "app/model/experiment/experiment.h"
#include "sim/pipeline/method.h"
#include "sim/scene/scene.h"
#include "tests/app/support/files.h"

#include <QTest>

#include <limits>

/// Shared by the suites of experiment files.
namespace experiment_support {

using namespace app;
using tests::contentsOf;

inline const LessonLibrary &library()
{
    static const LessonLibrary loaded = LessonLibrary::load({LESSON_DIR});
    return loaded;
}

/// Fails unless the two run alike.
inline void compareExperiments(const Experiment &a, const Experiment &b)
{
    QCOMPARE(a.lesson, b.lesson);
    QCOMPARE(a.step, b.step);
    QCOMPARE(a.frames, b.frames);
    QVERIFY(a.script.values == b.script.values);
    QVERIFY(a.script.bodies == b.script.bodies);
    QVERIFY(a.script.effectsOff == b.script.effectsOff);
    QCOMPARE(a.script.method->id(), b.script.method->id());
    QVERIFY(a.script.step == b.script.step);
    QVERIFY(a.script.input == b.script.input);
    QVERIFY(sameMarked(a.branches, b.branches));
    for (std::size_t i = 0; i < a.branches.all().size(); ++i)
        QCOMPARE(a.branches.all()[i].end, b.branches.all()[i].end);
}

inline void compareAfterRoundTrip(const Experiment &experiment)
{
    const QByteArray text = experimentText(experiment, library());
    const Experiment back = parseExperiment(text, "x.json", library());
    compareExperiments(back, experiment);
    QCOMPARE(experimentText(back, library()), text);
}

/// Feet, with one of everything that a file can have.
inline Experiment everything()
{
    Experiment experiment = newExperiment("multi_foot", "any_number", library());
    sim::Script &script = experiment.script;
    experiment.frames = mostFrames;
    script.method = newExperiment("multi_foot", "any_number", library()).script.method;
    script.step = sim::StepSize::ofLength(1.0 / 3.0);
    script.values.set("k", 0.1 + 0.2);
    script.values.set("feet", 7.0);
    script.values.seed = std::uint64_t{1} << 53;
    script.bodies["foot6"] = {{1.0 / 3.0, -0.0}, sim::Vec2{std::numeric_limits<double>::denorm_min(), -1e22}};
    script.bodies["body"] = {{std::numeric_limits<double>::max(), 123456789012345678.0}, {}};
    script.effectsOff = {script.build(script.values).effects.front()->id()};
    script.input = {{0, sim::Grab{"foot0"}},         {0, sim::Move{{-1.5, 2e-7}}}, {3, sim::Grab{"body"}},
                    {4, sim::Set{"damp", 0.95}},     {4, sim::Set{"feet", 9.0}},   {5, sim::Release{}},
                    {10'000'000, sim::Grab{"foot8"}}};
    return experiment;
}

inline Branch branchOf(const QString &name, bool isNamed, bool isKept, sim::Script script)
{
    return {1, name, isNamed, isKept, 77, std::make_shared<const sim::Script>(std::move(script))};
}

/// Returns the same with three branches. One shares its first frames. Two have other parameters and share nothing.
inline Experiment withBranches(double h = 1.0 / 3.0)
{
    Experiment experiment = everything();
    experiment.script.step = sim::StepSize::ofLength(h);
    sim::Script forked = experiment.script;
    forked.input.resize(6);
    forked.input.push_back({8, sim::Grab{"foot1"}});
    forked.input.push_back({8, sim::Move{{0.1 + 0.2, 1e-300}}});
    sim::Script other = experiment.script;
    other.values.set("k", 1.0 / 3.0);
    other.effectsOff.clear();
    sim::Script untouched = newExperiment("multi_foot", "any_number", library()).script;
    experiment.branches.add(branchOf("softer “here”", true, false, forked));
    experiment.branches.add(branchOf("before: k 0.2", false, true, other));
    experiment.branches.add(branchOf("as published", true, true, untouched));
    experiment.branches.setOwn({"mine", "mine", true, 0});
    return experiment;
}

/// A file with one branch, whose fields begin on line 6.
inline QByteArray withBranch(const QByteArray &fields)
{
    return "{\n\"format\": \"springstep-experiment/1\",\n\"lesson\": \"multi_foot\", \"step\": "
           "\"any_number\",\n"
           "\"input\": [{\"frame\": 4, \"event\": \"grab\", \"body\": \"body\"}],\n\"branches\": [{\n" +
           fields + "\n}]}";
}

}
