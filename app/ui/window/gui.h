#pragma once

#include "app/model/map_plane.h"
#include "app/ui/theme/theme.h"
#include "app/ui/window/left.h"

#include <QSize>
#include <QString>

#include <cstdint>
#include <optional>

class QApplication;

namespace app {

/// A picture of the window, as `springstep screenshot` makes it.
struct ScreenshotRequest
{
    QString lesson;
    QString step;
    std::int64_t frame = 0;
    int phase = 0; ///< phases done inside the frame
    QSize size{1280, 800};
    Scheme scheme = Scheme::light;
    bool measuring = false;      ///< arranged for measuring, with all that is measured
    bool energy = false;         ///< whether the ledger of energy is shown
    bool effects = false;        ///< whether the ledger of effects is shown, and measured
    bool plots = false;          ///< in front of other tabs
    bool reasons = false;        ///< with what bounds the step
    std::optional<MapPlane> map; ///< and the map of growth
    QString out;                 ///< a file name; its ending tells the format
};

/// How a window ended.
struct WindowEnd
{
    int code = 0;             ///< the exit code
    std::optional<Left> left; ///< for another window that is to open at once
};

/// Shows the window, with the experiment `file` unless that is empty, or with what another one has left for it, and runs
/// until it is closed.
WindowEnd runWindow(QApplication &application, const QString &file, const std::optional<Left> &from = {});

/// Draws the window without showing it. Returns the exit code; says on stderr what is wrong.
int takeScreenshot(QApplication &application, const ScreenshotRequest &request);

}
