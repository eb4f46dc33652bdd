#pragma once

#include "app/ui/theme/theme.h"

#include <QAbstractButton>

#include <vector>

namespace app {

/// A small plot of a curve against time, to choose one of several.
class CurveButton : public QAbstractButton
{
    Q_OBJECT

public:
    /// `number`: its number in the row, which is also its key.
    CurveButton(int number, const Theme &theme, QWidget *parent = nullptr);

    /// Shows a curve on a scale from `least` to `most`. `pointsDown`: larger values are lower, as for y in px.
    void setCurve(const std::vector<double> &curve, double least, double most, bool pointsDown);
    /// Marks the curve as the right one.
    void setRight(bool isRight);
    QSize sizeHint() const override { return {76, 64}; }
    QSize minimumSizeHint() const override { return {48, 64}; }

protected:
    void paintEvent(QPaintEvent *event) override;
    void nextCheckState() override;

private:
    void describe();

    const Theme &m_theme;
    int m_number;
    std::vector<double> m_curve;
    double m_least = 0.0;
    double m_most = 1.0;
    bool m_pointsDown = false;
    bool m_isRight = false;
};

}
