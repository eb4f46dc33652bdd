#include "app/model/code/code_symbols.h"

#include "app/model/code/code_meanings.h"
#include "app/model/text/sentences.h"
#include "sim/run/script/composed_interval.h"

#include <QHash>
#include <QRegularExpression>

#include <algorithm>

namespace app {

namespace {

/// Returns the id of a class name: "radial_spring" for "RadialSpring".
QString idOf(QString className)
{
    static const QRegularExpression capital(QStringLiteral("(?<!^)([A-Z])"));
    return className.replace(capital, QStringLiteral("_\\1")).toLower();
}

/// How the set-up uses parameters.
struct SetUp
{
    QHash<QString, QString> names;      ///< variables and their members, with the parameter that each holds
    QHash<QString, QStringList> handed; ///< words passed to each effect's constructor, by the effect's id
};

/// Returns the variable or member that a line sets to exactly one parameter.
std::optional<std::pair<QString, QString>> readInto(const QString &code, const std::vector<CodeWord> &words)
{
    static const QRegularExpression sets(
        QStringLiteral("^(?:const )?(?:double |int |bool |auto )?([\\w.]+) = "));
    const QRegularExpressionMatch match = sets.match(code);
    const auto reads = std::find_if(words.begin(), words.end(),
                                    [](const CodeWord &word) { return !word.parameter.isEmpty(); });
    if (!match.hasMatch() || reads == words.end())
        return std::nullopt;
    const QString rest = code.mid(match.capturedEnd());
    if (rest.size() != reads->length + 1 || !rest.endsWith(';'))
        return std::nullopt;
    return std::pair(match.captured(1), reads->parameter);
}

SetUp readSetUp(const CodeSection &section)
{
    SetUp setUp;
    static const QRegularExpression adds(QStringLiteral("\\badd<(\\w+)>\\(scene(.*?)\\);"));
    QString all;
    for (const CodeLine &line : section.lines) {
        const QString code = line.code();
        if (const auto read = readInto(code, wordsOf(code)))
            setUp.names.insert(read->first, read->second);
        all += code + ' ';
    }
    for (auto found = adds.globalMatch(all); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        QStringList &handed = setUp.handed[idOf(match.captured(1))];
        for (const CodeWord &word : wordsOf(match.captured(2)))
            handed << word.name;
    }
    return setUp;
}

/// Returns the line after the last one of the region that starts at line `first`.
std::size_t endOfRegion(const CodeSection &section, std::size_t first)
{
    std::size_t end = first + 1;
    while (end < section.lines.size() && section.lines[end].file == section.lines[first].file &&
           section.lines[end].source.number == section.lines[end - 1].source.number + 1)
        ++end;
    return end;
}

/// Returns whether `name` is an argument of a function in the region and is never assigned there.
bool isGiven(const CodeSection &section, std::size_t first, std::size_t end, const QString &name)
{
    const QString plain = QRegularExpression::escape(name.section('.', 0, 0));
    const QRegularExpression given(
        QStringLiteral("\\b(?:double |int |const [\\w:]+ &)%1\\s*[,)]").arg(plain));
    const QRegularExpression set(
        QStringLiteral("(?<![\\w.])%1\\s*[-+*/]?=(?!=)").arg(QRegularExpression::escape(name)));
    bool isGiven = false;
    for (std::size_t i = first; i < end; ++i) {
        const QString code = section.lines[i].code();
        if (set.match(code).hasMatch())
            return false;
        isGiven = isGiven || given.match(code).hasMatch();
    }
    return isGiven;
}

/// Returns all numbers that the phase can report for `point`, by treating everything in its state as changed.
std::vector<sim::LiveValue> liveOf(const sim::Phase &phase, const sim::ComposedInterval &interval, int point)
{
    const sim::State &start = interval.scene.start;
    sim::State after = start;
    after.place(point, start.positionOf(point) + sim::Vec2{1.0, 1.0});
    after.setVelocity(point, start.velocityOf(point) + sim::Vec2{1.0, 1.0});
    return phase.explain(start, after, point);
}

/// Returns the names of the numbers that the phase computes itself.
QStringList computedBy(const sim::Phase &phase, const sim::ComposedInterval &interval)
{
    QStringList names;
    if (phase.points.count == 0)
        return names;
    for (const sim::LiveValue &live : liveOf(phase, interval, phase.points.first))
        names << QString::fromStdString(live.name);
    return names;
}

/// Returns the names that stand for a parameter in a phase's code, with its id.
QHash<QString, QString> namesIn(const CodeSection &section, const SetUp &setUp,
                                const sim::ComposedInterval &interval)
{
    QHash<QString, QString> names;
    const sim::Phase &phase = interval.pipeline.phases[static_cast<std::size_t>(section.phases.front())];
    if (!phase.effect)
        return names;
    const QStringList handed = setUp.handed.value(QString::fromStdString(phase.effect->id()));
    const QStringList computed = computedBy(phase, interval);
    for (auto it = setUp.names.begin(); it != setUp.names.end(); ++it) {
        if (handed.contains(it.key().section('.', 0, 0)) && !computed.contains(it.key()))
            names.insert(it.key(), it.value());
    }
    return names;
}

void addPhaseSpots(std::vector<ParameterSpot> &spots, const CodeListing &listing, std::size_t s,
                   const QHash<QString, QString> &names)
{
    const CodeSection &section = listing.sections[s];
    for (std::size_t first = 0; first < section.lines.size();) {
        const std::size_t end = endOfRegion(section, first);
        for (std::size_t i = first; i < end; ++i) {
            for (CodeWord &word : wordsOf(section.lines[i].source.text)) {
                if (!names.contains(word.name) || !isGiven(section, first, end, word.name))
                    continue;
                word.parameter = names[word.name];
                spots.push_back({s, i, word});
            }
        }
        first = end;
    }
}

void addSetUpSpots(std::vector<ParameterSpot> &spots, const CodeListing &listing, std::size_t s,
                   const SetUp &setUp, const lessons::Step &step)
{
    const CodeSection &section = listing.sections[s];
    for (std::size_t i = 0; i < section.lines.size(); ++i) {
        for (CodeWord &word : wordsOf(section.lines[i].source.text)) {
            if (word.parameter.isEmpty())
                word.parameter = setUp.names.value(word.name);
            if (step.parameter(word.parameter))
                spots.push_back({s, i, word});
        }
    }
}

CodeSymbol parameterSymbol(const CodeWord &word, const lessons::Parameter &parameter)
{
    return {word.name, capitalised(parameter.name), parameter.unit, parameter.help, parameter.id, -1};
}

}

std::vector<CodeWord> wordsOf(const QString &line)
{
    static const QRegularExpression tokens(QStringLiteral(
        R"re(//.*|\bvalues\s*(?:\[\s*"(\w+)"\s*\]|\.integer\s*\(\s*"(\w+)"\s*\))|"(?:\\.|[^"\\])*"|\d[\d.']*(?:e[+-]?\d+)?\w*|([A-Za-z_]\w*(?:\.[A-Za-z_]\w*)*)(?![\w.]*(?:<|\s*\(|::)))re"));
    std::vector<CodeWord> words;
    for (auto found = tokens.globalMatch(line); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const QString parameter = match.captured(1) + match.captured(2);
        if (!parameter.isEmpty() || !match.captured(3).isEmpty())
            words.push_back({match.capturedStart(), match.capturedLength(), match.captured(), parameter});
    }
    return words;
}

std::vector<ParameterSpot> parameterSpots(const CodeListing &listing, const lessons::Step &step,
                                          const sim::ComposedInterval &interval)
{
    std::vector<ParameterSpot> spots;
    SetUp setUp;
    for (std::size_t s = 0; s < listing.sections.size(); ++s) {
        const CodeSection &section = listing.sections[s];
        if (section.role == CodeSection::Role::scene) {
            setUp = readSetUp(section);
            addSetUpSpots(spots, listing, s, setUp, step);
        } else if (section.role == CodeSection::Role::phase) {
            addPhaseSpots(spots, listing, s, namesIn(section, setUp, interval));
        }
    }
    std::erase_if(spots, [&](const ParameterSpot &spot) { return !step.parameter(spot.word.parameter); });
    return spots;
}

QString unitOf(const sim::LiveValue &live, const sim::Phase &phase)
{
    const bool isNumber = std::holds_alternative<double>(live.value);
    if (isNumber && (live.name == "x" || live.name == "v")) // of what turns
        return live.name == "x" ? QStringLiteral("°") : QStringLiteral("°/frame");
    if (live.name == "pull" && dynamic_cast<const sim::Torque *>(phase.effect.get()))
        return QStringLiteral("°/frame²");
    return meaningOf(QString::fromStdString(live.name), phase).unit;
}

std::optional<CodeSymbol> symbolAt(const CodeListing &listing, std::size_t section, std::size_t line,
                                   qsizetype column, const std::vector<ParameterSpot> &spots,
                                   const lessons::Step &step, const sim::ComposedInterval &interval,
                                   int point)
{
    for (const ParameterSpot &spot : spots) {
        if (spot.section == section && spot.line == line && spot.word.contains(column))
            return parameterSymbol(spot.word, *step.parameter(spot.word.parameter));
    }
    const CodeSection &its = listing.sections[section];
    const std::vector<CodeWord> words = wordsOf(its.lines[line].source.text);
    const auto word = std::find_if(words.begin(), words.end(),
                                   [column](const CodeWord &one) { return one.contains(column); });
    if (its.role != CodeSection::Role::phase || word == words.end())
        return std::nullopt;
    // If the same phase runs for several groups, use the one that works on the point.
    const auto works = [&](int one) {
        return interval.pipeline.phases[static_cast<std::size_t>(one)].points.contains(point);
    };
    const auto found = std::find_if(its.phases.begin(), its.phases.end(), works);
    const int phase = found == its.phases.end() ? its.phases.front() : *found;
    const sim::Phase &runs = interval.pipeline.phases[static_cast<std::size_t>(phase)];
    const int asked = runs.points.contains(point) ? point : runs.points.first;
    if (runs.points.count == 0)
        return std::nullopt;
    const QString whole = word->name.section('.', 0, 0);
    for (const sim::LiveValue &live : liveOf(runs, interval, asked)) {
        const QString name = QString::fromStdString(live.name);
        const bool isPart = std::holds_alternative<sim::Vec2>(live.value) &&
                            (word->name == name + ".x" || word->name == name + ".y");
        if (word->name != name && !isPart)
            continue;
        return CodeSymbol{word->name, word->name, unitOf(live, runs), meaningOf(whole, runs).what, {}, phase};
    }
    return std::nullopt;
}

}
