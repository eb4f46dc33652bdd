#pragma once

#include "app/model/text/user_error.h"

#include <QHash>
#include <QStringList>

#include <vector>

namespace app {

/// An argument that a verb requires.
struct Argument
{
    QString name; ///< the last one may end in "...": then there can be more of it
    QString summary;
};

/// The Qt application that a verb needs.
enum class ApplicationKind {
    core,   ///< QCoreApplication
    widgets ///< QApplication, without a display, for verbs that draw
};

/// An option of a verb.
struct Option
{
    QString name; ///< without dashes
    QString summary;
    QString valueName = {};    ///< the name of its value in help texts; empty for an option without a value
    QString defaultValue = {}; ///< empty if there is none
    ApplicationKind application = ApplicationKind::core; ///< what the verb needs if this option is given
};

/// The arguments and options that a verb was given.
struct Arguments
{
    QStringList names; ///< one for each entry of Verb::arguments, or more if the last one repeats
    QHash<QString, QStringList> options; ///< the values of given options, and of those with a default value

    bool has(const QString &option) const { return options.contains(option); }
    /// Returns the values of an option that was given several times.
    QStringList values(const QString &option) const { return options.value(option); }
    /// Returns the last of them.
    QString value(const QString &option) const
    {
        const QStringList all = values(option);
        return all.isEmpty() ? QString() : all.last();
    }
};

/// Wrong use of a verb. Its message starts with the program's name.
class UsageError : public UserError
{
public:
    using UserError::UserError;
};

/// A verb of the command line.
struct Verb
{
    QString name;
    QString summary;
    std::vector<Argument> arguments;
    std::vector<Option> options;
    /// Returns the exit code.
    /// @throws UserError, sim::Error
    int (*run)(const Arguments &arguments);
    ApplicationKind application = ApplicationKind::core;
};

/// Returns all verbs, in the order of help texts.
const std::vector<Verb> &verbs();

int runLessons(const Arguments &arguments);
int runCheck(const Arguments &arguments);
int runTrace(const Arguments &arguments);
int runAccuracy(const Arguments &arguments);
int runHardCases(const Arguments &arguments);
int runCost(const Arguments &arguments);
int runScreenshot(const Arguments &arguments);
int runFilm(const Arguments &arguments);
int runNotebook(const Arguments &arguments);
int runHandout(const Arguments &arguments);

}
