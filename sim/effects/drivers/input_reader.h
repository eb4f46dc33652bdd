#pragma once

namespace sim {

/// A learner's input that reaches a scene, besides the hand that carries a body.
enum class InputKind {
    pointer, ///< its place and its button
    target,
    keys,
};

/// An effect that reads a learner's input. Where no effect of a scene reads an input, it changes nothing there.
class InputReader
{
public:
    virtual ~InputReader() = default;
    /// Returns whether the effect reads this input.
    virtual bool reads(InputKind signal) const = 0;

protected:
    InputReader() = default;
    InputReader(const InputReader &) = default;
    InputReader &operator=(const InputReader &) = default;
};

}
