// Mouse and keys on a plot of a study.

#include "app/ui/measure/spot_plot.h"

#include <algorithm>

namespace app {

namespace {

bool isWalk(int key)
{
    return key >= Qt::Key_Left && key <= Qt::Key_Down;
}

bool isTake(int key)
{
    return key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space;
}

}

void SpotPlot::walk(int along, int across)
{
    if (m_spots.empty())
        return;
    if (!m_chosen) {
        const sim::AccuracyRow *used = m_study.inUse();
        const auto here = std::find_if(m_spots.begin(), m_spots.end(),
                                       [&](const Spot &spot) { return &rowOf(spot) == used; });
        choose(here == m_spots.end() ? &m_spots.front() : &*here);
        return;
    }
    if (const Spot *best = spotBeyond(m_spots, screen(), *m_chosen, along, across))
        choose(best);
}

bool SpotPlot::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool plain = (key->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
        if ((plain && (isWalk(key->key()) || isTake(key->key()))) || wantsKey(*key)) {
            event->accept();
            return true;
        }
    }
    return QCustomPlot::event(event);
}

void SpotPlot::keyPressEvent(QKeyEvent *event)
{
    if (key(*event))
        return;
    if (isTake(event->key())) {
        adopt();
        return;
    }
    if (!isWalk(event->key())) {
        QCustomPlot::keyPressEvent(event);
        return;
    }
    const int step = event->key() == Qt::Key_Left || event->key() == Qt::Key_Up ? -1 : 1;
    const bool isAlong = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right;
    walk(isAlong ? step : 0, isAlong ? 0 : step);
    showTip();
}

void SpotPlot::mouseMoveEvent(QMouseEvent *event)
{
    if (m_dragging) {
        drag(event->position());
        return;
    }
    const Spot *spot = spotNear(m_spots, screen(), event->position());
    const bool same = spot && m_chosen && spot->row == m_chosen->row && spot->place == m_chosen->place;
    if (!same && (spot || m_chosen)) {
        choose(spot);
        showTip();
    }
    setCursor(spot ? Qt::PointingHandCursor : cursorAt(event->position()));
}

void SpotPlot::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    if (const Spot *spot = spotNear(m_spots, screen(), event->position())) {
        choose(spot);
        adopt();
        return;
    }
    m_dragging = press(event->position());
}

void SpotPlot::mouseReleaseEvent(QMouseEvent *)
{
    if (m_dragging)
        drop();
    m_dragging = false;
}

void SpotPlot::leaveEvent(QEvent *event)
{
    if (m_chosen && !hasFocus())
        choose(nullptr);
    QCustomPlot::leaveEvent(event);
}

void SpotPlot::focusInEvent(QFocusEvent *event)
{
    m_ringed = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
    QCustomPlot::focusInEvent(event);
    update();
}

void SpotPlot::focusOutEvent(QFocusEvent *event)
{
    m_ringed = false;
    QCustomPlot::focusOutEvent(event);
    choose(nullptr);
}

}
