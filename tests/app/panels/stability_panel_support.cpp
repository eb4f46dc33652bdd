#include "tests/app/panels/stability_panel_support.h"

using namespace app;

StabilityFixture::StabilityFixture(const char *lesson, const char *step) : WindowFixture({lesson, step})
{
    waitForReading();
}

void StabilityFixture::waitForReading()
{
    if (!QTest::qWaitFor([&] { return window.stability().reading() && window.stability().isCurrent(); },
                         20'000))
        qFatal("no reading");
    QCoreApplication::processEvents();
}

void StabilityFixture::waitForMap()
{
    const auto whole = std::size_t(StabilityMonitor::columns) * StabilityMonitor::rows;
    if (!QTest::qWaitFor(
            [&] {
                const StabilityMonitor &monitor = window.stability();
                return !monitor.isMapping() && monitor.map() && monitor.map()->growth.size() == whole;
            },
            60'000))
        qFatal("no map");
    QCoreApplication::processEvents();
}

QToolButton *StabilityFixture::plane(int index) const
{
    return panel.findChildren<QToolButton *>("tab").at(index);
}

QColor colourAt(QWidget &widget, QPointF place)
{
    const QImage image = widget.grab().toImage();
    return image.pixelColor((place * image.devicePixelRatio()).toPoint());
}

bool isNear(const QColor &a, const QColor &b)
{
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) < 30;
}
