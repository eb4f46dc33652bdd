#pragma once

#include <QPointF>

#include <cstddef>
#include <functional>
#include <vector>

namespace app {

/// A place on a plot that means a row of a study.
struct Spot
{
    std::size_t row = 0; ///< of the study
    QPointF place;       ///< on the axes
    int line = 0;        ///< spots of one line follow each other by Left and Right
};

/// Where a spot is on the screen, in px.
using OnScreen = std::function<QPointF(const Spot &)>;

/// The spot under the pointer, as near as a hand can point; null for none.
const Spot *spotNear(const std::vector<Spot> &spots, const OnScreen &onScreen, QPointF at);

/// The spot that an arrow key leads to: the next one along the line of `from` (`along` is 1 or -1), or on another
/// line, below or above (`across` is 1 or -1). Null where there is none.
const Spot *spotBeyond(const std::vector<Spot> &spots, const OnScreen &onScreen, const Spot &from, int along,
                       int across);

}
