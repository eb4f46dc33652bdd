#include "app/model/lesson_folders/lesson_step.h"

#include "app/model/breakpoints/condition.h"
#include "app/model/breakpoints/condition_names.h"
#include "app/model/breakpoints/condition_tokens.h"
#include "app/model/learning/run_setup.h"
#include "app/model/text/sentences.h"
#include "app/model/text/user_error.h"
#include "lessons/api/view/view.h"
#include "sim/base/error.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"
#include "sim/scene/scene.h"

#include <QCoreApplication>
#include <QSet>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace app {

namespace {

/// The parts of a scene that are not parameters. A step of a lesson without C++ has them from its scene file.
struct OwnScene
{
    std::shared_ptr<const sim::Blueprint> blueprint;
    std::optional<int> points;
    std::optional<std::vector<sim::Stick>> sticks;
    std::vector<ParameterTarget> targets; ///< numbers of the blueprint that parameters set

    bool isThere() const { return blueprint || points || sticks; }

    sim::Values with(sim::Values values) const
    {
        values.blueprint = blueprintWith(blueprint, targets, values);
        values.points = points;
        values.sticks = sticks;
        return values;
    }
};

void useOwnScene(lessons::Step &step, const OwnScene &own)
{
    step.scene = [scene = step.scene, own](const sim::Values &values) { return scene(own.with(values)); };
    step.view = [view = step.view, own](const sim::Scene &scene, const sim::Values &values) {
        return view(scene, own.with(values));
    };
    if (step.overlays)
        step.overlays = [overlays = step.overlays, own](const sim::Scene &scene, const sim::State &state,
                                                        const sim::Values &values) {
            return overlays(scene, state, own.with(values));
        };
    step.points = lessons::PointSource::step;
}

/// Only a rule of a sandbox scene reads input besides dragging.
std::vector<lessons::Interaction> interactionsOf(const lessons::Step &base, const OwnScene &own)
{
    const bool hasRule = own.blueprint && own.blueprint->rule;
    return own.blueprint && !hasRule ? std::vector{lessons::Interaction::drag} : base.interactions;
}

void beginWith(lessons::Step &step, const sim::Script &script)
{
    for (lessons::Parameter &parameter : step.parameters) {
        parameter.defaultValue = script.values[parameter.id.toStdString()];
        parameter.sliderMin = std::min(parameter.sliderMin, parameter.defaultValue);
        parameter.sliderMax = std::max(parameter.sliderMax, parameter.defaultValue);
    }
    step.method = QString::fromStdString(script.method->id());
    if (!script.step.isAdaptive())
        step.h = script.step.h;
    // The start of the sandbox step is a scene of its own.
    const auto before = step.points == lessons::PointSource::scene ? nullptr : step.prepareScript;
    step.prepareScript = [before, script](sim::Script &opened) {
        if (before)
            before(opened);
        for (const auto &[name, start] : script.bodies)
            opened.bodies[name] = start;
        if (opened.values.seed == sim::Values().seed)
            opened.values.seed = script.values.seed;
        if (opened.method->id() == script.method->id() && script.step.isAdaptive())
            opened.step = script.step;
        opened.effectsOff = script.effectsOff;
        opened.input = script.input;
    };
}

using Choices = std::map<QString, QStringList>;

ConditionNames namesIn(const sim::Timeline &run, const Choices &choices)
{
    return {run.track().interval().scene, run.values(), run.track().nextInterval()->pipeline, choices, {}};
}

ConditionMoment momentOf(const sim::Timeline &run)
{
    const sim::Phase &next = run.track().nextInterval()->pipeline.phaseAt(run.cursor().phase);
    return {run.state(), run.cursor().frame, &next, {}, &run.track()};
}

/// Returns the text left of the sign if `condition` is one comparison; otherwise nothing.
QString comparedIn(const QString &condition)
{
    static const QSet<QString> comparisons = {"<", "<=", ">", ">=", "==", "!="};
    static const QSet<QString> joins = {"and", "or", "not"};
    QString left;
    for (const ConditionToken &word : conditionWords(condition)) {
        if (word.kind == ConditionToken::Kind::sign && joins.contains(word.text))
            return {};
        if (word.kind == ConditionToken::Kind::sign && comparisons.contains(word.text))
            left = condition.left(word.place - 1).trimmed();
    }
    return left;
}

/// Makes a condition of a thing to try from a line of its document.
class ConditionMaker
{
    Q_DECLARE_TR_FUNCTIONS(LessonStepText)

public:
    ConditionMaker(const lessons::Document &document, const lessons::Step &step)
        : m_document(document), m_choices(condition_names::choicesOf(step)), m_run(step.script(), 0)
    {
    }

    lessons::Condition make(const lessons::ListItem &item, const lessons::TryText &text) const
    {
        try {
            Condition::parse(item.value, namesIn(m_run, m_choices));
        } catch (const UserError &error) {
            throw lessons::DocumentError(m_document.file, item.line, error.sentence());
        }
        lessons::Condition condition;
        condition.holds = [said = item.value, choices = m_choices](const sim::Timeline &run) {
            try {
                return Condition::parse(said, namesIn(run, choices)).holds(momentOf(run));
            } catch (const UserError &) {
                return false; // a name in it does not exist under this method
            }
        };
        if (!text.missing.contains(item.name))
            return condition;
        condition.sentence = item.name;
        if (text.missing[item.name].contains(QStringLiteral("%1")))
            condition.measured = measuredBy(item);
        return condition;
    }

private:
    std::function<double(const sim::Timeline &)> measuredBy(const lessons::ListItem &item) const
    {
        const QString number = comparedIn(item.value);
        if (number.isEmpty())
            throw lessons::DocumentError(
                m_document.file, item.line,
                tr("%1 stands for a number, and this condition does not compare one. Write a "
                   "comparison with the number on its left, or a sentence without %1."));
        return [number, choices = m_choices](const sim::Timeline &run) {
            try {
                return MomentNumber::parse(number, namesIn(run, choices)).at(momentOf(run));
            } catch (const UserError &) {
                return std::numeric_limits<double>::quiet_NaN();
            }
        };
    }

    const lessons::Document &m_document;
    Choices m_choices;
    sim::Timeline m_run;
};

/// Calls `check`, and names the line of `document` if it throws.
template <class Check>
void atLine(const lessons::Document &document, int line, const Check &check)
{
    try {
        check();
    } catch (const UserError &error) {
        throw lessons::DocumentError(document.file, line, error.sentence());
    } catch (const sim::Error &error) {
        throw lessons::DocumentError(document.file, line, sentenceFor(error));
    }
}

/// Returns a run as `setup` says, without its drags, whose bodies are checked only: to know where a hand takes them, all frames
/// before would have to be computed.
FollowedRun openedRun(lessons::RunSetup setup, const lessons::Step &step)
{
    const std::vector<lessons::RunSetup::Drag> drags = std::exchange(setup.drags, {});
    FollowedRun run(step, scriptFor(setup, step));
    for (const lessons::RunSetup::Drag &drag : drags)
        run.point(drag.body);
    return run;
}

void checkPrediction(const lessons::Prediction &prediction, const lessons::Step &step)
{
    const FollowedRun run = openedRun(prediction.run, step);
    if (!prediction.run.until.isEmpty())
        run.condition(prediction.run.until);
    if (prediction.question.kind == lessons::Question::Kind::place)
        run.point(prediction.question.of);
    else if (!prediction.question.asksFrames())
        run.number(prediction.question.of);
    for (const lessons::RunSetup &other : prediction.otherCurves)
        openedRun(other, step);
}

}

lessons::Step stepOf(const QString &id, const lessons::Step &base, const Experiment &scene,
                     const std::vector<lessons::Parameter> &declared,
                     const std::vector<ParameterTarget> &targets)
{
    const sim::Values &values = scene.script.values;
    const OwnScene own{values.blueprint, values.points, values.sticks, targets};
    lessons::Step step = base;
    step.parameters.insert(step.parameters.begin(), declared.begin(), declared.end());
    step.lesson.clear(); // its documents are not embedded
    step.id = id;
    step.interactions = interactionsOf(base, own);
    step.checks.clear();
    step.tries.clear();
    step.codeTasks.clear();
    step.predictions.clear();
    step.presets.clear();
    step.examples.clear();
    step.companion.reset();
    step.availableEffects.clear();
    beginWith(step, scene.script);
    if (step.method != base.method || step.h != base.h)
        step.listing = {}; // it belongs to the other method
    if (own.isThere())
        useOwnScene(step, own);
    return step;
}

std::vector<lessons::Check> checksOf(const lessons::Document &document, const lessons::Step &step)
{
    std::vector<lessons::Check> checks;
    if (document.tries.empty())
        return checks;
    const ConditionMaker maker(document, step);
    for (const lessons::TryText &text : document.tries) {
        if (text.doneWhen.empty())
            throw lessons::DocumentError(
                document.file, text.line,
                ConditionMaker::tr("nothing says when the thing to try “%1” is done. Write a “### Done when” "
                                   "with a list, as in “- pulled: released(%2)”.")
                    .arg(text.id, QString::fromStdString(step.scene(step.defaultValues()).names.front())));
        std::vector<lessons::Condition> conditions;
        for (const lessons::ListItem &item : text.doneWhen)
            conditions.push_back(maker.make(item, text));
        checks.push_back({text.id, lessons::Conditions(std::move(conditions))});
    }
    return checks;
}

void checkRuns(const lessons::Document &document, const lessons::Step &step)
{
    for (const lessons::Prediction &prediction : document.predictions)
        atLine(document, prediction.run.line, [&] { checkPrediction(prediction, step); });
    for (const lessons::TryText &text : document.tries) {
        if (text.solution.line > 0)
            atLine(document, text.solution.line, [&] { openedRun(text.solution, step); });
    }
}

}
