// How long the window's event loop is blocked while a thread measures accuracy, which event blocks it, and
// when the first points appear: bench_window [LESSON/STEP]...

#include "app/model/catalog/lesson_library.h"
#include "app/ui/window/main_window.h"
#include "tests/bench/slow_events.h"

#include <QElapsedTimer>
#include <QSettings>
#include <QTemporaryDir>
#include <QTextStream>
#include <QThread>

#include <algorithm>

using namespace app;

namespace {

constexpr qint64 givenUp = 60'000; ///< ms

struct Stall
{
    Took opening;             ///< opening the window, before any measurement
    Took turn;                ///< the longest turn of the event loop, by both times
    double firstPoints = 0.0; ///< ms
    double done = 0.0;        ///< ms
    std::size_t rows = 0;
};

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
    session.playback().play(); // as for a learner: the scene moves while it is measured
    QElapsedTimer clock;
    clock.start();
    const auto ms = [&] { return static_cast<double>(clock.nsecsElapsed()) / 1e6; };
    const Stopwatch opening;
    window.setMode(MainWindow::Mode::measure);
    QApplication::processEvents();
    stall.opening = opening.took();
    while (window.study().stage() == AccuracyStudy::Stage::measuring && clock.elapsed() < givenUp) {
        const Stopwatch turn;
        QApplication::processEvents();
        stall.turn = longer(stall.turn, turn.took());
        if (stall.firstPoints == 0.0 && hasPoints(window.study().accuracy()))
            stall.firstPoints = ms();
        QThread::usleep(500);
    }
    stall.done = ms();
    stall.rows = window.study().accuracy() ? window.study().accuracy()->rows.size() : 0;
    session.playback().pause();
    return stall;
}

}

int main(int count, char **arguments)
{
    WatchedApplication application(count, arguments);
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
        application.slowest();
        const Stall stall = measure(session, theme);
        const auto text = [](Took took) {
            return QString("%1 ms (%2 of work)").arg(qRound(took.passed)).arg(qRound(took.work));
        };
        out << step << ": first points after " << qRound(stall.firstPoints) << " ms, " << stall.rows
            << " rows after " << qRound(stall.done) << " ms; opening " << text(stall.opening)
            << ", longest turn " << text(stall.turn) << Qt::endl;
        for (const WatchedApplication::Delivery &one : application.slowest())
            out << "  " << one.what << ": " << text(one.took) << Qt::endl;
    }
    return 0;
}
