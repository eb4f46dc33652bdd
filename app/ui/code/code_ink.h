#pragma once

#include <QByteArray>
#include <QString>

namespace app {

/// The styles of the code view, by their numbers there.
enum class Ink : char { plain, keyword, number, type, comment, text, heading, caption };

/// The style of each byte of a line of C++, in UTF-8.
QByteArray inksOf(const QString &line);

}
