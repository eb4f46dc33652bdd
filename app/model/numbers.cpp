#include "app/model/numbers.h"

#include <QLocale>

#include <cmath>

namespace app {

namespace {

constexpr QChar minus(0x2212);
constexpr double longest = 1e7; ///< from here on numbers are written with a power of ten

QString withPower(double value)
{
    QString text = QString::number(value, 'g', QLocale::FloatingPointShortest);
    text.replace("e+0", "e").replace("e+", "e").replace("e-0", "e-");
    return text;
}

/// Without the sign of a number that is shown as 0.
QString signedText(QString text)
{
    if (text.startsWith('-') && text.toDouble() == 0.0)
        text.remove(0, 1);
    return text.replace('-', minus);
}

}

QString fixedNumber(double value, int decimals)
{
    return signedText(QString::number(value, 'f', decimals));
}

QString writtenNumber(double value, int decimals)
{
    if (std::abs(value) >= longest)
        return signedText(withPower(value));
    QString text = QString::number(value, 'f', decimals);
    if (text.toDouble() != value)
        text = QString::number(value, 'g', QLocale::FloatingPointShortest);
    return signedText(text);
}

}
