#include "app/ui/parameters/parameter_slider.h"

#include <QMouseEvent>
#include <QPainter>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double grooveHeight = 4.0;
constexpr double stepsOfDecade = 9.0;

/// Returns the number of slider steps from `first`, a power of ten, to `value`. Each step changes the first
/// digit by one.
double decadeSteps(double first, double value)
{
    const double least = std::max(value, first) / first;
    const double decade = std::floor(std::log10(least) + 1e-12);
    return stepsOfDecade * decade + least / std::pow(10.0, decade) - 1.0;
}

}

ParameterSlider::ParameterSlider(const lessons::Parameter &parameter, const Theme &theme, QWidget *parent)
    : QSlider(Qt::Horizontal, parent), m_theme(theme), m_scale(parameter.scale), m_min(parameter.sliderMin),
      m_unit(parameter.isInteger ? 1.0 : std::pow(10.0, -parameter.decimals))
{
    const int steps = std::max(1, qRound(m_scale == lessons::Scale::logarithmic
                                             ? decadeSteps(m_min, parameter.sliderMax)
                                             : (parameter.sliderMax - parameter.sliderMin) / m_unit));
    setRange(0, steps);
    setSingleStep(1);
    setPageStep(std::max(1, steps / 10));
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setLayoutDirection(Qt::LeftToRight); // numbers grow to the right in every language
    connect(this, &QSlider::valueChanged, this, [this](int position) { emit chosen(valueAt(position)); });
}

int ParameterSlider::positionOf(double value) const
{
    const double steps =
        m_scale == lessons::Scale::logarithmic ? decadeSteps(m_min, value) : (value - m_min) / m_unit;
    return static_cast<int>(std::clamp(std::round(steps), double(minimum()), double(maximum())));
}

double ParameterSlider::valueAt(int position) const
{
    double value = m_min + position * m_unit;
    if (m_scale == lessons::Scale::logarithmic) {
        const double decade = std::floor(position / stepsOfDecade);
        value = m_min * std::pow(10.0, decade) * (1.0 + position - stepsOfDecade * decade);
    }
    // Dividing two whole numbers gives the double nearest to the decimal fraction, so that 0.3 equals a typed
    // 0.3.
    return std::round(value / m_unit) / std::round(1.0 / m_unit);
}

void ParameterSlider::show(double value)
{
    const QSignalBlocker silent(this);
    setValue(positionOf(value));
}

void ParameterSlider::setComparison(std::optional<double> value)
{
    if (value == m_comparison)
        return;
    m_comparison = value;
    update();
}

double ParameterSlider::xOf(double position) const
{
    return handle / 2.0 + (width() - handle) * position / maximum();
}

int ParameterSlider::positionAt(double x) const
{
    return qRound((x - handle / 2.0) / (width() - handle) * maximum());
}

void ParameterSlider::paintEvent(QPaintEvent *)
{
    const Tokens &tokens = m_theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (!isEnabled())
        painter.setOpacity(0.4);
    const double middle = height() / 2.0;
    const double at = xOf(sliderPosition());
    const auto bar = [&](double from, double to, const QColor &color) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(color);
        painter.drawRoundedRect(QRectF(from, middle - grooveHeight / 2, to - from, grooveHeight), 2, 2);
    };
    QColor groove = tokens.computed;
    groove.setAlphaF(0.75F);
    bar(xOf(0), xOf(maximum()), groove);
    bar(xOf(0), at, tokens.ink2);
    if (m_comparison) {
        painter.setBrush(tokens.ghost);
        painter.drawRoundedRect(QRectF(xOf(positionOf(*m_comparison)) - 1, middle - 6, 2, 12), 1, 1);
    }
    painter.setPen(QPen(tokens.ink, 1.2));
    painter.setBrush(m_theme.isDark() ? tokens.ink : tokens.scene);
    painter.drawEllipse(QPointF(at, middle), handle / 2.0 - 0.6, handle / 2.0 - 0.6);
}

void ParameterSlider::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    const double x = event->position().x();
    const double offset = x - xOf(sliderPosition());
    m_held = std::abs(offset) <= handle / 2.0 ? offset : 0.0;
    setSliderDown(true);
    setSliderPosition(positionAt(x - m_held));
}

void ParameterSlider::mouseMoveEvent(QMouseEvent *event)
{
    if (isSliderDown())
        setSliderPosition(positionAt(event->position().x() - m_held));
}

void ParameterSlider::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        setSliderDown(false);
}

void ParameterSlider::wheelEvent(QWheelEvent *event)
{
    // The wheel scrolls the panel unless this slider has the focus.
    if (hasFocus())
        QSlider::wheelEvent(event);
    else
        event->ignore();
}

}
