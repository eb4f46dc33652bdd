#include "app/ui/effects/effect_list.h"

#include "app/ui/effects/kind_mark.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace app {

namespace {

constexpr int listedHeight = 32;
constexpr int absentHeight = 27;
constexpr int margin = 16;
constexpr double markSize = 11.0;
constexpr double barHeight = 7.0;
constexpr double switchWidth = 30.0;
constexpr double switchHeight = 18.0;
constexpr double roomForPoints = 520.0; ///< px, of the list
constexpr double roomForSpread = 500.0;

struct Head
{
    double left;
    double right;
    Qt::Alignment side;
    QString title;
    QString help;
};

std::vector<Head> headsFor(double width)
{
    const EffectColumns c(width);
    std::vector<Head> heads = {
        {c.name, c.name + c.nameWidth, Qt::AlignLeft, EffectHeads::tr("Effect"),
         EffectHeads::tr("The effects of this scene, in the order in which they run.")},
        {c.frameRight - 74.0, c.frameRight, Qt::AlignRight, EffectHeads::tr("µs a frame"),
         EffectHeads::tr("Microseconds (millionths of a second) that each frame of the run spends on it. "
                         "About half of the measurements are within the ±.")},
        {c.pointRight - 64.0, c.pointRight, Qt::AlignRight, EffectHeads::tr("µs a point"),
         EffectHeads::tr("The same for each point that it acts on.")},
        {c.runsRight - 40.0, c.runsRight, Qt::AlignRight, EffectHeads::tr("runs"),
         EffectHeads::tr("How often a frame computes it. Some methods compute it several times.")},
    };
    if (c.hasPoints)
        heads.push_back({c.pointsRight - 50.0, c.pointsRight, Qt::AlignRight, EffectHeads::tr("points"),
                         EffectHeads::tr("How many points it acts on.")});
    return heads;
}

}

EffectColumns::EffectColumns(double width)
    : hasSpread(width >= roomForSpread), hasPoints(width >= roomForPoints)
{
    toggle = width - margin - switchWidth;
    runsRight = toggle - 14.0;
    pointsRight = runsRight - 52.0;
    pointRight = hasPoints ? pointsRight - 58.0 : runsRight - 58.0;
    frameRight = pointRight - (hasSpread ? 132.0 : 80.0);
    name = margin + markSize + 9.0;
    const double room = frameRight - 62.0 - name; // for name and bar
    nameWidth = std::clamp(room * 0.55, 112.0, 128.0);
    bar = name + nameWidth + 8.0;
    barWidth = std::max(0.0, name + room - bar);
}

QVariant EffectListModel::data(const QModelIndex &index, int role) const
{
    if (role != Qt::CheckStateRole || !index.isValid())
        return LedgerModel::data(index, role);
    return line(index).isListed() ? QVariant(line(index).isOn() ? Qt::Checked : Qt::Unchecked) : QVariant();
}

bool EffectListModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role != Qt::CheckStateRole || !index.isValid() || !line(index).isListed())
        return false;
    emit switched(line(index).id, value.toInt() == Qt::Checked);
    return true;
}

Qt::ItemFlags EffectListModel::flags(const QModelIndex &index) const
{
    if (!index.isValid())
        return Qt::NoItemFlags;
    const Qt::ItemFlags seen = Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemNeverHasChildren;
    return line(index).isListed() ? seen | Qt::ItemIsUserCheckable : seen;
}

QSize EffectDelegate::sizeHint(const QStyleOptionViewItem &, const QModelIndex &index) const
{
    const auto line = index.data(lineRole).value<EffectLine>();
    return {200, line.role == EffectRole::absent ? absentHeight : listedHeight};
}

QRect EffectDelegate::switchRect(const QRect &row)
{
    const double left = row.left() + EffectColumns(row.width()).toggle;
    return QRectF(left, row.top() + (row.height() - switchHeight) / 2.0, switchWidth, switchHeight).toRect();
}

bool EffectDelegate::editorEvent(QEvent *event, QAbstractItemModel *model, const QStyleOptionViewItem &option,
                                 const QModelIndex &index)
{
    const QVariant checked = index.data(Qt::CheckStateRole);
    if (!checked.isValid())
        return false;
    const bool isKey =
        event->type() == QEvent::KeyPress && static_cast<QKeyEvent *>(event)->key() == Qt::Key_Space;
    bool isClick = false;
    if (event->type() == QEvent::MouseButtonRelease) {
        const auto *mouse = static_cast<QMouseEvent *>(event);
        isClick = mouse->button() == Qt::LeftButton &&
                  switchRect(option.rect).adjusted(-8, -7, 8, 7).contains(mouse->position().toPoint());
    }
    if (!isKey && !isClick)
        return false;
    return model->setData(index, checked.toInt() == Qt::Checked ? Qt::Unchecked : Qt::Checked,
                          Qt::CheckStateRole);
}

void EffectDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                           const QModelIndex &index) const
{
    const auto line = index.data(lineRole).value<EffectLine>();
    const Tokens &t = m_theme.tokens();
    const QRectF row = option.rect;
    const EffectColumns columns(row.width());
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const bool isChosen = paintLedgerRow(*painter, option, m_theme);
    const QRectF mark(row.x() + margin, row.center().y() - markSize / 2.0, markSize, markSize);
    const bool isThere = line.role == EffectRole::acts;
    drawKindMark(*painter, mark, line.kind, isThere ? MarkFill::solid : MarkFill::hollow, m_theme);
    painter->setFont(m_theme.ui(13));
    painter->setPen(line.isOn() || line.role == EffectRole::rest ? t.ink : isChosen ? t.ink2 : t.ink3);
    const bool hasBar = line.ns > 0.0;
    const double nameWidth = hasBar ? columns.nameWidth : columns.frameRight - 30.0 - columns.name;
    const QRectF name(row.x() + columns.name, row.y(), nameWidth, row.height());
    painter->drawText(
        name, Qt::AlignLeft | Qt::AlignVCenter,
        painter->fontMetrics().elidedText(line.title, Qt::ElideRight, static_cast<int>(nameWidth)));
    if (hasBar)
        drawBar(*painter, row, line, index.data(shareRole).toDouble());
    drawFigures(*painter, row, line);
    if (line.role != EffectRole::rest)
        drawSwitch(*painter, switchRect(option.rect), line);
    painter->restore();
}

void EffectDelegate::drawBar(QPainter &painter, const QRectF &row, const EffectLine &line, double share) const
{
    const EffectColumns columns(row.width());
    const double length = std::max(2.0, columns.barWidth * share);
    const QRectF bar(row.x() + columns.bar, row.center().y() - barHeight / 2.0, length, barHeight);
    painter.setPen(Qt::NoPen);
    painter.setBrush(line.role == EffectRole::rest ? m_theme.tokens().line2 : m_theme.kindColor(line.kind));
    painter.drawRoundedRect(bar, 1.5, 1.5);
}

void EffectDelegate::drawFigures(QPainter &painter, const QRectF &row, const EffectLine &line) const
{
    const EffectColumns columns(row.width());
    const Tokens &t = m_theme.tokens();
    const auto put = [&](double right, const QString &text) {
        painter.drawText(QRectF(row.x() + right - 140.0, row.y(), 140.0, row.height()),
                         Qt::AlignRight | Qt::AlignVCenter, text);
    };
    const bool isPale =
        line.role == EffectRole::absent || line.role == EffectRole::off || line.role == EffectRole::offered;
    painter.setFont(m_theme.mono(12));
    painter.setPen(isPale ? t.ink3 : t.ink);
    put(columns.frameRight, line.frame);
    painter.setPen(t.ink2);
    put(columns.pointRight, line.point);
    put(columns.runsRight, line.runs);
    if (columns.hasPoints)
        put(columns.pointsRight, line.points);
    if (columns.hasSpread) {
        painter.setPen(t.ink3);
        painter.drawText(QRectF(row.x() + columns.frameRight + 6.0, row.y(), 60.0, row.height()),
                         Qt::AlignLeft | Qt::AlignVCenter, line.spread);
    }
    painter.setFont(m_theme.ui(12));
    painter.setPen(t.ink3);
    put(columns.runsRight, line.note);
}

void EffectDelegate::drawSwitch(QPainter &painter, const QRectF &box, const EffectLine &line) const
{
    const Tokens &t = m_theme.tokens();
    const bool isOn = line.isOn();
    if (!line.isListed())
        painter.setOpacity(0.45);
    painter.setPen(Qt::NoPen);
    painter.setBrush(isOn ? t.ink2 : t.ctl);
    painter.drawRoundedRect(box, box.height() / 2.0, box.height() / 2.0);
    const double knob = box.height() - 4.0;
    const double left = isOn ? box.right() - knob - 2.0 : box.left() + 2.0;
    painter.setBrush(t.panel);
    painter.drawEllipse(QRectF(left, box.top() + 2.0, knob, knob));
    painter.setOpacity(1.0);
}

EffectList::EffectList(const Theme &theme, QWidget *parent) : EffectList(new EffectListModel, theme, parent)
{
}

EffectList::EffectList(EffectListModel *model, const Theme &theme, QWidget *parent)
    : LedgerList(model, new EffectDelegate(theme), parent), m_model(model)
{
    setAccessibleName(tr("The effects of the scene and their costs"));
    connect(this, &QListView::entered, this, &EffectList::currentChangedTo);
    connect(m_model, &QAbstractItemModel::layoutChanged, this, &EffectList::showWholeRows);
}

void EffectList::resizeEvent(QResizeEvent *event)
{
    QListView::resizeEvent(event);
    showWholeRows();
}

void EffectList::showWholeRows()
{
    const int room = contentsRect().height();
    int whole = 0;
    for (int row = 0; row < m_model->rowCount() && whole + sizeHintForRow(row) <= room; ++row)
        whole += sizeHintForRow(row);
    const QMargins spare(0, 0, 0, whole > 0 ? room - whole : 0);
    if (viewportMargins() != spare)
        setViewportMargins(spare);
}

void EffectList::currentChanged(const QModelIndex &current, const QModelIndex &previous)
{
    QListView::currentChanged(current, previous);
    emit currentChangedTo();
}

const EffectLine *EffectList::current() const
{
    const QModelIndex under =
        viewport()->underMouse() ? indexAt(viewport()->mapFromGlobal(QCursor::pos())) : QModelIndex();
    const QModelIndex index = under.isValid() ? under : currentIndex();
    return index.isValid() ? &m_model->line(index) : nullptr;
}

EffectHeads::EffectHeads(const Theme &theme, const EffectList &list, QWidget *parent)
    : QWidget(parent), m_theme(theme), m_list(list)
{
    setFixedHeight(headHeight);
}

void EffectHeads::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setFont(m_theme.ui(12));
    painter.setPen(m_theme.tokens().ink3);
    for (const Head &head : headsFor(m_list.viewport()->width())) {
        const QRectF box(head.left, 0.0, head.right - head.left, height());
        painter.drawText(box, int(head.side | Qt::AlignVCenter | Qt::TextDontClip), head.title);
    }
}

bool EffectHeads::event(QEvent *event)
{
    if (event->type() != QEvent::ToolTip)
        return QWidget::event(event);
    const auto *help = static_cast<QHelpEvent *>(event);
    for (const Head &head : headsFor(m_list.viewport()->width())) {
        if (help->pos().x() >= head.left && help->pos().x() <= head.right) {
            QToolTip::showText(help->globalPos(), head.help, this);
            return true;
        }
    }
    QToolTip::hideText();
    return true;
}

}
