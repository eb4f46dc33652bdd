#include "tests/bench/scenes/limit_creatures.h"

#include "tests/bench/scenes/lanes.h"

namespace bench {

namespace {

using namespace crowd;

struct Pull
{
    Lanes x, y;
};

/// Returns the force on `foot` from its spring to `body`. The body has the opposite force.
Pull pullOn(const FourCreatures::Point &foot, Lanes bodyX, Lanes bodyY)
{
    const Lanes dx = load(foot.x) - bodyX, dy = load(foot.y) - bodyY;
    const Lanes share = k * (radius / root(dx * dx + dy * dy) - 1.0);
    return {share * dx, share * dy};
}

/// Applies gravity, damping, the move and the walls.
void finish(FourCreatures::Point &point, Pull pull, double half)
{
    Lanes vx = (load(point.vx) + pull.x) * damp;
    Lanes vy = (load(point.vy) + pull.y + gravity) * damp;
    Lanes x = load(point.x) + vx, y = load(point.y) + vy;
    const Lanes far = every(right - half), near = every(left + half), low = every(floor - half);
    vx = ((x > far) | (x < near)) ? vx * -bounce : vx;
    x = larger(smaller(x, far), near);
    vy = y > low ? vy * -bounce : vy;
    y = smaller(y, low);
    store(point.x, x);
    store(point.y, y);
    store(point.vx, vx);
    store(point.vy, vy);
}

}

void limitFrame(FourCreatures *groups, std::size_t count)
{
    for (FourCreatures *four = groups; four != groups + count; ++four) {
        FourCreatures::Point &body = four->points[0];
        const Lanes bodyX = load(body.x), bodyY = load(body.y);
        Pull onBody = {every(0.0), every(0.0)};
        for (int foot = 1; foot < points; ++foot) {
            const Pull pull = pullOn(four->points[foot], bodyX, bodyY);
            onBody = {onBody.x - pull.x, onBody.y - pull.y};
            finish(four->points[foot], pull, halfFoot);
        }
        finish(body, onBody, halfBody);
    }
}

}
