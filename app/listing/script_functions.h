#pragma once

namespace AngelScript {
class asIScriptEngine;
}

namespace listing {

/// Adds to `engine` what every listing has and no scene decides: Vec2 with its operators, and the functions of numbers
/// and vectors.
void registerFunctions(AngelScript::asIScriptEngine &engine);

}
