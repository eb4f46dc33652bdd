#pragma once

#include "app/ui/scene/canvas.h"
#include "app/ui/scene/stencil.h"

#include <array>
#include <memory>
#include <vector>

namespace app {

struct SkyColors;

/// How much of the branches of one size is drawn: one in `every`, and each `longer` times as long and `stronger`
/// times as strong, so that all together cover as much as they should.
struct Thinning
{
    int every = 1;
    int longer = 1;
    int stronger = 1;
};

/// For branches of `length` and `width` px of the screen.
Thinning thinningOf(double length, double width);
/// Whether branch number `branch` is the one in `every` that is drawn: always the same ones.
bool isDrawn(int branch, int every);

/// Paints trees, thin branches all at once, with all detail that shows and not more. Keeps its working memory
/// from one frame to the next.
class TreePainter
{
public:
    /// Branches, in the colour `bark` where it is given, and blossoms on their tips.
    void draw(const Canvas &canvas, const std::shared_ptr<const lessons::View> &look, const sim::State &state,
              const std::optional<QColor> &bark = {});
    /// Thin lines: of thick branches the edges, of others the middle.
    void drawOutline(const Canvas &canvas, const std::shared_ptr<const lessons::View> &look,
                     const sim::State &state, const QColor &color);

private:
    /// A branch on the screen.
    struct Branch
    {
        int number = 0;
        QPointF from;
        QPointF along; ///< of length 1
        double length = 0.0;
        double width = 0.0;  ///< where it begins
        double narrow = 0.0; ///< where it ends
        QPointF to() const { return from + length * along; }
    };

    struct Blossom
    {
        QPointF centre; ///< on the screen
        double radius = 0.0;
    };

    void plan(const std::shared_ptr<const lessons::View> &look);
    /// Calls `visit` with each branch that can show.
    template <class Visit>
    void visitBranches(const Canvas &canvas, const sim::State &state, double least, Visit &&visit) const;
    void addTwig(const Branch &branch, const Thinning &thinning);
    static void drawTaper(QPainter &painter, const Branch &branch);
    void addBlossom(const Branch &branch, double size);
    void drawBlossoms(QPainter &painter, const SkyColors &colors);

    std::shared_ptr<const lessons::View> m_look; ///< what the plan below is for
    std::vector<double> m_narrow;                ///< px, the width of each branch where it ends
    std::vector<char> m_isTip;
    int m_tips = 0;

    Stencil m_thin;                                 ///< twigs, or the lines of an outline
    std::array<std::vector<Blossom>, 3> m_blossoms; ///< by colour
    int m_blossomEvery = 1;
};

}
