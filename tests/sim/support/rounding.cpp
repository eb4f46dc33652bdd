// Built with fused multiply-add where the compiler supports it. If the compiler contracted a product and a
// sum into one operation, it would round once less and the result would differ. This file must not include
// Eigen, because Eigen's memory layout depends on these compiler options.

#include "tests/sim/support/rounding.h"

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
