#include "tests/app/notebook/notebook_maker.h"

#include "app/model/experiment/experiment_line.h"
#include "app/model/learning/prediction_truth.h"
#include "app/model/learning/project_desk.h"
#include "app/model/learning/recall_desk.h"
#include "app/model/session/attempts.h"
#include "tests/lessons/attempts/attempts.h"
#include "tests/lessons/attempts/formulations.h"

#include <QCoreApplication>
#include <QDir>
#include <QSettings>

#include <algorithm>
#include <map>
#include <stdexcept>

using namespace app;

namespace tests {

namespace {

/// Performs an attempt, and lets `Attempts` look at the run as often as the window does.
class RecordedPlayer : public support::RunPlayer
{
public:
    RecordedPlayer(const LessonEntry &lesson, const support::Attempt &attempt, Record &record)
        : RunPlayer(*lesson.step(attempt.step), attempt.number), m_lesson(lesson.id),
          m_step(*lesson.step(attempt.step)), m_attempts(record.progress, record.proofs, allLessons())
    {
    }

    void play(int frames) override
    {
        for (int i = 0; i < frames; ++i) {
            RunPlayer::play(1);
            look(true);
        }
    }
    void grab(const std::string &body) override
    {
        after([&] { RunPlayer::grab(body); });
    }
    void movePointer(sim::Vec2 to) override
    {
        after([&] { RunPlayer::movePointer(to); });
    }
    void release() override
    {
        after([&] { RunPlayer::release(); });
    }
    void point(sim::Vec2 at, bool down) override
    {
        after([&] { RunPlayer::point(at, down); });
    }
    void target(sim::Vec2 at) override
    {
        after([&] { RunPlayer::target(at); });
    }
    void key(bool sim::Keys::*key, bool down) override
    {
        after([&] { RunPlayer::key(key, down); });
    }
    void set(const std::string &id, double value) override
    {
        after([&] { RunPlayer::set(id, value); });
    }
    void useMethod(const std::string &id) override
    {
        after([&] { RunPlayer::useMethod(id); });
    }
    void useStep(double h) override
    {
        after([&] { RunPlayer::useStep(h); });
    }
    void useTolerance(double size) override
    {
        after([&] { RunPlayer::useTolerance(size); });
    }
    void goTo(std::int64_t frame) override
    {
        after([&] { RunPlayer::goTo(frame); });
    }
    void stepPhases(int count) override
    {
        for (int i = 0; i < count; ++i)
            after([&] { RunPlayer::stepPhases(1); });
    }
    void useTiming(lessons::TimeMeasurement timing) override
    {
        m_attempts.setTiming(timing);
        RunPlayer::useTiming(std::move(timing));
    }
    void look(bool plays) { m_attempts.check(m_lesson, m_step, run(), plays); }

private:
    template <class Act>
    void after(Act act)
    {
        act();
        look(false);
    }

    QString m_lesson;
    const lessons::Step &m_step;
    Attempts m_attempts;
};

void writeTasks(const LessonEntry &lesson, Record &record)
{
    for (const support::Formulation &one : support::rightFormulations()) {
        if (lesson.id != one.lesson)
            continue;
        const lessons::Step &step = *lesson.step(one.step);
        record.progress.markWritten(lesson.id, step.id, one.task);
        record.proofs.keep(Notes::keyOf(lesson.id, step.id, "code", one.task),
                           {.code = step.listing.with(one.task, one.code)});
    }
}

void predictAll(const LessonEntry &lesson, Record &record)
{
    for (const lessons::Step &step : lesson.steps) {
        for (const lessons::Prediction &one : step.predictions) {
            const QString answer = notedAnswer(one.question, truthOf(one, step)->answer);
            record.notes.keep(Notes::keyOf(lesson.id, step.id, "predict", one.id),
                              {notedKind(one.question), answer, answer, true});
        }
    }
}

/// Keeps the notes that the window keeps.
void chooseAll(const LessonEntry &lesson, Record &record)
{
    for (const lessons::Step &step : lesson.steps) {
        for (const lessons::Try &one : step.tries) {
            const QString right = QString::number(one.choices.right + 1);
            if (!one.choices.isEmpty())
                record.notes.keep(Notes::keyOf(lesson.id, step.id, "choice", one.id),
                                  {"choice", right, right, true});
        }
    }
    for (const lessons::RecallQuestion &question : lesson.recall.questions) {
        if (!question.task)
            record.notes.keep(RecallDesk::keyOf(lesson.id, question.id), {"recall", "0", "0", true});
    }
}

void passLevels(const LessonEntry &lesson, Record &record)
{
    for (const lessons::ProjectLevel &level : lesson.project->levels) {
        const Experiment built = readExperiment(
            QStringLiteral(TEST_DATA "/projects/%1-%2.json").arg(lesson.id, level.id), allLessons());
        record.progress.markWritten(lesson.id, projectTicks, level.id);
        record.proofs.keep(Notes::keyOf(lesson.id, projectTicks, "code", level.id),
                           {.run = experimentLine(built, allLessons())});
    }
}

}

void forgetRecords()
{
    QSettings().clear();
    QSettings(QSettings::defaultFormat(), QSettings::UserScope, QCoreApplication::organizationName(),
              "notebook")
        .clear();
}

Record::Record() : progress((forgetRecords(), nullptr)) {}

const LessonLibrary &allLessons()
{
    static const LessonLibrary all = LessonLibrary::load({LESSON_DIR});
    return all;
}

void tryAll(const QString &lesson, Record &record)
{
    const LessonEntry &entry = *allLessons().lesson(lesson);
    for (const support::Attempt &attempt : support::attemptsOf(lesson.toStdString())) {
        const lessons::Step &step = *entry.step(attempt.step);
        const QString &id = step.tries[attempt.number].id;
        if (attempt.isNearMiss() || record.proofs.has(Notes::keyOf(lesson, step.id, "try", id)))
            continue;
        RecordedPlayer player(entry, attempt, record);
        attempt.act(player);
        player.look(false);
    }
}

void doTheRest(const QString &lesson, Record &record)
{
    const LessonEntry &entry = *allLessons().lesson(lesson);
    writeTasks(entry, record);
    predictAll(entry, record);
    chooseAll(entry, record);
    passLevels(entry, record);
}

const Notebook &notebookOfAll(const QString &lesson)
{
    static std::map<QString, Notebook> known;
    const auto found = known.find(lesson);
    if (found != known.end())
        return found->second;
    Record record;
    tryAll(lesson, record);
    doTheRest(lesson, record);
    const NotebookPlan plan{.name = QStringLiteral("Ada"), .lessons = {lesson}};
    return known[lesson] = collectNotebook(plan, allLessons(), record.progress, record.notes, record.proofs);
}

NotebookEntry &entryOf(Notebook &notebook, NotebookEntry::Kind kind, const QString &id)
{
    const auto found = std::find_if(notebook.entries.begin(), notebook.entries.end(),
                                    [&](const auto &entry) { return entry.kind == kind && entry.id == id; });
    if (found == notebook.entries.end())
        throw std::invalid_argument("no entry " + id.toStdString());
    return *found;
}

}
