#include "app/model/effect_lines.h"

#include "app/model/numbers.h"
#include "app/model/sentences.h"
#include "sim/effects/all_effects.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(EffectLines)
};

constexpr QChar thin(0x2009);

/// In µs, the unit of all times here, with as many digits as a learner can use: "0.0314", "7.922", "1250".
QString figure(double ns)
{
    const double us = ns / 1e3;
    return fixedNumber(us, us >= 1000.0 ? 0 : us >= 100.0 ? 1 : us >= 1.0 ? 3 : 4);
}

/// "±0.0003", "±0.219".
QString spreadFigure(double ns)
{
    return QChar(0x00B1) + figure(ns);
}

/// What is no whole number, of a method that chooses its steps, has one digit more.
QString runsOf(double evaluations)
{
    const bool isWhole = std::abs(evaluations - std::round(evaluations)) < 0.05;
    return QChar(0x00D7) + fixedNumber(evaluations, isWhole ? 0 : 1);
}

/// What was measured of the effects with one id: a scene may list several.
struct Measured
{
    double ns = 0.0;
    double spread = 0.0;
    double evaluations = 0.0;
    int points = 0;
    bool isKnown = false;
};

Measured measured(const EffectFacts &facts, const std::string &id)
{
    Measured sum;
    if (!facts.cost || facts.cost->rounds == 0)
        return sum;
    for (const sim::EffectCost &one : facts.cost->effects) {
        if (one.effect->id() != id)
            continue;
        sum.ns += one.ns;
        sum.spread = std::hypot(sum.spread, one.spread);
        sum.evaluations = std::max(sum.evaluations, one.evaluations);
        sum.points += one.points;
        sum.isKnown = true;
    }
    return sum;
}

/// Whether of the effects with this id, which a scene may list twice, each is left out.
bool isIdle(const EffectFacts &facts, const std::string &id)
{
    const auto isIt = [&](const sim::EffectPtr &one) { return one->id() == id; };
    const auto left = std::count_if(facts.leftOut.begin(), facts.leftOut.end(), isIt);
    return left > 0 && left == std::count_if(facts.listed.begin(), facts.listed.end(), isIt);
}

QString savingWords(const QString &title, double ns, const sim::FrameCost &cost)
{
    return Text::tr("Without “%1” a frame would cost %2\u2009µs in place of %3.")
        .arg(title, figure(std::max(0.0, cost.ns - ns)), figure(cost.ns));
}

void fillActing(EffectLine &line, const Measured &cost, const EffectFacts &facts)
{
    if (!cost.isKnown) {
        line.frame = QChar(0x2026);
        return;
    }
    line.ns = cost.ns;
    line.frame = figure(cost.ns);
    line.spread = spreadFigure(cost.spread);
    line.points = fixedNumber(cost.points, 0);
    if (cost.points > 0)
        line.point = figure(cost.ns / cost.points);
    if (cost.evaluations > 0.0)
        line.runs = runsOf(cost.evaluations);
    line.saving = savingWords(line.title, cost.ns, *facts.cost);
}

QString helpFor(const EffectLine &line, const std::string &purpose)
{
    QStringList help = {line.title};
    if (!purpose.empty())
        help << phrase(purpose);
    if (!line.points.isEmpty()) {
        help << Text::tr("%1\u2009µs a frame, half of the rounds within %2.").arg(line.frame, line.spread);
        help << Text::tr("Points that it works on: %1.").arg(line.points);
        help << (line.runs.isEmpty() ? Text::tr("The method works it out together with the move.")
                                     : Text::tr("A frame computes it %1.").arg(line.runs));
        help << line.saving;
    }
    if (line.role == EffectRole::idle)
        help << Text::tr("As it is set it can change nothing, so no frame computes it: 0\u2009µs.");
    if (line.role == EffectRole::off)
        help << Text::tr("Switched off: it costs nothing.");
    if (line.role == EffectRole::offered)
        help << Text::tr("Not in this scene, so it costs nothing.");
    help << (line.isOn() ? Text::tr("Space or a click on the switch takes it out of the scene.")
                         : Text::tr("Space or a click on the switch puts it back."));
    return help.join('\n');
}

EffectLine listedLine(const EffectFacts &facts, const sim::Effect &effect)
{
    const std::string id = effect.id();
    EffectLine line;
    line.id = QString::fromStdString(id);
    line.title = capitalised(phrase(effect.title()));
    line.kind = effect.kind();
    if (std::find(facts.off.begin(), facts.off.end(), id) != facts.off.end()) {
        line.role = EffectRole::off;
        line.frame = QStringLiteral("0");
        line.note = Text::tr("switched off");
    } else if (isIdle(facts, id)) {
        line.role = EffectRole::idle;
        line.frame = QStringLiteral("0");
        line.note = Text::tr("changes nothing here");
    } else {
        fillActing(line, measured(facts, id), facts);
    }
    line.help = helpFor(line, sim::purposeOf(effect));
    return line;
}

/// Whether the scene lists an effect with the id of `effect`.
bool isListed(const EffectFacts &facts, const sim::EffectDescription &effect)
{
    return std::any_of(facts.listed.begin(), facts.listed.end(),
                       [&](const sim::EffectPtr &one) { return one->id() == effect.id; });
}

EffectLine offeredLine(const sim::EffectDescription &effect)
{
    EffectLine line;
    line.id = QString::fromUtf8(effect.id);
    line.title = capitalised(phrase(effect.title));
    line.kind = effect.kind;
    line.role = EffectRole::offered;
    line.frame = QStringLiteral("0");
    line.note = Text::tr("not in this scene");
    line.help = helpFor(line, effect.purpose);
    return line;
}

EffectLine restLine(const sim::FrameCost *cost)
{
    EffectLine line;
    line.id = QStringLiteral("rest");
    line.title = Text::tr("Rest of the frame");
    line.role = EffectRole::rest;
    const bool isKnown = cost && cost->rounds > 0;
    line.ns = isKnown ? cost->restNs : 0.0;
    line.frame = isKnown ? figure(cost->restNs) : QString(QChar(0x2026));
    if (isKnown)
        line.spread = spreadFigure(cost->restSpread);
    line.help = line.title + '\n' +
                Text::tr("What no effect takes: moving the points, and the method's own sums. "
                         "It cannot be switched off.");
    return line;
}

/// What one kind of effects has that is not listed: one line, however many there are.
std::optional<EffectLine> absentLine(const EffectFacts &facts, sim::EffectKind kind)
{
    const auto isListed = [&](const KnownEffect &known) {
        return std::any_of(
                   facts.listed.begin(), facts.listed.end(),
                   [&](const auto &one) { return one->kind() == kind && one->title() == known.title; }) ||
               std::any_of(facts.offered.begin(), facts.offered.end(),
                           [&](const auto *one) { return one->kind == kind && one->title == known.title; });
    };
    QStringList titles, help;
    for (const KnownEffect &known : facts.known) {
        if (known.kind != kind || isListed(known))
            continue;
        const QString title = phrase(known.title);
        titles << title;
        help
            << Text::tr("%1 (%2). %3").arg(capitalised(title), known.lesson, phrase(known.purpose)).trimmed();
    }
    if (titles.isEmpty())
        return std::nullopt;
    EffectLine line;
    line.id = QStringLiteral(":%1").arg(static_cast<int>(kind));
    line.title = capitalised(titles.join(QStringLiteral(", ")));
    line.kind = kind;
    line.role = EffectRole::absent;
    line.frame = QStringLiteral("0");
    line.note = Text::tr("not in this scene");
    help.prepend(Text::tr("Not in this scene, so it costs nothing and there is nothing to switch. "
                          "Other lessons have:"));
    line.help = help.join('\n');
    return line;
}

}

QString EffectLine::spoken() const
{
    if (role == EffectRole::absent)
        return Text::tr("%1, %2\u2009µs, %3").arg(title, frame, note);
    const QString figures = ns == 0.0 && role == EffectRole::acts
                                ? Text::tr("%1, not measured yet").arg(title)
                                : Text::tr("%1, %2\u2009µs a frame").arg(title, frame);
    if (role == EffectRole::rest)
        return figures;
    const QString state = isOn() ? Text::tr("on") : Text::tr("off");
    return role == EffectRole::idle ? Text::tr("%1, %2, %3").arg(figures, state, note)
                                    : Text::tr("%1, %2").arg(figures, state);
}

std::vector<EffectLine> effectLines(const EffectFacts &facts)
{
    std::vector<EffectLine> lines;
    std::vector<std::string> ids;
    for (const sim::EffectPtr &effect : facts.listed) {
        if (std::find(ids.begin(), ids.end(), effect->id()) != ids.end())
            continue;
        ids.push_back(effect->id());
        lines.push_back(listedLine(facts, *effect));
    }
    for (const sim::EffectDescription *effect : facts.offered) {
        if (!isListed(facts, *effect))
            lines.push_back(offeredLine(*effect));
    }
    lines.push_back(restLine(facts.cost));
    std::vector<sim::EffectKind> kinds;
    for (const KnownEffect &known : facts.known) {
        if (std::find(kinds.begin(), kinds.end(), known.kind) != kinds.end())
            continue;
        kinds.push_back(known.kind);
        if (const auto line = absentLine(facts, known.kind))
            lines.push_back(*line);
    }
    return lines;
}

QString frameWords(const sim::FrameCost &cost)
{
    return Text::tr("%1%2µs a frame, ±%3").arg(figure(cost.ns), thin, figure(cost.spread));
}

}
