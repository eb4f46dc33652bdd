#include "sim/simd/dispatch.h"

#include <cstdlib>
#include <string_view>

namespace sim {

namespace {

InstructionSet detectInstructionSet()
{
#if defined(__GNUC__) && defined(__x86_64__)
    const char *variable = std::getenv("SPRINGSTEP_INSTRUCTIONS");
    const std::string_view limit = variable ? variable : "";
    if (limit == "baseline" || !__builtin_cpu_supports("avx2"))
        return InstructionSet::baseline;
    const bool has512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
    return has512 && limit != "avx2" ? InstructionSet::avx512 : InstructionSet::avx2;
#else
    return InstructionSet::baseline;
#endif
}

}

InstructionSet instructionSet()
{
    static const InstructionSet detected = detectInstructionSet();
    return detected;
}

}
