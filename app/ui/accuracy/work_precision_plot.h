#pragma once

#include "app/ui/accuracy/study_plot.h"
#include "app/ui/accuracy/work_precision_layout.h"

namespace app {

/// Error against time, both on logarithmic axes: what each step of each method costs and how far off it is. Before
/// there are times, it is error against how often forces are computed.
class WorkPrecisionPlot : public StudyPlot
{
    Q_OBJECT

public:
    WorkPrecisionPlot(AccuracyStudy &study, const Theme &theme, QWidget *parent = nullptr);

    /// Returns the error, in px, that the learner wants to stay below: a line that is dragged, or moved by + and -.
    double target() const { return m_target; }
    void setTarget(double target);
    /// Returns where the handle of that line is.
    QRectF targetHandle() const;
    /// Returns whether the time that a frame is on the screen is in sight.
    bool showsFrame() const { return m_timed && xAxis->range().contains(frameOnScreen); }

    static constexpr double leastTarget = 1e-10; ///< px
    static constexpr double mostTarget = 100.0;  ///< px

signals:
    void targetChanged();

protected:
    std::vector<Spot> layOut() override;
    AxisNames axisNames() const override;
    void drawLines(QPainter &painter) override;
    void drawOver(QPainter &painter) override;
    LabelPlaces takenPlaces() const override;
    LabelPlaces placeNames() override;
    bool wantsKey(const QKeyEvent &event) const override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    static QString hereText();
    static QString frameText();
    /// Returns where that is written; empty where the line is out of sight.
    QRectF frameLabel() const;
    void drawFrame(QPainter &painter) const;
    /// Returns the spots of the Pareto front on the screen, from cheap to expensive; empty before there are times.
    QPolygonF frontLine() const;
    QRectF hereTag() const;
    void drawFront(QPainter &painter) const;
    void drawLadders(QPainter &painter) const;
    void drawWhiskers(QPainter &painter) const;
    /// The name of the front and the line to it. Empty where there is no room.
    struct Note
    {
        QRectF box;
        QLineF lead; ///< ends at the front
    };
    static QString frontText();
    Note frontNote(const LabelPlaces &places) const;
    void drawFrontNote(QPainter &painter) const;
    void drawUnstable(QPainter &painter) const;
    void drawTarget(QPainter &painter) const;
    void drawHere(QPainter &painter) const;
    bool isOnTarget(QPointF at) const;

    double m_target = 0.1;
    bool m_timed = false;
    bool m_isDraggingTarget = false;
    Note m_note;
};

}
