#include "lessons/api/step.h"

#include "lessons/api/text/formula_reader.h"
#include "lessons/api/text/join.h"
#include "lessons/api/view/view.h"
#include "sim/methods/methods.h"
#include "sim/run/script/script.h"
#include "sim/scene/scene.h"

#include <algorithm>

namespace lessons {

bool Step::accepts(Interaction interaction) const
{
    return std::find(interactions.begin(), interactions.end(), interaction) != interactions.end();
}

void Step::addParameters(const std::vector<Parameter> &more)
{
    parameters.insert(parameters.end(), more.begin(), more.end());
}

void Step::readTexts(const std::vector<Check> &tests)
{
    checks = tests;
    setTexts(readDocument(lesson, id));
}

void Step::setTexts(const Document &document)
{
    checkGaps(document, listing);
    checkParameters(document, parameters);
    if (scene) // not yet while a plugin puts the step together
        checkHighlights(document, *this);
    tries = joinedTries(document, checks);
    title = document.title;
    narration = document.story;
    explanation = document.explanation;
    codeTasks = document.tasks;
    predictions = document.predictions;
}

const Parameter *Step::parameter(const QString &parameterId) const
{
    for (const Parameter &parameter : parameters) {
        if (parameter.id == parameterId)
            return &parameter;
    }
    return nullptr;
}

const Parameter *Step::parameterFor(ParameterRole role) const
{
    for (const Parameter &parameter : parameters) {
        if (parameter.role == role)
            return &parameter;
    }
    return nullptr;
}

sim::Values Step::defaultValues() const
{
    sim::Values values;
    for (const Parameter &parameter : parameters)
        values.set(parameter.id.toStdString(), parameter.defaultValue);
    return values;
}

sim::Script Step::script() const
{
    return scriptWith(defaultValues(), sim::findMethod(method.toStdString()));
}

sim::Script Step::scriptWith(const sim::Values &values, const sim::MethodPtr &chosenMethod) const
{
    sim::Script script;
    script.build = scene;
    script.values = values;
    script.method = chosenMethod;
    script.step = sim::stepFor(*chosenMethod, sim::StepSize::ofLength(h));
    if (prepareScript)
        prepareScript(script);
    return script;
}

Step makeStep(const QString &lesson, const QString &id)
{
    Step step;
    step.lesson = lesson;
    step.id = id;
    step.sceneSource = {QStringLiteral("lessons/%1/scenes.cpp").arg(lesson).toStdString(), id.toStdString()};
    step.listing = readListing(lesson, id);
    return step;
}

}
