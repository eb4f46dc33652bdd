#include "steps.h"

#include "checks.h"
#include "measuring.h"
#include "parameters.h"
#include "scenes.h"
#include "view.h"

#include <QCoreApplication>

#include <algorithm>

using namespace lessons;

namespace swaying_tree {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(SwayingTree)
};

/// Of a branch of scale 1, as published.
constexpr double trunkWidth = 10.0;

/// A hand takes hold of a branch by name only: what is drawn is the tree, and the pointer blows.
Look drawn(const sim::Tree &tree)
{
    Look look;
    look.bodies.assign(tree.parent.size(), {BodyLook::Shape::none, 0.0});
    look.tree = TreeLook{tree.parent, tree.scale, tree.scale};
    for (double &length : look.tree->length)
        length *= tree.baseLength;
    for (double &width : look.tree->width)
        width *= trunkWidth;
    look.stage = QRectF(0, 0, 550, 400);
    look.sky = Look::Sky::dusk;
    return look;
}

}

Step treeStep(const char *id, const QString &title, sim::Tree (*grow)(const sim::Values &))
{
    Step step = lessons::stepCalled("swaying_tree", id, title);
    step.look = [grow](const sim::Scene &, const sim::Values &values) { return drawn(grow(values)); };
    step.does = {Does::hand, Does::pointer};
    step.columns = Columns::placeAndAngle;
    return step;
}

Step trunkStep()
{
    Step step = treeStep("trunk", Text::tr("The trunk"), trunk::grow);
    step.addParameters({baseLength(), formula()});
    step.narration = Text::tr(
        "A branch is three things: where it begins, its **angle**, and its length. Where it ends follows: "
        "`cos` and `sin` of the angle, times the length, lead from its origin to its end.\n\n"
        "The trunk begins in the middle of the ground, 275 px to the right and 400 px down. Its angle "
        "is −90°: y points down, so angles grow clockwise, and minus a quarter turn is straight up. It is "
        "100 px long.\n\n"
        "`cos` and `sin` take radians, so the angle is divided by the degrees to a radian: 57.2958. The "
        "tutorial behind this lesson divides by 57.3. That leans the trunk by 0.0066° to the right, "
        "and its end is 0.0116 px off. The list **Formula** offers both.");
    step.tries = trunkTries();
    step.scene = trunk::setUp;
    step.guides = trunkEnd;
    return step;
}

Step branchesStep()
{
    Step step = treeStep("branches", Text::tr("Branches"), branches::grow);
    step.addParameters({spread(), slope(), minScale(), baseLength(), formula()});
    step.narration = Text::tr(
        "Where a branch ends, two smaller ones begin. One leans 30° to the left of it, one to the "
        "right: that is the **spread**. Each is 0.8 times as large: the **slope**. And each of them "
        "does the same.\n\n"
        "Such a rule that uses itself needs an end. A branch grows only while it is **larger than 0.2** "
        "of the trunk. That makes 8 levels: 1 + 2 + 4 + … + 128 = **255 branches** from one rule.\n\n"
        "With a slope of 1 nothing would get smaller and the tree would never end. So the levels "
        "are counted before it grows, and a tree of more than 131071 branches is refused.\n\n"
        "Branches are numbered level by level, from left to right: 0 is the trunk.");
    step.tries = branchesTries();
    step.scene = branches::setUp;
    step.measures = {countMeasure()};
    return step;
}

Step randomnessStep()
{
    Step step = treeStep("randomness", Text::tr("A little chance"), randomness::grow);
    step.addParameters({jitter(), spread(), slope(), minScale(), baseLength(), formula()});
    step.narration = Text::tr(
        "Real trees are not so neat. So each new branch is turned by a little more: by chance, up to "
        "10° to either side. That is the **jitter**.\n\n"
        "A branch leans from where its parent points. So what chance did to the parent, its children "
        "carry on, and one change near the trunk turns a whole bough.\n\n"
        "Each number of chance is worked out from the branch’s own number and the **seed**, a whole "
        "number that belongs to the experiment. So the same seed grows the same tree, each time that "
        "you go back to the start.\n\n"
        "A variable or two are enough for quite other patterns. The **gallery** has some; from one "
        "of them, go on by yourself.");
    step.tries = randomnessTries();
    step.scene = randomness::setUp;
    step.measures = {countMeasure()};
    step.presetGallery = galleryFor(step);
    return step;
}

}
