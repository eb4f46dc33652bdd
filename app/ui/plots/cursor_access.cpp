#include "app/ui/plots/cursor_access.h"

#include "app/ui/plots/cursor_plot.h"

#include <QAccessible>
#include <QAccessibleWidget>

namespace app {

namespace {

class CursorAccess : public QAccessibleWidget
{
public:
    explicit CursorAccess(CursorPlot *plot) : QAccessibleWidget(plot, QAccessible::Chart), m_plot(plot) {}

    QString text(QAccessible::Text kind) const override
    {
        if (kind == QAccessible::Name)
            return m_plot->title();
        return kind == QAccessible::Value ? m_plot->fullSentence() : QAccessibleWidget::text(kind);
    }

private:
    CursorPlot *m_plot;
};

QAccessibleInterface *makeAccess(const QString &, QObject *object)
{
    auto *plot = qobject_cast<CursorPlot *>(object);
    return plot ? new CursorAccess(plot) : nullptr;
}

}

void installCursorAccess()
{
    static const bool once = [] {
        QAccessible::installFactory(makeAccess);
        return true;
    }();
    Q_UNUSED(once);
}

}
