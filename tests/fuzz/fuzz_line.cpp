// Feeds any pasted text to the reader of experiment lines. The first byte selects the meaning of the others:
// the text itself, the compressed data of a line, or the JSON to compress into a line.

#include "app/model/experiment/experiment_line.h"
#include "support.h"

namespace {

QString lineOf(const QByteArray &bytes, std::uint8_t kind)
{
    constexpr auto encoding = QByteArray::Base64UrlEncoding | QByteArray::OmitTrailingEquals;
    if (kind % 3 == 0)
        return QString::fromUtf8(bytes);
    constexpr int lengthBytes = 4; // the length that qCompress() puts before the zlib data
    const QByteArray packed = kind % 3 == 1 ? bytes : qCompress(bytes).mid(lengthBytes);
    return "springstep:" + QString::fromLatin1(packed.toBase64(encoding));
}

}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size == 0)
        return 0;
    const QByteArray bytes(reinterpret_cast<const char *>(data) + 1, qsizetype(size) - 1);
    try {
        const app::Experiment experiment = app::experimentFromLine(lineOf(bytes, data[0]), fuzz::library());
        fuzz::check(experiment);
        fuzz::check(
            app::experimentFromLine(app::experimentLine(experiment, fuzz::library()), fuzz::library()));
    } catch (const app::UserError &error) {
        fuzz::check(error);
    }
    return 0;
}
