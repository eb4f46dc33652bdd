#pragma once

#include "sim/pipeline/pipeline.h"
#include "sim/simd/thread_pool.h"

#include <vector>

namespace sim {

/// Runs one step: cache block after cache block, or kernel after kernel if the pipeline has no blocks. Both
/// give the same bits as the phases one after the other.
void runStep(const Pipeline &pipeline, State &state);

/// Runs one step. If it has enough cache blocks, the threads of `pool` share them. The bits are the same.
void runStep(const Pipeline &pipeline, State &state, ThreadPool &pool);

/// Runs one step and skips the cache blocks with a nonzero entry in `sleeping`. If `sleeping` is empty, all
/// blocks run.
void runStep(const Pipeline &pipeline, State &state, ThreadPool &pool, const std::vector<char> &sleeping);

}
