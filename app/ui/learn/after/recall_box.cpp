#include "app/ui/learn/after/recall_box.h"

#include "app/ui/dock/panel_parts.h"
#include "app/ui/learn/choice_row.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/theme/icon_button.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int recallTextLeft = 25; ///< px: aligned with the texts of the choices

}

RecallBox::RecallBox(RecallDesk &desk, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_desk(desk), m_theme(theme), m_column(new QVBoxLayout(this))
{
    setObjectName("recall");
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Minimum);
    m_column->setContentsMargins(0, 0, 0, 10);
    m_column->setSpacing(2);
    m_heading = makeTextLabel("heading", {}, this);
    m_intro = makeTextLabel("caption", {}, this);
    m_intro->setTextFormat(Qt::PlainText);
    m_count = new QLabel(this);
    m_count->setObjectName("caption");
    m_back = addStepButton("previousQuestion", "left", tr("The question before"));
    m_next = addStepButton("nextQuestion", "right", tr("The next question"));
    auto *row = new QHBoxLayout;
    row->setSpacing(0);
    row->addWidget(m_count, 1);
    row->addWidget(m_back);
    row->addWidget(m_next);
    m_column->addWidget(m_heading);
    m_column->addWidget(m_intro);
    m_column->addLayout(row);
    m_text = addText("recallText");
    m_rowColumn = new QVBoxLayout;
    m_rowColumn->setSpacing(0);
    m_column->addLayout(m_rowColumn);
    m_do = new QPushButton(tr("Do it in the scene"), this);
    m_do->setObjectName("doIt");
    m_do->setFocusPolicy(Qt::TabFocus);
    m_do->setToolTip(tr("Opens the scene. Your run of that step stays under “Runs”."));
    m_column->addSpacing(4);
    m_column->addWidget(m_do, 0, Qt::AlignLeft);
    m_answer = addText("recallAnswer");
    connect(m_back, &QToolButton::clicked, this, [this] { showQuestion(m_number - 1); });
    connect(m_next, &QToolButton::clicked, this, [this] { showQuestion(m_number + 1); });
    connect(m_do, &QPushButton::clicked, this, [this] { m_desk.start(*m_lesson, question()); });
    connect(&desk, &RecallDesk::changed, this, &RecallBox::refresh);
    hide();
}

QToolButton *RecallBox::addStepButton(const QString &name, const QString &icon, const QString &tip)
{
    QToolButton *button = makeIconButton(name, icon, m_theme, this);
    button->setFixedSize(28, 24);
    button->setIconSize({14, 14});
    button->setAccessibleName(tip);
    button->setToolTip(tip);
    return button;
}

NarrationText *RecallBox::addText(const QString &name)
{
    auto *text = new NarrationText(m_theme, this, NarrationText::Kind::aside);
    text->setObjectName(name);
    m_column->addWidget(text);
    return text;
}

void RecallBox::setLesson(const LessonEntry &lesson)
{
    const std::vector<lessons::RecallQuestion> &all = lesson.recall.questions;
    const bool isSame = m_lesson == &lesson;
    m_lesson = &lesson;
    if (isSame || all.empty()) {
        refresh();
        return;
    }
    const auto open = std::find_if(all.begin(), all.end(), [&](const lessons::RecallQuestion &one) {
        return !m_desk.isAnswered(lesson, one);
    });
    showQuestion(open == all.end() ? 0 : static_cast<std::size_t>(open - all.begin()));
}

void RecallBox::showQuestion(std::size_t number)
{
    if (number >= count())
        return;
    m_number = number;
    refresh();
}

void RecallBox::refresh()
{
    setVisible(count() > 0);
    m_isStale = !isVisible();
    if (count() == 0 || m_isStale)
        return;
    m_number = std::min(m_number, count() - 1);
    m_back->setEnabled(m_number > 0);
    m_next->setEnabled(m_number + 1 < count());
    m_heading->setText(m_lesson->recall.title);
    m_intro->setText(m_lesson->recall.text);
    m_text->setText(question().text);
    addRows();
    m_do->setVisible(question().task.has_value());
    m_answer->setText(question().task ? question().task->answer : QString());
    showAnswers();
}

void RecallBox::showEvent(QShowEvent *)
{
    if (m_isStale)
        refresh();
}

void RecallBox::addRows()
{
    for (const Row &row : m_rows) { // a row may be what was just clicked
        for (QWidget *widget :
             {static_cast<QWidget *>(row.button), static_cast<QWidget *>(row.explanation)}) {
            widget->hide();
            widget->deleteLater();
        }
    }
    m_rows.clear();
    QWidget *before = m_next;
    while (QLayoutItem *item = m_rowColumn->takeAt(0))
        delete item;
    for (const std::size_t choice : RecallDesk::shuffled(question())) {
        const lessons::RecallChoice &content = question().choices[choice];
        Row row{new ChoiceRow(content.text, m_theme, this),
                new NarrationText(m_theme, this, NarrationText::Kind::aside), choice};
        row.button->setObjectName("choice");
        row.explanation->setObjectName("explanation");
        const QString verdict = choice == 0 ? tr("**Right.** %1") : tr("**Not this one.** %1");
        row.explanation->setText(verdict.arg(content.explanation));
        m_rowColumn->addWidget(row.button);
        auto *indented = new QVBoxLayout;
        indented->setContentsMargins(recallTextLeft, 0, 0, 4);
        indented->addWidget(row.explanation);
        m_rowColumn->addLayout(indented);
        connect(row.button, &ChoiceRow::clicked, this, [this, choice] {
            m_desk.choose(*m_lesson, question(), choice);
            showAnswers();
        });
        setTabOrder(before, row.button); // it is made after the buttons below
        before = row.button;
        m_rows.push_back(row);
    }
}

void RecallBox::showAnswers()
{
    const bool isAnswered = m_desk.isAnswered(*m_lesson, question());
    const std::optional<std::size_t> chosen = m_desk.chosen(*m_lesson, question());
    for (const Row &row : m_rows) {
        const bool isChosen = chosen == row.choice;
        row.button->setChecked(isChosen);
        row.button->setVerdict(!isChosen         ? ChoiceRow::Verdict::none
                               : row.choice == 0 ? ChoiceRow::Verdict::right
                                                 : ChoiceRow::Verdict::wrong);
        row.explanation->setVisible(isChosen);
    }
    const bool isDone = question().task && isAnswered;
    m_do->setText(isDone ? tr("Do it again") : tr("Do it in the scene"));
    m_answer->setVisible(isDone);
    const QString which = tr("Question %1 of %2").arg(m_number + 1).arg(count());
    m_count->setText(isAnswered && (isDone || chosen == 0U) ? which + QStringLiteral(" ✓") : which);
    updateGeometry();
    emit heightChanged();
}

}
