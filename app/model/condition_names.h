#pragma once

#include "app/model/condition.h"

#include <QHash>

/// What a condition may speak of, for looking up and for sentences.
namespace app::condition_names {

/// @throws Refusal "Character 7: why"
[[noreturn]] void refuse(qsizetype place, const QString &why);

/// A few of `names`, for a sentence.
QString someOf(const QStringList &names);
/// The names of the first bodies.
QStringList bodiesOf(const sim::Scene &scene);
QStringList parametersOf(const sim::Values &values);
/// Each title once, in the learner's language.
QStringList phasesOf(const sim::Pipeline &pipeline);
/// The numbers that bodies have in states like this one.
QHash<QString, Condition::Operation::Kind> membersOf(const sim::State &state);
/// Their names.
QString listOf(const QHash<QString, Condition::Operation::Kind> &members);

}
