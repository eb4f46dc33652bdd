#include "app/ui/effects/effect_list.h"

#include "app/ui/effects/kind_mark.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

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

void EffectListModel::setLines(std::vector<EffectLine> lines)
{
    m_longest = 0.0;
    for (const EffectLine &line : lines)
        m_longest = std::max(m_longest, line.ns);
    const bool sameRows =
        lines.size() == m_lines.size() &&
        std::equal(lines.begin(), lines.end(), m_lines.begin(),
                   [](const EffectLine &a, const EffectLine &b) { return a.id == b.id && a.role == b.role; });
    if (sameRows) {
        m_lines = std::move(lines);
        if (!m_lines.empty())
            emit dataChanged(index(0), index(rowCount() - 1));
        return;
    }
    // Whoever switches one line after the other stays where he is.
    emit layoutAboutToBeChanged();
    const QModelIndexList kept = persistentIndexList();
    QModelIndexList moved;
    for (const QModelIndex &one : kept) {
        const QString &id = m_lines[static_cast<std::size_t>(one.row())].id;
        const auto found =
            std::find_if(lines.begin(), lines.end(), [&](const EffectLine &line) { return line.id == id; });
        moved << (found == lines.end() ? QModelIndex()
                                       : createIndex(static_cast<int>(found - lines.begin()), 0));
    }
    m_lines = std::move(lines);
    changePersistentIndexList(kept, moved);
    emit layoutChanged();
}

int EffectListModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

QVariant EffectListModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const EffectLine &its = line(index);
    switch (role) {
    case Qt::DisplayRole:
        return its.title;
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
        return its.help;
    case Qt::AccessibleTextRole:
        return its.spoken();
    case Qt::CheckStateRole:
        return its.isListed() ? QVariant(its.isOn() ? Qt::Checked : Qt::Unchecked) : QVariant();
    default:
        return {};
    }
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
    const auto *model = static_cast<const EffectListModel *>(index.model());
    return {200, model->line(index).role == EffectRole::absent ? absentHeight : listedHeight};
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
    const auto *model = static_cast<const EffectListModel *>(index.model());
    const EffectLine &line = model->line(index);
    const Tokens &t = m_theme.tokens();
    const QRectF row = option.rect;
    const EffectColumns columns(row.width());
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const bool chosen = (option.state & QStyle::State_HasFocus) && (option.state & QStyle::State_Selected);
    if (chosen || (option.state & QStyle::State_MouseOver))
        m_theme.paintSurface(*painter, row.adjusted(4, 1, -4, -1), 6,
                             chosen ? Surface::chosen : Surface::hovered);
    const QRectF mark(row.x() + margin, row.center().y() - markSize / 2.0, markSize, markSize);
    const bool isThere = line.role == EffectRole::acts;
    drawKindMark(*painter, mark, line.kind, isThere ? MarkFill::solid : MarkFill::hollow, m_theme);
    painter->setFont(m_theme.ui(13));
    painter->setPen(line.isOn() || line.role == EffectRole::rest ? t.ink : chosen ? t.ink2 : t.ink3);
    const bool hasBar = line.ns > 0.0;
    const double nameWidth = hasBar ? columns.nameWidth : columns.frameRight - 30.0 - columns.name;
    const QRectF name(row.x() + columns.name, row.y(), nameWidth, row.height());
    painter->drawText(
        name, Qt::AlignLeft | Qt::AlignVCenter,
        painter->fontMetrics().elidedText(line.title, Qt::ElideRight, static_cast<int>(nameWidth)));
    if (hasBar)
        drawBar(*painter, row, line, model->longest());
    drawFigures(*painter, row, line);
    if (line.role != EffectRole::rest)
        drawSwitch(*painter, switchRect(option.rect), line);
    painter->restore();
}

void EffectDelegate::drawBar(QPainter &painter, const QRectF &row, const EffectLine &line,
                             double longest) const
{
    const EffectColumns columns(row.width());
    const double length = std::max(2.0, columns.barWidth * line.ns / longest);
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

EffectList::EffectList(const Theme &theme, QWidget *parent)
    : QListView(parent), m_model(new EffectListModel(this))
{
    setObjectName("ledger");
    setAccessibleName(tr("The effects of the scene, and what each costs"));
    setModel(m_model);
    setItemDelegate(new EffectDelegate(theme, this));
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setMouseTracking(true);
    connect(this, &QListView::entered, this, &EffectList::currentChangedTo);
    connect(m_model, &QAbstractItemModel::layoutChanged, this, &EffectList::showWholeRows);
    connect(&theme, &Theme::changed, viewport(), qOverload<>(&QWidget::update));
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

}
