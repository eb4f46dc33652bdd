#include "app/ui/scene/drawing/body_text.h"

#include "app/model/text/numbers.h"
#include "app/model/text/sentences.h"

#include <QCoreApplication>

#include <cmath>

namespace app {

namespace {

struct BodyText
{
    Q_DECLARE_TR_FUNCTIONS(BodyText)
};

constexpr double still = 0.05; ///< px/frame; a slower body is shown as 0.0

}

QString bodySentence(const QString &name, sim::Vec2 at, sim::Vec2 speed)
{
    const QString place =
        BodyText::tr("%1 at (%2, %3)").arg(bodyTitle(name), fixedNumber(at.x, 0), fixedNumber(at.y, 0));
    const double fast = shownLength(speed);
    if (fast < still)
        return BodyText::tr("%1, at rest").arg(place);
    return BodyText::tr("%1, moving %2 px a frame").arg(place, fixedNumber(fast, 1));
}

QString shownMagnitude(double value)
{
    if (value != 0.0 && std::abs(value) < 0.005)
        return "< " + fixedNumber(0.01, 2);
    if (std::abs(value) >= 1000.0)
        return roughNumber(value);
    return fixedNumber(value, 2);
}

}
