#include "app/model/session/comparison_runs.h"

#include "app/model/run/time_slice.h"

#include <QTimer>

#include <algorithm>
#include <utility>

namespace app {

namespace {

constexpr qint64 reportMilliseconds = 250;

}

RunSnapshot ComparisonRuns::snapshot() const
{
    return {std::make_shared<const sim::Script>(m_run.timeline().script()), m_branches, m_run.draft()};
}

void ComparisonRuns::reset(Branches branches)
{
    m_coming.reset();
    m_shown = 0;
    m_branches = std::move(branches);
}

Branch ComparisonRuns::branchOf(const RunSnapshot &before, std::int64_t computed, const QString &name)
{
    const OwnRun &own = before.branches.own();
    const bool isNamed = !own.name.isEmpty();
    return {++m_lastId, isNamed ? own.name : name,   isNamed,
            own.isKept, std::max(computed, own.end), before.script};
}

void ComparisonRuns::recordEdit(const EditLabel &label, const RunSnapshot &before, std::int64_t computed,
                                Replaced replaced)
{
    if (replaced != Replaced::forgotten) {
        const QString differs = label.before.isEmpty() ? label.what : label.before;
        m_branches.add(branchOf(before, computed, tr("before: %1").arg(differs)),
                       m_run.timeline().cursor().frame);
        m_branches.setOwn({});
        m_branches.limit();
    }
    OwnRun own = m_branches.own();
    own.made = tr("after: %1").arg(label.after.isEmpty() ? label.what : label.after);
    m_branches.setOwn(std::move(own));
    m_branches.settle(m_run.timeline().script());
    if (replaced == Replaced::comparison) {
        m_coming.reset();
        m_shown = m_lastId;
    }
    hideRemoved();
}

void ComparisonRuns::hideRemoved()
{
    if (shown())
        return;
    m_shown = 0;
    m_coming.reset();
    m_run.timeline().dropComparison();
}

void ComparisonRuns::show(int id)
{
    const Branch *branch = m_branches.find(id);
    if (branch && id == m_shown)
        return;
    const ChangeNotifier::Batch batch(m_run.changes());
    m_shown = branch ? id : 0;
    m_coming.reset();
    m_run.timeline().dropComparison();
    if (branch) {
        m_coming.emplace(*branch->script, m_run.timeline().comparisonBudget());
        m_sinceReport.start();
        computeSlice();
    }
    m_run.changes().announce(ChangeKind::run | ChangeKind::cursor);
}

void ComparisonRuns::computeSlice()
{
    if (!m_coming || !shown())
        return;
    sim::Timeline &timeline = m_run.timeline();
    const std::int64_t goal = timeline.cursor().frame;
    if (goNearer(*m_coming, goal)) {
        timeline.setComparison(std::move(*m_coming), firstDifferent(*shown()->script, timeline.script()));
        m_coming.reset();
        m_run.changes().announce(ChangeKind::run | ChangeKind::cursor);
        return;
    }
    if (m_sinceReport.hasExpired(reportMilliseconds)) {
        m_sinceReport.start();
        m_run.showMessage(
            tr("Computing “%1” again: frame %2 of %3. Press Esc to stop.")
                .arg(shown()->name, QString::number(m_coming->cursor().frame), QString::number(goal)));
    }
    if (std::exchange(m_isSliceDue, true))
        return;
    QTimer::singleShot(0, this, [this] {
        m_isSliceDue = false;
        computeSlice();
    });
}

void ComparisonRuns::cancel()
{
    if (!m_coming)
        return;
    m_run.showMessage(tr("Stopped: “%1” is not shown. You can show it again in “Runs”.").arg(shown()->name));
    show(0);
}

void ComparisonRuns::keep(int branch, bool kept)
{
    change(kept ? tr("Keep run") : tr("Stop keeping run"),
           [&](Branches &branches) { branches.keep(branch, kept); });
}

void ComparisonRuns::rename(int branch, const QString &name)
{
    change(tr("Rename run"), [&](Branches &branches) { branches.rename(branch, name); });
}

void ComparisonRuns::remove(int branch)
{
    change(tr("Delete run"), [&](Branches &branches) { branches.remove(branch); });
}

void ComparisonRuns::change(const QString &what, const std::function<void(Branches &)> &edit)
{
    RunSnapshot before = snapshot();
    edit(m_branches);
    if (m_branches == before.branches)
        return;
    const ChangeNotifier::Batch batch(m_run.changes());
    hideRemoved();
    m_history.add({what, {}}, std::move(before), snapshot());
    m_run.changes().announce(ChangeKind::run | ChangeKind::cursor);
}

void ComparisonRuns::restore(Branches branches, const sim::Script *comparison)
{
    m_branches = std::move(branches);
    m_coming.reset();
    const Branch *branch = comparison ? m_branches.find(*comparison) : nullptr;
    m_shown = branch ? branch->id : 0;
    hideRemoved();
}

void ComparisonRuns::restoreBranches(const Branches &branches)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    const Branches were = std::exchange(m_branches, branches);
    hideRemoved();
    const std::vector<Branch> &all = m_branches.all();
    const auto isBack =
        std::find_if(all.begin(), all.end(), [&](const Branch &one) { return !were.find(one.id); });
    if (!shown() && isBack != all.end())
        show(isBack->id);
    m_run.changes().announce(ChangeKind::run | ChangeKind::cursor);
}

}
