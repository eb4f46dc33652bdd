#include "tests/bench/peers/plain_crowd.h"

#include "tests/bench/scenes/crowd_numbers.h"

#include <cmath>

namespace bench {

namespace {

using namespace crowd;

/// Adds the forces between the bodies of all creatures and one foot of each.
void addPulls(int creatures, const double *bodyX, const double *bodyY, const double *x, const double *y,
              double *__restrict bodyAx, double *__restrict bodyAy, double *__restrict ax,
              double *__restrict ay)
{
    for (int i = 0; i < creatures; ++i) {
        const double dx = x[i] - bodyX[i], dy = y[i] - bodyY[i];
        const double share = k * (radius / std::sqrt(dx * dx + dy * dy) - 1.0);
        ax[i] += share * dx;
        ay[i] += share * dy;
        bodyAx[i] -= share * dx;
        bodyAy[i] -= share * dy;
    }
}

void add(int count, double *__restrict to, const double *__restrict what)
{
    for (int i = 0; i < count; ++i)
        to[i] += what[i];
}

void slow(int count, double *v)
{
    for (int i = 0; i < count; ++i)
        v[i] *= damp;
}

void clear(int count, double *a)
{
    for (int i = 0; i < count; ++i)
        a[i] = 0.0;
}

}

void plainFrame(const CrowdArrays &all)
{
    const int n = all.creatures, count = points * n;
    clear(count, all.ax);
    clear(count, all.ay);
    for (int foot = 1; foot < points; ++foot) {
        const int first = foot * n;
        addPulls(n, all.x, all.y, all.x + first, all.y + first, all.ax, all.ay, all.ax + first,
                 all.ay + first);
    }
    add(count, all.vx, all.ax);
    add(count, all.vy, all.ay);
    slow(count, all.vx);
    slow(count, all.vy);
    add(count, all.x, all.vx);
    add(count, all.y, all.vy);
}

}
