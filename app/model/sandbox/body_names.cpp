#include "app/model/sandbox/body_names.h"

#include "app/listing/language.h"
#include "app/model/sandbox/blueprint_edits.h"
#include "app/model/sandbox/blueprint_limits.h"

#include <QCoreApplication>

#include <algorithm>
#include <memory>
#include <utility>

namespace app {

namespace {

struct BodyNamesText
{
    Q_DECLARE_TR_FUNCTIONS(BodyNamesText)
};

}

std::optional<Renaming> renamingBetween(const sim::Blueprint &before, const sim::Blueprint &after)
{
    const auto sameName = [](const sim::BlueprintPoint &one, const sim::BlueprintPoint &other) {
        return one.name == other.name;
    };
    const auto [old, fresh] = std::mismatch(before.points.begin(), before.points.end(), after.points.begin(),
                                            after.points.end(), sameName);
    if (old == before.points.end() || fresh == after.points.end())
        return {};
    sim::Blueprint renamed = before;
    renamed.points[std::size_t(old - before.points.begin())].name = fresh->name;
    return renamed == after ? std::optional(Renaming{old->name, fresh->name}) : std::nullopt;
}

QString whyNotAName(const QString &name)
{
    if (!built::isName(name) || name.contains('.'))
        return BodyNamesText::tr(
                   "A name is a letter from a to z, then up to %1 letters, digits or _. Write it "
                   "without spaces and accents.")
            .arg(built::longestName - 1);
    if (!listing::isUsableName(name.toStdString()))
        return BodyNamesText::tr("“%1” is a word of the code. Choose another name, such as “%1_1”.")
            .arg(name);
    return {};
}

sim::Script withBodyRenamed(sim::Script script, const Renaming &renaming)
{
    if (!script.values.blueprint)
        return script;
    sim::Blueprint plan = *script.values.blueprint;
    const std::optional<int> point = pointCalled(plan, renaming.from);
    if (!point || pointCalled(plan, renaming.to))
        return script;
    plan.points[std::size_t(*point)].name = renaming.to;
    script.values.blueprint = std::make_shared<const sim::Blueprint>(std::move(plan));
    if (auto start = script.bodies.extract(renaming.from)) {
        start.key() = renaming.to;
        script.bodies.insert(std::move(start));
    }
    for (sim::Event &event : script.input) {
        sim::Grab *grab = std::get_if<sim::Grab>(&event.what);
        if (grab && grab->body == renaming.from)
            grab->body = renaming.to;
    }
    return script;
}

}
