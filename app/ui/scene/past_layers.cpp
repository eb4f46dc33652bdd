// What was: the trail, earlier moments, and the old run.

#include "app/ui/scene/figure.h"
#include "app/ui/scene/layers.h"

namespace app {

namespace {

constexpr double ghostAlpha = 0.9;
constexpr double latestSkin = 0.55; ///< how strong the latest of the earlier moments is

}

void GhostLayer::draw(const Canvas &canvas) const
{
    const std::optional<Picture> &ghost = canvas.shown.ghost;
    if (!ghost || !canvas.shown.extras.ghost)
        return;
    const QColor color = faded(canvas.tokens().ghost, ghostAlpha);
    if (ghost->look->tree)
        m_tree.drawOutline(canvas, ghost->look, ghost->state, color);
    drawOutlines(canvas, {*ghost->look, ghost->state}, {color});
}

void OnionLayer::draw(const Canvas &canvas) const
{
    const Shown &shown = canvas.shown;
    // The earliest first, so that later ones lie above it.
    for (std::size_t k = shown.onion.size(); k-- > 0;) {
        const sim::State &state = shown.onion[k];
        if (state.pointCount() != shown.points())
            continue;
        const double alpha = latestSkin * (1.0 - static_cast<double>(k) / onionSkins);
        const QColor color = faded(canvas.tokens().body, alpha);
        if (shown.look().tree)
            m_tree.drawOutline(canvas, shown.picture.look, state, color);
        drawOutlines(canvas, {shown.look(), state},
                     {color, 1.2, false, faded(canvas.tokens().body, alpha * 0.22)});
    }
    if (!shown.past || shown.past->state.pointCount() != shown.points())
        return;
    if (shown.past->look->tree)
        m_tree.drawOutline(canvas, shown.past->look, shown.past->state, canvas.tokens().ink2);
    drawOutlines(canvas, {*shown.past->look, shown.past->state}, {canvas.tokens().ink2, 1.8, false});
}

void TrailLayer::draw(const Canvas &canvas) const
{
    const Shown &shown = canvas.shown;
    const std::deque<Trail::Mark> &marks = shown.trail.marks();
    const std::vector<int> points = trailed(shown);
    if (points.empty())
        return;
    for (std::size_t k = 1; k < marks.size(); ++k) {
        const double age = static_cast<double>(marks.back().frame - marks[k].frame) / Trail::length;
        canvas.painter.setPen(solid(faded(canvas.tokens().body, 0.05 + 0.3 * (1.0 - age)), 2.0));
        for (const int i : points) {
            const auto place = [&](const Trail::Mark &mark) {
                return canvas.camera.at({mark.position(i, 0), mark.position(i, 1)});
            };
            canvas.painter.drawLine(canvas.cut(place(marks[k - 1]), place(marks[k])));
        }
    }
}

}
