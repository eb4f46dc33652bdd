#pragma once

#include "app/ui/theme/theme.h"

#include <QWidget>

class QToolButton;

namespace app {

/// The buttons of the lesson rail. The button above the marks opens the whole list; the buttons below go to
/// the previous and the next step.
class LessonRail : public QObject
{
    Q_OBJECT

public:
    LessonRail(const Theme &theme, QWidget *parent);

    QWidget &head() const { return *m_head; }
    QWidget &foot() const { return *m_foot; }
    void setVisible(bool visible);
    /// Sets the keys that show the lessons with their texts.
    void setUnfoldKeys(const QKeySequence &keys);
    /// Sets the tooltips of the back and next buttons. `hasBack` is false at the first step.
    void setWays(const QString &back, const QString &next, bool hasBack);
    /// Sets whether the open step is done. If it is, the next button is highlighted.
    void setDone(bool done);

signals:
    void unfolded();
    void backRequested();
    void nextRequested();

private:
    void applyTheme();

    const Theme &m_theme;
    bool m_isDone = false;
    QWidget *m_head;
    QWidget *m_foot;
    QToolButton *m_unfold;
    QToolButton *m_back;
    QToolButton *m_next;
};

}
