#include "app/ui/window/gui.h"

#include "app/model/language.h"
#include "app/model/session.h"
#include "app/ui/effects/effects_panel.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/window/appearance.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/stop_notice.h"

#include <QAction>
#include <QApplication>
#include <QScreen>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTextStream>
#include <QTimer>

namespace app {

namespace {

int refuse(const QString &sentence)
{
    QTextStream(stderr) << "springstep: " << sentence << '\n';
    return 2;
}

QString noLessons()
{
    return QApplication::translate("Gui",
                                   "No lesson was found in %1. Build the lessons, or name their folder in "
                                   "SPRINGSTEP_LESSONS.")
        .arg(LessonLibrary::folders().join(", "));
}

}

WindowEnd runWindow(QApplication &application, const QString &file, const std::optional<Left> &from)
{
    Language language(Language::chosen(QSettings().value("window/language").toString()));
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders(), &language);
    if (library.lessons.empty())
        return {refuse(noLessons()), {}};
    Theme theme(keptScheme());
    theme.apply(application);
    Session session(library);
    MainWindow window(session, theme);
    window.fitInto(window.screen()->availableSize());
    window.openLast();
    window.show();
    if (from)
        window.goOn(*from);
    else if (!file.isEmpty())
        window.openFile(file);
    else if (MainWindow::wantsTour())
        QTimer::singleShot(0, &window, &MainWindow::startTour);
    window.keepScenesIn(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/scenes");
    const int code = QApplication::exec();
    return {code, window.left()};
}

int takeScreenshot(QApplication &application, const ScreenshotRequest &request)
{
    // A learner's own settings and progress stay out of the picture, and untouched.
    const QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());

    Language language(Language::chosen({}));
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders(), &language);
    if (library.lessons.empty())
        return refuse(noLessons());
    try {
        const Experiment experiment = newExperiment(request.lesson, request.step, library);
        Theme theme(request.scheme);
        theme.apply(application);
        Session session(library);
        session.open(experiment);
        MainWindow window(session, theme);
        window.setAttribute(Qt::WA_DontShowOnScreen);
        window.resize(request.size);
        window.show();
        QApplication::processEvents();
        if (request.measuring)
            window.setMode(MainWindow::Mode::measure);
        if (request.energy)
            window.showEnergy(true);
        if (request.effects)
            window.showEffects(true);
        if (request.plots)
            window.showPlots(true);
        while (window.study().stage() == AccuracyStudy::Stage::measuring)
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        session.goTo({request.frame, request.phase});
        while (session.goingTo())
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        if (request.reasons)
            window.showStability(true);
        if (request.effects)
            window.effects().measureAgain()->trigger();
        while (!window.effects().isSettled())
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        if (request.map)
            window.showGrowthMap(*request.map);
        while (!window.stability().isCurrent() || window.stability().isMapping() ||
               window.stopNotice().search().isSearching())
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        QApplication::processEvents();
        while (!window.plots().isSettled())
            QApplication::processEvents(QEventLoop::WaitForMoreEvents);
        if (!window.grab().save(request.out))
            return refuse(QApplication::translate("Gui",
                                                  "%1 cannot be written: name a folder that you may write "
                                                  "to, and a file that ends in .png or .jpg.")
                              .arg(request.out));
    } catch (const Refusal &refusal) {
        return refuse(refusal.sentence());
    }
    return 0;
}
}
