#include "app/ui/window/gui.h"

#include "app/cli/command_line.h"

#include <QCoreApplication>

/// For builds without the window.
namespace app {

int runWindow(QApplication &, const QString &)
{
    return refuseUse(QCoreApplication::translate("CommandLine", "this build has no window."));
}

int takeScreenshot(QApplication &, const ScreenshotRequest &)
{
    return refuseUse(QCoreApplication::translate("CommandLine", "this build has no window."));
}

}
