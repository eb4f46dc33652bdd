#include "app/model/notebook/notebook_check.h"

#include "app/model/catalog/lists.h"
#include "app/model/experiment/experiment.h"
#include "app/model/learning/prediction_truth.h"
#include "app/model/learning/project_judge.h"
#include "app/model/learning/project_start.h"
#include "app/model/learning/recall_desk.h"
#include "app/model/learning/run_setup.h"
#include "app/model/listing/code_judge.h"
#include "app/model/notebook/notebook_question.h"
#include "app/model/run/same_run.h"
#include "app/model/text/quoting.h"
#include "app/model/text/sentences.h"
#include "app/model/text/user_error.h"
#include "sim/run/timeline.h"

#include <QCoreApplication>

#include <chrono>

namespace app {

namespace {

using Kind = NotebookEntry::Kind;
using Result = NotebookFinding::Result;

constexpr std::chrono::seconds longestReplay{30};
constexpr std::size_t replayBudget = 16 << 20; ///< bytes of keyframes
constexpr std::int64_t replaySlice = 32;       ///< output steps between two questions whether to go on

NotebookFinding notShown(const QString &why)
{
    return {Result::notShown, why};
}

/// A replay of one entry.
class EntryCheck
{
    Q_DECLARE_TR_FUNCTIONS(NotebookCheckText)

public:
    EntryCheck(const NotebookEntry &entry, const LessonLibrary &library,
               const sim::ShouldContinue &shouldContinue)
        : m_entry(entry), m_library(library), m_lesson(*library.lesson(entry.lesson)),
          m_step(m_lesson.step(entry.step)), m_shouldContinue(shouldContinue)
    {
    }

    std::optional<NotebookFinding> find()
    {
        try {
            const std::optional<NotebookFinding> finding = findOrThrow();
            if (finding || m_isCancelled)
                return finding;
            return notShown(tr("Its run takes more than %1 s to replay.").arg(longestReplay.count()));
        } catch (const UserError &error) {
            return notShown(error.sentence());
        } catch (const sim::Error &error) {
            return notShown(sentenceFor(error));
        }
    }

private:
    /// Returns nothing if it was cancelled, or took too long.
    std::optional<NotebookFinding> findOrThrow()
    {
        if (m_entry.kind == Kind::prediction)
            return findPrediction();
        const std::optional<NotebookQuestion> question =
            m_entry.kind == Kind::answer ? notebookQuestion(m_lesson, m_entry.step, m_entry.id)
                                         : std::nullopt;
        if (question && !question->task)
            return findChoice(*question);
        if (m_entry.kind == Kind::code ? m_entry.code.isEmpty() : m_entry.run.text.isEmpty())
            return NotebookFinding{Result::noRun, tr("It was ticked by a version that kept no runs.")};
        switch (m_entry.kind) {
        case Kind::tried:
            return findTry();
        case Kind::code:
            return findCode();
        case Kind::level:
            return findLevel();
        case Kind::answer:
            return findTask(*question->task);
        default:
            break;
        }
        const Experiment scene = experimentIn(m_entry.run.text);
        sim::Track(scene.script, 0).seek({1, 0});
        return scene.lesson == m_entry.lesson ? NotebookFinding{} : notShown(otherStep());
    }

    bool goesOn()
    {
        if (m_shouldContinue && !m_shouldContinue())
            m_isCancelled = true;
        return !m_isCancelled && std::chrono::steady_clock::now() - m_begun < longestReplay;
    }

    static QString otherStep() { return tr("Its run is of another step."); }

    Experiment experimentIn(const QByteArray &text) const
    {
        return parseExperiment(text, m_entry.id, m_library);
    }

    bool isOfStep(const Experiment &experiment) const
    {
        return experiment.lesson == m_entry.lesson && experiment.step == m_entry.step;
    }

    /// Moves `run` to the moment of the entry. Returns whether it had the time.
    bool replay(sim::Timeline &run)
    {
        const sim::Cursor goal = m_entry.run.at;
        const std::int64_t slice = replaySlice * run.track().framesPerOutput();
        for (std::int64_t frame = slice; frame < goal.frame; frame += slice) {
            if (!goesOn())
                return false;
            run.seek({frame, 0});
            if (run.stop() || run.isFinished())
                break;
        }
        run.seek(goal);
        return goesOn();
    }

    std::optional<NotebookFinding> findTry()
    {
        const Experiment experiment = experimentIn(m_entry.run.text);
        if (!isOfStep(experiment))
            return notShown(otherStep());
        sim::Timeline run(experiment.script, replayBudget);
        if (!m_entry.run.beside.isEmpty()) {
            const Experiment beside = experimentIn(m_entry.run.beside);
            if (!isOfStep(beside))
                return notShown(otherStep());
            run.setComparison(sim::Track(beside.script, replayBudget), m_entry.run.fork);
        }
        if (!replay(run))
            return std::nullopt;
        const lessons::Try &one = *findById(m_step->tries, m_entry.id);
        const auto noTime = [](const sim::Script &, std::int64_t) { return 0.0; };
        const auto isDone = [&] {
            return one.isDone(run) &&
                   (!one.budget || lessons::staysWithin(*one.budget, run.script(), noTime));
        };
        if (isDone())
            return NotebookFinding{};
        // A run may end here, which is only known when it goes on.
        run.seek({m_entry.run.at.frame + run.track().framesPerOutput(), 0});
        run.seek(m_entry.run.at);
        if (isDone())
            return NotebookFinding{};
        const QString todo = one.conditions.todo(run);
        const QString why = notDone(run);
        return notShown(todo.isEmpty() ? why : why + ' ' + tr("Still to do: %1").arg(todo));
    }

    static QString notDone(const sim::Timeline &run)
    {
        return tr("At frame %1 its run does not do it.").arg(run.cursor().frame);
    }

    /// Replays the run that answers a recall question.
    std::optional<NotebookFinding> findTask(const lessons::RecallTask &task)
    {
        const Experiment experiment = experimentIn(m_entry.run.text);
        if (OpenRun::keyOf(experiment.lesson, experiment.step) != task.setup.step)
            return notShown(otherStep());
        const lessons::Step &step = *m_library.lesson(experiment.lesson)->step(experiment.step);
        sim::Timeline run(experiment.script, replayBudget);
        if (!replay(run))
            return std::nullopt;
        const bool isAsSetUp =
            sameScript(run.script(), scriptFor(task.setup, step)); // the learner did nothing
        return !isAsSetUp && isTaskDone(task, step, run) ? NotebookFinding{} : notShown(notDone(run));
    }

    NotebookFinding findChoice(const NotebookQuestion &question) const
    {
        const lessons::RecallChoice *said = question.choice(m_entry.said);
        if (!said)
            return notShown(tr("Its answer cannot be read."));
        const bool isRight = question.isRight(m_entry.said);
        // Sentences that become parts of a sentence lose their full stop.
        const QString words = oneLine(said->text), right = oneLine(question.choices[question.right].text);
        if (m_entry.isRight != isRight)
            return notShown(tr("The notebook counts “%1” as %2, but the answer of the lesson is “%3”.")
                                .arg(words, rightWord(), right));
        if (isRight)
            return {Result::right};
        return {Result::off, tr("“%1” was said; it is “%2”.").arg(words, right)};
    }

    /// Returns what the notebook says about an answer.
    QString rightWord() const { return m_entry.isRight ? tr("right") : tr("not right"); }

    std::optional<NotebookFinding> findCode()
    {
        const lessons::CodeTask &task = *findById(m_step->codeTasks, m_entry.id);
        const std::optional<Verdict> verdict =
            judge(*m_step, task, m_entry.code, [this] { return goesOn(); });
        if (!verdict)
            return std::nullopt;
        return verdict->kind == Verdict::Kind::right ? NotebookFinding{}
                                                     : notShown(sentenceFor(*verdict, task));
    }

    std::optional<NotebookFinding> findLevel()
    {
        const Experiment start = projectStart(m_lesson, m_library);
        const Experiment built = experimentIn(m_entry.run.text);
        if (built.lesson != start.lesson || built.step != start.step)
            return notShown(otherStep());
        const lessons::Step *place = m_library.lesson(start.lesson)->step(start.step);
        const ProjectTrial trial{*findById(m_lesson.project->levels, m_entry.id), place, start.script,
                                 built.script};
        const std::optional<ProjectVerdict> verdict = judgeProject(trial, {}, [this] { return goesOn(); });
        if (!verdict)
            return std::nullopt;
        return verdict->isPassed() ? NotebookFinding{} : notShown(verdict->sentence);
    }

    std::optional<NotebookFinding> findPrediction()
    {
        const lessons::Prediction &prediction = *findById(m_step->predictions, m_entry.id);
        const lessons::Question &question = prediction.question;
        const std::optional<PredictionTruth> truth =
            truthOf(prediction, *m_step, [this] { return goesOn(); });
        if (!truth)
            return std::nullopt;
        const QString computed = notedAnswer(question, truth->answer);
        const std::optional<PredictedAnswer> said = answerInNote(question, m_entry.said);
        if (!said)
            return notShown(tr("Its answer cannot be read."));
        const bool isRight = isGood(question, *said, truth->answer);
        if (m_entry.found != computed || m_entry.isRight != isRight)
            return notShown(m_entry.isRight != isRight
                                ? tr("The notebook counts “%1” as %2, but the run gives “%3”.")
                                      .arg(m_entry.said, rightWord(), computed)
                                : tr("The notebook says that the run gives “%1”, but it gives “%2”.")
                                      .arg(m_entry.found, computed));
        if (isRight)
            return NotebookFinding{Result::right};
        return NotebookFinding{Result::off, tr("“%1” was said; it is “%2”.").arg(m_entry.said, computed)};
    }

    const NotebookEntry &m_entry;
    const LessonLibrary &m_library;
    const LessonEntry &m_lesson;
    const lessons::Step *m_step; ///< null if the entry is of no step
    const sim::ShouldContinue &m_shouldContinue;
    const std::chrono::steady_clock::time_point m_begun = std::chrono::steady_clock::now();
    bool m_isCancelled = false;
};

}

QString wordFor(Result result)
{
    switch (result) {
    case Result::shown:
        return QStringLiteral("shown");
    case Result::right:
        return QStringLiteral("right");
    case Result::off:
        return QStringLiteral("off");
    case Result::notShown:
        return QStringLiteral("not shown");
    case Result::noRun:
        break;
    }
    return QStringLiteral("no run");
}

std::optional<NotebookFinding> checkEntry(const NotebookEntry &entry, const LessonLibrary &library,
                                          const sim::ShouldContinue &shouldContinue)
{
    return EntryCheck(entry, library, shouldContinue).find();
}

}
