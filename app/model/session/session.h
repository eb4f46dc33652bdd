#pragma once

#include "app/model/catalog/progress.h"
#include "app/model/experiment/experiment.h"
#include "app/model/learning/notes.h"
#include "app/model/learning/proofs.h"
#include "app/model/listing/learner_code.h"
#include "app/model/listing/line_stepper.h"
#include "app/model/listing/rule_code.h"
#include "app/model/session/presentation.h"
#include "app/model/session/run_editor.h"

#include <map>
#include <optional>

namespace app {

/// The open step of a lesson, and the parts that show and change its run. It opens steps and experiments, and keeps the
/// steps that were open before. A widget takes the parts that it needs, changes the run only through them, and follows
/// onChange().
class Session : public QObject
{
    Q_OBJECT

public:
    /// Opens the first step of the first lesson. `library` must not be empty and must outlive the session.
    explicit Session(const LessonLibrary &library, QObject *parent = nullptr);

    // The parts
    Playback &playback() { return m_playback; }
    const Playback &playback() const { return m_playback; }
    Preview &preview() { return m_preview; }
    RunEditor &editor() { return m_editor; }
    const RunEditor &editor() const { return m_editor; }
    UserInput &input() { return m_editor.input(); }
    ComparisonRuns &comparisons() { return m_comparisons; }
    const ComparisonRuns &comparisons() const { return m_comparisons; }
    LearnerCode &code() { return m_code; }
    const LearnerCode &code() const { return m_code; }
    RuleCode &rule() { return m_rule; }
    LineStepper &lines() { return m_lines; }
    const LineStepper &lines() const { return m_lines; }
    const Presentation &presentation() const { return m_presentation; }
    Progress &progress() { return m_progress; }
    Notes &notes() { return m_notes; }
    Proofs &proofs() { return m_proofs; }

    // The open step
    const OpenRun &run() const { return m_run; }
    const LessonLibrary &library() const { return m_run.library(); }
    const LessonEntry &lesson() const { return m_run.lesson(); }
    const lessons::Step &step() const { return m_run.step(); }
    const sim::Timeline &timeline() const { return m_run.timeline(); }
    bool isSandbox() const { return m_run.isSandbox(); }
    /// Returns the body whose values are shown.
    QString selected() const { return m_run.selected(); }
    void select(const QString &body) { m_run.select(body); }

    /// Opens a step as it was left, or new. Names that do not exist change nothing.
    void openStep(const QString &lesson, const QString &step);
    void openFollowing();
    void openPreceding();
    /// Opens an experiment in place of the step's run, at frame 0.
    void open(const Experiment &experiment);
    /// Returns the run so far, for a file.
    Experiment experiment() const;
    /// Returns the run of a step that was open before, as it was left.
    std::optional<Experiment> experimentOf(const QString &lesson, const QString &step) const;

    /// Returns whether all things to try and all tasks in the listing of `step` are done, and there are any.
    bool isStepDone(const LessonEntry &lesson, const lessons::Step &step) const;
    /// Returns what remains to do for the thing to try with this number, if it was begun; see Attempts::todo().
    QString todo(int number) const;
    /// Sets the function that measures run times, for things to try within a budget.
    void setTiming(lessons::TimeMeasurement timing) { m_attempts.setTiming(std::move(timing)); }

    /// Pauses, and cancels the computing of a distant moment or of a branch.
    void cancelComputing();
    /// Announces that the library's steps have other texts.
    void announceTexts() { m_changes.announce(ChangeKind::texts); }
    /// Shows `sentence` in the status line.
    void showMessage(const QString &sentence) const { m_run.showMessage(sentence); }

    /// Announces the changes of the run, each edit once.
    const ChangeNotifier &changes() const { return m_changes; }
    /// As OpenRun::onChange().
    template <typename Receiver, typename Slot>
    void onChange(ChangeKinds kinds, Receiver *receiver, Slot slot) const
    {
        m_run.onChange(kinds, receiver, slot);
    }

private:
    /// A step that was open before, as it was left.
    struct StepHandover
    {
        sim::Script script;
        sim::Cursor at;
        Branches branches;
        std::optional<QString> draft;
    };

    bool isBusy() const;
    /// Brings the parts up to date before changes of these kinds are announced.
    void prepare(ChangeKinds kinds);
    void leave();

    ChangeNotifier m_changes;
    OpenRun m_run;
    Progress m_progress;
    Notes m_notes;
    Proofs m_proofs;
    Attempts m_attempts{m_progress, m_proofs, m_run.library()};
    Preview m_preview;
    CompanionFollower m_companion;
    Playback m_playback;
    EditHistory m_history;
    ComparisonRuns m_comparisons;
    RunEditor m_editor;
    LearnerCode m_code;
    RuleCode m_rule;
    LineStepper m_lines;
    Presentation m_presentation;
    std::map<QString, StepHandover> m_handovers;
};

}
