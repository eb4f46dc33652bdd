#include "app/model/handout/handout.h"
#include "app/cli/option_values.h"
#include "app/cli/terminal.h"
#include "app/cli/verbs.h"
#include "app/model/experiment/experiment.h"
#include "app/model/files/whole_file.h"
#include "app/model/lesson_folders/lesson_folder.h"
#include "app/model/text/language.h"
#include "app/model/text/pdf.h"
#include "app/model/text/quoting.h"
#include "app/ui/film/handout_export.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QTextDocument>

namespace app {

namespace {

struct HandoutCliText
{
    Q_DECLARE_TR_FUNCTIONS(HandoutCliText)
};

/// Returns a lesson by its id or its path. One with a path is added to `library`.
const LessonEntry &lessonFor(const QString &name, LessonLibrary &library)
{
    if (isLessonPath(name) || (QFileInfo::exists(name) && !library.lesson(name))) {
        library.yours.push_back(readLesson(name, library));
        return library.yours.back();
    }
    const LessonEntry *lesson = library.lesson(name);
    if (!lesson)
        throw UsageError(HandoutCliText::tr("handout: %1").arg(noLesson(name, library)));
    return *lesson;
}

}

int runHandout(const Arguments &arguments)
{
    const QString out = arguments.names[1];
    if (!out.endsWith(".pdf", Qt::CaseInsensitive))
        throw UsageError(
            HandoutCliText::tr("%1 is not the name of a handout; it ends in .pdf.").arg(quoted(out)));
    Language language(languageCode(arguments));
    LessonLibrary library = LessonLibrary::load(LessonLibrary::folders(), &language);
    const LessonEntry &lesson = lessonFor(arguments.names[0], library);
    listenForInterrupt();
    QTextDocument document;
    bool isWritten = false;
    {
        TerminalLine status;
        const HandoutPicture draw = handoutPicture(library);
        int count = 0;
        isWritten = writeHandout(
            document, lesson,
            [&](const HandoutMoment &moment) {
                if (status.isDue())
                    status.show(
                        HandoutCliText::tr("%1 of %2 pictures").arg(count).arg(handoutPictureCount(lesson)));
                ++count;
                return draw(moment);
            },
            [] { return !isInterrupted(); });
        status.erase();
    }
    if (!isWritten) {
        printMessage(HandoutCliText::tr("Stopped before the handout was written."));
        return exitInterrupted;
    }
    writeWholeFile(out, pdfOf(document, lesson.title));
    return exitDone;
}

}
