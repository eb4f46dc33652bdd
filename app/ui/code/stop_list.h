#pragma once

#include "app/model/session.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QScrollArea;
class QVBoxLayout;

namespace app {

class Theme;

/// Below the code: where the run is to stop by itself, and a field for one more condition.
class StopList : public QWidget
{
    Q_OBJECT

public:
    StopList(Session &session, const Theme &theme, QWidget *parent = nullptr);

    QLineEdit *field() const { return m_field; }
    /// The sentence about what was refused last; empty if nothing was.
    QString refusal() const;
    /// Takes the keyboard to the condition of a breakpoint.
    void edit(int id);

signals:
    /// A line was chosen: it should come into view.
    void chosen(const CodePlace &place);

private:
    void rebuild();
    /// An example of a condition, of a body that is there.
    void suggest();
    QWidget *rowFor(const Breakpoint &breakpoint);
    QLineEdit *conditionOf(const Breakpoint &breakpoint, QWidget *row);
    void addFromField();
    void setCondition(int id, QLineEdit *edit);
    /// Whether `text` makes sense in this scene; if not, says why.
    bool accepts(const QString &text);
    void say(const QString &refusal);
    void dress();

    Session &m_session;
    const Theme &m_theme;
    QScrollArea *m_scroll;
    QWidget *m_rows = nullptr;
    QLineEdit *m_field;
    QLabel *m_refusal;
    std::vector<Breakpoint> m_shown; ///< what the rows show
};

}
