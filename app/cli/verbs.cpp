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

Option languageOption()
{
    return {"language", VerbsText::tr("en, de, es or fr (default: that of the system)."), "LANG"};
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
        {"check",
         VerbsText::tr(
             "Checks a lesson of your own, and plays the solution of each thing to try. The exit code is 1 "
             "if one fails."),
         {{"LESSON", VerbsText::tr("The folder of the lesson, or its zip.")}},
         {jsonOption()},
         runCheck},
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
          {"stability", VerbsText::tr("gauge, reasons, or a map: step, damping or rest."), "WHAT", "gauge"}},
         runScreenshot,
         ApplicationKind::widgets},
        {"film",
         VerbsText::tr("Makes a film of the run of an experiment: a WebM video, an animated GIF, a PNG for "
                       "each frame, or a "
                       "web page that plays it."),
         {experimentFile(),
          {"OUT",
           VerbsText::tr(
               "The film: OUT.webm, OUT.gif, OUT.html, or OUT_%04d.png, where %04d stands for the "
               "number of the frame with 4 digits, such as 0007. %d writes 7, and the files do not sort by "
               "name.")}},
         {{"from", VerbsText::tr("The first frame."), "N", "0"},
          {"to", VerbsText::tr("The last frame (default: the file's number of frames)."), "N"},
          sizeOption("640x480"),
          themeOption(),
          {"fps",
           VerbsText::tr("Frames per second, up to 50 in a GIF and 120 otherwise (default 30). Not for PNG "
                         "files."),
           "F"},
          languageOption(),
          {"plot",
           VerbsText::tr(
               "A plot on a web page, such as \"y(body)\", \"energy\" or \"y(body):x(body)\". Repeat it "
               "for more."),
           "NAME"},
          {"ghost", VerbsText::tr("The run in FILE that a web page shows as the ghost."), "NAME"}},
         runFilm,
         ApplicationKind::widgets},
        {"notebook",
         VerbsText::tr(
             "Checks notebooks by replaying every run, makes a page of one, or writes your own. The exit "
             "code is 1 if a run does not show what its notebook says."),
         {{"ACTION",
           VerbsText::tr(
               "check FILE..., page FILE OUT.html, page FILE OUT.pdf, or write OUT.springstep-notebook.")},
          {"FILE...",
           VerbsText::tr("The notebooks, or the notebook and the page to write; and the lessons without "
                         "C++ that they are about, as folders or zips.")}},
         {jsonOption(),
          {"csv", VerbsText::tr("Prints the result as CSV.")},
          {"name", VerbsText::tr("The name to write into the notebook."), "NAME"},
          {"lessons", VerbsText::tr("The lessons to write (default: all)."), "ID,ID"}},
         runNotebook,
         ApplicationKind::widgets},
        {"handout",
         VerbsText::tr("Writes a lesson on paper: its texts, pictures and questions with lines to write on. "
                       "The answers "
                       "follow on separate pages."),
         {{"LESSON", VerbsText::tr("A lesson, or the folder or the zip of one.")},
          {"OUT.pdf", VerbsText::tr("The PDF to write.")}},
         {languageOption()},
         runHandout,
         ApplicationKind::widgets},
    };
    return all;
}

}
