#include "app/model/session/presentation.h"

#include "app/model/picture/overlays.h"
#include "app/model/text/phrases.h"
#include "app/model/text/sentences.h"
#include "app/model/text/step_text.h"

#include <algorithm>
#include <utility>

namespace app {

namespace {

constexpr std::int64_t mostPointSteps = 3'000'000; ///< points times steps, to explain one moment

}

Picture Presentation::pictureOf(const sim::Track &track,
                                std::shared_ptr<const sim::ComposedInterval> interval, sim::State state) const
{
    Picture picture;
    picture.view = m_views.of(m_run.step(), track.script(), interval);
    picture.overlays = overlaysOf(m_run.step(), track, *interval, state);
    picture.interval = std::move(interval);
    picture.state = std::move(state);
    return picture;
}

Picture Presentation::currentPicture(const sim::Track &track) const
{
    if (!m_preview.run().hasPendingInput())
        return pictureOf(track, track.intervalPtr(), track.state());
    std::shared_ptr<const sim::ComposedInterval> interval;
    sim::State state = track.preview(interval);
    return pictureOf(track, std::move(interval), std::move(state));
}

Picture Presentation::picture() const
{
    const sim::Track &track = m_preview.run().track();
    if (m_lines.state() && !m_preview.isActive())
        return pictureOf(track, track.nextInterval(), *m_lines.state());
    return currentPicture(track);
}

std::optional<Picture> Presentation::comparison() const
{
    const sim::Track *track = m_preview.run().comparison();
    if (!track || track->cursor().frame != m_preview.run().cursor().frame)
        return std::nullopt;
    return pictureOf(*track, track->intervalPtr(), track->state());
}

std::optional<Picture> Presentation::companion() const
{
    const sim::Track *track = m_companion.isThere() ? m_companion.track() : nullptr;
    return track ? std::optional(currentPicture(*track)) : std::nullopt;
}

QString Presentation::ownCaption() const
{
    const sim::Script &script = m_run.timeline().script();
    return listed(phrase(script.method->title()), stepTitle(script.step));
}

QString Presentation::note() const
{
    return m_run.step().note ? m_run.step().note(m_preview.run().track()) : QString();
}

std::vector<sim::PhaseExplanation> Presentation::explanations() const
{
    const sim::Track &track = m_preview.run().track();
    const std::int64_t end =
        track.cursor().phase > 0 ? track.cursor().frame : track.cursor().frame - track.framesPerOutput();
    const std::int64_t outputSteps =
        (end - track.cachedFrameBefore(std::max<std::int64_t>(0, end))) / track.framesPerOutput();
    if (outputSteps * track.script().step.stepsPerOutput * track.state().pointCount() > mostPointSteps)
        return {};
    return track.explainPhases(m_run.selected().toStdString());
}

}
