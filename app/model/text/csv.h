#pragma once

#include <QByteArray>
#include <QString>

namespace app {

// Fields of comma-separated tables.

/// Appends `value` with the fewest digits, at most 17, that read back as the same number. Appends nothing for a
/// value that is not finite.
void appendNumber(QByteArray &text, double value);
/// Appends a comma and `value`, as appendNumber().
void appendField(QByteArray &text, double value);
/// Returns a quoted field that can hold any text.
QByteArray quotedField(QString text);

}
