#pragma once

#include "app/model/session.h"
#include "app/ui/theme/theme.h"
#include "app/ui/time/phase_strip.h"
#include "app/ui/time/timeline_painter.h"

#include <QWidget>

namespace app {

/// The run in time, to scrub in, and under it the phases of the step at the cursor, enlarged.
class TimelineStrip : public QWidget
{
    Q_OBJECT

public:
    TimelineStrip(Session &session, const Theme &theme, QWidget *parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

    /// What of it is shown: all, or the run in time alone, as high as a row of buttons.
    enum class Form { whole, trackOnly };
    void setForm(Form form);
    Form form() const { return m_form; }

    const TimelineAxis &axis() const { return m_axis; }
    const PhaseStrip &phases() const { return m_phases; }
    /// "Frame 41, after gravity, 2 of 5 phases done".
    QString sentence() const;
    std::int64_t frame() const { return m_session.timeline().cursor().frame; }
    int rowFrames() const { return m_session.timeline().track().framesPerOutput(); }
    /// Pauses, and goes to a frame.
    void scrubTo(std::int64_t frame);
    /// What is at a place, and what it does; empty where nothing is.
    QString hintAt(const QPoint &place) const;
    /// A thin mark at a frame that the mouse is at, here or in a plot; nothing: there is none.
    void setPointed(std::optional<std::int64_t> frame);
    std::optional<std::int64_t> pointed() const { return m_pointed; }

signals:
    /// The mouse is at a frame of the track, or has left it.
    void pointedAt(std::optional<std::int64_t> frame);
    /// This run and the one beside it are to be compared in numbers.
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
    void startNew();
    /// Reads all of the session again.
    void refresh();
    /// Reads where the cursor is, and repaints what that changes.
    void follow();
    void readPhases();
    /// Whether the strip shows all phases of the frame just done: while the run stands at its end.
    bool showsEnd() const;
    std::shared_ptr<const sim::ComposedInterval> phasesShown() const;
    bool coverRun();
    /// The fork whose mark is at a place, away from the old run's dots; null if none is.
    const Fork *forkAt(const QPointF &place) const;
    bool isOnOldRun(const QPointF &place) const;
    void press(const Fork &fork, const QPoint &onScreen);
    /// A menu of these branches; of all if there are none.
    void showRuns(std::vector<int> branches, const QPoint &onScreen);
    QString hintOf(const Fork &fork) const;
    void setHovered(int phase);
    void showMarked();
    /// The phase of the strip after which a moment is; -1 for none.
    int phaseBefore(sim::Cursor moment) const;
    /// The computed frame under a place; nothing where there is none.
    std::optional<std::int64_t> trackFrameAt(const QPointF &place) const;
    void runTo(int phase);
    void step(bool forward, bool byPhase);
    void announce();

    Session &m_session;
    const Theme &m_theme;
    TimelineAxis m_axis;
    PhaseStrip m_phases;
    RunView m_view;
    Position m_position;
    std::shared_ptr<const sim::ComposedInterval> m_interval; ///< whose phases are shown
    bool m_showsEnd = false;
    int m_hovered = -1;                    ///< the phase that the mouse is on
    std::optional<std::int64_t> m_pointed; ///< the frame that it is on
    int m_marked = -1;                     ///< the phase that is marked elsewhere
    Form m_form = Form::whole;
    int m_wheel = 0; ///< what is left of a notch
    bool m_scrubbing = false;
    bool m_byKeyboard = false; ///< whether focus came with the keyboard, and shows
};

}
