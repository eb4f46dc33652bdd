#include "app/ui/time/phase_strip.h"

#include "app/model/text/sentences.h"
#include "sim/run/script/composed_interval.h"

#include <QFontMetricsF>
#include <QPainterPath>
#include <QRegularExpression>

#include <algorithm>
#include <numeric>

namespace app {

namespace {

constexpr double arrowTip = 7.0;      ///< how far the current phase's arrow extends into the next phase
constexpr double markAndGap = 14.0;   ///< the square or tick before a name
constexpr double leastPadding = 12.0; ///< of a name, both sides together
constexpr double leastMark = 24.0;    ///< the width of a phase without its name, which still can be clicked
constexpr double captionLead = 10.0;
constexpr double corner = 7.0;

QString groupTitle(const sim::ComposedInterval &interval, const sim::Phase &phase)
{
    const std::vector<sim::Group> &groups = interval.scene.groups;
    const bool known = phase.group >= 0 && phase.group < static_cast<int>(groups.size());
    return known ? phrase(groups[static_cast<std::size_t>(phase.group)].title) : QString();
}

bool goesByGroups(const std::vector<sim::Phase> &phases)
{
    return std::any_of(phases.begin(), phases.end(),
                       [&](const sim::Phase &phase) { return phase.group != phases.front().group; });
}

QString withWidestDigits(QString text)
{
    static const QRegularExpression digit("\\d");
    return text.replace(digit, "0");
}

}

void PhaseStrip::setContent(const sim::ComposedInterval &interval, const Position &position)
{
    const std::vector<sim::Phase> &phases = interval.pipeline.phases;
    m_cells.clear();
    m_captions.clear();
    const QString step = stepOf(position);
    m_hasStep = !step.isEmpty();
    if (m_hasStep) {
        Position last = position;
        last.step = position.steps - 1;
        m_captions.push_back({step, withWidestDigits(stepOf(last))});
    }
    const bool byGroups = goesByGroups(phases);
    for (std::size_t i = 0; i < phases.size(); ++i) {
        Cell cell;
        cell.title = phrase(phases[i].title);
        cell.kind = phases[i].kind;
        const int index = static_cast<int>(i);
        if (index < position.done)
            cell.state = index == position.done - 1 ? State::now : State::done;
        if (byGroups) {
            cell.group = groupTitle(interval, phases[i]);
            cell.opensGroup = i == 0 || phases[i].group != phases[i - 1].group;
            if (cell.opensGroup)
                m_captions.push_back({cell.group, cell.group, 0, 0, !m_captions.empty()});
        }
        m_cells.push_back(std::move(cell));
    }
}

void PhaseStrip::measureCaptions(const Theme &theme)
{
    const QFontMetricsF metrics(theme.ui(11.5));
    for (Caption &caption : m_captions) {
        caption.isShown = true;
        caption.width = captionLead + metrics.horizontalAdvance(caption.widest);
    }
    if (m_hasStep)
        m_captions.front().width += captionLead;
}

/// Uses the bold font of the current phase for every phase. If all names fit, positions then stay the same
/// when the current phase changes.
double PhaseStrip::wantedWidth(const Cell &cell, const Theme &theme)
{
    return QFontMetricsF(theme.ui(12.5, QFont::DemiBold)).horizontalAdvance(cell.title) + markAndGap +
           leastPadding;
}

double PhaseStrip::roomBesideCaptions(double width, const Theme &theme)
{
    measureCaptions(theme);
    double needed = 0.0;
    for (const Cell &cell : m_cells)
        needed += cell.state == State::now ? std::max(leastMark, wantedWidth(cell, theme)) : leastMark;
    double room = width;
    for (const Caption &caption : m_captions)
        room -= caption.width;
    // Hides captions from the right, because the first one is the step's number, if there is one.
    for (auto caption = m_captions.rbegin(); caption != m_captions.rend() && room < needed; ++caption) {
        room += caption->width;
        caption->width = 0.0;
        caption->isShown = false;
    }
    return room;
}

bool PhaseStrip::showsNames() const
{
    return std::all_of(m_cells.begin(), m_cells.end(), [](const Cell &cell) { return cell.isNamed; });
}

std::vector<double> PhaseStrip::widths(double available, const Theme &theme)
{
    std::vector<double> wanted;
    for (const Cell &cell : m_cells)
        wanted.push_back(wantedWidth(cell, theme));
    const double count = static_cast<double>(m_cells.size());
    const double even = available / count;
    const double sum = std::accumulate(wanted.begin(), wanted.end(), 0.0);
    for (Cell &cell : m_cells)
        cell.isNamed = true;
    if (sum > available)
        return crowdedWidths(available, wanted);
    if (*std::max_element(wanted.begin(), wanted.end()) <= even)
        return std::vector<double>(m_cells.size(), even);
    for (double &width : wanted)
        width += (available - sum) / count;
    return wanted;
}

std::vector<double> PhaseStrip::crowdedWidths(double available, const std::vector<double> &wanted)
{
    std::vector<std::size_t> order(m_cells.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    // The current phase comes first, then the shortest names, so that as many names as possible are shown.
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        const bool isNowA = m_cells[a].state == State::now, isNowB = m_cells[b].state == State::now;
        return isNowA != isNowB ? isNowA : wanted[a] < wanted[b];
    });
    std::vector<double> widths(m_cells.size(),
                               std::min(leastMark, available / static_cast<double>(m_cells.size())));
    double spare = available - std::accumulate(widths.begin(), widths.end(), 0.0);
    for (const std::size_t i : order) {
        const double more = wanted[i] - widths[i];
        const bool isNow = m_cells[i].state == State::now;
        m_cells[i].isNamed = more <= spare || isNow;
        if (!m_cells[i].isNamed)
            continue;
        widths[i] += std::min(more, spare);
        spare -= std::min(more, spare);
    }
    for (double &width : widths)
        width += spare / static_cast<double>(widths.size());
    return widths;
}

void PhaseStrip::arrange(const QRectF &area, const Theme &theme)
{
    m_area = area;
    if (m_cells.empty())
        return;
    const std::vector<double> width = widths(roomBesideCaptions(area.width(), theme), theme);
    double x = area.left();
    auto caption = m_captions.begin();
    const auto place = [&] {
        caption->x = x;
        x += caption->width;
        ++caption;
    };
    if (m_hasStep)
        place();
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        if (m_cells[i].opensGroup)
            place();
        m_cells[i].area = QRectF(x, area.top(), width[i], area.height());
        x += width[i];
    }
}

int PhaseStrip::phaseAt(const QPointF &place) const
{
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        if (m_cells[i].area.contains(place))
            return static_cast<int>(i);
    }
    return -1;
}

QPainterPath PhaseStrip::outline(std::size_t index) const
{
    const QRectF area = m_cells[index].area;
    const double middle = area.center().y();
    const bool first = index == 0 && m_captions.empty();
    const bool last = index + 1 == m_cells.size();
    QPainterPath path;
    path.moveTo(area.left() + (first ? corner : 0), area.top());
    if (last) {
        path.lineTo(area.right() - corner, area.top());
        path.arcTo(QRectF(area.right() - 2 * corner, area.top(), 2 * corner, 2 * corner), 90, -90);
        path.arcTo(QRectF(area.right() - 2 * corner, area.bottom() - 2 * corner, 2 * corner, 2 * corner), 0,
                   -90);
    } else {
        path.lineTo(area.right(), area.top());
        path.lineTo(area.right() + arrowTip, middle);
        path.lineTo(area.right(), area.bottom());
    }
    if (first) {
        path.lineTo(area.left() + corner, area.bottom());
        path.arcTo(QRectF(area.left(), area.bottom() - 2 * corner, 2 * corner, 2 * corner), 270, -90);
        path.arcTo(QRectF(area.left(), area.top(), 2 * corner, 2 * corner), 180, -90);
    } else {
        path.lineTo(area.left(), area.bottom());
        path.lineTo(area.left() + arrowTip, middle);
    }
    path.closeSubpath();
    return path;
}

bool PhaseStrip::hasChevron(std::size_t index) const
{
    const bool last = index + 1 == m_cells.size();
    if (last || m_cells[index].state == State::now)
        return false;
    const Cell &next = m_cells[index + 1];
    return next.state != State::now && !next.opensGroup;
}

void PhaseStrip::paintCell(QPainter &painter, const Theme &theme, std::size_t index, bool playing) const
{
    const Tokens &t = theme.tokens();
    const Cell &cell = m_cells[index];
    const bool now = cell.state == State::now;
    const QFont font = theme.ui(12.5, now ? QFont::DemiBold : QFont::Medium);
    const QFontMetricsF metrics(font);
    // Only the current phase can be too narrow for its name.
    const QString name =
        metrics.elidedText(cell.title, Qt::ElideRight, std::max(0.0, cell.area.width() - markAndGap));
    const double nameWidth = cell.isNamed ? metrics.horizontalAdvance(name) : -6.0;
    const double aside = index == 0 && m_captions.empty() ? 0.0 : 3.0;
    const QPointF mark(cell.area.center().x() + aside - nameWidth / 2 - 3, cell.area.center().y() + 0.5);
    if (cell.state == State::done) {
        painter.setPen(QPen(t.ok, 1.7, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.setBrush(Qt::NoBrush);
        const QPointF tick[] = {mark + QPointF(-4, 0), mark + QPointF(-1.4, 2.6), mark + QPointF(3.6, -2.8)};
        painter.drawPolyline(tick, 3);
    } else {
        painter.setOpacity(now && !playing ? 1.0 : 0.75);
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme.kindColor(cell.kind));
        painter.drawRoundedRect(QRectF(mark.x() - 4, mark.y() - 4, 8, 8), 2, 2);
        painter.setOpacity(1.0);
    }
    if (!cell.isNamed)
        return;
    painter.setFont(font);
    painter.setPen(now ? t.nowText : cell.state == State::done ? t.ink : t.ink3);
    painter.drawText(mark + QPointF(10, 4), name);
}

void PhaseStrip::paint(QPainter &painter, const Theme &theme, bool playing, int hovered) const
{
    const Tokens &t = theme.tokens();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(t.line2);
    painter.setBrush(playing ? t.panel : t.scene);
    painter.drawRoundedRect(m_area.adjusted(0.5, 0, -0.5, 0), corner, corner);
    paintCaptions(painter, theme);
    paintShapes(painter, theme, hovered);
    for (std::size_t i = 0; i < m_cells.size(); ++i)
        paintCell(painter, theme, i, playing);
}

void PhaseStrip::paintCaptions(QPainter &painter, const Theme &theme) const
{
    const Tokens &t = theme.tokens();
    const auto rule = [&](double x) {
        painter.setPen(t.line2);
        painter.drawLine(QPointF(x + 0.5, m_area.top() + 0.5), QPointF(x + 0.5, m_area.bottom() - 0.5));
    };
    painter.setFont(theme.ui(11.5));
    for (const Caption &caption : m_captions) {
        if (caption.rule)
            rule(caption.x);
        if (!caption.isShown)
            continue;
        painter.setPen(t.ink3);
        painter.drawText(QPointF(caption.x + captionLead, m_area.top() + 17.5), caption.text);
    }
    if (m_hasStep && m_captions.size() == 1 && m_captions.front().isShown)
        rule(m_cells.front().area.left());
}

void PhaseStrip::paintShapes(QPainter &painter, const Theme &theme, int hovered) const
{
    const Tokens &t = theme.tokens();
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const bool now = m_cells[i].state == State::now;
        if (now || static_cast<int>(i) == hovered)
            painter.fillPath(outline(i), now ? t.now : t.hover);
        if (hasChevron(i)) {
            const QRectF area = m_cells[i].area;
            painter.setPen(QPen(t.line2, 1.3));
            painter.setBrush(Qt::NoBrush);
            const double middle = area.center().y() - 0.5;
            const QPointF chevron[] = {
                {area.right(), area.top() + 5.5}, {area.right() + 5, middle}, {area.right(), middle + 8}};
            painter.drawPolyline(chevron, 3);
        }
    }
}

}
