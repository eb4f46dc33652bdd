#pragma once

#include "app/ui/theme/theme.h"

#include <QAbstractListModel>
#include <QListView>
#include <QStyledItemDelegate>

#include <algorithm>
#include <vector>

namespace app {

/// The roles of a ledger's model, besides those of Qt.
enum LedgerRole {
    lineRole = Qt::UserRole, ///< the whole line
    shareRole,               ///< the length of the line's bar, from 0 to 1
};

/// A list model of lines with an `id`, a `title`, a `help` text and a `role`.
template <typename Line>
class LedgerModel : public QAbstractListModel
{
public:
    using QAbstractListModel::QAbstractListModel;

    /// Replaces the lines. The current row and the selection stay at lines with the same id.
    void setLines(std::vector<Line> lines);
    const std::vector<Line> &lines() const { return m_lines; }
    const Line &line(const QModelIndex &index) const
    {
        return m_lines[static_cast<std::size_t>(index.row())];
    }

    int rowCount(const QModelIndex &parent = {}) const override
    {
        return parent.isValid() ? 0 : static_cast<int>(m_lines.size());
    }
    QVariant data(const QModelIndex &index, int role) const override;

protected:
    /// Returns the amount that a line's bar stands for.
    virtual double amountOf(const Line &line) const = 0;
    /// Returns what a screen reader reads for a line.
    virtual QString spoken(const Line &line) const = 0;

private:
    bool hasSameRows(const std::vector<Line> &lines) const
    {
        return std::equal(lines.begin(), lines.end(), m_lines.begin(), m_lines.end(),
                          [](const Line &a, const Line &b) { return a.id == b.id && a.role == b.role; });
    }

    std::vector<Line> m_lines;
    double m_longest = 0.0; ///< the amount of the longest bar
};

/// A list of a ledger's lines. The arrow keys go through it, and a row under the pointer or in the focus is marked.
class LedgerList : public QListView
{
    Q_OBJECT

public:
    LedgerList(QAbstractItemModel *model, QStyledItemDelegate *delegate, QWidget *parent);
};

/// Paints the background of a row that is chosen by keyboard or under the pointer. Returns whether it is chosen.
bool paintLedgerRow(QPainter &painter, const QStyleOptionViewItem &option, const Theme &theme);

template <typename Line>
void LedgerModel<Line>::setLines(std::vector<Line> lines)
{
    m_longest = 0.0;
    for (const Line &line : lines)
        m_longest = std::max(m_longest, amountOf(line));
    if (hasSameRows(lines)) {
        m_lines = std::move(lines);
        if (!m_lines.empty())
            emit dataChanged(index(0), index(rowCount() - 1));
        return;
    }
    emit layoutAboutToBeChanged();
    const QModelIndexList before = persistentIndexList();
    QModelIndexList after;
    for (const QModelIndex &one : before) {
        const auto found = std::find_if(lines.begin(), lines.end(),
                                        [&](const Line &other) { return other.id == line(one).id; });
        after << (found == lines.end() ? QModelIndex()
                                       : createIndex(static_cast<int>(found - lines.begin()), 0));
    }
    m_lines = std::move(lines);
    changePersistentIndexList(before, after);
    emit layoutChanged();
}

template <typename Line>
QVariant LedgerModel<Line>::data(const QModelIndex &index, int role) const
{
    if (!index.isValid() || index.row() >= rowCount())
        return {};
    const Line &its = line(index);
    switch (role) {
    case Qt::DisplayRole:
        return its.title;
    case Qt::ToolTipRole:
    case Qt::AccessibleDescriptionRole:
        return its.help;
    case Qt::AccessibleTextRole:
        return spoken(its);
    case lineRole:
        return QVariant::fromValue(its);
    case shareRole:
        return m_longest > 0.0 ? amountOf(its) / m_longest : 0.0;
    default:
        return {};
    }
}

}
