#include "app/ui/scene/layers/tree_painter.h"

#include "app/ui/scene/layers/crowd.h"
#include "app/ui/scene/layers/sky.h"
#include "lessons/api/view/view.h"
#include "sim/base/random.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {

namespace {

constexpr double thinnestBranch = 0.3; ///< screen px; below this, one branch represents several
constexpr double shortest = 0.7;       ///< screen px, likewise
constexpr int mostMerged = 64; ///< branches that one branch represents at most, for each of the two reasons
constexpr double thick = 2.0;  ///< screen px; thicker branches taper and have round ends
constexpr double tipShare = 0.55;    ///< end width of a tip, as a fraction of its start width
constexpr double fineEnds = 8.0;     ///< screen px; thicker ends need more corners to look round
constexpr int petals = 9;            ///< corners of a blossom, which is too small to tell from a disc
constexpr double thickOutline = 5.0; ///< screen px; outlines of thicker branches have two sides
constexpr int mostBlossoms = 1500;
constexpr double blossomBranch = 5.0; ///< screen px; thicker tips have no blossoms
constexpr std::uint64_t treeSeed = 11;

double branchChance(int branch, int what)
{
    return sim::uniform(treeSeed, what, branch);
}

int times(double least, double is)
{
    if (is >= least)
        return 1;
    return static_cast<int>(std::ceil(std::min<double>(mostMerged, least / std::max(is, 1e-9))));
}

}

Thinning thinningOf(double length, double width)
{
    const int stronger = times(thinnestBranch, width);
    const int longer = times(shortest, length);
    return {stronger * longer, longer, stronger};
}

bool isDrawn(int branch, int every)
{
    return every <= 1 || sim::mixBits(static_cast<std::uint64_t>(branch)) % static_cast<unsigned>(every) == 0;
}

void TreePainter::plan(const std::shared_ptr<const lessons::View> &view)
{
    if (view == m_view)
        return;
    m_view = view;
    const lessons::TreeView &tree = *view->tree;
    const std::size_t count = tree.parent.size();
    m_narrow.assign(count, 0.0);
    m_isTip.assign(count, 1);
    for (std::size_t i = 0; i < count; ++i) {
        if (tree.parent[i] < 0)
            continue;
        const auto parent = static_cast<std::size_t>(tree.parent[i]);
        m_isTip[parent] = 0;
        m_narrow[parent] = std::min(tree.width[parent], std::max(m_narrow[parent], tree.width[i]));
    }
    m_tips = 0;
    for (std::size_t i = 0; i < count; ++i) {
        m_tips += m_isTip[i];
        if (m_isTip[i])
            m_narrow[i] = tipShare * tree.width[i];
    }
    m_blossomEvery = 1 + m_tips / mostBlossoms;
}

template <class Visit>
void TreePainter::visitBranches(const Canvas &canvas, const sim::State &state, double least,
                                Visit &&visit) const
{
    const lessons::TreeView &tree = *m_view->tree;
    const int count = std::min(static_cast<int>(tree.parent.size()), state.pointCount());
    if (state.angle.rows() < count)
        return;
    const double zoom = canvas.camera.zoom;
    const QTransform &toView = canvas.camera.toView;
    const QRectF area = canvas.area;
    for (int i = 0; i < count; ++i) {
        const auto row = static_cast<std::size_t>(i);
        Branch branch;
        branch.width = tree.width[row] * zoom;
        branch.length = tree.length[row] * zoom;
        const Thinning thinning = thinningOf(branch.length, std::max(least, branch.width));
        if (!isDrawn(i, thinning.every))
            continue;
        branch.from = {state.position(i, 0) * zoom + toView.dx(), state.position(i, 1) * zoom + toView.dy()};
        const double reach = branch.length * thinning.longer + branch.width + 3.0;
        if (branch.from.x() < area.left() - reach || branch.from.x() > area.right() + reach ||
            branch.from.y() < area.top() - reach || branch.from.y() > area.bottom() + reach)
            continue;
        const double angle = state.angle[i] * std::numbers::pi / 180.0;
        branch.number = i;
        branch.along = {std::cos(angle), std::sin(angle)};
        branch.narrow = m_narrow[row] * zoom;
        visit(branch, thinning);
    }
}

void TreePainter::addTwig(const Branch &branch, const Thinning &thinning)
{
    const QPointF end = branch.from + thinning.longer * branch.length * branch.along;
    m_thin.addLine({branch.from, end}, (branch.width + branch.narrow) / 2.0 * thinning.stronger);
}

void TreePainter::drawTaper(QPainter &painter, const Branch &branch)
{
    // Half a circle around each end. Branches are filled one by one, because Qt would go through a path of
    // all of them once for every few rows of the screen.
    const QPointF across(branch.along.y(), -branch.along.x());
    const int corners = branch.width < fineEnds ? 3 : 9;
    std::array<QPointF, 20> outline;
    std::size_t count = 0;
    const auto round = [&](QPointF centre, double radius, QPointF first, QPointF middle) {
        for (int i = 0; i <= corners; ++i) {
            const double turn = std::numbers::pi * i / corners;
            outline[count++] = centre + radius * (std::cos(turn) * first + std::sin(turn) * middle);
        }
    };
    round(branch.from, branch.width / 2.0, -across, -branch.along);
    round(branch.to(), branch.narrow / 2.0, across, branch.along);
    painter.drawConvexPolygon(outline.data(), static_cast<int>(count));
}

void TreePainter::addBlossom(const Branch &branch, double size)
{
    if (branch.width > blossomBranch || branchChance(branch.number, 2) * m_blossomEvery >= 1.0)
        return;
    const auto color = static_cast<std::size_t>(3.0 * branchChance(branch.number, 1));
    m_blossoms[color].push_back({branch.to(), (1.5 + 1.1 * branchChance(branch.number, 0)) * size});
}

void TreePainter::draw(const Canvas &canvas, const std::shared_ptr<const lessons::View> &view,
                       const sim::State &state, const std::optional<QColor> &bark)
{
    plan(view);
    // Blossoms shrink with the zoom, but grow more slowly than the zoom.
    const double size = std::min(canvas.camera.zoom, std::sqrt(canvas.camera.zoom));
    const bool isOpen = view->sky == lessons::View::Sky::dusk;
    const SkyColors colors = skyColors(canvas.theme.scheme());
    canvas.painter.setPen(Qt::NoPen);
    canvas.painter.setBrush(bark.value_or(isOpen ? colors.bark : canvas.tokens().body));
    begin(m_thin, canvas);
    visitBranches(canvas, state, 0.0, [&](const Branch &branch, const Thinning &thinning) {
        if (branch.width >= thick)
            drawTaper(canvas.painter, branch);
        else
            addTwig(branch, thinning);
        if (m_isTip[static_cast<std::size_t>(branch.number)])
            addBlossom(branch, size);
    });
    m_thin.paint(canvas.painter, bark.value_or(isOpen ? colors.twigs : canvas.tokens().body));
    drawBlossoms(canvas.painter, colors);
}

void TreePainter::drawBlossoms(QPainter &painter, const SkyColors &colors)
{
    std::array<QPointF, petals> unit;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        const double turn = 2.0 * std::numbers::pi * static_cast<double>(i) / petals;
        unit[i] = {std::cos(turn), std::sin(turn)};
    }
    painter.setPen(Qt::NoPen);
    for (std::size_t i = 0; i < m_blossoms.size(); ++i) {
        painter.setBrush(colors.blossoms[i]); // opaque: much cheaper
        for (const Blossom &blossom : m_blossoms[i]) {
            std::array<QPointF, petals> outline;
            for (std::size_t k = 0; k < unit.size(); ++k)
                outline[k] = blossom.centre + blossom.radius * unit[k];
            painter.drawConvexPolygon(outline.data(), petals);
        }
        m_blossoms[i].clear();
    }
    painter.setBrush(Qt::NoBrush);
}

void TreePainter::drawOutline(const Canvas &canvas, const std::shared_ptr<const lessons::View> &view,
                              const sim::State &state, const QColor &color)
{
    plan(view);
    begin(m_thin, canvas);
    visitBranches(canvas, state, 1.0, [&](const Branch &branch, const Thinning &thinning) {
        const QPointF end = branch.from + thinning.longer * branch.length * branch.along;
        if (branch.width < thickOutline) {
            m_thin.addLine({branch.from, end}, 1.0);
            return;
        }
        const QPointF across(branch.along.y(), -branch.along.x());
        for (const double side : {-0.5, 0.5})
            m_thin.addLine({branch.from + side * branch.width * across, end + side * branch.narrow * across},
                           1.0);
    });
    m_thin.paint(canvas.painter, color);
}

}
