#include "app/model/handout/paper.h"

#include "app/model/text/numbers.h"

#include <QFont>
#include <QFontDatabase>
#include <QImage>
#include <QPainter>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextDocument>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace app {

namespace {

constexpr qreal textSize = 10.0; ///< points
constexpr std::array<qreal, 3> headingSizes = {20.0, 15.0, 11.0};
constexpr std::array<qreal, 3> headingMargins = {0.0, 20.0, 14.0};
constexpr qreal writingLine = 22.0; ///< px, from one line to the next
constexpr qreal paragraphGap = 6.0;
constexpr QSize curveSize{180, 110}; ///< px
constexpr int curveGap = 20;
constexpr int pictureScale = 2; ///< image px per px

QString withoutWordLinks(QString markdown)
{
    static const QRegularExpression link(QStringLiteral("\\[([^\\]]+)\\]\\(word:[^)]*\\)"));
    return markdown.replace(link, QStringLiteral("\\1"));
}

/// Draws one curve; `low` and `high` are the values at the lower and the upper edge.
void drawCurve(QPainter &painter, const QRectF &area, const std::vector<double> &curve, double low,
               double high)
{
    painter.setPen(QPen(QColor(0xc5, 0xc9, 0xd1), 1.0));
    painter.drawRect(area);
    QPolygonF line;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        if (!std::isfinite(curve[i]))
            break;
        const double x =
            static_cast<double>(i) / static_cast<double>(std::max<std::size_t>(curve.size() - 1, 1));
        line << QPointF(area.left() + x * area.width(),
                        area.bottom() - (curve[i] - low) / (high - low) * area.height());
    }
    painter.setPen(QPen(QColor(0x23, 0x26, 0x2e), 1.5));
    painter.drawPolyline(line);
}

}

Paper::Paper(QTextDocument &document) : m_cursor(&document)
{
    document.clear();
    QFont font;
    font.setPointSizeF(textSize);
    document.setDefaultFont(font);
}

void Paper::beginBlock(qreal top, qreal left)
{
    QTextBlockFormat format;
    format.setTopMargin(top);
    format.setLeftMargin(left);
    format.setLineHeight(120.0, QTextBlockFormat::ProportionalHeight);
    if (m_beginsPage)
        format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
    m_beginsPage = false;
    if (m_cursor.document()->isEmpty())
        m_cursor.setBlockFormat(format);
    else
        m_cursor.insertBlock(format);
    m_cursor.setCharFormat({});
}

void Paper::addHeading(int level, const QString &text)
{
    const auto index = static_cast<std::size_t>(level - 1);
    beginBlock(headingMargins[index]);
    QTextBlockFormat format = m_cursor.blockFormat();
    format.setHeadingLevel(level);
    m_cursor.setBlockFormat(format);
    QTextCharFormat bold;
    bold.setFontPointSize(headingSizes[index]);
    bold.setFontWeight(QFont::Bold);
    m_cursor.insertText(text, bold);
}

void Paper::addMarkdown(const QString &markdown, qreal top, qreal left, const QString &mark)
{
    QTextDocument text;
    text.setDefaultFont(m_cursor.document()->defaultFont());
    text.setMarkdown(withoutBreaksInNumbers(withoutWordLinks(markdown)), QTextDocument::MarkdownNoHTML);
    bool isFirst = true;
    for (QTextBlock block = text.begin(); block.isValid(); block = block.next()) {
        if (block.text().isEmpty())
            continue;
        beginBlock(top, left + (block.textList() ? 16.0 : 0.0));
        if (isFirst)
            m_cursor.insertText(mark);
        else if (block.textList())
            m_cursor.insertText(QStringLiteral("• "));
        isFirst = false;
        for (auto part = block.begin(); !part.atEnd(); ++part)
            m_cursor.insertText(part.fragment().text(), part.fragment().charFormat());
    }
}

void Paper::addText(const QString &markdown)
{
    addMarkdown(markdown, paragraphGap, 0.0, {});
}

void Paper::addItem(const QString &markdown)
{
    addMarkdown(markdown, paragraphGap + 4.0, 0.0, QStringLiteral("▸ "));
}

void Paper::addChoice(const QString &markdown)
{
    addMarkdown(markdown, 3.0, 18.0, QStringLiteral("☐ "));
}

void Paper::addCode(const QString &code)
{
    QTextCharFormat format;
    format.setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    format.setFontPointSize(8.5);
    beginBlock(paragraphGap + 2.0, 12.0);
    // Line separators keep the code in one paragraph.
    m_cursor.insertText(code.trimmed().replace('\n', QChar::LineSeparator), format);
}

void Paper::addLines(int count)
{
    for (int i = 0; i < count; ++i) {
        beginBlock(writingLine - textSize);
        QTextBlockFormat format = m_cursor.blockFormat();
        format.setProperty(QTextFormat::BlockTrailingHorizontalRulerWidth,
                           QTextLength(QTextLength::PercentageLength, 100));
        m_cursor.setBlockFormat(format);
    }
}

void Paper::addFields(const QStringList &names)
{
    beginBlock(14.0);
    for (const QString &name : names)
        m_cursor.insertText(QStringLiteral("%1 %2   ").arg(name, QString(28, '_')));
}

void Paper::addPicture(const QImage &picture)
{
    if (picture.isNull())
        return;
    beginBlock(paragraphGap + 2.0);
    QTextBlockFormat block = m_cursor.blockFormat();
    block.setLineHeight(100.0, QTextBlockFormat::ProportionalHeight);
    m_cursor.setBlockFormat(block);
    QTextImageFormat format;
    const QString name = QStringLiteral("picture%1").arg(m_cursor.position());
    m_cursor.document()->addResource(QTextDocument::ImageResource, name, picture);
    format.setName(name);
    const QSizeF size = picture.deviceIndependentSize();
    format.setWidth(size.width());
    format.setHeight(size.height());
    m_cursor.insertImage(format);
}

void Paper::addCurves(const std::vector<std::vector<double>> &curves)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const std::vector<double> &curve : curves) {
        for (const double value : curve) {
            if (std::isfinite(value)) {
                low = std::min(low, value);
                high = std::max(high, value);
            }
        }
    }
    if (!(low < high))
        high = low + 1.0;
    const int count = static_cast<int>(curves.size());
    const QSize size(count * curveSize.width() + (count - 1) * curveGap, curveSize.height() + 20);
    QImage image(size * pictureScale, QImage::Format_RGB32);
    image.setDevicePixelRatio(pictureScale);
    image.fill(Qt::white);
    QPainter painter(&image);
    painter.setRenderHint(QPainter::Antialiasing);
    for (int i = 0; i < count; ++i) {
        const QRectF area(i * (curveSize.width() + curveGap) + 1, 18, curveSize.width() - 2,
                          curveSize.height());
        drawCurve(painter, area.adjusted(0, 0, 0, -1), curves[static_cast<std::size_t>(i)], low, high);
        painter.drawText(QPointF(area.left(), 12), QStringLiteral("☐ %1").arg(i + 1));
    }
    painter.end();
    addPicture(image);
}

void Paper::beginPage()
{
    m_beginsPage = true;
}

}
