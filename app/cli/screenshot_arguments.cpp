#include "app/cli/screenshot_arguments.h"

#include "app/cli/command_line.h"
#include "app/cli/terminal.h"
#include "app/model/experiment.h"
#include "app/model/words.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QRegularExpression>

#include <limits>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

}

std::int64_t wholeNumber(const QString &option, const QString &text, std::int64_t most)
{
    bool isNumber = false;
    const qint64 number = text.toLongLong(&isNumber);
    if (!isNumber || number < 0 || number > most)
        throw Refusal(Text::tr("--%1 is %2; it can be a whole number from 0 to %3.")
                          .arg(option, quoted(text))
                          .arg(most));
    return number;
}

QSize pictureSize(const QString &text)
{
    static const QRegularExpression form(QStringLiteral("\\A(\\d{3,4})x(\\d{3,4})\\z"));
    const auto match = form.match(text);
    if (!match.hasMatch())
        throw Refusal(
            Text::tr(
                "--size is %1; it can be WIDTHxHEIGHT in pixels, each from 100 to 9999, such as 1280x800.")
                .arg(quoted(text)));
    return {match.captured(1).toInt(), match.captured(2).toInt()};
}

Scheme schemeOf(const QString &text)
{
    if (text == "light")
        return Scheme::light;
    if (text == "dark")
        return Scheme::dark;
    if (text == "contrast")
        return Scheme::highContrast;
    throw Refusal(
        Text::tr("--theme is %1; it can be \"light\", \"dark\" or \"contrast\".").arg(quoted(text)));
}

namespace {

bool isMeasuring(const QString &text)
{
    if (text != "learn" && text != "measure")
        throw Refusal(Text::tr("--mode is %1; it can be \"learn\" or \"measure\".").arg(quoted(text)));
    return text == "measure";
}

/// What to show of the step's stability.
void readStability(const QString &text, ScreenshotRequest &request)
{
    if (text != "gauge" && text != "reasons" && text != "step" && text != "damping")
        throw Refusal(Text::tr("--stability is %1; it can be \"gauge\", \"reasons\", or a map: \"step\" or "
                               "\"damping\".")
                          .arg(quoted(text)));
    request.reasons = text != "gauge";
    if (text == "step" || text == "damping")
        request.map = text == "step" ? MapPlane::step : MapPlane::damping;
}

/// What to photograph. @throws Refusal
ScreenshotRequest requestFrom(const QCommandLineParser &parser)
{
    ScreenshotRequest request;
    const QString place = parser.positionalArguments().at(0);
    if (place.count('/') != 1 || place.startsWith('/') || place.endsWith('/'))
        throw Refusal(
            Text::tr("%1 is not a step; name it as LESSON/STEP, as \"springstep lessons\" lists them.")
                .arg(quoted(place)));
    request.lesson = place.section('/', 0, 0);
    request.step = place.section('/', 1);
    request.out = parser.positionalArguments().at(1);
    request.frame = wholeNumber("frame", parser.value("frame"), mostFrames);
    request.phase = int(wholeNumber("phase", parser.value("phase"), std::numeric_limits<int>::max()));
    request.size = pictureSize(parser.value("size"));
    request.scheme = schemeOf(parser.value("theme"));
    request.measuring = isMeasuring(parser.value("mode"));
    request.energy = parser.isSet("energy");
    request.effects = parser.isSet("effects");
    request.plots = parser.isSet("plots");
    readStability(parser.value("stability"), request);
    return request;
}

void addScreenshotOptions(QCommandLineParser &parser)
{
    parser.setApplicationDescription(Text::tr("Draws the window as a learner sees it."));
    parser.addPositionalArgument("LESSON/STEP", Text::tr("The step to open."));
    parser.addPositionalArgument("OUT.png", Text::tr("The picture to write."));
    parser.addOptions({
        {"frame", Text::tr("Go to frame N (default 0)."), "N", "0"},
        {"phase", Text::tr("Stop after P phases inside the next frame (default 0)."), "P", "0"},
        {"size", Text::tr("Width and height in pixels (default 1280x800)."), "WxH", "1280x800"},
        {"theme", Text::tr("light, dark or contrast (default light)."), "THEME", "light"},
        {"mode", Text::tr("learn or measure (default learn)."), "MODE", "learn"},
        {"energy", Text::tr("Show where energy went, below the picture.")},
        {"effects", Text::tr("Show what each effect costs.")},
        {"plots", Text::tr("Show the plots.")},
        {"stability", Text::tr("gauge, reasons, or a map: step or damping (default gauge)."), "WHAT",
         "gauge"},
    });
}

}

std::variant<int, ScreenshotRequest> readScreenshotArguments(const QStringList &arguments)
{
    QCommandLineParser parser;
    addScreenshotOptions(parser);
    if (const auto settled = readArguments(parser, "screenshot", arguments, {"LESSON/STEP", "OUT.png"}))
        return *settled;
    try {
        return requestFrom(parser);
    } catch (const Refusal &refusal) {
        return refuseUse(refusal.sentence());
    }
}

}
