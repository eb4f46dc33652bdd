#pragma once

#include "sim/run/script/composed_intervals.h"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <map>
#include <vector>

namespace app {

/// What a condition may speak of: the bodies of a scene, the parameters in force, and the phases of a pipeline.
struct ConditionNames
{
    const sim::Scene &scene;
    const sim::Values &values;
    const sim::Pipeline &pipeline;
    /// The ids of choices, by the id of the parameter that has them.
    std::map<QString, QStringList> choices = {};
};

/// A moment that a condition is asked about.
struct ConditionMoment
{
    const sim::State &state;
    std::int64_t frame = 0;           ///< frames that are done
    const sim::Phase *next = nullptr; ///< the phase that runs next
};

/// A question about a moment of a run, as a learner writes it: `foot0.y > 380 and phase == "springs"`. It knows numbers
/// (x, y, vx, vy of bodies, angle and spin where points turn, `frame`, parameters by id, abs() and sqrt()), + - * / and
/// parentheses, the comparisons < <= > >= == !=, and, or, not. `phase` is compared with the name of the phase that runs
/// next, and a choice with the id of one of its values.
class Condition
{
public:
    static constexpr qsizetype longest = 400; ///< characters

    /// Names are looked up here, so it holds for states of names.scene only.
    /// @throws Refusal one sentence with the place (counted in characters from 1) and the remedy
    static Condition parse(const QString &text, const ConditionNames &names);

    /// Whether it holds: never where a number that it compares is none (0 / 0), but for "!=".
    bool holds(const ConditionMoment &moment) const;
    /// Whether it looks at the number of the frame.
    bool readsFrame() const;

    /// One step of the computation, on a stack of numbers; a truth is 1 or 0.
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
    std::vector<Operation> m_program; ///< operands first
};

}
