#include "app/ui/learn/after/recall_page.h"

#include "app/ui/dock/panel_parts.h"
#include "app/ui/dock/scroll_page.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/step_button.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace app {

RecallPage::RecallPage(RecallDesk &desk, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_desk(desk), m_theme(theme)
{
    layOutPage(*this, makeText(), makeButtons());
    connect(&desk, &RecallDesk::changed, this, &RecallPage::refresh);
    refresh();
}

QWidget *RecallPage::makeText()
{
    QWidget *page = makePage();
    QLabel *title = makeTextLabel("stepTitle", tr("Do it in the scene"), page);
    m_text = new NarrationText(m_theme, page);
    m_text->setObjectName("recallText");
    m_state = new NarrationText(m_theme, page, NarrationText::Kind::aside);
    m_state->setObjectName("recallState");
    m_again = new QToolButton(page);
    m_again->setObjectName("startOver");
    m_again->setText(tr("Set the scene up again"));
    m_again->setToolTip(tr("Begins the run again as it was when this question opened"));
    m_again->setFocusPolicy(Qt::TabFocus);
    auto *column = new QVBoxLayout(page);
    column->setContentsMargins(18, 12, 18, 8);
    column->setSpacing(5);
    column->addWidget(title);
    column->addWidget(m_text);
    column->addSpacing(4);
    column->addWidget(m_state);
    column->addSpacing(4);
    column->addWidget(m_again, 0, Qt::AlignLeft);
    column->addStretch(1);
    connect(m_again, &QToolButton::clicked, &m_desk, &RecallDesk::startAgain);
    return page;
}

QWidget *RecallPage::makeButtons()
{
    auto *buttons = new QWidget(this);
    m_back = new StepButton(buttons);
    m_back->setObjectName("backToQuestions");
    m_back->setFullText(tr("Back to the questions"), tr("Back"));
    m_back->setToolTip(tr("Back to the questions of the lesson. You can answer this one later."));
    auto *row = new QHBoxLayout(buttons);
    row->setContentsMargins(16, 8, 16, 14);
    row->addWidget(m_back, 1);
    connect(m_back, &QPushButton::clicked, this, &RecallPage::closed);
    return buttons;
}

void RecallPage::refresh()
{
    const lessons::RecallQuestion *question = m_desk.question();
    if (!question)
        return;
    m_text->setText(question->text);
    m_state->setText(m_desk.isDone() ? tr("**Done** ✓") + QStringLiteral("\n\n") + question->task->answer
                                     : tr("Not done yet. Springstep sees it when you have done it."));
    m_back->setPrimary(m_desk.isDone());
}

}
