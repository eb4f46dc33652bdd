#pragma once

#include "app/ui/theme/theme.h"
#include "lessons/api/step.h"

#include <QWidget>

class QToolButton;

namespace app {

class GuessBox;
class NarrationText;
class TryRow;

/// A task with a line that says what is still missing, a hint on request, and an answer once the task is
/// done.
class TryBox : public QWidget
{
    Q_OBJECT

public:
    static constexpr int left = 4; ///< px before the row, so that the button is aligned under its box

    TryBox(const lessons::Try &what, const Theme &theme, QWidget *parent = nullptr);

    /// Marks the task as done. A finished task offers its answer in place of its hint.
    void setDone(bool done);
    bool isDone() const;
    /// Shows what is still to do, in Markdown; an empty text hides the line. Returns whether the text has
    /// changed.
    bool setTodo(const QString &todo);
    /// Shows or hides the answer of a finished task.
    void showAnswer(bool shown);
    bool hasHint() const;
    bool showsHint() const;
    void showHint(bool shown);
    /// Shows what the learner chose as her answer, by its index; -1: nothing. Only with Try::choices.
    void setChosen(int index);

signals:
    /// Emitted when the learner asks for the hint, or hides it.
    void hintToggled(bool shown);
    /// Emitted when the learner asks for the answer, or hides it.
    void answerToggled(bool shown);
    /// Emitted when the learner chooses an answer.
    void chosen(int index);
    /// Emitted when the choices are folded or unfolded.
    void choicesToggled(bool shown);

private:
    NarrationText *addText(const QString &name, const QString &text);
    void addGuess(const lessons::Choices &choices);
    void press(bool shown);
    void describeButton();

    const Theme &m_theme;
    TryRow *m_row;
    GuessBox *m_guess = nullptr;     ///< null if there are no choices
    QToolButton *m_button = nullptr; ///< null if there is neither hint nor answer
    NarrationText *m_todo = nullptr;
    NarrationText *m_hint = nullptr;   ///< null if there is no hint
    NarrationText *m_answer = nullptr; ///< null if there is no answer
    QString m_todoText;
};

}
