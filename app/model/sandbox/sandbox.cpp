#include "app/model/sandbox/sandbox.h"

#include "app/listing/rule_program.h"
#include "app/model/catalog/lists.h"
#include "app/model/sandbox/blueprint_limits.h"
#include "app/model/text/quoting.h"
#include "app/model/text/sentences.h"
#include "lessons/api/blueprint_of.h"
#include "sim/base/error.h"
#include "sim/effects/all_effects.h"
#include "sim/effects/rules/rule_force.h"
#include "sim/pipeline/pipeline.h"
#include "sim/run/script/script.h"
#include "sim/scene/blueprint_draft.h"

#include <QCoreApplication>

#include <algorithm>
#include <map>

namespace app {

namespace {

struct SandboxText
{
    Q_DECLARE_TR_FUNCTIONS(SandboxText)
};

/// Returns the parameter values of the sandbox run: the exported values, limited to their ranges.
sim::Values valuesOf(const lessons::Step &sandbox, const sim::BlueprintDraft &draft)
{
    sim::Values values = sandbox.defaultValues();
    for (const auto &[id, number] : draft.parameters) {
        const lessons::Parameter *parameter = sandbox.parameter(QString::fromStdString(id));
        if (parameter)
            values.set(id, std::clamp(number, parameter->min, parameter->max));
    }
    values.blueprint = std::make_shared<const sim::Blueprint>(draft.blueprint);
    return values;
}

/// Makes the rule of a scene independent of its lesson: parameters of the sandbox have the values of the lesson, and those
/// that the lesson declares become numbers in the text.
void takeRuleParameters(sim::BlueprintDraft &draft, const lessons::Step &sandbox, const sim::Values &values)
{
    const std::shared_ptr<const sim::Rule> rule = draft.blueprint.rule.program;
    if (!rule)
        return;
    std::map<std::string, double> declared;
    for (const std::string &id : rule->parameters()) {
        const double value = values.has(id) ? values[id] : 0.0;
        if (sandbox.parameter(QString::fromStdString(id)))
            draft.parameters[id] = value;
        else
            declared[id] = value;
    }
    if (declared.empty())
        return;
    draft.blueprint.rule = {listing::compileRule(listing::withNumbers(rule->text(), declared)).rule};
    if (!draft.blueprint.rule)
        draft.omit(sim::descriptions::rule.title); // too long with the numbers
}

/// Returns the order in which the groups of a scene move, if there are several and `method` keeps it. Empty if all move
/// at once. A sandbox scene is one group.
QStringList orderOf(const sim::Scene &scene, const sim::Method &method)
{
    const std::vector<std::string> needs = method.requirements();
    QStringList order;
    if (scene.groups.size() > 1 && contains(needs, "groups")) {
        for (const sim::Group &group : scene.groups)
            order << phrase(group.title);
    }
    return order;
}

QString sentenceOf(const sim::BlueprintDraft &draft, const QStringList &order)
{
    QStringList names;
    for (const std::string &one : draft.omitted)
        names << phrase(one);
    if (!order.isEmpty())
        names << SandboxText::tr("the order in which points move (%1), because here all move at once")
                     .arg(order.join(QStringLiteral(", ")));
    if (names.isEmpty())
        return SandboxText::tr("This is your own copy of the scene: change what you like.");
    return SandboxText::tr(
               "This is your own copy of the scene. It could not be copied completely. Missing: %1.")
        .arg(names.join(QStringLiteral(", ")));
}

/// Returns whether a file can hold the positions and velocities of all points.
bool isWithinLimits(const sim::Blueprint &plan)
{
    return std::all_of(plan.points.begin(), plan.points.end(), [](const sim::BlueprintPoint &one) {
        return built::place.holds(one.x.x) && built::place.holds(one.x.y) && built::speed.holds(one.v.x) &&
               built::speed.holds(one.v.y);
    });
}

/// Returns whether the run of `script` can be set up.
bool fits(const sim::Script &script)
{
    try {
        sim::compose(sim::sceneOf(script, script.values), *script.method, script.step);
        return true;
    } catch (const sim::Error &) {
        return false;
    }
}

}

const LessonEntry *sandboxOf(const LessonLibrary &library)
{
    return library.sandboxes.empty() ? nullptr : &library.sandboxes.front();
}

ExportedScene takenScene(const Session &session, const lessons::Step &sandbox)
{
    const Picture picture = session.presentation().picture();
    if (picture.state.pointCount() > int(built::mostPoints))
        throw UserError(
            SandboxText::tr(
                "This scene has %1 points, but the sandbox allows only %2. Choose a smaller scene.")
                .arg(picture.state.pointCount())
                .arg(built::mostPoints));
    std::optional<sim::BlueprintDraft> draft =
        lessons::blueprintOf(picture.interval->scene, picture.state, *picture.view);
    if (!draft)
        throw UserError(
            SandboxText::tr("The sandbox cannot open this scene, because it has no branches with joints. "
                            "Take another scene, or look at the examples in the sandbox."));
    if (!isWithinLimits(draft->blueprint))
        throw UserError(
            SandboxText::tr("This scene has flown apart: a point is more than %1 px away, or moves that far "
                            "in a frame. Go back in time, and take the scene from there.")
                .arg(exactNumber(built::place.max)));
    takeRuleParameters(*draft, sandbox, picture.interval->values);
    const sim::Script &now = session.timeline().script();
    ExportedScene scene;
    scene.script = sandbox.scriptWith(valuesOf(sandbox, *draft), now.method);
    scene.script.step = now.step;
    scene.sentence = sentenceOf(*draft, orderOf(picture.interval->scene, *now.method));
    if (!fits(scene.script)) {
        scene.script = sandbox.script();
        scene.script.values = valuesOf(sandbox, *draft);
    }
    return scene;
}

void takeToSandbox(Session &session)
{
    const LessonEntry *sandbox = sandboxOf(session.library());
    if (!sandbox || session.isSandbox())
        return;
    try {
        const ExportedScene scene = takenScene(session, sandbox->steps.front());
        session.openStep(sandbox->id, sandbox->steps.front().id);
        if (session.editor().replaceScene({SandboxText::tr("Take scene to sandbox"), {}, {}}, scene.script))
            session.showMessage(scene.sentence);
    } catch (const UserError &error) {
        session.showMessage(error.sentence());
    }
}

bool takeExample(const OpenRun &run, RunEditor &editor, const lessons::Example &example)
{
    try {
        const Experiment read = readExperiment(example.file, run.library());
        return editor.replaceScene({SandboxText::tr("Open example %1").arg(example.title), {}, {}},
                                   read.script, read.draft);
    } catch (const UserError &error) {
        run.showMessage(error.sentence());
        return false;
    }
}

bool canBuild(const OpenRun &run, const RunEditor &editor, const Playback &playback)
{
    return run.isSandbox() && editor.blueprint() && !playback.isPlaying() &&
           run.timeline().cursor() == sim::Cursor{};
}

QString buildOnlyAtStart()
{
    return SandboxText::tr("You can only build at the start of the run. Press Home to go there.");
}

bool setBuiltEffect(const OpenRun &run, RunEditor &editor, const Playback &playback, const QString &id,
                    bool present)
{
    const sim::EffectDescription *effect =
        sim::findDescription(run.step().availableEffects, id.toStdString());
    if (!effect || !editor.blueprint())
        return false;
    if (!canBuild(run, editor, playback)) {
        run.showMessage(buildOnlyAtStart());
        return false;
    }
    sim::Blueprint plan = *editor.blueprint();
    std::erase(plan.effects, effect->id);
    if (present)
        plan.effects.push_back(effect->id);
    const QString title = phrase(effect->title);
    return editor.build(
        {present ? SandboxText::tr("Add %1").arg(title) : SandboxText::tr("Remove %1").arg(title), {}, {}},
        std::move(plan));
}

bool startEmpty(const OpenRun &run, RunEditor &editor)
{
    sim::Script script = run.step().script();
    sim::Blueprint plan;
    plan.points = {{"p0", {270, 200}, {}, 1.0, 20.0, false}};
    plan.effects = {"gravity", "damping", "walls"};
    std::erase_if(plan.effects, [&](const std::string &id) {
        return !sim::findDescription(run.step().availableEffects, id);
    });
    script.values.blueprint = std::make_shared<const sim::Blueprint>(std::move(plan));
    if (!editor.replaceScene({SandboxText::tr("Start new scene"), {}, {}}, script))
        return false;
    run.showMessage(SandboxText::tr(
        "A new scene has one point, the fewest that a scene can have. Move it, or add parts to it."));
    return true;
}

}
