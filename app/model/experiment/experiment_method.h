#pragma once

#include "app/model/experiment/json_fields.h"
#include "lessons/api/listing.h"
#include "sim/run/script/script.h"

namespace app {

/// Reads "method", "h" and "tolerance" of a file into `script`, which holds those of the file's step.
/// @throws UserError: an unknown method, an invalid step, or a step that does not fit the method
void readMethod(const JsonFields &fields, sim::Script &script);

/// Reads "code", if the file has it, and makes it the method of `script`, whose scene must be complete. `original` is the
/// listing of the file's step; see learnersText().
/// @throws UserError: too long, or it does not compile
void readCode(const JsonFields &fields, const lessons::Listing &original, sim::Script &script);

/// Returns the text of a listing in the field `name`; empty if there is none.
/// @throws UserError: not a text, or longer than listing::maxTextBytes
QString codeText(const JsonFields &fields, const QString &name);

/// Returns the text in the field `name` that a learner has made of `original`. Its comments are in the language
/// of the window, also if the file was written in another one.
/// @throws UserError as codeText()
QString learnersText(const JsonFields &fields, const QString &name, const lessons::Listing &original);

}
