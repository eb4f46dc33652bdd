#pragma once

#include "app/model/session/comparison_runs.h"
#include "app/model/session/playback.h"
#include "app/model/session/user_input.h"
#include "sim/analysis/stability/remedies/remedies.h"

#include <QObject>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace app {

/// Switches the effects on that `script` switches off but does not list.
void keepListedOff(sim::Script &script);

/// Changes the run at the cursor: parameters, method, step size, effects, and the scene of a sandbox. Every edit can be
/// undone. If the replaced run had a future, it becomes a branch, shown as the ghost. An edit that fails says why, and
/// changes nothing.
class RunEditor : public QObject
{
    Q_OBJECT

public:
    RunEditor(OpenRun &run, Preview &preview, CompanionFollower &companion, Playback &playback,
              ComparisonRuns &comparisons, EditHistory &history);

    UserInput &input() { return m_input; }
    const UserInput &input() const { return m_input; }

    double parameter(const QString &id) const;
    /// Sets a parameter. Values outside its range are brought into it. An unknown `id` changes nothing.
    void setParameter(const QString &id, double value);
    void resetParameters();
    /// Sets the method. If it takes another kind of step (a length, or a tolerance), the last one of that kind is used.
    void setMethod(const QString &id);
    /// Sets the step size to `h` frames.
    void setStepSize(double h);
    /// Sets the error, in px, that an adaptive method may make in each of its own steps.
    void setTolerance(double tolerance);
    /// Sets method and step size in one edit.
    void use(const sim::MethodPtr &method, sim::StepSize step);
    /// Applies a remedy. If the run has ended by itself, the remedy holds from frame 0 on, and the session goes to the
    /// same frame again. All input stays.
    void use(const sim::Remedy &remedy);
    /// Sets the method that computes the listing, and the text `draft` that the run does not use, in one edit. If the
    /// edit is merged with the last one, the run of that one is forgotten, and its ghost stays.
    void setListing(const EditLabel &label, std::optional<QString> draft, const sim::MethodPtr &method,
                    sim::StepSize step);
    /// Sets the rule of the sandbox's scene, and the text `draft` that is not a rule yet, in the same way.
    void setRule(const EditLabel &label, std::optional<QString> draft, sim::BlueprintRule rule);
    /// Returns the parameter of the step that damps, if it has one.
    std::optional<sim::DampRange> damping() const;
    /// Returns the parameter of the step that counts passes over sticks, if it has one.
    std::optional<sim::IterationRange> passes() const;

    /// Returns all effects of the scene in order, including those that are switched off.
    std::vector<sim::EffectPtr> listedEffects() const;
    bool isOff(const QString &effect) const;
    /// Switches the effects with this id off or on, from frame 0 on. An unknown id changes nothing. If nothing would
    /// move without the effects, that is said.
    void setEffect(const QString &id, bool on);

    /// Starts the run again with a preset's values. Playback goes on.
    void startWith(const lessons::Preset &preset);
    /// Starts the step as it was when it was first opened: without input, with its first values.
    void startAfresh();
    /// Who has made a run.
    enum class Maker {
        learner,
        program, ///< the run ticks nothing, because things to try look at what the learner does
    };
    /// Makes `script`, a run of the open step, the run, and pauses at frame 0. No ghost is shown. Returns whether it can be
    /// computed; if not, says why.
    bool setUp(const EditLabel &label, const sim::Script &script, Maker maker);
    /// Starts the run again at frame 0 without user input, with the parameters, method and effects in use. Without
    /// any user input, goes to frame 0.
    void restart();
    /// Returns whether there is input besides what the step begins with.
    bool hasInput() const;

    /// Returns the blueprint of the sandbox's scene; null if a lesson sets the scene up.
    std::shared_ptr<const sim::Blueprint> blueprint() const;
    /// Replaces the blueprint, and goes to frame 0. Returns whether the new scene could be built.
    bool build(const EditLabel &label, sim::Blueprint blueprint);
    /// Replaces the script of a sandbox and the draft of its rule, and goes to frame 0. Returns whether the new scene could
    /// be built.
    bool replaceScene(const EditLabel &label, const sim::Script &script, std::optional<QString> draft = {});
    /// Changes how the script of a sandbox and those of its branches describe the same runs, and goes to frame 0. Returns
    /// whether the new scene could be built.
    bool rewriteScene(const EditLabel &label, const std::function<sim::Script(const sim::Script &)> &rewrite);

    /// Makes a branch the run again, bit for bit, at the same frame. The run in use becomes a branch.
    void goBackTo(int branch);

    const QUndoStack &undoStack() const { return m_history.stack(); }
    void undo();
    void redo();
    /// The next edit is not merged with the last one.
    void endGesture() { m_history.endGesture(); }

    /// Edits a timeline. Returns whether the replaced run became the timeline's comparison.
    using Edit = std::function<bool(sim::Timeline &)>;
    /// Runs `edit` on the run, announces the change, and makes it undoable.
    void edit(const EditLabel &label, const Edit &edit);
    /// Starts the run of `script` at `at` with these branches, in place of everything that is open. `draft` is the text of
    /// the listing, if the run does not use it. It cannot be undone.
    /// Throws sim::Error if there is no such run; nothing has changed then.
    void begin(sim::Script script, sim::Cursor at, Branches branches, std::optional<QString> draft = {});

private:
    /// Sets the step that `make` makes of `value`; if it throws, says why.
    void setStep(sim::StepSize (*make)(double), double value);
    void runAgain(const sim::Remedy &remedy);
    /// Returns the methods for a new start of the step's run, best first: the learner's code if it is in use, then that of
    /// the step.
    std::vector<sim::MethodPtr> ownMethods() const;
    /// Starts the step's run with these values and without user input, by the first of `methods` that can compute it.
    void startAnew(const EditLabel &label, const sim::Values &values,
                   const std::vector<sim::MethodPtr> &methods);
    void startAnew(const EditLabel &label, sim::Script script);
    /// Replaces the run and the branches of a sandbox, for replaceScene() and rewriteScene().
    bool replaceSandbox(const EditLabel &label, const sim::Script &script, std::optional<QString> draft,
                        Branches branches);
    /// Replaces the run for setUp(). Returns whether it could be computed; if not, says why.
    bool replaceBy(const EditLabel &label, const sim::Script &script);
    /// Replaces the script and the draft after the learner has written code.
    void setCode(const EditLabel &label, std::optional<QString> draft, sim::Script script);
    /// Replaces the run for setCode(), and goes to the same frame again. Returns whether it could be computed.
    bool replaceCode(const EditLabel &label, sim::Script script);
    /// Returns the draft beside the run of `script`, in place of that of `before`. It keeps the learner's listing if the
    /// run `before` used it, and none if another listing computes the run now.
    std::optional<QString> draftBeside(const sim::Script &script, const RunSnapshot &before) const;
    void restore(const RunSnapshot &to, const QString &replacedName, KeepRun keepReplaced);
    /// Returns whether the step has to be opened again for `script`.
    bool needsNewStart(const sim::Script &script) const;
    /// Replaces the script and moves the cursor before the first difference. Returns whether the replaced run is the
    /// timeline's comparison now.
    bool replaceRun(const sim::Script &script);

    OpenRun &m_run;
    Preview &m_preview;
    CompanionFollower &m_companion;
    Playback &m_playback;
    ComparisonRuns &m_comparisons;
    EditHistory &m_history;
    UserInput m_input;
    int m_typedOver = 0;            ///< id of the branch that the last edit of the listing has left
    std::int64_t m_wantedFrame = 0; ///< where the learner was before the last edit of the listing
    std::optional<sim::StepSize>
        m_otherStep; ///< the last step of the kind that the method in use does not take
};

}
