#pragma once

#include "app/ui/window/main_window.h"

namespace app {

/// px that the scene has at least; less only when nothing else is left to give.
constexpr QSize leastScene{480, 220};
/// px that the window has at least.
constexpr QSize leastWindow{480, 420};

/// What stepped aside.
struct MainWindow::Aside
{
    Way way;
    std::vector<QDockWidget *> panels; ///< that were hidden
    QSize least;                       ///< px that the window needs to have it back
};

}
