#pragma once

#include "app/model/catalog/lesson_summary.h"
#include "app/model/session/session.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

class QLabel;
class QToolButton;

namespace app {

class NarrationText;
class ProjectBox;
class ProjectDesk;
class RecallBox;
class RecallDesk;
class StepButtons;

/// A page after the last step of a lesson: what the learner learnt, what is left to try, and what comes next.
class SummaryPage : public QWidget
{
    Q_OBJECT

public:
    SummaryPage(Session &session, const Theme &theme, QWidget *parent = nullptr);

    /// Adds the questions of the open lesson below the title. `desk` must outlive this object.
    void addRecall(RecallDesk &desk);
    /// Returns whether the open lesson has questions.
    bool hasQuestions() const;
    /// Adds the project of the open lesson above the list of its steps. `desk` must outlive this object.
    void addProject(ProjectDesk &desk);
    /// Scrolls to the project.
    void showProject();

    QSize minimumSizeHint() const override { return {200, 160}; }

signals:
    /// Emitted when the learner goes back to the text of the open step.
    void closed();

protected:
    void showEvent(QShowEvent *event) override;

private:
    QWidget *makeText();
    QWidget *makeButtons();
    void open();
    void refresh();
    void startOver();
    QString textOf(const LessonSummary &summary) const;
    /// Returns what the learner predicted in a step, and what came out, in Markdown.
    QStringList predictionsOf(const QString &stepId) const;

    Session &m_session;
    const Theme &m_theme;
    QLabel *m_title = nullptr;
    NarrationText *m_text = nullptr;
    RecallDesk *m_desk = nullptr;
    RecallBox *m_recall = nullptr;
    ProjectBox *m_project = nullptr;
    QToolButton *m_startOver = nullptr;
    StepButtons *m_buttons = nullptr;
    QString m_lesson;        ///< the id of the lesson that is shown
    QStringList m_forgotten; ///< ticks that can be restored
    bool m_isStale = false;
};

}
