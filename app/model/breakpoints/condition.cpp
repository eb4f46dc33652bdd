#include "app/model/breakpoints/condition.h"

#include "app/model/breakpoints/condition_names.h"
#include "app/model/breakpoints/condition_parser.h"
#include "app/model/breakpoints/condition_tokens.h"
#include "app/model/catalog/lists.h"
#include "app/model/text/user_error.h"
#include "lessons/api/checks/input_queries.h"
#include "lessons/api/checks/run_queries.h"
#include "sim/pipeline/method.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

namespace {

using Kind = Condition::Operation::Kind;

/// Returns whether a point (all if -1) is still. Where only the state is known, a body at its turning point is still, too.
bool isStill(int point, const ConditionMoment &moment)
{
    if (moment.run)
        return lessons::staysStill(*moment.run, point);
    const Eigen::ArrayX2d &velocity = moment.state.velocity;
    const Eigen::Index first = std::max(point, 0), count = point < 0 ? velocity.rows() : 1;
    return (velocity.middleRows(first, count).abs() <= lessons::stillness).all();
}

/// Returns whether the word at `i` is the name of a body for distance(), speed(), still(), held() or released(). Elsewhere, a
/// body has a member, as in "foot.y".
bool isArgument(const std::vector<ConditionToken> &words, std::size_t i)
{
    if (i == 0 || words[i - 1].kind != ConditionToken::Kind::sign)
        return false;
    return words[i - 1].text == u"," || (i > 1 && words[i - 1].text == u"(" &&
                                         condition_names::bodyFunctions().contains(words[i - 2].text));
}

/// Returns the number that an operation without operands reads.
double read(const Condition::Operation &operation, const ConditionMoment &moment)
{
    const sim::State &state = moment.state;
    switch (operation.kind) {
    case Kind::frame:
        return static_cast<double>(moment.frame);
    case Kind::x:
        return state.position(operation.point, 0);
    case Kind::y:
        return state.position(operation.point, 1);
    case Kind::vx:
        return state.velocity(operation.point, 0);
    case Kind::vy:
        return state.velocity(operation.point, 1);
    case Kind::angle:
        return state.angle[operation.point];
    case Kind::spin:
        return state.spin[operation.point];
    case Kind::distance:
        return sim::length(state.positionOf(operation.point) - state.positionOf(operation.other));
    case Kind::speed:
        return sim::length(state.velocityOf(operation.point));
    case Kind::still:
        return isStill(operation.point, moment);
    case Kind::held:
        return operation.point < 0 ? state.hold.point >= 0 : state.hold.point == operation.point;
    case Kind::released:
        return moment.run && lessons::isReleased(*moment.run, operation.path);
    case Kind::phaseIs:
        return moment.next && contains(operation.phases, moment.next->id + '/' + moment.next->title);
    default:
        return operation.number;
    }
}

double single(Kind kind, double value)
{
    switch (kind) {
    case Kind::minus:
        return -value;
    case Kind::absolute:
        return std::abs(value);
    case Kind::root:
        return std::sqrt(value);
    default:
        return value == 0.0; // negate
    }
}

double ofTwo(Kind kind, double a, double b)
{
    switch (kind) {
    case Kind::add:
        return a + b;
    case Kind::subtract:
        return a - b;
    case Kind::multiply:
        return a * b;
    case Kind::divide:
        return a / b;
    case Kind::less:
        return a < b;
    case Kind::lessOrEqual:
        return a <= b;
    case Kind::greater:
        return a > b;
    case Kind::greaterOrEqual:
        return a >= b;
    case Kind::equal:
        return a == b;
    case Kind::notEqual:
        return a != b;
    case Kind::both:
        return a != 0.0 && b != 0.0;
    default:
        return a != 0.0 || b != 0.0; // either
    }
}

/// Returns the result of a program; empty where a variable of the listing has no value.
std::optional<double> evaluated(const std::vector<Condition::Operation> &program,
                                const ConditionMoment &moment)
{
    std::vector<double> stack;
    stack.reserve(program.size());
    for (const Condition::Operation &operation : program) {
        if (operation.kind >= Kind::add && operation.kind <= Kind::either) {
            const double right = stack.back();
            stack.pop_back();
            stack.back() = ofTwo(operation.kind, stack.back(), right);
        } else if (operation.kind == Kind::minus || operation.kind == Kind::absolute ||
                   operation.kind == Kind::root || operation.kind == Kind::negate) {
            stack.back() = single(operation.kind, stack.back());
        } else if (operation.kind == Kind::variable) {
            const std::optional<double> value =
                moment.variable ? moment.variable(operation.path) : std::nullopt;
            if (!value)
                return std::nullopt;
            stack.push_back(*value);
        } else {
            stack.push_back(read(operation, moment));
        }
    }
    return stack.back();
}

}

Condition Condition::parse(const QString &text, const ConditionNames &names)
{
    Condition condition;
    condition.m_program = ConditionParser(text, names).parse();
    return condition;
}

bool Condition::holds(const ConditionMoment &moment) const
{
    const std::optional<double> truth = evaluated(m_program, moment);
    return truth && *truth != 0.0;
}

bool Condition::readsFrame() const
{
    return std::any_of(m_program.begin(), m_program.end(),
                       [](const Operation &one) { return one.kind == Kind::frame; });
}

bool Condition::readsVariables() const
{
    return std::any_of(m_program.begin(), m_program.end(),
                       [](const Operation &one) { return one.kind == Kind::variable; });
}

QString withBodyRenamed(const QString &condition, const QString &from, const QString &to)
{
    std::vector<ConditionToken> words;
    try {
        words = conditionWords(condition);
    } catch (const UserError &) {
        return condition;
    }
    QString renamed;
    qsizetype copied = 0; // characters of `condition`
    for (std::size_t i = 0; i < words.size(); ++i) {
        const QString &word = words[i].text;
        const bool isBody = isArgument(words, i) ? word == from : word.section('.', 0, -2) == from;
        if (words[i].kind != ConditionToken::Kind::name || !isBody)
            continue;
        const qsizetype begin = words[i].place - 1;
        renamed += condition.mid(copied, begin - copied) + to;
        copied = begin + from.size();
    }
    return renamed + condition.mid(copied);
}

MomentNumber MomentNumber::parse(const QString &text, const ConditionNames &names)
{
    MomentNumber number;
    number.m_program = ConditionParser(text, names).parseNumber();
    return number;
}

double MomentNumber::at(const ConditionMoment &moment) const
{
    return evaluated(m_program, moment).value_or(std::numeric_limits<double>::quiet_NaN());
}

}
