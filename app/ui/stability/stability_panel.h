#pragma once

#include "app/model/analysis/settling_monitor.h"
#include "app/model/text/stability_text.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

#include <vector>

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QToolButton;

namespace app {

class Command;
class GrowthPlot;
class PanelTitle;
class PlotExport;
class SettlingPlot;

/// The panel of stability: the limit of the step, the spring or body that decides it, remedies, and on request the map
/// of growth or the map of settling times.
class StabilityPanel : public QWidget
{
    Q_OBJECT

public:
    /// `toggle` shows and hides the panel, `settlingToggle` the map of settling times in it.
    StabilityPanel(StabilityMonitor &monitor, SettlingMonitor &settling, const Command &toggle,
                   const Command &settlingToggle, const Theme &theme, QWidget *parent = nullptr);

    QString verdict() const;
    QString leftOut() const;
    const std::vector<QPushButton *> &remedies() const { return m_remedies; }
    GrowthPlot &plot() { return *m_plot; }
    SettlingPlot &settlingPlot() { return *m_settlingPlot; }
    PlotExport &exports() const { return *m_export; }
    /// Shows a map of growth in place of another map. Empty: shows no map of growth.
    void showMap(std::optional<MapPlane> plane);
    /// Shows the map of settling times in place of a map of growth, or hides it.
    void showSettling(bool shown);

signals:
    void closed();
    /// Emitted when the map of settling times was shown or hidden.
    void settlingShown(bool isShown);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *title(const Command &toggle);
    QWidget *card();
    QWidget *remedyRows();
    QWidget *map();
    QWidget *mapTabs();
    QToolButton *mapButton(const QString &text, const QString &tip, MapPlane plane);
    void makeExport();
    void refresh();
    void refreshRemedies(const std::vector<sim::Remedy> &remedies);
    QPushButton *remedyButton(const sim::Remedy &remedy);
    void placeRemedies();
    void refreshMap();
    void refreshSettling();
    QString whyNoMap() const;

    StabilityMonitor &m_monitor;
    SettlingMonitor &m_settling;
    const Theme &m_theme;
    PanelTitle *m_title = nullptr;
    QScrollArea *m_area = nullptr;
    QLabel *m_verdict = nullptr;
    QLabel *m_leftOut = nullptr;
    QWidget *m_remedyRows = nullptr;
    QGridLayout *m_rows = nullptr;
    QStringList m_offered; ///< the texts of the rows, which are kept while these stay the same
    std::vector<QWidget *> m_cells;
    std::vector<QPushButton *> m_remedies;
    std::vector<QHBoxLayout *> m_shortRows; ///< of the remedies, beside a map
    std::vector<QToolButton *> m_planes;
    QToolButton *m_settlingTab = nullptr;
    QLabel *m_noMap = nullptr;
    QLabel *m_counted = nullptr; ///< what the map of settling times counts, or why there is none
    GrowthPlot *m_plot = nullptr;
    SettlingPlot *m_settlingPlot = nullptr;
    PlotExport *m_export = nullptr;
    QToolButton *m_plotMenu = nullptr;
};

}
