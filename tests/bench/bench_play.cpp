// The cost of long playback with all panels open: the longest turn of the window's event loop, and the growth
// of memory besides the keyframes: bench_play [--from N] [--frames N] [--speed F] [--size WxH]...
// [LESSON/STEP[,PARAMETER=VALUE]...]...
//
// It plays at twice the usual speed, 60 frames and 60 pictures a second, so that 36 000 frames are ten
// minutes. Panels that share a tab bar take turns in front. Times are processor time of this thread, which
// does not depend on the load of the machine, with wall-clock time beside it.

#include "app/model/catalog/lesson_library.h"
#include "app/ui/window/main_window.h"
#include "tests/bench/every_panel.h"
#include "tests/bench/slow_events.h"

#include <QCommandLineParser>
#include <QElapsedTimer>
#include <QFile>
#include <QSettings>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTextStream>
#include <QThread>

#include <algorithm>
#include <cmath>
#include <unistd.h>
#include <vector>

using namespace app;

namespace {

constexpr std::int64_t tenMinutes = 10 * 60 * 60; ///< frames at twice the usual speed
constexpr std::int64_t framesOfATab = 300;        ///< until the next tab comes to the front
constexpr int samplesOfMemory = 12;
constexpr double tooLong = 50.0;  ///< ms
constexpr qint64 settling = 2000; ///< ms
constexpr double mebi = 1 << 20;

/// Returns the resident memory of this program, MiB.
double resident()
{
    QFile file("/proc/self/statm");
    if (!file.open(QIODevice::ReadOnly))
        return 0.0;
    return file.readAll().split(' ').at(1).toDouble() * static_cast<double>(sysconf(_SC_PAGESIZE)) / mebi;
}

struct Memory
{
    std::int64_t frame = 0;
    double resident = 0.0; ///< MiB
    double history = 0.0;  ///< MiB, of the keyframes
    std::size_t pictures = 0;
};

struct Play
{
    std::vector<Took> frames; ///< one entry per turn that computes a frame, up to the next such turn
    Took turn;                ///< the longest turn
    Took arranging;           ///< the longest turn that brings other tabs to the front
    std::vector<Memory> memory;
    QSize window;
    QStringList slow; ///< the most expensive events of turns that took too long
};

/// Brings the next tab of each tab bar to the front.
void turnTabs(const MainWindow &window)
{
    for (QTabBar *tabs : window.findChildren<QTabBar *>(QString(), Qt::FindDirectChildrenOnly)) {
        if (tabs->isVisible() && tabs->count() > 1)
            tabs->setCurrentIndex((tabs->currentIndex() + 1) % tabs->count());
    }
}

Memory memoryNow(const Session &session)
{
    return {session.timeline().computed(), resident(),
            static_cast<double>(session.timeline().keyframeBytes()) / mebi};
}

void note(Play &play, Took took, bool arranges, bool computes)
{
    if (arranges) {
        play.arranging = longer(play.arranging, took);
        return;
    }
    play.turn = longer(play.turn, took);
    if (computes || play.frames.empty())
        play.frames.push_back(took);
    else
        play.frames.back() = {play.frames.back().passed + took.passed, play.frames.back().work + took.work};
}

QString said(const QList<WatchedApplication::Delivery> &deliveries)
{
    QStringList parts;
    for (const WatchedApplication::Delivery &one : deliveries)
        parts << QString("%1 %2 ms").arg(one.what).arg(one.took.work, 0, 'f', 1);
    return parts.join(", ");
}

struct Plan
{
    QSize size; ///< of the window
    /// The frame at which playback starts. The run before it is computed first, and read by the panels.
    std::int64_t from = 0;
    std::int64_t frames = 0; ///< the last frame
    double speed = 2.0;      ///< factor on the usual speed
};

/// Goes to a frame, and waits until the panels have read the run up to it.
void goTo(Session &session, std::int64_t frame)
{
    session.playback().goTo({frame, 0});
    QElapsedTimer clock;
    for (clock.start(); session.playback().goal() || clock.elapsed() < settling; QThread::usleep(500)) {
        if (session.playback().goal())
            clock.restart();
        QApplication::processEvents();
    }
}

Play play(Session &session, Theme &theme, WatchedApplication &application, const Plan &plan)
{
    Play play;
    MainWindow window(session, theme);
    window.resize(plan.size);
    window.show();
    openEveryPanel(window);
    play.window = window.size();
    goTo(session, plan.from);
    play.memory.push_back(memoryNow(session));
    session.playback().setSpeed(plan.speed);
    session.playback().play();
    std::int64_t turned = plan.from;
    std::int64_t noted = plan.from;
    while (session.timeline().computed() < plan.frames && session.playback().isPlaying() &&
           !session.playback().isWaiting()) {
        const std::int64_t before = session.timeline().cursor().frame;
        const bool turns = before >= turned + framesOfATab;
        application.slowest();
        const Stopwatch watch;
        if (turns) {
            turned = before;
            turnTabs(window);
        }
        QApplication::processEvents();
        const Took took = watch.took();
        const std::int64_t now = session.timeline().cursor().frame;
        note(play, took, turns, now > before);
        if (took.work > tooLong)
            play.slow << QString("frame %1%2: ").arg(now).arg(turns ? " (tabs)" : "") +
                             said(application.slowest());
        if (now >= noted + (plan.frames - plan.from) / samplesOfMemory) {
            noted = now;
            play.memory.push_back(memoryNow(session));
            play.memory.back().pictures = play.frames.size();
        }
        QThread::usleep(500);
    }
    play.memory.push_back(memoryNow(session));
    session.playback().pause();
    return play;
}

QString percentiles(std::vector<double> ms)
{
    if (ms.empty())
        return "none";
    std::sort(ms.begin(), ms.end());
    const auto at = [&](double share) {
        const auto last = static_cast<double>(ms.size() - 1);
        return QString::number(ms[static_cast<std::size_t>(std::lround(share * last))], 'f', 1);
    };
    return QString("median %1 ms, 90 %: %2, 99 %: %3, 99.9 %: %4, most %5")
        .arg(at(0.5), at(0.9), at(0.99), at(0.999), at(1.0));
}

void print(const Play &play, QTextStream &out)
{
    std::vector<double> work, passed;
    for (const Took &frame : play.frames) {
        work.push_back(frame.work);
        passed.push_back(frame.passed);
    }
    const auto over = [](const std::vector<double> &ms) {
        return std::count_if(ms.begin(), ms.end(), [](double one) { return one > tooLong; });
    };
    const auto text = [](Took took) {
        return QString("%1 ms of work, %2 by the clock")
            .arg(took.work, 0, 'f', 1)
            .arg(took.passed, 0, 'f', 1);
    };
    out << "  window " << play.window.width() << " x " << play.window.height() << ", " << play.frames.size()
        << " pictures\n  work of one:      " << percentiles(work) << "; over 50 ms: " << over(work)
        << "\n  by the clock:     " << percentiles(passed) << "; over 50 ms: " << over(passed)
        << "\n  the longest turn: " << text(play.turn)
        << "\n  the longest that brings other tabs to the front: " << text(play.arranging) << '\n';
    for (const Memory &one : play.memory)
        out << QString("  frame %1: %2 MiB resident, %3 MiB of history, %4 MiB beside it\n")
                   .arg(one.frame, 6)
                   .arg(one.resident, 6, 'f', 1)
                   .arg(one.history, 6, 'f', 1)
                   .arg(one.resident - one.history, 6, 'f', 1);
    out << "  work of a picture, from one of these to the next, in ms (median):";
    for (std::size_t i = 1; i < play.memory.size() && play.memory[i].pictures > 0; ++i) {
        const auto at = [&](std::size_t index) {
            return work.begin() + static_cast<std::ptrdiff_t>(play.memory[index].pictures);
        };
        std::vector<double> part(at(i - 1), at(i));
        std::sort(part.begin(), part.end());
        out << ' ' << (part.empty() ? QString("none") : QString::number(part[part.size() / 2], 'f', 1));
    }
    out << '\n';
    for (const QString &line : play.slow.mid(0, 20))
        out << "  " << line << '\n';
    out << Qt::flush;
}

QSize sizeOf(const QString &text)
{
    return {text.section('x', 0, 0).toInt(), text.section('x', 1).toInt()};
}

}

int main(int count, char **arguments)
{
    WatchedApplication application(count, arguments);
    const QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    QCommandLineParser given;
    const QCommandLineOption frames("frames", "How many frames are played.", "N",
                                    QString::number(tenMinutes));
    const QCommandLineOption size("size", "How large the window is, in px.", "WxH");
    const QCommandLineOption speed("speed", "How many times the usual speed, up to 4.", "F", "2");
    const QCommandLineOption from("from", "The frame at which it begins to play.", "N", "0");
    given.addOptions({frames, size, speed, from});
    given.process(application);
    const QStringList sizes = given.isSet(size) ? given.values(size) : QStringList{"1280x800", "1920x1080"};
    const QStringList steps = given.positionalArguments().isEmpty()
                                  ? QStringList{"walking_gait/company", "accuracy/crowd,creatures=300,damp=1"}
                                  : given.positionalArguments();
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    Theme theme(Scheme::light);
    theme.apply(application);
    Session session(library);
    QTextStream out(stdout);
    for (const QString &step : steps) {
        for (const QString &one : sizes) {
            openStep(session, step);
            out << step << ", " << one << Qt::endl;
            const Plan plan{sizeOf(one), given.value(from).toLongLong(), given.value(frames).toLongLong(),
                            given.value(speed).toDouble()};
            print(play(session, theme, application, plan), out);
        }
    }
    return 0;
}
