#pragma once

#include "lessons/api/checks/exact_run.h"
#include "sim/run/script/script.h"
#include "sim/scene/scene.h"

#include <cstdint>
#include <optional>
#include <string>

namespace app {

/// Numbers of a whole scene that conditions of projects can use: how many parts it has, where its outermost bodies are, how
/// long its sticks are, how exact the run is. lessons/README.md lists them.
class ProjectNumbers
{
public:
    /// `script` is the judged run, and `start` the state that it begins with. Both must outlive this object.
    ProjectNumbers(const sim::Script &script, const sim::State &start) : m_script(script), m_start(start) {}

    /// Returns the number called `name` in `state` after `frame` frames. Empty for an unknown name, and for the error of a
    /// run that has no exact one.
    std::optional<double> at(const std::string &name, const sim::Scene &scene, const sim::State &state,
                             std::int64_t frame) const;

private:
    const sim::Script &m_script;
    const sim::State m_start;
    mutable lessons::ExactRun m_exact;
};

}
