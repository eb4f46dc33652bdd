#pragma once

#include "app/model/catalog/lesson_library.h"
#include "app/model/session/change_notifier.h"
#include "sim/run/timeline.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <type_traits>
#include <vector>

namespace app {

/// The open step of a lesson, its run and the selected body: the state that the parts of a session share. Widgets have
/// it as a constant, to read it and to follow its changes.
class OpenRun
{
public:
    /// `library` must not be empty. Both arguments must outlive this object. There is no run until setTimeline().
    OpenRun(const LessonLibrary &library, ChangeNotifier &changes) : m_library(library), m_changes(changes) {}

    const LessonLibrary &library() const { return m_library; }
    ChangeNotifier &changes() { return m_changes; }
    const ChangeNotifier &changes() const { return m_changes; }

    /// Calls `slot`, a member function of `receiver` or a functor, for each change of at least one of these kinds. It
    /// may take the Change.
    template <typename Receiver, typename Slot>
    void onChange(ChangeKinds kinds, Receiver *receiver, Slot slot) const
    {
        QObject::connect(&m_changes, &ChangeNotifier::changed, receiver, [=](const Change &change) {
            if (!change.isAny(kinds))
                return;
            if constexpr (std::is_invocable_v<Slot, Receiver *, const Change &>)
                std::invoke(slot, receiver, change);
            else if constexpr (std::is_invocable_v<Slot, Receiver *>)
                std::invoke(slot, receiver);
            else if constexpr (std::is_invocable_v<Slot, const Change &>)
                std::invoke(slot, change);
            else
                std::invoke(slot);
        });
    }
    /// Shows `sentence` in the status line.
    void showMessage(const QString &sentence) const { m_changes.showMessage(sentence); }

    std::size_t lessonNumber() const { return m_lesson; }
    std::size_t stepNumber() const { return m_step; }
    const LessonEntry &lesson() const { return m_library.entry(m_lesson); }
    const lessons::Step &step() const { return lesson().steps[m_step]; }
    /// Returns whether the user builds the scene of the open step.
    bool isSandbox() const { return step().points == lessons::PointSource::scene; }
    /// Returns the step after this one, in this lesson or the next; null after the last.
    const lessons::Step *following() const;
    const lessons::Step *preceding() const;
    void setStep(std::size_t lesson, std::size_t step);
    /// Returns the text that identifies the step in settings: "lesson/step".
    QString key() const { return keyOf(lesson().id, step().id); }
    static QString keyOf(const QString &lesson, const QString &step) { return lesson + '/' + step; }

    sim::Timeline &timeline() { return *m_timeline; }
    const sim::Timeline &timeline() const { return *m_timeline; }
    /// Makes `timeline` the run, and selects its first body.
    void setTimeline(std::unique_ptr<sim::Timeline> timeline);

    /// Says whether the learner has changed the run since it was opened, set up or restored.
    void setEdited(bool isEdited) { m_isEdited = isEdited; }
    /// Remembers a run that the program sets up in the open step, for example for a prediction.
    void addGiven(const sim::Script &script);
    /// Returns whether the program has set up the run, and the learner has not changed it since.
    bool isGiven() const;

    /// Returns the text of the listing that the learner has written, if the run is not computed by it: it does not
    /// compile, or another method is in use. In the sandbox, see hasRuleDraft().
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
    bool m_isEdited = false;
    std::map<QString, std::vector<sim::Script>> m_given; ///< runs that the program has set up, by key()
    std::optional<QString> m_draft;
    QString m_selected;
};

}
