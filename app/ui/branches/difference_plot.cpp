#include "app/ui/branches/difference_plot.h"

#include "app/model/numbers.h"
#include "app/ui/plots/number_ticker.h"
#include "app/ui/theme/plot_axes.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double peakSize = 9.0; ///< px

}

DifferencePlot::DifferencePlot(Session &session, const DifferenceCourse &course, const Theme &theme,
                               QWidget *parent)
    : QCustomPlot(parent), m_session(session), m_course(course), m_theme(theme), m_line(addGraph()),
      m_peak(addGraph()), m_name(new QCPItemText(this)), m_cursor(new QCPItemStraightLine(this))
{
    setObjectName("differencePlot");
    setPlottingHint(QCP::phImmediateRefresh, false); // in the middle of a change others cannot be painted yet
    setAccessibleName(tr("Distance between the two runs over time"));
    setToolTip(tr("Press or drag to go to a frame"));
    setCursor(Qt::PointingHandCursor);
    setAntialiasedElements(QCP::aeAll);
    setNoAntialiasingOnDrag(false);
    for (QCPAxis *axis : {xAxis, yAxis})
        axis->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(5)));
    yAxis->ticker()->setTickCount(4);
    yAxis->setLabel(tr("px apart"));
    xAxis->setLabel(tr("frame"));
    axisRect()->setMinimumMargins({44, 10, 16, 24});
    m_peak->setLineStyle(QCPGraph::lsNone);
    m_name->setPadding({6, 0, 6, 2});
    connect(&theme, &Theme::changed, this, &DifferencePlot::dress);
    dress();
}

void DifferencePlot::dress()
{
    const Tokens &t = m_theme.tokens();
    setBackground(t.panel);
    for (QCPAxis *axis : {xAxis, yAxis}) {
        dressAxis(*axis, m_theme);
        axis->setLabelFont(m_theme.ui(12));
        axis->setLabelColor(t.ink3);
        axis->setLabelPadding(4);
    }
    m_line->setPen(QPen(t.ink, 1.6));
    m_peak->setScatterStyle({QCPScatterStyle::ssCircle, QPen(t.ink, 1.5), t.panel, peakSize});
    m_name->setFont(m_theme.ui(12));
    m_name->setColor(t.ink2);
    m_cursor->setPen(QPen(t.now, 2.0));
    refresh();
}

void DifferencePlot::refresh()
{
    const std::vector<Difference> &samples = m_course.samples();
    QVector<QCPGraphData> points;
    points.reserve(static_cast<int>(samples.size()));
    for (const Difference &one : samples)
        points.push_back({static_cast<double>(one.frame), one.distance});
    m_line->data()->set(points, true);
    const auto start = static_cast<double>(m_course.shared());
    const double end =
        std::max(samples.empty() ? 0.0 : static_cast<double>(samples.back().frame), start + 10.0);
    xAxis->setRange(start, end + 0.02 * (end - start)); // room for a cursor at the end
    markLargest();
    const auto now = static_cast<double>(m_session.timeline().at().frame);
    m_cursor->setVisible(xAxis->range().contains(now));
    m_cursor->point1->setCoords(now, 0.0);
    m_cursor->point2->setCoords(now, 1.0);
    replot();
}

void DifferencePlot::markLargest()
{
    const Difference *largest = m_course.largest();
    m_peak->data()->clear();
    const bool isSeen = largest && largest->distance > 0.0;
    m_name->setVisible(isSeen);
    yAxis->setRange(0.0, isSeen ? 1.25 * largest->distance : 1.0);
    if (!isSeen)
        return;
    const auto frame = static_cast<double>(largest->frame);
    m_peak->addData(frame, largest->distance);
    m_name->setText(tr("%1\u2009px").arg(roughNumber(largest->distance)));
    m_name->position->setCoords(frame, largest->distance);
    const bool isLeft = frame < xAxis->range().center();
    m_name->setPositionAlignment((isLeft ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignBottom);
}

std::int64_t DifferencePlot::frameAt(double x) const
{
    const double frame = std::clamp(xAxis->pixelToCoord(x), xAxis->range().lower, xAxis->range().upper);
    return std::min(static_cast<std::int64_t>(std::lround(frame)),
                    std::max(m_course.shared(), m_course.end()));
}

void DifferencePlot::goTo(double x)
{
    if (m_course.samples().empty())
        return;
    m_session.pause();
    m_session.goTo({frameAt(x), 0});
}

void DifferencePlot::mousePressEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        goTo(event->position().x());
}

void DifferencePlot::mouseMoveEvent(QMouseEvent *event)
{
    if (event->buttons() & Qt::LeftButton)
        goTo(event->position().x());
}

}
