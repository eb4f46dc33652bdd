#include "app/ui/panels/learn_panel.h"

#include "app/ui/panels/lesson_delegate.h"
#include "app/ui/panels/lesson_list.h"
#include "app/ui/panels/lesson_model.h"
#include "app/ui/panels/narration.h"
#include "app/ui/panels/panel_title.h"
#include "app/ui/panels/summary_page.h"
#include "app/ui/panels/word_card.h"

#include <QEvent>
#include <QFrame>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int leastRows = 4; ///< of the list that stay while the text wants more: the open step among them
constexpr int summaryHeight = 400; ///< px, that a summary would like to have; it scrolls
constexpr int topMargin = 4;
constexpr int listMargin = 8;

}

LearnPanel::LearnPanel(Session &session, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_glossary(session.library()),
      m_title(new PanelTitle(tr("Lessons"), PanelTitle::CaptionPlace::right, theme, this)),
      m_list(new LessonList(session, theme, this)),
      m_narration(new Narration(session, m_glossary, theme, this)),
      m_summary(new SummaryPage(session, theme, this)), m_card(new WordCard(m_glossary, theme, this))
{
    setObjectName("panel");
    setAttribute(Qt::WA_StyledBackground);
    auto *divider = new QFrame(this);
    divider->setObjectName("divider");
    divider->setFixedHeight(1);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, topMargin, 0, 0);
    column->setSpacing(0);
    column->setSizeConstraint(QLayout::SetNoConstraint); // the list's height follows the panel's
    column->addWidget(m_title);
    column->addWidget(m_list);
    column->addSpacing(listMargin);
    column->addWidget(divider);
    column->addWidget(m_narration, 1);
    column->addWidget(m_summary, 1);
    m_summary->hide();
    connect(&session, &Session::stepOpened, this, [this] { showSummary(false); });
    connect(m_list, &LessonList::contentHeightChanged, this, &LearnPanel::shareHeight);
    connect(m_list->model(), &QAbstractItemModel::dataChanged, this, &LearnPanel::showCount);
    listen();
    showCount();
    shareHeight();
}

void LearnPanel::listen()
{
    connect(m_narration, &Narration::heightChanged, this, &LearnPanel::shareHeight);
    connect(m_narration, &Narration::summaryAsked, this, [this] { showSummary(true); });
    connect(m_narration, &Narration::wordAsked, m_card, &WordCard::popUp);
    connect(m_card, &WordCard::stepAsked, &m_session, &Session::openStep);
    connect(m_card, &WordCard::glossaryAsked, this, &LearnPanel::glossaryAsked);
    connect(m_summary, &SummaryPage::closed, this, [this] { showSummary(false); });
    connect(&m_list->lessons(), &LessonModel::summaryAsked, this, [this] { showSummary(true); });
    connect(&m_list->lessons(), &LessonModel::stepAsked, this, [this] { showSummary(false); });
}

void LearnPanel::showSummary(bool shown)
{
    m_narration->setVisible(!shown);
    m_summary->setVisible(shown);
    m_list->markSummary(shown);
    shareHeight();
}

void LearnPanel::goOn()
{
    const bool isLast = &m_session.step() == &m_session.lesson().steps.back();
    if (isVisible() && isLast && m_summary->isHidden())
        showSummary(true);
    else
        m_session.openFollowing();
}

void LearnPanel::goBack()
{
    if (isVisible() && !m_summary->isHidden())
        showSummary(false);
    else
        m_session.openPreceding();
}

void LearnPanel::showCount()
{
    const LessonModel &lessons = m_list->lessons();
    m_title->setCaption(tr("%1 of %2 steps").arg(lessons.stepsDone()).arg(lessons.stepCount()));
}

void LearnPanel::shareHeight()
{
    // The list can scroll and shows where it is; a text that has to be scrolled is not read. So the text comes first.
    m_narration->fitText();
    const int all = m_list->contentHeight();
    const int least = std::min(all, leastRows * LessonDelegate::lessonHeight);
    const int room = height() - topMargin - PanelTitle::height - listMargin - 1;
    const bool isSummary = !m_summary->isHidden();
    const int full = isSummary ? summaryHeight : m_narration->fullHeight();
    const int fewest = isSummary
                           ? m_summary->minimumSizeHint().height()
                           : std::max(m_narration->minimumSizeHint().height(), m_narration->leastHeight());
    const int wanted = std::clamp(room - full, least, all);
    const int most = room - fewest;
    m_list->setFixedHeight(std::max(m_list->minimumSizeHint().height(), std::min(wanted, most)));
    m_list->showOpen();
}

QSize LearnPanel::minimumSizeHint() const
{
    return {200, topMargin + PanelTitle::height + m_list->minimumSizeHint().height() + listMargin + 1 +
                     m_narration->minimumSizeHint().height()};
}

bool LearnPanel::event(QEvent *event)
{
    // A text knows its height only when it has its width.
    if (event->type() == QEvent::LayoutRequest)
        shareHeight();
    return QWidget::event(event);
}

void LearnPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    shareHeight();
}

}
