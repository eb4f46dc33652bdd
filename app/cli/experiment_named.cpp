#include "app/cli/experiment_named.h"

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

Experiment experimentNamed(const QString &what, const LessonLibrary &library)
{
    if (QFileInfo::exists(what))
        return readExperiment(what, library);
    if (what.count('/') == 1 && !what.startsWith('/') && !what.endsWith('/') && !what.endsWith(".json"))
        return newExperiment(what.section('/', 0, 0), what.section('/', 1), library);
    throw Refusal(Text::tr("%1 is neither a file nor a step; name a step as LESSON/STEP, as \"springstep "
                           "lessons\" lists them.")
                      .arg(quoted(what)));
}

}
