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
    : CursorPlot(session, theme, parent), m_course(course), m_line(addGraph()), m_peak(addGraph()),
      m_name(new QCPItemText(this))
{
    setObjectName("differencePlot");
    setAccessibleName(tr("Distance between the two runs over time"));
    for (QCPAxis *axis : {xAxis, yAxis})
        axis->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(5)));
    yAxis->ticker()->setTickCount(4);
    yAxis->setLabel(tr("px apart"));
    xAxis->setLabel(tr("frame"));
    axisRect()->setMinimumMargins({44, 12, 16, 24}); // above: the cursor's head
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
    replot();
    announce();
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

std::optional<std::int64_t> DifferencePlot::frameAt(QPointF place) const
{
    if (m_course.samples().empty())
        return std::nullopt;
    const double frame =
        std::clamp(xAxis->pixelToCoord(place.x()), xAxis->range().lower, xAxis->range().upper);
    return std::min(static_cast<std::int64_t>(std::lround(frame)),
                    std::max(m_course.shared(), m_course.end()));
}

const Difference *DifferencePlot::nearest(std::int64_t frame) const
{
    const std::vector<Difference> &samples = m_course.samples();
    if (samples.empty())
        return nullptr;
    const auto after =
        std::lower_bound(samples.begin(), samples.end(), frame,
                         [](const Difference &one, std::int64_t at) { return one.frame < at; });
    if (after == samples.begin())
        return &*after;
    const auto before = after - 1;
    return after == samples.end() || frame - before->frame <= after->frame - frame ? &*before : &*after;
}

QPointF DifferencePlot::placeOf(const Difference &one) const
{
    return {xAxis->coordToPixel(static_cast<double>(one.frame)), yAxis->coordToPixel(one.distance)};
}

void DifferencePlot::paintMarks(QPainter &painter) const
{
    const std::int64_t frame = m_session.timeline().cursor().frame;
    paintCursor(painter, xAxis->coordToPixel(static_cast<double>(frame)));
    const Difference *here = nearest(frame);
    if (here && here->frame == frame)
        paintDot(painter, placeOf(*here));
}

void DifferencePlot::paintHovered(QPainter &painter, std::int64_t frame) const
{
    const Difference *there = nearest(frame);
    if (!there || !xAxis->range().contains(static_cast<double>(frame)))
        return;
    const QPointF dot = placeOf(*there);
    paintHoveredLine(painter, dot.x());
    paintHoveredDot(painter, dot);
    paintTag(painter, dot, hoveredText(frame));
}

QString DifferencePlot::hoveredText(std::int64_t frame) const
{
    const Difference *there = nearest(frame);
    return there ? tr("frame %1: %2\u2009px apart").arg(there->frame).arg(roughNumber(there->distance))
                 : QString();
}

PlotPicture DifferencePlot::picture()
{
    return {tr("%1, px").arg(accessibleName()), accessibleName(), size(),
            [this](QCPPainter &painter) { paintPicture(painter); }};
}

QString DifferencePlot::sentence() const
{
    const std::int64_t frame = m_session.timeline().cursor().frame;
    const Difference *here = nearest(frame);
    if (!here || here->frame != frame)
        return accessibleDescription();
    return tr("%1: %2\u2009px at frame %3").arg(title(), roughNumber(here->distance)).arg(frame);
}

}
