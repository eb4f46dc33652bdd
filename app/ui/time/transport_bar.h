#pragma once

#include "app/model/session/session.h"
#include "app/ui/dock/number_pace.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

class QBoxLayout;
class QShortcut;
class QToolButton;

namespace app {

class Command;
class FrameCounter;
class RunCommands;
class RunsMenu;
class SpeedButton;

/// The bar with the commands of time, the frame counter and the playing speed. 52 px high.
class TransportBar : public QWidget
{
    Q_OBJECT

public:
    /// All arguments must outlive it.
    TransportBar(Session &session, const RunCommands &commands, const Theme &theme,
                 QWidget *parent = nullptr);

    /// Returns the menu of the other runs of the step, which the Run menu shows, too.
    RunsMenu &runs() const { return *m_runs; }

    /// Inserts a widget between the frame counter and the other runs, and takes ownership of it.
    void insertMiddle(QWidget *widget);
    /// Removes that widget; the caller takes ownership.
    void removeMiddle(QWidget *widget);

    QSize minimumSizeHint() const override;

public slots:
    /// Sets the next lower speed of the menu.
    void slower();
    /// Sets the next higher speed of the menu.
    void faster();
    /// Turns the frame counter into an editor.
    void editFrame();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    struct ButtonWidths
    {
        int usual; ///< px
        int least; ///< px, in a narrow bar
    };

    QToolButton *addButton(const QString &name, Command &command, ButtonWidths widths, QColor Tokens::*ink);
    void addSpace(int width);
    void build();
    void refresh();
    void follow(const Change &change);
    void followCursor();
    void followCancel();
    void showFrame();
    /// Shows the previewed moment behind the frame `current`, in as many words as fit, so that no button moves.
    void showPreview(std::int64_t current);
    void fit();

    Session &m_session;
    const RunCommands &m_commands;
    const Theme &m_theme;
    QBoxLayout *m_layout;
    QToolButton *m_runsButton = nullptr;
    RunsMenu *m_runs = nullptr;
    FrameCounter *m_frame = nullptr;
    QWidget *m_middle = nullptr; ///< see insertMiddle()
    SpeedButton *m_speed = nullptr;
    QShortcut *m_cancel; ///< Escape, while the session goes to a far frame or computes a run again
    NumberPace m_pace{m_session.playback()};
};

}
