#pragma once

#include "app/model/energy_lines.h"
#include "app/ui/plots/cursor_plot.h"
#include "app/ui/plots/plot_export.h"

namespace app {

/// Energy, or momentum, over the last frames, with the cursor in it. Of energy: what there is and what was lost, piled
/// up, up to what was there and came in; the gap between the two is the drift. Of momentum: its parts to the right and
/// down, and of each what is drift.
class EnergyPlot : public CursorPlot
{
    Q_OBJECT

public:
    enum class Shows { energy, momentum };
    static constexpr std::int64_t shownRows = 240;

    EnergyPlot(Session &session, const EnergyCourse &course, const Theme &theme, QWidget *parent = nullptr);

    void setShows(Shows what);
    /// Draws what is counted now.
    void refresh(const EnergyLines &lines);
    std::optional<std::int64_t> frameAt(QPointF place) const override;
    QString sentence() const override;
    /// What there is at a frame, and the drift until then; of momentum its two parts. Empty where that is not counted.
    QString readout(std::int64_t frame) const;

    /// The plot as it is saved.
    PlotPicture picture();

    /// The heights of the pile at a frame, from the ground up: springs, height, motion, what damping took, what impacts
    /// took; and how high it should be.
    struct Pile
    {
        std::array<double, 5> tops{};
        double given = 0.0;
    };
    static Pile pileOf(const sim::Balance &balance, double lowest);

    QSize minimumSizeHint() const override { return {140, 120}; }
    QSize sizeHint() const override { return {360, 240}; }

protected:
    void paintMarks(QPainter &painter) const override;
    void paintHovered(QPainter &painter, std::int64_t frame) const override;
    QString hoveredText(std::int64_t frame) const override;

private:
    void dress();
    void dressEnergy();
    void dressMomentum();
    void drawEnergy(std::int64_t first, std::int64_t last, double lowest);
    void drawMomentum(std::int64_t first, std::int64_t last);
    QCPGraph *line(const QPen &pen);
    QString unit() const;
    /// The heights at a frame that have a dot.
    std::vector<double> marked(std::int64_t frame) const;

    const EnergyCourse &m_course;
    Shows m_shows = Shows::energy;
    std::vector<QCPGraph *> m_lines;
    std::vector<QCPItemText *> m_names;
    double m_lowest = 0.0; ///< from where height counts
};

}
