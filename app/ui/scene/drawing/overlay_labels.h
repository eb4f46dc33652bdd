#pragma once

#include "app/ui/scene/drawing/arrows.h"

#include <vector>

namespace app {

constexpr double crossArm = 7.0;   ///< screen px
constexpr double beyondArc = 14.0; ///< screen px: how far the x axis extends beyond an angle's arc

/// The label of an overlay. If there is space, it covers no bodies, arrows or other labels.
struct OverlayLabel
{
    QString text;
    QRectF box;
};

/// Returns the labels of the overlays that begin within `area`.
std::vector<OverlayLabel> overlayLabels(const SceneContent &shown, const Camera &camera, const Theme &theme,
                                        QRectF area);
/// Returns the box of the name that tells two runs shown together apart; empty if there is none. `camera`: includes
/// the shift of `shown`.
QRectF titleBox(const SceneContent &shown, const Camera &camera);
/// Returns the name of the figure, shortened to the width of its stage: the other figure's name is beside it.
QString shownTitle(const SceneContent &shown, const Camera &camera);
/// Returns the lines of the overlays and arrows of `shown`, as straight pieces on the screen.
std::vector<QLineF> explainingStrokes(const SceneContent &shown, const Camera &camera, const Theme &theme);

/// Returns the radius of an overlay's ring, screen px.
double ringRadius(const lessons::Overlay &overlay, const Camera &camera);
/// Returns the radius of an overlay's arc, screen px: outside the body at its centre.
double arcRadius(const lessons::Overlay &overlay, const SceneContent &shown, const Camera &camera);
/// Returns the force arrow of an overlay, from the edge of the body at its start.
Arrow overlayArrow(const lessons::Overlay &overlay, const SceneContent &shown, const Camera &camera,
                   const Theme &theme);

}
