#pragma once

#include "app/model/series/quantity.h"

#include <QString>

#include <optional>

namespace app {

// Names and units of quantities.

/// Returns the name of a quantity without its bodies: "y", "speed", "kinetic energy".
QString kindTitle(QuantityKind what);
/// Returns one sentence that explains the quantity.
QString kindHelp(QuantityKind what);
/// Returns the unit of a quantity: "px", "px/frame", "frames". The unit of an energy depends on whether the scene's
/// points turn (`turns`) or move.
QString unitOf(QuantityKind what, bool turns);
/// Returns the title of a quantity: "y of foot 1", "distance foot 1 – body", "total energy", "time". The quantity
/// must name its bodies.
QString quantityTitle(const Quantity &quantity);
/// Returns the name of a quantity as files write it: "y(foot0)", "distance(foot0, body)".
QString quantityName(const Quantity &quantity);
/// Returns the quantity of such a name. Its body may be missing: "y". Empty if there is no quantity of that name.
std::optional<Quantity> quantityFrom(const QString &name);
/// Returns why this scene has nothing to plot, and how to fix that.
QString noValueWords(const Quantity &quantity, const sim::Scene &scene, NoValue why);
/// Returns a number with its unit, as shown beside a plot: "183.21 px". Returns "–" if there is no number.
QString valueWords(double value, const QString &unit);

}
