#pragma once

#include "app/ui/help/tour.h"

namespace app {

class LearnPanel;
class ParameterPanel;
class RunCommands;
class SceneColumn;

/// Returns the cards of the tour of a window with these parts.
std::vector<TourStop> tourStops(const QWidget &window, const SceneColumn &centre, const LearnPanel &learn,
                                const QWidget &code, const ParameterPanel &parameters,
                                const RunCommands &commands);

}
