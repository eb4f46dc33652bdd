#pragma once

#include "lessons/api/step.h"
#include "tests/lessons/support/support.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <string>
#include <vector>

namespace support {

/// One line of a published trajectory: positions in px, velocities in px/frame, angles in degrees.
struct PublishedRow
{
    std::int64_t frame = 0;
    std::string body;
    sim::Vec2 x;
    std::optional<sim::Vec2> v;
    std::optional<double> angle;
};

/// An experiment of the tutorials, with the trajectory that their code computes for it.
struct PublishedRun
{
    QString step;
    sim::Script script;
    std::vector<PublishedRow> rows;
};

/// Returns the names of the published files of a lesson, without extension.
QStringList publishedNames(const QString &lesson);
/// Reads a published experiment and its trajectory. Supports only the keys that these files contain.
/// @throws std::runtime_error if a file cannot be read
PublishedRun readPublished(const QString &name, const LoadedLesson &lesson);

/// Returns the largest difference in any position, velocity or angle between the published rows and a run of
/// the script. Infinite if the run lacks a body or a frame.
double largestDifference(const PublishedRun &run);

/// Adds one test row per published file of a lesson, with the column "name".
void addPublishedRows(const QString &lesson);
/// Checks the trajectory of the current test row, within 1e-9.
void checkPublished(const LoadedLesson &lesson);

}
