#include "tests/bench/peers/plain_creature.h"

#include <cmath>

namespace bench {

void PlainCreature::pullPublished(std::size_t mover, std::size_t anchor)
{
    const double angle = std::atan2(y[mover] - y[anchor], x[mover] - x[anchor]);
    vx[mover] += k * (x[anchor] + radius * std::cos(angle) - x[mover]);
    vy[mover] += k * (y[anchor] + radius * std::sin(angle) - y[mover]);
}

void PlainCreature::finish(std::size_t i)
{
    const double half = i == feet ? 15.0 : 5.0;
    vx[i] *= damp;
    vy[i] *= damp;
    x[i] += vx[i];
    y[i] += vy[i];
    if (x[i] > right - half) {
        x[i] = right - half;
        vx[i] *= -bounce;
    }
    if (x[i] < left + half) {
        x[i] = left + half;
        vx[i] *= -bounce;
    }
    if (y[i] > floor - half) {
        y[i] = floor - half;
        vy[i] *= -bounce;
    }
}

void PlainCreature::published()
{
    for (std::size_t i = 0; i < feet; ++i)
        pullPublished(i, feet);
    for (std::size_t i = 0; i < feet; ++i) {
        vy[i] += gravity;
        finish(i);
    }
    for (std::size_t i = 0; i < feet; ++i)
        pullPublished(feet, i);
    vy[feet] += gravity;
    finish(feet);
}

void PlainCreature::semiImplicit()
{
    std::array<double, points> ax{}, ay{};
    for (std::size_t i = 0; i < feet; ++i) {
        const double dx = x[i] - x[feet], dy = y[i] - y[feet];
        const double length = std::sqrt(dx * dx + dy * dy);
        const double ux = dx / length, uy = dy / length;
        ax[i] = k * (x[feet] + radius * ux - x[i]);
        ay[i] = k * (y[feet] + radius * uy - y[i]);
        ax[feet] += k * (x[i] + radius * -ux - x[feet]);
        ay[feet] += k * (y[i] + radius * -uy - y[feet]);
    }
    for (std::size_t i = 0; i < points; ++i) {
        vx[i] += ax[i];
        vy[i] += ay[i] + gravity;
        finish(i);
    }
}

}
