#pragma once

#include <cstdint>

namespace sim {

/// Returns a hash of 64 bits: neighbouring inputs give unrelated outputs.
/// Source: Steele, Lea and Flood, "Fast splittable pseudorandom number generators" (SplitMix64), 2014.
constexpr std::uint64_t mixBits(std::uint64_t z)
{
    z += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
}

/// Returns a pseudorandom number in [0, 1) that depends only on the arguments. No generator state is stored,
/// so a run that goes back in time gets the same numbers again.
constexpr double uniform(std::uint64_t seed, std::int64_t frame, std::int64_t index)
{
    const std::uint64_t bits = mixBits(mixBits(mixBits(seed) ^ static_cast<std::uint64_t>(frame)) ^
                                       static_cast<std::uint64_t>(index));
    return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

}
