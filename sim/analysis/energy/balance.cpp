#include "sim/analysis/energy/balance.h"

#include "sim/scene/effect.h"

namespace sim {

const std::array<AccountName, accountCount> &accountNames()
{
    static const std::array<AccountName, accountCount> names = {{
        {Account::hand, "hand", SIM_TEXT("Done by dragging")},
        {Account::changes, "changes", SIM_TEXT("Changed with a parameter")},
        {Account::motors, "motors", SIM_TEXT("Done by clocks and steering")},
        {Account::wind, "wind", SIM_TEXT("Done by wind")},
        {Account::rule, "rule", SIM_TEXT("Done by my rule")},
        {Account::pulls, "pulls", SIM_TEXT("Done by one-way pulls")},
        {Account::gravity, "gravity", SIM_TEXT("Given by gravity")},
        {Account::anchors, "anchors", SIM_TEXT("Given by fixed places")},
        {Account::damping, "damping", SIM_TEXT("Lost by damping")},
        {Account::impact, "impact", SIM_TEXT("At impacts")},
        {Account::sticks, "sticks", SIM_TEXT("Changed by sticks")},
        {Account::drift, "drift", SIM_TEXT("Drift of the method")},
    }};
    return names;
}

void Balance::close()
{
    energy[Account::drift] = 0.0;
    momentum[Account::drift] = {};
    double gained = 0.0;
    Vec2 pushed;
    for (const AccountName &name : accountNames()) {
        gained += energy[name.account];
        pushed = pushed + momentum[name.account];
    }
    energy[Account::drift] = after.total() - before.total() - gained;
    momentum[Account::drift] = after.momentum - before.momentum - pushed;
}

void Balance::append(const Balance &next)
{
    for (const AccountName &name : accountNames()) {
        energy[name.account] += next.energy[name.account];
        momentum[name.account] = momentum[name.account] + next.momentum[name.account];
    }
    after = next.after;
    errorEstimate += next.errorEstimate;
}

}
