#include "parameters.h"

#include "lessons/api/parameters.h"

#include <QCoreApplication>

using namespace lessons;

namespace sandbox {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Sandbox)
};

Parameter of(const QStringList &effects, Parameter parameter)
{
    parameter.effects = effects;
    return parameter;
}

/// A share from 0 to `max`, of which the slider covers `sliderMax`.
Parameter share(const char *id, const QString &name, const QString &help, double preset, double max,
                double sliderMax)
{
    return {id, name, {}, {}, help, preset, 0.0, max, 0.0, sliderMax, 2, {}};
}

Parameter wind()
{
    return {"wind",
            Text::tr("Wind"),
            {},
            Text::tr("px/frame²"),
            Text::tr("How hard it blows to the right on a body 10 px wide. Below 0: to the left."),
            0.1,
            -1e6,
            1e6,
            -1.0,
            1.0,
            2,
            {}};
}

Parameter push()
{
    return {"push",
            Text::tr("Push"),
            "k",
            Text::tr("1/frame²"),
            Text::tr("How hard two bodies push: this share of the missing distance, each frame."),
            0.2,
            0.0,
            1e9,
            0.0,
            1.0,
            2,
            {}};
}

Parameter distance()
{
    return {"distance",
            Text::tr("Distance"),
            {},
            Text::tr("px"),
            Text::tr("Two bodies closer than this push each other."),
            20.0,
            0.0,
            1e6,
            0.0,
            100.0,
            0,
            {}};
}

std::vector<Parameter> ramp()
{
    const auto place = [](const char *id, const QString &name, const QString &help, double preset,
                          double sliderMax) -> Parameter {
        return {id, name, {}, Text::tr("px"), help, preset, -1e6, 1e6, 0.0, sliderMax, 0, {}};
    };
    return {
        {"ramp",
         Text::tr("Ramp"),
         {},
         Text::tr("°"),
         Text::tr("How steeply it rises to the right. 0: level. 90: a wall on the right. 180: a ceiling."),
         20.0,
         -180.0,
         180.0,
         -180.0,
         180.0,
         0,
         {}},
        place("ramp_x", Text::tr("Ramp x"), Text::tr("How far to the right a place of the ramp is."), 270.0,
              540.0),
        place("ramp_y", Text::tr("Ramp y"), Text::tr("How far down that place is."), 320.0, 400.0)};
}

Parameter iterations()
{
    return {"iterations",
            Text::tr("Iterations"),
            {},
            Text::tr("passes"),
            Text::tr("How often each frame goes through the list of sticks."),
            10.0,
            1.0,
            1000.0,
            1.0,
            50.0,
            0,
            {},
            true,
            Role::passes};
}

}

std::vector<Parameter> sceneParameters()
{
    std::vector<Parameter> all = {of({"gravity"}, gravity(0.3)), of({"damping"}, damping(0.99))};
    for (const Parameter &wall : room())
        all.push_back(of({"walls", "room", "turn_round"}, wall));
    all.push_back(of({"walls", "ramp"}, bounce(0.5)));
    for (const Parameter &one : ramp())
        all.push_back(of({"ramp"}, one));
    all.push_back(of({"room"}, share("friction", Text::tr("Friction"),
                                     Text::tr("How much a wall’s push holds back what slides along it. 0: "
                                              "like ice."),
                                     0.5, 10.0, 2.0)));
    all.push_back(of({"ground"}, ground(380.0)));
    all.push_back(of({"breeze"}, wind()));
    all.push_back(
        of({"breeze"}, share("gusts", Text::tr("Gusts"),
                             Text::tr("The share by which the wind swells and ebbs."), 0.5, 1.0, 1.0)));
    all.push_back(of({"push"}, push()));
    all.push_back(of({"push"}, distance()));
    all.push_back(of({"sticks"}, iterations()));
    return all;
}

}
