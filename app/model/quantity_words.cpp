#include "app/model/quantity_words.h"

#include "app/model/energy_lines.h"
#include "app/model/numbers.h"
#include "app/model/sentences.h"
#include "app/model/words.h"

#include <QCoreApplication>

#include <cmath>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Quantity)
};

constexpr double smallest = 1e-3; ///< below, numbers are written with a power of ten

}

QString measuredTitle(Measured what)
{
    switch (what) {
    case Measured::time:
        return Text::tr("time");
    case Measured::placeX:
        return Text::tr("x");
    case Measured::placeY:
        return Text::tr("y");
    case Measured::velocityX:
        return Text::tr("velocity x");
    case Measured::velocityY:
        return Text::tr("velocity y");
    case Measured::speed:
        return Text::tr("speed");
    case Measured::accelerationX:
        return Text::tr("acceleration x");
    case Measured::accelerationY:
        return Text::tr("acceleration y");
    case Measured::acceleration:
        return Text::tr("size of acceleration");
    case Measured::angle:
        return Text::tr("angle");
    case Measured::spin:
        return Text::tr("turning speed");
    case Measured::ownMotion:
        return Text::tr("kinetic energy");
    case Measured::distance:
        return Text::tr("distance");
    case Measured::motion:
        return Text::tr("kinetic energy of all");
    case Measured::stored:
        return Text::tr("potential energy of all");
    case Measured::energy:
        break;
    }
    return Text::tr("total energy");
}

QString measuredHelp(Measured what)
{
    switch (what) {
    case Measured::time:
        return Text::tr("Frames since the start of the run");
    case Measured::placeX:
        return Text::tr("How far to the right it is");
    case Measured::placeY:
        return Text::tr("How far down it is: y grows downwards, in the picture and in plots");
    case Measured::velocityX:
        return Text::tr("How far it comes to the right in a frame");
    case Measured::velocityY:
        return Text::tr("How far it comes down in a frame");
    case Measured::speed:
        return Text::tr("How far it comes in a frame, whichever way");
    case Measured::accelerationX:
        return Text::tr("By how much its velocity to the right changed in the last frame");
    case Measured::accelerationY:
        return Text::tr("By how much its velocity downwards changed in the last frame");
    case Measured::acceleration:
        return Text::tr("By how much its velocity changed in the last frame, whichever way");
    case Measured::angle:
        return Text::tr("Where it points: 0° is to the right, and 90° is down");
    case Measured::spin:
        return Text::tr("By how much its angle changes in a frame");
    case Measured::ownMotion:
        return Text::tr("Half its mass times the square of its speed");
    case Measured::distance:
        return Text::tr("How far two bodies are from each other, centre to centre");
    case Measured::motion:
        return Text::tr("The energy of motion of everything together");
    case Measured::stored:
        return Text::tr("What springs hold, and what lies high");
    case Measured::energy:
        break;
    }
    return Text::tr("Kinetic and potential energy of everything together");
}

QString unitOf(Measured what, bool turns)
{
    switch (what) {
    case Measured::time:
        return Text::tr("frames");
    case Measured::placeX:
    case Measured::placeY:
    case Measured::distance:
        return Text::tr("px");
    case Measured::velocityX:
    case Measured::velocityY:
    case Measured::speed:
        return Text::tr("px/frame");
    case Measured::accelerationX:
    case Measured::accelerationY:
    case Measured::acceleration:
        return Text::tr("px/frame²");
    case Measured::angle:
        return Text::tr("degrees");
    case Measured::spin:
        return Text::tr("degrees/frame");
    default:
        return energyUnit(turns);
    }
}

QString quantityTitle(const Quantity &quantity)
{
    const QString title = measuredTitle(quantity.what);
    switch (aboutOf(quantity.what)) {
    case About::run:
        return title;
    case About::oneBody:
        return Text::tr("%1 of %2").arg(title, bodyTitle(quantity.body));
    case About::twoBodies:
        break;
    }
    return Text::tr("%1 %2 – %3").arg(title, bodyTitle(quantity.body), bodyTitle(quantity.other));
}

QString quantityName(const Quantity &quantity)
{
    const QString id = idOf(quantity.what);
    switch (aboutOf(quantity.what)) {
    case About::run:
        return id;
    case About::oneBody:
        return QStringLiteral("%1(%2)").arg(id, quantity.body);
    case About::twoBodies:
        break;
    }
    return QStringLiteral("%1(%2, %3)").arg(id, quantity.body, quantity.other);
}

QString noValueWords(const Quantity &quantity, const sim::Scene &scene, NoValue why)
{
    const bool isOther = scene.find(quantity.body.toStdString()) >= 0;
    switch (why) {
    case NoValue::noSuchBody:
        return Text::tr("Nothing here is called %1. The curve comes back with the next step that has one; or "
                        "choose another body above.")
            .arg(bodyTitle(isOther ? quantity.other : quantity.body));
    case NoValue::noInertia:
        return Text::tr("Something else puts %1 where it goes, so it keeps no velocity. Its position can be "
                        "plotted: choose that above.")
            .arg(bodyTitle(quantity.body));
    case NoValue::noAngle:
        return Text::tr("What this scene moves are points: they have no angle. Branches of a tree have one.");
    case NoValue::noEnergyHere:
        break;
    }
    return noEnergyWords(sim::StoredEnergyReader::whyNot(scene).value_or(sim::NoEnergy::nothingMoves));
}

QString valueWords(double value, const QString &unit)
{
    if (!std::isfinite(value))
        return QStringLiteral("–");
    const double size = std::abs(value);
    const QString number = size != 0.0 && size < smallest ? roughNumber(value) : fixedNumber(value, 2);
    return number + QChar(0x2009) + unit;
}

}
