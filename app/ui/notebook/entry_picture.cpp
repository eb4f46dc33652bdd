#include "app/ui/notebook/entry_picture.h"

#include "app/model/text/user_error.h"
#include "app/ui/film/moment_picture.h"
#include "sim/base/error.h"

namespace app {

EntryPicture entryPicture(const LessonLibrary &library)
{
    return [&library](const NotebookEntry &entry) -> QImage {
        try {
            const Experiment experiment = parseExperiment(entry.run.text, entry.id, library);
            return pictureOfMoment(experiment, entry.run.at, library);
        } catch (const UserError &) { // the check names it
        } catch (const sim::Error &) {
        }
        return {};
    };
}

}
