#pragma once

#include "sim/forward.h"

#include <QString>

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace lessons {

/// A condition of a thing to try: what has to be true of the run at its cursor, and what is to do while it is not.
struct Condition
{
    std::function<bool(const sim::Timeline &)> holds;
    /// What is still to do, for example "let go of the foot at 5 px per frame or more. Yours left at %1.": Markdown, without
    /// a capital at its start. `%1` stands for `measured`. Empty where the text of the thing to try says all.
    QString todo = {};
    std::function<double(const sim::Timeline &)> measured = {}; ///< in the unit that `todo` names
    int decimals = 1;                                           ///< of that number
};

/// The conditions of a thing to try, all of which must hold at one moment. The first is what a learner begins with: once it
/// holds, the thing is begun, and the first of the others that does not hold says what is missing.
class Conditions
{
public:
    Conditions() = default;
    Conditions(std::initializer_list<Condition> all) : m_all(all) {}
    /// One condition, which the text of the thing to try says in full.
    template <class Holds,
              class = std::enable_if_t<std::is_invocable_r_v<bool, Holds, const sim::Timeline &>>>
    Conditions(Holds holds) : m_all{{std::move(holds)}}
    {
    }

    const std::vector<Condition> &all() const { return m_all; }
    bool hold(const sim::Timeline &run) const;
    /// Returns whether a learner has begun: the first condition holds.
    bool hasBegun(const sim::Timeline &run) const;
    /// Returns what is still to do; empty when all is done, and before a learner has begun.
    QString todo(const sim::Timeline &run) const;

private:
    std::vector<Condition> m_all;
};

// Conditions that many things to try share

/// The hand has let go of `body`, or of anything if that is empty, and has taken nothing since.
Condition released(const std::string &body = {});
/// The same, and it let go after the parameter `id` was set: what was done with another value does not count.
Condition releasedSinceSet(const std::string &id, const std::string &body = {});
/// It let go while it moved at least `leastSpeed` px/frame.
Condition thrownAtLeast(double leastSpeed = 5.0);
/// What the hand took last is `body`, whether it still holds it or not.
Condition lastGrabbed(const std::string &body);
/// The hand holds `body`.
Condition holding(const std::string &body);
/// The hand carried what it took last at least `least` px away.
Condition draggedAtLeast(double least);
/// Nothing moves.
Condition allStill();
/// The hand has been off for `frames` frames.
Condition idleFor(std::int64_t frames);
/// The parameter `id` has its value for `frames` frames.
Condition unchangedFor(const std::string &id, std::int64_t frames);
/// The run has come to `frame`.
Condition playedTo(std::int64_t frame);
/// The parameter `id` is `value`; `todo` says to set it.
Condition parameterSetTo(const std::string &id, double value, const QString &todo = {});
/// The run goes on with the method called `id`; `todo` says to choose it.
Condition runsMethod(const std::string &id, const QString &todo = {});
/// The cursor stands inside a frame.
Condition insideAFrame();
/// In the frame where the cursor stands, a spring has pulled and nothing has moved.
Condition onlyPulled();
/// The run differs from its ghost in the parameter `id`.
Condition ghostDiffers(const std::string &id);
/// The run has gone on for ten frames since it left its ghost.
Condition playedBesideGhost();

/// A condition that `measured` is `least` or more; `todo` may show it as `%1`.
Condition atLeast(double least, std::function<double(const sim::Timeline &)> measured, const QString &todo,
                  int decimals = 1);
/// A condition that `measured` is `most` or less.
Condition atMost(double most, std::function<double(const sim::Timeline &)> measured, const QString &todo,
                 int decimals = 1);

}
