#include "app/ui/code/parameter_drag.h"

#include "app/model/code/code_targets.h"

#include <utility>

namespace app {

QStringList ParameterDrag::parameters() const
{
    QStringList ids;
    for (const lessons::Parameter &parameter : m_run.step().parameters) {
        if (!parameter.restartsRun)
            ids << parameter.id;
    }
    return ids;
}

void ParameterDrag::take(const QString &id)
{
    m_changes.endGesture();
    m_drag = Drag{id, m_changes.parameter(id)};
}

bool ParameterDrag::drag(int pixels, bool fine)
{
    const lessons::Parameter *parameter = m_drag ? m_run.step().parameter(m_drag->parameter) : nullptr;
    if (!parameter || parameter->restartsRun)
        return false;
    m_changes.setParameter(parameter->id,
                           draggedValue(*parameter, m_drag->from, (fine ? finePixel : 1.0) * pixels));
    return true;
}

bool ParameterDrag::leave(bool keep)
{
    const std::optional<Drag> drag = std::exchange(m_drag, std::nullopt);
    if (drag && !keep)
        m_changes.setParameter(drag->parameter, drag->from);
    if (drag)
        m_changes.endGesture();
    return drag.has_value();
}

}
