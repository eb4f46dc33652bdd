#include "app/ui/stability/stability_gauge.h"

#include "app/model/text/numbers.h"
#include "app/ui/actions/command.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QKeyEvent>
#include <QPainter>
#include <QTextDocumentFragment>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr int gaugeMargin = 8;
constexpr int gaugeGap = 8;
constexpr int gaugeHeight = 24;
constexpr int tickHeight = 12;
constexpr double paleness = 0.45;

/// A button with a value: the share of the limit.
class GaugeAccess : public QAccessibleWidget, public QAccessibleValueInterface
{
public:
    explicit GaugeAccess(StabilityGauge *gauge)
        : QAccessibleWidget(gauge, QAccessible::PushButton), m_gauge(gauge)
    {
    }

    void *interface_cast(QAccessible::InterfaceType type) override
    {
        if (type == QAccessible::ValueInterface)
            return static_cast<QAccessibleValueInterface *>(this);
        return QAccessibleWidget::interface_cast(type);
    }
    QString text(QAccessible::Text kind) const override
    {
        return kind == QAccessible::Value ? m_gauge->words() : QAccessibleWidget::text(kind);
    }
    QStringList actionNames() const override { return {pressAction()}; }
    void doAction(const QString &name) override
    {
        if (name == pressAction())
            m_gauge->click();
    }

    QVariant currentValue() const override { return m_gauge->percent(); }
    void setCurrentValue(const QVariant &) override {}
    QVariant minimumValue() const override { return 0.0; }
    QVariant maximumValue() const override { return 100.0 / StabilityGauge::limitPlace; }
    QVariant minimumStepSize() const override { return 1.0; }

private:
    StabilityGauge *m_gauge;
};

QAccessibleInterface *makeGaugeAccess(const QString &, QObject *object)
{
    auto *gauge = qobject_cast<StabilityGauge *>(object);
    return gauge ? new GaugeAccess(gauge) : nullptr;
}

}

StabilityGauge::StabilityGauge(const StabilityMonitor &monitor, const Command &toggle, const Theme &theme,
                               QWidget *parent)
    : QAbstractButton(parent), m_monitor(monitor), m_keys(toggle.shortcut()), m_theme(theme)
{
    QAccessible::installFactory(makeGaugeAccess);
    setObjectName("gauge");
    setCheckable(true);
    setFocusPolicy(Qt::TabFocus);
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAttribute(Qt::WA_Hover);
    connect(&monitor, &StabilityMonitor::changed, this, &StabilityGauge::refresh);
    connect(&monitor.preview(), &StabilityPreview::changed, this, &StabilityGauge::refresh);
    refresh();
}

const StabilityReading *StabilityGauge::reading() const
{
    const StabilityPreview &preview = m_monitor.preview();
    return preview.isOpen() && preview.reading() ? preview.reading() : m_monitor.reading();
}

QString StabilityGauge::description() const
{
    if (!reading())
        return {};
    const QString verdict = QTextDocumentFragment::fromHtml(stabilityVerdict(*reading())).toPlainText();
    const StabilityPreview &preview = m_monitor.preview();
    return preview.isOpen() && preview.isCurrent()
               ? tr("Preview of frame %1: %2").arg(preview.frame()).arg(verdict)
               : verdict;
}

void StabilityGauge::refresh()
{
    const QString words = reading() ? gaugeWords(*reading()) : QString();
    const bool grows = QFontMetrics(m_theme.ui(12)).horizontalAdvance(words) !=
                       QFontMetrics(m_theme.ui(12)).horizontalAdvance(m_words);
    m_words = words;
    setText(words);
    setAccessibleName(tr("Stability"));
    setAccessibleDescription(description());
    setToolTip(QStringLiteral("<p>%1</p><p>%2</p>")
                   .arg(reading() ? stabilityVerdict(*reading()) : QString(),
                        withKeys(tr("Click for the reasons and the remedies"), m_keys)));
    if (grows)
        updateGeometry();
    update();
}

double StabilityGauge::percent() const
{
    if (!reading() || reading()->stability.bound != sim::Bound::stiffness)
        return 0.0;
    return 100.0 * std::min(reading()->stability.share(), 1.0 / limitPlace);
}

double StabilityGauge::filled() const
{
    return percent() / 100.0 * limitPlace;
}

QColor StabilityGauge::fillColor() const
{
    const Tokens &tokens = m_theme.tokens();
    switch (nearnessOf(reading()->stability)) {
    case Nearness::past:
        return tokens.past;
    case Nearness::near:
        return tokens.near;
    case Nearness::far:
    case Nearness::none:
        break;
    }
    return tokens.ok;
}

QSize StabilityGauge::sizeHint() const
{
    const QFontMetrics metrics(m_theme.ui(12));
    // Room for numbers that change during playback, so that nothing beside them moves.
    const int words =
        std::max(metrics.horizontalAdvance(m_words),
                 metrics.horizontalAdvance(tr("%1\u2009% of the limit").arg(fixedNumber(99.9, 1))));
    return {2 * gaugeMargin + metrics.horizontalAdvance(tr("Stability")) + gaugeGap + barWidth + gaugeGap +
                words,
            gaugeHeight};
}

void StabilityGauge::paintBar(QPainter &painter, const QRectF &bar) const
{
    const Tokens &tokens = m_theme.tokens();
    const bool isBound = reading() && reading()->stability.bound == sim::Bound::stiffness;
    const double round = bar.height() / 2.0;
    if (!isBound) {
        painter.setPen(QPen(tokens.line2, 1.0, Qt::DotLine));
        painter.setBrush(Qt::NoBrush);
        painter.drawRoundedRect(bar.adjusted(0.5, 0.5, -0.5, -0.5), round, round);
        return;
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(tokens.computed);
    painter.drawRoundedRect(bar, round, round);
    QRectF done = bar;
    done.setWidth(std::max(bar.height(), bar.width() * std::min(1.0, filled())));
    if (filled() > 0.0) {
        painter.setBrush(fillColor());
        painter.drawRoundedRect(done, round, round);
    }
    const double x = std::round(bar.left() + limitPlace * bar.width()) + 0.5;
    painter.setPen(QPen(tokens.ink, 1.0));
    painter.drawLine(QPointF(x, bar.center().y() - tickHeight / 2.0),
                     QPointF(x, bar.center().y() + tickHeight / 2.0));
}

void StabilityGauge::paintEvent(QPaintEvent *)
{
    const Tokens &tokens = m_theme.tokens();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (underMouse() || isChecked())
        m_theme.paintSurface(painter, rect(), 6, Surface::hovered);
    if (isPale())
        painter.setOpacity(paleness);
    const QFont font = m_theme.ui(12);
    const QFontMetricsF metrics(font);
    painter.setFont(font);
    painter.setPen(tokens.ink2);
    QRectF row = QRectF(rect()).adjusted(gaugeMargin, 0, -gaugeMargin, 0);
    painter.drawText(row, Qt::AlignVCenter | Qt::AlignLeft, tr("Stability"));
    row.setLeft(row.left() + metrics.horizontalAdvance(tr("Stability")) + gaugeGap);
    paintBar(painter, QRectF(row.left(), row.center().y() - barHeight / 2.0, barWidth, barHeight));
    row.setLeft(row.left() + barWidth + gaugeGap);
    painter.setPen(tokens.ink);
    painter.drawText(row, Qt::AlignVCenter | Qt::AlignLeft, m_words);
}

void StabilityGauge::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        click();
    else
        QAbstractButton::keyPressEvent(event);
}

}
