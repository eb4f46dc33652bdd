#pragma once

#include "lessons/api/step.h"
#include "sim/catalogue/hard_case.h"

/// The hard cases of sim/catalogue as the last step shows it.
namespace hard_cases {

/// Those that begin at all: what a refused one has to show is one sentence, and no scene. A tree that is too large to
/// be drawn while it plays has fewer forks here.
std::vector<sim::HardCase> shownCases();
/// The one at position `number` of that list.
sim::HardCase caseNumber(int number);
/// The position of the case called `id`; -1 if it is not there.
int numberOf(const char *id);

/// The choice among them.
lessons::Parameter caseParameter();
/// The stiffness of its springs, in place of the case's own.
lessons::Parameter stiffnessOfCase();

/// Input, starts of bodies and step of the case that the values name.
void openCase(sim::Script &script);

/// Whether the run is that of a case, with nothing but method and step changed.
bool isAsTold(const sim::Script &script);
/// Returns what the last step says while a case runs: its story, whether the method claims it, and whether it has held
/// up to this moment.
std::function<QString(const sim::Track &)> caseNote();

}
