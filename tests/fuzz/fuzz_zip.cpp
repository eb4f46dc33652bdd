// Feeds any bytes to the reader of lessons without C++, as a zip (.springstep-lesson) from a stranger. The zip is a lesson, or
// it is rejected with a user error. Half of the mutations change a file inside the zip, so that its checksum stays right.

#include "app/model/lesson_folders/lesson_folder.h"
#include "app/model/lesson_folders/zip_reader.h"
#include "support.h"
#include "tests/app/support/zip_writer.h"

#include <algorithm>
#include <random>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t *data, std::size_t size, std::size_t most);

namespace {

using Files = std::map<QString, QByteArray>;

const QString zipName = QStringLiteral("stranger.springstep-lesson");
const app::ZipLimits zipLimits{app::mostLessonFiles, app::largestLessonFile, app::largestLesson};

void checkFiles(const Files &files)
{
    qsizetype all = 0;
    for (const auto &[name, content] : files) {
        all += content.size();
        if (name.contains('/') || name.contains('\\') || name == u".." || content.size() > zipLimits.file)
            fuzz::fail("Not safe", name);
    }
    if (files.size() > zipLimits.files || all > zipLimits.all)
        fuzz::fail("Larger than allowed", QString::number(all));
    if (app::readZip(tests::zipOf(files), zipName, zipLimits) != files)
        fuzz::fail("Read otherwise the second time", QString::number(files.size()));
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray bytes(reinterpret_cast<const char *>(data), static_cast<qsizetype>(size));
    try {
        app::LessonFiles files{zipName, QStringLiteral("/") + zipName};
        files.all = app::readZip(bytes, zipName, zipLimits);
        checkFiles(files.all);
        for (const char *language : {"en", "de"}) {
            const app::LessonEntry lesson =
                app::lessonOf(files, QString::fromLatin1(language), fuzz::library());
            if (lesson.id.isEmpty() || lesson.title.isEmpty() || lesson.steps.empty())
                fuzz::fail("Read without its parts", lesson.id);
        }
    } catch (const app::UserError &error) {
        fuzz::check(error);
    }
    return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t *data, std::size_t size, std::size_t most,
                                               unsigned int seed)
{
    std::minstd_rand random(seed);
    if (random() % 2 == 0)
        return LLVMFuzzerMutate(data, size, most);
    Files files;
    try {
        files = app::readZip({reinterpret_cast<const char *>(data), static_cast<qsizetype>(size)}, zipName,
                             zipLimits);
    } catch (const app::UserError &) {
        return LLVMFuzzerMutate(data, size, most);
    }
    QByteArray &content =
        std::next(files.begin(), static_cast<std::ptrdiff_t>(random() % files.size()))->second;
    const auto before = static_cast<std::size_t>(content.size());
    content.resize(static_cast<qsizetype>(std::max(before, most)));
    const std::size_t after =
        LLVMFuzzerMutate(reinterpret_cast<std::uint8_t *>(content.data()), before, std::max(before, most));
    content.resize(static_cast<qsizetype>(after));
    const QByteArray zip = tests::zipOf(files);
    if (static_cast<std::size_t>(zip.size()) > most)
        return LLVMFuzzerMutate(data, size, most);
    std::copy(zip.begin(), zip.end(), data);
    return static_cast<std::size_t>(zip.size());
}
