#include "app/ui/learn/lessons/lesson_list.h"

#include "app/ui/learn/lessons/lesson_delegate.h"
#include "app/ui/learn/lessons/lesson_model.h"
#include "app/ui/theme/focus_ring.h"

#include <QHeaderView>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <QToolTip>

namespace app {

LessonList::LessonList(Session &session, const Theme &theme, QWidget *parent)
    : QTreeView(parent), m_theme(theme), m_model(new LessonModel(session, this))
{
    setModel(m_model);
    setItemDelegate(new LessonDelegate(theme, this));
    setAccessibleName(tr("Lessons"));
    setFocusPolicy(Qt::TabFocus); // after a click, the keys of time still work
    setHeaderHidden(true);
    header()->setMinimumSectionSize(1);
    header()->setStretchLastSection(false); // a hidden header would keep the old width of its section
    setRootIsDecorated(false);
    setIndentation(0);
    setExpandsOnDoubleClick(false);
    setItemsExpandable(false);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setSelectionMode(QAbstractItemView::NoSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setMouseTracking(true);
    connect(this, &QTreeView::clicked, this, &LessonList::openRow);
    session.onChange(ChangeKind::step, this, &LessonList::follow);
    connect(m_model, &QAbstractItemModel::modelReset, this, &LessonList::follow);
    follow();
}

void LessonList::follow()
{
    const QModelIndex open = m_model->openLesson();
    for (int i = 0; i < m_model->rowCount(); ++i)
        setExpanded(m_model->index(i, 0), i == open.row());
    setCurrentIndex(m_model->openRow());
    updateGeometry();
    emit contentHeightChanged();
    showOpen();
}

void LessonList::showOpen()
{
    const QModelIndex lesson = m_model->openLesson();
    if (!lesson.isValid())
        return;
    if (openLessonHeight() <= viewport()->height()) {
        scrollTo(m_model->index(m_model->rowCount(lesson) - 1, 0, lesson));
        scrollTo(lesson);
    } else {
        scrollTo(lesson, QAbstractItemView::PositionAtTop);
        scrollTo(m_model->openRow());
    }
}

bool LessonList::hasStuckTitle() const
{
    const QModelIndex lesson = m_model->openLesson();
    const int steps = lesson.isValid() ? m_model->rowCount(lesson) : 0;
    return steps > 0 && visualRect(lesson).top() < 0 &&
           visualRect(m_model->index(steps - 1, 0, lesson)).bottom() >= LessonDelegate::lessonHeight;
}

QModelIndex LessonList::indexAt(const QPoint &place) const
{
    const bool isOnTitle = place.y() >= 0 && place.y() < LessonDelegate::lessonHeight && hasStuckTitle();
    return isOnTitle ? m_model->openLesson() : QTreeView::indexAt(place);
}

void LessonList::scrollTo(const QModelIndex &index, ScrollHint hint)
{
    QTreeView::scrollTo(index, hint);
    QScrollBar &bar = *verticalScrollBar();
    if (visualRect(index).bottom() == viewport()->height())
        bar.setValue(bar.value() + 1); // Qt leaves the last line of px outside
    const int covered = LessonDelegate::lessonHeight - visualRect(index).top();
    if (covered > 0 && index.parent().isValid() && hasStuckTitle())
        bar.setValue(bar.value() - covered);
}

void LessonList::markSummary(bool shown)
{
    m_model->setSummaryShown(shown);
    setCurrentIndex(m_model->openRow());
    showOpen();
}

void LessonList::openRow(const QModelIndex &index)
{
    m_model->open(index);
    if (index == m_model->openLesson())
        setCurrentIndex(m_model->openRow());
}

int LessonList::contentHeight() const
{
    return (m_model->rowCount() - 1) * LessonDelegate::lessonHeight + openLessonHeight();
}

int LessonList::openLessonHeight() const
{
    const QModelIndex lesson = m_model->openLesson();
    const int rows = lesson.isValid() ? m_model->rowCount(lesson) : 0;
    return LessonDelegate::lessonHeight + rows * LessonDelegate::stepHeight;
}

QSize LessonList::sizeHint() const
{
    return {280, contentHeight()};
}

QSize LessonList::minimumSizeHint() const
{
    return {LessonDelegate::markRow, LessonDelegate::lessonHeight + LessonDelegate::stepHeight};
}

void LessonList::keyPressEvent(QKeyEvent *event)
{
    m_byKeyboard = true;
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        openRow(currentIndex());
        event->accept();
        return;
    }
    QTreeView::keyPressEvent(event);
}

void LessonList::focusInEvent(QFocusEvent *event)
{
    m_byKeyboard = isByKeyboard(event->reason());
    QTreeView::focusInEvent(event);
}

void LessonList::mousePressEvent(QMouseEvent *event)
{
    m_byKeyboard = false;
    QTreeView::mousePressEvent(event);
}

void LessonList::resizeEvent(QResizeEvent *event)
{
    QTreeView::resizeEvent(event);
    header()->resizeSection(0, viewport()->width());
    // The rows have moved away from under the pointer.
    QHoverEvent leave(QEvent::HoverLeave, QPointF(), QPointF(), QPointF());
    viewportEvent(&leave);
}

void LessonList::paintEvent(QPaintEvent *event)
{
    QTreeView::paintEvent(event);
    if (!hasStuckTitle())
        return;
    const QModelIndex lesson = m_model->openLesson();
    QStyleOptionViewItem option;
    initViewItemOption(&option);
    option.rect = QRect(0, 0, viewport()->width(), LessonDelegate::lessonHeight);
    option.state.setFlag(QStyle::State_HasFocus, hasFocus() && currentIndex() == lesson);
    QPainter painter(viewport());
    painter.fillRect(option.rect, m_theme.tokens().panel);
    itemDelegate()->paint(&painter, option, lesson);
}

void LessonList::scrollContentsBy(int dx, int dy)
{
    QTreeView::scrollContentsBy(dx, dy);
    viewport()->update(); // Qt moves the pixels of the title, too
}

bool LessonList::viewportEvent(QEvent *event)
{
    if (event->type() != QEvent::ToolTip || viewport()->width() >= LessonDelegate::leastTextWidth)
        return QTreeView::viewportEvent(event);
    // The tooltip shows text that is cut off in the row.
    const auto &help = *static_cast<QHelpEvent *>(event);
    QToolTip::showText(help.globalPos(), indexAt(help.pos()).data(Qt::AccessibleTextRole).toString(),
                       viewport());
    return true;
}

void LessonList::initViewItemOption(QStyleOptionViewItem *option) const
{
    QTreeView::initViewItemOption(option);
    option->state.setFlag(QStyle::State_KeyboardFocusChange, m_byKeyboard);
}

void LessonList::drawBranches(QPainter *, const QRect &, const QModelIndex &) const
{
    // No arrows: only the open lesson shows its steps.
}

}
