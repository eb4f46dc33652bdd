#include "app/model/session/open_run.h"

#include "app/model/run/same_run.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <utility>

namespace app {

const lessons::Step *OpenRun::following() const
{
    const std::size_t next = m_step + 1;
    if (next < lesson().steps.size())
        return &lesson().steps[next];
    const std::size_t nextLesson = m_lesson + 1;
    return nextLesson < m_library.lessons.size() ? &m_library.lessons[nextLesson].steps.front() : nullptr;
}

const lessons::Step *OpenRun::preceding() const
{
    if (m_step > 0)
        return &lesson().steps[m_step - 1];
    return m_lesson > 0 && m_lesson < m_library.lessons.size() ? &m_library.lessons[m_lesson - 1].steps.back()
                                                               : nullptr;
}

void OpenRun::setStep(std::size_t lesson, std::size_t step)
{
    m_lesson = lesson;
    m_step = step;
}

void OpenRun::setTimeline(std::unique_ptr<sim::Timeline> timeline)
{
    m_timeline = std::move(timeline);
    m_selected = QString::fromStdString(m_timeline->track().interval().scene.names.front());
}

void OpenRun::addGiven(const sim::Script &script)
{
    std::vector<sim::Script> &all = m_given[key()];
    if (std::none_of(all.begin(), all.end(), [&](const auto &one) { return sameScript(one, script); }))
        all.push_back(script);
}

bool OpenRun::isGiven() const
{
    const auto found = m_given.find(key());
    if (m_isEdited || found == m_given.end())
        return false;
    return std::any_of(found->second.begin(), found->second.end(),
                       [this](const auto &one) { return sameScript(one, m_timeline->script()); });
}

void OpenRun::setDraft(std::optional<QString> draft)
{
    if (draft == m_draft)
        return;
    m_draft = std::move(draft);
    m_changes.announce(ChangeKind::code);
}

void OpenRun::select(const QString &body)
{
    if (body == m_selected)
        return;
    m_selected = body;
    m_changes.announce(ChangeKind::selection);
}

}
