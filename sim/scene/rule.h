#pragma once

#include "sim/base/vec2.h"
#include "sim/forward.h"

#include <Eigen/Core>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace sim {

/// One evaluation of a rule: force(me), or pull(me, other).
struct RuleCall
{
    int me = 0;
    int other = -1; ///< -1: the call is force(me)
    int moved = -1; ///< the point that is moved during this call, for differences; -1: none
    Vec2 by = {};   ///< px, how far it is moved
};

/// The parts of a state that a rule reads besides its bodies `me` and `other`.
struct RuleUse
{
    bool bodies = false;   ///< `bodies`: the other bodies of the scene
    bool pointer = false;  ///< the pointer or the hand
    bool target = false;   ///< targets that the learner sets by a click
    bool keys = false;     ///< the arrow keys
    bool held = false;     ///< whether a body is held
    bool frame = false;    ///< the frame number, also for random numbers
    bool time = false;     ///< `time`, which is continuous
    bool velocity = false; ///< the velocity of a body
    bool input() const { return pointer || target || keys || held; }
};

/// The constants of a scene that a rule reads.
struct RuleScene
{
    Eigen::ArrayXd mass;            ///< per point; 0 if it is fixed
    Eigen::ArrayXd radius;          ///< px, per point
    std::vector<double> parameters; ///< values of Rule::parameters()
    int clock = -1;                 ///< the gait clock that is `time`; -1 if the rule does not use it
    std::uint64_t seed = 1;
};

/// A force that a learner writes in the sandbox. The program that runs it is outside this library. A rule keeps no state,
/// and several threads may evaluate it at the same time.
class Rule
{
public:
    virtual ~Rule() = default;
    virtual const std::string &text() const = 0;
    /// Returns whether it has a function `force`, which acts on every dynamic body.
    virtual bool hasForce() const = 0;
    /// Returns whether it has a function `pull`, which acts along the rule links of a scene.
    virtual bool hasPull() const = 0;
    virtual RuleUse use() const = 0;
    /// Returns the ids of the parameters that it reads.
    virtual std::vector<std::string> parameters() const = 0;
    /// Computes the force (mass px/frame^2) of each of `calls` at `state`. It is NaN if the rule fails there.
    virtual void evaluate(const RuleScene &scene, const State &state, std::span<const RuleCall> calls,
                          std::span<Vec2> forces) const = 0;
};

/// The rule of a blueprint, if it has one. Two rules with the same text are equal.
struct BlueprintRule
{
    std::shared_ptr<const Rule> program; ///< null: no rule

    /// Returns the text of the rule; empty without one.
    std::string text() const { return program ? program->text() : std::string(); }
    explicit operator bool() const { return program != nullptr; }
    friend bool operator==(const BlueprintRule &a, const BlueprintRule &b)
    {
        return a.program == b.program || (a.program && b.program && a.program->text() == b.program->text());
    }
};

}
