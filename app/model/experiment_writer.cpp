#include "app/model/experiment.h"

#include "app/model/blueprint_writer.h"
#include "app/model/experiment_events.h"
#include "app/model/input_walk.h"
#include "app/model/parameter_value.h"
#include "app/model/words.h"
#include "sim/methods/methods.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
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
    QString text() const { return "{\n " + m_fields.join(",\n ") + "\n}"; }

private:
    QStringList m_fields;
};

QStringList parameterEntries(const sim::Script &script, const lessons::Step &step)
{
    QStringList entries;
    for (const lessons::Parameter &parameter : step.parameters) {
        const double value = script.values[parameter.id.toStdString()];
        if (value == parameter.defaultValue)
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

QString placeFields(sim::Vec2 at)
{
    return ", \"x\": " + jsonNumber(at.x) + ", \"y\": " + jsonNumber(at.y);
}

QString truthField(const char *name, bool value)
{
    return QStringLiteral(", \"%1\": %2").arg(QLatin1String(name), QLatin1String(value ? "true" : "false"));
}

QString keyName(bool sim::Keys::*key)
{
    for (const KeyName &one : keyNames()) {
        if (one.key == key)
            return one.name;
    }
    return {};
}

/// An event from its kind on, by what it is.
struct EventText
{
    const lessons::Step &step;

    QString operator()(const sim::Grab &grab) const { return "\"grab\", \"body\": " + jsonText(grab.body); }
    QString operator()(const sim::Move &move) const { return "\"move\"" + placeFields(move.to); }
    QString operator()(const sim::Release &) const { return QStringLiteral("\"release\""); }
    QString operator()(const sim::Pointer &pointer) const
    {
        return "\"pointer\"" + placeFields(pointer.at) + truthField("down", pointer.down);
    }
    QString operator()(const sim::Target &target) const { return "\"target\"" + placeFields(target.at); }
    QString operator()(const sim::Gust &gust) const
    {
        return "\"gust\", \"degrees\": " + jsonNumber(gust.degrees);
    }
    QString operator()(const sim::Key &key) const
    {
        return "\"key\", \"key\": " + jsonText(keyName(key.key)) + truthField("down", key.down);
    }
    QString operator()(const sim::Set &set) const
    {
        const QString number = jsonNumber(set.value);
        const QString id = QString::fromStdString(set.parameter);
        const lessons::Parameter *parameter = step.parameter(id);
        return "\"set\", \"parameter\": " + jsonText(id) +
               ", \"value\": " + (parameter ? parameterText(*parameter, set.value) : number);
    }
};

QString eventEntry(const sim::Event &event, const lessons::Step &step)
{
    return "{ \"frame\": " + QString::number(event.frame) +
           ", \"event\": " + std::visit(EventText{step}, event.what) + " }";
}

QStringList linkEntries(const sim::Script &script)
{
    QStringList entries;
    if (!script.values.sticks)
        return entries;
    const auto end = [](int point) { return jsonText(QStringLiteral("p%1").arg(point)); };
    for (const sim::Stick &stick : *script.values.sticks)
        entries.push_back("{ \"a\": " + end(stick.a) + ", \"b\": " + end(stick.b) + ", \"length\": " +
                          jsonNumber(stick.length) + ", \"share\": " + jsonNumber(stick.share) + " }");
    return entries;
}

/// The events that do something. A parameter that was changed in the past can leave others without effect: a
/// body that is taken hold of later may be gone now. What a file has must make sense to who reads it. Those before frame
/// `from` are left out.
QStringList inputEntries(const sim::Script &script, const lessons::Step &step, std::int64_t from = 0)
{
    QStringList entries;
    std::vector<sim::Event> input = script.input;
    sim::sortByFrame(input);
    walkInput(
        script, input, [](const sim::Scene &, int) {},
        [&](int index, EventEffect effect) {
            const sim::Event &event = input[std::size_t(index)];
            if (event.frame < from)
                return;
            if (effect == EventEffect::works)
                entries.push_back(eventEntry(event, step));
            else if (effect == EventEffect::onlyLetsGo)
                entries.push_back(eventEntry({event.frame, sim::Release{}}, step));
        });
    return entries;
}

void writeStep(sim::StepSize step, Writer &writer)
{
    if (step.isAdaptive())
        writer.field("tolerance", jsonNumber(step.tolerance));
    else
        writer.field("h", jsonNumber(step.h));
}

/// What differs in a run from the step's own.
void writeRun(const sim::Script &script, std::int64_t frames, const lessons::Step &step, Writer &writer)
{
    const sim::Script untouched = step.script();
    if (script.method->id() != untouched.method->id())
        writer.field("method", jsonText(script.method->id()));
    const sim::Script opened = step.prepareScript ? step.scriptWith(script.values, script.method) : untouched;
    if (script.step != sim::stepFor(*script.method, opened.step))
        writeStep(script.step, writer);
    writer.field("frames", QString::number(frames));
    if (script.values.seed != untouched.values.seed)
        writer.field("seed", QString::number(script.values.seed));
    QStringList effects;
    for (const std::string &id : script.effectsOff)
        effects.push_back(jsonText(id));
    if (!effects.isEmpty())
        writer.field("effects", '[' + effects.join(", ") + ']');
    writer.block("parameters", "{}", parameterEntries(script, step));
    if (script.values.blueprint)
        writer.field("scene", blueprintText(*script.values.blueprint));
    writer.block("bodies", "{}", bodyEntries(script));
    if (script.values.sticks && script.values.sticks->empty())
        writer.field("links", "[]");
    writer.block("links", "[]", linkEntries(script));
    const QStringList input = inputEntries(script, step);
    if (input.isEmpty() && !opened.input.empty())
        writer.field("input", "[]");
    if (script.input != opened.input)
        writer.block("input", "[]", input);
}

/// Whether the learner gave it that name, and whether it is kept, where that is not so.
void writeName(const QString &name, bool isNamed, bool isKept, Writer &writer)
{
    writer.field("name", jsonText(name.left(longestRunName)));
    if (!isNamed)
        writer.field("named", "false");
    if (!isKept)
        writer.field("kept", "false");
}

/// The first frame of the row from which a branch is another run than `own`; 0 where nothing is shared.
std::int64_t forkOf(const sim::Script &branch, const sim::Script &own)
{
    const std::int64_t row = own.step.framesPerOutput;
    const std::int64_t first = std::min(firstDifferent(branch, own), mostFrames);
    const std::int64_t before = (first + row - 1) / row - 1; ///< rows that both share
    return before > 0 ? before * row + 1 : 0;
}

QString branchEntry(const Branch &branch, const sim::Script &own, const lessons::Step &step)
{
    Writer writer;
    writeName(branch.name, branch.isNamed, branch.isKept, writer);
    const std::int64_t frames = std::min(branch.end, mostFrames);
    const std::int64_t fork = forkOf(*branch.script, own);
    if (fork > 0) {
        writer.field("fork", QString::number(fork));
        writer.field("frames", QString::number(frames));
        writer.block("input", "[]", inputEntries(*branch.script, step, fork));
    } else {
        writeRun(*branch.script, frames, step, writer);
    }
    return writer.text().replace('\n', "\n  ");
}

QStringList branchEntries(const Branches &branches, const sim::Script &own, const lessons::Step &step)
{
    QStringList entries;
    std::size_t events = 0;
    for (const Branch &branch : branches.all()) {
        events += branch.script->input.size();
        entries.push_back(branchEntry(branch, own, step));
    }
    if (branches.all().size() > mostKeptBranches || events > mostBranchEvents)
        throw Refusal(
            Text::tr("Not saved: there are more runs beside this one than a file can have: %1 with %2 "
                     "events together. Delete some that you named or keep, in “Runs”.")
                .arg(mostKeptBranches)
                .arg(mostBranchEvents));
    return entries;
}

}

QByteArray experimentText(const Experiment &experiment, const LessonLibrary &library)
{
    const LessonEntry *lesson = library.lesson(experiment.lesson);
    const lessons::Step *step = lesson ? lesson->step(experiment.step) : nullptr;
    if (!step)
        throw Refusal(
            Text::tr("Not saved: the step %1 is not installed any more.").arg(quoted(experiment.step)));
    Writer writer;
    writer.field("format", jsonText(QStringLiteral("springstep-experiment/1")));
    writer.field("lesson", jsonText(experiment.lesson));
    writer.field("step", jsonText(experiment.step));
    const Branches branches = experiment.branches.marked();
    const OwnRun &own = branches.own();
    if (const QString name = own.name.isEmpty() ? own.made : own.name; own.isKept || !own.name.isEmpty())
        writeName(name, !own.name.isEmpty(), own.isKept, writer);
    writeRun(experiment.script, experiment.frames, *step, writer);
    writer.block("branches", "[]", branchEntries(branches, experiment.script, *step));
    QByteArray text = (writer.text() + '\n').toUtf8();
    if (text.size() > largestExperiment || !hasFewEnoughValues(text))
        throw Refusal(
            Text::tr("Not saved: the run has more input than a file can have. Start it again, or go back and "
                     "change it earlier."));
    return text;
}

}
