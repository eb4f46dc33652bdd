#include "tests/app/support/waiting.h"

#include <QAbstractEventDispatcher>
#include <QApplication>
#include <QDeadlineTimer>
#include <QTest>
#include <QWidget>

namespace tests {

void settle()
{
    QAbstractEventDispatcher &events = *QCoreApplication::eventDispatcher();
    const QDeadlineTimer deadline(60'000);
    do {
        if (deadline.hasExpired())
            qFatal("the application does not settle");
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // which only the main loop sends
    } while (events.processEvents(QEventLoop::AllEvents));
}

Activity::Activity()
{
    m_sinceLast.start();
    qApp->installEventFilter(this);
}

Activity::~Activity()
{
    qApp->removeEventFilter(this);
}

bool Activity::comesToRest(int span, int limit)
{
    m_sinceLast.start();
    return QTest::qWaitFor([&] { return m_sinceLast.elapsed() >= span; }, limit);
}

bool Activity::eventFilter(QObject *, QEvent *event)
{
    if (event->type() == QEvent::Timer || event->type() == QEvent::Paint)
        m_sinceLast.start();
    return false;
}

PaintCounter::PaintCounter(QWidget &widget)
{
    widget.installEventFilter(this);
}

bool PaintCounter::eventFilter(QObject *, QEvent *event)
{
    count += event->type() == QEvent::Paint ? 1 : 0;
    return false;
}

}
