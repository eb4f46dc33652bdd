#include "sim/analysis/energy/ledger.h"

#include "sim/analysis/energy/energy_accounting.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/script/state_transfer.h"

#include <algorithm>

namespace sim {

namespace {

constexpr std::size_t maxKept = 4;

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
    const bool hasNoEnergy = StoredEnergyReader::whyNot(interval->scene).has_value();
    if (m_kept.size() == maxKept)
        m_kept.erase(m_kept.begin());
    m_kept.push_back({interval, hasNoEnergy
                                    ? nullptr
                                    : std::make_shared<const EnergyAccounting>(*interval, directionRule)});
    return m_kept.back().accounting;
}

std::optional<Balance> Ledger::balanceAt(const Track &track, std::int64_t frame)
{
    const std::int64_t start = frame - track.framesPerOutput();
    const DirectionRule directionRule = track.script().method->directionRule();
    const std::shared_ptr<const ComposedInterval> intervalBefore = track.intervalAt(start),
                                                  interval = track.intervalAt(frame);
    const std::shared_ptr<const EnergyAccounting> accountingBefore =
                                                      accountingOf(intervalBefore, directionRule),
                                                  accounting = accountingOf(interval, directionRule);
    if (!accountingBefore || !accounting)
        return {};
    Balance balance;
    const State stateBefore = track.stateAt(start);
    balance.before = balance.after = accountingBefore->reader().read(stateBefore);
    const auto add = [&](Account account, const StoredEnergy &now) {
        balance.energy[account] += now.total() - balance.after.total();
        balance.momentum[account] = balance.momentum[account] + now.momentum - balance.after.momentum;
        balance.after = now;
    };
    if (intervalBefore != interval)
        add(Account::changes,
            accounting->reader().read(transferState(stateBefore, intervalBefore->scene, interval->scene)));
    State state = track.stateAfterInput(stateBefore, start);
    add(Account::hand, accounting->reader().read(state));
    accounting->outputStep(state, balance);
    balance.after = accounting->reader().read(state);
    balance.close();
    return balance;
}

}
