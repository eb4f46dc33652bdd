// What a learner sees of the run, its ghost and its companion.

#include "app/model/guides.h"
#include "app/model/sentences.h"
#include "app/model/session.h"
#include "app/model/step_words.h"

#include <QTimer>

#include <algorithm>
#include <utility>

namespace app {

namespace {

constexpr std::int64_t mostComputedAgain = 3'000'000; ///< points times steps, for values of one moment

}

Picture Session::pictureOf(const sim::Track &track, std::shared_ptr<const sim::ComposedInterval> interval,
                           sim::State state) const
{
    Picture picture;
    picture.look = m_looks.of(step(), track.script(), interval);
    picture.guides = guidesOf(step(), track, *interval, state);
    picture.interval = std::move(interval);
    picture.state = std::move(state);
    return picture;
}

Picture Session::picture() const
{
    const sim::Track &track = shown().track();
    if (!shown().hasPendingInput())
        return pictureOf(track, track.intervalPtr(), track.state());
    std::shared_ptr<const sim::ComposedInterval> interval;
    sim::State state = track.preview(interval);
    return pictureOf(track, std::move(interval), std::move(state));
}

bool Session::bringCompanion()
{
    m_companionIsThere = !m_companion || m_companion->follow(m_timeline->script(), shown().cursor().frame);
    return m_companionIsThere;
}

void Session::bringCompanionLater()
{
    if (bringCompanion() || std::exchange(m_companionDue, true))
        return;
    QTimer::singleShot(0, this, [this] {
        m_companionDue = false;
        emit moved();
    });
}

std::optional<Picture> Session::companion() const
{
    const sim::Track *track = m_companion && m_companionIsThere ? m_companion->track() : nullptr;
    if (!track)
        return std::nullopt;
    if (!shown().hasPendingInput())
        return pictureOf(*track, track->intervalPtr(), track->state());
    std::shared_ptr<const sim::ComposedInterval> interval;
    sim::State state = track->preview(interval);
    return pictureOf(*track, std::move(interval), std::move(state));
}

std::vector<sim::PhaseExplanation> Session::moments() const
{
    const sim::Track &track = shown().track();
    const std::int64_t end =
        track.cursor().phase > 0 ? track.cursor().frame : track.cursor().frame - track.framesPerOutput();
    const std::int64_t rows =
        (end - track.cachedFrameBefore(std::max<std::int64_t>(0, end))) / track.framesPerOutput();
    if (rows * track.script().step.stepsPerOutput * track.state().pointCount() > mostComputedAgain)
        return {};
    return track.explainPhases(m_selected.toStdString());
}

QString Session::ownCaption() const
{
    const sim::Script &script = m_timeline->script();
    return tr("%1, %2").arg(phrase(script.method->title()), stepTitle(script.step));
}

QString Session::note() const
{
    return step().note ? step().note(shown().track()) : QString();
}

std::optional<Picture> Session::ghost() const
{
    const sim::Track *track = shown().comparison();
    if (!track || track->cursor().frame != shown().cursor().frame)
        return std::nullopt;
    return pictureOf(*track, track->intervalPtr(), track->state());
}

}
