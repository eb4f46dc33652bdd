#pragma once

#include "app/model/text/stability_text.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

#include <vector>

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace app {

class Command;
class GrowthPlot;
class PanelTitle;
class PlotExport;

/// The panel of stability: the limit of the step, the spring or body that decides it, remedies, and on request the map
/// of growth.
class StabilityPanel : public QWidget
{
    Q_OBJECT

public:
    /// `toggle` shows and hides the panel.
    StabilityPanel(StabilityMonitor &monitor, const Command &toggle, const Theme &theme,
                   QWidget *parent = nullptr);

    QString verdict() const;
    QString leftOut() const;
    const std::vector<QPushButton *> &remedies() const { return m_remedies; }
    GrowthPlot &plot() { return *m_plot; }
    PlotExport &exports() const { return *m_export; }
    void showMap(std::optional<MapPlane> plane);

signals:
    void closed();

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *title(const Command &toggle);
    QWidget *card();
    QWidget *remedyRows();
    QWidget *map();
    QToolButton *mapButton(const QString &text, const QString &tip, MapPlane plane);
    void applyTheme();
    void refresh();
    void refreshRemedies(const std::vector<sim::Remedy> &remedies);
    QPushButton *remedyButton(const sim::Remedy &remedy);
    void placeRemedies();
    void refreshMap();
    QString whyNoMap() const;

    StabilityMonitor &m_monitor;
    const Theme &m_theme;
    PanelTitle *m_title = nullptr;
    QToolButton *m_close = nullptr;
    QLabel *m_verdict = nullptr;
    QLabel *m_leftOut = nullptr;
    QWidget *m_remedyRows = nullptr;
    QGridLayout *m_rows = nullptr;
    QStringList m_offered; ///< the texts of the rows, which are kept while these stay the same
    std::vector<QWidget *> m_cells;
    std::vector<QPushButton *> m_remedies;
    std::vector<QHBoxLayout *> m_shortRows; ///< of the remedies, beside a map
    std::vector<QToolButton *> m_planes;
    QLabel *m_noMap = nullptr;
    GrowthPlot *m_plot = nullptr;
    PlotExport *m_export = nullptr;
    QToolButton *m_plotMenu = nullptr;
};

}
