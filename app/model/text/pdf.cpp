#include "app/model/text/pdf.h"

#include <QAbstractTextDocumentLayout>
#include <QBuffer>
#include <QGuiApplication>
#include <QPageSize>
#include <QPdfWriter>
#include <QScreen>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextFrame>

#include <memory>

namespace app {

namespace {

bool isHeading(const QTextBlock &block)
{
    return block.blockFormat().headingLevel() > 0;
}

void beginPageAt(QTextDocument &document, int block)
{
    QTextCursor cursor(document.findBlockByNumber(block));
    QTextBlockFormat format = cursor.blockFormat();
    format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
    cursor.setBlockFormat(format);
}

/// Begins a page at each heading that would stand alone at the end of one.
void keepHeadingsWithTheirText(QTextDocument &document, QPdfWriter &writer)
{
    // As QTextDocument::print() lays it out, with margins of 2 cm in px of the screen.
    const std::unique_ptr<QTextDocument> paper(document.clone());
    paper->documentLayout()->setPaintDevice(&writer);
    QTextFrameFormat frame = paper->rootFrame()->frameFormat();
    frame.setMargin(static_cast<int>(2 / 2.54 * QGuiApplication::primaryScreen()->logicalDotsPerInchY()));
    paper->rootFrame()->setFrameFormat(frame);
    paper->setPageSize(QSizeF(writer.width(), writer.height()));
    const auto pageOf = [&](const QTextBlock &block) {
        const QTextLayout &lines = *block.layout();
        const qreal top = lines.position().y() + (lines.lineCount() > 0 ? lines.lineAt(0).y() : 0.0);
        return static_cast<int>(top / writer.height());
    };
    for (QTextBlock block = paper->begin(); block.isValid(); block = block.next()) {
        if (!isHeading(block))
            continue;
        const QTextBlock first = block; // of headings that follow each other
        while (isHeading(block) && block.next().isValid())
            block = block.next();
        paper->documentLayout()->documentSize(); // so that the blocks have their places
        if (pageOf(first) == pageOf(block))
            continue;
        beginPageAt(*paper, first.blockNumber());
        beginPageAt(document, first.blockNumber());
    }
}

}

QByteArray pdfOf(QTextDocument &document, const QString &title)
{
    QByteArray pdf;
    QBuffer buffer(&pdf);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setTitle(title);
    writer.setCreator(QStringLiteral("Springstep"));
    keepHeadingsWithTheirText(document, writer);
    document.print(&writer);
    return pdf;
}

}
