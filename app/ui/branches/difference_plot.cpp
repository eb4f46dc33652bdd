#include "app/ui/branches/difference_plot.h"

#include "app/model/text/numbers.h"
#include "app/model/text/phrases.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double peakSize = 9.0; ///< px

}

DifferencePlot::DifferencePlot(const OpenRun &run, Playback &playback, const DifferenceSeries &series,
                               const Theme &theme, QWidget *parent)
    : CursorPlot(run, playback, theme, parent), m_series(series), m_line(addGraph()), m_peak(addGraph()),
      m_name(new QCPItemText(this))
{
    setObjectName("differencePlot");
    setAccessibleName(tr("Distance between the two runs over time"));
    yAxis->setLabel(tr("px apart"));
    xAxis->setLabel(frameHeading());
    axisRect()->setMinimumMargins({44, 12, 16, 24}); // above: the cursor's head
    m_peak->setLineStyle(QCPGraph::lsNone);
    m_name->setPadding({6, 0, 6, 2});
    applyTheme();
}

void DifferencePlot::applyTheme()
{
    CursorPlot::applyTheme();
    const Tokens &t = m_theme.tokens();
    for (QCPAxis *axis : {xAxis, yAxis}) {
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
    const std::vector<Difference> &samples = m_series.samples();
    QVector<QCPGraphData> points;
    points.reserve(static_cast<int>(samples.size()));
    for (const Difference &one : samples)
        points.push_back({static_cast<double>(one.frame), one.distance});
    m_line->data()->set(points, true);
    const auto start = static_cast<double>(m_series.shared());
    setTimeRange(start,
                 std::max(samples.empty() ? 0.0 : static_cast<double>(samples.back().frame), start + 10.0));
    markLargest();
    replot();
    announceCursor();
}

void DifferencePlot::markLargest()
{
    const Difference *largest = m_series.largest();
    m_peak->data()->clear();
    const bool isSeen = largest && largest->distance > 0.0;
    m_name->setVisible(isSeen);
    yAxis->setRange(0.0, isSeen ? 1.25 * largest->distance : 1.0);
    if (!isSeen)
        return;
    const auto frame = static_cast<double>(largest->frame);
    m_peak->addData(frame, largest->distance);
    m_name->setText(pixels(roughNumber(largest->distance)));
    m_name->position->setCoords(frame, largest->distance);
    const bool isLeft = frame < xAxis->range().center();
    m_name->setPositionAlignment((isLeft ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignBottom);
}

std::optional<std::int64_t> DifferencePlot::frameAt(QPointF place) const
{
    if (m_series.samples().empty())
        return std::nullopt;
    return std::min(static_cast<std::int64_t>(std::lround(timeAt(place))),
                    std::max(m_series.shared(), m_series.end()));
}

const Difference *DifferencePlot::nearest(std::int64_t frame) const
{
    const std::vector<Difference> &samples = m_series.samples();
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
    return onScreen({static_cast<double>(one.frame), one.distance});
}

const Difference *DifferencePlot::atCursor() const
{
    const Difference *here = nearest(cursorFrame());
    return here && here->frame == cursorFrame() ? here : nullptr;
}

void DifferencePlot::paintMarks(QPainter &painter)
{
    paintCursor(painter, xAxis->coordToPixel(static_cast<double>(cursorFrame())));
    if (const Difference *here = atCursor())
        paintDot(painter, placeOf(*here));
}

std::vector<QPointF> DifferencePlot::curvesAt(std::int64_t frame) const
{
    const Difference *there = nearest(frame);
    if (!there || !xAxis->range().contains(static_cast<double>(frame)))
        return {};
    return {placeOf(*there)};
}

QString DifferencePlot::hoveredText(std::int64_t frame) const
{
    const Difference *there = nearest(frame);
    return there ? tr("frame %1: %2\u2009px apart").arg(there->frame).arg(roughNumber(there->distance))
                 : QString();
}

PlotPicture DifferencePlot::picture()
{
    return pictureNamed(tr("%1, px").arg(title()), title());
}

QString DifferencePlot::sentence() const
{
    const Difference *here = atCursor();
    return here
               ? tr("%1: %2\u2009px at frame %3").arg(title(), roughNumber(here->distance)).arg(cursorFrame())
               : accessibleDescription();
}

}
