#include "app/ui/actions/run_commands.h"

#include "app/model/session/session.h"
#include "app/model/text/sentences.h"
#include "app/ui/actions/command_list.h"

namespace app {

RunCommands::RunCommands(Session &session, CommandList &list)
    : play(list.add(tr("&Play or pause"), {QKeySequence(Qt::Key_Space)}, KeyGroup::time)),
      frameForward(list.add(tr("Next &frame"), {QKeySequence(Qt::Key_Right)}, KeyGroup::time)),
      frameBack(list.add(tr("Frame &back"), {QKeySequence(Qt::Key_Left)}, KeyGroup::time)),
      phaseForward(list.add(tr("&Next phase"), {QKeySequence("Shift+Right")}, KeyGroup::time)),
      phaseBack(list.add(tr("P&hase back"), {QKeySequence("Shift+Left")}, KeyGroup::time)),
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
    phaseForward->setIconText(tr("One phase forward"));
    phaseBack->setIconName("phase-back");
    phaseBack->setIconText(tr("One phase back"));
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
    connect(phaseForward, &QAction::triggered, &session.playback(), &Playback::phaseForward);
    connect(phaseBack, &QAction::triggered, &session.playback(), &Playback::phaseBack);
    connect(restart, &QAction::triggered, &session.editor(), &RunEditor::restart);
    connect(repeat, &QAction::triggered, &session.playback(), &Playback::repeat);
    connect(end, &QAction::triggered, &session, [&session] {
        session.playback().goTo({session.timeline().computed(), 0});
    });
    connect(startAfresh, &QAction::triggered, &session.editor(), &RunEditor::startAfresh);
    connect(forgetOldRun, &QAction::triggered, &session.comparisons(), &ComparisonRuns::removeShown);
    session.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::cursor | ChangeKind::playing, this,
                     &RunCommands::follow);
    session.onChange(ChangeKind::step | ChangeKind::run, this, &RunCommands::followBranches);
}

QString RunCommands::whyNoPast() const
{
    // While the run moves, going back stops it at least.
    const bool isAtStart = m_session.timeline().cursor() == sim::Cursor{};
    return isAtStart && !m_session.playback().isPlaying() && !m_session.playback().goal()
               ? tr("This is frame 0, the first frame.")
               : QString();
}

QString RunCommands::whyNoFuture() const
{
    const std::optional<sim::Stop> &stop = m_session.timeline().stop();
    return stop && m_session.timeline().cursor().frame >= stop->frame ? sentenceFor(*stop) : QString();
}

void RunCommands::follow()
{
    const bool isInside = m_session.timeline().cursor().phase > 0;
    const QString noPast = whyNoPast();
    const QString noFuture = whyNoFuture();
    phaseBack->setObstacle(noPast);
    frameBack->setIconText(isInside ? tr("To the start of this frame") : tr("One frame back"));
    frameBack->setObstacle(noPast);
    frameForward->setIconText(isInside ? tr("To the end of this frame") : tr("One frame forward"));
    frameForward->setObstacle(noFuture);
    phaseForward->setObstacle(noFuture);
    followPlay(noFuture);
    followRestart(noPast);
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
