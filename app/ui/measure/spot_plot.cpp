#include "app/ui/measure/spot_plot.h"

#include "app/model/accuracy_words.h"
#include "app/ui/measure/plot_access.h"

#include <QAccessible>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double reach = 12.0; ///< px round the pointer in which a spot is found

bool isWalk(int key)
{
    return key >= Qt::Key_Left && key <= Qt::Key_Down;
}

bool isTake(int key)
{
    return key == Qt::Key_Return || key == Qt::Key_Enter || key == Qt::Key_Space;
}

double distance(QPointF a, QPointF b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

}

SpotPlot::SpotPlot(AccuracyStudy &study, const Theme &theme, QWidget *parent)
    : QCustomPlot(parent), m_study(study), m_theme(theme)
{
    installPlotAccess();
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAntialiasedElements(QCP::aeAll);
    setNoAntialiasingOnDrag(false);
    for (QCPAxis *axis : {xAxis, yAxis}) {
        axis->grid()->setSubGridVisible(false);
        axis->setTickLengthIn(0);
        axis->setTickLengthOut(3);
        axis->setSubTicks(false);
    }
    axisRect()->setAutoMargins(QCP::msNone);
    axisRect()->setMargins({58, 12, 16, 44});
    connect(&study, &AccuracyStudy::changed, this, &SpotPlot::refresh);
    connect(&theme, &Theme::changed, this, &SpotPlot::dress);
    dress();
}

void SpotPlot::dress()
{
    const Tokens &t = m_theme.tokens();
    setBackground(t.panel);
    for (QCPAxis *axis : {xAxis, yAxis}) {
        axis->setBasePen(QPen(t.line2, 1.0));
        axis->setTickPen(QPen(t.line2, 1.0));
        axis->setTickLabelColor(t.ink3);
        axis->setTickLabelFont(m_theme.ui(12));
        axis->setTickLabelPadding(4);
        axis->grid()->setPen(QPen(t.line, 1.0));
        axis->grid()->setZeroLinePen(Qt::NoPen);
    }
    refresh();
}

void SpotPlot::refresh()
{
    if (!isVisible()) {
        m_stale = true;
        return;
    }
    m_stale = false;
    const bool had = m_chosen.has_value();
    m_spots = m_study.accuracy() ? layOut() : std::vector<Spot>{};
    if (had) {
        // The same way again, as near as possible to where it was.
        const Spot *found = nullptr;
        for (const Spot &spot : m_spots) {
            if (!sameWay(rowOf(spot).way, m_chosenWay))
                continue;
            if (!found || std::abs(spot.place.x() - m_chosen->place.x()) <
                              std::abs(found->place.x() - m_chosen->place.x()))
                found = &spot;
        }
        m_chosen = found ? std::optional(*found) : std::nullopt;
    }
    replot(QCustomPlot::rpQueuedReplot);
}

QPointF SpotPlot::onScreen(QPointF place) const
{
    return {xAxis->coordToPixel(place.x()), yAxis->coordToPixel(place.y())};
}

const SpotPlot::Spot *SpotPlot::chosen() const
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

const SpotPlot::Spot *SpotPlot::nearest(QPointF at) const
{
    const Spot *best = nullptr;
    double least = reach;
    for (const Spot &spot : m_spots) {
        const double away = distance(onScreen(spot), at);
        if (away < least) {
            least = away;
            best = &spot;
        }
    }
    return best;
}

void SpotPlot::choose(const Spot *spot)
{
    if (spot) {
        m_chosenWay = rowOf(*spot).way;
        m_chosen = *spot;
    } else {
        m_chosen.reset();
    }
    update();
    emit chosenChanged();
    QAccessibleValueChangeEvent event(this, sentence());
    QAccessible::updateAccessibility(&event);
}

void SpotPlot::walk(int along, int across)
{
    if (m_spots.empty())
        return;
    if (!m_chosen) {
        const sim::AccuracyRow *used = m_study.inUse();
        const auto here = std::find_if(m_spots.begin(), m_spots.end(),
                                       [&](const Spot &spot) { return &rowOf(spot) == used; });
        choose(here == m_spots.end() ? &m_spots.front() : &*here);
        return;
    }
    const Spot from = *m_chosen;
    const QPointF at = onScreen(from);
    const Spot *best = nullptr;
    double least = 0.0;
    for (const Spot &spot : m_spots) {
        const QPointF there = onScreen(spot);
        const double ahead =
            along != 0 ? along * (there.x() - at.x()) : across * (there.y() - at.y()); // px on the way
        if (ahead <= 0.0 || (along != 0) != (spot.line == from.line))
            continue;
        // Up and Down look for what is straight ahead.
        const double cost = along != 0 ? ahead : ahead + 2.0 * std::abs(there.x() - at.x());
        if (!best || cost < least) {
            best = &spot;
            least = cost;
        }
    }
    if (best)
        choose(best);
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
        m_study.adopt(rowOf(*m_chosen).way);
}

bool SpotPlot::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool plain = (key->modifiers() & ~Qt::KeypadModifier) == Qt::NoModifier;
        if ((plain && (isWalk(key->key()) || isTake(key->key()))) || wantsKey(*key)) {
            event->accept();
            return true;
        }
    }
    return QCustomPlot::event(event);
}

void SpotPlot::keyPressEvent(QKeyEvent *event)
{
    if (key(*event))
        return;
    if (isTake(event->key())) {
        adopt();
        return;
    }
    if (!isWalk(event->key())) {
        QCustomPlot::keyPressEvent(event);
        return;
    }
    const int step = event->key() == Qt::Key_Left || event->key() == Qt::Key_Up ? -1 : 1;
    const bool isAlong = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right;
    walk(isAlong ? step : 0, isAlong ? 0 : step);
    showTip();
}

void SpotPlot::mouseMoveEvent(QMouseEvent *event)
{
    if (m_dragging) {
        drag(event->position());
        return;
    }
    const Spot *spot = nearest(event->position());
    const bool same = spot && m_chosen && spot->row == m_chosen->row && spot->place == m_chosen->place;
    if (!same && (spot || m_chosen)) {
        choose(spot);
        showTip();
    }
    setCursor(spot ? Qt::PointingHandCursor : cursorAt(event->position()));
}

void SpotPlot::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton)
        return;
    if (const Spot *spot = nearest(event->position())) {
        choose(spot);
        adopt();
        return;
    }
    m_dragging = press(event->position());
}

void SpotPlot::mouseReleaseEvent(QMouseEvent *)
{
    if (m_dragging)
        drop();
    m_dragging = false;
}

void SpotPlot::leaveEvent(QEvent *event)
{
    if (m_chosen && !hasFocus())
        choose(nullptr);
    QCustomPlot::leaveEvent(event);
}

void SpotPlot::focusInEvent(QFocusEvent *event)
{
    m_ringed = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason;
    QCustomPlot::focusInEvent(event);
    update();
}

void SpotPlot::focusOutEvent(QFocusEvent *event)
{
    m_ringed = false;
    QCustomPlot::focusOutEvent(event);
    choose(nullptr);
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

void SpotPlot::paintEvent(QPaintEvent *event)
{
    QCustomPlot::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_study.accuracy())
        draw(painter);
    if (!m_ringed)
        return;
    painter.setPen(QPen(m_theme.tokens().ink, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(2.0, 2.0, -2.0, -2.0), 6.0, 6.0);
}

}
