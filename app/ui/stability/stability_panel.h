#pragma once

#include "app/model/stability_words.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

#include <vector>

class QGridLayout;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace app {

class GrowthPlot;
class PanelTitle;
class PlotExport;

/// What bounds the step, which spring or body decides it, what would mend it, and on request the map of growth.
class StabilityPanel : public QWidget
{
    Q_OBJECT

public:
    StabilityPanel(StabilityWatch &watch, const Theme &theme, QWidget *parent = nullptr);

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
    QWidget *title();
    QWidget *card();
    QWidget *mends();
    QWidget *map();
    QToolButton *mapButton(const QString &text, const QString &tip, MapPlane plane);
    void dress();
    void refresh();
    void refreshRemedies(const std::vector<sim::Remedy> &remedies);
    QPushButton *remedyButton(const sim::Remedy &remedy);
    void placeRemedies();
    void refreshMap();
    QString whyNoMap() const;

    StabilityWatch &m_watch;
    const Theme &m_theme;
    PanelTitle *m_title = nullptr;
    QToolButton *m_close = nullptr;
    QLabel *m_verdict = nullptr;
    QLabel *m_leftOut = nullptr;
    QWidget *m_mends = nullptr;
    QGridLayout *m_rows = nullptr;
    QStringList m_offered; ///< what the rows say, so that they stay while it does
    std::vector<QWidget *> m_cells;
    std::vector<QPushButton *> m_remedies;
    std::vector<QHBoxLayout *> m_shortRows; ///< of these, beside a map
    std::vector<QToolButton *> m_planes;
    QLabel *m_noMap = nullptr;
    GrowthPlot *m_plot = nullptr;
    PlotExport *m_export = nullptr;
    QToolButton *m_plotMenu = nullptr;
};

}
