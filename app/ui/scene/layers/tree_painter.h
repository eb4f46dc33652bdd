#pragma once

#include "app/ui/scene/drawing/canvas.h"
#include "app/ui/scene/layers/stencil.h"

#include <array>
#include <memory>
#include <vector>

namespace app {

struct SkyColors;

/// The share of the branches of one size that is drawn: one in `every`. Each is drawn `longer` times as long
/// and `stronger` times as wide, so that the total covered area is the same.
struct Thinning
{
    int every = 1;
    int longer = 1;
    int stronger = 1;
};

/// Returns the thinning for branches of `length` and `width` screen px.
Thinning thinningOf(double length, double width);
/// Returns whether branch number `branch` is drawn. The choice is the same in every frame.
bool isDrawn(int branch, int every);

/// A painter of trees. It draws only visible detail and paints thin branches all at once. Keeps its working
/// memory between frames.
class TreePainter
{
public:
    /// Draws branches, in the colour `bark` if given, and blossoms on their tips.
    void draw(const Canvas &canvas, const std::shared_ptr<const lessons::View> &view, const sim::State &state,
              const std::optional<QColor> &bark = {});
    /// Draws thin lines: both edges of thick branches, the middle of others.
    void drawOutline(const Canvas &canvas, const std::shared_ptr<const lessons::View> &view,
                     const sim::State &state, const QColor &color);

private:
    /// A branch on the screen.
    struct Branch
    {
        int number = 0;
        QPointF from;
        QPointF along; ///< unit vector
        double length = 0.0;
        double width = 0.0;  ///< at its start
        double narrow = 0.0; ///< at its end
        QPointF to() const { return from + length * along; }
    };

    struct Blossom
    {
        QPointF centre; ///< on the screen
        double radius = 0.0;
    };

    void plan(const std::shared_ptr<const lessons::View> &view);
    /// Calls `visit` with each branch that can be visible.
    template <class Visit>
    void visitBranches(const Canvas &canvas, const sim::State &state, double least, Visit &&visit) const;
    void addTwig(const Branch &branch, const Thinning &thinning);
    static void drawTaper(QPainter &painter, const Branch &branch);
    void addBlossom(const Branch &branch, double size);
    void drawBlossoms(QPainter &painter, const SkyColors &colors);

    std::shared_ptr<const lessons::View> m_view; ///< the view for which the data below was computed
    std::vector<double> m_narrow;                ///< px, the width of each branch at its end
    std::vector<char> m_isTip;
    int m_tips = 0;

    Stencil m_thin;                                 ///< twigs, or the lines of an outline
    std::array<std::vector<Blossom>, 3> m_blossoms; ///< grouped by colour
    int m_blossomEvery = 1;
};

}
