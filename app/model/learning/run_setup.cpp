#include "app/model/learning/run_setup.h"

#include "app/model/breakpoints/condition_names.h"
#include "app/model/text/user_error.h"
#include "sim/methods/methods.h"

#include <QCoreApplication>

#include <cmath>

namespace app {

namespace {

struct RunSetupText
{
    Q_DECLARE_TR_FUNCTIONS(RunSetupText)
};

QString idsOfParameters(const lessons::Step &step)
{
    QStringList ids;
    for (const lessons::Parameter &parameter : step.parameters)
        ids << parameter.id;
    return ids.join(QStringLiteral(", "));
}

QString idsOfMethods()
{
    QStringList ids;
    for (const sim::MethodPtr &method : sim::allMethods())
        ids << QString::fromStdString(method->id());
    return ids.join(QStringLiteral(", "));
}

/// Returns the value of a parameter as a document writes it.
double valueOf(const lessons::Parameter &parameter, const QString &text)
{
    if (!parameter.choices.isEmpty()) {
        const qsizetype index = parameter.choices.indexOf(text);
        if (index < 0)
            throw UserError(
                RunSetupText::tr("%1 cannot be %2. It can be: %3.")
                    .arg(parameter.id, quoted(text), parameter.choices.join(QStringLiteral(", "))));
        return static_cast<double>(index);
    }
    bool isNumber = false;
    const double value = text.toDouble(&isNumber);
    const bool fits = isNumber && value >= parameter.min && value <= parameter.max;
    if (!fits || (parameter.isInteger && value != std::floor(value)))
        throw UserError(
            RunSetupText::tr("%1 cannot be %2. It can be a number from %3 to %4.")
                .arg(parameter.id, quoted(text), exactNumber(parameter.min), exactNumber(parameter.max)));
    return value;
}

int pointIn(const sim::Scene &scene, const QString &body)
{
    const int point = scene.find(body.toStdString());
    if (point < 0)
        throw UserError(RunSetupText::tr("There is no body %1 here; there are %2.")
                            .arg(quoted(body), condition_names::someOf(condition_names::bodiesOf(scene))));
    return point;
}

/// Returns the place of a body when the hand takes it, px.
sim::Vec2 placeAt(const sim::Script &script, const QString &body, std::int64_t frame)
{
    sim::Track track(script, 0);
    const int point = pointIn(track.interval().scene, body);
    track.seek({frame, 0});
    return track.state().positionOf(point);
}

void addDrags(const std::vector<lessons::RunSetup::Drag> &drags, sim::Script &script)
{
    std::int64_t begin = 0;
    for (const lessons::RunSetup::Drag &drag : drags) {
        const sim::Vec2 from = placeAt(script, drag.body, begin);
        script.input.push_back({begin, sim::Grab{drag.body.toStdString()}});
        for (int i = 1; i <= drag.frames; ++i) {
            const double share = static_cast<double>(i) / drag.frames;
            script.input.push_back({begin + i, sim::Move{from + share * (drag.to - from)}});
        }
        begin += drag.frames + 1;
        script.input.push_back({begin, sim::Release{}});
        sim::sortByFrame(script.input);
    }
}

void addInput(const lessons::RunSetup &setup, sim::Script &script)
{
    if (setup.press) {
        script.input.push_back({0, sim::Pointer{setup.press->at, true}});
        script.input.push_back({setup.press->frames, sim::Pointer{setup.press->at, false}});
    }
    if (setup.click)
        script.input.push_back({0, sim::Target{*setup.click}});
    sim::sortByFrame(script.input);
    addDrags(setup.drags, script);
}

}

const lessons::Step *stepCalled(const QString &name, const LessonLibrary &library)
{
    const LessonEntry *lesson = library.lesson(name.section('/', 0, 0));
    return lesson ? lesson->step(name.section('/', 1)) : nullptr;
}

sim::Script scriptFor(const lessons::RunSetup &setup, const lessons::Step &step)
{
    return scriptWith(setup, step, step.script());
}

sim::Script scriptWith(const lessons::RunSetup &setup, const lessons::Step &step, sim::Script script)
{
    for (const auto &[id, text] : setup.values) {
        const lessons::Parameter *parameter = step.parameter(id);
        if (!parameter)
            throw UserError(RunSetupText::tr("There is no parameter %1 here; there are %2.")
                                .arg(quoted(id), idsOfParameters(step)));
        script.values.set(id.toStdString(), valueOf(*parameter, text));
    }
    if (!setup.method.isEmpty()) {
        const sim::MethodPtr method = sim::findMethod(setup.method.toStdString());
        if (!method)
            throw UserError(RunSetupText::tr("There is no method %1; the methods are %2.")
                                .arg(quoted(setup.method), idsOfMethods()));
        script.method = method;
        script.step = sim::stepFor(*method, script.step);
    }
    const sim::Scene scene = sim::sceneOf(script, script.values);
    for (const lessons::RunSetup::Place &place : setup.places) {
        const lessons::Parameter *parameter = step.parameter(place.body);
        if (parameter && scene.find(place.body.toStdString()) < 0) // "1,2" with a decimal comma
            valueOf(*parameter, exactNumber(place.at.x) + ',' + exactNumber(place.at.y));
        pointIn(scene, place.body);
        script.bodies[place.body.toStdString()] = {place.at, {}};
    }
    addInput(setup, script);
    return script;
}

bool FollowedRun::advance()
{
    const std::int64_t before = frame();
    m_track.seek({before + m_track.framesPerOutput(), 0});
    return frame() > before;
}

int FollowedRun::point(const QString &body) const
{
    return pointIn(scene(), body);
}

ConditionNames FollowedRun::names() const
{
    return {scene(), m_track.interval().values, m_track.interval().pipeline,
            condition_names::choicesOf(m_step)};
}

std::optional<RunEnd> runToEnd(FollowedRun &run, const lessons::RunSetup &setup,
                               const sim::ShouldContinue &shouldContinue, const std::function<void()> &visit)
{
    std::optional<Condition> until;
    if (!setup.until.isEmpty())
        until = run.condition(setup.until);
    if (visit)
        visit();
    while (run.frame() < setup.frames) {
        if (shouldContinue && !shouldContinue())
            return std::nullopt;
        if (!run.advance())
            break;
        if (visit)
            visit();
        if (until && until->holds(run.moment()))
            return RunEnd{run.frame(), true};
    }
    return RunEnd{run.frame(), !until};
}

}
