#pragma once

#include "sim/base/vec2.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace sim {
struct State;
}

namespace listing {

/// A body, a creature or a stick that a variable stands for.
struct BodyReference
{
    enum class Kind { body, creature, stick };
    /// As in the listing: "body", "feet[2]", "creatures[0]", "sticks[1]". Empty if the variable stands for none.
    std::string name;
    int point = -1; ///< index in the state, of a creature that of its body; -1: none, or a stick
    Kind kind = Kind::body;
    friend bool operator==(const BodyReference &, const BodyReference &) = default;
};

/// The value of a variable: double, int, bool, Vec2 (px or px/frame), a body, a creature or a stick.
using Value = std::variant<double, std::int64_t, bool, sim::Vec2, BodyReference>;

/// Returns the name of the type of `value` in a listing: "double", "int", "bool", "Vec2", "Body", "Creature" or
/// "Stick".
std::string typeName(const Value &value);

/// Returns whether both coordinates are finite.
bool isFinite(sim::Vec2 vector);
/// Returns whether a number or a vector is finite. Values of other types always are.
bool isFinite(const Value &value);

/// A variable of a listing at some moment.
struct Variable
{
    std::string name;
    Value value;
    bool isGlobal = false; ///< whether it keeps its value from frame to frame
    friend bool operator==(const Variable &, const Variable &) = default;
};

/// A mistake in the text of a listing.
struct CompileError
{
    int line = 1;   ///< from 1
    int column = 1; ///< from 1, in bytes of UTF-8
    int length = 1; ///< bytes, of the word that is wrong
    std::string sentence;
};

/// Sorts mistakes by their places in the text.
void sortByPlace(std::span<CompileError> errors);

/// The kind of a mistake that stops a frame.
enum class RunErrorKind {
    noSuchBody,     ///< an index outside an array of bodies, or a variable that stands for no body
    divisionByZero, ///< also x / 0.0, which has no finite result
    endlessLoop,    ///< more than maxLinesPerFrame lines
    tooDeep,        ///< calls inside calls, deeper than maxCallDepth
    notFinite,      ///< a position, a velocity or a global variable is infinite or not a number
    other,          ///< any other error of the interpreter
};

/// The mistake that stopped a frame.
struct RunError
{
    RunErrorKind kind = RunErrorKind::other;
    int line = 0; ///< from 1
    std::string sentence;
    std::vector<Variable> variables; ///< in scope on that line, before it finished
};

/// The turn of a loop: "2 of 5".
struct LoopTurn
{
    int line = 0;  ///< of the word `for`, `while` or `do`
    int turn = 0;  ///< from 1
    int turns = 0; ///< of this run of the loop; up to the end of the trace if it does not end
    friend bool operator==(const LoopTurn &, const LoopTurn &) = default;
};

/// The motion of a body: px, px/frame, degrees and degrees/frame.
struct BodyMotion
{
    int point = -1; ///< index in the state
    sim::Vec2 position, velocity;
    double angle = 0.0, spin = 0.0; ///< 0 where bodies do not turn
    friend bool operator==(const BodyMotion &, const BodyMotion &) = default;
};

/// Moves the body in `state`.
void apply(const BodyMotion &motion, sim::State &state);

/// A line that is about to run.
struct TracedLine
{
    int line = 0;  ///< from 1
    int depth = 0; ///< number of calls around it; 0 in the function `frame`
    std::string function;
    std::vector<Variable> variables; ///< in scope, before the line runs; globals last
    std::vector<LoopTurn> loops;     ///< the loops of `function` around it, outermost first
    /// The bodies that change until the next line of the trace, with their motion then.
    std::vector<BodyMotion> changed = {};
};

}
