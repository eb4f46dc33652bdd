#pragma once

#include "app/model/difference_course.h"
#include "app/ui/plots/cursor_plot.h"
#include "app/ui/plots/plot_export.h"

namespace app {

/// How far two runs are apart over time, with the largest difference marked and the cursor in it.
class DifferencePlot : public CursorPlot
{
    Q_OBJECT

public:
    DifferencePlot(Session &session, const DifferenceCourse &course, const Theme &theme,
                   QWidget *parent = nullptr);

    /// Draws what was looked at until now.
    void refresh();
    std::optional<std::int64_t> frameAt(QPointF place) const override;
    QString sentence() const override;
    PlotPicture picture();

    QSize minimumSizeHint() const override { return {140, 110}; }
    QSize sizeHint() const override { return {480, 220}; }

protected:
    void paintMarks(QPainter &painter) const override;
    void paintHovered(QPainter &painter, std::int64_t frame) const override;
    QString hoveredText(std::int64_t frame) const override;

private:
    void dress();
    void markLargest();
    /// The one that was looked at nearest to a frame; null if none was.
    const Difference *nearest(std::int64_t frame) const;
    QPointF placeOf(const Difference &one) const;

    const DifferenceCourse &m_course;
    QCPGraph *m_line;
    QCPGraph *m_peak;
    QCPItemText *m_name;
};

}
