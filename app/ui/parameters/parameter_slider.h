#pragma once

#include "app/ui/theme/theme.h"
#include "lessons/api/parameter.h"

#include <QSlider>

#include <optional>

namespace app {

/// A slider over the range that a parameter declares. A linear slider moves in steps of the last decimal
/// shown. A logarithmic one moves in steps of the first digit (8, 9, 10, 20, 30...). It can mark the value of
/// the comparison run. A value outside the range puts the handle at that end.
class ParameterSlider : public QSlider
{
    Q_OBJECT

public:
    static constexpr int handle = 16; ///< px; half of it is left free at both ends

    ParameterSlider(const lessons::Parameter &parameter, const Theme &theme, QWidget *parent = nullptr);

    /// Shows a value without emitting chosen().
    void show(double value);
    void setComparison(std::optional<double> value);
    std::optional<double> comparison() const { return m_comparison; }
    QSize sizeHint() const override { return {120, 20}; }
    QSize minimumSizeHint() const override { return {60, 20}; }

signals:
    /// Emitted when the learner moves the handle.
    void chosen(double value);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;

private:
    double xOf(double position) const;
    int positionAt(double x) const;
    int positionOf(double value) const;
    double valueAt(int position) const;

    const Theme &m_theme;
    lessons::Scale m_scale;
    double m_min;
    double m_unit; ///< one step of the slider; if logarithmic, a step of its first decade
    std::optional<double> m_comparison;
    double m_held = 0.0; ///< offset from the handle's centre to the point where it was grabbed
};

}
