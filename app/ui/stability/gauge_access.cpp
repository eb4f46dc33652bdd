#include "app/ui/stability/growth_plot.h"
#include "app/ui/stability/stability_gauge.h"

#include <QAccessible>
#include <QAccessibleWidget>

namespace app {

namespace {

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

class MapAccess : public QAccessibleWidget
{
public:
    explicit MapAccess(GrowthPlot *plot) : QAccessibleWidget(plot, QAccessible::Chart), m_plot(plot) {}

    QString text(QAccessible::Text kind) const override
    {
        return kind == QAccessible::Value ? m_plot->sentence() : QAccessibleWidget::text(kind);
    }
    QStringList actionNames() const override { return {pressAction()}; }
    void doAction(const QString &name) override
    {
        if (name == pressAction())
            m_plot->adopt();
    }

private:
    GrowthPlot *m_plot;
};

QAccessibleInterface *makeAccess(const QString &, QObject *object)
{
    if (auto *gauge = qobject_cast<StabilityGauge *>(object))
        return new GaugeAccess(gauge);
    if (auto *plot = qobject_cast<GrowthPlot *>(object))
        return new MapAccess(plot);
    return nullptr;
}

}

void installGaugeAccess()
{
    static const bool once = [] {
        QAccessible::installFactory(makeAccess);
        return true;
    }();
    Q_UNUSED(once);
}

}
