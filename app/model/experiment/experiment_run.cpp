#include "app/model/experiment/experiment_run.h"

#include "app/model/experiment/blueprint_reader.h"
#include "app/model/experiment/experiment.h"
#include "app/model/experiment/experiment_input.h"
#include "app/model/experiment/experiment_method.h"
#include "app/model/experiment/experiment_points.h"
#include "app/model/experiment/input_walk.h"
#include "app/model/experiment/parameter_value.h"
#include "app/model/text/quoting.h"
#include "app/model/text/sentences.h"
#include "sim/pipeline/pipeline.h"
#include "sim/scene/scene.h"

#include <QCoreApplication>

#include <map>
#include <set>

namespace app {

namespace {

constexpr std::int64_t mostSeed = std::int64_t{1}
                                  << 53; ///< the largest number up to which every JSON reader is exact

/// A reader of a run from a file, field by field.
class RunReader
{
    Q_DECLARE_TR_FUNCTIONS(Experiment)

public:
    RunReader(const QString &file, const JsonFields &fields, const lessons::Step &step)
        : m_file(file), m_fields(fields), m_step(step)
    {
    }

    ReadRun read()
    {
        script() = m_step.script();
        refuseWhatNoStepHas();
        readMethod(m_fields, script());
        readParameters();
        readScene();
        openRun();
        readPoints();
        compileCode();
        readFrames();
        if (const JsonValue *input = m_fields.find("input"))
            m_events = readInput(m_file, *input, m_step);
        takeInput();
        walk();
        readEffects();
        readBodies();
        moveBuiltBodies();
        composeAll();
        return m_run;
    }

    ReadRun readFrom(const sim::Script &base, std::int64_t fork)
    {
        script() = base;
        readFrames();
        for (const sim::Event &event : base.input) {
            if (event.frame < fork)
                m_events.push_back({event, m_fields.line()});
        }
        if (const JsonValue *input = m_fields.find("input")) {
            const std::vector<ReadEvent> own = readInput(m_file, *input, m_step);
            if (!own.empty() && own.front().event.frame < fork)
                refuse(m_file, own.front().line,
                       tr("frame %1 is before the start of the branch, whose \"fork\" is %2; use frame %2 or "
                          "a later one.")
                           .arg(own.front().event.frame)
                           .arg(fork));
            m_events.insert(m_events.end(), own.begin(), own.end());
        }
        takeInput();
        walk();
        composeAll();
        return m_run;
    }

private:
    sim::Script &script() { return m_run.script; }

    void readFrames() { m_run.frames = m_fields.integer("frames", 0, mostFrames, m_run.frames); }

    void takeInput()
    {
        script().input.clear();
        for (const ReadEvent &read : m_events)
            script().input.push_back(read.event);
    }

    void refuseWhatNoStepHas() const
    {
        const bool isBuilt = m_step.points == lessons::PointSource::scene;
        if (const JsonValue *scene = m_fields.find("scene"); scene && !isBuilt)
            m_fields.refuse(
                "scene",
                tr("\"scene\" does not go with a lesson's step, which has its own; remove it, and change "
                   "that "
                   "one by \"parameters\", \"bodies\" and \"effects\"."));
        const JsonValue *links = m_fields.find("links");
        if (links && isBuilt)
            m_fields.refuse(
                "links",
                tr("the step %1 has its sticks in \"scene\"; move \"links\" there and call it \"sticks\".")
                    .arg(quoted(m_step.id)));
        if (links && m_step.points != lessons::PointSource::file && !listOf(m_file, *links, "links").empty())
            m_fields.refuse("links",
                            tr("the step %1 has no sticks; remove \"links\".").arg(quoted(m_step.id)));
    }

    void readParameters()
    {
        std::uint64_t &seed = script().values.seed;
        seed = std::uint64_t(m_fields.integer("seed", 0, mostSeed, std::int64_t(seed)));
        const JsonValue *parameters = m_fields.find("parameters");
        if (!parameters)
            return;
        for (const auto &[id, value] : JsonFields(m_file, *parameters, quoted("parameters")).all()) {
            const lessons::Parameter &parameter = parameterOf(m_file, value.line, m_step, id);
            script().values.set(id.toStdString(), parameterValue(m_file, value, parameter));
        }
    }

    /// Prepares the start of the step's run with the file's values. The file's own fields take precedence.
    void openRun()
    {
        if (!m_step.prepareScript)
            return;
        sim::Script opened = m_step.scriptWith(script().values, script().method);
        if (!m_fields.find("h") && !m_fields.find("tolerance"))
            script().step = opened.step;
        script().bodies = opened.bodies;
        script().input = m_fields.find("input") ? std::vector<sim::Event>() : std::move(opened.input);
        for (const sim::Event &event : script().input)
            m_events.push_back({event, m_fields.line()});
    }

    /// Reads the whole scene, if the step takes one.
    void readScene()
    {
        if (const JsonValue *scene = m_fields.find("scene"))
            script().values.blueprint =
                std::make_shared<const sim::Blueprint>(readBlueprint(m_file, *scene, m_step));
    }

    /// Reads the file's own points and sticks, if the step takes them. Scenes are built from them.
    void readPoints()
    {
        if (m_step.points != lessons::PointSource::file)
            return;
        const JsonValue *bodies = m_fields.find("bodies");
        if (bodies && countPoints(m_file, *bodies) > 0)
            script().values.points = countPoints(m_file, *bodies);
        const JsonValue *links = m_fields.find("links");
        if (!links)
            return;
        const auto own = [this] { return script().build(script().values).start.pointCount(); };
        const std::optional<int> &given = script().values.points;
        script().values.sticks = readSticks(m_file, *links, given ? *given : own());
    }

    void compileCode()
    {
        try {
            readCode(m_fields, m_step.listing, script());
        } catch (const sim::Error &error) { // of the scene
            refuse(m_file, m_fields.line(), sentenceFor(error));
        }
    }

    /// Walks through the input, and collects the bodies and effects of the run's scenes.
    void walk()
    {
        const auto newScene = [this](const sim::Scene &scene, int) {
            if (m_names.empty())
                m_startNames = scene.names;
            if (scene.names != m_sceneNames)
                m_names.insert(scene.names.begin(), scene.names.end());
            for (const sim::EffectPtr &effect : scene.effects)
                m_effects.insert(effect->id());
            m_sceneNames = scene.names;
        };
        const auto each = [this](int index, EventEffect effect) {
            if (effect != EventEffect::works)
                refuseEvent(m_events[std::size_t(index)], effect);
        };
        try {
            walkInput(script(), script().input, newScene, each);
        } catch (const SceneRefused &refused) {
            const int line = refused.event < 0 ? m_fields.line() : m_events[std::size_t(refused.event)].line;
            refuse(m_file, line, sentenceFor(refused));
        }
    }

    [[noreturn]] void refuseEvent(const ReadEvent &read, EventEffect effect) const
    {
        if (effect != EventEffect::nothingHeld) {
            const std::string &body = std::get<sim::Grab>(read.event.what).body;
            refuse(m_file, read.line, noBody(body, m_sceneNames));
        }
        const QString event = std::holds_alternative<sim::Move>(read.event.what) ? "move" : "release";
        refuse(m_file, read.line,
               tr("nothing is held at frame %1; a %2 comes after a \"grab\".")
                   .arg(QString::number(read.event.frame), quoted(event)));
    }

    void readEffects()
    {
        const JsonValue *effects = m_fields.find("effects");
        if (!effects)
            return;
        for (const JsonValue &value : listOf(m_file, *effects, "effects")) {
            const QString id = textOf(m_file, value, "effects");
            if (!m_effects.contains(id.toStdString()))
                refuse(m_file, value.line,
                       tr("the step %1 has no effect %2; it has %3.")
                           .arg(quoted(m_step.id), quoted(id), listed(m_effects, id)));
            script().effectsOff.push_back(id.toStdString());
        }
    }

    void readBodies()
    {
        const JsonValue *bodies = m_fields.find("bodies");
        if (!bodies)
            return;
        for (const auto &[name, value] : JsonFields(m_file, *bodies, quoted("bodies")).all()) {
            if (!m_names.contains(name.toStdString()))
                refuse(m_file, value.line, noBody(name.toStdString(), m_startNames));
            const JsonFields body(m_file, value, tr("the body %1").arg(quoted(name)));
            body.refuseOthers({"x", "y", "vx", "vy"});
            sim::BodyStart start{{body.number("x"), body.number("y")}, {}};
            const bool hasX = body.find("vx");
            const bool hasY = body.find("vy");
            if (hasX || hasY)
                start.v = {hasX ? body.number("vx") : 0.0, hasY ? body.number("vy") : 0.0};
            script().bodies[name.toStdString()] = start;
        }
    }

    /// Moves bodies of a built scene to their starts in "bodies", so that the learner can move them.
    void moveBuiltBodies()
    {
        if (!script().values.blueprint)
            return;
        sim::Blueprint plan = *script().values.blueprint;
        for (sim::BlueprintPoint &point : plan.points) {
            const auto start = script().bodies.find(point.name);
            if (start == script().bodies.end())
                continue;
            point.x = start->second.x;
            point.v = start->second.v.value_or(point.v);
        }
        script().values.blueprint = std::make_shared<const sim::Blueprint>(std::move(plan));
        script().bodies.clear();
    }

    /// Composes the scene of every interval of the run, so that no error appears in the middle of it. Each set of
    /// values is composed once.
    void composeAll()
    {
        sim::Values values = script().values;
        compose(values, m_fields.line());
        std::set<std::map<std::string, double>> composed = {values.all()};
        const ReadEvent *last = nullptr; // last change of the current output step
        const auto endRow = [&] {
            if (last && composed.insert(values.all()).second)
                compose(values, last->line);
        };
        for (const ReadEvent &read : m_events) {
            const auto *set = std::get_if<sim::Set>(&read.event.what);
            if (!set)
                continue;
            if (last && rowOf(*last) != rowOf(read))
                endRow();
            values.set(set->parameter, set->value);
            last = &read;
        }
        endRow();
    }

    std::int64_t rowOf(const ReadEvent &read)
    {
        return sim::outputStepEnd(read.event.frame, script().step.framesPerOutput);
    }

    void compose(const sim::Values &values, int line)
    {
        try {
            sim::compose(sim::sceneOf(script(), values), *script().method, script().step);
        } catch (const sim::Error &error) {
            refuse(m_file, line, sentenceFor(error));
        }
    }

    static QString noBody(const std::string &body, const std::vector<std::string> &names)
    {
        return tr("there is no body %1 here; there is %2.")
            .arg(quoted(QString::fromStdString(body)), listed(names, QString::fromStdString(body)));
    }

    template <class Texts>
    static QString listed(const Texts &texts, const QString &given)
    {
        QStringList list;
        for (const std::string &text : texts)
            list.push_back(QString::fromStdString(text));
        return quotedList(list, given);
    }

    const QString &m_file;
    const JsonFields &m_fields;
    const lessons::Step &m_step;
    ReadRun m_run;
    std::vector<ReadEvent> m_events;
    std::vector<std::string> m_startNames; ///< bodies at the start
    std::vector<std::string> m_sceneNames; ///< bodies at the current place of walk()
    std::set<std::string> m_names;         ///< bodies at any time
    std::set<std::string> m_effects;       ///< effects at any time
};

}

const QStringList &runFields()
{
    static const QStringList names = {"method", "code",       "h",      "tolerance", "effects", "scene",
                                      "frames", "parameters", "bodies", "links",     "seed",    "input"};
    return names;
}

ReadRun readRun(const QString &file, const JsonFields &fields, const lessons::Step &step)
{
    return RunReader(file, fields, step).read();
}

ReadRun readRunFrom(const QString &file, const JsonFields &fields, const lessons::Step &step,
                    const sim::Script &base, std::int64_t fork)
{
    return RunReader(file, fields, step).readFrom(base, fork);
}

}
