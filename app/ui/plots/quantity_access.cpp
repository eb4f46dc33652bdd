#include "app/ui/plots/quantity_access.h"

#include "app/ui/plots/quantity_plot.h"

#include <QAccessible>
#include <QAccessibleWidget>

namespace app {

namespace {

class QuantityAccess : public QAccessibleWidget
{
public:
    explicit QuantityAccess(QuantityPlot *plot) : QAccessibleWidget(plot, QAccessible::Chart), m_plot(plot) {}

    QString text(QAccessible::Text kind) const override
    {
        if (kind == QAccessible::Name)
            return m_plot->title();
        return kind == QAccessible::Value ? m_plot->sentence() : QAccessibleWidget::text(kind);
    }

private:
    QuantityPlot *m_plot;
};

QAccessibleInterface *makeAccess(const QString &, QObject *object)
{
    auto *plot = qobject_cast<QuantityPlot *>(object);
    return plot ? new QuantityAccess(plot) : nullptr;
}

}

void installQuantityAccess()
{
    static const bool once = [] {
        QAccessible::installFactory(makeAccess);
        return true;
    }();
    Q_UNUSED(once);
}

}
