#include "sim/wide.h"

#include <cstdlib>
#include <string_view>

namespace sim {

namespace {

bool found()
{
#if defined(__GNUC__) && defined(__x86_64__)
    const char *said = std::getenv("SPRINGSTEP_INSTRUCTIONS");
    if (said && std::string_view(said) == "baseline")
        return false;
    return __builtin_cpu_supports("avx2");
#else
    return false;
#endif
}

}

bool hasWideInstructions()
{
    static const bool wide = found();
    return wide;
}

}
