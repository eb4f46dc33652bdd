#include "app/cli/web_page.h"

#include "app/cli/experiment_argument.h"
#include "app/cli/option_values.h"
#include "app/cli/terminal.h"
#include "app/ui/film/page_colors.h"

#include <QCoreApplication>

#include <algorithm>
#include <optional>

namespace app {

namespace {

struct WebPageCliText
{
    Q_DECLARE_TR_FUNCTIONS(WebPageCliText)
};

constexpr double leastPageRate = 0.1; ///< frames per second
constexpr double mostPageRate = 120.0;

/// Returns whether the value of an option of `film` is another one than its default.
bool isChosen(const Arguments &arguments, const QString &name)
{
    const auto &all = verbs();
    const auto film =
        std::find_if(all.begin(), all.end(), [](const Verb &one) { return one.name == "film"; });
    const auto option = std::find_if(film->options.begin(), film->options.end(),
                                     [&](const Option &one) { return one.name == name; });
    return arguments.value(name) != option->defaultValue;
}

/// @throws UsageError, or UserError: the experiment cannot be read
WebPagePlan pagePlan(const Arguments &arguments, const LessonLibrary &library)
{
    for (const char *name : {"size", "theme"}) {
        if (isChosen(arguments, name))
            throw UsageError(
                WebPageCliText::tr(
                    "--%1 is for films; a web page has the size and the colours of its reader's browser. "
                    "Leave it out.")
                    .arg(QLatin1String(name)));
    }
    WebPagePlan plan;
    plan.out = arguments.names[1];
    plan.from = wholeNumberOption(arguments, "from", mostFrames);
    if (arguments.has("to"))
        plan.to = wholeNumberOption(arguments, "to", mostFrames);
    if (arguments.has("fps"))
        plan.rate = numberOption(arguments, "fps", leastPageRate, mostPageRate);
    plan.experiment = experimentFromFile(arguments.names[0], library);
    if (!arguments.has("to"))
        plan.to = plan.experiment.frames;
    plan.plots = plotsOfPage(plan.experiment.script);
    plan.light = pageColors(Scheme::light);
    plan.dark = pageColors(Scheme::dark);
    return plan;
}

/// Makes the page. Returns false if it was interrupted.
bool isMade(WebPage &page, std::int64_t last)
{
    TerminalLine status;
    while (page.goOn()) {
        QCoreApplication::processEvents();
        if (isInterrupted())
            return false;
        if (status.isDue())
            status.show(WebPageCliText::tr("Frame %1 of %2").arg(page.frame()).arg(last));
    }
    return true;
}

}

bool isWebPage(const Arguments &arguments)
{
    return arguments.names[1].endsWith(pageEnding, Qt::CaseInsensitive);
}

int runWebPage(const Arguments &arguments)
{
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    const WebPagePlan plan = pagePlan(arguments, library);
    listenForInterrupt();
    std::optional<Waiting> waiting(WebPageCliText::tr("Setting up the run"));
    WebPage page(plan, library);
    waiting.reset();
    if (!isMade(page, plan.to)) {
        printMessage(WebPageCliText::tr("Stopped at frame %1 of %2.").arg(page.frame()).arg(plan.to));
        return exitInterrupted;
    }
    if (page.endsEarly().isEmpty())
        return exitDone;
    printMessage(page.endsEarly());
    return exitNo;
}

}
