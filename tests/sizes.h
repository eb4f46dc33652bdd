#pragma once

namespace tests {

/// How many of a great number of cases of one kind a suite runs: `all`, or `some` under the sanitizers, where each takes
/// ten to twenty times as long, and the same lines run in fewer of them.
constexpr int sized([[maybe_unused]] int all, [[maybe_unused]] int some)
{
#ifdef __SANITIZE_ADDRESS__
    return some;
#else
    return all;
#endif
}

}
