#pragma once

#include "app/listing/values.h"
#include "app/listing/vocabulary.h"
#include "sim/base/vec2.h"

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace AngelScript {
class asIScriptEngine;
}

namespace listing {

struct BodyCell;

/// Bodies that are neighbours in an array: the children of a branch.
struct ChildArray
{
    int count = 0;
    BodyCell *first = nullptr;
};

/// A body as the interpreter sees it.
struct BodyCell
{
    sim::Vec2 position, velocity, before;
    double mass = 0.0, radius = 0.0, angle = 0.0, spin = 0.0;
    bool held = false;
    int point = -1;
    // of a branch
    int number = 0;
    double rest = 0.0, scale = 0.0, length = 0.0, inertia = 0.0;
    ChildArray children;
};

struct BodyArray
{
    int count = 0;
    std::string name;
    std::vector<BodyCell> cells;
};

struct CreatureCell
{
    BodyCell body;
    BodyArray feet;
    double gait = 0.0, gaitSpeed = 0.0;
};

struct CreatureArray
{
    int count = 0;
    std::vector<CreatureCell> cells;
};

struct StickCell
{
    BodyCell *a = nullptr, *b = nullptr;
    double length = 0.0, share = 0.0;
};

struct StickArray
{
    int count = 0;
    std::vector<StickCell> cells;
};

/// Places that were clicked, as the interpreter sees them.
struct TargetArray
{
    int count = 0;
    std::vector<sim::Vec2> all;
};

/// Keys, as the interpreter sees them.
struct KeyCell
{
    bool left = false, right = false, up = false, down = false;
};

/// The cells that the names of a vocabulary stand for.
struct NamedCells
{
    std::deque<BodyCell> bodies;
    std::deque<BodyCell *> handles; ///< one per single body; null if the scene does not have it
    std::deque<BodyArray> arrays;
    CreatureArray creatures;
    std::vector<BodyCell> others; ///< without a name
    StickArray sticks;
};

/// The interpreter's numbers of the types of a scene.
struct CellTypes
{
    int vec2 = 0;
    int body = 0;
    int creature = -1; ///< -1: this scene has no creatures
    int stick = -1;    ///< -1: this scene has no sticks
};

/// What a program may do with the bodies of the scene.
enum class BodyAccess { write, read };

/// Registers with `engine` the types of the cells of a scene, and the functions that need cells only. The functions of
/// registerFunctions() come before. Returns the interpreter's numbers of the types.
CellTypes registerCellTypes(AngelScript::asIScriptEngine &engine, const Vocabulary &vocabulary,
                            BodyAccess access);

/// Returns whether `cell` is a body. If the variable stands for none, the program stops with an error.
bool standsForBody(const void *cell);

/// Returns the name of an element, for example "feet[2]".
std::string cellName(const std::string &array, std::size_t index);

/// Reads variables of programs as plain values, in which references to cells are names of the scene.
class CellValues
{
public:
    /// The references must outlive this object.
    CellValues(const NamedCells &cells, const CellTypes &types, const Vocabulary &vocabulary)
        : m_cells(cells), m_types(types), m_vocabulary(vocabulary)
    {
    }

    /// Returns the value of a variable at `address`. Empty if a listing cannot have variables of this type.
    std::optional<Value> valueAt(const void *address, int type) const;
    /// Returns the name of a body that has none in the scene, by a stick that ends there: "sticks[3].b".
    std::string nameBySticks(const BodyCell *cell) const;

private:
    Value valueOf(const BodyCell *cell) const;
    Value valueOf(const CreatureCell *cell) const;
    Value valueOf(const StickCell *cell) const;

    const NamedCells &m_cells;
    const CellTypes &m_types;
    const Vocabulary &m_vocabulary;
};

}
