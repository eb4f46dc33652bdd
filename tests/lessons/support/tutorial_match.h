#pragma once

#include "lessons/api/step.h"
#include "tests/lessons/support/tutorial.h"

#include <QMetaType>

#include <random>

namespace support {

/// An experiment that both a lesson step and the Tutorial compute.
struct Match
{
    const char *step = nullptr;
    Tutorial tutorial;
};

/// Returns a tutorial with random parameters, `feet` feet and a body. They start with random positions and
/// velocities. Its input drags and throws random ones of them.
Tutorial randomTutorial(Tutorial::Kind kind, int feet, std::mt19937 &random);

/// Returns the largest difference in any position or velocity between step and tutorial, over `frames`
/// frames.
double largestDifference(const lessons::Step &step, const Tutorial &tutorial, int frames);

}

Q_DECLARE_METATYPE(support::Match)
