#pragma once

#include <QObject>
#include <QPointer>
#include <QTimer>

class QScrollArea;
class QWidget;

namespace app {

/// Keeps a widget of a scroll area in view while heights change, until somebody scrolls or the focus moves elsewhere.
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
    /// Returns the widget that should have room: the last that was kept, also after somebody has scrolled, until release().
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
