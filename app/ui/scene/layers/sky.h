#pragma once

#include "app/ui/scene/drawing/canvas.h"

#include <QPixmap>

#include <array>

namespace app {

/// The colours of an open sky: dusk in dark themes, morning in light themes.
struct SkyColors
{
    std::array<QColor, 5> sky; ///< from the top to the horizon
    QColor star;               ///< transparent in the morning
    QColor sun;                ///< transparent at dusk
    QColor hills;
    QColor meadow;
    QColor bark;  ///< thick branches
    QColor twigs; ///< thin branches
    std::array<QColor, 3> blossoms;
    QColor buried; ///< branches below the ground, drawn over the meadow
};

SkyColors skyColors(Scheme scheme);

/// Returns the y at which the ground below an open sky begins, px: at the trunk, else at the ground, else at
/// the bottom of the stage.
double horizonOf(const SceneContent &shown);

/// The sky with stars and distant hills. It is painted into a cache, because it changes only when the view
/// moves.
class Sky
{
public:
    /// `horizon`: y of the ground's edge, screen px.
    void draw(QPainter &painter, QRectF view, double horizon, Scheme scheme);

private:
    QPixmap m_painted;
    double m_horizon = 0.0;
    Scheme m_scheme = Scheme::light;
};

/// Paints the near ground, which hides the feet of things that stand on it and moves with the view. Returns
/// its outline.
QPolygonF drawMeadow(const Canvas &canvas, const SkyColors &colors);

}
