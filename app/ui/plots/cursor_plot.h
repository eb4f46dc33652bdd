#pragma once

#include "app/model/session/open_run.h"
#include "app/model/session/playback.h"
#include "app/ui/plots/plot.h"

#include <optional>

namespace app {

/// A plot in which each place means a moment of the run, with the cursor of the run in it. A press or a drag goes to a
/// frame, Left and Right go to the next frame (with Shift to the next phase), and a second, thin cursor with its
/// numbers follows the pointer. Derived classes say where frames are and what is drawn.
class CursorPlot : public Plot
{
    Q_OBJECT

public:
    CursorPlot(const OpenRun &run, Playback &playback, const Theme &theme, QWidget *parent = nullptr);

    /// Moves the second cursor to a frame; nothing hides it.
    void setHovered(std::optional<std::int64_t> frame);
    std::optional<std::int64_t> hovered() const { return m_hovered; }
    QString spokenValue() const override;
    /// Returns the frame at a place of the widget, if there is one.
    virtual std::optional<std::int64_t> frameAt(QPointF place) const = 0;

signals:
    /// Emitted when the pointer is at a frame, or has left.
    void pointedAt(std::optional<std::int64_t> frame);

protected:
    /// Returns where the curves are at a frame, in px; empty where the plot shows nothing.
    virtual std::vector<QPointF> curvesAt(std::int64_t frame) const = 0;
    /// Returns the text beside the second cursor; empty where the plot shows nothing.
    virtual QString hoveredText(std::int64_t frame) const = 0;
    /// Returns whether the horizontal axis is time, so that cursors are lines.
    virtual bool hasTimeAxis() const { return true; }

    bool isDragging() const { return m_isDragging; }
    /// Returns the frame of the run's cursor.
    std::int64_t cursorFrame() const { return m_run.timeline().cursor().frame; }
    /// Tells screen readers the numbers at the cursor, unless the run plays.
    void announceCursor();
    /// Shows the frames from `first` to `last`, with room for a cursor at the end.
    void setTimeRange(double first, double last);
    /// Returns the time at a place of the widget, within the axis.
    double timeAt(QPointF place) const;
    /// Paints the line of the cursor with its head, if it is within the axes.
    void paintCursor(QPainter &painter, double x) const;
    void paintDot(QPainter &painter, QPointF at) const;
    /// Paints a ring that marks a moment inside the cursor's frame; it is lighter than the dot.
    void paintInside(QPainter &painter, QPointF at) const;

    bool wantsKey(const QKeyEvent &event) const override;
    void paintPointer(QPainter &painter) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

    const OpenRun &m_run;
    Playback &m_playback;

private:
    void goTo(QPointF place);
    void paintTag(QPainter &painter, QPointF dot, const QString &text) const;

    std::optional<std::int64_t> m_hovered;
    bool m_isDragging = false;
};

}
