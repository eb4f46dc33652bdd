#pragma once

#include "app/ui/accuracy/study_plot.h"

namespace app {

/// Error against step, both on logarithmic axes: the order of a method is the slope of its line. A dotted line has the
/// slope of the order that the method states.
class OrderPlot : public StudyPlot
{
    Q_OBJECT

public:
    OrderPlot(AccuracyStudy &study, const Theme &theme, QWidget *parent = nullptr);

    /// Returns the measured order in words: "RK4: 4.0, as stated".
    static QString orderWords(const sim::Accuracy &accuracy, const sim::Method &method);

protected:
    std::vector<Spot> layOut() override;
    AxisNames axisNames() const override;
    QString nameOf(const sim::Method &method) const override;
    void drawLines(QPainter &painter) override;
    void drawOver(QPainter &painter) override;
    QString tipOf(const Spot &spot) const override;

private:
    void drawStated(QPainter &painter, const Spot &from, const Spot &to) const;
};

}
