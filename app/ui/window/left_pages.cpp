#include "app/ui/window/left_pages.h"

#include <QLayout>

namespace app {

LeftPages::LeftPages(QWidget *parent) : QStackedWidget(parent)
{
    setObjectName("leftPages");
}

void LeftPages::setLessons(QWidget &page)
{
    m_lessons = &page;
    page.layout()->setEnabled(false); // Qt would lay the page out, for a size that is not its own yet
    addWidget(&page);
    page.layout()->setEnabled(true);
}

void LeftPages::setTools(QWidget &page)
{
    m_tools = &page;
    addWidget(&page);
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
