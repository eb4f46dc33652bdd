#pragma once

#include "app/model/glossary.h"
#include "app/model/session.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

class QToolButton;

namespace app {

class LessonList;
class Narration;
class LessonRail;
class PanelTitle;
class SummaryPage;
class WordCard;

/// The left side of the window: the lessons over the text of the open step, or over the summary of its lesson. Where there
/// is little room it is a rail: the marks of the lessons alone.
class LearnPanel : public QWidget
{
    Q_OBJECT

public:
    enum class Form { whole, rail };
    static constexpr int railWidth = 44; ///< px

    LearnPanel(Session &session, const Theme &theme, QWidget *parent = nullptr);

    void setForm(Form form);
    Form form() const { return m_form; }
    const Glossary &glossary() const { return m_glossary; }
    Narration &narration() const { return *m_narration; }
    /// The summary of the open lesson in place of the step's text, or that again.
    void showSummary(bool shown);
    /// To what comes next: the next step, after the last one of a lesson its summary, after that the next lesson. While this is
    /// not seen there is no summary.
    void goOn();
    void goBack();

    QSize sizeHint() const override { return {m_form == Form::rail ? railWidth : 280, 700}; }
    QSize minimumSizeHint() const override;

signals:
    /// A button asks for another form.
    void formAsked(LearnPanel::Form form);
    void formChanged();
    /// All words were asked for, first of all those that are found for this.
    void glossaryAsked(const QString &typed);

protected:
    bool event(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void shareHeight();
    void shareRail();
    void dressRail();
    QWidget *foldButton();
    void makeUnfold();
    /// Shows the text, the summary, or all of the list in their place.
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
    LessonRail *m_rail;
    QToolButton *m_unfold; ///< on: all of the list in place of the text
    QWidget *m_divider;
    WordCard *m_card;
};

}
