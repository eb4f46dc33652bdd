#include "app/ui/scene/hud/hud.h"

#include "app/model/picture/rest_marks.h"
#include "app/model/text/accuracy_text.h"
#include "app/model/text/numbers.h"
#include "app/model/text/phrases.h"
#include "app/model/text/scene_words.h"
#include "app/ui/scene/drawing/arrows.h"
#include "app/ui/scene/drawing/label_places.h"
#include "app/ui/scene/drawing/overlay_labels.h"
#include "app/ui/scene/hud/free_area.h"
#include "app/ui/scene/layers/reference_marks.h"
#include "sim/run/script/composed_interval.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

namespace {

struct HudText
{
    Q_DECLARE_TR_FUNCTIONS(HudText)
};

constexpr double margin = 20.0;
constexpr double lowest = 20.0;        ///< of the symbols in the bottom line, above the edge
constexpr double scaleHeight = 36.0;   ///< of the line with the scale
constexpr double longestScale = 150.0; ///< screen px
constexpr double besideScale = 10.0;   ///< between the scale and its text
constexpr double legendRow = 20.0;
constexpr double legendGap = 24.0;
constexpr double legendPadding = 6.0;
constexpr double legendAscent = 14.5; ///< from the baseline of the text to the top of its row
constexpr double legendCover = 0.9;   ///< opacity over the scene behind

/// Returns the longest of 1, 2, 5, 10, 20... scene px that is at most longestScale on the screen.
double scaleLength(double zoom)
{
    const double most = longestScale / zoom;
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    double best = power;
    for (const double step : std::array{1.0, 2.0, 5.0}) {
        if (step * power <= most)
            best = step * power;
    }
    return best;
}

QString plain(double value)
{
    return std::abs(value) < 1e6 ? QLocale().toString(value, 'g', 6) : roughNumber(value);
}

/// Returns the meaning of an arrow of the legend's length and, if it has just changed, its previous meaning.
QString scaleWords(const QString &text, const ArrowScale &scale)
{
    const QString words = text.arg(plain(scale.unit));
    return scale.before ? HudText::tr("%1 (before: %2)").arg(words, plain(*scale.before)) : words;
}

}

/// A symbol and its meaning.
struct Hud::Entry
{
    enum class Mark { pull, velocity, sum, comparison, onion, yours, reference, rest };
    Mark mark;
    double width;
    QString text;
    bool isNews = false; ///< has just changed
    QPointF at = {};     ///< the left end of the symbol, on the baseline of the text
};

/// Where the texts beside bodies are drawn. A text with an empty box is not drawn.
struct Hud::Labels
{
    QRectF card; ///< of the forces
    QRectF name; ///< of the selected body
    QRectF reference;
    std::vector<QRectF> taken; ///< these, and all that they avoid
};

std::vector<EdgeMarker> Hud::markers(const Camera &camera, QRectF view) const
{
    std::vector<QRectF> taken = bodyBoxes(m_shown, camera);
    taken.insert(taken.end(), {nameBox(m_shown, camera, view), m_shown.card});
    const std::vector<QRectF> words = wordBoxes(camera, view);
    taken.insert(taken.end(), words.begin(), words.end());
    return edgeMarkers(m_shown, camera, view, freeArea(m_shown, view).adjusted(4, 4, -4, -8),
                       std::move(taken));
}

std::vector<QRectF> Hud::wordBoxes(const Camera &camera, QRectF view) const
{
    std::vector<QRectF> boxes;
    for (const OverlayLabel &label : overlayLabels(m_shown, camera, m_theme, view))
        boxes.push_back(label.box);
    for (const SceneContent *figure : {&m_shown, &m_companion}) {
        QTransform moved = camera.toView;
        moved.translate(figure->shift.x, figure->shift.y);
        boxes.push_back(titleBox(*figure, Camera(moved)));
    }
    return boxes;
}

std::vector<QRectF> Hud::textBoxes(const Camera &camera, QRectF view) const
{
    std::vector<QRectF> boxes = wordBoxes(camera, view);
    const Labels placed = labels(camera, view, markers(camera, view));
    boxes.insert(boxes.end(), {placed.card, placed.name, placed.reference});
    return boxes;
}

std::vector<QRectF> Hud::takenBoxes(const Camera &camera, QRectF view,
                                    const std::vector<EdgeMarker> &outside) const
{
    std::vector<QRectF> taken = bodyBoxes(m_shown, camera);
    taken.push_back(m_shown.card);
    for (const Arrow &arrow : pullArrows(m_shown, camera, m_theme))
        taken.push_back(arrow.bounds());
    for (const EdgeMarker &marker : outside)
        taken.insert(taken.end(), {marker.head(), marker.label});
    const std::vector<QRectF> words = wordBoxes(camera, view);
    taken.insert(taken.end(), words.begin(), words.end());
    return taken;
}

Hud::Labels Hud::labels(const Camera &camera, QRectF view, const std::vector<EdgeMarker> &outside) const
{
    Labels placed;
    placed.taken = takenBoxes(camera, view, outside);
    if (hasCard(m_shown))
        placed.card = pullCardBox(m_shown, m_theme, camera, cardArea(m_shown, camera, view), placed.taken);
    placed.name = nameBox(m_shown, camera, view);
    placed.taken.insert(placed.taken.end(), {placed.card, placed.name});
    placed.reference =
        referenceLabelBox(m_shown, camera, freeArea(m_shown, view).adjusted(8, 28, -8, -44), placed.taken);
    placed.taken.push_back(placed.reference);
    return placed;
}

LabelPlaces Hud::labelPlaces(const Camera &camera, QRectF view) const
{
    std::vector<QLineF> strokes = explainingStrokes(m_shown, camera, m_theme);
    const std::vector<QLineF> links = linkLines(m_shown, camera);
    strokes.insert(strokes.end(), links.begin(), links.end());
    return LabelPlaces(labels(camera, view, markers(camera, view)).taken, std::move(strokes));
}

void Hud::draw(QPainter &painter, const Camera &camera, QRectF view) const
{
    if (m_shown.points() == 0)
        return;
    painter.setFont(m_shown.text);
    const std::vector<EdgeMarker> outside = markers(camera, view);
    drawEdgeMarkers(painter, m_shown, m_theme, outside);
    const Labels placed = labels(camera, view, outside);
    if (hasCard(m_shown))
        drawPullCard(painter, m_shown, m_theme, placed.card);
    drawName(painter, placed.name);
    drawReferenceLabel(painter, m_shown, m_theme, placed.reference);
    drawCaption(painter, camera, view);
    drawClock(painter, view);
    drawScale(painter, camera, view);
    drawLegend(painter, camera, view);
    if (m_shown.extras.ruler) {
        const QRectF scale(view.left(), view.bottom() - scaleHeight, scaleEnd(camera), scaleHeight);
        drawRuler({painter, m_shown, m_theme, camera, view}, m_shown.ruler, scale);
    }
    if (m_shown.focusVisible)
        drawFocus(painter, view);
}

void Hud::drawCaption(QPainter &painter, const Camera &camera, QRectF view) const
{
    if (m_shown.caption.isEmpty())
        return;
    painter.setFont(m_shown.text);
    painter.setPen(m_theme.tokens().ink2);
    painter.drawText(captionBox(m_shown, camera, view), Qt::TextWordWrap, m_shown.caption);
}

void Hud::drawClock(QPainter &painter, QRectF view) const
{
    if (!m_shown.extras.clock)
        return;
    painter.setFont(m_shown.figures);
    painter.setPen(m_theme.tokens().ink);
    const QRectF top = view.adjusted(margin, 12.0, -margin, 0.0);
    painter.drawText(top, Qt::AlignTop | Qt::AlignRight, m_shown.clock);
}

QColor Hud::captionInk() const
{
    const bool isPaper = m_shown.view().sky == lessons::View::Sky::paper;
    return isPaper ? m_theme.tokens().ink3 : m_theme.tokens().ink2;
}

double Hud::scaleEnd(const Camera &camera) const
{
    const double px = scaleLength(camera.zoom);
    return margin + 0.5 + std::round(px * camera.zoom) + besideScale +
           QFontMetricsF(m_shown.text).horizontalAdvance(pixels(plain(px)));
}

void Hud::drawScale(QPainter &painter, const Camera &camera, QRectF view) const
{
    const double px = scaleLength(camera.zoom);
    const double y = std::round(view.bottom() - lowest) - 0.5;
    const double x = margin + 0.5;
    const double end = x + std::round(px * camera.zoom);
    painter.setPen(QPen(captionInk(), 1.3, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(QPolygonF{{x, y - 4.0}, {x, y}, {end, y}, {end, y - 4.0}});
    painter.setFont(m_shown.text);
    painter.drawText(QPointF(end + besideScale, y + 2.5), pixels(plain(px)));
}

std::vector<Hud::Entry> Hud::legend() const
{
    std::vector<Entry> entries;
    if (m_shown.reference && m_shown.extras.reference) {
        entries.push_back({Entry::Mark::yours, 18.0, HudText::tr("your method")});
        entries.push_back({Entry::Mark::reference, 18.0,
                           HudText::tr("reference, ±%1").arg(pixels(m_shown.reference->uncertainty))});
    }
    if (m_shown.comparison && m_shown.extras.comparison)
        entries.push_back({Entry::Mark::comparison, 30.0, m_shown.comparisonName});
    if (!m_shown.onion.empty())
        entries.push_back({Entry::Mark::onion, 30.0, onionWords().arg(onionFrames)});
    if (m_shown.extras.rests && hasRests(m_shown.picture.interval->scene))
        entries.push_back({Entry::Mark::rest, 30.0, HudText::tr("rest length")});
    if (m_shown.hasVelocityArrows() && m_shown.scales.velocity.isUsed)
        entries.push_back({Entry::Mark::velocity, unitArrow + 8.0,
                           scaleWords(velocityScaleWords(), m_shown.scales.velocity),
                           m_shown.scales.velocity.before.has_value()});
    if (m_shown.hasPulls)
        entries.push_back({Entry::Mark::pull, unitArrow + 8.0,
                           scaleWords(pullScaleWords(), m_shown.scales.pull),
                           m_shown.scales.pull.before.has_value()});
    if (m_shown.hasSum())
        entries.push_back({Entry::Mark::sum, unitArrow + 2.0, sumWords(m_shown)});
    return entries;
}

QColor Hud::groundAt(const Camera &camera, double y) const
{
    const lessons::View &view = m_shown.view();
    const std::optional<double> floor = view.room ? std::optional(view.room->floor) : view.ground;
    const bool isBelow = floor && camera.at({0.0, *floor}).y() < y;
    return isBelow ? m_theme.tokens().win : m_theme.tokens().scene;
}

std::vector<Hud::Entry> Hud::placedLegend(const Camera &camera, QRectF view) const
{
    const QFontMetricsF metrics(m_shown.text);
    const double left = std::max(scaleEnd(camera) + legendGap, margin);
    double x = view.right() - margin;
    double y = std::round(view.bottom() - lowest) + 2.0;
    std::vector<Entry> entries = legend();
    std::reverse(entries.begin(), entries.end());
    for (Entry &entry : entries) {
        // In narrow views, a long name of a ghost is shortened, or it would cover the scale.
        const double most = view.right() - margin - left - entry.width;
        entry.text = metrics.elidedText(entry.text, Qt::ElideRight, most);
        const double width = entry.width + metrics.horizontalAdvance(entry.text);
        if (x - width < left) {
            x = view.right() - margin;
            y -= legendRow;
        }
        entry.at = {x - width, y};
        x -= width + legendGap;
    }
    return entries;
}

QRectF Hud::boxOf(const Entry &entry) const
{
    const double width = entry.width + QFontMetricsF(m_shown.text).horizontalAdvance(entry.text);
    return {entry.at.x() - legendPadding, entry.at.y() - legendAscent, width + 2.0 * legendPadding,
            legendRow};
}

QRectF Hud::legendBox(const Camera &camera, QRectF view) const
{
    QRectF box;
    for (const Entry &entry : placedLegend(camera, view))
        box |= boxOf(entry);
    return box;
}

void Hud::drawLegend(QPainter &painter, const Camera &camera, QRectF view) const
{
    const bool isPaper = m_shown.view().sky == lessons::View::Sky::paper;
    for (const Entry &entry : placedLegend(camera, view)) {
        if (isPaper) { // keeps arrows from crossing the text
            painter.setPen(Qt::NoPen);
            painter.setBrush(faded(groundAt(camera, entry.at.y()), legendCover));
            painter.drawRoundedRect(boxOf(entry), 4.0, 4.0);
            painter.setBrush(Qt::NoBrush);
        }
        drawEntry(painter, entry);
    }
}

void Hud::drawEntry(QPainter &painter, const Entry &entry) const
{
    const Tokens &t = m_theme.tokens();
    const QPointF mark = entry.at - QPointF(0.0, 4.5);
    switch (entry.mark) {
    case Entry::Mark::pull:
        drawArrow(painter, {mark, {unitArrow, 0.0}, {t.ink3, 2.0}}, t.scene);
        break;
    case Entry::Mark::velocity:
        drawArrow(painter, {mark, {unitArrow, 0.0}, velocityStyle(m_theme)}, t.scene);
        break;
    case Entry::Mark::sum:
        drawArrow(painter, {mark, {30.0, 0.0}, sumStyle(m_theme)}, t.scene);
        break;
    case Entry::Mark::comparison:
        painter.setPen(dashed(t.ghost, 2.0, {3.0, 4.0}));
        painter.drawLine(mark, mark + QPointF(22.0, 0.0));
        break;
    case Entry::Mark::yours:
        painter.setPen(Qt::NoPen);
        painter.setBrush(t.body);
        painter.drawEllipse(mark + QPointF(6.0, 0.0), 5.0, 5.0);
        painter.setBrush(Qt::NoBrush);
        break;
    case Entry::Mark::reference:
        drawReferenceMark(painter, m_theme, mark + QPointF(6.0, 0.0));
        break;
    case Entry::Mark::rest:
        painter.setPen(dashed(t.ink3, 1.2, {4.0, 3.0}));
        painter.drawLine(mark, mark + QPointF(20.0, 0.0));
        painter.setPen(QPen(t.ink3, 2.0, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(mark + QPointF(20.0, -6.0), mark + QPointF(20.0, 6.0));
        break;
    case Entry::Mark::onion:
        for (int i = 0; i < 3; ++i) {
            painter.setPen(QPen(faded(t.body, 0.2 + 0.15 * i), 1.2));
            painter.drawEllipse(mark + QPointF(5.0 + 6.0 * i, 0.0), 4.5, 4.5);
        }
        break;
    }
    painter.setFont(m_shown.text);
    painter.setPen(entry.isNews ? m_theme.tokens().ink : captionInk());
    painter.drawText(entry.at + QPointF(entry.width, 0.0), entry.text);
}

void Hud::drawName(QPainter &painter, QRectF box) const
{
    if (box.isEmpty())
        return;
    painter.setPen(QPen(m_theme.tokens().line2, 1.0));
    painter.setBrush(m_theme.tokens().scene);
    painter.drawRoundedRect(box, 5.0, 5.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(m_theme.tokens().body);
    painter.drawRoundedRect(QRectF(box.left() + 7.0, box.top() + 7.0, 6.0, 6.0), 1.5, 1.5);
    painter.setFont(m_shown.text);
    painter.setPen(m_theme.tokens().ink);
    painter.drawText(QPointF(box.left() + 18.0, box.top() + 14.0), selectedName(m_shown));
    painter.setBrush(Qt::NoBrush);
}

void Hud::drawFocus(QPainter &painter, QRectF view) const
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_theme.tokens().ink, 2.0));
    painter.drawRoundedRect(view.adjusted(2.0, 2.0, -2.0, -2.0), 6.0, 6.0);
}

}
