#include "app/ui/dialogs/caption.h"

#include "app/ui/dock/panel_parts.h"

#include <QLabel>

namespace app {

QLabel *makeCaption(const QString &text, QWidget *parent)
{
    QLabel *label = makeTextLabel("caption", text, parent);
    label->setTextFormat(Qt::PlainText);
    return label;
}

}
