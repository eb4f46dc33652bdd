#pragma once

#include "app/model/map_plane.h"
#include "app/model/session.h"
#include "app/ui/theme/theme.h"
#include "app/ui/window/left.h"

#include <QSize>
#include <QString>

#include <cstdint>
#include <memory>
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

/// The lessons and what is open of them: stays while a window closes and the next one opens, each with an application of
/// its own.
struct Work
{
    LessonLibrary library;
    std::unique_ptr<Session> session; ///< null before the first window
    QString language;                 ///< of the library's texts
};

/// Shows the window, with the experiment `file` unless that is empty, or with what another one has left for it, and runs
/// until it is closed.
WindowEnd runWindow(QApplication &application, Work &work, const QString &file,
                    const std::optional<Left> &from = {});

/// Puts the texts of `other` in place of those of `library`, where lessons and steps are the same.
void retranslate(LessonLibrary &library, LessonLibrary other);

/// Draws the window without showing it. Returns the exit code; says on stderr what is wrong.
int takeScreenshot(QApplication &application, const ScreenshotRequest &request);

}
