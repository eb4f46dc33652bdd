// How long the window's event loop is ever held up while it measures accuracy on the thread beside it, which event
// held it up, and when the first points are there: bench_window [LESSON/STEP]...

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
#include <utility>

using namespace app;

namespace {

constexpr qint64 givenUp = 60'000; ///< ms

/// What something takes, in ms.
struct Took
{
    double passed = 0.0; ///< by the clock
    double work = 0.0;   ///< of processor time of this thread: what a busy machine does not add to
};

struct Stall
{
    Took opening;             ///< arranging the window, before there is anything to measure
    Took turn;                ///< the longest turn of the event loop, by each of the two
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

class Stopwatch
{
public:
    Stopwatch() { m_clock.start(); }
    Took took() const { return {static_cast<double>(m_clock.nsecsElapsed()) / 1e6, threadTime() - m_before}; }

private:
    QElapsedTimer m_clock;
    double m_before = threadTime();
};

Took longer(Took a, Took b)
{
    return {std::max(a.passed, b.passed), std::max(a.work, b.work)};
}

/// Keeps in mind which events took the most work. An event that another one sends is part of that.
class Application : public QApplication
{
public:
    using QApplication::QApplication;

    struct Delivery
    {
        Took took;
        QString what;
    };

    bool notify(QObject *receiver, QEvent *event) override
    {
        if (m_isWithin)
            return QApplication::notify(receiver, event);
        m_isWithin = true;
        // Both may be gone afterwards.
        const char *const name = receiver->metaObject()->className();
        const QEvent::Type type = event->type();
        const Stopwatch watch;
        const bool answer = QApplication::notify(receiver, event);
        const Took took = watch.took();
        m_isWithin = false;
        if (took.work > leastWork)
            m_slow.push_back({took, QString("%1 for %2").arg(QVariant::fromValue(type).toString(), name)});
        return answer;
    }

    /// The three with the most work since the last call, the most first.
    QList<Delivery> slowest()
    {
        std::sort(m_slow.begin(), m_slow.end(),
                  [](const Delivery &a, const Delivery &b) { return a.took.work > b.took.work; });
        return std::exchange(m_slow, {}).mid(0, 3);
    }

private:
    static constexpr double leastWork = 1.0; ///< ms
    bool m_isWithin = false;
    QList<Delivery> m_slow;
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
    session.play(); // as a learner has it: the scene moves while it is measured
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
    session.pause();
    return stall;
}

}

int main(int count, char **arguments)
{
    Application application(count, arguments);
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
        for (const Application::Delivery &one : application.slowest())
            out << "  " << one.what << ": " << text(one.took) << Qt::endl;
    }
    return 0;
}
