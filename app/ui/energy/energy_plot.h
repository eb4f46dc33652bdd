#pragma once

#include "app/model/analysis/energy_lines.h"
#include "app/ui/plots/cursor_plot.h"

namespace app {

/// The quantity that the panel of energy shows.
enum class EnergyView { energy, momentum };

/// Energy, or momentum, over the last frames. Energy is a stack: what there is, what was lost, and as a line what was
/// there at the start and came in; the gap between stack and line is the drift. Momentum is two lines, to the right and
/// down, each with its drift.
class EnergyPlot : public CursorPlot
{
    Q_OBJECT

public:
    static constexpr std::int64_t mostOutputSteps = 240; ///< shown at once

    EnergyPlot(const OpenRun &run, Playback &playback, const EnergySeries &series, const Theme &theme,
               QWidget *parent = nullptr);

    void setView(EnergyView view);
    EnergyView view() const { return m_view; }
    /// Draws what is counted now.
    void refresh(const EnergyLines &lines);
    std::optional<std::int64_t> frameAt(QPointF place) const override;
    QString sentence() const override;
    /// Returns the energy at a frame and the drift until then, or both parts of the momentum. Empty if that frame is
    /// not counted.
    QString readout(std::int64_t frame) const;
    PlotPicture picture() override;

    /// The stack at a frame.
    struct Stack
    {
        /// From the ground up: springs, height, motion, losses to damping, losses to impacts.
        std::array<double, 5> tops{};
        double given = 0.0; ///< the height that it should have
    };
    static Stack stackOf(const sim::Balance &balance, double lowest);

    QSize minimumSizeHint() const override { return {140, 120}; }
    QSize sizeHint() const override { return {360, 240}; }

protected:
    void applyTheme() override;
    void paintMarks(QPainter &painter) override;
    std::vector<QPointF> curvesAt(std::int64_t frame) const override;
    QString hoveredText(std::int64_t frame) const override;

private:
    void makeEnergyLines();
    void makeMomentumLines();
    void drawEnergy(std::int64_t first, std::int64_t last, double lowest);
    void drawMomentum(std::int64_t first, std::int64_t last);
    QCPGraph *line(const QPen &pen);
    QString unit() const;

    const EnergySeries &m_series;
    EnergyView m_view = EnergyView::energy;
    std::vector<QCPGraph *> m_lines;
    std::vector<QCPItemText *> m_names;
    double m_lowest = 0.0; ///< the zero of energy from height
};

}
