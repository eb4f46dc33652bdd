#include "app/cli/option_values.h"
#include "app/model/experiment/experiment.h"
#include "app/model/text/quoting.h"
#include "app/ui/window/gui.h"

#include <QApplication>

#include <limits>

namespace app {

namespace {

struct ScreenshotText
{
    Q_DECLARE_TR_FUNCTIONS(ScreenshotText)
};

bool isMeasuring(const Arguments &arguments)
{
    const QString mode = arguments.value("mode");
    if (mode != "learn" && mode != "measure")
        throw UsageError(
            ScreenshotText::tr("--mode is %1; it can be \"learn\" or \"measure\".").arg(quoted(mode)));
    return mode == "measure";
}

void readStability(const Arguments &arguments, ScreenshotRequest &request)
{
    const QString what = arguments.value("stability");
    if (what != "gauge" && what != "reasons" && what != "step" && what != "damping" && what != "rest")
        throw UsageError(
            ScreenshotText::tr("--stability is %1; it can be \"gauge\", \"reasons\", or a map: \"step\", "
                               "\"damping\" or \"rest\".")
                .arg(quoted(what)));
    request.reasons = what != "gauge";
    request.settling = what == "rest";
    if (what == "step" || what == "damping")
        request.map = what == "step" ? MapPlane::step : MapPlane::damping;
}

/// @throws UsageError
ScreenshotRequest screenshotRequest(const Arguments &arguments)
{
    ScreenshotRequest request;
    const QString place = arguments.names[0];
    if (place.count('/') != 1 || place.startsWith('/') || place.endsWith('/'))
        throw UsageError(
            ScreenshotText::tr(
                "%1 is not a step; name it as LESSON/STEP, as \"springstep lessons\" lists them.")
                .arg(quoted(place)));
    request.lesson = place.section('/', 0, 0);
    request.step = place.section('/', 1);
    request.out = arguments.names[1];
    request.frame = wholeNumberOption(arguments, "frame", mostFrames);
    request.phase = int(wholeNumberOption(arguments, "phase", std::numeric_limits<int>::max()));
    request.size = pictureSize(arguments);
    request.scheme = colorScheme(arguments);
    request.measuring = isMeasuring(arguments);
    request.energy = arguments.has("energy");
    request.effects = arguments.has("effects");
    request.plots = arguments.has("plots");
    readStability(arguments, request);
    return request;
}

}

int runScreenshot(const Arguments &arguments)
{
    return takeScreenshot(*qApp, screenshotRequest(arguments));
}

}
