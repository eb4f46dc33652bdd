#pragma once

/// Stands before a loop whose iterations are independent: none reads what another one writes. It lets the
/// compiler vectorise the loop.
#if defined(__clang__)
#define SIM_INDEPENDENT_ITERATIONS _Pragma("clang loop vectorize(assume_safety) interleave_count(1)")
#elif defined(__GNUC__)
#define SIM_INDEPENDENT_ITERATIONS _Pragma("GCC ivdep")
#else
#define SIM_INDEPENDENT_ITERATIONS
#endif

/// Stands before a function that the work of dispatch() calls. GCC compiles such functions for the instruction
/// set of the work as they are, clang only if they are always inlined: its attribute `flatten` includes only
/// the calls that the work makes itself.
#if defined(__GNUC__)
#define SIM_INLINED [[gnu::always_inline]]
#else
#define SIM_INLINED
#endif

/// Eight doubles at a time. GCC uses half of them if it is not told; clang does not know the option.
#if defined(__clang__)
#define SIM_AVX512 "avx512f,avx512vl,avx512dq,avx512bw"
#else
#define SIM_AVX512 "avx512f,avx512vl,avx512dq,avx512bw,prefer-vector-width=512"
#endif

namespace sim {

/// The instruction set for loops over many numbers.
enum class InstructionSet {
    baseline, ///< what every processor of the architecture has
    avx2,     ///< four doubles at a time
    avx512,   ///< eight doubles at a time
};

/// Returns the widest instruction set of this machine. The environment variable SPRINGSTEP_INSTRUCTIONS
/// limits it to "baseline" or "avx2". It is read at the first call.
InstructionSet instructionSet();

#if defined(__GNUC__) && defined(__x86_64__)

/// Runs `work`, compiled for AVX2 with everything that it calls. FMA instructions are disabled on purpose: a
/// fused multiply-add rounds once instead of twice, so results would differ from machine to machine.
template <class Work>
[[gnu::target("avx2"), gnu::flatten, gnu::noinline]] void runAvx2(const Work &work)
{
    work();
}

/// Runs `work`, compiled for AVX-512. AVX-512 includes FMA instructions; -ffp-contract=off disables them.
template <class Work>
[[gnu::target(SIM_AVX512), gnu::flatten, gnu::noinline]] void runAvx512(const Work &work)
{
    work();
}

#endif

/// Runs `work`, compiled for every processor of the architecture.
template <class Work>
#if defined(__GNUC__)
[[gnu::flatten, gnu::noinline]]
#endif
void runBaseline(const Work &work)
{
    work();
}

/// Runs `work`, a loop over many numbers, with the widest instruction set of this machine. All instruction
/// sets give the same bits.
template <class Work>
void dispatch(const Work &work)
{
#if defined(__GNUC__) && defined(__x86_64__)
    switch (instructionSet()) {
    case InstructionSet::avx512:
        runAvx512(work);
        return;
    case InstructionSet::avx2:
        runAvx2(work);
        return;
    case InstructionSet::baseline:
        break;
    }
#endif
    runBaseline(work);
}

}
