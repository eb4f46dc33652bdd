#include "app/model/words.h"

#include <QLocale>

#include <cmath>

namespace app {

namespace {

QString printable(QString text)
{
    for (QChar &c : text) {
        if (!c.isPrint() && !c.isSurrogate())
            c = c.isSpace() ? QChar(' ') : QChar(QChar::ReplacementCharacter);
    }
    return text;
}

}

QString quoted(const QString &text)
{
    constexpr int most = 40;
    const bool isLong = text.size() > most;
    return '"' + printable(isLong ? text.left(most) + QChar(0x2026) : text) + '"';
}

QString quotedList(const QStringList &texts)
{
    constexpr int most = 40;
    QStringList list;
    for (const QString &text : texts.mid(0, most))
        list.push_back(quoted(text));
    if (texts.size() > most)
        list.push_back(QChar(0x2026));
    return list.join(", ");
}

QString withoutPadding(QString number)
{
    return number.replace("e+0", "e").replace("e+", "e").replace("e-0", "e-");
}

QString exactNumber(double value)
{
    const double size = std::abs(value);
    const bool isPlain = size == 0.0 || (size >= 1e-6 && size < 1e15);
    return withoutPadding(QString::number(value, isPlain ? 'f' : 'g', QLocale::FloatingPointShortest));
}

QString toleranceNumber(double tolerance)
{
    if (tolerance >= 1.0)
        return exactNumber(tolerance);
    return withoutPadding(QString::number(tolerance, 'e', QLocale::FloatingPointShortest));
}

QString oneLine(const QString &text)
{
    QString line = printable(text).simplified();
    while (line.endsWith('.'))
        line.chop(1);
    return line;
}

}
