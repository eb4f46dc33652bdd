#include "tests/lessons/support/walking_tutorial.h"

#include "sim/run/track.h"
#include "tests/lessons/support/tutorial_match.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace support {

void WalkingTutorial::enterFrame()
{
    takeInput();
    if (held())
        moveHeld(held() != &body || kind >= Kind::bodyPulled);
    for (Foot &foot : feet)
        moveFoot(foot);
    moveBody();
}

std::vector<Clip> WalkingTutorial::clips() const
{
    std::vector<Clip> all(feet.begin(), feet.end());
    all.push_back(body);
    return all;
}

Clip *WalkingTutorial::findClip(const std::string &name)
{
    if (name == "body")
        return &body;
    return &feet.at(std::stoul(name.substr(std::string("foot").size())));
}

void WalkingTutorial::moveFoot(Foot &foot)
{
    const double realAngle = kind >= Kind::swing ? foot.angle + m_bodyAngle : foot.angle;
    const double tx = body.x - std::cos(realAngle) * leg;
    double ty = body.y - std::sin(realAngle) * leg;
    if (kind >= Kind::below)
        ty = ty + drop;
    const double ax = (tx - foot.x) * k;
    const double ay = (ty - foot.y) * k;
    if (kind >= Kind::bodyPulled && !isHeld(body)) {
        body.vx -= ax;
        body.vy -= ay;
    }
    if (isHeld(foot))
        return;
    foot.vx += ax;
    foot.vy += ay;
    if (kind == Kind::ground)
        foot.vy += grav;
    foot.vx *= damp;
    foot.vy *= damp;
    foot.x += foot.vx;
    foot.y += foot.vy;
    if (kind == Kind::ground && foot.y > ground) {
        foot.y = ground;
        foot.vy = -foot.vy * bounce;
        if (!ice)
            foot.vx = 0.0;
    }
}

void WalkingTutorial::moveBody()
{
    if (kind >= Kind::bodyPulled && !isHeld(body)) {
        if (kind == Kind::ground)
            body.vy += grav;
        body.vx *= damp;
        body.vy *= damp;
        body.x += body.vx;
        body.y += body.vy;
    }
    m_bodyAngle += speed;
}

WalkingTutorial randomWalk(WalkingTutorial::Kind kind, int feet, std::mt19937 &random)
{
    const auto between = [&](double min, double max) {
        return std::uniform_real_distribution<double>(min, max)(random);
    };
    const Tutorial startAndDrags = randomTutorial(Tutorial::Kind::mutual, feet, random);
    WalkingTutorial walk;
    walk.kind = kind;
    walk.k = between(0.05, 0.3);
    walk.damp = between(0.6, 0.95);
    walk.leg = between(20, 80);
    walk.drop = between(-20, 90);
    walk.speed = between(-0.2, 0.2);
    walk.grav = between(0.1, 1.0);
    walk.ground = between(300, 420);
    walk.bounce = random() % 2 ? between(0, 1) : 0.0;
    walk.ice = random() % 4 == 0;
    walk.body = startAndDrags.body;
    if (kind < WalkingTutorial::Kind::bodyPulled)
        walk.body.vx = walk.body.vy = 0.0; // a handle
    for (int i = 0; i < feet; ++i) {
        WalkingTutorial::Foot foot;
        static_cast<Clip &>(foot) = startAndDrags.feet[static_cast<std::size_t>(i)];
        foot.angle = 2.0 * std::numbers::pi * i / feet;
        walk.feet.push_back(foot);
    }
    walk.input = startAndDrags.input;
    return walk;
}

namespace {

sim::Script scriptFor(const lessons::Step &step, const WalkingTutorial &walk)
{
    sim::Script script = step.script();
    const std::map<std::string, double> numbers = {
        {"k", walk.k},
        {"damp", walk.damp},
        {"leg", walk.leg},
        {"drop", walk.drop},
        {"speed", walk.speed},
        {"gravity", walk.grav},
        {"ground", walk.ground},
        {"bounce", walk.bounce},
        {"traction", walk.ice ? 1.0 : 0.0},
        {"feet", double(walk.feet.size())},
    };
    for (const auto &[id, value] : numbers) {
        if (script.values.has(id))
            script.values.set(id, value);
    }
    const auto start = [](const Clip &clip) {
        return sim::BodyStart{{clip.x, clip.y}, sim::Vec2{clip.vx, clip.vy}};
    };
    for (std::size_t i = 0; i < walk.feet.size(); ++i)
        script.bodies["foot" + std::to_string(i)] = start(walk.feet[i]);
    script.bodies["body"] = start(walk.body);
    script.input = walk.input;
    return script;
}

}

double largestDifference(const lessons::Step &step, const WalkingTutorial &tutorial, int frames)
{
    sim::Track track(scriptFor(step, tutorial), 0);
    WalkingTutorial other = tutorial;
    double largest = 0.0;
    for (int frame = 0; frame <= frames; ++frame) {
        if (frame > 0)
            other.enterFrame();
        track.seek({frame, 0});
        const std::vector<Clip> clips = other.clips();
        if (track.cursor().frame != frame || track.state().pointCount() != static_cast<int>(clips.size()))
            return INFINITY;
        for (int i = 0; i < track.state().pointCount(); ++i) {
            const Clip &clip = clips[static_cast<std::size_t>(i)];
            const sim::Vec2 x = track.state().positionOf(i), v = track.state().velocityOf(i);
            largest = std::max({largest, std::abs(x.x - clip.x), std::abs(x.y - clip.y),
                                std::abs(v.x - clip.vx), std::abs(v.y - clip.vy)});
        }
    }
    return largest;
}

}
