// The overlays of a step that are drawn.

#include "app/model/picture/overlays.h"
#include "lessons/api/view/view.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"

#include "app/model/experiment/experiment.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>

using namespace app;

class TestOverlays : public QObject
{
    Q_OBJECT

    const LessonLibrary m_library = LessonLibrary::load({LESSON_DIR});

    /// What is drawn of a foot on a spring that stands at `x`, and how many guides its step has for that.
    void overlaysAt(double x, std::size_t &drawn, std::size_t &all) const
    {
        Experiment experiment = newExperiment("single_spring", "drag", m_library);
        experiment.script.values.set("k", 1.5);
        experiment.script.bodies["foot"] = {{x, 100.0}, {}};
        const lessons::Step *step = m_library.lesson("single_spring")->step("drag");
        const sim::Track run(experiment.script, 0);
        const sim::ComposedInterval &interval = run.interval();
        all = step->overlays(interval.scene, run.state(), interval.values).size();
        const std::vector<lessons::Overlay> overlays = overlaysOf(*step, run, interval, run.state());
        for (const lessons::Overlay &overlay : overlays) {
            for (const double number : {overlay.a.x, overlay.a.y, overlay.b.x, overlay.b.y, overlay.size})
                QVERIFY(std::isfinite(number));
        }
        drawn = overlays.size();
    }

private slots:
    void allAreDrawnWhereTheyAreNumbers()
    {
        std::size_t drawn = 0, all = 0;
        overlaysAt(300.0, drawn, all);
        QVERIFY(all > 0);
        QCOMPARE(drawn, all);
    }

    void aPullThatIsNoNumberIsNotDrawn()
    {
        std::size_t drawn = 0, all = 0;
        overlaysAt(1.7e308, drawn, all);
        QCOMPARE(drawn + 1, all); // the centre is still there
    }
};

SUITE(tst_overlays, TestOverlays)
#include "tst_overlays.moc"
