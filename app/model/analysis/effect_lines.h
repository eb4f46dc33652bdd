#pragma once

#include "app/model/catalog/known_effects.h"
#include "sim/analysis/cost/cost.h"

namespace app {

// The lines and texts of the effect ledger.

/// The role of a line.
enum class EffectRole {
    acts,
    idle,    ///< listed, but left out because its settings make it do nothing
    off,     ///< listed, but switched off
    offered, ///< not listed, but available in the sandbox scene
    rest,    ///< time of the frame outside effects
    absent,  ///< not listed here; other lessons know it
};

/// One line of the ledger.
struct EffectLine
{
    QString id;
    QString title;
    QString help; ///< purpose and measured numbers, one line each
    sim::EffectKind kind = sim::EffectKind::motion;
    EffectRole role = EffectRole::acts;
    double ns = 0.0; ///< per frame; 0 if nothing was measured
    // Texts as shown; empty if there is nothing to show.
    QString frame;  ///< µs per frame
    QString spread; ///< uncertainty of `frame`: "±0.0003"
    QString point;  ///< µs per frame for each of the points that it works on
    QString points;
    QString runs;   ///< "×1"
    QString note;   ///< replaces the texts above: "not in this scene"
    QString saving; ///< a sentence: the cost of a frame without the effect

    bool isListed() const { return role != EffectRole::rest && role != EffectRole::absent; }
    bool isOn() const { return role == EffectRole::acts || role == EffectRole::idle; }
    /// "Springs, 0.0314\u2009µs a frame, on".
    QString spoken() const;
};

/// The data that the lines are made from.
struct EffectFacts
{
    std::vector<sim::EffectPtr> listed; ///< in the order in which they run
    std::vector<std::string> off;       ///< ids
    std::vector<sim::EffectPtr> leftOut;
    const sim::FrameCost *cost = nullptr; ///< null: not measured yet
    std::vector<KnownEffect> known;
    std::vector<const sim::EffectDescription *> offered = {}; ///< effects available in a sandbox scene
};

/// Returns a line for each listed id, then for each offered one, then for the rest of the frame, then for each kind
/// that has absent effects.
std::vector<EffectLine> effectLines(const EffectFacts &facts);

/// "0.0460\u2009µs a frame, ±0.0020".
QString frameWords(const sim::FrameCost &cost);

}
