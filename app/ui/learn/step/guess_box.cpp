#include "app/ui/learn/step/guess_box.h"

#include "app/ui/dock/panel_parts.h"
#include "app/ui/learn/choice_row.h"
#include "app/ui/learn/fold_box.h"
#include "app/ui/learn/narration_text.h"

#include <QVBoxLayout>

namespace app {

GuessBox::GuessBox(const lessons::Choices &choices, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_choices(choices), m_title(new WhyButton({}, theme, this)),
      m_said(new NarrationText(theme, this, NarrationText::Kind::aside)), m_content(new QWidget(this))
{
    setObjectName("guess");
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_content->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    m_said->setObjectName("guessSaid");
    QVBoxLayout *column = makeColumn(this);
    column->addWidget(m_title);
    column->addWidget(m_said);
    column->addWidget(m_content);
    auto *rows = new QVBoxLayout(m_content);
    rows->setContentsMargins(0, 0, 0, 4);
    rows->setSpacing(0);
    for (int i = 0; i < static_cast<int>(choices.texts.size()); ++i) {
        auto *row = new ChoiceRow(choices.texts[i], theme, m_content);
        row->setObjectName(QStringLiteral("guess%1").arg(i + 1));
        rows->addWidget(row);
        m_rows.push_back(row);
        connect(row, &QAbstractButton::clicked, this, [this, i] {
            setChosen(i);
            emit chosen(i);
        });
    }
    connect(m_title, &QAbstractButton::toggled, this, [this](bool open) {
        m_content->setVisible(open && !m_isDone);
        refresh();
        emit unfolded(open);
    });
    m_content->hide();
    refresh();
}

void GuessBox::setChosen(int index)
{
    m_chosen = index < static_cast<int>(m_rows.size()) ? index : -1;
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        m_rows[i]->setChecked(static_cast<int>(i) == m_chosen);
    refresh();
}

void GuessBox::setDone(bool done)
{
    m_isDone = done;
    m_content->setVisible(m_title->isChecked() && !done);
    refresh();
}

void GuessBox::refresh()
{
    const QString text = m_chosen < 0 ? QString() : m_choices.texts[m_chosen];
    const QString title = m_chosen < 0 ? tr("What do you expect?") : tr("You said: %1").arg(text);
    m_title->setMarkdown(title);
    m_title->setToolTip(m_content->isHidden() ? tr("Choose what you expect") : tr("Hide the choices"));
    m_title->setVisible(!m_isDone);
    const QString mark = m_chosen == m_choices.right ? QStringLiteral(" ✓") : QStringLiteral(" ✗");
    m_said->setText(m_chosen < 0 ? QString() : tr("**You said:** %1").arg(text) + mark);
    m_said->setVisible(m_isDone && m_chosen >= 0);
}

}
