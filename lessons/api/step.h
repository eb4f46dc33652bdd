#pragma once

#include "lessons/api/look.h"
#include "lessons/api/parameter.h"
#include "sim/timeline.h"

#include <functional>
#include <vector>

namespace lessons {

/// A thing to try, and how the machine sees that it was done.
struct Try
{
    QString text; ///< Markdown, one or two short sentences
    /// Looked at after each frame and each change; once true, the thing is done. Must be false at the start and
    /// for a run that nobody touches.
    std::function<bool(const sim::Timeline &)> done;
};

/// One step of a lesson.
struct Step
{
    QString id;
    QString title;
    QString narration; ///< Markdown
    std::vector<Parameter> parameters;
    std::vector<Try> tries;
    std::function<sim::Scene(const sim::Values &)> scene;
    sim::Region setUp; ///< the source of `scene`
    std::function<Look(const sim::Scene &, const sim::Values &)> look;
    /// May be empty.
    std::function<std::vector<Guide>(const sim::Scene &, const sim::State &, const sim::Values &)> guides;
    QString method = QStringLiteral("published");
    double h = 1.0; ///< frames

    const Parameter *parameter(const QString &wanted) const;
    sim::Values presets() const;
    /// The run of this step that nobody has touched.
    sim::Script script() const;
};

}
