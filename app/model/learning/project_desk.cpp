#include "app/model/learning/project_desk.h"

#include "app/model/catalog/lists.h"
#include "app/model/experiment/experiment_line.h"
#include "app/model/learning/project_start.h"

#include <QSettings>

#include <algorithm>
#include <utility>

namespace app {

namespace {

const char *const currentProjectKey = "projects/current";
const QString ticksOfProjects = QString::fromLatin1(projectTicks);

}

ProjectDesk::ProjectDesk(Session &session, QObject *parent)
    : QObject(parent), m_session(session), m_current(QSettings().value(currentProjectKey).toString())
{
    session.onChange(ChangeKind::step, this, &ProjectDesk::changed);
    session.onChange(ChangeKind::texts, this, [this] {
        m_job.cancel();
        m_judgedLesson.clear();
        m_judgedLevel.clear();
        emit changed();
    });
    connect(&session.progress(), &Progress::changed, this, &ProjectDesk::changed);
}

const lessons::Project *ProjectDesk::projectOf(const QString &lesson) const
{
    const LessonEntry *entry = m_session.library().lesson(lesson);
    return entry && entry->project ? &*entry->project : nullptr;
}

const Experiment *ProjectDesk::startOf(const QString &lesson)
{
    const auto known = m_starts.find(lesson);
    if (known != m_starts.end())
        return known->second ? &*known->second : nullptr;
    std::optional<Experiment> &start = m_starts[lesson];
    if (!projectOf(lesson))
        return nullptr;
    try {
        start = projectStart(*m_session.library().lesson(lesson), m_session.library());
    } catch (const UserError &error) { // the lesson is at fault
        m_session.showMessage(error.sentence());
    }
    return start ? &*start : nullptr;
}

std::pair<QString, QString> ProjectDesk::placeOf(const QString &lesson)
{
    const Experiment *start = startOf(lesson);
    return start ? std::pair{start->lesson, start->step} : std::pair<QString, QString>{};
}

bool ProjectDesk::isAtPlace(const QString &lesson)
{
    return placeOf(lesson) == std::pair{m_session.lesson().id, m_session.step().id};
}

std::vector<lessons::ProjectRing> ProjectDesk::rings()
{
    const lessons::Project *project = projectOf(m_current);
    if (!project || !isAtPlace(m_current))
        return {};
    std::vector<lessons::ProjectRing> rings;
    for (const lessons::ProjectLevel &level : project->levels) {
        for (const lessons::ProjectRing &ring : level.rings) {
            if (!contains(rings, ring)) // two levels can have the same
                rings.push_back(ring);
        }
    }
    return rings;
}

void ProjectDesk::setCurrent(const QString &lesson)
{
    m_current = lesson;
    QSettings().setValue(currentProjectKey, lesson);
    emit changed();
}

void ProjectDesk::start(const QString &lesson)
{
    const Experiment *scene = startOf(lesson);
    if (!scene)
        return;
    goOn(lesson);
    RunEditor &editor = m_session.editor();
    const EditLabel label{tr("Start “%1”").arg(projectOf(lesson)->title), {}, {}};
    editor.endGesture();
    const bool isOpen = m_session.isSandbox() ? editor.replaceScene(label, scene->script, scene->draft)
                                              : editor.setUp(label, scene->script, RunEditor::Maker::program);
    editor.endGesture();
    if (isOpen)
        m_session.showMessage(tr("The start scene is open. Undo brings your scene back."));
}

void ProjectDesk::goOn(const QString &lesson)
{
    if (!startOf(lesson))
        return;
    const auto [place, step] = placeOf(lesson);
    if (!isAtPlace(lesson))
        m_session.openStep(place, step);
    setCurrent(lesson);
    emit opened();
}

void ProjectDesk::putAway()
{
    cancel();
    setCurrent({});
}

void ProjectDesk::judge(const QString &lesson, const QString &level)
{
    const Experiment *scene = startOf(lesson);
    if (!scene)
        return;
    const lessons::ProjectLevel *found = findById(projectOf(lesson)->levels, level);
    const auto [place, step] = placeOf(lesson);
    const std::optional<Experiment> built =
        isAtPlace(lesson) ? m_session.experiment() : m_session.experimentOf(place, step);
    if (!found)
        return;
    cancel();
    const LessonEntry *where = m_session.library().lesson(place);
    const sim::Script &start = scene->script;
    // The lessons outlive the session, and with it this job.
    const ProjectTrial trial{*found, where ? where->step(step) : nullptr, start,
                             built ? built->script : start, built && built->draft};
    if (!trial.step)
        return;
    m_judgedLesson = lesson;
    m_judgedLevel = level;
    m_judged = {place, step, std::max(1, trial.level.run.frames), trial.built};
    m_percent = 0;
    m_job.start(
        [this, trial](const BackgroundJob::Context &context) {
            const auto report = [&](int percent) {
                context.report([this, percent] {
                    m_percent = percent;
                    emit changed();
                });
            };
            return judgeProject(trial, report, context.shouldContinue());
        },
        [this](std::future<std::optional<ProjectVerdict>> verdict) { receive(std::move(verdict)); });
    emit changed();
}

void ProjectDesk::cancel()
{
    m_job.cancel();
    m_judgedLesson.clear();
    m_judgedLevel.clear();
    emit changed();
}

void ProjectDesk::receive(std::future<std::optional<ProjectVerdict>> future)
{
    const QString lesson = std::exchange(m_judgedLesson, {}), level = std::exchange(m_judgedLevel, {});
    try {
        if (const std::optional<ProjectVerdict> verdict = future.get()) {
            m_verdicts[{lesson, level}] = *verdict;
            if (verdict->isPassed()) {
                keepProof(lesson, level);
                m_session.progress().markWritten(lesson, ticksOfProjects, level);
            }
        }
    } catch (const std::exception &error) { // the lesson is at fault
        m_session.showMessage(QString::fromUtf8(error.what()));
    }
    emit changed();
}

void ProjectDesk::keepProof(const QString &lesson, const QString &level)
{
    try {
        m_session.proofs().keep(Notes::keyOf(lesson, ticksOfProjects, QStringLiteral("code"), level),
                                {.run = experimentLine(m_judged, m_session.library())});
    } catch (const UserError &) { // too large for a line: the tick stays without a proof
    }
}

const ProjectVerdict *ProjectDesk::verdict(const QString &lesson, const QString &level) const
{
    const auto found = m_verdicts.find({lesson, level});
    return found == m_verdicts.end() ? nullptr : &found->second;
}

bool ProjectDesk::isPassed(const QString &lesson, const QString &level) const
{
    return m_session.progress().isWritten(lesson, ticksOfProjects, level);
}

int ProjectDesk::passedLevels(const QString &lesson) const
{
    const lessons::Project *project = projectOf(lesson);
    if (!project)
        return 0;
    const auto &levels = project->levels;
    return static_cast<int>(std::count_if(levels.begin(), levels.end(),
                                          [&](const auto &one) { return isPassed(lesson, one.id); }));
}

}
