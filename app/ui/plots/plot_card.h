#pragma once

#include "app/ui/dock/number_pace.h"
#include "app/ui/plots/plot_export.h"
#include "app/ui/plots/quantity_menu.h"
#include "app/ui/plots/quantity_plot.h"

#include <QWidget>

class QToolButton;

namespace app {

class FlatButton;
class PlotValue;

/// A plot with its header: the quantities as menus, the number at the cursor, and a menu of commands.
class PlotCard : public QWidget
{
    Q_OBJECT

public:
    PlotCard(const OpenRun &run, Playback &playback, const ComparisonRuns &comparisons,
             const PlotSeries &series, const Theme &theme, QWidget *parent = nullptr);

    void setSpec(const PlotSpec &spec);
    const PlotSpec &spec() const { return m_plot->spec(); }
    void refresh(const std::vector<double> &begun, const std::optional<PlotSeries::Inside> &inside);
    QuantityPlot &plot() const { return *m_plot; }
    PlotExport &exports() const { return *m_export; }
    /// Returns a new menu with the commands of the plot; the caller owns it.
    QMenu *menu();

signals:
    /// Emitted when the learner chooses other quantities.
    void changeWanted(const app::PlotSpec &spec);
    void removalWanted();
    void pointedAt(std::optional<std::int64_t> frame);
    void zoomWanted(int steps);

protected:
    void contextMenuEvent(QContextMenuEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *header();
    /// Returns a button with a menu that chooses the quantity of an axis.
    FlatButton *chooser(QuantityMenu::Axis axis, Quantity PlotSpec::*quantity, const QString &tip);
    void fitHeader();
    void writeHeader();
    void openMenu(const QPoint &place);
    std::optional<NumberSheet> numbers() const;

    const OpenRun &m_run;
    Playback &m_playback;
    const ComparisonRuns &m_comparisons;
    const PlotSeries &m_series;
    const Theme &m_theme;
    QuantityPlot *m_plot;
    PlotExport *m_export;
    FlatButton *m_up = nullptr;
    FlatButton *m_across = nullptr;
    PlotValue *m_value = nullptr;
    NumberPace m_pace{m_playback};
    QToolButton *m_more = nullptr;
};

}
