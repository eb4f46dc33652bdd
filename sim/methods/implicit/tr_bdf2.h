#pragma once

#include "sim/methods/implicit/implicit.h"

namespace sim {

/// TR-BDF2: the trapezoid rule over the first 0.586 of a step, then the backward differentiation formula of order 2
/// over those two places. Order 2 and L-stable: what is far too stiff for the step is damped at once, what the step
/// can follow hardly at all. Damping enters exactly, half before and half after (Strang's splitting).
/// Source: Bank et al., "Transient simulation of silicon devices and circuits", 1985; Hosea and Shampine, "Analysis and
/// implementation of TR-BDF2", 1996.
class TrBdf2 : public ImplicitMethod
{
public:
    std::string id() const override { return "tr_bdf2"; }
    std::string title() const override { return SIM_TEXT("TR-BDF2"); }
    int order() const override { return 2; }

protected:
    Take taking() const override;
    Region shown() const override { return {"sim/methods/implicit/tr_bdf2.cpp", "tr_bdf2"}; }
};

}
