#pragma once

#include <QByteArray>
#include <QString>

namespace app {

/// Returns the content of a file of at most `largest` bytes. It may be a pipe or a device.
/// @throws UserError: there is no such file, it is a folder or too large, or it cannot be read
QByteArray readWholeFile(const QString &path, qsizetype largest);

/// Writes `content` to a temporary file and renames it, so that a failure leaves the old file unchanged.
/// @throws UserError: the file cannot be written
void writeWholeFile(const QString &path, const QByteArray &content);

}
