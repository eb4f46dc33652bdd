#include "app/model/energy_lines.h"

#include "app/model/numbers.h"

#include <QCoreApplication>

#include <cmath>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(EnergyLines)
};

using sim::Account;

constexpr double rounding = 1e-11; ///< of the largest number of the run: less than this is none

/// As areas are stacked: the drift on top.
constexpr Account shownOrder[] = {Account::drift,   Account::impact,  Account::damping, Account::hand,
                                  Account::changes, Account::motors,  Account::wind,    Account::pulls,
                                  Account::gravity, Account::anchors, Account::sticks};

struct Words
{
    QString title;
    QString help;
    sim::EffectKind kind;
};

Words wordsOf(Account account)
{
    using sim::EffectKind;
    switch (account) {
    case Account::hand:
        return {Text::tr("Done by the hand"), Text::tr("What you put in by grabbing and dragging"),
                EffectKind::driver};
    case Account::changes:
        return {Text::tr("Changed with a number"),
                Text::tr("A stiffness or a length that changes also changes what springs hold"),
                EffectKind::driver};
    case Account::motors:
        return {Text::tr("Done by what drives"), Text::tr("What clocks and steering put in"),
                EffectKind::driver};
    case Account::wind:
        return {Text::tr("Done by wind"), Text::tr("What the wind puts in, or takes"), EffectKind::wind};
    case Account::pulls:
        return {Text::tr("Done by one-way pulls"),
                Text::tr("A pull that pulls nothing back holds nothing: what it does, it makes or takes"),
                EffectKind::spring};
    case Account::gravity:
        return {Text::tr("Given by gravity"), Text::tr("It pulls everything down, and nothing pulls back"),
                EffectKind::gravity};
    case Account::anchors:
        return {Text::tr("Given by what stands fast"),
                Text::tr("Springs to a place that cannot move pull on it, and it pulls back"),
                EffectKind::spring};
    case Account::damping:
        return {Text::tr("Lost by damping"), Text::tr("What damping takes from everything that moves"),
                EffectKind::damping};
    case Account::impact:
        return {Text::tr("At impacts"), Text::tr("What walls and ground take, and what they lift bodies by"),
                EffectKind::contact};
    case Account::sticks:
        return {Text::tr("Changed by sticks"),
                Text::tr("What sticks and joints change when they put things right"), EffectKind::stick};
    case Account::drift:
        break;
    }
    return {
        Text::tr("Drift of the method"),
        Text::tr(
            "Made or lost by the method's error: nothing in the scene explains it. A smaller step or another "
            "method makes it smaller."),
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

/// 0 for what is only rounding.
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
    const Words words = wordsOf(account);
    EnergyLine line;
    line.id = QString::fromStdString(sim::accountNames()[static_cast<std::size_t>(account)].id);
    line.title = words.title;
    line.help = words.help;
    line.kind = words.kind;
    line.role = account == Account::drift ? EnergyRole::drift : EnergyRole::brought;
    return line;
}

}

EnergyLines::EnergyLines(const EnergyCourse &course) : m_course(course)
{
    const sim::Balance *first = course.at(course.first());
    if (!first)
        return;
    m_lowest = std::min(first->before.gravity, first->after.gravity);
    for (std::int64_t frame = course.first(); frame <= course.last(); frame += course.rowFrames())
        look(*course.at(frame));
    for (std::int64_t frame = course.first(); frame <= course.last(); frame += course.rowFrames()) {
        for (const sim::AccountName &name : sim::accountNames()) {
            const sim::Balance &balance = *course.at(frame);
            if (std::abs(balance.energy[name.account]) > rounding * m_scale)
                m_hasEnergy[name.account] = true;
            if (sim::length(balance.momentum[name.account]) > rounding * m_push)
                m_hasMomentum[name.account] = true;
        }
    }
    m_hasEnergy[Account::drift] = m_hasMomentum[Account::drift] = true;
}

void EnergyLines::look(const sim::Balance &balance)
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
    const sim::Balance *balance = m_course.at(frame);
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
    lines.push_back(held("moving", Text::tr("In what moves"),
                         Text::tr("Half of mass × speed², added up over all points"), sim::EffectKind::motion,
                         cleaned(balance->after.moving, m_scale)));
    if (m_isHigh)
        lines.push_back(held("height", Text::tr("Held by height"),
                             Text::tr("Mass × gravity × height, counted from the lowest of this run"),
                             sim::EffectKind::gravity, cleaned(balance->after.gravity - m_lowest, m_scale)));
    if (m_hasSprings)
        lines.push_back(held("springs", Text::tr("What springs hold"),
                             Text::tr("Half of stiffness × stretch², added up over all springs"),
                             sim::EffectKind::spring, cleaned(balance->after.springs, m_scale)));
    return lines;
}

std::vector<EnergyLine> EnergyLines::momentumAt(std::int64_t frame) const
{
    const sim::Balance *balance = m_course.at(frame);
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
    lines.push_back(held("momentum", Text::tr("In what moves"),
                         Text::tr("Mass × velocity, added up over all points: to the right, and down"),
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
        return Text::tr(
            "Something here has no velocity of its own: a rule puts it where it goes, and nothing keeps it "
            "moving. So there is no energy to count. Scenes in which everything has inertia have this "
            "ledger.");
    case sim::NoEnergy::nothingMoves:
        return Text::tr(
            "Nothing here moves by itself: where it is, something else decides. So there is no energy to "
            "count. Scenes with a body that a spring pulls have this ledger.");
    case sim::NoEnergy::tooLarge:
        return Text::tr(
                   "There are more than %1 points here. To count the energy of all of them, phase by phase, "
                   "would take longer than the run itself.")
            .arg(EnergyCourse::mostPoints);
    case sim::NoEnergy::unknownForce:
        break;
    }
    return Text::tr("Nothing here tells how heavy what turns is. So there is no energy to count.");
}

QString energyUnit(bool turns)
{
    return turns ? Text::tr("inertia × degrees²/frame²") : Text::tr("mass × px²/frame²");
}

QString momentumUnit()
{
    return Text::tr("mass × px/frame");
}

}
