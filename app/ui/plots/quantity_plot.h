#pragma once

#include "app/model/series/plot_list.h"
#include "app/model/series/plot_series.h"
#include "app/ui/plots/cursor_plot.h"

namespace app {

/// A quantity of the run against time, or against another quantity. Layers are buffered: axes are painted again only
/// when they change, curves when they grow, and cursors over both.
class QuantityPlot : public CursorPlot
{
    Q_OBJECT

public:
    QuantityPlot(const OpenRun &run, Playback &playback, const PlotSeries &series, const Theme &theme,
                 QWidget *parent = nullptr);

    void setSpec(const PlotSpec &spec);
    const PlotSpec &spec() const { return m_spec; }
    /// Draws the curve thicker if it is of `body`, because the pointer is at that body.
    void setPointedBody(const QString &body);
    bool isThick() const { return m_isThick; }
    /// Draws what has changed. `begun` holds the values where the cursor's frame begins, by columns of the series;
    /// `inside` holds those inside the frame, if the cursor is inside one.
    void refresh(const std::vector<double> &begun, const std::optional<PlotSeries::Inside> &inside);

    /// Returns the title: "y of foot 1 against time".
    QString title() const override;
    /// Returns the value at the cursor, also inside a frame, with its unit. A plot against another quantity has two.
    QString valueText() const;
    /// Returns the same without rounding: valueText() shows rounding errors as 0.
    QString exactText() const;
    QString sentence() const override;
    /// Returns the text in place of a curve; empty where there is one.
    const QString &emptyText() const { return m_empty; }
    std::optional<std::int64_t> frameAt(QPointF place) const override;
    /// Returns the place of a frame of the run, in px.
    QPointF placeOf(std::int64_t frame) const;
    /// Returns the place of the moment inside a frame, in px, if the cursor is inside one.
    std::optional<QPointF> insidePlace() const;
    PlotPicture picture() override;
    /// Returns how often each layer was painted, for tests.
    int curvesPainted() const { return m_curvesPainted; }
    int comparisonsPainted() const { return m_comparisonsPainted; }
    int axesPainted() const { return m_axesPainted; }

    QSize minimumSizeHint() const override { return {200, 110}; }
    QSize sizeHint() const override { return {380, 190}; }

signals:
    /// Emitted when the learner wants to see fewer frames (`steps` > 0) or more.
    void zoomWanted(int steps);
    void removalWanted();

protected:
    void applyTheme() override;
    void paintMarks(QPainter &painter) override;
    std::vector<QPointF> curvesAt(std::int64_t frame) const override;
    QString hoveredText(std::int64_t frame) const override;
    bool hasTimeAxis() const override { return m_spec.isAgainstTime(); }
    bool wantsKey(const QKeyEvent &event) const override;
    void resizeEvent(QResizeEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    /// The values of a moment on both axes.
    struct Moment
    {
        double up = 0.0;
        double across = 0.0; ///< frames, if the plot is against time
    };
    /// One curve of the plot, as a function of time or of another quantity.
    struct Curve
    {
        QCPGraph *graph = nullptr;
        QCPCurve *curve = nullptr;
    };
    static Curve onLayer(const char *name, Curve curve);
    void setPen(const Curve &curve, const QPen &pen);
    void setPens();
    QString whyEmpty() const;
    bool fitAxes();
    void fitAxis(QCPAxis &axis, PlotRange &range, std::size_t column);
    void keepShape();
    void drawCurves(bool curves, bool comparison);
    void fillCurves();
    void fillComparison();
    Moment momentOf(const std::vector<double> &numbers, double time) const;
    /// Fills a curve with the buckets from `first` to `last`, both included.
    void fill(const Curve &curve, const Samples &samples, std::size_t first, std::size_t last);
    QString unit(const Quantity &quantity) const;
    QString readout(double up, double across) const;
    /// Returns whether there is anything to point at.
    bool hasCurve() const;
    std::size_t nearestBucket(QPointF place, double &distance) const;
    void paintUnits(QPainter &painter) const;
    void paintNow(QPainter &painter) const;
    QPointF placeOf(const Moment &moment) const;
    /// Returns the moment whose values valueText() shows.
    const Moment &reading() const { return m_inside ? *m_inside : m_now; }
    void paintEmpty(QPainter &painter) const;

    const PlotSeries &m_series;
    PlotSpec m_spec;
    std::size_t m_up = 0;     ///< column of the quantity on the vertical axis
    std::size_t m_across = 0; ///< and on the horizontal one
    Curve m_past;             ///< up to the cursor
    Curve m_future;           ///< computed frames after it
    Curve m_comparison;
    PlotRange m_upRange;
    PlotRange m_acrossRange;
    Moment m_now;                   ///< where the cursor's frame begins
    std::optional<Moment> m_inside; ///< inside it
    QString m_empty;
    quint64 m_drawn = 0;           ///< the revision of the series that is drawn
    quint64 m_drawnComparison = 0; ///< the same of the comparison run
    std::int64_t m_drawnAt = -1;   ///< the frame between past and future
    bool m_axesAreOld = true;
    bool m_isThick = false;
    int m_curvesPainted = 0;
    int m_comparisonsPainted = 0;
    int m_axesPainted = 0;
    double m_wheel = 0.0; ///< the part of a notch that the wheel has turned
};

}
