#pragma once

#include "app/model/code/code_listing.h"

#include <optional>

namespace app {

/// Returns the next moment after the cursor at which a phase of `section` has just run: in the current frame, or else
/// in the next one. Empty for a section without phases.
std::optional<sim::Cursor> runTarget(const CodeSection &section, const sim::Timeline &timeline);

/// Returns the moment right after the phase of `section` in the step on display: the current step, or between two
/// frames the first step of the next frame. If the section has several phases, the last completed one counts, or else
/// the first. Empty for a section without phases.
std::optional<sim::Cursor> momentOf(const CodeSection &section, const sim::Timeline &timeline);

/// How far one pixel of a fine drag counts, relative to a normal drag.
constexpr double finePixel = 0.1;
/// Returns the value of a number that was `from` when the drag began, after the mouse has moved `way` px to the right.
/// 200 px cover the same range as the slider. For a choice, 24 px move on by one value. The value never leaves its
/// range.
double draggedValue(const lessons::Parameter &parameter, double from, double way);

/// Returns the value that the user typed for a parameter: a number in its range, or the id of a choice.
/// @throws UserError
double typedValue(const lessons::Parameter &parameter, const QString &text);
/// Returns the value of a parameter in the form in which the user types it.
QString typedText(const lessons::Parameter &parameter, double value);

}
