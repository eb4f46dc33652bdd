#include "steps.h"

#include "checks.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/tree_view.h"
#include "lessons/swaying_tree/text.h"
#include "parameters.h"
#include "scenes.h"
#include "view.h"

#include <QCoreApplication>

using namespace lessons;

namespace swaying_tree {

namespace {

/// Returns a step with the settings that all steps of this lesson share. `grow` makes the tree for the view.
/// `id` is also the marker of the set-up function.
Step treeStep(const char *id, sim::Tree (*grow)(const sim::Values &))
{
    Step step = lessons::makeStep("swaying_tree", id);
    step.view = [grow](const sim::Scene &, const sim::Values &values) { return treeView(grow(values)); };
    step.interactions = {Interaction::drag, Interaction::pointer};
    step.traceColumns = TraceColumns::positionAndAngle;
    return step;
}

/// Adds the angle of the trunk to the view of a step.
void addAngle(Step &step)
{
    step.view = [view = step.view](const sim::Scene &scene, const sim::Values &values) {
        View shown = view(scene, values);
        shown.angle = AngleView{.from = 0, .to = -1};
        return shown;
    };
}

/// Returns a step whose tree bends. The parameters `first` precede those of the tree.
Step bentStep(const char *id, const std::vector<Parameter> &first)
{
    Step step = treeStep(id, randomness::grow);
    step.addParameters(first);
    step.addParameters({jitter(), spread(), slope(), minScale(), baseLength()});
    step.measures = {bendMeasure()};
    step.overlays = windByBothFormulas;
    step.note = groundNote;
    step.presets = galleryFor(step);
    return step;
}

}

Step trunkStep()
{
    Step step = treeStep("trunk", trunk::grow);
    step.addParameters({baseLength(), formula()});
    step.readTexts(trunkChecks());
    step.scene = trunk::setUp;
    addAngle(step);
    step.overlays = trunkEnd;
    return step;
}

Step branchesStep()
{
    Step step = treeStep("branches", branches::grow);
    step.addParameters({spread(), slope(), minScale(), baseLength(), formula()});
    step.readTexts(branchesChecks());
    step.scene = branches::setUp;
    step.measures = {countMeasure()};
    return step;
}

Step randomnessStep()
{
    Step step = treeStep("randomness", randomness::grow);
    step.addParameters({jitter(), spread(), slope(), minScale(), baseLength(), formula()});
    step.readTexts(randomnessChecks());
    step.scene = randomness::setUp;
    step.measures = {countMeasure()};
    step.presets = galleryFor(step);
    return step;
}

Step towardsPointerStep()
{
    Step step = bentStep("towards_pointer", {formula()});
    step.readTexts(towardsPointerChecks());
    step.scene = towards_pointer::setUp;
    step.overlays = aimByBothFormulas;
    return step;
}

Step windStep()
{
    Step step = bentStep("wind", {formula(), ease()});
    step.readTexts(windChecks());
    step.scene = wind::setUp;
    return step;
}

Step restStep()
{
    Step step = bentStep("rest", {formula(), ease()});
    step.readTexts(restChecks());
    step.scene = rest::setUp;
    return step;
}

Step distanceStep()
{
    Step step = bentStep("distance", {formula(), ease()});
    step.readTexts(distanceChecks());
    step.scene = distance::setUp;
    return step;
}

Step thicknessStep()
{
    Step step = bentStep("thickness", {formula(), windStrength(), ease()});
    step.readTexts(thicknessChecks());
    step.scene = thickness::setUp;
    return step;
}

Step turbulenceStep()
{
    Step step = bentStep("turbulence", {formula(), windStrength(), turbulenceAngle(), ease()});
    step.interactions.push_back(Interaction::gust);
    step.readTexts(turbulenceChecks());
    step.scene = turbulence::setUp;
    return step;
}

Step realSwayStep()
{
    Parameter k = stiffness(0.05);
    k.help = Text::tr("How hard a joint turns its branch back: for a lone trunk, this share of its bend "
                      "each frame.");
    k.sliderMax = 0.3;
    Parameter damp = damping(0.96);
    damp.help = Text::tr("The share of its spin that every branch keeps each frame. 1 keeps it all.");
    Step step = bentStep("real_sway", {k, damp, windStrength(), gustSpeed(), gusts()});
    step.method = QStringLiteral("semi_implicit_euler");
    step.readTexts(realSwayChecks());
    step.scene = real_sway::setUp;
    step.overlays = gustFromPointer;
    for (const Measure &energy : energyMeasures())
        step.measures.push_back(energy);
    return step;
}

}
