#include "app/model/code/code_targets.h"

#include "app/model/text/numbers.h"
#include "app/model/text/quoting.h"
#include "app/model/text/user_error.h"
#include "sim/run/script/composed_interval.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

struct CodeTargetsText
{
    Q_DECLARE_TR_FUNCTIONS(CodeTargetsText)
};

constexpr double slidersWay = 200.0; ///< px
constexpr double choicesWay = 24.0;  ///< px

/// Rounds a number to the decimals of the parameter's field.
double rounded(const lessons::Parameter &parameter, double value)
{
    return QString::number(value, 'f', parameter.isInteger ? 0 : parameter.decimals).toDouble();
}

}

std::optional<sim::Cursor> runTarget(const CodeSection &section, const sim::Timeline &timeline)
{
    if (section.phases.empty())
        return std::nullopt;
    const sim::Track &track = timeline.track();
    const sim::Pipeline &pipeline = track.nextInterval()->pipeline;
    const sim::Cursor at = track.cursor();
    for (int phase = at.phase;; ++phase) {
        const bool isNextRow = phase >= pipeline.phasesPerOutput();
        const int index = phase % pipeline.phasesPerOutput();
        if (!section.has(index % pipeline.phasesPerStep()))
            continue;
        const std::int64_t frame = at.frame + (isNextRow ? track.framesPerOutput() : 0);
        return index + 1 < pipeline.phasesPerOutput() ? sim::Cursor{frame, index + 1}
                                                      : sim::Cursor{frame + track.framesPerOutput(), 0};
    }
}

std::optional<sim::Cursor> momentOf(const CodeSection &section, const sim::Timeline &timeline)
{
    if (section.phases.empty())
        return std::nullopt;
    const sim::Cursor at = timeline.cursor();
    const int perStep = timeline.track().nextInterval()->pipeline.phasesPerStep();
    const int stepStart = at.phase > 0 ? (at.phase - 1) / perStep * perStep : 0;
    int after = perStep;
    for (int phase = 0; phase < perStep; ++phase) {
        const bool isDone = stepStart + phase < at.phase;
        if (section.has(phase) && (isDone || after == perStep))
            after = phase + 1;
    }
    return sim::Cursor{at.frame, stepStart + after};
}

double draggedValue(const lessons::Parameter &parameter, double from, double way)
{
    if (!parameter.choices.isEmpty())
        return std::clamp(from + std::round(way / choicesWay), parameter.min, parameter.max);
    double value = from + way / slidersWay * (parameter.sliderMax - parameter.sliderMin);
    if (parameter.scale == lessons::Scale::logarithmic && from > 0.0 && parameter.sliderMin > 0.0)
        value = from * std::pow(parameter.sliderMax / parameter.sliderMin, way / slidersWay);
    return way == 0.0 ? from : std::clamp(rounded(parameter, value), parameter.min, parameter.max);
}

double typedValue(const lessons::Parameter &parameter, const QString &text)
{
    const QString plain = QString(text).replace(QChar(0x2212), '-').replace(',', '.').trimmed();
    const qsizetype choice = parameter.choices.indexOf(text.trimmed());
    if (choice >= 0)
        return static_cast<double>(choice);
    if (!parameter.choices.isEmpty())
        throw UserError(CodeTargetsText::tr("%1 can be %2, but not %3.")
                            .arg(parameter.name, quotedList(parameter.choices, text), quoted(text)));
    bool isNumber = false;
    const double value = QLocale::c().toDouble(plain, &isNumber);
    const bool fits = isNumber && std::isfinite(value) && value >= parameter.min && value <= parameter.max;
    if (!fits || (parameter.isInteger && value != std::round(value)))
        throw UserError((parameter.isInteger
                             ? CodeTargetsText::tr("%1 can be a whole number from %2 to %3, but not %4.")
                             : CodeTargetsText::tr("%1 can be a number from %2 to %3, but not %4."))
                            .arg(parameter.name, writtenNumber(parameter.min, 0),
                                 writtenNumber(parameter.max, 0), quoted(text)));
    return value;
}

QString typedText(const lessons::Parameter &parameter, double value)
{
    const auto choice = static_cast<qsizetype>(std::lround(value));
    if (choice >= 0 && choice < parameter.choices.size())
        return parameter.choices[choice];
    return writtenNumber(value, parameter.isInteger ? 0 : parameter.decimals);
}

}
