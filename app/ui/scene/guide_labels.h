#pragma once

#include "app/ui/scene/arrows.h"

#include <vector>

namespace app {

/// A guide's name, where it covers neither bodies nor other names.
struct GuideLabel
{
    QString text;
    QRectF box;
};

/// The names of the guides that begin within `area`.
std::vector<GuideLabel> guideLabels(const Shown &shown, const Camera &camera, QRectF area);

/// The radius of a guide's ring on the screen.
double ringRadius(const lessons::Guide &guide, const Camera &camera);
/// The radius of a guide's arc on the screen: outside of the body that stands there.
double arcRadius(const lessons::Guide &guide, const Shown &shown, const Camera &camera);
/// A guide's pull, from the edge of the body that stands there.
Arrow guideArrow(const lessons::Guide &guide, const Shown &shown, const Camera &camera, const Theme &theme);

}
