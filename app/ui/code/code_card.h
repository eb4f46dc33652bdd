#pragma once

#include "app/model/code_history.h"

#include <QWidget>

namespace app {

class Theme;

/// What a word of the code stands for: its value now, what it is, and its course over the last frames. Shown beside the
/// word; redrawn only when somebody shows something else.
class CodeCard : public QWidget
{
    Q_OBJECT

public:
    explicit CodeCard(const Theme &theme, QWidget *parent = nullptr);

    /// `whose`: "foot 0, springs"; empty for a parameter. `word`: where it stands on the screen.
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
