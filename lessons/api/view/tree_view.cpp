#include "lessons/api/view/tree_view.h"

#include "lessons/api/view/scene_view.h"
#include "sim/effects/tree/tree.h"

namespace lessons {

namespace {

/// px, of a branch of scale 1, as published.
constexpr double trunkWidth = 10.0;

}

Look treeLook(const sim::Tree &tree)
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
