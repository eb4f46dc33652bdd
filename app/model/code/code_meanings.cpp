#include "app/model/code/code_meanings.h"

#include "app/model/text/sentences.h"
#include "sim/effects/all_effects.h"

#include <QCoreApplication>

#include <optional>

namespace app {

namespace {

using enum sim::EffectKind;

struct OfKind
{
    const char *name;
    std::optional<sim::EffectKind> kind; ///< of the phase; empty: any
    const char *unit;
    const char *what; ///< in the context CodeSymbols; may be empty
};

constexpr OfKind meanings[] = {
    {"from", spring, "px",
     QT_TRANSLATE_NOOP("CodeSymbols", "Where the body is, as seen from the other end of its spring.")},
    {"out", spring, "",
     QT_TRANSLATE_NOOP("CodeSymbols",
                       "The direction away from the other end of the spring, as an arrow of length 1.")},
    {"angle", spring, "rad", QT_TRANSLATE_NOOP("CodeSymbols", "The same direction, as an angle.")},
    {"length", spring, "px",
     QT_TRANSLATE_NOOP("CodeSymbols", "How far the body is from the other end of its spring.")},
    {"share", spring, "",
     QT_TRANSLATE_NOOP("CodeSymbols",
                       "How much farther away the spring pulls the body, as a share of its distance.")},
    {"target", spring, "px", QT_TRANSLATE_NOOP("CodeSymbols", "Where the spring pulls the body to.")},
    {"d", spring, "px",
     QT_TRANSLATE_NOOP("CodeSymbols", "The arrow from the body to where the spring pulls it.")},
    {"pull", spring, "px/frame²",
     QT_TRANSLATE_NOOP("CodeSymbols", "How much all springs together add to the velocity in each frame.")},
    {"pull", gravity, "px/frame²",
     QT_TRANSLATE_NOOP("CodeSymbols", "How much gravity adds to the velocity in each frame.")},
    {"d", driver, "px", QT_TRANSLATE_NOOP("CodeSymbols", "The arrow from the body to its target.")},
    {"keep", damping, "",
     QT_TRANSLATE_NOOP("CodeSymbols", "The share of the velocity that is left after this step.")},
    {"pull", std::nullopt, "px/frame²",
     QT_TRANSLATE_NOOP("CodeSymbols", "How much is added to the velocity in each frame.")},
    {"x", std::nullopt, "px", QT_TRANSLATE_NOOP("CodeSymbols", "Where the body is: x to the right, y down.")},
    {"v", std::nullopt, "px/frame",
     QT_TRANSLATE_NOOP("CodeSymbols", "The velocity: how far the body moves in a frame.")},
    {"velocity", std::nullopt, "px/frame",
     QT_TRANSLATE_NOOP("CodeSymbols", "The velocity: how far the body moves in a frame.")},
    {"a", std::nullopt, "px/frame²",
     QT_TRANSLATE_NOOP("CodeSymbols", "How much is added to the velocity in each frame.")},
    {"target", std::nullopt, "px", ""},
    {"d", std::nullopt, "px", ""},
    {"distance", std::nullopt, "px",
     QT_TRANSLATE_NOOP("CodeSymbols", "How far the two are from each other.")},
    {"length", std::nullopt, "px", ""},
    {"spin", std::nullopt, "°/frame", QT_TRANSLATE_NOOP("CodeSymbols", "How fast it turns.")},
    {"angle", std::nullopt, "°", QT_TRANSLATE_NOOP("CodeSymbols", "The direction in which it points.")},
};

}

Meaning meaningOf(const QString &name, const sim::Phase &phase)
{
    const QString whole = name.section('.', 0, 0);
    const auto *described =
        phase.effect ? sim::findDescription(sim::allEffects(), phase.effect->id()) : nullptr;
    if (described) {
        for (const sim::CodeVariable &one : described->variables) {
            if (whole == QLatin1String(one.name))
                return {QString::fromUtf8(one.unit), phrase(one.meaning)};
        }
    }
    for (const OfKind &one : meanings) {
        if (whole == QLatin1String(one.name) && (!one.kind || one.kind == phase.kind))
            return {QString::fromUtf8(one.unit),
                    *one.what ? QCoreApplication::translate("CodeSymbols", one.what) : QString()};
    }
    return {};
}

}
