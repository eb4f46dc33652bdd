#pragma once

#include "app/model/sandbox/blueprint_limits.h"

#include <QCoreApplication>

namespace app {

/// The name, unit, help text and range of a property of the parts of a sandbox scene, before translation.
struct PropertyRange
{
    const char *id;
    const char *name;
    const char *unit;
    const char *help;
    Span span;
    int decimals;
};

constexpr PropertyRange range(const char *id, const char *name, const char *unit, const char *help, Span span,
                              int decimals)
{
    return {id, name, unit, help, span, decimals};
}

/// The properties that can be set.
class PropertyRanges
{
    Q_DECLARE_TR_FUNCTIONS(PropertyRangesText)

public:
    static constexpr PropertyRange x = range("x", QT_TR_NOOP("x"), QT_TR_NOOP("px"),
                                             QT_TR_NOOP("How far to the right it starts."), built::place, 0);
    static constexpr PropertyRange y =
        range("y", QT_TR_NOOP("y"), QT_TR_NOOP("px"), QT_TR_NOOP("How far down it starts."), built::place, 0);
    static constexpr PropertyRange vx =
        range("vx", QT_TR_NOOP("Speed x"), QT_TR_NOOP("px/frame"),
              QT_TR_NOOP("How fast it starts to the right."), built::speed, 1);
    static constexpr PropertyRange vy = range("vy", QT_TR_NOOP("Speed y"), QT_TR_NOOP("px/frame"),
                                              QT_TR_NOOP("How fast it starts downwards."), built::speed, 1);
    static constexpr PropertyRange mass =
        range("mass", QT_TR_NOOP("Mass"), nullptr, QT_TR_NOOP("How hard it is to move. Most bodies have 1."),
              built::mass, 2);
    static constexpr PropertyRange size =
        range("size", QT_TR_NOOP("Size"), QT_TR_NOOP("px"),
              QT_TR_NOOP("Its width: walls stop its edge, and the wind pushes against it."), built::size, 0);
    static constexpr PropertyRange fixed = range("fixed", QT_TR_NOOP("Nailed"), nullptr,
                                                 QT_TR_NOOP("Whether it is fixed in place."), {0.0, 1.0}, 0);
    static constexpr PropertyRange stiffness = range(
        "k", QT_TR_NOOP("Stiffness"), QT_TR_NOOP("1/frame²"),
        QT_TR_NOOP("How hard it pulls a body of mass 1: this share of the missing distance in each frame."),
        built::stiffness, 2);
    static constexpr PropertyRange length =
        range("length", QT_TR_NOOP("Length"), QT_TR_NOOP("px"),
              QT_TR_NOOP("How far apart its two ends should be."), built::length, 0);
    static constexpr PropertyRange share = range(
        "share", QT_TR_NOOP("Share"), nullptr,
        QT_TR_NOOP(
            "The share of a length error that its first end corrects; the other end corrects the rest."),
        built::share, 2);
    static constexpr PropertyRange angle =
        range("angle", QT_TR_NOOP("Angle"), QT_TR_NOOP("°"),
              QT_TR_NOOP("The angle of the foot, seen from its body: 0 is left of the body, 90 above it."),
              built::angle, 0);
    static constexpr PropertyRange leg =
        range("leg", QT_TR_NOOP("Leg"), QT_TR_NOOP("px"),
              QT_TR_NOOP("How long the legs of this gait group are."), built::length, 0);
    static constexpr PropertyRange drop =
        range("drop", QT_TR_NOOP("Drop"), QT_TR_NOOP("px"),
              QT_TR_NOOP("How far below the body the legs of this gait group end."), built::drop, 0);
    static constexpr PropertyRange gaitSpeed =
        range("speed", QT_TR_NOOP("Swing"), QT_TR_NOOP("rad/frame"),
              QT_TR_NOOP("How fast the clock of this gait group turns its legs. 0: they stand still. To "
                         "walk, feet need ground."),
              built::gaitSpeed, 3);
    static constexpr PropertyRange gaitStart =
        range("start", QT_TR_NOOP("Begin"), QT_TR_NOOP("rad"),
              QT_TR_NOOP("The angle at which that clock starts. Groups with different angles step in turn."),
              built::gaitStart, 2);
    static constexpr PropertyRange pullsBody =
        range("pulls_body", QT_TR_NOOP("Carries"), nullptr,
              QT_TR_NOOP("Whether the feet push the body back. If they do not, they cannot carry it."),
              {0.0, 1.0}, 0);
    static constexpr PropertyRange group =
        range("gait", QT_TR_NOOP("Group"), nullptr, QT_TR_NOOP("The gait group: its feet share one clock."),
              {0.0, 0.0}, 0);
};

}
