#pragma once

#include <cstdint>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace sim {

/// A scope in which this thread reads and writes denormal numbers (below 2.2e-308) as 0. The destructor
/// restores the previous mode. All code that runs phases needs such a scope, so that a run has the same bits
/// on every thread. Motion that dies out also reaches 0 soon. Otherwise it would need many steps with
/// denormals, which are slow on many processors. On processors other than x86-64 and 64-bit ARM it does
/// nothing.
/// Source: Intel, "64 and IA-32 architectures software developer's manual", volume 1, sections 10.2.3.3 and
/// 10.2.3.4 (FTZ, DAZ); Arm, "Architecture reference manual", FPCR, bit FZ.
class FlushDenormals
{
public:
    FlushDenormals() : m_before(mode()) { setMode(m_before | flushBits); }
    ~FlushDenormals() { setMode(m_before); }
    FlushDenormals(const FlushDenormals &) = delete;
    FlushDenormals &operator=(const FlushDenormals &) = delete;

    /// Returns whether this thread flushes denormals to 0. Always false on other processors.
    static bool isActive() { return flushBits != 0 && (mode() & flushBits) == flushBits; }

private:
#if defined(__SSE2__)
    using Mode = unsigned int;
    static constexpr Mode flushBits = 0x8040; // FTZ and DAZ
    static Mode mode()
    {
        return _mm_getcsr();
    }
    static void setMode(Mode mode)
    {
        _mm_setcsr(mode);
    }
#elif defined(__aarch64__)
    using Mode = std::uint64_t;
    static constexpr Mode flushBits = Mode{1} << 24; // FZ
    static Mode mode()
    {
        Mode mode = 0;
        asm volatile("mrs %0, fpcr" : "=r"(mode));
        return mode;
    }
    static void setMode(Mode mode)
    {
        asm volatile("msr fpcr, %0" : : "r"(mode) : "memory");
    }
#else
    using Mode = unsigned int;
    static constexpr Mode flushBits = 0;
    static Mode mode()
    {
        return 0;
    }
    static void setMode(Mode) {}
#endif

    Mode m_before;
};

}
