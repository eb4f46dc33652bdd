#include "lessons/api/view/tree_view.h"

#include "lessons/api/view/view.h"
#include "sim/effects/tree/tree.h"

namespace lessons {

namespace {

/// px, of a branch of scale 1, as published.
constexpr double trunkWidth = 10.0;

}

View treeView(const sim::Tree &tree)
{
    View look;
    look.bodies.assign(tree.parent.size(), {BodyView::Shape::none, 0.0});
    look.tree = TreeView{tree.parent, tree.scale, tree.scale};
    for (double &length : look.tree->length)
        length *= tree.baseLength;
    for (double &width : look.tree->width)
        width *= trunkWidth;
    look.stage = QRectF(0, 0, 550, 400);
    look.sky = View::Sky::dusk;
    return look;
}

}
