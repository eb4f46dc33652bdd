#pragma once

#include "app/ui/learn/step_button.h"

namespace app {

/// The buttons below a text: a small one that goes back, and one with the title of what comes next.
class StepButtons : public QWidget
{
    Q_OBJECT

public:
    StepButtons(const Theme &theme, QWidget *parent);

    QPushButton &back() const { return *m_back; }
    StepButton &next() const { return *m_next; }

private:
    QPushButton *m_back;
    StepButton *m_next;
};

}
