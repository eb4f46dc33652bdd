#include "app/ui/energy/energy_plot.h"

#include "app/ui/energy/energy_list.h"
#include "app/ui/plots/number_ticker.h"
#include "app/ui/theme/plot_axes.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using sim::Account;

constexpr int levels = 5; ///< of a pile

QColor faded(QColor color, int alpha)
{
    color.setAlpha(alpha);
    return color;
}

}

EnergyPlot::EnergyPlot(Session &session, const EnergyCourse &course, const Theme &theme, QWidget *parent)
    : QCustomPlot(parent), m_session(session), m_course(course), m_theme(theme),
      m_cursor(new QCPItemStraightLine(this))
{
    setObjectName("energyPlot");
    setPlottingHint(QCP::phImmediateRefresh, false); // in the middle of a change others cannot be painted yet
    setAccessibleName(tr("Energy over the last frames"));
    setToolTip(tr("Press or drag to go to a frame"));
    setCursor(Qt::PointingHandCursor);
    setAntialiasedElements(QCP::aeAll);
    setNoAntialiasingOnDrag(false);
    xAxis->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(5)));
    yAxis->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(4)));
    axisRect()->setMinimumMargins({40, 8, 12, 24});
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
    m_cursor->setPen(QPen(t.now, 2.0));
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
        QCPGraph *level = line(QPen(faded(colors[i], isLost ? 150 : 255), 1.2));
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
    const std::int64_t at = m_session.timeline().at().frame;
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
    const auto now = static_cast<double>(at);
    m_cursor->point1->setCoords(now, 0.0);
    m_cursor->point2->setCoords(now, 1.0);
    replot();
}

PlotPicture EnergyPlot::picture()
{
    const bool isEnergy = m_shows == Shows::energy;
    const QString unit = isEnergy ? energyUnit(m_session.timeline().now().spin.rows() > 0) : momentumUnit();
    return {tr("%1, %2").arg(accessibleName(), unit), isEnergy ? tr("energy") : tr("momentum"), size(),
            [this](QCPPainter &painter) { toPainter(&painter, width(), height()); }};
}

std::int64_t EnergyPlot::frameAt(double x) const
{
    const double frame = std::clamp(xAxis->pixelToCoord(x), xAxis->range().lower, xAxis->range().upper);
    return static_cast<std::int64_t>(std::lround(frame));
}

void EnergyPlot::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton && m_course.last() >= m_course.first())
        m_session.goTo({std::min(frameAt(event->position().x()), m_course.last()), 0});
}

void EnergyPlot::mouseMoveEvent(QMouseEvent *event)
{
    if ((event->buttons() & Qt::LeftButton) && m_course.last() >= m_course.first())
        m_session.goTo({std::min(frameAt(event->position().x()), m_course.last()), 0});
}

}
