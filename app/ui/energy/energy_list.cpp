#include "app/ui/energy/energy_list.h"

#include <QPainter>

#include <cmath>

namespace app {

namespace {

constexpr int markSize = 10;
constexpr int margin = 12;
constexpr int textLeft = margin + markSize + 9;
constexpr int barHeight = 3;

double amountOf(const EnergyLine &line)
{
    return std::hypot(line.amount, line.across);
}

}

QColor inkOf(const EnergyLine &line, const Theme &theme)
{
    if (line.role == EnergyRole::drift)
        return theme.tokens().past;
    return line.kind == sim::EffectKind::motion ? theme.tokens().ghost : theme.kindColor(line.kind);
}

QBrush driftBrush(const Theme &theme)
{
    return {theme.tokens().past, Qt::BDiagPattern};
}

void EnergyListModel::setLines(std::vector<EnergyLine> lines, const QString &unit)
{
    m_longest = 0.0;
    for (const EnergyLine &line : lines)
        m_longest = std::max(m_longest, amountOf(line));
    m_unit = unit;
    const bool sameRows = lines.size() == m_lines.size() &&
                          std::equal(lines.begin(), lines.end(), m_lines.begin(),
                                     [](const EnergyLine &a, const EnergyLine &b) { return a.id == b.id; });
    if (sameRows) {
        m_lines = std::move(lines);
        if (!m_lines.empty())
            emit dataChanged(index(0), index(rowCount() - 1));
        return;
    }
    beginResetModel();
    m_lines = std::move(lines);
    endResetModel();
}

int EnergyListModel::rowCount(const QModelIndex &parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
}

QVariant EnergyListModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const EnergyLine &line = m_lines[static_cast<std::size_t>(index.row())];
    if (role == Qt::DisplayRole)
        return line.title;
    if (role == Qt::ToolTipRole)
        return QStringLiteral("%1: %2\u2009%3\n%4").arg(line.title, line.number, m_unit, line.help);
    if (role == Qt::AccessibleTextRole)
        return QStringLiteral("%1: %2 %3").arg(line.title, line.number, m_unit);
    if (role == Qt::AccessibleDescriptionRole)
        return line.help;
    return {};
}

QSize EnergyDelegate::sizeHint(const QStyleOptionViewItem &, const QModelIndex &) const
{
    return {200, rowHeight};
}

void EnergyDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                           const QModelIndex &index) const
{
    const auto *model = static_cast<const EnergyListModel *>(index.model());
    const EnergyLine &line = model->lines()[static_cast<std::size_t>(index.row())];
    const Tokens &t = m_theme.tokens();
    const bool isDrift = line.role == EnergyRole::drift;
    const QColor ink = inkOf(line, m_theme);
    const QRectF row = option.rect;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const bool chosen = (option.state & QStyle::State_HasFocus) && (option.state & QStyle::State_Selected);
    if (chosen || (option.state & QStyle::State_MouseOver))
        m_theme.paintSurface(*painter, row.adjusted(4, 1, -4, -1), 6,
                             chosen ? Surface::chosen : Surface::hovered);
    const QRectF mark(row.x() + margin, row.y() + 5, markSize, markSize);
    painter->setPen(QPen(ink, 1.2));
    painter->setBrush(isDrift ? driftBrush(m_theme)
                              : QBrush(line.role == EnergyRole::held ? ink : Qt::transparent));
    painter->drawRoundedRect(mark, 2, 2);
    const QRectF text = row.adjusted(textLeft, 1, -margin, -(barHeight + 4));
    painter->setPen(line.amount == 0.0 && line.across == 0.0 ? t.ink3 : t.ink);
    painter->setFont(m_theme.mono(12));
    const double numberWidth = painter->fontMetrics().horizontalAdvance(line.number);
    painter->drawText(text, Qt::AlignRight | Qt::AlignVCenter, line.number);
    painter->setFont(m_theme.ui(13, isDrift ? QFont::DemiBold : QFont::Normal));
    painter->setPen(t.ink);
    const double room = text.width() - numberWidth - 8;
    painter->drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                      painter->fontMetrics().elidedText(line.title, Qt::ElideRight, static_cast<int>(room)));
    const double share = model->longest() > 0.0 ? amountOf(line) / model->longest() : 0.0;
    QRectF bar(text.left(), row.bottom() - barHeight - 3, text.width(), barHeight);
    painter->setPen(Qt::NoPen);
    painter->setBrush(t.track);
    painter->drawRoundedRect(bar, 1.5, 1.5);
    bar.setWidth(bar.width() * share);
    painter->setBrush(ink);
    painter->drawRoundedRect(bar, 1.5, 1.5);
    painter->restore();
}

EnergyList::EnergyList(const Theme &theme, QWidget *parent)
    : QListView(parent), m_model(new EnergyListModel(this))
{
    setObjectName("ledger");
    setAccessibleName(tr("Where energy and momentum went"));
    setModel(m_model);
    setItemDelegate(new EnergyDelegate(theme, this));
    setFrameShape(QFrame::NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setUniformItemSizes(true);
    setMouseTracking(true);
    connect(&theme, &Theme::changed, viewport(), qOverload<>(&QWidget::update));
}

void EnergyList::setLines(std::vector<EnergyLine> lines, const QString &unit)
{
    m_model->setLines(std::move(lines), unit);
}

}
