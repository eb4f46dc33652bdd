#include "sim/pipeline.h"

#include "sim/error.h"

#include <cmath>

namespace sim {

StepSize StepSize::of(double h)
{
    if (h >= 1e-6 * (1.0 - 1e-9) && h <= 100.0) {
        const double whole = std::round(h);
        if (h >= 1.0 && std::abs(h - whole) <= 1e-9)
            return {whole, 1, static_cast<int>(whole)};
        const double parts = std::round(1.0 / h);
        if (h < 1.0 && std::abs(1.0 / h - parts) <= 1e-9 * parts)
            return {1.0 / parts, static_cast<int>(parts), 1};
    }
    throw Error("step-size", {{"h", std::to_string(h)}});
}

Pipeline compose(const Scene &scene, const Method &method, StepSize step)
{
    Pipeline pipeline{method.phases(scene, step.h), step};
    if (pipeline.phases.empty())
        throw Error("nothing-moves", {{"method", method.id()}});
    return pipeline;
}

}
