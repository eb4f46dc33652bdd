#pragma once

#include <QByteArray>
#include <QString>

#include <map>

namespace app {

/// The files of a lesson without C++, from its folder or its zip.
struct LessonFiles
{
    QString name; ///< of the folder or zip, for messages
    QString path; ///< likewise, without links in it; the same for every way to write it
    std::map<QString, QByteArray> all = {};

    bool has(const QString &file) const { return all.contains(file); }
    /// Returns the content of `file`; empty if there is none.
    QByteArray content(const QString &file) const;
    /// Returns the name of `file` in messages: "pendulum_clock/swing.md".
    QString shown(const QString &file) const;
};

/// The ending of the zip of a lesson, with its dot.
inline const QString lessonEnding = QStringLiteral(".springstep-lesson");

constexpr std::size_t mostLessonFiles = 200;
constexpr qsizetype largestLessonFile = 4 << 20; ///< bytes
constexpr qsizetype largestLesson = 16 << 20;    ///< bytes, of all files together, and of the zip

/// Returns whether `path` looks like a lesson without C++: a folder with a lesson.json, or a file with lessonEnding.
bool isLessonPath(const QString &path);

/// Reads the files of a lesson: a folder, its lesson.json, or a zip of it. Of a folder, only documents, scenes and listings
/// are read. Nothing is written.
/// @throws UserError: it cannot be read or is too large; a zip is damaged, or has a path, a link, a name twice or a file that
/// expands to more than it says
LessonFiles readLessonFiles(const QString &path);

}
