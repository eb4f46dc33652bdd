// The scene of a workshop, which the learner builds.

#include "app/model/session.h"

#include <algorithm>

namespace app {

bool Session::build(const Deed &deed, sim::Blueprint blueprint)
{
    sim::Script script = m_timeline->script();
    script.values.blueprint = std::make_shared<const sim::Blueprint>(std::move(blueprint));
    const std::vector<sim::EffectPtr> listed = script.build(script.values).effects;
    std::erase_if(script.effectsOff, [&](const std::string &id) {
        return std::none_of(listed.begin(), listed.end(),
                            [&](const sim::EffectPtr &one) { return one->id() == id; });
    });
    return takeUp(deed, script);
}

bool Session::takeUp(const Deed &deed, const sim::Script &script)
{
    pause();
    letGo();
    letUp();
    sim::Script before = m_timeline->script();
    const bool built = change({}, [&](sim::Timeline &timeline) {
        const sim::Cursor was = timeline.at();
        timeline.seek({});
        try {
            timeline.replace(script);
        } catch (...) {
            timeline.seek(was);
            throw;
        }
        timeline.forgetGhost(); // what was built before is no other run of this scene
        return false;
    });
    if (!built)
        return false;
    remember(deed, std::move(before));
    const std::vector<std::string> &names = m_timeline->track().shown().scene.names;
    if (m_timeline->track().shown().scene.find(m_selected.toStdString()) < 0)
        select(QString::fromStdString(names.front()));
    return true;
}

}
