#pragma once

#include "app/ui/measure/plot_marks.h"
#include "app/ui/measure/spot_plot.h"

namespace app {

/// Error over the run: one line a method, at the rung that costs about as much as the one in use.
class RunPlot : public SpotPlot
{
    Q_OBJECT

public:
    RunPlot(AccuracyStudy &study, const Theme &theme, QWidget *parent = nullptr);

    /// The rows that are drawn, one a method.
    const std::vector<std::size_t> &rows() const { return m_rows; }

protected:
    std::vector<Spot> layOut() override;
    void placeWords() override;
    void draw(QPainter &painter) override;
    QByteArray numbersOf(const sim::Accuracy &accuracy) const override;
    QString tipOf(const Spot &spot) const override;

private:
    void chooseRows();
    QPolygonF lineOf(std::size_t row) const;

    std::vector<std::size_t> m_rows;
    std::vector<PlacedLabel> m_names;
};

}
