#pragma once

#include "lessons/api/explanation.h"
#include "lessons/api/listing.h"
#include "lessons/api/parameter.h"
#include "lessons/api/prediction.h"
#include "lessons/api/text/document.h"
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

/// A number that is measured in every frame and plotted over the last frames.
struct Measure
{
    QString name = {};
    QString unit = {}; ///< may be empty
    QString help = {}; ///< one sentence: what the number means
    int decimals = 1;
    /// Returns the number for a state; not finite if there is nothing to measure. `before` is the state a
    /// frame earlier, or null at the start.
    std::function<double(const sim::Scene &, const sim::State &, const sim::State *before,
                         const sim::Values &)>
        of = {};
    /// Replaces `of` for a number that depends on the script of the run, too.
    std::function<double(const sim::Script &, const sim::Scene &, const sim::State &,
                         const sim::State *before, const sim::Values &)>
        ofRun = {};
};

/// A named set of parameter values. All other parameters take their default values.
struct Preset
{
    QString title = {};
    QString help = {}; ///< one sentence: the result to expect
    std::vector<std::pair<QString, double>> values = {};
};

/// A kind of input to a scene besides changes of parameters. Files name each kind by its event.
enum class Interaction {
    drag,    ///< grab, move, release
    pointer, ///< the scene reads the pointer's position and button
    target,  ///< a click sets a target
    gust,    ///< the turbulence of one frame, from files only
    keys,    ///< the scene reads the arrow keys while it plays
};

/// The columns that `trace` writes for each body besides its name.
enum class TraceColumns { positionAndVelocity, position, positionAndAngle };

/// The source of the points and sticks of a scene.
enum class PointSource {
    step,  ///< the step's own set-up function
    file,  ///< if a file lists bodies p0, p1... or links, they replace the step's points or sticks
    scene, ///< Values::blueprint, which a file or the sandbox sets
};

/// An experiment that comes with a step.
struct Example
{
    QString title = {};
    QString help = {}; ///< one sentence: what to watch and to try
    QString file = {}; ///< an embedded experiment file of this step
};

/// A second run of the same script with another method or other values, drawn beside the run.
struct Companion
{
    QString method = {};   ///< id
    QString caption = {};  ///< a few words
    sim::Vec2 offset = {}; ///< px, added to the positions of its points when it is drawn
    double h = 1.0;        ///< frames, its step
    /// Values of the parameters that differ from those of the run.
    std::vector<std::pair<QString, double>> values = {};
};

/// One step of a lesson.
struct Step
{
    QString lesson; ///< the folder of the lesson; empty if the step has no document
    QString id;
    QString title;
    QString narration; ///< Markdown
    Explanation explanation;
    std::vector<Parameter> parameters;
    std::vector<Try> tries;
    std::vector<Check> checks = {}; ///< tests of `tries`, which setTexts() joins with their texts
    /// The program of a frame, which learners read and change. Empty if the step has none.
    Listing listing = {};
    std::vector<CodeTask> codeTasks = {}; ///< tasks to write a part of the listing
    std::vector<Prediction> predictions = {};
    std::function<sim::Scene(const sim::Values &)> scene;
    sim::Region sceneSource; ///< the source code of `scene`
    std::function<View(const sim::Scene &, const sim::Values &)> view;
    /// Returns the overlays for a state. May be empty.
    std::function<std::vector<Overlay>(const sim::Scene &, const sim::State &, const sim::Values &)> overlays;
    /// Returns further overlays, which depend on the script of the run. May be empty. `frame` is the frame of
    /// the state; inside a frame, it is the frame in progress.
    std::function<std::vector<Overlay>(const sim::Script &, const sim::State &, std::int64_t frame)>
        runOverlays;
    /// If set, both runs are drawn on the view's stage, each with a caption above it.
    std::optional<Companion> companion = {};
    /// Returns a note about the state at the run's cursor, between two frames. It is shown over the scene.
    /// May be empty.
    std::function<QString(const sim::Track &)> note = {};
    /// Completes a script that has values and a method: it may set input, start states of bodies, and the
    /// step. May be empty.
    std::function<void(sim::Script &)> prepareScript = {};
    /// Numbers shown beside the scene. May be empty.
    std::vector<Measure> measures;
    /// Shown as a gallery. May be empty.
    std::vector<Preset> presets;
    /// Shown as a gallery in the sandbox. May be empty.
    std::vector<Example> examples = {};
    /// In the sandbox: the effects that a learner can add, besides those of springs, sticks and feet.
    std::vector<const sim::EffectDescription *> availableEffects = {};
    /// Returns whether a foot of View::feet is planted on the ground. Required if there are feet.
    std::function<bool(const sim::Scene &, const sim::State &, const sim::Values &, int point)> isFootDown;
    std::vector<Interaction> interactions = {Interaction::drag};
    TraceColumns traceColumns = TraceColumns::positionAndVelocity;
    PointSource points = PointSource::step;
    QString method = QStringLiteral("published");
    double h = 1.0; ///< frames, the default step

    /// Returns whether the step allows this kind of input.
    bool accepts(Interaction interaction) const;
    /// Appends parameters.
    void addParameters(const std::vector<Parameter> &more);

    /// Reads the texts of the step from its document, in the language of documentLanguage(), and joins its things to
    /// try with `tests`.
    /// @throws DocumentError as readDocument() and setTexts()
    void readTexts(const std::vector<Check> &tests);
    /// Takes all texts from `document`.
    /// @throws DocumentError if the document lacks a thing to try or a sentence of `checks`, or has another one, or
    /// if a task is about a gap that the listing lacks. The step is then unchanged.
    void setTexts(const Document &document);

    /// Returns a parameter by its id. Null if there is none.
    const Parameter *parameter(const QString &parameterId) const;
    /// Returns the first parameter with this role. Null if there is none.
    const Parameter *parameterFor(ParameterRole role) const;
    sim::Values defaultValues() const;
    /// Returns the script of this step with default values, its default method, and no learner's input.
    sim::Script script() const;
    /// Returns the script of this step with other values and another method.
    sim::Script scriptWith(const sim::Values &values, const sim::MethodPtr &chosenMethod) const;
};

/// Returns a step of the lesson in folder `lesson`, without texts: see Step::readTexts(). The region `id` of its
/// scenes.cpp is the source of the scene, and the resource `id`.code is its listing.
/// @throws std::runtime_error if the gaps of the listing are wrong
Step makeStep(const QString &lesson, const QString &id);

}
