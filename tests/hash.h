#pragma once

#include "sim/scene/state.h"

#include <cstddef>
#include <cstdint>

namespace tests {

/// The 64-bit FNV-1a hash of no bytes.
inline constexpr std::uint64_t emptyHash = 0xcbf29ce484222325u;

/// Returns a 64-bit FNV-1a hash, updated with more bytes. Source: RFC 9923.
inline std::uint64_t updatedHash(std::uint64_t hash, const void *data, std::size_t bytes)
{
    const auto *byte = static_cast<const unsigned char *>(data);
    for (std::size_t i = 0; i < bytes; ++i)
        hash = (hash ^ byte[i]) * 0x100000001b3u;
    return hash;
}

/// Returns a hash, updated with all bits of a state.
inline std::uint64_t updatedHash(std::uint64_t hash, const sim::State &state)
{
    sim::visitBytes(state,
                    [&](const void *data, std::size_t bytes) { hash = updatedHash(hash, data, bytes); });
    return hash;
}

}
