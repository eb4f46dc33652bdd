#pragma once

#include "app/ui/measure/plot_marks.h"
#include "app/ui/measure/spot_plot.h"

#include <map>

namespace app {

/// Error against step, both on logarithmic axes: a method's order is how steep its line is. Dotted: as steep as the
/// order that the method states.
class OrderPlot : public SpotPlot
{
    Q_OBJECT

public:
    OrderPlot(AccuracyStudy &study, const Theme &theme, QWidget *parent = nullptr);

    /// "RK4: 4.0, as stated".
    static QString orderWords(const sim::Accuracy &accuracy, const sim::Method &method);

protected:
    std::vector<Spot> layOut() override;
    void placeWords() override;
    void draw(QPainter &painter) override;
    QString tipOf(const Spot &spot) const override;

private:
    std::map<int, std::vector<const Spot *>> lines() const;
    QPolygonF onScreenAll(const std::vector<const Spot *> &line) const;
    void drawStated(QPainter &painter, const Spot &from, const Spot &to) const;

    std::vector<PlacedLabel> m_names;
};

}
