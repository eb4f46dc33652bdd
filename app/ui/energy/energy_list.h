#pragma once

#include "app/model/analysis/energy_lines.h"
#include "app/ui/dock/ledger.h"

namespace app {

/// The lines of the energy or momentum ledger.
class EnergyListModel : public LedgerModel<EnergyLine>
{
    Q_OBJECT

public:
    /// `unit` is the unit of all numbers.
    void setLines(std::vector<EnergyLine> lines, const QString &unit);

    QVariant data(const QModelIndex &index, int role) const override;

protected:
    double amountOf(const EnergyLine &line) const override;
    QString spoken(const EnergyLine &line) const override;

private:
    QString m_unit;
};

/// Draws a line: its mark, its name, its number, and a bar as long as its amount.
class EnergyDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    static constexpr int rowHeight = 27;

    explicit EnergyDelegate(const Theme &theme) : m_theme(theme) {}

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &, const QModelIndex &) const override
    {
        return {200, rowHeight};
    }

private:
    const Theme &m_theme;
};

/// The energy or momentum ledger.
class EnergyList : public LedgerList
{
    Q_OBJECT

public:
    EnergyList(const Theme &theme, QWidget *parent = nullptr);

    void setLines(std::vector<EnergyLine> lines, const QString &unit);
    const std::vector<EnergyLine> &lines() const { return m_model->lines(); }

private:
    EnergyList(EnergyListModel *model, const Theme &theme, QWidget *parent);

    EnergyListModel *m_model;
};

/// Returns the colour of a line, in lists and plots.
QColor inkOf(const EnergyLine &line, const Theme &theme);
/// Returns the hatch that marks the drift besides its colour.
QBrush driftBrush(const Theme &theme);

}
