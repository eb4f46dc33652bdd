#include "app/ui/window/left_pages.h"

namespace app {

LeftPages::LeftPages(QWidget *lessons, QWidget *tools, QWidget *parent)
    : QStackedWidget(parent), m_lessons(lessons), m_tools(tools)
{
    setObjectName("leftPages");
    addWidget(lessons);
    addWidget(tools);
}

void LeftPages::setPage(QWidget &page)
{
    // A stack is as large as its largest page, so the hidden page must need no room.
    for (QWidget *one : {m_lessons, m_tools}) {
        const auto policy = one == &page ? QSizePolicy::Preferred : QSizePolicy::Ignored;
        one->setSizePolicy(policy, policy);
    }
    setCurrentWidget(&page);
}

}
