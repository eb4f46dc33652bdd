#pragma once

#include "app/model/session.h"
#include "app/ui/theme/theme.h"

#include <QElapsedTimer>
#include <QWidget>

#include <vector>

class QScrollArea;
class QToolButton;
class QVBoxLayout;

namespace app {

class ParameterRow;

/// The parameters of the open step, under a title of their own: four, and the rest when there is room or the
/// learner asks.
class ParameterPanel : public QWidget
{
    Q_OBJECT

public:
    ParameterPanel(Session &session, const Theme &theme, QWidget *parent = nullptr);

    /// The height that shows what is unfolded, with the title.
    QSize sizeHint() const override;
    /// The height from which every parameter is shown unasked.
    int fullHeight() const;
    QSize minimumSizeHint() const override;

signals:
    /// sizeHint().height() is another.
    void wantedHeightChanged(int height);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    QWidget *makeTitle();
    void makeDisclosure();
    void open();
    void addRows();
    void alignColumns();
    void refresh();
    void refreshNow();
    void unfold(bool all);
    void unfoldIfRoom();
    int heightOf(std::size_t rows, bool disclosure) const;
    void dress();

    Session &m_session;
    const Theme &m_theme;
    QToolButton *m_resetAll = nullptr;
    QScrollArea *m_area = nullptr;
    QVBoxLayout *m_column = nullptr;
    QToolButton *m_more = nullptr;
    std::vector<ParameterRow *> m_rows;
    QElapsedTimer m_sinceRefresh;
    bool m_placed = false; ///< whether it was given a size
    bool m_unfolded = false;
    bool m_chosen = false; ///< whether the learner folded or unfolded the rest
};

}
