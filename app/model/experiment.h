#pragma once

#include "app/model/branches.h"
#include "app/model/lesson_library.h"
#include "app/model/refusal.h"
#include "sim/run/script/script.h"

#include <QByteArray>
#include <QString>

#include <cstdint>

namespace app {

/// An experiment file (springstep-experiment/1): a step of a lesson, what is changed in it, and the input.
struct Experiment
{
    QString lesson;
    QString step;
    std::int64_t frames = 300; ///< how many `trace` computes
    sim::Script script;        ///< complete: presets filled in
    Branches branches = {};    ///< runs beside it, and what the learner calls this one
};

constexpr qint64 largestExperiment = 32 << 20; ///< bytes
constexpr std::int64_t mostFrames = 10'000'000;
constexpr std::size_t mostBranchEvents =
    2'000'000; ///< of all branches together: what they share, each has again

/// Reads an experiment. `name` is how messages call it.
/// @throws Refusal: not JSON, wrong types, unknown or missing names, values out of range; with the line
Experiment parseExperiment(const QByteArray &text, const QString &name, const LessonLibrary &library);
/// @throws Refusal: as parseExperiment, or the file cannot be read or is larger than largestExperiment
Experiment readExperiment(const QString &path, const LessonLibrary &library);

/// The experiment as a file: what differs from the step's own is written, and nothing else. Of the branches those are
/// written that the learner named or keeps. @throws Refusal: a number that is not finite, or too many branches
QByteArray experimentText(const Experiment &experiment, const LessonLibrary &library);
/// Writes to a temporary file and renames it, so that a failure leaves the old file as it was.
/// @throws Refusal when the file cannot be written
void writeExperiment(const QString &path, const Experiment &experiment, const LessonLibrary &library);

/// An untouched experiment of a step. @throws Refusal for names that are not there, listing what there is
Experiment newExperiment(const QString &lesson, const QString &step, const LessonLibrary &library);

/// The ids that there are, as messages list them: the nearest to `given` first, where not all fit.
QString lessonIds(const LessonLibrary &library, const QString &given = {});
QString stepIds(const LessonEntry &lesson, const QString &given = {});
/// "there is no lesson ID; there is ...": what messages say about a name that is not there.
QString noLesson(const QString &id, const LessonLibrary &library);
QString noStep(const QString &id, const LessonEntry &lesson);

}
