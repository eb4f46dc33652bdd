#include "sim/methods/methods.h"

#include "sim/methods/adaptive/steps/dop853.h"
#include "sim/methods/adaptive/steps/dormand_prince.h"
#include "sim/methods/adaptive/steps/nystrom.h"
#include "sim/methods/fixed/explicit_euler.h"
#include "sim/methods/fixed/position_verlet.h"
#include "sim/methods/fixed/published.h"
#include "sim/methods/fixed/runge_kutta.h"
#include "sim/methods/fixed/semi_implicit_euler.h"
#include "sim/methods/fixed/velocity_verlet.h"
#include "sim/methods/implicit/backward_euler.h"
#include "sim/methods/implicit/implicit_midpoint.h"
#include "sim/methods/implicit/tr_bdf2.h"

namespace sim {

std::vector<MethodPtr> allMethods()
{
    return {
        std::make_shared<Published>(),      std::make_shared<SemiImplicitEuler>(),
        std::make_shared<ExplicitEuler>(),  std::make_shared<PositionVerlet>(),
        std::make_shared<VelocityVerlet>(), std::make_shared<Midpoint>(),
        std::make_shared<RungeKutta4>(),    std::make_shared<DormandPrince>(),
        std::make_shared<Nystrom>(),        std::make_shared<Dop853>(),
        std::make_shared<BackwardEuler>(),  std::make_shared<ImplicitMidpoint>(),
        std::make_shared<TrBdf2>(),
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

StepSize stepFor(const Method &method, StepSize requested)
{
    const bool adaptive = method.stepping() == Stepping::adaptive;
    if (requested.isAdaptive() == adaptive)
        return requested;
    return adaptive ? StepSize::withTolerance(defaultTolerance) : StepSize::ofLength(1.0);
}

}
