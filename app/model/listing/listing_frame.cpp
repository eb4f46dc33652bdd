#include "app/model/listing/listing_frame.h"

#include "app/listing/tokens.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <utility>

namespace app {

namespace {

using listing::Value;

/// A part of a path behind its first name.
struct PathPart
{
    std::string member; ///< empty: an index
    std::string index;  ///< the path in the brackets
};

struct Path
{
    std::string root;
    std::vector<PathPart> parts;
};

/// Returns the parts of "feet[i].position"; empty for anything else than names, members and indices.
std::optional<Path> pathOf(const std::string &text)
{
    const listing::Tokens tokens(text);
    if (!tokens.isWord(0))
        return {};
    Path path = {std::string(tokens[0].text), {}};
    for (std::size_t i = 1; i < tokens.size();) {
        if (tokens.is(i, ".") && tokens.isWord(i + 1)) {
            path.parts.push_back({std::string(tokens[i + 1].text), {}});
            i += 2;
        } else if (tokens.is(i, "[") && tokens.closing(i) < tokens.size() && tokens.closing(i) > i + 1) {
            const std::size_t begin = tokens.beginOf(i + 1);
            const std::size_t end = tokens.endOf(tokens.closing(i) - 1);
            path.parts.push_back({{}, text.substr(begin, end - begin)});
            i = tokens.closing(i) + 1;
        } else {
            return {};
        }
    }
    return path;
}

/// Returns the number in the last brackets of "sticks[12]", or -1.
int numberIn(const std::string &name)
{
    const std::size_t open = name.rfind('[');
    return open == std::string::npos ? -1 : std::atoi(name.c_str() + open + 1);
}

const listing::Variable *variableIn(const std::vector<listing::Variable> &variables, const std::string &name)
{
    // Locals come first; of two with one name, the inner one is declared later.
    const listing::Variable *found = nullptr;
    for (const listing::Variable &one : variables) {
        if (one.name == name && !(found && one.isGlobal))
            found = &one;
    }
    return found;
}

std::optional<Value> memberOf(sim::Vec2 vector, const std::string &member)
{
    if (member == "x")
        return Value(vector.x);
    if (member == "y")
        return Value(vector.y);
    if (member == "length")
        return Value(sim::length(vector));
    return {};
}

std::optional<Value> memberOf(const sim::Keys &keys, const std::string &member)
{
    if (member == "left")
        return Value(keys.left);
    if (member == "right")
        return Value(keys.right);
    if (member == "up")
        return Value(keys.up);
    if (member == "down")
        return Value(keys.down);
    return {};
}

}

ListingFrame::ListingFrame(std::shared_ptr<const listing::Program> program, const sim::Scene &scene,
                           const sim::State &start, std::int64_t frame)
    : m_program(std::move(program)), m_binding(listing::bind(m_program->vocabulary(), scene)), m_frame(frame),
      m_start(m_program->runLines(start, m_binding, 0).state), m_trace(m_program->trace(start, m_binding))
{
    // A deeper line is in a new call. So is one on the first line of the same function, before the function has any
    // variables: two calls on one line have nothing between them.
    struct Call
    {
        int number = 0;
        const listing::TracedLine *first = nullptr;
    };
    std::vector<Call> calls; // around the line, outermost first
    int count = 0;
    for (const listing::TracedLine &line : m_trace.lines) {
        const auto depth = static_cast<std::size_t>(line.depth);
        if (calls.size() > depth + 1)
            calls.resize(depth + 1);
        const bool beginsAgain = calls.size() == depth + 1 && depth > 0 &&
                                 (line.function != calls.back().first->function ||
                                  (line.line == calls.back().first->line && line.loops.empty() &&
                                   line.variables.size() == calls.back().first->variables.size()));
        if (beginsAgain)
            calls.pop_back();
        while (calls.size() < depth + 1)
            calls.push_back({count++, &line});
        m_calls.push_back(calls.back().number);
    }
}

sim::State ListingFrame::stateAfter(int index) const
{
    return m_program->runLines(m_start, m_binding, index).state;
}

void ListingFrame::applyLine(int index, sim::State &state) const
{
    for (const listing::BodyMotion &one : line(index).changed)
        listing::apply(one, state);
}

std::optional<double> ListingFrame::numberOf(const std::string &path, int index) const
{
    const std::optional<Value> value = valueOf(QString::fromStdString(path), index);
    if (!value)
        return {};
    if (const auto *number = std::get_if<double>(&*value))
        return *number;
    if (const auto *whole = std::get_if<std::int64_t>(&*value))
        return static_cast<double>(*whole);
    const auto *truth = std::get_if<bool>(&*value);
    return truth ? std::optional(*truth ? 1.0 : 0.0) : std::nullopt;
}

std::optional<listing::BodyMotion> ListingFrame::motionOf(int point, int index) const
{
    if (point < 0 || point >= m_start.pointCount())
        return {};
    for (int i = std::min(index, count()) - 1; i >= 0; --i) {
        const std::vector<listing::BodyMotion> &changed = line(i).changed;
        const auto found = std::find_if(changed.begin(), changed.end(),
                                        [&](const listing::BodyMotion &one) { return one.point == point; });
        if (found != changed.end())
            return *found;
    }
    return listing::BodyMotion{point, m_start.positionOf(point), m_start.velocityOf(point),
                               m_start.angle.rows() > point ? m_start.angle[point] : 0.0,
                               m_start.spin.rows() > point ? m_start.spin[point] : 0.0};
}

std::optional<Value> ListingFrame::variable(const std::string &name, int index, int scope) const
{
    const auto in = [&](int i) { return variableIn(line(i).variables, name); };
    if (scope < count() && scope >= 0) {
        // The values after `index` lines are those before the next line of the same call.
        for (int i = index; i < count() && line(i).depth >= line(scope).depth; ++i) {
            if (callOf(i) != callOf(scope))
                continue;
            if (const listing::Variable *found = in(i))
                return found->value;
            break;
        }
        for (int i = std::min(index, count()) - 1; i >= 0; --i) {
            const listing::Variable *found = callOf(i) == callOf(scope) ? in(i) : nullptr;
            if (found && !found->isGlobal)
                return found->value;
        }
    }
    const std::vector<listing::Variable> &all = index < count() ? line(index).variables : m_trace.globals;
    const listing::Variable *global = variableIn(all, name);
    return global && global->isGlobal ? std::optional(global->value) : std::nullopt;
}

std::optional<Value> ListingFrame::rootValue(const std::string &name, int index, int scope) const
{
    if (std::optional<Value> value = variable(name, index, scope))
        return value;
    const listing::Vocabulary &names = m_program->vocabulary();
    const auto at = [&](const std::vector<std::string> &list) {
        return static_cast<std::size_t>(std::find(list.begin(), list.end(), name) - list.begin());
    };
    if (const std::size_t i = at(names.bodies); i < names.bodies.size())
        return Value(listing::BodyReference{name, m_binding.bodies[i]});
    if (const std::size_t i = at(names.parameters); i < names.parameters.size())
        return Value(m_binding.parameters[i]);
    const bool isHeld = m_start.hold.point >= 0;
    const sim::Vec2 pointer = m_start.input.pointer.value_or(sim::Vec2{});
    if (name == "pointer")
        return Value(pointer);
    if (name == "hand")
        return Value(isHeld ? m_start.hold.hand : pointer);
    if (name == "pointer_known")
        return Value(m_start.input.pointer.has_value());
    if (name == "target")
        return Value(m_start.input.target);
    if (name == "pointer_down")
        return Value(isHeld || m_start.input.pointerDown);
    if (name == "frame_number")
        return Value(static_cast<double>(m_start.frame));
    return remembered(name, index);
}

std::optional<Value> ListingFrame::remembered(const std::string &name, int index) const
{
    const listing::Vocabulary &names = m_program->vocabulary();
    if (names.hasGait && !names.hasCreatures && (name == "gait" || name == "gait_speed"))
        return gaitOf(0, name, index);
    if (names.hasTree && name == "gust")
        return Value(m_start.input.gust.value_or(0.0));
    if (names.hasTree && name == "gust_known")
        return Value(m_start.input.gust.has_value());
    if (names.hasGust && name == "gust_front")
        return Value(stateAfter(index).gustExtent.front);
    if (names.hasGust && name == "gust_tail")
        return Value(stateAfter(index).gustExtent.tail);
    return {};
}

std::optional<Value> ListingFrame::gaitOf(std::size_t clock, const std::string &member, int index) const
{
    const sim::State state = stateAfter(index);
    const Eigen::ArrayXd &numbers = member == "gait" ? state.gait : state.gaitSpeed;
    const auto row = static_cast<Eigen::Index>(clock);
    return row < numbers.rows() ? std::optional(Value(numbers[row])) : std::nullopt;
}

std::optional<Value> ListingFrame::bodyMember(const listing::BodyReference &body, const std::string &member,
                                              int index) const
{
    const std::optional<listing::BodyMotion> motion = motionOf(body.point, index);
    if (!motion)
        return {};
    if (member == "position")
        return Value(motion->position);
    if (member == "velocity")
        return Value(motion->velocity);
    if (member == "before")
        return Value(m_start.positionOf(body.point));
    if (member == "angle" && m_start.angle.rows() > 0)
        return Value(motion->angle);
    if (member == "spin" && m_start.spin.rows() > 0)
        return Value(motion->spin);
    if (member == "held")
        return Value(m_start.hold.point == body.point);
    if (member == "mass")
        return Value(m_binding.mass[body.point]);
    if (member == "radius")
        return Value(m_binding.radius[body.point]);
    const int branch = branchAt(body.point);
    if (branch < 0)
        return {};
    const listing::Binding::Branch &its = m_binding.branches[static_cast<std::size_t>(branch)];
    if (member == "number")
        return Value(std::int64_t{branch});
    if (member == "rest")
        return Value(its.rest);
    if (member == "scale")
        return Value(its.scale);
    if (member == "length")
        return Value(its.length);
    if (member == "inertia")
        return Value(its.inertia);
    return {};
}

std::optional<Value> ListingFrame::memberValue(const Value &value, const std::string &member, int index) const
{
    if (const auto *vector = std::get_if<sim::Vec2>(&value))
        return memberOf(*vector, member);
    const auto *reference = std::get_if<listing::BodyReference>(&value);
    if (!reference || reference->name.empty())
        return {};
    using Kind = listing::BodyReference::Kind;
    if (reference->kind == Kind::body)
        return bodyMember(*reference, member, index);
    const auto number = static_cast<std::size_t>(numberIn(reference->name));
    if (reference->kind == Kind::creature) {
        if (m_program->vocabulary().hasGait && (member == "gait" || member == "gait_speed"))
            return gaitOf(number, member, index);
        return member == "body"
                   ? std::optional(Value(listing::BodyReference{reference->name + ".body", reference->point}))
                   : std::nullopt;
    }
    if (number >= m_binding.sticks.size())
        return {};
    const sim::Stick &stick = m_binding.sticks[number];
    if (member == "a" || member == "b")
        return Value(
            listing::BodyReference{reference->name + '.' + member, member == "a" ? stick.a : stick.b});
    if (member == "length")
        return Value(stick.length);
    if (member == "share")
        return Value(stick.share);
    return {};
}

int ListingFrame::branchAt(int point) const
{
    const std::vector<int> *branches = pointsOf("branches");
    if (!branches || m_binding.branches.size() != branches->size())
        return -1;
    const auto found = std::find(branches->begin(), branches->end(), point);
    return found == branches->end() ? -1 : static_cast<int>(found - branches->begin());
}

const std::vector<int> *ListingFrame::pointsOf(const std::string &array) const
{
    const std::vector<listing::Vocabulary::Array> &arrays = m_program->vocabulary().arrays;
    const auto found =
        std::find_if(arrays.begin(), arrays.end(), [&](const auto &one) { return one.name == array; });
    return found == arrays.end() ? nullptr
                                 : &m_binding.arrays[static_cast<std::size_t>(found - arrays.begin())];
}

std::optional<ListingFrame::List> ListingFrame::rootList(const std::string &name) const
{
    if (const std::vector<int> *points = pointsOf(name))
        return List{name, points, 0, static_cast<int>(points->size())};
    List list = {name, nullptr, 0, 0};
    if (name == "creatures" && m_program->vocabulary().hasCreatures) {
        list.kind = listing::BodyReference::Kind::creature;
        list.count = static_cast<int>(m_binding.creatures.size());
        return list;
    }
    if (name == "sticks" && m_program->vocabulary().hasSticks) {
        list.kind = listing::BodyReference::Kind::stick;
        list.count = static_cast<int>(m_binding.sticks.size());
        return list;
    }
    return {};
}

std::optional<ListingFrame::List> ListingFrame::memberList(const Value &value,
                                                           const std::string &member) const
{
    const auto *reference = std::get_if<listing::BodyReference>(&value);
    if (!reference)
        return {};
    if (reference->kind == listing::BodyReference::Kind::creature && member == "feet") {
        const auto number = static_cast<std::size_t>(numberIn(reference->name));
        if (number >= m_binding.creatures.size())
            return {};
        const std::vector<int> &feet = m_binding.creatures[number].feet;
        return List{reference->name + ".feet", &feet, 0, static_cast<int>(feet.size())};
    }
    const int branch = member == "children" ? branchAt(reference->point) : -1;
    if (branch < 0)
        return {};
    const listing::Binding::Branch &its = m_binding.branches[static_cast<std::size_t>(branch)];
    return List{"branches", pointsOf("branches"), its.firstChild, its.children};
}

std::optional<Value> ListingFrame::itemOf(const List &list, int i) const
{
    if (i < 0 || i >= list.count)
        return {};
    const int at = list.first + i;
    int point = -1;
    if (list.points)
        point = (*list.points)[static_cast<std::size_t>(at)];
    else if (list.kind == listing::BodyReference::Kind::creature)
        point = m_binding.creatures[static_cast<std::size_t>(at)].body;
    return Value(listing::BodyReference{list.name + '[' + std::to_string(at) + ']', point, list.kind});
}

std::optional<Value> ListingFrame::valueOf(const QString &text, int index, int scope) const
{
    const std::optional<Path> path = pathOf(text.toStdString());
    if (!path)
        return {};
    auto part = path->parts.begin();
    const auto end = path->parts.end();
    std::optional<Value> value = variable(path->root, index, scope);
    std::optional<List> list = value ? std::nullopt : rootList(path->root);
    if (!value && path->root == "keys" && part != end) {
        value = memberOf(m_start.input.keys, part->member);
        ++part;
    } else if (!value && !list) {
        value = rootValue(path->root, index, scope);
    }
    for (; part != end && (value || list); ++part) {
        if (list && part->member == "count") {
            value = Value(std::int64_t{list->count});
            list.reset();
        } else if (list) {
            std::optional<int> i = listing::wholeNumber(part->index);
            if (!i && part->member.empty()) {
                const std::optional<Value> computed =
                    valueOf(QString::fromStdString(part->index), index, scope);
                const auto *whole = computed ? std::get_if<std::int64_t>(&*computed) : nullptr;
                i = whole ? std::optional(static_cast<int>(*whole)) : std::nullopt;
            }
            value = i ? itemOf(*list, *i) : std::nullopt;
            list.reset();
        } else {
            list = part->member.empty() ? std::nullopt : memberList(*value, part->member);
            value = list || part->member.empty() ? std::nullopt : memberValue(*value, part->member, index);
        }
    }
    return value;
}

std::optional<Value> ListingFrame::valueOf(const QString &path, int index) const
{
    return valueOf(path, index, std::min(index, count() - 1));
}

int ListingFrame::nextWithin(int index, int depth) const
{
    int next = index + 1;
    while (next < count() && line(next).depth > depth)
        ++next;
    return std::min(next, count());
}

}
