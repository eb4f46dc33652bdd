#include "app/listing/cell_values.h"

#include "sim/scene/state.h"

#include <angelscript.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <utility>

namespace listing {

using namespace AngelScript;

namespace {

/// Returns the index of `cell` in `cells`, if it is one of them.
template <class Cell>
std::optional<std::size_t> indexOf(const Cell *cell, const std::vector<Cell> &cells)
{
    const std::less<const Cell *> isBefore;
    if (!cell || cells.empty() || isBefore(cell, cells.data()) ||
        !isBefore(cell, cells.data() + cells.size()))
        return {};
    return static_cast<std::size_t>(cell - cells.data());
}

}

std::string typeName(const Value &value)
{
    static const char *const names[] = {"double", "int", "bool", "Vec2", "Body"};
    const auto *reference = std::get_if<BodyReference>(&value);
    if (reference && reference->kind == BodyReference::Kind::creature)
        return "Creature";
    if (reference && reference->kind == BodyReference::Kind::stick)
        return "Stick";
    return names[value.index()];
}

bool isFinite(sim::Vec2 vector)
{
    return std::isfinite(vector.x) && std::isfinite(vector.y);
}

bool isFinite(const Value &value)
{
    const auto *number = std::get_if<double>(&value);
    const auto *vector = std::get_if<sim::Vec2>(&value);
    return number ? std::isfinite(*number) : !vector || isFinite(*vector);
}

void sortByPlace(std::span<CompileError> errors)
{
    std::stable_sort(errors.begin(), errors.end(), [](const CompileError &a, const CompileError &b) {
        return std::pair(a.line, a.column) < std::pair(b.line, b.column);
    });
}

void apply(const BodyMotion &motion, sim::State &state)
{
    state.place(motion.point, motion.position);
    state.setVelocity(motion.point, motion.velocity);
    if (state.angle.rows() > motion.point)
        state.angle[motion.point] = motion.angle;
    if (state.spin.rows() > motion.point)
        state.spin[motion.point] = motion.spin;
}

std::string cellName(const std::string &array, std::size_t index)
{
    return array + "[" + std::to_string(index) + "]";
}

Value CellValues::valueOf(const BodyCell *cell) const
{
    if (!cell)
        return BodyReference();
    for (std::size_t i = 0; i < m_cells.bodies.size(); ++i) {
        if (cell == &m_cells.bodies[i])
            return BodyReference{m_vocabulary.bodies[i], cell->point};
    }
    for (const BodyArray &array : m_cells.arrays) {
        if (const auto index = indexOf(cell, array.cells))
            return BodyReference{cellName(array.name, *index), cell->point};
    }
    for (std::size_t i = 0; i < m_cells.creatures.cells.size(); ++i) {
        const CreatureCell &creature = m_cells.creatures.cells[i];
        if (cell == &creature.body)
            return BodyReference{cellName("creatures", i) + ".body", cell->point};
        if (const auto index = indexOf(cell, creature.feet.cells))
            return BodyReference{cellName(creature.feet.name, *index), cell->point};
    }
    return BodyReference{nameBySticks(cell), cell->point};
}

std::string CellValues::nameBySticks(const BodyCell *cell) const
{
    for (std::size_t i = 0; i < m_cells.sticks.cells.size(); ++i) {
        const StickCell &stick = m_cells.sticks.cells[i];
        if (cell == stick.a || cell == stick.b)
            return cellName("sticks", i) + (cell == stick.a ? ".a" : ".b");
    }
    return {};
}

Value CellValues::valueOf(const CreatureCell *cell) const
{
    const std::optional<std::size_t> index = indexOf(cell, m_cells.creatures.cells);
    constexpr auto kind = BodyReference::Kind::creature;
    return index ? BodyReference{cellName("creatures", *index), cell->body.point, kind}
                 : BodyReference{{}, -1, kind};
}

Value CellValues::valueOf(const StickCell *cell) const
{
    const std::optional<std::size_t> index = indexOf(cell, m_cells.sticks.cells);
    return BodyReference{index ? cellName("sticks", *index) : std::string(), -1, BodyReference::Kind::stick};
}

std::optional<Value> CellValues::valueAt(const void *address, int type) const
{
    if (!address)
        return {};
    const auto number = [address]<class Number>(Number value) {
        std::memcpy(&value, address, sizeof value);
        return value;
    };
    switch (type) {
    case asTYPEID_BOOL:
        return Value(number(char{}) != 0);
    case asTYPEID_INT32:
        return Value(std::int64_t{number(std::int32_t{})});
    case asTYPEID_DOUBLE:
        return Value(number(double{}));
    default:
        break;
    }
    if (type == m_types.vec2)
        return Value(number(sim::Vec2{}));
    if ((type & asTYPEID_MASK_SEQNBR) == m_types.body)
        return valueOf(number(static_cast<const BodyCell *>(nullptr)));
    if ((type & asTYPEID_MASK_SEQNBR) == m_types.creature)
        return valueOf(number(static_cast<const CreatureCell *>(nullptr)));
    if ((type & asTYPEID_MASK_SEQNBR) == m_types.stick)
        return valueOf(number(static_cast<const StickCell *>(nullptr)));
    return {};
}

}
