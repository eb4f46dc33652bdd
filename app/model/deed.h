#pragma once

#include <QString>

namespace app {

/// Something that a learner did to the run, in words.
struct Deed
{
    QString what;         ///< as undoing calls it: "Springs off", "Damping"
    QString before;       ///< what the run as it was is called beside the new one, after "before: "
    QString gesture = {}; ///< deeds in a row with the same one are undone together; empty: it stands alone
    QString after = {};   ///< what the run is called that it made, after "after: "; empty: `what`
};

}
