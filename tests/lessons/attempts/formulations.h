#pragma once

#include <span>

namespace support {

/// Code that solves a task of a listing in another way than the lesson does, so that agreement of text cannot make it pass.
struct Formulation
{
    const char *lesson;
    const char *step;
    const char *task;
    const char *code;
};

/// Returns right formulations of the tasks of all lessons.
std::span<const Formulation> rightFormulations();

}
