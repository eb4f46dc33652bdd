#include "parameters.h"

#include <QCoreApplication>

using lessons::Parameter;

namespace codeling {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Codeling)
};

/// A share from 0 to 1.
Parameter part(const char *id, const QString &name, const QString &unit, const QString &help, double preset)
{
    return {id, name, {}, unit, help, preset, 0.0, 1.0, 0.0, 1.0, 2, {}};
}

/// What swings is the lead, on its motor: so this is what damps.
Parameter keptByLead()
{
    Parameter parameter = part("keep", Text::tr("Keep"), Text::tr("per frame"),
                               Text::tr("The share of its speed that the lead keeps each frame."), 0.7);
    parameter.role = lessons::Role::keptSpeed;
    return parameter;
}

Parameter pixels(const char *id, const QString &name, const QString &help, double preset, double sliderMax)
{
    return {id, name, {}, Text::tr("px"), help, preset, 0.0, 1e6, 0.0, sliderMax, 0, {}};
}

Parameter place(const char *id, const QString &name, const QString &help, double sliderMax)
{
    Parameter parameter = pixels(id, name, help, 200.0, sliderMax);
    parameter.min = -1e6;
    return parameter;
}

Parameter count(const char *id, const QString &name, const QString &help, double preset, double min,
                double max)
{
    return {id, name, {}, {}, help, preset, min, max, min, max, 0, {}, true};
}

}

std::vector<Parameter> motorParameters()
{
    return {
        {"k",
         Text::tr("Stiffness"),
         "k",
         {},
         Text::tr("How hard the motor pulls: this times the way to the target."),
         0.9,
         0.0,
         1e9,
         0.0,
         4.0,
         2,
         {}},
        keptByLead(),
        {"dt",
         Text::tr("Time step"),
         {},
         {},
         Text::tr("How much of its own time passes in a frame: the pull counts dt × dt."),
         0.25,
         0.0,
         100.0,
         0.0,
         1.0,
         2,
         {}},
        place("target_x", Text::tr("Target x"), Text::tr("How far to the right the first target is."), 540.0),
        place("target_y", Text::tr("Target y"), Text::tr("How far down the first target is."), 400.0)};
}

Parameter restLength()
{
    return pixels("rest_length", Text::tr("Rest length"),
                  Text::tr("How far the tail is from the lead at rest."), 40.0, 120.0);
}

Parameter anticipationPart()
{
    return part("anticipation", Text::tr("Anticipation"), {},
                Text::tr("How far it backs up before a move, as a part of the way to the target."), 0.2);
}

std::vector<Parameter> spineParameters()
{
    const QString perFrame = Text::tr("per frame");
    return {part("soft", Text::tr("Soft"), perFrame,
                 Text::tr("The part of the spine’s error that goes each frame."), 0.1),
            part("hard", Text::tr("Hard"), perFrame,
                 Text::tr("The same, when the spine is shorter than least or longer than most."), 0.8),
            part("along", Text::tr("Along"), perFrame,
                 Text::tr("The share of the tail’s speed along the spine that it keeps."), 0.7),
            part("across", Text::tr("Across"), perFrame,
                 Text::tr("The share of the tail’s speed across the spine that it keeps."), 0.5),
            pixels("min_length", Text::tr("Least length"),
                   Text::tr("Shorter than this, the spine pushes hard."), 20.0, 120.0),
            pixels("max_length", Text::tr("Most length"), Text::tr("Longer than this, the spine pulls hard."),
                   60.0, 120.0)};
}

std::vector<Parameter> tentacleParameters()
{
    return {count("tentacles", Text::tr("Tentacles"), Text::tr("How many tentacles it has."), 4.0, 2.0, 8.0),
            count("links", Text::tr("Links"), Text::tr("How many links each tentacle has."), 10.0, 3.0, 30.0),
            part("water", Text::tr("Water"), Text::tr("per frame"),
                 Text::tr("The share of its speed that a tentacle keeps each frame. Less: thicker water."),
                 0.9)};
}

}
