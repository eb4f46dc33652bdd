#pragma once

#include "app/model/attempts.h"
#include "app/model/branches.h"
#include "app/model/break_watch.h"
#include "app/model/companion_run.h"
#include "app/model/deed.h"
#include "app/model/experiment.h"
#include "app/model/foresight.h"
#include "app/model/look_cache.h"
#include "app/model/picture.h"
#include "app/model/player.h"
#include "app/model/progress.h"
#include "sim/analysis/force_snapshot.h"
#include "sim/analysis/stability/remedies/remedies.h"
#include "sim/run/timeline.h"

#include <QElapsedTimer>
#include <QObject>
#include <QUndoStack>

#include <map>
#include <memory>
#include <optional>

namespace app {

/// The open step of a lesson and its run: all that the window shows and does. The widgets change nothing but
/// this, and repaint when it says so.
class Session : public QObject
{
    Q_OBJECT

public:
    /// Opens the first step of the first lesson. `library` must not be empty and must outlive the session.
    explicit Session(const LessonLibrary &library, QObject *parent = nullptr);

    // What is open
    const LessonLibrary &library() const { return m_library; }
    const LessonEntry &lesson() const { return m_library.entry(m_lesson); }
    const lessons::Step &step() const { return lesson().steps[m_step]; }
    /// The step after this one, in this lesson or the next; null after the last.
    const lessons::Step *following() const;
    const lessons::Step *preceding() const;
    const sim::Timeline &timeline() const { return *m_timeline; }
    Progress &progress() { return m_progress; }
    bool isStepDone(const LessonEntry &lesson, const lessons::Step &step) const;
    /// What is still to do for the thing to try with this number, which has been begun; see Attempts::todo().
    QString todo(int number) const;
    /// How the time is told that a run takes, for things to try within a budget; measured, unless said otherwise.
    void setTiming(lessons::TimeMeasurement timing) { m_attempts.setTiming(std::move(timing)); }

    /// Opens a step as it was left, or new. Names that do not exist change nothing.
    void openStep(const QString &lesson, const QString &step);
    void openFollowing();
    void openPreceding();
    /// Opens an experiment in place of the step's run, at frame 0.
    void open(const Experiment &experiment);
    /// The run so far, as a file would keep it.
    Experiment experiment() const;
    /// The run of a step that was open before, as it was left.
    std::optional<Experiment> left(const QString &lesson, const QString &step) const;

    // Time
    bool isPlaying() const { return m_player.isPlaying(); }
    /// Whether it plays, but everything rests: time stands still, and goes on with the next change.
    bool isResting() const { return m_player.isWaiting(); }
    double speed() const { return m_player.speed(); }
    /// From 0.1 to 4 times 30 frames a second. Never changes the step.
    void setSpeed(double speed);
    void play();
    void pause();
    void togglePlaying();
    /// Pauses, and goes where it says.
    void frameForward();
    void frameBack();
    void phaseForward();
    void phaseBack();
    /// Goes to a moment. A far one is approached in slices, so that the window never waits; goingTo() tells.
    void goTo(sim::Cursor cursor);
    std::optional<std::int64_t> goingTo() const
    {
        return m_goingTo ? std::optional(m_goingTo->frame) : std::nullopt;
    }
    /// Pauses, and goes on to a moment after the cursor as playing does: it stops at breakpoints on the way.
    void runTo(sim::Cursor cursor);
    /// Begins the run again at frame 0, with parameters, method and effects as they are now, and without what hand,
    /// pointer and keys did. The run as it was becomes a branch, and it can be undone. Without any input, goes to frame 0.
    void restart();
    /// Plays the run again from frame 0, with all that was done in it.
    void repeat();
    /// Whether anything was done in this run besides what the step begins with.
    bool hasInput() const;
    /// Where the recorded hand holds something at the moment of shown(), or where the recorded pointer has its button
    /// down, px; empty where there is none, and while the learner's own hand does it.
    std::optional<sim::Vec2> recordedHand() const;
    /// A hand is about to take hold of something while time stands: starts time at the start of the run and at its end,
    /// where nothing comes after the cursor. In a scene that is built, inside a frame and in the past time stays.
    void startTimeByHand();
    /// While time stands, says so to a learner whose pointer acts.
    void sayThatTimeStands();
    /// The step as it was when it was first opened: no input, presets, published start.
    void startAfresh();

    // Looking: the mouse is at another moment than the run. Nothing of the run changes by it.
    /// Marks a moment and shows it, until endGlance() or until anything changes. While the run plays or is on its way,
    /// and where the moment takes long to be found again, it is marked only.
    void glance(sim::Cursor at);
    /// Marks a moment without showing it.
    void mark(sim::Cursor at);
    void endGlance();
    /// The moment that is marked, if one is.
    const std::optional<sim::Cursor> &marked() const { return m_marked; }
    bool isGlancing() const { return m_look.has_value(); }
    /// The run at the moment that is shown: timeline(), or a copy of it that stands where somebody looks.
    const sim::Timeline &shown() const { return m_look ? *m_look : *m_timeline; }

    // Breakpoints of the open step: playing, frameForward() and runTo() stop at them
    Breakpoints &breakpoints() { return m_breakpoints; }
    const Breakpoints &breakpoints() const { return m_breakpoints; }
    /// What stopped the run where it stands, if a breakpoint did and nothing has changed since.
    const std::optional<BreakHit> &stoppedBy() const { return m_hit; }

    // Changes, at the cursor
    double parameter(const QString &id) const;
    /// Values outside the parameter's range are brought into it.
    void setParameter(const QString &id, double value);
    void resetParameters();
    /// A method that takes another kind of step (a length, a tolerance) gets the one of that kind that was last in use.
    void setMethod(const QString &id);
    /// Steps of `h` frames.
    void setStepSize(double h);
    /// The error, in px, that an adaptive method may make in each of its own steps.
    void setTolerance(double tolerance);
    /// Method and step in one change.
    void use(const sim::MethodPtr &method, sim::StepSize step);
    /// Takes up what mends: a method and a step like use(), a parameter like setParameter(). Where the run has ended by
    /// itself nothing can be mended from there on: then the change holds from the start on, and the session goes to that
    /// frame again. The run as it was becomes the ghost, and all that the learner did is kept.
    void use(const sim::Remedy &remedy);
    /// All effects of the scene, in order: those that are switched off, too.
    std::vector<sim::EffectPtr> listedEffects() const;
    bool isOff(const QString &effect) const;
    /// Switches the effects with this id off or on again, from the start of the run on. An id that the scene does not
    /// list changes nothing; where nothing would move without it, that is said.
    void setEffect(const QString &id, bool on);
    /// The parameter of the step that damps, if it has one.
    std::optional<sim::DampRange> damping() const;
    /// The one that counts passes over sticks, if it has one.
    std::optional<sim::IterationRange> passes() const;
    void grab(const QString &body);
    void moveHand(sim::Vec2 to);
    void letGo();
    bool isHolding() const { return m_holding; }
    /// The pointer's place and button reach the scene, if its step lets them in; likewise a target and a key.
    void point(sim::Vec2 at, bool down);
    void aim(sim::Vec2 target);
    void steer(bool sim::Keys::*key, bool down);
    /// Keys come up and the pointer's button, as when the window loses the keyboard.
    void letUp();
    /// The step as it was when it was first opened, with a preset's values. Goes on playing if it played.
    void startWith(const lessons::Preset &preset);

    // A scene that the learner builds
    /// Whether the open step takes a scene that is built.
    bool isWorkshop() const { return step().points == lessons::PointSource::scene; }
    /// What the scene is built from; null where a lesson sets it up.
    std::shared_ptr<const sim::Blueprint> blueprint() const { return m_timeline->script().values.blueprint; }
    /// Puts another blueprint in its place, and goes to the start of the run. A scene that cannot be is refused in a
    /// sentence, and nothing changes. Returns whether it was built.
    bool build(const Deed &deed, sim::Blueprint blueprint);
    /// The same for all of a run: another experiment of the open step.
    bool takeUp(const Deed &deed, const sim::Script &script);

    // Undo: all that was changed since the step was opened, and comes back with the very bits it had
    const QUndoStack &deeds() const { return m_deeds; }
    void undo();
    void redo();
    /// What follows is another gesture, even if it goes on with the same thing.
    void endGesture() { ++m_gesture; }

    // Branches: runs that were left for another one
    const Branches &branches() const { return m_branches; }
    /// The branch that is shown beside the run, or will be as soon as it is computed again; null if there is none.
    const Branch *beside() const { return m_branches.find(m_beside); }
    /// Whether that one is still on its way.
    bool isBringing() const { return m_coming.has_value(); }
    /// Shows a branch beside the run, as its ghost. What is no longer there of it is computed again in slices, so that
    /// the window never waits. With an id that does not exist none is shown.
    void showBeside(int branch);
    /// Makes a branch the run again, bit for bit, at the same frame; the run in use becomes a branch.
    void goBackTo(int branch);
    void keepBranch(int branch, bool kept);
    void renameBranch(int branch, const QString &name);
    void deleteBranch(int branch);
    /// Stays where it is, if it is on its way to a moment; gives up a branch that is on its way.
    void stopGoing();

    // What is shown, at the moment of shown()
    Picture picture() const;
    /// The old run at the cursor's frame, if there is one.
    std::optional<Picture> ghost() const;
    /// The figure beside the run's own, at the same moment; empty where the step has none, or its method cannot.
    std::optional<Picture> companion() const;
    /// Whether that is still on its way to this moment; moved() tells when it is there.
    bool isCompanionComing() const { return m_companionDue; }
    /// Who the run's own figure is, next to a companion: its method and step.
    QString ownCaption() const;
    /// What the step has to say about this moment; may be empty.
    QString note() const;
    /// What the ghost differs by, for example "before: damp 0.85", or what the learner calls it.
    QString ghostName() const { return m_timeline->comparison() && beside() ? beside()->name : QString(); }
    /// Deletes the branch that is shown as the ghost.
    void forgetGhost();
    /// The body whose values are shown.
    QString selected() const { return m_selected; }
    void select(const QString &body);
    /// What the phases of the step under way, or of the last one, did to the selected body.
    /// Empty where finding out would take too long: in a crowd, far from a moment that is kept.
    std::vector<sim::PhaseExplanation> moments() const;
    /// Inside a frame: the accelerations so far.
    std::vector<sim::ForceSnapshot> gathered() const { return sim::accumulatedForces(shown().track()); }

signals:
    /// Another step is open: everything is new.
    void stepOpened();
    /// Parameters, method, step size, input or ghost changed: phases and code may be others.
    void runChanged();
    /// The cursor moved, or what is at it changed.
    void moved();
    /// Another moment is marked, or shown, or none any more.
    void glanceChanged();
    void playingChanged();
    void selectionChanged();
    /// Something for the status line.
    void said(const QString &sentence);

private:
    class RunChange; ///< a deed that can be undone

    /// The run in use with its branches: all that a deed changes.
    struct Stand
    {
        std::shared_ptr<const sim::Script> script;
        Branches branches;
    };

    struct Left
    {
        sim::Script script;
        sim::Cursor at;
        Branches branches;
    };

    /// What changes a timeline, and returns whether the run as it was became the ghost.
    using Edit = std::function<bool(sim::Timeline &)>;

    Picture pictureOf(const sim::Track &track, std::shared_ptr<const sim::ComposedInterval> interval,
                      sim::State state) const;
    void setStep(sim::StepSize step);
    void runAgain(const sim::Remedy &remedy);
    void leave();
    void start(sim::Script script, sim::Cursor at, Branches branches);
    /// The step's run with these values and no input of a learner's, by the first of `methods` that can. Goes on
    /// playing if it played.
    void startAnew(const Deed &deed, const sim::Values &values, const std::vector<sim::MethodPtr> &methods);
    void startAnew(const Deed &deed, sim::Script script);
    void advance(int frames);
    /// One row on, or to a breakpoint in it.
    std::optional<BreakHit> stepRow();
    void watchBreakpoints();
    /// Stands still for a breakpoint.
    void stopFor(const BreakHit &hit);
    /// A slice of the way of runTo().
    void runOn();
    void approachLater();
    /// Says once, after a while, that playing falls behind: `played` of the frames that were `due`.
    void judgePace(int due, int played);
    /// A change: what was foreseen no longer holds, and time goes on if it waited.
    void wakeUp();
    bool isOver();
    /// Whether a moment is there in some milliseconds, and nothing else is on its way.
    bool canShow(sim::Cursor at) const;
    void setMarked(sim::Cursor at, std::optional<sim::Timeline> look);
    /// Something happens: ends the glance if there is one. What is only marked stays so.
    void lookNoMore();
    /// While playing: waits if time alone shows nothing new and gets nothing done.
    void waitIfOver();
    /// Takes the companion to the cursor. Returns whether it is there.
    bool bringCompanion();
    void bringCompanionLater();
    void approach();
    Stand stand() const;
    /// Runs `edit` on the timeline. If the run as it was had a future, it becomes a branch, shown beside; a refusal is
    /// said, and changes nothing. What was done can be undone.
    void edit(const Deed &deed, const Edit &edit);
    /// Makes a branch of what `before` was: `deed` leaves it.
    void branchOff(const Stand &before, std::int64_t computed, const Deed &deed);
    /// The run in use is what `deed` made.
    void nameOwn(const Deed &deed);
    /// The run that `before` had in use, as a branch called `name` if the learner did not call it anything.
    Branch leftRun(const Stand &before, std::int64_t computed, const QString &name);
    /// Keeps what was done to `before`, so that it can be undone.
    void remember(const Deed &deed, Stand before);
    /// When a run that is left becomes a branch.
    enum class Leaves {
        ifItWentOn, ///< after what both share
        always,
        never, ///< it is one of the branches already
    };
    /// Puts a run of this step and its branches in place of those in use, at the same frame where it can. The run in use
    /// stays as a branch called `left`.
    void restore(const Stand &to, const QString &left, Leaves leaves);
    /// Whether to come to `script` the step has to be opened anew.
    bool opensAnew(const sim::Script &script) const;
    void goOnAt(sim::Cursor at);
    /// The same run with other branches; what comes back is shown, if nothing else is.
    void restoreBranches(const Branches &branches);
    /// Puts a script of this step in place of the run's, and takes the cursor to before where they differ. Returns whether
    /// the run as it was is the ghost now.
    bool replaceRun(const sim::Script &script);
    /// Another script is in use: those who watch the run hear of it.
    void runIsAnother();
    void changeBranches(const QString &deed, const std::function<void(Branches &)> &change);
    /// The branch beside the run is computed on in the next slice.
    void bring();
    void hideWhatIsGone();
    void checkTries();
    QString keyOf(const QString &lesson, const QString &step) const { return lesson + '/' + step; }

    const LessonLibrary &m_library;
    std::size_t m_lesson = 0;
    std::size_t m_step = 0;
    std::unique_ptr<sim::Timeline> m_timeline;
    std::optional<CompanionRun> m_companion; ///< where the step has one
    bool m_companionIsThere = false;         ///< at the cursor
    Player m_player;
    Foresight m_foresight, m_ghostForesight;
    Progress m_progress;
    Attempts m_attempts{m_progress};
    QString m_selected;
    Branches m_branches;
    int m_lastBranch = 0;               ///< the last id
    int m_beside = 0;                   ///< the branch that is the ghost, or will be
    std::optional<sim::Track> m_coming; ///< that one, while it is on its way to the cursor
    bool m_bringDue = false;            ///< whether the next slice of its way is already asked for
    QElapsedTimer m_sinceSaid;          ///< how far it is
    std::optional<sim::StepSize>
        m_otherStep;  ///< of the kind that the method in use does not take, as last in use
    int m_due = 0;    ///< frames since it plays
    int m_played = 0; ///< of them
    bool m_holding = false;
    sim::Keys m_keys;                       ///< those that the learner has down
    std::optional<sim::Vec2> m_pointerDown; ///< where the learner has the pointer's button down
    std::optional<sim::Cursor> m_goingTo;
    bool m_stopsOnTheWay = false; ///< whether it looks out for breakpoints while it goes there
    std::optional<sim::Cursor> m_marked;
    std::optional<sim::Timeline> m_look; ///< a copy, at the moment that is looked at
    Breakpoints m_breakpoints;
    BreakWatch m_watch;
    std::optional<BreakHit> m_hit;
    bool m_companionDue = false; ///< whether the next slice of its way is already asked for
    bool m_approachDue = false;  ///< whether the next slice of the way is already asked for
    mutable LookCache m_looks;
    std::map<QString, Left> m_left; ///< steps that were open before, as they were left
    QUndoStack m_deeds;
    int m_gesture = 0; ///< the number of the gesture under way
};

}
