#pragma once

#include "app/model/session/session.h"
#include "app/ui/theme/theme.h"

#include <QTreeView>

namespace app {

class LessonModel;

/// A tree view of the lessons and the steps of the open lesson. A click or Enter opens a row; the arrow keys
/// move without opening. The title of the open lesson stays at the top while its steps are scrolled.
class LessonList : public QTreeView
{
    Q_OBJECT

public:
    LessonList(Session &session, const Theme &theme, QWidget *parent = nullptr);

    LessonModel &lessons() const { return *m_model; }
    /// Highlights the summary of the open lesson, or the open step again.
    void markSummary(bool shown);
    /// Returns the height of all rows, px.
    int contentHeight() const;
    /// Returns the height of the open lesson and its steps, px.
    int openLessonHeight() const;
    /// Scrolls to the open step. Shows the whole open lesson if there is room.
    void showOpen();
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    /// Returns the open lesson where its title covers a step.
    QModelIndex indexAt(const QPoint &place) const override;
    void scrollTo(const QModelIndex &index, ScrollHint hint = EnsureVisible) override;

signals:
    /// Emitted when contentHeight() changes.
    void contentHeightChanged();

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void scrollContentsBy(int dx, int dy) override;
    bool viewportEvent(QEvent *event) override;
    void initViewItemOption(QStyleOptionViewItem *option) const override;
    void drawBranches(QPainter *painter, const QRect &rect, const QModelIndex &index) const override;

private:
    void follow();
    void openRow(const QModelIndex &index);
    /// Returns whether the title of the open lesson is painted over the top row.
    bool hasStuckTitle() const;

    const Theme &m_theme;
    LessonModel *m_model;
    bool m_byKeyboard = false; ///< whether the current row has a focus ring
};

}
