// A cloth that is much too stiff for explicit methods at this step, and its linear solver.

#include "tests/sim/support/implicit_scenes.h"
#include "tests/sim/support/support.h"

#include "sim/methods/implicit/solvers/conjugate_gradients.h"
#include "sim/methods/implicit/solvers/linear_solve.h"
#include "sim/methods/methods.h"
#include "sim/methods/ode_system.h"
#include "sim/run/finite.h"
#include "sim/scenes/cloth.h"
#include "tests/suite.h"

#include <Eigen/Dense>
#include <QTest>

using namespace sim;
namespace cloth = scenes::cloth;

namespace {

using Entries = std::vector<Jacobian::Entry>;

/// Returns the Jacobian of the dynamic points of `scene`, times -h^2, as backward Euler uses it. Fixed points
/// have no rows and columns.
Entries entriesOf(const Scene &scene, double h)
{
    const int points = scene.start.pointCount();
    std::vector<int> number(std::size_t(points), -1);
    int free = 0;
    for (int i = 0; i < points; ++i)
        number[std::size_t(i)] = scene.start.isDynamic(i) ? free++ : -1;
    Jacobian jacobian(points);
    OdeSystem(scene, DirectionRule::regularised).jacobian(scene.start, jacobian);
    Entries entries;
    const auto numberOf = [&](int row) {
        const int index = number[std::size_t(row % points)];
        return index < 0 || row < points ? index : index + free;
    };
    for (const Jacobian::Entry &entry : jacobian.entries()) {
        if (numberOf(entry.row) >= 0 && numberOf(entry.column) >= 0)
            entries.push_back({numberOf(entry.row), numberOf(entry.column), -h * h * entry.value});
    }
    return entries;
}

int unknownCount(const Scene &scene)
{
    return 2 * int((scene.start.inverseMass != 0.0).count());
}

/// Returns the mass of each unknown.
Eigen::VectorXd massesOf(const Scene &scene)
{
    std::vector<double> masses;
    for (int i = 0; i < scene.start.pointCount(); ++i) {
        if (scene.start.isDynamic(i))
            masses.push_back(1.0 / scene.start.inverseMass[i]);
    }
    const Eigen::VectorXd pointMasses =
        Eigen::Map<Eigen::VectorXd>(masses.data(), Eigen::Index(masses.size()));
    Eigen::VectorXd allMasses(2 * pointMasses.size());
    allMasses << pointMasses, pointMasses;
    return allMasses;
}

Eigen::MatrixXd denseOf(const Entries &entries, int size)
{
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Identity(size, size);
    for (const Jacobian::Entry &entry : entries)
        matrix(entry.row, entry.column) += entry.value;
    return matrix;
}

/// Returns how far row `row` of a cloth hangs below its unstretched position at rest, in px. Each spring of a
/// column carries the points below it, so the m-th spring is stretched by weight (side - m) / k.
double sag(int side, double k, int row)
{
    const double carried = row * side - row * (row + 1) / 2.0; // the sum of side - m, m from 1 to row
    return cloth::weight * carried / k;
}

/// Returns a cloth with stretched springs and masses from 1 to 1000.
Scene crumpled(int side, double k)
{
    Scene scene = cloth::hung(side, k, 1.0);
    support::Dice dice(5);
    scene.start.position *= 1.5;
    for (int i = 0; i < scene.start.pointCount(); ++i) {
        scene.start.place(i, scene.start.positionOf(i) + Vec2{dice.real(-1, 1), dice.real(-1, 1)});
        if (scene.start.isDynamic(i))
            scene.start.inverseMass[i] = std::pow(10.0, dice.real(-3.0, 0.0));
    }
    return scene;
}

}

class TestStiffCloth : public QObject
{
    Q_OBJECT

private slots:
    void clothComesToRestAtItsExactSag_data()
    {
        QTest::addColumn<QString>("method");
        QTest::newRow("backward Euler") << "backward_euler";
        QTest::newRow("TR-BDF2") << "tr_bdf2";
    }
    void clothComesToRestAtItsExactSag()
    {
        QFETCH(QString, method);
        constexpr int side = 64, frames = 12;
        constexpr double k = 1e6; // one step per frame, so k h^2 = 1e6
        const Scene scene = cloth::hung(side, k, 0.5);
        const State end = support::plainRun(scene, method.toStdString(), 1.0, frames);
        for (int point = 0; point < end.pointCount(); ++point) {
            const double exact = sag(side, k, point / side);
            const Vec2 moved = end.positionOf(point) - scene.start.positionOf(point);
            QVERIFY2(std::abs(moved.y - exact) <= 0.01 * exact,
                     qPrintable(QString("point %1: %2, not %3").arg(point).arg(moved.y).arg(exact)));
            QVERIFY2(std::abs(moved.x) <= 0.01 * sag(side, k, side - 1),
                     qPrintable(QString("point %1: %2 sideways").arg(point).arg(moved.x)));
        }
        // In a hundred frames it would move by less than a hundredth of its sag.
        QVERIFY2(end.velocity.abs().maxCoeff() < 1e-4 * sag(side, k, side - 1),
                 qPrintable(QString::number(end.velocity.abs().maxCoeff())));
    }

    /// Makes sure that the other tests do use conjugate gradients.
    void solverFollowsFromTheSprings()
    {
        const auto solverOf = [](const Scene &scene) {
            return solverFor(entriesOf(scene, 1.0), unknownCount(scene));
        };
        QVERIFY(solverOf(cloth::hung(4, 1.0, 1.0)) == Solver::dense);
        QVERIFY(solverOf(cloth::hung(10, 1.0, 1.0)) == Solver::sparse);
        QVERIFY(solverOf(cloth::hung(64, 1.0, 1.0)) == Solver::conjugate);
        QVERIFY(solverOf(implicit_scenes::creature(2000, 1.0)) == Solver::sparse); // a star has no cycles
    }

    void conjugateGradientsAgreeWithFactorisation_data()
    {
        QTest::addColumn<double>("k");
        for (const double k : {0.2, 1e3, 1e6})
            QTest::addRow("k = %g", k) << k;
    }
    void conjugateGradientsAgreeWithFactorisation()
    {
        QFETCH(double, k);
        const Scene scene = crumpled(8, k);
        const int size = unknownCount(scene);
        const Entries entries = entriesOf(scene, 1.0);
        const Eigen::VectorXd rightSide = Eigen::VectorXd::LinSpaced(size, -1.0, 2.0),
                              masses = massesOf(scene);
        const auto matrix = SpringMatrix::of(entries, masses);
        QVERIFY(matrix);
        const ConjugateResult found =
            conjugateGradients(*matrix, interleaved(masses.cwiseProduct(rightSide)), 1e-13);
        const Eigen::MatrixXd dense = denseOf(entries, size);
        const Eigen::VectorXd exact = dense.fullPivLu().solve(rightSide);
        const double error = (separated(found.x) - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff();
        const double conditionNumber = dense.norm() * dense.inverse().norm(); // amplifies rounding errors
        QVERIFY2(error < 1e-13 * conditionNumber + 1e-13,
                 qPrintable(QString("%1, %2").arg(error).arg(conditionNumber)));
        QVERIFY(found.iterations > 5);
    }

    void springMatrixIsSymmetricOnlyWithItsMasses()
    {
        const Scene scene = crumpled(8, 1e3);
        const Entries entries = entriesOf(scene, 1.0);
        QVERIFY(!SpringMatrix::of(entries, Eigen::VectorXd::Ones(unknownCount(scene))));
        Eigen::VectorXd masses = massesOf(scene);
        QVERIFY(SpringMatrix::of(entries, masses));
        masses[3] = std::numeric_limits<double>::infinity();
        QVERIFY(!SpringMatrix::of(entries, masses));
    }

    /// Springs compressed to a third of their length make the matrix indefinite, so conjugate gradients fail.
    void compressedClothFallsBackToFactorisation()
    {
        Scene scene = cloth::hung(40, 1e3, 1.0);
        scene.start.position /= 3.0;
        const Entries entries = entriesOf(scene, 1.0);
        const int size = unknownCount(scene);
        const Eigen::VectorXd rightSide = Eigen::VectorXd::LinSpaced(size, -1.0, 2.0),
                              masses = massesOf(scene);
        QVERIFY(solverFor(entries, size) == Solver::conjugate);
        const auto matrix = SpringMatrix::of(entries, masses);
        QVERIFY(matrix && !conjugateGradients(*matrix, interleaved(rightSide), 1e-12).x.allFinite());
        const Eigen::VectorXd found = solved(entries, rightSide, masses);
        Eigen::VectorXd residual = found - rightSide;
        for (const Jacobian::Entry &entry : entries)
            residual[entry.row] += entry.value * found[entry.column];
        QVERIFY2(residual.norm() < 1e-8 * rightSide.norm(), qPrintable(QString::number(residual.norm())));
    }

    void repeatedRunsHaveTheSameBits()
    {
        const Scene scene = cloth::hung(32, 1e6, 0.9);
        const State run = support::plainRun(scene, "backward_euler", 1.0, 3);
        QVERIFY(sameBits(run, support::plainRun(scene, "backward_euler", 1.0, 3)));
        QCOMPARE(firstNonFinitePoint(run), -1);
    }
};

SUITE(tst_stiff_cloth, TestStiffCloth)
#include "tst_stiff_cloth.moc"
