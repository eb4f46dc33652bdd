#include "app/model/catalog/known_effects.h"

#include "sim/base/error.h"
#include "sim/effects/all_effects.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <algorithm>

namespace app {

namespace {

std::vector<sim::EffectPtr> effectsOf(const lessons::Step &step)
{
    try {
        return step.scene(step.defaultValues()).effects;
    } catch (const sim::Error &) {
        return {}; // a step that does not open has no known effects
    }
}

}

std::vector<KnownEffect> effectsKnownBy(const LessonLibrary &library, const std::function<bool()> &goesOn)
{
    std::vector<KnownEffect> known;
    for (const LessonEntry &lesson : library.lessons) {
        for (const lessons::Step &step : lesson.steps) {
            if (!goesOn())
                return known;
            for (const sim::EffectPtr &effect : effectsOf(step)) {
                const auto isSame = [&](const KnownEffect &one) {
                    return one.kind == effect->kind() && one.title == effect->title();
                };
                if (std::none_of(known.begin(), known.end(), isSame))
                    known.push_back({effect->id(), effect->title(), sim::purposeOf(*effect), effect->kind(),
                                     lesson.title});
            }
        }
    }
    return known;
}

}
