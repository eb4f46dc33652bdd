#include "app/model/session/offered_parameters.h"

#include <algorithm>

namespace app {

std::vector<const lessons::Parameter *> offeredParameters(const OpenRun &run, const RunEditor &editor)
{
    std::vector<const lessons::Parameter *> offered;
    std::vector<sim::EffectPtr> listed;
    for (const lessons::Parameter &parameter : run.step().parameters) {
        if (!parameter.effects.isEmpty() && listed.empty())
            listed = editor.listedEffects();
        const bool isRead = std::any_of(listed.begin(), listed.end(), [&](const sim::EffectPtr &one) {
            return parameter.effects.contains(QString::fromStdString(one->id()));
        });
        if (parameter.effects.isEmpty() || isRead)
            offered.push_back(&parameter);
    }
    return offered;
}

}
