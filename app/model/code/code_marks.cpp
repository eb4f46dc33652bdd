#include "app/model/code/code_marks.h"

#include "app/model/text/phrases.h"
#include "app/model/text/sentences.h"
#include "sim/run/script/composed_interval.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {

namespace {

struct CodeMarksText
{
    Q_DECLARE_TR_FUNCTIONS(CodeMarksText)
};

/// Returns the last line of `section` that `accepts`, if there is one.
template <class Accepts>
std::optional<std::size_t> lastLine(const CodeSection &section, Accepts &&accepts)
{
    for (std::size_t i = section.lines.size(); i-- > 0;) {
        if (accepts(section.lines[i]))
            return i;
    }
    return std::nullopt;
}

/// Returns the line that shows the result of a phase: the formula of its last value. If it has no value for the point,
/// the last formula counts. Summing forces is the same in all methods' effects, so those lines come last.
std::optional<std::size_t> resultOf(const CodeListing &listing, std::size_t section,
                                    const std::vector<CodeChip> &chips)
{
    const CodeSection &its = listing.sections[section];
    const auto isStatement = [](const CodeLine &line) { return line.code().endsWith(';'); };
    for (auto chip = chips.rbegin(); chip != chips.rend(); ++chip) {
        if (chip->section == section && !its.lines[chip->line].isQuiet)
            return chip->line;
    }
    const auto formula =
        lastLine(its, [&](const CodeLine &line) { return isStatement(line) && !line.isQuiet; });
    return formula ? formula : lastLine(its, isStatement);
}

/// Returns the phase of a section to describe: the last completed one, else the one that works on `point`, else the
/// next.
int phaseToMark(const CodeSection &section, const sim::Pipeline &pipeline, int last, int point)
{
    if (section.has(last))
        return last;
    for (int phase : section.phases) {
        if (pipeline.phases[static_cast<std::size_t>(phase)].points.contains(point))
            return phase;
    }
    const auto toCome = std::find_if(section.phases.begin(), section.phases.end(),
                                     [last](int phase) { return phase > last; });
    return toCome == section.phases.end() ? section.phases.back() : *toCome;
}

When whenOf(const CodeSection &section, int phase, int last)
{
    if (phase == last)
        return When::now;
    if (phase < last)
        return When::done;
    return section.has(last + 1) ? When::next : When::later;
}

QString wordFor(When when)
{
    switch (when) {
    case When::done:
        return CodeMarksText::tr("done");
    case When::now:
        return CodeMarksText::tr("now");
    case When::next:
        return CodeMarksText::tr("next");
    case When::plain:
    case When::later:
        break;
    }
    return {};
}

/// Returns the amount of work of a phase: "10 pulls", "6 points".
QString amountOf(const sim::Phase &phase, const sim::ComposedInterval &interval)
{
    const int points = phase.points.count;
    const int count = phase.effect ? phase.effect->count(interval.scene.start, phase.points) : points;
    if (phase.kind == sim::EffectKind::spring)
        return count == 1 ? CodeMarksText::tr("1 pull") : CodeMarksText::tr("%1 pulls").arg(count);
    return pointCount(count);
}

QString noteOf(const SectionMark &mark, const sim::Phase &phase, const sim::ComposedInterval &interval)
{
    QStringList parts = {mark.shortNote};
    if (phase.group >= 0 && interval.scene.groups.size() > 1)
        parts << phrase(interval.scene.groups[static_cast<std::size_t>(phase.group)].title);
    if (mark.when != When::next)
        parts << amountOf(phase, interval);
    return parts.join(QStringLiteral(" · "));
}

}

std::vector<SectionMark> marksOf(const CodeListing &listing, const sim::Timeline &timeline,
                                 const std::vector<CodeChip> &chips, int point)
{
    std::vector<SectionMark> marks(listing.sections.size());
    if (timeline.cursor() == sim::Cursor{})
        return marks;
    const sim::ComposedInterval &interval = timeline.track().interval();
    const sim::Pipeline &pipeline = interval.pipeline;
    const int done = timeline.cursor().phase > 0 ? timeline.cursor().phase : pipeline.phasesPerOutput();
    const int last = (done - 1) % pipeline.phasesPerStep();
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const CodeSection &section = listing.sections[i];
        if (section.role != CodeSection::Role::phase)
            continue;
        SectionMark &mark = marks[i];
        mark.phase = phaseToMark(section, pipeline, last, point);
        const sim::Phase &phase = pipeline.phases[static_cast<std::size_t>(mark.phase)];
        mark.when = whenOf(section, mark.phase, last);
        mark.selected = phase.points.contains(point);
        mark.shortNote = wordFor(mark.when);
        if (!mark.shortNote.isEmpty())
            mark.note = noteOf(mark, phase, interval);
        if (mark.when == When::now)
            mark.result = resultOf(listing, i, chips);
    }
    return marks;
}

}
