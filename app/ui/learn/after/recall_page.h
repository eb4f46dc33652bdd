#pragma once

#include "app/model/learning/recall_desk.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

class QToolButton;

namespace app {

class NarrationText;
class StepButton;

/// The page beside a scene in which a recall question is answered by doing: what to do and, once it is done, the answer.
class RecallPage : public QWidget
{
    Q_OBJECT

public:
    /// `desk` must outlive this object.
    RecallPage(RecallDesk &desk, const Theme &theme, QWidget *parent = nullptr);

    QSize minimumSizeHint() const override { return {200, 160}; }

signals:
    /// Emitted when the learner goes back to the other questions.
    void closed();

private:
    QWidget *makeText();
    QWidget *makeButtons();
    void refresh();

    RecallDesk &m_desk;
    const Theme &m_theme;
    NarrationText *m_text = nullptr;
    NarrationText *m_state = nullptr;
    QToolButton *m_again = nullptr;
    StepButton *m_back = nullptr;
};

}
