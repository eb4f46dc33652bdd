#pragma once

#include "app/model/session.h"

namespace app {

// The workshop: where a learner builds the scene.

/// The first one that is installed; null where there is none.
const LessonEntry *workshopOf(const LessonLibrary &library);

/// The scene that is open, as an experiment of the workshop, with its points where they are now.
struct TakenScene
{
    sim::Script script;
    QString sentence; ///< what was taken, and what of it could not be
};

/// @throws Refusal: nothing of it can be built, it is too large, or has flown apart
TakenScene takenScene(const Session &session, const lessons::Step &workshop);

/// Opens the workshop with the scene that is open; undo brings back what was in it. What does not carry over, or why
/// nothing does, is said.
void takeToWorkshop(Session &session);

/// An experiment that comes with the open workshop, in place of its scene. Returns whether it was opened.
bool takeExample(Session &session, const lessons::Example &example);

/// Whether the scene that is open can be changed now: it is one that is built, and stands at the start of its run.
bool canBuild(const Session &session);

/// Gives the scene that is built an effect of the workshop's catalogue, or takes it away. Where that cannot be now, it is
/// said. Returns whether it was done.
bool setBuiltEffect(Session &session, const QString &id, bool present);

/// A scene with nothing but one point.
bool startEmpty(Session &session);

}
