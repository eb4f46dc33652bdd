#include "app/model/series/difference_series.h"

#include "app/model/text/numbers.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>
#include <numeric>

namespace app {

DifferenceSeries::DifferenceSeries(const OpenRun &run, const ComparisonRuns &comparisons, QObject *parent)
    : QObject(parent), m_run(run), m_comparisons(comparisons),
      m_idleTask([this] { return addSample(); }, [this] { emit changed(); })
{
    run.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::selection | ChangeKind::cursor, this,
                 &DifferenceSeries::follow);
}

void DifferenceSeries::setActive(bool isActive)
{
    if (isActive == m_isActive)
        return;
    m_isActive = isActive;
    if (isActive)
        restart();
    else
        m_idleTask.stop();
}

void DifferenceSeries::setOf(Of of)
{
    m_of = of;
    restart();
}

std::int64_t DifferenceSeries::end() const
{
    const sim::Timeline &timeline = m_run.timeline();
    return timeline.comparison() ? std::min(timeline.computed(), timeline.comparison()->computed()) : 0;
}

void DifferenceSeries::restart()
{
    m_samples.clear();
    m_largest = {};
    m_branch.reset();
    m_one.reset();
    m_other.reset();
    const sim::Timeline &timeline = m_run.timeline();
    if (m_isActive && isComparing() && m_comparisons.shown()) {
        m_branch = m_comparisons.shown()->script;
        m_shared = lastShared(timeline.script(), *m_branch);
        m_leastSpacing =
            std::lcm(timeline.track().framesPerOutput(), timeline.comparison()->framesPerOutput());
        m_spacing = m_leastSpacing;
        m_next = m_shared / m_leastSpacing * m_leastSpacing;
        m_isTooLarge = false;
    }
    emit changed();
    m_idleTask.run();
}

void DifferenceSeries::follow(const Change &change)
{
    if (change.isAny(ChangeKind::step) || (change.isAny(ChangeKind::selection) && m_of == Of::selected))
        restart();
    else if (change.isAny(ChangeKind::run))
        dropFrom(change.firstFrame);
    else if (change.isAny(ChangeKind::cursor))
        m_idleTask.run();
}

void DifferenceSeries::dropFrom(std::int64_t frame)
{
    if (!m_isActive)
        return;
    const Branch *shown = m_comparisons.shown();
    const bool isSame = m_branch && isComparing() && shown && shown->script == m_branch && frame > 0 &&
                        lastShared(m_run.timeline().script(), *m_branch) == m_shared;
    const bool isPast = m_next - m_spacing >= frame;
    if (!isSame || (isPast && m_spacing > m_leastSpacing)) {
        restart();
        return;
    }
    if (isPast)
        dropAfter(frame - 1);
    m_idleTask.run();
}

void DifferenceSeries::dropAfter(std::int64_t frame)
{
    std::erase_if(m_samples, [&](const Difference &one) { return one.frame > frame; });
    m_next = frame / m_leastSpacing * m_leastSpacing + m_leastSpacing;
    m_largest = {};
    for (const Difference &one : m_samples) {
        if (one.distance > m_largest.distance)
            m_largest = one;
    }
    emit changed();
}

void DifferenceSeries::pairUp(const std::shared_ptr<const sim::ComposedInterval> &one,
                              const std::shared_ptr<const sim::ComposedInterval> &other)
{
    if (one == m_one && other == m_other)
        return;
    m_one = one;
    m_other = other;
    m_pairs.clear();
    std::map<std::string, int> places;
    for (std::size_t i = 0; i < other->scene.names.size(); ++i)
        places.emplace(other->scene.names[i], static_cast<int>(i));
    for (std::size_t i = 0; i < one->scene.names.size(); ++i) {
        const auto found = places.find(one->scene.names[i]);
        if (found != places.end())
            m_pairs.push_back({static_cast<int>(i), found->second});
    }
}

bool DifferenceSeries::addSample()
{
    if (!m_isActive || !m_branch || !isComparing() || m_isTooLarge || m_next > end())
        return false;
    const sim::Track &run = m_run.timeline().track();
    const sim::Track &branch = *m_run.timeline().comparison();
    const std::int64_t frame = m_next;
    pairUp(run.intervalAt(frame), branch.intervalAt(frame));
    m_isTooLarge = std::max(m_one->scene.start.pointCount(), m_other->scene.start.pointCount()) > mostPoints;
    if (m_isTooLarge) {
        m_samples.clear();
        return true;
    }
    const sim::State one = run.stateAt(frame), other = branch.stateAt(frame);
    const int selected = m_one->scene.find(m_run.selected().toStdString());
    Difference farthest{frame, -1.0, {}};
    for (const Pair &pair : m_pairs) {
        if (m_of == Of::selected && pair.one != selected)
            continue;
        const double distance = shownLength(one.positionOf(pair.one) - other.positionOf(pair.other));
        if (distance > farthest.distance)
            farthest = {frame, distance, m_one->scene.names[static_cast<std::size_t>(pair.one)]};
    }
    m_next += m_spacing;
    if (farthest.distance < 0.0)
        return true; // the two runs have no body in common
    if (m_samples.empty() || farthest.distance > m_largest.distance)
        m_largest = farthest;
    m_samples.push_back(std::move(farthest));
    if (m_samples.size() >= mostSamples)
        thin();
    return true;
}

void DifferenceSeries::thin()
{
    m_spacing *= 2;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < m_samples.size(); i += 2)
        m_samples[kept++] = std::move(m_samples[i]);
    m_samples.resize(kept);
    m_next = m_samples.back().frame + m_spacing;
}

}
