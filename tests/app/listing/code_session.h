#pragma once

#include "app/model/listing/line_values.h"
#include "app/model/session/session.h"
#include "sim/run/script/script.h"

#include <QTest>

/// Shared by the suites of the learner's code.
namespace code_session {

/// A session in which a step of the real lessons is open.
struct Opened
{
    Opened(const QString &lesson, const QString &step)
    {
        session.openStep(lesson, step);
        if (session.step().id != step)
            qFatal("there is no step %s", qPrintable(step));
    }

    const QString &listing() const { return session.step().listing.text; }
    /// Goes to a frame, and waits until the run is there.
    void goTo(std::int64_t frame)
    {
        session.playback().goTo({frame, 0});
        waitUntilThere();
    }
    void waitUntilThere() { QTRY_VERIFY(!session.playback().goal()); }
    /// Returns the text with `from`, which it has, replaced by `to`.
    static QString with(QString text, const QString &from, const QString &to)
    {
        if (!text.contains(from))
            qFatal("the text has no %s", qPrintable(from));
        return text.replace(from, to);
    }
    /// Returns the line of the learner's text that has `code`, from 1.
    int lineOf(const QString &code) const
    {
        const QStringList lines = session.code().text().split('\n');
        for (int i = 0; i < lines.size(); ++i) {
            if (lines[i].contains(code))
                return i + 1;
        }
        qFatal("no line has %s", qPrintable(code));
        return 0;
    }

    app::LessonLibrary library = app::LessonLibrary::load({LESSON_DIR});
    app::Session session{library};
};

/// Returns the state at `frame` of the run that the step's own compiled method computes from `script`.
inline sim::State published(const lessons::Step &step, sim::Script script, std::int64_t frame)
{
    script.method = step.script().method;
    script.step = step.script().step;
    sim::Track track(std::move(script), 0);
    track.seek({frame, 0});
    return track.state();
}

inline bool sameMotion(const sim::State &a, const sim::State &b)
{
    return a.pointCount() == b.pointCount() && (a.position == b.position).all() &&
           (a.velocity == b.velocity).all();
}

/// Returns the chip beside the line that has `code`, or an empty one.
inline app::LineChip chipAt(const Opened &opened, const QString &code)
{
    const app::LineStepper::Shown shown = opened.session.lines().shown();
    if (!shown.frame)
        return {};
    for (const app::LineChip &chip : valuesAfter(*shown.frame, shown.index).chips) {
        if (chip.line == opened.lineOf(code))
            return chip;
    }
    return {};
}

/// Returns the values beside the lines.
inline app::LineValues valuesOf(const Opened &opened)
{
    const app::LineStepper::Shown shown = opened.session.lines().shown();
    return valuesAfter(*shown.frame, shown.index);
}

}
