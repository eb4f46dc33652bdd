#include "app/model/plot_course.h"

#include "app/model/same_run.h"

#include <QElapsedTimer>

#include <algorithm>

namespace app {

namespace {

bool isSame(const sim::Script &a, const sim::Script &b)
{
    return sameRun(a, b) && a.input == b.input;
}

}

PlotCourse::PlotCourse(Session &session, QObject *parent)
    : QObject(parent), m_session(session), m_later([this](double milliseconds) { fillFor(milliseconds); })
{
    connect(&session, &Session::stepOpened, this, &PlotCourse::restart);
    connect(&session, &Session::runChanged, this, &PlotCourse::dropChanged);
    connect(&session, &Session::selectionChanged, this, &PlotCourse::changeSelection);
    connect(&session, &Session::moved, this, &PlotCourse::follow);
}

void PlotCourse::setWatched(bool watched)
{
    m_watched = watched;
    if (!watched) {
        m_later.stop();
        m_isStale = true;
    } else if (m_isStale) {
        restart();
    }
}

void PlotCourse::setQuantities(std::vector<Quantity> quantities)
{
    if (quantities == m_quantities)
        return;
    m_quantities = std::move(quantities);
    restart();
}

void PlotCourse::setMostRows(std::int64_t rows)
{
    rows = std::clamp(rows, PlotWindow::leastRows, allRows);
    if (rows == m_mostRows)
        return;
    m_mostRows = rows;
    follow();
    tell();
}

std::size_t PlotCourse::columnOf(const Quantity &quantity) const
{
    const auto found = std::find(m_quantities.begin(), m_quantities.end(), quantity);
    return static_cast<std::size_t>(found - m_quantities.begin());
}

std::vector<Quantity> PlotCourse::allBound() const
{
    std::vector<Quantity> all = m_quantities;
    for (Quantity &one : all)
        one = bound(one);
    return all;
}

void PlotCourse::restart()
{
    m_isStale = !m_watched;
    if (m_isStale)
        return;
    const sim::Timeline &timeline = m_session.timeline();
    m_framesPerOutput = timeline.track().framesPerOutput();
    m_script = withoutInput(timeline.script());
    m_input = timeline.script().input;
    m_window =
        windowAfter(m_window, {timeline.cursor().frame, timeline.computed(), m_framesPerOutput, m_mostRows});
    const std::int64_t stride = strideOf(m_window, m_framesPerOutput, mostBuckets);
    m_run = RunSampler(allBound(), m_window.first, m_framesPerOutput, stride);
    restartGhost();
    tell();
    fill();
}

void PlotCourse::tell()
{
    ++m_revision;
    emit changed();
}

void PlotCourse::restartGhost()
{
    ++m_ghostRevision;
    const sim::Track *ghost = m_session.timeline().comparison();
    const bool fits = ghost && ghost->framesPerOutput() == m_framesPerOutput;
    m_ghostScript = fits ? std::optional(ghost->script()) : std::nullopt;
    m_ghost = fits ? RunSampler(allBound(), ghostStart(), m_framesPerOutput, m_run.samples().stride())
                   : RunSampler();
}

std::int64_t PlotCourse::ghostStart() const
{
    // The last moment that both share, so that the two curves meet.
    const std::int64_t wide = strideOf(m_window, m_framesPerOutput, mostBuckets) * m_framesPerOutput;
    const std::int64_t fork = std::max<std::int64_t>(0, m_session.timeline().forkFrame() - m_framesPerOutput);
    return std::max(m_window.first, fork / wide * wide);
}

void PlotCourse::dropChanged()
{
    if (!m_watched) {
        m_isStale = true;
        return;
    }
    const sim::Timeline &timeline = m_session.timeline();
    if (!sameRun(m_script, timeline.script())) {
        restart();
        return;
    }
    // What a learner does concerns the rows after the cursor; what is undone may be long past.
    const std::vector<sim::Event> &input = timeline.script().input;
    m_run.forgetAfter(std::min(timeline.cursor().frame, firstDifference(m_input, input) - 1));
    m_input = input;
    const sim::Track *ghost = timeline.comparison();
    if (ghost ? !m_ghostScript || !isSame(*m_ghostScript, ghost->script()) : m_ghostScript.has_value())
        restartGhost();
    moveWindow();
    tell();
    fill();
}

void PlotCourse::changeSelection()
{
    const auto follows = [](const Quantity &one) {
        return aboutOf(one.what) != About::run && one.body.isEmpty();
    };
    if (std::any_of(m_quantities.begin(), m_quantities.end(), follows))
        restart();
}

void PlotCourse::move(RunSampler &sampler, std::int64_t first, std::int64_t stride)
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

bool PlotCourse::moveWindow()
{
    const sim::Timeline &timeline = m_session.timeline();
    const PlotWindow next =
        windowAfter(m_window, {timeline.cursor().frame, timeline.computed(), m_framesPerOutput, m_mostRows});
    if (next == m_window)
        return false;
    m_window = next;
    const std::int64_t stride = strideOf(m_window, m_framesPerOutput, mostBuckets);
    move(m_run, m_window.first, stride);
    if (m_ghostScript) {
        ++m_ghostRevision;
        move(m_ghost, ghostStart(), stride);
    }
    return true;
}

void PlotCourse::follow()
{
    if (!m_watched)
        return;
    if (moveWindow())
        tell();
    if (m_session.isPlaying())
        fill();
    else
        m_later.runWhileMoved();
}

std::int64_t PlotCourse::endOf(const sim::Track &track) const
{
    return std::min(track.computed(), m_window.last);
}

bool PlotCourse::takeRow()
{
    const sim::Timeline &timeline = m_session.timeline();
    if (m_run.samples().nextFrame() <= endOf(timeline.track())) {
        m_run.takeRow(timeline.track());
        return true;
    }
    const sim::Track *ghost = m_ghostScript ? timeline.comparison() : nullptr;
    if (!ghost || m_ghost.samples().nextFrame() > endOf(*ghost))
        return false;
    ++m_ghostRevision;
    m_ghost.takeRow(*ghost);
    return true;
}

bool PlotCourse::isReading() const
{
    return m_later.isDue();
}

void PlotCourse::fillFor(double milliseconds)
{
    if (!m_watched || m_quantities.empty())
        return;
    QElapsedTimer clock;
    clock.start();
    bool any = false;
    while (takeRow()) {
        any = true;
        if (static_cast<double>(clock.nsecsElapsed()) > 1e6 * milliseconds) {
            m_later.goOn();
            break;
        }
    }
    if (any)
        tell();
}

}
