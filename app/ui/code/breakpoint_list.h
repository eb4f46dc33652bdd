#pragma once

#include "app/model/session/open_run.h"
#include "app/model/session/playback.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QScrollArea;

namespace app {

class Theme;

/// A list of breakpoints below the code, with a field for adding a condition. Rows are widgets, because each has three
/// controls that can be reached with Tab: a check box, the condition as a field, and a button.
class BreakpointList : public QWidget
{
    Q_OBJECT

public:
    BreakpointList(const OpenRun &run, Playback &playback, const Theme &theme, QWidget *parent = nullptr);

    QLineEdit *field() const { return m_field; }
    /// Returns the message about the last rejected condition; empty if there is none.
    QString errorText() const;
    /// Moves the keyboard focus to the condition of a breakpoint.
    void edit(int id);

signals:
    /// Emitted when the user chooses a line. The code view should scroll to it.
    void chosen(const CodePlace &place);

private:
    void rebuild();
    /// Shows an example condition that uses a body of the scene.
    void suggest();
    QWidget *rowFor(const Breakpoint &breakpoint);
    QLineEdit *conditionOf(const Breakpoint &breakpoint, QWidget *row);
    void addFromField();
    void setCondition(int id, QLineEdit *edit);
    /// Returns whether `text` is a valid condition in this scene. Shows the reason if it is not.
    bool accepts(const QString &text);
    void showError(const QString &text);

    const OpenRun &m_run;
    Playback &m_playback;
    const Theme &m_theme;
    QScrollArea *m_scroll;
    QWidget *m_rows = nullptr;
    QLineEdit *m_field;
    QLabel *m_error;
    std::vector<Breakpoint> m_shown; ///< the breakpoints in the rows
};

}
