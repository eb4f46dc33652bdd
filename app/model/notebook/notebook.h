#pragma once

#include "app/model/catalog/lesson_library.h"
#include "sim/run/track.h"

#include <QByteArray>
#include <QDateTime>
#include <QString>
#include <QStringList>

#include <vector>

namespace app {

class Notes;
class Proofs;
class Progress;

/// A run in a notebook, and the moment at which it did something.
struct NotebookRun
{
    QByteArray text; ///< of an experiment file, without white space between its parts; empty: there is no run
    sim::Cursor at = {};
    QByteArray beside = {}; ///< the comparison run, likewise
    std::int64_t fork = 0;  ///< the first frame at which the two runs differ
    friend bool operator==(const NotebookRun &, const NotebookRun &) = default;
};

/// Something that a learner did.
struct NotebookEntry
{
    enum class Kind {
        tried,      ///< a thing to try is ticked
        code,       ///< a task in the listing is ticked
        level,      ///< a level of a project is ticked
        prediction, ///< a prediction was made
        answer,     ///< a recall question, or the question of a thing to try, was answered
        scene,      ///< a scene is kept in the gallery
    };
    Kind kind = Kind::tried;
    QString lesson = {};
    QString step = {};   ///< empty for levels, scenes, and answers to recall questions
    QString id = {};     ///< of the thing to try, task, level, prediction or question; the title of a scene
    QDateTime when = {}; ///< UTC; invalid if it was not recorded
    NotebookRun run = {};
    QString code = {}; ///< of a task: the text of the listing; empty if it was not recorded
    /// Of a prediction, as notes have it; see answerInNote(). Of an answer: the number of the choice in the document, from 1;
    /// empty if it was given by doing something in a scene, and has a run.
    QString said = {};
    QString found = {};   ///< of a prediction, likewise: what the run showed
    bool isRight = false; ///< of a prediction or a choice
    friend bool operator==(const NotebookEntry &, const NotebookEntry &) = default;
};

/// What a learner hands in.
struct Notebook
{
    static constexpr qsizetype longestName = 100;
    static constexpr std::size_t mostEntries = 5000;

    QString name = {};   ///< that the learner typed; empty if she typed none
    QDateTime when = {}; ///< UTC, when it was written
    std::vector<NotebookEntry> entries = {};
    /// Whether the file is unchanged since it was written. The seal finds accidents only: anybody can compute it again.
    bool isSealed = true;
};

/// The word for a kind in files and tables: "try", "code", "level", "prediction", "answer", "scene".
QString wordFor(NotebookEntry::Kind kind);

/// What to put into a notebook.
struct NotebookPlan
{
    QString name = {};
    QStringList lessons = {}; ///< ids
    QString gallery = {};     ///< the folder of the gallery; empty: without its scenes
};

/// Collects what the learner did in the lessons of `plan`. Scenes that cannot be read are left out.
Notebook collectNotebook(const NotebookPlan &plan, const LessonLibrary &library, const Progress &progress,
                         const Notes &notes, const Proofs &proofs);
/// Returns the number of things that the learner did in a lesson.
int notebookEntries(const LessonEntry &lesson, const Progress &progress, const Notes &notes);

}
