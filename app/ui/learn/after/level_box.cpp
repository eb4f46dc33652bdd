#include "app/ui/learn/after/level_box.h"

#include "app/ui/learn/button_flow.h"
#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/why_box.h"

#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr int levelTextLeft = 19; ///< px: aligned with the title, which has an arrow before it

NarrationText *levelText(const QString &name, const QString &text, const Theme &theme, QVBoxLayout &column,
                         QWidget *parent)
{
    auto *made = new NarrationText(theme, parent, NarrationText::Kind::aside);
    made->setObjectName(name);
    made->setText(text);
    column.addWidget(made);
    return made;
}

}

LevelBox::LevelBox(ProjectDesk &desk, const QString &lesson, const lessons::ProjectLevel &level,
                   const Theme &theme, QWidget *parent)
    : QWidget(parent), m_desk(desk), m_lesson(lesson), m_id(level.id), m_name(level.title),
      m_demands(level.demands), m_title(new WhyButton(level.title, theme, this)),
      m_content(new QWidget(this)), m_buttons(new ButtonFlow(m_content))
{
    setObjectName("projectLevel");
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
    texts->setContentsMargins(levelTextLeft, 2, 0, 6);
    texts->setSpacing(2);
    levelText("levelText", level.text, theme, *texts, m_content);
    m_list = levelText("levelDemands", {}, theme, *texts, m_content);
    m_hintText = levelText("levelHint", level.hint, theme, *texts, m_content);
    m_hintText->hide();
    m_sentence = new QLabel(m_content);
    m_sentence->setObjectName("levelSentence");
    m_sentence->setWordWrap(true);
    m_sentence->setTextFormat(Qt::PlainText);
    texts->addWidget(m_sentence);
    m_judge = addButton("judgeLevel", tr("Judge it"),
                        tr("Runs your scene or your code, and says whether it passes"));
    m_cancel = addButton("cancelJudging", tr("Cancel"), tr("Stops the judge"));
    m_hint = addButton("levelHintButton", tr("Hint"), tr("Shows or hides a hint"));
    m_hint->setCheckable(true);
    texts->addWidget(m_buttons);
    connect(m_title, &QAbstractButton::toggled, this, [this](bool open) {
        m_content->setVisible(open);
        emit changed();
    });
    connect(m_judge, &QToolButton::clicked, this, [this] { m_desk.judge(m_lesson, m_id); });
    connect(m_cancel, &QToolButton::clicked, &desk, &ProjectDesk::cancel);
    connect(m_hint, &QToolButton::toggled, this, [this](bool shown) {
        m_hintText->setVisible(shown);
        emit changed();
    });
    m_content->hide();
    refresh();
}

QToolButton *LevelBox::addButton(const QString &name, const QString &text, const QString &tip)
{
    auto *button = new QToolButton(m_buttons->strip());
    m_buttons->add(button);
    button->setObjectName(name);
    button->setText(text);
    button->setToolTip(tip);
    button->setAccessibleName(tr("%1: %2").arg(text, m_name));
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

void LevelBox::setUnfolded(bool isUnfolded)
{
    m_title->setChecked(isUnfolded);
}

bool LevelBox::isUnfolded() const
{
    return m_title->isChecked();
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
    const bool isPassed = m_desk.isPassed(m_lesson, m_id);
    const bool isJudging = m_desk.judging(m_lesson) == m_id;
    m_title->setText(isPassed ? m_name + QStringLiteral(" ✓") : m_name);
    m_title->setAccessibleName(isPassed ? tr("%1, passed").arg(m_name) : m_name);
    m_title->updateGeometry();
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
    }
    m_sentence->setVisible(!sentence.isEmpty());
    m_judge->setVisible(!isJudging);
    m_cancel->setVisible(isJudging);
    m_buttons->refresh();
    emit changed();
}

}
