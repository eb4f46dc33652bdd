#pragma once

#include "app/model/analysis/accuracy_study.h"
#include "app/ui/theme/theme.h"

#include <QWidget>

class QButtonGroup;
class QLabel;
class QPushButton;
class QScrollArea;
class QStackedWidget;

namespace app {

class PanelTitle;
class PlotExport;
class ProgressLine;
class RunPlot;
class WorkPrecisionPlot;

/// The panel of accuracy against time in the open scene: three plots of one study, and their result in words.
class AccuracyPanel : public QWidget
{
    Q_OBJECT

public:
    AccuracyPanel(AccuracyStudy &study, const Preview &preview, const Theme &theme,
                  QWidget *parent = nullptr);

    enum View { errorAgainstTime, overTheRun, order };
    void setView(View view);
    View view() const;
    WorkPrecisionPlot &workPrecision() const { return *m_workPrecision; }
    RunPlot &run() const { return *m_overTheRun; }
    /// Returns whether the plots show all methods, with all remarks. Otherwise they show three, for a beginner. The
    /// choice is stored.
    bool showsAll() const { return m_showsAll; }
    void setShowsAll(bool all);
    static constexpr const char *showsAllKey = "measure/allMethods"; ///< of the settings
    /// Returns the export of the visible plot.
    PlotExport &exports() const { return *m_export; }
    /// Returns the text of the card without markup.
    QString verdict() const;
    QString remarks() const;

    QSize sizeHint() const override { return {560, 520}; }
    QSize minimumSizeHint() const override { return {420, 360}; }

signals:
    /// Emitted when the pointer is at a frame of the plot over the run, or has left.
    void pointedAt(std::optional<std::int64_t> frame);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *tabs();
    QWidget *stateRow();
    /// Returns a button that shows all methods, or fewer.
    QPushButton *choiceButton(const char *name, const QString &text, const QString &tip, bool all);
    QWidget *card(const Theme &theme);
    void refresh();
    void makeRemarks();
    void chooseMethods();
    QString captionOf(const sim::Accuracy &accuracy) const;
    void fitRemarks();
    void refreshState();
    void refreshCard();
    void measureOrCancel();
    void useCheapest();
    const sim::AccuracyRow *cheapest() const;

    AccuracyStudy &m_study;
    PanelTitle *m_title;
    PlotExport *m_export;
    QLabel *m_unstable;
    QStackedWidget *m_views;
    WorkPrecisionPlot *m_workPrecision;
    RunPlot *m_overTheRun;
    QButtonGroup *m_tabs = nullptr;
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
    QScrollArea *m_remarksArea; ///< shrinks where there is little room
};

}
