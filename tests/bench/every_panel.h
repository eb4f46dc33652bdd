#pragma once

#include "app/ui/window/main_window.h"

/// Opens "LESSON/STEP,PARAMETER=VALUE..." in its initial state.
void openStep(app::Session &session, const QString &what);

/// Opens all panels and three plots, in the arrangement of Measure mode if there is enough space. Otherwise
/// uses that of Learn mode, with the panels that do not fit as tabs.
void openEveryPanel(app::MainWindow &window);

/// Shows all panels at once without tabs: lessons, code, parameters and values, three plots, and the energy
/// and effect ledgers. Needs a window of at least 1920 x 1080 px.
void showEveryPanel(app::MainWindow &window);
