// Feeds any bytes to the reader of experiment files. They are rejected with a user error, or read. An
// experiment that was read must survive writing and reading unchanged.

#include "support.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray text(reinterpret_cast<const char *>(data), qsizetype(size));
    try {
        fuzz::check(app::parseExperiment(text, "x.json", fuzz::library()));
    } catch (const app::UserError &error) {
        fuzz::check(error);
    }
    return 0;
}
