// Feeds any text to the reader of lesson metadata (lesson.json). It describes a lesson or is rejected with a
// user error. Qt's extraction of the metadata from a plugin file is not tested here.

#include "app/model/catalog/lesson_plugin.h"
#include "support.h"

#include <QJsonDocument>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), qsizetype(size));
    try {
        const app::LessonDescription description =
            app::describedLesson(QJsonDocument::fromJson(bytes).object());
        if (description.lesson.id.isEmpty() || description.steps.isEmpty() || description.lesson.order < 0)
            fuzz::fail("Described without its parts", description.lesson.id);
    } catch (const app::UserError &error) {
        fuzz::check(error);
    }
    return 0;
}
