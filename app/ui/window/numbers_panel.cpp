#include "app/ui/window/numbers_panel.h"

#include "app/ui/dock/divider.h"
#include "app/ui/dock/panel_parts.h"
#include "app/ui/parameters/measure_panel.h"
#include "app/ui/parameters/parameter_panel.h"
#include "app/ui/scene/drawing/thumbnail.h"

#include <QVBoxLayout>

namespace app {

NumbersPanel::NumbersPanel(const OpenRun &run, RunEditor &editor, Playback &playback, Preview &preview,
                           MeasureSeries &series, const Theme &theme, QWidget *parent)
    : QWidget(parent), m_measures(new MeasurePanel(run, playback, preview, series, theme, this)),
      m_divider(divider(this)), m_parameters(new ParameterPanel(run, editor, playback, theme, this))
{
    m_parameters->setPresetPainter(
        [&theme](const lessons::Step &step, const lessons::Preset &preset, QSize size) {
            sim::Values values = step.defaultValues();
            for (const auto &[id, value] : preset.values)
                values.set(id.toStdString(), value);
            return thumbnail(step, values, theme, size);
        });
    QVBoxLayout *column = makeColumn(this);
    column->addWidget(m_measures);
    column->addWidget(m_divider);
    column->addWidget(m_parameters, 1);
    connect(m_parameters, &ParameterPanel::wantedHeightChanged, this, &NumbersPanel::wantedHeightChanged);
    connect(m_measures, &MeasurePanel::contentChanged, this, &NumbersPanel::showMeasures);
    showMeasures();
}

void NumbersPanel::showMeasures()
{
    m_measures->setVisible(!m_measures->isEmpty());
    m_divider->setVisible(!m_measures->isEmpty());
    emit wantedHeightChanged();
}

}
