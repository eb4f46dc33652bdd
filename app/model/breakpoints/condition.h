#pragma once

#include "sim/run/script/composed_intervals.h"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <map>
#include <vector>

namespace app {

/// The names that a condition may use: bodies of a scene, current parameters, and phases of a pipeline.
struct ConditionNames
{
    const sim::Scene &scene;
    const sim::Values &values;
    const sim::Pipeline &pipeline;
    /// The ids of choices, by the id of their parameter.
    std::map<QString, QStringList> choices = {};
};

/// A moment at which a condition is evaluated.
struct ConditionMoment
{
    const sim::State &state;
    std::int64_t frame = 0;           ///< completed frames
    const sim::Phase *next = nullptr; ///< the phase that runs next
};

/// A condition on a moment of a run, as the learner writes it: `foot0.y > 380 and phase == "springs"`. Numbers are x,
/// y, vx and vy of bodies, angle and spin where points turn, `frame`, parameters by id, abs() and sqrt(). Operators are
/// + - * /, parentheses, the comparisons < <= > >= == !=, and, or, not. `phase` is compared with the name of the phase
/// that runs next. A choice is compared with the id of one of its values.
class Condition
{
public:
    static constexpr qsizetype longest = 400; ///< characters

    /// Parses `text` and looks up its names. The condition is therefore valid only for states of names.scene.
    /// @throws UserError one sentence with the place (counted in characters from 1) and the remedy
    static Condition parse(const QString &text, const ConditionNames &names);

    /// Returns whether the condition holds. A comparison with NaN (0 / 0) is false, except "!=".
    bool holds(const ConditionMoment &moment) const;
    /// Returns whether the condition depends on the frame number.
    bool readsFrame() const;

    /// One operation on a stack of numbers. Truth values are 1 or 0.
    struct Operation
    {
        enum class Kind {
            number,
            frame,
            x,
            y,
            vx,
            vy,
            angle,
            spin,
            phaseIs,
            minus,
            absolute,
            root,
            add,
            subtract,
            multiply,
            divide,
            less,
            lessOrEqual,
            greater,
            greaterOrEqual,
            equal,
            notEqual,
            both,
            either,
            negate,
        };
        Kind kind = Kind::number;
        double number = 0.0;                  ///< for `number`
        int point = -1;                       ///< for x to spin
        std::vector<std::string> phases = {}; ///< ids, for `phaseIs`
    };

private:
    std::vector<Operation> m_program; ///< in postfix order: operands first
};

}
