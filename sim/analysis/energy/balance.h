#pragma once

#include "sim/analysis/energy/stored_energy.h"

#include <array>
#include <cstddef>
#include <string>

namespace sim {

/// Where energy and momentum come from and go to.
enum class Account {
    hand,    ///< what a hand does
    changes, ///< a parameter that takes a new value
    motors,  ///< drivers: gait clocks, steering
    wind,    ///< wind
    pulls,   ///< forces that have nothing stored: springs that pull one end only, motors to a target
    gravity, ///< of momentum only: the earth's pull
    anchors, ///< of momentum only: springs to places that stand fast
    damping, ///< drags
    impact,  ///< what bodies meet
    sticks,  ///< constraints
    drift,   ///< what remains: the method's error
};
constexpr std::size_t accountCount = 11;

/// How an account is called.
struct AccountName
{
    Account account;
    std::string id;    ///< lower case with underscores
    std::string title; ///< in English; see SIM_TEXT
};
/// Of every account, in order.
const std::array<AccountName, accountCount> &accountNames();

/// One entry each account.
template <class Amount>
class Accounts
{
public:
    Amount &operator[](Account account) { return m_amounts[static_cast<std::size_t>(account)]; }
    const Amount &operator[](Account account) const { return m_amounts[static_cast<std::size_t>(account)]; }

private:
    std::array<Amount, accountCount> m_amounts{};
};

/// Where the energy and the momentum of a stretch of time went: what there was, what each account brought (or, below
/// 0, took), and what there is. Before plus all accounts is after, as drift is what remains.
struct Balance
{
    StoredEnergy before;
    StoredEnergy after;
    Accounts<double> energy;
    Accounts<Vec2> momentum;
    /// By how much the energy of all accounts but the drift, and so of that, may be off. 0 where each is exact.
    double doubt = 0.0;

    /// Sets the drift to what remains.
    void close();
    /// Puts the stretch after this one to it.
    void append(const Balance &next);
};

}
