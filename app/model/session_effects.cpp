// The effects of a session's scene, and which of them are switched off.

#include "app/model/sentences.h"
#include "app/model/session.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>

namespace app {

std::vector<sim::EffectPtr> Session::listedEffects() const
{
    const sim::Script &script = m_timeline->script();
    const sim::ComposedInterval &interval = *m_timeline->track().nextInterval();
    return script.effectsOff.empty() ? interval.scene.effects : script.build(interval.values).effects;
}

bool Session::isOff(const QString &effect) const
{
    const std::vector<std::string> &off = m_timeline->script().effectsOff;
    return std::find(off.begin(), off.end(), effect.toStdString()) != off.end();
}

void Session::setEffect(const QString &id, bool on)
{
    const std::vector<sim::EffectPtr> listed = listedEffects();
    const auto found = std::find_if(listed.begin(), listed.end(),
                                    [&](const sim::EffectPtr &one) { return one->id() == id.toStdString(); });
    if (found == listed.end() || isOff(id) != on)
        return;
    const QString title = capitalised(phrase((*found)->title()));
    const QString was = on ? tr("%1 off").arg(title) : tr("%1 on").arg(title);
    edit({on ? tr("%1 on").arg(title) : tr("%1 off").arg(title), was}, [&](sim::Timeline &timeline) {
        sim::Script script = timeline.script();
        script.effectsOff.clear(); // in the scene's order, however they were switched
        for (const sim::EffectPtr &one : listed) {
            const QString other = QString::fromStdString(one->id());
            const bool known = std::find(script.effectsOff.begin(), script.effectsOff.end(), one->id()) !=
                               script.effectsOff.end();
            if (!known && (other == id ? !on : isOff(other)))
                script.effectsOff.push_back(one->id());
        }
        return timeline.replaceScript(std::move(script));
    });
}

}
