#include "lessons/api/text/parameter_text.h"

#include "lessons/api/text/document.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace lessons {

namespace {

struct ParameterTextWords
{
    Q_DECLARE_TR_FUNCTIONS(ParameterText)
};

constexpr qsizetype longestUnit = 20;  ///< characters
constexpr qsizetype longestLabel = 40; ///< characters
constexpr double mostMagnitude = 1e9;  ///< of the numbers of a parameter
constexpr std::array<double, 7> stepsAllowed = {1.0, 0.1, 0.01, 0.001, 0.0001, 0.00001, 0.000001};

/// Reads the list of a parameter.
class ParameterItems
{
public:
    ParameterItems(ParameterText &into, const QString &file) : m_into(into), m_file(file) {}

    void read(const ListItem &item)
    {
        if (item.name == u"value")
            set(m_into.value, item);
        else if (item.name == u"minimum")
            set(m_into.minimum, item);
        else if (item.name == u"maximum")
            set(m_into.maximum, item);
        else if (item.name == u"step")
            setStep(item);
        else if (item.name == u"unit")
            setUnit(item);
        else if (item.name == u"sets")
            setTarget(item);
        else
            reject(item,
                   ParameterTextWords::tr("a parameter has no “%1”. It has “value”, “minimum”, “maximum”, "
                                          "“step”, “unit” and “sets”.")
                       .arg(item.name));
    }

private:
    [[noreturn]] void reject(const ListItem &item, const QString &why) const
    {
        throw DocumentError(m_file, item.line, why);
    }

    void checkOnce(bool isThere, const ListItem &item) const
    {
        if (isThere)
            reject(item, ParameterTextWords::tr("“%1” is there twice. Remove one of them.").arg(item.name));
    }

    void set(std::optional<double> &number, const ListItem &item) const
    {
        checkOnce(number.has_value(), item);
        bool isNumber = false;
        const double value = item.value.toDouble(&isNumber);
        if (!isNumber || !(std::abs(value) <= mostMagnitude))
            reject(item,
                   ParameterTextWords::tr(
                       "“%1” is not a number between -1000000000 and 1000000000. Write it as in “- %2: 2”.")
                       .arg(item.value, item.name));
        number = value;
    }

    void setStep(const ListItem &item) const
    {
        set(m_into.step, item);
        if (std::find(stepsAllowed.begin(), stepsAllowed.end(), *m_into.step) == stepsAllowed.end())
            reject(item,
                   ParameterTextWords::tr("the step cannot be %1. Write one of these: %2.")
                       .arg(item.value, QStringLiteral("1, 0.1, 0.01, 0.001, 0.0001, 0.00001, 0.000001")));
    }

    void setUnit(const ListItem &item) const
    {
        checkOnce(!m_into.unit.isEmpty(), item);
        if (item.value.size() > longestUnit)
            reject(item, ParameterTextWords::tr("this unit has %1 characters. Write at most %2.")
                             .arg(item.value.size())
                             .arg(longestUnit));
        m_into.unit = item.value;
    }

    void setTarget(const ListItem &item) const
    {
        checkOnce(m_into.sets.has_value(), item);
        m_into.sets = item;
    }

    ParameterText &m_into;
    const QString &m_file;
};

}

ParameterText parseParameter(const DocumentPart &part, const QString &name, const QString &id,
                             const QString &file)
{
    ParameterText parameter{.id = id, .name = name, .line = part.line};
    if (name.size() > longestLabel)
        throw DocumentError(
            file, part.line,
            ParameterTextWords::tr("the name of the parameter “%1” has %2 characters. Write at most %3.")
                .arg(id)
                .arg(name.size())
                .arg(longestLabel));
    const auto firstItem = std::find_if(part.body.begin(), part.body.end(),
                                        [](const QString &line) { return line.trimmed().startsWith("- "); });
    const qsizetype textLines = firstItem - part.body.begin();
    parameter.help = joinedText(part.body.mid(0, textLines));
    if (parameter.help.isEmpty())
        throw DocumentError(
            file, part.line,
            ParameterTextWords::tr(
                "nothing says what the parameter “%1” does. Write one sentence below its heading.")
                .arg(id));
    if (firstItem == part.body.end())
        return parameter;
    DocumentPart list = part;
    std::fill_n(list.body.begin(), textLines, QString()); // so that the lines keep their numbers
    ParameterItems items(parameter, file);
    for (const ListItem &item : parseList(list, file))
        items.read(item);
    return parameter;
}

}
