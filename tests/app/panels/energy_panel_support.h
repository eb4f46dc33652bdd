#pragma once

#include "app/ui/energy/energy_panel.h"
#include "app/ui/energy/energy_plot.h"
#include "tests/app/support/panel_fixture.h"

#include <QtTest>

#include <map>

/// Shared by the suites of the panel of energy.
namespace energy_panel_support {

using namespace app;
using namespace tests;

/// Returns two lessons, with a further step whose foot has no velocity of its own.
inline LessonLibrary withPuppet()
{
    LessonLibrary library = twoLessons();
    lessons::Step puppet = puppetOf(library.lessons.front().steps.front());
    puppet.tries.clear();
    library.lessons.front().steps.push_back(puppet);
    return library;
}

/// A foot that starts at rest, 30 px to the right of and 10 px below the place to which a spring with k = 0.2 pulls it;
/// the body stands.
struct EnergyFixture : PanelFixture<EnergyPanel>
{
    EnergyFixture() : PanelFixture(withPuppet(), {660, 300}) { session.openStep("one", "second"); }

    /// Goes to a frame and waits until its energy is known.
    void goTo(std::int64_t frame)
    {
        session.playback().goTo({frame, 0});
        QVERIFY(QTest::qWaitFor([&] { return panel.series().last() >= frame; }));
    }
    const EnergyLine *line(const QString &id) const
    {
        for (const EnergyLine &one : panel.lines()) {
            if (one.id == id)
                return &one;
        }
        return nullptr;
    }
    std::int64_t frame() { return session.timeline().cursor().frame; }
    QPoint placeOf(std::int64_t frame)
    {
        EnergyPlot &plot = panel.plot();
        return {qRound(plot.xAxis->coordToPixel(static_cast<double>(frame))), plot.height() / 2};
    }
    void hover(QPoint place, Qt::MouseButtons buttons = {}) { moveMouse(panel.plot(), place, buttons); }
    /// Returns the rows of a table, by the names of its columns without their units.
    static std::vector<std::map<QString, double>> readTable(const QString &path)
    {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            return {};
        const QStringList lines = QString::fromUtf8(file.readAll()).trimmed().split('\n');
        QStringList titles;
        for (const QString &field : lines.front().split(','))
            titles << field.section('"', 1, 1).section(" [", 0, 0);
        std::vector<std::map<QString, double>> rows;
        for (const QString &line : lines.mid(1)) {
            const QStringList fields = line.split(',');
            rows.emplace_back();
            for (int i = 0; i < titles.size() && i < fields.size(); ++i)
                rows.back()[titles[i]] = fields[i].toDouble();
        }
        return rows;
    }
    /// Returns the amount of an account; 0 without a line, because the account is still empty.
    double amount(const QString &id) const { return line(id) ? line(id)->amount : 0.0; }
};

inline constexpr double atStart = 0.5 * 0.2 * (30.0 * 30.0 + 10.0 * 10.0);

inline double springEnergy(const sim::State &state)
{
    const sim::Vec2 d = state.positionOf(0) - sim::Vec2{270.0, 200.0};
    return 0.5 * 0.2 * (d.x * d.x + d.y * d.y);
}

inline double motionEnergy(const sim::State &state)
{
    double sum = 0.0;
    for (int i = 0; i < state.pointCount(); ++i)
        sum += 0.5 * (state.velocityOf(i).x * state.velocityOf(i).x +
                      state.velocityOf(i).y * state.velocityOf(i).y);
    return sum;
}

}
