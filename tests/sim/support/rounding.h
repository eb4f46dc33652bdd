#pragma once

/// Returns whether this processor has the instructions that rounding.cpp is built for.
bool canRunFused();

/// Returns a b - c.
double productMinus(double a, double b, double c);
