#pragma once

#include "app/ui/theme/theme.h"

#include <QTextDocument>
#include <QUrl>

#include <map>

namespace app {

class Glossary;

/// The typography of a Markdown text.
struct ProseStyle
{
    double size = 13;       ///< px, a whole number: Qt draws only whole sizes
    double lineHeight = 20; ///< px
    double paragraphGap = 6;
    QColor text;
    QColor bold;
    QFont::Weight boldWeight = QFont::DemiBold;
    double tracking = 0; ///< px, added between letters
    QFont::Weight weight = QFont::Normal;
};

/// A sign without width, at which no line breaks. setProse() puts it into `++`.
inline constexpr QChar unbroken(0x2060);

/// Fills `document` with `markdown`. Line heights are set here, because Qt style sheets cannot set them.
void setProse(QTextDocument &document, const QString &markdown, const ProseStyle &style, const Theme &theme);

/// Lays `document` out for `width`, px, unless it is already; Qt would do it again.
void layOut(QTextDocument &document, double width);

/// The heights that a text has at widths asked for. Layouts ask for the same ones again and again, and laying out a
/// text takes most of the time in which a window opens.
class ProseHeights
{
public:
    /// Returns the height of `document` at `width`, px. The document may keep any width.
    int at(int width, QTextDocument &document);
    /// Forgets the heights; to be called after each change of the document.
    void forget() { m_heights.clear(); }

private:
    std::map<int, int> m_heights;
};

/// Returns the link to a glossary word. wordOf() returns the word of such a link, or an empty text for any
/// other link.
QUrl wordLink(const QString &name);
QString wordOf(const QUrl &link);

/// Makes the first occurrence of each word of `glossary` a link. The links keep the text colour, so that they
/// do not distract the reader.
void linkWords(QTextDocument &document, const Glossary &glossary, const Theme &theme);

/// Returns the link to a step. stepOf() returns the ids of such a link, or empty ids for any other link.
QUrl stepLink(const QString &lesson, const QString &step);
struct StepPlace
{
    QString lesson;
    QString step;
};
StepPlace stepOf(const QUrl &link);

/// Returns whether a word of the text is a link.
bool hasLinks(const QTextDocument &document);

/// Returns the text without Markdown syntax, in one line, for screen readers. Spaces that no line breaks at stay.
QString plainText(const QString &markdown);

}
