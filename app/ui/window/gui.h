#pragma once

#include "app/model/analysis/map_plane.h"
#include "app/model/session/session.h"
#include "app/ui/theme/theme.h"
#include "app/ui/window/restart.h"

#include <QSize>
#include <QString>

#include <cstdint>
#include <memory>
#include <optional>

class QApplication;

namespace app {

/// A picture of the window, for `springstep screenshot`.
struct ScreenshotRequest
{
    QString lesson;
    QString step;
    std::int64_t frame = 0;
    int phase = 0; ///< phases done inside the frame
    QSize size{1280, 800};
    Scheme scheme = Scheme::light;
    bool measuring = false;      ///< in the measure mode
    bool energy = false;         ///< with the energy panel
    bool effects = false;        ///< with the effects panel, measured
    bool plots = false;          ///< in front of other tabs
    bool reasons = false;        ///< with the stability panel
    std::optional<MapPlane> map; ///< with the growth map
    bool settling = false;       ///< with the map of settling times
    QString out;                 ///< a file name; its ending tells the format
};

/// How a window ended.
struct WindowEnd
{
    int code = 0;                     ///< the exit code
    std::optional<Handover> handover; ///< for another window that opens at once
};

/// The lessons and the session. They stay while a window closes and the next one opens, each with an application of its
/// own.
struct Work
{
    LessonLibrary library;
    std::unique_ptr<Session> session; ///< null before the first window
    QString language;                 ///< of the library's texts
};

/// Shows the window until it is closed. It opens the experiment `file` unless that is empty, or continues from an
/// earlier window.
WindowEnd runWindow(QApplication &application, Work &work, const QString &file,
                    const std::optional<Handover> &from = {});

/// Replaces the texts of `library` by those of `other`, where lessons and steps are the same.
void retranslate(LessonLibrary &library, LessonLibrary other);

/// Draws the window without showing it. Returns the exit code; errors go to stderr.
int takeScreenshot(QApplication &application, const ScreenshotRequest &request);

}
