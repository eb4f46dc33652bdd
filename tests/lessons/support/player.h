#pragma once

#include "lessons/api/step.h"
#include "sim/run/timeline.h"

#include <cstdint>
#include <string>

namespace support {

/// Performs the actions of a learner who follows one "thing to try". Attempts are written once against this
/// interface. RunPlayer performs them on a run. In tests/app/by_hand, a player performs them in the window
/// with mouse and keys.
class Player
{
public:
    virtual ~Player() = default;

    virtual void play(int frames) = 0;
    virtual void grab(const std::string &body) = 0;
    /// Moves the pointer that drags the grabbed body.
    virtual void movePointer(sim::Vec2 to) = 0;
    virtual void release() = 0;
    /// Sets the pointer and its button, for scenes that feel the pointer.
    virtual void point(sim::Vec2 at, bool down) = 0;
    /// Clicks the background, for scenes with a target.
    virtual void target(sim::Vec2 at) = 0;
    virtual void key(bool sim::Keys::*key, bool down) = 0;
    /// Sets a parameter. One that opens another experiment restarts the run, as in the app.
    virtual void set(const std::string &parameter, double value) = 0;
    virtual void useMethod(const std::string &id) = 0;
    virtual void useStep(double h) = 0; ///< frames
    /// Sets the error tolerance of an adaptive method, in px per step.
    virtual void useTolerance(double tolerance) = 0;
    /// Sets the time measurement for things to try with a budget. Without one, no run keeps a budget.
    virtual void useTiming(lessons::TimeMeasurement timing) = 0;
    virtual void goTo(std::int64_t frame) = 0;
    virtual void stepPhases(int count) = 0;

    virtual bool done() const = 0;
    virtual const sim::Timeline &run() const = 0;

    /// Plays until the thing to try is done, for at most `frames` frames.
    void playUntilDone(int frames);
    /// Drags the grabbed body to `to` in equal steps, one per frame.
    void dragTo(sim::Vec2 to, int frames);
    /// Grabs `body`, drags it to `to` and releases it. With few frames, that is a throw.
    void drag(const std::string &body, sim::Vec2 to, int frames);
    void reset() { goTo(0); }
    /// Returns the position of `body`.
    sim::Vec2 at(const std::string &body) const;

protected:
    std::string m_held; ///< name of the body that was grabbed last
};

/// Performs attempts on a run without a window. Checks the thing to try after each frame and each change, as
/// the app does.
class RunPlayer : public Player
{
public:
    /// `number` is the index of the thing to try in `step`.
    RunPlayer(const lessons::Step &step, std::size_t number);

    void play(int frames) override;
    void grab(const std::string &body) override;
    void movePointer(sim::Vec2 to) override;
    void release() override;
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
    /// Returns the hint about what is still to do. Empty before the attempt has begun.
    QString todo() const { return m_try.conditions.todo(m_run); }
    /// Returns the name of the document's sentence about what is still to do, with the number that it shows:
    /// "long 33". Where conditions of all lessons have the sentence, returns todo().
    QString missing() const;
    /// Returns whether there was a moment, between begin and success, without a hint.
    bool lackedHint() const { return m_lackedHint; }
    const sim::Timeline &run() const override { return m_run; }

private:
    void checkTry();
    void use(sim::Script script);

    lessons::Step m_step;
    sim::Timeline m_run;
    lessons::Try m_try;
    lessons::TimeMeasurement m_timing;
    bool m_done = false;
    bool m_lackedHint = false;
};

}
