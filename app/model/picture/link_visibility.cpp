#include "app/model/picture/link_visibility.h"

#include <algorithm>
#include <set>

namespace app {

namespace {

/// Pairs of points, with the smaller index first.
using Pairs = std::set<sim::Coupling>;

sim::Coupling pairOf(int a, int b)
{
    return {std::min(a, b), std::max(a, b)};
}

/// Returns the pairs that springs and sticks connect. Other effects that use two points, such as drags, do not
/// connect them.
Pairs heldBy(const std::vector<sim::EffectPtr> &effects)
{
    std::vector<sim::Coupling> ties;
    for (const sim::EffectPtr &effect : effects) {
        if (effect->kind() == sim::EffectKind::spring || effect->kind() == sim::EffectKind::stick)
            effect->addCouplings(ties);
    }
    Pairs pairs;
    for (const sim::Coupling &tie : ties)
        pairs.insert(pairOf(tie.first, tie.second));
    return pairs;
}

bool hasRule(const std::vector<sim::EffectPtr> &effects)
{
    return std::any_of(effects.begin(), effects.end(),
                       [](const sim::EffectPtr &one) { return one->kind() == sim::EffectKind::rule; });
}

}

void dropLinks(lessons::View &view, const std::vector<sim::EffectPtr> &listed,
               const std::vector<sim::EffectPtr> &acting)
{
    const Pairs all = heldBy(listed);
    const Pairs still = heldBy(acting);
    const auto isLoose = [&](int a, int b) {
        const sim::Coupling pair = pairOf(a, b);
        return all.contains(pair) && !still.contains(pair);
    };
    const auto hasLoosePart = [&](const std::vector<int> &points) {
        for (std::size_t i = 1; i < points.size(); ++i) {
            if (isLoose(points[i - 1], points[i]))
                return true;
        }
        return false;
    };
    std::erase_if(view.legs, [&](const lessons::LegView &leg) { return isLoose(leg.from, leg.to); });
    std::erase_if(view.sticks, [&](const lessons::StickView &stick) { return isLoose(stick.a, stick.b); });
    std::erase_if(view.springs, [&](const lessons::SpringView &one) { return isLoose(one.a, one.b); });
    std::erase_if(view.sheets, [&](const lessons::SheetView &sheet) {
        const auto &[a, b, c, d] = sheet.corners;
        return isLoose(a, b) || isLoose(b, c) || isLoose(c, d) || isLoose(d, a);
    });
    std::erase_if(view.limbs, [&](const lessons::LimbView &limb) { return isLoose(limb.a, limb.b); });
    std::erase_if(view.chains, [&](const lessons::ChainView &chain) { return hasLoosePart(chain.points); });
    if (hasRule(listed) && !hasRule(acting))
        view.ruleLinks.clear();
    std::erase_if(view.skins, [&](const lessons::SkinView &skin) { return hasLoosePart(skin.outline); });
}

}
