#include "app/cli/film.h"

#include "app/cli/experiment_named.h"
#include "app/cli/terminal.h"
#include "app/model/sentences.h"
#include "app/ui/film/film.h"

#include <QCoreApplication>

#include <optional>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(FilmVerb)
};

FilmPlan planOf(const FilmRequest &request, const LessonLibrary &library)
{
    FilmPlan plan;
    plan.experiment = experimentIn(request.file, library);
    plan.out = request.out;
    plan.size = request.size;
    plan.scheme = request.scheme;
    plan.from = request.from;
    plan.to = request.to.value_or(plan.experiment.frames);
    plan.rate = request.rate;
    return plan;
}

/// Whether the film is whole: else somebody has pressed Ctrl+C.
bool isShot(Film &film, std::int64_t last)
{
    StatusLine status;
    while (film.goOn()) {
        QCoreApplication::processEvents();
        if (isInterrupted())
            return false;
        if (status.isDue())
            status.show(Text::tr("Frame %1 of %2, %3 %")
                            .arg(film.frame())
                            .arg(last)
                            .arg(100 * film.done() / film.total()));
    }
    return true;
}

int shoot(Film &film, std::int64_t last)
{
    if (!isShot(film, last)) {
        say(Text::tr("Stopped at frame %1 of %2.").arg(film.frame()).arg(last));
        return exitInterrupted;
    }
    if (!film.stop())
        return exitDone;
    say(sentenceFor(*film.stop()));
    return exitNo;
}

}

int makeFilm(const FilmRequest &request)
{
    try {
        const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
        const FilmPlan plan = planOf(request, library);
        listenForInterrupt();
        std::optional<Waiting> waiting(Text::tr("Setting up the run"));
        Film film(plan, library);
        waiting.reset();
        return shoot(film, plan.to);
    } catch (const Refusal &refusal) {
        say(refusal.sentence());
    } catch (const sim::Error &error) {
        say(sentenceFor(error));
    }
    return exitBadUse;
}

}
