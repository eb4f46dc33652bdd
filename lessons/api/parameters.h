#pragma once

#include "lessons/api/parameter.h"

#include <vector>

/// The parameters that several lessons share.
namespace lessons {

Parameter stiffness(double preset = 0.2);
Parameter damping(double preset = 0.9);
Parameter radius(double preset = 50.0);
Parameter offset(double preset = 50.0);
Parameter feet(int preset);
Parameter gravity(double preset = 0.5);
Parameter bounce(double preset = 1.0);
/// `centre_x` and `centre_y`.
std::vector<Parameter> centre();
/// `left`, `right` and `floor`.
std::vector<Parameter> room();

}
