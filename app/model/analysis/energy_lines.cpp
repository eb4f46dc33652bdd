#include "app/model/analysis/energy_lines.h"

#include "app/model/text/numbers.h"
#include "app/model/text/sentences.h"

#include <QCoreApplication>

#include <cmath>

namespace app {

namespace {

struct EnergyLinesText
{
    Q_DECLARE_TR_FUNCTIONS(EnergyLinesText)
};

using sim::Account;

constexpr double rounding = 1e-11; ///< fraction of the largest number of the run: smaller numbers count as 0

/// The order of the stacked areas: the drift is on top.
constexpr Account shownOrder[] = {Account::drift,   Account::impact,  Account::damping, Account::hand,
                                  Account::changes, Account::motors,  Account::wind,    Account::rule,
                                  Account::pulls,   Account::gravity, Account::anchors, Account::sticks};

struct Words
{
    QString help;
    sim::EffectKind kind;
};

Words wordsOf(Account account)
{
    using sim::EffectKind;
    switch (account) {
    case Account::hand:
        return {EnergyLinesText::tr("Energy that you add by dragging"), EffectKind::driver};
    case Account::changes:
        return {EnergyLinesText::tr(
                    "If a stiffness or a length changes, the energy stored in springs changes, too"),
                EffectKind::driver};
    case Account::motors:
        return {EnergyLinesText::tr("Energy that gait clocks and steering add"), EffectKind::driver};
    case Account::wind:
        return {EnergyLinesText::tr("Energy that the wind adds or takes away"), EffectKind::wind};
    case Account::rule:
        return {EnergyLinesText::tr("Energy that the force of your rule adds or takes away"),
                EffectKind::rule};
    case Account::pulls:
        return {EnergyLinesText::tr(
                    "A pull without an opposite pull stores no energy. It adds energy or takes it away"),
                EffectKind::spring};
    case Account::gravity:
        return {EnergyLinesText::tr("It pulls everything down, and nothing pulls back"), EffectKind::gravity};
    case Account::anchors:
        return {EnergyLinesText::tr("Springs pull on fixed places, and those pull back"), EffectKind::spring};
    case Account::damping:
        return {EnergyLinesText::tr("Energy that damping takes from everything that moves"),
                EffectKind::damping};
    case Account::impact:
        return {EnergyLinesText::tr("Energy that walls and ground take, or add when they push bodies out"),
                EffectKind::contact};
    case Account::sticks:
        return {
            EnergyLinesText::tr("Energy that sticks and joints change when they correct lengths and angles"),
            EffectKind::stick};
    case Account::drift:
        break;
    }
    return {EnergyLinesText::tr("Gained or lost through the method's error, not through anything in the "
                                "scene. A smaller step or another method makes it smaller."),
            EffectKind::motion};
}

QString size(double value)
{
    const double far = std::abs(value);
    if (far == 0.0)
        return QStringLiteral("0");
    if (far < 0.05 || far >= 1e6)
        return roughNumber(far);
    return fixedNumber(far, 1);
}

/// Returns `value`, or 0 if it is only a rounding error.
double cleaned(double value, double scale)
{
    return std::abs(value) <= rounding * scale ? 0.0 : value;
}

EnergyLine held(const char *id, const QString &title, const QString &help, sim::EffectKind kind,
                double amount)
{
    EnergyLine line;
    line.id = QString::fromLatin1(id);
    line.title = title;
    line.help = help;
    line.kind = kind;
    line.amount = amount;
    line.number = energyNumber(amount);
    return line;
}

EnergyLine brought(Account account)
{
    const sim::AccountName &name = sim::accountNames()[static_cast<std::size_t>(account)];
    const Words words = wordsOf(account);
    EnergyLine line;
    line.id = QString::fromStdString(name.id);
    line.title = phrase(name.title);
    line.help = words.help;
    line.kind = words.kind;
    line.role = account == Account::drift ? EnergyRole::drift : EnergyRole::brought;
    return line;
}

}

EnergyLines::EnergyLines(const EnergySeries &series) : m_series(series)
{
    const sim::Balance *first = series.at(series.first());
    if (!first)
        return;
    m_lowest = std::min(first->before.gravity, first->after.gravity);
    for (std::int64_t frame = series.first(); frame <= series.last(); frame += series.framesPerOutput())
        include(*series.at(frame));
    for (std::int64_t frame = series.first(); frame <= series.last(); frame += series.framesPerOutput()) {
        for (const sim::AccountName &name : sim::accountNames()) {
            const sim::Balance &balance = *series.at(frame);
            if (std::abs(balance.energy[name.account]) > rounding * m_scale)
                m_hasEnergy[name.account] = true;
            if (sim::length(balance.momentum[name.account]) > rounding * m_push)
                m_hasMomentum[name.account] = true;
        }
    }
    m_hasEnergy[Account::drift] = m_hasMomentum[Account::drift] = true;
}

void EnergyLines::include(const sim::Balance &balance)
{
    const sim::StoredEnergy &stored = balance.after;
    m_lowest = std::min(m_lowest, stored.gravity);
    m_isHigh = m_isHigh || stored.gravity != 0.0;
    m_hasSprings = m_hasSprings || stored.springs != 0.0;
    m_scale = std::max({m_scale, stored.moving, std::abs(stored.springs), std::abs(stored.gravity)});
    m_push = std::max(m_push, sim::length(stored.momentum));
    for (const sim::AccountName &name : sim::accountNames()) {
        m_scale = std::max(m_scale, std::abs(balance.energy[name.account]));
        m_push = std::max(m_push, sim::length(balance.momentum[name.account]));
    }
}

std::vector<EnergyLine> EnergyLines::energyAt(std::int64_t frame) const
{
    const sim::Balance *balance = m_series.at(frame);
    if (!balance)
        return {};
    std::vector<EnergyLine> lines;
    for (const Account account : shownOrder) {
        if (!m_hasEnergy[account])
            continue;
        EnergyLine line = brought(account);
        line.amount = cleaned(balance->energy[account], m_scale);
        line.number = signedEnergyNumber(line.amount);
        if (line.role == EnergyRole::drift) {
            line.errorEstimate = balance->errorEstimate;
            if (line.errorEstimate > 0.05 * std::abs(line.amount) && line.errorEstimate > 1e-9 * m_scale)
                line.number += QStringLiteral(" ± ") + size(line.errorEstimate);
        }
        lines.push_back(line);
    }
    lines.push_back(held("moving", EnergyLinesText::tr("In motion"),
                         EnergyLinesText::tr("Half of mass × speed², added up over all points"),
                         sim::EffectKind::motion, cleaned(balance->after.moving, m_scale)));
    if (m_isHigh)
        lines.push_back(
            held("height", EnergyLinesText::tr("In height"),
                 EnergyLinesText::tr("Mass × gravity × height, measured from the lowest point of this run"),
                 sim::EffectKind::gravity, cleaned(balance->after.gravity - m_lowest, m_scale)));
    if (m_hasSprings)
        lines.push_back(held("springs", EnergyLinesText::tr("In springs"),
                             EnergyLinesText::tr("Half of stiffness × stretch², added up over all springs"),
                             sim::EffectKind::spring, cleaned(balance->after.springs, m_scale)));
    return lines;
}

std::vector<EnergyLine> EnergyLines::momentumAt(std::int64_t frame) const
{
    const sim::Balance *balance = m_series.at(frame);
    if (!balance)
        return {};
    const auto put = [this](EnergyLine &line, sim::Vec2 push, auto &&write) {
        line.amount = cleaned(push.x, m_push);
        line.across = cleaned(push.y, m_push);
        line.number = QStringLiteral("%1, %2").arg(write(line.amount), write(line.across));
    };
    std::vector<EnergyLine> lines;
    for (const Account account : shownOrder) {
        if (!m_hasMomentum[account])
            continue;
        lines.push_back(brought(account));
        put(lines.back(), balance->momentum[account], signedEnergyNumber);
    }
    lines.push_back(
        held("momentum", EnergyLinesText::tr("In motion"),
             EnergyLinesText::tr("Mass × velocity, added up over all points: to the right, and down"),
             sim::EffectKind::motion, 0.0));
    put(lines.back(), balance->after.momentum, energyNumber);
    return lines;
}

QString energyNumber(double value)
{
    return (value < 0.0 ? QString(QChar(0x2212)) : QString()) + size(value);
}

QString signedEnergyNumber(double value)
{
    if (value == 0.0)
        return QStringLiteral("0");
    return (value < 0.0 ? QChar(0x2212) : QChar('+')) + size(value);
}

QString noEnergyWords(sim::NoEnergy why)
{
    switch (why) {
    case sim::NoEnergy::noInertia:
        return EnergyLinesText::tr(
            "A rule sets the position of at least one body in each frame, so this body has no velocity and "
            "the energy cannot be counted. Choose a scene in which every body has inertia.");
    case sim::NoEnergy::nothingMoves:
        return EnergyLinesText::tr(
            "Nothing moves in this scene unless you drag it, so there is no energy to count. Choose a scene "
            "with a body on a spring.");
    case sim::NoEnergy::tooLarge:
        return EnergyLinesText::tr("There are more than %1 points here. Counting the energy of all of them, "
                                   "phase by phase, would take longer than the run itself.")
            .arg(EnergySeries::mostPoints);
    case sim::NoEnergy::unknownForce:
        break;
    }
    return EnergyLinesText::tr(
        "Something here turns, but its inertia is unknown. So there is no energy to count.");
}

QString energyUnit(bool turns)
{
    return turns ? EnergyLinesText::tr("inertia × degrees²/frame²")
                 : EnergyLinesText::tr("mass × px²/frame²");
}

QString momentumUnit()
{
    return EnergyLinesText::tr("mass × px/frame");
}

}
