#pragma once

/// Whether this processor runs what rounding.cpp is built for.
bool canRunFused();

/// a b - c.
double productMinus(double a, double b, double c);
