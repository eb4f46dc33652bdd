#pragma once

#include <QByteArray>
#include <QString>

namespace app {

// Fields of tables as text, comma-separated.

/// In the fewest digits, 17 at most, that are read back as the same number. What is not finite adds nothing.
void appendNumber(QByteArray &text, double value);
/// A field that holds any text.
QByteArray quotedField(QString text);

}
