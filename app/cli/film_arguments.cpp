#include "app/cli/film_arguments.h"

#include "app/cli/command_line.h"
#include "app/cli/screenshot_arguments.h"
#include "app/model/experiment.h"
#include "app/model/film_file.h"
#include "app/model/words.h"

#include <QCommandLineParser>
#include <QCoreApplication>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

constexpr double leastRate = 0.1;

double rate(const QString &text, FilmKind kind)
{
    if (kind == FilmKind::pictures)
        throw Refusal(
            Text::tr("--fps is for a film in one file; PNG files have no time in them. Leave it out."));
    bool isNumber = false;
    const double number = text.toDouble(&isNumber);
    const double most = kind == FilmKind::gif ? mostGifRate : mostVideoRate;
    if (!isNumber || number < leastRate || number > most)
        throw Refusal(Text::tr("--fps is %1; it can be %2 to %3.")
                          .arg(quoted(text), exactNumber(leastRate), exactNumber(most)));
    return number;
}

/// @throws Refusal
FilmRequest requestFrom(const QCommandLineParser &parser)
{
    FilmRequest request;
    request.file = parser.positionalArguments().at(0);
    request.out = parser.positionalArguments().at(1);
    const FilmKind kind = filmKind(request.out);
    request.size = pictureSize(parser.value("size"));
    request.scheme = schemeOf(parser.value("theme"));
    request.from = wholeNumber("from", parser.value("from"), mostFrames);
    if (parser.isSet("to"))
        request.to = wholeNumber("to", parser.value("to"), mostFrames);
    if (parser.isSet("fps"))
        request.rate = rate(parser.value("fps"), kind);
    return request;
}

}

std::variant<int, FilmRequest> readFilmArguments(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(Text::tr(
        "Makes a film of an experiment's run: a video (WebM), an animated GIF, or a PNG for each frame."));
    parser.addPositionalArgument("FILE", Text::tr("The experiment."));
    parser.addPositionalArgument(
        "OUT", Text::tr("The film: OUT.webm, OUT.gif, or OUT_%04d.png with the frame's number for %04d."));
    parser.addOptions({
        {"size", Text::tr("Width and height in pixels (default 640x480)."), "WxH", "640x480"},
        {"theme", Text::tr("light, dark or contrast (default light)."), "THEME", "light"},
        {"from", Text::tr("The first frame (default 0)."), "N", "0"},
        {"to", Text::tr("The last frame (default: the file's frames)."), "N"},
        {"fps", Text::tr("Frames a second, up to 50 in a GIF and 120 in a video (default 30)."), "F"},
    });
    if (const auto settled = readArguments(parser, "film", arguments, {"FILE", "OUT"}))
        return *settled;
    try {
        return requestFrom(parser);
    } catch (const Refusal &refusal) {
        return refuseUse(refusal.sentence());
    }
}

}
