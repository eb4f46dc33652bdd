#include "app/model/web/page_words.h"

#include <QCoreApplication>

namespace app {

namespace {

struct WebPageWords
{
    Q_DECLARE_TR_FUNCTIONS(WebPageWords)
};

}

std::vector<std::pair<QString, QString>> pageWords()
{
    return {
        {"play", WebPageWords::tr("Play")},
        {"pause", WebPageWords::tr("Pause")},
        {"back", WebPageWords::tr("One frame back")},
        {"forward", WebPageWords::tr("One frame forward")},
        {"start", WebPageWords::tr("To the start")},
        {"frame", WebPageWords::tr("Frame")},
        {"frameOf", WebPageWords::tr("Frame %1 of %2")},
        {"seconds", WebPageWords::tr("%1 s")},
        {"speed", WebPageWords::tr("Speed")},
        {"zoomIn", WebPageWords::tr("Zoom in")},
        {"zoomOut", WebPageWords::tr("Zoom out")},
        {"fit", WebPageWords::tr("Fit the scene")},
        {"trails", WebPageWords::tr("Trails")},
        {"light", WebPageWords::tr("Light colours")},
        {"dark", WebPageWords::tr("Dark colours")},
        {"scene", WebPageWords::tr("Scene")},
        {"bodyAt", WebPageWords::tr("%1 at (%2, %3)")},
        {"text", WebPageWords::tr("About this step")},
        {"listing", WebPageWords::tr("Listing")},
        {"listingHelp", WebPageWords::tr("Beside each line: the values that this frame has set")},
        {"plots", WebPageWords::tr("Plots")},
        {"time", WebPageWords::tr("time, frames")},
        {"noValue", WebPageWords::tr("no value")},
        {"keys", WebPageWords::tr("Keys and mouse")},
        {"keySpace", WebPageWords::tr("Space")},
        {"keyArrows", WebPageWords::tr("Left, Right")},
        {"keyEnds", WebPageWords::tr("Home, End")},
        {"keyMove", WebPageWords::tr("Shift with arrows, or drag")},
        {"keyWheel", WebPageWords::tr("Mouse wheel")},
        {"playPause", WebPageWords::tr("play or pause")},
        {"oneFrame", WebPageWords::tr("one frame back or forward; with Ctrl, ten")},
        {"firstLast", WebPageWords::tr("first or last frame")},
        {"moveView", WebPageWords::tr("move the view")},
        {"zoomView", WebPageWords::tr("zoom")},
        {"otherColours", WebPageWords::tr("light or dark colours")},
        {"made", WebPageWords::tr("Made with Springstep")},
    };
}

QString noRunText(NoRun why)
{
    switch (why) {
    case NoRun::noScripts:
        return WebPageWords::tr(
            "The run needs JavaScript. Allow it in this browser, and load the page again.");
    case NoRun::oldBrowser:
        return WebPageWords::tr("This browser is too old to show the run. Use one from 2023 or later.");
    case NoRun::damaged:
        break;
    }
    return WebPageWords::tr("The run on this page cannot be read: the file is damaged. Ask for it again.");
}

}
