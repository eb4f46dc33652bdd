#pragma once

#include "app/model/session.h"
#include "app/ui/theme/theme.h"

#include <QSet>
#include <QTimer>
#include <QWidget>

#include <vector>

class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace app {

class NarrationText;
class Glossary;
class StepButton;
class TryBox;
class WhyBox;

/// The text of the open step, the things to try in it, and the ways to its neighbours.
class Narration : public QWidget
{
    Q_OBJECT

public:
    /// `glossary` must outlive this.
    Narration(Session &session, const Glossary &glossary, const Theme &theme, QWidget *parent = nullptr);

    QSize minimumSizeHint() const override;
    /// Shows the next hint: of the first thing that is not done and shows none.
    void showNextHint();
    /// What the buttons below the text lead to, for what takes their place.
    QString backTip() const;
    QString nextTip() const;
    /// Takes the height that the text has at this width.
    void fitText();
    /// The height that shows all of the text, what there is to try, and the buttons at this width.
    int fullHeight() const;
    /// The same with as little of the text as can be scrolled.
    int leastHeight() const;

signals:
    /// A word of the text was asked for, which stands over `place` on the screen.
    void wordAsked(const QString &name, const QPoint &place);
    /// After the last step of a lesson comes its summary.
    void summaryAsked();
    /// What is unfolded is higher or lower than before.
    void heightChanged();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *makeText();
    QWidget *makeTries();
    QWidget *makeButtons();
    void open();
    void addTries();
    void addWhys();
    void nameButtons();
    void goOn();
    void remember(std::size_t number, bool shown);
    QString keyOf(std::size_t number) const;
    void showProgress();
    /// Shows the answer of the thing to try that was done just now, and puts those before away.
    void showAnswerOf(std::size_t number);
    void showTodos();
    void dress();

    Session &m_session;
    const Theme &m_theme;
    QScrollArea *m_area = nullptr;
    QLabel *m_title = nullptr;
    NarrationText *m_text = nullptr;
    QWidget *m_tryPage = nullptr;
    QWidget *m_buttons = nullptr;
    QLabel *m_heading = nullptr;
    QVBoxLayout *m_tryColumn = nullptr;
    std::vector<TryBox *> m_tries;
    QVBoxLayout *m_whyColumn = nullptr;
    std::vector<WhyBox *> m_whys;
    QTimer m_todoDue;
    bool m_isOpen = false; ///< whether what is shown as done was done while the step is open
    QSet<QString> m_hints; ///< those that are shown, by step and number, until the program ends
    QPushButton *m_back = nullptr;
    StepButton *m_next = nullptr;
};

}
