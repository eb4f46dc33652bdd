#include "app/model/breakpoints/condition_tokens.h"

#include "app/model/breakpoints/condition_names.h"
#include "app/model/text/quoting.h"
#include "app/model/text/user_error.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace app {

namespace {

using Word = ConditionToken;
using condition_names::refuse;

struct ConditionTokensText
{
    Q_DECLARE_TR_FUNCTIONS(ConditionTokensText)
};

/// Alternative spellings of signs. Those of two characters must come first.
struct Spelling
{
    const char16_t *written;
    const char16_t *sign;
};

constexpr Spelling spellings[] = {
    {u"<=", u"<="}, {u">=", u">="}, {u"==", u"=="}, {u"!=", u"!="}, {u"&&", u"and"}, {u"||", u"or"},
    {u"≤", u"<="},  {u"≥", u">="},  {u"≠", u"!="},  {u"<", u"<"},   {u">", u">"},    {u"+", u"+"},
    {u"-", u"-"},   {u"−", u"-"},   {u"*", u"*"},   {u"×", u"*"},   {u"·", u"*"},    {u"/", u"/"},
    {u"÷", u"/"},   {u"(", u"("},   {u")", u")"},   {u"!", u"not"},
};

Word numberAt(const QString &text, qsizetype from)
{
    static const QRegularExpression number(
        QStringLiteral("\\G(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?[\\w.]*"));
    const QString written = number.match(text, from).captured();
    bool isNumber = false;
    const double value = written.toDouble(&isNumber);
    if (!isNumber || !std::isfinite(value))
        refuse(from + 1, ConditionTokensText::tr("%1 is not a number; write one like 380, 0.5 or 1e-3.")
                             .arg(quoted(written)));
    return {Word::Kind::number, written, value, from + 1};
}

Word nameAt(const QString &text, qsizetype from)
{
    static const QRegularExpression name(QStringLiteral("\\G[A-Za-z_]\\w*(\\.\\w+)*"));
    const QString written = name.match(text, from).captured();
    const bool isSign = written == u"and" || written == u"or" || written == u"not";
    return {isSign ? Word::Kind::sign : Word::Kind::name, written, 0.0, from + 1};
}

/// Returns the quotation mark that closes `mark`; null if `mark` is not an opening quotation mark.
QChar closing(QChar mark)
{
    if (mark == u'"' || mark == u'\'')
        return mark;
    return mark == u'“' || mark == u'„' ? u'”' : QChar();
}

Word textAt(const QString &text, qsizetype from)
{
    const QChar last = closing(text[from]);
    const auto ends = [last](QChar c) { return c == last || (last == u'”' && (c == u'“' || c == u'"')); };
    const auto begin = text.begin() + from + 1;
    const auto end = std::find_if(begin, text.end(), ends);
    if (end == text.end())
        refuse(
            from + 1,
            ConditionTokensText::tr("This text has no closing quotation mark; close it with %1.").arg(last));
    return {Word::Kind::text, text.mid(from + 1, end - begin), 0.0, from + 1};
}

const Spelling *signAt(const QString &text, qsizetype from)
{
    const QStringView rest = QStringView(text).mid(from);
    const auto found = std::find_if(std::begin(spellings), std::end(spellings), [&](const Spelling &one) {
        return rest.startsWith(QStringView(one.written));
    });
    return found == std::end(spellings) ? nullptr : found;
}

[[noreturn]] void refuseCharacter(const QString &text, qsizetype at)
{
    if (text[at] == '=')
        refuse(at + 1,
               ConditionTokensText::tr("A single “=” would set a value; write == to compare two values."));
    if (text[at] == ',')
        refuse(at + 1,
               ConditionTokensText::tr(
                   "A comma has no meaning here; write 0.5 with a point, and join conditions with “and”."));
    refuse(at + 1, ConditionTokensText::tr(
                       "%1 has no meaning here; there are numbers, names, + - * / ( ), comparisons, and, "
                       "or, not.")
                       .arg(quoted(text.mid(at, text[at].isHighSurrogate() ? 2 : 1))));
}

}

std::vector<ConditionToken> conditionWords(const QString &text)
{
    std::vector<Word> words;
    int open = 0; // parentheses; between them, a comma separates two bodies
    for (qsizetype at = 0; at < text.size();) {
        const QChar c = text[at];
        const bool isPoint = c == '.' && at + 1 < text.size() && text[at + 1].isDigit();
        if (c.isSpace()) {
            ++at;
        } else if ((c >= '0' && c <= '9') || isPoint) {
            words.push_back(numberAt(text, at));
            at += words.back().text.size();
        } else if ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_') {
            words.push_back(nameAt(text, at));
            at += words.back().text.size();
        } else if (!closing(c).isNull()) {
            words.push_back(textAt(text, at));
            at += words.back().text.size() + 2;
        } else if (c == ',' && open > 0) {
            words.push_back({Word::Kind::sign, QStringLiteral(","), 0.0, at + 1});
            ++at;
        } else if (const Spelling *sign = signAt(text, at)) {
            open += c == '(' ? 1 : c == ')' ? -1 : 0;
            words.push_back({Word::Kind::sign, QString::fromUtf16(sign->sign), 0.0, at + 1});
            at += QStringView(sign->written).size();
        } else {
            refuseCharacter(text, at);
        }
    }
    words.push_back({Word::Kind::end, {}, 0.0, text.size() + 1});
    return words;
}

}
