#pragma once

#include "app/model/session.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

#include <vector>

class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace app {

class NarrationText;
class StepButton;
class TryRow;

/// The text of the open step, the things to try in it, and the ways to its neighbours.
class Narration : public QWidget
{
    Q_OBJECT

public:
    Narration(Session &session, const Theme &theme, QWidget *parent = nullptr);

    QSize minimumSizeHint() const override;
    /// Takes the height that the text has at this width.
    void fitText();
    /// The height that shows all of the text, what there is to try, and the buttons at this width.
    int fullHeight() const;
    /// The same with as little of the text as can be scrolled.
    int leastHeight() const;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *makeText();
    QWidget *makeTries();
    QWidget *makeButtons();
    void open();
    void showProgress();
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
    std::vector<TryRow *> m_tries;
    QPushButton *m_back = nullptr;
    StepButton *m_next = nullptr;
};

}
