#pragma once

#include "app/model/listing/line_stepper.h"
#include "app/model/picture/view_cache.h"
#include "app/model/session/companion_follower.h"
#include "app/model/session/picture.h"
#include "sim/analysis/force_snapshot.h"

#include <QObject>

#include <optional>
#include <vector>

namespace app {

/// Returns the pictures and explanations of the moment that is shown.
class Presentation : public QObject
{
    Q_OBJECT

public:
    Presentation(const OpenRun &run, const Preview &preview, const CompanionFollower &companion,
                 const LineStepper &lines)
        : m_run(run), m_preview(preview), m_companion(companion), m_lines(lines)
    {
    }

    /// Returns the picture of the moment that is shown, also between two lines of the listing.
    Picture picture() const;
    /// Returns the comparison run at the frame shown, if there is one.
    std::optional<Picture> comparison() const;
    /// Returns the companion run at the moment shown. Empty if the step has none, if its method cannot compute the
    /// scene, or while it is computed.
    std::optional<Picture> companion() const;
    /// Returns whether the companion run is being computed; ChangeKind::cursor announces it.
    bool isCompanionComing() const { return m_companion.isComing(); }
    /// Returns the name of the run next to its companion: method and step size.
    QString ownCaption() const;
    /// Returns the step's remark about this moment; may be empty.
    QString note() const;
    /// Returns the effects of the current or last step's phases on the selected body. Empty if the computation would
    /// take too long: with many points, far from a keyframe.
    std::vector<sim::PhaseExplanation> explanations() const;
    /// Returns the accelerations so far; inside a frame only.
    std::vector<sim::ForceSnapshot> forces() const { return sim::accumulatedForces(m_preview.run().track()); }

private:
    /// Returns the picture of `track`, including input that has been given since its last step.
    Picture currentPicture(const sim::Track &track) const;
    Picture pictureOf(const sim::Track &track, std::shared_ptr<const sim::ComposedInterval> interval,
                      sim::State state) const;

    const OpenRun &m_run;
    const Preview &m_preview;
    const CompanionFollower &m_companion;
    const LineStepper &m_lines;
    mutable ViewCache m_views;
};

}
