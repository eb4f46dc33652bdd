#include "app/ui/dock/scroll_page.h"

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
    page->setObjectName("panel");
    page->setAttribute(Qt::WA_StyledBackground);
    return page;
}

void layOutPage(QWidget &panel, QWidget *text, QWidget *buttons)
{
    panel.setObjectName("panel");
    panel.setAttribute(Qt::WA_StyledBackground);
    QScrollArea *area = makeScrollArea(panel);
    text->resize(area->size()); // or the area would compute a size at once, before it has one itself
    area->setWidget(text);
    auto *column = new QVBoxLayout(&panel);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(area, 1);
    column->addWidget(buttons);
}

}
