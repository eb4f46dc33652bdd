#pragma once

#include "app/model/session.h"
#include "app/ui/scene/hand.h"
#include "app/ui/scene/overlay.h"
#include "app/ui/scene/shown.h"

#include <QGraphicsScene>
#include <QGraphicsView>

class QNativeGestureEvent;

namespace app {

/// The picture of the run: what happens, what happened, and a hand that reaches into it.
class SceneView : public QGraphicsView
{
    Q_OBJECT

public:
    SceneView(Session &session, const Theme &theme, QWidget *parent = nullptr);
    ~SceneView() override;

    /// In percent: at 100, a px of the scene is one of the screen.
    double zoom() const;
    const Extras &extras() const { return m_shown.extras; }
    void setExtras(const Extras &extras);
    /// Moves the picture so that the body is in the middle.
    void bringBack(const QString &body);
    /// What is said inside a frame; empty between two frames.
    QString caption() const { return m_shown.caption; }

public slots:
    void zoomIn();
    void zoomOut();
    void zoomTo100();
    /// Shows the whole stage.
    void fit();
    void selectNext() { selectBeside(1); }
    void selectPrevious() { selectBeside(-1); }

signals:
    void zoomChanged(double percent);

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
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    bool viewportEvent(QEvent *event) override;

private:
    void open();
    void refresh();
    void describe();
    void readTheme();
    Camera camera() const { return Camera(viewportTransform()); }
    QRectF viewRect() const { return QRectF(viewport()->rect()); }
    QString nameOf(int point) const;

    void showHome();
    void showArea(QRectF area, double mostZoom);
    void setZoom(double zoom, QPointF keep);
    void pan(QPointF by);
    void updateCursor();
    const EdgeMarker *markerAt(QPointF place);
    QString tipAt(QPointF place);
    void pinch(const QNativeGestureEvent &gesture);
    void selectBeside(int step);
    void carrySelected(sim::Vec2 by);

    Session &m_session;
    const Theme &m_theme;
    Shown m_shown;
    Overlay m_overlay;
    Hand m_hand;
    QGraphicsScene m_scene;
    std::vector<EdgeMarker> m_markers; ///< as last asked for
    QRectF m_home;                     ///< what a step shows first, px
    bool m_atHome = true;              ///< nobody has zoomed or moved the picture yet
    std::optional<QPointF> m_panFrom;
    QPointF m_pointer{-1.0, -1.0};
};

}
