#include "app/model/handout/handout.h"

#include "app/model/handout/paper.h"
#include "app/model/learning/prediction_text.h"
#include "app/model/learning/prediction_truth.h"
#include "app/model/learning/recall_desk.h"
#include "app/model/learning/run_setup.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {

namespace {

constexpr int linesToAnswer = 2;
constexpr qsizetype mostLines = 20; ///< for a task

/// A lesson on its way to paper.
class Handout
{
    Q_DECLARE_TR_FUNCTIONS(Handout)

public:
    Handout(QTextDocument &document, const LessonEntry &lesson, const HandoutPicture &picture,
            const sim::ShouldContinue &shouldContinue)
        : m_paper(document), m_lesson(lesson), m_picture(picture), m_shouldContinue(shouldContinue)
    {
    }

    bool write()
    {
        m_paper.addHeading(1, m_lesson.title);
        m_paper.addText(m_lesson.summary);
        m_paper.addFields({tr("Name:"), tr("Date:")});
        for (const lessons::Step &step : m_lesson.steps) {
            if (!addStep(step))
                return false;
        }
        addQuestions();
        addProject();
        m_paper.beginPage();
        m_paper.addHeading(1, tr("Answers: %1").arg(m_lesson.title));
        for (const lessons::Step &step : m_lesson.steps) {
            if (!addAnswers(step))
                return false;
        }
        addAnswersToQuestions();
        return true;
    }

private:
    bool addStep(const lessons::Step &step)
    {
        m_paper.addHeading(2, numbered(step));
        if (!addPicture({m_lesson, step, step.script(), 0}))
            return false;
        m_paper.addText(step.narration);
        if (!step.listing.isEmpty())
            m_paper.addCode(step.listing.text);
        for (const lessons::Term &term : step.explanation.terms)
            m_paper.addText(QStringLiteral("**%1:** %2").arg(term.name, term.text));
        for (const lessons::Prediction &prediction : step.predictions) {
            if (!addPrediction(step, prediction))
                return false;
        }
        addTries(step);
        for (const lessons::CodeTask &task : step.codeTasks)
            addTask(step, task);
        return true;
    }

    QString numbered(const lessons::Step &step) const
    {
        return QStringLiteral("%1. %2").arg(&step - m_lesson.steps.data() + 1).arg(step.title);
    }

    /// Returns false if cancelled.
    bool addPicture(const HandoutMoment &moment)
    {
        if (m_shouldContinue && !m_shouldContinue())
            return false;
        m_paper.addPicture(m_picture(moment));
        return true;
    }

    bool addPrediction(const lessons::Step &step, const lessons::Prediction &prediction)
    {
        m_paper.addHeading(3, tr("Predict"));
        m_paper.addText(prediction.text);
        if (!addPicture({m_lesson, step, scriptFor(prediction.run, step), 0}))
            return false;
        switch (prediction.question.kind) {
        case lessons::Question::Kind::place:
            m_paper.addText(tr("Mark the place in the picture."));
            break;
        case lessons::Question::Kind::number:
            m_paper.addLines(1);
            break;
        case lessons::Question::Kind::curve:
            return addCurves(step, prediction);
        }
        return true;
    }

    /// Returns false if cancelled.
    bool addCurves(const lessons::Step &step, const lessons::Prediction &prediction)
    {
        const std::optional<PredictionTruth> truth = truthOf(prediction, step, m_shouldContinue);
        if (!truth)
            return false;
        std::vector<std::vector<double>> curves;
        for (const int curve : curveOrder(prediction))
            curves.push_back(truth->curves.at(static_cast<std::size_t>(curve)));
        m_paper.addCurves(curves);
        return true;
    }

    void addTries(const lessons::Step &step)
    {
        if (step.tries.empty())
            return;
        m_paper.addHeading(3, tr("Try this"));
        for (const lessons::Try &one : step.tries) {
            m_paper.addItem(one.text);
            for (const QString &choice : one.choices.texts)
                m_paper.addChoice(choice);
            if (one.choices.isEmpty() && !one.answer.isEmpty())
                m_paper.addLines(linesToAnswer);
        }
    }

    void addTask(const lessons::Step &step, const lessons::CodeTask &task)
    {
        m_paper.addHeading(3, tr("Write it yourself: %1").arg(task.title));
        m_paper.addText(task.text);
        const qsizetype lines = 1 + step.listing.solution(task.id).trimmed().count('\n');
        m_paper.addLines(static_cast<int>(std::min(lines, mostLines)));
    }

    void addQuestions()
    {
        if (m_lesson.recall.questions.empty())
            return;
        m_paper.addHeading(2, m_lesson.recall.title);
        int number = 0;
        for (const lessons::RecallQuestion &question : m_lesson.recall.questions) {
            m_paper.addText(QStringLiteral("**%1.** %2").arg(++number).arg(question.text));
            for (const std::size_t choice : RecallDesk::shuffled(question))
                m_paper.addChoice(question.choices[choice].text);
            if (question.choices.empty())
                m_paper.addLines(linesToAnswer);
        }
    }

    void addProject()
    {
        if (!m_lesson.project)
            return;
        m_paper.addHeading(2, tr("Build: %1").arg(m_lesson.project->title));
        m_paper.addText(m_lesson.project->brief);
        for (const lessons::ProjectLevel &level : m_lesson.project->levels)
            m_paper.addItem(QStringLiteral("**%1.** %2").arg(level.title, level.text));
    }

    bool addAnswers(const lessons::Step &step)
    {
        const bool hasAny = !step.predictions.empty() || !step.codeTasks.empty() ||
                            std::any_of(step.tries.begin(), step.tries.end(),
                                        [](const lessons::Try &one) { return !one.answer.isEmpty(); });
        if (!hasAny)
            return true;
        m_paper.addHeading(2, numbered(step));
        for (const lessons::Prediction &prediction : step.predictions) {
            if (!addOutcome(step, prediction))
                return false;
        }
        for (const lessons::Try &one : step.tries) {
            if (one.answer.isEmpty())
                continue;
            m_paper.addItem(one.text);
            if (!one.choices.isEmpty())
                m_paper.addText(QStringLiteral("**%1**").arg(one.choices.texts.value(one.choices.right)));
            m_paper.addText(one.answer);
        }
        for (const lessons::CodeTask &task : step.codeTasks) {
            m_paper.addItem(QStringLiteral("**%1**").arg(task.title));
            m_paper.addCode(step.listing.solution(task.id));
        }
        return true;
    }

    bool addOutcome(const lessons::Step &step, const lessons::Prediction &prediction)
    {
        const std::optional<PredictionTruth> truth = truthOf(prediction, step, m_shouldContinue);
        if (!truth)
            return false;
        m_paper.addItem(prediction.text);
        m_paper.addText(
            QStringLiteral("**%1.** %2").arg(answerWords(prediction, truth->answer), prediction.answer));
        return prediction.question.kind != lessons::Question::Kind::place ||
               addPicture({m_lesson, step, scriptFor(prediction.run, step), truth->end});
    }

    void addAnswersToQuestions()
    {
        if (m_lesson.recall.questions.empty())
            return;
        m_paper.addHeading(2, m_lesson.recall.title);
        int number = 0;
        for (const lessons::RecallQuestion &question : m_lesson.recall.questions) {
            ++number;
            if (question.task) {
                m_paper.addText(QStringLiteral("**%1.** %2").arg(number).arg(question.task->answer));
                continue;
            }
            const lessons::RecallChoice &right = question.choices.front();
            m_paper.addText(QStringLiteral("**%1.** %2").arg(number).arg(right.text));
            m_paper.addText(right.explanation);
        }
    }

    Paper m_paper;
    const LessonEntry &m_lesson;
    const HandoutPicture &m_picture;
    const sim::ShouldContinue &m_shouldContinue;
};

}

bool writeHandout(QTextDocument &document, const LessonEntry &lesson, const HandoutPicture &picture,
                  const sim::ShouldContinue &shouldContinue)
{
    return Handout(document, lesson, picture, shouldContinue).write();
}

}
