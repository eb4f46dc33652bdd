#pragma once

#include "app/model/series/stances.h"
#include "app/model/session/playback.h"
#include "app/model/session/preview.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

namespace app {

class TimelineStrip;

/// The footfall diagram under the timeline: when each foot is on the ground, and how far it slips. It has no height in
/// steps without such feet.
class FootfallStrip : public QWidget
{
    Q_OBJECT

public:
    FootfallStrip(const OpenRun &run, Playback &playback, Preview &preview, const MeasureSeries &series,
                  TimelineStrip &timeline, const Theme &theme, QWidget *parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {280, sizeHint().height()}; }
    /// Returns the state of the feet at the cursor: "foot0 stands, slipped 0.4 px. foot1 is in the air."
    QString sentence() const;

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void leaveEvent(QEvent *event) override;

private:
    /// Returns the names of the feet that the scene has at the cursor.
    std::vector<QString> feetAtCursor() const;
    void open();
    /// Adds rows for feet that a parameter has added since the run began.
    void addFeet();
    void read();
    void updateDescription();
    int rowHeight() const;
    int rowAt(int y) const;
    const Stance *stanceAt(std::size_t foot, std::int64_t frame) const;
    void paintFoot(QPainter &painter, std::size_t foot, double top, const QFontMetricsF &metrics) const;
    void paintSlip(QPainter &painter, const Stance &stance, const QRectF &bar,
                   const QFontMetricsF &metrics) const;
    void paintCursors(QPainter &painter) const;
    QString tipAt(const QPoint &place) const;

    const OpenRun &m_run;
    Playback &m_playback;
    Preview &m_preview;
    const MeasureSeries &m_series;
    TimelineStrip &m_timeline;
    const Theme &m_theme;
    std::vector<QString> m_names;
    std::size_t m_points = 0; ///< of the scene at the cursor, at the last look
    Stances m_stances;
};

}
