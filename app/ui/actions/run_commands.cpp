#include "app/ui/actions/run_commands.h"

#include "app/model/run/run_program.h"
#include "app/model/session/session.h"
#include "app/ui/actions/command_list.h"

namespace app {

RunCommands::RunCommands(Session &session, CommandList &list)
    : play(list.add(tr("&Play or pause"), {QKeySequence(Qt::Key_Space)}, KeyGroup::time)),
      frameForward(list.add(tr("Next &frame"), {QKeySequence(Qt::Key_Right)}, KeyGroup::time)),
      frameBack(list.add(tr("Frame &back"), {QKeySequence(Qt::Key_Left)}, KeyGroup::time)),
      phaseForward(list.add(tr("&Next phase"), {QKeySequence("Shift+Right")}, KeyGroup::time)),
      phaseBack(list.add(tr("P&hase back"), {QKeySequence("Shift+Left")}, KeyGroup::time)),
      stepOver(list.add(tr("Step over calls"), {QKeySequence("F10")}, KeyGroup::time)),
      stepOut(list.add(tr("Step out of the call"), {QKeySequence("Ctrl+F10")}, KeyGroup::time)),
      restart(list.add(tr("Re&start"), {QKeySequence(Qt::Key_Home)}, KeyGroup::time)),
      repeat(
          list.add(tr("Repea&t the run with the same input"), {QKeySequence("Shift+Home")}, KeyGroup::time)),
      end(list.add(tr("To th&e last computed frame"), {QKeySequence(Qt::Key_End)}, KeyGroup::time)),
      goToFrame(list.add(tr("Go to frame…"), {QKeySequence("Ctrl+G")}, KeyGroup::time)),
      slower(list.add(tr("S&lower"), {QKeySequence("-")}, KeyGroup::time)),
      faster(list.add(tr("Faste&r"), {QKeySequence("+"), QKeySequence("=")}, KeyGroup::time)),
      startAfresh(list.add(tr("Reset run &and parameters"), {QKeySequence("Ctrl+R")}, KeyGroup::time)),
      forgetOldRun(list.add(tr("Delete the &old run"), {QKeySequence("Ctrl+D")}, KeyGroup::time)),
      chooseRun(list.add(tr("Choose another run…"), {QKeySequence("Ctrl+Shift+R")}, KeyGroup::otherRuns)),
      compare(list.add(tr("&Compare two runs"), {QKeySequence("Ctrl+Shift+B")}, KeyGroup::otherRuns)),
      nextStep(list.add(tr("Ne&xt step"), {QKeySequence(Qt::Key_PageDown)}, KeyGroup::steps)),
      previousStep(list.add(tr("Pre&vious step"), {QKeySequence(Qt::Key_PageUp)}, KeyGroup::steps)),
      m_session(session)
{
    frameForward->setIconName("frame-forward");
    frameBack->setIconName("frame-back");
    phaseForward->setIconName("phase-forward");
    phaseBack->setIconName("phase-back");
    stepOver->setHelp(tr("Run the next line with all functions that it calls"));
    stepOut->setHelp(tr("Run to the end of the function, or of the frame"));
    nameSteps();
    restart->setIconName("reset");
    goToFrame->setHelp(tr("Go to a frame"));
    chooseRun->setIconName("runs");
    compare->setHelp(tr("The distance between the two runs, frame by frame"));
    compare->setObjectName("showBranches");
    compare->setCheckable(true);
    connectToSession();
    follow();
    followBranches();
}

void RunCommands::connectToSession()
{
    Session &session = m_session;
    connect(play, &QAction::triggered, &session, [&session] {
        session.playback().goal() ? session.playback().pause() : session.playback().togglePlaying();
    });
    connect(frameForward, &QAction::triggered, &session.playback(), &Playback::frameForward);
    connect(frameBack, &QAction::triggered, &session.playback(), &Playback::frameBack);
    connect(phaseForward, &QAction::triggered, this, [this] { step(true); });
    connect(phaseBack, &QAction::triggered, this, [this] { step(false); });
    connect(stepOver, &QAction::triggered, this, [this] { m_session.lines().stepOver(); });
    connect(stepOut, &QAction::triggered, this, [this] { m_session.lines().stepOut(); });
    connect(restart, &QAction::triggered, &session.editor(), &RunEditor::restart);
    connect(repeat, &QAction::triggered, &session.playback(), &Playback::repeat);
    connect(end, &QAction::triggered, &session, [&session] {
        session.playback().goTo({session.timeline().computed(), 0});
    });
    connect(startAfresh, &QAction::triggered, &session.editor(), &RunEditor::startAfresh);
    connect(forgetOldRun, &QAction::triggered, &session.comparisons(), &ComparisonRuns::removeShown);
    session.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::cursor | ChangeKind::playing |
                         ChangeKind::code,
                     this, &RunCommands::follow);
    session.onChange(ChangeKind::step | ChangeKind::run, this, &RunCommands::followBranches);
}

void RunCommands::setStepBy(StepBy stepBy)
{
    m_pageSteps = stepBy;
    follow();
}

void RunCommands::followStepBy()
{
    // A run that stands inside a frame, after a phase, has no next line.
    const bool isAfterPhase = m_session.timeline().cursor().phase > 0;
    const StepBy now = isAfterPhase ? StepBy::phases : m_pageSteps;
    if (now == m_stepBy)
        return;
    m_stepBy = now;
    nameSteps();
    emit stepByChanged(now);
}

void RunCommands::nameSteps()
{
    const bool byLine = m_stepBy == StepBy::lines;
    phaseForward->setText(byLine ? tr("&Next line") : tr("&Next phase"));
    phaseForward->setIconText(byLine ? tr("One line forward") : tr("One phase forward"));
    phaseBack->setText(byLine ? tr("Line bac&k") : tr("P&hase back"));
    phaseBack->setIconText(byLine ? tr("One line back") : tr("One phase back"));
}

void RunCommands::step(bool forward)
{
    if (m_stepBy == StepBy::lines)
        forward ? m_session.lines().forward() : m_session.lines().back();
    else
        forward ? m_session.playback().phaseForward() : m_session.playback().phaseBack();
}

QString RunCommands::whyNoPast() const
{
    // While the run moves, going back stops it at least.
    const bool isAtStart = m_session.timeline().cursor() == sim::Cursor{} && m_session.lines().index() == 0;
    return isAtStart && !m_session.playback().isPlaying() && !m_session.playback().goal()
               ? tr("This is frame 0, the first frame.")
               : QString();
}

QString RunCommands::whyNoFuture() const
{
    const std::optional<sim::Stop> &stop = m_session.timeline().stop();
    return stop && m_session.timeline().cursor().frame >= stop->frame
               ? endSentence(m_session.timeline().track())
               : QString();
}

void RunCommands::follow()
{
    followStepBy();
    const bool isInside = m_session.timeline().cursor().phase > 0 || m_session.lines().index() > 0;
    const QString noPast = whyNoPast();
    const QString noFuture = whyNoFuture();
    phaseBack->setObstacle(noPast);
    frameBack->setIconText(isInside ? tr("To the start of this frame") : tr("One frame back"));
    frameBack->setObstacle(noPast);
    frameForward->setIconText(isInside ? tr("To the end of this frame") : tr("One frame forward"));
    frameForward->setObstacle(noFuture);
    followLines(noFuture);
    followPlay(noFuture);
    followRestart(noPast);
}

void RunCommands::followLines(const QString &whyNoFuture)
{
    const bool byLine = m_stepBy == StepBy::lines;
    // A frame with a mistake runs up to the line of the mistake.
    const QString noLine = byLine && m_session.lines().nextLine() > 0 ? QString() : whyNoFuture;
    phaseForward->setObstacle(noLine);
    const QString noCalls = byLine ? noLine : tr("Open the Listing page of the code to go line by line.");
    stepOver->setObstacle(noCalls);
    stepOut->setObstacle(noCalls);
}

void RunCommands::followPlay(const QString &whyNot)
{
    const bool isOnItsWay = m_session.playback().goal().has_value();
    play->setIconName(isOnItsWay || m_session.playback().isPlaying() ? "pause" : "play");
    play->setIconText(isOnItsWay                         ? tr("Stop here")
                      : m_session.playback().isPlaying() ? tr("Pause")
                                                         : tr("Play"));
    play->setOtherKeys(isOnItsWay ? QKeySequence(cancelKey) : QKeySequence());
    play->setObstacle(isOnItsWay ? QString() : whyNot);
}

void RunCommands::followRestart(const QString &whyNot)
{
    const bool hasInput = m_session.editor().hasInput();
    QStringList details{tr("Starts a new run from frame 0, with the current parameters.")};
    if (hasInput)
        details << tr("%1 repeats this run instead, with the same input.").arg(keyText(repeat->shortcut()));
    restart->setDetails(details.join('\n'));
    restart->setObstacle(hasInput ? QString() : whyNot);
}

void RunCommands::followBranches()
{
    const std::size_t count = m_session.comparisons().branches().all().size();
    chooseRun->setIconText(count == 0   ? tr("Other runs: none yet")
                           : count == 1 ? tr("Other runs: one")
                                        : tr("Other runs: %1").arg(count));
    chooseRun->setObstacle(
        count == 0 ? tr("Go back in time and change something: the old run then appears here.") : QString());
    forgetOldRun->setEnabled(m_session.comparisons().shown());
}

}
