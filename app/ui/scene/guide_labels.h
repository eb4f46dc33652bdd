#pragma once

#include "app/ui/scene/arrows.h"

#include <vector>

namespace app {

constexpr double crossArm = 7.0;   ///< px of the screen
constexpr double beyondArc = 14.0; ///< px of the screen, how far the x axis goes on beyond an angle's arc

/// A guide's name, where it covers neither bodies nor arrows nor other names, as far as there is room.
struct GuideLabel
{
    QString text;
    QRectF box;
};

/// The names of the guides that begin within `area`.
std::vector<GuideLabel> guideLabels(const Shown &shown, const Camera &camera, const Theme &theme,
                                    QRectF area);
/// Where the name stands that tells a run from the one beside it; empty where there is none. `camera`: of what
/// `shown` draws, its shift included.
QRectF titleBox(const Shown &shown, const Camera &camera);
/// The lines that the guides and arrows of `shown` draw, as straight pieces on the screen.
std::vector<QLineF> explainingStrokes(const Shown &shown, const Camera &camera, const Theme &theme);

/// The radius of a guide's ring on the screen.
double ringRadius(const lessons::Overlay &guide, const Camera &camera);
/// The radius of a guide's arc on the screen: outside of the body that stands there.
double arcRadius(const lessons::Overlay &guide, const Shown &shown, const Camera &camera);
/// A guide's pull, from the edge of the body that stands there.
Arrow guideArrow(const lessons::Overlay &guide, const Shown &shown, const Camera &camera, const Theme &theme);

}
