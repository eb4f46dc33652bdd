// Forces that learners write, against closed forms and against the compiled effects.

#include "app/listing/limits.h"
#include "app/listing/rule_program.h"
#include "sim/analysis/energy/ledger.h"
#include "sim/base/error.h"
#include "sim/effects/drivers/gait_clock.h"
#include "sim/effects/rules/rule_force.h"
#include "sim/effects/springs/springs.h"
#include "sim/methods/methods.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"
#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <thread>

using sim::Account;
using sim::Vec2;

namespace {

std::shared_ptr<const sim::Rule> ruleOf(const std::string &text)
{
    const listing::CompiledRule compiled = listing::compileRule(text);
    if (!compiled.rule)
        qFatal("%s", compiled.errors.front().sentence.c_str());
    return compiled.rule;
}

std::string forceOf(const std::string &expression)
{
    return "Vec2 force(Body me)\n{\n    return " + expression + ";\n}\n";
}

/// A nail at (270, 180), and free bodies.
sim::Blueprint planOf(const std::vector<sim::BlueprintPoint> &free, const std::string &rule = {},
                      const std::vector<sim::BlueprintRuleLink> &links = {})
{
    sim::Blueprint plan;
    plan.points = {{.name = "nail", .x = {270, 180}, .v = {}, .fixed = true}};
    plan.points.insert(plan.points.end(), free.begin(), free.end());
    if (!rule.empty())
        plan.rule = {ruleOf(rule)};
    plan.ruleLinks = links;
    return plan;
}

sim::Scene sceneOf(const sim::Blueprint &plan, const sim::Values &values = {})
{
    const int count = static_cast<int>(plan.points.size());
    sim::Scene scene;
    scene.start = sim::State::ofPoints(count);
    scene.groups = {{"points", {0, count}}};
    for (int i = 0; i < count; ++i) {
        const sim::BlueprintPoint &point = plan.points[static_cast<std::size_t>(i)];
        scene.names.push_back(point.name);
        scene.start.place(i, point.x);
        scene.start.setVelocity(i, point.v);
        scene.start.inverseMass[i] = point.fixed ? 0.0 : 1.0 / point.mass;
    }
    std::vector<sim::Spring> springs;
    for (const sim::BlueprintSpring &spring : plan.springs)
        springs.push_back({spring.a, spring.b, spring.k, spring.length});
    if (!springs.empty())
        scene.effects.push_back(std::make_shared<sim::Springs>(springs, count));
    if (plan.rule)
        scene.effects.push_back(sim::ruleForceOf(plan, values));
    if (sim::hasRuleClock(plan)) {
        scene.start.gait.setZero(sim::clockCount(plan));
        scene.start.gaitSpeed.setZero(sim::clockCount(plan));
        scene.start.gaitSpeed[sim::ruleClockOf(plan)] = 1.0;
        scene.effects.push_back(std::make_shared<sim::GaitClock>());
    }
    return scene;
}

sim::Script scriptOf(const sim::Blueprint &plan, const std::string &method, double h = 1.0)
{
    sim::Script script;
    script.build = [plan](const sim::Values &values) { return sceneOf(plan, values); };
    script.method = sim::findMethod(method);
    script.step = script.method->stepping() == sim::Stepping::adaptive ? sim::StepSize::withTolerance(h)
                                                                       : sim::StepSize::ofLength(h);
    return script;
}

sim::State stateAfterFrames(const sim::Script &script, std::int64_t frameCount)
{
    sim::Track track(script, std::size_t{1} << 20);
    track.seek({frameCount, 0});
    return track.state();
}

double largestDifference(const sim::State &a, const sim::State &b)
{
    return (a.position - b.position).abs().maxCoeff();
}

sim::Balance balanceOf(const sim::Script &script, std::int64_t frameCount)
{
    sim::Track track(script, std::size_t{1} << 20);
    sim::Ledger ledger;
    sim::Balance balance;
    for (std::int64_t frame = 1; frame <= frameCount; ++frame) {
        track.seek({frame, 0});
        const sim::Balance row = *ledger.balanceAt(track, frame);
        if (frame == 1)
            balance = row;
        else
            balance.append(row);
    }
    return balance;
}

const std::string planet = "Vec2 pull(Body me, Body other)\n"
                           "{\n"
                           "    Vec2 to = other.position - me.position;\n"
                           "    return 900 * me.mass / pow(length(to), 3) * to;\n"
                           "}\n";
const std::string springRule = "Vec2 pull(Body me, Body other)\n"
                               "{\n"
                               "    Vec2 to = other.position - me.position;\n"
                               "    double far = length(to);\n"
                               "    return 0.2 * (far - 60) / far * to;\n"
                               "}\n";

const std::vector<sim::BlueprintPoint> chain = {{.name = "p1", .x = {350, 190}, .v = {0.5, 0}, .mass = 2.0},
                                                {.name = "p2", .x = {420, 240}, .v = {0, -1}},
                                                {.name = "p3", .x = {400, 320}, .v = {}, .mass = 0.5}};
const std::vector<sim::BlueprintRuleLink> chainLinks = {{0, 1}, {1, 2}, {2, 3}};

}

class RuleSuite : public QObject
{
    Q_OBJECT

private slots:
    /// The ellipse of Kepler with the planet at its far end: semi-axis a, and the period 2 pi sqrt(a^3 / mu).
    void planetByARuleFollowsKepler_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("h");
        QTest::addColumn<double>("tolerance");
        QTest::newRow("rk4") << "rk4" << 0.25 << 1e-4;
        QTest::newRow("dop853") << "dop853" << 1e-10 << 1e-6;
        QTest::newRow("dormand_prince") << "dormand_prince" << 1e-9 << 1e-4;
        QTest::newRow("rkn86") << "rkn86" << 1e-10 << 1e-6;
    }
    void planetByARuleFollowsKepler()
    {
        QFETCH(QString, method);
        QFETCH(double, h);
        QFETCH(double, tolerance);
        constexpr double mu = 900.0, far = 120.0, semiAxis = 100.0, eccentricity = 0.2;
        const double speed = std::sqrt(mu * (2.0 / far - 1.0 / semiAxis));
        const sim::Script script =
            scriptOf(planOf({{.name = "planet", .x = {270 + far, 180}, .v = {0, speed}}}, planet, {{0, 1}}),
                     method.toStdString(), h);
        constexpr int orbitFrames = 500;
        const sim::State state = stateAfterFrames(script, orbitFrames);
        // Kepler's equation, from the far end: M = E + e sin E.
        const double mean = orbitFrames * std::sqrt(mu / (semiAxis * semiAxis * semiAxis));
        double angle = mean;
        for (int i = 0; i < 100; ++i)
            angle = mean - eccentricity * std::sin(angle);
        const Vec2 wanted = {270 + semiAxis * (std::cos(angle) + eccentricity),
                             180 + semiAxis * std::sqrt(1 - eccentricity * eccentricity) * std::sin(angle)};
        const double off = sim::length(state.positionOf(1) - wanted);
        QVERIFY2(off < tolerance, qPrintable(QString::number(off)));
    }

    /// The Jacobian by differences leads Newton's method to the same solution.
    void springByARuleMovesAsTheCompiledSpring_data()
    {
        QTest::addColumn<QString>("method");
        for (const sim::MethodPtr &method : sim::allMethods())
            QTest::newRow(method->id().c_str()) << QString::fromStdString(method->id());
    }
    void springByARuleMovesAsTheCompiledSpring()
    {
        QFETCH(QString, method);
        sim::Blueprint compiled = planOf(chain);
        compiled.springs = {{0, 1, 0.2, 60}, {1, 2, 0.2, 60}, {2, 3, 0.2, 60}};
        const bool isAdaptive = sim::findMethod(method.toStdString())->stepping() == sim::Stepping::adaptive;
        const double h = isAdaptive ? 1e-11 : 0.5;
        const sim::State one = stateAfterFrames(scriptOf(compiled, method.toStdString(), h), 60);
        const sim::State other =
            stateAfterFrames(scriptOf(planOf(chain, springRule, chainLinks), method.toStdString(), h), 60);
        const double off = largestDifference(one, other);
        QVERIFY2(off < (isAdaptive ? 1e-8 : 1e-9), qPrintable(QString::number(off)));
    }

    void jacobianByDifferencesAgreesWithTheCompiledOne()
    {
        sim::Blueprint compiled = planOf(chain);
        compiled.springs = {{0, 1, 0.2, 60}, {1, 2, 0.2, 60}, {2, 3, 0.2, 60}};
        const auto matrixOf = [](const sim::Scene &scene) {
            sim::Jacobian jacobian(4);
            sim::as<sim::Force>(scene.effects.front())
                ->addJacobian(scene.start, {0, 4}, 1.0, sim::DirectionRule::regularised, jacobian);
            Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(8, 8);
            for (const sim::Jacobian::Entry &entry : jacobian.entries())
                matrix(entry.row, entry.column) += entry.value;
            return matrix;
        };
        const Eigen::MatrixXd exact = matrixOf(sceneOf(compiled));
        const Eigen::MatrixXd found = matrixOf(sceneOf(planOf(chain, springRule, chainLinks)));
        QVERIFY(exact.cwiseAbs().maxCoeff() > 0.1);
        QVERIFY((exact - found).cwiseAbs().maxCoeff() < 1e-8);
    }

    /// Halving the step divides the error by 2^order, also for a force that reads the velocity and the time.
    void methodsKeepTheirOrder_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("order");
        QTest::newRow("semi_implicit_euler") << "semi_implicit_euler" << 1.0;
        QTest::newRow("explicit_euler") << "explicit_euler" << 1.0;
        QTest::newRow("midpoint") << "midpoint" << 2.0;
        QTest::newRow("rk4") << "rk4" << 4.0;
        QTest::newRow("backward_euler") << "backward_euler" << 1.0;
        QTest::newRow("implicit_midpoint") << "implicit_midpoint" << 2.0;
        QTest::newRow("tr_bdf2") << "tr_bdf2" << 2.0;
    }
    void methodsKeepTheirOrder()
    {
        QFETCH(QString, method);
        QFETCH(double, order);
        const sim::Blueprint plan =
            planOf({{.name = "p1", .x = {330, 190}, .v = {1, 2}}},
                   forceOf("0.02 * (bodies[0].position - me.position) - 0.01 * length(me.velocity) * "
                           "me.velocity + Vec2(0.3 * sin(0.2 * time), 0)"));
        const sim::State exact = stateAfterFrames(scriptOf(plan, "dop853", 1e-12), 16);
        const auto errorOf = [&](double h) {
            return largestDifference(exact, stateAfterFrames(scriptOf(plan, method.toStdString(), h), 16));
        };
        const double found = std::log2(errorOf(0.25) / errorOf(0.125));
        QVERIFY2(std::abs(found - order) < 0.25, qPrintable(QString::number(found)));
    }

    void methodWithoutVelocitiesRejectsARuleThatReadsThem()
    {
        const sim::Script script = scriptOf(
            planOf({{.name = "p1", .x = {}, .v = {}}}, forceOf("-0.1 * me.velocity")), "rkn86", 1e-6);
        try {
            sim::Track::check(script);
            QFAIL("accepted");
        } catch (const sim::Error &error) {
            QCOMPARE(error.id(), std::string("method-does-not-fit"));
            QCOMPARE(error.values().at("effect"), std::string("rule"));
        }
    }

    /// The rule has no potential, so its work is the change of the kinetic energy.
    void workOfTheRuleIsTheChangeOfTheRest_data()
    {
        QTest::addColumn<QString>("method");
        for (const char *method : {"published", "semi_implicit_euler", "velocity_verlet", "rk4", "dop853",
                                   "backward_euler", "implicit_midpoint"})
            QTest::newRow(method) << QString(method);
    }
    void workOfTheRuleIsTheChangeOfTheRest()
    {
        QFETCH(QString, method);
        const bool isWhole = method == "backward_euler" || method == "implicit_midpoint";
        const sim::Balance balance = balanceOf(
            scriptOf(planOf({{.name = "p1", .x = {370, 180}, .v = {0, 3}, .mass = 2}}, planet, {{0, 1}}),
                     method.toStdString(), method == "dop853" ? 1e-9 : 0.125),
            80);
        const double change = balance.after.total() - balance.before.total();
        const Vec2 gained = balance.after.momentum - balance.before.momentum;
        QVERIFY(sim::length(gained) > 1.0);
        const double work = balance.energy[Account::rule];
        const double tolerance = isWhole ? 0.2 : 1e-5;
        QVERIFY2(std::abs(work - change) < tolerance, qPrintable(QString("%1 %2").arg(work).arg(change)));
        QVERIFY(sim::length(balance.momentum[Account::rule] - gained) < (isWhole ? 0.1 : 1e-5));
    }

    void eachEndOfALinkFeelsItsOwnPull()
    {
        const sim::Blueprint plan = planOf(
            {{.name = "p1", .x = {300, 180}, .v = {}}, {.name = "p2", .x = {340, 180}, .v = {}, .mass = 4}},
            "Vec2 pull(Body me, Body other)\n{\n    return Vec2(me.mass, other.mass);\n}\n",
            {{1, 2}, {0, 1}});
        const sim::Scene scene = sceneOf(plan);
        Eigen::ArrayX2d sum = Eigen::ArrayX2d::Zero(3, 2);
        sim::as<sim::Force>(scene.effects.front())
            ->add(scene.start, {0, 3}, 1.0, sim::DirectionRule::regularised, sum);
        QCOMPARE(sum(0, 0), 0.0); // a nail
        QCOMPARE(sum(1, 0), 2.0); // from both links
        QCOMPARE(sum(1, 1), 4.0); // the mass of a nail is 0
        QCOMPARE(sum(2, 0), 1.0); // 4 / 4
        QCOMPARE(sum(2, 1), 0.25);
    }

    void rulesWithTheSameTextAreEqual()
    {
        QVERIFY(planOf({}, planet) == planOf({}, planet));
        QVERIFY(!(planOf({}, planet) == planOf({}, springRule)));
        QVERIFY(!(planOf({}, planet) == planOf({})));
    }

    void dependenceFollowsFromTheNames_data()
    {
        QTest::addColumn<QString>("expression");
        QTest::addColumn<int>("dependence");
        const auto row = [](const char *expression, sim::Dependence dependence) {
            QTest::newRow(expression) << QString(expression) << static_cast<int>(dependence);
        };
        row("me.position", sim::Dependence::coupledPoints);
        row("bodies[0].position", sim::Dependence::scene);
        row("pointer", sim::Dependence::scene);
        row("Vec2(time, 0)", sim::Dependence::scene);
        row("Vec2(random(1), frame_number)", sim::Dependence::time);
    }
    void dependenceFollowsFromTheNames()
    {
        QFETCH(QString, expression);
        QFETCH(int, dependence);
        const sim::Scene scene = sceneOf(planOf({}, forceOf(expression.toStdString())));
        QCOMPARE(static_cast<int>(scene.effects.front()->dependence()), dependence);
    }

    void parametersReachTheRule()
    {
        sim::Values values;
        values.set("gravity", 0.25);
        const sim::Blueprint plan =
            planOf({{.name = "p1", .x = {}, .v = {}}}, forceOf("Vec2(0, -gravity) * me.mass"));
        const sim::Scene scene = sceneOf(plan, values);
        Eigen::ArrayX2d sum = Eigen::ArrayX2d::Zero(2, 2);
        sim::as<sim::Force>(scene.effects.front())
            ->add(scene.start, {0, 2}, 1.0, sim::DirectionRule::regularised, sum);
        QCOMPARE(sum(1, 1), -0.25);
    }

    void mistakesInTheTextNameTheirLine_data()
    {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("line");
        QTest::addColumn<QString>("words");
        QTest::newRow("empty") << "" << 1 << "needs the function 'Vec2 force(Body me)'";
        QTest::newRow("no function") << "double f() { return 1; }" << 1 << "needs the function";
        QTest::newRow("form") << "\nvoid force(Body me) { }" << 2 << "has the form 'Vec2 force(Body me)'";
        QTest::newRow("form of pull") << "Vec2 pull(Body me) { return Vec2(); }" << 1
                                      << "has the form 'Vec2 pull(Body me, Body other)'";
        QTest::newRow("global") << "double sum = 0;\nVec2 force(Body me) { return Vec2(); }" << 1
                                << "A rule remembers nothing";
        QTest::newRow("name") << "Vec2 force(Body me)\n{\n    return me.velocty;\n}" << 3 << "velocity";
        QTest::newRow("change") << "Vec2 force(Body me)\n{\n    me.position.x = 3;\n    return Vec2();\n}"
                                << 3 << "";
    }
    void mistakesInTheTextNameTheirLine()
    {
        QFETCH(QString, text);
        QFETCH(int, line);
        QFETCH(QString, words);
        const listing::CompiledRule compiled = listing::compileRule(text.toStdString());
        QVERIFY(!compiled.rule);
        QCOMPARE(compiled.errors.front().line, line);
        const QString sentence = QString::fromStdString(compiled.errors.front().sentence);
        QVERIFY2(sentence.contains(words), qPrintable(sentence));
    }

    void mistakesInARunNameTheirLine_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("lines");
        QTest::addColumn<int>("kind");
        QTest::addColumn<int>("line");
        using Kind = listing::RunErrorKind;
        for (const sim::MethodPtr &method : sim::allMethods()) {
            const QString id = QString::fromStdString(method->id());
            const auto row = [&](const char *name, const char *lines, Kind kind, int line) {
                QTest::newRow(qPrintable(id + ", " + name))
                    << id << QString(lines) << static_cast<int>(kind) << line;
            };
            row("no such body", "Body one = bodies[7];\nreturn one.position;", Kind::noSuchBody, 3);
            row("division", "double none = 0 * me.mass;\nreturn 1 / none * Vec2(1, 1);", Kind::divisionByZero,
                4);
            row("variable", "double k = sqrt(-me.mass);\nreturn k * Vec2(1, 1);", Kind::notFinite, 3);
            row("force", "double k = 2;\nreturn sqrt(-k) * Vec2(1, 1);", Kind::notFinite, 4);
            row("endless", "double x = 0;\nwhile (true)\n    x += 1;\nreturn Vec2();", Kind::endlessLoop, 4);
        }
    }
    void mistakesInARunNameTheirLine()
    {
        QFETCH(QString, method);
        QFETCH(QString, lines);
        QFETCH(int, kind);
        QFETCH(int, line);
        // Only to the right of x = 300, so that the run begins well.
        const std::string text = "Vec2 force(Body me)\n{ if (me.position.x < 300) return Vec2();\n" +
                                 lines.toStdString() + "\n}\n";
        const sim::Script script = scriptOf(
            planOf({{.name = "p1", .x = {290, 180}, .v = {1.5, 0}}}, text), method.toStdString(),
            sim::findMethod(method.toStdString())->stepping() == sim::Stepping::adaptive ? 1e-3 : 1.0);
        sim::Track track(script, std::size_t{1} << 20);
        track.seek({40, 0});
        QVERIFY(track.stop());
        const std::int64_t frame = track.stop()->frame;
        QVERIFY2(frame >= 5 && frame <= 8, qPrintable(QString::number(frame)));
        const auto interval = track.intervalAt(frame + 1);
        const sim::State state = track.stateAfterInput(track.stateAt(frame), frame);
        const std::optional<listing::RuleError> found =
            listing::ruleErrorIn(interval->scene, *script.method, interval->pipeline.step, state);
        QVERIFY(found);
        QCOMPARE(found->me, 1);
        QCOMPARE(static_cast<int>(found->error.kind), kind);
        QCOMPARE(found->error.line, line);
        QVERIFY(!found->error.sentence.empty());
    }

    void threadsEvaluateARuleAtTheSameTime()
    {
        const sim::Script script = scriptOf(planOf(chain, springRule, chainLinks), "rk4", 0.5);
        const sim::State alone = stateAfterFrames(script, 50);
        std::vector<sim::State> states(8);
        std::vector<std::thread> threads;
        for (sim::State &state : states)
            threads.emplace_back([&state, &script] { state = stateAfterFrames(script, 50); });
        for (std::thread &thread : threads)
            thread.join();
        for (const sim::State &state : states)
            QVERIFY(sim::sameBits(state, alone));
    }
};

SUITE(tst_rule, RuleSuite)
#include "tst_rule.moc"
