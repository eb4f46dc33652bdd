// The editing marks that are drawn over the scene in a sandbox.

#include "app/ui/sandbox/scene_builder.h"

namespace app {

namespace {

constexpr double ringGap = 5.0;  ///< px of the screen
constexpr double crossArm = 9.0; ///< px of the screen
constexpr double askedWidth = 2.0;
constexpr double askedGap = 6.0; ///< px of the screen
constexpr double askedRadius = 14.0;
constexpr double bandWidth = 9.0;
constexpr double bandShade = 0.22;

QPointF placeOn(const Canvas &canvas, int point)
{
    return canvas.camera.at(canvas.shown.state().positionOf(point));
}

void drawRing(const Canvas &canvas, int point, double more)
{
    const double radius = canvas.camera.radius(canvas.shown.radius(point)) + ringGap + more;
    canvas.painter.drawEllipse(placeOn(canvas, point), radius, radius);
}

/// Draws a band under the selected links.
template <class Links>
void drawBands(const Canvas &canvas, const Links &links, const std::vector<int> &chosen)
{
    canvas.painter.setPen(solid(faded(canvas.tokens().ink, bandShade), bandWidth));
    for (const int one : chosen) {
        const auto &link = links[std::size_t(one)];
        canvas.painter.drawLine(canvas.cut(placeOn(canvas, link.a), placeOn(canvas, link.b)));
    }
}

void drawCross(const Canvas &canvas, QPointF at)
{
    canvas.painter.setPen(solid(canvas.tokens().ink, 1.5));
    canvas.painter.drawLine(at - QPointF(crossArm, 0.0), at + QPointF(crossArm, 0.0));
    canvas.painter.drawLine(at - QPointF(0.0, crossArm), at + QPointF(0.0, crossArm));
}

void drawBox(const Canvas &canvas, const QRectF &box)
{
    const QRectF seen(canvas.camera.at({box.left(), box.top()}),
                      canvas.camera.at({box.right(), box.bottom()}));
    canvas.painter.setPen(dashed(canvas.tokens().ink2, 1.0, {4.0, 3.0}));
    canvas.painter.setBrush(faded(canvas.tokens().ink, 0.06));
    canvas.painter.drawRect(seen);
    canvas.painter.setBrush(Qt::NoBrush);
}

}

void BuildLayer::drawLinkUnderWay(const Canvas &canvas) const
{
    const SandboxEditor &editor = *m_marks.editor;
    const std::optional<sim::Vec2> end = m_marks.cursor ? m_marks.cursor : m_marks.pointer;
    if (editor.first() && !m_marks.from)
        drawRing(canvas, *editor.first(), 3.0);
    if (!end || (!editor.first() && !m_marks.from))
        return;
    const QPointF from = m_marks.from ? canvas.camera.at(*m_marks.from) : placeOn(canvas, *editor.first());
    canvas.painter.setPen(dashed(canvas.tokens().ink2, 1.5, {4.0, 3.0}));
    canvas.painter.drawLine(canvas.cut(from, canvas.camera.at(*end)));
}

void BuildLayer::drawTarget(const Canvas &canvas) const
{
    canvas.painter.setPen(solid(canvas.tokens().now, askedWidth));
    for (const int point : m_marks.guide->points())
        drawRing(canvas, point, askedGap);
    if (const std::optional<sim::Vec2> place = m_marks.guide->place()) {
        const QPointF at = canvas.camera.at(*place);
        drawCross(canvas, at);
        canvas.painter.setPen(solid(canvas.tokens().now, askedWidth));
        canvas.painter.drawEllipse(at, askedRadius, askedRadius);
    }
}

void BuildLayer::draw(const Canvas &canvas) const
{
    const SandboxEditor &editor = *m_marks.editor;
    if (!editor.isUpToDate() || std::size_t(canvas.shown.points()) != editor.plan().points.size())
        return; // the view may repaint before every part of the program has the edited scene
    QPainter &p = canvas.painter;
    p.setBrush(Qt::NoBrush);
    drawBands(canvas, editor.plan().springs, editor.chosen().springs);
    drawBands(canvas, editor.plan().sticks, editor.chosen().sticks);
    drawBands(canvas, editor.plan().ruleLinks, editor.chosen().ruleLinks);
    p.setPen(solid(canvas.tokens().ink, 1.5));
    for (const int point : editor.chosen().points)
        drawRing(canvas, point, 0.0);
    if (!editor.canBuild())
        return;
    drawLinkUnderWay(canvas);
    if (m_marks.guide->isOn())
        drawTarget(canvas);
    if (m_marks.cursor)
        drawCross(canvas, canvas.camera.at(*m_marks.cursor));
    if (m_marks.box)
        drawBox(canvas, *m_marks.box);
}

}
