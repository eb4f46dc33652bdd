#pragma once

#include "app/model/accuracy_study.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QScrollArea;
class QStackedWidget;
class QToolButton;

namespace app {

class OrderPlot;
class PanelTitle;
class PlotExport;
class ProgressLine;
class RunPlot;
class WorkPrecisionPlot;

/// What accuracy costs in time on the scene that is open: three plots of one study, and what they say in words.
class AccuracyPanel : public QWidget
{
    Q_OBJECT

public:
    AccuracyPanel(AccuracyStudy &study, const Theme &theme, QWidget *parent = nullptr);

    enum View { errorAgainstTime, overTheRun, order };
    void setView(View view);
    View view() const;
    WorkPrecisionPlot &workPrecision() const { return *m_workPrecision; }
    RunPlot &run() const { return *m_overTheRun; }
    /// Whether the plots show all methods, with all remarks: else three of them, for a beginner. What a learner chooses is
    /// remembered.
    bool showsAll() const { return m_showsAll; }
    void setShowsAll(bool all);
    static constexpr const char *showsAllKey = "measure/allMethods"; ///< of the settings
    /// Of the plot that is seen.
    PlotExport &exports() const { return *m_export; }
    /// What the card says, without its marks.
    QString verdict() const;
    QString remarks() const;

    QSize sizeHint() const override { return {560, 520}; }
    QSize minimumSizeHint() const override { return {420, 360}; }

signals:
    /// The mouse is at a frame of the plot over the run, or has left.
    void pointedAt(std::optional<std::int64_t> frame);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *tabs();
    QWidget *stateRow();
    /// A button that shows all methods, or fewer.
    QPushButton *choiceButton(const char *name, const QString &text, const QString &tip, bool all);
    QWidget *card();
    void refresh();
    void makeRemarks();
    void chooseMethods();
    QString captionOf(const sim::Accuracy &accuracy) const;
    void fitRemarks();
    void refreshState();
    void refreshCard();
    void dress();
    void measureOrCancel();
    void useCheapest();
    const sim::AccuracyRow *cheapest() const;

    AccuracyStudy &m_study;
    const Theme &m_theme;
    PanelTitle *m_title;
    PlotExport *m_export;
    QLabel *m_unstable;
    QStackedWidget *m_views;
    WorkPrecisionPlot *m_workPrecision;
    RunPlot *m_overTheRun;
    std::vector<QToolButton *> m_tabs;
    QLabel *m_state;
    bool m_showsAll = false;
    QWidget *m_tabRow;
    QWidget *m_stateRow = nullptr;
    QPushButton *m_all;
    QPushButton *m_fewer = nullptr;
    ProgressLine *m_progress;
    QPushButton *m_measure;
    QLabel *m_verdict;
    QPushButton *m_use;
    QLabel *m_remarks;
    QScrollArea *m_remarksArea; ///< gives way where there is little room
};

}
