#include "app/ui/window/gui.h"

#include "app/model/analysis/settling_monitor.h"
#include "app/model/catalog/lesson_documents.h"
#include "app/model/files/gallery.h"
#include "app/model/lesson_folders/your_lessons.h"
#include "app/model/session/session.h"
#include "app/model/text/language.h"
#include "app/ui/code/code_pages.h"
#include "app/ui/effects/effects_panel.h"
#include "app/ui/help/tour.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/settings/appearance.h"
#include "app/ui/stability/stability_panel.h"
#include "app/ui/window/failure_notice.h"
#include "app/ui/window/introduction.h"
#include "app/ui/window/last_step.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/restart.h"

#include <QAction>
#include <QApplication>
#include <QScreen>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTextStream>
#include <QTimerEvent>

#include <algorithm>

namespace app {

namespace {

/// Introduces a window after its first frame, which would otherwise wait for the pages that introduce it.
class Welcome : public QObject
{
public:
    using Introduce = void (Introduction::*)();

    Welcome(MainWindow &window, Introduce introduce)
        : QObject(&window), m_window(window), m_introduce(introduce)
    {
        window.installEventFilter(this);
    }

    bool eventFilter(QObject *, QEvent *event) override
    {
        if (event->type() == QEvent::Paint) {
            m_window.removeEventFilter(this);
            startTimer(0); // fires after the events that the frame has posted
        }
        return false;
    }

protected:
    void timerEvent(QTimerEvent *event) override
    {
        killTimer(event->timerId());
        (m_window.introduction().*m_introduce)();
    }

private:
    MainWindow &m_window;
    Introduce m_introduce;
};

int reportError(const QString &sentence)
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

/// Handles events until `isDone` returns true.
template <class Condition>
void waitUntil(Condition isDone)
{
    while (!isDone())
        QApplication::processEvents(QEventLoop::WaitForMoreEvents);
}

/// Opens the panels of a picture, goes to its frame, and waits until everything is measured and drawn.
void arrange(MainWindow &window, Session &session, const ScreenshotRequest &request)
{
    if (request.measuring)
        window.setMode(MainWindow::Mode::measure);
    if (request.energy)
        window.docks().show(Panel::energy, true);
    if (request.effects)
        window.docks().show(Panel::effects, true);
    if (request.plots)
        window.docks().show(Panel::plots, true);
    waitUntil([&] { return window.study().stage() != AccuracyStudy::Stage::measuring; });
    session.playback().goTo({request.frame, request.phase});
    waitUntil([&] { return !session.playback().goal(); });
    if (request.reasons || request.settling)
        window.docks().show(Panel::stability, true);
    if (request.effects)
        window.effects().measureAgain()->trigger();
    waitUntil([&] { return window.effects().isSettled(); });
    if (request.map)
        window.stabilityPanel().showMap(*request.map);
    if (request.settling)
        window.stabilityPanel().showSettling(true);
    waitUntil([&] {
        return window.stability().isCurrent() && !window.stability().isMapping() &&
               !window.settling().isMapping() && !window.stopNotice().search().isSearching();
    });
    QApplication::processEvents();
    waitUntil([&] { return window.plots().isSettled(); });
}

}

void retranslate(LessonLibrary &library, LessonLibrary other)
{
    const auto replace = [](std::vector<LessonEntry> &all, std::vector<LessonEntry> &by) {
        for (LessonEntry &one : all) {
            const auto same = std::find_if(by.begin(), by.end(), [&](const LessonEntry &entry) {
                return entry.id == one.id &&
                       std::equal(entry.steps.begin(), entry.steps.end(), one.steps.begin(), one.steps.end(),
                                  [](const auto &a, const auto &b) { return a.id == b.id; });
            });
            if (same == by.end())
                continue;
            one.title = same->title;
            one.summary = same->summary;
            one.recall = std::move(same->recall);
            one.project = std::move(same->project);
            // Each step keeps its address, because the session refers to it.
            std::move(same->steps.begin(), same->steps.end(), one.steps.begin());
        }
    };
    replace(library.lessons, other.lessons);
    replace(library.sandboxes, other.sandboxes);
}

WindowEnd runWindow(QApplication &application, Work &work, const QString &file,
                    const std::optional<Handover> &from)
{
    Language language(Language::chosen(QSettings().value("window/language").toString()));
    if (!work.session) {
        work.library = LessonLibrary::load(LessonLibrary::folders(), &language);
        if (work.library.lessons.empty())
            return {reportError(noLessons()), {}};
        work.session = std::make_unique<Session>(work.library);
    } else if (work.language != language.code()) {
        retranslate(work.library, LessonLibrary::load(LessonLibrary::folders(), &language));
    }
    work.language = language.code();
    YourLessons yours(work.library);
    Theme theme(storedScheme());
    theme.apply(application);
    LessonDocuments documents(work.library, LessonDocuments::folder());
    const LastStep last = LastStep::load();
    if (!from)
        last.openIn(*work.session); // before the window, which would show another step first
    MainWindow window(*work.session, theme);
    QObject::connect(&documents, &LessonDocuments::changed, work.session.get(), &Session::announceTexts);
    QObject::connect(&documents, &LessonDocuments::mistakeChanged, &window, &MainWindow::showDocumentMistake);
    if (!documents.mistake().isEmpty())
        window.showDocumentMistake(documents.mistake());
    window.offerYourLessons(yours);
    window.fitInto(window.screen()->availableSize());
    window.show();
    if (from)
        window.restart().continueFrom(*from);
    else if (!file.isEmpty())
        window.openFile(file);
    else if (Tour::isWanted())
        new Welcome(window, &Introduction::welcome);
    else if (last.lesson.isEmpty())
        new Welcome(window, &Introduction::showMap); // no lesson was opened yet
    window.keepGalleryIn(galleryFolder());
    window.autosaveIn(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + "/scenes");
    const int code = QApplication::exec();
    QApplication::processEvents(); // what the session has postponed needs this application
    return {code, window.restart().handover()};
}

int takeScreenshot(QApplication &application, const ScreenshotRequest &request)
{
    // The learner's own settings and progress neither show in the picture nor change.
    const QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());

    Language language(Language::chosen({}));
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders(), &language);
    if (library.lessons.empty())
        return reportError(noLessons());
    try {
        const Experiment experiment = newExperiment(request.lesson, request.step, library);
        Theme theme(request.scheme);
        theme.apply(application);
        Session session(library);
        session.open(experiment);
        if (request.phase > 0) // the listing has lines and no phases
            QSettings().setValue(CodePages::pageKey, QStringLiteral("engine"));
        MainWindow window(session, theme);
        window.setAttribute(Qt::WA_DontShowOnScreen);
        window.resize(request.size);
        window.show();
        QApplication::processEvents();
        arrange(window, session, request);
        if (!window.grab().save(request.out))
            return reportError(
                QApplication::translate("Gui", "%1 could not be written: give a folder that you may write "
                                               "to, and a name that ends in .png or .jpg.")
                    .arg(request.out));
    } catch (const UserError &error) {
        return reportError(error.sentence());
    }
    return 0;
}
}
