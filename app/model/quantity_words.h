#pragma once

#include "app/model/quantity.h"

#include <QString>

namespace app {

// What quantities are called.

/// "y", "speed", "kinetic energy": without whose it is.
QString measuredTitle(Measured what);
/// One sentence: what it is.
QString measuredHelp(Measured what);
/// "px", "px/frame", "frames"; of energies in a scene whose points turn another than in one whose points move.
QString unitOf(Measured what, bool turns);
/// "y of foot 1", "distance foot 1 – body", "total energy", "time". The quantity must name its bodies.
QString quantityTitle(const Quantity &quantity);
/// The same in the letters of files: "y(foot0)", "distance(foot0, body)".
QString quantityName(const Quantity &quantity);
/// Why there is nothing to plot in this scene, and what helps.
QString noValueWords(const Quantity &quantity, const sim::Scene &scene, NoValue why);
/// A number with its unit, as it is read beside a plot: "183.21 px"; "–" where there is none.
QString valueWords(double value, const QString &unit);

}
