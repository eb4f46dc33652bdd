// The scene of a workshop, which the learner builds.

#include "app/model/sentences.h"
#include "app/model/session.h"
#include "sim/base/error.h"
#include "sim/run/script/composed_interval.h"

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
    Stand before = stand();
    const sim::Cursor was = m_timeline->cursor();
    try {
        m_timeline->seek({});
        m_timeline->replaceScript(script);
    } catch (const sim::Error &error) {
        m_timeline->seek(was);
        emit said(sentenceFor(error));
        return false;
    }
    m_timeline->dropComparison(); // the scene before this one has other bodies, so it cannot be compared
    m_branches = {};
    m_coming.reset();
    m_beside = 0;
    runIsAnother();
    remember(deed, std::move(before));
    const std::vector<std::string> &names = m_timeline->track().interval().scene.names;
    if (m_timeline->track().interval().scene.find(m_selected.toStdString()) < 0)
        select(QString::fromStdString(names.front()));
    return true;
}

}
