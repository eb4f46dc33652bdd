#include "app/ui/time/timeline_access.h"

#include "app/ui/time/timeline_strip.h"

#include <QAccessible>
#include <QAccessibleWidget>

namespace app {

namespace {

class TimelineAccess : public QAccessibleWidget, public QAccessibleValueInterface
{
public:
    explicit TimelineAccess(TimelineStrip *timeline)
        : QAccessibleWidget(timeline, QAccessible::Slider), m_timeline(timeline)
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
        return kind == QAccessible::Value ? m_timeline->sentence() : QAccessibleWidget::text(kind);
    }

    QVariant currentValue() const override { return number(m_timeline->frame()); }
    void setCurrentValue(const QVariant &value) override { m_timeline->scrubTo(value.toLongLong()); }
    QVariant minimumValue() const override { return number(0); }
    QVariant maximumValue() const override { return number(m_timeline->axis().frames()); }
    QVariant minimumStepSize() const override { return number(m_timeline->framesPerOutput()); }

private:
    static QVariant number(std::int64_t frame) { return QVariant::fromValue<qlonglong>(frame); }

    TimelineStrip *m_timeline;
};

QAccessibleInterface *makeAccess(const QString &, QObject *object)
{
    TimelineStrip *timeline = qobject_cast<TimelineStrip *>(object);
    return timeline ? new TimelineAccess(timeline) : nullptr;
}

}

void installTimelineAccess()
{
    QAccessible::installFactory(makeAccess);
}

}
