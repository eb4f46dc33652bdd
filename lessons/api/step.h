#pragma once

#include "lessons/api/explanation.h"
#include "lessons/api/parameter.h"
#include "lessons/api/try.h"
#include "sim/base/vec2.h"
#include "sim/forward.h"
#include "sim/scene/explanation.h"

#include <QString>

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace lessons {

struct Overlay;
struct View;

/// A number that is measured of every frame, with its course over the last frames.
struct Measure
{
    QString name = {};
    QString unit = {}; ///< may be empty
    QString help = {}; ///< one sentence: what it says
    int decimals = 1;
    /// `before`: the state a frame earlier, or null at the start. Not finite where there is nothing to measure.
    std::function<double(const sim::Scene &, const sim::State &, const sim::State *before,
                         const sim::Values &)>
        of = {};
    /// For a number that a state alone does not tell, in place of `of`: the same with the script of the whole run.
    std::function<double(const sim::Script &, const sim::Scene &, const sim::State &,
                         const sim::State *before, const sim::Values &)>
        ofRun = {};
};

/// Values of parameters that belong together; what is not named takes its preset.
struct Preset
{
    QString title = {};
    QString help = {}; ///< one sentence: what to expect
    std::vector<std::pair<QString, double>> values = {};
};

/// What a learner can do in a scene besides changing parameters; files name each by its event.
enum class Interaction {
    drag,    ///< grab, move, release
    pointer, ///< the pointer's place and button reach the scene
    target,  ///< a click sets a target
    gust,    ///< a frame's turbulence; files only
    keys,    ///< arrow keys reach the scene while it plays
};

/// What `trace` writes of each body besides its name.
enum class TraceColumns { positionAndVelocity, position, positionAndAngle };

/// Whose the points and sticks of a scene are.
enum class PointsFrom {
    step,
    file,  ///< a file's bodies p0, p1... are all the points there are, and its links all the sticks
    scene, ///< a file's scene is all there is: Values::blueprint
};

/// An experiment that comes with a step.
struct Example
{
    QString title = {};
    QString help = {}; ///< one sentence: what to see, and to try
    QString file = {}; ///< an embedded experiment file of this step
};

/// A second run of the same script, to compare with: its figure is drawn beside that of the run.
struct Companion
{
    QString method = {};   ///< id
    QString caption = {};  ///< who it is, in a few words
    sim::Vec2 offset = {}; ///< px: how far its figure is moved from where its points are
    double h = 1.0;        ///< frames
    /// Of parameters that it does not share with the run.
    std::vector<std::pair<QString, double>> values = {};
};

/// One step of a lesson.
struct Step
{
    QString id;
    QString title;
    QString narration; ///< Markdown
    Explanation explanation;
    std::vector<Parameter> parameters;
    std::vector<Try> tries;
    std::function<sim::Scene(const sim::Values &)> scene;
    sim::Region sceneSource; ///< the source of `scene`
    std::function<View(const sim::Scene &, const sim::Values &)> view;
    /// May be empty.
    std::function<std::vector<Overlay>(const sim::Scene &, const sim::State &, const sim::Values &)> overlays;
    /// Guides that a state alone does not tell, besides those; may be empty. `frame`: the whole frame that the state
    /// stands for; inside a frame the one that is under way.
    std::function<std::vector<Overlay>(const sim::Script &, const sim::State &, std::int64_t frame)>
        runOverlays;
    /// Then both figures stand on the look's stage, each with a caption over it.
    std::optional<Companion> companion = {};
    /// What the step says of the moment at the run's cursor, between two frames, over the scene; may be empty.
    std::function<QString(const sim::Track &)> note = {};
    /// Adds to a script with values and method what its run begins with besides them: input, starts of bodies, its
    /// step. May be empty.
    std::function<void(sim::Script &)> prepareScript = {};
    /// Shown beside the scene; may be empty.
    std::vector<Measure> measures;
    /// Offered as a gallery; may be empty.
    std::vector<Preset> presets;
    /// Offered as a gallery where a learner builds the scene; may be empty.
    std::vector<Example> examples = {};
    /// Where a learner builds the scene: the effects that it can have besides those of its springs, sticks and feet.
    std::vector<const sim::EffectDescription *> availableEffects = {};
    /// Whether one of look().feet stands on the ground; needed where there are any.
    std::function<bool(const sim::Scene &, const sim::State &, const sim::Values &, int point)> isFootDown;
    std::vector<Interaction> interactions = {Interaction::drag};
    TraceColumns traceColumns = TraceColumns::positionAndVelocity;
    PointsFrom points = PointsFrom::step;
    QString method = QStringLiteral("published");
    double h = 1.0; ///< frames

    bool accepts(Interaction what) const;
    /// Adds parameters after those it has.
    void addParameters(const std::vector<Parameter> &more);

    const Parameter *parameter(const QString &wanted) const;
    /// The first with that role; null where there is none.
    const Parameter *parameterFor(ParameterRole role) const;
    sim::Values defaultValues() const;
    /// The run of this step that nobody has touched.
    sim::Script script() const;
    /// The same with other values and by another method.
    sim::Script scriptWith(const sim::Values &values, const sim::MethodPtr &method) const;
};

/// A step of the lesson in folder `lesson`, whose scene is set up in the region `id` of its scenes.cpp.
Step makeStep(const QString &lesson, const QString &id, const QString &title);

}
