#include "app/model/workshop.h"

#include "app/model/blueprint_limits.h"
#include "app/model/sentences.h"
#include "app/model/words.h"
#include "lessons/api/blueprint_of.h"
#include "sim/base/error.h"
#include "sim/effects/all_effects.h"
#include "sim/pipeline/pipeline.h"
#include "sim/run/script/script.h"
#include "sim/scene/blueprint_draft.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Workshop)
};

/// The values of a workshop's run: what was taken, inside the range that each parameter has.
sim::Values valuesOf(const lessons::Step &workshop, const sim::BlueprintDraft &draft)
{
    sim::Values values = workshop.defaultValues();
    for (const auto &[id, number] : draft.parameters) {
        const lessons::Parameter *parameter = workshop.parameter(QString::fromStdString(id));
        if (parameter)
            values.set(id, std::clamp(number, parameter->min, parameter->max));
    }
    values.blueprint = std::make_shared<const sim::Blueprint>(draft.blueprint);
    return values;
}

/// The order in which the groups of a scene move, if there are several and `method` keeps it; empty: all move at once. What is
/// built is one group.
QStringList orderOf(const sim::Scene &scene, const sim::Method &method)
{
    const std::vector<std::string> needs = method.requirements();
    QStringList order;
    if (scene.groups.size() > 1 && std::find(needs.begin(), needs.end(), "groups") != needs.end()) {
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
        names << Text::tr("the order in which points move (%1), as here all move at once")
                     .arg(order.join(QStringLiteral(", ")));
    if (names.isEmpty())
        return Text::tr("This is your own copy of the scene: change what you like.");
    return Text::tr("This is your own copy of the scene. What could not be taken along: %1.")
        .arg(names.join(QStringLiteral(", ")));
}

/// Whether a file can hold where all points are, and how fast.
bool isWithinLimits(const sim::Blueprint &plan)
{
    return std::all_of(plan.points.begin(), plan.points.end(), [](const sim::BlueprintPoint &one) {
        return built::place.holds(one.x.x) && built::place.holds(one.x.y) && built::speed.holds(one.v.x) &&
               built::speed.holds(one.v.y);
    });
}

/// Whether the run of `script` can be set up.
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

const LessonEntry *workshopOf(const LessonLibrary &library)
{
    return library.workshops.empty() ? nullptr : &library.workshops.front();
}

TakenScene takenScene(const Session &session, const lessons::Step &workshop)
{
    const Picture picture = session.picture();
    if (picture.state.pointCount() > int(built::mostPoints))
        throw Refusal(Text::tr("This scene has %1 points; one that you build can have %2.")
                          .arg(picture.state.pointCount())
                          .arg(built::mostPoints));
    const std::optional<sim::BlueprintDraft> draft =
        lessons::blueprintOf(picture.interval->scene, picture.state, *picture.look);
    if (!draft)
        throw Refusal(
            Text::tr("This scene cannot be built from points: its branches turn in their joints. Take "
                     "another one, or open the sandbox and look at its examples."));
    if (!isWithinLimits(draft->blueprint))
        throw Refusal(
            Text::tr("This scene has flown apart: a point is farther away than %1 px, or that fast. "
                     "Go back in time, and take it from there.")
                .arg(exactNumber(built::place.max)));
    const sim::Script &now = session.timeline().script();
    TakenScene scene;
    scene.script = workshop.scriptWith(valuesOf(workshop, *draft), now.method);
    scene.script.step = now.step;
    scene.sentence = sentenceOf(*draft, orderOf(picture.interval->scene, *now.method));
    if (!fits(scene.script)) {
        scene.script = workshop.script();
        scene.script.values = valuesOf(workshop, *draft);
    }
    return scene;
}

void takeToWorkshop(Session &session)
{
    const LessonEntry *workshop = workshopOf(session.library());
    if (!workshop || session.isWorkshop())
        return;
    try {
        const TakenScene scene = takenScene(session, workshop->steps.front());
        session.openStep(workshop->id, workshop->steps.front().id);
        if (session.takeUp({Text::tr("Take over scene"), {}, {}}, scene.script))
            emit session.said(scene.sentence);
    } catch (const Refusal &refusal) {
        emit session.said(refusal.sentence());
    }
}

bool takeExample(Session &session, const lessons::Example &example)
{
    try {
        const Experiment read = readExperiment(example.file, session.library());
        return session.takeUp({Text::tr("Open example %1").arg(example.title), {}, {}}, read.script);
    } catch (const Refusal &refusal) {
        emit session.said(refusal.sentence());
        return false;
    }
}

bool canBuild(const Session &session)
{
    return session.isWorkshop() && session.blueprint() && !session.isPlaying() &&
           session.timeline().cursor() == sim::Cursor{};
}

bool setBuiltEffect(Session &session, const QString &id, bool present)
{
    const sim::EffectDescription *effect =
        sim::findDescription(session.step().availableEffects, id.toStdString());
    if (!effect || !session.blueprint())
        return false;
    if (!canBuild(session)) {
        emit session.said(Text::tr("Building happens at the start of the run: press Home to go there."));
        return false;
    }
    sim::Blueprint plan = *session.blueprint();
    std::erase(plan.effects, effect->id);
    if (present)
        plan.effects.push_back(effect->id);
    const QString title = phrase(effect->title);
    return session.build({present ? Text::tr("Add %1").arg(title) : Text::tr("Remove %1").arg(title), {}, {}},
                         std::move(plan));
}

bool startEmpty(Session &session)
{
    sim::Script script = session.step().script();
    sim::Blueprint plan;
    plan.points = {{"p0", {270, 200}, {}, 1.0, 20.0, false}};
    plan.effects = {"gravity", "damping", "walls"};
    std::erase_if(plan.effects, [&](const std::string &id) {
        return !sim::findDescription(session.step().availableEffects, id);
    });
    script.values.blueprint = std::make_shared<const sim::Blueprint>(std::move(plan));
    if (!session.takeUp({Text::tr("Start new scene"), {}, {}}, script))
        return false;
    emit session.said(Text::tr(
        "A new scene has one point: the least that a scene can have. Move it, or build on from it."));
    return true;
}

}
