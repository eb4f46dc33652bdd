#include "app/ui/energy/energy_plot.h"

#include "app/ui/energy/energy_list.h"
#include "app/ui/plots/number_ticker.h"
#include "app/ui/theme/plot_axes.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using sim::Account;

constexpr int levels = 5;         ///< of a pile
constexpr double lostEdge = 0.72; ///< how much of its colour the edge of what was lost has

QColor faded(QColor color, int alpha)
{
    color.setAlpha(alpha);
    return color;
}

}

EnergyPlot::EnergyPlot(Session &session, const EnergyCourse &course, const Theme &theme, QWidget *parent)
    : CursorPlot(session, theme, parent), m_course(course)
{
    setObjectName("energyPlot");
    setAccessibleName(tr("Energy over the last frames"));
    setAccessibleDescription(tr("A press or a drag goes to a frame, and the arrow keys go on by one"));
    xAxis->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(5)));
    yAxis->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(4)));
    axisRect()->setMinimumMargins({40, 12, 12, 24}); // above: the cursor's head
    connect(&theme, &Theme::changed, this, &EnergyPlot::dress);
    dress();
}

void EnergyPlot::setShows(Shows what)
{
    m_shows = what;
    setAccessibleName(what == Shows::energy ? tr("Energy over the last frames")
                                            : tr("Momentum over the last frames"));
    dress();
}

void EnergyPlot::dress()
{
    const Tokens &t = m_theme.tokens();
    setBackground(t.panel);
    for (QCPAxis *axis : {xAxis, yAxis}) {
        dressAxis(*axis, m_theme);
        if (m_shows == Shows::momentum)
            axis->grid()->setZeroLinePen(QPen(t.line2, 1.0));
    }
    clearGraphs();
    m_lines.clear();
    for (QCPItemText *name : m_names)
        removeItem(name);
    m_names.clear();
    if (m_shows == Shows::energy)
        dressEnergy();
    else
        dressMomentum();
}

QCPGraph *EnergyPlot::line(const QPen &pen)
{
    QCPGraph *made = addGraph();
    made->setPen(pen);
    made->setAdaptiveSampling(false);
    m_lines.push_back(made);
    return made;
}

void EnergyPlot::dressEnergy()
{
    const Tokens &t = m_theme.tokens();
    const QColor colors[levels] = {t.spring, t.gravity, t.ghost, t.damping, t.contact};
    for (int i = 0; i < levels; ++i) {
        const bool isLost = i > 2;
        QCPGraph *level = line(curvePen(faint(colors[i], isLost ? lostEdge : 1.0, t.panel), 1.2));
        level->setBrush(faded(colors[i], isLost ? 90 : 205));
        if (i > 0)
            level->setChannelFillGraph(m_lines[static_cast<std::size_t>(i) - 1]);
    }
    QCPGraph *drift = line(QPen(t.past, 1.2));
    drift->setBrush(faded(t.past, 70));
    QCPGraph *hatch = line(Qt::NoPen);
    hatch->setBrush(driftBrush(m_theme));
    QCPGraph *given = line(QPen(t.ink, 1.4, Qt::DashLine));
    drift->setChannelFillGraph(given);
    hatch->setChannelFillGraph(given);
}

void EnergyPlot::dressMomentum()
{
    const Tokens &t = m_theme.tokens();
    line(QPen(t.ink, 1.6));
    line(QPen(t.ink2, 1.6, Qt::DashLine));
    line(QPen(t.past, 1.8));
    line(QPen(t.past, 1.8, Qt::DashLine));
    for (const QString &text : {tr("to the right"), tr("down")}) {
        auto *name = new QCPItemText(this);
        name->setText(text);
        name->setFont(m_theme.ui(12));
        name->setColor(t.ink2);
        name->setPositionAlignment(Qt::AlignRight | Qt::AlignBottom);
        name->setPadding({2, 0, 4, 2});
        m_names.push_back(name);
    }
}

EnergyPlot::Pile EnergyPlot::pileOf(const sim::Balance &balance, double lowest)
{
    const sim::Accounts<double> &energy = balance.energy;
    const double hit = energy[Account::impact];
    Pile pile;
    pile.tops[0] = balance.after.springs;
    pile.tops[1] = pile.tops[0] + balance.after.gravity - lowest;
    pile.tops[2] = pile.tops[1] + balance.after.moving;
    pile.tops[3] = pile.tops[2] - energy[Account::damping];
    pile.tops[4] = pile.tops[3] + std::max(0.0, -hit);
    pile.given = balance.before.total() - lowest + std::max(0.0, hit);
    for (const Account account :
         {Account::hand, Account::changes, Account::motors, Account::wind, Account::pulls, Account::sticks})
        pile.given += energy[account];
    return pile;
}

void EnergyPlot::drawEnergy(std::int64_t first, std::int64_t last, double lowest)
{
    double high = 0.0, low = 0.0;
    for (std::int64_t frame = first; frame <= last; frame += m_course.rowFrames()) {
        const Pile pile = pileOf(*m_course.at(frame), lowest);
        const auto x = static_cast<double>(frame);
        for (std::size_t i = 0; i < levels; ++i)
            m_lines[i]->addData(x, pile.tops[i]);
        m_lines[levels]->addData(x, pile.tops[levels - 1]);
        m_lines[levels + 1]->addData(x, pile.tops[levels - 1]);
        m_lines[levels + 2]->addData(x, pile.given);
        high = std::max({high, pile.given, pile.tops[levels - 1]});
        low = std::min({low, pile.given, pile.tops[0]});
    }
    const double span = high > low ? high - low : 1.0;
    yAxis->setRange(low < 0.0 ? low - 0.06 * span : 0.0, high + 0.08 * span);
}

void EnergyPlot::drawMomentum(std::int64_t first, std::int64_t last)
{
    double most = 0.0;
    for (std::int64_t frame = first; frame <= last; frame += m_course.rowFrames()) {
        const sim::Balance &balance = *m_course.at(frame);
        const sim::Vec2 all = balance.after.momentum, drift = balance.momentum[Account::drift];
        const double values[] = {all.x, all.y, drift.x, drift.y};
        for (std::size_t i = 0; i < 4; ++i) {
            m_lines[i]->addData(static_cast<double>(frame), values[i]);
            most = std::max(most, std::abs(values[i]));
        }
    }
    most = most > 1e-9 ? most : 1.0; // what is only rounding is a line at 0
    yAxis->setRange(-1.15 * most, 1.15 * most);
    for (std::size_t i = 0; i < m_names.size(); ++i) {
        const auto end = m_lines[i]->data()->constEnd() - 1;
        m_names[i]->position->setCoords(end->key, end->value);
    }
    // Where both end in one place, one name goes above the line, the other below it.
    const bool isUp = !m_names.empty() && m_names[0]->position->value() >= m_names[1]->position->value();
    for (std::size_t i = 0; i < m_names.size(); ++i)
        m_names[i]->setPositionAlignment(Qt::AlignRight |
                                         ((i == 0) == isUp ? Qt::AlignBottom : Qt::AlignTop));
}

void EnergyPlot::refresh(const EnergyLines &lines)
{
    for (QCPGraph *graph : m_lines)
        graph->data()->clear();
    const std::int64_t rows = m_course.rowFrames(), width = shownRows * rows;
    const std::int64_t at = m_session.timeline().cursor().frame;
    const std::int64_t right = std::min(m_course.last(), std::max(at, m_course.first() + width));
    const std::int64_t left = std::max(m_course.first(), right - width);
    const bool isCounted = right >= left && m_course.at(left) && m_course.at(right);
    for (QCPItemText *name : m_names)
        name->setVisible(isCounted);
    if (isCounted) {
        const auto start = static_cast<double>(left),
                   end = static_cast<double>(std::max(right, left + 10 * rows));
        xAxis->setRange(start, end + 0.02 * (end - start)); // room for a cursor at the end
        if (m_shows == Shows::energy)
            drawEnergy(left, right, lines.lowest());
        else
            drawMomentum(left, right);
    }
    m_lowest = lines.lowest();
    replot();
    announce();
}

std::vector<double> EnergyPlot::marked(std::int64_t frame) const
{
    const sim::Balance *balance = m_course.at(frame);
    if (!balance || !xAxis->range().contains(static_cast<double>(frame)))
        return {};
    if (m_shows == Shows::energy)
        return {pileOf(*balance, m_lowest).tops[2]};
    return {balance->after.momentum.x, balance->after.momentum.y};
}

void EnergyPlot::paintMarks(QPainter &painter) const
{
    const std::int64_t frame = m_session.timeline().cursor().frame;
    const double x = xAxis->coordToPixel(static_cast<double>(frame));
    paintCursor(painter, x);
    for (const double height : marked(frame))
        paintDot(painter, {x, yAxis->coordToPixel(height)});
}

void EnergyPlot::paintHovered(QPainter &painter, std::int64_t frame) const
{
    const std::vector<double> heights = marked(frame);
    if (heights.empty())
        return;
    const double x = xAxis->coordToPixel(static_cast<double>(frame));
    paintHoveredLine(painter, x);
    QPointF highest(x, axisRect()->bottom());
    for (const double height : heights) {
        const QPointF dot(x, yAxis->coordToPixel(height));
        paintHoveredDot(painter, dot);
        highest.setY(std::min(highest.y(), dot.y()));
    }
    paintTag(painter, highest, hoveredText(frame));
}

QString EnergyPlot::hoveredText(std::int64_t frame) const
{
    return marked(frame).empty() ? QString() : tr("frame %1: %2").arg(frame).arg(readout(frame));
}

QString EnergyPlot::readout(std::int64_t frame) const
{
    const sim::Balance *balance = m_course.at(frame);
    if (!balance)
        return {};
    if (m_shows == Shows::momentum)
        return tr("%1 to the right, %2 down")
            .arg(energyNumber(balance->after.momentum.x), energyNumber(balance->after.momentum.y));
    return tr("%1 there, drift %2")
        .arg(energyNumber(balance->after.total() - m_lowest),
             signedEnergyNumber(balance->energy[Account::drift]));
}

QString EnergyPlot::sentence() const
{
    const std::int64_t frame = m_session.timeline().cursor().frame;
    const QString numbers = readout(frame);
    if (numbers.isEmpty())
        return tr("%1: frame %2 is not counted").arg(title()).arg(frame);
    return tr("%1: %2 (%3) at frame %4").arg(title(), numbers, unit()).arg(frame);
}

QString EnergyPlot::unit() const
{
    return m_shows == Shows::energy ? energyUnit(m_session.timeline().state().spin.rows() > 0)
                                    : momentumUnit();
}

PlotPicture EnergyPlot::picture()
{
    return {tr("%1, %2").arg(accessibleName(), unit()),
            m_shows == Shows::energy ? tr("energy") : tr("momentum"), size(),
            [this](QCPPainter &painter) { paintPicture(painter); }};
}

std::optional<std::int64_t> EnergyPlot::frameAt(QPointF place) const
{
    const std::int64_t first = m_course.first(), rows = m_course.rowFrames();
    if (m_course.last() < first)
        return std::nullopt;
    const double frame =
        std::clamp(xAxis->pixelToCoord(place.x()), xAxis->range().lower, xAxis->range().upper);
    const double row = std::round((frame - static_cast<double>(first)) / static_cast<double>(rows));
    return std::clamp(first + static_cast<std::int64_t>(row) * rows, first, m_course.last());
}

}
