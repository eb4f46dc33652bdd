#include "app/ui/dock/panel_parts.h"

#include <QBoxLayout>
#include <QLabel>

namespace app {

void styleAsPanel(QWidget &widget)
{
    widget.setObjectName("panel");
    widget.setAttribute(Qt::WA_StyledBackground);
}

QVBoxLayout *makeColumn(QWidget *widget, int spacing)
{
    auto *column = new QVBoxLayout(widget);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(spacing);
    return column;
}

QHBoxLayout *makeRow(QWidget *widget, int spacing)
{
    auto *row = new QHBoxLayout(widget);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(spacing);
    return row;
}

QLabel *makeTextLabel(const QString &objectName, const QString &text, QWidget *parent)
{
    auto *label = new QLabel(text, parent);
    label->setObjectName(objectName);
    label->setWordWrap(true);
    return label;
}

}
