#pragma once

#include "sim/methods/implicit/implicit.h"

namespace sim {

/// The TR-BDF2 method: the trapezoidal rule over the first 0.586 of a step, then the backward differentiation
/// formula of order 2 from both positions. Order 2 and L-stable: it damps oscillations that are far too fast
/// for the step at once, and slow ones hardly at all. Damping by drags is exact: half before and half after
/// (Strang splitting).
/// Source: Bank et al., "Transient simulation of silicon devices and circuits", 1985; Hosea and Shampine,
/// "Analysis and implementation of TR-BDF2", 1996.
class TrBdf2 : public ImplicitMethod
{
public:
    std::string id() const override { return "tr_bdf2"; }
    std::string title() const override { return SIM_TEXT("TR-BDF2"); }
    int order() const override { return 2; }

protected:
    StepFunction stepFunction() const override;
    Region stepRegion() const override { return {"sim/methods/implicit/tr_bdf2.cpp", "tr_bdf2"}; }
};

}
