#include "app/model/session.h"

#include "app/model/sentences.h"

#include <QElapsedTimer>

#include <algorithm>
#include <utility>

namespace app {

namespace {

constexpr qint64 sliceMilliseconds = 12;
constexpr std::int64_t sliceSteps = 64;
/// What a run costs is measured no more often than this.
constexpr qint64 measureAgainMilliseconds = 500;

}

Session::Session(const LessonLibrary &library, QObject *parent) : QObject(parent), m_library(library)
{
    connect(&m_player, &Player::due, this, &Session::advance);
    // The first who hears of it: whoever draws the moment draws the companion, too.
    connect(this, &Session::moved, this, &Session::bringCompanionLater);
    start(step().script(), {});
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
    return m_lesson > 0 ? &m_library.lessons[m_lesson - 1].steps.back() : nullptr;
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
    for (std::size_t i = 0; i < m_library.lessons.size(); ++i) {
        const LessonEntry &entry = m_library.lessons[i];
        for (std::size_t j = 0; j < entry.steps.size(); ++j) {
            if (entry.id != lessonId || entry.steps[j].id != stepId)
                continue;
            leave();
            m_lesson = i;
            m_step = j;
            const auto left = m_left.find(keyOf(lessonId, stepId));
            if (left != m_left.end())
                start(left->second.script, left->second.at);
            else
                start(step().script(), {});
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
    start(experiment.script, {});
}

Experiment Session::experiment() const
{
    return {lesson().id, step().id, std::max<std::int64_t>(1, m_timeline->computed()), m_timeline->script()};
}

void Session::leave()
{
    pause();
    letGo();
    letUp();
    m_left.insert_or_assign(keyOf(lesson().id, step().id), Left{m_timeline->script(), m_timeline->at()});
}

void Session::start(sim::Script script, sim::Cursor at)
{
    auto timeline = std::make_unique<sim::Timeline>(std::move(script)); // throws before anything has changed
    m_goingTo.reset();
    m_holding = false;
    m_keys = {};
    m_pointerDown.reset();
    m_ghostName.clear();
    m_otherStep.reset();
    m_timeline = std::move(timeline);
    m_companion.reset();
    if (step().companion)
        m_companion.emplace(*step().companion);
    bringCompanion();
    m_selected = QString::fromStdString(m_timeline->track().shown().scene.names.front());
    emit stepOpened();
    goTo(at);
}

void Session::setSpeed(double speed)
{
    m_player.setSpeed(speed);
    emit playingChanged();
}

void Session::play()
{
    if (isPlaying())
        return;
    m_goingTo.reset();
    m_player.play();
    emit playingChanged();
}

void Session::pause()
{
    m_goingTo.reset();
    if (!isPlaying())
        return;
    m_player.pause();
    emit playingChanged();
}

void Session::togglePlaying()
{
    isPlaying() ? pause() : play();
}

void Session::frameForward()
{
    pause();
    advance(1);
}

void Session::frameBack()
{
    pause();
    m_timeline->stepRowBack();
    checkTries();
    emit moved();
}

void Session::phaseForward()
{
    pause();
    m_timeline->stepPhase();
    checkTries();
    emit moved();
}

void Session::phaseBack()
{
    pause();
    m_timeline->stepPhaseBack();
    checkTries();
    emit moved();
}

void Session::goTo(sim::Cursor cursor)
{
    m_goingTo = {std::max<std::int64_t>(0, cursor.frame), cursor.phase};
    approach();
    checkTries();
    emit moved();
}

void Session::approach()
{
    if (!m_goingTo)
        return;
    QElapsedTimer clock;
    clock.start();
    const int rowFrames = m_timeline->track().rowFrames();
    const std::int64_t target = m_goingTo->frame;
    const std::int64_t slice =
        std::max<std::int64_t>(1, sliceSteps / m_timeline->script().step.perRow) * rowFrames;
    // Frames that were computed before, and every way back, cost one seek at the most.
    if (target <= m_timeline->computed())
        m_timeline->seek({target, 0});
    while (m_timeline->at().frame + rowFrames <= target && clock.elapsed() < sliceMilliseconds &&
           !m_timeline->stop())
        m_timeline->seek({std::min(target, m_timeline->at().frame + slice), 0});
    const bool isThere = m_timeline->at().frame + rowFrames > target || m_timeline->stop();
    if (bringCompanion() && isThere) {
        const int phase = m_goingTo->phase;
        m_goingTo.reset();
        if (phase > 0)
            m_timeline->seek({m_timeline->at().frame, phase});
        return;
    }
    // One call at a time, however often the goal changes meanwhile.
    if (std::exchange(m_approachDue, true))
        return;
    QTimer::singleShot(0, this, [this] {
        m_approachDue = false;
        approach();
        checkTries();
        emit moved();
    });
}

void Session::rewind()
{
    pause();
    goTo({});
}

void Session::startAfresh()
{
    pause();
    start(step().script(), {});
}

void Session::advance(int frames)
{
    const bool wasStopped = m_timeline->stop().has_value();
    for (int i = 0; i < frames; ++i) {
        m_timeline->stepRow();
        checkTries();
    }
    const std::optional<sim::Stop> &stop = m_timeline->stop();
    if (stop && m_timeline->at().frame == stop->frame) {
        if (isPlaying() || !wasStopped)
            emit said(sentenceFor(*stop));
        pause();
    }
    emit moved();
}

void Session::forgetGhost()
{
    m_timeline->forgetGhost();
    m_ghostName.clear();
    emit runChanged();
    emit moved();
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
    const bool mayMeasure =
        !m_sinceMeasured.isValid() || m_sinceMeasured.elapsed() >= measureAgainMilliseconds;
    const auto keeps = [&](const lessons::Budget &budget) {
        if (!mayMeasure)
            return false;
        const bool kept = lessons::keeps(budget, m_timeline->script(), lessons::measuredTime);
        m_sinceMeasured.start();
        return kept;
    };
    const std::vector<lessons::Try> &tries = step().tries;
    for (int i = 0; i < static_cast<int>(tries.size()); ++i) {
        const lessons::Try &one = tries[static_cast<std::size_t>(i)];
        if (!m_progress.isDone(lesson().id, step().id, i) && one.done(*m_timeline) &&
            (!one.budget || keeps(*one.budget)))
            m_progress.markDone(lesson().id, step().id, i);
    }
}

}
