#pragma once

#include <QStringList>

#include <optional>
#include <variant>

class QCommandLineParser;

namespace app {

/// The verbs, as messages list them.
QStringList verbs();

/// Says what is wrong with the arguments. Returns the exit code.
int refuseUse(const QString &sentence);

/// Reads the arguments that follow `verb`: options, and one argument for each of `names` (any number when `verb`
/// is empty). Prints help if asked. Returns the exit code when that is all there is to do: for help and for bad
/// use, which is said in one sentence.
std::optional<int> readArguments(QCommandLineParser &parser, const QString &verb,
                                 const QStringList &arguments, const QStringList &names);

/// The file that the window is to open, empty for none; or the exit code, when that is settled: for help, for
/// the version and for bad use.
std::variant<int, QString> readWindowArguments(const QStringList &arguments);

/// Runs a verb that needs no window system. Nothing if `arguments` have another verb or none.
std::optional<int> runPlainVerb(const QStringList &arguments);

}
