#include "app/ui/energy/energy_plot.h"

#include "app/model/text/phrases.h"
#include "app/ui/energy/energy_list.h"
#include "app/ui/theme/colors.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using sim::Account;

constexpr int levels = 5;         ///< of a stack
constexpr double lostEdge = 0.72; ///< the share of its colour that the edge of a loss has

QColor faded(QColor color, int alpha)
{
    color.setAlpha(alpha);
    return color;
}

}

EnergyPlot::EnergyPlot(const OpenRun &run, Playback &playback, const EnergySeries &series, const Theme &theme,
                       QWidget *parent)
    : CursorPlot(run, playback, theme, parent), m_series(series)
{
    setObjectName("energyPlot");
    setAccessibleName(tr("Energy over the last frames"));
    setAccessibleDescription(tr("Click or drag to go to a frame; the arrow keys move by one frame"));
    axisRect()->setMinimumMargins({40, 12, 12, 24}); // above: the cursor's head
    applyTheme();
}

void EnergyPlot::setView(EnergyView view)
{
    m_view = view;
    setAccessibleName(view == EnergyView::energy ? tr("Energy over the last frames")
                                                 : tr("Momentum over the last frames"));
    applyTheme();
}

void EnergyPlot::applyTheme()
{
    CursorPlot::applyTheme();
    if (m_view == EnergyView::momentum) {
        for (QCPAxis *axis : {xAxis, yAxis})
            axis->grid()->setZeroLinePen(QPen(m_theme.tokens().line2, 1.0));
    }
    clearGraphs();
    m_lines.clear();
    for (QCPItemText *name : m_names)
        removeItem(name);
    m_names.clear();
    if (m_view == EnergyView::energy)
        makeEnergyLines();
    else
        makeMomentumLines();
}

QCPGraph *EnergyPlot::line(const QPen &pen)
{
    QCPGraph *made = addGraph();
    made->setPen(pen);
    made->setAdaptiveSampling(false);
    m_lines.push_back(made);
    return made;
}

void EnergyPlot::makeEnergyLines()
{
    const Tokens &t = m_theme.tokens();
    const QColor colors[levels] = {t.spring, t.gravity, t.ghost, t.damping, t.contact};
    for (int i = 0; i < levels; ++i) {
        const bool isLost = i > 2;
        QCPGraph *level = line(curvePen(mixed(t.panel, colors[i], isLost ? lostEdge : 1.0), 1.2));
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

void EnergyPlot::makeMomentumLines()
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

EnergyPlot::Stack EnergyPlot::stackOf(const sim::Balance &balance, double lowest)
{
    const sim::Accounts<double> &energy = balance.energy;
    const double hit = energy[Account::impact];
    Stack stack;
    stack.tops[0] = balance.after.springs;
    stack.tops[1] = stack.tops[0] + balance.after.gravity - lowest;
    stack.tops[2] = stack.tops[1] + balance.after.moving;
    stack.tops[3] = stack.tops[2] - energy[Account::damping];
    stack.tops[4] = stack.tops[3] + std::max(0.0, -hit);
    stack.given = balance.before.total() - lowest + std::max(0.0, hit);
    for (const Account account : {Account::hand, Account::changes, Account::motors, Account::wind,
                                  Account::rule, Account::pulls, Account::sticks})
        stack.given += energy[account];
    return stack;
}

void EnergyPlot::drawEnergy(std::int64_t first, std::int64_t last, double lowest)
{
    double high = 0.0, low = 0.0;
    for (std::int64_t frame = first; frame <= last; frame += m_series.framesPerOutput()) {
        const Stack stack = stackOf(*m_series.at(frame), lowest);
        const auto x = static_cast<double>(frame);
        for (std::size_t i = 0; i < levels; ++i)
            m_lines[i]->addData(x, stack.tops[i]);
        m_lines[levels]->addData(x, stack.tops[levels - 1]);
        m_lines[levels + 1]->addData(x, stack.tops[levels - 1]);
        m_lines[levels + 2]->addData(x, stack.given);
        high = std::max({high, stack.given, stack.tops[levels - 1]});
        low = std::min({low, stack.given, stack.tops[0]});
    }
    const double span = high > low ? high - low : 1.0;
    yAxis->setRange(low < 0.0 ? low - 0.06 * span : 0.0, high + 0.08 * span);
}

void EnergyPlot::drawMomentum(std::int64_t first, std::int64_t last)
{
    double most = 0.0;
    for (std::int64_t frame = first; frame <= last; frame += m_series.framesPerOutput()) {
        const sim::Balance &balance = *m_series.at(frame);
        const sim::Vec2 all = balance.after.momentum, drift = balance.momentum[Account::drift];
        const double values[] = {all.x, all.y, drift.x, drift.y};
        for (std::size_t i = 0; i < 4; ++i) {
            m_lines[i]->addData(static_cast<double>(frame), values[i]);
            most = std::max(most, std::abs(values[i]));
        }
    }
    most = most > 1e-9 ? most : 1.0; // rounding errors are a line at 0
    yAxis->setRange(-1.15 * most, 1.15 * most);
    for (std::size_t i = 0; i < m_names.size(); ++i) {
        const auto end = m_lines[i]->data()->constEnd() - 1;
        m_names[i]->position->setCoords(end->key, end->value);
    }
    // One name is above its line and the other below, because both lines may end in one place.
    const bool isUp = !m_names.empty() && m_names[0]->position->value() >= m_names[1]->position->value();
    for (std::size_t i = 0; i < m_names.size(); ++i)
        m_names[i]->setPositionAlignment(Qt::AlignRight |
                                         ((i == 0) == isUp ? Qt::AlignBottom : Qt::AlignTop));
}

void EnergyPlot::refresh(const EnergyLines &lines)
{
    for (QCPGraph *graph : m_lines)
        graph->data()->clear();
    const std::int64_t step = m_series.framesPerOutput(), width = mostOutputSteps * step;
    const std::int64_t at = cursorFrame();
    const std::int64_t right = std::min(m_series.last(), std::max(at, m_series.first() + width));
    const std::int64_t left = std::max(m_series.first(), right - width);
    const bool isCounted = right >= left && m_series.at(left) && m_series.at(right);
    for (QCPItemText *name : m_names)
        name->setVisible(isCounted);
    if (isCounted) {
        setTimeRange(static_cast<double>(left), static_cast<double>(std::max(right, left + 10 * step)));
        if (m_view == EnergyView::energy)
            drawEnergy(left, right, lines.lowest());
        else
            drawMomentum(left, right);
    }
    m_lowest = lines.lowest();
    replot();
    announceCursor();
}

std::vector<QPointF> EnergyPlot::curvesAt(std::int64_t frame) const
{
    const sim::Balance *balance = m_series.at(frame);
    const auto x = static_cast<double>(frame);
    if (!balance || !xAxis->range().contains(x))
        return {};
    if (m_view == EnergyView::energy)
        return {onScreen({x, stackOf(*balance, m_lowest).tops[2]})};
    return {onScreen({x, balance->after.momentum.x}), onScreen({x, balance->after.momentum.y})};
}

void EnergyPlot::paintMarks(QPainter &painter)
{
    paintCursor(painter, xAxis->coordToPixel(static_cast<double>(cursorFrame())));
    for (const QPointF dot : curvesAt(cursorFrame()))
        paintDot(painter, dot);
}

QString EnergyPlot::hoveredText(std::int64_t frame) const
{
    return curvesAt(frame).empty() ? QString() : labelled(frameName(frame), readout(frame));
}

QString EnergyPlot::readout(std::int64_t frame) const
{
    const sim::Balance *balance = m_series.at(frame);
    if (!balance)
        return {};
    if (m_view == EnergyView::momentum)
        return tr("%1 to the right, %2 down")
            .arg(energyNumber(balance->after.momentum.x), energyNumber(balance->after.momentum.y));
    return tr("%1 there, drift %2")
        .arg(energyNumber(balance->after.total() - m_lowest),
             signedEnergyNumber(balance->energy[Account::drift]));
}

QString EnergyPlot::sentence() const
{
    const std::int64_t frame = cursorFrame();
    const QString numbers = readout(frame);
    if (numbers.isEmpty())
        return tr("%1: frame %2 is not counted").arg(title()).arg(frame);
    return tr("%1: %2 (%3) at frame %4").arg(title(), numbers, unit()).arg(frame);
}

QString EnergyPlot::unit() const
{
    return m_view == EnergyView::energy ? energyUnit(m_run.timeline().state().spin.rows() > 0)
                                        : momentumUnit();
}

PlotPicture EnergyPlot::picture()
{
    return pictureNamed(listed(title(), unit()),
                        m_view == EnergyView::energy ? tr("energy") : tr("momentum"));
}

std::optional<std::int64_t> EnergyPlot::frameAt(QPointF place) const
{
    const std::int64_t first = m_series.first(), step = m_series.framesPerOutput();
    if (m_series.last() < first)
        return std::nullopt;
    const double steps = std::round((timeAt(place) - static_cast<double>(first)) / static_cast<double>(step));
    return std::clamp(first + static_cast<std::int64_t>(steps) * step, first, m_series.last());
}

}
