#include "sim/methods/fixed/runge_kutta.h"

#include "sim/methods/ode_system.h"
#include "sim/methods/zero_accelerations.h"
#include "sim/pipeline/phase_builder.h"

namespace sim {

namespace {

const char *const sourceFile = "sim/methods/fixed/runge_kutta.cpp";

Tableau midpoint()
{
    Tableau t;
    //! [midpoint_tableau]
    t.stages = 2;
    t.c = {0, 0.5};
    t.a[1] = {0.5};
    t.b = {0, 1};
    //! [midpoint_tableau]
    return t;
}

Tableau classical()
{
    Tableau t;
    //! [rk4_tableau]
    t.stages = 4;
    t.c = {0, 0.5, 0.5, 1};
    t.a[1] = {0.5};
    t.a[2] = {0, 0.5};
    t.a[3] = {0, 0, 1};
    t.b = {1. / 6, 1. / 3, 1. / 3, 1. / 6};
    //! [rk4_tableau]
    return t;
}

/// The columns of State::stages: positions and velocities at the start of the step, then the velocities of
/// each stage, then the accelerations of each stage, then one for the next position.
struct Columns
{
    int stages = 0;
    int startPosition() const { return 0; }
    int startVelocity() const { return 1; }
    int velocity(int stage) const { return 2 + stage; }
    int acceleration(int stage) const { return 2 + stages + stage; }
    /// The column in which the next position is computed.
    int nextPosition() const { return 2 + 2 * stages; }
    int count() const { return 3 + 2 * stages; }
};

/// The equations of a scene and the stage weights for them, which all phases of a step share.
struct Plan
{
    Plan(const Scene &scene, const Tableau &tableau, DirectionRule directionRule, double step)
        : system(scene, directionRule), c(tableau.c), columns{tableau.stages}, h(step)
    {
        for (const OdeSystem::RateRange &range : system.rateRanges())
            weights.emplace_back().set(tableau, range.rate, h, tableau.stages);
    }

    OdeSystem system;
    Tableau::Row c;
    std::vector<StageWeights> weights; ///< one per rate range of the system
    Columns columns;
    double h;

    /// Returns the time of a stage, or of the end of the step, in frames after its start.
    double timeOf(int stage) const
    {
        return stage < columns.stages ? h * c[static_cast<std::size_t>(stage)] : h;
    }
    /// Runs the continuous drivers from the stage before to `stage`.
    void tickTo(State &state, int stage) const
    {
        system.advanceDrivers(state, timeOf(stage) - timeOf(stage - 1));
    }
};

double *column(State &state, int number)
{
    return state.stages.data() + number * state.stages.rows();
}

/// Computes the positions of a stage, or of the end of the step, from the velocities of the stages before it.
double *positionOf(State &state, const Plan &plan, int stage)
{
    const Columns &at = plan.columns;
    for (std::size_t i = 0; i < plan.weights.size(); ++i) {
        const OdeSystem::RateRange &rows = plan.system.rateRanges()[i];
        const double *weights = plan.weights[i].position[static_cast<std::size_t>(stage)].data();
        blendRows(column(state, at.nextPosition()), column(state, at.startPosition()), 1.0,
                  column(state, at.velocity(0)), weights, stage, rows.first, rows.end(), plan.system.size());
    }
    return column(state, at.nextPosition());
}

/// Computes the velocities of a stage, or of the end of the step, in column `out` from the accelerations of
/// the stages before it.
double *velocityOf(State &state, const Plan &plan, int stage, int out)
{
    const Columns &at = plan.columns;
    for (std::size_t i = 0; i < plan.weights.size(); ++i) {
        const OdeSystem::RateRange &rows = plan.system.rateRanges()[i];
        const auto row = static_cast<std::size_t>(stage);
        const double *weights = plan.weights[i].velocity[row].data();
        blendRows(column(state, out), column(state, at.startVelocity()), plan.weights[i].keep[row],
                  column(state, at.acceleration(0)), weights, stage, rows.first, rows.end(),
                  plan.system.size());
    }
    return column(state, out);
}

/// Stores the accumulated accelerations of `stage` and computes its velocities.
void storeStage(State &state, const Plan &plan, int stage)
{
    const Columns &at = plan.columns;
    if (stage == 0)
        plan.system.readState(state, column(state, at.startPosition()), column(state, at.startVelocity()));
    plan.system.readAccumulated(state, column(state, at.acceleration(stage)));
    velocityOf(state, plan, stage, at.velocity(stage));
}

// Shown lines are short.
// clang-format off
/// Moves the state to the positions of `stage`, or of the end of the step.
//! [trial_place]
void goTo(State &state,
    const Plan &plan, int stage)
{
    // by the velocities found so far
    double *x =
        positionOf(state, plan, stage);
    plan.tickTo(state, stage);
    plan.system.writePositions(x, state);
}
//! [trial_place]

/// Moves the state to the positions of `stage`, and to its velocities if a force reads them.
void goToTrial(State &state, const Plan &plan, int stage)
{
    goTo(state, plan, stage);
    if (plan.system.readsVelocities())
        plan.system.writeVelocities(velocityOf(state, plan, stage, plan.columns.velocity(stage)), state);
}

/// Moves the state to the end of the step: positions and velocities.
//! [step_end]
void finish(State &state,
    const Plan &plan)
{
    int end = plan.columns.stages;
    goTo(state, plan, end);
    // by the pulls of all stages
    int out = plan.columns.nextPosition();
    double *v = velocityOf(
        state, plan, end, out);
    plan.system.writeVelocities(v, state);
}
//! [step_end]
// clang-format on

Phase stagePhase(const char *id, const char *title, const Scene &scene, const char *tableau)
{
    Phase phase;
    phase.id = id;
    phase.title = title;
    phase.points = {0, scene.start.pointCount()};
    phase.regions = {{sourceFile, "trial_place"},
                     {sourceFile, "step_end"},
                     {sourceFile, tableau},
                     {"sim/methods/fixed/tableau.h", "blend"}};
    phase.consumesAcceleration = true;
    phase.integrates = true;
    phase.explain = [](const State &before, const State &after, int point) {
        return motionChange(before, after, point);
    };
    return phase;
}

/// Adds the effects of the equations that are neither forces nor torques, which `phase` computes itself.
void addInnerEffects(Phase &phase, const Plan &plan, DirectionRule directionRule)
{
    for (const EffectPtr &effect : plan.system.effects()) {
        if (as<Force>(effect) || as<Torque>(effect))
            continue;
        phase.innerEffects.push_back(effect);
        for (const Region &region : effect->regions(directionRule))
            phase.regions.push_back(region);
    }
}

}

Midpoint::Midpoint() : RungeKutta(midpoint(), 2, "midpoint_tableau") {}

RungeKutta4::RungeKutta4() : RungeKutta(classical(), 4, "rk4_tableau") {}

void RungeKutta::prepareState(State &state) const
{
    zeroAccelerations(state);
    state.stages.setZero(2 * state.pointCount() + state.spin.rows(), Columns{m_tableau.stages}.count());
}

std::vector<Phase> RungeKutta::phases(const Scene &scene, StepSize size) const
{
    PhaseBuilder step(scene, directionRule(), size.h);
    const auto plan = std::make_shared<const Plan>(scene, m_tableau, directionRule(), size.h);
    const auto trial = [&](int stage) {
        Phase phase = stagePhase("trial", SIM_TEXT("trial step"), scene, m_shown);
        phase.kernels = {{[plan, stage](State &state) {
                              storeStage(state, *plan, stage - 1);
                              goToTrial(state, *plan, stage);
                          },
                          {}}};
        addInnerEffects(phase, *plan, directionRule());
        return phase;
    };
    const auto move = [&] {
        Phase phase = stagePhase("step", SIM_TEXT("move"), scene, m_shown);
        phase.kernels = {{[plan](State &state) {
                              storeStage(state, *plan, plan->columns.stages - 1);
                              finish(state, *plan);
                          },
                          {}}};
        return phase;
    };
    const int stages = step.anyMoves() ? m_tableau.stages : 0;
    if (stages == 0)
        step.continuousDrivers(1);
    //! [runge_kutta_order]
    // forces at one trial place after
    // another, then one step from all
    PhasePoints all = step.allPoints();
    step.leadingImpulses();
    for (int i = 0; i < stages; ++i) {
        if (i > 0)
            step.add(trial(i));
        step.accumulateForces(all);
    }
    if (stages > 0)
        step.add(move());
    step.dampingWithoutRate(all);
    step.rewindPrevious(all);
    step.constraints(all);
    step.contacts(all);
    step.trailingImpulses();
    //! [runge_kutta_order]
    return step.take();
}

}
