// What a learner changes at the cursor.

#include "app/model/sentences.h"
#include "app/model/session.h"
#include "app/model/step_words.h"
#include "lessons/api/parameter.h"
#include "sim/base/error.h"
#include "sim/methods/methods.h"
#include "sim/run/script/composed_interval.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

/// A parameter and a value of it, for the name of a ghost.
QString written(const lessons::Parameter &parameter, double value)
{
    const QStringList &titles = parameter.choiceTitles.isEmpty() ? parameter.choices : parameter.choiceTitles;
    if (!titles.isEmpty())
        return QStringLiteral("%1 %2").arg(parameter.name,
                                           lessons::withoutGroup(titles.value(static_cast<int>(value))));
    return QStringLiteral("%1 %2").arg(parameter.id, QLocale().toString(value, 'g', 4));
}

/// The way in which `script` was computed before `method` took its place: its step, or its method.
QString written(const sim::Script &script, const sim::Method &method)
{
    return script.method->id() == method.id() ? stepTitle(script.step) : phrase(script.method->title());
}

/// A body that was taken, carried and let go.
Deed handDeed(const QString &body)
{
    const QString hand = Session::tr("your hand");
    return {Session::tr("Drag %1").arg(bodyTitle(body)), hand, QStringLiteral(":hand"), hand};
}

}

double Session::parameter(const QString &id) const
{
    return m_timeline->values()[id.toStdString()];
}

void Session::setParameter(const QString &id, double value)
{
    const lessons::Parameter *declared = step().parameter(id);
    if (!declared)
        return;
    value = std::clamp(value, declared->min, declared->max);
    if (declared->isInteger)
        value = std::round(value);
    const double was = parameter(id);
    if (value == was)
        return;
    if (declared->restartsRun) {
        sim::Values values = step().defaultValues();
        values.set(id.toStdString(), value);
        startAnew({tr("Change %1").arg(withinSentence(declared->name)), declared->name, {}, declared->name},
                  values, {m_timeline->script().method, sim::findMethod(step().method.toStdString())});
        return;
    }
    edit({tr("Change %1").arg(withinSentence(declared->name)), written(*declared, was), id,
          written(*declared, value)},
         [&](sim::Timeline &timeline) { return timeline.setParameter(id.toStdString(), value); });
}

void Session::resetParameters()
{
    const std::vector<lessons::Parameter> &all = step().parameters;
    if (std::all_of(all.begin(), all.end(),
                    [this](const auto &one) { return parameter(one.id) == one.defaultValue; }))
        return;
    m_deeds.beginMacro(tr("Reset all parameters"));
    for (const lessons::Parameter &one : all)
        setParameter(one.id, one.defaultValue);
    m_deeds.endMacro();
}

void Session::setMethod(const QString &id)
{
    const sim::MethodPtr method = sim::findMethod(id.toStdString());
    const sim::Script &script = m_timeline->script();
    if (!method || method->id() == script.method->id())
        return;
    const sim::StepSize usual = sim::stepFor(*method, script.step);
    use(method, usual == script.step ? usual : m_otherStep.value_or(usual));
}

void Session::use(const sim::MethodPtr &method, sim::StepSize step)
{
    const sim::Script &now = m_timeline->script();
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

std::optional<sim::DampRange> Session::damping() const
{
    const lessons::Parameter *kept = step().parameterFor(lessons::ParameterRole::damping);
    if (!kept)
        return std::nullopt;
    return sim::DampRange{kept->id.toStdString(), kept->min, std::pow(10.0, -kept->decimals)};
}

std::optional<sim::IterationRange> Session::passes() const
{
    const lessons::Parameter *passes = step().parameterFor(lessons::ParameterRole::iterations);
    return passes ? std::optional(sim::IterationRange{passes->id.toStdString(), passes->max}) : std::nullopt;
}

void Session::use(const sim::Remedy &remedy)
{
    const std::optional<sim::Stop> &stop = m_timeline->stop();
    // What sticks are like comes from the whole way: passes changed from here on would not mend what is behind.
    if ((stop && m_timeline->cursor().frame == stop->frame) ||
        remedy.kind == sim::Remedy::Kind::moreIterations)
        runAgain(remedy);
    else if (remedy.kind == sim::Remedy::Kind::moreDamping)
        setParameter(QString::fromStdString(remedy.parameter), remedy.value);
    else
        use(remedy.method, remedy.step);
}

void Session::runAgain(const sim::Remedy &remedy)
{
    pause();
    const std::int64_t frame = m_timeline->cursor().frame;
    const lessons::Parameter *changed =
        remedy.setsParameter() ? step().parameter(QString::fromStdString(remedy.parameter)) : nullptr;
    const QString was =
        changed ? written(*changed, parameter(changed->id)) : written(m_timeline->script(), *remedy.method);
    m_timeline->seek({}); // the way to that frame may be long: goTo() takes it in slices
    edit({tr("Apply remedy"), was, {}, tr("a remedy")}, [&](sim::Timeline &timeline) {
        const sim::StepSize step = timeline.script().step;
        const bool forked = timeline.replaceScript(sim::withRemedy(timeline.script(), remedy));
        if (step.isAdaptive() != timeline.script().step.isAdaptive())
            m_otherStep = step;
        return forked;
    });
    goTo({frame, 0});
}

void Session::setStep(sim::StepSize step)
{
    use(m_timeline->script().method, step);
}

void Session::setStepSize(double h)
{
    try {
        setStep(sim::StepSize::ofLength(h));
    } catch (const sim::Error &error) {
        emit said(sentenceFor(error));
    }
}

void Session::setTolerance(double tolerance)
{
    try {
        setStep(sim::StepSize::withTolerance(tolerance));
    } catch (const sim::Error &error) {
        emit said(sentenceFor(error));
    }
}

void Session::grab(const QString &body)
{
    if (m_timeline->track().interval().scene.find(body.toStdString()) < 0)
        return;
    select(body);
    m_holding = true;
    edit(handDeed(body),
         [&](sim::Timeline &timeline) { return timeline.applyInput(sim::Grab{body.toStdString()}); });
}

void Session::moveHand(sim::Vec2 to)
{
    if (!m_holding || !std::isfinite(to.x) || !std::isfinite(to.y))
        return;
    edit(handDeed(m_selected), [&](sim::Timeline &timeline) { return timeline.applyInput(sim::Move{to}); });
}

void Session::letGo()
{
    if (!m_holding)
        return;
    m_holding = false;
    edit(handDeed(m_selected), [](sim::Timeline &timeline) { return timeline.applyInput(sim::Release{}); });
    endGesture();
}

void Session::point(sim::Vec2 at, bool down)
{
    if (!step().accepts(lessons::Interaction::pointer) || !std::isfinite(at.x) || !std::isfinite(at.y))
        return;
    m_pointerDown = down ? std::optional(at) : std::nullopt;
    edit({tr("Move pointer"), tr("the pointer"), QStringLiteral(":pointer"), tr("the pointer")},
         [&](sim::Timeline &timeline) {
             return timeline.applyInput(sim::Pointer{at, down});
         });
    if (!down)
        endGesture();
}

void Session::aim(sim::Vec2 target)
{
    if (!step().accepts(lessons::Interaction::target) || !std::isfinite(target.x) || !std::isfinite(target.y))
        return;
    edit({tr("Set target"), tr("the target"), {}, tr("the target")},
         [&](sim::Timeline &timeline) { return timeline.applyInput(sim::Target{target}); });
}

void Session::steer(bool sim::Keys::*key, bool down)
{
    if (!step().accepts(lessons::Interaction::keys) || m_keys.*key == down)
        return;
    m_keys.*key = down;
    edit({tr("Press arrow keys"), tr("the keys"), QStringLiteral(":keys"), tr("the keys")},
         [&](sim::Timeline &timeline) {
             return timeline.applyInput(sim::Key{key, down});
         });
    if (m_keys == sim::Keys{})
        endGesture();
}

void Session::letUp()
{
    for (const auto key : {&sim::Keys::left, &sim::Keys::right, &sim::Keys::up, &sim::Keys::down})
        steer(key, false);
    if (m_pointerDown)
        point(*m_pointerDown, false);
}

void Session::startWith(const lessons::Preset &preset)
{
    sim::Values values = step().defaultValues();
    for (const auto &[id, value] : preset.values)
        values.set(id.toStdString(), value);
    startAnew({tr("Choose “%1”").arg(preset.title), preset.title, {}, preset.title}, values,
              {sim::findMethod(step().method.toStdString())});
}

void Session::startAnew(const Deed &deed, const sim::Values &values,
                        const std::vector<sim::MethodPtr> &methods)
{
    for (const sim::MethodPtr &method : methods) {
        try {
            startAnew(deed, step().scriptWith(values, method));
            return;
        } catch (const sim::Error &error) {
            emit said(sentenceFor(error)); // another method may be able to
        }
    }
}

void Session::startAnew(const Deed &deed, sim::Script script)
{
    const bool played = isPlaying();
    Stand before = stand();
    const std::int64_t computed = m_timeline->computed();
    pause();
    start(std::move(script), {}, m_branches);
    if (std::max(computed, before.branches.own().end) > 0)
        branchOff(before, computed, deed);
    nameOwn(deed);
    m_branches.settle(m_timeline->script());
    remember(deed, std::move(before));
    emit runChanged();
    if (played)
        play();
}

}
