// A frame of many creatures through scene and pipeline. For comparison, bench_limits.cpp measures
// hand-written code and peer_*.cpp measures other engines.

#include "tests/bench/scenes/crowd_runs.h"

namespace {

using namespace bench::crowd;

const benchmark::internal::Benchmark *const entered[] = {
    enter({"creatures", inTheRoom, ours}),
    enter({"creatures_built", builtInTheRoom, ours}),
    enter({"creatures_in_air", inTheAir, ours}),
};

}
