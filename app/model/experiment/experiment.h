#pragma once

#include "app/model/catalog/lesson_library.h"
#include "app/model/run/branches.h"
#include "app/model/text/user_error.h"
#include "sim/run/script/script.h"

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <optional>

namespace app {

/// An experiment file (springstep-experiment/1): a step of a lesson, the changes to it, and the input.
struct Experiment
{
    QString lesson;
    QString step;
    std::int64_t frames = 300; ///< number of frames that `trace` computes
    sim::Script script;        ///< complete: presets filled in
    Branches branches = {};    ///< other runs, and the learner's name for this one
    /// The text of the listing that the learner has written, if the run does not use it; at most listing::maxTextBytes.
    std::optional<QString> draft = {};
};

constexpr qint64 largestExperiment = 32 << 20; ///< bytes
constexpr std::int64_t mostFrames = 10'000'000;
constexpr std::size_t mostBranchEvents =
    2'000'000; ///< in all branches together; shared events count once per branch

/// Reads an experiment. `name` is its name in messages.
/// @throws UserError: not JSON, wrong types, unknown or missing names, values out of range; with the line
Experiment parseExperiment(const QByteArray &text, const QString &name, const LessonLibrary &library);
/// Does the same for a scene whose step has the parameters `more`, too. The rule of the scene can read them.
Experiment parseExperimentWith(const std::vector<lessons::Parameter> &more, const QByteArray &text,
                               const QString &name, const LessonLibrary &library);
/// Reads an experiment from a file.
/// @throws UserError: as parseExperiment(), or the file cannot be read or is larger than largestExperiment
Experiment readExperiment(const QString &path, const LessonLibrary &library);

/// Returns the text of an experiment file. It contains only the differences from the step's own run, and the
/// branches that the learner named or keeps.
/// @throws UserError: a number is not finite, or there are too many branches
QByteArray experimentText(const Experiment &experiment, const LessonLibrary &library);
/// Writes to a temporary file and renames it, so that a failure leaves the old file unchanged.
/// @throws UserError: the file cannot be written
void writeExperiment(const QString &path, const Experiment &experiment, const LessonLibrary &library);

/// Returns an unchanged experiment of a step.
/// @throws UserError: an id does not exist; the message lists the existing ones
Experiment newExperiment(const QString &lesson, const QString &step, const LessonLibrary &library);

/// Returns the existing ids as messages list them. If not all fit, those most similar to `given` come first.
QString lessonIds(const LessonLibrary &library, const QString &given = {});
QString stepIds(const LessonEntry &lesson, const QString &given = {});
/// Returns the message for an id that does not exist: "there is no lesson ID; there is ...".
QString noLesson(const QString &id, const LessonLibrary &library);
QString noStep(const QString &id, const LessonEntry &lesson);

}
