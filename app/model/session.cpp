#include "app/model/session.h"

#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <utility>

namespace app {

namespace {

constexpr int mostDeeds = 100; ///< that can be undone

}

Session::Session(const LessonLibrary &library, QObject *parent) : QObject(parent), m_library(library)
{
    m_deeds.setUndoLimit(mostDeeds);
    connect(&m_player, &Player::due, this, &Session::advance);
    // The first who hear of it: whoever draws the moment draws no other one, and the companion, too.
    for (const auto change : {&Session::moved, &Session::runChanged, &Session::playingChanged})
        connect(this, change, this, &Session::lookNoMore);
    connect(this, &Session::moved, this, &Session::bringCompanionLater);
    connect(&m_attempts, &Attempts::checkDue, this, &Session::checkTries);
    watchBreakpoints();
    start(step().script(), {}, {});
}

const lessons::Step *Session::following() const
{
    if (m_step + 1 < lesson().steps.size())
        return &lesson().steps[m_step + 1];
    return m_lesson + 1 < m_library.lessons.size() ? &m_library.lessons[m_lesson + 1].steps.front() : nullptr;
}

const lessons::Step *Session::preceding() const
{
    if (m_step > 0)
        return &lesson().steps[m_step - 1];
    return m_lesson > 0 && !isWorkshop() ? &m_library.lessons[m_lesson - 1].steps.back() : nullptr;
}

bool Session::isStepDone(const LessonEntry &lesson, const lessons::Step &step) const
{
    for (int i = 0; i < static_cast<int>(step.tries.size()); ++i) {
        if (!m_progress.isDone(lesson.id, step.id, i))
            return false;
    }
    return !step.tries.empty();
}

void Session::openStep(const QString &lessonId, const QString &stepId)
{
    for (std::size_t i = 0; i < m_library.entries(); ++i) {
        const LessonEntry &entry = m_library.entry(i);
        for (std::size_t j = 0; j < entry.steps.size(); ++j) {
            if (entry.id != lessonId || entry.steps[j].id != stepId)
                continue;
            leave();
            m_deeds.clear();
            m_lesson = i;
            m_step = j;
            const auto left = m_left.find(keyOf(lessonId, stepId));
            if (left != m_left.end())
                start(left->second.script, left->second.at, left->second.branches);
            else
                start(step().script(), {}, {});
            return;
        }
    }
}

void Session::openFollowing()
{
    if (!following())
        return;
    const bool same = m_step + 1 < lesson().steps.size();
    openStep(same ? lesson().id : m_library.lessons[m_lesson + 1].id, following()->id);
}

void Session::openPreceding()
{
    if (!preceding())
        return;
    openStep(m_step > 0 ? lesson().id : m_library.lessons[m_lesson - 1].id, preceding()->id);
}

void Session::open(const Experiment &experiment)
{
    sim::Timeline trial(experiment.script); // throws before anything has changed
    openStep(experiment.lesson, experiment.step);
    start(experiment.script, {}, experiment.branches.renumbered(m_lastBranch));
    m_deeds.clear();
}

Experiment Session::experiment() const
{
    return {lesson().id, step().id, std::max<std::int64_t>(1, m_timeline->computed()), m_timeline->script(),
            m_branches.marked()};
}

std::optional<Experiment> Session::left(const QString &lesson, const QString &step) const
{
    const auto found = m_left.find(keyOf(lesson, step));
    if (found == m_left.end())
        return std::nullopt;
    return Experiment{lesson, step, std::max<std::int64_t>(1, found->second.at.frame), found->second.script,
                      found->second.branches.marked()};
}

void Session::leave()
{
    pause();
    letGo();
    letUp();
    m_left.insert_or_assign(keyOf(lesson().id, step().id),
                            Left{m_timeline->script(), m_timeline->cursor(), m_branches});
}

void Session::start(sim::Script script, sim::Cursor at, Branches branches)
{
    auto timeline = std::make_unique<sim::Timeline>(std::move(script)); // throws before anything has changed
    endGlance();
    m_goingTo.reset();
    m_holding = false;
    m_keys = {};
    m_pointerDown.reset();
    m_coming.reset();
    m_beside = 0;
    m_branches = std::move(branches);
    m_otherStep.reset();
    m_timeline = std::move(timeline);
    m_companion.reset();
    if (step().companion)
        m_companion.emplace(*step().companion);
    bringCompanion();
    m_selected = QString::fromStdString(m_timeline->track().interval().scene.names.front());
    m_breakpoints.open(keyOf(lesson().id, step().id));
    m_watch.watch(m_breakpoints.all(), step());
    emit stepOpened();
    goTo(at);
}

void Session::select(const QString &body)
{
    if (body == m_selected)
        return;
    m_selected = body;
    emit selectionChanged();
}

void Session::checkTries()
{
    m_attempts.check(lesson().id, step(), *m_timeline, isPlaying());
}

QString Session::todo(int number) const
{
    return m_attempts.todo(lesson().id, step(), number, *m_timeline, isPlaying());
}

}
