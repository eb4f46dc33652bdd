#include "app/ui/energy/energy_list.h"

#include <QPainter>

#include <cmath>

namespace app {

namespace {

constexpr int kindMarkSize = 10;
constexpr int rowMargin = 12;
constexpr int textLeft = rowMargin + kindMarkSize + 9;
constexpr int shareBarHeight = 3;

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
    m_unit = unit;
    LedgerModel::setLines(std::move(lines));
}

double EnergyListModel::amountOf(const EnergyLine &line) const
{
    return std::hypot(line.amount, line.across);
}

QString EnergyListModel::spoken(const EnergyLine &line) const
{
    return tr("%1: %2 %3").arg(line.title, line.number, m_unit);
}

QVariant EnergyListModel::data(const QModelIndex &index, int role) const
{
    if (role != Qt::ToolTipRole || !index.isValid())
        return LedgerModel::data(index, role);
    const EnergyLine &its = line(index);
    return tr("%1: %2\u2009%3\n%4").arg(its.title, its.number, m_unit, its.help);
}

void EnergyDelegate::paint(QPainter *painter, const QStyleOptionViewItem &option,
                           const QModelIndex &index) const
{
    const auto line = index.data(lineRole).value<EnergyLine>();
    const Tokens &t = m_theme.tokens();
    const bool isDrift = line.role == EnergyRole::drift;
    const QColor ink = inkOf(line, m_theme);
    const QRectF row = option.rect;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    paintLedgerRow(*painter, option, m_theme);
    const QRectF mark(row.x() + rowMargin, row.y() + 5, kindMarkSize, kindMarkSize);
    painter->setPen(QPen(ink, 1.2));
    painter->setBrush(isDrift ? driftBrush(m_theme)
                              : QBrush(line.role == EnergyRole::held ? ink : Qt::transparent));
    painter->drawRoundedRect(mark, 2, 2);
    const QRectF text = row.adjusted(textLeft, 1, -rowMargin, -(shareBarHeight + 4));
    painter->setPen(line.amount == 0.0 && line.across == 0.0 ? t.ink3 : t.ink);
    painter->setFont(m_theme.mono(12));
    const double numberWidth = painter->fontMetrics().horizontalAdvance(line.number);
    painter->drawText(text, Qt::AlignRight | Qt::AlignVCenter, line.number);
    painter->setFont(m_theme.ui(13, isDrift ? QFont::DemiBold : QFont::Normal));
    painter->setPen(t.ink);
    const double room = text.width() - numberWidth - 8;
    painter->drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                      painter->fontMetrics().elidedText(line.title, Qt::ElideRight, static_cast<int>(room)));
    QRectF bar(text.left(), row.bottom() - shareBarHeight - 3, text.width(), shareBarHeight);
    painter->setPen(Qt::NoPen);
    painter->setBrush(t.track);
    painter->drawRoundedRect(bar, 1.5, 1.5);
    bar.setWidth(bar.width() * index.data(shareRole).toDouble());
    painter->setBrush(ink);
    painter->drawRoundedRect(bar, 1.5, 1.5);
    painter->restore();
}

EnergyList::EnergyList(const Theme &theme, QWidget *parent) : EnergyList(new EnergyListModel, theme, parent)
{
}

EnergyList::EnergyList(EnergyListModel *model, const Theme &theme, QWidget *parent)
    : LedgerList(model, new EnergyDelegate(theme), parent), m_model(model)
{
    setAccessibleName(tr("Where energy and momentum went"));
    setUniformItemSizes(true);
}

void EnergyList::setLines(std::vector<EnergyLine> lines, const QString &unit)
{
    m_model->setLines(std::move(lines), unit);
}

}
