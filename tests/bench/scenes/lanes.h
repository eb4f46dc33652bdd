#pragma once

#include <immintrin.h>

/// SIMD vectors of four numbers for the limits: hand-written code for AVX2 and FMA. Only for files that are
/// compiled for these. The operators and `mask ? a : b` are the compiler's own.
namespace bench {

using Lanes = __m256d;

inline Lanes every(double value)
{
    return _mm256_set1_pd(value);
}

inline Lanes load(const double *from)
{
    return _mm256_loadu_pd(from);
}

inline void store(double *to, Lanes values)
{
    _mm256_storeu_pd(to, values);
}

inline Lanes root(Lanes square)
{
    return _mm256_sqrt_pd(square);
}

inline Lanes smaller(Lanes a, Lanes b)
{
    return _mm256_min_pd(a, b);
}

inline Lanes larger(Lanes a, Lanes b)
{
    return _mm256_max_pd(a, b);
}

inline Lanes sizeOf(Lanes value)
{
    return _mm256_andnot_pd(every(-0.0), value);
}

/// Returns `value` with its sign flipped where `sign` is negative.
inline Lanes signedBy(Lanes value, Lanes sign)
{
    return _mm256_xor_pd(value, _mm256_and_pd(sign, every(-0.0)));
}

/// Returns `yes` where `sign` is negative, else `no`.
inline Lanes bySign(Lanes sign, Lanes yes, Lanes no)
{
    return _mm256_blendv_pd(no, yes, sign);
}

/// Returns bit `bit` of whole numbers as the sign of lanes.
inline Lanes signFromBit(__m256i whole, int bit)
{
    return _mm256_castsi256_pd(_mm256_slli_epi64(whole, 63 - bit));
}

inline Lanes nearestWhole(Lanes value)
{
    return _mm256_round_pd(value, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC);
}

}
