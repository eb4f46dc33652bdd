#include "sim/effects/springs/offset_spring.h"

#include "sim/effects/pairs/pair_kernels.h"

namespace sim {

template class PairForce<OffsetLaw>;

namespace descriptions {
constinit const EffectDescription offset_spring = {"offset_spring", SIM_TEXT("spring"), EffectKind::spring,
                                                   SIM_TEXT("Pulls a foot to a place beside the body.")};
}

}
