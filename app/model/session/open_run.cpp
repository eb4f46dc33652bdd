#include "app/model/session/open_run.h"

#include "sim/run/script/composed_interval.h"

#include <utility>

namespace app {

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
