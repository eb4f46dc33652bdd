#include "app/model/notebook/notebook.h"

#include "app/model/catalog/progress.h"
#include "app/model/experiment/experiment_line.h"
#include "app/model/files/gallery.h"
#include "app/model/learning/notes.h"
#include "app/model/learning/prediction_truth.h"
#include "app/model/learning/project_desk.h"
#include "app/model/learning/proofs.h"
#include "app/model/learning/recall_desk.h"
#include "app/model/notebook/notebook_file.h"
#include "app/model/notebook/notebook_question.h"

#include <utility>

namespace app {

namespace {

using Kind = NotebookEntry::Kind;

/// A collector of what a learner did in one lesson; without `proofs`, it collects no runs and no code.
class LessonCollector
{
public:
    LessonCollector(const LessonEntry &lesson, const Progress &progress, const Notes &notes,
                    const Proofs *proofs)
        : m_lesson(lesson), m_progress(progress), m_notes(notes), m_proofs(proofs)
    {
    }

    std::vector<NotebookEntry> collect()
    {
        for (const lessons::Step &step : m_lesson.steps)
            addStep(step);
        for (const lessons::RecallQuestion &question : m_lesson.recall.questions)
            addRecall(question);
        if (!m_lesson.project)
            return std::move(m_entries);
        const QString place = QString::fromLatin1(projectTicks);
        for (const lessons::ProjectLevel &level : m_lesson.project->levels) {
            if (m_progress.isWritten(m_lesson.id, place, level.id))
                addProved({.kind = Kind::level, .lesson = m_lesson.id, .id = level.id},
                          Notes::keyOf(m_lesson.id, place, QStringLiteral("code"), level.id));
        }
        return std::move(m_entries);
    }

private:
    void addStep(const lessons::Step &step)
    {
        for (int i = 0; i < static_cast<int>(step.tries.size()); ++i) {
            const QString &id = step.tries[static_cast<std::size_t>(i)].id;
            if (m_progress.isDone(m_lesson.id, step.id, i))
                addProved({.kind = Kind::tried, .lesson = m_lesson.id, .step = step.id, .id = id},
                          Notes::keyOf(m_lesson.id, step.id, QStringLiteral("try"), id));
            if (const Note *note =
                    m_notes.find(Notes::keyOf(m_lesson.id, step.id, QStringLiteral("choice"), id)))
                addChoice(step.id, id, note->said, *note);
        }
        for (const lessons::Prediction &prediction : step.predictions)
            addPrediction(step, prediction);
        for (const lessons::CodeTask &task : step.codeTasks) {
            if (m_progress.isWritten(m_lesson.id, step.id, task.id))
                addProved({.kind = Kind::code, .lesson = m_lesson.id, .step = step.id, .id = task.id},
                          Notes::keyOf(m_lesson.id, step.id, QStringLiteral("code"), task.id));
        }
    }

    void addRecall(const lessons::RecallQuestion &question)
    {
        const QString key = RecallDesk::keyOf(m_lesson.id, question.id);
        const Note *note = m_notes.find(key);
        if (!note)
            return;
        bool isNumber = false;
        const uint index = note->said.toUInt(&isNumber);
        if (isNumber)
            addChoice({}, question.id, QString::number(index + 1), *note);
        else if (question.task)
            addProved({.kind = Kind::answer, .lesson = m_lesson.id, .id = question.id, .when = note->at},
                      key);
    }

    /// Adds a choice with this number, unless the question of today has no such choice.
    void addChoice(const QString &step, const QString &id, const QString &number, const Note &note)
    {
        const std::optional<NotebookQuestion> question = notebookQuestion(m_lesson, step, id);
        if (question && question->choice(number))
            m_entries.push_back({.kind = Kind::answer,
                                 .lesson = m_lesson.id,
                                 .step = step,
                                 .id = id,
                                 .when = note.at,
                                 .said = number,
                                 .isRight = note.isRight});
    }

    void addProved(NotebookEntry entry, const QString &key)
    {
        if (const auto proof = m_proofs ? m_proofs->find(key) : std::nullopt) {
            entry.when = proof->when;
            entry.code = proof->code;
            try {
                if (!proof->run.isEmpty())
                    entry.run = {textInLine(proof->run, largestNotebookRun), proof->at};
                if (!proof->beside.isEmpty()) {
                    entry.run.beside = textInLine(proof->beside, largestNotebookRun);
                    entry.run.fork = proof->fork;
                }
            } catch (const UserError &) { // damaged, or too large: the tick stays without it
                entry.run = {};
            }
        }
        m_entries.push_back(std::move(entry));
    }

    void addPrediction(const lessons::Step &step, const lessons::Prediction &prediction)
    {
        const Note *note =
            m_notes.find(Notes::keyOf(m_lesson.id, step.id, QStringLiteral("predict"), prediction.id));
        const bool isAnswer = note && note->kind == notedKind(prediction.question) &&
                              answerInNote(prediction.question, note->said);
        if (isAnswer)
            m_entries.push_back({.kind = Kind::prediction,
                                 .lesson = m_lesson.id,
                                 .step = step.id,
                                 .id = prediction.id,
                                 .when = note->at,
                                 .said = note->said,
                                 .found = note->found,
                                 .isRight = note->isRight});
    }

    const LessonEntry &m_lesson;
    const Progress &m_progress;
    const Notes &m_notes;
    const Proofs *m_proofs;
    std::vector<NotebookEntry> m_entries;
};

/// Returns a time as files have it.
QDateTime inWholeSeconds(const QDateTime &time)
{
    return time.isValid() ? QDateTime::fromSecsSinceEpoch(time.toSecsSinceEpoch(), Qt::UTC) : QDateTime();
}

void addScenes(const QString &folder, const LessonLibrary &library, std::vector<NotebookEntry> &entries)
{
    const Gallery gallery(folder);
    for (const KeptExperiment &kept : gallery.all()) {
        try {
            const Experiment experiment = Gallery::experimentOf(kept, library);
            const QByteArray text = textInLine(experimentLine(experiment, library), largestNotebookRun);
            entries.push_back({.kind = Kind::scene,
                               .lesson = experiment.lesson,
                               .id = kept.title,
                               .when = kept.when.toUTC(),
                               .run = {text, {}}});
        } catch (const UserError &) { // the gallery names it
        }
    }
}

}

QString wordFor(Kind kind)
{
    switch (kind) {
    case Kind::tried:
        return QStringLiteral("try");
    case Kind::code:
        return QStringLiteral("code");
    case Kind::level:
        return QStringLiteral("level");
    case Kind::prediction:
        return QStringLiteral("prediction");
    case Kind::answer:
        return QStringLiteral("answer");
    case Kind::scene:
        break;
    }
    return QStringLiteral("scene");
}

Notebook collectNotebook(const NotebookPlan &plan, const LessonLibrary &library, const Progress &progress,
                         const Notes &notes, const Proofs &proofs)
{
    Notebook notebook{.name = plan.name.simplified().left(Notebook::longestName),
                      .when = inWholeSeconds(QDateTime::currentDateTimeUtc())};
    for (std::size_t i = 0; i < library.entries(); ++i) {
        const LessonEntry &lesson = library.entry(i);
        if (!plan.lessons.contains(lesson.id))
            continue;
        for (NotebookEntry &entry : LessonCollector(lesson, progress, notes, &proofs).collect())
            notebook.entries.push_back(std::move(entry));
    }
    if (!plan.gallery.isEmpty())
        addScenes(plan.gallery, library, notebook.entries);
    for (NotebookEntry &entry : notebook.entries)
        entry.when = inWholeSeconds(entry.when);
    return notebook;
}

int notebookEntries(const LessonEntry &lesson, const Progress &progress, const Notes &notes)
{
    return static_cast<int>(LessonCollector(lesson, progress, notes, nullptr).collect().size());
}

}
