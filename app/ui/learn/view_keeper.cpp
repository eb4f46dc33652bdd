#include "app/ui/learn/view_keeper.h"

#include <QCoreApplication>
#include <QEvent>
#include <QScopedValueRollback>
#include <QScrollArea>
#include <QScrollBar>

#include <algorithm>

namespace app {

ViewKeeper::ViewKeeper(QScrollArea &area) : QObject(&area), m_area(area)
{
    m_due.setSingleShot(true);
    m_due.setInterval(0);
    connect(&m_due, &QTimer::timeout, this, &ViewKeeper::scroll);
    const QScrollBar *bar = area.verticalScrollBar();
    connect(bar, &QScrollBar::actionTriggered, this, &ViewKeeper::forget);
    connect(bar, &QScrollBar::rangeChanged, this, [this] {
        if (m_kept)
            m_due.start();
    });
    connect(bar, &QScrollBar::valueChanged, this, [this, bar](int value) {
        if (!m_scrolls && value < bar->maximum()) // at its end it is where a smaller range has put it
            forget();
    });
    area.viewport()->installEventFilter(this);
}

void ViewKeeper::keep(QWidget &widget)
{
    forget();
    m_kept = m_wanted = &widget;
    widget.installEventFilter(this);
    m_due.start();
}

void ViewKeeper::forget()
{
    if (m_kept)
        m_kept->removeEventFilter(this);
    m_kept.clear();
}

bool ViewKeeper::eventFilter(QObject *watched, QEvent *event)
{
    const bool isOther = event->type() == QEvent::Resize || event->type() == QEvent::Move;
    if (m_kept && isOther)
        m_due.start();
    return QObject::eventFilter(watched, event);
}

void ViewKeeper::scroll()
{
    QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest); // each can post another one
    if (!m_kept || !m_kept->isVisible())
        return;
    const int top = m_kept->mapTo(m_area.widget(), QPoint()).y();
    const int end = top + m_kept->height() - m_area.viewport()->height();
    QScrollBar &bar = *m_area.verticalScrollBar();
    const QScopedValueRollback scrolls(m_scrolls, true);
    bar.setValue(std::max(end, std::min(top, bar.value())));
}

void keepInView(QWidget &widget)
{
    QWidget *around = widget.parentWidget();
    while (around && !qobject_cast<QScrollArea *>(around))
        around = around->parentWidget();
    auto *area = static_cast<QScrollArea *>(around);
    if (!area || !area->widget() || !area->widget()->isAncestorOf(&widget))
        return;
    auto *keeper = area->findChild<ViewKeeper *>(QString(), Qt::FindDirectChildrenOnly);
    (keeper ? keeper : new ViewKeeper(*area))->keep(widget);
}

}
