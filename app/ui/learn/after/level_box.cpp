#include "app/ui/learn/after/level_box.h"

#include "app/model/text/phrases.h"
#include "app/ui/dock/button_flow.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/view_keeper.h"

#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace app {

LevelBox::LevelBox(ProjectDesk &desk, const QString &lesson, const lessons::ProjectLevel &level,
                   const Theme &theme, QWidget *parent)
    : FoldBox(level.title, theme, parent), m_desk(desk), m_lesson(lesson), m_id(level.id),
      m_name(level.title), m_text(level.text), m_demands(level.demands), m_hintMarkdown(level.hint)
{
    setObjectName("projectLevel");
    connect(this, &FoldBox::unfolded, this, &LevelBox::changed);
    refresh();
}

void LevelBox::fill()
{
    addText("levelText", m_text);
    m_list = addText("levelDemands", {});
    m_hintText = addText("levelHint", m_hintMarkdown);
    m_hintText->hide();
    m_sentence = makeTextLabel("levelSentence", {}, content());
    m_sentence->setTextFormat(Qt::PlainText);
    column().addWidget(m_sentence);
    m_buttons = new ButtonFlow(content());
    m_judge = m_buttons->add<QToolButton>("judgeLevel", tr("Judge it"),
                                          tr("Runs your scene or your code, and says whether it passes"));
    m_cancel = m_buttons->add<QToolButton>("cancelJudging", tr("Cancel"), tr("Stops the judge"));
    m_hint = m_buttons->add<QToolButton>("levelHintButton", tr("Hint"), tr("Shows or hides a hint"));
    m_hint->setCheckable(true);
    for (QToolButton *button : {m_judge, m_cancel, m_hint})
        button->setAccessibleName(labelled(button->text(), m_name));
    column().addWidget(m_buttons);
    connect(m_judge, &QToolButton::clicked, this, [this] { m_desk.judge(m_lesson, m_id); });
    connect(m_cancel, &QToolButton::clicked, &m_desk, &ProjectDesk::cancel);
    connect(m_hint, &QToolButton::toggled, this, [this](bool shown) {
        m_hintText->setVisible(shown);
        emit changed();
    });
    refreshContent();
}

QString LevelBox::demandText() const
{
    const ProjectVerdict *verdict = m_desk.verdict(m_lesson, m_id);
    QStringList lines;
    for (std::size_t i = 0; i < m_demands.size(); ++i) {
        QString mark = QStringLiteral("○ ");
        if (verdict && i < verdict->met.size())
            mark = verdict->met[i] ? QStringLiteral("✓ ") : QStringLiteral("✗ ");
        lines << mark + m_demands[i].sentence;
    }
    return lines.join(QStringLiteral("\n\n"));
}

void LevelBox::refresh()
{
    showTitle(m_name, m_desk.isPassed(m_lesson, m_id), tr("%1, passed").arg(m_name));
    if (isFilled())
        refreshContent();
    emit changed();
}

void LevelBox::refreshContent()
{
    const bool isJudging = m_desk.judging(m_lesson) == m_id;
    m_list->setText(demandText());
    const ProjectVerdict *verdict = m_desk.verdict(m_lesson, m_id);
    QString sentence;
    if (isJudging)
        sentence = tr("Judging: %1 % of the frames.").arg(m_desk.percent());
    else if (verdict)
        sentence = verdict->isPassed() ? tr("Passed: everything holds.") : verdict->sentence;
    if (sentence != m_sentence->text()) {
        m_sentence->setText(sentence);
        m_sentence->setAccessibleName(sentence);
        if (verdict && !isJudging && isVisible())
            keepInView(*this); // the judgement is at its end
    }
    m_sentence->setVisible(!sentence.isEmpty());
    m_judge->setVisible(!isJudging);
    m_cancel->setVisible(isJudging);
    m_buttons->refresh();
}

}
