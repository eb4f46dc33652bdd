#pragma once

#include "app/model/difference_course.h"
#include "app/ui/theme/theme.h"

#include "app/ui/theme/custom_plot.h"

namespace app {

/// How far two runs are apart over time, with the largest difference marked and the cursor in it. A press or a drag goes to
/// a frame.
class DifferencePlot : public QCustomPlot
{
    Q_OBJECT

public:
    DifferencePlot(Session &session, const DifferenceCourse &course, const Theme &theme,
                   QWidget *parent = nullptr);

    /// Draws what was looked at until now.
    void refresh();
    /// The frame at a place of the widget.
    std::int64_t frameAt(double x) const;

    QSize minimumSizeHint() const override { return {140, 110}; }
    QSize sizeHint() const override { return {480, 220}; }

protected:
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;

private:
    void dress();
    void markLargest();
    void goTo(double x);

    Session &m_session;
    const DifferenceCourse &m_course;
    const Theme &m_theme;
    QCPGraph *m_line;
    QCPGraph *m_peak;
    QCPItemText *m_name;
    QCPItemStraightLine *m_cursor;
};

}
