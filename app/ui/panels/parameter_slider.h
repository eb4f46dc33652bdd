#pragma once

#include "app/ui/theme/theme.h"
#include "lessons/api/parameter.h"

#include <QSlider>

#include <optional>

namespace app {

/// A slider over the stretch that a parameter declares: in steps of the last place that is shown or, where it has
/// decades, in steps of the first (8, 9, 10, 20, 30...). It can mark the value that the old run has. Values outside
/// the stretch hold the handle at its end.
class ParameterSlider : public QSlider
{
    Q_OBJECT

public:
    static constexpr int handle = 16; ///< px; half of it is left free at both ends

    ParameterSlider(const lessons::Parameter &parameter, const Theme &theme, QWidget *parent = nullptr);

    /// Shows a value without chosen().
    void show(double value);
    void setGhost(std::optional<double> value);
    std::optional<double> ghost() const { return m_ghost; }
    QSize sizeHint() const override { return {120, 20}; }
    QSize minimumSizeHint() const override { return {60, 20}; }

signals:
    /// The learner moved the handle.
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
    double m_unit; ///< one step of the slider; with decades, one of its first decade
    std::optional<double> m_ghost;
    double m_held = 0.0; ///< where the handle was taken, from its middle
};

}
