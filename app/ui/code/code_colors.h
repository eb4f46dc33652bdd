#pragma once

#include <QByteArray>
#include <QString>

namespace app {

/// The styles of the code view. The values are Scintilla's style numbers.
enum class Ink : char { plain, keyword, number, type, comment, text, heading, caption };

/// Returns the style of each UTF-8 byte of a line of C++.
QByteArray inksOf(const QString &line);

}
