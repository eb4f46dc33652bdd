#include "app/ui/learn/learn_panel.h"

#include "app/model/learning/project_desk.h"
#include "app/model/learning/recall_desk.h"
#include "app/ui/actions/command.h"
#include "app/ui/actions/command_button.h"
#include "app/ui/dock/divider.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/dock/panel_title.h"
#include "app/ui/learn/after/recall_page.h"
#include "app/ui/learn/after/summary_page.h"
#include "app/ui/learn/lessons/lesson_delegate.h"
#include "app/ui/learn/lessons/lesson_list.h"
#include "app/ui/learn/lessons/lesson_model.h"
#include "app/ui/learn/lessons/lesson_rail.h"
#include "app/ui/learn/step/narration.h"
#include "app/ui/learn/step_buttons.h"
#include "app/ui/learn/words/word_card.h"
#include "app/ui/theme/icon_button.h"

#include <QEvent>
#include <QKeyEvent>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int leastRows = 2;       ///< list rows that stay visible with a long text, with the open step
constexpr int rowsToScroll = 4;    ///< from which on the list has a scroll bar
constexpr int summaryHeight = 400; ///< px, preferred height of a summary; it scrolls
constexpr int recallHeight = 520;  ///< px, the same with questions
constexpr int topMargin = 4;
constexpr int listMargin = 8;

}

LearnPanel::LearnPanel(Session &session, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_theme(theme), m_glossary(session.library()),
      m_title(new PanelTitle(tr("Lessons"), theme, this, PanelTitle::CaptionPlace::right)),
      m_list(new LessonList(session, theme, this)), m_narration(makeNarration()),
      m_summary(new SummaryPage(session, theme, this)), m_rail(new LessonRail(theme, this)),
      m_map(makeIconButton("map", {}, theme, m_title)),
      m_fold(makeIconButton("fold", "left", theme, m_title)),
      m_unfold(makeIconButton("allLessons", "down", theme, m_title)), m_divider(divider(this)),
      m_card(new WordCard(m_glossary, theme, this))
{
    styleAsPanel(*this);
    m_map->hide(); // until it has a command
    m_title->addAction(m_map);
    m_title->addAction(m_unfold);
    m_title->addAction(m_fold);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, topMargin, 0, 0);
    column->setSpacing(0);
    column->setSizeConstraint(QLayout::SetNoConstraint); // the list's height depends on the panel's height
    column->addWidget(m_title);
    column->addWidget(&m_rail->head());
    column->addWidget(m_list);
    column->addSpacing(listMargin);
    column->addWidget(m_divider);
    column->addWidget(m_narration, 1);
    column->addWidget(m_summary, 1);
    column->addStretch(0);
    column->addWidget(&m_rail->foot());
    m_summary->hide();
    m_rail->setVisible(false);
    makeUnfold();
    makeFold();
    makeRecall();
    makeProject();
    session.onChange(ChangeKind::step, this, [this] { showSummary(false); });
    connect(m_list, &LessonList::contentHeightChanged, this, &LearnPanel::shareHeight);
    connect(m_list->model(), &QAbstractItemModel::dataChanged, this, &LearnPanel::showCount);
    connect(m_list->model(), &QAbstractItemModel::dataChanged, this, &LearnPanel::updateRail);
    session.onChange(ChangeKind::step | ChangeKind::texts, this, &LearnPanel::updateRail);
    listen();
    showCount();
    updateRail();
    shareHeight();
}

Narration *LearnPanel::makeNarration()
{
    // Connected first, so that the texts link the words that there are now.
    m_session.onChange(ChangeKind::texts, this, [this] { m_glossary = Glossary(m_session.library()); });
    return new Narration(m_session, m_glossary, m_theme, this);
}

void LearnPanel::makeRecall()
{
    m_recallDesk = new RecallDesk(m_session, this);
    m_summary->addRecall(*m_recallDesk);
    m_recall = new RecallPage(*m_recallDesk, m_theme, this);
    m_recall->hide();
    auto *column = static_cast<QVBoxLayout *>(layout());
    column->insertWidget(column->indexOf(m_summary) + 1, m_recall, 1);
    connect(m_recallDesk, &RecallDesk::changed, this, &LearnPanel::showPages);
    connect(m_recall, &RecallPage::closed, this, &LearnPanel::leaveRecall);
}

void LearnPanel::leaveRecall()
{
    const LessonEntry *lesson = m_recallDesk->lesson();
    if (!lesson)
        return;
    m_recallDesk->stop();
    m_session.openStep(lesson->id, lesson->steps.back().id);
    showSummary(true);
}

void LearnPanel::setMapCommand(Command &command)
{
    showCommand(*m_map, command, m_theme);
    m_map->show();
}

void LearnPanel::makeProject()
{
    m_projects = new ProjectDesk(m_session, this);
    m_summary->addProject(*m_projects);
    connect(m_projects, &ProjectDesk::opened, this, [this] {
        if (m_session.isSandbox())
            return;
        setForm(Form::whole); // the brief stays beside the scene
        showSummary(true);
        m_summary->showProject();
    });
}

void LearnPanel::makeFold()
{
    m_fold->setAccessibleName(tr("Fold the lessons to a narrow strip"));
    m_fold->setToolTip(m_fold->accessibleName());
    connect(m_fold, &QToolButton::clicked, this, [this] { emit formRequested(Form::rail); });
}

void LearnPanel::setKeys(const QKeySequence &form, const QKeySequence &back, const QKeySequence &next)
{
    m_fold->setToolTip(withKeys(m_fold->accessibleName(), form));
    m_rail->setUnfoldKeys(form);
    m_narration->setStepKeys(back, next);
    updateRail();
}

void LearnPanel::makeUnfold()
{
    m_unfold->setCheckable(true);
    m_unfold->setAccessibleName(tr("All lessons"));
    connect(m_unfold, &QToolButton::toggled, this, [this](bool on) {
        m_unfold->setToolTip(on ? tr("Back to the text (Esc)") : tr("Show all lessons instead of the text"));
        showPages();
    });
    m_unfold->setToolTip(tr("Show all lessons instead of the text"));
}

void LearnPanel::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape && m_unfold->isChecked())
        m_unfold->setChecked(false);
    else
        QWidget::keyPressEvent(event);
}

void LearnPanel::setForm(Form form)
{
    if (form == m_form)
        return;
    m_form = form;
    m_unfold->setChecked(false);
    m_title->setVisible(form == Form::whole);
    m_divider->setVisible(form == Form::whole);
    m_rail->setVisible(form == Form::rail);
    // The rail is too narrow for a scroll bar; the wheel and the keys still scroll.
    m_list->setVerticalScrollBarPolicy(form == Form::rail ? Qt::ScrollBarAlwaysOff : Qt::ScrollBarAsNeeded);
    showSummary(m_isSummary && form == Form::whole);
    updateGeometry();
    emit formChanged();
}

void LearnPanel::updateRail()
{
    const StepButtons &buttons = m_narration->buttons();
    m_rail->setWays(buttons.back().toolTip(), buttons.next().toolTip(), m_session.run().preceding());
    m_rail->setDone(m_session.isStepDone(m_session.lesson(), m_session.step()));
}

void LearnPanel::listen()
{
    connect(m_narration, &Narration::heightChanged, this, &LearnPanel::shareHeight);
    connect(m_narration, &Narration::summaryRequested, this, [this] { showSummary(true); });
    connect(m_narration, &Narration::wordRequested, m_card, &WordCard::popUp);
    connect(m_card, &WordCard::stepRequested, &m_session, &Session::openStep);
    connect(m_card, &WordCard::glossaryRequested, this, &LearnPanel::glossaryRequested);
    connect(m_summary, &SummaryPage::closed, this, [this] { showSummary(false); });
    connect(&m_list->lessons(), &LessonModel::summaryRequested, this, [this] {
        setForm(Form::whole); // the rail has no room for it
        showSummary(true);
    });
    connect(m_rail, &LessonRail::unfolded, this, [this] { emit formRequested(Form::whole); });
    connect(m_rail, &LessonRail::backRequested, this, &LearnPanel::goBack);
    connect(m_rail, &LessonRail::nextRequested, this, &LearnPanel::goOn);
    connect(&m_list->lessons(), &LessonModel::stepRequested, this, [this] { showSummary(false); });
}

void LearnPanel::showSummary(bool shown)
{
    m_isSummary = shown;
    m_unfold->setChecked(false);
    m_list->markSummary(shown);
    showPages();
}

void LearnPanel::showPages()
{
    const bool hasPage = m_form == Form::whole && !m_unfold->isChecked();
    const bool isRecall = m_recallDesk->question();
    m_narration->setVisible(hasPage && !m_isSummary && !isRecall);
    m_summary->setVisible(hasPage && m_isSummary && !isRecall);
    m_recall->setVisible(hasPage && isRecall);
    shareHeight();
}

void LearnPanel::goOn()
{
    const bool isLast = &m_session.step() == &m_session.lesson().steps.back();
    if (isVisible() && isLast && !m_isSummary) {
        setForm(Form::whole);
        showSummary(true);
    } else {
        m_session.openFollowing();
    }
}

void LearnPanel::goBack()
{
    if (isVisible() && m_isSummary)
        showSummary(false);
    else
        m_session.openPreceding();
}

void LearnPanel::showCount()
{
    const LessonModel &lessons = m_list->lessons();
    m_title->setShortCaption(QStringLiteral("%1/%2").arg(lessons.stepsDone()).arg(lessons.stepCount()));
    m_title->setCaption(tr("%1 of %2 steps").arg(lessons.stepsDone()).arg(lessons.stepCount()));
}

void LearnPanel::shareHeight()
{
    if (!testAttribute(Qt::WA_Resized))
        return; // it has no size yet
    // The text comes first: the list stays usable when it scrolls, but learners do not read a text that they
    // have to scroll.
    if (m_form == Form::rail) {
        shareRail();
        return;
    }
    m_narration->fitText();
    const int all = m_list->contentHeight();
    const int least = std::min(all, leastRows * LessonDelegate::lessonHeight);
    const int room = height() - topMargin - PanelTitle::height - listMargin - 1;
    if (m_unfold->isChecked()) {
        m_list->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
        m_list->setFixedHeight(std::min(room, all));
        m_list->showOpen();
        return;
    }
    const bool isSummary = m_isSummary || m_recallDesk->question();
    const int full = !isSummary                  ? m_narration->fullHeight()
                     : m_summary->hasQuestions() ? recallHeight
                                                 : summaryHeight;
    const int fewest = isSummary
                           ? m_summary->minimumSizeHint().height()
                           : std::max(m_narration->minimumSizeHint().height(), m_narration->leastHeight());
    const int wanted = std::clamp(room - full, least, all);
    const int most = room - fewest;
    m_list->setFixedHeight(std::max(m_list->minimumSizeHint().height(), std::min(wanted, most)));
    m_unfold->setVisible(m_list->height() < all);
    // In a list of few rows, the bar would be hardly longer than its handle. The wheel and the keys still scroll.
    const bool isLow = m_list->height() < rowsToScroll * LessonDelegate::lessonHeight;
    m_list->setVerticalScrollBarPolicy(isLow ? Qt::ScrollBarAlwaysOff : Qt::ScrollBarAsNeeded);
    m_list->showOpen();
}

void LearnPanel::shareRail()
{
    const int room = height() - topMargin - listMargin - m_rail->head().sizeHint().height() -
                     m_rail->foot().sizeHint().height();
    m_list->setFixedHeight(
        std::max(m_list->minimumSizeHint().height(), std::min(room, m_list->contentHeight())));
    m_list->showOpen();
}

QSize LearnPanel::minimumSizeHint() const
{
    if (m_form == Form::rail)
        return {railWidth, topMargin + listMargin + m_rail->head().sizeHint().height() +
                               m_list->minimumSizeHint().height() + m_rail->foot().sizeHint().height()};
    return {200, topMargin + PanelTitle::height + m_list->minimumSizeHint().height() + listMargin + 1 +
                     m_narration->minimumSizeHint().height()};
}

bool LearnPanel::event(QEvent *event)
{
    // The height of the text is known only once it has its width.
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
