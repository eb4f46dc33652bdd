#include "app/ui/learn/step/try_box.h"

#include "app/ui/learn/narration_text.h"
#include "app/ui/learn/prose.h"
#include "app/ui/learn/step/guess_box.h"
#include "app/ui/learn/step/try_row.h"
#include "app/ui/theme/icon_button.h"

#include <QToolButton>
#include <QVBoxLayout>

namespace app {

namespace {

constexpr QSize hintButtonSize{24, 24};
constexpr QPoint buttonPlace{0, 22}; ///< under the box of the row, clear of its text
constexpr int leastHeight = 46;      ///< px, of a row with a button
constexpr int hintLeft = 25;         ///< px from the row’s left: aligned with the row's text

}

TryBox::TryBox(const lessons::Try &what, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_theme(theme), m_row(new TryRow(what.text, theme, this))
{
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(left, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(m_row);
    addGuess(what.choices);
    m_todo = addText("todoText", {});
    if (!what.hint.isEmpty())
        m_hint = addText("hintText", what.hint);
    if (!what.answer.isEmpty())
        m_answer = addText("answerText", what.answer);
    if (!m_hint && !m_answer)
        return;
    m_button = new QToolButton(this);
    m_button->setObjectName("hint");
    showIcon(*m_button, "hint", theme);
    m_button->setCheckable(true);
    m_button->setIconSize({14, 14});
    m_button->setGeometry(QRect(buttonPlace, hintButtonSize));
    m_button->setFocusPolicy(Qt::TabFocus);
    connect(m_button, &QToolButton::clicked, this, &TryBox::press);
    setDone(false);
}

NarrationText *TryBox::addText(const QString &name, const QString &text)
{
    auto *made = new NarrationText(m_theme, this, NarrationText::Kind::aside);
    made->setObjectName(name);
    made->setText(text);
    made->hide();
    auto *indented = new QVBoxLayout; // takes no space while the text is hidden
    indented->setContentsMargins(hintLeft, 0, 0, 4);
    indented->addWidget(made);
    static_cast<QVBoxLayout *>(layout())->addLayout(indented);
    return made;
}

void TryBox::addGuess(const lessons::Choices &choices)
{
    if (choices.isEmpty())
        return;
    m_guess = new GuessBox(choices, m_theme, this);
    auto *indented = new QVBoxLayout;
    indented->setContentsMargins(hintLeft, 0, 0, 2);
    indented->addWidget(m_guess);
    static_cast<QVBoxLayout *>(layout())->addLayout(indented);
    connect(m_guess, &GuessBox::chosen, this, &TryBox::chosen);
    connect(m_guess, &GuessBox::unfolded, this, &TryBox::choicesToggled);
}

void TryBox::setChosen(int index)
{
    if (m_guess)
        m_guess->setChosen(index);
}

void TryBox::press(bool shown)
{
    if (isDone()) {
        showAnswer(shown);
        emit answerToggled(shown);
    } else {
        showHint(shown);
        emit hintToggled(shown);
    }
}

void TryBox::describeButton()
{
    const bool shown = m_button->isChecked();
    if (isDone())
        m_button->setToolTip(shown ? tr("Hide the answer") : tr("Show the answer"));
    else
        m_button->setToolTip(shown ? tr("Hide the hint") : tr("Show a hint (H)"));
    m_button->setAccessibleName(isDone() ? tr("Answer: %1").arg(m_row->plain())
                                         : tr("Hint: %1").arg(m_row->plain()));
}

void TryBox::setDone(bool done)
{
    m_row->setDone(done);
    if (done)
        setTodo({});
    if (m_guess)
        m_guess->setDone(done);
    if (!m_button)
        return;
    const bool hasMore = done ? m_answer != nullptr : m_hint != nullptr;
    if (done)
        showHint(false);
    else
        showAnswer(false);
    const NarrationText *asked = done ? m_answer : m_hint;
    m_button->setChecked(asked && !asked->isHidden());
    m_button->setVisible(hasMore);
    m_row->setMinimumHeight(hasMore ? leastHeight : 0);
    describeButton();
}

bool TryBox::isDone() const
{
    return m_row->isChecked();
}

bool TryBox::setTodo(const QString &todo)
{
    if (todo == m_todoText)
        return false;
    m_todoText = todo;
    const QString text = todo.isEmpty() ? QString() : tr("**Still to do:** %1").arg(todo);
    if (!todo.isEmpty())
        m_todo->setText(text);
    m_todo->setVisible(!todo.isEmpty());
    m_row->setTodo(plainText(text));
    return true;
}

void TryBox::showAnswer(bool shown)
{
    if (!m_answer)
        return;
    m_answer->setVisible(shown);
    if (isDone())
        m_button->setChecked(shown);
    describeButton();
}

bool TryBox::hasHint() const
{
    return m_hint && !isDone();
}

bool TryBox::showsHint() const
{
    return m_hint && !m_hint->isHidden();
}

void TryBox::showHint(bool shown)
{
    if (!m_hint)
        return;
    m_hint->setVisible(shown);
    if (!isDone())
        m_button->setChecked(shown);
    describeButton();
}

}
