#pragma once

#include <QString>

namespace app {

class OpenRun;
class Session;

/// The step of a lesson that was open last, in this program start or an earlier one.
struct LastStep
{
    QString lesson; ///< ids; empty if none is stored
    QString step;

    static LastStep load();
    /// Stores the open step, unless it is a sandbox.
    static void store(const OpenRun &run);
    /// Opens the step, if it is installed.
    void openIn(Session &session) const;
};

}
