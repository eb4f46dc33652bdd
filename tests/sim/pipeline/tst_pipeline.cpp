// How a scene and a method are composed into the phases of a frame.

#include "sim/pipeline/pipeline.h"
#include "sim/run/finite.h"
#include "tests/sim/support/support.h"

#include "sim/base/error.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/offset_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>

#include <limits>

using namespace sim;

namespace {

constexpr int feet = 2;

/// Returns seven different effects.
std::vector<EffectPtr> oneOfEach()
{
    return {
        std::make_shared<PointSpring>(feet, Vec2{250, 150}, 0.1),
        std::make_shared<BodySpring>(std::vector<Link>{{0, 1}}, 0.1),
        std::make_shared<OffsetSpring>(std::vector<Link>{{1, feet}}, 0.1, 50.0),
        std::make_shared<RadialSpring>(scenes::legs(feet), 0.2, 50.0),
        std::make_shared<Gravity>(0.5),
        std::make_shared<Damping>(0.85),
        std::make_shared<Walls>(Room{20, 520, 380, 0.5}, Eigen::ArrayXd::Constant(feet + 1, 5.0)),
    };
}

/// An effect that no method can compute.
class UnknownEffect : public Effect
{
public:
    Role role() const override { return {}; }
    std::string id() const override { return "foreign"; }
    std::string title() const override { return "foreign"; }
    EffectKind kind() const override { return EffectKind::wind; }
    std::vector<Region> regions(DirectionRule) const override { return {}; }
    int count(const State &, PointRange points) const override { return points.count; }
};

/// Returns the ids of the phases, each followed by its inner effects in brackets.
std::string phaseIds(const Scene &scene, const std::string &method)
{
    std::string all;
    for (const Phase &phase : compose(scene, *findMethod(method), StepSize::ofLength(1.0)).phases) {
        all += all.empty() ? "" : " ";
        all += phase.id + (phase.group < 0 ? "" : ":" + scene.groups[std::size_t(phase.group)].title);
        for (const EffectPtr &effect : phase.innerEffects)
            all += " (" + effect->id() + ")";
    }
    return all;
}

/// Returns the effects that the phases of a step compute.
std::vector<EffectPtr> computedEffects(const Scene &scene, const Method &method)
{
    std::vector<EffectPtr> all;
    for (const Phase &phase : compose(scene, method, support::stepFor(method, 1.0)).phases) {
        all.push_back(phase.effect);
        all.insert(all.end(), phase.innerEffects.begin(), phase.innerEffects.end());
    }
    return all;
}

Scene roomScene()
{
    Scene scene = scenes::creature(feet);
    scene.effects = {oneOfEach()[3], oneOfEach()[4], oneOfEach()[5], oneOfEach()[6]};
    return scene;
}

template <class Call>
std::string errorOf(Call &&call)
{
    try {
        call();
    } catch (const Error &error) {
        return error.id() + " " + (error.values().contains("effect") ? error.values().at("effect") : "");
    }
    return {};
}

}

class TestPipeline : public QObject
{
    Q_OBJECT

private slots:
    void publishedMovesOneGroupAfterTheOther()
    {
        QCOMPARE(phaseIds(roomScene(), "published"),
                 std::string("radial_spring:feet gravity:feet damping:feet move:feet walls:feet "
                             "radial_spring:body gravity:body damping:body move:body walls:body"));
    }

    void semiImplicitMovesAllAtOnce()
    {
        QCOMPARE(phaseIds(roomScene(), "semi_implicit_euler"),
                 std::string("radial_spring gravity kick damping move walls"));
    }

    void effectsThatAreNotListedMakeNoPhase()
    {
        Scene scene = roomScene();
        scene.effects.erase(scene.effects.begin() + 1); // gravity
        for (const char *method : {"published", "semi_implicit_euler"})
            QVERIFY(phaseIds(scene, method).find("gravity") == std::string::npos);
        scene.effects.clear();
        QCOMPARE(phaseIds(scene, "published"), std::string("move:feet move:body"));
        QCOMPARE(phaseIds(scene, "semi_implicit_euler"), std::string("move"));
    }

    void effectsThatConcernOneGroupMakeOnePhase()
    {
        Scene scene = scenes::creature(feet);
        scene.effects = {std::make_shared<BodySpring>(std::vector<Link>{{0, 2}, {1, 2}}, 0.2)};
        QCOMPARE(phaseIds(scene, "published"), std::string("body_spring:feet move:feet move:body"));
    }

    void groupOfHandlesHasNoPhases()
    {
        Scene scene = scenes::creature(1);
        scene.start.inverseMass[1] = 0.0;
        scene.effects = {std::make_shared<Gravity>(0.5), std::make_shared<Damping>(0.9)};
        QCOMPARE(phaseIds(scene, "published"), std::string("gravity:feet damping:feet move:feet"));
    }

    void sceneWithoutDynamicPointsIsRefused()
    {
        Scene scene = scenes::creature(1);
        scene.start.inverseMass.setZero();
        scene.effects = {std::make_shared<Gravity>(0.5)};
        for (const MethodPtr &method : allMethods())
            QCOMPARE(errorOf([&] { compose(scene, *method, support::stepFor(*method, 1.0)); }),
                     std::string("nothing-moves "));
    }

    void unknownEffectIsRefusedByName()
    {
        Scene scene = roomScene();
        scene.effects.push_back(std::make_shared<UnknownEffect>());
        for (const MethodPtr &method : allMethods())
            QCOMPARE(errorOf([&] { compose(scene, *method, support::stepFor(*method, 1.0)); }),
                     std::string("method-does-not-fit foreign"));
    }

    void publishedNeedsAnUpdateOrder()
    {
        Scene scene = roomScene();
        scene.groups.clear();
        QCOMPARE(errorOf([&] { compose(scene, *findMethod("published"), StepSize::ofLength(1.0)); }),
                 std::string("method-does-not-fit radial_spring"));
        QVERIFY(errorOf([&] {
                    compose(scene, *findMethod("semi_implicit_euler"), StepSize::ofLength(1.0));
                }).empty());
    }

    void phasesAreComplete()
    {
        Scene scene = roomScene();
        scene.effects = oneOfEach();
        for (const MethodPtr &method : allMethods()) {
            for (const Phase &phase : compose(scene, *method, support::stepFor(*method, 1.0)).phases) {
                QVERIFY(!phase.id.empty() && !phase.title.empty() && !phase.regions.empty());
                QVERIFY(phase.points.count > 0 && !phase.kernels.empty() && phase.explain);
                QCOMPARE(phase.effect == nullptr, phase.kind == EffectKind::motion);
            }
        }
    }

    void stepsThatFillFramesAreAccepted_data()
    {
        QTest::addColumn<double>("h");
        QTest::addColumn<int>("stepsPerOutput");
        QTest::addColumn<int>("framesPerOutput");
        QTest::newRow("one frame") << 1.0 << 1 << 1;
        QTest::newRow("a quarter") << 0.25 << 4 << 1;
        QTest::newRow("a third") << 1.0 / 3 << 3 << 1;
        QTest::newRow("a third, rounded") << 0.3333333333333 << 3 << 1;
        QTest::newRow("a millionth") << 1e-6 << 1'000'000 << 1;
        QTest::newRow("two frames") << 2.0 << 1 << 2;
        QTest::newRow("a hundred frames") << 100.0 << 1 << 100;
        QTest::newRow("nearly one") << 1.0 - 1e-12 << 1 << 1;
    }
    void stepsThatFillFramesAreAccepted()
    {
        QFETCH(double, h);
        QFETCH(int, stepsPerOutput);
        QFETCH(int, framesPerOutput);
        const StepSize step = StepSize::ofLength(h);
        QCOMPARE(step.stepsPerOutput, stepsPerOutput);
        QCOMPARE(step.framesPerOutput, framesPerOutput);
        QCOMPARE(step.h, stepsPerOutput > 1 ? 1.0 / stepsPerOutput : double(framesPerOutput)); // exactly
    }

    void allUnitFractionsAreAccepted()
    {
        for (int n = 1; n <= 1'000'000; n += n < 1000 ? 1 : 997)
            QCOMPARE(StepSize::ofLength(1.0 / n).stepsPerOutput, n);
    }

    void otherStepsAreRefused_data()
    {
        QTest::addColumn<double>("h");
        for (const double h : {0.0, -1.0, 0.3, 0.4, 0.75, 1.5, 99.5, 101.0, 5e-7, 1e-300, 1e300})
            QTest::addRow("%g", h) << h;
        QTest::newRow("infinite") << std::numeric_limits<double>::infinity();
        QTest::newRow("not a number") << std::numeric_limits<double>::quiet_NaN();
    }
    void otherStepsAreRefused()
    {
        QFETCH(double, h);
        QCOMPARE(errorOf([&] { StepSize::ofLength(h); }), std::string("step-size "));
    }

    void refusedStepIsReportedAsGiven()
    {
        try {
            StepSize::ofLength(5e-7);
            QFAIL("accepted");
        } catch (const Error &error) {
            QCOMPARE(error.values().at("h"), std::string("5e-07"));
        }
    }

    void everySetOfEffectsRunsWithEveryMethod_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("h");
        for (const MethodPtr &method : allMethods()) {
            for (const double h : {0.25, 1.0, 2.0})
                QTest::addRow("%s, h = %g", method->id().c_str(), h)
                    << QString::fromStdString(method->id()) << h;
        }
    }
    void everySetOfEffectsRunsWithEveryMethod()
    {
        QFETCH(QString, method);
        QFETCH(double, h);
        const std::vector<EffectPtr> effects = oneOfEach();
        for (unsigned subset = 0; subset < 1u << effects.size(); ++subset) {
            Scene scene = scenes::creature(feet);
            support::scatter(scene.start, subset, 200.0);
            std::string expected;
            for (std::size_t i = 0; i < effects.size(); ++i) {
                if (subset >> i & 1u)
                    scene.effects.push_back(effects[i]);
            }
            const std::vector<EffectPtr> found = computedEffects(scene, *findMethod(method.toStdString()));
            for (std::size_t i = 0; i < effects.size(); ++i)
                QCOMPARE(std::count(found.begin(), found.end(), effects[i]) > 0, bool(subset >> i & 1u));
            const State end = support::plainRun(scene, method.toStdString(), h, 100);
            QCOMPARE(firstNonFinitePoint(end), -1);
        }
    }
};

SUITE(tst_pipeline, TestPipeline)
#include "tst_pipeline.moc"
