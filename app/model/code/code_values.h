#pragma once

#include "app/model/code/code_listing.h"

#include <QString>

#include <optional>
#include <vector>

namespace app {

/// The value that a line of code computed, shown at the end of the line.
struct CodeChip
{
    std::size_t section = 0;
    std::size_t line = 0; ///< in the section
    QString text;         ///< "(15.7, −55.2)", "−2.29 → −1.49"
    QStringList shorter;  ///< for places that are too narrow for `text`, longest first
    QString tip;          ///< with names and units
    friend bool operator==(const CodeChip &, const CodeChip &) = default;
};

/// Returns the values of `moments` on the lines that assign them. `point` is the point that the values belong to.
std::vector<CodeChip> chipsOf(const CodeListing &listing, const std::vector<sim::PhaseExplanation> &moments,
                              const sim::ComposedInterval &interval, int point);

/// Removes the values from the lines that run as phase `next` of a step. These lines computed them earlier, perhaps for
/// another body.
void dropNext(std::vector<CodeChip> &chips, const CodeListing &listing, int next);

/// Returns the values of the parameters on the lines of the set-up that read them.
std::vector<CodeChip> parameterChips(const CodeListing &listing, const lessons::Step &step,
                                     const sim::Values &values);

/// Returns the line of `section` that shows `live`: the line that assigns it, else one that returns it, else the first
/// that names it.
std::optional<std::size_t> lineOf(const CodeSection &section, const sim::LiveValue &live);

/// Formats a number for readers: about three digits, with a proper minus sign. `more` adds decimals, or removes them if
/// it is negative.
QString shownNumber(double value, int more = 0);
QString shownValue(const std::variant<double, sim::Vec2> &value, int more = 0);

/// Returns the size below which a number computed in `scene` is rounding noise: 10^-12 of the scene's extent.
double noiseOf(const sim::Scene &scene);
/// Returns `value`, with 0 for each component that is smaller than `noise`.
std::variant<double, sim::Vec2> withoutNoise(const std::variant<double, sim::Vec2> &value, double noise);

}
