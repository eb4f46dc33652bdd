#include "app/model/experiment.h"

#include "app/model/input_walk.h"
#include "app/model/parameter_value.h"
#include "app/model/words.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>

#include <cmath>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Experiment)
};

/// A text as JSON writes it.
QString jsonText(const QString &text)
{
    const QByteArray list = QJsonDocument(QJsonArray{text}).toJson(QJsonDocument::Compact);
    return QString::fromUtf8(list.mid(1, list.size() - 2));
}

QString jsonText(const std::string &text)
{
    return jsonText(QString::fromStdString(text));
}

QString jsonNumber(double value)
{
    if (!std::isfinite(value))
        throw Refusal(Text::tr("Not saved: a number of this experiment is not finite, and files have no such "
                               "number. Go back to a frame before that."));
    return exactNumber(value);
}

/// Writes fields one a line, as the published examples do.
class Writer
{
public:
    void field(const QString &name, const QString &value)
    {
        m_fields.push_back(jsonText(name) + ": " + value);
    }
    /// A list or object with one entry a line; left out when it is empty.
    void block(const QString &name, const QString &brackets, const QStringList &entries)
    {
        if (!entries.isEmpty())
            field(name, brackets.left(1) + "\n  " + entries.join(",\n  ") + "\n " + brackets.right(1));
    }
    QByteArray text() const { return ("{\n " + m_fields.join(",\n ") + "\n}\n").toUtf8(); }

private:
    QStringList m_fields;
};

QStringList parameterEntries(const sim::Script &script, const lessons::Step &step)
{
    QStringList entries;
    for (const lessons::Parameter &parameter : step.parameters) {
        const double value = script.values[parameter.id.toStdString()];
        if (value == parameter.preset)
            continue;
        jsonNumber(value);
        entries.push_back(jsonText(parameter.id) + ": " + parameterText(parameter, value));
    }
    return entries;
}

QStringList bodyEntries(const sim::Script &script)
{
    QStringList entries;
    for (const auto &[name, start] : script.bodies) {
        QString entry =
            jsonText(name) + ": { \"x\": " + jsonNumber(start.x.x) + ", \"y\": " + jsonNumber(start.x.y);
        if (start.v)
            entry += ", \"vx\": " + jsonNumber(start.v->x) + ", \"vy\": " + jsonNumber(start.v->y);
        entries.push_back(entry + " }");
    }
    return entries;
}

QString eventEntry(const sim::Event &event, const lessons::Step &step)
{
    const QString start = "{ \"frame\": " + QString::number(event.frame) + ", \"event\": ";
    if (const auto *grab = std::get_if<sim::Grab>(&event.what))
        return start + "\"grab\", \"body\": " + jsonText(grab->body) + " }";
    if (const auto *move = std::get_if<sim::Move>(&event.what))
        return start + "\"move\", \"x\": " + jsonNumber(move->to.x) + ", \"y\": " + jsonNumber(move->to.y) +
               " }";
    const auto *set = std::get_if<sim::Set>(&event.what);
    if (!set)
        return start + "\"release\" }";
    jsonNumber(set->value);
    const QString id = QString::fromStdString(set->parameter);
    const lessons::Parameter *parameter = step.parameter(id);
    return start + "\"set\", \"parameter\": " + jsonText(id) +
           ", \"value\": " + (parameter ? parameterText(*parameter, set->value) : jsonNumber(set->value)) +
           " }";
}

/// The events that do something. A parameter that was changed in the past can leave others without effect: a
/// body that is taken hold of later may be gone now. What a file has must make sense to who reads it.
QStringList inputEntries(const sim::Script &script, const lessons::Step &step)
{
    QStringList entries;
    std::vector<sim::Event> input = script.input;
    sim::sortByFrame(input);
    walkInput(
        script, input, [](const sim::Scene &, int) {},
        [&](int index, EventEffect effect) {
            const sim::Event &event = input[std::size_t(index)];
            if (effect == EventEffect::works)
                entries.push_back(eventEntry(event, step));
            else if (effect == EventEffect::onlyLetsGo)
                entries.push_back(eventEntry({event.frame, sim::Release{}}, step));
        });
    return entries;
}

}

QByteArray experimentText(const Experiment &experiment, const LessonLibrary &library)
{
    const sim::Script &script = experiment.script;
    const LessonEntry *lesson = library.lesson(experiment.lesson);
    const lessons::Step *step = lesson ? lesson->step(experiment.step) : nullptr;
    if (!step)
        throw Refusal(
            Text::tr("Not saved: the step %1 is not installed any more.").arg(quoted(experiment.step)));
    Writer writer;
    writer.field("format", jsonText(QStringLiteral("springstep-experiment/1")));
    writer.field("lesson", jsonText(experiment.lesson));
    writer.field("step", jsonText(experiment.step));
    const sim::Script untouched = step->script();
    if (script.method->id() != untouched.method->id())
        writer.field("method", jsonText(script.method->id()));
    if (script.step != untouched.step)
        writer.field("h", jsonNumber(script.step.h));
    writer.field("frames", QString::number(experiment.frames));
    if (script.values.seed != untouched.values.seed)
        writer.field("seed", QString::number(script.values.seed));
    QStringList effects;
    for (const std::string &id : script.effectsOff)
        effects.push_back(jsonText(id));
    if (!effects.isEmpty())
        writer.field("effects", '[' + effects.join(", ") + ']');
    writer.block("parameters", "{}", parameterEntries(script, *step));
    writer.block("bodies", "{}", bodyEntries(script));
    writer.block("input", "[]", inputEntries(script, *step));
    return writer.text();
}

}
