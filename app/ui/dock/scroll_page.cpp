#include "app/ui/dock/scroll_page.h"

#include "app/ui/dock/panel_parts.h"

#include <QScrollArea>
#include <QVBoxLayout>

namespace app {

QScrollArea *makeScrollArea(QWidget &panel)
{
    auto *area = new QScrollArea(&panel);
    area->setWidgetResizable(true);
    area->setFrameShape(QFrame::NoFrame);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);
    return area;
}

QWidget *makePage()
{
    auto *page = new QWidget;
    styleAsPanel(*page);
    return page;
}

void layOutPage(QWidget &panel, QWidget *text, QWidget *buttons)
{
    styleAsPanel(panel);
    QScrollArea *area = makeScrollArea(panel);
    text->resize(area->size()); // or the area would compute a size at once, before it has one itself
    area->setWidget(text);
    QVBoxLayout *column = makeColumn(&panel);
    column->addWidget(area, 1);
    column->addWidget(buttons);
}

}
