#include "app/model/text/quoting.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace app {

namespace {

struct QuotingText
{
    Q_DECLARE_TR_FUNCTIONS(QuotingText)
};

/// Returns whether the character is visible and does not break the line.
bool isSeen(char32_t character)
{
    switch (QChar::category(character)) {
    case QChar::Separator_Line:
    case QChar::Separator_Paragraph:
    case QChar::Other_Control:
    case QChar::Other_Format:
    case QChar::Other_Surrogate:
    case QChar::Other_PrivateUse:
    case QChar::Other_NotAssigned:
        return false;
    default:
        return true;
    }
}

QString escapeOf(QStringView character)
{
    if (character == u'\n')
        return QStringLiteral("\\n");
    if (character == u'\r')
        return QStringLiteral("\\r");
    if (character == u'\t')
        return QStringLiteral("\\t");
    QString escape;
    for (const QChar unit : character)
        escape += QStringLiteral("\\u%1").arg(unit.unicode(), 4, 16, QLatin1Char('0'));
    return escape;
}

/// Returns the characters of `text`, each as a message shows it.
QStringList shownCharacters(QStringView text)
{
    QStringList shown;
    for (qsizetype i = 0; i < text.size();) {
        const bool isPair = text[i].isHighSurrogate() && i + 1 < text.size() && text[i + 1].isLowSurrogate();
        const QStringView one = text.sliced(i, isPair ? 2 : 1);
        const char32_t code = isPair ? QChar::surrogateToUcs4(one[0], one[1]) : one[0].unicode();
        shown << (isSeen(code) ? one.toString() : escapeOf(one));
        i += one.size();
    }
    return shown;
}

/// Returns the longest prefix of `characters` with at most `most` letters in total.
QStringList fitting(const QStringList &characters, qsizetype most)
{
    qsizetype length = 0;
    const auto end = std::find_if(characters.begin(), characters.end(), [&](const QString &one) {
        length += one.size();
        return length > most;
    });
    return {characters.begin(), end};
}

/// Returns how many letters must be added, removed or replaced to turn `a` into `b`.
qsizetype distance(const QString &a, const QString &b)
{
    std::vector<qsizetype> row(static_cast<std::size_t>(b.size()) + 1);
    std::iota(row.begin(), row.end(), 0);
    for (qsizetype i = 0; i < a.size(); ++i) {
        qsizetype diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 1; j < row.size(); ++j) {
            const qsizetype replaced = diagonal + (a[i] == b[static_cast<qsizetype>(j) - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
        }
    }
    return row.back();
}

/// Returns the `count` texts that are most similar to `given`.
QStringList nearest(const QStringList &texts, const QString &given, qsizetype count)
{
    constexpr qsizetype longestCompared = 100; // no name is longer, and the cost of the distance is quadratic
    const QString wanted = given.left(longestCompared).toLower();
    std::vector<std::pair<qsizetype, QString>> all;
    for (const QString &text : texts)
        all.push_back({distance(wanted, text.left(longestCompared).toLower()), text});
    std::stable_sort(all.begin(), all.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
    QStringList first;
    for (const auto &[away, text] : all) {
        if (first.size() < count)
            first << text;
    }
    return first;
}

}

QString escaped(const QString &text)
{
    return shownCharacters(text).join(QString());
}

QString quoted(const QString &text)
{
    constexpr qsizetype most = 40;
    const QStringList shown = shownCharacters(QStringView(text).left(most + 2));
    const QStringList start = fitting(shown, most);
    const QString rest = start.size() < shown.size() ? QString(QChar(0x2026)) : QString();
    return '"' + start.join(QString()) + rest + '"';
}

QString shownPath(const QString &path)
{
    constexpr qsizetype end = 100;
    const QStringList shown = shownCharacters(path);
    const QString whole = shown.join(QString());
    if (whole.size() <= 2 * end)
        return whole;
    const QStringList start = fitting(shown, end);
    QStringList back = fitting(QStringList(shown.rbegin(), shown.rend()), end);
    std::reverse(back.begin(), back.end());
    return start.join(QString()) + QChar(0x2026) + back.join(QString());
}

QString quotedList(const QStringList &texts, const QString &given)
{
    constexpr qsizetype longest = 200;
    constexpr qsizetype few = 5;
    QStringList list;
    for (const QString &text : texts.mid(0, longest / 2))
        list << quoted(text);
    if (texts.size() <= few || (list.size() == texts.size() && list.join(", ").size() <= longest))
        return list.join(", ");
    list.clear();
    for (const QString &text : nearest(texts, given, few))
        list << quoted(text);
    return QuotingText::tr("%1 and %2 more").arg(list.join(", ")).arg(texts.size() - few);
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
    QString line = escaped(text.simplified());
    while (line.endsWith('.'))
        line.chop(1);
    return line;
}

}
