#include "app/ui/accuracy/work_precision_layout.h"

#include "sim/pipeline/method.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

using sim::AccuracyRow;
using sim::Outcome;

constexpr double nameRoom = 128.0;   ///< px right of the last marker
constexpr double besideFirst = 24.0; ///< px left of the first one
constexpr double besideFrame = 14.0; ///< px right of the time that a frame has
constexpr double nameFactor = 30.0;  ///< from the most expensive marker to that time, so that names have room
constexpr double mostBeyond = 2.0 / 3.0; ///< of the decades of the markers, from the last one to that time
constexpr double shortest = 80.0;        ///< px between them, at least
constexpr double factorAbove = 30.0;     ///< a factor of room over the largest error
constexpr double fromTop = 0.06;         ///< of the height, the place of unstable rows

/// Returns whether all measured rows have times, so that times can be compared.
bool isTimed(const std::vector<AccuracyRow> &rows)
{
    bool any = false;
    for (const AccuracyRow &row : rows) {
        if (row.outcome != Outcome::measured)
            continue;
        if (!(row.nsPerFrame > 0.0))
            return false;
        any = true;
    }
    return any;
}

/// Returns the cost of an unstable row. It was not timed, so this follows from the cost of the next finer step that
/// was.
double unstableCost(const std::vector<AccuracyRow> &rows, std::size_t row, bool timed)
{
    const sim::MethodSetup &setup = rows[row].setup;
    for (std::size_t i = row + 1; i < rows.size() && rows[i].setup.method->id() == setup.method->id(); ++i) {
        if (costOf(rows[i], timed) > 0.0 && !setup.step.isAdaptive())
            return costOf(rows[i], timed) * rows[i].setup.step.h / setup.step.h;
    }
    return costOf(rows[row], timed);
}

/// Returns the line of each row. Each method has one line.
std::vector<int> linesOf(const std::vector<AccuracyRow> &rows)
{
    std::vector<int> lines;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const bool isNew = i > 0 && rows[i].setup.method->id() != rows[i - 1].setup.method->id();
        lines.push_back(i == 0 ? 0 : lines.back() + (isNew ? 1 : 0));
    }
    return lines;
}

void fitCosts(WorkPrecisionLayout &layout, double width, bool withFrame)
{
    double cheap = HUGE_VAL;
    double expensive = 0.0;
    for (const Spot &spot : layout.spots) {
        cheap = std::min(cheap, spot.place.x());
        expensive = std::max(expensive, spot.place.x());
    }
    const double farthest = expensive * std::pow(expensive / cheap, mostBeyond);
    const bool isFrameShown =
        withFrame && expensive * nameFactor < frameOnScreen && frameOnScreen <= farthest;
    const double last = isFrameShown ? frameOnScreen : expensive;
    const double room = isFrameShown ? besideFrame : nameRoom;
    const double inner = std::max(shortest, width - room - besideFirst);
    const double decades = std::max(0.3, std::log10(last / cheap)) / inner; // a px
    layout.least = cheap * std::pow(10.0, -besideFirst * decades);
    layout.most = last * std::pow(10.0, room * decades);
}

void addUnstable(WorkPrecisionLayout &layout, const std::vector<AccuracyRow> &rows, const ShownMethods &shown,
                 int line)
{
    const ErrorScale &errors = layout.errors;
    const double top = errors.upper / std::pow(errors.upper / errors.lower, fromTop);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].outcome != Outcome::unstable || !shown.has(*rows[i].setup.method))
            continue;
        const double cost = unstableCost(rows, i, layout.timed);
        layout.spots.push_back({i, {std::clamp(cost, layout.least * 1.1, layout.most), top}, line});
    }
}

}

double costOf(const AccuracyRow &row, bool timed)
{
    return timed ? row.nsPerFrame / 1e3 : row.evaluations;
}

WorkPrecisionLayout workPrecisionLayout(const sim::Accuracy &accuracy, const ShownMethods &shown,
                                        double target, QSizeF size)
{
    const std::vector<AccuracyRow> &rows = accuracy.rows;
    const std::vector<int> lines = linesOf(rows);
    WorkPrecisionLayout layout;
    layout.timed = isTimed(rows);
    std::vector<double> errors{target};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].outcome != Outcome::measured || !(costOf(rows[i], layout.timed) > 0.0) ||
            !shown.has(*rows[i].setup.method))
            continue;
        layout.spots.push_back({i, {costOf(rows[i], layout.timed), rows[i].error}, lines[i]});
        errors.push_back(rows[i].error);
    }
    if (layout.spots.empty())
        return layout;
    layout.errors = errorScale(errors, factorAbove, size.height());
    for (Spot &spot : layout.spots)
        spot.place.setY(layout.errors.place(spot.place.y()));
    fitCosts(layout, size.width(), layout.timed && !shown.areAll);
    addUnstable(layout, rows, shown, lines.back() + 1);
    return layout;
}

}
