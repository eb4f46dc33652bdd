// Layers of sticks, of the limbs around them, and of rule links.

#include "app/ui/scene/layers/layers.h"
#include "app/ui/scene/layers/material.h"
#include "app/ui/scene/layers/sticks.h"
#include "lessons/api/view/view.h"

#include "sim/effects/constraints/stick.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double calm = 0.01;            ///< the strain up to which a stick counts as correct
constexpr double worst = 0.20;           ///< the strain at which a stick has the full warning colour
constexpr double thinnest = 0.5;         ///< of a stick's width, at +worst
constexpr double thickest = 1.7;         ///< of a stick's width, at −worst
constexpr double finest = 1.2;           ///< screen px
constexpr double besideJoint = 2.;       ///< px between a joint's disc and the end cap
constexpr double leastRound = 5.0;       ///< screen px; thinner sticks have no sheen
constexpr double sheenWidth = 0.2;       ///< as a fraction of the rod's width
constexpr double ruleLinkWidth = 1.2;    ///< screen px
constexpr double ruleLinkShare = 0.75;   ///< opacity
constexpr std::size_t crowdedLinks = 60; ///< so many rule links are drawn paler, because most of them cross
constexpr double crowdedShare = 0.3;     ///< opacity of so many
constexpr double sheenUp = 0.24;         ///< offset from the middle, as a fraction of the rod's width

/// Returns 0 up to `calm` and 1 from `worst` on.
double badness(double strain)
{
    return std::clamp((std::abs(strain) - calm) / (worst - calm), 0.0, 1.0);
}

/// Draws a short bar across the stick, just beside the disc at its end.
void drawCap(const Canvas &canvas, const QLineF &stick, int point, double width)
{
    const QPointF u = (stick.p2() - stick.p1()) / stick.length();
    const QPointF across = (width + 2.0) * QPointF(-u.y(), u.x());
    const double away = canvas.discRadius(point) + besideJoint + width / 2.0;
    if (2.0 * away > stick.length())
        return;
    const QPointF middle = stick.p1() + away * u;
    canvas.painter.drawLine(middle - across, middle + across);
}

/// Draws a highlight along the upper side of a rod.
void drawSheen(const Canvas &canvas, const QLineF &rod, double width, const QColor &color)
{
    const double length = rod.length();
    if (isFlat(canvas.theme) || width < leastRound || length <= 0.0)
        return;
    QPointF up(rod.dy() / length, -rod.dx() / length);
    if (up.y() > 0.0 || (up.y() == 0.0 && up.x() > 0.0))
        up = -up;
    canvas.painter.setPen(solid(mixed(color, Qt::white, 0.4), sheenWidth * width));
    canvas.painter.drawLine(rod.translated(sheenUp * width * up));
}

void drawStick(const Canvas &canvas, const lessons::StickView &stick)
{
    const sim::State &state = canvas.shown.state();
    const QLineF line(canvas.camera.at(state.positionOf(stick.a)),
                      canvas.camera.at(state.positionOf(stick.b)));
    const QLineF visible = canvas.cut(line.p1(), line.p2());
    if (visible.isNull())
        return;
    const double strain = stickStrain(stick, state);
    const double width = std::max(finest, stick.width * stickSwelling(strain) * canvas.camera.zoom);
    const QColor color = stickColor(canvas.tokens(), strain);
    canvas.painter.setPen(solid(color, width));
    canvas.painter.drawLine(visible);
    drawSheen(canvas, visible, width, color);
    canvas.painter.setPen(solid(canvas.tokens().stick, std::clamp(width * 0.6, 1.2, 4.0)));
    drawCap(canvas, line, stick.a, width);
    drawCap(canvas, QLineF(line.p2(), line.p1()), stick.b, width);
}

}

double stickStrain(const lessons::StickView &stick, const sim::State &state)
{
    if (!(stick.length > 0.0))
        return 0.0;
    return sim::stickError(state.positionOf(stick.a), state.positionOf(stick.b), stick.length) / stick.length;
}

QColor stickColor(const Tokens &tokens, double strain)
{
    const double bad = badness(strain);
    if (bad < 0.5)
        return mixed(tokens.stick, tokens.near, 2.0 * bad);
    return mixed(tokens.near, tokens.past, 2.0 * bad - 1.0);
}

double stickSwelling(double strain)
{
    return 1.0 + badness(strain) * ((strain > 0.0 ? thinnest : thickest) - 1.0);
}

void drawLimbs(const Canvas &canvas)
{
    const sim::State &state = canvas.shown.state();
    const QColor color = canvas.tokens().body;
    for (const lessons::LimbView &limb : canvas.shown.view().limbs) {
        const double width = std::max(finest, limb.width * canvas.camera.zoom);
        const QLineF line = canvas.cut(canvas.camera.at(state.positionOf(limb.a)),
                                       canvas.camera.at(state.positionOf(limb.b)));
        canvas.painter.setPen(solid(color, width));
        canvas.painter.drawLine(line);
    }
}

void drawSticks(const Canvas &canvas)
{
    for (const lessons::StickView &stick : canvas.shown.view().sticks)
        drawStick(canvas, stick);
}

void drawRuleLinks(const Canvas &canvas)
{
    const sim::State &state = canvas.shown.state();
    const std::vector<lessons::RuleLinkView> &links = canvas.shown.view().ruleLinks;
    const double share = links.size() < crowdedLinks ? ruleLinkShare : crowdedShare;
    canvas.painter.setPen(dashed(faded(canvas.tokens().rule, share), ruleLinkWidth, {8.0, 4.0, 1.0, 4.0}));
    for (const lessons::RuleLinkView &link : links)
        canvas.painter.drawLine(canvas.cut(canvas.camera.at(state.positionOf(link.a)),
                                           canvas.camera.at(state.positionOf(link.b))));
}

}
