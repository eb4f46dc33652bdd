#pragma once

#include "app/model/code_listing.h"

#include <optional>

namespace app {

/// The next moment after the cursor at which a phase of `section` has just been done: in the frame under way, or else in
/// the next one. Empty for a section that no phase belongs to.
std::optional<sim::Cursor> runTarget(const CodeSection &section, const sim::Timeline &timeline);

/// The moment right after the phase of `section` in the step that is shown: the one under way, or between two frames the
/// first of the next. Of several phases, after the one that was done last, or else the first. Empty for a section that no
/// phase belongs to.
std::optional<sim::Cursor> momentOf(const CodeSection &section, const sim::Timeline &timeline);

/// What a pixel counts of a drag that is to be fine.
constexpr double finePixel = 0.1;
/// The value of a number that was `from` when the mouse took hold of it, `way` px farther to the right. 200 px are as
/// much as its slider. Never out of its range; for a choice 24 px are one more.
double draggedValue(const lessons::Parameter &parameter, double from, double way);

/// What somebody typed for a parameter: a number in its range, or the id of a choice.
/// @throws Refusal
double typedValue(const lessons::Parameter &parameter, const QString &text);
/// A parameter's value as it is typed.
QString typedText(const lessons::Parameter &parameter, double value);

}
