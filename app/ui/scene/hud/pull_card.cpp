// The card that is shown when a run is paused inside a frame.

#include "app/model/text/numbers.h"
#include "app/model/text/sentences.h"
#include "app/ui/scene/drawing/body_text.h"
#include "app/ui/scene/drawing/label_places.h"
#include "app/ui/scene/hud/hud.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

struct PullCardText
{
    Q_DECLARE_TR_FUNCTIONS(PullCardText)
};

constexpr double rowHeight = 22.0;
constexpr double leastWidth = 196.0;
constexpr double nameAt = 28.0;
constexpr double leastValueEnd = 124.0; ///< the right edge of the numbers
constexpr double besideBody = 45.0;

QString unitOfPulls()
{
    return PullCardText::tr("px/frame²");
}

struct Row
{
    QString name;
    QString value;
    QColor color;
};

std::vector<Row> rowsOf(const SceneContent &shown, const Theme &theme)
{
    std::vector<Row> rows;
    for (const sim::ForceSnapshot &one : shown.gathered) {
        const sim::Vec2 pull = {one.acceleration(shown.selected, 0), one.acceleration(shown.selected, 1)};
        rows.push_back({phrase(one.effect->title()), shownMagnitude(shownLength(pull)),
                        theme.kindColor(one.effect->kind())});
    }
    if (shown.hasSum())
        rows.push_back(
            {sumWords(shown), shownMagnitude(shownLength(shown.sumOnSelected())), theme.tokens().ink});
    return rows;
}

/// The positions of the columns of a card.
struct Columns
{
    double valueEnd = leastValueEnd;
    double width = leastWidth;
};

Columns columnsOf(const std::vector<Row> &rows, const SceneContent &shown, const QString &unit)
{
    const QFontMetricsF text(shown.text);
    const QFontMetricsF figures(shown.figures);
    Columns columns;
    for (const Row &row : rows)
        columns.valueEnd = std::max(columns.valueEnd, nameAt + text.horizontalAdvance(row.name) + 12.0 +
                                                          figures.horizontalAdvance(row.value));
    columns.width =
        std::max(leastWidth, std::ceil(columns.valueEnd + 7.0 + text.horizontalAdvance(unit) + 10.0));
    return columns;
}

}

QRectF pullCardBox(const SceneContent &shown, const Theme &theme, const Camera &camera, QRectF free,
                   std::vector<QRectF> taken)
{
    const std::vector<Row> rows = rowsOf(shown, theme);
    const Columns columns = columnsOf(rows, shown, unitOfPulls());
    const QSizeF size(columns.width, rowHeight * static_cast<double>(rows.size()) + 12.0);
    const QPointF centre = camera.at(shown.state().positionOf(shown.selected));
    const double radius = camera.radius(shown.radius(shown.selected));
    const QPointF wanted = centre + QPointF(radius + besideBody, -radius - 20.0 - size.height());
    QRectF box = LabelPlaces(std::move(taken)).within(free, wanted, size);
    box.moveTo(std::round(box.left()) + 0.5, std::round(box.top()) + 0.5);
    return box;
}

void drawPullCard(QPainter &painter, const SceneContent &shown, const Theme &theme, QRectF box)
{
    const std::vector<Row> rows = rowsOf(shown, theme);
    const QString unit = unitOfPulls();
    const Columns columns = columnsOf(rows, shown, unit);
    const Tokens &t = theme.tokens();
    painter.setPen(QPen(t.line2, 1.0));
    painter.setBrush(t.scene);
    painter.drawRoundedRect(box, 8.0, 8.0);
    double y = box.top() + 12.0;
    for (const Row &row : rows) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(row.color);
        painter.drawRoundedRect(QRectF(box.left() + 12.0, y + 1.0, 8.0, 8.0), 2.0, 2.0);
        painter.setFont(shown.text);
        painter.setPen(t.ink);
        painter.drawText(QPointF(box.left() + nameAt, y + 9.0), row.name);
        painter.setPen(t.ink3);
        painter.drawText(QPointF(box.left() + columns.valueEnd + 7.0, y + 9.0), unit);
        painter.setFont(shown.figures);
        painter.setPen(t.ink);
        const double width = QFontMetricsF(shown.figures).horizontalAdvance(row.value);
        painter.drawText(QPointF(box.left() + columns.valueEnd - width, y + 9.0), row.value);
        y += rowHeight;
    }
    painter.setFont(shown.text);
    painter.setBrush(Qt::NoBrush);
}

}
