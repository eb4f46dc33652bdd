#pragma once

#include "app/model/plot_course.h"
#include "app/model/plot_list.h"
#include "app/ui/theme/theme.h"

#include <QTimer>
#include <QWidget>

#include <vector>

class QLabel;
class QScrollArea;
class QStackedWidget;
class QVBoxLayout;

namespace app {

class FlatButton;
class NumberTable;
class PanelTitle;
class PlotCard;
class PlotExport;
class ProgressLine;

/// The plots of a learner, one below the other, with one time. Reads the run only while it is seen.
class PlotsPanel : public QWidget
{
    Q_OBJECT

public:
    PlotsPanel(Session &session, const Theme &theme, QWidget *parent = nullptr);

    const std::vector<PlotCard *> &cards() const { return m_cards; }
    PlotList &list() { return m_list; }
    PlotCourse &course() { return m_course; }
    /// Whether all that is computed of what is shown is drawn.
    bool isSettled() const { return !m_course.isReading() && !m_isDue; }
    /// The button that adds plots.
    FlatButton &addButton() const { return *m_add; }
    /// Adds a plot as the button's menu does.
    void add(const PlotSpec &plot);

    /// While another tab covers it, it reads and draws nothing.
    void setCovered(bool covered);
    bool isCovered() const { return m_isCovered; }

    /// The second cursor of all plots: where the mouse points in one of them, or elsewhere.
    void setHovered(std::optional<std::int64_t> frame);

    /// The curves of this body are drawn thicker; of none if it is empty.
    void setPointedBody(const QString &body);

    /// Room for the first two plots: the others are scrolled to.
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {260, 170}; }

signals:
    void said(const QString &sentence);
    void failed(const QString &sentence);
    void wantedHeightChanged();
    /// The mouse is at a frame of a plot, or has left.
    void pointedAt(std::optional<std::int64_t> frame);

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    QMenu *addMenu();
    QWidget *emptyPage();
    QWidget *saving();
    void fillAddMenu(QMenu &menu);
    void open();
    void rebuild();
    PlotCard *makeCard();
    void removeCard(PlotCard &card);
    /// Takes it away, and leaves off what it is writing.
    void letGo(PlotCard &card);
    std::size_t indexOf(const PlotCard &card) const;
    void refreshSoon();
    void followGlance();
    void watch();
    void refresh();
    void zoom(int steps);
    void writeCaption();
    void showSaving();
    NumberTable *table() const;

    Session &m_session;
    const Theme &m_theme;
    PlotCourse m_course;
    PlotList m_list;
    PanelTitle *m_title;
    FlatButton *m_add;
    QStackedWidget *m_pages;
    QScrollArea *m_scroll = nullptr;
    QVBoxLayout *m_column = nullptr;
    std::vector<PlotCard *> m_cards;
    QWidget *m_saving = nullptr;
    ProgressLine *m_progress = nullptr;
    bool m_isCovered = false;
    bool m_isDue = false;       ///< all that changes together is drawn together
    bool m_looksInside = false; ///< whether somebody looks at a moment inside a frame
    int m_wantedHeight = 0;     ///< px
    QTimer m_patience;          ///< what takes longer shows how far it is
};

}
