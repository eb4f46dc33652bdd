#pragma once

#include "app/model/experiment/json_document.h"
#include "lessons/api/step.h"

namespace app {

class JsonWriter;

/// Returns the declared parameter `id` of a step.
/// @throws UserError: it does not exist; the message lists the existing ones
const lessons::Parameter &parameterOf(const QString &file, int line, const lessons::Step &step,
                                      const QString &id);
/// Returns the checked value of a parameter in a file: a number, or the index of a choice.
double parameterValue(const QString &file, const JsonValue &value, const lessons::Parameter &parameter);
/// Writes a parameter's value: a number, or the name of a choice.
void writeParameterValue(const lessons::Parameter &parameter, double value, JsonWriter &json);

}
