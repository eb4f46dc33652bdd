#pragma once

namespace bench {

/// A full tree in breadth-first order: branch i has the children 2i + 1 and 2i + 2. Arrays have one entry per
/// branch, and four more.
struct TreeArrays
{
    int branches = 0;             ///< 2^n - 1
    const double *rest = nullptr; ///< degrees
    const double *scale = nullptr;
    double *angle = nullptr;           ///< degrees
    double *x = nullptr, *y = nullptr; ///< px, the start of a branch
};

/// The numbers of the tutorial's last step. `length`: of a branch of scale 1 (px); `ease`: in frames;
/// `strength`: of the wind; the pointer in px; this frame's gust in degrees.
struct TreeNumbers
{
    double length = 0.0, ease = 0.0, strength = 0.0;
    double pointerX = 0.0, pointerY = 0.0, gust = 0.0;
};

/// Computes a frame by the corrected formula in the wind, as hand-written code for AVX2: level by level over
/// arrays, four branches at once, with polynomials for sine, cosine and arc tangent, each computed only once.
/// Every branch needs its own arc tangent, because the wind acts on its end; siblings share only their start.
void limitFrame(const TreeArrays &tree, const TreeNumbers &numbers);

}
