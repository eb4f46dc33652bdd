#pragma once

#include "sim/base/vec2.h"

#include <string>
#include <vector>

namespace AngelScript {
class asIScriptEngine;
}

namespace listing {

/// A Vec2 in the memory of the interpreter, whose stack aligns to 4 bytes only. Functions return a Vec2, because such a
/// struct would be returned in another way.
struct [[gnu::packed, gnu::aligned(4)]] VectorCell
{
    double x;
    double y;
};

inline sim::Vec2 read(const VectorCell &cell)
{
    return {cell.x, cell.y};
}

/// Adds to `engine` what every listing has and no scene decides: Vec2 with its operators, and the functions of numbers
/// and vectors. Those of angles are not among them, see AngleFunctions. A function is left out if one of `parameters` has its name; see isUsableName().
void registerFunctions(AngelScript::asIScriptEngine &engine, const std::vector<std::string> &parameters);

}
