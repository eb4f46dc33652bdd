#pragma once

#include "app/model/catalog/lesson_library.h"
#include "app/model/session/change_notifier.h"
#include "sim/run/timeline.h"

#include <memory>
#include <optional>

namespace app {

/// The open step of a lesson, its run and the selected body: the state that the parts of a session share.
class OpenRun
{
public:
    /// `library` must not be empty. Both arguments must outlive this object. There is no run until setTimeline().
    OpenRun(const LessonLibrary &library, ChangeNotifier &changes) : m_library(library), m_changes(changes) {}

    const LessonLibrary &library() const { return m_library; }
    ChangeNotifier &changes() const { return m_changes; }

    std::size_t lessonNumber() const { return m_lesson; }
    std::size_t stepNumber() const { return m_step; }
    const LessonEntry &lesson() const { return m_library.entry(m_lesson); }
    const lessons::Step &step() const { return lesson().steps[m_step]; }
    void setStep(std::size_t lesson, std::size_t step);
    /// Returns the text that identifies the step in settings: "lesson/step".
    QString key() const { return keyOf(lesson().id, step().id); }
    static QString keyOf(const QString &lesson, const QString &step) { return lesson + '/' + step; }

    sim::Timeline &timeline() { return *m_timeline; }
    const sim::Timeline &timeline() const { return *m_timeline; }
    /// Makes `timeline` the run, and selects its first body.
    void setTimeline(std::unique_ptr<sim::Timeline> timeline);

    /// Returns the text of the listing that the learner has written, if the run is not computed by it: it does not
    /// compile, or another method is in use.
    const std::optional<QString> &draft() const { return m_draft; }
    void setDraft(std::optional<QString> draft);

    /// Returns the body whose values are shown.
    const QString &selected() const { return m_selected; }
    void select(const QString &body);

private:
    const LessonLibrary &m_library;
    ChangeNotifier &m_changes;
    std::size_t m_lesson = 0;
    std::size_t m_step = 0;
    std::unique_ptr<sim::Timeline> m_timeline;
    std::optional<QString> m_draft;
    QString m_selected;
};

}
