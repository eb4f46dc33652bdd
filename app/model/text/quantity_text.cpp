#include "app/model/text/quantity_text.h"

#include "app/model/analysis/energy_lines.h"
#include "app/model/text/numbers.h"
#include "app/model/text/sentences.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <cmath>

namespace app {

namespace {

struct QuantityText
{
    Q_DECLARE_TR_FUNCTIONS(QuantityText)
};

constexpr double smallest = 1e-3; ///< smaller numbers are written with a power of ten

struct Words
{
    QString title;
    QString help;
};

Words wordsFor(QuantityKind what)
{
    switch (what) {
    case QuantityKind::time:
        return {QuantityText::tr("time"), QuantityText::tr("Frames since the start of the run")};
    case QuantityKind::placeX:
        return {QuantityText::tr("x"), QuantityText::tr("How far to the right it is")};
    case QuantityKind::placeY:
        return {QuantityText::tr("y"),
                QuantityText::tr("How far down it is: y grows downwards, in the picture and in plots")};
    case QuantityKind::velocityX:
        return {QuantityText::tr("velocity x"), QuantityText::tr("How far it moves to the right in a frame")};
    case QuantityKind::velocityY:
        return {QuantityText::tr("velocity y"), QuantityText::tr("How far it moves down in a frame")};
    case QuantityKind::speed:
        return {QuantityText::tr("speed"), QuantityText::tr("How far it moves in a frame, in any direction")};
    case QuantityKind::accelerationX:
        return {QuantityText::tr("acceleration x"),
                QuantityText::tr("How much its velocity to the right changed in the last frame")};
    case QuantityKind::accelerationY:
        return {QuantityText::tr("acceleration y"),
                QuantityText::tr("How much its velocity downwards changed in the last frame")};
    case QuantityKind::acceleration:
        return {QuantityText::tr("size of acceleration"),
                QuantityText::tr("How much its velocity changed in the last frame, in any direction")};
    case QuantityKind::angle:
        return {QuantityText::tr("angle"),
                QuantityText::tr("Where it points: 0° is to the right, and 90° is down")};
    case QuantityKind::spin:
        return {QuantityText::tr("turning speed"), QuantityText::tr("How much its angle changes in a frame")};
    case QuantityKind::ownMotion:
        return {QuantityText::tr("kinetic energy"),
                QuantityText::tr("Half its mass times the square of its speed")};
    case QuantityKind::distance:
        return {QuantityText::tr("distance"),
                QuantityText::tr("How far two bodies are from each other, centre to centre")};
    case QuantityKind::motion:
        return {QuantityText::tr("total kinetic energy"),
                QuantityText::tr("The energy of motion of everything together")};
    case QuantityKind::stored:
        return {QuantityText::tr("total potential energy"),
                QuantityText::tr("The energy stored in springs and in height")};
    case QuantityKind::energy:
        break;
    }
    return {QuantityText::tr("total energy"),
            QuantityText::tr("Kinetic and potential energy of everything together")};
}

}

QString kindTitle(QuantityKind what)
{
    return wordsFor(what).title;
}

QString kindHelp(QuantityKind what)
{
    return wordsFor(what).help;
}

QString unitOf(QuantityKind what, bool turns)
{
    switch (what) {
    case QuantityKind::time:
        return QuantityText::tr("frames");
    case QuantityKind::placeX:
    case QuantityKind::placeY:
    case QuantityKind::distance:
        return QuantityText::tr("px");
    case QuantityKind::velocityX:
    case QuantityKind::velocityY:
    case QuantityKind::speed:
        return QuantityText::tr("px/frame");
    case QuantityKind::accelerationX:
    case QuantityKind::accelerationY:
    case QuantityKind::acceleration:
        return QuantityText::tr("px/frame²");
    case QuantityKind::angle:
        return QuantityText::tr("degrees");
    case QuantityKind::spin:
        return QuantityText::tr("degrees/frame");
    default:
        return energyUnit(turns);
    }
}

QString quantityTitle(const Quantity &quantity)
{
    const QString title = kindTitle(quantity.what);
    switch (aboutOf(quantity.what)) {
    case About::run:
        return title;
    case About::oneBody:
        return QuantityText::tr("%1 of %2").arg(title, bodyTitle(quantity.body));
    case About::twoBodies:
        break;
    }
    return QuantityText::tr("%1 %2 – %3").arg(title, bodyTitle(quantity.body), bodyTitle(quantity.other));
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

std::optional<Quantity> quantityFrom(const QString &name)
{
    static const QRegularExpression form(
        QStringLiteral("\\A\\s*(\\w+)\\s*(?:\\(\\s*([^,()]+?)\\s*(?:,\\s*([^,()]+?)\\s*)?\\)\\s*)?\\z"));
    const QRegularExpressionMatch match = form.match(name);
    const std::optional<QuantityKind> what = quantityKindFrom(match.captured(1));
    if (!what)
        return std::nullopt;
    const Quantity quantity{*what, match.captured(2), match.captured(3)};
    const About about = aboutOf(*what);
    const bool isTooFew = about == About::twoBodies && quantity.other.isEmpty();
    const bool isTooMany =
        about == About::run ? !quantity.body.isEmpty() : about == About::oneBody && !quantity.other.isEmpty();
    return isTooFew || isTooMany ? std::nullopt : std::optional(quantity);
}

QString noValueWords(const Quantity &quantity, const sim::Scene &scene, NoValue why)
{
    const bool isOther = scene.find(quantity.body.toStdString()) >= 0;
    switch (why) {
    case NoValue::noSuchBody:
        return QuantityText::tr("There is no %1 in this step. Choose another body above. The curve returns "
                                "in the next step that has %1.")
            .arg(bodyTitle(isOther ? quantity.other : quantity.body));
    case NoValue::noInertia:
        return QuantityText::tr("%1 is moved from outside, so it has no velocity of its own. Choose its "
                                "position above instead.")
            .arg(bodyTitle(quantity.body));
    case NoValue::noAngle:
        return QuantityText::tr(
            "This scene has only points, and points have no angle. Choose another quantity above.");
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
