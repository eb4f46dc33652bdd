#pragma once

#include "app/model/session/session.h"
#include "app/ui/scene/body_drag.h"
#include "app/ui/scene/framing.h"
#include "app/ui/scene/hud/hud.h"
#include "app/ui/scene/layers/scene_content.h"
#include "app/ui/scene/layers/sky.h"
#include "app/ui/scene/place_picker.h"
#include "app/ui/scene/tools.h"

#include <QGraphicsScene>
#include <QGraphicsView>
#include <QPointer>

class QNativeGestureEvent;

namespace app {

class AccuracyStudy;
class ProjectDesk;

/// A view of the scene at the moment of the run that is shown. Bodies can be dragged in it.
class SceneView : public QGraphicsView
{
    Q_OBJECT

public:
    SceneView(Session &session, const Theme &theme, QWidget *parent = nullptr);
    ~SceneView() override;

    /// Shows the reference of `study` while it is being shown elsewhere.
    void attach(const AccuracyStudy &study);
    /// Takes the places that the learner predicts. `desk` must outlive this.
    void attach(PredictionDesk &desk);
    /// Shows the rings of the project that is open at `desk`.
    void attach(ProjectDesk &desk);

    /// Returns the zoom in percent. At 100, one scene px is one screen px.
    double zoom() const;
    const Extras &extras() const { return m_shown.extras; }
    /// Returns all that is drawn now.
    const SceneContent &shown() const { return m_shown; }
    /// Returns the companion that is drawn beside the scene.
    const SceneContent &companion() const { return m_companion; }
    /// Sets what is shown besides the creature. Changes count as the learner's choice in all later steps.
    void setExtras(const Extras &extras);
    /// Shows the area that the step shows first, together with `motion`: the box of a span of the run, from
    /// MotionArea::area().
    void showSpan(const QRectF &motion);
    /// Draws a Vec2 of the listing, until it is set again.
    void setVector(const std::optional<VectorMark> &vector);
    /// Highlights the subjects of a formula, until they are set again or another step opens.
    void setHighlights(const std::vector<lessons::Highlight> &highlights);
    /// Sets the box of a card over the scene, which labels avoid. Empty: there is none.
    void setCard(const QRectF &box);
    /// Moves the view to centre the body.
    void bringBack(const QString &body);
    /// Returns an image of the scene as shown, without legends and captions. `scale`: image px per screen px.
    QImage picture(double scale = 1.0);
    /// Paints the same image in screen px.
    void paintPicture(QPainter &painter);
    /// Returns the box of the legend of arrows and ghosts, px of the viewport; empty if there is none.
    QRectF legendBox() const { return m_overlay.legendBox(camera(), viewRect()); }
    /// Returns the caption inside a frame; empty between two frames.
    QString caption() const { return m_shown.caption; }

public slots:
    void zoomIn();
    void zoomOut();
    void zoomTo100();
    /// Shows the whole stage with all bodies, and keeps them in view from then on.
    void fit();
    /// Goes back to the framing before the view zoomed by itself.
    void returnHome();
    /// Selects the next body outside the view, and moves the view to it.
    void showNextOutside();
    void selectNext() { selectBeside(1); }
    void selectPrevious() { selectBeside(-1); }

signals:
    void zoomChanged(double percent);
    /// Emitted when something else is shown: another moment, or other extras.
    void contentChanged();
    /// Emitted when a step shows other extras than the step before.
    void extrasChanged();
    /// Emitted when the mouse enters or leaves a body. The name is empty if there is no body under the mouse.
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
    /// Draws dots every 25 px and crosses every 100 px, or at wider distances where these would be too dense.
    void drawGrid(QPainter &painter, const QTransform &toView, const QRectF &area) const;
    void refresh();
    void describe();
    void followChange(const Change &change);
    void followPreview(const Change &change);
    void takeMoment();
    void takeCaption();
    /// Previews the moment of the trail or onion skin under the mouse. The figure stays, and its earlier pose
    /// is drawn in its earlier position.
    void previewPointed();
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

    /// Returns the area that the run crosses from its start without user input. Measured once per run; see
    /// MotionArea::area().
    const QRectF &motion();
    /// Returns the same area at the present position of the followed point, scene px.
    QRectF motionHere();
    void showHome();
    void frameHome();
    void frame(const Framing &framing);
    Framing framing() const;
    void setZoom(double zoom, QPointF keep);
    void pan(QPointF by);
    void movePicture(QPointF by);
    void shiftBy(QPointF by);
    /// Moves the view sideways if the followed point is outside `from` to `to`, as fractions of the view's
    /// width.
    void followWithin(double from, double to);
    void follow();
    /// Keeps something in view after a change: follows the bodies, zooms out or moves back to them.
    void keepSubject();
    /// Returns the box of all bodies, scene px.
    QRectF subject() const;
    /// Returns the box of the bodies of the run and of its companion within `area`.
    QRectF subjectWithin(const QRectF &area) const;
    bool isSubjectInSight() const;
    /// Returns the shortest move that brings a body into view, screen px.
    QPointF wayToSubject() const;
    void bringSubjectBack();
    void widen();
    /// Inside a frame: enlarges a small creature, to make its arrows readable.
    void zoomToCreature();
    void updateCursor();
    const EdgeMarker *markerAt(QPointF place);
    QString tipAt(QPointF place);
    void pinch(const QNativeGestureEvent &gesture);
    void selectBeside(int step);
    void carrySelected(sim::Vec2 by);
    bool useTools(const QKeyEvent &event);
    /// Starts to move an end of the ruler if the pointer is on it. Returns whether it is.
    bool takeRuler();

    Session &m_session;
    const AccuracyStudy *m_study = nullptr;
    QPointer<ProjectDesk> m_projects;
    const Theme &m_theme;
    SceneContent m_shown;
    ArrowScales m_runScales;  ///< of the run itself; a preview does not change them
    SceneContent m_companion; ///< without a picture if there is no companion
    Hud m_overlay;
    BodyDrag m_drag;
    Tools m_tools;
    PlacePicker m_picker;
    QGraphicsScene m_scene;
    std::vector<EdgeMarker> m_markers; ///< as last computed
    QRectF m_home;                     ///< the area that a step shows first, px
    QRectF m_stage;                    ///< the stage from which `m_home` was computed
    bool m_atHome = true;              ///< the learner has not zoomed or panned yet
    bool m_isFitted = false;           ///< `m_home` is the whole scene
    bool m_isClose = false;            ///< enlarged, inside a frame
    std::optional<Framing> m_narrow;   ///< before the view zoomed by itself
    std::optional<QRectF> m_motion;    ///< of the run in use, once measured
    sim::Cursor m_seenAt;              ///< the last moment shown
    bool m_follows = true;             ///< the learner has not panned away from the followed point
    Sky m_sky;
    std::optional<bool> m_wantsVelocities; ///< the learner's choice; until then, the lesson view decides
    std::optional<bool> m_wantsOnion;
    std::optional<QPointF> m_panFrom;
    std::optional<Ruler::End> m_ruled; ///< the end of the ruler that is being dragged
    QPointF m_pointer{-1.0, -1.0};
    QString m_pointed;             ///< the body under the mouse
    bool m_ownsPreview = false;    ///< whether the preview is of the moment under the mouse
    std::optional<QPoint> m_place; ///< the scroll positions before a preview
};

}
