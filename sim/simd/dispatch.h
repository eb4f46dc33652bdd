#pragma once

/// Before a loop over points: no turn of it reads what another one writes, so several may run at once.
#if defined(__clang__)
#define SIM_TURNS_ARE_APART _Pragma("clang loop vectorize(assume_safety)")
#elif defined(__GNUC__)
#define SIM_TURNS_ARE_APART _Pragma("GCC ivdep")
#else
#define SIM_TURNS_ARE_APART
#endif

namespace sim {

/// The instructions that loops over many numbers run with.
enum class InstructionSet {
    baseline, ///< those of every machine of its kind
    avx2,     ///< four numbers at a time
    avx512,   ///< eight
};

/// The widest that this machine has. The environment variable SPRINGSTEP_INSTRUCTIONS=baseline, or avx2, says that it
/// may be no wider. Found out once.
InstructionSet instructionSet();

#if defined(__GNUC__) && defined(__x86_64__)

/// `work` compiled for machines with AVX2, with all that it calls. Multiply-add in one instruction is left out on
/// purpose: it rounds once where two instructions round twice, and the same input would not give the same bits.
template <class Work>
[[gnu::target("avx2"), gnu::flatten, gnu::noinline]] void runAvx2(const Work &work)
{
    work();
}

/// The same for AVX-512. It has that instruction, too: -ffp-contract=off keeps it out.
template <class Work>
[[gnu::target("avx512f,avx512vl,avx512dq,avx512bw,prefer-vector-width=512"), gnu::flatten,
  gnu::noinline]] void
runAvx512(const Work &work)
{
    work();
}

#endif

/// The same compiled for every machine of its kind.
template <class Work>
#if defined(__GNUC__)
[[gnu::flatten, gnu::noinline]]
#endif
void runBaseline(const Work &work)
{
    work();
}

/// Runs `work`, a loop over many numbers, in the form that is the fastest on this machine. All forms come to the same
/// bits.
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
