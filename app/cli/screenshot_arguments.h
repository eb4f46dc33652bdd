#pragma once

#include "app/ui/window/gui.h"

#include <QStringList>

#include <variant>

namespace app {

// What the options of pictures say. @throws Refusal
/// The number of an option, from 0 to `most`.
std::int64_t wholeNumber(const QString &option, const QString &text, std::int64_t most);
/// Of --size.
QSize pictureSize(const QString &text);
/// Of --theme.
Scheme schemeOf(const QString &text);

/// What `springstep screenshot` is to draw; or the exit code, when that is settled: for help and for bad use.
std::variant<int, ScreenshotRequest> readScreenshotArguments(const QStringList &arguments);

}
