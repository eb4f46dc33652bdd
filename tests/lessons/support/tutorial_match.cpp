#include "tests/lessons/support/tutorial_match.h"

#include "sim/run/track.h"
#include "sim/scene/scene.h"

#include <algorithm>
#include <cmath>

namespace support {

namespace {

double between(double min, double max, std::mt19937 &random)
{
    return std::uniform_real_distribution<double>(min, max)(random);
}

Clip randomClip(double width, std::mt19937 &random)
{
    Clip clip;
    clip.x = between(200, 340, random);
    clip.y = between(130, 270, random);
    clip.vx = between(-4, 4, random);
    clip.vy = between(-4, 4, random);
    clip.width = width;
    return clip;
}

std::vector<std::string> namesOf(const Tutorial &tutorial)
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < tutorial.feet.size(); ++i)
        names.push_back("foot" + std::to_string(i));
    if (tutorial.kind != Tutorial::Kind::fixedCentre)
        names.push_back("body");
    return names;
}

/// Returns three drags. Each grabs a random body, moves it along a straight line for 15 frames and releases
/// it.
std::vector<sim::Event> randomDrags(const std::vector<std::string> &names, std::mt19937 &random)
{
    std::vector<sim::Event> input;
    std::int64_t frame = 20;
    for (int drag = 0; drag < 3; ++drag) {
        const auto chosen = std::uniform_int_distribution<std::size_t>(0, names.size() - 1)(random);
        input.push_back({frame, sim::Grab{names[chosen]}});
        sim::Vec2 pointer{between(100, 400, random), between(50, 350, random)};
        const sim::Vec2 velocity{between(-9, 9, random), between(-9, 9, random)};
        for (int i = 0; i < 15; ++i, ++frame) {
            input.push_back({frame, sim::Move{pointer}});
            pointer = pointer + velocity;
        }
        if (drag == 1)
            frame += 10; // holds still before the release
        input.push_back({frame, sim::Release{}});
        frame += 25;
    }
    return input;
}

/// Returns the name of a clip in `scene`. In the first two lessons the only foot has no number.
std::string nameIn(const sim::Scene &scene, const std::string &name)
{
    return scene.find(name) < 0 && name == "foot0" ? "foot" : name;
}

sim::Script scriptFor(const lessons::Step &step, const Tutorial &tutorial)
{
    sim::Script script = step.script();
    const std::map<std::string, double> numbers = {
        {"k", tutorial.k},           {"damp", tutorial.damp},        {"radius", tutorial.radius},
        {"offset", tutorial.offset}, {"centre_x", tutorial.centreX}, {"centre_y", tutorial.centreY},
        {"left", tutorial.left},     {"right", tutorial.right},      {"floor", tutorial.floor},
        {"bounce", tutorial.bounce}, {"gravity", tutorial.gravity},  {"feet", double(tutorial.feet.size())},
    };
    for (const auto &[id, value] : numbers) {
        if (script.values.has(id))
            script.values.set(id, value);
    }
    const sim::Scene scene = script.build(script.values);
    const std::vector<std::string> names = namesOf(tutorial);
    const std::vector<Clip> clips = tutorial.clips();
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Clip &clip = clips[i];
        script.bodies[nameIn(scene, names[i])] = {{clip.x, clip.y}, sim::Vec2{clip.vx, clip.vy}};
    }
    script.input = tutorial.input;
    for (sim::Event &event : script.input) {
        if (auto *grab = std::get_if<sim::Grab>(&event.what))
            grab->body = nameIn(scene, grab->body);
    }
    return script;
}

double difference(const sim::State &state, const std::vector<Clip> &clips)
{
    if (state.pointCount() != static_cast<int>(clips.size()))
        return INFINITY;
    double largest = 0.0;
    for (int i = 0; i < state.pointCount(); ++i) {
        const Clip &clip = clips[static_cast<std::size_t>(i)];
        const sim::Vec2 x = state.positionOf(i), v = state.velocityOf(i);
        largest = std::max({largest, std::abs(x.x - clip.x), std::abs(x.y - clip.y), std::abs(v.x - clip.vx),
                            std::abs(v.y - clip.vy)});
    }
    return largest;
}

}

Tutorial randomTutorial(Tutorial::Kind kind, int feet, std::mt19937 &random)
{
    Tutorial tutorial;
    tutorial.kind = kind;
    tutorial.k = between(0.05, 0.25, random);
    tutorial.damp = between(0.6, 0.85, random);
    tutorial.radius = between(20, 80, random);
    tutorial.offset = between(-80, 80, random);
    tutorial.centreX = between(200, 340, random);
    tutorial.centreY = between(150, 250, random);
    for (int i = 0; i < feet; ++i)
        tutorial.feet.push_back(randomClip(10.0, random));
    tutorial.body = randomClip(30.0, random);
    if (kind != Tutorial::Kind::mutual)
        tutorial.body.vx = tutorial.body.vy = 0.0; // a handle keeps no velocity
    tutorial.input = randomDrags(namesOf(tutorial), random);
    return tutorial;
}

double largestDifference(const lessons::Step &step, const Tutorial &tutorial, int frames)
{
    sim::Track track(scriptFor(step, tutorial), 0);
    Tutorial other = tutorial;
    double largest = difference(track.state(), other.clips());
    for (int frame = 1; frame <= frames; ++frame) {
        track.seek({frame, 0});
        other.enterFrame();
        largest = std::max(largest, difference(track.state(), other.clips()));
    }
    return largest;
}

}
