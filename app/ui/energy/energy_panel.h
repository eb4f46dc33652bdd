#pragma once

#include "app/model/analysis/energy_lines.h"
#include "app/ui/dock/live_panel.h"
#include "app/ui/theme/theme.h"

class QBoxLayout;
class QButtonGroup;
class QLabel;
class QStackedWidget;

namespace app {

class EnergyList;
class EnergyPlot;
class PanelTitle;
class PlotExport;
enum class EnergyView;

/// The panel of energy and momentum: a plot of the last frames, and the ledger at the cursor.
class EnergyPanel : public LivePanel
{
    Q_OBJECT

public:
    EnergyPanel(const OpenRun &run, Playback &playback, const Preview &preview, const Theme &theme,
                QWidget *parent = nullptr);

    void setView(EnergyView view);
    EnergyView view() const;
    /// Returns the text in place of a ledger; empty where there is one.
    QString reason() const;
    const std::vector<EnergyLine> &lines() const;
    const EnergySeries &series() const { return m_series; }
    EnergyPlot &plot() const { return *m_plot; }
    PlotExport &exports() const { return *m_export; }

    QSize sizeHint() const override { return {660, 290}; }
    QSize minimumSizeHint() const override { return {420, 190}; }

protected:
    void setActive(bool isActive) override;
    bool isChanging() const override;
    void showContents() override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *tabs();
    QWidget *ledger();
    void placeList();
    void showLedger();
    const EnergyLines &counted();
    void followPreview();
    QString unit() const;

    const OpenRun &m_run;
    Playback &m_playback;
    const Preview &m_preview;
    EnergySeries m_series;
    std::optional<EnergyLines> m_lines; ///< of the counted frames; kept because making them takes long
    PanelTitle *m_title;
    QStackedWidget *m_pages;
    QWidget *m_ledger = nullptr;
    QWidget *m_side = nullptr;     ///< the list with its unit
    QBoxLayout *m_split = nullptr; ///< of that and the plot
    QLabel *m_reason = nullptr;
    EnergyPlot *m_plot = nullptr;
    PlotExport *m_export = nullptr;
    EnergyList *m_list = nullptr;
    QLabel *m_unit = nullptr;
    QButtonGroup *m_tabs = nullptr;
    bool m_showsPreview = false; ///< whether the ledger is of the preview's moment
};

}
