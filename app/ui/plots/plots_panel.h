#pragma once

#include "app/model/series/plot_list.h"
#include "app/model/series/plot_series.h"
#include "app/ui/dock/live_panel.h"
#include "app/ui/theme/theme.h"

class QScrollArea;
class QStackedWidget;
class QVBoxLayout;

namespace app {

class ComparisonRuns;
class FlatButton;
class NumberTable;
class PanelTitle;
class Playback;
class PlotCard;
class Preview;
class ProgressLine;

/// The panel of the learner's plots, one below the other, with one time.
class PlotsPanel : public LivePanel
{
    Q_OBJECT

public:
    /// All arguments must outlive it.
    PlotsPanel(const OpenRun &run, Playback &playback, const Preview &preview,
               const ComparisonRuns &comparisons, const Theme &theme, QWidget *parent = nullptr);

    const std::vector<PlotCard *> &cards() const { return m_cards; }
    PlotList &list() { return m_list; }
    PlotSeries &series() { return m_series; }
    /// Returns whether all computed frames that the plots show are drawn.
    bool isSettled() const { return !m_series.isReading() && !m_isDue; }
    /// Returns the button that adds plots.
    FlatButton &addButton() const { return *m_add; }
    /// Adds a plot as the button's menu does.
    void add(const PlotSpec &plot);

    /// Moves the second cursor of all plots to where the pointer is, in one of them or elsewhere.
    void setHovered(std::optional<std::int64_t> frame);

    /// Draws the curves of a body thicker; of none if `body` is empty.
    void setPointedBody(const QString &body);

    /// Returns room for the first two plots; the learner scrolls to the others.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {260, 170}; }

signals:
    void failed(const QString &sentence);
    void wantedHeightChanged();
    /// Emitted when the pointer is at a frame of a plot, or has left.
    void pointedAt(std::optional<std::int64_t> frame);

protected:
    void setActive(bool isActive) override;
    bool isChanging() const override { return false; }
    void showContents() override;

private:
    QMenu *addMenu();
    QWidget *emptyPage();
    QWidget *saving();
    void fillAddMenu(QMenu &menu);
    void open();
    void rebuild();
    PlotCard *makeCard();
    void removeCard(PlotCard &card);
    /// Removes a card, and cancels its export.
    void discard(PlotCard &card);
    std::size_t indexOf(const PlotCard &card) const;
    void refreshSoon();
    void followPreview();
    void zoom(int steps);
    void writeCaption();
    void showSaving();
    NumberTable *table() const;

    const OpenRun &m_run;
    Playback &m_playback;
    const Preview &m_preview;
    const ComparisonRuns &m_comparisons;
    const Theme &m_theme;
    PlotSeries m_series;
    PlotList m_list;
    PanelTitle *m_title;
    FlatButton *m_add;
    QStackedWidget *m_pages;
    QScrollArea *m_scroll = nullptr;
    QVBoxLayout *m_column = nullptr;
    std::vector<PlotCard *> m_cards;
    QWidget *m_saving = nullptr;
    ProgressLine *m_progress = nullptr;
    bool m_isDue = false;          ///< a refresh is queued
    bool m_previewsInside = false; ///< whether the preview is inside a frame
    int m_wantedHeight = 0;        ///< px
    QTimer m_patience;             ///< an export that takes longer shows its progress
};

}
