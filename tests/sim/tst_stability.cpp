// Where steps begin to fail: predicted from slopes, against closed forms and against runs.

#include "stability_bench.h"
#include "support.h"

#include "sim/effects/body_spring.h"
#include "sim/effects/damping.h"
#include "sim/effects/gravity.h"
#include "sim/effects/point_spring.h"
#include "sim/effects/radial_spring.h"
#include "sim/effects/torsion.h"
#include "sim/effects/walls.h"
#include "sim/methods/methods.h"
#include "sim/stability/krylov.h"

#include <Eigen/Eigenvalues>
#include <QTest>

#include <cmath>

using namespace sim;
using namespace stability_bench;
using std::make_shared;

namespace {

/// The smallest root of `f`, which is below 0 just above `from`: looked for in small steps, then halved.
double firstRoot(double from, const std::function<double(double)> &f)
{
    double low = from, high = from;
    while (f(high) < 0.0 && high < 1e3) {
        low = high;
        high *= 1.001;
    }
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (f(middle) < 0.0 ? low : high) = middle;
    }
    return low;
}

const std::vector<const char *> &explicitMethods()
{
    static const std::vector<const char *> all = {
        "explicit_euler", "semi_implicit_euler", "position_verlet", "velocity_verlet", "midpoint", "rk4",
        "published"};
    return all;
}

struct Named
{
    const char *name;
    Swinging swinging;
};

/// Body springs between bodies of several masses, of which one is slowed more than the others.
Swinging uneven()
{
    Swinging found = chain(4, 0.3, 0.95);
    found.scene.start.inverseMass << 1.0, 0.25, 2.0, 1.0;
    found.scene.effects.push_back(make_shared<Damping>(0.8, Points{1, 1}));
    return found;
}

/// More patterns of motion than are looked at exactly, and no two feet alike.
Swinging manyFeet()
{
    const int feet = 20;
    Swinging found = creature(feet, 0.2, 0.85);
    for (int i = 0; i < feet; ++i)
        found.scene.start.inverseMass[i] = 0.5 + 0.05 * i;
    return found;
}

/// A young tree whose joints are springs.
Swinging tree(double k, double damp)
{
    Tree grown = Tree::ofTrunk(100.0);
    grown.sprout(0, -120.0, 0.7);
    grown.sprout(0, -55.0, 0.8);
    grown.sprout(1, -150.0, 0.5);
    const auto shared = make_shared<const Tree>(grown);
    Scene scene;
    const int branches = grown.branches();
    scene.start = State::ofPoints(branches);
    scene.start.spin.setZero(branches);
    scene.start.angle.resize(branches);
    for (int i = 0; i < branches; ++i) {
        scene.start.angle[i] = grown.rest[std::size_t(i)];
        scene.names.push_back(std::string("branch").append(std::to_string(i)));
    }
    scene.groups = {{"branches", {0, branches}}};
    scene.effects = {make_shared<Torsion>(shared, limbsOf(grown, k)), make_shared<SpinDamping>(damp)};
    const Eigen::ArrayXd rest = scene.start.angle;
    return {scene, [rest](const State &state) {
                return state.spin.square().sum() + (state.angle - rest).square().sum();
            }};
}

/// A force that keeps its slopes to itself.
class Silent : public Force
{
public:
    explicit Silent(std::shared_ptr<const Force> inner) : m_inner(std::move(inner)) {}
    std::string id() const override { return "silent"; }
    std::string title() const override { return "silent"; }
    Kind kind() const override { return Kind::spring; }
    std::vector<Region> regions(Directions) const override { return {}; }
    int count(const State &state, Points points) const override { return m_inner->count(state, points); }
    void add(const State &state, Points movers, double scale, Directions way,
             Eigen::ArrayX2d &into) const override
    {
        m_inner->add(state, movers, scale, way, into);
    }
    std::vector<Live> explain(const State &, int, Directions) const override { return {}; }

private:
    std::shared_ptr<const Force> m_inner;
};

}

class TestStability : public QObject
{
    Q_OBJECT

private slots:
    void limitsAgreeWithClosedForms_data();
    void limitsAgreeWithClosedForms();
    void limitsAgreeWithTheMeasuredOnset_data();
    void limitsAgreeWithTheMeasuredOnset();
    void whatGrowsAtEveryStepHasTheLimitNought_data();
    void whatGrowsAtEveryStepHasTheLimitNought();
    void thePairThatPropelsItselfIsPastItsLimit();
    void manyFeetDriveTheirBodyByTheClosedForm_data();
    void manyFeetDriveTheirBodyByTheClosedForm();
    void strongDampingHoldsLongStepsAgain();
    void enoughDampingHoldsEveryStep();
    void everyMethodSaysWhatBoundsIt();
    void nothingSwingsWithoutSprings();
    void whatPushesApartIsNoFaultOfTheStep();
    void theStiffestSpringIsNamed();
    void aSpringToAPlaceIsNamed();
    void contactsAreNamedAsLeftOut();
    void forcesWithoutSlopesAreDifferenced();
    void aHeldBodyDoesNotSwing();
    void theLargestEigenvaluesOfALargeMatrixAreFound();
    void pullsThatAreNotFiniteAreSaid();
    void extremesHaveAnAnswer_data();
    void extremesHaveAnAnswer();
};

void TestStability::limitsAgreeWithClosedForms_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("k");
    QTest::addColumn<double>("damp");
    QTest::addColumn<double>("limit");
    for (const double k : {1e-4, 0.2, 1.0, 1e6}) {
        const auto row = [&](const char *method, double damp, double limit) {
            QTest::addRow("%s, k %g, damp %g", method, k, damp) << QString(method) << k << damp << limit;
        };
        // Hairer, Lubich and Wanner, I.1 and I.5: |trace| of the step is 2 at omega h = 2.
        for (const char *method : {"semi_implicit_euler", "position_verlet", "velocity_verlet", "published"})
            row(method, 1.0, 2.0 / std::sqrt(k));
        // Hairer and Wanner II, IV.2: the end of the stability region on the imaginary axis.
        row("rk4", 1.0, 2.0 * std::sqrt(2.0) / std::sqrt(k));
        row("explicit_euler", 1.0, 0.0);
        row("midpoint", 1.0, 0.0);
        // With damping a step's matrix has the determinant d = e^(-c h). It leaves the unit circle at -1, where its
        // trace is -(1 + d): 1 + d - d k h^2 for semi-implicit Euler, 1 + d - sqrt(d) k h^2 for both of Verlet's; and
        // explicit Euler's, d (1 + k h^2), where that is 1.
        const double damp = std::exp(-0.1 * std::sqrt(k)), c = -std::log(damp);
        const double from = 1e-6 / std::sqrt(k);
        const auto flip = [&](double power) {
            return firstRoot(from, [=](double h) {
                const double d = std::exp(-c * h);
                return std::pow(d, power) * k * h * h - 2.0 * (1.0 + d);
            });
        };
        row("semi_implicit_euler", damp, flip(1.0));
        row("published", damp, flip(1.0));
        row("position_verlet", damp, flip(0.5));
        row("velocity_verlet", damp, flip(0.5));
        row("explicit_euler", damp,
            firstRoot(from, [=](double h) { return std::exp(-c * h) * (1.0 + k * h * h) - 1.0; }));
    }
}

void TestStability::limitsAgreeWithClosedForms()
{
    QFETCH(QString, method);
    QFETCH(double, k);
    QFETCH(double, damp);
    QFETCH(double, limit);
    const Stability found = predicted(onePoint(k, damp).scene, method.toStdString());
    QCOMPARE(found.bound, Bound::stiffness);
    // Limits are halved down to 1e-4 of themselves.
    QVERIFY2(std::abs(found.limit - limit) <= 2e-4 * limit,
             qPrintable(QString("%1 in place of %2").arg(found.limit).arg(limit)));
    if (limit > 0.0) {
        QVERIFY(predicted(onePoint(k, damp).scene, method.toStdString(), 0.99 * limit).holds());
        QVERIFY(!predicted(onePoint(k, damp).scene, method.toStdString(), 1.01 * limit).holds());
    }
}

void TestStability::limitsAgreeWithTheMeasuredOnset_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<Swinging>("swinging");
    const std::vector<Named> scenes = {
        {"one damped point", onePoint(0.2, 0.9)}, {"chain", chain(5, 0.2, 1.0)},
        {"damped chain", chain(5, 0.2, 0.97)},    {"damped creature", creature(5, 0.2, 0.85)},
        {"creature", creature(4, 0.1, 1.0)},      {"damped bundle", bundle(7, 0.3, 0.9)},
        {"uneven masses and drags", uneven()},    {"damped tree", tree(0.05, 0.95)},
        {"soft pair", creature(1, 0.2, 0.9)},     {"twenty feet", manyFeet()},
    };
    for (const Named &one : scenes) {
        for (const char *method : explicitMethods()) {
            const Stability found = predicted(one.swinging.scene, method);
            if (found.limit > 0.0) // the others: see the next test
                QTest::addRow("%s, %s", one.name, method) << QString(method) << one.swinging;
        }
    }
}

void TestStability::limitsAgreeWithTheMeasuredOnset()
{
    QFETCH(QString, method);
    QFETCH(Swinging, swinging);
    const Stability found = predicted(swinging.scene, method.toStdString());
    const double measured = onset(swinging, method.toStdString(), 0.3 * found.limit);
    QVERIFY2(std::abs(found.limit - measured) <= 0.02 * measured,
             qPrintable(QString("%1 predicted, %2 measured").arg(found.limit).arg(measured)));
}

void TestStability::whatGrowsAtEveryStepHasTheLimitNought_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<Swinging>("swinging");
    for (const char *method : {"explicit_euler", "midpoint"}) {
        QTest::addRow("chain, %s", method) << QString(method) << chain(5, 0.2, 1.0);
        QTest::addRow("creature, %s", method) << QString(method) << creature(5, 0.2, 1.0);
    }
    // Feet, then body: the sum of pulls is not nought in between.
    QTest::addRow("pair, published") << QString("published") << creature(1, 0.2, 1.0);
    QTest::addRow("creature, published") << QString("published") << creature(5, 0.2, 1.0);
}

void TestStability::whatGrowsAtEveryStepHasTheLimitNought()
{
    QFETCH(QString, method);
    QFETCH(Swinging, swinging);
    const Stability found = predicted(swinging.scene, method.toStdString(), 0.125);
    QCOMPARE(found.limit, 0.0);
    QVERIFY(std::isinf(found.share()));
    QVERIFY(!found.holds());
    for (const double h : {1.0, 0.5, 0.25})
        QVERIFY(grows(swinging, method.toStdString(), h));
}

void TestStability::thePairThatPropelsItselfIsPastItsLimit()
{
    // Both drift at V. The spring is short by u when the foot moves, and by u - h V when the body does, so that
    // V (1 - d)/d = h k u for the foot and -h k (u - h V) for the body: k h^2 = 2 (1 - d)/d, with d = damp^h.
    const double k = 0.3, damp = 0.9;
    const Stability found = predicted(creature(1, k, damp).scene, "published");
    const double limit =
        firstRoot(1e-3, [=](double h) { return k * h * h - 2.0 * (std::pow(damp, -h) - 1.0); });
    QVERIFY2(std::abs(found.limit - limit) < 2e-4 * limit, qPrintable(QString::number(found.limit)));
    QVERIFY(!found.holds());
    QCOMPARE(found.manner, Manner::away);
    QCOMPARE(found.culprit.point, 0);
    QCOMPARE(found.culprit.other, 1);
    // The same pair under a method that keeps momentum, and a softer pair, rest.
    QVERIFY(predicted(creature(1, k, damp).scene, "semi_implicit_euler").holds());
    QVERIFY(predicted(creature(1, 0.2, damp).scene, "published").holds());
    const auto speedAfter = [](const Swinging &pair, const char *method) {
        Scene scene = pair.scene;
        scene.start.place(0, {330, 260});
        return length(support::plainRun(scene, method, 1.0, 3000).speed(1));
    };
    QVERIFY(speedAfter(creature(1, k, damp), "published") > 1.0);
    QVERIFY(speedAfter(creature(1, 0.2, damp), "published") < 1e-6);
    QVERIFY(speedAfter(creature(1, k, damp), "semi_implicit_euler") < 1e-6);
}

void TestStability::manyFeetDriveTheirBodyByTheClosedForm_data()
{
    QTest::addColumn<int>("feet");
    for (const int feet : {1, 2, 5, 9})
        QTest::addRow("%d feet", feet) << feet;
}

void TestStability::manyFeetDriveTheirBodyByTheClosedForm()
{
    QFETCH(int, feet);
    // As for the pair, with as many pulls on the body: k h^2 = (1 + feet)/feet (1 - d)/d.
    const double k = 0.2, damp = 0.85;
    const double limit = firstRoot(
        1e-3, [=](double h) { return k * h * h - (1.0 + feet) / feet * (std::pow(damp, -h) - 1.0); });
    const Stability found = predicted(bundle(feet, k, damp).scene, "published");
    QVERIFY2(std::abs(found.limit - limit) < 2e-4 * limit,
             qPrintable(QString("%1 in place of %2").arg(found.limit).arg(limit)));
}

void TestStability::strongDampingHoldsLongStepsAgain()
{
    const Swinging one = onePoint(1.0, std::exp(-0.3));
    const Stability past = predicted(one.scene, "semi_implicit_euler", 6.0);
    QVERIFY(past.limit > 2.0 && past.limit < 3.0);
    QVERIFY(!past.holds());
    QVERIFY(grows(one, "semi_implicit_euler", 6.0));
    const Stability far = predicted(one.scene, "semi_implicit_euler", 20.0);
    QCOMPARE(far.limit, past.limit);
    QVERIFY(far.holds());
    QVERIFY(!grows(one, "semi_implicit_euler", 20.0));
}

void TestStability::enoughDampingHoldsEveryStep()
{
    // k h^2 < 2 (1 + e^(c h)) for all h where c > 0.52 sqrt(k): where h^2 and 2 e^(c h) would touch, h is 2/c.
    const Stability found = predicted(onePoint(0.2, 0.5).scene, "semi_implicit_euler", 7.0);
    QVERIFY(std::isinf(found.limit));
    QCOMPARE(found.share(), 0.0);
    QVERIFY(found.holds());
    const Stability stopped = predicted(onePoint(0.2, 0.0).scene, "semi_implicit_euler");
    QVERIFY(std::isinf(stopped.limit));
}

void TestStability::everyMethodSaysWhatBoundsIt()
{
    const Scene scene = chain(3, 0.2, 0.9).scene;
    for (const MethodPtr &method : allMethods()) {
        const Bound bound = stabilityOf(scene, scene.start, *method, 1.0).bound;
        if (method->stepping() == Stepping::adaptive)
            QCOMPARE(bound, Bound::tolerance);
        else if (method->needs() == std::vector<std::string>{"slopes"})
            QCOMPARE(bound, Bound::none);
        else
            QCOMPARE(bound, Bound::stiffness);
    }
}

void TestStability::nothingSwingsWithoutSprings()
{
    Scene scene = support::pointsOf(2);
    scene.effects = {make_shared<Gravity>(0.5), make_shared<Damping>(0.9)};
    QCOMPARE(predicted(scene, "explicit_euler").bound, Bound::noSprings);
    QCOMPARE(growthOf(scene, scene.start, *findMethod("published"), 1.0), 1.0);
}

void TestStability::whatPushesApartIsNoFaultOfTheStep()
{
    // A long row of points that springs press together would buckle sideways by itself; along the springs it has the
    // limit of springs that nothing presses.
    Scene scene = creature(3, 0.2, 0.9).scene;
    const Stability slack = predicted(scene, "semi_implicit_euler", 0.1);
    for (int i = 0; i < 3; ++i)
        scene.start.place(i, scene.start.at(3) + 0.4 * (scene.start.at(i) - scene.start.at(3)));
    const Stability pressed = predicted(scene, "semi_implicit_euler", 0.1);
    QVERIFY(pressed.holds());
    QVERIFY(std::abs(pressed.limit - slack.limit) < 1e-9);
    const Stability published = predicted(scene, "published", 0.1);
    QVERIFY(published.holds());
}

void TestStability::theStiffestSpringIsNamed()
{
    Scene scene = chain(6, 0.05, 0.95).scene;
    const auto stiff = make_shared<BodySpring>(std::vector<Link>{{3, 4}, {4, 3}}, 0.9);
    scene.effects.push_back(stiff);
    for (const char *method : {"semi_implicit_euler", "rk4", "published"}) {
        const Stability found = predicted(scene, method, 3.0);
        QCOMPARE(found.culprit.effect, stiff);
        QCOMPARE(found.culprit.point, 3);
        QCOMPARE(found.culprit.other, 4);
        QCOMPARE(found.points.size(), std::size_t(2));
    }
}

void TestStability::aSpringToAPlaceIsNamed()
{
    Scene scene = chain(6, 0.05, 0.95).scene;
    const auto stiff = make_shared<PointSpring>(2, Vec2{0, 0}, 0.9);
    scene.effects.push_back(stiff);
    const Stability found = predicted(scene, "velocity_verlet", 1.0);
    QCOMPARE(found.culprit.effect, stiff);
    QCOMPARE(found.culprit.point, 2);
    QCOMPARE(found.culprit.other, -1);
    QCOMPARE(found.points.front(), 2);
}

void TestStability::contactsAreNamedAsLeftOut()
{
    const support::Sample &room = support::sample("creature in a room");
    const Scene scene = room.build(room.values);
    const Stability found = predicted(scene, "semi_implicit_euler");
    QCOMPARE(found.bound, Bound::stiffness);
    QCOMPARE(found.leftOut.size(), std::size_t(1));
    QCOMPARE(found.leftOut.front()->id(), "walls");
}

void TestStability::forcesWithoutSlopesAreDifferenced()
{
    Scene scene = creature(4, 0.2, 0.9).scene;
    for (const char *method : {"rk4", "published"}) {
        const double told = predicted(scene, method).limit;
        Scene silent = scene;
        silent.effects.front() =
            make_shared<Silent>(std::dynamic_pointer_cast<const Force>(scene.effects.front()));
        const double found = predicted(silent, method).limit;
        QVERIFY2(std::abs(told - found) < 1e-3 * told, qPrintable(QString("%1 %2").arg(told).arg(found)));
    }
}

void TestStability::aHeldBodyDoesNotSwing()
{
    // The pair is then one foot on a spring to a place.
    Scene scene = creature(1, 0.3, 1.0).scene;
    scene.start.inverseMass[1] = 0.0;
    const double limit = 2.0 / std::sqrt(0.3);
    for (const char *method : {"semi_implicit_euler", "published"})
        QVERIFY(std::abs(predicted(scene, method).limit - limit) < 2e-4 * limit);
}

void TestStability::theLargestEigenvaluesOfALargeMatrixAreFound()
{
    const int size = 300;
    support::Dice dice(3);
    Eigen::MatrixXd matrix(size, size);
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j <= i; ++j)
            matrix(i, j) = matrix(j, i) = dice.real(-1, 1);
    }
    const Spectrum found(size, [&](const Eigen::VectorXd &in, Eigen::VectorXd &out) { out = matrix * in; });
    const Eigen::VectorXd all = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
    const double largest = all.cwiseAbs().maxCoeff();
    QVERIFY(std::abs(std::abs(found.values().front()) - largest) < 1e-6 * largest);
    const Eigen::VectorXcd vector = found.vector(0);
    QVERIFY((matrix * vector - found.values().front() * vector).norm() < 1e-4 * largest);
}

void TestStability::pullsThatAreNotFiniteAreSaid()
{
    Scene scene = creature(1, 0.3, 0.9).scene;
    scene.start.place(0, {std::nan(""), 0.0});
    const Stability found = predicted(scene, "semi_implicit_euler");
    QCOMPARE(found.bound, Bound::unknown);
    QVERIFY(!found.holds());
}

void TestStability::extremesHaveAnAnswer_data()
{
    QTest::addColumn<double>("k");
    QTest::addColumn<double>("damp");
    QTest::addColumn<double>("inverse");
    for (const double k : {1e-12, 1.0, 1e9}) {
        for (const double damp : {0.0, 1e-300, 0.5, 1.0}) {
            for (const double inverse : {1e-9, 1.0, 1e9})
                QTest::addRow("k %g, damp %g, mass 1 : %g", k, damp, inverse) << k << damp << inverse;
        }
    }
}

void TestStability::extremesHaveAnAnswer()
{
    QFETCH(double, k);
    QFETCH(double, damp);
    QFETCH(double, inverse);
    Scene scene = creature(3, k, damp).scene;
    scene.start.inverseMass[0] = inverse;
    scene.start.place(1, {1e9, -1e9});
    for (const char *method : explicitMethods()) {
        for (const double h : {1e-6, 1.0, 100.0}) {
            const Stability found = predicted(scene, method, h);
            QCOMPARE(found.bound, Bound::stiffness);
            QVERIFY(found.limit >= 0.0);
            QVERIFY(found.growth >= 0.0);
            // Far below its limit a step holds, unless that is below what rounding tells.
            if (found.limit > 0.0 && found.share() < 0.9)
                QVERIFY(found.holds());
        }
    }
}

QTEST_APPLESS_MAIN(TestStability)
#include "tst_stability.moc"
