#pragma once

#include "app/ui/theme/theme.h"

#include <QWidget>

namespace app {

class MeasurePanel;
class MeasureSeries;
class OpenRun;
class ParameterPanel;
class Playback;
class Preview;
class RunEditor;

/// The measures of a step, if it has any, above its parameters.
class NumbersPanel : public QWidget
{
    Q_OBJECT

public:
    /// All arguments must outlive it.
    NumbersPanel(const OpenRun &run, RunEditor &editor, Playback &playback, Preview &preview,
                 MeasureSeries &series, const Theme &theme, QWidget *parent);

    ParameterPanel &parameters() const { return *m_parameters; }

signals:
    /// sizeHint().height() has changed.
    void wantedHeightChanged();

private:
    void showMeasures();

    MeasurePanel *m_measures;
    QWidget *m_divider; ///< between measures and parameters
    ParameterPanel *m_parameters;
};

}
