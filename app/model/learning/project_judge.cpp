#include "app/model/learning/project_judge.h"

#include "app/model/breakpoints/condition.h"
#include "app/model/breakpoints/condition_names.h"
#include "app/model/breakpoints/condition_tokens.h"
#include "app/model/learning/project_numbers.h"
#include "app/model/learning/run_setup.h"
#include "app/model/run/run_program.h"
#include "app/model/sandbox/blueprint_edits.h"
#include "app/model/text/numbers.h"
#include "app/model/text/phrases.h"
#include "app/model/text/quoting.h"
#include "app/model/text/sentences.h"
#include "app/model/text/user_error.h"
#include "sim/base/error.h"
#include "sim/effects/all_effects.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

namespace {

using When = lessons::ProjectDemand::When;

constexpr std::size_t trialTrackBudget = 1 << 20; ///< bytes: the run is computed once, forwards
constexpr double roughly = 10.0;                  ///< smaller numbers are shown with more digits

/// Returns the names in a condition, each once.
QStringList namesInCondition(const QString &condition)
{
    QStringList names;
    for (const ConditionToken &word : conditionWords(condition)) {
        if (word.kind == ConditionToken::Kind::name && !names.contains(word.text))
            names << word.text;
    }
    return names;
}

/// Returns the point of a sandbox scene with this name; null if there is none.
const sim::BlueprintPoint *builtPoint(const sim::Values &values, const std::string &name)
{
    const auto found = values.blueprint ? pointCalled(*values.blueprint, name) : std::nullopt;
    return found ? &values.blueprint->points[std::size_t(*found)] : nullptr;
}

/// Judges a trial before and while its run is computed.
class Judge
{
    Q_DECLARE_TR_FUNCTIONS(ProjectJudge)

public:
    explicit Judge(const ProjectTrial &trial)
        : m_trial(trial), m_level(trial.level), m_met(m_level.demands.size(), false)
    {
        for (std::size_t i = 0; i < m_met.size(); ++i)
            m_met[i] = m_level.demands[i].when == When::always;
        m_failedAt.resize(m_met.size(), -1);
        m_measured.resize(m_met.size());
    }

    /// Returns what is wrong with the scene, before it runs. Empty: nothing.
    QString sentenceBeforeRun() const
    {
        if (m_trial.hasDraft)
            return tr("Not yet: the run does not use what you have written. Mend its mistakes first.");
        for (const QString &name : m_level.unchanged) {
            const QString sentence = sentenceIfChanged(name);
            if (!sentence.isEmpty())
                return sentence;
        }
        const sim::Scene scene = sim::sceneOf(m_trial.built, m_trial.built.values);
        for (const QString &id : m_level.effects) {
            if (std::none_of(scene.effects.begin(), scene.effects.end(),
                             [&](const sim::EffectPtr &one) { return one->id() == id.toStdString(); }))
                return tr("Not yet: this level needs %1. Switch it on.").arg(quoted(titleOf(id)));
        }
        for (const QString &body : bodiesOfLevel()) {
            if (scene.find(body.toStdString()) < 0)
                return noBody(body);
        }
        return {};
    }

    std::optional<ProjectVerdict> run(const std::function<void(int)> &report,
                                      const sim::ShouldContinue &shouldContinue)
    {
        const sim::Script script = judgedScript(m_trial);
        sim::Track track(script, trialTrackBudget);
        ProjectNumbers numbers(script, track.state());
        compile(script, track);
        look(track, numbers, 0);
        const int step = track.framesPerOutput();
        const int last = m_level.run.frames / step * step;
        int percent = 0;
        for (int frame = step; frame <= last; frame += step) {
            if ((shouldContinue && !shouldContinue()) || !track.seek({frame, 0}, shouldContinue))
                return std::nullopt;
            if (track.cursor().frame < frame)
                return stopped(track);
            look(track, numbers, frame);
            if (report && 100 * frame / last > percent)
                report(percent = 100 * frame / last);
        }
        return verdict();
    }

private:
    /// Returns the names of the bodies that the level is about.
    QStringList bodiesOfLevel() const
    {
        QStringList names;
        for (const lessons::RunSetup::Place &place : m_level.run.places)
            names << place.body;
        for (const lessons::RunSetup::Drag &drag : m_level.run.drags)
            names << drag.body;
        for (const lessons::ProjectDemand &demand : m_level.demands) {
            for (const QString &name : namesInCondition(demand.condition)) {
                if (name.contains('.'))
                    names << name.section('.', 0, -2);
            }
        }
        return names;
    }

    static QString titleOf(const QString &effect)
    {
        const sim::EffectDescription *found = sim::findDescription(sim::allEffects(), effect.toStdString());
        return found ? phrase(found->title) : effect;
    }

    static QString noBody(const QString &body)
    {
        return tr("Not yet: your scene has no body %1, which this level is about. Undo, or start again.")
            .arg(quoted(body));
    }

    QString sentenceIfChanged(const QString &name) const
    {
        const std::string id = name.toStdString();
        const sim::Values &start = m_trial.start.values, &built = m_trial.built.values;
        if (start.has(id)) {
            if (built.has(id) && built[id] == start[id])
                return {};
            const lessons::Parameter *parameter = m_trial.step->parameter(name);
            return tr("Not yet: this level asks you to leave %1 at %2.")
                .arg(quoted(parameter ? parameter->name : name), exactNumber(start[id]));
        }
        const sim::BlueprintPoint *was = builtPoint(start, id), *is = builtPoint(built, id);
        if (!was)
            throw UserError(QStringLiteral("%1: there is no parameter and no body “%2” in the start scene.")
                                .arg(m_level.id, name));
        if (!is)
            return noBody(name);
        if (*is == *was)
            return {};
        return tr("Not yet: this level asks you to leave %1 as it was: place, speed, mass and size. Undo, "
                  "or start again.")
            .arg(withinSentence(bodyTitle(name)));
    }

    void compile(const sim::Script &script, const sim::Track &track)
    {
        const std::shared_ptr<const sim::ComposedInterval> next = track.nextInterval();
        ConditionNames names{next->scene, script.values, next->pipeline,
                             condition_names::choicesOf(*m_trial.step)};
        for (const QString &number : projectNumbers())
            names.variables[number] = QStringLiteral("double");
        for (const lessons::ProjectDemand &demand : m_level.demands)
            m_conditions.push_back(Condition::parse(demand.condition, names));
    }

    /// Judges the moment after `frame`.
    void look(const sim::Track &track, const ProjectNumbers &numbers, std::int64_t frame)
    {
        const sim::Scene &scene = track.interval().scene;
        const ConditionMoment moment{
            track.state(), frame, nullptr,
            [&](const std::string &name) { return numbers.at(name, scene, track.state(), frame); }, &track};
        const bool isLast = frame + track.framesPerOutput() > m_level.run.frames;
        for (std::size_t i = 0; i < m_conditions.size(); ++i) {
            const When when = m_level.demands[i].when;
            const bool isSettled = when == When::always ? !m_met[i] : when == When::once && m_met[i];
            const bool isDue = when == When::always || when == When::once ||
                               (when == When::atTheStart ? frame == 0 : isLast);
            if (isSettled || !isDue)
                continue;
            m_met[i] = m_conditions[i].holds(moment);
            if (!m_met[i] && (when != When::once || isLast)) {
                m_failedAt[i] = frame;
                m_measured[i] = measured(m_level.demands[i].condition, scene, track.state(), numbers, frame);
            }
        }
    }

    /// Returns the numbers in a condition, for a sentence: "foot.x is 309.2, fastest is 0.3".
    static QString measured(const QString &condition, const sim::Scene &scene, const sim::State &state,
                            const ProjectNumbers &numbers, std::int64_t frame)
    {
        QStringList all;
        for (const QString &name : namesInCondition(condition)) {
            const std::optional<double> number = name.contains('.')
                                                     ? numberOfBody(name, scene, state)
                                                     : numbers.at(name.toStdString(), scene, state, frame);
            if (!number)
                continue;
            const int decimals = *number == std::round(*number) ? 0 : std::abs(*number) < roughly ? 3 : 1;
            all << tr("%1 is %2").arg(name, fixedNumber(*number, decimals));
        }
        return all.join(QStringLiteral(", "));
    }

    static std::optional<double> numberOfBody(const QString &name, const sim::Scene &scene,
                                              const sim::State &state)
    {
        const int point = scene.find(name.section('.', 0, -2).toStdString());
        const QString member = name.section('.', -1);
        if (point < 0)
            return std::nullopt;
        const sim::Vec2 at = state.positionOf(point);
        const Eigen::Index row = point;
        if (member == u"x" || member == u"y")
            return member == u"x" ? at.x : at.y;
        if (member == u"vx" || member == u"vy")
            return state.velocity(row, member == u"vx" ? 0 : 1);
        return std::nullopt;
    }

    ProjectVerdict stopped(const sim::Track &track) const
    {
        ProjectVerdict result;
        result.frame = track.cursor().frame;
        result.met.assign(m_met.size(), false);
        result.sentence =
            tr("Not yet: the run stops in frame %1. %2").arg(result.frame + 1).arg(endSentence(track));
        return result;
    }

    ProjectVerdict verdict() const
    {
        ProjectVerdict result;
        result.met = m_met;
        const auto failed = std::find(m_met.begin(), m_met.end(), false);
        if (failed == m_met.end())
            return result;
        const auto index = static_cast<std::size_t>(failed - m_met.begin());
        result.demand = static_cast<int>(index);
        result.frame = m_failedAt[index];
        result.sentence = sentenceAbout(index);
        return result;
    }

    QString sentenceAbout(std::size_t index) const
    {
        const lessons::ProjectDemand &demand = m_level.demands[index];
        const QString frame = QString::number(m_failedAt[index]), &numbers = m_measured[index];
        const QString said = numbers.isEmpty() ? demand.sentence : withRemark(demand.sentence, numbers);
        switch (demand.when) {
        case When::atTheStart:
            return tr("Not yet: at the start, this does not hold: %1.").arg(said);
        case When::always:
            return tr("Not yet: in frame %1, this does not hold: %2.").arg(frame, said);
        case When::once:
            return tr("Not yet: up to frame %1, this never happens: %2.").arg(frame, said);
        case When::atTheEnd:
            break;
        }
        return tr("Not yet: at the end, in frame %1, this does not hold: %2.").arg(frame, said);
    }

    const ProjectTrial &m_trial;
    const lessons::ProjectLevel &m_level;
    std::vector<Condition> m_conditions;
    std::vector<bool> m_met;
    std::vector<std::int64_t> m_failedAt; ///< -1: not yet
    std::vector<QString> m_measured;      ///< where it failed
};

}

sim::Script judgedScript(const ProjectTrial &trial)
{
    sim::Script script = trial.built;
    script.input = trial.step->scriptWith(script.values, script.method).input;
    return scriptWith(trial.level.run, *trial.step, std::move(script));
}

std::optional<ProjectVerdict> judgeProject(const ProjectTrial &trial, const std::function<void(int)> &report,
                                           const sim::ShouldContinue &shouldContinue)
{
    Judge judge(trial);
    try {
        const QString sentence = judge.sentenceBeforeRun();
        if (!sentence.isEmpty())
            return ProjectVerdict{.sentence = sentence};
        return judge.run(report, shouldContinue);
    } catch (const sim::Error &error) { // of the learner's scene with the changes of the level
        return ProjectVerdict{.sentence = Judge::tr("Not yet: %1").arg(sentenceFor(error))};
    }
}

}
