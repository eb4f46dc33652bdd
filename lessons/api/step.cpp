#include "lessons/api/step.h"

#include "lessons/api/view/scene_view.h"
#include "sim/methods/methods.h"
#include "sim/run/script/script.h"
#include "sim/scene/scene.h"

#include <algorithm>

namespace lessons {

bool Step::can(Does what) const
{
    return std::find(does.begin(), does.end(), what) != does.end();
}

void Step::addParameters(const std::vector<Parameter> &more)
{
    parameters.insert(parameters.end(), more.begin(), more.end());
}

const Parameter *Step::parameter(const QString &wanted) const
{
    for (const Parameter &parameter : parameters) {
        if (parameter.id == wanted)
            return &parameter;
    }
    return nullptr;
}

const Parameter *Step::parameterFor(Role role) const
{
    for (const Parameter &parameter : parameters) {
        if (parameter.role == role)
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
    return scriptWith(presets(), sim::findMethod(method.toStdString()));
}

sim::Script Step::scriptWith(const sim::Values &values, const sim::MethodPtr &by) const
{
    sim::Script script;
    script.build = scene;
    script.values = values;
    script.method = by;
    script.step = sim::stepFor(*by, sim::StepSize::of(h));
    if (opening)
        opening(script);
    return script;
}

Step stepCalled(const QString &lesson, const QString &id, const QString &title)
{
    Step step;
    step.id = id;
    step.title = title;
    step.setUp = {QStringLiteral("lessons/%1/scenes.cpp").arg(lesson).toStdString(), id.toStdString()};
    return step;
}

}
