#include "app/model/experiment/experiment.h"

#include "app/listing/limits.h"
#include "app/model/experiment/blueprint_writer.h"
#include "app/model/experiment/experiment_events.h"
#include "app/model/experiment/input_walk.h"
#include "app/model/experiment/parameter_value.h"
#include "app/model/run/run_program.h"
#include "app/model/text/json_writer.h"
#include "app/model/text/quoting.h"
#include "sim/methods/methods.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {

namespace {

struct ExperimentWriterText
{
    Q_DECLARE_TR_FUNCTIONS(ExperimentWriterText)
};

using Layout = JsonWriter::Layout;

QString pointName(int point)
{
    return QStringLiteral("p%1").arg(point);
}

QString keyName(bool sim::Keys::*key)
{
    for (const KeyName &one : keyNames()) {
        if (one.key == key)
            return one.name;
    }
    return {};
}

void writePlace(sim::Vec2 at, JsonWriter &json)
{
    json.field("x", at.x);
    json.field("y", at.y);
}

void writeParameters(const sim::Script &script, const lessons::Step &step, JsonWriter &json)
{
    const auto differs = [&](const lessons::Parameter &parameter) {
        return script.values[parameter.id.toStdString()] != parameter.defaultValue;
    };
    if (std::none_of(step.parameters.begin(), step.parameters.end(), differs))
        return;
    json.beginObject("parameters");
    for (const lessons::Parameter &parameter : step.parameters) {
        if (!differs(parameter))
            continue;
        json.name(parameter.id);
        writeParameterValue(parameter, script.values[parameter.id.toStdString()], json);
    }
    json.endObject();
}

void writeBodies(const sim::Script &script, JsonWriter &json)
{
    if (script.bodies.empty())
        return;
    json.beginObject("bodies");
    for (const auto &[name, start] : script.bodies) {
        json.beginObject(QString::fromStdString(name), Layout::oneLine);
        writePlace(start.x, json);
        if (start.v) {
            json.field("vx", start.v->x);
            json.field("vy", start.v->y);
        }
        json.endObject();
    }
    json.endObject();
}

void writeLinks(const sim::Script &script, JsonWriter &json)
{
    if (!script.values.sticks)
        return;
    json.beginList("links");
    for (const sim::Stick &stick : *script.values.sticks) {
        json.beginObject(Layout::oneLine);
        json.field("a", pointName(stick.a));
        json.field("b", pointName(stick.b));
        json.field("length", stick.length);
        json.field("share", stick.share);
        json.endObject();
    }
    json.endList();
}

/// A writer of an event's kind and its fields.
struct EventFields
{
    const lessons::Step &step;
    JsonWriter &json;

    void operator()(const sim::Grab &grab) const
    {
        json.field("event", "grab");
        json.field("body", grab.body);
    }
    void operator()(const sim::Move &move) const
    {
        json.field("event", "move");
        writePlace(move.to, json);
    }
    void operator()(const sim::Release &) const { json.field("event", "release"); }
    void operator()(const sim::Pointer &pointer) const
    {
        json.field("event", "pointer");
        writePlace(pointer.at, json);
        json.field("down", pointer.down);
    }
    void operator()(const sim::Target &target) const
    {
        json.field("event", "target");
        writePlace(target.at, json);
    }
    void operator()(const sim::Gust &gust) const
    {
        json.field("event", "gust");
        json.field("degrees", gust.degrees);
    }
    void operator()(const sim::Key &key) const
    {
        json.field("event", "key");
        json.field("key", keyName(key.key));
        json.field("down", key.down);
    }
    void operator()(const sim::Set &set) const
    {
        json.field("event", "set");
        json.field("parameter", set.parameter);
        json.name("value");
        if (const auto *parameter = step.parameter(QString::fromStdString(set.parameter)))
            writeParameterValue(*parameter, set.value, json);
        else
            json.value(set.value);
    }
};

void writeInput(const std::vector<sim::Event> &input, const lessons::Step &step, JsonWriter &json)
{
    json.beginList("input");
    for (const sim::Event &event : input) {
        json.beginObject(Layout::oneLine);
        json.field("frame", event.frame);
        std::visit(EventFields{step, json}, event.what);
        json.endObject();
    }
    json.endList();
}

/// Returns the events that have an effect, from frame `from` on. A changed parameter can make later events useless:
/// the body that one grabs may no longer exist. Readers of the file should not see such events.
std::vector<sim::Event> effectiveInput(const sim::Script &script, std::int64_t from = 0)
{
    std::vector<sim::Event> effective;
    std::vector<sim::Event> input = script.input;
    sim::sortByFrame(input);
    walkInput(
        script, input, [](const sim::Scene &, int) {},
        [&](int index, EventEffect effect) {
            const sim::Event &event = input[std::size_t(index)];
            if (event.frame < from)
                return;
            if (effect == EventEffect::works)
                effective.push_back(event);
            else if (effect == EventEffect::onlyLetsGo)
                effective.push_back({event.frame, sim::Release{}});
        });
    return effective;
}

/// Writes how a run differs from the step's own run.
void writeRun(const sim::Script &script, std::int64_t frames, const lessons::Step &step, JsonWriter &json)
{
    const sim::Script untouched = step.script();
    if (script.method->id() != untouched.method->id())
        json.field("method", script.method->id());
    if (const auto program = programOf(script.method))
        json.field("code", program->text());
    const sim::Script opened = step.prepareScript ? step.scriptWith(script.values, script.method) : untouched;
    if (script.step != sim::stepFor(*script.method, opened.step))
        script.step.isAdaptive() ? json.field("tolerance", script.step.tolerance)
                                 : json.field("h", script.step.h);
    json.field("frames", frames);
    if (script.values.seed != untouched.values.seed)
        json.field("seed", script.values.seed);
    if (!script.effectsOff.empty()) {
        json.list("effects", script.effectsOff, Layout::oneLine);
    }
    writeParameters(script, step, json);
    if (script.values.blueprint) {
        json.name("scene");
        writeBlueprint(*script.values.blueprint, json);
    }
    writeBodies(script, json);
    writeLinks(script, json);
    // Input that has become useless is not written. An empty list means that the step's own input does not apply.
    const std::vector<sim::Event> input = effectiveInput(script);
    if (input.empty() ? !opened.input.empty() : script.input != opened.input)
        writeInput(input, step, json);
}

void writeDraft(const QString &draft, JsonWriter &json)
{
    if (draft.toStdString().size() > listing::maxTextBytes)
        throw UserError(
            ExperimentWriterText::tr("your code is longer than %1 bytes, the most that a file can store. "
                                     "Shorten it.")
                .arg(listing::maxTextBytes));
    json.field("draft", draft);
}

/// Writes the name of a run. Also writes whether the learner named it and whether it is kept, if either is false.
void writeName(const QString &name, bool isNamed, bool isKept, JsonWriter &json)
{
    json.field("name", name.left(longestRunName));
    if (!isNamed)
        json.field("named", false);
    if (!isKept)
        json.field("kept", false);
}

/// Returns the first frame of the output step in which `branch` first differs from `own`. Returns 0 if they share
/// nothing.
std::int64_t forkOf(const sim::Script &branch, const sim::Script &own)
{
    const std::int64_t row = own.step.framesPerOutput;
    const std::int64_t first = std::min(firstDifferent(branch, own), mostFrames);
    const std::int64_t before = (first + row - 1) / row - 1; ///< output steps that both share
    return before > 0 ? before * row + 1 : 0;
}

void writeBranch(const Branch &branch, const sim::Script &own, const lessons::Step &step, JsonWriter &json)
{
    json.beginObject();
    writeName(branch.name, branch.isNamed, branch.isKept, json);
    const std::int64_t frames = std::min(branch.end, mostFrames);
    const std::int64_t fork = forkOf(*branch.script, own);
    if (fork > 0) {
        json.field("fork", fork);
        json.field("frames", frames);
        const std::vector<sim::Event> input = effectiveInput(*branch.script, fork);
        if (!input.empty())
            writeInput(input, step, json);
    } else {
        writeRun(*branch.script, frames, step, json);
    }
    json.endObject();
}

void writeBranches(const Branches &branches, const sim::Script &own, const lessons::Step &step,
                   JsonWriter &json)
{
    std::size_t events = 0;
    for (const Branch &branch : branches.all())
        events += branch.script->input.size();
    if (branches.all().size() > mostKeptBranches || events > mostBranchEvents)
        throw UserError(ExperimentWriterText::tr("the file would have too many other runs: it can have %1, "
                                                 "with %2 events together. Delete some in “Runs”.")
                            .arg(mostKeptBranches)
                            .arg(mostBranchEvents));
    if (branches.all().empty())
        return;
    json.beginList("branches");
    for (const Branch &branch : branches.all())
        writeBranch(branch, own, step, json);
    json.endList();
}

}

QByteArray experimentText(const Experiment &experiment, const LessonLibrary &library)
{
    const LessonEntry *lesson = library.lesson(experiment.lesson);
    const lessons::Step *step = lesson ? lesson->step(experiment.step) : nullptr;
    if (!step)
        throw UserError(
            ExperimentWriterText::tr("the step %1 is no longer installed. Install its lesson again.")
                .arg(quoted(experiment.step)));
    JsonWriter json(1);
    json.beginObject();
    json.field("format", "springstep-experiment/1");
    json.field("lesson", experiment.lesson);
    json.field("step", experiment.step);
    const Branches branches = experiment.branches.marked();
    const OwnRun &own = branches.own();
    if (const QString name = own.name.isEmpty() ? own.made : own.name; own.isKept || !own.name.isEmpty())
        writeName(name, !own.name.isEmpty(), own.isKept, json);
    writeRun(experiment.script, experiment.frames, *step, json);
    if (experiment.draft)
        writeDraft(*experiment.draft, json);
    writeBranches(branches, experiment.script, *step, json);
    json.endObject();
    if (!json.isFinite())
        throw UserError(ExperimentWriterText::tr("a number of this experiment is not finite, and a file "
                                                 "cannot store such a number. Go back to an earlier frame."));
    const QByteArray text = json.text() + '\n';
    if (text.size() > largestExperiment || !hasFewEnoughValues(text))
        throw UserError(ExperimentWriterText::tr("the run has more input than a file can store. Restart it, "
                                                 "or go back and continue from an earlier frame."));
    return text;
}

}
