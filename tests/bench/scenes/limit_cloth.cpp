#include "tests/bench/scenes/limit_cloth.h"

#include "tests/bench/scenes/lanes.h"

namespace bench {

namespace {

/// Forces on a row of points, x and y. Entry -1 also exists.
struct Pulls
{
    double *x, *y;
};

/// Adds the forces of springs from the points at `x`, `y` to the points at `toX`, `toY`.
void pull(const double *x, const double *y, const double *toX, const double *toY, int count,
          const ClothNumbers &numbers, Pulls into)
{
    for (int i = 0; i < count; i += 4) {
        const Lanes dx = load(toX + i) - load(x + i), dy = load(toY + i) - load(y + i);
        const Lanes share = numbers.k * (1.0 - numbers.length / root(dx * dx + dy * dy));
        store(into.x + i, share * dx);
        store(into.y + i, share * dy);
    }
}

void finish(const ClothArrays &cloth, int first, const ClothNumbers &numbers, Pulls right, Pulls up,
            Pulls down)
{
    for (int i = 0; i < cloth.side; i += 4) {
        const Lanes ax = load(right.x + i) - load(right.x + i - 1) + load(down.x + i) - load(up.x + i);
        const Lanes ay = load(right.y + i) - load(right.y + i - 1) + load(down.y + i) - load(up.y + i);
        const int at = first + i;
        const Lanes vx = (load(cloth.vx + at) + ax) * numbers.damp;
        const Lanes vy = (load(cloth.vy + at) + ay + numbers.gravity) * numbers.damp;
        store(cloth.vx + at, vx);
        store(cloth.vy + at, vy);
        store(cloth.x + at, load(cloth.x + at) + vx);
        store(cloth.y + at, load(cloth.y + at) + vy);
    }
}

}

void limitFrame(const ClothArrays &cloth, const ClothNumbers &numbers)
{
    const int side = cloth.side, width = side + 8;
    const auto rowOf = [&](int row) { return cloth.scratch + row * width + 4; };
    const Pulls right = {rowOf(0), rowOf(1)}, none = {rowOf(6), rowOf(7)};
    Pulls up = {rowOf(2), rowOf(3)}, down = {rowOf(4), rowOf(5)};
    for (int i = 0; i < side; ++i)
        none.x[i] = none.y[i] = 0.0;
    right.x[-1] = right.y[-1] = 0.0;
    pull(cloth.x, cloth.y, cloth.x + side, cloth.y + side, side, numbers, up);
    for (int row = 1; row < side; ++row) {
        const double *x = cloth.x + row * side, *y = cloth.y + row * side;
        pull(x, y, x + 1, y + 1, side, numbers, right);
        right.x[side - 1] = right.y[side - 1] = 0.0; // its neighbour belongs to another row
        const bool isLast = row + 1 == side;
        if (!isLast)
            pull(x, y, x + side, y + side, side, numbers, down);
        finish(cloth, row * side, numbers, right, up, isLast ? none : down);
        const Pulls done = up;
        up = down;
        down = done;
    }
}

}
