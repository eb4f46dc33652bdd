#include "lessons/api/step.h"

#include "sim/methods/methods.h"

namespace lessons {

const Parameter *Step::parameter(const QString &wanted) const
{
    for (const Parameter &parameter : parameters) {
        if (parameter.id == wanted)
            return &parameter;
    }
    return nullptr;
}

sim::Values Step::presets() const
{
    sim::Values values;
    for (const Parameter &parameter : parameters)
        values.set(parameter.id.toStdString(), parameter.preset);
    return values;
}

sim::Script Step::script() const
{
    sim::Script script;
    script.build = scene;
    script.values = presets();
    script.method = sim::findMethod(method.toStdString());
    script.step = sim::StepSize::of(h);
    return script;
}

}
