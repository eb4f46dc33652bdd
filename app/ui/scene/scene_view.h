#pragma once

#include "app/model/session.h"
#include "app/ui/scene/framing.h"
#include "app/ui/scene/hand.h"
#include "app/ui/scene/overlay.h"
#include "app/ui/scene/shown.h"
#include "app/ui/scene/sky.h"
#include "app/ui/scene/tools.h"

#include <QGraphicsScene>
#include <QGraphicsView>

class QNativeGestureEvent;

namespace app {

class AccuracyStudy;

/// The picture of the run: what happens, what happened, and a hand that reaches into it.
class SceneView : public QGraphicsView
{
    Q_OBJECT

public:
    SceneView(Session &session, const Theme &theme, QWidget *parent = nullptr);
    ~SceneView() override;

    /// Shows the reference of `study` while that is watched.
    void attach(const AccuracyStudy &study);

    /// In percent: at 100, a px of the scene is one of the screen.
    double zoom() const;
    const Extras &extras() const { return m_shown.extras; }
    /// All that is drawn now.
    const Shown &shown() const { return m_shown; }
    /// The companion beside it.
    const Shown &beside() const { return m_beside; }
    /// What differs from what was shown is the learner's choice from then on, in every step.
    void setExtras(const Extras &extras);
    /// Shows what the step shows first together with `motion`, the box of a span of the run: see MotionArea::area().
    void showSpan(const QRectF &motion);
    /// Moves the picture so that the body is in the middle.
    void bringBack(const QString &body);
    /// The scene as it is shown, without legends and captions; each px of the screen is `scale` of the picture's.
    QImage picture(double scale = 1.0);
    /// Paints the same, in px of the screen.
    void paintPicture(QPainter &painter);
    /// What is said inside a frame; empty between two frames.
    QString caption() const { return m_shown.caption; }

public slots:
    void zoomIn();
    void zoomOut();
    void zoomTo100();
    /// Shows the whole stage with all bodies, and stays with them from then on.
    void fit();
    /// Shows what it showed before it zoomed by itself.
    void returnHome();
    /// Selects the next of the bodies outside of the picture, and moves the picture to it.
    void showNextOutside();
    void selectNext() { selectBeside(1); }
    void selectPrevious() { selectBeside(-1); }

signals:
    void zoomChanged(double percent);
    /// A step shows other extras than the one before.
    void extrasChanged();
    /// The mouse is on a body, or on none any more: then the name is empty.
    void bodyPointedAt(const QString &body);

protected:
    void drawBackground(QPainter *painter, const QRectF &rect) override;
    void drawForeground(QPainter *painter, const QRectF &rect) override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void mouseDoubleClickEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void keyReleaseEvent(QKeyEvent *event) override;
    bool event(QEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    bool viewportEvent(QEvent *event) override;

private:
    void open();
    /// Dots every 25 px, and crosses every 100, or more widely where those would stand too close.
    void drawGrid(QPainter &painter, const QTransform &toView, const QRectF &area) const;
    void refresh();
    void describe();
    void followGlance();
    void takeMoment();
    void takeCaption();
    /// The moment of the trail or the skins that the mouse is at is looked at: the figure stays, and what it was then is
    /// drawn where it was.
    void lookBack();
    void pointAt(const QString &body);
    void takeExtrasOfStep();
    void takeOnion();
    void takePulls();
    void takeReference();
    void takeCompanion();
    void readTheme();
    Camera camera() const { return Camera(viewportTransform()); }
    QRectF viewRect() const { return QRectF(viewport()->rect()); }
    QString nameOf(int point) const;

    /// Where the run goes from its start if nobody touches it, measured once a run; see MotionArea::area().
    const QRectF &motion();
    /// The same in px of the scene, now.
    QRectF motionHere();
    void showHome();
    void frameHome();
    void frame(const Framing &framing);
    Framing framing() const;
    void setZoom(double zoom, QPointF keep);
    void pan(QPointF by);
    void movePicture(QPointF by);
    void shiftBy(QPointF by);
    /// Moves the picture sideways when the point that the look follows leaves its place, shares of the view's width.
    void followWithin(double from, double to);
    void follow();
    /// After a change: follows, zooms out or comes back, so that there is always something to see.
    void keepSubject();
    /// The box of all bodies, px of the scene.
    QRectF subject() const;
    /// The box of those bodies of the run, and of its companion, that are within `area`.
    QRectF subjectWithin(const QRectF &area) const;
    bool isSubjectInSight() const;
    /// The shortest move, px of the screen, that brings a body into sight.
    QPointF wayToSubject() const;
    void bringSubjectBack();
    void widen();
    /// Inside a frame: enlarges a small creature, so that its arrows can be read.
    void lookClosely();
    void updateCursor();
    const EdgeMarker *markerAt(QPointF place);
    QString tipAt(QPointF place);
    void pinch(const QNativeGestureEvent &gesture);
    void selectBeside(int step);
    void carrySelected(sim::Vec2 by);
    bool useTools(const QKeyEvent &event);
    /// Whether the pointer is on an end of the ruler, which it then moves.
    bool takeRuler();

    Session &m_session;
    const AccuracyStudy *m_study = nullptr;
    const Theme &m_theme;
    Shown m_shown;
    ArrowScales m_runScales; ///< of the run itself: a look at another moment changes nothing of them
    Shown m_beside;          ///< the companion; no picture where there is none
    Overlay m_overlay;
    Hand m_hand;
    Tools m_tools;
    QGraphicsScene m_scene;
    std::vector<EdgeMarker> m_markers; ///< as last asked for
    QRectF m_home;                     ///< what a step shows first, px
    QRectF m_stage;                    ///< of the look that this is from
    bool m_atHome = true;              ///< nobody has zoomed or moved the picture yet
    bool m_isFitted = false;           ///< `m_home` is all that there is to show
    bool m_isClose = false;            ///< it looks closer, inside a frame
    std::optional<Framing> m_narrow;   ///< before the picture zoomed by itself
    std::optional<QRectF> m_motion;    ///< of the run in use, if it is measured
    sim::Cursor m_seenAt;              ///< the moment that was in the picture last
    bool m_follows = true;             ///< nobody has moved the picture away from what walks
    Sky m_sky;
    std::optional<bool> m_wantsVelocities; ///< as the learner chose; a step's look decides before
    std::optional<bool> m_wantsOnion;
    std::optional<QPointF> m_panFrom;
    std::optional<Ruler::End> m_ruled; ///< the end of the ruler that the pointer moves
    QPointF m_pointer{-1.0, -1.0};
    QString m_pointed;             ///< the body that the mouse is on
    bool m_looksBack = false;      ///< whether the moment that is looked at is that under the mouse
    std::optional<QPoint> m_place; ///< what the scroll bars stood at before somebody looked elsewhere
};

}
