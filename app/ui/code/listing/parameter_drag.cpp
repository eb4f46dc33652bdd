#include "app/ui/code/listing/parameter_drag.h"

#include "app/model/code/code_targets.h"
#include "app/ui/code/listing/listing_editor.h"

namespace app {

ParameterDrag::ParameterDrag(ListingEditor &editor, const OpenRun &run, RunEditor &changes)
    : QObject(&editor), m_editor(editor), m_run(run), m_changes(changes)
{
    connect(&editor, &ListingEditor::parameterTaken, this, &ParameterDrag::take);
    connect(&editor, &ListingEditor::parameterDragged, this, &ParameterDrag::drag);
    connect(&editor, &ListingEditor::parameterLeft, this, &ParameterDrag::leave);
    connect(&editor, &ListingEditor::numberGesture, this, [this] { m_changes.endGesture(); });
}

void ParameterDrag::offer()
{
    QStringList parameters;
    for (const lessons::Parameter &parameter : m_run.step().parameters) {
        if (!parameter.restartsRun) // dragging it would restart the run at every value
            parameters << parameter.id;
    }
    m_editor.setParameters(parameters);
}

void ParameterDrag::take(const QString &id)
{
    m_changes.endGesture();
    m_drag = Drag{id, m_changes.parameter(id)};
}

void ParameterDrag::drag(int pixels, bool fine)
{
    const lessons::Parameter *parameter = m_drag ? m_run.step().parameter(m_drag->parameter) : nullptr;
    if (parameter)
        m_changes.setParameter(parameter->id,
                               draggedValue(*parameter, m_drag->from, (fine ? finePixel : 1.0) * pixels));
}

void ParameterDrag::leave(bool keep)
{
    if (!m_drag)
        return;
    if (!keep)
        m_changes.setParameter(m_drag->parameter, m_drag->from);
    m_changes.endGesture();
    m_drag.reset();
}

}
