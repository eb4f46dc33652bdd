#pragma once

#include "app/model/plot_course.h"
#include "app/model/plot_list.h"
#include "app/ui/plots/cursor_plot.h"

namespace app {

/// A quantity of the run against time, or against another one. What is drawn is kept as pictures: the axes are painted
/// anew only where they change, the curves where they grow, and cursors on top of both.
class QuantityPlot : public CursorPlot
{
    Q_OBJECT

public:
    QuantityPlot(Session &session, const PlotCourse &course, const Theme &theme, QWidget *parent = nullptr);

    void setSpec(const PlotSpec &spec);
    const PlotSpec &spec() const { return m_spec; }
    /// The curve is drawn thicker while somebody points at its body.
    void setPointedBody(const QString &body);
    bool isThick() const { return m_isThick; }
    /// Draws what has changed. `begun`: the numbers where the cursor's frame begins, by the course's columns; `inside`:
    /// those inside it, if that is where somebody is.
    void refresh(const std::vector<double> &begun, const std::optional<PlotCourse::Inside> &inside);

    /// "y of foot 1 against time".
    QString title() const override;
    /// The number at the cursor, also inside a frame, with its unit; of a plot against another quantity both.
    QString valueText() const;
    /// The same where it is rounding noise, too, which valueText() shows as 0.
    QString exactText() const;
    QString sentence() const override;
    /// What is said in place of a curve; empty where there is one.
    const QString &emptyText() const { return m_empty; }
    std::optional<std::int64_t> frameAt(QPointF place) const override;
    /// Where a frame of the run is drawn.
    QPointF placeOf(std::int64_t frame) const;
    /// Where the moment inside a frame is drawn, if somebody is inside one.
    std::optional<QPointF> insidePlace() const;
    /// How often curves, the old run's and axes were painted: for tests.
    int curvesPainted() const { return m_curvesPainted; }
    int ghostsPainted() const { return m_ghostsPainted; }
    int axesPainted() const { return m_axesPainted; }

    QSize minimumSizeHint() const override { return {200, 110}; }
    QSize sizeHint() const override { return {380, 190}; }

signals:
    /// More frames are to be shown, or fewer.
    void zoomWanted(int steps);
    void removalWanted();

protected:
    void paintMarks(QPainter &painter) const override;
    void paintHovered(QPainter &painter, std::int64_t frame) const override;
    QString hoveredText(std::int64_t frame) const override;
    bool wantsKey(int key) const override;
    void resizeEvent(QResizeEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    /// A moment of the plot.
    struct Spot
    {
        double up = 0.0;
        double across = 0.0; ///< against time: frames
    };
    /// One curve of the plot, as a function of time or of another quantity.
    struct Curve
    {
        QCPGraph *graph = nullptr;
        QCPCurve *curve = nullptr;
    };
    static Curve onLayer(const char *name, Curve curve);
    void setPen(const Curve &curve, const QPen &pen);
    void dress();
    void dressCurves();
    QString whyEmpty() const;
    bool fitAxes();
    void fitAxis(QCPAxis &axis, PlotRange &range, std::size_t column);
    void keepShape();
    void draw(bool curves, bool ghost);
    void fillCurves();
    void fillGhost();
    Spot spotOf(const std::vector<double> &numbers, double time) const;
    /// Draws the buckets from `first` to `last`, both included.
    void fill(const Curve &curve, const Samples &samples, std::size_t first, std::size_t last);
    QString unit(const Quantity &quantity) const;
    QString readout(double up, double across) const;
    std::size_t nearestBucket(QPointF place, double &distance) const;
    QPointF place(double across, double up) const;
    void paintUnits(QPainter &painter) const;
    void paintNow(QPainter &painter) const;
    QPointF placeOf(const Spot &spot) const;
    /// What the numbers at the cursor are of.
    const Spot &reading() const { return m_inside ? *m_inside : m_now; }
    void paintEmpty(QPainter &painter) const;

    const PlotCourse &m_course;
    PlotSpec m_spec;
    std::size_t m_up = 0;     ///< column of the quantity on the vertical axis
    std::size_t m_across = 0; ///< and on the other
    Curve m_past;             ///< up to the cursor
    Curve m_future;           ///< what is computed after it
    Curve m_ghost;
    PlotRange m_upRange;
    PlotRange m_acrossRange;
    Spot m_now;                   ///< where the cursor's frame begins
    std::optional<Spot> m_inside; ///< inside it
    QString m_empty;
    quint64 m_drawn = 0;         ///< the course's revision that the curves are from
    quint64 m_drawnGhost = 0;    ///< the same of the ghost
    std::int64_t m_drawnAt = -1; ///< the frame at which they change
    bool m_axesAreOld = true;
    bool m_isThick = false;
    int m_curvesPainted = 0;
    int m_ghostsPainted = 0;
    int m_axesPainted = 0;
    double m_wheel = 0.0; ///< what is left of a notch
};

}
