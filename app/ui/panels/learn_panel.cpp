#include "app/ui/panels/learn_panel.h"

#include "app/ui/panels/lesson_list.h"
#include "app/ui/panels/lesson_model.h"
#include "app/ui/panels/narration.h"
#include "app/ui/panels/panel_title.h"

#include <QFrame>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int lowWindow = 720;       ///< px high, below which only the open lesson's rows keep their place
constexpr int narrationWanted = 320; ///< px that the list leaves to the text while it can scroll itself
constexpr int topMargin = 4;
constexpr int listMargin = 8;

}

LearnPanel::LearnPanel(Session &session, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_title(new PanelTitle(tr("Lessons"), PanelTitle::CaptionPlace::right, theme, this)),
      m_list(new LessonList(session, theme, this)), m_narration(new Narration(session, theme, this))
{
    setObjectName("panel");
    setAttribute(Qt::WA_StyledBackground);
    auto *divider = new QFrame(this);
    divider->setObjectName("divider");
    divider->setFixedHeight(1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, topMargin, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_title);
    column->addWidget(m_list);
    column->addSpacing(listMargin);
    column->addWidget(divider);
    column->addWidget(m_narration, 1);
    connect(m_list, &LessonList::contentHeightChanged, this, &LearnPanel::shareHeight);
    connect(m_list->model(), &QAbstractItemModel::dataChanged, this, &LearnPanel::showCount);
    showCount();
    shareHeight();
}

void LearnPanel::showCount()
{
    const LessonModel &lessons = m_list->lessons();
    m_title->setCaption(tr("%1 of %2 steps").arg(lessons.stepsDone()).arg(lessons.stepCount()));
}

void LearnPanel::shareHeight()
{
    const int all = m_list->contentHeight();
    const int least = std::min(all, m_list->openLessonHeight());
    const int room = height() - topMargin - PanelTitle::height - listMargin - 1 - narrationWanted;
    const int wanted = window()->height() < lowWindow ? least : std::clamp(room, least, all);
    // Even the open lesson gives way before the text has no room at all.
    const int most =
        height() - topMargin - PanelTitle::height - listMargin - 1 - m_narration->minimumSizeHint().height();
    m_list->setFixedHeight(std::max(m_list->minimumSizeHint().height(), std::min(wanted, most)));
    m_list->showOpen();
}

void LearnPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    shareHeight();
}

}
