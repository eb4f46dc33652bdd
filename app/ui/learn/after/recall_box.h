#pragma once

#include "app/model/learning/recall_desk.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

#include <vector>

class QLabel;
class QPushButton;
class QToolButton;
class QVBoxLayout;

namespace app {

class ChoiceRow;
class NarrationText;

/// The recall questions of a lesson, one at a time. A question can be answered, skipped, and answered again.
class RecallBox : public QWidget
{
    Q_OBJECT

public:
    /// `desk` must outlive this object.
    RecallBox(RecallDesk &desk, const Theme &theme, QWidget *parent = nullptr);

    /// Shows the questions of `lesson`, beginning with the first that is not answered; those of the lesson that it shows
    /// already where they are. It is hidden if there are none.
    void setLesson(const LessonEntry &lesson);
    /// Shows the question with this number, from 0.
    void showQuestion(std::size_t number);
    std::size_t number() const { return m_number; }
    std::size_t count() const { return m_lesson ? m_lesson->recall.questions.size() : 0; }
    /// Shows the present texts and answers.
    void refresh();

signals:
    /// The height can be another one.
    void heightChanged();

protected:
    void showEvent(QShowEvent *event) override;

private:
    /// A choice, and what is said about it once it was chosen.
    struct Row
    {
        ChoiceRow *button = nullptr;
        NarrationText *explanation = nullptr;
        std::size_t choice = 0; ///< index in the document
    };

    QToolButton *addStepButton(const QString &name, const QString &icon, const QString &tip);
    NarrationText *addText(const QString &name);
    void addRows();
    void showAnswers();
    const lessons::RecallQuestion &question() const { return m_lesson->recall.questions[m_number]; }

    RecallDesk &m_desk;
    const Theme &m_theme;
    const LessonEntry *m_lesson = nullptr;
    std::size_t m_number = 0;
    bool m_isStale = false; ///< while the box is hidden, its texts are not made
    QVBoxLayout *m_column;
    QLabel *m_heading;
    QLabel *m_intro;
    QLabel *m_count;
    QToolButton *m_back;
    QToolButton *m_next;
    NarrationText *m_text;
    QVBoxLayout *m_rowColumn;
    std::vector<Row> m_rows;
    QPushButton *m_do;
    NarrationText *m_answer;
};

}
