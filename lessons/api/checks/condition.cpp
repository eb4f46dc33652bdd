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

struct ConditionText
{
    Q_DECLARE_TR_FUNCTIONS(Conditions)
};

/// Returns `text` with the required value in place of %2.
QString withRequired(QString text, double required)
{
    return text.replace(QStringLiteral("%2"), QLocale().toString(required, 'g', 6));
}

/// Returns `condition` with a sentence of its own.
Condition saying(const QString &todo, Condition condition)
{
    condition.todo = todo;
    return condition;
}

/// Returns `condition`, which can hold inside a frame only.
Condition inPhases(Condition condition)
{
    condition.insideFrame = true;
    return condition;
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

QString Condition::number(const sim::Timeline &run) const
{
    const double value = measured(run);
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const QString formatted = locale.toString(value, 'f', decimals);
    return std::isfinite(value) ? QString(formatted).replace(u'-', u'−') : QStringLiteral("–");
}

bool Conditions::hold(const sim::Timeline &run) const
{
    return std::all_of(m_all.begin(), m_all.end(),
                       [&](const Condition &condition) { return condition.holds(run); });
}

QStringList Conditions::sentences() const
{
    QStringList names;
    for (const Condition &condition : m_all) {
        if (!condition.sentence.isEmpty() && !names.contains(condition.sentence))
            names << condition.sentence;
    }
    return names;
}

Conditions Conditions::with(const QMap<QString, QString> &sentences) const
{
    Conditions result = *this;
    for (Condition &condition : result.m_all) {
        if (!condition.sentence.isEmpty())
            condition.todo = sentences.value(condition.sentence);
    }
    return result;
}

bool Conditions::hasBegun(const sim::Timeline &run) const
{
    return !m_all.empty() && m_all.front().holds(run);
}

const Condition *Conditions::missing(const sim::Timeline &run) const
{
    const auto failing = std::find_if(m_all.begin(), m_all.end(),
                                      [&](const Condition &condition) { return !condition.holds(run); });
    return failing == m_all.end() || !hasBegun(run) ? nullptr : &*failing;
}

bool Conditions::waitsForPhase(const sim::Timeline &run) const
{
    return std::any_of(m_all.begin(), m_all.end(), [&](const Condition &condition) {
        return condition.insideFrame && !condition.holds(run);
    });
}

bool Conditions::waitsForStep(const sim::Timeline &run) const
{
    return std::any_of(m_all.begin(), m_all.end(), [&](const Condition &condition) {
        return condition.otherSteps && !condition.holds(run);
    });
}

QString Conditions::todo(const sim::Timeline &run) const
{
    const Condition *condition = missing(run);
    if (!condition)
        return {};
    QString todo = condition->todo;
    return condition->measured ? todo.replace(QStringLiteral("%1"), condition->number(run)) : todo;
}

Condition released(const std::string &body)
{
    return saying(ConditionText::tr("take it with the mouse, and let go of it."),
                  {[body](const sim::Timeline &run) { return lastReleased(run, body).has_value(); }});
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
    return saying(
        withRequired(
            ConditionText::tr("let go while the mouse moves, at %2 px per frame or more. You let go at %1."),
            minSpeed),
        atLeast(minSpeed, releaseSpeed));
}

Condition lastGrabbed(const std::string &body)
{
    return saying(ConditionText::tr("take it with the mouse."), {[body](const sim::Timeline &run) {
                      const std::vector<DragGesture> all = dragGestures(run);
                      return !all.empty() && all.back().body == body;
                  }});
}

Condition holding(const std::string &body)
{
    return saying(ConditionText::tr("take it with the mouse, and hold it."),
                  {[body](const sim::Timeline &run) { return heldBody(run) == body; }});
}

Condition draggedAtLeast(double minDistance)
{
    return saying(withRequired(ConditionText::tr("carry it %2 px or more. It came %1 px."), minDistance),
                  atLeast(minDistance, lastDragDistance, {}, 0));
}

Condition allStill()
{
    return saying(ConditionText::tr("let time run (**Space**) until nothing moves."), {isStill});
}

Condition idleFor(std::int64_t frames)
{
    const auto idle = [](const sim::Timeline &run) {
        return run.cursor().phase > 0 ? 0.0 : static_cast<double>(idleFrames(run));
    };
    const auto required = static_cast<double>(frames);
    return saying(
        withRequired(ConditionText::tr("hands off, and let time run for %2 frames. So far: %1."), required),
        atLeast(required, idle, {}, 0));
}

Condition unchangedFor(const std::string &id, std::int64_t frames)
{
    const auto since = [id](const sim::Timeline &run) {
        return static_cast<double>(framesSinceSet(run, id));
    };
    const auto required = static_cast<double>(frames);
    return saying(
        withRequired(ConditionText::tr("let time run for %2 frames with this value. So far: %1."), required),
        atLeast(required, since, {}, 0));
}

Condition playedTo(std::int64_t frame)
{
    return saying(
        withRequired(ConditionText::tr("go on to frame %2. This is frame %1."), static_cast<double>(frame)),
        {[frame](const sim::Timeline &run) { return run.cursor().phase == 0 && run.cursor().frame >= frame; },
         {},
         [](const sim::Timeline &run) { return static_cast<double>(run.cursor().frame); },
         0});
}

Condition parameterSetTo(const std::string &id, double value, const QString &sentence)
{
    return {[id, value](const sim::Timeline &run) { return isSetTo(run, id, value); }, sentence};
}

Condition runsMethod(const std::string &id, const QString &sentence)
{
    return {[id](const sim::Timeline &run) { return usesMethod(run, id); }, sentence};
}

Condition stepIs(double h, const QString &sentence)
{
    Condition condition{[h](const sim::Timeline &run) {
                            const sim::StepSize &step = run.script().step;
                            return !step.isAdaptive() && step.h == h;
                        },
                        sentence};
    condition.otherSteps = h != 1.0;
    return condition;
}

Condition insideFrame()
{
    return inPhases(saying(
        ConditionText::tr("stop, show the page **Engine** of the code, and go into a frame: **Shift+→**."),
        {[](const sim::Timeline &run) { return run.cursor().phase > 0; }}));
}

Condition onlyPulled()
{
    return inPhases(
        saying(ConditionText::tr(
                   "press **Shift+→** or **Shift+←** until a spring has pulled and nothing has moved."),
               {onlySpringsPulled}));
}

Condition comparisonDiffers(const std::string &id)
{
    return {[id](const sim::Timeline &run) { return differsFromComparison(run, id); }};
}

Condition playedSinceFork()
{
    const auto since = [](const sim::Timeline &run) {
        return static_cast<double>(run.cursor().frame - run.forkFrame());
    };
    return saying(ConditionText::tr("play on for 10 frames from where the two part. So far: %1."),
                  atLeast(10.0, since, {}, 0));
}

Condition atLeast(double min, std::function<double(const sim::Timeline &)> measured, const QString &sentence,
                  int decimals)
{
    return {[measured, min](const sim::Timeline &run) { return measured(run) >= min; }, sentence, measured,
            decimals};
}

Condition atMost(double max, std::function<double(const sim::Timeline &)> measured, const QString &sentence,
                 int decimals)
{
    return {[measured, max](const sim::Timeline &run) { return measured(run) <= max; }, sentence, measured,
            decimals};
}

}
