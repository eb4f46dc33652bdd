#pragma once

#include "app/model/analysis/effect_lines.h"
#include "app/ui/dock/ledger.h"

namespace app {

/// The lines of the effect ledger. Effects that the scene lists have a check state: their switch.
class EffectListModel : public LedgerModel<EffectLine>
{
    Q_OBJECT

public:
    QVariant data(const QModelIndex &index, int role) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role) override;
    Qt::ItemFlags flags(const QModelIndex &index) const override;

signals:
    /// Emitted when the learner switches the effects with this id.
    void switched(const QString &id, bool on);

protected:
    double amountOf(const EffectLine &line) const override { return line.ns; }
    QString spoken(const EffectLine &line) const override { return line.spoken(); }
};

/// The columns of a line, in px.
struct EffectColumns
{
    /// @param width of the whole list, px
    explicit EffectColumns(double width);

    double name = 0.0, nameWidth = 0.0;
    double bar = 0.0, barWidth = 0.0;
    double frameRight = 0.0; ///< right end of "µs a frame"; the uncertainty is right of it
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
    explicit EffectDelegate(const Theme &theme) : m_theme(theme) {}

    void paint(QPainter *painter, const QStyleOptionViewItem &option,
               const QModelIndex &index) const override;
    QSize sizeHint(const QStyleOptionViewItem &option, const QModelIndex &index) const override;
    /// Returns the place of the switch in a row.
    static QRect switchRect(const QRect &row);

protected:
    bool editorEvent(QEvent *event, QAbstractItemModel *model, const QStyleOptionViewItem &option,
                     const QModelIndex &index) override;

private:
    void drawBar(QPainter &painter, const QRectF &row, const EffectLine &line, double share) const;
    void drawFigures(QPainter &painter, const QRectF &row, const EffectLine &line) const;
    void drawSwitch(QPainter &painter, const QRectF &box, const EffectLine &line) const;

    const Theme &m_theme;
};

/// The effect ledger. Space switches the current line.
class EffectList : public LedgerList
{
    Q_OBJECT

public:
    explicit EffectList(const Theme &theme, QWidget *parent = nullptr);

    EffectListModel &lines() const { return *m_model; }
    /// Returns the line under the pointer, or the one that the keys went to; null for none.
    const EffectLine *current() const;

signals:
    void currentChangedTo();

protected:
    void currentChanged(const QModelIndex &current, const QModelIndex &previous) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    EffectList(EffectListModel *model, const Theme &theme, QWidget *parent);
    /// Leaves the room below the last row that fits as a whole empty.
    void showWholeRows();

    EffectListModel *m_model;
};

/// The header of the list: the names of its columns, with tooltips.
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
