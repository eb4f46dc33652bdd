#include "app/ui/dialogs/caption.h"

#include <QLabel>

namespace app {

QLabel *makeCaption(const QString &text, QWidget *parent)
{
    auto *label = new QLabel(text, parent);
    label->setObjectName("caption");
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

}
