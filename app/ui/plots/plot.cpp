#include "app/ui/plots/plot.h"

#include "app/ui/theme/focus_ring.h"

#include <QAccessible>
#include <QAccessibleWidget>

#include <cmath>

namespace app {

namespace {

class PlotAccess : public QAccessibleWidget
{
public:
    explicit PlotAccess(Plot *plot) : QAccessibleWidget(plot, QAccessible::Chart), m_plot(plot) {}

    QString text(QAccessible::Text kind) const override
    {
        switch (kind) {
        case QAccessible::Name:
            return m_plot->title();
        case QAccessible::Value:
            return m_plot->spokenValue();
        default:
            return QAccessibleWidget::text(kind);
        }
    }
    QStringList actionNames() const override
    {
        QStringList names = QAccessibleWidget::actionNames();
        if (m_plot->canPress())
            names.prepend(pressAction());
        return names;
    }
    void doAction(const QString &name) override
    {
        if (name == pressAction())
            m_plot->press();
        else
            QAccessibleWidget::doAction(name);
    }

private:
    Plot *m_plot;
};

QAccessibleInterface *makePlotAccess(const QString &, QObject *object)
{
    auto *plot = qobject_cast<Plot *>(object);
    return plot ? new PlotAccess(plot) : nullptr;
}

}

Plot::Plot(const Theme &theme, QWidget *parent) : QCustomPlot(parent), m_theme(theme)
{
    QAccessible::installFactory(makePlotAccess);
    setLayoutDirection(Qt::LeftToRight); // axes are the same in every language
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAntialiasedElements(QCP::aeAll);
    setNoAntialiasingOnDrag(false);
    // Plots are painted with everything else that has changed: in the middle of a change others may not be ready.
    setPlottingHint(QCP::phImmediateRefresh, false);
    connect(&theme, &Theme::changed, this, &Plot::applyTheme);
}

void styleAxis(QCPAxis &axis, const Theme &theme)
{
    const Tokens &t = theme.tokens();
    axis.setBasePen(QPen(t.line2, 1.0));
    axis.setTickPen(QPen(t.line2, 1.0));
    axis.setTickLength(0, 3);
    axis.setSubTicks(false);
    axis.setTickLabelColor(t.ink3);
    axis.setTickLabelFont(theme.ui(12));
    axis.setTickLabelPadding(4);
    axis.grid()->setSubGridVisible(false);
    // In high contrast, lines and curves are equally white, so the grid uses the weaker colour of the dots.
    axis.grid()->setPen(QPen(theme.scheme() == Scheme::highContrast ? t.dots : t.line, 1.0));
    axis.grid()->setZeroLinePen(Qt::NoPen);
}

void Plot::applyTheme()
{
    const Tokens &t = m_theme.tokens();
    setBackground(t.panel);
    for (QCPAxis *axis : {xAxis, yAxis})
        styleAxis(*axis, m_theme);
}

PlotPicture Plot::pictureNamed(const QString &title, const QString &fileName)
{
    return {title, fileName, size(), [this](QCPPainter &painter) {
                toPainter(&painter, width(), height());
                painter.setRenderHint(QPainter::Antialiasing);
                paintMarks(painter);
            }};
}

QPointF Plot::onScreen(QPointF place) const
{
    return {xAxis->coordToPixel(place.x()), yAxis->coordToPixel(place.y())};
}

void Plot::announceValue()
{
    if (!QAccessible::isActive())
        return;
    QAccessibleValueChangeEvent event(this, sentence());
    QAccessible::updateAccessibility(&event);
}

bool Plot::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride && wantsKey(*static_cast<QKeyEvent *>(event))) {
        event->accept();
        return true;
    }
    return QCustomPlot::event(event);
}

void Plot::paintEvent(QPaintEvent *event)
{
    QCustomPlot::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintMarks(painter);
    paintPointer(painter);
    if (!m_hasFocusRing)
        return;
    painter.setPen(QPen(m_theme.tokens().ink, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(2.0, 2.0, -2.0, -2.0), 6.0, 6.0);
}

void Plot::focusInEvent(QFocusEvent *event)
{
    m_hasFocusRing = isByKeyboard(event->reason());
    QCustomPlot::focusInEvent(event);
    update();
}

void Plot::focusOutEvent(QFocusEvent *event)
{
    m_hasFocusRing = false;
    QCustomPlot::focusOutEvent(event);
    update();
}

bool isPlainKey(const QKeyEvent &event, Qt::KeyboardModifiers allowed)
{
    return (event.modifiers() & ~(Qt::KeypadModifier | allowed)) == Qt::NoModifier;
}

QPen curvePen(const QColor &ink, double width)
{
    return {ink, width, Qt::SolidLine, Qt::SquareCap, Qt::BevelJoin};
}

bool isFinite(QPointF place)
{
    return std::isfinite(place.x()) && std::isfinite(place.y());
}

}
