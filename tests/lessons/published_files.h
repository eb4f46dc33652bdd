#pragma once

#include "lessons/api/step.h"
#include "tests/lessons/support.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <string>
#include <vector>

namespace support {

/// One row of a published trajectory: positions in px, velocities in px/frame, angles in degrees.
struct PublishedRow
{
    std::int64_t frame = 0;
    std::string body;
    sim::Vec2 x;
    std::optional<sim::Vec2> v;
    std::optional<double> angle;
};

/// An experiment of the tutorials, and what their own code computes for it.
struct PublishedRun
{
    QString step;
    sim::Script script;
    std::vector<PublishedRow> rows;
};

/// The names of the published files of a lesson, without ending.
QStringList publishedNames(const QString &lesson);
/// Reads a published experiment and its trajectory. Knows just what these files hold.
/// @throws std::runtime_error when one cannot be read
PublishedRun readPublished(const QString &name, const LoadedLesson &lesson);

/// The largest difference of a position, a velocity or an angle between `run`'s rows and what its script computes.
double largestDifference(const PublishedRun &run);

}
