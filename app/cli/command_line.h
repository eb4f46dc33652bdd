#pragma once

#include "app/cli/verbs.h"

#include <QStringList>

#include <variant>

namespace app {

/// A verb with the arguments that it was given.
struct VerbCall
{
    const Verb *verb;
    Arguments arguments;
};

/// The exit code if nothing is left to do, after help, the version or an error message. Otherwise a verb to run, or the
/// file to open in the window; empty for none.
using CommandLine = std::variant<int, VerbCall, QString>;

/// Reads the arguments of the program. Prints help and the version if they ask for it. Prints one sentence if they are
/// wrong.
CommandLine readCommandLine(const QStringList &arguments);

/// Returns the application that a verb needs with these arguments.
ApplicationKind applicationFor(const VerbCall &call);

/// Runs a verb, and prints the message of an error. Returns the exit code.
int runVerb(const VerbCall &call);

/// Prints a sentence about wrong use, after the program's name. Returns the exit code.
int reportUsageError(const QString &sentence);

/// Returns the names of all verbs, as messages list them.
QString verbNames();

}
