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

Picture Session::pictureOf(const sim::Track &track, std::shared_ptr<const sim::Segment> segment,
                           sim::State state) const
{
    Picture picture;
    picture.look = m_looks.of(step(), track.script(), segment);
    picture.guides = guidesOf(step(), track, *segment, state);
    picture.segment = std::move(segment);
    picture.state = std::move(state);
    return picture;
}

Picture Session::picture() const
{
    const sim::Track &track = shown().track();
    if (!shown().hasPending())
        return pictureOf(track, track.shownPtr(), track.now());
    std::shared_ptr<const sim::Segment> segment;
    sim::State state = track.preview(segment);
    return pictureOf(track, std::move(segment), std::move(state));
}

bool Session::bringCompanion()
{
    m_companionIsThere = !m_companion || m_companion->follow(m_timeline->script(), shown().at().frame);
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
    if (!shown().hasPending())
        return pictureOf(*track, track->shownPtr(), track->now());
    std::shared_ptr<const sim::Segment> segment;
    sim::State state = track->preview(segment);
    return pictureOf(*track, std::move(segment), std::move(state));
}

std::vector<sim::Moment> Session::moments() const
{
    const sim::Track &track = shown().track();
    const std::int64_t end = track.at().phase > 0 ? track.at().frame : track.at().frame - track.rowFrames();
    const std::int64_t rows = (end - track.knownBefore(std::max<std::int64_t>(0, end))) / track.rowFrames();
    if (rows * track.script().step.perRow * track.now().points() > mostComputedAgain)
        return {};
    return track.moments(m_selected.toStdString());
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
    const sim::Track *track = shown().ghost();
    if (!track || track->at().frame != shown().at().frame)
        return std::nullopt;
    return pictureOf(*track, track->shownPtr(), track->now());
}

}
