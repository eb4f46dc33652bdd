#pragma once

#include <QElapsedTimer>
#include <QObject>

namespace tests {

/// Processes events until none is due: no posted event, no paint and no timer that has run out, among them the slices of
/// work that the program does between events. Ends the program if that takes a minute.
void settle();

/// A counter of the events that the application causes by itself: timers and paints of all its objects.
class Activity : public QObject
{
public:
    Activity();
    ~Activity() override;

    /// Waits until `span` ms pass without activity. Returns whether they came within `limit` ms.
    bool comesToRest(int span = 1000, int limit = 30'000);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    QElapsedTimer m_sinceLast;
};

/// A counter of the paint events of one widget.
class PaintCounter : public QObject
{
public:
    explicit PaintCounter(QWidget &widget);

    int count = 0;

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
};

}
