#include "lessons/api/parameters.h"

#include <QCoreApplication>

namespace lessons {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Parameters)
};

/// A coordinate on the stage, which is `sliderMax` px wide or high.
Parameter place(const char *id, const QString &name, const QString &help, double preset, double sliderMax)
{
    return {id, name, {}, Text::tr("px"), help, preset, -1e6, 1e6, 0.0, sliderMax, 0, {}};
}

}

Parameter stiffness(double preset)
{
    return {"k",
            Text::tr("Stiffness"),
            "k",
            Text::tr("1/frame²"),
            Text::tr("How hard a spring pulls: this share of the missing distance, each frame."),
            preset,
            0.0,
            1e9,
            0.0,
            1.0,
            2,
            {}};
}

Parameter damping(double preset)
{
    return {"damp",
            Text::tr("Damping"),
            {},
            Text::tr("per frame"),
            Text::tr("The share of its speed that everything keeps each frame. 1 keeps it all."),
            preset,
            0.0,
            1.0,
            0.0,
            1.0,
            2,
            {},
            false,
            Role::keptSpeed};
}

Parameter radius(double preset)
{
    return {"radius",
            Text::tr("Radius"),
            {},
            Text::tr("px"),
            Text::tr("The distance that the spring keeps."),
            preset,
            0.0,
            1e6,
            0.0,
            150.0,
            0,
            {}};
}

Parameter offset(double preset)
{
    return {"offset",
            Text::tr("Offset"),
            {},
            Text::tr("px"),
            Text::tr("How far to the right of the body the spring ends. Below 0: to the left."),
            preset,
            -1e6,
            1e6,
            -150.0,
            150.0,
            0,
            {}};
}

Parameter feet(int preset)
{
    return {"feet",
            Text::tr("Feet"),
            {},
            {},
            Text::tr("How many feet the body has."),
            double(preset),
            1.0,
            100.0,
            1.0,
            24.0,
            0,
            {},
            true};
}

Parameter gravity(double preset)
{
    return {"gravity",
            Text::tr("Gravity"),
            "g",
            Text::tr("px/frame²"),
            Text::tr("How much speed everything gains downwards each frame."),
            preset,
            -1e6,
            1e6,
            0.0,
            3.0,
            2,
            {}};
}

Parameter bounce(double preset)
{
    return {"bounce",
            Text::tr("Bounce"),
            {},
            Text::tr("kept"),
            Text::tr("The share of its speed that a body keeps at a wall."),
            preset,
            0.0,
            1.0,
            0.0,
            1.0,
            2,
            {}};
}

Parameter ground(double preset)
{
    return place("ground", Text::tr("Ground"), Text::tr("How far down the ground lies."), preset, 440.0);
}

Parameter choice(const char *id, const QString &name, const QString &help, const QStringList &choices)
{
    const double last = double(choices.size() - 1);
    return {id, name, {}, {}, help, 0.0, 0.0, last, 0.0, last, 0, choices, true};
}

std::vector<Parameter> centre()
{
    return {
        place("centre_x", Text::tr("Centre x"), Text::tr("How far to the right the cross is."), 270.0, 540.0),
        place("centre_y", Text::tr("Centre y"), Text::tr("How far down the cross is."), 200.0, 400.0)};
}

std::vector<Parameter> room()
{
    return {place("left", Text::tr("Left wall"), Text::tr("Where the left wall stands."), 20.0, 540.0),
            place("right", Text::tr("Right wall"), Text::tr("Where the right wall stands."), 520.0, 540.0),
            place("floor", Text::tr("Floor"), Text::tr("How far down the floor lies."), 380.0, 400.0)};
}

}
