#include "app/ui/measure/spot_plot.h"

#include "app/model/accuracy_rows.h"
#include "app/model/accuracy_words.h"
#include "app/ui/measure/plot_access.h"
#include "app/ui/measure/plot_marks.h"
#include "app/ui/theme/plot_axes.h"

#include <QAccessible>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

SpotPlot::SpotPlot(AccuracyStudy &study, const Theme &theme, QWidget *parent)
    : QCustomPlot(parent), m_study(study), m_theme(theme)
{
    installPlotAccess();
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAntialiasedElements(QCP::aeAll);
    setNoAntialiasingOnDrag(false);
    setPlottingHint(QCP::phImmediateRefresh, false); // it is painted together with all else that has changed
    m_errorTicks = makeLogarithmic(*yAxis, PowerTicker::Writing::plain);
    setErrors({});
    axisRect()->setAutoMargins(QCP::msNone);
    axisRect()->setMargins({66, 12, 16, 44});
    connect(&study, &AccuracyStudy::changed, this, &SpotPlot::refresh);
    connect(&theme, &Theme::changed, this, &SpotPlot::dress);
    dress();
}

void SpotPlot::dress()
{
    setBackground(m_theme.tokens().panel);
    dressAxis(*xAxis, m_theme);
    dressAxis(*yAxis, m_theme);
    m_axesAreOld = true;
    refresh();
}

void SpotPlot::setShown(const ShownMethods &shown)
{
    if (shown == m_shown)
        return;
    m_shown = shown;
    refresh();
}

void SpotPlot::refresh()
{
    if (!isVisible()) {
        m_stale = true;
        return;
    }
    m_stale = false;
    const QCPRange across = xAxis->range();
    const QCPRange up = yAxis->range();
    const bool had = m_chosen.has_value();
    m_spots = m_study.accuracy() ? layOut() : std::vector<Spot>{};
    if (had) {
        // The same way again, as near as possible to where it was.
        const Spot *found = nullptr;
        for (const Spot &spot : m_spots) {
            if (!sameWay(rowOf(spot).setup, m_chosenWay))
                continue;
            if (!found || std::abs(spot.place.x() - m_chosen->place.x()) <
                              std::abs(found->place.x() - m_chosen->place.x()))
                found = &spot;
        }
        m_chosen = found ? std::optional(*found) : std::nullopt;
    }
    // The axes are painted anew only where they are others: that takes more than all the rest.
    if (std::exchange(m_axesAreOld, false) || xAxis->range() != across || yAxis->range() != up)
        replot(QCustomPlot::rpQueuedReplot);
    else
        update();
    m_isUnplaced = true;
}

void SpotPlot::setErrors(const ErrorScale &errors)
{
    m_errors = errors;
    m_errorTicks->setLowest(errors.lowest);
    yAxis->setRange(errors.lower, errors.upper);
}

OnScreen SpotPlot::screen() const
{
    return [this](const Spot &spot) { return onScreen(spot); };
}

QPointF SpotPlot::onScreen(QPointF place) const
{
    return {xAxis->coordToPixel(place.x()), yAxis->coordToPixel(place.y())};
}

const Spot *SpotPlot::chosen() const
{
    return m_chosen && m_study.accuracy() ? &*m_chosen : nullptr;
}

QString SpotPlot::tipOf(const Spot &spot) const
{
    return rowWords(rowOf(spot));
}

QString SpotPlot::sentence() const
{
    if (!chosen())
        return tr("Points: %1. Arrow keys walk through them, Enter uses one.").arg(m_spots.size());
    return tipOf(*m_chosen).replace('\n', QStringLiteral(". "));
}

void SpotPlot::choose(const Spot *spot)
{
    if (spot) {
        m_chosenWay = rowOf(*spot).setup;
        m_chosen = *spot;
    } else {
        m_chosen.reset();
    }
    update();
    emit chosenChanged();
    QAccessibleValueChangeEvent event(this, sentence());
    QAccessible::updateAccessibility(&event);
}

void SpotPlot::showTip()
{
    if (!chosen()) {
        QToolTip::hideText();
        return;
    }
    const QPoint beside = onScreen(*m_chosen).toPoint() + QPoint(8, 8);
    QToolTip::showText(mapToGlobal(beside), tipOf(*m_chosen), this);
}

void SpotPlot::adopt()
{
    if (chosen())
        m_study.adopt(rowOf(*m_chosen).setup);
}

void SpotPlot::showEvent(QShowEvent *event)
{
    QCustomPlot::showEvent(event);
    if (m_stale)
        refresh();
}

void SpotPlot::resizeEvent(QResizeEvent *event)
{
    QCustomPlot::resizeEvent(event);
    refresh(); // room for labels is counted in px
}

/// Where errors of exactly 0 stand: below the numbers, from which a gap in the axis parts it.
void SpotPlot::drawFloor(QPainter &painter) const
{
    if (!m_study.accuracy() || m_errors.floor <= 0.0)
        return;
    const Tokens &t = m_theme.tokens();
    const QRectF area = axisRect()->rect();
    const double y = yAxis->coordToPixel(m_errors.floor);
    painter.setPen(dotted(t.ink3, 1.0));
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    painter.setFont(m_theme.ui(12));
    painter.setPen(t.ink3);
    const double height = QFontMetricsF(painter.font()).height();
    painter.drawText(QRectF(0.0, y - height / 2.0, area.left() - 8.0, height),
                     Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("0"));
    const double gap = 0.5 * (y + yAxis->coordToPixel(m_errors.lowest));
    painter.fillRect(QRectF(area.left() - 3.0, gap - 2.0, 6.0, 4.0), t.panel);
    painter.setPen(QPen(t.ink3, 1.0));
    for (const double edge : {gap - 2.0, gap + 2.0})
        painter.drawLine(QPointF(area.left() - 4.0, edge + 2.0), QPointF(area.left() + 4.0, edge - 2.0));
}

void SpotPlot::drawAll(QPainter &painter)
{
    painter.setRenderHint(QPainter::Antialiasing);
    drawFloor(painter);
    if (!m_study.accuracy())
        return;
    if (std::exchange(m_isUnplaced, false))
        placeWords();
    draw(painter);
}

PlotPicture SpotPlot::picture()
{
    return {accessibleName(), accessibleName(), size(), [this](QCPPainter &painter) {
                toPainter(&painter, width(), height());
                drawAll(painter);
            }};
}

QByteArray SpotPlot::numbers() const
{
    return m_study.accuracy() ? numbersOf(*m_study.accuracy()) : QByteArray();
}

QByteArray SpotPlot::numbersOf(const sim::Accuracy &accuracy) const
{
    return accuracyRows(accuracy);
}

void SpotPlot::paintEvent(QPaintEvent *event)
{
    QCustomPlot::paintEvent(event);
    QPainter painter(this);
    drawAll(painter);
    if (!m_ringed)
        return;
    painter.setPen(QPen(m_theme.tokens().ink, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(2.0, 2.0, -2.0, -2.0), 6.0, 6.0);
}

}
