#include "app/model/text/csv.h"

#include <charconv>
#include <cmath>

namespace app {

void appendNumber(QByteArray &text, double value)
{
    if (!std::isfinite(value))
        return; // an empty field
    char digits[32];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, value);
    text.append(digits, end - digits);
}

void appendField(QByteArray &text, double value)
{
    text += ',';
    appendNumber(text, value);
}

QByteArray quotedField(QString text)
{
    return '"' + text.replace('"', "\"\"").toUtf8() + '"';
}

}
