#include "sim/methods/touching.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace sim {

Touching::Touching(const Scene &scene)
{
    for (int point = 0; point < scene.start.points(); ++point) {
        int number = 0;
        for (const EffectPtr &effect : scene.effects) {
            const auto contact = std::dynamic_pointer_cast<const Contact>(effect);
            if (!contact || !scene.hasInertia(point))
                continue;
            for (const Surface &surface : contact->surfaces(point))
                m_places.push_back({point, 1 << number++, surface});
        }
    }
}

double restingSpeed(double pull, double tolerance)
{
    return std::max(1e-3, std::sqrt(2.0 * pull * 0.1 * tolerance));
}

Vec2 bounced(const Surface &surface, Vec2 v)
{
    const double into = away(surface, v);
    if (surface.grip == Grip::full)
        v = into * surface.normal;
    return v - ((1.0 + surface.bounce) * into) * surface.normal;
}

Vec2 held(const Surface &surface, Vec2 a)
{
    if (surface.grip == Grip::full)
        return {0.0, 0.0};
    return a - away(surface, a) * surface.normal;
}

}
