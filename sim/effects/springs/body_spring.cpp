#include "sim/effects/springs/body_spring.h"

#include "sim/effects/pairs/pair_kernels.h"

namespace sim {

template class PairForce<BodyLaw>;

namespace descriptions {
constinit const EffectDescription body_spring = {"body_spring", SIM_TEXT("spring"), EffectKind::spring,
                                                 SIM_TEXT("Pulls a foot to the body, wherever that is.")};
}

}
