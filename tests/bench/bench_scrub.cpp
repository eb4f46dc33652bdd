// How long the window takes to show another moment of a long run: bench_scrub [--frames N] [--moves N]
// [LESSON/STEP[,PARAMETER=VALUE]...]...
//
// Measures each step twice. First, random moments with the window as it opens, 1280 x 800 px, painted as a
// whole. Second, the playhead dragged to and fro with the mouse, 1920 x 1080 px, with every panel visible,
// where each panel repaints only its changes. Times are processor time of this thread, which does not depend
// on the load of the machine.

#include "app/model/catalog/lesson_library.h"
#include "app/ui/energy/energy_panel.h"
#include "app/ui/energy/energy_plot.h"
#include "app/ui/plots/plot_card.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/window/main_window.h"
#include "sim/base/cpu_clock.h"
#include "tests/bench/every_panel.h"
#include "tests/bench/slow_events.h"

#include <QCommandLineParser>
#include <QMouseEvent>
#include <QSettings>
#include <QTemporaryDir>
#include <QTextStream>
#include <QThread>

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <set>

using namespace app;

namespace {

constexpr std::int64_t tenMinutes = 10 * 60 * 30; ///< frames
constexpr double aPicture = 1.0 / 60.0;           ///< s
constexpr int turnsAfterwards = 6; ///< turns of the event loop in which panels finish reading the run
constexpr int settlingTurns = 500;
constexpr int stride = 3; ///< px between two moves of the mouse

void turn(int times)
{
    for (int i = 0; i < times; ++i)
        QApplication::processEvents();
}

void waitThere(const Session &session)
{
    while (session.playback().goal())
        QApplication::processEvents();
}

QString percentiles(std::vector<double> seconds)
{
    const auto slowest = std::max_element(seconds.begin(), seconds.end()) - seconds.begin() + 1;
    const auto late = std::count_if(seconds.begin(), seconds.end(), [](double s) { return s > aPicture; });
    std::sort(seconds.begin(), seconds.end());
    const auto at = [&](double share) {
        const auto last = static_cast<double>(seconds.size() - 1);
        return QString::number(1e3 * seconds[static_cast<std::size_t>(std::lround(share * last))], 'f', 2);
    };
    return QString("median %1 ms, 90 %: %2, 99 %: %3, most %4 (number %5); over 1/60 s: %6 of %7")
        .arg(at(0.5), at(0.9), at(0.99), at(1.0))
        .arg(slowest)
        .arg(late)
        .arg(seconds.size());
}

/// Computes a run, and waits until the panels have read it.
void compute(Session &session, MainWindow &window, std::int64_t frames)
{
    session.playback().goTo({frames, 0});
    waitThere(session);
    const auto *energy = window.findChild<EnergyPanel *>();
    const auto isReading = [&] {
        const bool counts = energy->isVisible() && !energy->series().whyNot();
        return (counts && energy->series().last() < session.timeline().computed()) ||
               !window.plots().isSettled();
    };
    for (int i = 0; i < settlingTurns || isReading(); ++i) {
        turn(1);
        QThread::usleep(500);
    }
}

struct Plan
{
    std::int64_t frames = tenMinutes;
    int moves = 300;
};

void jump(Session &session, Theme &theme, const Plan &plan, QTextStream &out)
{
    MainWindow window(session, theme);
    window.resize(1280, 800);
    window.show();
    QApplication::processEvents();
    compute(session, window, plan.frames);
    std::mt19937 random(1);
    std::uniform_int_distribution<std::int64_t> anywhere(0, session.timeline().computed());
    std::vector<double> seeking, all;
    QImage image(window.size(), QImage::Format_RGB32);
    for (int i = 0; i < plan.moves; ++i) {
        const double start = sim::threadCpuSeconds();
        session.playback().goTo({anywhere(random), 0});
        waitThere(session);
        seeking.push_back(sim::threadCpuSeconds() - start);
        window.render(&image);
        all.push_back(sim::threadCpuSeconds() - start);
        QApplication::processEvents(); // delayed work: readings, time series
    }
    out << "  jumping, 1280 x 800 px, seeking:       " << percentiles(seeking)
        << "\n  jumping, seeking and painting it all:  " << percentiles(all) << Qt::endl;
}

/// An application that records when widgets have been painted.
class Eyes : public WatchedApplication
{
public:
    using WatchedApplication::WatchedApplication;

    void lookFor(const std::set<QObject *> &widgets)
    {
        m_unseen = widgets;
        m_seen.reset();
    }
    /// Returns when the window's painting ended in which the last of these widgets was painted. Empty until
    /// then.
    std::optional<double> seen() const { return m_seen; }

    bool notify(QObject *receiver, QEvent *event) override
    {
        const QEvent::Type type = event->type(); // the event may be deleted afterwards
        if (type == QEvent::Paint)
            m_unseen.erase(receiver);
        const bool answer = WatchedApplication::notify(receiver, event);
        if (type == QEvent::UpdateRequest && m_unseen.empty() && !m_seen)
            m_seen = sim::threadCpuSeconds();
        return answer;
    }

private:
    std::set<QObject *> m_unseen;
    std::optional<double> m_seen;
};

/// Returns the widgets that show the moment.
std::set<QObject *> viewsOf(MainWindow &window)
{
    std::set<QObject *> views{window.findChild<TimelineStrip *>(),
                              window.findChild<SceneView *>()->viewport(),
                              &window.findChild<EnergyPanel *>()->plot()};
    for (const PlotCard *card : window.plots().cards()) {
        if (!card->plot().visibleRegion().isEmpty())
            views.insert(&card->plot());
    }
    return views;
}

void send(QWidget &to, QEvent::Type type, QPointF place)
{
    const bool isMove = type == QEvent::MouseMove;
    const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton;
    QMouseEvent event(type, place, to.mapToGlobal(place), isMove ? Qt::NoButton : Qt::LeftButton, held, {});
    QApplication::sendEvent(&to, &event);
}

void drag(Session &session, Theme &theme, Eyes &application, const Plan &plan, QTextStream &out)
{
    MainWindow window(session, theme);
    window.resize(1920, 1080);
    window.show();
    showEveryPanel(window);
    compute(session, window, plan.frames);
    auto &timeline = *window.findChild<TimelineStrip *>();
    const double left = timeline.axis().xOf(0), right = timeline.axis().xOf(session.timeline().computed());
    constexpr double onTrack = 25.0; // px from the top
    const std::set<QObject *> views = viewsOf(window);
    std::vector<double> seen, read;
    QStringList slow;
    double x = right, step = -stride;
    send(timeline, QEvent::MouseButtonPress, {x, onTrack});
    for (int i = 0; i < plan.moves; ++i) {
        if (x + step < left || x + step > right)
            step = -step;
        x += step;
        application.slowest();
        application.lookFor(views);
        const double start = sim::threadCpuSeconds();
        send(timeline, QEvent::MouseMove, {x, onTrack});
        waitThere(session);
        for (int one = 0; !application.seen() && one < turnsAfterwards; ++one)
            turn(1);
        seen.push_back(application.seen().value_or(sim::threadCpuSeconds()) - start);
        if (seen.back() > aPicture)
            for (const WatchedApplication::Delivery &one : application.slowest())
                slow << QString("%1 %2 ms").arg(one.what).arg(one.took.work, 0, 'f', 1);
        turn(turnsAfterwards);
        read.push_back(sim::threadCpuSeconds() - start);
    }
    send(timeline, QEvent::MouseButtonRelease, {x, onTrack});
    out << "  dragging, " << window.width() << " x " << window.height()
        << " px, every panel open: " << percentiles(seen)
        << "\n  dragging, and reading on afterwards:   " << percentiles(read) << Qt::endl;
    for (const QString &line : slow.mid(0, 6))
        out << "    " << line << Qt::endl;
}

}

int main(int count, char **arguments)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    Eyes application(count, arguments);
    const QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    QCommandLineParser given;
    const QCommandLineOption frames("frames", "How long the run is.", "N", QString::number(tenMinutes));
    const QCommandLineOption moves("moves", "How many moments are gone to.", "N", "300");
    given.addOptions({frames, moves});
    given.process(application);
    QStringList steps = given.positionalArguments();
    if (steps.isEmpty())
        steps = QStringList{"gravity_walls/gravity", "accuracy/crowd,creatures=800"};
    const Plan plan{given.value(frames).toLongLong(), given.value(moves).toInt()};
    const LessonLibrary library = LessonLibrary::load(LessonLibrary::folders());
    Theme theme(Scheme::light);
    theme.apply(application);
    Session session(library);
    QTextStream out(stdout);
    for (const QString &one : steps) {
        openStep(session, one);
        session.playback().goTo({plan.frames, 0});
        waitThere(session);
        out << one << ": " << session.timeline().state().pointCount() << " points, "
            << session.timeline().track().keyframeCount() << " moments kept of "
            << session.timeline().computed() << Qt::endl;
        jump(session, theme, plan, out);
        drag(session, theme, application, plan, out);
    }
    return 0;
}
