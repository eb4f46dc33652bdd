#include "app/ui/learn/step/task_box.h"

#include "app/model/text/sentences.h"
#include "app/ui/dock/button_flow.h"
#include "app/ui/learn/narration_text.h"

#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace app {

TaskBox::TaskBox(TaskDesk &desk, const lessons::CodeTask &task, const Theme &theme, QWidget *parent)
    : FoldBox(capitalised(task.title), theme, parent), m_desk(desk), m_task(task)
{
    setObjectName("codeTask");
    refresh();
    setUnfolded(isActive());
}

void TaskBox::fill()
{
    addText("taskText", m_task.text);
    for (const QString &hint : m_task.hints)
        m_hints.push_back(addText("taskHint", hint));
    m_sentence = addText("taskSentence", {});
    m_buttons = new ButtonFlow(content());
    m_start = m_buttons->add<QToolButton>("startTask", tr("Write it yourself"),
                                          tr("Empties the place in the listing, so that you can write it"));
    m_hint = m_buttons->add<QToolButton>("taskHintButton", {}, tr("Shows the next hint"));
    m_solution = m_buttons->add<QToolButton>("taskSolution", tr("Solution"),
                                             tr("Writes the solution into the listing"));
    m_stop = m_buttons->add<QToolButton>("stopTask", tr("Stop"), tr("Stops this task. Your code stays."));
    column().addWidget(m_buttons);
    connect(m_start, &QToolButton::clicked, this, [this] {
        m_desk.start(m_task.id);
        emit started();
    });
    connect(m_hint, &QToolButton::clicked, &m_desk, &TaskDesk::showNextHint);
    connect(m_solution, &QToolButton::clicked, &m_desk, &TaskDesk::showSolution);
    connect(m_stop, &QToolButton::clicked, &m_desk, &TaskDesk::stop);
    refresh();
}

bool TaskBox::refresh()
{
    const bool isDone = m_desk.isDone(m_task);
    const QString title = capitalised(m_task.title);
    showTitle(title, isDone, tr("%1, done").arg(title));
    if (!isFilled())
        return false;
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
    return isUnfolded();
}

}
