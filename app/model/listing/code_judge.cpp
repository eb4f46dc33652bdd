#include "app/model/listing/code_judge.h"

#include "app/listing/listing_method.h"
#include "app/listing/program.h"
#include "app/model/run/run_program.h"
#include "app/model/text/numbers.h"
#include "app/model/text/sentences.h"
#include "sim/methods/methods.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <variant>

namespace app {

namespace {

struct JudgeText
{
    Q_DECLARE_TR_FUNCTIONS(CodeJudge)
};

constexpr std::size_t judgeTrackBudget = 1 << 20; ///< bytes: the runs are computed once, forwards
constexpr int judgeTrials = 3;

/// The course of a hand that takes a body, moves it and lets go.
struct Stroke
{
    int begin = 0;       ///< frame of the grab
    int end = 0;         ///< frame of the release
    sim::Vec2 velocity;  ///< px/frame, at the grab
    double turn = 0.0;   ///< rad/frame: the hand moves on a curve
    int stillFrames = 0; ///< before the release the hand rests for so long; 0: it throws the body
};

using Strokes = std::array<Stroke, 2>;

// The hand moves in all directions. The second run begins with an undisturbed motion, and no body is thrown in the
// third one before the others had time to settle.
constexpr std::array<Strokes, judgeTrials> judgeStrokes = {{
    {{{4, 18, {16.0, 6.0}, 0.1, 0}, {40, 58, {-14.0, -9.0}, -0.08, 4}}},
    {{{30, 42, {-17.0, 5.0}, 0.05, 0}, {60, 74, {9.0, 14.0}, 0.12, 0}}},
    {{{2, 22, {-6.0, -14.0}, 0.15, 6}, {50, 60, {15.0, -8.0}, 0.0, 0}}},
}};

void addStroke(std::vector<sim::Event> &input, const std::string &body, sim::Vec2 hand, const Stroke &stroke)
{
    input.push_back({stroke.begin, sim::Grab{body}});
    double angle = std::atan2(stroke.velocity.y, stroke.velocity.x);
    const double speed = sim::length(stroke.velocity);
    for (int frame = stroke.begin; frame < stroke.end - stroke.stillFrames; ++frame) {
        hand = hand + speed * sim::Vec2{std::cos(angle), std::sin(angle)};
        angle += stroke.turn;
        input.push_back({frame, sim::Move{hand}});
    }
    input.push_back({stroke.end, sim::Release{}});
}

/// Adds input of the kinds besides dragging. The places are near `middle`.
void addOtherInput(std::vector<sim::Event> &input, const lessons::Step &step, sim::Vec2 middle, int trial)
{
    const double side = trial == 1 ? -1.0 : 1.0;
    if (step.accepts(lessons::Interaction::pointer)) {
        for (int i = 0; i < 8; ++i) {
            const double turn = side * 0.9 * i + trial;
            const sim::Vec2 at = middle + (60.0 + 25.0 * i) * sim::Vec2{std::cos(turn), std::sin(turn)};
            input.push_back({3 + 11 * i, sim::Pointer{at, i % 3 == trial}});
        }
    }
    if (step.accepts(lessons::Interaction::target)) {
        input.push_back({6, sim::Target{middle + sim::Vec2{side * 150.0, 90.0 - 60.0 * trial}}});
        input.push_back({45, sim::Target{middle + sim::Vec2{-side * 120.0, -80.0}}});
    }
    if (step.accepts(lessons::Interaction::gust)) {
        input.push_back({12, sim::Gust{side * 4.0}});
        input.push_back({48, sim::Gust{-side * 2.5}});
    }
    if (step.accepts(lessons::Interaction::keys)) {
        bool sim::Keys::*const along = side > 0.0 ? &sim::Keys::right : &sim::Keys::left;
        bool sim::Keys::*const across = trial == 2 ? &sim::Keys::down : &sim::Keys::up;
        input.push_back({8, sim::Key{along, true}});
        input.push_back({38, sim::Key{along, false}});
        input.push_back({38, sim::Key{across, true}});
        input.push_back({70, sim::Key{across, false}});
    }
}

/// Returns the choice of a run: the default one first, and then the following ones.
double judgedChoice(const lessons::Parameter &parameter, int trial)
{
    return static_cast<double>((std::lround(parameter.defaultValue) + trial) % parameter.choices.size());
}

/// Returns the whole number of a run: the default one, one more, and one less or, where that is too little, two more.
double judgedWhole(const lessons::Parameter &parameter, int trial)
{
    const double most = std::min(parameter.max, parameter.sliderMax),
                 least = std::max(parameter.min, parameter.sliderMin);
    if (trial == 1)
        return parameter.defaultValue + (parameter.defaultValue < most ? 1.0 : -1.0);
    if (trial == 2)
        return std::min(most, parameter.defaultValue + (parameter.defaultValue > least ? -1.0 : 2.0));
    return parameter.defaultValue;
}

/// Returns the values of a run: the first has the default values. In the others each number is closer to the left end
/// of its slider, where nothing is more violent, and choices and whole numbers are other ones. A choice that is not
/// marked as a whole number stays: the formula of a tree repeats slips of the tutorial, which no task asks for.
sim::Values judgeValues(const lessons::Step &step, int trial)
{
    sim::Values values = step.defaultValues();
    for (const lessons::Parameter &parameter : step.parameters) {
        if (parameter.restartsRun || parameter.scale == lessons::Scale::logarithmic)
            continue;
        const double share = trial == 1 ? 0.2 : 0.1;
        double value =
            parameter.defaultValue + share * trial * (parameter.sliderMin - parameter.defaultValue) / 2.0;
        if (!parameter.choices.isEmpty())
            value = parameter.isInteger ? judgedChoice(parameter, trial) : parameter.defaultValue;
        else if (parameter.isInteger)
            value = judgedWhole(parameter, trial);
        values.set(parameter.id.toStdString(), value);
    }
    return values;
}

/// The positions and angles of all points after a frame.
struct Pose
{
    Eigen::ArrayX2d position;
    Eigen::ArrayXd angle;
};

/// A run, up to judgedFrames or to an error.
struct JudgedRun
{
    std::vector<Pose> poses;
    std::optional<listing::RunError> error;

    bool hasStopped() const { return poses.size() < judgedFrames; }
};

/// A run that is computed frame by frame.
class JudgedTrack
{
public:
    JudgedTrack(const sim::Script &script, std::shared_ptr<const listing::Program> program)
        : m_program(std::move(program)), m_track(withMethod(script, m_program), judgeTrackBudget)
    {
    }

    const JudgedRun &run() const { return m_run; }
    bool isOver() const { return m_hasStopped || m_run.poses.size() == judgedFrames; }
    /// Computes the next frame, or the error that stops the run there. Returns false if it was cancelled.
    bool goOn(const sim::ShouldContinue &shouldContinue)
    {
        const auto frame = static_cast<std::int64_t>(m_run.poses.size()) + 1;
        if ((shouldContinue && !shouldContinue()) || !m_track.seek({frame, 0}, shouldContinue))
            return false;
        if (m_track.cursor().frame < frame) {
            m_hasStopped = true;
            sim::State next = m_track.stateAfterInput(m_track.state(), m_track.cursor().frame);
            const auto interval = m_track.nextInterval();
            m_run.error = m_program->run(next, listing::bind(m_program->vocabulary(), interval->scene));
        } else {
            m_run.poses.push_back({m_track.state().position, m_track.state().angle});
        }
        return true;
    }

private:
    static sim::Script withMethod(sim::Script script, const std::shared_ptr<const listing::Program> &program)
    {
        script.method = std::make_shared<listing::ListingMethod>(program);
        script.step = sim::stepFor(*script.method, sim::StepSize::ofLength(1.0));
        return script;
    }

    std::shared_ptr<const listing::Program> m_program;
    sim::Track m_track;
    JudgedRun m_run;
    bool m_hasStopped = false;
};

using JudgedRuns = std::vector<JudgedRun>;

/// Returns the runs of `scripts` by `program`; nothing if they were cancelled.
std::optional<JudgedRuns> runsOf(const std::vector<sim::Script> &scripts,
                                 const std::shared_ptr<const listing::Program> &program,
                                 const sim::ShouldContinue &shouldContinue)
{
    JudgedRuns runs;
    for (const sim::Script &script : scripts) {
        JudgedTrack track(script, program);
        while (!track.isOver()) {
            if (!track.goOn(shouldContinue))
                return std::nullopt;
        }
        runs.push_back(track.run());
    }
    return runs;
}

/// Returns the greatest difference of two columns, and its row.
double greatestDifference(const Eigen::ArrayXd &a, const Eigen::ArrayXd &b, Eigen::Index &row)
{
    return a.size() == 0 ? 0.0 : (a - b).abs().maxCoeff(&row);
}

Eigen::ArrayXd distancesOf(const Pose &a, const Pose &b)
{
    return (a.position - b.position).square().rowwise().sum().sqrt();
}

bool areEqual(const Pose &a, const Pose &b)
{
    Eigen::Index row = 0;
    const Eigen::ArrayXd distances = distancesOf(a, b);
    return greatestDifference(distances, Eigen::ArrayXd::Zero(distances.size()), row) <= judgeTolerance &&
           greatestDifference(a.angle, b.angle, row) <= judgeTolerance;
}

bool areEqual(const JudgedRuns &a, const JudgedRuns &b)
{
    const auto sameRun = [](const JudgedRun &one, const JudgedRun &other) {
        return one.poses.size() == other.poses.size() &&
               std::equal(one.poses.begin(), one.poses.end(), other.poses.begin(),
                          [](const Pose &x, const Pose &y) { return areEqual(x, y); });
    };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), sameRun);
}

/// Returns whether the runs of `scripts` by `program` are equal to `runs`; nothing if they were cancelled. They end at
/// the first difference, which is often an early one.
std::optional<bool> agree(const std::vector<sim::Script> &scripts,
                          const std::shared_ptr<const listing::Program> &program, const JudgedRuns &runs,
                          const sim::ShouldContinue &shouldContinue)
{
    for (std::size_t i = 0; i < scripts.size(); ++i) {
        JudgedTrack track(scripts[i], program);
        while (!track.isOver()) {
            if (!track.goOn(shouldContinue))
                return std::nullopt;
            const std::size_t frames = track.run().poses.size();
            if (frames > runs[i].poses.size() ||
                (frames > 0 && !areEqual(track.run().poses.back(), runs[i].poses[frames - 1])))
                return false;
        }
        if (track.run().poses.size() != runs[i].poses.size())
            return false;
    }
    return true;
}

/// Returns how the first of the runs that differs does so. One of them does.
Verdict firstDifference(const std::vector<sim::Script> &scripts, const JudgedRuns &reference,
                        const JudgedRuns &written)
{
    Verdict verdict;
    for (std::size_t run = 0; run < written.size(); ++run) {
        const std::vector<Pose> &poses = written[run].poses;
        for (std::size_t i = 0; i < poses.size(); ++i) {
            const Pose &right = reference[run].poses[i];
            if (areEqual(poses[i], right))
                continue;
            Eigen::Index row = 0;
            const Eigen::ArrayXd distances = distancesOf(poses[i], right);
            verdict.distance = distances.maxCoeff(&row);
            if (verdict.distance <= judgeTolerance) {
                verdict.isAngle = true;
                verdict.distance = greatestDifference(poses[i].angle, right.angle, row);
            }
            verdict.frame = static_cast<std::int64_t>(i) + 1;
            verdict.body =
                sim::sceneOf(scripts[run], scripts[run].values).names[static_cast<std::size_t>(row)];
            verdict.held = heldBody(scripts[run], verdict.frame);
            verdict.hasOtherValues = !(scripts[run].values == scripts.front().values);
            return verdict;
        }
        if (written[run].hasStopped()) {
            verdict.kind = Verdict::Kind::stopped;
            verdict.frame = static_cast<std::int64_t>(poses.size()) + 1;
            verdict.runError = written[run].error;
            return verdict;
        }
    }
    return verdict;
}

std::shared_ptr<const listing::Program> programFor(const sim::Script &script, const QString &code)
{
    const listing::Compiled compiled = compiledFor(script, code);
    if (!compiled.program)
        throw std::invalid_argument("a listing of a task does not compile: " +
                                    compiled.errors.front().sentence + '\n' + code.toStdString());
    return compiled.program;
}

QString sentenceForDifference(const Verdict &verdict)
{
    const QString body = withinSentence(bodyTitle(QString::fromStdString(verdict.body)));
    const QString difference = roughNumber(verdict.distance);
    const QString much = verdict.isAngle ? JudgeText::tr("%1° away from its angle").arg(difference)
                                         : JudgeText::tr("%1 px away from its place").arg(difference);
    if (verdict.held.empty())
        return (verdict.hasOtherValues
                    ? JudgeText::tr("Not yet: in frame %1 of a trial run with other parameters, %2 is %3.")
                    : JudgeText::tr("Not yet: in frame %1 of a trial run, %2 is %3."))
            .arg(verdict.frame)
            .arg(body, much);
    return (verdict.hasOtherValues
                ? JudgeText::tr(
                      "Not yet: while your hand holds %1 in a trial run with other parameters, %2 is %3.")
                : JudgeText::tr("Not yet: while your hand holds %1 in a trial run, %2 is %3."))
        .arg(withinSentence(bodyTitle(QString::fromStdString(verdict.held))), body, much);
}

}

std::vector<sim::Script> judgeScripts(const lessons::Step &step)
{
    std::vector<sim::Script> scripts;
    for (int trial = 0; trial < judgeTrials; ++trial) {
        sim::Script script = step.script();
        script.values = judgeValues(step, trial);
        const sim::Scene scene = sim::sceneOf(script, script.values);
        const auto points = static_cast<std::size_t>(scene.start.pointCount());
        if (step.accepts(lessons::Interaction::drag) && points > 0) {
            for (std::size_t i = 0; i < judgeStrokes[0].size(); ++i) {
                const std::size_t point = (i * (points - 1) + static_cast<std::size_t>(trial)) % points;
                addStroke(script.input, scene.names[point], scene.start.positionOf(static_cast<int>(point)),
                          judgeStrokes[static_cast<std::size_t>(trial)][i]);
            }
        }
        const Eigen::Array2d middle = scene.start.position.colwise().mean();
        addOtherInput(script.input, step, {middle.x(), middle.y()}, trial);
        sim::sortByFrame(script.input);
        scripts.push_back(std::move(script));
    }
    return scripts;
}

std::string heldBody(const sim::Script &script, std::int64_t frame)
{
    std::string body;
    for (const sim::Event &event : script.input) {
        if (event.frame > frame)
            break;
        if (const auto *grab = std::get_if<sim::Grab>(&event.what))
            body = grab->body;
        else if (std::holds_alternative<sim::Release>(event.what))
            body.clear();
    }
    return body;
}

std::optional<Verdict> judge(const lessons::Step &step, const lessons::CodeTask &task, const QString &code,
                             const sim::ShouldContinue &shouldContinue)
{
    const std::vector<sim::Script> scripts = judgeScripts(step);
    const listing::Compiled compiled = compiledFor(scripts.front(), code);
    if (!compiled.program) {
        Verdict verdict{.kind = Verdict::Kind::doesNotCompile};
        verdict.compileError = compiled.errors.front();
        return verdict;
    }
    const auto reference = runsOf(scripts, programFor(scripts.front(), step.listing.text), shouldContinue);
    const auto written = reference ? runsOf(scripts, compiled.program, shouldContinue) : std::nullopt;
    if (!written)
        return std::nullopt;
    if (areEqual(*reference, *written))
        return Verdict{.kind = Verdict::Kind::right};
    for (std::size_t i = 0; i < task.nearMisses.size(); ++i) {
        const lessons::NearMiss &miss = task.nearMisses[i];
        const QString text = step.listing.with(miss.gap.isEmpty() ? task.id : miss.gap, miss.code);
        const std::optional<bool> isMissed =
            agree(scripts, programFor(scripts.front(), text), *written, shouldContinue);
        if (!isMissed)
            return std::nullopt;
        if (*isMissed) {
            Verdict verdict = firstDifference(scripts, *reference, *written);
            verdict.kind = Verdict::Kind::nearMiss;
            verdict.nearMiss = static_cast<int>(i);
            return verdict;
        }
    }
    return firstDifference(scripts, *reference, *written);
}

QString sentenceFor(const Verdict &verdict, const lessons::CodeTask &task)
{
    switch (verdict.kind) {
    case Verdict::Kind::right:
        return JudgeText::tr("Right: your code does the same as the listing in three trial runs.");
    case Verdict::Kind::nearMiss:
        return task.nearMisses[static_cast<std::size_t>(verdict.nearMiss)].sentence;
    case Verdict::Kind::stopped:
        return verdict.runError
                   ? JudgeText::tr("Not yet: a trial run stops in frame %1. %2")
                         .arg(QString::number(verdict.frame), mistakeSentence(*verdict.runError))
                   : JudgeText::tr("Not yet: in frame %1 of a trial run, a number became infinite.")
                         .arg(verdict.frame);
    case Verdict::Kind::doesNotCompile:
        return JudgeText::tr("Line %1 is not correct yet, so the code cannot run.")
            .arg(verdict.compileError->line);
    case Verdict::Kind::wrong:
        break;
    }
    return sentenceForDifference(verdict);
}

}
