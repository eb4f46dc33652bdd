#pragma once

#include "app/model/analysis/accuracy_study.h"
#include "app/ui/accuracy/accuracy_panel.h"
#include "app/ui/accuracy/work_precision_plot.h"
#include "tests/app/support/panel_fixture.h"

#include <QTest>

#include <atomic>

/// Shared by the suites of the panel of accuracy.
namespace accuracy_support {

/// Returns the results of a made-up study. A method of order p has an error of h^p px times a constant and a cost of
/// 1/h times another constant, so every answer is known. `published` is unstable at its first level.
sim::Accuracy madeUp(const sim::Script &script, const sim::StudyPlan &plan);

/// A study that returns these results at once.
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
    /// Returns the position of the mark of `method` at `step`; fails the test if there is none.
    QPoint spotOf(const std::string &method, sim::StepSize step);
    std::string method() const { return world.session.timeline().script().method->id(); }
    sim::StepSize step() const { return world.session.timeline().script().step; }

    Puppet puppet;
    tests::SessionFixture world;
    app::AccuracyStudy study{world.session.run(), world.session.editor(), puppet.function()};
    app::AccuracyPanel panel{study, world.session.preview(), world.theme};
};

}
