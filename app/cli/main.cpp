#include "app/cli/command_line.h"
#include "app/cli/terminal.h"
#include "app/ui/settings/size_menu.h"
#include "app/ui/window/gui.h"

#include <QApplication>

#include <memory>
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

/// Drops Qt's notes, such as that of a missing runtime folder, so that stderr has only the program's own sentences. Errors
/// that end the program are printed.
void dropNotes(QtMsgType type, const QMessageLogContext &, const QString &text)
{
    if (type == QtCriticalMsg || type == QtFatalMsg)
        app::printMessage(text);
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

int openWindow(int argc, char **argv, const QString &file)
{
    if (!hasDisplay())
        return app::reportUsageError(
            QCoreApplication::translate("CommandLine",
                                        "there is no display for the window; set DISPLAY, or use a "
                                        "verb that needs none: %1.")
                .arg(app::verbNames()));
    qInstallMessageHandler(nullptr);
    const bool isScaled = !qEnvironmentVariableIsEmpty(scaleFactor);
    app::Work work;
    app::WindowEnd end = {};
    do {
        if (!isScaled)
            scaleBy(app::storedSize());
        QApplication application(argc, argv);
        end = app::runWindow(application, work, file, end.handover);
        if (!end.handover)
            work.session.reset(); // while there is an application
    } while (end.handover);
    return end.code;
}

std::unique_ptr<QCoreApplication> applicationWithWidgets(int &argc, char **argv)
{
    // The picture is the same on every machine, with a display or without.
    if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    return std::make_unique<QApplication>(argc, argv);
}

int run(int argc, char **argv)
{
    auto application = std::make_unique<QCoreApplication>(argc, argv);
    const app::CommandLine command = app::readCommandLine(QCoreApplication::arguments().mid(1));
    if (const int *exitCode = std::get_if<int>(&command))
        return *exitCode;
    // Qt allows one application at a time, and its class cannot be known before the arguments are read.
    if (const auto *file = std::get_if<QString>(&command)) {
        application.reset();
        return openWindow(argc, argv, *file);
    }
    const auto &call = std::get<app::VerbCall>(command);
    if (app::applicationFor(call) == app::ApplicationKind::widgets) {
        application.reset();
        application = applicationWithWidgets(argc, argv);
    }
    return app::runVerb(call);
}

}

int main(int argc, char **argv)
{
    app::handleOutOfMemory();
    QCoreApplication::setApplicationName("springstep");
    QCoreApplication::setOrganizationName("springstep");
    QCoreApplication::setApplicationVersion(SPRINGSTEP_VERSION);
    QGuiApplication::setApplicationDisplayName("Springstep");
    qInstallMessageHandler(dropNotes);
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc &) {
        return app::printNoMemory();
    }
}
