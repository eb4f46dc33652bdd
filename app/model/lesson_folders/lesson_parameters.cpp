#include "app/model/lesson_folders/lesson_parameters.h"

#include "app/listing/language.h"
#include "app/listing/vocabulary.h"
#include "app/model/catalog/lists.h"
#include "app/model/sandbox/blueprint_limits.h"
#include "app/model/text/quoting.h"
#include "sim/run/script/script.h"
#include "sim/scene/scene.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace app {

namespace {

struct LessonParametersText
{
    Q_DECLARE_TR_FUNCTIONS(LessonParametersText)
};

using Number = ParameterTarget::Number;

constexpr double usualStep = 0.01;

/// Words of rules, of conditions and of runs in documents, which a parameter would hide or not be found beside.
const QStringList &takenWords()
{
    static const QStringList words = {"time",  "bodies", "me",    "other",  "force",
                                      "pull",  "phase",  "floor", "method", "press",
                                      "click", "frames", "until", "step",   "drag"};
    return words;
}

[[noreturn]] void reject(const lessons::Document &document, int line, const QString &why)
{
    throw lessons::DocumentError(document.file, line, why);
}

bool isWhole(double value)
{
    return value == std::floor(value);
}

/// Checks one declaration of a lesson's own document.
void checkDeclaration(const lessons::Document &own, const lessons::ParameterText &text)
{
    if (!listing::isUsableName(text.id.toStdString()) || takenWords().contains(text.id))
        reject(own, text.line,
               LessonParametersText::tr(
                   "a parameter cannot be called “%1”: the word has another meaning in code, in "
                   "conditions or in runs. Choose another id.")
                   .arg(text.id));
    if (!text.minimum || !text.maximum)
        reject(own, text.line,
               LessonParametersText::tr(
                   "the parameter “%1” has no range. Write “- minimum: 0” and “- maximum: 1” "
                   "below its text, with your numbers.")
                   .arg(text.id));
    if (*text.minimum >= *text.maximum)
        reject(own, text.line,
               LessonParametersText::tr("the minimum of “%1” is not below its maximum. Change one of them.")
                   .arg(text.id));
    if (text.value && text.sets)
        reject(
            own, text.sets->line,
            LessonParametersText::tr("“%1” begins with the value that the scene has there. Remove “- value”.")
                .arg(text.id));
    if (!text.value && !text.sets)
        reject(own, text.line,
               LessonParametersText::tr("the parameter “%1” has no value at the start. Write “- value: %2”, "
                                        "or “- sets: k of a-b” with "
                                        "the names of two bodies that a spring joins.")
                   .arg(text.id, exactNumber(*text.minimum)));
    const bool isInteger = text.step.value_or(usualStep) == 1.0;
    if (isInteger && !(isWhole(*text.minimum) && isWhole(*text.maximum) && isWhole(text.value.value_or(0.0))))
        reject(own, text.line,
               LessonParametersText::tr(
                   "the step of “%1” is 1, so its numbers are whole. Choose a smaller step, such as 0.1.")
                   .arg(text.id));
    if (text.value && !(*text.value >= *text.minimum && *text.value <= *text.maximum))
        reject(own, text.line,
               LessonParametersText::tr(
                   "the value of “%1” is %2, outside its range from %3 to %4. Change one of them.")
                   .arg(text.id, exactNumber(*text.value), exactNumber(*text.minimum),
                        exactNumber(*text.maximum)));
}

void checkSameNumber(const lessons::Document &shown, const lessons::ParameterText &text, const QString &name,
                     std::optional<double> there, std::optional<double> own)
{
    if (there && there != own)
        reject(shown, text.line,
               LessonParametersText::tr(
                   "the %1 of “%2” differs between the languages. Remove it here: the numbers "
                   "are in the first language.")
                   .arg(name, text.id));
}

/// Checks that a translation declares the same parameters.
void checkTranslation(const lessons::Document &own, const lessons::Document &shown)
{
    for (const lessons::ParameterText &text : own.parameters) {
        if (!findById(shown.parameters, text.id))
            reject(shown, 1,
                   LessonParametersText::tr(
                       "the parameter “%1” is missing. Write “## Parameter: name {#%1}”, and a "
                       "sentence below it.")
                       .arg(text.id));
    }
    for (const lessons::ParameterText &text : shown.parameters) {
        const lessons::ParameterText *same = findById(own.parameters, text.id);
        if (!same)
            reject(shown, text.line,
                   LessonParametersText::tr("%1 declares no parameter “%2”. Remove it here, or add it there.")
                       .arg(own.file, text.id));
        checkSameNumber(shown, text, QStringLiteral("value"), text.value, same->value);
        checkSameNumber(shown, text, QStringLiteral("minimum"), text.minimum, same->minimum);
        checkSameNumber(shown, text, QStringLiteral("maximum"), text.maximum, same->maximum);
        checkSameNumber(shown, text, QStringLiteral("step"), text.step, same->step);
        if (text.sets && (!same->sets || same->sets->value != text.sets->value))
            reject(shown, text.sets->line,
                   LessonParametersText::tr("“sets” differs between the languages. Remove it here."));
    }
}

lessons::Parameter parameterFrom(const lessons::ParameterText &own, const lessons::ParameterText &shown)
{
    const double step = own.step.value_or(usualStep);
    lessons::Parameter parameter;
    parameter.id = own.id;
    parameter.name = shown.name;
    parameter.help = shown.help;
    parameter.unit = shown.unit.isEmpty() ? own.unit : shown.unit;
    parameter.defaultValue = own.value.value_or(*own.minimum);
    parameter.min = parameter.sliderMin = *own.minimum;
    parameter.max = parameter.sliderMax = *own.maximum;
    parameter.decimals = static_cast<int>(std::lround(-std::log10(step)));
    parameter.isInteger = step == 1.0;
    return parameter;
}

/// Finds what a parameter sets in a blueprint.
class TargetFinder
{
public:
    TargetFinder(const lessons::Document &own, const lessons::ParameterText &text, const sim::Blueprint &plan)
        : m_own(own), m_text(text), m_plan(plan)
    {
    }

    std::vector<ParameterTarget> find()
    {
        static const QRegularExpression pattern(
            QStringLiteral("\\A\\s*(k|length) of ([A-Za-z0-9_.]+)\\s*-\\s*([A-Za-z0-9_.]+)\\s*\\z"));
        for (const QString &part : m_text.sets->value.split(',')) {
            const auto match = pattern.match(part);
            if (!match.hasMatch())
                refuse(LessonParametersText::tr(
                           "“%1” is not something that a parameter can set. Write “k of a-b” or "
                           "“length of a-b” with the names of two bodies, and commas between "
                           "several.")
                           .arg(part.trimmed()));
            add(match.captured(1) == u"k", match.captured(2), match.captured(3));
        }
        return std::move(m_targets);
    }

private:
    [[noreturn]] void refuse(const QString &why) const { reject(m_own, m_text.sets->line, why); }

    void add(bool isStiffness, const QString &a, const QString &b)
    {
        const std::size_t before = m_targets.size();
        addLinks(m_plan.springs, isStiffness ? Number::springStiffness : Number::springLength, a, b);
        if (!isStiffness)
            addLinks(m_plan.sticks, Number::stickLength, a, b);
        if (m_targets.size() == before && pairsThere(isStiffness).isEmpty())
            refuse(isStiffness ? LessonParametersText::tr("the scene has no springs. Build one, or write "
                                                          "“- value: ” in place of “- sets: ”.")
                               : LessonParametersText::tr("the scene has no springs or sticks. Build one, or "
                                                          "write “- value: ” in place of “- sets: ”."));
        if (m_targets.size() == before)
            refuse((isStiffness ? LessonParametersText::tr(
                                      "no spring of the scene joins “%1” and “%2”. Springs join %3.")
                                : LessonParametersText::tr(
                                      "no spring or stick of the scene joins “%1” and “%2”. They join %3."))
                       .arg(a, b, pairsThere(isStiffness)));
        const Span span = isStiffness ? built::stiffness : built::length;
        if (!span.holds(*m_text.minimum) || !span.holds(*m_text.maximum))
            refuse(LessonParametersText::tr(
                       "“%1” can be %2 to %3 in a scene, and the parameter goes from %4 to %5. "
                       "Change its minimum or maximum.")
                       .arg(isStiffness ? QStringLiteral("k") : QStringLiteral("length"),
                            exactNumber(span.min), exactNumber(span.max), exactNumber(*m_text.minimum),
                            exactNumber(*m_text.maximum)));
    }

    template <class Links>
    void addLinks(const Links &links, Number number, const QString &a, const QString &b)
    {
        for (std::size_t i = 0; i < links.size(); ++i) {
            const QString first = nameOf(links[i].a), second = nameOf(links[i].b);
            if ((first == a && second == b) || (first == b && second == a))
                m_targets.push_back({m_text.id.toStdString(), number, i});
        }
    }

    QString nameOf(int point) const
    {
        return QString::fromStdString(m_plan.points[static_cast<std::size_t>(point)].name);
    }

    QString pairsThere(bool isStiffness) const
    {
        QStringList pairs;
        const auto note = [&](const auto &links) {
            for (const auto &link : links)
                pairs << nameOf(link.a) + '-' + nameOf(link.b);
        };
        note(m_plan.springs);
        if (!isStiffness)
            note(m_plan.sticks);
        return quotedList(pairs);
    }

    const lessons::Document &m_own;
    const lessons::ParameterText &m_text;
    const sim::Blueprint &m_plan;
    std::vector<ParameterTarget> m_targets;
};

/// Returns the number that `target` is about.
double &numberAt(sim::Blueprint &blueprint, const ParameterTarget &target)
{
    switch (target.number) {
    case Number::springStiffness:
        return blueprint.springs[target.index].k;
    case Number::springLength:
        return blueprint.springs[target.index].length;
    case Number::stickLength:
        break;
    }
    return blueprint.sticks[target.index].length;
}

}

std::shared_ptr<const sim::Blueprint> blueprintWith(std::shared_ptr<const sim::Blueprint> blueprint,
                                                    const std::vector<ParameterTarget> &targets,
                                                    const sim::Values &values)
{
    if (targets.empty())
        return blueprint;
    const auto plan = std::make_shared<sim::Blueprint>(*blueprint);
    for (const ParameterTarget &target : targets) {
        if (values.has(target.parameter))
            numberAt(*plan, target) = values[target.parameter];
    }
    return plan;
}

std::vector<lessons::Parameter> declaredParameters(const lessons::Document &own,
                                                   const lessons::Document &shown)
{
    for (const lessons::ParameterText &text : own.parameters)
        checkDeclaration(own, text);
    checkTranslation(own, shown);
    std::vector<lessons::Parameter> parameters;
    for (const lessons::ParameterText &text : own.parameters)
        parameters.push_back(parameterFrom(text, *findById(shown.parameters, text.id)));
    return parameters;
}

std::vector<ParameterTarget> targetsOf(const lessons::Document &own, const Experiment &scene)
{
    std::vector<ParameterTarget> targets;
    for (const lessons::ParameterText &text : own.parameters) {
        if (!scene.script.values.blueprint)
            reject(own, text.line,
                   LessonParametersText::tr(
                       "a parameter of your own needs a scene of the sandbox. Remove “%1”, or take "
                       "the scene to the sandbox (Ctrl+B) and save it there.")
                       .arg(text.id));
        if (!text.sets)
            continue;
        const std::vector<ParameterTarget> found =
            TargetFinder(own, text, *scene.script.values.blueprint).find();
        targets.insert(targets.end(), found.begin(), found.end());
    }
    return targets;
}

void takeValues(std::vector<lessons::Parameter> &parameters, const lessons::Document &own,
                const std::vector<ParameterTarget> &targets, Experiment &scene)
{
    for (const lessons::ParameterText &text : own.parameters) {
        const std::string id = text.id.toStdString();
        std::optional<double> value;
        for (const ParameterTarget &target : targets) {
            if (target.parameter != id)
                continue;
            sim::Blueprint plan = *scene.script.values.blueprint;
            const double found = numberAt(plan, target);
            if (value && *value != found)
                reject(own, text.sets->line,
                       LessonParametersText::tr(
                           "“%1” sets several numbers, of which one is %2 and another is %3 in the "
                           "scene. Make them the same there, or use two parameters.")
                           .arg(text.id, exactNumber(*value), exactNumber(found)));
            value = found;
        }
        if (!value)
            continue;
        lessons::Parameter *parameter = findById(parameters, text.id);
        if (*value < parameter->min || *value > parameter->max || (parameter->isInteger && !isWhole(*value)))
            reject(own, text.sets->line,
                   LessonParametersText::tr(
                       "the scene has %1 there, which does not fit the parameter “%2” from %3 to "
                       "%4. Change its minimum, maximum or step, or the scene.")
                       .arg(exactNumber(*value), text.id, exactNumber(parameter->min),
                            exactNumber(parameter->max)));
        parameter->defaultValue = *value;
        scene.script.values.set(id, *value);
    }
}

void checkNamesAndUse(const lessons::Document &own, const std::vector<ParameterTarget> &targets,
                      const lessons::Step &base, const Experiment &scene)
{
    if (own.parameters.empty())
        return;
    const sim::Script &script = scene.script;
    const std::vector<std::string> free =
        listing::vocabularyOf(sim::sceneOf(script, script.values)).parameters;
    const auto &rule = script.values.blueprint->rule.program;
    const std::vector<std::string> read = rule ? rule->parameters() : std::vector<std::string>();
    for (const lessons::ParameterText &text : own.parameters) {
        const std::string id = text.id.toStdString();
        if (base.parameter(text.id))
            reject(own, text.line,
                   LessonParametersText::tr("the scene has a parameter “%1” already. Choose another id.")
                       .arg(text.id));
        if (!contains(free, id))
            reject(own, text.line,
                   LessonParametersText::tr("bodies of the scene are called “%1”. Choose another id.")
                       .arg(text.id));
        const bool isSet = std::any_of(targets.begin(), targets.end(),
                                       [&id](const ParameterTarget &one) { return one.parameter == id; });
        if (!isSet && !contains(read, id))
            reject(own, text.line,
                   LessonParametersText::tr(
                       "nothing reads the parameter “%1”. Write %1 into the rule of the scene in "
                       "place of a number, or let it set one: “- sets: k of a-b”.")
                       .arg(text.id));
    }
}

QString parameterKey(const lessons::Document &own)
{
    const auto shown = [](std::optional<double> number) { return number ? exactNumber(*number) : QString(); };
    QStringList parts;
    for (const lessons::ParameterText &text : own.parameters)
        parts << text.id << shown(text.value) << shown(text.minimum) << shown(text.maximum)
              << shown(text.step) << (text.sets ? text.sets->value : QString());
    return parts.join(';');
}

QString sectionFor(const lessons::ParameterText &parameter)
{
    QString text =
        QStringLiteral("## Parameter: %1 {#%2}\n\n%3\n\n").arg(parameter.name, parameter.id, parameter.help);
    const auto item = [&text](const QString &name, const QString &value) {
        text += QStringLiteral("- %1: %2\n").arg(name, value);
    };
    if (parameter.sets)
        item(QStringLiteral("sets"), parameter.sets->value);
    if (parameter.value)
        item(QStringLiteral("value"), exactNumber(*parameter.value));
    item(QStringLiteral("minimum"), exactNumber(*parameter.minimum));
    item(QStringLiteral("maximum"), exactNumber(*parameter.maximum));
    if (parameter.step)
        item(QStringLiteral("step"), exactNumber(*parameter.step));
    if (!parameter.unit.isEmpty())
        item(QStringLiteral("unit"), parameter.unit);
    return text + '\n';
}

}
