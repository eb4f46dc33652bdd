#include "app/ui/measure/plot_access.h"

#include "app/ui/measure/spot_plot.h"

#include <QAccessible>
#include <QAccessibleWidget>

namespace app {

namespace {

class PlotAccess : public QAccessibleWidget
{
public:
    explicit PlotAccess(SpotPlot *plot) : QAccessibleWidget(plot, QAccessible::Chart), m_plot(plot) {}

    QString text(QAccessible::Text kind) const override
    {
        return kind == QAccessible::Value ? m_plot->sentence() : QAccessibleWidget::text(kind);
    }

private:
    SpotPlot *m_plot;
};

QAccessibleInterface *makeAccess(const QString &, QObject *object)
{
    auto *plot = qobject_cast<SpotPlot *>(object);
    return plot ? new PlotAccess(plot) : nullptr;
}

}

void installPlotAccess()
{
    static const bool once = [] {
        QAccessible::installFactory(makeAccess);
        return true;
    }();
    Q_UNUSED(once);
}

}
