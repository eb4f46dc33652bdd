#pragma once

#include <QString>

namespace app {

/// The names of an edit of the run.
struct EditLabel
{
    QString what;   ///< for undo: "Springs off", "Damping"
    QString before; ///< the name of the replaced run is "before: " and this text
    QString gesture =
        {};             ///< consecutive edits with the same gesture are undone together; empty: undone alone
    QString after = {}; ///< the name of the new run is "after: " and this text; empty: `what`
};

}
