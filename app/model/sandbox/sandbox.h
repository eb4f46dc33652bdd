#pragma once

#include "app/model/session/session.h"

namespace app {

// The sandbox: the lesson step in which a learner builds a scene.

/// Returns the first sandbox that is installed; null if there is none.
const LessonEntry *sandboxOf(const LessonLibrary &library);

/// The open scene as an experiment of the sandbox, with its points at their present positions.
struct ExportedScene
{
    sim::Script script;
    QString sentence; ///< says which parts were exported, and which could not be
};

/// @throws UserError if no part of the scene can be built, it is too large, or its points are too far away
ExportedScene takenScene(const Session &session, const lessons::Step &sandbox);

/// Opens the sandbox with the open scene. Undo restores the previous scene of the sandbox. A message lists the parts
/// that could not be exported, or says why nothing could be.
void takeToSandbox(Session &session);

/// Replaces the scene of the open sandbox by one of its examples. Returns whether the example was opened.
bool takeExample(const OpenRun &run, RunEditor &editor, const lessons::Example &example);

/// Returns whether the open scene can be edited now: it is a sandbox scene at the start of its run.
bool canBuild(const OpenRun &run, const RunEditor &editor, const Playback &playback);

/// Returns the message for a scene that cannot be edited now.
QString buildOnlyAtStart();
/// Adds an effect of the sandbox's catalogue to the scene, or removes it. If that is not possible now, a message says
/// so. Returns whether the scene was changed.
bool setBuiltEffect(const OpenRun &run, RunEditor &editor, const Playback &playback, const QString &id,
                    bool present);

/// Starts a scene that has only one point.
bool startEmpty(const OpenRun &run, RunEditor &editor);

}
