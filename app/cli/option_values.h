#pragma once

#include "app/cli/verbs.h"
#include "app/ui/theme/theme.h"

#include <QSize>

namespace app {

// The values of options. All of these throw a UsageError if the value is not valid.

/// Returns the value of `option` if it is a number from `least` to `most`.
double numberOption(const Arguments &arguments, const QString &option, double least, double most);
/// Returns the value of `option` if it is a whole number from 0 to `most`.
std::int64_t wholeNumberOption(const Arguments &arguments, const QString &option, std::int64_t most);
/// Returns the value of --size.
QSize pictureSize(const Arguments &arguments);
/// Returns the value of --theme.
Scheme colorScheme(const Arguments &arguments);
/// Returns the code of the language of --language: that of the system without it.
QString languageCode(const Arguments &arguments);

}
