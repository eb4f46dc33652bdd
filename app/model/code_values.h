#pragma once

#include "app/model/code_listing.h"

#include <QString>

#include <optional>
#include <vector>

namespace app {

/// What a line of code computed, to be shown at its end.
struct CodeChip
{
    std::size_t section = 0;
    std::size_t line = 0; ///< in the section
    QString text;         ///< "(15.7, −55.2)", "−2.29 → −1.49"
    QStringList shorter;  ///< for places that are too narrow for `text`, the longest first
    QString tip;          ///< with names and units
    friend bool operator==(const CodeChip &, const CodeChip &) = default;
};

/// The numbers of `moments` on the lines that assign them. `point` is the point whose numbers they are.
std::vector<CodeChip> chipsOf(const CodeListing &listing, const std::vector<sim::PhaseExplanation> &moments,
                              const sim::ComposedInterval &interval, int point);

/// Removes the values of the lines that run as phase `next` of a step: they are what these lines computed before, perhaps
/// for another body.
void dropNext(std::vector<CodeChip> &chips, const CodeListing &listing, int next);

/// The parameters' values on the lines of the set-up that read them.
std::vector<CodeChip> parameterChips(const CodeListing &listing, const lessons::Step &step,
                                     const sim::Values &values);

/// The line of `section` that stands for `live`: the one that assigns it, else one that returns it, else the
/// first that names it.
std::optional<std::size_t> lineOf(const CodeSection &section, const sim::LiveValue &live);

/// A number as a person reads it: three digits or so, with a minus sign. `more` asks for further decimals, or fewer.
QString shownNumber(double value, int more = 0);
QString shownValue(const std::variant<double, sim::Vec2> &value, int more = 0);

/// Returns the size below which a number computed in `scene` is rounding noise: 10^-12 of the scene's extent.
double noiseOf(const sim::Scene &scene);
/// Returns `value` with 0 in place of parts that are smaller than `noise`.
std::variant<double, sim::Vec2> withoutNoise(const std::variant<double, sim::Vec2> &value, double noise);

}
