#include "app/ui/learn/lessons/lesson_delegate.h"

#include "app/ui/learn/lessons/lesson_model.h"

#include <QPainter>
#include <QPainterPath>
#include <QWidget>

namespace app {

namespace {

constexpr int sideMargin = 8; ///< px, between the panel's edge and a row's background
constexpr int padding = 10;   ///< px, inside the background
constexpr int gap = 10;       ///< px, between mark and text
constexpr int ringSize = 16;
constexpr int markSize = 14;
constexpr int stepIndent = 36;
constexpr int radius = 6;

bool hasText(const QRect &row)
{
    return row.width() >= LessonDelegate::leastTextWidth;
}

/// Returns a square with this `side` at `x`, vertically centred in the row. In a row without text it is also
/// centred horizontally.
QRectF squareAt(int x, const QRect &row, double side)
{
    if (!hasText(row))
        return {row.x() + (row.width() - side) / 2.0, row.y() + (row.height() - side) / 2.0, side, side};
    return {static_cast<double>(x), row.y() + (row.height() - side) / 2.0, side, side};
}

LessonModel::Kind kindOf(const QModelIndex &index)
{
    return static_cast<LessonModel::Kind>(index.data(LessonModel::kindRole).toInt());
}

}

void LessonDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                           const QModelIndex &index) const
{
    const LessonModel::Kind kind = kindOf(index);
    const bool isOpenStep = kind != LessonModel::Kind::lesson && index.data(LessonModel::openRole).toBool();
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    if (kind != LessonModel::Kind::heading)
        paintRow(*painter, option, isOpenStep);
    switch (kind) {
    case LessonModel::Kind::lesson:
        paintLesson(*painter, option.rect, index);
        break;
    case LessonModel::Kind::step:
        paintStep(*painter, option.rect, index);
        break;
    case LessonModel::Kind::summary:
        paintSummary(*painter, option.rect, index);
        break;
    case LessonModel::Kind::heading:
        paintHeading(*painter, option.rect, index);
        break;
    case LessonModel::Kind::problem:
        paintProblem(*painter, option.rect, index);
        break;
    }
    painter->restore();
}

QSize LessonDelegate::sizeHint(const QStyleOptionViewItem &, const QModelIndex &index) const
{
    const LessonModel::Kind kind = kindOf(index);
    const bool isInside = kind == LessonModel::Kind::step || kind == LessonModel::Kind::summary;
    return {100, isInside ? stepHeight : lessonHeight};
}

void LessonDelegate::paintRow(QPainter &painter, const QStyleOptionViewItem &option, bool open) const
{
    const int side = hasText(option.rect) ? sideMargin : sideMargin / 2;
    const QRectF row = QRectF(option.rect).adjusted(side, 0, -side, 0);
    const bool hovered = option.state & QStyle::State_MouseOver;
    if (open || hovered)
        m_theme.paintSurface(painter, row, radius, open ? Surface::chosen : Surface::hovered);
    if ((option.state & QStyle::State_HasFocus) && (option.state & QStyle::State_KeyboardFocusChange)) {
        painter.setPen(QPen(m_theme.tokens().ink, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(row.adjusted(1, 1, -1, -1), radius - 1, radius - 1);
    }
}

void LessonDelegate::paintText(QPainter &painter, const QRect &place, const QString &text, const QFont &font,
                               const QColor &color) const
{
    if (place.width() <= 0)
        return;
    painter.setFont(font);
    painter.setPen(color);
    painter.drawText(place, Qt::AlignVCenter | Qt::AlignLeft,
                     painter.fontMetrics().elidedText(text, Qt::ElideRight, place.width()));
}

void LessonDelegate::paintLesson(QPainter &painter, const QRect &row, const QModelIndex &index) const
{
    const Tokens &tokens = m_theme.tokens();
    const int done = index.data(LessonModel::doneRole).toInt();
    const int count = index.data(LessonModel::countRole).toInt();
    const bool open = index.data(LessonModel::openRole).toBool();
    const int left = row.left() + sideMargin + padding;
    QRect place = row.adjusted(left - row.left() + ringSize + gap, 0, -sideMargin - padding, 0);
    paintRing(painter, squareAt(left, row, ringSize), double(done) / count);
    if (!hasText(row))
        return;
    if (done < count) {
        const QString text = QString("%1/%2").arg(done).arg(count);
        painter.setFont(m_theme.ui(12));
        painter.setPen(tokens.ink3);
        painter.drawText(place, Qt::AlignVCenter | Qt::AlignRight, text);
        place.setRight(place.right() - painter.fontMetrics().horizontalAdvance(text) - gap);
    }
    paintText(painter, place, index.data().toString(), m_theme.ui(13, open ? QFont::DemiBold : QFont::Normal),
              open ? tokens.ink : tokens.ink2);
}

void LessonDelegate::paintStep(QPainter &painter, const QRect &row, const QModelIndex &index) const
{
    const Tokens &tokens = m_theme.tokens();
    const bool done = index.data(LessonModel::doneRole).toBool();
    const bool open = index.data(LessonModel::openRole).toBool();
    const QRectF mark = squareAt(row.left() + sideMargin + stepIndent, row, markSize);
    if (done) {
        m_theme.icon("check", tokens.ok).paint(&painter, mark.toRect());
    } else {
        painter.setPen(QPen(open ? tokens.ink : tokens.line2, 1.5));
        painter.setBrush(open ? QBrush(tokens.ink) : QBrush(Qt::NoBrush));
        const double size = open ? 3.2 : 2.6;
        painter.drawEllipse(mark.center(), size, size);
    }
    paintBesideMark(painter, row, index);
}

void LessonDelegate::paintSummary(QPainter &painter, const QRect &row, const QModelIndex &index) const
{
    const Tokens &tokens = m_theme.tokens();
    const bool open = index.data(LessonModel::openRole).toBool();
    const QRectF mark = squareAt(row.left() + sideMargin + stepIndent, row, markSize);
    painter.setPen(QPen(open ? tokens.ink : tokens.ink3, 1.5, Qt::SolidLine, Qt::RoundCap));
    for (const auto &[y, right] : {std::pair{4.0, 11.0}, {7.0, 11.0}, {10.0, 8.0}}) // text lines
        painter.drawLine(mark.topLeft() + QPointF(3.0, y), mark.topLeft() + QPointF(right, y));
    paintBesideMark(painter, row, index);
}

void LessonDelegate::paintBesideMark(QPainter &painter, const QRect &row, const QModelIndex &index) const
{
    const bool open = index.data(LessonModel::openRole).toBool();
    const QRect place = row.adjusted(sideMargin + stepIndent + markSize + gap, 0, -sideMargin - padding, 0);
    paintText(painter, place, index.data().toString(), m_theme.ui(13, open ? QFont::Medium : QFont::Normal),
              open ? m_theme.tokens().ink : m_theme.tokens().ink2);
}

void LessonDelegate::paintHeading(QPainter &painter, const QRect &row, const QModelIndex &index) const
{
    const Tokens &tokens = m_theme.tokens();
    const int side = sideMargin + (hasText(row) ? padding : 0);
    const QRect place = row.adjusted(side, 0, -side, 0);
    if (hasText(row)) {
        paintText(painter, place, index.data().toString(), m_theme.ui(12, QFont::DemiBold), tokens.ink3);
        return;
    }
    painter.setPen(QPen(tokens.line2, 1.0));
    painter.drawLine(QPointF(place.left(), row.center().y() + 0.5),
                     QPointF(place.right(), row.center().y() + 0.5));
}

void LessonDelegate::paintProblem(QPainter &painter, const QRect &row, const QModelIndex &index) const
{
    if (!hasText(row)) {
        painter.setFont(m_theme.ui(13, QFont::DemiBold));
        painter.setPen(m_theme.tokens().past);
        painter.drawText(row, Qt::AlignCenter, QStringLiteral("✕"));
        return;
    }
    const QRect place = row.adjusted(sideMargin + padding, 0, -sideMargin - padding, 0);
    paintText(painter, place, index.data().toString(), m_theme.ui(12), m_theme.tokens().past);
}

void LessonDelegate::paintRing(QPainter &painter, const QRectF &place, double share) const
{
    const Tokens &tokens = m_theme.tokens();
    if (share >= 1.0) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(tokens.ok);
        painter.drawEllipse(place);
        QPainterPath tick(place.topLeft() + QPointF(4.6, 8.2));
        tick.lineTo(place.topLeft() + QPointF(7.0, 10.6));
        tick.lineTo(place.topLeft() + QPointF(11.4, 5.6));
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(tokens.panel, 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPath(tick);
        return;
    }
    const QRectF ring = place.adjusted(1.2, 1.2, -1.2, -1.2);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(tokens.line2, 1.7));
    painter.drawEllipse(ring);
    if (share > 0.0) {
        painter.setPen(QPen(tokens.ok, 1.9, Qt::SolidLine, Qt::RoundCap));
        painter.drawArc(ring, 90 * 16, qRound(-share * 360 * 16));
    }
}

}
