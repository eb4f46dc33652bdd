#pragma once

#include "app/ui/dock/number_pace.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

#include <vector>

namespace app {

class ParameterRow;
class OpenRun;
class RunEditor;

/// The first parameters of a step in a bar, as many as fit.
class FocusParameters : public QWidget
{
    Q_OBJECT

public:
    static constexpr std::size_t most = 3;

    FocusParameters(const OpenRun &run, RunEditor &editor, const Playback &playback, const Theme &theme,
                    QWidget *parent = nullptr);

    /// Returns the rows of the first parameters, including those that do not fit.
    const std::vector<ParameterRow *> &rows() const { return m_rows; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {0, 0}; }

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void open();
    void refresh();
    void fit();

    const OpenRun &m_run;
    RunEditor &m_editor;
    const Theme &m_theme;
    std::vector<ParameterRow *> m_rows;
    NumberPace m_pace;
};

}
