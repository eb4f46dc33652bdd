#pragma once

#include "app/model/session.h"
#include "app/ui/theme/theme.h"

#include <QTreeView>

namespace app {

class LessonModel;

/// The lessons, and the steps of the open one. A click or Enter opens; the arrow keys move without opening.
class LessonList : public QTreeView
{
    Q_OBJECT

public:
    LessonList(Session &session, const Theme &theme, QWidget *parent = nullptr);

    LessonModel &lessons() const { return *m_model; }
    /// Marks the summary of the open lesson, or its open step again.
    void markSummary(bool shown);
    /// The height of all rows.
    int contentHeight() const;
    /// The height of the open lesson with its steps.
    int openLessonHeight() const;
    /// Scrolls so that the open step is seen, and the whole open lesson if there is room.
    void showOpen();
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// contentHeight() is another: other steps are shown.
    void contentHeightChanged();

protected:
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    bool viewportEvent(QEvent *event) override;
    void initViewItemOption(QStyleOptionViewItem *option) const override;
    void drawBranches(QPainter *painter, const QRect &rect, const QModelIndex &index) const override;

private:
    void follow();
    void openRow(const QModelIndex &index);

    LessonModel *m_model;
    bool m_byKeyboard = false; ///< whether the ring round the current row is shown
};

}
