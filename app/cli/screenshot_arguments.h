#pragma once

#include "app/ui/window/gui.h"

#include <QStringList>

#include <variant>

namespace app {

/// What `springstep screenshot` is to draw; or the exit code, when that is settled: for help and for bad use.
std::variant<int, ScreenshotRequest> readScreenshotArguments(const QStringList &arguments);

}
