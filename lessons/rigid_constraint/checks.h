#pragma once

#include "lessons/api/try.h"

#include <vector>

/// The things to try in each step.
namespace rigid_constraint {

std::vector<lessons::Try> pairTries();
std::vector<lessons::Try> sharedErrorTries();
std::vector<lessons::Try> triangleTries();
std::vector<lessons::Try> listTries();
std::vector<lessons::Try> verletTries();
std::vector<lessons::Try> ragdollTries();

}
