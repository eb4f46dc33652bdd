#pragma once

#include "app/ui/theme/theme.h"

#include <QPainter>
#include <QWidget>

namespace app {

/// A right-aligned number that changes many times a second without a new layout. It is hidden where it does not fit.
class PlotValue : public QWidget
{
    Q_OBJECT

public:
    explicit PlotValue(const Theme &theme, QWidget *parent = nullptr) : QWidget(parent), m_theme(theme)
    {
        setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        setToolTip(tr("The number at the cursor"));
        connect(&theme, &Theme::changed, this, qOverload<>(&QWidget::update));
    }

    QString text() const { return m_text; }
    /// `exact` is the same number with rounding errors, for the tooltip.
    void setText(const QString &text, const QString &exact)
    {
        const QString what = tr("The number at the cursor");
        const QString tip = exact.isEmpty() || exact == text ? what : what + '\n' + exact;
        if (tip != toolTip())
            setToolTip(tip);
        if (text == m_text)
            return;
        m_text = text;
        update();
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        // The raised digits of the monospaced font cannot be told apart at this size.
        const bool hasPower = m_text.contains(QChar(0x00B7));
        painter.setFont(hasPower ? m_theme.ui(12) : m_theme.mono(12));
        painter.setPen(m_theme.tokens().ink);
        if (painter.fontMetrics().horizontalAdvance(m_text) <= width())
            painter.drawText(rect(), Qt::AlignRight | Qt::AlignVCenter, m_text);
    }

private:
    const Theme &m_theme;
    QString m_text;
};

}
