#pragma once

#include "app/ui/theme/theme.h"

#include <QToolButton>

class QActionGroup;

namespace app {

/// A button that shows the playing speed, "1× 30 frames/s", with a menu of speeds.
class SpeedButton : public QToolButton
{
    Q_OBJECT

public:
    explicit SpeedButton(const Theme &theme, QWidget *parent = nullptr);

    void setSpeed(double speed);
    /// Sets whether only the factor is shown, because space is short.
    void setBrief(bool brief);
    /// Returns the next lower (higher) speed of the menu, or `speed` itself if there is none.
    static double slowerThan(double speed);
    static double fasterThan(double speed);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

signals:
    void chosen(double speed);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QString factor() const;
    QString rate() const;

    const Theme &m_theme;
    QActionGroup *m_choices;
    double m_speed = 1.0;
    bool m_isBrief = false;
};

}
