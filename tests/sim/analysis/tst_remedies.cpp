// Remedies for a step beyond its stability limit, each checked by a run, and the growth map.

#include "tests/sim/support/stability_scenes.h"
#include "tests/sim/support/support.h"

#include "sim/analysis/stability/growth_map.h"
#include "sim/analysis/stability/remedies/remedies.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;
using namespace stability_scenes;

namespace {

/// Returns a script with a creature at rest. Its parameters are k and damp.
Script creatureScript(int feet, const char *method, double k, double damp, double h)
{
    Script script;
    script.build = [feet](const Values &values) { return creature(feet, values["k"], values["damp"]).scene; };
    script.values.set("k", k);
    script.values.set("damp", damp);
    script.method = findMethod(method);
    script.step = StepSize::ofLength(h);
    return script;
}

struct Request
{
    Script script;
    Scene scene = sceneOf(script, script.values);
    Stability now = stabilityOf(scene, scene.start, *script.method, script.step.h);

    explicit Request(Script given) : script(std::move(given)) {}
    std::vector<Remedy> remedies(const DampRange *damp) const
    {
        return remediesFor(script, script.values, scene.start, now, damp);
    }
};

const DampRange damping = {"damp", 0.0, 0.01};

}

class TestRemedies : public QObject
{
    Q_OBJECT

private slots:
    void remediesStabiliseAGrowingRun_data();
    void remediesStabiliseAGrowingRun();
    void suggestedStepIsTheLargestSafeOne();
    void suggestedDampingIsTheWeakestStableOne();
    void safeStepGetsNoRemedy();
    void noStepIsSuggestedIfNoneIsStable();
    void noDampingIsSuggestedWithoutAParameter();
    void growthMapAgreesWithRuns_data();
    void growthMapAgreesWithRuns();
    void growthMapCanBeCancelled();
};

void TestRemedies::remediesStabiliseAGrowingRun_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("k");
    QTest::addColumn<double>("damp");
    QTest::addRow("explicit Euler") << "explicit_euler" << 0.2 << 0.9;
    QTest::addRow("semi-implicit Euler") << "semi_implicit_euler" << 2.5 << 0.9;
    QTest::addRow("published") << "published" << 0.3 << 0.9;
    QTest::addRow("midpoint") << "midpoint" << 0.5 << 0.95;
    QTest::addRow("Runge-Kutta 4") << "rk4" << 4.0 << 0.9;
}

void TestRemedies::remediesStabiliseAGrowingRun()
{
    QFETCH(QString, method);
    QFETCH(double, k);
    QFETCH(double, damp);
    const int feet = 3;
    const Request request(creatureScript(feet, qPrintable(method), k, damp, 1.0));
    QVERIFY(grows(creature(feet, k, damp), method.toStdString(), 1.0));
    const std::vector<Remedy> remedies = request.remedies(&damping);
    QVERIFY(findRemedy(remedies, Remedy::Kind::smallerStep));
    QVERIFY(findRemedy(remedies, Remedy::Kind::unlimitedMethod));
    for (const Remedy &remedy : remedies) {
        const bool isDamping = remedy.kind == Remedy::Kind::moreDamping;
        const OscillatingScene changed = creature(feet, k, isDamping ? remedy.value : damp);
        QVERIFY2(!grows(changed, remedy.method->id(), remedy.step.h, 4000),
                 qPrintable(QString::fromStdString(remedy.method->id())));
        QVERIFY(remedy.share <= (isDamping ? marginalShare : safeShare));
    }
}

void TestRemedies::suggestedStepIsTheLargestSafeOne()
{
    const Request request(creatureScript(5, "explicit_euler", 0.2, 0.85, 1.0));
    const std::vector<Remedy> remedies = request.remedies(&damping);
    const Remedy *step = findRemedy(remedies, Remedy::Kind::smallerStep);
    QVERIFY(step);
    QVERIFY(step->step.h <= safeShare * request.now.limit);
    QVERIFY(2.0 * step->step.h > safeShare * request.now.limit);
}

void TestRemedies::suggestedDampingIsTheWeakestStableOne()
{
    const Request request(creatureScript(3, "published", 0.3, 0.9, 1.0));
    const std::vector<Remedy> remedies = request.remedies(&damping);
    const Remedy *damp = findRemedy(remedies, Remedy::Kind::moreDamping);
    QVERIFY(damp);
    const auto shareAt = [&](double value) {
        return predicted(creature(3, 0.3, value).scene, "published").share();
    };
    QVERIFY(damp->value < 0.9);
    QVERIFY(shareAt(damp->value) <= marginalShare);
    QVERIFY(shareAt(damp->value + 0.01) > marginalShare);
}

void TestRemedies::safeStepGetsNoRemedy()
{
    const Request request(creatureScript(5, "semi_implicit_euler", 0.2, 0.85, 1.0));
    QVERIFY(request.now.share() < safeShare);
    QVERIFY(request.remedies(&damping).empty());
}

void TestRemedies::noStepIsSuggestedIfNoneIsStable()
{
    const Request request(creatureScript(3, "explicit_euler", 0.2, 1.0, 1.0));
    const std::vector<Remedy> remedies = request.remedies(&damping);
    QVERIFY(!findRemedy(remedies, Remedy::Kind::smallerStep));
    const Remedy *other = findRemedy(remedies, Remedy::Kind::stableMethod);
    QVERIFY(other);
    QCOMPARE(other->method->evaluationsPerStep(), 1);
    QVERIFY(other->method->requirements().empty());
}

void TestRemedies::noDampingIsSuggestedWithoutAParameter()
{
    const Request request(creatureScript(3, "published", 0.3, 0.9, 1.0));
    QVERIFY(findRemedy(request.remedies(&damping), Remedy::Kind::moreDamping));
    QVERIFY(!findRemedy(request.remedies(nullptr), Remedy::Kind::moreDamping));
}

void TestRemedies::growthMapAgreesWithRuns_data()
{
    QTest::addColumn<QString>("method");
    for (const char *method : {"published", "semi_implicit_euler", "explicit_euler"})
        QTest::addRow("%s", method) << QString(method);
}

void TestRemedies::growthMapAgreesWithRuns()
{
    QFETCH(QString, method);
    const Script script = creatureScript(2, qPrintable(method), 0.2, 0.9, 1.0);
    const Scene scene = sceneOf(script, script.values);
    const auto check = [&](const MapAxis &y) {
        const GrowthMap map =
            growthMap(script, script.values, scene.start, MapAxis::evenly("k", 0.05, 3.0, 7), y,
                      [](const GrowthMap &) { return true; });
        QCOMPARE(map.growth.size(), std::size_t(7 * 5));
        int growingCells = 0;
        for (std::size_t row = 0; row < map.y.values.size(); ++row) {
            for (std::size_t column = 0; column < map.x.values.size(); ++column) {
                const double value = map.y.values[row];
                const bool isStep = map.y.parameter.empty();
                const OscillatingScene changed = creature(2, map.x.values[column], isStep ? 0.9 : value);
                const bool found = grows(changed, method.toStdString(), isStep ? value : 1.0, 4000);
                QCOMPARE(map.at(column, row) > 1.0, found);
                growingCells += found;
            }
        }
        QVERIFY(growingCells > 0 && growingCells < 35);
    };
    check(MapAxis::byRatio({}, 0.1, 2.0, 5));
    check(MapAxis::evenly("damp", 0.3, 0.99, 5));
}

void TestRemedies::growthMapCanBeCancelled()
{
    const Script script = creatureScript(2, "published", 0.2, 0.9, 1.0);
    const Scene scene = sceneOf(script, script.values);
    int rows = 0;
    const GrowthMap map =
        growthMap(script, script.values, scene.start, MapAxis::evenly("k", 0.1, 1.0, 4),
                  MapAxis::byRatio({}, 0.1, 1.0, 5), [&](const GrowthMap &) { return ++rows < 2; });
    QCOMPARE(map.growth.size(), std::size_t(2 * 4));
}

SUITE(tst_remedies, TestRemedies)
#include "tst_remedies.moc"
