#include "app/ui/code/code_colors.h"

#include <QRegularExpression>
#include <QSet>

namespace app {

namespace {

bool isKeyword(const QString &word)
{
    static const QSet<QString> keywords = {
        "auto",      "bool",     "break",   "case",     "catch",       "char",     "class",  "const",
        "constexpr", "continue", "default", "do",       "double",      "else",     "enum",   "explicit",
        "false",     "float",    "for",     "friend",   "if",          "inline",   "int",    "long",
        "namespace", "new",      "nullptr", "operator", "override",    "private",  "public", "return",
        "short",     "signed",   "sizeof",  "static",   "static_cast", "struct",   "switch", "template",
        "this",      "throw",    "true",    "try",      "typename",    "unsigned", "using",  "virtual",
        "void",      "while",
    };
    return keywords.contains(word);
}

/// Returns whether a word is a type: an upper-case letter followed by lower-case letters.
bool isType(const QString &word)
{
    static const QRegularExpression type(QStringLiteral("^[A-Z]\\w*[a-z]"));
    return type.match(word).hasMatch();
}

Ink inkOf(const QString &token)
{
    if (token.startsWith(QLatin1String("//")))
        return Ink::comment;
    if (token[0] == '"' || token[0] == '\'')
        return Ink::text;
    if (token[0].isDigit())
        return Ink::number;
    if (isKeyword(token))
        return Ink::keyword;
    return isType(token) ? Ink::type : Ink::plain;
}

}

QByteArray inksOf(const QString &line)
{
    static const QRegularExpression tokens(QStringLiteral(
        R"(//.*|"(?:\\.|[^"\\])*"|'(?:\\.|[^'\\])*'|\d[\d.']*(?:e[+-]?\d+)?\w*|[A-Za-z_]\w*)"));
    QByteArray inks;
    qsizetype end = 0;
    const auto add = [&](qsizetype from, qsizetype to, Ink ink) {
        inks.append(QStringView(line).mid(from, to - from).toUtf8().size(), static_cast<char>(ink));
    };
    for (auto found = tokens.globalMatch(line); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        add(end, match.capturedStart(), Ink::plain);
        add(match.capturedStart(), match.capturedEnd(), inkOf(match.captured()));
        end = match.capturedEnd();
    }
    add(end, line.size(), Ink::plain);
    return inks;
}

}
