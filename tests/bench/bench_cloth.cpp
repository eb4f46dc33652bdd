// Measures a frame of a soft cloth by an explicit step. Also solves the linear system of a stiff cloth's step, by our
// conjugate gradients spring by spring and by Eigen's with an assembled matrix. Both use the same Jacobian,
// tolerance and diagonal preconditioner.

#include "tests/sim/support/support.h"

#include "sim/methods/implicit/solvers/conjugate_gradients.h"
#include "sim/methods/methods.h"
#include "sim/methods/ode_system.h"
#include "sim/pipeline/run_step.h"
#include "sim/scenes/cloth.h"

#include <benchmark/benchmark.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>

namespace {

namespace cloth = scenes::cloth;

constexpr int side = 64;
constexpr double k = 1e6;
constexpr double tolerance = 1e-10;

struct System
{
    std::vector<sim::Jacobian::Entry> entries;
    Eigen::VectorXd right;
};

/// Returns the system of a stretched cloth whose points are shifted randomly, so that no two rows are equal.
System drawnOut()
{
    sim::Scene scene = cloth::hung(side, k, 1.0);
    support::Dice dice(3);
    const int points = side * side, free = points - side;
    for (int i = 0; i < points; ++i)
        scene.start.place(i, 1.5 * scene.start.positionOf(i) + sim::Vec2{dice.real(-1, 1), dice.real(-1, 1)});
    sim::Jacobian jacobian(points);
    sim::OdeSystem(scene, sim::DirectionRule::regularised).jacobian(scene.start, jacobian);
    const auto number = [&](int row) { return row % points - side + (row < points ? 0 : free); };
    System system;
    for (const sim::Jacobian::Entry &entry : jacobian.entries()) {
        if (entry.row % points >= side && entry.column % points >= side)
            system.entries.push_back({number(entry.row), number(entry.column), -entry.value});
    }
    system.right.resize(2 * free);
    for (double &value : system.right)
        value = dice.real(-1.0, 1.0);
    return system;
}

Eigen::SparseMatrix<double, Eigen::RowMajor> matrixOf(const System &system)
{
    std::vector<Eigen::Triplet<double>> all;
    all.reserve(system.entries.size() + std::size_t(system.right.size()));
    for (int i = 0; i < system.right.size(); ++i)
        all.emplace_back(i, i, 1.0);
    for (const sim::Jacobian::Entry &entry : system.entries)
        all.emplace_back(entry.row, entry.column, entry.value);
    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(system.right.size(), system.right.size());
    matrix.setFromTriplets(all.begin(), all.end());
    return matrix;
}

void clothOurs(benchmark::State &run)
{
    const System system = drawnOut();
    const Eigen::VectorXd ones = Eigen::VectorXd::Ones(system.right.size());
    for (auto _ : run) {
        const auto matrix = sim::SpringMatrix::of(system.entries, ones);
        const sim::ConjugateResult found =
            sim::conjugateGradients(*matrix, sim::interleaved(system.right), tolerance);
        Eigen::VectorXd x = sim::separated(found.x);
        benchmark::DoNotOptimize(x.data());
        run.counters["products"] = found.iterations;
    }
}

void clothEigen(benchmark::State &run)
{
    const System system = drawnOut();
    for (auto _ : run) {
        const auto matrix = matrixOf(system);
        // Upper and lower triangle, as Eigen's documentation recommends for speed.
        Eigen::ConjugateGradient<Eigen::SparseMatrix<double, Eigen::RowMajor>, Eigen::Lower | Eigen::Upper>
            solver;
        solver.setTolerance(tolerance);
        solver.compute(matrix);
        Eigen::VectorXd x = solver.solve(system.right);
        benchmark::DoNotOptimize(x.data());
        run.counters["products"] = double(solver.iterations());
    }
}

void clothCholesky(benchmark::State &run)
{
    const System system = drawnOut();
    for (auto _ : run) {
        const Eigen::SparseMatrix<double> matrix = matrixOf(system);
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factors(matrix);
        Eigen::VectorXd x = factors.solve(system.right);
        benchmark::DoNotOptimize(x.data());
    }
}

void frames(benchmark::State &run, const sim::Scene &scene, const char *id)
{
    const sim::MethodPtr method = sim::findMethod(id);
    const sim::Pipeline pipeline = sim::compose(scene, *method, sim::StepSize::ofLength(1.0));
    sim::State state = scene.start;
    method->prepareState(state);
    for (auto _ : run) {
        sim::runStep(pipeline, state);
        benchmark::DoNotOptimize(state.position.data());
    }
    run.SetComplexityN(state.pointCount());
}

/// Measures a frame by semi-implicit Euler.
void clothExplicit(benchmark::State &run)
{
    frames(run, cloth::hung(static_cast<int>(run.range(0)), cloth::soft, cloth::calm), "semi_implicit_euler");
}

/// Measures a frame by backward Euler near rest, like most frames.
void clothImplicit(benchmark::State &run)
{
    frames(run, cloth::hung(static_cast<int>(run.range(0)), k, 0.5), "backward_euler");
}

BENCHMARK(clothExplicit)->Arg(32)->Arg(64)->Arg(128)->Arg(256)->Complexity();
BENCHMARK(clothOurs)->Unit(benchmark::kMillisecond);
BENCHMARK(clothEigen)->Unit(benchmark::kMillisecond);
BENCHMARK(clothCholesky)->Unit(benchmark::kMillisecond);
BENCHMARK(clothImplicit)->Arg(16)->Arg(32)->Arg(64)->Complexity();

}
