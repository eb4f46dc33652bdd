#pragma once

#include "app/model/code/code_listing.h"

#include <optional>
#include <vector>

namespace app {

/// A word in a line of code that may stand for a number.
struct CodeWord
{
    qsizetype from = 0; ///< index of its first character
    qsizetype length = 0;
    QString name;      ///< as written in the code: "pull", "room.floor"
    QString parameter; ///< id of the parameter that the word reads, if any: values["k"]
    friend bool operator==(const CodeWord &, const CodeWord &) = default;
    bool contains(qsizetype column) const { return column >= from && column < from + length; }
};

/// Returns the words of a line, without those in comments and string literals.
std::vector<CodeWord> wordsOf(const QString &line);

/// A place in the shown code that names a parameter.
struct ParameterSpot
{
    std::size_t section = 0;
    std::size_t line = 0; ///< in the section
    CodeWord word;        ///< with the id of the parameter
    friend bool operator==(const ParameterSpot &, const ParameterSpot &) = default;
};

/// Returns the words that stand for a parameter of `step` and nothing else. These are the places where the set-up reads
/// a parameter, the variables that it stores it in, and the same names in the source of effects that receive it. A name
/// that the code computes again is left out, such as the fraction of velocity kept in a step.
std::vector<ParameterSpot> parameterSpots(const CodeListing &listing, const lessons::Step &step,
                                          const sim::ComposedInterval &interval);

/// A word whose value is known while the program runs.
struct CodeSymbol
{
    QString name;
    QString title; ///< name for the learner: "Stiffness", or the word itself
    QString unit;
    QString what;      ///< description in one sentence; may be empty
    QString parameter; ///< id, if the symbol is a parameter
    int phase = -1;    ///< the phase of a step that computes it; -1 if no phase does
    friend bool operator==(const CodeSymbol &, const CodeSymbol &) = default;
};

/// Returns the symbol at `column` of a line. Empty for a word without a value. `point` selects the point, for symbols
/// that have a value for each point.
std::optional<CodeSymbol> symbolAt(const CodeListing &listing, std::size_t section, std::size_t line,
                                   qsizetype column, const std::vector<ParameterSpot> &spots,
                                   const lessons::Step &step, const sim::ComposedInterval &interval,
                                   int point);

/// Returns the unit of a number that `phase` computes. Empty for a number without a unit.
QString unitOf(const sim::LiveValue &live, const sim::Phase &phase);

}
