// A frame of many creatures through scene and pipeline. What can be reached by hand is in bench_limits.cpp, what others
// take in peer_*.cpp.

#include "crowd_runs.h"

namespace {

using namespace bench::crowd;

const benchmark::internal::Benchmark *const entered[] = {
    enter({"creatures", inTheRoom, ours}),
    enter({"creatures_built", builtInTheRoom, ours}),
    enter({"creatures_in_air", inTheAir, ours}),
};

}
