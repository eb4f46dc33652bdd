#pragma once

#include "app/model/effect_lines.h"
#include "app/ui/theme/theme.h"

#include <QAbstractListModel>
#include <QListView>
#include <QStyledItemDelegate>

namespace app {

/// The lines of the ledger of effects, for views.
class EffectListModel : public QAbstractListModel
{
    Q_OBJECT

public:
    using QAbstractListModel::QAbstractListModel;

    void setLines(std::vector<EffectLine> lines);
    const std::vector<EffectLine> &lines() const { return m_lines; }
    const EffectLine &line(const QModelIndex &index) const
    {
        return m_lines[static_cast<std::size_t>(index.row())];
    }
    /// The longest bar stands for this much, in ns.
    double longest() const { return m_longest; }

    int rowCount(const QModelIndex &parent = {}) const override;
    QVariant data(const QModelIndex &index, int role) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;

signals:
    /// Somebody wants the effects with this id on or off.
    void switched(const QString &id, bool on);

private:
    std::vector<EffectLine> m_lines;
    double m_longest = 0.0;
};

/// Where the columns of a line are.
struct EffectColumns
{
    /// @param width of the whole list, px
    explicit EffectColumns(double width);

    double name = 0.0, nameWidth = 0.0;
    double bar = 0.0, barWidth = 0.0;
    double frameRight = 0.0; ///< right end of "µs a frame"; what it is off by stands right of it
    double pointRight = 0.0;
    double pointsRight = 0.0;
    double runsRight = 0.0;
    double toggle = 0.0; ///< left end of the switch
    bool hasSpread = true;
    bool hasPoints = true;
};

/// Draws a line: its mark, name, bar, figures and switch.
class EffectDelegate : public QStyledItemDelegate
{
    Q_OBJECT

public:
    EffectDelegate(const Theme &theme, QObject *parent) : QStyledItemDelegate(parent), m_theme(theme) {}

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    /// Where the switch of a row is.
    static QRect switchRect(const QRect &row);

protected:
    bool editorEvent(QEvent *event, QAbstractItemModel *model, const QStyleOptionViewItem &option,
                     const QModelIndex &index) override;

private:
    void drawBar(QPainter &painter, const QRectF &row, const EffectLine &line, double longest) const;
    void drawFigures(QPainter &painter, const QRectF &row, const EffectLine &line) const;
    void drawSwitch(QPainter &painter, const QRectF &box, const EffectLine &line) const;

    const Theme &m_theme;
};

/// The lines of the ledger as a list: arrow keys walk through it, Space switches.
class EffectList : public QListView
{
    Q_OBJECT

public:
    explicit EffectList(const Theme &theme, QWidget *parent = nullptr);

    EffectListModel &lines() const { return *m_model; }
    /// The line that the learner looks at: under the pointer, or chosen by keys; null: none.
    const EffectLine *current() const;

signals:
    void currentChangedTo();

protected:
    void currentChanged(const QModelIndex &current, const QModelIndex &previous) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    /// Leaves room free below the last row that fits whole.
    void showWholeRows();

    EffectListModel *m_model;
};

/// The names of the columns over the list.
class EffectHeads : public QWidget
{
    Q_OBJECT

public:
    static constexpr int headHeight = 24;

    EffectHeads(const Theme &theme, const EffectList &list, QWidget *parent = nullptr);

protected:
    void paintEvent(QPaintEvent *event) override;
    bool event(QEvent *event) override;

private:
    const Theme &m_theme;
    const EffectList &m_list;
};

}
