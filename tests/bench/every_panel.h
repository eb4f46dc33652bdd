#pragma once

#include "app/ui/window/main_window.h"

/// Opens "LESSON/STEP,PARAMETER=VALUE..." as it was when it was first opened.
void openStep(app::Session &session, const QString &what);

/// All panels and three plots: as Measure has them where there is room for that, else as Learn has them, with what there is no
/// room for as tabs.
void openEveryPanel(app::MainWindow &window);

/// Lessons, code, parameters and values, three plots, the ledger of energy and that of effects, all of them seen at once:
/// none is a tab. Meant for windows from 1920 x 1080 px on.
void showEveryPanel(app::MainWindow &window);
