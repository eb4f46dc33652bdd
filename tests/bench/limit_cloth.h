#pragma once

namespace bench {

/// A square cloth of `side` x `side` points, row by row; four more numbers behind the last row are read, and not used.
/// The top row hangs. `side` is a multiple of 4.
struct ClothArrays
{
    int side = 0;
    double *x = nullptr, *y = nullptr;   ///< px
    double *vx = nullptr, *vy = nullptr; ///< px/frame
    /// Room for pulls, 8 rows of side + 8.
    double *scratch = nullptr;
};

/// Springs of stiffness k (1/frame^2) and rest length `length` px; gravity px/frame^2.
struct ClothNumbers
{
    double k = 0.0, length = 0.0, gravity = 0.0, damp = 1.0;
};

/// A frame by semi-implicit Euler, as a loop over a stencil that one would write by hand for AVX2: row by row, each
/// spring once for both of its ends, a row's pulls kept in the cache.
void limitFrame(const ClothArrays &cloth, const ClothNumbers &numbers);

}
