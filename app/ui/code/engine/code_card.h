#pragma once

#include "app/model/code/code_history.h"

#include <QWidget>

namespace app {

class Theme;

/// A card that explains a word of the code: its current value, its meaning, and a plot of its last frames.
/// It is shown beside the word and redrawn only when show() is called.
class CodeCard : public QWidget
{
    Q_OBJECT

public:
    explicit CodeCard(const Theme &theme, QWidget *parent = nullptr);

    /// Shows `symbol`. `whose` names its owner, for example "foot 0, springs"; it is empty for a parameter.
    /// `word` is the rectangle of the word on the screen.
    void show(const CodeSymbol &symbol, const QString &whose, const CodeHistory &history,
              const QString &value, const QRect &word);
    const CodeSymbol &symbol() const { return m_symbol; }
    const CodeHistory &history() const { return m_history; }
    QString value() const { return m_value; }

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    QString headline() const;
    QString text() const;
    int textHeight() const;
    void paintPlot(QPainter &painter, const QRectF &area) const;
    void paintLine(QPainter &painter, const QRectF &area, int part) const;
    void paintLabels(QPainter &painter, const QRectF &area) const;
    std::pair<double, double> range() const;

    const Theme &m_theme;
    CodeSymbol m_symbol;
    CodeHistory m_history;
    QString m_whose;
    QString m_value;
};

}
