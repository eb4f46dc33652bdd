#include "app/model/series/plot_series.h"

#include <algorithm>

namespace app {

PlotSeries::PlotSeries(const OpenRun &run, const Playback &playback, const ComparisonRuns &comparisons,
                       QObject *parent)
    : QObject(parent), m_run(run), m_playback(playback), m_comparisons(comparisons),
      m_idleTask([this] { return readNext(); }, [this] { announce(); })
{
    run.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::selection | ChangeKind::cursor, this,
                 &PlotSeries::follow);
}

void PlotSeries::setActive(bool isActive)
{
    m_isActive = isActive;
    if (!isActive) {
        m_idleTask.stop();
        m_isStale = true;
    } else if (m_isStale) {
        restart();
    }
}

void PlotSeries::setQuantities(std::vector<Quantity> quantities)
{
    if (quantities == m_quantities)
        return;
    m_quantities = std::move(quantities);
    restart();
}

void PlotSeries::setMostSteps(std::int64_t steps)
{
    steps = std::clamp(steps, PlotWindow::leastSteps, allSteps);
    if (steps == m_mostSteps)
        return;
    m_mostSteps = steps;
    followCursor();
    announce();
}

std::size_t PlotSeries::columnOf(const Quantity &quantity) const
{
    const auto found = std::find(m_quantities.begin(), m_quantities.end(), quantity);
    return static_cast<std::size_t>(found - m_quantities.begin());
}

std::vector<Quantity> PlotSeries::allBound() const
{
    std::vector<Quantity> all = m_quantities;
    for (Quantity &one : all)
        one = bound(one);
    return all;
}

void PlotSeries::restart()
{
    m_isStale = !m_isActive;
    if (m_isStale)
        return;
    const sim::Timeline &timeline = m_run.timeline();
    m_framesPerOutput = timeline.track().framesPerOutput();
    m_window =
        windowAfter(m_window, {timeline.cursor().frame, timeline.computed(), m_framesPerOutput, m_mostSteps});
    const std::int64_t stride = strideOf(m_window, m_framesPerOutput, mostBuckets);
    m_runSampler = RunSampler(allBound(), m_window.first, m_framesPerOutput, stride);
    restartComparison();
    announce();
    fill();
}

void PlotSeries::announce()
{
    ++m_revision;
    emit changed();
}

void PlotSeries::restartComparison()
{
    ++m_comparisonRevision;
    const sim::Track *comparison = m_run.timeline().comparison();
    const bool fits = comparison && comparison->framesPerOutput() == m_framesPerOutput;
    m_comparisonScript = fits ? shownBranch() : nullptr;
    m_comparisonSampler =
        fits ? RunSampler(allBound(), comparisonStart(), m_framesPerOutput, m_runSampler.samples().stride())
             : RunSampler();
}

std::int64_t PlotSeries::comparisonStart() const
{
    // Start at the last shared moment, so that the two curves meet.
    const std::int64_t wide = strideOf(m_window, m_framesPerOutput, mostBuckets) * m_framesPerOutput;
    const std::int64_t fork = std::max<std::int64_t>(0, m_run.timeline().forkFrame() - m_framesPerOutput);
    return std::max(m_window.first, fork / wide * wide);
}

std::shared_ptr<const sim::Script> PlotSeries::shownBranch() const
{
    const Branch *shown = m_comparisons.shown();
    return shown && m_run.timeline().comparison() ? shown->script : nullptr;
}

void PlotSeries::follow(const Change &change)
{
    if (change.isAny(ChangeKind::step) || change.firstFrame == 0 ||
        (change.isAny(ChangeKind::selection) && followsSelection()))
        restart();
    else if (change.isAny(ChangeKind::run))
        dropFrom(change.firstFrame);
    else if (change.isAny(ChangeKind::cursor))
        followCursor();
}

void PlotSeries::dropFrom(std::int64_t frame)
{
    if (!m_isActive) {
        m_isStale = true;
        return;
    }
    m_runSampler.forgetAfter(frame - 1);
    if (m_comparisonScript != shownBranch())
        restartComparison();
    moveWindow();
    announce();
    fill();
}

bool PlotSeries::followsSelection() const
{
    return std::any_of(m_quantities.begin(), m_quantities.end(), [](const Quantity &one) {
        return aboutOf(one.what) != About::run && one.body.isEmpty();
    });
}

void PlotSeries::move(RunSampler &sampler, std::int64_t first, std::int64_t stride)
{
    const Samples &samples = sampler.samples();
    const std::int64_t wide = samples.stride() * m_framesPerOutput;
    const bool goesOn = first >= samples.firstFrame() && first <= samples.nextFrame() &&
                        (first - samples.firstFrame()) % wide == 0;
    if (!goesOn || stride < samples.stride()) {
        sampler = RunSampler(allBound(), first, m_framesPerOutput, stride);
        return;
    }
    sampler.forgetBefore(first);
    while (sampler.samples().stride() < stride)
        sampler.thin();
}

bool PlotSeries::moveWindow()
{
    const sim::Timeline &timeline = m_run.timeline();
    const PlotWindow next =
        windowAfter(m_window, {timeline.cursor().frame, timeline.computed(), m_framesPerOutput, m_mostSteps});
    if (next == m_window)
        return false;
    m_window = next;
    const std::int64_t stride = strideOf(m_window, m_framesPerOutput, mostBuckets);
    move(m_runSampler, m_window.first, stride);
    if (m_comparisonScript) {
        ++m_comparisonRevision;
        move(m_comparisonSampler, comparisonStart(), stride);
    }
    return true;
}

void PlotSeries::followCursor()
{
    if (!m_isActive)
        return;
    if (moveWindow())
        announce();
    if (m_playback.isPlaying())
        fill();
    else
        m_idleTask.runWhileMoved();
}

std::int64_t PlotSeries::endOf(const sim::Track &track) const
{
    return std::min(track.computed(), m_window.last);
}

bool PlotSeries::readNext()
{
    if (!m_isActive || m_quantities.empty())
        return false;
    const sim::Timeline &timeline = m_run.timeline();
    if (m_runSampler.samples().nextFrame() <= endOf(timeline.track())) {
        m_runSampler.readNext(timeline.track());
        return true;
    }
    const sim::Track *comparison = m_comparisonScript ? timeline.comparison() : nullptr;
    if (!comparison || m_comparisonSampler.samples().nextFrame() > endOf(*comparison))
        return false;
    ++m_comparisonRevision;
    m_comparisonSampler.readNext(*comparison);
    return true;
}

}
