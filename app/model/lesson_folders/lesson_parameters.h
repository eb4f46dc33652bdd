#pragma once

#include "app/model/experiment/experiment.h"
#include "lessons/api/step.h"
#include "lessons/api/text/document.h"

#include <memory>
#include <string>
#include <vector>

namespace app {

/// A number of a built scene that a parameter of a lesson sets.
struct ParameterTarget
{
    enum class Number { springStiffness, springLength, stickLength };
    std::string parameter; ///< id
    Number number = Number::springStiffness;
    std::size_t index = 0; ///< of the spring or stick in the blueprint
};

/// Returns `blueprint` with the numbers that `values` has for `targets`. Without targets it is the same one.
std::shared_ptr<const sim::Blueprint> blueprintWith(std::shared_ptr<const sim::Blueprint> blueprint,
                                                    const std::vector<ParameterTarget> &targets,
                                                    const sim::Values &values);

/// Returns the parameters that `own` declares, the document of a step in the first language of its lesson, with the texts of
/// `shown`, which is `own` or its translation. One that sets numbers of the scene begins with its minimum.
/// @throws lessons::DocumentError if one is incomplete, its numbers contradict each other, or the documents differ in them
std::vector<lessons::Parameter> declaredParameters(const lessons::Document &own,
                                                   const lessons::Document &shown);

/// Returns what the parameters of `own` set in the scene of `scene`.
/// @throws lessons::DocumentError if there is no such spring or stick, or it cannot have the numbers of the parameter
std::vector<ParameterTarget> targetsOf(const lessons::Document &own, const Experiment &scene);

/// Gives the parameters that set numbers of the scene the values of the scene, also in its script.
/// @throws lessons::DocumentError if such a value is outside the range of its parameter, or two differ
void takeValues(std::vector<lessons::Parameter> &parameters, const lessons::Document &own,
                const std::vector<ParameterTarget> &targets, Experiment &scene);

/// Checks that the names of the parameters of `own` are free in `scene`, a scene of the step `base`, and that it reads each.
/// @throws lessons::DocumentError if not
void checkNamesAndUse(const lessons::Document &own, const std::vector<ParameterTarget> &targets,
                      const lessons::Step &base, const Experiment &scene);

/// Returns a text that the parameters of two documents share if they are the same but for their texts.
QString parameterKey(const lessons::Document &own);

/// Returns the section of a document that declares `parameter`.
QString sectionFor(const lessons::ParameterText &parameter);

}
