#include "app/ui/accuracy/study_plot.h"

#include "app/model/analysis/accuracy_rows.h"
#include "app/model/text/accuracy_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace app {

namespace {

constexpr double reach = 12.0; ///< px round the pointer in which a spot is found

}

StudyPlot::StudyPlot(AccuracyStudy &study, const Theme &theme, QWidget *parent)
    : SpotPlot(theme, parent), m_study(study)
{
    m_errorTicks = makeLogarithmic(*yAxis);
    setErrors({});
    axisRect()->setAutoMargins(QCP::msNone);
    axisRect()->setMargins({66, 12, 16, 44});
    connect(&study, &AccuracyStudy::changed, this, &StudyPlot::refresh);
    connect(this, &SpotPlot::chosenChanged, this, [this] {
        if (chosen())
            m_chosenSetup = rowOf(*chosen()).setup;
    });
    applyTheme();
}

void StudyPlot::applyTheme()
{
    SpotPlot::applyTheme();
    m_axesAreOld = true;
    refresh();
}

void StudyPlot::setShown(const ShownMethods &shown)
{
    if (shown == m_shown)
        return;
    m_shown = shown;
    refresh();
}

void StudyPlot::refresh()
{
    if (!isVisible()) {
        m_isStale = true;
        choose(std::nullopt); // its row may be gone
        return;
    }
    m_isStale = false;
    const QCPRange across = xAxis->range();
    const QCPRange up = yAxis->range();
    m_spots = m_study.accuracy() ? layOut() : std::vector<Spot>{};
    keepChosen(chosenInNewLayout());
    // Painting the axes takes more time than everything else, so that they are painted only where they have changed.
    if (std::exchange(m_axesAreOld, false) || xAxis->range() != across || yAxis->range() != up)
        replot(QCustomPlot::rpQueuedReplot);
    else
        update();
    m_namesAreOld = true;
}

/// Returns the spot of the same method and step, as near as possible to where it was.
std::optional<Spot> StudyPlot::chosenInNewLayout() const
{
    std::optional<Spot> nearest;
    for (const Spot &spot : m_spots) {
        if (!chosen() || !sameSetup(rowOf(spot).setup, m_chosenSetup))
            continue;
        const auto distance = [&](const Spot &one) { return std::abs(one.place.x() - chosen()->place.x()); };
        if (!nearest || distance(spot) < distance(*nearest))
            nearest = spot;
    }
    return nearest;
}

void StudyPlot::setErrors(const ErrorScale &errors)
{
    m_errors = errors;
    m_errorTicks->setLowest(errors.lowest);
    yAxis->setRange(errors.lower, errors.upper);
}

std::vector<StudyPlot::Line> StudyPlot::lines() const
{
    std::vector<Line> all;
    for (const Spot &spot : m_spots) {
        if (rowOf(spot).outcome != sim::Outcome::measured)
            continue;
        if (all.empty() || all.back().front()->line != spot.line)
            all.emplace_back();
        all.back().push_back(&spot);
    }
    return all;
}

QPolygonF StudyPlot::onScreen(const Line &line) const
{
    QPolygonF places;
    for (const Spot *spot : line)
        places << onScreen(*spot);
    return places;
}

MethodColors StudyPlot::inkOf(const Spot &spot) const
{
    return app::inkOf(*rowOf(spot).setup.method, m_theme);
}

const Spot *StudyPlot::spotInUse() const
{
    const sim::AccuracyRow *used = m_study.inUse();
    const auto found =
        std::find_if(m_spots.begin(), m_spots.end(), [&](const Spot &spot) { return &rowOf(spot) == used; });
    return found == m_spots.end() ? nullptr : &*found;
}

std::optional<Spot> StudyPlot::spotAt(QPointF place) const
{
    std::optional<Spot> nearest;
    double least = reach;
    for (const Spot &spot : m_spots) {
        const QPointF off = onScreen(spot) - place;
        const double distance = std::hypot(off.x(), off.y());
        if (distance < least) {
            least = distance;
            nearest = spot;
        }
    }
    return nearest;
}

/// Left and Right stay on a line; Up and Down go to another line, preferably straight ahead.
std::optional<Spot> StudyPlot::spotBeyond(QPoint step) const
{
    if (m_spots.empty())
        return std::nullopt;
    if (!chosen())
        return spotInUse() ? *spotInUse() : m_spots.front();
    const bool isAlong = step.x() != 0;
    const QPointF from = onScreen(*chosen());
    std::optional<Spot> best;
    double least = 0.0;
    for (const Spot &spot : m_spots) {
        const QPointF off = onScreen(spot) - from;
        const double ahead = isAlong ? step.x() * off.x() : step.y() * off.y();
        if (ahead <= 0.0 || isAlong != (spot.line == chosen()->line))
            continue;
        const double cost = isAlong ? ahead : ahead + 2.0 * std::abs(off.x());
        if (!best || cost < least) {
            best = spot;
            least = cost;
        }
    }
    return best;
}

void StudyPlot::use(const Spot &spot)
{
    m_study.adopt(rowOf(spot).setup);
}

QString StudyPlot::tipOf(const Spot &spot) const
{
    return rowWords(rowOf(spot));
}

QString StudyPlot::overview() const
{
    return tr("Points: %1. The arrow keys go through them, and Enter uses one.").arg(m_spots.size());
}

void StudyPlot::showEvent(QShowEvent *event)
{
    SpotPlot::showEvent(event);
    if (m_isStale)
        refresh();
}

void StudyPlot::resizeEvent(QResizeEvent *event)
{
    SpotPlot::resizeEvent(event);
    refresh(); // room for labels is counted in px
}

void StudyPlot::mouseMoveEvent(QMouseEvent *event)
{
    const std::optional<Spot> before = chosen();
    SpotPlot::mouseMoveEvent(event);
    if (chosen() != before)
        showTip();
}

QString StudyPlot::nameOf(const sim::Method &method) const
{
    return methodTitle(method);
}

LabelPlaces StudyPlot::takenPlaces() const
{
    std::vector<QLineF> strokes;
    for (const Line &line : lines())
        addStrokes(strokes, onScreen(line));
    return LabelPlaces({}, std::move(strokes));
}

LabelPlaces StudyPlot::placeNames()
{
    std::vector<EndLabel> labels;
    for (const Line &line : lines()) {
        const Spot &end = *line.back();
        labels.push_back({onScreen(end), nameOf(*rowOf(end).setup.method), inkOf(end).color});
    }
    LabelPlaces places = takenPlaces();
    m_names = placeEndLabels(std::move(labels), m_theme.ui(12, QFont::Medium), axisRect()->rect(), places);
    return places;
}

void StudyPlot::paintMarks(QPainter &painter)
{
    if (!m_study.accuracy())
        return;
    drawFloor(painter);
    if (std::exchange(m_namesAreOld, false))
        placeNames();
    AxisNames names = axisNames();
    names.lessUp = tr("← more accurate");
    drawAxisNames(painter, axisRect()->rect(), names, m_theme);
    painter.save();
    drawLines(painter);
    painter.restore();
    drawEndLabels(painter, m_names, m_theme.ui(12, QFont::Medium), m_theme.tokens().panel);
    drawOver(painter);
    if (chosen())
        drawRing(painter, onScreen(*chosen()), QPen(m_theme.tokens().ink, 2.0), markerSize());
}

/// Draws where errors of exactly 0 are: below the numbers of the axis, separated from them by a gap.
void StudyPlot::drawFloor(QPainter &painter) const
{
    if (m_errors.floor <= 0.0)
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

QByteArray StudyPlot::numbers() const
{
    return m_study.accuracy() ? numbersOf(*m_study.accuracy()) : QByteArray();
}

QByteArray StudyPlot::numbersOf(const sim::Accuracy &accuracy) const
{
    return accuracyRows(accuracy);
}

}
