#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>

class QScrollArea;
class QWidget;

namespace app {

/// Scrolls a scroll area so that one of its widgets stays in view when heights change. Stops when the user scrolls or
/// moves the focus to another widget.
class ViewKeeper : public QObject
{
    Q_OBJECT

public:
    /// The area owns the keeper.
    explicit ViewKeeper(QScrollArea &area);

    /// Scrolls so that the whole widget is in view, or at least its end, once the layout is done, and keeps it so.
    void keep(QWidget &widget);
    /// Leaves the view where it is from now on.
    void forget();
    /// Returns the last widget that was kept in view, also after the user has scrolled; null after release().
    const QWidget *wanted() const { return m_wanted; }
    void release() { m_wanted.clear(); }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void scroll();

    QScrollArea &m_area;
    QPointer<QWidget> m_kept;
    QPointer<QWidget> m_wanted;
    QTimer m_due;
    bool m_scrolls = false;
};

/// Keeps `widget` in view in the scroll area around it, as ViewKeeper::keep(). Without such an area, nothing happens.
void keepInView(QWidget &widget);

}
