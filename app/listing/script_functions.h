#pragma once

#include <string>
#include <vector>

namespace AngelScript {
class asIScriptEngine;
}

namespace listing {

/// Adds to `engine` what every listing has and no scene decides: Vec2 with its operators, and the functions of numbers
/// and vectors. A function is left out if one of `parameters` has its name; see isUsableName().
void registerFunctions(AngelScript::asIScriptEngine &engine, const std::vector<std::string> &parameters);

}
