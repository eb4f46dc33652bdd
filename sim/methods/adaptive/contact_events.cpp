#include "sim/methods/adaptive/contact_events.h"

#include "sim/effects/contacts/reflection.h"

#include <algorithm>
#include <cmath>

namespace sim {

ContactCandidates::ContactCandidates(const Scene &scene, const std::vector<PointRange> &ranges)
{
    std::vector<const Contact *> contacts;
    for (const EffectPtr &effect : scene.effects) {
        if (const auto *contact = as<Contact>(effect))
            contacts.push_back(contact);
    }
    int row = 0;
    for (const PointRange &range : ranges) {
        for (int point = range.first; point < range.end(); ++point, ++row) {
            int index = 0;
            for (const Contact *contact : contacts) {
                if (!scene.movesByVelocity(point))
                    continue;
                for (const Surface &surface : contact->surfaces(point))
                    m_candidates.push_back({point, row, 1 << index++, surface});
            }
        }
    }
}

double restingSpeed(double acceleration, double tolerance)
{
    return std::max(1e-3, std::sqrt(2.0 * acceleration * 0.1 * tolerance));
}

Vec2 bounced(const Surface &surface, Vec2 v)
{
    if (surface.traction == Traction::full)
        v = normalVelocity(surface, v) * surface.normal;
    return reflected(v, surface.normal, surface.bounce);
}

Vec2 restingAcceleration(const Surface &surface, Vec2 a)
{
    if (surface.traction == Traction::full)
        return {0.0, 0.0};
    return a - normalVelocity(surface, a) * surface.normal;
}

}
