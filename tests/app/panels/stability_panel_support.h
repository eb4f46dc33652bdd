#pragma once

#include "app/ui/stability/growth_plot.h"
#include "app/ui/stability/stability_gauge.h"
#include "app/ui/stability/stability_panel.h"
#include "tests/app/support/window_fixture.h"

#include <QToolButton>
#include <QtTest>

/// The window with the gauge of stability and its panel.
struct StabilityFixture : tests::WindowFixture
{
    explicit StabilityFixture(const char *lesson = "two_body", const char *step = "mutual");
    /// Waits for a reading of the session as it is.
    void waitForReading();
    /// Waits for a whole map.
    void waitForMap();
    /// Returns the button that opens the map with this index in MapPlane.
    QToolButton *plane(int index) const;
    template <class Widget>
    bool isSeen() const
    {
        return window.findChild<Widget *>()->isVisible();
    }

    app::StabilityGauge &gauge = part<app::StabilityGauge>();
    app::StabilityPanel &panel = part<app::StabilityPanel>();
};

QColor colourAt(QWidget &widget, QPointF place);
bool isNear(const QColor &a, const QColor &b);
