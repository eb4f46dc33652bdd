#pragma once

#include "app/ui/measure/plot_marks.h"
#include "app/ui/measure/spot_plot.h"

namespace app {

/// Error over the run: one line a method, at the rung that costs about as much as the one in use. The cursor of the run is
/// in it, and where the mouse is it asks for a look at that moment.
class RunPlot : public SpotPlot
{
    Q_OBJECT

public:
    RunPlot(AccuracyStudy &study, const Theme &theme, QWidget *parent = nullptr);

    /// The rows that are drawn, one a method.
    const std::vector<std::size_t> &rows() const { return m_rows; }

    /// The frame at a place, if the run has been computed until there.
    std::optional<std::int64_t> frameAt(QPointF place) const;
    /// The frame that somebody looks at, here or elsewhere, if it is drawn.
    std::optional<std::int64_t> hovered() const;

signals:
    /// The mouse is at a frame, or has left.
    void pointedAt(std::optional<std::int64_t> frame);

protected:
    std::vector<Spot> layOut() override;
    void placeWords() override;
    void draw(QPainter &painter) override;
    QByteArray numbersOf(const sim::Accuracy &accuracy) const override;
    QString tipOf(const Spot &spot) const override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    void chooseRows();
    void drawMoments(QPainter &painter) const;
    QPolygonF lineOf(std::size_t row) const;

    std::vector<std::size_t> m_rows;
    std::vector<PlacedLabel> m_names;
};

}
