#pragma once

#include "app/model/analysis/settling_monitor.h"
#include "app/ui/stability/map_plot.h"

namespace app {

/// The map of settling times: stiffness across, damping up, darker where the run takes longer to come to rest. Cells where
/// it keeps moving have dots, and those where the motion grows have strokes. Using a cell begins the run again with its
/// stiffness and damping.
class SettlingPlot : public MapPlot
{
    Q_OBJECT

public:
    SettlingPlot(SettlingMonitor &monitor, const Theme &theme, QWidget *parent = nullptr);

    /// Returns what the map counts, in two or three sentences.
    QString explanation() const;

protected:
    Axes axes() const override;
    const std::vector<TriedSpot> &tried() const override { return m_monitor.tried(); }
    TriedSpot settable(const TriedSpot &spot) const override { return m_monitor.settable(spot); }
    void adopt(const TriedSpot &spot) override { m_monitor.adopt(spot); }
    double shadeOf(std::size_t cell) const override;
    int kindOf(std::size_t cell) const override;
    QString resultWords(std::size_t cell) const override;
    QString useWords(const TriedSpot &to) const override;
    QString acrossTitle() const override;
    QString upTitle() const override;
    void drawKey(QPainter &painter) const override;
    void drawSign(QPainter &painter, const QRectF &cell, int kind) const override;
    void applyTheme() override;

private:
    /// Returns what is known about a cell: its own result, or that of the nearest known cell.
    const sim::Settling *resultAt(std::size_t cell) const;

    SettlingMonitor &m_monitor;
};

}
