#include "app/model/lesson_folders/lesson_check.h"

#include "app/listing/listing_method.h"
#include "app/model/catalog/lists.h"
#include "app/model/experiment/experiment.h"
#include "app/model/learning/prediction_truth.h"
#include "app/model/learning/project_judge.h"
#include "app/model/learning/run_setup.h"
#include "app/model/listing/code_judge.h"
#include "app/model/run/run_program.h"
#include "app/model/text/numbers.h"
#include "app/model/text/quoting.h"
#include "app/model/text/sentences.h"
#include "app/model/text/user_error.h"
#include "sim/base/error.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"
#include "sim/scene/scene.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace app {

namespace {

using Kind = LessonFinding::Kind;

constexpr int idleFrames = 600; ///< in which nothing may be done without the learner
constexpr double least = 1e-3;  ///< of a curve's range: two curves that differ by less look the same

/// Checks one lesson, thing by thing.
class LessonChecker
{
    Q_DECLARE_TR_FUNCTIONS(LessonCheckText)

public:
    LessonChecker(const LessonFiles &files, const LessonEntry &lesson, const LessonLibrary &library,
                  const sim::ShouldContinue &shouldContinue)
        : m_files(files), m_lesson(lesson), m_library(library), m_shouldContinue(shouldContinue)
    {
        m_library.yours = {lesson};
    }

    std::vector<LessonFinding> check()
    {
        for (const lessons::Step &step : m_lesson.steps) {
            checkListing(step);
            checkTries(step);
            for (const lessons::Prediction &one : step.predictions)
                note(Kind::prediction, step.id, one.id, [&] { return checkPrediction(one, step); });
            for (const lessons::CodeTask &one : step.codeTasks)
                note(Kind::task, step.id, one.id, [&] { return checkTask(one, step); });
        }
        for (const lessons::RecallQuestion &one : m_lesson.recall.questions) {
            note(Kind::question, {}, one.id, [&] {
                return one.task ? checkQuestion(*one.task)
                                : Result{true, tr("has %1 choices").arg(one.choices.size())};
            });
        }
        if (m_lesson.project) {
            for (const lessons::ProjectLevel &level : m_lesson.project->levels)
                note(Kind::level, {}, level.id, [&] { return checkLevel(level); });
        }
        return std::move(m_findings);
    }

private:
    struct Result
    {
        bool isGood = false;
        QString sentence;
    };

    bool goesOn() const { return !m_shouldContinue || m_shouldContinue(); }

    /// Carries out `check` and keeps what it finds. A mistake of the lesson is a finding, too.
    template <class Check>
    void note(Kind kind, const QString &step, const QString &id, const Check &check)
    {
        if (!goesOn())
            return;
        Result result;
        try {
            result = check();
        } catch (const UserError &error) {
            result.sentence = error.sentence();
        } catch (const sim::Error &error) {
            result.sentence = sentenceFor(error);
        } catch (const std::invalid_argument &error) {
            result.sentence = oneLine(QString::fromUtf8(error.what()));
        }
        m_findings.push_back({kind, step, id, result.isGood, result.sentence});
    }

    void checkListing(const lessons::Step &step)
    {
        if (!step.listing.isEmpty())
            note(Kind::listing, step.id, {}, [&] { return checkSameMotion(step); });
    }

    /// Compares the listing with the method of its step, in the runs in which listings are judged.
    Result checkSameMotion(const lessons::Step &step) const
    {
        for (sim::Script script : judgeScripts(step)) {
            const listing::Compiled compiled = compiledFor(script, step.listing.text);
            if (!compiled.program)
                return {false, tr("the listing does not compile")};
            script.method = step.script().method;
            sim::Track own(script, 0);
            script.method = std::make_shared<const listing::ListingMethod>(compiled.program);
            sim::Track written(script, 0);
            for (int frame = 1; frame <= judgedFrames && goesOn(); ++frame) {
                own.seek({frame, 0});
                written.seek({frame, 0});
                if (own.cursor() != written.cursor())
                    return {false, tr("one of them stops in frame %1").arg(frame)};
                const Eigen::ArrayX2d difference = (own.state().position - written.state().position).abs();
                Eigen::Index row = 0, column = 0;
                const double most = difference.maxCoeff(&row, &column);
                if (!(most <= judgeTolerance))
                    return {false, differenceOf(step, script, static_cast<int>(row), frame, most)};
            }
        }
        return {true, tr("same motion as %1").arg(step.method)};
    }

    /// Returns what a writer should know about a listing that moves `point` otherwise than the method of its step.
    static QString differenceOf(const lessons::Step &step, const sim::Script &script, int point, int frame,
                                double away)
    {
        const std::string name = sim::sceneOf(script, script.values).names[static_cast<std::size_t>(point)];
        const QString body = QString::fromStdString(name);
        const QString sentence =
            tr("the listing moves %1 otherwise than the method %2: %3 px apart in frame %4 "
               "of a trial run")
                .arg(quoted(body), step.method, roughNumber(away))
                .arg(frame);
        return heldBody(script, frame) == name
                   ? tr("%1, in which the hand holds it. Every body can be held: write "
                        "“if (%2.held) %2.position = hand;”, and leave the forces out then")
                         .arg(sentence, body)
                   : sentence;
    }

    void checkTries(const lessons::Step &step)
    {
        const std::vector<int> idle = doneWithoutLearner(step);
        for (std::size_t i = 0; i < step.tries.size(); ++i) {
            const lessons::Try &one = step.tries[i];
            note(Kind::thing, step.id, one.id, [&]() -> Result {
                if (idle[i] >= 0)
                    return {false, tr("it is done in frame %1 without the learner; add a condition such as "
                                      "“- begun: released()”")
                                       .arg(idle[i])};
                return checkSolution(one, solutionOf(step.id, one.id), step);
            });
        }
    }

    /// Returns for each thing to try the frame in which a run without input does it; -1: never.
    std::vector<int> doneWithoutLearner(const lessons::Step &step) const
    {
        std::vector<int> frames(step.tries.size(), -1);
        sim::Timeline run(step.script(), 0);
        for (int frame = 0; frame <= idleFrames && goesOn(); frame = static_cast<int>(run.cursor().frame)) {
            for (std::size_t i = 0; i < frames.size(); ++i) {
                if (frames[i] < 0 && step.tries[i].isDone(run))
                    frames[i] = frame;
            }
            run.nextOutputStep();
            if (run.cursor().frame == frame)
                break;
        }
        return frames;
    }

    lessons::RunSetup solutionOf(const QString &step, const QString &id) const
    {
        const lessons::Document document = lessons::parseDocument(m_files.content(step + ".md"), step);
        const lessons::TryText *found = findById(document.tries, id);
        return found ? found->solution : lessons::RunSetup();
    }

    Result checkSolution(const lessons::Try &one, const lessons::RunSetup &solution,
                         const lessons::Step &step) const
    {
        if (solution.line == 0)
            return {false, tr("it states no solution; write a “### Solution”")};
        sim::Timeline run(scriptFor(solution, step), 0);
        QString todo;
        std::vector<bool> held(one.conditions.all().size());
        for (;;) {
            const std::int64_t frame = run.cursor().frame;
            if (one.isDone(run))
                return {true, tr("done in frame %1").arg(frame)};
            todo = one.conditions.todo(run);
            for (std::size_t i = 0; i < held.size(); ++i)
                held[i] = held[i] || one.conditions.all()[i].holds(run);
            if (frame >= solution.frames || !goesOn())
                break;
            run.nextOutputStep();
            if (run.cursor().frame == frame)
                break;
        }
        const QString frames = QString::number(run.cursor().frame);
        if (!contains(held, false))
            return {false, tr("its solution does not do it in %1 frames: each condition holds in "
                              "some frame, but they never all hold in the same one")
                               .arg(frames)};
        return {false, todo.isEmpty() ? tr("its solution does not do it in %1 frames").arg(frames)
                                      : tr("its solution does not do it in %1 frames: %2").arg(frames, todo)};
    }

    Result checkPrediction(const lessons::Prediction &prediction, const lessons::Step &step) const
    {
        const auto truth = truthOf(prediction, step, m_shouldContinue);
        if (!truth)
            return {};
        if (!truth->isReached)
            return {false, tr("its condition does not hold up to frame %1").arg(truth->end)};
        const QString end = tr("ends in frame %1").arg(truth->end);
        switch (prediction.question.kind) {
        case lessons::Question::Kind::place:
            return {
                std::isfinite(truth->answer.place.x + truth->answer.place.y),
                tr("%1, at (%2, %3)")
                    .arg(end, fixedNumber(truth->answer.place.x, 1), fixedNumber(truth->answer.place.y, 1))};
        case lessons::Question::Kind::number:
            return {std::isfinite(truth->answer.number),
                    tr("%1, with %2").arg(end, roughNumber(truth->answer.number))};
        case lessons::Question::Kind::curve:
            break;
        }
        for (std::size_t i = 1; i < truth->curves.size(); ++i) {
            if (looksTheSame(truth->curves[0], truth->curves[i]))
                return {false, tr("two of its curves look the same")};
        }
        return {true, end};
    }

    static bool looksTheSame(const std::vector<double> &a, const std::vector<double> &b)
    {
        double most = 0.0;
        for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
            most = std::max(most, std::abs(a[i] - b[i]));
        const auto [low, high] = std::minmax_element(a.begin(), a.end());
        return most <= least * std::max(1.0, *high - *low);
    }

    Result checkTask(const lessons::CodeTask &task, const lessons::Step &step) const
    {
        const auto judged = [&](const QString &code) { return judge(step, task, code, m_shouldContinue); };
        const lessons::Listing &listing = step.listing;
        const auto solution = judged(listing.text), empty = judged(listing.emptied(task));
        if (!solution || !empty)
            return {};
        if (solution->kind != Verdict::Kind::right)
            return {false, tr("the listing itself does not pass")};
        if (empty->kind == Verdict::Kind::right)
            return {false, tr("the empty place passes")};
        for (std::size_t i = 0; i < task.nearMisses.size(); ++i) {
            const lessons::NearMiss &miss = task.nearMisses[i];
            const auto verdict = judged(listing.with(miss.gap.isEmpty() ? task.id : miss.gap, miss.code));
            if (!verdict)
                return {};
            if (verdict->kind != Verdict::Kind::nearMiss || verdict->nearMiss != static_cast<int>(i))
                return {false,
                        tr("near miss %1 is not told from the others or from the solution").arg(i + 1)};
        }
        return {true, tr("passes, with %1 near misses").arg(task.nearMisses.size())};
    }

    Result checkQuestion(const lessons::RecallTask &task) const
    {
        if (task.solution.line == 0)
            return {false, tr("it states no solution; write a “### Solution”")};
        const lessons::Step *step = stepCalled(task.setup.step, m_library);
        if (!step)
            return {false, tr("there is no step %1").arg(quoted(task.setup.step))};
        FollowedRun run(*step, scriptWith(task.solution, *step, scriptFor(task.setup, *step)));
        lessons::RunSetup setup = task.setup;
        setup.frames = task.solution.frames;
        const auto end = runToEnd(run, setup, m_shouldContinue);
        if (!end)
            return {};
        return {end->isReached, end->isReached
                                    ? tr("done in frame %1").arg(end->frame)
                                    : tr("its solution does not do it in %1 frames").arg(end->frame)};
    }

    Result checkLevel(const lessons::ProjectLevel &level) const
    {
        const Experiment start = sceneFrom(QStringLiteral("project.json"));
        const lessons::Step *step = m_library.lesson(start.lesson)->step(start.step);
        const auto judged = [&](const sim::Script &built) {
            return judgeProject({level, step, start.script, built}, {}, m_shouldContinue);
        };
        const auto unchanged = judged(start.script);
        if (!unchanged)
            return {};
        if (unchanged->isPassed())
            return {false, tr("the start scene passes")};
        const QString file = QStringLiteral("project_%1.json").arg(level.id);
        if (!m_files.has(file))
            return {false, tr("it states no solution; save one as %1").arg(file)};
        const auto verdict = judged(sceneFrom(file).script);
        if (!verdict)
            return {};
        return {verdict->isPassed(), verdict->isPassed() ? tr("%1 passes").arg(file) : verdict->sentence};
    }

    Experiment sceneFrom(const QString &file) const
    {
        return parseExperiment(m_files.content(file), m_files.shown(file), m_library);
    }

    const LessonFiles &m_files;
    const LessonEntry &m_lesson;
    LessonLibrary m_library; ///< with this lesson
    const sim::ShouldContinue &m_shouldContinue;
    std::vector<LessonFinding> m_findings;
};

}

std::vector<LessonFinding> checkLesson(const LessonFiles &files, const LessonEntry &lesson,
                                       const LessonLibrary &library,
                                       const sim::ShouldContinue &shouldContinue)
{
    return LessonChecker(files, lesson, library, shouldContinue).check();
}

QString wordFor(LessonFinding::Kind kind)
{
    switch (kind) {
    case Kind::listing:
        return QStringLiteral("listing");
    case Kind::thing:
        return QStringLiteral("try");
    case Kind::prediction:
        return QStringLiteral("prediction");
    case Kind::task:
        return QStringLiteral("task");
    case Kind::question:
        return QStringLiteral("question");
    case Kind::level:
        break;
    }
    return QStringLiteral("level");
}

}
