#pragma once

#include "app/model/series/difference_series.h"
#include "app/ui/dock/live_panel.h"
#include "app/ui/theme/theme.h"

class QButtonGroup;
class QLabel;
class QToolButton;

namespace app {

class ComparisonRuns;
class DifferencePlot;
class PanelTitle;
class Playback;
class PlotExport;
class RunEditor;
class RunsMenu;

/// Compares two runs: the distance between a body's positions in both, over time, and the largest of these distances.
class BranchesPanel : public LivePanel
{
    Q_OBJECT

public:
    /// All arguments must outlive it.
    BranchesPanel(const OpenRun &run, RunEditor &editor, Playback &playback, ComparisonRuns &comparisons,
                  const Theme &theme, QWidget *parent = nullptr);

    const DifferenceSeries &series() const { return m_series; }
    DifferencePlot &plot() const { return *m_plot; }
    PlotExport &exports() const { return *m_export; }
    /// Returns a sentence with the largest difference and its frame, or with the reason why there is none.
    QString sentence() const;
    /// Sets of which body the distance is.
    void setOf(DifferenceSeries::Of of);

    QSize sizeHint() const override { return {660, 290}; }
    QSize minimumSizeHint() const override { return {420, 190}; }

protected:
    void setActive(bool isActive) override;
    bool isChanging() const override;
    void showContents() override;

private:
    QWidget *tabs();
    QWidget *foot();
    void goToLargest();
    void nameBodies();

    const OpenRun &m_run;
    Playback &m_playback;
    const ComparisonRuns &m_comparisons;
    const Theme &m_theme;
    DifferenceSeries m_series;
    PanelTitle *m_title;
    DifferencePlot *m_plot;
    PlotExport *m_export;
    QLabel *m_sentence = nullptr;
    QButtonGroup *m_tabs = nullptr; ///< in the order of DifferenceSeries::Of
    QToolButton *m_go = nullptr;
    RunsMenu *m_runs;
};

}
