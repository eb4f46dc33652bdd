#include "app/cli/command_line.h"

#include "app/cli/terminal.h"
#include "app/model/text/quoting.h"
#include "app/model/text/sentences.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFileInfo>

#include <algorithm>
#include <optional>

namespace app {

namespace {

struct CommandLineText
{
    Q_DECLARE_TR_FUNCTIONS(CommandLineText)
};

constexpr qsizetype lineLength = 79; ///< of help texts, in characters; QCommandLineParser has the same

/// Returns the words on lines of at most `lineLength` characters. The lines after the first one start with `indentation`
/// spaces.
QString wrapped(QString text, const QStringList &words, qsizetype indentation)
{
    qsizetype length = text.size();
    for (const QString &word : words) {
        if (length + 1 + word.size() > lineLength) {
            text += '\n' + QString(indentation, ' ');
            length = indentation;
        } else {
            text += ' ';
            ++length;
        }
        text += word;
        length += word.size();
    }
    return text;
}

/// Returns a verb's arguments and options for the overview, and its summary.
QString overviewOf(const Verb &verb)
{
    QStringList words;
    for (const Argument &argument : verb.arguments)
        words << argument.name;
    for (const Option &option : verb.options)
        words << (option.valueName.isEmpty() ? "[--" + option.name + ']'
                                             : "[--" + option.name + ' ' + option.valueName + ']');
    constexpr qsizetype indentation = 6;
    return wrapped("  " + verb.name, words, indentation + 4) + '\n' +
           wrapped(QString(indentation - 1, ' '), verb.summary.split(' '), indentation) + '\n';
}

QString descriptionOfProgram()
{
    QString text =
        CommandLineText::tr("Physically based animation, step by step.\n\n"
                            "Without a verb, the window opens and shows FILE, an experiment or a lesson.\n\n"
                            "Verbs (each has its own --help, and none needs a display):") +
        '\n';
    for (const Verb &verb : verbs())
        text += overviewOf(verb);
    return text.trimmed();
}

QCommandLineOption parserOption(const Option &option)
{
    QString summary = option.summary;
    if (!option.defaultValue.isEmpty())
        summary = CommandLineText::tr("%1 (default %2).").arg(oneLine(summary), option.defaultValue);
    return QCommandLineOption(option.name, summary, option.valueName, option.defaultValue);
}

/// Returns the help text with the list of arguments at its end. QCommandLineParser lists them, too, but breaks names that
/// are longer than those of the options.
QString withArguments(const QString &help, const std::vector<Argument> &arguments)
{
    if (arguments.empty())
        return help;
    const qsizetype list = help.lastIndexOf("\n\n") + 2;
    QString text = help.left(help.indexOf('\n', list) + 1);
    for (const Argument &argument : arguments)
        text += "  " + argument.name + "\n      " + argument.summary + '\n';
    return text;
}

/// Reads `arguments` into `parser`, which has the positional arguments `named`. `program` is the program's name, with the verb if there is one. Returns the exit code
/// after help or an error message.
std::optional<int> parse(QCommandLineParser &parser, const QString &program,
                         const std::vector<Argument> &named, const QStringList &arguments)
{
    const QCommandLineOption help({"h", "help"}, CommandLineText::tr("Prints this help."));
    parser.addOption(help);
    if (!parser.parse(QStringList{program} + arguments))
        return reportUsageError(
            CommandLineText::tr("%1; see %2 --help.").arg(oneLine(parser.errorText()), program));
    if (!parser.isSet(help))
        return {};
    QString text = parser.helpText(); // begins with "Usage: " and the path of the program
    const QString path = QCoreApplication::arguments().value(0);
    text.replace(text.indexOf(path), path.size(), program);
    print(withArguments(text.trimmed(), named).trimmed() + '\n');
    return exitDone;
}

CommandLine readVerb(const Verb &verb, const QStringList &given)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(verb.summary);
    QStringList names;
    for (const Argument &argument : verb.arguments) {
        parser.addPositionalArgument(argument.name, argument.summary);
        names << argument.name;
    }
    for (const Option &option : verb.options)
        parser.addOption(parserOption(option));
    const QString program = "springstep " + verb.name;
    if (const auto exitCode = parse(parser, program, verb.arguments, given))
        return *exitCode;
    const qsizetype count = parser.positionalArguments().size();
    const bool repeats = !names.isEmpty() && names.back().endsWith(QLatin1String("..."));
    if (repeats ? count < names.size() : count != names.size()) {
        const QString takes = names.isEmpty() ? CommandLineText::tr("no arguments") : names.join(' ');
        return reportUsageError(
            CommandLineText::tr("%1 takes %2; see %3 --help.").arg(verb.name, takes, program));
    }
    Arguments arguments{parser.positionalArguments(), {}};
    for (const Option &option : verb.options) {
        if (parser.isSet(option.name) || !option.defaultValue.isEmpty())
            arguments.options[option.name] =
                option.valueName.isEmpty() ? QStringList() : parser.values(option.name);
    }
    return VerbCall{&verb, arguments};
}

/// Returns the exit code for names that are neither a verb nor one existing file.
std::optional<int> reportUnknownNames(const QStringList &names)
{
    if (names.isEmpty() || (names.size() == 1 && QFileInfo::exists(names.front())))
        return {};
    if (names.size() > 1 && QFileInfo::exists(names.front()))
        return reportUsageError(
            CommandLineText::tr("the window opens one file; leave out %1.").arg(quoted(names[1])));
    const QString sentence = names.size() == 1
                                 ? CommandLineText::tr("there is no verb and no file %1; the verbs are %2.")
                                 : CommandLineText::tr("there is no verb %1; the verbs are %2.");
    return reportUsageError(sentence.arg(quoted(names.front()), verbNames()));
}

CommandLine readFile(const QStringList &arguments)
{
    QCommandLineParser parser;
    parser.setApplicationDescription(descriptionOfProgram());
    parser.addPositionalArgument("FILE", CommandLineText::tr("An experiment or a lesson to open."),
                                 "[FILE | VERB ...]");
    parser.addOption({{"v", "version"}, CommandLineText::tr("Prints the version.")});
    if (const auto exitCode = parse(parser, "springstep", {}, arguments))
        return *exitCode;
    if (parser.isSet("version")) {
        print("springstep " + QCoreApplication::applicationVersion() + '\n');
        return exitDone;
    }
    if (const auto exitCode = reportUnknownNames(parser.positionalArguments()))
        return *exitCode;
    return parser.positionalArguments().value(0);
}

}

CommandLine readCommandLine(const QStringList &arguments)
{
    const auto verb = std::find_if(verbs().begin(), verbs().end(),
                                   [&](const Verb &one) { return one.name == arguments.value(0); });
    return verb == verbs().end() ? readFile(arguments) : readVerb(*verb, arguments.mid(1));
}

ApplicationKind applicationFor(const VerbCall &call)
{
    for (const Option &option : call.verb->options) {
        if (option.application == ApplicationKind::widgets && call.arguments.has(option.name))
            return ApplicationKind::widgets;
    }
    return call.verb->application;
}

int runVerb(const VerbCall &call)
{
    try {
        return call.verb->run(call.arguments);
    } catch (const UsageError &error) {
        return reportUsageError(error.sentence());
    } catch (const UserError &error) {
        printMessage(error.sentence());
    } catch (const sim::Error &error) {
        printMessage(sentenceFor(error));
    }
    return exitBadUse;
}

int reportUsageError(const QString &sentence)
{
    printMessage("springstep: " + sentence);
    return exitBadUse;
}

QString verbNames()
{
    QStringList names;
    for (const Verb &verb : verbs())
        names << verb.name;
    return names.join(", ");
}

}
