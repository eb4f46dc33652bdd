// Layers of the past: the trail, earlier moments and the ghost.

#include "app/ui/scene/drawing/figure.h"
#include "app/ui/scene/layers/layers.h"

namespace app {

namespace {

constexpr double comparisonAlpha = 0.9;
constexpr double latestSkin = 0.55; ///< opacity of the latest onion skin

}

void drawComparison(const Canvas &canvas, TreePainter &tree)
{
    const std::optional<Picture> &comparison = canvas.shown.comparison;
    if (!comparison || !canvas.shown.extras.comparison)
        return;
    const QColor color = faded(canvas.tokens().ghost, comparisonAlpha);
    if (comparison->view->tree)
        tree.drawOutline(canvas, comparison->view, comparison->state, color);
    drawOutlines(canvas, {*comparison->view, comparison->state}, {color});
}

void drawOnion(const Canvas &canvas, TreePainter &tree)
{
    const SceneContent &shown = canvas.shown;
    // Earliest first, so that later ones are painted over it.
    for (std::size_t k = shown.onion.size(); k-- > 0;) {
        const sim::State &state = shown.onion[k];
        if (state.pointCount() != shown.points())
            continue;
        const double alpha = latestSkin * (1.0 - static_cast<double>(k) / onionSkins);
        const QColor color = faded(canvas.tokens().body, alpha);
        if (shown.view().tree)
            tree.drawOutline(canvas, shown.picture.view, state, color);
        drawOutlines(canvas, {shown.view(), state},
                     {color, 1.2, false, faded(canvas.tokens().body, alpha * 0.22)});
    }
    if (!shown.past || shown.past->state.pointCount() != shown.points())
        return;
    if (shown.past->view->tree)
        tree.drawOutline(canvas, shown.past->view, shown.past->state, canvas.tokens().ink2);
    drawOutlines(canvas, {*shown.past->view, shown.past->state}, {canvas.tokens().ink2, 1.8, false});
}

void drawTrail(const Canvas &canvas)
{
    const SceneContent &shown = canvas.shown;
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
