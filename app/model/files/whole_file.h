#pragma once

#include <QByteArray>
#include <QString>

namespace app {

/// Writes `content` to a temporary file and renames it, so that a failure leaves the old file unchanged.
/// @throws UserError: the file cannot be written
void writeWholeFile(const QString &path, const QByteArray &content);

}
