#pragma once

#include "tests/app/support/window_fixture.h"

#include "app/ui/code/engine/code_panel.h"
#include "app/ui/code/engine/code_view.h"
#include "app/ui/energy/energy_panel.h"
#include "app/ui/energy/energy_plot.h"
#include "app/ui/plots/plot_card.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/time/frame_counter.h"
#include "app/ui/time/timeline_strip.h"

#include <QAccessible>
#include <QLabel>
#include <QStatusBar>
#include <QtTest>

/// Shared by the suites about previews: the window on a run, and a mouse that hovers.
namespace cursor_support {

using namespace app;

inline constexpr std::int64_t currentFrame = 60;

/// The whole window on a run of 80 frames that stands at frame 60.
struct CursorFixture : tests::WindowFixture
{
    explicit CursorFixture(const char *lesson = "multi_foot", const char *step = "two_feet",
                           StudyFunction study = tests::noStudy)
        : WindowFixture({.lesson = lesson, .step = step, .size = {1600, 900}, .study = std::move(study)})
    {
        window.docks().show(Panel::energy, true);
        goTo(80);
        goTo(currentFrame);
        settle();
        park();
    }
    /// Waits until plots and energy have all frames of the run.
    void settle()
    {
        QVERIFY(QTest::qWaitFor(
            [&] { return window.plots().isSettled() && energy.series().last() >= currentFrame; }));
        QCoreApplication::processEvents();
    }
    void hover(QWidget &widget, QPointF place) { QTest::mouseMove(&widget, place.toPoint()); }
    /// Moves the mouse to an empty place.
    void park()
    {
        QTest::mouseMove(window.statusBar(), {3, 3});
        QCoreApplication::processEvents();
    }
    QPointF onPlot(double frame) { return {plot().xAxis->coordToPixel(frame), plot().height() / 2.0}; }
    QPointF onEnergy(double frame)
    {
        return {energy.plot().xAxis->coordToPixel(frame), energy.plot().height() / 2.0};
    }
    QPointF onTrack(std::int64_t frame) { return {timeline.axis().xOf(frame), 25.0}; }
    QPointF onPhase(int phase)
    {
        for (int x = 0; x < timeline.width(); ++x) {
            if (timeline.phases().phaseAt({double(x), TimelinePlaces::strip + 14.0}) == phase)
                return {x + 8.0, TimelinePlaces::strip + 14.0};
        }
        qFatal("there is no phase %d", phase);
    }
    /// Scrolls to a line and returns its place.
    QPointF onCode(const QString &part)
    {
        CodeView &lines = code.view();
        for (std::size_t row = 0; row < lines.rows().size(); ++row) {
            if (lines.rows()[row].kind != CodeRow::Kind::code || !lines.rows()[row].text.contains(part))
                continue;
            lines.ensureLineVisible(static_cast<int>(row));
            return lines.rowRect(row).center();
        }
        qFatal("no line says %s", qPrintable(part));
    }
    QuantityPlot &plot() { return window.plots().cards().front()->plot(); }
    QPointF places(std::int64_t frame, const char *body)
    {
        sim::Track track(session.timeline().script(), 0);
        track.seek({frame, 0});
        const sim::Vec2 at = track.state().positionOf(track.interval().scene.find(body));
        return {at.x, at.y};
    }
    QPointF shown(const char *body)
    {
        const Picture &picture = view.shown().picture;
        const sim::Vec2 at = picture.state.positionOf(picture.interval->scene.find(body));
        return {at.x, at.y};
    }
    QString status() { return window.statusBar()->findChild<QLabel *>()->text(); }
    QString spoken(QWidget &widget, QAccessible::Text kind)
    {
        return QAccessible::queryAccessibleInterface(&widget)->text(kind);
    }

    EnergyPanel &energy = *window.findChild<EnergyPanel *>();
    TimelineStrip &timeline = *window.findChild<TimelineStrip *>();
    CodePanel &code = *window.findChild<CodePanel *>();
    FrameCounter &counter = *window.findChild<FrameCounter *>();
};

}
