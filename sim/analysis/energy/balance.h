#pragma once

#include "sim/analysis/energy/stored_energy.h"

#include <array>
#include <cstddef>
#include <string>

namespace sim {

/// The sources and sinks of energy and momentum.
enum class Account {
    hand,    ///< the learner's hand
    changes, ///< parameters that take a new value
    motors,  ///< drivers: gait clocks, steering
    wind,    ///< wind
    rule,    ///< the force of a rule that a learner wrote
    pulls,   ///< forces without potential energy: springs that act on one end only, motors with a target
    gravity, ///< momentum only: weight
    anchors, ///< momentum only: springs to fixed positions
    damping, ///< drags
    impact,  ///< contacts
    sticks,  ///< constraints
    drift,   ///< the remainder: the error of the method
};
constexpr std::size_t accountCount = 12;

/// The id and the title of an account.
struct AccountName
{
    Account account;
    std::string id;    ///< lower case with underscores
    std::string title; ///< in English; see SIM_TEXT
};
/// Returns the names of all accounts, in the order of Account.
const std::array<AccountName, accountCount> &accountNames();

/// One amount per account.
template <class Amount>
class Accounts
{
public:
    Amount &operator[](Account account) { return m_amounts[static_cast<std::size_t>(account)]; }
    const Amount &operator[](Account account) const { return m_amounts[static_cast<std::size_t>(account)]; }

private:
    std::array<Amount, accountCount> m_amounts{};
};

/// The energy and momentum of a time interval: the amounts before and after, and the gain (a loss if
/// negative) in each account. The drift makes before plus all accounts equal after.
struct Balance
{
    StoredEnergy before;
    StoredEnergy after;
    Accounts<double> energy;
    Accounts<Vec2> momentum;
    /// Estimated error of the accounts' total energy without drift, and therefore of the drift. 0 if all are
    /// exact.
    double errorEstimate = 0.0;

    /// Sets the drift to the remainder.
    void close();
    /// Appends the interval that follows.
    void append(const Balance &next);
};

}
