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

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *makeText();
    QWidget *makeTries();
    QWidget *makeButtons();
    void open();
    void fitText();
    void showProgress();
    void dress();

    Session &m_session;
    const Theme &m_theme;
    QScrollArea *m_area = nullptr;
    QLabel *m_title = nullptr;
    NarrationText *m_text = nullptr;
    QWidget *m_tryPage = nullptr;
    QLabel *m_heading = nullptr;
    QVBoxLayout *m_tryColumn = nullptr;
    std::vector<TryRow *> m_tries;
    QPushButton *m_back = nullptr;
    StepButton *m_next = nullptr;
};

}
