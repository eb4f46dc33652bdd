// Any bytes as an experiment file: refused with a sentence, or read, and then written and read again as the same.

#include "support.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const QByteArray text(reinterpret_cast<const char *>(data), qsizetype(size));
    try {
        fuzz::check(app::parseExperiment(text, "x.json", fuzz::library()));
    } catch (const app::Refusal &refusal) {
        fuzz::check(refusal);
    }
    return 0;
}
