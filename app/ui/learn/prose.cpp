#include "app/ui/learn/prose.h"

#include "app/model/text/glossary.h"
#include "app/model/text/numbers.h"

#include <QFontMetricsF>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextCursor>

#include <cmath>

namespace app {

namespace {

QTextCharFormat styled(const QTextCharFormat &from, const ProseStyle &style, const Theme &theme)
{
    QTextCharFormat format;
    const bool bold = from.fontWeight() > QFont::Normal;
    const bool code = from.fontFixedPitch();
    QFont font =
        code ? theme.mono(style.size - 1) : theme.ui(style.size, bold ? style.boldWeight : style.weight);
    font.setItalic(from.fontItalic());
    if (style.tracking != 0.0 && !code)
        font.setLetterSpacing(QFont::AbsoluteSpacing, style.tracking);
    format.setFont(font);
    format.setForeground(bold || code ? style.bold : style.text);
    if (from.isAnchor()) {
        format.setAnchor(true);
        format.setAnchorHref(from.anchorHref());
        format.setForeground(theme.tokens().link);
        format.setUnderlineStyle(QTextCharFormat::DotLine);
        format.setUnderlineColor(theme.tokens().link);
    }
    return format;
}

void styleFragments(const QTextBlock &block, const ProseStyle &style, const Theme &theme)
{
    struct Piece
    {
        int start;
        int end;
        QTextCharFormat format;
    };
    std::vector<Piece> pieces; // collected first, because setting a format changes the fragments
    for (auto it = block.begin(); !it.atEnd(); ++it) {
        const QTextFragment fragment = it.fragment();
        pieces.push_back({fragment.position(), fragment.position() + fragment.length(),
                          styled(fragment.charFormat(), style, theme)});
    }
    QTextCursor cursor(block);
    for (const Piece &piece : pieces) {
        cursor.setPosition(piece.start);
        cursor.setPosition(piece.end, QTextCursor::KeepAnchor);
        cursor.setCharFormat(piece.format);
    }
}

}

void setProse(QTextDocument &document, const QString &markdown, const ProseStyle &style, const Theme &theme)
{
    document.setUndoRedoEnabled(false);
    document.setDocumentMargin(0);
    if (const QFont font = theme.ui(style.size); document.defaultFont() != font)
        document.setDefaultFont(font);
    QTextCursor all(&document);
    all.beginEditBlock(); // laid out once, at its end
    // Qt breaks lines between the two signs of `i++`.
    document.setMarkdown(
        withoutBreaksInNumbers(markdown).replace(QStringLiteral("++"), '+' + QString(unbroken) + '+'),
        QTextDocument::MarkdownNoHTML);
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        styleFragments(block, style, theme);
        QTextBlockFormat format = block.blockFormat();
        format.setLineHeight(style.lineHeight, QTextBlockFormat::FixedHeight);
        format.setTopMargin(block.blockNumber() > 0 ? style.paragraphGap : 0);
        format.setBottomMargin(0);
        QTextCursor(block).setBlockFormat(format);
    }
    all.endEditBlock();
}

void layOut(QTextDocument &document, double width)
{
    if (document.textWidth() != width)
        document.setTextWidth(width);
}

int ProseHeights::at(int width, QTextDocument &document)
{
    const auto known = m_heights.find(width);
    if (known != m_heights.end())
        return known->second;
    layOut(document, width);
    return m_heights[width] = static_cast<int>(std::ceil(document.size().height()));
}

QUrl wordLink(const QString &name)
{
    return QUrl(QStringLiteral("word:") + QString::fromLatin1(QUrl::toPercentEncoding(name)));
}

QString wordOf(const QUrl &link)
{
    return link.scheme() == u"word" ? link.path(QUrl::FullyDecoded) : QString();
}

QUrl stepLink(const QString &lesson, const QString &step)
{
    return QUrl(QStringLiteral("step:%1/%2").arg(lesson, step));
}

StepPlace stepOf(const QUrl &link)
{
    if (link.scheme() != u"step")
        return {};
    return {link.path().section('/', 0, 0), link.path().section('/', 1)};
}

void linkWords(QTextDocument &document, const Glossary &glossary, const Theme &theme)
{
    QTextCursor cursor(&document);
    cursor.beginEditBlock();
    for (const Mention &mention : glossary.mentionsIn(document.toPlainText())) {
        cursor.setPosition(static_cast<int>(mention.start) + 1);
        if (cursor.charFormat().isAnchor())
            continue;
        cursor.setPosition(static_cast<int>(mention.start));
        cursor.setPosition(static_cast<int>(mention.start + mention.length), QTextCursor::KeepAnchor);
        QTextCharFormat format;
        format.setAnchor(true);
        format.setAnchorHref(
            wordLink(glossary.entries()[mention.entry].term.name).toString(QUrl::FullyEncoded));
        format.setUnderlineStyle(QTextCharFormat::DotLine);
        format.setUnderlineColor(theme.tokens().link);
        cursor.mergeCharFormat(format);
    }
    cursor.endEditBlock();
}

bool hasLinks(const QTextDocument &document)
{
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        for (auto it = block.begin(); !it.atEnd(); ++it) {
            if (it.fragment().charFormat().isAnchor())
                return true;
        }
    }
    return false;
}

QString plainText(const QString &markdown)
{
    QTextDocument document;
    document.setMarkdown(markdown, QTextDocument::MarkdownNoHTML);
    // Not simplified(): it makes ordinary spaces of those between a number and its unit.
    static const QRegularExpression breaks(QStringLiteral("[ \\t\\n\\x{2028}\\x{2029}]+"));
    return document.toRawText().replace(breaks, QStringLiteral(" ")).trimmed();
}

}
