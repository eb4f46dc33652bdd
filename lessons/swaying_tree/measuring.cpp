#include "measuring.h"

#include "sim/effects/tree/joints.h"

#include <QCoreApplication>

#include <cmath>
#include <limits>

using lessons::Measure;

namespace swaying_tree {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(SwayingTree)
};

using Energy = double (*)(const sim::Torsion &, const sim::State &);

Measure energyMeasure(const QString &name, const QString &help, Energy energy)
{
    return {
        .name = name,
        .help = help,
        .decimals = 2,
        .of =
            [energy](const sim::Scene &scene, const sim::State &state, const sim::State *,
                     const sim::Values &) {
                const auto *springs = effectOf<sim::Torsion>(scene);
                return springs ? energy(*springs, state) : std::numeric_limits<double>::quiet_NaN();
            },
    };
}

double motion(const sim::Torsion &springs, const sim::State &state)
{
    return springs.motionEnergy(state);
}

double held(const sim::Torsion &springs, const sim::State &state)
{
    return springs.springEnergy(state);
}

double total(const sim::Torsion &springs, const sim::State &state)
{
    return motion(springs, state) + held(springs, state);
}

}

double bendOf(const sim::Scene &scene, const sim::State &state, int branch)
{
    return state.angle[branch] - scene.start.angle[branch];
}

double largestBend(const sim::Scene &scene, const sim::State &state)
{
    return (state.angle - scene.start.angle).abs().maxCoeff();
}

sim::Vec2 endOf(const sim::Scene &scene, const sim::State &state, int branch)
{
    const auto *joints = effectOf<sim::Joints>(scene);
    if (!joints)
        return state.at(branch);
    return sim::endOf(joints->tree(), state, branch, sim::degreesPerRadian);
}

int nearestBranch(const sim::Scene &scene, const sim::State &state, sim::Vec2 place)
{
    int nearest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < state.points(); ++i) {
        const double distance = sim::length(endOf(scene, state, i) - place);
        if (distance < least) {
            least = distance;
            nearest = i;
        }
    }
    return nearest;
}

Measure countMeasure()
{
    return {
        .name = Text::tr("Branches"),
        .help = Text::tr("How many branches the tree has."),
        .decimals = 0,
        .of = [](const sim::Scene &, const sim::State &state, const sim::State *,
                 const sim::Values &) { return double(state.points()); },
    };
}

Measure bendMeasure()
{
    return {
        .name = Text::tr("Largest bend"),
        .unit = Text::tr("°"),
        .help = Text::tr("How far the most bent branch is turned from where it grew."),
        .decimals = 1,
        .of = [](const sim::Scene &scene, const sim::State &state, const sim::State *,
                 const sim::Values &) { return largestBend(scene, state); },
    };
}

std::vector<Measure> energyMeasures()
{
    return {
        energyMeasure(Text::tr("Energy"),
                      Text::tr("Of motion and springs together. Without wind and damping it stays."), total),
        energyMeasure(Text::tr("In motion"), Text::tr("The part that is in the turning branches."), motion),
        energyMeasure(Text::tr("In springs"), Text::tr("The part that the bent joints hold."), held)};
}

}
