#include "sim/methods/methods.h"

#include "sim/methods/published.h"
#include "sim/methods/semi_implicit_euler.h"

namespace sim {

std::vector<MethodPtr> allMethods()
{
    return {
        std::make_shared<Published>(),
        std::make_shared<SemiImplicitEuler>(),
    };
}

MethodPtr findMethod(const std::string &id)
{
    for (const MethodPtr &method : allMethods()) {
        if (method->id() == id)
            return method;
    }
    return nullptr;
}

StepSize stepFor(const Method &method, StepSize own)
{
    const bool adaptive = method.stepping() == Stepping::adaptive;
    if (own.adaptive() == adaptive)
        return own;
    return adaptive ? StepSize::within(presetTolerance) : StepSize::of(1.0);
}

}
