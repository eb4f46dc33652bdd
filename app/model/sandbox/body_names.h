#pragma once

#include "sim/run/script/script.h"
#include "sim/scene/blueprint.h"

#include <QString>

#include <optional>
#include <string>

namespace app {

/// A new name of a body in a sandbox scene.
struct Renaming
{
    std::string from;
    std::string to;
    friend bool operator==(const Renaming &, const Renaming &) = default;
};

/// Returns the new name if `after` differs from `before` in the name of one body only. Otherwise empty.
std::optional<Renaming> renamingBetween(const sim::Blueprint &before, const sim::Blueprint &after);

/// Returns why a learner cannot give a body this name, as a sentence; empty if she can. A name has to fit into files,
/// conditions and listings: it is a letter, then letters, digits and _, and no word of the language of listings.
QString whyNotAName(const QString &name);

/// Returns the script with a new name for a body: in its scene, its start and the input that takes it. The run stays the
/// same. A scene without this body, or with another one of the new name, stays as it is.
sim::Script withBodyRenamed(sim::Script script, const Renaming &renaming);

}
