#pragma once

#include "app/model/lesson_summary.h"
#include "app/model/session.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QToolButton;

namespace app {

class NarrationText;
class StepButton;

/// After the last step of a lesson: what was learnt, what is still to try, and what comes next.
class SummaryPage : public QWidget
{
    Q_OBJECT

public:
    SummaryPage(Session &session, const Theme &theme, QWidget *parent = nullptr);

    QSize minimumSizeHint() const override { return {200, 160}; }

signals:
    /// Back to the text of the open step.
    void closed();

private:
    QWidget *makeText();
    QWidget *makeButtons();
    void open();
    void refresh();
    void startOver();
    QString textOf(const LessonSummary &summary) const;
    void dress();

    Session &m_session;
    const Theme &m_theme;
    QLabel *m_title = nullptr;
    NarrationText *m_text = nullptr;
    QToolButton *m_startOver = nullptr;
    QPushButton *m_back = nullptr;
    StepButton *m_next = nullptr;
    QStringList m_forgotten; ///< ticks that can be given back
};

}
