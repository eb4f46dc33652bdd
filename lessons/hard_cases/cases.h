#pragma once

#include "lessons/api/step.h"
#include "sim/catalogue/hard_case.h"

/// The hard cases of sim/catalogue, as the step `torture` shows them.
namespace hard_cases {

/// Returns the cases that the step shows. Cases that must be refused are left out, because they have no
/// scene. Large trees get fewer forks, so that they can be drawn while the run plays. They are made once, because what is
/// asked of a run needs them in every frame.
const std::vector<sim::HardCase> &shownCases();
/// Returns the shown case at `index`.
const sim::HardCase &caseNumber(int index);
/// Returns the index of the shown case `id`. -1 if there is none.
int caseIndex(const char *id);

/// Returns the parameter `case`, a choice among the shown cases.
lessons::Parameter caseParameter();
/// Returns the parameter `k`, which replaces the stiffness of the case's springs unless it is 0.
lessons::Parameter caseStiffness();

/// Gives `script` the input, start states and step of the case that its values name.
void prepareCase(sim::Script &script);

/// Returns whether the learner has changed nothing in the case but method and step.
bool isUnchangedCase(const sim::Script &script);
/// Returns a function for Step::note. Its note tells the story of the case, whether the method claims the
/// case, and whether the run has met the requirements so far.
std::function<QString(const sim::Track &)> caseNote();

}
