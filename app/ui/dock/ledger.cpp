#include "app/ui/dock/ledger.h"

#include <QPainter>

namespace app {

LedgerList::LedgerList(QAbstractItemModel *model, QStyledItemDelegate *delegate, QWidget *parent)
    : QListView(parent)
{
    setObjectName("ledger");
    setFocusPolicy(Qt::TabFocus); // after a click, the keys of time still work
    model->setParent(this);
    delegate->setParent(this);
    setModel(model);
    setItemDelegate(delegate);
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setMouseTracking(true);
}

bool paintLedgerRow(QPainter &painter, const QStyleOptionViewItem &option, const Theme &theme)
{
    const bool isChosen = (option.state & QStyle::State_HasFocus) && (option.state & QStyle::State_Selected);
    if (isChosen || (option.state & QStyle::State_MouseOver))
        theme.paintSurface(painter, QRectF(option.rect).adjusted(4, 1, -4, -1), 6,
                           isChosen ? Surface::chosen : Surface::hovered);
    return isChosen;
}

}
