#pragma once

#include <QString>

namespace app {

// Texts about what the scene shows, in the window and on web pages. Numbers go in place of %1, %2...

/// The texts of the unit circle.
struct UnitCircleWords
{
    QString title;
    QString noLength, noDirection; ///< two lines about an arrow without length
    QString angle;                 ///< in degrees and in radians
    QString side;                  ///< cosine or sine = a side / the length = the number
    QString cosine, beside;
    QString sine, opposite;
    QString pythagoras;
    QString down;
};
UnitCircleWords unitCircleWords();

/// Returns the meaning of the legend's arrow: its velocity, px/frame.
QString velocityScaleWords();
/// Returns the meaning of the legend's arrow: its acceleration, px/frame^2.
QString pullScaleWords();
/// Returns the meaning of onion skins, which are so many frames apart.
QString onionWords();

}
