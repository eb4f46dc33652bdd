#include "app/cli/command_line.h"

#include "app/cli/accuracy.h"
#include "app/cli/cost.h"
#include "app/cli/hard_cases.h"
#include "app/cli/lessons_list.h"
#include "app/cli/terminal.h"
#include "app/cli/trace.h"
#include "app/model/experiment.h"
#include "app/model/words.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFileInfo>

#include <cmath>

namespace app {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

int runLessons(const QStringList &arguments)
{
    QCommandLineParser parser;
    const QCommandLineOption json(QStringLiteral("json"), Text::tr("The same as JSON."));
    parser.addOption(json);
    parser.setApplicationDescription(Text::tr("Lists lessons, steps, parameters and methods."));
    if (const auto settled = readArguments(parser, "lessons", arguments, {}))
        return *settled;
    return listLessons(parser.isSet(json));
}

int runTrace(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        Text::tr("Computes an experiment and writes every frame as CSV: frame,body,x,y,vx,vy."));
    parser.addPositionalArgument("FILE", Text::tr("The experiment."));
    if (const auto settled = readArguments(parser, "trace", arguments, {"FILE"}))
        return *settled;
    return trace(parser.positionalArguments().constFirst());
}

/// What `option` says, if it is set. @throws Refusal unless it is from `least` to `most`
std::optional<double> numberOption(const QCommandLineParser &parser, const QString &option, double least,
                                   double most)
{
    if (!parser.isSet(option))
        return {};
    bool isNumber = false;
    const double number = parser.value(option).toDouble(&isNumber);
    if (isNumber && number >= least && number <= most)
        return number;
    throw Refusal(Text::tr("--%1 is %2; it can be %3 to %4.")
                      .arg(option, quoted(parser.value(option)), exactNumber(least), exactNumber(most)));
}

AccuracyRequest accuracyRequest(const QCommandLineParser &parser)
{
    AccuracyRequest request{
        parser.positionalArguments().constFirst(), parser.isSet("json"), parser.value("svg"), {}, {}};
    request.tolerance = numberOption(parser, "tolerance", 1e-12, 1e6);
    if (const auto frames = numberOption(parser, "frames", 1, static_cast<double>(mostStudied)))
        request.frames = std::llround(*frames);
    return request;
}

int runAccuracy(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        Text::tr("Measures what error each method makes on a scene, and what it costs."));
    parser.addPositionalArgument("FILE|LESSON/STEP", Text::tr("The experiment, or the step."));
    parser.addOptions({{"json", Text::tr("The same as JSON.")},
                       {"svg", Text::tr("Draws error against time."), "OUT"},
                       {"tolerance", Text::tr("Names the cheapest way within E px."), "E"},
                       {"frames", Text::tr("Frames to compute (default 200, or the file's)."), "N"}});
    if (const auto settled = readArguments(parser, "accuracy", arguments, {"FILE|LESSON/STEP"}))
        return *settled;
    try {
        return accuracy(accuracyRequest(parser));
    } catch (const Refusal &refusal) {
        return refuseUse(refusal.sentence());
    }
}

int runHardCases(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(Text::tr(
        "Runs every hard case under every method, and tells what holds; exit code 1 if a method fails a "
        "case that it claims."));
    parser.addOptions({{"case", Text::tr("Runs this case only."), "ID"},
                       {"json", Text::tr("The same as JSON.")},
                       {"full", Text::tr("Runs of full size: some take hours.")}});
    if (const auto settled = readArguments(parser, "hardcases", arguments, {}))
        return *settled;
    HardCasesRequest request{{}, parser.isSet("json"), parser.isSet("full")};
    if (parser.isSet("case"))
        request.only = parser.value("case");
    return hardCases(request);
}

int runCost(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(
        Text::tr("Measures what each effect of a scene costs in a frame, and what else the frame takes."));
    parser.addPositionalArgument("FILE|LESSON/STEP", Text::tr("The experiment, or the step."));
    parser.addOptions({{"json", Text::tr("The same as JSON.")},
                       {"frame", Text::tr("Measures the frames after frame N (default 0)."), "N"}});
    if (const auto settled = readArguments(parser, "cost", arguments, {"FILE|LESSON/STEP"}))
        return *settled;
    try {
        CostRequest request{parser.positionalArguments().constFirst(), parser.isSet("json")};
        if (const auto frame = numberOption(parser, "frame", 0, static_cast<double>(mostFrames)))
            request.frame = std::llround(*frame);
        return cost(request);
    } catch (const Refusal &refusal) {
        return refuseUse(refusal.sentence());
    }
}

void describeProgram(QCommandLineParser &parser)
{
    parser.setApplicationDescription(
        Text::tr("Physically based animation, step by step.\n\n"
                 "Without a verb the window opens, with an experiment if FILE names one.\n\n"
                 "Verbs; each has its own --help, and none needs a display:\n"
                 "  lessons [--json]                            lists lessons, steps, parameters, methods\n"
                 "  trace FILE                                  writes the run of an experiment as CSV\n"
                 "  accuracy FILE|LESSON/STEP [--json] [--svg OUT] [--tolerance E]\n"
                 "                                              measures errors and costs of the methods\n"
                 "  hardcases [--case ID] [--json]              tells which methods hold where runs break\n"
                 "  cost FILE|LESSON/STEP [--json] [--frame N]  measures what each effect costs in a frame\n"
                 "  screenshot LESSON/STEP --frame N OUT.png    draws the window\n"
                 "  film FILE OUT.webm|OUT.gif|OUT_%04d.png     makes a film of an experiment's run"));
    parser.addPositionalArgument("FILE", Text::tr("An experiment to open."), "[FILE | VERB ...]");
    parser.addOption({{"v", "version"}, Text::tr("Prints the version.")});
}

/// Refuses a first argument that is neither a verb nor a file. Returns whether it did.
bool refusesName(const QStringList &names)
{
    if (names.isEmpty() || (names.size() == 1 && QFileInfo::exists(names.front())))
        return false;
    const QString verbList = verbs().join(", ");
    if (names.size() == 1)
        refuseUse(Text::tr("there is no verb and no file %1; the verbs are %2.")
                      .arg(quoted(names.front()), verbList));
    else
        refuseUse(Text::tr("there is no verb %1; the verbs are %2.").arg(quoted(names.front()), verbList));
    return true;
}

}

QStringList verbs()
{
    return {"lessons", "trace", "accuracy", "hardcases", "cost", "screenshot", "film"};
}

int refuseUse(const QString &sentence)
{
    say("springstep: " + sentence);
    return exitBadUse;
}

std::optional<int> readArguments(QCommandLineParser &parser, const QString &verb,
                                 const QStringList &arguments, const QStringList &names)
{
    const QCommandLineOption help({"h", "help"}, Text::tr("Prints this help."));
    parser.addOption(help);
    const QString program = verb.isEmpty() ? QStringLiteral("springstep") : "springstep " + verb;
    if (!parser.parse(QStringList{program} + arguments))
        return refuseUse(
            Text::tr("%1; %2 --help tells what there is.").arg(oneLine(parser.errorText()), program));
    if (parser.isSet(help)) {
        QString text = parser.helpText();
        text.replace(QCoreApplication::arguments().value(0), program);
        print(text.trimmed() + '\n');
        return exitDone;
    }
    if (verb.isEmpty() || parser.positionalArguments().size() == names.size())
        return {};
    const QString takes = names.isEmpty() ? Text::tr("no name") : names.join(' ');
    return refuseUse(Text::tr("%1 takes %2; %3 --help tells more.").arg(verb, takes, program));
}

std::variant<int, QString> readWindowArguments(const QStringList &arguments)
{
    QCommandLineParser parser;
    describeProgram(parser);
    if (const auto settled = readArguments(parser, {}, arguments, {}))
        return *settled;
    if (parser.isSet("version")) {
        print("springstep " + QCoreApplication::applicationVersion() + '\n');
        return exitDone;
    }
    if (refusesName(parser.positionalArguments()))
        return exitBadUse;
    return parser.positionalArguments().value(0);
}

std::optional<int> runPlainVerb(const QStringList &arguments)
{
    const QString verb = arguments.value(0);
    if (verb == "lessons")
        return runLessons(arguments.mid(1));
    if (verb == "trace")
        return runTrace(arguments.mid(1));
    if (verb == "accuracy")
        return runAccuracy(arguments.mid(1));
    if (verb == "hardcases")
        return runHardCases(arguments.mid(1));
    if (verb == "cost")
        return runCost(arguments.mid(1));
    return {};
}

}
