#pragma once

#include "app/model/session/session.h"
#include "app/model/text/glossary.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

class QToolButton;

namespace app {

class Command;
class LessonList;
class Narration;
class LessonRail;
class PanelTitle;
class ProjectDesk;
class RecallDesk;
class RecallPage;
class SummaryPage;
class WordCard;

/// The left panel of the window: the lesson list above the text of the open step or the summary of its
/// lesson. In a narrow window it becomes a rail that shows only the marks of the lessons.
class LearnPanel : public QWidget
{
    Q_OBJECT

public:
    enum class Form { whole, rail };
    static constexpr int railWidth = 44; ///< px

    LearnPanel(Session &session, const Theme &theme, QWidget *parent = nullptr);

    void setForm(Form form);
    /// Sets the keys for changing the form and for the previous and the next step, as the tooltips show them.
    void setKeys(const QKeySequence &form, const QKeySequence &back, const QKeySequence &next);
    /// Shows the command that opens the map of concepts as a button above the list.
    void setMapCommand(Command &command);
    Form form() const { return m_form; }
    /// Returns the words of all lessons. It follows lessons that are opened, changed or removed.
    const Glossary &glossary() const { return m_glossary; }
    Narration &narration() const { return *m_narration; }
    ProjectDesk &projects() const { return *m_projects; }
    /// Shows the summary of the open lesson in place of the step's text, or the text again.
    void showSummary(bool shown);
    /// Goes to the next step. After the last step of a lesson comes its summary, and then the next lesson.
    /// The summary is skipped while this panel is hidden.
    void goOn();
    void goBack();

    QSize sizeHint() const override { return {m_form == Form::rail ? railWidth : 280, 700}; }
    QSize minimumSizeHint() const override;

signals:
    /// Emitted when the learner presses a button that asks for another form.
    void formRequested(LearnPanel::Form form);
    void formChanged();
    /// Emitted when the learner asks for the glossary, with the words that match `typed` first.
    void glossaryRequested(const QString &typed);

protected:
    bool event(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void shareHeight();
    void shareRail();
    void updateRail();
    Narration *makeNarration();
    void makeFold();
    void makeProject();
    void makeRecall();
    void leaveRecall();
    void makeUnfold();
    /// Shows the step's text, the summary, the recall question of the scene, or the full list in place of them.
    void showPages();
    void showCount();
    void listen();

    Session &m_session;
    const Theme &m_theme;
    Form m_form = Form::whole;
    bool m_isSummary = false;
    Glossary m_glossary;
    PanelTitle *m_title;
    LessonList *m_list;
    Narration *m_narration;
    SummaryPage *m_summary;
    ProjectDesk *m_projects = nullptr;
    RecallDesk *m_recallDesk = nullptr;
    RecallPage *m_recall = nullptr;
    LessonRail *m_rail;
    QToolButton *m_map;
    QToolButton *m_fold;
    QToolButton *m_unfold; ///< checked: the full list replaces the text
    QWidget *m_divider;
    WordCard *m_card;
};

}
