#include "lessons/api/view/tree_view.h"

#include "lessons/api/view/view.h"
#include "sim/effects/tree/tree.h"

namespace lessons {

namespace {

/// px, width of a branch of scale 1 (published).
constexpr double trunkWidth = 10.0;

}

View treeView(const sim::Tree &tree)
{
    View view;
    view.bodies.assign(tree.parent.size(), {BodyView::Shape::none, 0.0});
    view.tree = TreeView{tree.parent, tree.scale, tree.scale};
    for (double &length : view.tree->length)
        length *= tree.baseLength;
    for (double &width : view.tree->width)
        width *= trunkWidth;
    view.stage = QRectF(0, 0, 550, 400);
    view.sky = View::Sky::dusk;
    return view;
}

}
