#pragma once

#include "app/ui/theme/theme.h"

#include <QFrame>

#include <functional>
#include <vector>

class QLabel;
class QPushButton;
class QShortcut;

namespace app {

/// A part of the window that the tour points at.
struct TourStop
{
    QString title;
    QString text;
    std::function<QRect()> part; ///< returns its place, again after each change of the window
};

/// The tour: cards, one after the other, each beside the part of the window that it explains. The window can be used
/// meanwhile. Esc ends the tour.
class Tour : public QFrame
{
    Q_OBJECT

public:
    /// The cards lie over `window`, hidden until the tour is started. `stops` must not be empty.
    Tour(std::vector<TourStop> stops, const Theme &theme, QWidget *window);

    /// Returns whether the tour was never started on this computer.
    static bool isWanted();
    void start();
    void end();
    bool isRunning() const { return !isHidden(); }
    /// Returns the number of the card, from 0.
    std::size_t stop() const { return m_stop; }
    std::size_t count() const { return m_stops.size(); }

signals:
    void ended();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    void makeButtons();
    void goTo(std::size_t stop);
    void forward();
    void back();
    void place();

    /// The side of the part on which the card is.
    enum class Side { right, left, below, above, inside };
    struct Place
    {
        QRect card;
        Side side = Side::inside;
    };
    Place placeBeside(const QRect &part) const;

    std::vector<TourStop> m_stops;
    const Theme &m_theme;
    QWidget *m_ring; ///< round the part
    QLabel *m_title;
    QLabel *m_text;
    QLabel *m_count;
    QPushButton *m_skip;
    QPushButton *m_back;
    QPushButton *m_next;
    QShortcut *m_escape;
    std::size_t m_stop = 0;
    Side m_side = Side::inside;
    int m_tip = 0; ///< px along the side, where its tip points at the part
};

}
