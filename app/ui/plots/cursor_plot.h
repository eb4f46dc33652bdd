#pragma once

#include "app/model/session.h"
#include "app/ui/theme/custom_plot.h"
#include "app/ui/theme/theme.h"

#include <optional>

namespace app {

/// A plot with the cursor of the run in it. A press or a drag goes to a frame, the arrow keys go on by one (with Shift by
/// a phase), and where the mouse points is a second, thin cursor with its numbers. What is drawn, and where frames are,
/// is the plots' own business.
class CursorPlot : public QCustomPlot
{
    Q_OBJECT

public:
    CursorPlot(Session &session, const Theme &theme, QWidget *parent = nullptr);

    /// The frame of the second cursor; nothing: there is none.
    void setHovered(std::optional<std::int64_t> frame);
    std::optional<std::int64_t> hovered() const { return m_hovered; }
    /// What is plotted, for those who cannot see it.
    virtual QString title() const { return accessibleName(); }
    /// All of it, with the numbers at the cursor.
    virtual QString sentence() const = 0;
    /// The same, with the frame that is looked at and its numbers, if there is one.
    QString fullSentence() const;
    /// The frame at a place, if the plot has one there.
    virtual std::optional<std::int64_t> frameAt(QPointF place) const = 0;
    /// The plot as it is seen, without focus and second cursor.
    void paintPicture(QCPPainter &painter);

signals:
    /// The mouse is at a frame, or has left.
    void pointedAt(std::optional<std::int64_t> frame);

protected:
    /// What lies over the axes and curves, the cursor among it.
    virtual void paintMarks(QPainter &painter) const = 0;
    /// The second cursor.
    virtual void paintHovered(QPainter &painter, std::int64_t frame) const = 0;
    /// What stands beside it; empty where the plot has nothing there.
    virtual QString hoveredText(std::int64_t frame) const = 0;
    /// Whether a key without Ctrl or Alt is for the plot rather than for the window.
    virtual bool wantsKey(int key) const;

    bool isDragging() const { return m_isDragging; }
    /// Tells who listens to the plot where the cursor is now.
    void announce();
    /// The amber line with its head, if `x` is within the axes.
    void paintCursor(QPainter &painter, double x) const;
    void paintDot(QPainter &painter, QPointF at) const;
    /// A moment inside the cursor's frame: a ring, lighter than the dot.
    void paintInside(QPainter &painter, QPointF at) const;
    void paintHoveredLine(QPainter &painter, double x) const;
    void paintHoveredDot(QPainter &painter, QPointF at) const;
    /// Words in a box over or, where a dot is there, under `dot`.
    void paintTag(QPainter &painter, QPointF dot, const QString &text) const;

    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

    Session &m_session;
    const Theme &m_theme;

private:
    void goTo(QPointF place);

    std::optional<std::int64_t> m_hovered;
    bool m_isDragging = false;
    bool m_isRinged = false; ///< the keyboard is here
};

/// A pen for curves, which are drawn line by line: with ends that leave no gap between two of them. `ink` must be opaque,
/// or the places where two lines meet would show.
QPen curvePen(const QColor &ink, double width);
/// `ink` as it looks where it lets `ground` through, `share` of it left, as an opaque colour.
QColor faint(const QColor &ink, double share, const QColor &ground);

/// Whether a place is one at all.
bool isSomewhere(QPointF place);

}
