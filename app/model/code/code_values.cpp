#include "app/model/code/code_values.h"

#include "app/model/code/code_symbols.h"
#include "app/model/text/quoting.h"
#include "sim/run/script/composed_interval.h"

#include <QCoreApplication>
#include <QHash>
#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

namespace {

using Value = std::variant<double, sim::Vec2>;

struct CodeValuesText
{
    Q_DECLARE_TR_FUNCTIONS(CodeValuesText)
};

/// A number (or a component of one) and its line.
struct Placed
{
    std::size_t line = 0;
    sim::LiveValue live;
};

std::optional<std::size_t> firstLine(const CodeSection &section, const QString &pattern)
{
    const QRegularExpression expression(pattern);
    for (std::size_t i = 0; i < section.lines.size(); ++i) {
        if (expression.match(section.lines[i].code()).hasMatch())
            return i;
    }
    return std::nullopt;
}

/// Returns the line that assigns to `name` in place, such as "x.y". Empty unless there is exactly one.
std::optional<std::size_t> onlyAssignment(const CodeSection &section, const QString &name)
{
    const QRegularExpression expression(
        QStringLiteral("(?<![\\w.>])%1\\s*[-+*/]?=(?!=)").arg(QRegularExpression::escape(name)));
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < section.lines.size(); ++i) {
        if (!expression.match(section.lines[i].code()).hasMatch())
            continue;
        if (found)
            return std::nullopt;
        found = i;
    }
    return found;
}

QString assignmentOf(const QString &name)
{
    return QStringLiteral("(?<![\\w.>])%1\\s*=(?!=)").arg(name);
}

/// Returns the changed coordinates of a pair that the code assigns separately, with their lines. Empty if the lines are
/// ambiguous.
std::vector<Placed> coordinates(const CodeSection &section, const sim::LiveValue &live)
{
    const auto *after = std::get_if<sim::Vec2>(&live.value);
    const auto *before = live.before ? std::get_if<sim::Vec2>(&*live.before) : nullptr;
    if (!after || !before || firstLine(section, assignmentOf(QString::fromStdString(live.name))))
        return {};
    const std::array<std::tuple<const char *, double, double>, 2> parts = {
        {{".x", after->x, before->x}, {".y", after->y, before->y}}};
    std::vector<Placed> placed;
    for (const auto &[suffix, now, was] : parts) {
        if (now == was)
            continue;
        const std::string name = live.name + suffix;
        const auto line = onlyAssignment(section, QString::fromStdString(name));
        if (!line)
            return {};
        placed.push_back({*line, {name, now, Value(was)}});
    }
    return placed;
}

std::vector<Placed> placesOf(const CodeSection &section, const sim::LiveValue &live)
{
    std::vector<Placed> placed = coordinates(section, live);
    if (placed.empty()) {
        if (const auto line = lineOf(section, live))
            placed.push_back({*line, live});
    }
    return placed;
}

/// Formats a number with the decimals that suit numbers of `size`.
QString numberAt(double value, double size, int more)
{
    if (value == 0.0)
        return QStringLiteral("0");
    if (!std::isfinite(value)) // overflow past 1.8e308, or its consequences
        return std::isnan(value) ? CodeValuesText::tr("none") : CodeValuesText::tr("too large");
    QString text;
    if (size < 0.0001 || size >= 1e7) {
        text = withoutPadding(QString::number(value, 'e', std::max(0, 1 + more)));
    } else {
        const int decimals = size >= 10.0 ? 1 : size >= 0.1 ? 2 : size >= 0.01 ? 3 : 4;
        const double unit = std::pow(10.0, -(decimals + more));
        const double shown = std::abs(value) < 0.5 * unit ? 0.0 : value; // no minus sign before zeros
        text = QString::number(shown, 'f', decimals + more);
    }
    return text.replace('-', u'−');
}

/// Formats a change such as "−2.29 → −1.49", with enough digits to tell the two apart.
std::pair<QString, QString> shownChange(const Value &before, const Value &after)
{
    int more = 0;
    while (more < 6 && shownValue(before, more) == shownValue(after, more))
        ++more;
    return {shownValue(before, more), shownValue(after, more)};
}

/// Returns the full value with its name and unit, including rounding noise.
QString tipFor(const sim::LiveValue &live, const sim::Phase &phase)
{
    const QString name = QString::fromStdString(live.name);
    const QString its = unitOf(live, phase);
    const QString unit = its.isEmpty() ? QString() : QStringLiteral("\u2009") + its;
    if (live.before && *live.before != live.value) {
        const auto [before, after] = shownChange(*live.before, live.value);
        return CodeValuesText::tr("%1: from %2 to %3%4").arg(name, before, after, unit);
    }
    const QString value = shownValue(live.value);
    return live.before ? CodeValuesText::tr("%1: %2%3, unchanged").arg(name, value, unit)
                       : CodeValuesText::tr("%1: %2%3").arg(name, value, unit);
}

CodeChip chipFor(std::size_t section, const Placed &placed, const sim::Phase &phase, double noise)
{
    CodeChip chip{section, placed.line, {}, {}, tipFor(placed.live, phase)};
    const Value value = withoutNoise(placed.live.value, noise);
    const Value was = placed.live.before ? withoutNoise(*placed.live.before, noise) : value;
    if (was != value) {
        const auto [before, after] = shownChange(was, value);
        chip.text = before + QStringLiteral(" → ") + after;
        chip.shorter = {QStringLiteral("→ ") + after, QStringLiteral("→ ") + shownValue(value, -1)};
        return chip;
    }
    chip.text = shownValue(value);
    chip.shorter = {shownValue(value, -1)};
    return chip;
}

/// Adds a chip. Two chips on one line are merged, with their `name` (if any) before each value.
void put(std::vector<CodeChip> &chips, CodeChip chip, const QString &name, QHash<qsizetype, QString> &names)
{
    const auto named = [](const QString &its, const QString &text) {
        return its.isEmpty() ? text : its + ' ' + text;
    };
    for (std::size_t i = 0; i < chips.size(); ++i) {
        CodeChip &there = chips[i];
        if (there.section != chip.section || there.line != chip.line)
            continue;
        const QString first = names.take(static_cast<qsizetype>(i));
        const QString shorter =
            named(first, there.shorter.first()) + QStringLiteral("  ") + named(name, chip.shorter.first());
        there.text = named(first, there.text) + QStringLiteral("  ") + named(name, chip.text);
        there.shorter = {shorter};
        there.tip += '\n' + chip.tip;
        return;
    }
    names.insert(static_cast<qsizetype>(chips.size()), name);
    chips.push_back(std::move(chip));
}

/// Returns the number of single forces in the sum that a phase computes for `point`.
int pullsOn(const sim::Phase &phase, const sim::ComposedInterval &interval, int point)
{
    return phase.effect ? phase.effect->count(interval.scene.start, {point, 1}) : 0;
}

QString shownParameter(const lessons::Parameter &parameter, double value)
{
    const auto choice = static_cast<qsizetype>(std::lround(value));
    if (choice >= 0 && choice < parameter.choices.size())
        return parameter.choices[choice];
    return QLocale::c().toString(value, 'f', parameter.isInteger ? 0 : parameter.decimals).replace('-', u'−');
}

}

QString shownNumber(double value, int more)
{
    return numberAt(value, std::abs(value), more);
}

QString shownValue(const Value &value, int more)
{
    if (const double *number = std::get_if<double>(&value))
        return shownNumber(*number, more);
    const sim::Vec2 pair = std::get<sim::Vec2>(value);
    const double size = std::max(std::abs(pair.x), std::abs(pair.y));
    return QStringLiteral("(%1, %2)").arg(numberAt(pair.x, size, more), numberAt(pair.y, size, more));
}

double noiseOf(const sim::Scene &scene)
{
    constexpr double ofTheExtent = 1e-12;
    const double extent = scene.start.pointCount() > 0 ? scene.start.position.abs().maxCoeff() : 0.0;
    return ofTheExtent * (extent > 0.0 ? extent : 1.0);
}

Value withoutNoise(const Value &value, double noise)
{
    const auto quiet = [noise](double part) { return std::abs(part) < noise ? 0.0 : part; };
    if (const double *number = std::get_if<double>(&value))
        return quiet(*number);
    const sim::Vec2 pair = std::get<sim::Vec2>(value);
    return sim::Vec2{quiet(pair.x), quiet(pair.y)};
}

std::optional<std::size_t> lineOf(const CodeSection &section, const sim::LiveValue &live)
{
    const QString name = QRegularExpression::escape(QString::fromStdString(live.name));
    for (const QString &pattern : {assignmentOf(name), QStringLiteral("^return\\b.*\\b%1\\b").arg(name),
                                   QStringLiteral("\\b%1\\b").arg(name)}) {
        if (const auto line = firstLine(section, pattern))
            return line;
    }
    return std::nullopt;
}

std::vector<CodeChip> chipsOf(const CodeListing &listing, const std::vector<sim::PhaseExplanation> &moments,
                              const sim::ComposedInterval &interval, int point)
{
    std::vector<CodeChip> chips;
    QHash<qsizetype, QString> names;
    const double noise = noiseOf(interval.scene);
    for (const sim::PhaseExplanation &moment : moments) {
        const auto section = std::find_if(listing.sections.begin(), listing.sections.end(),
                                          [&](const CodeSection &one) { return one.has(moment.phase); });
        if (section == listing.sections.end())
            continue;
        const auto index = static_cast<std::size_t>(section - listing.sections.begin());
        const sim::Phase &phase = interval.pipeline.phases[static_cast<std::size_t>(moment.phase)];
        for (const sim::LiveValue &live : moment.live) {
            for (const Placed &placed : placesOf(*section, live)) {
                CodeChip chip = chipFor(index, placed, phase, noise);
                const int pulls = live.name == "pull" ? pullsOn(phase, interval, point) : 0;
                if (pulls > 1)
                    chip.tip += '\n' + CodeValuesText::tr("The sum of %1 pulls").arg(pulls);
                put(chips, std::move(chip), QString::fromStdString(placed.live.name), names);
            }
        }
    }
    return chips;
}

void dropNext(std::vector<CodeChip> &chips, const CodeListing &listing, int next)
{
    std::erase_if(chips, [&](const CodeChip &chip) { return listing.sections[chip.section].has(next); });
}

std::vector<CodeChip> parameterChips(const CodeListing &listing, const lessons::Step &step,
                                     const sim::Values &values)
{
    static const QRegularExpression reads(
        QStringLiteral("\\bvalues\\s*(?:\\[\\s*\"(\\w+)\"\\s*\\]|\\.integer\\s*\\(\\s*\"(\\w+)\"\\s*\\))"));
    std::vector<CodeChip> chips;
    QHash<qsizetype, QString> names;
    for (std::size_t s = 0; s < listing.sections.size(); ++s) {
        const CodeSection &section = listing.sections[s];
        for (std::size_t i = 0; section.role == CodeSection::Role::scene && i < section.lines.size(); ++i) {
            for (auto found = reads.globalMatch(section.lines[i].code()); found.hasNext();) {
                const QRegularExpressionMatch match = found.next();
                const QString id = match.captured(1) + match.captured(2);
                const lessons::Parameter *parameter = step.parameter(id);
                if (!parameter || !values.has(id.toStdString()))
                    continue;
                const QString value = shownParameter(*parameter, values[id.toStdString()]);
                const QString unit = parameter->unit.isEmpty() ? QString() : u'\u2009' + parameter->unit;
                const QString tip = CodeValuesText::tr("%1: %2%3").arg(parameter->name, value, unit);
                put(chips, {s, i, id + ' ' + value, {value}, tip}, {}, names);
            }
        }
    }
    return chips;
}

}
