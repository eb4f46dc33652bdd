#include "app/ui/status/status_sentence.h"

#include <QHelpEvent>
#include <QPainter>
#include <QTextDocumentFragment>
#include <QToolTip>

namespace app {

StatusSentence::StatusSentence(QWidget *parent) : QLabel(parent)
{
    setTextFormat(Qt::RichText);
    setContentsMargins(8, 0, 8, 0);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
}

bool StatusSentence::isCut() const
{
    return sizeHint().width() > width();
}

QString StatusSentence::plain() const
{
    return QTextDocumentFragment::fromHtml(text()).toPlainText();
}

bool StatusSentence::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip || !isCut())
        return QLabel::event(event);
    QToolTip::showText(static_cast<QHelpEvent *>(event)->globalPos(), plain(), this);
    return true;
}

void StatusSentence::paintEvent(QPaintEvent *event)
{
    if (!isCut()) {
        QLabel::paintEvent(event);
        return;
    }
    QPainter painter(this);
    painter.setPen(palette().color(foregroundRole()));
    const QRect room = contentsRect();
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(plain(), Qt::ElideRight, room.width()));
}

}
