#include "app/model/parameter_value.h"

#include "app/model/json_fields.h"
#include "app/model/words.h"

#include <QCoreApplication>

#include <cmath>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(ParameterValue)
};

double choiceOf(const QString &file, const JsonValue &value, const lessons::Parameter &parameter)
{
    const QString *text = std::get_if<QString>(&value.what);
    const qsizetype position = text ? parameter.choices.indexOf(*text) : -1;
    if (position < 0)
        refuse(file, value.line,
               Text::tr("%1 is %2; it can be one of %3.")
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
           Text::tr("the step %1 has no parameter %2; it has %3.")
               .arg(quoted(step.id), quoted(id), ids.isEmpty() ? Text::tr("none") : quotedList(ids, id)));
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
                                 ? Text::tr("%1 is %2; it can be a whole number from %3 to %4.")
                                 : Text::tr("%1 is %2; it can be %3 to %4.");
    refuse(file, value.line,
           possible.arg(quoted(parameter.id), exactNumber(number), exactNumber(parameter.min),
                        exactNumber(parameter.max)));
}

QString parameterText(const lessons::Parameter &parameter, double value)
{
    if (parameter.choices.isEmpty())
        return exactNumber(value);
    const auto position = qsizetype(std::lround(value));
    return '"' + parameter.choices.value(position) + '"';
}

}
