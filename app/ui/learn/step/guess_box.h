#pragma once

#include "app/ui/theme/theme.h"
#include "lessons/api/try.h"

#include <QWidget>

#include <vector>

namespace app {

class ChoiceRow;
class NarrationText;
class WhyButton;

/// The choices of a thing to try that asks a question, folded to a line. A learner can choose before she tries. Once the
/// thing is done, the line says what she chose, and whether it is right.
class GuessBox : public QWidget
{
    Q_OBJECT

public:
    GuessBox(const lessons::Choices &choices, const Theme &theme, QWidget *parent = nullptr);

    /// Shows what the learner chose, by its index; -1: nothing.
    void setChosen(int index);
    /// Sets whether the thing is done, so that the choice is judged.
    void setDone(bool done);

signals:
    /// Emitted when the learner chooses.
    void chosen(int index);
    /// Emitted when the choices are folded or unfolded.
    void unfolded(bool open);

private:
    void refresh();

    const lessons::Choices m_choices;
    WhyButton *m_title;
    NarrationText *m_said;
    QWidget *m_content;
    std::vector<ChoiceRow *> m_rows;
    int m_chosen = -1;
    bool m_isDone = false;
};

}
