#include "app/cli/command_line.h"
#include "app/cli/film.h"
#include "app/cli/film_arguments.h"
#include "app/cli/screenshot_arguments.h"
#include "app/cli/terminal.h"
#include "app/ui/window/appearance.h"
#include "app/ui/window/gui.h"

#include <QApplication>

#include <new>

namespace {

bool hasDisplay()
{
#if defined(Q_OS_UNIX) && !defined(Q_OS_DARWIN)
    return !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM") || !qEnvironmentVariableIsEmpty("DISPLAY") ||
           !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY");
#else
    return true;
#endif
}

/// The command line answers in its own sentences. Qt's notes (a runtime folder that is not set, a hint that a picture
/// needs not) stay out of them; what ends the program does not.
void dropNotes(QtMsgType type, const QMessageLogContext &, const QString &text)
{
    if (type == QtCriticalMsg || type == QtFatalMsg)
        app::say(text);
}

/// An exit code, or what needs Qt's window system: the window with a file, or pictures.
using Command = std::variant<int, QString, app::ScreenshotRequest, app::FilmRequest>;

/// Verbs that need no window system start without one.
Command readCommand(int argc, char **argv)
{
    const QCoreApplication plain(argc, argv);
    const QStringList arguments = QCoreApplication::arguments().mid(1);
    if (const auto done = app::runPlainVerb(arguments))
        return *done;
    const auto widen = [](auto &&value) { return Command(value); };
    if (arguments.value(0) == "screenshot")
        return std::visit(widen, app::readScreenshotArguments(arguments.mid(1)));
    if (arguments.value(0) == "film")
        return std::visit(widen, app::readFilmArguments(arguments.mid(1)));
    return std::visit(widen, app::readWindowArguments(arguments));
}

/// Qt reads the factor when an application begins.
constexpr const char *scaleFactor = "QT_SCALE_FACTOR";

void scaleBy(int percent)
{
    if (percent == 100)
        qunsetenv(scaleFactor);
    else
        qputenv(scaleFactor, QByteArray::number(percent / 100.0));
}

int start(int argc, char **argv, const QString &file)
{
    if (!hasDisplay())
        return app::refuseUse(QCoreApplication::translate(
                                  "CommandLine", "there is no display for the window; set DISPLAY, or use a "
                                                 "verb that needs none: %1.")
                                  .arg(app::verbs().join(", ")));
    qInstallMessageHandler(nullptr);
    const bool isScaled = !qEnvironmentVariableIsEmpty(scaleFactor);
    app::Work work;
    app::WindowEnd end = {};
    do {
        if (!isScaled)
            scaleBy(app::keptSize());
        QApplication application(argc, argv);
        end = app::runWindow(application, work, file, end.left);
        if (!end.left)
            work.session.reset(); // while there is an application
    } while (end.left);
    return end.code;
}

/// The same picture everywhere, with a display or without.
void drawOffscreen()
{
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
}

int start(int argc, char **argv, const app::ScreenshotRequest &request)
{
    drawOffscreen();
    QApplication application(argc, argv);
    return app::takeScreenshot(application, request);
}

int start(int argc, char **argv, const app::FilmRequest &request)
{
    drawOffscreen();
    const QApplication application(argc, argv);
    return app::makeFilm(request);
}

int run(int argc, char **argv)
{
    const auto command = readCommand(argc, argv);
    if (const int *done = std::get_if<int>(&command))
        return *done;
    if (const QString *file = std::get_if<QString>(&command))
        return start(argc, argv, *file);
    if (const auto *film = std::get_if<app::FilmRequest>(&command))
        return start(argc, argv, *film);
    return start(argc, argv, std::get<app::ScreenshotRequest>(command));
}

}

int main(int argc, char **argv)
{
    app::endWithASentenceWithoutMemory();
    QCoreApplication::setApplicationName("springstep");
    QCoreApplication::setOrganizationName("springstep");
    QCoreApplication::setApplicationVersion(SPRINGSTEP_VERSION);
    QGuiApplication::setApplicationDisplayName("Springstep");
    qInstallMessageHandler(dropNotes);
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc &) {
        return app::sayNoMemory();
    }
}
