#pragma once

#include "app/model/text/stability_text.h"
#include "app/ui/theme/theme.h"

#include <QAbstractButton>
#include <QKeySequence>

namespace app {

class Command;

/// A gauge of how near the step in use is to its limit: a bar with a tick at the limit, and words. During a preview it
/// shows the moment of the preview, and is pale until that is computed. A click, Space or Enter asks for the reasons.
class StabilityGauge : public QAbstractButton
{
    Q_OBJECT

public:
    /// `toggle` shows and hides the reasons.
    StabilityGauge(const StabilityMonitor &monitor, const Command &toggle, const Theme &theme,
                   QWidget *parent = nullptr);

    /// Returns whether the reading of the previewed moment is late, so that the gauge shows an older one.
    bool isPale() const { return m_monitor.preview().isLate(); }
    /// Returns the text beside the bar.
    QString words() const { return m_words; }
    /// Returns the step in percent of its limit, at most as far as the bar goes; 0 if there is no limit.
    double percent() const;
    /// Returns the filled fraction of the bar's width; the limit is at limitPlace.
    double filled() const;

    static constexpr double limitPlace = 0.82;
    static constexpr int barWidth = 92;
    static constexpr int barHeight = 6;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    void refresh();
    const StabilityReading *reading() const;
    QString description() const;
    QColor fillColor() const;
    void paintBar(QPainter &painter, const QRectF &bar) const;

    const StabilityMonitor &m_monitor;
    const QKeySequence m_keys; ///< that show and hide the reasons
    const Theme &m_theme;
    QString m_words;
};

}
