#include "app/ui/learn/after/summary_page.h"

#include "app/model/learning/prediction_text.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/dock/scroll_page.h"
#include "app/ui/learn/after/project_box.h"
#include "app/ui/learn/after/recall_box.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/prose.h"
#include "app/ui/learn/step_buttons.h"

#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

namespace app {

namespace {

QString linkTo(const QString &text, const LessonSummary &summary, const StepSummary &step)
{
    return QStringLiteral("[%1](%2)").arg(text, stepLink(summary.lesson, step.id).toString());
}

}

SummaryPage::SummaryPage(Session &session, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_session(session), m_theme(theme)
{
    layOutPage(*this, makeText(), makeButtons());
    session.onChange(ChangeKind::step, this, &SummaryPage::open);
    session.onChange(ChangeKind::texts, this, &SummaryPage::refresh);
    connect(&session.progress(), &Progress::changed, this, &SummaryPage::refresh);
    connect(&session.notes(), &Notes::changed, this, &SummaryPage::refresh);
    open();
}

QWidget *SummaryPage::makeText()
{
    QWidget *page = makePage();
    m_title = makeTextLabel("stepTitle", {}, page);
    m_title->setTextFormat(Qt::PlainText);
    m_text = new NarrationText(m_theme, page, NarrationText::Kind::aside);
    m_startOver = new QToolButton(page);
    m_startOver->setObjectName("startOver");
    m_startOver->setFocusPolicy(Qt::TabFocus);
    auto *column = new QVBoxLayout(page);
    column->setContentsMargins(18, 12, 18, 8);
    column->setSpacing(6);
    column->addWidget(m_title);
    column->addWidget(m_text);
    column->addWidget(m_startOver, 0, Qt::AlignLeft);
    column->addStretch(1);
    connect(m_startOver, &QToolButton::clicked, this, &SummaryPage::startOver);
    connect(m_text, &NarrationText::linkActivated, this, [this](const QUrl &link) {
        const StepPlace place = stepOf(link);
        m_session.openStep(place.lesson, place.step);
        emit closed();
    });
    return page;
}

QWidget *SummaryPage::makeButtons()
{
    m_buttons = new StepButtons(m_theme, this);
    m_buttons->back().setAccessibleName(tr("Back to the step"));
    m_buttons->back().setToolTip(tr("Back to the step"));
    connect(&m_buttons->back(), &QPushButton::clicked, this, &SummaryPage::closed);
    connect(&m_buttons->next(), &QPushButton::clicked, this, [this] {
        const LessonSummary summary =
            summaryOf(m_session.lesson(), m_session.library(), m_session.progress());
        if (summary.next)
            m_session.openStep(summary.next->id, summary.next->steps.front().id);
    });
    return m_buttons;
}

void SummaryPage::addRecall(RecallDesk &desk)
{
    QWidget *page = m_text->parentWidget();
    m_desk = &desk;
    m_recall = new RecallBox(desk, m_theme, page);
    auto *column = static_cast<QVBoxLayout *>(page->layout());
    column->insertWidget(1, m_recall);
    m_session.onChange(ChangeKind::texts, m_recall, &RecallBox::refresh);
    m_recall->setLesson(m_session.lesson());
}

bool SummaryPage::hasQuestions() const
{
    return m_recall && m_recall->count() > 0;
}

void SummaryPage::addProject(ProjectDesk &desk)
{
    QWidget *page = m_text->parentWidget();
    m_project = new ProjectBox(m_session.run(), desk, ProjectBox::Shows::lesson, m_theme, page);
    auto *column = static_cast<QVBoxLayout *>(page->layout());
    column->insertWidget(column->indexOf(m_text), m_project);
}

void SummaryPage::showProject()
{
    QTimer::singleShot(0, this, [this] { // after the layout is done
        auto *area = findChild<QScrollArea *>();
        if (m_project && area)
            area->verticalScrollBar()->setValue(m_project->y());
    });
}

void SummaryPage::open()
{
    m_forgotten.clear();
    if (m_recall &&
        !m_desk->question()) // a question stays while it is answered in the scene of another lesson
        m_recall->setLesson(m_session.lesson());
    refresh();
    if (const QString lesson = m_session.lesson().id; lesson != m_lesson) {
        m_lesson = lesson;
        findChild<QScrollArea *>()->verticalScrollBar()->setValue(0);
    }
}

void SummaryPage::showEvent(QShowEvent *)
{
    if (m_isStale)
        refresh();
}

void SummaryPage::refresh()
{
    m_isStale = !isVisible(); // it is a long text, and most steps are opened without it
    if (m_isStale)
        return;
    const LessonSummary summary = summaryOf(m_session.lesson(), m_session.library(), m_session.progress());
    m_title->setText(tr("%1: what you learnt").arg(summary.title));
    m_text->setText(textOf(summary));
    StepButton &next = m_buttons->next();
    next.setEnabled(summary.next);
    next.setPrimary(summary.next);
    const QString last = tr("The last lesson");
    next.setFullText(summary.next ? tr("Next: %1").arg(summary.next->title) : last,
                     summary.next ? summary.next->title : last);
    next.setToolTip(summary.next ? tr("Next: %1").arg(summary.next->title)
                                 : tr("No lesson comes after this one."));
    const bool canGiveBack = !m_forgotten.isEmpty();
    m_startOver->setText(canGiveBack ? tr("Restore the ticks") : tr("Restart this lesson"));
    m_startOver->setToolTip(canGiveBack ? tr("Ticks everything again that you had done before")
                                        : tr("Removes the ticks of this lesson. You can restore them."));
    m_startOver->setEnabled(canGiveBack || summary.done > 0 || summary.written > 0 || summary.passed > 0);
    if (!m_startOver->isEnabled())
        m_startOver->setToolTip(tr("Nothing is ticked in this lesson yet."));
}

void SummaryPage::startOver()
{
    if (m_forgotten.isEmpty()) {
        m_forgotten = m_session.progress().forgetLesson(m_session.lesson().id);
    } else {
        const QStringList ticks = std::exchange(m_forgotten, {});
        m_session.progress().giveBack(ticks);
    }
    refresh();
}

QString SummaryPage::textOf(const LessonSummary &summary) const
{
    QStringList text{tr("%1 of %2 things tried.").arg(summary.done).arg(summary.count)};
    if (summary.codeTasks > 0)
        text << tr("%1 of %2 tasks written in the listing.").arg(summary.written).arg(summary.codeTasks);
    if (summary.levels > 0)
        text << tr("%1 of %2 levels of the project passed.").arg(summary.passed).arg(summary.levels);
    for (const StepSummary &step : summary.steps) {
        const bool isDone = step.open.isEmpty() && step.unwritten.isEmpty();
        text << QStringLiteral("**%1**%2")
                    .arg(linkTo(step.title, summary, step), isDone ? QStringLiteral(" ✓") : QString());
        if (!step.learnt.isEmpty())
            text << step.learnt;
        text << predictionsOf(step.id);
        for (const QString &open : step.open)
            text << tr("Still to try: %1").arg(open);
        for (const QString &unwritten : step.unwritten)
            text << tr("Still to write: %1").arg(unwritten);
    }
    if (summary.levels > 0) {
        const bool isDone = summary.unpassed.isEmpty();
        text << tr("**Project: %1**").arg(m_session.lesson().project->title) +
                    (isDone ? QStringLiteral(" ✓") : QString());
        for (const QString &level : summary.unpassed)
            text << tr("Still to pass: %1").arg(level);
    }
    if (summary.next)
        text << tr("**Next: %1.** %2").arg(summary.next->title, summary.next->summary);
    return text.join(QStringLiteral("\n\n"));
}

QStringList SummaryPage::predictionsOf(const QString &stepId) const
{
    QStringList lines;
    for (const lessons::Step &step : m_session.lesson().steps) {
        if (step.id != stepId)
            continue;
        for (const lessons::Prediction &prediction : step.predictions) {
            const QString outcome =
                notedOutcome(m_session.notes(), m_session.lesson().id, step.id, prediction);
            if (!outcome.isEmpty())
                lines << tr("Predicted: %1 %2").arg(prediction.text, outcome);
        }
    }
    return lines;
}

}
