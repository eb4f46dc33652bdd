#pragma once

#include "app/model/session/session.h"
#include "app/ui/actions/step_by.h"
#include "app/ui/theme/theme.h"
#include "app/ui/time/line_strip.h"
#include "app/ui/time/phase_strip.h"
#include "app/ui/time/timeline_painter.h"

#include <QWidget>

namespace app {

/// The timeline of the run, for scrubbing, above the phases of the step at the cursor.
class TimelineStrip : public QWidget
{
    Q_OBJECT

public:
    TimelineStrip(Session &session, const Theme &theme, QWidget *parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    /// What is shown: all, or only the track, as high as a row of buttons.
    enum class Form { whole, trackOnly };
    void setForm(Form form);
    Form form() const { return m_form; }

    /// Sets what is shown below the track: the phases of a step, or the lines of a frame of the listing.
    void setStepBy(StepBy stepBy);

    const TimelineAxis &axis() const { return m_axis; }
    const PhaseStrip &phases() const { return m_phases; }
    const LineStrip &lines() const { return m_lines; }
    /// Returns "Frame 41, after gravity, 2 of 5 phases done".
    QString sentence() const;
    std::int64_t frame() const { return m_session.timeline().cursor().frame; }
    int framesPerOutput() const { return m_session.timeline().track().framesPerOutput(); }
    /// Pauses and goes to a frame.
    void scrubTo(std::int64_t frame);
    /// Returns a description of what is at a place, and what a click does; empty if nothing is there.
    QString hintAt(const QPoint &place) const;
    /// Sets the thin mark at the frame under the mouse, here or in a plot; empty removes it.
    void setPointed(std::optional<std::int64_t> frame);
    std::optional<std::int64_t> pointed() const { return m_pointed; }

signals:
    /// Emitted when the mouse moves to another frame of the track, or leaves the track.
    void pointedAt(std::optional<std::int64_t> frame);
    /// The learner wants to compare this run and the one beside it in numbers.
    void compareWanted();

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    /// Reads everything from the session again.
    void refresh();
    void follow(const Change &change);
    /// Reads the cursor, and repaints what has changed.
    void followCursor();
    void readPhases();
    void readLines();
    bool goesByLines() const { return m_stepBy == StepBy::lines; }
    /// Returns whether the strip shows all phases of the frame just done, because the run is at its end.
    bool showsEnd() const;
    std::shared_ptr<const sim::ComposedInterval> phasesShown() const;
    bool coverRun();
    /// Returns the fork whose mark is at a place, or null. The dots of the comparison run take precedence.
    const Fork *forkAt(const QPointF &place) const;
    bool isOnOldRun(const QPointF &place) const;
    void press(const Fork &fork, const QPoint &onScreen);
    /// Opens a menu of these branches, or of all if there are none.
    void showRuns(std::vector<int> branches, const QPoint &onScreen);
    QString hintOf(const Fork &fork) const;
    /// Returns the phase or line of the strip at a place, or -1.
    int partAt(const QPointF &place) const;
    void setHovered(int phase);
    void showMarked();
    /// Returns the phase of the strip right before a moment, or -1.
    int phaseBefore(sim::Cursor moment) const;
    /// Returns the computed frame under a place, if there is one.
    std::optional<std::int64_t> trackFrameAt(const QPointF &place) const;
    void runTo(int phase);
    void step(bool forward, bool byPhase);
    void announce();

    Session &m_session;
    const Theme &m_theme;
    TimelineAxis m_axis;
    PhaseStrip m_phases;
    LineStrip m_lines;
    StepBy m_stepBy = StepBy::phases;
    RunView m_view;
    Position m_position;
    std::shared_ptr<const sim::ComposedInterval> m_interval; ///< the interval whose phases are shown
    bool m_showsEnd = false;
    int m_hovered = -1;                    ///< the phase or line under the mouse
    std::optional<std::int64_t> m_pointed; ///< the frame under the mouse
    int m_marked = -1;                     ///< the phase that is marked elsewhere
    Form m_form = Form::whole;
    int m_wheel = 0; ///< rest of a notch that was not used yet
    bool m_scrubbing = false;
    bool m_byKeyboard = false; ///< whether focus came from the keyboard, so that its ring shows
};

}
