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

std::shared_ptr<const Books> Ledger::booksOf(const std::shared_ptr<const Segment> &segment,
                                             Directions directions)
{
    const auto found =
        std::find_if(m_kept.begin(), m_kept.end(), [&](const Kept &kept) { return kept.segment == segment; });
    if (found != m_kept.end())
        return found->books;
    const bool none = Meter::whyNot(segment->scene).has_value();
    if (m_kept.size() == mostKept)
        m_kept.erase(m_kept.begin());
    m_kept.push_back({segment, none ? nullptr : std::make_shared<const Books>(*segment, directions)});
    return m_kept.back().books;
}

std::optional<Balance> Ledger::row(const Track &track, std::int64_t frame)
{
    const std::int64_t start = frame - track.rowFrames();
    const Directions directions = track.script().method->directions();
    const std::shared_ptr<const Segment> was = track.segmentAt(start), is = track.segmentAt(frame);
    const std::shared_ptr<const Books> before = booksOf(was, directions), books = booksOf(is, directions);
    if (!before || !books)
        return {};
    Balance balance;
    const State end = track.stateAt(start);
    balance.before = balance.after = before->meter().read(end);
    const auto book = [&](Account account, const Stock &now) {
        balance.energy[account] += now.total() - balance.after.total();
        balance.momentum[account] = balance.momentum[account] + now.momentum - balance.after.momentum;
        balance.after = now;
    };
    if (was != is)
        book(Account::changes, books->meter().read(carryOver(end, was->scene, is->scene)));
    State state = track.begunAfter(end, start);
    book(Account::hand, books->meter().read(state));
    books->row(state, balance);
    balance.after = books->meter().read(state);
    balance.close();
    return balance;
}

}
