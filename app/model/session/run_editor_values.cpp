// Edits of parameters, method, step size and effects.

#include "app/model/catalog/lists.h"
#include "app/model/session/run_editor.h"
#include "app/model/text/numbers.h"
#include "app/model/text/sentences.h"
#include "app/model/text/step_text.h"
#include "lessons/api/parameter.h"
#include "sim/base/error.h"
#include "sim/methods/methods.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

/// Returns a parameter with a value, as part of the name of a run.
QString written(const lessons::Parameter &parameter, double value)
{
    const QStringList &titles = parameter.choiceTitles.isEmpty() ? parameter.choices : parameter.choiceTitles;
    if (!titles.isEmpty())
        return QStringLiteral("%1 %2").arg(parameter.name,
                                           lessons::withoutGroup(titles.value(static_cast<int>(value))));
    // Four figures, but no power of ten for a large number.
    const double said = std::abs(value) < 1000.0 ? QString::number(value, 'g', 4).toDouble() : value;
    return QStringLiteral("%1 %2").arg(withinSentence(parameter.name), writtenNumber(said, 0));
}

/// Returns what `method` replaces in `script`: the step size, or the method.
QString written(const sim::Script &script, const sim::Method &method)
{
    return script.method->id() == method.id() ? stepTitle(script.step) : phrase(script.method->title());
}

}

double RunEditor::parameter(const QString &id) const
{
    return m_run.timeline().values()[id.toStdString()];
}

void RunEditor::setParameter(const QString &id, double value)
{
    const lessons::Parameter *declared = m_run.step().parameter(id);
    if (!declared)
        return;
    value = std::clamp(value, declared->min, declared->max);
    if (declared->isInteger)
        value = std::round(value);
    const double was = parameter(id);
    if (value == was)
        return;
    if (declared->restartsRun) {
        sim::Values values = m_run.step().defaultValues();
        values.set(id.toStdString(), value);
        startAnew({tr("Change %1").arg(withinSentence(declared->name)), declared->name, {}, declared->name},
                  values,
                  {m_run.timeline().script().method, sim::findMethod(m_run.step().method.toStdString())});
        return;
    }
    edit({tr("Change %1").arg(withinSentence(declared->name)), written(*declared, was), id,
          written(*declared, value)},
         [&](sim::Timeline &timeline) { return timeline.setParameter(id.toStdString(), value); });
}

void RunEditor::resetParameters()
{
    const std::vector<lessons::Parameter> &all = m_run.step().parameters;
    if (std::all_of(all.begin(), all.end(),
                    [this](const auto &one) { return parameter(one.id) == one.defaultValue; }))
        return;
    const ChangeNotifier::Batch batch(m_run.changes());
    m_history.stack().beginMacro(tr("Reset all parameters"));
    for (const lessons::Parameter &one : all)
        setParameter(one.id, one.defaultValue);
    m_history.stack().endMacro();
}

void RunEditor::setMethod(const QString &id)
{
    const sim::MethodPtr method = sim::findMethod(id.toStdString());
    const sim::Script &script = m_run.timeline().script();
    if (!method || method->id() == script.method->id())
        return;
    const sim::StepSize usual = sim::stepFor(*method, script.step);
    use(method, usual == script.step ? usual : m_otherStep.value_or(usual));
}

void RunEditor::use(const sim::MethodPtr &method, sim::StepSize step)
{
    const sim::Script &now = m_run.timeline().script();
    const sim::MethodPtr wasMethod = now.method;
    const sim::StepSize was = now.step;
    const bool sameMethod = method->id() == wasMethod->id();
    if (sameMethod && step == was)
        return;
    const QString after = sameMethod ? stepTitle(step) : phrase(method->title());
    edit({sameMethod ? tr("Change step") : tr("Change method"), written(now, *method), {}, after},
         [&](sim::Timeline &timeline) {
             sim::Script script = timeline.script();
             script.method = method;
             script.step = step;
             const bool forked = timeline.replaceScript(std::move(script));
             if (was.isAdaptive() != step.isAdaptive())
                 m_otherStep = was;
             return forked;
         });
}

std::optional<sim::DampRange> RunEditor::damping() const
{
    const lessons::Parameter *kept = m_run.step().parameterFor(lessons::ParameterRole::damping);
    if (!kept)
        return std::nullopt;
    return sim::DampRange{kept->id.toStdString(), kept->min, std::pow(10.0, -kept->decimals)};
}

std::optional<sim::IterationRange> RunEditor::passes() const
{
    const lessons::Parameter *passes = m_run.step().parameterFor(lessons::ParameterRole::iterations);
    return passes ? std::optional(sim::IterationRange{passes->id.toStdString(), passes->max}) : std::nullopt;
}

void RunEditor::use(const sim::Remedy &remedy)
{
    const std::optional<sim::Stop> &stop = m_run.timeline().stop();
    // The shape of sticks results from the whole run: more passes from here on would not repair it.
    if ((stop && m_run.timeline().cursor().frame == stop->frame) ||
        remedy.kind == sim::Remedy::Kind::moreIterations)
        runAgain(remedy);
    else if (remedy.kind == sim::Remedy::Kind::moreDamping)
        setParameter(QString::fromStdString(remedy.parameter), remedy.value);
    else
        use(remedy.method, remedy.step);
}

void RunEditor::runAgain(const sim::Remedy &remedy)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    m_playback.pause();
    const std::int64_t frame = m_run.timeline().cursor().frame;
    const lessons::Parameter *changed =
        remedy.setsParameter() ? m_run.step().parameter(QString::fromStdString(remedy.parameter)) : nullptr;
    const QString was = changed ? written(*changed, parameter(changed->id))
                                : written(m_run.timeline().script(), *remedy.method);
    m_run.timeline().seek({}); // that frame may be far away: goTo() computes in slices
    edit({tr("Apply remedy"), was, {}, tr("a remedy")}, [&](sim::Timeline &timeline) {
        const sim::StepSize step = timeline.script().step;
        const bool forked = timeline.replaceScript(sim::withRemedy(timeline.script(), remedy));
        if (step.isAdaptive() != timeline.script().step.isAdaptive())
            m_otherStep = step;
        return forked;
    });
    m_playback.goTo({frame, 0});
}

void RunEditor::setStep(sim::StepSize (*make)(double), double value)
{
    try {
        use(m_run.timeline().script().method, make(value));
    } catch (const sim::Error &error) {
        m_run.showMessage(sentenceFor(error));
    }
}

void RunEditor::setStepSize(double h)
{
    setStep(sim::StepSize::ofLength, h);
}

void RunEditor::setTolerance(double tolerance)
{
    setStep(sim::StepSize::withTolerance, tolerance);
}

std::vector<sim::EffectPtr> RunEditor::listedEffects() const
{
    const sim::Script &script = m_run.timeline().script();
    const sim::ComposedInterval &interval = *m_run.timeline().track().nextInterval();
    return script.effectsOff.empty() ? interval.scene.effects : script.build(interval.values).effects;
}

bool RunEditor::isOff(const QString &effect) const
{
    const std::vector<std::string> &off = m_run.timeline().script().effectsOff;
    return contains(off, effect.toStdString());
}

void RunEditor::setEffect(const QString &id, bool on)
{
    const std::vector<sim::EffectPtr> listed = listedEffects();
    const auto found = std::find_if(listed.begin(), listed.end(),
                                    [&](const sim::EffectPtr &one) { return one->id() == id.toStdString(); });
    if (found == listed.end() || isOff(id) != on)
        return;
    const QString title = capitalised(phrase((*found)->title()));
    const QString was = on ? tr("%1 off").arg(title) : tr("%1 on").arg(title);
    edit({on ? tr("%1 on").arg(title) : tr("%1 off").arg(title), was}, [&](sim::Timeline &timeline) {
        sim::Script script = timeline.script();
        script.effectsOff.clear(); // in the scene's order, however they were switched
        for (const sim::EffectPtr &one : listed) {
            const QString other = QString::fromStdString(one->id());
            const bool known = contains(script.effectsOff, one->id());
            if (!known && (other == id ? !on : isOff(other)))
                script.effectsOff.push_back(one->id());
        }
        return timeline.replaceScript(std::move(script));
    });
}

}
