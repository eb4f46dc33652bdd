#pragma once

#include "app/model/energy_lines.h"
#include "app/ui/theme/theme.h"

#include <QAbstractListModel>
#include <QListView>
#include <QStyledItemDelegate>

namespace app {

/// The lines of a ledger, for views.
class EnergyListModel : public QAbstractListModel
{
    Q_OBJECT

public:
    using QAbstractListModel::QAbstractListModel;

    /// `unit` is read out after each number.
    void setLines(std::vector<EnergyLine> lines, const QString &unit);
    const std::vector<EnergyLine> &lines() const { return m_lines; }
    /// The longest bar stands for this much.
    double longest() const { return m_longest; }

    int rowCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;

private:
    std::vector<EnergyLine> m_lines;
    QString m_unit;
    double m_longest = 0.0;
};

/// Draws a line: its mark, its name, its number, and a bar as long as its amount.
class EnergyDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    static constexpr int rowHeight = 27;

    EnergyDelegate(const Theme &theme, QObject *parent) : QStyledItemDelegate(parent), m_theme(theme) {}

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;

private:
    const Theme &m_theme;
};

/// The lines of a ledger as a list: the arrow keys walk through it.
class EnergyList : public QListView
{
    Q_OBJECT

public:
    EnergyList(const Theme &theme, QWidget *parent = nullptr);

    void setLines(std::vector<EnergyLine> lines, const QString &unit);
    const std::vector<EnergyLine> &lines() const { return m_model->lines(); }

private:
    EnergyListModel *m_model;
};

/// The colour of a line, in lists and plots.
QColor inkOf(const EnergyLine &line, const Theme &theme);
/// The hatch that marks the drift besides its colour.
QBrush driftBrush(const Theme &theme);

}
