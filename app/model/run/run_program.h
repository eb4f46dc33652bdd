#pragma once

#include "app/listing/program.h"
#include "sim/run/track.h"

#include <QString>

#include <memory>
#include <optional>

namespace app {

// The listing that computes a run, if its method is *Your code*.

/// Returns the program of `method`, or null if it is another method.
std::shared_ptr<const listing::Program> programOf(const sim::MethodPtr &method);
/// Compiles the listing `code` for the names of the scene of `script`.
listing::Compiled compiledFor(const sim::Script &script, const QString &code);

/// Returns the mistake in the listing that ended the run. Empty if the run has not ended, or for another reason.
std::optional<listing::RunError> runErrorOf(const sim::Track &track);

/// Returns a mistake with its line: "Line 7 of your code: This divides by 0."
QString mistakeSentence(const listing::RunError &error);

/// Returns why the run ended, as sentenceFor(). For a listing or a rule, names the line and its
/// mistake. The run must have ended.
QString endSentence(const sim::Track &track);

}
