#pragma once

#include "app/ui/theme/theme.h"

#include <QWidget>

class QToolButton;

namespace app {

/// What stands round the marks of a rail of lessons: above them the way to the whole list, below them the ways to the
/// neighbours of the open step.
class LessonRail : public QObject
{
    Q_OBJECT

public:
    LessonRail(const Theme &theme, QWidget *parent);

    QWidget &head() const { return *m_head; }
    QWidget &foot() const { return *m_foot; }
    void setVisible(bool visible);
    /// Where the two ways lead, in words; there is nothing before the first step.
    void setWays(const QString &back, const QString &next, bool hasBack);
    /// Whether the open step is done, so that the next one is the thing to do.
    void setDone(bool done);

signals:
    void unfolded();
    void backAsked();
    void nextAsked();

private:
    QToolButton *button(const QString &name, QWidget *holder);
    void dress();

    const Theme &m_theme;
    bool m_isDone = false;
    QWidget *m_head;
    QWidget *m_foot;
    QToolButton *m_unfold;
    QToolButton *m_back;
    QToolButton *m_next;
};

}
