#include "app/model/experiment/parameter_value.h"

#include "app/model/experiment/json_fields.h"
#include "app/model/text/json_writer.h"
#include "app/model/text/quoting.h"

#include <QCoreApplication>

#include <cmath>

namespace app {

namespace {

struct ParameterValueText
{
    Q_DECLARE_TR_FUNCTIONS(ParameterValueText)
};

double choiceOf(const QString &file, const JsonValue &value, const lessons::Parameter &parameter)
{
    const QString *text = std::get_if<QString>(&value.what);
    const qsizetype position = text ? parameter.choices.indexOf(*text) : -1;
    if (position < 0)
        refuse(file, value.line,
               ParameterValueText::tr("%1 is %2; it can be one of %3.")
                   .arg(quoted(parameter.id), shortText(value),
                        quotedList(parameter.choices, text ? *text : QString())));
    return double(position);
}

}

const lessons::Parameter &parameterOf(const QString &file, int line, const lessons::Step &step,
                                      const QString &id)
{
    if (const lessons::Parameter *parameter = step.parameter(id))
        return *parameter;
    QStringList ids;
    for (const lessons::Parameter &parameter : step.parameters)
        ids.push_back(parameter.id);
    refuse(file, line,
           ParameterValueText::tr("the step %1 has no parameter %2; it has %3.")
               .arg(quoted(step.id), quoted(id),
                    ids.isEmpty() ? ParameterValueText::tr("none") : quotedList(ids, id)));
}

double parameterValue(const QString &file, const JsonValue &value, const lessons::Parameter &parameter)
{
    if (!parameter.choices.isEmpty())
        return choiceOf(file, value, parameter);
    const double number = numberOf(file, value, parameter.id);
    const bool fits = number >= parameter.min && number <= parameter.max;
    if (fits && !(parameter.isInteger && number != std::floor(number)))
        return number;
    const QString possible = parameter.isInteger
                                 ? ParameterValueText::tr("%1 is %2; it can be a whole number from %3 to %4.")
                                 : ParameterValueText::tr("%1 is %2; it can be %3 to %4.");
    refuse(file, value.line,
           possible.arg(quoted(parameter.id), exactNumber(number), exactNumber(parameter.min),
                        exactNumber(parameter.max)));
}

void writeParameterValue(const lessons::Parameter &parameter, double value, JsonWriter &json)
{
    if (parameter.choices.isEmpty() || !std::isfinite(value))
        json.value(value);
    else
        json.value(parameter.choices.value(qsizetype(std::lround(value))));
}

}
