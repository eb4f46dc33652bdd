#pragma once

#include "lessons/api/step.h"
#include "tests/lessons/tutorial.h"

#include <QMetaType>

#include <random>

namespace support {

/// An experiment for both a step and the Tutorial.
struct Match
{
    const char *step = nullptr;
    Tutorial tutorial;
};

/// A tutorial with random stiffness, damping and so on, `feet` feet and the body at random places with random
/// velocities, and a hand that drags and throws one after the other.
Tutorial randomTutorial(Tutorial::Kind kind, int feet, std::mt19937 &random);

/// The largest difference of a position or a velocity between the step and the tutorial, over `frames` frames.
double largestDifference(const lessons::Step &step, const Tutorial &tutorial, int frames);

}

Q_DECLARE_METATYPE(support::Match)
