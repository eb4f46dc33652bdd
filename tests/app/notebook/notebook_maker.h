#pragma once

#include "app/model/catalog/progress.h"
#include "app/model/learning/notes.h"
#include "app/model/learning/proofs.h"
#include "app/model/notebook/notebook.h"

namespace tests {

/// Removes what earlier tests have recorded.
void forgetRecords();

/// A learner's record, which begins empty.
struct Record
{
    Record();

    app::Progress progress;
    app::Notes notes;
    app::Proofs proofs;
};

/// Returns all lessons of the program, in English.
const app::LessonLibrary &allLessons();

/// Does each thing to try of a lesson, as its scripted attempts do. Its runs are recorded as the window records them.
void tryAll(const QString &lesson, Record &record);
/// Writes each task of a lesson in a right way, passes each level of its project, makes each prediction well, and makes each
/// right choice.
void doTheRest(const QString &lesson, Record &record);
/// Returns the notebook of a learner who did everything in a lesson. It is computed once.
const app::Notebook &notebookOfAll(const QString &lesson);

/// Returns the entry of a notebook.
app::NotebookEntry &entryOf(app::Notebook &notebook, app::NotebookEntry::Kind kind, const QString &id);

}
