#pragma once

#include "sim/run/script/composed_intervals.h"

#include <QString>
#include <QStringList>

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace app {

/// The names that a condition may use: bodies of a scene, current parameters, phases of a pipeline, and variables of the
/// listing that computes the run.
struct ConditionNames
{
    const sim::Scene &scene;
    const sim::Values &values;
    const sim::Pipeline &pipeline;
    /// The ids of choices, by the id of their parameter.
    std::map<QString, QStringList> choices = {};
    /// The types of the listing's variables ("double", "Vec2", "Body"...), by name.
    std::map<QString, QString> variables = {};
};

/// A moment at which a condition is evaluated.
struct ConditionMoment
{
    const sim::State &state;
    std::int64_t frame = 0;           ///< completed frames
    const sim::Phase *next = nullptr; ///< the phase that runs next
    /// Returns a number of the listing by its path ("angle", "from.x"); empty where it has no value. Null between lines.
    std::function<std::optional<double>(const std::string &path)> variable = {};
    /// The run whose cursor is at this moment, for still() and released(). Null where only the state is known.
    const sim::Track *run = nullptr;
};

/// A condition on a moment of a run, as the learner writes it: `foot0.y > 380 and phase == "springs"`. Numbers are x,
/// y, vx and vy of bodies, angle and spin where points turn, `frame`, parameters by id, abs(), sqrt(), distance(a, b) of
/// two bodies (px) and speed(a) of a body (px/frame). still(a) is true if the body does not move in this frame and the next,
/// held(a) while a hand holds it, and released(a) from when a hand has let go of it until one takes a body again; without a
/// name, they are about all bodies, or any. Operators are + - * /, parentheses, the comparisons < <= > >= == !=, and, or,
/// not. `phase` is compared with the name of the phase that runs next. A choice is compared with the id of one of its values.
class Condition
{
public:
    static constexpr qsizetype longest = 400; ///< characters

    /// Parses `text` and looks up its names. The condition is therefore valid only for states of names.scene.
    /// @throws UserError one sentence with the place (counted in characters from 1) and the remedy
    static Condition parse(const QString &text, const ConditionNames &names);

    /// Returns whether the condition holds. A comparison with NaN (0 / 0) is false, except "!=". Where a variable of the
    /// listing has no value, the condition does not hold.
    bool holds(const ConditionMoment &moment) const;
    /// Returns whether the condition depends on the frame number.
    bool readsFrame() const;
    /// Returns whether the condition depends on variables of the listing, so that it can hold between two lines only.
    bool readsVariables() const;

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
            distance,
            speed,
            phaseIs,
            still,
            held,
            released,
            variable,
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
        int point = -1;                       ///< for x to speed; for still to released, -1: all, or any
        std::vector<std::string> phases = {}; ///< ids, for `phaseIs`
        std::string path = {};                ///< for `variable`; of the body, for `released`
        int other = -1;                       ///< the second point, for `distance`
    };

private:
    std::vector<Operation> m_program; ///< in postfix order: operands first
};

/// Returns the text of a condition with `to` where it names the body `from`. A text that is no condition stays as it is.
QString withBodyRenamed(const QString &condition, const QString &from, const QString &to);

/// A number of a moment of a run in the language of conditions: `distance(foot, body)`.
class MomentNumber
{
public:
    /// Parses `text` as Condition::parse() does.
    /// @throws UserError as there, also if `text` is a condition
    static MomentNumber parse(const QString &text, const ConditionNames &names);

    /// Returns the number at `moment`; NaN where a variable of the listing has no value.
    double at(const ConditionMoment &moment) const;

private:
    std::vector<Condition::Operation> m_program; ///< in postfix order
};

}
