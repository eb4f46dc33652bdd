#pragma once

#include "app/model/difference_course.h"
#include "app/ui/theme/theme.h"

#include <QElapsedTimer>
#include <QWidget>

class QLabel;
class QToolButton;

namespace app {

class DifferencePlot;
class PanelTitle;
class PlotExport;
class RunsMenu;

/// Two runs compared: how far a body is in the one from where it is in the other, over time, and the largest of it. Looks
/// only while it is seen.
class BranchesPanel : public QWidget
{
    Q_OBJECT

public:
    BranchesPanel(Session &session, const Theme &theme, QWidget *parent = nullptr);

    /// While another tab covers it, it looks at and draws nothing.
    void setCovered(bool covered);
    const DifferenceCourse &course() const { return m_course; }
    DifferencePlot &plot() const { return *m_plot; }
    PlotExport &exports() const { return *m_export; }
    /// The largest difference and where it is, or why there is none.
    QString sentence() const;
    /// Of which body.
    void setOf(DifferenceCourse::Of of);

    /// Where the mouse points in another plot, as the plot's second cursor.
    void setHovered(std::optional<std::int64_t> frame);

    QSize sizeHint() const override { return {660, 290}; }
    QSize minimumSizeHint() const override { return {420, 190}; }

signals:
    /// The mouse is at a frame of the plot, or has left.
    void pointedAt(std::optional<std::int64_t> frame);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    QWidget *tabs();
    QToolButton *tab(const QString &name, const QString &tip);
    QWidget *foot();
    void goToLargest();
    void nameBodies();
    void dress();
    void refresh();
    void refreshNow();
    bool isSeen() const { return isVisible() && !m_isCovered; }
    void watch();

    Session &m_session;
    const Theme &m_theme;
    DifferenceCourse m_course;
    PanelTitle *m_title;
    DifferencePlot *m_plot;
    PlotExport *m_export;
    QLabel *m_sentence = nullptr;
    QToolButton *m_farthest = nullptr;
    QToolButton *m_selected = nullptr;
    QToolButton *m_runsButton = nullptr;
    QToolButton *m_go = nullptr;
    RunsMenu *m_runs;
    QElapsedTimer m_sinceRefresh;
    QTimer m_later;
    bool m_isCovered = false;
};

}
