#pragma once

#include "app/model/series/measure_series.h"
#include "app/model/session/preview.h"
#include "app/ui/dock/number_pace.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

namespace app {

class MeasureRow;

/// A panel with the measures of the open step: each has its number at the cursor and a curve of its time
/// series. It is hidden if the step has no measures.
class MeasurePanel : public QWidget
{
    Q_OBJECT

public:
    MeasurePanel(const OpenRun &run, const Playback &playback, const Preview &preview,
                 const MeasureSeries &series, const Theme &theme, QWidget *parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {300, sizeHint().height()}; }
    bool isEmpty() const { return m_rows.empty(); }

signals:
    /// Emitted when another step is opened: isEmpty() and sizeHint() may have changed.
    void contentChanged();

private:
    void open();
    void follow(const Change &change);
    void refresh();
    void refreshNow();

    const OpenRun &m_run;
    const Preview &m_preview;
    const MeasureSeries &m_series;
    const Theme &m_theme;
    std::vector<MeasureRow *> m_rows;
    const lessons::Step *m_step = nullptr; ///< whose measures the rows show
    NumberPace m_pace;
};

}
