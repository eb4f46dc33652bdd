#include "app/cli/web_page.h"

#include "app/cli/experiment_argument.h"
#include "app/cli/option_values.h"
#include "app/model/text/quantity_text.h"
#include "app/model/text/quoting.h"
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

/// Returns a quantity that can be read in `scene`. Without a body in its name, it is that of the first one.
/// @throws UsageError
Quantity quantityOption(const QString &name, const sim::Scene &scene)
{
    const std::optional<Quantity> read = quantityFrom(name);
    if (!read || read->what == QuantityKind::time) {
        QStringList ids;
        for (const QuantityKind what : quantityKinds()) {
            if (what != QuantityKind::time)
                ids << idOf(what);
        }
        throw UsageError(WebPageCliText::tr("--plot is %1; it can be %2, with its bodies, as in %3 and %4.")
                             .arg(quoted(name), ids.join(QStringLiteral(", ")), QStringLiteral("y(foot0)"),
                                  QStringLiteral("distance(foot0, body)")));
    }
    const Quantity quantity = boundTo(*read, QString::fromStdString(scene.names.front()));
    const std::optional<NoValue> why = whyNot(quantity, scene);
    if (why == NoValue::noSuchBody) {
        QStringList bodies;
        for (const std::string &body : scene.names)
            bodies << QString::fromStdString(body);
        const bool isOther = bodies.contains(quantity.body);
        const QString &missing = isOther ? quantity.other : quantity.body;
        throw UsageError(WebPageCliText::tr("--plot is %1, but there is no %2; there is %3.")
                             .arg(quoted(name), quoted(missing), quotedList(bodies, missing)));
    }
    if (why)
        throw UsageError(
            WebPageCliText::tr("--plot is %1, which has no value in this scene. Choose another one.")
                .arg(quoted(name)));
    return quantity;
}

/// @throws UsageError
std::vector<PlotSpec> plotsFrom(const Arguments &arguments, const sim::Script &script)
{
    const QStringList names = arguments.values("plot");
    const sim::Scene scene = sim::sceneOf(script, script.values);
    if (names.isEmpty() || scene.names.empty())
        return plotsOfPage(script);
    if (names.size() > static_cast<qsizetype>(PlotList::most))
        throw UsageError(WebPageCliText::tr("--plot is given %1 times; a web page has room for %2 plots.")
                             .arg(names.size())
                             .arg(PlotList::most));
    std::vector<PlotSpec> plots;
    for (const QString &name : names) {
        const qsizetype colon = name.indexOf(':');
        PlotSpec plot{quantityOption(name.left(colon), scene)};
        if (colon >= 0)
            plot.across = quantityOption(name.mid(colon + 1), scene);
        plots.push_back(plot);
    }
    return plots;
}

/// @throws UsageError
std::optional<PageGhost> ghostFrom(const Arguments &arguments, const Branches &branches)
{
    if (!arguments.has("ghost"))
        return std::nullopt;
    const QString name = arguments.value("ghost");
    QStringList names;
    for (const Branch &branch : branches.all()) {
        if (branch.name == name)
            return PageGhost{branch.name, branch.script};
        names << branch.name;
    }
    if (names.isEmpty())
        throw UsageError(
            WebPageCliText::tr("--ghost is %1, but FILE has no other run. Keep one in the window.")
                .arg(quoted(name)));
    throw UsageError(
        WebPageCliText::tr("--ghost is %1; it can be %2.").arg(quoted(name), quotedList(names, name)));
}

}

bool isWebPage(const Arguments &arguments)
{
    return arguments.names[1].endsWith(pageEnding, Qt::CaseInsensitive);
}

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
    plan.plots = plotsFrom(arguments, plan.experiment.script);
    plan.ghost = ghostFrom(arguments, plan.experiment.branches);
    plan.light = pageColors(Scheme::light);
    plan.dark = pageColors(Scheme::dark);
    return plan;
}

}
