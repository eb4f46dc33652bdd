#include "app/model/notebook/notebook.h"
#include "app/cli/notebook_report.h"
#include "app/cli/terminal.h"
#include "app/cli/verbs.h"
#include "app/model/catalog/progress.h"
#include "app/model/files/gallery.h"
#include "app/model/files/whole_file.h"
#include "app/model/learning/notes.h"
#include "app/model/learning/proofs.h"
#include "app/model/lesson_folders/lesson_folder.h"
#include "app/model/notebook/notebook_check.h"
#include "app/model/notebook/notebook_file.h"
#include "app/model/notebook/notebook_page.h"
#include "app/model/text/quoting.h"
#include "app/ui/notebook/entry_picture.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {

namespace {

struct NotebookText
{
    Q_DECLARE_TR_FUNCTIONS(NotebookText)
};

/// What a command names after its action.
struct Named
{
    LessonLibrary library; ///< the lessons of the program, and the named lessons without C++
    QStringList files;     ///< the other names
};

Named namedIn(const Arguments &arguments)
{
    Named named{LessonLibrary::load(LessonLibrary::folders()), {}};
    for (const QString &name : arguments.names.mid(1)) {
        if (isLessonPath(name))
            named.library.yours.push_back(readLesson(name, named.library));
        else
            named.files << name;
    }
    return named;
}

/// Checks the entries of a notebook. Returns whether it came to the end.
bool checkEntries(CheckedNotebook &checked, const LessonLibrary &library, TerminalLine &status)
{
    for (const NotebookEntry &entry : checked.notebook.entries) {
        if (status.isDue())
            status.show(NotebookText::tr("%1: %2 of %3")
                            .arg(shownPath(checked.file))
                            .arg(checked.findings.size())
                            .arg(checked.notebook.entries.size()));
        const auto finding = checkEntry(entry, library, [] { return !isInterrupted(); });
        if (!finding)
            return false;
        checked.findings.push_back(*finding);
    }
    return true;
}

int reportNotebooks(const std::vector<CheckedNotebook> &all, const Arguments &arguments)
{
    print(arguments.has("json")  ? notebookJson(all)
          : arguments.has("csv") ? notebookCsv(all)
                                 : notebookTable(all));
    qsizetype unread = 0;
    for (const CheckedNotebook &checked : all) {
        if (checked.mistake.isEmpty())
            continue;
        printMessage(checked.mistake);
        ++unread;
    }
    if (unread > 0 && all.size() > 1)
        printMessage(NotebookText::tr("%1 of %2 notebooks could not be read.").arg(unread).arg(all.size()));
    if (unread > 0)
        return exitBadUse;
    return std::all_of(all.begin(), all.end(), [](const CheckedNotebook &one) { return one.holds(); })
               ? exitDone
               : exitNo;
}

int checkNotebooks(const Arguments &arguments)
{
    const auto [library, files] = namedIn(arguments);
    if (files.isEmpty())
        throw UsageError(NotebookText::tr("notebook check takes FILE...; see springstep notebook --help."));
    listenForInterrupt();
    std::vector<CheckedNotebook> all;
    {
        TerminalLine status;
        for (const QString &file : files) {
            CheckedNotebook checked{.file = file};
            try {
                checked.notebook = readNotebook(file, library);
                if (!checkEntries(checked, library, status)) {
                    status.erase();
                    return printInterrupted();
                }
            } catch (const UserError &error) { // the others are checked nevertheless
                checked.mistake = error.sentence();
            }
            all.push_back(std::move(checked));
        }
    }
    return reportNotebooks(all, arguments);
}

int writePage(const Arguments &arguments)
{
    const auto [library, files] = namedIn(arguments);
    if (files.size() != 2)
        throw UsageError(NotebookText::tr("notebook page takes FILE OUT; see springstep notebook --help."));
    const QString &out = files[1];
    const bool isPdf = out.endsWith(".pdf", Qt::CaseInsensitive);
    if (!isPdf && !out.endsWith(".html", Qt::CaseInsensitive))
        throw UsageError(
            NotebookText::tr("%1 is not the name of a page; it can end in .html or .pdf.").arg(quoted(out)));
    const Notebook notebook = readNotebook(files[0], library);
    const EntryPicture picture = entryPicture(library);
    writeWholeFile(out, isPdf ? notebookPdf(notebook, library, picture)
                              : notebookHtml(notebook, library, picture));
    return exitDone;
}

/// Returns the lessons of --lessons, or all.
QStringList lessonsFor(const Arguments &arguments, const LessonLibrary &library)
{
    QStringList ids;
    if (!arguments.has("lessons")) {
        for (std::size_t i = 0; i < library.entries(); ++i)
            ids << library.entry(i).id;
        return ids;
    }
    ids = arguments.value("lessons").split(',');
    for (const QString &id : ids) {
        if (!library.lesson(id))
            throw UsageError(NotebookText::tr("--lessons: %1").arg(noLesson(id, library)));
    }
    return ids;
}

int writeOwn(const Arguments &arguments)
{
    const auto [library, files] = namedIn(arguments);
    if (files.size() != 1)
        throw UsageError(NotebookText::tr("notebook write takes OUT; see springstep notebook --help."));
    const QString &out = files[0];
    if (!out.endsWith(notebookEnding))
        throw UsageError(NotebookText::tr("%1 is not the name of a notebook; it ends in %2.")
                             .arg(quoted(out), notebookEnding));
    const NotebookPlan plan{.name = arguments.value("name"),
                            .lessons = lessonsFor(arguments, library),
                            .gallery = galleryFolder()};
    writeWholeFile(out, notebookText(collectNotebook(plan, library, Progress(), Notes(), Proofs())));
    return exitDone;
}

/// @throws UsageError for options of another action
void checkOptions(const Arguments &arguments, const QString &action)
{
    for (const char *option : {"json", "csv"}) {
        if (arguments.has(option) && action != "check")
            throw UsageError(NotebookText::tr("--%1 is for notebook check. Leave it out.").arg(option));
    }
    if (arguments.has("json") && arguments.has("csv"))
        throw UsageError(NotebookText::tr("--json and --csv are two forms of the result. Leave one out."));
    for (const char *option : {"name", "lessons"}) {
        if (arguments.has(option) && action != "write")
            throw UsageError(NotebookText::tr("--%1 is for notebook write. Leave it out.").arg(option));
    }
}

}

int runNotebook(const Arguments &arguments)
{
    const QString action = arguments.names[0];
    checkOptions(arguments, action);
    if (action == "check")
        return checkNotebooks(arguments);
    if (action == "page")
        return writePage(arguments);
    if (action == "write")
        return writeOwn(arguments);
    throw UsageError(
        NotebookText::tr("notebook cannot %1; it can \"check\", \"page\" or \"write\".").arg(quoted(action)));
}

}
