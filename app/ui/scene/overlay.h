#pragma once

#include "app/ui/scene/edge_markers.h"

namespace app {

/// What lies over the picture and keeps its place and size at every zoom: caption, scale, legends, the selected
/// body's name or its card of pulls, and signs for bodies outside.
class Overlay
{
public:
    /// `beside`: the companion, which has no picture where there is none.
    Overlay(const Shown &shown, const Shown &beside, const Theme &theme)
        : m_shown(shown), m_beside(beside), m_theme(theme)
    {
    }

    void draw(QPainter &painter, const Camera &camera, QRectF view) const;
    /// The signs for bodies outside of `view`.
    std::vector<EdgeMarker> markers(const Camera &camera, QRectF view) const;

private:
    struct Entry;

    std::vector<Entry> legend() const;
    /// For words on the background: stronger on a coloured sky.
    QColor captionInk() const;
    void drawCaption(QPainter &painter, const Camera &camera, QRectF view) const;
    void drawClock(QPainter &painter, QRectF view) const;
    /// Returns where it ends.
    double drawScale(QPainter &painter, const Camera &camera, QRectF view) const;
    /// The colour of the background `y` px down the screen.
    QColor groundAt(const Camera &camera, double y) const;
    void drawLegend(QPainter &painter, const Camera &camera, QRectF view, double from) const;
    void drawEntry(QPainter &painter, const Entry &entry, QPointF at) const;
    void drawName(QPainter &painter, QRectF box) const;
    /// The words that belong to the picture: names of guides, and of the figures where there are two.
    std::vector<QRectF> wordBoxes(const Camera &camera, QRectF view) const;
    /// What a card must not cover.
    std::vector<QRectF> takenBoxes(const Camera &camera, QRectF view,
                                   const std::vector<EdgeMarker> &outside) const;
    void drawFocus(QPainter &painter, QRectF view) const;

    const Shown &m_shown;
    const Shown &m_beside;
    const Theme &m_theme;
};

/// The card of a stop inside a frame: what each effect pulls with at the selected body, and the sum.
void drawPullCard(QPainter &painter, const Shown &shown, const Theme &theme, const Camera &camera,
                  QRectF free, std::vector<QRectF> taken);

}
