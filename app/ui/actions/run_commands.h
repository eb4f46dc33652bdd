#pragma once

#include "app/ui/actions/step_by.h"

#include <QObject>

namespace app {

class Command;
class CommandList;
class Session;

/// The commands of the Run menu, most of which the transport bar shows, too. A command that has no effect at
/// the cursor of the run is disabled and says why.
class RunCommands : public QObject
{
    Q_OBJECT

public:
    /// The key that cancels a long way to another frame. Other parts of the window use it, too, so that it is
    /// no command's shortcut.
    static constexpr Qt::Key cancelKey = Qt::Key_Escape;

    /// All arguments must outlive it.
    RunCommands(Session &session, CommandList &list);

    Command *const play;
    Command *const frameForward;
    Command *const frameBack;
    Command *const phaseForward;
    Command *const phaseBack;
    Command *const stepOver;
    Command *const stepOut;
    Command *const restart;
    Command *const repeat;
    Command *const end;
    Command *const goToFrame;
    Command *const slower;
    Command *const faster;
    Command *const startAfresh;
    Command *const forgetOldRun;
    Command *const chooseRun;
    Command *const compare;
    Command *const nextStep;
    Command *const previousStep;

    /// Sets what phaseForward and phaseBack run on the page of the code that is shown. Inside a frame, after a phase,
    /// they go by phases on every page.
    void setStepBy(StepBy stepBy);
    StepBy stepBy() const { return m_stepBy; }

signals:
    void stepByChanged(StepBy stepBy);

private:
    void connectToSession();
    void step(bool forward);
    void follow();
    void followStepBy();
    void followLines(const QString &whyNoFuture);
    void nameSteps();
    void followPlay(const QString &whyNot);
    void followRestart(const QString &whyNot);
    void followBranches();
    /// Returns why the run cannot go back from here; empty if it can.
    QString whyNoPast() const;
    /// Returns why the run cannot go on from here; empty if it can.
    QString whyNoFuture() const;

    Session &m_session;
    StepBy m_pageSteps = StepBy::phases;
    StepBy m_stepBy = StepBy::phases;
};

}
