#pragma once

#include "app/ui/theme/theme.h"
#include "lessons/api/step.h"

#include <QWidget>

class QToolButton;

namespace app {

class NarrationText;
class TryRow;

/// A thing to try with what is still missing, with its hint, which is shown when the learner asks for it, and with its
/// answer once it is done.
class TryBox : public QWidget
{
    Q_OBJECT

public:
    static constexpr int left = 4; ///< px before the row, so that the button stands right under its box

    TryBox(const lessons::Try &what, const Theme &theme, QWidget *parent = nullptr);

    /// What is done needs no hint any more, but has its answer.
    void setDone(bool done);
    bool isDone() const;
    /// Shows what is still to do, in Markdown; an empty text shows nothing. Returns whether the text is another one.
    bool setTodo(const QString &todo);
    bool hasAnswer() const { return m_answer; }
    /// Of what is done.
    void showAnswer(bool shown);
    bool hasHint() const;
    bool showsHint() const;
    void showHint(bool shown);

signals:
    /// The learner has asked for the hint, or put it away.
    void hintAsked(bool shown);
    /// The learner has asked for the answer, or put it away.
    void answerAsked(bool shown);

private:
    NarrationText *addText(const QString &name, const QString &text);
    void press(bool shown);
    void dress();

    const Theme &m_theme;
    TryRow *m_row;
    QToolButton *m_button = nullptr; ///< null where there is neither hint nor answer
    NarrationText *m_todo = nullptr;
    NarrationText *m_hint = nullptr;   ///< null where there is no hint
    NarrationText *m_answer = nullptr; ///< null where there is no answer
    QString m_todoText;
};

}
