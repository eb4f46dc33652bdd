#pragma once

#include "app/model/json_document.h"
#include "lessons/api/step.h"

namespace app {

/// The declared parameter `id` of a step. @throws Refusal listing what there is
const lessons::Parameter &parameterOf(const QString &file, int line, const lessons::Step &step,
                                      const QString &id);
/// What a file gives for a parameter, checked: a number, or a choice's position.
double parameterValue(const QString &file, const JsonValue &value, const lessons::Parameter &parameter);
/// A parameter's value as files write it.
QString parameterText(const lessons::Parameter &parameter, double value);

}
