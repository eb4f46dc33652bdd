#include "app/ui/theme/focus_ring.h"

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QFocusEvent>
#include <QFocusFrame>
#include <QLineEdit>

namespace app {

namespace {

bool isField(const QWidget *widget)
{
    return qobject_cast<const QLineEdit *>(widget) || qobject_cast<const QAbstractSpinBox *>(widget);
}

bool hasRing(const QWidget *widget)
{
    return isField(widget) || qobject_cast<const QAbstractButton *>(widget) ||
           qobject_cast<const QAbstractSlider *>(widget) || qobject_cast<const QComboBox *>(widget);
}

}

bool isByKeyboard(Qt::FocusReason reason)
{
    return reason == Qt::TabFocusReason || reason == Qt::BacktabFocusReason ||
           reason == Qt::ShortcutFocusReason;
}

FocusRing::FocusRing(QObject *parent) : QObject(parent)
{
    connect(qApp, &QApplication::focusChanged, this, [this](QWidget *, QWidget *now) { follow(now); });
    follow(QApplication::focusWidget());
}

FocusRing::~FocusRing()
{
    // A style can change while Qt iterates over all widgets, so no widget may be deleted at once.
    if (m_frame && !QCoreApplication::closingDown())
        m_frame->deleteLater();
    else
        delete m_frame;
}

void FocusRing::follow(QWidget *widget)
{
    if (m_widget)
        m_widget->removeEventFilter(this);
    hide();
    m_widget = widget && hasRing(widget) ? widget : nullptr;
    if (!m_widget)
        return;
    m_widget->installEventFilter(this);
    // The focus event came before this call, but the window remembers whether Tab was used last.
    if (isField(m_widget) || m_widget->window()->testAttribute(Qt::WA_KeyboardFocusChange))
        show();
}

bool FocusRing::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == m_widget) {
        if (event->type() == QEvent::KeyPress ||
            (event->type() == QEvent::FocusIn && isByKeyboard(static_cast<QFocusEvent *>(event)->reason())))
            show();
        else if (event->type() == QEvent::MouseButtonPress && !isField(m_widget))
            hide();
    }
    return QObject::eventFilter(watched, event);
}

void FocusRing::show()
{
    if (!m_frame) {
        m_frame = new QFocusFrame;
        m_frame->setAttribute(Qt::WA_TransparentForMouseEvents);
    }
    m_frame->setWidget(m_widget);
}

void FocusRing::hide()
{
    if (m_frame)
        m_frame->setWidget(nullptr);
}

}
