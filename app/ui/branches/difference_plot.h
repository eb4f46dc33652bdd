#pragma once

#include "app/model/series/difference_series.h"
#include "app/ui/plots/cursor_plot.h"

namespace app {

/// The distance between two runs over time, with the largest distance marked.
class DifferencePlot : public CursorPlot
{
    Q_OBJECT

public:
    DifferencePlot(const OpenRun &run, Playback &playback, const DifferenceSeries &series, const Theme &theme,
                   QWidget *parent = nullptr);

    /// Draws the samples that the series has now.
    void refresh();
    std::optional<std::int64_t> frameAt(QPointF place) const override;
    QString sentence() const override;
    PlotPicture picture() override;

    QSize minimumSizeHint() const override { return {140, 110}; }
    QSize sizeHint() const override { return {480, 220}; }

protected:
    void applyTheme() override;
    void paintMarks(QPainter &painter) override;
    std::vector<QPointF> curvesAt(std::int64_t frame) const override;
    QString hoveredText(std::int64_t frame) const override;

private:
    void markLargest();
    /// Returns the sample nearest to a frame; null if there are none.
    const Difference *nearest(std::int64_t frame) const;
    /// Returns the sample at the cursor; null if that frame has none.
    const Difference *atCursor() const;
    QPointF placeOf(const Difference &one) const;

    const DifferenceSeries &m_series;
    QCPGraph *m_line;
    QCPGraph *m_peak;
    QCPItemText *m_name;
};

}
