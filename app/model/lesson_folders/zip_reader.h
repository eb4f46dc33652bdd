#pragma once

#include <QByteArray>
#include <QString>

#include <map>

namespace app {

/// The bounds of a zip that is read.
struct ZipLimits
{
    std::size_t files = 0;
    qsizetype file = 0; ///< bytes
    qsizetype all = 0;  ///< bytes
};

/// Reads all files of a zip into memory. If all of them are in one folder, its name is left out. `name` is the name of the
/// zip in messages.
/// @throws UserError: it is no zip or damaged, has more than `limits` allow, or something that a plain zip of one folder does
/// not have: a path out of it, a folder inside it, a link, a name twice, a password
std::map<QString, QByteArray> readZip(const QByteArray &zip, const QString &name, const ZipLimits &limits);

}
