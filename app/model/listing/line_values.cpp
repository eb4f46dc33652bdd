#include "app/model/listing/line_values.h"

#include "app/listing/limits.h"
#include "app/model/code/code_values.h"
#include "app/model/listing/assigned_paths.h"
#include "app/model/run/run_program.h"
#include "app/model/text/phrases.h"

#include <QCoreApplication>

#include <algorithm>
#include <map>

namespace app {

namespace {

struct LineValuesText
{
    Q_DECLARE_TR_FUNCTIONS(LineValuesText)
};

/// Returns where the calls around a line are, the outermost first: the line itself comes last.
std::vector<int> callsAround(const ListingFrame &frame, int index)
{
    std::vector<int> lines;
    int depth = frame.line(index).depth + 1;
    for (int i = index; i >= 0 && depth > 0; --i) {
        if (frame.line(i).depth >= depth)
            continue;
        depth = frame.line(i).depth;
        lines.push_back(i);
    }
    std::reverse(lines.begin(), lines.end());
    return lines;
}

/// Returns for each line of the text the line of the frame that ran it last, among the first `index` ones. Those of the
/// calls that are still running come first.
std::map<int, int> lastRuns(const ListingFrame &frame, int index)
{
    const std::vector<int> running = index < frame.count() ? callsAround(frame, index) : std::vector<int>{0};
    const auto isRunning = [&](int i) {
        return std::any_of(running.begin(), running.end(),
                           [&](int line) { return frame.callOf(line) == frame.callOf(i); });
    };
    std::map<int, int> runs;
    for (int i = 0; i < index; ++i) {
        const auto [found, isNew] = runs.try_emplace(frame.line(i).line, i);
        if (!isNew && (isRunning(i) || !isRunning(found->second)))
            found->second = i;
    }
    return runs;
}

/// Returns the value of `path` as the line at `run` has left it: for the last one that ran with all calls in it.
std::optional<listing::Value> valueBehind(const ListingFrame &frame, const QString &path, int run, int index)
{
    return frame.valueOf(path, std::min(index, frame.nextWithin(run, frame.line(run).depth)), run);
}

void addTo(LineChip &chip, const QString &path, const listing::Value &value,
           const std::optional<listing::Value> &before)
{
    const auto append = [](QString &list, const QString &part) {
        list += list.isEmpty() ? part : QStringLiteral(",  ") + part;
    };
    const QString now = shownText(value);
    append(chip.text, path + QStringLiteral(" = ") + now);
    if (chip.shorter.isEmpty())
        chip.shorter = {QString(), QString()};
    append(chip.shorter.front(), now);
    append(chip.shorter.back(), shownText(value, -1));
    const bool isOther = before && before->index() == value.index() && *before != value;
    append(chip.tip, isOther ? LineValuesText::tr("%1: from %2 to %3").arg(path, shownText(*before), now)
                             : labelled(path, now));
}

/// Returns the name of the counter of the loop at `line`: "i" of `for (int i = 0; ...`. Empty if it has none.
std::string counterOf(const listing::Tokens &tokens, int line)
{
    for (std::size_t i = 0; i + 3 < tokens.size(); ++i) {
        if (tokens[i].line == line && tokens.is(i, "for") && tokens.is(i + 1, "(") && tokens.isWord(i + 2))
            return std::string(tokens.isWord(i + 3) ? tokens[i + 3].text : tokens[i + 2].text);
    }
    return {};
}

std::vector<LoopNote> loopNotes(const ListingFrame &frame, int index, const listing::Tokens &tokens)
{
    std::vector<LoopNote> notes;
    for (const listing::LoopTurn &loop : frame.line(index).loops) {
        const QString counter = QString::fromStdString(counterOf(tokens, loop.line));
        const std::optional<listing::Value> value =
            counter.isEmpty() ? std::nullopt : frame.valueOf(counter, index);
        const QString turns = QString::number(loop.turns);
        notes.push_back(
            {loop.line, value ? LineValuesText::tr("%1 = %2 of %3").arg(counter, shownText(*value), turns)
                              : partOf(QString::number(loop.turn), turns)});
    }
    return notes;
}

}

QString shownText(const listing::Value &value, int more)
{
    if (const auto *number = std::get_if<double>(&value))
        return shownNumber(*number, more);
    if (const auto *whole = std::get_if<std::int64_t>(&value))
        return QString::number(*whole).replace('-', u'−');
    if (const auto *truth = std::get_if<bool>(&value))
        return *truth ? QStringLiteral("true") : QStringLiteral("false"); // as in the listing
    if (const auto *vector = std::get_if<sim::Vec2>(&value))
        return shownValue(*vector, more);
    const std::string &name = std::get<listing::BodyReference>(value).name;
    return name.empty() ? LineValuesText::tr("no body") : QString::fromStdString(name);
}

LineValues valuesAfter(const ListingFrame &frame, int index)
{
    LineValues values;
    const listing::Tokens tokens(frame.program().text());
    index = std::clamp(index, 0, frame.count());
    const bool isInside = index < frame.count();
    const std::map<int, int> runs = lastRuns(frame, index);
    const int scope = isInside ? frame.callOf(index) : -1;
    for (const Assignment &one : assignmentsIn(tokens)) {
        const auto found = runs.find(one.line);
        if (one.isInHead || found == runs.end())
            continue;
        const int run = found->second;
        const QString path = QString::fromStdString(one.path);
        const std::optional<listing::Value> value = valueBehind(frame, path, run, index);
        if (!value)
            continue;
        if (values.chips.empty() || values.chips.back().line != one.line)
            values.chips.push_back({one.line, {}, {}, {}, false, !isInside || frame.callOf(run) == scope});
        const std::optional<listing::Value> before = frame.valueOf(path, run, run);
        LineChip &chip = values.chips.back();
        addTo(chip, path, *value, before);
        const bool ranLast = index > 0 && frame.nextWithin(run, frame.line(run).depth) >= index;
        chip.isChanged = chip.isChanged || (isInside && ranLast && (!before || *before != *value));
    }
    if (isInside) {
        values.loops = loopNotes(frame, index, tokens);
        for (const int line : callsAround(frame, index))
            values.calls << QString::fromStdString(frame.line(line).function);
    } else {
        values.calls = {QStringLiteral("frame")};
    }
    if (frame.error() && index >= frame.count() - 1)
        values.message = mistakeSentence(*frame.error());
    else if (!frame.isComplete() && index >= frame.count() - 1)
        values.message = LineValuesText::tr("This frame runs more than %1 lines. The others are not shown.")
                             .arg(listing::maxTracedLines);
    return values;
}

}
