#pragma once

namespace bench {

/// A full tree breadth first: branch i has the children 2i + 1 and 2i + 2. One entry a branch, and four more.
struct TreeArrays
{
    int branches = 0;             ///< 2^n - 1
    const double *rest = nullptr; ///< degrees
    const double *scale = nullptr;
    double *angle = nullptr;           ///< degrees
    double *x = nullptr, *y = nullptr; ///< px: where a branch begins
};

/// Of the tutorial's last step. `length` is a branch's of scale 1 (px), `ease` in frames, `strength` the wind's, the
/// pointer in px, this frame's gust in degrees.
struct TreeNumbers
{
    double length = 0.0, ease = 0.0, strength = 0.0;
    double pointerX = 0.0, pointerY = 0.0, gust = 0.0;
};

/// A frame of it, by the corrected formula with the wind blowing, as one would write it by hand for AVX2: level after
/// level over arrays, four branches at once, polynomials for sine, cosine and arc tangent, and none computed twice.
/// Each branch takes an arc tangent of its own, as the wind comes to its end; siblings share their beginning alone.
void limitFrame(const TreeArrays &tree, const TreeNumbers &numbers);

}
