#include "app/model/experiment/experiment_line.h"

#include <QCoreApplication>

#include <zlib.h>

#include <array>

namespace app {

namespace {

struct ExperimentLineText
{
    Q_DECLARE_TR_FUNCTIONS(ExperimentLineText)
};

constexpr auto prefix = "springstep:";
constexpr auto encoding = QByteArray::Base64UrlEncoding | QByteArray::OmitTrailingEquals;

/// Returns JSON without white space between its parts.
QByteArray compact(const QByteArray &json)
{
    QByteArray line;
    bool isText = false;
    for (qsizetype i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (!isText && (c == ' ' || c == '\n'))
            continue;
        line += c;
        if (isText && c == '\\' && i + 1 < json.size())
            line += json[++i];
        else if (c == '"')
            isText = !isText;
    }
    return line;
}

QByteArray compressed(const QByteArray &text)
{
    constexpr int lengthBytes = 4; // length prefix that Qt writes before the zlib data
    return qCompress(text, 9).mid(lengthBytes);
}

[[noreturn]] void refuseCut()
{
    throw UserError(ExperimentLineText::tr("The text begins like an experiment, but it is incomplete. Copy "
                                           "all of it, from “springstep:” to its end."));
}

[[noreturn]] void refuseLarge(qint64 largest)
{
    throw UserError(ExperimentLineText::tr("The text is larger than %1 MiB, the maximum for an experiment.")
                        .arg(largest >> 20));
}

/// Reverses compressed(). Throws UserError as soon as the text exceeds `largest`, so that a short line cannot fill the
/// memory.
QByteArray expanded(const QByteArray &data, qint64 largest)
{
    z_stream stream = {};
    if (data.isEmpty() || inflateInit(&stream) != Z_OK)
        refuseCut();
    const std::unique_ptr<z_stream, decltype(&inflateEnd)> end(&stream, &inflateEnd);
    QByteArray input = data; // zlib takes a pointer to mutable data
    stream.next_in = reinterpret_cast<Bytef *>(input.data());
    stream.avail_in = static_cast<uInt>(input.size());
    QByteArray text;
    std::array<char, 1 << 16> piece;
    int state = Z_OK;
    while (state == Z_OK && text.size() <= largest) {
        stream.next_out = reinterpret_cast<Bytef *>(piece.data());
        stream.avail_out = static_cast<uInt>(piece.size());
        state = inflate(&stream, Z_NO_FLUSH);
        text.append(piece.data(), static_cast<qsizetype>(piece.size() - stream.avail_out));
    }
    if (text.size() > largest)
        refuseLarge(largest);
    if (state != Z_STREAM_END)
        refuseCut();
    return text;
}

}

QByteArray textInLine(const QString &line, qint64 largest)
{
    if (line.startsWith('{')) {
        const QByteArray text = line.toUtf8();
        if (text.size() > largest)
            refuseLarge(largest);
        return text;
    }
    if (!line.startsWith(prefix))
        refuseCut();
    QString code = line.mid(QLatin1StringView(prefix).size());
    code.removeIf([](QChar c) { return c.isSpace(); });
    const auto decoded =
        QByteArray::fromBase64Encoding(code.toLatin1(), encoding | QByteArray::AbortOnBase64DecodingErrors);
    if (!decoded)
        refuseCut();
    return expanded(*decoded, largest);
}

QString experimentLine(const Experiment &experiment, const LessonLibrary &library)
{
    return lineOf(experimentText(experiment, library));
}

QString lineOf(const QByteArray &json)
{
    const QByteArray plain = compact(json);
    const QByteArray packed = prefix + compressed(plain).toBase64(encoding);
    const QByteArray &line = packed.size() < plain.size() ? packed : plain;
    if (line.size() > longestLine)
        throw UserError(ExperimentLineText::tr(
            "This run has too much input for a message. Save it as a file, and send that."));
    return QString::fromUtf8(line);
}

Experiment experimentFromLine(const QString &line, const LessonLibrary &library)
{
    const QString text = line.trimmed();
    if (text.isEmpty())
        throw UserError(
            ExperimentLineText::tr("There is no text to paste. Copy an experiment first: it begins with "
                                   "“springstep:” or {."));
    if (!text.startsWith(prefix) && !text.startsWith('{'))
        throw UserError(ExperimentLineText::tr(
            "The copied text is not an experiment. An experiment begins with “springstep:” or {."));
    if (text.size() > largestExperiment || (!text.startsWith('{') && text.size() > 2 * longestLine))
        throw UserError(
            ExperimentLineText::tr("The text is too long for an experiment in one line. Open it as a file."));
    return parseExperiment(textInLine(text), ExperimentLineText::tr("Pasted text"), library);
}

}
