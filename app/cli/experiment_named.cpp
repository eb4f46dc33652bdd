#include "app/cli/experiment_named.h"

#include "app/cli/terminal.h"
#include "app/model/words.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

}

Experiment experimentIn(const QString &file, const LessonLibrary &library)
{
    const Waiting waiting(Text::tr("Reading %1").arg(shownPath(file)));
    return readExperiment(file, library);
}

Experiment experimentNamed(const QString &what, const LessonLibrary &library)
{
    if (QFileInfo::exists(what))
        return experimentIn(what, library);
    if (what.count('/') == 1 && !what.startsWith('/') && !what.endsWith('/') && !what.endsWith(".json"))
        return newExperiment(what.section('/', 0, 0), what.section('/', 1), library);
    throw Refusal(Text::tr("%1 is neither a file nor a step; name a step as LESSON/STEP, as \"springstep "
                           "lessons\" lists them.")
                      .arg(quoted(what)));
}

}
