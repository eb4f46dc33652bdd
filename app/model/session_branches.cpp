// The branches of a session: runs that were left for another one, shown beside it, gone back to, kept and deleted.

#include "app/model/same_run.h"
#include "app/model/sentences.h"
#include "app/model/session.h"
#include "app/model/slices.h"
#include "sim/base/error.h"

#include <QTimer>

#include <algorithm>
#include <utility>

namespace app {

namespace {

constexpr qint64 sayAgainMilliseconds = 250; ///< how far a branch is that is on its way

}

Session::Stand Session::stand() const
{
    return {std::make_shared<const sim::Script>(m_timeline->script()), m_branches};
}

void Session::edit(const Deed &deed, const Edit &edit)
{
    lookNoMore();
    m_goingTo.reset();
    Stand before = stand();
    const std::int64_t computed = m_timeline->computed();
    bool forked = false;
    try {
        forked = edit(*m_timeline);
    } catch (const sim::Error &error) {
        emit said(sentenceFor(error));
        return;
    }
    const bool isLeft = forked || before.branches.own().end > m_timeline->cursor().frame;
    if (isLeft)
        branchOff(before, computed, deed);
    nameOwn(deed);
    m_branches.settle(m_timeline->script());
    if (forked) {
        m_coming.reset();
        m_beside = m_lastBranch;
    }
    hideWhatIsGone();
    runIsAnother();
    if (isLeft && !forked)
        showBeside(m_lastBranch);
    if (isLeft && beside())
        emit said(tr("The run as it was stays beside this one, as “%1”.").arg(beside()->name));
    remember(deed, std::move(before));
}

Branch Session::leftRun(const Stand &before, std::int64_t computed, const QString &name)
{
    const OwnRun &own = before.branches.own();
    const bool isNamed = !own.name.isEmpty();
    return {++m_lastBranch, isNamed ? own.name : name,   isNamed,
            own.isKept,     std::max(computed, own.end), before.script};
}

void Session::branchOff(const Stand &before, std::int64_t computed, const Deed &deed)
{
    const QString differs = deed.before.isEmpty() ? deed.what : deed.before;
    m_branches.add(leftRun(before, computed, tr("before: %1").arg(differs)), m_timeline->cursor().frame);
    m_branches.setOwn({});
    m_branches.limit();
}

void Session::nameOwn(const Deed &deed)
{
    OwnRun own = m_branches.own();
    own.made = tr("after: %1").arg(deed.after.isEmpty() ? deed.what : deed.after);
    m_branches.setOwn(std::move(own));
}

void Session::runIsAnother()
{
    wakeUp();
    checkTries();
    emit runChanged();
    emit moved();
}

void Session::hideWhatIsGone()
{
    if (beside())
        return;
    m_beside = 0;
    m_coming.reset();
    m_timeline->dropComparison();
}

void Session::showBeside(int id)
{
    const Branch *branch = m_branches.find(id);
    if (branch && id == m_beside)
        return;
    m_beside = branch ? id : 0;
    m_coming.reset();
    m_timeline->dropComparison();
    if (branch) {
        m_coming.emplace(*branch->script, m_timeline->comparisonBudget());
        m_sinceSaid.start();
        bring();
    }
    if (!branch || m_coming)
        runIsAnother();
}

void Session::bring()
{
    if (!m_coming || !beside())
        return;
    const std::int64_t goal = m_timeline->cursor().frame;
    if (goNearer(*m_coming, goal)) {
        m_timeline->setComparison(std::move(*m_coming),
                                  firstDifferent(*beside()->script, m_timeline->script()));
        m_coming.reset();
        runIsAnother();
        return;
    }
    if (m_sinceSaid.hasExpired(sayAgainMilliseconds)) {
        m_sinceSaid.start();
        emit said(tr("Computing “%1” again: frame %2 of %3. Esc stops.")
                      .arg(beside()->name, QString::number(m_coming->cursor().frame), QString::number(goal)));
    }
    if (std::exchange(m_bringDue, true))
        return;
    QTimer::singleShot(0, this, [this] {
        m_bringDue = false;
        bring();
    });
}

void Session::stopGoing()
{
    pause();
    if (!m_coming)
        return;
    emit said(tr("Stopped: “%1” is not shown. It can be shown again from “Runs”.").arg(beside()->name));
    showBeside(0);
}

bool Session::replaceRun(const sim::Script &script)
{
    const sim::Track *ghost = m_timeline->comparison();
    const std::int64_t shared = lastShared(script, m_timeline->script());
    const bool isGhost = ghost && sameScript(ghost->script(), script);
    if (isGhost)
        m_timeline->swapWithComparison();
    // Watchers take it that input changes after the cursor only.
    m_timeline->seek({std::min(m_timeline->cursor().frame, shared), 0});
    if (isGhost)
        return true;
    return sameRun(script, m_timeline->script()) ? m_timeline->replaceInput(script.input)
                                                 : m_timeline->replaceScript(script);
}

void Session::goBackTo(int id)
{
    letGo();
    letUp();
    endGesture();
    const Branch *branch = m_branches.find(id);
    if (!branch)
        return;
    const QString name = branch->name;
    Stand before = stand();
    Stand to{branch->script, m_branches};
    to.branches.settle(*to.script);
    const QString made = before.branches.own().made;
    restore(to, made.isEmpty() ? tr("the first run") : made, Leaves::always);
    m_branches.limit();
    remember({tr("Go back to “%1”").arg(name), {}}, std::move(before));
    emit runChanged();
    emit said(tr("This is “%1” again. The run that you left is a branch now.").arg(name));
}

void Session::keepBranch(int branch, bool kept)
{
    changeBranches(kept ? tr("Keep run") : tr("Stop keeping run"),
                   [&](Branches &branches) { branches.keep(branch, kept); });
}

void Session::renameBranch(int branch, const QString &name)
{
    changeBranches(tr("Rename run"), [&](Branches &branches) { branches.rename(branch, name); });
}

void Session::deleteBranch(int branch)
{
    changeBranches(tr("Delete run"), [&](Branches &branches) { branches.remove(branch); });
}

void Session::forgetGhost()
{
    deleteBranch(m_beside);
}

void Session::changeBranches(const QString &deed, const std::function<void(Branches &)> &change)
{
    Stand before = stand();
    change(m_branches);
    if (m_branches == before.branches)
        return;
    hideWhatIsGone();
    remember({deed, {}}, std::move(before));
    emit runChanged();
    emit moved();
}

}
