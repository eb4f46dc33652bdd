#include "app/ui/film/film.h"
#include "app/cli/experiment_argument.h"
#include "app/cli/option_values.h"
#include "app/cli/terminal.h"
#include "app/cli/web_page.h"
#include "app/model/text/language.h"

#include <QCoreApplication>

#include <optional>

namespace app {

namespace {

struct FilmText
{
    Q_DECLARE_TR_FUNCTIONS(FilmText)
};

constexpr double leastRate = 0.1; ///< frames per second

FilmKind kindOf(const QString &out)
{
    try {
        return filmKind(out);
    } catch (const UserError &error) {
        throw UsageError(
            FilmText::tr("%1 For a web page, choose one that ends in .html.").arg(error.sentence()));
    }
}

double frameRate(const Arguments &arguments, FilmKind kind)
{
    if (kind == FilmKind::pictures)
        throw UsageError(
            FilmText::tr("--fps is for a film in one file; PNG files have no time in them. Leave it out."));
    return numberOption(arguments, "fps", leastRate, kind == FilmKind::gif ? mostGifRate : mostVideoRate);
}

/// @throws UsageError, or UserError: the experiment cannot be read
FilmPlan planFrom(const Arguments &arguments, const LessonLibrary &library)
{
    FilmPlan plan;
    plan.out = arguments.names[1];
    const FilmKind kind = kindOf(plan.out);
    for (const char *name : {"plot", "ghost"}) {
        if (arguments.has(name))
            throw UsageError(FilmText::tr("--%1 is for web pages, which end in .html. Leave it out.")
                                 .arg(QLatin1String(name)));
    }
    plan.size = pictureSize(arguments);
    plan.scheme = colorScheme(arguments);
    plan.from = wholeNumberOption(arguments, "from", mostFrames);
    if (arguments.has("to"))
        plan.to = wholeNumberOption(arguments, "to", mostFrames);
    if (arguments.has("fps"))
        plan.rate = frameRate(arguments, kind);
    plan.experiment = experimentFromFile(arguments.names[0], library);
    if (!arguments.has("to"))
        plan.to = plan.experiment.frames;
    return plan;
}

/// Makes a film or a web page. Returns false if it was interrupted.
bool isMade(Export &made, std::int64_t last)
{
    TerminalLine status;
    while (made.goOn()) {
        QCoreApplication::processEvents();
        if (isInterrupted())
            return false;
        if (status.isDue())
            status.show(FilmText::tr("Frame %1 of %2, %3 %")
                            .arg(made.frame())
                            .arg(last)
                            .arg(100 * made.done() / made.total()));
    }
    return true;
}

template <class Made, class Plan>
int make(const Plan &plan, const LessonLibrary &library)
{
    listenForInterrupt();
    std::optional<Waiting> waiting(FilmText::tr("Setting up the run"));
    Made made(plan, library);
    waiting.reset();
    if (!isMade(made, plan.to))
        return printInterrupted(made.frame(), plan.to);
    if (made.endsEarly().isEmpty())
        return exitDone;
    printMessage(made.endsEarly());
    return exitNo;
}

}

int runFilm(const Arguments &arguments)
{
    Language language(languageCode(arguments));
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders(), &language);
    return isWebPage(arguments) ? make<WebPage>(pagePlan(arguments, library), library)
                                : make<Film>(planFrom(arguments, library), library);
}

}
