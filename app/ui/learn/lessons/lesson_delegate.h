#pragma once

#include "app/ui/theme/theme.h"

#include <QStyledItemDelegate>

namespace app {

/// A delegate that draws the rows of the lesson list: mark and text, or only the mark where the row is too
/// narrow.
class LessonDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    static constexpr int lessonHeight = 27;
    static constexpr int stepHeight = 26;
    static constexpr int leastTextWidth = 80; ///< px; a narrower row shows only its mark
    static constexpr int markRow = 34;        ///< px, the width of a row that shows only its mark

    LessonDelegate(const Theme &theme, QObject *parent) : QStyledItemDelegate(parent), m_theme(theme) {}

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;

private:
    void paintRow(QPainter &painter, const QStyleOptionViewItem &option, bool open) const;
    void paintLesson(QPainter &painter, const QRect &row, const QModelIndex &index) const;
    void paintStep(QPainter &painter, const QRect &row, const QModelIndex &index) const;
    void paintSummary(QPainter &painter, const QRect &row, const QModelIndex &index) const;
    /// Paints the text of a step or a summary.
    void paintBesideMark(QPainter &painter, const QRect &row, const QModelIndex &index) const;
    void paintHeading(QPainter &painter, const QRect &row, const QModelIndex &index) const;
    void paintProblem(QPainter &painter, const QRect &row, const QModelIndex &index) const;
    void paintRing(QPainter &painter, const QRectF &place, double share) const;
    void paintText(QPainter &painter, const QRect &place, const QString &text, const QFont &font,
                   const QColor &color) const;

    const Theme &m_theme;
};

}
