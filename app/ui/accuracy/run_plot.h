#pragma once

#include "app/model/session/preview.h"
#include "app/ui/accuracy/study_plot.h"

namespace app {

/// Error over the run. Each method has one line, with the step that costs about as much as the one in use. The cursor
/// of the run is in it, and the pointer asks for a preview of its moment.
class RunPlot : public StudyPlot
{
    Q_OBJECT

public:
    RunPlot(AccuracyStudy &study, const Preview &preview, const Theme &theme, QWidget *parent = nullptr);

    /// Returns the rows of the study that are drawn, one for each method.
    const std::vector<std::size_t> &rows() const { return m_rows; }

    /// Returns the frame at a place, if the run has been computed that far.
    std::optional<std::int64_t> frameAt(QPointF place) const;
    /// Returns the frame of the preview, if the plot shows it.
    std::optional<std::int64_t> hovered() const;

signals:
    /// Emitted when the pointer is at a frame, or has left.
    void pointedAt(std::optional<std::int64_t> frame);

protected:
    std::vector<Spot> layOut() override;
    AxisNames axisNames() const override;
    void drawLines(QPainter &painter) override;
    double markerSize() const override { return 8.0; }
    QByteArray numbersOf(const sim::Accuracy &accuracy) const override;
    QString tipOf(const Spot &spot) const override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    void chooseRows();
    void drawCursors(QPainter &painter) const;

    const Preview &m_preview;
    std::vector<std::size_t> m_rows;
};

}
