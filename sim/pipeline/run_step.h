#pragma once

#include "sim/pipeline/pipeline.h"
#include "sim/simd/thread_pool.h"

#include <vector>

namespace sim {

/// Runs one step: block after block where the pipeline has blocks, else phase after phase. Either way
/// `state` comes out the same in every bit.
void runStep(const Pipeline &pipeline, State &state);

/// The same; what is large enough to gain by it `crew` shares among its threads. The same bits again.
void runStep(const Pipeline &pipeline, State &state, ThreadPool &pool);

/// The same without the blocks whose entry in `asleep` is not 0; empty: with all of them.
void runStep(const Pipeline &pipeline, State &state, ThreadPool &pool, const std::vector<char> &asleep);

}
