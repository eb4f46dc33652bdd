#pragma once

#include "app/model/series/measure_series.h"
#include "app/model/session/preview.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

namespace app {

/// A row with one measure: its name, number and unit, and a curve of its time series with the cursor in it.
class MeasureRow : public QWidget
{
    Q_OBJECT

public:
    static constexpr int height = 34;
    static constexpr int mostOutputSteps = 240; ///< at most, of the time series

    /// `index` is the index of the measure in the step.
    MeasureRow(const OpenRun &run, const Preview &preview, const MeasureSeries &series, std::size_t index,
               const Theme &theme, QWidget *parent = nullptr);

    /// Updates the number at the cursor.
    void refresh();
    /// Returns the number as shown: "12.3", or "–" if there is nothing to measure.
    QString number() const;
    QSize sizeHint() const override { return {300, height}; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    double valueAt(std::int64_t frame) const;
    double valueNow() const;
    void paintSeries(QPainter &painter, const QRectF &area) const;

    const OpenRun &m_run;
    const Preview &m_preview;
    const MeasureSeries &m_series;
    std::size_t m_index;
    lessons::Measure m_measure;
    const Theme &m_theme;
    double m_value;
};

}
