#pragma once

#include "lessons/api/step.h"

#include <cstdint>
#include <string>

namespace support {

/// A learner at a step: does what a hand can do in the app and looks at one "thing to try" after each frame and
/// each change, as the app does.
class Player
{
public:
    /// `wanted`: the number of the try to look at.
    Player(const lessons::Step &step, std::size_t wanted);

    void play(int frames);
    /// Plays until the try is done, for at most `frames` frames.
    void playUntilDone(int frames);
    void grab(const std::string &body);
    /// Moves the hand to `to` in equal parts, one a frame, from where the held body is.
    void carryTo(sim::Vec2 to, int frames);
    void letGo();
    /// Grabs, carries and lets go: a throw, if `frames` is small.
    void drag(const std::string &body, sim::Vec2 to, int frames);
    /// The pointer at a place, its button down or up; and the other things that reach a scene.
    void point(sim::Vec2 at, bool down);
    void target(sim::Vec2 at);
    void key(bool sim::Keys::*key, bool down);
    /// A parameter that opens another experiment begins the run anew, as in the app.
    void set(const std::string &parameter, double value);
    void useMethod(const std::string &id);
    void useStep(double h);
    /// For a method that chooses its steps: px a step.
    void useTolerance(double tolerance);
    /// How the time is told that a run takes, for tries with a budget; before, no time keeps one.
    void useTiming(lessons::Timing timing);
    void goTo(std::int64_t frame);
    void reset() { goTo(0); }
    void stepPhases(int count);

    bool done() const { return m_done; }
    const sim::Timeline &run() const { return m_run; }
    sim::Vec2 at(const std::string &body) const;

private:
    void look();
    void use(sim::Script script);

    lessons::Step m_step;
    sim::Timeline m_run;
    lessons::Try m_try;
    lessons::Timing m_timing;
    std::string m_held;
    bool m_done = false;
};

}
