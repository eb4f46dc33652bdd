#pragma once

#include "app/listing/program.h"
#include "sim/run/script/script.h"
#include "sim/scene/scene.h"

#include <QString>

#include <optional>
#include <string>

/// Shared by the suites of listings.
namespace listing_support {

/// Returns a scene with the points "foot0", "foot1"... at (10 i, 0), "body" at (100, 50), all at rest, and the
/// parameters k = 0.25, damp = 0.5 and radius = 50.
sim::Scene threeFeet();

/// Returns three creatures with two feet each, all points at (0, 0). Their gait clocks are at 0, 1 and 2 and gain
/// 0.5 in a frame. The parameters are floor = 380 and k = 0.25.
sim::Scene threeCreatures();

/// Returns a trunk of 100 px at (0, 0) with two branches, 0.8 and 0.7 times as large, which swings in gusts. k = 0.25.
sim::Scene swingingBush();

/// Returns the points "p0" at (0, 0), "p1" at (3, 4) and "tail0_0" at (3, 4), joined by two sticks: the first is
/// 10 px long and p0 takes 0.25 of its error, the second is 7 px long. k = 0.25.
sim::Scene twoSticks();

/// A compiled listing with a scene that it runs in.
struct Bench
{
    sim::Scene scene;
    std::shared_ptr<const listing::Program> program;
    listing::Binding binding;
    sim::State state = scene.start;

    /// Compiles `text` for `scene`. Fails the test with the errors if it does not compile.
    explicit Bench(const std::string &text, const sim::Scene &scene = threeFeet());
    /// The same for the body of the function `frame`, in threeFeet().
    static Bench ofFrame(const std::string &body);
    /// Runs one frame; the frame number grows by 1.
    std::optional<listing::RunError> run();
    sim::Vec2 body() const { return state.positionOf(3); }
};

/// Returns `body` as a listing. Its first line is line 3.
std::string frameOf(const std::string &body);

/// Returns the errors of `text`, compiled for `scene`, as "line:column+length sentence" each on a line.
std::string errorsOf(const std::string &text, const sim::Scene &scene = threeFeet());

/// Returns the text of a file of the project. Fails the test if there is none.
std::string fileText(const std::string &path);

/// Returns the variable `name` of `variables` as text: "i = 2", "from = (3, 4)", "foot = feet[1]". Empty if there
/// is none.
std::string shown(const std::vector<listing::Variable> &variables, const std::string &name);

}
