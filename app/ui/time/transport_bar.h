#pragma once

#include "app/model/session.h"
#include "app/ui/theme/theme.h"

#include <QElapsedTimer>
#include <QWidget>

class QAction;
class QBoxLayout;
class QShortcut;
class QToolButton;

namespace app {

class FrameCounter;
class RunsMenu;
class SpeedButton;

/// Play, pause and step in time; the frame; the playing speed. 52 px high.
class TransportBar : public QWidget
{
    Q_OBJECT

public:
    TransportBar(Session &session, const Theme &theme, QWidget *parent = nullptr);

    /// "Go to frame", with its shortcut Ctrl+G; it works wherever the focus is, and may be put into a menu.
    QAction *goToFrameAction() const { return m_goToFrame; }
    /// The other runs of the step; the menu may be put into others.
    RunsMenu &runs() const { return *m_runs; }
    /// Opens that menu above its button.
    void chooseRun();

    /// Puts a widget between the frame and the other runs, and owns it from then on.
    void takeIn(QWidget *widget);
    /// Gives it up again: whoever calls takes it.
    void giveOut(QWidget *widget);

    /// Less high and wide than this is not to be had.
    QSize minimumSizeHint() const override;

public slots:
    /// The next speed of the menu.
    void slower();
    void faster();
    /// Turns the counter into an editor.
    void editFrame();
    /// Ends going to a far frame where it is; if nothing goes anywhere, plays or pauses.
    void playOrPause();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    QToolButton *addButton(const QString &name, int width, int least, void (TransportBar::*pressed)());
    void addSpace(int width);
    void build();
    void dress();
    void refresh();
    void follow();
    void showFrame();
    /// What is looked at, in as many words as there is room for: no button moves for it.
    void showLook(std::int64_t stands);
    void showButtons();
    void showRuns();
    void showPlay();
    void fit();
    QString whyNoPast() const;
    QString whyNoFuture() const;
    void restart() { m_session.restart(); }
    void showRestart();
    void phaseBack() { m_session.phaseBack(); }
    void frameBack() { m_session.frameBack(); }
    void frameForward() { m_session.frameForward(); }
    void phaseForward() { m_session.phaseForward(); }

    Session &m_session;
    const Theme &m_theme;
    QBoxLayout *m_layout;
    QToolButton *m_reset;
    QToolButton *m_phaseBack;
    QToolButton *m_frameBack;
    QToolButton *m_play;
    QToolButton *m_frameForward;
    QToolButton *m_phaseForward;
    QToolButton *m_runsButton;
    RunsMenu *m_runs;
    FrameCounter *m_frame;
    QWidget *m_middle = nullptr; ///< what was taken in
    SpeedButton *m_speed;
    QAction *m_goToFrame;
    QShortcut *m_cancel; ///< Escape, while the session goes to a far frame or computes a run again
    QElapsedTimer m_sinceFrame;
};

}
