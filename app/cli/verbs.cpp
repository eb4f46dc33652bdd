#include "app/cli/verbs.h"

#include <QCoreApplication>

namespace app {

namespace {

struct VerbsText
{
    Q_DECLARE_TR_FUNCTIONS(VerbsText)
};

Option jsonOption()
{
    return {"json", VerbsText::tr("Prints the result as JSON.")};
}

Option sizeOption(const QString &defaultSize)
{
    return {"size", VerbsText::tr("Width and height in pixels, each from 100 to 9999."), "WxH", defaultSize};
}

Option themeOption()
{
    return {"theme", VerbsText::tr("light, dark or contrast."), "THEME", "light"};
}

Argument experimentFile()
{
    return {"FILE", VerbsText::tr("The experiment.")};
}

Argument experimentOrStep()
{
    return {"FILE|LESSON/STEP", VerbsText::tr("The experiment or the step of a lesson.")};
}

}

const std::vector<Verb> &verbs()
{
    static const std::vector<Verb> all = {
        {"lessons",
         VerbsText::tr("Lists lessons, steps, parameters and methods."),
         {},
         {jsonOption()},
         runLessons},
        {"trace",
         VerbsText::tr("Computes the run of an experiment and writes every frame as CSV."),
         {experimentFile()},
         {},
         runTrace},
        {"accuracy",
         VerbsText::tr("Measures the error of each method on a scene, and its cost."),
         {experimentOrStep()},
         {jsonOption(),
          {"svg",
           VerbsText::tr("Also draws error against time, as an SVG file."),
           "OUT",
           {},
           ApplicationKind::widgets},
          {"tolerance",
           VerbsText::tr("Also names the cheapest method and step with an error of at most E px."), "E"},
          {"frames",
           VerbsText::tr(
               "The number of frames to compute (default: the file's, at most 1000, or 200 for a step)."),
           "N"}},
         runAccuracy},
        {"hardcases",
         VerbsText::tr("Runs every hard case with every method. The exit code is 1 if a method fails a case "
                       "that it claims."),
         {},
         {{"case", VerbsText::tr("Runs this case only."), "ID"},
          jsonOption(),
          {"full", VerbsText::tr("Runs the cases at full size. Some take hours.")}},
         runHardCases},
        {"cost",
         VerbsText::tr("Measures the time of a frame, and of each effect in it."),
         {experimentOrStep()},
         {jsonOption(), {"frame", VerbsText::tr("Measures the frames after frame N."), "N", "0"}},
         runCost},
        {"screenshot",
         VerbsText::tr("Draws the window as a learner sees it."),
         {{"LESSON/STEP", VerbsText::tr("The step to open.")},
          {"OUT.png", VerbsText::tr("The picture to write.")}},
         {{"frame", VerbsText::tr("Goes to frame N."), "N", "0"},
          {"phase", VerbsText::tr("Stops after P phases inside the next frame."), "P", "0"},
          sizeOption("1280x800"),
          themeOption(),
          {"mode", VerbsText::tr("learn or measure."), "MODE", "learn"},
          {"energy", VerbsText::tr("Shows where energy went.")},
          {"effects", VerbsText::tr("Shows the cost of each effect.")},
          {"plots", VerbsText::tr("Shows the plots.")},
          {"stability", VerbsText::tr("gauge, reasons, or a map: step or damping."), "WHAT", "gauge"}},
         runScreenshot,
         ApplicationKind::widgets},
        {"film",
         VerbsText::tr(
             "Makes a film of the run of an experiment: a WebM video, an animated GIF, or a PNG for each "
             "frame."),
         {experimentFile(),
          {"OUT",
           VerbsText::tr("The film: OUT.webm, OUT.gif, or OUT_%04d.png, where %04d stands for the number of "
                         "the frame.")}},
         {{"from", VerbsText::tr("The first frame."), "N", "0"},
          {"to", VerbsText::tr("The last frame (default: the file's number of frames)."), "N"},
          sizeOption("640x480"),
          themeOption(),
          {"fps",
           VerbsText::tr("Frames per second, up to 50 in a GIF and 120 in a video (default 30). Not for PNG "
                         "files."),
           "F"}},
         runFilm,
         ApplicationKind::widgets},
    };
    return all;
}

}
