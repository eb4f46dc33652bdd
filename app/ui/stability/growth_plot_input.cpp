// What a map of growth says, and what mouse and keys do on it.

#include "app/model/numbers.h"
#include "app/model/step_words.h"
#include "app/ui/stability/growth_plot.h"
#include "app/ui/stability/map_axis.h"

#include <QAccessible>
#include <QHelpEvent>
#include <QToolTip>

#include <algorithm>

namespace app {

namespace {

QString valueWords(const sim::MapAxis &axis, double value)
{
    if (axis.parameter.empty())
        return GrowthPlot::tr("a step of %1\u2009"
                              "frames")
            .arg(roughNumber(value));
    return QStringLiteral("%1 %2").arg(QString::fromStdString(axis.parameter), roughNumber(value));
}

bool isWalk(int key)
{
    return key >= Qt::Key_Left && key <= Qt::Key_Down;
}

bool isTake(int key)
{
    return key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space;
}

}

std::optional<QPoint> GrowthPlot::cellAt(QPointF place) const
{
    const sim::GrowthMap *map = m_watch.map();
    if (!map || !QRectF(axisRect()->rect()).contains(place))
        return {};
    int column = 0, row = 0;
    m_cells->data()->coordToCell(xAxis->pixelToCoord(place.x()), yAxis->pixelToCoord(place.y()), &column,
                                 &row);
    column = std::clamp(column, 0, static_cast<int>(map->x.values.size()) - 1);
    row = std::clamp(row, 0, static_cast<int>(map->y.values.size()) - 1);
    return QPoint(column, row);
}

TriedSpot GrowthPlot::spotOf(QPoint at) const
{
    const sim::GrowthMap &map = *m_watch.map();
    TriedSpot spot = m_watch.tried().back();
    spot.k = map.x.values[static_cast<std::size_t>(at.x())];
    (map.y.parameter.empty() ? spot.h : spot.damp) = map.y.values[static_cast<std::size_t>(at.y())];
    return m_watch.settable(spot);
}

QString GrowthPlot::wordsOf(QPoint at) const
{
    const sim::GrowthMap &map = *m_watch.map();
    const auto x = static_cast<std::size_t>(at.x()), y = static_cast<std::size_t>(at.y());
    if (y * map.x.values.size() + x >= map.growth.size())
        return {};
    const QString where =
        tr("%1, %2").arg(valueWords(map.x, map.x.values[x]), valueWords(map.y, map.y.values[y]));
    return grows(at.x(), at.y()) ? tr("%1: disturbances %2").arg(where, growthWords(map.at(x, y)))
                                 : tr("%1: it holds").arg(where);
}

QString GrowthPlot::wordsAt(QPointF place) const
{
    const std::optional<QPoint> at = cellAt(place);
    return at ? wordsOf(*at) : QString();
}

QString GrowthPlot::tipOf(QPoint at) const
{
    const QString words = wordsOf(at);
    if (words.isEmpty())
        return {};
    const TriedSpot spot = spotOf(at);
    const QString up = m_watch.map()->y.parameter.empty()
                           ? tr("a step of %1").arg(stepTitle(spot.h))
                           : QStringLiteral("damp %1").arg(roughNumber(spot.damp));
    return tr("%1\nA click or Enter uses k %2 and %3").arg(words, roughNumber(spot.k), up);
}

QString GrowthPlot::tipAt(QPointF place) const
{
    const std::optional<QPoint> at = cellAt(place);
    return at ? tipOf(*at) : QString();
}

QString GrowthPlot::sentence() const
{
    if (!m_watch.map() || m_watch.tried().empty())
        return tr("The map is being computed.");
    if (m_chosen)
        return tipOf(*m_chosen).replace('\n', QStringLiteral(". "));
    return tr("You are at %1. Arrow keys walk over the map, Enter uses a place.")
        .arg(wordsAt(onScreen(m_watch.tried().back())));
}

void GrowthPlot::choose(std::optional<QPoint> at)
{
    if (at == m_chosen)
        return;
    m_chosen = at;
    setAccessibleDescription(sentence());
    QAccessibleValueChangeEvent event(this, sentence());
    QAccessible::updateAccessibility(&event);
    update();
}

void GrowthPlot::adopt()
{
    if (m_chosen && m_watch.map() && !wordsOf(*m_chosen).isEmpty())
        m_watch.adopt(spotOf(*m_chosen));
}

bool GrowthPlot::event(QEvent *event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto *help = static_cast<QHelpEvent *>(event);
        QToolTip::showText(help->globalPos(), tipAt(help->pos()), this);
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool isPlain = (key->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
        if (isPlain && (isWalk(key->key()) || isTake(key->key()))) {
            event->accept();
            return true;
        }
    }
    return QCustomPlot::event(event);
}

void GrowthPlot::mouseMoveEvent(QMouseEvent *event)
{
    const std::optional<QPoint> at = cellAt(event->position());
    setCursor(at ? Qt::PointingHandCursor : Qt::ArrowCursor);
    choose(at);
}

void GrowthPlot::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    choose(cellAt(event->position()));
    adopt();
}

void GrowthPlot::leaveEvent(QEvent *event)
{
    if (!hasFocus())
        choose({});
    QCustomPlot::leaveEvent(event);
}

void GrowthPlot::keyPressEvent(QKeyEvent *event)
{
    if (!m_watch.map() || !(isWalk(event->key()) || isTake(event->key()))) {
        QCustomPlot::keyPressEvent(event);
        return;
    }
    if (isTake(event->key())) {
        adopt();
        return;
    }
    QPoint at = m_chosen.value_or(cellAt(onScreen(m_watch.tried().back())).value_or(QPoint()));
    const int key = event->key();
    at +=
        QPoint(key == Qt::Key_Left ? -1 : key == Qt::Key_Right, key == Qt::Key_Down ? -1 : key == Qt::Key_Up);
    at.setX(std::clamp(at.x(), 0, static_cast<int>(m_watch.map()->x.values.size()) - 1));
    at.setY(std::clamp(at.y(), 0, static_cast<int>(m_watch.map()->y.values.size()) - 1));
    choose(at);
    QToolTip::showText(mapToGlobal(cell(at.x(), at.y()).bottomRight().toPoint() + QPoint(8, 8)), tipOf(at),
                       this);
}

void GrowthPlot::focusInEvent(QFocusEvent *event)
{
    m_ringed = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
    QCustomPlot::focusInEvent(event);
    update();
}

void GrowthPlot::focusOutEvent(QFocusEvent *event)
{
    m_ringed = false;
    QCustomPlot::focusOutEvent(event);
    choose({});
    update();
}

}
