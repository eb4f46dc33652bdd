#include "sim/effects/offset_spring.h"

#include "sim/effects/pair_kernels.h"

namespace sim {

template class PairForce<OffsetLaw>;

}
