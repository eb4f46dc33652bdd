#include "app/cli/experiment_argument.h"

#include "app/cli/terminal.h"
#include "app/model/text/quoting.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace app {

namespace {

struct ExperimentArgumentText
{
    Q_DECLARE_TR_FUNCTIONS(ExperimentArgumentText)
};

}

Experiment experimentFromFile(const QString &file, const LessonLibrary &library)
{
    const Waiting waiting(ExperimentArgumentText::tr("Reading %1").arg(shownPath(file)));
    return readExperiment(file, library);
}

Experiment experimentFor(const QString &argument, const LessonLibrary &library)
{
    if (QFileInfo::exists(argument))
        return experimentFromFile(argument, library);
    if (argument.count('/') == 1 && !argument.startsWith('/') && !argument.endsWith('/') &&
        !argument.contains('.'))
        return newExperiment(argument.section('/', 0, 0), argument.section('/', 1), library);
    throw UserError(ExperimentArgumentText::tr(
                        "%1 is neither a file nor a step; name a step as LESSON/STEP, as \"springstep "
                        "lessons\" lists them.")
                        .arg(quoted(argument)));
}

}
