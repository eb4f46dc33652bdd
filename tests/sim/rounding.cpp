// Built for fused multiply-add where the compiler knows it: contraction, which rounds less often and gives other
// bits, then shows. Nothing of Eigen may come in here: its memory layout depends on such options.

#include "rounding.h"

bool canRunFused()
{
#if defined(__FMA__) && (defined(__x86_64__) || defined(__i386__))
    return __builtin_cpu_supports("fma");
#else
    return true;
#endif
}

double productMinus(double a, double b, double c)
{
    return a * b - c;
}
