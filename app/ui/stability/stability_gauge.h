#pragma once

#include "app/model/stability_words.h"
#include "app/ui/theme/theme.h"

#include <QAbstractButton>

namespace app {

/// How near the step in use is to its limit: a bar with a tick at the limit, and words. While somebody looks at another
/// moment it is of that one, and pale until that is known. A click, Space or Enter asks for the reasons.
class StabilityGauge : public QAbstractButton
{
    Q_OBJECT

public:
    StabilityGauge(const StabilityWatch &watch, const Theme &theme, QWidget *parent = nullptr);

    /// Whether what it shows is not of the moment that somebody looks at, as that takes long to be known.
    bool isPale() const { return m_watch.look().isLate(); }
    /// What stands beside the bar.
    QString words() const { return m_words; }
    /// The share of the limit, in percent, as far as the bar goes; 0 where there is none.
    double percent() const;
    /// Of the bar's width, up to where it is filled; the limit is at limitPlace.
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

    const StabilityWatch &m_watch;
    const Theme &m_theme;
    QString m_words;
};

/// Makes gauges known to screen readers, with their share as value. More calls than one do nothing.
void installGaugeAccess();

}
