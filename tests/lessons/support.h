#pragma once

#include "lessons/api/step.h"
#include "sim/run/script/script.h"

#include <QJsonObject>
#include <QString>
#include <QStringList>

#include <optional>
#include <string>
#include <vector>

namespace support {

/// A lesson's plugin: what its metadata says, and its steps.
struct LoadedLesson
{
    QJsonObject metadata;
    std::vector<lessons::Step> steps;

    /// The step called `id`. @throws std::out_of_range if there is none
    const lessons::Step &step(const QString &id) const;
};

/// The ids of all lessons in the build, from the names of their files.
QStringList lessonIds();
/// The lesson called `id`. @throws std::runtime_error with Qt's reason when it does not load
LoadedLesson loadLesson(const QString &id);

/// Adds one row a step of every lesson, of columns "lesson" and "id"; and the step of the row under way.
void addStepRows();
lessons::Step stepOfRow();

/// The text of a region as it was embedded; empty unless the file is there and has exactly two marker lines.
std::optional<QString> regionText(const sim::Region &region);

/// The methods that the walking lesson is tested with: of fixed step, since a hand that steers acts once a step; that hold
/// at a step a frame for ever, which explicit Euler and the midpoint rule do not, as both gain energy where nothing
/// damps; and whose errors are not lost in rounding at the steps at which orders are measured there.
std::vector<sim::MethodPtr> walkingMethods();

/// The script of `step` with another method and step, and other values for some parameters. Methods that choose their
/// steps get the preset tolerance in place of `h`.
using Changes = std::vector<std::pair<std::string, double>>;
sim::Script scriptOf(const lessons::Step &step, const std::string &method = "published", double h = 1.0,
                     const Changes &changes = {});

/// The state after `frames` frames of `script`.
sim::State stateAfter(const sim::Script &script, std::int64_t frames);

/// The largest distance between points of the same number, in px.
double farthestApart(const sim::State &a, const sim::State &b);

/// How fast `error(h)` shrinks from h = 1/2^first to 1/2^last: the least and the greatest log2 of the ratio between
/// neighbours. A method of order 1 has 1.
struct Slope
{
    double least = 0.0;
    double greatest = 0.0;
};
Slope slopeOf(const std::function<double(double)> &error, int first, int last);

}
