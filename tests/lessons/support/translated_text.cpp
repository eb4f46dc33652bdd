#include "tests/lessons/support/translated_text.h"

#include <QRegularExpression>

#include <algorithm>

namespace support {

namespace {

const QString codePattern = QStringLiteral("`[^`]*`");

/// Returns whether code consists of numbers and units, without a name of the listing.
bool hasOnlyNumbers(QString code)
{
    return !code.remove(QRegularExpression("\\b(rad|px)\\b")).contains(QRegularExpression("[A-Za-z_]"));
}

}

QStringList foundIn(const QString &text, const QString &pattern)
{
    QStringList all;
    for (auto at = QRegularExpression(pattern).globalMatch(text); at.hasNext();)
        all << at.next().captured();
    std::sort(all.begin(), all.end());
    return all;
}

QStringList codeIn(const QString &text)
{
    QStringList all = foundIn(text, codePattern);
    for (QString &code : all) {
        if (hasOnlyNumbers(code))
            code.replace(QRegularExpression("(?<=\\d),(?=\\d)"), ".");
    }
    all.sort();
    return all;
}

bool hasDecimalCommas(const QString &text)
{
    QString prose = text;
    for (const QString &code : foundIn(text, codePattern)) {
        if (!hasOnlyNumbers(code))
            prose.remove(code);
    }
    // A point before three digits groups the digits of a large number.
    return foundIn(prose, "(?<![\\d.])\\d+\\.\\d+(?![\\d.])") ==
           foundIn(prose, "(?<![\\d.])\\d{1,3}\\.\\d{3}(?![\\d.])");
}

}
