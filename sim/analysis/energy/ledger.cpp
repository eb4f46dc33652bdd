#include "sim/analysis/energy/ledger.h"

#include "sim/analysis/energy/energy_accounting.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/script/state_transfer.h"

#include <algorithm>

namespace sim {

namespace {

constexpr std::size_t mostKept = 4;

}

Ledger::Ledger() = default;
Ledger::~Ledger() = default;
Ledger::Ledger(Ledger &&) noexcept = default;
Ledger &Ledger::operator=(Ledger &&) noexcept = default;

std::shared_ptr<const EnergyAccounting>
Ledger::accountingOf(const std::shared_ptr<const ComposedInterval> &interval, DirectionRule directionRule)
{
    const auto found = std::find_if(m_kept.begin(), m_kept.end(),
                                    [&](const Kept &kept) { return kept.interval == interval; });
    if (found != m_kept.end())
        return found->accounting;
    const bool none = StoredEnergyReader::whyNot(interval->scene).has_value();
    if (m_kept.size() == mostKept)
        m_kept.erase(m_kept.begin());
    m_kept.push_back(
        {interval, none ? nullptr : std::make_shared<const EnergyAccounting>(*interval, directionRule)});
    return m_kept.back().accounting;
}

std::optional<Balance> Ledger::row(const Track &track, std::int64_t frame)
{
    const std::int64_t start = frame - track.framesPerOutput();
    const DirectionRule directionRule = track.script().method->directionRule();
    const std::shared_ptr<const ComposedInterval> was = track.intervalAt(start), is = track.intervalAt(frame);
    const std::shared_ptr<const EnergyAccounting> before = accountingOf(was, directionRule),
                                                  accounting = accountingOf(is, directionRule);
    if (!before || !accounting)
        return {};
    Balance balance;
    const State end = track.stateAt(start);
    balance.before = balance.after = before->meter().read(end);
    const auto book = [&](Account account, const StoredEnergy &now) {
        balance.energy[account] += now.total() - balance.after.total();
        balance.momentum[account] = balance.momentum[account] + now.momentum - balance.after.momentum;
        balance.after = now;
    };
    if (was != is)
        book(Account::changes, accounting->meter().read(transferState(end, was->scene, is->scene)));
    State state = track.stateAfterInput(end, start);
    book(Account::hand, accounting->meter().read(state));
    accounting->row(state, balance);
    balance.after = accounting->meter().read(state);
    balance.close();
    return balance;
}

}
