#pragma once

#include "lessons/api/step.h"
#include "sim/run/script/script.h"

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace support {

/// A loaded lesson plugin: its metadata and its steps.
struct LoadedLesson
{
    QJsonObject metadata;
    std::vector<lessons::Step> steps;

    /// Returns the step `id`. @throws std::out_of_range if there is none
    const lessons::Step &step(const QString &id) const;
};

/// Returns the ids of all lessons in the build, from their file names.
QStringList lessonIds();
/// Loads the lesson `id`. @throws std::runtime_error with Qt's message if it does not load
LoadedLesson loadLesson(const QString &id);

/// Adds one test row per step of every lesson, with the columns "lesson" and "id".
void addStepRows();
/// Returns the step of the current test row.
lessons::Step stepOfRow();

/// Returns whether `method` can compute `step`. Methods with requirements reject some steps.
bool fits(const lessons::Step &step, const sim::Method &method);
/// Adds one test row per step of every lesson and method that `accept` accepts, with the columns "lesson", "id" and
/// "method".
void addStepAndMethodRows(const std::function<bool(const lessons::Step &, const sim::Method &)> &accept);

/// Returns the embedded text of a source region. Empty if the file is missing or lacks exactly two marker
/// lines.
std::optional<QString> regionText(const sim::Region &region);

/// Returns the methods that the walking lesson is tested with. They have a fixed step, because steering acts
/// once per step. They stay stable with steps of one frame: explicit Euler and explicit Runge-Kutta methods of order 2
/// gain energy without damping. Their order is at most 2, so that rounding does not hide their errors at the steps where
/// orders are measured.
std::vector<sim::MethodPtr> walkingMethods();
/// Adds one test row per walking method, with the column "method".
void addWalkingMethodRows();

/// Returns the name of a point of a figure in the lesson on rigid constraints: "p0", "p1" and so on.
std::string figurePointName(std::size_t point);

/// Values of parameters by id.
using Changes = std::vector<std::pair<std::string, double>>;
/// Returns the script of `step` with another method, step `h` in frames and changed parameters. Adaptive
/// methods get the default tolerance in place of `h`.
sim::Script scriptOf(const lessons::Step &step, const std::string &method = "published", double h = 1.0,
                     const Changes &changes = {});

/// Computes the state after `frames` frames of `script`.
sim::State stateAfter(const sim::Script &script, std::int64_t frames);

/// Returns the largest distance between points of equal number, in px.
double largestDistance(const sim::State &a, const sim::State &b);

/// The range of observed convergence orders.
struct OrderRange
{
    double min = 0.0;
    double max = 0.0;
};
/// Computes the observed orders of `error(h)` for h from 1/2^first to 1/2^last: the log2 of the ratio of two
/// successive errors. It is near 1 for a method of order 1.
OrderRange observedOrders(const std::function<double(double)> &error, int first, int last);

}
