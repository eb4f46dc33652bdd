#include "app/model/web/page_words.h"

#include "app/model/text/scene_words.h"

#include <QCoreApplication>

namespace app {

namespace {

struct WebPageWords
{
    Q_DECLARE_TR_FUNCTIONS(WebPageWords)
};

using WordList = std::vector<std::pair<QString, QString>>;

/// The texts about what the scene shows besides the bodies.
WordList sceneWords()
{
    const UnitCircleWords circle = unitCircleWords();
    return {
        {"show", WebPageWords::tr("Show")},
        {"showHelp", WebPageWords::tr("Choose what the scene shows")},
        {"trails", WebPageWords::tr("Trails")},
        {"velocities", WebPageWords::tr("Velocity arrows")},
        {"onion", WebPageWords::tr("Onion skins")},
        {"ghost", WebPageWords::tr("Ghost")},
        {"guides", WebPageWords::tr("Guide lines")},
        {"unitCircle", circle.title},
        {"legend", WebPageWords::tr("Legend")},
        {"velocityScale", velocityScaleWords()},
        {"pullScale", pullScaleWords()},
        {"onionScale", onionWords()},
        {"noLength", circle.noLength},
        {"noDirection", circle.noDirection},
        {"angleIs", circle.angle},
        {"sideIs", circle.side},
        {"cosine", circle.cosine},
        {"beside", circle.beside},
        {"sine", circle.sine},
        {"opposite", circle.opposite},
        {"pythagoras", circle.pythagoras},
        {"down", circle.down},
    };
}

}

WordList pageWords()
{
    WordList words = {
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
    for (const auto &word : sceneWords())
        words.push_back(word);
    return words;
}

WordList noRunWords()
{
    return {
        {"needsScripts",
         WebPageWords::tr("The run needs JavaScript. Allow it in this browser, and load the page again.")},
        {"tooOld", WebPageWords::tr("This browser is too old to show the run. Use one from 2023 or later.")},
        {"damaged",
         WebPageWords::tr("The run on this page cannot be read: the file is damaged. Ask for it again.")},
    };
}

}
