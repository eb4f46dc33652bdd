#pragma once

#include "lessons/api/step.h"
#include "sim/run/timeline.h"

#include <cstdint>
#include <string>

namespace support {

/// A learner at a step, who follows one "thing to try": does what a hand can do in the app. What an attempt does is
/// told once, and done in two ways: by code on a run alone (RunPlayer), and with mouse and keys in the window.
class Player
{
public:
    virtual ~Player() = default;

    virtual void play(int frames) = 0;
    virtual void grab(const std::string &body) = 0;
    /// Moves the hand that holds a body.
    virtual void moveHand(sim::Vec2 to) = 0;
    virtual void letGo() = 0;
    /// The pointer at a place, its button down or up; and the other things that reach a scene.
    virtual void point(sim::Vec2 at, bool down) = 0;
    virtual void target(sim::Vec2 at) = 0;
    virtual void key(bool sim::Keys::*key, bool down) = 0;
    /// A parameter that opens another experiment begins the run anew, as in the app.
    virtual void set(const std::string &parameter, double value) = 0;
    virtual void useMethod(const std::string &id) = 0;
    virtual void useStep(double h) = 0;
    /// For a method that chooses its steps: px a step.
    virtual void useTolerance(double tolerance) = 0;
    /// How the time is told that a run takes, for tries with a budget; before, no time keeps one.
    virtual void useTiming(lessons::TimeMeasurement timing) = 0;
    virtual void goTo(std::int64_t frame) = 0;
    virtual void stepPhases(int count) = 0;

    virtual bool done() const = 0;
    virtual const sim::Timeline &run() const = 0;

    /// Plays until the try is done, for at most `frames` frames.
    void playUntilDone(int frames);
    /// Moves the hand to `to` in equal parts, one a frame, from where the held body is.
    void carryTo(sim::Vec2 to, int frames);
    /// Grabs, carries and lets go: a throw, if `frames` is small.
    void drag(const std::string &body, sim::Vec2 to, int frames);
    void reset() { goTo(0); }
    sim::Vec2 at(const std::string &body) const;

protected:
    std::string m_held; ///< the body that was grabbed last
};

/// Does it on a run alone, and looks at the try after each frame and each change, as the app does.
class RunPlayer : public Player
{
public:
    /// `wanted`: the number of the try to look at.
    RunPlayer(const lessons::Step &step, std::size_t wanted);

    void play(int frames) override;
    void grab(const std::string &body) override;
    void moveHand(sim::Vec2 to) override;
    void letGo() override;
    void point(sim::Vec2 at, bool down) override;
    void target(sim::Vec2 at) override;
    void key(bool sim::Keys::*key, bool down) override;
    void set(const std::string &parameter, double value) override;
    void useMethod(const std::string &id) override;
    void useStep(double h) override;
    void useTolerance(double tolerance) override;
    void useTiming(lessons::TimeMeasurement timing) override;
    void goTo(std::int64_t frame) override;
    void stepPhases(int count) override;

    bool done() const override { return m_done; }
    /// What is still to do; empty where nobody has begun.
    QString todo() const { return m_try.conditions.todo(m_run); }
    /// Whether the try was begun and not done at some moment when nothing said what was missing.
    bool wasSilent() const { return m_wasSilent; }
    const sim::Timeline &run() const override { return m_run; }

private:
    void look();
    void use(sim::Script script);

    lessons::Step m_step;
    sim::Timeline m_run;
    lessons::Try m_try;
    lessons::TimeMeasurement m_timing;
    bool m_done = false;
    bool m_wasSilent = false;
};

}
