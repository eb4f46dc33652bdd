#include "app/model/analysis/effect_lines.h"

#include "app/model/catalog/lists.h"
#include "app/model/text/numbers.h"
#include "app/model/text/phrases.h"
#include "app/model/text/sentences.h"
#include "sim/effects/all_effects.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

struct EffectLinesText
{
    Q_DECLARE_TR_FUNCTIONS(EffectLinesText)
};

constexpr QChar thin(0x2009);

/// Formats a time in µs, the unit of all times here, with the digits that a learner can use: "0.0314", "7.922", "1250".
QString figure(double ns)
{
    const double us = ns / 1e3;
    return fixedNumber(us, us >= 1000.0 ? 0 : us >= 100.0 ? 1 : us >= 1.0 ? 3 : 4);
}

/// Formats an uncertainty: "±0.0003", "±0.219".
QString spreadFigure(double ns)
{
    return QChar(0x00B1) + figure(ns);
}

/// Methods with adaptive steps can have a fractional number of evaluations, which gets one more digit.
QString runsOf(double evaluations)
{
    const bool isWhole = std::abs(evaluations - std::round(evaluations)) < 0.05;
    return QChar(0x00D7) + fixedNumber(evaluations, isWhole ? 0 : 1);
}

/// The measured cost of the effects with one id. A scene may list several.
struct MeasuredCost
{
    double ns = 0.0;
    double spread = 0.0;
    double evaluations = 0.0;
    int points = 0;
    bool isKnown = false;
};

MeasuredCost measured(const EffectFacts &facts, const std::string &id)
{
    MeasuredCost sum;
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

/// Returns whether all effects with this id are left out. A scene may list an id twice.
bool isIdle(const EffectFacts &facts, const std::string &id)
{
    const auto isIt = [&](const sim::EffectPtr &one) { return one->id() == id; };
    const auto left = std::count_if(facts.leftOut.begin(), facts.leftOut.end(), isIt);
    return left > 0 && left == std::count_if(facts.listed.begin(), facts.listed.end(), isIt);
}

QString savingWords(const QString &title, double ns, const sim::FrameCost &cost)
{
    if (ns >= cost.ns) // by less than their scatter
        return EffectLinesText::tr("Nearly all of a frame’s %2\u2009µs are spent in “%1”.")
            .arg(title, figure(cost.ns));
    return EffectLinesText::tr("Without “%1” a frame would cost %2\u2009µs instead of %3.")
        .arg(title, figure(cost.ns - ns), figure(cost.ns));
}

void fillActing(EffectLine &line, const MeasuredCost &cost, const EffectFacts &facts)
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
        help << EffectLinesText::tr("%1\u2009µs a frame; about half of the measurements are within %2.")
                    .arg(line.frame, line.spread);
        help << EffectLinesText::tr("Points that it acts on: %1.").arg(line.points);
        help << (line.runs.isEmpty() ? EffectLinesText::tr("The method computes it together with the move.")
                                     : EffectLinesText::tr("Each frame computes it %1.").arg(line.runs));
        help << line.saving;
    }
    if (line.role == EffectRole::idle)
        help << EffectLinesText::tr(
            "With these settings it changes nothing, so it is not computed: 0\u2009µs.");
    if (line.role == EffectRole::off)
        help << EffectLinesText::tr("Switched off: it costs nothing.");
    if (line.role == EffectRole::offered)
        help << EffectLinesText::tr("Not in this scene, so it costs nothing.");
    help << (line.isOn() ? EffectLinesText::tr("Press Space or click the switch to turn it off.")
                         : EffectLinesText::tr("Press Space or click the switch to turn it on again."));
    return help.join('\n');
}

EffectLine listedLine(const EffectFacts &facts, const sim::Effect &effect)
{
    const std::string id = effect.id();
    EffectLine line;
    line.id = QString::fromStdString(id);
    line.title = capitalised(phrase(effect.title()));
    line.kind = effect.kind();
    if (contains(facts.off, id)) {
        line.role = EffectRole::off;
        line.frame = QStringLiteral("0");
        line.note = EffectLinesText::tr("switched off");
    } else if (isIdle(facts, id)) {
        line.role = EffectRole::idle;
        line.frame = QStringLiteral("0");
        line.note = EffectLinesText::tr("changes nothing here");
    } else {
        fillActing(line, measured(facts, id), facts);
    }
    line.help = helpFor(line, sim::purposeOf(effect));
    return line;
}

/// Returns whether the scene lists an effect with the id of `effect`.
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
    line.note = EffectLinesText::tr("not in this scene");
    line.help = helpFor(line, effect.purpose);
    return line;
}

EffectLine restLine(const sim::FrameCost *cost)
{
    EffectLine line;
    line.id = QStringLiteral("rest");
    line.title = EffectLinesText::tr("Rest of the frame");
    line.role = EffectRole::rest;
    const bool isKnown = cost && cost->rounds > 0;
    line.ns = isKnown ? cost->restNs : 0.0;
    line.frame = isKnown ? figure(cost->restNs) : QString(QChar(0x2026));
    if (isKnown)
        line.spread = spreadFigure(cost->restSpread);
    line.help = line.title + '\n' +
                EffectLinesText::tr("Time outside the effects: moving the points, and the method's own sums. "
                                    "It cannot be switched off.");
    return line;
}

/// Returns one line for all effects of a kind that are not listed.
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
        help << EffectLinesText::tr("%1 (%2). %3")
                    .arg(capitalised(title), known.lesson, phrase(known.purpose))
                    .trimmed();
    }
    if (titles.isEmpty())
        return std::nullopt;
    EffectLine line;
    line.id = QStringLiteral(":%1").arg(static_cast<int>(kind));
    line.title = capitalised(titles.join(QStringLiteral(", ")));
    line.kind = kind;
    line.role = EffectRole::absent;
    line.frame = QStringLiteral("0");
    line.note = EffectLinesText::tr("not in this scene");
    help.prepend(
        EffectLinesText::tr("Not in this scene, so it costs nothing and has no switch. Other lessons have:"));
    line.help = help.join('\n');
    return line;
}

}

QString EffectLine::spoken() const
{
    if (role == EffectRole::absent)
        return EffectLinesText::tr("%1, %2\u2009µs, %3").arg(title, frame, note);
    const QString figures = ns == 0.0 && role == EffectRole::acts
                                ? EffectLinesText::tr("%1, not measured yet").arg(title)
                                : EffectLinesText::tr("%1, %2\u2009µs a frame").arg(title, frame);
    if (role == EffectRole::rest)
        return figures;
    const QString state = isOn() ? EffectLinesText::tr("on") : EffectLinesText::tr("off");
    return role == EffectRole::idle ? listed(listed(figures, state), note) : listed(figures, state);
}

std::vector<EffectLine> effectLines(const EffectFacts &facts)
{
    std::vector<EffectLine> lines;
    std::vector<std::string> ids;
    for (const sim::EffectPtr &effect : facts.listed) {
        if (contains(ids, effect->id()))
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
        if (contains(kinds, known.kind))
            continue;
        kinds.push_back(known.kind);
        if (const auto line = absentLine(facts, known.kind))
            lines.push_back(*line);
    }
    return lines;
}

QString frameWords(const sim::FrameCost &cost)
{
    return EffectLinesText::tr("%1%2µs a frame, ±%3").arg(figure(cost.ns), thin, figure(cost.spread));
}

}
