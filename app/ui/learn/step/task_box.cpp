#include "app/ui/learn/step/task_box.h"

#include "app/model/text/sentences.h"
#include "app/ui/learn/button_flow.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/why_box.h"

#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

namespace {

constexpr int taskTextLeft = 19; ///< px: aligned with the title, which has an arrow before it

NarrationText *taskText(const QString &name, const QString &text, const Theme &theme, QVBoxLayout &column,
                        QWidget *parent)
{
    auto *made = new NarrationText(theme, parent, NarrationText::Kind::aside);
    made->setObjectName(name);
    made->setText(text);
    column.addWidget(made);
    return made;
}

}

TaskBox::TaskBox(TaskDesk &desk, const lessons::CodeTask &task, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_desk(desk), m_task(task),
      m_title(new WhyButton(capitalised(task.title), theme, this)), m_content(new QWidget(this)),
      m_buttons(new ButtonFlow(m_content))
{
    setObjectName("codeTask");
    QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    m_content->setSizePolicy(policy);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_title);
    column->addWidget(m_content);
    auto *texts = new QVBoxLayout(m_content);
    texts->setContentsMargins(taskTextLeft, 2, 0, 6);
    texts->setSpacing(2);
    m_text = taskText("taskText", task.text, theme, *texts, m_content);
    for (const QString &hint : task.hints)
        m_hints.push_back(taskText("taskHint", hint, theme, *texts, m_content));
    m_sentence = taskText("taskSentence", {}, theme, *texts, m_content);
    m_start = addButton("startTask", tr("Write it yourself"),
                        tr("Empties the place in the listing, so that you can write it"));
    m_hint = addButton("taskHintButton", {}, tr("Shows the next hint"));
    m_solution = addButton("taskSolution", tr("Solution"), tr("Writes the solution into the listing"));
    m_stop = addButton("stopTask", tr("Stop"), tr("Stops this task. Your code stays."));
    texts->addWidget(m_buttons);
    connect(m_title, &QAbstractButton::toggled, this, [this](bool open) {
        m_content->setVisible(open);
        emit unfolded(open);
    });
    connect(m_start, &QToolButton::clicked, this, [this] {
        m_desk.start(m_task.id);
        emit started();
    });
    connect(m_hint, &QToolButton::clicked, &desk, &TaskDesk::showNextHint);
    connect(m_solution, &QToolButton::clicked, &desk, &TaskDesk::showSolution);
    connect(m_stop, &QToolButton::clicked, &desk, &TaskDesk::stop);
    m_content->hide();
    refresh();
    m_title->setChecked(isActive());
}

QToolButton *TaskBox::addButton(const QString &name, const QString &text, const QString &tip)
{
    auto *button = new QToolButton(m_buttons->strip());
    m_buttons->add(button);
    button->setObjectName(name);
    button->setText(text);
    button->setToolTip(tip);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

bool TaskBox::refresh()
{
    const bool isDone = m_desk.isDone(m_task);
    const QString title = capitalised(m_task.title);
    m_title->setText(isDone ? title + QStringLiteral(" ✓") : title);
    m_title->setAccessibleName(isDone ? tr("%1, done").arg(title) : title);
    m_title->updateGeometry();
    const int shown = isActive() ? m_desk.hintsShown() : 0;
    const int hints = static_cast<int>(m_hints.size());
    for (int i = 0; i < hints; ++i)
        m_hints[static_cast<std::size_t>(i)]->setVisible(i < shown);
    const QString sentence = isActive() ? m_desk.sentence() : QString();
    m_sentence->setText(sentence);
    m_sentence->setVisible(!sentence.isEmpty());
    m_start->setText(isDone ? tr("Write it again") : tr("Write it yourself"));
    m_start->setVisible(!isActive() || m_desk.isSolutionShown());
    m_hint->setText(tr("Hint %1 of %2").arg(std::min(shown + 1, hints)).arg(hints));
    const bool isRight = m_desk.verdict() && m_desk.verdict()->kind == Verdict::Kind::right;
    const bool needsHelp = isActive() && !m_desk.isSolutionShown() && !isRight;
    m_hint->setVisible(needsHelp && shown < hints);
    m_solution->setVisible(needsHelp);
    m_stop->setVisible(isActive());
    m_buttons->refresh();
    return !m_content->isHidden();
}

}
