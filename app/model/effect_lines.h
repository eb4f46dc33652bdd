#pragma once

#include "app/model/known_effects.h"
#include "sim/analysis/cost/cost.h"

namespace app {

// What the ledger of effects says, in lines and words.

/// What a line of it is about.
enum class EffectRole {
    acts,
    idle,    ///< listed, but set so that it changes nothing: left out
    off,     ///< listed, but switched off
    offered, ///< not listed, but the scene is built and can have it
    rest,    ///< what no effect takes of the frame
    absent,  ///< not listed here; other lessons know it
};

/// One line of the ledger.
struct EffectLine
{
    QString id;
    QString title;
    QString help; ///< what it is for and what was measured, a line each
    sim::EffectKind kind = sim::EffectKind::motion;
    EffectRole role = EffectRole::acts;
    double ns = 0.0; ///< a frame; 0 where nothing was measured
    // As shown; empty where there is nothing to say.
    QString frame;  ///< µs a frame
    QString spread; ///< of that: "±0.0003"
    QString point;  ///< µs a frame for each of the points that it works on
    QString points;
    QString runs;   ///< "×1"
    QString note;   ///< in place of those: "not in this scene"
    QString saving; ///< a sentence: what a frame would cost without it

    bool isListed() const { return role != EffectRole::rest && role != EffectRole::absent; }
    bool isOn() const { return role == EffectRole::acts || role == EffectRole::idle; }
    /// "Springs, 0.0314\u2009µs a frame, on".
    QString spoken() const;
};

/// What the lines are made from.
struct EffectFacts
{
    std::vector<sim::EffectPtr> listed; ///< in the order in which they run
    std::vector<std::string> off;       ///< ids
    std::vector<sim::EffectPtr> leftOut;
    const sim::FrameCost *cost = nullptr; ///< null: not measured yet
    std::vector<KnownEffect> known;
    std::vector<const sim::EffectDescription *> offered = {}; ///< what a scene that is built can have
};

/// A line for each id that is listed, then for each that is offered, then the rest of the frame, then one for each kind that has absent effects.
std::vector<EffectLine> effectLines(const EffectFacts &facts);

/// "0.0460\u2009µs a frame, ±0.0020".
QString frameWords(const sim::FrameCost &cost);

}
