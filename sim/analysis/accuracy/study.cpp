#include "sim/analysis/accuracy/study.h"

#include "sim/analysis/accuracy/errors.h"
#include "sim/analysis/accuracy/reference.h"
#include "sim/analysis/accuracy/timing.h"
#include "sim/scene/scene.h"

#include <algorithm>
#include <limits>
#include <string>

namespace sim {

bool Accuracy::isExact() const
{
    const auto hasError = [](const AccuracyRow &row) {
        return row.outcome == Outcome::waiting || row.outcome == Outcome::unstable || row.error > 0.0;
    };
    return horizon > 0 && previewed == 0 && !rows.empty() && std::none_of(rows.begin(), rows.end(), hasError);
}

const AccuracyRow *Accuracy::cheapest(double error) const
{
    const AccuracyRow *best = nullptr;
    for (const AccuracyRow &row : rows) {
        const bool fits = row.outcome == Outcome::measured && row.nsPerFrame > 0.0 && row.error <= error;
        if (fits && (!best || row.nsPerFrame < best->nsPerFrame))
            best = &row;
    }
    return best;
}

void markFront(std::vector<AccuracyRow> &rows)
{
    std::vector<AccuracyRow *> timed;
    for (AccuracyRow &row : rows) {
        row.front = false;
        if (row.outcome == Outcome::measured && row.nsPerFrame > 0.0)
            timed.push_back(&row);
    }
    std::stable_sort(timed.begin(), timed.end(), [](const AccuracyRow *a, const AccuracyRow *b) {
        return std::pair(a->nsPerFrame, a->error) < std::pair(b->nsPerFrame, b->error);
    });
    double best = std::numeric_limits<double>::infinity();
    for (AccuracyRow *row : timed) {
        row->front = row->error < best;
        best = std::min(best, row->error);
    }
}

Accuracy studyAccuracy(const Script &script, const StudyPlan &plan, const StudyProgress &progress)
{
    Track::check(script);
    if (const int points = sceneOf(script, script.values).start.pointCount(); points > maxStudiedPoints)
        throw Error("too-many-points",
                    {{"points", std::to_string(points)}, {"most", std::to_string(maxStudiedPoints)}});
    Accuracy found;
    found.span = plan.frames;
    found.rows = waitingRows(plan);
    StudyMonitor monitor(progress, found);
    monitor.beginPart(0.0, 0.1);
    Preview preview(script, plan, found, monitor);
    findReference(script, plan, found, monitor, preview);
    preview.discard();
    monitor.beginPart(0.1, 0.5);
    if (monitor.reportNow(0.0))
        measureErrors(script, plan, found, monitor);
    monitor.beginPart(0.5, 1.0);
    if (monitor.reportNow(0.0))
        measureTimes(script, plan, found, monitor);
    markFront(found.rows);
    monitor.reportNow(1.0);
    return found;
}

}
