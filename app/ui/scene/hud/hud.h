#pragma once

#include "app/ui/scene/drawing/label_places.h"
#include "app/ui/scene/hud/edge_markers.h"

namespace app {

/// The heads-up display, whose position and size do not change with the zoom. It has the caption, scale, legends, the
/// selected body's name or force card, and markers for bodies outside.
class Hud
{
public:
    /// The picture of `companion` is empty if there is no companion.
    Hud(const SceneContent &shown, const SceneContent &companion, const Theme &theme)
        : m_shown(shown), m_companion(companion), m_theme(theme)
    {
    }

    void draw(QPainter &painter, const Camera &camera, QRectF view) const;
    /// Returns the markers for bodies outside `view`.
    std::vector<EdgeMarker> markers(const Camera &camera, QRectF view) const;
    /// Returns places for further labels. They avoid bodies, links, arrows, and everything that draw() places.
    LabelPlaces labelPlaces(const Camera &camera, QRectF view) const;
    /// Returns the boxes of the texts that draw() and overlays place beside bodies. Some may be empty.
    std::vector<QRectF> textBoxes(const Camera &camera, QRectF view) const;
    /// Returns the box of the legend, one or more rows at the bottom right; empty if there is none.
    QRectF legendBox(const Camera &camera, QRectF view) const;

private:
    struct Entry;
    struct Labels;

    std::vector<Entry> legend() const;
    /// Returns the legend with the place of each entry, from the bottom right.
    std::vector<Entry> placedLegend(const Camera &camera, QRectF view) const;
    /// Returns the box of an entry with its padding.
    QRectF boxOf(const Entry &entry) const;
    /// Returns the colour of text on the background: stronger on a coloured sky.
    QColor captionInk() const;
    void drawCaption(QPainter &painter, const Camera &camera, QRectF view) const;
    void drawClock(QPainter &painter, QRectF view) const;
    /// Returns the x of the right end of the scale and its text, screen px.
    double scaleEnd(const Camera &camera) const;
    void drawScale(QPainter &painter, const Camera &camera, QRectF view) const;
    /// Returns the colour of the background at `y` screen px from the top.
    QColor groundAt(const Camera &camera, double y) const;
    void drawLegend(QPainter &painter, const Camera &camera, QRectF view) const;
    void drawEntry(QPainter &painter, const Entry &entry) const;
    void drawName(QPainter &painter, QRectF box) const;
    /// Returns the boxes of the texts in the scene: the labels of overlays, and the names of two creatures.
    std::vector<QRectF> wordBoxes(const Camera &camera, QRectF view) const;
    /// Returns the boxes of what draw() places beside bodies.
    Labels labels(const Camera &camera, QRectF view, const std::vector<EdgeMarker> &outside) const;
    /// Returns the boxes that a card must not cover.
    std::vector<QRectF> takenBoxes(const Camera &camera, QRectF view,
                                   const std::vector<EdgeMarker> &outside) const;
    void drawFocus(QPainter &painter, QRectF view) const;

    const SceneContent &m_shown;
    const SceneContent &m_companion;
    const Theme &m_theme;
};

/// Returns the box in `free` for the card shown when a run is paused inside a frame. Avoids the boxes in `taken`.
QRectF pullCardBox(const SceneContent &shown, const Theme &theme, const Camera &camera, QRectF free,
                   std::vector<QRectF> taken);
/// Draws that card in its box: the force of each effect on the selected body, and the sum.
void drawPullCard(QPainter &painter, const SceneContent &shown, const Theme &theme, QRectF box);

}
