#include "sim/simd/dispatch.h"

#include <cstdlib>
#include <string_view>

namespace sim {

namespace {

InstructionSet found()
{
#if defined(__GNUC__) && defined(__x86_64__)
    const char *said = std::getenv("SPRINGSTEP_INSTRUCTIONS");
    const std::string_view most = said ? said : "";
    if (most == "baseline" || !__builtin_cpu_supports("avx2"))
        return InstructionSet::baseline;
    const bool has512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
    return has512 && most != "avx2" ? InstructionSet::avx512 : InstructionSet::avx2;
#else
    return InstructionSet::baseline;
#endif
}

}

InstructionSet instructionSet()
{
    static const InstructionSet widest = found();
    return widest;
}

}
