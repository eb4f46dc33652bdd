#pragma once

#include "app/model/learning/prediction_desk.h"
#include "app/model/listing/task_desk.h"
#include "app/model/session/session.h"
#include "app/ui/learn/step/step_room.h"
#include "app/ui/theme/theme.h"

#include <QKeySequence>
#include <QSet>
#include <QTimer>
#include <QWidget>

#include <vector>

class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace app {

class NarrationText;
class Glossary;
class PartLink;
class PredictionBox;
class StepButtons;
class TaskBox;
class TryBox;
class WhyBox;

/// A panel with the text of the open step, the things to try, and buttons to the previous and the next step.
class Narration : public QWidget
{
    Q_OBJECT

public:
    /// `glossary` must outlive this.
    Narration(Session &session, const Glossary &glossary, const Theme &theme, QWidget *parent = nullptr);

    QSize minimumSizeHint() const override;
    /// Sets the keys that go to the previous and to the next step. The tooltips of the buttons name them.
    void setStepKeys(const QKeySequence &back, const QKeySequence &next);
    /// Shows the next hint: that of the first unfinished task whose hint is still hidden.
    void showNextHint();
    /// Returns the buttons below the text.
    const StepButtons &buttons() const { return *m_buttons; }
    /// Returns whether the learner writes a task of the open step, whose hints and judgement are here.
    bool isWriting() const { return m_desk.task(); }
    /// Returns the predictions of the open step.
    PredictionDesk &predictions() { return m_predictions; }
    /// Sets the height of the text area to the height of its text at the present width.
    void fitText();
    /// Returns the height that shows all of the text, the tasks and the buttons at this width, px.
    int fullHeight() const { return m_room.fullHeight(); }
    /// Returns the same height with the text area at its scrollable minimum, px.
    int leastHeight() const { return m_room.leastHeight(); }

signals:
    /// Emitted when the learner clicks a glossary word in the text. `place` is below the word, in screen coordinates.
    void wordRequested(const QString &name, const QPoint &place);
    /// Emitted when the learner goes on from the last step of a lesson, so its summary comes next.
    void summaryRequested();
    /// Emitted when the learner starts a task in the listing. The listing should be shown, with the caret at the end of
    /// `line` (from 1).
    void listingRequested(int line);
    /// Emitted when a part is folded or unfolded, which changes the height.
    void heightChanged();
    /// Emitted when a formula highlights other things. Empty: nothing.
    void highlightsChanged(const std::vector<lessons::Highlight> &highlights);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void makeText();
    void makeTries();
    void makeButtons();
    void open();
    void addPredictions();
    void showPredictions();
    void goToPrediction();
    void goToTask();
    /// Returns the predictions without a shown answer.
    std::vector<PredictionBox *> openPredictions() const;
    /// Returns the code tasks that are not done.
    std::vector<TaskBox *> openTasks() const;
    /// Gives each link its row, and none if there is nothing to go to. Returns whether that changed anything.
    bool placeLinks();
    void offerLinks();
    void addTries();
    void rememberChoice(std::size_t number, int chosen);
    QString keyOfChoice(std::size_t number) const;
    /// Makes room for the thing to try with this number, whose height has changed, and scrolls to it.
    void makeRoomFor(std::size_t number);
    void addWhys();
    void addTasks();
    void showTasks();
    /// Makes room for `box`, which was folded or unfolded.
    void showUnfolded(QWidget *box, bool open);
    void nameButtons();
    void goOn();
    void remember(std::size_t number, bool shown);
    QString keyOf(std::size_t number) const;
    void showProgress();
    /// Shows the answer of the task that was just done, and hides earlier answers.
    void showAnswerOf(std::size_t number);
    void showTodos();

    Session &m_session;
    const Theme &m_theme;
    StepRoom m_room;
    QLabel *m_title = nullptr;
    NarrationText *m_text = nullptr;
    QWidget *m_tryHead = nullptr; ///< the heading of the things to try
    QWidget *m_tryPage = nullptr;
    StepButtons *m_buttons = nullptr;
    QKeySequence m_backKeys;
    QKeySequence m_nextKeys;
    QLabel *m_heading = nullptr;
    QVBoxLayout *m_tryColumn = nullptr;
    std::vector<TryBox *> m_tries;
    PredictionDesk m_predictions;
    QGridLayout *m_headGrid = nullptr; ///< the heading of the things to try, and links to parts of the text
    PartLink *m_toPredictions = nullptr;
    PartLink *m_toTask = nullptr;
    QLabel *m_predictionHeading = nullptr;
    QVBoxLayout *m_predictionColumn = nullptr;
    std::vector<PredictionBox *> m_predictionBoxes;
    QVBoxLayout *m_whyColumn = nullptr;
    std::vector<WhyBox *> m_whys;
    TaskDesk m_desk;
    QLabel *m_taskHeading = nullptr;
    QVBoxLayout *m_taskColumn = nullptr;
    std::vector<TaskBox *> m_tasks;
    QTimer m_todoDue;
    bool m_hasSize = false; ///< once the layout has given it one
    bool m_isOpen = false;  ///< false while a step opens: ticks from before do not show answers
    QSet<QString> m_hints;  ///< shown hints, by step and number, until the program ends
};

}
