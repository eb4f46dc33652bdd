#pragma once

#include "app/model/breakpoints/condition.h"
#include "lessons/api/step.h"

#include <QHash>

#include <map>

/// The names that a condition may use, for look-up and for error messages.
namespace app::condition_names {

/// @throws UserError "Character 7: why"
[[noreturn]] void refuse(qsizetype place, const QString &why);

/// Returns the functions of bodies, such as distance(a, b), by name.
const QHash<QString, Condition::Operation::Kind> &bodyFunctions();
/// Returns a few of `names` for a sentence.
QString someOf(const QStringList &names);
/// Returns the names of the first bodies.
QStringList bodiesOf(const sim::Scene &scene);
QStringList parametersOf(const sim::Values &values);
/// Returns the ids of the values of each parameter of `step` that is a choice, by the id of the parameter.
std::map<QString, QStringList> choicesOf(const lessons::Step &step);
/// Returns each phase title once, in the learner's language.
QStringList phasesOf(const sim::Pipeline &pipeline);
/// Returns the numbers that each body has in a state such as `state`, by name.
QHash<QString, Condition::Operation::Kind> membersOf(const sim::State &state);
/// Returns the names of `members` as a list for a sentence.
QString listOf(const QHash<QString, Condition::Operation::Kind> &members);

}
