#pragma once

#include "app/ui/scene/canvas.h"

#include <QPixmap>

#include <array>

namespace app {

/// The colours of an open sky: dusk where the theme is dark, a morning where it is light.
struct SkyColors
{
    std::array<QColor, 5> sky; ///< from above to the horizon
    QColor star;               ///< invisible in the morning
    QColor sun;                ///< invisible at dusk
    QColor hills;
    QColor meadow;
    QColor bark;  ///< thick branches
    QColor twigs; ///< thin branches
    std::array<QColor, 3> blossoms;
    QColor buried; ///< branches below the ground, where they lie over the meadow
};

SkyColors skyColors(Scheme scheme);

/// How far down the ground below an open sky begins: where the trunk stands, or at the ground, or at the foot of
/// the stage. px.
double horizonOf(const Shown &shown);

/// Sky, stars and far hills. They stay the same while nobody moves the picture, so they are painted once.
class Sky
{
public:
    /// `horizon`: how far down the view the ground begins, px of the screen.
    void draw(QPainter &painter, QRectF view, double horizon, Scheme scheme);

private:
    QPixmap m_painted;
    double m_horizon = 0.0;
    Scheme m_scheme = Scheme::light;
};

/// Paints the near ground, which hides the foot of what stands on it and moves with the picture. Returns its outline.
QPolygonF drawMeadow(const Canvas &canvas, const SkyColors &colors);

}
