#pragma once

#include "app/model/text/stability_text.h"
#include "app/ui/stability/map_plot.h"

namespace app {

/// The map of growth: stiffness across, step or damping up, coloured where disturbances grow. Using a cell sets stiffness
/// and step or damping.
class GrowthPlot : public MapPlot
{
    Q_OBJECT

public:
    GrowthPlot(StabilityMonitor &monitor, const Theme &theme, QWidget *parent = nullptr);

protected:
    Axes axes() const override;
    const std::vector<TriedSpot> &tried() const override { return m_monitor.tried(); }
    TriedSpot settable(const TriedSpot &spot) const override { return m_monitor.settable(spot); }
    void adopt(const TriedSpot &spot) override { m_monitor.adopt(spot); }
    double shadeOf(std::size_t cell) const override;
    int kindOf(std::size_t cell) const override;
    QString kindWord(int kind) const override;
    QString resultWords(std::size_t cell) const override;
    QString useWords(const TriedSpot &to) const override;
    QString acrossTitle() const override;
    QString upTitle() const override;
    void drawKey(QPainter &painter) const override;
    void applyTheme() override;

private:
    StabilityMonitor &m_monitor;
};

}
