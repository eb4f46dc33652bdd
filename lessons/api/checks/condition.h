#pragma once

#include "sim/forward.h"

#include <QMap>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace lessons {

/// A condition of a thing to try: a test of the run at its cursor, and what the learner has to do until it
/// holds.
struct Condition
{
    std::function<bool(const sim::Timeline &)> holds;
    /// The name of the sentence in the step's document that becomes `todo`. Empty if `todo` is given here, and if
    /// the text of the thing to try says everything.
    QString sentence = {};
    std::function<double(const sim::Timeline &)> measured = {}; ///< number for `%1`
    int decimals = 1;                                           ///< of the measured number
    /// Markdown without a capital at its start: what is still to do. For example "let go of the foot at 5 px
    /// per frame or more. You let go at %1." `%1` stands for `measured`. Empty if the text of the thing to
    /// try says everything.
    QString todo = {};
    bool insideFrame = false; ///< whether it can hold between two phases of a frame only
    bool otherSteps = false;  ///< whether it can hold with steps other than one frame only

    /// Returns the measured number as learners read it.
    QString number(const sim::Timeline &run) const;
};

/// The conditions of a thing to try, all of which must hold at the same time. The first one holds as soon as
/// a learner has begun. From then on, the first condition that does not hold says what is missing.
class Conditions
{
public:
    Conditions() = default;
    Conditions(std::initializer_list<Condition> all) : m_all(all) {}
    explicit Conditions(std::vector<Condition> all) : m_all(std::move(all)) {}
    /// A single condition, without a `todo` because the text of the thing to try says everything.
    template <class Holds,
              class = std::enable_if_t<std::is_invocable_r_v<bool, Holds, const sim::Timeline &>>>
    Conditions(Holds holds) : m_all{{std::move(holds)}}
    {
    }

    const std::vector<Condition> &all() const { return m_all; }
    /// Returns the names of the sentences that the conditions have in the document of their step.
    QStringList sentences() const;
    /// Returns the same conditions with sentences from a document, by name. Those that it lacks stay empty.
    Conditions with(const QMap<QString, QString> &sentences) const;
    /// Returns whether all conditions hold at the cursor of `run`.
    bool hold(const sim::Timeline &run) const;
    /// Returns whether a learner has begun, that is, whether the first condition holds.
    bool hasBegun(const sim::Timeline &run) const;
    /// Returns the first condition that does not hold, once a learner has begun. Null before, and when everything is
    /// done.
    const Condition *missing(const sim::Timeline &run) const;
    /// Returns whether a condition that does not hold can hold inside a frame only. A method with a single phase cannot
    /// stop there.
    bool waitsForPhase(const sim::Timeline &run) const;
    /// Returns whether a condition that does not hold needs another step than one frame. A listing has no other.
    bool waitsForStep(const sim::Timeline &run) const;
    /// Returns what is still to do. Empty before a learner has begun and when everything is done.
    QString todo(const sim::Timeline &run) const;

private:
    std::vector<Condition> m_all;
};

// Conditions that many things to try share. `sentence` is the name of a sentence in the step's document; the others have
// a sentence of their own.

/// The learner's last drag is finished, and it moved `body` (any body if empty).
Condition released(const std::string &body = {});
/// The learner's last drag is finished, moved `body` (any if empty), and ended after the parameter `id` was
/// set last.
Condition releasedSinceSet(const std::string &id, const std::string &body = {});
/// The last drag is finished and released its body at `minSpeed` px/frame or more.
Condition thrownAtLeast(double minSpeed = 5.0);
/// The last drag moves or moved `body`.
Condition lastGrabbed(const std::string &body);
/// The learner is dragging `body`.
Condition holding(const std::string &body);
/// The last drag went `minDistance` px or more from where its body was.
Condition draggedAtLeast(double minDistance);
/// Nothing moves (isStill()).
Condition allStill();
/// There has been no drag and no other input, except to parameters, for `frames` frames.
Condition idleFor(std::int64_t frames);
/// The parameter `id` has not been set for `frames` frames.
Condition unchangedFor(const std::string &id, std::int64_t frames);
/// The cursor is between two frames, at `frame` or later.
Condition playedTo(std::int64_t frame);
/// The parameter `id` is `value`. The sentence tells the learner to set it.
Condition parameterSetTo(const std::string &id, double value, const QString &sentence = {});
/// The run uses the method `id`. The sentence tells the learner to choose it.
Condition runsMethod(const std::string &id, const QString &sentence = {});
/// The method makes fixed steps of `h` frames.
Condition stepIs(double h, const QString &sentence = {});
/// The cursor is inside a frame.
Condition insideFrame();
/// The cursor is inside a step in which a spring has pulled and nothing has moved yet.
Condition onlyPulled();
/// The parameter `id` differs between the run and its comparison run.
Condition comparisonDiffers(const std::string &id);
/// The cursor is ten frames or more after the frame at which the run departs from its comparison run.
Condition playedSinceFork();

/// `measured` is `min` or more. The sentence may show it as `%1`.
Condition atLeast(double min, std::function<double(const sim::Timeline &)> measured,
                  const QString &sentence = {}, int decimals = 1);
/// `measured` is `max` or less. The sentence may show it as `%1`.
Condition atMost(double max, std::function<double(const sim::Timeline &)> measured,
                 const QString &sentence = {}, int decimals = 1);

}
