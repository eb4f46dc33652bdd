#pragma once

#include "app/model/energy_lines.h"
#include "app/ui/theme/theme.h"

#include <QElapsedTimer>
#include <QWidget>

class QBoxLayout;
class QLabel;
class QStackedWidget;
class QToolButton;

namespace app {

class EnergyList;
class EnergyPlot;
class PanelTitle;
class PlotExport;

/// Where energy and momentum went: a plot of the last frames, and the ledger at the cursor. Counts only while it is
/// seen.
class EnergyPanel : public QWidget
{
    Q_OBJECT

public:
    EnergyPanel(Session &session, const Theme &theme, QWidget *parent = nullptr);

    enum View { energy, momentum };
    void setView(View view);
    View view() const { return m_view; }
    /// While another tab covers it, it counts and draws nothing.
    void setCovered(bool covered);
    /// What is said in place of a ledger; empty where there is one.
    QString reason() const;
    const std::vector<EnergyLine> &lines() const;
    const EnergyCourse &course() const { return m_course; }
    EnergyPlot &plot() const { return *m_plot; }
    PlotExport &exports() const { return *m_export; }

    /// Where the mouse points in another plot, as its second cursor.
    void setHovered(std::optional<std::int64_t> frame);

    QSize sizeHint() const override { return {660, 290}; }
    QSize minimumSizeHint() const override { return {420, 190}; }

signals:
    /// The mouse is at a frame of the plot, or has left.
    void pointedAt(std::optional<std::int64_t> frame);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *tabs();
    QWidget *ledger();
    void placeList();
    void refresh();
    void refreshNow();
    void showLedger();
    const EnergyLines &counted();
    void followGlance();
    bool isSeen() const { return isVisible() && !m_isCovered; }
    void watch();
    QString unit() const;

    Session &m_session;
    EnergyCourse m_course;
    std::optional<EnergyLines> m_lines; ///< of what is counted: to look at all of it takes long
    View m_view = energy;
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
    std::vector<QToolButton *> m_tabs;
    QElapsedTimer m_sinceRefresh;
    QTimer m_later;
    bool m_isCovered = false;
    bool m_isElsewhere = false; ///< whether the ledger is of a moment that somebody looks at
};

}
