#include "lessons/api/checks/condition.h"

#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/run_queries.h"
#include "sim/run/timeline.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace lessons {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Conditions)
};

/// Returns `text` with the required value in place of %2.
QString withRequired(QString text, double required)
{
    return text.replace(QStringLiteral("%2"), QLocale().toString(required, 'g', 6));
}

/// Returns the speed at which the last drag released its body, in px/frame. It is 0 during a drag.
double releaseSpeed(const sim::Timeline &run)
{
    const std::optional<DragGesture> drag = lastReleased(run);
    return drag ? sim::length(drag->releaseVelocity()) : 0.0;
}

/// Returns the largest distance of the last drag from where its body was, in px.
double lastDragDistance(const sim::Timeline &run)
{
    const std::vector<DragGesture> all = dragGestures(run);
    if (all.empty() || all.back().path.empty())
        return 0.0;
    const sim::Vec2 from = grabPosition(run, all.back());
    double farthest = 0.0;
    for (const PointerSample &sample : all.back().path)
        farthest = std::max(farthest, sim::length(sample.position - from));
    return farthest;
}

}

bool Conditions::hold(const sim::Timeline &run) const
{
    return std::all_of(m_all.begin(), m_all.end(),
                       [&](const Condition &condition) { return condition.holds(run); });
}

bool Conditions::hasBegun(const sim::Timeline &run) const
{
    return !m_all.empty() && m_all.front().holds(run);
}

QString Conditions::todo(const sim::Timeline &run) const
{
    if (!hasBegun(run))
        return {};
    const auto missing = std::find_if(m_all.begin(), m_all.end(),
                                      [&](const Condition &condition) { return !condition.holds(run); });
    if (missing == m_all.end())
        return {};
    QString todo = missing->todo;
    if (missing->measured) {
        const double number = missing->measured(run);
        QLocale locale;
        locale.setNumberOptions(QLocale::OmitGroupSeparator);
        const QString formatted = locale.toString(number, 'f', missing->decimals);
        todo.replace(QStringLiteral("%1"),
                     std::isfinite(number) ? QString(formatted).replace(u'-', u'−') : QStringLiteral("–"));
    }
    return todo;
}

Condition released(const std::string &body)
{
    return {[body](const sim::Timeline &run) { return lastReleased(run, body).has_value(); },
            Text::tr("take it with the mouse, and let go of it.")};
}

Condition releasedSinceSet(const std::string &id, const std::string &body)
{
    Condition condition = released(body);
    condition.holds = [id, body](const sim::Timeline &run) {
        const std::optional<DragGesture> drag = lastReleased(run, body);
        const std::int64_t set = lastSetFrame(run, id);
        return drag && (drag->grabFrame >= set || *drag->releaseFrame > set);
    };
    return condition;
}

Condition thrownAtLeast(double minSpeed)
{
    return atLeast(
        minSpeed, releaseSpeed,
        withRequired(Text::tr("let go while the mouse moves, at %2 px per frame or more. Yours left at %1."),
                     minSpeed));
}

Condition lastGrabbed(const std::string &body)
{
    return {[body](const sim::Timeline &run) {
                const std::vector<DragGesture> all = dragGestures(run);
                return !all.empty() && all.back().body == body;
            },
            Text::tr("take it with the mouse.")};
}

Condition holding(const std::string &body)
{
    return {[body](const sim::Timeline &run) { return heldBody(run) == body; },
            Text::tr("take it with the mouse, and hold it.")};
}

Condition draggedAtLeast(double minDistance)
{
    return atLeast(minDistance, lastDragDistance,
                   withRequired(Text::tr("carry it %2 px or more. It came %1 px."), minDistance), 0);
}

Condition allStill()
{
    return {isStill, Text::tr("let time run (**Space**) until nothing moves.")};
}

Condition idleFor(std::int64_t frames)
{
    return atLeast(
        static_cast<double>(frames),
        [](const sim::Timeline &run) {
            return run.cursor().phase > 0 ? 0.0 : static_cast<double>(idleFrames(run));
        },
        withRequired(Text::tr("hands off, and let time run for %2 frames. So far: %1."),
                     static_cast<double>(frames)),
        0);
}

Condition unchangedFor(const std::string &id, std::int64_t frames)
{
    return atLeast(
        static_cast<double>(frames),
        [id](const sim::Timeline &run) { return static_cast<double>(framesSinceSet(run, id)); },
        withRequired(Text::tr("let time run for %2 frames with this value. So far: %1."),
                     static_cast<double>(frames)),
        0);
}

Condition playedTo(std::int64_t frame)
{
    return {
        [frame](const sim::Timeline &run) { return run.cursor().phase == 0 && run.cursor().frame >= frame; },
        withRequired(Text::tr("go on to frame %2. This is frame %1."), static_cast<double>(frame)),
        [](const sim::Timeline &run) { return static_cast<double>(run.cursor().frame); }, 0};
}

Condition parameterSetTo(const std::string &id, double value, const QString &todo)
{
    return {[id, value](const sim::Timeline &run) { return isSetTo(run, id, value); }, todo};
}

Condition runsMethod(const std::string &id, const QString &todo)
{
    return {[id](const sim::Timeline &run) { return usesMethod(run, id); }, todo};
}

Condition stepIs(double h, const QString &todo)
{
    return {[h](const sim::Timeline &run) {
                const sim::StepSize &step = run.script().step;
                return !step.isAdaptive() && step.h == h;
            },
            todo};
}

Condition insideFrame()
{
    return {[](const sim::Timeline &run) { return run.cursor().phase > 0; },
            Text::tr("stop, show the page **Engine** of the code, and go into a frame: **Shift+→**.")};
}

Condition onlyPulled()
{
    return {onlySpringsPulled,
            Text::tr("press **Shift+→** or **Shift+←** until a spring has pulled and nothing has moved.")};
}

Condition comparisonDiffers(const std::string &id)
{
    return {[id](const sim::Timeline &run) { return differsFromComparison(run, id); }};
}

Condition playedSinceFork()
{
    return atLeast(
        10.0,
        [](const sim::Timeline &run) { return static_cast<double>(run.cursor().frame - run.forkFrame()); },
        Text::tr("play on for 10 frames from where the two part. So far: %1."), 0);
}

Condition atLeast(double min, std::function<double(const sim::Timeline &)> measured, const QString &todo,
                  int decimals)
{
    return {[measured, min](const sim::Timeline &run) { return measured(run) >= min; }, todo, measured,
            decimals};
}

Condition atMost(double max, std::function<double(const sim::Timeline &)> measured, const QString &todo,
                 int decimals)
{
    return {[measured, max](const sim::Timeline &run) { return measured(run) <= max; }, todo, measured,
            decimals};
}

}
