// How long the window's event loop is ever held up while it measures accuracy on the thread beside it, and when the
// first points are there: bench_window [LESSON/STEP]...

#include "app/model/lesson_library.h"
#include "app/ui/window/main_window.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>
#include <QTextStream>
#include <QThread>

#include <algorithm>
#include <ctime>

using namespace app;

namespace {

constexpr qint64 givenUp = 60'000; ///< ms

struct Stall
{
    double opening = 0.0; ///< ms that arranging the window takes, before there is anything to measure
    double longest = 0.0; ///< ms between two turns of the event loop
    double work = 0.0;    ///< ms of processor time in the longest turn: what a busy machine does not add to
    double firstPoints = 0.0; ///< ms
    double done = 0.0;        ///< ms
    std::size_t rows = 0;
};

/// Processor time of this thread in ms.
double threadTime()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

bool hasPoints(const sim::Accuracy *accuracy)
{
    return accuracy &&
           std::any_of(accuracy->rows.begin(), accuracy->rows.end(),
                       [](const sim::AccuracyRow &row) { return row.outcome == sim::Outcome::measured; });
}

Stall measure(Session &session, Theme &theme)
{
    Stall stall;
    MainWindow window(session, theme);
    window.resize(1920, 1080);
    window.show();
    QApplication::processEvents();
    session.play(); // as a learner has it: the scene moves while it is measured
    QElapsedTimer clock;
    clock.start();
    const auto ms = [&] { return static_cast<double>(clock.nsecsElapsed()) / 1e6; };
    window.setMode(MainWindow::Mode::measure);
    QApplication::processEvents();
    stall.opening = ms();
    double last = ms();
    while (window.study().stage() == AccuracyStudy::Stage::measuring && clock.elapsed() < givenUp) {
        const double before = threadTime();
        QApplication::processEvents();
        stall.work = std::max(stall.work, threadTime() - before);
        stall.longest = std::max(stall.longest, ms() - last);
        last = ms();
        if (stall.firstPoints == 0.0 && hasPoints(window.study().accuracy()))
            stall.firstPoints = ms();
        QThread::usleep(500);
    }
    stall.done = ms();
    stall.rows = window.study().accuracy() ? window.study().accuracy()->rows.size() : 0;
    session.pause();
    return stall;
}

}

int main(int count, char **arguments)
{
    QApplication application(count, arguments);
    const QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    QStringList steps = QApplication::arguments().mid(1);
    if (steps.isEmpty())
        steps = {"single_spring/radial", "multi_foot/any_number", "gravity_walls/gravity",
                 "walking_gait/company"};
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    Theme theme(Scheme::light);
    theme.apply(application);
    Session session(library);
    QTextStream out(stdout);
    for (const QString &step : steps) {
        session.openStep(step.section('/', 0, 0), step.section('/', 1));
        const Stall stall = measure(session, theme);
        out << step << ": first points after " << qRound(stall.firstPoints) << " ms, " << stall.rows
            << " rows after " << qRound(stall.done) << " ms; opening " << qRound(stall.opening)
            << " ms, longest gap " << qRound(stall.longest) << " ms, longest work " << qRound(stall.work)
            << " ms" << Qt::endl;
    }
    return 0;
}
