#pragma once

#include "app/ui/measure/plot_marks.h"
#include "app/ui/measure/spot_plot.h"
#include "app/ui/measure/work_precision_layout.h"

namespace app {

/// Error against time: what each rung of each method costs and how far off it is, both on logarithmic axes. Before
/// there are times, error against how often forces are computed.
class WorkPrecisionPlot : public SpotPlot
{
    Q_OBJECT

public:
    WorkPrecisionPlot(AccuracyStudy &study, const Theme &theme, QWidget *parent = nullptr);

    /// The error, in px, that the learner wants to stay below: a line that can be dragged, or moved by + and -.
    double target() const { return m_target; }
    void setTarget(double target);
    /// Where the handle of that line is.
    QRectF targetHandle() const;
    /// Whether times are known, so that the plot shows them.
    bool showsTimes() const { return m_timed; }
    /// Whether the time that a frame is on the screen is in sight.
    bool showsFrame() const { return m_timed && xAxis->range().contains(frameOnScreen); }

    static constexpr double leastTarget = 1e-10; ///< px
    static constexpr double mostTarget = 100.0;  ///< px

signals:
    void targetChanged();

protected:
    std::vector<Spot> layOut() override;
    void placeWords() override;
    void draw(QPainter &painter) override;
    bool press(QPointF at) override;
    void drag(QPointF at) override;
    void drop() override;
    bool key(const QKeyEvent &event) override;
    bool wantsKey(const QKeyEvent &event) const override;
    Qt::CursorShape cursorAt(QPointF at) const override;

private:
    static QString hereText();
    static QString frameText();
    /// Where that is written; empty where the line is out of sight.
    QRectF frameLabel() const;
    void drawFrame(QPainter &painter) const;
    /// What the names must not cover.
    LabelPlaces takenPlaces() const;
    /// The spots that nothing beats, on the screen, from cheap to dear; empty before there are times.
    QPolygonF frontLine() const;
    /// The spot of the way in use; null where it is not shown.
    const Spot *here() const;
    QRectF hereTag() const;
    void drawFront(QPainter &painter) const;
    void drawLadders(QPainter &painter) const;
    void drawWhiskers(QPainter &painter) const;
    /// What the front is called, and the line to it. Empty where there is no room.
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

    double m_target = 0.1;
    bool m_timed = false;
    std::vector<PlacedLabel> m_names;
    Note m_note;
};

}
