#pragma once

#include "app/model/code_listing.h"

#include <optional>
#include <vector>

namespace app {

/// A word of a line of code that may stand for a number.
struct CodeWord
{
    qsizetype from = 0; ///< its first character
    qsizetype length = 0;
    QString name;      ///< as it stands there: "pull", "room.floor"
    QString parameter; ///< the id, where the word reads a parameter: values["k"]
    friend bool operator==(const CodeWord &, const CodeWord &) = default;
    bool contains(qsizetype column) const { return column >= from && column < from + length; }
};

/// The words of a line, without those in comments and texts.
std::vector<CodeWord> wordsOf(const QString &line);

/// A place in the shown code where a parameter's number stands.
struct ParameterSpot
{
    std::size_t section = 0;
    std::size_t line = 0; ///< in the section
    CodeWord word;        ///< with the parameter's id
    friend bool operator==(const ParameterSpot &, const ParameterSpot &) = default;
};

/// The words that are parameters of `step` and nothing else: where the set-up reads one, the variable that it reads it
/// into, and the same name in the source of an effect that the set-up hands it to. A name that the code computes anew,
/// as the part of a velocity that is kept in a step, is none.
std::vector<ParameterSpot> parameterSpots(const CodeListing &listing, const lessons::Step &step,
                                          const sim::ComposedInterval &interval);

/// A word whose number is known while the program runs.
struct CodeSymbol
{
    QString name;
    QString title; ///< what a learner calls it: "Stiffness", or its name
    QString unit;
    QString what;      ///< what it is, in a sentence; may be empty
    QString parameter; ///< the id, if it is one
    int phase = -1;    ///< of a step, which computes it; -1 for what no phase computes
    friend bool operator==(const CodeSymbol &, const CodeSymbol &) = default;
};

/// What the word at `column` of a line stands for; empty for a word without a number. `point`: whose numbers are asked
/// for, where each point has its own.
std::optional<CodeSymbol> symbolAt(const CodeListing &listing, std::size_t section, std::size_t line,
                                   qsizetype column, const std::vector<ParameterSpot> &spots,
                                   const lessons::Step &step, const sim::ComposedInterval &interval,
                                   int point);

/// The unit of a number that `phase` computes; empty for what has none.
QString unitOf(const sim::LiveValue &live, const sim::Phase &phase);

}
