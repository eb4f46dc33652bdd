#pragma once

namespace bench {

/// A square cloth of `side` x `side` points, row by row. The code reads four more numbers after the last row,
/// but does not use them. The top row is fixed. `side` is a multiple of 4.
struct ClothArrays
{
    int side = 0;
    double *x = nullptr, *y = nullptr;   ///< px
    double *vx = nullptr, *vy = nullptr; ///< px/frame
    /// Memory for forces, 8 rows of side + 8.
    double *scratch = nullptr;
};

/// Springs of stiffness k (1/frame^2) and rest length `length` px; gravity px/frame^2.
struct ClothNumbers
{
    double k = 0.0, length = 0.0, gravity = 0.0, damp = 1.0;
};

/// Computes a frame by semi-implicit Euler, as a hand-written stencil loop for AVX2: row by row, each spring
/// once for both of its ends, with the forces of a row in the cache.
void limitFrame(const ClothArrays &cloth, const ClothNumbers &numbers);

}
