#pragma once

#include <QString>
#include <QStringList>

namespace support {

/// Returns all that `pattern` finds in a text, sorted.
QStringList foundIn(const QString &text, const QString &pattern);
/// Returns the code in a text, sorted. Plain numbers in it have the decimal point of English.
QStringList codeIn(const QString &text);
/// Returns whether the numbers of a text have a decimal comma. Those in formulas of the code keep the point.
bool hasDecimalCommas(const QString &text);

}
