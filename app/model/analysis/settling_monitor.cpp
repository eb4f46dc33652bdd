#include "app/model/analysis/settling_monitor.h"

#include "app/model/run/same_run.h"
#include "app/model/text/numbers.h"
#include "app/model/text/sentences.h"

#include <QElapsedTimer>

#include <algorithm>
#include <limits>

namespace app {

namespace {

constexpr double softest = 0.01, stiffest = 10.0;  ///< 1/frame^2
constexpr double leastKept = 0.04, mostKept = 1.0; ///< fraction per frame
constexpr auto always = std::numeric_limits<std::int64_t>::max();

QString writtenSpot(const lessons::Step &step, const TriedSpot &spot)
{
    return QStringLiteral("%1 %2, %3 %4")
        .arg(stiffnessOf(step)->id, roughNumber(spot.k), dampingOf(step)->id, roughNumber(spot.damp));
}

/// Returns whether both scripts make the same run but for the values of two parameters.
bool differOnlyIn(sim::Script a, const sim::Script &b, const sim::MapAxis &x, const sim::MapAxis &y)
{
    for (const std::string *parameter : {&x.parameter, &y.parameter}) {
        if (!a.values.has(*parameter) || !b.values.has(*parameter))
            return false;
        a.values.set(*parameter, b.values[*parameter]);
    }
    return sameScript(a, b);
}

}

SettlingMonitor::SettlingMonitor(const OpenRun &run, RunEditor &editor, Playback &playback, QObject *parent)
    : QObject(parent), m_run(run), m_editor(editor), m_playback(playback)
{
    m_due.setSingleShot(true);
    m_due.setInterval(restMilliseconds);
    connect(&m_due, &QTimer::timeout, this, &SettlingMonitor::start);
    run.onChange(ChangeKind::step, this, &SettlingMonitor::reset);
    run.onChange(ChangeKind::run, this, &SettlingMonitor::followRun);
    noteSpot();
}

bool SettlingMonitor::canMap() const
{
    return stiffnessOf(m_run.step()) && dampingOf(m_run.step()) &&
           m_run.timeline().state().pointCount() <= mostPoints;
}

TriedSpot SettlingMonitor::present() const
{
    const sim::Values &values = m_run.timeline().values();
    const auto valueOf = [&](const lessons::Parameter *parameter, double otherwise) {
        const std::string id = parameter ? parameter->id.toStdString() : std::string();
        return values.has(id) ? values[id] : otherwise;
    };
    return {valueOf(stiffnessOf(m_run.step()), 0.0), valueOf(dampingOf(m_run.step()), 1.0),
            m_run.timeline().script().step.h};
}

void SettlingMonitor::noteSpot()
{
    if (addTried(m_tried, present()))
        emit changed();
}

SettlingMonitor::Question SettlingMonitor::question() const
{
    const lessons::Parameter &across = *stiffnessOf(m_run.step());
    const std::string x = across.id.toStdString(), y = dampingOf(m_run.step())->id.toStdString();
    const double k = present().k;
    return {sim::settlingScript(m_run.timeline().script(), x, y, mostInput),
            sim::MapAxis::byRatio(x, k > 0.0 ? std::min(softest, k / 2.0) : softest,
                                  std::min(across.max, std::max(stiffest, 2.0 * k)), columns),
            sim::MapAxis::evenly(y, leastKept, mostKept, rows)};
}

bool SettlingMonitor::isAnswered() const
{
    const Question now = question();
    const double k = present().k;
    const bool isOnMap =
        m_question && (k <= 0.0 || (k >= m_question->x.values.front() && k <= m_question->x.values.back()));
    return isOnMap && now.x.parameter == m_question->x.parameter &&
           now.y.parameter == m_question->y.parameter &&
           differOnlyIn(now.script, m_question->script, now.x, now.y);
}

void SettlingMonitor::followRun()
{
    noteSpot();
    if (m_isActive && !(canMap() && isAnswered())) {
        m_due.start();
        emit changed();
    }
}

void SettlingMonitor::reset()
{
    stop();
    m_map.reset();
    m_question.reset();
    m_tried.clear();
    noteSpot();
    if (m_isActive)
        m_due.start();
    emit changed();
}

void SettlingMonitor::setActive(bool isActive)
{
    if (isActive == m_isActive)
        return;
    m_isActive = isActive;
    if (!isActive) {
        stop();
        m_map.reset();
        m_question.reset();
    } else {
        start();
    }
    emit changed();
}

std::int64_t SettlingMonitor::countedFrom() const
{
    return canMap() ? sim::lastInputFrame(question().script) : 0;
}

bool SettlingMonitor::leavesInputOut() const
{
    return sim::lastInputFrame(m_run.timeline().script()) > mostInput;
}

void SettlingMonitor::stop()
{
    m_due.stop();
    m_job.cancel();
}

void SettlingMonitor::start()
{
    stop();
    if (!canMap()) {
        m_map.reset();
        m_question.reset();
        emit changed();
        return;
    }
    m_question = question();
    m_job.start(
        [this, asked = *m_question](const BackgroundJob::Context &job) {
            QElapsedTimer clock, sinceReport;
            clock.start();
            sinceReport.start();
            const auto progress = [&](const sim::SettlingMap &soFar) {
                if (sinceReport.hasExpired(reportMilliseconds)) {
                    sinceReport.start();
                    job.report([this, copy = std::make_shared<const sim::SettlingMap>(soFar)] {
                        m_map = copy;
                        emit changed();
                    });
                }
                const bool isLong = soFar.stride > 0 && clock.hasExpired(longestMilliseconds);
                return !isLong && !job.isCancelled();
            };
            return std::make_shared<const sim::SettlingMap>(
                sim::settlingMap(asked.script, asked.x, asked.y, progress, job.shouldContinue()));
        },
        [this](std::future<std::shared_ptr<const sim::SettlingMap>> result) {
            m_map = result.get();
            emit changed();
        });
}

void SettlingMonitor::adopt(const TriedSpot &spot)
{
    if (!canMap())
        return;
    const lessons::Step &step = m_run.step();
    const lessons::Parameter &k = *stiffnessOf(step), &damp = *dampingOf(step);
    const TriedSpot was = present(), to = settable(spot);
    sim::Script script =
        sim::settlingScript(m_run.timeline().script(), k.id.toStdString(), damp.id.toStdString(), always);
    script.values.set(k.id.toStdString(), to.k);
    script.values.set(damp.id.toStdString(), to.damp);
    m_playback.goTo({}); // the map is about the run from its start
    m_editor.endGesture();
    m_editor.edit({tr("Change %1 and %2").arg(withinSentence(k.name), withinSentence(damp.name)),
                   writtenSpot(step, was),
                   {},
                   writtenSpot(step, to)},
                  [&](sim::Timeline &timeline) { return timeline.replaceScript(std::move(script)); });
}

}
