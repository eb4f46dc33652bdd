#pragma once

namespace sim {

/// A kind of learner's input that reaches a scene, besides dragging a body.
enum class InputKind {
    pointer, ///< position and button
    target,
    keys,
};

/// An effect that reads a learner's input. Input that no effect of a scene reads changes nothing in it.
class InputReader
{
public:
    virtual ~InputReader() = default;
    /// Returns whether the effect reads input of this kind.
    virtual bool reads(InputKind kind) const = 0;

protected:
    InputReader() = default;
    InputReader(const InputReader &) = default;
    InputReader &operator=(const InputReader &) = default;
};

}
