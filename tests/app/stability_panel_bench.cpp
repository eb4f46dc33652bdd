#include "stability_panel_bench.h"

#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>

using namespace app;

sim::Accuracy StabilityPanelBench::noStudy(const sim::Script &, const sim::StudyPlan &,
                                           const sim::StudyProgress &)
{
    return {};
}

StabilityPanelBench::StabilityPanelBench(const char *lesson, const char *step)
{
    theme.apply(*qApp);
    session.openStep(lesson, step);
    window.resize(1280, 800);
    window.show();
    QApplication::setActiveWindow(&window);
    settle();
}

void StabilityPanelBench::settle()
{
    if (!QTest::qWaitFor([&] { return window.stability().reading() && window.stability().isCurrent(); },
                         20'000))
        qFatal("no reading");
    QCoreApplication::processEvents();
}

void StabilityPanelBench::mapped()
{
    const auto whole = std::size_t(StabilityWatch::columns) * StabilityWatch::rows;
    if (!QTest::qWaitFor(
            [&] {
                const StabilityWatch &watch = window.stability();
                return !watch.isMapping() && watch.map() && watch.map()->growth.size() == whole;
            },
            60'000))
        qFatal("no map");
    QCoreApplication::processEvents();
}

QToolButton *StabilityPanelBench::plane(int index) const
{
    return panel.findChildren<QToolButton *>("tab").at(index);
}

void useOwnSettings()
{
    QStandardPaths::setTestModeEnabled(true);
    static const QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    QCoreApplication::setOrganizationName("springstep-tests");
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
