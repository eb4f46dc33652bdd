#pragma once

#include "app/model/analysis/accuracy_study.h"
#include "app/ui/accuracy/accuracy_panel.h"
#include "app/ui/accuracy/work_precision_plot.h"
#include "tests/app/support/panel_fixture.h"

#include <QTest>

#include <atomic>

/// Shared by the suites of the panel of accuracy.
namespace accuracy_support {

/// What a made-up study finds: a rung of a method of order p is off by h^p px times a constant and costs 1/h times
/// another one, so that every answer can be told by hand. `published` is unstable at its first rung.
sim::Accuracy madeUp(const sim::Script &script, const sim::StudyPlan &plan);

/// A study that finds that, at once.
app::StudyFunction madeUpAtOnce();

/// A study that is told when to go on. It may be asked from any thread.
struct Puppet
{
    std::atomic<int> begun = 0;
    std::atomic<int> stopped = 0;   ///< those that were told to
    std::atomic<bool> held = false; ///< while set, a study reports again and again, and does not end

    app::StudyFunction function();
};

/// The panel of accuracy on two small lessons, with a made-up study.
struct AccuracyFixture
{
    AccuracyFixture();

    app::WorkPrecisionPlot &plot() { return panel.workPrecision(); }
    /// Waits until a study has ended.
    bool measured();
    /// Where the row of `method` at `step` is drawn; fails the test where it is not.
    QPoint spotOf(const std::string &method, sim::StepSize step);
    std::string method() const { return world.session.timeline().script().method->id(); }
    sim::StepSize step() const { return world.session.timeline().script().step; }

    Puppet puppet;
    tests::SessionFixture world;
    app::AccuracyStudy study{world.session.run(), world.session.editor(), puppet.function()};
    app::AccuracyPanel panel{study, world.session.preview(), world.theme};
};

}
