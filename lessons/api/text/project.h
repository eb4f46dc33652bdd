#pragma once

#include "lessons/api/prediction.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace lessons {

/// A condition that the judged run of a level has to meet.
struct ProjectDemand
{
    enum class When {
        atTheStart, ///< before the first frame
        always,     ///< at the start and after each frame
        once,       ///< at the start or after one of the frames
        atTheEnd,   ///< after the last frame
    };
    When when = When::atTheEnd;
    QString condition; ///< in the language of conditions, with the further names that lessons/README.md lists
    QString sentence;  ///< the same in words, beginning without a capital: "the foot stays left of x = 305"
    int line = 0;      ///< from 1
};

/// A ring that the scene shows while the project is open.
struct ProjectRing
{
    sim::Vec2 centre;    ///< px
    double radius = 0.0; ///< px

    friend bool operator==(const ProjectRing &, const ProjectRing &) = default;
};

/// A level of a project: what to build, and how the machine judges it.
struct ProjectLevel
{
    QString id; ///< made of a to z, 0 to 9 and _. No other level of the project has it.
    QString title;
    QString text;      ///< Markdown
    RunSetup run = {}; ///< the judged run: the learner's scene, with these changes
    std::vector<ProjectDemand> demands = {};
    QStringList unchanged = {}; ///< parameters and bodies that have to be as in the start scene
    QStringList effects = {};   ///< ids of effects that have to act
    std::vector<ProjectRing> rings = {};
    QString hint = {}; ///< Markdown
    int line = 0;      ///< of its heading, from 1
};

/// A thing to build after a lesson, in one language.
struct Project
{
    static constexpr std::size_t levelCount = 3;

    QString file; ///< the name that errors show
    QString title;
    QString brief; ///< Markdown
    std::vector<ProjectLevel> levels = {};
};

/// Reads the project of a lesson. lessons/README.md describes the format. `file` is the name that errors show. Names of
/// bodies, parameters and effects, and conditions, are not looked up.
/// @throws DocumentError if a heading or a text is missing, unknown or there twice, or if `source` is not UTF-8
Project parseProject(const QByteArray &source, const QString &file);

/// Returns the project in the resource `:/documents/LESSON/project.md`, in the language of documentLanguage() if it is
/// there and otherwise in English. Empty if the lesson has none.
/// @throws DocumentError as parseProject()
std::optional<Project> readProject(const QString &lesson);

/// Returns the resource with the experiment that the project of a lesson starts with. Its lesson and step are the place
/// where the learner works.
QString projectStartFile(const QString &lesson);

}
