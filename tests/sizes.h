#pragma once

#include <concepts>
#include <cstdlib>

// GCC and clang tell differently whether they compile for AddressSanitizer.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SPRINGSTEP_FOR_ADDRESS_SANITIZER
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define SPRINGSTEP_FOR_ADDRESS_SANITIZER
#endif

namespace tests {

#ifdef SPRINGSTEP_FOR_ADDRESS_SANITIZER
constexpr bool isSanitized = true;
#else
constexpr bool isSanitized = false;
#endif

/// How many of a great number of cases of one kind a suite runs: `all`, or `some` under the sanitizers, where each takes
/// ten to twenty times as long, and the same lines run in fewer of them.
constexpr int sized(int all, int some)
{
    return isSanitized ? some : all;
}

/// Returns the number that an environment variable gives, or `preset` if it is not set.
template <std::unsigned_integral Number>
Number setting(const char *variable, Number preset)
{
    const char *given = std::getenv(variable);
    return given && *given ? static_cast<Number>(std::strtoull(given, nullptr, 10)) : preset;
}

}
