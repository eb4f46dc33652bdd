#include "app/ui/plots/spot_plot.h"

#include <QToolTip>

namespace app {

namespace {

bool isArrow(int key)
{
    return key >= Qt::Key_Left && key <= Qt::Key_Down;
}

bool isEnter(int key)
{
    return key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space;
}

QPoint stepOf(int arrow)
{
    switch (arrow) {
    case Qt::Key_Left:
        return {-1, 0};
    case Qt::Key_Right:
        return {1, 0};
    case Qt::Key_Up:
        return {0, -1};
    default:
        return {0, 1};
    }
}

}

QString SpotPlot::sentence() const
{
    return m_chosen ? tipOf(*m_chosen).replace('\n', QStringLiteral(". ")) : overview();
}

void SpotPlot::press()
{
    if (const std::optional<Spot> spot = m_chosen) // using it may choose another one
        use(*spot);
}

void SpotPlot::choose(const std::optional<Spot> &spot)
{
    if (spot == m_chosen)
        return;
    m_chosen = spot;
    update();
    emit chosenChanged();
    announceValue();
}

void SpotPlot::showTip()
{
    if (!m_chosen) {
        QToolTip::hideText();
        return;
    }
    const QPoint beside = markOf(*m_chosen).bottomRight().toPoint() + QPoint(8, 8);
    QToolTip::showText(mapToGlobal(beside), tipOf(*m_chosen), this);
}

bool SpotPlot::wantsKey(const QKeyEvent &event) const
{
    return isPlainKey(event) && (isArrow(event.key()) || isEnter(event.key()));
}

void SpotPlot::mouseMoveEvent(QMouseEvent *event)
{
    const std::optional<Spot> spot = spotAt(event->position());
    setCursor(spot ? Qt::PointingHandCursor : Qt::ArrowCursor);
    choose(spot);
}

void SpotPlot::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    choose(spotAt(event->position()));
    press();
}

void SpotPlot::leaveEvent(QEvent *event)
{
    if (!hasFocus())
        choose(std::nullopt);
    Plot::leaveEvent(event);
}

void SpotPlot::keyPressEvent(QKeyEvent *event)
{
    if (isEnter(event->key())) {
        press();
    } else if (isArrow(event->key())) {
        if (const std::optional<Spot> next = spotBeyond(stepOf(event->key())))
            choose(next);
        showTip();
    } else {
        Plot::keyPressEvent(event);
    }
}

void SpotPlot::focusOutEvent(QFocusEvent *event)
{
    Plot::focusOutEvent(event);
    choose(std::nullopt);
}

}
