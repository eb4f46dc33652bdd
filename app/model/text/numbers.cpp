#include "app/model/text/numbers.h"

#include "app/model/text/quoting.h"

#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

namespace {

constexpr QChar minus(0x2212);
constexpr double leastWithPower = 1e7; ///< from this value on, numbers are written with a power of ten

/// Returns `text` with the learner's decimal sign, and without a minus sign if the shown number is 0.
QString signedText(QString text)
{
    bool isNumber = false; // QString cannot read "-2·10⁹"
    if (text.startsWith('-') && text.toDouble(&isNumber) == 0.0 && isNumber)
        text.remove(0, 1);
    return text.replace('-', minus).replace('.', QLocale().decimalPoint());
}

}

QString fixedNumber(double value, int decimals)
{
    if (std::abs(value) >= leastWithPower)
        return roughNumber(value);
    return signedText(QString::number(value, 'f', decimals));
}

QString writtenNumber(double value, int decimals)
{
    if (std::abs(value) >= leastWithPower)
        return signedText(withoutPadding(QString::number(value, 'g', QLocale::FloatingPointShortest)));
    QString text = QString::number(value, 'f', decimals);
    if (text.toDouble() != value)
        text = QString::number(value, 'g', QLocale::FloatingPointShortest);
    return signedText(text);
}

double shownLength(sim::Vec2 a)
{
    return std::min(std::hypot(a.x, a.y), std::numeric_limits<double>::max());
}

QString powerOfTen(int exponent)
{
    static constexpr char16_t raised[] = {0x2070, 0x00B9, 0x00B2, 0x00B3, 0x2074,
                                          0x2075, 0x2076, 0x2077, 0x2078, 0x2079};
    QString text = QStringLiteral("10");
    for (const QChar c : QString::number(exponent))
        text += c == '-' ? QChar(0x207B) : QChar(raised[c.digitValue()]);
    return text;
}

QString roughNumber(double value)
{
    const double size = std::abs(value);
    if (value == 0.0 || !std::isfinite(value))
        return signedText(QString::number(value));
    if (size >= 99.5 && size < 1e5)
        return signedText(QString::number(value, 'f', 0));
    // Rounding first makes 0.000996 count as 0.0010, as it is shown.
    const QString rounded = QString::number(value, 'e', 1);
    const int exponent = rounded.section('e', 1).toInt();
    if (exponent >= -3 && exponent < 5)
        return signedText(QString::number(rounded.toDouble(), 'g', 2));
    QString digits = rounded.section('e', 0, 0);
    if (digits.endsWith(".0"))
        digits.chop(2);
    const QString power = powerOfTen(exponent);
    return signedText(digits == "1" ? power : digits + QChar(0x00B7) + power);
}

QString withoutBreaksInNumbers(QString markdown)
{
    static const QRegularExpression times(QStringLiteral("(?<=\\d)[ \\n]×[ \\n](?=[\\d(−])"));
    static const QRegularExpression beforeUnit(QStringLiteral("(?<=\\d)[ \\n](?=(?:px|rad|µs|%|°)(?!\\w))"));
    markdown.replace(QChar(0x2009), QChar(0x202F)); // a line can break at a thin space
    markdown.replace(times, QStringLiteral("\u00A0×\u00A0"));
    return markdown.replace(beforeUnit, QStringLiteral("\u202F"));
}

}
